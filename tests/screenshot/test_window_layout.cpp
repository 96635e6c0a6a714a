// Nothing is cut off and nothing is in another language: on no page and in no dialog, in neither palette, in
// a small window and in the usual one, in all languages and in one whose texts are 40 % longer.
#include "core/strategy/plan/operation.h"
#include "tests/screenshot/access_rules.h"
#include "tests/screenshot/cut_texts.h"
#include "tests/screenshot/long_texts.h"
#include "tests/screenshot/shown_texts.h"
#include "tests/screenshot/window_tour.h"
#include "ui/elided_label.h"
#include "ui/language.h"
#include "ui/properties_panel.h"
#include "ui/settings_file.h"
#include "ui/text.h"
#include "ui/viewport.h"
#include "ui/whole_text.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTabBar>
#include <QTest>
#include <QTreeWidget>
#include <QVBoxLayout>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A text that the made-up language does not know, as nobody asked how it is said there.
QString never_asked(const QString& text) {
    static const QRegularExpression word(QStringLiteral("[A-Za-z]{4,}")), made_up(QStringLiteral("[äéîöû]"));
    // Names that users, files and makers gave, and Qt's own words, which it has in other languages.
    static const QRegularExpression name(
        QStringLiteral("/|\\.(stl|nc|json)$|^(T\\d +|\\d )?Ball( \\d)?$|^Finish( \\d)?$|^(surface\\*? – "
                       ")?Facetmill$|^Plan first\\.$"
                       "|^(English|Deutsch|Français|Cancel|Close)$|binary STL"));
    if (!text.contains(word) || text.contains(made_up) || name.match(text).hasMatch()) return {};
    return QStringLiteral("“%1” is said in English everywhere").arg(text.left(120));
}

} // namespace

