// Posted programs in front of somebody else's interpreter: rs274 of LinuxCNC (Debian's linuxcnc-uspace).
#include "tests/support/test_runner.h"
#include "tests/unit/output/posted_parts.h"

#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

using Place = std::array<double, 6>;

struct Interpreted {
    int status = -1;
    QByteArray message;
    std::vector<Place> places; ///< X, Y, Z and A, B, C of every straight motion
};

QString rs274_program() {
    return QStandardPaths::findExecutable("rs274");
}

/// Each run has a home of its own: runs that share one spoil each other's.
Interpreted interpret(const std::string& text, const ClProgram& program) {
    QTemporaryDir home;
    const auto write = [&](const QString& name, const QByteArray& bytes) {
        QFile file(home.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("cannot write");
    };
    write("p.ngc", QByteArray::fromStdString(text));
    write("p.var", "");
    QByteArray table;
    for (const auto& s : program.sections) // lengths are inches here, whatever the program has
        table +=
            QString("T%1 P%1 Z%2 D0.1\n").arg(s->tool_number).arg(s->gauge_length / 25.4, 0, 'f', 9).toUtf8();
    write("tool.tbl", table);
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("HOME", home.path());
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(home.path());
    process.setStandardInputFile(QProcess::nullDevice());
    process.start(rs274_program(), {"-g", "-t", "tool.tbl", "-v", "p.var", "p.ngc"});
    Interpreted result;
    if (!process.waitForFinished(60000) || process.exitStatus() != QProcess::NormalExit) return result;
    result.status = process.exitCode();
    result.message = process.readAllStandardError();
    for (const QByteArray& line : process.readAllStandardOutput().split('\n')) {
        const auto open = line.indexOf('(');
        if (open < 0 || (!line.contains("STRAIGHT_TRAVERSE(") && !line.contains("STRAIGHT_FEED("))) continue;
        const QList<QByteArray> numbers = line.mid(open + 1).chopped(1).split(',');
        Place at{};
        for (int k = 0; k < 6 && k < numbers.size(); ++k)
            at[std::size_t(k)] = numbers[k].trimmed().toDouble();
        result.places.push_back(at);
    }
    return result;
}

/// The ways in which the machine can hold the place of every motion, in the words of the control.
std::vector<std::vector<Place>> wanted_places(const ClProgram& program, const PostSetup& setup) {
    std::vector<std::vector<Place>> all;
    for (const auto& s : program.sections) {
        const Kinematics kinematics(setup.machine, s->gauge_length, setup.part_origin);
        for (const Motion& m : s->motions.motions) {
            const Kinematics::Solutions held = kinematics.inverse({m.to.tip, m.to.axis}, {});
            std::vector<Place> held_so;
            for (int k = 0; k < held.count; ++k) {
                const Joints& at = held.at[std::size_t(k)];
                const Vec3 words = at.linear - setup.part_origin - Vec3(0, 0, s->gauge_length);
                Place place{words.x(), words.y(), words.z(), 0, 0, 0};
                for (std::size_t r = 0; r < setup.machine.rotary.size(); ++r)
                    place[3 + std::size_t(setup.machine.rotary[r].name[0] - 'A')] = degrees(at.rotary[r]);
                held_so.push_back(place);
            }
            all.push_back(held_so);
        }
    }
    return all;
}

/// The largest difference of two places; whole turns count for nothing, and angles are printed apart.
double difference(const Place& a, const Place& b) {
    double most = 0;
    for (std::size_t k = 0; k < 6; ++k)
        most =
            std::max(most, k < 3 ? std::abs(a[k] - b[k]) : std::abs(std::remainder(a[k] - b[k], 360)) - 1e-5);
    return most;
}

} // namespace

class TestPostsRs274 : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        if (rs274_program().isEmpty())
            QSKIP(
                "SKIPPED: no rs274 on this machine (Debian: linuxcnc-uspace), posted programs were not shown "
                "to LinuxCNC's interpreter");
    }

    void programs_are_accepted_data() {
        QTest::addColumn<QString>("post");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<bool>("leans");
        QTest::newRow("grbl") << "grbl"
                              << "generic-3-axis" << false;
        QTest::newRow("linuxcnc") << "linuxcnc"
                                  << "generic-3-axis" << false;
        for (const char* machine : {"trunnion-ac", "trunnion-bc", "head-b-table-c", "tarus-tpi-2000"})
            QTest::addRow("linuxcnc, %s", machine) << "linuxcnc" << machine << true;
    }
    /// Status 0, and every place of the program to half a digit of what the interpreter prints.
    void programs_are_accepted() {
        QFETCH(QString, post);
        QFETCH(QString, machine);
        QFETCH(bool, leans);
        std::vector<ClSection> sections = {leans ? leaning_section("One", 1) : upright_section("One (1)", 1)};
        if (post == "linuxcnc") sections.push_back(upright_section("Two", 2, 5));
        const ClProgram program = joined_program(sections);
        const PostSetup setup = setup_for(program, machine.toStdString());
        const Post& control = find_post(post.toStdString());
        const Interpreted seen = interpret(post_program(program, control, setup, {}).text, program);
        QVERIFY2(seen.status == 0, seen.message.constData());
        const double digit = std::max(std::pow(10, -control.mm_decimals), 1e-4);
        std::size_t at = 0;
        for (const std::vector<Place>& held_so : wanted_places(program, setup)) {
            const auto there = [&](const Place& p) {
                return std::any_of(held_so.begin(), held_so.end(),
                                   [&](const Place& w) { return difference(p, w) < 0.501 * digit; });
            };
            while (at < seen.places.size() && !there(seen.places[at]))
                ++at;
            QVERIFY2(at < seen.places.size(), "a place is missing");
        }
        if (leans) QVERIFY(seen.places.size() > wanted_places(program, setup).size());
    }

    /// The interpreter reads what stands in brackets of its own: a name with one must not come through.
    void a_name_moves_nothing() {
        ClSection section = upright_section("a", 1);
        section.motions.motions.resize(4);
        const ClProgram plain = joined_program({section});
        const PostSetup setup = setup_for(plain, "generic-3-axis");
        const auto places = [&](const ClProgram& p) {
            const Interpreted seen = interpret(post_program(p, find_post("linuxcnc"), setup, {}).text, p);
            return seen.status == 0 ? seen.places.size() : 0;
        };
        section.operation_name = "(part bracket) G0 Z-50 (x)";
        section.tool_name = "a)\nG0 Z-40\n(";
        ClProgram hostile = joined_program({section});
        hostile.part_name = "%\nM2";
        QVERIFY(places(plain) > 0);
        QCOMPARE(places(hostile), places(plain));
    }
};

FACETMILL_TEST(TestPostsRs274)
#include "test_posts_rs274.moc"
