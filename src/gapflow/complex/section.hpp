// The border of a convex solid's section with a plane of the grid: curves that follow each other clockwise.
#pragma once

#include "gapflow/complex/curve.hpp"
#include "gapflow/grid/inline_vector.hpp"

#include <utility>

namespace gapflow {

/// Empty, or one closed ellipse (no corners), or curves from corner to corner, or one unbounded line.
struct Section {
    static constexpr int most = 12;
    int count = 0;
    bool closed = true; ///< false: a half-plane's line
    std::array<Curve, most> curve;
    std::array<Vec<2>, most> corner; ///< where curve k starts; it ends where the next one starts. One ellipse: unused
    Vec<2> inside = Vec<2>::Zero();  ///< a point of the section
    Vec<2> low, high;                ///< a box that holds it

    bool empty() const { return count == 0; }
    bool single() const { return count == 1; }
    void add(const Curve& c, const Vec<2>& start)
    {
        curve[count] = c;
        corner[count++] = start;
    }
    /// Bulge of the piece of the border that runs clockwise from A to B, both on it; the corners between belong to it. `around`: where A
    /// and B coincide to round-off, whether the piece is the whole border or nothing.
    Bulge piece(const Vec<2>& A, const Vec<2>& B, bool around) const;
    /// Of the whole border.
    Bulge whole() const;
    /// The piece's ends and the corners between, and which curve joins each to the next.
    struct Walk {
        InlineVector<Vec<2>, 14> points;
        InlineVector<int, 14> curves;
    };
    Walk walk(const Vec<2>& A, const Vec<2>& B, bool around) const;

private:
    /// Curve that holds x, and how far along it x lies (0 .. 1 of a line, clockwise angle of an ellipse).
    std::pair<int, double> locate(const Vec<2>& x) const;
};

} // namespace gapflow
