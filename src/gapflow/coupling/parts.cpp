#include "gapflow/coupling/parts.hpp"

#include "gapflow/core/sharing.hpp"
#include "gapflow/coupling/film_rows.hpp"
#include "gapflow/coupling/grid_conductance.hpp"
#include "gapflow/coupling/pressure_gauge.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace gapflow {
namespace {

/// A link between two nodes, or a node and a cell.
struct PartLink {
    double conductance;
    int node, other; ///< other: -1 where there is a cell
    long cell;
};

/// An entry of a link between several rows: a node's, or a cell's.
struct MouthEntry {
    bool first; ///< of its link
    int node;   ///< -1: a cell's
    long cell;
    double conductance, weight;
};

/// Of all ranks.
void add_mouths(const Communicator& comm, const std::vector<MouthEntry>& own, std::vector<Link>& links)
{
    for (const MouthEntry& entry : comm.size() == 1 ? own : all_values(comm, own)) {
        if (entry.first)
            links.push_back({entry.conductance, {}, {}});
        if (entry.node >= 0)
            links.back().nodes.emplace_back(entry.node, entry.weight);
        else
            links.back().cells.emplace_back(entry.cell, entry.weight);
    }
}

/// Of all ranks: parts of the system beside a rank's own film rows.
void add_links(const Communicator& comm, const std::vector<PartLink>& own, std::vector<Link>& links)
{
    for (const PartLink& link : comm.size() == 1 ? own : all_values(comm, own)) {
        if (link.other >= 0)
            links.push_back({link.conductance, {{link.node, 1.0}, {link.other, -1.0}}, {}});
        else
            links.push_back({link.conductance, {{link.node, 1.0}}, {{link.cell, -1.0}}});
    }
}

/// A mass in cells.
template <int D>
TwistMatrix<D> mass_in_world(const Coupling<D>& coupling, const TwistMatrix<D>& mass)
{
    const double dx = coupling.grid->dx();
    Twist<D> lengths = Twist<D>::Constant(std::sqrt(coupling.density * std::pow(dx, D)));
    lengths.template tail<spin_size<D>>() *= dx;
    return lengths.asDiagonal() * mass * lengths.asDiagonal();
}

/// A gap's mass, of twists in cells.
template <int D>
PairMass<D> gap_mass_in_world(const Coupling<D>& coupling, const PairMass<D>& mass)
{
    const double dx = coupling.grid->dx();
    PairMass<D> block = coupling.density * std::pow(dx, D) * mass;
    for (int side = 0; side < 2; ++side) {
        block.template middleRows<spin_size<D>>(side * twist_size<D> + D) *= dx;
        block.template middleCols<spin_size<D>>(side * twist_size<D> + D) *= dx;
    }
    return block;
}

/// Of a symmetric matrix.
using Modes = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;
[[gnu::noinline]] Modes modes_of(const Eigen::MatrixXd& mass)
{
    return Modes(mass);
}

/// What gaps add to the masses of two solids, of all ranks.
template <int D>
std::vector<PairInertia<D>> pairs_of_ranks(const Communicator& comm, const std::vector<PairInertia<D>>& own)
{
    std::vector<PairInertia<D>> pairs = comm.size() == 1 ? own : all_values(comm, own);
    merge_pairs(pairs);
    return pairs;
}

/// The mass that gaps add, of all ranks: as sums of squares of rows of twists, on one rank.
template <int D>
void add_gap_inertia(Coupling<D>& coupling, const std::vector<PairInertia<D>>& own)
{
    constexpr int T = twist_size<D>;
    const Communicator& comm = coupling.grid->comm();
    const std::vector<PairInertia<D>> pairs = pairs_of_ranks(comm, own);
    coupling.gap_deficit.assign(coupling.solids.size(), TwistMatrix<D>::Zero());
    for (const PairInertia<D>& pair : pairs) {
        std::vector<int> known; // components of the twists that the gap knows: the others' rows stay 0
        for (int i = 0; i < 2 * T; ++i)
            if (!pair.mass.col(i).isZero(0) || !pair.motion.col(i).isZero(0))
                known.push_back(i);
        if (known.empty())
            continue;
        GapDeficit<D> deficit{pair.a, pair.b, TwistMatrix<D>::Zero(), TwistMatrix<D>::Zero()};
        for (const bool all : {true, false}) {
            const Modes modes = modes_of(gap_mass_in_world(coupling, all ? pair.mass : pair.motion)(known, known));
            for (std::size_t k = 0; k < known.size(); ++k) {
                PairTwist<D> row = PairTwist<D>::Zero();
                row(known) = modes.eigenvectors().col(k);
                const Twist<D> a = row.template head<T>(), b = row.template tail<T>();
                const double m = modes.eigenvalues()[k];
                if (all && m != 0 && comm.root())
                    coupling.normal_inertia.push_back({pair.a, pair.b, a, b, m});
                if (!all && m < 0) { // (x_a + x_b)^2 <= 2 (x_a^2 + x_b^2)
                    deficit.of_a += Twist<D>(-2 * m * a) * a.transpose();
                    deficit.of_b += Twist<D>(-2 * m * b) * b.transpose();
                }
            }
        }
        coupling.gap_deficit[pair.a] += deficit.of_a;
        coupling.gap_deficit[pair.b] += deficit.of_b;
        coupling.gap_deficits.push_back(deficit);
    }
}

/// Weights of the terms of gaps that make uniform motion exact, by pairs of solids.
template <int D>
using MotionWeights = std::map<std::pair<std::int32_t, std::int32_t>, PairMass<D>>;

/// -weight/2 z . dG z of the deficit G of a solid by its gaps, as a sum over pairs of weights of dQ. G is twice the solid's block of the negative
/// part of each Q, whose derivative by Q are divided differences.
template <int D>
void add_deficit(const Coupling<D>& coupling, std::span<const PairInertia<D>> pairs, int solid, const WeightedTwist<D>& of,
                 MotionWeights<D>& to)
{
    constexpr int T = twist_size<D>;
    for (const PairInertia<D>& pair : pairs)
        for (int side = 0; side < 2; ++side) {
            if ((side == 0 ? pair.a : pair.b) != solid)
                continue;
            const Modes modes = modes_of(gap_mass_in_world(coupling, pair.motion));
            PairTwist<D> z; // along the modes
            for (int k = 0; k < 2 * T; ++k)
                z[k] = of.z.dot(modes.eigenvectors().col(k).template segment<T>(side * T));
            PairMass<D> by_motion = PairMass<D>::Zero();
            for (int i = 0; i < 2 * T; ++i)
                for (int j = 0; j < 2 * T; ++j) {
                    const double a = modes.eigenvalues()[std::min(i, j)], b = modes.eigenvalues()[std::max(i, j)]; // a <= b
                    const double factor = (b <= 0 ? 1.0 : a >= 0 ? 0.0 : a / (a - b)) * z[i] * z[j];
                    const PairTwist<D> scaled = factor * modes.eigenvectors().col(i);
                    for (int k = 0; k < 2 * T; ++k)
                        by_motion.col(k) += modes.eigenvectors()(k, j) * scaled;
                }
            to.try_emplace({pair.a, pair.b}, PairMass<D>::Zero()).first->second += 2 * of.weight * by_motion;
        }
}

} // namespace

