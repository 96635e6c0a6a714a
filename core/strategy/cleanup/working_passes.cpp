#include "core/strategy/cleanup/working_passes.h"

#include "core/base/parallel.h"
#include "core/strategy/cleanup/cut_tree.h"
#include "core/strategy/cleanup/standing.h"
#include "core/strategy/surface/cell_set.h"
#include "core/strategy/surface/contact_domain.h"

#include <algorithm>
#include <queue>

namespace facetmill {

namespace {

/// Places that stand for the bands are so far apart, in radii; those of triangles that are larger are closer.
constexpr double place_share = 0.15;
/// A motion that leaves no more than the least that any leaves, and this share of the cusp, is as good; so is
/// one that leaves no more than such a share of the cusp.
constexpr double as_good_share = 0.15, good_share = 0.8;
/// Passes are kept by stretches of about so many radii, and to begin one costs as much as so many.
constexpr double stretch_radii = 6, begin_radii = 2;
/// A stretch goes on over what works by so many radii, half as far as places that stand for the bands are
/// apart: what is beyond, another cuts.
constexpr double stretch_overlap = 0.5 * place_share;
/// On the border of a band as much is left as may be, but for rounding.
constexpr double border_share = 1 + 1e-6;
/// Distances from motions are known to this share of the cusp.
constexpr double working_accuracy = 0.02;
/// What of a pass takes nothing away is gone over where it is shorter than so many radii: that takes less
/// time than going out, over and in again.
constexpr double bridged_radii = 2;
constexpr std::size_t band_triangles_per_check = 4096, stretches_per_check = 4096;

class Working {
public:
    Working(const StripCutting& with, std::span<const BandCut> bands) : with_(with) {
        const double radius = with.cover->radius();
        for (const BandCut& b : bands)
            for (const Pass& pass : b.cut->passes) {
                double length = infinity;
                for (std::size_t i = 0; i + 1 < pass.cl.size(); ++i) {
                    if (length >= stretch_radii * radius) {
                        stretches_.push_back({motions_.size(), begin_radii * radius});
                        length = 0;
                    }
                    motions_.push_back({pass.cl[i].tip, pass.cl[i + 1].tip});
                    const double step = (pass.cl[i + 1].tip - pass.cl[i].tip).norm();
                    length += step;
                    stretches_.back().cost += step;
                }
            }
    }

    /// Says of every motion of all passes, one after the other, whether it is kept.
    std::vector<char> run(std::span<const BandCut> bands, const Progress& progress) {
        const std::vector<Place> places = places_of(bands, progress.part(0, 0.1));
        const CutTree tree(*with_.cover, motions_, working_accuracy * with_.cusp, progress);
        cutting_.resize(places.size());
        parallel_blocks(places.size(), 64, progress.part(0.1, 0.9), [&](std::size_t from, std::size_t to) {
            Standing::Hint near;
            for (std::size_t i = from; i < to; ++i)
                cutting_[i] = cutting(places[i], tree, near);
        });
        return kept(progress.part(0.9, 1));
    }

private:
    struct Place {
        Vec3 point;
        double left;        ///< by the cutter before; infinite where it is not asked
        bool known = false; ///< as rest_gaps.h says it; else between such places
    };

    struct Stretch {
        std::size_t first; ///< motion
        double cost;       ///< its length, and what it takes to begin it
    };

    std::vector<Place> places_of(std::span<const BandCut> bands, const Progress& progress) const {
        std::vector<Place> places;
        CellSet seen(place_share * with_.cover->radius());
        const auto add = [&](const Vec3& at, const Vec3& n, double left, bool known) {
            if (seen.add_first(at)) places.push_back({at + with_.allowance * n, left, known});
        };
        std::size_t count = 0;
        const auto check = [&] {
            if (count++ % band_triangles_per_check == 0) progress.check();
        };
        for (const BandCut& b : bands)
            for (std::size_t t = 0; t < b.band->band.size(); ++t) {
                check();
                const auto& [p, q, r] = b.band->band[t];
                const Vec3 n = with_.side->towards_tool((q - p).cross(r - p).normalized());
                const auto& left = b.band->left[t];
                const bool known = with_.allowance == 0;
                add(p, n, double(left[0]), known);
                add(q, n, double(left[1]), known);
                add(r, n, double(left[2]), known);
                add((p + q + r) / 3, n, (double(left[0]) + double(left[1]) + double(left[2])) / 3, false);
            }
        // What is left beside a band is not much, and not known well.
        for (const BandCut& b : bands)
            for (const auto& [p, n] : b.band->beside) {
                check();
                add(p, n, infinity, false);
            }
        return places;
    }

