// Deflation of the constants: L 1_k = 0 for a sealed part of the fluid, and nearly so for one that only films join to
// the rest, so that neither multigrid (which has only faces) nor the films' band (which is local) corrects its level. The energy
// of a constant comes from the bodies and the films:
//
//     E = Z^T (L + K M^-1 K^T) Z = Z^T L Z + G G^T,   G = (Z^T K) M^-1/2,     B gains Z E^+ Z^T.
//
// Energies at round-off (null vectors) are dropped; squares make that safe for the bodies' part.

#include "gapflow/solver/deflation.hpp"

#include "gapflow/core/decompositions.hpp"
#include "gapflow/solver/band_levels.hpp"
#include "gapflow/solver/grid_parts.hpp"
#include "gapflow/solver/weak_films.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr int full_parts = 48;
constexpr double round_off = 1e-12; // of a level's energy with free bodies

} // namespace

template <int D>
Deflation<D>::Deflation(const CoupledOperator<D>& matrix, const FilmBand<D>& band)
    : system_(matrix.system()), matrix_(matrix), band_(band)
{
    // The usual case: the null space contains all constants, and no part of a component has a separate level.
    int weak = 0;
    node_part_ = weak_films(system_, weak);
    const bool whole = std::all_of(system_.components.begin(), system_.components.end(),
                                   [](const Component& c) { return c.grid_parts == 0 || c.grid_parts == 1; });
    if (weak == 0 && whole && all_constants_null())
        return;
    number_columns(whole, weak > 0);
    for (int& k : node_part_)
        if (k >= 0)
            k += columns_;
    all_columns_ = columns_ += weak;
    if (columns_ > 0) {
        set_up_fluid();
        update_bodies();
    }
}

template <int D>
bool Deflation<D>::all_constants_null() const
{
    long floating = 0;
    for (const Component& component : system_.components)
        floating += component.grounded ? 0 : 1;
    return floating == system_.null_space.cols();
}

// Parts without a body or link have no energy and no column. Parts that lie wholly in the films' band have no column either: the band's
// solve determines their level.
template <int D>
void Deflation<D>::number_columns(bool whole, bool weak_films)
{
    const Grid<D>& grid = *system_.grid;
    std::vector<char> grounded;
    std::vector<long> size;
    if (whole) {
        part_ = system_.component;
        for (const Component& component : system_.components)
            grounded.push_back(component.open_faces);
    } else {
        GridParts<D> parts = find_grid_parts(system_);
        part_ = std::move(parts.part);
        grounded = parts.grounded;
        size = parts.size;
    }
    std::vector<double> acted(grounded.size(), 0.0);
    for (const auto& entry : system_.cell_flux)
        if (const int k = part_(entry.row); k >= 0)
            acted[k] = 1;
    for (const Link& link : system_.links)
        for (const auto& entry : link.cells)
            if (const Index<D> c = grid.cell_of_key(entry.first); grid.owns(c) && part_(c) >= 0)
                acted[part_(c)] = 1;
    grid.comm().sum(acted);
    std::vector<double> banded(size.size(), 0.0);
    for (const auto& entry : band_.owned())
        if (!size.empty() && !band_.floating(entry.row))
            banded[part_(entry.cell)] += 1;
    grid.comm().sum(banded);
    for (std::size_t k = 0; k < size.size(); ++k)
        if (banded[k] == static_cast<double>(size[k]))
            acted[k] = 0;
    std::vector<int> column(grounded.size(), -1);
    const std::vector<char> null = whole_levels(acted, grounded, weak_films);
    for (std::size_t k = 0; k < column.size(); ++k)
        if (acted[k] > 0 && !grounded[k] && !null[k])
            column[k] = columns_++;
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (int& k = part_(c); k >= 0)
            k = column[k];
    });
}

// Parts whose level, extended into the films, is that of all of a component whose constant is a null vector: there is no other part of the grid and
// no film with a level of its own in it. What would be found of its energy is the round-off of the extension (two balls in the slots of a comb).
template <int D>
std::vector<char> Deflation<D>::whole_levels(const std::vector<double>& acted, const std::vector<char>& grounded,
                                             bool weak_films) const
{
    const std::size_t count = acted.size();
    std::vector<char> null(count, 0);
    if (weak_films || !all_constants_null())
        return null;
    const Grid<D>& grid = *system_.grid;
    std::vector<double> sums(2 * count, 0.0); // of each part: its component's number, summed over its cells, and their count
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (const int k = part_(c); k >= 0) {
            sums[2 * k] += system_.component(c);
            sums[2 * k + 1] += 1;
        }
    });
    grid.comm().sum(sums);
    std::vector<int> parts(system_.components.size(), 0);
    const auto component = [&](std::size_t k) { return std::lround(sums[2 * k] / sums[2 * k + 1]); };
    for (std::size_t k = 0; k < count; ++k)
        if (acted[k] > 0 && !grounded[k])
            ++parts[component(k)];
    for (std::size_t k = 0; k < count; ++k)
        null[k] = acted[k] > 0 && !grounded[k] && parts[component(k)] == 1 && !system_.components[component(k)].grounded;
    return null;
}

