// What bounds the energy of films: transport adds none, mouths' heads get what the film gave away.
#include "film_scene.hpp"

#include "gapflow/film/film_energy.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow::test {
namespace {

using Transported = FilmHistory<2>::Transported;

/// The film of two plates at rest, with the history of flow along it.
struct Channel {
    explicit Channel(double gap = 0.2) : scene(10)
    {
        scene.add_box("lower", {3, 2}, {7, 4.5 - gap});
        scene.add_box("upper", {3, 4.5}, {7, 7});
        scene.clip();
        network = scene.network();
    }
    const Film<2>& film() const { return network.films.front(); }
    const std::vector<FilmElement<2>>& elements() const { return film().mesh.elements; }
    const std::vector<Mouth<2>>& mouths() const { return network.rim.mouths; }
    std::vector<Vec<2>> flow(const std::function<double(double)>& speed) const
    {
        std::vector<Vec<2>> u;
        for (const FilmElement<2>& e : elements())
            u.push_back(speed(e.centroid[0]) * unit<2>(0));
        return u;
    }
    FilmHistory<2> remember(const std::vector<Vec<2>>& u) const
    {
        return {scene.solids()[film().pair.master], Twist<2>::Zero(), {&film()}, u, {}, {}, 1.0};
    }
    double motion(const std::vector<Vec<2>>& u) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < u.size(); ++i)
            sum += elements()[i].volume * u[i].squaredNorm();
        return sum;
    }

    FilmScene<2> scene;
    FilmNetwork<2> network;
};

/// What the old film carried to one place: nothing but that it was there.
Transported carried(const Vec<2>& velocity = Vec<2>::Zero())
{
    return {velocity, unit<2>(1), true, false, 1e9};
}

GivenAwayOf limit(const Channel& now, const FilmHistory<2>& old, std::vector<Vec<2>>& u,
                  const std::vector<Transported>& at_mouth, double dt = 0, double beyond_x = 1e9)
{
    std::vector<Transported> at_element(u.size(), carried());
    for (std::size_t i = 0; i < u.size(); ++i)
        at_element[i].beyond = now.elements()[i].centroid[0] > beyond_x;
    const GivenAway<2> given = limit_motion<2>(now.network, now.scene.solids(), {&old}, at_element, at_mouth, dt, u);
    return given.at(&old);
}

TEST(FilmEnergy, WhatTransportTakesIsGivenAway)
{
    const Channel channel;
    ASSERT_EQ(channel.mouths().size(), 2u);
    const std::vector<Vec<2>> start = channel.flow([](double) { return 1.0; });
    const FilmHistory<2> old = channel.remember(start);
    std::vector<Vec<2>> u = channel.flow([](double x) { return x < 5 ? 0.5 : 0.9; });
    const std::vector<Vec<2>> before = u;
    const GivenAwayOf given = limit(channel, old, u, {2, carried()});
    EXPECT_EQ(u, before);
    EXPECT_NEAR(given.energy, channel.motion(start) - channel.motion(u), 1e-12);
    EXPECT_NEAR(given.energy, 0.2 * 4 - 0.2 * 2 * (0.25 + 0.81), 1e-9);
    EXPECT_NEAR(given.closing, 0, 1e-12);
}

// Energy that would be gained is cut from the fastest alone, to what there was.
TEST(FilmEnergy, WhatWouldBeGainedIsTakenFromTheFastest)
{
    const Channel channel;
    const FilmHistory<2> old = channel.remember(channel.flow([](double) { return 1.0; })); // 0.2 * 4
    const auto fast = [](double x) { return x > 6 ? -3.0 : x > 5 ? 2.0 : 0.5; };
    std::vector<Vec<2>> u = channel.flow(fast);
    const GivenAwayOf given = limit(channel, old, u, {2, carried()});
    EXPECT_NEAR(channel.motion(u), old.motion(), 1e-12);
    EXPECT_EQ(given.energy, 0);
    const double cut = std::sqrt((4 - 2 * 0.25) / 2);
    for (std::size_t i = 0; i < u.size(); ++i) {
        const double was = fast(channel.elements()[i].centroid[0]);
        EXPECT_NEAR(u[i][0], std::copysign(std::min(std::abs(was), cut), was), 1e-9);
        EXPECT_EQ(u[i][1], 0);
    }
    // Where the film is new it may bring its share.
    std::vector<Vec<2>> grown = channel.flow([](double) { return 2.0; });
    limit(channel, old, grown, {2, carried()}, 0, 6);
    EXPECT_NEAR(channel.motion(grown), 1.25 * old.motion(), 1e-9);
}

