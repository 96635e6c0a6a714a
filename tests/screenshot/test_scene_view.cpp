// Views, fitting, picking, and the picture that the command line draws.
#include "tests/screenshot/scene_parts.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "viz/offscreen.h"
#include "viz/render_picture.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <vtkCamera.h>

using namespace facetmill;
using namespace facetmill::test;

namespace {

std::shared_ptr<const OperationResult> short_operation() {
    auto operation = std::make_shared<OperationResult>();
    const PathSource path = hill_path(9, 30, 6);
    operation->name = "Finish";
    operation->path = *path.contacts;
    operation->program.motions = *path.motions;
    operation->program.tool_number = 3;
    return operation;
}

RenderRequest hill_request(int width = 200, int height = 150) {
    RenderRequest request;
    request.part = hill_part();
    request.width = width;
    request.height = height;
    return request;
}

std::size_t count_colored(const Picture& p, const std::array<int, 3>& color, int within) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < p.rgb.size(); i += 3)
        n += std::abs(p.rgb[i] - color[0]) <= within && std::abs(p.rgb[i + 1] - color[1]) <= within
             && std::abs(p.rgb[i + 2] - color[2]) <= within;
    return n;
}
constexpr std::array<int, 3> cut_blue{0x00, 0x5F, 0xA8}, cutter_yellow{0xE2, 0xB1, 0x3C};

} // namespace

class TestSceneView : public QObject {
    Q_OBJECT

    OffscreenWindow window_;

private slots:
    void standard_views_look_where_they_say() {
        Scene scene;
        scene.part().set(box_part({0, 0, 0}, {100, 60, 30}));
        window_.show(scene, 400, 300);
        struct Expected {
            StandardView view;
            Vec3 right, up; // directions on the screen
        };
        const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
        for (const Expected& e : {Expected{StandardView::front, x, z}, Expected{StandardView::rear, -x, z},
                                  Expected{StandardView::right, y, z}, Expected{StandardView::left, -y, z},
                                  Expected{StandardView::top, x, y}, Expected{StandardView::bottom, -x, y}}) {
            scene.set_view(e.view);
            const Vec3 c(50, 30, 15);
            const Vec2 at = scene.camera().display_of(c), r = scene.camera().display_of(c + e.right) - at,
                       u = scene.camera().display_of(c + e.up) - at;
            QVERIFY2(r.x() > 0.5 && std::abs(r.y()) < 1e-9, view_name(e.view).data());
            QVERIFY2(u.y() < -0.5 && std::abs(u.x()) < 1e-9, view_name(e.view).data()); // y runs down
            QVERIFY(std::abs(r.norm() - u.norm()) < 1e-9); // the same scale both ways
        }
        scene.set_view(StandardView::iso);
        const Vec2 o = scene.camera().display_of({0, 0, 0});
        QVERIFY((scene.camera().display_of(z) - o).y() < 0
                && std::abs((scene.camera().display_of(z) - o).x()) < 1e-9);
        QVERIFY((scene.camera().display_of(x) - o).x() > 0 && (scene.camera().display_of(y) - o).x() > 0);
    }

    void fitting_shows_everything_and_is_tight() {
        for (const auto& [w, h] : {std::pair(640, 480), {300, 600}, {800, 200}, {120, 90}})
            for (const Vec3& size :
                 {Vec3(100, 60, 30), Vec3(500, 1, 1), Vec3(1, 1, 400), Vec3(0.001, 0.002, 0.001)})
                for (const StandardView view : standard_views()) {
                    Scene scene;
                    scene.part().set(box_part({7, 8, 9}, Vec3(7, 8, 9) + size));
                    scene.set_title("Box");
                    window_.show(scene, w, h);
                    scene.set_view(view);
                    const Box3 b = scene.bounds();
                    Vec2 lo(infinity, infinity), hi = -lo;
                    const int s =
                        w * 2 > 16384 ? 1 : 2; // device pixels of the off-screen window per picture pixel
                    for (int c = 0; c < 8; ++c) {
                        const Vec2 p = scene.camera().display_of({c & 1 ? b.hi.x() : b.lo.x(),
                                                                  c & 2 ? b.hi.y() : b.lo.y(),
                                                                  c & 4 ? b.hi.z() : b.lo.z()})
                                       / s;
                        lo = lo.cwiseMin(p);
                        hi = hi.cwiseMax(p);
                    }
                    QVERIFY(lo.x() >= 0 && lo.y() >= 0 && hi.x() <= w && hi.y() <= h);
                    QVERIFY((hi - lo).x() > 0.3 * w || (hi - lo).y() > 0.3 * h);
                }
    }

