#include "gapflow/film/film_cells.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace gapflow {

namespace {

// Open fractions below this do not count.
constexpr double negligible_opening = 1e-12;

// Sum of open fractions below which a mixed cell gets its faces to other mixed cells back.
constexpr double strangled_aperture = 0.25;

// Largest grid component that a film absorbs.
template <int D>
constexpr int pocket_cells = D == 2 ? 9 : 27;

} // namespace

// ---- faces

template <int D>
Index<D> FaceCache<D>::stored(const Index<D>& f) const
{
    return grid_->wrapped(f);
}

template <int D>
long FaceCache<D>::key(int axis, const Index<D>& f) const
{
    const Index<D> s = stored(f);
    long k = 0;
    for (int a = D - 1; a >= 0; --a)
        k = k * (grid_->cells()[a] + 1) + s[a];
    return k * D + axis;
}

template <int D>
typename FaceCache<D>::Entry& FaceCache<D>::entry(int axis, const Index<D>& f) const
{
    auto [it, is_new] = entries_.try_emplace(key(axis, f));
    if (is_new)
        clipper_->clip(axis, stored(f), it->second.parts);
    return it->second;
}

template <int D>
const ClippedFace<D>& FaceCache<D>::face(int axis, const Index<D>& f) const
{
    return entry(axis, f).parts;
}

template <int D>
Vec<D> FaceCache<D>::displacement(const Index<D>& f) const
{
    return grid_->dx() * (f - stored(f)).template cast<double>();
}

template <int D>
Vec<D> FaceCache<D>::open_point(int axis, const Index<D>& f) const
{
    Entry& e = entry(axis, f);
    if (!e.has_open_point) {
        e.open_point = e.parts.solid.size() == 0 ? grid_->face_centre(axis, stored(f))
                                                 : clipper_->deepest_open_centroid(axis, stored(f));
        e.has_open_point = true;
    }
    return e.open_point + displacement(f);
}

// ---- cells

template <int D>
std::array<CellSide<D>, 2 * D> sides_of(const Grid<D>& grid, const Index<D>& cell)
{
    std::array<CellSide<D>, 2 * D> sides;
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end) {
            CellSide<D>& side = sides[2 * axis + end];
            side.axis = axis;
            side.end = end;
            side.face = cell + end * step<D>(axis);
            side.cell = cell + (2 * end - 1) * step<D>(axis);
            side.inside = grid.in_domain(grid.wrapped(side.cell));
        }
    return sides;
}

template <int D>
bool in_film_gap(const Grid<D>& grid, std::span<const Solid<D>> solids, const Film<D>& film, const Vec<D>& x)
{
    return in_gap<D>(solids[film.pair.master].shape, other_shape(grid, solids, film.pair), x, film.threshold);
}

template <int D>
void cells_on_segment(const Grid<D>& grid, const Vec<D>& x, const Vec<D>& y, std::vector<Index<D>>& result)
{
    result.clear();
    const Index<D> first = grid.cell_of(x), last = grid.cell_of(y);
    if (first == last) {
        result.push_back(first);
        return;
    }
    thread_local std::vector<double> crossings;
    crossings.assign({0.0, 1.0});
    for (int axis = 0; axis < D; ++axis)
        for (int k = std::min(first[axis], last[axis]) + 1; k <= std::max(first[axis], last[axis]); ++k) {
            const double plane = grid.origin()[axis] + k * grid.dx();
            crossings.push_back(std::clamp((plane - x[axis]) / (y[axis] - x[axis]), 0.0, 1.0));
        }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        if (crossings[i + 1] - crossings[i] <= 1e-12)
            continue;
        const Index<D> c = grid.cell_of(x + 0.5 * (crossings[i] + crossings[i + 1]) * (y - x));
        if (result.empty() || result.back() != c)
            result.push_back(c);
    }
}

namespace {

template <int D>
struct Classifier {
    const FaceCache<D>& faces;
    const Grid<D>& grid;
    std::span<const Solid<D>> solids;
    std::span<const Film<D>> films;
    FilmCells<D>& result;

    // Points that stand for the open faces of a cell of the domain.
    std::vector<Vec<D>> open_points(const Index<D>& cell) const
    {
        std::vector<Vec<D>> points;
        for (const CellSide<D>& side : sides_of(grid, cell))
            if (faces.face(side.axis, side.face).open > negligible_opening)
                points.push_back(faces.open_point(side.axis, side.face));
        return points;
    }

    bool holds(const Touch<D>& touch, const Vec<D>& x) const
    {
        return in_film_gap<D>(grid, solids, films[touch.film], x + grid.dx() * touch.offset.template cast<double>());
    }

