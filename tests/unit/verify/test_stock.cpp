// The stock: rays, removal, collisions, surface, playback; against shapes with known answers and a plain
// subtraction.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/mesh_report.h"
#include "core/verify/playback.h"
#include "core/verify/removal.h"
#include "core/verify/stock_surface.h"
#include "core/verify/stock_tiles.h"
#include "core/verify/sweep.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <map>
#include <random>

using namespace facetmill;
using facetmill::test::code_of;
using facetmill::test::trials;

namespace {

StockSolid box_stock(const Vec3& lo, const Vec3& hi) {
    StockSolid s;
    s.box.add(lo);
    s.box.add(hi);
    return s;
}

std::shared_ptr<ToolMotions> motions_of(const std::vector<CutterLocation>& at,
                                        MotionKind kind = MotionKind::cut) {
    auto m = std::make_shared<ToolMotions>();
    for (const CutterLocation& l : at)
        m->motions.push_back({m->motions.empty() ? MotionKind::rapid : kind, l});
    return m;
}

VerifyProgram program_of(const AptCutter& cutter, const std::vector<CutterLocation>& at) {
    return {"Test", VerifyTool(cutter), motions_of(at), std::nullopt};
}

CutterLocation upright(double x, double y, double z) {
    return {Vec3(x, y, z), Vec3::UnitZ()};
}

/// Cuts all motions; the collisions found.
std::vector<Collision> cut_all(StockModel& stock, const std::vector<VerifyProgram>& programs,
                               double bound = 0.01, double touch = 1e-3) {
    MaterialRemoval removal(programs, bound, touch);
    for (std::size_t p = 0; p < programs.size(); ++p)
        removal.cut(stock, p, 0, programs[p].motions->motions.size(), 1, true, Progress());
    return removal.collisions();
}

StockModel model(const StockSolid& solid, double resolution) {
    return StockModel(solid, StockLattice::over(solid.box, resolution), Progress());
}

double mesh_volume(const Mesh& m) {
    double v = 0;
    for (std::size_t f = 0; f < m.facet_count(); ++f)
        v += m.corner(f, 0).dot(m.corner(f, 1).cross(m.corner(f, 2))) / 6;
    return v;
}

/// The surface as one mesh, corners welded.
Mesh stock_mesh(const StockModel& stock) {
    std::map<std::array<double, 3>, Index> seen;
    Mesh m;
    stock_triangles(
        stock,
        [&](const Vec3& a, const Vec3& b, const Vec3& c) {
            Facet f;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& p = k == 0 ? a : k == 1 ? b : c;
                const auto [at, fresh] = seen.try_emplace({p.x(), p.y(), p.z()}, Index(m.vertices.size()));
                if (fresh) m.vertices.push_back(p);
                f[k] = at->second;
            }
            m.facets.push_back(f);
        },
        Progress());
    return m;
}

/// Every edge of every facet has one partner that runs the other way.
bool closed(const Mesh& m) {
    std::map<std::pair<Index, Index>, int> edges;
    for (const Facet& f : m.facets)
        for (std::size_t k = 0; k < 3; ++k)
            ++edges[{f[k], f[(k + 1) % 3]}];
    for (const auto& [e, n] : edges) {
        const auto back = edges.find({e.second, e.first});
        if (n != 1 || back == edges.end() || back->second != 1) return false;
    }
    return !edges.empty();
}

std::vector<CutterLocation> wild_path(unsigned seed, int n) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    std::normal_distribution<double> normal;
    std::vector<CutterLocation> at;
    for (int i = 0; i < n; ++i)
        at.push_back({Vec3(40 * share(random), 30 * share(random), 8 + 12 * share(random)),
                      Vec3(0.3 * normal(random), 0.3 * normal(random), 1).normalized()});
    return at;
}

