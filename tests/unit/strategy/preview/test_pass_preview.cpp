// Previews of passes against the exact lift of the cutter and against what the operations plan.
#include "core/strategy/preview/pass_preview.h"

#include "core/base/parallel.h"
#include "core/gouge/axial_lift.h"
#include "core/strategy/preview/preview_turning.h"
#include "core/strategy/surface/travel_direction.h"
#include "tests/property/shapes.h"
#include "tests/support/cancel_at.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double cusp = 0.1;

/// A hollow with steep flanks in the middle of a plate, round hills beside it.
Mesh hollowed() {
    return height_field(
        [](double x, double y) {
            const double d = std::hypot(x, y);
            return -5 / (1 + std::exp(1.6 * (d - 6))) + 0.6 * std::sin(0.35 * x) * std::cos(0.3 * y);
        },
        Vec2(-15, -12), Vec2(15, 12), 90, 72);
}
/// Two planes that meet in a sharp valley.
Mesh gutter() {
    return height_field([](double, double y) { return 0.8 * std::abs(y); }, Vec2(-15, -10), Vec2(15, 10), 30,
                        40);
}
Mesh rod() {
    Mesh mesh;
    constexpr int rings = 30, around = 48;
    for (int i = 0; i <= rings; ++i)
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * pi * k / around, radius = 8 + 0.6 * std::sin(0.4 * i);
            mesh.vertices.emplace_back(i, radius * std::cos(angle), radius * std::sin(angle));
        }
    const auto at = [&](int i, int k) { return Index(i * around + k % around); };
    for (int i = 0; i < rings; ++i)
        for (int k = 0; k < around; ++k) {
            mesh.facets.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
            mesh.facets.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
        }
    return mesh;
}

/// A plate of 40 mm with a peg on it, 8 mm round and 18 high.
Mesh peg_on_a_plate(int around) {
    Mesh mesh;
    constexpr int levels = 24, outward = 8;
    for (int i = 0; i < around; ++i) {
        const double angle = 2 * pi * i / around, x = std::cos(angle), y = std::sin(angle);
        for (int k = 0; k <= levels; ++k)
            mesh.vertices.emplace_back(8 * x, 8 * y, 18.0 * (levels - k) / levels);
        const double edge = 20 / std::max(std::abs(x), std::abs(y));
        for (int k = 1; k <= outward; ++k) {
            const double out = 8 + (edge - 8) * k / outward;
            mesh.vertices.emplace_back(out * x, out * y, 0);
        }
    }
    const auto top = Index(mesh.vertices.size());
    mesh.vertices.emplace_back(0, 0, 18);
    constexpr int column = levels + outward + 1;
    const auto at = [&](int i, int k) { return Index(i % around * column + k); };
    for (int i = 0; i < around; ++i) {
        mesh.facets.push_back({at(i, 0), at(i + 1, 0), top});
        for (int k = 0; k + 1 < column; ++k) {
            mesh.facets.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
            mesh.facets.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
        }
    }
    return mesh;
}

std::unique_ptr<Operation> operation_of(const std::string& kind) {
    auto op = make_operation(kind);
    op->common().tolerance = cusp;
    op->common().allowance = 0;
    if (kind == "cleanup") op->set("previous_tool", 2L);
    if (kind == "finish5" || kind == "global_local") op->set("posture", std::string("cm2"));
    return op;
}

Mesh part_for(const std::string& kind) {
    if (kind.starts_with("lathe")) return rod();
    if (kind == "pencil" || kind == "cleanup") return gutter();
    if (kind == "finish5" || kind == "global_local")
        return height_field([](double x, double y) { return 0.6 * std::sin(0.3 * x) * std::cos(0.25 * y); },
                            Vec2(-10, -8), Vec2(10, 8), 20, 16);
    return hollowed();
}
Tool tool_for(const std::string& kind) {
    return kind == "finish5" || kind == "global_local" ? flat_tool(4) : ball_tool(4);
}

