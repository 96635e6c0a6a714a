// A line looked at more closely until the motion from point to point is as near to what its field says as it
// must be. Millimetres.
#pragma once

#include "core/base/vec.h"
#include "core/strategy/surface/lift_line.h"

#include <cmath>
#include <vector>

namespace facetmill {

/// A `Line` has points `Line::Point`, and
/// - `LinePoint flat(from, p)`: p seen from `from`, as distance along the line and height;
/// - `Point middle(a, b)`: what the field says half-way;
/// - `Point over(high, low)`: `high` moved along the line to where `low` is;
/// - `void check()`: throws Cancelled.
template <class Line>
class LineRefiner {
public:
    using Point = typename Line::Point;

    LineRefiner(Line& line, const LineTolerance& tolerance) : line_(line), tolerance_(tolerance) {}

    /// Appends what lies between a and b, with `mid` half-way, and b.
    void add(const Point& a, const Point& mid, const Point& b, std::vector<Point>& out, int depth = 0) const {
        if (is_undivided(a, b, depth)) {
            add_jump(a, b, out);
            return;
        }
        if (depth % 8 == 7) line_.check();
        const Point before = line_.middle(a, mid), after = line_.middle(mid, b);
        if (is_straight(a, before, mid, after, b)) {
            out.insert(out.end(), {before, mid, after, b});
            return;
        }
        add(a, before, mid, out, depth + 1);
        add(mid, after, b, out, depth + 1);
    }

    /// Too short to be looked at more closely.
    bool is_undivided(const Point& a, const Point& b, int depth) const {
        return line_.flat(a, b).s <= tolerance_.shortest() || depth >= deepest;
    }
    /// Appends b, with an upright move before it, on the low side of what then is a jump.
    void add_jump(const Point& a, const Point& b, std::vector<Point>& out) const {
        const double dz = line_.flat(a, b).z - line_.flat(a, a).z;
        if (dz < 0)
            out.push_back(line_.over(a, b));
        else if (dz > 0)
            out.push_back(line_.over(b, a));
        out.push_back(b);
    }
    /// Whether quarters of a piece are all near its chord, and short. The middle alone does not tell: down a
    /// steep wall the path bends over the wall's edge and back at its foot, and what the one bend lifts the
    /// middle over the chord the other may lower it. Of the height of a single kink, wherever it is, the
    /// nearest quarter shows four fifths; half of what is allowed leaves room for a second one beside it.
    bool is_straight(const Point& a, const Point& before, const Point& mid, const Point& after,
                     const Point& b) const {
        const LinePoint quarter[] = {line_.flat(a, a), line_.flat(a, before), line_.flat(a, mid),
                                     line_.flat(a, after), line_.flat(a, b)};
        const double ds = quarter[4].s, dz = quarter[4].z - quarter[0].z, across = ds / std::hypot(ds, dz);
        for (std::size_t k = 1; k < 5; ++k) {
            const LinePoint &p = quarter[k - 1], &q = quarter[k];
            // Along the path itself, not as seen from above: that is what the cutter may pass unseen.
            if (std::hypot(q.s - p.s, q.z - p.z) > tolerance_.spacing) return false;
            const double off = (q.z - quarter[0].z - 0.25 * double(k) * dz) * across;
            if (off > 0.5 * tolerance_.below || off < -0.5 * tolerance_.above) return false;
        }
        return true;
    }

private:
    /// Halvings between two places, at most: a guard only, since they end where pieces are short.
    static constexpr int deepest = 40;

    Line& line_;
    LineTolerance tolerance_;
};

} // namespace facetmill
