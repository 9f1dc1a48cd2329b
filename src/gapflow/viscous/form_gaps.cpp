// Gaps narrower than a cell: their dissipation in closed form (complex/gap_drag),
//
//     E_f = 1/2 (R q^2 + 2 q c V + V B V) = 1/2 R (q + c V/R)^2 + 1/2 V (B - c c^T/R) V,      q = A (u - U V).
#include "gapflow/viscous/form_builder.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace gapflow {
namespace {

/// 1 up to a thickness, 0 from another one on.
double gap_share(double thickness, double from, double to)
{
    const double x = std::clamp((thickness - from) / (to - from), 0.0, 1.0);
    return 1 - x * x * (3 - 2 * x);
}

} // namespace

/// In space the known peak of the pressure is that of a pair of solids, and all of their gap goes over to elements together, by its least thickness.
template <int D>
double FormBuilder<D>::pair_share(const std::array<std::int32_t, 2>& solids) const
{
    const auto at = least_thickness_.find(solids);
    return at == least_thickness_.end() ? 1 : gap_share(at->second, viscous_parameters.pair_start, viscous_parameters.pair_end);
}

template <int D>
void FormBuilder<D>::find_gaps()
{
    const auto take = [&](std::int32_t piece, double share) {
        if (const std::int32_t face = face_of_piece_[piece]; face >= 0 && share > 0)
            form_.faces[face].gap = share;
    };
    if constexpr (D == 3)
        for (const GapDrag<D>& drag : gaps_.faces) {
            const auto [at, is_new] = least_thickness_.emplace(drag.solid, drag.thickness);
            at->second = std::min(at->second, drag.thickness);
        }
    for (const GapDrag<D>& drag : gaps_.faces)
        take(drag.piece, drag.share * pair_share(drag.solid));
    for (const auto& joined : gaps_.joined)
        take(joined.piece, joined.share);
    find_cell_shares();
}

/// A cell's dissipation is that of a gap as far as all its faces lie in one; of cells whose faces others of the gap stand for, as far as for all of them.
template <int D>
void FormBuilder<D>::find_cell_shares()
{
    const int cells = form_.cells.count();
    gap_of_cell_.assign(cells, 0);
    if (D == 3) {
        for (std::int32_t face = 0; face < pieces_; ++face)
            for (const std::int32_t cell : {form_.faces[face].low, form_.faces[face].high})
                if (cell >= 0 && form_.faces[face].gap > 0)
                    gap_of_cell_[cell] += form_.faces[face].gap / static_cast<double>(faces_of(cell).size());
        return;
    }
    std::vector<std::int32_t> root(cells);
    std::iota(root.begin(), root.end(), 0);
    const auto root_of = [&](std::int32_t cell) {
        while (root[cell] != cell)
            cell = root[cell] = root[root[cell]];
        return cell;
    };
    for (const auto& joined : gaps_.joined)
        if (const std::int32_t face = face_of_piece_[joined.piece]; face >= 0)
            root[root_of(form_.faces[face].low)] = root_of(form_.faces[face].high);
    std::vector<double> share(cells, 1);
    for (int cell = 0; cell < cells; ++cell)
        for (const CellFace& of : faces_of(cell))
            share[root_of(cell)] = std::min(share[root_of(cell)], form_.faces[of.face].gap);
    for (int cell = 0; cell < cells; ++cell)
        gap_of_cell_[cell] = faces_of(cell).empty() ? 0 : share[root_of(cell)];
    for (FormFace<D>& face : form_.faces)
        face.gap = face.low < 0 || face.high < 0 ? 0 : 0.5 * (gap_of_cell_[face.low] + gap_of_cell_[face.high]);
}

/// A form of the twists of two solids, as squares.
template <int D>
void FormBuilder<D>::add_pair(const std::array<std::int32_t, 2>& solids, const PairMass<D>& mass)
{
    constexpr int T = twist_size<D>;
    const Eigen::SelfAdjointEigenSolver<PairMass<D>> modes(mass);
    for (int m = 0; m < 2 * T; ++m) {
        const double value = modes.eigenvalues()[m];
        if (!(value > 1e-13 * modes.eigenvalues()[2 * T - 1])) // round-off of what common motion does
            continue;
        Row row;
        for (int k = 0; k < 2 * T; ++k)
            if (const double share = modes.eigenvectors()(k, m); share != 0)
                row.add(-1 - T * solids[k / T] - k % T, share);
        form_.squares.add(value, row);
    }
}

/// The face of a peak's gap that lies nearest to it; -1: none.
template <int D>
std::int32_t FormBuilder<D>::face_at(const PeakDrag<D>& peak) const
{
    std::int32_t nearest = -1;
    double least = 0;
    for (const GapDrag<D>& drag : gaps_.faces)
        if (const std::int32_t face = face_of_piece_[drag.piece]; face >= 0 && drag.solid == peak.solid)
            if (const double far = (form_.faces[face].centroid - peak.at).norm(); nearest < 0 || far < least) {
                nearest = face;
                least = far;
            }
    return nearest;
}

