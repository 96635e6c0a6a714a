// Outputs under attack: killed at every step, on full disks, over what must stay.
#include "core/base/file.h"
#include "core/base/file_lock.h"
#include "core/base/leftovers.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <map>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace facetmill;
using test::code_of;

namespace {

namespace fs = std::filesystem;

/// Calls that change what is on disk until the process kills itself; 0: it does not.
int steps_to_live = 0;

void step() {
    if (steps_to_live > 0 && --steps_to_live == 0) ::kill(::getpid(), SIGKILL);
}

template <class F>
F* original(const char* name) {
    return reinterpret_cast<F*>(::dlsym(RTLD_NEXT, name));
}

} // namespace

// In place of the C library's, which they call: this program is looked at first.
extern "C" {
int rename(const char* from, const char* to) noexcept {
    step();
    return original<int(const char*, const char*)>("rename")(from, to);
}
int link(const char* from, const char* to) noexcept {
    step();
    return original<int(const char*, const char*)>("link")(from, to);
}
int remove(const char* path) noexcept {
    step();
    return original<int(const char*)>("remove")(path);
}
int fsync(int fd) {
    step();
    return original<int(int)>("fsync")(fd);
}
}

namespace {

/// What stands in a folder: names and texts.
std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.is_directory()) continue;
        std::ifstream in(entry.path());
        all[entry.path().filename().string()] = std::string(std::istreambuf_iterator<char>(in), {});
    }
    return all;
}

void put(const fs::path& path, const std::string& text) {
    std::ofstream(path) << text;
}

mode_t mode_of(const fs::path& path) {
    struct ::stat info {};
    return ::stat(path.c_str(), &info) == 0 ? info.st_mode & 0777 : 0;
}

/// Runs `job` in a process of its own that kills itself before the given step; true when it came to its end.
bool ends(int step, const std::function<void()>& job) {
    const pid_t child = ::fork();
    if (child == 0) {
        steps_to_live = step;
        job();
        ::_exit(0);
    }
    int status = 0;
    return ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// What the next run in the folder does first.
void next_run(const fs::path& folder) {
    const OutputFile any(folder / "any");
}

} // namespace

class TestFiles : public QObject {
    Q_OBJECT
private slots:

    void a_set_killed_at_any_step_is_whole() {
        const auto write_all = [](const fs::path& folder) {
            OutputSet set;
            for (const char* name : {"a", "b", "new", "z"})
                set.add(folder / name).write("after");
            set.commit();
        };
        const std::map<std::string, std::string> before = {{"a", "before"}, {"b", "before"}, {"z", "before"}};
        std::map<std::string, std::string> after = before;
        after["new"];
        for (auto& [name, text] : after)
            text = "after";
        int old_ones = 0, step = 1;
        for (bool over = false; !over; ++step) {
            QVERIFY(step < 1000);
            QTemporaryDir dir;
            const fs::path folder = dir.path().toStdString();
            for (const auto& [name, text] : before)
                put(folder / name, text);
            over = ends(step, [&] { write_all(folder); });
            next_run(folder);
            const auto found = contents(folder);
            QVERIFY2(found == before || found == after,
                     qPrintable(QString("killed before step %1").arg(step)));
            old_ones += found == before;
        }
        QVERIFY(old_ones > 8 && step - old_ones > 3); // both were seen
    }

    void what_a_user_wrote_since_is_not_put_back() {
        QTemporaryDir dir;
        const fs::path folder = dir.path().toStdString();
        put(folder / "a", "before");
        put(folder / "b", "before");
        // Far enough that both second names are there.
        for (int step = 1; fs::exists(folder / "a") && contents(folder)["a"] == "before"; ++step) {
            QVERIFY(step < 100);
            ends(step, [&] {
                OutputSet set;
                set.add(folder / "a").write("after");
                set.add(folder / "b").write("after");
                set.commit();
            });
        }
        put(folder / "mine", "mine");
        fs::rename(folder / "mine", folder / "a");
        next_run(folder);
        QCOMPARE(contents(folder), (std::map<std::string, std::string>{{"a", "mine"}, {"b", "before"}}));
    }

