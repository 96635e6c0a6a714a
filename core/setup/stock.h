// The raw material before the first operation.
#pragma once

#include "core/base/parameter.h"
#include "core/base/vec.h"

#include <array>

namespace facetmill {

struct StockSpec {
    enum class Kind { box };
    Kind kind = Kind::box;
    std::array<double, 3> margin{0, 0, 0}; ///< mm added to the part's box on both sides in x and y, on top in z
};

const ParameterTable<StockSpec>& stock_parameters();

/// The stock's box around the part's; the bottom of the stock is the part's bottom.
Box3 stock_box(const StockSpec& stock, const Box3& part);

} // namespace facetmill
