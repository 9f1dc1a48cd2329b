// Open areas of the grid's faces, and those beside them in the same plane of the grid.
#pragma once

#include "gapflow/complex/complex.hpp"
#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/grid/inline_vector.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

namespace gapflow {

/// What a link of the conductance g (times density; 3D: in cells) joins of its two parts: s = g/(1 + g), as a resistance of one beside its own. Links are ordered by it.
struct JoinLevel {
    double share = -1; ///< of all levels, -1: below all links
    std::int32_t link = -1;

    friend auto operator<=>(const JoinLevel&, const JoinLevel&) = default;
};
using JoinLevels = InlineVector<JoinLevel, 8>;

/// Pieces of a face that lead from one part to another one, lines from sharp corners not counted, taken together: so nothing jumps where a smooth wall comes
/// through the face; and what lies beside them in the plane of the grid. A corner's link joins its parts up to the level s: what depends on the areas is the integral over the
/// levels 0 .. 1, and so continuous where a link begins or ends. A face is
/// plain where all that is open of it joins the largest parts of two cells in one piece: Complex::main_area and main_of tell all of it.
template <int D>
class OpenAreas {
public:
    struct Area {
        std::int32_t piece = -1; ///< its first piece; -1: all that is open of a plain face
        std::int32_t face = -1;  ///< -1: none
        double area = 0;
        Vec<D> centroid = Vec<D>::Zero();
        JoinLevel level{}; ///< above which links join its pieces
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
        first_link_.assign(count + 1, 0);
        for (const CornerLink<D>& link : complex.links)
            ++first_link_[whole_[link.a] + 1];
        std::partial_sum(first_link_.begin(), first_link_.end(), first_link_.begin());
        links_.resize(complex.links.size());
        std::vector<std::int32_t> at(first_link_.begin(), first_link_.end() - 1);
        for (std::size_t k = 0; k < complex.links.size(); ++k)
            links_[at[whole_[complex.links[k].a]]++] = level_of(static_cast<std::int32_t>(k));
    }

    bool plain(int axis, int face) const { return first_[axis][face] >= none; }
    /// The first piece of a face, and the one after a piece; -1: none.
    std::int32_t first(int axis, int face) const { return decoded(first_[axis][face]); }
    std::int32_t next(std::int32_t piece) const { return next_[piece]; }

    /// Levels of the links on which the areas of a piece's face depend, and the walls beside it; in their order.
    void find_levels(std::int32_t piece, JoinLevels& levels) const
    {
        levels.clear();
        if (whole_.empty())
            return;
        const FacePiece<D>& p = complex_.pieces[piece];
        const auto add = [&](const FacePiece<D>& of) {
            for (const PartOrCell& side : {of.low, of.high})
                for (const JoinLevel& level : links_of(side))
                    if (std::find(levels.begin(), levels.end(), level) == levels.end())
                        levels.push_back(level);
        };
        if (plain(p.axis, p.face))
            add(p);
        else
            for (std::int32_t k = first(p.axis, p.face); k >= 0; k = next_[k])
                add(complex_.pieces[k]);
        std::sort(levels.begin(), levels.end());
    }

    /// The area to which a piece belongs, if that is its first one.
    std::optional<Area> led_by(std::int32_t piece, const JoinLevel& level) const
    {
        const FacePiece<D>& p = complex_.pieces[piece];
        if (plain(p.axis, p.face))
            return Area{-1, p.face, p.area, p.centroid, level};
        Area sum{piece, p.face, 0, Vec<D>::Zero(), level};
        for (std::int32_t k = first(p.axis, p.face); k >= 0; k = next_[k])
            if (same(k, piece, level)) {
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
            if (same(k, area.piece, area.level))
                f(k);
    }

    /// Whether a link joins a part with another one at a level: its wall patches have a dividing line that is none there.
    bool divided(std::int32_t part, const JoinLevel& level) const
    {
        for (const JoinLevel& of : links_of(PartOrCell::part(part)))
            if (of > level && (complex_.links[of.link].a == part || complex_.links[of.link].b == part))
                return true;
        return false;
    }

    /// The one of the face `steps` beyond f, that of the given area, along t whose centroid is nearest to its own across t; in 2D, where none
    /// lies across, along t. All links join it.
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
            return {-1, open > 0 ? face : -1, open, Vec<D>::Zero(), {}};
        }
        Area best;
        std::pair least{std::numeric_limits<double>::infinity(), 0.0}; // across: the same side of a thin solid; then along
        for (std::int32_t k = first(axis, face); k >= 0; k = next_[k])
            if (const std::optional<Area> area = led_by(k, {})) {
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
    JoinLevel level_of(std::int32_t link) const
    {

        const double g = complex_.links[link].conductance;
        return {g / (1 + g), link};
    }
    /// Links of all parts that links join with one.
    std::span<const JoinLevel> links_of(const PartOrCell& side) const
    {
        if (!side.is_part() || whole_.empty())
            return {};
        const int whole = whole_[side.number()];
        return {links_.data() + first_link_[whole], static_cast<std::size_t>(first_link_[whole + 1] - first_link_[whole])};
    }
    bool joined(const PartOrCell& a, const PartOrCell& b, const JoinLevel& level) const
    {
        if (a.code == b.code)
            return true;
        if (!a.is_part() || !b.is_part() || whole_.empty() || whole_[a.number()] != whole_[b.number()])
            return false;
        InlineVector<std::int32_t, 8> reached;
        reached.push_back(a.number());
        for (std::size_t k = 0; k < reached.size(); ++k)
            for (const JoinLevel& of : links_of(a)) {
                const CornerLink<D>& link = complex_.links[of.link];
                if (!(of > level) || (link.a != reached[k] && link.b != reached[k]))
                    continue;
                const std::int32_t other = link.a == reached[k] ? link.b : link.a;
                if (other == b.number())
                    return true;
                if (std::find(reached.begin(), reached.end(), other) == reached.end())
                    reached.push_back(other);
            }
        return false;
    }
    bool same(std::int32_t a, std::int32_t b, const JoinLevel& level) const
    {
        return a == b || (joined(complex_.pieces[a].low, complex_.pieces[b].low, level) &&
                          joined(complex_.pieces[a].high, complex_.pieces[b].high, level));
    }

    const Complex<D>& complex_;
    std::array<std::vector<std::int32_t>, D> first_; ///< piece of each face; -2 less it where the face is not plain
    std::vector<std::int32_t> next_;
    std::vector<int> whole_;               ///< of each part: those that links join have one number; empty: there are none
    std::vector<std::int32_t> first_link_; ///< of each such number in `links_`, and the end
    std::vector<JoinLevel> links_;
};

} // namespace gapflow
