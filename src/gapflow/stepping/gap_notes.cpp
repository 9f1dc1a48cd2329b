#include "gapflow/stepping/gap_notes.hpp"

#include "gapflow/core/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace gapflow {

std::string place_text(const std::vector<double>& x)
{
    std::string text;
    for (const double coordinate : x) {
        char number[32];
        std::snprintf(number, sizeof number, "%.4g", coordinate + 0.0); // no -0
        text += (text.empty() ? "(" : ", ") + std::string(number);
    }
    return text + ")";
}

std::string sealed_text(const SealedPocket& pocket)
{
    const std::string what = pocket.cells > 0
                                 ? std::to_string(pocket.cells) + (pocket.cells == 1 ? " cell" : " cells") + " of fluid"
                                 : std::string("a film");
    return what + " at " + place_text(pocket.at) + (pocket.bodies.empty() ? "" : " between " + joined(pocket.bodies, ", ")) +
           ": nothing lets this fluid out, so its volume holds what bounds it; if that is not meant, leave a gap or an open "
           "side";
}

template <int D>
std::vector<std::string> blind_end_notes(const Coupling<D>& coupling, std::set<FilmPair<D>>& told)
{
    constexpr std::size_t most_blind_told = 5;
    std::vector<std::string> notes;
    for (const BlindEnd<D>& end : coupling.network.rim.blind) {
        const Film<D>& film = coupling.network.films[end.film];
        if (told.size() > most_blind_told || !told.insert(film.pair).second)
            continue;
        if (told.size() > most_blind_told) {
            notes.push_back("more films end where nothing continues them; they are not named");
            continue;
        }
        notes.push_back(
            "the film between '" + coupling.solids[film.mesh.master].name + "' and '" + coupling.solids[film.mesh.other].name +
            "' ends at " + place_text<D>(end.x) +
            " where nothing continues it (no cell with fluid, no other film, no side): the flow there may be too stiff; "
            "use a finer grid (domain.cells), or another gap.threshold for this pair");
    }
    return notes;
}

