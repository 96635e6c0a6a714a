// The mouse in views that are dragged: which drag is under way, whether a press has become one, and where the
// pointer rests. What a drag does is the view's.
#pragma once

#include <QMouseEvent>
#include <QPointF>
#include <QTimer>
#include <QWheelEvent>

#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace facetmill::ui {

/// Pointer travel, in points, below which a press and release is a click.
constexpr double click_slack = 4.0;

/// `Kind` is the view's enumeration of what is dragged, with `none`. One drag at a time: a second button
/// during it changes nothing.
template <class Kind>
class PointerDrag {
public:
    /// `slack`: pointer travel before anything moves.
    explicit PointerDrag(double slack) : slack_(slack) {}

    Kind kind() const { return kind_; }
    explicit operator bool() const { return kind_ != Kind::none; }
    /// It went further than a click does.
    bool moved() const { return moved_; }
    const QPointF& press() const { return press_; }

    /// Kind::none: the button drags nothing.
    void begin(Kind kind, const QPointF& at) {
        kind_ = kind;
        press_ = last_ = at;
        moved_ = false;
    }
    /// How far the pointer went since the last call; nothing while there is no drag, or not yet.
    std::optional<QPointF> travel(const QMouseEvent& event) {
        const QPointF at = event.position();
        if (event.buttons() == Qt::NoButton) kind_ = Kind::none; // the release went elsewhere
        if (kind_ == Kind::none) return std::nullopt;
        if (!moved_ && std::hypot(at.x() - press_.x(), at.y() - press_.y()) < slack_) return std::nullopt;
        moved_ = true;
        return at - std::exchange(last_, at);
    }
    /// What was dragged until now.
    Kind end() { return std::exchange(kind_, Kind::none); }

private:
    double slack_;
    Kind kind_ = Kind::none;
    bool moved_ = false;
    QPointF press_, last_;
};

/// Tells where the pointer has come to rest.
class PointerRest {
public:
    explicit PointerRest(std::function<void(const QPointF&)> rested) {
        timer_.setSingleShot(true);
        timer_.setInterval(rest_ms);
        timer_.callOnTimeout([this, rested = std::move(rested)] { rested(at_); });
    }
    void moved(const QPointF& at) {
        at_ = at;
        timer_.start();
    }
    void stop() { timer_.stop(); }

private:
    static constexpr int rest_ms = 60;
    QTimer timer_;
    QPointF at_;
};

/// Notches of a wheel, upward.
inline double wheel_steps(const QWheelEvent& event) {
    return event.angleDelta().y() / 120.0;
}

} // namespace facetmill::ui