/// Numbers of the nodes of parts: those that are not the largest of their cell, but slivers between lines from sharp corners without a way out.
/// In the order of their cells, whichever ranks have these. -1: none.
template <int D>
std::vector<int> nodes_of_parts(const Grid<D>& grid, const Complex<D>& complex, CoupledSystem<D>& system)
{
    std::vector<char> leads_on(complex.parts(), 0);
    for (const FacePiece<D>& piece : complex.pieces)
        for (const PartOrCell& side : {piece.low, piece.high})
            if (side.is_part() && piece.area > 0)
                leads_on[side.number()] = 1;
    for (const CornerLink<D>& link : complex.links)
        if (link.conductance > 0)
            leads_on[link.a] = leads_on[link.b] = 1;
    // A node's place, the same on all ranks: its cell, and which of its parts.
    using Place = std::array<long, 2>;
    const auto place_of = [&](int p) {
        return Place{grid.key(grid.wrapped(complex.cell_of_part(p))), p - complex.first_part[complex.part_cell[p]]};
    };
    std::vector<int> node(complex.parts(), -1);
    std::vector<Place> own;
    for (int p = 0; p < complex.parts(); ++p)
        if (!complex.is_main(p) && leads_on[p] && grid.owns(complex.cell_of_part(p))) {
            node[p] = static_cast<int>(own.size());
            own.push_back(place_of(p));
        }
    system.nodes = static_cast<int>(own.size());
    if (grid.comm().size() == 1)
        return node;
    std::vector<Place> all = all_values(grid.comm(), own);
    std::sort(all.begin(), all.end());
    system.nodes = static_cast<int>(all.size());
    system.own_node.assign(system.nodes, 0);
    for (int p = 0; p < complex.parts(); ++p)
        if (const auto found = std::lower_bound(all.begin(), all.end(), place_of(p));
            found != all.end() && *found == place_of(p)) {
            const bool owned = node[p] >= 0;
            node[p] = static_cast<int>(found - all.begin());
            if (owned)
                system.own_node[node[p]] = 1;
        }
    return node;
}

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

    const std::vector<int>& node = coupling.part_node = nodes_of_parts(grid, complex, system);
    coupling.open = FaceField<D>(grid, 0.0);
    coupling.kind = CellField<D, std::int8_t>(grid, static_cast<std::int8_t>(CellKind::solid));
    for_each_row_on_threads<D>(grid.low(), grid.high(), [&](const Index<D>& row) {
        const std::int32_t* cell = &complex.cell[complex.index(row)];
        std::int8_t* kind = &coupling.kind(row);
        for (int i = 0; i < grid.high()[0] - row[0]; ++i)
            if (cell[i] != Complex<D>::solid)
                kind[i] = static_cast<std::int8_t>(CellKind::bulk);
    });
    for (int axis = 0; axis < D; ++axis) {            // the faces on both sides of this rank's cells
        const bool wraps = complex.index.wraps[axis]; // the last face is the first one
        const Index<D> end = grid.high() + (wraps ? Index<D>(Index<D>::Zero()) : step<D>(axis));
        for_each_row_on_threads<D>(grid.low(), end, [&](const Index<D>& row) {
            const double* weight = &inertia.main_weight[axis][complex.index(row)];
            std::copy(weight, weight + (end[0] - row[0]), &coupling.open(axis, row));
        });
        if (wraps) {
            Index<D> low = grid.low(), high = grid.high();
            low[axis] = high[axis];
            high[axis] = low[axis] + 1;
            for_each_index<D>(low, high, [&](const Index<D>& f) {
                coupling.open(axis, f) = inertia.main_weight[axis][complex.index(complex.index.wrapped(f))];
            });
        }
    }
    fill_conductance(coupling);

    const double unit = std::pow(grid.dx(), D - 2) / density;
    std::vector<Eigen::Triplet<double>> film; ///< between own nodes
    std::vector<PartLink> links;
    const auto node_of = [&](const PartOrCell& side) { return side.is_part() ? node[side.number()] : -1; };
    // Between two parts or cells, not both their cell's largest.
    const auto join = [&](const PartOrCell& a, const PartOrCell& b, double g) {
        const int i = node_of(a), j = node_of(b);
        if (i >= 0 && j >= 0 && system.owns(i) && system.owns(j)) {
            if (i == j)
                return;
            film.emplace_back(i, i, g);
            film.emplace_back(j, j, g);
            film.emplace_back(i, j, -g);
            film.emplace_back(j, i, -g);
        } else if (i >= 0 && j >= 0)
            links.push_back({g, i, j, -1});
        else {
            const PartOrCell& cell = i >= 0 ? b : a;
            links.push_back({g, std::max(i, j), -1, grid.key(grid.wrapped(complex.index.index(complex.cell_of(cell))))});
        }
    };
    for (std::size_t k = 0; k < complex.links.size(); ++k)
        if (const CornerLink<D>& link = complex.links[k];
            inertia.link_conductance[k] > 0 && grid.owns(complex.cell_of_part(link.a)))
            join(PartOrCell::part(link.a), PartOrCell::part(link.b), unit * inertia.link_conductance[k]);
    for (std::size_t k = 0; k < complex.pieces.size(); ++k) {
        const FacePiece<D>& piece = complex.pieces[k];
        if (complex.joins_main(piece) || !(piece.area > 0))
            continue;
        const Index<D> f = complex.index.index(piece.face);
        if (!owns_face(grid, piece.axis, f))
            continue;
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
    add_links(grid.comm(), links, system.links);
    std::vector<MouthEntry> mouths;
    for (const RowsLink<D>& link : inertia.mouths) {
        if (!grid.owns(grid.wrapped(complex.index.index(complex.cell_of(link.first)))))
            continue;
        bool first = true;
        for (const auto& [row, weight] : link.rows) {
            const int i = node_of(row);
            const long cell = i < 0 ? grid.key(grid.wrapped(complex.index.index(complex.cell_of(row)))) : 0;
            mouths.push_back({std::exchange(first, false), i, cell, unit * link.conductance, weight});
        }
    }
    add_mouths(grid.comm(), mouths, system.links);

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
            if (!grid.owns(row))
                return;
            for (int k = complex.first_patch[p]; k < complex.first_patch[p + 1]; ++k)
                cells.add(coupling, row, complex.patches[k].solid, in_world(inertia.patch_flux[k]));
        },
        coupling.cell_flux, system.cell_flux);
    append_entries<D, Index<D>>(
        static_cast<long>(inertia.flux.size()),
        [&](long i, FluxEntries<D, Index<D>>& cells) {
            const LentFlux<D>& lent = inertia.flux[i];
            const Index<D> row = complex.index.index(complex.cell_of(lent.row));
            if (complex.is_main(lent.row) && grid.owns(row))
                cells.add(coupling, row, lent.solid, in_world(lent.flux));
        },
        coupling.cell_flux, system.cell_flux);
    FluxEntries<D, int> nodes;
    const auto has_row = [&](int p) { return node[p] >= 0 && system.owns(node[p]); };
    for (int p = 0; p < complex.parts(); ++p)
        for (int k = complex.first_patch[p]; has_row(p) && k < complex.first_patch[p + 1]; ++k)
            nodes.add(coupling, node[p], complex.patches[k].solid, in_world(inertia.patch_flux[k]));
    for (const LentFlux<D>& lent : inertia.flux)
        if (lent.row.is_part() && has_row(lent.row.number()))
            nodes.add(coupling, node[lent.row.number()], lent.solid, in_world(lent.flux));
    coupling.node_flux = std::move(nodes.all);
    system.node_flux = std::move(nodes.free);
    fill_mass(coupling, mass); // the bodies' own: D follows with add_seen_mass()
    for (const TwistMatrix<D>& seen : complex.seen_mass)
        coupling.seen_mass.push_back(mass_in_world(coupling, seen));
    add_gap_inertia(coupling, inertia.pairs);
    limit_deficits(coupling);
    system.response = BodyResponse(system.mass, {}, {});
    find_components(coupling);
    return coupling;
}

