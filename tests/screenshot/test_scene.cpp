// Scenes drawn off-screen, held against baseline pictures.
#include "core/mesh/sample.h"
#include "tests/screenshot/scene_parts.h"
#include "tests/support/part_meshes.h"
#include "tests/support/picture_compare.h"
#include "tests/support/test_runner.h"
#include "viz/offscreen.h"
#include "viz/scene_actor.h"
#include "viz/scene_renderer.h"
#include "viz/strip_display.h"

#include <QDir>
#include <QTest>

#include <vtkRenderWindow.h>
#include <vtkRendererCollection.h>

#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

Tool ball_tool() {
    Tool tool;
    tool.diameter = 12;
    tool.corner_radius = 6;
    tool.flute_length = 22;
    tool.shank_diameter = 10;
    tool.shank_length = 14;
    tool.holder = {{22, 10}, {30, 8}};
    return tool;
}

/// Part, stock, path, tool and marker.
void fill(Scene& scene) {
    const PathSource path = hill_path(17, 60, 6);
    scene.part().set(hill_part());
    scene.stock().set_box({{-5, -5, 0}, {105, 85, 22}});
    scene.paths().set(prepare_path_display({path}, {}));
    const Pass& pass = path.contacts->passes[12];
    scene.tool().set(ball_tool());
    scene.tool().set_pose(pass.cl[20]);
    scene.marks().set_marker(Marker{pass.cc[20].point, pass.cc[20].normal});
    scene.set_title("Hill", "100 \u00d7 80 \u00d7 18 mm");
}

void show_only(Scene& scene, const std::vector<Layer>& layers) {
    for (const Layer l :
         {Layer::part, Layer::edges, Layer::stock, Layer::cc, Layer::cl, Layer::tool, Layer::marker})
        scene.set_visible(l, std::find(layers.begin(), layers.end(), l) != layers.end());
}

} // namespace

class TestScene : public QObject {
    Q_OBJECT

    OffscreenWindow window_;

