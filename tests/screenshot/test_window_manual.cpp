// The manual: its names are those of the window, F1 opens it at the right place, and its first job can be
// done as it is told. With FACETMILL_MANUAL_PICTURES=FOLDER the pictures of the manual are written there,
// those of FACETMILL_MANUAL_LANGUAGE (packaging/manual-pictures).
#include "core/job/verify_limits.h"
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/few_colours.h"
#include "tests/screenshot/window_support.h"
#include "tests/support/part_meshes.h"
#include "ui/boundary_box.h"
#include "ui/controllers.h"
#include "ui/cspace_controller.h"
#include "ui/cspace_panel.h"
#include "ui/help.h"
#include "ui/help_browser.h"
#include "ui/help_pages.h"
#include "ui/help_window.h"
#include "ui/language.h"
#include "ui/parameter_form.h"
#include "ui/part_dialog.h"
#include "ui/project_tree.h"
#include "ui/properties_panel.h"
#include "ui/region_controller.h"
#include "ui/region_dialog.h"
#include "ui/scan_controller.h"
#include "ui/settings.h"
#include "ui/settings_file.h"
#include "ui/study_controller.h"
#include "ui/text.h"
#include "ui/theme.h"
#include "ui/tool_dialog.h"
#include "ui/value_words.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QRadioButton>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>
#include <QXmlStreamReader>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;
using ui::TreeNode;

namespace {

/// As a menu or a button has it, without marks for keys.
QString plain(QString name) {
    name = name.section(QChar('\t'), 0, 0).remove(QChar('&')).remove(QChar(0x2026)).trimmed();
    return name.endsWith(QChar(':')) ? name.chopped(1) : name;
}

/// A relief of gentle hills, 80 x 60 x 9 mm, as a scan might be.
Mesh relief() {
    return height_field(
        [](double x, double y) {
            return 5 + 2.5 * std::sin(x / 9) * std::cos(y / 11) + 1.5 * std::cos((x + y) / 17);
        },
        Vec2(0, 0), Vec2(80, 60), 80, 60);
}

/// A dome of 40 mm as a scanner might have seen it: rough, with two holes, and something that is none of it.
Mesh scanned_dome() {
    Mesh mesh = only(dome(20, 60), [](const Vec3& p) {
        return (p - Vec3(-8, -12, 14)).norm() > 3.2 && (p - Vec3(9, -14, 11)).norm() > 1.8;
    });
    for (Vec3& v : mesh.vertices)
        if (v.z() > 0.5) v *= 1 + 0.004 * std::sin(90 * v.x()) * std::cos(70 * v.y() + 40 * v.z());
    append_mesh(mesh, box(Vec3(14, -20, 4), Vec3(15.5, -19, 5)));
    append_mesh(mesh, box(Vec3(-17, -17, 9), Vec3(-16, -16, 10.2)));
    return mesh;
}

/// Where pictures go, or an empty text.
QString picture_folder() {
    return qEnvironmentVariable("FACETMILL_MANUAL_PICTURES");
}

/// Which language the pictures speak; empty: English.
QString picture_language() {
    return qEnvironmentVariable("FACETMILL_MANUAL_LANGUAGE");
}

/// What the window calls what it calls so in English: every word for it that the language of the pictures
/// has.
QStringList said_names(const QString& english) {
    QStringList names;
    if (picture_language().isEmpty()) return {english};
    QFile file(QStringLiteral(FACETMILL_TEST_DATA "/../resources/languages/facetmill_%1.ts")
                   .arg(picture_language()));
    if (!file.open(QIODevice::ReadOnly)) return names;
    QXmlStreamReader xml(&file);
    for (QString source; !xml.atEnd();) {
        if (!xml.readNextStartElement()) continue;
        if (xml.name() == QLatin1String("source"))
            source = plain(xml.readElementText());
        else if (xml.name() == QLatin1String("translation") && source == english)
            names << plain(xml.readElementText(QXmlStreamReader::IncludeChildElements));
    }
    return names;
}

} // namespace

