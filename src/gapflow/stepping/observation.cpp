#include "gapflow/stepping/observation.hpp"

#include "gapflow/stepping/drive.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/coupling/film_drag.hpp"
#include "gapflow/grid/side_faces.hpp"
#include "gapflow/stepping/flooding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

template <int D>
UnknownVector<D> reduced_pressure(const State<D>& state)
{
    UnknownVector<D> p = state.pressure.impulse;
    const double scale = state.dt > 0 ? 1 / state.dt : 0.0;
    for (long i = 0; i < p.cells.size(); ++i)
        p.cells.data()[i] *= scale;
    p.nodes *= scale;
    return p;
}

template <int D>
std::vector<GapState> gap_states(const Model<D>& model, const Coupling<D>& here, const State<D>& state)
{
    const Eigen::VectorXd node_pressure = state.pressure.impulse.nodes * (state.dt > 0 ? 1 / state.dt : 0.0);
    const std::vector<Twist<D>> V = model.twists(state.bodies);
    std::map<std::pair<int, int>, GapState> states;
    for (const Film<D>& film : here.network.films) {
        const FilmMesh<D>& mesh = film.mesh;
        const int a = std::min(mesh.master, mesh.other), b = std::max(mesh.master, mesh.other);
        auto [it, is_new] = states.try_emplace({a, b});
        GapState& gap = it->second;
        if (is_new) {
            gap.body_a = here.solids[a].name;
            gap.body_b = here.solids[b].name;
            gap.thickness = std::numeric_limits<double>::infinity();
            gap.pressure_min = std::numeric_limits<double>::infinity();
            gap.pressure_max = -std::numeric_limits<double>::infinity();
        }
        gap.film_nodes += static_cast<int>(mesh.h.size());
        const PlacedShape<D> other = here.solids[mesh.other].shape.shifted(mesh.shift);
        const double least = *std::min_element(mesh.h.begin(), mesh.h.end());
        for (std::size_t i = 0; i < mesh.h.size(); ++i) {
            if (mesh.h[i] != least) // h is not less than the roughness: of all nodes at it the closest
                continue;
            const SurfacePoint<D> closest = other.closest(mesh.x[i]);
            if (closest.distance >= gap.thickness)
                continue;
            gap.thickness = closest.distance;
            gap.opening_rate =
                closest.normal.dot(velocity_at<D>(V[mesh.master], mesh.x[i] - here.solids[mesh.master].centre) -
                                   velocity_at<D>(V[mesh.other], closest.x - here.solids[mesh.other].centre - mesh.shift));
        }
        std::vector<double> pressure(mesh.h.size());
        for (std::size_t i = 0; i < pressure.size(); ++i) {
            pressure[i] = node_pressure[film.first_node + static_cast<int>(i)] + model.hydrostatic(mesh.mid[i]);
            gap.pressure_min = std::min(gap.pressure_min, pressure[i]);
            gap.pressure_max = std::max(gap.pressure_max, pressure[i]);
        }
        for (std::size_t i = 0; i < mesh.h.size(); ++i)
            gap.void_volume += state.voids.volume()[film.first_node + i];
        for (const FilmElement<D>& e : mesh.elements) {
            double mean = 0;
            for (int node : e.nodes)
                mean += pressure[node] / D;
            gap.force += mean * e.measure;
            gap.film_area += e.measure;
        }
    }
    for (const Contact<D>& contact : state.contacts.contacts()) {
        if (!contact.closed)
            continue;
        auto [it, is_new] = states.try_emplace({contact.point.a, contact.point.b});
        GapState& gap = it->second;
        if (is_new) {
            gap.body_a = here.solids[contact.point.a].name;
            gap.body_b = here.solids[contact.point.b].name;
            gap.thickness = std::numeric_limits<double>::infinity();
        }
        if (contact.point.distance < gap.thickness) {
            gap.thickness = contact.point.distance;
            gap.opening_rate = contact.normal.a.dot(V[contact.point.a]) + contact.normal.b.dot(V[contact.point.b]);
        }
        gap.contact_impulse += contact.impulse;
        gap.contact_force += contact.impulse / state.dt;
    }
    std::vector<GapState> result;
    for (const auto& [pair, gap] : states)
        result.push_back(gap);
    return result;
}