    bool holds(const Touch<D>& touch, const std::vector<Vec<D>>& points) const
    {
        return std::all_of(points.begin(), points.end(), [&](const Vec<D>& x) { return holds(touch, x); });
    }

    // Do both solids of a pair meet in the closed cell, so that neither's flux out of it vanishes?
    bool has_body_flux(const Index<D>& cell, const FilmPair<D>& pair) const
    {
        std::map<int, Vec<D>> area;
        for (const CellSide<D>& side : sides_of(grid, cell))
            for (const SolidPart<D>& part : faces.face(side.axis, side.face).solid) {
                auto [it, is_new] = area.try_emplace(part.solid, Vec<D>::Zero());
                it->second += (2 * side.end - 1) * part.fraction * unit<D>(side.axis);
            }
        return area.count(pair.master) && area.count(pair.other) && area[pair.master].norm() > 1e-12 &&
               area[pair.other].norm() > 1e-12;
    }

    void count_touches()
    {
        std::map<std::pair<long, int>, Touch<D>> touches;
        std::vector<Index<D>> passed;
        for (int k = 0; k < static_cast<int>(films.size()); ++k)
            for (const FilmPoint<D>& point : films[k].mesh.points) {
                cells_on_segment<D>(grid, point.x, point.y, passed);
                const Index<D> last = grid.cell_of(point.y + 1e-9 * grid.dx() * point.other_normal);
                if (std::find(passed.begin(), passed.end(), last) == passed.end())
                    passed.push_back(last);
                for (const Index<D>& c : passed) {
                    const Index<D> w = grid.wrapped(c);
                    if (!grid.in_domain(w))
                        continue;
                    auto [it, is_new] = touches.try_emplace({grid.key(w), k}, Touch<D>{k, 0, c - w});
                    ++it->second.points;
                }
            }
        for (const auto& [where, touch] : touches)
            result.cells[where.first].touches.push_back(touch);
        for (auto& [key, cell] : result.cells)
            std::stable_sort(cell.touches.begin(), cell.touches.end(),
                             [](const Touch<D>& a, const Touch<D>& b) { return a.points > b.points; });
    }

    void set_kind(long key, FilmCell<D>& cell)
    {
        const std::vector<Vec<D>> points = open_points(grid.cell_of_key(key));
        cell.owner = cell.touches.front().film;
        for (const Touch<D>& touch : cell.touches)
            if (holds(touch, points)) {
                cell.owner = touch.film;
                cell.kind = CellKind::film;
                return;
            }
        const bool together = std::all_of(points.begin(), points.end(), [&](const Vec<D>& x) {
            return std::any_of(cell.touches.begin(), cell.touches.end(), [&](const Touch<D>& t) { return holds(t, x); });
        });
        cell.kind = together ? CellKind::film : CellKind::mixed;
    }

    // Makes a cell that no film touches a cell of the film of `touch`.
    void add_film_cell(long key, const Touch<D>& touch)
    {
        FilmCell<D> cell;
        cell.kind = CellKind::film;
        cell.owner = touch.film;
        cell.touches.push_back({touch.film, 0, touch.offset});
        result.cells.emplace(key, cell);
    }

    // Calls f(neighbour's key, touch of `cell` by `film` seen from there) for a cell of the domain displaced by d.
    template <class F>
    void seen_from(long key, const FilmCell<D>& cell, int film, const Index<D>& d, F&& f) const
    {
        const Index<D> c = grid.cell_of_key(key) + d, w = grid.wrapped(c);
        if (grid.in_domain(w) && !result.cells.count(grid.key(w)))
            f(grid.key(w), Touch<D>{film, 0, cell.offset(film) + c - w});
    }

    // Bulk cells beside film cells that lie wholly in the same gap.
    void take_neighbours()
    {
        std::vector<std::pair<long, Touch<D>>> taken;
        for (const auto& [key, cell] : result.cells) {
            if (cell.kind != CellKind::film)
                continue;
            for (int side = 0; side < 2 * D; ++side)
                seen_from(key, cell, cell.owner, (side % 2 ? 1 : -1) * step<D>(side / 2), [&](long beyond, const Touch<D>& touch) {
                    const std::vector<Vec<D>> points = open_points(grid.cell_of_key(beyond));
                    if (!points.empty() && holds(touch, points))
                        taken.emplace_back(beyond, touch);
                });
        }
        for (const auto& [key, touch] : taken)
            add_film_cell(key, touch);
    }

