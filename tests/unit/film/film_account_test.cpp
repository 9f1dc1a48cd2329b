// The account of the films' energy: what transport and heads did is known after the projection, and no energy escapes it.
#include "gapflow/film/film_account.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <random>

namespace gapflow::test {
namespace {

constexpr FilmPair<2> first_pair{0, 1, {}}, second_pair{2, 3, {}};

/// Two pairs: the first has two films, of 2 elements and 1, the second has one. A mouth each: outflow, inflow, outflow.
struct Account {
    Account()
    {
        add(first_pair, {2, 3});
        add(first_pair, {0.5});
        add(second_pair, {1.5});
        for (int film = 0; film < 3; ++film) {
            Mouth<2> m{};
            m.film = film;
            m.resistance = 0.4 + 0.3 * film;
            m.length = 1.5 - 0.4 * film;
            network.rim.mouths.push_back(m);
        }
        account.gain = {0.3, -0.2, 0.15};
        account.owed = {{first_pair, 0.25}, {second_pair, 0.05}};
        account.before = {{first_pair, 1.5}, {second_pair, 1.25}};
        account.planned = {{first_pair, 0.0}, {second_pair, 0.0}};
        std::mt19937 random(11);
        for (int i = 0; i < network.elements; ++i) {
            account.reference.push_back(some(random));
            account.master.push_back(some(random));
            account.transported.push_back(some(random));
            velocity.push_back(some(random));
        }
        for (int r = 0; r < 3; ++r) {
            account.predicted.push_back(some(random)[0]);
            account.carried.push_back(some(random)[0]);
            account.kept.push_back(some(random)[0]);
            mouth.push_back(some(random)[0]);
        }
    }
    static Vec<2> some(std::mt19937& random)
    {
        std::normal_distribution<double> normal;
        return {normal(random), 0};
    }
    void add(const FilmPair<2>& pair, const std::vector<double>& volumes)
    {
        Film<2> film{pair, {}, 0.5, 0, network.elements};
        for (double volume : volumes) {
            film.mesh.elements.emplace_back();
            film.mesh.elements.back().volume = volume;
        }
        network.elements += static_cast<int>(volumes.size());
        network.films.push_back(film);
    }
    /// No film moves against its master, and no mouth has a flux.
    void rest()
    {
        account.reference = account.transported = velocity = account.master;
        mouth = account.carried;
        account.kept.assign(3, 0.0);
        account.gain.assign(3, 0.0);
    }
    std::vector<Vec<2>> increment;
    FilmDebts<2> settle(double dt = 0.1) { return settle_films<2>(network, account, velocity, mouth, dt, increment); }
    std::set<FilmPair<2>> mispredicted() const { return mispredicted_films<2>(network, account, velocity, mouth); }

