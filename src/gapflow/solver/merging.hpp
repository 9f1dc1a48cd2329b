// Which neighbours become one on the next coarser level of a multigrid on a graded grid.
#pragma once

#include <algorithm>
#include <vector>

namespace gapflow {

/// Neighbours whose widths sum up to more than this times the level's target stay apart. 1.75 and more: 10 to 12 iterations in 3D instead of
/// 7 to 9.
inline constexpr double widest_merged = 1.25;

/// Where the cells begin .. end start after merging: in pairs from the first of the narrowest ones both ways, as far as two together are no
/// wider than `widest`. Coarser levels so become uniform.
inline std::vector<int> merged(const std::vector<double>& width, int begin, int end, double widest)
{
    const double narrowest = *std::min_element(width.begin() + begin, width.begin() + end);
    int first = begin;
    while (width[first] > 1.001 * narrowest)
        ++first;
    std::vector<int> starts;
    for (int i = first - 1; i >= begin; --i) {
        if (i > begin && width[i] + width[i - 1] <= widest)
            --i;
        starts.push_back(i);
    }
    std::reverse(starts.begin(), starts.end());
    for (int i = first; i < end; ++i) {
        starts.push_back(i);
        if (i + 1 < end && width[i] + width[i + 1] <= widest)
            ++i;
    }
    return starts;
}

} // namespace gapflow
