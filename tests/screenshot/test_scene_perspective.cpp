// Perspective: between places and pixels as VTK draws them, fitting, zooming and picking.
#include "tests/screenshot/scene_parts.h"
#include "tests/support/test_runner.h"
#include "viz/offscreen.h"
#include "viz/scene.h"

#include <QTest>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <random>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Where VTK draws a place: pixels, y down.
Vec2 drawn_at(Scene& scene, const Vec3& p) {
    vtkRenderer* renderer = scene.renderer();
    renderer->SetWorldPoint(p.x(), p.y(), p.z(), 1);
    renderer->WorldToDisplay();
    const double* at = renderer->GetDisplayPoint();
    return {at[0], scene.camera().window_size().y() - at[1]};
}

/// The nearest facet that a line from the eye meets, by going through all of them.
std::optional<std::size_t> facet_under(Scene& scene, const Mesh& mesh, const Vec2& pixel) {
    std::optional<std::size_t> found;
    double least = infinity;
    const Vec3 eye(scene.camera().vtk()->GetPosition());
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        const Vec2 a = drawn_at(scene, mesh.corner(f, 0)), b = drawn_at(scene, mesh.corner(f, 1)),
                   c = drawn_at(scene, mesh.corner(f, 2));
        const auto cross = [](const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); };
        const double s1 = cross(b - a, pixel - a), s2 = cross(c - b, pixel - b), s3 = cross(a - c, pixel - c);
        if (!((s1 > 0 && s2 > 0 && s3 > 0) || (s1 < 0 && s2 < 0 && s3 < 0))) continue;
        const double away = ((mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3 - eye).norm();
        if (away < least) {
            least = away;
            found = f;
        }
    }
    return found;
}

Vec3 corner_of(const Box3& b, int c) {
    return {c & 1 ? b.hi.x() : b.lo.x(), c & 2 ? b.hi.y() : b.lo.y(), c & 4 ? b.hi.z() : b.lo.z()};
}

} // namespace

class TestScenePerspective : public QObject {
    Q_OBJECT

    OffscreenWindow window_;

private slots:
    void pixels_are_where_vtk_draws() {
        Scene scene;
        scene.part().set(hill_part());
        window_.show(scene, 400, 300);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> share(0, 1);
        for (const StandardView view : standard_views()) {
            scene.camera().set_perspective(true);
            scene.set_view(view);
            scene.camera().zoom_at(150, 420, 1.3);
            (void)window_.render();
            const Box3 box = scene.bounds();
            for (int i = 0; i < 50; ++i) {
                Vec3 p;
                for (int k = 0; k < 3; ++k)
                    p[k] = box.lo[k] + share(random) * (box.hi[k] - box.lo[k]);
                QVERIFY2((scene.camera().display_of(p) - drawn_at(scene, p)).norm() < 1e-6,
                         view_name(view).data());
                const Vec2 at = scene.camera().display_of(p);
                const SightLine line = scene.camera().sight_at(at.x(), at.y());
                // On the line, and seen from the eye.
                QVERIFY((p - line.at).cross(line.direction).norm() < 1e-6);
                const Vec3 eye(scene.camera().vtk()->GetPosition());
                QVERIFY((line.start(1e9) - eye).norm() < 0.01 * (p - eye).norm());
            }
        }
    }

    void fitting_shows_everything_and_is_tight() {
        for (const auto& [w, h] : {std::pair(640, 480), {300, 600}, {800, 200}})
            for (const Vec3& size :
                 {Vec3(100, 60, 30), Vec3(500, 1, 1), Vec3(1, 1, 400), Vec3(0.1, 0.2, 0.1)})
                for (const StandardView view : standard_views()) {
                    Scene scene;
                    scene.part().set(box_part({7, 8, 9}, Vec3(7, 8, 9) + size));
                    scene.set_title("Box");
                    window_.show(scene, w, h);
                    scene.camera().set_perspective(true);
                    scene.set_view(view);
                    const Box3 b = scene.bounds();
                    Vec2 lo(infinity, infinity), hi = -lo;
                    for (int c = 0; c < 8; ++c) {
                        const Vec2 p = scene.camera().display_of(corner_of(b, c)) / 2;
                        lo = lo.cwiseMin(p);
                        hi = hi.cwiseMax(p);
                    }
                    QVERIFY2(lo.x() >= 0 && lo.y() >= 0 && hi.x() <= w && hi.y() <= h,
                             view_name(view).data());
                    // Nearer to the end of a long thin one the eye would be in it.
                    const double deep = std::abs(scene.camera().toward_eye().dot(size));
                    if (deep < 20 * (size - deep * scene.camera().toward_eye().cwiseAbs()).norm())
                        QVERIFY2((hi - lo).x() > 0.3 * w || (hi - lo).y() > 0.3 * h, view_name(view).data());
                }
    }

    void there_and_back_is_the_same_picture() {
        Scene scene;
        scene.part().set(hill_part());
        window_.show(scene, 300, 200);
        scene.set_view(StandardView::iso);
        const Picture before = window_.render();
        scene.camera().set_perspective(true);
        const Picture seen = window_.render();
        QVERIFY(seen.rgb != before.rgb);
        // The focal point's plane keeps its scale.
        const Vec2 middle(300, 200); // two device pixels a pixel
        QVERIFY((scene.camera().display_of(Vec3(scene.camera().vtk()->GetFocalPoint())) - middle).norm()
                < 1e-6);
        scene.camera().set_perspective(false);
        QVERIFY(window_.render().rgb == before.rgb);
    }

