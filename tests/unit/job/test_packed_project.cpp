// Packed projects: what is packed comes back whole, and what does not hold together is refused by its name.
#include "core/base/archive.h"
#include "core/job/packed_project.h"
#include "core/job/project_inputs.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

#include <sys/stat.h>
#include <unistd.h>

using namespace facetmill;
using test::code_of;
namespace fs = std::filesystem;

namespace {

const char* const travelled = R"({ "facetmill": 2, "units": "mm", "part": { "file": "meshes/part.stl" },
  "tools": [ { "number": 1, "diameter": 6 } ],
  "setups": [
    { "name": "Top", "stock": { "kind": "mesh", "file": "ABOVE/raw/part.stl" }, "machine": "own.json",
      "post": "posts/own.json",
      "fixtures": [ { "name": "Jaw", "kind": "mesh", "file": "top/jaw.stl" },
                    { "name": "Other jaw", "kind": "mesh", "file": "top/jaw.stl" } ],
      "operations": [ { "kind": "finish3", "name": "Finish", "tool": 1 } ] },
    { "name": "Bottom", "machine": "own.json",
      "fixtures": [ { "name": "Jaw", "kind": "mesh", "file": "bottom/Jaw.stl" },
                    { "name": "Block", "kind": "box" } ],
      "operations": [ { "kind": "finish3", "name": "Below", "tool": 1 } ] } ] })";

void lay(const fs::path& file, const std::string& bytes) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << bytes;
}

std::string bytes_at(const fs::path& file) {
    return std::string(InputFile(file).bytes());
}

/// A project of two setups whose files lie in many folders, one of them above it.
struct Travelled {
    Travelled() {
        const std::string machine =
            bytes_at(FACETMILL_TEST_DATA "/../resources/machines/generic-3-axis.json");
        const std::string post = bytes_at(FACETMILL_TEST_DATA "/../resources/posts/grbl.json");
        lay(root / "job/meshes/part.stl", "the part");
        lay(root / "raw/part.stl", std::string(300'000, 's'));
        lay(root / "job/top/jaw.stl", "a jaw");
        lay(root / "job/bottom/Jaw.stl", "another jaw");
        lay(root / "job/own.json", machine);
        lay(root / "job/posts/own.json", post);
        std::string text = travelled;
        text.replace(text.find("ABOVE"), 5, "..");
        lay(file, text);
    }

    void repack(const std::string& name, const std::string& from, const std::string& to) const {
        std::vector<ArchiveFile> files = read_archive(bytes_at(packed), "it");
        for (ArchiveFile& f : files)
            if (const std::size_t at = f.bytes.find(from); f.name == name && at != std::string::npos)
                f.bytes.replace(at, from.size(), to);
        lay(packed, archive_bytes(files));
    }
    void pack() const { pack_project(load_project(file), "job", packed); }

    QTemporaryDir dir;
    fs::path root = fs::path(dir.path().toStdString()), file = root / "job/job.facetmill",
             packed = root / "sent.facetmill";
};

/// What is in a folder for temporary files that only this test uses.
class OwnTemporaries {
public:
    OwnTemporaries() { qputenv("TMPDIR", dir_.path().toUtf8()); }
    ~OwnTemporaries() {
        if (before_.isEmpty())
            qunsetenv("TMPDIR");
        else
            qputenv("TMPDIR", before_);
    }
    std::size_t count() const {
        return std::size_t(std::distance(fs::directory_iterator(dir_.path().toStdString()), {}));
    }
    fs::path path() const { return dir_.path().toStdString(); }

private:
    QByteArray before_ = qgetenv("TMPDIR");
    QTemporaryDir dir_;
};

/// Every file that a project names, by bytes, in order.
std::vector<std::string> contents(const Project& project) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < setup_count(project); ++i)
        for (const ProjectInput& input : project_inputs(view_of_setup(project, i)))
            all.push_back(bytes_at(input.path));
    return all;
}

} // namespace

class TestPackedProject : public QObject {
    Q_OBJECT
private slots:

