#include "tests/bench/opencamlib.h"

#ifdef FACETMILL_OPENCAMLIB
#include <opencamlib/adaptivepathdropcutter.hpp>
#include <opencamlib/adaptivewaterline.hpp>
#include <opencamlib/ballcutter.hpp>
#include <opencamlib/line.hpp>
#include <opencamlib/path.hpp>
#include <opencamlib/stlsurf.hpp>
#include <opencamlib/triangle.hpp>
#include <opencamlib/waterline.hpp>
#endif

namespace facetmill {

#ifdef FACETMILL_OPENCAMLIB

bool opencamlib_is_here() {
    return true;
}

namespace {

ocl::STLSurf surface_of(const Mesh& mesh) {
    ocl::STLSurf surface;
    const auto point = [](const Vec3& p) { return ocl::Point(p.x(), p.y(), p.z()); };
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        surface.addTriangle(
            ocl::Triangle(point(mesh.corner(f, 0)), point(mesh.corner(f, 1)), point(mesh.corner(f, 2))));
    return surface;
}

void levels_of(ocl::Waterline& waterline, const ocl::STLSurf& surface, const ocl::BallCutter& ball,
               const std::vector<double>& heights, std::vector<std::vector<Vec3>>& loops) {
    waterline.setSTL(surface);
    waterline.setCutter(&ball);
    for (const double z : heights) {
        waterline.reset();
        waterline.setZ(z);
        waterline.run();
        for (const auto& loop : waterline.getLoops()) {
            loops.emplace_back();
            for (const ocl::Point& p : loop)
                loops.back().emplace_back(p.x, p.y, p.z);
            if (!loop.empty()) loops.back().push_back(loops.back().front()); // it goes round
        }
    }
}

} // namespace

double parallel_finish_by_opencamlib(const Mesh& mesh, double diameter, double step) {
    const ocl::STLSurf surface = surface_of(mesh);
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

std::vector<std::vector<Vec3>> waterline_by_opencamlib(const Mesh& mesh, double diameter,
                                                       const std::vector<double>& heights, double sampling,
                                                       double min_sampling) {
    const ocl::STLSurf surface = surface_of(mesh);
    const ocl::BallCutter ball(diameter, 500); // as long as ours
    std::vector<std::vector<Vec3>> loops;
    if (min_sampling > 0) {
        ocl::AdaptiveWaterline adaptive;
        adaptive.setSampling(sampling);
        adaptive.setMinSampling(min_sampling);
        levels_of(adaptive, surface, ball, heights, loops);
    } else {
        ocl::Waterline even;
        even.setSampling(sampling);
        levels_of(even, surface, ball, heights, loops);
    }
    return loops;
}

#else

bool opencamlib_is_here() {
    return false;
}

double parallel_finish_by_opencamlib(const Mesh&, double, double) {
    return 0;
}

std::vector<std::vector<Vec3>> waterline_by_opencamlib(const Mesh&, double, const std::vector<double>&,
                                                       double, double) {
    return {};
}

#endif

} // namespace facetmill
