// Connected components of the unknowns and the null space of the coupled system (method, "The coupled system"):
//
// 1_k is the constant on component k that no open side touches. The null space of L + K M^-1 K^T is every combination
// sum c_k 1_k with K^T sum c_k 1_k = 0 on all free bodies: the kernel of a small matrix.
#include "gapflow/core/decompositions.hpp"
#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/core/sharing.hpp"
#include "gapflow/coupling/fluid_parts.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace gapflow {

namespace {

constexpr int chunk = 64; // cells of a row that are labelled at once where nothing closes a face

// Labels n cells of a row from `first` on if all are open to each other and to the cells before them, which have one label.
template <int D>
bool label_if_joined(const Coupling<D>& coupling, CellField<D, int>& label, const Index<D>& first, int n)
{
    const Grid<D>& grid = *coupling.grid;
    if ((first.array() == grid.low().array()).any())
        return false;
    const Block<D>& block = label.block();
    const long at = block.offset(first);
    int* mine = label.data() + at;
    const int wanted = mine[-1];
    if (wanted < 0)
        return false;
    const std::int8_t* kind = coupling.kind.data() + at;
    int others = 0;
    for (int i = 0; i < n; ++i)
        others |= kind[i] != static_cast<std::int8_t>(CellKind::bulk);
    for (int axis = 0; axis < D; ++axis) {
        const double* a = coupling.system.conductance[axis].data() + at;
        for (int i = 0; i < n; ++i)
            others |= !(a[i] > 0);
        for (int i = 0; i < n && axis > 0; ++i)
            others |= mine[i - block.stride[axis]] ^ wanted;
    }
    if (others)
        return false;
    std::fill_n(mine, n, wanted);
    return true;
}

// Components of this rank's block alone: one pass in memory order. Returns their number.
template <int D>
int label_block(const Coupling<D>& coupling, CellField<D, int>& label)
{
    const Grid<D>& grid = *coupling.grid;
    const FaceField<D>& conductance = coupling.system.conductance;
    const Block<D>& block = label.block();
    DisjointSets sets;
    auto visit = [&](const Index<D>& c) {
        const auto kind = static_cast<CellKind>(coupling.kind(c));
        if (kind != CellKind::bulk && kind != CellKind::mixed)
            return;
        const long at = block.offset(c);
        int mine = -1;
        for (int axis = 0; axis < D; ++axis) {
            if (c[axis] == grid.low()[axis] || conductance[axis].data()[at] <= 0)
                continue;
            const int other = label.data()[at - block.stride[axis]];
            if (mine < 0)
                mine = other;
            else if (other != mine)
                sets.join(mine, other);
        }
        label.data()[at] = mine < 0 ? sets.add() : mine;
    };
    const int width = grid.high()[0] - grid.low()[0];
    for_each_row<D>(grid.low(), grid.high(), [&](const Index<D>& row) {
        for (int begin = 0; begin < width; begin += chunk) {
            Index<D> c = row;
            c[0] += begin;
            const int n = std::min(chunk, width - begin);
            if (label_if_joined(coupling, label, c, n))
                continue;
            for (int i = 0; i < n; ++i, ++c[0])
                visit(c);
        }
    });
    int count = 0;
    const std::vector<int> number = sets.numbers(count);
    bool same = true;
    for (std::size_t l = 0; l < number.size(); ++l)
        same = same && number[l] == static_cast<int>(l);
    if (!same)
        for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
            int& l = label(c);
            if (l >= 0)
                l = number[l];
        });
    return count;
}

// Does the link join its nodes and cells? Not where a node of it is shut.
bool leads_on(const Link& link, const std::vector<char>& shut)
{
    return link.conductance > 0 && (shut.empty() || std::none_of(link.nodes.begin(), link.nodes.end(),
                                                                 [&](const auto& node) { return shut[node.first]; }));
}

// Labels all cells, each rank its own block's components, with numbers after those of lower ranks. Returns the number of labels.
template <int D>
int label_cells(const Coupling<D>& coupling, CellField<D, int>& label)
{
    const Grid<D>& grid = *coupling.grid;
    const Communicator& comm = grid.comm();
    const int mine = label_block(coupling, label);
    int start = 0;
    MPI_Exscan(&mine, &start, 1, MPI_INT, MPI_SUM, comm.mpi());
    if (comm.root())
        start = 0;
    const int labels = static_cast<int>(comm.sum(static_cast<long>(mine)));
    if (start > 0)
        for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
            if (label(c) >= 0)
                label(c) += start;
        });
    exchange(grid, label, 1);
    return labels;
}

