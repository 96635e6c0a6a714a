#include "core/strategy/cleanup/cleanup.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/tool_lift.h"
#include "core/strategy/cleanup/axis_tilt.h"
#include "core/strategy/cleanup/left_strip.h"
#include "core/strategy/cleanup/nearest_place.h"
#include "core/strategy/cleanup/strip_passes.h"
#include "core/strategy/cleanup/touch_up.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/surface/point_grid.h"

#include <optional>

namespace facetmill {

namespace {

const OperationRegistration registration("cleanup", "Clean-up", [] { return std::make_unique<Cleanup>(); });

/// A curve that is found twice is one: of its points so many lie beside those of the other.
constexpr double same_share = 0.5;

/// Of the square of its longest edge: a facet with less area has no sure normal.
constexpr double needle_share = 0.02;

/// Of the radius: what stays is measured at places so far apart.
constexpr double judge_share = 0.1;

/// Of the tolerance: an inclined tool that would cut elsewhere is drawn out by no more.
constexpr double raise_share = 0.25;

/// Of the tolerance: that less than this stays is not measured further.
constexpr double good_enough = 0.5;

/// The names in a list that is separated by commas, without the blanks around them.
std::vector<std::string> listed(const std::string& list) {
    std::vector<std::string> names;
    for (std::size_t at = 0; at < list.size();) {
        const std::size_t end = std::min(list.find(',', at), list.size());
        const std::size_t first = list.find_first_not_of(' ', at);
        if (first < end) names.push_back(list.substr(first, list.find_last_not_of(' ', end - 1) + 1 - first));
        at = end + 1;
    }
    return names;
}

/// A cutter as valleys are found with it.
struct Probe {
    AxialLift lift;
    CutterCover cover;
    Probe(const PlanContext& context, const CutterProfile& profile, double slack)
        : lift(context.contact, profile), cover(profile, slack) {}
};

class CleanupPlanner {
public:
    CleanupPlanner(const CleanupSettings& settings, const PlanContext& context, const Progress& progress)
        : settings_(settings), context_(context), text_{context.unit}, cusp_(cusp_budget(settings, context)),
          chord_(chord_budget({0, "auto"}, cusp_)),
          allowance_(settings.allowance + context.tessellation_tolerance[1]), profile_(context.tool.cutter()),
          cover_(profile_, cusp_detail(cusp_)), lift_(context.contact, profile_, allowance_),
          grid_(*context.part, progress), side_(*context.part, progress) {
        radius_ = profile_.max_radius();
        ripple_ = settings.smallest_strip.is_number() ? settings.smallest_strip.number : radius_;
        overlap_ = settings.overlap.is_number() ? settings.overlap.number : 0.5 * radius_;
    }

    StrategyResult run(const Progress& progress) {
        const Tool& before = context_.further_tools.front();
        find(CutterProfile(before.cutter()), StripKind::valley, progress.part(0.02, 0.4));
        if (settings_.normal_change_limit.is_number()) {
            const double d = 2 / settings_.normal_change_limit.number;
            find(CutterProfile(AptCutter::ball(d, std::max(d, before.flute_length))), StripKind::sharp,
                 progress.part(0.4, 0.5, "Looking for sharp changes of normals"));
        }
        if (context_.left) {
            const EarlierLeft& left = *context_.left;
            if (settings_.left_points)
                find_left(left.points, ripple_, StripKind::no_posture, progress.part(0.4, 0.45));
            if (settings_.rest_material)
                find_left(left.rest, left.rest_spacing, StripKind::rest, progress.part(0.45, 0.5));
        }
        if (found_.empty())
            throw Error(ErrorCode::empty_result, settings_.name,
                        "tool " + std::to_string(settings_.previous_tool) + " leaves nowhere more than "
                            + text_(cusp_)
                            + (settings_.left_points || settings_.rest_material
                                   ? ", nor do the operations before"
                                   : ""),
                        "leave the operation out, or allow a smaller tolerance");
        name_strips();
        cut(progress.part(0.5, 0.9, "Planning passes"));
        hold(progress.part(0.9, 0.93));
        if (result_.passes.empty()
            && std::none_of(result_.strips.begin(), result_.strips.end(),
                            [](const Strip& s) { return s.enabled; }))
            throw Error(ErrorCode::empty_result, settings_.name, "all strips are switched off",
                        "switch one on, or leave the operation out");
        if (result_.passes.empty() && held_ > 0)
            throw Error(ErrorCode::empty_result, settings_.name,
                        "the tool's " + std::string(tool_body_name(held_by_))
                            + " would touch the part wherever there is something to cut",
                        settings_.tilt_limit > 0
                            ? "use a longer tool, or allow a larger tilt_limit"
                            : "use a longer tool, or allow it to be inclined (tilt_limit)");
        if (result_.passes.empty())
            throw Error(ErrorCode::empty_result, settings_.name,
                        "the tool can stand nowhere along the " + std::to_string(found_.size())
                            + " strips that tool " + std::to_string(settings_.previous_tool) + " left",
                        "use a smaller or longer tool");
        judge(progress.part(0.93, 1, "Measuring what stays"));
        finish();
        return std::move(result_);
    }

private:
    struct Found {
        StripKind kind;
        std::optional<ValleyCurve> curve;
        RestBand band;
        LeftStrip left; ///< of strips from places that were left; `band` has its facets
    };

