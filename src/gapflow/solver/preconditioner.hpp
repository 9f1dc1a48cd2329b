// The preconditioner of the coupled system: films' band, multigrid, band; bodies; constants.
#pragma once

#include "gapflow/solver/body_correction.hpp"
#include "gapflow/solver/constants.hpp"
#include "gapflow/solver/multigrid.hpp"
#include "gapflow/solver/solver.hpp"

#include <optional>

namespace gapflow {

/// A symmetric positive approximate inverse B of L + K M^-1 K^T.
template <int D>
class Preconditioner {
public:
    Preconditioner(const CoupledOperator<D>& matrix, BodyMode bodies);

    /// z = B r; 0 in cells without unknown. `size`: about |r|, the scale for single precision. Collective.
    void apply(const UnknownVector<D>& r, UnknownVector<D>& z, double size);
    /// Whether the bodies' correction should be added now: `remaining` iterations are expected without.
    bool wants_bodies(double remaining) const;
    void add_bodies();
    /// Takes the system's masses and contacts anew.
    void update_bodies();
    long bytes() const;

private:
    /// z = B r with B ~ L^-1.
    void apply_fluid(const UnknownVector<D>& r, UnknownVector<D>& z, double size);
    typename BodyCorrection<D>::Inverse inverse();

    const CoupledOperator<D>& matrix_;
    BodyMode mode_;
    Multigrid<D> multigrid_;
    FilmBand<D> band_;
    std::optional<ConstantCorrection<D>> constants_;
    BodyCorrection<D> bodies_;
};

} // namespace gapflow
