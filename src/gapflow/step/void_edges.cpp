// The edges that lead to voids, and rows of the system that are given.
#include "gapflow/step/void_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace gapflow {
namespace {

constexpr double least_way = 1e-9; // in dx: a dry gap that is closed stays this open, so that what it encloses has a pressure

template <int D>
class Edges {
public:
    Edges(const Complex<D>& complex, const Coupling<D>& coupling, Voids<D>& voids)
        : complex_(complex), coupling_(coupling), voids_(voids), cells_(coupling.grid->cells().template cast<long>().prod())
    {
        for (VoidPart<D>& part : voids_.parts)
            part.row = row_of(side_of(complex, part.part));
    }

    long row_of(const PartOrCell& side) const
    {
        const int node = side.is_part() ? coupling_.part_node[side.number()] : -1;
        return node >= 0 ? cells_ + node
                         : coupling_.grid->key(coupling_.grid->wrapped(complex_.index.index(complex_.cell_of(side))));
    }

    /// If any of the sides is a void. `thickness`: of the gap there, in cells; 0: that of the voids' parts.
    void offer(double conductance, double area, double thickness, const std::vector<std::pair<PartOrCell, double>>& sides,
               std::int32_t piece, std::int32_t mouth, long face = -1)
    {
        const double dx = coupling_.grid->dx();
        double permeable = 1;
        bool leads_to_void = false;
        for (const auto& [side, weight] : sides)
            if (side.exists() && voids_.is_void(site_of(complex_, side))) {
                const VoidPart<D>& part = *voids_.find(site_of(complex_, side));
                const double gap = thickness > 0 ? thickness * dx : part.thickness;
                permeable = std::min(permeable, std::max(gap - part.held, least_way * dx) / gap);
                leads_to_void = true;
            }
        if (!leads_to_void || !(conductance > 0))
            return;
        VoidEdge<D> edge{conductance, permeable, area * std::pow(dx, D - 1), {}, {}, piece, mouth, face};
        for (const auto& [side, weight] : sides)
            if (side.exists()) {
                edge.rows.emplace_back(row_of(side), weight);
                edge.sites.push_back(site_of(complex_, side));
            }
        voids_.edges.push_back(std::move(edge));
    }

private:
    const Complex<D>& complex_;
    const Coupling<D>& coupling_;
    Voids<D>& voids_;
    long cells_;
};

/// Faces of the grid between whole cells, or what is the largest in them, that lead to a void.
template <int D>
void offer_whole_faces(const Complex<D>& complex, const Coupling<D>& coupling, const Voids<D>& voids, Edges<D>& edges)
{
    const Grid<D>& grid = *coupling.grid;
    const DenseIndex<D>& index = complex.index;
    std::array<std::vector<char>, D> has_piece;
    for (std::vector<char>& has : has_piece)
        has.assign(index.count, 0);
    for (const FacePiece<D>& piece : complex.pieces)
        has_piece[piece.axis][piece.face] = 1;
    for (const VoidPart<D>& part : voids.parts) {
        const PartOrCell side = side_of(complex, part.part);
        if (!voids.is_void(part.part) || !complex.is_main(side))
            continue;
        const Index<D> c = index.index(complex.cell_of(side));
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end) {
                const Index<D> next = index.wrapped(c + (2 * end - 1) * step<D>(axis)), f = c + end * step<D>(axis);
                const double g = coupling.system.conductance(axis, f);
                if (!(g > 0) || !grid.in_domain(next) || has_piece[axis][index(index.wrapped(f))])
                    continue;
                const PartOrCell other = complex.main_of(index(next));
                if (end == 0 && voids.is_void(site_of(complex, other)))
                    continue; // the other one's
                edges.offer(g, 1.0, 0.0, {{end ? side : other, 1.0}, {end ? other : side, -1.0}}, -1, -1,
                            grid.key(index.wrapped(f)) * D + axis);
            }
    }
}

} // namespace

template <int D>
void separate(const Complex<D>& complex, const Inertia<D>& inertia, Voids<D>& voids, Coupling<D>& coupling)
{
    const Grid<D>& grid = *coupling.grid;
    const double unit = std::pow(grid.dx(), D - 2) / coupling.density;
    Edges<D> edges(complex, coupling, voids);
    if (voids.any()) {
        std::vector<double> thickness(complex.pieces.size(), 0.0);
        for (const GapArm<D>& arm : voids.arms)
            thickness[arm.piece] = arm.thickness;
        for (std::size_t k = 0; k < complex.pieces.size(); ++k) {
            const FacePiece<D>& piece = complex.pieces[k];
            if (is_way_out(grid, piece) && piece.low.exists() && piece.high.exists())
                edges.offer(unit * inertia.piece_weight[k] /
                                grid.spread(piece.axis, complex.index.index(piece.face)[piece.axis]),
                            piece.area, thickness[k], {{piece.low, 1.0}, {piece.high, -1.0}}, static_cast<std::int32_t>(k), -1);
        }
        offer_whole_faces(complex, coupling, voids, edges);
        std::size_t number = 0; // of Inertia::mouths
        for (std::size_t m = 0; m < voids.mouths.size(); ++m)
            if (const MouthArm<D>& mouth = voids.mouths[m]; mouth.resistance > 0) {
                const RowsLink<D>& link = inertia.mouths[number++];
                edges.offer(unit * link.conductance,
                            mouth.piece >= 0 ? complex.pieces[mouth.piece].area : complex.links[mouth.link].open,
                            mouth.piece >= 0 ? thickness[mouth.piece] : 0.0, link.rows, mouth.piece,
                            static_cast<std::int32_t>(m));
            }
    }
    voids.all = std::make_unique<Coupling<D>>();
    if (voids.any()) {
        std::map<long, double> rows;
        for (const VoidPart<D>& part : voids.parts)
            if (voids.is_void(part.part))
                rows[part.row] = 0;
        take_rows_out<D>(coupling, rows, nullptr);
    }
    *voids.all = coupling;
    const long cells = grid.cells().template cast<long>().prod();
    for (const VoidEdge<D>& edge : voids.edges) {
        Link link{edge.open(), {}, {}};
        for (const auto& [row, weight] : edge.rows)
            if (row < cells)
                link.cells.emplace_back(row, weight);
            else
                link.nodes.emplace_back(static_cast<int>(row - cells), weight);
        voids.all->system.links.push_back(std::move(link));
    }
}

