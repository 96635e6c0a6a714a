// facetmill-cli place: a placement that lays the part on a face.
#include "app/cli_commands.h"
#include "app/cli_mesh.h"
#include "app/cli_session.h"
#include "core/base/strict_json.h"
#include "core/mesh/flat_face.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/outward.h"
#include "core/setup/lying.h"

#include <cmath>

namespace facetmill::cli {

namespace {

/// To a millionth of what is printed: measured, not read.
Json number_json(double v) {
    return json_number(std::round(v * 1e9) / 1e9 + 0.0, "place");
}

Json vector_json(const Vec3& v) {
    return Json::array({number_json(v.x()), number_json(v.y()), number_json(v.z())});
}

/// What the part is laid on: which way is down, and what is told of it.
struct Choice {
    Vec3 down;
    Json told;
};

Json face_json(const LyingFace& face, double per) {
    Json out;
    out["down"] = vector_json(face.down);
    out["contact_area"] = number_json(face.contact_area / (per * per));
    out["support_area"] = number_json(face.support_area / (per * per));
    out["height"] = number_json(face.height / per);
    out["facing_down"] = number_json(face.facing_down);
    out["tips_at"] = number_json(degrees(face.tips_at));
    return out;
}

Choice choose(const Mesh& mesh, const std::string& on, double per, const Progress& progress) {
    Choice choice;
    if (on == "largest" || on == "best") {
        const auto faces = lying_faces(mesh, on == "best" ? LyingOrder::best : LyingOrder::largest, progress);
        choice.down = faces.front().down;
        choice.told["lies_on"] = face_json(faces.front(), per);
        choice.told["candidates"] = Json::array();
        for (const LyingFace& face : faces)
            choice.told["candidates"].push_back(face_json(face, per));
        return choice;
    }
    double number = 0;
    if (!parse_number(on, number) || number < 0 || number != std::floor(number))
        throw Error(ErrorCode::usage, "--on", "'" + printable(on) + "' is no face",
                    "write largest, best or the number of a facet");
    if (number >= double(mesh.facet_count()))
        throw Error(ErrorCode::out_of_range, "--on", "the part has no facet " + printable(on),
                    "facets are numbered from 0 to " + std::to_string(mesh.facet_count() - 1));
    const std::vector<Index> face = flat_face(mesh, Index(number));
    double area = 0;
    for (const Index f : face)
        area += 0.5 * mesh.facet_cross(f).norm();
    choice.down = mesh.facet_normal(std::size_t(number));
    choice.told["lies_on"] = {{"down", vector_json(choice.down)},
                              {"facets", face.size()},
                              {"area", number_json(area / (per * per))}};
    return choice;
}

void run_place(const Arguments& arguments, Session& session) {
    const LengthUnit unit = arguments.unit("--units", LengthUnit::mm), told = project_unit(unit);
    const double per = mm_per(told);
    const std::string& path = arguments.operand(0);
    use_threads(arguments);
    const Progress progress = session.progress();
    const LoadedMesh loaded =
        load_mesh(path, asked_reading(arguments), progress.part(0, 0.4, "Reading the part"));
    const OutwardSides sides = outward_sides(*loaded.mesh, progress.part(0.4, 0.7));
    const MeshPtr mesh = wound_outward(loaded.mesh, sides);
    const Choice choice = choose(*mesh, arguments.value("--on"), per, progress.part(0.7, 1));

    Mat3 turn = turn_to_lie(choice.down);
    if (arguments.has("--square")) {
        Mesh lying = *mesh;
        for (Vec3& v : lying.vertices)
            v = turn * v;
        turn = turn_to_square(lying) * turn;
    }
    const Placement at = laid({}, *mesh, turn);
    const Box3 box = turned_box(*mesh, rotation_of(at.rotate));
    const Vec3 move(at.translate[0], at.translate[1], at.translate[2]);
    Json part;
    part["file"] = printable(path, 400);
    part["units"] = std::string(unit_name(unit));
    part["rotate"] = vector_json(Vec3(degrees(at.rotate[0]), degrees(at.rotate[1]), degrees(at.rotate[2])));
    part["translate"] = vector_json(move / per);
    Json out;
    out["units"] = std::string(unit_name(told));
    out["part"] = part;
    out["low"] = vector_json((box.lo + move) / per);
    out["high"] = vector_json((box.hi + move) / per);
    out.update(choice.told);
    session.print(pretty_json(out));
}

} // namespace

Command place_command() {
    return {
        .name = "place",
        .operands = {"PART"},
        .summary = "Prints a placement that lays the part on a face, as a project has it.",
        .help = "`part` is what a project file in these `units`, mm or in, says of it: the face comes down "
                "to Z 0, the middle of the "
                "box keeps its X\n"
                "and Y. largest: the largest area on the table. best: the least surface that faces the "
                "table without\n"
                "lying on it, the largest area on it, a firm stand. candidates lists the faces of the convex "
                "hull that "
                "the part stays on,\n"
                "in that order: tips_at is the tilt in degrees that it falls at, facing_down a share of "
                "the surface.",
        .options = with_reading_options(
            {{.name = "--on",
              .value = "FACE",
              .help =
                  "largest, best, or a facet by its number from 0, degenerate ones left out: the flat face "
                  "it belongs to",
              .required = true},
             {.name = "--square",
              .value = "",
              .help = "also turn the part about Z to the smallest box, its longer side along X"},
             {.name = "--units",
              .value = "UNIT",
              .help = "unit of the file's numbers: mm, cm, m, in, ft (default: mm)"},
             threads_option()}),
        .run = run_place};
}

} // namespace facetmill::cli
