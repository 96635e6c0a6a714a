// Every kind of operation that is registered, with every cutter, over parts of several kinds, on the mills
// there are: whatever fits together is planned through the whole pipeline and judged by points on the part's
// surface and the seven numbers of the cutter, by nothing of the planner. A new kind is tested here before it
// has a test of its own, and a kind that fits nowhere fails.
#include "core/base/parallel.h"
#include "core/job/planner.h"
#include "core/job/program_files.h"
#include "core/mesh/mesh_io.h"
#include "tests/property/shapes.h"
#include "tests/support/brute_lift.h"
#include "tests/support/cancel_at.h"
#include "tests/support/test_runner.h"
#include "tests/support/trials.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <fstream>
#include <map>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// Coarse, so that all kinds with all cutters over all parts take seconds each.
constexpr double kinds_tolerance = 0.3;

struct KindPart {
    const char* name;
    Mesh mesh;
    bool turns; ///< about X, in round stock
};

const std::vector<KindPart>& kind_parts() {
    static const std::vector<KindPart> all = [] {
        const Vec2 lo(-12, -9), hi(12, 9);
        const auto waves = [](double x, double y) { return 1.5 * std::sin(0.3 * x) * std::cos(0.25 * y); };
        const auto groove = [](double, double y) { return -4 * std::exp(-y * y / 6); };
        Mesh rod;
        const int rings = 12, around = 36;
        for (int i = 0; i <= rings; ++i)
            for (int k = 0; k < around; ++k) {
                const double angle = 2 * pi * k / around, radius = 8 + 1.2 * std::cos(3 * angle) + 0.05 * i;
                rod.vertices.emplace_back(2.0 * i, radius * std::cos(angle), radius * std::sin(angle));
            }
        const auto at = [&](int i, int k) { return Index(i * around + k % around); };
        for (int i = 0; i < rings; ++i)
            for (int k = 0; k < around; ++k) {
                rod.facets.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
                rod.facets.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
            }
        for (int k = 1; k + 1 < around; ++k) {
            rod.facets.push_back({at(0, 0), at(0, k), at(0, k + 1)});
            rod.facets.push_back({at(rings, 0), at(rings, k + 1), at(rings, k)});
        }
        return std::vector<KindPart>{
            {"waves", height_field(waves, lo, hi, 24, 18), false},
            {"groove", height_field(groove, lo, hi, 6, 48), false},
            {"step", only(step(-4, 0), [](const Vec3& p) { return std::abs(p.x()) < 16; }), false},
            {"lobes", std::move(rod), true},
        };
    }();
    return all;
}

Tool numbered(Tool tool, long number) {
    tool.number = number;
    tool.name = "Tool " + std::to_string(number);
    return tool;
}

/// A job of one operation; its own tool is number 1, a much larger one number 2, a much smaller one number 3.
class KindWorkplace {
    QTemporaryDir dir_;

public:
    Project project;

    KindWorkplace(const KindPart& part, const std::string& machine, const std::string& kind,
                  const Tool& tool) {
        const std::filesystem::path folder(dir_.path().toStdString());
        save_stl(part.mesh, folder / "part.stl", LengthUnit::mm, {});
        project.path = folder / "p.facetmill";
        project.part.file = "part.stl";
        project.machine = machine;
        if (part.turns) {
            project.stock.kind = StockSpec::Kind::cylinder;
            project.stock.axis = StockSpec::Axis::x;
            project.stock.margin = {0, 1, 1};
        }
        project.tools = {numbered(tool, 1), numbered(ball_tool(16), 2), numbered(ball_tool(2), 3)};
        for (Tool& t : project.tools) {
            t.flute_length = 30; // no shank in the way: whether shanks are minded is tested elsewhere
            t.shank_diameter = std::min(t.shank_diameter, t.diameter);
        }
        auto op = make_operation(kind);
        op->common().name = "Op";
        op->common().tolerance = kinds_tolerance;
        project.operations.push_back(std::move(op));
    }

    std::shared_ptr<const PlanResult> plan(const Progress& progress = {}) const {
        return Planner().plan(project, {}, progress);
    }
    /// All files that the plan is written to, one after the other, without measured seconds.
    std::string written(const PlanResult& result) const {
        QTemporaryDir out;
        std::string all;
        for (const auto& file :
             write_plan(project, result, std::filesystem::path(out.path().toStdString()) / "plan", {})) {
            if (file.filename() == "report.json") continue;
            std::ifstream in(file, std::ios::binary);
            all += file.filename().string() + "\n";
            all.append(std::istreambuf_iterator<char>(in), {});
        }
        return all;
    }
};

