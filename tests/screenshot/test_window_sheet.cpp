// The setup sheet as the workbench writes it where another language is spoken: its words are translated, its
// numbers are the user's, and nothing is left in English.
#include "tests/screenshot/shown_texts.h"
#include "tests/screenshot/window_support.h"
#include "ui/document.h"
#include "ui/language.h"
#include "ui/program_export.h"
#include "ui/project_tree.h"

#include <QAction>
#include <QFile>
#include <QMenu>
#include <QPainter>
#include <QRegularExpression>
#include <QTest>
#include <QTextDocument>

using namespace facetmill;
using namespace facetmill::test;

class TestWindowSheet : public QObject, private WindowFixture {
    Q_OBJECT

    /// A posted 3-axis job with a fixture, an inclined axis and a zero of its own, verified.
    bool judge() {
        if (!open_and_plan()) return false;
        w().document().change(QStringLiteral("Posted"), [](Project& p) {
            p.programs.post = "linuxcnc";
            p.programs.zero_from = ProgramSpec::ZeroFrom::stock;
            Tool more = p.tools.front();
            more.number = 2;
            more.name = "Second";
            more.holder = {{40, 30}};
            p.tools.push_back(more);
        });
        w().verify();
        return wait_until_settled(w()) && w().last_failure().isEmpty();
    }
    QString sheet_in(const QString& language) {
        ui::speak(language);
        const QString file =
            scratch_folder(QStringLiteral("sheet-") + language) + QStringLiteral("/part.html");
        w().exports().save_sheet(file);
        if (!wait_until_settled(w())) return {};
        QFile sheet(file);
        return sheet.open(QIODevice::ReadOnly) ? QString::fromUtf8(sheet.readAll()) : QString();
    }
    /// What stands in its cells and paragraphs.
    static QStringList texts_of(QString html) {
        html.remove(QRegularExpression(QStringLiteral("<style>.*</style>"),
                                       QRegularExpression::DotMatchesEverythingOption));
        QStringList texts;
        for (const QString& piece : html.split(QRegularExpression(QStringLiteral("<[^>]*>|\n"))))
            if (QTextDocument text; !piece.trimmed().isEmpty()) {
                text.setHtml(piece);
                texts << text.toPlainText();
            }
        return texts;
    }
    static void picture(const QString& html, const QString& name) {
        QTextDocument page;
        page.setHtml(html);
        page.setTextWidth(1000);
        QImage image(page.size().toSize(), QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        page.drawContents(&painter);
        painter.end();
        image.save(QStringLiteral(FACETMILL_PICTURE_OUT "/%1.png").arg(name));
    }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { leave_as_found(); }

    void nothing_is_left_in_english() {
        QVERIFY(judge());
        const QStringList english = texts_of(sheet_in(QStringLiteral("en")));
        QVERIFY2(english.size() > 60, qPrintable(english.join(QChar('\n'))));
        static const QRegularExpression word(QStringLiteral("[A-Za-z]{4,}"));
        // Names of the user's, of files and of controls, and what is the same.
        static const QRegularExpression name(QStringLiteral(
            "^(Name|Passes|surface.*|Ball 1|Second|Finish|.*\\.(ngc|apt|stl)|LinuxCNC.*|APT|Origin|Position|"
            "Tolerance|Machine|Operation|Program|Rotation|Verification|Collisions|Place)$"));
        for (const char* language : {"de", "fr"}) {
            const QString code = QLatin1String(language), html = sheet_in(code);
            picture(html, QStringLiteral("sheet-") + code);
            QVERIFY(html.contains(QStringLiteral("<html lang=\"%1\"").arg(code)));
            const QStringList texts = texts_of(html);
            QCOMPARE(texts.size(), english.size());
            const EnglishTexts catalogue(code);
            QStringList left;
            for (qsizetype i = 0; i < texts.size(); ++i) {
                if (texts[i] == english[i] && texts[i].contains(word) && !name.match(texts[i]).hasMatch())
                    left << texts[i];
                if (const QString why = catalogue.in(texts[i]);
                    !why.isEmpty() && !name.match(texts[i]).hasMatch())
                    left << why;
            }
            QVERIFY2(left.isEmpty(), qPrintable(code + QStringLiteral(": ") + left.join(QChar('\n'))));
        }
        const QStringList german = texts_of(sheet_in(QStringLiteral("de")));
        QVERIFY(german.contains(QStringLiteral("Rohteil"))
                || german.contains(QStringLiteral("Teil, Rohteil und Maschine")));
        QVERIFY(german.filter(QRegularExpression(QStringLiteral("\\d,\\d"))).size() > 15);
    }
};

FACETMILL_TEST(TestWindowSheet)
#include "test_window_sheet.moc"
