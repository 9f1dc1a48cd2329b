#include "gapflow/film/mouths.hpp"

#include "gapflow/core/sharing.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/film/mouth_cells.hpp"
#include "gapflow/film/mouth_stencil.hpp"
#include "gapflow/film/rim_joints.hpp"
#include "gapflow/film/rim_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

namespace gapflow {

namespace {

constexpr double sample_distance = 0.5;     // of a mouth's grid pressure beyond the rim, in dx
constexpr double mouth_radius = 0.8;        // r in the mouth formulas, in dx: the radius that the grid resolves
constexpr double open_resistance = 0.2;     // of a mouth on an open side
constexpr double on_side = 1e-3;            // distance of a mouth from the side on which it lies, in dx
constexpr double minimum_resistance = 0.02; // keeps wide mouths positive
constexpr double touching = 1e-6;           // distance to a third body that closes a rim, in dx
constexpr double least_channel = 0.1;       // beyond a smooth mouth, in dx
constexpr double joint_reach = 1.5;         // in (h + h_other), else in dx

void add_weight(std::vector<std::pair<long, double>>& cells, long key, double weight)
{
    const auto known = std::find_if(cells.begin(), cells.end(), [&](const auto& entry) { return entry.first == key; });
    if (known != cells.end())
        known->second += weight;
    else
        cells.emplace_back(key, weight);
}

// From the rim's point x along its outward direction to a cell's centre.
template <int D>
double way_beyond(const Grid<D>& grid, const Vec<D>& x, const Vec<D>& outward, long key)
{
    return Vec<D>(grid.nearest_image(grid.cell_centre(grid.cell_of_key(key)) - x)).dot(outward);
}

// Beyond a smooth end the gap continues as a channel up to the stencil's point: the weighted mean of its cells along the
// rim's outward direction, plus the loss from returning the flux to cells that lie apart, their variance over dx (f (1 - f)
// dx for a sample a fraction f between two cells).
template <int D>
double channel_resistance(const Grid<D>& grid, const Vec<D>& x, const Vec<D>& outward, double h,
                          const std::vector<std::pair<long, double>>& cells)
{
    double mean = 0, square = 0;
    for (const auto& [key, weight] : cells) {
        const double s = way_beyond(grid, x, outward, key);
        mean += weight * s;
        square += weight * s * s;
    }
    const double length = std::max(mean + (square - mean * mean) / grid.dx(), least_channel * grid.dx());
    return std::max(length / h, minimum_resistance);
}

template <int D>
class MouthFinder {
public:
    MouthFinder(const Grid<D>& grid, const FaceClipper<D>& clipper, const FilmGaps<D>& gaps, const FilmCells<D>& cells)
        : grid_(grid), clipper_(clipper), gaps_(gaps), films_(gaps.films()), cells_(cells),
          points_(rim_points(films_, grid_.dx())), ends_(points_.size()), joints_(grid, films_, points_)
    {
    }

    /// Finds the type of end at each point of the rims, on the rank that has its place; after the first call only for points near cells that
    /// changed since. Collective.
    void find(const CellStates<D>& states, const std::vector<long>& changed)
    {
        KeyMap<char> near;
        for (long key : changed)
            for_each_index<D>(Index<D>::Constant(-2), Index<D>::Constant(3), [&](const Index<D>& d) {
                const Index<D> c =
                    grid_.cell_of_key(key) + d.unaryExpr([](int k) { return k * std::abs(k); }); // -4, -1, 0, 1, 4
                near.insert(block(c));
            });
        const auto is_sought = [&](std::size_t i) {
            return grid_.owns(grid_.nearest_cell(points_[i].x)) &&
                   (!found_ || near.contains(block(grid_.cell_of(points_[i].x))));
        };
        for_each_part(static_cast<long>(points_.size()), [&](long begin, long end) {
            Around around{states, {}};
            for (long i = begin; i < end; ++i)
                if (is_sought(i)) {
                    ends_[i] = {};
                    place(points_[i], around, ends_[i]);
                }
        });
        exchange_items(
            grid_.comm(), points_.size(), is_sought,
            [&](ByteWriter& out, std::size_t i) {
                out(ends_[i].closed, ends_[i].joints, ends_[i].mouth.has_value());
                if (ends_[i].mouth)
                    ends_[i].mouth->each_field(out);
            },
            [&](ByteReader& in, std::size_t i) {
                bool has_mouth;
                in(ends_[i].closed, ends_[i].joints, has_mouth);
                ends_[i].mouth.reset();
                if (has_mouth)
                    ends_[i].mouth.emplace().each_field(in);
            });
        found_ = true;
    }