    Picture drawn(Scene& scene, int width = 480, int height = 360, StandardView view = StandardView::iso) {
        window_.show(scene, width, height);
        scene.set_view(view);
        return window_.render();
    }
    void check(Scene& scene, const char* name, int width = 480, int height = 360,
               StandardView view = StandardView::iso) {
        const Picture picture = drawn(scene, width, height, view);
        QCOMPARE(picture.width, width);
        QCOMPARE(picture.height, height);
        const std::string wrong = check_picture(picture, name, FACETMILL_PICTURE_OUT);
        QVERIFY2(wrong.empty(), wrong.c_str());
    }

private slots:
    void sample_part() {
        Scene scene;
        scene.set_unit(LengthUnit::inch);
        scene.part().set(make_sample("concave", default_sample_tolerance, {}));
        scene.set_title("concave.stl", "10 \u00d7 10 in");
        check(scene, "part-smooth");
    }
    void flat_with_edges() {
        Scene scene;
        scene.part().set(sheet_part({0, 0}, {hill_length, hill_width}, 16, hill));
        scene.part().set_style(PartStyle::flat);
        scene.set_visible(Layer::edges, true);
        check(scene, "part-flat-edges");
    }
    void wire() {
        Scene scene;
        scene.part().set(sheet_part({0, 0}, {hill_length, hill_width}, 16, hill));
        scene.part().set_style(PartStyle::wire);
        check(scene, "part-wire");
    }
    void back_side_has_its_own_color() {
        Scene scene;
        scene.part().set(hill_part());
        check(scene, "part-back", 480, 360, StandardView::bottom);
    }
    void stock_around_a_block() {
        Scene scene;
        scene.part().set(box_part({0, 0, 0}, {60, 40, 25}));
        scene.stock().set_box({{-8, -8, 0}, {68, 48, 30}}); // shares the part's bottom plane
        check(scene, "stock");
        check(scene, "stock-front", 480, 360, StandardView::front);
        check(scene, "stock-bottom", 480, 360, StandardView::bottom);
    }
    void round_and_cast_stock() {
        Scene scene;
        scene.part().set(box_part({0, 0, 0}, {60, 40, 25}));
        StockSolid solid;
        solid.kind = StockSolid::Kind::cylinder;
        solid.box = {{-10, -20, 0}, {70, 60, 30}};
        solid.radius = 40;
        scene.stock().set(make_stock_shape(solid, {}));
        check(scene, "stock-round");
        solid.axis = 0;
        solid.box = {{-5, -10, -17.5}, {65, 50, 42.5}};
        solid.radius = 30;
        scene.stock().set(make_stock_shape(solid, {}));
        check(scene, "stock-lying");
        solid.kind = StockSolid::Kind::mesh;
        auto raw = std::make_shared<Mesh>(*box_part({-15, -15, 0}, {75, 55, 32}));
        for (Vec3& p : raw->vertices) // sides that lean
            if (p.z() > 1) p = Vec3(30 + 0.8 * (p.x() - 30), 20 + 0.8 * (p.y() - 20), p.z());
        solid.mesh = raw;
        solid.box = raw->box();
        scene.stock().set(make_stock_shape(solid, {}));
        check(scene, "stock-cast");
        QVERIFY(scene.has(Layer::stock));
        scene.stock().set(make_stock_shape(StockSolid(), {}));
        QVERIFY(!scene.has(Layer::stock));
    }
    /// What was higher is seen, what is the same is not.
    void the_part_before() {
        Scene scene;
        scene.part().set(box_part({0, 0, 0}, {60, 40, 25}));
        scene.former().set(prepare_part_display(box_part({0, 0, 0}, {45, 40, 34}), {}));
        check(scene, "part-before");
        QCOMPARE(scene.bounds().hi.z(), 25.0);
        const Picture both = drawn(scene);
        scene.set_visible(Layer::part, false);
        QVERIFY(drawn(scene).rgb != both.rgb);
        scene.set_visible(Layer::part, true);
        scene.former().set(nullptr);
        QVERIFY(!scene.former().any() && drawn(scene).rgb != both.rgb);
    }
    void path_layers() {
        Scene scene;
        fill(scene);
        show_only(scene, {Layer::part, Layer::cl});
        check(scene, "path-cl");
        show_only(scene, {Layer::part, Layer::cc});
        check(scene, "path-cc", 480, 360, StandardView::top);
        show_only(scene, {Layer::cl});
        scene.paths().set_visible(MotionKind::cut, false);
        check(scene, "path-without-cuts");
    }
    void tool_at_a_point() {
        Scene scene;
        fill(scene);
        show_only(scene, {Layer::part, Layer::tool, Layer::marker});
        window_.show(scene, 480, 360);
        scene.set_view(StandardView::iso);
        scene.fit(true);
        const std::string wrong = check_picture(window_.render(), "tool", FACETMILL_PICTURE_OUT);
        QVERIFY2(wrong.empty(), wrong.c_str());
    }
    void tilted_bull_nose() {
        Scene scene;
        scene.part().set(box_part({-30, -30, -10}, {30, 30, 0}));
        Tool tool = ball_tool();
        tool.corner_radius = 2;
        scene.tool().set(tool);
        scene.tool().set_pose(CutterLocation{Vec3(0, 0, 0), Vec3(0.5, -0.2, 1).normalized()});
        window_.show(scene, 360, 360);
        scene.set_view(StandardView::front);
        scene.fit(true);
        const std::string wrong = check_picture(window_.render(), "tool-tilted", FACETMILL_PICTURE_OUT);
        QVERIFY2(wrong.empty(), wrong.c_str());
    }
    void everything_light_and_dark() {
        Scene scene;
        fill(scene);
        check(scene, "all-light", 640, 480);
        scene.set_palette(Palette::dark);
        check(scene, "all-dark", 640, 480);
    }
    void empty_scene() {
        Scene scene;
        scene.set_empty_text("Open a mesh, or drop one here");
        check(scene, "empty");
        scene.set_palette(Palette::dark);
        check(scene, "empty-dark", 240, 160);
    }
    void long_names_are_shortened() {
        Scene scene;
        fill(scene);
        scene.set_title(
            "a-very-long-name-of-a-fixture-that-nobody-would-type-twice-but-somebody-did-revision-b.stl",
            "\u00c4\u00d6\u00dc \u00e9\u00e8 123.456 \u00d7 234.567 \u00d7 345.678 mm, tool number 12, and "
            "what else there is to say about it");
        check(scene, "long-names");
        check(scene, "long-names-narrow", 200, 360);
    }
    void small_windows() {
        Scene scene;
        fill(scene);
        check(scene, "small", 160, 120);
        check(scene, "tiny", 48, 32);
        check(scene, "flat-window", 480, 60);
        QCOMPARE(drawn(scene, 1, 1).rgb.size(), std::size_t(3)); // and nothing breaks
        drawn(scene, 3, 700);
    }

