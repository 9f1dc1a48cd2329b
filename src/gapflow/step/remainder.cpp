#include "gapflow/step/remainder.hpp"

#include "gapflow/core/sharing.hpp"
#include "gapflow/step/given_sides.hpp"
#include "gapflow/step/inner_faces.hpp"

#include <cmath>
#include <utility>

namespace gapflow {
namespace {

/// Density times velocity, integrated along an edge: the sum of w p has this unit. `p`: with what other ranks have around this one's cells.
template <int D>
double drop_along(const Placed<D>& at, const SparseEdge<D>& edge, const UnknownVector<D>& p)
{
    double sum = 0;
    for (const auto& row : at.edges.rows_of(edge))
        sum += row.weight * (row.node >= 0 ? p.nodes[row.node] : p.cells(row.cell));
    return sum;
}

/// The line integral along an edge, as a sum over velocities on faces of the grid: f(axis, face, length).
template <int D, class F>
void for_each_face_along(const Placed<D>& at, const SparseEdge<D>& edge, const F& f)
{
    const Grid<D>& grid = *at.coupling.grid;
    const DenseIndex<D>& index = at.complex.index;
    if (edge.link >= 0)
        return; // both nodes are at the cell's centre
    if (edge.piece >= 0) {
        const FacePiece<D>& piece = at.complex.pieces[edge.piece];
        const Index<D> face = at.complex.index.index(piece.face);
        f(int(piece.axis), face, face_length(grid, piece.axis, face));
        return;
    }
    const auto rows = at.edges.rows_of(edge);
    const Index<D> start = rows[0].cell;
    for (const auto& row : rows) { // along the grid's lines from the first row's cell
        Index<D> c = start;
        for (int axis = 0; axis < D; ++axis) {
            const int cells = grid.cells()[axis];
            int way = row.cell[axis] - c[axis];
            if (index.wraps[axis])
                way -= cells * static_cast<int>(std::lround(static_cast<double>(way) / cells));
            for (; way != 0; way -= way > 0 ? 1 : -1) {
                const Index<D> next = c + (way > 0 ? 1 : -1) * step<D>(axis), face = index.wrapped(way > 0 ? next : c);
                f(axis, face, (way > 0 ? -1 : 1) * row.weight * face_length(grid, axis, face));
                c = next;
            }
        }
    }
}

/// Adds to a field at cells of any rank in the layers around this one's.
template <int D>
class SumAtCells {
public:
    SumAtCells(const Grid<D>& grid, CellField<D>& field) : grid_(grid), field_(field) {}
    void add(const Index<D>& c, double value)
    {
        if (grid_.owns(c))
            field_(c) += value;
        else
            beyond_.emplace_back(grid_.key(grid_.wrapped(c)), value);
    }
    /// Gives what is another rank's to it. Collective.
    void finish()
    {
        if (grid_.comm().size() == 1)
            return;
        for (const auto& [key, value] : all_values(grid_.comm(), beyond_))
            if (const Index<D> c = grid_.cell_of_key(key); grid_.owns(c))
                field_(c) += value;
    }

private:
    const Grid<D>& grid_;
    CellField<D>& field_;
    std::vector<std::pair<long, double>> beyond_;
};

/// Adds f(edge, its number, axis, face, length) on the faces along all edges, whichever ranks have them. Collective.
template <int D, class F>
void add_along_edges(const Placed<D>& at, FaceField<D>& to, const F& f)
{
    const Grid<D>& grid = *at.coupling.grid;
    std::vector<SumAtCells<D>> inner; // the faces of edges that are another rank's lie between cells
    for (int axis = 0; axis < D; ++axis)
        inner.emplace_back(grid, to[axis]);
    for (std::size_t e = 0; e < at.edges.edges.size(); ++e)
        for_each_face_along(at, at.edges.edges[e], [&](int axis, const Index<D>& face, double length) {
            const double value = f(at.edges.edges[e], e, axis, face, length);
            if (owns_face(grid, axis, face))
                to(axis, face) += value;
            else
                inner[axis].add(face, value);
        });
    for (SumAtCells<D>& sum : inner)
        sum.finish();
    exchange(grid, to);
}

/// The remainder's momentum along what carries a flux.
template <int D>
double along(const Grid<D>& grid, const CarriedFlux<D>& flux, const Remainder<D>& remainder)
{
    return flux.axis >= 0 ? face_length(grid, flux.axis, flux.face) * remainder.faces(flux.axis, flux.face)
                          : remainder.edges[flux.edge];
}

} // namespace

template <int D>
std::vector<double> along_edges(const Placed<D>& at, const FaceField<D>& velocity)
{
    std::vector<double> result;
    for (const SparseEdge<D>& edge : at.edges.edges) {
        double sum = 0;
        for_each_face_along(at, edge, [&](int axis, const Index<D>& f, double length) { sum += length * velocity(axis, f); });
        result.push_back(sum);
    }
    return result;
}

template <int D>
Remainder<D> remainder_of(const Placed<D>& at, FaceField<D> velocity)
{
    exchange(*at.coupling.grid, velocity);
    std::vector<double> edges = along_edges(at, velocity);
    return {std::move(velocity), std::move(edges)};
}

template <int D>
std::vector<FaceAlong<D>> faces_along(const Placed<D>& at, const SparseEdge<D>& edge)
{
    std::vector<FaceAlong<D>> faces;
    for_each_face_along(at, edge, [&](int axis, const Index<D>& f, double length) { faces.push_back({axis, f, length}); });
    return faces;
}

template <int D>
UnknownVector<D> outflow_of_edges(const Placed<D>& at, const Remainder<D>& remainder)
{
    const Coupling<D>& coupling = at.coupling;
    UnknownVector<D> sum{CellField<D>(*coupling.grid), Eigen::VectorXd::Zero(coupling.system.nodes)};
    SumAtCells<D> cells(*coupling.grid, sum.cells);
    for (std::size_t e = 0; e < remainder.edges.size(); ++e) {
        const SparseEdge<D>& edge = at.edges.edges[e];
        const double flux = edge.conductance * coupling.density * remainder.edges[e];
        for (const auto& row : at.edges.rows_of(edge))
            if (row.node >= 0)
                sum.nodes[row.node] += row.weight * flux;
            else
                cells.add(row.cell, row.weight * flux);
    }
    cells.finish();
    coupling.grid->comm().sum(std::span<double>(sum.nodes.data(), sum.nodes.size()));
    return sum;
}

template <int D>
UnknownVector<D> outflow_of_faces(const Placed<D>& at, const Remainder<D>& remainder)
{
    const Coupling<D>& coupling = at.coupling;
    UnknownVector<D> faces;
    outflow(coupling, {remainder.faces, {}, {}, {}}, std::vector<Twist<D>>(coupling.solids.size(), Twist<D>::Zero()), faces);
    return faces;
}

template <int D>
UnknownVector<D> outflow_of_remainder(const Placed<D>& at, const Remainder<D>& remainder)
{
    UnknownVector<D> sum = outflow_of_edges(at, remainder);
    add_to(sum, outflow_of_faces(at, remainder));
    return sum;
}

template <int D>
std::vector<Twist<D>> impulse_of_remainder(const Placed<D>& at, const Remainder<D>& remainder)
{
    const Coupling<D>& coupling = at.coupling;
    std::vector<Twist<D>> impulse(coupling.solids.size(), Twist<D>::Zero());
    for (const auto* list : {&at.edges.carried, &at.edges.covered})
        for (const CarriedFlux<D>& flux : *list)
            impulse[flux.solid] -= coupling.density * along(*coupling.grid, flux, remainder) * flux.flux;
    if (!impulse.empty())
        coupling.grid->comm().sum(std::span<double>(impulse.data()->data(), impulse.size() * twist_size<D>));
    return impulse;
}

template <int D>
double work_of_fluxes(const Coupling<D>& coupling, const FaceField<D>& flux, const FaceField<D>& velocity)
{
    const Grid<D>& grid = *coupling.grid;
    double sum = 0;
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> end = owned_faces_end(grid, axis);
        for_each_row<D>(grid.low(), end, [&](const Index<D>& first) {
            const double *q = &flux(axis, first), *u = &velocity(axis, first);
            const SpreadRow<D> spread(grid, axis, first);
            Index<D> f = first;
            for (int i = 0; f[0] < end[0]; ++i, ++f[0]) {
                const bool in_side = f[axis] == 0 || f[axis] == grid.cells()[axis];
                sum += q[i] * (in_side ? face_length(grid, axis, f) : grid.dx() * spread[i]) * u[i];
            }
        });
    }
    return coupling.density * grid.face_area() * grid.comm().sum(sum);
}

