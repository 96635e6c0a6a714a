#include "app/cli_judge.h"

#include "core/base/error.h"
#include "core/job/work_estimate.h"

#include <cmath>

namespace facetmill::cli {

namespace {

/// Where someone asks for a spacing, memory is the limit.
constexpr std::size_t max_samples_asked_for = 10'000'000;

double positive_length(const Arguments& arguments, const char* option, double per) {
    if (!arguments.has(option)) return 0;
    const double v = arguments.number(option, 0) * per;
    if (!(v > 0))
        throw Error(ErrorCode::usage, option, "'" + printable(arguments.value(option)) + "' is not above 0",
                    "give a length in the project's units");
    return v;
}

double uncut_limit(const Arguments& arguments) {
    const double share = arguments.number("--uncut-limit", 0);
    if (!(share >= 0 && share <= 1))
        throw Error(ErrorCode::usage, "--uncut-limit",
                    "'" + printable(arguments.value("--uncut-limit")) + "' is no share",
                    "give a number from 0 to 1: 0.02 is 2 %");
    return share;
}

/// A spacing that asks for a little too much is made coarser, and that is told; one that asks for more is a
/// slip.
void check_spacing(double spacing, const PreparedPart& part, LengthUnit unit) {
    constexpr double slack = 10;
    const double places = estimate_places(part, spacing), most = double(max_samples_asked_for);
    if (places <= slack * most) return;
    throw Error(ErrorCode::limit_exceeded, "--spacing",
                length_text(spacing, unit, 3) + " asks for about " + format_number(places, 2)
                    + " places; at most " + format_number(most) + " are compared",
                "use at least " + length_text(1.05 * spacing * std::sqrt(places / most), unit, 3));
}

} // namespace

OptionInfo resolution_option() {
    return {.name = "--resolution",
            .value = "R",
            .help = "of the stock, in the project's units (default: 1/20 of the cutter's radius)"};
}

OptionInfo spacing_option() {
    return {.name = "--spacing",
            .value = "S",
            .help = "of the places compared, in the project's units (default: the resolution)"};
}

AskedSettings::AskedSettings(const Arguments& arguments, LengthUnit unit)
    : arguments_(arguments), unit_(unit),
      resolution_(positive_length(arguments, "--resolution", mm_per(unit))),
      spacing_(positive_length(arguments, "--spacing", mm_per(unit))),
      gouge_limit_(positive_length(arguments, "--gouge-limit", mm_per(unit))) {}

void AskedSettings::apply(VerifySettings& settings, const PreparedPart& part) const {
    if (arguments_.has("--gouge-limit")) settings.gouge_limit = gouge_limit_;
    if (arguments_.has("--uncut-limit")) settings.uncut_limit = uncut_limit(arguments_);
    settings.resolution = resolution_;
    settings.sample_spacing = spacing_;
    if (spacing_ > 0) {
        settings.max_samples = max_samples_asked_for;
        check_spacing(spacing_, part, unit_);
    }
}

} // namespace facetmill::cli
