#include "gapflow/coupling/wet_system.hpp"

#include "gapflow/coupling/film_drag.hpp"
#include "gapflow/coupling/film_rows.hpp"

#include <algorithm>

namespace gapflow {

namespace {

// A shut mouth keeps this part of its conductance, so that the pressure level of a pocket stays determined.
constexpr double shut_share = 1e-6;

} // namespace

template <int D>
WetSystem<D>::WetSystem(Coupling<D>& coupling)
    : coupling_(coupling),
      is_void_(coupling.system.nodes, 0), b_{CellField<D>(*coupling.grid), Eigen::VectorXd::Zero(coupling.system.nodes)},
      film_(coupling.system.film), links_(coupling.system.links),
      node_flux_(coupling.system.node_flux), entries_{coupling.cell_flux.size(), coupling.node_flux.size(),
                                                      coupling.system.cell_flux.size(), node_flux_.size()},
      components_(coupling.system.components), null_space_(coupling.system.null_space)
{
    for (const Link& link : links_)
        open_conductance_.push_back(link.conductance);
}

template <int D>
WetSystem<D>::~WetSystem()
{
    CoupledSystem<D>& system = coupling_.system;
    system.film = std::move(film_);
    system.links = std::move(links_);
    system.node_flux = std::move(node_flux_);
    system.components = std::move(components_);
    system.null_space = std::move(null_space_);
}

template <int D>
void WetSystem<D>::take_out(const std::vector<char>& is_void, const Eigen::VectorXd& b, const std::vector<char>& shut)
{
    is_void_ = is_void;
    b_.nodes = b;
    for (std::size_t r = 0; r < shut.size(); ++r)
        links_[r].conductance = (shut[r] ? shut_share : 1.0) * open_conductance_[r];
    close(shut);
    CoupledSystem<D>& system = coupling_.system;
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < film_.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(film_, column); entry; ++entry)
            if (!is_void[entry.row()] && !is_void[column])
                entries.emplace_back(static_cast<int>(entry.row()), column, entry.value());
    for (int node = 0; node < system.nodes; ++node)
        if (is_void[node] && system.owns(node)) // any number: the row has no other entry, and its right-hand side is 0
            entries.emplace_back(node, node, 1.0);
    system.film.setFromTriplets(entries.begin(), entries.end());

    system.links = links_;
    for (Link& link : system.links)
        std::erase_if(link.nodes, [&](const auto& node) { return is_void[node.first]; });
    system.node_flux.clear();
    std::copy_if(node_flux_.begin(), node_flux_.end(), std::back_inserter(system.node_flux),
                 [&](const BodyFlux<D, int>& entry) { return !is_void[entry.row]; });

    // The pressure level of a component with a void is determined by the void.
    system.components = components_;
    for (int node = 0; node < system.nodes; ++node)
        if (is_void[node])
            system.components[system.node_component[node]].grounded = true;
    find_null_space(coupling_);
}

// Takes the shut mouths out of K.
template <int D>
void WetSystem<D>::close(const std::vector<char>& shut)
{
    CoupledSystem<D>& system = coupling_.system;
    coupling_.cell_flux.resize(entries_[0]);
    coupling_.node_flux.resize(entries_[1]);
    system.cell_flux.resize(entries_[2]);
    node_flux_.resize(entries_[3]);
    FluxRows<D> rows(system);
    for (std::size_t r = 0; r < shut.size(); ++r)
        if (shut[r])
            add_mouth(coupling_, r, -1.0, rows);
    append_rows(coupling_, rows, node_flux_);
}

template <int D>
void WetSystem<D>::add_void_impulse(std::vector<Twist<D>>& twists, Eigen::VectorXd& contact_impulse) const
{
    add_pressure_impulse(coupling_, b_, twists, contact_impulse);
}

template <int D>
void WetSystem<D>::reduce(const std::vector<Twist<D>>& twists, const Eigen::VectorXd& filling, UnknownVector<D>& rhs)
{
    const Grid<D>& grid = *coupling_.grid;
    star_twists_ = twists;
    star_outflow_ = -rhs.nodes;
    const UnknownVector<D> driven = film_outflow(b_);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) { rhs.cells(c) -= driven.cells(c); });
    for (int node = 0; node < coupling_.system.nodes; ++node)
        rhs.nodes[node] = is_void_[node] ? 0.0 : rhs.nodes[node] - driven.nodes[node] - filling[node];
}

template <int D>
typename WetSystem<D>::Outcome WetSystem<D>::outcome(const UnknownVector<D>& p, const std::vector<Twist<D>>& twists) const
{
    UnknownVector<D> all = p;
    all.nodes += b_.nodes;
    Outcome outcome;
    const Communicator& comm = coupling_.grid->comm();
    outcome.outflow = star_outflow_ + film_outflow(all, &outcome.drop).nodes;
    if (!comm.root()) // each rank adds its nodes' part
        outcome.outflow.setZero();
    for (const auto& entry : coupling_.node_flux)
        outcome.outflow[entry.row] += entry.flux.dot(twists[entry.body] - star_twists_[entry.body]);
    comm.sum(std::span<double>(outcome.outflow.data(), outcome.outflow.size()));
    return outcome;
}

// L p of films and links, voids included: of every film node, and of the cells of links.
template <int D>
UnknownVector<D> WetSystem<D>::film_outflow(const UnknownVector<D>& p, std::vector<double>* drop) const
{
    const Grid<D>& grid = *coupling_.grid;
    UnknownVector<D> out{CellField<D>(grid), Eigen::VectorXd::Zero(coupling_.system.nodes)};
    for (const Film<D>& film : coupling_.network.films)
        for (std::size_t e = 0; film.here && e < film.mesh.elements.size(); ++e) {
            const FilmElement<D>& element = film.mesh.elements[e];
            Vec<D> gradient = Vec<D>::Zero();
            for (int i = 0; i < D; ++i)
                gradient += p.nodes[film.first_node + element.nodes[i]] * element.gradient[i];
            const double conductance = film_conductance(coupling_, film, e) / coupling_.density;
            for (int i = 0; i < D; ++i)
                out.nodes[film.first_node + element.nodes[i]] += conductance * element.gradient[i].dot(gradient);
        }
    std::vector<double> sums(links_.size(), 0.0);
    for (std::size_t r = 0; r < links_.size(); ++r)
        for (const auto& [key, weight] : links_[r].cells)
            if (const Index<D> c = grid.cell_of_key(key); grid.owns(c))
                sums[r] += weight * p.cells(c);
    grid.comm().sum(sums);
    for (std::size_t r = 0; r < links_.size(); ++r) {
        const Link& link = links_[r];
        for (const auto& [node, weight] : link.nodes)
            sums[r] += weight * p.nodes[node];
        const double flux = link.conductance * sums[r];
        for (const auto& [node, weight] : link.nodes)
            if (coupling_.system.owns(node))
                out.nodes[node] += weight * flux;
        for (const auto& [key, weight] : link.cells)
            if (const Index<D> c = grid.cell_of_key(key); grid.owns(c))
                out.cells(c) += weight * flux;
    }
    grid.comm().sum(std::span<double>(out.nodes.data(), out.nodes.size()));
    if (drop)
        drop->assign(sums.begin(), sums.begin() + static_cast<long>(coupling_.network.rim.mouths.size()));
    return out;
}

template class WetSystem<2>;
template class WetSystem<3>;

} // namespace gapflow
