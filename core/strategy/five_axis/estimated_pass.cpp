#include "core/strategy/five_axis/estimated_pass.h"

#include "core/base/parallel.h"
#include "core/strategy/five_axis/strip_width.h"

#include <algorithm>
#include <cmath>

namespace facetmill {

namespace {

/// Lengths in radii of the cutter. Width of a bin; how far beyond its ends a pass answers for its strip; the
/// least width to one side that a contact is taken to have.
constexpr double bin_share = 0.25, beyond_share = 1.5, min_width_share = 1.0 / 40;
/// So far beyond its ends, about, a pass goes on, and has to clear its strip there too.
constexpr double further_share = 0.3;
/// Where along the travel a pose reaches the borders of its strip. A flat end that leans along the travel
/// does so the farther behind its contact the wider its strip is, a ball beside it; one with a yaw up to a
/// radius behind.
constexpr double behind_share = 0.5, ahead_share = 0.5, yawed_behind_share = 1, yawed_ahead_share = 0.25;
/// Contacts farther apart than this are looked at half-way too.
constexpr double far_apart_share = 0.25;

} // namespace

TravelBins::TravelBins(const FiveAxisField& field) {
    const auto [lo, hi] = field.travelled();
    lo_ = lo;
    width_ = bin_share * field.radius();
    count_ = std::size_t((hi - lo_) / width_) + 1;
}

std::size_t TravelBins::at(double u) const {
    return std::size_t(std::clamp((u - lo_) / width_, 0.0, double(count_ - 1)));
}

PassEstimator::PassEstimator(const FiveAxisField& field, double leave)
    : field_(field), widths_(field, leave), bins_(field) {
    const double r = field.radius();
    const bool yawed = widths_.yawed();
    smallest_ = 2 * min_width_share * r * field.fineness();
    largest_ = 2 * StripWidth::max_width(field);
    behind_ = (yawed ? yawed_behind_share : behind_share) * r;
    ahead_ = (yawed ? yawed_ahead_share : ahead_share) * r;
}

std::array<double, 2> PassEstimator::cleared(double u, int travel) const {
    return travel > 0 ? std::array{u - behind_, u + ahead_} : std::array{u - ahead_, u + behind_};
}

EstimatedPass PassEstimator::estimate(long plane, int travel, double gap, const BinRange& within,
                                      const Progress& progress) const {
    return *estimate(plane, travel, gap, within, Refusal(), progress);
}

std::optional<EstimatedPass> PassEstimator::estimate(long plane, int travel, double gap,
                                                     const BinRange& within, const Refusal& refusal,
                                                     const Progress& progress) const {
    EstimatedPass pass;
    pass.plane = plane;
    pass.v = field_.lines().v(plane);
    pass.travel = travel;
    cut_lines(pass, within);
    if (refusal.lines && refusal.lines(pass)) return std::nullopt;
    place_contacts(pass);
    if (refusal.contacts && is_refused(pass, gap, refusal, progress)) return std::nullopt;
    const std::vector<EstimatedContact> between = find_contacts(pass, gap, progress);
    // Postures with a yaw may be free at the last contact and not where the pass goes on.
    if (widths_.yawed()) answer_beyond_ends(pass, gap);
    spread_over_bins(pass, between);
    return pass;
}

void PassEstimator::cut_lines(EstimatedPass& pass, const BinRange& within) const {
    const bool everywhere = within.first == 0 && within.last == bins_.count() - 1;
    const double u0 = bins_.begin(within.first) - within.beyond,
                 u1 = bins_.begin(within.last + 1) + within.beyond;
    for (SurfaceLine& line : field_.lines().lines(pass.v)) {
        std::array<bool, 2> cut_short = line.goes_on;
        if (!everywhere) line = part_of_line(line, u0, u1, cut_short);
        if (line.points.size() < 2 || !(line.length() > 0)) continue;
        pass.lines.push_back(std::move(line));
        pass.cut_short.push_back(cut_short);
    }
}

void PassEstimator::place_contacts(EstimatedPass& pass) const {
    for (const SurfaceLine& line : pass.lines) {
        auto& contacts = pass.contacts.emplace_back();
        for (const double s : field_.samples(line))
            contacts.push_back({.place = field_.place(line, s, pass.v, pass.travel)});
    }
}

bool PassEstimator::is_refused(EstimatedPass& pass, double gap, const Refusal& refusal,
                               const Progress& progress) const {
    struct Block {
        std::span<EstimatedContact> contacts;
        double likely;
    };
    std::vector<Block> blocks;
    for (auto& contacts : pass.contacts)
        for (std::size_t b = 0; b < ContactWidths::blocks(contacts.size()); ++b) {
            Block block{ContactWidths::block(contacts, b), -infinity};
            for (const EstimatedContact& c : block.contacts)
                block.likely = std::max(block.likely, refusal.likely[bins_.at(c.place.u)]);
            blocks.push_back(block);
        }
    std::stable_sort(blocks.begin(), blocks.end(),
                     [](const Block& a, const Block& b) { return a.likely > b.likely; });
    // Several threads take more and more at a time, so that they seldom wait for each other.
    const auto threads = std::size_t(thread_count());
    std::size_t begin = 0, count = threads;
    while (begin < blocks.size()) {
        const std::size_t end = std::min(begin + count, blocks.size());
        parallel_for(end - begin, 1, progress.part(0, 0),
                     [&](std::size_t i) { widths_.find_block(blocks[begin + i].contacts, gap, progress); });
        for (std::size_t i = begin; i < end; ++i)
            if (refusal.contacts(pass, blocks[i].contacts)) return true;
        begin = end;
        if (threads > 1) count *= 2;
    }
    return false;
}

std::vector<EstimatedContact> PassEstimator::find_contacts(EstimatedPass& pass, double gap,
                                                           const Progress& progress) const {
    std::vector<EstimatedContact> between;
    for (std::size_t l = 0; l < pass.lines.size(); ++l) {
        auto& contacts = pass.contacts[l];
        widths_.find(contacts, gap, progress);
        std::vector<EstimatedContact> middles;
        for (std::size_t i = 1; i < contacts.size(); ++i) {
            const double s0 = contacts[i - 1].place.s, s1 = contacts[i].place.s;
            if (s1 - s0 > far_apart_share * field_.radius())
                middles.push_back(
                    {.place = field_.place(pass.lines[l], 0.5 * (s1 + s0), pass.v, pass.travel)});
        }
        widths_.find(middles, gap, progress);
        between.insert(between.end(), middles.begin(), middles.end());
    }
    return between;
}

void PassEstimator::answer_beyond_ends(EstimatedPass& pass, double gap) const {
    const double further = further_share * field_.radius();
    ToolLift::Hint hint;
    for (std::size_t l = 0; l < pass.lines.size(); ++l)
        for (const bool first : {true, false}) {
            auto& contacts = pass.contacts[l];
            EstimatedContact& end = first ? contacts.front() : contacts.back();
            if (pass.cut_short[l][first ? 0 : 1] || !end.usable) continue;
            const double s = first ? -further : pass.lines[l].length() + further;
            EstimatedContact beyond{.place = field_.place(pass.lines[l], s, pass.v, pass.travel)};
            double lead = end.posture.lead;
            widths_.find(beyond, gap, lead, hint);
            if (!beyond.usable) continue;
            end.width_lo = std::min(end.width_lo, beyond.width_lo);
            end.width_hi = std::min(end.width_hi, beyond.width_hi);
        }
}

void PassEstimator::spread_over_bins(EstimatedPass& pass,
                                     const std::vector<EstimatedContact>& between) const {
    pass.width_lo.assign(bins_.count(), 0);
    pass.width_hi.assign(bins_.count(), 0);
    pass.end_lo.assign(bins_.count(), 0);
    pass.end_hi.assign(bins_.count(), 0);
    pass.comes.assign(bins_.count(), false);
    pass.unfree.assign(bins_.count(), false);
    const double least = min_width(), most = StripWidth::max_width(field_);
    const auto count = [&](const EstimatedContact& c, double beyond_lo, double beyond_hi) {
        const auto [from, to] = cleared(c.place.u, pass.travel);
        for (std::size_t b = bins_.at(from - beyond_lo); b <= bins_.at(to + beyond_hi); ++b) {
            if (!pass.comes[b]) pass.width_lo[b] = pass.width_hi[b] = infinity;
            pass.comes[b] = true;
            // What no posture serves is no fault of the step: it is left to clean-up, as far as a pass can
            // answer for.
            const bool counts = c.usable && !c.left;
            if (!c.usable) pass.unfree[b] = true;
            pass.end_lo[b] = std::max(pass.end_lo[b], counts ? c.end_lo : most);
            pass.end_hi[b] = std::max(pass.end_hi[b], counts ? c.end_hi : most);
            if (!counts) continue;
            pass.width_lo[b] = std::min(pass.width_lo[b], std::max(c.width_lo, least));
            pass.width_hi[b] = std::min(pass.width_hi[b], std::max(c.width_hi, least));
        }
    };
    const double beyond = beyond_share * field_.radius();
    for (std::size_t l = 0; l < pass.contacts.size(); ++l) {
        const auto& contacts = pass.contacts[l];
        for (const auto& c : contacts) {
            // Beyond its ends a pass goes on as far as its strip does.
            const bool first = &c == &contacts.front() && !pass.cut_short[l][0],
                       last = &c == &contacts.back() && !pass.cut_short[l][1];
            count(c, first ? beyond : 0, last ? beyond : 0);
        }
    }
    for (const auto& c : between)
        if (c.usable) count(c, 0, 0);
}

} // namespace facetmill