    std::vector<long> reached() const
    {
        KeyMap<char> reached;
        for (const End& end : ends_)
            if (end.mouth)
                for (const auto& [key, weight] : end.mouth->cells)
                    reached.insert(key);
        std::vector<long> keys;
        for (const auto& item : reached)
            keys.push_back(item.first);
        return keys;
    }

    RimLinks<D> links()
    {
        RimLinks<D> result;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            End& end = ends_[i];
            if (end.mouth)
                result.mouths.push_back(std::move(*end.mouth));
            else if (end.closed)
                result.closed_length += points_[i].length;
            else if (end.joints.empty()) {
                result.blind_length += points_[i].length;
                if (!grid_.in_domain(grid_.wrapped(grid_.cell_of(points_[i].x))))
                    continue; // no fluid either: nothing to report
                if (result.blind.empty() || result.blind.back().film != points_[i].film)
                    result.blind.push_back({points_[i].film, points_[i].x, 0.0});
                result.blind.back().length += points_[i].length;
            }
            result.joints.insert(result.joints.end(), end.joints.begin(), end.joints.end());
        }
        return result;
    }

private:
    /// The end at a point of a rim; none: blind.
    struct End {
        bool closed = false;
        std::optional<Mouth<D>> mouth;
        std::vector<Joint<D>> joints;
    };

    /// What a thread knows of the places that it has come by.
    struct Around {
        const CellStates<D>& states;
        typename FaceClipper<D>::Nearby solids;
    };

    // First match: closed, side of the domain, free mouth, joint of neighbours, mouth, joint within reach, open side within reach, blind.
    void place(const RimPoint<D>& point, Around& around, End& end) const
    {
        const double dx = grid_.dx();
        if (closed(point, around)) {
            end.closed = true;
            return;
        }
        if (const int side = side_at(point, 0); side >= 0) {
            append_side_mouth(point, side, open_resistance, end);
            return;
        }
        const Vec<D> y = point.x + sample_distance * dx * point.edge->outward;
        std::vector<std::pair<long, double>> cells = stencil_across(point, y, around.states);
        if (!cells.empty() && is_free(point, y, around)) {
            append_mouth(point, kind_of_rim(point), std::move(cells), end);
            return;
        }
        if (joints_.add(point, joint_reach, 0, end.joints))
            return;
        if (!cells.empty())
            append_mouth(point, kind_of_rim(point), std::move(cells), end);
        else if (!joints_.add(point, 0, joint_reach * dx, end.joints))
            add_mouth_beyond_side(point, end);
    }

    // The rim abuts a third solid: a point further out would lie in it. Or the surfaces touch there and are one solid.
    bool closed(const RimPoint<D>& point, Around& around) const
    {
        if (point.edge->end == RimEnd::touching)
            return true;
        return any_third(point, point.x, around, [&](const PlacedShape<D>& shape) {
            if (shape.distance(point.x) > touching * grid_.dx())
                return false;
            const Vec<D> beyond = point.x + 1e-3 * grid_.dx() * point.edge->outward;
            return shape.distance(beyond) < shape.distance(point.x) - 0.5e-3 * grid_.dx();
        });
    }

    // The open or inflow side on which the rim lies, or that it reaches within `reach` along its outward direction; -1: none.
    int side_at(const RimPoint<D>& point, double reach) const
    {
        const double near = on_side * grid_.dx();
        for (int side = 0; side < 2 * D; ++side) {
            const SideKind kind = grid_.side(side / 2, side % 2);
            const int sign = 2 * (side % 2) - 1;
            const double out = sign * point.edge->outward[side / 2], distance = sign * (plane_of(side) - point.x[side / 2]);
            if ((is_open(kind) || kind == SideKind::inflow) && out >= 0.5 && distance >= -near &&
                distance <= std::max(near, reach * out))
                return side;
        }
        return -1;
    }

