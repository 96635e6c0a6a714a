#include "core/job/kept_folder.h"

#include "core/base/file.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kept_head = "Facetmill kept 1\n", kept_ending = ".kept";
constexpr std::size_t seal_bytes = 16, hashed_at_once = std::size_t(1) << 22;

/// The mark by which programs that make backups know a folder that they may leave out.
constexpr std::string_view cache_mark =
    "Signature: 8a477f597d28d172789f06886806bc55\n"
    "# What Facetmill has planned and verified of the project beside this folder. It may be deleted: it is\n"
    "# made again by planning and verifying.\n";

void add_in_pieces(KeyedHasher& hasher, std::string_view bytes, const Progress& progress) {
    for (std::size_t i = 0; i < bytes.size(); i += hashed_at_once) {
        progress.set(double(i) / double(bytes.size()));
        hasher.add(bytes.substr(i, hashed_at_once));
    }
}

std::string seal_text(const KeyedHash& seal) {
    std::string text(seal_bytes, '\0');
    std::memcpy(text.data(), seal.words.data(), seal_bytes);
    return text;
}

/// Those that the folder is for, and no others that may lie in it.
std::vector<fs::path> kept_files(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code ec;
    for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec))
        if (it->path().extension() == kept_ending && fs::is_regular_file(it->symlink_status(ec)))
            files.push_back(it->path());
    return files;
}

fs::path cache_folder_of(const fs::path& project) {
    return project.parent_path() / (project.stem().string() + ".facetmill-cache");
}

/// The bytes of a file of a folder, which were sealed when it was written.
void copy_file_to(const fs::path& from, const fs::path& to, const Progress& progress) {
    const InputFile in(from);
    OutputFile out(to);
    for (std::size_t i = 0; i < in.bytes().size(); i += hashed_at_once) {
        progress.check();
        out.write(in.bytes().substr(i, hashed_at_once));
    }
    out.commit();
}

void mark_folder(const fs::path& folder) {
    std::error_code ec;
    if (!fs::create_directory(folder, ec) && ec)
        throw Error(ErrorCode::unwritable, folder.string(), "the folder cannot be made: " + ec.message(),
                    "give the right to write there");
    const fs::path mark = folder / "CACHEDIR.TAG";
    if (fs::exists(mark, ec)) return;
    OutputFile file(mark);
    file.write(cache_mark);
    file.commit();
}

} // namespace

KeptFolder::KeptFolder(const fs::path& project, const HashKey& key, std::string program)
    : path_(cache_folder_of(project)), key_(key), program_(std::move(program)) {}

std::string KeptFolder::name_of(std::string_view kind, std::string_view source) const {
    const auto part = [](std::string_view text) {
        return std::to_string(text.size()) + ':' + std::string(text);
    };
    return keyed_hash(key_, part(kind) + part(program_) + part(source)).hex();
}

fs::path KeptFolder::file_of(const std::string& name) const {
    return path_ / (name + std::string(kept_ending));
}

bool KeptFolder::has(const std::string& name) const {
    std::error_code ec;
    return fs::is_regular_file(file_of(name), ec);
}

KeyedHash KeptFolder::seal(const std::string& head, std::string_view bytes, const Progress& progress) const {
    KeyedHasher hasher(key_);
    hasher.add(head);
    add_in_pieces(hasher, bytes, progress);
    return hasher.hash();
}

std::optional<std::string> KeptFolder::read(const std::string& name, const Progress& progress) const {
    const fs::path file = file_of(name);
    const std::string head = std::string(kept_head) + name;
    std::error_code ec;
    // A pipe of that name would be waited for.
    const auto size = fs::is_regular_file(file, ec) ? fs::file_size(file, ec) : 0;
    if (ec || size < head.size() + seal_bytes || size > largest_total) return std::nullopt;
    std::ifstream in(file, std::ios::binary);
    std::string all;
    // Piece by piece: a file may be shorter by now, and a size is not believed before its bytes are there.
    while (in && all.size() < size) {
        progress.set(0.5 * double(all.size()) / double(size));
        const std::size_t before = all.size();
        all.resize(std::min<std::size_t>(size, before + hashed_at_once));
        in.read(all.data() + before, std::streamsize(all.size() - before));
        all.resize(before + std::size_t(in.gcount()));
    }
    if (all.size() != size || !all.starts_with(head)) return std::nullopt;
    const std::string_view bytes =
        std::string_view(all).substr(head.size(), all.size() - head.size() - seal_bytes);
    if (seal_text(seal(head, bytes, progress.part(0.5, 1))) != all.substr(all.size() - seal_bytes))
        return std::nullopt;
    return std::string(bytes);
}

bool KeptFolder::write(const std::string& name, std::string_view bytes, const Progress& progress) const {
    const std::string head = std::string(kept_head) + name;
    if (size() + bytes.size() + head.size() + seal_bytes > largest_total) return false;
    mark_folder(path_);
    OutputFile file(file_of(name));
    file.write(head);
    file.write(bytes);
    file.write(seal_text(seal(head, bytes, progress)));
    file.commit();
    return true;
}

void KeptFolder::keep_only(const std::set<std::string>& names) const {
    for (const fs::path& file : kept_files(path_)) {
        std::error_code ec;
        if (!names.contains(file.stem().string())) fs::remove(file, ec);
    }
}

std::uint64_t KeptFolder::size() const {
    std::uint64_t all = 0;
    for (const fs::path& file : kept_files(path_)) {
        std::error_code ec;
        const auto one = fs::file_size(file, ec);
        if (!ec) all += one;
    }
    return all;
}

void copy_kept(const fs::path& from_project, const fs::path& to_project, const Progress& progress) {
    const fs::path from = cache_folder_of(from_project), to = cache_folder_of(to_project);
    std::error_code ec;
    if (from == to || fs::equivalent(from, to, ec)) return;
    std::vector<fs::path> files = kept_files(from);
    std::sort(files.begin(), files.end());
    std::uint64_t all = 0;
    for (const fs::path& file : kept_files(to))
        all += fs::file_size(file, ec);
    try {
        for (const fs::path& file : files) {
            const fs::path there = to / file.filename();
            const auto size = fs::file_size(file, ec);
            if (ec || fs::exists(there, ec) || (all += size) > KeptFolder::largest_total) continue;
            mark_folder(to);
            copy_file_to(file, there, progress);
        }
    } catch (const Error&) {
        // It is planned again.
    }
}

std::string content_text(const fs::path& path, const HashKey& key, const Progress& progress) {
    const InputFile file(path);
    KeyedHasher hasher(key);
    add_in_pieces(hasher, file.bytes(), progress);
    return "content " + hasher.hash().hex();
}

} // namespace facetmill