    // Closed cells with a body flux that no film touches (contact surfaces on a grid plane), up to two cells from one.
    void take_orphans()
    {
        std::map<long, Touch<D>> taken;
        std::set<long> seen;
        for (const auto& [key, cell] : result.cells) {
            if (cell.touches.front().points == 0)
                continue;
            for_each_index<D>(Index<D>::Constant(-2), Index<D>::Constant(3), [&](const Index<D>& d) {
                seen_from(key, cell, cell.touches.front().film, d, [&](long beyond, const Touch<D>& touch) {
                    if (seen.insert(beyond).second && open_points(grid.cell_of_key(beyond)).empty() &&
                        has_body_flux(grid.cell_of_key(beyond), films[touch.film].pair))
                        taken.emplace(beyond, touch);
                });
            });
        }
        for (const auto& [key, touch] : taken)
            add_film_cell(key, touch);
    }
};

} // namespace

template <int D>
FilmCells<D> classify_cells(const FaceCache<D>& faces, std::span<const Solid<D>> solids, std::span<const Film<D>> films)
{
    FilmCells<D> result;
    Classifier<D> classifier{faces, faces.grid(), solids, films, result};
    classifier.count_touches();
    for (auto& [key, cell] : result.cells)
        classifier.set_kind(key, cell);
    classifier.take_neighbours();
    classifier.take_orphans();
    return result;
}

template <int D>
CellKind kind_of(const FaceCache<D>& faces, const FilmCells<D>& cells, const Index<D>& cell)
{
    const Index<D> w = faces.grid().wrapped(cell);
    auto it = cells.cells.find(faces.grid().key(w));
    if (it != cells.cells.end())
        return it->second.kind;
    for (const CellSide<D>& side : sides_of(faces.grid(), w))
        if (faces.face(side.axis, side.face).open > negligible_opening)
            return CellKind::bulk;
    return CellKind::solid;
}

template <int D>
double open_after_closing(const FaceCache<D>& faces, const FilmCells<D>& cells, int axis, const Index<D>& face)
{
    if (!cells.closed.empty() && cells.closed.count(faces.key(axis, face)))
        return 0.0;
    return faces.face(axis, face).open;
}

namespace {

// A mixed cell whose faces to other mixed cells were closed may be left with a sliver of an opening, through which all that its
// film does not take would be forced: those faces open again.
template <int D>
void reopen_strangled(const FaceCache<D>& faces, FilmCells<D>& cells)
{
    const Grid<D>& grid = faces.grid();
    auto is_mixed = [&](long key) { return cells.kind(key, CellKind::bulk) == CellKind::mixed; };
    std::vector<long> reopened;
    for (const auto& [key, cell] : cells.cells) {
        if (cell.kind != CellKind::mixed)
            continue;
        double aperture = 0;
        std::vector<long> closed;
        for (const CellSide<D>& side : sides_of(grid, grid.cell_of_key(key))) {
            aperture += open_after_closing(faces, cells, side.axis, side.face);
            const long face = faces.key(side.axis, side.face);
            if (side.inside && cells.closed.count(face) && is_mixed(grid.key(grid.wrapped(side.cell))))
                closed.push_back(face);
        }
        if (aperture < strangled_aperture)
            reopened.insert(reopened.end(), closed.begin(), closed.end());
    }
    for (long face : reopened)
        cells.closed.erase(face);
}

} // namespace

template <int D>
void close_faces(const FaceCache<D>& faces, std::span<const Solid<D>> solids, std::span<const Film<D>> films, FilmCells<D>& cells)
{
    const Grid<D>& grid = faces.grid();
    cells.closed.clear();
    auto holds = [&](const FilmCell<D>& cell, int film, const Vec<D>& x) {
        return in_film_gap<D>(grid, solids, films[film], x + grid.dx() * cell.offset(film).template cast<double>());
    };
    for (const auto& [key, cell] : cells.cells) {
        for (const CellSide<D>& side : sides_of(grid, grid.cell_of_key(key))) {
            if (!side.inside || faces.face(side.axis, side.face).open <= 0)
                continue;
            auto beyond = cells.cells.find(grid.key(grid.wrapped(side.cell)));
            const FilmCell<D>* other = beyond == cells.cells.end() ? nullptr : &beyond->second;
            const bool film = cell.kind == CellKind::film, other_film = other && other->kind == CellKind::film;
            int owner = -1;
            if (film && other_film && cell.owner != other->owner) {
                const Vec<D> x = faces.open_point(side.axis, side.face);
                const bool own = holds(cell, cell.owner, x), others = holds(*other, other->owner, x - faces.displacement(side.cell));
                owner = own == others ? std::min(cell.owner, other->owner) : own ? cell.owner : other->owner;
            } else if (film) {
                owner = cell.owner;
            } else if (other_film) {
                owner = other->owner;
            } else if (other && cell.kind == CellKind::mixed && other->kind == CellKind::mixed) {
                const Vec<D> x = faces.open_point(side.axis, side.face);
                for (const Touch<D>& touch : cell.touches) { // the lowest common film whose gap holds the face
                    const bool common = std::any_of(other->touches.begin(), other->touches.end(),
                                                    [&](const Touch<D>& t) { return t.film == touch.film; });
                    if (common && (owner < 0 || touch.film < owner) && holds(cell, touch.film, x))
                        owner = touch.film;
                }
            }
            if (owner >= 0)
                cells.closed.emplace(faces.key(side.axis, side.face), owner);
        }
    }
    reopen_strangled(faces, cells);
}

