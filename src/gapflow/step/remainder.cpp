#include "gapflow/step/remainder.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/step/matching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace gapflow {
namespace {

/// Density times velocity, integrated along an edge: the sum of w p has this unit.
template <int D>
double drop_along(const Placed<D>& at, const SparseEdge<D>& edge, const UnknownVector<D>& p)
{
    double sum = 0;
    for (const auto& row : at.edges.rows_of(edge))
        sum += row.weight * (row.node >= 0 ? p.nodes[row.node] : p.cells(row.cell));
    return sum;
}

template <int D>
double face_length(const Grid<D>& grid, int axis, const Index<D>& f)
{
    return grid.dx() * grid.spread(axis, f[axis]);
}

/// The remainder's momentum along what carries a flux.
template <int D>
double along(const Grid<D>& grid, const CarriedFlux<D>& flux, const Remainder<D>& remainder)
{
    return flux.axis >= 0 ? face_length(grid, flux.axis, flux.face) * remainder.faces(flux.axis, flux.face)
                          : remainder.edges[flux.edge];
}

/// Of one complex, seen from another one.
template <int D>
class EarlierRemainder {
public:
    EarlierRemainder(const Placed<D>& before, const Remainder<D>& remainder, const Placed<D>& after)
        : grid_(*after.coupling.grid), before_(before), remainder_(remainder), after_(after),
          parts_(matched_parts(grid_, after.complex, before.complex))
    {
        const Complex<D>& old = before.complex;
        for (std::size_t k = 0; k < old.pieces.size(); ++k)
            if (old.pieces[k].area > 0)
                pieces_.emplace_back(old.pieces[k].axis, old.pieces[k].face, static_cast<std::int32_t>(k));
        std::sort(pieces_.begin(), pieces_.end());
        for (const SparseEdge<D>& edge : before.edges.edges)
            if (edge.link >= 0 || edge.mouth >= 0)
                others_.emplace_back(grid_.key(before.edges.rows_of(edge)[0].cell), &edge - before.edges.edges.data());
        std::sort(others_.begin(), others_.end());
    }

    /// Velocity on a face between two parts or cells.
    std::optional<double> velocity(int axis, const Index<D>& f, const PartOrCell& low, const PartOrCell& high) const
    {
        const PartOrCell from = was(low), to = was(high);
        if (from.exists() != low.exists() || to.exists() != high.exists())
            return {};
        const std::int32_t face = after_.complex.index(after_.complex.index.wrapped(f));
        bool cut = false;
        for (auto k = std::lower_bound(pieces_.begin(), pieces_.end(), std::tuple(std::int8_t(axis), face, -1));
             k != pieces_.end() && std::get<0>(*k) == axis && std::get<1>(*k) == face; ++k) {
            const FacePiece<D>& piece = before_.complex.pieces[std::get<2>(*k)];
            cut = true;
            if (piece.low.code != from.code || piece.high.code != to.code)
                continue;
            if (before_.complex.joins_main(piece))
                return remainder_.faces(axis, f);
            if (const std::int32_t edge = before_.edges.edge_of_piece[std::get<2>(*k)]; edge >= 0)
                return remainder_.edges[edge] / face_length(grid_, axis, f);
        }
        if (!cut && before_.coupling.system.conductance(axis, f) > 0 && before_.complex.is_main(from) &&
            before_.complex.is_main(to))
            return remainder_.faces(axis, f);
        return {};
    }

    /// Of a link, or a mouth.
    std::optional<double> along(const SparseEdge<D>& edge) const
    {
        const Complex<D>&here = after_.complex, &there = before_.complex;
        const long key = grid_.key(after_.edges.rows_of(edge)[0].cell);
        std::optional<double> value;
        double least = 0;
        for (auto k = std::lower_bound(others_.begin(), others_.end(), std::pair(key, 0L));
             k != others_.end() && k->first == key; ++k) {
            const SparseEdge<D>& old = before_.edges.edges[k->second];
            if ((old.link >= 0) != (edge.link >= 0))
                continue;
            double distance = 0;
            if (edge.link >= 0) {
                if (here.links[edge.link].solid != there.links[old.link].solid)
                    continue;
                distance = (here.links[edge.link].at - there.links[old.link].at).norm();
            }
            if (!value || distance < least) {
                value = remainder_.edges[k->second];
                least = distance;
            }
        }
        return value;
    }

private:
    PartOrCell was(const PartOrCell& side) const
    {
        if (!side.exists())
            return {};
        if (side.is_cell())
            return before_.complex.main_of(side.number());
        const MatchedPart& match = parts_[side.number()];
        return match.kind == MatchedPart::Kind::other  ? PartOrCell::part(match.part)
               : match.kind == MatchedPart::Kind::main ? before_.complex.main_of(after_.complex.cell_of(side))
                                                       : PartOrCell{};
    }

