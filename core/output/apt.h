// APT CL files: written strictly (lines at most 72 characters, '$' continues, IPM/MMPM, RAPID before each rapid motion,
// MULTAX/ON with i, j, k on every GOTO of a multi-axis path, FINI at the end), read tolerantly (Lu's Appendix B too).
#pragma once

#include "core/base/file.h"
#include "core/base/progress.h"
#include "core/output/cl_program.h"

#include <filesystem>
#include <string_view>

namespace facetmill {

/// Throws Error(unwritable, non_finite, empty_result). Coordinates carry six decimals;
/// see the rounding note in apt_writer.cpp.
void write_apt(const ClProgram& program, OutputFile& file, const Progress& progress);

struct AptReadResult {
    ClProgram program;
    std::vector<std::string> ignored; ///< statements that were read over, once each, with their first line number
    bool had_cutter = false;
};
/// Throws Error(syntax, non_finite, encoding, empty_result, ...) that names file and line.
AptReadResult read_apt(const std::filesystem::path& path, LengthUnit default_unit, const Progress& progress);

} // namespace facetmill
