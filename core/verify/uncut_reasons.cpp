#include "core/verify/uncut_reasons.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/mesh/box_tree.h"
#include "core/verify/probes.h"
#include "core/verify/winding_number.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace facetmill {

namespace {

/// Uncut samples that are asked why: enough to share out the area by reasons to a percent or two.
constexpr std::size_t max_asked = 4000;
/// Axes that are tried at a sample, the nearest to its normal: a tool that fits fits with one of them.
constexpr std::size_t max_axes_tried = 12;
/// Samples in a box of the tree.
constexpr std::size_t samples_per_box = 32;
/// Places on a fixture, how far apart at least in radii of the cutter, and what a tool has to keep of the
/// clearance so that the fixture is no reason: planners of five axes are not that exact.
constexpr std::size_t max_fixture_places = 200'000;
constexpr double fixture_place_share = 0.2, beyond_clearance = 1.2;
/// Places on what is left of the stock, about so many at most.
constexpr std::size_t max_stock_places = 2'000'000;

/// Whether bodies can stand somewhere without having samples of the part inside.
class Room {
public:
    Room(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& order, const Progress& progress) {
        const std::size_t n = points.size();
        for (const std::uint32_t i : order)
            points_.push_back(points[i]);
        std::vector<Box3> boxes((n + samples_per_box - 1) / samples_per_box);
        for (std::size_t i = 0; i < n; ++i)
            boxes[i / samples_per_box].add(points_[i]);
        tree_ = BoxTree(std::move(boxes), progress);
    }
    Room(const Mesh& mesh, double spacing, const Progress& progress)
        : Room(sample_surface(mesh, spacing, max_fixture_places, progress, 0).points, progress) {}
    Room(const std::vector<Vec3>& points, const Progress& progress)
        : Room(points, neighbors_together(points, progress), progress) {}
    /// No point lies deeper than `slack` in a body whose tip is here.
    bool has(const BodySupport& body, const CutterLocation& at, double slack) const {
        const Vec3 middle = at.tip + body.middle() * at.axis;
        bool free = true;
        tree_.each(
            [&](const Box3& box) {
                if (!free) return false;
                const Vec3 nearest = middle.cwiseMax(box.lo).cwiseMin(box.hi);
                const BodySupport::Plane plane = body.nearest(nearest - at.tip, at.axis);
                double most = plane.inside;
                for (int k = 0; k < 3; ++k)
                    most -= plane.normal[k] * ((plane.normal[k] > 0 ? box.lo[k] : box.hi[k]) - nearest[k]);
                return most > slack;
            },
            [&](std::size_t box) {
                const std::size_t end = std::min(points_.size(), (box + 1) * samples_per_box);
                for (std::size_t i = box * samples_per_box; free && i < end; ++i)
                    free = !(body.nearest(points_[i] - at.tip, at.axis).inside > slack);
            });
        return free;
    }

private:
    std::vector<Vec3> points_; ///< neighbours together
    BoxTree tree_;
};

struct FitTool {
    BodySupport cutter;
    std::vector<BodySupport> sections;
    struct Held {
        Room room;
        double clearance;
        MeshPtr mesh;
        bool tab;
    };
    std::vector<Held> fixtures;
    std::vector<Vec3> axes; ///< with which its program cuts
    std::function<bool(const Vec3&)> asked;
    std::shared_ptr<const ToolMotions> motions;
    double radius = 0;                 ///< of the cutter
    bool finishes = true;              ///< what its operation leaves does not count as uncut
    std::optional<BodySupport> beyond; ///< the cutter of which its operation cuts what it cannot enter
    Vec3 up = Vec3::UnitZ();           ///< of its setup
    double lowest = -infinity;  ///< along it: the stock's bottom, or how low the cutter goes if that is lower
    std::optional<Room> before; ///< the stock as it begins with it, where shank and holder keep out of it
};

/// How high the lowest place of a cutter is along `up`.
double lowest_of(const BodySupport& cutter, const CutterLocation& at, const Vec3& up) {
    return (at.tip + cutter.support(-up, at.axis)).dot(up);
}

/// Ends of the rays' stretches, on rays so far apart that they are not too many.
std::vector<Vec3> stock_places(const StockModel& stock, const Progress& progress) {
    const StockLattice& lattice = stock.lattice();
    const double ends = 2 * double(lattice.rays()); // mostly
    const int step = std::max(1, int(std::ceil(std::sqrt(ends / double(max_stock_places)))));
    std::vector<Vec3> places;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int i = 0; i < lattice.nodes[std::size_t(u)]; i += step) {
            progress.check();
            for (int j = 0; j < lattice.nodes[std::size_t(v)]; j += step)
                for (const auto& stretch : stock.stretches(axis, i, j))
                    for (const double end : stretch) {
                        Vec3& p = places.emplace_back();
                        p[axis] = end;
                        p[u] = lattice.origin[u] + i * lattice.spacing[u];
                        p[v] = lattice.origin[v] + j * lattice.spacing[v];
                    }
        }
    }
    return places;
}

