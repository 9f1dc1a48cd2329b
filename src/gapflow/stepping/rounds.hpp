// The rounds of a projection over its unilateral conditions (method, "Contact", "Voids: dry contact and cavitation"): contacts that hold or open,
// film nodes that are void or wet. Each round solves with the current sets, tests their conditions, and changes the states that
// violate them. Rough solves find the sets, exact ones confirm them.
#pragma once

#include "gapflow/stepping/contact_set.hpp"

namespace gapflow {

class Rounds {
public:
    /// Whether there are contacts and voids at all. `expect_none`: they are not expected to change; the first solve is exact then.
    Rounds(bool contacts, bool voids, bool expect_none)
        : rough_((contacts || voids) && !expect_none), sets_(contacts || voids), voids_changed_(voids)
    {
    }

    /// Number of the round under way, from 0.
    int number() const { return round_; }
    bool last() const { return round_ == most_rounds; }
    /// Whether the round's solve is to full tolerance.
    bool exact() const { return !rough_; }
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
    /// Of the sets, over the tolerance of the solve that they are found with.
    static constexpr double accuracy_over_tolerance = 10;

private:
    // Relative residual of the solves while contacts or voids change.
    static constexpr double rough_tolerance = 1e-3;
    static constexpr double least_accuracy = 1e-6, friction_accuracy = 1e-3, most_friction = 0.05;
    // Part of the tolerance once they do not change: the contacts' forces are small compared with the weights that the fluid
    // supports.
    static constexpr double settled_tolerance = 0.1;
    // Voids change all at once in the first rounds, then one at a time.
    static constexpr int void_rounds_at_once = 40;

    int round_ = 0, exact_rounds_ = 0; ///< so far
    bool rough_, sets_, changed_ = true, voids_changed_, unsettled_ = false;
};

} // namespace gapflow
