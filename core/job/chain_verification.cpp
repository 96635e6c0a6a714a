#include "core/job/chain_verification.h"

#include "core/job/new_folder.h"
#include "core/job/posting.h"
#include "core/job/stock_solid.h"
#include "core/job/verify_object.h"

#include <algorithm>
#include <iterator>

namespace facetmill {

namespace fs = std::filesystem;

namespace {

const Project& project_of(const JudgedChain& chain) {
    return chain.setups.front().project;
}

Json setups_of(const JudgedChain& chain) {
    const Verification& v = *chain.result;
    Json setups = Json::array();
    for (std::size_t k = 0; k < chain.setups.size(); ++k) {
        Json operations = Json::array();
        bool found = false;
        for (std::size_t i = 0; i < chain.programs.setups.size(); ++i) {
            if (chain.programs.setups[i] != k) continue;
            operations.push_back(printable(chain.programs.programs[i].name, 200));
            found = found || v.program_gouges[i] > v.used.gouge_limit
                    || std::any_of(v.collisions.begin(), v.collisions.end(),
                                   [&](const Collision& c) { return c.at.program == i; });
        }
        setups.push_back(Json{{"name", printable(chain.setups[k].project.name, 200)},
                              {"verdict", verdict_name(v.verdict_where(found))},
                              {"operations", std::move(operations)}});
    }
    return setups;
}

Json chain_object(const JudgedChain& chain) {
    Json object = verify_object(project_of(chain), chain.programs.programs, *chain.result);
    object["setups"] = setups_of(chain);
    return object;
}

} // namespace

JudgedChain judge_chain(std::span<const SetupPlan> setups,
                        std::span<const std::vector<VerifyProgram>> programs, const VerifySettings& settings,
                        const Progress& progress) {
    JudgedChain chain{setups, chain_programs(setups, programs), nullptr};
    const PlanResult& first = *setups.front().plan;
    auto result = std::make_shared<Verification>(
        verify(*first.part->mesh, first.stock, chain.programs.programs, settings, progress));
    std::vector<std::string> remarks =
        stock_warnings(project_of(chain).stock, *first.part, project_of(chain).unit);
    if (std::string remark = tolerance_remark(setups); !remark.empty()) remarks.push_back(std::move(remark));
    result->remarks.insert(result->remarks.begin(), remarks.begin(), remarks.end());
    chain.result = std::move(result);
    return chain;
}

JudgedChain judge_posted_chain(std::span<const SetupPlan> setups, const VerifySettings& settings,
                               const Progress& progress) {
    std::vector<std::vector<VerifyProgram>> programs;
    PostedPrograms all; // of the chain, in its order; the programs themselves are in `programs`
    std::vector<std::string> remarks;
    const double n = double(setups.size());
    for (std::size_t k = 0; k < setups.size(); ++k) {
        const SetupPlan& setup = setups[k];
        const std::string place = "setup '" + printable(setup.project.name) + "'";
        try {
            PostedPrograms own = programs_to_judge(
                setup.project, setup.plan, progress.part(0.1 * double(k) / n, 0.1 * double(k + 1) / n));
            own.planned.resize(own.programs.size());
            std::move(own.planned.begin(), own.planned.end(), std::back_inserter(all.planned));
            all.blocks += own.blocks;
            if (!own.remark.empty()) remarks.push_back("S" + place.substr(1) + ": " + own.remark);
            programs.push_back(std::move(own.programs));
        } catch (const Error& e) {
            throw e.within(place);
        }
    }
    JudgedChain chain = judge_chain(setups, programs, settings, progress.part(0.1, 1));
    auto result = std::make_shared<Verification>(*chain.result);
    name_planned_motions(*result, all);
    result->remarks.insert(result->remarks.begin(), remarks.begin(), remarks.end());
    chain.result = std::move(result);
    chain.posted_blocks = all.blocks;
    return chain;
}

Verdict verdict_of(std::span<const JudgedChain> chains) {
    Verdict worst = Verdict::verified;
    for (const JudgedChain& chain : chains) {
        const Verdict own = chain.result->verdict();
        if (own == Verdict::failed || worst == Verdict::verified) worst = own;
    }
    return worst;
}

std::string findings_line(std::span<const JudgedChain> chains) {
    std::string all;
    for (const JudgedChain& chain : chains) {
        std::string line = findings_line(project_of(chain), chain.programs.programs, *chain.result);
        if (line.empty()) continue;
        if (chains.size() > 1) line = "from setup '" + printable(project_of(chain).name) + "': " + line;
        all += (all.empty() ? "" : "; ") + line;
    }
    return all;
}

std::string chains_json(std::span<const JudgedChain> chains) {
    if (chains.size() == 1) return pretty_json(chain_object(chains.front()));
    const std::vector<std::string> names = chain_file_names(chains.size());
    Json all;
    all["units"] = std::string(unit_name(project_of(chains.front()).unit));
    all["verdict"] = verdict_name(verdict_of(chains));
    Json stocks = Json::array();
    for (std::size_t i = 0; i < chains.size(); ++i) {
        Json object = chain_object(chains[i]);
        object["stock_file"] = names[2 * i];
        object["deviation_file"] = names[2 * i + 1];
        stocks.push_back(std::move(object));
    }
    all["stocks"] = std::move(stocks);
    return pretty_json(all);
}

std::vector<std::string> chain_file_names(std::size_t chains) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < chains; ++i) {
        const std::string number = chains > 1 ? "-" + std::to_string(i + 1) : "";
        names.push_back("stock" + number + ".stl");
        names.push_back("deviation" + number + ".vtp");
    }
    names.emplace_back("verify.json");
    return names;
}

std::vector<fs::path> write_chains(std::span<const JudgedChain> chains, const fs::path& folder,
                                   const Progress& progress, const std::function<void()>& before) {
    const NewFolder made(folder);
    OutputSet files;
    std::vector<fs::path> paths;
    for (const std::string& name : chain_file_names(chains.size()))
        paths.push_back(folder / name);
    const double n = double(chains.size());
    for (std::size_t i = 0; i < chains.size(); ++i)
        add_verification(files, project_of(chains[i]), *chains[i].result, paths[2 * i], paths[2 * i + 1],
                         progress.part(double(i) / n, double(i + 1) / n));
    keep_inputs(project_of(chains.front()), paths.back());
    files.add(paths.back()).write(chains_json(chains));
    progress.check();
    files.commit(before);
    return paths;
}

} // namespace facetmill
