// What the files of Square share. Private to complex/.
#pragma once

#include "gapflow/complex/square.hpp"

#include <utility>

namespace gapflow {

/// Whether edge e runs against its axis, counterclockwise.
inline bool reversed(int e)
{
    return e >= 2;
}

inline double cross(const Vec<2>& a, const Vec<2>& b)
{
    return a[0] * b[1] - a[1] * b[0];
}

/// Ends of an edge's stretch in counterclockwise order.
inline std::pair<double, double> ends(int e, double from, double to)
{
    return reversed(e) ? std::pair{to, from} : std::pair{from, to};
}

/// SquareArc::joins of an arc that ends where another one is about to start.
inline constexpr int pending = -2;

} // namespace gapflow