    ValleyInput input_of(const Probe& probe) const {
        ValleyInput in;
        in.mesh = context_.part.get();
        in.grid = &grid_;
        in.side = &side_;
        in.lift = &probe.lift;
        in.cover = &probe.cover;
        in.tolerance = cusp_;
        in.ripple = ripple_;
        return in;
    }

    void find(const CutterProfile& profile, StripKind kind, const Progress& progress) {
        const Probe probe(context_, profile, cusp_detail(cusp_));
        const ValleyInput in = input_of(probe);
        Valleys valleys = find_valleys(in, progress.part(0, 0.6));
        if (!found_.empty()) leave_out_known(valleys);
        std::vector<RestBand> bands = rest_bands(in, valleys, progress.part(0.6, 1));
        for (RestBand& band : bands) {
            Found f;
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
        const double apart = std::max(spacing, 0.25 * radius_);
        // A point stands for all that its line was to cut there; a sample for itself.
        const double smallest = kind == StripKind::rest ? ripple_ : 0;
        PointGrid known(apart);
        for (const Found& f : found_)
            for (const auto& t : f.band.band)
                for (const Vec3& p : t)
                    known.add(p);
        std::vector<LeftPlace> others;
        for (const LeftPlace& place : places)
            if (!known.near_until(place.point, apart, [&](std::size_t i) {
                    return (known.points()[i] - place.point).norm() < apart;
                }))
                others.push_back(place);
        for (LeftStrip& strip : left_strips(context_, others, apart, overlap_, smallest, progress)) {
            Found f;
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

    /// Curves that are there already.
    void leave_out_known(Valleys& valleys) const {
        const std::size_t before = valleys.curves.size();
        const double within = 2 * valleys.step;
        PointGrid known(within);
        for (const Found& f : found_)
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
        if (valleys.curves.size() == before) return;
        // Numbers of curves have changed.
        PointGrid tips(within);
        std::vector<int> owner;
        for (std::size_t c = 0; c < valleys.curves.size(); ++c)
            for (const PencilPoint& p : valleys.curves[c].points) {
                tips.add(p.tip);
                owner.push_back(int(c));
            }
        for (Valleys::Tip& t : valleys.tips) {
            t.curve = -1;
            double least = valleys.step;
            tips.near(t.tip, valleys.step, [&](std::size_t i) {
                if (const double d = (tips.points()[i] - t.tip).norm(); d < least) {
                    least = d;
                    t.curve = owner[i];
                }
            });
        }
    }

    static const char* kind_word(const Found& f) {
        switch (f.kind) {
        case StripKind::sharp:
            return "Crease";
        case StripKind::no_posture:
            return "Points";
        case StripKind::rest:
            return "Rest";
        default:
            return f.curve ? "Valley" : "Hollow";
        }
    }
    std::string reason(const Found& f) const {
        const std::string tool = "tool " + std::to_string(settings_.previous_tool);
        switch (f.kind) {
        case StripKind::sharp:
            return "normals turn by more than the limit";
        case StripKind::no_posture:
            return std::to_string(f.left.places)
                   + (f.left.places == 1 ? " contact point was left" : " contact points were left")
                   + " by operations before";
        case StripKind::rest:
            return "the operations before leave " + text_(f.band.depth);
        default:
            return tool + (f.curve ? " touches both flanks, leaves " : " cannot enter, leaves ")
                   + text_(f.band.depth);
        }
    }

    void name_strips() {
        std::size_t number = 0;
        for (const Found& f : found_) {
            Strip s;
            s.kind = f.kind;
            s.name = kind_word(f) + (" " + std::to_string(++number));
            s.reason = reason(f);
            s.tool = settings_.tool;
            s.enabled = !is_switched_off(settings_.switched_off, s.name);
            s.band = f.band.band;
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
            result_.strips.push_back(std::move(s));
        }
    }

    StripCutting cutting() const {
        StripCutting with;
        with.mesh = context_.part;
        with.grid = &grid_;
        with.side = &side_;
        with.lift = &lift_;
        with.cover = &cover_;
        with.allowance = allowance_;
        with.cusp = std::max(cusp_ - chord_, 0.5 * cusp_);
        with.chord = chord_;
        with.overlap = overlap_;
        with.along_z = settings_.lift == CleanupSettings::Lift::z;
        with.one_way = settings_.pattern == CleanupSettings::Pattern::oneway;
        return with;
    }

    void cut(const Progress& progress) {
        const StripCutting with = cutting();
        result_.stepover_min = infinity;
        std::vector<StripCut> cuts(found_.size());
        std::vector<BandCut> touched;
        const Progress strips = progress.part(0, 0.7), within = progress.part(0, 0);
        parallel_for(found_.size(), 1, strips, [&](std::size_t i) {
            const Found& f = found_[i];
            if (!result_.strips[i].enabled) return;
            cuts[i] = f.left.piece.mesh ? cut_around_places(f, within)
                      : f.curve         ? cut_valley(with, *f.curve, f.band, within)
                                        : cut_hollow(with, f.band, within);
        });
        for (std::size_t i = 0; i < found_.size(); ++i) {
            if (!result_.strips[i].enabled) continue;
            StripCut& c = cuts[i];
            result_.stepover_min = std::min(result_.stepover_min, c.stepover_min);
            result_.stepover_max = std::max(result_.stepover_max, c.stepover_max);
            blocked_ += c.blocked;
            if (!found_[i].left.piece.mesh) touched.push_back({&found_[i].band, &c});
        }
        touch_up(with, touched, progress.part(0.7, 1));
        std::erase_if(cuts, [](const StripCut& c) { return c.passes.empty(); });
        if (result_.stepover_min == infinity) result_.stepover_min = result_.stepover_max;
        // From each strip to the nearest that is left.
        std::vector<char> done(cuts.size(), 0);
        Vec3 at = Vec3::Zero();
        for (std::size_t n = 0; n < cuts.size(); ++n) {
            std::size_t nearest = cuts.size();
            double least = infinity;
            for (std::size_t i = 0; i < cuts.size(); ++i) {
                if (done[i]) continue;
                const double d = n == 0 ? 0 : (cuts[i].passes.front().cl.front().tip - at).squaredNorm();
                if (d < least) {
                    least = d;
                    nearest = i;
                }
            }
            done[nearest] = 1;
            for (Pass& p : cuts[nearest].passes) {
                at = p.cl.back().tip;
                result_.passes.push_back(std::move(p));
            }
        }
    }

    StripCut cut_around_places(const Found& f, const Progress& progress) const {
        StrategyResult path = cut_left(
            context_, settings_, settings_.pattern == CleanupSettings::Pattern::oneway, f.left, progress);
        StripCut cut;
        cut.passes = std::move(path.passes);
        if (cut.passes.empty()) cut.blocked = f.band.length;
        cut.stepover_min = path.stepover_max > 0 ? path.stepover_min : infinity;
        cut.stepover_max = path.stepover_max;
        return cut;
    }

    /// Leaves out where shank or holder would touch, or inclines the tool there.
    void hold(const Progress& progress) {
        Tool tool = context_.tool;
        // A hair thinner: a shank as thick as the cutter runs along what the cutter has cut.
        const double thinner = 2 * std::max(chord_, tolerance::contact_distance);
        tool.shank_diameter = std::max(tool.shank_diameter - thinner, 0.5 * tool.shank_diameter);
        for (HolderSection& s : tool.holder)
            s.diameter = std::max(s.diameter - thinner, 0.5 * s.diameter);
        const ToolLift whole(context_.contact, tool, {allowance_, 0, 0});
        std::vector<TiltedPass> kept(result_.passes.size());
        parallel_for(result_.passes.size(), 1, progress, [&](std::size_t i) {
            kept[i] = settings_.tilt_limit > 0
                          ? tilted_where_held({&whole, settings_.tilt_limit, chord_, raise_share * cusp_},
                                              result_.passes[i], progress)
                          : upright_where_free(whole, result_.passes[i], progress);
        });
        result_.passes.clear();
        double largest = 0;
        for (TiltedPass& k : kept) {
            held_ += k.lost;
            if (k.by != ToolBody::none) held_by_ = k.by;
            largest = std::max(largest, k.largest);
            for (Pass& p : k.passes)
                result_.passes.push_back(std::move(p));
        }
        if (settings_.tilt_limit > 0) {
            own_.lead_min = 0;
            own_.lead_max = largest;
        }
        for (std::size_t i = 0; i < result_.passes.size(); ++i)
            result_.passes[i].drive = int(i);
        result_.drive_planes = int(result_.passes.size());
    }

    /// A pass without the locations at which shank or holder would touch.
    TiltedPass upright_where_free(const ToolLift& whole, const Pass& pass, const Progress& progress) const {
        TiltedPass kept;
        ToolLift::Hint hint;
        Pass run = pass;
        run.cl.clear();
        run.cc.clear();
        for (std::size_t k = 0; k < pass.cl.size(); ++k) {
            if (k % 256 == 0) progress.check();
            const ToolContact c = whole.contact_above({pass.cl[k].tip, pass.cl[k].axis}, chord_, hint);
            if (c.body == ToolBody::shank || c.body == ToolBody::holder) {
                kept.by = c.body;
                if (k > 0) kept.lost += (pass.cl[k].tip - pass.cl[k - 1].tip).norm();
                if (run.cl.size() > 1) kept.passes.push_back(run);
                run.cl.clear();
                run.cc.clear();
                continue;
            }
            run.cl.push_back(pass.cl[k]);
            run.cc.push_back(pass.cc[k]);
        }
        if (run.cl.size() > 1) kept.passes.push_back(std::move(run));
        return kept;
    }

    /// Of facets that are small against the cutter one a cell is enough to measure what stays.
    std::vector<std::array<Vec3, 3>> thinned(const std::vector<std::array<Vec3, 3>>& band) const {
        const double cell = judge_share * radius_;
        PointGrid seen(cell);
        std::vector<std::array<Vec3, 3>> kept;
        for (const auto& t : band) {
            const auto& [a, b, c] = t;
            const double longest2 =
                std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
            if (longest2 > cell * cell || seen.add_first((a + b + c) / 3)) kept.push_back(t);
        }
        return kept;
    }

    /// What stays of the bands, against what the cutter could reach.
    void judge(const Progress& progress) {
        std::vector<CutterLocation> stands;
        PointGrid near(radius_);
        bool inclined = false;
        const double spacing = std::sqrt(8 * std::max(profile_.cutter().r, 0.1 * radius_) * 0.1 * cusp_);
        for (const Pass& pass : result_.passes)
            for (std::size_t k = 0; k < pass.cl.size(); ++k) {
                const CutterLocation& b = pass.cl[k];
                const CutterLocation& a = k > 0 ? pass.cl[k - 1] : b;
                inclined = inclined || b.axis != Vec3::UnitZ();
                const auto parts = std::size_t((b.tip - a.tip).norm() / spacing) + 1;
                for (std::size_t i = 1; i <= parts; ++i) {
                    const double t = double(i) / double(parts);
                    stands.push_back(
                        {a.tip + t * (b.tip - a.tip), (a.axis + t * (b.axis - a.axis)).normalized()});
                    near.add(Vec3(stands.back().tip.x(), stands.back().tip.y(), 0));
                }
            }
        // An inclined cutter's contacts are farther from its tip, seen from above, by up to its radius.
        const double reach = (inclined ? 2.1 : 1.1) * radius_ + cusp_;
        const auto distance = [&](const Vec3& p, const CutterLocation& at) {
            const Vec3 rel = p - at.tip;
            const double along = rel.dot(at.axis);
            return cover_.distance(Vec3((rel - along * at.axis).norm(), 0, along));
        };
        const ValleyInput in = reach_of(cutting());
        struct Sum {
            double reached = 0, hollow = 0, missed_area = 0, missed = 0, area = 0;
            Vec3 hollow_at = Vec3::Zero(), missed_at = Vec3::Zero();
        };
        Sum total;
        for (std::size_t s = 0; s < found_.size(); ++s) {
            if (!result_.strips[s].enabled) continue;
            const auto band = thinned(found_[s].band.band);
            total = parallel_reduce(
                band.size(), 64, total, progress.part(double(s) / double(found_.size()), 1),
                [&](std::size_t begin, std::size_t end) {
                    Sum sum;
                    LiftHint hint;
                    for (std::size_t i = begin; i < end; ++i) {
                        const auto& [a, b, c] = band[i];
                        const Vec3 cross = (b - a).cross(c - a);
                        const double area = 0.5 * cross.norm();
                        // The normals of needles mean nothing.
                        if (!(area > needle_share
                                         * std::max({(b - a).squaredNorm(), (c - a).squaredNorm(),
                                                     (c - b).squaredNorm()})))
                            continue;
                        const Vec3 n = side_.towards_tool(cross.normalized());
                        const Vec3 p = (a + b + c) / 3 + allowance_ * n;
                        const double limit = nearest_touch(in, p, n, hint).gap;
                        double rest = infinity;
                        near.near_until(Vec3(p.x(), p.y(), 0), reach, [&](std::size_t t) {
                            rest = std::min(rest, distance(p, stands[t]));
                            return rest <= good_enough * cusp_;
                        });
                        sum.area += area;
                        if (limit > cusp_ && rest < infinity && rest > std::max(sum.hollow, cusp_)) {
                            sum.hollow = rest;
                            sum.hollow_at = p;
                        }
                        if (limit <= 0.25 * cusp_ && rest < infinity)
                            sum.reached = std::max(sum.reached, rest);
                        if (rest > limit + (1 + tolerance::uncut_margin) * cusp_) {
                            sum.missed_area += area;
                            if (rest > sum.missed) {
                                sum.missed = rest;
                                sum.missed_at = p;
                            }
                        }
                    }
                    return sum;
                },
                [](Sum x, const Sum& y) {
                    x.area += y.area;
                    x.reached = std::max(x.reached, y.reached);
                    x.missed_area += y.missed_area;
                    if (y.hollow > x.hollow) {
                        x.hollow = y.hollow;
                        x.hollow_at = y.hollow_at;
                    }
                    if (y.missed > x.missed) {
                        x.missed = y.missed;
                        x.missed_at = y.missed_at;
                    }
                    return x;
                });
        }
        result_.cusp_max = total.reached;
        auto& warnings = result_.warnings;
        if (total.hollow > 0)
            warnings.push_back("the cutter is too large for the innermost of the strips: up to "
                               + text_(total.hollow) + " stays, most at " + text_(total.hollow_at)
                               + ": use a smaller tool there");
        if (total.missed_area > 0)
            warnings.push_back(
                format_number(std::max(100 * total.missed_area / total.area, 1e-3), 2)
                + " % of the strips stays uncut"
                + (total.missed < infinity ? " by up to " + text_(total.missed) : std::string()) + ", as at "
                + text_(total.missed_at));
    }

    void finish() {
        auto record = std::make_shared<CleanupRecord>();
        record->previous = context_.further_tools.front();
        for (std::size_t i = 0; i < found_.size(); ++i)
            if (found_[i].curve && found_[i].kind == StripKind::valley)
                for (const PencilPoint& p : found_[i].curve->points)
                    record->touches.push_back({i, p.center, p.tip, p.touch, p.gap});
        own_.record = std::move(record);
        result_.detail = std::move(own_);
        result_.chord_tolerance = chord_;
        auto& warnings = result_.warnings;
        if (blocked_ > ripple_)
            warnings.push_back("the cutter has no place along " + text_(blocked_)
                               + " of its passes: they are left out there");
        if (held_ > 0)
            warnings.push_back(
                "the " + std::string(tool_body_name(held_by_)) + " would touch the part along " + text_(held_)
                + " of passes, which are left out: use a longer tool"
                + (settings_.tilt_limit > 0 ? "" : ", or allow it to be inclined (tilt_limit)"));
    }

    const CleanupSettings& settings_;
    const PlanContext& context_;
    PlanText text_;
    double cusp_, chord_, allowance_;
    CutterProfile profile_;
    CutterCover cover_;
    AxialLift lift_;
    FacetGrid grid_;
    UpSide side_;
    double radius_ = 0, ripple_ = 0, overlap_ = 0;
    std::vector<Found> found_;
    double blocked_ = 0, held_ = 0;
    ToolBody held_by_ = ToolBody::none;
    StrategyResult result_;
    CleanupPath own_;
};

} // namespace

const ParameterTable<CleanupSettings>& cleanup_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        using S = CleanupSettings;
        ParameterTable<S> t;
        add_common_parameters(t);
        t.add(&S::previous_tool,
              {.key = "previous_tool",
               .label = "Previous tool",
               .help = "Number of the tool that cut the part before: clean-up looks for what it "
                       "could not enter.",
               .kind = K::integer,
               .quantity = Quantity::count,
               .minimum = 1,
               .maximum = largest_tool_number,
               .stage = Stage::cutter});
        t.add(&S::normal_change_limit,
              {.key = "normal_change_limit",
               .label = "Normal change limit",
               .help = "Turn of the surface's normal per length, in radians per mm, above which a hollow is "
                       "a strip "
                       "even where the previous tool could enter it; auto leaves that to the previous tool.",
               .kind = K::number_or_word,
               .minimum = 1e-4,
               .maximum = 1e3,
               .words = {"auto"},
               .advanced = true});
        t.add_choice(&S::lift,
                     {.key = "lift",
                      .label = "Lift",
                      .help = "How the tool is moved out of what it would cut: along a vector fitted to "
                              "the strip, or along Z.",
                      .words = {"strip", "z"}});
        t.add(&S::overlap,
              {.key = "overlap",
               .label = "Overlap",
               .help = "How far passes go on over what the previous tool has cut; auto is half the "
                       "tool's radius.",
               .kind = K::number_or_word,
               .quantity = Quantity::length,
               .minimum = 0,
               .maximum = 1000,
               .words = {"auto"}});
        t.add(&S::smallest_strip,
              {.key = "smallest_strip",
               .label = "Smallest strip",
               .help =
                   "Valleys shorter than this are left out as noise, and shorter interruptions are bridged; "
                   "auto is the tool's radius.",
               .kind = K::number_or_word,
               .quantity = Quantity::length,
               .minimum = 0,
               .maximum = 1000,
               .words = {"auto"},
               .advanced = true});
        t.add_choice(&S::pattern,
                     {.key = "pattern",
                      .label = "Pattern",
                      .help = "zigzag cuts neighbouring passes to and fro; oneway all in the same "
                              "direction.",
                      .words = {"zigzag", "oneway"}});
        t.add(&S::left_points,
              {.key = "left_points",
               .label = "Points left before",
               .help = "Strips also around contact points that operations before left to clean-up, as those "
                       "without a free posture.",
               .kind = K::boolean});
        t.add(&S::rest_material,
              {.key = "rest_material",
               .label = "Rest material",
               .help = "Strips also where more than the tolerance stands after the operations before: their "
                       "programs are verified first.",
               .kind = K::boolean});
        t.add(&S::tilt_limit,
              {.key = "tilt_limit",
               .label = "Tilt limit",
               .help =
                   "Largest inclination of the tool axis, used where shank or holder would touch the part. "
                   "0 keeps the tool upright; above 0 the program is one of five axes.",
               .kind = K::number,
               .quantity = Quantity::angle,
               .minimum = 0,
               .maximum = radians(75)});
        t.add(&S::switched_off, {.key = "switched_off",
                                 .label = "Switched off",
                                 .help = "Names of strips that are found but not cut, separated by commas.",
                                 .kind = K::text});
        return t;
    }();
    return table;
}

std::span<const CleanupRecord::Touch> CleanupRecord::of(std::size_t strip) const {
    const auto [first, last] =
        std::equal_range(touches.begin(), touches.end(), Touch{.strip = strip},
                         [](const Touch& a, const Touch& b) { return a.strip < b.strip; });
    return {first, last};
}

bool is_switched_off(const std::string& list, const std::string& name) {
    const auto names = listed(list);
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string with_switched(const std::string& list, const std::string& name, bool on) {
    std::string result;
    for (const std::string& n : listed(list))
        if (n != name) result += (result.empty() ? "" : ", ") + n;
    if (!on) result += (result.empty() ? "" : ", ") + name;
    return result;
}

StrategyResult Cleanup::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    if (context.further_tools.empty())
        throw Error(ErrorCode::missing_reference, "previous_tool", "the tool that cut before is not known",
                    "give the number of the previous tool");
    if (settings_.previous_tool == settings_.tool)
        throw Error(ErrorCode::out_of_range, "previous_tool",
                    "tool " + std::to_string(settings_.tool) + " is to clean up what it left itself",
                    "choose a smaller tool, or the one that cut before");
    return CleanupPlanner(settings_, context, progress.part(0, 0.02)).run(progress);
}

} // namespace facetmill
