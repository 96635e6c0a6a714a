#include "ui/curve_tool.h"

#include "ui/pointer.h"
#include "ui/viewport.h"

#include <cmath>
#include <utility>

namespace facetmill::ui {

namespace {

constexpr double corner_reach = 8; ///< points about a corner that mean it

} // namespace

CurveTool::CurveTool(Viewport& viewport, QObject* parent) : QObject(parent), viewport_(viewport) {}

void CurveTool::begin(std::vector<Vec3> corners) {
    corners_ = std::move(corners);
    drawing_ = false;
    held_.reset();
}

std::optional<Vec3> CurveTool::place(const QPointF& at) const {
    const QPointF p = at * viewport_.devicePixelRatioF();
    const auto pick = viewport_.scene().part().pick(p.x(), p.y());
    return pick ? std::optional(pick->point) : std::nullopt;
}

std::optional<std::size_t> CurveTool::corner_at(const QPointF& at) const {
    const double ratio = viewport_.devicePixelRatioF();
    std::optional<std::size_t> found;
    double nearest = corner_reach;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const Vec2 there = viewport_.scene().camera().display_of(corners_[i]) / ratio;
        const double away = std::hypot(there.x() - at.x(), there.y() - at.y());
        if (away > nearest) continue;
        nearest = away;
        found = i;
    }
    return found;
}

bool CurveTool::press(const QPointF& at, Qt::KeyboardModifiers) {
    press_ = at;
    moved_ = false;
    held_ = drawing_ ? std::nullopt : corner_at(at);
    return held_ || place(at);
}

void CurveTool::drag(const QPointF& at, Qt::KeyboardModifiers) {
    moved_ = moved_ || std::hypot(at.x() - press_.x(), at.y() - press_.y()) >= click_slack;
    if (!held_ || !moved_) return;
    if (const auto to = place(at)) {
        corners_[*held_] = *to;
        emit changed();
    }
}

void CurveTool::release(const QPointF& at, Qt::KeyboardModifiers keys) {
    drag(at, keys);
    const auto held = std::exchange(held_, std::nullopt);
    if (held && moved_) return emit ended();
    if (held || moved_) return;
    const auto there = place(at);
    if (!there) return;
    if (!std::exchange(drawing_, true)) corners_.clear();
    corners_.push_back(*there);
    emit changed();
}

bool CurveTool::double_click(const QPointF&) {
    // Its first click has added the last corner.
    if (drawing_) close();
    return true;
}

bool CurveTool::close() {
    if (corners_.size() < 3) {
        emit refused();
        return false;
    }
    drawing_ = false;
    emit ended();
    return true;
}

void CurveTool::take_back() {
    if (!drawing_ || corners_.empty()) return;
    corners_.pop_back();
    emit changed();
}

} // namespace facetmill::ui
