// Open areas of the grid's faces, and those beside them in the same plane of the grid.
#pragma once

#include "gapflow/complex/complex.hpp"
#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/core/threads.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace gapflow {

/// Pieces of a face that lead from one part to another one, lines from sharp corners not counted, taken together: so nothing jumps where a smooth wall comes
/// through the face; and what lies beside them in the plane of the grid. A face is
/// plain where all that is open of it joins the largest parts of two cells in one piece: Complex::main_area and main_of tell all of it.
template <int D>
class OpenAreas {
public:
    struct Area {
        std::int32_t piece = -1; ///< its first piece; -1: all that is open of a plain face
        std::int32_t face = -1;  ///< -1: none
        double area = 0;
        Vec<D> centroid = Vec<D>::Zero();
    };

    explicit OpenAreas(const Complex<D>& complex) : complex_(complex), next_(complex.pieces.size())
    {
        for_each_job(D, [&](int d) {
            std::vector<std::int32_t>& first = first_[d];
            first.assign(complex.index.count, none);
            for (std::size_t k = complex.pieces.size(); k-- > 0;) {
                const FacePiece<D>& piece = complex.pieces[k];
                if (piece.axis != d)
                    continue;
                std::int32_t& of_face = first[piece.face];
                const auto number = static_cast<std::int32_t>(k);
                next_[k] = decoded(of_face);
                of_face = of_face == none && complex.joins_main(piece) ? number : -2 - number;
            }
        });
        if (complex.links.empty())
            return;
        DisjointSets whole(complex.parts());
        for (const CornerLink<D>& link : complex.links)
            whole.join(link.a, link.b);
        int count = 0;
        whole_ = whole.numbers(count);
    }

    bool plain(int axis, int face) const { return first_[axis][face] >= none; }
    /// The first piece of a face, and the one after a piece; -1: none.
    std::int32_t first(int axis, int face) const { return decoded(first_[axis][face]); }
    std::int32_t next(std::int32_t piece) const { return next_[piece]; }

    /// The area to which a piece belongs, if that is its first one.
    std::optional<Area> led_by(std::int32_t piece) const
    {
        const FacePiece<D>& p = complex_.pieces[piece];
        if (plain(p.axis, p.face))
            return Area{-1, p.face, p.area, p.centroid};
        Area sum{piece, p.face, 0, Vec<D>::Zero()};
        for (std::int32_t k = first(p.axis, p.face); k >= 0; k = next_[k])
            if (same(k, piece)) {
                if (k < piece)
                    return {};
                sum.area += complex_.pieces[k].area;
                sum.centroid += complex_.pieces[k].area * complex_.pieces[k].centroid;
            }
        sum.centroid /= sum.area > 0 ? sum.area : 1;
        return sum;
    }

    /// Calls f(piece) for the pieces of an area of a face that is not plain.
    template <class F>
    void for_each(const Area& area, F&& f) const
    {
        const FacePiece<D>& p = complex_.pieces[area.piece];
        for (std::int32_t k = first(p.axis, p.face); k >= 0; k = next_[k])
            if (same(k, area.piece))
                f(k);
    }

    /// The one of the face `steps` beyond f, that of the given area, along t whose centroid is nearest to its own across t; in 2D, where none
    /// lies across, along t.
    Area beside(int axis, const Area& from, const Index<D>& f, int t, int steps) const
    {
        const DenseIndex<D>& index = complex_.index;
        const int low = index.low[t], cells = index.size[t] - 1;
        int at = f[t] + steps;
        double shift = 0; // of what lies across a periodic side
        if (at < low || at >= low + cells) {
            if (!index.wraps[t])
                return {};
            const int around = at < low ? cells : -cells;
            at += around;
            shift = -around;
        }
        const std::int32_t face = from.face + (at - f[t]) * index.stride[t];
        if (plain(axis, face)) {
            const double open = complex_.main_area[axis][face];
            return {-1, open > 0 ? face : -1, open, Vec<D>::Zero()};
        }
        Area best;
        std::pair least{std::numeric_limits<double>::infinity(), 0.0}; // across: the same side of a thin solid; then along
        for (std::int32_t k = first(axis, face); k >= 0; k = next_[k])
            if (const std::optional<Area> area = led_by(k)) {
                Vec<D> way = area->centroid - from.centroid;
                const double along = std::abs(way[t] + shift);
                way[t] = way[axis] = 0;
                if (const std::pair far{way.norm(), along}; far < least) {
                    least = far;
                    best = *area;
                }
            }
        return best;
    }

private:
    static constexpr std::int32_t none = -1;

    static std::int32_t decoded(std::int32_t first) { return first >= none ? first : -2 - first; }
    int whole(const PartOrCell& side) const { return side.is_part() && !whole_.empty() ? whole_[side.number()] : side.code; }
    bool same(std::int32_t a, std::int32_t b) const
    {
        return a == b || (whole(complex_.pieces[a].low) == whole(complex_.pieces[b].low) &&
                          whole(complex_.pieces[a].high) == whole(complex_.pieces[b].high));
    }

    const Complex<D>& complex_;
    std::array<std::vector<std::int32_t>, D> first_; ///< piece of each face; -2 less it where the face is not plain
    std::vector<std::int32_t> next_;
    std::vector<int> whole_; ///< of each part: those that links join have one number; empty: there are none
};

} // namespace gapflow
