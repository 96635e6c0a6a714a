#include "core/verify/standing.h"

#include "core/base/golden_section.h"
#include "core/base/tolerances.h"
#include "core/mesh/triangle_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace facetmill {

namespace {

/// A share of the line that is within some distance of a facet. The distance is convex along the line, so it
/// is one stretch.
struct Near {
    double from = 0, to = 0;
};

/// Where a convex function comes from below a limit at `in` to above it at `out`, as halving the way between
/// them finds it: most of the places that are halved at lie beyond others whose side is known, and are not
/// asked.
template <class F>
double last_below(const F& f, LowPlace in, LowPlace out, double limit, double accuracy) {
    LowPlace low = in, high = out; // the known places next to the limit
    const auto ask = [&](double at) {
        const LowPlace here{at, f(at)};
        (here.value <= limit ? low : high) = here;
        return here.value <= limit;
    };
    // Chords meet the limit before the function does, as it is convex: where one has, the next place is set
    // beyond.
    constexpr int chords = 8;
    const double fine = std::copysign(accuracy / 16, out.at - in.at);
    bool beyond = false;
    for (int k = 0; k < chords && std::abs(high.at - low.at) > 2 * std::abs(fine); ++k) {
        const double share = (limit - low.value) / (high.value - low.value);
        const double step = share * (high.at - low.at), at = low.at + (beyond ? 2 * step + fine : step);
        if (!(std::abs(at - low.at) < std::abs(high.at - low.at))) break;
        beyond = ask(at);
    }
    double from = in.at, to = out.at;
    const auto is_below = [&](double at) {
        if (std::abs(at - in.at) <= std::abs(low.at - in.at)) return true;
        if (std::abs(at - out.at) <= std::abs(high.at - out.at)) return false;
        return ask(at);
    };
    while (std::abs(to - from) > accuracy) {
        const double middle = 0.5 * (from + to);
        (is_below(middle) ? from : to) = middle;
    }
    return from;
}

/// Where f, convex on [0, length], is at most `limit`; false where it never is.
template <class F>
bool stretch_below(const F& f, double length, double limit, double accuracy, Near& near) {
    const LowPlace begin{0, f(0)}, end{length, f(length)};
    LowPlace low = end.value < begin.value ? end : begin;
    if (low.value > limit)
        if (const LowPlace within = golden_minimum(f, 0, length, accuracy, limit); within.value < low.value)
            low = within;
    if (low.value > limit) return false;
    const auto edge = [&](const LowPlace& out) {
        return out.value <= limit ? out.at : last_below(f, low, out, limit, accuracy);
    };
    near = {edge(begin), edge(end)};
    return true;
}

/// A facet beside a line p + t n.
class FacetBeside {
public:
    FacetBeside(const Vec3& p, const Vec3& n, const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 x = n.unitOrthogonal(), y = n.cross(x);
        for (std::size_t k = 0; const Vec3* corner : {&a, &b, &c}) {
            const Vec3 from = *corner - p;
            along_[k] = from.dot(n);
            across_[k++] = {from.dot(x), from.dot(y)};
        }
        const Vec3 normal = (b - a).cross(c - a);
        height_ = (p - a).dot(normal);
        climb_ = n.dot(normal);
        size_ = normal.norm();
    }
    /// Whether no place with t in [0, length] is within `reach` of it.
    bool is_apart(double length, double reach) const {
        const double end = height_ + length * climb_, off = (1 + tolerance::figure_rounding) * reach * size_;
        if (std::min(height_, end) > off || std::max(height_, end) < -off) return true;
        // The whole line, seen along it: a point beside a triangle.
        double left = 1, right = 1, least = infinity;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 &a = across_[k], d = across_[(k + 1) % 3] - a;
            const double side = a.x() * d.y() - a.y() * d.x(), square = d.squaredNorm();
            left = std::min(left, side);
            right = std::min(right, -side);
            const double t = square > 0 ? std::clamp(-a.dot(d) / square, 0.0, 1.0) : 0;
            least = std::min(least, (a + t * d).squaredNorm());
        }
        const double apart = (1 + tolerance::figure_rounding) * reach;
        return left < 0 && right < 0 && least > apart * apart;
    }
    /// All places within `reach` of it are within these.
    Near within(double reach) const {
        return {*std::min_element(along_.begin(), along_.end()) - reach,
                *std::max_element(along_.begin(), along_.end()) + reach};
    }

private:
    std::array<double, 3> along_;
    std::array<Vec2, 3> across_;               ///< of the line
    double height_ = 0, climb_ = 0, size_ = 0; ///< over its plane, times twice the facet's area
};

} // namespace

