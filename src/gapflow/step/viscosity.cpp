// L-stable and of second order: with gamma = 1 - 1/sqrt(2), y1 = y* - gamma dt A y1, y' = y* - (1 - gamma) dt A y1 - gamma dt A y' (R. Alexander, SIAM J. Numer. Anal. 14
// (1977) 1006-1021).
#include "gapflow/step/viscosity.hpp"

#include "gapflow/grid/side_faces.hpp"
#include "gapflow/step/covered.hpp"
#include "gapflow/step/drained.hpp"
#include "gapflow/step/inner_faces.hpp"
#include "gapflow/step/remainder.hpp"
#include "gapflow/step/viscous_solve.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace gapflow {
namespace {

const double stage_share = 1 - std::sqrt(0.5); // gamma

} // namespace

template <int D>
void fill_covered(const Placed<D>& at, FaceField<D>& velocity)
{
    const Grid<D>& grid = *at.coupling.grid;
    FaceField<D> known(grid);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            known(axis, f) = at.coupling.system.conductance(axis, f) > 0 ||
                             (!is_inner(grid, axis, f) && !is_open(grid.side(axis, f[axis] > 0)));
        });
    for (const SparseEdge<D>& edge : at.edges.edges)
        if (edge.piece >= 0 && edge.conductance > 0)
            known(at.complex.pieces[edge.piece].axis, at.complex.index.index(at.complex.pieces[edge.piece].face)) = 1;
    for (int axis = 0; axis < D; ++axis) {
        std::vector<Index<D>> left;
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            if (known(axis, f) == 0)
                left.push_back(f);
        });
        while (!left.empty()) {
            std::vector<Index<D>> next;
            std::vector<std::pair<Index<D>, double>> found;
            for (const Index<D>& f : left) {
                double sum = 0, count = 0;
                for (int d = 0; d < D; ++d)
                    for (int end = -1; end < 2; end += 2) {
                        const Index<D> g = grid.wrapped(Index<D>(f + end * step<D>(d)));
                        if ((d != axis && !grid.in_domain(g - std::max(0, g[axis] - grid.cells()[axis] + 1) * step<D>(axis))) ||
                            known(axis, g) == 0)
                            continue;
                        sum += velocity(axis, g);
                        ++count;
                    }
                if (count > 0)
                    found.emplace_back(f, sum / count);
                else
                    next.push_back(f);
            }
            for (const auto& [f, value] : found) {
                velocity(axis, f) = value;
                known(axis, f) = 1;
            }
            if (found.empty())
                break; // no fluid at all
            left = std::move(next);
        }
    }
}

template <int D>
Vec<D> mean_flux(const Grid<D>& grid, const FaceField<D>& flux)
{
    Vec<D> sum = Vec<D>::Zero();
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis),
                          [&](const Index<D>& f) { sum[axis] += flux(axis, f) * face_length(grid, axis, f); });
    return grid.face_area() / grid.size().prod() * sum;
}

namespace {

/// What is given of the form's columns, its derivatives by the others, and twice its own dissipation.
struct GivenPart {
    Eigen::VectorXd columns, rest;
    double square = 0;
};

template <int D>
GivenPart given_part(const ViscousForm<D>& form, const ViscousColumns<D>& columns, const GivenSides<D>& sides, double factor)
{
    GivenPart part{columns.given(sides), Eigen::VectorXd::Zero(columns.columns())};
    if (part.columns.isZero(0))
        return part;
    Eigen::VectorXd by(part.columns.size());
    form.product({part.columns.data(), static_cast<std::size_t>(by.size())}, {by.data(), static_cast<std::size_t>(by.size())});
    part.rest = factor * columns.from_form(by);
    part.square = factor * part.columns.dot(by);
    return part;
}

/// The two stages, linear in what they start from, what is given and in the load.
template <int D>
class ViscousStages {
public:
    using Vector = Eigen::VectorXd;

