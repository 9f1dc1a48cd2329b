// The slabs' cells and parts joined into one complex over their faces.
#pragma once

#include "gapflow/complex/cells.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/grid/field.hpp"

#include <algorithm>
#include <vector>

namespace gapflow {

/// What is common to both dimensions: one numbering of the slabs' cells and parts.
template <int D>
class Joining {
public:
    Joining(const Grid<D>& grid, const GridPlanes<D>& planes, const std::vector<PlacedSolid<D>>& solids, const CutFaces<D>& cut,
            const std::vector<CellSlab<D>>& slabs, const std::vector<PartsBeside>& beside, Complex<D>& complex,
            FaceDerivatives<D>* derivatives)
        : grid_(grid), planes_(planes), solids_(solids), cut_(cut), slabs_(slabs), beside_(beside), complex_(complex),
          index_(complex.index), derivatives_(derivatives)
    {
        for (const CellSlab<D>& slab : slabs) {
            part_offset_.push_back(part_offset_.back() + static_cast<int>(slab.part_cell.size()));
            cell_offset_.push_back(cell_offset_.back() + static_cast<int>(slab.cut_cell.size()));
            patch_offset_.push_back(patch_offset_.back() + static_cast<int>(slab.patches.size()));
        }
        complex.cut_cell.resize(cell_offset_.back());
        complex.first_part.resize(cell_offset_.back() + 1);
        complex.part_cell.resize(part_offset_.back());
        complex.part_area.resize(part_offset_.back());
        if (D == 2)
            complex.part_centroid.resize(part_offset_.back());
        complex.first_patch.resize(part_offset_.back() + 1);
        complex.patches.resize(patch_offset_.back());
        for_each_job(static_cast<int>(slabs.size()), [&](int s) { copy_slab(s); });
        for (std::size_t s = 0; s < slabs.size(); ++s) {
            if (derivatives) {
                for (PatchRate<D> rate : slabs[s].patch_rates) {
                    rate.patch += patch_offset_[s];
                    derivatives->patches.push_back(rate);
                }
                for (LinkRate<D> rate : slabs[s].link_rates) {
                    rate.link += static_cast<int>(complex.links.size());
                    derivatives->links.push_back(rate);
                }
            }
            for (CornerLink<D> link : slabs[s].links) {
                link.a += part_offset_[s];
                link.b += part_offset_[s];
                complex.links.push_back(link);
            }
        }
        for_each_job(D, [&](int d) { complex.main_area[d].assign(index_.count, 0); });
    }

    /// The largest part of a cell, or the cell where it is whole.
    PartOrCell main_of(const Index<D>& c) const
    {
        const Index<D> w = index_.wrapped(c);
        return index_.holds(w) ? complex_.main_of(index_(w)) : PartOrCell{};
    }

    /// Pieces of one slab.
    struct Pieces {
        std::vector<FacePiece<D>> pieces;
        std::vector<PieceSource> sources;
    };

    void add_piece(int d, const Index<D>& f, PartOrCell low, PartOrCell high, double area, const Vec<D>& centroid,
                   const PieceSource& source, Pieces& to)
    {
        const auto lies = [&](const PartOrCell& side, const Index<D>& c) {
            return side.exists() || !index_.holds(index_.wrapped(c));
        };
        if (!lies(low, f - step<D>(d)) || !lies(high, f) || (!low.exists() && !high.exists()))
            return; // a part too small to be one
        const std::int32_t id = index_(f);
        to.pieces.push_back({static_cast<std::int8_t>(d), id, low, high, area, centroid});
        if (sources)
            to.sources.push_back(source);
        if (complex_.joins_main(to.pieces.back()))
            complex_.main_area[d][id] += area;
    }

    /// Of all slabs, in their order.
    void add_all(const std::vector<Pieces>& lists)
    {
        std::vector<std::size_t> offset{0};
        for (const Pieces& list : lists)
            offset.push_back(offset.back() + list.pieces.size());
        complex_.pieces.resize(offset.back());
        if (sources)
            sources->resize(offset.back());
        for_each_job(static_cast<int>(lists.size()), [&](int s) {
            std::copy(lists[s].pieces.begin(), lists[s].pieces.end(), complex_.pieces.begin() + offset[s]);
            if (sources)
                std::copy(lists[s].sources.begin(), lists[s].sources.end(), sources->begin() + offset[s]);
        });
    }

