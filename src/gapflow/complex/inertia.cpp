#include "gapflow/complex/inertia.hpp"

#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/grid/field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace gapflow {
namespace {

/// Pieces of faces that only the line from a sharp corner separates, taken together; and what lies beside them in the plane of the grid.
template <int D>
class OpenAreas {
public:
    struct Area {
        std::int32_t piece = -1; ///< its first piece; -1: all of an open face
        std::int32_t face = -1;  ///< -1: none
        double area = 0;
        Vec<D> centroid = Vec<D>::Zero();
    };

    OpenAreas(const Grid<D>& grid, const Complex<D>& complex) : grid_(grid), complex_(complex)
    {
        for (int d = 0; d < D; ++d)
            first_[d].assign(complex.index.count, -1);
        next_.assign(complex.pieces.size(), -1);
        for (std::size_t k = complex.pieces.size(); k-- > 0;) {
            std::int32_t& first = first_[complex.pieces[k].axis][complex.pieces[k].face];
            next_[k] = first;
            first = static_cast<std::int32_t>(k);
        }
        if (complex.links.empty())
            return;
        DisjointSets whole(complex.parts());
        for (const CornerLink<D>& link : complex.links)
            whole.join(link.a, link.b);
        int count = 0;
        whole_ = whole.numbers(count);
    }

    /// The area to which a piece belongs, if that is its first one.
    std::optional<Area> led_by(std::int32_t piece) const
    {
        const FacePiece<D>& p = complex_.pieces[piece];
        if (complex_.links.empty())
            return Area{piece, p.face, p.area, p.centroid};
        Area sum{piece, p.face, 0, Vec<D>::Zero()};
        for (std::int32_t k = first_[p.axis][p.face]; k >= 0; k = next_[k])
            if (same(k, piece)) {
                if (k < piece)
                    return {};
                sum.area += complex_.pieces[k].area;
                sum.centroid += complex_.pieces[k].area * complex_.pieces[k].centroid;
            }
        sum.centroid /= sum.area > 0 ? sum.area : 1;
        return sum;
    }

    /// Calls f(piece) for the pieces of an area.
    template <class F>
    void for_each(const Area& area, F&& f) const
    {
        if (complex_.links.empty()) {
            f(area.piece);
            return;
        }
        const FacePiece<D>& p = complex_.pieces[area.piece];
        for (std::int32_t k = first_[p.axis][p.face]; k >= 0; k = next_[k])
            if (same(k, area.piece))
                f(k);
    }

    /// The one of the face `steps` beyond f, that of the given area, along t whose centroid is nearest to its own but for t.
    Area beside(int axis, const Area& from, const Index<D>& f, int t, int steps) const
    {
        const int cells = grid_.cells()[t];
        int at = f[t] + steps;
        if (at < 0 || at >= cells) {
            if (!grid_.periodic(t))
                return {};
            at += at < 0 ? cells : -cells;
        }
        const std::int32_t face = from.face + (at - f[t]) * complex_.index.stride[t], first = first_[axis][face];
        if (first < 0)
            return {-1, complex_.main_area[axis][face] > 0 ? face : -1, complex_.main_area[axis][face], Vec<D>::Zero()};
        Area best;
        double least = std::numeric_limits<double>::infinity();
        for (std::int32_t k = first; k >= 0; k = next_[k])
            if (const std::optional<Area> area = led_by(k)) {
                Vec<D> way = area->centroid - from.centroid;
                way[t] = 0; // across: the same side of a thin solid
                if (way.norm() < least) {
                    least = way.norm();
                    best = *area;
                }
            }
        return best;
    }

private:
    int whole(const PartOrCell& side) const { return side.is_part() ? whole_[side.number()] : side.code; }
    bool same(std::int32_t a, std::int32_t b) const
    {
        return a == b || (whole(complex_.pieces[a].low) == whole(complex_.pieces[b].low) &&
                          whole(complex_.pieces[a].high) == whole(complex_.pieces[b].high));
    }

    const Grid<D>& grid_;
    const Complex<D>& complex_;
    std::array<std::vector<std::int32_t>, D> first_;
    std::vector<std::int32_t> next_;
    std::vector<int> whole_; ///< of each part: those that links join have one number
};

template <int D>
class Lending {
public:
    using Area = typename OpenAreas<D>::Area;

    Lending(const Grid<D>& grid, const Complex<D>& complex, Inertia<D>& inertia)
        : grid_(grid), complex_(complex), inertia_(inertia), areas_(grid, complex)
    {
    }