template <int D>
bool absorb_pockets(const FaceCache<D>& faces, const std::vector<long>& reached, FilmCells<D>& cells)
{
    const Grid<D>& grid = faces.grid();
    std::set<long> seen, reach(reached.begin(), reached.end());
    std::vector<std::pair<long, FilmCell<D>>> taken;
    // Seeds: mixed cells, and unclassified cells beside film or mixed ones.
    std::vector<std::tuple<long, long, const FilmCell<D>*>> seeds;
    for (const auto& [key, cell] : cells.cells) {
        if (cell.kind == CellKind::mixed)
            seeds.emplace_back(key, key, &cell);
        for (const CellSide<D>& side : sides_of(grid, grid.cell_of_key(key)))
            if (side.inside && faces.face(side.axis, side.face).open > negligible_opening) {
                const long beyond = grid.key(grid.wrapped(side.cell));
                if (!cells.cells.count(beyond))
                    seeds.emplace_back(beyond, key, &cell);
            }
    }
    for (const auto& [seed, beside_key, beside] : seeds) {
        if (seen.count(seed))
            continue;
        std::vector<long> component{seed};
        std::set<long> members{seed};
        bool small = true;
        for (std::size_t i = 0; i < component.size() && small; ++i) {
            for (const CellSide<D>& side : sides_of(grid, grid.cell_of_key(component[i]))) {
                if (open_after_closing(faces, cells, side.axis, side.face) <= negligible_opening)
                    continue;
                if (!side.inside) { // an open side of the domain: not a pocket
                    small = false;
                    break;
                }
                const long beyond = grid.key(grid.wrapped(side.cell));
                if (members.insert(beyond).second)
                    component.push_back(beyond);
            }
            small = small && static_cast<int>(component.size()) <= pocket_cells<D>;
        }
        if (!small)
            continue;
        seen.insert(members.begin(), members.end());
        if (std::any_of(component.begin(), component.end(), [&](long key) { return reach.count(key) > 0; }))
            continue;
        for (long key : component) {
            auto it = cells.cells.find(key);
            FilmCell<D> cell;
            if (it != cells.cells.end()) {
                cell = it->second;
            } else {
                // Pockets are a few cells wide: the nearest image of the cell beside it is the film's.
                const Index<D> from = grid.cell_of_key(beside_key), to = grid.cell_of_key(key);
                Index<D> offset = beside->offset(beside->owner);
                for (int axis = 0; axis < D; ++axis)
                    if (grid.periodic(axis))
                        offset[axis] += grid.cells()[axis] *
                                        static_cast<int>(std::lround(double(from[axis] - to[axis]) / grid.cells()[axis]));
                cell.owner = beside->owner;
                cell.touches = {{beside->owner, 0, offset}};
            }
            cell.kind = CellKind::film;
            taken.emplace_back(key, cell);
        }
    }
    for (const auto& [key, cell] : taken)
        cells.cells[key] = cell;
    return !taken.empty();
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template class FaceCache<D>;                                                                                               \
    template std::array<CellSide<D>, 2 * D> sides_of<D>(const Grid<D>&, const Index<D>&);                                      \
    template bool in_film_gap<D>(const Grid<D>&, std::span<const Solid<D>>, const Film<D>&, const Vec<D>&);                    \
    template void cells_on_segment<D>(const Grid<D>&, const Vec<D>&, const Vec<D>&, std::vector<Index<D>>&);                   \
    template FilmCells<D> classify_cells<D>(const FaceCache<D>&, std::span<const Solid<D>>, std::span<const Film<D>>);         \
    template CellKind kind_of<D>(const FaceCache<D>&, const FilmCells<D>&, const Index<D>&);                                   \
    template double open_after_closing<D>(const FaceCache<D>&, const FilmCells<D>&, int, const Index<D>&);                     \
    template void close_faces<D>(const FaceCache<D>&, std::span<const Solid<D>>, std::span<const Film<D>>, FilmCells<D>&);     \
    template bool absorb_pockets<D>(const FaceCache<D>&, const std::vector<long>&, FilmCells<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
