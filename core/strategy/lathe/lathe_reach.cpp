#include "core/strategy/lathe/lathe_reach.h"

#include "core/base/tolerances.h"
#include "core/strategy/lathe/lathe_unreached.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace facetmill {

namespace {

/// Cells of the unrolled part are this many spacings wide: samples in neighbouring ones lie together.
constexpr double cell_spacings = 2;
/// Samples of a region that are searched for thoroughly.
constexpr int max_again = 64;

/// Samples of one reason that lie together, on a grid over the unrolled part that closes around it.
class Regions {
public:
    /// The samples that a region's distance comes from are searched for again, and left out if served.
    Regions(const UnreachedSearch& search, std::vector<ReachSample>& samples, double cell, double radius)
        : search_(search), samples_(samples), cell_(cell), radius_(radius),
          around_(std::max<std::int64_t>(3, std::int64_t(2 * pi * radius / cell))) {}

    std::vector<UnreachedRegion> find(const Progress& progress) {
        std::vector<std::size_t> parent(samples_.size());
        std::iota(parent.begin(), parent.end(), std::size_t(0));
        const auto root = [&](std::size_t i) {
            while (parent[i] != i)
                i = parent[i] = parent[parent[i]];
            return i;
        };
        using Key = std::array<std::int64_t, 3>;
        std::map<Key, std::size_t> cells; // to the first sample in each
        const auto key = [&](const ReachSample& s) {
            return Key{std::int64_t(s.why),
                       std::min(std::int64_t(s.angle / (2 * pi) * double(around_)), around_ - 1),
                       std::int64_t(std::floor(s.y / cell_))};
        };
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const auto [at, is_new] = cells.try_emplace(key(samples_[i]), i);
            if (!is_new) parent[root(i)] = root(at->second);
        }
        for (const auto& [k, i] : cells)
            for (const std::int64_t a : {-1, 0, 1})
                for (const std::int64_t b : {-1, 0, 1}) {
                    const auto other = cells.find({k[0], (k[1] + a + around_) % around_, k[2] + b});
                    if (other != cells.end()) parent[root(i)] = root(other->second);
                }
        std::map<std::size_t, std::vector<std::size_t>> members;
        for (std::size_t i = 0; i < samples_.size(); ++i)
            members[root(i)].push_back(i);
        std::vector<UnreachedRegion> regions;
        for (auto& [unused, of] : members) {
            make_sure(of, progress);
            if (of.empty()) continue;
            if (UnreachedRegion r = region(of); r.area > 0) regions.push_back(std::move(r));
        }
        std::stable_sort(regions.begin(), regions.end(),
                         [](const UnreachedRegion& a, const UnreachedRegion& b) { return a.area > b.area; });
        return regions;
    }

private:
    /// Until the farthest has been searched thoroughly.
    void make_sure(std::vector<std::size_t>& of, const Progress& progress) const {
        LatheField::Hint hint;
        for (int k = 0; k < max_again && !of.empty(); ++k) {
            progress.check();
            const auto farthest = std::max_element(of.begin(), of.end(), [&](std::size_t a, std::size_t b) {
                return samples_[a].distance < samples_[b].distance;
            });
            if (samples_[*farthest].sure) return;
            if (!search_.search_again(samples_[*farthest], hint, progress)) of.erase(farthest);
        }
    }

    UnreachedRegion region(const std::vector<std::size_t>& of) const {
        UnreachedRegion r;
        r.why = samples_[of.front()].why;
        r.from = infinity;
        r.to = -infinity;
        std::vector<double> angles;
        for (const std::size_t i : of) {
            const ReachSample& s = samples_[i];
            r.area += s.area;
            r.distance = std::max(r.distance, s.distance);
            const double half = s.alone || of.size() == 1 ? s.half : 0;
            r.from = std::min(r.from, s.y - half);
            r.to = std::max(r.to, s.y + half);
            angles.push_back(s.angle);
            if (half > 0)
                for (const double to : {s.angle - half / radius_, s.angle + half / radius_})
                    angles.push_back(to - 2 * pi * std::floor(to / (2 * pi)));
        }
        // Round the part but for the widest gap; a gap no wider than the grid can tell is none.
        std::sort(angles.begin(), angles.end());
        double widest = angles.front() + 2 * pi - angles.back();
        r.angle_from = angles.front();
        r.angle_to = angles.back();
        for (std::size_t i = 1; i < angles.size(); ++i)
            if (angles[i] - angles[i - 1] > widest) {
                widest = angles[i] - angles[i - 1];
                r.angle_from = angles[i];
                r.angle_to = angles[i - 1] + 2 * pi;
            }
        if (widest <= 4 * pi / double(around_)) {
            r.angle_from = 0;
            r.angle_to = 2 * pi;
        }
        return r;
    }

    const UnreachedSearch& search_;
    std::vector<ReachSample>& samples_;
    double cell_, radius_;
    std::int64_t around_;
};

} // namespace

LatheReach lathe_reach(const LatheCommon& settings, const LatheField& field, const PlanContext& context,
                       const LatheRange& range, double allowed, const ReachFeed& feed,
                       const Progress& progress) {
    const LatheProbe probe(field, range, allowed);
    const ReachSampler sampler(settings, probe, *context.part);
    ReachSampler::Found found = sampler.facets(progress.part(0, 0.3));
    CreaseSearch::Found creases =
        CreaseSearch(sampler, probe, *context.part, feed).find(progress.part(0.3, 0.5));
    found.doubtful.insert(found.doubtful.end(), creases.doubtful.begin(), creases.doubtful.end());
    const UnreachedSearch search(probe, context.contact);
    std::vector<ReachSample> out = search.unreached(std::move(found.doubtful), progress.part(0.5, 0.95));
    LatheReach reach;
    reach.area = found.area;
    reach.limits = std::move(creases.limits);
    reach.crease_cusp = creases.cusp;
    reach.regions = Regions(search, out, cell_spacings * sampler.spacing(),
                            std::max(field.part_radius(), tolerance::smallest_extent))
                        .find(progress.part(0.95, 1));
    return reach;
}

} // namespace facetmill
