// facetmill-cli render: a picture of a part or a planned project, without a display.
#include "app/cli_commands.h"
#include "app/cli_mesh.h"
#include "app/cli_project.h"
#include "app/cli_session.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/output/apt.h"

#ifdef FACETMILL_HAS_PICTURES
#include "core/base/parallel.h"
#include "core/base/strict_json.h"
#include "core/job/opened_program.h"
#include "core/job/planner.h"
#include "core/job/stock_solid.h"
#include "core/job/verification.h"
#include "core/strategy/five_axis/five_axis_study.h"
#include "core/verify/playback.h"
#include "core/verify/stock_surface.h"
#include "viz/render_picture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#endif

namespace facetmill::cli {

namespace {

#ifdef FACETMILL_HAS_PICTURES

/// What the command line cannot mean is wrong usage, whatever the parser calls it.
template <class Parse>
auto as_usage(Parse&& parse) {
    try {
        return parse();
    } catch (const Error& e) {
        if (e.code() != ErrorCode::out_of_range) throw;
        throw Error(ErrorCode::usage, e.where(), e.message(), e.remedy());
    }
}

bool is_project(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension)
        c = char(std::tolower(static_cast<unsigned char>(c)));
    return extension == ".facetmill" || extension == ".json";
}

/// The surface of what is left, no finer than a picture shows.
StockPatches cut_stock(const StockSolid& solid, const std::vector<VerifyProgram>& programs,
                       const Verification& verification, const Progress& progress) {
    constexpr double max_triangles = 1.5e6, triangles_per_square = 2.4; // of the lattice
    const Vec3 s = solid.box.size();
    const double area = 2 * (s.x() * s.y() + s.y() * s.z() + s.z() * s.x());
    const double coarsest = std::sqrt(triangles_per_square * area / max_triangles);
    if (verification.used.resolution < coarsest) {
        StockPlayback again(solid, programs, coarsest, progress);
        again.go_to(double(again.motion_count()), progress.part(0.0, 0.8));
        return again.patches(progress.part(0.8, 1.0));
    }
    const StockSurface surface(verification.stock->lattice());
    StockPatches patches(surface.patch_count());
    parallel_for(patches.size(), 1, progress,
                 [&](std::size_t k) { patches[k] = surface.patch(*verification.stock, k); });
    return patches;
}

void print_picture(const Picture& picture, const Arguments& arguments, Session& session) {
    OutputFile file(arguments.value("-o"));
    file.write(encode_png(picture));
    file.close_stream();
    Json out;
    out["file"] = printable(arguments.value("-o"), 400);
    out["width"] = picture.width;
    out["height"] = picture.height;
    session.print(pretty_json(out));
    file.commit();
}

/// The first operation with configuration spaces, or the one that is named.
std::string cspace_operation(const Project& project, const std::string& name) {
    if (!name.empty()) return name;
    for (const auto& operation : project.operations)
        if (manual_posture_list.is_in(*operation)) return operation->common().name;
    throw Error(ErrorCode::empty_result, "--show cspace", "the project has no operation of kind finish5",
                "add one, or show something else");
}

void render_cspace(const Arguments& arguments, Session& session) {
    const std::string input = arguments.operand(0);
    CSpaceRequest request;
    const PictureSize size =
        as_usage([&] { return parse_picture_size(arguments.value("--size", "1200x900"), "--size"); });
    request.width = size.width;
    request.height = size.height;
    if (!is_project(input))
        throw Error(ErrorCode::usage, "--show cspace", "a mesh has no operations", "give a project");
    use_threads(arguments);
    const Project project = asked_setup(arguments, load_project(input), false);
    keep_inputs(project, arguments.value("-o"));
    const std::string name = cspace_operation(project, arguments.value("--op"));
    const Progress progress = session.progress();
    SetupPlanners planners;
    Planner& planner = ready_planner(planners, project, arguments, session, progress.part(0.0, 0.2));
    const auto plan = plan_project(planner, project, name, arguments, session, progress.part(0.2, 0.7));
    const auto record = plan->operations.front()->path.five_axis();
    if (!record)
        throw Error(ErrorCode::out_of_range, "operation '" + printable(name) + "'",
                    "has no configuration spaces: its tool axes do not turn",
                    "name an operation of kind finish5");
    const std::size_t number =
        arguments.has("--point") ? point_number(arguments.value("--point")) : record->points.size() / 2;
    const FiveAxisStudy study(record, progress.part(0.7, 0.75, "Configuration space"));
    const FiveAxisStudy::Point point = study.point(number, progress.part(0.75, 0.95));
    request.content = CSpaceContent::of(point);
    request.unit = project.unit;
    request.title = name + " \u00b7 point " + std::to_string(number);
    request.subtitle = "Configuration space, pass " + std::to_string(record->line_of(number).drive + 1) + ", "
                       + std::to_string(request.content.free_nodes) + " of "
                       + std::to_string(request.content.block.size()) + " postures free";
    print_picture(render_cspace(request), arguments, session);
}

/// What a picture of a project shows: planned, or of CL files or posted programs, and verified where its
/// layers ask for that.
PlanResult shown_project(const Arguments& arguments, const Project& project, RenderRequest& request,
                         Session& session, const Progress& all) {
    SetupPlanners planners;
    Planner& planner = ready_planner(planners, project, arguments, session, all.part(0.0, 0.3));
    const Progress progress = all.part(0.3, 1.0);
    PlanResult result;
    const auto wants = [&](std::initializer_list<Layer> layers) {
        return std::find_first_of(request.layers.begin(), request.layers.end(), layers.begin(), layers.end())
               != request.layers.end();
    };
    const bool verifies = wants({Layer::deviation, Layer::findings});
    const std::vector<std::string> cl_files = arguments.values("--cl");
    const std::vector<std::filesystem::path> nc_files = posted_files(arguments);
    const bool planned = cl_files.empty() && nc_files.empty();
    if (planned && !verifies && !wants({Layer::cc, Layer::cl, Layer::strips, Layer::tool})) {
        result.part = planner.prepare(project, progress);
        result.stock = stock_solid(project.stock, *result.part);
        return result;
    }
    const Progress planning = progress.part(0.0, verifies ? 0.5 : 1.0);
    std::vector<VerifyProgram> programs;
    VerifySettings settings;
    if (planned) {
        const auto plan =
            plan_project(planner, project, arguments.value("--op"), arguments, session, planning);
        result = *plan;
        programs = verify_programs(project, plan);
        settings = verify_settings(project, plan.get());
    } else {
        result.part = planner.prepare(project, planning.part(0.0, 0.5));
        result.stock = stock_solid(project.stock, *result.part);
        const Progress opening = planning.part(0.5, 1.0);
        OpenedProgram opened =
            nc_files.empty()
                ? open_program(project, {cl_files.begin(), cl_files.end()}, opening)
                : open_posted(project, *result.part, asked_post(arguments, project), nc_files, opening);
        result.operations = std::move(opened.operations);
        programs = std::move(opened.programs);
        stand_fixtures(programs, *result.part);
        settings = verify_settings(project, nullptr);
    }
    if (!verifies) return result;
    const Progress verifying = progress.part(0.5, 1.0);
    // A picture shows no more; of colours that are finer than the tolerance it does.
    settings.max_samples = request.half_done ? 2'500'000 : 400'000;
    tell_work(settings, arguments, session);
    request.verification = std::make_shared<const Verification>(
        verify(*result.part->mesh, result.stock, programs, settings, verifying.part(0.0, 0.9)));
    // It would hide the colours.
    if (wants({Layer::stock}) && !wants({Layer::deviation}))
        request.cut_stock = cut_stock(result.stock, programs, *request.verification,
                                      verifying.part(0.9, 1.0, "Making the stock's surface"));
    return result;
}

/// Size, eye and colours.
void take_looks(RenderRequest& request, const Arguments& arguments) {
    const std::string view = arguments.value("--view", "iso");
    if (view.find(',') != std::string::npos)
        request.toward_eye = as_usage([&] { return parse_eye(view, "--view"); });
    else
        request.view = as_usage([&] { return parse_view(view, "--view"); });
    const PictureSize size =
        as_usage([&] { return parse_picture_size(arguments.value("--size", "1200x900"), "--size"); });
    request.width = size.width;
    request.height = size.height;
    request.perspective = arguments.has("--perspective");
    if (arguments.has("--dark")) request.palette = Palette::dark;
    if (!arguments.has("--half-done")) return;
    const double share = arguments.number("--half-done", 0.5);
    if (!(share >= 0 && share <= 1))
        throw Error(ErrorCode::usage, "--half-done",
                    "'" + printable(arguments.value("--half-done")) + "' is no share",
                    "give a number from 0 to 1");
    request.half_done = share;
}

/// Colours of deviations finer or coarser than those of the tolerance: from half of `scale` missing to all of
/// it standing.
void take_scale(RenderRequest& request, const Arguments& arguments, LengthUnit unit) {
    if (!arguments.has("--scale")) return;
    const double scale = arguments.number("--scale", 1) * mm_per(unit);
    if (!(scale > 0 && std::isfinite(scale)))
        throw Error(ErrorCode::usage, "--scale",
                    "'" + printable(arguments.value("--scale")) + "' is no length", "give a length above 0");
    constexpr double within = 1.0 / 8; // of the scale, all of one green
    request.deviation_scale = DeviationScale{-0.5 * scale, scale, within * scale, within * scale};
}

void run_render(const Arguments& arguments, Session& session) {
    if (arguments.value("--show") == "cspace") return render_cspace(arguments, session);
    if (arguments.has("--cl") && arguments.has("--op"))
        throw Error(ErrorCode::usage, "--op", "CL files are shown instead of a plan", "give --cl or --op");
    if (arguments.has("--point"))
        throw Error(ErrorCode::usage, "--point", "is for --show cspace", "leave it out");
    const std::string input = arguments.operand(0);
    RenderRequest request;
    take_looks(request, arguments);
    const bool project_given = is_project(input);
    const std::string fallback = project_given ? "part,stock,cl" : "part";
    request.layers =
        as_usage([&] { return parse_picture_layers(arguments.value("--show", fallback), "--show"); });
    const MeshReading reading = asked_reading(arguments);
    use_threads(arguments);

    refuse_to_overwrite(input, arguments.value("-o"));
    const Progress progress = session.progress();
    if (project_given) {
        if (arguments.has("--units"))
            throw Error(ErrorCode::usage, "--units", "a project states its units", "leave --units out");
        refuse_reading_options(arguments);
        const bool read_back = arguments.has("--cl") || arguments.has("--nc");
        const Project project = asked_setup(arguments, load_project(input), read_back);
        keep_inputs(project, arguments.value("-o"));
        for (const std::string& file : arguments.values("--cl"))
            refuse_to_overwrite(file, arguments.value("-o"));
        for (const std::filesystem::path& file : posted_files(arguments))
            refuse_to_overwrite(file, arguments.value("-o"));
        const PlanResult result =
            shown_project(arguments, project, request, session, progress.part(0.0, 0.6));
        take_plan(request, project, result);
        take_scale(request, arguments, project.unit);
    } else {
        for (const char* option : {"--op", "--cl", "--nc"})
            if (arguments.has(option))
                throw Error(ErrorCode::usage, option, "a mesh has no operations", "give a project");
        const LoadedMesh loaded = load_mesh(input, reading, progress.part(0.0, 0.5, "Reading the part"));
        request.part = loaded.mesh;
        request.unit = project_unit(loaded.report.assumed_unit);
        request.title = std::filesystem::path(input).filename().string();
    }
    const Picture picture = render_picture(request, progress.part(0.6, 0.95, "Drawing"));
    progress.check();
    print_picture(picture, arguments, session);
}

#else

void run_render(const Arguments&, Session&) {
    throw Error(ErrorCode::unsupported_format, "render", "this facetmill-cli was built without pictures",
                "build with -DFACETMILL_VIZ=ON");
}

#endif

} // namespace

