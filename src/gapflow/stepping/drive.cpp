#include "gapflow/stepping/drive.hpp"

#include "gapflow/stepping/volume_flux.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gapflow {

namespace {

// Of all faces of an axis, in cells' volumes: the sum of the parts that lie in each body. The sum over planes of a cross-section, whose faces
// inside the body count with those around: a cell's position times what of the body passes it, summed by parts.
template <int D>
std::vector<Vec<D>> sections(const Grid<D>& grid, const FaceFractions<D>& fractions, const std::vector<RigidBody<D>>& bodies)
{
    std::vector<double> sums(D * bodies.size(), 0.0);
    const auto is_inside = [&](const Index<D>& c) { // all that passes one face passes the other, too
        for (int axis = 0; axis < D; ++axis)
            for (const Index<D>& f : {c, Index<D>(c + gapflow::step<D>(axis))})
                if (fractions.cut(axis, f) < 0 && fractions.open(axis, f) == 0)
                    return true;
        return false;
    };
    for (const Index<D>& c : fractions.surface_cells)
        for (int axis = 0; axis < D && !is_inside(c); ++axis)
            for (int end = 0; end < 2; ++end) {
                const Index<D> f = end ? Index<D>(c + gapflow::step<D>(axis)) : c;
                const int cut = fractions.cut(axis, f);
                if (cut < 0)
                    continue;
                for (const SolidPart<D>& part : fractions.faces[cut].solid)
                    if (part.solid < static_cast<int>(bodies.size())) {
                        const double x = part.arm[axis] - part.centroid[axis] + grid.cell_centre(c)[axis];
                        sums[D * part.solid + axis] += (end ? -1 : 1) * part.fraction * x / grid.dx();
                    }
            }
    grid.comm().sum(sums);
    std::vector<Vec<D>> result(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b)
        result[b] = Eigen::Map<const Vec<D>>(&sums[D * b]);
    return result;
}

// Estimate of the change of the mean velocity by a uniform impulse of 1 per mass of fluid in ideal fluid, after Maxwell's formula for a mixture
// of conductors: a body takes up to infinitely much, a fixed one nothing. Of light bodies it is an upper bound up to close packing.
template <int D>
double response(const Model<D>& model, const std::vector<RigidBody<D>>& bodies)
{
    constexpr double most = 0.85, margin = 1.25;
    double sum = 0;
    for (const RigidBody<D>& body : bodies) {
        const double mobility = body.motion == Motion::free ? model.scene.density * body.volume / body.mass : 0.0;
        if (body.volume > 0 && body.volume < model.grid.size().prod())
            sum += (mobility - 1) / (mobility + D - 1) * body.volume / model.grid.size().prod();
    }
    sum = std::clamp(sum, -most, most);
    const double s = (1 + (D - 1) * sum) / (1 - sum);
    return s > 1 ? 1 + margin * (s - 1) : s;
}

} // namespace

// The flow through the planes of a grid's faces, in the mean: through open faces, in bodies, and in films.
template <int D>
Vec<D> mean_velocity(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V)
{
    const Grid<D>& grid = model.grid;
    std::vector<double> sums(D, 0.0); // flow through open faces
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> low = grid.low(),
                       high = grid.high(); // one face a cell along each axis, also where there is no other end
        for_each_row<D>(low, high, [&](const Index<D>& row) {
            const double *open = &here.open(axis, row), *u = &state.velocity.grid(axis, row);
            for (int i = 0; i < high[0] - low[0]; ++i)
                sums[axis] += open[i] * u[i];
        });
    }
    grid.comm().sum(sums);
    const Vec<D> in_films = flow_of_films(model, here, state, V) / std::pow(grid.dx(), D);
    const std::vector<Vec<D>> section = sections(grid, *here.fractions, state.bodies);
    Vec<D> flow;
    for (int axis = 0; axis < D; ++axis) {
        flow[axis] = sums[axis] + in_films[axis];
        for (std::size_t b = 0; b < state.bodies.size(); ++b) {
            const RigidBody<D>& body = state.bodies[b];
            if (body.motion != Motion::fixed)
                flow[axis] += section[b][axis] * velocity_at<D>(V[b], displacement(body).arm)[axis];
        }
    }
    return flow / grid.cells().template cast<double>().prod();
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
    drive.flow = mean_velocity(model, here, state, model.twists(state.bodies));
    if (scene.pressure_gradient)
        drive.gradient = to_vec<D>(*scene.pressure_gradient);
    const double s = response(model, state.bodies);
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
            const Vec<D>& n = film.mesh.elements[k].normal;
            const Vec<D> along = tangential<D>(impulse, n);
            u.film[i] += along;
            u.film_normal[i] += impulse.dot(n);
            account.reference[i] += along;
            account.transported[i] += along;
        }
    for (std::size_t r = 0; r < u.mouth.size(); ++r) {
        const Mouth<D>& mouth = there.network.rim.mouths[r];
        const double flux = mouth.length * mouth.section.dot(impulse);
        u.mouth[r] += star.mouth_factor[r] * flux;
        account.kept[r] += flux;
    }
}

template <int D>
Twist<D> driving_wrench(const RigidBody<D>& body, const Drive<D>& drive)
{
    if (drive.gradient.isZero(0))
        return Twist<D>::Zero();
    const Displacement<D> displaced = displacement(body);
    return wrench<D>(-displaced.volume * drive.gradient, displaced.arm);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Vec<D> mean_velocity<D>(const Model<D>&, const Coupling<D>&, const State<D>&, const std::vector<Twist<D>>&);      \
    template Drive<D> next_drive<D>(const Model<D>&, const Coupling<D>&, const State<D>&, const Step&);                        \
    template void drive_fluid<D>(const Model<D>&, const Coupling<D>&, const Drive<D>&, const Step&, Intermediate<D>&);         \
    template Twist<D> driving_wrench<D>(const RigidBody<D>&, const Drive<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
