#include "ui/help_pages.h"

#include "ui/icons.h"
#include "ui/language.h"
#include "ui/theme.h"

#include <QApplication>
#include <QBuffer>
#include <QFile>
#include <QPainter>
#include <QSet>
#include <QSvgRenderer>

#include <map>

/// The pages that were made while building. A static library has to ask for what it carries, outside of
/// namespaces.
static void init_manual() {
    Q_INIT_RESOURCE(manual);
}

namespace facetmill::ui {

const std::vector<HelpSection>& help_sections() {
    static std::map<QString, std::vector<HelpSection>> all;
    const auto [found, unread] = all.try_emplace(spoken_language());
    std::vector<HelpSection>& sections = found->second;
    if (unread)
        for (const QString& line :
             QString::fromUtf8(help_file(QStringLiteral("index.tsv"))).split(QChar('\n'))) {
            const QStringList cells = line.split(QChar('\t'));
            if (cells.size() == 4) sections.push_back({cells[0], cells[1].toInt(), cells[2], cells[3]});
        }
    return sections;
}

bool has_help(const QString& topic) {
    // The same in all languages, which a test watches.
    static const QSet<QString> topics = [] {
        QSet<QString> all;
        for (const HelpSection& s : help_sections())
            all << s.topic;
        return all;
    }();
    return topics.contains(topic);
}

std::vector<const HelpSection*> find_help(const QString& words) {
    const QStringList all = words.split(QChar(' '), Qt::SkipEmptyParts);
    if (all.isEmpty()) return {};
    const auto has = [&](const QString& text) {
        return std::all_of(all.begin(), all.end(),
                           [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
    };
    std::vector<const HelpSection*> titled, others;
    for (const HelpSection& s : help_sections()) {
        if (has(s.title))
            titled.push_back(&s);
        else if (has(s.title + QChar(' ') + s.text))
            others.push_back(&s);
    }
    titled.insert(titled.end(), others.begin(), others.end());
    return titled;
}

QByteArray help_file(const QString& name) {
    static const bool ready = (init_manual(), true);
    QFile file(QStringLiteral(":/manual/%1/%2").arg(spoken_language(), name));
    if (spoken_language().isEmpty() || !file.exists()) file.setFileName(QStringLiteral(":/manual/") + name);
    return ready && file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QString help_style(const QPalette& palette) {
    QString style = QString::fromUtf8(help_file(QStringLiteral("window.css")));
    const QColor text = palette.color(QPalette::Text), base = palette.color(QPalette::Base);
    for (const auto& [word, color] : {std::pair{"@text", text},
                                      {"@link", palette.color(QPalette::Link)},
                                      {"@accent", mixed(text, 2, palette.color(QPalette::Link))},
                                      {"@raised", palette.color(QPalette::AlternateBase)},
                                      {"@line", mixed(base, 4, text)},
                                      {"@quiet", palette.color(QPalette::PlaceholderText)}})
        style.replace(QLatin1String(word), color.name());
    return style;
}

QString parameter_drawing(const QString& scope, const QString& key) {
    static const std::map<QString, QString> drawings = [] {
        std::map<QString, QString> all;
        const QString table = QString::fromUtf8(help_file(QStringLiteral("parameters.txt")));
        for (const QString& line : table.split(QChar('\n'), Qt::SkipEmptyParts))
            all[line.section(QChar(' '), 0, 0)] = line.section(QChar(' '), 1, 1);
        return all;
    }();
    auto found = drawings.find(scope + QChar('.') + key);
    if (found == drawings.end()) found = drawings.find(key);
    return found == drawings.end() || found->second == QLatin1String("-") ? QString() : found->second;
}

QImage help_drawing(const QString& name, const QPalette& palette, int width, qreal pixel_ratio) {
    const QByteArray svg = help_file(QStringLiteral("drawings/%1.svg").arg(name));
    if (svg.isEmpty()) return {};
    const SignalColors signal = signal_colors(palette);
    const IconColors colors{palette.color(QPalette::Text),
                            palette.color(QPalette::Link),
                            signal.good,
                            signal.attention,
                            signal.bad,
                            signal.busy,
                            palette.color(QPalette::PlaceholderText)};
    QSvgRenderer drawing(with_colors(QString::fromUtf8(svg), colors).toUtf8());
    const QSizeF own = drawing.defaultSize();
    QImage image(QSizeF(width * pixel_ratio, width * pixel_ratio * own.height() / own.width()).toSize(),
                 QImage::Format_ARGB32_Premultiplied);
    image.fill(0);
    QPainter painter(&image);
    drawing.render(&painter);
    painter.end();
    image.setDevicePixelRatio(pixel_ratio);
    return image;
}

QString help_drawing_html(const QString& name, const QPalette& palette, int width) {
    // Forms ask for the same few again and again.
    static std::map<QString, QString> made;
    QString& html = made[name + QString::number(width) + palette.color(QPalette::Text).name()
                         + palette.color(QPalette::Link).name()];
    if (!html.isEmpty()) return html;
    // The text shows the picture at the size that is named: drawn finer, it is sharp on fine screens.
    constexpr qreal fine = 2;
    QImage image = help_drawing(name, palette, width, fine);
    if (image.isNull()) return {};
    image.setDevicePixelRatio(1);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    html = QStringLiteral("<img src=\"data:image/png;base64,%1\" width=\"%2\" height=\"%3\">")
               .arg(QString::fromLatin1(bytes.toBase64()))
               .arg(width)
               .arg(width * image.height() / image.width());
    return html;
}

} // namespace facetmill::ui
