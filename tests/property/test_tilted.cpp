// Finishing with a short ball that is inclined where its holder would come into the part: the same cut as
// that of a tool so long that it never has to be, by every kind of passes.
#include "core/job/cspace_json.h"
#include "core/strategy/curves/along_curve.h"
#include "core/strategy/five_axis/five_axis_study.h"
#include "core/strategy/five_axis/posture_path.h"
#include "tests/property/five_axis_plan.h"
#include "tests/support/error_code.h"
#include "tests/support/naive_check.h"
#include "tests/support/random_meshes.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double tilted_tau = 0.1;
const double tilted_limit = radians(50);

/// A floor between a high wall that leans back and winds, and a lower one that leans more.
Mesh floor_between_walls() {
    return height_field(
        [](double x, double y) {
            const double wall = y - 7 - 1.5 * std::sin(x / 5), low = -12 - y;
            return std::max({0.0, std::min(26.0, 5 * wall), std::min(10.0, 1.5 * low)});
        },
        Vec2(-14, -20), Vec2(14, 16), 56, 144);
}

Tool long_six() {
    Tool t = ball_tool(6);
    t.flute_length = 60;
    t.shank_length = 0;
    t.holder.clear();
    return t;
}
Tool short_six() {
    Tool t = ball_tool(6);
    t.flute_length = 10;
    t.shank_length = 4;
    t.shank_diameter = 6;
    t.holder = {{22, 30}};
    return t;
}

std::unique_ptr<Operation> finishing(const std::string& kind, double tilt_limit) {
    auto op = make_operation(kind);
    op->common().tolerance = tilted_tau;
    op->common().direction = {0, "x"};
    op->set("tilt_limit", tilt_limit);
    return op;
}

/// The short tool over the part as a long one has left it, to within half a millimetre.
PlanContext semi_finished(const Mesh& part) {
    PlanContext context = five_axis_context(part, short_six());
    const auto before = finishing("finish3", 0);
    before->common().allowance = 0.4;
    auto cuts = std::make_shared<EarlierCuts>();
    cuts->cutter = long_six().cutter();
    cuts->no_nearer = 0.35;
    for (const Pass& pass : before->plan(five_axis_context(part, long_six()), Progress()).passes)
        for (std::size_t i = 1; i < pass.cl.size(); ++i)
            cuts->motions.push_back({pass.cl[i - 1].tip, pass.cl[i].tip});
    context.earlier.push_back(std::move(cuts));
    return context;
}

double tilted_length(const StrategyResult& path) {
    double sum = 0;
    for (const Pass& pass : path.passes)
        for (std::size_t i = 1; i < pass.cl.size(); ++i)
            sum += (pass.cl[i].tip - pass.cl[i - 1].tip).norm();
    return sum;
}

Vec3 ball_middle(const CutterLocation& c) {
    return c.tip + 3 * c.axis;
}

/// How far the middles of the ball, also those between locations, come from the ways of others.
double away_from(const StrategyResult& ways, const StrategyResult& path) {
    std::vector<std::array<Vec3, 2>> pieces;
    for (const Pass& pass : ways.passes)
        for (std::size_t i = 1; i < pass.cl.size(); ++i)
            pieces.push_back({ball_middle(pass.cl[i - 1]), ball_middle(pass.cl[i])});
    double farthest = 0;
    std::size_t last = 0; // the nearest piece is most often that of before or the next
    for (const Pass& pass : path.passes)
        for (std::size_t i = 1; i < pass.cl.size(); ++i)
            for (const double t : {0.0, 0.5, 1.0}) {
                const Vec3 m = ball_middle(location_on_route(pass.cl[i - 1], pass.cl[i], t));
                const auto away = [&](std::size_t k) {
                    const auto& [a, b] = pieces[k];
                    const double along =
                        std::clamp((m - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-300), 0.0, 1.0);
                    return (m - a - along * (b - a)).norm();
                };
                double nearest = infinity;
                for (std::size_t k = last; k < std::min(last + 3, pieces.size()) && nearest > 1e-6; ++k)
                    nearest = std::min(nearest, away(k));
                for (std::size_t k = 0; k < pieces.size() && nearest > 1e-6; ++k)
                    if (const double d = away(k); d < nearest) {
                        nearest = d;
                        last = k;
                    }
                farthest = std::max(farthest, nearest);
            }
    return farthest;
}

ToolMotions linked_tilted(const StrategyResult& path, const PlanContext& context, const Operation& op) {
    return link_five_axis(path, context, {0, op.holder_clearance(), op.holder_clearance()},
                          default_link_options(path, context, op.common()), Progress());
}

Verification judged_tilted(const Mesh& part, const PlanContext& context, const ToolMotions& motions,
                           double chord) {
    VerifySettings s;
    s.resolution = s.sample_spacing = 0.8;
    s.tolerance = tilted_tau;
    s.gouge_limit = chord;
    StockSolid stock;
    stock.box = context.stock_box;
    const VerifyProgram program{"F", VerifyTool(context.tool), std::make_shared<ToolMotions>(motions), {}};
    return verify(part, stock, {&program, 1}, s, Progress());
}