constexpr std::size_t no_program = std::size_t(-1);

struct WhyUncut {
    UncutReason::Why why = UncutReason::Why::no_tool;
    std::size_t program = no_program; ///< whose tool or cutter fits
    bool operator<(const WhyUncut& other) const {
        return std::pair(why, program) < std::pair(other.why, other.program);
    }
};

/// Whether a tool of the programs could bring what stands on a place down to less than what counts as uncut,
/// without a gouge; and if not, whether its cutter could.
class Fit {
public:
    Fit(const SurfaceSamples& samples, const std::vector<std::uint32_t>& order,
        std::span<const VerifyProgram> programs, const Box3& stock, const VerifySettings& used,
        const Progress& progress)
        : room_(samples.points, order, progress), allowance_(used.allowance), limit_(2 * used.tolerance),
          gouge_limit_(used.gouge_limit) {
        for (const VerifyProgram& p : programs) {
            FitTool tool{BodySupport(p.tool.cutter),      {},      {},
                         cutting_axes({&p, 1}, progress), p.asked, p.motions,
                         p.tool.cutter.max_radius()};
            for (const ToolSection& s : p.tool.sections)
                tool.sections.emplace_back(s);
            tool.finishes = p.leaves <= used.allowance + limit_;
            if (p.beyond) tool.beyond.emplace(CutterProfile(*p.beyond));
            if (!p.turning) find_lowest(tool, p, stock);
            if (p.fixtures)
                for (const FixtureSolid& f : *p.fixtures) {
                    const double apart =
                        std::max(f.clearance, fixture_place_share * p.tool.cutter.max_radius());
                    tool.fixtures.push_back({Room(*f.mesh, apart, progress), f.clearance, f.mesh, f.tab});
                }
            tools_.push_back(std::move(tool));
        }
    }
    /// From now on shank and holder are asked against what is left of the stock, too.
    void stand_in(const StockModel& stock, const Progress& progress) {
        left_.emplace(stock_places(stock, progress), progress);
    }
    /// And those of a program against what it begins with.
    void begin_in(std::size_t program, const StockModel& stock, const Progress& progress) {
        tools_[program].before.emplace(stock_places(stock, progress), progress);
    }
    /// True where a program's tool fits no farther than its cutter is wide at its radius from the motion that
    /// left what stands, as the middle of its end moves, whichever way the axes lean, or, if it is upright,
    /// where others of its motions go by above and below, as along a steep side: the next pass is too far
    /// away. `by`: that motion; unknown where it is another program's.
    bool is_beside(const Vec3& point, const Vec3& normal, std::size_t program, const MotionPlace& by) const {
        const FitTool& tool = tools_[program];
        CutterLocation fits;
        if (!tool.finishes || (tool.asked && !tool.asked(point))
            || fit_of(tool, point, normal, &fits) != UncutReason::Why::not_cut)
            return false;
        const std::span<const Motion> motions = tool.motions->motions;
        if (by.known() && from_motion(fits, tool, by.motion).norm() <= tool.radius) return true;
        if (tool.axes.size() != 1) return false;
        bool above = false, below = false;
        for (std::size_t i = 1; i < motions.size() && !(above && below); ++i) {
            if (motions[i].kind == MotionKind::rapid) continue;
            const Vec3 off = from_motion(fits, tool, i);
            const double height = off.dot(tool.axes.front());
            if (off.squaredNorm() - height * height <= tool.radius * tool.radius)
                (height < 0 ? above : below) = true;
        }
        return above && below;
    }
    /// not_cut where a tool fits, boundary, below_bottom, fixture, tab, stock, held, no_operation, or
    /// no_tool; and the program whose tool or cutter it is. Where only an operation is left that cuts what
    /// another cutter cannot enter, and that one can, it is its.
    WhyUncut reason(const Vec3& point, const Vec3& normal) const {
        WhyUncut told_off, left_to_others;
        for (std::size_t program = tools_.size(); program-- > 0;) {
            const FitTool& tool = tools_[program];
            if (!tool.finishes) continue;
            const UncutReason::Why fit = fit_of(tool, point, normal);
            if (fit == UncutReason::Why::no_tool) continue;
            const bool asked = !tool.asked || tool.asked(point);
            if (asked && tool.beyond && cutter_fits(*tool.beyond, tool, point, normal)) {
                if (left_to_others.program == no_program) left_to_others = {fit, program};
                continue;
            }
            if (asked) return {fit, program};
            if (fit == UncutReason::Why::not_cut && told_off.program == no_program)
                told_off = {UncutReason::Why::boundary, program};
        }
        if (told_off.program != no_program) return told_off;
        if (left_to_others.program != no_program) return left_to_others;
        for (std::size_t program = tools_.size(); program-- > 0;) {
            const FitTool& tool = tools_[program];
            if (!tool.finishes && fit_of(tool, point, normal) == UncutReason::Why::not_cut)
                return {UncutReason::Why::no_operation, program};
        }
        return told_off;
    }

private:
    static void find_lowest(FitTool& tool, const VerifyProgram& program, const Box3& stock) {
        if (stock.empty()) return;
        tool.up = program.machine_turn * Vec3::UnitZ();
        const Vec3 below = tool.up.array().sign() * (0.5 * stock.size()).array();
        tool.lowest = (stock.center() - below).dot(tool.up);
        for (const Motion& m : program.motions->motions)
            if (m.kind != MotionKind::rapid)
                tool.lowest = std::min(tool.lowest, lowest_of(tool.cutter, m.to, tool.up));
    }
    /// To the middle of a cutter's end from where it is nearest in a motion.
    static Vec3 from_motion(const CutterLocation& at, const FitTool& tool, std::size_t motion) {
        const std::span<const Motion> motions = tool.motions->motions;
        const auto middle = [&](const CutterLocation& l) {
            return Vec3(l.tip + tool.cutter.middle() * l.axis);
        };
        const Vec3 end = middle(at), to = middle(motions[motion].to),
                   moved = to - middle(motions[motion > 0 ? motion - 1 : 0].to);
        const double square = moved.squaredNorm();
        const double t = square > 0 ? std::clamp((to - end).dot(moved) / square, 0.0, 1.0) : 0;
        return end - to + t * moved;
    }
    /// not_cut, below_bottom, fixture, tab, stock, held or no_tool for one of the tools; for the first
    /// where.
    UncutReason::Why fit_of(const FitTool& tool, const Vec3& point, const Vec3& normal,
                            CutterLocation* fits = nullptr) const {
        const Vec3 start = point + allowance_ * normal;
        bool held = false, beside_fixture = false, in_tab = false, in_stock = false, low = false;
        for (const auto& [along, axis] : axes_near(tool, normal))
            for (const Vec3& touch : places_at(tool.cutter, normal, *axis)) {
                const CutterLocation at{start - touch, *axis};
                if (!room_.has(tool.cutter, at, gouge_limit_ - allowance_)) continue;
                if (!body_stands(room_, at, tool))
                    held = true;
                else if (!clear_of(at, tool, false))
                    beside_fixture = true;
                else if (!clear_of(at, tool, true))
                    in_tab = true;
                else if (lowest_of(tool.cutter, at, tool.up) < tool.lowest - gouge_limit_)
                    low = true;
                else if ((left_ && !body_stands(*left_, at, tool))
                         || (tool.before && !body_stands(*tool.before, at, tool)))
                    in_stock = true;
                else {
                    if (fits) *fits = at;
                    return UncutReason::Why::not_cut;
                }
            }
        return in_stock         ? UncutReason::Why::stock
               : low            ? UncutReason::Why::below_bottom
               : in_tab         ? UncutReason::Why::tab
               : beside_fixture ? UncutReason::Why::fixture
               : held           ? UncutReason::Why::held
                                : UncutReason::Why::no_tool;
    }
    /// Whether a cutter fits without regard to what is above it, with the axes of a program.
    bool cutter_fits(const BodySupport& cutter, const FitTool& of, const Vec3& point,
                     const Vec3& normal) const {
        const Vec3 start = point + allowance_ * normal;
        for (const auto& [along, axis] : axes_near(of, normal))
            for (const Vec3& touch : places_at(cutter, normal, *axis))
                if (room_.has(cutter, {start - touch, *axis}, gouge_limit_ - allowance_)) return true;
        return false;
    }
    /// Its program's axes that see the surface, the nearest to the normal first.
    static std::vector<std::pair<double, const Vec3*>> axes_near(const FitTool& tool, const Vec3& normal) {
        std::vector<std::pair<double, const Vec3*>> near;
        for (const Vec3& a : tool.axes)
            if (const double along = a.dot(normal); along > tolerance::vertical_normal_z)
                near.push_back({-along, &a});
        std::sort(near.begin(), near.end());
        if (near.size() > max_axes_tried) near.resize(max_axes_tried);
        return near;
    }
    /// Places from the tip that may stand at the sample. With those of the cutter that touch a surface of
    /// this normal, lifted by a quarter of what counts as uncut, or nearly all of it; and with places round
    /// about them, lifted so that the cutter is in touch beside the sample. A flat end touches a level floor
    /// with any place of it: some rings of them are tried.
    std::vector<Vec3> places_at(const BodySupport& cutter, const Vec3& normal, const Vec3& axis) const {
        constexpr double level_cosine = 0.9998, lean = 1e-3; // a degree
        constexpr double low = 0.25, high = 0.95;            // of what counts as uncut
        constexpr int round = 8, rings = 4;
        const Vec3 foot = cutter.support(-normal, axis);
        std::vector<Vec3> places{foot - low * limit_ * normal, foot - high * limit_ * normal};
        const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
        for (int k = 0; k < round; ++k) {
            const double turn = 2 * pi * k / round;
            const Vec3 aside = std::cos(turn) * x + std::sin(turn) * y;
            // The farthest place aside that is no higher over the surface than that.
            double from = 0, to = 0.25 * pi;
            for (int halving = 0; halving < 12; ++halving) {
                const double angle = 0.5 * (from + to);
                const Vec3 place = cutter.support(std::sin(angle) * aside - std::cos(angle) * normal, axis);
                ((place - foot).dot(normal) <= high * limit_ ? from : to) = angle;
            }
            const Vec3 place = cutter.support(std::sin(from) * aside - std::cos(from) * normal, axis);
            const double height = (place - foot).dot(normal);
            if (height <= high * limit_) places.push_back(place - (height + (1 - high) * limit_) * normal);
            if (normal.dot(axis) < level_cosine) continue;
            // A direction that leans a little finds the rim.
            const Vec3 rim = cutter.support((lean * aside - axis).normalized(), axis);
            for (int ring = 1; ring <= rings; ++ring)
                places.push_back(double(ring) / rings * rim - low * limit_ * normal);
        }
        return places;
    }
    bool body_stands(const Room& room, const CutterLocation& at, const FitTool& tool) const {
        return std::all_of(tool.sections.begin(), tool.sections.end(),
                           [&](const BodySupport& s) { return room.has(s, at, gouge_limit_); });
    }
    /// No nearer to fixtures, or to tabs, than the clearance, and what planners keep beyond it.
    bool clear_of(const CutterLocation& at, const FitTool& tool, bool tabs) const {
        return std::all_of(tool.fixtures.begin(), tool.fixtures.end(), [&](const FitTool::Held& held) {
            if (held.tab != tabs) return true;
            const double slack = -beyond_clearance * held.clearance;
            const auto has = [&](const BodySupport& body) { return held.room.has(body, at, slack); };
            // Deep in a large one no place of its surface is near.
            return std::abs(winding_number(*held.mesh, at.tip, Progress())) < 0.5 && has(tool.cutter)
                   && std::all_of(tool.sections.begin(), tool.sections.end(), has);
        });
    }
    Room room_;
    std::optional<Room> left_; ///< of the stock
    std::vector<FitTool> tools_;
    double allowance_, limit_, gouge_limit_;
};

