#include "ui/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOption>
#include <QToolTip>

namespace facetmill::ui {

namespace {

struct Shades {
    QColor window, base, alternate, button, text, quiet, light, midlight, mid, dark, shadow, highlight,
        on_highlight, link, disabled, tip, on_tip;
};

QPalette palette_of(const Shades& s) {
    QPalette p;
    p.setColor(QPalette::Window, s.window);
    p.setColor(QPalette::WindowText, s.text);
    p.setColor(QPalette::Base, s.base);
    p.setColor(QPalette::AlternateBase, s.alternate);
    p.setColor(QPalette::Text, s.text);
    p.setColor(QPalette::PlaceholderText, s.quiet);
    p.setColor(QPalette::Button, s.button);
    p.setColor(QPalette::ButtonText, s.text);
    p.setColor(QPalette::BrightText, Qt::white);
    p.setColor(QPalette::Light, s.light);
    p.setColor(QPalette::Midlight, s.midlight);
    p.setColor(QPalette::Mid, s.mid);
    p.setColor(QPalette::Dark, s.dark);
    p.setColor(QPalette::Shadow, s.shadow);
    p.setColor(QPalette::Highlight, s.highlight);
    p.setColor(QPalette::HighlightedText, s.on_highlight);
    p.setColor(QPalette::Link, s.link);
    p.setColor(QPalette::LinkVisited, s.link);
    p.setColor(QPalette::ToolTipBase, s.tip);
    p.setColor(QPalette::ToolTipText, s.on_tip);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, s.disabled);
    p.setColor(QPalette::Disabled, QPalette::Highlight, s.mid);
    p.setColor(QPalette::Disabled, QPalette::HighlightedText, s.disabled);
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

QPalette light_palette() {
    return palette_of({.window = QColor(0xf1f3f5),
                       .base = QColor(0xffffff),
                       .alternate = QColor(0xf6f8fa),
                       .button = QColor(0xf4f6f8),
                       .text = QColor(0x1f2933),
                       .quiet = QColor(0x7b8794),
                       .light = QColor(0xffffff),
                       .midlight = QColor(0xe9edf1),
                       .mid = QColor(0xc4ccd4),
                       .dark = QColor(0xa3aeb9),
                       .shadow = QColor(0x5f6b77),
                       .highlight = QColor(0x1f6fb2),
                       .on_highlight = QColor(0xffffff),
                       .link = QColor(0x1a66a5),
                       .disabled = QColor(0x9aa5b1),
                       .tip = QColor(0x26323d),
                       .on_tip = QColor(0xf1f3f5)});
}

QPalette dark_palette() {
    return palette_of({.window = QColor(0x23282e),
                       .base = QColor(0x2c333a),
                       .alternate = QColor(0x30373f),
                       .button = QColor(0x2d343b),
                       .text = QColor(0xdde3e9),
                       .quiet = QColor(0x8794a1),
                       .light = QColor(0x4a545f),
                       .midlight = QColor(0x3b444d),
                       .mid = QColor(0x3d464f),
                       .dark = QColor(0x15181c),
                       .shadow = QColor(0x0c0e10),
                       .highlight = QColor(0x2f7fc1),
                       .on_highlight = QColor(0xffffff),
                       .link = QColor(0x6cb2ee),
                       .disabled = QColor(0x69747f),
                       .tip = QColor(0x39434d),
                       .on_tip = QColor(0xf1f3f5)});
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
    if (is_dark(palette))
        return {QColor(0x5cc98a), QColor(0xf0b849), QColor(0xff7b72), QColor(0x6cb2ee), QColor(0x8794a1)};
    return {QColor(0x1c7c46), QColor(0xa86400), QColor(0xc0271d), QColor(0x1f6fb2), QColor(0x66727f)};
}

} // namespace facetmill::ui
