// The manual in all its languages: every page is there, built like the English one, with the same places to
// land at, and what is bold is called as the window calls it in that language.
#include "app/manual/pages.h"
#include "tests/support/test_runner.h"

#include <QFile>
#include <QMultiMap>
#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

#include <algorithm>
#include <map>

using namespace facetmill;
using namespace facetmill::manual;

namespace {

const std::filesystem::path& manual_resources() {
    static const std::filesystem::path folder = std::filesystem::path(FACETMILL_SOURCE) / "resources";
    return folder;
}

QString in_qt(const std::string& text) {
    return QString::fromStdString(text);
}

/// As a menu or a button has it, without marks for keys; signs that a page sets finer are those of the files.
QString bare_name(QString name) {
    name = name.section(QChar('\t'), 0, 0).remove(QChar('&')).remove(QChar(0x2026));
    name.replace(QChar(0xa0), QChar(' ')).replace(QChar(0x2019), QChar('\''));
    name = name.trimmed();
    return name.endsWith(QChar(':')) ? name.chopped(1).trimmed() : name;
}

/// What the window calls what it calls `key` in English.
QMultiMap<QString, QString> window_names(const std::string& language) {
    QFile file(in_qt((manual_resources() / "languages" / ("facetmill_" + language + ".ts")).string()));
    QMultiMap<QString, QString> names;
    if (!file.open(QIODevice::ReadOnly)) return names;
    QXmlStreamReader xml(&file);
    for (QString source; !xml.atEnd();) {
        if (!xml.readNextStartElement()) continue;
        if (xml.name() == QLatin1String("source"))
            source = bare_name(xml.readElementText());
        else if (xml.name() == QLatin1String("translation"))
            names.insert(source, bare_name(xml.readElementText(QXmlStreamReader::IncludeChildElements)));
    }
    return names;
}

QStringList names_for(const QMultiMap<QString, QString>& names, const QString& english) {
    QStringList all = names.values(english);
    if (!all.isEmpty()) return all;
    // "Mirror X" is "Mirror %1".
    const qsizetype blank = english.lastIndexOf(QChar(' '));
    const QString last = english.mid(blank + 1);
    for (QString with_place : names.values(english.left(blank) + QStringLiteral(" %1")))
        all << with_place.replace(QStringLiteral("%1"), last);
    return all;
}

QStringList captured(const QString& html, const QRegularExpression& what) {
    QStringList all;
    for (auto it = what.globalMatch(html); it.hasNext();)
        all << it.next().captured(what.captureCount() > 0 ? 1 : 0);
    return all;
}

QString html_of(const NamedPage& page) {
    return in_qt(page.page.html).replace(QStringLiteral("../"), QString());
}

/// Headings, places, paragraphs, lists, tables, code and pictures in their order.
QStringList outline(const QString& html) {
    static const QRegularExpression blocks(
        QStringLiteral("<h\\d><a name=\"[^\"]*\"|<a name=\"[^\"]*\"|<img src=\"[^\"]*\"|<pre>[^<]*|"
                       "</?(?:p|ul|ol|li|table|tr|th|td|h\\d)\\b"));
    return captured(html, blocks);
}

QStringList in_bold(const QString& html) {
    static const QRegularExpression bold(QStringLiteral("<b>(.*?)</b>"));
    QStringList names;
    for (const QString& one : captured(html, bold))
        for (QString name : one.split(QStringLiteral(" ▸ "))) {
            name.replace(QStringLiteral("&quot;"), QStringLiteral("\""))
                .replace(QStringLiteral("&amp;"), QStringLiteral("&"));
            names << bare_name(name);
        }
    return names;
}

bool is_reference(const NamedPage& page) {
    return page.file.starts_with("reference");
}

} // namespace

class TestManualPages : public QObject {
    Q_OBJECT

    std::vector<NamedPage> english_;

    static void each_language() {
        QTest::addColumn<QString>("language");
        for (const std::string& language : manual_languages(manual_resources()))
            QTest::newRow(language.c_str()) << in_qt(language);
    }
    static std::vector<NamedPage> pages_in(const QString& language) {
        return manual_pages(manual_resources(), Words(manual_resources(), language.toStdString()));
    }

private slots:
    void initTestCase() {
        english_ = manual_pages(manual_resources(), Words());
        QVERIFY(english_.size() > 30);
    }

