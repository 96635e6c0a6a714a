#include "ui/view_cube.h"

#include "ui/text.h"
#include "ui/theme.h"
#include "ui/worded.h"
#include "viz/palette.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <cmath>

namespace facetmill::ui {

namespace {

struct Face {
    StandardView view;
    Vec3 outward, right, up; ///< right and up as its label is written
};

const std::array<Face, 6>& faces() {
    static const std::array<Face, 6> all = {{
        {StandardView::front, {0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
        {StandardView::rear, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
        {StandardView::right, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        {StandardView::left, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
        {StandardView::top, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}},
        {StandardView::bottom, {0, 0, -1}, {-1, 0, 0}, {0, 1, 0}},
    }};
    return all;
}

constexpr int side = 92;
constexpr double half_edge = 25.0;
constexpr int widest_label = 96; ///< of a face, whose side is 100
const QRectF house(side - 21, side - 21, 18, 18);
constexpr double house_radius = 11.0, arrow_radius = 9.0;

} // namespace

ViewCube::ViewCube(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("view_cube"));
    setFixedSize(side, side);
    setMouseTracking(true);
    setCursor(Qt::ArrowCursor);
    // The corners of the square belong to the view below: a drag that begins there is one of the view.
    const double reach = half_edge * std::sqrt(3.0) + 2;
    const QPointF middle(side / 2.0, side / 2.0);
    const auto disc = [](const QPointF& center, double radius) {
        const int r = int(std::ceil(radius));
        return QRegion(int(center.x()) - r, int(center.y()) - r, 2 * r, 2 * r, QRegion::Ellipse);
    };
    setMask(disc(middle, reach) + disc(house.center(), house_radius + 1)
            + disc(roll_center(1), arrow_radius + 1) + disc(roll_center(-1), arrow_radius + 1));
}

void ViewCube::set_orientation(const Vec3& sight, const Vec3& up) {
    if (sight.isApprox(sight_, 1e-12) && up.isApprox(up_, 1e-12)) return;
    sight_ = sight;
    up_ = up;
    update();
}

QPointF ViewCube::project(const Vec3& p) const {
    const Vec3 right = sight_.cross(up_).normalized();
    const Vec3 upward = right.cross(sight_);
    return {side / 2.0 + p.dot(right) * half_edge, side / 2.0 - p.dot(upward) * half_edge};
}

std::optional<QPointF> ViewCube::face_center(StandardView view) const {
    if (view == StandardView::iso) return house.center();
    for (const Face& f : faces())
        if (f.view == view && seen(f.outward)) return project(f.outward);
    return std::nullopt;
}

QPointF ViewCube::roll_center(int quarters) const {
    constexpr double from_edge = arrow_radius + 1;
    return {quarters > 0 ? side - from_edge : from_edge, from_edge};
}

int ViewCube::roll_at(const QPointF& at) const {
    for (const int quarters : {1, -1}) {
        const QPointF away = at - roll_center(quarters);
        if (std::hypot(away.x(), away.y()) <= arrow_radius) return quarters;
    }
    return 0;
}

std::optional<StandardView> ViewCube::face_at(const QPointF& at) const {
    if (house.contains(at)) return StandardView::iso;
    if (roll_at(at) != 0) return std::nullopt;
    for (const Face& f : faces()) {
        if (!seen(f.outward)) continue;
        const QPolygonF outline({project(f.outward - f.right - f.up), project(f.outward + f.right - f.up),
                                 project(f.outward + f.right + f.up), project(f.outward - f.right + f.up)});
        if (outline.containsPoint(at, Qt::WindingFill)) return f.view;
    }
    return std::nullopt;
}

void ViewCube::paintEvent(QPaintEvent*) {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const ViewCubeColors& colors = view_colors(palette()).cube;
    const QColor ink = to_qt(colors.ink), body = to_qt(colors.body), edge = to_qt(colors.edge);
    const QColor accent = palette().color(QPalette::Highlight);
    for (const Face& f : faces()) {
        if (!seen(f.outward)) continue;
        const QPointF a = project(f.outward - f.right - f.up), b = project(f.outward + f.right - f.up),
                      d = project(f.outward - f.right + f.up), c = b + d - a;
        QColor fill = hover_ == f.view ? accent : body.darker(int(100 + 22 * (1.0 + f.outward.dot(sight_))));
        fill.setAlpha(235);
        p.setPen(QPen(edge, 1.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        p.setBrush(fill);
        p.drawPolygon(QPolygonF({a, b, c, d}));
        // The label lies in the face: a unit square of the face is mapped onto the screen.
        p.save();
        const QTransform onto((b.x() - a.x()) / 100, (b.y() - a.y()) / 100, (a.x() - d.x()) / 100,
                              (a.y() - d.y()) / 100, d.x(), d.y());
        p.setTransform(onto, true);
        QFont font = this->font();
        font.setPixelSize(21);
        font.setBold(true);
        const QString label = worded(view_label(f.view)).toUpper();
        if (const int wide = QFontMetrics(font).horizontalAdvance(label); wide > widest_label)
            font.setPixelSize(font.pixelSize() * widest_label / wide);
        p.setFont(font);
        p.setPen(hover_ == f.view ? to_qt(colors.on_accent) : ink);
        p.drawText(QRectF(0, 0, 100, 100), Qt::AlignCenter, label);
        p.restore();
    }
    QColor ground = body;
    ground.setAlpha(200);
    for (const int quarters : {1, -1})
        draw_arrow(p, quarters, ground, roll_hover_ == quarters ? accent : ink);
    p.setPen(Qt::NoPen);
    p.setBrush(ground);
    p.drawEllipse(house.center(), house_radius, house_radius);
    p.setPen(
        QPen(hover_ == StandardView::iso ? accent : ink, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    p.setBrush(Qt::NoBrush);
    const double x = house.x(), y = house.y();
    p.drawPolyline(QPolygonF({{x + 2, y + 9}, {x + 9, y + 2.5}, {x + 16, y + 9}}));
    p.drawPolyline(
        QPolygonF({{x + 4.5, y + 7.5}, {x + 4.5, y + 15}, {x + 13.5, y + 15}, {x + 13.5, y + 7.5}}));
}

/// A quarter of a circle over the disc's middle with a head at its end.
void ViewCube::draw_arrow(QPainter& p, int quarters, const QColor& ground, const QColor& ink) const {
    constexpr double bow = 5.5, head = 3.5;
    const QPointF middle = roll_center(quarters);
    p.setPen(Qt::NoPen);
    p.setBrush(ground);
    p.drawEllipse(middle, arrow_radius, arrow_radius);
    p.setPen(QPen(ink, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    p.setBrush(Qt::NoBrush);
    const int sixteenth = 16; // QPainter counts in sixteenths of a degree
    const QRectF circle(middle.x() - bow, middle.y() - bow, 2 * bow, 2 * bow);
    p.drawArc(circle, (quarters > 0 ? 0 : 30) * sixteenth, 150 * sixteenth);
    const QPointF end(middle.x() + quarters * bow, middle.y());
    p.drawPolyline(QPolygonF({end + QPointF(-head, -head + 1), end, end + QPointF(head, -head + 1)}));
}

void ViewCube::mousePressEvent(QMouseEvent* event) {
    pressed_ = face_at(event->position());
    roll_pressed_ = roll_at(event->position());
}

void ViewCube::mouseReleaseEvent(QMouseEvent* event) {
    const auto face = face_at(event->position());
    if (event->button() == Qt::LeftButton && face && face == pressed_) emit chosen(*face);
    const int roll = roll_at(event->position());
    if (event->button() == Qt::LeftButton && roll != 0 && roll == roll_pressed_) emit rolled(roll);
    pressed_.reset();
    roll_pressed_ = 0;
}

void ViewCube::mouseMoveEvent(QMouseEvent* event) {
    const auto face = face_at(event->position());
    const int roll = roll_at(event->position());
    if (face == hover_ && roll == roll_hover_) return;
    hover_ = face;
    roll_hover_ = roll;
    update();
}

void ViewCube::mouseDoubleClickEvent(QMouseEvent* event) {
    mousePressEvent(event); // two quick clicks, not a fit of the view below
}

void ViewCube::leaveEvent(QEvent*) {
    hover_.reset();
    roll_hover_ = 0;
    update();
}

bool ViewCube::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        auto* help = static_cast<QHelpEvent*>(event);
        if (const int roll = roll_at(help->pos()))
            QToolTip::showText(help->globalPos(), roll > 0 ? tr("Roll clockwise") : tr("Roll anticlockwise"),
                               this);
        else if (const auto face = face_at(help->pos()))
            QToolTip::showText(help->globalPos(), worded(view_label(*face)), this);
        else
            QToolTip::hideText();
        return true;
    }
    return QWidget::event(event);
}

} // namespace facetmill::ui
