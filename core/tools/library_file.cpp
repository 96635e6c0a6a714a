#include "core/tools/library_file.h"

#include "core/base/archive.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/tools/formats.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

/// What a .tools archive holds.
constexpr const char* packed_name = "tools.json";

struct FormatInfo {
    LibraryFormat format;
    const char* name;
    const char* end; ///< of a file's name; of .json files Fusion's is the usual one
};
constexpr std::array<FormatInfo, 9> formats{{{LibraryFormat::facetmill, "facetmill", ".fmtools"},
                                             {LibraryFormat::freecad_tool, "freecad-tool", ".fctb"},
                                             {LibraryFormat::freecad_library, "freecad-library", ".fctl"},
                                             {LibraryFormat::freecad_holder, "freecad-holder", ".fcholder"},
                                             {LibraryFormat::fusion, "fusion", ".json"},
                                             {LibraryFormat::fusion_archive, "fusion-archive", ".tools"},
                                             {LibraryFormat::linuxcnc, "linuxcnc", ".tbl"},
                                             {LibraryFormat::camotics, "camotics", ".json"},
                                             {LibraryFormat::kiri, "kirimoto", ".json"}}};

/// Which of the programs that write .json files wrote one.
LibraryFormat format_of(const Json& json, const std::string& name) {
    if (json.is_object() && json.contains("facetmill_tools")) return LibraryFormat::facetmill;
    if (json.is_object() && json.contains("data")) return LibraryFormat::fusion;
    const Json* tools = json.is_object() && json.contains("tools") ? &json["tools"] : &json;
    if (tools->is_array() && !tools->empty() && (*tools)[0].is_object() && (*tools)[0].contains("flute_diam"))
        return LibraryFormat::kiri;
    if (tools->is_object() && !tools->empty() && tools->begin()->is_object()
        && tools->begin()->contains("shape"))
        return LibraryFormat::camotics;
    throw Error(ErrorCode::unsupported_format, name, "is no tool library that this program knows",
                "give one of Facetmill, Fusion, CAMotics or Kiri:Moto");
}

ReadLibrary read_json(std::string_view bytes, const std::string& name, LibraryFormat format, LengthUnit unit,
                      const NamedFiles& files) {
    const Json json = parse_strict_json(bytes, name);
    if (format == LibraryFormat::fusion) format = format_of(json, name);
    ReadLibrary read;
    switch (format) {
    case LibraryFormat::freecad_tool:
        read = read_freecad_tool(json, unit);
        break;
    case LibraryFormat::freecad_library:
        read = read_freecad_library(json, unit, files);
        break;
    case LibraryFormat::freecad_holder:
        read = read_freecad_holder(json);
        break;
    case LibraryFormat::camotics:
        read = read_camotics(json);
        break;
    case LibraryFormat::kiri:
        read = read_kiri(json);
        break;
    case LibraryFormat::facetmill:
        read = read_own(json, name);
        break;
    default:
        read = read_fusion(json);
        break;
    }
    read.format = format;
    return read;
}

ReadLibrary read_as(std::string_view bytes, const std::string& name, LibraryFormat format, LengthUnit unit,
                    const NamedFiles& files) {
    if (format == LibraryFormat::linuxcnc) {
        ReadLibrary read = read_linuxcnc(bytes, name, unit);
        read.format = format;
        return read;
    }
    if (format != LibraryFormat::fusion_archive) return read_json(bytes, name, format, unit, files);
    for (const ArchiveFile& file : read_archive(bytes, name))
        if (file.name == packed_name) {
            ReadLibrary read =
                read_json(file.bytes, name + ": " + packed_name, LibraryFormat::fusion, unit, files);
            read.format = format;
            return read;
        }
    throw Error(ErrorCode::not_found, name, std::string("holds no ") + packed_name,
                "export the library anew");
}

std::string write_one(const ToolLibrary& library, LibraryFormat format, std::vector<std::string>& remarks) {
    switch (format) {
    case LibraryFormat::facetmill:
        return write_own(library);
    case LibraryFormat::fusion:
        return write_fusion(library, remarks);
    case LibraryFormat::fusion_archive: {
        const std::string json = write_fusion(library, remarks);
        return json.empty() ? json : archive_bytes({{packed_name, json}});
    }
    case LibraryFormat::linuxcnc:
        return write_linuxcnc(library, remarks);
    case LibraryFormat::camotics:
        return write_camotics(library, remarks);
    case LibraryFormat::kiri:
        return write_kiri(library, remarks);
    case LibraryFormat::freecad_tool:
        if (library.tools.size() > 1)
            throw Error(ErrorCode::limit_exceeded, "tools", "a .fctb file has one tool",
                        "name the tool, or write a .fctl library");
        return library.tools.empty() ? std::string()
                                     : write_freecad_tool(library.tools[0], library.unit, remarks);
    case LibraryFormat::freecad_holder: {
        std::vector<ToolHolder> holders = library.holders;
        for (const LibraryTool& t : library.tools)
            if (!t.holder.outline.empty()) holders.push_back(t.holder);
        if (holders.size() > 1)
            throw Error(ErrorCode::limit_exceeded, "tools", "a .fcholder file has one holder",
                        "name the tool");
        return holders.empty() ? std::string() : write_freecad_holder(holders[0], library.unit);
    }
    case LibraryFormat::freecad_library:
        break;
    }
    return {};
}

} // namespace

