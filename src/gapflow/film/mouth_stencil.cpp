#include "gapflow/film/mouth_stencil.hpp"

#include <algorithm>
#include <array>

namespace gapflow {

namespace {

constexpr double full_aperture = 0.25;  // a cell counts in full for a mouth if its open fractions sum to this
constexpr double minimum_weight = 0.02; // of a stencil: below, there is none

// Corners of the stencil joined to `start` through open faces between corners.
template <int D>
unsigned connected_corners(const CellStates<D>& states, const std::array<Index<D>, 1 << D>& cell, int start)
{
    unsigned found = 1u << start, next = found;
    while (next) {
        const unsigned now = next;
        next = 0;
        for (int corner = 0; corner < 1 << D; ++corner)
            if (now >> corner & 1) {
                const unsigned open = states(cell[corner]).open;
                for (int axis = 0; axis < D; ++axis) {
                    const bool high = corner >> axis & 1;
                    if (open >> (2 * axis + !high) & 1)
                        next |= 1u << (corner ^ 1 << axis);
                }
            }
        next &= ~found;
        found |= next;
    }
    return found;
}

// Cells joined to `start` through open faces within one cell of the stencil at base .. base + 1.
template <int D>
std::vector<Index<D>> connected_around(const CellStates<D>& states, const Index<D>& start, const Index<D>& base)
{
    std::vector<Index<D>> found{start};
    for (std::size_t i = 0; i < found.size(); ++i) {
        const unsigned open = states(found[i]).open;
        for (int side = 0; side < 2 * D; ++side) {
            if (!(open >> side & 1))
                continue;
            const Index<D> beyond = found[i] + (side % 2 ? 1 : -1) * step<D>(side / 2), d = beyond - base;
            if ((d.array() >= -1).all() && (d.array() <= 2).all() &&
                std::find(found.begin(), found.end(), beyond) == found.end())
                found.push_back(beyond);
        }
    }
    return found;
}

} // namespace

template <int D>
std::vector<std::pair<long, double>> mouth_stencil(const CellStates<D>& states, const Vec<D>& y)
{
    const Grid<D>& grid = states.grid();
    constexpr int count = 1 << D;
    const Vec<D> place = (y - grid.anchor()) / grid.dx() - Vec<D>::Constant(0.5);
    const Index<D> base = place.array().floor().template cast<int>();
    std::array<Index<D>, count> cell;
    std::array<double, count> weights;
    unsigned wanted = 0; // bit k: corner k has weight
    int heaviest = -1;
    for (int corner = 0; corner < count; ++corner) {
        Index<D> c = base;
        double weight = 1;
        for (int axis = 0; axis < D; ++axis) {
            const double f = place[axis] - base[axis];
            const bool high = corner >> axis & 1;
            c[axis] += high;
            weight *= high ? f : 1 - f;
        }
        cell[corner] = c;
        if (weight <= 1e-9 || !grid.in_domain(grid.wrapped(c)))
            continue;
        const auto state = states(c);
        if (state.kind != CellKind::bulk && state.kind != CellKind::mixed)
            continue;
        weight *= std::min(1.0, state.aperture / full_aperture);
        if (weight <= 0)
            continue;
        weights[corner] = weight;
        wanted |= 1u << corner;
        if (heaviest < 0 || weight > weights[heaviest])
            heaviest = corner;
    }
    if (heaviest < 0)
        return {};
    unsigned connected = connected_corners<D>(states, cell, heaviest);
    if (wanted & ~connected) {
        const std::vector<Index<D>> around = connected_around<D>(states, cell[heaviest], base);
        for (int corner = 0; corner < count; ++corner)
            if (std::find(around.begin(), around.end(), cell[corner]) != around.end())
                connected |= 1u << corner;
    }
    std::vector<std::pair<long, double>> result;
    double total = 0;
    for (int corner = 0; corner < count; ++corner)
        if (wanted & connected & 1u << corner) {
            result.emplace_back(grid.key(grid.wrapped(cell[corner])), weights[corner]);
            total += weights[corner];
        }
    if (total < minimum_weight)
        return {};
    for (auto& entry : result)
        entry.second /= total;
    return result;
}

template std::vector<std::pair<long, double>> mouth_stencil<2>(const CellStates<2>&, const Vec<2>&);
template std::vector<std::pair<long, double>> mouth_stencil<3>(const CellStates<3>&, const Vec<3>&);

} // namespace gapflow
