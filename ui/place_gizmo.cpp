#include "ui/place_gizmo.h"

#include "ui/text.h"
#include "ui/viewport.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

constexpr int ring_sides = 96;
constexpr double box_share = 0.55;  ///< of the ring, of the diagonal of the part's box
constexpr double view_share = 0.36; ///< at most, of the shorter side of the view
constexpr double arrow_reach = 1.3, head_length = 0.14, head_width = 0.05; ///< of the ring's radius
constexpr double pick_slack = 7;                                           ///< pixels
constexpr double edge_on = 0.25; ///< cosine between the sight and a ring's axis below which it is a line
constexpr double facing_all = 0.98;
constexpr double dot_share = 0.2; ///< of its length that is seen of an arrow below which it is a dot
/// Round steps with Shift; and what a drag without it is rounded to.
const double round_angle = radians(5), fine_angle = radians(0.1);
constexpr double round_mm = 1, fine_mm = 0.01, round_inch = 0.05, fine_inch = 0.001;

double rounded(double v, double step) {
    return std::round(v / step) * step;
}

double distance_to(const QPolygonF& line, const QPointF& p) {
    double least = infinity;
    for (qsizetype i = 0; i + 1 < line.size(); ++i) {
        const QPointF a = line[i], d = line[i + 1] - a, off = p - a;
        const double square = QPointF::dotProduct(d, d);
        const double t = square > 0 ? std::clamp(QPointF::dotProduct(off, d) / square, 0.0, 1.0) : 0;
        const QPointF gap = off - t * d;
        least = std::min(least, std::hypot(gap.x(), gap.y()));
    }
    return least;
}

/// Two directions across a coordinate axis, counter-clockwise seen from its end.
std::pair<Vec3, Vec3> across(int axis) {
    return {Vec3::Unit((axis + 1) % 3), Vec3::Unit((axis + 2) % 3)};
}

} // namespace

PlaceGizmo::PlaceGizmo(Viewport& viewport, QObject* parent) : QObject(parent), viewport_(viewport) {}

void PlaceGizmo::set_box(const Box3& box, LengthUnit unit) {
    if (held_ && (box.lo != box_.lo || box.hi != box_.hi)) cancel();
    box_ = box;
    unit_ = unit;
    viewport_.update();
}

void PlaceGizmo::cancel() {
    if (!held_) return;
    const Handle was = *held_;
    held_.reset();
    emit dropped(was.what, was.axis, 0);
    viewport_.update();
}

double PlaceGizmo::radius() const {
    const double side = std::min(viewport_.width(), viewport_.height()) * viewport_.devicePixelRatioF();
    const double in_view = view_share * side * viewport_.scene().camera().pixel_size(box_.center());
    return std::min(box_share * box_.diagonal(), in_view);
}

Vec3 PlaceGizmo::toward_eye() const {
    return -viewport_.scene().camera().sight_to(box_.center()).direction;
}

QPointF PlaceGizmo::pixel(const Vec3& p) const {
    const Vec2 at = viewport_.scene().camera().display_of(p) / viewport_.devicePixelRatioF();
    return {at.x(), at.y()};
}

Vec3 PlaceGizmo::ring_place(int axis, double angle) const {
    const auto [u, v] = across(axis);
    return box_.center() + radius() * (std::cos(angle) * u + std::sin(angle) * v);
}

QPointF PlaceGizmo::place_of(PlaceChange what, int axis, double share) const {
    return what == PlaceChange::turn ? pixel(ring_place(axis, 2 * pi * share))
                                     : pixel(box_.center() + arrow_reach * radius() * Vec3::Unit(axis));
}

QPolygonF PlaceGizmo::line_of(const Handle& handle, bool behind) const {
    QPolygonF line;
    if (handle.what == PlaceChange::move) {
        if (!behind)
            line << pixel(box_.center() + radius() * Vec3::Unit(handle.axis))
                 << pixel(box_.center() + arrow_reach * radius() * Vec3::Unit(handle.axis));
        return line;
    }
    const Vec3 toward = toward_eye();
    // From where it comes to the front, so that either half is one line.
    const auto [u, v] = across(handle.axis);
    const double front = std::atan2(toward.dot(v), toward.dot(u));
    const double from = behind ? front + 0.5 * pi : front - 0.5 * pi;
    for (int i = 0; i <= ring_sides / 2; ++i)
        line << pixel(ring_place(handle.axis, from + 2 * pi * i / ring_sides));
    return line;
}

bool PlaceGizmo::seen(const Handle& handle) const {
    if (handle.what == PlaceChange::turn) return true;
    const double along = toward_eye()[handle.axis];
    return std::sqrt(std::max(0.0, 1 - along * along)) > dot_share;
}

std::optional<PlaceGizmo::Handle> PlaceGizmo::handle_at(const QPointF& at) const {
    if (box_.empty() || viewport_.scene().camera().pixel_size(box_.center()) <= 0) return std::nullopt;
    std::optional<Handle> found;
    double least = pick_slack;
    // Arrows first, and of the rings what is in front.
    for (const bool behind : {false, true})
        for (const PlaceChange what : {PlaceChange::move, PlaceChange::turn})
            for (int axis = 0; axis < 3 && !(found && behind); ++axis) {
                const Handle handle{what, axis};
                if (!seen(handle)) continue;
                if (const double d = distance_to(line_of(handle, behind), at); d < least) {
                    least = d;
                    found = handle;
                }
            }
    return found;
}

bool PlaceGizmo::press(const QPointF& at, Qt::KeyboardModifiers) {
    held_ = handle_at(at);
    if (!held_) return false;
    press_ = at;
    value_ = turned_ = last_angle_ = 0;
    last_angle_ = held_->what == PlaceChange::turn ? value_at(at) : 0;
    return true;
}