template <int D>
std::vector<std::string> rough_gap_notes(const Scene& scene, const Coupling<D>& coupling)
{
    constexpr double touch = 1e-6; // in cells: what is closer touches
    const double dx = coupling.grid->dx();
    std::map<FilmPair<D>, double> least;
    for (const Film<D>& film : coupling.network.films)
        for (const FilmPoint<D>& q : film.mesh.points) {
            const double distance = q.other_normal.dot(q.x - q.y);
            double& known = least.try_emplace(film.pair, distance).first->second;
            known = std::min(known, distance);
        }
    constexpr std::size_t most = 3; // with more pairs the closest are named, and the others counted
    std::vector<std::pair<double, FilmPair<D>>> thin;
    for (const auto& [pair, distance] : least) {
        const GapScene& gap = scene.gap_of(coupling.solids[pair.master].name, coupling.solids[pair.other].name);
        if (gap.automatic_roughness && distance > touch * dx && distance < gap.roughness)
            thin.emplace_back(distance, pair);
    }
    const std::size_t named = std::min(thin.size(), most);
    std::partial_sort(thin.begin(), thin.begin() + static_cast<long>(named), thin.end(),
                      [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> notes;
    for (std::size_t k = 0; k < named; ++k) {
        const auto& [distance, pair] = thin[k];
        const std::string &a = coupling.solids[pair.master].name, &b = coupling.solids[pair.other].name;
        const GapScene& gap = scene.gap_of(a, b);
        char text[300];
        std::snprintf(text, sizeof text,
                      " are %.3g (%.3g cells) apart, and their film counts as %.3g (%.3g cells) thick, which gap.roughness is "
                      "by default; "
                      "give a smaller gap.roughness, down to 0, if the film shall be as thin as the gap",
                      distance, distance / dx, gap.roughness, gap.roughness / dx);
        notes.push_back("'" + a + "' and '" + b + "'" + text);
    }
    if (thin.size() > named)
        notes.push_back("so it is with " + std::to_string(thin.size() - named) +
                        (thin.size() - named == 1 ? " more pair, whose gap is wider" : " more pairs, whose gaps are wider"));
    return notes;
}

template <int D>
std::vector<std::string> closed_gap_notes(const Scene& scene, const Coupling<D>& coupling)
{
    std::vector<std::string> notes;
    std::set<FilmPair<D>> told;
    for (const Film<D>& film : coupling.network.films) {
        const std::string &a = coupling.solids[film.pair.master].name, &b = coupling.solids[film.pair.other].name;
        const double roughness = scene.gap_of(a, b).roughness;
        const bool closes = std::any_of(film.mesh.rim.begin(), film.mesh.rim.end(),
                                        [](const RimEdge<D>& edge) { return edge.end == RimEnd::touching; });
        if (!closes || !(roughness > 0) || !told.insert(film.pair).second)
            continue;
        char text[64];
        std::snprintf(text, sizeof text, "%.3g (%.3g cells)", roughness, roughness / coupling.grid->dx());
        notes.push_back("'" + a + "' and '" + b + "' stand still and are one solid where they are closer than gap.roughness, " +
                        text + ": nothing leaks through there; a [[pair]] with bodies = [\"" + a + "\", \"" + b +
                        "\"] makes it a film of that thickness");
    }
    return notes;
}

namespace {

// Length of a film between sharp edges over its least thickness h0: half of int (h0/h)^3 dA over the rim there, each part of it by its own (h0/h)^3,
// twice. As long a channel of thickness h0 resists a flow as the film does, if that goes on from one edge to another; from an edge on into a wedge,
// half of it does. Infinite without an edge.
template <int D>
double length_over_thickness(const FilmMesh<D>& mesh)
{
    const double least = *std::min_element(mesh.h.begin(), mesh.h.end());
    double area = 0, rim = 0;
    for (const FilmElement<D>& e : mesh.elements)
        area += e.measure * std::pow(least * e.measure / e.volume, 3);
    for (const RimEdge<D>& edge : mesh.rim)
        if (edge.end == RimEnd::master_edge || edge.end == RimEnd::other_edge) {
            double h = 0;
            for (const int node : edge.nodes)
                h += mesh.h[node] / (D - 1);
            rim += edge.length * std::pow(least / h, 3);
        }
    return rim > 0 ? 2 * area / (rim * least) : std::numeric_limits<double>::infinity();
}

// Least and largest values.
struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

    void add(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    double width() const { return high > low ? high - low : 0.0; }
};

// In cells that no surface cuts: a few of those may have any pressure.
template <int D>
Range range_in_cells(const Coupling<D>& coupling, const CellField<D>& pressure)
{
    const Grid<D>& grid = *coupling.grid;
    const auto is_whole = [&](const Index<D>& c) {
        for (int side = 0; side < 2 * D; ++side) {
            const Index<D> f = c + (side % 2) * step<D>(side / 2);
            if (coupling.fractions->cut(side / 2, f) >= 0 || !(coupling.open(side / 2, f) > 0))
                return false;
        }
        return true;
    };
    Range range;
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (coupling.system.component(c) >= 0 && is_whole(c))
            range.add(pressure(c));
    });
    return {grid.comm().min(range.low), grid.comm().max(range.high)};
}

// At all mouths in the grid.
template <int D>
std::vector<double> pressure_at_mouths(const Coupling<D>& coupling, const CellField<D>& pressure)
{
    const Grid<D>& grid = *coupling.grid;
    std::vector<double> values;
    for (const Mouth<D>& mouth : coupling.network.rim.mouths) {
        values.push_back(0.0);
        for (const auto& [key, weight] : mouth.cells)
            if (const Index<D> c = grid.cell_of_key(key); grid.owns(c))
                values.back() += weight * pressure(c);
    }
    grid.comm().sum(values);
    return values;
}

// Two solids that both touch a cell of the grid's fluid: a gap of a cell or less, without a film.
template <int D>
std::optional<std::pair<int, int>> solids_around(const Coupling<D>& coupling, const Index<D>& c)
{
    const FaceFractions<D>& fractions = *coupling.fractions;
    if (coupling.system.component(c) < 0 || static_cast<CellKind>(coupling.kind(c)) != CellKind::bulk)
        return {};
    std::optional<int> first;
    for (int side = 0; side < 2 * D; ++side) {
        const int cut = fractions.cut(side / 2, c + (side % 2) * step<D>(side / 2));
        for (std::size_t i = 0; cut >= 0 && i < fractions.faces[cut].solid.size(); ++i) {
            const int solid = fractions.faces[cut].solid[i].solid;
            if (first && solid != *first)
                return std::pair(*first, solid);
            first = solid;
        }
    }
    return {};
}

// By how much the pressure falls in a cell, through its open faces and those of the cells beyond; 0 where it is the least or the highest there, as
// where a gap is squeezed.
template <int D>
double fall_through(const Coupling<D>& coupling, const CellField<D>& pressure, const Index<D>& c)
{
    const Grid<D>& grid = *coupling.grid;
    Range range;
    range.add(pressure(c));
    std::vector<Index<D>> reached{c};
    for (int layer = 0, next = 0; layer < 2; ++layer)
        for (const int end = static_cast<int>(reached.size()); next < end; ++next)
            for (int side = 0; side < 2 * D; ++side) {
                const Index<D> from = reached[next], beyond = from + (2 * (side % 2) - 1) * step<D>(side / 2);
                if (!grid.owns(beyond) || !(coupling.open(side / 2, from + (side % 2) * step<D>(side / 2)) > 0))
                    continue;
                range.add(pressure(beyond));
                reached.push_back(beyond);
            }
    const double least = 0.1 * range.width();
    return range.high - pressure(c) > least && pressure(c) - range.low > least ? range.width() : 0.0;
}

// The solids of the gap without a film through which the pressure falls most, if it falls by more than a difference. Collective.
template <int D>
std::optional<std::pair<int, int>> bare_gap(const Coupling<D>& coupling, const CellField<D>& pressure, double difference)
{
    const Communicator& comm = coupling.grid->comm();
    double largest = difference;
    std::pair<int, int> solids{-1, -1};
    for (const Index<D>& c : coupling.fractions->surface_cells)
        if (const auto around = solids_around(coupling, c))
            if (const double fall = fall_through(coupling, pressure, c); fall > largest) {
                largest = fall;
                solids = *around;
            }
    const bool mine = largest == comm.max(largest);
    const double first = comm.max(mine ? solids.first : -1.0), second = comm.max(mine ? solids.second : -1.0);
    return first < 0 ? std::nullopt : std::optional(std::pair(static_cast<int>(first), static_cast<int>(second)));
}

} // namespace

