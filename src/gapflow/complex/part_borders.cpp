#include "gapflow/complex/part_borders.hpp"

#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace gapflow {

template <>
Vec<2> PartFace<2>::area() const
{
    const Vec<2> way = points[1] - points[0];
    return {way[1], -way[0]};
}

template <>
Vec<3> PartFace<3>::area() const
{
    Vec<3> sum = Vec<3>::Zero();
    for (std::size_t k = 1; k + 1 < points.size(); ++k)
        sum += 0.5 * (points[k] - points[0]).cross(points[k + 1] - points[0]);
    return sum;
}

template <>
double PartFace<2>::volume(const Vec<2>& about) const
{
    return 0.5 * area().dot(points[0] - about);
}

template <>
double PartFace<3>::volume(const Vec<3>& about) const
{
    Vec<3> middle = Vec<3>::Zero();
    for (const Vec<3>& x : points)
        middle += x / static_cast<double>(points.size());
    double sum = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
        sum += (points[k] - about).cross(points[(k + 1) % points.size()] - about).dot(middle - about) / 6;
    return sum;
}

template <int D>
std::vector<Vec<D>> with_holes(const std::vector<std::vector<Vec<D>>>& loops)
{
    std::vector<Vec<D>> outline = loops[0];
    for (std::size_t h = 1; h < loops.size(); ++h) {
        const std::vector<Vec<D>>& hole = loops[h];
        std::size_t a = 0, b = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < outline.size(); ++i)
            for (std::size_t j = 0; j < hole.size(); ++j)
                if (const double far = (outline[i] - hole[j]).squaredNorm(); far < least) {
                    least = far;
                    a = i;
                    b = j;
                }
        std::vector<Vec<D>> way(hole);
        std::rotate(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(b), way.end());
        way.push_back(way.front());
        way.push_back(outline[a]);
        outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(a) + 1, way.begin(), way.end());
    }
    return outline;
}

namespace {

/// As PartFace::solid.
template <int D>
std::int32_t kind_of(const BorderChord& chord, const std::vector<PlacedSolid<D>>& solids)
{
    return chord.solid < 0 ? PartFace<D>::open : chord.fin >= 0 ? PartFace<D>::dividing : solids[chord.solid].solid;
}

/// Loops of a piece of a face; `of`: the chords of the first one from its points.
void find_loops(std::span<const BorderChord> chords, int piece, std::vector<std::vector<Vec<2>>>& loops,
                std::vector<const BorderChord*>& of)
{
    loops.clear();
    of.clear();
    std::vector<const BorderChord*> all;
    Vec<2> last = Vec<2>::Constant(std::numeric_limits<double>::quiet_NaN());
    for (const BorderChord& chord : chords) {
        if (chord.piece != piece)
            continue;
        if (chord.from != last)
            loops.emplace_back();
        last = chord.to;
        if (chord.from == chord.to)
            continue;
        loops.back().push_back(chord.from);
        all.push_back(&chord);
    }
    std::size_t before = 0;
    for (const std::vector<Vec<2>>& loop : loops) {
        if (loop.size() >= 3 && of.empty())
            of.assign(all.begin() + static_cast<std::ptrdiff_t>(before),
                      all.begin() + static_cast<std::ptrdiff_t>(before + loop.size()));
        before += loop.size();
    }
    std::erase_if(loops, [](const auto& loop) { return loop.size() < 3; });
}

/// A chord of a wall on a face of a cell, with the face outside at its right: as the wall's polygon has it.
struct WallChord {
    Vec<3> from, to;
    std::int32_t solid;       ///< as PartFace::solid
    std::int32_t image, edge; ///< edge of the dividing plane, or -1
};

/// Polygons of walls and dividing planes from their borders: loops, each divided where what borders it changes.
void close_walls(std::vector<WallChord> chords, std::int32_t part, const std::vector<PlacedSolid<3>>& solids,
                 const GridPlanes<3>& planes, PartBorders<3>& result)
{
    const auto same = [&](const WallChord& a, const WallChord& b) {
        return solids[a.image].solid == solids[b.image].solid && a.edge == b.edge;
    };
    int walls = 0;
    const auto add_wall = [&](const WallChord& of, const std::vector<Vec<3>>& points) {
        const std::int32_t wall = of.edge < 0 ? walls++ : -1;
        Vec<3> middle = Vec<3>::Zero();
        for (const Vec<3>& x : points)
            middle += x / static_cast<double>(points.size());
        // The wall's own surface. In a periodic domain's last cell the chords lie a period from their image.
        const auto on = solids[of.image].shape.closest(planes.in_world(middle));
        const Vec<3> moved = on.distance / planes.dx * on.normal;
        if (wall < 0 || points.size() < 4 || moved.norm() > 1 || moved.norm() < parameters.joint_distance) {
            result.push_back({part, of.solid, wall, points});
            return;
        }
        for (std::size_t k = 0; k < points.size(); ++k)
            result.push_back({part, of.solid, wall, {points[k], points[(k + 1) % points.size()], Vec<3>(middle - moved)}});
    };
    while (!chords.empty()) {
        std::vector<WallChord> loop{chords.back()};
        chords.pop_back();
        while (!chords.empty()) {
            std::size_t next = 0;
            for (std::size_t k = 1; k < chords.size(); ++k)
                if ((chords[k].from - loop.back().to).squaredNorm() < (chords[next].from - loop.back().to).squaredNorm())
                    next = k;
            if ((loop[0].from - loop.back().to).squaredNorm() <= (chords[next].from - loop.back().to).squaredNorm())
                break;
            loop.push_back(chords[next]);
            chords.erase(chords.begin() + static_cast<std::ptrdiff_t>(next));
        }
        const std::size_t n = loop.size();
        std::vector<std::size_t> changes; // where another wall begins
        Vec<3> middle = Vec<3>::Zero();
        for (std::size_t k = 0; k < n; ++k)
            if (!same(loop[k], loop[(k + n - 1) % n])) {
                changes.push_back(k);
                middle += loop[k].from;
            }
        if (changes.empty()) {
            std::vector<Vec<3>> points;
            for (const WallChord& chord : loop)
                points.push_back(chord.from);
            add_wall(loop[0], points);
            continue;
        }
        middle /= static_cast<double>(changes.size());
        for (std::size_t c = 0; c < changes.size(); ++c) {
            const std::size_t begin = changes[c], end = c + 1 < changes.size() ? changes[c + 1] : changes[0] + n;
            std::vector<Vec<3>> points;
            for (std::size_t k = begin; k <= end; ++k)
                points.push_back(loop[k % n].from);
            if (changes.size() > 2)
                points.push_back(middle);
            add_wall(loop[begin], points);
        }
    }
}

} // namespace