template <int D>
typename Deflation<D>::Magnitudes Deflation<D>::magnitudes() const
{
    const int dofs = matrix_.dofs();
    Magnitudes result{Eigen::VectorXd::Zero(columns_), Eigen::VectorXd::Zero(columns_), Eigen::VectorXd::Zero(columns_)};
    auto& [links, fluxes, squares] = result;
    const Grid<D>& grid = *system_.grid;
    const Eigen::VectorXd mass = system_.mass.diagonal();
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(dofs, columns_);
    Eigen::MatrixXd magnitudes = Eigen::MatrixXd::Zero(dofs, columns_);
    auto count = [&](int k, int body, double sign, const Twist<D>& f) {
        if (k >= 0) {
            sums.block(twist_size<D> * body, k, twist_size<D>, 1) += sign * f;
            magnitudes.block(twist_size<D> * body, k, twist_size<D>, 1) += f.cwiseAbs();
        }
    };
    for (const auto& entry : system_.cell_flux)
        count(part_(entry.row), entry.body, 1, entry.flux);
    for (const Link& link : system_.links)
        for (const auto& [key, weight] : link.cells)
            if (const Index<D> c = grid.cell_of_key(key); grid.owns(c) && part_(c) >= 0)
                links[part_(c)] += link.conductance * weight * weight;
    grid.comm().sum(std::span<double>(sums.data(), sums.size()));
    grid.comm().sum(std::span<double>(magnitudes.data(), magnitudes.size()));
    grid.comm().sum(std::span<double>(links.data(), links.size()));
    for (const auto& entry : system_.node_flux)
        count(node_part_[entry.row], entry.body, 1, entry.flux);
    for (const Link& link : system_.links)
        for (const auto& [node, weight] : link.nodes)
            if (node_part_[node] >= 0)
                links[node_part_[node]] += link.conductance * weight * weight;
    for (int k = 0; k < columns_; ++k)
        for (int d = 0; d < dofs; ++d) {
            fluxes[k] += magnitudes(d, k) * magnitudes(d, k) / mass[d];
            squares[k] += sums(d, k) * sums(d, k) / mass[d];
        }
    return result;
}

template <int D>
Eigen::MatrixXd Deflation<D>::flux_of_levels() const
{
    const Grid<D>& grid = *system_.grid;
    Eigen::MatrixXd flux = Eigen::MatrixXd::Zero(matrix_.dofs(), full_);
    if (matrix_.dofs() == 0)
        return flux;
    CellField<D, int> row(grid, -1); // of the band
    for (const auto& entry : band_.owned())
        row(entry.cell) = entry.row;
    const auto add = [&](int column, int of_band, const auto& entry) {
        const auto wrench = [&](int k) { return flux.block(twist_size<D> * entry.body, k, twist_size<D>, 1); };
        if (column >= 0 && column < full_)
            wrench(column) += entry.flux;
        if (of_band < 0)
            return;
        for (Eigen::SparseMatrix<double>::InnerIterator level(extension_, of_band); level; ++level)
            wrench(static_cast<int>(level.row())) += level.value() * entry.flux;
    };
    for (const auto& entry : system_.cell_flux)
        add(part_(entry.row), row(entry.row), entry);
    grid.comm().sum(std::span<double>(flux.data(), flux.size()));
    for (const auto& entry : system_.node_flux)
        add(node_part_[entry.row], band_.empty() ? -1 : entry.row, entry);
    return flux;
}

template <int D>
void Deflation<D>::set_up_fluid()
{
    full_ = std::min(columns_, full_parts);
    const int dofs = matrix_.dofs();
    const BandLevels<D> levels(matrix_, band_, part_, node_part_, full_);
    extension_ = levels.extension();
    energy_ = levels.energy(extension_);
    flux_ = flux_of_levels();
    const Eigen::VectorXd mass = system_.mass.diagonal();
    magnitudes_ = magnitudes();
    const auto& [links, fluxes, squares] = magnitudes_;
    for (int k = 0; k < full_; ++k) {
        if (energy_(k, k) < 1e-13 * links[k]) {
            energy_.row(k).setZero();
            energy_.col(k).setZero();
        }
        // A film's harmonic extension may carry the flux: its magnitude is not in `fluxes`.
        if (dofs > 0 && flux_.col(k).cwiseAbs2().cwiseQuotient(mass).sum() < 1e-20 * fluxes[k])
            flux_.col(k).setZero();
    }
}

