#include "gapflow/film/film_cells.hpp"

#include "gapflow/core/sharing.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/film/cell_states.hpp"
#include "gapflow/grid/cell_marks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gapflow {

namespace {

// In dx: points this close to a plane of the grid count as on it, as for fractions.
constexpr double beside_plane = 1e-6;

// Sum of open fractions below which a mixed cell's faces to other mixed cells are reopened.
constexpr double strangled_aperture = 0.25;

constexpr long cells_a_chunk = 256; // of a thread's work

// Largest grid component that a film absorbs.
template <int D>
constexpr int pocket_cells = D == 2 ? 9 : 27;

} // namespace

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
FilmGaps<D>::FilmGaps(const Grid<D>& grid, std::span<const Solid<D>> solids, std::span<const Film<D>> films)
    : solids_(solids), films_(films)
{
    others_.reserve(films.size());
    for (const Film<D>& film : films)
        others_.push_back(other_shape(grid, solids, film.pair));
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
            const double plane = grid.face_place(axis, k);
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

/// Representative points of the open faces of a cell.
template <int D>
struct OpenPoints {
    std::array<Vec<D>, 2 * D> points;
    int size = 0;
    const Vec<D>* begin() const { return points.data(); }
    const Vec<D>* end() const { return points.data() + size; }
};

template <int D>
struct Classifier {
    const FaceCache<D>& faces;
    const FilmGaps<D>& gaps;
    const Grid<D>& grid;
    FilmCells<D>& result;

    // Of a cell of the domain, slightly inside it: where a film ends on a plane of the grid the round-off of its bodies' positions must
    // not decide which cells are film.
    OpenPoints<D> open_points(const Index<D>& cell) const
    {
        OpenPoints<D> open;
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end)
                if (const Index<D> face = cell + end * step<D>(axis); faces.open(axis, face) > negligible_opening)
                    open.points[open.size++] =
                        faces.open_point(axis, face) + (1 - 2 * end) * beside_plane * grid.dx() * unit<D>(axis);
        return open;
    }

    bool holds(const Touch<D>& touch, const Vec<D>& x) const
    {
        return gaps.holds(touch.film, x + grid.dx() * touch.offset.template cast<double>());
    }

    bool holds(const Touch<D>& touch, const OpenPoints<D>& points) const
    {
        return std::all_of(points.begin(), points.end(), [&](const Vec<D>& x) { return holds(touch, x); });
    }

    // Is a cell without any opening more than the inside of one solid?
    bool is_closed_surface(const Index<D>& cell) const
    {
        for (int side = 0; side < 2 * D; ++side)
            if (faces.open(side / 2, cell + (side % 2) * step<D>(side / 2)) > negligible_opening)
                return false;
        for (int side = 0; side < 2 * D; ++side)
            if (faces.parts(side / 2, cell + (side % 2) * step<D>(side / 2)).empty())
                return false;
        return true;
    }

    // Do both solids of a pair meet in a closed cell, so that neither's flux out of it vanishes?
    bool is_orphan(const Index<D>& cell, const FilmPair<D>& pair) const
    {
        std::optional<Vec<D>> master, other; // area of their parts of the faces
        for (int side = 0; side < 2 * D; ++side) {
            for (const SolidPart<D>& part : faces.parts(side / 2, cell + (side % 2) * step<D>(side / 2)))
                for (auto [solid, area] : {std::pair(pair.master, &master), std::pair(pair.other, &other)})
                    if (part.solid == solid)
                        *area = area->value_or(Vec<D>::Zero()) + (2 * (side % 2) - 1) * part.fraction * unit<D>(side / 2);
        }
        return master && other && master->norm() > 1e-12 && other->norm() > 1e-12;
    }

    // The cells that the gap segments of a film's points pass through.
    KeyMap<Touch<D>> touches_of(int k) const
    {
        KeyMap<Touch<D>> touches;
        std::vector<Index<D>> passed;
        for (const FilmPoint<D>& point : gaps.films()[k].mesh.points) {
            cells_on_segment<D>(grid, point.x, point.y, passed);
            const Index<D> last = grid.cell_of(point.y + 1e-9 * grid.dx() * point.other_normal);
            if (std::find(passed.begin(), passed.end(), last) == passed.end())
                passed.push_back(last);
            for (const Index<D>& c : passed) {
                const Index<D> w = grid.wrapped(c);
                if (grid.in_domain(w))
                    touches.insert(grid.key(w), Touch<D>{k, 0, c - w}).first.measure += point.weight;
            }
        }
        return touches;
    }

    void count_touches()
    {
        const int n = static_cast<int>(gaps.films().size());
        std::vector<std::vector<std::pair<long, Touch<D>>>> touches(n);
        for_each_job(n, [&](int k) {
            if (gaps.films()[k].here) {
                const KeyMap<Touch<D>> of_film = touches_of(k);
                touches[k].assign(of_film.begin(), of_film.end());
            }
        });
        exchange_items(
            grid.comm(), touches.size(), [&](std::size_t k) { return gaps.films()[k].here; },
            [&](ByteWriter& out, std::size_t k) { out(touches[k]); }, [&](ByteReader& in, std::size_t k) { in(touches[k]); });
        for (const auto& of_film : touches)
            for (const auto& [key, touch] : of_film)
                result.cells[key].touches.push_back(touch);
        result.cells.sort();
        for_each_part(static_cast<long>(result.cells.size()), [&](long begin, long end) {
            for (long i = begin; i < end; ++i) {
                auto& touches_of_cell = result.cells.item(static_cast<int>(i)).second.touches;
                std::stable_sort(touches_of_cell.begin(), touches_of_cell.end(), [](const Touch<D>& a, const Touch<D>& b) {
                    return static_cast<float>(a.measure) > static_cast<float>(b.measure);
                });
            }
        });
    }

    void set_kind(long key, FilmCell<D>& cell) const
    {
        const OpenPoints<D> points = open_points(grid.cell_of_key(key));
        cell.owner = cell.touches[0].film;
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

    // Kinds of all touched cells, each found by the rank that has it.
    void set_kinds()
    {
        const auto chunks = each_chunk(static_cast<long>(result.cells.size()), cells_a_chunk, [&](long begin, long end) {
            NumberedItems<std::pair<CellKind, int>> found;
            for (long i = begin; i < end; ++i) {
                auto& [key, cell] = result.cells.item(static_cast<int>(i));
                if (!grid.owns(grid.cell_of_key(key)))
                    continue;
                set_kind(key, cell);
                found.push_back({i, {cell.kind, cell.owner}});
            }
            return found;
        });
        for (const auto& [i, found] : all_items(grid.comm(), chunks)) {
            FilmCell<D>& cell = result.cells.item(static_cast<int>(i)).second;
            std::tie(cell.kind, cell.owner) = found;
        }
    }

    /// A cell, and the film that takes it.
    struct Taking {
        long key;
        Touch<D> touch;
    };
    using Taken = NumberedItems<Taking>; // by what found it

    // Makes the cells listed film, in the order of what found them; the first to take one has it. Each rank lists its own cells.
    void add_film_cells(const std::vector<Taken>& chunks)
    {
        for (const auto& [i, taking] : all_items(grid.comm(), chunks)) {
            FilmCell<D> cell;
            cell.kind = CellKind::film;
            cell.owner = taking.touch.film;
            cell.touches.push_back({taking.touch.film, 0, taking.touch.offset});
            result.cells.insert(taking.key, cell);
        }
    }

    // Calls f(neighbour's key, touch of `cell` by `film` seen from there) for a cell of the domain displaced by d.
    template <class F>
    void seen_from(const Index<D>& from, const FilmCell<D>& cell, int film, const Index<D>& d, F&& f) const
    {
        const Index<D> c = from + d, w = grid.wrapped(c);
        if (grid.in_domain(w))
            f(w, Touch<D>{film, 0, cell.offset(film) + c - w});
    }

    // Bulk cells beside film cells that lie wholly in the same gap.
    void take_neighbours()
    {
        const auto take = [&](int i, Taken& taken) {
            const auto& [key, cell] = result.cells.item(i);
            if (cell.kind != CellKind::film)
                return;
            for (int side = 0; side < 2 * D; ++side)
                seen_from(grid.cell_of_key(key), cell, cell.owner, (side % 2 ? 1 : -1) * step<D>(side / 2),
                          [&](const Index<D>& beyond, const Touch<D>& touch) {
                              if (!grid.owns(beyond) || result.cells.contains(grid.key(beyond)))
                                  return;
                              const OpenPoints<D> points = open_points(beyond);
                              if (points.size > 0 && holds(touch, points))
                                  taken.push_back({i, {grid.key(beyond), touch}});
                          });
        };
        add_film_cells(each_chunk(static_cast<long>(result.cells.size()), cells_a_chunk, [&](long begin, long end) {
            Taken taken;
            for (long i = begin; i < end; ++i)
                take(static_cast<int>(i), taken);
            return taken;
        }));
    }

    // Of this rank's cells and two around them, those within two cells of one that a film's points touch, along every axis; places are not wrapped.
    CellMarks<D> near_touched() const
    {
        CellMarks<D> marks(grid.low() - Index<D>::Constant(2), grid.high() + Index<D>::Constant(2));
        for (const auto& [key, cell] : result.cells)
            if (cell.touches[0].measure > 0)
                marks.set_images(grid, grid.cell_of_key(key));
        for (int axis = 0; axis < D; ++axis)
            marks.spread(axis, 2);
        return marks;
    }

    // Closed cells with a body flux that no film touches (contact surfaces on a grid plane), up to two cells from one. Each goes to the film of the
    // first cell that reaches it.
    void take_orphans()
    {
        const CellMarks<D> near = near_touched();
        add_film_cells(each_plane(grid.low()[D - 1], grid.high()[D - 1], [&](int plane) {
            Taken taken;
            for_each_row_of_plane<D>(grid.low(), grid.high(), plane, [&](Index<D> cell) {
                for (; cell[0] < grid.high()[0]; ++cell[0])
                    if (near(cell) && is_closed_surface(cell) && !result.cells.contains(grid.key(cell)))
                        if (const std::optional<Touch<D>> touch = first_taker(cell))
                            taken.push_back({grid.key(cell), {grid.key(cell), *touch}});
            });
            return taken;
        }));
    }

    // The touch, seen from a closed cell, of the first cell within two steps whose film's solids both meet in it.
    std::optional<Touch<D>> first_taker(const Index<D>& closed) const
    {
        int first = -1;
        std::optional<Touch<D>> taker;
        for_each_index<D>(Index<D>::Constant(-2), Index<D>::Constant(3), [&](const Index<D>& d) {
            const Index<D> from = grid.wrapped(Index<D>(closed - d));
            const int i = grid.in_domain(from) ? result.cells.index(grid.key(from)) : -1;
            if (i < 0 || (first >= 0 && i >= first))
                return;
            const FilmCell<D>& cell = result.cells.item(i).second;
            const int film = cell.touches[0].film;
            if (cell.touches[0].measure == 0 || !is_orphan(closed, gaps.films()[film].pair))
                return;
            first = i;
            seen_from(from, cell, film, d, [&](const Index<D>&, const Touch<D>& touch) { taker = touch; });
        });
        return taker;
    }
};

} // namespace

