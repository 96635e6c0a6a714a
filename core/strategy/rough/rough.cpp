#include "core/strategy/rough/rough.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/mesh/geometry.h"
#include "core/strategy/plan/budget.h"
#include "core/strategy/plan/plan_text.h"
#include "core/strategy/rough/rough_entry.h"
#include "core/strategy/rough/rough_floor.h"
#include "core/strategy/rough/rough_layers.h"
#include "core/strategy/rough/rough_order.h"
#include "core/strategy/rough/rough_remaining.h"
#include "core/strategy/rough/rough_valley.h"
#include "core/strategy/surface/cutter_cover.h"
#include "core/strategy/surface/stock_before.h"
#include "core/strategy/surface/up_side.h"

#include <cmath>
#include <optional>
#include <utility>

namespace facetmill {

namespace {

const OperationRegistration registration("rough", "Rough", [] { return std::make_unique<Rough>(); });

/// Lu's safety factor c of the step-over.
constexpr double stepover_share = 0.95;
/// Of the cutter's diameter: what tips keep from the exact surface; the cells of the stock; what is too
/// little to be cut.
constexpr double margin_share = 2e-3, cell_share = 0.02, min_share = 2e-3;
/// Of the tolerance: the margin is at most this.
constexpr double margin_of_tolerance = 0.05;
/// Lines on floors are at most so many times closer than others.
constexpr int max_divisions = 64;
constexpr double max_lines = 1e5;
/// Links between lines stay down if they are no longer than this many diameters.
constexpr double longest_link = 3, longest_join = 10;
/// A pass along a floor goes on so far to begin where nothing stands.
constexpr double longest_floor_entry = 3;
/// Of what is stated: as much less may stay beside floors, for the cutter itself may be kept as far from
/// there.
constexpr double kept_away_share = 0.05;
/// Stretches of air shorter than this many diameters are run through.
constexpr double short_air = 1.5;

class Planner {
public:
    Planner(const RoughSettings& settings, const PlanContext& context, const Progress& progress);
    StrategyResult run();
    RoughPreview preview();

private:
    void look_at_stock(const Progress& progress);
    void choose_heights(const Progress& progress);
    double expected() const { return layers_.excess + 2 * margin_ + min_; }
    void plan_layers(const Progress& progress);
    void plan_layer(std::size_t layer, const Progress& progress);
    bool shank_comes_by(const Vec2& a, const Vec2& b, double z) const;
    void cut_floors(const Progress& progress);
    void number_layers();
    void cut_floor(std::vector<Vec3> tips);
    void finish(RoughRoute route, double z, int layer, const LayerRoutes& routes,
                std::span<const Contour> contours);
    bool join(RoughRoute& route, double z, int layer, const LayerRoutes& routes,
              std::span<const Contour> contours);
    void finish_later(double z, int layer);
    void take(const RoughRoute& route, const std::vector<Vec3>& down, double z, int layer);
    void take(const std::vector<Vec3>& tips, const std::vector<Vec3>& down, int layer);
    void add_warnings();
    void warn_of_short_tool();
    void check_passes(const Progress& progress);
    ContactIndexPtr offset_index(const Progress& progress) const;
    double stepover() const;