/// A gap's friction is that of the motion relative to the walls' mean rotation omega, 2 |e|^2. What of |grad u|^2 it lacks across a face of the area A, with the difference v
/// of the velocities at its ends: (v^2 - (v - A omega)^2)/A. Of two pieces that meet at a vertex of the grid each has its share of the walls' difference.
template <>
void FormBuilder<2>::add_turning()
{
    std::map<std::pair<int, std::int32_t>, std::int32_t> above; // faces from a vertex to a wall
    const auto segment_of = [&](std::int32_t face) -> const BorderSegment<2>& { return segments_[first_segment_[face]]; };
    const auto faces = static_cast<std::int32_t>(form_.faces.size());
    for (std::int32_t f = 0; f < faces; ++f)
        if (form_.faces[f].gap > 0 && segment_of(f).from.vertex >= 0 && segment_of(f).to.solid >= 0)
            above.emplace(std::make_pair(int(form_.faces[f].axis), segment_of(f).from.vertex), f);
    for (std::int32_t f = 0; f < faces; ++f) {
        if (!(form_.faces[f].gap > 0) || segment_of(f).from.solid < 0)
            continue;
        std::vector<std::int32_t> pieces{f};
        const int axis = form_.faces[f].axis;
        if (segment_of(f).to.solid < 0) {
            const auto other = above.find({axis, segment_of(f).to.vertex});
            if (segment_of(f).to.vertex < 0 || other == above.end())
                continue;
            pieces.push_back(other->second);
        }
        const BorderPoint<2>&from = segment_of(f).from, &to = segment_of(pieces.back()).to;
        double area = 0;
        for (const std::int32_t piece : pieces)
            area += form_.faces[piece].area;
        for (const std::int32_t piece : pieces) {
            const FormFace<2>& face = form_.faces[piece];
            Row difference;
            difference.add(of_solid(to.solid, to.at, axis), face.area / area);
            difference.add(of_solid(from.solid, from.at, axis), -face.area / area);
            Row relative = difference;
            for (const std::int32_t solid : {from.solid, to.solid})
                relative.add(-1 - 3 * solid - 2, (axis == 0 ? 0.5 : -0.5) * face.area);
            form_.rotation.add(face.gap * face.length / face.area, difference);
            form_.rotation.add(-face.gap * face.length / face.area, relative);
            form_.turning_face.resize(form_.rotation.rows(), piece);
        }
    }
}

/// A gap that a line of the grid crosses at a vertex has two pieces on it. Of the form of the gap only their sum is a flux; how it is shared out follows from
/// the profile 6 W z (1 - z)/t + v_0 + (v_1 - v_0) z, v the velocities of the walls. Returns the first of the two pieces for the second.
template <>
std::vector<std::size_t> FormBuilder<2>::side_by_side()
{
    std::vector<std::size_t> first(gaps_.faces.size());
    std::iota(first.begin(), first.end(), std::size_t{0});
    std::map<std::pair<int, std::int32_t>, std::array<std::ptrdiff_t, 2>> at_vertex; // below and above
    for (std::size_t k = 0; k < first.size(); ++k) {
        const std::int32_t face = face_of_piece_[gaps_.faces[k].piece];
        if (face < 0 || !(form_.faces[face].gap > 0))
            continue;
        const BorderSegment<2>& segment = segments_[first_segment_[face]];
        const bool below = segment.from.solid >= 0 && segment.to.vertex >= 0,
                   above = segment.from.vertex >= 0 && segment.to.solid >= 0;
        if (below == above)
            continue;
        const std::int32_t vertex = below ? segment.to.vertex : segment.from.vertex;
        at_vertex.emplace(std::make_pair(int(form_.faces[face].axis), vertex), std::array<std::ptrdiff_t, 2>{-1, -1})
            .first->second[above] = static_cast<std::ptrdiff_t>(k);
    }
    for (const auto& [where, pieces] : at_vertex) {
        if (pieces[0] < 0 || pieces[1] < 0)
            continue;
        const GapDrag<2>&low = gaps_.faces[pieces[0]], &high = gaps_.faces[pieces[1]];
        if (low.solid != high.solid)
            continue;
        first[pieces[1]] = static_cast<std::size_t>(pieces[0]);
        const int axis = where.first;
        const std::int32_t a = face_of_piece_[low.piece], b = face_of_piece_[high.piece];
        const BorderPoint<2>&from = segments_[first_segment_[a]].from, &to = segments_[first_segment_[b]].to;
        const double A = form_.faces[a].area, B = form_.faces[b].area, z = A / (A + B), share = z * z * (3 - 2 * z);
        Row rest; // q_a - share W - A (v_0 + (v_1 - v_0) z/2),  W = q_a + q_b - (A + B) (v_0 + v_1)/2
        rest.add(a, (1 - share) * A);
        rest.add(b, -share * B);
        rest.add(of_solid(from.solid, from.at, axis), 0.5 * share * (A + B) - A * (1 - 0.5 * z));
        rest.add(of_solid(to.solid, to.at, axis), 0.5 * share * (A + B) - 0.5 * A * z);
        form_.squares.add(form_.faces[a].gap / low.share * low.resistance, rest);
        form_.row_face.resize(form_.squares.rows(), a);
    }
    return first;
}

