// Lists of numbers with weights, one after the other in memory: a sparse matrix by rows.
#pragma once

#include <span>
#include <vector>

namespace gapflow {

template <class Number>
class WeightedLists {
public:
    struct Entry {
        Number number;
        double weight;
    };

    long size() const { return static_cast<long>(begin_.size()) - 1; }
    std::span<const Entry> operator[](long list) const
    {
        return {entries_.data() + begin_[list], entries_.data() + begin_[list + 1]};
    }
    const std::vector<Entry>& entries() const { return entries_; }
    /// Adds to the list that end_list() ends.
    void add(Number number, double weight) { entries_.push_back({number, weight}); }
    void end_list() { begin_.push_back(static_cast<int>(entries_.size())); }

    /// For each of n places the lists that have a number there, in their order. `place`: of a number.
    template <class Place>
    WeightedLists<int> transposed(long n, Place&& place) const
    {
        WeightedLists<int> result;
        result.begin_.assign(n + 1, 0);
        for (const Entry& entry : entries_)
            ++result.begin_[place(entry.number) + 1];
        for (long i = 0; i < n; ++i)
            result.begin_[i + 1] += result.begin_[i];
        result.entries_.resize(entries_.size());
        std::vector<int> next(result.begin_.begin(), result.begin_.end() - 1);
        for (long list = 0; list < size(); ++list)
            for (const Entry& entry : (*this)[list])
                result.entries_[next[place(entry.number)]++] = {static_cast<int>(list), entry.weight};
        return result;
    }

    long bytes() const { return static_cast<long>(sizeof(Entry) * entries_.size() + sizeof(int) * begin_.size()); }

private:
    template <class>
    friend class WeightedLists;
    std::vector<Entry> entries_;
    std::vector<int> begin_{0}; ///< first of each list, and the end
};

} // namespace gapflow
