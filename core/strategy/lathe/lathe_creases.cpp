#include "core/strategy/lathe/lathe_creases.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace facetmill {

namespace {

/// Creases that a thread takes at a time; vertices between two looks at the cancel flag.
constexpr std::size_t creases_per_block = 32, facets_per_check = 8192;
/// A fillet of less than this share of what is allowed takes nothing from the feed.
constexpr double min_fillet = 0.05;
/// Where between two turns a crease may lie, in advances; halvings of the advance that it allows, and
/// the least, as a share of that without it.
constexpr std::array<double, 3> shares{0.35, 0.5, 0.65};
constexpr int crease_halvings = 6;
constexpr double smallest_share = 1.0 / 16;

CreaseSearch::Found joined_creases(CreaseSearch::Found a, const CreaseSearch::Found& b) {
    a.doubtful.insert(a.doubtful.end(), b.doubtful.begin(), b.doubtful.end());
    a.limits.insert(a.limits.end(), b.limits.begin(), b.limits.end());
    a.cusp = std::max(a.cusp, b.cusp);
    return a;
}

} // namespace

CreaseSearch::Found CreaseSearch::find(const Progress& progress) const {
    const std::vector<Crease> all = creases(progress);
    // Where creases meet more stays than in their middles.
    const Corners corners = corners_of(all, progress);
    Found found = parallel_reduce(
        all.size() + corners.ends.size(), creases_per_block, Found(), progress,
        [&](std::size_t begin, std::size_t end) {
            Found here;
            LatheField::Hint hint;
            std::vector<Vec3> normals;
            for (std::size_t i = begin; i < end; ++i) {
                if (i < all.size()) {
                    along(all[i], hint, here, progress);
                    continue;
                }
                const Index v = corners.ends[i - all.size()];
                normals.clear();
                for (std::size_t k = corners.first[v]; k < corners.first[v + 1]; ++k)
                    for (const Vec3& n : all[corners.meeting[k]].normal)
                        if (std::find(normals.begin(), normals.end(), n) == normals.end())
                            normals.push_back(n);
                hollow(mesh_.vertices[v], normals, 0, hint, here, progress);
            }
            return here;
        },
        joined_creases);
    thin_out(found.doubtful);
    return found;
}

CreaseSearch::Corners CreaseSearch::corners_of(const std::vector<Crease>& all,
                                               const Progress& progress) const {
    const std::size_t corners = mesh_.vertices.size();
    Corners filed;
    filed.first.assign(corners + 1, 0);
    for (const Crease& c : all)
        for (const Index v : c.ends)
            ++filed.first[v + 1];
    for (std::size_t v = 0; v < corners; ++v) {
        if (filed.first[v + 1] > 0) filed.ends.push_back(Index(v));
        filed.first[v + 1] += filed.first[v];
    }
    progress.check();
    filed.meeting.resize(2 * all.size());
    std::vector<std::size_t> next(filed.first.begin(), filed.first.end() - 1);
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const Index v : all[i].ends)
            filed.meeting[next[v]++] = i;
    return filed;
}

/// Looks at the middles of pieces of a crease.
void CreaseSearch::along(const Crease& crease, LatheField::Hint& hint, Found& found,
                         const Progress& progress) const {
    const Vec3 &a = mesh_.vertices[crease.ends[0]], &b = mesh_.vertices[crease.ends[1]];
    const auto pieces = std::size_t((b - a).norm() / sampler_.spacing()) + 1;
    const double length = (b - a).norm() / double(pieces);
    for (std::size_t k = 0; k < pieces; ++k)
        hollow(a + (double(k) + 0.5) / double(pieces) * (b - a), crease.normal, length, hint, found,
               progress);
}

/// Keeps of samples without an area, which only say how far the cutter stays away, the farthest in every
/// piece of the part as large as a sample's: in a fine mesh they lie much closer than those of facets.
void CreaseSearch::thin_out(std::vector<ReachSample>& samples) const {
    std::map<std::array<std::int64_t, 2>, std::size_t> farthest;
    const auto piece = [&](const ReachSample& s) {
        return std::array<std::int64_t, 2>{std::int64_t(s.angle * probe_.away_of(s.p) / sampler_.spacing()),
                                           std::int64_t(std::floor(s.y / sampler_.spacing()))};
    };
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples[i].area > 0) continue;
        const auto [at, is_new] = farthest.try_emplace(piece(samples[i]), i);
        if (!is_new && samples[i].distance > samples[at->second].distance) at->second = i;
    }
    std::size_t left = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
        if (samples[i].area > 0 || farthest.at(piece(samples[i])) == i)
            std::swap(samples[left++], samples[i]);
    samples.resize(left);
}

