#include "viz/render_picture.h"

#include "viz/offscreen.h"
#include "viz/strip_display.h"

#include <algorithm>
#include <charconv>

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

Picture render_picture(const RenderRequest& request, const Progress& progress) {
    check_picture_size(request.width, request.height, "--size");
    const auto wanted = [&](Layer layer) {
        return std::find(request.layers.begin(), request.layers.end(), layer) != request.layers.end();
    };
    Scene scene;
    scene.set_palette(request.palette);
    scene.set_unit(request.unit);
    scene.part().set_style(request.part_style);
    if (request.part) scene.part().set(prepare_part_display(request.part, progress.part(0.0, 0.4)));
    scene.stock().set(make_stock_shape(request.stock, progress));
    scene.stock().set_cut(request.cut_stock);
    scene.fixtures().set(request.fixtures);
    if (wanted(Layer::deviation) && request.verification && request.verification->surface)
        scene.deviation().set(prepare_deviation_display(
            request.verification->surface,
            request.deviation_scale.value_or(default_scale(*request.verification, request.unit)),
            progress.part(0.4, 0.4)));
    if (wanted(Layer::findings) && request.verification)
        scene.findings().set(finding_marks(*request.verification));
    if (wanted(Layer::strips)) {
        std::vector<Strip> strips;
        for (const auto& operation : request.operations)
            strips.insert(strips.end(), operation->path.strips.begin(), operation->path.strips.end());
        scene.strips().set(prepare_strip_display(strips, request.unit, progress));
    }
    if (wanted(Layer::cc) || wanted(Layer::cl)) {
        std::vector<PathSource> sources;
        for (const auto& operation : request.operations)
            sources.push_back(path_source(operation));
        scene.paths().set(prepare_path_display(std::move(sources), progress.part(0.4, 0.6)));
    }
    if (wanted(Layer::tool)) {
        scene.tool().set(request.tool);
        scene.tool().set_pose(request.pose ? request.pose : middle_cut(request));
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
    scene.set_title(request.title, request.subtitle.empty() && request.part
                                       ? size_text(request.part, request.unit)
                                       : request.subtitle);
    progress.set(0.6);
    OffscreenWindow window;
    window.show(scene, request.width, request.height);
    scene.set_view(request.view);
    if (wanted(Layer::tool)) scene.fit(true);
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
