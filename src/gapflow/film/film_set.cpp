#include "gapflow/film/film_set.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace gapflow {

namespace {

// Films live up to this multiple of h_c once they exist, so that they do not chatter.
constexpr double hysteresis = 1.3;
// Surfaces no further apart than this, in dx, and facing the same way are one surface.
constexpr double coincident = 1e-6;
constexpr double same_way = 0.5; // least n . n of the two

// Order in which solids become master: free, prescribed, fixed, walls; containers last among their kind; the smaller; by name.
template <int D>
std::tuple<int, int, double, std::string> master_rank(const Solid<D>& solid, double radius)
{
    const bool unbounded = !std::isfinite(radius);
    return {unbounded ? 2 : solid.shape.shape().inside_out() ? 1 : 0, static_cast<int>(solid.motion), radius, solid.name};
}

} // namespace

template <int D>
double third_distance(const Grid<D>& grid, std::span<const Solid<D>> solids, const FaceClipper<D>& clipper,
                      const FilmPair<D>& pair, const Vec<D>& x, const Vec<D>& n, double reach)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Vec<D> size = grid.size();
    Vec<D> wrap = Vec<D>::Zero();
    Index<D> periods = Index<D>::Zero();
    for (int axis = 0; axis < D; ++axis)
        if (grid.periodic(axis)) {
            periods[axis] = -static_cast<int>(std::floor((x[axis] - grid.origin()[axis]) / size[axis]));
            wrap[axis] = periods[axis] * size[axis];
        } else {
            const double below = grid.origin()[axis] - x[axis], above = x[axis] - grid.origin()[axis] - size[axis];
            if ((grid.side(axis, 0) != SideKind::wall && below > 0) || (grid.side(axis, 1) != SideKind::wall && above > 0))
                return -infinity;
        }
    thread_local std::vector<int> candidates;
    clipper.near(x + wrap, reach, candidates);
    double nearest = infinity;
    for (int i : candidates) {
        const Image<D>& image = clipper.images()[i];
        if (image.solid == pair.master || image.solid == pair.other) {
            Index<D> shift = periods;
            if (image.solid == pair.other)
                shift += Index<D>(pair.shift.data());
            if ((image.shift - shift.template cast<double>().cwiseProduct(size)).norm() < 1e-9 * size.norm())
                continue;
        }
        const SurfacePoint<D> p = image.shape.closest(x + wrap);
        if (std::abs(p.distance) <= coincident * grid.dx() && n.dot(p.normal) > same_way) {
            // Round-off must not tell which of two flush bodies bears the film there: the names do.
            if (solids[image.solid].name < solids[pair.master].name)
                return -infinity;
            continue;
        }
        if (p.distance < nearest && (p.distance < 0 || n.dot(p.normal) < facing_cosine))
            nearest = p.distance;
    }
    return nearest;
}

template <int D>
void number_films(std::vector<Film<D>>& films)
{
    int node = 0, element = 0;
    for (Film<D>& film : films) {
        film.first_node = node;
        film.first_element = element;
        node += static_cast<int>(film.mesh.h.size());
        element += static_cast<int>(film.mesh.elements.size());
    }
}

template <int D>
std::vector<Film<D>> find_films(const Grid<D>& grid, std::span<const Solid<D>> solids, const FaceClipper<D>& clipper,
                                const std::function<GapSettings(int, int)>& settings, const std::set<FilmPair<D>>& alive)
{
    const std::vector<Image<D>>& images = clipper.images();
    const Vec<D> size = grid.size();
    std::vector<double> radius(solids.size());
    for (std::size_t s = 0; s < solids.size(); ++s)
        radius[s] = bounding_radius<D>(world_bounds(solids[s].shape));

    std::set<FilmPair<D>> pairs;
    for (const auto& [a, b] : close_images<D>(images, solids, 4 * hysteresis * grid.dx())) {
        FilmPair<D> pair{images[a].solid, images[b].solid, {}}, turned{images[b].solid, images[a].solid, {}};
        for (int axis = 0; axis < D; ++axis) {
            const double shift = images[b].shift[axis] - images[a].shift[axis];
            pair.shift[axis] = static_cast<int>(std::lround(shift / size[axis]));
            turned.shift[axis] = -pair.shift[axis];
        }
        if (alive.count(pair) || alive.count(turned))
            pairs.insert(alive.count(pair) ? pair : turned);
        else
            pairs.insert(master_rank(solids[pair.master], radius[pair.master]) <
                                 master_rank(solids[pair.other], radius[pair.other])
                             ? pair
                             : turned);
    }

    std::vector<FilmPair<D>> ordered(pairs.begin(), pairs.end());
    std::sort(ordered.begin(), ordered.end(), [&](const FilmPair<D>& p, const FilmPair<D>& q) {
        return std::tie(solids[p.master].name, solids[p.other].name, p.shift) <
               std::tie(solids[q.master].name, solids[q.other].name, q.shift);
    });
    std::vector<Film<D>> films;
    for (const FilmPair<D>& pair : ordered) {
        const GapSettings gap = settings(pair.master, pair.other);
        if (!gap.film)
            continue;
        FilmMeshOptions options;
        options.dx = grid.dx();
        options.threshold = gap.threshold * (alive.count(pair) ? hysteresis : 1.0);
        options.floor = gap.floor;
        options.origin.template head<D>() = grid.origin();
        const double reach = options.threshold;
        auto third = [&](const Vec<D>& x, const Vec<D>& n) { return third_distance(grid, solids, clipper, pair, x, n, reach); };
        for (FilmMesh<D>& mesh :
             film_meshes<D>(solids[pair.master].shape, other_shape(grid, solids, pair), third, options)) {
            mesh.master = pair.master;
            mesh.other = pair.other;
            mesh.shift = size.cwiseProduct(Index<D>(pair.shift.data()).template cast<double>());
            films.push_back({pair, std::move(mesh), options.threshold});
        }
    }
    number_films(films);
    return films;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template double third_distance<D>(const Grid<D>&, std::span<const Solid<D>>, const FaceClipper<D>&, const FilmPair<D>&,    \
                                      const Vec<D>&, const Vec<D>&, double);                                                   \
    template std::vector<Film<D>> find_films<D>(const Grid<D>&, std::span<const Solid<D>>, const FaceClipper<D>&,              \
                                                const std::function<GapSettings(int, int)>&, const std::set<FilmPair<D>>&);    \
    template void number_films<D>(std::vector<Film<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
