#include "ui/icons.h"

#include "ui/theme.h"
#include "viz/palette.h"

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

namespace facetmill::ui {

namespace {

/// Draws on a 24 × 24 sheet with a pen in the text's colour; `accent` marks what the icon is about.
class Sheet {
public:
    Sheet(QPainter& painter, const QColor& ink, const QColor& accent)
        : p_(painter), ink_(ink), accent_(accent) {
        pen(ink_);
    }
    void pen(const QColor& color, double width = 1.7) {
        p_.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        p_.setBrush(Qt::NoBrush);
    }
    void fill(const QColor& color) {
        p_.setPen(Qt::NoPen);
        p_.setBrush(color);
    }
    QColor faint(const QColor& c, int alpha = 60) const {
        return QColor(c.red(), c.green(), c.blue(), alpha);
    }
    const QColor& ink() const { return ink_; }
    const QColor& accent() const { return accent_; }
    QPainter& painter() { return p_; }

    void line(double x1, double y1, double x2, double y2) { p_.drawLine(QPointF(x1, y1), QPointF(x2, y2)); }
    void polyline(std::initializer_list<QPointF> points) {
        p_.drawPolyline(points.begin(), int(points.size()));
    }
    void polygon(std::initializer_list<QPointF> points) {
        p_.drawPolygon(points.begin(), int(points.size()));
    }
    void rect(double x, double y, double w, double h, double r = 0) {
        p_.drawRoundedRect(QRectF(x, y, w, h), r, r);
    }
    void circle(double x, double y, double r) { p_.drawEllipse(QPointF(x, y), r, r); }
    void arc(double x, double y, double r, double start_degrees, double span_degrees) {
        p_.drawArc(QRectF(x - r, y - r, 2 * r, 2 * r), int(start_degrees * 16), int(span_degrees * 16));
    }

private:
    QPainter& p_;
    QColor ink_, accent_;
};

void draw_page(Sheet& s) {
    s.polygon({{6, 3.5}, {14, 3.5}, {18.5, 8}, {18.5, 20.5}, {6, 20.5}});
    s.polyline({{14, 3.5}, {14, 8}, {18.5, 8}});
}

/// A cube seen from the corner, with the faces of bits (top 1, front 2, side 4) filled.
void draw_cube(Sheet& s, int faces, bool seen_from_behind = false) {
    const QPointF top{12, 3.2}, left{4.5, 7.4}, right{19.5, 7.4}, middle{12, 11.6}, low_left{4.5, 16.2},
        low_right{19.5, 16.2}, bottom{12, 20.6};
    s.fill(s.faint(s.accent(), 210));
    if (faces & 1) s.polygon({top, right, middle, left});
    if (faces & 2) s.polygon({left, middle, bottom, low_left});
    if (faces & 4) s.polygon({middle, right, low_right, bottom});
    if (seen_from_behind) {
        // The face lies at the back: shown through the cube.
        const QPointF back{12, 12.4};
        s.fill(s.faint(s.accent(), 210));
        if (faces & 8) s.polygon({top, right, low_right, back});
        if (faces & 16) s.polygon({top, left, low_left, back});
        if (faces & 32) s.polygon({back, low_right, bottom, low_left});
    }
    s.pen(s.ink(), 1.4);
    s.polygon({top, right, low_right, bottom, low_left, left});
    s.polyline({left, middle, right});
    s.line(middle.x(), middle.y(), bottom.x(), bottom.y());
}

void draw_turn(Sheet& s, bool mirrored) {
    QPainter& p = s.painter();
    p.save();
    if (mirrored) {
        p.translate(24, 0);
        p.scale(-1, 1);
    }
    s.pen(s.ink(), 1.9);
    QPainterPath path(QPointF(5, 9.5));
    path.lineTo(14, 9.5);
    path.cubicTo(21.5, 9.5, 21.5, 18.5, 14, 18.5);
    path.lineTo(10, 18.5);
    p.drawPath(path);
    s.polyline({{9, 5.3}, {4.8, 9.5}, {9, 13.7}});
    p.restore();
}

void draw_tool(Sheet& s) {
    s.fill(s.faint(s.ink(), 50));
    s.rect(7.5, 2.5, 9, 5.5, 1);
    s.pen(s.ink(), 1.5);
    s.rect(7.5, 2.5, 9, 5.5, 1);
    QPainterPath body(QPointF(9, 8));
    body.lineTo(9, 18);
    body.arcTo(QRectF(9, 15, 6, 6), 180, 180);
    body.lineTo(15, 8);
    s.fill(s.faint(s.accent(), 150));
    s.painter().drawPath(body);
    s.pen(s.ink(), 1.5);
    s.painter().drawPath(body);
    s.line(9.3, 16, 14.7, 12.4);
    s.line(9.3, 12.4, 14.7, 8.8);
}

/// The ground of a verdict, unlike the discs of planning; leaves a white pen.
void draw_shield(Sheet& s, const QColor& color) {
    QPainterPath path(QPointF(12, 2.5));
    path.lineTo(20, 5.2);
    path.lineTo(20, 11);
    path.cubicTo(20, 16.5, 16.5, 20, 12, 21.8);
    path.cubicTo(7.5, 20, 4, 16.5, 4, 11);
    path.lineTo(4, 5.2);
    path.closeSubpath();
    s.fill(color);
    s.painter().drawPath(path);
    s.pen(Qt::white, 2.2);
}

void draw(Sheet& s, Icon which, const SignalColors& colors) {
    switch (which) {
    case Icon::new_project:
        draw_page(s);
        s.pen(s.accent(), 2);
        s.line(12.2, 11, 12.2, 17.4);
        s.line(9, 14.2, 15.4, 14.2);
        break;
    case Icon::open:
        s.fill(s.faint(s.accent(), 70));
        s.polygon({{3, 19}, {6.2, 11}, {21.5, 11}, {18.3, 19}});
        s.pen(s.ink());
        s.polyline({{3, 19}, {3, 5.5}, {9, 5.5}, {11, 8}, {18, 8}, {18, 11}});
        s.polygon({{3, 19}, {6.2, 11}, {21.5, 11}, {18.3, 19}});
        break;
    case Icon::save:
        s.polygon({{4, 4}, {16.5, 4}, {20, 7.5}, {20, 20}, {4, 20}});
        s.rect(8, 4, 7, 5);
        s.fill(s.faint(s.accent(), 150));
        s.rect(7.5, 13, 9, 7);
        s.pen(s.ink());
        s.rect(7.5, 13, 9, 7);
        break;
    case Icon::export_program:
        s.polyline({{13, 3.5}, {5, 3.5}, {5, 20.5}, {18, 20.5}, {18, 16.5}});
        s.line(8, 8, 12, 8);
        s.line(8, 12, 10.5, 12);
        s.line(8, 16, 12, 16);
        s.pen(s.accent(), 2);
        s.line(13, 12, 21.5, 12);
        s.polyline({{18, 8.5}, {21.5, 12}, {18, 15.5}});
        break;
    case Icon::picture:
        s.rect(3, 5, 18, 14, 1.5);
        s.fill(s.faint(s.accent(), 170));
        s.polygon({{4.5, 18}, {10, 10.5}, {14, 15.5}, {16, 13}, {19.5, 18}});
        s.pen(s.ink(), 1.4);
        s.circle(16.6, 9, 1.5);
        break;
    case Icon::undo:
        draw_turn(s, false);
        break;
    case Icon::redo:
        draw_turn(s, true);
        break;
    case Icon::add:
        s.pen(s.accent(), 2.2);
        s.line(12, 5, 12, 19);
        s.line(5, 12, 19, 12);
        break;
    case Icon::remove:
        s.pen(s.ink(), 2.2);
        s.line(5, 12, 19, 12);
        break;
    case Icon::duplicate:
        s.rect(8.5, 8.5, 11.5, 11.5, 1.5);
        s.polyline({{15.5, 5.5}, {15.5, 4}, {4, 4}, {4, 15.5}, {5.5, 15.5}});
        break;
    case Icon::up:
        s.pen(s.ink(), 2);
        s.line(12, 5, 12, 19.5);
        s.polyline({{6, 11}, {12, 5}, {18, 11}});
        break;
    case Icon::down:
        s.pen(s.ink(), 2);
        s.line(12, 4.5, 12, 19);
        s.polyline({{6, 13}, {12, 19}, {18, 13}});
        break;
    case Icon::reset:
        s.pen(s.ink(), 1.9);
        s.arc(12, 12.5, 7, 130, -300);
        s.polyline({{7.8, 2.8}, {7.3, 7.4}, {11.9, 7.8}});
        break;
    case Icon::edit:
        s.polygon({{4.5, 19.5}, {5.5, 15}, {16, 4.5}, {19.5, 8}, {9, 18.5}});
        s.line(13.5, 7, 17, 10.5);
        break;
    case Icon::close:
        s.pen(s.ink(), 2);
        s.line(6.5, 6.5, 17.5, 17.5);
        s.line(17.5, 6.5, 6.5, 17.5);
        break;
    case Icon::plan:
        s.pen(colors.good, 1.7);
        s.painter().setBrush(s.faint(colors.good, 190));
        s.polygon({{6.5, 4}, {20, 12}, {6.5, 20}});
        break;
    case Icon::verify:
        // A glass over a surface, with the mark of what passed.
        s.pen(s.ink(), 1.8);
        s.circle(10.5, 10, 6.8);
        s.pen(s.ink(), 2.4);
        s.line(15.6, 15.2, 20.8, 20.6);
        s.pen(colors.good, 2.1);
        s.polyline({{7.4, 10.2}, {9.8, 12.6}, {13.8, 7.6}});
        break;
    case Icon::play:
        s.fill(s.ink());
        s.polygon({{7.5, 4.5}, {19.5, 12}, {7.5, 19.5}});
        break;
    case Icon::pause:
        s.fill(s.ink());
        s.rect(6.5, 5, 4, 14, 0.8);
        s.rect(13.5, 5, 4, 14, 0.8);
        break;
    case Icon::step_back:
    case Icon::step_forward:
    case Icon::to_start:
    case Icon::to_end: {
        const bool back = which == Icon::step_back || which == Icon::to_start;
        const bool far = which == Icon::to_start || which == Icon::to_end;
        QPainter& p = s.painter();
        p.save();
        if (back) {
            p.translate(24, 0);
            p.scale(-1, 1);
        }
        s.fill(s.ink());
        if (far) {
            s.polygon({{4, 6}, {11, 12}, {4, 18}});
            s.polygon({{10.5, 6}, {17.5, 12}, {10.5, 18}});
            s.rect(17.8, 6, 2.4, 12, 0.6);
        } else {
            s.rect(6, 6, 2.6, 12, 0.6);
            s.polygon({{10.5, 6}, {18.5, 12}, {10.5, 18}});
        }
        p.restore();
        break;
    }
    case Icon::cancel:
        s.pen(colors.bad, 1.7);
        s.painter().setBrush(s.faint(colors.bad, 190));
        s.rect(5.5, 5.5, 13, 13, 1.5);
        break;
    case Icon::pick:
        s.pen(s.ink(), 1.7);
        s.polyline({{12, 3}, {12, 8.5}});
        s.polyline({{12, 15.5}, {12, 21}});
        s.polyline({{3, 12}, {8.5, 12}});
        s.polyline({{15.5, 12}, {21, 12}});
        s.fill(s.accent());
        s.rect(10.2, 10.2, 3.6, 3.6, 1.8);
        break;
    case Icon::fit:
        s.pen(s.ink(), 1.9);
        s.polyline({{4, 9}, {4, 4}, {9, 4}});
        s.polyline({{15, 4}, {20, 4}, {20, 9}});
        s.polyline({{20, 15}, {20, 20}, {15, 20}});
        s.polyline({{9, 20}, {4, 20}, {4, 15}});
        s.fill(s.faint(s.accent(), 200));
        s.rect(8, 8, 8, 8, 1);
        break;
    case Icon::view_iso:
        draw_cube(s, 7);
        break;
    case Icon::view_top:
        draw_cube(s, 1);
        break;
    case Icon::view_front:
        draw_cube(s, 2);
        break;
    case Icon::view_right:
        draw_cube(s, 4);
        break;
    case Icon::view_rear:
        draw_cube(s, 8, true);
        break;
    case Icon::view_left:
        draw_cube(s, 16, true);
        break;
    case Icon::view_bottom:
        draw_cube(s, 32, true);
        break;
    case Icon::part:
        s.fill(s.faint(s.accent(), 110));
        s.polygon({{3, 15}, {9, 6}, {15, 15}});
        s.fill(s.faint(s.accent(), 200));
        s.polygon({{9, 6}, {21, 9}, {15, 15}});
        s.pen(s.ink(), 1.4);
        s.polygon({{3, 15}, {9, 6}, {21, 9}, {15, 15}, {10, 20}});
        s.polyline({{9, 6}, {15, 15}, {3, 15}});
        break;
    case Icon::stock:
        s.fill(s.faint(s.accent(), 70));
        s.rect(4, 5, 16, 14, 1);
        s.painter().setPen(QPen(s.ink(), 1.4, Qt::DashLine));
        s.painter().setBrush(Qt::NoBrush);
        s.rect(4, 5, 16, 14, 1);
        break;
    case Icon::machine:
        s.pen(s.ink(), 1.5);
        s.polyline({{4, 20.5}, {4, 4}, {14.5, 4}, {14.5, 7}});
        s.rect(12, 7, 5, 5, 0.8);
        s.line(14.5, 12, 14.5, 15);
        s.line(3, 20.5, 21.5, 20.5);
        s.fill(s.faint(s.accent(), 190));
        s.rect(9.5, 16, 11, 3, 0.5);
        break;
    case Icon::tools:
    case Icon::tool:
        draw_tool(s);
        break;
    case Icon::operations:
        for (const double y : {6.0, 12.0, 18.0}) {
            s.fill(s.accent());
            s.circle(5, y, 1.8);
            s.pen(s.ink(), 1.7);
            s.line(10, y, 20, y);
        }
        break;
    case Icon::operation: {
        s.pen(s.accent(), 1.8);
        QPainterPath zigzag(QPointF(4, 5.5));
        zigzag.lineTo(18, 5.5);
        zigzag.arcTo(QRectF(15.8, 5.5, 4.4, 4.4), 90, -180);
        zigzag.lineTo(6, 9.9);
        zigzag.arcTo(QRectF(3.8, 9.9, 4.4, 4.4), 90, 180);
        zigzag.lineTo(18, 14.3);
        zigzag.arcTo(QRectF(15.8, 14.3, 4.4, 4.4), 90, -180);
        zigzag.lineTo(4, 18.7);
        s.painter().drawPath(zigzag);
        break;
    }
    case Icon::not_planned:
        s.pen(colors.quiet, 2);
        s.circle(12, 12, 7);
        break;
    case Icon::planning:
        s.pen(s.faint(colors.busy, 90), 2.6);
        s.circle(12, 12, 7);
        s.pen(colors.busy, 2.6);
        s.arc(12, 12, 7, 90, -110);
        break;
    case Icon::planned:
        s.fill(colors.good);
        s.circle(12, 12, 8.5);
        s.pen(Qt::white, 2.2);
        s.polyline({{8, 12.4}, {11, 15.4}, {16.3, 9}});
        break;
    case Icon::stale:
        s.pen(colors.attention, 2.3);
        s.arc(12, 12, 7, 60, -300);
        s.fill(colors.attention);
        s.polygon({{13.2, 2.2}, {18.6, 6}, {12.6, 9.2}});
        break;
    case Icon::failed:
    case Icon::error:
        s.fill(colors.bad);
        s.circle(12, 12, 8.5);
        s.pen(Qt::white, 2.2);
        s.line(9, 9, 15, 15);
        s.line(15, 9, 9, 15);
        break;
    case Icon::verified:
        draw_shield(s, colors.good);
        s.polyline({{8.2, 11.8}, {11, 14.6}, {16, 8.6}});
        break;
    case Icon::verify_failed:
        draw_shield(s, colors.bad);
        s.line(9, 8.4, 15, 14.4);
        s.line(15, 8.4, 9, 14.4);
        break;
    case Icon::verify_stale:
        s.pen(colors.quiet, 2);
        s.circle(12, 12, 8.2);
        s.polyline({{12, 7}, {12, 12}, {15.6, 14}});
        break;
    case Icon::information:
        s.fill(colors.busy);
        s.circle(12, 12, 8.5);
        s.pen(Qt::white, 2.2);
        s.line(12, 11.5, 12, 16.5);
        s.line(12, 7.6, 12, 7.7);
        break;
    case Icon::warning:
        s.fill(colors.attention);
        s.polygon({{12, 3}, {22, 20.5}, {2, 20.5}});
        s.pen(Qt::white, 2.2);
        s.line(12, 9.5, 12, 14);
        s.line(12, 17.3, 12, 17.4);
        break;
    }
}

class DrawnIcon : public QIconEngine {
public:
    explicit DrawnIcon(Icon which) : which_(which) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        const QPalette palette = QApplication::palette();
        const bool selected = mode == QIcon::Selected;
        const QColor ink = palette.color(selected ? QPalette::HighlightedText : QPalette::ButtonText);
        QColor accent = palette.color(selected ? QPalette::HighlightedText : QPalette::Highlight);
        if (!selected && is_dark(palette)) accent = accent.lighter(125);
        painter->save();
        if (mode == QIcon::Disabled) painter->setOpacity(0.32);
        painter->setRenderHint(QPainter::Antialiasing);
        const int side = std::min(rect.width(), rect.height());
        painter->translate(rect.x() + (rect.width() - side) / 2.0, rect.y() + (rect.height() - side) / 2.0);
        painter->scale(side / 24.0, side / 24.0);
        Sheet sheet(*painter, ink, accent);
        SignalColors colors = signal_colors(palette);
        if (selected) colors.quiet = colors.busy = ink; // rings would drown in the highlight
        draw(sheet, which_, colors);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return pixmap;
    }
    QIconEngine* clone() const override { return new DrawnIcon(which_); }

private:
    Icon which_;
};

} // namespace

