// Axial lifts against the brute-force reference: single facets of every degenerate family, and whole meshes
// through the index.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/axial_lift.h"
#include "core/gouge/contact_blocks.h"
#include "core/gouge/facet_duties.h"
#include "core/gouge/vertex_slopes.h"
#include "tests/support/brute_lift.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/gouge/lift_cases.h"
#include "tests/unit/gouge/lift_check.h"

#include <QTest>

#include <cstring>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// What whole meshes must reach, over coordinates up to 100 mm.
constexpr double mesh_accuracy = 1e-7;

/// A closed ball of facets, seen from above half of it inside out; long fans at the poles.
std::shared_ptr<Mesh> globe(double radius, int n) {
    const auto mesh = std::make_shared<Mesh>();
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i < n; ++i) {
            const double u = pi * j / n, v = 2 * pi * i / n;
            mesh->vertices.push_back(
                radius * Vec3(1 + std::sin(u) * std::cos(v), 1 + std::sin(u) * std::sin(v), std::cos(u)));
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const auto at = [&](int row, int column) { return Index(row * n + column % n); };
            mesh->facets.push_back({at(j, i), at(j + 1, i), at(j + 1, i + 1)});
            mesh->facets.push_back({at(j, i), at(j + 1, i + 1), at(j, i + 1)});
        }
    return mesh;
}

struct NamedMesh {
    const char* name;
    std::shared_ptr<Mesh> mesh;
    double size;
};

std::vector<NamedMesh> meshes() {
    Random rng(5);
    const auto waves = [](double x, double y) {
        return 4 * std::sin(0.31 * x) * std::cos(0.27 * y) + 0.05 * x;
    };
    const auto rough = [&rng](double, double) { return uniform(rng, -2, 2); };
    const auto terraces = [](double x, double y) {
        return std::floor(0.25 * x + 0.125 * y) + 0.5 * std::floor(0.2 * y);
    };
    const auto groove = [](double x, double y) { return 0.8 * std::abs(x - 30) + 0.3 * std::abs(y - 25); };
    const auto ridge = [](double x, double y) { return -0.8 * std::abs(x - 30) - 0.3 * std::abs(y - 25); };
    std::vector<NamedMesh> all{
        {"waves", field(30, 60, waves, 0.3, 1), 60},
        {"rough", field(30, 60, rough, 0.3, 2), 60},
        {"terraces", field(30, 60, terraces, 0, 3), 60},
        {"groove", field(24, 60, groove, 0, 4), 60},
        {"ridge", field(24, 60, ridge, 0.2, 5), 60},
        {"walls",
         field(
             20, 60,
             [&](double x, double y) { return std::fmod(std::floor(x / 9) + std::floor(y / 9), 2) * 12; },
             0.1, 6),
         60},
        {"soup", soup(500, 60, 7), 60},
        {"globe", globe(30, 24), 60},
        {"needles", needles_askew(240, 60, 5), 60},
    };
    // Three facets on an edge, a doubled facet, facets turned over, a sheet folded back over itself.
    auto folded = field(12, 60, waves, 0.2, 8);
    const std::size_t sheet = folded->facets.size();
    for (std::size_t f = 0; f < sheet; f += 3) {
        Facet t = folded->facets[f];
        std::swap(t[0], t[1]);
        folded->facets[f] = t;
        if (f % 2) folded->facets.push_back(t);
        folded->vertices.push_back(folded->vertices[t[2]]
                                   + Vec3(uniform(rng, -9, 9), uniform(rng, -9, 9), uniform(rng, -9, 9)));
        folded->facets.push_back({t[0], t[1], Index(folded->vertices.size() - 1)});
        folded->facets.push_back({t[1], t[1], t[2]});
    }
    all.push_back({"folded", folded, 60});
    return all;
}

std::vector<AptCutter> cutters() {
    std::vector<AptCutter> all;
    Random rng(17);
    for (int kind = 0; kind < 14; ++kind)
        all.push_back(random_cutter(rng, kind, kind % 2 ? 6 : 11));
    return all;
}