    double plane_of(int side) const { return grid_.origin()[side / 2] + side % 2 * grid_.size()[side / 2]; }

    void append_side_mouth(const RimPoint<D>& point, int side, double resistance, End& result) const
    {
        const MouthKind kind = is_open(grid_.side(side / 2, side % 2)) ? MouthKind::open_side : MouthKind::inflow;
        append_mouth(point, kind, {}, result);
        result.mouth->side = side;
        result.mouth->resistance = resistance;
    }

    // Where a film ends between an open side and the last cells' centres its gap goes on as a channel to the side.
    void add_mouth_beyond_side(const RimPoint<D>& point, End& result) const
    {
        const int side = side_at(point, sample_distance * grid_.dx());
        if (side < 0 || !is_open(grid_.side(side / 2, side % 2)))
            return;
        const double way = std::abs(plane_of(side) - point.x[side / 2]) / std::abs(point.edge->outward[side / 2]);
        append_side_mouth(point, side, std::max(way / point.h, open_resistance), result);
    }

    // Neither in a solid, or on its surface, nor in another film's gap.
    bool is_free(const RimPoint<D>& point, const Vec<D>& y, Around& around) const
    {
        const FilmPair<D>& own = films_[point.film].pair;
        const auto holds = [&](const PlacedShape<D>& shape) { return shape.distance(y) <= clipper_.tolerance(); };
        if (holds(gaps_.master(point.film)) || holds(gaps_.other(point.film)) || any_third(point, y, around, holds))
            return false;
        const Index<D> c = grid_.cell_of(y), w = grid_.wrapped(c);
        if (!grid_.in_domain(w))
            return false;
        const FilmCell<D>* cell = cells_.cells.find(grid_.key(w));
        return !cell || std::none_of(cell->touches.begin(), cell->touches.end(), [&](const Touch<D>& touch) {
            const Vec<D> there = y + grid_.dx() * (w + touch.offset - c).template cast<double>();
            return films_[touch.film].pair != own && gaps_.holds(touch.film, there);
        });
    }

