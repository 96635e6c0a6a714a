// Verification of a project: what the verifier is given, and what it leaves on disk.
#pragma once

#include "core/base/file.h"
#include "core/job/planner.h"
#include "core/verify/verify.h"

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace facetmill {

/// One program per planned operation. Motions are shared with the plan, not copied.
std::vector<VerifyProgram> verify_programs(const Project& project,
                                           const std::shared_ptr<const PlanResult>& plan);

/// The feeds that a section of a program has.
void set_feeds(VerifyProgram& program, const ClSection& section);

/// Puts the fixtures of the part's setup into programs that run in it.
void stand_fixtures(std::vector<VerifyProgram>& programs, const PreparedPart& part);

/// Length of the motions at feed of each planned program in which its cutter meets nothing of the stock as it
/// stands then, mm: what the upright rays of a StockModel say that is cut with the programs; coarser than for
/// `verify`, which is not in a hurry. Empty where the stock has no volume.
std::vector<double> feed_in_air(const Project& project, const std::shared_ptr<const PlanResult>& plan,
                                const Progress& progress);

/// But for the length of the flutes, to what a CL file's digits say.
bool same_shape(const AptCutter& a, const AptCutter& b);

/// A CL file as programs to verify: one per operation and tool in it.
struct ClFilePrograms {
    std::vector<VerifyProgram> programs;
    std::vector<std::shared_ptr<const ClSection>> sections; ///< one for each program
    std::vector<std::string> ignored;                       ///< statements that were read over
    std::vector<std::string> remarks; ///< one sentence each: shank and holder are not known, or were guessed
};
/// Cutters of the file's CUTTER statements; shank and holder of the project's tool of the file's number, if
/// there is one. A file that names no tool is one of tool 1 only if that has its cutter. Throws what read_apt
/// does, and Error(missing_key) without CUTTER.
ClFilePrograms read_verify_programs(const Project& project, const std::filesystem::path& path,
                                    const Progress& progress);

/// Tolerance and allowance of the last operation, planned or without a plan (null) the project's, of those
/// that leave the least; the limits of the project. A gouge limit of `auto` is twice the largest chord
/// tolerance that operations keep which leave no more on purpose than that one, at least 1e-4 mm.
VerifySettings verify_settings(const Project& project, const PlanResult* plan);

/// verify.json as the contract says, in the project's units: lengths in `units`, angles in degrees, seconds.
std::string verify_json(const Project& project, std::span<const VerifyProgram> programs,
                        const Verification& result);

/// "verified", "failed", "not_judged".
std::string verdict_name(Verdict verdict);
/// " in the stock", " in the fixture 'Clamp'": what a tool came into.
std::string touched_text(const Collision& collision);
/// "the tool of 'Rough' fits but does not go there": why surface stays uncut.
std::string uncut_reason_text(const UncutReason& reason);

/// One line: the deepest gouge and the first collision, with operation and GOTO, what is uncut and why, or
/// why nothing can be said. Empty where all is well.
std::string findings_line(const Project& project, std::span<const VerifyProgram> programs,
                          const Verification& result);

/// The stock as it is left (closed) and the deviation into a set of files, see write_verification.
void add_verification(OutputSet& files, const Project& project, const Verification& result,
                      const std::filesystem::path& stock, const std::filesystem::path& deviation,
                      const Progress& progress);

/// Writes stock.stl (closed), deviation.vtp (VTK PolyData: points, `Normals`, `deviation`, `flag`) and
/// verify.json into `folder` (made if missing), lengths in the project's units: all of them or none, and
/// never over a file that the project reads. `before` as in write_plan. Returns the paths. Throws
/// Error(unwritable, no_facets where nothing of the stock is left).
std::vector<std::filesystem::path>
write_verification(const Project& project, std::span<const VerifyProgram> programs,
                   const Verification& result, const std::filesystem::path& folder, const Progress& progress,
                   const std::function<void()>& before = {});

} // namespace facetmill
