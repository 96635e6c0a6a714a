#include "core/study/study_results.h"

#include "core/base/file.h"
#include "core/base/strict_json.h"

#include <algorithm>

namespace facetmill {

std::string_view standing_name(CandidateStanding standing) {
    constexpr std::string_view names[] = {"winner", "front", "verified", "behind", "out"};
    return names[std::size_t(standing)];
}

const CandidateState& state_of(const StudyOutcome& outcome, std::size_t candidate) {
    return outcome.states[outcome.same[candidate]];
}

std::string why_no_winner(const StudyOutcome& outcome, std::size_t candidate) {
    if (!outcome.candidates[candidate].usable()) return outcome.candidates[candidate].impossible;
    if (outcome.same[candidate] != candidate) return "the same as " + std::to_string(outcome.same[candidate]);
    const RungResult* last = outcome.states[candidate].last();
    if (!last) return "not looked at";
    if (!last->passed) return last->why;
    return missed_limits(*last, *outcome.states[candidate].closest(), outcome.decision.limits);
}

CandidateStanding standing_of(const StudyOutcome& outcome, std::size_t candidate) {
    const auto& front = outcome.decision.front;
    if (outcome.decision.winner == candidate) return CandidateStanding::winner;
    if (std::find(front.begin(), front.end(), candidate) != front.end()) return CandidateStanding::front;
    if (!why_no_winner(outcome, candidate).empty()) return CandidateStanding::out;
    return outcome.states[candidate].at(Rung::fine) ? CandidateStanding::verified : CandidateStanding::behind;
}

namespace {

std::string rung_of_state(const CandidateState& state) {
    const auto rung = state.closest();
    return rung ? std::string(rung_name(*rung)) : "";
}

Json candidate_json(const StudyFolder& folder, const StudyOutcome& outcome, std::size_t i) {
    const Candidate& c = outcome.candidates[i];
    Json choice = Json::object();
    for (std::size_t v = 0; v < c.chosen.size(); ++v) {
        const StudyVariation& variation = folder.study().vary[v];
        choice[variation.name] = variation.choices[c.chosen[v]].label;
    }
    Json one{{"number", i},
             {"key", outcome.keys[i]},
             {"choice", std::move(choice)},
             {"standing", std::string(standing_name(standing_of(outcome, i)))}};
    const CandidateState& state = state_of(outcome, i);
    one["rung"] = rung_of_state(state);
    one["why_not"] = printable(why_no_winner(outcome, i), 2000);
    Json measures = Json::object();
    if (const RungResult* last = state.last())
        for (const Measure m : all_measures())
            if (last->measures[m])
                measures[std::string(measure_name(m))] = json_number(*last->measures[m], "study");
    one["measures"] = std::move(measures);
    return one;
}

Json head_json(const StudyFolder& folder, const StudyOutcome& outcome) {
    Json head;
    head["study"] = 1;
    head["units"] = std::string(unit_name(folder.project().unit));
    head["program"] = folder.program();
    head["candidates"] = outcome.candidates.size() - 1;
    Json counts = Json::object();
    for (const Rung rung : all_rungs)
        counts[std::string(rung_name(rung))] =
            std::count_if(outcome.states.begin(), outcome.states.end(),
                          [&](const CandidateState& s) { return s.at(rung).has_value(); });
    head["looked_at"] = std::move(counts);
    head["missing"] = outcome.decision.missing.size();
    head["lost"] = outcome.lost.size();
    Json want = Json::array(), limits = Json::object();
    for (const Measure m : folder.study().want)
        want.push_back(std::string(measure_name(m)));
    for (const SetLimit& l : outcome.decision.limits)
        limits[std::string(measure_name(l.measure))] = json_number(l.most, "study");
    head["want"] = std::move(want);
    head["limits"] = std::move(limits);
    head["project"] = candidate_json(folder, outcome, 0);
    head["winner"] =
        outcome.decision.winner ? candidate_json(folder, outcome, *outcome.decision.winner) : Json();
    head["front"] = outcome.decision.front;
    head["nearest"] =
        outcome.decision.nearest ? candidate_json(folder, outcome, *outcome.decision.nearest) : Json();
    return head;
}

std::string number_text(const std::optional<double>& value) {
    return value ? format_number(*value, 6) : "";
}

/// Those that could win, by what is wanted; then the others, by number.
std::vector<std::size_t> table_order(const StudyFolder& folder, const StudyOutcome& outcome) {
    struct Row {
        std::size_t number;
        int group;
        std::vector<double> wanted;
    };
    std::vector<Row> rows;
    for (std::size_t i = 0; i < outcome.candidates.size(); ++i) {
        const CandidateStanding standing = standing_of(outcome, i);
        Row row{i,
                standing == CandidateStanding::out      ? 2
                : standing == CandidateStanding::behind ? 1
                                                        : 0,
                {}};
        const RungResult* last = state_of(outcome, i).last();
        if (row.group < 2 && last)
            for (const Measure m : folder.study().want)
                row.wanted.push_back(last->measures[m].value_or(0));
        rows.push_back(std::move(row));
    }
    std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
        if (a.group != b.group) return a.group < b.group;
        return a.wanted < b.wanted;
    });
    std::vector<std::size_t> order;
    order.reserve(rows.size());
    for (const Row& row : rows)
        order.push_back(row.number);
    return order;
}

