#include "core/study/halving.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace facetmill {

namespace {

double wanted_value(const Measures& measures, Measure m) {
    if (measures[m]) return *measures[m];
    const bool foretold = m == Measure::excess_max || m == Measure::excess_p99 || m == Measure::excess_p95;
    return foretold && measures[Measure::cusp_max] ? *measures[Measure::cusp_max] : 0;
}

struct Standing {
    std::size_t candidate = 0;
    std::vector<double> wanted;
};

/// No worse in anything, better in something.
bool surpasses(const Standing& a, const Standing& b) {
    bool better = false;
    for (std::size_t i = 0; i < a.wanted.size(); ++i) {
        if (a.wanted[i] > b.wanted[i]) return false;
        better = better || a.wanted[i] < b.wanted[i];
    }
    return better;
}

bool comes_before(const Standing& a, const Standing& b) {
    if (a.wanted != b.wanted) return a.wanted < b.wanted;
    return a.candidate < b.candidate;
}

std::vector<Standing> standings(const Study& study, const std::vector<CandidateState>& candidates,
                                const std::vector<std::size_t>& of, Rung rung) {
    std::vector<Standing> all;
    for (const std::size_t c : of) {
        Standing s{c, {}};
        for (const Measure m : study.want)
            s.wanted.push_back(wanted_value(candidates[c].at(rung)->measures, m));
        all.push_back(std::move(s));
    }
    std::sort(all.begin(), all.end(), comes_before);
    return all;
}

/// The fronts one after the other. `all` is sorted: who surpasses another stands before it.
std::vector<std::vector<std::size_t>> fronts(const std::vector<Standing>& all) {
    std::vector<std::size_t> front_of(all.size(), 0);
    std::vector<std::vector<std::size_t>> found;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            if (front_of[j] >= front_of[i] && surpasses(all[j], all[i])) front_of[i] = front_of[j] + 1;
        if (found.size() <= front_of[i]) found.resize(front_of[i] + 1);
        found[front_of[i]].push_back(all[i].candidate);
    }
    return found;
}

std::vector<std::size_t> best_first(const Study& study, const std::vector<CandidateState>& candidates,
                                    const std::vector<std::size_t>& of, Rung rung) {
    std::vector<std::size_t> order;
    for (const auto& front : fronts(standings(study, candidates, of, rung)))
        order.insert(order.end(), front.begin(), front.end());
    return order;
}

std::vector<SetLimit> set_limits(const Study& study, const RungResult& project) {
    std::vector<SetLimit> limits;
    for (const StudyLimit& limit : study.limits) {
        if (!limit.project) {
            limits.push_back({limit.measure, limit.most});
            continue;
        }
        const auto& value = project.measures[limit.measure];
        if (!value)
            throw Error(ErrorCode::missing_reference, "limits." + std::string(measure_name(limit.measure)),
                        "is what the project as it stands comes to, which is not known: " + project.why,
                        "write a number");
        limits.push_back({limit.measure, limit.most * *value});
    }
    return limits;
}

/// What a limit comes to at a look. A gouge or an excess that a coarse look has found is there; percentiles,
/// shares and loads are estimates from fewer places and coarser stock, and a few hundredths more or less
/// than those of a fine look.
double limit_at(const SetLimit& limit, Rung rung) {
    constexpr double doubt = 0.1, min_share = 0.001;
    const Measure m = limit.measure;
    if (rung != Rung::coarse || known_from(m) != Rung::coarse || m == Measure::gouge_max
        || m == Measure::excess_max)
        return limit.most;
    return (1 + doubt) * limit.most + (m == Measure::uncut_share ? min_share : 0);
}

/// By which share of it the limit that is missed most is missed.
double largest_miss(const RungResult& result, Rung rung, const std::vector<SetLimit>& limits) {
    double miss = 0;
    for (const SetLimit& limit : limits) {
        const auto& value = result.measures[limit.measure];
        if (!value || *value <= limit_at(limit, rung)) continue;
        miss = std::max(miss, limit.most > 0 ? *value / limit.most - 1 : std::numeric_limits<double>::max());
    }
    return miss;
}

class Decider {
public:
    Decider(const Study& study, const std::vector<CandidateState>& candidates)
        : study_(study), known_(candidates), seen_(candidates.size()) {
        for (std::size_t c = 0; c < candidates.size(); ++c)
            seen_[c].usable = candidates[c].usable;
    }

    StudyDecision decide() {
        follow();
        decision_.seen = seen_;
        return decision_;
    }

private:
    static constexpr std::size_t project = 0;

    void follow() {
        if (!known_at_first()) return;
        decision_.limits = set_limits(study_, *seen_[0].at(Rung::fine));
        std::vector<std::size_t> planned;
        std::size_t usable = 0;
        for (std::size_t c = 0; c < seen_.size(); ++c) {
            if (!seen_[c].usable) continue;
            ++usable;
            if (meets(c, first_rung(c))) planned.push_back(c);
        }
        if (look_closer(in_order(planned), usable)) conclude();
    }

    /// The project as it stands is judged finely from the beginning: that holds for its other rungs.
    Rung first_rung(std::size_t c) const { return c == project ? Rung::fine : Rung::estimate; }
    Rung rung_of(std::size_t c, Rung rung) const { return c == project ? Rung::fine : rung; }

    bool asks(std::size_t c, Rung rung) {
        if (const auto& known = known_[c].at(rung)) {
            seen_[c].rungs[std::size_t(rung)] = known;
            return false;
        }
        decision_.missing.push_back({c, rung});
        return true;
    }

