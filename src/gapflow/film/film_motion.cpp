#include "gapflow/film/film_motion.hpp"

#include "gapflow/film/film_energy.hpp"
#include "gapflow/film/for_each_job.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace gapflow {

namespace {

// A mouth thinner than its film keeps its flux, relative to the master, up to this multiple of the film's speed there times its
// section: where it narrows beside a point of contact, the flux of a wider mouth would become a jet without a physical cause. (The flux of
// wide mouths is not limited: each step would remove it, each solve would restore it, and the energy of that would grow.)
constexpr double mouth_bound = 2.0;
// Mouths thinner than this times their film's mean thickness lie beside a point of contact, and their outflow's head adds no more than
// their own flux; much thinner ones have none.
constexpr double thin_mouth = 0.5, blocked_mouth = 0.1;
// Of the angle between an element's normal and the other's, which is 30 degrees at most where there is a film; else its mean normal is unreliable.
constexpr double least_cosine = 0.5;

double square(double x)
{
    return x * x;
}

} // namespace

template <int D>
NormalRows<D> normal_rows(const FilmMesh<D>& mesh, const FilmElement<D>& e, std::span<const Solid<D>> solids)
{
    const Vec<D>& centre = solids[mesh.master].centre;
    const Vec<D> other_centre = solids[mesh.other].centre + mesh.shift;
    const double across = e.normal.dot(e.into_other);
    const bool known = across > least_cosine;
    const Vec<D> normal = known ? Vec<D>(e.into_other / (2 * across)) : Vec<D>(0.5 * e.normal);
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

namespace {

// The transport of films in a step, part by part.
template <int D>
class FilmAdvection {
public:
    FilmAdvection(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const FilmHistories<D>& histories, double dt)
        : network_(network), solids_(solids), mouths_(network.rim.mouths), dt_(dt), history_(network.films.size(), nullptr),
          at_element_(network.elements, unknown()), at_mouth_(mouths_.size(), unknown())
    {
        for (std::size_t k = 0; k < network.films.size(); ++k)
            if (auto it = histories.find(network.films[k].pair); it != histories.end())
                history_[k] = it->second.get();
    }

    // Velocities transported from the old films to the new elements and mouths.
    void transport()
    {
        for_each_job(static_cast<int>(history_.size()), [&](int k) {
            if (!history_[k])
                return;
            const Film<D>& film = network_.films[k];
            const PlacedShape<D>& master = solids_[film.pair.master].shape;
            int hint = -1;
            for (std::size_t e = 0; e < film.mesh.elements.size(); ++e)
                at_element_[film.first_element + e] =
                    history_[k]->transport(master.to_body(film.mesh.elements[e].centroid_master), dt_, hint);
        });
        constexpr int chunk = 64;
        for_each_job(static_cast<int>((mouths_.size() + chunk - 1) / chunk), [&](int job) {
            for (std::size_t r = static_cast<std::size_t>(job) * chunk;
                 r < std::min(mouths_.size(), (job + std::size_t(1)) * chunk); ++r)
                if (const int k = mouths_[r].film; history_[k]) {
                    int hint = -1;
                    at_mouth_[r] = history_[k]->at(solids_[network_.films[k].pair.master].shape.to_body(mouths_[r].x), hint);
                }
        });
    }

    // The bulk's velocity: at elements without an old film near them, then at all mouths.
    std::vector<Vec<D>> from_grid(const VelocitySampler<D>& grid_velocity) const
    {
        std::vector<Vec<D>> places;
        for (const Film<D>& film : network_.films)
            for (std::size_t e = 0; e < film.mesh.elements.size(); ++e)
                if (!at_element_[film.first_element + e].near)
                    places.push_back(film.mesh.elements[e].centroid);
        for (const Mouth<D>& mouth : mouths_) // at smooth ends beyond the film's own cells
            places.push_back(at_mouth_[&mouth - mouths_.data()].near && mouth.kind == MouthKind::smooth
                                 ? Vec<D>(mouth.x + 0.5 * mouth.h * mouth.outward)
                                 : mouth.x);
        return grid_velocity(places);
    }

    // Elements' velocities; the pairs' energy losses.
    auto move_elements(const std::vector<double>& normal_speed, typename std::vector<Vec<D>>::const_iterator& next,
                       FilmFlow<D>& flow) const
    {
        std::vector<double> turned; // of an element's normal speed: the part that was along the film at the foot of its trace
        for (std::size_t k = 0; k < history_.size(); ++k)
            for (const FilmElement<D>& e : network_.films[k].mesh.elements) {
                const Transported& old = at_element_[flow.velocity.size()];
                Vec<D> w = old.near ? old.velocity : *next++;
                turned.push_back(old.near ? tangential<D>(w - master_velocity(k, e), old.normal).dot(e.normal) : 0.0);
                const Vec<D> n_bar = old.near ? Vec<D>(e.normal + old.normal) : e.normal;
                const double across = n_bar.dot(e.normal);
                flow.normal.push_back(w.dot(e.normal));
                if (across > 0.1 * n_bar.norm())
                    w += (normal_speed[flow.velocity.size()] - w.dot(e.normal)) / across * n_bar;
                flow.velocity.push_back(tangential<D>(w, e.normal));
            }
        auto given_away = limit_motion(network_, solids_, history_, at_element_, at_mouth_, dt_, flow.velocity);
        // At a corner the flow along the old film hits the new film's walls: it counts with at most the speed that remains along the film.
        for (std::size_t k = 0; k < history_.size(); ++k)
            for (std::size_t i = 0; i < network_.films[k].mesh.elements.size(); ++i) {
                const std::size_t at = network_.films[k].first_element + i;
                if (turned[at] == 0)
                    continue;
                const FilmElement<D>& e = network_.films[k].mesh.elements[i];
                const double speed = tangential<D>(flow.velocity[at] - master_velocity(k, e), e.normal).norm();
                flow.normal[at] += std::clamp(turned[at], -speed, speed) - turned[at];
            }
        return given_away;
    }

    // Mouths' fluxes and the factors of their conductances; returns the flux that the head of the outflow adds to each.
    std::vector<double> move_mouths(const std::function<MouthLaw(int, int)>& law,
                                    typename std::vector<Vec<D>>::const_iterator& next, FilmFlow<D>& flow) const
    {
        const std::vector<double> thickness = mean_thickness();
        std::vector<double> head(mouths_.size(), 0.0);
        for (std::size_t r = 0; r < mouths_.size(); ++r) {
            const Mouth<D>& mouth = mouths_[r];
            const FilmPair<D>& pair = network_.films[mouth.film].pair;
            const Vec<D> bulk = *next++;
            double q = 0, scale = 1.0;
            if (at_mouth_[r].near)
                std::tie(q, scale, head[r]) =
                    mouth_values(static_cast<int>(r), thickness[mouth.film], bulk, law(pair.master, pair.other));
            else
                q = mouth.length * mouth.h * mouth.outward.dot(bulk);
            flow.mouth.push_back(q);
            flow.mouth_scale.push_back(scale);
        }
        return head;
    }

    const std::vector<const FilmHistory<D>*>& history() const { return history_; }

private:
    using Transported = typename FilmHistory<D>::Transported;
    static Transported unknown() { return {Vec<D>::Zero(), Vec<D>::Zero(), false, false, 0}; }

    Vec<D> master_velocity(std::size_t film, const FilmElement<D>& e) const
    {
        return history_[film]->master_velocity(solids_[network_.films[film].pair.master].shape.to_body(e.centroid_master));
    }

    std::vector<double> mean_thickness() const
    {
        std::vector<double> mean;
        for (const Film<D>& film : network_.films) {
            double volume = 0, measure = 0;
            for (const FilmElement<D>& e : film.mesh.elements) {
                volume += e.volume;
                measure += e.measure;
            }
            mean.push_back(volume / measure);
        }
        return mean;
    }

    // Flux, factor of the conductance and flux by the outflow's head of a mouth with an old film near it. `bulk`: its velocity there.
    std::tuple<double, double, double> mouth_values(int r, double mean_thickness, const Vec<D>& bulk, const MouthLaw& law) const
    {
        const Mouth<D>& mouth = mouths_[r];
        const FilmHistory<D>& history = *history_[mouth.film];
        const double section = mouth.length * mouth.h;
        const Vec<D> place = solids_[network_.films[mouth.film].pair.master].shape.to_body(mouth.x);
        const Vec<D> w = at_mouth_[r].velocity, U = history.master_velocity(place);
        double u = mouth.outward.dot(w - U); // out of the film, relative to the master
        const auto* old = history.nearest_mouth(place, mouth.outward);
        double q = section * mouth.outward.dot(w), scale = 1.0, head = 0.0;
        if (old) {
            const double flux =
                mouth.length * (old->flux + (mouth.h * mouth.outward - old->h * old->outward).dot(old->master_velocity));
            const double with_master = section * mouth.outward.dot(U), most = mouth_bound * section * at_mouth_[r].fastest;
            q = mouth.h < mean_thickness ? with_master + std::clamp(flux - with_master, -most, most) : flux;
        }
        // Without losses, fluid that passes a mouth has the film's kinetic energy on one side and the bulk's on the other, which the bulk's
        // transport supplies or takes up. The head is the difference: where fluid leaves by a sharp mouth, and where it enters by a smooth one.
        const bool smooth = mouth.kind == MouthKind::smooth;
        const double beyond = mouth.kind == MouthKind::open_side ? 0.0 : square(mouth.outward.dot(bulk - U));
        const bool enters = u < 0 && mouth.kind != MouthKind::inflow && (!smooth || !law.jet);
        const bool regains = u >= 0 && mouth.kind != MouthKind::inflow && !smooth && !law.jet;
        if (enters) { // semi-implicit
            const double k = smooth ? std::max(1 - beyond / square(u), 0.0) : 1 + law.entrance_loss;
            scale = 1 / (1 + dt_ * k * -u / (2 * mouth.resistance * mouth.h));
            q = scale * q + (1 - scale) * section * mouth.outward.dot(U);
        } else if (regains) {
            int hint = -1;
            if (history.second_order())
                u = std::max(mouth.outward.dot(history.half_way(place, dt_, hint) - U), 0.0);
            const double thickness = mouth.h / mean_thickness;
            const double open = std::min(1.0, thickness / blocked_mouth);
            head = open * open * mouth.length * dt_ * 0.5 * std::max(square(u) - beyond, 0.0) / mouth.resistance;
            if (thickness < thin_mouth)
                head = std::min(head, section * u);
        }
        return {q, scale, head};
    }

    const FilmNetwork<D>& network_;
    std::span<const Solid<D>> solids_;
    const std::vector<Mouth<D>>& mouths_;
    double dt_;
    std::vector<const FilmHistory<D>*> history_; // of each film's pair; null: none
    std::vector<Transported> at_element_, at_mouth_;
};

} // namespace

template <int D>
FilmFlow<D> advect_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const FilmHistories<D>& histories,
                         const std::vector<Twist<D>>& predicted, const VelocitySampler<D>& grid_velocity,
                         const std::function<MouthLaw(int, int)>& law, double dt)
{
    FilmAdvection<D> advection(network, solids, histories, dt);
    advection.transport();
    const std::vector<Vec<D>> from_grid = advection.from_grid(grid_velocity);
    auto next = from_grid.begin();
    FilmFlow<D> flow;
    const auto given_away = advection.move_elements(wall_normal_speed<D>(network, solids, predicted), next, flow);
    const std::vector<double> head = advection.move_mouths(law, next, flow);
    add_heads(network, solids, advection.history(), given_away, head, flow.mouth);
    return flow;
}

