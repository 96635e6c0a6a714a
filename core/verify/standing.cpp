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

/// Where f, convex on [0, length], is at most `limit`; false where it never is.
template <class F>
bool stretch_below(const F& f, double length, double limit, double accuracy, Near& near) {
    LowPlace low{0, f(0)};
    if (const LowPlace end{length, f(length)}; end.value < low.value) low = end;
    if (low.value > limit)
        if (const LowPlace within = golden_minimum(f, 0, length, accuracy, limit); within.value < low.value)
            low = within;
    if (low.value > limit) return false;
    const auto edge = [&](double in, double out) {
        if (f(out) <= limit) return out;
        while (std::abs(out - in) > accuracy) {
            const double middle = 0.5 * (in + out);
            (f(middle) <= limit ? in : out) = middle;
        }
        return in;
    };
    near = {edge(low.at, 0), edge(low.at, length)};
    return true;
}

} // namespace

/// A place of the line that is farther than `limit` from the part, well within the longest stretch of such;
/// below 0 where there is none.
double Standing::far_place(const Vec3& p, const Vec3& n, double length, double limit) const {
    constexpr double accuracy_share = 1e-3;
    const double reach = limit + allowance_, accuracy = accuracy_share * limit;
    std::vector<Near> covered{{0, std::min(limit, length)}}; // the place itself is of the part
    sight_.each_near(p, n, length, reach, [&](std::size_t facet) {
        const Mesh& mesh = sight_.mesh();
        const Vec3 &a = mesh.corner(facet, 0), &b = mesh.corner(facet, 1), &c = mesh.corner(facet, 2);
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

double Standing::off_part(const Vec3& p, const Vec3& n, double top) const {
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
