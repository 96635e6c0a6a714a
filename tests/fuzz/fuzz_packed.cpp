// Packed projects: the archive as it comes, or, where the input is none, entries that are packed first, each
// a name and its bytes, with a zero after either, so that mutations get past the checksums of the format. One
// in 64 of these is packed by core, the others here, as they are: what compressing takes its time for is
// its own memory. With "--seeds FOLDER" the target writes a small packed project in both forms and ends.
#include "core/base/archive.h"
#include "core/job/packed_project.h"
#include "tests/fuzz/fuzz.h"

#include <filesystem>
#include <fstream>

using namespace facetmill;

namespace {

std::string_view next_text(std::string_view& bytes) {
    const std::size_t end = std::min(bytes.find('\0'), bytes.size());
    const std::string_view text = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    return text;
}

std::uint32_t checksum(std::string_view bytes) {
    std::uint32_t sum = ~0u;
    for (const char byte : bytes) {
        sum ^= std::uint8_t(byte);
        for (int bit = 0; bit < 8; ++bit)
            sum = (sum >> 1) ^ (sum & 1 ? 0xedb88320u : 0u);
    }
    return ~sum;
}

/// A zip archive of the entries, none of them compressed; whatever their names are.
std::string stored(const std::vector<ArchiveFile>& files) {
    std::string all, directory;
    const auto put = [](std::string& to, std::uint32_t value, int bytes) {
        for (int k = 0; k < bytes; ++k)
            to += char(value >> (8 * k));
    };
    for (const ArchiveFile& file : files) {
        std::string entry;       // what both headers say alike
        put(entry, 20, 2);       // of the format
        put(entry, 0x800, 2);    // names in UTF-8
        put(entry, 0, 2);        // stored
        put(entry, 0x210000, 4); // the first day that there is
        put(entry, checksum(file.bytes), 4);
        put(entry, std::uint32_t(file.bytes.size()), 4);
        put(entry, std::uint32_t(file.bytes.size()), 4);
        put(entry, std::uint32_t(file.name.size()), 2);
        put(entry, 0, 2);
        directory += "PK\1\2";
        put(directory, 0x314, 2); // made under Unix
        directory += entry;
        put(directory, 0, 4); // no comment, the first disk
        put(directory, 0, 2);
        put(directory, 0100644u << 16, 4);
        put(directory, std::uint32_t(all.size()), 4);
        directory += file.name;
        all += "PK\3\4" + entry + file.name + file.bytes;
    }
    const std::size_t start = all.size();
    all += directory + std::string("PK\5\6\0\0\0\0", 8);
    put(all, std::uint32_t(files.size()), 2);
    put(all, std::uint32_t(files.size()), 2);
    put(all, std::uint32_t(directory.size()), 4);
    put(all, std::uint32_t(start), 4);
    put(all, 0, 2);
    return all;
}

/// Whatever is unpacked lies below the folder that it is unpacked into.
void check_names(const std::vector<ArchiveFile>& files) {
    for (const ArchiveFile& file : files)
        if (file.name.empty() || file.name.front() == '/' || file.name.back() == '/'
            || ("/" + file.name + "/").find("/../") != std::string::npos)
            fuzz::found("a name that leads elsewhere");
}

void write_seeds(const std::filesystem::path& folder) {
    const std::vector<ArchiveFile> files = {
        {"job.facetmill",
         R"({"facetmill":1,"units":"mm","part":{"file":"files/a.stl"},"stock":{"kind":"mesh","file":"files/b.stl"},)"
         R"("tools":[{"number":1,"name":"Ball","diameter":6,"corner_radius":3}],)"
         R"("operations":[{"kind":"finish3","name":"One","tool":1,"tolerance":0.1}]})"},
        {"files/a.stl", "solid a\nendsolid a\n"},
        {"files/b.stl", std::string(200, ' ')}};
    std::ofstream(folder / "archive", std::ios::binary) << archive_bytes(files);
    std::ofstream entries(folder / "entries", std::ios::binary);
    for (const ArchiveFile& file : files)
        entries << file.name << '\0' << file.bytes << '\0';
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
    if (*argc != 3 || std::string_view((*argv)[1]) != "--seeds") return 0;
    write_seeds((*argv)[2]);
    std::exit(0);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = fuzz::text_of(data, size);
    std::string packed(bytes);
    std::vector<ArchiveFile> files;
    const bool made_here = !is_archive(bytes);
    bool by_core = false;
    if (made_here) {
        for (std::string_view left = bytes; !left.empty();) {
            const std::string_view name = next_text(left);
            files.push_back({std::string(name), std::string(next_text(left))});
        }
        by_core = checksum(bytes) % 64 == 0;
        if (!by_core)
            packed = stored(files);
        else if (!fuzz::reads([&] { packed = archive_bytes(files); }))
            return 0;
    }
    std::erase_if(files, [](const ArchiveFile& file) { return file.name.ends_with('/'); }); // folders
    std::vector<ArchiveFile> again;
    const bool read = fuzz::reads([&] { again = read_archive(packed, "a.zip"); });
    if (read) check_names(again);
    // Core packs no names that it does not read.
    if (by_core && !read) fuzz::found("what was packed is not read");
    if (made_here && read && again.size() != files.size()) fuzz::found("what was packed does not come back");
    for (std::size_t i = 0; made_here && read && i < files.size(); ++i)
        if (again[i].name != files[i].name || again[i].bytes != files[i].bytes)
            fuzz::found("what was packed comes back as something else");
    fuzz::reads([&] { packed_project(packed, "a.zip"); });
    return 0;
}
