#include "core/setup/placement.h"

#include <cmath>

namespace facetmill {

namespace {

/// Steps, in degrees and mm, that numbers of a placement that was found are rounded to.
constexpr double angle_step = 1e-10, length_step = 1e-9;
/// Cosine of the second angle below which the first and the third turn about one axis.
constexpr double gimbal_cosine = 1e-9;

double rounded(double value, double step) {
    return std::round(value / step) * step + 0.0;
}

std::array<double, 3> rounded_lengths(const Vec3& v) {
    return {rounded(v.x(), length_step), rounded(v.y(), length_step), rounded(v.z(), length_step)};
}

Vec3 vector_of(const std::array<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

Mat3 mirror_matrix(Mirror mirror) {
    Vec3 factors = Vec3::Ones();
    if (mirror != Mirror::none) factors[int(mirror) - int(Mirror::x)] = -1;
    return factors.asDiagonal();
}

} // namespace

Mat3 rotation_of(const std::array<double, 3>& rotate) {
    return (Eigen::AngleAxisd(rotate[2], Vec3::UnitZ()) * Eigen::AngleAxisd(rotate[1], Vec3::UnitY())
            * Eigen::AngleAxisd(rotate[0], Vec3::UnitX()))
        .toRotationMatrix();
}

std::array<double, 3> angles_of(const Mat3& r) {
    const double cosine = std::hypot(r(0, 0), r(1, 0));
    std::array<double, 3> angles{0, std::atan2(-r(2, 0), cosine), 0};
    if (cosine > gimbal_cosine) {
        angles[0] = std::atan2(r(2, 1), r(2, 2));
        angles[2] = std::atan2(r(1, 0), r(0, 0));
    } else {
        angles[2] = std::atan2(-r(0, 1), r(1, 1));
    }
    for (double& angle : angles)
        angle = radians(rounded(degrees(angle), angle_step));
    return angles;
}

Placement turned(const Placement& placement, const Mat3& turn, const Vec3& about) {
    Placement result = placement;
    result.rotate = angles_of(turn * rotation_of(placement.rotate));
    result.translate = rounded_lengths(turn * (vector_of(placement.translate) - about) + about);
    return result;
}

Placement moved(const Placement& placement, const Vec3& by) {
    Placement result = placement;
    result.translate = rounded_lengths(vector_of(placement.translate) + by);
    return result;
}

Placement mirrored(const Placement& placement, int axis, double at) {
    Placement result = placement;
    const Mat3 flip = mirror_matrix(Mirror(int(Mirror::x) + axis));
    // Two mirrors are a turn, and one can stand before any turn.
    const bool was = placement.mirror != Mirror::none;
    result.mirror = was ? Mirror::none : Mirror(int(Mirror::x) + axis);
    result.rotate =
        angles_of(flip * rotation_of(placement.rotate) * (was ? mirror_matrix(placement.mirror) : flip));
    Vec3 move = vector_of(placement.translate);
    move[axis] = 2 * at - move[axis];
    result.translate = rounded_lengths(move);
    return result;
}

ParameterInfo mesh_unit_parameter() {
    return {.key = "units",
            .label = "Units",
            .help = "Unit of the numbers in the mesh file. Default: the project's.",
            .words = unit_names(),
            .stage = Stage::mesh};
}

ParameterInfo scale_parameter(const std::string& what) {
    return {.key = "scale",
            .label = "Scale",
            .help =
                "Makes the " + what
                + " so many times as large as its file and unit say, about the file's origin; 1 leaves it. "
                  "Unit, scale, mirror, rotate and translate are applied in this order.",
            .minimum = 0,
            .maximum = 1e6,
            .open_minimum = true,
            .stage = Stage::mesh};
}

ParameterInfo mirror_parameter(const std::string& what) {
    return {.key = "mirror",
            .label = "Mirror",
            .help = "Turns the " + what
                    + " into its mirror image, before it is turned: this coordinate of its points changes "
                      "sign.",
            .words = {"none", "x", "y", "z"},
            .stage = Stage::mesh};
}

ParameterInfo rotate_parameter(std::string help) {
    return {.key = "rotate",
            .label = "Rotate",
            .help = std::move(help),
            .kind = ParameterKind::triple,
            .quantity = Quantity::angle,
            .minimum = -2 * pi,
            .maximum = 2 * pi,
            .stage = Stage::mesh};
}

ParameterInfo translate_parameter(std::string help) {
    return {.key = "translate",
            .label = "Translate",
            .help = std::move(help),
            .kind = ParameterKind::triple,
            .quantity = Quantity::length,
            .minimum = -1e6,
            .maximum = 1e6,
            .stage = Stage::mesh};
}

} // namespace facetmill
