// The window in other languages: every text of core is known in them, messages keep what fills their places,
// numbers are written and read the user's way. That nothing is cut is asked by test_window_layout.cpp.
#include "core/job/program_files.h"
#include "core/job/project.h"
#include "core/output/post/post.h"
#include "core/setup/machine.h"
#include "tests/screenshot/window_support.h"
#include "ui/document.h"
#include "ui/language.h"
#include "ui/parameter_editor.h"
#include "ui/preferences_dialog.h"
#include "ui/project_tree.h"
#include "ui/rough_controller.h"
#include "ui/settings.h"
#include "ui/setup_list.h"
#include "ui/study_draft.h"
#include "ui/study_form.h"
#include "ui/text.h"
#include "ui/tool_dialog.h"
#include "ui/value_words.h"
#include "ui/worded.h"

#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTest>
#include <QTreeWidget>

#include <algorithm>

using namespace facetmill;
using namespace facetmill::test;
using ui::TreeNode;

namespace {

/// All described parameters of projects, with those of their lists.
std::vector<const ParameterInfo*> all_parameters() {
    std::vector<const ParameterInfo*> all;
    const auto add = [&](const std::vector<const ParameterInfo*>& some) {
        for (const ParameterInfo* p : some) {
            all.push_back(p);
            all.insert(all.end(), p->record.begin(), p->record.end());
        }
    };
    add(part_parameters().infos());
    add(place_parameters().infos());
    add(stock_parameters().infos());
    add(fixture_parameters().infos());
    add(boundary_parameters().infos());
    add(program_parameters().infos());
    add(verify_limit_parameters().infos());
    add(tool_parameters().infos());
    for (const OperationKind& kind : operation_kinds())
        add(kind.make()->parameters());
    return all;
}

QStringList message_templates() {
    QFile file(QStringLiteral(":/languages/messages.txt"));
    if (!file.open(QIODevice::ReadOnly)) return {};
    return QString::fromUtf8(file.readAll()).split(QChar('\n'), Qt::SkipEmptyParts);
}

/// With "7.5", "8.5" ... in its places.
QString filled(const QString& id, QStringList& values) {
    static const QRegularExpression place(QStringLiteral("\\{\\d+\\}"));
    QString text;
    qsizetype from = 0;
    for (auto it = place.globalMatch(id); it.hasNext();) {
        const auto match = it.next();
        values << QStringLiteral("%1.5").arg(7 + values.size());
        text += id.mid(from, match.capturedStart() - from) + values.back();
        from = match.capturedEnd();
    }
    return text + id.mid(from);
}

} // namespace

class TestWindowLanguages : public QObject, public WindowFixture {
    Q_OBJECT

private slots:
    void cleanup() {
        close_window();
        ui::speak(QStringLiteral("en"));
        ui::settings::set_language({});
    }

    void each_described_text_is_known_data() {
        QTest::addColumn<QString>("language");
        QTest::newRow("de") << QStringLiteral("de");
        QTest::newRow("fr") << QStringLiteral("fr");
    }
    void each_described_text_is_known() {
        QFETCH(QString, language);
        ui::speak(language);
        QCOMPARE(ui::spoken_language(), language);
        QStringList unknown;
        const auto check = [&](const std::string& english) {
            // Some words are alike; whole sentences are not.
            if (english.find(' ') != std::string::npos && ui::worded(english) == ui::text(english))
                unknown << ui::text(english);
        };
        for (const ParameterInfo* p : all_parameters()) {
            check(p->label);
            check(p->help);
            check(p->required);
        }
        for (const OperationKind& kind : operation_kinds())
            check(kind.label);
        for (const Machine& m : machines())
            if (m.name.find("tarus") == std::string::npos) check(m.label);
        QVERIFY2(unknown.isEmpty(), qPrintable(unknown.join(QChar('\n'))));
    }

