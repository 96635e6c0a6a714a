// Routes of a layer: what of lines and borders is to be cut, how lines are joined, in stock and over parts
// with known answers, and on random stock against every cell of it.
#include "core/strategy/rough/rough_routes.h"
#include "tests/property/shapes.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/strategy/rough/polyline_distance.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double radius = 3, least = 0.01, cell = 0.1;

StockSolid block(const Vec3& lo, const Vec3& hi) {
    StockSolid solid;
    solid.box.lo = lo;
    solid.box.hi = hi;
    return solid;
}

/// A layer at z = 0 in stock from `lo` to `hi`, over a part that leaves the layer free but where `part`
/// reaches up.
struct Layer {
    PlanContext context;
    CutterProfile profile;
    RoughReach reach;
    StockCutter cutter;
    StockField field;
    LayerRoutes routes;

    explicit Layer(const Vec3& lo = Vec3(-10, -10, -4), const Vec3& hi = Vec3(10, 10, 2),
                   const Mesh& part = height_field([](double, double) { return -8.0; }, Vec2(-40, -40),
                                                   Vec2(40, 40), 2, 2))
        : context(context_of(part, flat_tool(2 * radius))), profile(context.tool.cutter()),
          reach(context.contact, context, 0.1, 0.02, -8), cutter(profile),
          field(block(lo, hi), cell, Progress()), routes(reach, field, cutter, DriveFrame(0), least) {}

    std::vector<LinePiece> pieces(double v, const std::vector<Interval>& free, double merge, bool but_ends,
                                  int line = 0) const {
        std::vector<LinePiece> all;
        routes.add_pieces(line, v, free, 0, merge, but_ends, all);
        return all;
    }
    void cut(const Vec2& a, const Vec2& b) {
        field.cut(cutter, Vec3(a.x(), a.y(), 0), Vec3(b.x(), b.y(), 0));
    }
};

FreeContour square(double half) {
    FreeContour c;
    c.closed = true;
    c.points = {{-half, -half}, {half, -half}, {half, half}, {-half, half}, {-half, -half}};
    return c;
}

double length_of(const std::vector<Vec2>& points) {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        sum += (points[i] - points[i - 1]).norm();
    return sum;
}

/// The link between two places of a border runs along it and is as long as it should be; a straight one that
/// is free does as well.
void check_link(const Layer& layer, const Vec2& from, const Vec2& to, std::span<const FreeContour> contours,
                double exact) {
    std::vector<Vec2> link;
    QVERIFY(layer.routes.connect(from, to, contours, 0, 100, link));
    if (link.empty()) return;
    link.insert(link.begin(), from);
    link.push_back(to);
    for (std::size_t i = 1; i < link.size(); ++i)
        QVERIFY(distance_to(contours[0].points, 0.5 * (link[i - 1] + link[i])) < 1e-9);
    QVERIFY2(std::abs(length_of(link) - exact) < 1e-9,
             qPrintable(QString("%1 of %2").arg(length_of(link)).arg(exact)));
}

} // namespace

class TestRoughRoutes : public QObject {
    Q_OBJECT
private slots:
    void a_line_is_cut_where_stock_stands() {
        Layer layer;
        const std::vector<Interval> free{{-30, 30}};
        auto all = layer.pieces(0, free, radius, false);
        QCOMPARE(all.size(), std::size_t(1));
        // Over the stock, and at most from where the rim comes to it to where it leaves it.
        const double slack = 4 * cell;
        QVERIFY(all[0].cut.lo <= -10 && all[0].cut.lo > -10 - radius - slack);
        QVERIFY(all[0].cut.hi >= 10 && all[0].cut.hi < 10 + radius + slack);
        QCOMPARE(all[0].free.lo, -30.0);
        QVERIFY(layer.pieces(40, free, radius, false).empty()); // beside the stock
        layer.cut({-30, 0}, {0, 0});
        all = layer.pieces(0, free, radius, false);
        QCOMPARE(all.size(), std::size_t(1));
        QVERIFY(all[0].cut.lo > -slack && all[0].cut.lo < radius && all[0].cut.hi >= 10);
        layer.cut({0, 0}, {30, 0});
        QVERIFY(layer.pieces(0, free, radius, false).empty());
    }

