#include "gapflow/complex/cells.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/surface_rate.hpp"
#include "gapflow/grid/field.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {
namespace {

/// Whether a piece of a cell in 2D is a part: it has an open face, or is too large to be round-off.
bool is_part(const Slab<2>& slab, const CutFace<2>& face, int p)
{
    if (slab.pieces[face.piece + p].area > parameters.least_area)
        return true;
    if (face.detail < 0)
        return true; // one corner of it is open
    const FaceDetail& detail = slab.details[face.detail];
    return std::any_of(slab.stretches.begin() + detail.stretch[0], slab.stretches.begin() + detail.stretch[4],
                       [&](const OpenStretch& stretch) { return stretch.piece == p; });
}

/// 2D: a wall's area vector and moment follow from the ends of its arcs; those where solids meet move.
template <class IsIn>
void add_junction_rates(const Slab<2>& slab, const FaceDetail& detail, IsIn&& is_in, const std::vector<PlacedSolid<2>>& solids,
                        std::size_t begin, CellSlab<2>& result)
{
    for (int k = detail.junction; k < detail.junction + detail.junctions; ++k) {
        const Junction<2>& j = slab.junctions[k];
        if (!is_in(j.piece))
            continue;
        for (const auto& [image, turn] : {std::pair{j.from, 1.0}, {j.to, -1.0}}) {
            const int patch = add_patch<2>(result.patches, begin, solids[image].solid, Vec<2>::Zero(), Spin<2>::Zero());
            for (const PointRate<2>& r : slab.junction_rates[k]) {
                PatchRate<2> rate{patch, solids[r.solid].solid, TwistMatrix<2>::Zero()};
                rate.flux.row(0) = turn * r.rate.row(1);
                rate.flux.row(1) = -turn * r.rate.row(0);
                rate.flux.row(2) = -turn * (j.at - solids[image].reference).transpose() * r.rate;
                result.patch_rates.push_back(rate);
            }
        }
    }
}

} // namespace

CellSlab<2> build_cells(const CutFaces<2>& cut, const DenseIndex<2>& index, const std::vector<PlacedSolid<2>>& solids,
                        int slab_number, PartsBeside& beside, std::vector<std::int32_t>& cell)
{
    CellSlab<2> result;
    const Slab<2>& slab = cut.slabs[slab_number];
    Index<2> low = index.low, high = index.low + index.size - Index<2>::Ones();
    low[1] = slab.begin;
    high[1] = slab.end;
    for_each_index<2>(low, high, [&](const Index<2>& c) {
        const int number = index(c);
        cell[number] = std::min(cut.face[0][number], 0);
        if (cut.face[0][number] < 0)
            return;
        const CutFace<2>& face = slab.faces[cut.face[0][number]];
        InlineVector<int, 4> label;
        int count = 0, largest = -1;
        for (int p = 0; p < face.pieces; ++p) {
            label.push_back(is_part(slab, face, p) ? -1 : -2);
            if (label[p] == -1 && (largest < 0 || slab.pieces[face.piece + p].area > slab.pieces[face.piece + largest].area))
                largest = p;
        }
        cell[number] = Complex<2>::solid;
        if (largest < 0)
            return;
        const int part = static_cast<int>(result.part_cell.size());
        cell[number] = static_cast<std::int32_t>(result.cut_cell.size());
        label[largest] = count++;
        for (int p = 0; p < face.pieces; ++p)
            if (label[p] == -1)
                label[p] = count++;
        for (int l = 0; l < count; ++l) {
            const std::size_t begin = result.patches.size();
            for (int p = 0; p < face.pieces; ++p)
                if (label[p] == l) {
                    result.part_area.push_back(slab.pieces[face.piece + p].area);
                    result.part_centroid.push_back(slab.pieces[face.piece + p].centroid);
                }
            for (int k = 0; k < face.arcs; ++k) {
                const BorderArc<2>& arc = slab.arcs[face.arc + k];
                if (label[arc.piece] == l)
                    add_patch<2>(result.patches, begin, solids[arc.image].solid, arc.area, arc.moment);
            }
            if (!slab.junction_rates.empty() && face.detail >= 0)
                add_junction_rates(
                    slab, slab.details[face.detail], [&](int piece) { return label[piece] == l; }, solids, begin, result);
            result.part_cell.push_back(static_cast<std::int32_t>(result.cut_cell.size()));
            result.patches_of_part.push_back(static_cast<std::int32_t>(result.patches.size() - begin));
        }
        for (int p = 0; p < face.pieces; ++p)
            beside[face.piece + p][0] = label[p] < 0 ? -1 : part + label[p];
        result.cut_cell.push_back(number);
        result.parts_of_cell.push_back(count);
    });
    return result;
}

} // namespace gapflow