double distance_to_facet(const Mesh& mesh, Index facet, const Vec3& p) {
    const Vec3 a = mesh.corner(facet, 0), u = mesh.corner(facet, 1) - a, v = mesh.corner(facet, 2) - a;
    const auto to_segment = [&](const Vec3& from, const Vec3& d) {
        const double t =
            d.squaredNorm() > 0 ? std::clamp((p - from).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
        return (p - from - t * d).norm();
    };
    double best = std::min({to_segment(a, u), to_segment(a, v), to_segment(a + u, v - u)});
    const Vec3 n = u.cross(v);
    if (n.squaredNorm() > 0) {
        const Vec3 w = p - a;
        const double s = w.cross(v).dot(n) / n.squaredNorm(), t = u.cross(w).dot(n) / n.squaredNorm();
        if (s >= 0 && t >= 0 && s + t <= 1) best = std::min(best, std::abs(w.dot(n)) / n.norm());
    }
    return best;
}

std::vector<Vec2> grid_points(Random& rng, double size, int n) {
    std::vector<Vec2> points;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            points.push_back(Vec2(size * (1.2 * (i + uniform(rng, 0, 1)) / n - 0.1),
                                  size * (1.2 * (j + uniform(rng, 0, 1)) / n - 0.1)));
    // and places where mesh lines coincide with the axis
    for (int i = 0; i < n; ++i)
        points.push_back(Vec2(2.0 * i, 2.0 * (i % 5)));
    return points;
}

} // namespace

class TestAxialLift : public QObject {
    Q_OBJECT
private slots:

    void single_facets() {
        const LiftCheck check = check_lift_cases(0, trials(100'000));
        QVERIFY2(check.first_failure.isEmpty(), qPrintable(check.first_failure));
        QVERIFY(check.touched > trials(80'000u));
        QVERIFY2(check.borderline < trials(200u), qPrintable(QString::number(check.borderline)));
    }

    // Edges on the torus, where the contact is found by Newton's steps: corner radii from thin to nearly a
    // ball, slopes from nearly level to nearly vertical, distances around the centre circle.
    void torus_edges() {
        Random rng(3);
        for (int i = 0; i < trials(100000); ++i) {
            const double r = 5 * std::pow(10.0, uniform(rng, -6, -1e-4));
            const AptCutter apt = AptCutter::bull(10, r, 50);
            const double slope = std::pow(10.0, uniform(rng, -9, 3));
            double l = uniform(rng, 0, 5);
            if (i % 3 == 0)
                l = std::min(5.0, apt.e * (1 + std::pow(10.0, uniform(rng, -12, -1)) * uniform(rng, -1, 1)));
            const double turn = uniform(rng, 0, 2 * pi), half = uniform(rng, 5, 12);
            const auto rotated = [&](double s) {
                return Vec3(l * std::cos(turn) - s * std::sin(turn), l * std::sin(turn) + s * std::cos(turn),
                            slope * s);
            };
            const auto mesh = std::make_shared<Mesh>();
            mesh->vertices = {rotated(-half), rotated(half)};
            mesh->facets = {{0, 1, 1}};
            const AxialLift lift(std::make_shared<ContactIndex>(mesh, Progress()), CutterProfile(apt));
            const double wanted = brute_lift(BruteCutter(apt), *mesh, 0, 0), got = lift.tip_z(0, 0);
            if (std::abs(l - 5) < 1e-9) continue; // whether the rim is reached at all hangs on the last digit
            // The steepest edges turn the rounding of the corners into 1e3 times as much in height.
            const double allowed = tolerance::lift_accuracy;
            QVERIFY2(std::abs(got - wanted) <= allowed,
                     qPrintable(QString("%1: r %2 slope %3 l %4: %5 against %6")
                                    .arg(i)
                                    .arg(r)
                                    .arg(slope)
                                    .arg(l, 0, 'g', 17)
                                    .arg(got, 0, 'g', 17)
                                    .arg(wanted, 0, 'g', 17)));
        }
    }

    void whole_meshes() {
        for (const NamedMesh& named : meshes()) {
            const auto index = std::make_shared<ContactIndex>(named.mesh, Progress());
            const std::vector<AptCutter> all = cutters();
            std::vector<QString> failures(all.size());
            parallel_for(all.size(), 1, Progress(), [&](std::size_t c) {
                Random rng(100 + c);
                const AxialLift lift(index, CutterProfile(all[c]));
                const BruteCutter brute(all[c]);
                for (const Vec2& p : grid_points(rng, named.size, trials(9, 3))) {
                    const double got = lift.tip_z(p.x(), p.y()),
                                 wanted = brute_lift(brute, *named.mesh, p.x(), p.y());
                    if (got == wanted || std::abs(got - wanted) <= mesh_accuracy) continue;
                    failures[c] = QString("%1, cutter %2 at (%3, %4): %5, the reference says %6")
                                      .arg(named.name)
                                      .arg(c)
                                      .arg(p.x(), 0, 'g', 17)
                                      .arg(p.y(), 0, 'g', 17)
                                      .arg(got, 0, 'g', 17)
                                      .arg(wanted, 0, 'g', 17);
                    return;
                }
            });
            for (const QString& failure : failures)
                QVERIFY2(failure.isEmpty(), qPrintable(failure));
        }
    }

    void contact_is_on_part_and_cutter() {
        for (const NamedMesh& named : meshes()) {
            const auto index = std::make_shared<ContactIndex>(named.mesh, Progress());
            int features[4] = {};
            for (const AptCutter& cutter : cutters()) {
                Random rng(9);
                const AxialLift lift(index, CutterProfile(cutter));
                const std::vector<Vec2> places = grid_points(rng, named.size, trials(12, 2));
                // One by one, and after them all together.
                std::vector<AxialContact> contacts(2 * places.size());
                for (std::size_t i = 0; i < places.size(); ++i)
                    contacts[i] = lift.contact(places[i].x(), places[i].y());
                lift.contact(places, std::span(contacts).subspan(places.size()), Progress());
                for (std::size_t i = 0; i < contacts.size(); ++i) {
                    const AxialContact& contact = contacts[i];
                    const Vec2& p = places[i % places.size()];
                    QCOMPARE(contact.tip_z, lift.tip_z(p.x(), p.y()));
                    ++features[int(contact.feature)];
                    if (contact.feature == AxialContact::Feature::none) {
                        QCOMPARE(contact.tip_z, -infinity);
                        QCOMPARE(contact.facet, no_index);
                        continue;
                    }
                    QVERIFY(contact.facet < named.mesh->facet_count());
                    const double off_part = distance_to_facet(*named.mesh, contact.facet, contact.point);
                    QVERIFY2(off_part <= mesh_accuracy, qPrintable(QString::number(off_part)));
                    const double rho = (contact.point.head<2>() - p).norm();
                    const CutterProfile& profile = lift.profile();
                    QVERIFY(rho <= profile.max_radius() * (1 + 1e-12));
                    const double surface = profile.height_at(std::min(rho, profile.max_radius()));
                    // Near a vertical side a height says little: the distance is that from the profile's
                    // curve.
                    const double below = contact.point.z() - contact.tip_z - surface;
                    const double beside = profile.radius_at(contact.point.z() - contact.tip_z) - rho;
                    QVERIFY2(std::min(std::abs(below), std::abs(beside)) <= mesh_accuracy,
                             qPrintable(QString("%1 %2").arg(below).arg(beside)));
                }
            }
            QVERIFY(features[1] + features[2] + features[3] > 100);
            if (std::strcmp(named.name, "waves") == 0)
                QVERIFY(features[0] && features[1] && features[2] && features[3]);
        }
    }

    /// Many facets touch a flat end on a level floor: whoever tells them from higher ones must not lose one
    /// that is hardly higher.
    void a_flat_end_finds_what_stands_hardly_higher_on_a_floor() {
        Random rng(5);
        for (int trial = 0; trial < 40; ++trial) {
            auto mesh = field(
                40, 80, [](double, double) { return 7.3; }, 0.3, std::uint64_t(trial + 1));
            Vec3& higher = mesh->vertices[std::size_t(whole(rng, 0, int(mesh->vertices.size()) - 1))];
            higher.z() += std::pow(10, -double(trial % 12) - 1);
            const AxialLift lift(std::make_shared<ContactIndex>(mesh, Progress()),
                                 CutterProfile(AptCutter::flat(60, 50)));
            std::vector<Vec2> places;
            for (int i = 0; i < 200; ++i)
                places.push_back(higher.head<2>() + Vec2(uniform(rng, -40, 40), uniform(rng, -40, 40)));
            std::vector<double> heights(places.size());
            lift.tip_z(places, heights, Progress());
            for (std::size_t i = 0; i < places.size(); ++i) {
                const double away = (places[i] - higher.head<2>()).norm();
                QCOMPARE(lift.tip_z(places[i].x(), places[i].y()), heights[i]);
                if (away < 29.9) QCOMPARE(heights[i], higher.z());
            }
        }
    }

    /// Bounds over needles are as fine as these are thin: far from the origin, sloping along, some among
    /// others.
    void thin_needles() {
        const auto askew = needles_askew(3000, 100);
        Random rng(9);
        for (const double slope : {0.0, 0.4, 2.5}) {
            Mesh mesh = *askew;
            for (Vec3& p : mesh.vertices)
                p = Vec3(p.x() + 700, p.y() - 1200, p.z() + slope * (0.8 * p.x() + 0.6 * p.y()) - 300);
            const auto index = std::make_shared<ContactIndex>(std::make_shared<const Mesh>(mesh), Progress());
            for (const AptCutter& cutter :
                 {AptCutter::ball(6, 20), AptCutter::flat(5, 20), random_cutter(rng, 5, 4)}) {
                const AxialLift lift(index, CutterProfile(cutter));
                const BruteCutter brute(cutter);
                for (int i = 0; i < trials(12, 3); ++i) {
                    const double x = 750 + uniform(rng, -60, 60), y = -1150 + uniform(rng, -60, 60);
                    const double got = lift.tip_z(x, y), wanted = brute_lift(brute, mesh, x, y);
                    QVERIFY2(
                        got == wanted || std::abs(got - wanted) <= mesh_accuracy,
                        qPrintable(QString("%1, %2: %3 for %4").arg(x).arg(y).arg(got - wanted).arg(slope)));
                }
            }
        }
    }

    /// Whichever of its edges says so, a corner that stands highest is what is touched.
    void a_highest_corner_is_a_vertex() {
        for (std::size_t highest = 0; highest < 3; ++highest) {
            Mesh mesh;
            mesh.vertices = {Vec3(0, 0, 0), Vec3(12, 0, 0), Vec3(0, 10, 0)};
            mesh.facets = {{0, 1, 2}};
            mesh.vertices[highest].z() = 5;
            const Vec3 corner = mesh.vertices[highest];
            const auto index =
                std::make_shared<ContactIndex>(std::make_shared<const Mesh>(std::move(mesh)), Progress());
            // A point would touch the plane there as well.
            for (const AptCutter& cutter : {AptCutter::flat(6, 20), AptCutter::ball(6, 20)}) {
                const AxialContact c =
                    AxialLift(index, CutterProfile(cutter)).contact(corner.x(), corner.y());
                QCOMPARE(c.feature, AxialContact::Feature::vertex);
                QVERIFY((c.point - corner).norm() == 0);
            }
        }
    }

    void batches_and_threads_give_the_same_bits() {
        const auto all = meshes();
        for (const NamedMesh& named : all) {
            const auto index = std::make_shared<ContactIndex>(named.mesh, Progress());
            for (const AptCutter& cutter : cutters()) {
                Random rng(4);
                const AxialLift lift(index, CutterProfile(cutter), 0.3);
                std::vector<Vec2> points = grid_points(rng, named.size, trials(60, 2));
                std::vector<double> heights(points.size()), other(points.size());
                lift.tip_z(points, heights, Progress());
                set_thread_count(1);
                lift.tip_z(points, other, Progress());
                set_thread_count(0);
                QVERIFY(std::memcmp(heights.data(), other.data(), sizeof(double) * heights.size()) == 0);
                for (std::size_t i = 0; i < points.size(); ++i) {
                    const double one = lift.tip_z(points[i].x(), points[i].y());
                    QVERIFY(std::memcmp(&one, &heights[i], sizeof one) == 0);
                }
                // Another order, in small batches.
                for (std::size_t i = 0; i < points.size(); i += 7) {
                    const std::size_t n = std::min<std::size_t>(7, points.size() - i);
                    std::reverse(points.begin() + long(i), points.begin() + long(i + n));
                    lift.tip_z(std::span(points).subspan(i, n), std::span(other).subspan(i, n), Progress());
                    std::reverse(other.begin() + long(i), other.begin() + long(i + n));
                }
                QVERIFY(std::memcmp(heights.data(), other.data(), sizeof(double) * heights.size()) == 0);
            }
        }
    }

    /// What is asked only above a height, or whether it is above one, is what the height itself says.
    void heights_above_another_are_the_same() {
        const auto all = meshes();
        for (const NamedMesh& named : all) {
            const auto index = std::make_shared<ContactIndex>(named.mesh, Progress());
            for (const AptCutter& cutter : cutters())
                for (const double allowance : {0.0, 0.7}) {
                    Random rng(8);
                    const AxialLift lift(index, CutterProfile(cutter), allowance);
                    LiftHint hint;
                    for (const Vec2& p : grid_points(rng, named.size, trials(20, 2))) {
                        const double tip = lift.tip_z(p.x(), p.y());
                        if (tip == -infinity) {
                            QVERIFY(!lift.is_above(p.x(), p.y(), -1e6, hint));
                            QCOMPARE(lift.tip_z(p.x(), p.y(), hint, -1e6), -1e6);
                            continue;
                        }
                        for (const double by : {1e-7, -1e-7, 0.1, -0.1, 5.0, -5.0, 1000.0, -1000.0}) {
                            QCOMPARE(lift.is_above(p.x(), p.y(), tip + by, hint), by < 0);
                            const double is = lift.tip_z(p.x(), p.y(), hint, tip + by);
                            QVERIFY(std::abs(is - std::max(tip, tip + by)) < 1e-11);
                        }
                        QVERIFY(lift.is_above(p.x(), p.y(), -infinity, hint));
                        QVERIFY(!lift.is_above(p.x(), p.y(), infinity, hint));
                        QCOMPARE(lift.tip_z(p.x(), p.y(), hint, -infinity), tip);
                    }
                }
        }
        const double nowhere = std::numeric_limits<double>::quiet_NaN();
        const AxialLift lift(std::make_shared<ContactIndex>(all[0].mesh, Progress()),
                             CutterProfile(cutters()[0]));
        LiftHint hint;
        QVERIFY(!lift.is_above(nowhere, 0, 0, hint) && std::isnan(lift.tip_z(nowhere, 0, hint, 0)));
    }

    void either_side_may_be_up() {
        const auto mesh = meshes()[0].mesh;
        auto turned = std::make_shared<Mesh>(*mesh);
        for (Facet& f : turned->facets)
            std::swap(f[1], f[2]);
        const auto index = std::make_shared<ContactIndex>(mesh, Progress());
        const auto index_turned = std::make_shared<ContactIndex>(turned, Progress());
        Random rng(6);
        for (const AptCutter& cutter : cutters()) {
            const AxialLift up(index, CutterProfile(cutter)), down(index_turned, CutterProfile(cutter));
            for (const Vec2& p : grid_points(rng, 60, 10)) {
                const double a = up.tip_z(p.x(), p.y()), b = down.tip_z(p.x(), p.y());
                QVERIFY(a == b || std::abs(a - b) <= tolerance::lift_accuracy);
            }
        }
    }

    void allowance_grows_the_cutter() {
        const auto mesh = meshes()[1].mesh;
        const auto index = std::make_shared<ContactIndex>(mesh, Progress());
        const double allowance = 0.7;
        // A ball grown is a ball.
        const AxialLift grown(index, CutterProfile(AptCutter::ball(6, 50)), allowance);
        const AxialLift larger(index, CutterProfile(AptCutter::ball(6 + 2 * allowance, 50)));
        for (double x = 1; x < 60; x += 3.7)
            QVERIFY(std::abs(grown.tip_z(x, 20) - (larger.tip_z(x, 20) + allowance))
                    <= tolerance::lift_accuracy);
        // Any other: the lowest of all cutters moved by less than the allowance, so a convolution of its
        // profile.
        for (const AptCutter& apt : cutters()) {
            const CutterProfile profile(apt);
            const AxialLift lift(index, profile, allowance);
            const double end = profile.max_radius();
            const auto g = [&](long double rho) -> long double {
                // Convex in `at`: a ball about a point of the profile, on either side of the axis.
                const auto height = [&](long double at) {
                    const long double off = std::min<long double>(std::abs(rho - at), allowance);
                    return (long double)(profile.height_at(double(std::min<long double>(std::abs(at), end))))
                           - std::sqrt(allowance * allowance - off * off);
                };
                long double lo = std::max<long double>(rho - allowance, -end),
                            hi = std::min<long double>(rho + allowance, end);
                for (int i = 0; i < 60; ++i) {
                    const long double a = lo + (hi - lo) * 0.4L, b = lo + (hi - lo) * 0.6L;
                    (height(a) < height(b) ? hi : lo) = height(a) < height(b) ? b : a;
                }
                return height((lo + hi) / 2);
            };
            const BruteCutter brute(g, end + allowance);
            Random rng(8);
            const double x = uniform(rng, 20, 40), y = uniform(rng, 20, 40);
            const double wanted = brute_lift(brute, *mesh, x, y), got = lift.tip_z(x, y);
            QVERIFY2(std::abs(got - wanted) <= mesh_accuracy,
                     qPrintable(QString("%1 %2").arg(got).arg(wanted)));
        }
        QCOMPARE(code_of([&] { AxialLift(index, CutterProfile(AptCutter::ball(6, 50)), -0.1); }),
                 std::string("out_of_range"));
    }

    void valleys_are_left_to_their_facets() {
        // Two roofs: x = 0 is the edge, once a ridge, once a valley.
        for (const double middle : {1.0, -1.0}) {
            Mesh mesh;
            mesh.vertices = {Vec3(0, -1, middle), Vec3(0, 1, middle), Vec3(-1, 0, 0), Vec3(1, 0, 0)};
            mesh.facets = {{0, 1, 2}, {1, 0, 3}};
            const auto duties = facet_duties(mesh, Progress());
            QCOMPARE(bool(duties[0] & duty_edge), middle > 0);
            QVERIFY(!(duties[1] & duty_edge)); // the other owns it
        }
        // Everything that can be touched is owned once.
        for (const NamedMesh& named : meshes()) {
            const Mesh& mesh = *named.mesh;
            const auto duties = facet_duties(mesh, Progress());
            std::map<std::pair<Index, Index>, int> owners;
            for (std::size_t f = 0; f < mesh.facet_count(); ++f)
                for (std::size_t k = 0; k < 3; ++k) {
                    const Index a = mesh.facets[f][k], b = mesh.facets[f][(k + 1) % 3];
                    int& count = owners[std::minmax(a, b)];
                    if (duties[f] & (duty_edge_anyway << k)) ++count;
                    // A cutter that comes down Z asks no edge but of its owner.
                    QVERIFY(!(duties[f] & (duty_edge << k)) || (duties[f] & (duty_edge_anyway << k)));
                }
            for (const auto& [edge, count] : owners)
                QCOMPARE(count, 1);
        }
    }

    // The slopes of the facets around a vertex; everything where they do not lie around it, and beside facets
    // of which no slope is known.
    void slopes_around_vertices() {
        const auto range_of = [](const Mesh& mesh) {
            std::vector<std::uint8_t> is_open;
            facet_duties(mesh, Progress(), &is_open);
            return vertex_slopes(mesh, is_open, Progress());
        };
        const auto is_all = [](const SlopeRange& r) {
            const SlopeRange all = SlopeRange::all();
            return r.lo_x == all.lo_x && r.hi_x == all.hi_x && r.lo_y == all.lo_y && r.hi_y == all.hi_y;
        };
        // A pyramid: its tip is closed, its base is not. A vertex in the middle of a side makes that open.
        Mesh pyramid;
        pyramid.vertices = {Vec3(1, 1, 0), Vec3(-1, 1, 0), Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 0, 2)};
        pyramid.facets = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
        const auto slopes = range_of(pyramid);
        const double slack = 3.01 * tolerance::slope_slack;
        for (const auto& [got, wanted] : {std::pair(slopes[4].lo_x, -2.0), std::pair(slopes[4].hi_x, 2.0),
                                          std::pair(slopes[4].lo_y, -2.0), std::pair(slopes[4].hi_y, 2.0)}) {
            QVERIFY(std::abs(double(got)) >= std::abs(wanted) + 0.5 * tolerance::slope_slack);
            QVERIFY(std::abs(double(got) - wanted) <= slack);
        }
        for (std::size_t v = 0; v < 4; ++v)
            QVERIFY(is_all(slopes[v]));
        Mesh turned = pyramid; // one facet wound the other way
        std::swap(turned.facets[1][0], turned.facets[1][1]);
        QVERIFY(!is_all(range_of(turned)[4]));
        Mesh folded = pyramid; // one side leans over
        folded.vertices[2] = Vec3(0.5, 0.5, 0);
        QVERIFY(is_all(range_of(folded)[4]));
        Mesh upright = pyramid;
        upright.vertices[0] = Vec3(0, 1, 0);
        upright.vertices[1] = Vec3(0, 2, 0);
        QVERIFY(is_all(range_of(upright)[4]));
        Mesh missing = pyramid;
        missing.facets.pop_back();
        QVERIFY(is_all(range_of(missing)[4]));
        Mesh doubled = pyramid;
        doubled.facets.push_back(doubled.facets[0]);
        QVERIFY(is_all(range_of(doubled)[4]));
        // Every facet's own slope is in the ranges of its vertices.
        for (const NamedMesh& named : meshes()) {
            const Mesh& mesh = *named.mesh;
            const auto ranges = range_of(mesh);
            for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
                const Vec3 n =
                    (mesh.corner(f, 1) - mesh.corner(f, 0)).cross(mesh.corner(f, 2) - mesh.corner(f, 0));
                for (const Index v : mesh.facets[f]) {
                    const SlopeRange& r = ranges[v];
                    QVERIFY(is_all(r)
                            || (-n.x() / n.z() >= r.lo_x && -n.x() / n.z() <= r.hi_x
                                && -n.y() / n.z() >= r.lo_y && -n.y() / n.z() <= r.hi_y));
                }
            }
        }
    }

    // A third facet on an edge keeps it.
    void non_manifold_edges_are_kept() {
        Mesh mesh;
        mesh.vertices = {Vec3(0, -1, -1), Vec3(0, 1, -1), Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0, -4)};
        mesh.facets = {{0, 1, 2}, {1, 0, 3}};
        QVERIFY(!(facet_duties(mesh, Progress())[0] & duty_edge));
        mesh.facets.push_back({0, 1, 4});
        QVERIFY(facet_duties(mesh, Progress())[0] & duty_edge);
    }

    // Planes that are flat but for the last digits, and a ball that touches them exactly on their vertices
    // and edges: neither facet may leave the contact to the other.
    void contact_between_nearly_coplanar_facets() {
        Random rng(12);
        for (int i = 0; i < trials(600); ++i) {
            const double noise = i % 3 ? 0 : std::pow(10.0, uniform(rng, -16, -10));
            const double bowl = i % 3 ? std::pow(10.0, uniform(rng, -17, -12)) : 0; // every edge a valley
            const double turn = uniform(rng, 0, 2 * pi), narrow = std::pow(10.0, uniform(rng, -4, 0));
            const double slope = uniform(rng, 0.1, 3), uphill = uniform(rng, 0, 2 * pi);
            const Vec2 gradient = slope * Vec2(std::cos(uphill), std::sin(uphill));
            const auto mesh = field(
                24, 24, [](double, double) { return 0.0; }, 0, 1);
            for (Vec3& v : mesh->vertices) {
                const Vec2 at = Eigen::Rotation2Dd(turn) * Vec2(v.x() - 12, narrow * (v.y() - 12));
                v = Vec3(at.x(), at.y(),
                         gradient.dot(at) + bowl * at.squaredNorm() + noise * uniform(rng, -1, 1));
            }
            const double r = uniform(rng, 0.1, 1);
            const AxialLift lift(std::make_shared<ContactIndex>(mesh, Progress()),
                                 CutterProfile(AptCutter::ball(2 * r, 50)));
            for (int k = 0; k < 40; ++k) {
                // A vertex, or a place on a diagonal, near the middle: touched by a ball whose axis is
                // downhill of it.
                const Vec3& v = mesh->vertices[std::size_t(whole(rng, 10, 14) * 25 + whole(rng, 10, 14))];
                const Vec3& w = mesh->vertices[std::size_t(&v - mesh->vertices.data()) + 26];
                const Vec3 touched = k % 2 ? v : Vec3(0.5 * (v + w));
                const double root = std::sqrt(1 + slope * slope);
                const Vec2 axis = touched.head<2>() - r / root * gradient;
                const double wanted = gradient.dot(axis) + r * (root - 1),
                             got = lift.tip_z(axis.x(), axis.y());
                QVERIFY2(std::abs(got - wanted) <= tolerance::lift_accuracy,
                         qPrintable(QString("%1 %2 %3").arg(got - wanted).arg(narrow).arg(noise)));
            }
        }
    }

    // The rim of a flat end, uphill of the axis, exactly on a valley between planes that climb the same way:
    // each plane's contact is that point, and rounding may see it outside of both facets.
    void contact_on_a_valley() {
        Random rng(14);
        for (int i = 0; i < trials(400); ++i) {
            const double turn = uniform(rng, 0, 2 * pi);
            const auto mesh = field(
                12, 12, [](double x, double) { return 0.05 * x * x; }, 0, 1);
            for (Vec3& v : mesh->vertices)
                v.head<2>() = Eigen::Rotation2Dd(turn) * v.head<2>();
            const double r = uniform(rng, 0.5, 2);
            const AxialLift lift(std::make_shared<ContactIndex>(mesh, Progress()),
                                 CutterProfile(AptCutter::flat(2 * r, 50)));
            for (int x = 5; x <= 11; ++x)
                for (int k = 0; k < 10; ++k) {
                    const Vec2 axis =
                        Eigen::Rotation2Dd(turn) * Vec2(x - r, k % 2 ? uniform(rng, 3, 9) : whole(rng, 3, 9));
                    const double wanted = 0.05 * x * x, got = lift.tip_z(axis.x(), axis.y());
                    QVERIFY2(std::abs(got - wanted) <= tolerance::lift_accuracy,
                             qPrintable(QString::number(got - wanted)));
                }
        }
    }

    // Boxes of the index are kept in 32-bit floats: what only just reaches under the rim must not be lost by
    // their rounding.
    void small_things_at_the_rim() {
        Random rng(13);
        const AptCutter flat = AptCutter::flat(6, 50);
        for (int i = 0; i < trials(2000); ++i) {
            const Vec3 at(uniform(rng, 50, 100), uniform(rng, 50, 100), uniform(rng, 1, 2));
            const auto mesh = std::make_shared<Mesh>();
            for (int k = 0; k < 3; ++k)
                mesh->vertices.push_back(
                    at + 1e-10 * Vec3(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1)));
            mesh->facets = {{0, 1, 2}};
            const AxialLift lift(std::make_shared<ContactIndex>(mesh, Progress()), CutterProfile(flat));
            const double highest =
                std::max({mesh->vertices[0].z(), mesh->vertices[1].z(), mesh->vertices[2].z()});
            const double away = 3 - 1e-9, angle = 0.5 * pi * (i % 4);
            QCOMPARE(lift.tip_z(at.x() + away * std::cos(angle), at.y() + away * std::sin(angle)), highest);
        }
    }