// Over a step the bound grows by a quarter for each element that the flow crosses, a twentieth at most.
TEST(FilmEnergy, GrowsByATwentiethAtMost)
{
    const Channel channel;
    const FilmHistory<2> old = channel.remember(channel.flow([](double) { return 1.0; }));
    const double size = 4.0 / static_cast<double>(channel.elements().size());
    for (double ways : {0.1, 10.0}) {
        std::vector<Vec<2>> u = channel.flow([](double) { return 2.0; });
        const GivenAwayOf given = limit(channel, old, u, {2, carried()}, ways * size);
        EXPECT_NEAR(channel.motion(u) / old.motion(), ways < 1 ? 1.025 : 1.05, 1e-9);
        EXPECT_EQ(given.energy, 0);
    }
}

// What flows in brings its energy: its flux over the step, at its speed; that of the mouth where it was slower.
TEST(FilmEnergy, InflowBringsItsOwn)
{
    const Channel channel;
    FilmHistory<2> old = channel.remember(channel.flow([](double) { return 1.0; }));
    const double dt = 0.01, grown = 1 + 0.25 * dt / (4.0 / static_cast<double>(channel.elements().size()));
    const std::vector<Transported> at_mouth(2, carried({3, 0})); // in at one end, out at the other
    for (const bool known : {false, true}) {
        const double speed = known ? 2.0 : 3.0;
        if (known)
            for (const Mouth<2>& c : channel.mouths())
                old.mouths.push_back({channel.scene.solids()[channel.film().pair.master].shape.to_body(c.x), c.outward, c.h,
                                      c.h * 2.0 * c.outward[0], Vec<2>::Zero(), c.kind});
        std::vector<Vec<2>> u = channel.flow([](double) { return 9.0; });
        limit(channel, old, u, at_mouth, dt);
        EXPECT_NEAR(channel.motion(u), grown * old.motion() + 0.2 * dt * speed * speed * speed, 1e-9) << known;
    }
}

// A film that has become thinner says by how much.
TEST(FilmEnergy, ClosingIsThePartOfTheThicknessThatTheStepTook)
{
    const Channel before(0.2), after(0.15);
    const FilmHistory<2> old = before.remember(before.flow([](double) { return 1.0; }));
    std::vector<Vec<2>> u = after.flow([](double) { return 0.0; });
    const GivenAwayOf given = limit(after, old, u, {2, carried()});
    EXPECT_NEAR(given.closing, 0.25, 1e-9);
    EXPECT_NEAR(given.energy, old.motion(), 1e-12);
    u.assign(before.elements().size(), Vec<2>::Zero());
    EXPECT_EQ(limit(before, after.remember(after.flow([](double) { return 1.0; })), u, {2, carried()}).closing, 0); // it opens
}

// Heads do the work 2 sum R / l q dq at most that the film gave away; with less they all shrink alike.
TEST(FilmEnergy, HeadsWorkWithWhatWasGivenAway)
{
    const Channel channel;
    const FilmHistory<2> old = channel.remember(channel.flow([](double) { return 1.0; }));
    const std::vector<double> flux{0.3, 0.2}, head{0.05, 0.0};
    const double asked = 2 * channel.mouths()[0].resistance * flux[0] * head[0];
    for (const double share : {0.0, 0.25, 1.0, 100.0}) {
        std::vector<double> q = flux;
        add_heads<2>(channel.network, channel.scene.solids(), {&old}, {{&old, {share * asked, 0}}}, head, q);
        EXPECT_NEAR(q[0], flux[0] + std::min(share, 1.0) * head[0], 1e-12) << share;
        EXPECT_EQ(q[1], flux[1]);
    }
    std::vector<double> q = flux;
    add_heads<2>(channel.network, channel.scene.solids(), {&old}, {}, head, q); // nothing known: nothing given
    EXPECT_EQ(q, flux);
    // While the film closes by r: 3 r / (1 - (1 - r) (1 - r + r^2 / 2)^2) of it. r = 1/2: 1.5 / (1 - 0.5 * 0.390625).
    q = flux;
    add_heads<2>(channel.network, channel.scene.solids(), {&old}, {{&old, {0.25 * asked, 0.5}}}, head, q);
    EXPECT_NEAR(q[0] - flux[0], 0.25 * 1.5 / (1 - 0.5 * 0.390625) * head[0], 1e-12);
}

// Where a mouth hardly flows, the work of its head is small, but not the energy of what the head throws out: ten times what was given at most.
TEST(FilmEnergy, HeadsThrowOutNoFlood)
{
    const Channel channel;
    const FilmHistory<2> old = channel.remember(channel.flow([](double) { return 1.0; }));
    const double R = channel.mouths()[0].resistance, film = 4 / (3 * 0.4); // length over 3 h, both mouths
    const double head = 2, thrown = R * head * head * R / (R + film), given = thrown / 40;
    std::vector<double> q{0, 0};
    add_heads<2>(channel.network, channel.scene.solids(), {&old}, {{&old, {given, 0}}}, {head, 0}, q);
    EXPECT_NEAR(q[0], 0.5 * head, 1e-9);
}

} // namespace
} // namespace gapflow::test
