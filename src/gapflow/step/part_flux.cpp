#include "gapflow/step/part_flux.hpp"

#include "gapflow/complex/gap_surface.hpp"
#include "gapflow/step/gap_speed.hpp"
#include "gapflow/step/inner_faces.hpp"
#include "gapflow/step/remainder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace gapflow {
namespace {

/// `fluxes`: of the motion relative to the stream.
template <int D>
FaceFluxes<D> fluxes_of_faces(const Placed<D>& at, const Instant<D>& instant, const State<D>& state, EdgeFluxes<D> fluxes)
{
    const Grid<D>& grid = *at.coupling.grid;
    const Vec<D>& stream = instant.stream;
    FaceFluxes<D> result{on_faces(at, std::move(fluxes)), FaceField<D>(grid), FaceField<D>(grid)};
    FaceField<D> covered(grid);
    for (const CarriedFlux<D>& of : at.edges.covered) {
        covered(of.axis, of.face) += of.flux[of.axis] / grid.face_area();
        result.bodies(of.axis, of.face) +=
            of.flux.dot(instant.flow.twists[of.solid] + stream_twist<D>(stream)) / grid.face_area();
    }
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            if (is_inner(grid, axis, f))
                result.fluid(axis, f) += stream[axis] * (grid.relative_area(axis, f) - covered(axis, f));
            else if (const int end = f[axis] > 0; grid.side(axis, end) == SideKind::inflow)
                result.fluid(axis, f) = at.coupling.open(axis, f) * state.velocity.grid(axis, f);
            else if (is_open(grid.side(axis, end)))
                result.fluid(axis, f) += stream[axis] * at.coupling.open(axis, f);
        });
    const UnknownVector<D> p = potentials_around(instant);
    for (const GapArm<D>& arm : at.arms) {
        const FacePiece<D>& piece = at.complex.pieces[arm.piece];
        if (const Index<D> f = at.complex.index.index(piece.face); is_of_gap(arm) && owns_face(grid, piece.axis, f))
            result.gaps(piece.axis, f) += piece.area * (velocity_through(instant, p, arm) + stream[piece.axis]);
    }
    return result;
}

/// Cells of a pair's gap, in groups that hang together, and what leaves them.
template <int D>
class GapEnds {
public:
    GapEnds(const Placed<D>& at, const std::array<std::string, 2>& bodies)
        : at_(at), grid_(*at.coupling.grid), in_gap_(at.complex.parts(), 0)
    {
        const auto& solids = at.coupling.solids;
        for (const GapArm<D>& arm : at.arms) {
            const std::string &a = solids[arm.solid[0]].name, &b = solids[arm.solid[1]].name;
            if (!is_of_gap(arm) || !((a == bodies[0] && b == bodies[1]) || (a == bodies[1] && b == bodies[0])))
                continue;
            arms_.push_back(&arm);
            const FacePiece<D>& piece = at.complex.pieces[arm.piece];
            for (const PartOrCell& side : {piece.low, piece.high})
                if (side.is_part())
                    in_gap_[side.number()] = 1;
        }
    }
    bool any() const { return !arms_.empty(); }
    bool holds(const PartOrCell& side) const { return side.is_part() && in_gap_[side.number()]; }

    using Rows = std::vector<std::pair<PartOrCell, double>>;
    /// The flux of an edge, of which `rows` have what leaves each; x: where. An edge between two parts of the gap takes from one what it gives to the other.
    void add(double flux, const Rows& rows, const Vec<D>& x)
    {
        double out = 0;
        PartOrCell own;
        bool leaves = false;
        for (const auto& [side, weight] : rows)
            if (holds(side)) {
                out += weight * flux;
                own = side;
            } else
                leaves = true;
        if (leaves && own.exists())
            ends_.push_back({grid_.wrapped(at_.complex.index.index(at_.complex.cell_of(own))), out, x});
    }

