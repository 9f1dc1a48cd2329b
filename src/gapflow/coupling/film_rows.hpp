// The films' share of the coupled system (method, "Rows of the film", "Mouths and joints").
#pragma once

#include "gapflow/core/threads.hpp"
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
        if (system.grid->comm().size() == 1 || system.grid->owns(system.grid->cell_of_key(key)))
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

/// Entries of K, of all solids and of the free bodies among them.
template <int D, class Row>
struct FluxEntries {
    std::vector<BodyFlux<D, Row>> all, free;

    void add(const Coupling<D>& coupling, const Row& row, int solid, const Twist<D>& flux)
    {
        all.push_back({row, solid, flux});
        if (const int b = coupling.free_body[solid]; b >= 0)
            free.push_back({row, b, coupling.solids[solid].admissible * flux});
    }
};

/// Appends to both lists what add(i, entries) adds for every i < n, on threads.
template <int D, class Row, class Add>
void append_entries(long n, Add&& add, std::vector<BodyFlux<D, Row>>& all, std::vector<BodyFlux<D, Row>>& free)
{
    constexpr long chunk = 1024; // of a thread's piece of work
    std::vector<FluxEntries<D, Row>> chunks = each_chunk(n, chunk, [&](long begin, long end) {
        FluxEntries<D, Row> entries;
        for (long i = begin; i < end; ++i)
            add(i, entries);
        return entries;
    });
    std::size_t all_count = all.size(), free_count = free.size();
    for (const FluxEntries<D, Row>& entries : chunks) {
        all_count += entries.all.size();
        free_count += entries.free.size();
    }
    all.reserve(all_count);
    free.reserve(free_count);
    for (FluxEntries<D, Row>& entries : chunks) {
        all.insert(all.end(), entries.all.begin(), entries.all.end());
        free.insert(free.end(), entries.free.begin(), entries.free.end());
        entries = {};
    }
}

/// Appends the rows to K of all solids (coupling.cell_flux, node_flux) and to the free bodies' share of it: in cells that of the system, in
/// film nodes `free_nodes`.
template <int D>
void append_rows(Coupling<D>& coupling, const FluxRows<D>& rows, std::vector<BodyFlux<D, int>>& free_nodes);

/// Adds `share` times a mouth's contribution to K.
template <int D>
void add_mouth(const Coupling<D>& coupling, std::size_t mouth, double share, FluxRows<D>& rows);

} // namespace gapflow
