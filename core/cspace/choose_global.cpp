// The cheapest path through all configuration spaces of a pass. What Lu calls too complex to implement is a
// shortest path: the free nodes of each point's grid, in either joint solution of the machine, are the stops;
// a move between two of neighbouring points costs the time it takes, feed or joints, whichever is longer.
// The path begins where the pass before ended and goes on into the next one, so that the tool ends as the
// next pass is best begun. Between nodes it is then refined: around every stop a smaller grid and the same
// search, with three steps, each as often as it makes the path faster.
//
// With accelerations a move costs besides what its joints take to come from the speeds of the move before it
// and to those of the move after it, as core/output/motion_time counts it. Those speeds are not known while
// the path is sought; they are taken from the round before, and a round that makes it no better is dropped.
#include "core/cspace/choose.h"
#include "core/cspace/posture_smoothing.h"
#include "core/cspace/posture_stop.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr int refinements = 3;
/// Rounds with each step at most: the path may lie farther than one step from the nodes it was found at.
constexpr int rounds_per_step = 5;
/// The part of its time by which a round has to make the path faster for another one with the same step.
constexpr double worth_a_round = 5e-4;
/// What being separated costs, s: about a retract, a rapid and an approach. So much that no smooth path is
/// given up for it.
constexpr double separation_seconds = 1000;
constexpr std::size_t points_per_block = 4;
/// The part by which a path may take longer for axes that run evenly.
constexpr double smooth_slack = 3e-3;

using Stop = PostureStop;

/// The stops of one point. On the whole grid they are in the order of its nodes: those of node n stand from
/// first[n] to first[n + 1]; elsewhere, between nodes and where a posture is kept, `first` is empty.
struct Stops {
    std::vector<Stop> all;
    std::vector<std::uint32_t> first;
    bool empty() const { return all.empty(); }
};

class Search {
public:
    Search(std::span<const PassPoint> points, const ChooseInput& input)
        : points_(points.begin(), points.end()), own_(points.size()), input_(input), builder_(*input.builder),
          stops_(input), clock_(stops_.clock()), cos_limit_(std::cos(input.turn_limit)) {
        points_.insert(points_.end(), input.next.begin(),
                       input.next.begin() + long(std::min(input.next.size(), choose_horizon)));
    }

    std::vector<ChosenPosture> run(const Progress& progress) {
        std::vector<Stops> stops(points_.size());
        parallel_for(points_.size(), points_per_block, progress.part(0, 0),
                     [&](std::size_t i) { stops[i] = nodes(i); });
        std::vector<ChosenPosture> chosen(points_.size());
        // Points without a free posture part the pass.
        for (std::size_t begin = 0; begin < own_;) {
            if (stops[begin].empty()) {
                ++begin;
                continue;
            }
            std::size_t end = begin;
            while (end < points_.size() && !stops[end].empty())
                ++end;
            refined(stops, begin, end, chosen, progress);
            begin = end;
        }
        chosen.resize(own_);
        return chosen;
    }

private:
    Stops nodes(std::size_t i) const {
        const PassPoint& point = points_[i];
        const PostureGrid& grid = *builder_.input().grid;
        Stops stops;
        if (point.kept) {
            stops_.add(point, *point.kept, 0, stops.all);
            return stops;
        }
        for (std::size_t l = 0; l < grid.lead.size(); ++l)
            for (std::size_t o = 0; o < grid.yaw.size(); ++o) {
                const std::size_t n = grid.node(l, o);
                stops.first.push_back(std::uint32_t(stops.all.size()));
                if (point.space->block[n] != PostureBlock::free) continue;
                stops_.add(point, {grid.lead[l], grid.yaw[o], point.space->bottom[n]}, point.space->top[n],
                           stops.all);
            }
        stops.first.push_back(std::uint32_t(stops.all.size()));
        if (stops.all.empty() && !point.between.empty()) {
            CSpaceBuilder::Hints hints;
            for (const PostureValue& p : point.between)
                stops_.add_free(point, p.lead, p.yaw, hints, stops.all);
            stops.first.clear();
        }
        return stops;
    }

    /// What it costs to come to a stop from where the pass before ended.
    double entry_cost(const Stop& stop) const {
        if (!input_.before) return 0;
        const double cost = clock_.to(*input_.before, stop.stand);
        return cost < infinity ? cost : 0;
    }

    /// The cheapest of the stops `from` before one, or none (false) within the turn limit.
    struct Link {
        double cost = infinity;
        std::uint32_t from = 0;
    };
    /// Joint speeds of the moves before and after one, in the round before; nullptr: there is none, or it
    /// does not matter.
    struct Neighbors {
        const JointClock::Times *before = nullptr, *after = nullptr;
    };
    double move_cost(const Stand& a, const Stand& b, const Neighbors& n) const {
        const double cost = clock_.between(a, b);
        if (!n.before && !n.after) return cost;
        const JointClock::Times v = clock_.speeds(a, b);
        return cost + (n.before ? clock_.changing(*n.before, v) : 0)
               + (n.after ? clock_.changing(v, *n.after) : 0);
    }