    const Grid<D>& grid_;
    const Placed<D>& before_;
    const Remainder<D>& remainder_;
    const Placed<D>& after_;
    std::vector<MatchedPart> parts_;                                          ///< of the later complex
    std::vector<std::tuple<std::int8_t, std::int32_t, std::int32_t>> pieces_; ///< of the earlier one: axis, face, number
    std::vector<std::pair<long, long>> others_;                               ///< cell, number of links and mouths
};

/// Edges of the grid (2D: vertices), normal to two axes, that lie in the fluid with all four faces around them open. The faces are those around the low corner of
/// cell v.
template <int D>
class FreeEdges {
public:
    explicit FreeEdges(const Placed<D>& at) : at_(at), open_(open_areas(at)) {}

    bool has(int a, int b, const Index<D>& v)
    {
        const Grid<D>& grid = *at_.coupling.grid;
        double least = 1;
        for (const auto& [axis, f] :
             {std::pair(a, v), std::pair(a, Index<D>(v - step<D>(b))), std::pair(b, v), std::pair(b, Index<D>(v - step<D>(a)))})
            least = std::min(least, open_(axis, f) / grid.relative_area(axis, f));
        if (!(least > 0))
            return false;
        if (least >= 1)
            return true;
        Vec<D> x;
        for (int axis = 0; axis < D; ++axis)
            x[axis] = axis == a || axis == b ? grid.face_place(axis, v[axis]) : grid.centre_place(axis, v[axis]);
        const FaceClipper<D>& clipper = *at_.coupling.clipper;
        clipper.near(x, 0, near_);
        return std::none_of(near_.begin(), near_.end(), [&](int k) {
            const Image<D>& image = clipper.images()[k];
            return !at_.coupling.solids[image.solid].wall && image.shape.distance(x) < 0;
        });
    }
    const FaceField<D>& open() const { return open_; }

private:
    const Placed<D>& at_;
    FaceField<D> open_;
    std::vector<int> near_;
};

/// Faces that some fluid passes.
template <int D>
FaceField<D, std::int8_t> passable(const Placed<D>& at)
{
    const Grid<D>& grid = *at.coupling.grid;
    FaceField<D, std::int8_t> faces(grid, std::int8_t(0));
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis),
                          [&](const Index<D>& f) { faces(axis, f) = at.coupling.system.conductance(axis, f) > 0; });
    for (const FacePiece<D>& piece : at.complex.pieces)
        if (const Index<D> f = at.complex.index.index(piece.face);
            piece.low.exists() && piece.high.exists() && piece.area > 0 && owns_face(grid, piece.axis, f))
            faces(piece.axis, f) = 1;
    return faces;
}

/// Values of faces that have none yet from those beside them along any axis, for as long as some get one.
template <int D>
void spread_out(const Grid<D>& grid, const FaceField<D, std::int8_t>& wanted, FaceField<D, std::int8_t>& known,
                FaceField<D>& values)
{
    constexpr int farthest = 4; // cells that a body uncovers in a step
    struct Found {
        int axis;
        Index<D> face;
        double value;
    };
    for (int layer = 0; layer < farthest; ++layer) {
        exchange(grid, values, 1);
        exchange(grid, known, 1);
        std::vector<Found> found;
        for (int axis = 0; axis < D; ++axis)
            for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
                if (!wanted(axis, f) || known(axis, f))
                    return;
                double sum = 0;
                int count = 0;
                for (int along = 0; along < D; ++along)
                    for (int side = -1; side < 2; side += 2)
                        if (const Index<D> g = f + side * step<D>(along); known(axis, g)) {
                            sum += values(axis, g);
                            ++count;
                        }
                if (count > 0)
                    found.push_back({axis, f, sum / count});
            });
        for (const Found& one : found) {
            values(one.axis, one.face) = one.value;
            known(one.axis, one.face) = 1;
        }
        if (grid.comm().sum(static_cast<long>(found.size())) == 0)
            break;
    }
    exchange(grid, values);
}

