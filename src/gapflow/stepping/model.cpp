#include "gapflow/stepping/model.hpp"

#include "gapflow/coupling/parts.hpp"
#include "gapflow/coupling/pressure_gauge.hpp"
#include "gapflow/stepping/standoff.hpp"

#include "gapflow/body/forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

namespace {

bool is_pressure_side(const SideScene& side)
{
    return side.kind == SideScene::Kind::pressure;
}

double side_pressure(const SideScene& side, double time)
{
    return value_at(side.table, time).at(0);
}

} // namespace

template <int D>
Model<D>::Model(const Scene& s, const Communicator& comm, Task task)
    : scene(s), grid(make_grid<D>(scene, comm)), bodies(make_bodies<D>(scene)), walls(make_walls<D>(scene)),
      gaps(gap_settings<D>(scene, solids(bodies), task == Task::motion)), mouths(mouth_laws<D>(scene, solids(bodies)))
{
}

template <int D>
std::vector<Twist<D>> Model<D>::twists(const std::vector<RigidBody<D>>& of) const
{
    std::vector<Twist<D>> V;
    for (const RigidBody<D>& body : of)
        V.push_back(body.motion == Motion::fixed ? Twist<D>(Twist<D>::Zero()) : body.twist);
    V.insert(V.end(), walls.twists.begin(), walls.twists.end());
    return V;
}

template <int D>
std::vector<TwistMatrix<D>> Model<D>::masses(const std::vector<RigidBody<D>>& of, double dt) const
{
    std::vector<TwistMatrix<D>> mass;
    for (const RigidBody<D>& body : of)
        mass.push_back(mass_matrix(body) + stiffness_inertia(body, dt));
    mass.resize(of.size() + walls.solids.size(), TwistMatrix<D>::Identity());
    return mass;
}

template <int D>
std::optional<double> Model<D>::kept_velocity(int axis) const
{
    if (!grid.periodic(axis) || scene.pressure_gradient)
        return {};
    if (scene.mean_velocity)
        return (*scene.mean_velocity)[axis];
    const bool falls = scene.gravity[axis] != 0 && std::any_of(bodies.begin(), bodies.end(), [&](const RigidBody<D>& body) {
                           return body.motion == Motion::free && body.mass != scene.density * body.volume;
                       });
    return falls ? std::optional(scene.fluid_velocity[axis]) : std::nullopt;
}

template <int D>
bool Model<D>::driven() const
{
    bool driven = scene.pressure_gradient.has_value();
    for (int axis = 0; axis < D; ++axis)
        driven = driven || kept_velocity(axis).has_value();
    return driven;
}

template <int D>
BoundaryVelocity<D> Model<D>::sides(double time) const
{
    BoundaryVelocity<D> sides;
    sides.no_slip = viscous();
    sides.grid = grid_velocity;
    for (int s = 0; s < 2 * D; ++s) {
        const SideScene& side = scene.sides[s];
        sides.velocity[s] = to_vec<D>(side.velocity);
        if (side.kind == SideScene::Kind::inflow && !side.table.time.empty()) {
            const std::vector<double> u = value_at(side.table, time);
            sides.velocity[s] = Eigen::Map<const Vec<D>>(u.data());
        }
    }
    return sides;
}

// Largest -g . x on a side.
template <int D>
double Model<D>::height(int side) const
{
    const Vec<D> g = gravity();
    double highest = -std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < (1 << D); ++corner) {
        Vec<D> place;
        for (int axis = 0; axis < D; ++axis)
            place[axis] = scene.origin[axis] + (corner >> axis & 1) * grid.size()[axis]; // also of a grid that has moved
        if ((corner >> (side / 2) & 1) == side % 2)
            highest = std::max(highest, -g.dot(place));
    }
    return highest;
}

template <int D>
double Model<D>::hydrostatic(const Vec<D>& x) const
{
    double highest = -std::numeric_limits<double>::infinity(), level = 0;
    for (int s = 0; s < 2 * D; ++s)
        if (scene.sides[s].is_open() && !is_pressure_side(scene.sides[s]))
            highest = std::max(highest, height(s));
    if (std::isfinite(highest))
        level = scene.density * highest + scene.reference_pressure;
    else if (const auto first = std::find_if(scene.sides.begin(), scene.sides.end(), is_pressure_side);
             first != scene.sides.end())
        level = scene.density * height(static_cast<int>(first - scene.sides.begin())) + side_pressure(*first, 0);
    return scene.density * gravity().dot(x) + level;
}

template <int D>
std::array<double, 2 * D> Model<D>::pressure_beyond(double time) const
{
    std::array<double, 2 * D> beyond{};
    const double level = hydrostatic(Vec<D>::Zero());
    for (int s = 0; s < 2 * D; ++s)
        if (is_pressure_side(scene.sides[s]))
            beyond[s] = side_pressure(scene.sides[s], time) - (level - scene.density * height(s));
    return beyond;
}

template <int D>
Coupling<D> Model<D>::coupled(const std::vector<RigidBody<D>>& at, std::vector<TwistMatrix<D>> mass, double viscosity_dt,
                              const std::set<FilmPair<D>>& alive, const std::function<DragTerms(const Coupling<D>&)>& drag,
                              StageTimers* timers, const FaceFractions<D>* before) const
{
    const bool moves = !mass.empty();
    mass.resize(at.size() + walls.solids.size(), TwistMatrix<D>::Identity());
    if (scene.parts) {
        const auto [all, standoffs] = rough_solids<D>(scene, grid, solids(at));
        const Complex<D> complex = build_complex<D>(grid, all);
        const Inertia<D> inertia = find_inertia<D>(grid, complex, find_gap_arms<D>(grid, all, complex, standoffs),
                                                   find_mouth_arms<D>(grid, all, complex, standoffs));
        Coupling<D> coupling = couple_parts<D>(grid, all, mass, scene.density, complex, inertia);
        if (moves)
            add_seen_mass(coupling);
        return coupling;
    }
    return couple<D>(grid, solids(at), mass, {scene.density, fraction_mode(scene), timers, viscosity_dt}, gaps, alive, drag,
                     before);
}

template struct Model<2>;
template struct Model<3>;

} // namespace gapflow