PreviewRequest request_for(const Mesh& mesh, const Operation& operation, const Tool& tool,
                           int cells = preview_cells) {
    PreviewRequest request;
    request.context = context_of(mesh, tool);
    if (operation.turning()) {
        request.context.stock_box.lo -= Vec3(0, 2, 2);
        request.context.stock_box.hi += Vec3(0, 2, 2);
        request.context.stock.box = request.context.stock_box;
    } else if (operation.kind() == "rough") {
        request.context.stock_box.hi.z() += 1;
        request.context.stock.box = request.context.stock_box;
    }
    if (operation.turning())
        request.turned =
            std::make_shared<const TurnedGround>(*operation.turning(), request.context, cells, Progress());
    for (const Machine& machine : machines())
        if (!operation.three_axis() && machine.rotary.size() == 2) request.context.machine = machine;
    request.context.further_tools = {ball_tool(8)};
    request.context.further_tools.front().number = 2;
    request.ground =
        std::make_shared<const CoarseGround>(mesh, mesh.facet_count(), Mat3::Identity(), cells, Progress());
    request.travel = travel_direction(operation.common().direction, request.context, Progress());
    return request;
}

PassPreview preview_of(const std::string& kind, const Mesh& mesh, const Tool& tool) {
    const auto op = operation_of(kind);
    return preview_passes(*op, request_for(mesh, *op, tool), Progress());
}

double length_of(const StrategyResult& plan, bool contacts) {
    double sum = 0;
    for (const Pass& pass : plan.passes)
        for (std::size_t i = 1; i < pass.cl.size(); ++i)
            sum += contacts ? (pass.cc[i].point - pass.cc[i - 1].point).norm()
                            : (pass.cl[i].tip - pass.cl[i - 1].tip).norm();
    return sum;
}

Box3 box_of(const PassPreview& preview) {
    Box3 box;
    for (const auto& line : preview.lines)
        for (const Vec3& p : line)
            box.add(p);
    return box;
}

void add_kinds(bool turning) {
    QTest::addColumn<QString>("kind");
    for (const OperationKind& kind : operation_kinds())
        if (turning || !kind.make()->turning())
            QTest::addRow("%s", kind.kind.c_str()) << QString::fromStdString(kind.kind);
}

} // namespace

class TestPassPreview : public QObject {
    Q_OBJECT
private slots:
    void lines_lie_where_the_cutter_touches_data() { add_kinds(false); }
    /// For every kind: within two cells of it the exact tip (the part itself, of contacts) is as high, within
    /// what a cell rises.
    void lines_lie_where_the_cutter_touches() {
        QFETCH(QString, kind);
        const Mesh mesh = part_for(kind.toStdString());
        const Tool tool = tool_for(kind.toStdString());
        const PassPreview preview = preview_of(kind.toStdString(), mesh, tool);
        const bool contacts = kind == "finish5" || kind == "global_local", layers = kind == "rough";
        const CutterProfile cutter(contacts ? AptCutter::flat(1e-4, 50) : tool.cutter());
        const AxialLift exact(std::make_shared<ContactIndex>(std::make_shared<Mesh>(mesh), Progress()),
                              cutter);
        std::size_t seen = 0;
        for (const auto& line : preview.lines)
            for (const Vec3& p : line) {
                double low = infinity, high = -infinity;
                for (int dy = -2; dy <= 2; ++dy)
                    for (int dx = -2; dx <= 2; ++dx) {
                        const double z =
                            exact.tip_z(p.x() + dx * preview.spacing, p.y() + dy * preview.spacing);
                        low = std::min(low, z);
                        high = std::max(high, z);
                    }
                const bool above = p.z() >= low - preview.spacing, below = p.z() <= high + preview.spacing;
                QVERIFY2(above && (below || layers), qPrintable(QString("(%1, %2, %3): exact %4 to %5")
                                                                    .arg(p.x())
                                                                    .arg(p.y())
                                                                    .arg(p.z())
                                                                    .arg(low)
                                                                    .arg(high)));
                ++seen;
            }
        QVERIFY(seen > 20);
        QVERIFY(preview.passes > 0);
        QVERIFY(preview.spacing > 0);
    }

