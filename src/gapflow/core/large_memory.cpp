#include "gapflow/core/large_memory.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <mutex>
#include <unordered_map>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace gapflow {

namespace {

constexpr std::size_t small_page = 4096, huge_page = std::size_t{1} << 21;
constexpr std::size_t slack =
    16; // a sixteenth of the most ever used may be kept on top: a few blocks change size from step to step
class BlockStore {
public:
    void* take(std::size_t bytes)
    {
        const std::lock_guard lock(mutex_);
        const auto kept = kept_.lower_bound(bytes);
        if (kept != kept_.end() && kept->first - bytes <= bytes / 4) {
            void* memory = kept->second;
            size_[memory] = kept->first;
            in_use(kept->first);
            kept_bytes_ -= kept->first;
            kept_.erase(kept);
            return memory;
        }
        // The remainder that does not fill a huge page uses small pages: rounding up to huge pages would need a tenth more at 128^3 cells.
        const std::size_t alignment = bytes >= 2 * huge_page ? huge_page : small_page;
        const std::size_t size = (bytes + small_page - 1) / small_page * small_page;
        void* memory = nullptr;
        if (posix_memalign(&memory, alignment, size) != 0) {
            while (!kept_.empty())
                release(kept_.begin());
            if (posix_memalign(&memory, alignment, size) != 0)
                throw std::bad_alloc();
        }
#ifdef __linux__
        if (alignment == huge_page)
            madvise(memory, size, MADV_HUGEPAGE); // a request: may be ignored
#endif
        size_[memory] = size;
        in_use(size);
        while (used_ + kept_bytes_ > most_used_ + most_used_ / slack)
            release(std::prev(kept_.end()));
        return memory;
    }
    void give(void* memory)
    {
        const std::lock_guard lock(mutex_);
        const auto at = size_.find(memory);
        const std::size_t size = at->second;
        size_.erase(at);
        used_ -= size;
        kept_.emplace(size, memory);
        kept_bytes_ += size;
    }

private:
    using Kept = std::multimap<std::size_t, void*>; // by size

    void in_use(std::size_t size)
    {
        used_ += size;
        most_used_ = std::max(most_used_, used_);
    }
    void release(Kept::iterator block)
    {
        std::free(block->second);
        kept_bytes_ -= block->first;
        kept_.erase(block);
    }

    std::mutex mutex_;
    Kept kept_;
    std::unordered_map<void*, std::size_t> size_; // of blocks in use
    std::size_t used_ = 0, kept_bytes_ = 0, most_used_ = 0;
};

BlockStore& store()
{
    static BlockStore* const blocks = new BlockStore; // never destroyed: arrays of static objects may be destroyed later
    return *blocks;
}

} // namespace

void* take_large_block(std::size_t bytes)
{
    return store().take(bytes);
}

void give_large_block(void* memory)
{
    store().give(memory);
}

} // namespace gapflow