    void what_a_killed_run_left_goes() {
        QTemporaryDir dir;
        const fs::path folder = dir.path().toStdString();
        put(folder / "old", "before");
        put(folder / ".facetmill.json", "mine"); // no name of ours
        put(folder / ".facetmill.abcdef.before", "left");
        QVERIFY(!ends(0, [&] {
            OutputFile half(folder / "old");
            half.write("half");
            ::kill(::getpid(), SIGKILL);
        }));
        QCOMPARE(contents(folder).size(), std::size_t(3));
        OutputFile at_work(folder / "x");
        at_work.write("1");
        next_run(folder); // takes nothing from those that are at work
        at_work.commit();
        QCOMPARE(contents(folder), (std::map<std::string, std::string>{
                                       {"old", "before"}, {".facetmill.json", "mine"}, {"x", "1"}}));
    }

    void a_record_of_elsewhere_moves_nothing() {
        QTemporaryDir dir;
        const fs::path folder = dir.path().toStdString();
        fs::create_directories(folder / "in");
        put(folder / "mine", "mine");
        struct ::stat info {};
        QCOMPARE(::stat((folder / "mine").c_str(), &info), 0);
        std::string record("facetmill set 1\0../mine\0\0", 26);
        record += std::to_string(info.st_ino) + std::string("\0end\0", 5);
        put(folder / "in" / ".facetmill.abcdef.set", record);
        next_run(folder / "in");
        QCOMPARE(contents(folder)["mine"], std::string("mine"));
        QVERIFY(fs::is_empty(folder / "in"));
        for (const char* name : {".", "..", "a/b"})
            QVERIFY(detail::read_set_record(detail::set_record({{name, "", info.st_ino}})).empty());
        QCOMPARE(detail::read_set_record(detail::set_record({{"..a", "", 7}})).size(), std::size_t(1));
    }

    void permissions_stay() {
        QTemporaryDir dir;
        const fs::path folder = dir.path().toStdString();
        const auto write = [&](const char* name) {
            OutputFile file(folder / name);
            file.write("1");
            file.commit();
            return int(mode_of(folder / name));
        };
        put(folder / "secret", "0");
        for (const int mode : {0600, 0640, 0755}) {
            QCOMPARE(::chmod((folder / "secret").c_str(), mode_t(mode)), 0);
            QCOMPARE(write("secret"), mode);
        }
        const mode_t usual = ::umask(077);
        const int closed = write("closed");
        ::umask(027);
        const int half = write("half");
        ::umask(usual);
        QCOMPARE(closed, 0600);
        QCOMPARE(half, 0640);
    }

    void a_link_to_nothing_is_followed() {
        QTemporaryDir dir;
        const fs::path folder = dir.path().toStdString();
        fs::create_directories(folder / "far");
        fs::create_symlink("far/real", folder / "link");
        fs::create_symlink("link", folder / "chain");
        OutputFile file(folder / "chain");
        file.write("1");
        file.commit();
        QVERIFY(fs::is_symlink(folder / "chain") && fs::is_symlink(folder / "link"));
        QCOMPARE(contents(folder / "far"), (std::map<std::string, std::string>{{"real", "1"}}));
        fs::create_symlink("ring", folder / "ring");
        QCOMPARE(code_of([&] { OutputFile f(folder / "ring"); }), std::string("unwritable"));
    }

