#include "viz/scene_repair.h"

#include "viz/overlay.h"
#include "viz/poly_data.h"

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <utility>

namespace facetmill {

namespace {

void set_pieces(ScenePieces& pieces, SceneStage& stage, const PartDisplayPtr& part) {
    if (part && !part->triangles.empty())
        pieces.set(stage, triangle_pieces(part->points, part->normals, part->triangles, elements_in_piece),
                   part->center);
    else
        pieces.set(stage, {}, Vec3::Zero());
}

void set_coarse(SceneActor& actor, const PartDisplayPtr& part) {
    if (part && !part->preview.triangles.empty())
        actor.set_data(triangle_data(part->preview.points, part->preview.normals, part->preview.triangles),
                       part->center);
    else
        actor.clear();
}

/// As dull as a colour that means something has to be, so that it is found in the legend.
void make_dull(const ScenePieces& pieces) {
    vtkProperty* look = pieces.first.property();
    look->SetAmbient(0.35);
    look->SetDiffuse(0.65);
    look->SetSpecular(0);
}

} // namespace

void SceneRepair::Lines::set(const std::vector<ClosedCurve>& curves) {
    clear();
    points.clear();
    segments.clear();
    Box3 box;
    for (const ClosedCurve& curve : curves)
        for (const Vec3& p : curve)
            box.add(p);
    if (box.empty()) return;
    const Vec3 center = box.center();
    for (const ClosedCurve& curve : curves) {
        const auto first = std::int32_t(points.size() / 3), n = std::int32_t(curve.size());
        for (const Vec3& p : curve)
            for (int k = 0; k < 3; ++k)
                points.push_back(float(p[k] - center[k]));
        for (std::int32_t i = 0; i < n; ++i)
            segments.insert(segments.end(), {first + i, first + (i + 1) % n});
    }
    set_data(segment_data(points, segments), center);
}

SceneRepair::SceneRepair(SceneStage& stage) : SceneLayer(stage) {
    for (ScenePieces* pieces : {&before_, &kept_, &added_, &removed_})
        add_actor(pieces->first);
    for (SceneActor* a : {&before_preview_, &kept_preview_, &before_lines_})
        add_actor(*a);
    for (Lines* lines : {&left_, &filled_, &chosen_}) {
        add_actor(*lines);
        lines->unlit();
    }
    for (const ScenePieces* pieces : {&kept_, &added_, &removed_})
        make_dull(*pieces);
    vtkProperty* look = before_.first.property();
    look->SetAmbient(0.10);
    look->SetDiffuse(0.90);
    before_.first.actor->SetBackfaceProperty(vtkSmartPointer<vtkProperty>::New());
    before_preview_.actor->SetProperty(look);
    before_preview_.actor->SetBackfaceProperty(before_.first.actor->GetBackfaceProperty());
    kept_preview_.actor->SetProperty(kept_.first.property());
    // What goes lies in the very places of what is there before.
    removed_.first.mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(0, -20);
    before_lines_.unlit();
    before_lines_.nearer(36);
    left_.nearer(44);
    filled_.nearer(44);
    chosen_.nearer(60);
}

void SceneRepair::set(RepairDisplayPtr display) {
    if (display == display_) return;
    // The arrays stay until the actors have others.
    const RepairDisplayPtr old = std::exchange(display_, std::move(display));
    static const RepairDisplay none{};
    const RepairDisplay& d = display_ ? *display_ : none;
    data_.clear();
    set_pieces(before_, stage_, d.before);
    set_pieces(added_, stage_, d.added);
    set_pieces(removed_, stage_, d.removed);
    set_coarse(before_preview_, d.before);
    set_coarse(kept_preview_, d.kept);
    before_lines_.clear();
    if (d.before && !d.before->lines.empty())
        before_lines_.set_data(segment_data(d.before->points, d.before->lines), d.before->center);
    const bool colored = moves();
    kept_.first.mapper->SetScalarVisibility(colored);
    kept_preview_.mapper->SetScalarVisibility(colored);
    if (d.kept && !d.kept->triangles.empty()) {
        data_ = triangle_pieces(d.kept->points, d.kept->normals, d.kept->triangles, elements_in_piece);
        kept_.set(stage_, data_, d.kept->center);
        if (colored) set_point_colors(data_, d.colors);
    } else {
        kept_.set(stage_, {}, Vec3::Zero());
    }
    if (colored && kept_preview_.filled)
        set_point_colors({vtkSmartPointer<vtkPolyData>(kept_preview_.mapper->GetInput())}, d.preview_colors);
}

void SceneRepair::set_after(bool after) {
    after_ = after;
}

void SceneRepair::set_holes(const std::vector<ClosedCurve>& left, const std::vector<ClosedCurve>& filled) {
    left_.set(left);
    filled_.set(filled);
}

void SceneRepair::set_chosen(const std::vector<ClosedCurve>& curves) {
    chosen_.set(curves);
}

bool SceneRepair::has(Layer layer) const {
    return layer == Layer::part && display_;
}

void SceneRepair::apply_palette(const Colors& colors) {
    before_.first.color(colors.part);
    vtkProperty* back = before_.first.actor->GetBackfaceProperty();
    back->DeepCopy(before_.first.property());
    back->SetColor(colors.part_back.r, colors.part_back.g, colors.part_back.b);
    before_lines_.color(colors.feature_edges);
    kept_.first.color(colors.part);
    added_.first.color(colors.new_surface);
    removed_.first.color(colors.taken_away);
    left_.color(colors.hole);
    filled_.color(colors.new_surface_line);
    chosen_.color(colors.marker);
}

void SceneRepair::apply_line_widths() {
    before_lines_.set_line_width(1.1 * stage_.ratio);
    left_.set_line_width(2.2 * stage_.ratio);
    filled_.set_line_width(2.2 * stage_.ratio);
    chosen_.set_line_width(4 * stage_.ratio);
}

void SceneRepair::apply_visibility(ShownSurface shown) {
    const bool own = shown == ShownSurface::repair, before = own && !after_, after = own && after_;
    const auto show = [&](ScenePieces& pieces, SceneActor& preview, bool on) {
        const bool coarse = stage_.moving && preview.filled;
        pieces.show(on && !coarse);
        preview.show(on && coarse);
    };
    show(before_, before_preview_, before);
    show(kept_, kept_preview_, after);
    added_.show(after);
    removed_.show(before);
    before_lines_.show(before);
    left_.show(true);
    filled_.show(true);
    chosen_.show(true);
}

bool SceneRepair::has_preview() const {
    return before_preview_.filled || kept_preview_.filled;
}

void SceneRepair::add_bounds(Box3& box) const {
    if (!covers()) return;
    for (const PartDisplayPtr& part : {display_->before, display_->kept, display_->added})
        if (part) box.add(part->box);
}

void SceneRepair::add_known(KnownBoxes& known) const {
    if (!display_) return;
    if (!before_.first.shown() && !kept_.first.shown() && !added_.first.shown()) return;
    add_bounds(known.box);
    for (const ScenePieces* pieces : {&before_, &kept_, &added_, &removed_})
        pieces->add_to(known.actors);
}

void SceneRepair::add_heavy(HeavyActors& heavy) {
    for (ScenePieces* pieces : {&before_, &kept_, &added_, &removed_})
        pieces->add_to(heavy.surfaces);
    heavy.lines.push_back(&before_lines_);
}

void SceneRepair::add_legend(std::vector<LegendEntry>& entries, ShownSurface shown) const {
    const Colors& colors = colors_of(stage_.palette);
    using Sample = LegendEntry::Sample;
    if (shown == ShownSurface::repair && after_ && added_.first.filled)
        entries.push_back({Sample::surface, colors.new_surface, 1, "New surface"});
    if (shown == ShownSurface::repair && after_ && !moves())
        entries.push_back({Sample::surface, colors.part, 1, "Not moved"});
    if (shown == ShownSurface::repair && !after_ && removed_.first.filled)
        entries.push_back({Sample::surface, colors.taken_away, 1, "Taken away"});
    if (filled_.filled) entries.push_back({Sample::line, colors.new_surface_line, 2.2, "Hole, to be filled"});
    if (left_.filled) entries.push_back({Sample::line, colors.hole, 2.2, "Hole, left open"});
}

void SceneRepair::add_color_bars(std::vector<ColorBar>& bars, ShownSurface shown) const {
    if (shown != ShownSurface::repair || !after_ || !moves()) return;
    ColorBar bar;
    bar.title = "Moved (" + std::string(unit_name(stage_.unit)) + ")";
    const DeviationScale& s = display_->scale;
    constexpr int steps = 160;
    for (int i = 0; i < steps; ++i)
        bar.colors.push_back(deviation_color(s, s.low + (s.high - s.low) * (i + 0.5) / steps));
    for (const ScaleMark& m : scale_marks(s, stage_.unit, 0.12))
        bar.marks.emplace_back((m.value - s.low) / (s.high - s.low), m.label);
    bar.low_text = "inward";
    bar.high_text = "outward";
    bars.push_back(std::move(bar));
}

} // namespace facetmill
