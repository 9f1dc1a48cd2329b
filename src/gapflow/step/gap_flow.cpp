#include "gapflow/step/gap_flow.hpp"

#include "gapflow/complex/gap_surface.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/core/sharing.hpp"
#include "gapflow/step/gap_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <tuple>

namespace gapflow {
namespace {

/// This rank's parts in gaps, with their pairs.
template <int D>
std::set<std::tuple<int, int, std::int32_t>> gap_parts(const Placed<D>& at)
{
    const Grid<D>& grid = *at.coupling.grid;
    std::set<std::tuple<int, int, std::int32_t>> parts;
    for (const GapArm<D>& arm : at.arms) {
        if (!is_of_gap(arm))
            continue;
        const auto [a, b] = std::minmax(arm.solid[0], arm.solid[1]);
        const FacePiece<D>& piece = at.complex.pieces[arm.piece];
        for (const PartOrCell& side : {piece.low, piece.high})
            if (side.is_part() && grid.owns(at.complex.cell_of_part(side.number())))
                parts.emplace(a, b, side.number());
    }
    return parts;
}

template <int D, class Row>
std::vector<double> numbers_of(const std::vector<Row>& rows)
{
    std::vector<double> numbers;
    numbers.reserve(D * rows.size());
    for (const Row& row : rows)
        for (int k = 0; k < D; ++k)
            numbers.push_back(row[k]);
    return numbers;
}
template <int D, class Row>
std::vector<Row> rows_of(const std::vector<double>& numbers)
{
    std::vector<Row> rows(numbers.size() / D);
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (int k = 0; k < D; ++k)
            rows[i][k] = static_cast<std::decay_t<decltype(rows[i][k])>>(numbers[D * i + k]);
    return rows;
}

/// Of all ranks, gaps of the same solids as one.
template <int D>
GapMeshes<D> of_all_ranks(const Communicator& comm, const GapMeshes<D>& own)
{
    if (comm.size() == 1)
        return own;
    const auto all = [&](const std::vector<double>& values) { return all_values(comm, values); };
    GapMeshes<D> meshes;
    std::vector<double> nodes_before(comm.size(), 0.0), gaps_before(comm.size(), 0.0);
    for (int rank = comm.rank() + 1; rank < comm.size(); ++rank) {
        nodes_before[rank] = static_cast<double>(own.nodes.size());
        gaps_before[rank] = static_cast<double>(own.solids.size());
    }
    comm.sum(nodes_before);
    comm.sum(gaps_before);
    const int first_node = static_cast<int>(nodes_before[comm.rank()]), first_gap = static_cast<int>(gaps_before[comm.rank()]);
    std::vector<std::array<int, 2>> solids;
    for (const auto& [a, b] : own.solids)
        solids.push_back({a, b});
    solids = rows_of<2, std::array<int, 2>>(all(numbers_of<2>(solids)));
    std::map<std::array<int, 2>, int> number;
    for (const auto& pair : solids)
        number.emplace(pair, 0);
    for (auto& [pair, k] : number) {
        k = static_cast<int>(meshes.solids.size());
        meshes.solids.emplace_back(pair[0], pair[1]);
    }
    const auto gaps = [&](const std::vector<int>& of) {
        std::vector<double> values;
        for (const int gap : of)
            values.push_back(first_gap + gap);
        std::vector<int> result;
        for (const double value : all(values))
            result.push_back(number[solids[static_cast<std::size_t>(value)]]);
        return result;
    };
    meshes.node_gap = gaps(own.node_gap);
    meshes.element_gap = gaps(own.element_gap);
    std::vector<std::array<int, D>> elements = own.elements;
    for (auto& element : elements)
        for (int& node : element)
            node += first_node;
    meshes.nodes = rows_of<D, Vec<D>>(all(numbers_of<D>(own.nodes)));
    meshes.elements = rows_of<D, std::array<int, D>>(all(numbers_of<D>(elements)));
    meshes.velocity = rows_of<D, Vec<D>>(all(numbers_of<D>(own.velocity)));
    meshes.normal = rows_of<D, Vec<D>>(all(numbers_of<D>(own.normal)));
    meshes.thickness = all(own.thickness);
    meshes.pressure = all(own.pressure);
    meshes.void_depth = all(own.void_depth);
    meshes.area = all(own.area);
    return meshes;
}

/// Areas of the walls of a pair in a part, half of both; of a body and a side of the domain, which has none, that of the body.
template <int D>
double wall_area(const Placed<D>& at, std::int32_t part, int a, int b)
{
    double sum = 0;
    for (const WallPatch<D>& patch : at.complex.patches_of(part))
        if (patch.solid == a || patch.solid == b)
            sum += patch.area.norm();
    const auto& solids = at.coupling.solids;
    return (solids[a].wall || solids[b].wall ? 1.0 : 0.5) * sum * at.coupling.grid->face_area();
}

} // namespace

template <int D>
int count_gap_parts(const Placed<D>& at)
{
    std::set<std::int32_t> parts;
    for (const auto& [a, b, part] : gap_parts(at))
        parts.insert(part);
    return static_cast<int>(at.coupling.grid->comm().sum(static_cast<long>(parts.size())));
}

template <int D>
GapMeshes<D> gap_meshes(const Model<D>& model, const Instant<D>& instant, const State<D>& state)
{
    const Placed<D>& at = *instant.placed;
    const Grid<D>& grid = *at.coupling.grid;
    const UnknownVector<D> p = reduced_pressure(state);
    const auto through = flow_through_gaps(instant);
    GapMeshes<D> meshes;
    for (const GapSurface<D>& surface : gap_surfaces<D>(grid, at.coupling.solids, at.complex, at.arms)) {
        const auto [a, b] = surface.solid;
        const int number = static_cast<int>(meshes.solids.size()), first = static_cast<int>(meshes.nodes.size());
        meshes.solids.emplace_back(a, b);
        for (std::size_t i = 0; i < surface.points.size(); ++i) {
            double pressure = 0, depth = 0;
            for (const std::int32_t part : surface.parts[i]) {
                pressure += value_of(at, p, PartOrCell::part(part)) / static_cast<double>(surface.parts[i].size());
                if (instant.kept.is_void(part))
                    depth +=
                        instant.kept.volume[part] / wall_area(at, part, a, b) / static_cast<double>(surface.parts[i].size());
            }
            meshes.nodes.push_back(surface.points[i]);
            meshes.node_gap.push_back(number);
            meshes.thickness.push_back(surface.thickness[i]);
            meshes.pressure.push_back(pressure + model.hydrostatic(surface.points[i]));
            meshes.void_depth.push_back(depth);
        }
        for (const typename GapSurface<D>::Element& element : surface.elements) {
            std::array<int, D> nodes = element.points;
            for (int& node : nodes)
                node += first;
            meshes.elements.push_back(nodes);
            meshes.element_gap.push_back(number);
            meshes.velocity.push_back(through.at({a, b, element.part}).along(element.normal));
            meshes.normal.push_back(element.normal);
            meshes.area.push_back(element.area);
        }
    }
    return of_all_ranks(grid.comm(), meshes);
}

template <int D>
std::vector<ForceParts<D>> split_forces(const Model<D>& model, const Instant<D>& now, const State<D>& state)
{
    const Placed<D>& at = *now.placed;
    std::vector<ForceParts<D>> forces(state.bodies.size());
    const Grid<D>& grid = *at.coupling.grid;
    const UnknownVector<D> p = reduced_pressure(state);
    std::vector<Twist<D>> of_gaps(forces.size(), Twist<D>::Zero());
    std::set<std::int32_t> parts;
    for (const auto& [a, b, part] : gap_parts(at))
        parts.insert(part);
    for (const std::int32_t part : parts)
        for (const WallPatch<D>& patch : at.complex.patches_of(part))
            if (static_cast<std::size_t>(patch.solid) < of_gaps.size()) { // walls come after the bodies
                Twist<D> area;
                area << patch.area, grid.dx() * patch.moment;
                of_gaps[patch.solid] += value_of(at, p, PartOrCell::part(part)) * grid.face_area() * area;
            }
    grid.comm().sum(std::span<double>(of_gaps.data()->data(), of_gaps.size() * twist_size<D>));
    for (std::size_t b = 0; b < forces.size(); ++b) {
        forces[b].film = of_gaps[b];
        if (model.viscous()) {
            forces[b].film += now.friction.gaps[b];
            forces[b].shear = now.friction.bulk[b];
        }
        forces[b].buoyancy = buoyancy(model, state.bodies[b]);
        forces[b].pressure = state.wrenches[b] - forces[b].film - forces[b].shear - forces[b].buoyancy;
    }
    add_contact_forces(state, state.dt, forces);
    return forces;
}

template <int D>
void add_gap_parts(const Model<D>& model, const Placed<D>& at, const State<D>& state, std::vector<GapState>& gaps)
{
    const Grid<D>& grid = model.grid;
    const std::vector<Solid<D>>& solids = at.coupling.solids;
    const std::vector<Twist<D>> V = model.twists(state.bodies);
    Vec<D> period = Vec<D>::Zero();
    for (int axis = 0; axis < D; ++axis)
        period[axis] = grid.periodic(axis) ? grid.size()[axis] : 0.0;
    const double reach = parameters.gap_end * grid.dx();
    std::map<std::pair<int, int>, GapState> states; // the same pairs on every rank
    for (const ContactPoint<D>& point : find_contacts<D>(
             solids, state.contacts.features(), grid.origin(), grid.origin() + grid.size(), period,
             [&](int, int) { return reach; }, reach, 0.5 * grid.dx())) {
        const auto [found, is_new] = states.try_emplace({point.a, point.b});
        GapState& gap = found->second;
        if (!is_new && point.distance >= gap.thickness)
            continue;
        gap.body_a = solids[point.a].name;
        gap.body_b = solids[point.b].name;
        gap.thickness = point.distance;
        const RelativeRow<D> row = relative_row<D>(point, solids, point.normal);
        gap.opening_rate = row.a.dot(V[point.a]) + row.b.dot(V[point.b]);
    }
    const UnknownVector<D> p = reduced_pressure(state);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> sums(3 * states.size(), 0.0), most(2 * states.size(), -infinity);
    for (const auto& [a, b, part] : gap_parts(at)) {
        const auto found = states.find({a, b});
        if (found == states.end())
            continue;
        const auto k = static_cast<std::size_t>(std::distance(states.begin(), found));
        const double area = wall_area(at, part, a, b),
                     pressure = value_of(at, p, PartOrCell::part(part)) +
                                model.hydrostatic(grid.cell_centre(at.complex.cell_of_part(part)));
        sums[3 * k] += 1;
        sums[3 * k + 1] += area;
        sums[3 * k + 2] += pressure * area;
        most[2 * k] = std::max(most[2 * k], pressure);
        most[2 * k + 1] = std::max(most[2 * k + 1], -pressure);
    }
    grid.comm().sum(sums);
    grid.comm().max(most);
    std::size_t k = 0;
    std::map<std::pair<std::string, std::string>, GapState> contacts;
    for (const GapState& gap : gaps)
        contacts[{gap.body_a, gap.body_b}] = gap;
    gaps.clear();
    for (auto& [pair, gap] : states) {
        gap.film_nodes = static_cast<int>(sums[3 * k]);
        gap.film_area = sums[3 * k + 1];
        gap.force = sums[3 * k + 2];
        const auto same = contacts.find({gap.body_a, gap.body_b});
        if (gap.film_nodes > 0) {
            gap.pressure_max = most[2 * k];
            gap.pressure_min = -most[2 * k + 1];
        }
        ++k;
        if (same != contacts.end()) {
            gap.contact_force = same->second.contact_force;
            gap.contact_impulse = same->second.contact_impulse;
            contacts.erase(same);
        } else if (gap.film_nodes == 0)
            continue;
        gaps.push_back(gap);
    }
    for (const auto& [names, gap] : contacts) // none is farther apart
        gaps.push_back(gap);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template int count_gap_parts<D>(const Placed<D>&);                                                                         \
    template std::vector<ForceParts<D>> split_forces<D>(const Model<D>&, const Instant<D>&, const State<D>&);                  \
    template GapMeshes<D> gap_meshes<D>(const Model<D>&, const Instant<D>&, const State<D>&);                                  \
    template void add_gap_parts<D>(const Model<D>&, const Placed<D>&, const State<D>&, std::vector<GapState>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
