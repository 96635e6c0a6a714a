#include "core/strategy/rough/rough_layers.h"

#include "core/base/error.h"
#include "core/base/tolerances.h"
#include "core/gouge/tool_lift.h"
#include "core/strategy/surface/up_side.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace facetmill {

namespace {

/// Share of the cutter's radius to which the place is known where two cutters meet: the last bits.
constexpr double last_halving = 1e-14;
/// Stock lower than this, mm, is one bin of heights.
constexpr double min_span = 1e-12;
/// Layers less deep than this share of the cutter's radius would never end; a last layer thinner than this
/// share of the one above is cut with it.
constexpr double min_depth_share = 1e-6, last_layer_share = 1e-3;

/// Facets between two looks at the cancel flag.
constexpr std::size_t check_every = 8192;
/// Layers of a plan, at most: more come from a part in another unit.
constexpr std::size_t max_layers = 100000;
/// Bins in which the slopes of the part are gathered, half a degree each, by heights. A bin counts as its
/// worst, so wider ones only make layers closer.
constexpr int slope_bins = 180;
constexpr std::size_t height_bins = 2048;
/// Facets flatter than this are level; a level place counts from this share of the cutter's area on.
constexpr double level_slope = 0.25 * pi / 180, level_share = 0.05;
/// Level places that get a layer of their own, the largest first: each costs a layer.
constexpr std::size_t max_level_places = 200;
/// Edges whose facets' normals make a smaller angle belong to a smooth surface.
const double smooth_cosine = std::cos(10 * pi / 180);

} // namespace

double layer_excess(const CutterProfile& cutter, double depth, double stepover, double slope) {
    const double between = cutter.height_at(0.5 * stepover); // of the floor over its layer, at most
    slope = std::clamp(slope, 0.0, 0.5 * pi - tolerance::vertical_normal_z);
    const double c = std::cos(slope), tan = std::tan(slope);
    // Flat enough for the next layer to begin beyond any reach: the floor's own height over the plane there.
    const double step = tan > 0 ? depth / tan : infinity;
    const Vec2 touch = plane_contact(cutter, slope);
    if (!(step < 1e3 * cutter.max_radius())) return c * (depth + between);
    // The upper layer ends at x = 0, where its cutter touches the plane at x = -touch.x; the lower one at
    // x = step, `depth` deeper. Before they meet the floor rises over the plane, behind it falls.
    const auto upper = [&](double x) {
        const double side = cutter.height_at(std::abs(x));
        return x > 0 ? std::min(side, between) : side;
    };
    const auto lower = [&](double x) { return cutter.height_at(std::abs(step - x)) - depth; };
    double from = -touch.x(), to = step - touch.x();
    for (int i = 0; i < 100 && to - from > last_halving * cutter.max_radius(); ++i) {
        const double x = 0.5 * (from + to);
        (upper(x) < lower(x) ? from : to) = x;
    }
    const auto excess = [&](double x, double z) { return c * (z - touch.y() + tan * (x + touch.x())); };
    // At a jump the floor ends at the height it had before.
    return std::max(
        {0.0, excess(from, std::min(upper(from), lower(from))), excess(to, std::min(upper(to), lower(to)))});
}

double layer_depth(const CutterProfile& cutter, double excess, double stepover, double slope, double most) {
    if (layer_excess(cutter, most, stepover, slope) <= excess) return most;
    double low = 0, high = most;
    for (int i = 0; i < 60; ++i) {
        const double mid = 0.5 * (low + high);
        (layer_excess(cutter, mid, stepover, slope) <= excess ? low : high) = mid;
    }
    return low;
}

