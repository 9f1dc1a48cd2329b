#include "gapflow/stepping/rounds.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

double Rounds::tolerance(double full, bool holds) const
{
    if (!exact())
        return std::max(full, rough_tolerances[level_]);
    return holds ? settled_tolerance * full : full;
}

ContactAccuracy Rounds::accuracy(double tolerance) const
{
    return {std::max(10 * tolerance, least_accuracy * std::exp2(0.5 * exact_rounds_)),
            std::min(friction_accuracy * std::exp2(exact_rounds_), most_friction)};
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
    if (round_ > most_rounds / 2)
        level_ = rough_tolerances
                     .size(); // full tolerance: the fluid's balance then holds even if the contacts' states do not converge
    else if (!exactly && !voids && contacts != ContactChange::states)
        ++level_; // sliding friction alone changes: use the next tolerance
    ++round_;
    return true;
}

} // namespace gapflow
