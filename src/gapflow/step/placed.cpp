#include "gapflow/step/placed.hpp"

#include "gapflow/complex/gap_arm.hpp"
#include "gapflow/complex/mouth_arm.hpp"
#include "gapflow/coupling/grid_conductance.hpp"
#include "gapflow/coupling/pressure_gauge.hpp"
#include "gapflow/step/covered.hpp"
#include "gapflow/stepping/standoff.hpp"
#include "gapflow/viscous/form.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace gapflow {
namespace {

template <int D>
EdgesOfParts<D> edges_of_parts(const Grid<D>& grid, const Coupling<D>& coupling, const Complex<D>& complex,
                               std::span<const MouthArm<D>> arms, const Inertia<D>& inertia)
{
    EdgesOfParts<D> result;
    result.edge_of_piece.assign(complex.pieces.size(), -1);
    result.edge_of_link.assign(complex.links.size(), -1);
    const double unit = std::pow(grid.dx(), D - 2) / coupling.density;
    const auto in_world = [&](const Vec<D>& x) { return Vec<D>(grid.anchor() + grid.dx() * x); };
    const auto begin = [&](double conductance, std::int32_t piece, std::int32_t link, std::int32_t mouth) {
        result.edges.push_back({conductance, piece, link, mouth, static_cast<std::int32_t>(result.rows.size()), 0});
        return static_cast<std::int32_t>(result.edges.size()) - 1;
    };
    const auto add_row = [&](const PartOrCell& side, double weight) {
        const int node = side.is_part() ? coupling.part_node[side.number()] : -1;
        if (node < 0 && !complex.is_main(side))
            return; // a sliver without a way out
        result.rows.push_back({node, complex.index.index(complex.cell_of(side)), weight});
        ++result.edges.back().rows;
    };
    for (std::size_t k = 0; k < complex.pieces.size(); ++k) {
        const FacePiece<D>& piece = complex.pieces[k];
        const Index<D> f = complex.index.index(piece.face);
        if (complex.joins_main(piece) || !(piece.area > 0) || !owns_face(grid, piece.axis, f))
            continue;
        double g = unit * inertia.piece_weight[k] / grid.spread(piece.axis, f[piece.axis]);
        if (!piece.low.exists() || !piece.high.exists()) { // a side of the domain
            const int end = piece.low.exists();
            if (!is_open(grid.side(piece.axis, end)))
                continue;
            g *= side_factor(grid, piece.axis, f, end);
        }
        result.edge_of_piece[k] = begin(g, static_cast<std::int32_t>(k), -1, -1);
        if (piece.low.exists())
            add_row(piece.low, 1);
        if (piece.high.exists())
            add_row(piece.high, -1);
    }
    for (std::size_t k = 0; k < complex.links.size(); ++k)
        if (const CornerLink<D>& link = complex.links[k]; grid.owns(complex.cell_of_part(link.a))) {
            result.edge_of_link[k] = begin(unit * inertia.link_conductance[k], -1, static_cast<std::int32_t>(k), -1);
            add_row(PartOrCell::part(link.a), 1);
            add_row(PartOrCell::part(link.b), -1);
        }
    std::vector<std::int32_t> edge_of_mouth(inertia.mouths.size(), -1);
    auto arm = arms.begin();
    for (std::size_t k = 0; k < inertia.mouths.size(); ++k, ++arm) {
        while (!(arm->resistance > 0))
            ++arm;
        const RowsLink<D>& mouth = inertia.mouths[k];
        if (!grid.owns(grid.wrapped(complex.index.index(complex.cell_of(mouth.first)))))
            continue;
        edge_of_mouth[k] = begin(unit * mouth.conductance, -1, -1, static_cast<std::int32_t>(k));
        for (const auto& [row, weight] : mouth.rows)
            add_row(row, weight);
        result.in_mouths.push_back(
            {edge_of_mouth[k], arm->solid,
             in_world(arm->link >= 0 ? complex.links[arm->link].at : complex.pieces[arm->piece].centroid)});
    }
    const double area = std::pow(grid.dx(), D - 1);
    for (const FaceFlux<D>& of : inertia.face_flux) {
        Twist<D> flux = area * of.flux;
        flux.template tail<spin_size<D>>() *= grid.dx();
        const std::int32_t edge = of.mouth >= 0 ? edge_of_mouth[of.mouth] : of.piece >= 0 ? result.edge_of_piece[of.piece] : -1;
        if (edge >= 0)
            result.carried.push_back({-1, Index<D>::Zero(), edge, of.solid, flux});
        else if (of.mouth < 0 && of.piece < 0)
            if (const Index<D> f = complex.index.index(of.face); owns_face(grid, of.axis, f))
                result.carried.push_back({of.axis, f, -1, of.solid, flux});
    }
    return result;
}

/// The edges of voids are edges of the complex, but carry nothing there.
template <int D>
void leave_void_edges(Placed<D>& at)
{
    EdgesOfParts<D>& edges = at.edges;
    std::vector<std::int32_t> of_mouth; // by numbers in Inertia::mouths
    for (std::size_t e = 0; e < edges.edges.size(); ++e)
        if (edges.edges[e].mouth >= 0)
            of_mouth.push_back(static_cast<std::int32_t>(e));
    std::vector<std::int32_t> number; // there, by numbers in Voids::mouths
    for (const MouthArm<D>& mouth : at.voids.mouths)
        number.push_back((number.empty() ? 0 : number.back()) + (mouth.resistance > 0));
    for (VoidEdge<D>& edge : at.voids.edges) {
        edge.edge = edge.mouth >= 0 ? of_mouth[number[edge.mouth] - 1] : edge.piece >= 0 ? edges.edge_of_piece[edge.piece] : -1;
        if (edge.edge < 0) { // a face of the grid
            edge.edge = static_cast<std::int32_t>(edges.edges.size());
            edges.edges.push_back({0, edge.piece, -1, -1, static_cast<std::int32_t>(edges.rows.size()),
                                   static_cast<std::int32_t>(edge.rows.size())});
            for (std::size_t r = 0; r < edge.rows.size(); ++r) {
                const PartOrCell side = side_of(at.complex, edge.sites[r]);
                edges.rows.push_back({side.is_part() ? at.coupling.part_node[side.number()] : -1,
                                      at.complex.index.index(at.complex.cell_of(side)), edge.rows[r].second});
            }
        }
        edges.edges[edge.edge].conductance = 0;
    }
    const Grid<D>& grid = *at.coupling.grid; // and those through sides of the domain
    const long cells = grid.cells().template cast<long>().prod();
    std::set<long> empty;
    for (const VoidPart<D>& part : at.voids.parts)
        if (at.voids.is_void(part.part))
            empty.insert(part.row);
    for (SparseEdge<D>& edge : edges.edges)
        for (const auto& row : edges.rows_of(edge))
            if (empty.contains(row.node >= 0 ? cells + row.node : grid.key(grid.wrapped(row.cell))))
                edge.conductance = 0;
}

/// What follows from the arms, the mouths, and their voids.
template <int D>
void couple(const Model<D>& model, const std::vector<Solid<D>>& solids, const std::vector<TwistMatrix<D>>& mass,
            std::vector<MouthArm<D>> mouths, Placed<D>& at)
{
    const Complex<D>& complex = at.complex;
    const bool with_edges = at.rotational || !model.scene.fluxes.empty(); // which are measured by them
    const bool with_voids = voids_are_possible(model.scene);
    if (with_voids)
        leave_empty(complex, at.voids, at.arms, mouths);
    const Inertia<D> inertia = find_inertia<D>(model.grid, complex, at.arms, mouths, with_edges);
    at.pairs = inertia.pairs;
    at.coupling = couple_parts<D>(model.grid, solids, mass, model.scene.density, complex, inertia);
    if (with_voids) {
        separate(complex, inertia, at.voids, at.coupling);
        shut_empty(complex, at.voids, at.arms);
    }
    add_seen_mass(at.coupling);
    at.coupling.clipper = std::make_shared<FaceClipper<D>>(model.grid, at.coupling.solids, FractionMode::cut_cell);
    at.coupling.fractions = std::make_shared<FaceFractions<D>>(face_fractions(model.grid, *at.coupling.clipper));
    at.node = at.coupling.part_node;
    if (!at.arms.empty())
        at.gaps = std::make_unique<const GapDerivatives<D>>(model.grid, at.coupling.solids, complex, at.arms);
    if (with_edges) {
        at.edges = edges_of_parts<D>(model.grid, at.coupling, complex, mouths, inertia);
        at.edges.covered = covered_fluxes(at);
    }
    if (at.rotational)
        leave_void_edges(at);
}

} // namespace