std::vector<NaiveBarrel> tilted_barrels(const Tool& tool) {
    std::vector<NaiveBarrel> barrels;
    double at = tool.flute_length;
    if (tool.shank_length > 0)
        barrels.push_back({0.5 * tool.shank_diameter - 0.05, at, at + tool.shank_length});
    at += tool.shank_length;
    for (const HolderSection& s : tool.holder) {
        barrels.push_back({0.5 * s.diameter - 0.05, at, at + s.length});
        at += s.length;
    }
    return barrels;
}

} // namespace

class TestTilted : public QObject {
    Q_OBJECT
private slots:
    void a_short_tool_cuts_what_a_long_one_does_data() {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"finish3", "waterline", "scallop", "steep_shallow", "spiral", "along_curve"})
            QTest::newRow(kind) << kind;
    }
    void a_short_tool_cuts_what_a_long_one_does() {
        QFETCH(QString, kind);
        const std::string name = kind.toStdString();
        const Mesh part = floor_between_walls();
        const PlanContext with_long = five_axis_context(part, long_six()), with_short = semi_finished(part);
        const StrategyResult whole = finishing(name, 0)->plan(with_long, Progress());
        double upright = 0; // what the short tool cuts upright
        try {
            upright = tilted_length(finishing(name, 0)->plan(with_short, Progress()));
        } catch (const Error& e) {
            QCOMPARE(e.code(), ErrorCode::empty_result);
        }
        const auto op = finishing(name, tilted_limit);
        QVERIFY(!op->keeps_axis() && op->linking() == Linking::tilted);
        const StrategyResult path = op->plan(with_short, Progress());
        const auto* tilted = path.as<TiltedPath>();
        QVERIFY(tilted && tilted->lead_max > radians(5) && tilted->lead_max <= tilted_limit + 1e-9);
        const double length = tilted_length(whole), kept = tilted_length(path);
        const QString figures = QString("%1 mm of %2, %3 upright, inclined by %4, its middle off by %5")
                                    .arg(kept)
                                    .arg(length)
                                    .arg(upright)
                                    .arg(degrees(tilted->lead_max))
                                    .arg(away_from(whole, path));
        qInfo("%s", qPrintable(figures));
        for (const std::string& w : path.warnings)
            qInfo("%s", w.c_str());
        QVERIFY2(upright < 0.97 * length, qPrintable(figures));
        QVERIFY2(kept > 0.95 * length, qPrintable(figures));
        // Drawn out by up to the chord tolerance where upright passes run below the exact path.
        QVERIFY2(away_from(whole, path) <= 1.5 * path.chord_tolerance + 1e-6, qPrintable(figures));
        for (const Pass& pass : path.passes)
            for (const CutterLocation& c : pass.cl)
                QVERIFY(std::acos(std::min(c.axis.z(), 1.0)) <= tilted_limit + 1e-9);

        const ToolMotions motions = linked_tilted(path, with_short, *op);
        const Verification v = judged_tilted(part, with_short, motions, path.chord_tolerance);
        QVERIFY2(!v.gouged(), qPrintable(QString::number(std::max(v.figures.gouge_max, v.border.gouge_max))));
        for (const Collision& c : v.collisions)
            QVERIFY2(!c.with_part, "shank or holder meets the part");
        const NaiveProgram naive{with_short.tool.cutter(), motions.motions, tilted_barrels(with_short.tool)};
        const NaiveResult second =
            naive_check(part, {&naive, 1},
                        {.spacing = 2, .tolerance = tilted_tau, .stock = part.box(), .pose_share = 0.1});
        QVERIFY2(second.gouge_max <= path.chord_tolerance, qPrintable(QString::number(second.gouge_max)));
    }

    void any_number_of_threads_gives_the_same() {
        const PlanContext context = semi_finished(floor_between_walls());
        std::vector<std::vector<double>> found;
        for (const int threads : {1, 3}) {
            set_thread_count(threads);
            found.push_back(numbers(finishing("scallop", tilted_limit)->plan(context, Progress())));
        }
        set_thread_count(0);
        QVERIFY(found[0] == found[1]);
    }

    /// Of every contact point the posture that was chosen is free in the space that is shown, upright ones
    /// beside the wall are not, and none that leans beyond the limit is.
    void configuration_spaces_are_those_of_the_choice() {
        const PlanContext context = semi_finished(floor_between_walls());
        const StrategyResult path = finishing("finish3", tilted_limit)->plan(context, Progress());
        const auto record = path.five_axis();
        QVERIFY(record && !record->has_strips);
        std::size_t locations = 0;
        for (const Pass& pass : path.passes)
            locations += pass.cl.size();
        QCOMPARE(record->points.size(), locations);
        const FiveAxisStudy study(record, Progress());
        std::size_t inclined = 0;
        for (std::size_t i = 0; i < record->points.size(); i += record->points.size() / 40) {
            const FiveAxisStudy::Point point = study.point(i, Progress());
            QVERIFY(point.planned.free);
            const PostureValue& p = point.planned.posture;
            const Vec3 axis = posture_axis(point.place.frame, p.lead, p.yaw);
            const ToolPose pose = posture_pose(study.field().cutter(), point.place.frame, p);
            // A location of the path.
            bool found = false;
            for (const Pass& pass : path.passes)
                for (const CutterLocation& c : pass.cl)
                    found = found || ((c.tip - pose.tip).norm() < 0.01 && (c.axis - axis).norm() < 1e-9);
            QVERIFY(found);
            if (p.lead < radians(88)) {
                const auto reason = study.reason(point, p.lead, p.yaw);
                QVERIFY2(reason.block == PostureBlock::free, posture_block_name(reason.block));
            }
            const PostureValue upright = posture_of_axis(point.place.frame, Vec3::UnitZ());
            const PostureBlock block = study.reason(point, upright.lead, upright.yaw).block;
            if (axis.z() < std::cos(radians(1)) && block == PostureBlock::holder) ++inclined;
            for (std::size_t l = 0; l < point.grid.lead.size(); ++l)
                for (std::size_t o = 0; o < point.grid.yaw.size(); ++o)
                    if (posture_axis(point.place.frame, point.grid.lead[l], point.grid.yaw[o]).z()
                        < std::cos(tilted_limit) - 1e-6)
                        QVERIFY(point.space.block[point.grid.node(l, o)] != PostureBlock::free);
            QVERIFY(!cspace_json(study, point, LengthUnit::mm).empty());
        }
        QVERIFY(inclined > 3);
    }

    /// In a block that nobody roughed the holder comes into what stands over the floor, however it leans.
    void what_stands_is_kept_out_of() {
        const Mesh part = floor_between_walls();
        const PlanContext block = five_axis_context(part, short_six());
        const auto op = finishing("finish3", tilted_limit);
        const StrategyResult path = op->plan(block, Progress()),
                             after = op->plan(semi_finished(part), Progress());
        QVERIFY(tilted_length(path) < 0.5 * tilted_length(after));
        bool told = false;
        for (const std::string& w : path.warnings)
            told = told || w.find("what stands of the stock") != std::string::npos;
        QVERIFY(told);
        const Verification v =
            judged_tilted(part, block, linked_tilted(path, block, *op), path.chord_tolerance);
        for (const Collision& c : v.collisions)
            QVERIFY2(c.kind != Collision::Kind::holder, "the holder comes into the stock");
    }

    /// A tool that leans sees the sides of a box, which nobody asked it for.
    void what_only_a_leaning_tool_sees_is_not_asked_for() {
        const Mesh part = box(Vec3(0, 0, 0), Vec3(20, 20, 10));
        const PlanContext context = five_axis_context(part, long_six());
        ToolMotions motions;
        const Vec3 axis = Vec3(std::sin(radians(30)), 0, std::cos(radians(30)));
        for (const double y : {2.0, 18.0})
            motions.motions.push_back({MotionKind::cut, {Vec3(10, y, 10.5), axis}, 0, 0});
        VerifyProgram program{"F", VerifyTool(context.tool), std::make_shared<ToolMotions>(motions), {}};
        VerifySettings s;
        s.resolution = s.sample_spacing = 1;
        s.tolerance = tilted_tau;
        StockSolid stock;
        stock.box = context.stock_box;
        const double leaning = verify(part, stock, {&program, 1}, s, Progress()).figures.area;
        program.seen_along = Vec3::UnitZ();
        const double upright = verify(part, stock, {&program, 1}, s, Progress()).figures.area;
        QVERIFY2(std::abs(upright - 400) < 60 && leaning > upright + 100,
                 qPrintable(QString("%1 %2").arg(upright).arg(leaning)));
    }

    void only_balls_are_inclined() {
        const Mesh part = floor_between_walls();
        for (const char* kind : {"finish3", "waterline", "scallop", "radial"}) {
            const auto plan = [&](const Tool& tool) {
                return finishing(kind, tilted_limit)->plan(five_axis_context(part, tool), Progress());
            };
            QCOMPARE(code_of([&] { plan(flat_tool(6)); }), std::string("out_of_range"));
            QCOMPARE(code_of([&] { plan(bull_tool(6, 1)); }), std::string("out_of_range"));
        }
        AlongCurveSettings s;
        s.tilt_limit = tilted_limit;
        s.depth = 0.5;
        QCOMPARE(code_of([&] { AlongCurve(s).plan(five_axis_context(part, short_six()), Progress()); }),
                 std::string("out_of_range"));
    }

    /// Without two rotary axes nothing can lean: what the holder keeps the tool from is left out and told.
    void the_machine_has_to_hold_the_axis() {
        PlanContext context = five_axis_context(floor_between_walls(), short_six());
        context.machine = find_machine("generic-3-axis");
        const StrategyResult path = finishing("finish3", tilted_limit)->plan(context, Progress());
        for (const Pass& pass : path.passes)
            for (const CutterLocation& c : pass.cl)
                QCOMPARE(c.axis.z(), 1.0);
        bool told = false;
        for (const std::string& w : path.warnings)
            told = told || w.find("the tool is short") != std::string::npos;
        QVERIFY(told);
    }
};

FACETMILL_TEST(TestTilted)
#include "test_tilted.moc"
