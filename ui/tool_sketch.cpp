#include "ui/tool_sketch.h"

#include "ui/text.h"
#include "ui/theme.h"
#include "ui/worded.h"
#include "viz/palette.h"
#include "viz/tool_shape.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace facetmill::ui {

namespace {

struct SketchColors {
    QColor paper, ink, quiet, cutter, shank, holder, axis;
};

SketchColors sketch_colors_of(const QPalette& palette) {
    const ToolSketchColors& c = view_colors(palette).sketch;
    return {palette.color(QPalette::Base),
            palette.color(QPalette::Text),
            palette.color(QPalette::PlaceholderText),
            to_qt(c.cutter),
            to_qt(c.shank),
            to_qt(c.holder),
            to_qt(c.axis)};
}

/// A dimension line between two points with arrows and its text in the middle; `off` moves the text off the
/// line.
void dimension(QPainter& p, const QPointF& a, const QPointF& b, const QString& text, const QPointF& off,
               Qt::Alignment alignment) {
    p.drawLine(a, b);
    const QPointF d = b - a;
    const double length = std::hypot(d.x(), d.y());
    if (length > 1) {
        const QPointF along = d / length, across(-along.y(), along.x());
        const double size = std::min(6.0, length / 3);
        for (const auto& [tip, sign] : {std::pair{a, 1.0}, std::pair{b, -1.0}}) {
            p.drawLine(tip, tip + along * (sign * size) + across * (size * 0.35));
            p.drawLine(tip, tip + along * (sign * size) - across * (size * 0.35));
        }
    }
    const QPointF middle = (a + b) / 2 + off;
    QRectF box(middle.x() - 100, middle.y() - 10, 200, 20);
    if (alignment & Qt::AlignLeft) box.moveLeft(middle.x());
    if (alignment & Qt::AlignRight) box.moveRight(middle.x());
    p.drawText(box, int(alignment | Qt::AlignVCenter), text);
}

} // namespace

ToolSketch::ToolSketch(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("tool_sketch"));
    setMinimumSize(120, 140);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

QSize ToolSketch::sizeHint() const {
    return compact_ ? QSize(200, 260) : QSize(420, 420);
}

void ToolSketch::set_compact(bool compact) {
    compact_ = compact;
    updateGeometry();
    update();
}

void ToolSketch::set_tool(const Tool& tool, LengthUnit unit) {
    tool_ = tool;
    unit_ = unit;
    has_tool_ = false;
    why_not_.clear();
    try {
        const CutterProfile profile(tool.cutter());
        pieces_ = profile.pieces();
        cutter_height_ = profile.height();
        cutter_radius_ = profile.max_radius();
        has_tool_ = true;
    } catch (const Error& e) {
        why_not_ = sentence(with_lengths_in(worded(e.message()), unit_));
    }
    update();
}

QPainterPath ToolSketch::cutter_path(double scale) const {
    // The right half from the tip upward, then the left half as its mirror image.
    std::vector<QPointF> right;
    const auto add = [&](double rho, double z) { right.emplace_back(rho * scale, -z * scale); };
    add(0, 0);
    for (const ProfilePiece& piece : pieces_) {
        if (piece.kind == ProfilePiece::Kind::arc) {
            const double from =
                std::atan2(piece.from.y() - piece.center.y(), piece.from.x() - piece.center.x());
            const double to = std::atan2(piece.to.y() - piece.center.y(), piece.to.x() - piece.center.x());
            for (int i = 1; i < 32; ++i) {
                const double a = from + (to - from) * i / 32.0;
                add(piece.center.x() + piece.radius * std::cos(a),
                    piece.center.y() + piece.radius * std::sin(a));
            }
        }
        add(piece.to.x(), piece.to.y());
    }
    add(0, cutter_height_);
    QPainterPath path(right.front());
    for (const QPointF& q : right)
        path.lineTo(q);
    for (auto it = right.rbegin(); it != right.rend(); ++it)
        path.lineTo(-it->x(), it->y());
    path.closeSubpath();
    return path;
}

