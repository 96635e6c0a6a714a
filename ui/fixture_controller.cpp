#include "ui/fixture_controller.h"

#include "ui/text.h"
#include "ui/viewport.h"

#include <QTimer>

#include <cmath>

namespace facetmill::ui {

namespace {

/// What places that were dragged to are rounded to, in mm and inch.
constexpr double drop_step_mm = 0.1, drop_step_inch = 0.005;

} // namespace

FixtureController::FixtureController(Document& document, Viewport& viewport, ProjectTree& tree,
                                     QObject* window)
    : Controller(window), document_(document), viewport_(viewport) {
    connect(&viewport_, &Viewport::fixture_picked, &tree, [&tree](std::size_t i) {
        tree.select({TreeNode::Kind::fixture, i});
    });
    connect(&viewport_, &Viewport::fixture_dragged, this, &FixtureController::shift);
    connect(&viewport_, &Viewport::fixture_dropped, this, &FixtureController::drop);
}

void FixtureController::project_opened() {
    viewport_.scene().fixtures().set(nullptr);
    count_ = 0;
}

void FixtureController::part_changed() {
    if (!document_.part_is_current()) return;
    const auto& fixtures = document_.part()->fixtures;
    viewport_.scene().fixtures().set(fixtures);
    const std::size_t count = fixtures ? fixtures->size() : 0;
    // After all have heard of it. One that is new may stand out of sight.
    if (count > count_) QTimer::singleShot(0, this, [this] { viewport_.fit(); });
    count_ = count;
    viewport_.refresh();
}

void FixtureController::node_chosen(const std::optional<TreeNode>& node) {
    const bool fixture = node && node->kind == TreeNode::Kind::fixture;
    const auto chosen = fixture ? std::optional(node->index) : std::nullopt;
    if (chosen == viewport_.scene().fixtures().chosen()) return;
    viewport_.scene().fixtures().choose(chosen);
    viewport_.refresh();
}

void FixtureController::shift(std::size_t i, const Vec3& by) {
    viewport_.scene().fixtures().shift(i, by);
    viewport_.refresh();
}

void FixtureController::drop(std::size_t i, const Vec3& by) {
    if (i >= document_.project().fixtures.size()) return;
    const double step =
        document_.unit() == LengthUnit::inch ? drop_step_inch * mm_per(LengthUnit::inch) : drop_step_mm;
    document_.change(Document::tr("Move fixture “%1”").arg(text(document_.project().fixtures[i].name)),
                     [&](Project& p) {
                         for (int k = 0; k < 3; ++k)
                             if (double& at = p.fixtures[i].translate[std::size_t(k)]; by[k] != 0)
                                 at = std::round((at + by[k]) / step) * step;
                     });
}

} // namespace facetmill::ui