Command render_command() {
    return {
        .name = "render",
        .operands = {"PROJECT|PART"},
        .summary = "Draws a picture (PNG) without a display.",
        .help =
            "Layers of --show: part, stock, cc, cl, strips, tool, edges, deviation, findings. Paths are "
            "planned "
            "first, and\n"
            "verified for deviation and findings; with findings, and without deviation, stock is what is "
            "left of "
            "it. cspace,\n"
            "alone: the configuration space of a contact point (--op and --point; else of the first finish5, "
            "the one\n"
            "in the middle). Of several setups the one of --setup or --op is shown, else the first. Views: "
            "iso, front, top, right, rear, bottom, left, or two angles.",
        .options = with_reading_options(
            {{.name = "--view",
              .value = "VIEW",
              .help = "where to look from (default: iso); or degrees from X towards Y and above the level, "
                      "like -60,25"},
             {.name = "--perspective", .help = "what is nearer is larger; without a scale bar"},
             {.name = "--dark", .help = "on a dark ground"},
             {.name = "--half-done",
              .value = "SHARE",
              .help = "the last operation at this share of its cuts, 0 to 1: deviations behind the tool, the "
                      "cuts ahead"},
             {.name = "--scale",
              .value = "LENGTH",
              .help = "colours of deviations up to this much left (default: by the tolerance)"},
             {.name = "--show",
              .value = "LAYERS",
              .help = "what to draw (default: part, of a project part,stock,cl)"},
             {.name = "--size", .value = "WxH", .help = "pixels (default: 1200x900)"},
             {.name = "--op", .value = "NAME", .help = "plans and shows only this operation"},
             setup_option(),
             {.name = "--cl",
              .value = "FILE" + apt_writer().extension,
              .help = "shows this file instead of a plan, without planning; more than one in order",
              .repeated = true},
             nc_option(),
             post_option(),
             {.name = "--point",
              .value = "I",
              .help = "with --show cspace: number of the contact point, from 0"},
             {.name = "--units",
              .value = "UNIT",
              .help = "unit of a mesh file's numbers: mm, cm, m, in, ft (default: mm)"},
             threads_option(),
             large_option(),
             {.name = "-o", .value = "FILE.png", .help = "the file to write", .required = true}}),
        .run = run_render,
        .draws = true};
}

} // namespace facetmill::cli
