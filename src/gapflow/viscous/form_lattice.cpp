// Far from solids: differences of neighbours, in runs of faces where all cells are units; up to closed sides, with rows of the two cells beside these.
#include "gapflow/viscous/form_builder.hpp"
#include "gapflow/viscous/lattice_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gapflow {

template <int D>
void Lattice<D>::add_product(std::span<const double> x, std::span<double> y) const
{
    for (const LatticeRun<D>& run : runs)
        add_run<D>(run, 1, x.data(), y.data());
    for (const auto& [face, other] : links)
        y[face] += x[face] - x[other];
}

namespace {

/// The trace between the two cells beside a closed side, less the side's velocity: of means of a quadratic function.
std::array<double, 2> first_trace(double first, double second)
{
    // a x + b x^2 has the means a h/2 + b h^2/3 and a (h + k/2) + b (h^2 + h k + k^2/3).
    const double h = first, k = second;
    Mat<2> means;
    means << h / 2, h * h / 3, h + k / 2, h * h + h * k + k * k / 3;
    const Vec<2> weights = means.transpose().inverse() * Vec<2>(h, h * h);
    return {weights[0], weights[1]};
}

} // namespace

template <int D>
std::pair<int, int> FormBuilder<D>::cells_to_side(const FormFace<D>& face, int axis) const
{
    constexpr int far = 2;
    if (axis == face.axis || !has_wall_rows(grid_, axis))
        return {far, 0};
    const int at = index_.index(face.face)[axis], last = grid_.cells()[axis] - 1;
    for (int end = 0; end < 2; ++end)
        if (const int cells = end ? last - at : at; grid_.side(axis, end) == SideKind::wall && cells < far)
            return {cells, end};
    return {far, 0};
}

/// Faces around one, from the low to the high side of each axis.
template <int D>
std::array<std::int32_t, 2 * D> FormBuilder<D>::beside(std::int32_t number) const
{
    const FormFace<D>& face = form_.faces[number];
    const Index<D> f = index_.index(face.face);
    std::array<std::int32_t, 2 * D> result;
    const bool inside = (f.array() > index_.low.array()).all() && (f.array() < index_.high().array() - 1).all();
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end)
            result[2 * axis + end] = inside ? whole_face_[face.axis][face.face + (end ? 1 : -1) * index_.stride[axis]]
                                            : whole_face_at(face.axis, Index<D>(f + (end ? 1 : -1) * step<D>(axis)));
    return result;
}

template <int D>
void FormBuilder<D>::find_lattice()
{
    const auto is_unit = [&](const FormFace<D>& face) {
        constexpr double same = viscous_parameters.same_place;
        const Index<D> f = index_.index(face.face) - index_.low;
        bool unit = face.low >= 0 && face.high >= 0 && std::abs(face.length - 1) < same && std::abs(face.area - 1) < same;
        for (int axis = 0; axis < D && unit; ++axis) // and the cells on either side
            unit =
                std::abs(width_[axis][f[axis] < std::ssize(width_[axis]) ? f[axis] : 0] - 1) < same &&
                (axis != face.axis || std::abs(width_[axis][f[axis] > 0 ? f[axis] - 1 : width_[axis].size() - 1] - 1) < same);
        return unit;
    };
    const int count = form_.velocities();
    regular_.assign(count, false);
    std::vector<char> unit(count, false);
    for (int k = 0; k < count; ++k)
        unit[k] = compact_[k] && is_unit(form_.faces[k]);
    for (int k = 0; k < count; ++k) {
        if (!unit[k])
            continue;
        const FormFace<D>& face = form_.faces[k];
        const std::array<std::int32_t, 2 * D> around = beside(k);
        bool regular = true;
        for (int axis = 0; axis < D && regular; ++axis)
            for (int end = 0; end < 2; ++end)
                regular = regular && around[2 * axis + end] >= 0 && (axis == face.axis || unit[around[2 * axis + end]]) &&
                          cells_to_side(face, axis).first == 2 &&
                          (axis == face.axis || cells_to_side(form_.faces[around[2 * axis + end]], axis).first == 2);
        regular_[k] = regular;
        if (!regular)
            continue;
        std::vector<LatticeRun<D>>& runs = form_.lattice.runs;
        bool goes_on = !runs.empty() && k == runs.back().first + runs.back().length;
        for (int j = 0; j < 2 * D && goes_on; ++j)
            goes_on = around[j] == runs.back().beside[j] + runs.back().length;
        if (goes_on)
            ++runs.back().length;
        else
            runs.push_back({k, 1, around});
    }
    for (const LatticeRun<D>& run : form_.lattice.runs)
        for (const std::int32_t first : run.beside)
            for (std::int32_t i = 0; i < run.length; ++i)
                if (!regular_[first + i])
                    form_.lattice.links.push_back({first + i, run.first + i});
}

template <int D>
void FormBuilder<D>::add_at_sides(std::int32_t number)
{
    for (int axis = 0; axis < D; ++axis)
        if (const auto [layer, end] = cells_to_side(form_.faces[number], axis); layer < 2)
            add_at_side(number, axis, end, layer);
}

/// The two cells beside a closed side have their own elements across it: between the side and the trace of a quadratic function of their means, and from there to
/// where the links begin.
template <int D>
void FormBuilder<D>::add_at_side(std::int32_t number, int axis, int end, int layer)
{
    const FormFace<D>& face = form_.faces[number];
    const Index<D> f = index_.index(face.face), in = (end ? -1 : 1) * step<D>(axis), first = f - layer * in;
    const auto width = [&](const Index<D>& at) { return width_[axis][at[axis] - index_.low[axis]]; };
    const std::array<double, 2> weight = first_trace(width(first), width(Index<D>(first + in)));
    const auto side = [&](double factor, Terms& to) {
        add_side(axis, f[axis] + (end ? layer + 1 : -layer), face.axis, factor, to);
    };
    const auto trace = [&](double factor, Terms& to) {
        side(factor * (1 - weight[0] - weight[1]), to);
        for (int k = 0; k < 2; ++k)
            to.push_back({whole_face_at(face.axis, Index<D>(first + k * in)), factor * weight[k]});
    };
    const auto beyond = [&](double factor, Terms& to) {
        if (layer == 0)
            side(factor, to);
        else
            add_between(face.axis, axis, Index<D>(end ? f : f + in), factor, to);
    };
    const double stiffness = face.length * face.area / (width(f) * width(f));
    Terms row;
    trace(1, row);
    beyond(-1, row);
    add_row(stiffness, row);
    row = {{number, 1}};
    trace(-0.5, row);
    beyond(-0.5, row);
    add_row(12 * stiffness, row);
}

template struct Lattice<2>;
template struct Lattice<3>;
template void FormBuilder<2>::find_lattice();
template void FormBuilder<3>::find_lattice();
template std::array<std::int32_t, 4> FormBuilder<2>::beside(std::int32_t) const;
template std::array<std::int32_t, 6> FormBuilder<3>::beside(std::int32_t) const;
template std::pair<int, int> FormBuilder<2>::cells_to_side(const FormFace<2>&, int) const;
template std::pair<int, int> FormBuilder<3>::cells_to_side(const FormFace<3>&, int) const;
template void FormBuilder<2>::add_at_sides(std::int32_t);
template void FormBuilder<3>::add_at_sides(std::int32_t);
template void FormBuilder<2>::add_at_side(std::int32_t, int, int, int);
template void FormBuilder<3>::add_at_side(std::int32_t, int, int, int);

} // namespace gapflow
