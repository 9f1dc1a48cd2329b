// Advection of the bulk, of second order in time (method, "The time step", stage 2).
#include "gapflow/grid/far_field.hpp"
#include "gapflow/grid/side_faces.hpp"
#include "gapflow/stepping/advection.hpp"
#include "gapflow/stepping/carried_pressure.hpp"
#include "gapflow/stepping/transport.hpp"

#include <algorithm>
#include <array>

namespace gapflow {

namespace {

// Marks (nonzero) the faces beside places where a single closed face separates open ones: the extrapolated velocity there is
// the mean of the flows on the two sides of a body of one to two cells, and MacCormack's correction treats the difference as a
// gradient. `open`: of the flow;
// faces open by no more than `widest` count as closed. Returns whether there are any. Collective.
template <int D>
bool mark_across_thin_bodies(const Grid<D>& grid, const FaceField<D>& open, double widest, FaceField<D, std::int8_t>& marks)
{
    FaceField<D, std::int8_t> between(grid);
    bool any = false;
    for (int axis = 0; axis < D; ++axis) {
        const CellField<D>& a = open[axis];
        const Index<D> end = owned_faces_end(grid, axis);
        for_each_row<D>(grid.low(), end, [&](const Index<D>& row) {
            const double* value = &a(row);
            std::int8_t* to = &between(axis, row);
            for (int i = 0; i < end[0] - grid.low()[0]; ++i)
                for (int k = 0; k < D && value[i] <= widest; ++k) {
                    const long stride = a.block().stride[k];
                    if (value[i + stride] > widest && value[i - stride] > widest) {
                        to[i] = 1;
                        any = true;
                    }
                }
        });
    }
    if (!grid.comm().any(any))
        return false;
    exchange(grid, between);
    const Index<D> one = Index<D>::Ones(), reach = 2 * one;
    for (int axis = 0; axis < D; ++axis) {
        const Block<D>& block = between[axis].block();
        for_each_index<D>(grid.low() - reach, owned_faces_end(grid, axis) + reach, [&](const Index<D>& f) {
            if (!between(axis, f))
                return;
            for (int other = 0; other < D; ++other) {
                // Equally far on either side: faces of another axis lie half a cell off.
                Index<D> from = f - one, to = f + 2 * one;
                if (other != axis) {
                    from[axis] -= 1;
                    to[other] += 1;
                }
                for_each_index<D>(from.cwiseMax(block.low), to.cwiseMin(block.high),
                                  [&](const Index<D>& g) { marks(other, g) = 1; });
            }
        });
    }
    return true;
}

// Fluid that enters through an open side comes from a reservoir that moves with `outside`, the fluid's initial velocity: with w
// its speed across the side, p = rho (w_outside^2 - w^2) / 2 where w is larger than w_outside. With p = 0 inflow of any speed
// would add its kinetic energy, and beside a body that leaves, where ideal flow is singular, its speed would grow without
// bound.
template <int D>
void add_inflow_head(const Model<D>& model, const Vec<D>& outside, double dt, FaceField<D>& u)
{
    const Grid<D>& grid = model.grid;
    const Vec<D>& grid_velocity = model.grid_velocity;
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end) {
            const int place = end * grid.cells()[axis];
            Index<D> from = grid.low(), to = owned_faces_end(grid, axis);
            if (grid.side(axis, end) != SideKind::open || model.scene.sides[2 * axis + end].kind == SideScene::Kind::surface ||
                from[axis] > place || to[axis] <= place)
                continue;
            from[axis] = place;
            to[axis] = place + 1;
            const double free = outside[axis] * outside[axis];
            for_each_index<D>(from, to, [&](const Index<D>& f) {
                const double w = end == 0 ? u(axis, f) : -u(axis, f);
                if (w > (end == 0 ? 1 : -1) * grid_velocity[axis] && w > 0 && w * w > free)
                    u(axis, f) /= 1 + dt * (w - free / w) / (grid.dx() * grid.spread(axis, f[axis]));
            });
        }
}

// Near a CFL number of 1 the head above, implicit face by face, is up to half too small, and the flow that a pressure difference drives too
// fast. On pressure sides the mean of what is missing is taken off all faces where fluid comes in: the side's flow as a whole is inert enough
// for that, single faces are not. `before`: without the head.
template <int D>
void complete_head_of_pressure_sides(const Model<D>& model, const Coupling<D>& there, const FaceField<D>& before, double dt,
                                     FaceField<D>& u)
{
    const Grid<D>& grid = model.grid;
    for (int side = 0; side < 2 * D; ++side) {
        if (model.scene.sides[side].kind != SideScene::Kind::pressure)
            continue;
        const int axis = side / 2, inwards = side % 2 ? -1 : 1;
        const double free = model.scene.fluid_velocity[axis] * model.scene.fluid_velocity[axis];
        std::array<double, 2> sums{}; // open parts; what they lack
        for_each_face_of_side<D>(grid, axis, side % 2, [&](const Index<D>& f) {
            const double w = inwards * before(axis, f), open = there.open(axis, f);
            if (w <= 0 || w * w <= free)
                return;
            sums[0] += open;
            sums[1] += open * (dt * (w * w - free) / (grid.dx() * grid.spread(axis, f[axis])) - (w - inwards * u(axis, f)));
        });
        grid.comm().sum(sums);
        if (sums[0] <= 0)
            continue;
        for_each_face_of_side<D>(grid, axis, side % 2, [&](const Index<D>& f) {
            const double w = inwards * before(axis, f);
            if (w > 0 && w * w > free)
                u(axis, f) -= inwards * sums[1] / sums[0];
        });
    }
}

// Above a water level there is no stream that brings momentum in, as there is in front of a vessel's mouth: what comes in is at rest along the normal, moves
// with fluid.velocity along the level, and the pressure in the level is 0. It joins what is there, momentum being kept: in time dt the length dt w joins the
// half cell that a face in the level carries, and the cell below it. Energy is lost in any case. (With the head of a mouth alone, a disk of a fifth of the
// fluid's density that jumps out of water gains 20 % of its largest kinetic energy.)
template <int D>
void let_in_from_water_level(const Model<D>& model, const BoundaryVelocity<D>& sides, double dt, FaceField<D>& u)
{
    const Grid<D>& grid = model.grid;
    const Vec<D> outside = to_vec<D>(model.scene.fluid_velocity);
    for (int side = 0; side < 2 * D; ++side) {
        if (model.scene.sides[side].kind != SideScene::Kind::surface)
            continue;
        const int axis = side / 2, end = side % 2;
        fill_velocity_ghosts(grid, axis, u[axis], sides);
        const auto inflow = [&](const Index<D>& f) { return std::max((end ? -1 : 1) * u(axis, f), 0.0); };
        for_each_face_of_side<D>(grid, axis, end, [&](const Index<D>& f) {
            const Index<D> inner = end ? Index<D>(f - gapflow::step<D>(axis)) : f;
            for (int k = 0; k < D; ++k) {
                if (k == axis)
                    continue;
                const double w = 0.5 * (inflow(f) + inflow(f - gapflow::step<D>(k))),
                             joins = dt * w / (grid.dx() * grid.width(axis, inner[axis]));
                u(k, inner) = (u(k, inner) + joins * outside[k]) / (1 + joins);
            }
        });
        for_each_face_of_side<D>(grid, axis, end, [&](const Index<D>& f) {
            u(axis, f) /= 1 + 2 * dt * inflow(f) / (grid.dx() * grid.spread(axis, f[axis]));
        });
    }
}

template <int D>
void add(FaceField<D>& to, double factor, const FaceField<D>& more)
{
    for (int axis = 0; axis < D; ++axis)
        for (long i = 0; i < to[axis].size(); ++i)
            to[axis].data()[i] += factor * more[axis].data()[i];
}

// Fluid that comes in through a far side has no vorticity. What fades beyond the side like the pressure of fluid at rest is its whole head
// h = p / rho + (|u|^2 - |u_infinity|^2) / 2, so d u_n / dt = -dh/dn without advection; the pressure's part is the projection's.
template <int D>
void let_in_from_far(const Grid<D>& grid, const Vec<D>& outside, const Vec<D>& grid_velocity, double dt,
                     const FaceField<D>& before, FaceField<D>& u)
{
    const FarField<D> far = far_field(grid);
    for (int axis = 0; axis < D; ++axis)
        for_each_far_face(grid, axis, [&](const Index<D>& f, int end) {
            const int inwards = end ? -1 : 1;
            const double w = inwards * before(axis, f), beyond = w - inwards * grid_velocity[axis]; // through the side
            if (beyond <= 0)
                return;
            const Index<D> inner = end ? Index<D>(f - step<D>(axis)) : f;
            double square = w * w - outside.squaredNorm();
            for (int k = 0; k < D; ++k)
                if (k != axis) {
                    const double along = 0.5 * (before(k, inner) + before(k, inner + step<D>(k)));
                    square += along * along;
                }
            const double loss = dt * square / (far_distance(grid, far, axis, f) * grid.dx() * grid.spread(axis, f[axis]));
            u(axis, f) = inwards * (loss > 0 && w > 0 ? w / (1 + loss / w) : w - loss);
        });
}

} // namespace

