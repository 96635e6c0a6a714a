// The page of studies: asked, worked on by processes, stopped and gone on with, looked at in pictures and
// table, adopted and undone; and what it says where something is wrong.
#include "core/study/study_folder.h"
#include "tests/screenshot/cut_texts.h"
#include "tests/screenshot/window_support.h"
#include "ui/controllers.h"
#include "ui/help.h"
#include "ui/help_browser.h"
#include "ui/help_window.h"
#include "ui/language.h"
#include "ui/message_bar.h"
#include "ui/project_tree.h"
#include "ui/study_chart.h"
#include "ui/study_controller.h"
#include "ui/study_form.h"
#include "ui/study_runner.h"
#include "ui/study_sight.h"
#include "ui/study_table.h"
#include "ui/text.h"
#include "ui/verification_controller.h"
#include "ui/viewport.h"

#include <QAction>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <QTextBrowser>
#include <QTreeWidget>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include <sys/resource.h>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// As if the disk were full, for this process and those that it begins, as long as it lives.
class FullDisk {
public:
    explicit FullDisk(std::size_t most) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, SIG_IGN);
        rlimit now = before_;
        now.rlim_cur = most;
        ::setrlimit(RLIMIT_FSIZE, &now);
    }
    ~FullDisk() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, SIG_DFL);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit before_{};
};

} // namespace

class TestWindowStudy : public QObject, private WindowFixture {
    Q_OBJECT
private slots:
    void initTestCase() {
        if (!qEnvironmentVariableIsSet("FACETMILL_CLI")) qputenv("FACETMILL_CLI", FACETMILL_CLI_PROGRAM);
    }
    void init() {
        QVERIFY(show_window());
        QVERIFY(open_part());
        folder_ = scratch_folder(QStringLiteral("study"));
        w().tree().select({ui::TreeNode::Kind::operation, 0});
        enter(w(), "tolerance", QStringLiteral("0.03"));
        QVERIFY(w().files().save_to(folder_ + QStringLiteral("/job.facetmill")));
        QVERIFY(settled());
    }
    void cleanup() { leave_as_found(); }

    /// From the question to the project, by mouse and keys.
    void a_study_is_asked_run_looked_at_and_adopted() {
        QTest::keyClick(&w(), Qt::Key_S);
        QVERIFY(activate(dialog()));
        QVERIFY(!dialog().start_button()->isEnabled());
        QVERIFY(estimate().contains(QStringLiteral("Nothing may vary")));
        ask();
        QVERIFY2(estimate().contains(QStringLiteral("Candidates: 4 to plan")), qPrintable(estimate()));
        // Buttons stand close under what they are about.
        const auto* bar = dialog().findChild<QProgressBar*>(QStringLiteral("study_progress"));
        QVERIFY(bar);
        const int above = dialog().start_button()->mapTo(&dialog(), QPoint()).y() - bar->geometry().bottom();
        QVERIFY2(above <= 8, qPrintable(QString::number(above)));
        shot(dialog(), QStringLiteral("study-question"));
        QTest::mouseClick(dialog().start_button(), Qt::LeftButton);
        QVERIFY(study().running() && dialog().stop_button()->isEnabled());
        QVERIFY(settled());
        QVERIFY2(dialog().status().contains(QStringLiteral("wins")), qPrintable(dialog().status()));
        QVERIFY(QFile::exists(folder_ + QStringLiteral("/job.study.json")));
        QVERIFY(QFile::exists(folder_ + QStringLiteral("/job.study/study.json")));
        const std::size_t winner = *figures().winner;
        QCOMPARE(figures().rows.size(), std::size_t(5));
        QCOMPARE(dialog().chosen(), std::optional(winner));

        click_through_the_pictures();
        range_keeps_candidates();

        dialog().choose(winner);
        QVERIFY(settled());
        QVERIFY(dialog().sight()->shown() && dialog().sight()->shown()->setups.front().deviation);
        QVERIFY(dialog().sight()->report()->toPlainText().contains(QStringLiteral("Machining time")));
        shot(dialog(), QStringLiteral("study-candidates"));
        const int steps = w().document().undo_stack().index();
        const auto before = w().document().operation(0).get("direction");
        QTest::mouseClick(dialog().adopt_button(), Qt::LeftButton);
        QCOMPARE(w().document().undo_stack().index(), steps + 1);
        const Choice wanted = chosen_of(winner);
        QCOMPARE(std::get<std::string>(w().document().operation(0).get("direction")), wanted.direction);
        QVERIFY(std::abs(w().document().operation(0).common().tolerance / mm_per_inch - wanted.tolerance)
                < 1e-9);
        QVERIFY(settled());
        action(w(), "undo")->trigger();
        QVERIFY(w().document().operation(0).get("direction") == before);
        QVERIFY(settled());
    }

