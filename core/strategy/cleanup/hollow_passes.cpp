#include "core/strategy/cleanup/pass_clearing.h"
#include "core/strategy/cleanup/ridge.h"
#include "core/strategy/cleanup/strip_passes.h"
#include "core/strategy/surface/point_grid.h"

#include <algorithm>

namespace facetmill {

namespace {

/// The step-over is the widest of these, in radii, each this share of the one before, that keeps no more than
/// the cusp on a level floor; less by a share for floors that lean by up to 45 degrees.
constexpr double widest_step = 1.9, smallest_hollow_step = 0.01, next_step = 0.9, leaning_share = 0.7;
/// Points on lines, and those that stand for the hollow, are so far apart, in radii.
constexpr double hollow_point_share = 0.1, hollow_share = 0.5;

/// Lines over a hollow, along its longer side.
class HollowCutter {
public:
    HollowCutter(const StripCutting& with, const RestBand& band, const Progress& progress)
        : with_(with), radius_(with.cover->radius()), hollow_(hollow_share * radius_) {
        for (const auto& t : band.band) {
            progress.check();
            for (const Vec3& p : t) {
                box_.add(p);
                hollow_.add_first(Vec3(p.x(), p.y(), 0));
            }
        }
        const bool along_x = box_.size().x() >= box_.size().y();
        along_ = along_x ? Vec3::UnitX() : Vec3::UnitY();
        across_ = along_x ? Vec3::UnitY() : Vec3::UnitX();
    }

    StripCut run(const Progress& progress) {
        const double from = box_.lo.dot(across_), to = box_.hi.dot(across_);
        const int lines = std::max(1, int(std::ceil((to - from) / step())));
        for (int i = 0; i <= lines; ++i) {
            progress.set(double(i) / double(lines + 1));
            add_line(i, from + (to - from) * i / lines);
        }
        cut_.stepover_min = cut_.stepover_max = lines > 0 ? (to - from) / lines : 0;
        return std::move(cut_);
    }

private:
    double step() const {
        double step = widest_step * radius_;
        while (step > smallest_hollow_step * radius_
               && ridge(with_.cover->profile(), step * across_, along_) > with_.cusp)
            step *= next_step;
        return leaning_share * step;
    }

    bool is_wanted(const Vec3& p) const {
        return hollow_.near_until(Vec3(p.x(), p.y(), 0), radius_, [&](std::size_t i) {
            return (hollow_.points()[i] - p).head<2>().norm() <= radius_;
        });
    }

    /// The passes of a line: where it is over the hollow and the part is below.
    void add_line(int number, double at) {
        Pass pass;
        pass.drive = number;
        pass.offset = at;
        const double from = box_.lo.dot(along_), to = box_.hi.dot(along_), overlap = with_.overlap;
        const int points = int(std::ceil((to - from + 2 * overlap) / (hollow_point_share * radius_)));
        for (int k = 0; k <= points; ++k) {
            const Vec3 place =
                (from - overlap + (to - from + 2 * overlap) * k / points) * along_ + at * across_;
            const AxialContact c = with_.lift->contact(place.x(), place.y());
            if (!(c.tip_z > -infinity) || !is_wanted(place)) {
                finish(pass);
                continue;
            }
            const Vec3 tip(place.x(), place.y(), c.tip_z);
            pass.cl.push_back({tip, Vec3::UnitZ()});
            pass.cc.push_back({c.point, with_.cover->contact_normal(c.point - tip).value_or(Vec3::UnitZ())});
        }
        finish(pass);
    }

    void finish(Pass& pass) {
        if (pass.cl.size() > 1) {
            if (pass.drive % 2 != 0 && !with_.one_way) {
                std::reverse(pass.cl.begin(), pass.cl.end());
                std::reverse(pass.cc.begin(), pass.cc.end());
            }
            cut_.passes.push_back(pass);
        }
        pass.cl.clear();
        pass.cc.clear();
    }

    const StripCutting& with_;
    double radius_;
    Box3 box_;
    Vec3 along_, across_;
    PointGrid hollow_; ///< the hollow, seen from above
    StripCut cut_;
};

} // namespace

StripCut cut_hollow(const StripCutting& with, const RestBand& band, const Progress& progress) {
    StripCut cut = HollowCutter(with, band, progress).run(progress);
    clear_passes(with, cut.passes, progress.part(0.9, 1));
    return cut;
}

} // namespace facetmill
