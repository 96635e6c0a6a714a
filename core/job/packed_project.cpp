#include "core/job/packed_project.h"

#include "core/base/archive.h"
#include "core/base/error.h"
#include "core/base/leftovers.h"
#include "core/base/text.h"
#include "core/job/new_folder.h"
#include "core/job/project_inputs.h"

#include <algorithm>
#include <cerrno>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <system_error>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view project_ending = ".facetmill", files_folder = "files/";
constexpr std::uint64_t largest_project = std::uint64_t(1) << 30;

/// A file's name without what archives do not take.
std::string plain_name(std::string name) {
    for (char& c : name)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\' || c == ':' || c == '/') c = '_';
    return name.empty() || name == "." || name == ".." ? "project" : name;
}

/// The files of a project under the names that they are packed by.
class FilesToPack {
public:
    /// The name of a file; the same for the same file.
    std::string name_of(const fs::path& file) {
        std::error_code ec;
        const fs::path real = fs::weakly_canonical(file, ec);
        const auto [known, is_new] = names_.try_emplace(ec ? file : real);
        if (!is_new) return known->second;
        const fs::path plain = plain_name(file.filename().string());
        std::string name = plain.string();
        for (int n = 2; !taken_.insert(in_small_letters(name)).second; ++n)
            name = plain.stem().string() + "-" + std::to_string(n) + plain.extension().string();
        known->second = std::string(files_folder) + name;
        files.push_back({known->second, file, 0});
        return known->second;
    }

    std::vector<PackedFile> files;

private:
    std::map<fs::path, std::string> names_;
    std::set<std::string> taken_;
};

/// Names every file as it is called in the archive.
FilesToPack name_packed(Project& project) {
    FilesToPack to_pack;
    std::vector<std::vector<ProjectInput>> inputs; // first, while the project says where they are
    for (std::size_t i = 0; i < setup_count(project); ++i) {
        const Project view = view_of_setup(project, i);
        check_inputs(view);
        inputs.push_back(project_inputs(view));
    }
    const std::size_t chosen = chosen_setup(project);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        choose_setup(project, i);
        for (const ProjectInput& input : inputs[i])
            write_name(project, input, to_pack.name_of(input.path));
    }
    choose_setup(project, chosen);
    project.path.clear();
    return to_pack;
}

/// The only project in an archive.
std::size_t project_entry(const ArchiveReader& archive, const std::string& name) {
    std::size_t found = archive.count();
    for (std::size_t i = 0; i < archive.count(); ++i) {
        if (!in_small_letters(archive.entry_name(i)).ends_with(project_ending)) continue;
        if (found != archive.count())
            throw Error(ErrorCode::out_of_range, name,
                        "holds two projects: " + printable(archive.entry_name(found)) + " and "
                            + printable(archive.entry_name(i)),
                        "have one project packed, or unpack the archive by other means");
        found = i;
    }
    if (found == archive.count())
        throw Error(ErrorCode::missing_key, name, "is an archive without a project",
                    "name a file that `facetmill-cli pack` or File > Save packed copy has written");
    return found;
}

/// A packed file whose project names nothing but what is in it.
class OpenedPack {
public:
    OpenedPack(std::string_view bytes, const std::string& called)
        : name(called), archive(bytes, name), entry(project_entry(archive, name)) {
        if (archive.size(entry) > largest_project)
            throw Error(ErrorCode::limit_exceeded, archive.where(entry), "is too large for a project",
                        "have it packed again");
        project = parse_project(archive.bytes(entry), archive.where(entry));
        std::set<std::string> names;
        for (std::size_t i = 0; i < archive.count(); ++i)
            names.insert(archive.entry_name(i));
        const std::string from = fs::path(archive.entry_name(entry)).parent_path().generic_string();
        for (std::size_t i = 0; i < setup_count(project); ++i) {
            const Project view = view_of_setup(project, i);
            for (const ProjectInput& input : project_inputs(view)) {
                const std::string& file = written_name(view, input);
                std::string entry_name = from;
                if (!from.empty()) entry_name += '/';
                entry_name += file;
                if (names.contains(entry_name)) continue;
                throw Error(ErrorCode::missing_reference, archive.where(entry) + ": " + input_key(input),
                            "'" + printable(file) + "' is not in the packed file",
                            "have the project packed again, with all its files");
            }
        }
    }

    const std::string name;
    const ArchiveReader archive;
    const std::size_t entry;
    Project project;
};

std::string name_of(const fs::path& packed) {
    return printable(packed.string(), 400);
}

/// Calls `work` for every file with its share of the progress, which goes by bytes.
template <class Work>
void for_each_file(const ArchiveReader& archive, const Progress& progress, const Work& work) {
    double all = 1, done = 0;
    for (std::size_t i = 0; i < archive.count(); ++i)
        all += double(archive.size(i));
    for (std::size_t i = 0; i < archive.count(); ++i) {
        progress.check();
        const double next = done + double(archive.size(i));
        work(i, progress.part(done / all, next / all));
        done = next;
    }
}

} // namespace