    /// As the cube of a view does, which stands above the scale.
    void fitting_keeps_clear_of_what_is_covered() {
        const LayoutRect cube{520, 300, 630, 420};
        const Box3 slab{{0, 0, 0}, {300, 300, 10}};
        for (const StandardView view : {StandardView::iso, StandardView::top, StandardView::front}) {
            Scene scene;
            scene.part().set(box_part(slab.lo, slab.hi));
            window_.show(scene, 640, 480);
            scene.set_view(view);
            scene.fit();
            const double ratio = double(scene.camera().window_size().x()) / 640;
            if (view == StandardView::top) QVERIFY(scene.camera().shadow_meets(slab, cube, ratio));
            scene.set_covered({cube.x0, cube.y0}, {cube.x1, cube.y1});
            scene.fit();
            QVERIFY2(!scene.camera().shadow_meets(slab, cube, ratio), view_name(view).data());
            QVERIFY(scene.camera().shadow_meets(slab, {310, 230, 330, 250}, ratio));
        }
    }

    void fitting_an_empty_scene_is_harmless() {
        Scene scene;
        window_.show(scene, 300, 200);
        scene.fit();
        QVERIFY(scene.camera().vtk()->GetParallelScale() > 0);
        QVERIFY(scene.bounds().empty());
        QVERIFY(!scene.part().pick(150, 100));
        QVERIFY(!scene.paths().pick(150, 100, 1000));
        Scene never_shown;
        never_shown.part().set(hill_part());
        never_shown.fit();
        QVERIFY(!never_shown.part().pick(10, 10));
        QCOMPARE(never_shown.camera().display_of({1, 2, 3}), Vec2(0, 0));
    }

    void bounds_follow_the_layers() {
        Scene scene;
        scene.part().set(box_part({0, 0, 0}, {10, 10, 10}));
        scene.stock().set_box({{-1, -1, 0}, {11, 11, 12}});
        scene.paths().set(prepare_path_display({hill_path(5, 9, 2)}, {}));
        QVERIFY(scene.bounds().hi.x() > 90);
        scene.set_visible(Layer::cc, false);
        scene.set_visible(Layer::cl, false);
        QCOMPARE(scene.bounds().hi, Vec3(11, 11, 12));
        scene.set_visible(Layer::stock, false);
        QCOMPARE(scene.bounds().hi, Vec3(10, 10, 10));
        Tool tool;
        tool.diameter = 4;
        tool.flute_length = 20;
        tool.shank_diameter = 4;
        tool.shank_length = 10;
        scene.tool().set(tool);
        QVERIFY(!scene.has(Layer::tool)); // no pose yet
        scene.tool().set_pose(CutterLocation{Vec3(5, 5, 10), Vec3(0, 0, 1)});
        QVERIFY(scene.has(Layer::tool));
        QCOMPARE(scene.bounds().hi, Vec3(10, 10, 10));
        QCOMPARE(scene.bounds(true).hi, Vec3(10, 10, 40));
        scene.tool().set_pose(CutterLocation{Vec3(5, 5, 10), Vec3(1, 0, 0)});
        QCOMPARE(scene.bounds(true).hi, Vec3(35, 10, 12));
        scene.tool().set(std::nullopt);
        QVERIFY(!scene.has(Layer::tool));
    }

    void zooming_keeps_the_point_under_the_cursor() {
        Scene scene;
        scene.part().set(hill_part());
        window_.show(scene, 400, 300);
        scene.set_view(StandardView::iso);
        const Vec3 p(20, 70, 3);
        const Vec2 before = scene.camera().display_of(p);
        const double scale = scene.camera().vtk()->GetParallelScale();
        scene.camera().zoom_at(before.x(), before.y(), 2.5);
        QVERIFY((scene.camera().display_of(p) - before).norm() < 1e-6);
        QVERIFY(std::abs(scene.camera().vtk()->GetParallelScale() * 2.5 - scale) < 1e-9 * scale);
        scene.camera().zoom_at(1, 1, 0);
        scene.camera().zoom_at(1, 1, -2);
        scene.camera().zoom_at(1, 1, infinity);
        QVERIFY((scene.camera().display_of(p) - before).norm() < 1e-6);
        scene.camera().center_on(p);
        const Vec2 middle = scene.camera().display_of(p);
        QVERIFY((middle - Vec2(400, 300)).norm() < 1e-6); // half of 2 x 400 by 2 x 300 device pixels
    }

