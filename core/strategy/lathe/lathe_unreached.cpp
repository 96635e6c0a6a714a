#include "core/strategy/lathe/lathe_unreached.h"
#include "core/base/plane_geometry.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Distance of the places at which the cutter is lowered, once for all samples around, as a share of its
/// radius.
constexpr double lattice_share = 1.0 / 8;
constexpr double max_places = 1e6; ///< over the whole part; else they are farther apart
/// What a thread takes at a time; samples between two looks at the cancel flag.
constexpr std::size_t doubtful_per_block = 64, stands_per_block = 64, unreached_per_check = 64;
/// A thorough search looks at so many places, within so many radii of the cutter, and goes downhill from so
/// many of the best.
constexpr int spread = 96, best_starts = 3;
constexpr double spread_share = 1.25;
/// Angles to either side at which the way out from a place is looked at.
constexpr int sights = 4;

} // namespace

/// The cutter lowered on an even grid over the unrolled part, as far as samples lie below.
struct UnreachedSearch::Lattice {
    std::int64_t around = 0, along = 0;
    double turn = 0, step = 0, from = 0; ///< between neighbours, radians and mm; y of the first
    std::vector<std::uint32_t> slot;     ///< a place's, in `stands`
    std::vector<LatheProbe::Stand> stands;

    /// Calls visit(place's number) for all places that are less than `radius` beside the place.
    template <class Visit>
    void near(const LathePlace& place, double radius, double away, Visit&& visit) const {
        const auto lowest = std::int64_t(std::ceil((place.y - radius - from) / step)),
                   highest = std::int64_t(std::floor((place.y + radius - from) / step));
        for (std::int64_t j = std::max<std::int64_t>(lowest, 0); j <= std::min(highest, along - 1); ++j) {
            const double dy = from + double(j) * step - place.y;
            const double side = std::sqrt(std::max(radius * radius - dy * dy, 0.0)) / away;
            const auto left = std::int64_t(std::ceil((place.angle - side) / turn));
            auto right = std::int64_t(std::floor((place.angle + side) / turn));
            right = std::min(right, left + around - 1);
            for (std::int64_t i = left; i <= right; ++i)
                visit(std::size_t(j * around + ((i % around) + around) % around));
        }
    }
};

UnreachedSearch::UnreachedSearch(const LatheProbe& probe, const ContactIndexPtr& contact)
    : probe_(probe),
      needle_(contact, CutterProfile(AptCutter::flat(tolerance::needle_diameter, unlimited_height))) {}

std::vector<ReachSample> UnreachedSearch::unreached(std::vector<ReachSample> doubtful,
                                                    const Progress& progress) const {
    const Lattice lattice = lattice_around(doubtful, progress.part(0, 0.3));
    std::vector<char> served(doubtful.size(), 0);
    parallel_blocks(doubtful.size(), doubtful_per_block, progress.part(0.3, 1),
                    [&](std::size_t begin, std::size_t end) {
                        LatheField::Hint hint;
                        for (std::size_t i = begin; i < end; ++i)
                            served[i] = serve(doubtful[i], lattice, hint, progress);
                    });
    std::size_t left = 0;
    for (std::size_t i = 0; i < doubtful.size(); ++i)
        if (!served[i]) std::swap(doubtful[left++], doubtful[i]);
    doubtful.resize(left);
    return doubtful;
}

