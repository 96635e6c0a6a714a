// What this process has of memory, for tests that hold it against itself.
#pragma once

#include <fstream>
#include <malloc.h>
#include <unistd.h>

namespace facetmill::test {

struct MemoryInUse {
    double allocated = 0; ///< bytes that are asked for and not given back
    double resident = 0;  ///< bytes of memory behind the process, once what is free went back
};

inline MemoryInUse memory_in_use() {
    malloc_trim(0);
    const struct mallinfo2 info = mallinfo2();
    double pages = 0, resident_pages = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident_pages;
    return {double(info.uordblks) + double(info.hblkhd), resident_pages * double(sysconf(_SC_PAGESIZE))};
}

} // namespace facetmill::test
