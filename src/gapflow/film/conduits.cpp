#include "gapflow/film/conduits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace gapflow {

namespace {

constexpr double sample_distance = 0.5;     // of a conduit's grid pressure beyond the rim, in dx
constexpr double mouth_radius = 0.8;        // r in the mouth formulas, in dx: what the grid itself resolves
constexpr double minimum_resistance = 0.2;
constexpr double rim_spacing = 0.125;       // of points along a rim, in dx
constexpr double full_aperture = 0.25;      // a cell counts in full for a conduit if its open fractions sum to this
constexpr double minimum_weight = 0.02;     // of a stencil: below, there is none
constexpr double touching = 1e-6;           // distance to a third body that closes a rim, in dx
constexpr double joint_reach = 1.5;         // in (h + h_other), else in dx
template <int D>
constexpr double joint_length = D == 2 ? 0.01 : 0.05; // film length whose resistance a joint has, in dx

template <int D>
struct RimPoint {
    int film;
    const RimEdge<D>* edge;
    std::array<double, D - 1> shape;
    Vec<D> x;
    double length, h;
};

template <int D>
std::array<int, D - 1> global_nodes(const Film<D>& film, const std::array<int, D - 1>& nodes)
{
    std::array<int, D - 1> result = nodes;
    for (int& n : result)
        n += film.first_node;
    return result;
}

template <int D>
std::vector<RimPoint<D>> rim_points(std::span<const Film<D>> films, double dx)
{
    std::vector<RimPoint<D>> points;
    for (int k = 0; k < static_cast<int>(films.size()); ++k) {
        const FilmMesh<D>& mesh = films[k].mesh;
        for (const RimEdge<D>& edge : mesh.rim) {
            if constexpr (D == 2) {
                points.push_back({k, &edge, {1.0}, mesh.mid[edge.nodes[0]], 1.0, mesh.h[edge.nodes[0]]});
            } else {
                const auto [a, b] = edge.nodes;
                const int count = std::max(1, static_cast<int>(std::ceil(edge.length / (rim_spacing * dx) - 1e-9)));
                for (int i = 0; i < count; ++i) {
                    const double s = (i + 0.5) / count;
                    points.push_back({k, &edge, {1 - s, s}, (1 - s) * mesh.mid[a] + s * mesh.mid[b], edge.length / count,
                                      (1 - s) * mesh.h[a] + s * mesh.h[b]});
                }
            }
        }
    }
    return points;
}

template <int D>
class MouthFinder {
public:
    MouthFinder(const FaceCache<D>& faces, const FaceClipper<D>& clipper, std::span<const Solid<D>> solids,
                std::span<const Film<D>> films, const FilmCells<D>& cells)
        : faces_(faces), grid_(faces.grid()), clipper_(clipper), solids_(solids), films_(films), cells_(cells)
    {
    }

    Mouths<D> find()
    {
        points_ = rim_points(films_, grid_.dx());
        for (int i = 0; i < static_cast<int>(points_.size()); ++i)
            bins_[bin(grid_.wrapped(grid_.cell_of(points_[i].x)))].push_back(i);
        for (const RimPoint<D>& point : points_) {
            largest_h_ = std::max(largest_h_, point.h);
            if (D == 3)
                longest_edge_ = std::max(longest_edge_, point.edge->length);
        }
        for (const RimPoint<D>& point : points_)
            place(point);
        std::set<long> reached;
        for (const Conduit<D>& conduit : result_.conduits)
            for (const auto& [key, weight] : conduit.cells)
                reached.insert(key);
        result_.reached.assign(reached.begin(), reached.end());
        return std::move(result_);
    }

private:
    // First match: closed, side of the domain, free conduit, joint of neighbours, conduit, joint within reach, blind.
    void place(const RimPoint<D>& point)
    {
        const double dx = grid_.dx();
        if (closed(point)) {
            result_.closed_length += point.length;
            return;
        }
        if (add_side_conduit(point))
            return;
        const Vec<D> y = point.x + sample_distance * dx * point.edge->outward;
        const std::vector<std::pair<long, double>> cells = stencil(y);
        if (!cells.empty() && is_free(point, y)) {
            add_conduit(point, kind_of_rim(point), cells);
            return;
        }
        if (add_joints(point, joint_reach, 0))
            return;
        if (!cells.empty()) {
            add_conduit(point, kind_of_rim(point), cells);
            return;
        }
        if (!add_joints(point, 0, joint_reach * dx))
            result_.blind_length += point.length;
    }

