// The verdict on a project of several setups: each chain of them (setup_plan.h) is judged as one job, in the
// coordinates of its first setup.
#pragma once

#include "core/job/setup_plan.h"
#include "core/job/verification.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace facetmill {

struct JudgedChain {
    std::span<const SetupPlan> setups;
    ChainPrograms programs;
    std::shared_ptr<const Verification> result;
    std::size_t posted_blocks = 0; ///< of posted programs that were judged; 0: the plans were
};

/// `programs`: those of each setup in its own coordinates, planned or read back. Throws what verify does.
JudgedChain judge_chain(std::span<const SetupPlan> setups,
                        std::span<const std::vector<VerifyProgram>> programs, const VerifySettings& settings,
                        const Progress& progress);

/// What the setups' controls will run (programs_to_judge) is judged; findings name motions of the plans.
/// Throws what that and verify do, within "setup 'Bottom'".
JudgedChain judge_posted_chain(std::span<const SetupPlan> setups, const VerifySettings& settings,
                               const Progress& progress);

/// The worst of them.
Verdict verdict_of(std::span<const JudgedChain> chains);
/// findings_line of each.
std::string findings_line(std::span<const JudgedChain> chains);

/// verify.json of several setups. One chain: that of a single setup, with `setups[]` (name, verdict,
/// operations) besides. More: `verdict`, the worst, and `stocks[]`, such an object for each, with the names
/// of its files.
std::string chains_json(std::span<const JudgedChain> chains);

/// The names of the files that are written: stock.stl, deviation.vtp; of more than one chain stock-1.stl and
/// so on; and verify.json.
std::vector<std::string> chain_file_names(std::size_t chains);
/// As write_verification.
std::vector<std::filesystem::path> write_chains(std::span<const JudgedChain> chains,
                                                const std::filesystem::path& folder, const Progress& progress,
                                                const std::function<void()>& before = {});

} // namespace facetmill
