#include "gapflow/core/large_memory.hpp"

#include <map>
#include <mutex>
#include <unordered_map>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace gapflow {

namespace {

constexpr std::size_t huge_page = std::size_t{1} << 21;
constexpr std::size_t always_kept = std::size_t{64} << 20; // bytes

class BlockStore {
public:
    void* take(std::size_t bytes)
    {
        const std::lock_guard lock(mutex_);
        const auto kept = kept_.lower_bound(bytes);
        if (kept != kept_.end() && kept->first - bytes <= bytes / 4) {
            void* memory = kept->second;
            size_[memory] = kept->first;
            used_ += kept->first;
            kept_bytes_ -= kept->first;
            kept_.erase(kept);
            return memory;
        }
        const std::size_t unit = bytes >= 2 * huge_page ? huge_page : 4096, size = (bytes + unit - 1) / unit * unit;
        void* memory = std::aligned_alloc(unit, size);
        if (!memory) {
            release_all();
            memory = std::aligned_alloc(unit, size);
        }
        if (!memory)
            throw std::bad_alloc();
#ifdef __linux__
        if (unit == huge_page)
            madvise(memory, size, MADV_HUGEPAGE); // a wish
#endif
        size_[memory] = size;
        used_ += size;
        return memory;
    }
    void give(void* memory)
    {
        const std::lock_guard lock(mutex_);
        const auto at = size_.find(memory);
        const std::size_t size = at->second;
        size_.erase(at);
        used_ -= size;
        if (kept_bytes_ + size > used_ + always_kept) {
            std::free(memory);
            return;
        }
        kept_.emplace(size, memory);
        kept_bytes_ += size;
    }

private:
    void release_all()
    {
        for (const auto& [size, memory] : kept_)
            std::free(memory);
        kept_.clear();
        kept_bytes_ = 0;
    }

    std::mutex mutex_;
    std::multimap<std::size_t, void*> kept_;          // by size
    std::unordered_map<void*, std::size_t> size_;     // of blocks in use
    std::size_t used_ = 0, kept_bytes_ = 0;
};

BlockStore& store()
{
    static BlockStore* const blocks = new BlockStore; // never destroyed: arrays of static objects may outlive any order
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
