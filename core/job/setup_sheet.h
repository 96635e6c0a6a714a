// The setup sheet: what the person at the machine has to know of a planned project, as one HTML file that is
// complete in itself and prints on paper.
#pragma once

#include "core/job/chain_verification.h"
#include "core/job/planner.h"
#include "core/job/verification.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace facetmill {

/// A PNG file's bytes, and what stands below it.
struct SheetPicture {
    std::string caption, png;
};

/// What a sheet speaks: texts of core, which is English, and their numbers in other words; English without.
struct SheetLanguage {
    std::string code = "en"; ///< as HTML names it
    std::function<std::string(const std::string& english)> words;
};

/// Verdict, pictures, part and stock with their places, machine, tools, operations with their programs' files
/// and times, warnings, and the figures of the verification; lengths in the project's units. Text from the
/// project is escaped. The same text for the same input; no time of day. `programs` are those that were
/// verified.
std::string setup_sheet(const Project& project, const PlanResult& plan,
                        std::span<const VerifyProgram> programs, const Verification& verification,
                        std::span<const SheetPicture> pictures, const SheetLanguage& language = {});

/// The sheet of several setups: the verdict on them all, then for each its name, how it holds the part, and
/// what the sheet of a single one has; the figures of the verification at the end. `pictures`: for each
/// setup.
std::string setup_sheet(std::span<const JudgedChain> chains,
                        const std::vector<std::vector<SheetPicture>>& pictures,
                        const SheetLanguage& language = {});

} // namespace facetmill