    void every_language_of_the_window_has_every_page() {
        std::vector<std::string> spoken;
        for (const auto& entry : std::filesystem::directory_iterator(manual_resources() / "languages")) {
            const std::string name = entry.path().stem().string();
            if (entry.path().extension() == ".ts" && name != "facetmill_en")
                spoken.push_back(name.substr(10));
        }
        std::sort(spoken.begin(), spoken.end());
        QVERIFY(spoken.size() >= 2);
        QVERIFY(manual_languages(manual_resources()) == spoken);
        for (const std::string& language : spoken) {
            std::size_t count = 0;
            for (const NamedPage& page : pages_in(in_qt(language))) {
                if (is_reference(page)) continue;
                ++count;
                QCOMPARE(in_qt(page.source.string()),
                         in_qt((manual_resources() / "manual" / language / (page.file + ".md")).string()));
            }
            // None is left over that English has no more.
            std::size_t files = 0;
            for (const auto& entry :
                 std::filesystem::directory_iterator(manual_resources() / "manual" / language))
                files += entry.path().extension() == ".md" ? 1 : 0;
            QCOMPARE(files, count);
        }
    }

    void pages_are_built_alike_data() { each_language(); }
    void pages_are_built_alike() {
        QFETCH(QString, language);
        static const QRegularExpression code(QStringLiteral("<code>(.*?)</code>")),
            link(QStringLiteral("<a href=\"([^\"]*)\""));
        const std::vector<NamedPage> pages = pages_in(language);
        QCOMPARE(pages.size(), english_.size());
        for (std::size_t i = 0; i < pages.size(); ++i) {
            QCOMPARE(pages[i].file, english_[i].file);
            const QString own = html_of(pages[i]), english = html_of(english_[i]);
            const QStringList blocks = outline(own), of_english = outline(english);
            for (qsizetype k = 0; k < std::min(blocks.size(), of_english.size()); ++k)
                if (blocks[k] != of_english[k])
                    QFAIL(qPrintable(QStringLiteral("%1.md: behind %2 stands %3, in English %4")
                                         .arg(in_qt(pages[i].file),
                                              blocks.mid(std::max<qsizetype>(0, k - 6), 6).join(QChar(' ')),
                                              blocks[k], of_english[k])));
            QCOMPARE(blocks.size(), of_english.size());
            // The code's own words are for those who write it; what parameters are for is said as in the
            // window.
            if (pages[i].file == "glossary" || is_reference(pages[i])) continue;
            // Words change their order in a sentence, and what is written for a machine stays what it is.
            for (const QRegularExpression& what : {code, link}) {
                QStringList here = captured(own, what), there = captured(english, what);
                here.sort();
                there.sort();
                QVERIFY2(here == there, qPrintable(QStringLiteral("%1: %2 ≠ %3")
                                                       .arg(in_qt(pages[i].file), here.join(QChar(' ')),
                                                            there.join(QChar(' ')))));
            }
        }
    }

    void pictures_of_the_window_speak_the_language_data() { each_language(); }
    void pictures_of_the_window_speak_the_language() {
        QFETCH(QString, language);
        static const QRegularExpression picture(QStringLiteral("<img src=\"((?:\\.\\./)?pictures/[^\"]*)\""));
        const std::vector<std::string> own = own_pictures(manual_resources(), language.toStdString());
        QVERIFY(own.size() >= 8);
        std::size_t shown = 0;
        for (const NamedPage& page : pages_in(language))
            for (const QString& file : captured(in_qt(page.page.html), picture)) {
                const std::string name = file.section(QChar('/'), -1).toStdString();
                const bool has_own = std::find(own.begin(), own.end(), name) != own.end();
                // English ones stand in the folder above; these have next to no words.
                QCOMPARE(file.startsWith(QStringLiteral("../")), !has_own);
                QVERIFY2(has_own || name == "cspace_crowded.png", name.c_str());
                ++shown;
            }
        QVERIFY(shown >= own.size()); // none is shown nowhere
    }

