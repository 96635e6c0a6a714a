// What a verification shows: colours that stand for known deviations, their scale in the legend, the cut
// stock, findings, and where the camera goes to see one.
#include "tests/screenshot/scene_parts.h"
#include "tests/support/picture_compare.h"
#include "tests/support/test_runner.h"
#include "viz/offscreen.h"
#include "viz/overlay.h"
#include "viz/palette.h"
#include "viz/render_picture.h"

#include <QTest>

#include <cmath>

#include <vtkNew.h>
#include <vtkRenderer.h>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// A level square of 100 x 80 mm at z = 10, n x n cells, whose deviation grows along x as `of(x)`.
std::shared_ptr<DeviationSurface> level_surface(int n, const std::function<double(double, double)>& of) {
    auto s = std::make_shared<DeviationSurface>();
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const double x = 100.0 * i / n, y = 80.0 * j / n;
            s->points.push_back({float(x), float(y), 10.0f});
            s->normals.push_back({0, 0, 1});
            s->deviation.push_back(float(of(x, y)));
            s->flags.push_back(DeviationSurface::counted);
        }
    const auto at = [n](int i, int j) { return std::uint32_t(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            s->triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            s->triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return s;
}

constexpr DeviationScale scale{.low = -0.2, .high = 0.4, .gouge_limit = 0.01, .tolerance = 0.1};

std::array<int, 3> pixel(const Picture& p, const Vec2& at) {
    const auto* rgb = p.pixel(int(at.x()), int(at.y()));
    return {rgb[0], rgb[1], rgb[2]};
}

int off_by(const std::array<int, 3>& a, const Rgb& c) {
    return std::max({std::abs(a[0] - int(std::lround(255 * c.r))),
                     std::abs(a[1] - int(std::lround(255 * c.g))),
                     std::abs(a[2] - int(std::lround(255 * c.b)))});
}

std::size_t count_near(const Picture& p, const Rgb& c, int within) {
    std::size_t n = 0;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            n += off_by(pixel(p, {double(x), double(y)}), c) <= within;
    return n;
}

double lightness(const Rgb& c) {
    return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; // enough to order by
}

/// One patch: the top of a block between z = 0 and `z`.
std::shared_ptr<const StockPatch> top_patch(double x0, double x1, double z) {
    auto p = std::make_shared<StockPatch>();
    for (const auto& [x, y] : {std::pair(x0, 0.0), {x1, 0.0}, {x1, 80.0}, {x0, 80.0}}) {
        p->points.push_back({float(x), float(y), float(z)});
        p->normals.push_back({0, 0, 1});
    }
    p->triangles = {{0, 1, 2}, {0, 2, 3}};
    p->box = {{x0, 0, z}, {x1, 80, z}};
    return p;
}

Verification verification_of(std::shared_ptr<const DeviationSurface> surface) {
    Verification v;
    v.surface = std::move(surface);
    v.used.tolerance = 0.1;
    v.used.gouge_limit = 0.01;
    v.gouges.push_back({{20, 20, 10}, {0, 0, 1}, -0.3, {0, 6}});
    v.excess.push_back({{80, 20, 10}, {0, 0, 1}, 0.5, {0, 9}});
    v.collisions.push_back({.place = {50, 60, 10}, .depth = 1});
    return v;
}

} // namespace

class TestSceneVerify : public QObject {
    Q_OBJECT

    OffscreenWindow window_;