template <int D>
std::vector<Twist<D>>
energy_derivative(const Coupling<D>& coupling, const Complex<D>& complex, const FaceDerivatives<D>& derivatives,
                  const UnknownVector<D>& p, const std::vector<Twist<D>>& twists, const GapDerivatives<D>* of_gaps,
                  std::span<const PairInertia<D>> pairs, const std::vector<char>& wanted, const Circulation<D>* circulation)
{
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), 1) == wanted.end())
        return std::vector<Twist<D>>(twists.size(), Twist<D>::Zero());
    const double dx = coupling.grid->dx(), unit = coupling.density * dx * dx;
    const std::vector<int>& node = coupling.part_node;
    std::vector<TwistMatrix<D>> layers; // where a limit asks for them
    std::vector<PairInertia<D>> all_pairs;
    const auto in_cells = [&](const UnknownVector<D>& x, double factor) {
        Potentials<D> p{std::vector<double>(complex.parts(), 0), std::vector<double>(complex.index.count, 0)};
        CellField<D> shared; // with the cells of other ranks
        if (coupling.grid->comm().size() > 1) {
            shared = x.cells;
            exchange(*coupling.grid, shared, DenseIndex<D>::shared_layers);
        }
        const CellField<D>& cells = shared.size() > 0 ? shared : x.cells;
        for (int part = 0; part < complex.parts(); ++part)
            p.part[part] = node[part] >= 0         ? factor * x.nodes[node[part]]
                           : complex.is_main(part) ? factor * cells(complex.cell_of_part(part))
                                                   : 0.0;
        for_each_index<D>(complex.index.low, complex.index.high(),
                          [&](const Index<D>& c) { p.cell[complex.index(c)] = factor * cells(c); });
        return p;
    };
    const auto twist_in_cells = [&](Twist<D> twist) {
        twist.template head<D>() /= dx;
        return twist;
    };
    DerivedGaps<D> gaps{of_gaps, {}, {}, wanted};
    MotionWeights<D> deficits;
    std::vector<Twist<D>> V, sum(twists.size(), Twist<D>::Zero());
    std::vector<std::vector<WeightedTwist<D>>> seen;
    for (std::size_t s = 0; s < twists.size(); ++s) {
        V.push_back(twist_in_cells(twists[s]));
        const TwistMatrix<D> whole = mass_in_world(coupling, complex.seen_mass[s]);
        if ((coupling.seen_mass[s] - whole).norm() <= std::sqrt(std::numeric_limits<double>::epsilon()) * whole.norm()) {
            seen.push_back({{1.0, V.back()}});
            continue;
        }
        if (layers.empty()) {
            layers = layer_inertias(coupling);
            all_pairs = pairs_of_ranks<D>(coupling.grid->comm(), {pairs.begin(), pairs.end()});
        }
        LimitRate<D> limit =
            limit_rate<D>(coupling.solids[s], coupling.density, whole, layers[s] - coupling.gap_deficit[s], twists[s]);
        if (coupling.grid->comm().root())
            sum[s].template tail<spin_size<D>>() += limit.turn / (unit * std::pow(dx, D));
        for (WeightedTwist<D>& of : limit.seen)
            of.z = twist_in_cells(of.z);
        seen.push_back(std::move(limit.seen));
        for (const WeightedTwist<D>& of : limit.layer) {
            add_deficit<D>(coupling, all_pairs, static_cast<int>(s), of, deficits);
            const JacobiSteps<D> steps = jacobi_steps(coupling, static_cast<int>(s), of.z);
            const std::vector<Twist<D>> rate = layer_derivative<D>(
                *coupling.grid, complex, derivatives, in_cells(steps.first, 1 / unit), in_cells(steps.next, 1 / unit),
                static_cast<int>(s), {of.weight, twist_in_cells(of.z)}, gaps);
            for (std::size_t k = 0; k < rate.size(); ++k)
                sum[k] += rate[k];
        }
    }
    for (auto& [pair, weight] : deficits) {
        for (const int first : {0, twist_size<D>}) {
            weight.template middleRows<D>(first) /= dx;
            weight.template middleCols<D>(first) /= dx;
        }
        gaps.motion.push_back({pair.first, pair.second, weight});
    }
    const std::vector<Twist<D>> flow =
        energy_derivative<D>(*coupling.grid, complex, derivatives, in_cells(p, -1 / unit), std::span<const Twist<D>>(V),
                             std::span<const std::vector<WeightedTwist<D>>>(seen), gaps, circulation);
    for (std::size_t s = 0; s < sum.size(); ++s) {
        sum[s] = unit * std::pow(dx, D) * (sum[s] + flow[s]);
        sum[s].template head<D>() /= dx;
    }
    if (!sum.empty())
        coupling.grid->comm().sum(std::span<double>(sum.data()->data(), sum.size() * twist_size<D>));
    return sum;
}

