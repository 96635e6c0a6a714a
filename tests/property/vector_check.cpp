#include "tests/property/vector_check.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "tests/property/vector_cases.h"
#include "tests/support/reference_lift.h"

namespace facetmill::test {

namespace {

/// Roundings of the coordinates by which bodies and facets may be apart and still touch, for the reference.
constexpr double case_roundings = 64;

struct Case {
    VectorCase c;
    std::vector<ReferenceBody> bodies;
    ReferencePosture posture;
    VectorContact got;
    double digit;

    explicit Case(std::uint64_t i)
        : c(vector_case(i)), posture(c.posture.tip, c.posture.axis, c.posture.direction) {
        const auto mesh = std::make_shared<Mesh>();
        mesh->vertices.assign(c.corner.begin(), c.corner.end());
        mesh->facets = {{0, 1, 2}};
        const auto index = std::make_shared<ContactIndex>(mesh, Progress());
        if (c.raised > 0) {
            const AptCutter ball = AptCutter::ball(0.5 * c.cutter.d, 0.5 * c.cutter.d);
            const BodySection section{0.5 * c.cutter.d, c.raised, c.raised + c.cutter.h};
            got = VectorLift(index, CutterProfile(ball), {&section, 1}).contact(c.posture);
            bodies = {ReferenceBody(ball), ReferenceBody(c.cutter, c.raised)};
        } else {
            got = VectorLift(index, CutterProfile(c.cutter)).contact(c.posture);
            bodies = {ReferenceBody(c.cutter)};
        }
        double size = c.posture.tip.cwiseAbs().maxCoeff();
        for (const Vec3& corner : c.corner)
            size = std::max(size, corner.cwiseAbs().maxCoeff());
        for (const ReferenceBody& body : bodies)
            size = std::max(size, double(body.reach()));
        if (std::isfinite(got.lift)) size = std::max(size, std::abs(got.lift));
        digit = case_roundings * std::numeric_limits<double>::epsilon() * size;
    }

    /// True when no lift is above `enough`, of bodies grown by `grow`: by the planes that the contact offers,
    /// else by a search.
    bool none_above(Real enough, Real grow) const {
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            if (std::isfinite(got.lift)) {
                Vec3 n = (c.corner[1] - c.corner[0]).cross(c.corner[2] - c.corner[0]);
                if (n.dot(c.posture.direction) > 0) n = -n;
                if (bound_of(bodies[b], posture, c.corner, n, grow) <= enough) continue;
                if (bound_of(bodies[b], posture, c.corner, -c.posture.direction, grow) <= enough) continue;
                const Vec3 m = normal_at(bodies[b], posture, got.point, got.lift);
                if (bound_of(bodies[b], posture, c.corner, m, grow) <= enough) continue;
            }
            if (!(reference_bound(bodies[b], posture, c.corner, grow, enough) <= enough)) return false;
        }
        return true;
    }
    Real bound(Real grow) const {
        Real most = no_lift;
        for (const ReferenceBody& body : bodies)
            most = std::max(most, reference_bound(body, posture, c.corner, grow));
        return most;
    }
};

VectorCheck check_case(std::uint64_t i, unsigned compare_every, unsigned maximise_every) {
    const Case k(i);
    const double got = k.got.lift;
    VectorCheck check;
    const auto fail = [&](const QString& why, Real reference) {
        check.failures = 1;
        check.first_failure = QString("case %1 (%2): %3; got %4, the reference says %5")
                                  .arg(i)
                                  .arg(QString::fromStdString(k.c.family))
                                  .arg(why)
                                  .arg(got, 0, 'g', 17)
                                  .arg(double(reference), 0, 'g', 17);
        return check;
    };
    if (std::isnan(got)) return fail("not a number", k.bound(0));
    check.touched = got > -infinity;
    // Not too low.
    const double accuracy = tolerance::lift_accuracy;
    bool borderline = false;
    if (!k.none_above(got + accuracy, 0)) {
        borderline = true;
        if (!k.none_above(got + accuracy, -k.digit)) return fail("too low", k.bound(0));
    }
    // Not too high.
    if (got > -infinity) {
        const Witness w = witness(k.bodies[k.got.body], k.posture, k.c.corner, k.got.point, got);
        if (w.from_facet > k.digit)
            return fail(QString("%1 off the facet").arg(double(w.from_facet)), k.bound(0));
        if (w.from_body > k.digit)
            return fail(QString("%1 off the body").arg(double(w.from_body)), k.bound(0));
    }
    check.borderline = borderline;
    if (i % compare_every == 0 || borderline) {
        const Real wanted = k.bound(0);
        check.compared = 1;
        const bool same = Real(got) == wanted || std::abs(Real(got) - wanted) <= accuracy;
        if (same && std::isfinite(got)) check.worst = double(std::abs(Real(got) - wanted));
        if (!same) {
            check.borderline = 1;
            if (Real(got) > k.bound(k.digit) + accuracy) return fail("too high", wanted);
        }
    }
    if (i % maximise_every == 0) {
        check.maximised = 1;
        Real lowest = no_lift, highest = no_lift, maximum = no_lift;
        for (const ReferenceBody& body : k.bodies) {
            maximum = std::max(maximum, reference_lift(body, k.posture, k.c.corner));
            lowest = std::max(lowest, reference_bound(body, k.posture, k.c.corner, -1e-15L * k.digit));
            highest = std::max(highest, reference_bound(body, k.posture, k.c.corner, 0));
        }
        const Real off = 0.1L * accuracy;
        if (!(maximum >= lowest - off && maximum <= highest + off)
            && !(maximum >= k.bound(-k.digit) - off && maximum <= k.bound(k.digit) + off))
            return fail("the references disagree: by maximisation "
                            + QString::number(double(maximum), 'g', 17),
                        highest);
    }
    return check;
}

} // namespace

VectorCheck check_vector_cases(std::uint64_t begin, std::uint64_t end, unsigned compare_every,
                               unsigned maximise_every) {
    const auto join = [](VectorCheck total, const VectorCheck& one) {
        if (total.first_failure.isEmpty()) total.first_failure = one.first_failure;
        total.failures += one.failures;
        total.worst = std::max(total.worst, one.worst);
        total.touched += one.touched;
        total.compared += one.compared;
        total.maximised += one.maximised;
        total.borderline += one.borderline;
        return total;
    };
    return parallel_reduce(
        std::size_t(end - begin), 100, VectorCheck{}, Progress(),
        [&](std::size_t from, std::size_t to) {
            VectorCheck block;
            for (std::size_t i = from; i < to; ++i)
                block = join(std::move(block), check_case(begin + i, compare_every, maximise_every));
            return block;
        },
        join);
}

} // namespace facetmill::test