/// Of an edge across which the velocity is that of the faces beside it.
template <int D>
double fresh(const Placed<D>& at, const SparseEdge<D>& edge, const FaceField<D>& velocity)
{
    const Grid<D>& grid = *at.coupling.grid;
    if (edge.piece >= 0) {
        const FacePiece<D>& piece = at.complex.pieces[edge.piece];
        const Index<D> f = at.complex.index.index(piece.face);
        return face_length(grid, piece.axis, f) * velocity(piece.axis, f);
    }
    if (edge.link >= 0)
        return 0; // both nodes are at the cell's centre
    double sum = 0;
    const auto rows = at.edges.rows_of(edge);
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> c = rows[0].cell;
        const double u = 0.5 * (velocity(axis, c) + velocity(axis, Index<D>(c + step<D>(axis))));
        for (const auto& row : rows)
            sum -= row.weight * u * (grid.centre_place(axis, row.cell[axis]) - grid.centre_place(axis, c[axis]));
    }
    return sum;
}

} // namespace

template <int D>
void require_one_rank(const Model<D>& model)
{
    if (model.grid.comm().size() > 1)
        throw InputError(
            model.scene.file +
            ": gap.model: this version runs \"parts\" in fluid that has its own velocity on one rank; run it without "
            "mpirun (threads work), or write gap.model = \"film\"");
}

template <int D>
Remainder<D> remainder_of(const Placed<D>& at, FaceField<D> velocity)
{
    exchange(*at.coupling.grid, velocity);
    Remainder<D> remainder{std::move(velocity), {}};
    for (const SparseEdge<D>& edge : at.edges.edges)
        remainder.edges.push_back(fresh(at, edge, remainder.faces));
    return remainder;
}

template <int D>
Remainder<D> carried(const Placed<D>& before, const Remainder<D>& remainder, const Placed<D>& after)
{
    const Grid<D>& grid = *after.coupling.grid;
    const Complex<D>& complex = after.complex;
    const EarlierRemainder<D> earlier(before, remainder, after);
    Remainder<D> result{FaceField<D>(grid), std::vector<double>(after.edges.edges.size())};
    FaceField<D, std::int8_t> known(grid, std::int8_t(0));
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            if (after.coupling.system.conductance(axis, f) > 0 && before.coupling.system.conductance(axis, f) > 0) {
                result.faces(axis, f) = remainder.faces(axis, f);
                known(axis, f) = 1;
            }
        });
    for (const FacePiece<D>& piece : complex.pieces) {
        const Index<D> f = complex.index.index(piece.face);
        if (!complex.joins_main(piece) || !piece.low.exists() || !piece.high.exists() || !(piece.area > 0) ||
            !owns_face(grid, piece.axis, f))
            continue;
        const auto velocity = earlier.velocity(piece.axis, f, piece.low, piece.high);
        known(piece.axis, f) = velocity.has_value();
        result.faces(piece.axis, f) = velocity.value_or(0.0);
    }
    spread_out(grid, passable(after), known, result.faces);
    for (std::size_t e = 0; e < result.edges.size(); ++e) {
        const SparseEdge<D>& edge = after.edges.edges[e];
        std::optional<double> value;
        if (edge.piece >= 0) {
            const FacePiece<D>& piece = complex.pieces[edge.piece];
            const Index<D> f = complex.index.index(piece.face);
            if (value = earlier.velocity(piece.axis, f, piece.low, piece.high); value)
                *value *= face_length(grid, piece.axis, f);
        } else
            value = earlier.along(edge);
        result.edges[e] = value ? *value : fresh(after, edge, result.faces);
    }
    return result;
}

