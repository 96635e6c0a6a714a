// What is kept of a project, read in a job: plans, what setups begin with, and verdicts.
#pragma once

#include "core/job/kept_result.h"
#include "core/job/setup_plan.h"
#include "ui/document.h"
#include "ui/kept_writing.h"

#include <QStringList>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace facetmill::ui {

struct KeptReading {
    KeptFolder folder;
    Project project;
    std::vector<std::vector<int>> ids;        ///< of the operations of each setup
    std::shared_ptr<const PreparedPart> part; ///< of the shown setup
    // What there is.
    std::vector<OperationOutcome> outcomes; ///< those of other values have `other_values` for a fingerprint
    std::vector<std::shared_ptr<const VerificationOutcome>> verdicts;
    QStringList damaged; ///< names of operations
    KeptAs kept_as;

    static constexpr const char* other_values = "other values";

    void run(Planner& planner, SetupPlanners& planners, FileContents& contents, const Progress& progress);

private:
    struct Setup {
        Project view;
        std::shared_ptr<const PreparedPart> part;
        std::vector<std::shared_ptr<const OperationResult>> results; ///< of the operations, as they stand
        std::size_t complete = 0; ///< so many of them are planned as they stand, or switched off
    };
    Setup read_setup(std::size_t setup, Planner& planner, Planner* shown, const KeptNames& names,
                     const Progress& progress);
    /// Null where it is damaged.
    std::shared_ptr<const OperationResult> read_plan(const std::string& name, const Setup& setup,
                                                     std::size_t operation, const Progress& progress);
    void read_verdict(const Setup& setup, const KeptNames& names, const Progress& progress);
    void read_stale_verdict(const Setup& setup, const KeptNames& names, const Progress& progress);
    /// That on setups which were judged as one job; false where there is none.
    bool read_verdict(const std::vector<Setup>& setups, const std::vector<std::size_t>& together,
                      const KeptNames& names, const Progress& progress);
    std::optional<KeptVerdict> read_verification(const std::string& name, const Progress& progress);
};

} // namespace facetmill::ui
