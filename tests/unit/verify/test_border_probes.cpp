// What probes at the open border of a part say of a tool that comes by in touch with the edge.
#include "core/verify/verify.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;

namespace {

/// An upright sheet of 10 by 10 mm, y = 0, whose borders at x = 0 and x = 10 are upright; so finely divided
/// that its facets need no samples but their corners, or of two facets.
Mesh sheet(int pieces) {
    Mesh mesh;
    const double side = 10.0 / pieces;
    for (int i = 0; i <= pieces; ++i)
        for (int j = 0; j <= pieces; ++j)
            mesh.vertices.push_back(Vec3(side * i, 0, side * j - 10));
    for (int i = 0; i < pieces; ++i)
        for (int j = 0; j < pieces; ++j) {
            const auto at = [&](int a, int b) { return Index((i + a) * (pieces + 1) + j + b); };
            mesh.facets.push_back({at(0, 0), at(1, 0), at(1, 1)});
            mesh.facets.push_back({at(0, 0), at(1, 1), at(0, 1)});
        }
    return mesh;
}

/// A cutter of diameter 12 goes down beside the border at x = 0, so near that it cuts `depth` off.
Verification beside(const Mesh& part, double depth) {
    ToolMotions motions;
    motions.clearance_z = 10;
    const double x = depth - 6;
    motions.motions = {{MotionKind::rapid, {Vec3(x, 0, 10), Vec3::UnitZ()}, no_index, no_index},
                       {MotionKind::cut, {Vec3(x, 0, -20), Vec3::UnitZ()}, no_index, no_index}};
    Tool tool;
    tool.diameter = tool.shank_diameter = 12;
    tool.flute_length = 40;
    StockSolid stock;
    stock.box = part.box();
    stock.box.lo -= Vec3(1, 1, 0);
    stock.box.hi += Vec3(1, 1, 0);
    VerifySettings settings;
    settings.resolution = 0.5;
    settings.gouge_limit = 0.003;
    const VerifyProgram program{"Beside", VerifyTool(tool), std::make_shared<ToolMotions>(motions), {}};
    return verify(part, stock, {&program, 1}, settings, Progress());
}

} // namespace

class TestBorderProbes : public QObject {
    Q_OBJECT
private slots:
    void a_tool_in_touch_with_the_border_is_no_gouge_data() {
        QTest::addColumn<int>("pieces");
        QTest::newRow("two facets") << 1;
        QTest::newRow("many facets") << 40;
    }
    /// Half of the cutter's chord at a depth of 0.0025 mm is 0.17 mm: on the border itself, that would be how
    /// deep it is found across the sheet.
    void a_tool_in_touch_with_the_border_is_no_gouge() {
        QFETCH(int, pieces);
        const Mesh part = sheet(pieces);
        for (const double depth : {0.0, 0.001, 0.0025}) {
            const Verification v = beside(part, depth);
            QVERIFY2(!v.gouged(), qPrintable(QString::number(v.border.gouge_max)));
        }
        for (const double depth : {0.01, 0.1})
            QVERIFY(beside(part, depth).gouged());
    }
};

FACETMILL_TEST(TestBorderProbes)
#include "test_border_probes.moc"
