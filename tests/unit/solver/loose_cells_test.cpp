// Small groups of cells behind narrow openings: found, and no burden to the solver.
#include "gapflow/solver/loose_cells.hpp"
#include "unit/solver/synthetic_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace gapflow::test {
namespace {

/// Cells of a square, all faces inside it of conductance 1.
class Square {
public:
    explicit Square(int n)
        : n_(n), grid_(Vec<2>::Zero(), 1.0, Index<2>(n, n), TestScene<2>(Index<2>(n, n), 1.0).sides, 1, Communicator())
    {
        for (int axis = 0; axis < 2; ++axis)
            for (int j = 0; j < n; ++j)
                for (int i = 1; i < n; ++i)
                    set(axis, axis == 0 ? Index<2>(i, j) : Index<2>(j, i), 1);
    }
    void set(int axis, const Index<2>& face, double conductance) { faces_[{axis, face[0], face[1]}] = conductance; }
    /// All faces around a cell but those to the other cell.
    void enclose(const Index<2>& cell, const Index<2>& other, double conductance)
    {
        for (int axis = 0; axis < 2; ++axis)
            for (int end = 0; end < 2; ++end) {
                const Index<2> face = cell + end * step<2>(axis);
                const Index<2> beyond = end ? face : Index<2>(face - step<2>(axis));
                if (beyond != other && faces_.contains({axis, face[0], face[1]}))
                    set(axis, face, conductance);
            }
    }
    std::vector<Index<2>> loose(double least, std::size_t most, double others = 0) const
    {
        std::vector<CellTies<2>> cells;
        for (int j = 0; j < n_; ++j)
            for (int i = 0; i < n_; ++i)
                cells.push_back(
                    {grid_.key(Index<2>(i, j)), {of(0, i, j), of(0, i + 1, j), of(1, i, j), of(1, i, j + 1)}, others});
        std::sort(cells.begin(), cells.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
        const std::vector<char> found = loose_cells<2>(grid_, cells, least, most);
        std::vector<Index<2>> result;
        for (std::size_t k = 0; k < cells.size(); ++k)
            if (found[k])
                result.push_back(grid_.cell_of_key(cells[k].key));
        return result;
    }

private:
    double of(int axis, int i, int j) const
    {
        const auto face = faces_.find({axis, i, j});
        return face == faces_.end() ? 0.0 : face->second;
    }

    int n_;
    Grid<2> grid_;
    std::map<std::array<int, 3>, double> faces_;
};

TEST(LooseCells, NoneWhereAllFacesConductAlike)
{
    EXPECT_TRUE(Square(12).loose(0.5, 32).empty());
}

TEST(LooseCells, TwoCellsBehindNarrowOpenings)
{
    Square square(12);
    const Index<2> a(4, 5), b(5, 5);
    square.enclose(a, b, 0.02);
    square.enclose(b, a, 0.02);
    // 2 * 0.12 / 2.12 = 0.113
    EXPECT_EQ(square.loose(0.5, 32), (std::vector{a, b}));
    EXPECT_TRUE(square.loose(0.11, 32).empty());
    EXPECT_TRUE(square.loose(0.5, 1).empty());
    // What ties cells to films counts as a way out: 2 * (0.12 + 0.8) / (2.12 + 0.8) = 0.63
    EXPECT_TRUE(square.loose(0.5, 32, 0.4).empty());
}

TEST(LooseCells, AGroupInAGroup)
{
    // Four cells in a row: two pairs with an opening between them that is wider than those to the outside.
    Square square(12);
    std::vector<Index<2>> row;
    for (int i = 4; i < 8; ++i)
        row.emplace_back(i, 6);
    for (const Index<2>& cell : row)
        square.enclose(cell, cell, 0.001);
    square.set(0, Index<2>(5, 6), 1);
    square.set(0, Index<2>(6, 6), 0.5);
    square.set(0, Index<2>(7, 6), 1);
    // A pair alone: 2 * 0.505 / 2.505 = 0.40; all four: 2 * 0.01 / 5.01
    EXPECT_EQ(square.loose(0.3, 32), row);
    EXPECT_TRUE(square.loose(0.3, 2).empty());
    EXPECT_EQ(square.loose(0.5, 2), row);
}

// Pores of two cells whose openings are a thousandth to a twentieth of a face, in a fluid where so many cells lie beside films that most stay out of their band.
TEST(LooseCells, PoresInACrowdTakeNoIterations)
{
    const auto iterations = [](bool pores) {
        const auto test = build(film_scene<3>(40, 1.0, 1.0, 2.0));
        CoupledSystem<3>& system = test->system;
        const Grid<3>& grid = *test->grid;
        long count = 0, enclosed = 0;
        for_each_index<3>(grid.low(), grid.high(), [&](const Index<3>& c) {
            if (system.component(c) < 0)
                return;
            if (count++ % 3 == 0)
                system.links.push_back({1e-6, {{0, 1.0}}, {{grid.key(c), -1.0}}});
        });
        for_each_index<3>(grid.low(), grid.high(), [&](const Index<3>& c) {
            const Index<3> other = c + step<3>(0);
            if (!pores || c[0] % 5 != 1 || c[1] % 5 != 2 || c[2] % 5 != 2 || system.conductance(0, other) <= 0)
                return;
            const double opening = 0.001 * std::pow(50.0, 0.5 + 0.5 * noise(++enclosed));
            for (const Index<3>& cell : {c, other})
                for (int axis = 0; axis < 3; ++axis)
                    for (int end = 0; end < 2; ++end)
                        if (const Index<3> face = cell + end * step<3>(axis); !(axis == 0 && face == other))
                            system.conductance(axis, face) *= opening;
        });
        UnknownVector<3> exact = sample(*test, 0.1), rhs = zeros(*test), p = zeros(*test);
        remove_null(*test, exact);
        apply(system, exact, rhs);
        const SolveReport report = CoupledSolver<3>(system, {}).solve(p, rhs);
        EXPECT_TRUE(report.converged) << report.message;
        return report.iterations;
    };
    const int without = iterations(false), with = iterations(true);
    EXPECT_LE(with, without + 1); // 49 and 12 if the band has none of them
}

} // namespace
} // namespace gapflow::test
