// facetmill-cli sample: parametric parts to try things on.
#include "app/cli_commands.h"
#include "app/cli_session.h"
#include "core/base/file.h"
#include "core/base/parameter.h"
#include "core/base/strict_json.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample.h"

namespace facetmill::cli {

namespace {

const SampleKind& find_kind(const std::string& name) {
    std::vector<std::string> names;
    std::string list;
    for (const SampleKind& kind : sample_kinds()) {
        if (kind.name == name) return kind;
        names.push_back(kind.name);
        list += (list.empty() ? "" : ", ") + kind.name;
    }
    const std::string near = nearest_name(name, names);
    throw Error(ErrorCode::usage, "sample", "there is no sample '" + printable(name) + "'",
                near.empty() ? "samples: " + list : "did you mean '" + near + "'?");
}

void run_sample(const Arguments& arguments, Session& session) {
    const SampleKind& kind = find_kind(arguments.operand(0));
    const LengthUnit unit = arguments.unit("--units", kind.natural_unit);
    const double per = mm_per(unit);
    const double tolerance = arguments.number("--tolerance", default_sample_tolerance / per);
    const std::string file = arguments.value("-o");
    use_threads(arguments);
    const Progress progress = session.progress();
    const auto mesh = make_sample(kind.name, tolerance * per, progress.part(0.0, 0.8, "Making the sample"));
    OutputFile output(file);
    write_stl(*mesh, output, unit, progress.part(0.8, 1.0, "Writing"));
    output.close_stream();

    const Box3 box = mesh->box();
    Json numbers = Json::array();
    for (const Vec3& corner : {box.lo, box.hi})
        for (int k = 0; k < 3; ++k)
            numbers.push_back(json_number(corner[k] / per, "sample"));
    Json out;
    out["file"] = printable(file, 400);
    out["sample"] = kind.name;
    out["units"] = std::string(unit_name(unit));
    out["tolerance"] = json_number(tolerance, "sample");
    out["facets"] = mesh->facet_count();
    out["bbox"] = numbers;
    session.print(pretty_json(out));
    output.commit();
}

} // namespace

Command sample_command() {
    std::string help = "Samples:\n";
    for (const SampleKind& kind : sample_kinds()) {
        std::string left = "  " + kind.name;
        left.resize(18, ' ');
        help += left + kind.label + ": " + kind.help + "\n";
    }
    help += "An STL file carries no unit: give the same --units to what reads it.";
    return {
        .name = "sample",
        .operands = {"NAME"},
        .summary = "Writes a sample part as binary STL.",
        .help = help,
        .options = {{.name = "--tolerance",
                     .value = "T",
                     .help = "largest chord error, in --units (default: 0.002 in)"},
                    {.name = "--units",
                     .value = "UNIT",
                     .help = "unit of the file: mm, cm, m, in, ft (default: that of the sample's source)"},
                    threads_option(),
                    {.name = "-o", .value = "FILE", .help = "the file to write", .required = true}},
        .run = run_sample};
}

} // namespace facetmill::cli
