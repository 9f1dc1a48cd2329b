#include "gapflow/solver/weak_films.hpp"

#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/solver/film_edges.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr double weak_mouths =
    1e-6; // relative to the film's conductances: below, the band's own solve does not resolve the film's level

} // namespace

template <int D>
std::vector<int> weak_films(const CoupledSystem<D>& system, int& count)
{
    DisjointSets films(system.nodes);
    for_each_film_edge(system.film, [&](int i, int j, double conductance) {
        if (conductance != 0)
            films.join(i, j);
    });
    std::vector<double> inside(system.nodes, 0.0), outside(system.nodes, 0.0);
    for_each_film_edge(system.film, [&](int i, int, double conductance) {
        double& largest = inside[films.find(i)];
        largest = std::max(largest, std::abs(conductance));
    });
    for (const Link& link : system.links)
        for (const auto& [node, weight] : link.nodes)
            outside[films.find(node)] += link.conductance * weight * weight;
    const std::vector<double> ground = film_grounds(system.film);
    for (int i = 0; i < system.nodes; ++i)
        outside[films.find(i)] += std::abs(ground[i]);
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
