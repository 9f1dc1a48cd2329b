#include "gapflow/stepping/flooding.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

namespace gapflow {

namespace {

// Part of a surplus that is passed on: the rest makes sure that the node is filled.
constexpr double handed_on = 0.95;

// The master's velocity along an element.
template <int D>
Vec<D> along_master(const Coupling<D>& coupling, const FilmMesh<D>& mesh, const FilmElement<D>& e,
                    const std::vector<Twist<D>>& twists)
{
    const Vec<D> U = velocity_at<D>(twists[mesh.master], e.centroid - coupling.solids[mesh.master].centre);
    return U - U.dot(e.normal) * e.normal;
}

struct Place {
    int film, element; ///< element: in the film's own list
};

// Elements and mouths around every film node.
template <int D>
struct Around {
    std::vector<std::vector<Place>> elements;
    std::vector<std::vector<std::pair<int, double>>> mouths; ///< number, shape function

    explicit Around(const FilmNetwork<D>& network) : elements(network.nodes), mouths(network.nodes)
    {
        for (int k = 0; k < static_cast<int>(network.films.size()); ++k) {
            const Film<D>& film = network.films[k];
            for (int e = 0; e < static_cast<int>(film.mesh.elements.size()); ++e)
                for (int node : film.mesh.elements[e].nodes)
                    elements[film.first_node + node].push_back({k, e});
        }
        for (int r = 0; r < static_cast<int>(network.rim.mouths.size()); ++r)
            for (int i = 0; i < D - 1; ++i)
                mouths[network.rim.mouths[r].nodes[i]].emplace_back(r, network.rim.mouths[r].shape[i]);
    }
};

template <int D>
int place_of_node(const FilmElement<D>& e, int node)
{
    return static_cast<int>(std::find(e.nodes.begin(), e.nodes.end(), node) - e.nodes.begin());
}

} // namespace

template <int D>
double carried_flux(const Coupling<D>& coupling, const Mouth<D>& mouth, const std::vector<Twist<D>>& twists)
{
    const int master = coupling.network.films[mouth.film].mesh.master;
    return mouth.length * mouth.section.dot(velocity_at<D>(twists[master], mouth.x - coupling.solids[master].centre));
}

template <int D>
void rest_in_voids(const Coupling<D>& coupling, const std::vector<char>& empty, const std::vector<Twist<D>>& twists,
                   std::vector<Vec<D>>& u)
{
    for (const Film<D>& film : coupling.network.films)
        for (std::size_t e = 0; e < film.mesh.elements.size(); ++e)
            if (empty[film.first_element + e])
                u[film.first_element + e] = along_master(coupling, film.mesh, film.mesh.elements[e], twists);
}

template <int D>
void oppose_void_pressure(const Coupling<D>& coupling, const VoidSet<D>& voids, const std::vector<char>& empty, double dt,
                          std::vector<Vec<D>>& u)
{
    for (const Film<D>& film : coupling.network.films)
        for (std::size_t e = 0; e < film.mesh.elements.size(); ++e) {
            const FilmElement<D>& element = film.mesh.elements[e];
            for (int i = 0; i < D && empty[film.first_element + e]; ++i)
                u[film.first_element + e] +=
                    dt / coupling.density * voids.least_pressure(film.first_node + element.nodes[i]) * element.gradient[i];
        }
}

template <int D>
void limit_inflow(const Coupling<D>& coupling, const VoidSet<D>& voids, const FilmHistories<D>& histories,
                  const std::function<MouthLaw(int, int)>& law, const std::vector<double>& bulk_pressure, double dt,
                  FilmFlow<D>& flow)
{
    const std::vector<Mouth<D>>& mouths = coupling.network.rim.mouths;
    for (std::size_t r = 0; r < mouths.size(); ++r) {
        const Mouth<D>& mouth = mouths[r];
        const Film<D>& film = coupling.network.films[mouth.film];
        bool at_void = false;
        double drop = bulk_pressure[r];
        for (int i = 0; i < D - 1; ++i) {
            at_void = at_void || voids.is_void()[mouth.nodes[i]];
            drop -= mouth.shape[i] * voids.last_pressure()[mouth.nodes[i]];
        }
        const bool sharp = mouth.kind != MouthKind::smooth && mouth.kind != MouthKind::inflow;
        const auto history = histories.find(film.pair);
        if (!sharp || !(at_void || film.mesh.skin > 0) || history == histories.end())
            continue;
        const PlacedShape<D>& master = coupling.solids[film.pair.master].shape;
        const double along = mouth.length * mouth.section.dot(history->second->master_velocity(master.to_body(mouth.x)));
        double& q = flow.mouth[r];
        double& scale = flow.mouth_scale[r];
        const double before = (q - (1 - scale) * along) / scale; // q^n, without the head that advection took
        const double inertia = mouth.resistance / dt;
        const double head = (1 + law(film.pair.master, film.pair.other).entrance_loss) / (2 * mouth.h * mouth.h);
        const double force = drop / coupling.density + inertia * (along - before) / mouth.length;
        if (force <= 0)
            continue;
        // head w^2 + inertia w = force, without the difference of nearly equal numbers
        const double w = 2 * force / (inertia + std::sqrt(inertia * inertia + 4 * head * force));
        scale = 1 / (1 + head * w / inertia);
        q = scale * before + (1 - scale) * along;
    }
}

template <int D>
void pass_on(const Coupling<D>& coupling, const VoidSet<D>& voids, const std::vector<Twist<D>>& twists, double dt,
             FilmFlow<D>& flow)
{
    const FilmNetwork<D>& network = coupling.network;
    const std::vector<Mouth<D>>& mouths = network.rim.mouths;
    const Around<D> around(network);
    const std::vector<char> empty = voids.empty_elements(network);
    Eigen::VectorXd outflow = Eigen::VectorXd::Zero(network.nodes);
    for (const auto& entry : coupling.node_flux)
        outflow[entry.row] += entry.flux.dot(twists[entry.body]);
    for (const Film<D>& film : network.films)
        for (std::size_t e = 0; film.here && e < film.mesh.elements.size(); ++e) {
            const FilmElement<D>& element = film.mesh.elements[e];
            for (int i = 0; i < D; ++i)
                outflow[film.first_node + element.nodes[i]] -=
                    element.volume * element.gradient[i].dot(flow.velocity[film.first_element + e]);
        }
    for (std::size_t r = 0; r < mouths.size(); ++r)
        for (int i = 0; i < D - 1 && network.films[mouths[r].film].here; ++i)
            outflow[mouths[r].nodes[i]] += mouths[r].shape[i] * flow.mouth[r];
    network.ranks.sum(std::span<double>(outflow.data(), outflow.size()));

    std::vector<char> carries(network.elements, 0), done(network.nodes, 0);
    std::deque<int> queue;
    for (int node = 0; node < network.nodes; ++node)
        if (voids.is_void()[node])
            queue.push_back(node);
    while (!queue.empty()) {
        const int node = queue.front();
        queue.pop_front();
        const double surplus = -outflow[node] - voids.volume()[node] / dt;
        if (done[node] || surplus <= 0)
            continue;
        Vec<D> direction = Vec<D>::Zero();
        double fastest = 0;
        auto add = [&](double inflow, const Vec<D>& velocity) {
            if (inflow <= 0)
                return;
            direction += inflow * velocity.normalized();
            fastest = std::max(fastest, velocity.norm());
        };
        for (const Place& at : around.elements[node]) {
            const Film<D>& film = network.films[at.film];
            const FilmElement<D>& e = film.mesh.elements[at.element];
            const Vec<D> relative =
                flow.velocity[film.first_element + at.element] - along_master(coupling, film.mesh, e, twists);
            add(e.volume * e.gradient[place_of_node(e, node - film.first_node)].dot(relative), relative);
        }
        for (const auto& [r, shape] : around.mouths[node]) {
            const double in = carried_flux(coupling, mouths[r], twists) - flow.mouth[r];
            add(shape * in, -in / (mouths[r].length * mouths[r].h) * mouths[r].outward);
        }
        if (direction.isZero(0))
            continue;
        done[node] = 1;
        auto for_each_downstream = [&](auto&& f) {
            for (const Place& at : around.elements[node]) {
                const Film<D>& film = network.films[at.film];
                const FilmElement<D>& e = film.mesh.elements[at.element];
                const int number = film.first_element + at.element;
                const Vec<D> t = (direction - direction.dot(e.normal) * e.normal).normalized();
                const double section = -e.volume * e.gradient[place_of_node(e, node - film.first_node)].dot(t);
                if (empty[number] && !carries[number] && section > 0)
                    f(film, e, number, t, section);
            }
        };
        double section = 0;
        for_each_downstream([&](const Film<D>&, const FilmElement<D>&, int, const Vec<D>&, double s) { section += s; });
        if (section <= 0)
            continue;
        const double speed = std::min(handed_on * surplus / section, fastest);
        for_each_downstream([&](const Film<D>& film, const FilmElement<D>& e, int number, const Vec<D>& t, double) {
            carries[number] = 1;
            flow.velocity[number] += speed * t;
            for (int i = 0; i < D; ++i) {
                const int other = film.first_node + e.nodes[i];
                outflow[other] -= e.volume * speed * e.gradient[i].dot(t);
                if (voids.is_void()[other] && !done[other])
                    queue.push_back(other);
            }
        });
    }
}

template <int D>
void follow_front(const Coupling<D>& coupling, const std::vector<char>& was_empty, const std::vector<char>& is_empty,
                  const std::vector<char>& is_void, const std::vector<Twist<D>>& twists, FluidVelocity<D>& u)
{
    const FilmNetwork<D>& network = coupling.network;
    const Around<D> around(network);
    const std::vector<Vec<D>> before = u.film;
    for (const Film<D>& film : network.films)
        for (std::size_t e = 0; e < film.mesh.elements.size(); ++e) {
            const int number = film.first_element + static_cast<int>(e);
            if (!was_empty[number] || is_empty[number])
                continue;
            const FilmElement<D>& element = film.mesh.elements[e];
            Vec<D> behind = Vec<D>::Zero(), through_mouth = Vec<D>::Zero();
            double volume = 0, length = 0;
            for (int node : element.nodes) {
                if (is_void[film.first_node + node])
                    continue;
                for (const Place& at : around.elements[film.first_node + node]) {
                    const Film<D>& other = network.films[at.film];
                    const FilmElement<D>& from = other.mesh.elements[at.element];
                    if (was_empty[other.first_element + at.element])
                        continue;
                    behind += from.volume *
                              (before[other.first_element + at.element] - along_master(coupling, other.mesh, from, twists));
                    volume += from.volume;
                }
                for (const auto& [r, shape] : around.mouths[film.first_node + node]) {
                    const Mouth<D>& mouth = network.rim.mouths[r];
                    through_mouth += shape * (u.mouth[r] - carried_flux(coupling, mouth, twists)) / mouth.h * mouth.outward;
                    length += shape * mouth.length;
                }
            }
            if (volume <= 0 && length <= 0)
                continue;
            Vec<D> relative = volume > 0 ? Vec<D>(behind / volume) : Vec<D>(through_mouth / length);
            relative -= relative.dot(element.normal) * element.normal;
            u.film[number] = along_master(coupling, film.mesh, element, twists) + relative;
        }
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template double carried_flux<D>(const Coupling<D>&, const Mouth<D>&, const std::vector<Twist<D>>&);                        \
    template void rest_in_voids<D>(const Coupling<D>&, const std::vector<char>&, const std::vector<Twist<D>>&,                 \
                                   std::vector<Vec<D>>&);                                                                      \
    template void oppose_void_pressure<D>(const Coupling<D>&, const VoidSet<D>&, const std::vector<char>&, double,             \
                                          std::vector<Vec<D>>&);                                                               \
    template void limit_inflow<D>(const Coupling<D>&, const VoidSet<D>&, const FilmHistories<D>&,                              \
                                  const std::function<MouthLaw(int, int)>&, const std::vector<double>&, double, FilmFlow<D>&); \
    template void pass_on<D>(const Coupling<D>&, const VoidSet<D>&, const std::vector<Twist<D>>&, double, FilmFlow<D>&);       \
    template void follow_front<D>(const Coupling<D>&, const std::vector<char>&, const std::vector<char>&,                      \
                                  const std::vector<char>&, const std::vector<Twist<D>>&, FluidVelocity<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
