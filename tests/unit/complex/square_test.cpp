// Lines that divide a rectangle where they meet on its border.
#include "gapflow/complex/square.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace gapflow {
namespace {

/// A solid covers the lower right of a unit square up to a corner, from which a line leads to the upper side. Another solid's line leads from there, as far as round-off
/// tells, down to the first one's upper side.
Square divided_square(double lean, double off)
{
    Square square;
    square.low = {0, 0};
    square.high = {1, 1};
    const Vec<2> corner(0.3, 0.84);
    SquareSolid solid;
    solid.edges[0].push_back({0.3, 1});
    solid.edges[1].push_back({0, 0.84});
    solid.corner = {false, true, false, false};
    SquareArc arc;
    arc.start = {0, 0.3};
    arc.end = {1, 0.84};
    arc.from = {0.3, 0};
    arc.to = {1, 0.84};
    arc.segments.push_back({arc.from, corner, nullptr, 0, false, false});
    arc.segments.push_back({corner, arc.to, nullptr, 1, false, false});
    solid.arcs.push_back(arc);
    square.solids = {solid, SquareSolid{}};
    square.corners.push_back({0, corner, Vec<2>(lean, 1).normalized(), true});
    const double x = 0.3 + 0.16 * lean + off;
    square.lines.push_back({1, {x, 1}, {0.3 + 0.32 * lean, 0.84 - 1e-8}, {2, x}, {}, true});
    square.cut();
    return square;
}

TEST(Square, LinesThatMeetOnItsBorderDivideOnTheirSides)
{
    for (const double lean : {1e-6, 1e-3, 0.1})
        for (const double off : {0.0, 2e-16, -2e-16}) {
            const Square square = divided_square(lean, off);
            ASSERT_EQ(square.pieces.size(), 3u) << lean << ' ' << off;
            std::array<double, 3> area;
            std::transform(square.pieces.begin(), square.pieces.end(), area.begin(),
                           [](const SquarePiece& p) { return p.area; });
            std::sort(area.begin(), area.end());
            EXPECT_NEAR(area[0], 0.5 * 0.32 * lean * 0.16, 1e-9);                  // between the lines
            EXPECT_NEAR(area[1], 0.16 * (0.7 - 0.5 * (0.16 + 0.32) * lean), 1e-8); // behind both
            EXPECT_NEAR(area[2], 0.3 + 0.5 * 0.16 * 0.16 * lean, 1e-9);            // before both
            EXPECT_EQ(square.links.size(), 2u);
        }
}

} // namespace
} // namespace gapflow
