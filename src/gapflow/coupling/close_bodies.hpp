// The layers of fluid beside bodies that are close to each other (complex, "The system": close bodies).
//
// With Y = K / Lambda the inertia of the layers is the sum of squares g (Y_P V + Y_Q V)^2 over the conductances g between rows P and Q, V the twists of all
// bodies: where two bodies have a row in common, or rows beside each other, they use the same fluid. An edge between rows of different bodies counts twice
// in Lambda. Then it has
//
//     g [2 (Y_P V)^2 + 2 (Y_Q V)^2 + (Y_P V + Y_Q V)^2],
//
// and the first two terms are each body's own.
#pragma once

#include "gapflow/coupling/fluid_rows.hpp"

#include <map>

namespace gapflow {

/// Rows of the bodies that may move.
template <int D>
class BodyLayers {
public:
    using Entry = typename BodyRows<D>::Entry;

    /// Collective.
    explicit BodyLayers(const Coupling<D>& coupling);

    const FluidRows<D>& rows() const { return L_; }
    bool moves(int solid) const { return moves_[solid]; }
    /// Of an own row, or one at a side of another rank: K of the bodies that move, in their order.
    std::span<const Entry> of(long row) const;
    /// Lambda of an own row.
    double bound(long row) const;
    /// Own rows of bodies that move.
    template <class F>
    void for_each_row(F&& f) const
    {
        for_each_index<D>(L_.grid().low(), L_.grid().high(), [&](const Index<D>& c) {
            if (!K_.of(L_.local(c)).empty() && !of(L_.row(c)).empty())
                f(L_.row(c));
        });
        for (int node = 0; node < L_.system().nodes; ++node)
            if (L_.system().owns(node) && !of(L_.row(node)).empty())
                f(L_.row(node));
    }
    /// Whether both rows have bodies, and not the same.
    bool differ(long a, long b) const;
    template <class Rows>
    bool differ(const Rows& all) const
    {
        long first = -1;
        for (const auto& [row, weight] : all)
            if (!of(row).empty()) {
                if (first >= 0 && differ(first, row))
                    return true;
                first = row;
            }
        return false;
    }
    /// Whether another rank may look at an own row.
    bool at_side(long row) const;

private:
    FluidRows<D> L_;
    BodyRows<D> K_;
    std::vector<char> moves_;
    std::vector<std::int32_t> moving_;          ///< entries of each own row of bodies that move
    std::map<long, std::vector<Entry>> beside_; ///< rows of other ranks
};

/// Where the layers of fluid that close bodies share do not bear what D takes from all of them together, coupling.seen_mass of those that need more than their own
/// share grows until they do. After limit_deficits(). Collective.
template <int D>
void limit_close_deficits(Coupling<D>& coupling);

} // namespace gapflow