template <int D>
EdgeFluxes<D> edge_fluxes(const Placed<D>& at, const PotentialFlow<D>& flow)
{
    const Coupling<D>& coupling = at.coupling;
    const Grid<D>& grid = *coupling.grid;
    const Remainder<D>& remainder = flow.remainder;
    FluidVelocity<D> u{remainder.empty() ? FaceField<D>(grid) : remainder.faces, {}, {}, {}};
    UnknownVector<D> p = flow.p;
    subtract_gradient(coupling, p, u);
    exchange(grid, p.cells);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            u.grid(axis, f) = coupling.system.conductance(axis, f) > 0 ? coupling.open(axis, f) * u.grid(axis, f) : 0.0;
        });
    add_inflow(at, flow.sides, u.grid);
    std::vector<double> through(at.edges.edges.size());
    for (std::size_t e = 0; e < through.size(); ++e) {
        const SparseEdge<D>& edge = at.edges.edges[e];
        through[e] =
            edge.conductance * (drop_along(at, edge, p) + (remainder.empty() ? 0.0 : coupling.density * remainder.edges[e]));
    }
    for (const CarriedFlux<D>& of : at.edges.carried) {
        const double flux = of.flux.dot(flow.twists[of.solid]);
        if (of.axis >= 0)
            u.grid(of.axis, of.face) += flux / grid.face_area();
        else
            through[of.edge] += flux;
    }
    return {std::move(u.grid), std::move(through)};
}

