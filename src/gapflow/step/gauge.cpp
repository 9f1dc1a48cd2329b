#include "gapflow/step/gauge.hpp"

#include "gapflow/step/inner_faces.hpp"
#include "gapflow/step/own_edges.hpp"
#include "gapflow/step/remainder.hpp"

#include <utility>
#include <vector>

namespace gapflow {
namespace {

/// Values of the cells without fluid, such that the velocity less the gradient of all values over the density has no divergence there either: conjugate gradients.
template <int D>
void extend_into_solids(const Coupling<D>& coupling, const FaceField<D>& velocity, CellField<D>& p)
{
    constexpr double enough = 1e-3; // of the divergence at first: any field is a gauge
    const Grid<D>& grid = *coupling.grid;
    std::vector<Index<D>> cells;
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (coupling.system.component(c) < 0)
            cells.push_back(c);
    });
    if (!grid.comm().any(!cells.empty()))
        return;
    const auto for_each_face = [&](const Index<D>& c, const auto& f) {
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end)
                if (const Index<D> face = c + end * step<D>(axis); is_inner(grid, axis, face))
                    f(axis, face, Index<D>(end ? face : Index<D>(c - step<D>(axis))), end ? 1.0 : -1.0,
                      grid.relative_area(axis, face));
    };
    for (const Index<D>& c : cells)
        p(c) = 0;
    exchange(grid, p, 1);
    const std::size_t n = cells.size();
    std::vector<double> residual(n, 0.0), product(n);
    for (std::size_t k = 0; k < n; ++k)
        for_each_face(cells[k], [&](int axis, const Index<D>& f, const Index<D>& other, double sign, double area) {
            residual[k] += area * (p(other) / face_length(grid, axis, f) - sign * coupling.density * velocity(axis, f));
        });
    CellField<D> search(grid);
    const auto dot = [&](const std::vector<double>& a, const auto& b) {
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k)
            sum += a[k] * b(k);
        return grid.comm().sum(sum);
    };
    double square = dot(residual, [&](std::size_t k) { return residual[k]; });
    const double small = enough * enough * square;
    for (std::size_t k = 0; k < n; ++k)
        search(cells[k]) = residual[k];
    while (square > small) {
        exchange(grid, search, 1);
        for (std::size_t k = 0; k < n; ++k) {
            product[k] = 0;
            for_each_face(cells[k], [&](int axis, const Index<D>& f, const Index<D>& other, double, double area) {
                product[k] += area / face_length(grid, axis, f) * (search(cells[k]) - search(other));
            });
        }
        const double curvature = dot(product, [&](std::size_t k) { return search(cells[k]); });
        if (!(curvature > 0))
            break;
        const double step = square / curvature;
        for (std::size_t k = 0; k < n; ++k) {
            p(cells[k]) += step * search(cells[k]);
            residual[k] -= step * product[k];
        }
        const double before = square;
        square = dot(residual, [&](std::size_t k) { return residual[k]; });
        for (std::size_t k = 0; k < n; ++k)
            search(cells[k]) = residual[k] + square / before * search(cells[k]);
    }
}

/// Of cells: the potentials lose these values, the remainder their gradient.
template <int D>
void shift_gauge(const Placed<D>& at, CellField<D> p, PotentialFlow<D>& flow)
{
    const Coupling<D>& coupling = at.coupling;
    const Grid<D>& grid = *coupling.grid;
    extend_into_solids(coupling, flow.remainder.faces, p);
    const std::vector<double> own = own_along_edges(at, flow.remainder);
    FluidVelocity<D> u{std::move(flow.remainder.faces), {}, {}, {}};
    UnknownVector<D> by{p, Eigen::VectorXd::Zero(coupling.system.nodes)};
    subtract_gradient(coupling, by, u);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            if (!(coupling.system.conductance(axis, f) > 0) && is_inner(grid, axis, f))
                u.grid(axis, f) -=
                    (by.cells(f) - by.cells(Index<D>(f - step<D>(axis)))) / (coupling.density * face_length(grid, axis, f));
        });
    flow.remainder = remainder_of(at, std::move(u.grid));
    add_own(flow.remainder.edges, own);
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (coupling.system.component(c) >= 0)
            flow.p.cells(c) -= p(c);
    });
    Eigen::VectorXd of_nodes = Eigen::VectorXd::Zero(coupling.system.nodes);
    for (int part = 0; part < at.complex.parts(); ++part)
        if (const Index<D> c = at.complex.cell_of_part(part); at.node[part] >= 0 && grid.owns(c))
            of_nodes[at.node[part]] = p(c);
    grid.comm().sum(std::span<double>(of_nodes.data(), of_nodes.size()));
    flow.p.nodes -= of_nodes;
}

} // namespace

template <int D>
void renew_gauge(const Placed<D>& at, PotentialFlow<D>& flow, const SolverOptions& options)
{
    const std::vector<Twist<D>> rest(at.coupling.solids.size(), Twist<D>::Zero());
    shift_gauge(at, flow_of_twists(at, rest, options, flow.remainder).p.cells, flow);
}

template <int D>
void take_gauge_of_velocity(const Placed<D>& at, PotentialFlow<D>& flow)
{
    const Grid<D>& grid = *at.coupling.grid;
    shift_gauge(at, flow.p.cells, flow);
    FaceField<D>& u = flow.remainder.faces;
    FaceField<D> sum(grid), weight(grid);
    for (std::size_t e = 0; e < at.edges.edges.size(); ++e) {
        const SparseEdge<D>& edge = at.edges.edges[e];
        for (const auto& row : at.edges.rows_of(edge))
            if (row.node >= 0)
                flow.remainder.edges[e] += row.weight * flow.p.nodes[row.node] / at.coupling.density;
        if (edge.piece < 0)
            continue;
        const FacePiece<D>& piece = at.complex.pieces[edge.piece];
        const Index<D> f = at.complex.index.index(piece.face);
        sum(piece.axis, f) += edge.conductance * flow.remainder.edges[e] / face_length(grid, piece.axis, f);
        weight(piece.axis, f) += edge.conductance;
    }
    flow.p.nodes.setZero();
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            if (!(at.coupling.system.conductance(axis, f) > 0) && weight(axis, f) > 0)
                u(axis, f) = sum(axis, f) / weight(axis, f);
        });
    exchange(grid, u);
}

template void take_gauge_of_velocity<2>(const Placed<2>&, PotentialFlow<2>&);
template void take_gauge_of_velocity<3>(const Placed<3>&, PotentialFlow<3>&);
template void renew_gauge<2>(const Placed<2>&, PotentialFlow<2>&, const SolverOptions&);
template void renew_gauge<3>(const Placed<3>&, PotentialFlow<3>&, const SolverOptions&);

} // namespace gapflow
