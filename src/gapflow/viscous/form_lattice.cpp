// Far from solids: differences of neighbours, in runs of faces where all cells are units; up to closed sides, with rows of the two cells beside these.
#include "gapflow/viscous/form_builder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gapflow {

template <int D>
void Lattice<D>::add_product(std::span<const double> x, std::span<double> y) const
{
    for (const LatticeRun<D>& run : runs) {
        const double* here = x.data() + run.first;
        double* by = y.data() + run.first;
        std::array<const double*, 2 * D> beside;
        for (int k = 0; k < 2 * D; ++k)
            beside[k] = x.data() + run.beside[k];
        for (std::int32_t i = 0; i < run.length; ++i) {
            double sum = 2 * D * here[i];
            for (int k = 0; k < 2 * D; ++k)
                sum -= beside[k][i];
            by[i] += sum;
        }
    }
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
    constexpr double same = viscous_parameters.same_place;
    const auto is_unit = [&](const FormFace<D>& face) {
        const Index<D> f = index_.index(face.face);
        bool unit = face.compact && face.low >= 0 && face.high >= 0 && std::abs(face.length - 1) < same;
        for (int axis = 0; axis < D && unit; ++axis)
            for (int end = axis == face.axis ? -1 : 0; end < 1; ++end)
                unit = unit && std::abs(planes_.place[axis][f[axis] + end + 1] - planes_.place[axis][f[axis] + end] - 1) < same;
        return unit;
    };
    const int count = form_.velocities();
    regular_.assign(count, false);
    std::vector<char> unit(count, false);
    for (int k = 0; k < count; ++k)
        unit[k] = form_.faces[k].compact && is_unit(form_.faces[k]);
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

/// Links of a face that is in no run. Half of each is that of the face beyond, by its link or by its element.
template <int D>
void FormBuilder<D>::add_compact(std::int32_t number)
{
    if (regular_[number])
        return;
    const FormFace<D>& face = form_.faces[number];
    const Index<D> f = index_.index(face.face);
    const std::array<std::int32_t, 2 * D> around = beside(number);
    for (int a = 0; a < D; ++a) {
        if (a == face.axis)
            continue;
        if (const auto [layer, end] = cells_to_side(face, a); layer < 2) {
            add_at_side(number, a, end, layer);
            continue;
        }
        const double width = planes_.place[a][f[a] + 1] - planes_.place[a][f[a]], across = face.area / width;
        for (int end = 0; end < 2; ++end) {
            const std::int32_t other = around[2 * a + end];
            if (other < 0 || regular_[other])
                continue;
            const int g = index_.index(form_.faces[other].face)[a];
            form_.squares.add(face.length * across / (width + planes_.place[a][g + 1] - planes_.place[a][g]),
                              {{number, 1}, {other, -1}});
        }
    }
}

/// The two cells beside a closed side have their own elements across it: between the side and the trace of a quadratic function of their means, and from there to
/// where the links begin.
template <int D>
void FormBuilder<D>::add_at_side(std::int32_t number, int axis, int end, int layer)
{
    const FormFace<D>& face = form_.faces[number];
    const Index<D> f = index_.index(face.face), in = (end ? -1 : 1) * step<D>(axis), first = f - layer * in;
    const auto width = [&](const Index<D>& at) { return planes_.place[axis][at[axis] + 1] - planes_.place[axis][at[axis]]; };
    const Row side = of_side(axis, f[axis] + (end ? layer + 1 : -layer), face.axis);
    const std::array<double, 2> weight = first_trace(width(first), width(Index<D>(first + in)));
    Row trace, beyond;
    trace.add(side, 1 - weight[0] - weight[1]);
    for (int k = 0; k < 2; ++k)
        trace.add(whole_face_at(face.axis, Index<D>(first + k * in)), weight[k]);
    if (layer == 0)
        beyond = side;
    else
        beyond = between(face.axis, axis, Index<D>(end ? f : f + in));
    const double stiffness = face.length * face.area / (width(f) * width(f));
    Row difference = trace, rest = velocity(number);
    difference.add(beyond, -1);
    rest.add(trace, -0.5);
    rest.add(beyond, -0.5);
    form_.squares.add(stiffness, std::move(difference));
    form_.squares.add(12 * stiffness, std::move(rest));
}

template struct Lattice<2>;
template struct Lattice<3>;
template void FormBuilder<2>::find_lattice();
template void FormBuilder<3>::find_lattice();
template std::array<std::int32_t, 4> FormBuilder<2>::beside(std::int32_t) const;
template std::array<std::int32_t, 6> FormBuilder<3>::beside(std::int32_t) const;
template std::pair<int, int> FormBuilder<2>::cells_to_side(const FormFace<2>&, int) const;
template std::pair<int, int> FormBuilder<3>::cells_to_side(const FormFace<3>&, int) const;
template void FormBuilder<2>::add_compact(std::int32_t);
template void FormBuilder<3>::add_compact(std::int32_t);
template void FormBuilder<2>::add_at_side(std::int32_t, int, int, int);
template void FormBuilder<3>::add_at_side(std::int32_t, int, int, int);

} // namespace gapflow
