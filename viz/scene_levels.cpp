#include "viz/scene_levels.h"

#include "viz/overlay.h"
#include "viz/poly_data.h"

namespace facetmill {

SceneLevels::SceneLevels(SceneStage& stage) : SceneLayer(stage) {
    for (Frames* f : {&others_, &chosen_}) {
        add_actor(f->lines);
        f->lines.unlit();
    }
    others_.lines.nearer(38);
    chosen_.lines.nearer(42);
}

void SceneLevels::set(const std::optional<LevelMarks>& levels) {
    if (levels == levels_) return;
    levels_ = levels;
    for (Frames* f : {&others_, &chosen_}) {
        f->lines.clear();
        f->points.clear();
        f->segments.clear();
        if (levels) set(*f, *levels, f == &chosen_);
    }
}

void SceneLevels::set(Frames& frames, const LevelMarks& levels, bool chosen) {
    const Box3& box = levels.box;
    const Vec3 center = box.center();
    for (std::size_t i = 0; i < levels.heights.size(); ++i) {
        if ((levels.chosen == i) != chosen) continue;
        const auto first = std::int32_t(frames.points.size() / 3);
        for (const auto& [x, y] : {std::pair(box.lo.x(), box.lo.y()),
                                   {box.hi.x(), box.lo.y()},
                                   {box.hi.x(), box.hi.y()},
                                   {box.lo.x(), box.hi.y()}})
            for (const double v : {x - center.x(), y - center.y(), levels.heights[i] - center.z()})
                frames.points.push_back(float(v));
        for (std::int32_t c = 0; c < 4; ++c)
            frames.segments.insert(frames.segments.end(), {first + c, first + (c + 1) % 4});
    }
    if (!frames.segments.empty()) frames.lines.set_data(segment_data(frames.points, frames.segments), center);
}

void SceneLevels::apply_palette(const Colors& colors) {
    others_.lines.color(colors.stock);
    chosen_.lines.color(colors.marker);
}

void SceneLevels::apply_line_widths() {
    others_.lines.set_line_width(0.9 * stage_.line_ratio());
    chosen_.lines.set_line_width(2.4 * stage_.line_ratio());
}

void SceneLevels::apply_visibility(ShownSurface) {
    others_.lines.show(true);
    chosen_.lines.show(true);
}

void SceneLevels::add_legend(std::vector<LegendEntry>& entries, ShownSurface) const {
    const Colors& colors = colors_of(stage_.palette);
    if (others_.lines.filled) entries.push_back({LegendEntry::Sample::line, colors.stock, 1, "Layers"});
    if (chosen_.lines.filled)
        entries.push_back({LegendEntry::Sample::line, colors.marker, 2.4, "Layer chosen"});
}

} // namespace facetmill