    void look(const std::vector<Stop>& before, const std::vector<double>& cost, std::uint32_t begin,
              std::uint32_t end, const Stop& to, double cos_limit, const Neighbors& n, Link& best) const {
        for (std::uint32_t j = begin; j < end; ++j) {
            if (cost[j] >= best.cost) continue;
            const Stand& s = before[j].stand;
            const double total = cost[j] + move_cost(s, to.stand, n);
            if (total < best.cost && s.pose.axis.dot(to.stand.pose.axis) >= cos_limit) best = {total, j};
        }
    }

    static constexpr std::size_t no_node = std::size_t(-1);
    /// From nodes near its own; should none of them serve, where one of the two is no node, or between
    /// passes, from all.
    Link cheapest_link(const Stops& before, const std::vector<double>& cost, const Stop& to, std::size_t node,
                       double cos_limit, const Neighbors& n) const {
        Link best;
        const auto& all = before.all;
        if (!before.first.empty() && node != no_node && cos_limit > -1) {
            // Its own node's first: most others are then too dear already.
            look(all, cost, before.first[node], before.first[node + 1], to, cos_limit, n, best);
            const PostureGrid& grid = *builder_.input().grid;
            const std::size_t width = grid.yaw.size(), l = node / width, o = node % width;
            const std::size_t l_end = std::min(l + window + 1, grid.lead.size()),
                              o_end = std::min(o + window + 1, width);
            for (std::size_t i = l - std::min(l, window); i < l_end; ++i) {
                const std::size_t row = grid.node(i, 0);
                look(all, cost, before.first[row + o - std::min(o, window)], before.first[row + o_end], to,
                     cos_limit, n, best);
            }
        }
        if (best.cost == infinity) look(all, cost, 0, std::uint32_t(all.size()), to, cos_limit, n, best);
        return best;
    }

    /// Indices of the cheapest stops of points begin..end - 1. `speeds`: those of the moves to them in the
    /// round before, or none.
    std::vector<std::size_t> cheapest(const std::vector<Stops>& stops, std::size_t begin, std::size_t end,
                                      const std::vector<JointClock::Times>& speeds,
                                      const Progress& progress) const {
        std::vector<std::vector<std::uint32_t>> from(end - begin);
        std::vector<double> cost, next;
        for (const Stop& s : stops[begin].all)
            cost.push_back(s.own_cost + (begin == 0 ? entry_cost(s) : 0));
        for (std::size_t i = begin + 1; i < end; ++i) {
            progress.check();
            const Stops &before = stops[i - 1], &here = stops[i];
            const auto least = std::min_element(cost.begin(), cost.end());
            const Link separated{*least + separation_seconds, std::uint32_t(least - cost.begin())};
            next.assign(here.all.size(), infinity);
            from[i - begin].assign(here.all.size(), 0);
            // Between passes the axis may turn as far as it likes.
            const double cos_limit = i == own_ ? -2 : cos_limit_;
            Neighbors neighbors;
            if (!speeds.empty()) {
                if (i - begin >= 2) neighbors.before = &speeds[i - begin - 1];
                if (i + 1 < end) neighbors.after = &speeds[i - begin + 1];
            }
            const auto link = [&](std::size_t k, std::size_t node) {
                Link best = cheapest_link(before, cost, here.all[k], node, cos_limit, neighbors);
                if (best.cost > separated.cost) best = separated;
                next[k] = best.cost + here.all[k].own_cost;
                from[i - begin][k] = best.from;
            };
            if (here.first.empty()) {
                for (std::size_t k = 0; k < here.all.size(); ++k)
                    link(k, no_node);
            } else {
                parallel_for(here.first.size() - 1, nodes_per_block, Progress(), [&](std::size_t n) {
                    for (std::uint32_t k = here.first[n]; k < here.first[n + 1]; ++k)
                        link(k, n);
                });
            }
            cost.swap(next);
        }
        std::vector<std::size_t> path(end - begin);
        path.back() = std::size_t(std::min_element(cost.begin(), cost.end()) - cost.begin());
        for (std::size_t i = path.size() - 1; i > 0; --i)
            path[i - 1] = from[i][path[i]];
        return path;
    }

    /// Stops around one: a grid of 3 by 3 with the given step, those of it that are free. `known`: stops of
    /// the point that were found before, all of a posture's.
    Stops around(std::size_t i, const PostureValue& middle, double step,
                 const std::vector<Stop>& known) const {
        const PassPoint& point = points_[i];
        const PostureGrid& grid = *builder_.input().grid;
        CSpaceBuilder::Hints hints;
        Stops stops;
        if (point.kept) {
            stops_.add(point, *point.kept, 0, stops.all);
            return stops;
        }
        for (const int l : {0, -1, 1})
            for (const int o : {0, -1, 1}) {
                const double lead = std::clamp(middle.lead + l * step, grid.lead.front(), grid.lead.back());
                const double yaw = std::clamp(middle.yaw + o * step, grid.yaw.front(), grid.yaw.back());
                if ((l != 0 && lead == middle.lead) || (o != 0 && yaw == middle.yaw)) continue;
                const std::size_t before = stops.all.size();
                for (const Stop& s : known)
                    if (s.posture.lead == lead && s.posture.yaw == yaw) stops.all.push_back(s);
                if (stops.all.size() == before) stops_.add_free(point, lead, yaw, hints, stops.all);
            }
        return stops;
    }

