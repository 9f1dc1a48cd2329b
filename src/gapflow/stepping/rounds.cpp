#include "gapflow/stepping/rounds.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

double Rounds::tolerance(double full, bool holds) const
{
    if (!exact())
        return std::max(full, rough_tolerance);
    return holds ? settled_tolerance * full : full;
}

ContactAccuracy Rounds::accuracy(double tolerance) const
{
    return {std::max(accuracy_over_tolerance * tolerance, least_accuracy * std::exp2(0.5 * exact_rounds_)),
            std::min(friction_accuracy * std::exp2(exact_rounds_), most_friction),
            rough_ ? 1 / accuracy_over_tolerance : 1.0}; // what a rough solve tells for certain need not wait for the exact one
}

bool Rounds::go_on(ContactChange contacts, bool voids)
{
    if (!sets_)
        return false;
    const bool exactly = exact();
    exact_rounds_ += exactly;
    voids_changed_ = voids;
    changed_ = voids || contacts != ContactChange::none;
    unsettled_ = last();
    if (unsettled_ || (exactly && !changed_))
        return false;
    // Sliding friction alone changes, or what a rough solve hardly tells; or nothing settles: the fluid's balance is to hold even so.
    if (round_ > most_rounds / 2 || (!voids && contacts != ContactChange::states))
        rough_ = false;
    ++round_;
    return true;
}

} // namespace gapflow
