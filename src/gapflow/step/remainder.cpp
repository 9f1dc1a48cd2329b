#include "gapflow/step/remainder.hpp"

#include "gapflow/core/sharing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace gapflow {
namespace {

/// Density times velocity, integrated along an edge: the sum of w p has this unit. `p`: with what other ranks have around this one's cells.
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

/// Whether a face lies between two cells of the domain.
template <int D>
bool is_inner(const Grid<D>& grid, int axis, const Index<D>& f)
{
    return grid.in_domain(grid.wrapped(f)) && grid.in_domain(grid.wrapped(Index<D>(f - step<D>(axis))));
}

/// The line integral along an edge, as a sum over velocities on faces of the grid: f(axis, face, length).
template <int D, class F>
void for_each_face_along(const Placed<D>& at, const SparseEdge<D>& edge, const F& f)
{
    const Grid<D>& grid = *at.coupling.grid;
    const DenseIndex<D>& index = at.complex.index;
    if (edge.link >= 0)
        return; // both nodes are at the cell's centre
    if (edge.piece >= 0) {
        const FacePiece<D>& piece = at.complex.pieces[edge.piece];
        const Index<D> face = at.complex.index.index(piece.face);
        f(int(piece.axis), face, face_length(grid, piece.axis, face));
        return;
    }
    const auto rows = at.edges.rows_of(edge);
    const Index<D> start = rows[0].cell;
    for (const auto& row : rows) { // along the grid's lines from the first row's cell
        Index<D> c = start;
        for (int axis = 0; axis < D; ++axis) {
            const int cells = grid.cells()[axis];
            int way = row.cell[axis] - c[axis];
            if (index.wraps[axis])
                way -= cells * static_cast<int>(std::lround(static_cast<double>(way) / cells));
            for (; way != 0; way -= way > 0 ? 1 : -1) {
                const Index<D> next = c + (way > 0 ? 1 : -1) * step<D>(axis), face = index.wrapped(way > 0 ? next : c);
                f(axis, face, (way > 0 ? -1 : 1) * row.weight * face_length(grid, axis, face));
                c = next;
            }
        }
    }
}

/// Adds to a field at cells of any rank in the layers around this one's.
template <int D>
class SumAtCells {
public:
    SumAtCells(const Grid<D>& grid, CellField<D>& field) : grid_(grid), field_(field) {}
    void add(const Index<D>& c, double value)
    {
        if (grid_.owns(c))
            field_(c) += value;
        else
            beyond_.emplace_back(grid_.key(grid_.wrapped(c)), value);
    }
    /// Gives what is another rank's to it. Collective.
    void finish()
    {
        if (grid_.comm().size() == 1)
            return;
        for (const auto& [key, value] : all_values(grid_.comm(), beyond_))
            if (const Index<D> c = grid_.cell_of_key(key); grid_.owns(c))
                field_(c) += value;
    }

private:
    const Grid<D>& grid_;
    CellField<D>& field_;
    std::vector<std::pair<long, double>> beyond_;
};

/// Adds f(edge, its number, axis, face, length) on the faces along all edges, whichever ranks have them. Collective.
template <int D, class F>
void add_along_edges(const Placed<D>& at, FaceField<D>& to, const F& f)
{
    const Grid<D>& grid = *at.coupling.grid;
    std::vector<SumAtCells<D>> inner; // the faces of edges that are another rank's lie between cells
    for (int axis = 0; axis < D; ++axis)
        inner.emplace_back(grid, to[axis]);
    for (std::size_t e = 0; e < at.edges.edges.size(); ++e)
        for_each_face_along(at, at.edges.edges[e], [&](int axis, const Index<D>& face, double length) {
            const double value = f(at.edges.edges[e], e, axis, face, length);
            if (owns_face(grid, axis, face))
                to(axis, face) += value;
            else
                inner[axis].add(face, value);
        });
    for (SumAtCells<D>& sum : inner)
        sum.finish();
    exchange(grid, to);
}

/// The remainder's momentum along what carries a flux.
template <int D>
double along(const Grid<D>& grid, const CarriedFlux<D>& flux, const Remainder<D>& remainder)
{
    return flux.axis >= 0 ? face_length(grid, flux.axis, flux.face) * remainder.faces(flux.axis, flux.face)
                          : remainder.edges[flux.edge];
}

/// Four faces meet at an edge of the grid (2D: a vertex) normal to the axes a and b: those around the low corner of cell v.
template <int D>
struct AroundEdge {
    std::array<Index<D>, 2> of_a, of_b;
    AroundEdge(int a, int b, const Index<D>& v) : of_a{Index<D>(v - step<D>(b)), v}, of_b{Index<D>(v - step<D>(a)), v} {}

