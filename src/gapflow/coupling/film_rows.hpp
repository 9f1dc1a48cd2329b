// The films' share of the coupled system (method, "Rows of the film", "Mouths and joints").
#pragma once

#include "gapflow/coupling/coupling.hpp"

#include <utility>
#include <vector>

namespace gapflow {

/// K while it is assembled: flux rows of this rank's cells that films touch and of its film nodes. What is added to others is left out.
template <int D>
struct FluxRows {
    explicit FluxRows(const CoupledSystem<D>& of) : nodes(of.nodes), system(of) {}

    /// Flux per unit twist of the few solids in a row, in the order in which they were added.
    using Row = InlineVector<std::pair<int, Twist<D>>, 2>;
    KeyMap<Row> cells;      ///< by Grid::key
    std::vector<Row> nodes; ///< of film nodes
    const CoupledSystem<D>& system;

    void add_cell(long key, int solid, const Twist<D>& flux)
    {
        if (system.grid->owns(system.grid->cell_of_key(key)))
            add(cells[key], solid, flux);
    }
    void add_node(int node, int solid, const Twist<D>& flux)
    {
        if (system.owns(node))
            add(nodes[node], solid, flux);
    }

private:
    static void add(Row& row, int solid, const Twist<D>& flux)
    {
        for (auto& [known, sum] : row)
            if (known == solid) {
                sum += flux;
                return;
            }
        row.push_back({solid, flux});
    }
};

/// Adds all contributions of films to K (except the grid's own J of bulk and mixed cells), and fills the system's film
/// matrix and links and the coupling's normal inertia.
template <int D>
void assemble_films(Coupling<D>& coupling, FluxRows<D>& rows);

/// Appends the rows to K of all solids (coupling.cell_flux, node_flux) and to the free bodies' share of it: in cells that of the system, in
/// film nodes `free_nodes`.
template <int D>
void append_rows(Coupling<D>& coupling, const FluxRows<D>& rows, std::vector<BodyFlux<D, int>>& free_nodes);

/// Adds `share` times a mouth's contribution to K.
template <int D>
void add_mouth(const Coupling<D>& coupling, std::size_t mouth, double share, FluxRows<D>& rows);

} // namespace gapflow
