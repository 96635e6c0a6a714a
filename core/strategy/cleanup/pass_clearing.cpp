#include "core/strategy/cleanup/pass_clearing.h"

#include "core/base/parallel.h"
#include "core/strategy/surface/lift_line.h"

namespace facetmill {

namespace {

/// A move is divided so often, and no further once it is shorter than this share of the chord tolerance:
/// what still runs into the part then goes over it.
constexpr int max_clearing_divisions = 30;
constexpr double shortest_share = 0.1;
/// And no further once so many points are put into one move: a cutter with a flat bottom that goes over a
/// comb of edges would ask for a point at each, again and again.
constexpr std::size_t max_put_in = 1000;
/// Moved aside are places of the first divisions only: beside a ridge, each of them would ask for the next.
constexpr int max_divisions_aside = 10;
/// A point is moved out of what it would cut sideways, along the normal, by so many chord tolerances,
/// doubled from the first to the last; if none is enough, up.
constexpr double first_aside = 0.25, last_aside = 4;

/// Puts points into passes.
class Clearer {
public:
    Clearer(const StripCutting& with, const Clearing& clearing)
        : with_(with), dip_(clearing.dip_share * with.chord),
          spacing_(safe_spacing(with.cover->profile(), dip_)) {}

    void apply(Pass& pass, const Progress& progress) const {
        Pass result = pass;
        result.cl.clear();
        result.cc.clear();
        LiftHint hint;
        for (std::size_t i = 0; i < pass.cl.size(); ++i) {
            progress.check();
            if (i > 0)
                between(pass.cl[i - 1].tip, pass.cl[i].tip, pass.cc[i], result, hint,
                        {0, result.cl.size() + max_put_in});
            result.cl.push_back(pass.cl[i]);
            result.cc.push_back(pass.cc[i]);
        }
        pass = std::move(result);
    }

private:
    /// How deep the cutter is in the part.
    double below(const Vec3& tip, LiftHint& hint) const {
        return with_.lift->tip_z(tip.x(), tip.y(), hint) - tip.z();
    }
    /// How deep in the divisions of a move, and how many points the pass may have then.
    struct Divided {
        int depth;
        std::size_t limit;
    };
    void between(const Vec3& a, const Vec3& b, const CutterContact& cc, Pass& out, LiftHint& hint,
                 const Divided& divided) const {
        const auto [depth, limit] = divided;
        const double length = (b - a).norm();
        const auto parts = std::max<std::size_t>(2, std::size_t(std::ceil(length / spacing_)));
        double worst = dip_;
        std::size_t where = 0;
        for (std::size_t k = 1; k < parts; ++k) {
            const double x = double(k) / double(parts);
            if (const double d = below(a + x * (b - a), hint); d > worst) {
                worst = d;
                where = k;
            }
        }
        if (where == 0) return;
        if (depth > max_clearing_divisions || length < shortest_share * with_.chord
            || out.cl.size() >= limit) {
            over(a, b, worst, cc, out);
            return;
        }
        Vec3 mid = a + (double(where) / double(parts)) * (b - a);
        // Away from what it would cut: a little sideways is enough on steep flanks.
        Vec3 out_of = cc.normal;
        out_of.z() = std::max(out_of.z(), 0.0);
        bool free = false;
        for (double x = first_aside * with_.chord;
             x <= last_aside * with_.chord && !free && depth < max_divisions_aside; x *= 2) {
            const Vec3 aside = mid + x * out_of;
            if (below(aside, hint) > 0) continue;
            mid = aside;
            free = true;
        }
        if (!free) mid.z() += worst;
        between(a, mid, cc, out, hint, {depth + 1, limit});
        out.cl.push_back({mid, Vec3::UnitZ()});
        out.cc.push_back(cc);
        between(mid, b, cc, out, hint, {depth + 1, limit});
    }

    /// Up beside a, level over what a move would run into by `deep`, and down on b: both stand free.
    static void over(const Vec3& a, const Vec3& b, double deep, const CutterContact& cc, Pass& out) {
        const double high = std::max(a.z(), b.z()) + deep;
        for (const Vec3& end : {a, b}) {
            out.cl.push_back({Vec3(end.x(), end.y(), high), Vec3::UnitZ()});
            out.cc.push_back(cc);
        }
    }

    const StripCutting& with_;
    double dip_;     ///< how far a move may run into the part where it is looked at
    double spacing_; ///< distance of the places where it is
};

} // namespace

void clear_passes(const StripCutting& with, std::vector<Pass>& passes, const Progress& progress,
                  const Clearing& clearing) {
    const Clearer clearer(with, clearing);
    parallel_for(passes.size(), 1, progress, [&](std::size_t i) { clearer.apply(passes[i], progress); });
}

} // namespace facetmill
