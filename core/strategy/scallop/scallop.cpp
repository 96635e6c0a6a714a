#include "core/strategy/scallop/scallop.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/strategy/finish3/finish_warnings.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/pass_order.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/plan/shared_parameters.h"
#include "core/strategy/scallop/curve_front.h"
#include "core/strategy/scallop/detours.h"
#include "core/strategy/scallop/field_contours.h"
#include "core/strategy/scallop/field_distances.h"
#include "core/strategy/scallop/field_marks.h"
#include "core/strategy/scallop/left_by_lines.h"
#include "core/strategy/scallop/middle_lines.h"
#include "core/strategy/scallop/spiral_lines.h"
#include "core/strategy/scallop/wall_feet.h"
#include "core/strategy/surface/lift_line.h"
#include "core/strategy/surface/slope_facets.h"
#include "core/strategy/waterline/contour_passes.h"
#include "core/strategy/waterline/level_order.h"
#include "core/strategy/waterline/level_sweep.h"

#include <cmath>
#include <optional>

namespace facetmill {

namespace {

const OperationRegistration scallop_registration("scallop", "Constant scallop",
                                                 [] { return std::make_unique<Scallop>(); });

/// Places of the grid: so far apart in radii, and so many to a step; so many at most, and on a larger part
/// never so far apart as that share of a step.
constexpr double grid_radii = 0.1, places_a_step = 7, max_scallop_places = 6e6, coarsest_steps = 0.5;
/// The first line lies so far from the border, in steps: half a step would do, but the border is known to a
/// place of the grid.
constexpr double first_line = 0.3;
/// At the foot of a wall it lies so far from it: nothing else comes into the corner.
constexpr double foot_line = 0.005;
/// Lines are thinned to this share of a step, and that one of the cusp allowed: at feet of walls they are
/// near.
constexpr double line_share = 0.01, line_cusp_part = 0.15;
/// Steeper moves go upright, and beside it level.
constexpr double upright_slope = 20;
/// Open lines shorter than so many radii are not worth their links.
constexpr double shortest_line = 0.1;
constexpr std::size_t max_lines = 20000;
/// Crests between lines are to be so high, of what the chord tolerance leaves of the cusp allowed: among
/// facets as large as steps some are a fifth higher.
constexpr double line_cusp_share = 0.95;
/// Lines are added along what is left above the one, in the cusp that is asked for, where some of it is above
/// the other; so often. Nearer to the lines than so many steps nobody asks. Pieces that are so large with
/// what is half a step round them are spots.
constexpr double left_low = 1.12, left_top = 1.2, left_from = 0.3, joined_spots = 0.75, largest_spot = 2;
constexpr int adding_rounds = 3;
/// What is overlooked is of no account up to that share of the surface; else lines go there, so often. Spots
/// so near to each other, in steps, get one.
constexpr double max_overlooked = 2e-5, overlooked_joined = 0.15;
constexpr int overlooked_rounds = 4;
/// As long as a round leaves no more than that of what the one before did.
constexpr double worth_another = 0.7;
/// Steps are corrected so often by what lines leave.
constexpr int correcting_rounds = 2;

class ScallopPlanner {
public:
    ScallopPlanner(const ScallopSettings& settings, const PlanContext& context, const Progress& progress);
    PlannedPasses run(bool judged);

private:
    void make_field(const Progress& progress);
    void make_front(const Progress& progress);
    double first_value() const;
    bool from_curve() const;
    /// In the view.
    Vec3 asked_place() const {
        return context_.to_setup.transpose()
               * Vec3(settings_.place[0], settings_.place[1], settings_.place[2]);
    }
    std::vector<ScallopField::Seed> seeds() const;
    std::vector<double> distances(const Progress& progress) const;
    std::vector<FieldContour> lines_of(const std::vector<double>& distance, const Progress& progress) const;
    std::vector<double> away_from_lines(const std::vector<double>& distance, const Progress& progress) const;
    void find_lines(const Progress& progress);
    void add_where_left(const std::vector<double>& away, const Progress& progress);
    void make_passes(const std::vector<FieldContour>& lines, const Progress& progress);
    void add_overlooked(const Progress& progress);
    std::vector<Pass> cut_pieces(Pass pass) const;
    Pass pass_over(const FieldContour& line, const Progress& progress) const;
    void begin_near_each_other();
    UncutReport uncut(bool tell_passed, const Progress& progress) const;
    void add_warnings();
    [[noreturn]] void refuse() const;
    CutterContact contact(const Vec3& tip) const {
        const Vec2 p = tip.head<2>();
        const TipTouch touch = tell_(p, lift_.contact(p.x(), p.y()));
        return touch.any ? CutterContact{touch.point, touch.normal} : CutterContact{tip, Vec3::UnitZ()};
    }

