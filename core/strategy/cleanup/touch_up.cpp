#include "core/strategy/cleanup/touch_up.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/cleanup/border_touch.h"
#include "core/strategy/cleanup/cut_tree.h"
#include "core/strategy/cleanup/nearest_place.h"
#include "core/strategy/cleanup/pass_clearing.h"
#include "core/strategy/cleanup/standing.h"
#include "core/strategy/surface/cell_set.h"
#include "core/strategy/surface/facet_rows.h"
#include "core/strategy/surface/point_grid.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <numeric>
#include <optional>

namespace facetmill {

namespace {

constexpr std::size_t touched_per_check = 4096, touched_at_once = 32768;
/// In hollows that the cutter does not fill samples are so far apart, in radii.
constexpr double deep_share = 0.25;
constexpr double max_touch_samples = 1e6;
/// The least that the cutter can leave is looked for in steps down to this share of what may be left, unless
/// it is less than enough.
constexpr double finest_touch_share = 0.1, enough_share = 0.25;
/// Distances from motions are known to this share of what may be left.
constexpr double rest_accuracy = 0.02;
/// The next place on a pass is within this many radii, or else the first after a gap of up to this many.
constexpr double next_touch_share = 0.5, gap_share = 4;
/// A pass turns by no more than this cosine from one place to the next.
constexpr double max_touch_turn = 0.5, max_turn_after_gap = 0.95;
/// A pass goes on over its ends in so many steps of this share of the radius.
constexpr int end_steps = 1;
constexpr double end_share = 0.1;

/// A place of the part where passes leave more than they need to.
struct Left {
    RestSample sample; ///< `tip` and `gap` are those of the least that the cutter can leave
    double rest = 0;   ///< what is left
    double before = 0; ///< what stood before the cutter came
    std::size_t band = 0;
};

class TouchUp {
public:
    TouchUp(const StripCutting& with, std::span<const BandCut> bands, const TouchUpSampling& sampling)
        : with_(with), bands_(bands), sampling_(sampling), in_(reach_of(with)), radius_(with.cover->radius()),
          allowed_(with.cusp), enough_(enough_share * with.cusp),
          ball_(std::max(with.cover->profile().cutter().r, 0.1 * radius_)),
          spacing_(std::sqrt(8 * ball_ * sampling.stand_share * with.cusp)) {}

    void run(const Progress& progress) {
        for (const BandCut& b : bands_)
            for (const Pass& pass : b.cut->passes) {
                progress.check();
                for (std::size_t i = 0; i < pass.cl.size(); ++i)
                    motions_.push_back({pass.cl[i > 0 ? i - 1 : 0].tip, pass.cl[i].tip});
            }
        tree_.emplace(*with_.cover, motions_, rest_accuracy * allowed_, progress);
        find(progress.part(0, 0.9));
        join(progress.part(0.9, 1));
    }

private:
    static Vec3 level(const Vec3& p) { return Vec3(p.x(), p.y(), 0); }

    /// What helps to find out about the next place.
    struct Near {
        LiftHint lift;
        Standing::Hint cut;
        std::uint32_t pass = CutTree::no_motion;
    };

    /// A sample of a band.
    struct Place {
        Vec3 point; ///< on the triangle
        std::uint32_t band, triangle;
    };
    const std::array<Vec3, 3>& triangle(const Place& at) const {
        return bands_[at.band].band->band[at.triangle];
    }
    Vec3 normal(const std::array<Vec3, 3>& t) const {
        return with_.side->towards_tool((t[1] - t[0]).cross(t[2] - t[0]).normalized());
    }