    /// Part on a side of a piece of a slab's faces, where a cell of slab `of_cell` lies there.
    PartOrCell part_at(std::size_t slab, int piece, int side, std::size_t of_cell) const
    {
        const std::int32_t part = beside_[slab][piece][side];
        return part >= 0 ? PartOrCell::part(part + part_offset_[of_cell]) : PartOrCell{};
    }

    /// Parts below and above each piece of each slab; in 2D the first is the piece's own.
    std::vector<std::vector<std::array<PartOrCell, 2>>> parts_beside() const
    {
        std::vector<std::vector<std::array<PartOrCell, 2>>> result(slabs_.size());
        for (std::size_t s = 0; s < slabs_.size(); ++s) {
            result[s].resize(cut_.slabs[s].pieces.size());
            for (const CutFace<D>& face : cut_.slabs[s].faces) {
                const int plane = grid_.wrapped(index_.index(face.id) - step<D>(face.axis))[D - 1] - index_.low[D - 1];
                const std::size_t below = D == 2 || plane < 0 ? s : static_cast<std::size_t>(cut_.slab_of[plane]);
                for (int p = face.piece; face.state != CutFace<D>::State::dead && p < face.piece + face.pieces; ++p)
                    result[s][p] = {part_at(s, p, 0, below), part_at(s, p, 1, s)};
            }
        }
        return result;
    }

    Vec<D> face_centre(int d, const Index<D>& f) const
    {
        Vec<D> centre;
        for (int axis = 0; axis < D; ++axis)
            centre[axis] = axis == d ? planes_.place[axis][f[axis]]
                                     : 0.5 * (planes_.place[axis][f[axis]] + planes_.place[axis][f[axis] + 1]);
        return centre;
    }
    double face_area(int d, const Index<D>& f) const
    {
        double area = 1;
        for (int axis = 0; axis < D; ++axis)
            if (axis != d)
                area *= planes_.place[axis][f[axis] + 1] - planes_.place[axis][f[axis]];
        return area;
    }

    void join_faces() requires(D == 3);
    void join_faces() requires(D == 2);

    std::vector<PieceSource>* sources = nullptr; ///< of the complex's pieces, where they are wanted

private:
    void copy_slab(int s)
    {
        const CellSlab<D>& slab = slabs_[s];
        const int cell = cell_offset_[s], part = part_offset_[s], patch = patch_offset_[s];
        const auto sums = [](const std::vector<std::int32_t>& counts, int sum, auto to) { // ends of counted ranges
            for (const std::int32_t n : counts)
                *to++ = sum += n;
        };
        for (std::size_t k = 0; k < slab.cut_cell.size(); ++k) {
            complex_.cut_cell[cell + k] = slab.cut_cell[k];
            complex_.cell[slab.cut_cell[k]] += cell;
        }
        sums(slab.parts_of_cell, part, complex_.first_part.begin() + cell + 1);
        for (std::size_t k = 0; k < slab.part_cell.size(); ++k)
            complex_.part_cell[part + k] = slab.part_cell[k] + cell;
        std::copy(slab.part_area.begin(), slab.part_area.end(), complex_.part_area.begin() + part);
        std::copy(slab.part_centroid.begin(), slab.part_centroid.end(), complex_.part_centroid.begin() + part);
        sums(slab.patches_of_part, patch, complex_.first_patch.begin() + part + 1);
        std::copy(slab.patches.begin(), slab.patches.end(), complex_.patches.begin() + patch);
    }

    const Grid<D>& grid_;
    const GridPlanes<D>& planes_;
    const std::vector<PlacedSolid<D>>& solids_;
    const CutFaces<D>& cut_;
    const std::vector<CellSlab<D>>& slabs_;
    const std::vector<PartsBeside>& beside_;
    Complex<D>& complex_;
    const DenseIndex<D>& index_;
    std::vector<int> cell_offset_{0}, part_offset_{0}, patch_offset_{0}; ///< first one of each slab
    FaceDerivatives<D>* derivatives_;                                    ///< null: not wanted
};

} // namespace gapflow
