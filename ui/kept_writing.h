// What a document has now, written into its kept folder; in a thread of its own.
#pragma once

#include "core/job/planner.h"
#include "ui/kept_files.h"

#include <QString>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace facetmill::ui {

/// Which file a plan or a verification is kept in.
using KeptAs = std::vector<std::pair<std::shared_ptr<const void>, std::string>>;

struct KeptWriting {
    struct Plan {
        std::size_t setup = 0, operation = 0;
        std::shared_ptr<const OperationResult> result; ///< null: planning came to none
        std::string failure;                           ///< why, then
        std::string fingerprint;                       ///< as planned; empty: of other values
        std::string kept_as;                           ///< of other values: its file; empty: it has none
    };
    KeptFolder folder;
    Project project;
    std::vector<Plan> plans;
    std::map<std::size_t, std::shared_ptr<const PreparedPart>> parts;  ///< by setup
    std::map<std::size_t, std::shared_ptr<const CarriedStock>> stocks; ///< with which setups begin
    std::shared_ptr<const VerificationOutcome> verdict;                ///< that is shown, and current
    std::shared_ptr<const VerificationOutcome> stale_verdict;          ///< of one setup, out of date
    std::string stale_verdict_as;                                      ///< its file; empty: it has none
    std::vector<int> ids;                                              ///< of the shown setup
    bool saved = false; ///< the project is on disk as it is: what is of no use to it goes
    // What became of it.
    std::size_t written = 0;
    bool too_much = false;
    QString failed;
    KeptAs kept_as;

    void run(FileContents& contents, const Progress& progress);

private:
    using Bytes = std::function<std::string()>;
    void write(const std::string& name, const std::shared_ptr<const void>& what, const Bytes& bytes,
               const Progress& progress);
    /// A few words, which may be others than before.
    void write_words(const std::string& name, const std::string& words, const Progress& progress) const;
    void write_plan(const Plan& plan, const KeptNames& names, const Progress& progress);
    void write_stale(const KeptNames& names, const Progress& progress);
    void write_verdict(const VerificationOutcome& of, const std::string& name, const Progress& progress);
};

} // namespace facetmill::ui
