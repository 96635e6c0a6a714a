#include "core/strategy/rough/rough.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/mesh/geometry.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/plan/shared_parameters.h"
#include "core/strategy/rough/rough_check.h"
#include "core/strategy/rough/rough_floor.h"
#include "core/strategy/rough/rough_ground.h"
#include "core/strategy/rough/rough_order.h"
#include "core/strategy/rough/rough_passes.h"
#include "core/strategy/rough/rough_remaining.h"
#include "core/strategy/surface/up_side.h"

#include <cmath>
#include <optional>

namespace facetmill {

namespace {

const OperationRegistration registration("rough", "Rough", [] { return std::make_unique<Rough>(); });

/// Links between lines stay down if they are no longer than this many diameters.
constexpr double longest_link = 3;
/// Where the shank slides along walls, borders lie within this share of the margin of where they are.
constexpr double thinned_for_shank = 0.05;
/// A pass along a floor goes on for up to this many diameters to begin where nothing stands.
constexpr double longest_floor_entry = 3;
/// Stretches of air shorter than this many diameters are run through.
constexpr double short_air = 1.5;
/// Places of a floor that a thread looks at at a time.
constexpr std::size_t floor_tips = 16;

/// What is in `free` and not in `deeper`.
std::vector<Interval> less(const std::vector<Interval>& free, const std::vector<Interval>& deeper) {
    std::vector<Interval> rest;
    for (const Interval& f : free) {
        double from = f.lo;
        for (const Interval& d : deeper) {
            if (d.hi <= f.lo || d.lo >= f.hi) continue;
            if (d.lo > from) rest.push_back({from, d.lo});
            from = std::max(from, d.hi);
        }
        if (f.hi > from) rest.push_back({from, f.hi});
    }
    return rest;
}

/// One plan: ground, layers from the top down, floors between them, and what is said about it.
class Planner {
public:
    Planner(const RoughSettings& settings, const PlanContext& context, const Progress& progress);
    StrategyResult run();

private:
    enum class Lines { usual, floors, all };

    DriveFrame choose_frame() const;
    ContactIndexPtr offset_index(const Progress& progress) const;
    void plan_layers(const Progress& progress);
    void plan_layer(std::size_t layer, const Progress& progress);
    void cut_lines(Lines which, double z, std::optional<double> next, const LayerRoutes& routes,
                   std::span<const FreeContour> contours, const Progress& progress);
    bool shank_comes_by(const Vec2& a, const Vec2& b, double z) const;
    void cut_floors(const Progress& progress);
    void number_layers();
    void check_passes(const Progress& progress);
    void look_for_remaining(const Progress& progress);
    void add_warnings();

