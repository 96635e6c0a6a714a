#include "ui/kept_files.h"

#include "core/base/byte_coder.h"
#include "core/base/file.h"
#include "core/job/asked_operations.h"
#include "core/job/setup_plan.h"
#include "ui/document_keys.h"
#include "ui/text.h"

#include <algorithm>

namespace facetmill::ui {

namespace fs = std::filesystem;

template <class Coder, CodedAs<StaleVerdict::Program> T>
void code_fields(Coder& coder, T& v) {
    auto& [name, operation, index] = v;
    coder(name, operation, index);
}
template <class Coder, CodedAs<StaleVerdict> T>
void code_fields(Coder& coder, T& v) {
    auto& [name, programs, operations, part_key, last, across] = v;
    coder(name, programs, operations, part_key, last, across);
}

std::string FileContents::text(const fs::path& path, const Progress& progress) {
    const std::string stamp = file_stamp(path);
    {
        const std::lock_guard lock(mutex_);
        if (const auto it = known_.find(stamp); it != known_.end()) return it->second;
    }
    std::string text = content_text(path, key_, progress);
    if (file_stamp(path) != stamp)
        throw Error(ErrorCode::unreadable, path.string(), "it was written meanwhile", "try again");
    const std::lock_guard lock(mutex_);
    return known_[stamp] = std::move(text);
}

std::string KeptNames::plan(const Project& view, std::size_t operation) const {
    return folder_.name_of("plan", fingerprint(view, operation, texts_));
}

std::string KeptNames::failure(const Project& view, std::size_t operation) const {
    return folder_.name_of("failure", fingerprint(view, operation, texts_));
}

std::string KeptNames::stale_plan(const Project& view, std::size_t operation) const {
    return folder_.name_of("stale plan", fingerprint(view, operation, texts_));
}

std::string KeptNames::verdict(const Project& view, std::size_t operations) const {
    return folder_.name_of("verdict", verdict_source(view, operations, texts_));
}

std::string KeptNames::verdict(const Project& project, const std::vector<std::size_t>& setups) const {
    std::string source;
    for (const std::size_t k : setups) {
        const Project view = view_of_setup(project, k);
        const std::string own = verdict_source(view, view.operations.size(), texts_);
        source += std::to_string(k) + ':' + std::to_string(own.size()) + ':' + own;
    }
    return folder_.name_of("verdict", source);
}

std::string KeptNames::stale_verdict(const Project& view) const {
    return folder_.name_of("stale verdict", verdict_source(view, view.operations.size(), texts_));
}

std::string KeptNames::rest(const Project& view) const {
    return folder_.name_of("rest", stock_source(view, texts_));
}

std::set<std::string> KeptNames::all(const Project& project, const Progress& progress) const {
    std::set<std::string> all;
    // What was planned and judged of other values stays as long as it is shown.
    for (std::size_t k = 0; k < setup_count(project); ++k) {
        const Project view = view_of_setup(project, k);
        for (std::size_t i = 0; i < view.operations.size(); ++i) {
            all.insert({plan(view, i), failure(view, i), verdict(view, i + 1)});
            const std::string stale = stale_plan(view, i);
            if (const auto named = folder_.has(plan(view, i)) ? std::nullopt : folder_.read(stale, progress))
                all.insert({stale, *named});
        }
        if (!view.operations.empty()) all.insert(rest(view));
        if (!folder_.has(verdict(view, view.operations.size()))) add_stale_verdict(view, all, progress);
        if (const auto together = judged_together(project, k); together.size() > 1)
            all.insert(verdict(project, together));
    }
    return all;
}

void KeptNames::add_stale_verdict(const Project& view, std::set<std::string>& all,
                                  const Progress& progress) const {
    const std::string name = stale_verdict(view);
    const auto bytes = folder_.read(name, progress);
    if (!bytes) return;
    try {
        all.insert({name, stale_verdict_from(*bytes).name});
    } catch (const Error&) {
        // It says nothing.
    }
}

std::vector<std::size_t> judged_together(const Project& project, std::size_t setup) {
    const auto [first, last] = setups_of_stock(project, setup);
    std::vector<std::size_t> setups;
    for (std::size_t k = first; k < last; ++k)
        if (!operations_on(setup_at(project, k)).empty()) setups.push_back(k);
    return setups;
}

std::string stale_verdict_bytes(const StaleVerdict& verdict) {
    ByteWriter writer;
    writer(verdict);
    return writer.take();
}

StaleVerdict stale_verdict_from(std::string_view bytes) {
    ByteReader reader(bytes);
    StaleVerdict verdict;
    reader(verdict);
    reader.end();
    return verdict;
}

StaleVerdict stale_verdict_of(const VerificationOutcome& outcome, std::string name,
                              const std::vector<int>& ids) {
    const auto place = [&](int id) {
        const auto it = std::find(ids.begin(), ids.end(), id);
        return it == ids.end() ? std::int64_t(-1) : std::int64_t(it - ids.begin());
    };
    StaleVerdict verdict;
    verdict.name = std::move(name);
    for (const JudgedProgram& p : outcome.programs)
        verdict.programs.push_back({p.name, place(p.id), p.index});
    for (const int id : outcome.setups.front().ids)
        verdict.operations.push_back(place(id));
    verdict.part_key = outcome.setups.front().part_key;
    verdict.last = utf8(outcome.last);
    verdict.across = outcome.across;
    return verdict;
}

} // namespace facetmill::ui
