// Named arrays that store and restore an object: one list of members for both, and what does not fit is refused.
#include "gapflow/core/state_archive.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace gapflow {
namespace {

struct Part {
    int number = 0;
    std::vector<double> values;
    bool operator==(const Part&) const = default;
};

struct Whole {
    double time = 0;
    bool wet = false;
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    Eigen::VectorXd nodes;
    std::vector<Eigen::Vector2d> places;
    std::vector<Part> parts;

    void list_state(StateArchive& archive)
    {
        archive("time", time);
        archive("wet", wet);
        archive("pull", pull);
        archive("nodes", nodes);
        archive("places", places);
        archive.each("parts", parts, [](StateArchive& a, Part& part) {
            a("number", part.number);
            a("values", part.values);
        });
    }
};

Whole example()
{
    Whole whole;
    whole.time = 0.1;
    whole.wet = true;
    whole.pull = {1, -2, 1e-300};
    whole.nodes = Eigen::VectorXd::LinSpaced(4, 0, 1);
    whole.places = {{1, 2}, {3, 4}};
    whole.parts = {{7, {0.5}}, {-1, {}}, {3, {1, 2, 3}}};
    return whole;
}

StoredState stored(Whole whole)
{
    StoredState state;
    StateArchive archive(state);
    whole.list_state(archive);
    return state;
}

TEST(StateArchive, GivesBackWhatWasStored)
{
    const Whole whole = example();
    const StoredState state = stored(whole);
    EXPECT_EQ(state.numbers.at("parts/values"), (std::vector<double>{0.5, 1, 2, 3}));
    Whole other;
    other.parts.resize(9);
    StateArchive archive(state);
    EXPECT_TRUE(archive.restoring());
    other.list_state(archive);
    EXPECT_NO_THROW(archive.finish());
    EXPECT_EQ(other.time, whole.time);
    EXPECT_EQ(other.wet, whole.wet);
    EXPECT_EQ(other.pull, whole.pull);
    EXPECT_EQ(other.nodes, whole.nodes);
    EXPECT_EQ(other.places, whole.places);
    EXPECT_EQ(other.parts, whole.parts);
}

TEST(StateArchive, RefusesAStateWithLessOrMore)
{
    StoredState less = stored(example());
    less.numbers["parts/values"].pop_back();
    Whole other;
    StateArchive of_less(std::as_const(less));
    EXPECT_THROW(other.list_state(of_less), StateError);

    StoredState more = stored(example());
    more.numbers["parts/values"].push_back(1);
    StateArchive of_more(std::as_const(more));
    EXPECT_NO_THROW(other.list_state(of_more));
    EXPECT_THROW(of_more.finish(), StateError);
}

TEST(StateArchive, RefusesWhatIsNotAsExpected)
{
    StoredState state;
    StateArchive(state).expect("mass", 2.0);
    EXPECT_NO_THROW(StateArchive(std::as_const(state)).expect("mass", 2.0));
    EXPECT_THROW(StateArchive(std::as_const(state)).expect("mass", 2.01), StateError);
}

} // namespace
} // namespace gapflow