    void the_same_every_time() {
        Scene scene;
        fill(scene);
        const Picture first = drawn(scene);
        Scene again;
        fill(again);
        QCOMPARE(different_pixels(first, drawn(again)), std::size_t(0));
        OffscreenWindow other;
        other.show(scene, 480, 360);
        scene.set_view(StandardView::iso);
        QCOMPARE(different_pixels(first, other.render()), std::size_t(0));
    }

    void a_part_of_more_or_fewer_pieces_leaves_nothing_of_the_one_before() {
        const auto wave = [](double x, double y) { return 3 * std::sin(x / 9) * std::cos(y / 7); };
        Scene one;
        for (const int cells : {250, 150, 280}) { // 125, 45 and 157 thousand facets
            const auto part =
                std::make_shared<Mesh>(height_field(wave, Vec2(0, 0), Vec2(cells / 4.0, 60), cells, cells));
            QVERIFY(part->facets.size() > elements_in_piece);
            Scene fresh;
            for (Scene* scene : {&one, &fresh}) {
                scene->set_visible(Layer::edges, true);
                scene->part().set(part);
            }
            QCOMPARE(different_pixels(drawn(fresh), drawn(one)), std::size_t(0));
        }
    }

    // A float far from the origin is coarse; the scene draws relative to the part's middle.
    void a_part_far_from_the_origin_looks_the_same() {
        Scene near, far;
        near.part().set(hill_part());
        far.part().set(moved(hill_part(), {2e6, -3e6, 1e6}));
        const PictureDifference d = compare_pictures(drawn(near), drawn(far));
        QVERIFY2(d.worst > min_similarity, qPrintable(QString::number(d.worst)));
    }

    void layers_show_and_hide() {
        Scene scene;
        fill(scene);
        const Picture all = drawn(scene);
        for (const Layer layer : all_layers()) {
            if (layer == Layer::edges) continue; // hidden at first
            if (!scene.has(layer)) continue;     // test_scene_verify.cpp
            scene.set_visible(layer, false);
            const Picture without = window_.render();
            QVERIFY2(different_pixels(all, without) > 20, layer_name(layer).data());
            scene.set_visible(layer, true);
            QCOMPARE(different_pixels(all, window_.render()), std::size_t(0));
        }
        scene.set_visible(Layer::edges, true);
        QVERIFY(different_pixels(all, window_.render()) > 500);
        scene.set_visible(Layer::edges, false);
        // Removed for good: an empty scene again.
        scene.part().set(PartDisplayPtr());
        scene.stock().set_box({});
        scene.paths().set(nullptr);
        scene.tool().set(std::nullopt);
        scene.marks().set_marker(std::nullopt);
        scene.set_title("");
        Scene empty;
        QCOMPARE(different_pixels(drawn(scene), drawn(empty)), std::size_t(0));
    }

    void a_moving_view_shows_nearly_the_same() {
        Scene scene;
        scene.part().set(sheet_part({0, 0}, {hill_length, hill_width}, 300, hill));
        scene.paths().set(prepare_path_display({hill_path(60, 3000, 6)}, {}));
        scene.set_visible(Layer::cc, false);
        const Picture still = drawn(scene);
        scene.set_moving(true);
        const Picture moving = window_.render();
        const std::size_t different = different_pixels(still, moving);
        QVERIFY2(different > 100, qPrintable(QString::number(different))); // the preview is really drawn
        double sum = 0;
        for (std::size_t i = 0; i < still.rgb.size(); ++i)
            sum += std::abs(int(still.rgb[i]) - int(moving.rgb[i]));
        QVERIFY2(sum / double(still.rgb.size()) < 3,
                 qPrintable(QString::number(sum / double(still.rgb.size()))));
        scene.set_moving(false);
        QCOMPARE(different_pixels(still, window_.render()), std::size_t(0));
    }

