// Lowers a ball cutter onto a part at the points of a grid, and prints x, y and the height of its tip.
#include "core/gouge/axial_lift.h"
#include "core/mesh/sample.h"

#include <cmath>
#include <cstdio>

using namespace facetmill;

int main() {
    const Progress progress; // nobody watches, nobody cancels
    const MeshPtr part = make_sample("concave", 0.01, progress);
    const auto index = std::make_shared<const ContactIndex>(part, progress);
    const AxialLift lift(index, CutterProfile(AptCutter::ball(6, 30)));

    constexpr int n = 9;
    const Box3 box = part->box();
    std::vector<Vec2> points;
    for (int i = 0; i < n * n; ++i)
        points.emplace_back(box.lo.x() + (box.hi.x() - box.lo.x()) * (i % n) / (n - 1.0),
                            box.lo.y() + (box.hi.y() - box.lo.y()) * (i / n) / (n - 1.0));
    std::vector<double> heights(points.size());
    lift.tip_z(points, heights, progress);

    int touched = 0, wrong = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::printf("%10.4f %10.4f %10.4f\n", points[i].x(), points[i].y(), heights[i]);
        if (std::isinf(heights[i])) continue; // the cutter meets nothing there
        ++touched;
        // It touches with its ball: the tip is no higher than the part, and no farther below it than the
        // ball.
        if (heights[i] > box.hi.z() || heights[i] < box.lo.z() - 3) ++wrong;
    }
    std::fprintf(stderr, "%d of %zu touch the part, %d at an impossible height\n", touched, points.size(),
                 wrong);
    return touched > 10 && wrong == 0 ? 0 : 1;
}
