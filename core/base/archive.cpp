#include "core/base/archive.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <exception>
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
constexpr unsigned kind_mask = 0170000, plain_file = 0100000, folder_kind = 0040000;

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
        name = in_small_letters(std::move(name));
        if (folders_.contains(name) || !files_.insert(name).second) return false;
        for (std::size_t at = name.find('/'); at != std::string::npos; at = name.find('/', at + 1)) {
            const std::string above = name.substr(0, at);
            if (files_.contains(above)) return false;
            folders_.insert(above);
        }
        return true;
    }

private:
    std::set<std::string> files_, folders_;
};

/// Which of libzip's errors it is, beside the archive if it could be opened.
Archive opened_as(std::string_view bytes, int flags, zip_error_t& error) {
    Source source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error));
    Archive archive(source ? zip_open_from_source(source.get(), flags, &error) : nullptr);
    if (archive) source.release(); // NOLINT(bugprone-unused-return-value): the archive has it
    return archive;
}

Archive open_archive(std::string_view bytes, const std::string& name) {
    zip_error_t error;
    zip_error_init(&error);
    Archive archive = opened_as(bytes, ZIP_RDONLY | ZIP_CHECKCONS, error);
    // Fusion 360 writes some sizes both before a file and behind it, others only behind it, which libzip
    // finds inconsistent. The directory at the end counts, and every file's own checksum.
    if (!archive && zip_error_code_zip(&error) == ZIP_ER_INCONS)
        archive = opened_as(bytes, ZIP_RDONLY, error);
    const std::string why = archive ? std::string() : zip_error_strerror(&error);
    zip_error_fini(&error);
    if (!archive) damaged(name, printable(why));
    return archive;
}

/// Whether an entry is a plain file; folders are left out, whatever else there is is refused.
bool is_plain(zip_t& archive, zip_uint64_t i, const std::string& where) {
    zip_uint8_t system = 0;
    zip_uint32_t attributes = 0;
    if (zip_file_get_external_attributes(&archive, i, 0, &system, &attributes) != 0)
        damaged(where, "its attributes cannot be read");
    const unsigned kind = system == ZIP_OPSYS_UNIX ? (attributes >> 16) & kind_mask : 0;
    if (kind != 0 && kind != plain_file && kind != folder_kind)
        throw Error(ErrorCode::unsupported_format, where, "is a link or no plain file",
                    "have the project packed with the files themselves");
    return kind != folder_kind;
}

/// Where libzip writes to. It goes back to the head of a file once it knows its size.
struct Target {
    const ArchiveWriter& write;
    const Progress& progress;
    std::exception_ptr thrown; ///< exceptions do not pass through libzip
    std::uint64_t at = 0, end = 0;
    zip_error_t error{};
};

zip_int64_t put(Target& target, const void* data, zip_uint64_t size) {
    try {
        target.write(target.at, {static_cast<const char*>(data), std::size_t(size)});
    } catch (...) {
        target.thrown = std::current_exception();
        zip_error_set(&target.error, ZIP_ER_WRITE, 0);
        return -1;
    }
    target.at += size;
    target.end = std::max(target.end, target.at);
    return zip_int64_t(size);
}

/// An empty file that is written.
zip_int64_t serve_target(void* user, void* data, zip_uint64_t size, zip_source_cmd_t command) {
    Target& target = *static_cast<Target*>(user);
    switch (command) {
    case ZIP_SOURCE_WRITE:
        return put(target, data, size);
    case ZIP_SOURCE_SEEK_WRITE: {
        const zip_int64_t at =
            zip_source_seek_compute_offset(target.at, target.end, data, size, &target.error);
        if (at < 0) return -1;
        target.at = std::uint64_t(at);
        return 0;
    }
    case ZIP_SOURCE_TELL_WRITE:
        return zip_int64_t(target.at);
    case ZIP_SOURCE_STAT: {
        zip_stat_t& stat = *static_cast<zip_stat_t*>(data);
        zip_stat_init(&stat);
        stat.size = 0;
        stat.valid |= ZIP_STAT_SIZE;
        return sizeof stat;
    }
    case ZIP_SOURCE_ERROR:
        return zip_error_to_data(&target.error, data, size);
    case ZIP_SOURCE_SUPPORTS:
        return zip_source_make_command_bitmap(
            ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT, ZIP_SOURCE_ERROR,
            ZIP_SOURCE_FREE, ZIP_SOURCE_SEEK, ZIP_SOURCE_TELL, ZIP_SOURCE_SUPPORTS, ZIP_SOURCE_BEGIN_WRITE,
            ZIP_SOURCE_COMMIT_WRITE, ZIP_SOURCE_ROLLBACK_WRITE, ZIP_SOURCE_WRITE, ZIP_SOURCE_SEEK_WRITE,
            ZIP_SOURCE_TELL_WRITE, ZIP_SOURCE_REMOVE, -1);
    case ZIP_SOURCE_OPEN:
    case ZIP_SOURCE_READ:
    case ZIP_SOURCE_CLOSE:
    case ZIP_SOURCE_SEEK:
    case ZIP_SOURCE_TELL:
    case ZIP_SOURCE_BEGIN_WRITE:
    case ZIP_SOURCE_COMMIT_WRITE:
    case ZIP_SOURCE_ROLLBACK_WRITE:
    case ZIP_SOURCE_REMOVE:
    case ZIP_SOURCE_FREE:
        return 0;
    default:
        zip_error_set(&target.error, ZIP_ER_OPNOTSUPP, 0);
        return -1;
    }
}

