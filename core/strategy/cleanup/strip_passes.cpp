#include "core/strategy/cleanup/strip_passes.h"

#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/strategy/cleanup/between_passes.h"
#include "core/strategy/cleanup/pass_clearing.h"
#include "core/strategy/cleanup/valley_spots.h"

namespace facetmill {

namespace {

/// Passes to one side of a valley, and changes of their step-over until it suits.
constexpr int max_passes = 400, max_tries = 8;
/// Step-overs are no smaller, in radii of the cutter.
constexpr double smallest_step = 0.01;
/// The step-over suits this share of the places along a pass; elsewhere passes are put in, halving so often.
constexpr double usual_share = 0.85;
constexpr int max_fills = 4;
/// Such a pass goes on over up to so many radii of the curve between two places that ask for it.
constexpr double bridge_radii = 4;
/// Where a place between two comes no nearer to one of them than this share of the way, the cutter jumps:
/// from a flank to another, or over a rim. Places between say no more there, and what stays is touched up.
constexpr double jump_share = 0.75;
/// The step-over that is tried next is a little less than a ridge of the allowed height has, and changes by
/// no more than these factors at once.
constexpr double retry_share = 0.93, next_share = 0.95, max_shrink = 0.3, max_growth = 1.8;
/// What a band needs at a point is the most that it needs at so many points to either side.
constexpr std::ptrdiff_t smoothing_points = 2;

/// How far from a centre: across the fitted vector, and up the flank. On a steep one the first says little.
struct Extent {
    double across = 0, flank = 0;
    bool holds(const Extent& other) const { return across >= other.across && flank >= other.flank; }
    void grow(const Extent& other) {
        across = std::max(across, other.across);
        flank = std::max(flank, other.flank);
    }
};

/// A pass: where the cutter stands beside each point of the curve.
struct Row {
    std::vector<double> offsets; ///< left positive
    std::vector<ValleySpot> spots;
    std::vector<double> left; ///< what stays between it and the row before; 0 where not both have a place
};

/// Says of each point of a curve whether something is to be done there.
using Marked = std::vector<char>;

/// Passes from rows, in machining order.
class RowPasses {
public:
    RowPasses(const StripCutting& with, const ValleyCurve& curve, const ValleySpots& spots)
        : with_(with), curve_(curve), spots_(spots), count_(curve.points.size()) {}

    /// The stretches of a row where the cutter has a place, with their ends. Every other number
    /// runs against the curve, unless all go one way. Length of what is wanted and has no place goes to
    /// `blocked`.
    void add(const Row& row, const Marked& wanted, int number, double offset, StripCut& cut) const {
        const bool backwards = !with_.one_way && number % 2 != 0;
        add_blocked(row, wanted, cut.blocked);
        bool whole = false;
        auto all = stretches(row, whole);
        if (backwards) std::reverse(all.begin(), all.end());
        for (auto& points : all) {
            if (points.size() < 2) continue;
            if (curve_.closed && whole) close(points);
            std::vector<ValleySpot> spots = with_ends(row, wanted, points);
            if (backwards) {
                std::reverse(points.begin(), points.end());
                std::reverse(spots.begin(), spots.end());
            }
            Pass pass;
            pass.drive = number;
            pass.offset = offset;
            for (const ValleySpot& s : spots) {
                pass.cl.push_back({s.tip, Vec3::UnitZ()});
                pass.cc.push_back({s.touch, s.normal});
            }
            cut.passes.push_back(std::move(pass));
        }
    }

    double spacing(std::size_t i, std::size_t k) const {
        return (curve_.points[k].center - curve_.points[i].center).norm();
    }

private:
    using Points = std::vector<std::size_t>;

    void add_blocked(const Row& row, const Marked& wanted, double& length) const {
        for (std::size_t i = 0; i + 1 < count_; ++i)
            if (!row.spots[i].free && wanted[i] && curve_.points[i].on_part) length += spacing(i, i + 1);
    }