    double curl(const Grid<D>& grid, int a, int b, const FaceField<D>& w) const
    {
        return (w(a, of_a[0]) - w(a, of_a[1])) / face_length(grid, b, of_b[1]) +
               (w(b, of_b[1]) - w(b, of_b[0])) / face_length(grid, a, of_a[1]);
    }
    template <class F>
    void for_each(int a, int b, const F& f) const
    {
        for (const Index<D>& face : of_a)
            f(a, face);
        for (const Index<D>& face : of_b)
            f(b, face);
    }
};

/// f(number of the pair, a, b, v) for the edges of the grid beside this rank's cells.
template <int D, class F>
void for_each_edge(const Grid<D>& grid, const F& f)
{
    int pair = 0;
    for (int a = 0; a < D; ++a)
        for (int b = a + 1; b < D; ++b, ++pair)
            for_each_index<D>(grid.low(), grid.high() + step<D>(a) + step<D>(b), [&](const Index<D>& v) { f(pair, a, b, v); });
}

template <int D>
Vec<D> place_of_edge(const Grid<D>& grid, int a, int b, const Index<D>& v)
{
    Vec<D> x;
    for (int axis = 0; axis < D; ++axis)
        x[axis] = axis == a || axis == b ? grid.face_place(axis, v[axis]) : grid.centre_place(axis, v[axis]);
    return x;
}

} // namespace

template <int D>
Remainder<D> remainder_of(const Placed<D>& at, FaceField<D> velocity)
{
    exchange(*at.coupling.grid, velocity);
    Remainder<D> remainder{std::move(velocity), {}};
    for (const SparseEdge<D>& edge : at.edges.edges) {
        double sum = 0;
        for_each_face_along(at, edge,
                            [&](int axis, const Index<D>& f, double length) { sum += length * remainder.faces(axis, f); });
        remainder.edges.push_back(sum);
    }
    return remainder;
}

template <int D>
std::vector<FaceAlong<D>> faces_along(const Placed<D>& at, const SparseEdge<D>& edge)
{
    std::vector<FaceAlong<D>> faces;
    for_each_face_along(at, edge, [&](int axis, const Index<D>& f, double length) { faces.push_back({axis, f, length}); });
    return faces;
}

template <int D>
UnknownVector<D> outflow_of_edges(const Placed<D>& at, const Remainder<D>& remainder)
{
    const Coupling<D>& coupling = at.coupling;
    UnknownVector<D> sum{CellField<D>(*coupling.grid), Eigen::VectorXd::Zero(coupling.system.nodes)};
    SumAtCells<D> cells(*coupling.grid, sum.cells);
    for (std::size_t e = 0; e < remainder.edges.size(); ++e) {
        const SparseEdge<D>& edge = at.edges.edges[e];
        const double flux = edge.conductance * coupling.density * remainder.edges[e];
        for (const auto& row : at.edges.rows_of(edge))
            if (row.node >= 0)
                sum.nodes[row.node] += row.weight * flux;
            else
                cells.add(row.cell, row.weight * flux);
    }
    cells.finish();
    coupling.grid->comm().sum(std::span<double>(sum.nodes.data(), sum.nodes.size()));
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
    if (!impulse.empty())
        coupling.grid->comm().sum(std::span<double>(impulse.data()->data(), impulse.size() * twist_size<D>));
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
            sum += flux(axis, f) * face_length(grid, axis, f) * flow.remainder.faces(axis, f);
        });
    return 0.5 * coupling.density * grid.face_area() * grid.comm().sum(sum);
}

