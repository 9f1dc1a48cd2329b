#include "gapflow/stepping/film_reversal.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace gapflow {

namespace {

// With the speed v and slowed down by a, a gap never closes if gap a > v^2 / 2; plates in ideal flow have exactly that value,
// surfaces that meet at a point or an edge tend to 0. The limit lies between the two:
constexpr double stopping = 0.25;
// Films thinner than this times their floor are those of contact.
constexpr double in_contact = 2;
// Plates whose gap is nowhere thicker than this times its mean are parallel enough.
constexpr double parallel = 1.5;
/// Of a pair's films.
struct Gap {
    double area = 0, volume = 0, thickest = 0;
    double opening = 0, acceleration = 0; ///< mean rates
    bool flat = true;
    double thickness() const { return volume / area; }
};

} // namespace

template <int D>
std::set<FilmPair<D>>
reversing_films(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, const std::vector<Twist<D>>& acceleration,
                const std::function<GapSettings(int, int)>& settings, const std::function<MouthLaw(int, int)>& law)
{
    std::map<FilmPair<D>, Gap> gaps;
    for (const Film<D>& film : coupling.network.films) {
        const FilmMesh<D>& mesh = film.mesh;
        Gap& gap = gaps[film.pair];
        gap.flat = gap.flat && mesh.flat;
        for (const FilmPoint<D>& q : mesh.points) {
            auto rate = [&](const std::vector<Twist<D>>& twist) {
                return q.other_normal.dot(
                    velocity_at<D>(twist[mesh.master], q.x - coupling.solids[mesh.master].centre) -
                    velocity_at<D>(twist[mesh.other], q.y - coupling.solids[mesh.other].centre - mesh.shift));
            };
            gap.area += q.weight;
            gap.volume += q.weight * q.h;
            gap.thickest = std::max(gap.thickest, q.h);
            gap.opening += q.weight * rate(twists);
            gap.acceleration += q.weight * rate(acceleration);
        }
    }
    std::set<FilmPair<D>> reversing;
    for (auto& [pair, gap] : gaps) {
        gap.opening /= gap.area;
        gap.acceleration /= gap.area;
        if (gap.flat && gap.thickness() < smallest_limiting_gap * coupling.grid->dx() &&
            gap.thickness() > in_contact * settings(pair.master, pair.other).floor &&
            gap.thickest < parallel * gap.thickness() && gap.opening < 0 &&
            gap.thickness() * gap.acceleration > stopping * gap.opening * gap.opening && !law(pair.master, pair.other).jet)
            reversing.insert(pair);
    }
    return reversing;
}

template <int D>
void reverse_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const std::set<FilmPair<D>>& reversing,
                   const std::vector<Twist<D>>& twists, FilmFlow<D>& flow)
{
    if (reversing.empty())
        return;
    // The walls' mean velocity.
    auto carried = [&](const Film<D>& film, const Vec<D>& x) {
        const int a = film.pair.master, b = film.pair.other;
        return Vec<D>(0.5 * (velocity_at<D>(twists[a], x - solids[a].centre) +
                             velocity_at<D>(twists[b], x - solids[b].centre - film.mesh.shift)));
    };
    FilmAccount<D>& account = flow.account;
    for (const Film<D>& film : network.films) {
        if (!reversing.contains(film.pair))
            continue;
        for (std::size_t k = 0; k < film.mesh.elements.size(); ++k) {
            const std::size_t i = film.first_element + k;
            const Vec<D> along = tangential<D>(carried(film, film.mesh.elements[k].centroid), film.mesh.elements[k].normal);
            flow.velocity[i] = account.reference[i] = account.transported[i] = 2 * along - account.reference[i];
        }
        account.before.erase(film.pair);
    }
    for (std::size_t r = 0; r < network.rim.mouths.size(); ++r) {
        const Mouth<D>& mouth = network.rim.mouths[r];
        const Film<D>& film = network.films[mouth.film];
        if (!reversing.contains(film.pair))
            continue;
        const double along = mouth.length * mouth.section.dot(carried(film, mouth.x));
        flow.mouth[r] = 2 * along - (account.carried[r] + account.kept[r]);
        flow.mouth_scale[r] = 1;
        account.gain[r] = 0;
    }
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::set<FilmPair<D>> reversing_films<D>(                                                                         \
        const Coupling<D>&, const std::vector<Twist<D>>&, const std::vector<Twist<D>>&,                                        \
        const std::function<GapSettings(int, int)>&, const std::function<MouthLaw(int, int)>&);                                \
    template void reverse_films<D>(const FilmNetwork<D>&, std::span<const Solid<D>>, const std::set<FilmPair<D>>&,             \
                                   const std::vector<Twist<D>>&, FilmFlow<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
