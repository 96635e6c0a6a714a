// Access by keys and by assistive technology: every control says what it is, Tab goes on as one reads, and
// words can be read in both palettes.
#include "tests/screenshot/access_rules.h"
#include "tests/screenshot/cut_texts.h"
#include "tests/screenshot/shown_texts.h"
#include "tests/screenshot/window_states.h"
#include "tests/screenshot/window_support.h"
#include "tests/screenshot/window_tour.h"
#include "ui/language.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/theme.h"

#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>

using namespace facetmill;
using namespace facetmill::test;
using ui::TreeNode;

class TestWindowAccess : public QObject, private WindowFixture {
    Q_OBJECT

    static void palettes() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    static QStringList broken_rules(QWidget& top, const QString& page) {
        QStringList found;
        const std::pair<const char*, QStringList (*)(QWidget&)> rules[] = {
            {"no name or role", nameless},
            {"out of order", out_of_order},
            {"not reached by Tab", out_of_reach},
            {"one letter twice", shared_mnemonics},
            {"faint", faint_words},
            {"no help", without_help}};
        for (const auto& [name, rule] : rules)
            for (const QString& line : rule(top))
                found << page + QStringLiteral(": ") + QLatin1String(name) + QStringLiteral(": ") + line;
        return found;
    }
    /// What was found, each once, by rule and widget alone.
    static QString told(QStringList found) {
        QSet<QString> seen;
        QStringList lines;
        for (const QString& line : found)
            if (const QString what = line.section(QStringLiteral(": "), 1); !seen.contains(what)) {
                seen << what;
                lines << line;
                qWarning().noquote() << line;
            }
        return lines.join(QChar('\n'));
    }

private slots:
    void init() { QVERIFY(show_window()); }
    void cleanup() { close_window(); }

    void every_page_data() { palettes(); }
    /// In the forms of all nodes, in the panels, in dialogs: controls have names and roles, Tab reaches all
    /// of them, down from row to row, no letter stands twice, words can be read, and F1 knows where to go.
    void every_page() {
        QFETCH(bool, dark);
        w().set_theme(dark ? ui::Theme::dark : ui::Theme::light);
        QVERIFY(open_and_plan());
        QStringList found;
        const auto look = [&](QWidget& top, const QString& page) { found << broken_rules(top, page); };
        tour_window(w(), look);
        const QSet<QString> seen = tour_dialogs(w(), look);
        w().set_theme(ui::Theme::system);
        QVERIFY2(told(found).isEmpty(), qPrintable(told(found)));
        const QSet<QString> missing = dialog_classes() - seen;
        QVERIFY2(missing.isEmpty(), qPrintable(QStringList(missing.values()).join(QChar(' '))));
        QVERIFY(dialog_classes().size() > 6);
    }

    /// The same where things are empty, wrong, failed, missing or long; in the language with the longest
    /// words.
    void every_state() {
        ui::speak(QStringLiteral("fr"));
        close_window();
        QVERIFY(show_window());
        w().set_theme(ui::Theme::dark);
        w().resize(800, 600);
        const EnglishTexts english(QStringLiteral("fr"));
        auto painted = std::make_unique<PaintedTexts>();
        QStringList found;
        int pages = 0;
        tour_states(w(), [&](QWidget& top, const QString& page) {
            ++pages;
            found << broken_rules(top, page);
            for (const QString& line : found_at_rest([&] { return cut_texts(top); }))
                found << page + QStringLiteral(": cut: ") + line;
            for (const QString& text : shown_texts(top))
                if (const QString why = english.in(text); !why.isEmpty())
                    found << page + QStringLiteral(": English: ") + why;
        });
        found << painted->not_in(english);
        painted.reset();
        w().set_theme(ui::Theme::system);
        ui::speak(QStringLiteral("en"));
        QVERIFY2(told(found).isEmpty(), qPrintable(told(found)));
        QVERIFY2(pages > 20, qPrintable(QString::number(pages)));
    }

