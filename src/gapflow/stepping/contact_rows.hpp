// Rows of a contact and its state, as the parts of ContactSet share them (method, "Contact").
#pragma once

#include "gapflow/stepping/contact_set.hpp"

#include <vector>

namespace gapflow {

// In dx. Overlaps below the first are left; one of the second is removed in one pass. Surfaces this close count as near each other without approach.
constexpr double overlap_left = 1e-6, most_overlap = 0.1, cushion = 0.02;

// Whether a push along the row can move the solid: constraints may let it go only across.
template <int D>
bool yields(const Solid<D>& solid, const Twist<D>& row)
{
    return solid.motion == Motion::free && (solid.admissible * row).norm() > 1e-12 * row.norm();
}

template <int D>
double rate(const RelativeRow<D>& row, const Contact<D>& contact, const std::vector<Twist<D>>& twists)
{
    return row.a.dot(twists[contact.point.a]) + row.b.dot(twists[contact.point.b]);
}

// Adds a contact's impulse, friction included, to those on all solids, about their centres.
template <int D>
void add_impulse(const Contact<D>& c, std::vector<Twist<D>>& impulses)
{
    const auto add = [&](const RelativeRow<D>& row, double impulse) {
        impulses[c.point.a] += impulse * row.a;
        impulses[c.point.b] += impulse * row.b;
    };
    add(c.normal, c.impulse);
    for (int k = 0; k < D - 1; ++k)
        add(c.tangents[k], c.tangential[k]);
}

// Sliding friction turns with the slip: -bound (slip / |slip|). To first order this is a given impulse against the slip of the
// round before, and across it the resistance bound / |slip|, part of the solve: an explicit treatment diverges where bodies
// barely slide.
template <int D>
bool resists_turning(const Contact<D>& c)
{
    return D == 3 && c.closed && c.slides && c.sliding_impulse.squaredNorm() > 0;
}

// Open, sticks, slides.
template <int D>
char state_of(const Contact<D>& c)
{
    return static_cast<char>(c.closed + (c.closed && c.slides));
}

template <int D>
Vec<D - 1> across_pull(const Contact<D>& c)
{
    if constexpr (D == 3)
        return Vec<2>(-c.sliding_impulse[1], c.sliding_impulse[0]).normalized();
    else
        return Vec<1>::Zero();
}

template <int D>
RelativeRow<D> row_along(const Contact<D>& c, const Vec<D - 1>& direction)
{
    RelativeRow<D> row{Twist<D>::Zero(), Twist<D>::Zero()};
    for (int k = 0; k < D - 1; ++k) {
        row.a += direction[k] * c.tangents[k].a;
        row.b += direction[k] * c.tangents[k].b;
    }
    return row;
}

} // namespace gapflow
