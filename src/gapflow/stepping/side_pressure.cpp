#include "gapflow/stepping/side_pressure.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/grid/side_faces.hpp"

#include <limits>

namespace gapflow {

namespace {

// The body that holds a point of a wholly solid face.
template <int D>
int body_at(const Coupling<D>& there, std::size_t bodies, const Vec<D>& x)
{
    int deepest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < bodies; ++b)
        if (const double distance = there.solids[b].shape.distance(x); distance < least) {
            least = distance;
            deepest = static_cast<int>(b);
        }
    return deepest;
}

} // namespace

template <int D>
std::vector<double> pressure_beyond_mouths(const Model<D>& model, const std::vector<Mouth<D>>& mouths, double time)
{
    const std::array<double, 2 * D> beyond = model.pressure_beyond(time);
    std::vector<double> pressure(mouths.size(), 0.0);
    for (std::size_t r = 0; r < mouths.size(); ++r)
        if (mouths[r].kind == MouthKind::open_side)
            pressure[r] = beyond[mouths[r].side];
    return pressure;
}

// The section of a body with a side bears the pressure that the part beyond is exposed to all around, along the normal into the domain.
template <int D>
std::vector<Twist<D>> wrenches_from_beyond(const Model<D>& model, const Coupling<D>& there, double time)
{
    constexpr int n = twist_size<D>;
    const Grid<D>& grid = model.grid;
    const std::array<double, 2 * D> beyond = model.pressure_beyond(time);
    const std::size_t bodies = model.bodies.size();
    std::vector<double> sums(n * bodies, 0.0);
    bool any = false;
    for (int side = 0; side < 2 * D; ++side) {
        const int axis = side / 2, end = side % 2;
        if (beyond[side] == 0)
            continue;
        any = true;
        const Vec<D> force = (end ? -1 : 1) * beyond[side] * grid.face_area() * unit<D>(axis);
        auto add = [&](int body, double fraction, const Vec<D>& arm) {
            if (body >= 0 && body < static_cast<int>(bodies))
                Eigen::Map<Twist<D>>(&sums[n * body]) += wrench<D>(fraction * force, arm);
        };
        for_each_face_of_side<D>(grid, axis, end, [&](const Index<D>& f) {
            if (const int cut = there.fractions->cut(axis, f); cut >= 0) {
                for (const SolidPart<D>& part : there.fractions->faces[cut].solid)
                    add(part.solid, part.fraction, part.arm);
            } else if (there.fractions->open(axis, f) == 0) {
                const Vec<D> x = grid.face_centre(axis, f);
                if (const int body = body_at(there, bodies, x); body >= 0)
                    add(body, grid.relative_area(axis, f), x - there.solids[body].centre);
            }
        });
    }
    if (any)
        grid.comm().sum(sums);
    std::vector<Twist<D>> result;
    for (std::size_t b = 0; b < bodies; ++b)
        result.push_back(Eigen::Map<const Twist<D>>(&sums[n * b]));
    return result;
}

template <int D>
void push_from_beyond(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const Coupling<D>& there,
                      const Step& step, Intermediate<D>& star)
{
    const Grid<D>& grid = model.grid;
    const std::array<double, 2 * D> beyond = model.pressure_beyond(step.end());
    bool any = false;
    for (int side = 0; side < 2 * D; ++side) {
        const int axis = side / 2, end = side % 2;
        if (beyond[side] == 0)
            continue;
        any = true;
        const double change = (end ? -2 : 2) * step.dt * beyond[side] / (there.density * grid.dx());
        for_each_face_of_side<D>(grid, axis, end, [&](const Index<D>& f) {
            if (there.system.conductance(axis, f) > 0)
                star.velocity.grid(axis, f) += change / grid.spread(axis, f[axis]);
        });
    }
    if (!any)
        return;
    const std::vector<Twist<D>> wrenches = wrenches_from_beyond(model, there, step.end());
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (bodies[b].motion == Motion::free)
            star.twists[b] += impulse_response(bodies[b], Twist<D>(step.dt * wrenches[b]), step.dt);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<double> pressure_beyond_mouths<D>(const Model<D>&, const std::vector<Mouth<D>>&, double);             \
    template std::vector<Twist<D>> wrenches_from_beyond<D>(const Model<D>&, const Coupling<D>&, double);                       \
    template void push_from_beyond<D>(const Model<D>&, const std::vector<RigidBody<D>>&, const Coupling<D>&, const Step&,      \
                                      Intermediate<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
