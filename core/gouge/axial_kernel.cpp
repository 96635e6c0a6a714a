#include "core/gouge/axial_kernel.h"

#include <cstdlib>
#include <cstring>

namespace facetmill {

extern const AxialKernels axial_kernels_baseline;
#ifdef FACETMILL_X86
extern const AxialKernels axial_kernels_avx2;
extern const AxialKernels axial_kernels_avx512;
#endif

int axial_kernel_sets(const AxialKernels* (&sets)[4]) {
    int count = 0;
    sets[count++] = &axial_kernels_baseline;
#ifdef FACETMILL_X86
    if (__builtin_cpu_supports("avx2")) {
        sets[count++] = &axial_kernels_avx2;
        // All of x86-64-v4 that is not in every processor with AVX2.
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")
            && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq")
            && __builtin_cpu_supports("avx512cd"))
            sets[count++] = &axial_kernels_avx512;
    }
#endif
    return count;
}

const AxialKernels& axial_kernels() {
    static const AxialKernels& chosen = []() -> const AxialKernels& {
        const AxialKernels* sets[4];
        const int count = axial_kernel_sets(sets);
        const char* wanted = std::getenv("FACETMILL_KERNEL");
        return wanted && std::strcmp(wanted, "baseline") == 0 ? *sets[0] : *sets[count - 1];
    }();
    return chosen;
}

} // namespace facetmill