    // The rim abuts a third solid: going on would enter it.
    bool closed(const RimPoint<D>& point)
    {
        return any_third(point, point.x, [&](const PlacedShape<D>& shape) {
            if (shape.distance(point.x) > touching * grid_.dx())
                return false;
            const Vec<D> beyond = point.x + 1e-3 * grid_.dx() * point.edge->outward;
            return shape.distance(beyond) < shape.distance(point.x) - 0.5e-3 * grid_.dx();
        });
    }

    bool add_side_conduit(const RimPoint<D>& point)
    {
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end) {
                const SideKind side = grid_.side(axis, end);
                const double plane = grid_.origin()[axis] + end * grid_.size()[axis];
                if ((side != SideKind::open && side != SideKind::inflow) ||
                    std::abs(point.x[axis] - plane) > 1e-3 * grid_.dx() || point.edge->outward[axis] * (2 * end - 1) < 0.5)
                    continue;
                add_conduit(point, side == SideKind::open ? ConduitKind::open_side : ConduitKind::inflow, {});
                return true;
            }
        return false;
    }

    // Neither in a solid nor in another film's gap.
    bool is_free(const RimPoint<D>& point, const Vec<D>& y)
    {
        const FilmPair<D>& own = films_[point.film].pair;
        if (solids_[own.master].shape.distance(y) < 0 || other_shape(grid_, solids_, own).distance(y) < 0 ||
            any_third(point, y, [&](const PlacedShape<D>& shape) { return shape.distance(y) < 0; }))
            return false;
        const Index<D> c = grid_.cell_of(y), w = grid_.wrapped(c);
        if (!grid_.in_domain(w))
            return false;
        auto it = cells_.cells.find(grid_.key(w));
        if (it == cells_.cells.end())
            return true;
        return std::none_of(it->second.touches.begin(), it->second.touches.end(), [&](const Touch<D>& touch) {
            const Vec<D> there = y + grid_.dx() * (w + touch.offset - c).template cast<double>();
            return films_[touch.film].pair != own && in_film_gap(grid_, solids_, films_[touch.film], there);
        });
    }

    // Calls test for solids near x that are not the film's own pair; images are moved next to x.
    template <class Test>
    bool any_third(const RimPoint<D>& point, const Vec<D>& x, Test&& test)
    {
        const Vec<D> size = grid_.size();
        Vec<D> wrap = Vec<D>::Zero();
        for (int axis = 0; axis < D; ++axis)
            if (grid_.periodic(axis))
                wrap[axis] = -std::floor((x[axis] - grid_.origin()[axis]) / size[axis]) * size[axis];
        clipper_.near(x + wrap, grid_.dx(), candidates_);
        const FilmMesh<D>& mesh = films_[point.film].mesh;
        for (int i : candidates_) {
            const Image<D>& image = clipper_.images()[i];
            const Vec<D> shift = image.shift - wrap;
            const double same = 1e-9 * size.norm();
            if ((image.solid == mesh.master && shift.norm() < same) ||
                (image.solid == mesh.other && (shift - mesh.shift).norm() < same))
                continue;
            if (test(image.shape.shifted(-wrap)))
                return true;
        }
        return false;
    }

    ConduitKind kind_of_rim(const RimPoint<D>& point) const
    {
        if (point.edge->end == RimEnd::thickness || point.edge->end == RimEnd::normals)
            return ConduitKind::smooth;
        const FilmPair<D>& pair = films_[point.film].pair;
        const Vec<D> probe = point.x + mouth_radius * grid_.dx() * point.edge->outward;
        auto goes_on = [&](const PlacedShape<D>& shape) {
            const SurfacePoint<D> p = shape.closest(probe);
            return p.feature == Feature::face && p.distance > -1e-9 * grid_.dx();
        };
        const bool either = goes_on(solids_[pair.master].shape) || goes_on(other_shape(grid_, solids_, pair));
        return either ? ConduitKind::edge_face : ConduitKind::edge_edge;
    }

