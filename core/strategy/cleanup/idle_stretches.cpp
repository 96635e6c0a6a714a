#include "core/strategy/cleanup/idle_stretches.h"

#include "core/strategy/surface/stock_before.h"

#include <cmath>
#include <iterator>

namespace facetmill {

namespace {

/// In radii of the cutter: the cells of the stock, the pieces of a pass that are asked, how far a kept
/// stretch goes on, and the gaps that are cut as well: out of them the tool comes to its clearance at feed,
/// and into the next stretch by a lead.
constexpr double idle_cell_share = 0.03, idle_piece_share = 0.25, idle_beside_share = 0.1, idle_gap_share = 3;
/// What counts as nothing, in the tolerance.
constexpr double idle_share = 0.1;

/// Ranges of a pass's length where the cutter takes something away.
std::vector<Interval> busy_ranges(const Pass& pass, std::span<const double> arc, const StockField& field,
                                  const StockCutter& cutter, double least, const Progress& progress) {
    std::vector<Interval> busy;
    for (std::size_t i = 1; i < pass.cl.size(); ++i) {
        progress.check();
        const Vec3 &from = pass.cl[i - 1].tip, motion = pass.cl[i].tip - from;
        const double length = arc[i] - arc[i - 1],
                     pieces = std::floor(length / (idle_piece_share * cutter.radius())) + 1;
        for (double k = 0; k < pieces; ++k) {
            const double lo = k / pieces, hi = (k + 1) / pieces;
            if (field.has_work(cutter, from + lo * motion, from + hi * motion, least))
                busy.push_back({arc[i - 1] + lo * length, arc[i - 1] + hi * length});
        }
    }
    return busy;
}

} // namespace

void leave_out_idle(std::vector<Pass>& passes, const PlanContext& context, double radius, double tolerance,
                    const ContactAt& contact, const Progress& progress) {
    const CutterProfile profile(context.tool.cutter());
    // What hangs over beside the neck of an undercut cutter is in no field of heights.
    if (passes.empty() || is_undercut(profile) || (context.stock.box.empty() && context.stock_box.empty()))
        return;
    StockField field = stock_before(context, idle_cell_share * radius, progress.part(0, 0.5));
    const StockCutter cutter(profile);
    const double beside = idle_beside_share * radius;
    std::vector<Pass> kept;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const Pass& pass = passes[i];
        const std::vector<double> arc = arc_lengths(pass);
        std::vector<Interval> busy =
            busy_ranges(pass, arc, field, cutter, idle_share * tolerance, progress.part(0.5, 1));
        for (Interval& range : busy)
            range = {std::max(0.0, range.lo - beside), std::min(arc.back(), range.hi + beside)};
        const std::vector<Interval> ranges = joined(std::move(busy), idle_gap_share * radius);
        std::vector<Pass> pieces;
        if (ranges.size() == 1 && ranges[0].lo <= 0 && ranges[0].hi >= arc.back())
            pieces.push_back(pass);
        else
            pieces = pieces_of(pass, arc, ranges, contact);
        for (const Pass& piece : pieces)
            for (std::size_t k = 1; k < piece.cl.size(); ++k)
                field.cut(cutter, piece.cl[k - 1].tip, piece.cl[k].tip);
        std::move(pieces.begin(), pieces.end(), std::back_inserter(kept));
        progress.part(0.5, 1).set(double(i + 1) / double(passes.size()));
    }
    passes = std::move(kept);
}

} // namespace facetmill