    /// `beside`: of the whole time; `outflow` is that at the end of either stage.
    ViscousStages(const ViscousColumns<D>& columns, const ViscousSolve<D>& solve, const GivenPart& given, const Vector& start,
                  const Vector& load, const GivenRows& beside)
        : columns_(columns), solve_(solve), given_(given)
    {
        const auto rows = [&](const Vector& from) { // with the rows that keep their outflow
            const Vector out = columns.outflow() * from;
            GivenRows stage{share_ * beside.pressure, Vector::Zero(out.size())};
            for (Eigen::Index k = 0; k < out.size(); ++k)
                if (!std::isnan(beside.outflow[k]))
                    stage.outflow[k] = beside.outflow[k] - out[k];
            return stage;
        };
        const bool plain = beside.pressure.size() == 0;
        const GivenRows first = plain ? GivenRows{} : rows(start);
        const auto one = solve.solve(start, share_ * load - given.rest, nullptr, plain ? nullptr : &first);
        const Vector middle = start + again_ * (one.y - start);
        const GivenRows second = plain ? GivenRows{} : rows(middle);
        const auto two = solve.solve(middle, share_ * load - given.rest, &one, plain ? nullptr : &second);
        first_ = one.y;
        end = two.y;
        pressure = again_ * one.pressure + two.pressure;
        change_ = {one.y - start, two.y - middle};
        iterations = one.iterations + two.iterations;
    }
    void add(double factor, const ViscousStages& other)
    {
        first_ += factor * other.first_;
        end += factor * other.end;
        pressure += factor * other.pressure;
        for (int k = 0; k < 2; ++k)
            change_[k] += factor * other.change_[k];
        iterations += other.iterations;
    }

    /// Of which the form's derivatives, with the viscosity and the share of the time, are its impulses.
    Vector mean() const { return again_ * first_ + end; }
    /// The same of what is given, and what the form has of both.
    Vector mean_in_form() const { return columns_.to_form(mean()) + (again_ + 1) * given_.columns; }
    double dissipated() const
    {
        const auto of = [&](const Vector& y) { return y.dot(solve_.friction(y) + 2 * given_.rest) + given_.square; };
        return again_ * of(first_) + of(end);
    }
    double work(const Vector& load) const { return share_ * load.dot(mean()); }
    double work(const GivenRows& rows) const { return -share_ * rows.pressure.dot(columns_.outflow() * mean()); }
    /// 1/2 dt^2 sum_ij (b_i a_ij + b_j a_ji - b_i b_j) k_i k_j, k_i the rates of the stages: the mixed terms vanish.
    double lost() const
    {
        const auto square = [&](Vector x) {
            x.segment(columns_.edges(), columns_.twist(0) - columns_.edges()).setZero();
            return x.dot(solve_.inertia(x));
        };
        return 0.5 * (square(change_[1]) + again_ * (2 - again_) * square(change_[0]));
    }

