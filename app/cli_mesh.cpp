#include "app/cli_mesh.h"

#include "core/base/error.h"
#include "core/job/project.h"

#include <array>

namespace facetmill::cli {

namespace {

/// Each is the key of a part's parameter, and reads as that.
struct ReadingOption {
    const char *name, *key, *value, *help;
};
constexpr std::array<ReadingOption, 8> reading_options{{
    {"--objects", "objects", "NAMES",
     "3MF, glTF: objects by name or number, commas between (default: what is on the plate, or in the scene)"},
    {"--picture-width", "picture_width", "W", "PNG, TIFF: along X, first to last column (default: 100 mm)"},
    {"--picture-length", "picture_length", "L", "PNG, TIFF: along Y (default: as the pixels are, square)"},
    {"--relief-height", "relief_height", "H", "PNG, TIFF: of white above black (default: 5 mm)"},
    {"--smoothing", "smoothing", "S", "PNG, TIFF: evened out, no height moved by more (default: 0)"},
    {"--invert", "invert", "", "PNG, TIFF: black is the top"},
    {"--chord", "chord_tolerance", "T",
     "STEP, IGES: how far facets may lie from surfaces (default: 0.01 mm)"},
    {"--angle", "angle_tolerance", "DEGREES",
     "STEP, IGES: how much normals side by side may differ (default: 10)"},
}};

} // namespace

std::vector<OptionInfo> with_reading_options(std::vector<OptionInfo> options) {
    for (const ReadingOption& o : reading_options)
        options.push_back({.name = o.name, .value = o.value, .help = o.help});
    return options;
}

MeshReading asked_reading(const Arguments& arguments) {
    const LengthUnit unit = arguments.unit("--units", LengthUnit::mm);
    PartSpec spec;
    ParameterView<PartSpec> view(spec, part_parameters());
    for (const ReadingOption& o : reading_options) {
        if (!arguments.has(o.name)) continue;
        try {
            const std::string value = *o.value == '\0' ? "true" : arguments.value(o.name);
            view.set(o.key, view.parameter(o.key).parse(value, unit));
        } catch (const Error& e) {
            throw Error(e.code() == ErrorCode::wrong_type ? ErrorCode::usage : e.code(), o.name, e.message(),
                        e.remedy());
        }
    }
    MeshReading reading = spec.reading();
    reading.unit = arguments.has("--units") ? std::optional(unit) : std::nullopt;
    return reading;
}

void refuse_reading_options(const Arguments& arguments) {
    for (const ReadingOption& o : reading_options)
        if (arguments.has(o.name))
            throw Error(ErrorCode::usage, o.name, "a project says itself how its part is read",
                        "leave " + std::string(o.name) + " out, or set `" + o.key
                            + "` of the project's part");
}

} // namespace facetmill::cli
