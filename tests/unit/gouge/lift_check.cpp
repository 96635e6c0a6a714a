#include "tests/unit/gouge/lift_check.h"

#include "core/base/parallel.h"
#include "core/base/tolerances.h"
#include "core/gouge/axial_lift.h"
#include "tests/support/brute_lift.h"
#include "tests/unit/gouge/lift_cases.h"

namespace facetmill::test {

namespace {

LiftCheck check_case(std::uint64_t i) {
    const LiftCase c = lift_case(i);
    const auto mesh = std::make_shared<Mesh>();
    mesh->vertices.assign(c.corner, c.corner + 3);
    mesh->facets = {{0, 1, 2}};
    const AxialLift lift(std::make_shared<ContactIndex>(mesh, Progress()), CutterProfile(c.cutter));
    const double got = lift.tip_z(c.x, c.y);
    const BruteCutter cutter(c.cutter);
    const auto reference = [&](double dx, double dy) {
        return brute_lift(cutter, c.corner[0], c.corner[1], c.corner[2], c.x + dx, c.y + dy);
    };
    const double wanted = reference(0, 0);

    LiftCheck check;
    if (got == wanted) {
        check.touched = got > -infinity;
        return check;
    }
    if (std::isfinite(got) && std::isfinite(wanted)) {
        check.touched = 1;
        const double error = std::abs(got - wanted);
        if (error <= tolerance::lift_accuracy) {
            check.worst = error;
            return check;
        }
    }
    // Where the rim only just reaches something, or something is touched where the cutter's surface is
    // vertical, the answer hangs on the last digit of the coordinates: then it must lie among those that the
    // reference gives when the axis is moved by that.
    const double digit =
        4 * std::numeric_limits<double>::epsilon() * std::max({1.0, std::abs(c.x), std::abs(c.y)});
    double lowest = wanted, highest = wanted;
    for (const auto& [dx, dy] : {std::pair{digit, 0.0}, {-digit, 0.0}, {0.0, digit}, {0.0, -digit}}) {
        const double beside = reference(dx, dy);
        lowest = std::min(lowest, beside);
        highest = std::max(highest, beside);
    }
    if (got >= lowest - tolerance::lift_accuracy && got <= highest + tolerance::lift_accuracy) {
        check.borderline = 1;
        return check;
    }
    check.first_failure = QString("case %1 (%2): %3, the reference says %4")
                              .arg(i)
                              .arg(c.family)
                              .arg(got, 0, 'g', 17)
                              .arg(wanted, 0, 'g', 17);
    return check;
}

} // namespace

LiftCheck check_lift_cases(std::uint64_t begin, std::uint64_t end) {
    const auto join = [](LiftCheck total, const LiftCheck& one) {
        if (total.first_failure.isEmpty()) total.first_failure = one.first_failure;
        total.worst = std::max(total.worst, one.worst);
        total.touched += one.touched;
        total.borderline += one.borderline;
        return total;
    };
    return parallel_reduce(
        std::size_t(end - begin), 200, LiftCheck{}, Progress(),
        [&](std::size_t from, std::size_t to) {
            LiftCheck block;
            for (std::size_t i = from; i < to; ++i)
                block = join(std::move(block), check_case(begin + i));
            return block;
        },
        join);
}

} // namespace facetmill::test