bool same_stock(const StockModel& a, const StockModel& b) {
    for (int axis = 0; axis < 3; ++axis)
        for (int j = 0; j < a.lattice().nodes[std::size_t(second_across(axis))]; ++j)
            for (int i = 0; i < a.lattice().nodes[std::size_t(first_across(axis))]; ++i)
                if (a.stretches(axis, i, j) != b.stretches(axis, i, j)) return false;
    return true;
}

} // namespace

class TestStock : public QObject {
    Q_OBJECT
private slots:
    /// A channel through a block, from and to 20 mm beside it: what it cuts is cut once.
    void motion_in_the_air_is_told() {
        const StockSolid solid = box_stock(Vec3(0, 0, 0), Vec3(20, 20, 10));
        const std::vector<VerifyProgram> programs{
            program_of(AptCutter::ball(8, 20), {upright(-20, 10, 8), upright(40, 10, 8)}),
            program_of(AptCutter::ball(8, 20),
                       {upright(40, 10, 8), upright(-20, 10, 8), upright(-20, 10, 20)})};
        StockModel stock = model(solid, 0.25);
        MaterialRemoval removal(programs, 0.01, 0);
        for (std::size_t p = 0; p < programs.size(); ++p)
            removal.cut(stock, p, 0, programs[p].motions->motions.size(), 1, true, Progress());
        // 20 mm cut something; pieces are no longer than the cutter is wide.
        QVERIFY2(removal.air_length(0) <= 40 && removal.air_length(0) >= 40 - 2 * 8,
                 qPrintable(QString::number(removal.air_length(0))));
        QVERIFY(std::abs(removal.air_length(1) - 72) < 1e-9);
    }

    void rays_lose_what_is_removed() {
        std::mt19937 random(3);
        std::uniform_int_distribution<int> place(0, 200);
        for (int round = 0; round < 200; ++round) {
            RayTile tile;
            std::vector<bool> material(200, false);
            tile.append(5, 0, 200);
            std::fill(material.begin(), material.end(), true);
            for (int n = 0; n < 40; ++n) {
                int a = place(random), b = place(random);
                if (n % 3) b = a + (b - a) / 20;
                if (a > b) std::swap(a, b);
                if (a == b) continue;
                double expect = 0; // of material, between whole numbers
                for (int k = a; k < b; ++k) {
                    if (material[std::size_t(k)]) ++expect;
                    material[std::size_t(k)] = false;
                }
                QCOMPARE(tile.remove(5, float(a), float(b)), expect);
                std::vector<bool> got(200, false);
                const RayTile::Piece* p = &tile.first[5];
                float last = -1;
                while (!p->empty()) {
                    QVERIFY(p->lo > last && p->hi > p->lo);
                    last = p->hi;
                    for (int k = int(p->lo); k < int(p->hi); ++k)
                        got[std::size_t(k)] = true;
                    if (p->next == RayTile::none) break;
                    p = &tile.more[p->next];
                }
                QVERIFY(got == material);
            }
        }
    }

    void whole_stock_has_its_volume() {
        const StockModel box = model(box_stock(Vec3(-3, 2, 0), Vec3(17, 12, 5)), 0.7);
        QVERIFY(std::abs(box.volume() / 1000 - 1) < 0.005);
        const Mesh m = stock_mesh(box);
        QVERIFY(closed(m));
        QVERIFY(std::abs(mesh_volume(m) - 1000) < 0.01);

        StockSolid round = box_stock(Vec3(0, -10, -10), Vec3(50, 10, 10));
        round.kind = StockSolid::Kind::cylinder;
        round.axis = 0;
        round.radius = 10;
        double before = 1;
        for (double resolution : {1.0, 0.5, 0.25}) {
            const StockModel cylinder = model(round, resolution);
            const double off = std::abs(cylinder.volume() / (pi * 100 * 50) - 1);
            QVERIFY(off < 0.03 * resolution);
            QVERIFY(off < before);
            before = off;
            const Mesh surface = stock_mesh(cylinder);
            QVERIFY(closed(surface));
            QVERIFY(std::abs(mesh_volume(surface) / (pi * 100 * 50) - 1) < 0.03 * resolution);
        }
    }

