#include "viz/scene_findings.h"

#include "core/verify/verify.h"
#include "viz/overlay.h"
#include "viz/poly_data.h"

#include <vtkProperty.h>

#include <algorithm>
#include <utility>

namespace facetmill {

using Kind = FindingMark::Kind;

std::vector<FindingMark> finding_marks(const Verification& verification) {
    constexpr std::size_t max_collisions = 400; // more of them say no more
    std::vector<FindingMark> marks;
    for (const DeviationExtreme& e : verification.gouges)
        marks.push_back({Kind::gouge, e.point});
    for (const DeviationExtreme& e : verification.excess)
        marks.push_back({Kind::excess, e.point});
    const std::size_t n = verification.collisions.size(), stride = n / max_collisions + 1;
    for (std::size_t i = 0; i < n; i += stride)
        marks.push_back({Kind::collision, verification.collisions[i].place});
    return marks;
}

SceneFindings::SceneFindings(SceneStage& stage) : SceneLayer(stage) {
    for (auto& a : dots_) {
        add_actor(a);
        a.unlit();
        a.property()->SetRenderPointsAsSpheres(true);
    }
}

void SceneFindings::set(const std::vector<FindingMark>& findings) {
    const auto old = std::exchange(points_, {}); // they stay until the actors have others
    for (const FindingMark& f : findings)
        for (Eigen::Index k = 0; k < 3; ++k)
            points_[std::size_t(f.kind)].push_back(float(f.point[k]));
    for (std::size_t k = 0; k < finding_kinds; ++k)
        dots_[k].set_data(dot_data(points_[k]), Vec3::Zero());
}

bool SceneFindings::has(Layer layer) const {
    return layer == Layer::findings
           && std::any_of(dots_.begin(), dots_.end(), [](const SceneActor& a) { return a.filled; });
}

void SceneFindings::apply_palette(const Colors& colors) {
    dots_[std::size_t(Kind::gouge)].color(colors.gouge);
    dots_[std::size_t(Kind::excess)].color(colors.excess);
    dots_[std::size_t(Kind::collision)].color(colors.collision);
}

void SceneFindings::apply_line_widths() {
    for (auto& a : dots_)
        a.set_point_size(10 * stage_.line_ratio());
}

void SceneFindings::apply_visibility(ShownSurface) {
    for (auto& a : dots_)
        a.show(stage_.on(Layer::findings));
}

void SceneFindings::add_legend(std::vector<LegendEntry>& entries, ShownSurface) const {
    const auto found = [&](Kind kind, const Rgb& color, const char* label) {
        if (stage_.on(Layer::findings) && dots_[std::size_t(kind)].filled)
            entries.push_back({LegendEntry::Sample::spot, color, 1, label});
    };
    const Colors& colors = colors_of(stage_.palette);
    found(Kind::gouge, colors.gouge, "Deepest gouges");
    found(Kind::collision, colors.collision, "Collisions");
    found(Kind::excess, colors.excess, "Largest excess");
}

void SceneFindings::rehearse(std::size_t k, SceneRehearsal& rehearsal) {
    if (k == 6) rehearsal.dots(dots_.front());
}

} // namespace facetmill