class TestWindowManual : public QObject, private WindowFixture {
    Q_OBJECT

    ui::Help& help() { return *w().findChild<ui::Help*>(); }
    QString topic() { return help().window() ? help().window()->browser()->topic() : QString(); }
    void press_f1(QWidget* at) {
        QTest::keyClick(at, Qt::Key_F1);
        QApplication::processEvents();
    }
    void picture(QWidget& widget, const QString& name) {
        // Out of its window: by itself what OpenGL drew would be mixed with what is behind it.
        QWidget& window = *widget.window();
        const QImage image = shot(window, QStringLiteral("manual-") + name)
                                 .copy(QRect(widget.mapTo(&window, QPoint()), widget.size()));
        if (picture_folder().isEmpty()) return;
        QDir().mkpath(picture_folder());
        // As wide as a page: what is wider would be made smaller there.
        constexpr int page_width = 900;
        const QImage small =
            image.width() > page_width ? image.scaledToWidth(page_width, Qt::SmoothTransformation) : image;
        QVERIFY(in_few_colours(small).save(picture_folder() + QStringLiteral("/%1.png").arg(name), "PNG", 0));
    }
    void click(const char* button, QWidget* in = nullptr) {
        auto* b = (in ? in : &w())->findChild<QAbstractButton*>(QLatin1String(button));
        QVERIFY2(b && b->isEnabled(), button);
        b->click();
        QVERIFY(wait_until_settled(w()));
    }
    template <class Dialog>
    Dialog* dialog() {
        Dialog* found = nullptr;
        (void)QTest::qWaitFor([&] { return (found = w().findChild<Dialog*>()) && found->isVisible(); },
                              patience_ms);
        return found;
    }
    /// Chooses an entry of a menu by what it says.
    void choose(const QString& label) {
        const QStringList said = said_names(label);
        for (QAction* a : w().findChildren<QAction*>())
            if (said.contains(plain(a->text())) && a->isEnabled()) return a->trigger();
        QFAIL(qPrintable(label));
    }

    /// Every name that the window and its dialogs show.
    QSet<QString> names() {
        QSet<QString> all;
        const auto take = [&](QWidget* in) {
            for (const auto* a : in->findChildren<QAction*>())
                all << plain(a->text());
            for (const auto* d : in->findChildren<QDockWidget*>())
                all << plain(d->windowTitle());
            for (const auto* b : in->findChildren<QAbstractButton*>())
                all << plain(b->text());
            for (const auto* l : in->findChildren<QLabel*>())
                all << plain(l->text());
            for (const auto* c : in->findChildren<QComboBox*>())
                for (int i = 0; i < c->count(); ++i)
                    all << plain(c->itemText(i));
            for (const auto* t : in->findChildren<QTabWidget*>())
                for (int i = 0; i < t->count(); ++i)
                    all << plain(t->tabText(i));
            for (auto* t : in->findChildren<QTreeWidget*>())
                for (QTreeWidgetItemIterator i(t); *i; ++i)
                    all << plain((*i)->text(0));
        };
        w().properties().boundary_box()->show_kind(Boundary::Kind::facets, LengthUnit::mm);
        choose(QStringLiteral("Scan room")); // what the file holds is listed once it is seen
        (void)wait_until_settled(w());
        take(&w());
        for (const TreeNode::Kind kind : {TreeNode::Kind::part, TreeNode::Kind::stock, TreeNode::Kind::limits,
                                          TreeNode::Kind::machine, TreeNode::Kind::tool}) {
            w().tree().select({kind, 0});
            take(w().properties().form());
        }
        for (const char* command : {"Tool library", "Preferences", "Edit tool"}) {
            choose(QLatin1String(command));
            QWidget* shown = QApplication::activeModalWidget() ? QApplication::activeModalWidget()
                                                               : QApplication::activeWindow();
            take(shown);
            if (shown != &w()) shown->close();
            QApplication::processEvents();
        }
        w().controllers().study().open();
        take(w().controllers().study().dialog());
        w().controllers().study().dialog()->close();
        const auto add = [&](const std::vector<const ParameterInfo*>& parameters) {
            for (const ParameterInfo* p : parameters)
                all << ui::text(p->label);
        };
        add(fixture_parameters().infos());
        add(boundary_parameters().infos());
        add(tool_parameters().infos());
        for (const OperationKind& kind : operation_kinds()) {
            all << ui::text(kind.label);
            add(kind.make()->parameters());
        }
        for (const char* asked : {"Export", "Millimetres"}) // in dialogs that the first job opens
            all << QLatin1String(asked);
        return all;
    }

private slots:
    void init() {
        ui::SettingsFile::own().clear();
        if (!picture_language().isEmpty()) ui::speak(picture_language());
        QVERIFY(show_window());
    }
    void cleanup() {
        close_window();
        ui::apply_theme(*qApp, ui::Theme::light);
    }

