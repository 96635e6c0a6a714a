// The house keeps its order: includes point one way only, core knows no Qt and no VTK, viz no widgets, no
// file grows beyond what one can read, and a name stands for one class alone.
#include "tests/arch/cpp_scanner.h"
#include "tests/arch/source_tree.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <optional>

using namespace facetmill::test;

namespace {

/// A place in the order; a file includes only places that are not above its own.
const std::vector<std::string> order = {"core/base",
                                        "core/mesh",
                                        "core/repair",
                                        "core/cutter",
                                        "core/setup",
                                        "core/tools",
                                        "core/gouge",
                                        "core/cspace",
                                        "core/strategy/plan",
                                        "core/strategy/surface",
                                        "core/strategy/five_axis",
                                        "core/strategy/tilt",
                                        "core/strategy/finish3",
                                        "core/strategy/waterline",
                                        "core/strategy/scallop",
                                        "core/strategy/steep_shallow",
                                        "core/strategy/rough",
                                        "core/strategy/global_local",
                                        "core/strategy/cleanup",
                                        "core/strategy/curves",
                                        "core/strategy/lathe",
                                        "core/strategy/preview",
                                        "core/link",
                                        "core/verify",
                                        "core/output",
                                        "core/job",
                                        "core/study",
                                        "viz",
                                        "ui",
                                        "app"};

std::optional<std::size_t> place_of(const std::string& path) {
    for (std::size_t i = 0; i < order.size(); ++i)
        if (path.rfind(order[i] + "/", 0) == 0) return i;
    return std::nullopt;
}

/// What is wrong with one include, or nothing.
std::optional<std::string> violation(const Include& include) {
    const std::string at = include.file + ":" + std::to_string(include.line) + ": ";
    const auto from = place_of(include.file);
    if (!from) return at + "the folder is not in the order of rooms";
    const bool core = include.file.rfind("core/", 0) == 0, viz = include.file.rfind("viz/", 0) == 0;
    const std::string& t = include.target;
    if (include.quoted) {
        const auto to = place_of(t);
        if (!to) return at + "\"" + t + "\" is not written from the root";
        if (*to > *from) return at + order[*from] + " includes " + order[*to] + ", which lies above it";
        return std::nullopt;
    }
    const bool qt =
        t.size() > 1 && t[0] == 'Q' && (std::isupper(static_cast<unsigned char>(t[1])) || t[1] == 't');
    const bool vtk = t.rfind("vtk", 0) == 0;
    if (core && (qt || vtk)) return at + "core includes <" + t + ">";
    if (viz && qt) return at + "viz includes <" + t + ">";
    return std::nullopt;
}

/// Classes of one name in more than one place. The linker takes one of two functions that are called alike,
/// and the others would work on what is laid out otherwise; nothing warns of it.
QStringList names_given_twice(const std::map<std::string, std::string>& tree) {
    std::map<std::string, QStringList> places;
    for (const auto& [file, text] : tree)
        for (const Extent& e : scan_cpp(text).extents)
            if (e.kind == Extent::Kind::Class && !e.hidden)
                places[e.name] << QString("%1:%2").arg(QString::fromStdString(file)).arg(e.first);
    QStringList twice;
    for (const auto& [name, at] : places)
        if (at.size() > 1) twice << QString("%1: %2").arg(QString::fromStdString(name), at.join(", "));
    return twice;
}

} // namespace

class TestLayers : public QObject {
    Q_OBJECT
private slots:
    void includes_point_down() {
        std::size_t seen = 0;
        QStringList wrong;
        for (const auto& [file, text] : sources({"core", "viz", "ui", "app"}))
            for (const auto& include : includes_in(text, file)) {
                // A file Qt's moc or the build writes stands beside its source.
                if (include.quoted
                    && (include.target.ends_with(".moc") || include.target == "facetmill_version.h"))
                    continue;
                ++seen;
                if (const auto v = violation(include)) wrong << QString::fromStdString(*v);
            }
        QVERIFY(seen > 100); // the scan found the tree
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    void the_check_can_fail() {
        QVERIFY(violation({"core/mesh/a.cpp", 1, "core/cutter/cutter.h", true}));
        QVERIFY(violation({"core/job/a.cpp", 1, "viz/scene.h", true}));
        QVERIFY(violation({"core/base/a.cpp", 1, "QString", false}));
        QVERIFY(violation({"core/base/a.cpp", 1, "QtCore", false}));
        QVERIFY(violation({"core/gouge/a.cpp", 1, "vtkMath.h", false}));
        QVERIFY(violation({"viz/a.cpp", 1, "QWidget", false}));
        QVERIFY(violation({"core/mesh/a.cpp", 1, "mesh.h", true}));
        QVERIFY(violation({"core/strategy/finish3/a.cpp", 1, "core/strategy/rough/rough.h", true}));
        QVERIFY(violation({"core/strategy/a.cpp", 1, "core/base/vec.h", true})); // in no wing
        QVERIFY(violation({"extra/a.cpp", 1, "vector", false}));
        QVERIFY(!violation({"core/cutter/a.cpp", 1, "core/mesh/mesh.h", true}));
        QVERIFY(!violation({"viz/a.cpp", 1, "vtkMath.h", false}));
        QVERIFY(!violation({"ui/a.cpp", 1, "QWidget", false}));
        QCOMPARE(includes_in("#include \"a/b.h\"\n  # include <vector>\n// #include <x>\n", "f").size(),
                 std::size_t(2));
    }

    void a_name_stands_for_one_class() {
        const QStringList twice = names_given_twice(sources({"core", "viz", "ui", "app"}));
        QVERIFY2(twice.isEmpty(), qPrintable(twice.join('\n')));
    }

    void a_name_given_twice_is_found() {
        const std::string a = "namespace n {\nstruct A {};\n}\n";
        QCOMPARE(names_given_twice({{"a.h", a}, {"b.h", a}}), QStringList{"n::A: a.h:2, b.h:2"});
        QVERIFY(names_given_twice({{"a.h", a}, {"b.h", "namespace m {\nstruct A {};\n}\n"}}).isEmpty());
        QVERIFY(names_given_twice({{"a.h", a}, {"b.cpp", "namespace n {\nnamespace {\nstruct A {};\n}\n}\n"}})
                    .isEmpty());
        QVERIFY(names_given_twice(
                    {{"a.h", a}, {"b.h", "namespace n {\nstruct A;\nstruct B {\n  struct A {};\n};\n}\n"}})
                    .isEmpty());
    }

    void files_stay_readable() {
        QStringList wrong;
        for (const auto& [file, text] : sources({"core", "viz", "ui", "app", "tests"})) {
            const auto lines = std::count(text.begin(), text.end(), '\n');
            if (lines > 800) wrong << QString("%1: %2 lines").arg(QString::fromStdString(file)).arg(lines);
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    void headers_are_guarded() {
        QStringList wrong;
        for (const auto& [file, text] : sources({"core", "viz", "ui", "app", "tests"}))
            if (file.ends_with(".h") && text.find("#pragma once") == std::string::npos)
                wrong << QString::fromStdString(file);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }
};

FACETMILL_TEST(TestLayers)
#include "test_layers.moc"