template <int D>
FaceField<D> transport_bulk(const Model<D>& model, const FaceField<D>& velocity, PastPressure<D>& past,
                            const Coupling<D>& there, const FaceFractions<D>& old, const FaceField<D, std::int8_t>* first_order,
                            const std::vector<Twist<D>>& motion, std::size_t bodies, const Step& step)
{
    const Grid<D>& grid = model.grid;
    const BoundaryVelocity<D> sides = model.sides(step.start);
    const AdvectionScheme scheme =
        model.scene.advection == Scene::Advection::maccormack ? AdvectionScheme::maccormack : AdvectionScheme::semi_lagrangian;
    extrapolate_pressure(there, past);
    FaceField<D> change = velocity_change(there, past, step.dt, model.pressure_beyond(step.start));
    FaceField<D> middle(grid);
    const Vec<D>& grid_velocity = model.grid_velocity;
    advect<D>(grid, middle, velocity, velocity, 0.5 * step.dt, AdvectionScheme::semi_lagrangian, sides, nullptr, nullptr,
              grid_velocity);
    fill_velocity_ghosts(grid, middle, sides);
    const std::optional<CarryingVelocity<D>> carrying = carrying_velocity(there, motion, bodies, grid_velocity);
    // The limit is that of a grid that goes with the bodies: on it the flow changes by so much more.
    FaceField<D> with_bodies;
    if (carrying) {
        with_bodies = change_along(grid, *carrying, 0.5 * step.dt, velocity);
        add(middle, 1.0, with_bodies);
    }
    limit_to_inertia(grid, velocity, middle, change);
    if (carrying)
        add(middle, -1.0, with_bodies);
    fill_velocity_ghosts(grid, change, {});
    fill_velocity_ghosts(grid, middle, sides);
    FaceField<D, std::int8_t> uncorrected;
    if (scheme == AdvectionScheme::maccormack) {
        uncorrected = first_order ? *first_order : FaceField<D, std::int8_t>(grid);
        if (mark_across_thin_bodies(grid, old.open, widest_sliver(model, step.dt), uncorrected))
            first_order = &uncorrected;
    }
    FaceField<D> u_star(grid);
    advect<D>(grid, u_star, middle, velocity, step.dt, scheme, sides, first_order, &change, grid_velocity);
    if (carrying) {
        add(u_star, -0.5, change_along(grid, *carrying, -step.dt, change));
        carry(grid, *carrying, step.dt, past);
    }
    const Vec<D> outside = to_vec<D>(model.scene.fluid_velocity);
    const bool any_pressure_side = std::any_of(model.scene.sides.begin(), model.scene.sides.end(),
                                               [](const SideScene& side) { return side.kind == SideScene::Kind::pressure; });
    const FaceField<D> before_head = any_pressure_side ? u_star : FaceField<D>();
    add_inflow_head(model, outside, step.dt, u_star);
    let_in_from_water_level(model, sides, step.dt, u_star);
    if (any_pressure_side)
        complete_head_of_pressure_sides(model, there, before_head, step.dt, u_star);
    let_in_from_far(grid, outside, grid_velocity, step.dt, velocity, u_star);
    return u_star;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template FaceField<D> transport_bulk<D>(const Model<D>&, const FaceField<D>&, PastPressure<D>&, const Coupling<D>&,        \
                                            const FaceFractions<D>&, const FaceField<D, std::int8_t>*,                         \
                                            const std::vector<Twist<D>>&, std::size_t, const Step&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