class TestWindowLayout : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void init() { ui::SettingsFile::own().clear(); }
    void cleanup() { leave_as_found(); }
    void cleanupTestCase() { ui::SettingsFile::own().clear(); }

    void all_can_be_read_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("dark");
        QTest::newRow("long-800x600") << QStringLiteral("long") << QSize(800, 600) << false;
        QTest::newRow("de-800x600-dark") << QStringLiteral("de") << QSize(800, 600) << true;
        QTest::newRow("fr-800x600") << QStringLiteral("fr") << QSize(800, 600) << false;
        QTest::newRow("long-1280x800") << QStringLiteral("long") << QSize(1280, 800) << false;
    }
    void all_can_be_read() {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        QFETCH(bool, dark);
        const bool made_up = language == QLatin1String("long");
        if (made_up)
            ui::speak_by(std::make_unique<LongTexts>(), QLocale::c());
        else
            ui::speak(language);
        const EnglishTexts english(language);
        QCOMPARE(english.known(), !made_up);
        const PaintedTexts painted;
        QVERIFY(show_window());
        w().resize(size);
        w().set_theme(dark ? ui::Theme::dark : ui::Theme::light);
        action(w(), "first_steps")->trigger();
        QTest::qWait(30);
        const QString tag = QString::fromLatin1(QTest::currentDataTag());
        QStringList found;
        QHash<QString, QString> texts; // and where they were seen first
        int pages = 0;
        const auto look = [&](QWidget& top, const QString& page) {
            ++pages;
            for (const QString& line : found_at_rest([&] { return cut_texts(top); }))
                found << page + QStringLiteral(": ") + line;
            for (const QString& line : parted_numbers(top))
                found << page + QStringLiteral(": ") + line;
            for (const QString& line : shared_mnemonics(top))
                found << page + QStringLiteral(": one letter twice: ") + line;
            for (const QString& text : shown_texts(top))
                if (!texts.contains(text)) texts.insert(text, page);
            if (!qEnvironmentVariableIsEmpty("FACETMILL_LAYOUT_PICTURES"))
                shot(top, QStringLiteral("layout-%1-%2-%3")
                              .arg(tag)
                              .arg(pages, 3, 10, QChar('0'))
                              .arg(QString(page).replace(QChar('/'), QChar('-'))));
        };
        look(w(), QStringLiteral("start"));
        action(w(), "first_steps")->trigger();
        QVERIFY(open_and_plan());
        const int form = w().properties().width();
        tour_window(w(), look);
        tour_dialogs(w(), look);
        QVERIFY2(pages > 40, qPrintable(QString::number(pages)));
        // Operations are called in programs what they are called here, which controls show: in English at
        // first.
        for (const OperationKind& kind : operation_kinds())
            texts.remove(ui::text(kind.label.substr(0, kind.label.find_first_of(",("))));
        for (auto it = texts.cbegin(); it != texts.cend(); ++it)
            if (has_silly_figure(it.key())) found << it.value() + QStringLiteral(": ") + it.key();
        for (auto it = texts.cbegin(); it != texts.cend(); ++it)
            if (const QString why = made_up ? never_asked(it.key()) : english.in(it.key()); !why.isEmpty())
                found << it.value() + QStringLiteral(": ") + why;
        QVERIFY(painted.any());
        if (!made_up) found << painted.not_in(english);
        found.removeDuplicates();
        found.sort();
        for (const QString& each : found)
            qWarning().noquote() << each;
        QVERIFY(found.isEmpty());
        // The form keeps its width, and the view is still one.
        QVERIFY2(std::abs(w().properties().width() - form) <= 2,
                 qPrintable(QStringLiteral("%1 %2").arg(form).arg(w().properties().width())));
        QVERIFY(form >= 270);
        QVERIFY(w().viewport().width() >= 200 && w().viewport().height() >= 200);
        if (!made_up) QCOMPARE(w().size(), size);
    }

    void tabs_on_the_right_are_whole_data() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"en", "de", "fr"})
            QTest::newRow(language) << QString::fromLatin1(language);
    }
    void tabs_on_the_right_are_whole() {
        QFETCH(QString, language);
        ui::speak(language);
        QVERIFY(show_window());
        w().resize(1280, 800);
        QTest::qWait(50);
        const QString title = w().findChild<QDockWidget*>(QStringLiteral("cspace_dock"))->windowTitle();
        const QTabBar* found = nullptr;
        for (const QTabBar* bar : w().findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
            for (int i = 0; i < bar->count(); ++i)
                if (bar->tabText(i) == title) found = bar;
        QVERIFY(found && found->isVisible());
        QVERIFY(found->count() >= 3);
        const int end = found->tabRect(found->count() - 1).right();
        QVERIFY2(end <= found->width(), qPrintable(QStringLiteral("%1 %2").arg(end).arg(found->width())));
    }

    /// Choices with long names have room in a wide window, unless the form was given a width by hand.
    void the_form_is_wider_in_a_wide_window() {
        QVERIFY(show_window());
        const auto wide_after = [&](int width) {
            w().resize(width, 800);
            (void)QTest::qWaitFor([&] { return w().width() == width; }, 2000);
            QTest::qWait(50);
            return w().properties().width();
        };
        const int usual = wide_after(1280);
        QVERIFY(usual < 330);
        QVERIFY(wide_after(1920) >= 430);
        QVERIFY(std::abs(wide_after(1280) - usual) <= 2);
        auto* dock = w().findChild<QDockWidget*>(QStringLiteral("properties_dock"));
        w().resizeDocks({dock}, {350}, Qt::Horizontal);
        QTest::qWait(50);
        const int own = w().properties().width();
        QVERIFY(own > usual + 20);
        QVERIFY(std::abs(wide_after(1920) - own) <= 2);
    }

    /// In a small window the status line leaves out its first parts, and no word from within.
    void the_status_line_loses_no_word() {
        QVERIFY(show_window());
        w().resize(800, 600);
        QVERIFY(open_and_plan());
        enter(w(), "name", QStringLiteral("Finish of all that is curved"));
        auto* readout = w().findChild<ui::ElidedLabel*>(QStringLiteral("readout"));
        QVERIFY(readout && readout->isVisible());
        const auto at_contact = [&] { return readout->text().contains(QStringLiteral("CC ")); };
        for (int i = 0; i < 40 && !at_contact(); ++i)
            QTest::keyClick(&w().viewport(), Qt::Key_Right);
        QVERIFY2(at_contact(), qPrintable(readout->text()));
        for (const int width : {800, 1600}) {
            w().resize(width, 600);
            (void)QTest::qWaitFor([&] { return w().width() == width; }, 2000);
            QTest::qWait(30);
            const QString shown = readout->shown_text();
            QVERIFY2(!shown.contains(QChar(0x2026)) && readout->text().endsWith(shown), qPrintable(shown));
            for (const char* part : {"pass 1", "CC ", "CL ", " in"})
                QVERIFY2(shown.contains(QLatin1String(part)), qPrintable(shown));
            if (width > 800) QCOMPARE(shown, readout->text());
        }
        readout->set_text(QStringLiteral("Words that nobody has room for, and more and more of them"),
                          {QStringLiteral("Some that there is none for either, as it is so small"), "Few"});
        readout->setFixedWidth(60);
        QCOMPARE(readout->shown_text(), QStringLiteral("Few"));
    }

    void a_silly_figure_is_found() {
        for (const char* silly : {"0.00000608 % of it", "by 0,000001 mm", "-1.2e-16", "up to 3e-07 in"})
            QVERIFY2(has_silly_figure(QLatin1String(silly)), silly);
        for (const char* good :
             {"< 0.00001 in", "0.0000394 in", "0.02", "1000000 and 10.000005", "T1e-3.stl.txt", ""})
            QVERIFY2(!has_silly_figure(QLatin1String(good)), good);
    }

    /// A cut word is seen: the test itself.
    void a_cut_word_is_found() {
        QWidget top;
        top.setObjectName(QStringLiteral("top"));
        top.resize(200, 220);
        auto* label = new QLabel(QStringLiteral("Words that need more room than they have"), &top);
        label->setGeometry(0, 0, 60, 20);
        auto* button = new QPushButton(QStringLiteral("Quite a long button"), &top);
        button->setGeometry(0, 30, 50, 24);
        auto* edge = new QCheckBox(QStringLiteral("Beyond the edge"), &top);
        edge->setGeometry(150, 60, edge->sizeHint().width(), 24);
        auto* good = new QLabel(QStringLiteral("Short"), &top);
        good->setGeometry(0, 60, 80, 20);
        auto* choice = new QComboBox(&top);
        choice->addItem(QStringLiteral("A choice of many letters"));
        choice->setGeometry(0, 90, 60, 24);
        auto* tree = new QTreeWidget(&top);
        tree->setGeometry(0, 120, 80, 90);
        tree->setHeaderHidden(true);
        new QTreeWidgetItem(tree, {QStringLiteral("A line of quite a few words")});
        auto* told = new QTreeWidgetItem(tree, {QStringLiteral("Another one, with a tool tip")});
        told->setToolTip(0, told->text(0));
        auto* elided = new ui::ElidedLabel(&top);
        elided->set_text(QStringLiteral("One that shortens itself"));
        elided->setGeometry(90, 120, 40, 20);
        top.show();
        QVERIFY(QTest::qWaitForWindowExposed(&top));
        const QStringList found = cut_texts(top);
        QVERIFY2(found.size() == 5, qPrintable(found.join(QChar('\n'))));
        QCOMPARE(ui::shortened_text(*choice), choice->currentText());
        elided->setToolTip(QString());
        QCOMPARE(cut_texts(top).size(), 6);
    }

    /// So are words of a table without room, and two things in one place.
    void a_narrow_table_and_an_overlap_are_found() {
        QWidget window;
        QWidget top(&window);
        auto* column = new QVBoxLayout(&top);
        column->setSizeConstraint(QLayout::SetNoConstraint);
        auto* table = new QLabel(
            QStringLiteral(
                "<table><tr><td style=\"white-space:nowrap\">Considerably longer</td></tr></table>"),
            &top);
        table->setWordWrap(true);
        auto* below = new QWidget(&top);
        for (QWidget* w : {static_cast<QWidget*>(table), below})
            w->setMinimumSize(20, 40);
        column->addWidget(table);
        column->addWidget(below);
        window.resize(300, 200);
        top.resize(240, 140);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY2(cut_texts(window).isEmpty(), qPrintable(cut_texts(window).join(QChar('\n'))));
        top.resize(70, 140);
        QStringList found = cut_texts(window);
        QVERIFY2(found.size() == 1 && found.front().contains(QStringLiteral("Considerably")),
                 qPrintable(found.join(QChar('\n'))));
        top.resize(240, 80);
        found = cut_texts(window);
        QVERIFY2(found.size() == 1 && found.front().contains(QStringLiteral("lies over")),
                 qPrintable(found.join(QChar('\n'))));
    }

    /// A number in a narrow field ends with a mark, unless it is written in, and the pointer is told it
    /// whole.
    void a_number_in_a_narrow_field() {
        QWidget top;
        top.resize(200, 60);
        auto* line = new QLineEdit(QStringLiteral("-1.12454321"), &top);
        line->setGeometry(0, 0, 50, 26);
        auto* other = new QLineEdit(&top);
        other->setGeometry(100, 0, 50, 26);
        top.show();
        QVERIFY(activate(top));
        other->setFocus();
        QTest::qWait(20);
        const QImage shortened = line->grab().toImage();
        line->setText(QStringLiteral("-1.1245987"));
        QTest::qWait(20);
        QCOMPARE(line->grab().toImage(), shortened); // both end alike
        QVERIFY(cut_texts(top).isEmpty());
        QVERIFY(ui::with_whole_text(*line, QStringLiteral("Help")).contains(line->text()));
        line->setFocus();
        line->deselect();
        line->home(false);
        QTest::qWait(20);
        QVERIFY(line->grab().toImage() != shortened);
        line->resize(120, 26);
        QVERIFY(ui::shortened_text(*line).isEmpty());
    }

    /// A text in another language is seen: the test itself.
    void an_english_word_is_found() {
        const EnglishTexts german(QStringLiteral("de"));
        QVERIFY(german.known());
        QVERIFY(!german.in(QStringLiteral("&Preferences…")).isEmpty());
        QVERIFY(!german.in(QStringLiteral("the diameter 3 is not above 0")).isEmpty());
        QVERIFY(!german.in(QStringLiteral("0.5 mm")).isEmpty());
        for (const char* good : {"0,5 mm", "Werkzeug", "part2.5.stl", "G54.1 P1", "Ball 6"})
            QVERIFY2(german.in(QString::fromUtf8(good)).isEmpty(), good);
    }
};

FACETMILL_TEST(TestWindowLayout)
#include "test_window_layout.moc"
