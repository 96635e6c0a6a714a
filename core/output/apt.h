// APT CL files: written strictly (lines at most 72 characters, '$' continues, IPM/MMPM, RAPID before each
// rapid motion, MULTAX/ON with i, j, k on every GOTO of a multi-axis path, FINI at the end), read tolerantly
// (Lu's Appendix B too).
#pragma once

#include "core/base/file.h"
#include "core/base/progress.h"
#include "core/output/cl_program.h"

#include <filesystem>
#include <string_view>

namespace facetmill {

/// Throws Error(unwritable, non_finite, coordinate_range, out_of_range, empty_result) before it writes
/// anything; the caller commits the file. No time stamp: the same program gives the same bytes. Coordinates
/// carry six decimals of the file's unit; see the rounding note in apt_writer.cpp. Cancellation per 4096
/// motions.
void write_apt(const ClProgram& program, OutputFile& file, const Progress& progress);

struct AptReadResult {
    ClProgram program;
    std::vector<std::string>
        ignored; ///< statements that were read over, once each, with their first line number
    bool had_cutter = false, had_tool = false; ///< CUTTER; LOADTL or TOOLNO with a number
};
/// Reads straight motion: GOTO, FROM (a rapid), GODLTA, RAPID, with TLAXIS or i, j, k; UNITS, CUTTER,
/// LOADTL/TOOLNO, FEDRAT, SPINDL, names. Words that would change the path (arcs, cycles, cutter compensation,
/// transformations, loops) are refused, all others are read over and listed. One tool and one feed a program.
/// A file that ends within a statement or, without FINI or END, within a line is refused as truncated; one
/// that merely lacks FINI is read and listed. `default_unit` counts until UNITS. Motion that is not rapid
/// comes back as `cut`, the first motion as `rapid`. Throws Error(syntax, truncated, encoding,
/// coordinate_range, out_of_range, unsupported_format, empty_result, files) that names file and line.
/// Cancellation per 4096 lines.
AptReadResult read_apt(const std::filesystem::path& path, LengthUnit default_unit, const Progress& progress);
/// The same from memory; `name` stands for the path in messages.
AptReadResult parse_apt(std::string_view text, const std::string& name, LengthUnit default_unit,
                        const Progress& progress);

} // namespace facetmill
