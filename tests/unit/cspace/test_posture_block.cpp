// Planted causes: every posture that is blocked says why.
#include "core/cspace/cspace.h"

#include "core/setup/kinematics.h"
#include "tests/support/test_runner.h"
#include "tests/unit/cspace/cspace_cases.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A box standing on z = 0; the numbers of its facets are from `first` on.
Index add_block(Mesh& mesh, double x0, double x1, double y0, double y1, double height) {
    const auto first = Index(mesh.facets.size());
    const Vec3 a(x0, y0, 0), b(x1, y0, 0), c(x1, y1, 0), d(x0, y1, 0), up(0, 0, height);
    add_quad(mesh, a, b, b + up, a + up);
    add_quad(mesh, b, c, c + up, b + up);
    add_quad(mesh, c, d, d + up, c + up);
    add_quad(mesh, d, a, a + up, d + up);
    add_quad(mesh, a + up, b + up, c + up, d + up);
    return first;
}

constexpr double tau = 0.1;

} // namespace

class TestPostureBlock : public QObject {
    Q_OBJECT
private slots:
    void free_plane() {
        const Bench bench(level_plane(300), tool_of(12, 0, 25, 12, 30, 20));
        const CSpaceBuilder builder(bench.input);
        const auto reason = builder.reason(ContactFrame(), radians(5), 0, beside(0.5, tau));
        QCOMPARE(int(reason.block), int(PostureBlock::free));
        QVERIFY(reason.top > 0.09 && reason.bottom < 1e-12);
        QCOMPARE(posture_block_name(reason.block), "free");
    }

    void lift_where_the_cusp_forbids_it() {
        const Bench bench(level_plane(300), tool_of(12, 0, 25, 12, 30, 20));
        const CSpaceBuilder builder(bench.input);
        const auto reason = builder.reason(ContactFrame(), radians(45), 0, beside(3, tau));
        QCOMPARE(int(reason.block), int(PostureBlock::lift));
        QVERIFY(reason.top < 0);
        // Out of reach altogether.
        QCOMPARE(int(builder.reason(ContactFrame(), radians(5), 0, beside(7, tau)).block),
                 int(PostureBlock::lift));
    }

    /// The cutter leans into a wall that stands off the contact point.
    void global_at_a_wall() {
        Mesh mesh = level_plane(300);
        const Index wall = add_block(mesh, 9, 12, -50, 50, 20);
        const Bench bench(std::move(mesh), tool_of(12, 0, 25, 12, 30, 12));
        const CSpaceBuilder builder(bench.input);
        const auto toward = builder.reason(ContactFrame(), radians(45), 0, beside(0.5, tau));
        QCOMPARE(int(toward.block), int(PostureBlock::global));
        QCOMPARE(int(toward.contact.body), int(ToolBody::cutter));
        QVERIFY(toward.contact.facet >= wall);
        QVERIFY(toward.contact.point.x() >= 9 && toward.bottom > 1);
        const auto away = builder.reason(ContactFrame(), radians(45), radians(180), beside(0.1, tau));
        QCOMPARE(int(away.block), int(PostureBlock::free));
    }

    /// A block under the holder, lower than the holder when the tool stands upright.
    void holder_over_a_block() {
        Mesh mesh = level_plane(300);
        const Index block = add_block(mesh, 24, 60, -50, 50, 46);
        const Bench bench(std::move(mesh), tool_of(12, 0, 25, 12, 30, 60));
        const CSpaceBuilder builder(bench.input);
        const auto upright = builder.reason(ContactFrame(), radians(1), 0, beside(0.5, tau));
        QCOMPARE(int(upright.block), int(PostureBlock::free));
        const auto leaning = builder.reason(ContactFrame(), radians(20), 0, beside(0.2, tau));
        QCOMPARE(int(leaning.block), int(PostureBlock::holder));
        QVERIFY(leaning.contact.facet >= block && leaning.contact.section == 0);
    }

    void shank_over_a_block() {
        Mesh mesh = level_plane(300);
        const Index block = add_block(mesh, 12, 60, -50, 50, 28);
        const Bench bench(std::move(mesh), tool_of(12, 0, 25, 40, 60, 42));
        const CSpaceBuilder builder(bench.input);
        const auto reason = builder.reason(ContactFrame(), radians(1), 0, beside(0.5, tau));
        QCOMPARE(int(reason.block), int(PostureBlock::shank));
        QVERIFY(reason.contact.facet >= block);
        QCOMPARE(int(reason.contact.body), int(ToolBody::shank));
    }

    /// In a hollow along the feed, as narrow as the cutter, an upright flat end stands on both sides of it.
    void local_in_a_hollow() {
        const double radius = 20, size = 40;
        Mesh mesh = *field(80, size, [&](double, double y) {
            return -std::sqrt(radius * radius - 0.9 * (y - 20) * (y - 20));
        });
        const Bench bench(std::move(mesh), tool_of(12, 0, 25, 6, 60, 8));
        const CSpaceBuilder builder(bench.input);
        const ContactFrame frame = ContactFrame::at(Vec3(20.1, 20.1, -20), Vec3::UnitZ(), Vec3::UnitX());
        const std::vector<RaisedCurve> curves = {{{0, 20, -20 + tau}, {40, 20, -20 + tau}}};
        const auto upright = builder.reason(frame, 0, 0, curves);
        QCOMPARE(int(upright.block), int(PostureBlock::local));
        QVERIFY((upright.contact.point - frame.point).norm() <= bench.input.local_radius);
        const auto leaning = builder.reason(frame, radians(30), 0, curves);
        QCOMPARE(int(leaning.block), int(PostureBlock::free));
    }