void show_progress(zip_t* /*archive*/, double fraction, void* user) {
    try {
        static_cast<Target*>(user)->progress.set(fraction);
    } catch (...) { // libzip asks for cancels by itself
    }
}

int is_cancelled(zip_t* /*archive*/, void* user) {
    return static_cast<Target*>(user)->progress.cancelled() ? 1 : 0;
}

void add_entries(zip_t& archive, const std::vector<ArchiveEntry>& files) {
    const auto check = [&](bool good) {
        if (!good)
            throw Error(ErrorCode::internal, "archive", printable(zip_strerror(&archive)), "try again");
    };
    const ArchiveLimits limits;
    if (files.size() > limits.files)
        throw Error(ErrorCode::limit_exceeded, "archive",
                    "would hold " + std::to_string(files.size()) + " files, more than "
                        + std::to_string(limits.files),
                    "send the files as they are");
    Names names;
    std::uint64_t left = limits.bytes;
    for (const ArchiveEntry& file : files) {
        const std::string wrong = wrong_with(file.name);
        if (!wrong.empty() || !names.take(file.name))
            throw Error(ErrorCode::out_of_range, printable(file.name),
                        wrong.empty() ? "a name occurs twice" : wrong, "give the file another name");
        if (file.bytes.size() > left)
            throw Error(ErrorCode::limit_exceeded, printable(file.name),
                        "would make the archive hold more than " + std::to_string(limits.bytes) + " bytes",
                        "send the files as they are");
        left -= file.bytes.size();
        Source bytes(zip_source_buffer(&archive, file.bytes.data(), file.bytes.size(), 0));
        check(bytes != nullptr);
        const zip_int64_t i = zip_file_add(&archive, file.name.c_str(), bytes.get(), ZIP_FL_ENC_UTF_8);
        check(i >= 0);
        bytes.release(); // NOLINT(bugprone-unused-return-value): the archive has it
        // The first day that the format knows.
        check(zip_file_set_dostime(&archive, zip_uint64_t(i), 0, 0x21, 0) == 0);
    }
}

} // namespace

bool is_archive(std::string_view bytes) {
    using namespace std::string_view_literals;
    return bytes.starts_with("PK\3\4"sv) || bytes.starts_with("PK\5\6"sv);
}

void write_archive(const std::vector<ArchiveEntry>& files, const ArchiveWriter& write,
                   const Progress& progress) {
    Target target{.write = write, .progress = progress};
    zip_error_t error;
    zip_error_init(&error);
    zip_error_init(&target.error);
    Source source(zip_source_function_create(serve_target, &target, &error));
    Archive archive(source ? zip_open_from_source(source.get(), ZIP_TRUNCATE, &error) : nullptr);
    const std::string why = archive ? std::string() : zip_error_strerror(&error);
    zip_error_fini(&error);
    if (!archive) throw Error(ErrorCode::internal, "archive", printable(why), "try again");
    source.release(); // NOLINT(bugprone-unused-return-value): the archive has it
    add_entries(*archive, files);
    constexpr double step = 0.001;
    zip_register_progress_callback_with_state(archive.get(), step, show_progress, nullptr, &target);
    zip_register_cancel_callback_with_state(archive.get(), is_cancelled, nullptr, &target);
    if (zip_close(archive.get()) != 0) {
        if (target.thrown) std::rethrow_exception(target.thrown);
        progress.check();
        throw Error(ErrorCode::internal, "archive", printable(zip_strerror(archive.get())), "try again");
    }
    archive.release(); // NOLINT(bugprone-unused-return-value): closed
    progress.check();
}

std::string archive_bytes(const std::vector<ArchiveFile>& files) {
    std::vector<ArchiveEntry> entries;
    entries.reserve(files.size());
    for (const ArchiveFile& file : files)
        entries.push_back({file.name, file.bytes});
    std::string bytes;
    write_archive(entries, [&](std::uint64_t at, std::string_view piece) {
        bytes.resize(std::max(bytes.size(), std::size_t(at) + piece.size()));
        std::copy(piece.begin(), piece.end(), bytes.begin() + std::ptrdiff_t(at));
    });
    return bytes;
}

