#include "gapflow/solver/sorted_cells.hpp"
#include "unit/solver/synthetic_system.hpp"

#include <gtest/gtest.h>

#include <set>

namespace gapflow::test {
namespace {

template <int D>
void expect_neighbours(const Index<D>& cells, std::array<SideKind, 2 * D> sides)
{
    const Grid<D> grid(Vec<D>::Zero(), 1.0, cells, sides, 1, Communicator());
    std::set<long> some;
    for_each_index<D>(Index<D>::Zero(), cells, [&](const Index<D>& c) {
        if (noise(static_cast<std::uint64_t>(grid.key(c))) > 0.3)
            some.insert(grid.key(c));
    });
    const std::vector<long> keys(some.begin(), some.end());
    ASSERT_GT(keys.size(), 5u);
    std::set<long> around = some;
    NeighbourWalk<D> walk(grid, keys);
    for (long key : keys)
        for (int side = 0; side < 2 * D; ++side) {
            const Index<D> c = grid.cell_of_key(key);
            Index<D> beside = c;
            beside[side / 2] += side % 2 ? 1 : -1;
            beside = grid.wrapped(beside);
            const long place = walk(c, side);
            if (!grid.in_domain(beside)) {
                EXPECT_EQ(place, -1);
                continue;
            }
            around.insert(grid.key(beside));
            if (some.contains(grid.key(beside))) {
                ASSERT_GE(place, 0) << c.transpose() << ", side " << side;
                EXPECT_EQ(keys[place], grid.key(beside));
            } else {
                EXPECT_EQ(place, -1) << c.transpose() << ", side " << side;
            }
        }
    EXPECT_EQ(with_neighbours(grid, keys), std::vector<long>(around.begin(), around.end()));
}

TEST(SortedCells, NeighboursAreFound)
{
    constexpr SideKind wall = SideKind::wall, round = SideKind::periodic;
    expect_neighbours<2>({9, 7}, {wall, wall, wall, wall});
    expect_neighbours<2>({9, 7}, {round, round, wall, wall});
    expect_neighbours<2>({1, 40}, {round, round, round, round}); // beside itself
    expect_neighbours<3>({4, 5, 6}, {wall, wall, wall, wall, wall, wall});
    expect_neighbours<3>({2, 5, 6}, {round, round, wall, wall, round, round});
}

} // namespace
} // namespace gapflow::test