template <int D>
void Deflation<D>::update_bodies()
{
    columns_ = all_columns_;
    if (columns_ == 0)
        return;
    const int dofs = matrix_.dofs();
    Eigen::MatrixXd energy = energy_;
    if (dofs > 0) {
        energy += flux_.transpose() * matrix_.inverse_mass_of_columns(flux_);
        // A level that drives only bodies which contacts hold is a null vector: what is left of its energy is round-off, which the pseudo-inverse would scale up.
        const Eigen::VectorXd mass = system_.mass.diagonal();
        for (int k = 0; k < full_; ++k)
            if (energy(k, k) <= round_off * (energy_(k, k) + flux_.col(k).cwiseAbs2().cwiseQuotient(mass).sum())) {
                energy.row(k).setZero();
                energy.col(k).setZero();
            }
    }
    inverse_energy_ = positive_pseudo_inverse(energy, 1e-10);

    const auto& [links, fluxes, squares] = magnitudes_;
    inverse_diagonal_ = Eigen::VectorXd::Zero(columns_ - full_);
    for (int k = full_; k < columns_; ++k) {
        const double energy_k = links[k] + (squares[k] > 1e-20 * fluxes[k] ? squares[k] : 0.0);
        inverse_diagonal_[k - full_] = energy_k > 0 ? 1 / energy_k : 0.0;
    }
    if (inverse_energy_.isZero(0) && inverse_diagonal_.isZero(0)) // null vectors only
        columns_ = 0;
}

template <int D>
Eigen::VectorXd Deflation<D>::restricted(const UnknownVector<D>& r) const
{
    const Grid<D>& grid = *system_.grid;
    const auto of_planes = each_plane(grid.low()[D - 1], grid.high()[D - 1], [&](int plane) {
        Eigen::VectorXd sums = Eigen::VectorXd::Zero(columns_ + 1); // entry 0: no column
        for_each_row_of_plane<D>(grid.low(), grid.high(), plane, [&](const Index<D>& row) {
            const double* value = &r.cells(row);
            const int* part = &part_(row);
            for (int i = 0; i < grid.high()[0] - grid.low()[0]; ++i)
                sums[part[i] + 1] += value[i];
        });
        return sums;
    });
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(columns_ + 1);
    for (const Eigen::VectorXd& of_plane : of_planes)
        sums += of_plane;
    const auto add = [&](int row, double value) {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(extension_, row); entry; ++entry)
            sums[entry.row() + 1] += value * entry.value();
    };
    for (const auto& entry : band_.owned())
        add(entry.row, r.cells(entry.cell));
    grid.comm().sum(std::span<double>(sums.data() + 1, columns_));
    for (int i = 0; i < system_.nodes; ++i) {
        sums[node_part_[i] + 1] += r.nodes[i];
        if (!band_.empty())
            add(i, r.nodes[i]);
    }
    return sums.tail(columns_);
}

template <int D>
void Deflation<D>::prolong(const Eigen::VectorXd& c, UnknownVector<D>& z) const
{
    Eigen::VectorXd value = Eigen::VectorXd::Zero(columns_ + 1);
    value.tail(columns_) = c;
    const Grid<D>& grid = *system_.grid;
    for_each_row_on_threads<D>(grid.low(), grid.high(), [&](const Index<D>& row) {
        double* to = &z.cells(row);
        const int* part = &part_(row);
        for (int i = 0; i < grid.high()[0] - grid.low()[0]; ++i)
            to[i] += value[part[i] + 1];
    });
    for (int i = 0; i < system_.nodes; ++i)
        z.nodes[i] += value[node_part_[i] + 1];
    if (extension_.nonZeros() == 0)
        return;
    for (int i = 0; i < system_.nodes; ++i)
        z.nodes[i] += extended(i, c);
    for (const auto& entry : band_.owned())
        z.cells(entry.cell) += extended(entry.row, c);
}

template <int D>
void Deflation<D>::add_correction(const UnknownVector<D>& r, UnknownVector<D>& z) const
{
    if (empty())
        return;
    const Eigen::VectorXd sums = restricted(r);
    Eigen::VectorXd c(columns_);
    c.head(full_) = inverse_energy_ * sums.head(full_);
    c.tail(columns_ - full_) = inverse_diagonal_.cwiseProduct(sums.tail(columns_ - full_));
    prolong(c, z);
}

template class Deflation<2>;
template class Deflation<3>;

} // namespace gapflow
