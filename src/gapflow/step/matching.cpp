#include "gapflow/step/matching.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace gapflow {
namespace {

/// Middle of the open faces of each part, from its cell's middle, in cells of the core; and the sum of these faces' areas.
template <int D>
struct Middle {
    Vec<D> at = Vec<D>::Zero();
    double area = 0;
};
/// Of the parts that are `wanted`.
template <int D>
std::vector<Middle<D>> middles(const Grid<D>& grid, const Complex<D>& complex, const std::vector<char>& wanted)
{
    std::vector<Middle<D>> middle(complex.parts());
    for (const FacePiece<D>& piece : complex.pieces)
        for (const PartOrCell& side : {piece.low, piece.high})
            if (side.is_part() && wanted[side.number()] && piece.area > 0) {
                Middle<D>& of = middle[side.number()];
                Vec<D> way = piece.centroid;
                const Index<D> cell = complex.cell_of_part(side.number());
                for (int axis = 0; axis < D; ++axis) {
                    way[axis] -= (grid.centre_place(axis, cell[axis]) - grid.anchor()[axis]) / grid.dx();
                    if (const double period = grid.size()[axis] / grid.dx(); grid.periodic(axis))
                        way[axis] -= period * std::round(way[axis] / period);
                }
                of.at += piece.area * way;
                of.area += piece.area;
            }
    for (Middle<D>& of : middle)
        of.at /= of.area > 0 ? of.area : 1;
    return middle;
}

} // namespace

template <int D>
std::vector<MatchedPart> matched_parts(const Grid<D>& grid, const Complex<D>& own, const Complex<D>& other)
{
    std::vector<MatchedPart> matched(own.parts());
    std::vector<char> of_own(own.parts(), 0), of_other(other.parts(), 0);
    std::vector<int> several; // cells with more than one part
    for (int c = 0; c < own.cut_cells(); ++c) {
        const std::int32_t cell = other.cell[own.cut_cell[c]];
        const int first = own.first_part[c], end = own.first_part[c + 1];
        if (cell == Complex<D>::solid)
            continue;
        if (cell == Complex<D>::open) {
            matched[first].kind = MatchedPart::Kind::main;
            continue;
        }
        const int from = other.first_part[cell], to = other.first_part[cell + 1];
        if (end - first == 1 && to - from == 1) {
            matched[first] = {MatchedPart::Kind::main, from};
            continue;
        }
        several.push_back(c);
        std::fill(of_own.begin() + first, of_own.begin() + end, 1);
        std::fill(of_other.begin() + from, of_other.begin() + to, 1);
    }
    const std::vector<Middle<D>> here = middles(grid, own, of_own), there = middles(grid, other, of_other);
    std::vector<std::tuple<double, int, int>> pairs;
    for (const int c : several) {
        const int first = own.first_part[c], end = own.first_part[c + 1], cell = other.cell[own.cut_cell[c]],
                  from = other.first_part[cell], to = other.first_part[cell + 1];
        pairs.clear();
        for (int p = first; p < end; ++p)
            for (int q = from; q < to; ++q)
                pairs.emplace_back((here[p].at - there[q].at).squaredNorm(), p, q);
        std::sort(pairs.begin(), pairs.end());
        std::vector<char> taken(to - from, 0);
        for (const auto& [distance, p, q] : pairs)
            if (matched[p].kind == MatchedPart::Kind::none && !taken[q - from]) {
                matched[p] = q == from ? MatchedPart{MatchedPart::Kind::main, q} : MatchedPart{MatchedPart::Kind::other, q};
                taken[q - from] = 1;
            }
    }
    return matched;
}

template std::vector<MatchedPart> matched_parts<2>(const Grid<2>&, const Complex<2>&, const Complex<2>&);
template std::vector<MatchedPart> matched_parts<3>(const Grid<3>&, const Complex<3>&, const Complex<3>&);

} // namespace gapflow