    /// Collective.
    VolumeFlux flux(const std::optional<Vec<D>>& along) const
    {
        std::vector<double> sums(3, 0.0);
        for (const End& end : ends_) {
            sums[0] += std::max(-end.flux, 0.0);
            sums[1] += std::max(end.flux, 0.0);
        }
        if (along)
            sums[2] = flux_along(*along);
        grid_.comm().sum(sums);
        const double flux = along ? 0.5 * sums[2] : 0.5 * (sums[0] + sums[1]);
        return {flux, flux, 0, sums[0], sums[1]};
    }

private:
    struct End {
        Index<D> cell;
        double flux;
        Vec<D> x;
    };

    /// Twice what flows through the middle of the groups: 0 where a gap is squeezed alike to both sides.
    double flux_along(const Vec<D>& direction) const
    {
        const CellField<D, double> group = groups();
        std::map<double, std::pair<double, double>> extent; // along the direction
        for (std::int32_t part = 0; part < static_cast<std::int32_t>(in_gap_.size()); ++part)
            if (const Index<D> c = at_.complex.cell_of_part(part); in_gap_[part] && grid_.owns(c)) {
                const double height = direction.dot(grid_.cell_centre(c));
                auto& [low, high] = extent.try_emplace(group(c), height, height).first->second;
                low = std::min(low, height);
                high = std::max(high, height);
            }
        // Of all ranks: a group has the key of one of its cells.
        const long cells = grid_.cells().template cast<long>().prod();
        std::vector<double> key, low, high;
        for (const auto& [number, ends] : extent)
            key.push_back(number);
        std::vector<double> used(cells, 0.0);
        for (const double k : key)
            used[static_cast<long>(k)] = 1;
        grid_.comm().max(used);
        key.clear();
        for (long k = 0; k < cells; ++k)
            if (used[k] > 0)
                key.push_back(static_cast<double>(k));
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (const double k : key) {
            const auto found = extent.find(k);
            low.push_back(found == extent.end() ? -infinity : -found->second.first);
            high.push_back(found == extent.end() ? -infinity : found->second.second);
        }
        grid_.comm().max(low);
        grid_.comm().max(high);
        double sum = 0;
        for (const End& end : ends_) {
            const auto k = std::lower_bound(key.begin(), key.end(), group(end.cell)) - key.begin();
            const double height = end.x.dot(direction) - 0.5 * (high[k] - low[k]);
            if (std::abs(height) > 1e-9 * grid_.dx()) // one in the middle, to round-off, counts to neither side
                sum += height > 0 ? end.flux : -end.flux;
        }
        return sum;
    }
    /// For each cell of the gap the least key of those that hang together with it. Collective.
    CellField<D, double> groups() const
    {
        CellField<D, double> group(grid_, std::numeric_limits<double>::infinity());
        for (std::int32_t part = 0; part < static_cast<std::int32_t>(in_gap_.size()); ++part)
            if (const Index<D> c = at_.complex.cell_of_part(part); in_gap_[part] && grid_.owns(c))
                group(c) = static_cast<double>(grid_.key(c));
        for (bool again = true; again;) {
            exchange(grid_, group, 1);
            bool changed = false;
            for (const GapArm<D>* arm : arms_) {
                const FacePiece<D>& piece = at_.complex.pieces[arm->piece];
                const Index<D> high = at_.complex.index.index(piece.face), low = high - step<D>(piece.axis);
                if (!holds(piece.low) || !holds(piece.high) || !(grid_.owns(low) || grid_.owns(high)))
                    continue;
                const double least = std::min(group(low), group(high));
                for (const Index<D>& c : {low, high})
                    if (group(c) != least) {
                        group(c) = least;
                        changed = true;
                    }
            }
            again = grid_.comm().any(changed);
        }
        return group;
    }

    const Placed<D>& at_;
    const Grid<D>& grid_;
    std::vector<char> in_gap_; ///< each part
    std::vector<const GapArm<D>*> arms_;
    std::vector<End> ends_;
};

