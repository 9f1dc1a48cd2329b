#include "gapflow/complex/cells.hpp"
#include "gapflow/complex/corner_faces.hpp"
#include "gapflow/complex/edge_mouth.hpp"
#include "gapflow/complex/join_faces.hpp"
#include "gapflow/complex/mouth.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/part_borders.hpp"
#include "gapflow/complex/seen_volume.hpp"
#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

namespace gapflow {

template <int D>
DenseIndex<D>::DenseIndex(const Grid<D>& grid)
{
    Index<D> from = grid.low(), to = grid.high();
    std::array<bool, D> around{};
    for (int axis = 0; axis < D; ++axis) {
        const int cells = grid.cells()[axis];
        around[axis] = grid.periodic(axis) && to[axis] - from[axis] == cells;
        const bool on = grid.periodic(axis) && !around[axis];
        from[axis] = on ? from[axis] - shared_layers : std::max(0, from[axis] - shared_layers);
        to[axis] = on ? to[axis] + shared_layers : std::min(cells, to[axis] + shared_layers);
    }
    *this = DenseIndex(from, to);
    wraps = around;
}

/// Where the sides of sharp corners lead out of the domain through open sides of it.
static void find_ways_out(const Grid<2>& grid, const GridPlanes<2>& planes, std::vector<PlacedSolid<2>>& placed)
{
    for (PlacedSolid<2>& solid : placed)
        for (SharpCorner& corner : solid.corners)
            for (int side = 0; side < 4; ++side) {
                const int axis = side / 2, sign = side % 2 ? 1 : -1;
                const double distance = sign * (planes.place_of(axis, side % 2 ? grid.cells()[axis] : 0) - corner.at[axis]);
                if (!is_open(grid.side(axis, side % 2)) || !(distance > 0))
                    continue;
                for (const int turn : {-1, 1}) {
                    const Vec<2> way = Eigen::Rotation2Dd(turn * (std::numbers::pi - 0.5 * corner.angle)) * corner.outward;
                    const double rate = sign * way[axis];
                    if (!(rate > parameters.parallel) || (corner.length_out > 0 && distance >= rate * corner.length_out))
                        continue;
                    corner.way_out = way;
                    corner.length_out = distance / rate;
                    corner.axis_out = axis;
                }
            }
}

/// Whether the domain is periodic along an axis.
template <int D>
bool any_periodic(const Grid<D>& grid)
{
    bool any = false;
    for (int axis = 0; axis < D; ++axis)
        any = any || grid.periodic(axis);
    return any;
}

template <int D>
Complex<D> build_complex(const Grid<D>& grid, std::span<const Solid<D>> solids, FaceDerivatives<D>* derivatives,
                         std::vector<PartFace<D>>* borders, bool mouths)
{
    Complex<D> complex;
    if (derivatives)
        *derivatives = {};
    complex.index = DenseIndex<D>(grid);
    const GridPlanes<D> planes(grid);
    Vec<D> low, high;
    for (int axis = 0; axis < D; ++axis) {
        low[axis] = planes.place[axis][complex.index.low[axis]];
        high[axis] = planes.place[axis][complex.index.high()[axis]];
    }
    // Corners and edges divide cells between them and other walls.
    low -= Vec<D>::Constant(2);
    high += Vec<D>::Constant(2);
    const bool edges_lead = D == 3 && mouths && !any_periodic(grid);
    if (edges_lead) // an edge's plane depends on all that lies along it, whichever rank has it
        for (int axis = 0; axis < D; ++axis) {
            low[axis] = planes.place[axis][planes.place[axis].first()] - 2;
            high[axis] = planes.place[axis][planes.place[axis].last()] + 2;
        }
    std::vector<PlacedSolid<D>> placed = place_solids<D>(grid, planes, solids, low, high);
    if constexpr (D == 2) {
        find_ways_out(grid, planes, placed);
        if (mouths)
            complex.mouths = find_mouths(planes, solids, placed);
    }
    std::optional<EdgeMouths> edge_mouths;
    if constexpr (D == 3)
        if (edges_lead)
            edge_mouths.emplace(planes, solids, placed);
    const CutFaces<D> cut = cut_faces<D>(grid, planes, complex.index, placed, derivatives || borders);
    complex.cell.assign(complex.index.count, Complex<D>::solid);
    std::vector<CellSlab<D>> slabs(cut.slabs.size());
    std::vector<PartsBeside> beside(cut.slabs.size());
    for_each_job(static_cast<int>(slabs.size()), [&](int s) { beside[s].assign(cut.slabs[s].pieces.size(), {-1, -1}); });
    std::optional<FacetsInCells> facets;
    if constexpr (D == 3)
        facets.emplace(planes, complex.index, placed);
    for_each_job(static_cast<int>(slabs.size()), [&](int s) {
        if constexpr (D == 3)
            slabs[s] = build_cells(grid, planes, complex.index, placed, cut, *facets, s, beside, complex.cell);
        else
            slabs[s] = build_cells(cut, complex.index, placed, s, beside[s], complex.cell);
    });
    Joining<D> joining(grid, planes, placed, cut, slabs, beside, complex, derivatives);
    std::vector<PieceSource> sources;
    joining.sources = derivatives ? &sources : nullptr;
    joining.join_faces();
    if constexpr (D == 3)
        if (edge_mouths)
            edge_mouths->add_to(complex);
    if (derivatives) {
        face_derivatives<D>(planes, complex.index, placed, cut, sources, *derivatives);
    }
    if (borders)
        *borders = part_borders<D>(grid, planes, complex, placed, cut, joining.parts_beside());
    complex.seen_mass = seen_masses<D>(grid, planes, solids, placed, complex, derivatives);
    complex.corners = corners_near(planes, placed, edge_mouths ? &*edge_mouths : nullptr);
    const std::vector<TwistMatrix<D>> corners = corner_masses(grid, complex);
    for (std::size_t s = 0; s < corners.size(); ++s)
        complex.seen_mass[s] += corners[s];
    return complex;
}

template Complex<2> build_complex(const Grid<2>&, std::span<const Solid<2>>, FaceDerivatives<2>*, std::vector<PartFace<2>>*,
                                  bool);
template Complex<3> build_complex(const Grid<3>&, std::span<const Solid<3>>, FaceDerivatives<3>*, std::vector<PartFace<3>>*,
                                  bool);

template <int D>
long Complex<D>::bytes() const
{
    const auto of = [](const auto& v) { return static_cast<long>(v.capacity() * sizeof(v[0])); };
    long areas = 0;
    for (const std::vector<double>& area : main_area)
        areas += of(area);
    return areas + of(cell) + of(cut_cell) + of(first_part) + of(part_cell) + of(part_area) + of(first_patch) + of(patches) +
           of(pieces) + of(links) + of(corners);
}

template DenseIndex<2>::DenseIndex(const Grid<2>&);
template DenseIndex<3>::DenseIndex(const Grid<3>&);
template struct Complex<2>;
template struct Complex<3>;

} // namespace gapflow