    const RoughSettings& settings_;
    const PlanContext& context_;
    PlanText text_;
    const Progress& progress_;
    CutterProfile profile_;
    StockCutter cutter_;
    double diameter_, budget_, allowance_, margin_, min_;
    DriveFrame frame_;
    std::optional<StockField> field_;
    std::optional<UprightBodies> bodies_;
    std::optional<RoughReach> reach_;
    std::optional<ReachGrid> grid_;
    std::vector<ReachValley> valleys_;
    std::vector<ReachLine> lines_; ///< `divisions_` per step-over, the usual ones at multiples of it
    int divisions_ = 1;
    double step_ = 0, low_ = 0;
    double highest_ = 0; ///< of the stock when the layer began
    double cleared_ = 0; ///< walls are cut down to there for the shank
    Layers layers_;
    StrategyResult result_;
    RoughPath rough_;
    Vec2 at_ = Vec2::Zero();
    double blocked_length_ = 0, closed_length_ = 0; ///< left out: shank or holder; no room to enter
    std::size_t closed_routes_ = 0;
    std::vector<RoughRoute> later_; ///< of the layer, without an entry so far
    Vec3 blocked_at_ = Vec3::Zero(), closed_at_ = Vec3::Zero();
};

double Planner::stepover() const {
    if (!settings_.stepover.is_number()) return stepover_share * diameter_;
    const double step = settings_.stepover.number;
    if (!(step > 0) || step > diameter_)
        throw Error(ErrorCode::out_of_range, "stepover",
                    "a step-over of " + text_(step) + " with a cutter of diameter " + text_(diameter_)
                        + " leaves walls between the lines",
                    "choose at most the diameter");
    return step;
}

Planner::Planner(const RoughSettings& settings, const PlanContext& context, const Progress& progress)
    : settings_(settings), context_(context), text_{context.unit}, progress_(progress),
      profile_(context.tool.cutter()), cutter_(profile_),
      // Of a tapered cutter that at its end: above it is wider, and cuts less deep there.
      diameter_(context.tool.diameter > 0 ? std::min(2 * profile_.max_radius(), context.tool.diameter)
                                          : 2 * profile_.max_radius()),
      budget_(cusp_budget(settings, context)),
      allowance_(settings.allowance + context.tessellation_tolerance[1]),
      margin_(std::max(std::min(margin_share * diameter_, margin_of_tolerance * budget_),
                       tolerance::smallest_chord)),
      min_(min_share * diameter_) {
    min_ = std::min(min_, 0.1 * budget_);
}

/// Depth and step-over are right, and there is something to cut.
void Planner::look_at_stock(const Progress& progress) {
    const Box3& part = context_.part_box;
    step_ = stepover();
    if (settings_.depth.is_number()) {
        const double depth = settings_.depth.number;
        if (!(depth > 0))
            throw Error(ErrorCode::out_of_range, "depth", "the depth of the layers is not above 0",
                        "enter a length above 0, or from_tolerance");
        if (depth > context_.tool.flute_length)
            throw Error(ErrorCode::out_of_range, "depth",
                        "layers of " + text_(depth) + " are deeper than the flutes of the tool, "
                            + text_(context_.tool.flute_length),
                        "choose a smaller depth or a longer tool");
    }
    field_.emplace(stock_before(context_, cell_share * diameter_, progress));
    const double top = field_->highest();
    low_ = std::max(field_->box().lo.z(), part.lo.z());
    if (!(top > low_))
        throw Error(ErrorCode::empty_result, settings_.name,
                    top == -infinity
                        ? "there is no stock"
                        : "the stock ends at z = " + text_(top) + ", the part begins at z = " + text_(low_),
                    "check the stock's size and place");
}

RoughPreview Planner::preview() {
    look_at_stock(progress_.part(0, 0.5));
    choose_heights(progress_.part(0.5, 1));
    RoughPreview preview;
    preview.heights = layers_.heights;
    preview.depth_min = layers_.depth_min;
    preview.depth_max = layers_.depth_max;
    preview.stepover = step_ / divisions_;
    preview.remaining = expected() + context_.tessellation_tolerance[1];
    preview.stock = field_->box();
    preview.stock.hi.z() = field_->highest();
    return preview;
}

StrategyResult Planner::run() {
    look_at_stock(progress_.part(0, 0.03, "Looking at the stock"));
    // Along the longer side there are fewer ends of lines.
    const Vec3 size = field_->box().size();
    const bool auto_x = size.x() >= size.y();
    frame_ =
        DriveFrame(settings_.direction.is_number() ? settings_.direction.number
                   : settings_.direction.is("y") || (settings_.direction.is("auto") && !auto_x) ? 0.5 * pi
                                                                                                : 0.0);
    result_.direction = frame_.angle;

    const bool by_vertices = settings_.offset == RoughSettings::Offset::vertices;
    reach_.emplace(by_vertices ? offset_index(progress_.part(0.03, 0.05)) : context_.contact, context_,
                   by_vertices ? 0 : allowance_, margin_, low_);
    bodies_.emplace(context_.tool, profile_.max_radius());
    choose_heights(progress_.part(0.05, 0.08, "Choosing layers"));
    plan_layers(progress_.part(0.08, 0.92, "Cutting layers"));
    if (result_.passes.empty()) {
        std::string why = "of what stands above the allowance this tool reaches nothing";
        if (closed_routes_ > 0) why = "there is no room for the tool to enter";
        if (blocked_length_ > 0) why = "shank or holder would hit the stock";
        throw Error(ErrorCode::empty_result, settings_.name, why,
                    closed_routes_ > 0 ? "take a smaller tool, or allow it to plunge"
                                       : "check tool, allowance and stock");
    }
    result_.drive_planes = int(result_.passes.size());
    result_.stepover_min = step_ / divisions_;
    result_.stepover_max = step_;
    result_.chord_tolerance = margin_;
    rough_.stock_cell = field_->cell();
    check_passes(progress_.part(0.92, 0.94, "Checking passes"));

    RemainingInput input;
    input.mesh = context_.part.get();
    input.contact = context_.contact;
    input.profile = &profile_;
    input.field = &*field_;
    input.allowance = allowance_;
    input.lowest_tip = low_;
    // All of it above the surface that is safe to leave; the part itself lies that much lower.
    const double inner = context_.tessellation_tolerance[1];
    const double expected = this->expected();
    input.allowed = expected;
    const Remaining found = find_remaining(input, progress_.part(0.94, 1, "Looking for what stays"));
    // What the field cannot tell from it is as expected; more may be that much more yet.
    const bool more = found.height > expected + field_->cell();
    result_.cusp_max = (more ? found.height + field_->cell() : expected) + inner;
    if (more)
        result_.warnings.push_back("in places more stays than the layers leave on slopes ("
                                   + text_(expected + inner) + "): up to " + text_(found.height + inner)
                                   + " above the allowance, most at " + text_(found.at));
    if (found.out_of_reach > 0)
        result_.warnings.push_back(
            "the tool is too large for hollows of the part: over "
            + format_number(std::max(100.0 * double(found.out_of_reach) / double(found.places), 1e-3), 2)
            + " % of it, seen from above, up to " + text_(found.beyond + inner)
            + " stays above the allowance, most at " + text_(found.beyond_at)
            + ": rough again there with a smaller tool");
    add_warnings();
    result_.detail = std::move(rough_);
    return std::move(result_);
}

/// Depth, and how close lines stand on floors.
void Planner::choose_heights(const Progress& progress) {
    LayerInput input;
    input.mesh = context_.part.get();
    input.cutter = &profile_;
    input.allowance = allowance_;
    input.margin = margin_;
    input.top = field_->highest();
    input.low = low_;
    if (settings_.depth.is_number()) {
        input.depth = settings_.depth.number;
    } else {
        // Of what may stay, the floor between lines takes a share, the layers have the rest: few lines make
        // many layers, and the other way round. Cheapest is what makes the least length of lines.
        input.excess = budget_ - 2 * margin_ - min_;
        input.deepest = std::min(context_.tool.flute_length, diameter_);
        double best = infinity;
        for (int m = 1; m <= max_divisions; ++m) {
            const double rest = input.excess - profile_.height_at(0.5 * step_ / m);
            if (!(rest > 0)) continue;
            const double layers = std::max(1.0, (input.top - input.low) / std::min(rest, input.deepest));
            if (const double cost = layers + (m > 1 ? m : 0); cost < best) {
                best = cost;
                divisions_ = m;
            }
        }
        if (best == infinity)
            throw Error(ErrorCode::out_of_range, "tolerance",
                        "no lines of this tool leave as little as " + text_(settings_.tolerance),
                        "allow a larger tolerance, set a depth, or take a tool with a flat end");
    }
    input.stepover = step_ / divisions_;
    layers_ = layer_heights(input, progress);
}

void Planner::plan_layers(const Progress& progress) {
    const Box3& box = field_->box();
    // In (u, v), and beyond the stock as far as the tool can still cut it or come in from.
    Vec2 lo(infinity, infinity), hi(-infinity, -infinity);
    for (int k = 0; k < 4; ++k) {
        const Vec3 corner(k & 1 ? box.hi.x() : box.lo.x(), k & 2 ? box.hi.y() : box.lo.y(), 0);
        const Vec2 p(frame_.u(corner), frame_.v(corner));
        lo = lo.cwiseMin(p);
        hi = hi.cwiseMax(p);
    }
    const double out = profile_.max_radius() + 2 * field_->cell() + 2 * reach_->spacing();
    const double n = std::max(1.0, std::ceil((hi.y() - lo.y()) / step_));
    if (n * divisions_ > max_lines)
        throw Error(ErrorCode::limit_exceeded, "stepover",
                    "more than " + format_number(max_lines) + " lines a layer are asked for",
                    "choose a larger step-over or tolerance");
    grid_.emplace(*reach_, frame_, lo.array() - out, hi.array() + out, progress.part(0, 0.15));
    const FloorJudge judge(profile_, layers_.heights, box.hi.z(), (1 - kept_away_share) * expected(), min_);
    valleys_ = find_valleys(
        *reach_, *grid_, low_, field_->highest(), layers_.depth_max,
        [&](const FloorPlace& place) { return judge.too_high(place); }, progress.part(0.15, 0.2));
    // Centred, with half a step to the borders, and one more line outside on either side, for what a sloping
    // side of the part leaves there.
    const double step = n > 1 || hi.y() - lo.y() > step_ ? (hi.y() - lo.y()) / n : step_;
    const double first = 0.5 * (lo.y() + hi.y()) - 0.5 * (n - 1) * step;
    const auto count = std::size_t(n + 2) * std::size_t(divisions_);
    std::vector<std::optional<ReachLine>> lines(count);
    parallel_for(count, 1, progress.part(0.2, 0.35), [&](std::size_t i) {
        const double v = first + (double(i) / divisions_ - 1) * step;
        lines[i].emplace(*reach_, frame_, v, lo.x() - out, hi.x() + out);
    });
    for (auto& line : lines)
        lines_.push_back(std::move(*line));
    at_ = frame_.xy(lo.x(), first);
    for (std::size_t k = 0; k < layers_.heights.size(); ++k) {
        const double a = double(k) / double(layers_.heights.size()),
                     b = double(k + 1) / double(layers_.heights.size());
        plan_layer(k, progress.part(0.35 + 0.6 * a, 0.35 + 0.6 * b));
    }
    cut_floors(progress.part(0.95, 0.99));
    number_layers();
    // What is farther away than the tool is wide does not matter to a pass; shank and holder may be wider,
    // where they can reach the stock at all.
    const bool bodies = field_->box().hi.z() > low_ + bodies_->lowest_base();
    const double radius = profile_.max_radius();
    order_passes(result_.passes,
                 radius + std::max(radius, bodies ? bodies_->widest() : 0) + 2 * field_->cell(),
                 progress.part(0.99, 1));
}

void Planner::plan_layer(std::size_t layer, const Progress& progress) {
    const double z = layers_.heights[layer];
    highest_ = field_->highest();
    const std::optional<double> next =
        layer + 1 < layers_.heights.size() ? std::optional(layers_.heights[layer + 1]) : std::nullopt;
    const LayerRoutes routes(*reach_, *field_, cutter_, frame_, min_);
    const std::vector<Contour> contours = grid_->contours(z, progress);
    const bool oneway = settings_.pattern == RoughSettings::Pattern::oneway;
    const auto divisions = std::size_t(divisions_);
    // First the usual lines, then the borders, then the lines between, where a floor stays, and those
    // outside; at last whatever of any line is left.
    enum class Lines { usual, floors, all };
    const auto cut_lines = [&](Lines which) {
        std::vector<std::vector<LinePiece>> of_line(lines_.size());
        parallel_for(lines_.size(), 1, progress.part(0, 0), [&](std::size_t i) {
            const bool usual = i >= divisions && i < lines_.size() - divisions && i % divisions == 0;
            if (which != Lines::all && usual != (which == Lines::usual)) return;
            RoughReach::Hints hints;
            std::vector<Interval> free = lines_[i].free(z, hints);
            if (!usual && next) {
                std::vector<Interval> rest;
                const std::vector<Interval> deeper = lines_[i].free(*next, hints);
                for (const Interval& f : free) {
                    double from = f.lo;
                    for (const Interval& d : deeper) {
                        if (d.hi <= f.lo || d.lo >= f.hi) continue;
                        if (d.lo > from) rest.push_back({from, d.lo});
                        from = std::max(from, d.hi);
                    }
                    if (f.hi > from) rest.push_back({from, f.hi});
                }
                free = std::move(rest);
            }
            // Usual lines are neighbours of usual ones, others of any.
            routes.add_pieces(int(which == Lines::usual ? i / divisions : i), lines_[i].v(), free, z,
                              short_air * diameter_, which == Lines::usual, of_line[i]);
        });
        std::vector<LinePiece> pieces;
        for (auto& p : of_line)
            pieces.insert(pieces.end(), p.begin(), p.end());
        for (RoughRoute& route : routes.joined_lines(std::move(pieces), contours, z, longest_link * diameter_,
                                                     oneway, at_, progress))
            finish(std::move(route), z, int(layer), routes, contours);
    };
    cut_lines(Lines::usual);
    // An earlier operation may have left a skin on a wall that is too thin to be worth a cut, and to be seen
    // in the stock: where the shank comes by, as wide as the cutter, it is cut once every length of flutes.
    std::function<bool(const Vec2&, const Vec2&)> by_shank;
    if (layer == 0) cleared_ = highest_;
    if (next && *next + bodies_->sliding_base() < cleared_) {
        by_shank = [&](const Vec2& a, const Vec2& b) { return shank_comes_by(a, b, z); };
        cleared_ = z;
    }
    for (RoughRoute& route : routes.along_contours(contours, z, at_, progress, by_shank))
        finish(std::move(route), z, int(layer), routes, contours);
    cut_lines(Lines::floors);
    cut_lines(Lines::all);
    const std::vector<Contour> channels = unseen_channels(*reach_, valleys_, z, progress);
    for (RoughRoute& route : routes.along_contours(channels, z, at_, progress)) {
        route.reversible = true;
        finish(std::move(route), z, int(layer), routes, contours);
    }
    finish_later(z, int(layer));
    progress.set(1);
}

/// True where something may stand by the cutter on a way along a border at z, and a deeper layer may bring
/// the shank there: the lift falls off beside the way, or nearly so.
bool Planner::shank_comes_by(const Vec2& a, const Vec2& b, double z) const {
    if (field_->clear_height(cutter_, a, b) <= z + min_) return false;
    RoughReach::Hints hints;
    const Vec2 route = b - a, middle = 0.5 * (a + b);
    // The free side is on the left.
    const Vec2 left = route.norm() > 0 ? Vec2(Vec2(-route.y(), route.x()).normalized()) : Vec2::Zero();
    const double lift = std::min(reach_->tip_z(middle, hints),
                                 reach_->tip_z(middle + std::numbers::sqrt2 * field_->cell() * left, hints));
    return std::max(lift, low_) + bodies_->sliding_base() < field_->highest_near(a, b, profile_.max_radius());
}

/// Layers are those that are cut; passes are numbered by them.
void Planner::number_layers() {
    std::vector<int> number(layers_.heights.size(), -1);
    for (const Pass& pass : result_.passes)
        number[std::size_t(pass.layer)] = 0;
    for (std::size_t k = 0; k < number.size(); ++k) {
        if (number[k] < 0) continue;
        number[k] = int(rough_.layers.size());
        rough_.layers.push_back(layers_.heights[k]);
    }
    for (Pass& pass : result_.passes)
        pass.layer = number[std::size_t(pass.layer)];
}

/// Between two layers a floor is reached by neither. Where too much would stay beside it the tool runs along
/// the floor itself.
void Planner::cut_floors(const Progress& progress) {
    for (std::size_t v = 0; v < valleys_.size(); ++v) {
        progress.set(double(v) / double(valleys_.size()));
        const ReachValley& valley = valleys_[v];
        const std::size_t n = valley.tips.size();
        std::vector<Vec3> tips = valley.tips;
        for (Vec3& tip : tips)
            tip.z() = std::max(tip.z(), low_);
        std::vector<char> busy(n, 0); // the way from a tip to the next
        for (std::size_t i = 0; i + 1 < n; ++i)
            busy[i] = (valley.deep[i] || valley.deep[i + 1])
                      && std::max(valley.tips[i].z(), valley.tips[i + 1].z()) >= low_
                      && field_->has_work(cutter_, tips[i], tips[i + 1], min_);
        if (std::find(busy.begin(), busy.end(), 1) == busy.end()) continue;
        std::vector<double> stand(n);
        for (std::size_t i = 0; i < n; ++i)
            stand[i] = field_->stand_height(cutter_, tips[i].head<2>(), tips[i].head<2>());
        for (std::vector<Vec3>& route :
             floor_stretches(tips, busy, stand, diameter_, longest_floor_entry * diameter_, diameter_))
            cut_floor(std::move(route));
    }
}

void Planner::cut_floor(std::vector<Vec3> tips) {
    progress_.check();
    for (std::size_t i = 1; i < tips.size(); ++i) {
        const Vec2 a = tips[i - 1].head<2>(), b = tips[i].head<2>();
        const double low = std::min(tips[i - 1].z(), tips[i].z());
        // Where layers were left out, what stands is not for one cut.
        if (field_->stand_height(cutter_, a, b)
                > std::max(tips[i - 1].z(), tips[i].z()) + 2 * layers_.depth_max
            || !bodies_->clear(*field_, a, b, low))
            return;
    }
    tips = thinned_route(tips, 0.25 * margin_);
    const RoughEntry entry(settings_, *reach_, *field_, cutter_, *bodies_, min_);
    std::vector<Vec3> turned(tips.rbegin(), tips.rend()), down, other;
    const bool ahead = entry.descend(tips, down), back = entry.descend(turned, other);
    if (!ahead && !back) return;
    // In where it stands free, and uphill.
    if (!ahead || (back && other.empty() && (!down.empty() || tips.back().z() < tips.front().z()))) {
        tips.swap(turned);
        down.swap(other);
    }
    double low = infinity;
    for (const Vec3& tip : tips)
        low = std::min(low, tip.z());
    const auto deeper =
        std::upper_bound(layers_.heights.begin(), layers_.heights.end(), low, std::greater<>());
    const int layer = std::max(0, int(deeper - layers_.heights.begin()) - 1);
    take(tips, down, layer);
}

/// Leaves out what shank or holder forbid, finds the way in, and cuts.
void Planner::finish(RoughRoute route, double z, int layer, const LayerRoutes& routes,
                     std::span<const Contour> contours) {
    progress_.check();
    std::vector<RoughRoute> parts;
    if (highest_ <= z + bodies_->lowest_base()) {
        parts.push_back(std::move(route));
    } else {
        RoughRoute part = route;
        part.points.clear();
        const auto end = [&] {
            if (part.points.size() < 2) {
                part.points.clear();
                return;
            }
            part.after = part.points.back();
            parts.push_back(part);
            part.points.clear();
            part.closed = false;
        };
        bool whole = true;
        for (std::size_t i = 1; i < route.points.size(); ++i) {
            const Vec2 a = route.points[i - 1], d = route.points[i] - a;
            const double n = std::max(1.0, std::ceil(d.norm() / (0.5 * diameter_)));
            for (double k = 0; k < n; ++k) {
                const Vec2 from = a + (k / n) * d, to = a + ((k + 1) / n) * d;
                if (bodies_->clear(*field_, from, to, z)) {
                    if (part.points.empty()) {
                        part.points.push_back(from);
                        part.before = from;
                    }
                    part.points.push_back(to);
                    continue;
                }
                whole = false;
                if (blocked_length_ == 0) blocked_at_ = Vec3(from.x(), from.y(), z);
                blocked_length_ += (to - from).norm();
                end();
            }
        }
        if (whole) {
            parts.push_back(std::move(route));
        } else {
            end();
            for (RoughRoute& p : parts)
                p.points = thinned_route(p.points, 1e-9 * diameter_);
        }
    }
    const RoughEntry entry(settings_, *reach_, *field_, cutter_, *bodies_, min_);
    for (RoughRoute& p : parts) {
        if (join(p, z, layer, routes, contours)) continue;
        std::vector<Vec3> down;
        if (entry.enter(p, z, down)) {
            take(p, down, z, layer);
            continue;
        }
        later_.push_back(std::move(p));
    }
}

/// Where the last pass ended nearby on the same layer the tool stays down: what it meets on the way is to be
/// cut on this layer anyway.
bool Planner::join(RoughRoute& route, double z, int layer, const LayerRoutes& routes,
                   std::span<const Contour> contours) {
    const bool oneway = settings_.pattern == RoughSettings::Pattern::oneway;
    if (oneway || result_.passes.empty() || result_.passes.back().layer != layer) return false;
    Pass& last = result_.passes.back();
    const Vec2 from = last.cl.back().tip.head<2>();
    if (route.reversible && (route.points.back() - from).norm() < (route.points.front() - from).norm())
        route.turn();
    std::vector<Vec2> points{from};
    if (!routes.connect(from, route.points.front(), contours, z, longest_join * diameter_, points))
        return false;
    for (std::size_t i = 1; i <= points.size(); ++i)
        if (!bodies_->clear(*field_, points[i - 1], i < points.size() ? points[i] : route.points.front(), z))
            return false;
    points.insert(points.end(), route.points.begin(), route.points.end());
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 tip(points[i].x(), points[i].y(), z);
        field_->cut(cutter_, last.cl.back().tip, tip);
        last.cl.push_back({tip, Vec3(0, 0, 1)});
        last.cc.push_back({tip, Vec3(0, 0, 1)});
    }
    at_ = route.points.back();
    return true;
}

/// What had no room for an entry may have one when all round it is cut, or nothing left to cut.
void Planner::finish_later(double z, int layer) {
    const RoughEntry entry(settings_, *reach_, *field_, cutter_, *bodies_, min_);
    for (RoughRoute& route : std::exchange(later_, {})) {
        progress_.check();
        double length = 0;
        bool work = false;
        for (std::size_t i = 1; i < route.points.size(); ++i) {
            const Vec2 &a = route.points[i - 1], &b = route.points[i];
            length += (b - a).norm();
            work = work || field_->has_work(cutter_, Vec3(a.x(), a.y(), z), Vec3(b.x(), b.y(), z), min_);
        }
        if (!work) continue;
        std::vector<Vec3> down;
        if (entry.enter(route, z, down)) {
            take(route, down, z, layer);
            continue;
        }
        if (closed_routes_++ == 0) closed_at_ = Vec3(route.points.front().x(), route.points.front().y(), z);
        closed_length_ += length;
    }
}

void Planner::take(const RoughRoute& route, const std::vector<Vec3>& down, double z, int layer) {
    std::vector<Vec3> tips;
    for (const Vec2& p : route.points)
        tips.emplace_back(p.x(), p.y(), z);
    take(tips, down, layer);
    result_.passes.back().drive = route.line;
    result_.passes.back().offset = route.offset;
}

void Planner::take(const std::vector<Vec3>& tips, const std::vector<Vec3>& down, int layer) {
    Pass pass;
    pass.drive = -1;
    pass.layer = layer;
    const Vec3 up(0, 0, 1);
    for (std::size_t i = 0; i < down.size(); ++i) {
        pass.entry.push_back({down[i], up});
        if (i > 0) field_->cut(cutter_, down[i - 1], down[i]);
    }
    for (const Vec3& tip : tips) {
        if (!pass.cl.empty()) field_->cut(cutter_, pass.cl.back().tip, tip);
        pass.cl.push_back({tip, up});
        pass.cc.push_back({tip, up});
    }
    if (pass.cl.size() == 1) field_->cut(cutter_, pass.cl.front().tip, pass.cl.front().tip);
    at_ = tips.back().head<2>();
    result_.passes.push_back(std::move(pass));
}

void Planner::add_warnings() {
    auto& warnings = result_.warnings;
    if (result_.cusp_max > settings_.tolerance * (1 + 1e-9))
        warnings.push_back("up to " + text_(result_.cusp_max)
                           + " stays above the allowance; the tolerance is " + text_(settings_.tolerance)
                           + (settings_.depth.is_number() ? ": choose a smaller depth or step-over" : ""));
    if (blocked_length_ > 0)
        warnings.push_back("shank or holder would hit the stock: " + text_(blocked_length_)
                           + " of cuts are left out, the first at " + text_(blocked_at_)
                           + ": use a longer tool");
    if (closed_routes_ > 0)
        warnings.push_back(
            std::to_string(closed_routes_) + (closed_routes_ == 1 ? " place is" : " places are")
            + " left out that the tool has no room to enter by a ramp or a helix (" + text_(closed_length_)
            + " of cuts), the first at " + text_(closed_at_) + ": use a smaller tool, or allow it to plunge");
    if (settings_.allowance > 0 && context_.part_box.hi.z() + settings_.allowance > field_->box().hi.z())
        warnings.push_back("the stock ends " + text_(field_->box().hi.z() - context_.part_box.hi.z())
                           + " above the part: the allowance of " + text_(settings_.allowance)
                           + " cannot stay everywhere");
    if (context_.part_box.hi.z() > field_->box().hi.z() + tolerance::contact_distance)
        warnings.push_back("the part reaches " + text_(context_.part_box.hi.z() - field_->box().hi.z())
                           + " above the stock");
    warn_of_short_tool();
}

/// Where the part keeps shank or holder away though the cutter alone could go there, and something is left
/// that it would have cut.
void Planner::warn_of_short_tool() {
    const std::vector<double>& heights = layers_.heights;
    std::size_t places = 0;
    double lacks = 0;
    Vec3 at = Vec3::Zero();
    for (const ReachGrid::HeldUp& p : grid_->held_up()) {
        progress_.check();
        // The deepest layer that the cutter could be on.
        const auto deeper = std::upper_bound(heights.begin(), heights.end(), p.cutter, std::greater<>());
        if (deeper == heights.begin()) continue;
        const double z = *(deeper - 1);
        const Vec3 tip(p.place.x(), p.place.y(), z);
        if (z >= p.tool || !field_->has_work(cutter_, tip, tip, expected() + field_->cell())) continue;
        ++places;
        if (p.tool - z > lacks) {
            lacks = p.tool - z;
            at = tip;
        }
    }
    if (places == 0) return;
    result_.warnings.push_back(
        "the tool is short: shank or holder would come nearer to the part than the allowance, so over "
        + format_number(std::max(100.0 * double(places) / double(grid_->columns() * grid_->rows()), 1e-3), 2)
        + " % of the ground the cutter stays above where it could be, by up to " + text_(lacks) + ", most at "
        + text_(at) + ": use a longer tool");
}

/// The part with every vertex moved along its normal (Lu 3.4.3).
ContactIndexPtr Planner::offset_index(const Progress& progress) const {
    std::shared_ptr<const MeshGeometry> geometry = context_.geometry;
    if (!geometry) geometry = compute_geometry(*context_.part, progress.part(0, 0.5));
    const UpSide up(*context_.part, progress);
    auto moved = std::make_shared<Mesh>(*context_.part);
    for (std::size_t i = 0; i < moved->vertices.size(); ++i)
        moved->vertices[i] += allowance_ * up.towards_tool(geometry->vertex_normals[i]);
    return std::make_shared<ContactIndex>(moved, progress.part(0.5, 1));
}

/// Looks at every pass again, by the lift alone: no way that was planned may come nearer to the part than the
/// allowance. The surface offset by vertices does not promise it; what it lets through is told.
void Planner::check_passes(const Progress& progress) {
    const AxialLift exact(context_.contact, profile_, allowance_);
    struct Worst {
        double depth = 0;
        Vec3 at = Vec3::Zero();
    };
    const Worst worst = parallel_reduce(
        result_.passes.size(), 1, Worst(), progress,
        [&](std::size_t begin, std::size_t end) {
            Worst w;
            LiftHint hint;
            const auto look = [&](const std::vector<CutterLocation>& route) {
                for (std::size_t k = 1; k < route.size(); ++k) {
                    progress.check();
                    const Vec3 &a = route[k - 1].tip, &b = route[k].tip;
                    const double n = std::max(1.0, std::ceil((b - a).norm() / reach_->spacing()));
                    for (double i = 0; i <= n; ++i) {
                        const Vec3 p = a + (i / n) * (b - a);
                        const double depth = exact.tip_z(p.x(), p.y(), hint, p.z() + w.depth) - p.z();
                        if (depth > w.depth) w = {depth, p};
                    }
                }
            };
            for (std::size_t i = begin; i < end; ++i) {
                look(result_.passes[i].entry);
                look(result_.passes[i].cl);
            }
            return w;
        },
        [](const Worst& a, const Worst& b) { return b.depth > a.depth ? b : a; });
    if (worst.depth <= tolerance::contact_distance) return;
    if (settings_.offset == RoughSettings::Offset::contact)
        throw Error(ErrorCode::internal, settings_.name,
                    "a pass goes " + text_(worst.depth) + " into the allowance at " + text_(worst.at),
                    "report this");
    result_.warnings.push_back("the surface offset by vertices lets the cutter up to " + text_(worst.depth)
                               + " (upright) into the allowance of " + text_(settings_.allowance)
                               + ", most at " + text_(worst.at) + ": use offset contact");
}

} // namespace

