// Postures along a pass: always free, and the best there are where that is known.
#include "core/cspace/choose.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/setup/machine.h"
#include "tests/support/test_runner.h"
#include "tests/unit/cspace/cspace_cases.h"

#include <QTest>

#include <array>
#include <cstring>
#include <functional>

using namespace facetmill;
using namespace facetmill::test;

namespace {

constexpr double feed = 40; // mm/s

using Method = std::vector<ChosenPosture> (*)(std::span<const PassPoint>, const ChooseInput&,
                                              const Progress&);
constexpr std::array<Method, 3> methods{choose_cm2, choose_local, choose_global};

Box3 box_of(const Mesh& mesh) {
    Box3 box;
    for (const Vec3& p : mesh.vertices)
        box.add(p);
    return box;
}

/// Contact points in a row, with all that choosing postures there asks for.
struct Row {
    Bench bench;
    Kinematics kinematics;
    std::vector<std::vector<RaisedCurve>> curves;
    std::vector<CSpace> spaces;
    std::vector<PassPoint> points;
    std::unique_ptr<CSpaceBuilder> builder;
    ChooseInput input;

    Row(Mesh mesh, const Tool& tool, const PostureGrid& grid, const std::vector<ContactFrame>& frames,
        const char* machine = "tarus-tpi-2000", double tau = 0.4)
        : bench(std::move(mesh), tool),
          kinematics(find_machine(machine), gauge_length(tool),
                     default_part_origin(find_machine(machine), box_of(*bench.mesh))) {
        bench.grid = grid;
        bench.input.kinematics = &kinematics;
        bench.input.lowest_axis_z = tolerance::lowest_axis_z;
        builder = std::make_unique<CSpaceBuilder>(bench.input);
        for (const ContactFrame& f : frames) {
            const auto line = [&](double side) {
                const Vec3 middle = f.point + side * f.left + tau * f.normal;
                return RaisedCurve{middle - 9 * f.feed, middle, middle + 9 * f.feed};
            };
            curves.push_back({line(-0.8), line(0.8)});
        }
        spaces = builder->build(frames, curves, Progress());
        for (std::size_t i = 0; i < frames.size(); ++i)
            points.push_back({frames[i], &spaces[i], &curves[i], grid.lead.front()});
        input.builder = builder.get();
        input.feed = feed;
        input.turn_limit = pi;
    }

    ToolPose pose(std::size_t i, const PostureValue& p) const {
        return posture_pose(bench.lift.cutter(), points[i].frame, p);
    }
    bool all_free() const {
        for (const CSpace& s : spaces)
            for (const PostureBlock b : s.block)
                if (b != PostureBlock::free) return false;
        return true;
    }
};

/// Seconds between two ways to hold poses, from the joints themselves.
double seconds(const Kinematics& k, const ToolPose& a, const Joints& ja, const ToolPose& b, Joints jb) {
    // C goes round, A ends at 110 degrees.
    while (jb.rotary[0] - ja.rotary[0] > pi)
        jb.rotary[0] -= 2 * pi;
    while (jb.rotary[0] - ja.rotary[0] < -pi)
        jb.rotary[0] += 2 * pi;
    const double joints = k.time(ja, jb);
    return std::max((b.tip - a.tip).norm() / feed, joints) + 0.04 * joints;
}

/// Of a sequence of poses, held in the best ways: all combinations.
double best_seconds(const Kinematics& k, std::span<const ToolPose> poses, std::size_t i = 0,
                    const Joints* last = nullptr) {
    if (i == poses.size()) return 0;
    double least = infinity;
    const auto routes = k.inverse(poses[i], last ? *last : Joints{});
    for (std::size_t w = 0; w < std::size_t(routes.count); ++w) {
        const double step = last ? seconds(k, poses[i - 1], *last, poses[i], routes.at[w]) : 0;
        least = std::min(least, step + best_seconds(k, poses, i + 1, &routes.at[w]));
    }
    return least;
}

/// On facets of a mesh, in the order of their x.
std::vector<ContactFrame> along_x(const Mesh& mesh, std::size_t count, Random& rng) {
    std::vector<ContactFrame> frames;
    for (std::size_t i = 0; i < count; ++i) {
        const auto f = std::size_t(whole(rng, 0, int(mesh.facet_count()) - 1));
        const Vec3 point = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
        frames.push_back(ContactFrame::at(point, mesh.facet_normal(f), Vec3::UnitX()));
    }
    std::sort(frames.begin(), frames.end(),
              [](const auto& a, const auto& b) { return a.point.x() < b.point.x(); });
    return frames;
}

std::vector<ContactFrame> over_a_plane(std::size_t count, double step, const Vec3& travel,
                                       const Vec3& start = Vec3::Zero()) {
    std::vector<ContactFrame> frames;
    for (std::size_t i = 0; i < count; ++i)
        frames.push_back(ContactFrame::at(start + double(i) * step * travel, Vec3::UnitZ(), travel));
    return frames;
}

const Tool small_tool = tool_of(6, 1, 12, 6, 30, 20);

} // namespace