    Vector end, pressure;
    int iterations = 0;

private:
    const ViscousColumns<D>& columns_;
    const ViscousSolve<D>& solve_;
    const GivenPart& given_;
    double share_ = stage_share,
           again_ = (1 - stage_share) / stage_share; ///< what of the first stage's change the second one starts with
    Vector first_;
    std::array<Vector, 2> change_;
};

/// Of what acts along edges and on solids where the velocity on all faces is to change by this one: also the derivatives of its work by all columns.
template <int D>
Eigen::VectorXd push_of(const Placed<D>& at, const ViscousColumns<D>& columns, const Remainder<D>& remainder)
{
    const Grid<D>& grid = *at.coupling.grid;
    const UnknownVector<D> none{CellField<D>(grid), Eigen::VectorXd::Zero(at.coupling.system.nodes)};
    const std::vector<Twist<D>> rest(at.coupling.solids.size(), Twist<D>::Zero());
    Eigen::VectorXd push = columns.of_flow(PotentialFlow<D>{rest, none, 0, remainder});
    const std::vector<Twist<D>> carried = impulse_of_remainder(at, remainder);
    for (std::size_t s = 0; s < carried.size(); ++s)
        push.segment<twist_size<D>>(columns.twist(static_cast<int>(s))) = -carried[s];
    return push;
}

/// Of a uniform pressure gradient of -1 along an axis.
template <int D>
Eigen::VectorXd uniform_push(const Placed<D>& at, const ViscousColumns<D>& columns, int axis)
{
    FaceField<D> unit_velocity(*at.coupling.grid);
    unit_velocity[axis].fill(1 / at.coupling.density);
    return push_of(at, columns, remainder_of(at, std::move(unit_velocity)));
}

/// What given pressures and a mean gradient add to the velocity on faces. Pressures act in the sides' own faces, over the half cells within.
template <int D>
FaceField<D> driven_velocity(const Grid<D>& grid, double density, const Vec<D>& drive, const std::array<double, 2 * D>& sides)
{
    FaceField<D> velocity(grid);
    for (int axis = 0; axis < D; ++axis)
        velocity[axis].fill(drive[axis] / density);
    for (int side = 0; side < 2 * D; ++side)
        if (sides[side] != 0)
            for_each_face_of_side(grid, side / 2, side % 2, [&](const Index<D>& f) {
                velocity(side / 2, f) += (side % 2 ? -1 : 1) * sides[side] / (density * face_length(grid, side / 2, f));
            });
    return velocity;
}

/// The solids' part of the form's derivatives: impulses of friction, of all of the form and of its gaps.
template <int D>
Friction<D> friction_of(const ViscousForm<D>& form, const Eigen::VectorXd& x, const Eigen::VectorXd& by_form, double factor,
                        double dx)
{
    Eigen::VectorXd by_gaps = Eigen::VectorXd::Zero(x.size());
    form.squares.add_product({x.data(), static_cast<std::size_t>(x.size())},
                             {by_gaps.data(), static_cast<std::size_t>(by_gaps.size())}, form.gap_rows[0], form.gap_rows[1]);
    by_gaps *= factor;
    const auto impulses = [&](const Eigen::VectorXd& by) {
        std::vector<Twist<D>> result;
        for (int s = 0; s < form.solids; ++s) {
            result.push_back(-by.segment<twist_size<D>>(form.twist_column(s, 0)));
            result.back().template tail<spin_size<D>>() *= dx;
        }
        return result;
    };
    return {impulses(by_form - by_gaps), impulses(by_gaps)};
}

/// What the remainder loses along the edges to friction: what the momenta change by beside the pressure and what drives. (The form's derivatives are the same to the
/// solver's tolerance, but in a sliver of a face they are round-off times the square of its width's inverse.)
template <int D>
Eigen::VectorXd slowed_along_edges(const Placed<D>& at, const ViscousColumns<D>& columns, const ViscousStages<D>& stages,
                                   const Eigen::VectorXd& start, const Remainder<D>& driven)
{
    const std::vector<Twist<D>> rest(at.coupling.solids.size(), Twist<D>::Zero());
    const Eigen::VectorXd without =
        columns.of_flow(PotentialFlow<D>{rest, columns.to_unknowns(-stages.pressure), 0, driven}) - (stages.end - start);
    Eigen::VectorXd slowed = Eigen::VectorXd::Zero(columns.edges());
    for (int edge = 0; edge < columns.edges(); ++edge)
        if (const double g = columns.conductance(edge); g > 0)
            slowed[edge] = without[edge] / (std::sqrt(g) * at.coupling.density);
    return slowed;
}

/// The flow after the stages, and what they do to the solids.
template <int D>
void take_end(const Placed<D>& at, const ViscousForm<D>& form, const ViscousColumns<D>& columns, const ViscousStages<D>& stages,
              double factor, const Eigen::VectorXd& start, const Remainder<D>& driven, PotentialFlow<D>& flow,
              ViscousStep<D>& result)
{
    constexpr int T = twist_size<D>;
    const Coupling<D>& coupling = at.coupling;
    const Grid<D>& grid = *coupling.grid;
    const Eigen::VectorXd x = stages.mean_in_form();
    Eigen::VectorXd by_form(x.size());
    form.product({x.data(), static_cast<std::size_t>(x.size())}, {by_form.data(), static_cast<std::size_t>(by_form.size())});
    by_form *= factor;
    const Eigen::VectorXd slowed = slowed_along_edges(at, columns, stages, start, driven);
    PotentialFlow<D> by{{}, columns.to_unknowns(stages.pressure), 0, {}};
    for (std::size_t s = 0; s < flow.twists.size(); ++s)
        by.twists.push_back(stages.end.template segment<T>(columns.twist(static_cast<int>(s))) - flow.twists[s]);

    // On the solids - (B dV + K^T lambda) and friction on their walls and, by k, on the edges.
    result.impulse = fluid_impulse(at, PotentialFlow<D>{by.twists, by.p, 0, {}}); // B dV - K^T lambda
    const std::vector<Twist<D>> pressed = impulses(coupling, by.p), pushed = impulse_of_remainder(at, driven);
    result.friction = friction_of(form, x, by_form, factor, grid.dx());
    for (std::size_t s = 0; s < flow.twists.size(); ++s)
        result.impulse[s] =
            -(result.impulse[s] + 2 * pressed[s]) + result.friction.bulk[s] + result.friction.gaps[s] - pushed[s];
    for (const CarriedFlux<D>& of : at.edges.carried)
        if (const int edge = of.axis >= 0 ? columns.edge_of_face(of.axis, of.face) : columns.edge_of(of.edge); edge >= 0)
            result.impulse[of.solid] -= coupling.density * slowed[edge] * of.flux;

    FaceField<D>& w = flow.remainder.faces;
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            w(axis, f) += driven.faces(axis, f);
            if (const int edge = columns.edge_of_face(axis, f); edge >= 0)
                w(axis, f) -= slowed[edge] / face_length(grid, axis, f);
        });
    for (std::size_t e = 0; e < flow.remainder.edges.size(); ++e)
        flow.remainder.edges[e] += driven.edges[e] - slowed[columns.edge_of(e)];
    for (const VoidEdge<D>& edge : at.voids.edges) // momenta of their own
        flow.remainder.edges[edge.edge] += slowed[columns.edge_of(edge.edge)] - driven.edges[edge.edge];
    for (long i = 0; i < flow.p.cells.size(); ++i)
        flow.p.cells.data()[i] -= by.p.cells.data()[i];
    flow.p.nodes -= by.p.nodes;
    exchange(grid, w);
    for (std::size_t s = 0; s < flow.twists.size(); ++s)
        flow.twists[s] += by.twists[s];
}