template <int D>
UnknownVector<D> outflow_of_edges(const Placed<D>& at, const Remainder<D>& remainder)
{
    const Coupling<D>& coupling = at.coupling;
    UnknownVector<D> sum{CellField<D>(*coupling.grid), Eigen::VectorXd::Zero(coupling.system.nodes)};
    for (std::size_t e = 0; e < remainder.edges.size(); ++e) {
        const SparseEdge<D>& edge = at.edges.edges[e];
        const double flux = edge.conductance * coupling.density * remainder.edges[e];
        for (const auto& row : at.edges.rows_of(edge))
            (row.node >= 0 ? sum.nodes[row.node] : sum.cells(row.cell)) += row.weight * flux;
    }
    return sum;
}

template <int D>
UnknownVector<D> outflow_of_remainder(const Placed<D>& at, const Remainder<D>& remainder)
{
    const Coupling<D>& coupling = at.coupling;
    UnknownVector<D> sum = outflow_of_edges(at, remainder), faces;
    outflow(coupling, {remainder.faces, {}, {}, {}}, std::vector<Twist<D>>(coupling.solids.size(), Twist<D>::Zero()), faces);
    for (long i = 0; i < sum.cells.size(); ++i)
        sum.cells.data()[i] += faces.cells.data()[i];
    return sum;
}

template <int D>
std::vector<Twist<D>> impulse_of_remainder(const Placed<D>& at, const Remainder<D>& remainder)
{
    const Coupling<D>& coupling = at.coupling;
    std::vector<Twist<D>> impulse(coupling.solids.size(), Twist<D>::Zero());
    for (const CarriedFlux<D>& flux : at.edges.carried)
        impulse[flux.solid] -= coupling.density * along(*coupling.grid, flux, remainder) * flux.flux;
    return impulse;
}

template <int D>
double energy_of_remainder(const Placed<D>& at, const PotentialFlow<D>& flow)
{
    const Coupling<D>& coupling = at.coupling;
    const Grid<D>& grid = *coupling.grid;
    const FaceField<D> flux = face_fluxes(at, flow);
    double sum = 0;
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            sum += grid.face_area() * flux(axis, f) * face_length(grid, axis, f) * flow.remainder.faces(axis, f);
        });
    for (std::size_t e = 0; e < flow.remainder.edges.size(); ++e) {
        const SparseEdge<D>& edge = at.edges.edges[e];
        sum += flow.remainder.edges[e] * edge.conductance *
               (drop_along(at, edge, flow.p) + coupling.density * flow.remainder.edges[e]);
    }
    for (const CarriedFlux<D>& of : at.edges.carried)
        if (of.axis < 0)
            sum += flow.remainder.edges[of.edge] * of.flux.dot(flow.twists[of.solid]);
    return 0.5 * coupling.density * sum;
}

template <int D>
FaceField<D> face_fluxes(const Placed<D>& at, const PotentialFlow<D>& flow)
{
    const Coupling<D>& coupling = at.coupling;
    const Grid<D>& grid = *coupling.grid;
    FluidVelocity<D> u{flow.remainder.faces, {}, {}, {}};
    UnknownVector<D> p = flow.p;
    subtract_gradient(coupling, p, u);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            u.grid(axis, f) = coupling.system.conductance(axis, f) > 0 ? coupling.open(axis, f) * u.grid(axis, f) : 0.0;
        });
    for (const CarriedFlux<D>& of : at.edges.carried)
        if (of.axis >= 0)
            u.grid(of.axis, of.face) += of.flux.dot(flow.twists[of.solid]) / grid.face_area();
    exchange(grid, u.grid);
    return std::move(u.grid);
}

template <int D>
FaceField<D> open_areas(const Placed<D>& at)
{
    const Coupling<D>& coupling = at.coupling;
    const Grid<D>& grid = *coupling.grid;
    FaceField<D> open(grid, 0.0);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            open(axis, f) = coupling.system.conductance(axis, f) > 0 ? coupling.open(axis, f) : 0.0;
        });
    exchange(grid, open);
    return open;
}