    /// All in the folder is found again, by a window that was closed meanwhile as well.
    void a_stopped_run_goes_on() {
        study().open();
        ask();
        auto* tolerance = dialog().findChild<QLineEdit*>(QStringLiteral("study_values_tolerance"));
        type_over(tolerance, QStringLiteral("0.02; 0.022; 0.024; 0.026; 0.028; 0.03"));
        study().start();
        QVERIFY(QTest::qWaitFor([&] { return known_looks() > 0; }, patience_ms));
        QVERIFY(QFile::exists(folder_ + QStringLiteral("/job.study.json")));
        QTest::mouseClick(dialog().stop_button(), Qt::LeftButton);
        QVERIFY(settled());
        QVERIFY2(dialog().status().contains(QStringLiteral("Stopped")), qPrintable(dialog().status()));
        const std::size_t known = known_looks();
        QVERIFY(known > 0 && !QFile::exists(folder_ + QStringLiteral("/job.study/study.json")));
        close_window();
        QVERIFY(show_window());
        study().open_study(folder_ + QStringLiteral("/job.study"));
        QVERIFY(settled());
        QVERIFY(study().look() && !study().look()->outcome.decision.missing.empty());
        QVERIFY(known_looks() >= known);
        QCOMPARE(dialog().start_button()->text(), QStringLiteral("&Resume"));
        QVERIFY(dialog().status().contains(QStringLiteral("Resume")));
        study().start();
        QVERIFY(settled());
        QVERIFY2(dialog().status().contains(QStringLiteral("wins")), qPrintable(dialog().status()));
        QVERIFY(QFile::exists(folder_ + QStringLiteral("/job.study/study.json")));
    }

    void table_and_picture_are_written() {
        run_study_here();
        bool asked = false;
        answer_file_dialog(asked, folder_ + QStringLiteral("/table.csv"));
        QTest::mouseClick(button("study_table_file"), Qt::LeftButton);
        QVERIFY(settled());
        QFile table(folder_ + QStringLiteral("/table.csv"));
        QVERIFY(asked && table.open(QIODevice::ReadOnly));
        QCOMPARE(table.readAll().count('\n'), 6); // a head, the project, four candidates
        for (int tab = 0; tab < dialog().pictures()->count(); ++tab) {
            dialog().pictures()->setCurrentIndex(tab);
            const QString file = folder_ + QStringLiteral("/picture%1.png").arg(tab);
            answer_file_dialog(asked = false, file);
            QTest::mouseClick(button("study_picture_file"), Qt::LeftButton);
            QVERIFY(settled());
            const QImage image(file);
            QVERIFY(!image.isNull());
            QImage blank = image;
            blank.fill(image.pixel(0, 0));
            QVERIFY(changed_pixels(image, blank) > 3000);
        }
    }

    void a_limit_that_nobody_meets_names_the_nearest() {
        study().open();
        ask();
        auto* most = dialog().findChild<QLineEdit*>(QStringLiteral("study_most_machining_time"));
        type_over(most, QStringLiteral("0.001"));
        study().start();
        QVERIFY(settled());
        QVERIFY2(dialog().status().contains(QStringLiteral("No candidate meets the limits; nearest comes")),
                 qPrintable(dialog().status()));
        QVERIFY(dialog().status().contains(QStringLiteral("machining_time is")));
        QVERIFY(!dialog().adopt_button()->isEnabled());
    }

