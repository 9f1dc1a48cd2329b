// Hash map from keys of cells or faces to values (open addressing). Values lie in a vector, in the order of their insertion.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace gapflow {

template <class T>
class KeyMap {
public:
    using Item = std::pair<long, T>;

    /// Position of the key's value, or -1.
    int index(long key) const
    {
        if (slots_.empty())
            return -1;
        return slots_[slot(key)].index;
    }
    const T* find(long key) const
    {
        const int i = index(key);
        return i < 0 ? nullptr : &items_[i].second;
    }
    T* find(long key)
    {
        const int i = index(key);
        return i < 0 ? nullptr : &items_[i].second;
    }
    bool contains(long key) const { return index(key) >= 0; }

    /// The key's value and whether it is new. References last until the next insertion.
    std::pair<T&, bool> insert(long key, const T& value = T{})
    {
        if (2 * (items_.size() + 1) > slots_.size())
            rebuild(std::max<std::size_t>(32, 2 * slots_.size()));
        Slot& s = slots_[slot(key)];
        if (s.index >= 0)
            return {items_[s.index].second, false};
        s = {key, static_cast<int>(items_.size())};
        items_.emplace_back(key, value);
        return {items_.back().second, true};
    }
    T& operator[](long key) { return insert(key).first; }

    /// Puts the values into the order of their keys.
    void sort()
    {
        std::sort(items_.begin(), items_.end(), [](const Item& a, const Item& b) { return a.first < b.first; });
        rebuild(slots_.size());
    }
    /// Room for n values.
    void reserve(std::size_t n)
    {
        std::size_t size = 32;
        while (size < 2 * n)
            size *= 2;
        items_.reserve(n);
        if (size > slots_.size())
            rebuild(size);
    }
    void clear()
    {
        items_.clear();
        std::fill(slots_.begin(), slots_.end(), Slot{});
    }

    std::size_t size() const { return items_.size(); }
    bool empty() const { return items_.empty(); }
    auto begin() { return items_.begin(); }
    auto end() { return items_.end(); }
    auto begin() const { return items_.begin(); }
    auto end() const { return items_.end(); }
    Item& item(int index) { return items_[index]; }
    const Item& item(int index) const { return items_[index]; }

private:
    struct Slot {
        long key = 0;
        int index = -1;
    };

    std::size_t slot(long key) const
    {
        const std::size_t mask = slots_.size() - 1;
        std::size_t i = (static_cast<std::uint64_t>(key) * 0x9e3779b97f4a7c15u) >> 32 & mask;
        while (slots_[i].index >= 0 && slots_[i].key != key)
            i = (i + 1) & mask;
        return i;
    }
    void rebuild(std::size_t size)
    {
        slots_.assign(size, Slot{});
        for (std::size_t i = 0; i < items_.size(); ++i)
            slots_[slot(items_[i].first)] = {items_[i].first, static_cast<int>(i)};
    }

    std::vector<Slot> slots_;
    std::vector<Item> items_;
};

} // namespace gapflow