std::vector<CreaseSearch::Crease> CreaseSearch::creases(const Progress& progress) const {
    const Progress quiet = progress.part(0, 0); // cancels, and leaves the fraction alone
    const EdgeTable table(mesh_, quiet);
    // The fillet of the largest ball that could be in the cutter.
    const double least = 1 + min_fillet * probe_.allowed() / probe_.radius();
    std::vector<Crease> all;
    for (std::size_t v = 0; v < table.vertex_count(); ++v) {
        if (v % facets_per_check == 0) progress.check();
        table.for_edges(v, [&](Index, std::span<const EdgeSide> sides) {
            for (std::size_t i = 1; i < sides.size(); ++i)
                add_crease(Index(v), sides[i - 1], sides[i], least, all);
        });
    }
    return all;
}

void CreaseSearch::add_crease(Index low, const EdgeSide& side, const EdgeSide& other, double least,
                              std::vector<Crease>& creases) const {
    const Vec3 &a = mesh_.vertices[low], &b = mesh_.vertices[side.high];
    const Vec3 middle = 0.5 * (a + b), r = probe_.frame().radial(probe_.angle_of(middle));
    std::array<Vec3, 2> n{mesh_.facet_normal(side.facet()), mesh_.facet_normal(other.facet())};
    if (sampler_.is_end(side.facet(), n[0]) || sampler_.is_end(other.facet(), n[1])) return;
    for (Vec3& v : n)
        if (v.dot(r) < 0) v = -v;
    const double half_cosine = std::sqrt(std::max(0.5 * (1 + n[0].dot(n[1])), 0.0));
    if (half_cosine * least >= 1) return;
    if (!(n[0].dot(mesh_.vertices[side_across(mesh_, other.side)] - a) > 0)) return; // bulges
    creases.push_back({{low, side.high}, n});
}

/// A place of a hollow edge of which it stands for `length`, or (0) where such edges meet; normals of the
/// facets beside it.
void CreaseSearch::hollow(const Vec3& p, std::span<const Vec3> normals, double length, LatheField::Hint& hint,
                          Found& found, const Progress& progress) const {
    progress.check();
    if (sampler_.is_beyond(probe_.frame().along(p))) return;
    Vec3 middle = Vec3::Zero();
    for (const Vec3& n : normals)
        middle += n;
    const LathePlace place = probe_.place_over(p, middle.normalized());
    if (place.y < probe_.range().from || place.y > probe_.range().to) return;
    const LatheProbe::Stand over = probe_.stand(place, hint);
    double rests = 0;
    for (const Vec3& n : normals)
        rests = std::max(rests, probe_.rest(over, p, n).height);
    const double allowed = probe_.allowed();
    if (rests <= min_fillet * allowed) return;
    if (rests <= allowed) {
        limit_feed(place, p, normals, hint, found);
        return;
    }
    // A ball leaves h (s) = (w - s)^2 / 2r at the distance s from where it leaves h (0): more than is
    // allowed up to this. Where samples of facets are farther apart they would miss it; where not, it
    // is here that the cutter stays farthest away.
    const double wide = std::sqrt(2 * probe_.radius()) * (std::sqrt(rests) - std::sqrt(allowed));
    const bool missed = wide < 0.5 * sampler_.spacing();
    const double area = !missed ? 0 : length > 0 ? 2 * wide * length : pi * wide * wide;
    sampler_.sample(p, normals[0], area, missed, hint, found.doubtful);
}

/// What the nearer of two cutters leaves that pass p to both sides, an advance apart.
double CreaseSearch::left_by(double advance, const LathePlace& place, const Vec3& p,
                             std::span<const Vec3> normals, LatheField::Hint& hint) const {
    double most = 0;
    for (const double share : shares) {
        std::array<LathePlace, 2> places{place, place};
        (feed_.across_turns ? places[0].y : places[0].angle) -= share * advance;
        (feed_.across_turns ? places[1].y : places[1].angle) += (1 - share) * advance;
        const LatheProbe::Stand before = probe_.stand(places[0], hint), after = probe_.stand(places[1], hint);
        for (const Vec3& n : normals) {
            const double first = probe_.rest(before, p, n).height;
            if (first > most) most = std::max(most, std::min(first, probe_.rest(after, p, n).height));
        }
    }
    return most;
}

void CreaseSearch::limit_feed(const LathePlace& place, const Vec3& p, std::span<const Vec3> normals,
                              LatheField::Hint& hint, Found& found) const {
    const double at = feed_.across_turns ? place.y : std::remainder(place.angle - pi, 2 * pi) + pi;
    const auto left = [&](double advance) { return left_by(advance, place, p, normals, hint); };
    const double wanted = feed_.advance(at), leaves = left(wanted);
    found.cusp = std::max(found.cusp, leaves);
    if (leaves <= probe_.allowed()) return;
    double good = 0, bad = wanted;
    for (int k = 0; k < crease_halvings; ++k) {
        const double mid = 0.5 * (good + bad);
        (left(mid) <= probe_.allowed() ? good : bad) = mid;
    }
    found.limits.push_back({at, std::max(good, smallest_share * wanted)});
}

} // namespace facetmill
