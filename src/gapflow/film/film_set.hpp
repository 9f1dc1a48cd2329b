// All films of a configuration: which pairs of solids have one, which of the two is the master (method, "Films").
#pragma once

#include "gapflow/film/film_mesh.hpp"
#include "gapflow/geometry/solid.hpp"
#include "gapflow/grid/face_fractions.hpp"

#include <functional>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <vector>

namespace gapflow {

/// A pair of solids with the image of the second that faces the first (in whole periods).
template <int D>
struct FilmPair {
    int master, other;
    std::array<int, D> shift;
    auto operator<=>(const FilmPair&) const = default;
};

struct GapSettings {
    bool film = true;
    double threshold = 0;           ///< h_c, a length; a pair that has a film keeps it up to 1.3 h_c
    double floor = 0;               ///< h_floor, a length
    std::optional<double> touching; ///< of a pair at rest: no film where the surfaces are no further apart than this, a length
    double skin = 0;                ///< part of the thickness, less than the floor, without flow (dry contact)
    bool lasting =
        false; ///< a new film is created with the extent to which it will be kept: a part added later would have no velocity history
    bool viscous = false; ///< the film's mesh resolves the pressure peak in viscous fluid that is squeezed out
};

/// One connected piece of film.
template <int D>
struct Film {
    FilmPair<D> pair;
    FilmMesh<D> mesh;
    double threshold;      ///< h_c that it was built with
    int first_node = 0;    ///< number of its node 0 among all film nodes
    int first_element = 0; ///< number of its element 0 among all film elements
    bool here =
        true; ///< this rank meshed it, and computes for it what ranks share; one of them, the same for all films of a pair
};

/// Films of all pairs, sorted so that the order does not depend on the order of solids. Each rank meshes the pairs whose gap lies in its block, and all
/// ranks get all films. Collective. `settings` gives a pair's gap
/// settings; `alive`: pairs that had a film a step ago (they keep it to 1.3 h_c, and their master).
template <int D>
std::vector<Film<D>> find_films(const Grid<D>& grid, std::span<const Solid<D>> solids, const FaceClipper<D>& clipper,
                                const std::function<GapSettings(int, int)>& settings, const std::set<FilmPair<D>>& alive);

/// Numbers the nodes and elements of a list of films.
template <int D>
void number_films(std::vector<Film<D>>& films);

/// The placed shape of a pair's other solid: the image that faces the master.
template <int D>
PlacedShape<D> other_shape(const Grid<D>& grid, std::span<const Solid<D>> solids, const FilmPair<D>& pair)
{
    return solids[pair.other].shape.shifted(grid.size().cwiseProduct(Index<D>(pair.shift.data()).template cast<double>()));
}

} // namespace gapflow