template <>
PartBorders<2> part_borders(const Grid<2>&, const GridPlanes<2>& planes, const Complex<2>& complex,
                            const std::vector<PlacedSolid<2>>& solids, const CutFaces<2>& cut,
                            const std::vector<std::vector<std::array<PartOrCell, 2>>>& parts_beside)
{
    FaceArcs<2> retrace(cut, planes, complex.index, solids, true);
    std::vector<PartBorders<2>> of_part(complex.parts());
    int walls = 0; // of the part
    for (std::size_t s = 0; s < cut.slabs.size(); ++s)
        for (const CutFace<2>& face : cut.slabs[s].faces) {
            if (face.state == CutFace<2>::State::dead || face.pieces == 0)
                continue;
            retrace.of(cut.slabs[s], face);
            for (const BorderChord& chord : retrace.chords())
                if (const PartOrCell part = parts_beside[s][face.piece + chord.piece][0];
                    part.exists() && chord.from != chord.to) {
                    PartBorders<2>& sides = of_part[part.number()];
                    const std::int32_t solid = kind_of(chord, solids), last = sides.empty() ? -1 : sides.back().wall;
                    const bool goes_on = !sides.empty() && sides.back().solid == solid && sides.back().points[1] == chord.from;
                    walls = sides.empty() ? 0 : walls;
                    sides.push_back({part.number(), solid, solid < 0 ? -1 : goes_on ? last : walls++, {chord.from, chord.to}});
                }
        }
    PartBorders<2> result;
    for (const PartBorders<2>& sides : of_part)
        result.insert(result.end(), sides.begin(), sides.end());
    return result;
}