const ParameterTable<RoughSettings>& rough_parameters() {
    static const auto table = [] {
        using K = ParameterKind;
        using S = RoughSettings;
        ParameterTable<S> t;
        add_common_parameters(t);
        t.add(&S::depth, {.key = "depth",
                          .label = "Depth",
                          .help = "Distance between neighbouring layers; from_tolerance is everywhere the "
                                  "largest that leaves no more than the tolerance above the allowance, at "
                                  "most the diameter, and puts lines closer where a floor stays.",
                          .kind = K::number_or_word,
                          .quantity = Quantity::length,
                          .minimum = 0,
                          .maximum = 1000,
                          .open_minimum = true,
                          .words = {"from_tolerance"}});
        t.add(&S::stepover, {.key = "stepover",
                             .label = "Step-over",
                             .help = "Largest distance between neighbouring lines of a layer, at most the "
                                     "diameter; auto is 0.95 of the diameter.",
                             .kind = K::number_or_word,
                             .quantity = Quantity::length,
                             .minimum = 0,
                             .maximum = 10000,
                             .open_minimum = true,
                             .words = {"auto"}});
        t.add_choice(&S::pattern, {.key = "pattern",
                                   .label = "Pattern",
                                   .help = "zigzag cuts to and fro; oneway always cuts in the direction of "
                                           "travel and returns above what stands.",
                                   .words = {"zigzag", "oneway"}});
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

RoughPreview preview_rough(const RoughSettings& settings, const PlanContext& context,
                           const Progress& progress) {
    check_plannable(context, settings);
    return Planner(settings, context, progress).preview();
}

StrategyResult Rough::plan(const PlanContext& context, const Progress& progress) const {
    check_plannable(context, settings_);
    return Planner(settings_, context, progress).run();
}

} // namespace facetmill
