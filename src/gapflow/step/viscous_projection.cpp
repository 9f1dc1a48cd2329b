#include "gapflow/step/viscous_projection.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/sort_unique.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace gapflow {
namespace {

constexpr double loosest = 1e-2; // of each
constexpr double share = 0.2;    // of the flow's size: there are some twenty projections

} // namespace

template <int D>
ViscousProjection<D>::ViscousProjection(const Placed<D>& at, const ViscousColumns<D>& columns,
                                        const typename ViscousColumns<D>::Rows& form_of, const Vector& diagonal,
                                        const Eigen::SparseMatrix<double>& bodies, double tolerance,
                                        const std::vector<int>& given)
    : columns_(columns), weight_(diagonal.head(columns.edges()).cwiseInverse()), tolerance_(tolerance),
      traces_(columns, form_of, diagonal.tail(diagonal.size() - columns.edges())), unknowns_(form_of.cols()),
      coupling_(std::make_unique<Coupling<D>>(at.coupling))
{
    const Grid<D>& grid = *at.coupling.grid;
    if (bodies.rows() > 0 && !bodies_.compute(bodies))
        throw ComputationError("the bodies' block of the viscous system is not positive definite");
    Coupling<D>& coupling = *coupling_;
    CoupledSystem<D>& system = coupling.system;
    coupling.gauge_cells.clear();
    coupling.gauge_nodes.clear();
    find_conductances(at);
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
    find_outflow(given);
}

/// Of edges, with what friction leaves of them.
template <int D>
void ViscousProjection<D>::find_conductances(const Placed<D>& at)
{
    const Grid<D>& grid = *at.coupling.grid;
    CoupledSystem<D>& system = coupling_->system;
    const auto less = [&](int edge) { return columns_.conductance(edge) * weight_[edge]; };
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), grid.high() + step<D>(axis), [&](const Index<D>& f) {
            if (const int edge = columns_.edge_of_face(axis, f); edge >= 0)
                system.conductance(axis, f) = less(edge);
        });
    system.links.clear();
    std::vector<Eigen::Triplet<double>> film;
    for (std::size_t e = 0; e < at.edges.edges.size(); ++e) {
        const auto rows = at.edges.rows_of(at.edges.edges[e]);
        const double g = less(columns_.edge_of(e));
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
}

template <int D>
void ViscousProjection<D>::find_outflow(const std::vector<int>& given)
{
    const Grid<D>& grid = *coupling_->grid;
    const CoupledSystem<D>& system = coupling_->system;
    const int fluid = columns_.twist(0);
    std::vector<char> is_given(columns_.unknowns(), 0), in_run(columns_.edges(), 0);
    for (const int row : given)
        is_given[row] = 1;
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& f) {
            const int edge = columns_.edge_of_face(axis, f);
            if (edge < 0 || f[axis] == grid.low()[axis])
                return;
            const auto high = static_cast<std::int32_t>(grid.key(f)),
                       low = static_cast<std::int32_t>(grid.key(Index<D>(f - step<D>(axis))));
            if (is_given[low] || is_given[high])
                return;
            in_run[edge] = 1;
            const double root = std::sqrt(columns_.conductance(edge));
            if (!runs_.empty() && f[0] > grid.low()[0])
                if (Run& run = runs_.back(); run.root == root && edge == run.edge + run.length && low == run.low + run.length &&
                                             high == run.high + run.length) {
                    ++run.length;
                    return;
                }
            runs_.push_back({edge, 1, low, high, root});
        });
    // Columns of the unknowns: edges and traces, then the free bodies' twists.
    std::vector<Eigen::Triplet<double>> entries;
    const auto& out = columns_.outflow();
    for (int row = 0; row < out.outerSize(); ++row)
        for (typename ViscousColumns<D>::Rows::InnerIterator entry(out, row); entry; ++entry)
            if (entry.col() < columns_.edges() && !in_run[entry.col()] && !is_given[row])
                entries.emplace_back(row, static_cast<int>(entry.col()), entry.value());
    const auto add = [&](long row, int b, const Twist<D>& flux) {
        for (int k = 0; k < twist_size<D>; ++k)
            entries.emplace_back(static_cast<int>(row), fluid + twist_size<D> * b + k, flux[k]);
    };
    for (const auto& entry : system.cell_flux)
        add(grid.key(entry.row), entry.body, entry.flux);
    const long cells = columns_.unknowns() - system.nodes;
    for (const auto& entry : system.node_flux)
        add(cells + entry.row, entry.body, entry.flux);
    for (const auto& entry : entries)
        held_by_.push_back(entry.col());
    sort_unique(held_by_);
    for (auto& entry : entries)
        entry = {entry.row(),
                 static_cast<int>(std::lower_bound(held_by_.begin(), held_by_.end(), entry.col()) - held_by_.begin()),
                 entry.value()};
    outflow_.resize(columns_.unknowns(), static_cast<int>(held_by_.size()));
    outflow_.setFromTriplets(entries.begin(), entries.end());
    held_ = outflow_.transpose();
}

