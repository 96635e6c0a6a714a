#include "core/strategy/finish3/left_out.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/plan/plan_text.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

Vec3 place_on(const Pass& pass, std::span<const double> arc, double at) {
    const std::size_t n = pass.cl.size();
    if (n < 2) return pass.cl.front().tip;
    // Moves are straight: the place may lie within one.
    const auto i = std::size_t(std::clamp(std::lower_bound(arc.begin(), arc.end(), at) - arc.begin(),
                                          std::ptrdiff_t(1), std::ptrdiff_t(n - 1)));
    const double t =
        arc[i] > arc[i - 1] ? std::clamp((at - arc[i - 1]) / (arc[i] - arc[i - 1]), 0.0, 1.0) : 1;
    return pass.cl[i - 1].tip + t * (pass.cl[i].tip - pass.cl[i - 1].tip);
}

std::vector<Interval> free_ranges(const Pass& pass, std::span<const double> arc, double spacing,
                                  const std::function<bool(const Vec3& tip)>& is_free,
                                  const Progress& progress) {
    std::vector<Interval> ranges;
    bool was_free = false;
    const auto look = [&](const Vec3& tip, double at) {
        progress.check();
        const bool free = is_free(tip);
        if (free && !was_free) ranges.push_back({at, at});
        if (free) ranges.back().hi = at;
        was_free = free;
    };
    look(pass.cl.front().tip, 0);
    for (std::size_t i = 1; i < pass.cl.size(); ++i) {
        const Vec3 &a = pass.cl[i - 1].tip, &b = pass.cl[i].tip;
        const auto n = std::size_t(std::ceil((b - a).norm() / spacing)) + 1;
        for (std::size_t k = 1; k <= n; ++k) {
            const double t = double(k) / double(n);
            look(a + t * (b - a), arc[i - 1] + t * (arc[i] - arc[i - 1]));
        }
    }
    return ranges;
}

std::vector<double> arc_lengths(const Pass& pass) {
    std::vector<double> arc(pass.cl.size(), 0);
    for (std::size_t i = 1; i < arc.size(); ++i)
        arc[i] = arc[i - 1] + (pass.cl[i].tip - pass.cl[i - 1].tip).norm();
    return arc;
}

std::vector<Pass> pieces_of(const Pass& pass, std::span<const double> arc, std::span<const Interval> ranges,
                            const ContactAt& contact) {
    std::vector<Pass> pieces;
    for (const Interval& range : ranges) {
        Pass part;
        part.drive = pass.drive;
        part.offset = pass.offset;
        part.layer = pass.layer;
        const auto add_end = [&](double at) {
            const Vec3 tip = place_on(pass, arc, at);
            part.cl.push_back({tip, pass.cl.front().axis});
            part.cc.push_back(contact(tip));
        };
        add_end(range.lo);
        for (std::size_t i = 0; i < arc.size(); ++i)
            if (arc[i] > range.lo && arc[i] < range.hi) {
                part.cc.push_back(pass.cc[i]);
                part.cl.push_back(pass.cl[i]);
            }
        add_end(std::min(range.hi, arc.back()));
        pieces.push_back(std::move(part));
    }
    return pieces;
}

std::vector<Interval> gaps_between(std::span<const Interval> ranges, double length) {
    std::vector<Interval> gaps;
    double from = 0;
    for (const Interval& r : ranges) {
        if (r.lo > from) gaps.push_back({from, r.lo});
        from = r.hi;
    }
    if (from < length) gaps.push_back({from, length});
    return gaps;
}