    Picture top_view(Scene& scene, int width = 480, int height = 360) {
        window_.show(scene, width, height);
        scene.set_view(StandardView::top);
        return window_.render();
    }
    /// Picture pixels; the off-screen window has two device pixels for one.
    static Vec2 place(const Scene& scene, const Vec3& p) { return scene.camera().display_of(p) / 2; }
    void check(const Picture& picture, const char* name) {
        const std::string wrong = check_picture(picture, name, FACETMILL_PICTURE_OUT);
        QVERIFY2(wrong.empty(), wrong.c_str());
    }

private slots:
    void the_scale_of_colors() {
        // Green within the limits, both limits included; the ends beyond the range.
        const Rgb green = deviation_color_at(0);
        for (const double d : {-0.01, 0.0, 0.05, 0.1}) {
            const Rgb c = deviation_color(scale, d);
            QVERIFY(c.r == green.r && c.g == green.g && c.b == green.b);
        }
        QVERIFY(green.g > green.r + 0.2 && green.g > green.b + 0.2);
        const Rgb red = deviation_color(scale, -5), blue = deviation_color(scale, 5);
        QVERIFY(red.r > red.g + 0.4 && red.r > red.b + 0.4);
        QVERIFY(blue.b > blue.r + 0.3 && blue.b > blue.g + 0.3);
        QCOMPARE(deviation_color(scale, scale.low).r, red.r);
        QCOMPARE(deviation_color(scale, scale.high).b, blue.b);
        // Darker all along on both sides; no jump anywhere.
        double before_red = lightness(green), before_blue = before_red, jump = 0;
        Rgb last_red = green, last_blue = green;
        for (int i = 1; i <= 200; ++i) {
            const Rgb r = deviation_color_at(-i / 200.0), b = deviation_color_at(i / 200.0);
            QVERIFY(lightness(r) < before_red + 0.012);
            QVERIFY(lightness(b) < before_blue + 0.012);
            before_red = lightness(r);
            before_blue = lightness(b);
            jump = std::max({jump, std::abs(r.r - last_red.r), std::abs(r.g - last_red.g),
                             std::abs(b.b - last_blue.b), std::abs(b.g - last_blue.g)});
            last_red = r;
            last_blue = b;
        }
        QVERIFY(before_red < 0.4 * lightness(green) && before_blue < 0.4 * lightness(green));
        QVERIFY2(jump < 0.03, qPrintable(QString::number(jump)));
        // A range within the limits: what is good stays green, what is not has the end's colour.
        const DeviationScale narrow{.low = -0.001, .high = 0.001, .gouge_limit = 0.01, .tolerance = 0.1};
        QCOMPARE(deviation_color(narrow, 0.05).g, green.g);
        QCOMPARE(deviation_color(narrow, -0.02).r, red.r);
        QCOMPARE(deviation_colors(std::vector<float>{-0.02f, -0.005f, 0.05f, 0.2f}, {}, narrow),
                 (std::vector<std::uint8_t>{
                     std::uint8_t(std::lround(255 * red.r)), std::uint8_t(std::lround(255 * red.g)),
                     std::uint8_t(std::lround(255 * red.b)), 255, 0x6C, 0xCB, 0x5F, 255, 0x6C, 0xCB, 0x5F,
                     255, std::uint8_t(std::lround(255 * blue.r)), std::uint8_t(std::lround(255 * blue.g)),
                     std::uint8_t(std::lround(255 * blue.b)), 255}));
    }

    void marks_of_the_scale() {
        const auto marks = scale_marks(scale, LengthUnit::mm, 0.05);
        QStringList labels;
        for (const ScaleMark& m : marks)
            labels << QString::fromStdString(m.label);
        QCOMPARE(labels, (QStringList{QStringLiteral("−0.2"), QStringLiteral("0"), QStringLiteral("+0.1"),
                                      QStringLiteral("+0.4")}));
        QCOMPARE(scale_marks(scale, LengthUnit::inch, 0.05).front().label, std::string("\u22120.00787"));
    }

    void a_default_range() {
        Verification v;
        v.used.tolerance = 0.1;
        v.used.gouge_limit = 0.01;
        DeviationScale s = default_scale(v, LengthUnit::mm);
        QCOMPARE(s.high, 0.2);
        QCOMPARE(s.low, -0.1);
        v.used.tolerance = 0;
        v.figures.excess_p99 = 0.3;
        v.figures.gouge_max = 0.04;
        s = default_scale(v, LengthUnit::mm);
        QCOMPARE(s.high, 0.5);
        QCOMPARE(s.low, -0.05);
        v = {};
        s = default_scale(v, LengthUnit::inch); // nothing known, still a range
        QVERIFY(s.low < 0 && s.high > 0);
    }