    double aperture(const Index<D>& cell)
    {
        double sum = 0;
        for (const CellSide<D>& side : sides_of(grid_, cell))
            sum += open_after_closing(faces_, cells_, side.axis, side.face);
        return sum;
    }

    // Multilinear weights over bulk and mixed cells around y, those connected to the heaviest one through open faces
    // nearby (within one cell of the stencil: nothing leaks through a thin wall).
    std::vector<std::pair<long, double>> stencil(const Vec<D>& y)
    {
        const Vec<D> place = (y - grid_.origin()) / grid_.dx() - Vec<D>::Constant(0.5);
        const Index<D> base = place.array().floor().template cast<int>();
        std::vector<std::pair<Index<D>, double>> corners;
        int heaviest = -1;
        for (int corner = 0; corner < (1 << D); ++corner) {
            Index<D> c = base;
            double weight = 1;
            for (int axis = 0; axis < D; ++axis) {
                const double f = place[axis] - base[axis];
                const bool high = corner >> axis & 1;
                c[axis] += high;
                weight *= high ? f : 1 - f;
            }
            if (weight <= 1e-9 || !grid_.in_domain(grid_.wrapped(c)))
                continue;
            const CellKind kind = kind_of(faces_, cells_, c);
            if (kind != CellKind::bulk && kind != CellKind::mixed)
                continue;
            weight *= std::min(1.0, aperture(c) / full_aperture);
            if (weight <= 0)
                continue;
            corners.emplace_back(c, weight);
            if (heaviest < 0 || weight > corners[heaviest].second)
                heaviest = static_cast<int>(corners.size()) - 1;
        }
        if (heaviest < 0)
            return {};
        const std::vector<Index<D>> connected = connected_around(corners[heaviest].first, base);
        std::vector<std::pair<long, double>> result;
        double total = 0;
        for (const auto& [c, weight] : corners)
            if (std::find(connected.begin(), connected.end(), c) != connected.end()) {
                result.emplace_back(grid_.key(grid_.wrapped(c)), weight);
                total += weight;
            }
        if (total < minimum_weight)
            return {};
        for (auto& entry : result)
            entry.second /= total;
        return result;
    }

    // Cells joined to `start` through open faces within one cell of the stencil at base .. base + 1.
    std::vector<Index<D>> connected_around(const Index<D>& start, const Index<D>& base)
    {
        std::vector<Index<D>> found{start};
        for (std::size_t i = 0; i < found.size(); ++i)
            for (const CellSide<D>& side : sides_of(grid_, found[i])) {
                const Index<D> d = side.cell - base;
                if (!side.inside || (d.array() < -1).any() || (d.array() > 2).any() ||
                    std::find(found.begin(), found.end(), side.cell) != found.end())
                    continue;
                if (open_after_closing(faces_, cells_, side.axis, side.face) > 1e-12)
                    found.push_back(side.cell);
            }
        return found;
    }

    void add_conduit(const RimPoint<D>& point, ConduitKind kind, const std::vector<std::pair<long, double>>& cells)
    {
        const Film<D>& film = films_[point.film];
        const double resistance = kind == ConduitKind::smooth ? std::max(channel_length(point, cells) / point.h, minimum_resistance)
                                                              : mouth_resistance(kind, point.h, grid_.dx());
        result_.conduits.push_back({point.film, kind, global_nodes(film, point.edge->nodes), point.shape, point.x,
                                    point.edge->outward, point.length, point.h, resistance, cells});
    }

