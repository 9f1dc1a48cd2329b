#include "gapflow/step/drained.hpp"

#include <array>
#include <utility>

namespace gapflow {
namespace {

/// Arms that lead to voids, by the faces of the form.
template <int D>
std::map<std::int32_t, const GapArm<D>*> arms_of_voids(const Placed<D>& at, const ViscousForm<D>& form,
                                                       const std::map<long, double>& given)
{
    const auto is_void = [&](const PartOrCell& side) {
        const VoidPart<D>* part = side.exists() ? at.voids.find(site_of(at.complex, side)) : nullptr;
        return part && (at.voids.is_void(part->part) || given.contains(part->row));
    };
    std::map<std::pair<int, std::int32_t>, std::vector<std::int32_t>> faces;
    for (std::int32_t f = 0; f < form.velocities(); ++f)
        if (!form.faces[f].whole)
            faces[{form.faces[f].axis, form.faces[f].face}].push_back(f);
    std::map<std::int32_t, const GapArm<D>*> result;
    for (const GapArm<D>& arm : at.voids.arms) {
        const FacePiece<D>& piece = at.complex.pieces[arm.piece];
        if (!is_void(piece.low) && !is_void(piece.high))
            continue;
        for (const std::int32_t f : faces[{piece.axis, piece.face}])
            if (form.faces[f].low == form.cells.of(piece.low) && form.faces[f].high == form.cells.of(piece.high))
                result[f] = &arm;
    }
    return result;
}

/// With the walls' velocities along the gap at the arm's piece alone: as where both move along it without turning.
template <int D>
Row along_gap(const Placed<D>& at, const ViscousForm<D>& form, const Row& row, const GapArm<D>& arm)
{
    constexpr int T = twist_size<D>;
    const Grid<D>& grid = *at.coupling.grid;
    Vec<D> normal = arm.opening.template segment<D>(T);
    if (normal.isZero(0)) // a wall that stays
        normal = arm.opening.template head<D>();
    if (normal.isZero(0))
        return row;
    normal.normalize();
    const Vec<D> place = grid.anchor() + grid.dx() * at.complex.pieces[arm.piece].centroid;
    Row result;
    std::array<Vec<D>, 2> by{Vec<D>::Zero(), Vec<D>::Zero()};
    for (const Term& term : row.terms()) {
        const int k = term.column - form.unknowns(), solid = k / T;
        if (k < 0 || k >= T * form.solids)
            result.add(term.column, term.factor);
        else if (k % T < D)
            by[solid == arm.solid[1]][k % T] += term.factor;
    }
    for (int side = 0; side < 2; ++side) {
        const Vec<D> along = by[side] - by[side].dot(normal) * normal,
                     way = grid.nearest_image(Vec<D>(place - at.coupling.solids[arm.solid[side]].centre)) / grid.dx();
        const Spin<D> turn = moment<D>(way, along);
        for (int k = 0; k < T; ++k)
            result.add(form.twist_column(arm.solid[side], k), k < D ? along[k] : turn[k - D]);
    }
    result.merge();
    return result;
}

} // namespace

template <int D>
ViscousForm<D> drained_form(const Placed<D>& at, const ViscousForm<D>& form, const std::vector<double>& filled,
                            const std::map<long, double>& given)
{
    ViscousForm<D> result = form.filled(filled);
    const std::map<std::int32_t, const GapArm<D>*> arms = arms_of_voids(at, form, given);
    SquareSum& sum = result.squares;
    sum.end.resize(1);
    sum.column.clear();
    sum.factor.clear();
    for (std::int64_t k = 0; k < form.squares.rows(); ++k) {
        Row row;
        for (std::int64_t t = form.squares.end[k]; t < form.squares.end[k + 1]; ++t)
            row.add(form.squares.column[t], form.squares.factor[t]);
        const auto found = k >= form.gap_rows[0] && k < form.gap_rows[1] ? arms.find(form.row_face[k]) : arms.end();
        if (found != arms.end())
            row = along_gap(at, form, row, *found->second);
        for (const Term& term : row.terms()) {
            sum.column.push_back(term.column);
            sum.factor.push_back(term.factor);
        }
        sum.end.push_back(static_cast<std::int64_t>(sum.column.size()));
    }
    return result;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template ViscousForm<D> drained_form<D>(const Placed<D>&, const ViscousForm<D>&, const std::vector<double>&,               \
                                            const std::map<long, double>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