    void known_deviations_have_their_colors() {
        const auto surface = level_surface(
            100, [](double x, double) { return scale.low + (scale.high - scale.low) * x / 100; });
        Scene scene;
        scene.part().set(box_part({0, 0, 0}, {100, 80, 10}));
        scene.deviation().set(prepare_deviation_display(surface, scale, {}));
        scene.set_visible(Layer::axes, false);
        QVERIFY(scene.has(Layer::deviation) && scene.has(Layer::legend));
        const Picture picture = top_view(scene);
        for (const double x : {4.0, 12.0, 25.0, 40.0, 60.0, 75.0, 96.0}) {
            const double d = scale.low + (scale.high - scale.low) * x / 100;
            const auto seen = pixel(picture, place(scene, {x, 30, 10}));
            QVERIFY2(
                off_by(seen, deviation_color(scale, d)) <= 12,
                qPrintable(QStringLiteral("x %1: %2 %3 %4").arg(x).arg(seen[0]).arg(seen[1]).arg(seen[2])));
        }
        check(picture, "deviation-top");

        // A part that is off by one tolerance more everywhere must not pass for this one.
        auto wrong = std::make_shared<DeviationSurface>(*surface);
        for (float& d : wrong->deviation)
            d += 0.1f;
        scene.deviation().set(prepare_deviation_display(wrong, scale, {}));
        const Picture other = top_view(scene);
        QVERIFY(off_by(pixel(other, place(scene, {60, 30, 10})), deviation_color(scale, 0.16)) > 12);
        QVERIFY(compare_pictures(other, picture).worst < min_similarity);
    }

    void the_range_can_be_changed() {
        const auto surface = level_surface(20, [](double, double) { return 0.3; });
        Scene scene;
        scene.deviation().set(prepare_deviation_display(surface, scale, {}));
        const Picture first = top_view(scene);
        QVERIFY(off_by(pixel(first, place(scene, {50, 30, 10})), deviation_color(scale, 0.3)) <= 12);
        DeviationScale wide = scale;
        wide.high = 4;
        scene.deviation().set_scale(wide);
        const Picture picture = top_view(scene);
        const auto seen = pixel(picture, place(scene, {50, 30, 10}));
        QVERIFY(off_by(seen, deviation_color(wide, 0.3)) <= 12);
        QVERIFY(off_by(seen, deviation_color(scale, 0.3)) > 25);
    }

    void what_is_not_judged_is_gray() {
        auto surface = level_surface(20, [](double x, double) { return x < 50 ? 0.3 : -0.15; });
        for (std::size_t i = 0; i < surface->points.size(); ++i)
            surface->flags[i] =
                surface->points[i][1] < 40 ? DeviationSurface::border : DeviationSurface::counted;
        Scene scene;
        scene.deviation().set(prepare_deviation_display(surface, scale, {}));
        const Picture picture = top_view(scene);
        QVERIFY(off_by(pixel(picture, place(scene, {25, 60, 10})), deviation_color(scale, 0.3)) <= 12);
        QVERIFY(off_by(pixel(picture, place(scene, {25, 20, 10})), unjudged_color()) <= 12);
        // A gouge is one at the border too.
        QVERIFY(off_by(pixel(picture, place(scene, {75, 20, 10})), deviation_color(scale, -0.15)) <= 12);
        for (auto& f : surface->flags)
            f = DeviationSurface::bare;
        scene.deviation().set(prepare_deviation_display(surface, scale, {}));
        const Picture bare = top_view(scene);
        QVERIFY(off_by(pixel(bare, place(scene, {75, 20, 10})), unjudged_color()) <= 12);
    }