// Pairs of labels joined across the lower sides of this rank's block.
template <int D>
std::set<std::pair<int, int>> pairs_across_sides(const Coupling<D>& coupling, const CellField<D, int>& label)
{
    const Grid<D>& grid = *coupling.grid;
    std::set<std::pair<int, int>> pairs;
    for (int axis = 0; axis < D; ++axis) {
        Index<D> high = grid.high();
        high[axis] = grid.low()[axis] + 1;
        for_each_index<D>(grid.low(), high, [&](const Index<D>& f) {
            const Index<D> below = f - step<D>(axis);
            if (coupling.system.conductance(axis, f) > 0 && label(f) >= 0 && label(below) >= 0)
                pairs.insert({label(below), label(f)});
        });
    }
    return pairs;
}

// Pairs of labels and nodes that links from this rank's cells join; nodes count after all cells' labels, links without a node after these.
template <int D>
std::set<std::pair<int, int>> pairs_of_links(const Coupling<D>& coupling, const std::vector<char>& shut,
                                             const CellField<D, int>& label, int labels)
{
    const Grid<D>& grid = *coupling.grid;
    std::set<std::pair<int, int>> pairs;
    int without_node = labels + coupling.system.nodes;
    for (const Link& link : coupling.system.links) {
        const int hub = link.nodes.empty() ? without_node++ : labels + link.nodes.front().first;
        if (!leads_on(link, shut))
            continue;
        int last = -1; // a link's cells mostly have the same label
        for (const auto& [key, weight] : link.cells)
            if (const Index<D> c = grid.cell_of_key(key); grid.owns(c) && label(c) >= 0 && label(c) != last) {
                last = label(c);
                pairs.insert({last, hub});
            }
    }
    return pairs;
}

// Pairs of nodes that the film matrices of all ranks join.
template <int D>
std::vector<std::array<int, 2>> edges_of_parts(const Coupling<D>& coupling)
{
    std::vector<std::array<int, 2>> own;
    for (int node = 0; node < coupling.system.film.outerSize(); ++node)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(coupling.system.film, node); entry; ++entry)
            if (entry.row() < node && entry.value() != 0)
                own.push_back({static_cast<int>(entry.row()), node});
    const Communicator& comm = coupling.grid->comm();
    return comm.size() == 1 ? own : all_values(comm, own);
}

// Joins film nodes by the films' elements and by links between films; nodes count after all cells' labels.
template <int D>
void join_nodes(const Coupling<D>& coupling, const std::vector<char>& shut, int labels, DisjointSets& sets)
{
    for (const Film<D>& film : coupling.network.films)
        for (const FilmElement<D>& e : film.mesh.elements)
            for (int i = 1; i < D && (shut.empty() || std::none_of(e.nodes.begin(), e.nodes.end(),
                                                                   [&](int node) { return shut[film.first_node + node]; }));
                 ++i)
                sets.join(labels + film.first_node + e.nodes[0], labels + film.first_node + e.nodes[i]);
    if (coupling.network.films.empty()) // parts
        for (const auto& [a, b] : edges_of_parts(coupling))
            sets.join(labels + a, labels + b);
    for (const Link& link : coupling.system.links)
        for (std::size_t i = 1; i < link.nodes.size() && leads_on(link, shut); ++i)
            sets.join(labels + link.nodes[0].first, labels + link.nodes[i].first);
}

// The component of each label and, after these, of each film node.
struct Numbering {
    int labels = 0, components = 0;
    std::vector<int> component;
    std::vector<int> grid_parts; ///< of each component: parts that the grid's faces alone join
};