template <int D>
FaceField<D> face_fluxes(const Placed<D>& at, const PotentialFlow<D>& flow)
{
    const Coupling<D>& coupling = at.coupling;
    const Grid<D>& grid = *coupling.grid;
    FluidVelocity<D> u{flow.remainder.faces, {}, {}, {}};
    UnknownVector<D> p = flow.p;
    subtract_gradient(coupling, p, u);
    exchange(grid, p.cells);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            u.grid(axis, f) = coupling.system.conductance(axis, f) > 0 ? coupling.open(axis, f) * u.grid(axis, f) : 0.0;
        });
    std::vector<double> through(at.edges.edges.size());
    for (std::size_t e = 0; e < through.size(); ++e) {
        const SparseEdge<D>& edge = at.edges.edges[e];
        through[e] = edge.conductance * (drop_along(at, edge, p) + coupling.density * flow.remainder.edges[e]);
    }
    for (const CarriedFlux<D>& of : at.edges.carried) {
        const double flux = of.flux.dot(flow.twists[of.solid]);
        if (of.axis >= 0)
            u.grid(of.axis, of.face) += flux / grid.face_area();
        else
            through[of.edge] += flux;
    }
    add_along_edges(at, u.grid, [&](const SparseEdge<D>&, std::size_t e, int axis, const Index<D>& f, double length) {
        return length / face_length(grid, axis, f) * through[e] / grid.face_area();
    });
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
    const double unit = coupling.density / std::pow(grid.dx(), D - 2);
    add_along_edges(at, open, [&](const SparseEdge<D>& edge, std::size_t, int, const Index<D>&, double length) {
        return edge.piece >= 0 ? at.complex.pieces[edge.piece].area : std::abs(length) / grid.dx() * unit * edge.conductance;
    });
    return open;
}

template <int D>
VorticityCarriers<D>::VorticityCarriers(const Placed<D>& at, FaceField<D> open_areas) : at_(&at), open_(std::move(open_areas))
{
    const Grid<D>& grid = *at.coupling.grid;
    for (CellField<D, int>& field : carrier_)
        field = CellField<D, int>(grid, nothing);
    const FaceClipper<D>& clipper = *at.coupling.clipper;
    std::vector<int> near;
    for_each_edge(grid, [&](int pair, int a, int b, const Index<D>& v) {
        double least = 1;
        bool inner = true;
        AroundEdge<D>(a, b, v).for_each(a, b, [&](int axis, const Index<D>& f) {
            inner = inner && is_inner(grid, axis, f);
            least = std::min(least, open_(axis, f) / grid.relative_area(axis, f));
        });
        if (!inner)
            return;
        int& carrier = carrier_[pair](v);
        carrier = fluid;
        if (least >= 1)
            return;
        const Vec<D> x = place_of_edge(grid, a, b, v);
        clipper.near(x, grid.dx(), near);
        double nearest = least > 0 ? 0 : std::numeric_limits<double>::infinity();
        for (const int k : near) {
            const Image<D>& image = clipper.images()[k];
            if (const double distance = image.shape.distance(x); distance < nearest) {
                carrier = k;
                nearest = distance;
            }
        }
        if (carrier != fluid && at.coupling.solids[clipper.images()[carrier].solid].wall)
            carrier = nothing;
    });
}

template <int D>
FaceField<D> vortex_impulse(const VorticityCarriers<D>& carriers, const FaceField<D>& flux, const std::vector<Twist<D>>& twists,
                            const FaceField<D>& remainder, double dt)
{
    const Placed<D>& at = carriers.at();
    const Grid<D>& grid = *at.coupling.grid;
    FaceField<D> result(grid);
    const auto share = [&](int axis, const Index<D>& f) { return carriers.open()(axis, f) / grid.relative_area(axis, f); };
    for_each_edge(grid, [&](int pair, int a, int b, const Index<D>& v) {
        const int carrier = carriers.of(pair, v);
        if (carrier == carriers.nothing)
            return;
        const AroundEdge<D> around(a, b, v);
        const double omega = around.curl(grid, a, b, remainder);
        if (omega == 0)
            return;
        const double along_a = face_length(grid, a, v), along_b = face_length(grid, b, v);
        int open_a = 0, open_b = 0;
        for (int k = 0; k < 2; ++k) {
            open_a += share(a, around.of_a[k]) > 0;
            open_b += share(b, around.of_b[k]) > 0;
        }
        for (const Index<D>& fa : around.of_a)
            for (const Index<D>& fb : around.of_b) {
                const double both = share(a, fa) + share(b, fb);
                if (!(both > std::max(share(a, fa), share(b, fb))))
                    continue; // one is closed
                // Half of the velocity's mean over the open faces b for a, and a for b.
                const double weight = 0.25 / open_a + 0.25 / open_b;
                const double factor =
                    weight * dt * omega * (along_a / grid.relative_area(b, fb) + along_b / grid.relative_area(a, fa)) / both;
                result(a, fa) += factor / along_a * flux(b, fb);
                result(b, fb) -= factor / along_b * flux(a, fa);
            }
        if (carrier == carriers.fluid)
            return;
        const Image<D>& image = at.coupling.clipper->images()[carrier];
        const Vec<D> arm = place_of_edge(grid, a, b, v) - at.coupling.solids[image.solid].centre - image.shift;
        const Vec<D> velocity = velocity_at<D>(twists[image.solid], arm);
        for (int k = 0; k < 2; ++k) {
            if (const Index<D>& f = around.of_a[k]; !(share(a, f) > 0))
                result(a, f) += 0.5 * dt * omega * velocity[b];
            if (const Index<D>& f = around.of_b[k]; !(share(b, f) > 0))
                result(b, f) -= 0.5 * dt * omega * velocity[a];
        }
    });
    return result;
}