template <>
std::vector<std::size_t> FormBuilder<3>::side_by_side()
{
    std::vector<std::size_t> first(gaps_.faces.size());
    std::iota(first.begin(), first.end(), std::size_t{0});
    return first;
}
template <>
void FormBuilder<3>::add_turning()
{
}

template <int D>
void FormBuilder<D>::add_gaps()
{
    constexpr int T = twist_size<D>;
    form_.turning_face.resize(form_.rotation.rows(), -1);
    const std::vector<std::size_t> first = side_by_side();
    add_turning();
    struct Crossing {
        double conductance = 0;
        std::int32_t face = -1;
        Row flux; ///< relative, and c V/R
    };
    std::vector<Crossing> crossings(first.size());
    for (std::size_t k = 0; k < first.size(); ++k) {
        const GapDrag<D>& drag = gaps_.faces[k];
        const std::int32_t face = face_of_piece_[drag.piece];
        if (face < 0 || !(form_.faces[face].gap > 0) || !(drag.resistance > 0))
            continue;
        const FormFace<D>& of = form_.faces[face];
        std::array<double, 2> share{of.gap, of.gap};
        if (D == 2)
            share = {gap_of_cell_[of.low], gap_of_cell_[of.high]};
        DragForm<D> form;
        for (int side = 0; side < 2; ++side) {
            form.resistance += share[side] * drag.half[side].resistance;
            form.flux += share[side] * drag.half[side].flux;
            form.mass += share[side] * drag.half[side].mass;
        }
        if (!(form.resistance > 0)) {
            add_pair(drag.solid, form.mass);
            form_.row_face.resize(form_.squares.rows(), face);
            continue;
        }
        Crossing& crossing = crossings[first[k]];
        crossing.conductance += 1 / form.resistance;
        crossing.face = face;
        crossing.flux.add(face, of.area);
        for (int j = 0; j < 2 * T; ++j)
            crossing.flux.add(-1 - T * drag.solid[j / T] - j % T, form.flux[j] / form.resistance - of.area * drag.motion[j]);
        add_pair(drag.solid, form.mass - form.flux * form.flux.transpose() / form.resistance);
        form_.row_face.resize(form_.squares.rows(), face);
    }
    for (const Crossing& crossing : crossings)
        if (crossing.conductance > 0) {
            form_.squares.add(1 / crossing.conductance, crossing.flux);
            form_.row_face.resize(form_.squares.rows(), crossing.face);
        }
    for (const PeakDrag<D>& peak : gaps_.peaks) {
        add_pair(peak.solid, pair_share(peak.solid) * peak.mass);
        form_.row_face.resize(form_.squares.rows(), face_at(peak));
    }
}

template <int D>
ViscousForm<D> ViscousForm<D>::filled(const std::vector<double>& share) const
{
    ViscousForm<D> form = *this;
    for (std::int64_t row = 0; row < squares.rows(); ++row) {
        double least = row_face[row] >= 0 ? share[row_face[row]] : 1;
        for (std::int64_t t = squares.end[row]; t < squares.end[row + 1] && row_face[row] < 0; ++t)
            if (squares.column[t] < velocities())
                least = std::min(least, share[squares.column[t]]);
        form.squares.weight[row] *= least;
    }
    for (std::size_t k = 0; k < turning_face.size(); ++k)
        if (turning_face[k] >= 0)
            form.rotation.weight[k] *= share[turning_face[k]];
    return form;
}

template ViscousForm<2> ViscousForm<2>::filled(const std::vector<double>&) const;
template ViscousForm<3> ViscousForm<3>::filled(const std::vector<double>&) const;
template double FormBuilder<2>::pair_share(const std::array<std::int32_t, 2>&) const;
template double FormBuilder<3>::pair_share(const std::array<std::int32_t, 2>&) const;
template void FormBuilder<2>::find_gaps();
template void FormBuilder<2>::add_gaps();
template void FormBuilder<3>::find_gaps();
template void FormBuilder<3>::add_gaps();

} // namespace gapflow
