#include "gapflow/complex/corner.hpp"

#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapflow {

double corner_conductance(double angle, double open, double covered)
{
    const double tau = 1 - angle / std::numbers::pi;
    return parameters.corner_link * std::pow(tau, -parameters.corner_exponent) * open /
           std::max(covered, parameters.least_covered);
}

} // namespace gapflow