    /// What can be seen through needs textures as large as the picture.
    void pictures_of_two_sizes_in_turn_keep_their_textures() {
        Scene scene;
        scene.part().set(box_part({0, 0, 0}, {60, 40, 25}));
        scene.stock().set_box({{-8, -8, 0}, {68, 48, 30}});
        const Picture large = drawn(scene), small = drawn(scene, 240, 180);
        auto* renderer =
            SceneRenderer::SafeDownCast(scene.camera().window()->GetRenderers()->GetFirstRenderer());
        QVERIFY(renderer);
        const std::size_t sized = renderer->textures_sized();
        QVERIFY(sized > 0);
        for (int i = 0; i < 3; ++i) {
            QCOMPARE(different_pixels(large, drawn(scene)), std::size_t(0));
            QCOMPARE(different_pixels(small, drawn(scene, 240, 180)), std::size_t(0));
        }
        QCOMPARE(renderer->textures_sized(), sized);
        (void)drawn(scene, 320, 240);
        QVERIFY(renderer->textures_sized() > sized);
        QCOMPARE(different_pixels(large, drawn(scene)), std::size_t(0));
    }

    void a_picture_in_steps_is_the_whole_picture() {
        Scene scene;
        scene.part().set(sheet_part({0, 0}, {hill_length, hill_width}, 300, hill));
        scene.paths().set(prepare_path_display({hill_path(60, 3000, 6)}, {}));
        Box3 stock;
        stock.add(Vec3(-5, -5, -12));
        stock.add(Vec3(hill_length + 5, hill_width + 5, 14));
        scene.stock().set_box(stock);
        scene.set_visible(Layer::edges, true);
        scene.set_title("In steps");
        const Picture whole = drawn(scene);
        for (const bool smooth : {false, true}) {
            scene.set_antialiasing(smooth);
            const Picture expected = window_.render();
            const std::size_t steps = scene.begin_steps();
            QVERIFY(steps > 4);
            for (std::size_t k = 0; k < steps; ++k) {
                scene.set_step(k);
                const Picture now = window_.render();
                const std::size_t different = different_pixels(expected, now);
                if (k + 1 < steps)
                    QVERIFY2(different > 100, qPrintable(QString::number(k))); // no step does it all
                else
                    QCOMPARE(different, std::size_t(0));
            }
            scene.end_steps();
            QCOMPARE(different_pixels(expected, window_.render()), std::size_t(0));
        }
        scene.set_antialiasing(false);
        QCOMPARE(different_pixels(whole, window_.render()), std::size_t(0));
    }

    /// A large one is drawn piece by piece, too, and while the view moves only by its lines.
    void the_part_before_in_steps() {
        const auto higher = [](double x, double y) { return 1.2 * hill(x + 12, y); };
        Scene scene;
        scene.part().set(sheet_part({0, 0}, {hill_length, hill_width}, 200, hill));
        const Picture alone = drawn(scene);
        const std::size_t steps_alone = scene.begin_steps();
        scene.end_steps();
        scene.former().set(
            prepare_part_display(sheet_part({0, 0}, {hill_length, hill_width}, 200, higher), {}));
        const Picture whole = window_.render();
        QVERIFY(different_pixels(alone, whole) > 3000);
        const std::size_t steps = scene.begin_steps();
        QVERIFY(steps >= steps_alone + 2);
        for (std::size_t k = 0; k < steps; ++k) {
            scene.set_step(k);
            const std::size_t different = different_pixels(whole, window_.render());
            // Lines of the part come after it here.
            QVERIFY2(k + 1 < steps ? different > 100 : different < 600,
                     qPrintable(QString::number(different)));
        }
        scene.end_steps();
        QCOMPARE(different_pixels(whole, window_.render()), std::size_t(0));
        scene.set_moving(true);
        QVERIFY(different_pixels(whole, window_.render()) > 3000);
        scene.set_moving(false);
    }

