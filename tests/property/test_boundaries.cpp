// Boundaries at random: every kind of operation keeps contact, tip or cutter within them, and off those that
// it is to avoid. The judges measure the distance of every pose from every facet, and know nothing of
// planners: a ball touches the part where the part is nearest to its middle.
#include "core/mesh/triangle_distance.h"
#include "tests/property/held_job.h"
#include "tests/support/error_code.h"
#include "tests/support/test_runner.h"

#include <QTest>

using namespace facetmill;
using namespace facetmill::test;

namespace {

/// The facets about a place, a strip of slopes, a star, or the outline drawn in.
Boundary random_boundary(Random& rng, const Mesh& part) {
    Boundary b;
    b.name = "Here";
    b.kind = Boundary::Kind(whole(rng, 0, 3));
    const Vec2 middle(uniform(rng, -9, 9), uniform(rng, -6, 6));
    const double radius = uniform(rng, 4, 8);
    std::vector<Index> painted;
    for (std::size_t f = 0; f < part.facet_count(); ++f) {
        const Vec3 c = (part.corner(f, 0) + part.corner(f, 1) + part.corner(f, 2)) / 3;
        if ((c.head<2>() - middle).norm() < radius) painted.push_back(Index(f));
    }
    b.facets = facet_ranges_text(painted);
    b.of_facets = long(part.facet_count());
    const double low = uniform(rng, 0, 0.4);
    b.slope = {low, low + uniform(rng, 0.2, 0.8)};
    for (int k = 0; k < 9; ++k) {
        const double angle = 2 * pi * k / 9, r = radius * uniform(rng, 0.6, 1);
        b.curve.push_back({{middle.x() + r * std::cos(angle), middle.y() + r * std::sin(angle), 0}});
    }
    if (b.kind == Boundary::Kind::silhouette) b.offset = -uniform(rng, 1, 5);
    if (b.kind == Boundary::Kind::curve) b.offset = uniform(rng, -1, 1);
    b.invert = b.kind != Boundary::Kind::silhouette && whole(rng, 0, 3) == 0;
    return b;
}

double distance_from(const Mesh& part, std::size_t f, const Vec3& p) {
    return std::sqrt(squared_distance(p, part.corner(f, 0), part.corner(f, 1), part.corner(f, 2)));
}

/// By area and signs alone: whether a place lies in a facet looked at along Z.
bool over_facet(const Mesh& part, std::size_t f, const Vec2& p) {
    int left = 0, right = 0;
    for (int k = 0; k < 3; ++k) {
        const Vec2 a = part.corner(f, k).head<2>(), b = part.corner(f, (k + 1) % 3).head<2>();
        const double cross = (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
        left += cross >= 0;
        right += cross <= 0;
    }
    return left == 3 || right == 3;
}

/// A boundary, asked naively.
struct NaiveBoundary {
    const Boundary& boundary;
    const Mesh& part;
    std::vector<char> in; ///< per facet; facets and slope

    NaiveBoundary(const Boundary& b, const Mesh& mesh) : boundary(b), part(mesh), in(mesh.facet_count()) {
        std::vector<Index> painted = facet_ranges(b.facets, mesh.facet_count());
        for (std::size_t f = 0; f < in.size(); ++f) {
            const double slope = std::acos(mesh.facet_normal(f).z());
            const bool is_in = b.kind == Boundary::Kind::slope
                                   ? slope >= b.slope[0] && slope <= b.slope[1]
                                   : std::find(painted.begin(), painted.end(), Index(f)) != painted.end();
            in[f] = is_in != b.invert;
        }
    }
    bool by_plan() const {
        return boundary.kind == Boundary::Kind::curve || boundary.kind == Boundary::Kind::silhouette;
    }
    /// Distance from the border of the curve, or from the sides of the part's rectangle; below 0 outside.
    double depth(const Vec2& p) const {
        std::vector<Vec2> loop;
        if (boundary.kind == Boundary::Kind::silhouette)
            loop = {{-14, -10}, {14, -10}, {14, 10}, {-14, 10}};
        else
            for (const CurveCorner& c : boundary.curve)
                loop.emplace_back(c.at[0], c.at[1]);
        bool inside = false;
        double nearest = infinity;
        for (std::size_t i = 0, k = loop.size() - 1; i < loop.size(); k = i++) {
            const Vec2 &a = loop[i], &b = loop[k];
            if ((a.y() > p.y()) != (b.y() > p.y())
                && p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
                inside = !inside;
            const Vec2 d = b - a;
            nearest = std::min(nearest,
                               (p - a - std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) * d).norm());
        }
        const double depth = (inside ? nearest : -nearest) + boundary.offset;
        return boundary.invert ? -depth : depth;
    }
    bool covers(const Vec2& p) const {
        if (by_plan()) return depth(p) >= -1e-6;
        for (std::size_t f = 0; f < in.size(); ++f)
            if (in[f] && over_facet(part, f, p)) return true;
        return false;
    }
    /// How much farther the nearest place within is from p than the nearest of all: a tool that touches the
    /// one touches the other, to that.
    double farther(const Vec3& p) const {
        std::vector<double> distance(in.size());
        for (std::size_t f = 0; f < in.size(); ++f)
            distance[f] = distance_from(part, f, p);
        const double all = *std::min_element(distance.begin(), distance.end());
        double own = infinity;
        for (std::size_t f = 0; f < in.size(); ++f) {
            if (!by_plan()) {
                if (in[f]) own = std::min(own, distance[f]);
                continue;
            }
            constexpr double near = 0.2;
            constexpr int places = 24;
            if (distance[f] > all + near) continue;
            for (int a = 0; a <= places; ++a)
                for (int b = 0; a + b <= places; ++b) {
                    const Vec3 q = part.corner(f, 0)
                                   + double(a) / places * (part.corner(f, 1) - part.corner(f, 0))
                                   + double(b) / places * (part.corner(f, 2) - part.corner(f, 0));
                    if ((q - p).norm() < own && depth(q.head<2>()) >= -1e-6) own = (q - p).norm();
                }
        }
        return own - all;
    }
};

/// Poses of a program in which it cuts, some hundreds: locations and the middles between them.
std::vector<CutterLocation> cutting_poses(const ClSection& program) {
    std::vector<CutterLocation> poses;
    const auto& motions = program.motions.motions;
    for (std::size_t i = 1; i < motions.size(); ++i) {
        if (motions[i].kind != MotionKind::cut) continue;
        const CutterLocation &a = motions[i - 1].to, &b = motions[i].to;
        poses.push_back(b);
        if (motions[i - 1].kind == MotionKind::cut)
            poses.push_back({0.5 * (a.tip + b.tip), (a.axis + b.axis).normalized()});
    }
    constexpr std::size_t enough = 900;
    const std::size_t stride = poses.size() / enough + 1;
    for (std::size_t i = 0; i * stride < poses.size(); ++i)
        poses[i] = poses[i * stride];
    poses.resize((poses.size() + stride - 1) / stride);
    return poses;
}

/// What of a pose lies outside, for people; empty where nothing does. `near`: what may, mm.
QString outside(const NaiveBoundary& boundary, const CutterLocation& pose, double radius, Containment contain,
                double near) {
    const Vec2 tip = pose.tip.head<2>();
    if (contain == Containment::contact) {
        const Vec3 middle = pose.tip + radius * pose.axis;
        const double out = boundary.farther(middle);
        return out > near ? QString("contact by %1").arg(out) : QString();
    }
    // On the border, to rounding, is within.
    const auto covers = [&](const Vec2& p) {
        constexpr double rounding = 1e-5;
        for (const Vec2& aside : {Vec2(0, 0), Vec2(1, 1), Vec2(-1, 1), Vec2(1, -1), Vec2(-1, -1)})
            if (boundary.covers(p + rounding * aside)) return true;
        return false;
    };
    if (!covers(tip)) return QString("tip");
    if (contain == Containment::tip) return {};
    for (int k = 0; k < 24; ++k) {
        const double angle = 2 * pi * k / 24;
        if (!covers(tip + 0.999 * radius * Vec2(std::cos(angle), std::sin(angle))))
            return QString("cutter towards %1").arg(angle);
    }
    return {};
}

} // namespace

class TestBoundaries : public QObject {
    Q_OBJECT

private slots:
    void every_kind_stays_within_data() {
        QTest::addColumn<int>("which");
        for (int i = 0; i < int(std::size(held_cases)); ++i)
            if (!held_cases[i].turns) QTest::newRow(held_cases[i].kind) << i;
    }
    void every_kind_stays_within() {
        QFETCH(int, which);
        HeldJob job(held_cases[which]);
        const bool rough = std::string_view(held_cases[which].kind) == "rough";
        const auto everywhere = job.plan();
        const Mesh& part = *everywhere->part->mesh;
        Random rng(70 + std::uint64_t(which));
        int planned = 0, cut_short = 0;
        const int trials = std::max(1, qEnvironmentVariableIntValue("FACETMILL_BOUNDARIES"));
        for (int trial = 0; trial < trials * 3; ++trial) {
            job.project.boundaries = {random_boundary(rng, part)};
            OperationCommon& common = job.project.operations[0]->common();
            common.boundary = "Here";
            common.contain = Containment(trial % 3);
            std::shared_ptr<const PlanResult> plan;
            try {
                plan = job.plan();
            } catch (const Error& e) {
                QVERIFY2(e.code() == ErrorCode::empty_result, e.what());
                continue;
            }
            ++planned;
            const NaiveBoundary boundary(job.project.boundaries[0], part);
            // Roughing cuts stock: its tip stays within where others keep the contact.
            const Containment contain =
                rough && common.contain == Containment::contact ? Containment::tip : common.contain;
            for (const auto& o : plan->operations) {
                const double radius = CutterProfile(o->program.cutter).max_radius();
                for (const CutterLocation& pose : cutting_poses(o->program)) {
                    const QString out =
                        outside(boundary, pose, radius, contain, o->path.chord_tolerance + 0.01);
                    QVERIFY2(out.isEmpty(),
                             qPrintable(QString("trial %1, %2, kept %3: %4 outside at %5 %6 %7")
                                            .arg(trial)
                                            .arg(boundary_kind_name(boundary.boundary.kind).c_str())
                                            .arg(int(contain))
                                            .arg(out)
                                            .arg(pose.tip.x())
                                            .arg(pose.tip.y())
                                            .arg(pose.tip.z())));
                }
            }
            for (const CutterLocation& pose : cutting_poses(everywhere->operations[0]->program))
                if (!outside(boundary, pose, 3, contain, 0.1).isEmpty()) {
                    ++cut_short;
                    break;
                }
        }
        QVERIFY(planned >= trials && cut_short > 0);
    }

