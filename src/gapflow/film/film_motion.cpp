#include "gapflow/film/film_motion.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/film/film_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace gapflow {

namespace {

// Walls at an angle of less than the root of this, in radians, contribute alike.
constexpr double parallel = 0.01;

} // namespace

template <int D>
NormalRows<D> normal_rows(const FilmMesh<D>& mesh, const FilmElement<D>& e, std::span<const Solid<D>> solids)
{
    const Vec<D>& centre = solids[mesh.master].centre;
    const Vec<D> other_centre = solids[mesh.other].centre + mesh.shift;
    const double across = e.normal.dot(e.into_other);
    const bool known = across > least_cosine;
    // If not known, the other's mean normal is unreliable.
    Vec<D> normal = known ? Vec<D>(e.into_other / (2 * across)) : Vec<D>(0.5 * e.normal);
    if (known && !mesh.viscous) {
        std::array<Vec<D>, D> x;
        for (int i = 0; i < D; ++i)
            x[i] = mesh.x[e.nodes[i]];
        const Vec<D> of_master = area_vector<D>(x).normalized();
        const Vec<D> of_normal = e.normal - e.normal.dot(of_master) * of_master,
                     of_other = e.into_other - e.into_other.dot(of_master) * of_master;
        normal = (of_normal.dot(of_other) + parallel / (2 * across)) / (of_other.squaredNorm() + parallel) * e.into_other;
    }
    const Vec<D>& place = known ? e.place_on_other : e.centroid;
    return {wrench<D>(e.normal, e.centroid - centre) - wrench<D>(normal, place - centre),
            wrench<D>(normal, place - other_centre)};
}

template <int D>
std::vector<double> wall_normal_speed(const FilmNetwork<D>& network, std::span<const Solid<D>> solids,
                                      const std::vector<Twist<D>>& twists)
{
    std::vector<double> speed;
    for (const Film<D>& film : network.films)
        for (const FilmElement<D>& e : film.mesh.elements) {
            const NormalRows<D> rows = normal_rows<D>(film.mesh, e, solids);
            speed.push_back(rows.master.dot(twists[film.mesh.master]) + rows.other.dot(twists[film.mesh.other]));
        }
    return speed;
}

template <int D>
FilmHistories<D> remember_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids,
                                const std::vector<Twist<D>>& twists, const std::vector<Vec<D>>& u,
                                const std::vector<double>& mouth, double dx, const std::vector<char>& idle,
                                const std::vector<Vec<D>>& acceleration, const std::vector<Vec<D>>& increment)
{
    std::vector<Vec<D>> w = u;
    const std::vector<double> normal_speed = wall_normal_speed<D>(network, solids, twists);
    std::map<FilmPair<D>, std::vector<const Film<D>*>> pieces;
    for (const Film<D>& film : network.films) {
        pieces[film.pair].push_back(&film);
        for (std::size_t e = 0; e < film.mesh.elements.size(); ++e) {
            const std::size_t i = film.first_element + e;
            w[i] = tangential<D>(u[i], film.mesh.elements[e].normal) + normal_speed[i] * film.mesh.elements[e].normal;
        }
    }
    std::vector<std::pair<const FilmPair<D>*, const std::vector<const Film<D>*>*>> list;
    std::vector<int> number(network.films.size()); // of each film's pair
    for (const auto& [pair, films] : pieces) {
        for (const Film<D>* film : films)
            number[film - network.films.data()] = static_cast<int>(list.size());
        list.emplace_back(&pair, &films);
    }
    std::vector<std::shared_ptr<FilmHistory<D>>> histories(list.size());
    for_each_job(static_cast<int>(list.size()), [&](int k) {
        const int master = list[k].first->master;
        const std::vector<const Film<D>*>& films = *list[k].second;
        histories[k] =
            std::make_shared<FilmHistory<D>>(solids[master], twists[master], films, w, acceleration, increment, idle, dx);
    });
    for (std::size_t r = 0; r < mouth.size(); ++r) {
        const Mouth<D>& c = network.rim.mouths[r];
        const FilmPair<D>& pair = network.films[c.film].pair;
        const Solid<D>& master = solids[pair.master];
        histories[number[c.film]]->mouths.push_back({master.shape.to_body(c.x), c.outward, c.section, c.resistance,
                                                     mouth[r] / c.length,
                                                     velocity_at<D>(twists[pair.master], c.x - master.centre), c.kind});
    }
    FilmHistories<D> by_pair;
    for (std::size_t k = 0; k < list.size(); ++k)
        by_pair.emplace_hint(by_pair.end(), *list[k].first, std::move(histories[k]));
    return by_pair;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template NormalRows<D> normal_rows<D>(const FilmMesh<D>&, const FilmElement<D>&, std::span<const Solid<D>>);               \
    template FilmHistories<D> remember_films<D>(                                                                               \
        const FilmNetwork<D>&, std::span<const Solid<D>>, const std::vector<Twist<D>>&, const std::vector<Vec<D>>&,            \
        const std::vector<double>&, double, const std::vector<char>&, const std::vector<Vec<D>>&, const std::vector<Vec<D>>&); \
    template std::vector<double> wall_normal_speed<D>(const FilmNetwork<D>&, std::span<const Solid<D>>,                        \
                                                      const std::vector<Twist<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