    void gaps_are_merged_and_ends_left_to_contours() {
        Layer layer;
        layer.cut({-2, 0}, {2, 0}); // in the middle nothing is left: a gap of about 4
        const std::vector<Interval> free{{-9, 9}};
        QCOMPARE(layer.pieces(0, free, 0, false).size(), std::size_t(2));
        QCOMPARE(layer.pieces(0, free, 3, false).size(), std::size_t(2));
        QCOMPARE(layer.pieces(0, free, 6, false).size(), std::size_t(1));
        // A piece shorter than the radius at the end of what is free.
        const std::vector<Interval> ends{{-4, 9}};
        QCOMPARE(layer.pieces(0, ends, 0, false).size(), std::size_t(2));
        const auto kept = layer.pieces(0, ends, 0, true);
        QCOMPARE(kept.size(), std::size_t(1));
        QVERIFY(kept[0].cut.lo > 0);
        const std::vector<Interval> high_end{{-9, 4}};
        const auto low = layer.pieces(0, high_end, 0, true);
        QCOMPARE(low.size(), std::size_t(1));
        QVERIFY(low[0].cut.hi < 0);
        // However near to each other they are, pieces of two free ranges are two.
        const Layer whole;
        const auto apart = whole.pieces(0, std::vector<Interval>{{-9, -0.1}, {0.1, 9}}, 6, false);
        QCOMPARE(apart.size(), std::size_t(2));
        QVERIFY(apart[0].cut.hi <= -0.1 && apart[1].cut.lo >= 0.1);
    }

    void neighbouring_lines_are_one_route() {
        const Layer layer;
        std::vector<LinePiece> pieces;
        for (int line = 0; line < 3; ++line)
            pieces.push_back({line, 5.0 * line - 5, {-8, 8}, {-20, 20}});
        Vec2 at(-9, -6);
        auto routes = layer.routes.joined_lines(pieces, {}, 0, 6, false, at, Progress());
        QCOMPARE(routes.size(), std::size_t(1));
        const std::vector<Vec2> zigzag{{-8, -5}, {8, -5}, {8, 0}, {-8, 0}, {-8, 5}, {8, 5}};
        QCOMPARE(routes[0].points, zigzag);
        QCOMPARE(routes[0].before, Vec2(-20, -5));
        QCOMPARE(routes[0].after, Vec2(20, 5));
        QCOMPARE(at, Vec2(8, 5));
        // Links longer than allowed are not made.
        at = Vec2(9, 6);
        routes = layer.routes.joined_lines(pieces, {}, 0, 4, false, at, Progress());
        QCOMPARE(routes.size(), std::size_t(3));
        QCOMPARE(routes[0].points.front(), Vec2(8, 5)); // the nearest first
        routes = layer.routes.joined_lines(pieces, {}, 0, 6, true, at, Progress());
        QCOMPARE(routes.size(), std::size_t(3));
        for (const RoughRoute& r : routes) {
            QVERIFY(!r.reversible);
            QCOMPARE(r.points.front().x(), -8.0);
            QCOMPARE(r.points.back().x(), 8.0);
        }
    }

    /// Behind a block the tool goes round along the border, the shorter way, or not at all.
    void a_link_goes_round_what_stands_between() {
        const Layer layer(Vec3(-10, -10, -4), Vec3(10, 10, 2), box(Vec3(-2, -1, -8), Vec3(2, 1, 5)));
        const ReachGrid grid(layer.reach, DriveFrame(0), Vec2(-9, -9), Vec2(9, 9), Progress());
        const auto contours = grid.contours(0, Progress());
        QCOMPARE(contours.size(), std::size_t(1));
        // From a corner of the border over the block to one under it, both to the right of its middle.
        const auto& border = contours.front().points;
        const auto corner = [&](double side) {
            return *std::max_element(border.begin(), border.end(), [&](const Vec2& a, const Vec2& b) {
                return side * a.y() - std::abs(a.x() - 1.5) < side * b.y() - std::abs(b.x() - 1.5);
            });
        };
        const Vec2 from = corner(1), to = corner(-1);
        QVERIFY(from.y() > 3.9 && to.y() < -3.9);
        RoughReach::Hints hints;
        QVERIFY(!layer.reach.is_free(from, to, 0, hints));
        std::vector<Vec2> link;
        QVERIFY(!layer.routes.connect(from, to, contours, 0, 5, link));
        QVERIFY(layer.routes.connect(from, to, contours, 0, 40, link));
        for (const Vec2& p : link) {
            QVERIFY(distance_to(border, p) < 1e-9);
            QVERIFY(p.x() > 0);
        }
        // Half a circle, the block's side, and what is left of the sides above and below it.
        const double kept = radius + 0.12, exact = (2 - from.x()) + (2 - to.x()) + 2 + pi * kept;
        QVERIFY2(std::abs(length_of(link) - exact) < 0.1,
                 qPrintable(QString("%1 of %2").arg(length_of(link)).arg(exact)));
        link.clear();
        QVERIFY(layer.routes.connect(from, Vec2(4, 5), contours, 0, 5, link));
        QVERIFY(link.empty()); // straight
    }

