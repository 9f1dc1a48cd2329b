#include "gapflow/output/part_picture.hpp"

#include <algorithm>
#include <cmath>
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

/// The solid of a face: that on a closed side of the domain is the side's.
template <int D>
int wall_of(const Grid<D>& grid, const std::array<int, 2 * D>& sides, const PartFace<D>& face)
{
    if (face.solid != PartFace<D>::open)
        return face.solid;
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end) {
            const double place = (grid.face_place(axis, end ? grid.cells()[axis] : 0) - grid.anchor()[axis]) / grid.dx();
            if (sides[2 * axis + end] >= 0 &&
                std::all_of(face.points.begin(), face.points.end(), [&](const Vec<D>& x) { return x[axis] == place; }))
                return sides[2 * axis + end];
        }
    return PartFace<D>::open;
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
    std::vector<std::pair<int, double>> walls; // solid, area
    double all = 0; // sum of the sizes of the walls' area vectors
    Vec<D> sum = Vec<D>::Zero(), wall = Vec<D>::Zero();
    int last = PartFace<D>::open;
    for (const PartFace<D>& face : faces) {
        figures.volume += face.volume(faces[0].points[0]);
        const int solid = wall_of(grid, sides, face);
        if (D == 3 || solid != last) { // another wall; in 3D each is one face
            all += wall.norm();
            wall.setZero();
        }
        last = solid;
        if (solid < 0)
            continue;
        wall += face.area();
        sum += face.area();
        const auto known = std::find_if(walls.begin(), walls.end(), [&](const auto& w) { return w.first == solid; });
        if (known == walls.end())
            walls.emplace_back(solid, face.area().norm());
        else
            known->second += face.area().norm();
    }
    all += wall.norm();
    std::sort(walls.begin(), walls.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    figures.kind = walls.empty() ? PartFigures::Kind::whole : PartFigures::Kind::cut;
    figures.walls = static_cast<int>(walls.size());
    figures.first = walls.empty() ? -1 : walls[0].first;
    figures.second = walls.size() < 2 ? -1 : walls[1].first;
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
        const double thickness = figures.kind == PartFigures::Kind::thin ? figures.thickness * grid.dx()
                                                                         : std::numeric_limits<double>::quiet_NaN();
        const std::array<double, 8> values{static_cast<double>(figures.kind), static_cast<double>(part),
                                           static_cast<double>(parts), figures.volume / whole, thickness,
                                           static_cast<double>(figures.walls), static_cast<double>(figures.first),
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
                sides.push_back({0, PartFace<2>::open, {corners[k], corners[k + 1]}});
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