/// Why each of the samples that are asked is uncut.
std::vector<WhyUncut> why_uncut(const Verification& v, const std::vector<std::size_t>& asked,
                                const SurfaceSamples& samples, const std::vector<std::uint32_t>& order,
                                const Probed& probed, const StocksBefore& before,
                                std::span<const VerifyProgram> programs, const Progress& progress) {
    using Why = UncutReason::Why;
    std::vector<WhyUncut> found(asked.size());
    if (asked.empty()) return found;
    Fit fit(samples, order, programs, v.stock ? v.stock->solid().box : Box3(), v.used, progress);
    const auto ask = [&](std::size_t g) {
        const std::size_t i = asked[g];
        found[g] = fit.reason(samples.points[i], samples.normals[i]);
    };
    parallel_for(asked.size(), 4, progress, ask);
    // What is left of the stock is many more places: only where nothing else is in the way.
    const auto fits = [](const WhyUncut& why) { return why.why == Why::not_cut; };
    const auto ask_again = [&](std::size_t program) {
        parallel_for(asked.size(), 4, progress, [&](std::size_t g) {
            if (fits(found[g]) && (program == no_program || found[g].program == program)) ask(g);
        });
    };
    if (v.stock && std::any_of(found.begin(), found.end(), fits)) {
        fit.stand_in(*v.stock, progress);
        ask_again(no_program);
    }
    // A tool that came into the stock was not kept from anywhere by it.
    for (std::size_t i = std::min(before.size(), programs.size()); i-- > 0;) {
        const auto its = [&](const WhyUncut& why) { return fits(why) && why.program == i; };
        const auto touched = [&](const Collision& c) { return c.at.program == i && !c.with_part; };
        if (std::none_of(found.begin(), found.end(), its)
            || std::any_of(v.collisions.begin(), v.collisions.end(), touched))
            continue;
        fit.begin_in(i, *before[i], progress);
        ask_again(i);
    }
    parallel_for(asked.size(), 4, progress, [&](std::size_t g) {
        if (!fits(found[g])) return;
        const Vec3 &point = samples.points[asked[g]], &normal = samples.normals[asked[g]];
        const MotionPlace& by = probed.by[asked[g]];
        if (by.known() && fit.is_beside(point, normal, by.program, by))
            found[g] = {Why::passes_apart, by.program};
        else if (fit.is_beside(point, normal, found[g].program, {}))
            found[g].why = Why::passes_apart;
    });
    return found;
}

} // namespace