    // A smooth end goes on as a channel up to where the stencil takes its pressure: the weighted mean of its cells, along the
    // rim's outward direction, and what handing the flux back to cells that are apart loses, their variance over dx (f (1 - f)
    // dx for a sample a fraction f between two cells).
    double channel_length(const RimPoint<D>& point, const std::vector<std::pair<long, double>>& cells) const
    {
        double mean = 0, square = 0;
        for (const auto& [key, weight] : cells) {
            Vec<D> to = grid_.cell_centre(grid_.cell_of_key(key)) - point.x;
            for (int axis = 0; axis < D; ++axis)
                if (grid_.periodic(axis))
                    to[axis] -= grid_.size()[axis] * std::round(to[axis] / grid_.size()[axis]);
            const double s = to.dot(point.edge->outward);
            mean += weight * s;
            square += weight * s * s;
        }
        return std::max(mean + (square - mean * mean) / grid_.dx(), 0.1 * grid_.dx());
    }

    // Ties the point to the nearest rim of other films within factor * (h + h_other) + reach. 2D: to all ends there.
    bool add_joints(const RimPoint<D>& point, double factor, double reach)
    {
        const RimPoint<D>* nearest = nullptr;
        double best = std::numeric_limits<double>::infinity();
        std::array<double, D - 1> best_shape{};
        bool any = false;
        const Index<D> centre = grid_.cell_of(point.x);
        const double slack = 1e-9 * grid_.dx();
        const double furthest = factor * (point.h + largest_h_) + reach + slack + 0.5 * longest_edge_;
        const int cells = std::min(2, static_cast<int>(furthest / grid_.dx()) + 1);
        for_each_index<D>(Index<D>::Constant(-cells), Index<D>::Constant(cells + 1), [&](const Index<D>& d) {
            auto it = bins_.find(bin(grid_.wrapped(centre + d)));
            if (it == bins_.end())
                return;
            for (int i : it->second) {
                const RimPoint<D>& other = points_[i];
                if (other.film == point.film)
                    continue;
                if (!near(point.x, other, factor * (point.h + other.h) + reach + slack))
                    continue;
                std::array<double, D - 1> shape = other.shape;
                const double distance = distance_to_rim(point.x, other, shape);
                if (distance > factor * (point.h + other.h) + reach + slack)
                    continue;
                any = true;
                if constexpr (D == 2)
                    tie(point, other, shape);
                else if (distance < best) {
                    best = distance;
                    nearest = &other;
                    best_shape = shape;
                }
            }
        });
        if (nearest)
            tie(point, *nearest, best_shape);
        return any;
    }

    // From the other point to x, or to its nearest image.
    Vec<D> towards(const Vec<D>& x, const RimPoint<D>& other) const
    {
        Vec<D> to = x - other.x;
        for (int axis = 0; axis < D; ++axis)
            if (grid_.periodic(axis))
                to[axis] -= grid_.size()[axis] * std::round(to[axis] / grid_.size()[axis]);
        return to;
    }

    // Can the other point's rim edge come within `reach` of x?
    bool near(const Vec<D>& x, const RimPoint<D>& other, double reach) const
    {
        const double all = reach + (D == 3 ? other.edge->length : 0.0);
        return towards(x, other).squaredNorm() <= all * all;
    }

    // Distance from x to the other point's rim edge; `shape` becomes the edge's shape functions at the closest point.
    double distance_to_rim(const Vec<D>& x, const RimPoint<D>& other, std::array<double, D - 1>& shape) const
    {
        Vec<D> to = towards(x, other);
        if constexpr (D == 3) {
            const FilmMesh<D>& mesh = films_[other.film].mesh;
            const Vec<D> along = mesh.mid[other.edge->nodes[1]] - mesh.mid[other.edge->nodes[0]];
            const double s = std::clamp(other.shape[1] + to.dot(along) / along.squaredNorm(), 0.0, 1.0);
            to -= (s - other.shape[1]) * along;
            shape = {1 - s, s};
        }
        return to.norm();
    }

    void tie(const RimPoint<D>& a, const RimPoint<D>& b, const std::array<double, D - 1>& shape_b)
    {
        const double conductance = a.length * std::min(a.h, b.h) / (joint_length<D> * grid_.dx());
        result_.joints.push_back({global_nodes(films_[a.film], a.edge->nodes), global_nodes(films_[b.film], b.edge->nodes),
                                  a.shape, shape_b, conductance});
    }