    void what_is_wrong_is_said() {
        study().open();
        ask();
        // What is typed.
        auto* tolerance = dialog().findChild<QLineEdit*>(QStringLiteral("study_values_tolerance"));
        type_over(tolerance, QStringLiteral("0.02; no"));
        QVERIFY(!dialog().start_button()->isEnabled() && !estimate().isEmpty());
        type_over(tolerance, QStringLiteral("0.02; 0.03"));
        QVERIFY(dialog().start_button()->isEnabled());
        { // A full disk, at once and in the middle.
            const FullDisk full(16);
            study().start();
            QVERIFY(settled());
            QVERIFY2(!study().look() && dialog().status().contains(QStringLiteral("job.study.json")),
                     qPrintable(dialog().status()));
        }
        // No Slurm.
        const QByteArray path = qgetenv("PATH");
        qputenv("PATH", "/nowhere");
        auto* place = dialog().findChild<QComboBox*>(QStringLiteral("study_place"));
        place->setCurrentIndex(1);
        study().start();
        QVERIFY(settled());
        qputenv("PATH", path);
        QVERIFY2(dialog().status().contains(QStringLiteral("Slurm is not here")),
                 qPrintable(dialog().status()));
        // A folder of another version: what lies in it is left alone.
        QFile request(folder_ + QStringLiteral("/job.study/request.json"));
        QVERIFY(request.open(QIODevice::ReadOnly));
        QByteArray content = request.readAll();
        request.close();
        content.replace("facetmill-cli", "facetmill-elder");
        QVERIFY(request.open(QIODevice::WriteOnly | QIODevice::Truncate));
        request.write(content);
        request.close();
        study().open_study(folder_ + QStringLiteral("/job.study"));
        QVERIFY(settled());
        QVERIFY2(dialog().status().contains(QStringLiteral("nother program works on this study")),
                 qPrintable(dialog().status()));
        QVERIFY(!study().look());
        // The program that works is not there.
        qputenv("FACETMILL_CLI", "/nowhere/facetmill-cli");
        study().open_study(folder_ + QStringLiteral("/job.study.json"));
        QVERIFY(settled());
        qputenv("FACETMILL_CLI", FACETMILL_CLI_PROGRAM);
        QVERIFY2(dialog().status().contains(QStringLiteral("is not here")), qPrintable(dialog().status()));
        // From its file it can be begun anew.
        study().open_study(folder_ + QStringLiteral("/job.study.json"));
        QVERIFY(settled());
        QVERIFY2(!study().look() && dialog().start_button()->isEnabled(), qPrintable(dialog().status()));
    }

    /// Pictures of any study, for who looks at them: FACETMILL_STUDY=FILE.
    void pictures_of_a_study() {
        const QString file = qEnvironmentVariable("FACETMILL_STUDY");
        if (file.isEmpty()) QSKIP("made where FACETMILL_STUDY names a study");
        study().open();
        study().open_study(file);
        QVERIFY(settled());
        if (dialog().start_button()->isEnabled()) {
            study().start();
            QVERIFY(QTest::qWaitFor([&] { return known_looks() > 0 || !study().running(); }, patience_ms));
            dialog().resize(1280, 800);
            shot(dialog(), QStringLiteral("study-sample-running"));
            QVERIFY(QTest::qWaitFor([&] { return !study().running(); }, 3600000));
        }
        QVERIFY(QTest::qWaitFor([&] { return !w().busy(); }, 600000));
        for (const bool dark : {false, true}) {
            w().set_theme(dark ? ui::Theme::dark : ui::Theme::light);
            for (const QSize size : {QSize(1280, 800), QSize(800, 600)}) {
                dialog().resize(size);
                for (int tab = 0; tab < dialog().pictures()->count(); ++tab) {
                    dialog().pictures()->setCurrentIndex(tab);
                    QVERIFY(QTest::qWaitFor([&] { return !w().busy(); }, patience_ms));
                    shot(dialog(), QStringLiteral("study-sample-%1-%2-%3")
                                       .arg(size.width())
                                       .arg(dark ? QStringLiteral("dark") : QStringLiteral("light"))
                                       .arg(tab));
                }
            }
        }
        w().set_theme(ui::Theme::system);
    }

