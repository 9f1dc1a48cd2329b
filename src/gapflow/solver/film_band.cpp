// Multiplicative Schwarz (Smith, Bjorstad & Gropp 1996, section 1.1) between a direct solve on the band b and multigrid G on
// the cells: with R_b the restriction to the band and A_b = R_b L R_b^T,
//
//     z_1 = R_b^T A_b^-1 R_b r;     x = G (r - L z_1);     z = z_1 + x + R_b^T A_b^-1 R_b (r - L (z_1 + x)),
//
// symmetric and positive. Since A_b z_1 = r on the band, r - L z_1 is 0 there and differs from r only in the cells beside
// it, and the last residual is -L x. The film's coupling does not enter multigrid's diagonal, where it would act as a spurious
// connection to ground.
//
// A block of A_b without connections to the outside is singular: its constant is projected out of the right-hand side and the result.

#include "gapflow/solver/film_band.hpp"

#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/core/sharing.hpp"
#include "gapflow/solver/loose_cells.hpp"
#include "gapflow/solver/sorted_cells.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace gapflow {

namespace {

constexpr int layers = 2; // cells between a mouth's cells and the band's end
// Where films are everywhere, a band around all of them would be a factorisation of the whole fluid: then the band consists of those of the
// mouths' own cells whose mouths conduct more than a share of what the cell's faces do, and of small groups of cells whose level multigrid hardly
// corrects. This is so where the band has more cells than this.
constexpr std::size_t few_cells = 8000;
constexpr double share_of_faces = 0.1;
// Multigrid's least eigenvalue elsewhere in a crowd is some 0.55 (examples/11_pile at t = 0.4, where pores of two cells have 0.09 to 0.4).
constexpr double loose_level = 0.5;
constexpr std::size_t pore_cells = 32; // at most in such a group: bounds the factor
constexpr double shift = 1e-12;        // relative, on the diagonal: films whose mouths are 1e-12 of their own conductance

/// Cells of pairs that one face ties much more than all others do: the slices of a gap on both sides of a plane of the grid in it. Multigrid hardly
/// corrects their level. Sorted.
template <int D>
std::vector<long> loose_pairs(const CoupledSystem<D>& system)
{
    const Grid<D>& grid = *system.grid;
    struct Faces {
        double sum = 0, largest = 0;
        int side = 0; ///< the largest one's
    };
    const auto faces_of = [&](const Index<D>& c) {
        Faces faces;
        for (int side = 0; side < 2 * D; ++side) {
            const double g = system.conductance(side / 2, side % 2 ? Index<D>(c + step<D>(side / 2)) : c);
            faces.sum += g;
            if (g > faces.largest) {
                faces.largest = g;
                faces.side = side;
            }
        }
        return faces;
    };
    // By what leads out of a pair, and its own face.
    const auto loose = [](double out, double inside) { return 2 * out < loose_level * (out + 2 * inside); };
    std::vector<long> cells;
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        const Faces own = faces_of(c);
        const double g = own.largest;
        if (!loose(own.sum - g, g))
            return;
        const Index<D> other = grid.wrapped(Index<D>(c + (own.side % 2 ? 1 : -1) * step<D>(own.side / 2)));
        if (grid.in_domain(other) && (!grid.owns(other) || loose(own.sum + faces_of(other).sum - 2 * g, g)))
            cells.push_back(grid.key(c));
    });
    if (grid.comm().size() > 1)
        cells = all_values(grid.comm(), cells);
    std::sort(cells.begin(), cells.end());
    return cells;
}

/// Cells around the links, and loose pairs.
struct Surroundings {
    std::vector<long> cells;      ///< sorted
    bool crowded;                 ///< these cells and those beside them alone
    std::vector<long> linked;     ///< the links' cells and the pairs', sorted
    std::vector<double> by_links; ///< what the links conduct to each of them
};