template std::vector<int> nodes_of_parts(const Grid<2>&, const Complex<2>&, CoupledSystem<2>&);
template std::vector<int> nodes_of_parts(const Grid<3>&, const Complex<3>&, CoupledSystem<3>&);
template std::vector<Twist<2>> energy_derivative(const Coupling<2>&, const Complex<2>&, const FaceDerivatives<2>&,
                                                 const UnknownVector<2>&, const std::vector<Twist<2>>&,
                                                 const GapDerivatives<2>*, std::span<const PairInertia<2>>,
                                                 const std::vector<char>&, const Circulation<2>*);
template std::vector<Twist<3>> energy_derivative(const Coupling<3>&, const Complex<3>&, const FaceDerivatives<3>&,
                                                 const UnknownVector<3>&, const std::vector<Twist<3>>&,
                                                 const GapDerivatives<3>*, std::span<const PairInertia<3>>,
                                                 const std::vector<char>&, const Circulation<3>*);
template Coupling<2> couple_parts(const Grid<2>&, std::vector<Solid<2>>, const std::vector<TwistMatrix<2>>&, double,
                                  const Complex<2>&, const Inertia<2>&);
template Coupling<3> couple_parts(const Grid<3>&, std::vector<Solid<3>>, const std::vector<TwistMatrix<3>>&, double,
                                  const Complex<3>&, const Inertia<3>&);

} // namespace gapflow