    void nothing_under_the_cutter() {
        const AxialLift empty(std::make_shared<ContactIndex>(std::make_shared<Mesh>(), Progress()),
                              CutterProfile(AptCutter::ball(6, 50)));
        QCOMPARE(empty.tip_z(0, 0), -infinity);
        QCOMPARE(empty.contact(0, 0).facet, no_index);
        const auto index = std::make_shared<ContactIndex>(meshes()[0].mesh, Progress());
        const AxialLift lift(index, CutterProfile(AptCutter::ball(6, 50)));
        QCOMPARE(lift.tip_z(1000, 0), -infinity);
        QCOMPARE(lift.tip_z(infinity, 0), -infinity);
        QCOMPARE(lift.tip_z(0, -infinity), -infinity);
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(std::isnan(lift.tip_z(nan, 0)) && std::isnan(lift.tip_z(0, nan)));
        QVERIFY(std::isnan(lift.contact(nan, 0).tip_z));
        QCOMPARE(lift.contact(nan, 0).feature, AxialContact::Feature::none);
        const std::vector<Vec2> points{Vec2(30, 30), Vec2(nan, 1), Vec2(30, 30)};
        std::vector<double> heights(3);
        lift.tip_z(points, heights, Progress());
        QVERIFY(std::isfinite(heights[0]) && std::isnan(heights[1]));
        QCOMPARE(heights[0], heights[2]);
    }