/// All cells within `layers` steps of the links' cells, or within one.
template <int D>
Surroundings around_links(const CoupledSystem<D>& system)
{
    std::vector<std::pair<long, double>> ties;
    for (const Link& link : system.links)
        for (const auto& [key, weight] : link.cells)
            ties.emplace_back(key, link.conductance * weight * weight);
    for (const long key : loose_pairs(system))
        ties.emplace_back(key, 0.0);
    std::stable_sort(ties.begin(), ties.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    Surroundings around;
    for (const auto& [key, conductance] : ties) {
        if (around.linked.empty() || around.linked.back() != key) {
            around.linked.push_back(key);
            around.by_links.push_back(0);
        }
        around.by_links.back() += conductance;
    }
    const auto crowd = [](const std::vector<long>& cells) { return cells.size() > few_cells; };
    around.cells = with_neighbours(*system.grid, around.linked);
    around.crowded = crowd(around.cells);
    for (int layer = 1; layer < layers && !around.crowded; ++layer) {
        std::vector<long> wider = with_neighbours(*system.grid, around.cells);
        around.crowded = crowd(wider);
        if (!around.crowded)
            around.cells = std::move(wider);
    }
    return around;
}

/// What is told of a cell: 1 if it has an unknown, then the conductances of its faces.
template <int D>
constexpr int told_width = 2 * D + 1;

/// Clears the first entry of the cells that a crowd's band does not need.
template <int D>
void leave_out(const Grid<D>& grid, const Surroundings& around, std::vector<double>& told)
{
    std::vector<CellTies<D>> cells;
    std::vector<double*> needed;
    std::size_t link = 0;
    for (std::size_t i = 0; i < around.cells.size(); ++i) {
        double* const entry = &told[told_width<D> * i];
        if (entry[0] <= 0)
            continue;
        const long key = around.cells[i];
        while (link < around.linked.size() && around.linked[link] < key)
            ++link;
        const bool is_linked = link < around.linked.size() && around.linked[link] == key;
        CellTies<D>& cell = cells.emplace_back(CellTies<D>{key, {}, is_linked ? around.by_links[link] : 0.0});
        std::copy_n(entry + 1, 2 * D, cell.faces.begin());
        needed.push_back(entry);
    }
    const std::vector<char> loose = loose_cells<D>(grid, cells, loose_level, pore_cells);
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const double by_faces = std::accumulate(cells[k].faces.begin(), cells[k].faces.end(), 0.0);
        *needed[k] = loose[k] || cells[k].others > share_of_faces * by_faces;
    }
}

} // namespace

template <int D>
FilmBand<D>::FilmBand(const CoupledOperator<D>& matrix) : matrix_(matrix), system_(matrix.system())
{
    find_cells();
}