    /// The motions that cut a place as deep as any, or deep enough; none where that takes nothing away.
    std::vector<std::uint32_t> cutting(const Place& place, const CutTree& tree, Standing::Hint& near) const {
        // Between the corners of a band's triangles no more is known than about how much is left.
        double left = place.left, best = infinity;
        if (with_.standing
            && !(place.known ? left > border_share * with_.standing->enough()
                             : with_.standing->stands(place.point, left, with_.standing->enough(), near)))
            return {};
        // How much deeper it comes is not asked there.
        if (left == infinity) left = (1 + as_good_share) * with_.cusp;
        const auto bound = [&] {
            return std::min(std::max(good_share * with_.cusp, best + as_good_share * with_.cusp), left);
        };
        std::vector<std::pair<std::uint32_t, double>> found;
        tree.nearer(place.point, left, [&](std::size_t m, double d) {
            best = std::min(best, d);
            found.emplace_back(std::uint32_t(m), d);
            return bound();
        });
        if (found.empty()) return {};
        // Whether more than so much stood there matters.
        const double deep_enough = std::max(best, with_.cusp) + (1 + as_good_share) * with_.cusp;
        if (with_.standing && !(place.known && is_known(std::min(left, deep_enough))))
            left = with_.standing->uncut(place.point, std::min(left, deep_enough), infinity, near);
        // It comes within the cusp there, or much nearer than before.
        const bool deeper = place.left < infinity && left - best > with_.cusp;
        if (best > with_.cusp && !deeper) return {};
        std::vector<std::uint32_t> result;
        for (const auto& [m, d] : found)
            if (d <= bound()) result.push_back(m);
        std::sort(result.begin(), result.end());
        return result;
    }

    /// Has less than so much been asked for?
    bool is_known(double left) const { return left <= asked_tolerances * with_.standing->enough(); }

    /// Passes beside a crooked valley run over each other many times. So stretches of them are taken one
    /// after the other, first those that cut most places for their length which none before has cut, until
    /// every place is cut; of a stretch what cuts them.
    std::vector<char> kept(const Progress& progress) {
        std::vector<std::vector<std::uint32_t>> places(stretches_.size()); // that a stretch cuts
        for (std::size_t i = 0; i < cutting_.size(); ++i) {
            std::size_t last = stretches_.size();
            for (const std::uint32_t m : cutting_[i])
                if (const std::size_t s = stretch_of_motion(m); s != last)
                    places[last = s].push_back(std::uint32_t(i));
        }
        struct Offer {
            double gain;
            std::size_t stretch, places;
            bool operator<(const Offer& o) const {
                return gain != o.gain ? gain < o.gain : stretch > o.stretch;
            }
        };
        const auto offer = [&](std::size_t s, std::size_t count) {
            return Offer{double(count) / stretches_[s].cost, s, count};
        };
        std::priority_queue<Offer> offers;
        for (std::size_t s = 0; s < places.size(); ++s)
            if (!places[s].empty()) offers.push(offer(s, places[s].size()));
        std::vector<char> cut(cutting_.size(), 0), kept(motions_.size(), 0);
        for (std::size_t count = 0; !offers.empty(); ++count) {
            if (count % stretches_per_check == 0) progress.check();
            const Offer best = offers.top();
            offers.pop();
            auto& left = places[best.stretch];
            std::erase_if(left, [&](std::uint32_t i) { return cut[i] != 0; });
            if (left.empty()) continue;
            if (left.size() < best.places) {
                offers.push(offer(best.stretch, left.size()));
                continue;
            }
            const std::size_t next = best.stretch + 1;
            const std::size_t first = stretches_[best.stretch].first,
                              end = next < stretches_.size() ? stretches_[next].first : motions_.size();
            for (const std::uint32_t i : left) {
                cut[i] = 1;
                for (const std::uint32_t m : cutting_[i])
                    if (m >= first && m < end) kept[m] = 1;
            }
        }
        return kept;
    }