class TestChoose : public QObject {
    Q_OBJECT
private slots:

    /// Whatever is chosen lies in the configuration space and within the machine's reach, judged anew.
    void chosen_postures_are_free() {
        std::array<int, 3> chosen{};
        for (const std::uint64_t seed : {1, 2, 3, 4}) {
            Random rng(seed);
            const auto mesh = hills(seed);
            const Row row(*mesh, small_tool,
                          PostureGrid::make(0, radians(40), radians(-40), radians(40), radians(8)),
                          along_x(*mesh, 12, rng));
            for (std::size_t m = 0; m < methods.size(); ++m) {
                const auto choices = methods[m](row.points, row.input, Progress());
                QCOMPARE(choices.size(), row.points.size());
                for (std::size_t i = 0; i < choices.size(); ++i) {
                    if (!choices[i].free) continue;
                    ++chosen[m];
                    const PostureValue& p = choices[i].posture;
                    ToolLift::Hint hint;
                    const ContactFrame& frame = row.points[i].frame;
                    QVERIFY(p.delta >= row.builder->bottom(frame, p.lead, p.yaw, hint));
                    QVERIFY(p.delta <= row.builder->top(frame, p.lead, p.yaw, row.curves[i]));
                    QVERIFY(row.builder->holds(frame, p));
                    QVERIFY(p.lead >= 0 && p.lead <= radians(40) + 1e-12);
                    QVERIFY(std::abs(p.yaw) <= radians(40) + 1e-12);
                }
            }
        }
        for (const int count : chosen)
            QVERIFY2(count >= 20, qPrintable(QString::number(count)));
        QVERIFY(chosen[2] >= chosen[0]); // where anything on the grid is free, global has it
    }