template <int D>
void FilmBand<D>::find_cells()
{
    const Grid<D>& grid = *system_.grid;
    const Block<D> level = block_of_level<D>(grid.low(), grid.high());
    // Every rank sends its cells' data: whether there is an unknown, and the conductances around.
    constexpr int width = told_width<D>;
    const Surroundings surroundings = around_links(system_);
    const std::vector<long>& around = surroundings.cells;
    if (around.empty() && system_.nodes == 0)
        return;

    std::vector<double> told(width * around.size(), 0.0);
    for (std::size_t i = 0; i < around.size(); ++i) {
        const Index<D> c = grid.cell_of_key(around[i]);
        if (!grid.owns(c) || system_.component(c) < 0)
            continue;
        for (int side = 0; side < 2 * D; ++side)
            told[width * i + 1 + side] = system_.conductance(side / 2, side % 2 ? Index<D>(c + step<D>(side / 2)) : c);
        told[width * i] = 1;
    }
    grid.comm().sum(told);
    if (surroundings.crowded)
        leave_out<D>(grid, surroundings, told);
    for (std::size_t i = 0; i < around.size(); ++i)
        if (told[width * i] > 0) {
            rows_.insert(around[i], system_.nodes + static_cast<int>(keys_.size()));
            keys_.push_back(around[i]);
            faces_.emplace_back();
            std::copy_n(&told[width * i + 1], 2 * D, faces_.back().begin());
        }
    size_ = system_.nodes + static_cast<int>(keys_.size());

    NeighbourWalk<D> walk(grid, keys_);
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const Index<D> c = grid.cell_of_key(keys_[i]);
        const int row = system_.nodes + static_cast<int>(i);
        if (grid.owns(c))
            owned_.push_back({row, c, level.offset(c)});
        beside_.emplace_back();
        for (int side = 0; side < 2 * D; ++side) {
            const long place = walk(c, side);
            beside_.back()[side] = place < 0 ? -1 : system_.nodes + static_cast<int>(place);
            if (place >= 0 || faces_[i][side] <= 0)
                continue;
            Index<D> other = c;
            other[side / 2] += side % 2 ? 1 : -1;
            other = grid.wrapped(other);
            if (grid.in_domain(other) && grid.owns(other))
                outside_.push_back({level.offset(other), row, faces_[i][side]});
        }
    }
    const int first_plane = grid.low()[D - 1], planes = grid.high()[D - 1] - first_plane;
    plane_begin_.assign(planes + 1, 0);
    for (const OwnedCell& entry : owned_)
        ++plane_begin_[entry.cell[D - 1] - first_plane + 1];
    std::partial_sum(plane_begin_.begin(), plane_begin_.end(), plane_begin_.begin());
    for (std::size_t r = 0; r < system_.links.size(); ++r) {
        for (const auto& [node, weight] : system_.links[r].nodes)
            link_rows_.add(node, weight);
        for (const auto& [key, weight] : system_.links[r].cells) {
            const int row = row_of(key);
            if (row >= 0)
                link_rows_.add(row, weight);
            const Index<D> c = grid.cell_of_key(key);
            if (!grid.owns(c))
                continue;
            link_cells_.push_back({static_cast<int>(r), level.offset(c), weight});
            if (row < 0)
                outside_links_.push_back(link_cells_.back());
        }
        link_rows_.end_list();
    }
}

template <int D>
int FilmBand<D>::row_of(long key) const
{
    const int* row = rows_.find(key);
    return row ? *row : -1;
}

template <int D>
template <class F, class Join>
void FilmBand<D>::for_each_term(F&& f, Join&& join, std::vector<char>& fixed) const
{
    matrix_.for_each_film_edge([&](int i, int j, double conductance) {
        f(i, i, conductance);
        f(j, j, conductance);
        f(j, i, -conductance);
        if (conductance != 0)
            join(i, j);
    });
    for (int i = 0; i < system_.nodes; ++i) {
        f(i, i, matrix_.film_ground()[i]);
        fixed[i] = matrix_.film_ground()[i] != 0;
    }
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const int row = system_.nodes + static_cast<int>(i);
        for (int side = 0; side < 2 * D; ++side) {
            const double a = faces_[i][side];
            if (a <= 0)
                continue;
            const int column = beside_[i][side];
            if (column == row)
                continue; // periodic axis of one cell
            f(row, row, a);
            if (column < 0) {
                fixed[row] = 1;
                continue;
            }
            join(row, column);
            if (column < row)
                f(row, column, -a);
        }
    }
    for (std::size_t k = 0; k < system_.links.size(); ++k) {
        const Link& link = system_.links[k];
        const std::span terms = link_rows_[static_cast<long>(k)];
        double sum = 0, size = 0;
        for (const auto& [i, wi] : terms) {
            for (const auto& [j, wj] : terms)
                if (j <= i)
                    f(i, j, link.conductance * wi * wj);
            if (link.conductance > 0)
                join(i, terms.front().number);
            sum += wi;
            size += std::abs(wi);
        }
        if (!terms.empty() && link.conductance > 0 && std::abs(sum) > 1e-9 * size)
            fixed[terms.front().number] = 1; // a mouth to an open side
    }
}