    void a_large_surface_moves_as_a_coarse_one() {
        const auto surface = level_surface(170, [](double x, double) { return x / 200; });
        Scene scene;
        scene.deviation().set(prepare_deviation_display(surface, scale, {}));
        QVERIFY(scene.has_preview());
        scene.set_moving(true);
        const Picture moving = top_view(scene);
        for (const double x : {10.0, 50.0, 90.0})
            QVERIFY(off_by(pixel(moving, place(scene, {x, 30, 10})), deviation_color(scale, x / 200)) <= 14);
    }

    void the_histogram_counts_area() {
        auto surface = level_surface(50, [](double x, double) { return x < 50 ? 0.05 : 0.9; });
        const auto display = prepare_deviation_display(surface, scale, {});
        const DeviationHistogram h = deviation_histogram(*display, scale, 60);
        QVERIFY(std::abs(h.total - 8000) < 1);
        QVERIFY(std::abs(h.above - 4080) < 1);    // half a cell more: the samples at x = 50
        QVERIFY(std::abs(h.bins[25] - 3920) < 1); // -0.2 + 25 * 0.01 = 0.05
        QCOMPARE(h.below, 0.0);
        surface->flags.assign(surface->flags.size(), DeviationSurface::away);
        QCOMPARE(deviation_histogram(*prepare_deviation_display(surface, scale, {}), scale, 60).total, 0.0);
    }

    void unfit_surfaces_are_refused() {
        auto surface = level_surface(4, [](double, double) { return 0; });
        surface->flags.pop_back();
        QVERIFY_EXCEPTION_THROWN(prepare_deviation_display(surface, scale, {}), Error);
        surface = level_surface(4, [](double, double) { return 0; });
        surface->triangles[3][1] = 9999;
        QVERIFY_EXCEPTION_THROWN(prepare_deviation_display(surface, scale, {}), Error);
        surface = std::make_shared<DeviationSurface>();
        Scene scene;
        scene.deviation().set(prepare_deviation_display(surface, scale, {})); // empty: nothing to show
        QVERIFY(!scene.has(Layer::deviation));
    }

    void cut_stock_stands_for_box_and_part() {
        Scene scene;
        scene.part().set(box_part({0, 0, 0}, {100, 80, 10}));
        scene.stock().set_box({{0, 0, 0}, {100, 80, 20}});
        const Rgb stock = colors_of(facetmill::Palette::light).cut_stock,
                  part = colors_of(facetmill::Palette::light).part;
        const Picture before = top_view(scene);
        const StockPatches patches{top_patch(0, 50, 12), nullptr, top_patch(50, 100, 10)};
        scene.stock().set_cut(patches);
        const Picture cut = top_view(scene);
        for (const double x : {20.0, 80.0})
            QVERIFY(off_by(pixel(cut, place(scene, {x, 30, 10})), stock) <= 14);
        QVERIFY(off_by(pixel(before, place(scene, {20, 30, 10})), stock) > 14);
        check(cut, "cut-stock");
        // One patch is another: the rest stays. A missing one leaves a hole, and never the part in it.
        scene.stock().set_cut({top_patch(0, 20, 12), nullptr, patches[2]});
        const Picture less = top_view(scene);
        QVERIFY(off_by(pixel(less, place(scene, {80, 30, 10})), stock) <= 14);
        QVERIFY(off_by(pixel(less, place(scene, {40, 30, 10})), stock) > 14);
        QVERIFY(off_by(pixel(less, place(scene, {40, 30, 10})), part) > 14);
        // Hidden, it gives way to the part; without patches the box is back.
        scene.set_visible(Layer::stock, false);
        const Picture uncovered = top_view(scene);
        QVERIFY(off_by(pixel(uncovered, place(scene, {40, 30, 10})), part) <= 14);
        scene.set_visible(Layer::stock, true);
        scene.stock().set_cut({});
        QVERIFY(compare_pictures(top_view(scene), before).worst >= min_similarity);
    }

