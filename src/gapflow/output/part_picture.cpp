#include "gapflow/output/part_picture.hpp"

#include <algorithm>
#include <functional>
#include <limits>

namespace gapflow {
namespace {

/// Number of the solid that closes each side of the domain; -1: none.
template <int D>
std::array<int, 2 * D> closed_sides(const Grid<D>& grid, std::span<const Solid<D>> solids)
{
    std::array<int, 2 * D> result;
    result.fill(-1);
    int wall = 0;
    while (wall < static_cast<int>(solids.size()) && !solids[wall].wall)
        ++wall;
    for (int side = 0; side < 2 * D; ++side) // in this order (make_walls)
        if (grid.side(side / 2, side % 2) == SideKind::wall && wall < static_cast<int>(solids.size()))
            result[side] = wall++;
    return result;
}

/// The closed side of the domain on which an open face lies, 2 axis + end; -1: none.
template <int D>
int side_of(const Grid<D>& grid, const std::array<int, 2 * D>& sides, const PartFace<D>& face)
{
    for (int side = 0; side < 2 * D && face.solid == PartFace<D>::open; ++side) {
        const int axis = side / 2;
        const double place = (grid.face_place(axis, side % 2 ? grid.cells()[axis] : 0) - grid.anchor()[axis]) / grid.dx();
        if (sides[side] >= 0 &&
            std::all_of(face.points.begin(), face.points.end(), [&](const Vec<D>& x) { return x[axis] == place; }))
            return side;
    }
    return -1;
}

/// Appends a part's faces as a cell; points that are equal to round-off are one.
template <int D>
void add_cell(const Grid<D>& grid, std::span<const PartFace<D>> faces, VtkCells<D>& cells)
{
    constexpr double same = 1e-9; // round-off of places where borders meet
    const std::size_t first = cells.points.size();
    const auto point = [&](const Vec<D>& in_cells) {
        const Vec<D> x = grid.anchor() + grid.dx() * in_cells;
        for (std::size_t k = first; k < cells.points.size(); ++k)
            if ((cells.points[k] - x).norm() < same * grid.dx())
                return static_cast<std::int64_t>(k);
        cells.points.push_back(x);
        return static_cast<std::int64_t>(cells.points.size() - 1);
    };
    std::vector<std::vector<std::int64_t>> cell;
    const auto add = [&](std::vector<std::int64_t>& face, std::int64_t k) {
        if (face.empty() || face.back() != k)
            face.push_back(k);
    };
    if constexpr (D == 3)
        for (const PartFace<D>& from : faces) {
            std::vector<std::int64_t> face;
            for (const Vec<D>& x : from.points)
                add(face, point(x));
            while (face.size() > 1 && face.front() == face.back())
                face.pop_back();
            if (face.size() > 2)
                cell.push_back(face);
        }
    else {
        std::vector<std::vector<Vec<D>>> loops;
        for (std::size_t k = 0; k < faces.size(); ++k) {
            if (k == 0 || faces[k].points[0] != faces[k - 1].points[1])
                loops.emplace_back();
            loops.back().push_back(faces[k].points[0]);
        }
        std::vector<std::int64_t> outline;
        for (const Vec<D>& x : with_holes<D>(loops))
            add(outline, point(x));
        while (outline.size() > 1 && outline.front() == outline.back())
            outline.pop_back();
        cell.push_back(outline);
    }
    cells.cells.push_back(std::move(cell));
}

} // namespace

template <int D>
PartFigures part_figures(const Grid<D>& grid, std::span<const Solid<D>> solids, std::span<const PartFace<D>> faces)
{
    const std::array<int, 2 * D> sides = closed_sides(grid, solids);
    PartFigures figures;
    struct Wall {
        int number, solid; ///< number: PartFace::wall, or of a side of the domain
        Vec<D> area;
    };
    std::vector<Wall> walls;
    Vec<D> sum = Vec<D>::Zero();
    for (const PartFace<D>& face : faces) {
        figures.volume += face.volume(faces[0].points[0]);
        const int side = side_of(grid, sides, face), number = side >= 0 ? -1 - side : face.wall;
        if (face.wall < 0 && side < 0)
            continue;
        sum += face.area();
        const auto known = std::find_if(walls.begin(), walls.end(), [&](const Wall& wall) { return wall.number == number; });
        if (known == walls.end())
            walls.push_back({number, side >= 0 ? sides[side] : face.solid, face.area()});
        else
            known->area += face.area();
    }
    double all = 0;
    std::vector<std::pair<double, int>> of_solid; // size, solid
    for (const Wall& wall : walls) {
        const double size = wall.area.norm();
        all += size;
        const auto known =
            std::find_if(of_solid.begin(), of_solid.end(), [&](const auto& x) { return x.second == wall.solid; });
        if (known == of_solid.end())
            of_solid.emplace_back(size, wall.solid);
        else
            known->first += size;
    }
    std::sort(of_solid.begin(), of_solid.end(), std::greater<>());
    figures.kind = of_solid.empty() ? PartFigures::Kind::whole : PartFigures::Kind::cut;
    figures.walls = static_cast<int>(of_solid.size());
    figures.first = of_solid.empty() ? -1 : of_solid[0].second;
    figures.second = of_solid.size() < 2 ? -1 : of_solid[1].second;
    if (const double facing = 0.5 * (all - sum.norm()); facing > figures.volume) {
        figures.kind = PartFigures::Kind::thin;
        figures.thickness = figures.volume / facing;
    }
    return figures;
}

template <int D>
PartCounts write_parts(const std::filesystem::path& path, const Grid<D>& grid, std::span<const Solid<D>> solids,
                       const Complex<D>& complex, const PartBorders<D>& borders)
{
    VtkCells<D> cells;
    for (const char* name : {"kind", "part", "parts", "open", "thickness", "walls", "first_wall", "second_wall"})
        cells.cell_data.push_back({name, 1, {}});
    const auto add_data = [&](const PartFigures& figures, int part, int parts, double whole) {
        const double thickness =
            figures.kind == PartFigures::Kind::thin ? figures.thickness * grid.dx() : std::numeric_limits<double>::quiet_NaN();
        const std::array<double, 8> values{static_cast<double>(figures.kind),
                                           static_cast<double>(part),
                                           static_cast<double>(parts),
                                           figures.volume / whole,
                                           thickness,
                                           static_cast<double>(figures.walls),
                                           static_cast<double>(figures.first),
                                           static_cast<double>(figures.second)};
        for (std::size_t k = 0; k < values.size(); ++k)
            cells.cell_data[k].values.push_back(values[k]);
    };
    const auto box = [&](const Index<D>& c) {
        Vec<D> low, high;
        for (int axis = 0; axis < D; ++axis) {
            low[axis] = (grid.face_place(axis, c[axis]) - grid.anchor()[axis]) / grid.dx();
            high[axis] = (grid.face_place(axis, c[axis] + 1) - grid.anchor()[axis]) / grid.dx();
        }
        return std::pair{low, high};
    };
    PartCounts counts{complex.parts(), 0};
    const std::span<const PartFace<D>> all(borders);
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
        while (end < all.size() && all[end].part == all[begin].part)
            ++end;
        const int part = all[begin].part, cell = complex.part_cell[part];
        const auto faces = all.subspan(begin, end - begin);
        const auto [low, high] = box(complex.cell_of_part(part));
        const PartFigures figures = part_figures(grid, solids, faces);
        counts.thin += figures.kind == PartFigures::Kind::thin;
        add_cell(grid, faces, cells);
        add_data(figures, part - complex.first_part[cell], complex.first_part[cell + 1] - complex.first_part[cell],
                 (high - low).prod());
    }
    if constexpr (D == 2)
        for_each_index<2>(grid.low(), grid.high(), [&](const Index<2>& c) {
            if (complex.cell[complex.index(c)] != Complex<2>::open)
                return;
            const auto [low, high] = box(c);
            const std::array<Vec<2>, 5> corners{low, {high[0], low[1]}, high, {low[0], high[1]}, low};
            PartBorders<2> sides;
            for (int k = 0; k < 4; ++k)
                sides.push_back({0, PartFace<2>::open, -1, {corners[k], corners[k + 1]}});
            PartFigures figures;
            figures.volume = (high - low).prod();
            add_cell<2>(grid, sides, cells);
            add_data(figures, 0, 1, figures.volume);
        });
    write_vtu(path, cells);
    return counts;
}

template PartFigures part_figures(const Grid<2>&, std::span<const Solid<2>>, std::span<const PartFace<2>>);
template PartFigures part_figures(const Grid<3>&, std::span<const Solid<3>>, std::span<const PartFace<3>>);
template PartCounts write_parts(const std::filesystem::path&, const Grid<2>&, std::span<const Solid<2>>, const Complex<2>&,
                                const PartBorders<2>&);
template PartCounts write_parts(const std::filesystem::path&, const Grid<3>&, std::span<const Solid<3>>, const Complex<3>&,
                                const PartBorders<3>&);

} // namespace gapflow