    const ScallopSettings& settings_;
    const PlanContext& context_;
    const Progress& progress_;
    PlanText text_;
    double cusp_allowed_, allowance_, chord_, line_cusp_;
    CutterProfile profile_;
    CutterCover cover_;
    AxialLift lift_;
    TouchTeller tell_;
    ScallopSteps steps_;
    LineTolerance fine_;
    std::optional<ScallopField> field_;
    CurveFront front_;
    std::vector<FieldContour> lines_;
    PassFilter filter_;
    StrategyResult result_;
    SlopePiece piece_;
    UncutReport uncut_;
};

ScallopPlanner::ScallopPlanner(const ScallopSettings& settings, const PlanContext& context,
                               const Progress& progress)
    : settings_(settings), context_(context), progress_(progress), text_{context.unit, context.to_setup},
      cusp_allowed_(cusp_budget(settings, context)),
      allowance_(settings.allowance + context.tessellation_tolerance[1]),
      chord_(chord_budget(settings.chord_tolerance, cusp_allowed_)),
      line_cusp_(line_cusp_share * std::max(cusp_allowed_ - chord_, 0.5 * cusp_allowed_)),
      profile_(context.tool.cutter()), cover_(profile_, cusp_detail(cusp_allowed_)),
      lift_(context.contact, profile_, allowance_),
      tell_(context.contact, cover_, facets_of_part(context), allowance_),
      steps_(cover_, line_cusp_, progress.part(0, 0)),
      filter_(settings, context, profile_,
              {cusp_allowed_, allowance_, chord_, settings.holder_clearance, settings.tilt_limit,
               settings.rest_only},
              [this](const Vec3& tip) { return contact(tip); }) {
    fine_.below = fine_.above = 0.5 * chord_;
    fine_.spacing = safe_spacing(profile_, fine_.below);
}

void ScallopPlanner::refuse() const {
    throw Error(ErrorCode::empty_result, settings_.name,
                std::string("nothing of the part that can be cut ") + context_.seen_from()
                    + " is less steep than " + format_number(settings_.slope_limit * 180 / pi, 3)
                    + " degrees",
                "widen the slope limit, or cut it by levels (waterline)");
}

void ScallopPlanner::make_field(const Progress& progress) {
    piece_ = piece_between(context_, {0, settings_.slope_limit}, progress.part(0, 0.02));
    if (!piece_.mesh) refuse();
    const double radius = cover_.radius();
    ScallopField::Options options;
    if (settings_.stepover.is_number()) options.step = settings_.stepover.number;
    const double step = options.step ? *options.step : steps_.down(0).apart;
    const Box3 box = context_.part->box();
    const double beyond = radius + allowance_, width = box.size().x() + 2 * beyond,
                 height = box.size().y() + 2 * beyond;
    // A taper is wide where it hardly cuts.
    const AptCutter& shape = profile_.cutter();
    const double round = std::min(radius, std::max(shape.e + shape.r, 0.25 * radius));
    const double wanted = std::min(grid_radii * round, step / places_a_step);
    const double spacing = std::max(wanted, std::sqrt(width * height / max_scallop_places));
    if (spacing > coarsest_steps * step)
        throw Error(ErrorCode::limit_exceeded, settings_.name,
                    "a part of " + text_(width) + " by " + text_(height)
                        + " asks for too many passes of this tool",
                    "check the part's units, or take a larger tool or tolerance");
    options.steepest = settings_.slope_limit;
    options.within = context_.within.get();
    options.spacing = spacing;
    options.beyond = beyond + 2 * spacing;
    field_.emplace(lift_, tell_, steps_, box, options, progress);
    if (!field_->any()) refuse();
}

bool ScallopPlanner::from_curve() const {
    return settings_.from == ScallopSettings::From::curve && !context_.curves.empty()
           && !context_.curves[0].all.empty();
}

/// Of a curve that is itself the line at 0.
double ScallopPlanner::first_value() const {
    if (settings_.from == ScallopSettings::From::place) return 0.5;
    return from_curve() ? 1 : first_line;
}

void ScallopPlanner::make_front(const Progress& progress) {
    if (!from_curve()) return;
    const NamedCurves& curves = context_.curves[0];
    front_ = curve_front(*field_, curves.all, settings_.open, progress);
    if (!front_.lines.empty()) return;
    const Vec2& at = curves.all.front().points.front();
    throw Error(ErrorCode::out_of_range, boundary_place(curves.name),
                "all of it lies off the part, as at " + text_(Vec3(at.x(), at.y(), context_.part_box.hi.z())),
                "move it onto the part");
}

std::vector<ScallopField::Seed> ScallopPlanner::seeds() const {
    if (from_curve()) return front_.seeds;
    std::vector<ScallopField::Seed> seeds;
    if (settings_.from == ScallopSettings::From::place) {
        seeds.push_back({field_->nearest(asked_place()), 0});
        return seeds;
    }
    for (const std::size_t i : field_->border())
        seeds.push_back({i, field_->at_foot(i) ? first_line - foot_line : 0});
    return seeds;
}

/// In steps from where lines begin.
std::vector<double> ScallopPlanner::distances(const Progress& progress) const {
    std::vector<ScallopField::Seed> from = seeds();
    std::vector<double> distance = field_distances(field_->grid(), from, progress.part(0, 0.7));
    if (settings_.from != ScallopSettings::From::place && !from_curve()) return distance;
    // Pieces that no line comes to are cut from their own borders.
    bool apart = false;
    for (const std::size_t i : field_->border())
        if (!(distance[i] < infinity)) {
            from.push_back({i, first_value() - (field_->at_foot(i) ? foot_line : first_line)});
            apart = true;
        }
    return apart ? field_distances(field_->grid(), from, progress.part(0.7, 1)) : distance;
}

/// One step apart.
std::vector<FieldContour> ScallopPlanner::lines_of(const std::vector<double>& distance,
                                                   const Progress& progress) const {
    double most = 0;
    for (const double d : distance)
        if (d < infinity) most = std::max(most, d);
    if (most > double(max_lines))
        throw Error(ErrorCode::limit_exceeded, "stepover",
                    "the tolerance asks for more than " + std::to_string(max_lines) + " passes side by side",
                    "allow a larger tolerance or set a step-over");
    std::vector<double> values;
    for (double value = first_value(); value < most; value += 1)
        values.push_back(value);
    std::vector<FieldContour> lines = front_.lines;
    const auto add = [&](std::span<const double> levels) {
        for (auto& more : field_contours(field_->grid(), distance, levels, progress.part(0, 1)))
            std::move(more.begin(), more.end(), std::back_inserter(lines));
    };
    add(values);
    if (lines.empty()) // smaller than a step
        add(std::array{0.5 * most});
    for (FieldContour& line : lines)
        move_to_feet(*field_, lift_, settings_.slope_limit, line, progress);
    return lines;
}

/// Of every place from the nearest line, in steps.
std::vector<double> ScallopPlanner::away_from_lines(const std::vector<double>& distance,
                                                    const Progress& progress) const {
    std::vector<ScallopField::Seed> seeds;
    const double first = first_value();
    for (const FieldContour& line : lines_)
        for (const std::size_t i : line.corners)
            seeds.push_back({i, std::abs(distance[i] - first - std::round(distance[i] - first))});
    return seeds.empty() ? std::vector<double>(field_->size(), infinity)
                         : field_distances(field_->grid(), seeds, progress);
}

void ScallopPlanner::find_lines(const Progress& progress) {
    std::vector<double> distance = distances(progress.part(0, 0.2));
    lines_ = lines_of(distance, progress.part(0.2, 0.3));
    for (int round = 0; round < correcting_rounds && !settings_.stepover.is_number(); ++round) {
        const auto away = away_from_lines(distance, progress);
        const LeftByLines left(*field_, cover_, lift_, steps_.down(0).apart, lines_, progress.part(0.3, 0.3));
        field_->shorten_steps(step_corrections(*field_, left, away, line_cusp_, progress.part(0.3, 0.5)));
        distance = distances(progress.part(0.5, 0.6));
        lines_ = lines_of(distance, progress.part(0.6, 0.6));
    }
    std::vector<double> away;
    if (settings_.spiral)
        lines_ = spiral_lines(*field_, distance, std::move(lines_), progress.part(0.6, 0.65));
    else if (!settings_.stepover.is_number())
        away = away_from_lines(distance, progress.part(0.6, 0.7));
    if (!settings_.stepover.is_number()) add_where_left(away, progress.part(0.7, 1));
}

/// Along the middle of what the lines leave above what is allowed: where fronts meet, and wherever steps were
/// too long for the surface. `away`: what is near the lines need not be looked at; empty: all is.
void ScallopPlanner::add_where_left(const std::vector<double>& away, const Progress& progress) {
    std::vector<char> asked(field_->size());
    for (std::size_t i = 0; i < asked.size(); ++i)
        asked[i] = field_->cut(i) && (away.empty() || away[i] >= left_from);
    for (int round = 0; round < adding_rounds; ++round) {
        const Progress here = progress.part(double(round) / adding_rounds, double(round + 1) / adding_rounds);
        const LeftByLines left(*field_, cover_, lift_, steps_.down(0).apart, lines_, here.part(0, 0.2));
        const std::vector<double> high = left_high(*field_, left, asked, line_cusp_, here.part(0.2, 0.8));
        std::vector<char> pieces = pieces_above(*field_, high, left_low * line_cusp_, left_top * line_cusp_);
        if (std::none_of(pieces.begin(), pieces.end(), [](char c) { return c; })) return;
        const double step = steps_.down(0).apart;
        asked = grown(*field_, pieces, joined_spots, here.part(0.8, 0.85));
        add_detours(*field_, lift_, {left, high, line_cusp_, largest_spot * step}, lines_, pieces,
                    here.part(0.85, 0.9));
        pieces = grown(*field_, pieces, round == 0 ? joined_spots : 0.4 * joined_spots, here.part(0.9, 0.9));
        auto lines = middle_lines(*field_, high, std::move(pieces),
                                  (round == 0 ? 1 : 0.7) * largest_spot * step, here.part(0.9, 1));
        std::move(lines.begin(), lines.end(), std::back_inserter(lines_));
    }
}

Pass ScallopPlanner::pass_over(const FieldContour& line, const Progress& progress) const {
    std::vector<Vec2> places = line.places;
    if (line.closed) places.push_back(places.front());
    const LiftField field{&lift_};
    const double step = settings_.stepover.is_number() ? settings_.stepover.number : steps_.smallest();
    Pass pass;
    const auto put = [&](const Vec3& tip) {
        pass.cl.push_back({tip, Vec3::UnitZ()});
        pass.cc.push_back(contact(tip));
    };
    const auto add = [&](const Vec2& p, double z) {
        const Vec3 tip(p.x(), p.y(), z);
        // What is nearly upright is: over the rim of a wall it must not begin to fall before it is beside it.
        if (!pass.cl.empty()) {
            const Vec3 from = pass.cl.back().tip;
            const double fall = from.z() - z, far = (p - from.head<2>()).norm();
            if (std::abs(fall) > std::max(upright_slope * far, fine_.below) && far > 0)
                put(fall > 0 ? Vec3(p.x(), p.y(), from.z()) : Vec3(from.x(), from.y(), z));
        }
        put(tip);
    };
    const std::vector<std::size_t> kept =
        kept_places(places, std::min(line_share * step, line_cusp_part * cusp_allowed_));
    for (std::size_t k = 1; k < kept.size(); ++k) {
        progress.check();
        const Vec2 &a = places[kept[k - 1]], &b = places[kept[k]];
        const double length = (b - a).norm();
        if (!(length > 0)) continue;
        const Vec2 along = (b - a) / length;
        const auto points =
            thinned(lift_line(field, a, along, 0, length, fine_, progress), fine_.below, fine_.above);
        for (std::size_t i = pass.cl.empty() ? 0 : 1; i < points.size(); ++i)
            add(i + 1 == points.size() ? b : Vec2(a + points[i].s * along), points[i].z);
    }
    if (line.closed && pass.cl.size() > 1) pass.cl.back() = pass.cl.front();
    return pass;
}

/// Lines are smooth, what is cut need not be: where one leaves it, the tip might come down beside the part.
std::vector<Pass> ScallopPlanner::cut_pieces(Pass pass) const {
    const auto cut = [&](const CutterLocation& c) {
        return std::isfinite(c.tip.z())
               && (field_->cut_at(c.tip.head<2>()) || stands_at_foot(*field_, c.tip, settings_.slope_limit));
    };
    if (std::all_of(pass.cl.begin(), pass.cl.end(), cut)) return {std::move(pass)};
    std::vector<Pass> pieces;
    bool open = false;
    for (std::size_t i = 0; i < pass.cl.size(); ++i) {
        if (!cut(pass.cl[i])) {
            open = false;
            continue;
        }
        if (!open) pieces.emplace_back();
        open = true;
        pieces.back().cl.push_back(pass.cl[i]);
        pieces.back().cc.push_back(pass.cc[i]);
    }
    return pieces;
}

void ScallopPlanner::make_passes(const std::vector<FieldContour>& lines, const Progress& progress) {
    std::vector<Pass> made(lines.size());
    parallel_for(lines.size(), 1, progress,
                 [&](std::size_t i) { made[i] = pass_over(lines[i], progress.part(0, 0)); });
    for (Pass& line : made)
        for (Pass& pass : cut_pieces(std::move(line))) {
            if (pass.cl.size() < 2) continue;
            if (!is_closed(pass) && arc_lengths(pass).back() < shortest_line * cover_.radius()) continue;
            pass.drive = result_.drive_planes++;
            result_.passes.push_back(std::move(pass));
        }
    if (result_.passes.empty()) refuse();
}

/// Closed passes begin where the one before ends.
void ScallopPlanner::begin_near_each_other() {
    for (std::size_t k = 1; k < result_.passes.size(); ++k) {
        Pass& pass = result_.passes[k];
        if (!is_closed(pass)) continue;
        const Vec3& at = result_.passes[k - 1].cl.back().tip;
        std::size_t nearest = 0;
        for (std::size_t i = 0; i < pass.cl.size(); ++i)
            if ((pass.cl[i].tip - at).squaredNorm() < (pass.cl[nearest].tip - at).squaredNorm()) nearest = i;
        begin_at(pass, nearest);
    }
}

UncutReport ScallopPlanner::uncut(bool tell_passed, const Progress& progress) const {
    UncutInput input;
    input.mesh = piece_.mesh.get();
    input.lift = &lift_;
    input.cover = &cover_;
    input.allowance = allowance_;
    input.tell_passed = tell_passed;
    return uncut_by_levels(input, context_, {result_.passes, filter_.held().left}, profile_, cusp_allowed_,
                           progress);
}

/// Heights are known over the places of the grid; the surface itself is asked at last. Where it is cut too
/// little and a tip could do it, a line more goes.
void ScallopPlanner::add_overlooked(const Progress& progress) {
    const double spot = largest_spot * std::min(steps_.down(0).apart, cover_.radius());
    double before = infinity;
    for (int round = 0; round < overlooked_rounds; ++round) {
        const Progress here =
            progress.part(double(round) / overlooked_rounds, double(round + 1) / overlooked_rounds);
        const UncutReport left = uncut(true, here.part(0, 0.8));
        const double area = left.passed_by.area;
        if (area <= max_overlooked * left.area || area > worth_another * before) return;
        before = area;
        std::vector<char> marks(field_->size(), 0);
        std::vector<double> heights(field_->size(), 0);
        for (const Vec3& tip : left.passed_tips)
            for (const std::size_t i : field_->around(tip.head<2>())) {
                marks[i] = 1;
                heights[i] += 1;
            }
        marks = grown(*field_, marks, overlooked_joined, here.part(0.8, 0.9));
        auto lines = middle_lines(*field_, heights, std::move(marks), spot, here.part(0.9, 0.95));
        for (FieldContour& line : lines)
            move_to_feet(*field_, lift_, settings_.slope_limit, line, here.part(0.95, 0.95));
        make_passes(lines, here.part(0.95, 1));
    }
}

void ScallopPlanner::add_warnings() {
    auto& warnings = result_.warnings;
    const double all = piece_.all + piece_.walls;
    if (const double steeper = all - piece_.area; steeper > 1e-9 * all)
        warnings.push_back(
            share_text(steeper, all)
            + " of the surface is steeper than the slope limit and is left to other operations");
    if (uncut_.out_of_reach.height > 0)
        warnings.push_back(hollows_warning(uncut_.out_of_reach, piece_.all, text_));
    if (const UncutPlaces& u = uncut_.passed_by;
        u.height > (1 + tolerance::uncut_margin) * std::max(result_.cusp_max, cusp_allowed_))
        warnings.push_back("the passes leave more than expected: " + surface_share(u, piece_.all)
                           + " stays uncut by up to " + text_(u.height) + ", most at " + text_(u.at)
                           + ": choose a smaller tolerance or step-over");
    add_kept_from_warnings(uncut_, piece_.all, filter_, context_, warnings);
    result_.cusp_max = std::max(result_.cusp_max, uncut_.passed_by.height);
}

PlannedPasses ScallopPlanner::run(bool judged) {
    progress_.part(0, 1, "Measuring steps over the surface").set(0);
    make_field(progress_.part(0, 0.3));
    make_front(progress_.part(0.3, 0.3));
    find_lines(progress_.part(0.3, 0.5, "Counting steps from the border"));
    make_passes(lines_, progress_.part(0.5, 0.7, "Making passes"));
    if (judged && !settings_.stepover.is_number()) add_overlooked(progress_.part(0.7, 0.75));
    result_.chord_tolerance = chord_;
    result_.cusp_max = cusp_allowed_;
    result_.stepover_min = settings_.stepover.is_number() ? settings_.stepover.number : steps_.smallest();
    result_.stepover_max = settings_.stepover.is_number() ? settings_.stepover.number : steps_.down(0).apart;
    filter_.leave_out_held_up(result_.passes, progress_.part(0.75, 0.78));
    filter_.leave_out_air(result_.passes, progress_.part(0.78, 0.8));
    const double top = std::max(context_.part_box.hi.z(), context_.stock_box.hi.z()) + settings_.allowance
                       + settings_.clearance;
    order_by_travel(result_.passes, settings_.pattern == ScallopSettings::Pattern::zigzag, top,
                    progress_.part(0.8, 0.84));
    begin_near_each_other();
    filter_.leave_out_beside_stock(result_.passes, progress_.part(0.84, 0.86));
    if (judged) {
        uncut_ = uncut(false, progress_.part(0.86, 1, "Looking for what stays uncut"));
        add_warnings();
    }
    progress_.set(1);
    return {std::move(result_), filter_.held(), filter_.beside_stock()};
}

} // namespace

const ParameterTable<ScallopSettings>& scallop_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        using S = ScallopSettings;
        ParameterTable<S> t;
        add_common_parameters(t);
        add_tool_axis_parameter(t);
        t.add(&S::stepover, length_or_word_parameter(
                                {.key = "stepover",
                                 .label = "Step-over",
                                 .help = "Distance between neighbouring passes over the surface: adaptive is "
                                         "everywhere what leaves cusps of the tolerance; a length "
                                         "is kept whatever cusps it leaves.",
                                 .words = {"adaptive"}}));
        t.add_choice(&S::from,
                     {.key = "from",
                      .label = "Begin at",
                      .help = "border: passes follow the border of what is cut; curve: they lie on both "
                              "sides of a curve; place: they go round a place on the part.",
                      .words = {"border", "curve", "place"}});
        t.add(&S::curve, {.key = "curve",
                          .label = "Curve",
                          .help = "Name of a boundary of the setup, the curve or border of which passes "
                                  "follow, with 'Begin at' curve, seen from above. Empty: the outline "
                                  "of what is cut.",
                          .kind = K::text});
        t.add(&S::open, {.key = "open",
                         .label = "Open",
                         .help = "The curve ends at its last corner, instead of going back to the first.",
                         .kind = K::boolean});
        t.add(&S::place, place_parameter({.key = "place",
                                          .label = "Place",
                                          .help = "Where passes go round, with 'Begin at' place.",
                                          .default_unwritten = true}));
        t.add(&S::spiral, {.key = "spiral",
                           .label = "Spiral",
                           .help = "Joins closed passes that lie within each other to one, whose turns go "
                                   "evenly from each to the next.",
                           .kind = K::boolean});
        t.add(&S::slope_limit, {.key = "slope_limit",
                                .label = "Slope limit",
                                .help = "Surface that is steeper, from level, is left to other operations.",
                                .kind = K::number,
                                .quantity = Quantity::angle,
                                .minimum = radians(5),
                                .maximum = radians(84)});
        t.add_choice(&S::pattern,
                     pattern_parameter("zigzag cuts passes whichever way is nearer; oneway always "
                                       "one way round."));
        t.add(&S::chord_tolerance,
              chord_tolerance_parameter(
                  "How far straight moves may run beside the exact path, to either side"));
        t.add(&S::holder_clearance, holder_clearance_parameter());
        t.add(&S::tilt_limit, tilt_limit_parameter());
        t.add(&S::rest_only, rest_only_parameter());
        return t;
    }();
    return table;
}

StrategyResult Scallop::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    return with_tilt(settings_, context, progress, [&](const Progress& upright) {
        return ScallopPlanner(settings_, context, upright).run(true).path;
    });
}

PlannedPasses scallop_passes(const ScallopSettings& settings, const PlanContext& context,
                             const Progress& progress) {
    check_plannable(context, settings);
    return ScallopPlanner(settings, context, progress).run(false);
}

} // namespace facetmill