    // Calls test for solids near x that are not the film's own pair; images are moved next to x.
    template <class Test>
    bool any_third(const RimPoint<D>& point, const Vec<D>& x, Around& around, Test&& test) const
    {
        const Vec<D> size = grid_.size();
        Vec<D> wrap = Vec<D>::Zero();
        for (int axis = 0; axis < D; ++axis)
            if (grid_.periodic(axis))
                wrap[axis] = -std::floor((x[axis] - grid_.origin()[axis]) / size[axis]) * size[axis];
        clipper_.near(x + wrap, grid_.dx(), around.solids);
        const FilmMesh<D>& mesh = films_[point.film].mesh;
        for (int i : around.solids.images) {
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

    MouthKind kind_of_rim(const RimPoint<D>& point) const
    {
        if (point.edge->end == RimEnd::thickness || point.edge->end == RimEnd::normals)
            return MouthKind::smooth;
        const Vec<D> probe = point.x + mouth_radius * grid_.dx() * point.edge->outward;
        auto goes_on = [&](const PlacedShape<D>& shape) {
            const SurfacePoint<D> p = shape.closest(probe);
            return p.feature == Feature::face && p.distance > -1e-9 * grid_.dx();
        };
        const bool either = goes_on(gaps_.master(point.film)) || goes_on(gaps_.other(point.film));
        return either ? MouthKind::edge_face : MouthKind::edge_edge;
    }

    // A mouth thicker than two cells that continues as a channel is connected to all cells across it: the mean of several stencils, one for
    // each cell of thickness. With a single stencil in the middle the flow would converge to it, and this transverse flow would drag on the walls.
    std::vector<std::pair<long, double>> stencil_across(const RimPoint<D>& point, const Vec<D>& y,
                                                        const CellStates<D>& states) const
    {
        const int count = static_cast<int>(std::ceil(point.h / grid_.dx() - 1e-9));
        if (point.h <= 2 * grid_.dx() || kind_of_rim(point) != MouthKind::smooth)
            return mouth_stencil(states, y);
        const Vec<D> across = way_across(point);
        std::vector<std::pair<long, double>> result;
        int found = 0;
        for (int k = 0; k < count; ++k) {
            const auto cells = mouth_stencil(states, Vec<D>(y + ((k + 0.5) / count - 0.5) * across));
            found += !cells.empty();
            for (const auto& [key, weight] : cells)
                add_weight(result, key, weight);
        }
        for (auto& entry : result)
            entry.second /= found;
        return result;
    }

    // From the master to the other.
    Vec<D> way_across(const RimPoint<D>& point) const
    {
        const FilmMesh<D>& mesh = films_[point.film].mesh;
        Vec<D> across = Vec<D>::Zero();
        for (int i = 0; i < D - 1; ++i)
            across += point.shape[i] * (mesh.y[point.edge->nodes[i]] - mesh.x[point.edge->nodes[i]]);
        return across;
    }

    // The line across the gap leads along the other's normal, which may lean out of the film or into it.
    Vec<D> section(const RimPoint<D>& point) const
    {
        const FilmMesh<D>& mesh = films_[point.film].mesh;
        const Vec<D>&normal = mesh.elements[point.edge->element].normal, &nu = point.edge->outward;
        Vec<D> across = way_across(point);
        const double length = across.norm();
        if (mesh.viscous || length < 1e-3 * point.h)
            return point.h * nu;
        across /= length;
        return point.h * (std::max(across.dot(normal), least_cosine) * nu - across.dot(nu) * normal);
    }

    void append_mouth(const RimPoint<D>& point, MouthKind kind, std::vector<std::pair<long, double>> cells, End& end) const
    {
        const Film<D>& film = films_[point.film];
        const double resistance = kind == MouthKind::smooth
                                      ? channel_resistance(grid_, point.x, point.edge->outward, point.h, cells)
                                      : mouth_resistance(kind, point.h, grid_.dx());
        end.mouth = {point.film,
                     kind,
                     global_nodes(film, point.edge->nodes),
                     point.edge->element,
                     point.shape,
                     point.x,
                     point.edge->outward,
                     section(point),
                     point.length,
                     point.h,
                     resistance,
                     std::move(cells),
                     -1};
    }

    // The block of four cells per side around a cell.
    long block(const Index<D>& cell) const
    {
        return cell_number<D>(grid_.wrapped(cell).unaryExpr([](int k) { return k >> 2; }));
    }

    const Grid<D>& grid_;
    const FaceClipper<D>& clipper_;
    const FilmGaps<D>& gaps_;
    std::span<const Film<D>> films_;
    const FilmCells<D>& cells_;
    std::vector<RimPoint<D>> points_;
    std::vector<End> ends_;
    RimJoints<D> joints_;
    bool found_ = false;
};

} // namespace

// Potential flow from a half-plane into a slot (conformal map dz/dzeta = (h / pi) sqrt(zeta^2 - 1) / zeta), matched at
// r = 0.8 dx. Beside a wall that goes on the distance between the slot and its mirror image grows with h, and the grid resolves
// less of the flow between them: r grows with h (its factor is fitted). A smooth end is a channel up to the sample point,
// and the 1/6 is the loss of multilinear interpolation and its transpose, f (1 - f) dx / h on average.
double mouth_resistance(MouthKind kind, double h, double dx)
{
    using std::numbers::pi;
    constexpr double mirror_part = 0.14;
    const double r = mouth_radius * dx;
    if (kind == MouthKind::edge_edge)
        return std::max((std::log(pi * r / (2 * h)) + 1) / pi, minimum_resistance);
    if (kind == MouthKind::edge_face) {
        const double wide = std::pow(std::pow(r, 4) + mirror_part * std::pow(h, 4), 0.25);
        return std::max(2 * (std::log(pi * wide / (4 * h)) + 1) / pi, minimum_resistance);
    }
    if (kind == MouthKind::smooth)
        return std::max((sample_distance + 1.0 / 6.0) * dx / h, minimum_resistance);
    return open_resistance;
}

namespace {

// Smooth mouths of films without viscosity lead to the cells behind the faces that the film closes there. For the grid these faces move with the master,
// and so does the film's end: with other cells a master that turns about its centre would drive a flux from one to the other.
template <int D>
void lead_behind_closed_faces(const Grid<D>& grid, FilmNetwork<D>& network)
{
    if (std::all_of(network.films.begin(), network.films.end(), [](const Film<D>& film) { return film.mesh.viscous; }))
        return;
    const std::vector<std::vector<ClosedArea<D>>> closed = closed_areas(grid, network);
    const std::vector<std::vector<Vec<D>>> places = mouth_places(network);
    for (Mouth<D>& mouth : network.rim.mouths) {
        const Film<D>& film = network.films[mouth.film];
        if (mouth.kind != MouthKind::smooth || film.mesh.viscous || mouth.cells.empty())
            continue;
        const std::vector<CarriedCell> behind = cells_behind<D>(mouth, film, closed[mouth.film], places[mouth.film], grid.dx());
        if (behind.empty() ||
            std::any_of(behind.begin(), behind.end(), [](const CarriedCell& cell) { return cell.weight < 0; }))
            continue;
        // Where the cells lie back from the rim, in part those of the interpolation beyond it.
        double back = 0, beyond = 0;
        for (const CarriedCell& cell : behind)
            back += cell.weight * way_beyond(grid, mouth.x, mouth.outward, cell.key);
        for (const auto& [key, weight] : mouth.cells)
            beyond += weight * way_beyond(grid, mouth.x, mouth.outward, key);
        const double least = least_channel * grid.dx();
        const double share = back >= least     ? 0.0
                             : beyond <= least ? 1.0
                                               : (least - back) / (beyond - back); // of the interpolation
        for (auto& entry : mouth.cells)
            entry.second *= share;
        for (const CarriedCell& cell : behind)
            add_weight(mouth.cells, cell.key, (1 - share) * cell.weight);
        std::erase_if(mouth.cells, [](const auto& entry) { return entry.second == 0; });
        mouth.resistance = channel_resistance(grid, mouth.x, mouth.outward, mouth.h, mouth.cells);
    }
}

} // namespace

template <int D>
FilmNetwork<D> build_film_network(const Grid<D>& grid, std::span<const Solid<D>> solids, const FaceClipper<D>& clipper,
                                  const FaceFractions<D>& fractions, const std::function<GapSettings(int, int)>& settings,
                                  const std::set<FilmPair<D>>& alive)
{
    FilmNetwork<D> network;
    network.ranks = grid.comm();
    auto faces = std::make_shared<FaceCache<D>>(grid, clipper, solids, fractions);
    network.faces = faces;
    network.films = find_films(grid, solids, clipper, settings, alive);
    for (bool dropped = true; dropped && !network.films.empty();) {
        const FilmGaps<D> gaps(grid, solids, network.films);
        network.cells = classify_cells<D>(*faces, gaps);
        MouthFinder<D> finder(grid, clipper, gaps, network.cells);
        std::vector<long> changed;
        for (int pass = 0; pass < 10; ++pass) {
            close_faces<D>(*faces, gaps, network.cells);
            const CellStates<D> states(*faces, network.cells);
            finder.find(states, changed);
            changed = absorb_pockets(*faces, states, finder.reached(), network.cells);
            if (changed.empty())
                break;
        }
        network.rim = finder.links();
        std::set<int> used;
        for (const auto& [key, cell] : network.cells.cells)
            if (cell.kind == CellKind::film)
                used.insert(cell.owner);
        for (const auto& [face, film] : network.cells.closed)
            used.insert(film);
        dropped = used.size() < network.films.size();
        if (dropped) {
            std::vector<Film<D>> kept;
            for (int k = 0; k < static_cast<int>(network.films.size()); ++k)
                if (used.count(k))
                    kept.push_back(std::move(network.films[k]));
            network.films = std::move(kept);
            number_films(network.films);
            network.cells = {};
            network.rim = {};
        }
    }
    for (const Film<D>& film : network.films) {
        network.nodes += static_cast<int>(film.mesh.h.size());
        network.elements += static_cast<int>(film.mesh.elements.size());
    }
    if (D == 2)
        lead_behind_closed_faces(grid, network);
    return network;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template FilmNetwork<D> build_film_network<D>(const Grid<D>&, std::span<const Solid<D>>, const FaceClipper<D>&,            \
                                                  const FaceFractions<D>&, const std::function<GapSettings(int, int)>&,        \
                                                  const std::set<FilmPair<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
