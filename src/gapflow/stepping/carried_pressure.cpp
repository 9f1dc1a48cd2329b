#include "gapflow/stepping/carried_pressure.hpp"

#include "gapflow/grid/extrapolation.hpp"
#include "gapflow/grid/interpolation.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr int layers = 32;          // of faces around bodies to which their velocity extends
constexpr double longest_way = 1.5; // in cells: fields have ghosts two cells deep
constexpr double known_share = 0.3; // of the weights of known cells around a place, for a value there

template <int D>
Vec<D> at_face(const FaceField<D>& W, int axis, const Index<D>& f)
{
    Vec<D> mean;
    for (int k = 0; k < D; ++k)
        mean[k] =
            k == axis
                ? W(k, f)
                : 0.25 * (W(k, f) + W(k, f + step<D>(k)) + W(k, f - step<D>(axis)) + W(k, f - step<D>(axis) + step<D>(k)));
    return mean;
}

template <int D>
Vec<D> at_cell(const FaceField<D>& W, const Index<D>& c)
{
    Vec<D> mean;
    for (int k = 0; k < D; ++k)
        mean[k] = 0.5 * (W(k, c) + W(k, c + step<D>(k)));
    return mean;
}

} // namespace

template <int D>
std::optional<FaceField<D>> carrying_velocity(const Coupling<D>& there, const std::vector<Twist<D>>& motion, std::size_t bodies,
                                              const Vec<D>& grid_velocity)
{
    const Grid<D>& grid = *there.grid;
    const FaceFractions<D>& fractions = *there.fractions;
    if (std::none_of(motion.begin(), motion.begin() + static_cast<long>(bodies),
                     [&](const Twist<D>& V) { return V.template head<D>() != grid_velocity; }))
        return {};
    FaceField<D> W(grid);
    FaceField<D, std::int8_t> valid(grid);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            const int cut = fractions.cut(axis, f);
            if (cut < 0)
                return;
            double most = 0;
            for (const SolidPart<D>& part : fractions.faces[cut].solid)
                if (part.solid < static_cast<int>(bodies) && part.fraction > most) {
                    most = part.fraction;
                    W(axis, f) = motion[part.solid][axis] - grid_velocity[axis];
                    valid(axis, f) = 1;
                }
        });
    extrapolate(grid, W, valid, layers);
    return W;
}

template <int D>
FaceField<D> change_along(const Grid<D>& grid, const FaceField<D>& W, double dt, const FaceField<D>& f)
{
    FaceField<D> change(grid);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& face) {
            const Vec<D> way =
                (dt * at_face(W, axis, face)).cwiseMax(-longest_way * grid.dx()).cwiseMin(longest_way * grid.dx());
            if (!way.isZero(0))
                change(axis, face) =
                    interpolate_face<D>(grid, f[axis], axis, grid.face_centre(axis, face) + way) - f(axis, face);
        });
    exchange(grid, change);
    return change;
}

template <int D>
void carry(const Grid<D>& grid, const FaceField<D>& W, double dt, PastPressure<D>& past)
{
    exchange(grid, past.pressure);
    exchange(grid, past.known);
    CellField<D> moved = past.pressure;
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (past.known(c) <= 0)
            return;
        Index<D> base = c;
        Vec<D> part;
        const Vec<D> speed = at_cell(W, c);
        if (speed.isZero(0))
            return;
        for (int k = 0; k < D; ++k) {
            const double way = std::clamp(-dt * speed[k] / (grid.dx() * grid.width(k, c[k])), -longest_way, longest_way);
            base[k] += static_cast<int>(std::floor(way));
            part[k] = way - std::floor(way);
        }
        double sum = 0, weights = 0;
        for (int corner = 0; corner < (1 << D); ++corner) {
            Index<D> g = base;
            double weight = 1;
            for (int k = 0; k < D; ++k) {
                g[k] += corner >> k & 1;
                weight *= corner >> k & 1 ? part[k] : 1 - part[k];
            }
            if (weight > 0 && past.known(g) > 0) {
                sum += weight * past.pressure(g);
                weights += weight;
            }
        }
        if (weights > known_share)
            moved(c) = sum / weights;
    });
    past.pressure = std::move(moved);
    exchange(grid, past.pressure);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::optional<FaceField<D>> carrying_velocity<D>(const Coupling<D>&, const std::vector<Twist<D>>&, std::size_t,   \
                                                              const Vec<D>&);                                                  \
    template FaceField<D> change_along<D>(const Grid<D>&, const FaceField<D>&, double, const FaceField<D>&);                   \
    template void carry<D>(const Grid<D>&, const FaceField<D>&, double, PastPressure<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