    /// use(place, share) for the samples of all bands, with the share of triangles before.
    template <class Use>
    void each_place(Use&& use) const {
        double area = 0;
        for (const BandCut& b : bands_)
            area += b.band->area;
        const double apart = std::max(sampling_.sample_share * std::sqrt(2 * ball_ * with_.cusp),
                                      std::sqrt(area / max_touch_samples));
        CellSet seen(apart);
        std::size_t count = 0, triangles = 0;
        for (const BandCut& b : bands_)
            triangles += b.band->band.size();
        for (std::uint32_t b = 0; b < bands_.size(); ++b)
            for (std::uint32_t k = 0; k < bands_[b].band->band.size(); ++k) {
                const double share = double(count++) / double(triangles);
                const std::array<Vec3, 3>& t = bands_[b].band->band[k];
                const Vec3 n = normal(t);
                if (!(n.squaredNorm() > 0) || n.z() < -tolerance::vertical_normal_z) continue;
                const auto add = [&](const Vec3& at) { use(Place{at, b, k}, share); };
                const FacetRows rows(t, apart);
                if (rows.rows() == 1 && rows.columns(0) == 1) {
                    if (const Vec3 middle = rows.point(0, 0); seen.add_first(middle)) add(middle);
                    continue;
                }
                // Corners, too: on a hollow part more is left at them than between.
                for (const Vec3& corner : t)
                    if (seen.add_first(corner)) add(corner);
                for (std::size_t i = 0; i < rows.rows(); ++i)
                    for (std::size_t j = 0; j < rows.columns(i); ++j)
                        add(rows.point(i, j));
            }
    }

    /// What stood over a place before the cutter came, as known at the corners of its triangle.
    double before(const Place& at) const {
        const auto& [a, b, c] = triangle(at);
        const auto& left = bands_[at.band].band->left[at.triangle];
        const Vec3 n = (b - a).cross(c - a);
        const double in_a = (b - at.point).cross(c - at.point).dot(n) / n.squaredNorm(),
                     in_b = (c - at.point).cross(a - at.point).dot(n) / n.squaredNorm();
        return in_a * double(left[0]) + in_b * double(left[1]) + (1 - in_a - in_b) * double(left[2]);
    }

    /// A place on which more is left than may be, if it is one. How much is left takes longer to know.
    std::optional<Left> left_at(const Place& at, Near& near) const {
        Left l;
        const Vec3 n = normal(triangle(at)), p = at.point + with_.allowance * n;
        if (tree_->nearest(p, allowed_, allowed_, near.pass) < allowed_) return std::nullopt;
        l.before = before(at);
        if (with_.standing && !with_.standing->stands(p, l.before, with_.standing->enough(), near.cut))
            return std::nullopt;
        l.sample.point = p;
        l.sample.normal = n;
        l.band = at.band;
        return l;
    }

    /// The same for some, with where the cutter stands over them.
    std::vector<Left> left_at(std::span<const Place> places, const Progress& progress) const {
        std::vector<Left> found;
        std::vector<RestSample> samples;
        Near near;
        for (const Place& at : places)
            if (const auto l = left_at(at, near)) {
                found.push_back(*l);
                samples.push_back(l->sample);
            }
        nearest_touches(in_, samples, progress);
        for (std::size_t i = 0; i < found.size(); ++i)
            found[i].sample = samples[i];
        return found;
    }

    /// How much is left there, and the least that the cutter can leave. Is that worth it?
    bool leaves_too_much(Left& l, Near& near) const {
        const Vec3 p = l.sample.point;
        l.rest = tree_->nearest(p, allowed_, infinity, near.pass);
        // Where it leaves more than so much in any case, that is not worth it.
        const double most = std::min(l.rest - allowed_, std::max(allowed_, l.before - allowed_));
        l.sample = nearest_about(in_, l.sample, enough_, finest_touch_share * allowed_, near.lift,
                                 std::max(most, enough_));
        if (!too_much(l)) return false;
        // Less may stand there than at the corners of the triangle.
        const double best = at_best(l);
        return !with_.standing || best <= allowed_
               || with_.standing->stands(p, l.before, best + allowed_, near.cut);
    }

    /// Where more is left than need be. Places are asked to the end some at a time, so that only those are
    /// kept of which it is true.
    void find(const Progress& progress) {
        // Where the cutter does not touch, what is left changes less from place to place.
        CellSet deep(deep_share * radius_);
        std::vector<Place> some;
        some.reserve(touched_at_once);
        double done = 0;
        std::size_t count = 0;
        each_place([&](const Place& at, double share) {
            if (count++ % touched_per_check == 0) progress.check();
            some.push_back(at);
            if (some.size() < touched_at_once) return;
            look_at(some, deep, progress.part(done, share));
            some.clear();
            done = share;
        });
        look_at(some, deep, progress.part(done, 1));
    }

