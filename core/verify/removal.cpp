#include "core/verify/removal.h"

#include "core/base/error.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/verify/removal_batch.h"

#include <map>

namespace facetmill {

namespace {

/// Straight moves of one batch: enough to keep all threads busy, few enough for a quick cancel.
constexpr std::size_t items_per_batch = 1024;
/// Of one move, at most.
constexpr std::size_t max_pieces = 4096;
/// Of the rays in a tool's shadow, those that still have something there: the moves before have cut the rest.
/// Measured on a turned part, and on a relief.
constexpr double met_turning = 0.2, met_straight = 0.02;

std::string goto_name(const VerifyProgram& program, std::size_t motion) {
    return "'" + program.name + "', GOTO " + std::to_string(motion + 1);
}

} // namespace

void check_programs(std::span<const VerifyProgram> programs) {
    if (programs.empty())
        throw Error(ErrorCode::empty_result, "verification", "there is no program",
                    "plan an operation first");
    for (const VerifyProgram& program : programs) {
        if (!program.motions || program.motions->motions.empty())
            throw Error(ErrorCode::empty_result, "'" + program.name + "'", "the program has no motion",
                        "plan it again");
        const auto& motions = program.motions->motions;
        for (std::size_t i = 0; i < motions.size(); ++i) {
            const CutterLocation& to = motions[i].to;
            if (!to.tip.allFinite() || !to.axis.allFinite())
                throw Error(ErrorCode::non_finite, goto_name(program, i),
                            "a coordinate is not a finite number", "correct the program");
            if (to.tip.cwiseAbs().maxCoeff() > tolerance::largest_program_coordinate)
                throw Error(ErrorCode::coordinate_range, goto_name(program, i), "a coordinate is too large",
                            "check the program's units");
            if (std::abs(to.axis.norm() - 1) > tolerance::unit_axis)
                throw Error(ErrorCode::out_of_range, goto_name(program, i),
                            "the tool axis is not of length 1", "correct i, j, k");
            if (i > 0 && to.axis.dot(motions[i - 1].to.axis) < -1 + tolerance::level_angle)
                throw Error(ErrorCode::out_of_range, goto_name(program, i),
                            "the tool axis turns by half a turn at once",
                            "add a CL between, which says in which plane it turns");
        }
    }
}

struct MaterialRemoval::Bodies {
    struct Checked {
        TurnedBody still, turning; ///< shrunk for motions without and with a turning axis
        Collision::Kind kind;
    };
    TurnedBody cutter;
    Checked rapid;                 ///< the cutter, where it must not cut
    std::vector<Checked> sections; ///< shank and holder
    double reach;                  ///< of the cutter
    double whole_reach, radius;    ///< of all bodies