    /// Between any two places of a closed border the link is the shorter way along it; along an open one the
    /// only way; and from a place that is not free there is none.
    void links_follow_the_border() {
        const Layer layer(Vec3(-10, -10, -4), Vec3(10, 10, 2), box(Vec3(-2, -1, -8), Vec3(2, 1, 5)));
        const ReachGrid grid(layer.reach, DriveFrame(0), Vec2(-9, -9), Vec2(9, 9), Progress());
        const auto closed = grid.contours(0, Progress());
        QCOMPARE(closed.size(), std::size_t(1));
        std::vector<FreeContour> open = closed;
        open[0].closed = false;
        open[0].points.erase(open[0].points.begin(), open[0].points.begin() + 4);
        Random rng(23);
        std::size_t forward = 0, back = 0, links = 0;
        for (const auto& contours : {closed, open}) {
            const auto& border = contours[0].points;
            std::vector<double> arc{0};
            for (std::size_t i = 1; i < border.size(); ++i)
                arc.push_back(arc.back() + (border[i] - border[i - 1]).norm());
            for (int k = 0; k < 60; ++k) {
                const auto a = std::size_t(whole(rng, 0, int(border.size()) - 1)),
                           b = std::size_t(whole(rng, 0, int(border.size()) - 1));
                const double ahead = std::abs(arc[b] - arc[a]);
                const double exact = contours[0].closed ? std::min(ahead, arc.back() - ahead) : ahead;
                check_link(layer, border[a], border[b], contours, exact);
                if (QTest::currentTestFailed()) return;
                ++(a < b ? forward : back);
                ++links;
            }
        }
        QVERIFY(forward > 20 && back > 20 && links == 120);
        // Inside the border by less than is looked at around it.
        const Vec2 inside = closed[0].points[3] * (1 - 1 / closed[0].points[3].norm());
        std::vector<Vec2> link;
        RoughReach::Hints hints;
        QVERIFY(!layer.reach.is_free(inside, 0, hints));
        QVERIFY(!layer.routes.connect(inside, -inside * 1.5, closed, 0, 100, link));
    }

    void the_nearest_border_is_cut_first() {
        const Layer layer;
        std::vector<FreeContour> borders{square(2), square(2)};
        for (Vec2& p : borders[0].points)
            p.x() -= 6;
        for (Vec2& p : borders[1].points)
            p.x() += 6;
        for (const double side : {-1.0, 1.0}) {
            Vec2 at(side * 9, 0.5);
            const auto routes = layer.routes.along_contours(borders, 0, at, Progress());
            QCOMPARE(routes.size(), std::size_t(2));
            QVERIFY((routes[0].points.front() - Vec2(side * 8, 0.5)).norm() < 1e-12);
            QVERIFY(routes[1].points.front().x() * side < 0);
        }
    }

    /// Where nothing stands within a radius before its work the tool begins there.
    void a_border_is_begun_where_nothing_stands() {
        for (const double from : {6.0, 6.3, 6.6, 6.9, 7.2, 7.5}) {
            const Layer layer(Vec3(from, -10, -4), Vec3(20, 10, 2));
            const std::vector<FreeContour> borders{square(5)};
            Vec2 at(0, 0);
            const auto routes = layer.routes.along_contours(borders, 0, at, Progress());
            QCOMPARE(routes.size(), std::size_t(1));
            const Vec2 start = routes[0].points.front();
            QVERIFY2(layer.field.stand_height(layer.cutter, start, start) <= least,
                     qPrintable(
                         QString("stock from %1, begun at %2, %3").arg(from).arg(start.x()).arg(start.y())));
        }
    }

