// Archives: what is packed comes back, and nothing that leads elsewhere is taken.
#include "core/base/archive.h"
#include "core/base/error.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;
using test::code_of;

namespace {

std::string zeros(std::size_t n) {
    return std::string(n, '\0');
}

/// An archive of `from` in which one name of the same length stands for another, in both places of the
/// format.
std::string renamed(std::string bytes, const std::string& from, const std::string& to) {
    for (std::size_t at = bytes.find(from); at != std::string::npos; at = bytes.find(from, at + 1))
        bytes.replace(at, from.size(), to);
    return bytes;
}

} // namespace

class TestArchive : public QObject {
    Q_OBJECT
private slots:

    void what_is_packed_comes_back() {
        const std::vector<ArchiveFile> files = {
            {"job.json", "{}"}, {"files/a.stl", zeros(3'000'000) + "end"}, {"files/\u00fc.stl", ""}};
        const std::string bytes = archive_bytes(files);
        QVERIFY(is_archive(bytes) && !is_archive("{}"));
        QVERIFY(bytes.size() < 100'000);
        QCOMPARE(archive_bytes(files), bytes);
        const auto back = read_archive(bytes, "it");
        QCOMPARE(back.size(), files.size());
        for (std::size_t i = 0; i < files.size(); ++i) {
            QCOMPARE(back[i].name, files[i].name);
            QVERIFY(back[i].bytes == files[i].bytes);
        }
    }

    void names_that_lead_elsewhere_are_refused() {
        const std::string sound = archive_bytes({{"abcdefgh", "x"}, {"second/b", "y"}});
        for (const char* name : {"/bcdefgh", "../defgh", "a/../fgh", "a//defgh", "./cdefgh", "a\\cdefgh",
                                 "C:cdefgh", "abcdef/.", "a\ncdefgh", "second/b", "SECOND/B"})
            QCOMPARE(code_of([&] { read_archive(renamed(sound, "abcdefgh", name), "it"); }),
                     std::string("syntax"));
        const std::string folder = archive_bytes({{"folder", "x"}, {"folde2/b", "y"}});
        QCOMPARE(code_of([&] { read_archive(renamed(folder, "folde2/b", "folder/b"), "it"); }),
                 std::string("syntax"));
        for (const char* name : {"/a", "..", "a/../b", "a\\b", ""})
            QCOMPARE(code_of([&] { archive_bytes({{name, "x"}}); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] { archive_bytes({{"a", "x"}, {"A", "x"}}); }), std::string("out_of_range"));
    }

    void links_are_refused() {
        std::string bytes = archive_bytes({{"a", "/etc/passwd"}});
        const std::size_t entry = bytes.find("PK\1\2");
        QVERIFY(entry != std::string::npos);
        bytes[entry + 5] = 3;                                               // made by Unix
        bytes[entry + 40] = 0, bytes[entry + 41] = static_cast<char>(0xa0); // 0120000: a link
        QCOMPARE(code_of([&] { read_archive(bytes, "it"); }), std::string("unsupported_format"));
        bytes[entry + 41] = static_cast<char>(0x80); // a plain file
        QCOMPARE(read_archive(bytes, "it").size(), std::size_t(1));
    }

    /// What has a password is told before anything is read, whether libzip can undo it or not.
    void encrypted_files_are_refused() {
        const std::string sound = archive_bytes({{"a", "some text"}, {"b", "more"}});
        const std::size_t last = sound.rfind("PK\1\2"), local = sound.rfind("PK\3\4");
        QVERIFY(last != std::string::npos && local != std::string::npos);
        std::string bytes = sound;
        for (const std::size_t flags : {last + 8, local + 6})
            bytes[flags] = static_cast<char>(bytes[flags] | 1);
        QCOMPARE(code_of([&] { read_archive(bytes, "it"); }), std::string("unsupported_format"));
        try {
            ArchiveReader(bytes, "it");
        } catch (const Error& e) {
            QCOMPARE(e.where(), std::string("it: b"));
            QCOMPARE(e.message(), std::string("is encrypted"));
        }
    }

    void limits_hold() {
        const std::string bytes = archive_bytes({{"a", zeros(1000)}, {"b", zeros(1001)}});
        QCOMPARE(read_archive(bytes, "it", {2, 2001}).size(), std::size_t(2));
        QCOMPARE(code_of([&] { read_archive(bytes, "it", {2, 2000}); }), std::string("limit_exceeded"));
        QCOMPARE(code_of([&] { read_archive(bytes, "it", {1, 2001}); }), std::string("limit_exceeded"));
    }

    /// A mesh does not shrink to a hundredth; what is small anyway may.
    void archives_that_swell_are_refused() {
        const std::string bytes = archive_bytes({{"a", zeros(1'000'000)}});
        QVERIFY(bytes.size() * 200 < 1'000'000);
        QCOMPARE(read_archive(bytes, "it").size(), std::size_t(1));
        QCOMPARE(code_of([&] { read_archive(bytes, "it", {.always_allowed = 999'999}); }),
                 std::string("limit_exceeded"));
    }

    void cancelled_or_failed_writing_ends() {
        const std::string much = zeros(30'000'000);
        Job job;
        job.cancel_at(0.5);
        bool cancelled = false;
        std::size_t written = 0;
        try {
            write_archive(
                {{"a", much}}, [&](std::uint64_t, std::string_view bytes) { written += bytes.size(); },
                Progress(job));
        } catch (const Cancelled&) {
            cancelled = true;
        }
        QVERIFY(cancelled);
        QVERIFY(written < 30'000);
        QCOMPARE(code_of([&] {
                     write_archive({{"a", "some"}}, [](std::uint64_t, std::string_view) {
                         throw Error(ErrorCode::unwritable, "disk", "is full", "");
                     });
                 }),
                 std::string("unwritable"));
    }

    void sizes_that_lie_are_found() {
        const std::string sound = archive_bytes({{"a", zeros(100'000)}});
        for (const std::uint32_t size : {1u, 99'999u, 100'001u}) {
            std::string bytes = sound;
            for (const std::size_t at : {bytes.find("PK\3\4") + 22, bytes.find("PK\1\2") + 24})
                for (int i = 0; i < 4; ++i)
                    bytes[at + std::size_t(i)] = static_cast<char>(size >> (8 * i));
            QCOMPARE(code_of([&] { read_archive(bytes, "it"); }), std::string("syntax"));
        }
    }

    void damaged_bytes_end_in_an_error_or_in_the_files() {
        const std::string sound = archive_bytes({{"a", "some text"}, {"b/c", zeros(500)}});
        for (std::size_t n = 0; n < sound.size(); ++n)
            QVERIFY(!code_of([&] { read_archive(sound.substr(0, n), "it"); }).empty());
        for (std::size_t at = 0; at < sound.size(); ++at)
            for (const int change : {1, 0x80, 0xff}) {
                std::string bytes = sound;
                bytes[at] = static_cast<char>(bytes[at] ^ change);
                try {
                    for (const ArchiveFile& file : read_archive(bytes, "it"))
                        QVERIFY(file.bytes == "some text" || file.bytes == zeros(500));
                } catch (const Error&) { // told
                }
            }
    }
};

FACETMILL_TEST(TestArchive)
#include "test_archive.moc"