    /// Refined between nodes, the path is at least as good as the best over the nodes, which is found by
    /// trying every combination.
    void global_is_the_best_of_all_combinations() {
        int compared = 0;
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            Random rng(seed);
            const auto mesh = hills(seed);
            Row row(*mesh, small_tool,
                    PostureGrid::make(0, radians(30), radians(-15), radians(15), radians(15)),
                    along_x(*mesh, 4, rng));
            if (seed % 2 == 0)
                row.input.before =
                    ToolPose{row.points[0].frame.point + Vec3(-5, 3, 1),
                             Vec3(uniform(rng, -0.4, 0.4), uniform(rng, -0.4, 0.4), 1).normalized()};
            std::vector<std::vector<ToolPose>> poses;
            for (std::size_t i = 0; i < row.points.size(); ++i) {
                poses.emplace_back();
                for (std::size_t l = 0; l < row.bench.grid.lead.size(); ++l)
                    for (std::size_t o = 0; o < row.bench.grid.yaw.size(); ++o) {
                        const std::size_t n = row.bench.grid.node(l, o);
                        if (row.spaces[i].block[n] == PostureBlock::free)
                            poses[i].push_back(row.pose(
                                i, {row.bench.grid.lead[l], row.bench.grid.yaw[o], row.spaces[i].bottom[n]}));
                    }
            }
            if (std::any_of(poses.begin(), poses.end(), [](const auto& p) { return p.empty(); })) continue;
            double least = infinity;
            std::vector<ToolPose> path;
            if (row.input.before) path.push_back(*row.input.before);
            const std::function<void(std::size_t)> tried = [&](std::size_t i) {
                if (i == poses.size()) {
                    least = std::min(least, best_seconds(row.kinematics, path));
                    return;
                }
                for (const ToolPose& p : poses[i]) {
                    path.push_back(p);
                    tried(i + 1);
                    path.pop_back();
                }
            };
            tried(0);
            const auto choices = choose_global(row.points, row.input, Progress());
            for (std::size_t i = 0; i < choices.size(); ++i) {
                QVERIFY(choices[i].free);
                path.push_back(row.pose(i, choices[i].posture));
            }
            const double found = best_seconds(row.kinematics, path);
            // Three thousandths are given for axes that run evenly.
            QVERIFY2(found <= 1.003 * least + 5e-4,
                     qPrintable(QString("%1 %2 %3").arg(seed).arg(found).arg(least)));
            ++compared;
        }
        QVERIFY2(compared >= 5, qPrintable(QString::number(compared)));
    }

    /// Where an axis can stay, it stays: that of the pass before. It may turn a little while the tip moves.
    void local_keeps_the_axis() {
        const Row plane(level_plane(300), small_tool,
                        PostureGrid::make(0, radians(30), radians(-60), radians(60), radians(6)),
                        over_a_plane(6, 3, Vec3::UnitX()), "tarus-tpi-2000", 4);
        QVERIFY(plane.all_free());
        ChooseInput input = plane.input;
        const Vec3 before = posture_axis(plane.points[0].frame, radians(13), radians(25));
        input.before = ToolPose{Vec3(-5, 0, 0), before};
        for (const ChosenPosture& c : choose_local(plane.points, input, Progress())) {
            QVERIFY(c.free);
            const Vec3 axis = posture_axis(plane.points[0].frame, c.posture.lead, c.posture.yaw);
            QVERIFY2(std::acos(std::min(axis.dot(before), 1.0)) < radians(4),
                     qPrintable(QString("%1 %2").arg(degrees(c.posture.lead)).arg(degrees(c.posture.yaw))));
        }
        // With nowhere to come from it begins as CM2 does.
        const auto alone = choose_local(plane.points, plane.input, Progress());
        const auto cm2 = choose_cm2(plane.points, plane.input, Progress());
        QVERIFY(std::abs(alone[0].posture.lead - cm2[0].posture.lead) < radians(1));
        QCOMPARE(cm2[0].posture.yaw, 0.0);
    }

    /// The next pass comes back; leaning aside there is an axis that both can hold, and from point to point C
    /// turns by a node of the grid while the tip moves.
    void global_ends_as_the_next_pass_begins() {
        const PostureGrid aside =
            PostureGrid::make(radians(20), radians(20), radians(-90), radians(90), radians(5));
        const Row there(level_plane(300), small_tool, aside,
                        over_a_plane(25, 16, Vec3::UnitX(), Vec3(-200, 0, 0)), "tarus-tpi-2000", 6);
        const Row back(level_plane(300), small_tool, aside,
                       over_a_plane(20, 16, -Vec3::UnitX(), Vec3(184, 2, 0)), "tarus-tpi-2000", 6);
        QVERIFY(there.all_free() && back.all_free());
        ChooseInput input = there.input;
        input.before = there.pose(0, {radians(20), 0, 0});
        const auto turned = [&](const std::vector<ChosenPosture>& choices) {
            const Vec3 last = there.pose(choices.size() - 1, choices.back().posture).axis;
            double least = pi;
            for (const double yaw : aside.yaw)
                least = std::min(
                    least, std::acos(std::min(back.pose(0, {radians(20), yaw, 0}).axis.dot(last), 1.0)));
            return least;
        };
        const double blind = turned(choose_global(there.points, input, Progress()));
        input.next = back.points;
        const double seeing = turned(choose_global(there.points, input, Progress()));
        QVERIFY2(seeing < radians(1), qPrintable(QString::number(degrees(seeing))));
        QVERIFY2(blind > radians(5), qPrintable(QString::number(degrees(blind))));
    }

    /// A table that changes its speed slowly is spared.
    void accelerations_are_minded() {
        double plain = 0, minded = 0;
        for (const std::uint64_t seed : {21, 22, 23, 24, 25, 26}) {
            Random rng(seed);
            const auto mesh = hills(seed);
            Row row(*mesh, small_tool,
                    PostureGrid::make(0, radians(40), radians(-40), radians(40), radians(8)),
                    along_x(*mesh, 14, rng), "trunnion-ac");
            const Machine& machine = row.kinematics.machine();
            // What motion_time counts, with joints that follow each other.
            const auto counted = [&](const std::vector<ChosenPosture>& choices) {
                double sum = 0;
                std::optional<Joints> last;
                ToolPose last_pose;
                std::array<double, 5> speed{};
                int moves = 0;
                for (std::size_t i = 0; i < choices.size(); ++i) {
                    if (!choices[i].free) continue;
                    const ToolPose pose = row.pose(i, choices[i].posture);
                    const auto at = row.kinematics.nearest(pose, last ? *last : Joints{});
                    if (!at) continue;
                    if (last) {
                        const double time = std::max((pose.tip - last_pose.tip).norm() / feed,
                                                     row.kinematics.time(*last, *at));
                        double change = 0;
                        for (int k = 0; k < 5; ++k) {
                            const double v = time > 0 ? ((*at)[k] - (*last)[k]) / time : 0;
                            if (moves > 0)
                                change = std::max(change, std::abs(v - speed[std::size_t(k)])
                                                              / (2 * machine.acceleration(k)));
                            speed[std::size_t(k)] = v;
                        }
                        sum += time + change;
                        ++moves;
                    }
                    last = at;
                    last_pose = pose;
                }
                return sum;
            };
            const double without = counted(choose_global(row.points, row.input, Progress()));
            row.input.accelerations = true;
            const double with = counted(choose_global(row.points, row.input, Progress()));
            plain += without;
            minded += with;
        }
        QVERIFY2(minded < 0.99 * plain, qPrintable(QString("%1 %2").arg(minded).arg(plain)));
    }

    /// Over a surface whose normals are a little rough, at a feed that is slower than any joint, axes could
    /// go to and fro for nothing: they hardly bend, and seldom turn back.
    void axes_run_evenly() {
        Random rng(9);
        std::vector<ContactFrame> frames;
        for (int i = 0; i < 80; ++i) {
            const Vec3 normal = Vec3(0.4 * std::sin(0.08 * i) + uniform(rng, -0.03, 0.03),
                                     0.3 * std::cos(0.1 * i) + uniform(rng, -0.03, 0.03), 1)
                                    .normalized();
            frames.push_back(ContactFrame::at(Vec3(i - 40, 0, 20), normal, Vec3::UnitX()));
        }
        Row row(level_plane(300), small_tool,
                PostureGrid::make(radians(15), radians(25), radians(-20), radians(20), radians(5)), frames,
                "trunnion-ac");
        QVERIFY(row.all_free());
        row.input.feed = 2;
        const auto choices = choose_global(row.points, row.input, Progress());
        int back = 0;
        double bends = 0;
        std::optional<Joints> last;
        std::array<double, 2> step{};
        for (std::size_t i = 0; i < choices.size(); ++i) {
            const auto at = row.kinematics.nearest(row.pose(i, choices[i].posture), last ? *last : Joints{});
            QVERIFY(at);
            for (std::size_t r = 0; last && r < 2; ++r) {
                const double now = at->rotary[r] - last->rotary[r];
                back += now * step[r] < 0;
                if (i > 1) bends += std::abs(now - step[r]);
                step[r] = now;
            }
            last = at;
        }
        QVERIFY2(back < 50, qPrintable(QString::number(back)));
        QVERIFY2(bends < radians(340), qPrintable(QString::number(degrees(bends))));
    }

    /// Over a rough surface, at a feed that is slower than any joint, from a posture on one side to one on
    /// the other: nothing asks the axes to turn back, however the normals do.
    void axes_do_not_turn_back_for_nothing() {
        std::vector<ContactFrame> frames;
        Random rng(3);
        for (int i = 0; i < 121; ++i) {
            const Vec3 normal = Vec3(0.02 * std::sin(0.9 * i) + uniform(rng, -0.02, 0.02),
                                     0.02 * std::cos(0.7 * i) + uniform(rng, -0.02, 0.02), 1)
                                    .normalized();
            frames.push_back(ContactFrame::at(Vec3(i - 60, 0, 20), normal, Vec3::UnitX()));
        }
        Row row(level_plane(300), small_tool,
                PostureGrid::make(radians(15), radians(25), radians(-60), radians(60), radians(5)), frames,
                "trunnion-ac");
        QVERIFY(row.all_free());
        row.input.feed = 2;
        row.points[0].kept = PostureValue{radians(20), radians(-40), 0};
        row.points[120].kept = PostureValue{radians(20), radians(40), 0};
        const auto choices = choose_global(row.points, row.input, Progress());
        std::array<int, 2> back{};
        std::optional<Joints> last;
        std::array<double, 2> step{};
        for (std::size_t i = 0; i < choices.size(); ++i) {
            const auto at = row.kinematics.nearest(row.pose(i, choices[i].posture), last ? *last : Joints{});
            QVERIFY(at);
            for (std::size_t r = 0; last && r < 2; ++r) {
                const double now = at->rotary[r] - last->rotary[r];
                if (std::abs(now) < tolerance::level_angle) continue;
                back[r] += now * step[r] < 0;
                step[r] = now;
            }
            last = at;
        }
        QVERIFY2(back[0] <= 10 && back[1] <= 10, qPrintable(QString("%1 %2").arg(back[0]).arg(back[1])));
    }

    void neighbors_keep_the_turn_limit() {
        Random rng(5);
        const auto mesh = hills(5);
        Row row(*mesh, small_tool, PostureGrid::make(0, radians(40), radians(-40), radians(40), radians(8)),
                along_x(*mesh, 40, rng));
        row.input.turn_limit = radians(25);
        const auto choices = choose_global(row.points, row.input, Progress());
        int together = 0;
        for (std::size_t i = 1; i < choices.size(); ++i) {
            if (!choices[i - 1].free || !choices[i].free) continue;
            together += row.pose(i - 1, choices[i - 1].posture).axis.dot(row.pose(i, choices[i].posture).axis)
                        >= std::cos(radians(25)) - 1e-12;
        }
        QVERIFY2(together >= 20, qPrintable(QString::number(together)));
    }

    void same_bits_with_any_number_of_threads() {
        Random rng(9);
        const auto mesh = hills(9);
        const Row row(*mesh, small_tool,
                      PostureGrid::make(0, radians(40), radians(-40), radians(40), radians(8)),
                      along_x(*mesh, 16, rng));
        for (const Method method : methods) {
            set_thread_count(1);
            const auto one = method(row.points, row.input, Progress());
            set_thread_count(2);
            const auto two = method(row.points, row.input, Progress());
            set_thread_count(0);
            for (std::size_t i = 0; i < one.size(); ++i) {
                QCOMPARE(one[i].free, two[i].free);
                QVERIFY(std::memcmp(&one[i].posture, &two[i].posture, sizeof(PostureValue)) == 0);
            }
        }
    }

    void nothing_to_choose() {
        const Row row(level_plane(300), small_tool,
                      PostureGrid::make(0, radians(30), radians(-30), radians(30), radians(10)), {});
        for (const Method method : methods)
            QVERIFY(method(row.points, row.input, Progress()).empty());
    }
};

FACETMILL_TEST(TestChoose)
#include "test_choose.moc"