    void mesh_stock_is_what_the_mesh_holds() {
        // An octahedron, whose corners and edges lie on rays.
        auto mesh = std::make_shared<Mesh>();
        mesh->vertices = {{10, 0, 0}, {-10, 0, 0}, {0, 10, 0}, {0, -10, 0}, {0, 0, 10}, {0, 0, -10}};
        mesh->facets = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                        {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
        StockSolid solid = box_stock(Vec3(-10, -10, -10), Vec3(10, 10, 10));
        solid.kind = StockSolid::Kind::mesh;
        solid.mesh = mesh;
        const StockModel stock = model(solid, 0.5);
        QVERIFY(std::abs(stock.volume() / (4000.0 / 3) - 1) < 2e-3);
        const int middle = stock.lattice().nodes[0] / 2;
        const auto s = stock.stretches(2, middle, middle);
        QCOMPARE(s.size(), std::size_t(1));
        QVERIFY(std::abs(s[0][0] + 10) < 1e-5 && std::abs(s[0][1] - 10) < 1e-5);
        QVERIFY(closed(stock_mesh(stock)));

        auto open = std::make_shared<Mesh>(*mesh);
        open->facets.pop_back();
        solid.mesh = open;
        std::string message;
        QCOMPARE(code_of([&] { model(solid, 0.5); }, &message), std::string("out_of_range"));
        QVERIFY(message.find("not closed") != std::string::npos);
    }

    void removal_is_plain_subtraction() {
        for (unsigned seed : {1u, 2u, 3u}) {
            const std::vector<AptCutter> cutters{AptCutter::bull(9, 2, 20), AptCutter::ball(8, 12),
                                                 AptCutter::tapered_ball(2, radians(10), 20)};
            const std::vector<VerifyProgram> programs{
                program_of(cutters[seed % 3], wild_path(seed, trials(12, 3)))};
            StockModel stock = model(box_stock(Vec3(0, 0, 0), Vec3(40, 30, 15)), 1.3);
            const StockModel whole = stock;
            cut_all(stock, programs, 0.2);

            std::vector<StraightMove> moves;
            const TurnedBody body(programs[0].tool.cutter);
            const auto& at = programs[0].motions->motions;
            for (std::size_t i = 1; i < at.size(); ++i)
                straight_moves(at[i - 1].to, at[i].to, std::nullopt, 0, 1, body.reach(), 0.2, moves);
            double removed = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const int u = first_across(axis), v = second_across(axis);
                for (int j = 0; j < stock.lattice().nodes[std::size_t(v)]; ++j)
                    for (int i = 0; i < stock.lattice().nodes[std::size_t(u)]; ++i) {
                        Vec3 p = stock.lattice().origin;
                        p[u] += i * stock.lattice().spacing[u];
                        p[v] += j * stock.lattice().spacing[v];
                        std::vector<std::array<double, 2>> left{whole.stretches(axis, i, j)};
                        for (const StraightMove& move : moves) {
                            Stretch s = SweepRays(body, move, Vec3::Unit(axis))(p);
                            if (s.empty()) continue;
                            s.lo += p[axis];
                            s.hi += p[axis];
                            std::vector<std::array<double, 2>> next;
                            for (const auto& m : left) {
                                if (s.hi <= m[0] || s.lo >= m[1]) {
                                    next.push_back(m);
                                    continue;
                                }
                                if (s.lo > m[0]) next.push_back({m[0], s.lo});
                                if (s.hi < m[1]) next.push_back({s.hi, m[1]});
                            }
                            left = std::move(next);
                        }
                        // Slivers of rounding apart, the same.
                        const auto got = stock.stretches(axis, i, j);
                        double a = 0, b = 0;
                        for (const auto& m : got)
                            a += m[1] - m[0];
                        for (const auto& m : left)
                            b += m[1] - m[0];
                        QVERIFY2(
                            std::abs(a - b) < 1e-4,
                            qPrintable(QString("%1 %2 %3: %4 %5").arg(axis).arg(i).arg(j).arg(a).arg(b)));
                        removed += 30 - b;
                    }
            }
            QVERIFY(removed > 100);
            QVERIFY(closed(stock_mesh(stock)));
            QVERIFY(std::abs(mesh_volume(stock_mesh(stock)) / stock.volume() - 1) < 0.03);
        }
    }