    void a_border_in_stock_is_cut_all_round_from_the_nearest_place() {
        const Layer layer;
        const std::vector<FreeContour> borders{square(5)};
        Vec2 at(0, -20);
        const auto routes = layer.routes.along_contours(borders, 0, at, Progress());
        QCOMPARE(routes.size(), std::size_t(1));
        QVERIFY(routes[0].closed);
        QVERIFY((routes[0].points.front() - Vec2(0, -5)).norm() < 1e-12);
        QCOMPARE(routes[0].points.back(), routes[0].points.front());
        QVERIFY(std::abs(length_of(routes[0].points) - 40) < 1e-12);
        QCOMPARE(at, routes[0].points.back());
    }

    void of_a_border_only_what_has_work_is_cut() {
        const Layer layer(Vec3(7, -10, -4), Vec3(20, 10, 2)); // beside the square's side x = 5
        const std::vector<FreeContour> borders{square(5)};
        Vec2 at(0, 0);
        const auto routes = layer.routes.along_contours(borders, 0, at, Progress());
        QCOMPARE(routes.size(), std::size_t(1));
        QVERIFY(!routes[0].closed);
        const double length = length_of(routes[0].points);
        // The side, what is within the cutter's reach round its corners, and a radius to come in.
        QVERIFY2(length > 10 && length < 10 + 2 * radius + 1.1 * radius + 4 * 0.5 * radius,
                 qPrintable(QString::number(length)));
        for (const double y : {-4.9, 0.0, 4.9})
            QVERIFY(distance_to(routes[0].points, Vec2(5, y)) < 1e-9);
        QVERIFY(distance_to(routes[0].points, Vec2(-5, 0)) > radius);
        // Nothing stands there: no route, unless it is wanted for another reason.
        Layer empty(Vec3(30, 30, -4), Vec3(40, 40, 2));
        QVERIFY(empty.routes.along_contours(borders, 0, at, Progress()).empty());
        const auto wanted = empty.routes.along_contours(
            borders, 0, at, Progress(), [](const Vec2& a, const Vec2& b) { return a.x() + b.x() < -9; });
        QCOMPARE(wanted.size(), std::size_t(1));
        QVERIFY(distance_to(wanted[0].points, Vec2(-5, 0)) < 1e-9);
    }

    /// Every short step of a border that takes something away is in a route; routes lie on the border.
    void random_stock_against_every_step() {
        Random rng(17);
        std::size_t busy = 0, idle = 0;
        for (int trial = 0; trial < trials(30, 5); ++trial) {
            Layer layer;
            for (int k = 0; k < 6; ++k)
                layer.cut(Vec2(uniform(rng, -10, 10), uniform(rng, -10, 10)),
                          Vec2(uniform(rng, -10, 10), uniform(rng, -10, 10)));
            const std::vector<FreeContour> borders{square(uniform(rng, 4, 9))};
            Vec2 at(uniform(rng, -12, 12), uniform(rng, -12, 12));
            const auto routes = layer.routes.along_contours(borders, 0, at, Progress());
            const auto& points = borders[0].points;
            for (std::size_t i = 1; i < points.size(); ++i)
                for (double t = 0; t < 1; t += 0.02) {
                    const Vec2 p = points[i - 1] + t * (points[i] - points[i - 1]);
                    const Vec3 tip(p.x(), p.y(), 0);
                    if (!layer.field.has_work(layer.cutter, tip, tip, least)) {
                        ++idle;
                        continue;
                    }
                    ++busy;
                    double nearest = infinity;
                    for (const RoughRoute& r : routes)
                        nearest = std::min(nearest, distance_to(r.points, p));
                    QVERIFY2(nearest < 1e-6, qPrintable(QString("%1, %2").arg(p.x()).arg(p.y())));
                }
            for (const RoughRoute& r : routes)
                for (const Vec2& p : r.points)
                    QVERIFY(distance_to(points, p) < 1e-6);
        }
        QVERIFY(busy > trials(std::size_t(1000)) && idle > trials(std::size_t(100)));
    }
};

FACETMILL_TEST(TestRoughRoutes)
#include "test_rough_routes.moc"