    void passes_are_about_what_is_planned_data() { add_kinds(true); }
    void passes_are_about_what_is_planned() {
        if (under_sanitizer) QSKIP("others make these previews, and plans have checked tests of their own");
        QFETCH(QString, kind);
        const Mesh mesh = part_for(kind.toStdString());
        const auto op = operation_of(kind.toStdString());
        const PreviewRequest request = request_for(mesh, *op, tool_for(kind.toStdString()));
        const PassPreview preview = preview_passes(*op, request, Progress());
        const StrategyResult plan = op->plan(request.context, Progress());
        const bool contacts = kind == "finish5" || kind == "global_local";
        const double planned = length_of(plan, contacts), shown = preview.estimated_length();
        const QString said = QString("%1 mm planned, %2 mm shown; %3 and %4 passes")
                                 .arg(planned)
                                 .arg(shown)
                                 .arg(plan.drive_planes)
                                 .arg(preview.passes);
        // Levels of waterlines have pieces of others between them, which a preview has not.
        const double factor = kind == "waterline" ? 2.5 : 2;
        QVERIFY2(shown > planned / factor && shown < planned * factor, qPrintable(said));
        if (kind == "finish3" || kind == "finish5")
            QVERIFY2(double(preview.passes) > 0.6 * plan.drive_planes
                         && double(preview.passes) < 1.7 * plan.drive_planes,
                     qPrintable(said));
    }

    /// Over a piece of a ring passes from edge to edge go round its middle.
    void passes_from_edge_to_edge_follow_the_ground() {
        const Mesh mesh =
            only(height_field([](double, double) { return 0.0; }, Vec2(-30, 3), Vec2(30, 31), 120, 56),
                 [](const Vec3& p) {
                     const double radius = std::hypot(p.x(), p.y());
                     return radius > 14 && radius < 30 && std::abs(p.x()) < p.y();
                 });
        const auto op = operation_of("finish5");
        op->set("passes", std::string("morph"));
        op->set("direction", std::string("x"));
        const PassPreview preview = preview_passes(*op, request_for(mesh, *op, flat_tool(4)), Progress());
        QVERIFY(preview.passes > 3);
        for (const auto& line : preview.lines) {
            double least = infinity, most = 0;
            for (const Vec3& p : line) {
                least = std::min(least, std::hypot(p.x(), p.y()));
                most = std::max(most, std::hypot(p.x(), p.y()));
            }
            QVERIFY2(most - least < 2, qPrintable(QString("%1 to %2").arg(least).arg(most)));
        }
    }

    void rings_go_about_what_goes_round_data() {
        QTest::addColumn<int>("around");
        QTest::newRow("as it is") << 60;
        QTest::newRow("made coarser") << 600;
    }
    /// About a peg on a plate they are level and closed; the plate itself is cut from edge to edge.
    void rings_go_about_what_goes_round() {
        QFETCH(int, around);
        const Mesh mesh = peg_on_a_plate(around);
        const auto op = operation_of("finish5");
        op->set("passes", std::string("around"));
        const PreviewRequest request = request_for(mesh, *op, ball_tool(3));
        const PassPreview preview = preview_passes(*op, request, Progress());
        std::size_t rings = 0, others = 0;
        for (const auto& line : preview.lines) {
            Box3 box;
            for (const Vec3& p : line)
                box.add(p);
            if (box.lo.z() > 1.5 && box.hi.z() < 17.5) {
                ++rings;
                QVERIFY((line.front() - line.back()).norm() < 1e-9);
                QVERIFY2(box.size().z() < 2 * preview.spacing, qPrintable(QString::number(box.size().z())));
                for (const Vec3& p : line)
                    QVERIFY(std::hypot(p.x(), p.y()) < 8 + preview.spacing);
            } else if (box.hi.z() < 0.5) {
                ++others;
            }
        }
        const double apart = preview.step;
        QVERIFY2(double(rings) > 0.6 * 16 / apart && double(rings) < 1.5 * 16 / apart,
                 qPrintable(QString("%1 rings %2 apart").arg(rings).arg(apart)));
        QVERIFY(others > 3);
        op->set("passes", std::string("morph"));
        for (const auto& line : preview_passes(*op, request, Progress()).lines)
            QVERIFY((line.front() - line.back()).norm() > 1e-9);
    }