QIcon icon(Icon which) {
    return QIcon(new DrawnIcon(which));
}

QIcon application_icon() {
    QIcon result;
    for (const int side : {16, 24, 32, 48, 64, 128, 256}) {
        QPixmap pixmap(side, side);
        pixmap.fill(Qt::transparent);
        QPainter p(&pixmap);
        p.setRenderHint(QPainter::Antialiasing);
        p.scale(side / 64.0, side / 64.0);
        p.setPen(Qt::NoPen);
        p.setBrush(QColor(0x1d2b3a));
        p.drawRoundedRect(QRectF(2, 2, 60, 60), 12, 12);
        const auto facet = [&](QColor color, std::initializer_list<QPointF> corners) {
            p.setBrush(color);
            p.drawPolygon(corners.begin(), int(corners.size()));
        };
        facet(QColor(0x2f7fc1), {{8, 44}, {22, 34}, {30, 52}});
        facet(QColor(0x4b9bdc), {{22, 34}, {40, 40}, {30, 52}});
        facet(QColor(0x2468a2), {{40, 40}, {56, 46}, {30, 52}});
        facet(QColor(0x66b2ec), {{40, 40}, {52, 32}, {56, 46}});
        QPainterPath cutter(QPointF(30, 8));
        cutter.lineTo(30, 30);
        cutter.arcTo(QRectF(30, 23, 14, 14), 180, 180);
        cutter.lineTo(44, 8);
        cutter.closeSubpath();
        p.setBrush(QColor(0xf0b849));
        p.drawPath(cutter);
        p.setBrush(QColor(0xd99a22));
        p.drawPolygon(QList<QPointF>{{30, 24}, {44, 14}, {44, 18}, {30, 28}});
        result.addPixmap(pixmap);
    }
    return result;
}

QPixmap swatch(const Rgb& color, qreal device_pixel_ratio) {
    QPixmap pixmap(QSize(swatch_size, swatch_size) * device_pixel_ratio);
    pixmap.setDevicePixelRatio(device_pixel_ratio);
    pixmap.fill(Qt::transparent);
    QPainter p(&pixmap);
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(Qt::NoPen);
    p.setBrush(QColor::fromRgbF(float(color.r), float(color.g), float(color.b)));
    p.drawRoundedRect(QRectF(0.5, 0.5, swatch_size - 1, swatch_size - 1), 2.5, 2.5);
    return pixmap;
}

} // namespace facetmill::ui
