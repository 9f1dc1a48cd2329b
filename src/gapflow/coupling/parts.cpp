#include "gapflow/coupling/parts.hpp"

#include "gapflow/coupling/film_rows.hpp"
#include "gapflow/coupling/grid_conductance.hpp"
#include "gapflow/coupling/pressure_gauge.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace gapflow {
namespace {

/// Parts that are not the largest of their cell, in their order; but slivers between lines from sharp corners without a way out. Others: -1.
template <int D>
std::vector<int> nodes_of_parts(const Complex<D>& complex, int& count)
{
    std::vector<char> leads_on(complex.parts(), 0);
    for (const FacePiece<D>& piece : complex.pieces)
        for (const PartOrCell& side : {piece.low, piece.high})
            if (side.is_part() && piece.area > 0)
                leads_on[side.number()] = 1;
    for (const CornerLink<D>& link : complex.links)
        if (link.conductance > 0)
            leads_on[link.a] = leads_on[link.b] = 1;
    std::vector<int> node(complex.parts(), -1);
    for (int p = 0; p < complex.parts(); ++p)
        if (!complex.is_main(p) && leads_on[p])
            node[p] = count++;
    return node;
}

} // namespace

template <int D>
Coupling<D> couple_parts(const Grid<D>& grid, std::vector<Solid<D>> solids, const std::vector<TwistMatrix<D>>& mass,
                         double density, const Complex<D>& complex, const Inertia<D>& inertia)
{
    Coupling<D> coupling;
    coupling.grid = &grid;
    coupling.density = density;
    coupling.solids = std::move(solids);
    CoupledSystem<D>& system = coupling.system;
    system.grid = &grid;
    for (const Solid<D>& solid : coupling.solids)
        coupling.free_body.push_back(solid.motion == Motion::free ? system.bodies++ : -1);

    const std::vector<int> node = nodes_of_parts(complex, system.nodes);
    coupling.open = FaceField<D>(grid, 0.0);
    coupling.kind = CellField<D, std::int8_t>(grid, static_cast<std::int8_t>(CellKind::solid));
    for_each_row_on_threads<D>(grid.low(), grid.high(), [&](const Index<D>& row) {
        const std::int32_t* cell = &complex.cell[complex.index(row)];
        std::int8_t* kind = &coupling.kind(row);
        for (int i = 0; i < grid.high()[0] - row[0]; ++i)
            if (cell[i] != Complex<D>::solid)
                kind[i] = static_cast<std::int8_t>(CellKind::bulk);
    });
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> end = owned_faces_end(grid, axis);
        for_each_row_on_threads<D>(grid.low(), end, [&](const Index<D>& row) {
            const double* weight = &inertia.main_weight[axis][complex.index(row)];
            std::copy(weight, weight + (end[0] - row[0]), &coupling.open(axis, row));
        });
        if (grid.periodic(axis)) { // the last face is the first one
            Index<D> low = grid.low(), high = grid.high();
            low[axis] = high[axis];
            high[axis] = low[axis] + 1;
            for_each_index<D>(low, high, [&](const Index<D>& f) {
                coupling.open(axis, f) = inertia.main_weight[axis][complex.index(grid.wrapped(f))];
            });
        }
    }
    fill_conductance(coupling);

    const double unit = std::pow(grid.dx(), D - 2) / density;
    std::vector<Eigen::Triplet<double>> film;
    const auto node_of = [&](const PartOrCell& side) { return side.is_part() ? node[side.number()] : -1; };
    // Between two parts or cells, not both their cell's largest.
    const auto join = [&](const PartOrCell& a, const PartOrCell& b, double g) {
        const int i = node_of(a), j = node_of(b);
        if (i >= 0 && j >= 0) {
            if (i == j)
                return;
            film.emplace_back(i, i, g);
            film.emplace_back(j, j, g);
            film.emplace_back(i, j, -g);
            film.emplace_back(j, i, -g);
        } else {
            const PartOrCell& cell = i >= 0 ? b : a;
            system.links.push_back(
                {g, {{std::max(i, j), 1.0}}, {{grid.key(complex.index.index(complex.cell_of(cell))), -1.0}}});
        }
    };
    for (const CornerLink<D>& link : complex.links)
        if (link.conductance > 0)
            join(PartOrCell::part(link.a), PartOrCell::part(link.b), unit * link.conductance);
    for (std::size_t k = 0; k < complex.pieces.size(); ++k) {
        const FacePiece<D>& piece = complex.pieces[k];
        if (complex.joins_main(piece) || !(piece.area > 0))
            continue;
        const Index<D> f = complex.index.index(piece.face);
        const double g = unit * inertia.piece_weight[k] / grid.spread(piece.axis, f[piece.axis]);
        const int low = node_of(piece.low), high = node_of(piece.high);
        if (!piece.low.exists() || !piece.high.exists()) { // a side of the domain
            const int i = std::max(low, high), end = piece.low.exists();
            if (i >= 0 && is_open(grid.side(piece.axis, end)))
                film.emplace_back(i, i, g * side_factor(grid, piece.axis, f, end));
        } else
            join(piece.low, piece.high, g);
    }
    system.film.resize(system.nodes, system.nodes);
    system.film.setFromTriplets(film.begin(), film.end());

    const double area = std::pow(grid.dx(), D - 1);
    const auto in_world = [&](const Twist<D>& flux) {
        Twist<D> world = area * flux;
        world.template tail<spin_size<D>>() *= grid.dx();
        return world;
    };
    append_entries<D, Index<D>>(
        complex.cut_cells(),
        [&](long c, FluxEntries<D, Index<D>>& cells) {
            const int p = complex.first_part[c];
            const Index<D> row = complex.index.index(complex.cut_cell[c]);
            for (int k = complex.first_patch[p]; k < complex.first_patch[p + 1]; ++k)
                cells.add(coupling, row, complex.patches[k].solid, in_world(inertia.patch_flux[k]));
        },
        coupling.cell_flux, system.cell_flux);
    append_entries<D, Index<D>>(
        static_cast<long>(inertia.flux.size()),
        [&](long i, FluxEntries<D, Index<D>>& cells) {
            const LentFlux<D>& lent = inertia.flux[i];
            if (complex.is_main(lent.row))
                cells.add(coupling, complex.index.index(complex.cell_of(lent.row)), lent.solid, in_world(lent.flux));
        },
        coupling.cell_flux, system.cell_flux);
    FluxEntries<D, int> nodes;
    for (int p = 0; p < complex.parts(); ++p)
        for (int k = complex.first_patch[p]; node[p] >= 0 && k < complex.first_patch[p + 1]; ++k)
            nodes.add(coupling, node[p], complex.patches[k].solid, in_world(inertia.patch_flux[k]));
    for (const LentFlux<D>& lent : inertia.flux)
        if (lent.row.is_part() && node[lent.row.number()] >= 0)
            nodes.add(coupling, node[lent.row.number()], lent.solid, in_world(lent.flux));
    coupling.node_flux = std::move(nodes.all);
    system.node_flux = std::move(nodes.free);
    fill_mass(coupling, mass); // the bodies' own: D follows with add_seen_mass()
    for (std::size_t s = 0; s < coupling.solids.size(); ++s)
        for (int d = 0; d < D; ++d)
            if (const double mass_of = density * std::pow(grid.dx(), D) * complex.seen_excess[s][d]; mass_of != 0) {
                Twist<D> row = Twist<D>::Zero();
                row[d] = 1;
                coupling.normal_inertia.push_back({static_cast<int>(s), static_cast<int>(s), row, Twist<D>::Zero(), mass_of});
            }
    limit_deficits(coupling);
    // What gaps add, as sums of squares of rows of twists.
    for (const PairInertia<D>& pair : inertia.pairs) {
        constexpr int T = twist_size<D>;
        PairMass<D> block = density * std::pow(grid.dx(), D) * pair.mass;
        for (int side = 0; side < 2; ++side) {
            block.template middleRows<spin_size<D>>(side * T + D) *= grid.dx();
            block.template middleCols<spin_size<D>>(side * T + D) *= grid.dx();
        }
        const Eigen::SelfAdjointEigenSolver<PairMass<D>> modes(block);
        for (int k = 0; k < 2 * T; ++k)
            if (const double m = modes.eigenvalues()[k]; m != 0)
                coupling.normal_inertia.push_back({pair.a, pair.b, modes.eigenvectors().col(k).template head<T>(),
                                                   modes.eigenvectors().col(k).template tail<T>(), m});
    }
    system.response = BodyResponse(system.mass, {}, {});
    find_components(coupling);
    return coupling;
}

