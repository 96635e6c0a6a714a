#include "core/strategy/scallop/field_hollow.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace facetmill {

std::optional<FieldHollow> field_hollow(const ScallopField& field, std::size_t place,
                                        const CutterCover& cover, double deep) {
    const auto column = int(place % std::size_t(field.columns())),
               row = int(place / std::size_t(field.columns()));
    const std::size_t right = place + 1, above = place + std::size_t(field.columns());
    for (const auto& [inside, beside] :
         {std::pair(column + 1 < field.columns(), right), std::pair(row + 1 < field.rows(), above)}) {
        if (!inside || !field.cut(beside)) continue;
        const Vec3 a = field.touch(place).normal, b = field.touch(beside).normal, n = (a + b).normalized();
        // A circle that touches both planes at these places is as far from their corner.
        const double half = 0.5 * std::acos(std::clamp(a.dot(b), -1.0, 1.0)),
                     apart = (field.touched(beside) - field.touched(place)).norm();
        const double depth = 0.5 * apart * std::tan(0.5 * half);
        if (!(half > 0) || depth < deep || !(n.z() > 0)) continue;
        const Vec3 tip = field.touch(place).tip;
        return FieldHollow{{tip - cover.tip_offset(n), n, tip}, depth};
    }
    return std::nullopt;
}

} // namespace facetmill