    /// How far from the tip the tool is in the stock during a motion, at most; no more than the cutter's
    /// reach. With the length of the flutes instead, turns in shallow cuts would be divided many times over.
    double reach_in(const Box3& stock, const CutterLocation& from, const CutterLocation& to,
                    const std::optional<TurningAxis>& turning) const {
        if (from.axis == to.axis) return reach;
        double route = (to.tip - from.tip).norm();
        const double angle = angle_turned(from.axis, to.axis, turning);
        if (turning)
            route += angle * std::max((from.tip - turning->point).norm(), (to.tip - turning->point).norm());
        // So far is no place between the ends from the nearer of them; axes may tilt as well as turn.
        const Vec3 margin = Vec3::Constant(radius + route + 2 * whole_reach * angle);
        const Box3 near{stock.lo - margin, stock.hi + margin};
        double farthest = 0;
        for (const CutterLocation& at : {from, to}) {
            double enter = 0, leave = whole_reach;
            for (int k = 0; k < 3; ++k) {
                const double a = (near.lo[k] - at.tip[k]) / at.axis[k],
                             b = (near.hi[k] - at.tip[k]) / at.axis[k];
                if (std::isnan(a) || std::isnan(b)) return reach;
                enter = std::max(enter, std::min(a, b));
                leave = std::min(leave, std::max(a, b));
            }
            if (enter <= leave) farthest = std::max(farthest, leave);
        }
        return std::min(reach, std::hypot(farthest, radius));
    }
};

MaterialRemoval::MaterialRemoval(std::span<const VerifyProgram> programs, double motion_bound, double touch,
                                 std::size_t max_bytes)
    : programs_(programs), motion_bound_(motion_bound), touch_(touch), max_bytes_(max_bytes) {
    for (const VerifyProgram& program : programs) {
        TurnedBody cutter(program.tool.cutter);
        const double reach = cutter.reach();
        const auto checked = [&](const TurnedBody& body, Collision::Kind kind) {
            // The bound holds for what is as near to the tip as the cutter is.
            const double turn = motion_bound * std::max(1.0, body.reach() / reach);
            return Bodies::Checked{body.shrunk(touch), body.shrunk(touch + 2 * turn), kind};
        };
        Bodies bodies{cutter, checked(cutter, Collision::Kind::rapid), {}, reach, reach, cutter.radius()};
        for (const ToolSection& s : program.tool.sections) {
            const TurnedBody section(s.radius, s.from, s.to);
            bodies.sections.push_back(checked(section, s.part == ToolSection::Part::shank
                                                           ? Collision::Kind::shank
                                                           : Collision::Kind::holder));
            bodies.whole_reach = std::max(bodies.whole_reach, section.reach());
            bodies.radius = std::max(bodies.radius, section.radius());
        }
        bodies_.push_back(std::move(bodies));
    }
    air_.assign(programs.size(), 0);
    for (const Bodies& bodies : bodies_)
        meters_.emplace_back(2 * bodies.cutter.radius());
}

MaterialRemoval::~MaterialRemoval() = default;

namespace {

bool apart(const Box3& a, const Box3& b) {
    return (a.lo.array() > b.hi.array()).any() || (b.lo.array() > a.hi.array()).any();
}

} // namespace

std::size_t MaterialRemoval::bytes_needed(const StockModel& stock, const Progress& progress) const {
    const StockLattice& lattice = stock.lattice();
    const Vec3 size = lattice.spacing * RayTile::side;
    std::array<std::vector<bool>, 3> reached;
    std::array<int, 3> across{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = std::size_t(axis);
        across[k] = tiles_of(lattice.nodes[std::size_t(first_across(axis))]);
        reached[k].assign(stock.tiles_[k].size(), false);
        for (std::size_t n = 0; n < reached[k].size(); ++n)
            reached[k][n] = stock.tiles_[k][n] != nullptr;
    }
    std::vector<StraightMove> moves;
    for (std::size_t n = 0; n < programs_.size(); ++n) {
        const auto& motions = programs_[n].motions->motions;
        for (std::size_t i = 0; i < motions.size(); ++i) {
            if (i % 1024 == 0) progress.check();
            if (motions[i].kind == MotionKind::rapid) continue;
            moves.clear();
            const CutterLocation &from = motions[i > 0 ? i - 1 : 0].to, &to = motions[i].to;
            const double reach = bodies_[n].reach_in(stock.solid().box, from, to, programs_[n].turning);
            straight_moves(from, to, programs_[n].turning, 0, 1, reach, motion_bound_, moves);
            for (const StraightMove& whole : moves) {
                // The box of a long move across the lattice holds much that the tool does not reach.
                const Vec3 route = whole.to - whole.from;
                const auto parts = std::size_t(
                    std::clamp(std::ceil(route.cwiseAbs().cwiseQuotient(size).maxCoeff()), 1.0, 4096.0));
                for (std::size_t p = 0; p < parts; ++p) {
                    const StraightMove part{whole.from + double(p) / double(parts) * route,
                                            whole.from + double(p + 1) / double(parts) * route, whole.axis};
                    const Box3 box = part.box(bodies_[n].cutter);
                    if (apart(box, stock.solid().box)) continue;
                    for (int axis = 0; axis < 3; ++axis) {
                        const TileRange r = tiles_in(box, lattice, axis);
                        auto& tiles = reached[std::size_t(axis)];
                        for (int b = r.from[1]; b <= r.to[1]; ++b)
                            for (int a = r.from[0]; a <= r.to[0]; ++a)
                                tiles[std::size_t(a)
                                      + std::size_t(across[std::size_t(axis)]) * std::size_t(b)] = true;
                    }
                }
            }
        }
    }
    std::size_t count = 0;
    for (const auto& family : reached)
        count += std::size_t(std::count(family.begin(), family.end(), true));
    return count * sizeof(RayTile);
}

double MaterialRemoval::rays_asked(const Box3& stock, double resolution) const {
    const double ray = resolution * resolution;
    double asked = 0;
    for (std::size_t n = 0; n < programs_.size(); ++n) {
        const auto& motions = programs_[n].motions->motions;
        const double radius = bodies_[n].cutter.radius();
        for (std::size_t i = 0; i < motions.size(); ++i) {
            if (motions[i].kind == MotionKind::rapid) continue;
            const CutterLocation &from = motions[i > 0 ? i - 1 : 0].to, &to = motions[i].to;
            const double reach = bodies_[n].reach_in(stock, from, to, programs_[n].turning);
            const double angle = angle_turned(from.axis, to.axis, programs_[n].turning);
            const double lever = programs_[n].turning ? (to.tip - programs_[n].turning->point).norm() : 0;
            const auto pieces = double(pieces_of_turn(angle, lever, reach, motion_bound_));
            Box3 box = StraightMove{from.tip, to.tip, to.axis}.box(bodies_[n].cutter);
            box.lo = box.lo.cwiseMax(stock.lo);
            box.hi = box.hi.cwiseMin(stock.hi);
            if (box.empty()) continue;
            const Vec3 size = box.size();
            const double swept = 2 * radius * (to.tip - from.tip).norm();
            const double met = angle > 0 ? met_turning : met_straight;
            for (int axis = 0; axis < 3; ++axis) {
                const double upright = std::abs(to.axis[axis]);
                const double beside = std::sqrt(std::max(0.0, (1 - upright) * (1 + upright)));
                const double shadow = pi * radius * radius * upright + 2 * radius * reach * beside;
                const double most = size[(axis + 1) % 3] * size[(axis + 2) % 3];
                asked += (met * pieces * std::min(shadow, most) + std::min(swept, most)) / ray;
            }
        }
    }
    return asked;
}

void MaterialRemoval::cut(StockModel& stock, std::size_t program, std::size_t first, std::size_t last,
                          double until, bool watch, const Progress& progress) {
    const VerifyProgram& p = programs_[program];
    const Bodies& bodies = bodies_[program];
    const auto& motions = p.motions->motions;
    std::vector<RemovalItem> items;
    std::vector<StraightMove> moves;
    const Box3 stock_box = stock.solid().box;
    for (std::size_t i = first; i < last; ++i) {
        const Motion& motion = motions[i];
        // Nothing is known of where the tool was before its first motion.
        const CutterLocation& from = motions[i > 0 ? i - 1 : 0].to;
        const double end = i + 1 == last ? until : 1;
        moves.clear();
        const double reach = bodies.reach_in(stock_box, from, motion.to, p.turning);
        straight_moves(from, motion.to, p.turning, 0, end, reach, motion_bound_, moves);
        const bool rapid = motion.kind == MotionKind::rapid;
        const bool turns = from.axis != motion.to.axis;
        if (rapid) steps_.push_back({.program = program, .motion = i, .lifts = true});
        for (const StraightMove& move : moves) {
            const auto watched = [&](const TurnedBody& body, Collision::Kind kind) {
                const Box3 box = move.box(body);
                if (!apart(box, stock_box)) items.push_back({&body, move, box, program, i, false, kind});
            };
            if (!rapid) add_cut(move, program, i, stock_box, items);
            if (!watch) continue;
            if (rapid) watched(turns ? bodies.rapid.turning : bodies.rapid.still, Collision::Kind::rapid);
            for (const Bodies::Checked& s : bodies.sections)
                watched(turns ? s.turning : s.still, rapid ? Collision::Kind::rapid : s.kind);
            if (items.size() >= items_per_batch) flush(stock, items, progress);
        }
        if (items.size() >= items_per_batch) flush(stock, items, progress);
        progress.set(double(i - first) / double(last - first));
    }
    if (last == motions.size()) steps_.push_back({.program = program, .motion = last, .lifts = true});
    flush(stock, items, progress);
    progress.set(1.0);
}

/// In pieces, which are asked one by one whether they cut anything.
void MaterialRemoval::add_cut(const StraightMove& move, std::size_t program, std::size_t motion,
                              const Box3& stock_box, std::vector<RemovalItem>& items) {
    const TurnedBody& cutter = bodies_[program].cutter;
    const Vec3 route = move.to - move.from;
    const double length = route.norm();
    const auto pieces =
        std::size_t(std::clamp(std::ceil(length / (2 * cutter.radius())), 1.0, double(max_pieces)));
    for (std::size_t k = 0; k < pieces; ++k) {
        const StraightMove piece{move.from + double(k) / double(pieces) * route,
                                 move.from + double(k + 1) / double(pieces) * route, move.axis};
        const Box3 box = piece.box(cutter);
        const double own = length / double(pieces);
        const bool beside = apart(box, stock_box);
        steps_.push_back({.program = program,
                          .motion = motion,
                          .length = own,
                          .item = beside ? std::size_t(-1) : items.size()});
        if (beside)
            air_[program] += own;
        else
            items.push_back({&cutter, piece, box, program, motion, true, Collision::Kind::rapid, own});
    }
}

void MaterialRemoval::flush(StockModel& stock, std::vector<RemovalItem>& items, const Progress& progress) {
    if (items.empty()) return tell_meters({});
    RemovalBatch batch(stock.solid(), stock.lattice(), stock.tiles_, items, only_);
    batch.run(progress);
    for (std::size_t n = 0; n < items.size(); ++n)
        if (items[n].length > 0 && !batch.has_cut(n)) air_[items[n].program] += items[n].length;
    tell_meters(batch.volumes());
    grown_ += batch.grown();
    if (grown_ > 0 && std::size_t(grown_) > max_bytes_)
        throw Error(ErrorCode::limit_exceeded, "resolution",
                    "the stock has more than " + format_number(double(max_bytes_) / 1e9, 3)
                        + " GB of rays in "
                        + goto_name(programs_[items.front().program], items.front().motion),
                    "use a coarser resolution");

    keep(batch.touches(), items.front());
    items.clear();
}

void MaterialRemoval::tell_meters(const std::vector<double>& volumes) {
    for (const Step& step : steps_) {
        LoadMeter& meter = meters_[step.program];
        if (step.lifts)
            meter.lift();
        else
            meter.add(step.length, programs_[step.program].feed_of(step.motion),
                      step.item < volumes.size() ? volumes[step.item] : 0, step.motion);
    }
    steps_.clear();
}

void MaterialRemoval::keep(const std::vector<std::vector<RemovalTouch>>& touches, const RemovalItem& first) {
    if (std::all_of(touches.begin(), touches.end(), [](const auto& t) { return t.empty(); })) return;
    std::map<std::tuple<std::size_t, std::size_t, Collision::Kind>, RemovalTouch> joined;
    const auto take = [&](const RemovalTouch& t) { joined.try_emplace(t.key(), t).first->second.join(t); };
    // A motion may have begun in the batch before.
    while (!touches_.empty() && touches_.back().program == first.program
           && touches_.back().motion >= first.motion) {
        take(touches_.back());
        touches_.pop_back();
    }
    for (const auto& list : touches)
        for (const RemovalTouch& t : list)
            take(t);
    for (const auto& [key, t] : joined)
        touches_.push_back(t);
}

std::vector<Collision> MaterialRemoval::collisions() const {
    std::vector<Collision> found;
    for (const RemovalTouch& t : touches_) {
        // A ray that runs along the surface of what is touched sees a long overlap where the depth is small:
        // the shortest of the three says most.
        Collision c;
        c.kind = t.kind;
        c.at = {t.program, t.motion};
        c.depth = infinity;
        for (std::size_t k = 0; k < 3; ++k)
            if (t.overlap[k] > 0 && t.overlap[k] + touch_ < c.depth) {
                c.depth = t.overlap[k] + touch_;
                c.place = t.place[k];
            }
        found.push_back(c);
    }
    return found;
}

} // namespace facetmill
