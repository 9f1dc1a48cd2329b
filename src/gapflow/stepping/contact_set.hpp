// Contacts of a step (method, "Contact"): which hold, which stick or slide, and their impulses. The active set of
//
//     0 <= Lambda_c  |  C_c V - least_c >= 0,      least_c = -(distance - hold) / dt, or the rebound -e C_c V^n
//     |Lambda_t| <= mu Lambda_c,  Lambda_t against the slip
//
// around the coupled solve: contacts that hold are constraints of the bodies' response (HeldContact), sliding ones exert a
// given impulse.
#pragma once

#include "gapflow/body/contact_points.hpp"
#include "gapflow/body/rigid_body.hpp"
#include "gapflow/core/state_archive.hpp"
#include "gapflow/coupling/coupling.hpp"
#include "gapflow/coupling/film_inertia.hpp"
#include "gapflow/scene/scene.hpp"
#include "gapflow/stepping/contact_secants.hpp"

#include <array>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace gapflow {

/// What impacts change of a velocity counts as nothing below this share of what forces change in the step.
constexpr double slight_impact = 0.05;

template <int D>
struct ContactImpulse {
    double normal = 0;
    Vec<D - 1> tangential = Vec<D - 1>::Zero();
    bool slides = false; ///< friction is at its bound; of a forecast only
};

template <int D>
struct Contact {
    ContactPoint<D> point;
    double hold = 0; ///< distance at which surfaces that near each other meet: thickness or roughness
    double least_distance =
        0; ///< below which they overlap: the same, or what the scene placed the pair closer with an automatic roughness
    double restitution = 0, friction = 0;
    RelativeRow<D> normal;
    std::array<RelativeRow<D>, D - 1> tangents;
    double approach = 0; ///< opening rate before the step
    double gained = 0;   ///< its change by the explicit forces in the step, magnitude
    double forced = 0;   ///< change of the whole relative velocity by them
    double least = 0;    ///< opening rate that the end of the step may not fall below
    double target = 0;   ///< opening rate while it holds: `least`, or a rebound
    bool closed = false, was_closed = false;
    bool slides = false;
    Vec<D - 1> sliding_impulse = Vec<D - 1>::Zero(); ///< friction impulse on a along the tangents while it slides
    Vec<D - 1> lack =
        Vec<D - 1>::Zero(); ///< change of `sliding_impulse` that the last round asked for; 0: did not slide before
    double slip = 0;        ///< speed at which it slides
    double impulse = 0;     ///< normal, on a, over the step
    Vec<D - 1> tangential = Vec<D - 1>::Zero(); ///< friction impulse on a
    ContactImpulse<D> expected;   ///< while it holds: what redundant contacts' shares of a solve are the nearest to
    Vec<D> mark = Vec<D>::Zero(); ///< place on a in a's frame, to identify the contact in the next step
};

/// What counts as nothing when the laws of contact are tested.
struct ContactAccuracy {
    double contact = 0;  ///< impulses and speeds, of the largest ones
    double friction = 0; ///< sliding friction, of the largest bound of friction on the body
    double noticed = 1;  ///< part of these beyond which a change is made, although it is within them
};

/// Change of the contacts after a solve: `slight`: within the accuracy; `friction`: the states are the same, but sliding friction changes; `repeats`: the
/// states are those of an earlier round.
enum class ContactChange { none, slight, friction, states, repeats };

template <int D>
class ContactSet {
public:
    ContactSet() = default;
    /// Features of all solids, at the scene's start; pairs take their settings from the scene.
    ContactSet(const Scene& scene, const Grid<D>& grid, const std::vector<Solid<D>>& solids);