    bool meets(std::size_t c, Rung rung) const {
        const auto& result = seen_[c].at(rung);
        return result && result->passed && largest_miss(*result, rung, decision_.limits) == 0;
    }

    bool known_at_first() {
        for (std::size_t c = 0; c < seen_.size(); ++c)
            if (seen_[c].usable) asks(c, first_rung(c));
        return decision_.missing.empty();
    }

    /// By what planning tells of all of them, the project's own plan as well.
    std::vector<std::size_t> in_order(const std::vector<std::size_t>& planned) const {
        if (planned.empty() || planned[0] != project)
            return best_first(study_, seen_, planned, Rung::estimate);
        std::vector<CandidateState> alike = seen_;
        RungResult own = *alike[project].at(Rung::fine);
        for (const Measure m : all_measures())
            if (known_from(m) != Rung::estimate) own.measures[m].reset();
        alike[project].rungs[std::size_t(Rung::estimate)] = own;
        return best_first(study_, alike, planned, Rung::estimate);
    }

    /// False: something is missing.
    bool look_closer(const std::vector<std::size_t>& order, std::size_t usable) {
        const auto share = [&](double s) {
            return std::max<std::size_t>(1, std::size_t(std::ceil(s * double(usable) - 1e-9)));
        };
        for (std::size_t k = share(study_.coarse);; k *= 2) {
            const std::size_t looked_at = std::min(k, order.size());
            std::vector<std::size_t> passed;
            for (std::size_t i = 0; i < looked_at; ++i)
                asks(order[i], rung_of(order[i], Rung::coarse));
            if (!decision_.missing.empty()) return false;
            for (std::size_t i = 0; i < looked_at; ++i)
                if (meets(order[i], rung_of(order[i], Rung::coarse))) passed.push_back(order[i]);
            const auto found = finalists(coarse_order(passed), share(study_.fine));
            if (!found) return false;
            if (*found || !could_win(order, looked_at)) return true;
        }
    }

    /// Is there one from this place on that is not known to be no better than the project as it stands?
    bool could_win(const std::vector<std::size_t>& order, std::size_t from) const {
        const Measure first = study_.want.front();
        const auto begin = order.begin() + std::ptrdiff_t(from);
        if (known_from(first) != Rung::estimate || !meets(project, Rung::fine)) return begin != order.end();
        const double own = wanted_value(seen_[project].at(Rung::fine)->measures, first);
        return std::any_of(begin, order.end(), [&](std::size_t c) {
            return c != project && wanted_value(seen_[c].at(Rung::estimate)->measures, first) < own;
        });
    }

    std::vector<std::size_t> coarse_order(const std::vector<std::size_t>& passed) const {
        std::vector<CandidateState> alike = seen_;
        alike[project].rungs[std::size_t(Rung::coarse)] = alike[project].at(Rung::fine);
        return best_first(study_, alike, passed, Rung::coarse);
    }

    /// Has one of them passed that is not the project as it stands? Nothing: something is missing.
    std::optional<bool> finalists(const std::vector<std::size_t>& order, std::size_t first) {
        for (std::size_t k = first;; k *= 2) {
            const std::size_t looked_at = std::min(k, order.size());
            for (std::size_t i = 0; i < looked_at; ++i)
                asks(order[i], Rung::fine);
            if (!decision_.missing.empty()) return std::nullopt;
            for (std::size_t i = 0; i < looked_at; ++i)
                if (order[i] != project && meets(order[i], Rung::fine)) return true;
            if (looked_at == order.size()) return false;
        }
    }

    void conclude() {
        std::vector<std::size_t> passed;
        for (std::size_t c = 0; c < seen_.size(); ++c)
            if (seen_[c].usable && meets(c, Rung::fine)) passed.push_back(c);
        if (passed.empty()) return find_nearest();
        const std::vector<Standing> all = standings(study_, seen_, passed, Rung::fine);
        decision_.winner = all.front().candidate;
        decision_.front = fronts(all).front();
    }

    void find_nearest() {
        struct Miss {
            bool not_passed = true;
            double by = 0;
        };
        Miss least;
        for (std::size_t c = 0; c < seen_.size(); ++c) {
            const RungResult* last = seen_[c].usable ? seen_[c].last() : nullptr;
            if (!last) continue;
            const Miss miss{!last->passed, largest_miss(*last, *seen_[c].closest(), decision_.limits)};
            const bool nearer = miss.not_passed != least.not_passed ? !miss.not_passed : miss.by < least.by;
            if (decision_.nearest && !nearer) continue;
            decision_.nearest = c;
            least = miss;
        }
    }

    const Study& study_;
    const std::vector<CandidateState>& known_;
    std::vector<CandidateState> seen_;
    StudyDecision decision_;
};

} // namespace

std::optional<Rung> CandidateState::closest() const {
    for (std::size_t i = rungs.size(); i-- > 0;)
        if (rungs[i]) return all_rungs[i];
    return std::nullopt;
}

const RungResult* CandidateState::last() const {
    const auto rung = closest();
    return rung ? &*at(*rung) : nullptr;
}

StudyDecision decide(const Study& study, const std::vector<CandidateState>& candidates) {
    return Decider(study, candidates).decide();
}

std::string missed_limits(const RungResult& result, Rung rung, const std::vector<SetLimit>& limits) {
    std::string text;
    for (const SetLimit& limit : limits) {
        const auto& value = result.measures[limit.measure];
        if (!value || *value <= limit_at(limit, rung)) continue;
        const std::string missed = std::string(measure_name(limit.measure)) + " is " + format_number(*value)
                                   + ", at most " + format_number(limit.most) + " is allowed";
        text += (text.empty() ? "" : "; ") + missed;
    }
    return text;
}

} // namespace facetmill