    void too_much_lean_to_touch() {
        Tool tool = tool_of(6, 0, 12, 12, 30, 20);
        tool.taper_angle = radians(20);
        const Bench bench(level_plane(300), tool);
        const CSpaceBuilder builder(bench.input);
        ToolLift::Hint hint;
        for (const double lead : {radians(71), radians(90), radians(120)}) {
            const auto reason = builder.reason(ContactFrame(), lead, 0.2, beside(0.5, tau));
            QCOMPARE(int(reason.block), int(PostureBlock::shank));
            QCOMPARE(reason.bottom, infinity);
            QCOMPARE(reason.top, -infinity);
            QCOMPARE(builder.bottom(ContactFrame(), lead, 0.2, hint), infinity);
            QCOMPARE(builder.top(ContactFrame(), lead, 0.2, beside(0.5, tau)), -infinity);
        }
        PostureGrid grid = PostureGrid::make(radians(60), radians(80), 0, 0, radians(10));
        CSpaceInput input = bench.input;
        input.grid = &grid;
        const CSpace space = CSpaceBuilder(input).build(ContactFrame(), beside(0.05, tau));
        QCOMPARE(space.bottom.back(), infinity);
        QCOMPARE(space.top.back(), -infinity);
        QCOMPARE(int(space.block.back()), int(PostureBlock::shank));
        QVERIFY(space.bottom.front() < infinity);
    }

    /// Three axes hold an upright tool only; travel ends at the wrong height.
    void machine_limits() {
        const Bench bench(level_plane(300), tool_of(12, 0, 25, 12, 30, 20));
        Machine machine;
        const Kinematics plain(machine, gauge_length(bench.tool), Vec3::Zero());
        CSpaceInput input = bench.input;
        input.kinematics = &plain;
        const auto curves = beside(0.5, tau);
        QCOMPARE(int(CSpaceBuilder(input).reason(ContactFrame(), 0, 0, curves).block),
                 int(PostureBlock::free));
        QCOMPARE(int(CSpaceBuilder(input).reason(ContactFrame(), radians(5), 0, curves).block),
                 int(PostureBlock::machine));
        // What the part forbids comes first.
        QCOMPARE(int(CSpaceBuilder(input).reason(ContactFrame(), radians(45), 0, beside(3, tau)).block),
                 int(PostureBlock::lift));
        machine.travel[2] = {gauge_length(bench.tool) + 1, infinity};
        const Kinematics high(machine, gauge_length(bench.tool), Vec3::Zero());
        input.kinematics = &high;
        QCOMPARE(int(CSpaceBuilder(input).reason(ContactFrame(), 0, 0, curves).block),
                 int(PostureBlock::machine));
    }

    /// Without the bottoms of hopeless postures the others are the same.
    void bottoms_that_matter() {
        Mesh mesh = level_plane(300);
        add_block(mesh, 9, 12, -50, 50, 20);
        const Bench bench(std::move(mesh), tool_of(12, 0, 25, 12, 30, 12));
        CSpaceInput quick = bench.input;
        quick.bottom_everywhere = false;
        const auto curves = beside(1.5, tau);
        const CSpace all = CSpaceBuilder(bench.input).build(ContactFrame(), curves),
                     some = CSpaceBuilder(quick).build(ContactFrame(), curves);
        int hopeless = 0, lifted = 0;
        for (std::size_t i = 0; i < all.top.size(); ++i) {
            QCOMPARE(some.top[i], all.top[i]);
            QCOMPARE(int(some.block[i]), int(all.block[i]));
            const bool skipped = all.top[i] < 0;
            QCOMPARE(some.bottom[i], skipped ? 0 : all.bottom[i]);
            hopeless += skipped && all.bottom[i] > 0;
            lifted += !skipped && all.bottom[i] > 0;
        }
        QVERIFY(hopeless > 0 && lifted > 0);
    }

    /// With an allowance the cutter stands that much above the part, and no more.
    void allowance() {
        const auto mesh = std::make_shared<Mesh>(level_plane(300));
        const Tool tool = tool_of(12, 2, 25, 12, 30, 20);
        const ToolLift lift(std::make_shared<ContactIndex>(mesh, Progress()), tool, {.cutter = 0.5});
        const CSpaceBuilder builder({.lift = &lift, .local_radius = 6});
        ContactFrame frame;
        ToolLift::Hint hint;
        for (const double lead : {0.0, 10.0, 40.0})
            QVERIFY(builder.bottom(frame, radians(lead), 0.3, hint) > 0.49);
        frame.point.z() = 0.5;
        for (const double lead : {0.0, 10.0, 40.0})
            QVERIFY(builder.bottom(frame, radians(lead), 0.3, hint) < 1e-12);
    }
};

FACETMILL_TEST(TestPostureBlock)
#include "test_posture_block.moc"