template <int D>
FaceField<D> vortex_impulse(const Placed<D>& at, const FaceField<D>& open, const FaceField<D>& flux,
                            const FaceField<D>& remainder, double dt)
{
    const Coupling<D>& coupling = at.coupling;
    const Grid<D>& grid = *coupling.grid;
    FaceField<D> result(grid);
    FreeEdges<D> free(at);
    for (int a = 0; a < D; ++a)
        for (int b = a + 1; b < D; ++b)
            for_each_index<D>(grid.low(), grid.high() + step<D>(a) + step<D>(b), [&](const Index<D>& v) {
                // Around the edge of the grid at the low corner of cell v.
                const std::array<Index<D>, 2> of_a{Index<D>(v - step<D>(b)), v}, of_b{Index<D>(v - step<D>(a)), v};
                if (!free.has(a, b, v))
                    return;
                const auto share = [&](int axis, const Index<D>& f) { return open(axis, f) / grid.relative_area(axis, f); };
                const double along_a = face_length(grid, a, v), along_b = face_length(grid, b, v);
                const double omega = (remainder(a, of_a[0]) - remainder(a, of_a[1])) / along_b +
                                     (remainder(b, of_b[1]) - remainder(b, of_b[0])) / along_a;
                if (omega == 0)
                    return;
                for (const Index<D>& fa : of_a)
                    for (const Index<D>& fb : of_b) {
                        const double factor = 0.25 * dt * omega *
                                              (along_a / grid.relative_area(b, fb) + along_b / grid.relative_area(a, fa)) /
                                              (share(a, fa) + share(b, fb));
                        if (owns_face(grid, a, fa))
                            result(a, fa) += factor / along_a * flux(b, fb);
                        if (owns_face(grid, b, fb))
                            result(b, fb) -= factor / along_b * flux(a, fa);
                    }
            });
    return result;
}

template <int D>
void renew_gauge(const Placed<D>& at, PotentialFlow<D>& flow, const SolverOptions& options)
{
    const Coupling<D>& coupling = at.coupling;
    PotentialFlow<D> of_remainder =
        flow_of_twists(at, std::vector<Twist<D>>(coupling.solids.size(), Twist<D>::Zero()), options, flow.remainder);
    FluidVelocity<D> u{std::move(flow.remainder.faces), {}, {}, {}};
    subtract_gradient(coupling, of_remainder.p, u);
    flow.remainder.faces = std::move(u.grid);
    exchange(*coupling.grid, flow.remainder.faces);
    for (std::size_t e = 0; e < flow.remainder.edges.size(); ++e)
        flow.remainder.edges[e] += drop_along(at, at.edges.edges[e], of_remainder.p) / coupling.density;
    for (long i = 0; i < flow.p.cells.size(); ++i)
        flow.p.cells.data()[i] -= of_remainder.p.cells.data()[i];
    flow.p.nodes -= of_remainder.p.nodes;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void require_one_rank<D>(const Model<D>&);                                                                        \
    template Remainder<D> remainder_of<D>(const Placed<D>&, FaceField<D>);                                                     \
    template Remainder<D> carried<D>(const Placed<D>&, const Remainder<D>&, const Placed<D>&);                                 \
    template UnknownVector<D> outflow_of_edges<D>(const Placed<D>&, const Remainder<D>&);                                      \
    template UnknownVector<D> outflow_of_remainder<D>(const Placed<D>&, const Remainder<D>&);                                  \
    template std::vector<Twist<D>> impulse_of_remainder<D>(const Placed<D>&, const Remainder<D>&);                             \
    template double energy_of_remainder<D>(const Placed<D>&, const PotentialFlow<D>&);                                         \
    template FaceField<D> face_fluxes<D>(const Placed<D>&, const PotentialFlow<D>&);                                           \
    template FaceField<D> open_areas<D>(const Placed<D>&);                                                                     \
    template FaceField<D> vortex_impulse<D>(const Placed<D>&, const FaceField<D>&, const FaceField<D>&, const FaceField<D>&,   \
                                            double);                                                                           \
    template void renew_gauge<D>(const Placed<D>&, PotentialFlow<D>&, const SolverOptions&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
