// Part, stock and deviation as meshes: what there is can be written, and reads back as what was shown.
#include "core/mesh/mesh_io.h"
#include "tests/screenshot/window_support.h"
#include "ui/mesh_export.h"
#include "ui/settings_file.h"
#include "ui/verification_controller.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QTest>

#include <array>

using namespace facetmill;
using namespace facetmill::test;
using What = ui::MeshExport::What;

class TestWindowMeshExport : public QObject, private WindowFixture {
    Q_OBJECT

    ui::MeshExport& meshes() { return w().exports().meshes(); }
    QString path(const char* name) { return QDir(folder_).filePath(QLatin1String(name)); }
    Mesh read_back(const QString& file) {
        MeshReading reading;
        if (!file.endsWith(QStringLiteral(".3mf"))) reading.unit = LengthUnit::inch; // 3MF states its own
        return *load_mesh(file.toStdString(), reading, Progress()).mesh;
    }
    Box3 part_box() { return w().document().part()->box; }

    QString folder_;

private slots:
    void init() {
        ui::SettingsFile::own().clear();
        folder_ = scratch_folder(QStringLiteral("mesh_export"));
        QVERIFY(show_window());
    }
    void cleanup() { close_window(); }
    void cleanupTestCase() { ui::SettingsFile::own().clear(); }

    /// The entries of the menu can be chosen as soon as there is what they write.
    void what_there_is_can_be_chosen() {
        const auto enabled = [&] {
            return std::array{action(w(), "export_part")->isEnabled(),
                              action(w(), "export_stock")->isEnabled(),
                              action(w(), "export_deviation")->isEnabled()};
        };
        QCOMPARE(enabled(), (std::array{false, false, false}));
        QVERIFY(open_part());
        QCOMPARE(enabled(), (std::array{true, false, false}));
        QVERIFY(open_and_plan());
        QCOMPARE(enabled(), (std::array{true, true, false}));
        w().verify();
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(enabled(), (std::array{true, true, true}));
        enter(w(), "tolerance", QStringLiteral("0.03"));
        QVERIFY(wait_until_settled(w()));
        QCOMPARE(enabled(), (std::array{true, false, false})); // both would be of other settings
    }

    /// The part comes back as it lies, in the project's unit; the stock is closed and within what stood
    /// before; deviations have a figure for every corner.
    void meshes_read_back_as_what_was_shown() {
        QVERIFY(open_and_plan());
        w().verify();
        QVERIFY(wait_until_settled(w()));
        for (const char* name : {"part.stl", "part.3mf", "part.ply"}) {
            meshes().save(What::part, path(name));
            QVERIFY(wait_until_settled(w()));
            const Mesh mesh = read_back(path(name));
            QCOMPARE(mesh.facet_count(), w().document().part()->mesh->facet_count());
            QVERIFY((mesh.box().lo - part_box().lo).norm() < 1e-4);
            QVERIFY((mesh.box().hi - part_box().hi).norm() < 1e-4);
        }
        meshes().save(What::stock, path("stock.stl"));
        QVERIFY(wait_until_settled(w()));
        const Mesh stock = read_back(path("stock.stl"));
        const Box3 block = w().document().complete_plan()->stock.box;
        QVERIFY(stock.facet_count() > 100);
        for (int k = 0; k < 3; ++k)
            QVERIFY(stock.box().lo[k] > block.lo[k] - 1e-3 && stock.box().hi[k] < block.hi[k] + 1e-3);
        // It was cut: nothing stands as high as the block did over the middle of the part.
        double highest = -infinity;
        const Vec3 middle = 0.5 * (part_box().lo + part_box().hi);
        for (const Vec3& v : stock.vertices)
            if ((v - middle).head<2>().norm() < 10) highest = std::max(highest, v.z());
        QVERIFY(highest < block.hi.z() - 1 && highest > block.lo.z());

        meshes().save(What::deviation, path("deviation.ply"));
        QVERIFY(wait_until_settled(w()));
        QFile file(path("deviation.ply"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray head = file.read(2000);
        QVERIFY2(head.contains("property float deviation"), head.constData());
        QVERIFY(head.contains("property uchar red"));
        const auto& surface = *w().verification().model().verification().surface;
        QVERIFY(head.contains("element vertex " + QByteArray::number(qulonglong(surface.points.size()))));
    }

    /// Asked by the menu; nothing is written over the part, nor in a format that there is not.
    void files_that_are_refused() {
        QVERIFY(open_part());
        bool asked = false;
        answer_file_dialog(asked, path("by-menu.stl"));
        action(w(), "export_part")->trigger();
        QVERIFY(wait_until_settled(w()));
        QVERIFY(asked && QFile::exists(path("by-menu.stl")));
        const QString own = QString::fromStdString(w().document().project().part.file);
        QFile before(own);
        QVERIFY(before.open(QIODevice::ReadOnly));
        const QByteArray bytes = before.readAll();
        before.close();
        meshes().save(What::part, own);
        QVERIFY(wait_until_settled(w()));
        QVERIFY(before.open(QIODevice::ReadOnly));
        QCOMPARE(before.readAll(), bytes);
        meshes().save(What::part, path("part.step"));
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!QFile::exists(path("part.step")));
        meshes().save(What::stock, path("stock.stl")); // there is none yet
        QVERIFY(wait_until_settled(w()));
        QVERIFY(!QFile::exists(path("stock.stl")));
    }
};

FACETMILL_TEST(TestWindowMeshExport)
#include "test_window_mesh_export.moc"
