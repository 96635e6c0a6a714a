// The verifier judges what the planners make, so it shares nothing with them: what it includes, directly or
// through any other header, has nothing of their rooms. That it needs none of their objects either is shown
// by its unit tests, which are linked without them.
#include "tests/arch/source_tree.h"
#include "tests/support/test_runner.h"

#include <QTest>

#include <deque>
#include <set>

using namespace facetmill::test;

namespace {

using Tree = std::map<std::string, std::string>; // text by path from the root

const std::string judge = "core/verify/";
const std::vector<std::string> planners = {"core/gouge/", "core/cspace/", "core/strategy/", "core/link/"};
/// The header that is precompiled for every room of core, which each of its files includes unseen.
const std::string precompiled = "cmake/core_pch.h";

/// Everything that the verifier's files include, by path: the chain of files that leads there, the file
/// itself last.
std::map<std::string, std::vector<std::string>> included_by_judge(const Tree& tree) {
    std::map<std::string, std::vector<std::string>> chains;
    std::deque<std::string> open;
    for (const auto& [file, text] : tree)
        if (file.rfind(judge, 0) == 0 || file == precompiled) {
            chains[file] = {file};
            open.push_back(file);
        }
    for (; !open.empty(); open.pop_front()) {
        const auto text = tree.find(open.front());
        if (text == tree.end()) continue;
        for (const auto& include : includes_in(text->second, open.front())) {
            if (!include.quoted || chains.count(include.target)) continue;
            auto chain = chains.at(open.front());
            chain.push_back(include.target);
            chains[include.target] = std::move(chain);
            open.push_back(include.target);
        }
    }
    return chains;
}

/// One line for each file of the planners that the verifier includes, and for each that is not in the tree,
/// through which it could include anything.
QStringList shared_with_planners(const Tree& tree) {
    QStringList wrong;
    for (const auto& [file, chain] : included_by_judge(tree)) {
        QString line;
        for (const auto& step : chain)
            line += (line.isEmpty() ? "" : " includes ") + QString::fromStdString(step);
        const bool planner = std::any_of(planners.begin(), planners.end(),
                                         [&](const std::string& room) { return file.rfind(room, 0) == 0; });
        if (planner) wrong << line + ": the verifier shares nothing with the planners";
        if (!tree.count(file)) wrong << line + ", which is not there";
    }
    return wrong;
}

/// A small tree in which all is well.
Tree honest_tree() {
    return {{"cmake/core_pch.h", "#include <vector>\n"},
            {"core/base/vec.h", "#include <Eigen/Core>\n"},
            {"core/setup/motion.h", "#include \"core/base/vec.h\"\n"},
            {"core/gouge/lift.h", "#include \"core/base/vec.h\"\n"},
            {"core/cspace/posture.h", "#pragma once\n"},
            {"core/strategy/plan/path.h", "#include \"core/setup/motion.h\"\n"},
            {"core/link/link.h", "#include \"core/setup/motion.h\"\n"},
            {"core/verify/program.h", "#include \"core/setup/motion.h\"\n"},
            {"core/verify/verify.cpp", "#include \"core/verify/program.h\"\n"}};
}

} // namespace

class TestJudge : public QObject {
    Q_OBJECT
private slots:
    void shares_nothing_with_the_planners() {
        Tree tree = sources({"core", "cmake"});
        std::set<std::string> rooms;
        for (const auto& [file, chain] : included_by_judge(tree))
            rooms.insert(file.substr(0, file.find('/', file.find('/') + 1) + 1));
        // The scan followed includes beyond the room itself.
        for (const char* room : {"core/base/", "core/mesh/", "core/cutter/", "core/setup/"})
            QVERIFY2(rooms.count(room), room);
        const QStringList wrong = shared_with_planners(tree);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    void sharing_is_found_data() {
        QTest::addColumn<QString>("file");    // that has one line too many
        QTest::addColumn<QString>("include"); // what it says
        QTest::newRow("gouge") << "core/verify/verify.cpp"
                               << "core/gouge/lift.h";
        QTest::newRow("cspace") << "core/verify/verify.cpp"
                                << "core/cspace/posture.h";
        QTest::newRow("a wing of strategy") << "core/verify/program.h"
                                            << "core/strategy/plan/path.h";
        QTest::newRow("link") << "core/verify/program.h"
                              << "core/link/link.h";
        QTest::newRow("through one header") << "core/setup/motion.h"
                                            << "core/gouge/lift.h";
        QTest::newRow("through two headers") << "core/base/vec.h"
                                             << "core/gouge/lift.h";
        QTest::newRow("unseen, precompiled") << "cmake/core_pch.h"
                                             << "core/link/link.h";
        QTest::newRow("a file that is not there") << "core/verify/program.h"
                                                  << "core/mesh/gone.h";
    }
    void sharing_is_found() {
        QFETCH(QString, file);
        QFETCH(QString, include);
        Tree tree = honest_tree();
        QCOMPARE(shared_with_planners(tree), QStringList());
        tree.at(file.toStdString()) += "#include \"" + include.toStdString() + "\"\n";
        const QStringList wrong = shared_with_planners(tree);
        QCOMPARE(wrong.size(), 1);
        QVERIFY2(wrong[0].contains(file + " includes " + include), qPrintable(wrong[0]));
    }
};

FACETMILL_TEST(TestJudge)
#include "test_judge.moc"