namespace {

/// Momentum, angular momentum, energy.
template <int D>
using Sums = Eigen::Matrix<double, D + spin_size<D> + 1, 1>;

// Of faces in a water level, which count as others for a whole cell, the half that is above: as heavy as the rest is what a pressure moves there.
template <int D>
Sums<D> above_water(const Model<D>& model, const Coupling<D>& here, const FaceField<D>& velocity, const Vec<D>& about)
{
    const Grid<D>& grid = model.grid;
    Sums<D> sums = Sums<D>::Zero();
    for (int side = 0; side < 2 * D; ++side) {
        const int axis = side / 2;
        if (model.scene.sides[side].kind != SideScene::Kind::surface)
            continue;
        for_each_face_of_side<D>(grid, axis, side % 2, [&](const Index<D>& f) {
            if (!(here.system.conductance(axis, f) > 0))
                return;
            const double u = velocity(axis, f), mass = 0.5 * model.scene.density * std::pow(grid.dx(), D) * here.open(axis, f) *
                                                       grid.spread(axis, f[axis]);
            const int cut = here.fractions->cut(axis, f);
            const Vec<D> x = cut >= 0 ? here.fractions->faces[cut].open_centroid : grid.face_centre(axis, f);
            const Vec<D> momentum = mass * u * unit<D>(axis);
            sums.template head<D>() += momentum;
            sums.template segment<spin_size<D>>(D) += moment<D>(x - about, momentum);
            sums[D + spin_size<D>] += 0.5 * mass * u * u;
        });
    }
    return sums;
}

} // namespace

template <int D>
Budget<D> budget(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V)
{
    const Grid<D>& grid = model.grid;
    const double rho = model.scene.density, cell = std::pow(grid.dx(), D);
    const Vec<D> about = to_vec<D>(model.scene.origin); // a point of the world, also if the grid moves
    Sums<D> sums = Sums<D>::Zero();
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> low = grid.low(), end = owned_faces_end(grid, axis);
        const int n = end[0] - low[0];
        auto of_plane = [&](int plane) {
            Sums<D> sum = Sums<D>::Zero();
            for_each_row_of_plane<D>(low, end, plane, [&](const Index<D>& row) {
                const double *conductance = &here.system.conductance(axis, row), *open = &here.open(axis, row),
                             *u = &state.velocity.grid(axis, row);
                const int* cut = &here.fractions->cut(axis, row);
                double flow = 0, along = 0,
                       square = 0; // sums of a u, x / dx a u, a u^2; outside the core times the faces' spread
                int cuts = 0;
                const SpreadRow<D> spread(grid, axis, row);
                const double first = grid.face_centre(axis, row)[0];
                Index<D> at = row;
                for (int i = 0; i < n && grid.graded(); ++i, ++at[0]) {
                    const double au = conductance[i] > 0 ? open[i] * spread[i] * u[i] : 0.0;
                    flow += au;
                    along += (grid.face_centre(axis, at)[0] - first) / grid.dx() * au;
                    square += au * u[i];
                    cuts += cut[i] >= 0 ? 1 : 0;
                }
                const int plain = grid.graded() ? 0 : n;
#pragma omp simd reduction(+ : flow, along, square, cuts)
                for (int i = 0; i < plain; ++i) {
                    const double au = conductance[i] > 0 ? open[i] * u[i] : 0.0;
                    flow += au;
                    along += i * au;
                    square += au * u[i];
                    cuts += cut[i] >= 0 ? 1 : 0;
                }
                const Vec<D> direction = rho * cell * unit<D>(axis);
                Spin<D> angular = moment<D>(grid.face_centre(axis, row) - about, Vec<D>(flow * direction)) +
                                  moment<D>(grid.dx() * unit<D>(0), Vec<D>(along * direction));
                Index<D> f = row;
                for (int i = 0; i < n && cuts > 0; ++i, ++f[0])
                    if (cut[i] >= 0 && conductance[i] > 0)
                        angular += moment<D>(here.fractions->faces[cut[i]].open_centroid - grid.face_centre(axis, f),
                                             Vec<D>(open[i] * spread[i] * u[i] * direction));
                sum.template head<D>() += flow * direction;
                sum.template segment<spin_size<D>>(D) += angular;
                sum[D + spin_size<D>] += 0.5 * rho * cell * square;
            });
            return sum;
        };
        for (const Sums<D>& sum : each_plane(low[D - 1], end[D - 1], of_plane))
            sums += sum;
    }
    sums -= above_water(model, here, state.velocity.grid, about);
    std::vector<double> of_all_ranks(sums.begin(), sums.end());
    grid.comm().sum(of_all_ranks);
    std::copy(of_all_ranks.begin(), of_all_ranks.end(), sums.begin());
    Budget<D> budget;
    budget.momentum = sums.template head<D>();
    budget.angular_momentum = sums.template segment<spin_size<D>>(D);
    budget.energy_grid = sums[D + spin_size<D>];

    auto add = [&](const Vec<D>& momentum, const Vec<D>& x) {
        budget.momentum += momentum;
        budget.angular_momentum += moment<D>(x - about, momentum);
    };
    const std::vector<double> normal = wall_normal_speed<D>(here.network, here.solids, V);
    for (const Film<D>& film : here.network.films)
        for (std::size_t e = 0; e < film.mesh.elements.size(); ++e) {
            const FilmElement<D>& element = film.mesh.elements[e];
            const std::size_t i = film.first_element + e;
            const Vec<D> w = state.velocity.film[i] + normal[i] * element.normal;
            add(rho * element.volume * w, element.centroid);
            budget.energy_film += 0.5 * rho * element.volume * w.squaredNorm();
        }
    const std::vector<Mouth<D>>& mouths = here.network.rim.mouths;
    for (std::size_t r = 0; r < mouths.size(); ++r) {
        const Mouth<D>& mouth = mouths[r];
        const double q = state.velocity.mouth[r];
        add(rho * mouth.resistance * q * mouth.section, mouth.x);
        budget.energy_film += 0.5 * rho * mouth.resistance * q * q / mouth.length;
    }
    for (const RigidBody<D>& body : state.bodies)
        if (body.motion == Motion::free) {
            const Twist<D> m = momentum(body);
            budget.momentum += m.template head<D>();
            budget.angular_momentum += angular_momentum_about(body, about);
            budget.energy_bodies += kinetic_energy(body) + spring_energy(body);
        }
    return budget;
}