template <int D>
FilmCells<D> classify_cells(const FaceCache<D>& faces, const FilmGaps<D>& gaps)
{
    FilmCells<D> result;
    Classifier<D> classifier{faces, gaps, faces.grid(), result};
    classifier.count_touches();
    classifier.set_kinds();
    classifier.take_neighbours();
    classifier.take_orphans();
    result.cells.sort();
    return result;
}

namespace {

// A mixed cell whose faces to other mixed cells were closed may be left with a sliver of an opening, through which all fluid that its
// film does not take would be forced: those faces are reopened.
template <int D>
void reopen_strangled(const FaceCache<D>& faces, FilmCells<D>& cells)
{
    const Grid<D>& grid = faces.grid();
    auto is_mixed = [&](long key) { return cells.kind(key, CellKind::bulk) == CellKind::mixed; };
    const auto found = items_of<long>(static_cast<long>(cells.cells.size()), [&](long i, std::vector<long>& strangled) {
        const auto& [key, cell] = cells.cells.item(static_cast<int>(i));
        if (cell.kind != CellKind::mixed || !grid.owns(grid.cell_of_key(key)))
            return;
        const auto sides = sides_of(grid, grid.cell_of_key(key));
        double aperture = 0;
        for (const CellSide<D>& side : sides)
            aperture += open_after_closing(faces, cells, side.axis, side.face);
        if (aperture >= strangled_aperture)
            return;
        for (const CellSide<D>& side : sides) {
            const long face = faces.key(side.axis, side.face);
            if (side.inside && cells.closed.contains(face) && is_mixed(grid.key(grid.wrapped(side.cell))))
                strangled.push_back(face);
        }
    });
    KeyMap<char> reopened;
    for (long face : all_values(grid.comm(), found))
        reopened.insert(face);
    if (reopened.empty())
        return;
    KeyMap<int> still_closed;
    still_closed.reserve(cells.closed.size());
    for (const auto& [face, film] : cells.closed)
        if (!reopened.contains(face))
            still_closed.insert(face, film);
    cells.closed = std::move(still_closed);
}

} // namespace