    /// Neighbouring points where the cutter has a place. A closed row begins where one is missing, if any is.
    std::vector<Points> stretches(const Row& row, bool& whole) const {
        const auto missing =
            std::find_if(row.spots.begin(), row.spots.end(), [](const ValleySpot& s) { return !s.free; });
        whole = missing == row.spots.end();
        const std::size_t start = curve_.closed && !whole ? std::size_t(missing - row.spots.begin()) : 0;
        std::vector<Points> all;
        Points run;
        for (std::size_t k = 0; k < count_; ++k) {
            const std::size_t i = (start + k) % count_;
            if (row.spots[i].free) run.push_back(i);
            if (!run.empty() && (!row.spots[i].free || k + 1 == count_)) {
                all.push_back(run);
                run.clear();
            }
        }
        return all;
    }

    /// Once around, and the overlap.
    void close(Points& points) const {
        double length = 0;
        const std::size_t n = points.size();
        for (std::size_t k = 0; k < n && (k == 0 || length < with_.overlap); ++k) {
            points.push_back(points[k]);
            length += spacing(points[k], points[(k + 1) % n]);
        }
    }

    /// The point after a place, along the curve or against it; count_ where there is none.
    std::size_t next(std::size_t i, bool ahead) const {
        if (ahead) return i + 1 < count_ ? i + 1 : curve_.closed ? 0 : count_;
        return i > 0 ? i - 1 : curve_.closed ? count_ - 1 : count_;
    }

    /// The places of a stretch, with the last ones towards points where there is none.
    std::vector<ValleySpot> with_ends(const Row& row, const Marked& wanted, const Points& points) const {
        std::vector<ValleySpot> result;
        for (const std::size_t i : points)
            result.push_back(row.spots[i]);
        for (const bool ahead : {true, false}) {
            const std::size_t end = ahead ? points.back() : points.front(), k = next(end, ahead);
            if (k == count_ || !wanted[k] || row.spots[k].free) continue;
            if (const auto last = spots_.last_before(end, k, row.offsets[end]))
                result.insert(ahead ? result.end() : result.begin(), *last);
        }
        return result;
    }

    const StripCutting& with_;
    const ValleyCurve& curve_;
    const ValleySpots& spots_;
    std::size_t count_;
};

/// The pass along a valley and those beside it.
class ValleyCutter {
public:
    ValleyCutter(const StripCutting& with, const ValleyCurve& curve, const RestBand& band,
                 const Progress& progress)
        : with_(with), curve_(curve), band_(band), radius_(with.cover->radius()), count_(curve.points.size()),
          spots_(with, curve, band, progress), between_(with), passes_(with, curve, spots_) {}

    StripCut run(const Progress& progress) {
        const Marked all(count_, 1);
        Row pencil{std::vector<double>(count_, 0), {}, {}};
        pencil.spots = spots(pencil.offsets, all, progress);
        passes_.add(pencil, all, 0, 0, cut_);
        for (const int side : {1, -1})
            beside(side, pencil, progress.part(side > 0 ? 0.25 : 0.625, side > 0 ? 0.625 : 1));
        return std::move(cut_);
    }

private:
    std::vector<ValleySpot> spots(const std::vector<double>& offsets, const Marked& which,
                                  const Progress& progress) const {
        std::vector<ValleySpot> result(count_);
        parallel_for(count_, 16, progress.part(0, 0), [&](std::size_t i) {
            if (which[i]) result[i] = spots_.spot(i, offsets[i]);
        });
        return result;
    }

    /// Where the cutter has no place so far out, it goes as far as it can, from what it cut before: which
    /// have been moved so.
    Marked come_nearer(const Row& last, Row& next, const Marked& which, const Progress& progress) const {
        Marked moved(count_, 0);
        parallel_for(count_, 16, progress.part(0, 0), [&](std::size_t i) {
            if (!which[i] || next.spots[i].free) return;
            const auto spot = spots_.farthest(i, last.offsets[i], next.offsets[i]);
            if (!spot) return;
            next.spots[i] = *spot;
            moved[i] = 1;
        });
        return moved;
    }