    void menus_have_letters() {
        for (const QAction* menu : w().menuBar()->actions())
            QVERIFY2(menu->text().contains(QChar('&')), qPrintable(menu->text()));
        // In one menu no letter twice.
        for (const QAction* top : w().menuBar()->actions()) {
            QStringList letters;
            for (const QAction* entry : top->menu()->actions()) {
                const qsizetype at = entry->text().indexOf(QChar('&'));
                if (at < 0 || !entry->isVisible()) continue;
                const QString letter = entry->text().mid(at + 1, 1).toLower();
                QVERIFY2(!letters.contains(letter), qPrintable(top->text() + QChar(' ') + entry->text()));
                letters << letter;
            }
        }
    }

    void tab_goes_on_as_one_reads() {
        QVERIFY(open_and_plan());
        w().tree().select({TreeNode::Kind::operation, 0});
        QTest::qWait(20);
        QWidget& panel = w().properties();
        std::vector<QWidget*> fields;
        QWidget* first = nullptr;
        for (QWidget* c : controls_of(w()))
            if (panel.isAncestorOf(c) && !qobject_cast<QScrollArea*>(c) && !first) first = c;
        QVERIFY(first);
        for (QWidget* f = first; f && panel.isAncestorOf(f); f = f->nextInFocusChain())
            if (f->isVisible() && (f->focusPolicy() & Qt::TabFocus)) fields.push_back(f);
        QVERIFY(fields.size() > 8);
        // Down from row to row, to the right within one.
        QPoint last(-1, -1);
        for (const QWidget* f : fields) {
            const QRect at(f->mapTo(&panel, QPoint(0, 0)), f->size());
            const bool below = at.top() > last.y();
            QVERIFY2(below || at.left() > last.x(), qPrintable(described(*f)));
            last = QPoint(at.left(), below ? at.center().y() : last.y());
        }
    }

    void words_can_be_read_data() { palettes(); }
    /// WCAG AA: 4.5 to 1.
    void words_can_be_read() {
        QFETCH(bool, dark);
        const QPalette p = dark ? ui::dark_palette() : ui::light_palette();
        const std::pair<QPalette::ColorRole, QPalette::ColorRole> pairs[] = {
            {QPalette::WindowText, QPalette::Window},
            {QPalette::Text, QPalette::Base},
            {QPalette::Text, QPalette::AlternateBase},
            {QPalette::ButtonText, QPalette::Button},
            {QPalette::HighlightedText, QPalette::Highlight},
            {QPalette::PlaceholderText, QPalette::Base},
            {QPalette::PlaceholderText, QPalette::Window},
            {QPalette::ToolTipText, QPalette::ToolTipBase},
            {QPalette::Link, QPalette::Base},
            {QPalette::Link, QPalette::Window}};
        for (const auto& [word, ground] : pairs) {
            const double ratio = contrast(p.color(word), p.color(ground));
            QVERIFY2(
                ratio >= 4.5,
                qPrintable(QStringLiteral("role %1 on %2: %3").arg(int(word)).arg(int(ground)).arg(ratio)));
        }
        const ui::SignalColors s = ui::signal_colors(p);
        const std::pair<const char*, QColor> signals_[] = {{"good", s.good},
                                                           {"attention", s.attention},
                                                           {"bad", s.bad},
                                                           {"busy", s.busy},
                                                           {"quiet", s.quiet}};
        for (const auto& [name, color] : signals_)
            for (const auto ground : {QPalette::Window, QPalette::Base}) {
                const double ratio = contrast(color, p.color(ground));
                QVERIFY2(ratio >= 4.5,
                         qPrintable(QStringLiteral("%1: %2").arg(QLatin1String(name)).arg(ratio)));
            }
    }
};

FACETMILL_TEST(TestWindowAccess)
#include "test_window_access.moc"
