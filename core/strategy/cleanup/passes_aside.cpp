#include "core/strategy/cleanup/passes_aside.h"

#include "core/strategy/cleanup/body_clearance.h"
#include "core/strategy/cleanup/pass_clearing.h"

namespace facetmill {

namespace {

/// By this share of how far it is moved a tool may be lifted.
constexpr double climb_share = 0.5;

/// Level and across the travel at a place; zero where the pass runs upright.
Vec3 level_across(const Pass& pass, std::size_t i) {
    const Vec3 along = pass.cl[std::min(i + 1, pass.cl.size() - 1)].tip - pass.cl[i > 0 ? i - 1 : 0].tip;
    const Vec3 side(-along.y(), along.x(), 0);
    return side.norm() > 0 ? Vec3(side.normalized()) : Vec3(Vec3::Zero());
}

} // namespace

std::vector<Pass> passes_aside(const CleanupJob& job, const Pass& pass, double far,
                               const Progress& progress) {
    const StripCutting with = job.cutting();
    std::vector<Pass> moved;
    for (const double sign : {1.0, -1.0}) {
        Pass piece = pass;
        const auto begin = [&] {
            piece.cl.clear();
            piece.cc.clear();
        };
        const auto end = [&] {
            if (piece.cl.size() > 1) moved.push_back(piece);
            begin();
        };
        begin();
        for (std::size_t i = 0; i < pass.cl.size(); ++i) {
            const Vec3 side = level_across(pass, i), tip = pass.cl[i].tip + sign * far * side;
            const double z = with.lift->tip_z(tip.x(), tip.y());
            if (side.isZero(0) || z > tip.z() + climb_share * far) {
                end();
                continue;
            }
            // No lower than it was: beside a step the floor is another strip's, and through a hole there is
            // none.
            piece.cl.push_back({Vec3(tip.x(), tip.y(), std::max(z, tip.z())), pass.cl[i].axis});
            piece.cc.push_back(pass.cc[i]);
        }
        end();
    }
    if (moved.empty()) return moved;
    clear_passes(with, moved, progress);
    const std::vector<char> clear = is_body_clear(job, moved, progress);
    std::vector<Pass> free;
    for (std::size_t k = 0; k < moved.size(); ++k)
        if (clear[k] != 0) free.push_back(std::move(moved[k]));
    return free;
}

} // namespace facetmill
