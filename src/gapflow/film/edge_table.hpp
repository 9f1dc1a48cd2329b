// Hash table from unordered pairs of vertices to an integer (open addressing, grows by doubling).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gapflow {

class EdgeTable {
public:
    /// Empties the table and makes room for n pairs.
    void reset(std::size_t n)
    {
        std::size_t size = 16;
        while (size < 2 * n)
            size *= 2;
        slots_.assign(size, {});
        count_ = 0;
    }

    /// Value of the pair, or -1.
    int find(int a, int b) const { return slots_.empty() ? -1 : slots_[slot(key(a, b))].value; }

    /// Reference to the pair's value, -1 if new; valid until the next insertion.
    int& insert(int a, int b)
    {
        if (2 * (count_ + 1) > slots_.size())
            grow();
        Slot& s = slots_[slot(key(a, b))];
        if (s.key == vacant) {
            s.key = key(a, b);
            ++count_;
        }
        return s.value;
    }

private:
    static constexpr std::uint64_t vacant = ~std::uint64_t(0);
    struct Slot {
        std::uint64_t key = vacant;
        int value = -1;
    };

    static std::uint64_t key(int a, int b)
    {
        return std::uint64_t(std::uint32_t(std::min(a, b))) << 32 | std::uint32_t(std::max(a, b));
    }
    std::size_t slot(std::uint64_t k) const
    {
        const std::size_t mask = slots_.size() - 1;
        std::size_t i = (k * 0x9e3779b97f4a7c15u) >> 32 & mask;
        while (slots_[i].key != vacant && slots_[i].key != k)
            i = (i + 1) & mask;
        return i;
    }
    void grow()
    {
        std::vector<Slot> old(std::max<std::size_t>(16, 2 * slots_.size()));
        old.swap(slots_);
        for (const Slot& s : old)
            if (s.key != vacant)
                slots_[slot(s.key)] = s;
    }

    std::vector<Slot> slots_;
    std::size_t count_ = 0;
};

} // namespace gapflow
