// Memory of grid-sized arrays: in huge pages where the system has them, because a stencil over a large 3D array otherwise
// waits for address translation.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace gapflow {

/// Allocator of std::vector.
template <class T>
struct LargeMemory {
    using value_type = T;

    LargeMemory() = default;
    template <class U>
    LargeMemory(const LargeMemory<U>&)
    {
    }
    T* allocate(std::size_t n)
    {
        constexpr std::size_t page = std::size_t{1} << 21, line = 64;
        const bool large = n * sizeof(T) >= 2 * page;
        const std::size_t unit = large ? page : line, bytes = (n * sizeof(T) + unit - 1) / unit * unit;
        void* memory = std::aligned_alloc(unit, bytes);
        if (!memory)
            throw std::bad_alloc();
#ifdef __linux__
        if (large)
            madvise(memory, bytes, MADV_HUGEPAGE); // a wish
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t) { std::free(memory); }
    friend bool operator==(const LargeMemory&, const LargeMemory&) { return true; }
};

template <class T>
using LargeVector = std::vector<T, LargeMemory<T>>;

} // namespace gapflow