    void picks_the_first_facet_under_a_pixel() {
        Scene scene;
        scene.part().set(box_part({0, 0, 0}, {100, 60, 30}));
        window_.show(scene, 400, 300);
        for (const StandardView view : standard_views()) {
            scene.set_view(view);
            for (const Vec3& p : {Vec3(99, 20, 11), Vec3(33, 59, 7), Vec3(1, 41, 22), Vec3(71, 1, 5),
                                  Vec3(40, 22, 29), Vec3(61, 17, 1)}) {
                const Vec2 at = scene.camera().display_of(p);
                const auto pick = scene.part().pick(at.x(), at.y());
                QVERIFY(pick);
                const Vec2 back = scene.camera().display_of(pick->point);
                QVERIFY((back - at).norm() < 1e-6);
                QVERIFY(!pick->back_side);
                // On the box, and no point of it lies nearer to the eye.
                const Vec3 toward =
                    Vec3(scene.camera().vtk()->GetPosition()) - Vec3(scene.camera().vtk()->GetFocalPoint());
                QVERIFY(pick->normal.dot(toward) > 0);
                QVERIFY((pick->point - p).dot(toward.normalized()) > 0);
            }
            QVERIFY(!scene.part().pick(1, 1));
        }
        scene.part().set(hill_part());
        scene.set_view(StandardView::bottom);
        const Vec2 at = scene.camera().display_of({30, 30, hill(30, 30)});
        const auto pick = scene.part().pick(at.x(), at.y());
        QVERIFY(pick && pick->back_side);
        const Mesh& mesh = *hill_part();
        QVERIFY((pick->normal - mesh.facet_normal(pick->facet)).norm() < 1e-12);
    }

    void picks_on_a_part_far_from_the_origin() {
        const Vec3 far(3e6, -2e6, 1e6);
        Scene scene;
        scene.part().set(moved(hill_part(), far));
        window_.show(scene, 400, 300);
        scene.set_view(StandardView::top);
        const Vec2 at = scene.camera().display_of(far + Vec3(55, 38, 18));
        const auto pick = scene.part().pick(at.x(), at.y());
        QVERIFY(pick && (pick->point - far - Vec3(55, 38, 18)).norm() < 0.05);
    }

    void picks_the_nearest_visible_path_point() {
        const PathSource path = hill_path(17, 60, 6);
        Scene scene;
        scene.part().set(hill_part());
        scene.paths().set(prepare_path_display({path}, {}));
        window_.show(scene, 800, 600);
        scene.set_view(StandardView::top);
        scene.set_visible(Layer::cl, false);
        const Pass& pass = path.contacts->passes[8];
        const Vec2 at = scene.camera().display_of(pass.cc[12].point);
        auto pick = scene.paths().pick(at.x() + 2, at.y() - 1, 8);
        QVERIFY(pick && pick->is_contact && pick->pass == 8 && pick->point == 12);
        QCOMPARE(pick->position, pass.cc[12].point);
        QCOMPARE(pick->location.tip, pass.cl[12].tip);
        QVERIFY(!scene.paths().pick(3, 3, 8));

        scene.set_visible(Layer::cl, true);
        scene.set_visible(Layer::cc, false);
        const Vec2 tip = scene.camera().display_of(pass.cl[30].tip);
        pick = scene.paths().pick(tip.x(), tip.y(), 8);
        QVERIFY(pick && !pick->is_contact && pick->pass == 8 && pick->point == 30);
        QCOMPARE(path.motions->motions[pick->motion].to.tip, pass.cl[30].tip);
        scene.paths().set_visible(MotionKind::cut, false);
        pick = scene.paths().pick(tip.x(), tip.y(), 8);
        QVERIFY(!pick);

        // From below, the path lies behind the part; without the part it can be picked.
        scene.set_visible(Layer::cc, true);
        scene.part().set(moved(hill_part(), {0, 0, -3}));
        scene.set_view(StandardView::bottom);
        const Vec2 below = scene.camera().display_of(pass.cc[12].point);
        QVERIFY(!scene.paths().pick(below.x(), below.y(), 2));
        scene.set_visible(Layer::part, false);
        QVERIFY(scene.paths().pick(below.x(), below.y(), 2));
    }