namespace {

/// What the part asks of layers at every height of the tip.
class Demands {
public:
    Demands(const LayerInput& in, const Progress& progress)
        : in_(in), per_bin_(double(height_bins) / std::max(in.top - in.low, min_span)),
          steps_(height_bins, -1) {
        std::vector<Vec2> touch(slope_bins + 1);
        for (int b = 0; b <= slope_bins; ++b)
            touch[std::size_t(b)] = plane_contact(*in.cutter, slope_of(b));
        const UpSide up(*in.mesh, progress);
        struct Level {
            double height, area;
        };
        std::vector<Level> level;
        for (std::size_t f = 0; f < in.mesh->facet_count(); ++f) {
            if (f % check_every == 0) progress.check();
            const Vec3 n = up.towards_tool(in.mesh->facet_normal(f));
            if (!(n.z() > -tolerance::vertical_normal_z) || n == Vec3::Zero()) continue;
            double lo = infinity, hi = -infinity;
            for (int k = 0; k < 3; ++k) {
                lo = std::min(lo, in.mesh->corner(f, k).z());
                hi = std::max(hi, in.mesh->corner(f, k).z());
            }
            const double slope = std::acos(std::clamp(n.z(), 0.0, 1.0));
            // The flatter end of the bin asks for more.
            const auto bin = std::size_t(slope / (0.5 * pi) * slope_bins);
            const double lift = in.allowance * std::max(n.z(), 0.0) - touch[bin].y();
            if (slope < level_slope) {
                level.push_back({hi + in.allowance + in.margin + tolerance::contact_distance,
                                 0.5 * std::abs(in.mesh->facet_cross(f).z())});
                continue;
            }
            mark(lo + lift, hi + lift, int(bin));
        }
        std::sort(level.begin(), level.end(), [](const Level& a, const Level& b) {
            return a.height > b.height || (a.height == b.height && a.area > b.area);
        });
        std::vector<Level> places;
        for (const Level& l : level) {
            if (l.height >= in.top || l.height <= in.low) continue;
            // The highest of what lies close together is where the cutter may stand.
            if (!places.empty()
                && places.back().height - l.height <= 2 * std::max(in.margin, tolerance::contact_distance))
                places.back().area += l.area;
            else
                places.push_back(l);
        }
        const double radius = in.cutter->max_radius();
        std::erase_if(places, [&](const Level& l) { return l.area < level_share * pi * radius * radius; });
        std::sort(places.begin(), places.end(),
                  [](const Level& a, const Level& b) { return a.area > b.area; });
        if (places.size() > max_level_places) places.resize(max_level_places);
        for (const Level& l : places)
            level_.push_back(l.height);
        std::sort(level_.begin(), level_.end());
        // A level place with a layer of its own asks for nothing more.
        for (const Level& l : level) {
            const auto own = std::lower_bound(level_.begin(), level_.end(), l.height);
            if (own == level_.end() || *own - l.height > 2 * std::max(in.margin, tolerance::contact_distance))
                mark(l.height, l.height, 0);
        }
        mark_ridges(up, touch, progress);
        std::reverse(level_.begin(), level_.end());
    }

