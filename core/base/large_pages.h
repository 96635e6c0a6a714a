// Memory for arrays that are read here and there: in large pages where the system has them, so that the
// processor need not look up the place of nearly everything that is read.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace facetmill {

/// An allocator for std::vector. What is smaller than a few large pages comes from the heap as usual.
template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class Other>
    LargePages(const LargePages<Other>&) {}

    T* allocate(std::size_t n) {
        const std::size_t bytes = n * sizeof(T);
        if (bytes < smallest) return static_cast<T*>(::operator new(bytes, std::align_val_t(alignof(T))));
        const std::size_t whole = (bytes + page - 1) / page * page;
        void* memory = std::aligned_alloc(page, whole);
        if (!memory) throw std::bad_alloc();
#if defined(__linux__) && defined(MADV_HUGEPAGE)
        madvise(memory, whole, MADV_HUGEPAGE); // a wish only
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* p, std::size_t n) {
        if (n * sizeof(T) < smallest)
            ::operator delete(p, std::align_val_t(alignof(T)));
        else
            std::free(p);
    }
    template <class Other>
    bool operator==(const LargePages<Other>&) const {
        return true;
    }

private:
    static constexpr std::size_t page = std::size_t(2) << 20, smallest = 4 * page;
};

/// For arrays of millions, also such as are needed for a moment only: the system is asked for hundreds of
/// pages then, and not for hundreds of thousands.
template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

} // namespace facetmill