    // Of a cell in the domain or outside (rims lie on walls, to round-off).
    static long bin(const Index<D>& cell)
    {
        long k = 0;
        for (int axis = 0; axis < D; ++axis)
            k = (k << 21) + cell[axis];
        return k;
    }

    const FaceCache<D>& faces_;
    const Grid<D>& grid_;
    const FaceClipper<D>& clipper_;
    std::span<const Solid<D>> solids_;
    std::span<const Film<D>> films_;
    const FilmCells<D>& cells_;
    std::vector<RimPoint<D>> points_;
    std::unordered_map<long, std::vector<int>> bins_;
    double largest_h_ = 0, longest_edge_ = 0;
    std::vector<int> candidates_;
    Mouths<D> result_;
};

} // namespace

// Potential flow from a half-plane into a slot (conformal map dz/dzeta = (h / pi) sqrt(zeta^2 - 1) / zeta), matched at
// r = 0.8 dx; a smooth end is a channel up to the sample point, and the 1/6 is what multilinear interpolation and its
// transpose lose, f (1 - f) dx / h in the mean.
double mouth_resistance(ConduitKind kind, double h, double dx)
{
    using std::numbers::pi;
    const double r = mouth_radius * dx;
    double resistance = minimum_resistance;
    if (kind == ConduitKind::edge_edge)
        resistance = (std::log(pi * r / (2 * h)) + 1) / pi;
    else if (kind == ConduitKind::edge_face)
        resistance = 2 * (std::log(pi * r / (4 * h)) + 1) / pi;
    else if (kind == ConduitKind::smooth)
        resistance = (sample_distance + 1.0 / 6.0) * dx / h;
    return std::max(resistance, minimum_resistance);
}

template <int D>
Mouths<D> find_mouths(const FaceCache<D>& faces, const FaceClipper<D>& clipper, std::span<const Solid<D>> solids,
                      std::span<const Film<D>> films, const FilmCells<D>& cells)
{
    return MouthFinder<D>(faces, clipper, solids, films, cells).find();
}

template <int D>
FilmNetwork<D> build_film_network(const Grid<D>& grid, std::span<const Solid<D>> solids, const FaceClipper<D>& clipper,
                                  const std::function<GapSettings(int, int)>& settings, const std::set<FilmPair<D>>& alive)
{
    FilmNetwork<D> network;
    auto faces = std::make_shared<FaceCache<D>>(grid, clipper);
    network.faces = faces;
    network.films = find_films(grid, solids, clipper, settings, alive);
    for (bool dropped = true; dropped && !network.films.empty();) {
        network.cells = classify_cells<D>(*faces, solids, network.films);
        for (int pass = 0; pass < 10; ++pass) {
            close_faces<D>(*faces, solids, network.films, network.cells);
            network.mouths = find_mouths<D>(*faces, clipper, solids, network.films, network.cells);
            if (!absorb_pockets(*faces, network.mouths.reached, network.cells))
                break;
        }
        std::set<int> used;
        for (const auto& [key, cell] : network.cells.cells)
            if (cell.kind == CellKind::film)
                used.insert(cell.owner);
        dropped = used.size() < network.films.size();
        if (dropped) {
            std::vector<Film<D>> kept;
            for (int k = 0; k < static_cast<int>(network.films.size()); ++k)
                if (used.count(k))
                    kept.push_back(std::move(network.films[k]));
            network.films = std::move(kept);
            number_films(network.films);
            network.cells = {};
            network.mouths = {};
        }
    }
    for (const Film<D>& film : network.films) {
        network.nodes += static_cast<int>(film.mesh.h.size());
        network.elements += static_cast<int>(film.mesh.elements.size());
    }
    return network;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Mouths<D> find_mouths<D>(const FaceCache<D>&, const FaceClipper<D>&, std::span<const Solid<D>>,                   \
                                      std::span<const Film<D>>, const FilmCells<D>&);                                          \
    template FilmNetwork<D> build_film_network<D>(const Grid<D>&, std::span<const Solid<D>>, const FaceClipper<D>&,            \
                                                  const std::function<GapSettings(int, int)>&, const std::set<FilmPair<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
