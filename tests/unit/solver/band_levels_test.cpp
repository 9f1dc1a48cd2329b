// Levels extended over the films' band (solver/band_levels.hpp): what the whole operator makes of them.
#include "gapflow/solver/band_levels.hpp"
#include "gapflow/solver/grid_parts.hpp"
#include "unit/solver/synthetic_system.hpp"

#include <gtest/gtest.h>

namespace gapflow::test {
namespace {

// Two chambers joined by a film: a level on each, and one on the film's nodes. `odd`: every other node is in none.
template <int D>
void expect_the_operators(int n, double mouth, bool odd)
{
    SCOPED_TRACE(testing::Message() << D << "D, mouth " << mouth << ", odd " << odd);
    const auto test = build(chamber_scene<D>(n, 1.0, mouth, 2.0));
    const CoupledSystem<D>& system = test->system;
    const Grid<D>& grid = *test->grid;
    const CoupledOperator<D> matrix(system);
    FilmBand<D> band(matrix);
    band.factorise();
    const GridParts<D> parts = find_grid_parts(system);
    const int chambers = static_cast<int>(parts.size.size()), columns = chambers + 1;
    ASSERT_EQ(chambers, 2);
    std::vector<int> node_part(system.nodes, -1);
    for (int i = 0; i < system.nodes; i += odd ? 2 : 1)
        node_part[i] = chambers;
    const BandLevels<D> levels(matrix, band, parts.part, node_part, columns);
    const Eigen::SparseMatrix<double> extension = levels.extension();
    const Eigen::MatrixXd energy = levels.energy(extension);
    ASSERT_EQ(extension.rows(), columns);
    ASSERT_EQ(extension.cols(), band.size());

    std::vector<UnknownVector<D>> z;
    for (int k = 0; k < columns; ++k) {
        z.push_back(zeros(*test));
        for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) { z[k].cells(c) = parts.part(c) == k; });
        for (int i = 0; i < system.nodes; ++i)
            z[k].nodes[i] = (node_part[i] == k) + extension.coeff(k, i);
        for (const auto& entry : band.owned())
            z[k].cells(entry.cell) += extension.coeff(k, entry.row);
    }
    double largest = 0;
    for (int k = 0; k < columns; ++k) {
        UnknownVector<D> y = zeros(*test);
        matrix.apply_fluid(z[k], y);
        const double own = inner(*test, z[k], y);
        largest = std::max(largest, own);
        for (int j = 0; j < columns; ++j)
            EXPECT_NEAR(energy(j, k), inner(*test, z[j], y), 1e-12 * own) << j << " " << k;
        if (k < chambers) {
            EXPECT_LT(band.gather(y).norm(), 1e-6 * std::sqrt(static_cast<double>(band.size())) * own) << k;
        }
    }
    EXPECT_GT(largest, 0);
    // Without the extension a level drives what its mouths conduct.
    const Eigen::MatrixXd plain = levels.energy(Eigen::SparseMatrix<double>(columns, band.size()));
    EXPECT_LT(energy(0, 0), 0.9 * plain(0, 0));
    EXPECT_DOUBLE_EQ(energy(chambers, chambers), plain(chambers, chambers));
}

TEST(BandLevels, EnergiesAreTheOperators)
{
    for (const double mouth : {1.0, 1e-3})
        for (const bool odd : {false, true}) {
            expect_the_operators<2>(32, mouth, odd);
            expect_the_operators<3>(16, mouth, odd);
        }
}

} // namespace
} // namespace gapflow::test