    void threads_do_not_matter() {
        const std::vector<VerifyProgram> programs{
            program_of(AptCutter::bull(9, 2, 20), wild_path(9, trials(40, 5)))};
        const auto run = [&](int threads) {
            set_thread_count(threads);
            StockModel stock = model(box_stock(Vec3(0, 0, 0), Vec3(40, 30, 15)), 0.8);
            auto hits = cut_all(stock, programs, 0.05);
            set_thread_count(0);
            return std::pair(std::move(stock), std::move(hits));
        };
        const auto one = run(1), two = run(2);
        QVERIFY(same_stock(one.first, two.first));
        QCOMPARE(one.second.size(), two.second.size());
        for (std::size_t i = 0; i < one.second.size(); ++i)
            QVERIFY(one.second[i].depth == two.second[i].depth && one.second[i].place == two.second[i].place);
    }

    void a_plunge_removes_the_cutter() {
        // A ball of radius 4 down to 6 below the top of the stock.
        double before = 1;
        for (double resolution : {1.0, 0.5, 0.25}) {
            StockModel stock = model(box_stock(Vec3(-10, -10, 0), Vec3(10, 10, 10)), resolution);
            const double whole = stock.volume();
            cut_all(stock,
                    {program_of(AptCutter::ball(8, 30), {upright(0.1, 0.2, 20), upright(0.1, 0.2, 4)})});
            const double expect = pi * 16 * 2 + 2.0 / 3 * pi * 64;
            const double off = std::abs((whole - stock.volume()) / expect - 1);
            QVERIFY2(off < 0.04 * resolution, qPrintable(QString::number(off)));
            QVERIFY(off < before);
            before = off;
        }
    }

    void what_must_not_touch_is_found() {
        Tool tool;
        tool.diameter = 10;
        tool.flute_length = 20;
        tool.shank_diameter = 10;
        tool.shank_length = 20;
        tool.holder = {{30, 40}};
        const StockSolid solid = box_stock(Vec3(0, 0, 0), Vec3(100, 60, 50));
        const auto run = [&](const std::vector<CutterLocation>& at, MotionKind kind) {
            std::vector<VerifyProgram> programs{
                {"Test", VerifyTool(tool), motions_of(at, kind), std::nullopt}};
            StockModel stock = model(solid, 1.0);
            return cut_all(stock, programs);
        };
        // A slot at z = 35 from outside: flutes reach to 55, nothing else touches.
        QVERIFY(run({upright(-20, 30, 35), upright(50, 30, 35)}, MotionKind::cut).empty());
        // At z = 25 the shank (from 45) follows the flutes in the slot but drags through 5 mm of stock ahead
        // of them.
        const auto shank = run({upright(-20, 30, 25), upright(50, 30, 25)}, MotionKind::cut);
        QCOMPARE(shank.size(), std::size_t(1));
        QVERIFY(shank[0].kind == Collision::Kind::shank);
        QCOMPARE(shank[0].at, (MotionPlace{0, 1}));
        QVERIFY(std::abs(shank[0].depth - 5) < 0.01);
        QVERIFY(shank[0].place.z() > 45 && shank[0].place.z() < 50);
        // A hole 45 deep: the shank has the flutes' own diameter and slides; the holder (from 45) stops at z
        // = 50.
        QVERIFY(run({upright(50, 30, 60), upright(50, 30, 10)}, MotionKind::cut).empty());
        const auto holder = run({upright(50, 30, 60), upright(50, 30, 7)}, MotionKind::cut);
        QCOMPARE(holder.size(), std::size_t(1));
        QVERIFY(holder[0].kind == Collision::Kind::holder);
        QVERIFY(std::abs(holder[0].depth - 3) < 0.01);
        // A rapid 2 mm below the top, and one over what a cut has opened.
        const auto rapid = run({upright(-20, 30, 48), upright(120, 30, 48)}, MotionKind::rapid);
        QCOMPARE(rapid.size(), std::size_t(1));
        QVERIFY(rapid[0].kind == Collision::Kind::rapid);
        QVERIFY(std::abs(rapid[0].depth - 2) < 0.05);
        auto back = motions_of({upright(-20, 30, 40), upright(120, 30, 40)});
        back->motions.push_back({MotionKind::rapid, upright(-20, 30, 40)});
        const std::vector<VerifyProgram> programs{{"Test", VerifyTool(tool), back, std::nullopt}};
        StockModel stock = model(solid, 1.0);
        QVERIFY(cut_all(stock, programs).empty());
        back->motions.push_back({MotionKind::rapid, upright(120, 30, 39.5)});
        StockModel again = model(solid, 1.0);
        const auto dips = cut_all(again, programs);
        QCOMPARE(dips.size(), std::size_t(1));
        QCOMPARE(dips[0].at.motion, std::size_t(3));
    }

