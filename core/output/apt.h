// APT CL files: written strictly (lines at most 72 characters, '$' continues, IPM/MMPM, RAPID before each
// rapid motion, MULTAX/ON with i, j, k on every GOTO of a multi-axis path, FINI at the end), read tolerantly
// (Lu's Appendix B too).
#pragma once

#include "core/base/file.h"
#include "core/base/progress.h"
#include "core/output/cl_program.h"
#include "core/output/program_writer.h"

#include <filesystem>
#include <string_view>

namespace facetmill {

/// Throws what check_writable throws before it writes anything, and Error(unwritable); the caller commits the
/// file. Coordinates carry six decimals of the file's unit; see the rounding note in apt_writer.cpp.
void write_apt(const ClProgram& program, OutputFile& file, const Progress& progress);

/// The writer of this format, with its name, label and extension.
const ProgramWriter& apt_writer();

struct AptReadResult {
    ClProgram program;
    /// What the file says of a section's tool.
    struct Tool {
        bool cutter = false, number = false; ///< CUTTER; LOADTL or TOOLNO with a number
    };
    std::vector<Tool> tools; ///< one per section
    std::vector<std::string>
        ignored; ///< statements that were read over, once each, with their first line number
};
/// Reads straight motion: GOTO, FROM (a rapid), GODLTA, RAPID, with TLAXIS or i, j, k; UNITS, CUTTER,
/// LOADTL/TOOLNO, FEDRAT, SPINDL, COOLNT, names. Words that would change the path (arcs, cycles, cutter
/// compensation, transformations, loops) are refused, all others are read over and listed. A file that ends
/// within a statement or, without FINI or END, within a line is refused as truncated; one that merely lacks
/// FINI is read and listed. `default_unit` counts until UNITS.
///
/// Another tool number or cutter begins a section, as does a comment "OPERATION NAME : ..." between motions.
/// A section with the tool of the one before begins where that ended: its first motion is a rapid to there.
/// One with another tool begins anywhere. Motion that is not rapid comes back as `cut`, the first of a tool
/// as `rapid`. Each section has the speed and coolant of its first cut: changes of these are listed; feeds
/// may change from motion to motion. Throws Error(syntax, truncated, encoding, coordinate_range,
/// out_of_range, unsupported_format, empty_result, files) that names file and line.
AptReadResult read_apt(const std::filesystem::path& path, LengthUnit default_unit, const Progress& progress);
/// The same from memory; `name` stands for the path in messages.
AptReadResult parse_apt(std::string_view text, const std::string& name, LengthUnit default_unit,
                        const Progress& progress);

} // namespace facetmill
