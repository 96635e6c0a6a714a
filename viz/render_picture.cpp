#include "viz/render_picture.h"

#include "viz/half_done.h"
#include "viz/offscreen.h"
#include "viz/strip_display.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace facetmill {

namespace {

/// "12 345", as the workbench writes it.
std::string grouped(std::size_t n) {
    std::string text = std::to_string(n);
    for (int i = int(text.size()) - 3; i > 0; i -= 3)
        text.insert(std::size_t(i), "\u00a0");
    return text;
}

std::string size_text(const MeshPtr& part, LengthUnit unit) {
    const Vec3 size = part->box().size() / mm_per(unit);
    return format_number(size.x(), 4) + " \u00d7 " + format_number(size.y(), 4) + " \u00d7 "
           + format_number(size.z(), 4) + " " + std::string(unit_name(unit)) + " \u00b7 "
           + grouped(part->facet_count()) + (part->facet_count() == 1 ? " facet" : " facets");
}

/// The cut in the middle of the last operation that cuts.
std::optional<CutterLocation> middle_cut(const RenderRequest& request) {
    for (auto it = request.operations.rbegin(); it != request.operations.rend(); ++it) {
        const auto& motions = (*it)->program.motions.motions;
        const auto is_cut = [](const Motion& m) { return m.kind == MotionKind::cut; };
        const auto cuts = std::count_if(motions.begin(), motions.end(), is_cut);
        auto left = cuts / 2;
        for (const Motion& m : motions)
            if (is_cut(m) && left-- == 0) return m.to;
    }
    return std::nullopt;
}

/// What is up on the screen as one looks: Z, or Y from straight above.
Vec3 upright_for(const Vec3& toward_eye) {
    constexpr double straight = 0.9999;
    return std::abs(toward_eye.z()) < straight ? Vec3(Vec3::UnitZ()) : Vec3(Vec3::UnitY());
}

std::string trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

} // namespace

void take_plan(RenderRequest& request, const Project& project, const PlanResult& plan) {
    if (plan.part) request.part = plan.part->mesh;
    if (plan.part) request.fixtures = plan.part->fixtures;
    request.stock = plan.stock;
    request.operations = plan.operations;
    request.unit = project.unit;
    request.title = project.path.empty() ? project.part_path().stem().string() : project.path.stem().string();
    request.tool.reset();
    if (plan.operations.empty()) return;
    if (plan.operations.size() == 1) request.title += " \u00b7 " + plan.operations.front()->name;
    const long number = plan.operations.back()->program.tool_number;
    for (const Tool& tool : project.tools)
        if (tool.number == number) request.tool = tool;
}

namespace {

bool wants(const RenderRequest& request, Layer layer) {
    return std::find(request.layers.begin(), request.layers.end(), layer) != request.layers.end();
}

void show_paths(Scene& scene, const RenderRequest& request, const Progress& progress) {
    if (wants(request, Layer::cc) || wants(request, Layer::cl)) {
        std::vector<PathSource> sources;
        for (const auto& operation : request.operations)
            sources.push_back(path_source(operation));
        scene.paths().set(prepare_path_display(std::move(sources), progress.part(0.4, 0.6)));
    }
    if (!wants(request, Layer::tool)) return;
    scene.tool().set(request.tool);
    scene.tool().set_pose(request.pose ? request.pose : middle_cut(request));
}

/// The last operation alone: what came before it is under its colours.
void show_half_done(Scene& scene, const RenderRequest& request, const DeviationDisplayPtr& deviation,
                    const Progress& progress) {
    if (!deviation || request.operations.empty())
        throw Error(ErrorCode::empty_result, "--half-done", "there are no deviations",
                    "show the layer deviation of a project with an operation");
    HalfDone half = half_done(request.operations.back(), *deviation->surface, *request.half_done,
                              progress.part(0.4, 0.5));
    auto shown = std::make_shared<DeviationDisplay>(*deviation);
    shown->shown = std::move(half.done);
    scene.deviation().set(std::move(shown));
    scene.tool().set(request.tool);
    scene.tool().set_pose(half.pose);
    // Of the path what makes the surface: the ways there would be a knot of lines over it.
    for (const MotionKind kind :
         {MotionKind::rapid, MotionKind::approach, MotionKind::link, MotionKind::retract})
        scene.paths().set_visible(kind, false);
    scene.paths().set(prepare_path_display({half.ahead}, progress.part(0.5, 0.6)));
}

/// The part as large as it may be while the tool is in the picture: a box around both would be much larger
/// than either.
void fit_half_done(Scene& scene) {
    scene.fit();
    SceneCamera& camera = scene.camera();
    const Eigen::Vector2i size = camera.window_size();
    const Box3 tool = scene.tool().bounds();
    const double margin = 0.02 * size.y();
    const auto inside = [&] {
        for (int corner = 0; corner < 8; ++corner) {
            const Vec2 at = camera.display_of({corner & 1 ? tool.hi.x() : tool.lo.x(),
                                               corner & 2 ? tool.hi.y() : tool.lo.y(),
                                               corner & 4 ? tool.hi.z() : tool.lo.z()});
            if (at.x() < margin || at.y() < margin || at.x() > size.x() - margin
                || at.y() > size.y() - margin)
                return false;
        }
        return true;
    };
    constexpr double step = 0.97;
    for (int tries = 0; tries < 40 && !tool.empty() && !inside(); ++tries)
        camera.zoom_at(0.5 * size.x(), size.y(), step); // from the lower edge: tools reach upward
}

} // namespace

