// Memory of grid-sized arrays: in huge pages where the system has them, because a stencil over a large 3D array otherwise
// waits for address translation. Memory that a time step frees is kept for the next one, which needs the same sizes: pages from the
// system cost as much as computing on them.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

namespace gapflow {

/// Blocks of at least this many bytes are kept when they are freed.
constexpr std::size_t least_large_block = std::size_t{1} << 20;

/// A block of at least `bytes` bytes, its content arbitrary. Throws std::bad_alloc. Any thread.
void* take_large_block(std::size_t bytes);
/// Returns a block of take_large_block; it is kept for the next request of about its size. Blocks in use and kept blocks together never
/// exceed the past maximum of blocks in use.
void give_large_block(void* memory);

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
        const std::size_t bytes = size_of(n);
        void* memory = bytes >= least_large_block ? take_large_block(bytes) : std::aligned_alloc(line, bytes);
        if (!memory)
            throw std::bad_alloc();
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t n)
    {
        if (size_of(n) >= least_large_block)
            give_large_block(memory);
        else
            std::free(memory);
    }
    friend bool operator==(const LargeMemory&, const LargeMemory&) { return true; }

private:
    static constexpr std::size_t line = 64; ///< bytes of a cache line, to which blocks are aligned
    static std::size_t size_of(std::size_t n) { return (n * sizeof(T) + line - 1) / line * line; }
};

template <class T>
using LargeVector = std::vector<T, LargeMemory<T>>;

} // namespace gapflow