    void look_at(const std::vector<Place>& places, CellSet& deep, const Progress& progress) {
        constexpr std::size_t in_block = 256;
        std::vector<std::vector<Left>> some((places.size() + in_block - 1) / in_block);
        parallel_blocks(places.size(), in_block, progress.part(0, 0.6),
                        [&](std::size_t from, std::size_t to) {
                            some[from / in_block] =
                                left_at(std::span(places).subspan(from, to - from), progress.part(0, 0));
                        });
        std::vector<Left> found;
        for (const auto& block : some)
            for (const Left& l : block)
                if (!(l.sample.gap > 0.5 * allowed_ && !deep.add_first(l.sample.point))) found.push_back(l);
        std::vector<char> which(found.size(), 0);
        parallel_blocks(found.size(), 16, progress.part(0.6, 1), [&](std::size_t from, std::size_t to) {
            Near near;
            for (std::size_t i = from; i < to; ++i)
                which[i] = leaves_too_much(found[i], near) && !is_over_border(found[i].sample.tip);
        });
        for (std::size_t i = 0; i < found.size(); ++i)
            if (which[i]) left_.push_back(found[i]);
    }

    /// Where the search ended early the cutter can leave next to nothing.
    double at_best(const Left& l) const { return l.sample.gap > enough_ ? l.sample.gap : 0; }
    bool too_much(const Left& l) const {
        const double best = at_best(l);
        // Where too much stays in any case, it has to be worth it.
        return l.rest > best + allowed_ && (best <= allowed_ || l.before > best + allowed_);
    }

    /// Beyond the border there is nothing to cut.
    bool is_over_border(const Vec3& tip) const {
        const Vec3 touch = with_.lift->contact(tip.x(), tip.y()).point;
        const auto normal = with_.cover->contact_normal(touch - tip);
        return normal && rolls_over_border(*with_.mesh, *with_.grid, *with_.side, touch, *normal);
    }

    /// Passes over what was found, from where most is left.
    void join(const Progress& progress) {
        PointGrid tips(next_touch_share * radius_), points(radius_);
        for (const Left& l : left_) {
            tips.add(level(l.sample.tip));
            points.add(level(l.sample.point));
        }
        std::vector<std::size_t> order(left_.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return excess(a) > excess(b); });
        std::vector<std::vector<Pass>> more(bands_.size());
        for (const std::size_t seed : order) {
            progress.check();
            if (too_much(left_[seed]))
                more[left_[seed].band].push_back(pass_over(tips_from(seed, tips, points)));
        }
        for (std::size_t b = 0; b < bands_.size(); ++b) {
            clear_passes(with_, more[b], progress.part(0, 0));
            std::move(more[b].begin(), more[b].end(), std::back_inserter(bands_[b].cut->passes));
        }
    }

    /// The cutter's places from one on to both sides along the ridge that it stands on.
    std::vector<Vec3> tips_from(std::size_t seed, const PointGrid& tips, const PointGrid& points) {
        const Vec3 start = left_[seed].sample.tip;
        const Vec3 along = along_near(left_[seed].sample.point);
        std::array<std::vector<Vec3>, 2> halves;
        cover(start, start, points);
        for (const std::size_t half : {0, 1}) {
            Vec3 at = start, ahead = half == 0 ? along : Vec3(-along);
            if (half == 1 && !halves[0].empty()) ahead = (start - halves[0].front()).normalized();
            for (std::size_t next = next_on(at, ahead, tips); next != left_.size();
                 next = next_on(at, ahead, tips)) {
                const Vec3 tip = left_[next].sample.tip;
                cover(at, tip, points);
                // Where it cannot be bettered it is not asked again.
                left_[next].rest = std::min(left_[next].rest, left_[next].sample.gap);
                if (const double length = (tip - at).norm(); length > 0) ahead = (tip - at) / length;
                at = tip;
                halves[half].push_back(tip);
            }
            extend(at, ahead, halves[half]);
        }
        if (halves[0].empty() && halves[1].empty()) lengthen(left_[seed].sample, halves);
        std::vector<Vec3> all(halves[1].rbegin(), halves[1].rend());
        all.push_back(start);
        all.insert(all.end(), halves[0].begin(), halves[0].end());
        return all;
    }