template <int D>
void spread_in_solids(const VorticityCarriers<D>& carriers, FaceField<D>& velocity)
{
    constexpr int sweeps = 4;
    constexpr double damping = 0.25 / D; // half of what takes the shortest wave away at once
    const Grid<D>& grid = *carriers.at().coupling.grid;
    FaceField<D, int> within(grid, carriers.nothing); // the solid that carries all vorticity beside a closed face
    FaceField<D, std::int8_t> seen(grid);
    for_each_edge(grid, [&](int pair, int a, int b, const Index<D>& v) {
        AroundEdge<D>(a, b, v).for_each(a, b, [&](int axis, const Index<D>& f) {
            const int carrier = carriers.open()(axis, f) > 0 ? carriers.nothing : carriers.of(pair, v);
            within(axis, f) = !seen(axis, f) || within(axis, f) == carrier ? carrier : carriers.nothing;
            seen(axis, f) = 1;
        });
    });
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        FaceField<D> change(grid);
        for_each_edge(grid, [&](int pair, int a, int b, const Index<D>& v) {
            if (carriers.of(pair, v) < 0)
                return;
            const AroundEdge<D> around(a, b, v);
            const double by = damping * grid.dx() * grid.dx() * around.curl(grid, a, b, velocity);
            for (int side = 0; side < 2; ++side) {
                const double sign = side == 0 ? 1 : -1;
                change(a, around.of_a[side]) -= sign * by / face_length(grid, b, v);
                change(b, around.of_b[side]) += sign * by / face_length(grid, a, v);
            }
        });
        for (int axis = 0; axis < D; ++axis)
            for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
                if (within(axis, f) >= 0)
                    velocity(axis, f) += change(axis, f);
            });
        exchange(grid, velocity);
    }
}

namespace {

/// Values of the cells without fluid, such that the velocity less the gradient of all values over the density has no divergence there either: conjugate gradients.
template <int D>
void extend_into_solids(const Coupling<D>& coupling, const FaceField<D>& velocity, CellField<D>& p)
{
    constexpr double enough = 1e-3; // of the divergence at first: any field is a gauge
    const Grid<D>& grid = *coupling.grid;
    std::vector<Index<D>> cells;
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (coupling.system.component(c) < 0)
            cells.push_back(c);
    });
    if (!grid.comm().any(!cells.empty()))
        return;
    const auto for_each_face = [&](const Index<D>& c, const auto& f) {
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end)
                if (const Index<D> face = c + end * step<D>(axis); is_inner(grid, axis, face))
                    f(axis, face, Index<D>(end ? face : Index<D>(c - step<D>(axis))), end ? 1.0 : -1.0,
                      grid.relative_area(axis, face));
    };
    for (const Index<D>& c : cells)
        p(c) = 0;
    exchange(grid, p, 1);
    const std::size_t n = cells.size();
    std::vector<double> residual(n, 0.0), product(n);
    for (std::size_t k = 0; k < n; ++k)
        for_each_face(cells[k], [&](int axis, const Index<D>& f, const Index<D>& other, double sign, double area) {
            residual[k] += area * (p(other) / face_length(grid, axis, f) - sign * coupling.density * velocity(axis, f));
        });
    CellField<D> search(grid);
    const auto dot = [&](const std::vector<double>& a, const auto& b) {
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k)
            sum += a[k] * b(k);
        return grid.comm().sum(sum);
    };
    double square = dot(residual, [&](std::size_t k) { return residual[k]; });
    const double small = enough * enough * square;
    for (std::size_t k = 0; k < n; ++k)
        search(cells[k]) = residual[k];
    while (square > small) {
        exchange(grid, search, 1);
        for (std::size_t k = 0; k < n; ++k) {
            product[k] = 0;
            for_each_face(cells[k], [&](int axis, const Index<D>& f, const Index<D>& other, double, double area) {
                product[k] += area / face_length(grid, axis, f) * (search(cells[k]) - search(other));
            });
        }
        const double curvature = dot(product, [&](std::size_t k) { return search(cells[k]); });
        if (!(curvature > 0))
            break;
        const double step = square / curvature;
        for (std::size_t k = 0; k < n; ++k) {
            p(cells[k]) += step * search(cells[k]);
            residual[k] -= step * product[k];
        }
        const double before = square;
        square = dot(residual, [&](std::size_t k) { return residual[k]; });
        for (std::size_t k = 0; k < n; ++k)
            search(cells[k]) = residual[k] + square / before * search(cells[k]);
    }
}

} // namespace

