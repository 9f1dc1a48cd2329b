// With i the nodes of a film that no link enters, r the others, and w = M^-1 K^T p the bodies' response, L p + K w = b is
//
//     L_ii p_i + L_ir p_r + K_i w = b_i.
//
// Eliminated, with H = -L_ii^-1 L_ir:
//
//     (L_rr + L_ri H) p_r + (K_r + H^T K_i) w = b_r + H^T b_i,
//     (M + K_i^T L_ii^-1 K_i) w = (K_r + H^T K_i)^T p_r + K_i^T L_ii^-1 b_i:
//
// a system of the same kind (method, "The coupled system"). Contacts enter as before. A constant pressure drives no flow in it: rows of H sum to one, and the
// diagonal of L_rr + L_ri H is the negative sum of the others.

#include "gapflow/solver/film_condensation.hpp"

#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/solver/film_edges.hpp"
#include "gapflow/solver/weak_films.hpp"

#include <algorithm>

namespace gapflow {

namespace {

// The dense factor of a larger film takes longer than it saves.
constexpr std::size_t most_inner_nodes = 400, most_rim_nodes = 200;
// Added mass over the body's own up to which a film is condensed. Of heavier ones the sum of both masses loses the body's own to round-off: residuals of
// 1e-9 need seven digits more than this.
constexpr double heaviest = 1e3;
// The reduced system holds a copy of the grid's part, some 30 bytes a cell. Eliminated nodes over cells from which it is worth that.
constexpr double worthwhile = 0.002;
constexpr double constant = 1e-6; // what rows of H may sum to besides 1: a film that is nearly cut in two

} // namespace

template <int D>
FilmCondensation<D>::FilmCondensation(const CoupledSystem<D>& system) : system_(system)
{
    std::vector<Film> all = connected_nodes();
    std::size_t inner = 0;
    for (const Film& film : all)
        inner += film.rim.empty() ? 0 : film.inner.size();
    if (static_cast<double>(inner) < worthwhile * static_cast<double>(system.grid->cells().template cast<long>().prod()))
        return;
    const int count = static_cast<int>(all.size());
    std::vector<int> film_of(system.nodes);
    for (int f = 0; f < count; ++f)
        for (const std::vector<int>* nodes : {&all[f].inner, &all[f].rim})
            for (int i : *nodes)
                film_of[i] = f;
    std::vector<std::vector<long>> fluxes(count); // entries of K
    for (std::size_t e = 0; e < system.node_flux.size(); ++e)
        fluxes[film_of[system.node_flux[e].row]].push_back(static_cast<long>(e));
    int weak = 0;
    const std::vector<int> weak_film = weak_films(system, weak);
    std::vector<char> condensed(count, 0);
    std::vector<Rim> rims(count);
    for_each_job(count, [&](int f) {
        condensed[f] = !all[f].inner.empty() && weak_film[all[f].inner.front()] < 0 && condense(all[f], fluxes[f], rims[f]);
    });

    std::vector<Rim> used;
    std::vector<long> other_fluxes;
    number_.assign(system.nodes, 0);
    for (int f = 0; f < count; ++f) {
        if (!condensed[f]) {
            other_fluxes.insert(other_fluxes.end(), fluxes[f].begin(), fluxes[f].end());
            continue;
        }
        for (int i : all[f].inner)
            number_[i] = -1;
        films_.push_back(std::move(all[f]));
        used.push_back(std::move(rims[f]));
    }
    if (empty())
        return;
    int left = 0;
    for (int& number : number_)
        number = number < 0 ? -1 : left++;
    reduced_ = system;
    reduced_.nodes = left;
    assemble(used, other_fluxes);
    update_bodies();
}

template <int D>
std::vector<typename FilmCondensation<D>::Film> FilmCondensation<D>::connected_nodes() const
{
    std::vector<char> linked(system_.nodes, 0);
    for (const Link& link : system_.links)
        for (const auto& entry : link.nodes)
            linked[entry.first] = 1;
    DisjointSets sets(system_.nodes);
    for_each_film_edge(system_.film, [&](int i, int j, double conductance) {
        if (conductance != 0)
            sets.join(i, j);
    });
    int count = 0;
    const std::vector<int> set = sets.numbers(count);
    std::vector<Film> films(count);
    for (int i = 0; i < system_.nodes; ++i)
        (linked[i] ? films[set[i]].rim : films[set[i]].inner).push_back(i);
    return films;
}

template <int D>
bool FilmCondensation<D>::condense(Film& film, const std::vector<long>& fluxes, Rim& rim) const
{
    constexpr int n = twist_size<D>;
    const long inner = static_cast<long>(film.inner.size()), outer = static_cast<long>(film.rim.size());
    if (inner == 0 || outer == 0 || film.inner.size() > most_inner_nodes || film.rim.size() > most_rim_nodes)
        return false;
    // Where a node stands among the inner ones, or behind them in the rim; both lists ascend.
    const auto place = [&](int node) {
        const auto found = std::lower_bound(film.inner.begin(), film.inner.end(), node);
        return found != film.inner.end() && *found == node
                   ? found - film.inner.begin()
                   : inner + (std::lower_bound(film.rim.begin(), film.rim.end(), node) - film.rim.begin());
    };
    Eigen::MatrixXd fluid = Eigen::MatrixXd::Zero(inner + outer, inner + outer);
    for (const std::vector<int>* nodes : {&film.inner, &film.rim})
        for (int node : *nodes)
            for (Eigen::SparseMatrix<double>::InnerIterator entry(system_.film, node); entry; ++entry)
                fluid(place(static_cast<int>(entry.row())), place(node)) = entry.value();
    const Eigen::VectorXd ground = fluid.rowwise().sum();
    if ((ground.array().abs() > 1e-12 * fluid.diagonal().array()).any())
        return false; // beside voids
    film.factor.compute(fluid.topLeftCorner(inner, inner));
    if (film.factor.info() != Eigen::Success)
        return false;
    film.to_rim = fluid.topRightCorner(inner, outer);
    film.levels = -film.factor.solve(film.to_rim);
    const Eigen::VectorXd sums = film.levels.rowwise().sum();
    if (!((sums.array() - 1).abs() < constant).all())
        return false;
    film.levels = sums.cwiseInverse().asDiagonal() * film.levels;
    rim.fluid = fluid.bottomRightCorner(outer, outer) + film.to_rim.transpose() * film.levels;

    for (long e : fluxes)
        film.bodies.push_back(system_.node_flux[e].body);
    std::sort(film.bodies.begin(), film.bodies.end());
    film.bodies.erase(std::unique(film.bodies.begin(), film.bodies.end()), film.bodies.end());
    Eigen::MatrixXd flux = Eigen::MatrixXd::Zero(inner + outer, n * static_cast<long>(film.bodies.size()));
    for (long e : fluxes) {
        const BodyFlux<D, int>& entry = system_.node_flux[e];
        const long b = std::lower_bound(film.bodies.begin(), film.bodies.end(), entry.body) - film.bodies.begin();
        flux.row(place(entry.row)).template segment<n>(n * b) += entry.flux.transpose();
    }
    film.flux = flux.topRows(inner);
    rim.flux = flux.bottomRows(outer) + film.levels.transpose() * film.flux;
    rim.mass = film.flux.transpose() * film.factor.solve(film.flux);
    for (std::size_t b = 0; b < film.bodies.size(); ++b)
        for (long k = 0; k < n; ++k) {
            const long own = n * film.bodies[b] + k, here = n * static_cast<long>(b) + k;
            if (rim.mass(here, here) > heaviest * system_.mass.coeff(own, own))
                return false;
        }
    return true;
}

template <int D>
void FilmCondensation<D>::assemble(const std::vector<Rim>& rims, const std::vector<long>& other_fluxes)
{
    constexpr int n = twist_size<D>;
    std::vector<Eigen::Triplet<double>> fluid, mass;
    std::vector<char> replaced(system_.nodes, 0);
    reduced_.node_flux.clear();
    for (std::size_t f = 0; f < films_.size(); ++f) {
        const Film& film = films_[f];
        const Rim& rim = rims[f];
        const long nodes = static_cast<long>(film.rim.size()), bodies = static_cast<long>(film.bodies.size());
        for (int i : film.rim)
            replaced[i] = 1;
        for (long j = 0; j < nodes; ++j) {
            const int row = number_[film.rim[j]];
            double sum = 0;
            for (long i = 0; i < nodes; ++i)
                if (i != j) {
                    const double value = 0.5 * (rim.fluid(i, j) + rim.fluid(j, i));
                    fluid.emplace_back(number_[film.rim[i]], row, value);
                    sum += value;
                }
            fluid.emplace_back(row, row, -sum);
            for (long b = 0; b < bodies; ++b)
                reduced_.node_flux.push_back({row, film.bodies[b], rim.flux.row(j).template segment<n>(n * b).transpose()});
        }
        for (long j = 0; j < n * bodies; ++j)
            for (long i = 0; i < n * bodies; ++i)
                mass.emplace_back(n * film.bodies[i / n] + static_cast<int>(i % n),
                                  n * film.bodies[j / n] + static_cast<int>(j % n), 0.5 * (rim.mass(i, j) + rim.mass(j, i)));
    }
    for (int j = 0; j < system_.nodes; ++j)
        if (number_[j] >= 0 && !replaced[j])
            for (Eigen::SparseMatrix<double>::InnerIterator entry(system_.film, j); entry; ++entry)
                fluid.emplace_back(number_[entry.row()], number_[j], entry.value());
    for (long e : other_fluxes) {
        const BodyFlux<D, int>& entry = system_.node_flux[e];
        reduced_.node_flux.push_back({number_[entry.row], entry.body, entry.flux});
    }
    reduced_.film.resize(reduced_.nodes, reduced_.nodes);
    reduced_.film.setFromTriplets(fluid.begin(), fluid.end());
    added_.resize(system_.mass.rows(), system_.mass.cols());
    added_.setFromTriplets(mass.begin(), mass.end());
    for (Link& link : reduced_.links)
        for (auto& entry : link.nodes)
            entry.first = number_[entry.first];
    reduced_.node_component.resize(reduced_.nodes);
    for (int i = 0; i < system_.nodes; ++i)
        if (number_[i] >= 0)
            reduced_.node_component[number_[i]] = system_.node_component[i];
}

template <int D>
void FilmCondensation<D>::update_bodies()
{
    if (empty() || system_.bodies == 0)
        return;
    reduced_.mass = system_.mass + added_;
    reduced_.contact = system_.contact;
    reduced_.contact_resistance = system_.contact_resistance;
    const BodyResponse own =
        system_.response.ready() ? system_.response : BodyResponse(system_.mass, system_.contact, system_.contact_resistance);
    reduced_.response = own.of_mass(reduced_.mass);
}

template <int D>
Eigen::VectorXd FilmCondensation<D>::kept(const Eigen::VectorXd& nodes) const
{
    Eigen::VectorXd result(reduced_.nodes);
    for (int i = 0; i < system_.nodes; ++i)
        if (number_[i] >= 0)
            result[number_[i]] = nodes[i];
    return result;
}

template <int D>
typename FilmCondensation<D>::Reduced FilmCondensation<D>::reduce(const Eigen::VectorXd& rhs) const
{
    Reduced result{kept(rhs), Eigen::VectorXd::Zero(system_.mass.rows())};
    std::vector<Eigen::VectorXd> wrench(films_.size());
    for_each_job(static_cast<int>(films_.size()), [&](int f) {
        const Film& film = films_[f];
        const Eigen::VectorXd inner = rhs(film.inner), rim = film.levels.transpose() * inner;
        for (std::size_t k = 0; k < film.rim.size(); ++k)
            result.nodes[number_[film.rim[k]]] += rim[static_cast<long>(k)];
        wrench[f] = film.flux.transpose() * film.factor.solve(inner);
    });
    for (std::size_t f = 0; f < films_.size(); ++f)
        for (std::size_t b = 0; b < films_[f].bodies.size(); ++b)
            result.wrench.template segment<twist_size<D>>(twist_size<D> * films_[f].bodies[b]) +=
                wrench[f].template segment<twist_size<D>>(twist_size<D> * static_cast<long>(b));
    return result;
}

template <int D>
Eigen::VectorXd FilmCondensation<D>::of_bodies(const Film& film, const Eigen::VectorXd& twists) const
{
    Eigen::VectorXd own(film.flux.cols());
    for (std::size_t b = 0; b < film.bodies.size(); ++b)
        own.segment<twist_size<D>>(twist_size<D> * static_cast<long>(b)) =
            twists.segment<twist_size<D>>(twist_size<D> * film.bodies[b]);
    return own;
}

template <int D>
Eigen::VectorXd FilmCondensation<D>::expand(const Eigen::VectorXd& rhs, const Eigen::VectorXd& nodes,
                                            const Eigen::VectorXd& twist) const
{
    Eigen::VectorXd all = Eigen::VectorXd::Zero(system_.nodes);
    for (int i = 0; i < system_.nodes; ++i)
        if (number_[i] >= 0)
            all[i] = nodes[number_[i]];
    for_each_job(static_cast<int>(films_.size()), [&](int f) {
        const Film& film = films_[f];
        const Eigen::VectorXd rim = all(film.rim), own = rhs(film.inner);
        const Eigen::VectorXd inner = film.factor.solve(own - film.to_rim * rim - film.flux * of_bodies(film, twist));
        all(film.inner) = inner;
    });
    return all;
}

template <int D>
long FilmCondensation<D>::bytes() const
{
    long numbers = 0;
    for (const Film& film : films_)
        numbers += film.factor.matrixLLT().size() + film.to_rim.size() + film.levels.size() + film.flux.size();
    return empty() ? 0 : 8 * numbers + 12 * reduced_.film.nonZeros();
}

template class FilmCondensation<2>;
template class FilmCondensation<3>;

} // namespace gapflow
