// The kernels in the instructions that every processor has.
#include "core/gouge/axial_curve_impl.h"
#include "core/gouge/axial_kernel_impl.h"
#include "core/gouge/axial_packet_impl.h"

namespace facetmill {

extern const AxialKernels axial_kernels_baseline;
const AxialKernels axial_kernels_baseline{simd::search<false>, simd::search<true>, simd::touch, simd::packet,
                                          simd::curve,         simd::place_lanes,  "baseline"};

} // namespace facetmill
