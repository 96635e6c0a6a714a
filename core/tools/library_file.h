// Files of tool libraries, ours and those of the programs that users come from.
#pragma once

#include "core/tools/tool_library.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

enum class LibraryFormat {
    facetmill,       ///< .fmtools: everything that a ToolLibrary has
    freecad_tool,    ///< .fctb: one tool
    freecad_library, ///< .fctl: numbers and the files of tools, which lie beside it or in ../Bit
    freecad_holder,  ///< .fcholder: the outline of a holder
    fusion,          ///< .json as exported: "data" is a list of tools
    fusion_archive,  ///< .tools: the same packed
    linuxcnc,        ///< .tbl: numbers, diameters and remarks
    camotics,        ///< .json of tools by their numbers
    kiri,            ///< .json, a list of tools
};
/// "facetmill", "freecad-tool", "freecad-library", "freecad-holder", "fusion", "fusion-archive", "linuxcnc",
/// "camotics", "kirimoto"; in the order of the enumerators.
const std::vector<std::string>& library_format_names();
/// By its name. Throws Error(out_of_range) that names `where`.
LibraryFormat library_format(std::string_view name, const std::string& where);
/// By the end of a file's name; .json is Fusion's. Throws Error(unsupported_format).
LibraryFormat format_of(const std::filesystem::path& file);

/// What a file held, and every field of it that could not be carried: "T3 'Bull 6': start-values.presets[0]
/// .f_n is not carried".
struct ReadLibrary {
    ToolLibrary library;
    LibraryFormat format = LibraryFormat::facetmill;
    std::vector<std::string> remarks;
};

/// A file that another one names, by what it is called there: its bytes; none where there is no such file.
using NamedFiles = std::function<std::optional<std::string>(const std::string& name)>;

/// A library from its bytes; `name` is what errors call the file. The format follows from the name's end,
/// that of a .json from what it holds. `unit` is for files that do not say theirs (.tbl, .fctb numbers
/// without a unit). Throws Error(syntax, wrong_type, missing_key, out_of_range, unsupported_format,
/// empty_result, not_found).
ReadLibrary read_library(std::string_view bytes, const std::string& name, LengthUnit unit,
                         const NamedFiles& files = {});
/// The same from a file on disk, with those that it names.
ReadLibrary load_library(const std::filesystem::path& file, LengthUnit unit);

/// What is to be written, file by file, and every field that the format cannot carry.
struct WrittenLibrary {
    struct File {
        std::string name; ///< beside the library's own, which is the first
        std::string bytes;
    };
    std::vector<File> files;
    std::vector<std::string> remarks;
};
/// `name`: of the library's own file. Throws Error(empty_result) where the format can carry none of the
/// tools, Error(limit_exceeded) for several tools in a format for one.
WrittenLibrary write_library(const ToolLibrary& library, LibraryFormat format, const std::string& name);

/// A library in a user's folder, or why it cannot be read.
struct KeptLibrary {
    std::filesystem::path file;
    ToolLibrary library;
    std::string trouble;
};
/// Those of a folder, by their names; none where there is no folder.
std::vector<KeptLibrary> kept_libraries(const std::filesystem::path& folder);
/// Writes a library into the folder, which is made where there is none, under the name or, where that is
/// taken, with a number behind it. `before` runs when the file is complete and has not appeared. Throws
/// Error(unwritable) and what `before` throws.
std::filesystem::path keep_library(const ToolLibrary& library, const std::filesystem::path& folder,
                                   const std::string& name,
                                   const std::function<void(const std::filesystem::path&)>& before = {});

/// Where a user's own libraries lie: $XDG_DATA_HOME/facetmill/tools, or ~/.local/share/facetmill/tools.
std::filesystem::path user_library_folder();

} // namespace facetmill