    void names_in_bold_are_those_of_the_window() {
        QVERIFY(open_part());
        const QSet<QString> known = names();
        static const QRegularExpression bold(QStringLiteral("<b>(.*?)</b>"));
        QStringList wrong;
        int count = 0;
        for (const ui::HelpSection& s : ui::help_sections()) {
            if (s.level != 1 || s.topic.startsWith(QLatin1String("reference"))
                || s.topic == QLatin1String("glossary.html"))
                continue;
            const QString html = QString::fromUtf8(ui::help_file(s.topic));
            for (auto it = bold.globalMatch(html); it.hasNext();)
                for (QString name : it.next().captured(1).split(QStringLiteral(" ▸ "))) {
                    name.replace(QStringLiteral("&quot;"), QStringLiteral("\""));
                    ++count;
                    if (!known.contains(plain(name))) wrong << s.topic + QStringLiteral(": ") + name;
                }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QChar('\n'))));
        QVERIFY(count > 100);
        QVERIFY(!known.contains(QStringLiteral("Machine the part"))); // it can fail
    }

    void every_link_and_picture_is_there() {
        static const QRegularExpression link(QStringLiteral("<a href=\"([^\"]*)\"|<img src=\"([^\"]*)\"")),
            name(QStringLiteral("<a name=\"([^\"]*)\""));
        QSet<QString> pages, targets{QStringLiteral("index.html")};
        for (const ui::HelpSection& s : ui::help_sections())
            pages << s.page();
        QVERIFY(pages.size() > 20);
        for (const QString& page : pages) {
            targets << page;
            const QString html = QString::fromUtf8(ui::help_file(page));
            QVERIFY2(!html.isEmpty(), qPrintable(page));
            for (auto it = name.globalMatch(html); it.hasNext();)
                targets << page + QChar('#') + it.next().captured(1);
        }
        int links = 0, pictures = 0;
        for (const QString& page : pages)
            for (auto it = link.globalMatch(QString::fromUtf8(ui::help_file(page))); it.hasNext();) {
                const auto match = it.next();
                const QString to = match.captured(1), file = match.captured(2);
                if (!file.isEmpty()) {
                    ++pictures;
                    QVERIFY2(!ui::help_file(file).isEmpty(), qPrintable(page + QChar(' ') + file));
                } else if (!to.contains(QStringLiteral("://"))) {
                    ++links;
                    QVERIFY2(targets.contains(to.startsWith(QChar('#')) ? page + to : to),
                             qPrintable(page + QChar(' ') + to));
                }
            }
        QVERIFY(links > 60 && pictures > 60);
        for (const ui::HelpSection& s : ui::help_sections())
            QVERIFY2(ui::has_help(s.topic) && targets.contains(s.topic), qPrintable(s.topic));
    }

    void every_parameter_has_an_entry() {
        const auto has = [](const std::string& page, const std::string& scope,
                            const std::vector<const ParameterInfo*>& parameters) {
            for (const ParameterInfo* p : parameters) {
                const QString at = ui::text(page + ".html#" + scope + "-" + p->key);
                QVERIFY2(ui::has_help(at) || page == "reference", qPrintable(at));
                for (const ParameterInfo* of : p->record)
                    QVERIFY2(ui::has_help(at + QChar('-') + ui::text(of->key)), qPrintable(at));
            }
        };
        for (const OperationKind& kind : operation_kinds())
            has("reference_" + kind.kind, kind.kind, kind.make()->parameters());
        has("reference", "part", part_parameters().infos());
        has("reference", "stock", stock_parameters().infos());
        has("reference", "fixtures", fixture_parameters().infos());
        has("reference", "boundaries", boundary_parameters().infos());
        has("reference", "tools", tool_parameters().infos());
        has("reference", "verification", verify_limit_parameters().infos());
    }

    void drawings_are_there_and_follow_the_palette() {
        int drawn = 0;
        QSet<QString> seen;
        const auto look = [&](const QString& scope, const std::vector<const ParameterInfo*>& parameters) {
            for (const ParameterInfo* p : parameters) {
                const QString name = ui::parameter_drawing(scope, ui::text(p->key));
                if (name.isEmpty()) continue;
                ++drawn;
                seen << name;
                const QImage light = ui::help_drawing(name, ui::light_palette(), 200, 1),
                             dark = ui::help_drawing(name, ui::dark_palette(), 200, 1);
                QVERIFY2(!light.isNull() && light != dark, qPrintable(name));
                QVERIFY(ui::help_html(*p, LengthUnit::mm, scope).contains(QStringLiteral("<img")));
            }
        };
        for (const OperationKind& kind : operation_kinds())
            look(ui::text(kind.kind), kind.make()->parameters());
        look(QStringLiteral("tools"), tool_parameters().infos());
        look(QStringLiteral("fixtures"), fixture_parameters().infos());
        QVERIFY2(drawn > 60 && seen.size() > 20, qPrintable(QString::number(seen.size())));
        QVERIFY(ui::parameter_drawing(QStringLiteral("lathe_finish"), QStringLiteral("pattern")).isEmpty());
    }

    void f1_opens_the_place_of_what_has_the_keys() {
        press_f1(&w());
        QCOMPARE(topic(), QStringLiteral("first_job.html")); // the page of an empty window
        QVERIFY(open_part());
        w().tree().select({TreeNode::Kind::operation, 0});
        const std::pair<const char*, const char*> fields[] = {
            {"tolerance", "reference_finish3.html#finish3-tolerance"},
            {"stepover", "reference_finish3.html#finish3-stepover"},
            {"feed", "reference_finish3.html#finish3-feed"}};
        for (const auto& [key, to] : fields) {
            QVERIFY(activate(w()));
            field(w(), key)->setFocus();
            press_f1(field(w(), key));
            QCOMPARE(topic(), QLatin1String(to));
        }
        w().tree().select({TreeNode::Kind::stock, 0});
        QCOMPARE(ui::help_topic(field(w(), "margin0")), QStringLiteral("reference.html#stock-margin"));
        QCOMPARE(ui::help_topic(field(w(), "size0")), QStringLiteral("setup.html#stock"));
        w().tree().select({TreeNode::Kind::machine, 0});
        QCOMPARE(ui::help_topic(w().properties().form()->findChild<QComboBox*>(QStringLiteral("post"))),
                 QStringLiteral("reference.html#project_file-post"));
        w().tree().select({TreeNode::Kind::part, 0});
        QCOMPARE(ui::help_topic(field(w(), "scale")), QStringLiteral("reference.html#part-scale"));
        for (const auto* dock : w().findChildren<QDockWidget*>()) {
            const QString to = ui::help_topic(dock->widget());
            QVERIFY2(ui::has_help(to), qPrintable(dock->objectName() + QChar(' ') + to));
        }
        QCOMPARE(ui::help_topic(w().cspace().panel()), QStringLiteral("configuration_space.html"));
    }

    void f1_works_in_dialogs() {
        QVERIFY(open_part());
        w().tree().select({TreeNode::Kind::tool, 0});
        choose(QStringLiteral("Edit tool"));
        auto* tool = dialog<ui::ToolDialog>();
        QVERIFY(tool && activate(*tool));
        auto* diameter = tool->findChild<QLineEdit*>(QStringLiteral("diameter"));
        diameter->setFocus();
        press_f1(diameter);
        QCOMPARE(topic(), QStringLiteral("reference.html#tools-diameter"));
        QVERIFY(help().window()->isVisible());
        // It can be read while the dialog is open.
        QTest::keyClicks(help().window()->search_field(), QStringLiteral("shank"));
        QVERIFY(help().window()->results()->count() > 3);
        press_f1(tool->findChild<QComboBox*>(QStringLiteral("shape")));
        QCOMPARE(topic(), QStringLiteral("tools.html#dialog"));
        tool->reject();
        action(w(), "preferences")->trigger();
        press_f1(w().findChild<QWidget*>(QStringLiteral("navigation_style")));
        QCOMPARE(topic(), QStringLiteral("preferences.html"));
        for (const char* name : {"tool_dialog", "tool_library", "region_dialog", "axis_dialog", "part_dialog",
                                 "preferences", "export_dialog", "unpack_dialog"}) {
            QWidget of;
            of.setObjectName(QLatin1String(name));
            QVERIFY2(ui::has_help(ui::help_topic(&of)), name);
        }
    }

    void help_window() {
        help().open(QStringLiteral("nowhere.html"));
        ui::HelpWindow& window = *help().window();
        QVERIFY(activate(window));
        QCOMPARE(topic(), QStringLiteral("index.html"));
        help().open(QStringLiteral("operations.html#rough"));
        QCOMPARE(topic(), QStringLiteral("operations.html#rough"));
        QVERIFY(window.contents()->currentItem());
        QCOMPARE(window.contents()->currentItem()->text(0), QStringLiteral("Rough"));
        window.findChild<QAction*>(QStringLiteral("help_back"))->trigger();
        QCOMPARE(topic(), QStringLiteral("index.html"));
        window.findChild<QAction*>(QStringLiteral("help_forward"))->trigger();
        QCOMPARE(topic(), QStringLiteral("operations.html#rough"));

        QTest::keyClick(&window, Qt::Key_F, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(window.search_field()->hasFocus(), patience_ms);
        QTest::keyClicks(window.search_field(), QStringLiteral("cusp tolerance"));
        QVERIFY(window.results()->count() > 3);
        QTest::keyClick(window.search_field(), Qt::Key_Return);
        QCOMPARE(window.results()->currentRow(), 0);
        QVERIFY(!window.browser()->extraSelections().isEmpty());
        QTest::keyClicks(window.search_field(), QStringLiteral(" qqq"));
        QCOMPARE(window.results()->count(), 1);
        QVERIFY(!(window.results()->item(0)->flags() & Qt::ItemIsSelectable));
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(window.search_field()->text().isEmpty() && window.isVisible());

        const int size = window.browser()->document()->defaultFont().pointSize();
        window.findChild<QAction*>(QStringLiteral("help_larger"))->trigger();
        QVERIFY(window.browser()->font().pointSize() > size
                || window.browser()->fontInfo().pointSize() > size);
        window.findChild<QAction*>(QStringLiteral("help_smaller"))->trigger();
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(!window.isVisible());
    }

    void plain_words() {
        const auto rough = make_operation("rough");
        const ParameterInfo& depth = rough->parameter("depth");
        QCOMPARE(ui::shown_word(depth, "from_tolerance"), QStringLiteral("from the tolerance"));
        QCOMPARE(ui::word_of(depth, QStringLiteral("From the tolerance ")), QStringLiteral("from_tolerance"));
        QCOMPARE(ui::word_of(depth, QStringLiteral("from_tolerance")), QStringLiteral("from_tolerance"));
        QCOMPARE(ui::word_of(depth, QStringLiteral("0.5")), QStringLiteral("0.5"));
        QVERIFY(!ui::help_html(depth, LengthUnit::mm).contains(QStringLiteral("from_tolerance")));
        // 2 mm in inches is 0.07874016; what was typed in inches keeps its digits; what is round in neither
        // was worked out.
        QCOMPARE(ui::shown_number(2, depth, LengthUnit::inch), QStringLiteral("0.07874"));
        QCOMPARE(ui::shown_number(25.4 * 0.1234567, depth, LengthUnit::inch), QStringLiteral("0.1234567"));
        QCOMPARE(ui::shown_number(25.4 * 0.0625, depth, LengthUnit::mm), QStringLiteral("1.5875"));
        QCOMPARE(ui::shown_number(std::sqrt(2), depth, LengthUnit::mm), QStringLiteral("1.414"));
        QCOMPARE(ui::shown_number(0.48, depth, LengthUnit::inch), QStringLiteral("0.0189"));
        QCOMPARE(ui::shown_number(-100.0049123, depth, LengthUnit::mm), QStringLiteral("-100.005"));
        QCOMPARE(ui::position_text(25.4 * -5.412541, LengthUnit::inch), QStringLiteral("-5.4125"));
        QCOMPARE(ui::position_text(1e-9, LengthUnit::mm), QStringLiteral("0"));
        // No word of any operation has an underscore, and every one leads back.
        for (const OperationKind& kind : operation_kinds()) {
            const auto operation = kind.make();
            for (const ParameterInfo* p : operation->parameters())
                for (const std::string& word : p->words) {
                    const QString shown = ui::shown_word(*p, word);
                    QVERIFY2(!shown.contains(QChar('_')), qPrintable(shown));
                    QCOMPARE(ui::word_of(*p, shown), ui::text(word));
                }
        }
        QVERIFY(open_part());
        w().document().add_operation("rough");
        w().tree().select({TreeNode::Kind::operation, 0});
        enter(w(), "depth", QStringLiteral("from the tolerance"));
        QCOMPARE(std::get<std::string>(w().document().operation(0).get("depth")),
                 std::string("from_tolerance"));
        QCOMPARE(field(w(), "depth")->text(), QStringLiteral("from the tolerance"));
        enter(w(), "depth", QStringLiteral("nonsense"));
        QVERIFY2(error_under(w(), "depth").contains(QStringLiteral("from the tolerance")),
                 qPrintable(error_under(w(), "depth")));
    }

    /// What the chapter "First job, step by step" tells, done by keys and clicks.
    void guided_first_job() {
        const QString folder = scratch_folder(QStringLiteral("first-job"));
        save_stl(relief(), (folder + "/relief.stl").toStdString(), LengthUnit::mm, {});
        QVERIFY(wait_until_settled(w()));
        picture(w(), QStringLiteral("start")); // 1
        auto* control = w().findChild<QComboBox*>(QStringLiteral("usual_post"));
        control->setCurrentIndex(control->findData(QStringLiteral("grbl")));
        emit control->activated(control->currentIndex());

        w().open_file(folder + "/relief.stl"); // 2
        auto* asked = dialog<ui::PartDialog>();
        QVERIFY(asked);
        for (auto* unit : asked->findChildren<QRadioButton*>())
            if (unit->objectName() == QStringLiteral("unit_mm")) unit->click();
        asked->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(w().document().has_part());

        QVERIFY(activate(w()));
        QTest::keyClick(&w(), Qt::Key_P); // 3
        QVERIFY(wait_until_settled(w()));
        click("place_square");
        click("place_centre");
        click("zero_4");
        auto* dock = w().findChild<QDockWidget*>(QStringLiteral("place_dock"));
        QVERIFY(dock->isVisible());
        picture(w(), QStringLiteral("place"));
        dock->hide();

        w().tree().select({TreeNode::Kind::stock, 0}); // 4
        enter(w(), "margin2", QStringLiteral("1"));

        w().tree().select({TreeNode::Kind::tool, 0}); // 5
        choose(QStringLiteral("Edit tool"));
        auto* ball = dialog<ui::ToolDialog>();
        QVERIFY(ball && activate(*ball));
        auto* diameter = ball->findChild<QLineEdit*>(QStringLiteral("diameter"));
        type_over(diameter, QStringLiteral("6"));
        QTest::keyClick(diameter, Qt::Key_Tab);
        ball->accept();
        QTRY_VERIFY_WITH_TIMEOUT(!w().findChild<ui::ToolDialog*>(), patience_ms);
        choose(QStringLiteral("Add tool"));
        auto* flat = dialog<ui::ToolDialog>();
        QVERIFY(flat && activate(*flat));
        auto* shape = flat->findChild<QComboBox*>(QStringLiteral("shape"));
        shape->setCurrentIndex(shape->findText(said_names(QStringLiteral("Flat end")).value(0)));
        emit shape->activated(shape->currentIndex());
        diameter = flat->findChild<QLineEdit*>(QStringLiteral("diameter"));
        type_over(diameter, QStringLiteral("10"));
        QTest::keyClick(diameter, Qt::Key_Tab);
        picture(*flat, QStringLiteral("tool"));
        flat->accept();
        QCOMPARE(w().document().project().tools.size(), std::size_t(2));

        choose(QStringLiteral("Rough")); // 6
        QCOMPARE(w().document().operation_count(), std::size_t(2));
        QCOMPARE(w().document().operation(0).kind(), std::string_view("rough"));

        QVERIFY(activate(w()));
        w().setFocus();
        QTest::keyClick(&w(), Qt::Key_F5); // 7
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        QVERIFY(w().document().state(1) == ui::OperationState::planned);
        w().tree().select({TreeNode::Kind::operation, 1});
        w().viewport().set_view(StandardView::iso);
        QVERIFY(wait_until_settled(w()));
        picture(w(), QStringLiteral("planned"));

        QTest::keyClick(&w(), Qt::Key_F6); // 8
        QVERIFY(wait_until_settled(w()));
        const ui::VerificationModel& model = w().verification().model();
        QVERIFY2(model.verdict() == ui::Verdict::verified, qPrintable(model.failure_text()));
        picture(w(), QStringLiteral("verified"));

        QTest::keyClick(&w(), Qt::Key_Space); // 9
        QTest::qWait(200);
        QTest::keyClick(&w(), Qt::Key_Space);
        QVERIFY(wait_until_settled(w()));

        QTest::keyClick(&w(), Qt::Key_E, Qt::ControlModifier); // 10
        QLineEdit* into = nullptr;
        QTRY_VERIFY_WITH_TIMEOUT((into = w().findChild<QLineEdit*>(QStringLiteral("export_folder"))),
                                 patience_ms);
        type_over(into, folder + "/programs");
        into->window()->findChild<QPushButton*>(QStringLiteral("export"))->click();
        QVERIFY(wait_until_settled(w()));
        QTRY_VERIFY_WITH_TIMEOUT(QDir(folder + "/programs").entryList({QStringLiteral("*.nc")}).size() == 2,
                                 patience_ms);
        QVERIFY(w().files().save_to(folder + "/job.facetmill"));
    }

    /// The pictures of the other chapters.
    void pictures_of_chapters() {
        if (picture_folder().isEmpty()) QSKIP("made by packaging/manual-pictures");
        QVERIFY(plan_five_axes());
        auto* dock = w().findChild<QDockWidget*>(QStringLiteral("cspace_dock"));
        dock->show();
        dock->raise();
        w().resizeDocks({dock}, {480}, Qt::Horizontal);
        QVERIFY(wait_until_settled(w()));
        picture(*dock->widget(), QStringLiteral("cspace"));
        w().resizeDocks({dock}, {380}, Qt::Horizontal);
        w().findChild<QDockWidget*>(QStringLiteral("chart_dock"))->toggleViewAction()->trigger();
        QVERIFY(wait_until_settled(w()));
        if (picture_language().isEmpty()) // README's
            QVERIFY(shot(w(), QStringLiteral("workbench"))
                        .save(picture_folder() + QStringLiteral("/../workbench.png"), "PNG", 0));
        close_window();

        QVERIFY(show_window());
        const QString folder = scratch_folder(QStringLiteral("dents"));
        const Mesh dents = height_field(
            [](double x, double y) {
                const auto dent = [&](double at, double depth) {
                    return -depth * std::exp(-((x - at) * (x - at) + y * y) / 16);
                };
                return dent(-12, 1.1) + dent(12, 0.8);
            },
            Vec2(-26, -12), Vec2(26, 12), 52, 24);
        save_stl(dents, (folder + "/dents.stl").toStdString(), LengthUnit::mm, {});
        w().open_file(folder + "/dents.stl", LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        w().document().change(QStringLiteral("Tools"), [](Project& p) {
            p.machine = "tarus-tpi-2000";
            p.tools.front().diameter = p.tools.front().shank_diameter = 8;
            p.tools.front().corner_radius = 0;
            Tool ball = p.tools.front();
            ball.number = 7;
            ball.name = "Ball 3";
            ball.diameter = ball.shank_diameter = 3;
            ball.corner_radius = 1.5;
            p.tools.push_back(ball);
        });
        w().document().add_operation("global_local");
        w().document().remove_operation(0);
        w().document().change(QStringLiteral("Coarse"), [](Project& p) {
            Operation& operation = *p.operations[0];
            operation.common().tool = 1;
            operation.common().tolerance = 0.1;
            operation.set("direction", 0.0);
            operation.set("rework_offset", 1.0);
            operation.set("posture", std::string("cm2"));
            operation.set("lead_limit", radians(6));
            operation.set("raise_lead_limit", false);
            operation.set("rework_tool", 7L);
        });
        w().plan();
        QVERIFY(wait_until_settled(w()));
        QVERIFY2(w().last_failure().isEmpty(), qPrintable(w().last_failure()));
        for (const char* off : {"layer_cuts", "layer_links", "layer_rapids"})
            if (auto* box = w().findChild<QAbstractButton*>(QLatin1String(off)); box && box->isChecked())
                box->click();
        QVERIFY(wait_until_settled(w()));
        picture(w().viewport(), QStringLiteral("regions"));
    }

    void pictures_of_the_scan_room() {
        if (picture_folder().isEmpty()) QSKIP("made by packaging/manual-pictures");
        const QString path = scratch_folder(QStringLiteral("dome")) + QStringLiteral("/dome.stl");
        save_stl(scanned_dome(), path.toStdString(), LengthUnit::mm, {});
        w().open_file(path, LengthUnit::mm);
        QVERIFY(wait_until_settled(w()));
        w().viewport().set_view(StandardView::front);
        choose(QStringLiteral("Scan room"));
        QVERIFY(wait_until_settled(w()));
        click("scan_suggest");
        auto* steps = w().findChild<QListWidget*>(QStringLiteral("scan_steps"));
        steps->setCurrentRow(steps->count() - 1);
        choose(QStringLiteral("Smooth noise"));
        type_over(w().controllers().scan().panel()->form()->findChild<QLineEdit*>(QStringLiteral("bound")),
                  QStringLiteral("0.1"));
        click("scan_preview");
        QTest::qWait(20); // the list is laid out
        picture(w(), QStringLiteral("scan_after"));
        click("scan_before");
        picture(w().viewport(), QStringLiteral("scan_before"));
    }
};

FACETMILL_TEST(TestWindowManual)
#include "test_window_manual.moc"