template <int D>
UnknownVector<D> net_outflow(const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V)
{
    UnknownVector<D> rest;
    const std::vector<char>& shut = state.voids.shut();
    const bool any_shut = std::find(shut.begin(), shut.end(), 1) != shut.end();
    if (here.element_drag.empty() && !any_shut) {
        outflow(here, state.velocity, V, rest);
    } else { // the walls' entrainment is in K, shut mouths are not
        FluidVelocity<D> driven = state.velocity;
        add_entrainment(here, V, -1, driven);
        for (std::size_t r = 0; r < shut.size(); ++r)
            if (shut[r])
                driven.mouth[r] += entrained_flux(here, r, V) - carried_flux<D>(here, here.network.rim.mouths[r], V);
        outflow(here, driven, V, rest);
    }
    if (state.node_outflow.size() > 0) { // velocities at a void's front have changed since
        rest.nodes =
            state.node_outflow - Eigen::Map<const Eigen::VectorXd>(state.voids.growth().data(), state.node_outflow.size());
    } else {
        // Joints keep no flux of their own: it is the flux of the last projection.
        const std::vector<Link>& links = here.system.links;
        for (std::size_t r = here.network.rim.mouths.size(); r < links.size() && here.network.nodes > 0; ++r) {
            double drop = 0;
            for (const auto& [node, weight] : links[r].nodes)
                drop += weight * state.pressure.impulse.nodes[node];
            for (const auto& [node, weight] : links[r].nodes)
                rest.nodes[node] += links[r].conductance * weight * drop;
        }
    }
    return rest;
}

template <int D>
void report_state(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V,
                  StepReport& report)
{
    const Grid<D>& grid = model.grid;
    report.step = state.steps;
    report.time = state.time;
    report.dt = state.dt;
    for (const Component& component : here.system.components)
        report.cells += component.unknowns;
    report.film_nodes = here.network.nodes;
    report.cells -= report.film_nodes;
    const Budget<D> sums = budget(model, here, state, V);
    report.energy_fluid = sums.energy_grid + sums.energy_film;
    report.energy_bodies = sums.energy_bodies;
    if (model.driven()) {
        const Vec<D> flow = mean_velocity(model, here, state, V);
        double* const gradients[] = {&report.pressure_gradient_x, &report.pressure_gradient_y, &report.pressure_gradient_z};
        double* const flows[] = {&report.mean_velocity_x, &report.mean_velocity_y, &report.mean_velocity_z};
        for (int axis = 0; axis < D; ++axis) {
            *gradients[axis] = state.drive.gradient[axis];
            *flows[axis] = flow[axis];
        }
    }
    if (state.dt > 0)
        report.dissipation_film = film_loss(here, V, state.velocity) / state.dt;
    UnknownVector<D> rest = net_outflow(here, state, V);
    double worst = rest.nodes.size() ? rest.nodes.cwiseAbs().maxCoeff() : 0.0;
    worst = std::max(worst, max_over_planes(grid.low()[D - 1], grid.high()[D - 1], [&](int plane) {
                         double largest = 0;
                         for_each_row_of_plane<D>(grid.low(), grid.high(), plane, [&](const Index<D>& row) {
                             double* value = &rest.cells(row);
                             Index<D> c = row;
                             for (int i = 0; i < grid.high()[0] - grid.low()[0] && grid.graded(); ++i, ++c[0])
                                 value[i] /= grid.relative_volume(c);
#pragma omp simd reduction(max : largest)
                             for (int i = 0; i < grid.high()[0] - grid.low()[0]; ++i)
                                 largest = std::max(largest, std::abs(value[i]));
                         });
                         return largest;
                     }));
    report.divergence_max = grid.comm().max(worst) / std::pow(grid.dx(), D);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template UnknownVector<D> reduced_pressure<D>(const State<D>&);                                                            \
    template std::vector<GapState> gap_states<D>(const Model<D>&, const Coupling<D>&, const State<D>&);                        \
    template Budget<D> budget<D>(const Model<D>&, const Coupling<D>&, const State<D>&, const std::vector<Twist<D>>&);          \
    template UnknownVector<D> net_outflow<D>(const Coupling<D>&, const State<D>&, const std::vector<Twist<D>>&);               \
    template void report_state<D>(const Model<D>&, const Coupling<D>&, const State<D>&, const std::vector<Twist<D>>&,          \
                                  StepReport&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