template <int D>
void close_faces(const FaceCache<D>& faces, const FilmGaps<D>& gaps, FilmCells<D>& cells)
{
    const Grid<D>& grid = faces.grid();
    cells.closed.clear();
    auto holds = [&](const FilmCell<D>& cell, int film, const Vec<D>& x) {
        return gaps.holds(film, x + grid.dx() * cell.offset(film).template cast<double>());
    };
    using Closed = NumberedItems<std::pair<long, int>>; // by the cell: face, film
    const auto close = [&](long i, Closed& closed) {
        const auto& [key, cell] = cells.cells.item(static_cast<int>(i));
        if (!grid.owns(grid.cell_of_key(key)))
            return;
        for (const CellSide<D>& side : sides_of(grid, grid.cell_of_key(key))) {
            if (!side.inside || faces.open(side.axis, side.face) <= 0)
                continue;
            const FilmCell<D>* other = cells.cells.find(grid.key(grid.wrapped(side.cell)));
            if (other && side.end == 1) // visited from the other cell too
                continue;
            const bool film = cell.kind == CellKind::film, other_film = other && other->kind == CellKind::film;
            int owner = -1;
            if (film && other_film && cell.owner != other->owner) {
                const Vec<D> x = faces.open_point(side.axis, side.face);
                const bool own = holds(cell, cell.owner, x),
                           others = holds(*other, other->owner, x - faces.displacement(side.cell));
                const float here = cell.touched_by(cell.owner), there = other->touched_by(other->owner);
                const bool first = own != others ? own : here != there ? here > there : cell.owner < other->owner;
                owner = first ? cell.owner : other->owner;
            } else if (film) {
                owner = cell.owner;
            } else if (other_film) {
                owner = other->owner;
            } else if (other && cell.kind == CellKind::mixed && other->kind == CellKind::mixed) {
                const Vec<D> x = faces.open_point(side.axis, side.face);
                float most = 0;
                for (const Touch<D>& touch :
                     cell.touches) { // the common film that touches both most and whose gap holds the face
                    const bool common = std::any_of(other->touches.begin(), other->touches.end(),
                                                    [&](const Touch<D>& t) { return t.film == touch.film; });
                    const float both = cell.touched_by(touch.film) + other->touched_by(touch.film);
                    const bool first = owner < 0 || both > most || (both == most && touch.film < owner);
                    if (common && first && holds(cell, touch.film, x)) {
                        owner = touch.film;
                        most = both;
                    }
                }
            }
            if (owner >= 0)
                closed.push_back({i, {faces.key(side.axis, side.face), owner}});
        }
    };
    const auto chunks = each_chunk(static_cast<long>(cells.cells.size()), cells_a_chunk, [&](long begin, long end) {
        Closed closed;
        for (long i = begin; i < end; ++i)
            close(i, closed);
        return closed;
    });
    const auto all = all_items(grid.comm(), chunks);
    cells.closed.reserve(all.size());
    for (const auto& [i, closed] : all)
        cells.closed.insert(closed.first, closed.second);
    reopen_strangled(faces, cells);
}