Picture render_picture(const RenderRequest& request, const Progress& progress) {
    check_picture_size(request.width, request.height, "--size");
    const auto wanted = [&](Layer layer) { return wants(request, layer); };
    Scene scene;
    scene.set_palette(request.palette);
    scene.set_unit(request.unit);
    scene.part().set_style(request.part_style);
    if (request.part) scene.part().set(prepare_part_display(request.part, progress.part(0.0, 0.4)));
    scene.stock().set(make_stock_shape(request.stock, progress));
    scene.stock().set_cut(request.cut_stock);
    scene.fixtures().set(request.fixtures);
    DeviationDisplayPtr deviation;
    if (wanted(Layer::deviation) && request.verification && request.verification->surface)
        deviation = prepare_deviation_display(
            request.verification->surface,
            request.deviation_scale.value_or(default_scale(*request.verification, request.unit)),
            progress.part(0.4, 0.4));
    if (request.half_done) {
        show_half_done(scene, request, deviation, progress);
    } else {
        scene.deviation().set(deviation);
        show_paths(scene, request, progress);
    }
    if (wanted(Layer::findings) && request.verification)
        scene.findings().set(finding_marks(*request.verification));
    if (wanted(Layer::strips)) {
        std::vector<Strip> strips;
        for (const auto& operation : request.operations)
            strips.insert(strips.end(), operation->path.strips.begin(), operation->path.strips.end());
        scene.strips().set(prepare_strip_display(strips, request.unit, progress));
    }
    for (const Layer layer : {Layer::part, Layer::edges, Layer::stock, Layer::deviation, Layer::findings,
                              Layer::strips, Layer::cc, Layer::cl, Layer::tool}) {
        scene.set_visible(layer, wanted(layer));
        if (layer == Layer::findings || layer == Layer::strips) continue; // none is a good answer
        if (wanted(layer) && !scene.has(layer)) {
            const bool planned = layer == Layer::cc || layer == Layer::cl || layer == Layer::tool;
            throw Error(ErrorCode::empty_result, "--show " + std::string(layer_name(layer)),
                        "there is nothing to show",
                        layer == Layer::deviation ? "give a project whose operations can be verified"
                        : planned                 ? "give a project with an operation"
                                                  : "give a part, or a project with stock");
        }
    }
    std::string subtitle = request.subtitle;
    if (subtitle.empty() && request.part) subtitle = size_text(request.part, request.unit);
    if (request.half_done) subtitle += " \u00b7 behind the tool what is left, ahead what is to be cut";
    scene.set_title(request.title, subtitle);
    progress.set(0.6);
    OffscreenWindow window;
    window.show(scene, request.width, request.height);
    scene.set_view(request.view);
    scene.camera().set_perspective(request.perspective);
    if (request.toward_eye) {
        CameraPlace place = scene.camera().place();
        place.toward_eye = *request.toward_eye;
        place.up = upright_for(place.toward_eye);
        scene.camera().look_at(place);
    }
    if (request.half_done)
        fit_half_done(scene);
    else
        scene.fit(wanted(Layer::tool));
    progress.set(0.7);
    Picture picture = window.render();
    progress.set(1.0);
    return picture;
}

Picture render_cspace(const CSpaceRequest& request) {
    check_picture_size(request.width, request.height, "--size");
    CSpaceScene scene;
    scene.set_palette(request.palette);
    scene.set_unit(request.unit);
    scene.set_title(request.title, request.subtitle);
    scene.set_content(std::make_shared<const CSpaceContent>(request.content));
    OffscreenWindow window;
    window.show(scene, request.width, request.height);
    scene.reset_view();
    return window.render();
}

std::vector<Layer> parse_picture_layers(std::string_view text, const std::string& where) {
    static constexpr Layer known[] = {Layer::part,      Layer::stock,    Layer::cc,
                                      Layer::cl,        Layer::tool,     Layer::edges,
                                      Layer::deviation, Layer::findings, Layer::strips};
    std::vector<Layer> layers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string word = trimmed(text.substr(begin, end - begin));
        begin = end + 1;
        if (word == "cspace")
            throw Error(ErrorCode::unsupported_format, where, "'cspace' is a picture of its own",
                        "show it without other layers");
        const auto* layer =
            std::find_if(std::begin(known), std::end(known), [&](Layer l) { return layer_name(l) == word; });
        if (layer == std::end(known))
            throw Error(ErrorCode::out_of_range, where, "unknown layer '" + printable(word) + "'",
                        "show part, stock, cc, cl, strips, tool, edges or deviation, separated by commas");
        if (std::find(layers.begin(), layers.end(), *layer) == layers.end()) layers.push_back(*layer);
    }
    return layers;
}

Vec3 parse_eye(std::string_view text, const std::string& where) {
    const std::size_t comma = text.find(',');
    const auto number = [&](std::string_view digits) {
        const std::string word = trimmed(digits);
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size() || !(std::abs(value) <= 360))
            throw Error(ErrorCode::out_of_range, where, "'" + printable(text) + "' is no direction",
                        "give AZIMUTH,ELEVATION in degrees, like -60,25");
        return radians(value);
    };
    const double azimuth = number(text.substr(0, comma));
    const double elevation = number(comma == std::string_view::npos ? "" : text.substr(comma + 1));
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)};
}

PictureSize parse_picture_size(std::string_view text, const std::string& where) {
    const auto bad = [&]() -> Error {
        return {ErrorCode::out_of_range, where, "'" + printable(text) + "' is not a size in pixels",
                "give WIDTHxHEIGHT, like 1200x900"};
    };
    const std::size_t x = text.find_first_of("xX");
    if (x == std::string_view::npos) throw bad();
    const auto side = [&](std::string_view digits) {
        int value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc() || end != digits.data() + digits.size()) throw bad();
        return value;
    };
    const PictureSize size{side(text.substr(0, x)), side(text.substr(x + 1))};
    check_picture_size(size.width, size.height, where);
    return size;
}

} // namespace facetmill