void ToolSketch::paintEvent(QPaintEvent*) {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const SketchColors c = sketch_colors_of(palette());
    p.fillRect(rect(), c.paper);
    p.setPen(c.quiet);
    p.setBrush(Qt::NoBrush);
    p.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
    if (!has_tool_) {
        p.setPen(signal_colors(palette()).bad);
        p.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                   why_not_.isEmpty() ? tr("No tool") : tr("These values make no cutter.\n%1").arg(why_not_));
        return;
    }
    const QRectF area = QRectF(rect()).adjusted(10, 10, -10, -10);
    if (compact_ || width() < 300) {
        draw_assembly(p, area);
        return;
    }
    const double split = area.width() * 0.5;
    draw_assembly(p, QRectF(area.x(), area.y(), split - 6, area.height()));
    p.setPen(QPen(c.quiet, 0.6, Qt::DotLine));
    p.drawLine(QPointF(area.x() + split, area.y()), QPointF(area.x() + split, area.bottom()));
    draw_detail(p, QRectF(area.x() + split + 6, area.y(), area.width() - split - 6, area.height()));
}

void ToolSketch::draw_assembly(QPainter& p, const QRectF& area) const {
    const SketchColors c = sketch_colors_of(palette());
    double length = cutter_height_ + tool_.shank_length,
           radius = std::max(cutter_radius_, tool_.shank_diameter / 2);
    for (const HolderSection& h : tool_.holder) {
        length += h.length;
        radius = std::max(radius, h.diameter / 2);
    }
    if (!(length > 0) || !(radius > 0)) return;
    constexpr double text_width = 74, text_height = 34;
    const double scale =
        std::min((area.width() - text_width) / (2 * radius), (area.height() - text_height) / length);
    if (scale <= 0) return;
    p.save();
    p.translate(area.x() + (area.width() - text_width) / 2,
                area.y() + (area.height() + length * scale) / 2 - 8);

    const QPen outline(c.ink, 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    double z = cutter_height_;
    const auto cone = [&](double lower, double upper, double height, const QColor& color) {
        const double diameter = std::max(lower, upper);
        if (diameter <= 0 || height <= 0) return;
        QLinearGradient shade(-diameter / 2 * scale, 0, diameter / 2 * scale, 0);
        shade.setColorAt(0, color.darker(125));
        shade.setColorAt(0.35, color.lighter(112));
        shade.setColorAt(1, color.darker(135));
        p.setBrush(shade);
        p.setPen(outline);
        const double low = -z * scale, high = -(z + height) * scale;
        p.drawPolygon(QPolygonF({QPointF(-lower / 2 * scale, low), QPointF(lower / 2 * scale, low),
                                 QPointF(upper / 2 * scale, high), QPointF(-upper / 2 * scale, high)}));
        z += height;
    };
    const double shank_from = z;
    cone(tool_.shank_diameter, tool_.shank_diameter, tool_.shank_length, c.shank);
    const double holder_from = z;
    for (const HolderPiece& h : holder_pieces(tool_.holder))
        cone(h.lower, h.upper, h.length, c.holder);
    QLinearGradient shade(-cutter_radius_ * scale, 0, cutter_radius_ * scale, 0);
    shade.setColorAt(0, c.cutter.darker(125));
    shade.setColorAt(0.35, c.cutter.lighter(110));
    shade.setColorAt(1, c.cutter.darker(135));
    p.setBrush(shade);
    p.setPen(outline);
    p.drawPath(cutter_path(scale));

    p.setPen(QPen(c.axis, 1, Qt::DashDotLine));
    p.drawLine(QPointF(0, 8), QPointF(0, -length * scale - 8));

    // Lengths stand on the right, one above the other.
    p.setPen(QPen(c.quiet, 1));
    p.setFont(font());
    const double x = radius * scale + 10;
    const auto level = [&](double height) {
        p.drawLine(QPointF(x - 4, -height * scale), QPointF(x + 6, -height * scale));
    };
    double last_text = 1e9;
    const auto length_mark = [&](double from, double to) {
        if (to <= from) return;
        level(from);
        level(to);
        const double middle = -(from + to) / 2 * scale;
        const bool room = last_text - middle > 13; // texts must not lie on each other
        dimension(p, QPointF(x, -from * scale), QPointF(x, -to * scale),
                  room ? shown_length(to - from, unit_, 5) : QString(), QPointF(6, 0), Qt::AlignLeft);
        if (room) last_text = middle;
    };
    p.setPen(QPen(palette().color(QPalette::Text), 0.9));
    length_mark(0, cutter_height_);
    length_mark(shank_from, holder_from);
    length_mark(holder_from, length);
    p.drawText(QRectF(-120, 8, 240, 18), Qt::AlignHCenter | Qt::AlignTop,
               QStringLiteral("⌀ ") + shown_length(2 * cutter_radius_, unit_, 5));
    p.restore();
}

void ToolSketch::draw_detail(QPainter& p, const QRectF& area) const {
    const SketchColors c = sketch_colors_of(palette());
    // The part of the cutter that has a shape: a long straight flute above it says nothing.
    const double shown = std::min(
        cutter_height_, std::max(2.2 * cutter_radius_, 1.3 * (tool_.corner_radius + 0.2 * cutter_radius_)));
    const double scale = std::min((area.width() - 90) / (2 * cutter_radius_), (area.height() - 70) / shown);
    if (scale <= 0) return;
    p.save();
    const QPointF tip(area.x() + area.width() / 2 - 14, area.y() + (area.height() + shown * scale) / 2 - 4);
    p.translate(tip);
    p.save();
    p.setClipRect(QRectF(-area.width(), -shown * scale, 2 * area.width(), shown * scale + 20));
    QLinearGradient shade(-cutter_radius_ * scale, 0, cutter_radius_ * scale, 0);
    shade.setColorAt(0, c.cutter.darker(118));
    shade.setColorAt(0.35, c.cutter.lighter(110));
    shade.setColorAt(1, c.cutter.darker(128));
    p.setBrush(shade);
    p.setPen(QPen(c.ink, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    p.drawPath(cutter_path(scale));
    p.restore();
    p.setPen(QPen(c.axis, 1, Qt::DashDotLine));
    p.drawLine(QPointF(0, 10), QPointF(0, -shown * scale - 10));

    p.setPen(QPen(palette().color(QPalette::Text), 0.9));
    const double top = -shown * scale - 14;
    const double radius_at_top = [&] {
        double widest = 0;
        for (const ProfilePiece& piece : pieces_)
            if (std::min(piece.from.y(), piece.to.y()) <= shown) {
                const double dz = piece.to.y() - piece.from.y();
                const double t = dz > 0 ? std::clamp((shown - piece.from.y()) / dz, 0.0, 1.0) : 1.0;
                widest = std::max(widest, piece.from.x() + t * (piece.to.x() - piece.from.x()));
            }
        return widest;
    }();
    dimension(p, QPointF(-radius_at_top * scale, top), QPointF(radius_at_top * scale, top),
              QStringLiteral("⌀ ") + shown_length(2 * radius_at_top, unit_, 5), QPointF(0, -11),
              Qt::AlignHCenter);
    for (const ProfilePiece& piece : pieces_) {
        if (piece.kind != ProfilePiece::Kind::arc || piece.radius * scale < 4) continue;
        const QPointF center(piece.center.x() * scale, -piece.center.y() * scale);
        const double a = (std::atan2(piece.from.y() - piece.center.y(), piece.from.x() - piece.center.x())
                          + std::atan2(piece.to.y() - piece.center.y(), piece.to.x() - piece.center.x()))
                         / 2;
        const QPointF on(center.x() + piece.radius * scale * std::cos(a),
                         center.y() - piece.radius * scale * std::sin(a));
        p.setBrush(palette().color(QPalette::Text));
        p.drawEllipse(center, 1.8, 1.8);
        p.setBrush(Qt::NoBrush);
        const QPointF out =
            on + (on - center) / std::max(1.0, std::hypot(on.x() - center.x(), on.y() - center.y())) * 16;
        p.drawLine(center, out);
        p.drawText(QRectF(out.x() + 2, out.y() - 6, 100, 16), Qt::AlignLeft | Qt::AlignVCenter,
                   QStringLiteral("r ") + shown_length(piece.radius, unit_, 5));
    }
    QStringList angles;
    if (tool_.bottom_angle != 0)
        angles << QStringLiteral("α %1°").arg(number_text(degrees(tool_.bottom_angle), 4));
    if (tool_.taper_angle != 0)
        angles << QStringLiteral("β %1°").arg(number_text(degrees(tool_.taper_angle), 4));
    const QString below = angles.isEmpty() ? worded(tool_.shape_name())
                                           : worded(tool_.shape_name()) + QStringLiteral(" · ")
                                                 + angles.join(QStringLiteral(" · "));
    p.drawText(QRectF(-area.width() / 2 + 14, 16, area.width(), 18), Qt::AlignHCenter, below);
    p.restore();
}

} // namespace facetmill::ui