template <int D>
double ViscousProjection<D>::size_of(const Vector& flow) const
{
    const typename ViscousColumns<D>::Rows& out = columns_.outflow();
    double sum = 0;
    for (int row = 0; row < out.outerSize(); ++row)
        for (typename ViscousColumns<D>::Rows::InnerIterator entry(out, row); entry; ++entry)
            sum += std::pow(entry.value() * flow[entry.col()], 2);
    return share * std::sqrt(sum);
}

template <int D>
Eigen::VectorXd ViscousProjection<D>::outflow_of(const Vector& z) const
{
    Vector few(held_by_.size());
    for (std::size_t k = 0; k < held_by_.size(); ++k)
        few[static_cast<Eigen::Index>(k)] = z[held_by_[k]];
    Vector out = outflow_ * few;
    for (const Run& run : runs_) {
        const double* flux = z.data() + run.edge;
        double *low = out.data() + run.low, *high = out.data() + run.high;
        for (std::int32_t i = 0; i < run.length; ++i)
            low[i] += run.root * flux[i];
        for (std::int32_t i = 0; i < run.length; ++i)
            high[i] -= run.root * flux[i];
    }
    return out;
}

template <int D>
void ViscousProjection<D>::take_pressure(const Vector& pressure, Vector& residual) const
{
    const Vector few = held_ * pressure;
    for (std::size_t k = 0; k < held_by_.size(); ++k)
        residual[held_by_[k]] -= few[static_cast<Eigen::Index>(k)];
    for (const Run& run : runs_) {
        double* by = residual.data() + run.edge;
        const double *low = pressure.data() + run.low, *high = pressure.data() + run.high;
        for (std::int32_t i = 0; i < run.length; ++i)
            by[i] -= run.root * (low[i] - high[i]);
    }
}

template <int D>
void ViscousProjection<D>::find_weighted(const Vector& residual, Vector& z) const
{
    const Eigen::Index edges = weight_.size(), fluid = columns_.twist(0);
    z.resize(unknowns_);
    z.head(edges) = residual.head(edges).cwiseProduct(weight_);
    if (const Eigen::Index n = unknowns_ - fluid; n > 0)
        z.tail(n) = bodies_.solve(residual.segment(fluid, n));
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
    Vector z = Vector::Zero(unknowns_), push = Vector::Zero(unknowns_);
    if (outflow.isZero(0))
        return z;
    take_pressure(-pressure_of(outflow, tolerance_), push);
    find_weighted(push, z);
    traces_.follow(Vector::Zero(push.size()), z);
    return z;
}

template <int D>
Eigen::VectorXd ViscousProjection<D>::project(Vector& residual, Vector& z, double& largest) const
{
    const Vector pulled = traces_.pull(residual);
    find_weighted(residual, z);
    const Vector outflow = outflow_of(z);
    const double size = outflow.norm();
    largest = std::max(largest, size);
    const Vector pressure = pressure_of(outflow, std::min(loosest, tolerance_ * largest / std::max(size, 1e-300)));
    take_pressure(pressure, residual);
    find_weighted(residual, z);
    traces_.release(pulled, residual);
    traces_.follow(residual, z);
    return pressure;
}

template class ViscousProjection<2>;
template class ViscousProjection<3>;

} // namespace gapflow
