// The preconditioner of the coupled system: films' band, multigrid, band; bodies; deflation of constants.
#pragma once

#include "gapflow/solver/body_correction.hpp"
#include "gapflow/solver/deflation.hpp"
#include "gapflow/solver/multigrid.hpp"
#include "gapflow/solver/solver.hpp"

#include <optional>

namespace gapflow {

/// A symmetric positive approximate inverse B of L + K M^-1 K^T.
template <int D>
class Preconditioner {
public:
    /// `ask_lightness`: whether light bodies are corrected for from the start where `bodies` is automatic.
    Preconditioner(const CoupledOperator<D>& matrix, BodyMode bodies, bool ask_lightness = true);

    /// z = B r; 0 in cells without unknown. `size`: about |r|, the scale for single precision. Collective.
    void apply(const UnknownVector<D>& r, UnknownVector<D>& z, double size);
    /// The same, but unless `in_z` the cells of z may stay in the cycle's storage, to be read by result and result_rest.
    /// `loaded`: load() has been called for all cells with to_level = 1 / size.
    void apply_in_place(const UnknownVector<D>& r, UnknownVector<D>& z, double size, bool loaded, bool in_z);
    /// Hands n cells of a row of r to the next application.
    void load(const Index<D>& first, const double* r, int n, double to_level)
    {
        Level<D>& level = multigrid_->finest();
        float* to = &level.b[level.block.offset(first)];
        for (int i = 0; i < n; ++i)
            to[i] = static_cast<float>(to_level * r[i]);
    }
    /// n cells of a row of B r but for result_rest: in `buffer`, or where z holds them.
    const double* result(const Index<D>& first, const UnknownVector<D>& z, int n, double* buffer) const
    {
        if (dense_)
            return &z.cells(first);
        const Level<D>& level = multigrid_->finest();
        const float* from = &level.x[level.block.offset(first)];
        for (int i = 0; i < n; ++i)
            buffer[i] = from_level_ * from[i];
        return buffer;
    }
    /// Calls f(cell, value) for the cells of a plane normal to the last axis where B r is more than result, by value.
    template <class F>
    void result_rest(int plane, F&& f) const
    {
        if (!dense_)
            band_.for_each_correction(plane, f);
    }
    /// Whether the bodies' correction should be added now: after `done` iterations `remaining` are expected without.
    bool wants_bodies(int done, double remaining) const;
    void add_bodies();
    /// Corrects for some motions of the bodies (columns), too, unless for all already.
    void add_motions(const Eigen::MatrixXd& motions);
    /// Whether it corrects for all motions of the bodies.
    bool corrects_bodies() const { return bodies_.ready() && !bodies_.in_part(); }
    /// Takes the system's masses and contacts anew.
    void update_bodies();
    long bytes() const;

private:
    /// z = B r with B ~ L^-1.
    void apply_fluid(const UnknownVector<D>& r, UnknownVector<D>& z, double size);
    /// The same, in the finest level's x and the band's correction; nodes in z.
    void cycle(const UnknownVector<D>& r, UnknownVector<D>& z, double size, bool loaded);
    /// z.cells from there.
    void fetch(UnknownVector<D>& z) const;
    typename BodyCorrection<D>::Inverse inverse();
    std::vector<Index<D>> banded_cells() const;

    const CoupledOperator<D>& matrix_;
    BodyMode mode_;
    std::optional<Multigrid<D>> multigrid_; ///< its cells include those of films, which it joins as the grid would
    std::vector<long> film_cells_;          ///< offsets in its finest level of cells without unknown that films fill
    FilmBand<D> band_;
    std::optional<Deflation<D>> deflation_;
    BodyCorrection<D> bodies_;
    double from_level_ = 1; ///< factor on the finest level's x
    bool dense_ = true;     ///< the last result is in z
};

} // namespace gapflow
