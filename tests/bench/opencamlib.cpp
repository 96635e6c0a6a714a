#include "tests/bench/opencamlib.h"

#ifdef FACETMILL_OPENCAMLIB
#include <opencamlib/adaptivepathdropcutter.hpp>
#include <opencamlib/ballcutter.hpp>
#include <opencamlib/line.hpp>
#include <opencamlib/path.hpp>
#include <opencamlib/stlsurf.hpp>
#include <opencamlib/triangle.hpp>
#endif

namespace facetmill {

#ifdef FACETMILL_OPENCAMLIB

bool opencamlib_is_here() {
    return true;
}

double parallel_finish_by_opencamlib(const Mesh& mesh, double diameter, double step) {
    ocl::STLSurf surface;
    const auto point = [](const Vec3& p) { return ocl::Point(p.x(), p.y(), p.z()); };
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        surface.addTriangle(
            ocl::Triangle(point(mesh.corner(f, 0)), point(mesh.corner(f, 1)), point(mesh.corner(f, 2))));
    ocl::BallCutter ball(diameter, 50);
    const Box3 box = mesh.box();
    const double beside = 0.5 * diameter;
    ocl::Path path;
    for (double y = box.lo.y() - beside + 0.5 * step; y < box.hi.y() + beside; y += step)
        path.append(ocl::Line(ocl::Point(box.lo.x() - beside, y, 0), ocl::Point(box.hi.x() + beside, y, 0)));
    ocl::AdaptivePathDropCutter drop;
    drop.setSTL(surface);
    drop.setCutter(&ball);
    drop.setZ(box.lo.z());
    drop.setSampling(0.1);
    drop.setMinSampling(0.01);
    drop.setPath(&path);
    drop.run();
    return double(drop.getPoints().size());
}

#else

bool opencamlib_is_here() {
    return false;
}

double parallel_finish_by_opencamlib(const Mesh&, double, double) {
    return 0;
}

#endif

} // namespace facetmill