    const std::vector<double>& level_places() const { return level_; }
    /// The flattest slope that asks for something between two heights; nothing where none does.
    std::optional<double> flattest(double low, double high) const {
        int least = slope_bins + 1;
        for (std::size_t b = bin(low); b <= bin(high); ++b)
            if (steps_[b] >= 0) least = std::min(least, steps_[b]);
        if (least > slope_bins) return std::nullopt;
        return slope_of(least);
    }

private:
    /// Along a sharp convex edge the cutter rolls from one facet to the other, over all slopes between.
    void mark_ridges(const UpSide& up, const std::vector<Vec2>& touch, const Progress& progress) {
        struct Side {
            Index a, b, facet;
        };
        const Mesh& mesh = *in_.mesh;
        std::vector<Side> sides;
        sides.reserve(3 * mesh.facet_count());
        for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
            if (f % check_every == 0) progress.check();
            for (std::size_t k = 0; k < 3; ++k) {
                const Index a = mesh.facets[f][k], b = mesh.facets[f][(k + 1) % 3];
                sides.push_back({std::min(a, b), std::max(a, b), Index(f)});
            }
        }
        progress.check();
        std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
            return std::tie(x.a, x.b, x.facet) < std::tie(y.a, y.b, y.facet);
        });
        for (std::size_t i = 1; i < sides.size(); ++i) {
            if (i % check_every == 0) progress.check();
            const Side &s = sides[i - 1], &t = sides[i];
            if (s.a != t.a || s.b != t.b) continue;
            const Vec3 m = up.towards_tool(mesh.facet_normal(s.facet)),
                       n = up.towards_tool(mesh.facet_normal(t.facet));
            if (m.dot(n) > smooth_cosine || m == Vec3::Zero() || n == Vec3::Zero()) continue;
            if (m.z() < -tolerance::vertical_normal_z && n.z() < -tolerance::vertical_normal_z) continue;
            // Convex: the facets' middles lie behind each other's planes.
            const auto middle = [&](Index f) {
                return Vec3((mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3);
            };
            const Vec3& at = mesh.vertices[s.a];
            if (m.dot(middle(t.facet) - at) >= 0 || n.dot(middle(s.facet) - at) >= 0) continue;
            // The highest of the normals from m to n: where the edge's own plane stands upright, if between.
            Vec3 flattest = m.z() > n.z() ? m : n;
            const Vec3 edge = (mesh.vertices[s.b] - at).normalized();
            if (const Vec3 across = Vec3::UnitZ() - edge.z() * edge; across.norm() > 0) {
                const Vec3 top = across.normalized();
                if (m.cross(top).dot(m.cross(n)) >= 0 && n.cross(top).dot(n.cross(m)) >= 0) flattest = top;
            }
            const double slope = std::acos(std::clamp(flattest.z(), 0.0, 1.0));
            const auto bin_of = std::size_t(slope / (0.5 * pi) * slope_bins);
            const double lift = in_.allowance * std::max(flattest.z(), 0.0) - touch[bin_of].y();
            const double za = at.z(), zb = mesh.vertices[s.b].z();
            if (slope < level_slope) {
                // The rim of a level place that has a layer of its own.
                const double height =
                    std::max(za, zb) + in_.allowance + in_.margin + tolerance::contact_distance;
                const auto own = std::lower_bound(level_.begin(), level_.end(), height - in_.margin);
                if (own != level_.end()
                    && *own - height <= 2 * std::max(in_.margin, tolerance::contact_distance))
                    continue;
            }
            mark(std::min(za, zb) + lift, std::max(za, zb) + lift, int(bin_of));
        }
    }
    static double slope_of(int b) { return 0.5 * pi * b / slope_bins; }
    std::size_t bin(double z) const {
        return std::size_t(std::clamp((z - in_.low) * per_bin_, 0.0, double(height_bins - 1)));
    }
    void mark(double lo, double hi, int slope) {
        if (hi < in_.low || lo > in_.top) return;
        for (std::size_t b = bin(lo); b <= bin(hi); ++b)
            if (steps_[b] < 0 || slope < steps_[b]) steps_[b] = slope;
    }

    const LayerInput& in_;
    double per_bin_;
    std::vector<int> steps_; ///< slope bin of the flattest facet at a height; -1: none
    std::vector<double> level_;
};

} // namespace

Layers layer_heights(const LayerInput& in, const Progress& progress) {
    Layers layers;
    if (!(in.top > in.low)) return layers;
    const Demands demands(in, progress);
    std::vector<double> ends = demands.level_places();
    layers.level_places = ends.size();
    layers.depth_min = infinity;
    // On level places only the floor between lines stays.
    if (!ends.empty()) layers.excess = in.cutter->height_at(0.5 * in.stepover);
    ends.push_back(in.low);
    double z = in.top;
    const auto add = [&](double next) {
        if (layers.heights.size() >= max_layers)
            throw Error(ErrorCode::limit_exceeded, "depth",
                        "more than " + std::to_string(max_layers) + " layers are asked for",
                        "choose a larger depth or tolerance");
        layers.depth_min = std::min(layers.depth_min, z - next);
        layers.depth_max = std::max(layers.depth_max, z - next);
        if (const auto slope = demands.flattest(next, z))
            layers.excess = std::max(layers.excess, layer_excess(*in.cutter, z - next, in.stepover, *slope));
        layers.heights.push_back(next);
        z = next;
    };
    for (const double end : ends) {
        const double gap = z - end;
        if (in.depth) {
            const double n = std::ceil(gap / *in.depth - tolerance::grid_rounding), top = z;
            for (double i = 1; i <= n && layers.heights.size() <= max_layers; ++i)
                add(i == n ? end : top - gap * (i / n));
            continue;
        }
        while (z > end) {
            progress.check();
            // What lies within a layer decides its depth: less deep until nothing in it asks for less.
            double depth = std::min(in.deepest, z - end);
            for (int round = 0; round < 100; ++round) {
                const auto slope = demands.flattest(z - depth, z);
                const double allowed =
                    slope ? layer_depth(*in.cutter, in.excess, in.stepover, *slope, depth) : depth;
                if (allowed >= depth) break;
                depth = allowed;
            }
            if (!(depth > min_depth_share * in.cutter->max_radius()))
                throw Error(ErrorCode::internal, "depth", "no depth leaves what is allowed", "report this");
            add(z - depth > end + last_layer_share * depth ? z - depth : end);
        }
    }
    return layers;
}

} // namespace facetmill
