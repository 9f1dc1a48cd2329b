#include "gapflow/step/viscous_projection.hpp"

#include "gapflow/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace gapflow {
namespace {

constexpr double loosest = 1e-4; // of each

} // namespace

template <int D>
ViscousProjection<D>::ViscousProjection(const Placed<D>& at, const ViscousColumns<D>& columns,
                                        const Eigen::SparseMatrix<double>& free, const Vector& diagonal,
                                        const Eigen::SparseMatrix<double>& bodies, double tolerance,
                                        const std::vector<int>& given)
    : columns_(columns), diagonal_(diagonal), tolerance_(tolerance),
      traces_(columns, free, diagonal.tail(diagonal.size() - columns.edges())),
      coupling_(std::make_unique<Coupling<D>>(at.coupling))
{
    const Grid<D>& grid = *at.coupling.grid;
    if (bodies.rows() > 0 && !bodies_.compute(bodies))
        throw ComputationError("the bodies' block of the viscous system is not positive definite");
    Coupling<D>& coupling = *coupling_;
    CoupledSystem<D>& system = coupling.system;
    coupling.gauge_cells.clear();
    coupling.gauge_nodes.clear();
    const auto less = [&](int edge) { return columns.conductance(edge) / diagonal[edge]; };
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), grid.high() + step<D>(axis), [&](const Index<D>& f) {
            if (const int edge = columns.edge_of_face(axis, f); edge >= 0)
                system.conductance(axis, f) = less(edge);
        });
    system.links.clear();
    std::vector<Eigen::Triplet<double>> film;
    for (std::size_t e = 0; e < at.edges.edges.size(); ++e) {
        const auto rows = at.edges.rows_of(at.edges.edges[e]);
        const double g = less(columns.edge_of(e));
        if (!(g > 0) || rows.empty())
            continue;
        bool nodes = rows.size() <= 2;
        for (const auto& row : rows)
            nodes = nodes && row.node >= 0;
        if (nodes) {
            for (const auto& a : rows)
                for (const auto& b : rows)
                    film.emplace_back(a.node, b.node, g * a.weight * b.weight);
            continue;
        }
        Link link{g, {}, {}};
        for (const auto& row : rows)
            if (row.node >= 0)
                link.nodes.emplace_back(row.node, row.weight);
            else
                link.cells.emplace_back(grid.key(grid.wrapped(row.cell)), row.weight);
        system.links.push_back(std::move(link));
    }
    system.film.setZero();
    system.film.setFromTriplets(film.begin(), film.end());
    system.cell_flux.clear();
    system.node_flux.clear();
    const auto admitted = [&](int solid, const Twist<D>& flux) { return Twist<D>(coupling.solids[solid].admissible * flux); };
    for (const auto& entry : coupling.cell_flux)
        if (const int b = coupling.free_body[entry.body]; b >= 0)
            system.cell_flux.push_back({entry.row, b, admitted(entry.body, entry.flux)});
    for (const auto& entry : coupling.node_flux)
        if (const int b = coupling.free_body[entry.body]; b >= 0)
            system.node_flux.push_back({entry.row, b, admitted(entry.body, entry.flux)});
    system.mass = bodies;
    system.contact.resize(0, system.mass.rows());
    system.contact_resistance.resize(0);
    system.response = BodyResponse(system.mass, system.contact, system.contact_resistance);
    find_components(coupling);
    if (!given.empty()) {
        std::map<long, double> zero;
        for (const int row : given)
            zero[row] = 0;
        UnknownVector<D> none{CellField<D>(grid), Eigen::VectorXd::Zero(system.nodes)};
        take_rows_out(coupling, zero, &none);
    }
    SolverOptions options;
    options.tolerance = tolerance;
    solver_ = std::make_unique<CoupledSolver<D>>(system, options);
    // Columns of the unknowns: edges and traces, then the free bodies' twists.
    std::vector<Eigen::Triplet<double>> entries;
    const int fluid = columns.twist(0);
    const auto& out = columns.outflow();
    std::vector<char> is_given(columns.unknowns(), 0);
    for (const int row : given)
        is_given[row] = 1;
    for (int row = 0; row < out.outerSize(); ++row)
        for (typename ViscousColumns<D>::Rows::InnerIterator entry(out, row); entry; ++entry)
            if (entry.col() < fluid && !is_given[row])
                entries.emplace_back(row, static_cast<int>(entry.col()), entry.value());
    const auto add = [&](long row, int b, const Twist<D>& flux) {
        for (int k = 0; k < twist_size<D>; ++k)
            entries.emplace_back(static_cast<int>(row), fluid + twist_size<D> * b + k, flux[k]);
    };
    for (const auto& entry : system.cell_flux)
        add(grid.key(entry.row), entry.body, entry.flux);
    const long cells = columns.unknowns() - system.nodes;
    for (const auto& entry : system.node_flux)
        add(cells + entry.row, entry.body, entry.flux);
    outflow_.resize(columns.unknowns(), fluid + twist_size<D> * system.bodies);
    outflow_.setFromTriplets(entries.begin(), entries.end());
    held_ = outflow_.transpose();
}

template <int D>
void ViscousProjection<D>::find_weighted(const Vector& residual, Vector& z) const
{
    const int edges = columns_.edges();
    const Eigen::Index fluid = diagonal_.size();
    z.resize(residual.size());
    z.head(edges) = residual.head(edges).cwiseQuotient(diagonal_.head(edges));
    z.segment(edges, fluid - edges).setZero();
    if (const Eigen::Index n = residual.size() - fluid; n > 0)
        z.tail(n) = bodies_.solve(residual.tail(n));
}

template <int D>
Eigen::VectorXd ViscousProjection<D>::pressure_of(const Vector& outflow, double tolerance) const
{
    UnknownVector<D> p = columns_.to_unknowns(Vector::Zero(columns_.unknowns()));
    const SolveReport report = solver_->solve(p, columns_.to_unknowns(outflow), 0.0, tolerance);
    if (!report.converged)
        throw ComputationError("the projection of the viscous solve did not converge: " + report.message);
    return columns_.of_unknowns(p);
}

template <int D>
Eigen::VectorXd ViscousProjection<D>::with_outflow(const Vector& outflow) const
{
    Vector z = Vector::Zero(outflow_.cols());
    if (outflow.isZero(0))
        return z;
    const Vector push = held_ * pressure_of(outflow, tolerance_);
    find_weighted(push, z);
    traces_.follow(Vector::Zero(push.size()), z);
    return z;
}

template <int D>
Eigen::VectorXd ViscousProjection<D>::project(Vector& residual, Vector& z, double& largest) const
{
    Vector whole = residual;
    traces_.pull(residual, whole);
    find_weighted(whole, z);
    const Vector outflow = outflow_ * z;
    const double size = outflow.norm();
    largest = std::max(largest, size);
    const Vector pressure = pressure_of(outflow, std::min(loosest, tolerance_ * largest / std::max(size, 1e-300))),
                 held = held_ * pressure;
    residual -= held;
    whole -= held;
    find_weighted(whole, z);
    traces_.follow(residual, z);
    return pressure;
}

template class ViscousProjection<2>;
template class ViscousProjection<3>;

} // namespace gapflow
