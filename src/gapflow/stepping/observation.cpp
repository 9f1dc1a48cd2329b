// What a simulation reports of its state: pressure, gaps, momentum and energy. Reads the state, never changes it.
#include "gapflow/stepping/simulation.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/coupling/film_drag.hpp"
#include "gapflow/stepping/flooding.hpp"
#include "gapflow/stepping/gap_notes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

template <int D>
UnknownVector<D> Simulation<D>::reduced_pressure() const
{
    UnknownVector<D> p = impulse_;
    const double scale = dt_ > 0 ? 1 / dt_ : 0.0;
    for (long i = 0; i < p.cells.size(); ++i)
        p.cells.data()[i] *= scale;
    p.nodes *= scale;
    return p;
}

// rho g . (x - x0), x0 the highest point of the open sides, where the pressure is the reference pressure.
template <int D>
double Simulation<D>::hydrostatic(const Vec<D>& x) const
{
    const Vec<D> g = to_vec<D>(scene_.gravity);
    double highest = -std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < (1 << D); ++corner) {
        Vec<D> place;
        bool open = false;
        for (int axis = 0; axis < D; ++axis) {
            const int end = corner >> axis & 1;
            place[axis] = grid_.origin()[axis] + end * grid_.size()[axis];
            open = open || grid_.side(axis, end) == SideKind::open;
        }
        if (open)
            highest = std::max(highest, -g.dot(place));
    }
    const double level = std::isfinite(highest) ? scene_.density * highest + scene_.reference_pressure : 0.0;
    return scene_.density * g.dot(x) + level;
}

template <int D>
std::vector<GapState> Simulation<D>::gaps() const
{
    const Coupling<D>& c = *coupling_;
    const Eigen::VectorXd node_pressure = impulse_.nodes * (dt_ > 0 ? 1 / dt_ : 0.0);
    const std::vector<Twist<D>> V = twists();
    std::map<std::pair<int, int>, GapState> states;
    for (const Film<D>& film : c.network.films) {
        const FilmMesh<D>& mesh = film.mesh;
        const int a = std::min(mesh.master, mesh.other), b = std::max(mesh.master, mesh.other);
        auto [it, is_new] = states.try_emplace({a, b});
        GapState& gap = it->second;
        if (is_new) {
            gap.body_a = c.solids[a].name;
            gap.body_b = c.solids[b].name;
            gap.thickness = std::numeric_limits<double>::infinity();
            gap.pressure_min = std::numeric_limits<double>::infinity();
            gap.pressure_max = -std::numeric_limits<double>::infinity();
        }
        gap.film_nodes += static_cast<int>(mesh.h.size());
        const PlacedShape<D> other = c.solids[mesh.other].shape.shifted(mesh.shift);
        const std::size_t thinnest = std::min_element(mesh.h.begin(), mesh.h.end()) - mesh.h.begin();
        const SurfacePoint<D> closest = other.closest(mesh.x[thinnest]);
        if (closest.distance < gap.thickness) {
            gap.thickness = closest.distance;
            gap.opening_rate =
                closest.normal.dot(velocity_at<D>(V[mesh.master], mesh.x[thinnest] - c.solids[mesh.master].centre) -
                                   velocity_at<D>(V[mesh.other], closest.x - c.solids[mesh.other].centre - mesh.shift));
        }
        std::vector<double> pressure(mesh.h.size());
        for (std::size_t i = 0; i < pressure.size(); ++i) {
            pressure[i] = node_pressure[film.first_node + static_cast<int>(i)] + hydrostatic(mesh.mid[i]);
            gap.pressure_min = std::min(gap.pressure_min, pressure[i]);
            gap.pressure_max = std::max(gap.pressure_max, pressure[i]);
        }
        for (std::size_t i = 0; i < mesh.h.size(); ++i)
            gap.void_volume += voids_.volume()[film.first_node + i];
        for (const FilmElement<D>& e : mesh.elements) {
            double mean = 0;
            for (int node : e.nodes)
                mean += pressure[node] / D;
            gap.force += mean * e.measure;
            gap.film_area += e.measure;
        }
    }
    for (const Contact<D>& contact : contacts_.contacts()) {
        if (!contact.closed)
            continue;
        auto [it, is_new] = states.try_emplace({contact.point.a, contact.point.b});
        GapState& gap = it->second;
        if (is_new) {
            gap.body_a = c.solids[contact.point.a].name;
            gap.body_b = c.solids[contact.point.b].name;
            gap.thickness = std::numeric_limits<double>::infinity();
        }
        if (contact.point.distance < gap.thickness) {
            gap.thickness = contact.point.distance;
            gap.opening_rate = contact.normal.a.dot(V[contact.point.a]) + contact.normal.b.dot(V[contact.point.b]);
        }
        gap.contact_impulse += contact.impulse;
        gap.contact_force += contact.impulse / dt_;
    }
    std::vector<GapState> result;
    for (const auto& [pair, gap] : states)
        result.push_back(gap);
    return result;
}