    /// Where the band ends, a little smoothed, and the overlap beyond.
    std::vector<Extent> needed(int side) const {
        std::vector<Extent> result(count_);
        const auto n = std::ptrdiff_t(count_);
        const std::size_t of = side > 0 ? 0 : 1;
        for (std::ptrdiff_t i = 0; i < n; ++i)
            for (std::ptrdiff_t k = i - smoothing_points; k <= i + smoothing_points; ++k) {
                if (!curve_.closed && (k < 0 || k >= n)) continue;
                const auto j = std::size_t(((k % n) + n) % n);
                result[std::size_t(i)].grow({band_.reach[j][of], band_.flank[j][of]});
            }
        for (Extent& e : result)
            if (e.flank > 0) e.flank += with_.overlap;
        return result;
    }
    Extent extent(std::size_t i, const Vec3& p, int side) const {
        const Vec3 rel = p - curve_.points[i].center;
        const Vec3& along = spots_.along(i);
        return {side * rel.dot(left_of(along, curve_.points[i].up)), (rel - rel.dot(along) * along).norm()};
    }

    /// Passes to one side, until what the band needs is reached at every point.
    void beside(int side, const Row& pencil, const Progress& progress) {
        const std::vector<Extent> need = needed(side);
        std::vector<Extent> got(count_);
        Marked done(count_, 0);
        Row last = pencil;
        // On a flank that leans by 45 degrees.
        double step = std::sqrt(4 * std::max(with_.cover->profile().cutter().r, 0.1 * radius_) * with_.cusp);
        double offset = 0;
        for (int number = 1; number <= max_passes; ++number) {
            Marked todo(count_, 0);
            for (std::size_t i = 0; i < count_; ++i)
                todo[i] = last.spots[i].free && !done[i] && !got[i].holds(need[i]);
            if (std::none_of(todo.begin(), todo.end(), [](char t) { return t != 0; })) break;
            progress.set(std::min(1.0, number / 50.0));
            Row next;
            const double cusp = next_row(last, todo, side, offset, step, next, progress);
            const Marked at_end = come_nearer(last, next, todo, progress);
            left_between(last, next, at_end, next.left, progress);
            fill(last, next, next.left, max_fills, progress);
            offset += step;
            for (std::size_t i = 0; i < count_; ++i) {
                if (!todo[i]) continue;
                // Over the shoulder: nothing more of this flank is touched farther out.
                done[i] = !next.spots[i].free || at_end[i] || offset > need[i].across + radius_;
                if (next.spots[i].free) got[i].grow(extent(i, next.spots[i].touch, side));
            }
            cut_.cusp_max = std::max(cut_.cusp_max, cusp);
            cut_.stepover_min = std::min(cut_.stepover_min, step);
            cut_.stepover_max = std::max(cut_.stepover_max, step);
            add_extended(next, todo, side * offset, progress);
            last = std::move(next);
            if (cusp > 0 && cusp < with_.cusp)
                step *= std::min(max_growth, next_share * std::sqrt(with_.cusp / cusp));
        }
    }

    /// The row a step farther out than `last`, at `offset`. The step becomes smaller until most places keep
    /// no more than the cusp; further passes are put in at the others. Returns what most places keep.
    double next_row(const Row& last, const Marked& todo, int side, double offset, double& step, Row& next,
                    const Progress& progress) const {
        double cusp = 0;
        step = std::max(step, smallest_step * radius_);
        for (int tries = 0; tries < max_tries; ++tries) {
            next.offsets.assign(count_, side * (offset + step));
            next.spots = spots(next.offsets, todo, progress);
            next.left.assign(count_, 0);
            left_between(last, next, todo, next.left, progress);
            std::vector<double> all = next.left;
            std::erase(all, 0);
            std::sort(all.begin(), all.end());
            cusp = all.empty() ? 0 : all[std::size_t(usual_share * double(all.size() - 1))];
            if (cusp <= with_.cusp || step <= smallest_step * radius_) break;
            step = std::max(step * std::max(max_shrink, retry_share * std::sqrt(with_.cusp / cusp)),
                            smallest_step * radius_);
        }
        return cusp;
    }

