// deviation.vtp as VTK itself reads it.
#include "core/job/verification.h"
#include "tests/support/test_runner.h"

#include <QTemporaryDir>
#include <QTest>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

using namespace facetmill;

class TestDeviationFile : public QObject {
    Q_OBJECT
private slots:
    void vtk_reads_what_was_written() {
        auto part = std::make_shared<Mesh>();
        part->vertices = {Vec3(0, 0, 0), Vec3(20, 0, 0), Vec3(20, 20, 0), Vec3(0, 20, 0)};
        part->facets = {{0, 1, 2}, {0, 2, 3}};
        auto motions = std::make_shared<ToolMotions>();
        const auto go = [&](MotionKind kind, const Vec3& tip) {
            motions->motions.push_back({kind, {tip, Vec3::UnitZ()}, no_index, no_index});
        };
        go(MotionKind::rapid, Vec3(-10, 10, 20));
        go(MotionKind::approach, Vec3(-10, 10, 0.5));
        go(MotionKind::cut, Vec3(30, 10, 0.5));
        const std::vector<VerifyProgram> programs{
            {"Cut", VerifyTool(AptCutter::ball(8, 20)), motions, std::nullopt}};
        StockSolid stock;
        stock.box.add(Vec3(0, 0, -2));
        stock.box.add(Vec3(20, 20, 3));
        VerifySettings settings;
        settings.resolution = 0.5;
        const Verification v = verify(*part, stock, programs, settings, Progress());

        Project project;
        project.unit = LengthUnit::inch;
        QTemporaryDir folder;
        write_verification(project, programs, v, folder.path().toStdString(), Progress());
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName((folder.path() + "/deviation.vtp").toUtf8().constData());
        reader->Update();
        vtkPolyData* data = reader->GetOutput();
        const DeviationSurface& s = *v.surface;
        QCOMPARE(std::size_t(data->GetNumberOfPoints()), s.points.size());
        QCOMPARE(std::size_t(data->GetNumberOfPolys()), s.triangles.size());
        vtkDataArray* deviation = data->GetPointData()->GetScalars();
        vtkDataArray* normals = data->GetPointData()->GetNormals();
        vtkDataArray* flags = data->GetPointData()->GetArray("flag");
        QVERIFY(deviation && normals && flags);
        QCOMPARE(deviation->GetName(), "deviation");
        bool cut = false, whole = false;
        for (std::size_t i = 0; i < s.points.size(); ++i) {
            const auto id = vtkIdType(i);
            for (int k = 0; k < 3; ++k) {
                QVERIFY(std::abs(data->GetPoint(id)[k] * 25.4 - double(s.points[i][std::size_t(k)])) < 1e-5);
                QCOMPARE(float(normals->GetComponent(id, k)), s.normals[i][std::size_t(k)]);
            }
            const double d = deviation->GetComponent(id, 0) * 25.4;
            QVERIFY(std::abs(d - double(s.deviation[i])) < 1e-5);
            QCOMPARE(int(flags->GetComponent(id, 0)), int(s.flags[i]));
            cut = cut || std::abs(d - 0.5) < 1e-6;
            whole = whole || std::abs(d - 3) < 1e-6;
        }
        QVERIFY(cut && whole); // under the ball, and where it never was
        vtkNew<vtkIdList> corners;
        for (std::size_t i = 0; i < s.triangles.size(); ++i) {
            data->GetCellPoints(vtkIdType(i), corners);
            QCOMPARE(int(corners->GetNumberOfIds()), 3);
            for (int k = 0; k < 3; ++k)
                QCOMPARE(std::uint32_t(corners->GetId(k)), s.triangles[i][std::size_t(k)]);
        }
    }
};

FACETMILL_TEST(TestDeviationFile)
#include "test_deviation_file.moc"