    void a_finer_stock_gives_way_while_the_view_moves() {
        Scene scene;
        scene.stock().set_box({{0, 0, 0}, {100, 80, 20}});
        const StockPatches coarse{top_patch(0, 50, 12)}, fine{top_patch(0, 50, 12), top_patch(50, 100, 12)};
        scene.stock().set_cut(coarse, fine);
        QVERIFY(scene.has_preview());
        const Rgb stock = colors_of(facetmill::Palette::light).cut_stock;
        const Picture full = top_view(scene);
        scene.set_moving(true);
        const Picture moving = top_view(scene);
        QVERIFY(off_by(pixel(full, place(scene, {80, 30, 12})), stock) <= 14);
        QVERIFY(off_by(pixel(moving, place(scene, {80, 30, 12})), stock) > 14);
        QVERIFY(off_by(pixel(moving, place(scene, {20, 30, 12})), stock) <= 14);
    }

    void cut_stock_in_steps_is_the_same_picture() {
        Scene scene;
        scene.stock().set_box({{0, 0, 0}, {100, 80, 20}});
        scene.stock().set_cut({top_patch(0, 50, 12), top_patch(50, 100, 10)});
        const Picture whole = top_view(scene);
        const std::size_t steps = scene.begin_steps();
        QVERIFY(steps >= 3);
        Picture last;
        for (std::size_t k = 0; k < steps; ++k) {
            scene.set_step(k);
            last = window_.render();
        }
        scene.end_steps();
        QVERIFY(compare_pictures(last, whole).worst >= min_similarity);
    }

    /// Also above what lies along the lower edge of a small view, as messages do.
    void a_scale_leaves_room_for_the_cube() {
        constexpr double cube = 92 + 52; // with the scale bar below it
        const vtkNew<vtkRenderer> renderer;
        Overlay overlay(renderer);
        OverlayContent content;
        content.width = 468;
        content.height = 360;
        ColorBar bar;
        bar.title = "Deviation (mm)";
        bar.colors = {Rgb(), Rgb()};
        bar.low_text = "gouge";
        bar.high_text = "excess";
        bar.marks = {{0, "-0.2"}, {1, "+0.4"}};
        bar.other = {Rgb(), "not judged"};
        content.color_bars = {bar};
        for (const double covered : {0.0, 37.0}) {
            content.covered_below = covered;
            const LayoutRect legend = overlay.layout(content).legend;
            QVERIFY(!legend.empty());
            QVERIFY2(legend.y1 < content.height - covered - cube, qPrintable(QString::number(legend.y1)));
        }
    }

    void a_part_in_inches_has_a_legend_in_inches() {
        const auto surface = level_surface(60, [](double x, double y) { return (x - 30) / 100 + y / 900; });
        RenderRequest request;
        request.part = box_part({0, 0, 0}, {100, 80, 10});
        request.stock.box = {{0, 0, 0}, {100, 80, 20}};
        request.verification = std::make_shared<Verification>(verification_of(surface));
        request.layers = {Layer::part, Layer::deviation, Layer::findings};
        request.unit = LengthUnit::inch;
        request.width = 480;
        request.height = 360;
        request.title = "Plate";
        const Picture picture = render_picture(request, {});
        check(picture, "deviation-iso-inch");
        const Colors& light = colors_of(facetmill::Palette::light);
        QVERIFY(count_near(picture, light.collision, 30) > 10);
        request.palette = facetmill::Palette::dark;
        check(render_picture(request, {}), "deviation-iso-dark");
        request.layers = {Layer::part, Layer::stock};
        request.cut_stock = {top_patch(0, 50, 12), top_patch(50, 100, 10)};
        QVERIFY(count_near(render_picture(request, {}), colors_of(facetmill::Palette::dark).cut_stock, 50)
                > 2000);
        request.verification = nullptr;
        request.layers = {Layer::deviation};
        QVERIFY_EXCEPTION_THROWN(render_picture(request, {}), Error);
    }

