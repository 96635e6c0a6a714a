#include "tests/screenshot/shown_texts.h"

#include "ui/language.h"
#include "viz/overlay_words.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QFile>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QSet>
#include <QTabBar>
#include <QTableWidget>
#include <QTextDocument>
#include <QTextEdit>
#include <QTreeWidget>
#include <QXmlStreamReader>

#include <algorithm>

namespace facetmill::test {

namespace {

QString without_marks(const QString& text) {
    if (!Qt::mightBeRichText(text)) return text;
    QTextDocument document;
    document.setHtml(text);
    return document.toPlainText();
}

/// As the catalogue may have it: without mnemonics, and what stands at the end.
QString bare(const QString& text) {
    QString words = text.section(QChar('\t'), 0, 0);
    words.replace(QStringLiteral("&&"), QStringLiteral("\x01")).remove(QChar('&'));
    words.replace(QChar('\x01'), QStringLiteral("&"));
    words.replace(QChar(0x00A0), QChar(' ')); // sentences have it between a number and its unit
    words = words.trimmed();
    while (!words.isEmpty() && QStringLiteral(":.").contains(words.back()))
        words.chop(1);
    return words;
}

void add_models(const QWidget& w, QStringList& all) {
    if (const auto* tree = qobject_cast<const QTreeWidget*>(&w)) {
        for (QTreeWidgetItemIterator it(const_cast<QTreeWidget*>(tree)); *it; ++it)
            for (int c = 0; c < tree->columnCount(); ++c)
                all << (*it)->text(c) << (*it)->toolTip(c);
    } else if (const auto* list = qobject_cast<const QListWidget*>(&w)) {
        for (int i = 0; i < list->count(); ++i)
            all << list->item(i)->text() << list->item(i)->toolTip();
    } else if (const auto* table = qobject_cast<const QTableWidget*>(&w)) {
        for (int r = 0; r < table->rowCount(); ++r)
            for (int c = 0; c < table->columnCount(); ++c)
                if (const QTableWidgetItem* item = table->item(r, c)) all << item->text() << item->toolTip();
    } else if (const auto* heads = qobject_cast<const QHeaderView*>(&w);
               heads && heads->orientation() == Qt::Horizontal) {
        for (int i = 0; i < heads->count(); ++i)
            if (!heads->isHidden()) all << heads->model()->headerData(i, Qt::Horizontal).toString();
    }
}

void add_texts(const QWidget& w, QStringList& all) {
    all << w.toolTip();
    if (const auto* label = qobject_cast<const QLabel*>(&w))
        all << label->text();
    else if (const auto* button = qobject_cast<const QAbstractButton*>(&w))
        all << button->text();
    else if (const auto* line = qobject_cast<const QLineEdit*>(&w))
        all << line->text() << line->placeholderText();
    else if (const auto* box = qobject_cast<const QComboBox*>(&w))
        for (int i = 0; i < box->count(); ++i)
            all << box->itemText(i);
    else if (const auto* group = qobject_cast<const QGroupBox*>(&w))
        all << group->title();
    else if (const auto* text = qobject_cast<const QTextEdit*>(&w))
        all << text->toPlainText();
    else if (const auto* log = qobject_cast<const QPlainTextEdit*>(&w))
        all << log->toPlainText();
    else if (const auto* tabs = qobject_cast<const QTabBar*>(&w))
        for (int i = 0; i < tabs->count(); ++i)
            all << tabs->tabText(i) << tabs->tabToolTip(i);
    else if (const auto* menus = qobject_cast<const QMenuBar*>(&w))
        for (const QAction* menu : menus->actions())
            all << menu->text();
    else
        add_models(w, all);
}

} // namespace

QStringList shown_texts(const QWidget& window) {
    QStringList all{window.windowTitle()};
    for (const QWidget* w : window.findChildren<const QWidget*>())
        if (w->isVisible() && w->window() == &window) add_texts(*w, all);
    QSet<QString> lines;
    for (const QString& text : all)
        for (const QString& line : without_marks(text).split(QChar('\n')))
            if (!line.trimmed().isEmpty()) lines << line;
    return {lines.begin(), lines.end()};
}

bool has_silly_figure(const QString& shown) {
    static const QRegularExpression silly(
        QStringLiteral("(?<![\\w.,])(?:0[.,]00000\\d*[1-9]|\\d+(?:[.,]\\d+)?e-\\d+)(?![\\w.,]*[A-Za-z])"));
    return silly.match(shown).hasMatch();
}

EnglishTexts::EnglishTexts(const QString& language) {
    QFile file(QStringLiteral(FACETMILL_TEST_DATA "/../resources/languages/facetmill_%1.ts").arg(language));
    if (!file.open(QIODevice::ReadOnly)) return;
    static const QRegularExpression place(QStringLiteral("%L?\\d|%n|\\{\\d+\\}"));
    static const QRegularExpression word(QStringLiteral("[A-Za-z]{3,}"));
    QXmlStreamReader xml(&file);
    QString source;
    while (!xml.atEnd()) {
        if (!xml.readNextStartElement()) continue;
        if (xml.name() == QLatin1String("source")) {
            source = xml.readElementText();
            continue;
        }
        if (xml.name() != QLatin1String("translation")) continue;
        const QString said = xml.readElementText(QXmlStreamReader::IncludeChildElements);
        const QString english = bare(without_marks(source));
        translated_.insert(bare(without_marks(said)), true);
        if (bare(without_marks(said)) == english || !english.contains(word)) continue;
        QStringList between = english.split(place);
        if (between.size() == 1) {
            plain_.insert(english, true);
            continue;
        }
        const QString longest = *std::max_element(
            between.begin(), between.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
        if (longest.trimmed().size() >= 8) templates_.push_back({between, longest});
    }
}

bool EnglishTexts::is_of(const QString& shown, const Template& one) const {
    if (!shown.contains(one.longest) || !shown.startsWith(one.between.front())
        || !shown.endsWith(one.between.back()))
        return false;
    qsizetype at = 0;
    for (const QString& part : one.between) {
        at = shown.indexOf(part, at);
        if (at < 0) return false;
        at += part.size();
    }
    return true;
}

QString EnglishTexts::in(const QString& shown) const {
    static const QRegularExpression point(QStringLiteral("(?<![\\w.])\\d+\\.\\d+(?![\\w.])"));
    // Versions are no numbers.
    static const QRegularExpression version(QStringLiteral("\\b(Grbl |Apache\\D{0,12}|G54 ?)\\d+\\.\\d+"));
    QString words = bare(shown);
    words.remove(version);
    if (const auto number = point.match(words); number.hasMatch())
        return QStringLiteral("“%1”: %2").arg(words.left(120), number.captured());
    if (translated_.contains(words)) return {};
    if (plain_.contains(words)) return QStringLiteral("“%1”").arg(words.left(120));
    for (const Template& one : templates_)
        if (is_of(words, one))
            return QStringLiteral("“%1”: %2").arg(words.left(120), one.between.join(QChar(0x2026)).left(80));
    return {};
}

PaintedTexts::PaintedTexts() {
    set_overlay_words([this](const std::string& english) {
        const std::string said = ui::said_in_view(english);
        texts_ << QString::fromStdString(said);
        return said;
    });
}

PaintedTexts::~PaintedTexts() {
    set_overlay_words(ui::said_in_view);
}

QStringList PaintedTexts::not_in(const EnglishTexts& english) const {
    QStringList found;
    for (const QString& text : texts_)
        for (const QString& part : text.split(QStringLiteral(", ")))
            if (const QString why = english.in(part); !why.isEmpty())
                found << QStringLiteral("in the view: “%1”: %2").arg(text, why);
    return found;
}

} // namespace facetmill::test