    void help_is_its_page() {
        study().open();
        QVERIFY(activate(dialog()));
        QTest::keyClick(&dialog(), Qt::Key_F1);
        auto& help = *w().findChild<ui::Help*>();
        QVERIFY(help.window()
                && help.window()->browser()->topic().startsWith(QStringLiteral("studies.html")));
        help.window()->close();
    }

    void all_can_be_read_data() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"en", "de", "fr"})
            QTest::newRow(language) << QString::fromLatin1(language);
    }
    void all_can_be_read() {
        QFETCH(QString, language);
        if (language != QStringLiteral("en")) {
            ui::speak(language);
            close_window();
            QVERIFY(show_window());
            w().open_file(folder_ + QStringLiteral("/job.facetmill"));
            QVERIFY(settled());
        }
        run_study_here();
        QVERIFY(settled());
        QStringList cut;
        const auto look = [&](const QString& name) {
            QTest::qWait(30);
            shot(dialog(), QStringLiteral("study-%1-%2").arg(language, name));
            for (const QString& line : found_at_rest([&] { return cut_texts(dialog()); }))
                cut << name + QStringLiteral(": ") + line;
        };
        for (const bool dark : {false, true}) {
            w().set_theme(dark ? ui::Theme::dark : ui::Theme::light);
            for (const QSize size : {QSize(800, 600), QSize(1280, 800)}) {
                dialog().resize(size);
                const QString tag = QStringLiteral("%1-%2")
                                        .arg(size.width())
                                        .arg(dark ? QStringLiteral("dark") : QStringLiteral("light"));
                for (int tab = 0; tab < dialog().pictures()->count(); ++tab) {
                    dialog().pictures()->setCurrentIndex(tab);
                    dialog().sight()->tabs()->setCurrentIndex(tab == 1 ? 1 : 0);
                    look(tag + QStringLiteral("-%1").arg(tab));
                    QCOMPARE(dialog().size(), size);
                }
                dialog().pages()->setCurrentIndex(0);
                look(tag + QStringLiteral("-asked"));
                dialog().pages()->setCurrentIndex(1);
            }
        }
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(QChar('\n'))));
    }