    void words_of_views_layers_and_sizes() {
        for (const StandardView v : standard_views()) {
            QVERIFY(parse_view(view_name(v), "--view") == v);
            QVERIFY(!view_label(v).empty());
        }
        QCOMPARE(standard_views().size(), std::size_t(7));
        QCOMPARE(code_of([] { parse_view("Top", "--view"); }), std::string("out_of_range"));
        QCOMPARE(code_of([] { parse_view("", "--view"); }), std::string("out_of_range"));
        for (const Layer l : all_layers())
            QVERIFY(!layer_name(l).empty() && !layer_label(l).empty());

        QCOMPARE(parse_picture_layers("part,stock, cc ,cl,tool,strips,part", "--show"),
                 (std::vector<Layer>{Layer::part, Layer::stock, Layer::cc, Layer::cl, Layer::tool,
                                     Layer::strips}));
        for (const char* word : {"cspace", "part,cspace"})
            QCOMPARE(code_of([&] { parse_picture_layers(word, "--show"); }),
                     std::string("unsupported_format"));
        for (const char* word : {"", ",", "part,", "parts", "legend", "part;cl", "\xff\n"})
            QCOMPARE(code_of([&] { parse_picture_layers(word, "--show"); }), std::string("out_of_range"));

        QCOMPARE(parse_picture_size("1200x900", "--size").width, 1200);
        QCOMPARE(parse_picture_size("1X16384", "--size").height, 16384);
        for (const char* word : {"", "x", "12", "12x", "x12", "0x5", "-3x5", "5x16385", "16384x16384",
                                 "1e3x5", "5x5x5", " 5x5", "99999999999999999999x5", "5.5x5"})
            QCOMPARE(code_of([&] { parse_picture_size(word, "--size"); }), std::string("out_of_range"));
    }

    void the_command_lines_picture() {
        RenderRequest request = hill_request();
        const Picture part = render_picture(request, {});
        QCOMPARE(part.width, 200);
        QCOMPARE(part.height, 150);
        QCOMPARE(count_colored(part, cut_blue, 16), std::size_t(0));

        Project project;
        project.unit = LengthUnit::inch;
        project.part.file = "hill.stl";
        project.tools.resize(2);
        project.tools[1].number = 3;
        project.tools[1].diameter = 12;
        project.tools[1].corner_radius = 6;
        PlanResult plan;
        auto prepared = std::make_shared<PreparedPart>();
        prepared->mesh = request.part;
        plan.part = prepared;
        plan.stock.box = {{-5, -5, 0}, {105, 85, 20}};
        plan.operations = {short_operation()};
        take_plan(request, project, plan);
        QVERIFY(request.title.find("hill") != std::string::npos
                && request.title.find("Finish") != std::string::npos);
        QVERIFY(request.tool && request.tool->number == 3);
        QCOMPARE(request.unit, LengthUnit::inch);
        request.layers = {Layer::part, Layer::cl};
        QVERIFY(count_colored(render_picture(request, {}), cut_blue, 16) > 30);
        request.layers = {Layer::part, Layer::tool};
        const Picture tool = render_picture(request, {});
        QCOMPARE(count_colored(tool, cut_blue, 16), std::size_t(0));
        QVERIFY(count_colored(tool, cutter_yellow, 60) > 10);

        const QTemporaryDir folder;
        const std::string file = folder.filePath("out.png").toStdString();
        write_png(tool, file);
        QCOMPARE(read_png(file).rgb, tool.rgb);
        QCOMPARE(encode_png(tool), encode_png(read_png(file)));
    }

    void a_layer_without_content_is_an_error() {
        for (const Layer layer : {Layer::stock, Layer::cc, Layer::cl, Layer::tool}) {
            RenderRequest request = hill_request();
            request.layers.push_back(layer);
            QCOMPARE(code_of([&] { render_picture(request, {}); }), std::string("empty_result"));
        }
        RenderRequest nothing;
        QCOMPARE(code_of([&] { render_picture(nothing, {}); }), std::string("empty_result"));
        QCOMPARE(code_of([&] { render_picture(hill_request(0, 5), {}); }), std::string("out_of_range"));
        QCOMPARE(code_of([&] { render_picture(hill_request(20'000, 5), {}); }), std::string("out_of_range"));
        Job job;
        job.cancel();
        QVERIFY_EXCEPTION_THROWN(render_picture(hill_request(), Progress(job)), Cancelled);
    }

    void bad_picture_files() {
        const QTemporaryDir folder;
        const auto path = [&](const char* name) { return folder.filePath(name).toStdString(); };
        QCOMPARE(code_of([&] { read_png(path("none.png")); }), std::string("not_found"));
        QFile text(folder.filePath("text.png"));
        QVERIFY(text.open(QIODevice::WriteOnly));
        text.write("solid nothing");
        text.close();
        QCOMPARE(code_of([&] { read_png(path("text.png")); }), std::string("unsupported_format"));
        QCOMPARE(code_of([&] {
                     write_png(Picture{1, 1, {1, 2, 3}}, path("no/such/folder.png"));
                 }),
                 std::string("unwritable"));
    }
};

FACETMILL_TEST(TestSceneView)
#include "test_scene_view.moc"
