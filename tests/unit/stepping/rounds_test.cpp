// The rounds over contacts and voids: rough solves find the sets, exact ones confirm them, and what never settles ends.
#include "gapflow/stepping/rounds.hpp"

#include <gtest/gtest.h>

namespace gapflow {
namespace {

constexpr double full = 1e-8;

TEST(Rounds, OneFullSolveWithoutSets)
{
    Rounds rounds(false, false, false);
    EXPECT_TRUE(rounds.exact() && rounds.changed());
    EXPECT_FALSE(rounds.voids_changed());
    EXPECT_EQ(rounds.tolerance(full, false), full);
    EXPECT_FALSE(rounds.go_on(ContactChange::none, false));
    EXPECT_FALSE(rounds.unsettled());
}

TEST(Rounds, SetsThatAreExpectedToStayAreSolvedForExactlyAtOnce)
{
    Rounds rounds(true, false, true);
    EXPECT_TRUE(rounds.exact());
    EXPECT_LT(rounds.tolerance(full, true), full); // what holds is small against the weights that the fluid holds
    EXPECT_FALSE(rounds.go_on(ContactChange::none, false));
}

// A rough solve that changes no state is followed by an exact one, and an exact one that changes nothing ends the rounds.
TEST(Rounds, ToleranceFallsAsTheSetsSettle)
{
    Rounds rounds(true, false, false);
    const double rough = rounds.tolerance(full, true);
    EXPECT_LT(rough, 1);
    EXPECT_TRUE(rounds.go_on(ContactChange::none, false));
    EXPECT_TRUE(rounds.exact());
    EXPECT_LT(rounds.tolerance(full, true), rough);
    EXPECT_FALSE(rounds.changed()); // the system stands
    EXPECT_FALSE(rounds.go_on(ContactChange::none, false));
    EXPECT_FALSE(rounds.unsettled());
}

// What a rough solve tells beyond its own error is made at once; the exact solve that follows tests it.
TEST(Rounds, SlightChangesAreMadeAndSolvedForExactly)
{
    Rounds rounds(true, false, false);
    const double rough = rounds.tolerance(full, true);
    const ContactAccuracy accuracy = rounds.accuracy(rough);
    EXPECT_NEAR(accuracy.noticed * accuracy.contact, rough, 1e-12);
    EXPECT_TRUE(rounds.go_on(ContactChange::slight, false));
    EXPECT_TRUE(rounds.changed() && rounds.exact());
    EXPECT_EQ(rounds.accuracy(full).noticed, 1);
    EXPECT_TRUE(rounds.go_on(ContactChange::states, false)); // no rough solve again
    EXPECT_TRUE(rounds.exact());
}

TEST(Rounds, ChangesOfStateKeepTheToleranceRough)
{
    Rounds rounds(true, true, false);
    EXPECT_TRUE(rounds.voids_changed()); // their first set is to be taken out of the system
    const double rough = rounds.tolerance(full, true);
    EXPECT_TRUE(rounds.go_on(ContactChange::states, false));
    EXPECT_TRUE(rounds.changed());
    EXPECT_FALSE(rounds.voids_changed());
    EXPECT_EQ(rounds.tolerance(full, true), rough);
    EXPECT_TRUE(rounds.go_on(ContactChange::none, true));
    EXPECT_TRUE(rounds.changed() && rounds.voids_changed());
    EXPECT_EQ(rounds.tolerance(full, true), rough);
    EXPECT_TRUE(rounds.go_on(ContactChange::friction, false));
    EXPECT_LT(rounds.tolerance(full, true), rough); // sliding pulls settle on the way
}

// What flips for ever is solved for exactly in the second half, counts for less as it repeats, and ends unsettled.
TEST(Rounds, WhatNeverSettlesEnds)
{
    Rounds rounds(true, true, false);
    double accuracy = 0;
    int count = 1;
    while (rounds.go_on(ContactChange::repeats, false)) {
        ++count;
        if (rounds.number() > Rounds::most_rounds / 2 + 1) {
            EXPECT_TRUE(rounds.exact());
            EXPECT_GT(rounds.accuracy(full).contact, accuracy);
            accuracy = rounds.accuracy(full).contact;
        }
    }
    EXPECT_EQ(count, Rounds::most_rounds + 1);
    EXPECT_TRUE(rounds.last() && rounds.unsettled());
    EXPECT_FALSE(rounds.voids_at_once());
}

} // namespace
} // namespace gapflow
