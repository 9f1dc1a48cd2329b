// The rounds of a projection over its unilateral conditions (method, "Contact", "Voids: dry contact and cavitation"): contacts that hold or open,
// film nodes that are void or wet. Each round solves with the current sets, tests their conditions, and changes the states that
// violate them. Rough solves find the sets, exact ones confirm them.
#pragma once

#include "gapflow/stepping/contact_set.hpp"

#include <array>
#include <cstddef>

namespace gapflow {

class Rounds {
public:
    /// Whether there are contacts and voids at all. `expect_none`: they are not expected to change; the first solve is exact then.
    Rounds(bool contacts, bool voids, bool expect_none)
        : level_(contacts || voids ? 0 : rough_tolerances.size()), sets_(contacts || voids), expect_none_(expect_none),
          voids_changed_(voids)
    {
    }

    /// Number of the round under way, from 0.
    int number() const { return round_; }
    bool last() const { return round_ == most_rounds; }
    /// Whether the round's solve is to full tolerance.
    bool exact() const { return level_ == rough_tolerances.size() || (round_ == 0 && expect_none_); }
    /// Of the round's solve, relative. `full`: of one without sets; `holds`: something is held by contacts or voids.
    double tolerance(double full, bool holds) const;
    /// Contacts with negligible impulses may alternate without end, and the friction of contacts that share their force in many ways may follow
    /// shares that never settle: both grow with each exact solve.
    ContactAccuracy accuracy(double tolerance) const;
    /// Whether voids may change all at once; later, one at a time.
    bool voids_at_once() const { return round_ < void_rounds_at_once; }

    /// Whether the sets have changed since the last solve, so that the system is to be assembled anew.
    bool changed() const { return changed_; }
    /// Whether voids have.
    bool voids_changed() const { return voids_changed_; }
    /// To be called after a solve with its changes of contacts and voids. True if another round is to follow.
    bool go_on(ContactChange contacts, bool voids);
    /// Whether the rounds ended with sets that are still wrong.
    bool unsettled() const { return unsettled_; }

    static constexpr int most_rounds = 60;

private:
    // While contacts change, their solves go to this relative residual only; and so many times at most.
    static constexpr std::array<double, 3> rough_tolerances = {1e-2, 1e-4, 1e-6};
    static constexpr double least_accuracy = 1e-6, friction_accuracy = 1e-3, most_friction = 0.05;
    // Part of the tolerance once they do not change: the contacts' forces are small compared with the weights that the fluid
    // supports.
    static constexpr double settled_tolerance = 0.1;
    // Voids change all at once in the first rounds, then one at a time.
    static constexpr int void_rounds_at_once = 40;

    int round_ = 0;
    std::size_t level_;    ///< rough tolerances at which the sets did not change
    int exact_rounds_ = 0; ///< so far
    bool sets_, expect_none_, changed_ = true, voids_changed_, unsettled_ = false;
};

} // namespace gapflow
