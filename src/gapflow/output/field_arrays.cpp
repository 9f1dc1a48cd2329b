#include "gapflow/output/field_arrays.hpp"

namespace gapflow {

namespace {

template <int D>
Vec<D> at_centre(const FaceField<D>& u, const Index<D>& c)
{
    Vec<D> mean;
    for (int axis = 0; axis < D; ++axis)
        mean[axis] = 0.5 * (u(axis, c) + u(axis, Index<D>(c + step<D>(axis))));
    return mean;
}

// Second invariant of the velocity gradient, 1/2 ((tr G)^2 - tr G^2), from differences between the cells around.
template <int D>
double second_invariant(const Grid<D>& grid, const FaceField<D>& u, const Index<D>& c)
{
    Mat<D> gradient;
    for (int axis = 0; axis < D; ++axis) {
        const double between = grid.spread(axis, c[axis]) + grid.spread(axis, c[axis] + 1);
        gradient.col(axis) = (at_centre<D>(u, c + step<D>(axis)) - at_centre<D>(u, c - step<D>(axis))) / (between * grid.dx());
        gradient(axis, axis) = (u(axis, Index<D>(c + step<D>(axis))) - u(axis, c)) / (grid.width(axis, c[axis]) * grid.dx());
    }
    return 0.5 * (gradient.trace() * gradient.trace() - (gradient * gradient).trace());
}

} // namespace

template <int D>
VtkArray field_array(const Simulation<D>& simulation, const std::string& name)
{
    const Grid<D>& grid = simulation.grid();
    const FaceField<D>& u = simulation.velocity().grid;
    if (name == "velocity")
        return cell_array(grid, name, D,
                          [&](const Index<D>& c, int axis) { return 0.5 * (u(axis, c) + u(axis, c + step<D>(axis))); });
    if (name == "kind")
        return cell_array(grid, name, 1,
                          [&](const Index<D>& c, int) { return static_cast<double>(simulation.coupling().kind(c)); });
    const auto known = [&](const Index<D>& c) { return simulation.coupling().system.component(c) >= 0; };
    if (name == "pressure") {
        const UnknownVector<D> p = simulation.reduced_pressure();
        return cell_array(grid, name, 1, [&](const Index<D>& c, int) {
            return known(c) ? p.cells(c) + simulation.hydrostatic(grid.cell_centre(c)) : 0.0;
        });
    }
    if (name == "vorticity")
        return cell_array(grid, name, spin_size<D>, [&](const Index<D>& c, int axis) {
            return known(c) ? vorticity_at(grid, u, grid.cell_centre(c))[axis] : 0.0;
        });
    if (name == "divergence") {
        const CellField<D> outflow = simulation.outflow();
        const double volume = std::pow(grid.dx(), D);
        return cell_array(grid, name, 1, [&](const Index<D>& c, int) {
            return known(c) ? outflow(c) / (volume * grid.relative_volume(c)) : 0.0;
        });
    }
    return cell_array(grid, name, 1, [&](const Index<D>& c, int) { return known(c) ? second_invariant(grid, u, c) : 0.0; });
}

template VtkArray field_array(const Simulation<2>&, const std::string&);
template VtkArray field_array(const Simulation<3>&, const std::string&);

} // namespace gapflow
