// Grid indices and the exchange of ghosts on one rank.
#include "scenes.hpp"

namespace gapflow::testing {
namespace {

template <int D>
Grid<D> mixed_grid()
{
    auto sides = all_sides<D>(SideKind::wall);
    sides[0] = sides[1] = SideKind::periodic;
    Index<D> cells = Index<D>::Constant(5);
    cells[0] = 7;
    return Grid<D>(Vec<D>::Constant(-1), 0.5, cells, sides, 2, Communicator(MPI_COMM_SELF));
}

TEST(Grid, PlacesOfCellsAndFaces)
{
    const auto grid = mixed_grid<2>();
    EXPECT_EQ(grid.cell_centre({0, 1}), Vec<2>(-0.75, -0.25));
    EXPECT_EQ(grid.face_centre(0, {0, 1}), Vec<2>(-1, -0.25));
    EXPECT_EQ(grid.face_centre(1, {0, 1}), Vec<2>(-0.75, -0.5));
    EXPECT_EQ(grid.cell_of({-1.2, 1.4}), Index<2>(-1, 4));
    EXPECT_EQ(grid.wrapped({-1, -1}), Index<2>(6, -1));
    EXPECT_EQ(grid.key({3, 2}), 17);
    EXPECT_EQ(grid.cell_of_key(17), Index<2>(3, 2));
    EXPECT_EQ(owned_faces_end(grid, 0), Index<2>(7, 5));
    EXPECT_EQ(owned_faces_end(grid, 1), Index<2>(7, 6));
}

template <int D>
void check_exchange()
{
    const auto grid = mixed_grid<D>();
    CellField<D> cells(grid, -1.0);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) { cells(c) = static_cast<double>(grid.key(c)); });
    exchange(grid, cells);
    for_each_index<D>(cells.block().low, cells.block().high, [&](const Index<D>& c) {
        const Index<D> w = grid.wrapped(c);
        EXPECT_EQ(cells(c), grid.in_domain(w) ? static_cast<double>(grid.key(w)) : -1.0) << c.transpose();
    });

    FaceField<D, int> faces(grid, -1);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis),
                          [&](const Index<D>& f) { faces(axis, f) = static_cast<int>(100 * f.sum() + axis); });
    exchange(grid, faces, 1);
    Index<D> last = Index<D>::Constant(2); // the last faces of a closed axis travel across the periodic side
    last[1] = 5;
    last[0] = 7;
    EXPECT_EQ(faces(1, last), faces(1, Index<D>(last - 7 * step<D>(0))));
    last[0] = 8;
    EXPECT_EQ(faces(1, last), -1); // only one layer was asked for
}

TEST(Field, PeriodicExchangeOnOneRank)
{
    check_exchange<2>();
    check_exchange<3>();
}

TEST(InlineVector, GrowsOntoTheHeap)
{
    InlineVector<int, 2> v;
    for (int i = 0; i < 5; ++i) {
        v.push_back(i);
        ASSERT_EQ(v.size(), static_cast<std::size_t>(i + 1));
        int next = 0;
        for (int value : v)
            ASSERT_EQ(value, next++);
    }
    const InlineVector<int, 2> copy = v;
    v.clear();
    EXPECT_TRUE(v.empty());
    EXPECT_EQ(copy[4], 4);
}

} // namespace
} // namespace gapflow::testing
