// The films' share of the coupled system (method, section 3.3, items 6 to 9, and 3.4).
#pragma once

#include "gapflow/coupling/coupling.hpp"

#include <map>

namespace gapflow {

/// K while it is assembled: flux rows of cells (all of the grid's that films touch) and of film nodes.
template <int D>
struct FluxRows {
    std::map<long, std::map<int, Twist<D>>> cells;       ///< Grid::key -> solid -> flux
    std::vector<std::map<int, Twist<D>>> nodes;          ///< film node -> solid -> flux

    void add_cell(long key, int solid, const Twist<D>& flux)
    {
        auto [it, is_new] = cells[key].try_emplace(solid, flux);
        if (!is_new)
            it->second += flux;
    }
    void add_node(int node, int solid, const Twist<D>& flux)
    {
        auto [it, is_new] = nodes[node].try_emplace(solid, flux);
        if (!is_new)
            it->second += flux;
    }
};

/// Adds all that films contribute to K (except the grid's own J of bulk and mixed cells), and fills the system's film
/// matrix and links and the coupling's normal inertia. The same on every rank.
template <int D>
void assemble_films(Coupling<D>& coupling, FluxRows<D>& rows);

} // namespace gapflow
