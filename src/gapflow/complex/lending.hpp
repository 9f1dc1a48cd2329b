// What open areas lend to those beside them (theory, "Energy"; inertia.hpp). Shared by the energy and its derivative.
#pragma once

#include "gapflow/complex/open_areas.hpp"
#include "gapflow/complex/parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gapflow {

/// What of a solid's motion lent area carries: of its velocity along the axis, and of its spin.
template <int D>
struct MovingShare {
    std::int32_t solid;
    double size;                      ///< of the area vectors of its walls on both sides; in the end over the sum of all
    Vec<D> area = Vec<D>::Zero();     ///< of these walls, without those of parts that a link joins (see OpenAreas::divided)
    Spin<D> moment = Spin<D>::Zero(); ///< of the same
    Spin<D> spin = Spin<D>::Zero();   ///< flux of the spin

    /// Not the two sides of a dividing plane alone, which cancel but for round-off.
    bool faces() const { return area.norm() > parameters.least_area; }
    double speed(int axis, const Twist<D>& V) const { return size * V[axis] + spin.dot(V.template tail<spin_size<D>>()); }
};

/// What an area lends along an axis of its face: `size` goes to the next one and half of what the one after it bears, `more`, from there.
template <int D>
struct Loan {
    using Area = typename OpenAreas<D>::Area;
    Area own, next, after;
    int along;
    double offset; ///< of the own area's centroid from the middle of its face
    double size, more;

    double of_next() const { return size + 2 * more; }
    double of_after() const { return -more; }
    double given() const { return size + more; }
};

template <int D>
class Loans {
public:
    using Area = typename OpenAreas<D>::Area;

    Loans(const Grid<D>& grid, const Complex<D>& complex, const OpenAreas<D>& areas) : complex_(complex), areas_(areas)
    {
        for (int axis = 0; axis < D; ++axis)
            for (int i = complex.index.low[axis]; i < complex.index.high()[axis]; ++i)
                centre_[axis].push_back((grid.centre_place(axis, i) - grid.anchor()[axis]) / grid.dx());
    }

    /// Calls f(loan) for all that the area lends, above the given level, of which the piece k, of the face `face`, is the first. shares(): of the walls beside that area,
    /// whose sizes sum up to one.
    template <class F>
    void from(std::int32_t k, const Index<D>& face, const JoinLevel& level, F&& f)
    {
        const FacePiece<D>& piece = complex_.pieces[k];
        if (!piece.low.exists() || !piece.high.exists() || !(piece.area > 0))
            return;
        const std::optional<Area> own = areas_.led_by(k, level);
        if (!own)
            return;
        find_shares(k, *own);
        if (shares_.empty())
            return;
        for (int t = 0; t < D; ++t) {
            if (t == piece.axis)
                continue;
            const double offset = own->centroid[t] - centre_[t][face[t] - complex_.index.low[t]];
            const int towards = offset > 0 ? 1 : -1;
            const Area next = areas_.beside(piece.axis, *own, face, t, towards);
            if (next.face < 0 || !(next.area > 0))
                continue;
            const double lent = 0.5 * std::min(1.0, next.area / own->area) * own->area * std::abs(offset);
            const Area after = areas_.beside(piece.axis, *own, face, t, 2 * towards);
            const double more = after.face >= 0 && after.area > 0 ? 0.5 * lent * std::min(1.0, after.area / own->area) : 0.0;
            f(Loan<D>{*own, next, after, t, offset, lent, more});
        }
    }
    const std::vector<MovingShare<D>>& shares() const { return shares_; }

private:
    void find_shares(std::int32_t k, const Area& area)
    {
        const int axis = complex_.pieces[k].axis;
        shares_.clear();
        if (area.piece < 0)
            add_walls(complex_.pieces[k], area.level);
        else
            areas_.for_each(area, [&](std::int32_t piece) { add_walls(complex_.pieces[piece], area.level); });
        double sum = 0;
        for (const MovingShare<D>& share : shares_)
            sum += share.size;
        // A wall that turns moves with its speed along its normal: one that turns in itself lends nothing.
        for (MovingShare<D>& share : shares_) {
            share.size /= sum > 0 ? sum : 1;
            share.spin = (share.faces() ? share.size * share.area[axis] / share.area.squaredNorm() : 0.0) * share.moment;
        }
    }

    void add_walls(const FacePiece<D>& piece, const JoinLevel& level)
    {
        for (const PartOrCell& side : {piece.low, piece.high}) {
            if (!side.is_part())
                continue;
            const bool divided = areas_.divided(side.number(), level);
            for (const WallPatch<D>& patch : complex_.patches_of(side.number())) {
                auto share =
                    std::find_if(shares_.begin(), shares_.end(), [&](const auto& known) { return known.solid == patch.solid; });
                if (share == shares_.end())
                    share = shares_.insert(shares_.end(), {patch.solid, 0});
                share->size += patch.area.norm();
                if (!divided) {
                    share->area += patch.area;
                    share->moment += patch.moment;
                }
            }
        }
    }

    const Complex<D>& complex_;
    const OpenAreas<D>& areas_;
    std::array<std::vector<double>, D> centre_; ///< of cells along each axis, from the block's first one on
    std::vector<MovingShare<D>> shares_;
};

} // namespace gapflow