    FilmNetwork<2> network;
    FilmAccount<2> account;
    std::vector<Vec<2>> velocity;
    std::vector<double> mouth;
};

// By hand, one contribution at a time: the volume times the velocity relative to the master times what transport changed.
TEST(FilmAccount, DebtIsTheWorkOfTransport)
{
    Account a;
    a.rest();
    a.account.master[1] = {5, 0};
    a.account.reference[1] = {6, 0};
    a.account.transported[1] = {6.5, 0};
    a.velocity[1] = {7, 0};
    const FilmDebts<2> debts = a.settle();
    EXPECT_NEAR(debts.at(first_pair), 1.5 + 3 * 2 * 0.5, 1e-12);
    EXPECT_NEAR(debts.at(second_pair), 1.25, 1e-12);
    EXPECT_NEAR((a.increment[1] - Vec<2>(10, 0)).norm(), 0, 1e-12); // over what was put in place, in a step of 0.1
    EXPECT_NEAR(a.increment[0].norm(), 0, 1e-12);
}

// R dq q: at outflow dq = a (2 q_p - q), at inflow dq = a q with a < 0.
TEST(FilmAccount, DebtIsTheWorkOfHeads)
{
    for (int r : {0, 1, 2}) {
        Account a;
        a.rest();
        const double gain = a.account.gain[r] = r == 1 ? -0.2 : 0.3;
        a.account.predicted[r] = 0.7;
        a.mouth[r] = a.account.carried[r] + 0.9;
        const FilmPair<2> pair = r == 2 ? second_pair : first_pair;
        const double R = a.network.rim.mouths[r].resistance / a.network.rim.mouths[r].length;
        EXPECT_NEAR(a.settle().at(pair) - a.account.before.at(pair), R * gain * 0.9 * (r == 1 ? 0.9 : 0.5), 1e-12) << r;
    }
}

// Whatever the projection is: u* = u_D + k and the heads' q* are projected, orthogonally in kinetic energy with the mouths' resistances
// multiplied by 1 + |a|; the films then have no more energy than was put in place and the account says.
TEST(FilmAccount, NoEnergyEscapes)
{
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    double least = 1e300;
    for (int trial = 0; trial < 200; ++trial) {
        Account a;
        const int elements = a.network.elements, n = elements + 3;
        for (Vec<2>& u : a.account.transported)
            u = Account::some(random);
        Eigen::VectorXd mass(n), start(n), before(n); // relative to the master
        for (const Film<2>& film : a.network.films)
            for (std::size_t k = 0; k < film.mesh.elements.size(); ++k) {
                const std::size_t i = film.first_element + k;
                mass[i] = film.mesh.elements[k].volume;
                before[i] = (a.account.reference[i] - a.account.master[i])[0];
                start[i] = (a.account.transported[i] - a.account.master[i])[0];
            }
        Eigen::VectorXd inertia = mass;
        for (int r = 0; r < 3; ++r) {
            const Mouth<2>& m = a.network.rim.mouths[r];
            const double gain = a.account.gain[r], q = a.account.kept[r];
            before[elements + r] = q;
            start[elements + r] = (q + (gain > 0 ? 2 * gain * a.account.predicted[r] : 0.0)) / (1 + std::abs(gain));
            mass[elements + r] = m.resistance / m.length;
            inertia[elements + r] = m.resistance / m.length * (1 + std::abs(gain));
        }
        const int space = 1 + trial % n; // of this dimension
        Eigen::MatrixXd basis(n, space);
        for (int i = 0; i < basis.size(); ++i)
            basis(i) = normal(random);
        const Eigen::MatrixXd weighted = inertia.asDiagonal() * basis;
        const Eigen::VectorXd after = basis * (basis.transpose() * weighted).ldlt().solve(weighted.transpose() * start);
        for (int i = 0; i < elements; ++i)
            a.velocity[i] = a.account.master[i] + Vec<2>(after[i], 0);
        for (int r = 0; r < 3; ++r)
            a.mouth[r] = a.account.carried[r] + after[elements + r];
        a.account.before = {{first_pair, 100}, {second_pair, 100}};
        double gained = -200;
        for (const auto& [pair, debt] : a.settle())
            gained += debt;
        const double escaped =
            0.5 * after.dot(mass.asDiagonal() * after) - 0.5 * before.dot(mass.asDiagonal() * before) - gained;
        EXPECT_LE(escaped, 1e-9) << trial;
        // What is missing is lost by the projection, and no more: the distance from what was put in place.
        const Eigen::VectorXd lost = after - before;
        EXPECT_NEAR(escaped, -0.5 * lost.dot(mass.asDiagonal() * lost), 1e-9) << trial;
        least = std::min(least, -escaped);
    }
    EXPECT_LT(least, 1.0);
}

// What transport takes is not owed to the films; the debts of others stay.
TEST(FilmAccount, LossesAreNotGivenBack)
{
    Account a;
    a.rest();
    a.account.before = {{first_pair, 0.3}};
    a.account.transported[3] = a.account.reference[3] + Vec<2>(-0.5, 0);
    a.velocity[3] = a.account.master[3] + Vec<2>(2, 0);
    const FilmDebts<2> debts = a.settle();
    EXPECT_FALSE(debts.contains(second_pair));
    EXPECT_DOUBLE_EQ(debts.at(first_pair), 0.3);
}

// Contact has undone what transport did to a pair that rebounds: it owes what it owed, or nothing.
TEST(FilmAccount, ReboundingPairsOweWhatTheyOwed)
{
    Account a;
    a.account.rebounding = {first_pair};
    a.account.before[second_pair] = 20; // more than transport takes from it
    EXPECT_EQ(a.settle().at(first_pair), 0.25);
    EXPECT_NE(a.settle().at(second_pair), 0.05);
    a.account.owed.clear();
    EXPECT_FALSE(a.settle().contains(first_pair));
}

TEST(FilmAccount, WithoutTransportDebtsStayAsTheyWere)
{
    Account a;
    a.account.reference.clear(); // nothing was carried
    EXPECT_EQ(a.settle(), a.account.before);
    ASSERT_EQ(a.increment.size(), a.velocity.size());
    for (const Vec<2>& change : a.increment)
        EXPECT_EQ(change.norm(), 0);
}

// A pair whose films have the energy 100 and gain `gain` where `planned` was.
Account gaining(double gain, double planned)
{
    Account a;
    a.rest();
    a.account.planned[first_pair] = planned;
    a.account.reference[0] = a.account.master[0] + Vec<2>(8, 0); // 64 of the energy
    a.account.transported[0] = a.account.reference[0] + Vec<2>(gain / 20, 0);
    a.velocity[0] = a.account.master[0] + Vec<2>(10, 0);
    a.account.kept[0] = std::sqrt(2 * 36 * 1.5 / 0.4); // 36
    return a;
}

TEST(FilmAccount, GainsBeyondThePlanAreMispredicted)
{
    const std::set<FilmPair<2>> none, first{first_pair};
    EXPECT_EQ(gaining(2.1, 0).mispredicted(), first); // 2 % of the energy
    EXPECT_EQ(gaining(1.9, 0).mispredicted(), none);
    EXPECT_EQ(gaining(5, 4).mispredicted(), none); // was planned
    EXPECT_EQ(gaining(5, 2.5).mispredicted(), first);
    EXPECT_EQ(gaining(1, -5).mispredicted(), first); // was meant to lose
    EXPECT_EQ(gaining(-1, -50).mispredicted(), none);
    Account rebounds = gaining(50, 0), unplanned = gaining(50, 0);
    rebounds.account.rebounding = {first_pair};
    EXPECT_EQ(rebounds.mispredicted(), none);
    unplanned.account.planned.erase(first_pair);
    EXPECT_EQ(unplanned.mispredicted(), none);
}

// What is taken back has neither transport nor heads: no more is owed than before. Other pairs keep theirs.
TEST(FilmAccount, TakenBackTransportOwesNothingMore)
{
    Account a;
    const Account before = a;
    std::vector<double> factor;
    take_back_transport<2>(a.network, {first_pair}, a.account, a.velocity, a.mouth, factor);
    for (int i : {0, 1, 2}) {
        EXPECT_EQ(a.velocity[i], before.account.reference[i]);
        EXPECT_EQ(a.account.transported[i], before.account.reference[i]);
    }
    EXPECT_EQ(a.velocity[3], before.velocity[3]);
    EXPECT_EQ(a.account.transported[3], before.account.transported[3]);
    for (int r : {0, 1}) {
        EXPECT_EQ(a.mouth[r], before.account.carried[r] + before.account.kept[r]);
        EXPECT_EQ(a.account.gain[r], 0);
    }
    EXPECT_EQ(a.mouth[2], before.mouth[2]);
    EXPECT_EQ(a.account.gain[2], 0.15);
    // The heads had multiplied the conductances by 1 / (1 + |a|).
    ASSERT_EQ(factor.size(), 3u);
    EXPECT_NEAR(factor[0], 1.3, 1e-12);
    EXPECT_NEAR(factor[1], 1.2, 1e-12);
    EXPECT_EQ(factor[2], 1);
    EXPECT_EQ(a.account.before.at(second_pair), 1.25);
    EXPECT_NEAR(a.settle().at(first_pair), 0.25, 1e-12);
    EXPECT_TRUE(!a.mispredicted().contains(first_pair));
}

} // namespace
} // namespace gapflow::test