class ArchiveReader::Entries {
public:
    Entries(std::string_view bytes, std::string of, const ArchiveLimits& limits)
        : name(std::move(of)), archive(open_archive(bytes, name)) {
        const zip_int64_t n = zip_get_num_entries(archive.get(), 0);
        if (n < 0 || std::uint64_t(n) > limits.files)
            throw Error(ErrorCode::limit_exceeded, name,
                        "holds " + std::to_string(n) + " files, more than " + std::to_string(limits.files),
                        "unpack it by other means, if you trust it");
        const std::uint64_t allowed = std::min(
            limits.bytes, std::max(limits.always_allowed, std::uint64_t(bytes.size()) * limits.times_larger));
        Names names;
        std::uint64_t left = allowed;
        for (zip_uint64_t i = 0; i < zip_uint64_t(n); ++i) {
            Entry entry;
            if (!look_at(i, names, entry)) continue;
            if (entry.size > left)
                throw Error(ErrorCode::limit_exceeded, name + ": " + printable(entry.name),
                            "is more than " + std::to_string(allowed)
                                + " bytes with those before it, unpacked",
                            "unpack it by other means, if you trust it");
            left -= entry.size;
            all.push_back(std::move(entry));
        }
    }

    struct Entry {
        std::string name;
        zip_uint64_t place = 0;
        std::uint64_t size = 0;
    };
    std::string name;
    Archive archive;
    std::vector<Entry> all;

private:
    /// False for a folder.
    bool look_at(zip_uint64_t i, Names& names, Entry& entry) const {
        zip_stat_t said;
        if (zip_stat_index(archive.get(), i, ZIP_FL_ENC_STRICT, &said) != 0
            || (said.valid & ZIP_STAT_NAME) == 0 || (said.valid & ZIP_STAT_SIZE) == 0)
            damaged(name, "an entry has no name or no size");
        entry = {said.name, i, said.size};
        const std::string where = name + ": " + printable(entry.name);
        const bool ends_as_folder = entry.name.ends_with('/');
        if (ends_as_folder) entry.name.pop_back();
        if (const std::string wrong = wrong_with(entry.name); !wrong.empty()) damaged(where, wrong);
        if (!is_plain(*archive, i, where) || ends_as_folder) return false;
        if (!names.take(entry.name)) damaged(where, "the name occurs twice");
        if ((said.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && said.encryption_method != ZIP_EM_NONE)
            throw Error(ErrorCode::unsupported_format, where, "is encrypted",
                        "have it packed without a password");
        return true;
    }
};

ArchiveReader::ArchiveReader(std::string_view bytes, const std::string& name, const ArchiveLimits& limits)
    : entries_(std::make_unique<const Entries>(bytes, name, limits)) {}

ArchiveReader::~ArchiveReader() = default;

std::size_t ArchiveReader::count() const {
    return entries_->all.size();
}

const std::string& ArchiveReader::entry_name(std::size_t i) const {
    return entries_->all.at(i).name;
}

std::uint64_t ArchiveReader::size(std::size_t i) const {
    return entries_->all.at(i).size;
}

std::string ArchiveReader::where(std::size_t i) const {
    return entries_->name + ": " + printable(entry_name(i), 400);
}

void ArchiveReader::read(std::size_t i, const std::function<void(std::string_view)>& take,
                         const Progress& progress) const {
    const std::uint64_t said = size(i);
    const std::unique_ptr<zip_file_t, Close> file(
        zip_fopen_index(entries_->archive.get(), entries_->all[i].place, 0));
    if (!file) damaged(where(i), printable(zip_strerror(entries_->archive.get())));
    // What is said of the size may be a lie: one byte more is asked for.
    std::string piece(std::size_t(std::min<std::uint64_t>(said, (1 << 18) - 1)) + 1, '\0');
    std::uint64_t got = 0;
    while (true) {
        const zip_int64_t n = zip_fread(file.get(), piece.data(), piece.size());
        if (n < 0) damaged(where(i), "it cannot be unpacked");
        if (n == 0) break;
        got += std::uint64_t(n);
        if (got > said) damaged(where(i), "it is larger than it says");
        take(std::string_view(piece).substr(0, std::size_t(n)));
        progress.set(double(got) / double(said));
    }
    if (got != said) damaged(where(i), "it is smaller than it says");
}

std::string ArchiveReader::bytes(std::size_t i) const {
    std::string all;
    read(i, [&](std::string_view piece) { all += piece; });
    return all;
}

std::vector<ArchiveFile> read_archive(std::string_view bytes, const std::string& name,
                                      const ArchiveLimits& limits) {
    const ArchiveReader reader(bytes, name, limits);
    std::vector<ArchiveFile> files;
    for (std::size_t i = 0; i < reader.count(); ++i)
        files.push_back({reader.entry_name(i), reader.bytes(i)});
    return files;
}

} // namespace facetmill
