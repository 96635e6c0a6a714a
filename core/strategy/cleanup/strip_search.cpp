#include "core/strategy/cleanup/strip_search.h"

#include "core/strategy/cleanup/foot_places.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/surface/point_grid.h"

namespace facetmill {

namespace {

/// A curve that is found twice is one: more than this share of its points lie beside those of the other,
/// within so many steps.
constexpr double same_share = 0.5, same_steps = 2;
/// Gaps between places that were left are closed up to this length at least, in radii.
constexpr double smallest_spacing = 0.25;

class StripSearch {
public:
    explicit StripSearch(const CleanupJob& job) : job_(job) {}

    std::vector<FoundStrip> run(const Progress& progress) {
        const CleanupSettings& settings = job_.settings;
        const Tool& before = job_.context.further_tools.front();
        find(CutterProfile(before.cutter()), StripKind::valley, progress.part(0, 0.8));
        if (settings.normal_change_limit.is_number()) {
            const double d = 2 / settings.normal_change_limit.number;
            find(CutterProfile(AptCutter::ball(d, std::max(d, before.flute_length))), StripKind::sharp,
                 progress.part(0.8, 1, "Looking for sharp changes of normals"));
        }
        if (job_.context.left) {
            const EarlierLeft& left = *job_.context.left;
            if (settings.left_points)
                find_left(left.points, job_.ripple, StripKind::no_posture, progress.part(0.8, 0.9));
            if (settings.rest_material)
                find_left(left.rest, left.rest_spacing, StripKind::rest, progress.part(0.9, 1));
        }
        const FootPlaces foot = foot_places(job_, progress.part(1, 1));
        find_left(foot.places, foot.spacing, StripKind::foot, progress.part(1, 1));
        return std::move(found_);
    }

private:
    void find(const CutterProfile& profile, StripKind kind, const Progress& progress) {
        const AxialLift lift(job_.context.contact, profile);
        const CutterCover cover(profile, cusp_detail(job_.cusp));
        const ValleyInput in = job_.asking(lift, cover);
        Valleys valleys = find_valleys(in, progress.part(0, 0.6));
        if (!found_.empty()) leave_out_known(valleys);
        std::vector<RestBand> bands = rest_bands(in, valleys, progress.part(0.6, 1));
        for (RestBand& band : bands) {
            FoundStrip f;
            f.kind = kind;
            if (band.curve >= 0) f.curve = valleys.curves[std::size_t(band.curve)];
            // What a ball that stands for a limit leaves beside its valleys is the previous cutter's.
            if (band.curve < 0 && kind == StripKind::sharp) continue;
            f.band = std::move(band);
            found_.push_back(std::move(f));
        }
    }

    /// Strips around places that are on none yet.
    void find_left(const std::vector<LeftPlace>& places, double spacing, StripKind kind,
                   const Progress& progress) {
        const double apart = std::max(spacing, smallest_spacing * job_.radius);
        // A point stands for all that its line was to cut there; a sample for itself.
        const double smallest = kind == StripKind::no_posture ? 0 : job_.ripple;
        const std::vector<LeftPlace> others = beside_strips(places, apart);
        // Below the foot's places the cutter goes nowhere.
        const double offset = kind == StripKind::foot ? apart : job_.overlap;
        for (LeftStrip& strip : left_strips(job_.context, others, apart, offset, smallest, progress)) {
            FoundStrip f;
            f.kind = kind;
            f.band.band = strip.strip.band;
            f.band.boundaries = strip.strip.boundaries;
            f.band.area = strip.strip.area;
            f.band.length = strip.strip.length;
            f.band.depth = strip.height;
            f.left = std::move(strip);
            found_.push_back(std::move(f));
        }
    }

    std::vector<LeftPlace> beside_strips(const std::vector<LeftPlace>& places, double apart) const {
        PointGrid known(apart);
        for (const FoundStrip& f : found_)
            for (const auto& t : f.band.band)
                for (const Vec3& p : t)
                    known.add(p);
        std::vector<LeftPlace> others;
        for (const LeftPlace& place : places)
            if (!known.near_until(place.point, apart, [&](std::size_t i) {
                    return (known.points()[i] - place.point).norm() < apart;
                }))
                others.push_back(place);
        return others;
    }

    /// Takes out curves that are there already.
    void leave_out_known(Valleys& valleys) const {
        const std::size_t before = valleys.curves.size();
        const double within = same_steps * valleys.step;
        PointGrid known(within);
        for (const FoundStrip& f : found_)
            if (f.curve)
                for (const PencilPoint& p : f.curve->points)
                    known.add(p.center);
        std::erase_if(valleys.curves, [&](const ValleyCurve& c) {
            std::size_t same = 0;
            for (const PencilPoint& p : c.points) {
                same += known.near_until(p.center, within, [&](std::size_t i) {
                    return (known.points()[i] - p.center).norm() < within;
                });
            }
            return double(same) > same_share * double(c.points.size());
        });
        if (valleys.curves.size() != before) own_tips(valleys);
    }

    const CleanupJob& job_;
    std::vector<FoundStrip> found_;
};

const char* kind_word(const FoundStrip& f) {
    switch (f.kind) {
    case StripKind::sharp:
        return "Crease";
    case StripKind::no_posture:
        return "Points";
    case StripKind::rest:
        return "Rest";
    case StripKind::foot:
        return "Foot";
    default:
        return f.curve ? "Valley" : "Hollow";
    }
}

std::string reason(const CleanupJob& job, const FoundStrip& f) {
    switch (f.kind) {
    case StripKind::sharp:
        return "normals turn by more than the limit";
    case StripKind::no_posture:
        return std::to_string(f.left.places)
               + (f.left.places == 1 ? " contact point was left" : " contact points were left")
               + " by operations before";
    case StripKind::rest:
        return "the operations before leave " + job.text(f.band.depth);
    case StripKind::foot:
        return "tool " + std::to_string(job.settings.previous_tool)
               + " would go below the bottom of the stock, leaves " + job.text(f.band.depth);
    default:
        return "tool " + std::to_string(job.settings.previous_tool)
               + (f.curve ? " touches both flanks, leaves " : " cannot enter, leaves ")
               + job.text(f.band.depth);
    }
}

} // namespace

std::vector<FoundStrip> find_strips(const CleanupJob& job, const Progress& progress) {
    return StripSearch(job).run(progress);
}

std::vector<Strip> described(const CleanupJob& job, const std::vector<FoundStrip>& found) {
    std::vector<Strip> strips;
    for (const FoundStrip& f : found) {
        Strip s;
        s.kind = f.kind;
        s.name = kind_word(f) + (" " + std::to_string(strips.size() + 1));
        s.reason = reason(job, f);
        s.tool = job.settings.tool;
        s.enabled = !is_switched_off(job.settings.switched_off, s.name);
        s.boundaries = f.band.boundaries;
        if (f.curve) {
            std::vector<Vec3> center;
            for (const PencilPoint& p : f.curve->points)
                center.push_back(p.center);
            if (f.curve->closed) center.push_back(center.front());
            s.centers.push_back(std::move(center));
        }
        s.area = f.band.area;
        s.length = f.band.length;
        s.width = f.band.width;
        strips.push_back(std::move(s));
    }
    return strips;
}

} // namespace facetmill