    void nothing_stands_in_english_data() { each_language(); }
    void nothing_stands_in_english() {
        QFETCH(QString, language);
        const Words words(manual_resources(), language.toStdString());
        const std::vector<NamedPage> pages = manual_pages(manual_resources(), words);
        QStringList found;
        for (const std::string& text : words.missing())
            found << in_qt(text);
        static const QRegularExpression paragraph(
            QStringLiteral("<(?:p|li|td|h\\d)\\b[^>]*>(.*?)</(?:p|li|td|h\\d)>")),
            inner(QStringLiteral("<code>.*?</code>|<[^>]*>")), word(QStringLiteral("[a-z]{3,}")),
            decimal_point(QStringLiteral("(?<![\\w.])\\d+\\.\\d+(?![\\w.])")),
            facts(QStringLiteral("<p class=\"facts\">(.*?)</p>")),
            english_measure(QStringLiteral("\\d\\.\\d|\\brpm\\b"));
        for (std::size_t i = 0; i < pages.size(); ++i) {
            QSet<QString> english;
            for (QString text : captured(html_of(english_[i]), paragraph))
                if (text.remove(inner); captured(text, word).size() > 3) english << text;
            for (QString text : captured(html_of(pages[i]), paragraph)) {
                text.remove(inner);
                if (english.contains(text)
                    && pages[i].file != "glossary") // which has English words in its last column
                    found << in_qt(pages[i].file) + QStringLiteral(": ") + text;
                if (!is_reference(pages[i]) && text.contains(decimal_point))
                    found << in_qt(pages[i].file) + QStringLiteral(", a decimal point: ") + text;
            }
            for (const QString& text : captured(html_of(pages[i]), facts))
                if (text.contains(english_measure))
                    found << in_qt(pages[i].file) + QStringLiteral(", numbers and units: ") + text;
        }
        QVERIFY2(found.isEmpty(), qPrintable(found.join(QChar('\n'))));
    }

    void what_is_bold_is_called_as_in_the_window_data() { each_language(); }
    void what_is_bold_is_called_as_in_the_window() {
        QFETCH(QString, language);
        const auto names = window_names(language.toStdString());
        QVERIFY(names.size() > 1000);
        const std::vector<NamedPage> pages = pages_in(language);
        QStringList wrong;
        int count = 0;
        for (std::size_t i = 0; i < pages.size(); ++i) {
            if (is_reference(pages[i]) || pages[i].file == "glossary") continue;
            // Block by block, so that a name stands where it does in English.
            static const QRegularExpression end(QStringLiteral("</(?:p|li|td|h\\d)>"));
            const QStringList own = html_of(pages[i]).split(end), english = html_of(english_[i]).split(end);
            QCOMPARE(own.size(), english.size());
            for (qsizetype k = 0; k < own.size(); ++k) {
                QStringList here = in_bold(own[k]);
                for (const QString& name : in_bold(english[k])) {
                    ++count;
                    const QStringList known = names_for(names, name);
                    const auto found = std::find_if(
                        here.begin(), here.end(), [&](const QString& said) { return known.contains(said); });
                    if (found != here.end())
                        here.erase(found);
                    else
                        wrong << QStringLiteral("%1: no %2 for %3")
                                     .arg(in_qt(pages[i].file), known.join(QStringLiteral(" or ")), name);
                }
                for (const QString& name : here)
                    wrong << QStringLiteral("%1: bold: %2").arg(in_qt(pages[i].file), name);
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QChar('\n'))));
        QVERIFY(count > 300);
    }

    void words_of_the_reference() {
        const Words words(manual_resources(), "de");
        QCOMPARE(words.of("Rough"), std::string("Schruppen"));
        QCOMPARE(words.of("0 to 2.5 mm"), std::string("0 bis 2.5 mm"));
        QCOMPARE(words.of("number or `auto`"), std::string("Zahl oder `auto`"));
        QCOMPARE(words.of("Rough: parameters"), std::string("Schruppen: Parameter"));
        QCOMPARE(words.measure("0 bis 2.5 rpm"), std::string("0 bis 2,5 U/min"));
        QCOMPARE(Words().measure("2.5 rpm"), std::string("2.5 rpm"));
        QVERIFY(words.missing().empty());
        // A sentence is no range, though it has its word in it.
        QCOMPARE(words.of("from here to there"), std::string("from here to there"));
        QCOMPARE(words.missing().size(), std::size_t(1));
        QCOMPARE(Words().of("Rough"), std::string("Rough"));
    }
};

FACETMILL_TEST(TestManualPages)
#include "test_manual_pages.moc"
