// Union-find with path halving; the smaller root wins, so that results do not depend on the order of unions.
#pragma once

#include <numeric>
#include <utility>
#include <vector>

namespace gapflow {

class DisjointSets {
public:
    explicit DisjointSets(int size = 0) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }

    int size() const { return static_cast<int>(parent_.size()); }
    int add()
    {
        parent_.push_back(size());
        return size() - 1;
    }
    int find(int i)
    {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(int a, int b)
    {
        a = find(a);
        b = find(b);
        if (a > b)
            std::swap(a, b);
        parent_[b] = a;
    }
    /// Number of each element's set, counted from 0 in the order of their smallest members.
    std::vector<int> numbers(int& count)
    {
        std::vector<int> number(parent_.size());
        count = 0;
        for (int i = 0; i < size(); ++i)
            number[i] = find(i) == i ? count++ : number[find(i)];
        return number;
    }

private:
    std::vector<int> parent_;
};

} // namespace gapflow
