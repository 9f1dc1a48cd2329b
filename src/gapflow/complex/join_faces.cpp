#include "gapflow/complex/join_faces.hpp"

#include <tuple>
#include <utility>

namespace gapflow {

template <int D>
void Joining<D>::join_faces() requires(D == 3)
{
    // Wholly open faces; a side that is none lies beyond the domain, or is a part too small to be one.
    for (int d = 0; d < 3; ++d)
        for_each_row_on_threads<3>(index_.low, index_.faces_end(d), [&](const Index<3>& row) {
            const int end = index_.faces_end(d)[0] - row[0], first = index_(row), last_cell = index_.high()[0] - row[0] - 1;
            const Index<3> below = index_.wrapped(row - step<3>(d));
            const bool side = below[d]<index_.low[d], beyond = d> 0 && row[d] == index_.high()[d];
            const int back = side ? 0 : index_(below) - first;
            for (int i = 0; i < end; ++i) {
                const int at = first + i;
                if (cut_.face[d][at] != Complex<3>::open)
                    continue;
                const bool last = beyond || i > last_cell;
                // Along the rows themselves only the first face has another cell before it.
                const int other = d == 0 && i > 0 ? at - 1 : at + back;
                const bool high = !last && complex_.cell[at] != Complex<3>::solid;
                const bool low = (!side || (d == 0 && i > 0)) && complex_.cell[other] != Complex<3>::solid;
                if (high || low)
                    complex_.main_area[d][at] = grid_.graded() ? face_area(d, index_.index(at)) : 1.0;
            }
        });
    std::vector<typename CellSlab<3>::Astray> astray;
    for (std::size_t s = 0; s < slabs_.size(); ++s)
        for (auto a : slabs_[s].astray) {
            a.part += part_offset_[s];
            astray.push_back(a);
        }
    std::sort(astray.begin(), astray.end(),
              [](const auto& a, const auto& b) { return std::tie(a.axis, a.face, a.side) < std::tie(b.axis, b.face, b.side); });
    std::vector<Pieces> lists(slabs_.size() + 1); // those astray before the slabs'
    for (std::size_t k = 0; k < astray.size();) {
        const int d = astray[k].axis, id = astray[k].face;
        const Index<3> f = index_.index(id);
        std::array<PartOrCell, 2> side{main_of(f - step<3>(d)), main_of(f)};
        for (; k < astray.size() && astray[k].axis == d && astray[k].face == id; ++k)
            side[astray[k].side] = PartOrCell::part(astray[k].part);
        const double area = std::exchange(complex_.main_area[d][id], 0.0);
        add_piece(d, f, side[0], side[1], area, face_centre(d, f), {}, lists[0]);
    }
    for_each_job(static_cast<int>(slabs_.size()), [&](int s) {
        const Slab<3>& slab = cut_.slabs[s];
        for (const CutFace<3>& face : slab.faces) {
            if (face.state == CutFace<3>::State::dead)
                continue;
            const Index<3> f = index_.index(face.id);
            const int d = face.axis, u = u_axis<3>(d), v = v_axis<3>(d);
            const int plane = index_.wrapped(f - step<3>(d))[2] - index_.low[2]; // of the cell below
            const int below = plane < 0 ? s : cut_.slab_of[plane];
            for (int p = 0; p < face.pieces; ++p) {
                const int number = face.piece + p;
                const SquarePiece& piece = slab.pieces[number];
                Vec<3> centroid;
                centroid[d] = planes_.place[d][f[d]];
                centroid[u] = piece.centroid[0];
                centroid[v] = piece.centroid[1];
                add_piece(d, f, part_at(s, number, 0, below), part_at(s, number, 1, s), piece.area, centroid,
                          {s, static_cast<std::int32_t>(&face - slab.faces.data()), number, 0, 0, 0}, lists[s + 1]);
            }
        }
    });
    add_all(lists);
}

template <int D>
void Joining<D>::join_faces() requires(D == 2)
{
    // An edge's open stretches and what lies behind them, as one of the rectangles beside it has them; a line that divides the rectangle
    // divides the edge on that side alone.
    struct Behind {
        double from, to;
        PartOrCell part;
    };
    using Behinds = InlineVector<Behind, 4>;
    const auto is_cut = [&](const Index<2>& w) { return index_.holds(w) && cut_.face[0][index_(w)] >= 0; };
    const auto stretches_of = [&](const Index<2>& c, int e, double from, double to, Behinds& list) {
        const Index<2> w = index_.wrapped(c);
        list.clear();
        if (!is_cut(w)) {
            const PartOrCell main = main_of(c);
            if (main.exists() || !index_.holds(w))
                list.push_back({from, to, main});
            return;
        }
        const std::size_t number = static_cast<std::size_t>(cut_.slab_of[w[1] - index_.low[1]]);
        const Slab<2>& slab = cut_.slabs[number];
        const CutFace<2>& face = slab.faces[cut_.face[0][index_(w)]];
        const auto part_of = [&](int piece) { return part_at(number, face.piece + piece, 0, number); };
        if (face.detail >= 0) {
            const FaceDetail& detail = slab.details[face.detail];
            for (int k = detail.stretch[e]; k < detail.stretch[e + 1]; ++k)
                list.push_back({slab.stretches[k].from, slab.stretches[k].to, part_of(slab.stretches[k].piece)});
            return;
        }
        const bool a = face.open >> e & 1, b = face.open >> ((e + 1) & 3) & 1;
        if (!a && !b)
            return;
        Behind stretch{from, to, part_of(0)};
        if (!(a && b)) {
            const bool at_low = e < 2 ? a : b; // the open end along the axis
            (at_low ? stretch.to : stretch.from) = slab.crossings[2 * face.crossing + (face.crossing_edge[0] == e ? 0 : 1)];
        }
        list.push_back(stretch);
    };
    std::vector<Pieces> pieces(1);
    Behinds low, high;
    for (int d = 0; d < 2; ++d)
        for_each_index<2>(index_.low, index_.faces_end(d), [&](const Index<2>& f) {
            const int along = 1 - d, e_low = d == 0 ? 1 : 2, e_high = d == 0 ? 3 : 0; // as edges of the cells below and above
            const Index<2> below = f - step<2>(d);
            const double from = planes_.place[along][f[along]], to = planes_.place[along][f[along] + 1];
            stretches_of(below, e_low, from, to, low);
            stretches_of(f, e_high, from, to, high);
            if (!is_cut(index_.wrapped(below)) && !is_cut(index_.wrapped(f))) {
                if (!low.empty() && !high.empty() && (low[0].part.exists() || high[0].part.exists()))
                    complex_.main_area[d][index_(f)] = to - from;
                return;
            }
            for (std::size_t i = 0, j = 0; i < low.size() && j < high.size();) {
                const double begin = std::max(low[i].from, high[j].from), end = std::min(low[i].to, high[j].to);
                if (end > begin) {
                    Vec<2> centroid;
                    centroid[d] = planes_.place[d][f[d]];
                    centroid[along] = 0.5 * (begin + end);
                    PieceSource source;
                    source.from = begin;
                    source.to = end;
                    for (const auto& [c, e] : {std::pair{below, e_low}, {f, e_high}})
                        if (const Index<2> w = index_.wrapped(c); is_cut(w)) {
                            const bool first = source.slab < 0;
                            (first ? source.slab : source.other_slab) = cut_.slab_of[w[1] - index_.low[1]];
                            (first ? source.face : source.other_face) = cut_.face[0][index_(w)];
                            (first ? source.edge : source.other_edge) = e;
                        }
                    add_piece(d, f, low[i].part, high[j].part, end - begin, centroid, source, pieces[0]);
                }
                const bool next_low = low[i].to <= high[j].to, next_high = high[j].to <= low[i].to;
                i += next_low;
                j += next_high;
            }
        });
    add_all(pieces);
    for (std::size_t s = 0; s < slabs_.size(); ++s)
        for (const CutFace<2>& face : cut_.slabs[s].faces) {
            if (face.state == CutFace<2>::State::dead || face.detail < 0)
                continue;
            const FaceDetail& detail = cut_.slabs[s].details[face.detail];
            for (int k = detail.division; k < detail.division + detail.divisions; ++k) {
                const CornerDivision<2>& division = cut_.slabs[s].divisions[k];
                const PartOrCell a = part_at(s, face.piece + division.a, 0, s), b = part_at(s, face.piece + division.b, 0, s);
                if (!a.exists() || !b.exists())
                    continue;
                if (derivatives_)
                    for (const DivisionRate<2>& rate : cut_.slabs[s].rates_of_division(k))
                        derivatives_->links.push_back(
                            {static_cast<std::int32_t>(complex_.links.size()), solids_[rate.image].solid, rate.rate});
                complex_.links.push_back({a.number(), b.number(), solids_[division.image].solid, division.conductance,
                                          division.open, division.covered, division.at, division.mouth});
            }
        }
}

template class Joining<2>;
template class Joining<3>;

} // namespace gapflow
