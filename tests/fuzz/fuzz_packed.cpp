// Packed projects: the archive as it comes, or, where the input is none, entries that are packed first, each
// a name and its bytes, with a zero after either, so that mutations get past the checksums of the format.
// With
// "--seeds FOLDER" the target writes a small packed project in both forms and ends.
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
    if (made_here) {
        for (std::string_view left = bytes; !left.empty();) {
            const std::string_view name = next_text(left);
            files.push_back({std::string(name), std::string(next_text(left))});
        }
        if (!fuzz::reads([&] { packed = archive_bytes(files); })) return 0;
    }
    std::vector<ArchiveFile> again;
    const bool read = fuzz::reads([&] { again = read_archive(packed, "a.zip"); });
    if (read) check_names(again);
    if (made_here && (!read || again.size() != files.size()))
        fuzz::found("what was packed does not come back");
    for (std::size_t i = 0; made_here && i < files.size(); ++i)
        if (again[i].name != files[i].name || again[i].bytes != files[i].bytes)
            fuzz::found("what was packed comes back as something else");
    fuzz::reads([&] { packed_project(packed, "a.zip"); });
    return 0;
}