    void any_number_of_threads_makes_the_same_lines_data() { add_kinds(true); }
    void any_number_of_threads_makes_the_same_lines() {
        QFETCH(QString, kind);
        const Mesh mesh = part_for(kind.toStdString());
        const PassPreview many = preview_of(kind.toStdString(), mesh, tool_for(kind.toStdString()));
        set_thread_count(1);
        const PassPreview one = preview_of(kind.toStdString(), mesh, tool_for(kind.toStdString()));
        set_thread_count(0);
        QVERIFY(!one.lines.empty());
        QVERIFY(many.lines == one.lines);
    }

    void a_preview_can_be_cancelled_data() { add_kinds(true); }
    void a_preview_can_be_cancelled() {
        QFETCH(QString, kind);
        const auto op = operation_of(kind.toStdString());
        const PreviewRequest request =
            request_for(part_for(kind.toStdString()), *op, tool_for(kind.toStdString()));
        Job job;
        QVERIFY(cancelled_at(job, 0.3, [&](const Progress& p) { preview_passes(*op, request, p); }));
    }

    void a_boundary_holds_the_contacts_or_the_tips() {
        const Mesh mesh = hollowed();
        const auto op = operation_of("finish3");
        PreviewRequest request = request_for(mesh, *op, ball_tool(4));
        const CoarseGrid& grid = request.ground->grid();
        request.asked.resize(grid.size());
        for (std::size_t i = 0; i < grid.size(); ++i)
            request.asked[i] = grid.middle(i).x() < 3;
        const double all = preview_passes(*op, request_for(mesh, *op, ball_tool(4)), Progress()).length();
        op->common().contain = Containment::tip;
        const PassPreview tips = preview_passes(*op, request, Progress());
        QVERIFY(box_of(tips).hi.x() < 3 + tips.spacing);
        QVERIFY(tips.length() < 0.75 * all && tips.length() > 0.4 * all);
        op->common().contain = Containment::tool;
        QVERIFY(box_of(preview_passes(*op, request, Progress())).hi.x() < 1 + tips.spacing);
    }

    void what_is_avoided_is_kept_off() {
        const auto op = operation_of("finish3");
        op->common().avoid_distance = 1;
        PreviewRequest request = request_for(hollowed(), *op, ball_tool(4));
        const CoarseGrid& grid = request.ground->grid();
        request.avoided.resize(grid.size());
        for (std::size_t i = 0; i < grid.size(); ++i)
            request.avoided[i] = grid.middle(i).x() > 5;
        QVERIFY(box_of(preview_passes(*op, request, Progress())).hi.x() < 2 + 2 * grid.cell);
    }

    void levels_keep_to_the_slopes_asked_for() {
        const auto op = operation_of("waterline");
        const PassPreview preview =
            preview_passes(*op, request_for(hollowed(), *op, ball_tool(4)), Progress());
        // Steep is only the flank of the hollow, about 6 mm from the middle; the tip of a ball runs inside
        // it.
        for (const auto& line : preview.lines)
            for (const Vec3& p : line)
                QVERIFY2(std::hypot(p.x(), p.y()) < 9, qPrintable(QString("%1 %2").arg(p.x()).arg(p.y())));
        for (const auto& line : preview.lines)
            for (const Vec3& p : line)
                QCOMPARE(p.z(), line.front().z());
    }

    void walls_round_a_block_have_levels_and_borders_of_sheets_have_none() {
        const auto op = operation_of("waterline");
        const PassPreview block = preview_passes(
            *op, request_for(box(Vec3(0, 0, -6), Vec3(20, 10, 0)), *op, ball_tool(4)), Progress());
        double deepest = 0;
        for (const auto& line : block.lines)
            deepest = std::min(deepest, line.front().z());
        QVERIFY2(deepest < -3, qPrintable(QString::number(deepest)));
        const Mesh sheet =
            height_field([](double x, double) { return 0.02 * x; }, Vec2(0, 0), Vec2(20, 10), 20, 10);
        QCOMPARE(code_of([&] { preview_passes(*op, request_for(sheet, *op, ball_tool(4)), Progress()); }),
                 std::string(code_name(ErrorCode::empty_result)));
    }