    void all_files_of_all_setups_are_packed_once() {
        const Travelled t;
        const auto files = pack_project(load_project(t.file), "job", t.packed);
        std::vector<std::string> names;
        for (const PackedFile& f : files)
            names.push_back(f.name);
        QCOMPARE(names, (std::vector<std::string>{"job.facetmill", "files/part.stl", "files/part-2.stl",
                                                  "files/jaw.stl", "files/own.json", "files/own-2.json",
                                                  "files/Jaw-2.stl"}));
        QCOMPARE(files[2].bytes, std::uint64_t(300'000));
        QVERIFY(fs::file_size(t.packed) < 100'000);
        const std::string once = bytes_at(t.packed);
        t.pack();
        QVERIFY(bytes_at(t.packed) == once);
    }

    void a_packed_project_is_read_as_it_was() {
        const Travelled t;
        const OwnTemporaries temporaries;
        Project original = load_project(t.file);
        t.pack();
        fs::path inside;
        {
            Project copy;
            {
                const Project read = load_project(t.packed);
                copy = view_of_setup(read, 1);
                inside = copy.path;
            }
            QCOMPARE(temporaries.count(), std::size_t(1));
            QVERIFY(contents(copy) == contents(original));
            // But for names of files they say the same.
            take_inputs(copy, original);
            QCOMPARE(project_to_json(copy), project_to_json(original));
            // Users never see where it is.
            QCOMPARE(printable(inside.string(), 400), printable(t.packed.string(), 400) + ": job.facetmill");
        }
        QVERIFY(!fs::exists(inside));
        QCOMPARE(temporaries.count(), std::size_t(0));
        // Packed again from there it is the same file.
        pack_project(load_project(t.packed), "job", t.root / "again.facetmill");
        QVERIFY(bytes_at(t.root / "again.facetmill") == bytes_at(t.packed));
    }

    void what_is_unpacked_is_what_was_packed() {
        const Travelled t;
        t.pack();
        const auto files = unpack_project(t.packed, t.root / "deep/er");
        QCOMPARE(files.front().path, t.root / "deep/er/job.facetmill");
        QCOMPARE(files.size(), std::size_t(7));
        const Project back = load_project(files.front().path);
        QVERIFY(!back.unpacked);
        QVERIFY(contents(back) == contents(load_project(t.file)));
        // What is missing of it comes back, and the rest stays as it is.
        const auto written = fs::last_write_time(files.front().path);
        fs::remove(t.root / "deep/er/files/part.stl");
        QCOMPARE(unpack_project(t.packed, t.root / "deep/er").size(), std::size_t(7));
        QVERIFY(contents(load_project(files.front().path)) == contents(back));
        QVERIFY(fs::last_write_time(files.front().path) == written);
        QCOMPARE(unpack_project(t.packed, t.root / "deep/er").size(), std::size_t(7));
        // Never over another file, and nothing is begun then.
        fs::remove(t.root / "deep/er/files/part.stl");
        std::ofstream(files.front().path, std::ios::app) << ' ';
        std::string message;
        QCOMPARE(code_of([&] { unpack_project(t.packed, t.root / "deep/er"); }, &message),
                 std::string("unwritable"));
        QVERIFY(message.find("is there already") != std::string::npos);
        QVERIFY(!fs::exists(t.root / "deep/er/files/part.stl"));
    }

    void what_is_missing_is_named() {
        const Travelled t;
        fs::remove(t.root / "job/bottom/Jaw.stl");
        std::string message;
        QCOMPARE(code_of([&] { t.pack(); }, &message), std::string("not_found"));
        QVERIFY2(message.find("bottom/Jaw.stl") != std::string::npos, message.c_str());
        QVERIFY(!fs::exists(t.packed));
    }

    void inputs_are_never_replaced() {
        const Travelled t;
        const Project project = load_project(t.file);
        for (const fs::path& output : {t.file, t.root / "job/bottom/Jaw.stl", t.root / "raw/part.stl"}) {
            const std::string before = bytes_at(output);
            QCOMPARE(code_of([&] { pack_project(project, "job", output); }), std::string("unwritable"));
            QVERIFY(bytes_at(output) == before);
        }
    }

    void cancelled_jobs_leave_nothing() {
        const Travelled t;
        t.pack();
        for (const double at : {0.0, 0.4, 0.9}) {
            Job job, other;
            job.cancel_at(at);
            QCOMPARE(code_of([&] {
                         pack_project(load_project(t.file), "job", t.root / "none.facetmill", Progress(job));
                     }),
                     std::string("cancelled"));
            QVERIFY(!fs::exists(t.root / "none.facetmill"));
            other.cancel_at(at);
            QCOMPARE(code_of([&] { unpack_project(t.packed, t.root / "none", Progress(other)); }),
                     std::string("cancelled"));
            QVERIFY(!fs::exists(t.root / "none"));
        }
    }

    void what_does_not_hold_together_is_refused_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("told");
        const auto row = [](const char* name, const char* from, const char* to, const char* code,
                            const char* told) { QTest::newRow(name) << from << to << code << told; };
        row("absolute", "files/jaw.stl", "/etc/passwd", "missing_reference", "fixtures[0].file");
        row("above", "files/part.stl", "files/../../p.stl", "missing_reference", "part.file");
        row("elsewhere", "files/Jaw-2.stl", "files/Jaw-3.stl", "missing_reference",
            "fixtures[0].file: 'files/Jaw-3.stl' is not in the packed file");
        row("machine", "files/own.json", "/own.json", "missing_reference", "machine");
        row("no project", "{", "[", "syntax", "sent.facetmill: job.facetmill");
        row("a wrong value", "\"units\": \"mm\"", "\"units\": \"ell\"", "",
            "sent.facetmill: job.facetmill: ");
    }
    void what_does_not_hold_together_is_refused() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, code);
        QFETCH(QString, told);
        const Travelled t;
        const OwnTemporaries temporaries;
        t.pack();
        t.repack("job.facetmill", from.toStdString(), to.toStdString());
        std::string message, other;
        const std::string what = code_of([&] { load_project(t.packed); }, &message);
        QVERIFY(code.isEmpty() ? what != "none" : what == code.toStdString());
        QVERIFY2(message.starts_with(t.packed.string() + ": job.facetmill"), message.c_str());
        QVERIFY2(message.find(told.toStdString()) != std::string::npos, message.c_str());
        QCOMPARE(code_of([&] { unpack_project(t.packed, t.root / "none"); }, &other), what);
        QCOMPARE(other, message);
        QVERIFY(!fs::exists(t.root / "none"));
        QCOMPARE(temporaries.count(), std::size_t(0));
    }

