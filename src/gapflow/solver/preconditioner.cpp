#include "gapflow/solver/preconditioner.hpp"

#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

// Ratio of added to own mass above which bodies are corrected for from the start; it grows with the number of columns.
double light(int dofs)
{
    return std::max(2.0, 0.25 * dofs);
}
constexpr int few_dofs = 48;        // more columns than this only if the iterations converge slowly
constexpr double column_bytes = 96; // a cell, for kept columns

/// Film cells count as cells of the grid.
template <int D>
Multigrid<D> multigrid_of(const CoupledOperator<D>& matrix)
{
    const CoupledSystem<D>& system = matrix.system();
    if (system.film_faces.empty())
        return Multigrid<D>(system, matrix.conductance());
    return Multigrid<D>(system, shared_conductances(system, true));
}

} // namespace

template <int D>
Preconditioner<D>::Preconditioner(const CoupledOperator<D>& matrix, BodyMode bodies, bool ask_lightness)
    : matrix_(matrix), mode_(bodies), band_(matrix), bodies_(matrix)
{
    call_both([&] { multigrid_.emplace(multigrid_of(matrix)); }, [&] { band_.factorise(); });
    deflation_.emplace(matrix, band_);
    for (const FilmFace<D>& face : matrix.system().film_faces)
        for (const Index<D>& c : {face.face, Index<D>(face.face - step<D>(face.axis))})
            if (matrix.system().grid->owns(c) && matrix.system().component(c) < 0)
                film_cells_.push_back(multigrid_->finest().block.offset(c));
    std::sort(film_cells_.begin(), film_cells_.end());
    film_cells_.erase(std::unique(film_cells_.begin(), film_cells_.end()), film_cells_.end());
    if (matrix.dofs() == 0 || mode_ == BodyMode::never)
        return;
    if (mode_ == BodyMode::always ||
        (ask_lightness && matrix.dofs() <= few_dofs && bodies_.lightness(inverse()) > light(matrix.dofs())))
        add_bodies();
}

template <int D>
void Preconditioner<D>::cycle(const UnknownVector<D>& r, UnknownVector<D>& z, double size, bool loaded)
{
    const Grid<D>& grid = *matrix_.system().grid;
    const double to_level = size > 0 ? 1 / size : 1; // single precision has a range of 1e38
    if (!loaded)
        for_each_piece(grid, [&](const Index<D>& first, int n) { load(first, &r.cells(first), n, to_level); });
    band_.first(r, to_level, multigrid_->finest());
    multigrid_->cycle();
    for (long c : film_cells_)
        multigrid_->finest().x[c] = 0;
    from_level_ = multigrid_->scale() / to_level;
    band_.second(from_level_, multigrid_->finest());
    z.nodes = band_.node_correction();
}

template <int D>
void Preconditioner<D>::fetch(UnknownVector<D>& z) const
{
    const Grid<D>& grid = *matrix_.system().grid;
    const Level<D>& level = multigrid_->finest();
    for_each_piece(grid, [&](const Index<D>& first, int n) {
        const float* from = &level.x[level.block.offset(first)];
        double* to = &z.cells(first);
        for (int i = 0; i < n; ++i)
            to[i] = from_level_ * from[i];
    });
    for (int plane = grid.low()[D - 1]; plane < grid.high()[D - 1]; ++plane)
        band_.for_each_correction(plane, [&](const Index<D>& c, double value) { z.cells(c) += value; });
}

template <int D>
void Preconditioner<D>::apply_fluid(const UnknownVector<D>& r, UnknownVector<D>& z, double size)
{
    cycle(r, z, size, false);
    fetch(z);
}

template <int D>
typename BodyCorrection<D>::Inverse Preconditioner<D>::inverse()
{
    return [this](const UnknownVector<D>& r, UnknownVector<D>& z) {
        apply_fluid(r, z, std::sqrt(dot(*matrix_.system().grid, r, r)));
    };
}

template <int D>
void Preconditioner<D>::apply(const UnknownVector<D>& r, UnknownVector<D>& z, double size)
{
    apply_fluid(r, z, size);
    if (bodies_.ready())
        bodies_.correct(inverse(), r, z);
    deflation_->add_correction(r, z);
    dense_ = true;
}

template <int D>
void Preconditioner<D>::apply_in_place(const UnknownVector<D>& r, UnknownVector<D>& z, double size, bool loaded, bool in_z)
{
    cycle(r, z, size, loaded);
    dense_ = in_z || bodies_.ready() || !deflation_->empty();
    if (!dense_)
        return;
    fetch(z);
    if (bodies_.ready())
        bodies_.correct(inverse(), r, z);
    deflation_->add_correction(r, z);
}

template <int D>
bool Preconditioner<D>::wants_bodies(int done, double remaining) const
{
    // A column costs less than an iteration. The first iterations may reduce little where those to come do not: the more columns, the
    // later. Iterations that have cost three times the columns already do not converge as expected (a box that lies on a wall and turns about a
    // contact: its film of the least thickness makes an eigenvalue of 1e7, at which round-off stops them).
    const double columns = 0.6 * matrix_.dofs() + 8; // in iterations
    return mode_ == BodyMode::automatic && matrix_.dofs() > 0 && !corrects_bodies() && 10 * done >= matrix_.dofs() &&
           (remaining > columns || done > 3 * columns);
}

template <int D>
std::vector<Index<D>> Preconditioner<D>::banded_cells() const
{
    std::vector<Index<D>> cells;
    for (const auto& entry : band_.owned())
        cells.push_back(entry.cell);
    return cells;
}

template <int D>
void Preconditioner<D>::add_bodies()
{
    if (!bodies_.set_up(inverse(), column_bytes, banded_cells()))
        mode_ = BodyMode::never;
}

template <int D>
void Preconditioner<D>::add_motions(const Eigen::MatrixXd& motions)
{
    if (mode_ == BodyMode::automatic && !corrects_bodies() && motions.cols() > 0)
        bodies_.add_motions(inverse(), column_bytes, motions, banded_cells());
}

template <int D>
void Preconditioner<D>::update_bodies()
{
    deflation_->update_bodies();
    bodies_.update();
}

template <int D>
long Preconditioner<D>::bytes() const
{
    return multigrid_->bytes() + band_.bytes() + deflation_->bytes() + bodies_.bytes();
}

template class Preconditioner<2>;
template class Preconditioner<3>;

} // namespace gapflow
