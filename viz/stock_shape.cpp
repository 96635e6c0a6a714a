#include "viz/stock_shape.h"

#include "viz/part_display.h"

#include <cmath>

namespace facetmill {

namespace {

void add_point(StockShape& shape, const Vec3& p) {
    for (int k = 0; k < 3; ++k)
        shape.points.push_back(float(p[k]));
}

void make_box(StockShape& shape) {
    const Vec3 half = shape.box.size() / 2;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 p;
        for (int k = 0; k < 3; ++k)
            p[k] = corner >> k & 1 ? half[k] : -half[k];
        add_point(shape, p);
    }
    shape.triangles = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                       2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    shape.segments = {0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7};
}

void make_cylinder(StockShape& shape, int axis, double radius) {
    constexpr int around = 96, lines = 4;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double half = 0.5 * shape.box.size()[axis];
    for (int i = 0; i < around; ++i)
        for (const double end : {-half, half}) { // points 2 i and 2 i + 1
            Vec3 p;
            p[axis] = end;
            p[u] = radius * std::cos(2 * pi * i / around);
            p[v] = radius * std::sin(2 * pi * i / around);
            add_point(shape, p);
        }
    for (const double end : {-half, half}) {
        Vec3 p = Vec3::Zero();
        p[axis] = end;
        add_point(shape, p);
    }
    for (int i = 0; i < around; ++i) {
        const int a = 2 * i, b = 2 * ((i + 1) % around);
        for (const auto& t :
             {std::array{a, b, b + 1}, {a, b + 1, a + 1}, {b, a, 2 * around}, {a + 1, b + 1, 2 * around + 1}})
            shape.triangles.insert(shape.triangles.end(), t.begin(), t.end());
        shape.segments.insert(shape.segments.end(), {a, b, a + 1, b + 1});
        if (i % (around / lines) == 0) shape.segments.insert(shape.segments.end(), {a, a + 1});
    }
}

} // namespace

StockShapePtr make_stock_shape(const StockSolid& solid, const Progress& progress) {
    if (solid.box.empty()) return nullptr;
    auto shape = std::make_shared<StockShape>();
    shape->box = solid.box;
    shape->center = solid.box.center();
    switch (solid.kind) {
    case StockSolid::Kind::box:
        make_box(*shape);
        break;
    case StockSolid::Kind::cylinder:
        make_cylinder(*shape, solid.axis, solid.radius);
        break;
    case StockSolid::Kind::mesh: {
        const PartDisplayPtr display = prepare_part_display(solid.mesh, progress);
        shape->center = display->center;
        shape->points = display->points;
        shape->triangles = display->triangles;
        shape->segments = display->lines;
        break;
    }
    }
    progress.set(1.0);
    return shape;
}

} // namespace facetmill
