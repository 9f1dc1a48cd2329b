#include "gapflow/film/film_set.hpp"

#include "gapflow/core/sharing.hpp"
#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gapflow {

namespace {

// A film that exists is kept up to this multiple of h_c, so that it does not appear and vanish alternately.
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

// Whether surfaces are further apart than `reach`, by a sufficient test: the bounding ball of one, radius about the centre of its bounds,
// against the other's distance.
template <int D>
bool are_apart(const PlacedShape<D>& a, double radius_a, const PlacedShape<D>& b, double radius_b, double reach)
{
    auto apart = [&](const PlacedShape<D>& ball, double radius, const PlacedShape<D>& other) {
        const Bounds<D> bounds = ball.shape().bounds();
        return std::isfinite(radius) && other.distance(ball.to_world(0.5 * (bounds.low + bounds.high))) > radius + reach;
    };
    return apart(a, radius_a, b) || apart(b, radius_b, a);
}

// Largest distance of a shape's surface from the centre of its bounds, by its base mesh and how far the surface bulges from it.
template <int D>
double surface_radius(const Shape<D>& shape, const SurfaceMesh<D>& mesh)
{
    const Bounds<D> bounds = shape.bounds();
    const double limit = bounding_radius(bounds);
    if (mesh.elements.empty() || !std::isfinite(limit))
        return limit;
    const Vec<D> centre = 0.5 * (bounds.low + bounds.high);
    double radius = 0;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        double furthest = 0, longest = 0;
        for (int k = 0; k < D; ++k) {
            const Vec<D>& x = mesh.vertices[mesh.elements[e][k]];
            furthest = std::max(furthest, (x - centre).norm());
            longest = std::max(longest, (x - mesh.vertices[mesh.elements[e][(k + 1) % D]]).norm());
        }
        radius =
            std::max(radius, furthest + std::min(0.25 * std::abs(shape.curvature(mesh.patch[e])) * longest, 0.5) * longest);
    }
    return std::min(radius, limit);
}

// Elements of a solid's base mesh from which films on it are refined: of meshes far wider than the domain without those beyond its sides,
// where there is no fluid. (One that only reaches through walls keeps them: they have a part in how the others are split.)
template <int D>
void leave_out_beyond(const Grid<D>& grid, const PlacedShape<D>& solid, SurfaceMesh<D>& base)
{
    const Bounds<D> bounds = world_bounds(solid);
    const bool wide = ((bounds.high - bounds.low).array() > 2 * grid.size().array()).any();
    if (!wide || solid.shape().convex() || solid.shape().inside_out())
        return;
    const Vec<D> around = Vec<D>::Constant(4 * grid.dx());
    const Vec<D> low = grid.origin() - around, high = grid.origin() + grid.size() + around;
    std::vector<Vec<D>> vertices;
    for (const Vec<D>& x : base.vertices)
        vertices.push_back(solid.to_world(x));
    std::size_t kept = 0;
    for (std::size_t e = 0; e < base.elements.size(); ++e) {
        bool beyond = false;
        for (int axis = 0; axis < D && !beyond; ++axis) {
            const auto all = [&](auto&& is_there) {
                return std::all_of(base.elements[e].begin(), base.elements[e].end(),
                                   [&](int v) { return is_there(vertices[v][axis]); });
            };
            beyond = !grid.periodic(axis) &&
                     (all([&](double x) { return x < low[axis]; }) || all([&](double x) { return x > high[axis]; }));
        }
        if (beyond)
            continue;
        base.elements[kept] = base.elements[e];
        base.patch[kept++] = base.patch[e];
    }
    base.elements.resize(kept);
    base.patch.resize(kept);
}

/// The solids beside a pair that may end its film.
template <int D>
class ThirdBodies {
public:
    /// `reach`: h_c. Lists the images near the part of the master that may face the other.
    ThirdBodies(const Grid<D>& grid, std::span<const Solid<D>> solids, const FaceClipper<D>& clipper, const FilmPair<D>& pair,
                double reach)
        : grid_(grid), solids_(solids), clipper_(clipper), pair_(pair), reach_(reach)
    {
        const Bounds<D> a = world_bounds(solids[pair.master].shape), b = world_bounds(other_shape(grid, solids, pair));
        const Vec<D> around = Vec<D>::Constant(reach + 1e-6 * grid.dx());
        Vec<D> low = a.low, high = a.high;
        if (!solids[pair.other].shape.shape().inside_out()) {
            low = low.cwiseMax(b.low - around);
            high = high.cwiseMin(b.high + around);
        }
        if (!low.allFinite() || !high.allFinite() || (low.array() > high.array()).any())
            return;
        const Vec<D> end = grid.origin() + grid.size();
        bool periodic = false;
        for (int axis = 0; axis < D; ++axis) {
            periodic |= grid.periodic(axis);
            if (grid.periodic(axis) &&
                (low[axis] < grid.origin()[axis] + around[axis] || high[axis] > end[axis] - around[axis]))
                return;
        }
        const Vec<D> centre = 0.5 * (low + high);
        const double radius = 0.5 * (high - low).norm() + around[0];
        if (periodic && radius > 4 * grid.dx()) // further than the clipper searches
            return;
        clipper.near(centre, radius, near_);
        std::erase_if(near_, [&](int i) {
            const Image<D>& image = clipper.images()[i];
            return is_of_pair(image, Index<D>::Zero()) || image.shape.distance(centre) > radius;
        });
        listed_ = true;
    }

