// The kernels in AVX-512: the same vectors, with its masks and its registers. Compiled for x86-64-v4, run
// only where the processor has all that it names.
#include "core/gouge/axial_curve_impl.h"
#include "core/gouge/axial_kernel_impl.h"
#include "core/gouge/axial_packet_impl.h"

namespace facetmill {

extern const AxialKernels axial_kernels_avx512;
const AxialKernels axial_kernels_avx512{simd::search<false>, simd::search<true>, simd::touch, simd::packet,
                                        simd::curve,         simd::place_lanes,  "AVX-512"};

} // namespace facetmill