template <>
PartBorders<3> part_borders(const Grid<3>&, const GridPlanes<3>& planes, const Complex<3>& complex,
                            const std::vector<PlacedSolid<3>>& solids, const CutFaces<3>& cut,
                            const std::vector<std::vector<std::array<PartOrCell, 2>>>& parts_beside)
{
    FaceArcs<3> retrace(cut, planes, complex.index, solids, true);
    std::vector<PartBorders<3>> of_part(complex.parts());
    std::vector<std::vector<WallChord>> walls(complex.parts());
    const auto in_space = [](int d, double at, const Vec<2>& x) {
        Vec<3> y;
        y[d] = at;
        y[u_axis<3>(d)] = x[0];
        y[v_axis<3>(d)] = x[1];
        return y;
    };
    std::vector<std::vector<Vec<2>>> loops;
    std::vector<const BorderChord*> loop_chords;
    // Place of a face, as the cell on its side 0 (below) or 1 has it.
    const auto place = [&](int d, int plane, int side) {
        return planes
            .place[d][side == 0 && plane == complex.index.low[d] && complex.index.wraps[d] ? complex.index.high()[d] : plane];
    };
    for (std::size_t s = 0; s < cut.slabs.size(); ++s)
        for (const CutFace<3>& face : cut.slabs[s].faces) {
            if (face.state == CutFace<3>::State::dead || face.pieces == 0)
                continue;
            const int d = face.axis;
            retrace.of(cut.slabs[s], face);
            const std::span<const BorderChord> chords = retrace.chords();
            for (int piece = 0; piece < face.pieces; ++piece) {
                find_loops(chords, piece, loops, loop_chords);
                for (int side = 0; side < 2; ++side) {
                    const PartOrCell part = parts_beside[s][face.piece + piece][side];
                    if (!part.exists())
                        continue;
                    const double at = place(d, complex.index.index(face.id)[d], side);
                    for (const BorderChord& chord : chords) {
                        if (chord.piece != piece || chord.from == chord.to || chord.solid < 0 ||
                            (chord.fin >= 0 && !(retrace.line(chord.fin).sides >> side & 1)))
                            continue;
                        const Vec<3> from = in_space(d, at, chord.from), to = in_space(d, at, chord.to);
                        const int edge = chord.fin >= 0 ? retrace.line(chord.fin).edge : -1;
                        walls[part.number()].push_back(
                            {side == 0 ? to : from, side == 0 ? from : to, kind_of(chord, solids), chord.solid, edge});
                    }
                    if (loops.empty())
                        continue;
                    PartFace<3> polygon{part.number(), PartFace<3>::open, -1, {}};
                    const std::vector<Vec<2>> joined = loops.size() > 1 ? with_holes<2>(loops) : std::vector<Vec<2>>();
                    const std::vector<Vec<2>>& outline = loops.size() > 1 ? joined : loops[0];
                    polygon.points.reserve(outline.size());
                    polygon.sides.reserve(outline.size());
                    for (std::size_t k = 0; k < outline.size(); ++k) {
                        const Vec<2>&from = outline[k], &to = outline[k + 1 < outline.size() ? k + 1 : 0];
                        polygon.points.push_back(in_space(d, at, from));
                        polygon.sides.push_back(PartFace<3>::dividing);
                        if (loops.size() == 1 && loop_chords[k]->to == to) {
                            polygon.sides.back() = kind_of(*loop_chords[k], solids);
                            continue;
                        }
                        for (const BorderChord& chord : chords)
                            if (chord.piece == piece && chord.from == from && chord.to == to)
                                polygon.sides.back() = kind_of(chord, solids);
                    }
                    if (side == 1) {
                        std::reverse(polygon.points.begin(), polygon.points.end());
                        std::reverse(polygon.sides.begin(), polygon.sides.end() - 1);
                    }
                    of_part[part.number()].push_back(std::move(polygon));
                }
            }
        }
    // Wholly open faces of cut cells.
    std::map<std::pair<int, int>, const FacePiece<3>*> astray;
    for (const FacePiece<3>& piece : complex.pieces)
        if (cut.face[piece.axis][piece.face] == Complex<3>::open)
            astray[{piece.axis, piece.face}] = &piece;
    for (int c = 0; c < complex.cut_cells(); ++c)
        for (int q = 0; q < 6; ++q) {
            const int d = q / 2, side = 1 - q % 2;
            Index<3> f = complex.index.index(complex.cut_cell[c]);
            if (q % 2)
                f = complex.index.wraps[d] ? complex.index.wrapped(f + step<3>(d)) : Index<3>(f + step<3>(d));
            const int id = complex.index(f);
            if (cut.face[d][id] != Complex<3>::open)
                continue;
            int part = complex.first_part[c];
            if (const auto other = astray.find({d, id}); other != astray.end())
                part = (side == 1 ? other->second->high : other->second->low).number();
            const int u = u_axis<3>(d), v = v_axis<3>(d);
            PartFace<3> square{part, PartFace<3>::open, -1, {}, std::vector<std::int32_t>(4, PartFace<3>::open)};
            for (const auto& [du, dv] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
                square.points.push_back(
                    in_space(d, place(d, f[d], side), {planes.place[u][f[u] + du], planes.place[v][f[v] + dv]}));
            if (side == 1)
                std::reverse(square.points.begin(), square.points.end());
            of_part[part].push_back(std::move(square));
        }
    PartBorders<3> result;
    for (int part = 0; part < complex.parts(); ++part) {
        std::move(of_part[part].begin(), of_part[part].end(), std::back_inserter(result));
        close_walls(std::move(walls[part]), part, solids, planes, result);
    }
    return result;
}

template std::vector<Vec<2>> with_holes(const std::vector<std::vector<Vec<2>>>&);
template std::vector<Vec<3>> with_holes(const std::vector<std::vector<Vec<3>>>&);
template struct PartFace<2>;
template struct PartFace<3>;

} // namespace gapflow