    void layers_show_and_hide() {
        Scene scene;
        scene.part().set(box_part({0, 0, 0}, {100, 80, 10}));
        scene.deviation().set(
            prepare_deviation_display(level_surface(20, [](double, double) { return 0.3; }), scale, {}));
        scene.findings().set({{FindingMark::Kind::gouge, {20, 20, 10}}});
        const Picture all = top_view(scene);
        const Colors& light = colors_of(facetmill::Palette::light);
        QVERIFY(count_near(all, light.gouge, 20) > 30);
        scene.set_visible(Layer::findings, false);
        const Picture without = top_view(scene);
        QCOMPARE(count_near(without, light.gouge, 20), std::size_t(0));
        scene.set_visible(Layer::deviation, false);
        const Picture plain = top_view(scene);
        QVERIFY(off_by(pixel(plain, place(scene, {50, 30, 10})), light.part) <= 14);
        QVERIFY(!scene.has(Layer::legend)); // its scale goes with the colours
        scene.set_visible(Layer::deviation, true);
        scene.set_visible(Layer::findings, true);
        QVERIFY(compare_pictures(top_view(scene), all).worst >= min_similarity);
    }

    void small_windows_keep_the_scale_or_nothing() {
        const auto surface = level_surface(10, [](double x, double) { return x / 100; });
        for (const auto& [w, h] : {std::pair(260, 180), {160, 120}, {700, 160}, {200, 600}}) {
            Scene scene;
            scene.stock().set_box({{0, 0, 0}, {100, 80, 20}});
            scene.deviation().set(prepare_deviation_display(surface, scale, {}));
            scene.findings().set(
                {{FindingMark::Kind::gouge, {1, 1, 10}}, {FindingMark::Kind::excess, {9, 9, 10}}});
            scene.deviation().set_note("out of date");
            const Picture p = top_view(scene, w, h);
            QCOMPARE(p.width, w);
        }
    }

    void a_camera_flies_to_what_is_found() {
        Scene scene;
        scene.part().set(box_part({0, 0, 0}, {100, 80, 40}));
        window_.show(scene, 480, 360);
        scene.set_view(StandardView::iso);
        const CameraPlace before = scene.camera().place();
        // Seen already: only nearer. On the far side: from there. From below: from below.
        const CameraPlace top = scene.camera().place_to_see({70, 60, 40}, {0, 0, 1}, 20);
        QVERIFY((top.toward_eye - before.toward_eye).norm() < 1e-9);
        QCOMPARE(top.height, 20.0);
        for (const Vec3& n : {Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, 0, -1)}) {
            const CameraPlace p = scene.camera().place_to_see({50, 40, 20}, n, 20);
            QVERIFY(p.toward_eye.dot(n) >= 0.35);
            QVERIFY(std::abs(p.up.dot(p.toward_eye)) < 1e-9);
            QVERIFY(p.up.z() > 0);
        }
        QCOMPARE(scene.camera().place_to_see({0, 0, 0}, {0, 0, 0}, 1e6).height,
                 before.height); // never farther
        scene.camera().look_at(top);
        QVERIFY((place(scene, {70, 60, 40}) - Vec2(240, 180)).norm() < 0.6);
        const double pixels_per_mm =
            (scene.camera().display_of(Vec3(70, 60, 40) + top.up) - scene.camera().display_of({70, 60, 40}))
                .norm()
            / 2;
        QVERIFY(std::abs(pixels_per_mm - 360 / 20.0) < 0.1);
        scene.camera().look_at(before);
        QVERIFY((scene.camera().place().target - before.target).norm() < 1e-9);
    }
};

FACETMILL_TEST(TestSceneVerify)
#include "test_scene_verify.moc"
