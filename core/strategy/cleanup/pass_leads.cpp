#include "core/strategy/cleanup/pass_leads.h"

#include "core/strategy/cleanup/body_clearance.h"
#include "core/strategy/cleanup/pass_clearing.h"

namespace facetmill {

namespace {

/// Points of an arc, and its radius, in radii of the cutter. Moves between them are looked at with those of
/// the pass (pass_clearing.h).
constexpr int lead_points = 6;
constexpr double lead_share = 0.5;
/// Sine of the angle to the vertical: a pass steeper than this is left straight.
constexpr double too_steep = 0.1;

/// The points of a lead that leaves the pass at `tip` in the direction `along`.
std::vector<Vec3> lead(const StripCutting& with, const Vec3& tip, const Vec3& along, const Vec3& up) {
    const double r = lead_share * with.cover->radius();
    Vec3 ahead(along.x(), along.y(), std::max(along.z(), 0.0));
    std::vector<Vec3> points;
    if (ahead.norm() > 0) {
        ahead.normalize();
        Vec3 over = Vec3::UnitZ() - ahead.z() * ahead;
        if (over.norm() > too_steep) {
            over.normalize();
            bool free = true;
            for (int k = 1; k <= lead_points && free; ++k) {
                const double a = 0.5 * pi * k / lead_points;
                const Vec3 p = tip + r * std::sin(a) * ahead + r * (1 - std::cos(a)) * over;
                free = with.lift->tip_z(p.x(), p.y()) <= p.z();
                points.push_back(p);
            }
            if (free) return points;
        }
    }
    points.clear();
    const Vec3 p = tip + r * up;
    if (with.lift->tip_z(p.x(), p.y()) <= p.z()) points.push_back(p);
    return points;
}

} // namespace

void add_leads(const StripCutting& with, Pass& pass, bool at_front, bool at_back) {
    const std::size_t n = pass.cl.size();
    std::vector<Vec3> front, back;
    if (at_front) front = lead(with, pass.cl[0].tip, pass.cl[0].tip - pass.cl[1].tip, pass.cc.front().normal);
    if (at_back)
        back = lead(with, pass.cl[n - 1].tip, pass.cl[n - 1].tip - pass.cl[n - 2].tip, pass.cc.back().normal);
    std::vector<CutterLocation> cl;
    std::vector<CutterContact> cc;
    for (std::size_t k = front.size(); k-- > 0;) {
        cl.push_back({front[k], Vec3::UnitZ()});
        cc.push_back(pass.cc.front());
    }
    pass.cl.insert(pass.cl.begin(), cl.begin(), cl.end());
    pass.cc.insert(pass.cc.begin(), cc.begin(), cc.end());
    for (const Vec3& tip : back) {
        pass.cl.push_back({tip, Vec3::UnitZ()});
        pass.cc.push_back(pass.cc.back());
    }
}

void lead_between(const CleanupJob& job, std::vector<Pass>& passes, double linked, const Progress& progress) {
    const StripCutting with = job.cutting();
    const auto apart = [&](std::size_t before, std::size_t after) {
        return (passes[after].cl.front().tip - passes[before].cl.back().tip).head<2>().norm() > linked;
    };
    std::vector<std::size_t> which;
    std::vector<Pass> longer;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const bool front = i == 0 || apart(i - 1, i), back = i + 1 == passes.size() || apart(i, i + 1);
        if (!front && !back) continue;
        which.push_back(i);
        longer.push_back(passes[i]);
        add_leads(with, longer.back(), front, back);
    }
    clear_passes(with, longer, progress);
    const std::vector<char> clear = is_body_clear(job, longer, progress);
    for (std::size_t k = 0; k < which.size(); ++k)
        if (clear[k] != 0) passes[which[k]] = std::move(longer[k]);
}

} // namespace facetmill
