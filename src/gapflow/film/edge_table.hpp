// Map from unordered pairs of vertices to an integer.
#pragma once

#include "gapflow/film/key_map.hpp"

namespace gapflow {

class EdgeTable {
public:
    /// Empties the table and makes room for n pairs.
    void reset(std::size_t n)
    {
        map_.clear();
        map_.reserve(n);
    }
    /// Value of the pair, or -1.
    int find(int a, int b) const
    {
        const int* value = map_.find(key(a, b));
        return value ? *value : -1;
    }
    /// Reference to the pair's value, -1 if new; valid until the next insertion.
    int& insert(int a, int b) { return map_.insert(key(a, b), -1).first; }

private:
    static long key(int a, int b) { return static_cast<long>(std::min(a, b)) << 32 | static_cast<long>(std::max(a, b)); }

    KeyMap<int> map_;
};

} // namespace gapflow