template <int D>
Budget<D> Simulation<D>::budget() const
{
    const Coupling<D>& c = *coupling_;
    const double rho = scene_.density, cell = std::pow(grid_.dx(), D);
    using Sums = Eigen::Matrix<double, D + spin_size<D> + 1, 1>; // momentum, angular momentum, energy
    Sums sums = Sums::Zero();
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> low = grid_.low(), end = owned_faces_end(grid_, axis);
        const int n = end[0] - low[0];
        auto of_plane = [&](int plane) {
            Sums sum = Sums::Zero();
            for_each_row_of_plane<D>(low, end, plane, [&](const Index<D>& row) {
                const double *conductance = &c.system.conductance(axis, row), *open = &c.open(axis, row),
                             *u = &velocity_.grid(axis, row);
                const int* cut = &c.fractions->cut(axis, row);
                double flow = 0, along = 0, square = 0; // sums of a u, i a u, a u^2
                int cuts = 0;
#pragma omp simd reduction(+ : flow, along, square, cuts)
                for (int i = 0; i < n; ++i) {
                    const double au = conductance[i] > 0 ? open[i] * u[i] : 0.0;
                    flow += au;
                    along += i * au;
                    square += au * u[i];
                    cuts += cut[i] >= 0 ? 1 : 0;
                }
                const Vec<D> direction = rho * cell * unit<D>(axis);
                Spin<D> angular = moment<D>(grid_.face_centre(axis, row) - grid_.origin(), Vec<D>(flow * direction)) +
                                  moment<D>(grid_.dx() * unit<D>(0), Vec<D>(along * direction));
                Index<D> f = row;
                for (int i = 0; i < n && cuts > 0; ++i, ++f[0])
                    if (cut[i] >= 0 && conductance[i] > 0)
                        angular += moment<D>(c.fractions->faces[cut[i]].open_centroid - grid_.face_centre(axis, f),
                                             Vec<D>(open[i] * u[i] * direction));
                sum.template head<D>() += flow * direction;
                sum.template segment<spin_size<D>>(D) += angular;
                sum[D + spin_size<D>] += 0.5 * rho * cell * square;
            });
            return sum;
        };
        for (const Sums& sum : each_plane(low[D - 1], end[D - 1], of_plane))
            sums += sum;
    }
    std::vector<double> of_all_ranks(sums.begin(), sums.end());
    grid_.comm().sum(of_all_ranks);
    std::copy(of_all_ranks.begin(), of_all_ranks.end(), sums.begin());
    Budget<D> budget;
    budget.momentum = sums.template head<D>();
    budget.angular_momentum = sums.template segment<spin_size<D>>(D);
    budget.energy_grid = sums[D + spin_size<D>];

    auto add = [&](const Vec<D>& momentum, const Vec<D>& x) {
        budget.momentum += momentum;
        budget.angular_momentum += moment<D>(x - grid_.origin(), momentum);
    };
    const std::vector<double> normal = wall_normal_speed<D>(c.network, c.solids, twists());
    for (const Film<D>& film : c.network.films)
        for (std::size_t e = 0; e < film.mesh.elements.size(); ++e) {
            const FilmElement<D>& element = film.mesh.elements[e];
            const std::size_t i = film.first_element + e;
            const Vec<D> w = velocity_.film[i] + normal[i] * element.normal;
            add(rho * element.volume * w, element.centroid);
            budget.energy_film += 0.5 * rho * element.volume * w.squaredNorm();
        }
    const std::vector<Conduit<D>>& conduits = c.network.mouths.conduits;
    for (std::size_t r = 0; r < conduits.size(); ++r) {
        const Conduit<D>& conduit = conduits[r];
        const double q = velocity_.conduit[r];
        add(rho * conduit.resistance * conduit.h * q * conduit.outward, conduit.x);
        budget.energy_film += 0.5 * rho * conduit.resistance * q * q / conduit.length;
    }
    for (const RigidBody<D>& body : bodies_)
        if (body.motion == Motion::free) {
            const Twist<D> m = momentum(body);
            budget.momentum += m.template head<D>();
            budget.angular_momentum += angular_momentum_about(body, grid_.origin());
            budget.energy_bodies += kinetic_energy(body) + spring_energy(body);
        }
    return budget;
}