    void archives_of_other_things_are_refused() {
        const Travelled t;
        lay(t.packed, archive_bytes({{"a.stl", "x"}}));
        QCOMPARE(code_of([&] { load_project(t.packed); }), std::string("missing_key"));
        lay(t.packed, archive_bytes({{"a.facetmill", "{}"}, {"b.FACETMILL", "{}"}}));
        QCOMPARE(code_of([&] { load_project(t.packed); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] { unpack_project(t.file, t.root / "none"); }),
                 std::string("unsupported_format"));
    }

    /// What somebody zipped by hand, the folder with it.
    void a_project_in_a_folder_is_read() {
        const Travelled t;
        lay(t.packed,
            archive_bytes({{"job/a.facetmill", R"({"facetmill":1,"units":"mm","part":{"file":"m/a.stl"}})"},
                           {"job/m/a.stl", "mesh"},
                           {"job/readme.txt", "hello"}}));
        const Project project = load_project(t.packed);
        QCOMPARE(bytes_at(project.part_path()), std::string("mesh"));
    }

    /// What a run that was killed left goes with the next; what a run still uses stays.
    void folders_of_killed_runs_go() {
        const Travelled t;
        const OwnTemporaries temporaries;
        t.pack();
        const Project used = load_project(t.packed);
        lay(temporaries.path() / "facetmill-packed.abcdef/files/a.stl", "left");
        lay(temporaries.path() / "facetmill-other/a.stl", "not ours");
        QCOMPARE(temporaries.count(), std::size_t(3));
        const Project next = load_project(t.packed);
        QVERIFY(!fs::exists(temporaries.path() / "facetmill-packed.abcdef"));
        QVERIFY(fs::exists(temporaries.path() / "facetmill-other"));
        QVERIFY(fs::exists(used.part_path()) && fs::exists(next.part_path()));
        struct ::stat info {};
        QVERIFY(::stat(next.path.parent_path().c_str(), &info) == 0);
        QCOMPARE(info.st_mode & 0777, mode_t(0700));
    }
};

FACETMILL_TEST(TestPackedProject)
#include "test_packed_project.moc"