    void programs_are_checked() {
        std::string message;
        auto bad = program_of(AptCutter::ball(8, 30), {upright(0, 0, 5), upright(std::nan(""), 0, 4)});
        QCOMPARE(code_of([&] { check_programs(std::vector<VerifyProgram>{bad}); }, &message),
                 std::string("non_finite"));
        QVERIFY(message.find("GOTO 2") != std::string::npos);
        bad = program_of(AptCutter::ball(8, 30), {upright(0, 0, 5), {Vec3(1, 0, 0), -Vec3::UnitZ()}});
        QCOMPARE(code_of([&] { check_programs(std::vector<VerifyProgram>{bad}); }),
                 std::string("out_of_range"));
        bad = program_of(AptCutter::ball(8, 30), {{Vec3(1, 0, 0), Vec3(0, 0, 2)}});
        QCOMPARE(code_of([&] { check_programs(std::vector<VerifyProgram>{bad}); }),
                 std::string("out_of_range"));
        bad = program_of(AptCutter::ball(8, 30), {});
        QCOMPARE(code_of([&] { check_programs(std::vector<VerifyProgram>{bad}); }),
                 std::string("empty_result"));
        QCOMPARE(code_of([&] { StockLattice::over(box_stock(Vec3::Zero(), Vec3::Ones()).box, 1e-5); }),
                 std::string("limit_exceeded"));
    }

