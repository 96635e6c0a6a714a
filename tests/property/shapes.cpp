#include "tests/property/shapes.h"

#include "core/mesh/geometry.h"

namespace facetmill::test {

std::vector<Shape> shapes() {
    const Vec2 lo(-20, -15), hi(20, 15);
    const auto nowhere = [](const Vec3&, const Tool&) { return false; };
    // A level bottom of radius e stands on its rim over the middle of a hollow along y.
    const auto in_hollow = [](const Vec3& p, const Tool& t) {
        return std::abs(p.x()) < 1.5 * (0.5 * t.diameter - t.corner_radius);
    };
    std::vector<Shape> all;
    all.push_back({"plane", height_field([](double, double) { return 3.0; }, lo, hi, 4, 3), nowhere});
    all.push_back({"tilted", height_field([](double x, double y) { return 0.4 * x + 0.5 * y; }, lo, hi, 4, 3),
                   nowhere});
    all.push_back(
        {"cap",
         height_field([](double x, double y) { return std::sqrt(900 - x * x - y * y); }, lo, hi, 40, 30),
         nowhere});
    all.push_back({"trough",
                   height_field([](double x, double) { return -std::sqrt(900 - x * x); }, lo, hi, 80, 3),
                   in_hollow});
    all.push_back({"ridge",
                   turned(height_field([](double x, double) { return -std::abs(x); }, lo, hi, 8, 3), 0.3),
                   nowhere});
    all.push_back({"saddle",
                   height_field([](double x, double y) { return 0.01 * (x * x - y * y); }, lo, hi, 40, 30),
                   in_hollow});
    const auto beside_wall = [](const Vec3& p, const Tool& t) {
        return p.z() < 5 - 1e-9 && p.y() < CutterProfile(t.cutter()).radius_at(5) + 1e-6;
    };
    all.push_back({"step", step(0, 5), beside_wall});
    all.push_back({"step across", turned(step(0, 5), 0.5 * pi), [beside_wall](const Vec3& p, const Tool& t) {
                       return beside_wall(Vec3(p.y(), -p.x(), p.z()), t);
                   }});
    all.push_back({"step oblique", turned(step(0, 5), 0.4), [beside_wall](const Vec3& p, const Tool& t) {
                       const Vec3 q = Eigen::AngleAxisd(-0.4, Vec3::UnitZ()) * p;
                       return beside_wall(q, t);
                   }});
    all.push_back({"hole",
                   only(height_field([](double x, double) { return 0.1 * x; }, lo, hi, 40, 30),
                        [](const Vec3& p) { return std::hypot(p.x(), p.y()) > 6; }),
                   nowhere});
    all.push_back({"box", box(Vec3(-20, -15, 0), Vec3(20, 15, 8)),
                   [](const Vec3& p, const Tool&) { return p.z() < 8 - 1e-9; }});
    return all;
}

PlanContext context_of(const Mesh& mesh, const Tool& tool) {
    PlanContext c;
    const auto part = std::make_shared<Mesh>(mesh);
    c.part = part;
    c.geometry = compute_geometry(*part, Progress());
    c.contact = std::make_shared<ContactIndex>(part, Progress());
    c.part_box = c.stock_box = part->box();
    c.tool = tool;
    return c;
}

} // namespace facetmill::test
