#include "core/cspace/posture_smoothing.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

constexpr std::size_t stops_per_block = 4;
/// Times that the stretches of all lengths are pulled: those that were held by a neighbour come free.
constexpr int taut_rounds = 2;
/// Rounds of drawing stops between their neighbours.
constexpr int draw_rounds = 8;
/// The part of its bends by which a stretch or a stop has to fall.
constexpr double worth_it = 0.01;
/// The part by which the moves concerned may take longer.
constexpr double slack = 3e-3;

class Smoother {
public:
    Smoother(const PostureStops& stops, std::span<const PassPoint> points, std::size_t own,
             std::vector<PostureStop>& path, const Progress& progress)
        : stops_(stops), clock_(stops.clock()), points_(points), own_(std::min(own, path.size())),
          path_(path), progress_(progress), cos_limit_(std::cos(stops.input().turn_limit)) {}

    void run() {
        if (path_.size() < 3) return;
        for (int round = 0; round < taut_rounds; ++round)
            pull_taut();
        for (int round = 0; round < draw_rounds; ++round)
            for (std::size_t color = 0; color < 3;
                 ++color) // Stops that are three apart do not see each other.
                parallel_for((path_.size() + 2) / 3, stops_per_block, progress_.part(0, 0),
                             [&](std::size_t n) {
                                 const std::size_t k = 3 * n + color;
                                 if (k == 0 || k + 1 >= path_.size() || !free(k)) return;
                                 for (const double share : {1.0, 0.5})
                                     if (draw(k, share)) return;
                             });
    }

private:
    bool free(std::size_t k) const { return k < own_ && !points_[k].kept; }

    /// Stretches of every length, from the whole path down to two moves, each half-way over the one before.
    void pull_taut() {
        std::size_t length = 2;
        while (length < path_.size() - 1)
            length *= 2;
        for (; length >= 2; length /= 2)
            // Those that begin where others end do not see each other but for the bends at their ends, and
            // are left out in turn.
            for (std::size_t color = 0; color < 4; ++color)
                parallel_for(path_.size() / (2 * length) + 1, 1, progress_.part(0, 0), [&](std::size_t n) {
                    const std::size_t begin = 2 * n * length + color * (length / 2);
                    const std::size_t end = std::min({begin + length, own_, path_.size() - 1});
                    if (begin + 2 <= end) straighten(begin, end);
                });
    }

    const PostureStop& at(const std::vector<PostureStop>& stretch, std::size_t begin, std::size_t k) const {
        return k > begin && k - begin <= stretch.size() ? stretch[k - begin - 1] : path_[k];
    }
    /// The seconds of the moves of a stretch, and how the rotary axes bend on it and at its ends, with other
    /// stops between these.
    std::array<double, 2> cost(std::size_t begin, std::size_t end,
                               const std::vector<PostureStop>& between) const {
        std::array<double, 2> sum{0, 0};
        for (std::size_t k = begin; k < end; ++k)
            sum[0] += clock_.seconds(at(between, begin, k).stand, at(between, begin, k + 1).stand);
        const std::size_t last = std::min(end + 1, path_.size() - 1);
        for (std::size_t k = std::max<std::size_t>(begin, 1); k < last; ++k)
            sum[1] += clock_.bend(at(between, begin, k - 1).stand, at(between, begin, k).stand,
                                  at(between, begin, k + 1).stand);
        return sum;
    }

    /// Lets the rotary axes run evenly from one stop to another where all postures between are free.
    void straighten(std::size_t begin, std::size_t end) {
        const Stand &from = path_[begin].stand, &to = path_[end].stand;
        std::vector<double> when(end - begin + 1, 0);
        for (std::size_t k = begin; k < end; ++k) {
            if ((k > begin && !free(k))
                || path_[k].stand.pose.axis.dot(path_[k + 1].stand.pose.axis) < cos_limit_)
                return;
            when[k + 1 - begin] = when[k - begin] + clock_.seconds(path_[k].stand, path_[k + 1].stand);
        }
        if (!(when.back() > 0)) return;
        const std::array<double, 2> now = cost(begin, end, {});
        // At its best nothing bends but the ends.
        if (!(now[1] > 0)) return;
        std::vector<PostureStop> taut;
        taut.reserve(end - begin - 1);
        CSpaceBuilder::Hints hints;
        for (std::size_t k = begin + 1; k < end; ++k) {
            const double share = when[k - begin] / when.back();
            const auto stop = held(k, clock_.axis_between(from.joints, to.joints, share), hints);
            if (!stop) return;
            taut.push_back(*stop);
        }
        const std::array<double, 2> then = cost(begin, end, taut);
        if (then[0] > now[0] * (1 + slack) || then[1] > now[1] * (1 - worth_it)) return;
        std::copy(taut.begin(), taut.end(), path_.begin() + std::ptrdiff_t(begin) + 1);
    }

    /// The stop at a point with this tool axis whose joints stand nearest to those it has, if it is free and
    /// no more crowded.
    std::optional<PostureStop> held(std::size_t k, const Vec3& axis, CSpaceBuilder::Hints& hints) const {
        const PassPoint& point = points_[k];
        const PostureValue wanted = posture_of_axis(point.frame, axis);
        const PostureGrid& grid = *stops_.input().builder->input().grid;
        const double lead = std::clamp(wanted.lead, grid.lead.front(), grid.lead.back());
        const double yaw = std::clamp(wanted.yaw, grid.yaw.front(), grid.yaw.back());
        std::vector<PostureStop> stops;
        stops_.add_free(point, lead, yaw, hints, stops);
        std::optional<PostureStop> best;
        double nearest = infinity;
        for (const PostureStop& stop : stops) {
            if (stop.own_cost > path_[k].own_cost + lift_seconds) continue;
            const double seconds = clock_.between(stop.stand.joints, path_[k].stand.joints);
            if (seconds >= nearest) continue;
            nearest = seconds;
            best = stop;
        }
        return best;
    }

    /// Draws a stop towards the axis that lies between its neighbours' by a share of the way.
    bool draw(std::size_t k, double share) {
        const ToolPose &a = path_[k - 1].stand.pose, &b = path_[k + 1].stand.pose, &own = path_[k].stand.pose;
        const double before = (own.tip - a.tip).norm(), after = (b.tip - own.tip).norm();
        const double t = before + after > 0 ? before / (before + after) : 0.5;
        const Vec3 between = (a.axis + t * (b.axis - a.axis)).normalized();
        CSpaceBuilder::Hints hints;
        const auto stop = held(k, (own.axis + share * (between - own.axis)).normalized(), hints);
        if (!stop) return false;
        const Vec3& axis = stop->stand.pose.axis;
        if (std::min(axis.dot(a.axis), axis.dot(b.axis)) < cos_limit_) return false;
        const std::array<double, 2> now = cost(k - 1, k + 1, {}), then = cost(k - 1, k + 1, {*stop});
        if (then[0] > now[0] * (1 + slack) || then[1] > now[1] * (1 - worth_it)) return false;
        path_[k] = *stop;
        return true;
    }

    const PostureStops& stops_;
    const MoveClock& clock_;
    std::span<const PassPoint> points_;
    std::size_t own_;
    std::vector<PostureStop>& path_;
    const Progress& progress_;
    double cos_limit_;
};

} // namespace

void smooth_postures(const PostureStops& stops, std::span<const PassPoint> points, std::size_t own,
                     std::vector<PostureStop>& path, const Progress& progress) {
    Smoother(stops, points, own, path, progress).run();
}

} // namespace facetmill
