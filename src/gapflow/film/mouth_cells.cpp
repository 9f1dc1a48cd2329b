#include "gapflow/film/mouth_cells.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

// Faces that a film closes within this distance from a mouth, in dx, belong to the mouth.
constexpr double mouth_reach = 4;

// From the master to the other wall, at the mouth.
template <int D>
Vec<D> way_across(const Mouth<D>& mouth, const Film<D>& film)
{
    Vec<D> across = Vec<D>::Zero();
    for (int i = 0; i < D - 1; ++i) {
        const int node = mouth.nodes[i] - film.first_node;
        across += mouth.shape[i] * (film.mesh.y[node] - film.mesh.x[node]);
    }
    return across;
}

// Position between the walls, -1/2 at the master.
template <int D>
double place_across(const Vec<D>& from_middle, const Vec<D>& across)
{
    return std::clamp(from_middle.dot(across) / across.squaredNorm(), -0.5, 0.5);
}

} // namespace

template <int D>
std::vector<std::vector<ClosedArea<D>>> closed_areas(const Grid<D>& grid, const FilmNetwork<D>& network)
{
    std::vector<std::vector<ClosedArea<D>>> areas(network.films.size());
    const auto is_outside = [&](long key) { return network.cells.kind(key, CellKind::bulk) != CellKind::film; };
    for (const ClosedFace<D>& face : closed_faces(grid, network, is_outside))
        areas[face.film].push_back(face.area);
    return areas;
}

template <int D>
std::vector<std::vector<Vec<D>>> mouth_places(const FilmNetwork<D>& network)
{
    std::vector<std::vector<Vec<D>>> places(network.films.size());
    for (const Mouth<D>& mouth : network.rim.mouths)
        if (!mouth.cells.empty())
            places[mouth.film].push_back(mouth.x);
    return places;
}

template <int D>
std::vector<CarriedCell> cells_behind(const Mouth<D>& mouth, const Film<D>& film, std::span<const ClosedArea<D>> closed,
                                      std::span<const Vec<D>> places, double dx)
{
    const Vec<D> across = way_across(mouth, film);
    std::vector<CarriedCell> cells; // lean: so far the weighted sum of places
    double total = 0, mean = 0;
    for (const ClosedArea<D>& face : closed) {
        const double distance = (face.x - mouth.x).norm();
        if (distance > mouth_reach * dx ||
            std::any_of(places.begin(), places.end(), [&](const Vec<D>& x) { return (face.x - x).norm() < distance; }))
            continue;
        const double weight = -face.area.dot(mouth.outward), place = weight * place_across<D>(face.x - mouth.x, across);
        total += weight;
        mean += place;
        const auto known =
            std::find_if(cells.begin(), cells.end(), [&](const CarriedCell& cell) { return cell.key == face.key; });
        if (known == cells.end()) {
            cells.push_back({face.key, weight, place});
        } else {
            known->weight += weight;
            known->lean += place;
        }
    }
    if (total < 0.5 * mouth.length * mouth.h)
        return {};
    mean /= total;
    for (CarriedCell& cell : cells) {
        cell.weight /= total;
        cell.lean = -2 * (cell.lean / total - mean * cell.weight);
    }
    return cells;
}

template <int D>
std::vector<CarriedCell> cells_around(const Grid<D>& grid, const Mouth<D>& mouth, const Film<D>& film)
{
    std::vector<CarriedCell> cells;
    for (const auto& [key, weight] : mouth.cells)
        cells.push_back({key, weight, 0.0});
    if (mouth.kind != MouthKind::smooth || mouth.h <= 2 * grid.dx())
        return cells;
    const Vec<D> across = way_across(mouth, film);
    double mean = 0;
    for (CarriedCell& cell : cells) {
        cell.lean = place_across(grid.nearest_image(grid.cell_centre(grid.cell_of_key(cell.key)) - mouth.x), across);
        mean += cell.weight * cell.lean;
    }
    for (CarriedCell& cell : cells)
        cell.lean = -2 * cell.weight * (cell.lean - mean);
    return cells;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<std::vector<ClosedArea<D>>> closed_areas<D>(const Grid<D>&, const FilmNetwork<D>&);                   \
    template std::vector<std::vector<Vec<D>>> mouth_places<D>(const FilmNetwork<D>&);                                          \
    template std::vector<CarriedCell> cells_behind<D>(const Mouth<D>&, const Film<D>&, std::span<const ClosedArea<D>>,         \
                                                      std::span<const Vec<D>>, double);                                        \
    template std::vector<CarriedCell> cells_around<D>(const Grid<D>&, const Mouth<D>&, const Film<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