template <int D>
FaceField<D> on_faces(const Placed<D>& at, EdgeFluxes<D> fluxes)
{
    const Grid<D>& grid = *at.coupling.grid;
    add_along_edges(at, fluxes.face, [&](const SparseEdge<D>&, std::size_t e, int axis, const Index<D>& f, double length) {
        return length / face_length(grid, axis, f) * fluxes.edge[e] / grid.face_area();
    });
    return std::move(fluxes.face);
}

template <int D>
FaceField<D> face_fluxes(const Placed<D>& at, const PotentialFlow<D>& flow)
{
    EdgeFluxes<D> fluxes = edge_fluxes(at, flow);
    for (const CarriedFlux<D>& of : at.edges.covered)
        fluxes.face(of.axis, of.face) += of.flux.dot(flow.twists[of.solid]) / at.coupling.grid->face_area();
    return on_faces(at, std::move(fluxes));
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<double> along_edges<D>(const Placed<D>&, const FaceField<D>&);                                        \
    template Remainder<D> remainder_of<D>(const Placed<D>&, FaceField<D>);                                                     \
    template std::vector<FaceAlong<D>> faces_along<D>(const Placed<D>&, const SparseEdge<D>&);                                 \
    template UnknownVector<D> outflow_of_edges<D>(const Placed<D>&, const Remainder<D>&);                                      \
    template UnknownVector<D> outflow_of_faces<D>(const Placed<D>&, const Remainder<D>&);                                      \
    template UnknownVector<D> outflow_of_remainder<D>(const Placed<D>&, const Remainder<D>&);                                  \
    template std::vector<Twist<D>> impulse_of_remainder<D>(const Placed<D>&, const Remainder<D>&);                             \
    template double work_of_fluxes<D>(const Coupling<D>&, const FaceField<D>&, const FaceField<D>&);                           \
    template EdgeFluxes<D> edge_fluxes<D>(const Placed<D>&, const PotentialFlow<D>&);                                          \
    template FaceField<D> on_faces<D>(const Placed<D>&, EdgeFluxes<D>);                                                        \
    template FaceField<D> face_fluxes<D>(const Placed<D>&, const PotentialFlow<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