/// The same rows with no pressure, and outflows of 0 where they are given.
GivenRows no_given_rows(const GivenRows& rows)
{
    GivenRows none = rows;
    none.pressure.setZero();
    none.outflow *= 0;
    return none;
}

/// Voids in the columns: their edges' momenta, and what they give to rows. The rows' outflow is NaN where it stays.
template <int D>
GivenRows take_voids(const Placed<D>& at, const ViscousColumns<D>& columns, const ViscousVoids<D>& voids,
                     Eigen::VectorXd& start)
{
    for (std::size_t e = 0; e < voids.momentum.size(); ++e) {
        const int edge = columns.edge_of(at.voids.edges[e].edge);
        start[edge] = std::sqrt(columns.conductance(edge)) * voids.momentum[e];
    }
    GivenRows rows;
    if (voids.given.empty() && voids.outflow.empty())
        return rows;
    rows.pressure = Eigen::VectorXd::Zero(columns.unknowns());
    rows.outflow = Eigen::VectorXd::Constant(columns.unknowns(), std::numeric_limits<double>::quiet_NaN());
    for (const auto& [row, gain] : voids.given)
        rows.pressure[row] = -gain;
    for (const auto& [row, outflow] : voids.outflow)
        rows.outflow[row] = outflow;
    return rows;
}

} // namespace

