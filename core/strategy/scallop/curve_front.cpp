#include "core/strategy/scallop/curve_front.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Curves are looked at so often in a place of the grid.
constexpr double looks_a_place = 6;

class CurveWalk {
public:
    CurveWalk(const ScallopField& field, CurveFront& front) : field_(field), front_(front) {}

    void along(const PlanCurve& curve, bool closed, const Progress& progress) {
        const std::size_t n = curve.points.size(), first_line = front_.lines.size();
        bool whole = true, on = false;
        for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
            progress.check();
            const Vec2 &a = curve.points[i], &b = curve.points[(i + 1) % n];
            const double looks = std::ceil((b - a).norm() / field_.spacing() * looks_a_place);
            for (double k = 0; k <= looks; ++k) {
                const Vec2 p = a + k / std::max(looks, 1.0) * (b - a);
                const bool cut = field_.cut_at(p);
                if (cut && !on) front_.lines.emplace_back();
                if (cut) go(p);
                whole = whole && cut;
                on = cut;
            }
        }
        std::vector<FieldContour>& lines = front_.lines;
        if (lines.size() > first_line && closed) {
            FieldContour &first = lines[first_line], &last = lines.back();
            if (whole) {
                first.closed = true;
                first.places.pop_back();
            } else if (field_.cut_at(curve.points.front()) && on && lines.size() > first_line + 1) {
                // What is cut goes on over the curve's first place.
                last.places.insert(last.places.end(), first.places.begin() + 1, first.places.end());
                last.corners.insert(last.corners.end(), first.corners.begin(), first.corners.end());
                lines.erase(lines.begin() + std::ptrdiff_t(first_line));
            }
        }
        lines.erase(std::remove_if(lines.begin() + std::ptrdiff_t(first_line), lines.end(),
                                   [](const FieldContour& line) { return line.places.size() < 2; }),
                    lines.end());
    }

private:
    void go(const Vec2& p) {
        FieldContour& line = front_.lines.back();
        if (line.places.empty() || (p - line.places.back()).norm() > 1e-9 * field_.spacing())
            line.places.push_back(p);
        for (const std::size_t i : field_.around(p)) {
            front_.seeds.push_back({i, field_.steps(i, field_.place(i) - p)});
            line.corners.push_back(i);
        }
    }

    const ScallopField& field_;
    CurveFront& front_;
};

} // namespace

CurveFront curve_front(const ScallopField& field, std::span<const PlanCurve> curves, bool open,
                       const Progress& progress) {
    CurveFront front;
    CurveWalk walk(field, front);
    for (const PlanCurve& curve : curves)
        if (curve.points.size() > 1) walk.along(curve, curve.closed && !open, progress);
    return front;
}

} // namespace facetmill
