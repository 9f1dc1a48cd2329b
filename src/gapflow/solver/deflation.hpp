// Deflation of the constants on connected parts of the fluid whose level only bodies or films determine.
#pragma once

#include "gapflow/solver/coupled_operator.hpp"
#include "gapflow/solver/film_band.hpp"

#include <Eigen/Dense>

#include <vector>

namespace gapflow {

/// Z (Z^T A Z)^+ Z^T with A = L + K M^-1 K^T. Z: for each part of the grid (joined by faces) that no open side touches its
/// constant, extended harmonically into the films connected to it; for each film with much weaker mouths, or without
/// any, its constant. Beyond the `full_parts` largest, parts are treated separately: the diagonal of Z^T A Z.
template <int D>
class Deflation {
public:
    Deflation(const CoupledOperator<D>& matrix, const FilmBand<D>& band);
    bool empty() const { return columns_ == 0; }
    /// Takes the matrix' present response of the bodies.
    void update_bodies();
    /// z += Z (Z^T A Z)^+ Z^T r. Collective.
    void add_correction(const UnknownVector<D>& r, UnknownVector<D>& z) const;
    long bytes() const
    {
        return static_cast<long>(sizeof(int)) * part_.size() +
               static_cast<long>(sizeof(int) + sizeof(double)) * extension_.nonZeros();
    }

private:
    bool all_constants_null() const;
    /// `whole`: no component has several parts of the grid. `weak_films`: whether some have levels of their own.
    void number_columns(bool whole, bool weak_films);
    std::vector<char> whole_levels(const std::vector<double>& acted, const std::vector<char>& grounded, bool weak_films) const;
    /// K^T Z of the full columns. Collective.
    Eigen::MatrixXd flux_of_levels() const;
    /// The extension times c, of one unknown of the band.
    double extended(int row, const Eigen::VectorXd& c) const
    {
        double sum = 0;
        for (Eigen::SparseMatrix<double>::InnerIterator entry(extension_, row); entry; ++entry)
            sum += entry.value() * c[entry.row()];
        return sum;
    }
    void set_up_fluid();
    /// Of each column: sums of magnitudes, to distinguish an energy from round-off.
    struct Magnitudes {
        Eigen::VectorXd links;   ///< of the links' part of its energy
        Eigen::VectorXd fluxes;  ///< of the bodies' part
        Eigen::VectorXd squares; ///< the bodies' part itself, for columns beyond full_
    };
    Magnitudes magnitudes() const;
    /// Z^T r.
    Eigen::VectorXd restricted(const UnknownVector<D>& r) const;
    /// z += Z c.
    void prolong(const Eigen::VectorXd& c, UnknownVector<D>& z) const;

    const CoupledSystem<D>& system_;
    const CoupledOperator<D>& matrix_;
    const FilmBand<D>& band_;
    int columns_ = 0; ///< 0 if all of them are null vectors
    int all_columns_ = 0;
    int full_ = 0;                          ///< columns with a full energy matrix, the first ones
    CellField<D, int> part_;                ///< column of each cell's constant, -1: none
    std::vector<int> node_part_;            ///< column of each node's constant, -1: none
    Eigen::SparseMatrix<double> extension_; ///< full_ x band unknowns: harmonic extension minus the constants
    Eigen::MatrixXd energy_, flux_;         ///< Z^T L Z and K^T Z of the full columns
    Magnitudes magnitudes_;
    Eigen::MatrixXd inverse_energy_;   ///< full_ x full_
    Eigen::VectorXd inverse_diagonal_; ///< of the others
};

} // namespace gapflow