    void labels_keep_off_what_is_covered() {
        Scene scene;
        scene.part().set(sheet_part({0, 0}, {hill_length, hill_width}, 60, hill));
        const auto display = std::make_shared<StripDisplay>();
        StripDisplay::One& strip = display->strips.emplace_back();
        strip.name = "Valley 1";
        strip.detail = "120 mm2, for tool 3";
        strip.label_at = Vec3(hill_length / 2, hill_width / 2, 0);
        strip.area = 120;
        scene.strips().set(display);
        scene.set_antialiasing(false);
        const Picture with = drawn(scene);
        scene.set_covered({0, 0}, {double(with.width), double(with.height)});
        const Picture without = window_.render();
        QVERIFY(different_pixels(with, without) > 200);
        // Covered on its right end, it moves to the left; nothing of it is left under the cover.
        const Vec2 at = scene.camera().display_of(strip.label_at);
        scene.set_covered(at + Vec2(20, -40), at + Vec2(200, 40));
        const Picture beside = window_.render();
        QVERIFY(different_pixels(beside, without) > 200);
        for (int y = int(at.y()) - 39; y < int(at.y()) + 39; ++y)
            for (int x = int(at.x()) + 21; x < std::min(beside.width, int(at.x()) + 199); ++x)
                QCOMPARE(beside.pixel(x, y), without.pixel(x, y));
        scene.set_covered(Vec2::Zero(), Vec2::Zero());
        QCOMPARE(different_pixels(with, window_.render()), std::size_t(0));
    }

    /// Axes and scale stand as they are, above what covers the lower edge.
    void nothing_is_written_where_the_lower_edge_is_covered() {
        Scene scene;
        scene.part().set(sheet_part({0, 0}, {hill_length, hill_width}, 300, hill));
        for (const Layer layer : all_layers())
            scene.set_visible(layer, layer == Layer::axes || layer == Layer::scale);
        const Picture before = drawn(scene, 400, 480); // high enough for axes of full size
        constexpr int covered = 40;
        QVERIFY(scene.set_covered_below(covered));
        QVERIFY(!scene.set_covered_below(covered));
        const Picture raised = window_.render();
        // The background is graded: marks are what differs from the middle of its row.
        const auto mark = [](const Picture& p, int x, int y) {
            int off = 0;
            for (int k = 0; k < 3; ++k)
                off = std::max(off, std::abs(int(p.pixel(x, y)[k]) - int(p.pixel(p.width / 2, y)[k])));
            return off > 40;
        };
        const auto marks = [&](const Picture& p, int from, int to) {
            std::size_t n = 0;
            for (int y = from; y < to; ++y)
                for (int x = 0; x < p.width; ++x)
                    n += mark(p, x, y);
            return n;
        };
        const int edge = before.height - covered;
        QVERIFY(marks(before, edge, before.height) > 100);
        QCOMPARE(marks(raised, edge, raised.height), std::size_t(0));
        QVERIFY(marks(raised, edge - covered, edge) > 100); // what stood at the edge
        QVERIFY(scene.set_covered_below(0));
        QCOMPARE(different_pixels(before, window_.render()), std::size_t(0));
    }

    void shaders_are_rehearsed_whatever_is_shown() {
        Scene scene;
        scene.part().set(sheet_part({0, 0}, {hill_length, hill_width}, 300, hill));
        for (const Layer layer : all_layers())
            scene.set_visible(layer, false);
        scene.set_antialiasing(false);
        const Picture before = drawn(scene);
        for (std::size_t k = 0; k < Scene::rehearsals; ++k) {
            scene.rehearse(k);
            QVERIFY2(different_pixels(before, window_.render()) > 20, qPrintable(QString::number(k)));
            scene.end_rehearsal();
            QCOMPARE(different_pixels(before, window_.render()), std::size_t(0));
        }
    }

    void the_background_is_opaque_and_graded() {
        Scene scene;
        const Picture p = drawn(scene, 200, 200);
        QVERIFY(p.pixel(150, 2)[0] + 30 < p.pixel(150, 100)[0] + 60); // not black
        QVERIFY(p.pixel(150, 2)[0] > 150);
        QVERIFY(p.pixel(150, 197)[0] > p.pixel(150, 2)[0] + 30);
    }