    /// A single place on a steep flank: level along it, or else straight down on to it.
    void lengthen(const RestSample& place, std::array<std::vector<Vec3>, 2>& halves) const {
        const Vec3 along = Vec3::UnitZ().cross(place.normal);
        if (along.norm() > tolerance::level_angle) {
            extend(place.tip, along.normalized(), halves[0]);
            extend(place.tip, -along.normalized(), halves[1]);
        }
        if (halves[0].empty() && halves[1].empty())
            halves[1].push_back(place.tip + end_share * radius_ * Vec3::UnitZ());
    }

    /// The cutter moves from one tip to another: less is left then.
    void cover(const Vec3& from, const Vec3& to, const PointGrid& points) {
        const auto parts = std::size_t((to - from).norm() / spacing_) + 1;
        for (std::size_t k = 1; k <= parts; ++k) {
            const Vec3 tip = from + double(k) / double(parts) * (to - from);
            points.near(level(tip), 1.1 * radius_, [&](std::size_t i) {
                left_[i].rest = std::min(left_[i].rest, with_.cover->distance(left_[i].sample.point - tip));
            });
        }
    }

    double excess(std::size_t i) const { return left_[i].rest - at_best(left_[i]); }

    /// The place where most is left of those that come next on a pass, or, where there is none, the first
    /// after a gap; the number of places where there is none either.
    std::size_t next_on(const Vec3& at, const Vec3& ahead, const PointGrid& tips) const {
        for (const double reach : {next_touch_share * radius_, gap_share * radius_}) {
            std::size_t next = left_.size();
            double least = infinity;
            tips.near(level(at), reach, [&](std::size_t i) {
                const Vec3 step = left_[i].sample.tip - at;
                const double length = step.norm();
                const double cosine =
                    reach == next_touch_share * radius_ ? max_touch_turn : max_turn_after_gap;
                if (!too_much(left_[i]) || length > reach || step.dot(ahead) < cosine * length) return;
                const double rank = reach == next_touch_share * radius_ ? -excess(i) : length;
                if (rank > least || (rank == least && i > next)) return;
                least = rank;
                next = i;
            });
            if (next < left_.size()) return next;
        }
        return left_.size();
    }

    /// Unit vector along the pass that comes nearest to a place.
    Vec3 along_near(const Vec3& p) const {
        Vec3 along = Vec3::UnitX();
        tree_->nearer(p, infinity, [&](std::size_t m, double d) {
            const Vec3 route = motions_[m][1] - motions_[m][0];
            if (route.norm() > 0) along = route.normalized();
            return d;
        });
        return along;
    }

    /// A little farther, as far as the part goes on.
    void extend(Vec3 at, const Vec3& ahead, std::vector<Vec3>& tips) const {
        for (int k = 0; k < end_steps; ++k) {
            const double step = end_share * radius_;
            Vec3 next = at + step * ahead;
            const double z = with_.lift->tip_z(next.x(), next.y());
            if (!(std::abs(z - next.z()) <= step)) return;
            next.z() = z + tolerance::contact_distance;
            tips.push_back(next);
            at = next;
        }
    }

    Pass pass_over(const std::vector<Vec3>& tips) const {
        Pass pass;
        for (const Vec3& tip : tips) {
            const AxialContact c = with_.lift->contact(tip.x(), tip.y());
            pass.cl.push_back({tip, Vec3::UnitZ()});
            pass.cc.push_back({c.point, with_.cover->contact_normal(c.point - tip).value_or(Vec3::UnitZ())});
        }
        return pass;
    }

    const StripCutting& with_;
    std::span<const BandCut> bands_;
    TouchUpSampling sampling_;
    ValleyInput in_;
    double radius_, allowed_;
    double enough_;                        ///< where the cutter leaves no more, no better place is looked for
    double ball_;                          ///< radius of the cutter's corner
    double spacing_;                       ///< distance of places along passes
    std::vector<CutTree::Motion> motions_; ///< of the passes
    std::optional<CutTree> tree_;
    std::deque<Left> left_; ///< up to a million: they are not to be moved
};

} // namespace

void touch_up(const StripCutting& with, std::span<const BandCut> bands, const Progress& progress,
              const TouchUpSampling& sampling) {
    TouchUp(with, bands, sampling).run(progress);
}

} // namespace facetmill
