#include "gapflow/complex/face_helpers.hpp"
#include "gapflow/complex/general_cut.hpp"

#include <cmath>
#include <type_traits>
#include <variant>

namespace gapflow {

template <int D>
FaceArcs<D>::FaceArcs(const CutFaces<D>& cut, const GridPlanes<D>& planes, const DenseIndex<D>& index,
                      const std::vector<PlacedSolid<D>>& solids, bool with_chords)
    : planes_(planes), index_(index), solids_(solids),
      general_(std::make_unique<GeneralCut<D>>(cut, planes, index, solids, with_chords)), arcs_(1), with_chords_(with_chords)
{
}

template <int D>
const FaceLine& FaceArcs<D>::line(int fin) const
{
    return general_->line(fin);
}

template <int D>
FaceArcs<D>::~FaceArcs() = default;

template <int D>
std::span<const SquareArc> FaceArcs<D>::of(const Slab<D>& slab, const CutFace<D>& face)
{
    if (face.state == CutFace<D>::State::general) {
        const FaceDetail& detail = slab.details[face.detail];
        Square& square = general_->cut(face, detail, slab.facets);
        std::vector<SquareArc>& arcs = square.arcs;
        chords_.assign(square.chords.begin(), square.chords.end());
        for (BorderChord& chord : chords_)
            if (chord.solid >= 0)
                chord.solid = detail.images[chord.solid];
        for (SquareArc& arc : arcs) {
            arc.solid = detail.images[arc.solid];
            if constexpr (D == 3)
                for (ArcSegment& segment : arc.segments)
                    if (segment.fin >= 0)
                        segment.surface = surface_of_fin(general_->line(segment.fin).edge);
        }
        return arcs;
    }
    const PlacedSolid<D>& placed = solids_[face.image];
    std::visit(
        [&](const auto& kind) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(kind)>, FacetKind<D>>)
                find_simple(placed, kind, face);
        },
        placed.kind);
    return arcs_;
}

template <int D>
template <class Kind>
void FaceArcs<D>::find_simple(const PlacedSolid<D>& placed, const Kind& kind, const CutFace<D>& face)
{
    const Index<D> f = index_.index(face.id);
    const int d = face.axis;
    if (face.image != image_ || d != axis_) {
        image_ = face.image;
        axis_ = d;
        sections_.clear();
        sections_.resize(D == 3 ? index_.size[d] : 1);
    }
    std::unique_ptr<Section>& section = sections_[D == 3 ? f[d] - index_.low[d] : 0];
    if (!section)
        section = std::make_unique<Section>(kind.section(d, plane_of(planes_, d, f)));
    const auto on_edge = [&](int e) {
        const int axis = edge_axis<D>(d, e);
        const Index<D> start = edge_start<D>(d, f, e);
        const Vec<D> x = place_of(planes_, start);
        const int low_corner = e < 2 ? e : (e + 1) % 4;
        const bool covered = (face.open >> low_corner & 1) == placed.inverse;
        Vec<2> at = in_plane<D>(d, x);
        at[e % 2] = crossing(kind.line(axis, x), covered, x[axis], planes_.place[axis][start[axis] + 1]);
        return at;
    };
    int first = 0; // the first open corner
    while (!(face.open >> first & 1) || (face.open >> ((first + 3) & 3) & 1))
        ++first;
    int last = first;
    while (face.open >> ((last + 1) & 3) & 1)
        ++last;
    SquareArc& arc = arcs_[0];
    arc.solid = face.image;
    arc.piece = 0;
    arc.from = on_edge(last & 3);
    arc.to = on_edge((first + 3) & 3);
    arc.segments.clear();
    if (section->empty())
        arc.segments.push_back({arc.from, arc.to, nullptr, -1, false, false});
    else if (placed.inverse)
        add_walk(arc, *section, arc.to, arc.from, false, true);
    else
        add_walk(arc, *section, arc.from, arc.to, false, false);
    if (!with_chords_)
        return;
    chords_.clear();
    Vec<2> here = arc.to;
    const auto add = [&](const Vec<2>& to, int solid) {
        chords_.push_back({0, here, to, solid, -1});
        here = to;
    };
    for (int c = first; c <= last; ++c)
        add(in_plane<D>(d, place_of(planes_, vertex_of_corner<D>(d, f, c & 3))), -1);
    add(arc.from, -1);
    for (const ArcSegment& segment : arc.segments)
        for (int k = 1, n = segment.chords(); k <= n; ++k)
            add(k < n ? segment.at(static_cast<double>(k) / n) : segment.to, face.image);
}

template class FaceArcs<2>;
template class FaceArcs<3>;

} // namespace gapflow