// The lower triangle, and the blocks that float. Terms are counted, laid out by columns, and merged there: with films everywhere a
// list of triplets would be the largest array of a step.
template <int D>
Eigen::SparseMatrix<double> FilmBand<D>::assemble()
{
    DisjointSets joined(size_);
    std::vector<char> fixed(size_, 0);
    Eigen::SparseMatrix<double> matrix(size_, size_);
    std::vector<long> begin(size_ + 1, 0);
    for_each_term([&](int, int j, double) { ++begin[j + 1]; }, [&](int i, int j) { joined.join(i, j); }, fixed);
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::pair<int, double>> terms(begin.back());
    std::vector<long> next(begin.begin(), begin.end() - 1);
    for_each_term([&](int i, int j, double value) { terms[next[j]++] = {i, value}; }, [](int, int) {}, fixed);
    long count = 0; // of merged terms; they move to the front
    for (int j = 0; j < size_; ++j) {
        const long first = begin[j], last = begin[j + 1];
        std::stable_sort(&terms[first], terms.data() + last, [](const auto& a, const auto& b) { return a.first < b.first; });
        begin[j] = count;
        for (long k = first; k < last; ++k)
            if (count > begin[j] && terms[count - 1].first == terms[k].first)
                terms[count - 1].second += terms[k].second;
            else
                terms[count++] = terms[k];
    }
    begin[size_] = count;
    matrix.resizeNonZeros(count);
    for (int j = 0; j <= size_; ++j)
        matrix.outerIndexPtr()[j] = static_cast<int>(begin[j]);
    for (long k = 0; k < count; ++k) {
        matrix.innerIndexPtr()[k] = terms[k].first;
        matrix.valuePtr()[k] = terms[k].second;
    }

    std::vector<char> block_fixed(size_, 0);
    for (int i = 0; i < size_; ++i)
        if (fixed[i])
            block_fixed[joined.find(i)] = 1;
    std::unordered_map<int, int> number;
    block_.assign(size_, -1);
    for (int i = 0; i < size_; ++i)
        if (const int root = joined.find(i); !block_fixed[root])
            block_[i] = number.try_emplace(root, static_cast<int>(number.size())).first->second;
    block_size_.assign(number.size(), 0);
    for (int i = 0; i < size_; ++i)
        if (block_[i] >= 0)
            ++block_size_[block_[i]];
    return matrix;
}

template <int D>
void FilmBand<D>::factorise()
{
    correction_.setZero(size_);
    if (empty())
        return;
    Eigen::SparseMatrix<double> matrix = assemble();
    const Eigen::VectorXd diagonal = matrix.diagonal();
    const double alone = std::max(diagonal.maxCoeff(), 1.0); // for a row of zeros
    double relative = shift;
    for (int attempt = 0; attempt < 5; ++attempt, relative *= 100) {
        for (int i = 0; i < size_; ++i)
            matrix.coeffRef(i, i) = diagonal[i] > 0 ? diagonal[i] * (1 + relative) : alone;
        if (attempt == 0)
            factor_.analyse(matrix);
        if (factor_.factorise(matrix))
            return;
    }
    throw ComputationError("the films' matrix is not positive semidefinite");
}

template <int D>
Eigen::VectorXd FilmBand<D>::gather(const UnknownVector<D>& v) const
{
    Eigen::VectorXd values = Eigen::VectorXd::Zero(size_);
    for (const OwnedCell& entry : owned_)
        values[entry.row] = v.cells(entry.cell);
    system_.grid->comm().sum(std::span<double>(values.data() + system_.nodes, values.size() - system_.nodes));
    values.head(system_.nodes) = v.nodes;
    return values;
}

namespace {

/// Means of the values over every floating block.
std::vector<double> block_means(const std::vector<int>& block, const std::vector<long>& block_size,
                                const Eigen::Ref<const Eigen::VectorXd>& values)
{
    std::vector<double> mean(block_size.size(), 0.0);
    for (std::size_t i = 0; i < block.size(); ++i)
        if (block[i] >= 0)
            mean[block[i]] += values[static_cast<long>(i)] / static_cast<double>(block_size[block[i]]);
    return mean;
}

/// Takes them off the columns.
void remove_means(const std::vector<int>& block, const std::vector<long>& block_size, Eigen::Ref<Eigen::MatrixXd> columns)
{
    if (block_size.empty())
        return;
    for (long k = 0; k < columns.cols(); ++k) {
        const std::vector<double> mean = block_means(block, block_size, columns.col(k));
        for (std::size_t i = 0; i < block.size(); ++i)
            if (block[i] >= 0)
                columns(static_cast<long>(i), k) -= mean[block[i]];
    }
}

} // namespace

