#include "ui/kept_writing.h"

#include "core/job/kept_result.h"
#include "core/job/setup_plan.h"
#include "ui/document_keys.h"
#include "ui/worded.h"

namespace facetmill::ui {

void KeptWriting::write(const std::string& name, const std::shared_ptr<const void>& what, const Bytes& bytes,
                        const Progress& progress) {
    kept_as.emplace_back(what, name);
    if (folder.has(name)) return;
    if (folder.write(name, bytes(), progress))
        ++written;
    else
        too_much = true;
}

void KeptWriting::write_words(const std::string& name, const std::string& words,
                              const Progress& progress) const {
    if (folder.read(name, progress) != words) folder.write(name, words, progress);
}

void KeptWriting::write_plan(const Plan& plan, const KeptNames& names, const Progress& progress) {
    const Project view = view_of_setup(project, plan.setup);
    // What its files are now is what they were then.
    if (fingerprint(view, plan.operation) != plan.fingerprint) return;
    if (!plan.result) return write_words(names.failure(view, plan.operation), plan.failure, progress);
    write(
        names.plan(view, plan.operation), plan.result,
        [&] { return result_bytes(*plan.result, *parts.at(plan.setup), progress); }, progress);
}

void KeptWriting::write_verdict(const VerificationOutcome& of, const std::string& name,
                                const Progress& progress) {
    write(
        name, of.verification,
        [&] {
            return verdict_bytes({of.posted_blocks, of.verification}, progress);
        },
        progress);
}

void KeptWriting::write_stale(const KeptNames& names, const Progress& progress) {
    for (const Plan& plan : plans) {
        if (!plan.fingerprint.empty()) continue;
        const Project view = view_of_setup(project, plan.setup);
        std::string name = plan.kept_as;
        if (name.empty() || !folder.has(name)) {
            const std::string bytes = result_bytes(*plan.result, *parts.at(plan.setup), progress);
            name = folder.name_of("plan", bytes);
            write(
                name, plan.result, [&] { return bytes; }, progress);
        }
        write_words(names.stale_plan(view, plan.operation), name, progress);
    }
    if (!stale_verdict) return;
    std::string name = stale_verdict_as;
    if (name.empty() || !folder.has(name)) {
        const std::string bytes =
            verdict_bytes({stale_verdict->posted_blocks, stale_verdict->verification}, progress);
        name = folder.name_of("verdict", bytes);
        write(
            name, stale_verdict->verification, [&] { return bytes; }, progress);
    }
    write_words(names.stale_verdict(project),
                stale_verdict_bytes(stale_verdict_of(*stale_verdict, name, ids)), progress);
}

void KeptWriting::run(FileContents& contents, const Progress& progress) {
    try {
        const KeptNames names(folder, contents.texts(progress));
        // Out of date is only what the saved project finds so; its files stay.
        if (saved) write_stale(names, progress);
        if (saved && !folder.empty()) folder.keep_only(names.all(project, progress));
        for (const Plan& plan : plans)
            if (!plan.fingerprint.empty()) write_plan(plan, names, progress);
        for (const auto& [setup, stock] : stocks) {
            const Project view = view_of_setup(project, setup);
            if (stock->source != stock_source(view)) continue;
            write(
                names.rest(view), stock, [&, s = stock] { return carried_bytes(*s, progress); }, progress);
        }
        if (!verdict) return;
        std::vector<std::size_t> setups;
        for (const JudgedSetup& setup : verdict->setups)
            setups.push_back(setup.place);
        write_verdict(*verdict,
                      setups.size() > 1 ? names.verdict(project, setups)
                                        : names.verdict(project, verdict->setups.front().ids.size()),
                      progress);
    } catch (const Error& e) {
        failed = worded(e);
    } catch (const Cancelled&) {
        return; // nobody can
    }
}

} // namespace facetmill::ui