namespace {

// Finds small components of open cells that no mouth reaches.
template <int D>
class PocketFinder {
public:
    PocketFinder(const CellStates<D>& states, const KeyMap<char>& reached)
        : grid_(states.grid()), states_(states), reached_(reached)
    {
    }

    /// Lists the cells of the pocket of `seed`, one of this rank's cells, unless that is known.
    void visit(long seed, long beside, NumberedItems<long>& pockets)
    {
        if (!grid_.owns(grid_.cell_of_key(seed)) || done_.contains(seed) || large_.contains(seed))
            return;
        component_.assign(1, seed);
        bool small = true;
        for (std::size_t i = 0; i < component_.size() && small; ++i) {
            const Index<D> c = grid_.cell_of_key(component_[i]);
            const auto state = states_(c);
            small = !state.leads_out; // an open side of the domain: not a pocket
            for (int side = 0; side < 2 * D && small; ++side) {
                if (!(state.open >> side & 1))
                    continue;
                const long beyond = grid_.key(grid_.wrapped(Index<D>(c + (side % 2 ? 1 : -1) * step<D>(side / 2))));
                if (std::find(component_.begin(), component_.end(), beyond) == component_.end())
                    component_.push_back(beyond);
                small = !large_.contains(beyond);
            }
            small = small && static_cast<int>(component_.size()) <= pocket_cells<D>;
        }
        for (long key : component_)
            (small ? done_ : large_).insert(key);
        if (small && std::none_of(component_.begin(), component_.end(), [&](long key) { return reached_.contains(key); }))
            for (long key : component_)
                pockets.emplace_back(beside, key);
    }

private:
    const Grid<D>& grid_;
    const CellStates<D>& states_;
    const KeyMap<char>& reached_;
    KeyMap<char> done_, large_; ///< cells of components already visited; of those that are not pockets
    std::vector<long> component_;
};

} // namespace