    /// A row's passes, going on for the overlap before and after.
    void add_extended(const Row& row, const Marked& which, double offset, const Progress& progress) {
        Marked longer = extended(which);
        for (std::size_t i = 0; i < count_; ++i)
            longer[i] = longer[i] && !which[i];
        const std::vector<ValleySpot> more = spots(row.offsets, longer, progress);
        Row pass = row;
        for (std::size_t i = 0; i < count_; ++i)
            if (longer[i]) pass.spots[i] = more[i];
        add(pass, which, offset);
    }

    void add(const Row& row, const Marked& which, double offset) {
        const std::size_t first = cut_.passes.size();
        passes_.add(row, which, ++number_, offset, cut_);
        for (std::size_t i = first; i < cut_.passes.size(); ++i)
            points_ += cut_.passes[i].cl.size();
        if (points_ <= with_.max_points) return;
        const Vec3& at = curve_.points.front().center;
        const auto text = [](double x) { return format_number(x, 6); };
        throw Error(ErrorCode::limit_exceeded, "valley",
                    "the one that begins at (" + text(at.x()) + ", " + text(at.y()) + ", " + text(at.z())
                        + ") mm would take more than " + std::to_string(with_.max_points)
                        + " points of passes",
                    "allow a larger tolerance, or use a tool with a larger corner radius");
    }

    /// What stays between two rows where that is asked and both have a place.
    void left_between(const Row& a, const Row& b, const Marked& which, std::vector<double>& left,
                      const Progress& progress) const {
        parallel_for(count_, 16, progress.part(0, 0), [&](std::size_t i) {
            if (which[i] && a.spots[i].free && b.spots[i].free)
                left[i] = between_.left(a.spots[i], b.spots[i], spots_.along(i));
        });
    }

    /// Short passes between two where too much stays, given what does.
    void fill(const Row& a, const Row& b, const std::vector<double>& left, int depth,
              const Progress& progress) {
        Marked which(count_, 0);
        bool any = false;
        for (std::size_t i = 0; i < count_; ++i)
            if (left[i] > with_.cusp) {
                any = true;
                for (const std::size_t k : {i > 0 ? i - 1 : i, i, i + 1 < count_ ? i + 1 : i})
                    which[k] = 1;
            }
        progress.check();
        if (!any) return;
        bridge(which);
        Row middle{a.offsets, {}, std::vector<double>(count_, 0)};
        for (std::size_t i = 0; i < count_; ++i)
            middle.offsets[i] = 0.5 * (a.offsets[i] + b.offsets[i]);
        middle.spots = spots(middle.offsets, which, progress);
        const auto halves = [&](std::size_t i) {
            const ValleySpot &m = middle.spots[i], &from = a.spots[i], &to = b.spots[i];
            return left[i] > with_.cusp && m.free
                   && std::max((m.tip - from.tip).norm(), (to.tip - m.tip).norm())
                          < jump_share * (to.tip - from.tip).norm();
        };
        bool halved = false;
        for (std::size_t i = 0; i < count_ && !halved; ++i)
            halved = halves(i);
        if (!halved) return;
        const auto fill_half = [&](const Row& from, const Row& to) {
            if (depth == 1) return;
            std::fill(middle.left.begin(), middle.left.end(), 0);
            left_between(from, to, which, middle.left, progress);
            fill(from, to, middle.left, depth - 1, progress);
        };
        fill_half(a, middle);
        const auto first = std::size_t(std::find(which.begin(), which.end(), 1) - which.begin());
        add(middle, which, middle.offsets[first]);
        fill_half(middle, b);
    }

    /// Cutting nothing over a short stretch takes less time than going out, over and in again.
    void bridge(Marked& which) const {
        std::size_t last = count_;
        double length = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            if (i > 0) length += passes_.spacing(i - 1, i);
            if (!which[i]) continue;
            if (last < count_ && length <= bridge_radii * radius_)
                std::fill(which.begin() + std::ptrdiff_t(last), which.begin() + std::ptrdiff_t(i), 1);
            last = i;
            length = 0;
        }
    }