    void a_pencil_runs_along_the_bottom_of_a_gutter() {
        auto op = operation_of("pencil");
        op->set("side_passes", 0L);
        const PassPreview preview = preview_passes(*op, request_for(gutter(), *op, ball_tool(4)), Progress());
        QCOMPARE(preview.passes, std::size_t(1));
        double length = 0;
        for (const auto& line : preview.lines)
            for (std::size_t i = 0; i < line.size(); ++i) {
                QVERIFY(std::abs(line[i].y()) < 1.5 * preview.spacing);
                if (i > 0) length += (line[i] - line[i - 1]).norm();
            }
        QVERIFY2(length > 25, qPrintable(QString::number(length)));
    }

    void scallops_begin_where_they_are_asked() {
        const Mesh mesh = hollowed();
        const auto op = operation_of("scallop");
        const Tool tool = ball_tool(4);
        PreviewRequest request = request_for(mesh, *op, tool);
        // Nothing goes round a place as near as the passes from the border would.
        const auto nearest = [&](const Vec2& p) {
            double best = infinity;
            for (const auto& line : preview_passes(*op, request, Progress()).lines)
                for (std::size_t i = 1; i < line.size(); ++i) {
                    const Vec2 a = line[i - 1].head<2>(), d = line[i].head<2>() - a;
                    const double t = std::clamp((p - a).dot(d) / std::max(d.squaredNorm(), 1e-12), 0.0, 1.0);
                    best = std::min(best, (a + t * d - p).norm());
                }
            return best;
        };
        op->set("from", std::string("place"));
        op->set("place", std::array<double, 3>{9, 7, 0});
        const double half = 0.5 * preview_passes(*op, request, Progress()).step;
        const double round = nearest(Vec2(9, 7));
        QVERIFY2(std::abs(round - half) < 0.4 * half, qPrintable(QString::number(round / half)));
        op->set("from", std::string("curve"));
        request.context.curves = {{"Line", {{{Vec2(-14, 9), Vec2(14, 9)}, false}}}};
        QVERIFY(nearest(Vec2(3, 9)) < 0.1);
        request.context.curves = {{"Line", {{{Vec2(-14, 90), Vec2(14, 90)}, false}}}};
        QCOMPARE(code_of([&] { preview_passes(*op, request, Progress()); }),
                 std::string(code_name(ErrorCode::out_of_range)));
        // A closed pass of a spiral and what is shallow of a divided part are shown as well.
        const auto both = operation_of("steep_shallow");
        const double parallel = preview_passes(*both, request, Progress()).length();
        both->set("shallow", std::string("scallop"));
        const double scallop = preview_passes(*both, request, Progress()).length();
        QVERIFY(scallop != parallel && scallop > 0.5 * parallel && scallop < 2 * parallel);
    }

    void settings_that_make_no_passes_are_said() {
        const auto code = [](const std::string& kind, const char* key, const ParameterValue& value,
                             const Mesh& mesh) {
            const auto op = operation_of(kind);
            op->set(key, value);
            return code_of([&] { preview_passes(*op, request_for(mesh, *op, ball_tool(4)), Progress()); });
        };
        const Mesh mesh = hollowed();
        QCOMPARE(code("morph", "first_curve", std::string("Edge"), mesh),
                 std::string(code_name(ErrorCode::missing_reference)));
        QCOMPARE(code("radial", "from_radius", 90.0, mesh), std::string(code_name(ErrorCode::out_of_range)));
        QCOMPARE(code("pencil", "side_passes", 1L, box(Vec3(0, 0, 0), Vec3(9, 9, 2))),
                 std::string(code_name(ErrorCode::empty_result)));
        QCOMPARE(code("finish3", "tolerance", 0.0001, mesh), std::string("none"));
    }

    void more_lines_than_can_be_told_apart_are_thinned() {
        auto op = operation_of("finish3");
        op->set("stepover", 0.005);
        const PassPreview preview =
            preview_passes(*op, request_for(hollowed(), *op, ball_tool(4)), Progress());
        QVERIFY(preview.drawn_every > 1);
        QVERIFY(preview.passes > 4000);
        QVERIFY(preview.lines.size() < 2000);
        QVERIFY(preview.estimated_length() > 100'000);
    }
};

FACETMILL_TEST(TestPassPreview)
#include "test_pass_preview.moc"
