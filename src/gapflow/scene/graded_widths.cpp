#include "gapflow/scene/graded_widths.hpp"

#include <algorithm>
#include <numeric>

namespace gapflow {

namespace {

std::vector<double> grown_widths(std::size_t count, double growth, double largest)
{
    std::vector<double> widths;
    double width = 1;
    for (std::size_t i = 0; i < count; ++i)
        widths.push_back(width = std::min(width * growth, largest));
    return widths;
}

double sum_of_widths(const std::vector<double>& widths)
{
    return std::accumulate(widths.begin(), widths.end(), 0.0);
}

} // namespace

std::vector<double> graded_widths(double length, double growth, double largest)
{
    if (!(length > 0))
        return {};
    std::size_t count = 0;
    for (double reached = 0, width = 1; reached < length * (1 - 1e-12); ++count)
        reached += width = std::min(width * growth, largest);
    double low = 0.5 * std::min(1.0, length), high = growth;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (sum_of_widths(grown_widths(count, middle, largest)) < length ? low : high) = middle;
    }
    std::vector<double> widths = grown_widths(count, high, largest);
    const double factor = length / sum_of_widths(widths);
    for (double& width : widths)
        width *= factor;
    return widths;
}

int core_cells(const Scene& scene, int axis)
{
    return scene.cells[axis] -
           (scene.core ? static_cast<int>(scene.core->below[axis].size() + scene.core->above[axis].size()) : 0);
}

} // namespace gapflow