    /// Rays cost memory only where something is cut, and about what they will cost is known before.
    void only_what_is_cut_costs_memory() {
        const StockSolid solid = box_stock(Vec3(0, 0, 0), Vec3(100, 100, 40));
        const AptCutter ball = AptCutter::ball(4, 20);
        // A slot straight across, 1 deep, and rapids all over it that touch nothing.
        const std::vector<VerifyProgram> slot{
            program_of(ball, {upright(-5, 50, 39), upright(105, 50, 39)}),
            {"Air", VerifyTool(ball),
             motions_of({upright(0, 0, 40.5), upright(100, 100, 40.5), upright(0, 100, 40.5)},
                        MotionKind::rapid),
             std::nullopt}};
        StockModel stock = model(solid, 0.2);
        const std::size_t empty = stock.bytes();
        const std::size_t all = stock.lattice().rays() * sizeof(RayTile::Piece);
        const MaterialRemoval removal(slot, 0.01, 1e-3);
        const std::size_t needed = removal.bytes_needed(stock, Progress());
        QVERIFY(cut_all(stock, slot).empty());
        const std::size_t made = stock.bytes() - empty;
        QVERIFY2(made > 0 && made <= 2 * needed, qPrintable(QString("%1 %2").arg(made).arg(needed)));
        QVERIFY2(needed < all / 8, qPrintable(QString("%1 %2").arg(needed).arg(all)));
        // A diagonal slot is no more, though its box is the whole stock.
        const std::vector<VerifyProgram> diagonal{
            program_of(ball, {upright(0, 0, 39), upright(100, 100, 39)})};
        StockModel other = model(solid, 0.2);
        const std::size_t diagonally = MaterialRemoval(diagonal, 0.01, 1e-3).bytes_needed(other, Progress());
        cut_all(other, diagonal);
        QVERIFY(other.bytes() - empty <= 2 * diagonally && diagonally < all / 5);
        // Cutting stops where a limit is passed, rather than the machine running out of memory.
        StockModel third = model(solid, 0.2);
        MaterialRemoval limited(slot, 0.01, 1e-3, made / 2);
        QCOMPARE(code_of([&] { limited.cut(third, 0, 0, 2, 1, true, Progress()); }),
                 std::string("limit_exceeded"));
        StockModel fourth = model(solid, 0.2);
        MaterialRemoval just(slot, 0.01, 1e-3, made);
        QCOMPARE(code_of([&] { just.cut(fourth, 0, 0, 2, 1, true, Progress()); }), std::string("none"));
    }

    /// Flat sheets come in few triangles that fit those beside them.
    void a_flat_surface_takes_few_triangles() {
        const StockSolid solid = box_stock(Vec3(0, 0, 0), Vec3(60, 50, 20));
        StockModel stock = model(solid, 0.25);
        cut_all(stock, {program_of(AptCutter::ball(8, 20), {upright(20, -5, 17), upright(30, 20, 15)})});
        std::size_t plain = 0;
        const StockSurface surface(stock.lattice());
        for (std::size_t k = 0; k < surface.patch_count(); ++k)
            if (const auto patch = surface.patch(stock, k)) plain += patch->triangles.size();
        const Mesh m = stock_mesh(stock);
        QVERIFY(closed(m));
        QVERIFY2(m.facet_count() < plain / 2,
                 qPrintable(QString("%1 of %2").arg(m.facet_count()).arg(plain)));
        QVERIFY(std::abs(mesh_volume(m) / stock.volume() - 1) < 1e-3);
        // The same area, face by face: nothing is laid over anything.
        double area = 0;
        for (std::size_t f = 0; f < m.facet_count(); ++f)
            if (m.facet_normal(f).z() < -0.999999) area += 0.5 * m.facet_cross(f).norm();
        QVERIFY2(std::abs(area / 3000 - 1) < 1e-3, qPrintable(QString::number(area)));
        // Normals look where the triangles do, and a sheet's are the same all over.
        std::size_t sheets = 0;
        for (std::size_t k = 0; k < surface.patch_count(); ++k) {
            const auto whole = surface.patch(stock, k), patch = sparse_patch(whole);
            if (patch == whole) continue;
            ++sheets;
            QVERIFY(patch->triangles.size() < whole->triangles.size());
            const auto at = [](const std::array<float, 3>& a) { return Vec3(a[0], a[1], a[2]); };
            for (const auto& t : patch->triangles) {
                const Vec3 a = at(patch->points[t[0]]),
                           cross = (at(patch->points[t[1]]) - a).cross(at(patch->points[t[2]]) - a);
                for (const std::uint32_t corner : t)
                    QVERIFY((cross.normalized() - at(patch->normals[corner])).norm() < 1e-6);
            }
        }
        QVERIFY(sheets > 10);
        QVERIFY(!sparse_patch(nullptr));
    }

