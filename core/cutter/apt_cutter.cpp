#include "core/base/error.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/cutter/cutter.h"
#include "core/cutter/refuse.h"

#include <array>
#include <cmath>

namespace facetmill {

namespace {

std::string deg(double v) {
    return format_number(degrees(v)) + "°";
}

/// Half the angle by which the boundary turns short of a right angle from bottom to side: the corner circle
/// touches both lines at r tan of it from the corner (Lu 3.36, 3.37).
double half_corner_angle(double alpha, double beta) {
    return 0.5 * (0.5 * pi - alpha - beta);
}

} // namespace

double AptCutter::largest_corner_radius(double d, double alpha, double beta) {
    const double half = half_corner_angle(alpha, beta);
    if (half <= 0) return infinity;
    if (alpha == 0 && beta == 0) return 0.5 * d;
    return 0.5 * d / (std::cos(alpha) * std::tan(half));
}

AptCutter AptCutter::from_shape(double d, double r, double alpha, double beta, double h) {
    const std::array<std::pair<const char*, double>, 5> values{
        {{"d", d}, {"r", r}, {"alpha", alpha}, {"beta", beta}, {"h", h}}};
    for (const auto& [letter, value] : values)
        if (!std::isfinite(value)) refuse(letter, "the value is not a finite number", "enter a number");
    if (d <= 0) refuse("d", "the diameter " + mm(d) + " is not above 0", "enter a positive diameter");
    if (d > tolerance::largest_coordinate)
        refuse("d", "the diameter " + mm(d) + " is too large",
               "at most " + mm(tolerance::largest_coordinate));
    if (r < 0) refuse("r", "the corner radius " + mm(r) + " is negative", "enter 0 or more");
    if (alpha < 0 || alpha >= 0.5 * pi)
        refuse("alpha", "the bottom angle " + deg(alpha) + " is out of range", "0 or more and below 90°");
    if (std::abs(beta) >= 0.5 * pi)
        refuse("beta", "the taper angle " + deg(beta) + " is out of range", "above -90° and below 90°");
    if (alpha + beta > 0.5 * pi + tolerance::cutter_angle)
        refuse("beta",
               "bottom angle " + deg(alpha) + " and taper angle " + deg(beta) + " make no convex cutter",
               "together at most 90°");
    const double largest = largest_corner_radius(d, alpha, beta);
    if (r > largest * (1 + tolerance::cutter_tangency))
        refuse("r", "the corner radius " + mm(r) + " does not fit the diameter " + mm(d),
               "at most " + mm(largest));

    AptCutter c{d, r, 0, 0, alpha, beta, h};
    if (alpha == 0 && beta == 0) { // exactly, without the rounding of tan 45°
        c.r = std::min(r, 0.5 * d);
        c.e = 0.5 * d - c.r;
        c.f = c.r;
    } else {
        c.r = std::min(r, largest);
        // Lu 3.37, 3.39-3.41: the circle touches the bottom line at `touch` from the axis.
        const double half = std::max(0.0, half_corner_angle(alpha, beta));
        double touch = 0.5 * d - c.r * std::tan(half) * std::cos(alpha);
        if (touch < tolerance::cutter_angle * d) touch = 0;
        c.e = touch - c.r * std::sin(alpha);
        c.f = touch * std::tan(alpha) + c.r * std::cos(alpha);
    }
    CutterProfile{c}; // checks the height and what follows from all values together
    return c;
}

AptCutter AptCutter::cone(double d, double half_angle) {
    if (!std::isfinite(half_angle) || half_angle <= 0 || half_angle > 0.5 * pi)
        refuse("half_angle", "the half angle " + deg(half_angle) + " is out of range",
               "above 0° and at most 90°");
    const double alpha = 0.5 * pi - half_angle;
    if (!std::isfinite(d) || d <= 0) refuse("d", "the diameter is not above 0", "enter a positive diameter");
    // A half angle of 90° is a disc: it keeps a small height so that it is a body.
    const double height = alpha > 0 ? 0.5 * d * std::tan(alpha) : d;
    return from_shape(d, 0, alpha, 0, height);
}

AptCutter AptCutter::tapered_ball(double r, double beta, double h) {
    if (!std::isfinite(r) || r <= 0)
        refuse("r", "the ball's radius is not above 0", "enter a positive radius");
    if (!std::isfinite(beta) || std::abs(beta) >= 0.5 * pi)
        refuse("beta", "the taper angle " + deg(beta) + " is out of range", "above -90° and below 90°");
    return from_shape(2 * r * std::tan(half_corner_angle(0, beta)), r, 0, beta, h);
}

AptCutter parse_cutter(std::string_view text, double mm_per_unit) {
    const std::string where = "cutter '" + printable(text) + "'";
    const std::string forms = "use ball:D, flat:D, bull:D,r, cone:D,half_angle or apt:d,r,e,f,alpha,beta,h";
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) throw Error(ErrorCode::syntax, where, "the shape has no ':'", forms);
    const std::string_view name = text.substr(0, colon);
    const std::size_t wanted = name == "ball" || name == "flat"   ? 1
                               : name == "bull" || name == "cone" ? 2
                               : name == "apt"                    ? 7
                                                                  : 0;
    if (wanted == 0) throw Error(ErrorCode::syntax, where, "unknown shape '" + printable(name) + "'", forms);

    std::array<double, 7> v{};
    std::string_view rest = text.substr(colon + 1);
    for (std::size_t i = 0; i < wanted; ++i) {
        const std::size_t comma = rest.find(',');
        if ((comma == std::string_view::npos) != (i + 1 == wanted))
            throw Error(ErrorCode::syntax, where,
                        "the shape needs " + std::to_string(wanted) + (wanted == 1 ? " number" : " numbers"),
                        forms);
        const std::string_view number = rest.substr(0, comma);
        if (!parse_number(number, v[i]))
            throw Error(ErrorCode::syntax, where, "'" + printable(number) + "' is not a number", forms);
        if (comma != std::string_view::npos) rest.remove_prefix(comma + 1);
    }
    const auto length = [&](std::size_t i) { return v[i] * mm_per_unit; };
    try {
        AptCutter c;
        if (name == "ball")
            c = AptCutter::ball(length(0), unlimited_height);
        else if (name == "flat")
            c = AptCutter::flat(length(0), unlimited_height);
        else if (name == "bull")
            c = AptCutter::bull(length(0), length(1), unlimited_height);
        else if (name == "cone")
            c = AptCutter::cone(length(0), radians(v[1]));
        else
            c = {length(0), length(1), length(2), length(3), radians(v[4]), radians(v[5]), length(6)};
        CutterProfile{c};
        return c;
    } catch (const Error& e) {
        throw e.within(where);
    }
}

} // namespace facetmill