    // The cutter is shorter than the part is deep: what is above it inside its radius lifts it all the same.
    void part_higher_than_the_cutter() {
        const auto mesh = std::make_shared<Mesh>();
        mesh->vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 90)};
        mesh->facets = {{0, 1, 2}};
        const AxialLift lift(std::make_shared<ContactIndex>(mesh, Progress()),
                             CutterProfile(AptCutter::flat(6, 10)));
        QCOMPARE(lift.tip_z(0, 0), 90.0);
    }

    void refuses_bad_meshes() {
        const auto make = [](const Vec3& corner, Index vertex) {
            const auto mesh = std::make_shared<Mesh>();
            mesh->vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), corner};
            mesh->facets = {{0, 1, vertex}};
            return code_of([&] { ContactIndex(mesh, Progress()); });
        };
        QCOMPARE(make(Vec3(0, 1, 0), 2), std::string("none"));
        QCOMPARE(make(Vec3(0, std::nan(""), 0), 2), std::string("non_finite"));
        QCOMPARE(make(Vec3(0, 0, infinity), 2), std::string("non_finite"));
        QCOMPARE(make(Vec3(1e30, 0, 0), 2), std::string("non_finite"));
        QCOMPARE(make(Vec3(0, 1, 0), 3), std::string("internal"));
    }

    void cancels() {
        const auto mesh = meshes()[0].mesh;
        Job job;
        job.cancel();
        QVERIFY_THROWS_EXCEPTION(Cancelled, ContactIndex(mesh, Progress(job)));
        const AxialLift lift(std::make_shared<ContactIndex>(mesh, Progress()),
                             CutterProfile(AptCutter::ball(6, 50)));
        const std::vector<Vec2> points(1000, Vec2(30, 30));
        std::vector<double> heights(1000);
        QVERIFY_THROWS_EXCEPTION(Cancelled, lift.tip_z(points, heights, Progress(job)));
    }

    void index_is_small() {
        const auto mesh = field(
            200, 60, [](double x, double y) { return std::sin(x) * y; }, 0.3, 1);
        const ContactIndex index(mesh, Progress());
        QVERIFY2(index.memory() <= 100 * mesh->facet_count(), qPrintable(QString::number(index.memory())));
    }
};

FACETMILL_TEST(TestAxialLift)
#include "test_axial_lift.moc"