    /// Distance from the master's surface point x with normal n to the nearest third solid (or image) that also faces it and
    /// competes with the pair's other solid for the film there; negative inside any third solid and beyond an open side of the
    /// domain, where films end; infinity if none is within reach. Where a third solid's surface coincides with the master's (flush
    /// bodies), the first of them by name has the film. x may lie outside a periodic domain.
    double distance(const Vec<D>& x, const Vec<D>& n) const
    {
        const Vec<D> size = grid_.size();
        Index<D> periods = Index<D>::Zero();
        for (int axis = 0; axis < D; ++axis)
            if (grid_.periodic(axis)) {
                if (!listed_)
                    periods[axis] = -static_cast<int>(std::floor((x[axis] - grid_.origin()[axis]) / size[axis]));
            } else {
                const double below = grid_.origin()[axis] - x[axis], above = x[axis] - grid_.origin()[axis] - size[axis];
                if ((grid_.side(axis, 0) != SideKind::wall && below > 0) ||
                    (grid_.side(axis, 1) != SideKind::wall && above > 0))
                    return -infinity;
            }
        double nearest = infinity;
        if (listed_) {
            for (int i : near_)
                if (!consider(clipper_.images()[i], x, n, nearest))
                    return -infinity;
            return nearest;
        }
        const Vec<D> wrapped = x + periods.template cast<double>().cwiseProduct(size);
        thread_local std::vector<int> candidates;
        clipper_.near(wrapped, reach_, candidates);
        for (int i : candidates)
            if (!is_of_pair(clipper_.images()[i], periods) && !consider(clipper_.images()[i], wrapped, n, nearest))
                return -infinity;
        return nearest;
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    /// Whether the image is one of the pair itself, everything moved by `periods`.
    bool is_of_pair(const Image<D>& image, Index<D> periods) const
    {
        const Vec<D> size = grid_.size();
        const auto is_at = [&](const Index<D>& shift) {
            return (image.shift - shift.template cast<double>().cwiseProduct(size)).norm() < 1e-9 * size.norm();
        };
        return (image.solid == pair_.master && is_at(periods)) ||
               (image.solid == pair_.other && is_at(periods + Index<D>(pair_.shift.data())));
    }

    /// Lowers `nearest` if the image is nearer; false if it has the film at x.
    bool consider(const Image<D>& image, const Vec<D>& x, const Vec<D>& n, double& nearest) const
    {
        const double d = image.shape.distance(x);
        if (d > reach_ || d >= std::max(nearest, coincident * grid_.dx()))
            return true;
        const Vec<D> normal = image.shape.closest(x).normal;
        if (std::abs(d) <= coincident * grid_.dx() && n.dot(normal) > same_way)
            // Round-off must not decide which of two flush bodies has the film there: the names do.
            return !(solids_[image.solid].name < solids_[pair_.master].name);
        if (d < nearest && (d < 0 || n.dot(normal) < facing_cosine))
            nearest = d;
        return true;
    }

    const Grid<D>& grid_;
    std::span<const Solid<D>> solids_;
    const FaceClipper<D>& clipper_;
    const FilmPair<D>& pair_;
    double reach_;
    std::vector<int> near_;
    bool listed_ = false;
};

} // namespace

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