    void a_full_disk_leaves_what_was() {
        QTemporaryDir dir;
        const fs::path folder = dir.path().toStdString();
        put(folder / "a", "before");
        const auto before = contents(folder);
        constexpr std::size_t all = 40'000;
        for (const std::size_t room : {std::size_t(0), std::size_t(1), std::size_t(4096), all - 1}) {
            const bool told = ends(0, [&] {
                std::signal(SIGXFSZ, SIG_IGN);
                const ::rlimit limit{room, room};
                ::setrlimit(RLIMIT_FSIZE, &limit);
                const std::string code = code_of([&] {
                    OutputSet set;
                    set.add(folder / "new").write(std::string(all, 'x'));
                    set.add(folder / "a").write(std::string(all, 'x'));
                    set.commit();
                });
                ::_exit(code == "unwritable" ? 0 : 1);
            });
            QVERIFY(told);
            QCOMPARE(contents(folder), before);
        }
    }

    void a_result_that_nobody_was_told_leaves_nothing() {
        QTemporaryDir dir;
        const fs::path folder = dir.path().toStdString();
        put(folder / "a", "before");
        const auto before = contents(folder);
        for (const int files : {1, 2}) {
            OutputSet set;
            set.add(folder / "a").write("after");
            if (files > 1) set.add(folder / "b").write("after");
            QCOMPARE(code_of([&] {
                         set.commit(
                             [] { throw Error(ErrorCode::unwritable, "stdout", "is full", "empty it"); });
                     }),
                     std::string("unwritable"));
        }
        QCOMPARE(contents(folder), before);
    }

    void what_a_job_reads_stays() {
        QTemporaryDir dir;
        const fs::path folder = dir.path().toStdString();
        put(folder / "in", "before");
        fs::create_hard_link(folder / "in", folder / "second");
        fs::create_symlink("in", folder / "link");
        {
            const InputsKept kept;
            OutputFile early(folder / "in"); // before it is known to be an input
            early.write("after");
            QCOMPARE(std::string(InputFile(folder / "in").bytes()), std::string("before"));
            QCOMPARE(code_of([&] { early.commit(); }), std::string("unwritable"));
            for (const char* name : {"in", "second", "link", "./in"})
                QCOMPARE(code_of([&] { OutputFile f(folder / name); }), std::string("unwritable"));
        }
        QCOMPARE(contents(folder)["in"], std::string("before"));
        OutputFile after(folder / "in"); // a workbench saves what it has opened
        after.commit();
    }

    void locks_go_with_their_process() {
        QTemporaryDir dir;
        const fs::path path = dir.path().toStdString() + "/a";
        using detail::FileLock;
        QVERIFY(!FileLock(path)); // there is none
        QVERIFY(!fs::exists(path));
        FileLock first(path, FileLock::Open::or_make);
        QVERIFY(bool(first));
        QVERIFY(!FileLock(path) && !FileLock(path, FileLock::Open::or_make));
        FileLock moved = std::move(first);
        QVERIFY(!first && moved && !FileLock(path));
        moved.unlock();
        QVERIFY(bool(FileLock(path)));
        // Another process holds it, and is killed.
        int ready[2];
        QVERIFY(::pipe(ready) == 0);
        const pid_t child = ::fork();
        if (child == 0) {
            const FileLock theirs(path);
            const char locked = theirs ? 'y' : 'n';
            if (::write(ready[1], &locked, 1) == 1) ::pause();
            ::_exit(1);
        }
        char locked = 0;
        QVERIFY(::read(ready[0], &locked, 1) == 1);
        QCOMPARE(locked, 'y');
        QVERIFY(!FileLock(path));
        ::kill(child, SIGKILL);
        QCOMPARE(::waitpid(child, nullptr, 0), child);
        QVERIFY(bool(FileLock(path)));
        ::close(ready[0]);
        ::close(ready[1]);
        // Through a link it would be somebody else's file.
        fs::create_symlink("a", dir.path().toStdString() + "/link");
        QVERIFY(!FileLock(dir.path().toStdString() + "/link"));
        QVERIFY(!FileLock(dir.path().toStdString())); // a folder
    }
};

FACETMILL_TEST(TestFiles)
#include "test_files.moc"
