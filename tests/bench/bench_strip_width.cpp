// How far apart passes could be at most if every contact point had the posture that clears the widest strip
// there, whatever its neighbours need: per drive plane the least of these widths. From it the passes of the
// best adaptive step-over, and those of the best constant one. Flat end D 0.5 in on a sample part, travel
// along Y, leads of 0 to 9 degrees, yaws of -45 to 45.
//
//     bench_strip_width [PART [TOLERANCE_IN [EVERY_IN]]]      default: convex 0.004 0.125
#include "core/mesh/sample.h"
#include "core/strategy/five_axis/strip_width.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace facetmill;

namespace {

constexpr double inch = 25.4;
const double lead_max = radians(9), lead_step = radians(0.75), yaw_max = radians(45), yaw_step = radians(5);
/// Of the tolerance: what a posture may be lifted by.
constexpr double lifted_share = 0.9;

/// Of both sides together; 0: no posture serves.
double widest_strip(const FiveAxisField& field, const ContactPlace& place) {
    StripWidth width(field, place);
    ToolLift::Hint hint;
    const double most = StripWidth::max_width(field);
    double widest = 0;
    for (double lead = 0; lead <= lead_max + 0.5 * lead_step; lead += lead_step)
        for (double yaw = -yaw_max; yaw <= yaw_max + 0.5 * yaw_step; yaw += yaw_step) {
            const PostureValue p{lead, yaw, field.builder().bottom(place.frame, lead, yaw, hint)};
            if (!(p.delta <= lifted_share * field.cusp()) || !width.clears_own_line(p)) continue;
            widest =
                std::max(widest, std::min(width(p, -1).width, most) + std::min(width(p, +1).width, most));
        }
    return widest;
}

} // namespace

int main(int argc, char** argv) {
    const std::string part = argc > 1 ? argv[1] : "convex";
    const double tolerance = (argc > 2 ? std::atof(argv[2]) : 0.004) * inch;
    const double every = (argc > 3 ? std::atof(argv[3]) : 0.125) * inch;
    if (!(tolerance > 0 && every > 0)) {
        std::fprintf(stderr, "usage: bench_strip_width [PART [TOLERANCE_IN [EVERY_IN]]]\n");
        return 2;
    }
    PlanContext context;
    context.part = make_sample(part, default_sample_tolerance, Progress());
    context.contact = std::make_shared<ContactIndex>(context.part, Progress());
    for (const Vec3& p : context.part->vertices) {
        context.part_box.lo = context.part_box.lo.cwiseMin(p);
        context.part_box.hi = context.part_box.hi.cwiseMax(p);
    }
    context.stock_box = context.part_box;
    context.tool.diameter = 0.5 * inch;
    context.tool.flute_length = 4 * inch;
    context.tool.shank_diameter = 0.5 * inch;
    context.tool.shank_length = 2 * inch;
    context.tool.holder = {{2 * inch, 3 * inch}};
    Finish5Settings settings;
    settings.tolerance = tolerance;
    settings.direction = {0, "y"};
    const FiveAxisField field(context, settings, Progress());
    const auto& lines = field.lines();

    double passes = 0, least = infinity, most = 0;
    for (double v = lines.lo() + 0.5 * every; v < lines.hi(); v += every) {
        const long plane = std::max(1L, std::lround((v - lines.lo()) / lines.spacing()));
        double tightest = infinity;
        for (const SurfaceLine& line : lines.lines(lines.v(plane))) {
            const std::vector<double> samples = field.samples(line);
            for (std::size_t i = 0; i < samples.size(); i += 2)
                if (const double w = widest_strip(field, field.place(line, samples[i], lines.v(plane), 1));
                    w > 0)
                    tightest = std::min(tightest, w);
        }
        if (!std::isfinite(tightest)) continue;
        std::printf("%9.3f in  %.3f in\n", lines.v(plane) / inch, tightest / inch);
        std::fflush(stdout);
        passes += every / tightest;
        least = std::min(least, tightest);
        most = std::max(most, tightest);
    }
    const double constant = (lines.hi() - lines.lo()) / least;
    std::printf("%s: strips %.3f to %.3f in; adaptive %.1f passes, constant %.1f, ratio %.2f\n", part.c_str(),
                least / inch, most / inch, passes, constant, constant / passes);
}
