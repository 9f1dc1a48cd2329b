#include "gapflow/viscosity/thin_gap.hpp"

#include <algorithm>

namespace gapflow {

double thin_gap_drag(double near, double far, double share, bool next)
{
    const double h = near + far;
    // Mean of y (h - y) / 2 over the part of the gap within half a cell of a point at y = near.
    auto mean = [&](double centre, double& width) {
        const double low = std::max(centre - 0.5, 0.0), high = std::min(centre + 0.5, h);
        width = high - low;
        auto integral = [&](double y) { return y * y * (h / 4 - y / 6); };
        return width > 0 ? (integral(high) - integral(low)) / width : 0.0;
    };
    double width, unused;
    const double u = mean(near, width) / share;
    if (u <= 0)
        return 0;
    const double to_far = next ? mean(near + 1, unused) - u : -u / far;
    return std::max((share * width - u / near + to_far) / u, 0.0);
}

} // namespace gapflow