template <int D>
void Simulation<D>::finish_report(StepReport& report, double dt)
{
    report.step = steps_;
    report.time = time_;
    report.dt = dt;
    for (const Component& component : coupling_->system.components)
        report.cells += component.unknowns;
    report.film_nodes = coupling_->network.nodes;
    report.cells -= report.film_nodes;
    const Budget<D> sums = budget();
    report.energy_fluid = sums.energy_grid + sums.energy_film;
    report.energy_bodies = sums.energy_bodies;
    if (dt > 0)
        report.dissipation_film = film_loss(*coupling_, twists(), velocity_) / dt;
    UnknownVector<D> rest;
    const std::vector<char>& shut = voids_.shut();
    const bool any_shut = std::find(shut.begin(), shut.end(), 1) != shut.end();
    if (coupling_->element_drag.empty() && !any_shut) {
        outflow(*coupling_, velocity_, twists(), rest);
    } else { // the walls' entrainment is in K, shut mouths are not
        FluidVelocity<D> driven = velocity_;
        add_entrainment(*coupling_, twists(), -1, driven);
        for (std::size_t r = 0; r < shut.size(); ++r)
            if (shut[r])
                driven.conduit[r] += entrained_flux(*coupling_, r, twists()) -
                                     carried_flux<D>(*coupling_, coupling_->network.mouths.conduits[r], twists());
        outflow(*coupling_, driven, twists(), rest);
    }
    if (node_outflow_.size() > 0) { // velocities at a void's front have moved on since
        rest.nodes = node_outflow_ - Eigen::Map<const Eigen::VectorXd>(voids_.growth().data(), node_outflow_.size());
    } else {
        // Joints keep no flux of their own: it is what the last projection drove through them.
        const std::vector<Link>& links = coupling_->system.links;
        for (std::size_t r = coupling_->network.mouths.conduits.size(); r < links.size(); ++r) {
            double drop = 0;
            for (const auto& [node, weight] : links[r].nodes)
                drop += weight * impulse_.nodes[node];
            for (const auto& [node, weight] : links[r].nodes)
                rest.nodes[node] += links[r].conductance * weight * drop;
        }
    }
    double worst = rest.nodes.size() ? rest.nodes.cwiseAbs().maxCoeff() : 0.0;
    worst = std::max(worst, max_over_planes(grid_.low()[D - 1], grid_.high()[D - 1], [&](int plane) {
                         double largest = 0;
                         for_each_row_of_plane<D>(grid_.low(), grid_.high(), plane, [&](const Index<D>& row) {
                             const double* value = &rest.cells(row);
#pragma omp simd reduction(max : largest)
                             for (int i = 0; i < grid_.high()[0] - grid_.low()[0]; ++i)
                                 largest = std::max(largest, std::abs(value[i]));
                         });
                         return largest;
                     }));
    report.divergence_max = grid_.comm().max(worst) / std::pow(grid_.dx(), D);
    for (std::string& note : blind_end_notes(*coupling_, blind_told_))
        report.notes.push_back(std::move(note));
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template UnknownVector<D> Simulation<D>::reduced_pressure() const;                                                         \
    template double Simulation<D>::hydrostatic(const Vec<D>&) const;                                                           \
    template std::vector<GapState> Simulation<D>::gaps() const;                                                                \
    template Budget<D> Simulation<D>::budget() const;                                                                          \
    template void Simulation<D>::finish_report(StepReport&, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
