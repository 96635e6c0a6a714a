#include "core/link/pass_pieces.h"

#include "core/base/parallel.h"
#include "core/strategy/finish3/left_stock.h"
#include "core/strategy/plan/pass_order.h"

#include <algorithm>
#include <iterator>

namespace facetmill {

bool is_upright(const std::vector<Pass>& passes) {
    return std::all_of(passes.begin(), passes.end(), [](const Pass& pass) {
        return std::all_of(pass.cl.begin(), pass.cl.end(),
                           [](const CutterLocation& c) { return c.axis == Vec3::UnitZ(); });
    });
}

UprightContact::UprightContact(const ContactIndexPtr& index, const Tool& tool, double allowance)
    : index_(index), profile_(tool.cutter()), lift_(index, profile_, allowance) {}

CutterContact UprightContact::at(const Vec3& tip, Index& facet) const {
    const AxialContact at = lift_.contact(tip.x(), tip.y());
    facet = at.facet;
    if (at.facet == no_index) return {tip, Vec3::UnitZ()};
    const Vec3 n = index_->mesh().facet_normal(at.facet);
    return {at.point, n.z() < 0 ? Vec3(-n) : n};
}

CutterContact UprightContact::at(const Vec3& tip) const {
    Index facet = no_index;
    return at(tip, facet);
}

PassPieces divide_passes(const std::vector<Pass>& passes,
                         const std::function<PassPieces(const Pass&, const Progress&)>& divide,
                         const Progress& progress) {
    std::vector<PassPieces> parts(passes.size());
    parallel_for(passes.size(), 1, progress, [&](std::size_t i) {
        if (!passes[i].cl.empty()) parts[i] = divide(passes[i], progress);
    });
    PassPieces all;
    for (PassPieces& part : parts) {
        all.left += part.left;
        all.all = all.all && part.all;
        std::move(part.kept.begin(), part.kept.end(), std::back_inserter(all.kept));
    }
    return all;
}

PassPieces pieces_over(const Pass& pass, std::span<const double> arc, std::vector<Interval> ranges,
                       const UprightContact& contact) {
    PassPieces pieces;
    if (ranges.size() == 1 && ranges[0].lo <= 0 && ranges[0].hi >= arc.back()) {
        pieces.kept.push_back(pass);
        return pieces;
    }
    pieces.all = false;
    const double shortest = shortest_piece * contact.profile().max_radius();
    std::erase_if(ranges, [&](const Interval& r) { return r.length() < shortest; });
    for (const Interval& r : gaps_between(ranges, arc.back()))
        pieces.left += r.length();
    pieces.kept = pieces_of(pass, arc, ranges, [&](const Vec3& tip) { return contact.at(tip); });
    return pieces;
}

PassPieces pieces_of_locations(const Pass& pass, const std::function<bool(std::size_t)>& may,
                               const std::function<bool(std::size_t)>& joined, const Progress& progress) {
    PassPieces pieces;
    Pass blank = pass;
    blank.cc.clear();
    blank.cl.clear();
    Pass piece = blank;
    const auto end = [&] {
        if (piece.cl.size() > 1 || piece.cl.size() == pass.cl.size()) pieces.kept.push_back(piece);
        piece = blank;
    };
    for (std::size_t i = 0; i < pass.cl.size(); ++i) {
        progress.check();
        const bool goes_on = piece.cl.empty() || joined(i), stays = may(i);
        if (!goes_on || !stays) {
            pieces.all = false;
            pieces.left += i > 0 ? (pass.cl[i].tip - pass.cl[i - 1].tip).norm() : 0;
            end();
        }
        if (!stays) continue;
        piece.cl.push_back(pass.cl[i]);
        if (i < pass.cc.size()) piece.cc.push_back(pass.cc[i]);
    }
    end();
    return pieces;
}

void settle_pieces(StrategyResult& path, const PlanContext& context, const OperationCommon& common,
                   const UprightContact* upright, const Progress& progress) {
    const double top = std::max(context.kept_off_box().hi.z(), context.stock_box.hi.z()) + common.clearance;
    // Levels of an upright tool stay in their order, before what has none.
    const auto free = std::stable_partition(path.passes.begin(), path.passes.end(),
                                            [&](const Pass& pass) { return upright && pass.layer >= 0; });
    std::vector<Pass> in_any_order(std::make_move_iterator(free), std::make_move_iterator(path.passes.end()));
    path.passes.erase(free, path.passes.end());
    order_by_travel(in_any_order, false, top, progress.part(0, 0.3));
    std::move(in_any_order.begin(), in_any_order.end(), std::back_inserter(path.passes));
    if (!upright) return;
    const auto clear = keep_clear_of_left_stock(
        path.passes, context, upright->profile().max_radius(), common.tolerance,
        [&](const Vec3& tip) { return upright->at(tip); }, progress.part(0.3, 1));
    if (!clear) return;
    if (path.passes.empty()) refuse_beside_stock(common.name, *clear, context);
    if (clear->left_length > 0) path.warnings.push_back(beside_stock_warning(*clear, context));
}

} // namespace facetmill