/// Cells of Markdown keep off its own signs.
std::string markdown_cell(const std::string& text) {
    std::string cell;
    for (const char c : printable(text, 200)) {
        if (c == '|' || c == '*' || c == '_' || c == '`' || c == '<' || c == '\\') cell += '\\';
        cell += c;
    }
    return cell;
}

std::string csv_cell(const std::string& text) {
    std::string cell = "\"";
    for (const char c : printable(text, 2000))
        cell += c == '"' ? "\"\"" : std::string(1, c);
    return cell + "\"";
}

} // namespace

std::string study_json(const StudyFolder& folder, const StudyOutcome& outcome) {
    Json all = head_json(folder, outcome);
    all["all"] = Json::array();
    for (std::size_t i = 0; i < outcome.candidates.size(); ++i)
        all["all"].push_back(candidate_json(folder, outcome, i));
    return pretty_json(all);
}

std::string study_summary(const StudyFolder& folder, const StudyOutcome& outcome) {
    return pretty_json(head_json(folder, outcome));
}

std::string study_markdown(const StudyFolder& folder, const StudyOutcome& outcome) {
    std::string text = "| | standing | looked at |", line = "|---|---|---|";
    for (const StudyVariation& v : folder.study().vary) {
        text += " " + markdown_cell(v.name) + " |";
        line += "---|";
    }
    for (const Measure m : all_measures()) {
        const std::string unit = measure_unit(m, unit_name(folder.project().unit));
        text += " " + markdown_cell(std::string(measure_name(m))) + (unit.empty() ? "" : " (" + unit + ")")
                + " |";
        line += "---|";
    }
    text += " why not |\n" + line + "---|\n";
    for (const std::size_t i : table_order(folder, outcome)) {
        const Candidate& c = outcome.candidates[i];
        const CandidateState& state = state_of(outcome, i);
        text += "| " + std::to_string(i) + " | " + std::string(standing_name(standing_of(outcome, i))) + " | "
                + rung_of_state(state) + " |";
        for (std::size_t v = 0; v < folder.study().vary.size(); ++v) {
            const std::string shown = c.chosen.empty()
                                          ? std::string("as it stands")
                                          : markdown_cell(folder.study().vary[v].choices[c.chosen[v]].label);
            text += " " + shown + " |";
        }
        const RungResult* last = state.last();
        for (const Measure m : all_measures())
            text += " " + (last ? number_text(last->measures[m]) : "") + " |";
        text += " " + markdown_cell(why_no_winner(outcome, i)) + " |\n";
    }
    return text;
}

std::string study_csv(const StudyFolder& folder, const StudyOutcome& outcome) {
    std::string text = "number,standing,looked_at";
    for (const StudyVariation& v : folder.study().vary)
        text += "," + csv_cell(v.name);
    for (const Measure m : all_measures())
        text += "," + std::string(measure_name(m));
    text += ",why_not\n";
    for (std::size_t i = 0; i < outcome.candidates.size(); ++i) {
        const Candidate& c = outcome.candidates[i];
        const CandidateState& state = state_of(outcome, i);
        text += std::to_string(i) + "," + std::string(standing_name(standing_of(outcome, i))) + ","
                + rung_of_state(state);
        for (std::size_t v = 0; v < folder.study().vary.size(); ++v)
            text +=
                "," + (c.chosen.empty() ? "" : csv_cell(folder.study().vary[v].choices[c.chosen[v]].label));
        const RungResult* last = state.last();
        for (const Measure m : all_measures())
            text += "," + (last ? number_text(last->measures[m]) : "");
        text += "," + csv_cell(why_no_winner(outcome, i)) + "\n";
    }
    return text;
}

void write_study(const StudyFolder& folder, const StudyOutcome& outcome,
                 const std::function<void()>& before) {
    OutputSet set;
    set.add(folder.path() / "study.json").write(study_json(folder, outcome));
    set.add(folder.path() / "table.md").write(study_markdown(folder, outcome));
    set.add(folder.path() / "table.csv").write(study_csv(folder, outcome));
    set.commit(before);
}

void check_winner(const StudyFolder& folder, const StudyOutcome& outcome) {
    if (outcome.decision.winner) return;
    std::string nearest = "none was planned";
    if (const auto n = outcome.decision.nearest)
        nearest = "nearest comes " + std::to_string(*n) + " ("
                  + candidate_text(folder.study(), outcome.candidates[*n])
                  + "): " + why_no_winner(outcome, *n);
    throw Error(ErrorCode::empty_result, printable(folder.path().string(), 400),
                "no candidate meets the limits; " + nearest, "let more vary, or allow more");
}

void adopt_candidate(const StudyOutcome& outcome, std::size_t candidate, const std::filesystem::path& file) {
    if (candidate >= outcome.candidates.size() || !outcome.candidates[candidate].usable())
        throw Error(ErrorCode::out_of_range, "candidate " + std::to_string(candidate),
                    "there is no such candidate", "see the numbers in table.md");
    const CandidateState& state = state_of(outcome, candidate);
    const auto& fine = state.at(Rung::fine);
    if (!fine || !fine->passed)
        throw Error(ErrorCode::empty_result, "candidate " + std::to_string(candidate),
                    "has not been verified" + (state.last() ? ": " + state.last()->why : ""),
                    "take the winner, or one of the front");
    save_project(*outcome.candidates[candidate].project, file);
}

} // namespace facetmill