template <int D>
void renew_gauge(const Placed<D>& at, PotentialFlow<D>& flow, const SolverOptions& options)
{
    const Coupling<D>& coupling = at.coupling;
    const Grid<D>& grid = *coupling.grid;
    CellField<D> p =
        flow_of_twists(at, std::vector<Twist<D>>(coupling.solids.size(), Twist<D>::Zero()), options, flow.remainder).p.cells;
    extend_into_solids(coupling, flow.remainder.faces, p);
    FluidVelocity<D> u{std::move(flow.remainder.faces), {}, {}, {}};
    UnknownVector<D> by{p, Eigen::VectorXd::Zero(coupling.system.nodes)};
    subtract_gradient(coupling, by, u);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            if (!(coupling.system.conductance(axis, f) > 0) && is_inner(grid, axis, f))
                u.grid(axis, f) -=
                    (by.cells(f) - by.cells(Index<D>(f - step<D>(axis)))) / (coupling.density * face_length(grid, axis, f));
        });
    flow.remainder = remainder_of(at, std::move(u.grid));
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (coupling.system.component(c) >= 0)
            flow.p.cells(c) -= p(c);
    });
    Eigen::VectorXd of_nodes = Eigen::VectorXd::Zero(coupling.system.nodes);
    for (int part = 0; part < at.complex.parts(); ++part)
        if (const Index<D> c = at.complex.cell_of_part(part); at.node[part] >= 0 && grid.owns(c))
            of_nodes[at.node[part]] = p(c);
    grid.comm().sum(std::span<double>(of_nodes.data(), of_nodes.size()));
    flow.p.nodes -= of_nodes;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Remainder<D> remainder_of<D>(const Placed<D>&, FaceField<D>);                                                     \
    template std::vector<FaceAlong<D>> faces_along<D>(const Placed<D>&, const SparseEdge<D>&);                                 \
    template UnknownVector<D> outflow_of_edges<D>(const Placed<D>&, const Remainder<D>&);                                      \
    template UnknownVector<D> outflow_of_remainder<D>(const Placed<D>&, const Remainder<D>&);                                  \
    template std::vector<Twist<D>> impulse_of_remainder<D>(const Placed<D>&, const Remainder<D>&);                             \
    template double energy_of_remainder<D>(const Placed<D>&, const PotentialFlow<D>&);                                         \
    template FaceField<D> face_fluxes<D>(const Placed<D>&, const PotentialFlow<D>&);                                           \
    template FaceField<D> open_areas<D>(const Placed<D>&);                                                                     \
    template class VorticityCarriers<D>;                                                                                       \
    template FaceField<D> vortex_impulse<D>(const VorticityCarriers<D>&, const FaceField<D>&, const std::vector<Twist<D>>&,    \
                                            const FaceField<D>&, double);                                                      \
    template void spread_in_solids<D>(const VorticityCarriers<D>&, FaceField<D>&);                                             \
    template void renew_gauge<D>(const Placed<D>&, PotentialFlow<D>&, const SolverOptions&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