std::vector<PackedFile> pack_project(const Project& project, const std::string& name, const fs::path& output,
                                     const Progress& progress, const BeforePacked& before) {
    keep_inputs(project, output);
    Project packed = project;
    FilesToPack to_pack = name_packed(packed);
    const std::string text = project_to_json(packed);
    std::vector<PackedFile> files = {
        {plain_name(name) + std::string(project_ending), project.path, text.size()}};
    std::vector<std::unique_ptr<const InputFile>> open; // mapped, not read into memory
    std::vector<ArchiveEntry> entries = {{files.front().name, text}};
    for (PackedFile& file : to_pack.files) {
        open.push_back(std::make_unique<const InputFile>(file.path));
        file.bytes = open.back()->bytes().size();
        entries.push_back({file.name, open.back()->bytes()});
        files.push_back(file);
    }
    OutputFile out(output);
    std::uint64_t end = 0;
    write_archive(
        entries,
        [&](std::uint64_t at, std::string_view bytes) {
            if (at == end)
                out.write(bytes);
            else
                out.overwrite(std::size_t(at), bytes);
            end = std::max(end, at + bytes.size());
        },
        progress);
    out.close_stream();
    if (before) before(files);
    out.commit();
    return files;
}

bool is_packed(const fs::path& path) {
    try {
        return is_archive(InputFile(path).bytes());
    } catch (const Error&) {
        return false; // told by who reads it
    }
}

namespace {

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// A file of these very bytes: unpacked before, as a whole or by a run that was killed between two folders.
bool is_same(const ArchiveReader& archive, std::size_t i, const fs::path& path, const Progress& progress) {
    if (std::error_code ec; !fs::is_regular_file(path, ec)) return false;
    const InputFile there(path);
    if (there.bytes().size() != archive.size(i)) return false;
    std::size_t at = 0;
    bool same = true;
    archive.read(
        i,
        [&](std::string_view bytes) {
            same = same && there.bytes().substr(at, bytes.size()) == bytes;
            at += bytes.size();
        },
        progress);
    return same;
}

/// Which entries need not be unpacked. Throws Error(unwritable) where something else is in the way.
std::vector<bool> files_there(const ArchiveReader& archive, const fs::path& folder,
                              const Progress& progress) {
    std::set<fs::path> folders;
    for (std::size_t i = 0; i < archive.count(); ++i)
        folders.insert(folder_of(folder / archive.entry_name(i)));
    for (const fs::path& f : folders)
        detail::clear_leftovers(f);
    std::vector<bool> there(archive.count());
    for (std::size_t i = 0; i < archive.count(); ++i) {
        const fs::path to = folder / archive.entry_name(i);
        std::error_code ec;
        if (!fs::exists(fs::symlink_status(to, ec))) continue;
        if (!is_same(archive, i, to, progress.part(0, 0))) // the bar waits, a cancel does not
            throw Error(ErrorCode::unwritable, printable(to.string(), 400),
                        "is there already, and is another file", "unpack into another folder");
        there[i] = true;
    }
    return there;
}

} // namespace

std::vector<PackedFile> unpack_project(const fs::path& packed, const fs::path& folder,
                                       const Progress& progress, const BeforePacked& before) {
    const InputFile file(packed);
    if (!is_archive(file.bytes()))
        throw Error(ErrorCode::unsupported_format, name_of(packed), "is no packed project",
                    "name a file that `facetmill-cli pack` has written");
    const OpenedPack pack(file.bytes(), name_of(packed));
    const std::vector<bool> there = files_there(pack.archive, folder, progress);
    std::list<NewFolder> folders; // the innermost first: they go in this order
    OutputSet outputs;
    std::vector<PackedFile> files;
    for_each_file(pack.archive, progress, [&](std::size_t i, const Progress& part) {
        const fs::path to = folder / pack.archive.entry_name(i);
        files.push_back({pack.archive.entry_name(i), to, pack.archive.size(i)});
        if (there[i]) return;
        folders.emplace_front(folder_of(to));
        OutputFile& out = outputs.add(to);
        pack.archive.read(
            i, [&](std::string_view bytes) { out.write(bytes); }, part);
    });
    std::rotate(files.begin(), files.begin() + std::ptrdiff_t(pack.entry),
                files.begin() + std::ptrdiff_t(pack.entry) + 1);
    progress.check();
    outputs.commit([&] {
        if (before) before(files);
    });
    return files;
}

Project packed_project(std::string_view bytes, const std::string& name) {
    return OpenedPack(bytes, name).project;
}

Project load_packed(const InputFile& packed) {
    OpenedPack pack(packed.bytes(), name_of(packed.path()));
    auto folder = std::make_shared<const TemporaryFolder>(pack.name);
    for_each_file(pack.archive, {}, [&](std::size_t i, const Progress& part) {
        const auto fail = [&] {
            throw Error(ErrorCode::unwritable, pack.archive.where(i),
                        "cannot be unpacked for this run: " + std::generic_category().message(errno),
                        "check the free space of temporary files, or name another folder in TMPDIR");
        };
        auto out = folder->create(pack.archive.entry_name(i));
        pack.archive.read(
            i,
            [&](std::string_view bytes) {
                if (std::fwrite(bytes.data(), 1, bytes.size(), out.get()) != bytes.size()) fail();
            },
            part);
        if (std::fclose(out.release()) != 0) fail();
    });
    pack.project.path = folder->path() / pack.archive.entry_name(pack.entry);
    pack.project.unpacked = std::move(folder);
    return std::move(pack.project);
}

} // namespace facetmill
