// Which cells hold film and which faces films close, where both are known by hand.
#include "film_scene.hpp"

#include "gapflow/film/cell_states.hpp"

#include <algorithm>
#include <map>

namespace gapflow::test {
namespace {

template <int D>
std::vector<Index<D>> on_segment(const Grid<D>& grid, const Vec<D>& x, const Vec<D>& y)
{
    std::vector<Index<D>> cells{Index<D>::Constant(-9)}; // is cleared
    cells_on_segment<D>(grid, x, y, cells);
    return cells;
}

TEST(CellsOnSegment, AreThoseThatItPassesInTheirOrder)
{
    const FilmScene<2> scene(4);
    using Cells = std::vector<Index<2>>;
    EXPECT_EQ(on_segment<2>(scene.grid(), {0.2, 0.2}, {0.8, 0.7}), (Cells{{0, 0}}));
    EXPECT_EQ(on_segment<2>(scene.grid(), {0.5, 0.5}, {3.5, 0.5}), (Cells{{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
    // x crosses at 1/2 of the way and at 3/4, y at 2/3.
    EXPECT_EQ(on_segment<2>(scene.grid(), {0, 0}, {2, 1.5}), (Cells{{0, 0}, {1, 0}, {1, 1}}));
    // Downwards, and out of the domain: not wrapped.
    EXPECT_EQ(on_segment<2>(scene.grid(), {0.5, 0.6}, {-0.5, -0.1}), (Cells{{0, 0}, {-1, 0}, {-1, -1}}));
    // Through a corner: nothing of it lies in the cells beside.
    EXPECT_EQ(on_segment<2>(scene.grid(), {0.5, 0.5}, {1.5, 1.5}), (Cells{{0, 0}, {1, 1}}));
    const FilmScene<3> scene3(4);
    EXPECT_EQ(on_segment<3>(scene3.grid(), {0.5, 0.5, 0.6}, {1.6, 0.5, 1.5}),
              (std::vector<Index<3>>{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}}));
}

TEST(SidesOf, EveryFaceWithTheCellBeyond)
{
    for (SideKind kind : {SideKind::open, SideKind::periodic}) {
        const FilmScene<3> scene(4, kind);
        const auto sides = sides_of<3>(scene.grid(), {0, 2, 3});
        for (int i = 0; i < 6; ++i) {
            EXPECT_EQ(sides[i].axis, i / 2);
            EXPECT_EQ(sides[i].end, i % 2);
            EXPECT_EQ(sides[i].face, Index<3>(0, 2, 3) + (i % 2) * step<3>(i / 2));
            EXPECT_EQ(sides[i].cell, Index<3>(0, 2, 3) + (2 * (i % 2) - 1) * step<3>(i / 2));
            EXPECT_EQ(sides[i].inside, kind == SideKind::periodic || (i != 0 && i != 5));
        }
    }
}

/// Films with their cells and closed faces.
template <int D>
struct Classified {
    explicit Classified(const FilmScene<D>& of, const std::function<bool(int, int)>& has_film = {})
        : films(of.films(has_film)), gaps(of.grid(), of.solids(), films), cells(classify_cells<D>(of.faces(), gaps))
    {
        close_faces<D>(of.faces(), gaps, cells);
    }
    std::vector<Film<D>> films;
    FilmGaps<D> gaps;
    FilmCells<D> cells;
};

template <int D>
std::map<CellKind, int> count(const FilmCells<D>& cells)
{
    std::map<CellKind, int> result;
    for (const auto& [key, cell] : cells.cells)
        ++result[cell.kind];
    return result;
}

// Plates that end on planes of the grid, 4 cells wide: all cells between them are film, all of their faces in the layer closed.
template <int D>
void plates_on_planes()
{
    const auto scene = plates<D>(3, 7);
    const Grid<D>& grid = scene->grid();
    const Classified<D> found(*scene);
    ASSERT_EQ(found.films.size(), 1u);
    const int across = static_cast<int>(std::lround(std::pow(4, D - 2)));
    EXPECT_EQ(count(found.cells), (std::map<CellKind, int>{{CellKind::film, 4 * across}}));
    EXPECT_EQ(found.cells.closed.size(), static_cast<std::size_t>((D - 1) * 5 * across));
    double area = 0;
    for (const FilmElement<D>& e : found.films[0].mesh.elements)
        area += e.measure;
    EXPECT_NEAR(area, 4 * across, 1e-10); // a cell's share is 1
    long last = -1;
    for (const auto& [key, cell] : found.cells.cells) {
        EXPECT_GT(key, last) << "in the order of the keys";
        last = key;
        const Index<D> c = grid.cell_of_key(key);
        EXPECT_EQ(c[D - 1], 4);
        EXPECT_TRUE((c.array().template head<D - 1>() >= 3).all() && (c.array().template head<D - 1>() < 7).all());
        EXPECT_EQ(cell.owner, 0);
        ASSERT_EQ(cell.touches.size(), 1u);
        EXPECT_GT(cell.touches[0].measure, 0);
    }
    for (const auto& [face, film] : found.cells.closed)
        EXPECT_EQ(film, 0);
    Index<D> end = Index<D>::Constant(4);
    end[0] = 3;
    EXPECT_NEAR(scene->faces().open(0, end), 0.2, 1e-12);
    EXPECT_EQ(open_after_closing<D>(scene->faces(), found.cells, 0, end), 0);
    end[0] = 2;
    EXPECT_EQ(open_after_closing<D>(scene->faces(), found.cells, 0, end), 1);
    EXPECT_EQ(kind_of<D>(scene->faces(), found.cells, end), CellKind::bulk);
    EXPECT_EQ(kind_of<D>(scene->faces(), found.cells, Index<D>::Constant(4)), CellKind::film);
    EXPECT_EQ(kind_of<D>(scene->faces(), found.cells, Index<D>(Index<D>::Constant(4) - step<D>(D - 1))), CellKind::solid);
}

TEST(FilmCells, PlatesThatEndOnPlanes2D)
{
    plates_on_planes<2>();
}

TEST(FilmCells, PlatesThatEndOnPlanes3D)
{
    plates_on_planes<3>();
}

// Where the plates end within a cell, that cell is mixed: its face into the gap is closed, that to the bulk open.
TEST(FilmCells, TheCellInWhichPlatesEndIsMixed)
{
    const auto scene = plates<2>(2.6, 7.3);
    const Classified<2> found(*scene);
    EXPECT_EQ(count(found.cells), (std::map<CellKind, int>{{CellKind::film, 4}, {CellKind::mixed, 2}}));
    for (int x = 2; x < 8; ++x)
        EXPECT_EQ(kind_of<2>(scene->faces(), found.cells, {x, 4}), x == 2 || x == 7 ? CellKind::mixed : CellKind::film);
    EXPECT_EQ(found.cells.closed.size(), 5u);
    const CellStates<2> states(scene->faces(), found.cells);
    for (int x : {2, 7}) {
        const auto state = states({x, 4});
        EXPECT_EQ(state.kind, CellKind::mixed);
        EXPECT_EQ(state.open, (x == 2 ? 1u : 2u) | 4u | 8u); // to the bulk beside it, below and above
        EXPECT_FALSE(state.leads_out);
        const double beside = x == 2 ? 0.6 : 0.7; // of the faces below and above
        EXPECT_NEAR(state.aperture, 1 + 2 * beside, 1e-9);
    }
    const auto film = states({4, 4});
    EXPECT_EQ(film.kind, CellKind::film);
    EXPECT_EQ(film.open, 0u);
    EXPECT_EQ(film.aperture, 0);
    EXPECT_EQ(states({4, 3}).kind, CellKind::solid);
    const auto corner = states({0, 9});
    EXPECT_EQ(corner.kind, CellKind::bulk);
    EXPECT_EQ(corner.open, 2u | 4u);
    EXPECT_TRUE(corner.leads_out);
    EXPECT_EQ(corner.aperture, 4);
}

// The same in a periodic domain, across its border: kinds and faces are those of the plates displaced.
TEST(FilmCells, GoAcrossAPeriodicBorder)
{
    auto scene = std::make_unique<FilmScene<2>>(10, SideKind::periodic);
    scene->add_box("lower", {8, 2}, {12, 4.3});
    scene->add_box("upper", {8, 4.5}, {12, 7});
    scene->clip();
    const Classified<2> found(*scene);
    ASSERT_EQ(count(found.cells), (std::map<CellKind, int>{{CellKind::film, 4}}));
    EXPECT_EQ(found.cells.closed.size(), 5u);
    for (int x : {8, 9, 10, 11})
        EXPECT_EQ(kind_of<2>(scene->faces(), found.cells, {x, 4}), CellKind::film);
    EXPECT_EQ(found.cells.cells.find(scene->grid().key({1, 4}))->offset(0)[0], 10); // the film lies a period further
    EXPECT_EQ(found.cells.cells.find(scene->grid().key({9, 4}))->offset(0)[0], 0);
}

TEST(FilmGaps, HoldWhatLiesBetweenTheFaces)
{
    const auto scene = plates<2>(3, 7);
    const Classified<2> found(*scene);
    EXPECT_TRUE(found.gaps.holds(0, {5, 4.4}));
    EXPECT_TRUE(found.gaps.holds(0, {3.01, 4.31}));
    EXPECT_FALSE(found.gaps.holds(0, {2.9, 4.4}));
    EXPECT_FALSE(found.gaps.holds(0, {5, 7.1}));
}

/// A cup, 3 cells wide inside and `depth` deep to the layer of the gap, under a lid: the gap over its rim is film.
std::unique_ptr<FilmScene<2>> cup(int depth)
{
    auto scene = std::make_unique<FilmScene<2>>(14);
    const double floor = 8 - depth + 1;
    scene->add_box("left", {3, floor}, {5, 8.3});
    scene->add_box("right", {8, floor}, {10, 8.3});
    scene->add_box("floor", {3, floor - 2}, {10, floor});
    scene->add_box("lid", {3, 8.5}, {10, 11});
    scene->clip();
    return scene;
}

// A part of the grid of up to 9 cells that only films reach becomes film, unless a mouth draws on it.
TEST(AbsorbPockets, TakesSmallPartsThatNoConduitReaches)
{
    for (const int depth : {3, 4}) {
        const auto scene = cup(depth);
        const auto with_lid = [](int a, int b) { return a == 3 || b == 3; };
        for (const bool reached : {false, true}) {
            Classified<2> found(*scene, with_lid);
            ASSERT_EQ(count(found.cells), (std::map<CellKind, int>{{CellKind::film, 4}}));
            std::vector<long> reach;
            if (reached)
                reach.push_back(scene->grid().key({6, 7}));
            std::vector<long> changed =
                absorb_pockets<2>(scene->faces(), CellStates<2>(scene->faces(), found.cells), reach, found.cells);
            EXPECT_EQ(changed.size(), depth == 3 && !reached ? 9u : 0u) << depth;
            std::sort(changed.begin(), changed.end());
            EXPECT_EQ(std::unique(changed.begin(), changed.end()), changed.end());
            for (const long key : changed) {
                const Index<2> c = scene->grid().cell_of_key(key);
                EXPECT_TRUE(c[0] >= 5 && c[0] < 8 && c[1] >= 6 && c[1] < 9);
                EXPECT_EQ(found.cells.kind(key, CellKind::solid), CellKind::film);
            }
            EXPECT_EQ(count(found.cells)[CellKind::film], 4 + static_cast<int>(changed.size()));
            close_faces<2>(scene->faces(), found.gaps, found.cells);
            const CellStates<2> after(scene->faces(), found.cells);
            EXPECT_EQ(after({6, 7}).open, changed.empty() ? 15u : 0u);
        }
    }
}

} // namespace
} // namespace gapflow::test
