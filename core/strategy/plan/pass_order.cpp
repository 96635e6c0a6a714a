#include "core/strategy/plan/pass_order.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Moves of runs of passes to another place in the order are tried until none helps, or so often.
constexpr int max_rounds = 8;
constexpr std::size_t longest_run = 24;
/// Beyond so many passes that, or any order, would take longer than it saves.
constexpr std::size_t max_moved = 3000, max_ordered = 20'000;
constexpr double min_gain = 1e-6; // mm

/// One pass, perhaps turned round.
struct Piece {
    std::size_t pass = 0;
    bool turned = false;
    Vec3 start, end;
};

class Order {
public:
    Order(const std::vector<Pass>& passes, bool either_way, double clear_z, const Progress& progress)
        : either_way_(either_way), clear_z_(clear_z), progress_(progress) {
        for (std::size_t i = 0; i < passes.size(); ++i)
            if (!passes[i].cl.empty())
                planned_.push_back({i, false, passes[i].cl.front().tip, passes[i].cl.back().tip});
    }

    std::vector<Piece> run() {
        if (planned_.size() > max_ordered) return planned_;
        std::vector<Piece> order = nearest();
        if (planned_.size() > max_moved) return length(order) < length(planned_) ? order : planned_;
        for (int round = 0; round < max_rounds && moved(order); ++round) {
        }
        return length(order) < length(planned_) ? order : planned_;
    }

private:
    double travel(const Piece& a, const Piece& b) const { return travel_between(a.end, b.start, clear_z_); }

    double length(const std::vector<Piece>& order) const {
        double sum = 0;
        for (std::size_t i = 1; i < order.size(); ++i)
            sum += travel(order[i - 1], order[i]);
        return sum;
    }

    std::vector<Piece> nearest() const {
        std::vector<Piece> left = planned_, order;
        if (left.empty()) return order;
        order.push_back(left.front());
        left.erase(left.begin());
        while (!left.empty()) {
            progress_.check();
            std::size_t best = 0;
            bool turned = false;
            double least = infinity;
            for (std::size_t k = 0; k < left.size(); ++k) {
                Piece p = left[k];
                const auto look = [&](bool round) {
                    const double d = travel(order.back(), p);
                    if (!(d < least)) return;
                    least = d;
                    best = k;
                    turned = round;
                };
                look(false);
                if (!either_way_) continue;
                std::swap(p.start, p.end);
                look(true);
            }
            Piece next = left[best];
            if (turned) {
                std::swap(next.start, next.end);
                next.turned = true;
            }
            order.push_back(next);
            left.erase(left.begin() + long(best));
        }
        return order;
    }

    /// Takes runs of passes out and puts them where they add least; true where that was less. What the
    /// nearest-first order leaves behind is picked up on the way by.
    bool moved(std::vector<Piece>& order) const {
        bool any = false;
        for (std::size_t count = 1; count <= longest_run; count *= 2)
            for (std::size_t i = 1; i + count <= order.size(); ++i) {
                progress_.check();
                const Piece &before = order[i - 1], &first = order[i], &last = order[i + count - 1];
                const Piece* after = i + count < order.size() ? &order[i + count] : nullptr;
                const double gain =
                    travel(before, first) + (after ? travel(last, *after) - travel(before, *after) : 0);
                if (!(gain > min_gain)) continue;
                double best = gain - min_gain;
                std::size_t to = 0;
                for (std::size_t k = 0; k < order.size(); ++k) {
                    if (k + 1 >= i && k < i + count) continue;
                    const Piece* next = k + 1 < order.size() ? &order[k + 1] : nullptr;
                    const double cost =
                        travel(order[k], first) + (next ? travel(last, *next) - travel(order[k], *next) : 0);
                    if (!(cost < best)) continue;
                    best = cost;
                    to = k + 1;
                }
                if (to == 0) continue;
                const auto at = [&](std::size_t n) { return order.begin() + long(n); };
                if (to > i)
                    std::rotate(at(i), at(i + count), at(to));
                else
                    std::rotate(at(to), at(i), at(i + count));
                any = true;
            }
        return any;
    }

    bool either_way_;
    double clear_z_;
    const Progress& progress_;
    std::vector<Piece> planned_;
};

} // namespace

double travel_between(const Vec3& from, const Vec3& to, double clear_z) {
    return std::min((to - from).norm(), std::abs(clear_z - from.z()) + std::abs(clear_z - to.z()));
}

double surface_link_distance(double stepover, double cutter_diameter) {
    return std::max(4 * stepover, 0.5 * cutter_diameter);
}

void order_by_travel(std::vector<Pass>& passes, bool either_way, double clear_z, const Progress& progress) {
    if (passes.size() < 3) return;
    const std::vector<Piece> order = Order(passes, either_way, clear_z, progress).run();
    std::vector<Pass> ordered;
    ordered.reserve(order.size());
    for (const Piece& p : order) {
        ordered.push_back(std::move(passes[p.pass]));
        if (!p.turned) continue;
        std::reverse(ordered.back().cc.begin(), ordered.back().cc.end());
        std::reverse(ordered.back().cl.begin(), ordered.back().cl.end());
    }
    passes = std::move(ordered);
}

} // namespace facetmill
