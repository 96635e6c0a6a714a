#include "ui/operation_menu.h"

#include "core/strategy/plan/operation.h"
#include "ui/help_pages.h"
#include "ui/icons.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/worded.h"

#include <QApplication>
#include <QIconEngine>
#include <QMenu>
#include <QObject>
#include <QPainter>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace facetmill::ui {

namespace {

QString drawing_name(const std::string& kind) {
    return QStringLiteral("operation_") + text(kind);
}

/// A drawing is as high as this share of its width.
constexpr double drawing_share = 130.0 / 240.0;
/// Narrower ones could not be made out.
constexpr int narrowest_drawing = 48;
constexpr int picture_width = 62; // points, in menus: so all kinds stand in one column of 600 points

/// As the manual tells of them: what is done first, what is asked for most; others behind these.
std::vector<OperationKind> kinds_in_order() {
    constexpr std::array<std::string_view, 15> order = {
        "rough",   "finish3", "waterline",    "scallop",     "steep_shallow",
        "cleanup", "pencil",  "along_curve",  "radial",      "spiral",
        "morph",   "finish5", "global_local", "lathe_rough", "lathe_finish"};
    std::vector<OperationKind> kinds = operation_kinds();
    const auto place = [&](const OperationKind& k) { return std::find(order.begin(), order.end(), k.kind); };
    std::stable_sort(kinds.begin(), kinds.end(),
                     [&](const OperationKind& a, const OperationKind& b) { return place(a) < place(b); });
    return kinds;
}

class OperationIcon : public QIconEngine {
public:
    explicit OperationIcon(std::string kind) : kind_(std::move(kind)) {}

    QSize actualSize(const QSize& size, QIcon::Mode, QIcon::State) override {
        return drawn(size) ? QSize(size.width(), int(size.width() * drawing_share)) : size;
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        return scaledPixmap(size, mode, state, 1);
    }
    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State, qreal scale) override {
        // The size is in pixels; an icon that is asked for a small one has that many points.
        if (!drawn(size / scale)) return icon(Icon::operation).pixmap(size / scale, scale, mode);
        QPixmap plain = QPixmap::fromImage(
            help_drawing(drawing_name(kind_), QApplication::palette(), int(size.width() / scale), scale));
        if (mode != QIcon::Disabled) return plain;
        constexpr double faint = 0.4;
        QPixmap pale(plain.size());
        pale.setDevicePixelRatio(scale);
        pale.fill(Qt::transparent);
        QPainter painter(&pale);
        painter.setOpacity(faint);
        painter.drawPixmap(0, 0, plain);
        return pale;
    }
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const qreal scale = painter->device()->devicePixelRatioF();
        const QPixmap shown = scaledPixmap(rect.size() * scale, mode, state, scale);
        const QSizeF size = shown.deviceIndependentSize();
        painter->drawPixmap(
            QRectF(rect.center() - QPointF(size.width() / 2, size.height() / 2) + QPointF(0.5, 0.5), size),
            shown, QRectF(shown.rect()));
    }
    QIconEngine* clone() const override { return new OperationIcon(kind_); }

private:
    bool drawn(const QSize& size) const {
        return size.width() >= narrowest_drawing
               && !help_file(QStringLiteral("drawings/%1.svg").arg(drawing_name(kind_))).isEmpty();
    }

    std::string kind_;
};

} // namespace

QString operation_label(const std::string& kind) {
    // What core says in one word is no message of the catalogues: users give such names.
    if (kind == "rough") return QObject::tr("Rough");
    if (kind == "cleanup") return QObject::tr("Clean-up");
    for (const OperationKind& k : operation_kinds())
        if (k.kind == kind) return worded(k.label);
    return text(kind);
}

QString operation_words(const std::string& kind) {
    if (kind == "rough") return QMenu::tr("Takes the stock down layer by layer, and leaves an allowance");
    if (kind == "finish3") return QMenu::tr("Passes side by side over the surface, with an upright tool");
    if (kind == "waterline")
        return QMenu::tr("Goes round steep walls and flanks at one height after another");
    if (kind == "scallop")
        return QMenu::tr(
            "Passes that follow a border or a curve or go round a place, with cusps of one height");
    if (kind == "steep_shallow")
        return QMenu::tr("Divides the part by slope: levels round what is steep, passes over the rest");
    if (kind == "cleanup") return QMenu::tr("Cuts the valleys that a larger tool could not enter");
    if (kind == "pencil")
        return QMenu::tr("Runs along the valleys that the cutter touches on both sides, and beside them");
    if (kind == "along_curve")
        return QMenu::tr(
            "Follows a curve drawn on the part or the outline, on it or beside it: engraving, trimming");
    if (kind == "radial") return QMenu::tr("Passes from a centre outward, like the spokes of a wheel");
    if (kind == "spiral") return QMenu::tr("One pass that winds about a centre, for what is round");
    if (kind == "morph")
        return QMenu::tr("Passes that go over from one curve to another, the way the part flows");
    if (kind == "finish5")
        return QMenu::tr("The tool leans, so that a flat or bull-nosed cutter leaves wide strips");
    if (kind == "global_local")
        return QMenu::tr("A fast main path with five axes, and a smaller tool for the regions it leaves");
    if (kind == "lathe_rough") return QMenu::tr("Takes the stock of a turning part down in passes");
    if (kind == "lathe_finish") return QMenu::tr("A helix, rings or lengthwise lines over a part that turns");
    return {};
}

QIcon operation_picture(const std::string& kind) {
    return QIcon(new OperationIcon(kind));
}

void show_pictures(QMenu* menu) {
    menu->setProperty(menu_icon_property, picture_width);
    menu->setToolTipsVisible(true);
}

QMenu* operation_menu(QWidget* parent, const std::function<void(const std::string&)>& add) {
    auto* menu = new QMenu(QMenu::tr("Add operation"), parent);
    menu->setObjectName(QStringLiteral("operation_menu"));
    menu->setIcon(icon(Icon::operation));
    show_pictures(menu);
    for (const OperationKind& kind : kinds_in_order()) {
        QAction* entry = menu->addAction(operation_picture(kind.kind), operation_label(kind.kind), parent,
                                         [add, name = kind.kind] { add(name); });
        entry->setData(text(kind.kind));
        entry->setToolTip(operation_words(kind.kind));
    }
    return menu;
}

} // namespace facetmill::ui
