// STEP files of many solids, units and editions, and what is left of them when they are cut or entities go:
// the volume of the solid within what is told, or a word about it.
#include "core/mesh/mesh_io.h"
#include "tests/support/surface_files.h"
#include "tests/support/test_runner.h"
#include "tests/unit/mesh/step_text.h"

#include "core/base/error.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace facetmill;
using namespace facetmill::test;

namespace {

double enclosed_by(const Mesh& mesh) {
    double six = 0;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f)
        six += mesh.corner(f, 0).dot(mesh.corner(f, 1).cross(mesh.corner(f, 2)));
    return six / 6;
}

LoadedMesh read_step(const std::string& bytes) {
    return read_mesh(bytes, "a.step", {}, Progress());
}

/// Closed, of this volume as far as is told, and without a word.
QString wrong_with(const LoadedMesh& loaded, double exact) {
    const MeshReport& r = loaded.report;
    if (!r.watertight || !r.surfaces || r.surfaces->loose_faces != 0) return "it is open";
    const double off = std::abs(enclosed_by(*loaded.mesh) - exact);
    const double band = (r.surfaces->out + r.surfaces->in) * r.area_mm2() + 1e-9 * exact;
    if (off > band) return QString("volume %1, not %2").arg(enclosed_by(*loaded.mesh)).arg(exact);
    return {};
}

} // namespace

class TestSurfaceKinds : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
#ifdef FACETMILL_STEP_PROGRAM
        qputenv("FACETMILL_STEP", FACETMILL_STEP_PROGRAM);
#endif
    }

    /// Every solid by every edition of the standard that is written, each in another unit and order.
    void solids_of_known_volume() {
        if (no_surface_files()) QSKIP(no_surface_files());
        const std::array<const char*, 4> units = {"MM", "INCH", "M", "CM"};
        std::size_t n = 0;
        for (const std::string& name : step_solids())
            for (const int schema : {1, 3, 4, 5}) {
                const StepSolid solid = step_solid(name, units[n % units.size()], schema);
                std::string text = solid.bytes;
                std::vector<std::string> entities = entities_of(text);
                if (n % 3 == 1) std::reverse(entities.begin(), entities.end());
                if (n % 5 != 0) text = with_entities(text, entities);
                if (n % 2 == 1) text = replaced_all(text, "\n", "\r\n");
                if (n % 7 == 2) text = replaced_all(text, ",", " , ");
                ++n;
                const LoadedMesh loaded = read_step(text);
                const QString wrong = wrong_with(loaded, solid.volume);
                QVERIFY2(wrong.isEmpty(),
                         qPrintable(QString("%1, schema %2: %3").arg(name.c_str()).arg(schema).arg(wrong)));
                QVERIFY2(loaded.report.warnings.empty() || *loaded.report.warnings.begin() != "loose_faces",
                         name.c_str());
            }
        QCOMPARE(n, 40);
    }

    /// Cut anywhere it is refused.
    void cut_files_are_refused() {
        if (no_surface_files()) QSKIP(no_surface_files());
        const std::string whole = step_solid("hole").bytes;
        const std::size_t end = whole.find("END-ISO");
        for (std::size_t k = 1; k <= 20; ++k)
            try {
                read_step(whole.substr(0, end * k / 20));
                QFAIL(qPrintable(QString("cut at %1 of 20").arg(k)));
            } catch (const Error& e) {
                QVERIFY2(e.code() == ErrorCode::truncated || e.code() == ErrorCode::unsupported_format,
                         e.what());
                QVERIFY(!e.remedy().empty());
            }
    }

    /// One kind of entity is gone, or one of them is: refused, or the same solid, or a word that says it is
    /// not whole.
    void missing_entities_are_noticed() {
        if (no_surface_files()) QSKIP(no_surface_files());
        const StepSolid solid = step_solid("hole");
        const std::vector<std::string> entities = entities_of(solid.bytes);
        int tried = 0, refused = 0;
        for (const char* kind :
             {"ADVANCED_FACE", "FACE_BOUND", "EDGE_LOOP", "ORIENTED_EDGE", "EDGE_CURVE", "VERTEX_POINT",
              "CARTESIAN_POINT", "DIRECTION", "VECTOR", "LINE", "CIRCLE", "PLANE", "CYLINDRICAL_SURFACE",
              "AXIS2_PLACEMENT_3D", "CLOSED_SHELL", "MANIFOLD_SOLID_BREP",
              "ADVANCED_BREP_SHAPE_REPRESENTATION", "SHAPE_DEFINITION_REPRESENTATION"})
            for (const bool all : {false, true}) {
                std::vector<std::string> left;
                bool gone = false;
                for (const std::string& entity : entities) {
                    const bool is_one = entity.find(std::string("=") + kind) != std::string::npos
                                        || entity.find(std::string("= ") + kind) != std::string::npos;
                    if (is_one && (all || !gone))
                        gone = true;
                    else
                        left.push_back(entity);
                }
                if (!gone) continue;
                ++tried;
                try {
                    const LoadedMesh loaded = read_step(with_entities(solid.bytes, left));
                    const QString wrong = wrong_with(loaded, solid.volume);
                    QVERIFY2(wrong.isEmpty() || !loaded.report.warnings.empty(),
                             qPrintable(QString("%1: %2, and nothing is said").arg(kind, wrong)));
                } catch (const Error& e) {
                    ++refused;
                    QVERIFY2(e.code() != ErrorCode::internal && !e.remedy().empty(), e.what());
                }
            }
        QVERIFY2(tried >= 28 && refused >= 12, qPrintable(QString("%1, %2").arg(tried).arg(refused)));
    }
};

FACETMILL_TEST(TestSurfaceKinds)
#include "test_surface_kinds.moc"
