#include "core/base/archive.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <memory>
#include <set>

#include <zip.h>

namespace facetmill {

namespace {

struct Discard {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct Close {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};
struct Release {
    void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Archive = std::unique_ptr<zip_t, Discard>;
using Source = std::unique_ptr<zip_source_t, Release>;

/// Kind of file in the upper half of a Unix system's attributes.
constexpr unsigned kind_mask = 0170000, plain_file = 0100000, folder = 0040000;

[[noreturn]] void damaged(const std::string& where, const std::string& what) {
    throw Error(ErrorCode::syntax, where, "is no sound archive: " + what, "have it packed and sent again");
}

/// Why a name may not be unpacked; empty if it may.
std::string wrong_with(std::string_view name) {
    if (name.empty() || name.size() > 400) return "a name is empty or too long";
    if (name.front() == '/') return "a name is absolute";
    for (const char c : name)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\' || c == ':')
            return "a name has a backslash, a colon or a control character";
    for (std::size_t from = 0; from <= name.size();) {
        const std::size_t to = std::min(name.find('/', from), name.size());
        const std::string_view step = name.substr(from, to - from);
        if (step.empty() || step == "." || step == "..") return "a name leads elsewhere";
        from = to + 1;
    }
    return {};
}

/// Names that were taken, in small letters, and the folders on their way.
class Names {
public:
    bool take(std::string name) {
        std::transform(name.begin(), name.end(), name.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
        if (folders_.contains(name) || !files_.insert(name).second) return false;
        for (std::size_t at = name.find('/'); at != std::string::npos; at = name.find('/', at + 1)) {
            const std::string way = name.substr(0, at);
            if (files_.contains(way)) return false;
            folders_.insert(way);
        }
        return true;
    }

private:
    std::set<std::string> files_, folders_;
};

Archive open_archive(std::string_view bytes, const std::string& name) {
    zip_error_t error;
    zip_error_init(&error);
    Source source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error));
    Archive archive(source ? zip_open_from_source(source.get(), ZIP_RDONLY | ZIP_CHECKCONS, &error)
                           : nullptr);
    const std::string why = archive ? std::string() : zip_error_strerror(&error);
    zip_error_fini(&error);
    if (!archive) damaged(name, printable(why));
    source.release(); // NOLINT(bugprone-unused-return-value): the archive has it
    return archive;
}

/// Whether an entry is a plain file; folders are left out, whatever else there is is refused.
bool is_plain(zip_t& archive, zip_uint64_t i, const std::string& where) {
    zip_uint8_t system = 0;
    zip_uint32_t attributes = 0;
    if (zip_file_get_external_attributes(&archive, i, 0, &system, &attributes) != 0)
        damaged(where, "its attributes cannot be read");
    const unsigned kind = system == ZIP_OPSYS_UNIX ? (attributes >> 16) & kind_mask : 0;
    if (kind != 0 && kind != plain_file && kind != folder)
        throw Error(ErrorCode::unsupported_format, where, "is a link or no plain file",
                    "have the project packed with the files themselves");
    return kind != folder;
}

std::string entry_bytes(zip_t& archive, zip_uint64_t i, std::uint64_t size, const std::string& where) {
    const std::unique_ptr<zip_file_t, Close> file(zip_fopen_index(&archive, i, 0));
    if (!file) damaged(where, printable(zip_strerror(&archive)));
    // What is said of the size may be a lie: memory grows with what comes.
    std::string bytes, piece(1 << 20, '\0');
    while (true) {
        const zip_int64_t n = zip_fread(file.get(), piece.data(), piece.size());
        if (n < 0) damaged(where, "it cannot be unpacked");
        if (n == 0) break;
        bytes.append(piece, 0, std::size_t(n));
        if (bytes.size() > size) damaged(where, "it is larger than it says");
    }
    if (bytes.size() != size) damaged(where, "it is smaller than it says");
    return bytes;
}

} // namespace

bool is_archive(std::string_view bytes) {
    using namespace std::string_view_literals;
    return bytes.starts_with("PK\3\4"sv) || bytes.starts_with("PK\5\6"sv);
}

std::string archive_bytes(const std::vector<ArchiveFile>& files) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* const made = zip_source_buffer_create(nullptr, 0, 0, &error);
    if (!made) throw Error(ErrorCode::internal, "archive", "there is no memory for it", "try again");
    zip_source_keep(made);
    const Source source(made);
    Archive archive(zip_open_from_source(made, ZIP_TRUNCATE, &error));
    zip_error_fini(&error);
    const auto check = [&](bool good) {
        if (!good)
            throw Error(ErrorCode::internal, "archive",
                        archive ? printable(zip_strerror(archive.get())) : "cannot be made", "try again");
    };
    check(archive != nullptr);
    Names names;
    for (const ArchiveFile& file : files) {
        const std::string wrong = wrong_with(file.name);
        if (!wrong.empty() || !names.take(file.name))
            throw Error(ErrorCode::out_of_range, printable(file.name),
                        wrong.empty() ? "a name occurs twice" : wrong, "give the file another name");
        Source bytes(zip_source_buffer(archive.get(), file.bytes.data(), file.bytes.size(), 0));
        check(bytes != nullptr);
        const zip_int64_t i = zip_file_add(archive.get(), file.name.c_str(), bytes.get(), ZIP_FL_ENC_UTF_8);
        check(i >= 0);
        bytes.release(); // NOLINT(bugprone-unused-return-value): the archive has it
        // The first day that the format knows.
        check(zip_file_set_dostime(archive.get(), zip_uint64_t(i), 0, 0x21, 0) == 0);
    }
    check(zip_close(archive.get()) == 0);
    archive.release(); // NOLINT(bugprone-unused-return-value): closed
    zip_stat_t size;
    std::string bytes;
    if (zip_source_stat(made, &size) == 0 && zip_source_open(made) == 0) {
        bytes.resize(size.size);
        if (zip_source_read(made, bytes.data(), bytes.size()) != zip_int64_t(bytes.size())) bytes.clear();
        zip_source_close(made);
    }
    if (bytes.empty()) throw Error(ErrorCode::internal, "archive", "cannot be made", "try again");
    return bytes;
}

std::vector<ArchiveFile> read_archive(std::string_view bytes, const std::string& name,
                                      const ArchiveLimits& limits) {
    const Archive archive = open_archive(bytes, name);
    const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
    if (count < 0 || std::uint64_t(count) > limits.files)
        throw Error(ErrorCode::limit_exceeded, name,
                    "holds " + std::to_string(count) + " files, more than " + std::to_string(limits.files),
                    "unpack it by other means, if you trust it");
    std::vector<std::pair<zip_uint64_t, std::uint64_t>> plain; // place, size
    std::vector<ArchiveFile> files;
    Names names;
    std::uint64_t total = 0;
    for (zip_uint64_t i = 0; i < zip_uint64_t(count); ++i) {
        zip_stat_t said;
        if (zip_stat_index(archive.get(), i, ZIP_FL_ENC_STRICT, &said) != 0
            || (said.valid & ZIP_STAT_NAME) == 0 || (said.valid & ZIP_STAT_SIZE) == 0)
            damaged(name, "an entry has no name or no size");
        std::string entry = said.name;
        const std::string where = name + ": " + printable(entry);
        const bool ends_as_folder = entry.ends_with('/');
        if (ends_as_folder) entry.pop_back();
        if (const std::string wrong = wrong_with(entry); !wrong.empty()) damaged(where, wrong);
        if (!is_plain(*archive, i, where) || ends_as_folder) continue;
        if (!names.take(entry)) damaged(where, "the name occurs twice");
        if ((said.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && said.encryption_method != ZIP_EM_NONE)
            throw Error(ErrorCode::unsupported_format, where, "is encrypted", "have it packed without");
        if (said.size > limits.bytes - total)
            throw Error(ErrorCode::limit_exceeded, where,
                        "is more than " + std::to_string(limits.bytes)
                            + " bytes with those before it, unpacked",
                        "unpack it by other means, if you trust it");
        total += said.size;
        plain.emplace_back(i, said.size);
        files.push_back({std::move(entry), {}});
    }
    for (std::size_t k = 0; k < files.size(); ++k)
        files[k].bytes =
            entry_bytes(*archive, plain[k].first, plain[k].second, name + ": " + printable(files[k].name));
    return files;
}

} // namespace facetmill