    void lend()
    {
        for (std::size_t k = 0; k < complex_.pieces.size(); ++k) {
            const FacePiece<D>& piece = complex_.pieces[k];
            if (!piece.low.exists() || !piece.high.exists() || !(piece.area > 0))
                continue;
            const std::optional<Area> own = areas_.led_by(static_cast<std::int32_t>(k));
            if (!own)
                continue;
            find_shares(*own);
            if (shares_.empty())
                continue;
            const Index<D> f = complex_.index.index(piece.face);
            for (int t = 0; t < D; ++t) {
                if (t == piece.axis)
                    continue;
                const double centre = (grid_.centre_place(t, f[t]) - grid_.anchor()[t]) / grid_.dx(),
                             offset = own->centroid[t] - centre;
                const int towards = offset > 0 ? 1 : -1;
                const Area next = areas_.beside(piece.axis, *own, f, t, towards);
                if (next.face < 0 || !(next.area > 0))
                    continue;
                const double lent = 0.5 * std::min(1.0, next.area / own->area) * own->area * std::abs(offset);
                const Area after = areas_.beside(piece.axis, *own, f, t, 2 * towards);
                const double more =
                    after.face >= 0 && after.area > 0 ? 0.5 * lent * std::min(1.0, after.area / own->area) : 0.0;
                add(piece.axis, *own, -lent - more);
                add(piece.axis, next, lent + 2 * more);
                if (more > 0)
                    add(piece.axis, after, -more);
            }
        }
    }

private:
    /// A solid beside a piece: its walls in the parts on the two sides.
    struct Share {
        std::int32_t solid;
        double size; ///< of the area vectors; in the end over the sum of all
        Vec<D> area;
        Spin<D> moment;
    };

    void find_shares(const Area& area)
    {
        shares_.clear();
        double sum = 0;
        areas_.for_each(area, [&](std::int32_t piece) {
            for (const PartOrCell& side : {complex_.pieces[piece].low, complex_.pieces[piece].high})
                if (side.is_part())
                    for (const WallPatch<D>& patch : complex_.patches_of(side.number())) {
                        const double size = patch.area.norm();
                        sum += size;
                        auto known = std::find_if(shares_.begin(), shares_.end(),
                                                  [&](const Share& share) { return share.solid == patch.solid; });
                        if (known != shares_.end()) {
                            known->size += size;
                            known->area += patch.area;
                            known->moment += patch.moment;
                        } else
                            shares_.push_back({patch.solid, size, patch.area, patch.moment});
                    }
        });
        for (Share& share : shares_)
            share.size /= sum > 0 ? sum : 1;
    }

    PartOrCell main_of(const Index<D>& c) const { return complex_.main_of(complex_.index(grid_.wrapped(c))); }

    void add(int d, const Area& to, double area)
    {
        if (to.piece < 0) {
            inertia_.main_weight[d][to.face] += area;
            const Index<D> f = complex_.index.index(to.face);
            add_flux(d, main_of(f - step<D>(d)), main_of(f), area);
            return;
        }
        areas_.for_each(to, [&](std::int32_t k) {
            const FacePiece<D>& piece = complex_.pieces[k];
            const double share = area * piece.area / to.area;
            inertia_.piece_weight[k] += share;
            if (complex_.joins_main(piece))
                inertia_.main_weight[d][to.face] += share;
            add_flux(d, piece.low, piece.high, share);
        });
    }

    void add_flux(int d, const PartOrCell& low, const PartOrCell& high, double area)
    {
        for (const Share& share : shares_) {
            // A wall that turns moves with its speed along its normal: one that turns in itself lends nothing.
            Twist<D> flux = Twist<D>::Zero();
            flux[d] = share.size * area;
            if (const double square = share.area.squaredNorm(); square > 0)
                flux.template tail<spin_size<D>>() = share.size * area * share.area[d] / square * share.moment;
            add_row(high, share.solid, flux);
            add_row(low, share.solid, -flux);
        }
    }

    void add_row(const PartOrCell& row, std::int32_t solid, const Twist<D>& flux)
    {
        if (row.is_part())
            for (int k = complex_.first_patch[row.number()]; k < complex_.first_patch[row.number() + 1]; ++k)
                if (complex_.patches[k].solid == solid) {
                    inertia_.patch_flux[k] += flux;
                    return;
                }
        inertia_.flux.push_back({row, solid, flux});
    }

    const Grid<D>& grid_;
    const Complex<D>& complex_;
    Inertia<D>& inertia_;
    OpenAreas<D> areas_;
    std::vector<Share> shares_;
};

} // namespace

template <int D>
Inertia<D> find_inertia(const Grid<D>& grid, const Complex<D>& complex)
{
    Inertia<D> inertia;
    inertia.main_weight = complex.main_area;
    inertia.piece_weight.reserve(complex.pieces.size());
    inertia.patch_flux.reserve(complex.patches.size());
    for (const FacePiece<D>& piece : complex.pieces)
        inertia.piece_weight.push_back(piece.area);
    for (const WallPatch<D>& patch : complex.patches) {
        Twist<D> flux;
        flux << patch.area, patch.moment;
        inertia.patch_flux.push_back(flux);
    }
    Lending<D>(grid, complex, inertia).lend();
    return inertia;
}

template Inertia<2> find_inertia(const Grid<2>&, const Complex<2>&);
template Inertia<3> find_inertia(const Grid<3>&, const Complex<3>&);

} // namespace gapflow