template <int D>
std::unique_ptr<Placed<D>> placed(const Model<D>& model, const std::vector<RigidBody<D>>& bodies,
                                  const std::vector<TwistMatrix<D>>& mass, bool circulation, const VoidsBefore<D>* voids)
{
    auto result = std::make_unique<Placed<D>>();
    result->rotational = circulation;
    const auto [solids, standoffs] = rough_solids<D>(model.scene, model.grid, model.solids(bodies));
    PartBorders<D> borders;
    result->complex = build_complex<D>(model.grid, solids, &result->derivatives, model.viscous() ? &borders : nullptr);
    if (model.viscous())
        result->viscous = std::make_shared<const ViscousForm<D>>(build_viscous_form<D>(
            model.grid, solids, result->complex, borders, find_gap_drag<D>(model.grid, solids, result->complex, standoffs)));
    result->arms = find_gap_arms<D>(model.grid, solids, result->complex, standoffs);
    std::vector<MouthArm<D>> mouths = find_mouth_arms<D>(model.grid, solids, result->complex, standoffs);
    if (voids_are_possible(model.scene))
        result->voids = find_voids<D>(model, solids, result->complex, result->arms, mouths, voids);
    couple<D>(model, solids, mass, std::move(mouths), *result);
    return result;
}

template <int D>
Placed<D> placed_for_energy(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, bool circulation)
{
    Placed<D> result;
    const auto [solids, standoffs] = rough_solids<D>(model.scene, model.grid, model.solids(bodies));
    result.complex = build_complex<D>(model.grid, solids);
    const Complex<D>& complex = result.complex;
    const std::vector<MouthArm<D>> mouths = find_mouth_arms<D>(model.grid, solids, complex, standoffs);
    const Inertia<D> inertia =
        find_inertia<D>(model.grid, complex, find_gap_arms<D>(model.grid, solids, complex, standoffs), mouths, circulation);
    const std::vector<TwistMatrix<D>> mass(solids.size(), TwistMatrix<D>::Identity());
    result.coupling = couple_parts<D>(model.grid, solids, mass, model.scene.density, complex, inertia);
    result.node = result.coupling.part_node;
    result.rotational = circulation;
    if (circulation) {
        result.coupling.clipper = std::make_shared<FaceClipper<D>>(model.grid, result.coupling.solids, FractionMode::cut_cell);
        result.edges = edges_of_parts<D>(model.grid, result.coupling, complex, mouths, inertia);
        result.edges.covered = covered_fluxes(result);
    }
    return result;
}

