// An operation that is drawn half done: what counts as behind the tool, and what is still to come.
#include "tests/screenshot/scene_parts.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"
#include "viz/half_done.h"
#include "viz/render_picture.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace facetmill;
using namespace facetmill::test;

namespace {

std::shared_ptr<const OperationResult> hill_operation(int passes) {
    auto operation = std::make_shared<OperationResult>();
    const PathSource path = hill_path(passes, 30, 6);
    operation->name = "Finish";
    operation->path = *path.contacts;
    operation->program.motions = *path.motions;
    operation->program.tool_number = 3;
    return operation;
}

/// The hill as it was judged: nothing is left anywhere.
std::shared_ptr<const DeviationSurface> judged_hill() {
    const MeshPtr mesh = hill_part();
    auto surface = std::make_shared<DeviationSurface>();
    for (std::size_t v = 0; v < mesh->vertices.size(); ++v) {
        const Vec3& p = mesh->vertices[v];
        surface->points.push_back({float(p.x()), float(p.y()), float(p.z())});
        surface->normals.push_back({0, 0, 1});
    }
    for (const auto& f : mesh->facets)
        surface->triangles.push_back({std::uint32_t(f[0]), std::uint32_t(f[1]), std::uint32_t(f[2])});
    surface->deviation.assign(surface->points.size(), 0);
    surface->flags.assign(surface->points.size(), DeviationSurface::counted);
    return surface;
}

} // namespace

class TestSceneHalfDone : public QObject {
    Q_OBJECT
private slots:
    void behind_the_tool_and_ahead_of_it() {
        const auto operation = hill_operation(21);
        const auto surface = judged_hill();
        const auto& all = operation->program.motions.motions;
        for (const double share : {0.25, 0.5, 0.8}) {
            const HalfDone half = half_done(operation, *surface, share, {});
            const auto& ahead = half.ahead.motions->motions;
            // The tool stands where what is ahead begins, at about this share of the cuts.
            QVERIFY((ahead.front().to.tip - half.pose.tip).norm() < 1e-12);
            const auto cuts = [](const std::vector<Motion>& motions) {
                return double(std::count_if(motions.begin(), motions.end(),
                                            [](const Motion& m) { return m.kind == MotionKind::cut; }));
            };
            QVERIFY2(std::abs(1 - cuts(ahead) / cuts(all) - share) < 0.03,
                     qPrintable(QString::number(cuts(ahead) / cuts(all))));
            QCOMPARE(half.done.size(), surface->points.size());
            // Passes run along X, from low to high Y: so does what is done.
            const double front = half.pose.tip.y();
            for (std::size_t i = 0; i < half.done.size(); ++i) {
                const double y = double(surface->points[i][1]);
                QVERIFY(half.done[i] >= 0 && half.done[i] <= 1);
                if (y > front + 4) QCOMPARE(half.done[i], 0.0F);
                if (y < front - 0.15 * hill_width) QCOMPARE(half.done[i], 1.0F);
            }
        }
        const HalfDone begun = half_done(operation, *surface, 0, {});
        QVERIFY(*std::max_element(begun.done.begin(), begun.done.end()) == 0);
        QCOMPARE(code_of([&] { (void)half_done(std::make_shared<OperationResult>(), *surface, 0.5, {}); }),
                 std::string("empty_result"));
    }

    /// Colours stand behind the tool alone, cuts ahead of it alone.
    void the_picture() {
        RenderRequest request;
        request.part = hill_part();
        request.operations = {hill_operation(21)};
        auto verification = std::make_shared<Verification>();
        verification->surface = judged_hill();
        request.verification = verification;
        request.deviation_scale = DeviationScale{-0.1, 0.2, 0.02, 0.02};
        request.layers = {Layer::deviation, Layer::cl};
        request.view = StandardView::top;
        request.half_done = 0.5;
        request.width = 400;
        request.height = 300;
        const Picture picture = render_picture(request, {});
        std::array<int, 2> green{}, blue{}; // below and above the middle
        for (int y = 0; y < picture.height; ++y)
            for (int x = 40; x < picture.width - 140; ++x) { // without legend and axes
                const std::uint8_t* p = &picture.rgb[3 * std::size_t(y * picture.width + x)];
                const std::size_t half = y < picture.height / 2 ? 1 : 0;
                green[half] += p[1] > p[0] + 40 && p[1] > p[2] + 40;
                blue[half] += p[2] > p[0] + 80 && p[2] > p[1] + 30;
            }
        const QString counted =
            QStringLiteral("%1 %2 %3 %4").arg(green[0]).arg(green[1]).arg(blue[0]).arg(blue[1]);
        QVERIFY2(green[0] > 3000 && green[1] < green[0] / 20, qPrintable(counted));
        QVERIFY2(blue[1] > 500 && blue[0] < blue[1] / 10, qPrintable(counted));
        request.layers = {Layer::cl};
        QCOMPARE(code_of([&] { (void)render_picture(request, {}); }), std::string("empty_result"));
    }

    void directions_by_angles() {
        QVERIFY((parse_eye("0,90", "--view") - Vec3::UnitZ()).norm() < 1e-12);
        QVERIFY((parse_eye("-90, 0", "--view") + Vec3::UnitY()).norm() < 1e-12);
        QVERIFY((parse_eye("45,35.26438968", "--view") - Vec3(1, 1, 1).normalized()).norm() < 1e-8);
        for (const char* wrong : {"45", ",", "a,b", "1,2,3", "400,10", "nan,1"})
            QCOMPARE(code_of([&] { (void)parse_eye(wrong, "--view"); }), std::string("out_of_range"));
    }

    /// Seen as it is asked for, all of the part and of the tool in the picture.
    void eye_and_perspective() {
        RenderRequest request;
        request.part = hill_part();
        request.width = 300;
        request.height = 200;
        request.toward_eye = parse_eye("-60,25", "--view");
        const Picture parallel = render_picture(request, {});
        request.perspective = true;
        const Picture seen = render_picture(request, {});
        QVERIFY(parallel.rgb != seen.rgb);
        request.toward_eye = parse_eye("-60,90", "--view"); // straight from above there is another up
        const Picture above = render_picture(request, {});
        QVERIFY(above.rgb != seen.rgb);
    }
};
FACETMILL_TEST(TestSceneHalfDone)

#include "test_scene_half_done.moc"
