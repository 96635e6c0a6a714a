// The corpus of odd and broken STL files, file by file.
#include "core/mesh/mesh_format.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"
#include "tests/unit/mesh/mesh_io_support.h"

#include <QTest>

#include <nlohmann/json.hpp>

#include <fstream>

#include <sys/resource.h>

using namespace facetmill;

namespace {

const nlohmann::json& manifest() {
    static const nlohmann::json all =
        nlohmann::json::parse(std::ifstream(test::data_path("data/badstl/manifest.json")));
    return all;
}

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b));
}

/// What differs from the manifest's entry, or empty.
std::string difference(const LoadedMesh& loaded, const nlohmann::json& entry) {
    const MeshReport& r = loaded.report;
    std::string text;
    const auto count = [&](const char* key, std::size_t found) {
        if (entry.at(key).get<std::size_t>() != found)
            text += std::string(key) + " " + std::to_string(found) + " not " + entry.at(key).dump() + "; ";
    };
    count("facets", r.facets);
    count("degenerate", r.degenerate);
    count("duplicate", r.duplicate);
    count("open_edges", r.open_edges);
    count("non_manifold_edges", r.non_manifold_edges);
    count("shells", r.shells);
    count("welded_vertices", r.welded_vertices);
    if (entry.at("warnings") != nlohmann::json(r.warnings))
        text +=
            "warnings " + nlohmann::json(r.warnings).dump() + " not " + entry.at("warnings").dump() + "; ";
    const double box[] = {r.file_box.lo.x(), r.file_box.lo.y(), r.file_box.lo.z(),
                          r.file_box.hi.x(), r.file_box.hi.y(), r.file_box.hi.z()};
    for (std::size_t i = 0; i < 6; ++i)
        if (!near(box[i], entry.at("bbox")[i])) text += "bbox " + std::to_string(i) + "; ";
    // A flat part's volume is a sum that cancels: compare against its size.
    const double volume = entry.at("volume");
    if (!near(r.file_volume, volume)
        && std::abs(r.file_volume - volume) > 1e-9 * r.file_area * r.file_box.diagonal())
        text += "volume " + std::to_string(r.file_volume) + "; ";
    if (loaded.mesh->facets.size() != r.facets - r.degenerate) text += "facets of the mesh; ";
    if (entry.value("non_manifold_vertex", false) && r.non_manifold_vertices == 0)
        text += "non-manifold vertex; ";
    return text;
}

} // namespace

class TestMeshCorpus : public QObject {
    Q_OBJECT
private slots:

    void every_file_data() {
        QTest::addColumn<int>("index");
        QCOMPARE(manifest().at("files").size(), manifest().at("count").get<std::size_t>());
        int i = 0;
        for (const auto& entry : manifest().at("files"))
            QTest::newRow(entry.at("name").get<std::string>().c_str()) << i++;
    }

    void every_file() {
        QFETCH(int, index);
        const auto& entry = manifest().at("files")[std::size_t(index)];
        const std::string path = test::data_path("data/badstl/files/" + entry.at("name").get<std::string>());
        const bool load = entry.at("outcome") == "load";
        try {
            const LoadedMesh loaded = load_mesh(path, LengthUnit::mm, Progress());
            QVERIFY2(load, "must be refused");
            const InputFile file(path);
            for (const MeshFormat& format : mesh_formats())
                if (format.name != "STL") QVERIFY2(!format.sniff(file.bytes()), format.label.data());
            QCOMPARE(QString::fromStdString(difference(loaded, entry)), QString());
            for (const std::string& word : loaded.report.warnings)
                QVERIFY2(!explain_warning(word).empty(), word.c_str());
        } catch (const Error& e) {
            QVERIFY2(!load, e.what());
            const auto& allowed = entry.at("error");
            QVERIFY2(std::find(allowed.begin(), allowed.end(), std::string(code_name(e.code())))
                         != allowed.end(),
                     e.what());
            const std::string line = e.what();
            QVERIFY2(line.find(entry.at("name").get<std::string>()) != std::string::npos,
                     "the message names the file");
            QVERIFY2(line.find('\n') == std::string::npos && !e.remedy().empty(), e.what());
            QVERIFY2(printable(line, line.size()) == line, "the message is printable");
        }
    }

    void memory_stays_small() {
        if (test::under_sanitizer) QSKIP("a sanitizer takes memory of its own");
        // Runs after all files: none of their counts made the program ask for more than the manifest allows.
        struct ::rusage usage {};
        ::getrusage(RUSAGE_SELF, &usage);
        for (const auto& entry : manifest().at("files"))
            QVERIFY(double(usage.ru_maxrss) / 1024.0 < entry.at("max_mb").get<double>());
    }
};

FACETMILL_TEST(TestMeshCorpus)
#include "test_mesh_io_corpus.moc"
