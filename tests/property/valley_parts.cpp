#include "tests/property/valley_parts.h"

#include "core/base/tolerances.h"
#include "core/gouge/axial_lift.h"
#include "core/mesh/sample.h"
#include "core/mesh/sample_mould.h"
#include "core/mesh/sample_standins.h"
#include "tests/property/shapes.h"
#include "tests/support/random_meshes.h"

#include <map>

namespace facetmill::test {

ValleyPart mould_part() {
    return {"mould", *make_sample("mould", default_sample_tolerance, Progress()), sample::mould_valleys()};
}

ValleyPart pillar_part() {
    ValleyPart part{"pillar", *make_sample("pillar", default_sample_tolerance, Progress()),
                    sample::pillar_valleys(), 25.4, 8};
    part.beside_noisy = 0.5;
    return part;
}

ValleyPart gap_part() {
    ValleyPart part{"gap", *make_sample("gap", default_sample_tolerance, Progress()), {}, 25.4, 6};
    // A tenth of the width of the gap's floor: the ball touches the walls high above it.
    part.beside = part.beside_noisy = 1.5;
    // The place that the ball can take nearest to a place of the part, by search. Across the gap is not
    // across x: it winds, so its walls are not met at the same x.
    const Tool ball = ball_tool(part.previous);
    const double r = 0.5 * part.previous;
    const auto index = std::make_shared<ContactIndex>(
        make_sample("gap", 0.1 * default_sample_tolerance, Progress()), Progress());
    const AxialLift lift(index, CutterProfile(ball.cutter()));
    const AxialLift needle(index,
                           CutterProfile(AptCutter::flat(tolerance::needle_diameter, unlimited_height)));
    struct Nearest {
        Vec3 tip = Vec3::Zero();
        double distance = infinity;
    };
    const auto nearest = [&](const Vec3& p) {
        Nearest best;
        Vec2 middle = p.head<2>();
        double half = r;
        for (int level = 0; level < 8; ++level, half *= 0.25) {
            const int cells = level == 0 ? 12 : 4;
            const Vec2 from = middle;
            for (int i = -cells; i <= cells; ++i)
                for (int k = -cells; k <= cells; ++k) {
                    const Vec2 at = from + (half / cells) * Vec2(i, k);
                    const Vec3 tip(at.x(), at.y(), lift.tip_z(at.x(), at.y()));
                    const double d = (p - tip - Vec3(0, 0, r)).norm() - r;
                    if (!(d < best.distance)) continue;
                    best = {tip, d};
                    middle = at;
                }
        }
        return best;
    };
    // Known as far as it stands on the floor then; the gap from where it leaves more than the tolerance.
    const auto on_floor = [&](const Vec3& p) {
        const Vec3 tip = nearest(p).tip;
        return tip.z() - needle.tip_z(tip.x(), tip.y()) < 0.05;
    };
    const auto floor = sample::gap_floor();
    const auto blends = sample::gap_valleys();
    const auto halved = [&](const std::vector<Vec3>& line, auto&& is_before) {
        // Beyond the borders the ball comes down beside the part.
        std::size_t lo = line.size() / 4, hi = 3 * line.size() / 4;
        while (hi - lo > 1) {
            const std::size_t mid = (lo + hi) / 2;
            (is_before(line[mid]) ? lo : hi) = mid;
        }
        return hi;
    };
    const auto cut = [&](const std::vector<Vec3>& line, std::size_t from, std::size_t to) {
        return std::vector<Vec3>(line.begin() + std::ptrdiff_t(from), line.begin() + std::ptrdiff_t(to));
    };
    for (const auto& line : blends)
        part.valleys.push_back(cut(line, 0, halved(line, on_floor)));
    const auto enters = [&](const Vec3& p) { return nearest(p).distance < 0.05; };
    part.valleys.push_back(cut(floor, halved(floor, enters), floor.size()));
    return part;
}

ValleyPart corner_part() {
    // Flanks rise away from three valleys that fall towards the middle.
    const double slope = 1.2;
    std::vector<Vec2> rise;
    for (int k = 0; k < 3; ++k)
        rise.emplace_back(std::cos(0.3 + 2 * pi * k / 3), std::sin(0.3 + 2 * pi * k / 3));
    const auto z = [&](const Vec2& p) {
        double highest = -infinity;
        for (const Vec2& r : rise)
            highest = std::max(highest, slope * r.dot(p));
        return highest;
    };
    // Sectors between the valleys, each of one plane; valleys run opposite to the rise of the third.
    Mesh m;
    const int rings = 16, around = 60;
    const double radius = 22;
    m.vertices.push_back(Vec3::Zero());
    for (int i = 1; i <= rings; ++i)
        for (int k = 0; k < around; ++k) {
            const double a = 0.3 + pi / 3 + 2 * pi * k / around, d = radius * i / rings;
            const Vec2 p(d * std::cos(a), d * std::sin(a));
            m.vertices.emplace_back(p.x(), p.y(), z(p));
        }
    const auto at = [&](int i, int k) { return Index(1 + (i - 1) * around + k % around); };
    for (int k = 0; k < around; ++k) {
        m.facets.push_back({0, at(1, k), at(1, k + 1)});
        for (int i = 1; i < rings; ++i) {
            m.facets.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            m.facets.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    }
    ValleyPart part{"corner", m, {}};
    for (int k = 0; k < 3; ++k)
        part.valleys.push_back({Vec3::Zero(), m.vertices[at(rings, k * around / 3)]});
    return part;
}

ValleyPart ring_part() {
    const double middle = 18, slope = std::tan(radians(50));
    Mesh m;
    const int around = 240, across = 28;
    const double width = 10;
    for (int j = 0; j <= across; ++j)
        for (int k = 0; k < around; ++k) {
            const double d = middle - width + 2 * width * j / across, a = 2 * pi * k / around;
            m.vertices.emplace_back(d * std::cos(a), d * std::sin(a), slope * std::abs(d - middle));
        }
    const auto at = [&](int j, int k) { return Index(j * around + k % around); };
    for (int j = 0; j < across; ++j)
        for (int k = 0; k < around; ++k) {
            m.facets.push_back({at(j, k), at(j + 1, k), at(j + 1, k + 1)});
            m.facets.push_back({at(j, k), at(j + 1, k + 1), at(j, k + 1)});
        }
    ValleyPart part{"ring", m, {{}}};
    for (int k = 0; k <= around; ++k)
        part.valleys[0].push_back(m.vertices[at(across / 2, k)]);
    return part;
}

namespace {

/// Turns diagonals of about half of all pairs of facets that are level with each other.
void turn_diagonals(Mesh& m, Random& rng) {
    std::map<std::array<Index, 2>, std::vector<std::array<std::size_t, 2>>> at; // facets, and which edge
    for (std::size_t f = 0; f < m.facets.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = m.facets[f][k], b = m.facets[f][(k + 1) % 3];
            at[{std::min(a, b), std::max(a, b)}].push_back({f, k});
        }
    std::vector<char> done(m.facets.size(), 0);
    for (const auto& [edge, sides] : at) {
        if (sides.size() != 2 || uniform(rng, 0, 1) < 0.3) continue;
        const auto [f, i] = sides[0];
        const auto [g, j] = sides[1];
        if (done[f] || done[g]) continue;
        const Index a = m.facets[f][i], b = m.facets[f][(i + 1) % 3], c = m.facets[f][(i + 2) % 3],
                    d = m.facets[g][(j + 2) % 3];
        if (m.facets[g][j] != b) continue;
        const auto normal = [&](Index x, Index y, Index z) -> Vec3 {
            return (m.vertices[y] - m.vertices[x]).cross(m.vertices[z] - m.vertices[x]);
        };
        const Vec3 n = normal(a, b, c), o = normal(b, a, d), p = normal(a, d, c), q = normal(d, b, c);
        const double least = 0.2 * std::min(n.norm(), o.norm());
        if (n.cross(o).norm() > 0.01 * n.norm() * o.norm() || n.dot(o) <= 0) continue;
        if (n.dot(p) <= least * n.norm() || n.dot(q) <= least * n.norm()) continue;
        m.facets[f] = {a, d, c};
        m.facets[g] = {d, b, c};
        done[f] = done[g] = 1;
    }
}

} // namespace

Mesh scanned(const Mesh& mesh, double longest, double noise, std::uint64_t seed) {
    Random rng(seed);
    Mesh m = mesh;
    // Halving at random places whatever is too long, until nothing is.
    for (bool again = true; again;) {
        again = false;
        std::map<std::array<Index, 2>, Index> middle;
        const auto divided = [&](Index a, Index b) -> Index {
            const std::array<Index, 2> key{std::min(a, b), std::max(a, b)};
            if (const auto found = middle.find(key); found != middle.end()) return found->second;
            const Vec3 p = m.vertices[key[0]], q = m.vertices[key[1]];
            Index at = no_index;
            if ((p - q).norm() > longest) {
                at = Index(m.vertices.size());
                m.vertices.push_back(p + uniform(rng, 0.35, 0.65) * (q - p));
            }
            middle[key] = at;
            return at;
        };
        std::vector<Facet> facets;
        for (const Facet& f : m.facets) {
            std::array<Index, 3> mid{};
            int count = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                mid[k] = divided(f[k], f[(k + 1) % 3]);
                count += mid[k] != no_index;
            }
            if (count == 0) {
                facets.push_back(f);
                continue;
            }
            again = true;
            if (count == 3) {
                facets.push_back({f[0], mid[0], mid[2]});
                facets.push_back({mid[0], f[1], mid[1]});
                facets.push_back({mid[2], mid[1], f[2]});
                facets.push_back({mid[0], mid[1], mid[2]});
                continue;
            }
            // The outline with its new corners, from one of them.
            std::vector<Index> outline;
            std::size_t first = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                outline.push_back(f[k]);
                if (mid[k] == no_index) continue;
                first = outline.size();
                outline.push_back(mid[k]);
            }
            for (std::size_t k = 1; k + 1 < outline.size(); ++k)
                facets.push_back({outline[first], outline[(first + k) % outline.size()],
                                  outline[(first + k + 1) % outline.size()]});
        }
        m.facets = std::move(facets);
    }
    turn_diagonals(m, rng);
    for (Vec3& v : m.vertices)
        v += noise * Vec3(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1));
    return m;
}

double distance_to(const std::vector<std::vector<Vec3>>& lines, const Vec3& p) {
    double least = infinity;
    for (const auto& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Vec3 d = line[i] - line[i - 1];
            const double t =
                d.squaredNorm() > 0 ? std::clamp((p - line[i - 1]).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
            least = std::min(least, (p - line[i - 1] - t * d).norm());
        }
    return least;
}

std::vector<Vec3> places_along(const std::vector<std::vector<Vec3>>& lines, double spacing) {
    std::vector<Vec3> places;
    for (const auto& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Vec3 d = line[i] - line[i - 1];
            const int n = std::max(1, int(d.norm() / spacing));
            for (int k = 0; k < n; ++k)
                places.push_back(line[i - 1] + ((k + 0.5) / n) * d);
        }
    return places;
}

} // namespace facetmill::test
