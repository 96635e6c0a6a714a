// Writes what the workbench writes, by the window's own functions, for tests/faults/attack_files, which kills
// it meanwhile, fills the disk or takes away the right to write.
//
//     workbench_writer save|packed|programs|sheet|picture|chart|values TARGET [--user NUMBER] PROJECT ...
//     workbench_writer autosave TARGET PROJECT
//     workbench_writer restore TARGET
//
// One project after the other is opened, planned and verified as the output needs it, and written to the same
// target. Says "writing" before every output, "written" after it. --user: has from then on no more rights
// than that user. Ends with 1, and says why, at the first output that cannot be written.
//
// autosave: saves the project as the target, changes it again and again, to larger and larger ones, and has
// it kept; says the number of the change each time. Ends with 1, as if it were killed, when it cannot be
// kept. restore: writes what such a run left to the target, and says how many projects that were.
//
// What is kept without a project lies in a folder of the run's own, or in XDG_DATA_HOME where TARGET is that
// of autosave or restore.
#include "core/base/file.h"
#include "ui/autosave.h"
#include "ui/document.h"
#include "ui/inspection_controller.h"
#include "ui/inspection_panel.h"
#include "ui/kept_work.h"
#include "ui/main_window.h"
#include "ui/message_bar.h"
#include "ui/program_export.h"
#include "ui/project_files.h"
#include "ui/text.h"
#include "ui/viewport.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QTemporaryDir>
#include <QThread>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <unistd.h>

using namespace facetmill;

namespace {

/// Ends of jobs start others: idle must hold for a few turns of the event loop.
void wait_until_settled(ui::MainWindow& window) {
    for (int idle = 0; idle < 3; idle = window.busy() ? 0 : idle + 1) {
        QApplication::processEvents();
        QThread::msleep(2);
    }
}

void say(const char* word) {
    std::puts(word);
    std::fflush(stdout);
}

/// The chart of the last operation.
void show_chart(ui::MainWindow& window) {
    ui::InspectionPanel* panel = window.inspection().panel();
    if (!panel->isVisible())
        window.findChild<QDockWidget*>(QStringLiteral("chart_dock"))->toggleViewAction()->trigger();
    panel->operation_box()->setCurrentIndex(panel->operation_box()->count() - 1);
    wait_until_settled(window);
}

/// What went wrong, empty where nothing did.
QString write(ui::MainWindow& window, const QString& what, const QString& target) {
    bool done = true;
    if (what == QLatin1String("save"))
        done = window.files().save_to(target);
    else if (what == QLatin1String("packed"))
        window.files().save_packed_to(target);
    else if (what == QLatin1String("programs"))
        window.exports().save_programs(target);
    else if (what == QLatin1String("sheet"))
        window.exports().save_sheet(target);
    else if (what == QLatin1String("picture"))
        window.exports().save_picture(target);
    else if (what == QLatin1String("chart"))
        window.inspection().save_picture(target);
    else if (what == QLatin1String("values"))
        window.inspection().save_table(target);
    else
        return QStringLiteral("there is no output ") + what;
    wait_until_settled(window);
    return done || !window.last_failure().isEmpty() ? window.last_failure() : QStringLiteral("not written");
}

QString run(const QStringList& words) {
    ui::MainWindow window;
    window.show();
    int user = 0;
    for (qsizetype k = 2; k < words.size(); ++k) {
        if (words[k] == QLatin1String("--user")) {
            user = words.value(++k).toInt();
            continue;
        }
        window.resize(600 + 40 * int(k), 480); // every picture is another one
        window.open_file(words[k]);
        wait_until_settled(window);
        if (words[0] != QLatin1String("save") && words[0] != QLatin1String("packed")) window.plan();
        wait_until_settled(window);
        if (words[0] == QLatin1String("sheet")) window.verify();
        wait_until_settled(window);
        if (words[0] == QLatin1String("chart") || words[0] == QLatin1String("values")) show_chart(window);
        if (!window.last_failure().isEmpty()) return window.last_failure();
        // The view was turned to the part at whatever size the window had by then.
        window.viewport().fit();
        wait_until_settled(window);
        if (user > 0 && (setgid(gid_t(user)) != 0 || setuid(uid_t(user)) != 0))
            return QStringLiteral("cannot become another user");
        say("writing");
        if (const QString wrong = write(window, words[0], words[1]); !wrong.isEmpty()) return wrong;
        say("written");
    }
    return {};
}

/// Ends the program itself: a window that ends in order would take what it has kept along.
[[noreturn]] void keep_for_ever(const QStringList& words) {
    ui::MainWindow window;
    window.show();
    window.open_file(words[2]);
    wait_until_settled(window);
    if (!window.files().save_to(words[1])) std::_Exit(2);
    say("writing");
    for (int change = 1;; ++change) {
        window.document().change(QStringLiteral("Edit"), [change](Project& p) {
            p.operations[0]->common().feed = change;
            Tool tool = p.tools[0];
            tool.number = change + 1000;
            p.tools.push_back(tool);
        });
        window.files().autosave().keep();
        window.files().autosave().finish();
        if (window.message_bar().message().contains(QStringLiteral("cannot be kept"))) std::_Exit(1);
        say(std::to_string(change).c_str());
    }
}

QString restore(const QString& target) {
    const auto left = ui::KeptWork::abandoned();
    say(std::to_string(left.size()).c_str());
    try {
        for (const auto& work : left) {
            OutputFile file(ui::path_of(target));
            file.write(project_to_json(work->read()));
            file.commit();
            work->remove();
        }
    } catch (const Error& e) {
        return ui::text(e.what());
    }
    return {};
}

} // namespace

int main(int argc, char** argv) {
    const QTemporaryDir home;
    qputenv("XDG_CONFIG_HOME", (home.path() + QStringLiteral("/config")).toUtf8());
    qputenv("XDG_CACHE_HOME", (home.path() + QStringLiteral("/cache")).toUtf8());
    const QByteArray task(argc > 1 ? argv[1] : "");
    const bool outlives = task == "autosave" || task == "restore";
    if (!outlives) qputenv("XDG_DATA_HOME", (home.path() + QStringLiteral("/data")).toUtf8());
    ui::Viewport::set_default_format();
    QApplication::setOrganizationName(QStringLiteral("FacetmillTest"));
    QApplication::setApplicationName(QStringLiteral("facetmill-writer"));
    const QApplication app(argc, argv);
    const QStringList words = QApplication::arguments().mid(1);
    if (task == "autosave") keep_for_ever(words);
    const QString wrong = task == "restore" ? restore(words[1]) : run(words);
    if (wrong.isEmpty()) return 0;
    std::fprintf(stderr, "%s\n", qPrintable(wrong));
    return 1;
}