template <int D>
void put_voids(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const std::vector<TwistMatrix<D>>& mass,
               std::vector<double> volume, Placed<D>& at)
{
    at.voids.volume = std::move(volume);
    at.voids.edges.clear();
    at.arms = at.voids.arms;
    couple<D>(model, rough_solids<D>(model.scene, model.grid, model.solids(bodies)).solids, mass, at.voids.mouths, at);
}

template <int D>
std::vector<GapArm<D>> own_arms(const Placed<D>& at)
{
    std::vector<GapArm<D>> own;
    for (const GapArm<D>& arm : at.arms) {
        const FacePiece<D>& piece = at.complex.pieces[arm.piece];
        if (owns_face(*at.coupling.grid, piece.axis, at.complex.index.index(piece.face)))
            own.push_back(arm);
    }
    return own;
}

template <int D>
Coupling<D> with_given_twists(Coupling<D> coupling)
{
    coupling.system.bodies = 0;
    std::fill(coupling.free_body.begin(), coupling.free_body.end(), -1);
    coupling.system.cell_flux.clear();
    coupling.system.node_flux.clear();
    coupling.system.mass.resize(0, 0);
    coupling.gauge_cells.clear();
    coupling.gauge_nodes.clear();
    find_components(coupling);
    return coupling;
}

template std::unique_ptr<Placed<2>> placed<2>(const Model<2>&, const std::vector<RigidBody<2>>&,
                                              const std::vector<TwistMatrix<2>>&, bool, const VoidsBefore<2>*);
template std::unique_ptr<Placed<3>> placed<3>(const Model<3>&, const std::vector<RigidBody<3>>&,
                                              const std::vector<TwistMatrix<3>>&, bool, const VoidsBefore<3>*);
template Placed<2> placed_for_energy<2>(const Model<2>&, const std::vector<RigidBody<2>>&, bool);
template Placed<3> placed_for_energy<3>(const Model<3>&, const std::vector<RigidBody<3>>&, bool);
template void put_voids<2>(const Model<2>&, const std::vector<RigidBody<2>>&, const std::vector<TwistMatrix<2>>&,
                           std::vector<double>, Placed<2>&);
template std::vector<GapArm<2>> own_arms<2>(const Placed<2>&);
template void put_voids<3>(const Model<3>&, const std::vector<RigidBody<3>>&, const std::vector<TwistMatrix<3>>&,
                           std::vector<double>, Placed<3>&);
template std::vector<GapArm<3>> own_arms<3>(const Placed<3>&);
template Coupling<2> with_given_twists<2>(Coupling<2>);
template Coupling<3> with_given_twists<3>(Coupling<3>);

} // namespace gapflow