/// Parameters that name another tool, by their key: tried with the larger one and with the smaller one.
std::vector<std::string> keys_of_other_tools(const Operation& op) {
    std::vector<std::string> keys;
    for (const ParameterInfo* p : op.parameters())
        if (std::string_view(p->key).ends_with("_tool")) keys.emplace_back(p->key);
    return keys;
}

/// What was tried and why it does not fit, for a kind that fits nowhere.
using Refusals = std::map<std::string, int>;

/// Plans what fits; null, and why, where it does not. Anything but a refusal in words is a failure of the
/// test.
std::shared_ptr<const PlanResult> planned(KindWorkplace& place, Refusals& refusals) {
    const auto keys = keys_of_other_tools(*place.project.operations.front());
    for (const long other : {2L, 3L}) {
        std::shared_ptr<const PlanResult> result;
        try {
            for (const std::string& key : keys)
                place.project.operations.front()->set(key, other);
            result = place.plan();
            result->check_programs();
            result->check_reach();
            return result;
        } catch (const Error& e) {
            // A path that the machine cannot make is no program either.
            const bool refused = e.code() == ErrorCode::empty_result || e.code() == ErrorCode::out_of_range
                                 || e.code() == ErrorCode::missing_reference || result;
            if (!refused) throw;
            ++refusals[e.what()];
        }
        if (keys.empty()) break;
    }
    return nullptr;
}

/// Points on the part, no farther apart than `spacing`.
std::vector<Vec3> samples_of(const Mesh& mesh, double spacing) {
    std::vector<Vec3> points;
    for (std::size_t f = 0; f < mesh.facet_count(); ++f) {
        const Vec3 a = mesh.corner(f, 0), u = mesh.corner(f, 1) - a, v = mesh.corner(f, 2) - a;
        const int n = 1 + int(std::max({u.norm(), v.norm(), (u - v).norm()}) / spacing);
        for (int i = 0; i <= n; ++i)
            for (int j = 0; i + j <= n; ++j)
                points.push_back(a + double(i) / n * u + double(j) / n * v);
    }
    return points;
}

/// Is the point deeper than `limit` inside the cutting part of the tool that stands there?
bool is_inside(const BruteCutter& cutter, double height, const CutterLocation& at, const Vec3& p,
               double limit) {
    const Vec3 d = p - at.tip;
    const double z = d.dot(at.axis) - limit;
    if (z <= 0 || z > height) return false;
    const double rho = std::sqrt(std::max(d.squaredNorm() - d.dot(at.axis) * d.dot(at.axis), 0.0)) + limit;
    return rho < double(cutter.radius()) && z > double(cutter.height(rho));
}

/// How many of the program's poses have a point of the part deeper than `limit` inside of the cutter.
/// Straight motions are looked at every half millimetre; of a turning part the ends alone, which are close
/// together.
struct Findings {
    std::size_t poses = 0, gouging = 0;
};
Findings gouges(const ClSection& program, const Mesh& part, const std::vector<Vec3>& points, double limit) {
    const BruteCutter cutter(program.cutter);
    const double radius = double(cutter.radius()), height = program.cutter.h;
    const Box3 box = part.box();
    Findings found;
    const auto look = [&](const CutterLocation& at) {
        ++found.poses;
        if (at.axis.z() > 0 && at.tip.z() > box.hi.z() + radius) // above the part
            return;
        found.gouging += std::any_of(points.begin(), points.end(),
                                     [&](const Vec3& p) { return is_inside(cutter, height, at, p, limit); });
    };
    const auto& motions = program.motions.motions;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        look(motions[i].to);
        if (i == 0 || program.motions.turning) continue;
        const CutterLocation &a = motions[i - 1].to, &b = motions[i].to;
        const int steps = std::min(int((b.tip - a.tip).norm() / 0.5), 200);
        for (int k = 1; k < steps; ++k) {
            const double t = double(k) / steps;
            look({a.tip + t * (b.tip - a.tip), (a.axis + t * (b.axis - a.axis)).normalized()});
        }
    }
    return found;
}

const char* const mills[] = {"generic-3-axis", "trunnion-ac", "lathe-mill"};

} // namespace

class TestEveryKind : public QObject {
    Q_OBJECT

