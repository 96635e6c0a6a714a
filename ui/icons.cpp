#include "ui/icons.h"

#include "ui/theme.h"
#include "viz/palette.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QMetaEnum>
#include <QPainter>
#include <QPalette>
#include <QRegularExpression>
#include <QSvgRenderer>

#include <map>
#include <memory>

/// The files of resources/icons.qrc. A static library has to ask for what it carries, outside of namespaces.
static void init_files() {
    Q_INIT_RESOURCE(icons);
}

namespace facetmill::ui {

namespace {

constexpr double disabled_opacity = 0.32;

QByteArray read(const QString& name) {
    static const bool ready = (init_files(), true);
    QFile file(QStringLiteral(":/") + name);
    return ready && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

IconColors colors_in(const QPalette& palette, bool selected) {
    const QColor ink = palette.color(selected ? QPalette::HighlightedText : QPalette::ButtonText);
    QColor accent = palette.color(selected ? QPalette::HighlightedText : QPalette::Highlight);
    if (!selected && is_dark(palette)) accent = accent.lighter(125);
    const SignalColors signal = signal_colors(palette);
    // Rings would drown in the highlight.
    return {ink,
            accent,
            signal.good,
            signal.attention,
            signal.bad,
            selected ? ink : signal.busy,
            selected ? ink : signal.quiet};
}

class SvgIcon : public QIconEngine {
public:
    explicit SvgIcon(QString svg) : svg_(std::move(svg)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        painter->save();
        if (mode == QIcon::Disabled) painter->setOpacity(disabled_opacity * painter->opacity());
        const double side = std::min(rect.width(), rect.height());
        const QRectF square(rect.x() + (rect.width() - side) / 2, rect.y() + (rect.height() - side) / 2, side,
                            side);
        drawing(mode == QIcon::Selected).render(painter, square);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        if (size.isEmpty()) return {}; // of a button that has no room at all
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return pixmap;
    }
    QIconEngine* clone() const override { return new SvgIcon(svg_); }

private:
    /// As the palette is now.
    QSvgRenderer& drawing(bool selected) {
        const QString text = with_colors(svg_, colors_in(QApplication::palette(), selected));
        Drawing& d = drawings_[selected ? 1 : 0];
        if (!d.renderer || d.text != text) d = {text, std::make_unique<QSvgRenderer>(text.toUtf8())};
        return *d.renderer;
    }

    struct Drawing {
        QString text;
        std::unique_ptr<QSvgRenderer> renderer;
    };
    QString svg_;
    std::array<Drawing, 2> drawings_; ///< plain and selected
};

} // namespace

QString with_colors(const QString& svg, const IconColors& colors) {
    const std::pair<const char*, QColor> words[] = {{"blue", colors.accent},      {"green", colors.good},
                                                    {"orange", colors.attention}, {"red", colors.bad},
                                                    {"royalblue", colors.busy},   {"gray", colors.quiet}};
    static const QRegularExpression painted(QStringLiteral("\\b(fill|stroke)(=\"|:\\s*)(#?\\w+)"));
    QString result;
    qsizetype end = 0;
    for (auto it = painted.globalMatch(svg); it.hasNext();) {
        const auto match = it.next();
        const QString word = match.captured(3);
        result += svg.mid(end, match.capturedStart(3) - end);
        end = match.capturedEnd(3);
        QString shown = word;
        if (word == QLatin1String("currentColor"))
            shown = colors.ink.name();
        else if (QColor::isValidColor(word))
            for (const auto& [named, color] : words)
                if (QColor(word) == QColor(named)) shown = color.name();
        result += shown;
    }
    return result + svg.mid(end);
}

QIcon svg_icon(const QString& svg) {
    return QIcon(new SvgIcon(svg));
}

QIcon icon(Icon which) {
    static std::map<Icon, QIcon> made;
    QIcon& result = made[which];
    if (result.isNull()) {
        const char* name = QMetaEnum::fromType<Icon>().valueToKey(int(which));
        result = svg_icon(QString::fromUtf8(read(QStringLiteral("icons/%1.svg").arg(QLatin1String(name)))));
    }
    return result;
}

QIcon application_icon() {
    // Drawn once: what every window drew anew would be kept in Qt's cache of pixmaps once more for each of
    // them.
    static const QIcon made = [] {
        QIcon result;
        QSvgRenderer drawing(read(QStringLiteral("facetmill.svg")));
        for (const int side : {16, 24, 32, 48, 64, 128, 256}) {
            QPixmap pixmap(side, side);
            pixmap.fill(Qt::transparent);
            QPainter p(&pixmap);
            drawing.render(&p);
            result.addPixmap(pixmap);
        }
        return result;
    }();
    return made;
}

QPixmap swatch(const Rgb& color, qreal device_pixel_ratio) {
    QPixmap pixmap(QSize(swatch_size, swatch_size) * device_pixel_ratio);
    pixmap.setDevicePixelRatio(device_pixel_ratio);
    pixmap.fill(Qt::transparent);
    QPainter p(&pixmap);
    p.setRenderHint(QPainter::Antialiasing);
    p.setPen(Qt::NoPen);
    p.setBrush(to_qt(color));
    p.drawRoundedRect(QRectF(0.5, 0.5, swatch_size - 1, swatch_size - 1), 2.5, 2.5);
    return pixmap;
}

} // namespace facetmill::ui