    static std::vector<Stop> taken(const std::vector<Stops>& stops, std::size_t begin,
                                   const std::vector<std::size_t>& path) {
        std::vector<Stop> all;
        for (std::size_t k = 0; k < path.size(); ++k)
            all.push_back(stops[begin + k].all[path[k]]);
        return all;
    }

    /// Joint speeds of the move to each stop; the first has none.
    std::vector<JointClock::Times> speeds_of(const std::vector<Stop>& path) const {
        std::vector<JointClock::Times> speeds(path.size());
        for (std::size_t k = 1; k < path.size(); ++k)
            speeds[k] = clock_.speeds(path[k - 1].stand, path[k].stand);
        return speeds;
    }

    double seconds_of(const std::vector<Stop>& path) const {
        const std::vector<JointClock::Times> speeds = speeds_of(path);
        double sum = 0;
        for (std::size_t k = 1; k < path.size(); ++k) {
            sum += clock_.between(path[k - 1].stand, path[k].stand);
            if (k > 1) sum += clock_.changing(speeds[k - 1], speeds[k]);
        }
        return sum;
    }

    void refined(const std::vector<Stops>& stops, std::size_t begin, std::size_t end,
                 std::vector<ChosenPosture>& chosen, const Progress& progress) const {
        std::vector<Stop> path = taken(stops, begin, cheapest(stops, begin, end, {}, progress));
        const PostureGrid& grid = *builder_.input().grid;
        double step = grid.lead.size() > 1  ? grid.lead[1] - grid.lead[0]
                      : grid.yaw.size() > 1 ? grid.yaw[1] - grid.yaw[0]
                                            : 0;
        double seconds = seconds_of(path);
        std::vector<Stops> finer(stops.size());
        std::vector<char> found(stops.size(), 0);
        for (int refinement = 0; refinement < refinements && step > 0; ++refinement) {
            step *= 0.5;
            std::vector<PostureValue> middles(end - begin);
            for (int round = 0; round < rounds_per_step; ++round) {
                parallel_for(end - begin, points_per_block, progress.part(0, 0), [&](std::size_t k) {
                    Stops& here = finer[begin + k];
                    const PostureValue& middle = path[k].posture;
                    // Where the round before led nowhere else its stops serve again.
                    if (round > 0 && middle.lead == middles[k].lead && middle.yaw == middles[k].yaw) return;
                    middles[k] = middle;
                    static const std::vector<Stop> none;
                    here = around(begin + k, middle, step, found[begin + k] ? here.all : none);
                    // The middle is free by construction; should rounding say otherwise it is kept as it was.
                    found[begin + k] = !here.empty();
                    if (here.empty()) here.all.push_back(path[k]);
                });
                std::vector<JointClock::Times> speeds;
                if (input_.accelerations) speeds = speeds_of(path);
                std::vector<Stop> better = taken(finer, begin, cheapest(finer, begin, end, speeds, progress));
                const double now = seconds_of(better);
                if (!input_.accelerations || now < seconds) path = std::move(better);
                if (!(now < seconds * (1 - worth_a_round))) break;
                seconds = now;
            }
            seconds = seconds_of(path);
        }
        std::vector<Stop> even = path;
        const std::size_t free = std::min(end, std::max(own_, begin)) - begin;
        smooth_postures(stops_, std::span(points_).subspan(begin, end - begin), free, even, progress);
        if (seconds_of(even) <= (1 + smooth_slack) * seconds) path = std::move(even);
        for (std::size_t i = begin; i < end; ++i)
            chosen[i] = {true, path[i - begin].posture};
    }

    static constexpr std::size_t nodes_per_block = 64;
    /// Nodes on either side from which moves are looked for first. Between neighbouring points of a pass axes
    /// turn by a degree or so; a grid step is three.
    static constexpr std::size_t window = 2;

    std::vector<PassPoint> points_; ///< the pass's, then the next one's
    std::size_t own_;               ///< how many are the pass's
    const ChooseInput& input_;
    const CSpaceBuilder& builder_;
    PostureStops stops_;
    const MoveClock& clock_;
    double cos_limit_;
};

} // namespace

std::vector<ChosenPosture> choose_global(std::span<const PassPoint> points, const ChooseInput& input,
                                         const Progress& progress) {
    return Search(points, input).run(progress);
}

} // namespace facetmill