template <int D>
template <class Columns, class Solve>
Columns FilmBand<D>::between_means(Columns x, Solve&& solve) const
{
    remove_means(block_, block_size_, x);
    x = solve(x);
    remove_means(block_, block_size_, x);
    return x;
}

template <int D>
Eigen::VectorXd FilmBand<D>::solve(const Eigen::VectorXd& r) const
{
    return between_means(r, [this](const Eigen::VectorXd& b) { return factor_.solve(b); });
}

template <int D>
Eigen::MatrixXd FilmBand<D>::solve_columns(const Eigen::MatrixXd& r) const
{
    return between_means(r, [this](const Eigen::MatrixXd& b) { return factor_.solve_columns(b); });
}

template <int D>
void FilmBand<D>::first(const UnknownVector<D>& r, double scale, Level<D>& level)
{
    if (empty())
        return;
    const Eigen::VectorXd on_band = gather(r);
    correction_ = solve(on_band);
    const std::vector<double> mean =
        block_means(block_, block_size_, on_band); // the floating blocks' constants in r, which solve() does not act on
    for (const OwnedCell& entry : owned_)
        level.b[entry.level_offset] = block_[entry.row] >= 0 && level.inverse(entry.cell) > 0
                                          ? static_cast<float>(scale * mean[block_[entry.row]])
                                          : 0.0f;
    for (const Neighbour& entry : outside_)
        level.b[entry.level_offset] += static_cast<float>(scale * entry.conductance * correction_[entry.row]);
    int last = -1;
    double difference = 0; // of the last link
    for (const LinkCell& entry : outside_links_) {
        if (entry.link != last)
            difference = sum_over_band(last = entry.link, correction_);
        level.b[entry.level_offset] -=
            static_cast<float>(scale * system_.links[entry.link].conductance * entry.weight * difference);
    }
}

template <int D>
double FilmBand<D>::sum_over_band(int link, const Eigen::VectorXd& values) const
{
    double sum = 0;
    for (const auto& [row, weight] : link_rows_[link])
        sum += weight * values[row];
    return sum;
}

template <int D>
void FilmBand<D>::second(double scale, const Level<D>& level)
{
    if (empty())
        return;
    const long links = static_cast<long>(system_.links.size());
    Eigen::VectorXd r = Eigen::VectorXd::Zero(size_ + links);
    for (const OwnedCell& entry : owned_) {
        const int cell = entry.row - system_.nodes;
        const double x = level.x[entry.level_offset];
        for (int side = 0; side < 2 * D; ++side) {
            const long next = entry.level_offset + (side % 2 ? 1 : -1) * static_cast<long>(level.block.stride[side / 2]);
            r[entry.row] -= scale * (faces_[cell][side] * (x - level.x[next]));
        }
    }
    for (const LinkCell& entry : link_cells_)
        r[size_ + entry.link] += scale * (entry.weight * level.x[entry.level_offset]);
    system_.grid->comm().sum(std::span<double>(r.data() + system_.nodes, r.size() - system_.nodes));
    for (long k = 0; k < links; ++k) {
        const double flux = system_.links[k].conductance * r[size_ + k];
        for (const auto& [row, weight] : link_rows_[k])
            r[row] -= weight * flux;
    }
    correction_ += solve(r.head(size_));
}

template <int D>
long FilmBand<D>::bytes() const
{
    if (empty())
        return 0;
    return factor_.bytes() + static_cast<long>(keys_.size()) * (8 + 2 * D * 12) +
           static_cast<long>(outside_.size() * sizeof(Neighbour));
}

template class FilmBand<2>;
template class FilmBand<3>;

} // namespace gapflow
