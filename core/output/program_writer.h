// Program writers: what turns a CL program into files for a machine or another system. One file per writer;
// it registers itself by a line
//
//     const ProgramWriterRegistration registration({.name = "apt", .label = "APT", ...});
//
// and planning, the command line and the workbench write its files and know their extension.
#pragma once

#include "core/base/file.h"
#include "core/base/progress.h"
#include "core/output/cl_program.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill {

struct ProgramWriter {
    std::string name;      ///< "apt": what it is asked for by
    std::string label;     ///< "APT": what users read
    std::string extension; ///< with the dot
    /// The files of a program: what each has between the program's name and the extension, often nothing.
    /// Empty where this writer has nothing to say about the program.
    std::function<std::vector<std::string>(const ClProgram& program)> files;
    /// Writes the text of one of them; the caller commits the file. The same program gives the same bytes: no
    /// time stamp. Throws what check_writable throws before it writes anything, Error(unwritable).
    std::function<void(const ClProgram& program, std::size_t file, OutputFile& out, const Progress& progress)>
        write;
};

/// In alphabetical order of `name`.
const std::vector<ProgramWriter>& program_writers();
/// Throws Error(out_of_range) that lists the known writers.
const ProgramWriter& program_writer(std::string_view name);

struct ProgramWriterRegistration {
    explicit ProgramWriterRegistration(ProgramWriter writer);
};

} // namespace facetmill
