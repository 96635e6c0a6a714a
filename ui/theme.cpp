#include "ui/theme.h"

#include "ui/whole_text.h"
#include "viz/palette.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOption>
#include <QToolTip>

#include <algorithm>

namespace facetmill::ui {

namespace {

QPalette palette_of(const WidgetColors& s) {
    QPalette p;
    p.setColor(QPalette::Window, to_qt(s.window));
    p.setColor(QPalette::WindowText, to_qt(s.text));
    p.setColor(QPalette::Base, to_qt(s.base));
    p.setColor(QPalette::AlternateBase, to_qt(s.alternate));
    p.setColor(QPalette::Text, to_qt(s.text));
    p.setColor(QPalette::PlaceholderText, to_qt(s.quiet));
    p.setColor(QPalette::Button, to_qt(s.button));
    p.setColor(QPalette::ButtonText, to_qt(s.text));
    p.setColor(QPalette::BrightText, to_qt(s.bright));
    p.setColor(QPalette::Light, to_qt(s.light));
    p.setColor(QPalette::Midlight, to_qt(s.midlight));
    p.setColor(QPalette::Mid, to_qt(s.mid));
    p.setColor(QPalette::Dark, to_qt(s.dark));
    p.setColor(QPalette::Shadow, to_qt(s.shadow));
    p.setColor(QPalette::Highlight, to_qt(s.highlight));
    p.setColor(QPalette::HighlightedText, to_qt(s.on_highlight));
    p.setColor(QPalette::Link, to_qt(s.link));
    p.setColor(QPalette::LinkVisited, to_qt(s.link));
    p.setColor(QPalette::ToolTipBase, to_qt(s.tip));
    p.setColor(QPalette::ToolTipText, to_qt(s.on_tip));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, to_qt(s.disabled));
    p.setColor(QPalette::Disabled, QPalette::Highlight, to_qt(s.mid));
    p.setColor(QPalette::Disabled, QPalette::HighlightedText, to_qt(s.disabled));
    return p;
}

constexpr char style_name[] = "facetmill";

/// Fusion without the pictures on the buttons of dialogs, which belong to no theme of ours.
class WorkbenchStyle : public QProxyStyle {
public:
    WorkbenchStyle() : QProxyStyle(QStringLiteral("Fusion")) { setObjectName(QLatin1String(style_name)); }
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* data) const override {
        if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
        if (hint == SH_Slider_AbsoluteSetButtons) return Qt::LeftButton; // a click on a slider goes there
        return QProxyStyle::styleHint(hint, option, widget, data);
    }
    int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
        if (metric == PM_SmallIconSize && widget)
            if (const QVariant own = widget->property(menu_icon_property);
                own.isValid() && !is_sign(option, own.toInt()))
                return own.toInt();
        return QProxyStyle::pixelMetric(metric, option, widget);
    }
    QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                           const QWidget* widget) const override {
        QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
        const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
        if (type != CT_MenuItem || !item || item->icon.isNull() || !widget) return size;
        const QVariant wide = widget->property(menu_icon_property);
        if (!wide.isValid() || is_sign(option, wide.toInt())) return size;
        constexpr int around = 6;
        const int high = item->icon.actualSize(QSize(wide.toInt(), wide.toInt())).height() + around;
        return {size.width(), std::max(size.height(), high)};
    }
    using QProxyStyle::polish;
    void polish(QWidget* widget) override {
        QProxyStyle::polish(widget);
        const bool field = qobject_cast<QLineEdit*>(widget)
                           && !qobject_cast<QComboBox*>(widget->parentWidget())
                           && !qobject_cast<QAbstractSpinBox*>(widget->parentWidget());
        if ((field || qobject_cast<QComboBox*>(widget))
            && !widget->findChild<WholeText*>(QString(), Qt::FindDirectChildrenOnly))
            widget->installEventFilter(new WholeText(widget));
    }
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
        const auto* box = qstyleoption_cast<const QStyleOptionComboBox*>(option);
        if (element != CE_ComboBoxLabel || !box || box->editable)
            return QProxyStyle::drawControl(element, option, painter, widget);
        QStyleOptionComboBox shown(*box);
        const int icon = box->currentIcon.isNull() ? 0 : box->iconSize.width() + 4;
        const int room = subControlRect(CC_ComboBox, box, SC_ComboBoxEditField, widget).width() - icon;
        shown.currentText = box->fontMetrics.elidedText(box->currentText, Qt::ElideRight, room);
        QProxyStyle::drawControl(element, &shown, painter, widget);
    }
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        // Fusion outlines boxes in a darker shade of the window: on a dark one nobody would see them.
        if ((element != PE_IndicatorCheckBox && element != PE_IndicatorRadioButton)
            || !is_dark(option->palette))
            return;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setBrush(Qt::NoBrush);
        painter->setPen(option->palette.color(QPalette::PlaceholderText));
        const QRectF box = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
        if (element == PE_IndicatorCheckBox)
            painter->drawRect(box);
        else
            painter->drawEllipse(box);
        painter->restore();
    }

private:
    /// An entry of a menu with an icon that is as high as it is wide: a sign beside pictures, and small.
    static bool is_sign(const QStyleOption* option, int width) {
        const auto* item = qstyleoption_cast<const QStyleOptionMenuItem*>(option);
        return item && !item->icon.isNull() && item->icon.actualSize(QSize(width, width)).height() >= width;
    }
};

} // namespace

Theme theme_from_name(const QString& name) {
    if (name == QLatin1String("light")) return Theme::light;
    if (name == QLatin1String("dark")) return Theme::dark;
    return Theme::system;
}

QString theme_name(Theme theme) {
    switch (theme) {
    case Theme::light:
        return QStringLiteral("light");
    case Theme::dark:
        return QStringLiteral("dark");
    case Theme::system:
        break;
    }
    return QStringLiteral("system");
}

// Made once: what the style draws it keeps by palette, and a palette made anew, though of the same colours,
// is another one.
QPalette light_palette() {
    static const QPalette made = palette_of(colors_of(Palette::light).widgets);
    return made;
}

QPalette dark_palette() {
    static const QPalette made = palette_of(colors_of(Palette::dark).widgets);
    return made;
}

QColor to_qt(const Rgb& color) {
    return QColor::fromRgbF(float(color.r), float(color.g), float(color.b));
}

const Colors& view_colors(const QPalette& palette) {
    return colors_of(is_dark(palette) ? Palette::dark : Palette::light);
}

QColor mixed(const QColor& ground, int parts, const QColor& mark) {
    const auto mix = [&](int g, int m) { return (g * parts + m) / (parts + 1); };
    return QColor(mix(ground.red(), mark.red()), mix(ground.green(), mark.green()),
                  mix(ground.blue(), mark.blue()));
}

bool is_dark(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() < 128;
}

void apply_theme(QApplication& app, Theme theme) {
    // Asked for once, before a palette of ours hides the desktop's.
    static const bool desktop_is_dark = is_dark(QApplication::palette());
    if (app.style()->objectName() != QLatin1String(style_name)) QApplication::setStyle(new WorkbenchStyle);
    const bool dark = theme == Theme::dark || (theme == Theme::system && desktop_is_dark);
    const QPalette palette = dark ? dark_palette() : light_palette();
    QApplication::setPalette(palette);
    QToolTip::setPalette(palette);
}

SignalColors signal_colors(const QPalette& palette) {
    const SignalShades& s = view_colors(palette).signal;
    return {to_qt(s.good), to_qt(s.attention), to_qt(s.bad), to_qt(s.busy), to_qt(s.quiet)};
}

} // namespace facetmill::ui
