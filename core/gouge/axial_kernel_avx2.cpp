// The kernels in AVX2. Compiled with -mavx2, run only where the processor has it.
#include "core/gouge/axial_curve_impl.h"
#include "core/gouge/axial_kernel_impl.h"
#include "core/gouge/axial_packet_impl.h"

namespace facetmill {

extern const AxialKernels axial_kernels_avx2;
const AxialKernels axial_kernels_avx2{simd::search<false>, simd::search<true>, simd::touch, simd::packet,
                                      simd::curve,         simd::place_lanes,  "AVX2"};

} // namespace facetmill