namespace {

/// What of each pass is kept; `ranges` tells it of one.
template <class Ranges>
HeldOut leave_out_beside(const std::vector<Pass>& passes, const HolderReach& bodies, double shortest,
                         const ContactAt& contact, const Progress& progress, const Ranges& ranges) {
    std::vector<HeldOut> parts(passes.size());
    parallel_for(passes.size(), 1, progress, [&](std::size_t i) {
        const Pass& pass = passes[i];
        HeldOut& part = parts[i];
        if (pass.cl.empty()) return;
        const std::vector<double> arc = arc_lengths(pass);
        part.length = arc.back();
        std::vector<Interval> kept = ranges(pass, arc);
        if (kept.size() == 1 && kept[0].lo <= 0 && kept[0].hi >= arc.back()) {
            part.kept.push_back(pass);
            return;
        }
        std::erase_if(kept, [&](const Interval& r) { return r.length() < shortest; });
        const std::vector<Interval> left = gaps_between(kept, arc.back());
        for (const Interval& r : left)
            part.left_length += r.length();
        part.kept = pieces_of(pass, arc, kept, contact);
        part.left = pieces_of(pass, arc, left, contact);
        for (const Pass& p : part.left)
            for (const CutterLocation& c : p.cl) {
                progress.check();
                const HolderReach::Lack lack = bodies.lack(c.tip);
                part.lack.shank = std::max(part.lack.shank, lack.shank);
                part.lack.holder = std::max(part.lack.holder, lack.holder);
            }
    });
    HeldOut all;
    for (HeldOut& part : parts) {
        std::move(part.kept.begin(), part.kept.end(), std::back_inserter(all.kept));
        std::move(part.left.begin(), part.left.end(), std::back_inserter(all.left));
        all.length += part.length;
        all.left_length += part.left_length;
        all.lack.shank = std::max(all.lack.shank, part.lack.shank);
        all.lack.holder = std::max(all.lack.holder, part.lack.holder);
    }
    return all;
}

} // namespace

HeldOut leave_out_held(const std::vector<Pass>& passes, const HolderReach& bodies, double shortest,
                       const ContactAt& contact, const Progress& progress) {
    const auto ranges = [&](const Pass& pass, std::span<const double> arc) {
        HolderReach::Hints hints;
        const auto is_free = [&](const Vec3& tip) { return bodies.is_free(tip, hints); };
        return free_ranges(pass, arc, bodies.spacing(), is_free, progress);
    };
    return leave_out_beside(passes, bodies, shortest, contact, progress, ranges);
}

HeldOut leave_out_untilted(const std::vector<Pass>& passes, const PassTilter& tilter,
                           const HolderReach& bodies, double shortest, const ContactAt& contact,
                           const Progress& progress) {
    const auto ranges = [&](const Pass& pass, std::span<const double> arc) {
        std::vector<Interval> kept = tilter.run(pass, progress.part(0, 0)).kept;
        if (!kept.empty() && kept.back().hi > arc.back() * (1 - tolerance::figure_rounding))
            kept.back().hi = arc.back();
        return kept;
    };
    return leave_out_beside(passes, bodies, shortest, contact, progress, ranges);
}

std::vector<Pass> leave_out_air(const std::vector<Pass>& passes, const StockField& field,
                                const StockCutter& cutter, double least, double beside,
                                const ContactAt& contact, const Progress& progress) {
    std::vector<std::vector<Pass>> parts(passes.size());
    parallel_for(passes.size(), 1, progress, [&](std::size_t k) {
        const Pass& pass = passes[k];
        const std::vector<double> arc = arc_lengths(pass);
        std::vector<Interval> busy;
        for (std::size_t i = 1; i < arc.size(); ++i) {
            progress.check();
            const double length = arc[i] - arc[i - 1];
            for (const Interval& share : field.work(cutter, pass.cl[i - 1].tip, pass.cl[i].tip, least))
                busy.push_back({std::max(0.0, arc[i - 1] + share.lo * length - beside),
                                arc[i - 1] + share.hi * length + beside});
        }
        if (!busy.empty()) parts[k] = pieces_of(pass, arc, joined(std::move(busy), 2 * beside), contact);
    });
    std::vector<Pass> kept;
    for (auto& part : parts)
        std::move(part.begin(), part.end(), std::back_inserter(kept));
    return kept;
}

std::string held_alternative(const HeldOut& held) {
    if (held.tilt_limit > 0) return ", or a larger tilt limit";
    return held.has_ball ? ", or a tilt limit on a machine of five axes" : ", or a tool that tilts (finish5)";
}

void refuse_held(const std::string& operation, const HeldOut& held, const PlanContext& context) {
    const PlanText text{context.unit, context.to_setup};
    throw Error(ErrorCode::empty_result, operation,
                "shank or holder would come into the part wherever the cutter could cut",
                "use a tool that is " + text(std::max(held.lack.shank, held.lack.holder)) + " longer"
                    + held_alternative(held));
}

void refuse_beside_raw(const std::string& operation) {
    throw Error(ErrorCode::empty_result, operation, "no pass meets the stock",
                "correct the stock's place and size");
}

void refuse_without_rest(const std::string& operation) {
    throw Error(ErrorCode::empty_result, operation, "nowhere more than the tolerance stands of the stock",
                "leave the operation out, or cut everywhere (rest_only)");
}

} // namespace facetmill