template <int D>
ViscousStep<D> add_viscosity(const Placed<D>& at, const std::vector<TwistMatrix<D>>& mass, const ViscousLoads<D>& loads,
                             double viscosity, double dt, double tolerance, PotentialFlow<D>& flow, ViscousVoids<D>* voids)
{
    const double factor = viscosity * std::pow(at.coupling.grid->dx(), D - 2) * stage_share * dt,
                 volume = at.coupling.grid->size().prod();
    std::shared_ptr<const ViscousForm<D>> form = at.viscous;
    if (voids && (!at.voids.edges.empty() || !voids->given.empty()))
        form = std::make_shared<const ViscousForm<D>>(
            drained_form(at, *form, ViscousColumns<D>(at, *form).filled(), voids->given));
    const ViscousColumns<D> columns(at, *form);
    std::vector<int> free_rows;
    if (voids)
        for (const auto& [row, gain] : voids->given)
            free_rows.push_back(static_cast<int>(row));
    const ViscousSolve<D> solve(at, columns, mass, factor, tolerance, viscous_method<D>, free_rows);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(columns.columns());
    for (std::size_t s = 0; s < loads.impulse.size(); ++s)
        load.segment<twist_size<D>>(columns.twist(static_cast<int>(s))) = loads.impulse[s];
    ViscousStep<D> result;
    result.gradient = loads.gradient;
    std::vector<std::pair<int, Eigen::VectorXd>> kept;
    for (int axis = 0; axis < D; ++axis)
        if (loads.mean_velocity[axis])
            kept.emplace_back(axis, uniform_push(at, columns, axis));
    Vec<D> given = -dt * loads.gradient;
    for (const auto& [axis, push] : kept)
        given[axis] = 0;
    const FaceField<D> pushed = driven_velocity(*at.coupling.grid, at.coupling.density, given, loads.sides);
    load += push_of(at, columns, remainder_of(at, pushed));
    const GivenPart sides = given_part(*form, columns, flow.sides, factor),
                    nothing{Eigen::VectorXd::Zero(sides.columns.size()), Eigen::VectorXd::Zero(columns.columns())};
    Eigen::VectorXd start = columns.of_flow(flow);
    const GivenRows rows = voids ? take_voids(at, columns, *voids, start) : GivenRows{};
    ViscousStages<D> stages(columns, solve, sides, start, load, rows);
    if (!kept.empty()) { // the gradient with which the mean velocities are those
        const int n = static_cast<int>(kept.size());
        std::vector<ViscousStages<D>> answers;
        Eigen::MatrixXd response(n, n);
        Eigen::VectorXd missing(n);
        for (int k = 0; k < n; ++k) {
            answers.emplace_back(columns, solve, nothing, Eigen::VectorXd::Zero(columns.columns()), kept[k].second,
                                 no_given_rows(rows));
            missing[k] = *loads.mean_velocity[kept[k].first] * volume - kept[k].second.dot(stages.end);
        }
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < n; ++k)
                response(i, k) = kept[i].second.dot(answers[k].end);
        const Eigen::VectorXd impulse = response.ldlt().solve(missing);
        for (int k = 0; k < n; ++k) {
            stages.add(impulse[k], answers[k]);
            result.gradient[kept[k].first] = -impulse[k] / dt;
        }
    }
    result.iterations = stages.iterations;
    result.dissipated = stages.dissipated();
    result.lost = stages.lost();
    result.work = stages.work(load);
    const Remainder<D> driven =
        remainder_of(at, driven_velocity(*at.coupling.grid, at.coupling.density, Vec<D>(-dt * result.gradient), loads.sides));
    take_end(at, *form, columns, stages, factor, start, driven, flow, result);
    if (voids && rows.pressure.size() > 0)
        voids->work = stages.work(rows);
    if (voids)
        for (std::size_t e = 0; e < voids->momentum.size(); ++e)
            if (const int edge = columns.edge_of(at.voids.edges[e].edge); columns.conductance(edge) > 0)
                voids->momentum[e] = stages.end[edge] / std::sqrt(columns.conductance(edge));
    return result;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void fill_covered<D>(const Placed<D>&, FaceField<D>&);                                                            \
    template ViscousStep<D> add_viscosity<D>(const Placed<D>&, const std::vector<TwistMatrix<D>>&, const ViscousLoads<D>&,     \
                                             double, double, double, PotentialFlow<D>&, ViscousVoids<D>*);                     \
    template Vec<D> mean_flux<D>(const Grid<D>&, const FaceField<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
