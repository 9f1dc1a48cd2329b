// Lists of entries that add to rows, shared out over threads with the same bits whatever their number.
#pragma once

#include "gapflow/core/threads.hpp"

#include <cstddef>
#include <vector>

namespace gapflow {

/// A list of entries cut where a row comes again: each part is shared out over threads, those of a row on one.
class RowRuns {
public:
    RowRuns() = default;
    /// Of n entries, `row(i)` the row of each, below `rows`.
    template <class Row>
    RowRuns(long n, long rows, Row&& row)
    {
        std::vector<char> seen(rows, 0);
        for (long i = 0; i < n; ++i) {
            const long r = row(i);
            if (i > begin_.back() && r == row(i - 1))
                continue;
            if (seen[r]) {
                for (long k = begin_.back(); k < i; ++k)
                    seen[row(k)] = 0;
                begin_.push_back(i);
            }
            seen[r] = 1;
        }
        begin_.push_back(n);
    }
    /// Calls f(i) for all entries, those of a row in their order.
    template <class Row, class F>
    void for_each(Row&& row, F&& f) const
    {
        for (std::size_t run = 0; run + 1 < begin_.size(); ++run) {
            const long first = begin_[run], last = begin_[run + 1];
            const auto start = [&](long i) { // of the row there
                while (i > first && i < last && row(i) == row(i - 1))
                    ++i;
                return i;
            };
            for_each_part(last - first, [&](long begin, long end) {
                for (long i = start(first + begin), stop = start(first + end); i < stop; ++i)
                    f(i);
            });
        }
    }

private:
    std::vector<long> begin_{0};
};

} // namespace gapflow