template <int D>
std::vector<std::string> short_film_notes(const Scene& scene, const Coupling<D>& coupling, const UnknownVector<D>& pressure)
{
    const FilmNetwork<D>& network = coupling.network;
    std::map<FilmPair<D>, std::pair<double, double>> thinnest; // of each pair the thinnest film: thickness, length over it
    for (const Film<D>& film : network.films) {
        const double h = *std::min_element(film.mesh.h.begin(), film.mesh.h.end());
        const auto [known, is_new] = thinnest.try_emplace(film.pair, h, 0.0);
        if (!is_new && h >= known->second.first)
            continue;
        const double rough =
            scene.gap_of(coupling.solids[film.pair.master].name, coupling.solids[film.pair.other].name).roughness;
        known->second = {h, h > 1.001 * rough ? length_over_thickness(film.mesh) : std::numeric_limits<double>::infinity()};
    }
    std::erase_if(thinnest, [](const auto& pair) { return !(pair.second.second < 3); });
    const double half = 0.5 * range_in_cells(coupling, pressure.cells).width();
    const auto flow_between = [&](int a, int b) {
        return "the flow between '" + coupling.solids[a].name + "' and '" + coupling.solids[b].name + "' goes through a ";
    };
    std::vector<std::string> notes;
    if (!(half > 0))
        return notes;
    if (const auto solids = bare_gap(coupling, pressure.cells, half))
        notes.push_back(
            flow_between(solids->first, solids->second) +
            "gap that is narrower than a cell and has no film, as between sharp edges: it may be wrong by a factor; "
            "cells half as wide as the gap (domain.cells) resolve it");
    if (thinnest.empty())
        return notes;
    std::map<FilmPair<D>, Range> falls;
    const std::vector<double> at_mouths = pressure_at_mouths(coupling, pressure.cells);
    for (std::size_t r = 0; r < at_mouths.size(); ++r)
        if (const Mouth<D>& mouth = network.rim.mouths[r]; !mouth.cells.empty())
            falls[network.films[mouth.film].pair].add(at_mouths[r]);
    for (const auto& [pair, unused] : thinnest)
        if (notes.size() < 3 && falls[pair].width() > half)
            notes.push_back(
                flow_between(pair.master, pair.other) +
                "film that is shorter than three of its thicknesses, as at sharp edges: it may be wrong by a factor; "
                "cells half as wide as the gap (domain.cells), with gap.threshold = 0.05 for this pair, resolve it");
    return notes;
}

template std::vector<std::string> short_film_notes<2>(const Scene&, const Coupling<2>&, const UnknownVector<2>&);
template std::vector<std::string> short_film_notes<3>(const Scene&, const Coupling<3>&, const UnknownVector<3>&);
template std::vector<std::string> closed_gap_notes<2>(const Scene&, const Coupling<2>&);
template std::vector<std::string> closed_gap_notes<3>(const Scene&, const Coupling<3>&);
template std::vector<std::string> rough_gap_notes<2>(const Scene&, const Coupling<2>&);
template std::vector<std::string> rough_gap_notes<3>(const Scene&, const Coupling<3>&);
template std::vector<std::string> blind_end_notes<2>(const Coupling<2>&, std::set<FilmPair<2>>&);
template std::vector<std::string> blind_end_notes<3>(const Coupling<3>&, std::set<FilmPair<3>>&);

} // namespace gapflow