template <int D>
std::vector<long> absorb_pockets(const FaceCache<D>& faces, const CellStates<D>& states, const std::vector<long>& reached,
                                 FilmCells<D>& cells)
{
    const Grid<D>& grid = faces.grid();
    KeyMap<char> reach;
    for (long key : reached)
        reach.insert(key);
    // Seeds: mixed cells, and unclassified cells beside film or mixed ones. Each rank begins in its own, each thread in a part of them; several
    // may find the same pocket. Numbered by the cell whose film takes them.
    const long count = static_cast<long>(cells.cells.size()), threads = thread_count();
    const auto pockets = each_chunk(count, std::max(1L, (count + threads - 1) / threads), [&](long begin, long end) {
        PocketFinder<D> finder(states, reach);
        NumberedItems<long> found;
        for (long i = begin; i < end; ++i) {
            const auto& [key, cell] = cells.cells.item(static_cast<int>(i));
            if (cell.kind == CellKind::mixed)
                finder.visit(key, i, found);
            for (const CellSide<D>& side : sides_of(grid, grid.cell_of_key(key)))
                if (const Index<D> beyond = grid.wrapped(side.cell); side.inside && grid.owns(beyond) &&
                                                                     !cells.cells.contains(grid.key(beyond)) &&
                                                                     faces.open(side.axis, side.face) > negligible_opening)
                    finder.visit(grid.key(beyond), i, found);
        }
        return found;
    });
    KeyMap<FilmCell<D>> taken;
    for (const auto& [i, key] : all_items(grid.comm(), pockets)) {
        if (taken.contains(key))
            continue;
        FilmCell<D> cell;
        if (const FilmCell<D>* known = cells.cells.find(key)) {
            cell = *known;
        } else {
            // Pockets are a few cells wide: the nearest image of the cell beside it is the film's.
            const auto& [beside_key, beside] = cells.cells.item(static_cast<int>(i));
            const Index<D> from = grid.cell_of_key(beside_key), to = grid.cell_of_key(key);
            Index<D> offset = beside.offset(beside.owner);
            for (int axis = 0; axis < D; ++axis)
                if (grid.periodic(axis))
                    offset[axis] +=
                        grid.cells()[axis] * static_cast<int>(std::lround(double(from[axis] - to[axis]) / grid.cells()[axis]));
            cell.owner = beside.owner;
            cell.touches.push_back({beside.owner, 0, offset});
        }
        cell.kind = CellKind::film;
        taken.insert(key, cell);
    }
    std::vector<long> changed;
    for (const auto& [key, cell] : taken) {
        cells.cells[key] = cell;
        changed.push_back(key);
    }
    if (!taken.empty())
        cells.cells.sort();
    return changed;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template class FilmGaps<D>;                                                                                                \
    template std::array<CellSide<D>, 2 * D> sides_of<D>(const Grid<D>&, const Index<D>&);                                      \
    template void cells_on_segment<D>(const Grid<D>&, const Vec<D>&, const Vec<D>&, std::vector<Index<D>>&);                   \
    template FilmCells<D> classify_cells<D>(const FaceCache<D>&, const FilmGaps<D>&);                                          \
    template void close_faces<D>(const FaceCache<D>&, const FilmGaps<D>&, FilmCells<D>&);                                      \
    template std::vector<long> absorb_pockets<D>(const FaceCache<D>&, const CellStates<D>&, const std::vector<long>&,          \
                                                 FilmCells<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
