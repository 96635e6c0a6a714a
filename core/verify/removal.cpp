#include "core/verify/removal.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/verify/stock_tiles.h"
#include "core/verify/sweep.h"

#include <map>
#include <tuple>

namespace facetmill {

namespace {

/// Straight moves of one batch: enough to keep all threads busy, few enough for a quick cancel.
constexpr std::size_t items_per_batch = 1024;
constexpr std::size_t items_per_check = 64;

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
};

struct MaterialRemoval::Item {
    const TurnedBody* body;
    StraightMove move;
    Box3 box;
    std::size_t program, motion;
    bool cuts;
    Collision::Kind kind;
};

/// The longest overlap that the rays of each family saw.
struct MaterialRemoval::Touch {
    std::size_t program = 0, motion = 0;
    Collision::Kind kind = Collision::Kind::rapid;
    std::array<double, 3> overlap{0, 0, 0};
    std::array<Vec3, 3> place{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};

    auto key() const { return std::tuple(program, motion, kind); }
    void join(const Touch& other) {
        for (std::size_t k = 0; k < 3; ++k)
            if (other.overlap[k] > overlap[k]) {
                overlap[k] = other.overlap[k];
                place[k] = other.place[k];
            }
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
        Bodies bodies{cutter, checked(cutter, Collision::Kind::rapid), {}, reach};
        for (const ToolSection& s : program.tool.sections)
            bodies.sections.push_back(checked(TurnedBody(s.radius, s.from, s.to),
                                              s.part == ToolSection::Part::shank ? Collision::Kind::shank
                                                                                 : Collision::Kind::holder));
        bodies_.push_back(std::move(bodies));
    }
}

MaterialRemoval::~MaterialRemoval() = default;

namespace {

/// The tiles of a family that a box reaches: from, to; in both directions.
struct TileRange {
    std::array<int, 2> from, to;
};

TileRange tiles_in(const Box3& box, const StockLattice& lattice, int axis) {
    TileRange r{};
    for (const std::size_t n : {0u, 1u}) {
        const int k = n == 0 ? first_across(axis) : second_across(axis);
        const auto at = [&](double x) { return (x - lattice.origin[k]) / lattice.spacing[k]; };
        const double most = lattice.nodes[std::size_t(k)] - 1;
        r.from[n] = int(std::clamp(std::ceil(at(box.lo[k])), 0.0, most)) / RayTile::side;
        r.to[n] = int(std::clamp(std::floor(at(box.hi[k])), 0.0, most)) / RayTile::side;
    }
    return r;
}

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
            straight_moves(motions[i > 0 ? i - 1 : 0].to, motions[i].to, programs_[n].turning, 0, 1,
                           bodies_[n].reach, motion_bound_, moves);
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

void MaterialRemoval::cut(StockModel& stock, std::size_t program, std::size_t first, std::size_t last,
                          double until, bool watch, const Progress& progress) {
    const VerifyProgram& p = programs_[program];
    const Bodies& bodies = bodies_[program];
    const auto& motions = p.motions->motions;
    std::vector<Item> items;
    std::vector<StraightMove> moves;
    const Box3 stock_box = stock.solid().box;
    for (std::size_t i = first; i < last; ++i) {
        const Motion& motion = motions[i];
        // Nothing is known of where the tool was before its first motion.
        const CutterLocation& from = motions[i > 0 ? i - 1 : 0].to;
        const double end = i + 1 == last ? until : 1;
        moves.clear();
        straight_moves(from, motion.to, p.turning, 0, end, bodies.reach, motion_bound_, moves);
        const bool rapid = motion.kind == MotionKind::rapid;
        const bool turns = from.axis != motion.to.axis;
        for (const StraightMove& move : moves) {
            const auto add = [&](const TurnedBody& body, bool cuts, Collision::Kind kind) {
                const Box3 box = move.box(body);
                if (!apart(box, stock_box)) items.push_back({&body, move, box, program, i, cuts, kind});
            };
            if (!rapid) add(bodies.cutter, true, Collision::Kind::rapid);
            if (!watch) continue;
            if (rapid) add(turns ? bodies.rapid.turning : bodies.rapid.still, false, Collision::Kind::rapid);
            for (const Bodies::Checked& s : bodies.sections)
                add(turns ? s.turning : s.still, false, rapid ? Collision::Kind::rapid : s.kind);
            if (items.size() >= items_per_batch) flush(stock, items, progress);
        }
        if (items.size() >= items_per_batch) flush(stock, items, progress);
        progress.set(double(i - first) / double(last - first));
    }
    flush(stock, items, progress);
    progress.set(1.0);
}

void MaterialRemoval::flush(StockModel& stock, std::vector<Item>& items, const Progress& progress) {
    if (items.empty()) return;
    const StockLattice& lattice = stock.lattice();
    const Vec3 middle = stock.solid().box.center();

    // Which tiles an item may change.
    struct Work {
        int axis, tile_i, tile_j;
        std::vector<std::uint32_t> items;
    };
    std::vector<Work> work;
    std::vector<std::array<bool, 3>> used(items.size(), {false, false, false});
    for (int axis = 0; axis < 3; ++axis) {
        const int u = first_across(axis), v = second_across(axis);
        const int tu = tiles_of(lattice.nodes[std::size_t(u)]), tv = tiles_of(lattice.nodes[std::size_t(v)]);
        std::vector<std::int32_t> of_tile(std::size_t(tu) * std::size_t(tv), -1);
        for (std::size_t n = 0; n < items.size(); ++n) {
            const Box3& box = items[n].box;
            const TileRange reached = tiles_in(box, lattice, axis);
            for (int j = reached.from[1]; j <= reached.to[1]; ++j)
                for (int i = reached.from[0]; i <= reached.to[0]; ++i) {
                    const std::size_t index = std::size_t(i) + std::size_t(tu) * std::size_t(j);
                    const auto& tile = stock.tiles_[std::size_t(axis)][index];
                    if (tile
                        && (tile->lo > tile->hi || box.lo[axis] - middle[axis] > tile->hi
                            || box.hi[axis] - middle[axis] < tile->lo))
                        continue;
                    if (of_tile[index] < 0) {
                        of_tile[index] = std::int32_t(work.size());
                        work.push_back({axis, i, j, {}});
                    }
                    work[std::size_t(of_tile[index])].items.push_back(std::uint32_t(n));
                    used[n][std::size_t(axis)] = true;
                }
        }
    }

    std::vector<std::array<std::optional<SweepRays>, 3>> rays(items.size());
    const Progress quiet = progress.part(0, 0); // cancels, and leaves the fraction alone
    parallel_for(items.size(), 32, quiet, [&](std::size_t n) {
        for (int axis = 0; axis < 3; ++axis)
            if (used[n][std::size_t(axis)])
                rays[n][std::size_t(axis)].emplace(*items[n].body, items[n].move, Vec3(Vec3::Unit(axis)));
    });

    std::vector<std::vector<Touch>> touches(work.size());
    std::vector<std::ptrdiff_t> grown(work.size(), 0);
    parallel_for(work.size(), 1, quiet, [&](std::size_t w) {
        const Work& job = work[w];
        const int axis = job.axis, u = first_across(axis), v = second_across(axis);
        const int tu = tiles_of(lattice.nodes[std::size_t(u)]);
        auto& place = stock.tiles_[std::size_t(axis)]
                                  [std::size_t(job.tile_i) + std::size_t(tu) * std::size_t(job.tile_j)];
        std::shared_ptr<RayTile> tile;
        const auto bytes_of = [](const RayTile& t) {
            return std::ptrdiff_t(sizeof t + t.more.capacity() * sizeof(RayTile::Piece));
        };
        const std::ptrdiff_t before = place ? bytes_of(*place) : 0;
        if (!place)
            tile = solid_tile(stock.solid(), lattice, axis, job.tile_i, job.tile_j);
        else if (place.use_count() > 1) // shared with a copy of the model, which stays as it is
            tile = std::make_shared<RayTile>(*place);
        else
            tile = place;
        const int i0 = job.tile_i * RayTile::side, j0 = job.tile_j * RayTile::side;
        const auto range = [&](const Box3& box, int k, int start) {
            const auto at = [&](double x) { return (x - lattice.origin[k]) / lattice.spacing[k] - start; };
            const int most = std::min(RayTile::side, lattice.nodes[std::size_t(k)] - start);
            return std::pair(int(std::clamp(std::ceil(at(box.lo[k])), 0.0, double(most))),
                             int(std::clamp(std::floor(at(box.hi[k])) + 1, 0.0, double(most))));
        };
        bool changed = false;
        std::size_t done = 0;
        for (const std::uint32_t n : job.items) {
            if (++done % items_per_check == 0) progress.check();
            const Item& item = items[n];
            const SweepRays& stretch_of = *rays[n][std::size_t(axis)];
            const float low = float(item.box.lo[axis] - middle[axis]),
                        high = float(item.box.hi[axis] - middle[axis]);
            const auto [ib, ie] = range(item.box, u, i0);
            const auto [jb, je] = range(item.box, v, j0);
            Touch touch{item.program, item.motion, item.kind, {}, {}};
            Vec3 p = middle;
            for (int j = jb; j < je; ++j) {
                p[v] = lattice.origin[v] + (j0 + j) * lattice.spacing[v];
                p[u] = lattice.origin[u] + i0 * lattice.spacing[u];
                double first = ib, last = ie - 1;
                for (const SweepRays::Strip& strip : stretch_of.strips()) {
                    const double start = strip.value.dot(p), step = strip.value[u] * lattice.spacing[u];
                    if (step == 0) {
                        if (start < strip.low || start > strip.high) last = -1;
                        continue;
                    }
                    const double a = (strip.low - start) / step, b = (strip.high - start) / step;
                    first = std::max(first, std::ceil(std::min(a, b)));
                    last = std::min(last, std::floor(std::max(a, b)));
                }
                if (!(first <= last)) continue;
                for (int i = int(first); i <= int(last); ++i) {
                    const int ray = i + RayTile::side * j;
                    const RayTile::Piece* piece = &tile->first[std::size_t(ray)];
                    if (piece->empty() || piece->lo >= high) continue;
                    while (piece->hi <= low && piece->next != RayTile::none)
                        piece = &tile->more[piece->next];
                    if (piece->hi <= low || piece->lo >= high) continue;
                    p[u] = lattice.origin[u] + (i0 + i) * lattice.spacing[u];
                    const Stretch s =
                        stretch_of(p, piece->lo, piece->next == RayTile::none ? piece->hi : infinity);
                    if (s.empty()) continue;
                    const float from = float(s.lo), to = float(s.hi);
                    if (item.cuts) {
                        changed |= tile->remove(ray, from, to);
                        continue;
                    }
                    for (piece = &tile->first[std::size_t(ray)];; piece = &tile->more[piece->next]) {
                        const double a = std::max(from, piece->lo), b = std::min(to, piece->hi);
                        if (b - a > touch.overlap[std::size_t(axis)]) {
                            touch.overlap[std::size_t(axis)] = b - a;
                            touch.place[std::size_t(axis)] = p;
                            touch.place[std::size_t(axis)][axis] += 0.5 * (a + b);
                        }
                        if (piece->next == RayTile::none) break;
                    }
                }
            }
            if (touch.overlap[std::size_t(axis)] > 0) touches[w].push_back(touch);
        }
        if (!changed) return; // what nothing was cut from stays as the solid is, and costs nothing
        tile->find_bounds();
        tile->stamp = RayTile::next_stamp();
        grown[w] = bytes_of(*tile) - before;
        place = std::move(tile);
    });
    for (const std::ptrdiff_t bytes : grown)
        grown_ += bytes;
    if (grown_ > 0 && std::size_t(grown_) > max_bytes_)
        throw Error(ErrorCode::limit_exceeded, "resolution",
                    "the stock has more than " + format_number(double(max_bytes_) / 1e9, 3)
                        + " GB of rays in "
                        + goto_name(programs_[items.front().program], items.front().motion),
                    "use a coarser resolution");

    if (std::any_of(touches.begin(), touches.end(), [](const auto& t) { return !t.empty(); })) {
        std::map<std::tuple<std::size_t, std::size_t, Collision::Kind>, Touch> joined;
        const auto take = [&](const Touch& t) { joined.try_emplace(t.key(), t).first->second.join(t); };
        // A motion may have begun in the batch before.
        while (!touches_.empty() && touches_.back().program == items.front().program
               && touches_.back().motion >= items.front().motion) {
            take(touches_.back());
            touches_.pop_back();
        }
        for (const auto& list : touches)
            for (const Touch& t : list)
                take(t);
        for (const auto& [key, t] : joined)
            touches_.push_back(t);
    }
    items.clear();
}

std::vector<Collision> MaterialRemoval::collisions() const {
    std::vector<Collision> found;
    for (const Touch& t : touches_) {
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