    /// Of a grid that has moved.
    void move_domain(const Grid<D>& grid);
    /// Finds the contacts of a configuration that may close in dt; those known from the step before keep their state.
    void find(const std::vector<Solid<D>>& solids, const std::vector<Twist<D>>& twists, double dt);
    /// Removes overlaps by moving free bodies, without a change of momentum; `at_start`: in the metric without masses. True if
    /// anything
    /// moved; to be repeated, with the contacts found anew, until it is false.
    bool separate(std::vector<RigidBody<D>>& bodies, bool at_start = false) const;
    /// Sets the condition of each contact in the step: `before`: twists at its start; `forced`: with the explicit forces of the
    /// step; `expected`: at its end without contact. Sliding friction of the last step, of length `last_dt`, is taken over.
    void prepare(const std::vector<Twist<D>>& before, const std::vector<Twist<D>>& forced,
                 const std::vector<Twist<D>>& expected, double dt, double last_dt);
    /// Whether the current states violate the laws at the twists expected at the step's end: then rough solves find the states
    /// first.
    bool likely_to_change(const std::vector<Twist<D>>& expected) const;
    /// Rows of the contacts that hold: normal, then tangents of those that stick.
    std::vector<HeldContact<D>> held() const;
    /// Impulses of sliding friction on every solid, about its centre.
    std::vector<Twist<D>> sliding_impulses(std::size_t solids) const;
    /// Takes the twists and the impulses of held() that a solve gave, to full tolerance if `exact`. Unless nothing changes the solve must be
    /// repeated.
    ContactChange update(const std::vector<Twist<D>>& twists, const Eigen::VectorXd& impulses, const NearInertia<D>& inertia,
                         const ContactAccuracy& accuracy, bool exact, int round);

    /// Adds the impulses that the same contacts had in an earlier solve of the step.
    void add_impulses(const ContactSet& earlier);

    /// What earlier rounds told holds no more: voids or links of films have changed.
    void forget_rounds();

    /// A held contact that closes: its solids are driven into each other, and neither can give way. Null: none.
    const Contact<D>* crushed(const std::vector<Twist<D>>& twists, double dt) const;
    /// Whether a prescribed body moves that the contact's solids are, or are held by.
    bool driven(const Contact<D>& contact, const std::vector<Solid<D>>& solids, const std::vector<Twist<D>>& twists) const;

    const std::vector<Contact<D>>& contacts() const { return contacts_; }
    /// Of all solids.
    const std::vector<ContactFeatures<D>>& features() const { return features_; }
    bool empty() const { return contacts_.empty(); }
    /// Whether a contact of these two solids rebounds in the step.
    bool rebounds(int a, int b) const;
    /// The contacts of these two solids do not rebound in the step.
    void hold_back(int a, int b);
    /// Whether a contact of this solid closed, opened, rebounded or was brought to rest in the step: then the change of its
    /// twist is not an acceleration to extrapolate.
    bool impact_on(int solid) const;
    /// Impulses of the contacts with an impact on every solid, friction included, about its centre.
    std::vector<Twist<D>> impact_impulses(std::size_t solids) const;
    /// The contacts of the last step.
    void list_state(StateArchive& archive);

private:
    struct PairLaw {
        double hold, least_distance, restitution, friction;
    };
    PairLaw law(int a, int b) const;
    double thickest() const;
    std::vector<Twist<D>> displacements(const std::vector<RigidBody<D>>& bodies, bool evenly, double longest,
                                        double accuracy) const;
    bool goes_too_far(const std::vector<RigidBody<D>>& bodies, const std::vector<Twist<D>>& moved, double longest) const;
    void take_impulses(const Eigen::VectorXd& impulses);
    void limit_rebounds(const std::vector<Twist<D>>& twists);
    using States = std::vector<char>; ///< of each contact: open, sticks, slides
    bool repeats(const States& next, bool exact);

    const Scene* scene_ = nullptr;
    double dx_ = 0;
    Vec<D> low_, high_, period_;
    std::vector<std::string> names_;
    std::vector<ContactFeatures<D>> features_;
    std::map<std::pair<int, int>, double> placed_; ///< distances of pairs that the scene places closer than they are held
    std::vector<Contact<D>> contacts_;
    double relaxation_ = 1; ///< of the pulls in the step's last round
    std::set<States> seen_; ///< used in the step's last solves, since the last change of tolerance
    bool seen_exact_ = false;
    void remember(const std::vector<Twist<D>>& twists);
    SecantMemory secants_;                                  ///< of the step's exact solves
    double left_ = std::numeric_limits<double>::infinity(); ///< what was wrong in the last round if that was exact
    int repetitions_ = 0;                                   ///< of states of exact solves in the step
    bool one_at_a_time_ = false;
};

} // namespace gapflow