template <int D>
Numbering join_labels(const Coupling<D>& coupling, const std::vector<char>& shut, const CellField<D, int>& label, int labels)
{
    const Communicator& comm = coupling.grid->comm();
    const auto& links = coupling.system.links;
    const long without_node = std::count_if(links.begin(), links.end(), [](const Link& link) { return link.nodes.empty(); });
    DisjointSets parts(labels), sets(labels + coupling.system.nodes + static_cast<int>(without_node));
    const auto across = pairs_across_sides(coupling, label), linked = pairs_of_links(coupling, shut, label, labels);
    for (const auto& [a, b] : all_values(comm, std::vector(across.begin(), across.end()))) {
        parts.join(a, b);
        sets.join(a, b);
    }
    for (const auto& [a, b] : all_values(comm, std::vector(linked.begin(), linked.end())))
        sets.join(a, b);
    join_nodes(coupling, shut, labels, sets);
    Numbering numbering;
    numbering.labels = labels;
    numbering.component = sets.numbers(numbering.components);
    numbering.grid_parts.assign(numbering.components, 0);
    int part_count = 0;
    const std::vector<int> part = parts.numbers(part_count);
    std::vector<char> counted(part_count, 0);
    for (int l = 0; l < labels; ++l)
        if (!counted[part[l]]) {
            counted[part[l]] = 1;
            ++numbering.grid_parts[numbering.component[l]];
        }
    return numbering;
}

// Turns the labels of this rank's cells into components; adds the numbers of cells to `facts`.
template <int D>
void number_cells(const Grid<D>& grid, const std::vector<int>& number, CellField<D, int>& label, std::vector<double>& facts)
{
    for_each_row<D>(grid.low(), grid.high(), [&](const Index<D>& row) {
        const int n = grid.high()[0] - grid.low()[0];
        int* l = &label(row);
        for (int i = 0, end; i < n; i = end) { // runs of one label
            end = i + 1;
            while (end < n && l[end] == l[i])
                ++end;
            if (l[i] < 0)
                continue;
            const int k = number[l[i]];
            std::fill(l + i, l + end, k);
            facts[2 * k] += end - i;
        }
    });
}

// Adds the numbers of this rank's faces on open sides to `facts`.
template <int D>
void count_open_faces(const Coupling<D>& coupling, const CellField<D, int>& component, std::vector<double>& facts)
{
    const Grid<D>& grid = *coupling.grid;
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2 && !grid.periodic(axis); ++end) {
            const int last = end * (grid.cells()[axis] - 1);
            if (last < grid.low()[axis] || last >= grid.high()[axis])
                continue;
            Index<D> low = grid.low(), high = grid.high();
            low[axis] = last;
            high[axis] = last + 1;
            for_each_index<D>(low, high, [&](const Index<D>& c) {
                if (const int k = component(c); k >= 0 && coupling.system.conductance(axis, c + end * step<D>(axis)) > 0)
                    ++facts[2 * k + 1];
            });
        }
}

// Turns the cells' labels into components, and counts the cells and ways out of each.
template <int D>
void number_parts(const Coupling<D>& coupling, const std::vector<char>& shut, const Numbering& numbering, FluidParts<D>& parts)
{
    const Grid<D>& grid = *coupling.grid;
    const CoupledSystem<D>& system = coupling.system;
    parts.components.assign(numbering.components, {});
    std::vector<double> facts(2 * static_cast<std::size_t>(numbering.components), 0.0); // unknowns; ways out by open sides
    number_cells(grid, numbering.component, parts.component, facts);
    count_open_faces(coupling, parts.component, facts);
    grid.comm().sum(facts);
    for (int k = 0; k < numbering.components; ++k)
        parts.components[k].open_faces = facts[2 * k + 1] > 0;
    exchange(grid, parts.component, 1);
    parts.node_component.resize(system.nodes);
    for (int node = 0; node < system.nodes; ++node) {
        parts.node_component[node] = numbering.component[numbering.labels + node];
        ++facts[2 * parts.node_component[node]];
    }
    const bool of_parts = coupling.network.films.empty();
    if (of_parts) {
        std::vector<double> ways(numbering.components, 0.0); // to open sides, of this rank's nodes
        for (int node = 0; node < system.film.outerSize(); ++node) {
            double sum = 0, size = 0;
            for (Eigen::SparseMatrix<double>::InnerIterator entry(system.film, node); entry; ++entry) {
                sum += entry.value();
                size += std::abs(entry.value());
            }
            ways[parts.node_component[node]] += sum > 1e-9 * size;
        }
        grid.comm().sum(ways);
        for (int k = 0; k < numbering.components; ++k)
            facts[2 * k + 1] += ways[k];
    }
    for (const Link& link : system.links)
        if (!of_parts && link.cells.empty() && leads_on(link, shut) && link.nodes.size() == D - 1) // mouth to an open side
            ++facts[2 * parts.node_component[link.nodes.front().first] + 1];
    for (int k = 0; k < numbering.components; ++k) {
        parts.components[k].grid_parts = numbering.grid_parts[k];
        parts.components[k].unknowns = std::lround(facts[2 * k]);
        parts.components[k].grounded = facts[2 * k + 1] > 0;
    }
}