    void every_kind_avoids_data() { every_kind_stays_within_data(); }
    void every_kind_avoids() {
        QFETCH(int, which);
        HeldJob job(held_cases[which]);
        const auto everywhere = job.plan();
        const Mesh& part = *everywhere->part->mesh;
        Random rng(90 + std::uint64_t(which));
        int planned = 0, in_the_way = 0;
        for (int trial = 0; trial < 2; ++trial) {
            Boundary b = random_boundary(rng, part);
            b.kind = Boundary::Kind::facets;
            b.invert = false;
            job.project.boundaries = {b};
            OperationCommon& common = job.project.operations[0]->common();
            common.avoid = "Here";
            common.avoid_distance = 1;
            // Places nearly as far from the facets as the tool has to keep.
            std::vector<Vec3> points;
            for (const Index f : facet_ranges(b.facets, part.facet_count()))
                for (int i = 0; i <= 2; ++i)
                    for (int k = 0; i + k <= 2; ++k)
                        points.push_back(part.corner(f, 0) + 0.5 * i * (part.corner(f, 1) - part.corner(f, 0))
                                         + 0.5 * k * (part.corner(f, 2) - part.corner(f, 0))
                                         + 0.85 * part.facet_normal(f));
            std::shared_ptr<const PlanResult> plan;
            try {
                plan = job.plan();
            } catch (const Error& e) {
                QVERIFY2(e.code() == ErrorCode::empty_result, e.what());
                continue;
            }
            ++planned;
            for (const auto& o : plan->operations) {
                const double near =
                    deepest(o->program, *find_tool(job.project.tools, o->program.tool_number), points);
                QVERIFY2(near == 0, qPrintable(QString("trial %1: %2 too near").arg(trial).arg(near)));
            }
            in_the_way += deepest(everywhere->operations[0]->program, job.project.tools[0], points) > 0.1;
        }
        QVERIFY(planned > 0 && in_the_way > 0);
    }
};

FACETMILL_TEST(TestBoundaries)
#include "test_boundaries.moc"