void find_uncut_reasons(Verification& v, const SurfaceSamples& samples, const Probed& probed,
                        const StocksBefore& before, std::span<const VerifyProgram> programs,
                        const Progress& progress) {
    using Why = UncutReason::Why;
    v.uncut.clear();
    v.uncut_share = 0;
    if (!(v.used.tolerance > 0)) return;
    std::map<WhyUncut, UncutReason> reasons;
    const auto add = [&](const WhyUncut& why, std::size_t i, double area, double excess) {
        UncutReason& reason = reasons[why];
        if (reason.area == 0 || excess > reason.excess_max) {
            reason.excess_max = std::max(reason.excess_max, excess);
            reason.place = samples.points[i];
        }
        reason.why = why.why;
        if (why.program != no_program) reason.program = programs[why.program].name;
        reason.area += area;
    };
    const double limit = 2 * v.used.tolerance;
    double to_cut = 0;
    std::vector<std::size_t> standing;
    // Neighbours together: each sample that is asked stands for those about it.
    const std::vector<std::uint32_t> order = neighbors_together(samples.points, progress);
    for (const std::uint32_t i : order) {
        if (i % 65536 == 0) progress.check();
        const std::uint8_t flags = samples.flags[i];
        const double excess = std::max(probed.deviation[i], 0.0);
        if (flags == DeviationSurface::hidden) {
            if (excess > limit) add({Why::not_seen}, i, samples.weights[i], excess);
            continue;
        }
        if (flags == DeviationSurface::away && samples.upright[i] != 0 && excess > limit)
            add({Why::upright}, i, samples.weights[i], excess);
        if ((flags & ~DeviationSurface::bare) != 0) continue;
        to_cut += samples.weights[i];
        if (flags & DeviationSurface::bare)
            add({Why::outside_stock}, i, samples.weights[i], 0);
        else if (excess > limit)
            standing.push_back(i);
    }
    const std::size_t groups = std::min(standing.size(), max_asked);
    const auto first_of = [&](std::size_t group) { return group * standing.size() / groups; };
    std::vector<std::size_t> asked;
    for (std::size_t g = 0; g < groups; ++g)
        asked.push_back(standing[(first_of(g) + first_of(g + 1)) / 2]);
    const std::vector<WhyUncut> found =
        why_uncut(v, asked, samples, order, probed, before, programs, progress);
    for (std::size_t g = 0; g < groups; ++g)
        for (std::size_t k = first_of(g); k < first_of(g + 1); ++k) {
            const std::size_t i = standing[k];
            add(found[g], i, samples.weights[i], probed.deviation[i]);
        }
    double area = 0;
    for (const auto& [why, reason] : reasons) {
        v.uncut.push_back(reason);
        if (reason.counts()) area += reason.area;
    }
    // What is only told comes after what counts.
    std::stable_sort(v.uncut.begin(), v.uncut.end(), [](const UncutReason& a, const UncutReason& b) {
        return a.counts() != b.counts() ? a.counts() : a.area > b.area;
    });
    v.uncut_share = to_cut > 0 ? area / to_cut : 0;
}

} // namespace facetmill
