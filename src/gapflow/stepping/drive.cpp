#include "gapflow/stepping/drive.hpp"

#include "gapflow/stepping/observation.hpp"

#include <algorithm>

namespace gapflow {

namespace {

// Volume of the domain.
template <int D>
double domain_volume(const Grid<D>& grid)
{
    return grid.size().prod();
}

// Upper bound of the change of the mean velocity by a uniform impulse of 1 per mass of fluid: fluid takes 1, a light body up to 3, as a ball
// without mass does in ideal fluid.
template <int D>
double largest_response(const Model<D>& model, const std::vector<RigidBody<D>>& bodies)
{
    double response = 1;
    for (const RigidBody<D>& body : bodies)
        if (body.motion == Motion::free) {
            const double of_body = 1.5 / (0.5 + body.mass / (model.scene.density * body.volume));
            response += std::max(of_body - 1, 0.0) * body.volume / domain_volume(model.grid);
        }
    return response;
}

} // namespace

template <int D>
Vec<D> mean_velocity(const Model<D>& model, const State<D>& state, const Vec<D>& fluid_flow, const std::vector<Twist<D>>& V)
{
    Vec<D> flow = fluid_flow;
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
        const RigidBody<D>& body = state.bodies[b];
        if (body.motion == Motion::fixed)
            continue;
        const Vec<D> arm = body.pose.matrix() * (body.centre_of_volume - body.centre_of_mass);
        flow += body.volume * velocity_at<D>(V[b], arm);
    }
    return flow / domain_volume(model.grid);
}

// With b the impulse of the gradient over the density in the last step, and s the response to it, the mean velocity of the next step's end is
// U^n + (U^n - U^{n-1} - s b) + s b' if the other forces go on as they are.
template <int D>
Drive<D> next_drive(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const Step& step)
{
    Drive<D> drive;
    if (!model.driven())
        return drive;
    const Scene& scene = model.scene;
    const std::vector<Twist<D>> V = model.twists(state.bodies);
    drive.flow = mean_velocity(model, state, budget(model, here, state, V).volume_flow, V);
    if (scene.pressure_gradient)
        drive.gradient = to_vec<D>(*scene.pressure_gradient);
    const double s = largest_response(model, state.bodies);
    const double last = step.last_dt > 0 ? step.dt / step.last_dt : 0.0; // a change of the last step, over this one
    for (int axis = 0; axis < D; ++axis)
        if (const std::optional<double> wanted = model.kept_velocity(axis)) {
            const double by_others =
                drive.flow[axis] - state.drive.flow[axis] + s * step.last_dt / scene.density * state.drive.gradient[axis];
            drive.gradient[axis] = -scene.density / (s * step.dt) * (*wanted - drive.flow[axis] - last * by_others);
        }
    return drive;
}

template <int D>
void drive_fluid(const Model<D>& model, const Coupling<D>& there, const Drive<D>& drive, const Step& step,
                 Intermediate<D>& star)
{
    if (drive.gradient.isZero(0))
        return;
    const Grid<D>& grid = model.grid;
    const Vec<D> impulse = -step.dt / model.scene.density * drive.gradient;
    FluidVelocity<D>& u = star.velocity;
    for (int axis = 0; axis < D; ++axis)
        for_each_row<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& row) {
            double* value = &u.grid(axis, row);
            for (int i = 0; i < owned_faces_end(grid, axis)[0] - grid.low()[0]; ++i)
                value[i] += impulse[axis];
        });
    fill_velocity_ghosts(grid, u.grid, model.sides(step.end()));
    FilmAccount<D>& account = star.film_account;
    for (const Film<D>& film : there.network.films)
        for (std::size_t k = 0; k < film.mesh.elements.size(); ++k) {
            const std::size_t i = film.first_element + k;
            const Vec<D> along = tangential<D>(impulse, film.mesh.elements[k].normal);
            u.film[i] += along;
            account.reference[i] += along;
            account.transported[i] += along;
        }
    for (std::size_t r = 0; r < u.mouth.size(); ++r) {
        const Mouth<D>& mouth = there.network.rim.mouths[r];
        const double flux = mouth.length * mouth.h * mouth.outward.dot(impulse);
        u.mouth[r] += star.mouth_factor[r] * flux;
        account.kept[r] += flux;
    }
}

template <int D>
Twist<D> driving_wrench(const RigidBody<D>& body, const Drive<D>& drive)
{
    if (drive.gradient.isZero(0))
        return Twist<D>::Zero();
    const Vec<D> arm = body.pose.matrix() * (body.centre_of_volume - body.centre_of_mass);
    return wrench<D>(-body.volume * drive.gradient, arm);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Vec<D> mean_velocity<D>(const Model<D>&, const State<D>&, const Vec<D>&, const std::vector<Twist<D>>&);           \
    template Drive<D> next_drive<D>(const Model<D>&, const Coupling<D>&, const State<D>&, const Step&);                        \
    template void drive_fluid<D>(const Model<D>&, const Coupling<D>&, const Drive<D>&, const Step&, Intermediate<D>&);         \
    template Twist<D> driving_wrench<D>(const RigidBody<D>&, const Drive<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