namespace {

// Pairs of solids whose images come close, in the order of their names. A pair that had a film keeps its master.
template <int D>
std::vector<FilmPair<D>> close_pairs(const Grid<D>& grid, std::span<const Solid<D>> solids, const std::vector<Image<D>>& images,
                                     const std::set<FilmPair<D>>& alive)
{
    const Vec<D> size = grid.size();
    std::vector<double> radius(solids.size());
    std::vector<std::array<bool, D>> endless(
        solids.size()); // axes along which the solid is its own image, as a wall along itself
    for (std::size_t s = 0; s < solids.size(); ++s) {
        radius[s] = bounding_radius(
            solids[s].shape.shape().bounds()); // in the body's axes: equal bodies have the same bits wherever they are
        const Vec<D> x = grid.origin() + 0.5 * size;
        for (int axis = 0; axis < D; ++axis)
            endless[s][axis] = !std::isfinite(radius[s]) &&
                               std::abs(solids[s].shape.distance(x) -
                                        solids[s].shape.distance(x + size[axis] * unit<D>(axis))) < 1e-9 * size[axis];
    }

    std::set<FilmPair<D>> pairs;
    for (const auto& [a, b] : close_images(images, solids, 4 * hysteresis * grid.dx())) {
        FilmPair<D> pair{images[a].solid, images[b].solid, {}}, turned{images[b].solid, images[a].solid, {}};
        for (int axis = 0; axis < D; ++axis) {
            const bool same = endless[pair.master][axis] || endless[pair.other][axis];
            const double shift = same ? 0.0 : images[b].shift[axis] - images[a].shift[axis];
            pair.shift[axis] = static_cast<int>(std::lround(shift / size[axis]));
            turned.shift[axis] = -pair.shift[axis];
        }
        if (alive.count(pair) || alive.count(turned))
            pairs.insert(alive.count(pair) ? pair : turned);
        else if (pair.master == pair.other) // a solid and its own image
            pairs.insert(std::max(pair, turned));
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
    return ordered;
}

// Whether a pair's gap, taken where their bounds come closest, lies in this rank's block.
template <int D>
bool is_here(const Grid<D>& grid, std::span<const Solid<D>> solids, const FilmPair<D>& pair)
{
    const Bounds<D> a = world_bounds(solids[pair.master].shape), b = world_bounds(other_shape(grid, solids, pair));
    const Vec<D> begin = grid.origin(), end = grid.origin() + grid.size();
    Vec<D> place;
    for (int k = 0; k < D; ++k) {
        const double low = std::max(a.low[k], b.low[k]), high = std::min(a.high[k], b.high[k]);
        place[k] = 0.5 * ((std::isfinite(low) ? low : begin[k]) + (std::isfinite(high) ? high : end[k]));
    }
    return grid.owns(grid.nearest_cell(place));
}

} // namespace

template <int D>
std::vector<Film<D>> find_films(const Grid<D>& grid, std::span<const Solid<D>> solids, const FaceClipper<D>& clipper,
                                const std::function<GapSettings(int, int)>& settings, const std::set<FilmPair<D>>& alive)
{
    const Vec<D> size = grid.size();
    struct Job {
        FilmPair<D> pair;
        GapSettings gap;
        double threshold;
        std::vector<FilmMesh<D>> meshes;
        bool mine;
    };
    std::vector<Job> jobs;
    std::vector<std::optional<SurfaceMesh<D>>> base(solids.size());
    std::vector<double> reach(solids.size());
    for (const FilmPair<D>& pair : close_pairs(grid, solids, clipper.images(), alive)) {
        const GapSettings gap = settings(pair.master, pair.other);
        const double threshold = gap.threshold * (alive.count(pair) ? hysteresis : 1.0);
        for (int s : {pair.master, pair.other})
            if (!base[s]) {
                base[s] = solids[s].shape.shape().surface_mesh();
                reach[s] = surface_radius(solids[s].shape.shape(), *base[s]);
                leave_out_beyond(grid, solids[s].shape, *base[s]);
            }
        if (gap.film && !are_apart(solids[pair.master].shape, reach[pair.master], other_shape(grid, solids, pair),
                                   reach[pair.other], threshold))
            jobs.push_back({pair, gap, threshold, {}, is_here(grid, solids, pair)});
    }
    for_each_job(static_cast<int>(jobs.size()), [&](int k) {
        Job& job = jobs[k];
        if (!job.mine)
            return;
        FilmMeshOptions options = coupling_sizes<D>(job.gap.viscous);
        options.dx = grid.dx();
        options.floor = job.gap.floor;
        options.touching = job.gap.touching;
        options.origin.template head<D>() = grid.anchor();
        auto lay_out = [&](double threshold) {
            options.threshold = job.threshold = threshold;
            const ThirdBodies<D> thirds(grid, solids, clipper, job.pair, threshold);
            const auto third = [&](const Vec<D>& x, const Vec<D>& n) { return thirds.distance(x, n); };
            job.meshes = film_meshes<D>(solids[job.pair.master].shape, other_shape(grid, solids, job.pair), third, options,
                                        &*base[job.pair.master]);
        };
        lay_out(job.threshold);
        if (job.gap.lasting && job.threshold == job.gap.threshold && !job.meshes.empty())
            lay_out(hysteresis * job.gap.threshold);
    });
    exchange_items(
        grid.comm(), jobs.size(), [&](std::size_t k) { return jobs[k].mine; },
        [&](ByteWriter& out, std::size_t k) {
            out(jobs[k].threshold, jobs[k].meshes.size());
            for (FilmMesh<D>& mesh : jobs[k].meshes)
                mesh.each_field(out);
        },
        [&](ByteReader& in, std::size_t k) {
            std::size_t count;
            in(jobs[k].threshold, count);
            jobs[k].meshes.resize(count);
            for (FilmMesh<D>& mesh : jobs[k].meshes)
                mesh.each_field(in);
        });
    std::vector<Film<D>> films;
    for (Job& job : jobs)
        for (FilmMesh<D>& mesh : job.meshes) {
            mesh.master = job.pair.master;
            mesh.other = job.pair.other;
            take_skin_off(mesh, job.gap.skin);
            mesh.shift = size.cwiseProduct(Index<D>(job.pair.shift.data()).template cast<double>());
            films.push_back({job.pair, std::move(mesh), job.threshold, 0, 0, job.mine});
        }
    number_films(films);
    return films;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<Film<D>> find_films<D>(const Grid<D>&, std::span<const Solid<D>>, const FaceClipper<D>&,              \
                                                const std::function<GapSettings(int, int)>&, const std::set<FilmPair<D>>&);    \
    template void number_films<D>(std::vector<Film<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