template <int D>
std::vector<Twist<D>> energy_derivative(const Coupling<D>& coupling, const Complex<D>& complex,
                                        const FaceDerivatives<D>& derivatives, const UnknownVector<D>& p,
                                        const std::vector<Twist<D>>& twists)
{
    const double dx = coupling.grid->dx(), in_cells = -1 / (coupling.density * dx * dx);
    Potentials<D> potentials{std::vector<double>(complex.parts(), 0), std::vector<double>(complex.index.count, 0)};
    int nodes = 0;
    const std::vector<int> node = nodes_of_parts(complex, nodes);
    for (int part = 0; part < complex.parts(); ++part)
        potentials.part[part] = node[part] >= 0         ? in_cells * p.nodes[node[part]]
                                : complex.is_main(part) ? in_cells * p.cells(complex.cell_of_part(part))
                                                        : 0.0;
    for_each_index<D>(coupling.grid->low(), coupling.grid->high(),
                      [&](const Index<D>& c) { potentials.cell[complex.index(c)] = in_cells * p.cells(c); });
    std::vector<Twist<D>> V = twists;
    for (Twist<D>& twist : V)
        twist.template head<D>() /= dx;
    std::vector<Twist<D>> result =
        energy_derivative<D>(*coupling.grid, complex, derivatives, potentials, std::span<const Twist<D>>(V));
    for (Twist<D>& of : result) {
        of *= coupling.density * std::pow(dx, D + 2);
        of.template head<D>() /= dx;
    }
    return result;
}

template std::vector<Twist<2>> energy_derivative(const Coupling<2>&, const Complex<2>&, const FaceDerivatives<2>&,
                                                 const UnknownVector<2>&, const std::vector<Twist<2>>&);
template std::vector<Twist<3>> energy_derivative(const Coupling<3>&, const Complex<3>&, const FaceDerivatives<3>&,
                                                 const UnknownVector<3>&, const std::vector<Twist<3>>&);
template Coupling<2> couple_parts(const Grid<2>&, std::vector<Solid<2>>, const std::vector<TwistMatrix<2>>&, double,
                                  const Complex<2>&, const Inertia<2>&);
template Coupling<3> couple_parts(const Grid<3>&, std::vector<Solid<3>>, const std::vector<TwistMatrix<3>>&, double,
                                  const Complex<3>&, const Inertia<3>&);

} // namespace gapflow
