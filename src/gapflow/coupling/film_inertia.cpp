#include "gapflow/coupling/film_inertia.hpp"
#include "gapflow/core/sharing.hpp"
#include "gapflow/core/sparse_cholesky.hpp"
#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <map>

namespace gapflow {

namespace {

constexpr int most_nodes = 4000; // films with more are left out: not worth a second factorisation
constexpr double shift = 1e-10;  // relative, on the diagonal: for films without a way out

template <int D>
using PairRow = Eigen::Matrix<double, 2 * twist_size<D>, 1>;

// Sums of the matrices by pair of solids.
template <int D>
class Pairs {
public:
    explicit Pairs(const Coupling<D>& coupling) : coupling_(coupling) {}

    PairMatrix<D>& of(int a, int b) { return sums_.try_emplace(std::minmax(a, b), PairMatrix<D>::Zero()).first->second; }

    void add(const NormalInertia<D>& inertia)
    {
        if (inertia.master == inertia.other)
            return;
        PairRow<D> row = PairRow<D>::Zero();
        add_row(row, inertia.master, inertia.master < inertia.other, inertia.row_master);
        add_row(row, inertia.other, inertia.other < inertia.master, inertia.row_other);
        of(inertia.master, inertia.other) += inertia.mass * row * row.transpose();
    }

    /// Of all ranks. Collective.
    std::vector<FilmInertia<D>> list() const
    {
        std::vector<FilmInertia<D>> own, films;
        for (const auto& [pair, matrix] : sums_)
            own.push_back({pair.first, pair.second, matrix});
        Pairs all(coupling_); // images of a pair may be several ranks'
        for (const FilmInertia<D>& film : all_values(coupling_.grid->comm(), own))
            all.of(film.a, film.b) += film.matrix;
        for (const auto& [pair, matrix] : all.sums_)
            if (!matrix.isZero(0))
                films.push_back({pair.first, pair.second, 0.5 * (matrix + matrix.transpose())});
        return films;
    }

private:
    void add_row(PairRow<D>& row, int solid, bool first, const Twist<D>& part) const
    {
        if (coupling_.free_body[solid] >= 0)
            row.template segment<twist_size<D>>(first ? 0 : twist_size<D>) += coupling_.solids[solid].admissible * part;
    }

    const Coupling<D>& coupling_;
    std::map<std::pair<int, int>, PairMatrix<D>> sums_;
};

// Of a film, with a small shift on the diagonal; rows without entries become those of the identity.
Eigen::SparseMatrix<double> matrix_of(const std::vector<Eigen::Triplet<double>>& entries, long count)
{
    Eigen::SparseMatrix<double> L(count, count);
    L.setFromTriplets(entries.begin(), entries.end());
    const double largest = L.diagonal().size() > 0 ? L.diagonal().maxCoeff() : 0.0;
    for (long i = 0; i < count; ++i)
        L.coeffRef(i, i) += L.coeff(i, i) > 0 ? shift * largest : 1.0;
    return L;
}

// Film by film K^T L^-1 K with the pressure 0 in all cells and in other films.
template <int D>
void add_pressure(const Coupling<D>& coupling, const std::vector<char>& is_void, Pairs<D>& pairs)
{
    constexpr int n = twist_size<D>;
    const CoupledSystem<D>& system = coupling.system;
    const std::vector<Film<D>>& films = coupling.network.films;
    std::vector<int> film_of(system.nodes, -1);
    for (std::size_t f = 0; f < films.size(); ++f) {
        const auto count = static_cast<int>(films[f].mesh.h.size());
        if (films[f].here && count <= most_nodes && films[f].pair.master != films[f].pair.other)
            std::fill_n(film_of.begin() + films[f].first_node, count, static_cast<int>(f));
    }
    auto counts = [&](int node) { return film_of[node] >= 0 && (is_void.empty() || !is_void[node]); };
    auto local = [&](int node) { return node - films[film_of[node]].first_node; };

    std::vector<std::vector<Eigen::Triplet<double>>> entries(films.size());
    for (int column = 0; column < system.film.outerSize(); ++column)
        if (counts(column))
            for (Eigen::SparseMatrix<double>::InnerIterator entry(system.film, column); entry; ++entry)
                if (const auto row = static_cast<int>(entry.row()); counts(row) && film_of[row] == film_of[column])
                    entries[film_of[column]].emplace_back(local(row), local(column), entry.value());
    for (const Link& link : system.links)
        for (const auto& [i, wi] : link.nodes)
            for (const auto& [j, wj] : link.nodes)
                if (counts(i) && counts(j) && film_of[i] == film_of[j])
                    entries[film_of[i]].emplace_back(local(i), local(j), link.conductance * wi * wj);
    std::vector<int> solid_of(system.bodies);
    for (std::size_t s = 0; s < coupling.solids.size(); ++s)
        if (coupling.free_body[s] >= 0)
            solid_of[coupling.free_body[s]] = static_cast<int>(s);
    std::vector<Eigen::Matrix<double, Eigen::Dynamic, 2 * n>> flux(films.size());
    for (const auto& entry : system.node_flux) {
        if (!counts(entry.row))
            continue;
        const int f = film_of[entry.row], solid = solid_of[entry.body];
        const FilmPair<D>& pair = films[f].pair;
        if (solid != pair.master && solid != pair.other)
            continue;
        if (flux[f].size() == 0)
            flux[f].setZero(static_cast<long>(films[f].mesh.h.size()), 2 * n);
        const int first = solid == std::min(pair.master, pair.other) ? 0 : n;
        flux[f].row(local(entry.row)).template segment<n>(first) += entry.flux.transpose();
    }
    std::vector<Eigen::MatrixXd> pressure(films.size()); // L^-1 K
    for_each_job(static_cast<int>(films.size()), [&](int f) {
        if (flux[f].size() == 0)
            return;
        const Eigen::SparseMatrix<double> L = matrix_of(entries[f], flux[f].rows());
        SparseCholesky factor;
        if (factor.compute(L))
            pressure[f] = factor.solve_columns(flux[f]);
    });
    for (std::size_t f = 0; f < films.size(); ++f)
        if (pressure[f].size() > 0)
            pairs.of(films[f].pair.master, films[f].pair.other) += flux[f].transpose() * pressure[f];
}

} // namespace

template <int D>
NearInertia<D> near_inertia(const Coupling<D>& coupling, const std::vector<TwistMatrix<D>>& mass,
                            const std::vector<char>& is_void)
{
    NearInertia<D> inertia;
    inertia.mobility.assign(coupling.solids.size(), TwistMatrix<D>::Zero());
    for (std::size_t s = 0; s < coupling.solids.size(); ++s)
        if (coupling.free_body[s] >= 0) {
            const TwistMatrix<D>& P = coupling.solids[s].admissible;
            inertia.mobility[s] = P * admissible_mass<D>(P, mass[s], mass[s](0, 0)).inverse() * P;
        }
    Pairs<D> pairs(coupling);
    for (const NormalInertia<D>& film : coupling.normal_inertia)
        pairs.add(film);
    for (const DragInertia<D>& drag : coupling.drag_inertia)
        pairs.add(drag.inertia);
    add_pressure(coupling, is_void, pairs);
    inertia.films = pairs.list();
    return inertia;
}

template NearInertia<2> near_inertia(const Coupling<2>&, const std::vector<TwistMatrix<2>>&, const std::vector<char>&);
template NearInertia<3> near_inertia(const Coupling<3>&, const std::vector<TwistMatrix<3>>&, const std::vector<char>&);

} // namespace gapflow
