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
#include "gapflow/core/sharing.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/solver/film_edges.hpp"
#include "gapflow/solver/weak_films.hpp"

#include <algorithm>
#include <iterator>

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
    const Communicator& comm = system.grid->comm();
    std::vector<Film> own = connected_nodes();
    long inner = 0;
    for (const Film& film : own)
        inner += film.rim.empty() ? 0 : static_cast<long>(film.inner.size());
    if (!system.own_node.empty())
        inner = comm.sum(inner);
    const bool worth =
        static_cast<double>(inner) >= worthwhile * static_cast<double>(system.grid->cells().template cast<long>().prod());
    reduces_ = system.nodes > 0 && (worth || !system.own_node.empty());
    if (!reduces_)
        return;
    const int count = static_cast<int>(own.size());
    std::vector<int> film_of(system.nodes);
    for (int f = 0; f < count; ++f)
        for (const std::vector<int>* nodes : {&own[f].inner, &own[f].rim})
            for (int i : *nodes)
                film_of[i] = f;
    std::vector<std::vector<long>> fluxes(count); // entries of K
    for (std::size_t e = 0; e < system.node_flux.size(); ++e)
        fluxes[film_of[system.node_flux[e].row]].push_back(static_cast<long>(e));
    int weak = 0;
    const std::vector<int> weak_film = weak_films(system, weak);
    std::vector<Remainder> left(count);
    for_each_job(count, [&](int f) {
        left[f].condensed =
            worth && !own[f].inner.empty() && weak_film[own[f].inner.front()] < 0 && condense(own[f], fluxes[f], left[f]);
        if (!left[f].condensed)
            left[f] = whole(own[f], fluxes[f]);
    });
    for (int f = 0; f < count; ++f)
        if (left[f].condensed)
            films_.push_back(std::move(own[f]));
    if (system.own_node.empty()) {
        reduces_ = !films_.empty();
        if (reduces_)
            assemble(left);
    } else {
        assemble(of_all_ranks(std::move(left)));
    }
    if (reduces_)
        update_bodies();
}

// In the order of their first nodes.
template <int D>
std::vector<typename FilmCondensation<D>::Remainder> FilmCondensation<D>::of_all_ranks(std::vector<Remainder> left) const
{
    std::vector<int> at(system_.nodes, -1); // by the first node
    for (std::size_t f = 0; f < left.size(); ++f)
        at[left[f].nodes.front()] = static_cast<int>(f);
    const std::size_t own = left.size();
    exchange_items(
        system_.grid->comm(), at.size(), [&](std::size_t i) { return at[i] >= 0 && at[i] < static_cast<int>(own); },
        [&](ByteWriter& out, std::size_t i) { left[at[i]].each_field(out); },
        [&](ByteReader& in, std::size_t i) {
            at[i] = static_cast<int>(left.size());
            left.emplace_back().each_field(in);
        });
    std::sort(left.begin(), left.end(),
              [](const Remainder& a, const Remainder& b) { return a.nodes.front() < b.nodes.front(); });
    return left;
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
        if (system_.owns(i))
            (linked[i] ? films[set[i]].rim : films[set[i]].inner).push_back(i);
    std::erase_if(films, [](const Film& film) { return film.inner.empty() && film.rim.empty(); });
    return films;
}