    std::map<std::string, int> fits_;
    std::map<std::string, Refusals> refusals_;

private slots:
    void whatever_fits_is_cut_without_a_gouge_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<int>("part");
        QTest::addColumn<int>("cutter");
        const auto tools = tools_of_every_shape();
        // Every cutter on the first part and on one of the others, a ball in the groove as well; what every
        // run has time for: half of the cutters a kind on the first part, the others elsewhere.
        std::size_t nth = 0;
        for (const OperationKind& k : operation_kinds()) {
            ++nth;
            for (std::size_t p = 0; p < kind_parts().size(); ++p)
                for (std::size_t c = 0; c < tools.size(); ++c) {
                    const bool ball_in_groove = p == 1 && c == 0;
                    if (p > 0 && (p + c) % 4 != 0 && !ball_in_groove) continue;
                    if (!all_cases && !ball_in_groove && (nth + c) % 2 != std::min(p, std::size_t(1)))
                        continue;
                    QTest::addRow("%s %s %s", k.kind.c_str(), kind_parts()[p].name, tools[c].name)
                        << QString::fromStdString(k.kind) << int(p) << int(c);
                }
        }
    }

    void whatever_fits_is_cut_without_a_gouge() {
        QFETCH(QString, kind);
        QFETCH(int, part);
        QFETCH(int, cutter);
        const KindPart& p = kind_parts()[std::size_t(part)];
        const std::string name = kind.toStdString();
        const Tool tool = tools_of_every_shape()[std::size_t(cutter)].tool;
        for (const char* machine : mills) {
            KindWorkplace place(p, machine, name, tool);
            const auto result = planned(place, refusals_[name]);
            if (!result) continue;
            ++fits_[name];
            const auto points = samples_of(p.mesh, 0.7);
            QVERIFY(!result->operations.empty());
            for (const auto& op : result->operations) {
                QVERIFY2(op->cl_points > 0, op->name.c_str());
                QVERIFY(std::isfinite(op->path.cusp_max) && op->path.cusp_max >= 0);
                const double chord =
                    op->path.chord_tolerance > 0 ? op->path.chord_tolerance : kinds_tolerance / 20;
                const Findings found = gouges(op->program, p.mesh, points, 2 * chord);
                QVERIFY(found.poses > 10);
                QVERIFY2(found.gouging == 0, qPrintable(QString("%1 on %2: %3 of %4 poses gouge")
                                                            .arg(op->name.c_str(), machine)
                                                            .arg(found.gouging)
                                                            .arg(found.poses)));
            }
            return; // the first machine that can do it
        }
    }

    /// Without this a kind that every combination refuses would pass untested.
    void every_kind_fits_somewhere() {
        for (const OperationKind& k : operation_kinds()) {
            QString why = QString("%1 fits %2 combinations:").arg(k.kind.c_str()).arg(fits_[k.kind]);
            for (const auto& [text, times] : refusals_[k.kind])
                why += QString("\n  %1 x %2").arg(times).arg(text.c_str());
            QVERIFY2(fits_[k.kind] >= (all_cases ? 3 : 2), qPrintable(why));
        }
    }

    void threads_and_cancelling_change_nothing_data() {
        QTest::addColumn<QString>("kind");
        for (const OperationKind& k : operation_kinds())
            QTest::newRow(k.kind.c_str()) << QString::fromStdString(k.kind);
    }

    void threads_and_cancelling_change_nothing() {
        QFETCH(QString, kind);
        for (const KindPart& part : kind_parts())
            for (const char* machine : mills) {
                KindWorkplace place(part, machine, kind.toStdString(), bull_tool(6, 1.5));
                Refusals unused;
                const auto result = planned(place, unused);
                if (!result) continue;
                const std::string reference = place.written(*result);
                QVERIFY(reference.size() > 500);
                set_thread_count(1);
                const std::string alone = place.written(*place.plan());
                set_thread_count(0);
                QVERIFY(alone == reference);
                for (const double at : all_cases ? std::vector{0.0, 0.3, 0.6, 0.9} : std::vector{0.0, 0.6}) {
                    Job job;
                    QVERIFY2(cancelled_at(job, at, [&](const Progress& p) { place.plan(p); }),
                             qPrintable(QString::number(at)));
                }
                QVERIFY(place.written(*place.plan()) == reference);
                return;
            }
        QFAIL("fits no part and no machine");
    }

    /// The judge itself: a path that was let down by a millimetre is found.
    void a_lowered_path_is_found() {
        const KindPart& part = kind_parts().front();
        KindWorkplace place(part, mills[0], "finish3", ball_tool(6));
        ClSection program = place.plan()->operations.front()->program;
        const auto points = samples_of(part.mesh, 0.7);
        QCOMPARE(gouges(program, part.mesh, points, kinds_tolerance / 10).gouging, std::size_t(0));
        for (Motion& m : program.motions.motions)
            if (m.kind == MotionKind::cut) m.to.tip.z() -= 1;
        QVERIFY(gouges(program, part.mesh, points, kinds_tolerance / 10).gouging > 100);
    }
};

FACETMILL_TEST(TestEveryKind)
#include "test_every_kind.moc"