// K^T 1_k of the free bodies, one column per component, and the size of its terms before constraints are applied.
template <int D>
Eigen::MatrixXd component_impulses(const Coupling<D>& coupling, Eigen::VectorXd& magnitude)
{
    constexpr int n = twist_size<D>;
    const CoupledSystem<D>& system = coupling.system;
    const int count = static_cast<int>(system.components.size()), dofs = n * system.bodies;
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(dofs + 1, count); // last row: sum of squares
    auto add = [&](int component, int solid, const Twist<D>& flux) {
        const int body = coupling.free_body[solid];
        if (body < 0)
            return;
        sums.col(component).template segment<n>(n * body) += coupling.solids[solid].admissible * flux;
        sums(dofs, component) += flux.squaredNorm();
    };
    for (const auto& entry : coupling.cell_flux)
        add(system.component(entry.row), entry.body, entry.flux);
    for (const auto& entry : coupling.node_flux)
        add(system.node_component[entry.row], entry.body, entry.flux);
    coupling.grid->comm().sum(std::span<double>(sums.data(), static_cast<std::size_t>(sums.size())));
    magnitude = sums.row(dofs).cwiseSqrt();
    return sums.topRows(dofs);
}

// Floating components other than the largest.
template <int D>
void list_sealed(Coupling<D>& coupling)
{
    const CoupledSystem<D>& system = coupling.system;
    const Grid<D>& grid = *coupling.grid;
    const int count = static_cast<int>(system.components.size()), solids = static_cast<int>(coupling.solids.size());
    int main = -1;
    for (int k = 0; k < count; ++k)
        if (main < 0 || std::make_pair(system.components[k].grounded, system.components[k].unknowns) >
                            std::make_pair(system.components[main].grounded, system.components[main].unknowns))
            main = k;
    std::vector<int> sealed;
    std::vector<int> place(count, -1);
    for (int k = 0; k < count; ++k)
        if (k != main && !system.components[k].grounded) {
            place[k] = static_cast<int>(sealed.size());
            sealed.push_back(k);
        }
    coupling.sealed.clear();
    if (sealed.empty())
        return;
    const std::size_t row = static_cast<std::size_t>(solids + 1 + D); // the solids that touch it; its cells; a cell's centre
    std::vector<double> facts(sealed.size() * row, 0.0);
    auto touches = [&](int component, int solid) {
        if (place[component] >= 0 && !coupling.solids[solid].wall)
            facts[place[component] * row + solid] = 1;
    };
    for (const auto& entry : coupling.cell_flux)
        touches(system.component(entry.row), entry.body);
    for (const auto& entry : coupling.node_flux)
        touches(system.node_component[entry.row], entry.body);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        const int k = system.component(c);
        if (k < 0 || place[k] < 0)
            return;
        double* fact = &facts[place[k] * row + solids];
        ++fact[0];
        const Vec<D> x = grid.cell_centre(c);
        for (int axis = 0; axis < D; ++axis)
            fact[1 + axis] += x[axis];
    });
    grid.comm().sum(facts);
    std::vector<Vec<D>> node_at(sealed.size(), Vec<D>::Zero()); // a film node of it, for films without a way out
    std::vector<long> nodes(sealed.size(), 0);
    for (const Film<D>& film : coupling.network.films)
        for (std::size_t node = 0; node < film.mesh.mid.size(); ++node)
            if (const int i = place[system.node_component[film.first_node + static_cast<int>(node)]]; i >= 0) {
                node_at[i] = film.mesh.mid[node];
                ++nodes[i];
                if (facts[i * row + solids] == 0)
                    for (const int solid : {film.mesh.master, film.mesh.other})
                        facts[i * row + solid] = 1;
            }
    for (std::size_t i = 0; i < sealed.size(); ++i) {
        SealedPocket pocket;
        const double* fact = &facts[i * row + solids];
        pocket.cells = std::lround(fact[0]);
        pocket.nodes = nodes[i];
        for (int s = 0; s < solids; ++s)
            if (facts[i * row + s] > 0)
                pocket.bodies.push_back(coupling.solids[s].name);
        for (int axis = 0; axis < D; ++axis)
            pocket.at.push_back(fact[0] > 0 ? fact[1 + axis] / fact[0] : node_at[i][axis]);
        coupling.sealed.push_back(pocket);
    }
}

} // namespace