bool UnreachedSearch::search_again(ReachSample& s, LatheField::Hint& hint, const Progress& progress) const {
    const LathePlace straight = probe_.straight_over(s.p);
    const double radius = probe_.radius(), away = probe_.away_of(s.p);
    std::vector<std::pair<double, LathePlace>> starts;
    for (int k = 0; k < spread; ++k) {
        const double out = spread_share * radius * std::sqrt((k + 0.5) / spread);
        const LathePlace place{straight.angle + out * std::cos(k * golden_angle) / away,
                               straight.y + out * std::sin(k * golden_angle)};
        const LatheProbe::Rest here = probe_.rest(probe_.stand(place, hint), s.p, s.n);
        if (here.height <= probe_.allowed()) return false;
        starts.emplace_back(here.distance, place);
    }
    std::stable_sort(starts.begin(), starts.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    starts.resize(best_starts);
    starts.emplace_back(0, straight);
    for (const auto& [unused, start] : starts) {
        const LatheProbe::Nearest found = probe_.nearest_from(start, 0.5 * radius, s.p, s.n, hint, progress);
        if (found.height <= probe_.allowed()) return false;
        s.distance = std::min(s.distance, found.distance - probe_.field().allowance());
    }
    s.sure = true;
    return true;
}

UnreachedSearch::Lattice UnreachedSearch::lattice_around(std::span<const ReachSample> samples,
                                                         const Progress& progress) const {
    Lattice lattice;
    if (samples.empty()) return lattice;
    constexpr std::uint32_t none = ~std::uint32_t(0), wanted = none - 1;
    const double radius = probe_.radius(), outside = std::max(probe_.field().part_radius(), radius);
    const double step =
        std::max(lattice_share * radius,
                 std::sqrt(2 * pi * outside * (probe_.range().to - probe_.range().from) / max_places));
    lattice.around = std::int64_t(2 * pi * outside / step) + 1;
    lattice.along = std::int64_t((probe_.range().to - probe_.range().from) / step) + 2;
    lattice.turn = 2 * pi / double(lattice.around);
    lattice.step = std::max((probe_.range().to - probe_.range().from) / double(lattice.along - 1),
                            tolerance::smallest_extent);
    lattice.from = probe_.range().from;
    lattice.slot.assign(std::size_t(lattice.around * lattice.along), none);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (i % unreached_per_check == 0) progress.check();
        lattice.near(probe_.straight_over(samples[i].p), radius, probe_.away_of(samples[i].p),
                     [&](std::size_t k) { lattice.slot[k] = wanted; });
    }
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < lattice.slot.size(); ++k) {
        if (lattice.slot[k] == none) continue;
        lattice.slot[k] = std::uint32_t(places.size());
        places.push_back(k);
    }
    lattice.stands.resize(places.size());
    parallel_blocks(places.size(), stands_per_block, progress, [&](std::size_t begin, std::size_t end) {
        LatheField::Hint hint;
        for (std::size_t i = begin; i < end; ++i) {
            const auto k = std::int64_t(places[i]);
            lattice.stands[i] = probe_.stand({double(k % lattice.around) * lattice.turn,
                                              lattice.from + double(k / lattice.around) * lattice.step},
                                             hint);
        }
    });
    return lattice;
}

/// Whether any place serves the sample; if not, its best place, distance and reason are set.
bool UnreachedSearch::serve(ReachSample& s, const Lattice& lattice, LatheField::Hint& hint,
                            const Progress& progress) const {
    progress.check();
    const LathePlace straight = probe_.straight_over(s.p);
    const CutterCover& cover = probe_.field().cover();
    LatheProbe::Nearest best{LatheProbe::Rest{infinity, s.distance}, s.at};
    bool served = false;
    lattice.near(straight, cover.radius(), probe_.away_of(s.p), [&](std::size_t k) {
        if (served) return;
        const LatheProbe::Stand& tool = lattice.stands[lattice.slot[k]];
        const double distance = cover.distance(tool.local(s.p - tool.tip));
        // What is left along the normal is no less than the distance tells.
        if (distance <= probe_.field().allowance() + probe_.allowed())
            served = probe_.rest(tool, s.p, s.n).height <= probe_.allowed();
        if (distance < best.distance) best = {LatheProbe::Rest{infinity, distance}, tool.at};
    });
    if (served) return true;
    best = probe_.nearest_from(best.at.place, 0.5 * lattice.step, s.p, s.n, hint, progress);
    if (best.height <= probe_.allowed()) return true;
    // Straight over it the cutter is no farther than the part's outside.
    const LatheProbe::Stand above = probe_.stand(straight, hint);
    if (const LatheProbe::Nearest here{probe_.rest(above, s.p, s.n), above.at}; here.distance < best.distance)
        best = here;
    if (best.height <= probe_.allowed()) return true;
    s.at = best.at;
    s.distance = best.distance - probe_.field().allowance();
    s.why = reason(s.p, s.n, best.at);
    return false;
}

UnreachedRegion::Why UnreachedSearch::reason(const Vec3& p, const Vec3& n, const LathePoint& at) const {
    using Why = UnreachedRegion::Why;
    const bool beyond = at.place.y <= probe_.range().from || at.place.y >= probe_.range().to;
    if (at.held == LathePoint::HeldBy::zone || (beyond && probe_.range().held_back > 0)) return Why::held;
    if (is_covered(p, n)) return Why::covered;
    if (at.held == LathePoint::HeldBy::core) return Why::core;
    return at.held == LathePoint::HeldBy::shaft ? Why::shaft : Why::narrow;
}

/// Along the tool's axis, at no angle at which the cutter could be over p, the way out is free.
bool UnreachedSearch::is_covered(const Vec3& p, const Vec3& n) const {
    const double radius = probe_.radius(), rho = std::max(probe_.frame().away(p), radius);
    // Beside a wall that is upright to the tool its one side is open.
    const Vec3 beside = 10 * tolerance::needle_diameter * n;
    for (int k = -sights; k <= sights; ++k) {
        const Vec3 axis =
            probe_.frame().tool_axis(probe_.angle_of(p) + std::asin(radius * k / (sights * rho)));
        for (const double side : {1.0, -1.0})
            if (needle_.lift({p + side * beside, axis}) <= probe_.field().allowance() + probe_.allowed())
                return false;
    }
    return true;
}

} // namespace facetmill
