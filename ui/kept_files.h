// Which files of a kept folder (core/job/kept_folder.h) hold what of a project.
#pragma once

#include "core/base/keyed_hash.h"
#include "core/job/kept_folder.h"
#include "core/job/project.h"
#include "ui/verification_model.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace facetmill::ui {

/// The content of files, as text, each looked at once as it is on disk.
class FileContents {
public:
    explicit FileContents(const HashKey& key) : key_(key) {}
    /// Throws what InputFile does.
    std::string text(const std::filesystem::path& path, const Progress& progress);
    /// For document_keys.h; only as long as this and the progress live.
    FileText texts(const Progress& progress) {
        return [this, &progress](const std::filesystem::path& path) { return text(path, progress); };
    }

private:
    HashKey key_;
    std::mutex mutex_;
    std::map<std::string, std::string> known_; ///< by stamp
};

/// Names of files, by what their content was made from. `view`: the view on a setup.
class KeptNames {
public:
    KeptNames(const KeptFolder& folder, FileText texts) : folder_(folder), texts_(std::move(texts)) {}

    std::string plan(const Project& view, std::size_t operation) const;
    std::string failure(const Project& view, std::size_t operation) const;
    /// Its bytes are the name of the plan of other values that an operation still has.
    std::string stale_plan(const Project& view, std::size_t operation) const;
    /// That on the first `operations` of a setup.
    std::string verdict(const Project& view, std::size_t operations) const;
    /// That on setups which were judged as one job.
    std::string verdict(const Project& project, const std::vector<std::size_t>& setups) const;
    /// Says which verdict on other values a setup still has.
    std::string stale_verdict(const Project& view) const;
    std::string rest(const Project& view) const;
    /// All that a project can have kept.
    std::set<std::string> all(const Project& project, const Progress& progress) const;

private:
    void add_stale_verdict(const Project& view, std::set<std::string>& all, const Progress& progress) const;

    const KeptFolder& folder_;
    FileText texts_;
};

/// The setups that are judged as one job with this one: those that cut its stock, without those whose
/// operations are all switched off.
std::vector<std::size_t> judged_together(const Project& project, std::size_t setup);

/// A verdict on values that a setup had before: what an outcome says beside its verification.
struct StaleVerdict {
    std::string name; ///< of the file of its verification
    struct Program {
        std::string name;
        std::int64_t operation = -1; ///< place in the setup; -1: it is gone
        std::uint64_t index = 0;
    };
    std::vector<Program> programs;
    std::vector<std::int64_t> operations; ///< that were judged, likewise
    std::string part_key, last;
    double across = 0;
};
std::string stale_verdict_bytes(const StaleVerdict& verdict);
/// Throws Error where the bytes are none.
StaleVerdict stale_verdict_from(std::string_view bytes);
/// What an outcome on one setup says, whose operations are these.
StaleVerdict stale_verdict_of(const VerificationOutcome& outcome, std::string name,
                              const std::vector<int>& ids);

} // namespace facetmill::ui
