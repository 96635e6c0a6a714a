#include "core/strategy/waterline/level_order.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace facetmill {

namespace {

/// A pass's beginning, of those it may have.
struct Begin {
    std::uint32_t pass, point;
    bool back; ///< cut from its end
};

class Order {
public:
    Order(std::vector<Pass>& passes, double near, bool either_way, const Progress& progress)
        : passes_(passes), near_(near), progress_(progress), done_(passes.size(), false) {
        for (std::size_t i = 0; i < passes.size(); ++i) {
            const Pass& pass = passes[i];
            const auto number = std::uint32_t(i);
            heights_.push_back(pass.cl.front().tip.z());
            if (!is_closed(pass)) {
                add({number, 0, false});
                if (either_way) add({number, std::uint32_t(pass.cl.size() - 1), true});
            } else {
                for (std::size_t k = 0; k + 1 < pass.cl.size(); ++k)
                    add({number, std::uint32_t(k), false});
            }
        }
        sorted_.resize(passes.size());
        for (std::size_t i = 0; i < sorted_.size(); ++i)
            sorted_[i] = i;
        std::stable_sort(sorted_.begin(), sorted_.end(),
                         [&](std::size_t a, std::size_t b) { return height(a) > height(b); });
    }

    std::vector<Pass> run() {
        std::vector<Pass> ordered;
        ordered.reserve(passes_.size());
        std::optional<Vec3> at;
        std::size_t highest = 0;
        while (ordered.size() < passes_.size()) {
            progress_.check();
            progress_.set(double(ordered.size()) / double(passes_.size()));
            std::optional<Begin> next;
            if (at) next = below(*at);
            if (!next) {
                while (done_[sorted_[highest]])
                    ++highest;
                next = at ? nearest_on_level(highest, *at) : Begin{std::uint32_t(sorted_[highest]), 0, false};
            }
            done_[next->pass] = true;
            ordered.push_back(begun(std::move(passes_[next->pass]), *next));
            at = ordered.back().cl.back().tip;
        }
        return ordered;
    }

private:
    double height(std::size_t pass) const { return heights_[pass]; }
    std::pair<long, long> tile(const Vec3& p) const {
        return {long(std::floor(p.x() / near_)), long(std::floor(p.y() / near_))};
    }
    const Vec3& place(const Begin& b) const { return passes_[b.pass].cl[b.point].tip; }
    void add(const Begin& b) { tiles_[tile(place(b))].push_back(b); }

    /// The highest that is near and not above; of a level the nearest.
    std::optional<Begin> below(const Vec3& at) {
        std::optional<Begin> best;
        double best_z = -infinity, best_away = infinity;
        const auto [x, y] = tile(at);
        for (long i = x - 1; i <= x + 1; ++i)
            for (long j = y - 1; j <= y + 1; ++j) {
                const auto found = tiles_.find({i, j});
                if (found == tiles_.end()) continue;
                std::erase_if(found->second, [&](const Begin& b) { return done_[b.pass]; });
                for (const Begin& b : found->second) {
                    const Vec3& p = place(b);
                    const double away = (p - at).head<2>().norm();
                    if (away > near_ || p.z() > at.z()) continue;
                    if (p.z() > best_z || (p.z() == best_z && away < best_away)) {
                        best = b;
                        best_z = p.z();
                        best_away = away;
                    }
                }
            }
        return best;
    }

    Begin nearest_on_level(std::size_t first, const Vec3& at) const {
        const double z = height(sorted_[first]);
        Begin best{std::uint32_t(sorted_[first]), 0, false};
        double best_away = infinity;
        for (std::size_t i = first; i < sorted_.size() && height(sorted_[i]) == z; ++i) {
            const std::size_t pass = sorted_[i];
            if (done_[pass]) continue;
            const auto look = [&](std::size_t point) {
                const double away = (passes_[pass].cl[point].tip - at).head<2>().squaredNorm();
                if (!(away < best_away)) return;
                best_away = away;
                best = {std::uint32_t(pass), std::uint32_t(point), false};
            };
            if (!is_closed(passes_[pass]))
                look(0);
            else
                for (std::size_t k = 0; k + 1 < passes_[pass].cl.size(); ++k)
                    look(k);
        }
        return best;
    }

    static Pass begun(Pass pass, const Begin& begin) {
        if (begin.back) {
            std::reverse(pass.cl.begin(), pass.cl.end());
            std::reverse(pass.cc.begin(), pass.cc.end());
        } else if (begin.point > 0) {
            begin_at(pass, begin.point);
        }
        return pass;
    }

    std::vector<Pass>& passes_;
    double near_;
    const Progress& progress_;
    std::vector<double> heights_;
    std::vector<char> done_;
    std::vector<std::size_t> sorted_;
    std::map<std::pair<long, long>, std::vector<Begin>> tiles_;
};

} // namespace

bool is_closed(const Pass& pass) {
    return pass.cl.size() > 3 && pass.cl.front().tip == pass.cl.back().tip;
}

void begin_at(Pass& closed, std::size_t point) {
    const auto turn = [&](auto& list) {
        list.pop_back();
        std::rotate(list.begin(), list.begin() + std::ptrdiff_t(point), list.end());
        list.push_back(list.front());
    };
    turn(closed.cl);
    turn(closed.cc);
}

void order_by_level(std::vector<Pass>& passes, double near, bool either_way, const Progress& progress) {
    passes = Order(passes, near, either_way, progress).run();
}

} // namespace facetmill
