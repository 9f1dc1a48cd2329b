#include "gapflow/solver/preconditioner.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

// Added over own mass from where bodies are corrected for at once: the more columns that takes, the later.
double light(int dofs)
{
    return std::max(2.0, 0.25 * dofs);
}
constexpr int few_dofs = 48; // more columns than this only once iterations turn out slow
constexpr double column_bytes = 96; // a cell, for kept columns

} // namespace

template <int D>
Preconditioner<D>::Preconditioner(const CoupledOperator<D>& matrix, BodyMode bodies)
    : matrix_(matrix), mode_(bodies), multigrid_(matrix.system()), band_(matrix, multigrid_.finest()), bodies_(matrix)
{
    constants_.emplace(matrix, band_);
    if (matrix.dofs() == 0 || mode_ == BodyMode::never)
        return;
    if (mode_ == BodyMode::always || (matrix.dofs() <= few_dofs && bodies_.lightness(inverse()) > light(matrix.dofs())))
        add_bodies();
}

template <int D>
void Preconditioner<D>::apply_fluid(const UnknownVector<D>& r, UnknownVector<D>& z, double size)
{
    const Grid<D>& grid = *matrix_.system().grid;
    Level<D>& level = multigrid_.finest();
    const double scale = multigrid_.scale();
    const int n = grid.high()[0] - grid.low()[0];
    const double to_level = size > 0 ? 1 / size : 1; // single precision has a range of 1e38
    for_each_row<D>(grid.low(), grid.high(), [&](const Index<D>& row) {
        const double* from = &r.cells(row);
        const float* inverse = &level.inverse_diagonal[level.block.offset(row)];
        float* to = &level.b[level.block.offset(row)];
        for (int i = 0; i < n; ++i)
            to[i] = inverse[i] > 0 ? static_cast<float>(to_level * from[i]) : 0.0f;
    });
    band_.first(r, to_level, level);
    multigrid_.cycle();
    const double from_level = scale / to_level;
    band_.second(from_level, level);
    for_each_row<D>(grid.low(), grid.high(), [&](const Index<D>& row) {
        const float* from = &level.x[level.block.offset(row)];
        double* to = &z.cells(row);
        for (int i = 0; i < n; ++i)
            to[i] = from_level * from[i];
    });
    z.nodes.setZero();
    band_.add_correction(z);
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
    constants_->add_correction(r, z);
}

template <int D>
bool Preconditioner<D>::wants_bodies(double remaining) const
{
    // A column costs less than an iteration.
    return mode_ == BodyMode::automatic && matrix_.dofs() > 0 && !bodies_.ready() && remaining > 0.6 * matrix_.dofs() + 8;
}

template <int D>
void Preconditioner<D>::add_bodies()
{
    if (!bodies_.set_up(inverse(), column_bytes))
        mode_ = BodyMode::never;
}

template <int D>
void Preconditioner<D>::update_bodies()
{
    constants_.emplace(matrix_, band_);
    bodies_.update();
}

template <int D>
long Preconditioner<D>::bytes() const
{
    return multigrid_.bytes() + band_.bytes() + constants_->bytes() + bodies_.bytes();
}

template class Preconditioner<2>;
template class Preconditioner<3>;

} // namespace gapflow