    void picks_what_is_drawn() {
        const MeshPtr mesh = box_part({0, 0, 0}, {100, 60, 30});
        Scene scene;
        scene.part().set(mesh);
        window_.show(scene, 200, 150);
        scene.camera().set_perspective(true);
        std::mt19937 random(11);
        std::uniform_real_distribution<double> x(0, 400), y(0, 300);
        int met = 0;
        for (const StandardView view : standard_views()) {
            scene.set_view(view);
            (void)window_.render();
            for (int i = 0; i < 60; ++i) {
                const Vec2 at(x(random), y(random));
                const auto expected = facet_under(scene, *mesh, at);
                const auto pick = scene.part().pick(at.x(), at.y());
                QCOMPARE(pick.has_value(), expected.has_value());
                if (!pick) continue;
                ++met;
                QVERIFY((mesh->facet_normal(pick->facet) - mesh->facet_normal(*expected)).norm() < 1e-9);
                QVERIFY((scene.camera().display_of(pick->point) - at).norm() < 1e-6);
                QVERIFY(!scene.part().hides(pick->point));
                const Vec3 eye(scene.camera().vtk()->GetPosition());
                QVERIFY(scene.part().hides(pick->point + 5 * (pick->point - eye).normalized()));
            }
        }
        QVERIFY2(met > 100, qPrintable(QString::number(met)));
        // Within the box there is no face between the eye and the wall that one looks at.
        CameraPlace inside = scene.camera().place();
        inside.target = Vec3(90, 30, 15);
        inside.toward_eye = -Vec3::UnitX();
        inside.up = Vec3::UnitZ();
        inside.height = 20;
        scene.camera().look_at(inside);
        const auto pick = scene.part().pick(200, 150);
        QVERIFY(pick && pick->back_side && std::abs(pick->point.x() - 100) < 1e-9);
    }

    void a_rectangle_takes_the_facets_in_it() {
        const MeshPtr mesh = hill_part();
        Scene scene;
        scene.part().set(mesh);
        window_.show(scene, 300, 200);
        scene.camera().set_perspective(true);
        scene.set_view(StandardView::iso);
        (void)window_.render();
        const Vec2 from(180, 120), to(420, 300);
        std::vector<Index> expected;
        for (std::size_t f = 0; f < mesh->facet_count(); ++f) {
            bool in = true;
            for (int k = 0; k < 3; ++k) {
                const Vec2 p = drawn_at(scene, mesh->corner(f, k));
                in = in && (p.array() >= from.array()).all() && (p.array() <= to.array()).all();
            }
            if (in) expected.push_back(Index(f));
        }
        QVERIFY(expected.size() > 50 && expected.size() < mesh->facet_count());
        QVERIFY(scene.part().facets_in(from, to, true)({}) == expected);
    }

    void what_is_zoomed_at_stays() {
        Scene scene;
        scene.part().set(box_part({0, 0, 0}, {100, 60, 30}));
        window_.show(scene, 400, 300);
        scene.camera().set_perspective(true);
        scene.set_view(StandardView::iso);
        const auto pick = scene.part().pick(520, 330);
        QVERIFY(pick);
        const Vec2 before = scene.camera().display_of(pick->point),
                   other = scene.camera().display_of({0, 0, 30});
        scene.camera().focus_at(pick->point); // changes nothing that is seen
        QVERIFY((scene.camera().display_of({0, 0, 30}) - other).norm() < 1e-6);
        scene.camera().zoom_at(before.x(), before.y(), 3);
        QVERIFY((scene.camera().display_of(pick->point) - before).norm() < 1e-6);
        QVERIFY((scene.camera().display_of({0, 0, 30}) - before).norm() > 1.5 * (other - before).norm());
        scene.camera().zoom_at(before.x(), before.y(), 1 / 3.0);
        QVERIFY((scene.camera().display_of({0, 0, 30}) - other).norm() < 1e-6);
        scene.camera().focus_at(Vec3(scene.camera().vtk()->GetPosition()) + 50 * scene.camera().toward_eye());
        QVERIFY((scene.camera().display_of({0, 0, 30}) - other).norm() < 1e-6); // not behind the eye
    }

    void paths_are_picked_where_they_are_drawn() {
        const PathSource path = hill_path(17, 60, 6);
        Scene scene;
        scene.part().set(hill_part());
        scene.paths().set(prepare_path_display({path}, {}));
        window_.show(scene, 800, 600);
        scene.camera().set_perspective(true);
        scene.set_view(StandardView::iso);
        (void)window_.render();
        scene.set_visible(Layer::cc, false);
        const Pass& pass = path.contacts->passes[8];
        const Vec2 tip = drawn_at(scene, pass.cl[30].tip);
        const auto pick = scene.paths().pick(tip.x(), tip.y(), 8);
        QVERIFY(pick && !pick->is_contact);
        QCOMPARE(path.motions->motions[pick->motion].to.tip, pass.cl[30].tip);
    }

    /// On a screen with many pixels that is not enlarged lines would be hairs.
    void lines_grow_with_their_scale() {
        Scene scene;
        scene.paths().set(prepare_path_display({hill_path(3, 30, 6)}, {}));
        scene.set_visible(Layer::cc, false);
        scene.set_visible(Layer::legend, false);
        window_.show(scene, 400, 300);
        scene.set_view(StandardView::top);
        const auto ink = [&] {
            const Picture p = window_.render();
            std::size_t n = 0; // of the blue of cuts
            for (std::size_t i = 0; i < p.rgb.size(); i += 3)
                n += p.rgb[i] < 90 && p.rgb[i + 2] > 120;
            return n;
        };
        const std::size_t thin = ink();
        scene.set_line_scale(2);
        const std::size_t thick = ink();
        QVERIFY2(thin > 100 && double(thick) > 1.5 * double(thin),
                 qPrintable(QStringLiteral("%1 %2").arg(thin).arg(thick)));
    }
};
FACETMILL_TEST(TestScenePerspective)

#include "test_scene_perspective.moc"
