// Points on walls' curves by the chords' ends: each chord is a border of several faces and cells.
#pragma once

#include "gapflow/core/types.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gapflow {

class CurvePoints {
public:
    /// The point between `a` and `b` on the curve of a key; find() is called where it is not known.
    template <class F>
    Vec<3> of(const Vec<3>& a, const Vec<3>& b, std::int32_t key, const F& find)
    {
        if (2 * chords_.size() >= slots_.size())
            grow();
        std::int32_t& slot = slot_of(a, b, key);
        if (slot < 0) {
            slot = static_cast<std::int32_t>(chords_.size());
            chords_.push_back({a, b, find(), key});
        }
        return chords_[slot].point;
    }

private:
    struct Chord {
        Vec<3> a, b, point;
        std::int32_t key;
    };

    std::int32_t& slot_of(const Vec<3>& a, const Vec<3>& b, std::int32_t key)
    {
        std::uint64_t hash = static_cast<std::uint64_t>(key);
        for (int k = 0; k < 3; ++k) {
            const std::uint64_t low = std::bit_cast<std::uint64_t>(a[k]), high = std::bit_cast<std::uint64_t>(b[k]);
            hash = (hash ^ low ^ std::rotl(high, 32)) * 0x9e3779b97f4a7c15;
        }
        for (std::size_t k = hash >> 20;; ++k) {
            std::int32_t& slot = slots_[k & (slots_.size() - 1)];
            if (slot < 0 || (chords_[slot].a == a && chords_[slot].b == b && chords_[slot].key == key))
                return slot;
        }
    }
    void grow()
    {
        slots_.assign(slots_.empty() ? 4096 : 2 * slots_.size(), -1);
        for (std::size_t k = 0; k < chords_.size(); ++k)
            slot_of(chords_[k].a, chords_[k].b, chords_[k].key) = static_cast<std::int32_t>(k);
    }

    std::vector<Chord> chords_;
    std::vector<std::int32_t> slots_; ///< of a hash table, half of them free: numbers of chords, or -1
};

} // namespace gapflow
