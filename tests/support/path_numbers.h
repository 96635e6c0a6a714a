// All numbers of a path, to compare two bit by bit.
#pragma once

#include "core/strategy/plan/path.h"

#include <vector>

namespace facetmill::test {

inline std::vector<double> path_numbers(const StrategyResult& path) {
    std::vector<double> all{path.stepover_min, path.stepover_max, path.direction, path.cusp_max};
    const auto add = [&](const Vec3& v) { all.insert(all.end(), v.data(), v.data() + 3); };
    for (const Pass& p : path.passes) {
        all.push_back(p.offset);
        for (const CutterLocation& c : p.cl) {
            add(c.tip);
            add(c.axis);
        }
        for (const CutterContact& c : p.cc) {
            add(c.point);
            add(c.normal);
        }
        for (const CutterLocation& c : p.entry)
            add(c.tip);
    }
    for (const CutterContact& c : path.cleanup)
        add(c.point);
    for (const Strip& s : path.strips) {
        all.insert(all.end(), {s.area, s.length, s.width});
        for (const auto& triangle : s.band)
            for (const Vec3& v : triangle)
                add(v);
        for (const auto& loop : s.boundaries)
            for (const Vec3& v : loop)
                add(v);
    }
    return all;
}

} // namespace facetmill::test