double PlaceGizmo::value_at(const QPointF& at) const {
    const SceneCamera& camera = viewport_.scene().camera();
    const double ratio = viewport_.devicePixelRatioF();
    const Vec3 axis = Vec3::Unit(held_->axis), toward = toward_eye();
    const auto sight = [&](const QPointF& p) { return camera.sight_at(p.x() * ratio, p.y() * ratio); };
    // In the plane across the line of sight through the middle.
    const auto place = [&](const QPointF& p) {
        const SightLine line = sight(p);
        const double slope = line.direction.dot(toward);
        return Vec3(line.at + (box_.center() - line.at).dot(toward) / slope * line.direction);
    };
    if (held_->what == PlaceChange::move) {
        // As far as the arrow's shadow on the screen goes with the pointer.
        const Vec3 flat = axis - axis.dot(toward) * toward;
        return (place(at) - place(press_)).dot(flat) / flat.squaredNorm();
    }
    const double facing = toward.dot(axis);
    if (std::abs(facing) < edge_on) {
        // Seen from its edge it is a line that rolls.
        const Vec3 side = axis.cross(toward).normalized();
        return (place(at) - place(press_)).dot(side) / radius();
    }
    const SightLine line = sight(at);
    const double onto = line.direction.dot(axis);
    if (std::abs(onto) < 1e-9) return last_angle_;
    const Vec3 hit = line.at + (box_.center() - line.at).dot(axis) / onto * line.direction - box_.center();
    const auto [u, v] = across(held_->axis);
    return std::atan2(hit.dot(v), hit.dot(u));
}

void PlaceGizmo::drag(const QPointF& at, Qt::KeyboardModifiers keys) {
    if (!held_) return;
    const bool round = keys & Qt::ShiftModifier;
    if (held_->what == PlaceChange::turn) {
        const double now = value_at(at);
        turned_ += std::remainder(now - last_angle_, 2 * pi);
        last_angle_ = now;
        value_ = rounded(turned_, round ? round_angle : fine_angle);
    } else {
        const bool inch = unit_ == LengthUnit::inch;
        const double step = inch ? (round ? round_inch : fine_inch) : (round ? round_mm : fine_mm);
        value_ = rounded(value_at(at), step * mm_per(unit_));
    }
    emit dragged(held_->what, held_->axis, value_);
    viewport_.update();
}

void PlaceGizmo::release(const QPointF&, Qt::KeyboardModifiers) {
    if (!held_) return;
    const Handle was = *held_;
    held_.reset();
    emit dropped(was.what, was.axis, value_);
    viewport_.update();
}

QString PlaceGizmo::value_text() const {
    const QChar letter(u'X' + char16_t(held_->axis));
    const QString sign = value_ > 0 ? QStringLiteral("+") : QString();
    return held_->what == PlaceChange::turn
               ? tr("%1 %2%3°").arg(letter).arg(sign).arg(degrees(value_), 0, 'f', 1)
               : tr("%1 %2%3").arg(letter).arg(sign, shown_length(value_, unit_, 6));
}

void PlaceGizmo::paint(QPainter& painter, const QPointF& pointer) {
    if (box_.empty()) return;
    const Colors& colors = colors_of(viewport_.scene().palette());
    const std::optional<Handle> hot = held_ ? held_ : handle_at(pointer);
    for (const bool behind : {true, false})
        for (const PlaceChange what : {PlaceChange::turn, PlaceChange::move})
            for (int axis = 0; axis < 3; ++axis) {
                const Handle handle{what, axis};
                if ((held_ && !(handle == *held_)) || !seen(handle)) continue;
                const Rgb& c = colors.axes[std::size_t(axis)];
                QColor color = QColor::fromRgbF(float(c.r), float(c.g), float(c.b));
                // Seen from its axis all of a ring is in front.
                const double facing = toward_eye()[axis];
                if (behind && std::abs(facing) < facing_all) color.setAlphaF(0.3F);
                const bool lit = hot && handle == *hot;
                painter.setPen(QPen(color, lit ? 4 : 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
                const QPolygonF line = line_of(handle, behind);
                painter.drawPolyline(line);
                if (what == PlaceChange::turn || line.size() < 2) continue;
                const QPointF tip = line.back(), along = tip - line.front();
                const double length = std::hypot(along.x(), along.y());
                if (length < 1) continue;
                const double size =
                    radius()
                    / (viewport_.scene().camera().pixel_size(box_.center()) * viewport_.devicePixelRatioF());
                const QPointF back = along / length * (head_length * size),
                              side = QPointF(-along.y(), along.x()) / length * (head_width * size);
                painter.setBrush(color);
                painter.drawPolygon(QPolygonF({tip, tip - back + side, tip - back - side}));
                painter.setBrush(Qt::NoBrush);
            }
    if (!held_) return;
    const QString words = value_text();
    const QFontMetrics metrics = painter.fontMetrics();
    QRectF field(QPointF(pointer + QPointF(16, -28)),
                 QSizeF(metrics.horizontalAdvance(words) + 12, metrics.height() + 6));
    field.moveRight(std::min(field.right(), viewport_.width() - 4.0));
    field.moveTop(std::max(field.top(), 4.0));
    painter.setPen(viewport_.palette().color(QPalette::WindowText));
    painter.setBrush(viewport_.palette().color(QPalette::Window));
    painter.drawRoundedRect(field, 4, 4);
    painter.drawText(field, Qt::AlignCenter, words);
}

} // namespace facetmill::ui