    void sizes_are_checked() {
        Scene scene;
        QVERIFY_EXCEPTION_THROWN(window_.show(scene, 0, 10), Error);
        QVERIFY_EXCEPTION_THROWN(window_.show(scene, 10, -3), Error);
        QVERIFY_EXCEPTION_THROWN(window_.show(scene, 16385, 10), Error);
        QVERIFY_EXCEPTION_THROWN(window_.show(scene, 16384, 16384), Error);
        const Picture wide = drawn(scene, 16384, 2);
        QCOMPARE(wide.width, 16384);
    }
};

FACETMILL_TEST(TestScene)

class TestPictureCompare : public QObject {
    Q_OBJECT
private slots:
    void finds_a_small_wrong_spot() {
        Scene scene;
        fill(scene);
        OffscreenWindow window;
        window.show(scene, 480, 360);
        scene.set_view(StandardView::iso);
        const Picture good = window.render();
        QCOMPARE(compare_pictures(good, good).worst, 1.0);
        for (const auto& [x0, y0] : {std::pair(0, 0), {230, 170}, {457, 339}, {30, 300}}) {
            Picture painted = good;
            for (int y = y0; y < y0 + 20; ++y)
                for (int x = x0; x < x0 + 20; ++x)
                    for (int c = 0; c < 3; ++c)
                        painted.pixel(x, y)[c] = std::uint8_t(std::max(0, painted.pixel(x, y)[c] - 60));
            const PictureDifference d = compare_pictures(good, painted);
            QVERIFY2(d.worst < min_similarity, qPrintable(QString::number(d.worst)));
            QVERIFY(d.x > x0 - 8 && d.x < x0 + 20 && d.y > y0 - 8 && d.y < y0 + 20);
        }
    }
    void finds_a_wrong_hue_of_the_same_brightness() {
        Picture a{32, 32, std::vector<std::uint8_t>(3 * 32 * 32, 128)}, b = a;
        for (int y = 10; y < 20; ++y)
            for (int x = 10; x < 20; ++x) {
                b.pixel(x, y)[0] = 188;
                b.pixel(x, y)[2] = 68;
            }
        QVERIFY(compare_pictures(a, b).worst < min_similarity);
    }
    void forgives_one_level_everywhere() {
        Picture a{32, 32, std::vector<std::uint8_t>(3 * 32 * 32, 128)}, b = a;
        for (std::size_t i = 0; i < b.rgb.size(); i += 5)
            ++b.rgb[i];
        QVERIFY(compare_pictures(a, b).worst > min_similarity);
    }
    void sizes_must_agree() {
        const Picture a{4, 4, std::vector<std::uint8_t>(48, 9)}, b{4, 3, std::vector<std::uint8_t>(36, 9)};
        QCOMPARE(compare_pictures(a, a).worst, 1.0);
        QCOMPARE(compare_pictures(a, b).worst, 0.0);
    }
    void a_wrong_picture_is_kept_and_named() {
        if (qEnvironmentVariableIsSet("FACETMILL_UPDATE_PICTURES"))
            QSKIP("the baseline would be overwritten");
        Picture p = read_png(data_path("screenshot/baseline/tiny.png"));
        QCOMPARE(check_picture(p, "tiny", FACETMILL_PICTURE_OUT), std::string());
        for (std::size_t i = 0; i < 300; ++i)
            p.rgb[i] = 0;
        const QString folder = FACETMILL_PICTURE_OUT "/companion";
        const std::string wrong = check_picture(p, "tiny", folder.toStdString());
        QVERIFY2(wrong.find("similarity") != std::string::npos, wrong.c_str());
        QCOMPARE(read_png((folder + "/tiny-out.png").toStdString()).rgb, p.rgb);
        QVERIFY(read_png((folder + "/tiny-diff.png").toStdString()).rgb[0] > 100);
        QVERIFY(check_picture(p, "no-such-baseline", folder.toStdString()).find("no baseline")
                != std::string::npos);
        QDir(folder).removeRecursively();
    }
};

FACETMILL_TEST(TestPictureCompare)
#include "test_scene.moc"