    std::size_t stretch_of_motion(std::size_t motion) const {
        const auto after = std::upper_bound(stretches_.begin(), stretches_.end(), motion,
                                            [](std::size_t m, const Stretch& s) { return m < s.first; });
        return std::size_t(after - stretches_.begin()) - 1;
    }

    const StripCutting& with_;
    std::vector<CutTree::Motion> motions_;
    std::vector<Stretch> stretches_;
    std::vector<std::vector<std::uint32_t>> cutting_; ///< motions, by places
};

/// The stretch of a pass from one length along it to another, longer where the cutter stands free only at the
/// next of its points.
Pass stretch_of(const AxialLift& lift, const Pass& pass, const std::vector<double>& arc,
                const Interval& range) {
    Pass part = pass;
    part.cl.clear();
    part.cc.clear();
    const auto add_end = [&](double at, bool last) {
        const auto i = std::clamp<std::size_t>(
            std::size_t(std::lower_bound(arc.begin(), arc.end(), at) - arc.begin()), 1, arc.size() - 1);
        const double t =
            arc[i] > arc[i - 1] ? std::clamp((at - arc[i - 1]) / (arc[i] - arc[i - 1]), 0.0, 1.0) : 1;
        const Vec3 tip = pass.cl[i - 1].tip + t * (pass.cl[i].tip - pass.cl[i - 1].tip);
        LiftHint none;
        const std::size_t next = last ? i : i - 1;
        if (lift.is_above(tip.x(), tip.y(), tip.z(), none)) {
            part.cl.push_back(pass.cl[next]);
            part.cc.push_back(pass.cc[next]);
            return;
        }
        part.cl.push_back({tip, pass.cl[i].axis});
        part.cc.push_back(pass.cc[t < 0.5 ? i - 1 : i]);
    };
    add_end(range.lo, false);
    for (std::size_t i = 0; i < arc.size(); ++i)
        if (arc[i] > range.lo && arc[i] < range.hi) {
            part.cl.push_back(pass.cl[i]);
            part.cc.push_back(pass.cc[i]);
        }
    add_end(range.hi, true);
    return part;
}

/// What of a pass works, given what each of its motions does; the first is `motion`, then the next pass's.
std::vector<Pass> busy_stretches(const StripCutting& with, Pass pass, const std::vector<char>& works,
                                 std::size_t& motion) {
    const std::size_t n = pass.cl.size();
    std::vector<double> arc(n, 0);
    std::vector<Interval> busy;
    const double overlap = std::min(with.overlap, stretch_overlap * with.cover->radius());
    for (std::size_t i = 1; i < n; ++i) {
        arc[i] = arc[i - 1] + (pass.cl[i].tip - pass.cl[i - 1].tip).norm();
        if (works[motion++] != 0) busy.push_back({arc[i - 1] - overlap, arc[i] + overlap});
    }
    std::vector<Pass> kept;
    for (const Interval& range : joined(std::move(busy), bridged_radii * with.cover->radius())) {
        if (range.lo <= 0 && range.hi >= arc.back()) return {std::move(pass)};
        kept.push_back(
            stretch_of(*with.lift, pass, arc, {std::max(range.lo, 0.0), std::min(range.hi, arc.back())}));
    }
    return kept;
}

} // namespace

void keep_working(const StripCutting& with, std::span<const BandCut> bands, const Progress& progress) {
    Working working(with, bands);
    const std::vector<char> works = working.run(bands, progress);
    std::size_t motion = 0;
    for (const BandCut& b : bands) {
        progress.check();
        std::vector<Pass> kept;
        for (Pass& pass : b.cut->passes)
            for (Pass& part : busy_stretches(with, std::move(pass), works, motion))
                kept.push_back(std::move(part));
        b.cut->passes = std::move(kept);
    }
}

} // namespace facetmill