template <int D>
void find_null_space(Coupling<D>& coupling)
{
    CoupledSystem<D>& system = coupling.system;
    const int count = static_cast<int>(system.components.size());
    Eigen::VectorXd magnitude;
    const Eigen::MatrixXd impulse = component_impulses(coupling, magnitude);
    std::vector<int> touched; // floating components that free bodies touch
    std::vector<Eigen::VectorXd> null;
    for (int k = 0; k < count; ++k) {
        if (system.components[k].grounded)
            continue;
        if (impulse.col(k).norm() <= 1e-9 * magnitude[k] || magnitude[k] == 0)
            null.push_back(Eigen::VectorXd::Unit(count, k));
        else
            touched.push_back(k);
    }
    if (!touched.empty()) {
        Eigen::MatrixXd scaled(impulse.rows(), static_cast<long>(touched.size()));
        for (std::size_t i = 0; i < touched.size(); ++i)
            scaled.col(static_cast<long>(i)) = impulse.col(touched[i]) / magnitude[touched[i]];
        const SingularVectors right = right_singular_vectors(scaled);
        for (long j = 0; j < scaled.cols(); ++j) {
            if (j < right.values.size() && right.values[j] > 1e-9)
                continue;
            Eigen::VectorXd v = Eigen::VectorXd::Zero(count);
            for (std::size_t i = 0; i < touched.size(); ++i)
                v[touched[i]] = right.vectors(static_cast<long>(i), j) / magnitude[touched[i]];
            for (const Eigen::VectorXd& w : null)
                v -= v.dot(w) * w;
            null.push_back(v.normalized());
        }
    }
    system.null_space.resize(count, static_cast<long>(null.size()));
    for (std::size_t j = 0; j < null.size(); ++j)
        system.null_space.col(static_cast<long>(j)) = null[j];
}

template <int D>
bool contacts_lock_fluid(const Coupling<D>& coupling)
{
    const CoupledSystem<D>& system = coupling.system;
    Eigen::VectorXd magnitude;
    const Eigen::MatrixXd impulse = component_impulses(coupling, magnitude);
    for (long k = 0; k < impulse.cols(); ++k) {
        const Eigen::VectorXd pushed = impulse.col(k);
        const double yields = pushed.dot(system.response(pushed)),
                     without = pushed.cwiseAbs2().dot(system.mass.diagonal().cwiseInverse());
        if (!system.components[k].grounded && pushed.norm() > 1e-9 * magnitude[k] && yields <= 1e-9 * without)
            return true;
    }
    return false;
}

template <int D>
FluidParts<D> find_parts(const Coupling<D>& coupling, const std::vector<char>& shut)
{
    FluidParts<D> parts;
    parts.component = CellField<D, int>(*coupling.grid, -1);
    const int labels = label_cells(coupling, parts.component);
    const Numbering numbering = join_labels(coupling, shut, parts.component, labels);
    number_parts(coupling, shut, numbering, parts);
    return parts;
}

template <int D>
void find_components(Coupling<D>& coupling)
{
    FluidParts<D> parts = find_parts(coupling, {});
    coupling.system.component = std::move(parts.component);
    coupling.system.node_component = std::move(parts.node_component);
    coupling.system.components = std::move(parts.components);
    find_null_space(coupling);
    list_sealed(coupling);
}

template void find_null_space<2>(Coupling<2>&);
template void find_null_space<3>(Coupling<3>&);
template bool contacts_lock_fluid<2>(const Coupling<2>&);
template bool contacts_lock_fluid<3>(const Coupling<3>&);
template FluidParts<2> find_parts<2>(const Coupling<2>&, const std::vector<char>&);
template FluidParts<3> find_parts<3>(const Coupling<3>&, const std::vector<char>&);
template void find_components<2>(Coupling<2>&);
template void find_components<3>(Coupling<3>&);

} // namespace gapflow
