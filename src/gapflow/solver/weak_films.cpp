#include "gapflow/solver/weak_films.hpp"

#include "gapflow/core/disjoint_sets.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr double weak_mouths =
    1e-6; // relative to the film's conductances: below, the band's own solve does not resolve the film's level
constexpr double no_ground = 1e-12; // of a row's diagonal: round-off of its sum

} // namespace

template <int D>
std::vector<int> weak_films(const CoupledSystem<D>& system, int& count)
{
    const auto for_each_edge = [&](auto&& f) {
        for (int j = 0; j < system.film.outerSize(); ++j)
            for (Eigen::SparseMatrix<double>::InnerIterator entry(system.film, j); entry && entry.row() < j; ++entry)
                f(static_cast<int>(entry.row()), j, entry.value());
    };
    DisjointSets films(system.nodes);
    for_each_edge([&](int i, int j, double value) {
        if (value != 0)
            films.join(i, j);
    });
    std::vector<double> inside(system.nodes, 0.0), outside(system.nodes, 0.0);
    for_each_edge([&](int i, int, double value) {
        double& largest = inside[films.find(i)];
        largest = std::max(largest, std::abs(value));
    });
    for (const Link& link : system.links)
        for (const auto& [node, weight] : link.nodes)
            outside[films.find(node)] += link.conductance * weight * weight;
    for (int i = 0; i < system.nodes; ++i) {
        double ground = 0, diagonal = 0;
        for (Eigen::SparseMatrix<double>::InnerIterator entry(system.film, i); entry; ++entry) {
            ground += entry.value();
            if (entry.row() == i)
                diagonal = entry.value();
        }
        if (std::abs(ground) >= no_ground * diagonal)
            outside[films.find(i)] += std::abs(ground);
    }
    count = 0;
    std::vector<int> number(system.nodes, -1), result(system.nodes, -1);
    for (int i = 0; i < system.nodes; ++i) {
        const int film = films.find(i);
        if (outside[film] > weak_mouths * inside[film])
            continue;
        if (number[film] < 0)
            number[film] = count++;
        result[i] = number[film];
    }
    return result;
}

template std::vector<int> weak_films(const CoupledSystem<2>&, int&);
template std::vector<int> weak_films(const CoupledSystem<3>&, int&);

} // namespace gapflow