template <int D>
FilmHistories<D> remember_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids,
                                const std::vector<Twist<D>>& twists, const std::vector<Vec<D>>& u,
                                const std::vector<double>& mouth, double dx, const std::vector<char>& idle,
                                const std::vector<Vec<D>>& acceleration)
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
    const std::vector<Vec<D>> none;
    std::vector<std::shared_ptr<FilmHistory<D>>> histories(list.size());
    for_each_job(static_cast<int>(list.size()), [&](int k) {
        const int master = list[k].first->master;
        const std::vector<const Film<D>*>& films = *list[k].second;
        const bool flat = std::all_of(films.begin(), films.end(), [](const Film<D>* film) { return film->mesh.flat; });
        histories[k] =
            std::make_shared<FilmHistory<D>>(solids[master], twists[master], films, w, flat ? acceleration : none, idle, dx);
    });
    for (std::size_t r = 0; r < mouth.size(); ++r) {
        const Mouth<D>& c = network.rim.mouths[r];
        const FilmPair<D>& pair = network.films[c.film].pair;
        const Solid<D>& master = solids[pair.master];
        histories[number[c.film]]->mouths.push_back({master.shape.to_body(c.x), c.outward, c.h, mouth[r] / c.length,
                                                     velocity_at<D>(twists[pair.master], c.x - master.centre), c.kind});
    }
    FilmHistories<D> by_pair;
    for (std::size_t k = 0; k < list.size(); ++k)
        by_pair.emplace_hint(by_pair.end(), *list[k].first, std::move(histories[k]));
    return by_pair;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template NormalRows<D> normal_rows<D>(const FilmMesh<D>&, const FilmElement<D>&, std::span<const Solid<D>>);               \
    template FilmFlow<D> advect_films<D>(const FilmNetwork<D>&, std::span<const Solid<D>>, const FilmHistories<D>&,            \
                                         const std::vector<Twist<D>>&, const VelocitySampler<D>&,                              \
                                         const std::function<MouthLaw(int, int)>&, double);                                    \
    template FilmHistories<D> remember_films<D>(                                                                               \
        const FilmNetwork<D>&, std::span<const Solid<D>>, const std::vector<Twist<D>>&, const std::vector<Vec<D>>&,            \
        const std::vector<double>&, double, const std::vector<char>&, const std::vector<Vec<D>>&);                             \
    template std::vector<double> wall_normal_speed<D>(const FilmNetwork<D>&, std::span<const Solid<D>>,                        \
                                                      const std::vector<Twist<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
