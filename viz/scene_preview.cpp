#include "viz/scene_preview.h"

#include "viz/overlay.h"
#include "viz/poly_data.h"

#include <sstream>
#include <utility>

namespace facetmill {

namespace {

constexpr double preview_width = 1.3;

} // namespace

ScenePreview::ScenePreview(SceneStage& stage) : SceneLayer(stage) {
    add_actor(lines_);
    lines_.unlit();
    lines_.nearer(42);
}

void ScenePreview::set(PreviewDisplayPtr preview, const std::string& label) {
    const PreviewDisplayPtr old = std::exchange(preview_, std::move(preview)); // its arrays stay until then
    label_ = label;
    if (preview_ && !preview_->dashes.empty())
        lines_.set_data(polyline_data(preview_->dashes), preview_->center);
    else
        lines_.clear();
}

void ScenePreview::apply_palette(const Colors& colors) {
    lines_.color(colors.preview);
}

void ScenePreview::apply_line_widths() {
    lines_.set_line_width(preview_width * stage_.line_ratio());
}

void ScenePreview::apply_visibility(ShownSurface) {
    lines_.show(visible_);
}

void ScenePreview::add_legend(std::vector<LegendEntry>& entries, ShownSurface) const {
    if (!visible_ || label_.empty()) return;
    const Rgb& color = colors_of(stage_.palette).preview;
    auto sample = LegendEntry::Sample::dashes;
    std::istringstream lines(label_);
    for (std::string line; std::getline(lines, line);) {
        entries.push_back({sample, color, preview_width, line});
        sample = LegendEntry::Sample::none;
    }
}

} // namespace facetmill
