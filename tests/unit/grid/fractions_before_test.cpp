// Fractions that take from those before what no moved solid is near: the same bits, and no questions to solids that have not moved.
#include "scenes.hpp"

namespace gapflow::testing {
namespace {

template <int D>
void expect_same(const Grid<D>& grid, const FaceFractions<D>& a, const FaceFractions<D>& b)
{
    ASSERT_EQ(a.faces.size(), b.faces.size());
    ASSERT_EQ(a.surface_cells.size(), b.surface_cells.size());
    for (std::size_t i = 0; i < a.surface_cells.size(); ++i)
        ASSERT_EQ(a.surface_cells[i], b.surface_cells[i]);
    const Index<D> one = Index<D>::Ones();
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low() - one, grid.high() + 2 * one, [&](const Index<D>& f) {
            ASSERT_EQ(a.open(axis, f), b.open(axis, f)) << "axis " << axis << " face " << f.transpose();
            ASSERT_EQ(std::max(a.cut(axis, f), -1), std::max(b.cut(axis, f), -1))
                << "axis " << axis << " face " << f.transpose();
        });
    for (std::size_t i = 0; i < a.faces.size(); ++i) {
        ASSERT_EQ(a.faces[i].open, b.faces[i].open);
        ASSERT_EQ(a.faces[i].open_centroid, b.faces[i].open_centroid);
        ASSERT_EQ(a.faces[i].solid.size(), b.faces[i].solid.size());
        for (std::size_t k = 0; k < a.faces[i].solid.size(); ++k) {
            ASSERT_EQ(a.faces[i].solid[k].solid, b.faces[i].solid[k].solid);
            ASSERT_EQ(a.faces[i].solid[k].fraction, b.faces[i].solid[k].fraction);
            ASSERT_EQ(a.faces[i].solid[k].centroid, b.faces[i].solid[k].centroid);
            ASSERT_EQ(a.faces[i].solid[k].arm, b.faces[i].solid[k].arm);
        }
    }
}

template <int D>
Vec<D> place(double x, double y)
{
    Vec<D> at = Vec<D>::Constant(0.47);
    at[0] = x;
    at[1] = y;
    return at;
}

/// A ball moves past bodies that stand still, two of them in touch, one reaching out of the domain.
template <int D>
void check_motion(const std::array<SideKind, 2 * D>& sides, FractionMode mode, bool container = false)
{
    const Grid<D> grid = unit_grid<D>(D == 2 ? 64 : 24, sides);
    Scene<D> scene(grid);
    long asked = 0;
    scene.add("still", std::make_unique<Counting<D>>(make_capsule<D>(0.11, 0.2), asked), pose<D>(place<D>(0.7, 0.68), 0.4));
    scene.add("beside", make_box<D>(Vec<D>::Constant(0.2)), pose<D>(place<D>(0.2, 0.2)));
    scene.add("flush", make_box<D>(Vec<D>::Constant(0.2)), pose<D>(place<D>(0.4, 0.2)));
    scene.add("beyond", make_ball<D>(0.1), pose<D>(place<D>(0.02, 0.8)));
    if (container)
        scene.add("container", make_inside_out<D>(make_box<D>(Vec<D>::Constant(0.97))), pose<D>(Vec<D>::Constant(0.5)));
    const int moving = scene.add("moving", make_ball<D>(0.08), pose<D>(place<D>(0.36, 0.35)));
    FaceFractions<D> before;
    long most = 0;
    for (int move = 0; move < 4; ++move) { // the second time nothing has moved
        if (move > 1) {
            const Vec<D> at = place<D>(0.36 + 0.02 * move, 0.35 + 0.01 * move);
            scene.solids[moving].shape = PlacedShape<D>(scene.solids[moving].shape.shape(), pose<D>(at));
            scene.solids[moving].centre = at;
        }
        const FaceClipper<D> clipper(grid, scene.solids, mode);
        const FaceFractions<D> fresh = face_fractions(grid, clipper);
        asked = 0;
        FaceFractions<D> found = face_fractions(grid, clipper, move > 0 ? &before : nullptr);
        expect_same(grid, fresh, found);
        if (move == 0)
            most = asked;
        else
            EXPECT_LT(asked, most / 20); // beyond periodic sides, in voxels next to the one that moves
        before = std::move(found);
    }
    EXPECT_GT(most, 100);
}

TEST(FractionsBefore, AreTakenWhereNothingMoved)
{
    check_motion<2>(all_sides<2>(SideKind::wall), FractionMode::cut_cell);
    check_motion<3>(all_sides<3>(SideKind::wall), FractionMode::cut_cell);
    check_motion<2>(all_sides<2>(SideKind::open), FractionMode::voxel);
    check_motion<2>(all_sides<2>(SideKind::periodic), FractionMode::cut_cell);
    check_motion<3>(all_sides<3>(SideKind::periodic), FractionMode::cut_cell);
}

// A container is near everything, and it does not move; beyond periodic sides faces are clipped where they wrap to.
TEST(FractionsBefore, WithAContainer)
{
    check_motion<2>(all_sides<2>(SideKind::periodic), FractionMode::cut_cell, true);
    check_motion<2>(all_sides<2>(SideKind::wall), FractionMode::cut_cell, true);
}

TEST(FractionsBefore, AreNotTakenFromOtherGridsOrSolids)
{
    Grid<2> grid = unit_grid<2>(32, all_sides<2>(SideKind::open));
    Scene<2> scene(grid);
    scene.add("a", make_ball<2>(0.1), pose<2>({0.3, 0.3}));
    scene.add("b", make_ball<2>(0.1), pose<2>({0.7, 0.7}));
    const FaceFractions<2> before = face_fractions(grid, FaceClipper<2>(grid, scene.solids, FractionMode::cut_cell));
    const auto check = [&](const std::vector<Solid<2>>& solids) {
        const FaceClipper<2> clipper(grid, solids, FractionMode::cut_cell);
        expect_same(grid, face_fractions(grid, clipper), face_fractions(grid, clipper, &before));
    };
    check({scene.solids[1]}); // one has left
    check({scene.solids[1], scene.solids[0]});
    grid.shift_to({0.01, 0.0});
    check(scene.solids);
}

} // namespace
} // namespace gapflow::testing