template <int D>
bool FilmCondensation<D>::condense(Film& film, const std::vector<long>& fluxes, Remainder& left) const
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
    const Eigen::MatrixXd rim_fluid = fluid.bottomRightCorner(outer, outer) + film.to_rim.transpose() * film.levels;

    for (long e : fluxes)
        film.bodies.push_back(system_.node_flux[e].body);
    std::sort(film.bodies.begin(), film.bodies.end());
    film.bodies.erase(std::unique(film.bodies.begin(), film.bodies.end()), film.bodies.end());
    const long bodies = static_cast<long>(film.bodies.size());
    Eigen::MatrixXd flux = Eigen::MatrixXd::Zero(inner + outer, n * bodies);
    for (long e : fluxes) {
        const BodyFlux<D, int>& entry = system_.node_flux[e];
        const long b = std::lower_bound(film.bodies.begin(), film.bodies.end(), entry.body) - film.bodies.begin();
        flux.row(place(entry.row)).template segment<n>(n * b) += entry.flux.transpose();
    }
    film.flux = flux.topRows(inner);
    const Eigen::MatrixXd rim_flux = flux.bottomRows(outer) + film.levels.transpose() * film.flux;
    const Eigen::MatrixXd mass = film.flux.transpose() * film.factor.solve(film.flux);
    const auto dof = [&](long k) { return n * film.bodies[k / n] + static_cast<int>(k % n); };
    for (long k = 0; k < n * bodies; ++k)
        if (mass(k, k) > heaviest * system_.mass.coeff(dof(k), dof(k)))
            return false;

    left.nodes = film.rim;
    left.fluid.reserve(outer * outer);
    for (long j = 0; j < outer; ++j) {
        double sum = 0;
        for (long i = 0; i < outer; ++i)
            if (i != j) {
                const double value = 0.5 * (rim_fluid(i, j) + rim_fluid(j, i));
                left.fluid.emplace_back(film.rim[i], film.rim[j], value);
                sum += value;
            }
        left.fluid.emplace_back(film.rim[j], film.rim[j], -sum);
        for (long b = 0; b < bodies; ++b)
            left.flux.push_back({film.rim[j], film.bodies[b], rim_flux.row(j).template segment<n>(n * b).transpose()});
    }
    for (long j = 0; j < n * bodies; ++j)
        for (long i = 0; i < n * bodies; ++i)
            left.mass.emplace_back(dof(i), dof(j), 0.5 * (mass(i, j) + mass(j, i)));
    return true;
}

template <int D>
typename FilmCondensation<D>::Remainder FilmCondensation<D>::whole(const Film& film, const std::vector<long>& fluxes) const
{
    Remainder left;
    std::merge(film.inner.begin(), film.inner.end(), film.rim.begin(), film.rim.end(), std::back_inserter(left.nodes));
    for (int node : left.nodes)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(system_.film, node); entry; ++entry)
            left.fluid.emplace_back(static_cast<int>(entry.row()), node, entry.value());
    for (long e : fluxes)
        left.flux.push_back(system_.node_flux[e]);
    return left;
}

template <int D>
void FilmCondensation<D>::assemble(const std::vector<Remainder>& films)
{
    number_.assign(system_.nodes, -1);
    for (const Remainder& film : films)
        for (int i : film.nodes)
            number_[i] = 0;
    int nodes = 0;
    std::size_t entries = 0;
    for (int& number : number_)
        number = number < 0 ? -1 : nodes++;
    for (const Remainder& film : films)
        entries += film.fluid.size();
    reduced_ = system_;
    reduced_.nodes = nodes;
    reduced_.own_node.clear();
    reduced_.node_flux.clear();
    std::vector<Entry> fluid, mass;
    fluid.reserve(entries);
    for (const bool condensed : {true, false})
        for (const Remainder& film : films) {
            if (film.condensed != condensed)
                continue;
            for (const Entry& entry : film.fluid)
                fluid.emplace_back(number_[entry.row()], number_[entry.col()], entry.value());
            for (const BodyFlux<D, int>& entry : film.flux)
                reduced_.node_flux.push_back({number_[entry.row], entry.body, entry.flux});
            mass.insert(mass.end(), film.mass.begin(), film.mass.end());
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
    const Communicator& comm = system_.grid->comm();
    const bool shared = !system_.own_node.empty(); // each rank adds its films' part
    Reduced result{kept(rhs), Eigen::VectorXd::Zero(system_.mass.rows())};
    if (shared && !comm.root())
        result.nodes.setZero();
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
    if (shared) {
        comm.sum(std::span<double>(result.nodes.data(), result.nodes.size()));
        comm.sum(std::span<double>(result.wrench.data(), result.wrench.size()));
    }
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
    for_each_job(static_cast<int>(films_.size()), [&](int f) {
        const Film& film = films_[f];
        Eigen::VectorXd rim(film.rim.size());
        for (std::size_t k = 0; k < film.rim.size(); ++k)
            rim[static_cast<long>(k)] = nodes[number_[film.rim[k]]];
        const Eigen::VectorXd own = rhs(film.inner);
        const Eigen::VectorXd inner = film.factor.solve(own - film.to_rim * rim - film.flux * of_bodies(film, twist));
        all(film.inner) = inner;
    });
    if (!system_.own_node.empty())
        system_.grid->comm().sum(std::span<double>(all.data(), all.size()));
    for (int i = 0; i < system_.nodes; ++i)
        if (number_[i] >= 0)
            all[i] = nodes[number_[i]];
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