private:
    struct Choice {
        std::string direction;
        double tolerance = 0;
    };
    /// A study is work for many processes: on a busy machine it takes its time.
    bool settled() {
        return QTest::qWaitFor([&] { return !w().busy(); }, patience_ms) && wait_until_settled(w());
    }
    ui::StudyController& study() { return w().controllers().study(); }
    ui::StudyDialog& dialog() { return *study().dialog(); }
    ui::StudyFigures figures() { return *dialog().front()->figures(); }
    QPushButton* button(const char* name) { return dialog().findChild<QPushButton*>(QLatin1String(name)); }
    QString estimate() { return dialog().findChild<QLabel*>(QStringLiteral("study_estimate"))->text(); }
    /// Two tolerances, two directions.
    void ask() {
        for (const auto& [name, values] :
             {std::pair("study_values_tolerance", "0.02; 0.03"), std::pair("study_values_direction", "x; y")})
            type_over(dialog().findChild<QLineEdit*>(QLatin1String(name)), QLatin1String(values));
    }
    /// The first one is worked on from its beginning; the others go on with what that has looked at: they
    /// have all but the decision.
    void run_study_here() {
        study().open();
        if (worked_on_.isEmpty()) {
            ask();
        } else {
            QVERIFY(copied(worked_on_, folder_));
            QVERIFY(QFile::remove(folder_ + QStringLiteral("/job.study/study.json")));
            study().open_study(folder_ + QStringLiteral("/job.study"));
            QVERIFY(settled());
        }
        study().start();
        QVERIFY(settled());
        if (worked_on_.isEmpty()) {
            const QString kept = scratch_folder(QStringLiteral("study-worked-on"));
            QVERIFY(copied(folder_, kept));
            worked_on_ = kept;
        }
        QVERIFY2(study().look() && study().look()->outcome.decision.winner, qPrintable(dialog().status()));
    }
    std::size_t known_looks() {
        std::size_t n = 0;
        if (study().look())
            for (const CandidateState& state : study().look()->outcome.states)
                for (const auto& look : state.rungs)
                    n += look ? 1 : 0;
        return n;
    }
    Choice chosen_of(std::size_t candidate) {
        const auto& chosen = figures().rows[candidate].chosen;
        Choice row;
        for (std::size_t v = 0; v < chosen.size(); ++v) {
            const QString label = figures().choices[v][qsizetype(chosen[v])];
            bool number = false;
            const double value = label.toDouble(&number);
            if (number)
                row.tolerance = value;
            else
                row.direction = label.toStdString();
        }
        return row;
    }

    /// A click in each picture and in the table, and the arrow keys, choose one in all of them.
    void click_through_the_pictures() {
        const auto agreed = [&](std::size_t candidate) {
            return dialog().chosen() == candidate && dialog().front()->chosen() == candidate
                   && dialog().stages()->chosen() == candidate && dialog().parallel()->chosen() == candidate
                   && dialog().table()->currentIndex().siblingAtColumn(0).data().toInt() == int(candidate);
        };
        const std::initializer_list<ui::StudyChart*> charts = {dialog().front(), dialog().stages(),
                                                               dialog().parallel()};
        int tab = 0;
        for (ui::StudyChart* chart : charts) {
            dialog().pictures()->setCurrentIndex(tab++);
            QTest::qWait(20);
            int clicked = 0;
            for (std::size_t i = 1; i < figures().rows.size(); ++i) {
                const auto at = chart->place_of(i);
                if (!at) continue;
                QTest::mouseClick(chart, Qt::LeftButton, {}, at->toPoint());
                // Where two lie on each other the one below cannot be met.
                if (dialog().chosen() == i) ++clicked;
                QVERIFY(dialog().chosen() && agreed(*dialog().chosen()));
            }
            QVERIFY(clicked > 0);
            const auto before = dialog().chosen();
            QTest::keyClick(chart, Qt::Key_Left);
            QTest::keyClick(chart, Qt::Key_Left);
            QTest::keyClick(chart, Qt::Key_Right);
            QVERIFY(dialog().chosen() && agreed(*dialog().chosen()));
            QTest::keyClick(chart, Qt::Key_Right);
            QVERIFY(before.has_value());
        }
        auto* table = dialog().table();
        table->sortByColumn(0, Qt::DescendingOrder);
        QCOMPARE(table->listed(), (std::vector<std::size_t>{4, 3, 2, 1, 0}));
        table->sortByColumn(0, Qt::AscendingOrder);
        const QRect row = table->visualRect(table->model()->index(3, 0));
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, row.center());
        QVERIFY(agreed(3));
        QTest::keyClick(table, Qt::Key_Up);
        QVERIFY(agreed(2));
    }

    /// A range of the first axis, which has two values: half of the candidates stay.
    void range_keeps_candidates() {
        auto* chart = dialog().parallel();
        dialog().pictures()->setCurrentIndex(2);
        QTest::qWait(20);
        const QPoint from = chart->axis_place(0, 0.02).toPoint(), to = chart->axis_place(0, 0.45).toPoint();
        QTest::mousePress(chart, Qt::LeftButton, {}, from);
        QTest::mouseMove(chart, (from + to) / 2);
        QTest::mouseMove(chart, to);
        QTest::mouseRelease(chart, Qt::LeftButton, {}, to);
        QCOMPARE(dialog().table()->listed().size(), std::size_t(2));
        shot(dialog(), QStringLiteral("study-range"));
        QTest::mouseClick(chart, Qt::LeftButton, {}, chart->axis_place(0, 0.7).toPoint());
        QCOMPARE(dialog().table()->listed().size(), std::size_t(5));
    }

    /// The study, not the project that it is of.
    static bool copied(const QString& from, const QString& to) {
        constexpr auto all =
            std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing;
        std::error_code failed;
        for (const char* name : {"/job.study", "/job.study.json"})
            if (!failed)
                std::filesystem::copy((from + QLatin1String(name)).toStdString(),
                                      (to + QLatin1String(name)).toStdString(), all, failed);
        return !failed;
    }

    QString folder_, worked_on_;
};

FACETMILL_TEST(TestWindowStudy)
#include "test_window_study.moc"