template <int D>
void take_rows_out(Coupling<D>& coupling, const std::map<long, double>& given, UnknownVector<D>* outflow)
{
    const Grid<D>& grid = *coupling.grid;
    CoupledSystem<D>& system = coupling.system;
    const long cells = grid.cells().template cast<long>().prod();
    const auto is_given = [&](long row) { return given.contains(row); };
    const auto is_given_node = [&](int node) { return given.contains(cells + node); };
    std::set<long> beside;
    const auto close = [&](int axis, Index<D> f) {
        system.conductance(axis, f) = coupling.open(axis, f) = 0;
        if (grid.periodic(axis) && (f[axis] == 0 || f[axis] == grid.cells()[axis])) {
            f[axis] = grid.cells()[axis] - f[axis];
            system.conductance(axis, f) = coupling.open(axis, f) = 0;
        }
    };
    for (const auto& [row, value] : given) {
        if (row >= cells)
            continue;
        const Index<D> c = grid.cell_of_key(row);
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end) {
                const Index<D> f = c + end * step<D>(axis), next = grid.wrapped(c + (2 * end - 1) * step<D>(axis));
                const double g = system.conductance(axis, f);
                if (!(g > 0))
                    continue;
                if (outflow && grid.in_domain(next) && !is_given(grid.key(next))) {
                    outflow->cells(next) -= g * value;
                    system.links.push_back({g, {}, {{grid.key(next), 1.0}}});
                    beside.insert(grid.key(next));
                }
                close(axis, f);
            }
    }
    std::vector<Eigen::Triplet<double>> film;
    for (int j = 0; j < system.film.outerSize(); ++j) {
        double lost = 0;
        for (Eigen::SparseMatrix<double>::InnerIterator entry(system.film, j); entry; ++entry) {
            const int i = static_cast<int>(entry.row());
            if (is_given_node(j))
                continue;
            if (!is_given_node(i)) {
                film.emplace_back(i, j, entry.value());
                continue;
            }
            if (outflow)
                outflow->nodes[j] += entry.value() * given.at(cells + i);
            else
                lost += entry.value();
        }
        if (lost != 0)
            film.emplace_back(j, j, lost);
        if (outflow && is_given_node(j)) // any number: the row has no other entry
            film.emplace_back(j, j, 1.0);
    }
    system.film.setFromTriplets(film.begin(), film.end());
    const auto touches = [&](const Link& link) {
        return std::any_of(link.nodes.begin(), link.nodes.end(), [&](const auto& n) { return is_given_node(n.first); }) ||
               std::any_of(link.cells.begin(), link.cells.end(), [&](const auto& c) { return is_given(c.first); });
    };
    if (!outflow)
        std::erase_if(system.links, touches);
    for (Link& link : system.links) {
        if (!outflow || !touches(link))
            continue;
        double sum = 0;
        for (const auto& [node, weight] : link.nodes)
            sum += is_given_node(node) ? weight * given.at(cells + node) : 0.0;
        for (const auto& [key, weight] : link.cells)
            sum += is_given(key) ? weight * given.at(key) : 0.0;
        std::erase_if(link.nodes, [&](const auto& n) { return is_given_node(n.first); });
        std::erase_if(link.cells, [&](const auto& c) { return is_given(c.first); });
        for (const auto& [node, weight] : link.nodes) {
            outflow->nodes[node] += link.conductance * weight * sum;
            beside.insert(cells + node);
        }
        for (const auto& [key, weight] : link.cells) {
            outflow->cells(grid.cell_of_key(key)) += link.conductance * weight * sum;
            beside.insert(key);
        }
    }
    if (!outflow)
        return;
    std::erase_if(system.links, [](const Link& link) { return link.nodes.empty() && link.cells.empty(); });
    const auto cell_gone = [&](const auto& entry) { return is_given(grid.key(entry.row)); };
    const auto node_gone = [&](const auto& entry) { return is_given_node(entry.row); };
    std::erase_if(coupling.cell_flux, cell_gone);
    std::erase_if(system.cell_flux, cell_gone);
    std::erase_if(coupling.node_flux, node_gone);
    std::erase_if(system.node_flux, node_gone);
    for (const auto& [row, value] : given)
        if (row < cells)
            coupling.kind(grid.cell_of_key(row)) = static_cast<std::int8_t>(CellKind::solid);
    find_components(coupling);
    for (const long row : beside)
        system
            .components[row < cells ? system.component(grid.cell_of_key(row))
                                    : system.node_component[static_cast<int>(row - cells)]]
            .grounded = true;
    find_null_space(coupling);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void separate<D>(const Complex<D>&, const Inertia<D>&, Voids<D>&, Coupling<D>&);                                  \
    template void take_rows_out<D>(Coupling<D>&, const std::map<long, double>&, UnknownVector<D>*);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
