#include "core/strategy/rough/rough_order.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace facetmill {

namespace {

/// The plane is divided into squares, in which passes are seen; so many of them make `near`, and a route is
/// seen at least at every half of a square.
constexpr int squares_per_near = 2;
constexpr double seen_every = 0.5;

using Square = std::pair<std::int32_t, std::int32_t>;

std::uint64_t key(const Square& s) {
    return std::uint64_t(std::uint32_t(s.first)) << 32 | std::uint32_t(s.second);
}

std::vector<Square> squares_of(const Pass& pass, double side) {
    std::vector<Square> squares;
    const auto add_route = [&](const std::vector<CutterLocation>& route) {
        for (std::size_t i = 0; i < route.size(); ++i) {
            const Vec2 b = route[i].tip.head<2>(), a = i > 0 ? Vec2(route[i - 1].tip.head<2>()) : b;
            const double n = std::max(1.0, std::ceil((b - a).norm() / (seen_every * side)));
            for (double k = i > 0 ? 1 : 0; k <= n; ++k) {
                const Vec2 p = a + (k / n) * (b - a);
                const Square s{std::int32_t(std::floor(p.x() / side)),
                               std::int32_t(std::floor(p.y() / side))};
                if (squares.empty() || squares.back() != s) squares.push_back(s);
            }
        }
    };
    add_route(pass.entry);
    add_route(pass.cl);
    std::sort(squares.begin(), squares.end());
    squares.erase(std::unique(squares.begin(), squares.end()), squares.end());
    return squares;
}

} // namespace

void order_passes(std::vector<Pass>& passes, double near, const Progress& progress) {
    const std::size_t n = passes.size();
    if (n < 3 || !(near > 0)) return;
    const double side = near / squares_per_near;
    // A place of either pass lies up to a half of `seen_every` from one that was seen.
    std::vector<Square> around;
    const auto gap = [](std::int32_t d) { return std::max(0, std::abs(d) - 1); };
    for (std::int32_t x = -squares_per_near - 2; x <= squares_per_near + 2; ++x)
        for (std::int32_t y = -squares_per_near - 2; y <= squares_per_near + 2; ++y)
            if (std::hypot(gap(x), gap(y)) <= squares_per_near + seen_every) around.push_back({x, y});
    std::vector<std::vector<std::size_t>> after(n);
    std::vector<std::size_t> waits(n, 0);
    {
        // The last one of all that were in a square before is enough: it waits for the others.
        std::unordered_map<std::uint64_t, std::size_t> last;
        std::vector<std::size_t> before;
        for (std::size_t i = 0; i < n; ++i) {
            progress.check();
            const std::vector<Square> squares = squares_of(passes[i], side);
            before.clear();
            for (const Square& s : squares)
                for (const auto& [x, y] : around)
                    if (const auto found = last.find(key({s.first + x, s.second + y})); found != last.end())
                        before.push_back(found->second);
            std::sort(before.begin(), before.end());
            before.erase(std::unique(before.begin(), before.end()), before.end());
            for (const std::size_t b : before)
                after[b].push_back(i);
            waits[i] = before.size();
            for (const Square& s : squares)
                last[key(s)] = i;
        }
    }
    const auto start_of = [&](std::size_t i) {
        const Pass& p = passes[i];
        return Vec2((p.entry.empty() ? p.cl : p.entry).front().tip.head<2>());
    };
    std::vector<std::size_t> ready, order;
    for (std::size_t i = 0; i < n; ++i)
        if (waits[i] == 0) ready.push_back(i);
    Vec2 at = start_of(0);
    while (!ready.empty()) {
        progress.check();
        std::size_t best = 0;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < ready.size(); ++k) {
            const double d = (start_of(ready[k]) - at).squaredNorm();
            if (d < nearest || (d == nearest && ready[k] < ready[best])) {
                nearest = d;
                best = k;
            }
        }
        const std::size_t i = ready[best];
        ready.erase(ready.begin() + std::ptrdiff_t(best));
        order.push_back(i);
        at = passes[i].cl.back().tip.head<2>();
        for (const std::size_t next : after[i])
            if (--waits[next] == 0) ready.push_back(next);
    }
    std::vector<Pass> ordered;
    ordered.reserve(n);
    for (const std::size_t i : order)
        ordered.push_back(std::move(passes[i]));
    passes = std::move(ordered);
}

} // namespace facetmill