    void messages_are_known_by_what_stands_between_their_places() {
        const QStringList all = message_templates();
        QVERIFY(all.size() > 300);
        QStringList wrong;
        for (const QString& id : all) {
            QStringList values;
            const QString message = filled(id, values);
            const QString found = ui::message_id(message);
            // Where another one says as much of it, its places hold the same.
            if (found != id && (found.isEmpty() || ui::filled_places(message, found) != values))
                wrong << id + QStringLiteral(" ≠ ") + found;
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QChar('\n'))));
    }

    void messages_keep_their_values_and_names() {
        ui::speak(QStringLiteral("de"));
        QCOMPARE(ui::worded("the diameter -1 is not above 0"),
                 QStringLiteral("der Durchmesser -1 ist nicht über 0"));
        QCOMPARE(ui::worded("the value 0.25 mm is out of range"),
                 QStringLiteral("der Wert 0,25 mm ist außerhalb des Bereichs"));
        // A name is a name, even one that is a word of the catalogue.
        QCOMPARE(ui::worded("there is no operation 'Rough'"),
                 QStringLiteral("es gibt keine Operation „Rough“"));
        // Messages in the places of messages.
        QCOMPARE(ui::worded("expected a whole number"), QStringLiteral("eine ganze Zahl erwartet"));
        QCOMPARE(ui::worded("allowed: above 0 mm and at most 2.5 mm"),
                 QStringLiteral("erlaubt: über 0 mm und höchstens 2,5 mm"));
        const Error e(ErrorCode::out_of_range, "part.stl: facet 12", "a corner is not a finite number",
                      "the file is damaged: export it again");
        const QString line =
            QStringLiteral("part.stl: Facette 12: eine Ecke ist keine endliche Zahl (die Datei ist "
                           "beschädigt: neu exportieren)");
        QCOMPARE(ui::worded(e), line);
        QCOMPARE(ui::worded(QString::fromUtf8(e.what())), line); // the same once it is one text
        QCOMPARE(ui::worded("nobody has written this"), QStringLiteral("nobody has written this"));
        // Each of a list, however long it is and whatever stands before and behind it.
        const QString place = QStringLiteral("the machine cannot incline the tool like this");
        QStringList motions;
        for (int i = 4; i < 12; ++i)
            motions << QStringLiteral("motion %1: %2").arg(i).arg(place);
        const QString listed = ui::worded(QStringLiteral("Generic mill (3-axis) does not hold 70 of 80 "
                                                         "motions as planned: %1; and 62 more")
                                              .arg(motions.join(QStringLiteral("; "))));
        QVERIFY2(!listed.contains(QStringLiteral("motion")) && !listed.contains(QStringLiteral("Generic")),
                 qPrintable(listed));
        ui::speak(QStringLiteral("en"));
        QCOMPARE(ui::worded(e), QString::fromUtf8(e.what()));
    }

    /// Names stand in the quotes of the language, and apostrophes are no quotes.
    void names_stand_in_the_languages_quotes() {
        const Error e(ErrorCode::out_of_range, "operation 'Rough'", "unknown value 'three'", "");
        ui::speak(QStringLiteral("en"));
        QCOMPARE(ui::worded(e), QString::fromUtf8(e.what()));
        QCOMPARE(ui::in_user_quotes(QStringLiteral("'a' isn't 'b'")), QStringLiteral("'a' isn't 'b'"));
        ui::speak(QStringLiteral("de"));
        QVERIFY2(ui::worded(e).contains(QStringLiteral("„Rough“"))
                     && ui::worded(e).contains(QStringLiteral("„three“"))
                     && !ui::worded(e).contains(QChar('\'')),
                 qPrintable(ui::worded(e)));
        ui::speak(QStringLiteral("fr"));
        QVERIFY2(ui::worded(e).contains(QStringLiteral("«\u00a0three\u00a0»")), qPrintable(ui::worded(e)));
        QCOMPARE(ui::in_user_quotes(QStringLiteral("l'axe d'une 'Ébauche de l'avant' n'est pas 'd'")),
                 QStringLiteral("l'axe d'une «\u00a0Ébauche de l'avant\u00a0» n'est pas «\u00a0d\u00a0»"));
        QCOMPARE(ui::in_user_quotes(QStringLiteral("3' 5' et 1'")), QStringLiteral("3' 5' et 1'"));
    }

    void stages_of_operations_are_said() {
        ui::speak(QStringLiteral("de"));
        const QString said = ui::worded("Valleys (1 of 2): Valleys: linking");
        QVERIFY2(said.startsWith(QStringLiteral("Valleys (1 von 2): Valleys: ")), qPrintable(said));
        QVERIFY2(!said.contains(QStringLiteral("linking")), qPrintable(said));
        // Colons are set as the language sets them.
        ui::speak(QStringLiteral("fr"));
        const QString french = ui::worded("Valleys (1 of 2): Valleys: linking");
        QVERIFY2(french.count(QStringLiteral("\u00a0: ")) == 2 && french.count(QChar(':')) == 2,
                 qPrintable(french));
        const Error e(ErrorCode::out_of_range, "part.stl: facet 12", "a corner is not a finite number", "");
        QVERIFY2(ui::worded(e).count(QStringLiteral("\u00a0: ")) == 2, qPrintable(ui::worded(e)));
    }

    /// Numbers to type have their unit, and their range is told in the user's language.
    void a_study_is_asked_in_the_users_words() {
        Box3 box;
        box.add(Vec3::Zero());
        box.add(Vec3(90, 45, 30));
        const Project project = default_project("part.stl", LengthUnit::inch, box);
        for (const char* language : {"en", "de", "fr"}) {
            ui::speak(QString::fromLatin1(language));
            ui::StudyForm form;
            form.set_draft(ui::draft_for(project));
            const QString range =
                form.findChild<QLineEdit*>(QStringLiteral("study_values_tolerance"))->toolTip();
            QVERIFY2(range.contains(QStringLiteral("at most")) == (language == QStringLiteral("en")),
                     qPrintable(range));
            const auto* vary = form.findChild<QTreeWidget*>(QStringLiteral("study_vary"));
            QVERIFY(vary->findItems(QStringLiteral(" (in)"), Qt::MatchEndsWith | Qt::MatchRecursive).size()
                    > 1);
        }
        ui::speak(QStringLiteral("en"));
    }

    void words_in_the_view_are_said() {
        ui::speak(QStringLiteral("fr"));
        QCOMPARE(ui::said_in_view("CM2, planned"), std::string("CM2, planifiée"));
        QCOMPARE(ui::said_in_view("Chosen: CM2, planned"), std::string("Choisi\u00a0: CM2, planifiée"));
        QCOMPARE(ui::said_in_view("Lift, in"), std::string("Levée, in"));
        ui::speak(QStringLiteral("en"));
    }
    void large_counts_in_messages_have_gaps() {
        const QString message =
            QStringLiteral("M12345 does not hold 779670 of 780152 motions as planned: "
                           "motion 4: the machine cannot incline the tool like this; and 9667 more");
        const QString gap(QChar(0x202F));
        for (const char* language : {"en", "de", "fr"}) {
            ui::speak(QString::fromLatin1(language));
            const QString said = ui::worded(message);
            for (const QString& whole : {QStringLiteral("779") + gap + QStringLiteral("670"),
                                         QStringLiteral("780") + gap + QStringLiteral("152"),
                                         QStringLiteral("M12345"), QStringLiteral("9667")})
                QVERIFY2(said.contains(whole), qPrintable(said));
            // Lengths are told in other units afterwards.
            QVERIFY(
                ui::worded("allowed: above 0 mm and at most 12500 mm").contains(QStringLiteral("12500 mm")));
            QCOMPARE(ui::worded("nobody wrote 12345"), QStringLiteral("nobody wrote 12345"));
        }
    }

    void numbers_are_written_and_read_the_users_way() {
        const ParameterInfo& info = tool_parameters().find("diameter")->info;
        const auto read = [&](const char* entry) {
            return std::get<double>(
                ui::read_entered(info, QString::fromUtf8(entry), LengthUnit::mm, {{"stock.x", 3.5}}));
        };
        ui::speak(QStringLiteral("de"));
        QCOMPARE(ui::shown_number(0.125, info, LengthUnit::mm), QStringLiteral("0,125"));
        QCOMPARE(ui::number_text(1234.5), QStringLiteral("1234,5"));
        QCOMPARE(read("0,5"), 0.5);
        QCOMPARE(read("0.5"), 0.5);
        QCOMPARE(read(",5"), 0.5);
        QCOMPARE(read("25,4/2"), 12.7);
        QCOMPARE(read("= stock.x * 2 + 0,25"), 7.25);
        QCOMPARE(read("0.125"), 0.125);
        QCOMPARE(read("12,125"), 12.125);
        for (const char* unclear : {"1.500", "1.234,5", "1,234,567"})
            QVERIFY_EXCEPTION_THROWN(read(unclear), Error);
        QCOMPARE(ui::in_user_numbers(QStringLiteral("G54.1, v0.1.0: 2.5, 3.5 mm, part2.5.stl")),
                 QStringLiteral("G54.1, v0.1.0: 2,5; 3,5 mm, part2.5.stl"));
        QCOMPARE(ui::in_user_numbers(QStringLiteral("1.25e-06, 2.5e3x")), QStringLiteral("1,25e-06; 2.5e3x"));
        QCOMPARE(ui::with_lengths_in(QStringLiteral("um bis zu 25,4 mm"), LengthUnit::inch),
                 QStringLiteral("um bis zu 1 in"));
        ui::speak(QStringLiteral("en"));
        QCOMPARE(ui::shown_number(0.125, info, LengthUnit::mm), QStringLiteral("0.125"));
        QVERIFY_EXCEPTION_THROWN(read("0,5"), Error);
    }

    void the_window_speaks_german_and_files_do_not() {
        ui::speak(QStringLiteral("de"));
        QVERIFY(show_window() && open_part());
        w().tree().select({TreeNode::Kind::operation, 0});
        QVERIFY(wait_until_settled(w()));
        QStringList menus;
        for (const QAction* a : w().menuBar()->actions())
            menus << a->text().remove(QChar('&'));
        QVERIFY2(menus.contains(QStringLiteral("Datei")), qPrintable(menus.join(QChar(' '))));
        enter(w(), "tolerance", QStringLiteral("0,0125"));
        QCOMPARE(first_operation(w()).tolerance, 0.0125 * mm_per_inch);
        QCOMPARE(field(w(), "tolerance")->text(), QStringLiteral("0,0125"));
        enter(w(), "tolerance", QStringLiteral("-1"));
        QVERIFY2(error_under(w(), "tolerance").contains(QStringLiteral("außerhalb des Bereichs")),
                 qPrintable(error_under(w(), "tolerance")));
        shot(w(), QStringLiteral("language-de-error"));
        enter(w(), "tolerance", QStringLiteral("0.0125"));
        const QString file = scratch_folder(QStringLiteral("german")) + QStringLiteral("/part.facetmill");
        QVERIFY(w().files().save_to(file));
        QFile saved(file);
        QVERIFY(saved.open(QIODevice::ReadOnly));
        QVERIFY(saved.readAll().contains("0.0125"));
    }

    /// What the program calls a setup is said in the user's language, the first one's as well.
    void setups_have_names_of_the_language() {
        ui::speak(QStringLiteral("de"));
        QVERIFY(show_window() && open_part());
        ui::add_setup(w().document(), ui::NewSetup::flipped_about_x);
        const Project& project = w().document().project();
        QCOMPARE(setup_count(project), std::size_t(2));
        QCOMPARE(setup_at(project, 0).name, std::string("Aufspannung 1"));
        QCOMPARE(setup_at(project, 1).name, std::string("Aufspannung 2"));
        w().document().undo_stack().undo();
        QCOMPARE(project.name, usual_setup_name(0));
        ui::duplicate_setup(w().document(), 0);
        QCOMPARE(setup_at(project, 0).name, std::string("Aufspannung 1"));
        QCOMPARE(setup_at(project, 1).name, std::string("Aufspannung 2"));
    }

    void new_operations_have_names_of_the_language() {
        ui::speak(QStringLiteral("fr"));
        QVERIFY(show_window() && open_part());
        QCOMPARE(first_operation(w()).name, std::string("Finition"));
        w().document().add_operation("rough");
        w().document().add_operation("finish3");
        QStringList names;
        for (const auto& o : w().document().project().operations)
            names << ui::text(o->common().name);
        names.sort();
        QStringList kinds;
        for (const QAction* a : w().tree().add_operation_menu()->actions())
            kinds << a->text();
        QVERIFY2(kinds.contains(QString::fromUtf8("\xC3\x89"
                                                  "bauche"))
                     && kinds.contains(QStringLiteral("Nettoyage"))
                     && kinds.contains(QStringLiteral("Finition, 3 axes")),
                 qPrintable(kinds.join(QChar(' '))));
        QCOMPARE(names, (QStringList{QStringLiteral("Finition"), QStringLiteral("Finition 2"),
                                     QString::fromUtf8("\xC3\x89"
                                                       "bauche")}));
        const auto files = program_file_names(w().document().project());
        QVERIFY(std::find(files.begin(), files.end(), "01-Ebauche.apt") != files.end());
    }

    void new_tools_have_names_of_the_language() {
        ui::speak(QStringLiteral("de"));
        QVERIFY(show_window() && open_part());
        const auto& tools = w().document().project().tools;
        const std::string first = tools.front().name;
        QVERIFY2(first.starts_with("Kugel "), first.c_str());
        // One that the program adds for clean-up, and one that is edited.
        w().document().add_operation("cleanup");
        QCOMPARE(tools.size(), std::size_t(2));
        QVERIFY2(tools.back().name.starts_with("Kugel ") && tools.back().name != first,
                 tools.back().name.c_str());
        ui::ToolDialog* dialog = ui::ToolDialog::open_for(w().document(), std::nullopt, &w());
        QVERIFY(dialog && dialog->tool().name.starts_with("Kugel "));
        auto* shape = dialog->findChild<QComboBox*>(QStringLiteral("shape"));
        shape->setCurrentIndex(shape->findText(QStringLiteral("Flach")));
        emit shape->activated(shape->currentIndex());
        QVERIFY2(dialog->tool().name.starts_with("Flach "), dialog->tool().name.c_str());
        dialog->accept();
        QVERIFY(tools.back().name.starts_with("Flach "));
        // What a project calls a tool stays what it is.
        w().document().change(QStringLiteral("Name"), [](Project& p) { p.tools.front().name = "Ball 6"; });
        const QString file = scratch_folder(QStringLiteral("tool-names")) + QStringLiteral("/part.facetmill");
        QVERIFY(w().files().save_to(file));
        w().open_file(file);
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(tools.front().name, std::string("Ball 6"));
        QVERIFY(tools.back().name.starts_with("Flach "));
    }

    void mnemonics_are_their_own_in_every_menu_data() { each_described_text_is_known_data(); }
    void mnemonics_are_their_own_in_every_menu() {
        QFETCH(QString, language);
        ui::speak(language);
        QVERIFY(show_window());
        QStringList twice;
        const auto look = [&](const QList<QAction*>& actions, const QString& menu) {
            QString seen;
            for (const QAction* a : actions) {
                const qsizetype at = QString(a->text())
                                         .replace(QStringLiteral("&&"), QStringLiteral("__"))
                                         .indexOf(QChar('&'));
                if (at < 0 || !a->isVisible()) continue;
                const QChar key = a->text()[at + 1].toLower();
                if (seen.contains(key)) twice << menu + QStringLiteral(": ") + a->text();
                seen += key;
            }
        };
        look(w().menuBar()->actions(), QStringLiteral("bar"));
        for (const QMenu* menu : w().findChildren<const QMenu*>())
            look(menu->actions(), menu->title());
        QVERIFY2(twice.isEmpty(), qPrintable(twice.join(QChar('\n'))));
    }

    void a_number_decides_between_forms_data() {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QString>("none");
        QTest::addColumn<QString>("one");
        QTest::addColumn<QString>("three");
        QTest::newRow("en") << QStringLiteral("en") << QStringLiteral("0 files, 0 layers")
                            << QStringLiteral("1 file, 1 layer") << QStringLiteral("3 files, 3 layers");
        QTest::newRow("de") << QStringLiteral("de") << QStringLiteral("0 Dateien, 0 Ebenen")
                            << QStringLiteral("1 Datei, 1 Ebene") << QStringLiteral("3 Dateien, 3 Ebenen");
        QTest::newRow("fr") << QStringLiteral("fr") << QStringLiteral("0 fichier, 0 niveau")
                            << QStringLiteral("1 fichier, 1 niveau")
                            << QStringLiteral("3 fichiers, 3 niveaux");
    }
    void a_number_decides_between_forms() {
        QFETCH(QString, language);
        ui::speak(language);
        const auto said = [](int n) {
            static const QRegularExpression files(QStringLiteral("\\d \\w+"));
            return files.match(ui::ProgramExport::tr("Wrote %n files into %1.", nullptr, n)).captured()
                   + QStringLiteral(", ") + ui::RoughController::tr("%1 layers", nullptr, n).arg(n);
        };
        QTEST(said(0), "none");
        QTEST(said(1), "one");
        QTEST(said(3), "three");
    }

    void the_language_is_chosen_in_the_preferences() {
        ui::PreferencesDialog dialog;
        auto* box = dialog.findChild<QComboBox*>(QStringLiteral("language"));
        QVERIFY(box);
        QCOMPARE(box->currentData().toString(), QString());
        box->setCurrentIndex(box->findData(QStringLiteral("fr")));
        dialog.accept();
        QCOMPARE(ui::settings::language(), QStringLiteral("fr"));
        QCOMPARE(ui::language_for(ui::settings::language()), QStringLiteral("fr"));
        QCOMPARE(ui::language_for(QStringLiteral("xx")), ui::language_for(QString()));
    }
};

FACETMILL_TEST(TestWindowLanguages)

#include "test_window_languages.moc"
