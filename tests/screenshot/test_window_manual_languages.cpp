// The manual in the language of the window: F1 lands at the same place, contents and search speak it, and its
// pages fit. That pages say the same in all languages is asked by tests/arch/test_manual_pages.cpp.
#include "tests/screenshot/window_support.h"
#include "ui/document.h"
#include "ui/help.h"
#include "ui/help_browser.h"
#include "ui/help_pages.h"
#include "ui/help_window.h"
#include "ui/language.h"
#include "ui/project_tree.h"
#include "ui/settings_file.h"
#include "ui/theme.h"

#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QListWidget>
#include <QTest>
#include <QTreeWidget>

using namespace facetmill;
using namespace facetmill::test;
using ui::TreeNode;

class TestWindowManualLanguages : public QObject, private WindowFixture {
    Q_OBJECT

    ui::Help& help() { return *w().findChild<ui::Help*>(); }
    static void languages() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("first_job");
        QTest::addColumn<QString>("rough");
        QTest::addColumn<QString>("tolerance");
        QTest::newRow("de") << QStringLiteral("de")
                            << QStringLiteral("Der erste Auftrag, Schritt für Schritt")
                            << QStringLiteral("Schruppen") << QStringLiteral("Toleranz");
        QTest::newRow("fr") << QStringLiteral("fr") << QStringLiteral("Premier travail, pas à pas")
                            << QStringLiteral("Ébauche") << QStringLiteral("Tolérance");
    }

private slots:
    void init() { ui::SettingsFile::own().clear(); }
    void cleanup() {
        close_window();
        ui::speak(QStringLiteral("en"));
        ui::apply_theme(*qApp, ui::Theme::light);
    }

    void f1_lands_at_the_same_place_data() { languages(); }
    void f1_lands_at_the_same_place() {
        QFETCH(QString, language);
        QFETCH(QString, first_job);
        QFETCH(QString, rough);
        QFETCH(QString, tolerance);
        ui::speak(QStringLiteral("en"));
        QStringList english;
        for (const ui::HelpSection& s : ui::help_sections())
            english << s.topic;
        ui::speak(language);
        QStringList own;
        for (const ui::HelpSection& s : ui::help_sections())
            own << s.topic;
        QVERIFY(own.size() > 500);
        QCOMPARE(own, english);

        QVERIFY(show_window());
        QVERIFY(open_part());
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(activate(w()));
        field(w(), "tolerance")->setFocus();
        QTest::keyClick(field(w(), "tolerance"), Qt::Key_F1);
        QVERIFY(help().window());
        ui::HelpWindow& window = *help().window();
        QCOMPARE(window.browser()->topic(), QStringLiteral("reference_finish3.html#finish3-tolerance"));
        QVERIFY(window.browser()->toPlainText().contains(tolerance + QStringLiteral(" tolerance\n")));
        QCOMPARE(window.contents()->topLevelItem(0)->text(0), first_job);

        // A link of the page stays in the language.
        help().open(QStringLiteral("first_job.html"));
        QVERIFY(window.browser()->toPlainText().startsWith(first_job));
        emit window.browser()->anchorClicked(QUrl(QStringLiteral("planning.html#messages")));
        QCOMPARE(window.browser()->topic(), QStringLiteral("planning.html#messages"));
        QVERIFY(!window.browser()->toPlainText().contains(QStringLiteral("what to do")));

        QTest::keyClicks(window.search_field(), rough);
        QVERIFY(window.results()->count() > 3);
        QVERIFY(window.results()->item(0)->text().contains(rough, Qt::CaseInsensitive));
        // Pictures stand beside the pages of all languages.
        help().open(QStringLiteral("tools.html"));
        const QVariant drawing = window.browser()->document()->resource(
            QTextDocument::ImageResource, QUrl(QStringLiteral("../drawings/tool_measures.svg")));
        QVERIFY(!drawing.value<QImage>().isNull());
        QVERIFY(drawing.value<QImage>().width() > 100);
    }

    void every_page_fits_a_small_window_data() {
        languages();
        QTest::newRow("en") << QStringLiteral("en") << QString() << QString() << QString();
    }
    void every_page_fits_a_small_window() {
        QFETCH(QString, language);
        ui::speak(language);
        QVERIFY(show_window());
        help().open({});
        ui::HelpWindow& window = *help().window();
        window.resize(800, 600);
        QTest::qWait(300); // the page is made anew for its width
        for (const ui::Theme theme : {ui::Theme::light, ui::Theme::dark}) {
            w().set_theme(theme);
            QApplication::processEvents();
            for (const ui::HelpSection& s : ui::help_sections()) {
                if (s.level != 1) continue;
                window.show_topic(s.topic);
                QTest::qWait(5);
                // Only tables of machines are wider than a page that one can read.
                if (!s.topic.startsWith(QLatin1String("reference.")))
                    QVERIFY2(window.browser()->document()->size().width()
                                 <= window.browser()->viewport()->width() + 1,
                             qPrintable(s.topic));
                shot(window,
                     QStringLiteral("help-%1-%2-%3")
                         .arg(language, theme == ui::Theme::dark ? "dark" : "light", s.topic.chopped(5)));
            }
        }
    }
};

FACETMILL_TEST(TestWindowManualLanguages)
#include "test_window_manual_languages.moc"
