// Values of the flow at points (probes), wherever they lie: in the bulk, in a film, in a solid. Reads the state, never changes it.
//
//     bulk   pressure: of the cells around, multilinear; beside surfaces the linear function that fits the cells that the grid's open
//            faces connect best. Velocity: multilinear between faces, with the values beyond surfaces that the traces read too.
//            Vorticity: differences of face velocities at the cells' edges, multilinear between them. All of second order
//     film   the film's pressure, linear on its mesh, and its mean velocity across the gap; no vorticity
//     solid  nothing
#pragma once

#include "gapflow/stepping/state.hpp"

#include <limits>
#include <span>
#include <vector>

namespace gapflow {

/// Where a point lies; the numbers are those of the cells' kinds in the fields' files.
enum class PointKind { solid = 0, bulk = 1, film = 2 };

/// Values at a point; what is not there is NaN.
template <int D>
struct PointValues {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    PointKind kind = PointKind::solid;
    double pressure = none; ///< full, mean over the last step; not of a driven box's mean gradient
    Vec<D> velocity = Vec<D>::Constant(none);
    Spin<D> vorticity = Spin<D>::Constant(none);
};

/// The values at points of the domain, the same on every rank. A point within 1e-6 dx of a surface counts as in the fluid. `V`: twists of
/// all solids. Collective.
template <int D>
std::vector<PointValues<D>> sample_points(const Model<D>& model, const Coupling<D>& here, const State<D>& state,
                                          const std::vector<Twist<D>>& V, std::span<const Vec<D>> points);

/// Vorticity of the bulk's velocities at x, a point of this rank's block.
template <int D>
Spin<D> vorticity_at(const Grid<D>& grid, const FaceField<D>& velocity, const Vec<D>& x);

} // namespace gapflow
