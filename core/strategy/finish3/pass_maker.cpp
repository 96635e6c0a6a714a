#include "core/strategy/finish3/pass_maker.h"

#include "core/base/parallel.h"

#include <cmath>

namespace facetmill {

std::vector<Pass> PassMaker::passes(const PlannedLine& line, const Progress& progress) const {
    std::vector<Pass> all;
    const Interval* within = line.within ? &*line.within : nullptr;
    for (const Interval& range : stepover_.ranges(line.v, line.back, line.ahead, within)) {
        const auto points =
            lift_line(field_, line.v * frame_.across, frame_.along, range.lo, range.hi, fine_, progress);
        for (const auto& run : beside_part(points, line.v)) {
            all.push_back(pass(thinned(run, fine_.below, fine_.above), line.v, progress));
            all.back().offset = line.v;
        }
    }
    return all;
}

std::vector<std::vector<LinePoint>> PassMaker::beside_part(std::vector<LinePoint> points, double v) const {
    LiftHint hint, near_hint;
    // False where nothing is within reach; on the floor the tip rises to where it reaches as much.
    const auto reaches = [&](LinePoint& p) {
        if (p.z > field_.floor) return true;
        const Vec2 xy = frame_.xy(p.s, v);
        if (field_.lift->contact(xy.x(), xy.y(), hint).facet != no_index) return true;
        const AxialContact edge = near_.contact(xy.x(), xy.y(), near_hint);
        if (edge.facet == no_index) return false;
        const double foot = std::min(edge.point.z(), walls_.lowest(xy));
        p.z = std::max(field_.floor, foot - cover_.shoulder());
        return true;
    };
    const auto end_of_run = [&](LinePoint on, LinePoint beside) {
        while (std::abs(beside.s - on.s) > fine_.shortest()) {
            LinePoint mid{0.5 * (on.s + beside.s), field_.floor};
            (reaches(mid) ? on : beside) = mid;
        }
        return on;
    };
    std::vector<std::vector<LinePoint>> runs;
    const LinePoint* before = nullptr; // the last one that was left out
    bool inside = false;
    for (LinePoint& p : points) {
        if (!reaches(p)) {
            if (inside) runs.back().push_back(end_of_run(runs.back().back(), p));
            inside = false;
            before = &p;
            continue;
        }
        if (!inside) {
            runs.emplace_back();
            if (before) runs.back().push_back(end_of_run(p, *before));
        }
        inside = true;
        runs.back().push_back(p);
    }
    return runs;
}

CutterContact PassMaker::contact_of(const Vec3& tip, const AxialContact& contact) const {
    if (contact.facet == no_index) return {tip, Vec3(0, 0, 1)}; // nothing below: held up by the floor
    const Vec3 lifted(tip.x(), tip.y(), contact.tip_z);
    const auto open = cover_.contact_normal(contact.point - lifted);
    Vec3 normal = open ? *open : stepover_.mesh().facet_normal(contact.facet);
    if (normal.z() < 0) normal = -normal;
    return {contact.point, normal};
}

Pass PassMaker::pass(const std::vector<LinePoint>& points, double v, const Progress& progress) const {
    struct Place {
        LinePoint at;
        CutterLocation cl;
        CutterContact cc;
    };
    const auto placed = [&](const LinePoint& p, const AxialContact& touched) {
        const Vec3 tip = frame_.point(p.s, v, p.z);
        return Place{p, {tip, Vec3(0, 0, 1)}, contact_of(tip, touched)};
    };
    const double cos_limit = std::cos(normal_limit_), shortest = 0.25 * fine_.spacing;
    const auto add = [](const Place& p, Pass& to) {
        to.cl.push_back(p.cl);
        to.cc.push_back(p.cc);
    };
    // Between a and b (both placed elsewhere), more points while the normal turns too much.
    const auto fill = [&](const auto& self, const Place& a, const Place& b, LiftHint& hint,
                          Pass& to) -> void {
        if (a.cc.normal.dot(b.cc.normal) >= cos_limit || b.at.s - a.at.s < 2 * shortest) return;
        LinePoint mid{0.5 * (a.at.s + b.at.s), 0};
        mid.z = field_.tip_z(v * frame_.across + mid.s * frame_.along, hint);
        const Vec2 xy = frame_.xy(mid.s, v);
        const Place middle = placed(mid, field_.lift->contact(xy.x(), xy.y(), hint));
        self(self, a, middle, hint, to);
        add(middle, to);
        self(self, middle, b, hint, to);
    };
    constexpr std::size_t block = 64;
    std::vector<Pass> parts((points.size() - 1) / block + 1);
    parallel_blocks(points.size(), block, progress, [&](std::size_t begin, std::size_t end) {
        Pass& part = parts[begin / block];
        // And the first of the next block.
        std::vector<Vec2> places;
        for (std::size_t i = begin; i < std::min(end + 1, points.size()); ++i)
            places.push_back(frame_.xy(points[i].s, v));
        std::vector<AxialContact> touched(places.size());
        field_.lift->contact(places, touched, progress.part(0, 0));
        LiftHint hint;
        Place here = placed(points[begin], touched.front());
        for (std::size_t i = begin; i < end; ++i) {
            add(here, part);
            if (i + 1 == points.size()) break;
            const Place next = placed(points[i + 1], touched[i + 1 - begin]);
            fill(fill, here, next, hint, part);
            here = next;
        }
    });
    Pass whole;
    for (const Pass& p : parts) {
        whole.cl.insert(whole.cl.end(), p.cl.begin(), p.cl.end());
        whole.cc.insert(whole.cc.end(), p.cc.begin(), p.cc.end());
    }
    return whole;
}

} // namespace facetmill