    /// With the overlap before and after.
    Marked extended(const Marked& which) const {
        Marked result = which;
        const auto n = std::ptrdiff_t(count_);
        for (std::ptrdiff_t i = 0; i < n; ++i) {
            if (!which[std::size_t(i)]) continue;
            for (const std::ptrdiff_t step : {-1, 1}) {
                double length = 0;
                std::ptrdiff_t k = i;
                while (length < with_.overlap) {
                    std::ptrdiff_t next = k + step;
                    if (curve_.closed) next = (next + n) % n;
                    if (next < 0 || next >= n || which[std::size_t(next)] || next == i) break;
                    length += passes_.spacing(std::size_t(k), std::size_t(next));
                    k = next;
                    result[std::size_t(k)] = 1;
                }
            }
        }
        return result;
    }

    const StripCutting& with_;
    const ValleyCurve& curve_;
    const RestBand& band_;
    double radius_;
    std::size_t count_;
    ValleySpots spots_;
    BetweenPasses between_;
    RowPasses passes_;
    StripCut cut_;
    std::size_t points_ = 0; ///< of its passes
    int number_ = 0;         ///< counts passes, for turning every other one
};

/// The curve goes on beyond its ends, where it meets no other: as far as the cutter overlaps, and past a
/// border until what is beside the valley is cut too.
void run_out(const StripCutting& with, ValleyCurve& curve, RestBand& band) {
    auto& p = curve.points;
    if (curve.closed || p.size() < 3) return;
    constexpr double max_run_out_points = 1000;
    const double length = with.overlap + with.cover->radius();
    for (const std::size_t side : {0, 1}) {
        if (curve.node[side] >= 0) continue;
        const PencilPoint end = side == 0 ? p.front() : p.back();
        // Points that lie in one place say nothing about where it goes on.
        const double min_step = length / max_run_out_points;
        std::size_t back = 2;
        const auto before = [&] { return side == 0 ? p[back].center : p[p.size() - 1 - back].center; };
        while (back + 1 < p.size() && !(0.5 * (end.center - before()).norm() >= min_step))
            ++back;
        const double step = 0.5 * (end.center - before()).norm();
        if (!(step >= min_step)) continue;
        const Vec3 ahead = (end.center - before()).normalized();
        const auto reach = side == 0 ? band.reach.front() : band.reach.back();
        const auto flank = side == 0 ? band.flank.front() : band.flank.back();
        for (int k = 1; k * step <= length + step; ++k) {
            PencilPoint q = end;
            q.on_part = false;
            for (Vec3* v : {&q.tip, &q.touch[0], &q.touch[1], &q.from, &q.center})
                *v += k * step * ahead;
            p.insert(side == 0 ? p.begin() : p.end(), q);
            band.reach.insert(side == 0 ? band.reach.begin() : band.reach.end(), reach);
            band.flank.insert(side == 0 ? band.flank.begin() : band.flank.end(), flank);
        }
    }
}

} // namespace

ValleyInput reach_of(const StripCutting& with) {
    ValleyInput in;
    in.mesh = with.mesh.get();
    in.grid = with.grid;
    in.side = with.side;
    in.lift = with.lift;
    in.cover = with.cover;
    in.tips = with.tips;
    in.tolerance = with.cusp;
    return in;
}

StripCut cut_valley(const StripCutting& with, const ValleyCurve& curve, const RestBand& band,
                    const Progress& progress) {
    ValleyCurve longer = curve;
    // What passes are planned by: the band itself is large.
    RestBand wider;
    wider.band = band.band;
    wider.reach = band.reach;
    wider.flank = band.flank;
    run_out(with, longer, wider);
    StripCut cut;
    if (longer.points.size() > 1)
        cut = ValleyCutter(with, longer, wider, progress.part(0, 0.16)).run(progress.part(0.16, 0.8));
    clear_passes(with, cut.passes, progress.part(0.8, 1));
    return cut;
}

} // namespace facetmill
