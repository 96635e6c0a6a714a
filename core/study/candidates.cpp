#include "core/study/candidates.h"

#include "core/job/asked_operations.h"
#include "core/study/project_place.h"

#include <algorithm>
#include <optional>
#include <set>

namespace facetmill {

namespace {

constexpr std::uint64_t max_combinations = 1'000'000'000'000'000;

/// Steele, Lea, Flood 2014: a good number of each state, the states one after the other.
std::uint64_t split_mix(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

std::uint64_t combinations(const Study& study) {
    std::uint64_t total = 1;
    for (const StudyVariation& v : study.vary) {
        total *= v.choices.size();
        if (total > max_combinations)
            throw Error(ErrorCode::limit_exceeded, "vary", "there are more than 10^15 combinations",
                        "let less vary");
    }
    return total;
}

std::vector<std::size_t> choices_of(const Study& study, std::uint64_t number) {
    std::vector<std::size_t> chosen(study.vary.size());
    for (std::size_t i = study.vary.size(); i-- > 0;) {
        chosen[i] = std::size_t(number % study.vary[i].choices.size());
        number /= study.vary[i].choices.size();
    }
    return chosen;
}

/// Tools that came with the study and serve nothing are no part of the candidate.
void drop_unused(Project& project, const Project& base) {
    std::set<long> used;
    for (const Operation* o : all_operations(project))
        for (const long n : tools_of(*o))
            used.insert(n);
    std::erase_if(project.tools, [&](const Tool& t) {
        const bool own = std::any_of(base.tools.begin(), base.tools.end(),
                                     [&](const Tool& b) { return b.number == t.number; });
        return !own && used.count(t.number) == 0;
    });
}

std::shared_ptr<const Project> project_of_values(Json file, const Project& base) {
    auto project = std::make_shared<Project>(parse_project(file.dump(), "candidate"));
    project->path = base.path;
    check_project(*project); // its machine's file is read now that it has a place
    drop_unused(*project, base);
    return project;
}

/// The error of a value that neither fits the project alone nor any combination.
void refuse_useless_values(const Study& study, const Project& base, const Json& file,
                           const std::vector<Candidate>& candidates) {
    for (std::size_t v = 0; v < study.vary.size(); ++v)
        for (std::size_t c = 0; c < study.vary[v].choices.size(); ++c) {
            bool tried = false, used = false;
            for (std::size_t i = 1; i < candidates.size() && !used; ++i) {
                if (candidates[i].chosen[v] != c) continue;
                tried = true;
                used = candidates[i].usable();
            }
            if (!tried || used) continue;
            try {
                Json alone = file;
                for (const auto& [path, value] : study.vary[v].choices[c].values)
                    set_at(alone, path, value);
                (void)project_of_values(std::move(alone), base);
            } catch (const Error& e) {
                throw e.within(strict::element("vary", v) + ": " + printable(study.vary[v].choices[c].label));
            }
        }
}

} // namespace

std::vector<std::uint64_t> chosen_numbers(std::uint64_t total, std::size_t count, std::uint64_t seed) {
    std::set<std::uint64_t> chosen;
    if (count >= total) {
        for (std::uint64_t i = 0; i < total; ++i)
            chosen.insert(chosen.end(), i);
    } else {
        // Floyd 1987: each set of so many numbers is as likely as any other.
        std::uint64_t state = seed;
        for (std::uint64_t j = total - count; j < total; ++j)
            if (const std::uint64_t t = split_mix(state) % (j + 1); !chosen.insert(t).second)
                chosen.insert(j);
    }
    return {chosen.begin(), chosen.end()};
}

std::vector<Candidate> study_candidates(const Study& study, const Project& project,
                                        const Progress& progress) {
    const std::uint64_t total = combinations(study);
    const std::uint64_t asked = study.samples > 0 ? std::min<std::uint64_t>(study.samples, total) : total;
    if (asked > Study::max_candidates)
        throw Error(ErrorCode::limit_exceeded, study.samples > 0 ? "samples" : "vary",
                    std::to_string(asked) + " combinations are too many",
                    "write \"samples\" of at most " + std::to_string(Study::max_candidates));
    Json file = parse_strict_json(project_to_json(project), "project");
    for (const Json& tool : study.tools)
        file["tools"].push_back(tool);
    std::vector<Candidate> all;
    all.push_back({{}, std::make_shared<const Project>(project), {}});
    std::optional<Error> first;
    for (const std::uint64_t number : chosen_numbers(total, std::size_t(asked), study.seed)) {
        progress.set(double(all.size()) / double(asked + 1));
        Candidate one{choices_of(study, number), nullptr, {}};
        try {
            Json changed = file;
            for (std::size_t v = 0; v < study.vary.size(); ++v)
                for (const auto& [path, value] : study.vary[v].choices[one.chosen[v]].values)
                    set_at(changed, path, value);
            one.project = project_of_values(std::move(changed), project);
        } catch (const Error& e) {
            one.impossible = e.what();
            if (!first) first = e;
        }
        all.push_back(std::move(one));
    }
    refuse_useless_values(study, project, file, all);
    const bool any = std::any_of(all.begin() + 1, all.end(), [](const Candidate& c) { return c.usable(); });
    if (!any) throw first->within("vary: no combination is possible");
    return all;
}

std::string candidate_text(const Study& study, const Candidate& candidate) {
    if (candidate.chosen.empty()) return "the project as it stands";
    std::string text;
    for (std::size_t v = 0; v < study.vary.size(); ++v)
        text += (v > 0 ? ", " : "") + printable(study.vary[v].name) + " "
                + printable(study.vary[v].choices[candidate.chosen[v]].label);
    return text;
}

} // namespace facetmill