    const RoughSettings& settings_;
    const PlanContext& context_;
    PlanText text_;
    const Progress& progress_;
    RoughMeasures measures_;
    StockCutter cutter_;
    StockField field_;
    RoughHeights heights_;
    DriveFrame frame_;
    RoughReach reach_;
    UprightBodies bodies_;
    RoughPasses cut_;
    std::optional<RoughGround> ground_;
    double cleared_ = 0; ///< walls are cut down to there for the shank
    StrategyResult result_;
    RoughPath rough_;
};

Planner::Planner(const RoughSettings& settings, const PlanContext& context, const Progress& progress)
    : settings_(settings), context_(context), text_{context.unit, context.to_setup}, progress_(progress),
      measures_(settings, context), cutter_(measures_.profile),
      field_(rough_stock(settings, context, measures_, progress.part(0, 0.03, "Looking at the stock"))),
      heights_(settings, context, measures_, field_, progress.part(0.03, 0.06, "Choosing layers")),
      frame_(choose_frame()),
      reach_(settings.offset == RoughSettings::Offset::vertices ? offset_index(progress.part(0.06, 0.08))
                                                                : context.contact,
             context, settings.offset == RoughSettings::Offset::vertices ? 0 : measures_.allowance,
             measures_.margin, heights_.low),
      bodies_(context.tool, measures_.profile, heights_.layers.depth_max),
      cut_(settings, measures_, reach_, bodies_, cutter_, field_, progress) {}

/// Along the longer side there are fewer ends of lines.
DriveFrame Planner::choose_frame() const {
    if (settings_.direction.is_number()) return DriveFrame(settings_.direction.number);
    const Vec3 size = field_.box().size();
    const bool along_y =
        settings_.direction.is("y") || (settings_.direction.is("auto") && !(size.x() >= size.y()));
    return DriveFrame(along_y ? 0.5 * pi : 0.0);
}

StrategyResult Planner::run() {
    result_.direction = frame_.angle;
    plan_layers(progress_.part(0.08, 0.92, "Cutting layers"));
    if (cut_.passes().empty()) {
        const bool closed = cut_.closed().routes > 0;
        std::string why = "of what stands above the allowance this tool reaches nothing";
        if (closed) why = "there is no room for the tool to enter";
        if (cut_.blocked().length > 0) why = "shank or holder would hit the stock";
        throw Error(ErrorCode::empty_result, settings_.name, why,
                    closed ? "take a smaller tool, or allow it to plunge"
                           : "check tool, allowance and stock");
    }
    result_.passes = std::move(cut_.passes());
    result_.drive_planes = int(result_.passes.size());
    result_.stepover_min = measures_.stepover / heights_.divisions;
    result_.stepover_max = measures_.stepover;
    result_.chord_tolerance = measures_.margin;
    rough_.stock_cell = field_.cell();
    rough_.depth_max = heights_.layers.depth_max;
    check_passes(progress_.part(0.92, 0.94, "Checking passes"));
    look_for_remaining(progress_.part(0.94, 1, "Looking for what stays"));
    add_warnings();
    result_.detail = std::move(rough_);
    return std::move(result_);
}

void Planner::plan_layers(const Progress& progress) {
    ground_.emplace(reach_, frame_, measures_, heights_, field_, progress.part(0, 0.35));
    cut_.at() = ground_->start();
    const std::size_t layers = heights_.layers.heights.size();
    for (std::size_t k = 0; k < layers; ++k) {
        const double a = double(k) / double(layers), b = double(k + 1) / double(layers);
        plan_layer(k, progress.part(0.35 + 0.6 * a, 0.35 + 0.6 * b));
    }
    cut_floors(progress.part(0.95, 0.99));
    number_layers();
    // What is farther away than the tool is wide does not matter to a pass; shank and holder may be wider,
    // where they can reach the stock at all.
    const bool bodies = field_.box().hi.z() > heights_.low + bodies_.lowest_base();
    const double radius = measures_.profile.max_radius();
    order_passes(cut_.passes(), radius + std::max(radius, bodies ? bodies_.widest() : 0) + 2 * field_.cell(),
                 progress.part(0.99, 1));
}

void Planner::plan_layer(std::size_t layer, const Progress& progress) {
    const std::vector<double>& heights = heights_.layers.heights;
    const double z = heights[layer];
    cut_.begin_layer(int(layer), z);
    const std::optional<double> next =
        layer + 1 < heights.size() ? std::optional(heights[layer + 1]) : std::nullopt;
    const LayerRoutes routes(reach_, field_, cutter_, frame_, measures_.min_work);
    // Along one wall, layers that are thinned to different points leave steps of as much, which the shank of
    // a deeper one meets as it slides by.
    const bool slides = field_.highest() > heights_.low + bodies_.sliding_base();
    const std::vector<FreeContour> contours =
        ground_->grid().contours(z, progress, slides ? thinned_for_shank : ReachGrid::max_thinned);
    // First the usual lines, then the borders, then the lines between, where a floor stays, and those
    // outside; at last whatever of any line is left.
    if (layer == 0) cleared_ = field_.highest();
    cut_lines(Lines::usual, z, next, routes, contours, progress);
    // An earlier operation may have left a skin on a wall that is too thin to be worth a cut, and to be seen
    // in the stock: where the shank comes by, as wide as the cutter, it is cut once every length of flutes.
    std::function<bool(const Vec2&, const Vec2&)> by_shank;
    if (next && *next + bodies_.sliding_base() < cleared_) {
        by_shank = [&](const Vec2& a, const Vec2& b) { return shank_comes_by(a, b, z); };
        cleared_ = z;
    }
    for (RoughRoute& route : routes.along_contours(contours, z, cut_.at(), progress, by_shank))
        cut_.add(std::move(route), routes, contours);
    cut_lines(Lines::floors, z, next, routes, contours, progress);
    cut_lines(Lines::all, z, next, routes, contours, progress);
    const std::vector<FreeContour> channels = unseen_channels(reach_, ground_->valleys(), z, progress);
    for (RoughRoute& route : routes.along_contours(channels, z, cut_.at(), progress)) {
        route.reversible = true;
        cut_.add(std::move(route), routes, contours);
    }
    cut_.add_late();
    progress.set(1);
}

void Planner::cut_lines(Lines which, double z, std::optional<double> next, const LayerRoutes& routes,
                        std::span<const FreeContour> contours, const Progress& progress) {
    const std::vector<ReachLine>& lines = ground_->lines();
    std::vector<std::vector<LinePiece>> of_line(lines.size());
    parallel_for(lines.size(), 1, progress.part(0, 0), [&](std::size_t i) {
        const bool usual = ground_->is_usual(i);
        if (which != Lines::all && usual != (which == Lines::usual)) return;
        RoughReach::Hints hints;
        std::vector<Interval> free = lines[i].free(z, hints);
        if (!usual && next) free = less(free, lines[i].free(*next, hints));
        // Usual lines are neighbours of usual ones, others of any.
        routes.add_pieces(int(which == Lines::usual ? ground_->usual_number(i) : i), lines[i].v(), free, z,
                          short_air * measures_.diameter, which == Lines::usual, of_line[i]);
    });
    std::vector<LinePiece> pieces;
    for (auto& p : of_line)
        pieces.insert(pieces.end(), p.begin(), p.end());
    const bool oneway = settings_.pattern == RoughSettings::Pattern::oneway;
    for (RoughRoute& route : routes.joined_lines(
             std::move(pieces), contours, z, longest_link * measures_.diameter, oneway, cut_.at(), progress))
        cut_.add(std::move(route), routes, contours);
}

/// True where something may stand by the cutter on a route along a border at z, and a deeper layer may bring
/// the shank there: the lift falls off beside the route, or nearly so.
bool Planner::shank_comes_by(const Vec2& a, const Vec2& b, double z) const {
    if (field_.clear_height(cutter_, a, b) <= z + measures_.min_work) return false;
    RoughReach::Hints hints;
    const Vec2 d = b - a, middle = 0.5 * (a + b);
    // The free side is on the left.
    const Vec2 left = d.norm() > 0 ? Vec2(Vec2(-d.y(), d.x()).normalized()) : Vec2::Zero();
    const double lift = std::min(reach_.tip_z(middle, hints),
                                 reach_.tip_z(middle + std::numbers::sqrt2 * field_.cell() * left, hints));
    return std::max(lift, heights_.low) + bodies_.sliding_base()
           < field_.highest_near(a, b, measures_.profile.max_radius());
}

/// Layers are those that are cut; passes are numbered by them.
void Planner::number_layers() {
    std::vector<int> number(heights_.layers.heights.size(), -1);
    for (const Pass& pass : cut_.passes())
        number[std::size_t(pass.layer)] = 0;
    for (std::size_t k = 0; k < number.size(); ++k) {
        if (number[k] < 0) continue;
        number[k] = int(rough_.layers.size());
        rough_.layers.push_back(heights_.layers.heights[k]);
    }
    for (Pass& pass : cut_.passes())
        pass.layer = number[std::size_t(pass.layer)];
}

/// Between two layers a floor is reached by neither. Where too much would stay beside it the tool runs along
/// the floor itself.
void Planner::cut_floors(const Progress& progress) {
    const std::vector<ReachValley>& valleys = ground_->valleys();
    for (std::size_t v = 0; v < valleys.size(); ++v) {
        progress.set(double(v) / double(valleys.size()));
        const ReachValley& valley = valleys[v];
        const std::size_t n = valley.tips.size();
        std::vector<Vec3> tips = valley.tips;
        for (Vec3& tip : tips)
            tip.z() = std::max(tip.z(), heights_.low);
        std::vector<char> busy(n, 0); // from a tip to the next
        const Progress here = progress.part(0, 0);
        parallel_for(n > 0 ? n - 1 : 0, floor_tips, here, [&](std::size_t i) {
            busy[i] = (valley.deep[i] || valley.deep[i + 1])
                      && std::max(valley.tips[i].z(), valley.tips[i + 1].z()) >= heights_.low
                      && field_.has_work(cutter_, tips[i], tips[i + 1], measures_.min_work);
        });
        if (std::find(busy.begin(), busy.end(), 1) == busy.end()) continue;
        std::vector<double> stand(n);
        parallel_for(n, floor_tips, here, [&](std::size_t i) {
            stand[i] = field_.stand_height(cutter_, tips[i].head<2>(), tips[i].head<2>());
        });
        for (std::vector<Vec3>& route :
             floor_stretches(tips, busy, stand, measures_.diameter, longest_floor_entry * measures_.diameter,
                             measures_.diameter))
            cut_.add_floor(std::move(route), heights_.layers);
    }
}

/// Looks at every pass again, by the lift alone: none that was planned may come nearer to the part than the
/// allowance. The surface offset by vertices does not promise it; what it lets through is told.
void Planner::check_passes(const Progress& progress) {
    const AxialLift exact(context_.contact, measures_.profile, measures_.allowance);
    const RoughDepth worst = deepest_in_allowance(exact, result_.passes, reach_.spacing(), progress);
    if (worst.depth <= tolerance::contact_distance) return;
    if (settings_.offset == RoughSettings::Offset::contact)
        throw Error(ErrorCode::internal, settings_.name,
                    "a pass goes " + text_(worst.depth) + " into the allowance at " + text_(worst.at),
                    "report this");
    result_.warnings.push_back("the surface offset by vertices lets the cutter up to " + text_(worst.depth)
                               + " (upright) into the allowance of " + text_(settings_.allowance)
                               + ", most at " + text_(worst.at) + ": use offset contact");
}

void Planner::look_for_remaining(const Progress& progress) {
    RemainingInput input;
    input.mesh = context_.part.get();
    input.contact = context_.contact;
    input.profile = &measures_.profile;
    input.field = &field_;
    input.allowance = measures_.allowance;
    input.lowest_tip = heights_.low;
    input.within = context_.within.get();
    // All of it above the surface that is safe to leave; the part itself lies that much lower.
    const double inner = context_.tessellation_tolerance[1], expected = heights_.expected;
    input.allowed = expected;
    const Remaining found = find_remaining(input, progress);
    // What the field cannot tell from it is as expected; more may be that much more yet.
    const bool more = found.height > expected + field_.cell();
    result_.cusp_max = (more ? found.height + field_.cell() : expected) + inner;
    if (more)
        result_.warnings.push_back("in places more stays than the layers leave on slopes ("
                                   + text_(expected + inner) + "): up to " + text_(found.height + inner)
                                   + " above the allowance, most at " + text_(found.at));
    if (found.out_of_reach > 0)
        result_.warnings.push_back("the tool is too large for hollows of the part: over "
                                   + share_text(double(found.out_of_reach), double(found.places))
                                   + " of it, seen " + context_.seen_from() + ", up to "
                                   + text_(found.beyond + inner) + " stays above the allowance, most at "
                                   + text_(found.beyond_at) + ": rough again there with a smaller tool");
    if (found.too_low > 0)
        result_.warnings.push_back(
            "no layer lies lower than " + text_(heights_.low) + ", where stock or part end, and over "
            + share_text(double(found.too_low), double(found.places)) + " of the part, seen "
            + context_.seen_from() + ", the tool would have to be lower: up to "
            + text_(found.low_height + inner) + " stays above the allowance, most at " + text_(found.low_at)
            + ": take a tool that is flatter at its end, or leave it to what comes after");
}

void Planner::add_warnings() {
    auto& warnings = result_.warnings;
    // Layers of a stated depth leave their steps by intent: how high they are is a figure of the result.
    if (!settings_.depth.is_number()
        && result_.cusp_max > settings_.tolerance * (1 + tolerance::figure_rounding))
        warnings.push_back("up to " + text_(result_.cusp_max)
                           + " stays above the allowance; the tolerance is " + text_(settings_.tolerance));
    if (const RoughPasses::LeftOut& left = cut_.blocked(); left.length > 0)
        warnings.push_back("shank or holder would hit the stock: " + text_(left.length)
                           + " of cuts are left out, the first at " + text_(left.at) + ": use a longer tool");
    if (const RoughPasses::LeftOut& left = cut_.closed(); left.routes > 0)
        warnings.push_back(std::to_string(left.routes) + (left.routes == 1 ? " place is" : " places are")
                           + " left out that the tool has no room to enter by a ramp or a helix ("
                           + text_(left.length) + " of cuts), the first at " + text_(left.at)
                           + ": use a smaller tool, or allow it to plunge");
    const double part_top = context_.part_box.hi.z(), stock_top = field_.box().hi.z();
    if (settings_.allowance > 0 && part_top + settings_.allowance > stock_top)
        warnings.push_back("the stock ends " + text_(stock_top - part_top)
                           + " above the part: the allowance of " + text_(settings_.allowance)
                           + " cannot stay everywhere");
    if (part_top > stock_top + tolerance::contact_distance)
        warnings.push_back("the part reaches " + text_(part_top - stock_top) + " above the stock");
    const ReachGrid& grid = ground_->grid();
    const ShortTool lack = find_short_tool(grid, heights_, field_, cutter_, progress_);
    if (lack.places > 0)
        warnings.push_back(
            "the tool is short: shank or holder would come nearer to the part than the allowance, so over "
            + share_text(double(lack.places), double(grid.columns() * grid.rows()))
            + " of the ground the cutter stays above where it could be, by up to " + text_(lack.lacks)
            + ", most at " + text_(lack.at) + ": use a longer tool");
}

/// The part with every vertex moved along its normal (Lu 3.4.3), and all that the cutter keeps off as it is:
/// where the moved surface crosses itself or is wound the wrong way it lies inside the part.
ContactIndexPtr Planner::offset_index(const Progress& progress) const {
    std::shared_ptr<const MeshGeometry> geometry = context_.geometry;
    if (!geometry) geometry = compute_geometry(*context_.part, progress.part(0, 0.5));
    const UpSide up(*context_.part, progress);
    auto both = std::make_shared<Mesh>(*context_.part);
    for (std::size_t i = 0; i < both->vertices.size(); ++i)
        both->vertices[i] += measures_.allowance * up.towards_tool(geometry->vertex_normals[i]);
    append_mesh(*both, context_.contact->mesh());
    return std::make_shared<ContactIndex>(both, progress.part(0.5, 1));
}

} // namespace

const ParameterTable<RoughSettings>& rough_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        using S = RoughSettings;
        ParameterTable<S> t;
        add_common_parameters(t);
        add_tool_axis_parameter(t);
        t.add(&S::depth,
              length_or_word_parameter({.key = "depth",
                                        .label = "Depth",
                                        .help = "Distance between neighbouring layers; from_tolerance is "
                                                "everywhere the largest that leaves no more than the "
                                                "tolerance above the allowance, at most the diameter, and "
                                                "puts lines closer where a floor stays.",
                                        .words = {"from_tolerance"}}));
        t.add(&S::stepover,
              length_or_word_parameter({.key = "stepover",
                                        .label = "Step-over",
                                        .help = "Largest distance between neighbouring lines of a layer, at "
                                                "most the diameter; auto is 0.95 of the diameter.",
                                        .words = {"auto"}},
                                       10000));
        t.add_choice(&S::pattern, pattern_parameter("zigzag cuts to and fro; oneway always cuts in the "
                                                    "direction of travel and returns above what stands."));
        t.add_choice(&S::entry,
                     {.key = "entry",
                      .label = "Entry",
                      .help = "How the tool comes into material where it cannot come from outside: "
                              "auto takes a ramp along the first cut, or a helix where that is too "
                              "short; plunge goes straight down.",
                      .words = {"auto", "ramp", "helix", "plunge"}});
        t.add(&S::ramp_angle, {.key = "ramp_angle",
                               .label = "Ramp angle",
                               .help = "Slope at which ramps and helices go down.",
                               .kind = K::number,
                               .quantity = Quantity::angle,
                               .minimum = radians(0.1),
                               .maximum = radians(45)});
        t.add_choice(&S::offset, {.key = "offset",
                                  .label = "Offset",
                                  .help = "How the allowance is kept: contact is exact; vertices moves every "
                                          "vertex along its normal, cruder, and says what it cuts beyond.",
                                  .words = {"contact", "vertices"},
                                  .advanced = true});
        return t;
    }();
    return table;
}

StrategyResult Rough::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    return Planner(settings_, context, progress).run();
}

} // namespace facetmill