/// Faces between the largest parts of two cells that meet in the gap's parts, which have a piece or are open as a whole.
template <int D>
void add_faces(const Placed<D>& at, const FaceField<D>& flux, GapEnds<D>& ends)
{
    const Grid<D>& grid = *at.coupling.grid;
    const Complex<D>& complex = at.complex;
    for (std::int32_t part = 0; part < complex.parts(); ++part) {
        if (!ends.holds(PartOrCell::part(part)) || !complex.is_main(part))
            continue;
        const Index<D> c = complex.cell_of_part(part);
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end) {
                const Index<D> f = c + end * step<D>(axis), next = c + (2 * end - 1) * step<D>(axis);
                if (!is_inner(grid, axis, f) || !owns_face(grid, axis, f) || flux(axis, f) == 0)
                    continue;
                const PartOrCell other = complex.main_of(complex.index(complex.index.wrapped(next)));
                if (!ends.holds(other))
                    ends.add((2 * end - 1) * grid.face_area() * flux(axis, f), {{PartOrCell::part(part), 1}, {other, -1}},
                             grid.face_centre(axis, f));
            }
    }
}

template <int D>
VolumeFlux flux_of_gap(const Placed<D>& at, const FluxScene& through, const EdgeFluxes<D>& fluxes)
{
    const Grid<D>& grid = *at.coupling.grid;
    const Complex<D>& complex = at.complex;
    GapEnds<D> ends(at, through.bodies);
    if (!grid.comm().any(ends.any())) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan, nan, nan, nan};
    }
    std::vector<PartOrCell> part_of_node(at.coupling.system.nodes);
    for (std::int32_t part = 0; part < complex.parts(); ++part)
        if (at.node[part] >= 0)
            part_of_node[at.node[part]] = PartOrCell::part(part);
    add_faces(at, fluxes.face, ends);
    for (std::size_t e = 0; e < fluxes.edge.size(); ++e) {
        const SparseEdge<D>& edge = at.edges.edges[e];
        typename GapEnds<D>::Rows rows;
        Vec<D> x = Vec<D>::Zero();
        for (const auto& row : at.edges.rows_of(edge)) {
            rows.emplace_back(row.node >= 0 ? part_of_node[row.node] : complex.main_of(complex.index(row.cell)), row.weight);
            x += grid.cell_centre(row.cell) / static_cast<double>(edge.rows);
        }
        if (edge.piece >= 0)
            x = grid.anchor() + grid.dx() * complex.pieces[edge.piece].centroid;
        ends.add(fluxes.edge[e], rows, x);
    }
    return ends.flux(through.along ? std::optional<Vec<D>>(Vec<D>(through.along->data())) : std::nullopt);
}

} // namespace

template <int D>
VolumeFlux flux_on_parts(const Model<D>& model, const Instant<D>& instant, const State<D>& state, const FluxScene& through)
{
    std::unique_ptr<Placed<D>> built;
    if (instant.flow.remainder.empty() && model.scene.fluxes.empty())
        built = placed(model, state.bodies, model.masses(state.bodies, state.dt), true);
    const Placed<D>& at = built ? *built : *instant.placed;
    EdgeFluxes<D> fluxes = edge_fluxes(at, instant.flow);
    if (through.kind == FluxScene::Kind::gap)
        return flux_of_gap(at, through, fluxes);
    const FaceFluxes<D> of_faces = fluxes_of_faces(at, instant, state, std::move(fluxes));
    return volume_flux(model, at.coupling, state, model.twists(state.bodies), through, &of_faces);
}

template VolumeFlux flux_on_parts<2>(const Model<2>&, const Instant<2>&, const State<2>&, const FluxScene&);
template VolumeFlux flux_on_parts<3>(const Model<3>&, const Instant<3>&, const State<3>&, const FluxScene&);

} // namespace gapflow