/// A place of the line that is farther than `limit` from the part, well within the longest stretch of such;
/// below 0 where there is none.
double StandingMaterial::far_place(const Vec3& p, const Vec3& n, double length, double limit) const {
    constexpr double accuracy_share = 1e-3;
    const double reach = limit + allowance_, accuracy = accuracy_share * limit;
    std::vector<Near> covered{{0, std::min(limit, length)}}; // the place itself is of the part
    sight_.each_near(p, n, length, reach, [&](std::size_t facet) {
        const Mesh& mesh = sight_.mesh();
        const Vec3 &a = mesh.corner(facet, 0), &b = mesh.corner(facet, 1), &c = mesh.corner(facet, 2);
        const FacetBeside beside(p, n, a, b, c);
        if (beside.is_apart(length, reach)) return;
        const Near most = beside.within(reach);
        if (most.to < 0 || most.from > length) return;
        const auto holds = [&](const Near& other) {
            return other.from <= std::max(most.from, 0.0) && std::min(most.to, length) <= other.to;
        };
        if (std::any_of(covered.begin(), covered.end(), holds)) return;
        Near near;
        if (stretch_below([&](double t) { return std::sqrt(squared_distance(p + t * n, a, b, c)); }, length,
                          reach, accuracy, near))
            covered.push_back(near);
    });
    std::sort(covered.begin(), covered.end(), [](const Near& a, const Near& b) { return a.from < b.from; });
    double up_to = 0, longest = 4 * accuracy, place = -1;
    const auto gap = [&](double from, double to) {
        if (to - from <= longest) return;
        longest = to - from;
        place = 0.5 * (from + to);
    };
    for (const Near& near : covered) {
        gap(up_to, near.from);
        up_to = std::max(up_to, near.to);
    }
    gap(up_to, length);
    return place;
}

double StandingMaterial::off_part(const Vec3& p, const Vec3& n, double top) const {
    if (!(top > far_)) return top;
    // Of what it can be at most. A facet that is hardly nearer than the line's beginning need not be found:
    // over a hollow as wide as the line is high, that is nearly all of its facets.
    constexpr double enough = 0.985;
    const auto look = [&](double t, double most) {
        const double cap = enough * most > far_ ? enough * most : most;
        const double found = distance(p + t * n, cap, enough);
        return found >= cap * (1 - tolerance::figure_rounding) ? most : found;
    };
    const double at_top = look(top, top);
    if (at_top >= enough * top) return at_top;
    const double place = far_place(p, n, top, far_);
    if (place < 0) {
        double no_more = far_;
        for (int k = 0; k < 3 && far_place(p, n, top, 0.5 * no_more) < 0; ++k)
            no_more *= 0.5;
        return no_more;
    }
    // Stretches of the line by the most that can be between their ends: the distance changes by no more than
    // the way. The part is at the line's beginning.
    struct Piece {
        double from, to, at_from, at_to;
        double most() const { return 0.5 * (at_from + at_to + to - from); }
    };
    constexpr std::size_t looks = 16;
    std::array<Piece, looks + 2> pieces;
    std::size_t count = 0;
    const double at_place = look(place, place);
    pieces[count++] = {0, place, 0, at_place};
    pieces[count++] = {place, top, at_place, at_top};
    double best = std::max({at_top, at_place, far_});
    for (std::size_t k = 0; k < looks; ++k) {
        Piece& piece = *std::max_element(pieces.begin(), pieces.begin() + std::ptrdiff_t(count),
                                         [](const Piece& a, const Piece& b) { return a.most() < b.most(); });
        if (enough * piece.most() <= best) break;
        const double middle = 0.5 * (piece.from + piece.to);
        const double there = look(middle, piece.most());
        best = std::max(best, there);
        pieces[count++] = {middle, piece.to, there, piece.at_to};
        piece = {piece.from, middle, piece.at_from, there};
    }
    // More than `far` it is, whatever rounding says.
    return std::max(best, std::nextafter(far_, infinity));
}

} // namespace facetmill