    void groups_are_their_patches() {
        using Patches = std::vector<std::shared_ptr<const StockPatch>>;
        const StockSolid solid = box_stock(Vec3(0, 0, 0), Vec3(60, 50, 20));
        StockPlayback playback(solid, {program_of(AptCutter::ball(5, 20), wild_path(5, 60))}, 0.4,
                               Progress());
        constexpr std::size_t most = 2500;
        PatchGroups groups(most);
        // Area, as a sum that every corner is in.
        const auto sum = [](const Patches& patches, std::size_t& triangles) {
            double area = 0;
            triangles = 0;
            for (const auto& p : patches) {
                if (!p) continue;
                triangles += p->triangles.size();
                const auto at = [&](std::uint32_t i) {
                    return Vec3(p->points[i][0], p->points[i][1], p->points[i][2]);
                };
                for (const auto& [a, b, c] : p->triangles) {
                    area += (at(b) - at(a)).cross(at(c) - at(a)).norm();
                    for (const std::uint32_t i : {a, b, c}) {
                        if (p->normals.size() != p->points.size()
                            || ((p->box.lo - at(i)).array() > 1e-5).any()
                            || ((at(i) - p->box.hi).array() > 1e-5).any())
                            return -1.0;
                        area += 1e-3 * std::abs(p->normals[i][2]);
                    }
                }
            }
            return area;
        };
        Patches grouped;
        std::size_t kept = 0, others = 0;
        for (const double position : {0.0, 1.0, 2.0, 2.5, 30.0, 31.0, 60.0, 4.0}) {
            playback.go_to(position, Progress());
            const Patches patches = playback.patches(Progress());
            const Patches now = groups.of(patches);
            QVERIFY(groups.of(patches) == now); // the same objects
            std::size_t triangles = 0, in_groups = 0;
            const double area = sum(patches, triangles);
            QVERIFY(triangles > 0 && std::abs(sum(now, in_groups) / area - 1) < 1e-9);
            QCOMPARE(in_groups, triangles);
            QVERIFY2(now.size() <= 2 + 2 * triangles / most, qPrintable(QString::number(now.size())));
            const auto count =
                std::count_if(patches.begin(), patches.end(), [](const auto& p) { return bool(p); });
            QVERIFY(now.size() < std::size_t(count));
            if (now.size() == grouped.size())
                for (std::size_t g = 0; g < now.size(); ++g)
                    ++(now[g] == grouped[g] ? kept : others);
            grouped = now;
        }
        QVERIFY2(kept > 4 && others > 4, qPrintable(QString("%1 kept, %2 others").arg(kept).arg(others)));
        QVERIFY(PatchGroups(10).of({}).empty());
    }

    void playback_goes_both_ways() {
        std::vector<VerifyProgram> programs{program_of(AptCutter::bull(9, 2, 20), wild_path(4, 150)),
                                            program_of(AptCutter::ball(5, 20), wild_path(5, 60))};
        const StockSolid solid = box_stock(Vec3(0, 0, 0), Vec3(40, 30, 15));
        StockPlayback playback(solid, programs, 1.1, Progress());
        QCOMPARE(playback.motion_count(), std::size_t(210));
        QCOMPARE(playback.place(149.5), (MotionPlace{0, 149}));
        QCOMPARE(playback.place(150), (MotionPlace{1, 0}));
        QCOMPARE(playback.place(210), (MotionPlace{1, 59}));
        QCOMPARE(playback.first_motion(1), std::size_t(150));
        for (double position : {40.0, 170.5, 12.25, 12.75, 210.0, 0.0, 99.0, 151.0}) {
            playback.go_to(position, Progress());
            QCOMPARE(playback.position(), position);
            StockPlayback fresh(solid, programs, 1.1, Progress());
            fresh.go_to(position, Progress());
            QVERIFY(same_stock(playback.stock(), fresh.stock()));
            // Patches say the same as those made from nothing.
            const auto& a = playback.patches(Progress());
            const auto& b = fresh.patches(Progress());
            QCOMPARE(a.size(), b.size());
            for (std::size_t k = 0; k < a.size(); ++k) {
                QCOMPARE(a[k] != nullptr, b[k] != nullptr);
                if (a[k]) QVERIFY(a[k]->points == b[k]->points && a[k]->triangles == b[k]->triangles);
            }
        }
        const auto location = playback.location(30.5);
        const auto& m = programs[0].motions->motions;
        QVERIFY((location.tip - 0.5 * (m[29].to.tip + m[30].to.tip)).norm() < 1e-12);
        const auto before = playback.patches(Progress());
        QVERIFY(before == playback.patches(Progress()));

        // A cancelled call leaves a whole state.
        Job job;
        job.cancel();
        QVERIFY_EXCEPTION_THROWN(playback.go_to(205, Progress(job)), Cancelled);
        playback.go_to(160, Progress());
        StockPlayback fresh(solid, programs, 1.1, Progress());
        fresh.go_to(160, Progress());
        QVERIFY(same_stock(playback.stock(), fresh.stock()));
    }