const std::vector<std::string>& library_format_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const FormatInfo& f : formats)
            list.emplace_back(f.name);
        return list;
    }();
    return names;
}

LibraryFormat library_format(std::string_view name, const std::string& where) {
    std::string known;
    for (const FormatInfo& f : formats) {
        if (name == f.name) return f.format;
        known += (known.empty() ? "" : ", ") + std::string(f.name);
    }
    throw Error(ErrorCode::out_of_range, where, "'" + printable(name) + "' is no format of a tool library",
                "use one of " + known);
}

LibraryFormat format_of(const fs::path& file) {
    const std::string end = in_small_letters(file.extension().string());
    for (const FormatInfo& f : formats)
        if (end == f.end) return f.format;
    throw Error(ErrorCode::unsupported_format, printable(file.string(), 400),
                "is no tool library by its name",
                "use .fmtools, .fctb, .fctl, .fcholder, .json, .tools or .tbl");
}

ReadLibrary read_library(std::string_view bytes, const std::string& name, LengthUnit unit,
                         const NamedFiles& files) {
    ReadLibrary read = read_as(bytes, name, format_of(fs::path(name)), unit, files);
    if (read.library.name.empty()) read.library.name = printable(fs::path(name).stem().string(), 200);
    if (read.library.tools.empty() && read.library.holders.empty()) {
        std::string why =
            read.remarks.empty() ? "holds no tool" : "holds no tool that can be used: " + read.remarks[0];
        throw Error(ErrorCode::empty_result, name, std::move(why), "give a library of milling tools");
    }
    return read;
}

ReadLibrary load_library(const fs::path& file, LengthUnit unit) {
    const InputFile input(file);
    const NamedFiles beside = [&](const std::string& name) -> std::optional<std::string> {
        const fs::path plain = fs::path(name).filename(); // wherever the library's author had it
        const fs::path here = file.parent_path(), above = fs::absolute(file).parent_path().parent_path();
        for (const fs::path& folder : {here, here / "Bit", here / "bit", above / "Bit", above / "bit"}) {
            std::error_code ec;
            if (!plain.empty() && fs::is_regular_file(folder / plain, ec))
                return std::string(InputFile(folder / plain).bytes());
        }
        return std::nullopt;
    };
    return read_library(input.bytes(), printable(file.string(), 400), unit, beside);
}

WrittenLibrary write_library(const ToolLibrary& library, LibraryFormat format, const std::string& name) {
    WrittenLibrary written;
    if (format == LibraryFormat::freecad_library) {
        written = write_freecad_library(library, name);
    } else {
        written.files.push_back({name, {}});
        written.files[0].bytes = write_one(library, format, written.remarks);
    }
    if (written.files[0].bytes.empty()) {
        std::string why = "there is nothing that this format can carry";
        if (!written.remarks.empty()) why += ": " + written.remarks[0];
        throw Error(ErrorCode::empty_result, name, std::move(why), "choose another format or other tools");
    }
    return written;
}

std::vector<KeptLibrary> kept_libraries(const fs::path& folder) {
    std::vector<KeptLibrary> kept;
    std::error_code ec;
    for (const auto& entry : fs::directory_iterator(folder, ec))
        if (entry.path().extension() == ".fmtools") kept.push_back({entry.path(), {}, {}});
    std::sort(kept.begin(), kept.end(),
              [](const KeptLibrary& a, const KeptLibrary& b) { return a.file < b.file; });
    for (KeptLibrary& one : kept) {
        try {
            one.library = load_library(one.file, LengthUnit::mm).library;
        } catch (const Error& e) {
            one.trouble = e.what();
        }
    }
    return kept;
}

fs::path keep_library(const ToolLibrary& library, const fs::path& folder, const std::string& name,
                      const std::function<void(const fs::path&)>& before) {
    std::error_code ec;
    fs::create_directories(folder, ec);
    fs::path place;
    for (int k = 1; place.empty() || fs::exists(fs::symlink_status(place, ec)); ++k)
        place = folder / (name + (k > 1 ? " " + std::to_string(k) : std::string()) + ".fmtools");
    OutputFile file(place);
    file.write(write_library(library, LibraryFormat::facetmill, place.filename().string()).files[0].bytes);
    if (before) before(place);
    file.commit();
    return place;
}

fs::path user_library_folder() {
    if (const char* data = std::getenv("XDG_DATA_HOME"); data && *data)
        return fs::path(data) / "facetmill" / "tools";
    const char* home = std::getenv("HOME");
    return (home && *home ? fs::path(home) : fs::current_path()) / ".local" / "share" / "facetmill" / "tools";
}

} // namespace facetmill
