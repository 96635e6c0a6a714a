// Pictures of every page, in both palettes, three sizes and three languages, on sheets to be looked at:
// packaging/page-pictures.
#include "tests/screenshot/cut_texts.h"
#include "tests/screenshot/page_sheets.h"
#include "tests/screenshot/window_states.h"
#include "tests/screenshot/window_tour.h"
#include "ui/language.h"
#include "ui/settings_file.h"
#include "ui/verification_controller.h"

#include <QDockWidget>
#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

class TestWindowPictures : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void init() { ui::SettingsFile::own().clear(); }
    void cleanup() { leave_as_found(); }
    void cleanupTestCase() { ui::SettingsFile::own().clear(); }

    void every_page_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("dark");
        for (const char* language : {"en", "de", "fr"})
            for (const QSize size : {QSize(800, 600), QSize(1280, 800), QSize(3840, 2160)})
                for (const bool dark : {false, true})
                    QTest::addRow("%s-%d-%s", language, size.width(), dark ? "dark" : "light")
                        << QString::fromLatin1(language) << size << dark;
    }
    void every_page() {
        const QString folder = qEnvironmentVariable("FACETMILL_PAGE_PICTURES");
        if (folder.isEmpty()) QSKIP("made by packaging/page-pictures");
        QFETCH(QString, language);
        QFETCH(QSize, size);
        QFETCH(bool, dark);
        ui::speak(language);
        const double shrink = size.width() > 3000 ? 2.4 : 1;
        const QString tag = QString::fromLatin1(QTest::currentDataTag());
        PageSheets pages(folder, tag, shrink), forms(folder, tag + QStringLiteral("-forms"), shrink);
        const auto begin = [&] {
            close_window();
            QVERIFY(show_window());
            w().set_theme(dark ? ui::Theme::dark : ui::Theme::light);
            w().resize(size / w().devicePixelRatioF());
        };
        // Beside the pictures, what can be told by rule: states are too many to be toured by every test.
        QStringList cut;
        const auto check = [&](QWidget& top, const QString& page) {
            for (const QString& line : found_at_rest([&] { return cut_texts(top); }))
                cut << page + QStringLiteral(": ") + line;
        };
        begin();
        tour_states(w(), [&](QWidget& top, const QString& page) {
            check(top, page);
            pages.add(top, page);
        });
        begin();
        QVERIFY(open_and_plan());
        w().verify();
        QVERIFY(wait_until_settled(w()));
        const auto look = [&](QWidget& top, const QString& page) {
            // Only the form differs.
            auto* form = top.findChild<QDockWidget*>(QStringLiteral("properties_dock"));
            const bool of_form =
                page.startsWith(QLatin1String("node ")) || page.startsWith(QLatin1String("operation "))
                || page.startsWith(QLatin1String("fixture ")) || page.startsWith(QLatin1String("boundary "));
            if (of_form && form)
                forms.add(*form, page);
            else
                pages.add(top, page);
        };
        tour_window(w(), look);
        tour_dialogs(w(), [&](QWidget& top, const QString& page) { forms.add(top, page); });
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(QChar('\n'))));
    }
};

FACETMILL_TEST(TestWindowPictures)
#include "test_window_pictures.moc"