    /// A flat end of radius 3 from beside a block straight into it, 5 deep: at every position it is where its
    /// share of the motion says, and all that it has passed is gone.
    void playback_stops_within_a_motion() {
        const StockSolid solid = box_stock(Vec3(0, 0, 0), Vec3(40, 20, 10));
        StockPlayback playback(solid,
                               {program_of(AptCutter::flat(6, 20),
                                           {upright(-3, 10, 5), upright(12, 10, 5), upright(27, 10, 5)})},
                               0.5, Progress());
        const StockLattice& lattice = playback.stock().lattice();
        const auto along_x = [&](double y, double z) {
            return playback.stock().stretches(
                0, int(std::lround((y - lattice.origin.y()) / lattice.spacing.y())),
                int(std::lround((z - lattice.origin.z()) / lattice.spacing.z())));
        };
        // Forward, back, and within a motion that is cut by half already.
        for (const double position : {1.25, 1.75, 2.25, 2.75, 2.125, 1.0, 3.0}) {
            playback.go_to(position, Progress());
            const double tip = 15 * (position - 1) - 3;
            QVERIFY((playback.location(position).tip - Vec3(tip, 10, 5)).norm() < 1e-12);
            const auto cut = along_x(10, 8), below = along_x(10, 4);
            QCOMPARE(cut.size(), std::size_t(1));
            QVERIFY2(std::abs(cut[0][0] - (tip + 3)) < 1e-4 && std::abs(cut[0][1] - 40) < 1e-4,
                     qPrintable(QString("%1: %2 to %3").arg(position).arg(cut[0][0]).arg(cut[0][1])));
            QVERIFY(below.size() == 1 && std::abs(below[0][0]) < 1e-4);
        }
    }

    void the_surface_is_closed_however_torn() {
        // Thin walls and stretches that touch at corners only, in every constellation.
        std::mt19937 random(11);
        std::uniform_real_distribution<double> share(0, 1);
        std::vector<CutterLocation> at;
        std::vector<VerifyProgram> programs;
        for (int n = 0; n < 300; ++n) {
            const Vec3 tip(12 * share(random), 12 * share(random), 12 * share(random));
            auto m = motions_of({upright(tip.x(), tip.y(), tip.z()), upright(tip.x(), tip.y(), tip.z())});
            programs.push_back({"Test", VerifyTool(AptCutter::ball(1.6, 1.6)), m, std::nullopt});
        }
        StockModel stock = model(box_stock(Vec3(0, 0, 0), Vec3(12, 12, 12)), 0.75);
        cut_all(stock, programs);
        const Mesh m = stock_mesh(stock);
        QVERIFY(m.facet_count() > 2000);
        QVERIFY(closed(m));
        const double volume = mesh_volume(m);
        QVERIFY(volume > 0.6 * stock.volume() && volume < 1.4 * stock.volume());
    }
};

FACETMILL_TEST(TestStock)
#include "test_stock.moc"
