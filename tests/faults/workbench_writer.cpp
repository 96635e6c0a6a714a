// Writes what the workbench writes, by the window's own functions, for tests/faults/attack_files, which kills
// it meanwhile, fills the disk or takes away the right to write.
//
//     workbench_writer save|programs|sheet|picture TARGET [--user NUMBER] PROJECT ...
//
// One project after the other is opened, planned and verified as the output needs it, and written to the same
// target. Says "writing" before every output, "written" after it. --user: has from then on no more rights
// than that user. Ends with 1, and says why, at the first output that cannot be written.
#include "ui/document.h"
#include "ui/main_window.h"
#include "ui/program_export.h"
#include "ui/project_files.h"
#include "ui/viewport.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QThread>

#include <cstdio>
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

/// What went wrong, empty where nothing did.
QString write(ui::MainWindow& window, const QString& what, const QString& target) {
    bool done = true;
    if (what == QLatin1String("save"))
        done = window.files().save_to(target);
    else if (what == QLatin1String("programs"))
        window.exports().save_programs(target);
    else if (what == QLatin1String("sheet"))
        window.exports().save_sheet(target);
    else if (what == QLatin1String("picture"))
        done = window.exports().save_picture(target);
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
        if (words[0] != QLatin1String("save")) window.plan();
        wait_until_settled(window);
        if (words[0] == QLatin1String("sheet")) window.verify();
        wait_until_settled(window);
        if (!window.last_failure().isEmpty()) return window.last_failure();
        if (user > 0 && (setgid(gid_t(user)) != 0 || setuid(uid_t(user)) != 0))
            return QStringLiteral("cannot become another user");
        say("writing");
        if (const QString wrong = write(window, words[0], words[1]); !wrong.isEmpty()) return wrong;
        say("written");
    }
    return {};
}

} // namespace

int main(int argc, char** argv) {
    const QTemporaryDir home;
    qputenv("XDG_CONFIG_HOME", (home.path() + QStringLiteral("/config")).toUtf8());
    qputenv("XDG_CACHE_HOME", (home.path() + QStringLiteral("/cache")).toUtf8());
    ui::Viewport::set_default_format();
    QApplication::setOrganizationName(QStringLiteral("FacetmillTest"));
    QApplication::setApplicationName(QStringLiteral("facetmill-writer"));
    const QApplication app(argc, argv);
    const QString wrong = run(QApplication::arguments().mid(1));
    if (wrong.isEmpty()) return 0;
    std::fprintf(stderr, "%s\n", qPrintable(wrong));
    return 1;
}
