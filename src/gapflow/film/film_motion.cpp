#include "gapflow/film/film_motion.hpp"

#include "gapflow/film/edge_table.hpp"
#include "gapflow/film/film_energy.hpp"
#include "gapflow/film/for_each_job.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

namespace {

constexpr int longest_walk = 100; // elements: a walk that is longer may go round in circles
// An old film within this many cells of a new element's arrival point is its past.
constexpr double memory_reach = 2.0;
// A new element is an old one if its centroid lies within this part of the old one's size from it.
constexpr double same_element = 0.25;
// Interpolated velocities relative to the master exceed those of the elements around by this factor at most.
constexpr double surplus_bound = 1.5;
// Speeds are means over the elements around a vertex, and over no less than the gap's own thickness, or this in dx: what a film does over
// less is no flow of a film. (Its end cuts elements of a hundredth of a cell, through which next to nothing flows at any speed.)
constexpr double smallest_patch = 0.25;
// A mouth carries its flux on, seen from the master, up to this times what the film's speeds there make of its section: where the
// mouth narrows beside a point of contact, the flux of wider ones would become a jet that nothing drives.
constexpr double mouth_bound = 2.0;
// A mouth continues an old one within this many cells.
constexpr double mouth_reach = 2.0;
// In dx: a point further from a film is not of it. Shape functions less than `at_vertex` are round-off.
constexpr double beside_film = 0.05;
constexpr double at_vertex = 1e-6;
// Mouths thinner than this times their film's mean thickness lie beside a point of contact, and their outflow's head adds no more than
// their own flux; much thinner ones have none.
constexpr double thin_mouth = 0.5, blocked_mouth = 0.1;
// Films of up to this many elements are searched without bins.
constexpr int few_elements = 256;

// Barycentric coordinates of x in the plane of a simplex, and the distance from x to the (closed) simplex.
template <int D>
double to_simplex(const std::array<Vec<D>, D>& v, const Vec<D>& x, std::array<double, D>& shape)
{
    if constexpr (D == 2) {
        const Vec<2> t = v[1] - v[0];
        const double s = (x - v[0]).dot(t) / t.squaredNorm();
        shape = {1 - s, s};
        return (x - v[0] - std::clamp(s, 0.0, 1.0) * t).norm();
    } else {
        const Vec<3> a = v[1] - v[0], b = v[2] - v[0], r = x - v[0];
        const double aa = a.dot(a), ab = a.dot(b), bb = b.dot(b), ra = r.dot(a), rb = r.dot(b);
        const double det = aa * bb - ab * ab;
        const double s = (bb * ra - ab * rb) / det, t = (aa * rb - ab * ra) / det;
        shape = {1 - s - t, s, t};
        if (s >= 0 && t >= 0 && s + t <= 1)
            return (r - s * a - t * b).norm();
        double best = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; ++i) {
            const Vec<3>& p = v[i];
            const Vec<3> e = v[(i + 1) % 3] - p;
            best = std::min(best, (x - p - std::clamp((x - p).dot(e) / e.squaredNorm(), 0.0, 1.0) * e).norm());
        }
        return best;
    }
}

template <int D>
Vec<D> tangential(const Vec<D>& v, const Vec<D>& n)
{
    return v - v.dot(n) * n;
}

} // namespace

template <int D>
FilmMemory<D>::FilmMemory(const Solid<D>& master, const Twist<D>& master_twist, const std::vector<const Film<D>*>& films,
                          const std::vector<Vec<D>>& w, const std::vector<char>& idle, double dx)
    : dx_(dx), rotation_(master.shape.rotation()), centre_body_(master.shape.to_body(master.centre)), twist_(master_twist)
{
    std::vector<double> weight;
    for (const Film<D>* film : films) {
        const int first = static_cast<int>(x_.size());
        for (const Vec<D>& x : film->mesh.x)
            x_.push_back(master.shape.to_body(x));
        h_.insert(h_.end(), film->mesh.h.begin(), film->mesh.h.end());
        for (std::size_t e = 0; e < film->mesh.elements.size(); ++e) {
            const FilmElement<D>& element = film->mesh.elements[e];
            std::array<int, D> nodes = element.nodes;
            Vec<D> centroid = Vec<D>::Zero();
            for (int& node : nodes) {
                node += first;
                centroid += x_[node] / D;
            }
            elements_.push_back(nodes);
            centroid_.push_back(centroid);
            w_.push_back(w[film->first_element + e]);
            normal_.push_back(element.normal);
            idle_.push_back(!idle.empty() && idle[film->first_element + e]);
            weight.push_back(idle_.back() ? 0.0 : element.volume);
            h_mean_.push_back(element.volume / element.measure);
            coarse_.push_back(element.coarse);
            const Vec<D> relative = w_.back() - master_velocity(centroid);
            flux_.push_back(h_mean_.back() * relative);
            volume_ += element.volume;
            motion_ += element.volume * tangential<D>(relative, element.normal).squaredNorm();
        }
    }
    radius_.assign(elements_.size(), 0.0);
    for (std::size_t e = 0; e < elements_.size(); ++e)
        for (int node : elements_[e])
            radius_[e] = std::max(radius_[e], (x_[node] - centroid_[e]).norm());
    if (elements() > few_elements)
        for (int e = 0; e < elements(); ++e)
            bins_[bin_key(bin(centroid_[e]))].push_back(e);
    join_elements();
    fit_vertices(weight);
}

template <int D>
void FilmMemory<D>::join_elements()
{
    EdgeTable first; // facets (2D: nodes) -> D * element + node opposite
    first.reset(2 * elements_.size());
    beyond_.assign(elements_.size(), {});
    for (int e = 0; e < elements(); ++e)
        for (int i = 0; i < D; ++i) {
            beyond_[e][i] = -1;
            int& facet = first.insert(elements_[e][(i + 1) % D], elements_[e][(i + D - 1) % D]);
            if (facet < 0) {
                facet = D * e + i;
            } else {
                beyond_[e][i] = facet / D;
                beyond_[facet / D][facet % D] = e;
            }
        }
}

// Vertex values: linear fit a + b . t to the fluxes of the elements around the vertex (two rings where one is too few), t from
// the vertex in the tangent plane. With weights of sum 1, a = sum w f (1 - (t - <t>) . C^-1 <t>), C the covariance of t.
template <int D>
void FilmMemory<D>::fit_vertices(const std::vector<double>& weight)
{
    const int n = static_cast<int>(x_.size());
    std::vector<int> first(n + 1, 0);
    for (const auto& nodes : elements_)
        for (int node : nodes)
            ++first[node + 1];
    for (int i = 0; i < n; ++i)
        first[i + 1] += first[i];
    std::vector<int> ring(first[n]), next(first.begin(), first.end() - 1);
    for (int e = 0; e < elements(); ++e)
        for (int node : elements_[e])
            ring[next[node]++] = e;
    std::vector<Vec<D>> normal_body(elements_.size());
    for (std::size_t e = 0; e < elements_.size(); ++e)
        normal_body[e] = rotation_.transpose() * normal_[e];

    flux_vertex_.assign(n, Vec<D>::Zero());
    speed_.assign(n, 0.0);
    std::vector<int> around;
    for (int i = 0; i < n; ++i) {
        around.assign(ring.begin() + first[i], ring.begin() + first[i + 1]);
        if (around.size() < (D == 2 ? 2 : 5)) {
            for (int k = first[i]; k < first[i + 1]; ++k)
                for (int node : elements_[ring[k]])
                    around.insert(around.end(), ring.begin() + first[node], ring.begin() + first[node + 1]);
            std::sort(around.begin(), around.end());
            around.erase(std::unique(around.begin(), around.end()), around.end());
        }
        if (around.empty())
            continue;
        double reach = 0, total = 0;
        Vec<D> across = Vec<D>::Zero(); // mean normal, master's frame
        for (int e : around) {
            reach = std::max(reach, (centroid_[e] - x_[i]).squaredNorm());
            total += weight[e];
            across += weight[e] * normal_body[e];
        }
        if (total <= 0) { // idle all around
            flux_vertex_[i] = flux_[around.front()];
            speed_[i] = flux_[around.front()].norm() / h_mean_[around.front()];
            continue;
        }
        const double least = h_[i] * std::pow(std::min(h_[i], smallest_patch * dx_), D - 1);
        for (int e : around)
            speed_[i] += weight[e] / std::max(total, least) * flux_[e].squaredNorm() / (h_mean_[e] * h_mean_[e]);
        speed_[i] = std::sqrt(speed_[i]);
        reach = std::max(std::sqrt(reach), 1e-300);
        across.normalize();
        Vec<D> mean = Vec<D>::Zero();
        Mat<D> covariance = Mat<D>::Zero();
        for (int e : around) {
            const Vec<D> t = tangential<D>(centroid_[e] - x_[i], across) / reach;
            mean += weight[e] / total * t;
            covariance += weight[e] / total * t * t.transpose();
        }
        covariance -= mean * mean.transpose();
        // Slopes across the surface are 0, and so are those of a lone element.
        covariance += across * across.transpose();
        covariance.diagonal().array() += 1e-8;
        const Vec<D> slope = covariance.inverse() * mean;
        for (int e : around) {
            const Vec<D> t = tangential<D>(centroid_[e] - x_[i], across) / reach;
            flux_vertex_[i] += weight[e] / total * (1 - (t - mean).dot(slope)) * flux_[e];
        }
        if (!flux_vertex_[i].allFinite())
            flux_vertex_[i] = flux_[around.front()];
    }
}

template <int D>
Index<D> FilmMemory<D>::bin(const Vec<D>& x_body) const
{
    return (x_body / dx_).array().floor().template cast<int>();
}

template <int D>
long FilmMemory<D>::bin_key(const Index<D>& bin) const
{
    long key = 0;
    for (int axis = 0; axis < D; ++axis)
        key = key * 2000003L + bin[axis] + 1000001L;
    return key;
}

template <int D>
typename FilmMemory<D>::Place FilmMemory<D>::place_in(int element, const Vec<D>& x_body) const
{
    Place place{element, {}, 0};
    std::array<Vec<D>, D> v;
    for (int i = 0; i < D; ++i)
        v[i] = x_[elements_[element][i]];
    place.distance = to_simplex<D>(v, x_body, place.shape);
    return place;
}

// From element to element towards x, across the facet that x lies furthest beyond. Element -1: x lies beyond the film's end.
template <int D>
typename FilmMemory<D>::Place FilmMemory<D>::walk(const Vec<D>& x_body, int start) const
{
    Place place = place_in(start, x_body);
    for (int step = 0; step < longest_walk; ++step) {
        const int i = static_cast<int>(std::min_element(place.shape.begin(), place.shape.end()) - place.shape.begin());
        if (place.shape[i] >= 0)
            return place;
        const int next = beyond_[place.element][i];
        if (next < 0)
            break;
        place = place_in(next, x_body);
    }
    place.element = -1;
    return place;
}

// The element nearest to x; where a walk from the hint ends inside one close to x, that.
template <int D>
typename FilmMemory<D>::Place FilmMemory<D>::locate(const Vec<D>& x_body, int hint) const
{
    Place best{-1, {}, std::numeric_limits<double>::infinity()};
    if (hint >= 0) {
        const Place place = walk(x_body, hint);
        if (place.element >= 0 && place.distance < 0.5 * radius_[place.element])
            return place;
        best = place_in(hint, x_body);
    }
    auto consider = [&](int e) {
        const double least = best.distance + radius_[e];
        if ((x_body - centroid_[e]).squaredNorm() >= least * least)
            return;
        if (const Place place = place_in(e, x_body); place.distance < best.distance)
            best = place;
    };
    if (bins_.empty()) {
        for (int e = 0; e < elements(); ++e)
            consider(e);
        return best;
    }
    for (int reach = 1; reach <= 3; ++reach) {
        for_each_index<D>(Index<D>::Constant(-reach), Index<D>::Constant(reach + 1), [&](const Index<D>& d) {
            if (const std::vector<int>* in_bin = bins_.find(bin_key(Index<D>(bin(x_body) + d))))
                for (int e : *in_bin)
                    consider(e);
        });
        if (best.distance < (reach - 0.5) * dx_)
            return best;
    }
    if (best.element < 0)
        for (int e = 0; e < elements(); ++e)
            consider(e);
    return best;
}

template <int D>
Vec<D> FilmMemory<D>::vertex_velocity(const Vec<D>& x_body, const Place& place) const
{
    // Beyond the film the flux goes on linearly over one element's length; the thickness too, within a factor of two. Inside, the
    // thickness is quadratic: from the vertices and the element's mean (a bubble c sum lambda_i lambda_j of mean 1).
    Vec<D> flux = Vec<D>::Zero();
    double h = 0, mean = 0, bubble = 0, least = std::numeric_limits<double>::infinity(), most = 0;
    for (int i = 0; i < D; ++i) {
        const int node = elements_[place.element][i];
        const double share = std::clamp(place.shape[i], -1.0, 2.0);
        flux += share * flux_vertex_[node];
        h += share * h_[node];
        mean += h_[node] / D;
        for (int j = 0; j < i; ++j)
            bubble += (D == 2 ? 6 : 4) * std::clamp(place.shape[i], 0.0, 1.0) * std::clamp(place.shape[j], 0.0, 1.0);
        least = std::min(least, h_[node]);
        most = std::max(most, h_[node]);
    }
    h += bubble * (h_mean_[place.element] - mean);
    // Where the gap closes to a tip the division would make much of little: no faster than the elements around, nearly.
    Vec<D> relative = flux / std::clamp(h, 0.5 * least, 2 * most);
    const double bound = surplus_bound * speed_about(place.element);
    if (relative.norm() > bound)
        relative *= bound / relative.norm();
    return master_velocity(x_body) + relative;
}

template <int D>
double FilmMemory<D>::at_vertices(std::span<const double> field, const Vec<D>& x_body, int& hint) const
{
    const Place place = locate(x_body, hint);
    hint = place.element;
    if (place.element < 0 || place.distance > beside_film * dx_)
        return 0;
    double value = 0, sum = 0;
    for (int i = 0; i < D; ++i)
        if (place.shape[i] > at_vertex) {
            value += place.shape[i] * field[elements_[place.element][i]];
            sum += place.shape[i];
        }
    return value / sum;
}

template <int D>
double FilmMemory<D>::speed_about(int element) const
{
    double speed = 0;
    for (int node : elements_[element])
        speed = std::max(speed, speed_[node]);
    return speed;
}

template <int D>
Vec<D> FilmMemory<D>::master_velocity(const Vec<D>& x_body) const
{
    return velocity_at<D>(twist_, rotation_ * (x_body - centre_body_));
}

template <int D>
typename FilmMemory<D>::Transported FilmMemory<D>::transport(const Vec<D>& x_body, double dt, int& hint) const
{
    const Place arrival = locate(x_body, hint);
    hint = arrival.element;
    auto relative = [&](const Vec<D>& x, const Place& place) { // along the film, seen from the master, in its frame
        const Vec<D> v = vertex_velocity(x, place) - master_velocity(x);
        return Vec<D>(rotation_.transpose() * tangential<D>(v, normal_[place.element]));
    };
    Place foot = arrival;
    Vec<D> x_foot = x_body;
    if (dt > 0) {
        const Vec<D> middle = x_body - 0.5 * dt * relative(x_body, arrival);
        x_foot = x_body - dt * relative(middle, locate(middle, hint));
        foot = locate(x_foot, hint);
    }
    // What the old element has beyond its vertex values is kept where the new element is the old one and as far as the foot is
    // still in it: no diffusion at rest, and elsewhere that of linear interpolation (kept whole, the scheme would be a centred
    // difference forward in time, which grows; on a changed mesh it would be noise of small cut elements). Not where the element
    // is coarse for its gap: about a point of contact its velocity is noise, and would only gain by this.
    const std::array<int, D>& nodes = elements_[arrival.element];
    const double fastest = idle_[arrival.element] ? std::numeric_limits<double>::infinity() : speed_about(arrival.element);
    const Vec<D>& centroid = centroid_[arrival.element];
    Place middle = arrival;
    middle.shape.fill(1.0 / D);
    double size = 0;
    for (int i = 0; i < D; ++i)
        size = std::max(size, (x_[nodes[i]] - x_[nodes[(i + 1) % D]]).norm());
    const double same = coarse_[arrival.element] ? 0.0
                                                 : std::max(0.0, 1 - (x_body - centroid).norm() / (same_element * size)) *
                                                       std::max(0.0, 1 - (x_body - x_foot).norm() / size);
    return {vertex_velocity(x_foot, foot) + same * (w_[arrival.element] - vertex_velocity(centroid, middle)),
            normal_[foot.element], arrival.distance < memory_reach * dx_, arrival.distance > beside_film * dx_, fastest};
}

template <int D>
const typename FilmMemory<D>::Mouth* FilmMemory<D>::mouth(const Vec<D>& x_body, const Vec<D>& outward) const
{
    const Mouth* best = nullptr;
    double nearest = mouth_reach * dx_;
    for (const Mouth& m : mouths)
        if (m.outward.dot(outward) > 0.5 && (m.place - x_body).norm() < nearest) {
            nearest = (m.place - x_body).norm();
            best = &m;
        }
    return best;
}

template <int D>
std::vector<double> wall_normal_speed(const FilmNetwork<D>& network, std::span<const Solid<D>> solids,
                                      const std::vector<Twist<D>>& twists)
{
    std::vector<double> speed;
    for (const Film<D>& film : network.films) {
        const FilmMesh<D>& mesh = film.mesh;
        for (const FilmElement<D>& e : mesh.elements)
            speed.push_back(0.5 * e.normal.dot(velocity_at<D>(twists[mesh.master], e.centroid - solids[mesh.master].centre) +
                                               velocity_at<D>(twists[mesh.other], e.centroid - solids[mesh.other].centre - mesh.shift)));
    }
    return speed;
}

template <int D>
FilmFlow<D> advect_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const FilmMemories<D>& memories,
                         const std::vector<Twist<D>>& predicted, const VelocitySampler<D>& grid_velocity,
                         const std::function<MouthLaw(int, int)>& law, double dt)
{
    const std::vector<Conduit<D>>& conduits = network.mouths.conduits;
    const int films = static_cast<int>(network.films.size());
    std::vector<const FilmMemory<D>*> memory(films, nullptr); // of each film's pair
    for (int k = 0; k < films; ++k)
        if (auto it = memories.find(network.films[k].pair); it != memories.end())
            memory[k] = it->second.get();

    // What the old films carry to the new elements and conduits.
    using Transported = typename FilmMemory<D>::Transported;
    const Transported unknown{Vec<D>::Zero(), Vec<D>::Zero(), false, false, 0};
    std::vector<Transported> at_element(network.elements, unknown), at_conduit(conduits.size(), unknown);
    for_each_job(films, [&](int k) {
        if (!memory[k])
            return;
        const Film<D>& film = network.films[k];
        const PlacedShape<D>& master = solids[film.pair.master].shape;
        int hint = -1;
        for (std::size_t e = 0; e < film.mesh.elements.size(); ++e)
            at_element[film.first_element + e] =
                memory[k]->transport(master.to_body(film.mesh.elements[e].centroid_master), dt, hint);
    });
    constexpr int chunk = 64;
    for_each_job(static_cast<int>((conduits.size() + chunk - 1) / chunk), [&](int job) {
        for (std::size_t r = static_cast<std::size_t>(job) * chunk; r < std::min(conduits.size(), (job + std::size_t(1)) * chunk); ++r)
            if (const int k = conduits[r].film; memory[k]) {
                int hint = -1;
                at_conduit[r] = memory[k]->at(solids[network.films[k].pair.master].shape.to_body(conduits[r].x), hint);
            }
    });

    // The bulk's velocity where no old film is near.
    std::vector<Vec<D>> places;
    for (const Film<D>& film : network.films)
        for (std::size_t e = 0; e < film.mesh.elements.size(); ++e)
            if (!at_element[film.first_element + e].near)
                places.push_back(film.mesh.elements[e].centroid);
    for (std::size_t r = 0; r < conduits.size(); ++r)
        if (!at_conduit[r].near)
            places.push_back(conduits[r].x);
    const std::vector<Vec<D>> from_grid = grid_velocity(places);
    auto next = from_grid.begin();

    FilmFlow<D> flow;
    const std::vector<double> normal_speed = wall_normal_speed<D>(network, solids, predicted);
    for (const Film<D>& film : network.films)
        for (const FilmElement<D>& e : film.mesh.elements) {
            const Transported& old = at_element[flow.velocity.size()];
            Vec<D> w = old.near ? old.velocity : *next++;
            const Vec<D> n_bar = old.near ? Vec<D>(e.normal + old.normal) : e.normal;
            const double across = n_bar.dot(e.normal);
            flow.normal.push_back(w.dot(e.normal));
            if (across > 0.1 * n_bar.norm())
                w += (normal_speed[flow.velocity.size()] - w.dot(e.normal)) / across * n_bar;
            flow.velocity.push_back(tangential<D>(w, e.normal));
        }
    const auto given_away = limit_motion(network, solids, memory, at_element, at_conduit, dt, flow.velocity);
    std::vector<double> mean_thickness;
    for (const Film<D>& film : network.films) {
        double volume = 0, measure = 0;
        for (const FilmElement<D>& e : film.mesh.elements) {
            volume += e.volume;
            measure += e.measure;
        }
        mean_thickness.push_back(volume / measure);
    }
    std::vector<double> head(conduits.size(), 0.0); // flux that the head of the outflow adds to a mouth
    for (std::size_t r = 0; r < conduits.size(); ++r) {
        const Conduit<D>& conduit = conduits[r];
        const Film<D>& film = network.films[conduit.film];
        const double section = conduit.length * conduit.h;
        double q = 0, scale = 1.0;
        if (at_conduit[r].near) {
            const Vec<D> place = solids[film.pair.master].shape.to_body(conduit.x);
            const Vec<D> w = at_conduit[r].velocity, U = memory[conduit.film]->master_velocity(place);
            const double u = conduit.outward.dot(w - U); // out of the film, seen from the master
            const auto* old = memory[conduit.film]->mouth(place, conduit.outward);
            q = section * conduit.outward.dot(w);
            if (old) {
                const double flux =
                    conduit.length * (old->flux + (conduit.h * conduit.outward - old->h * old->outward).dot(old->master_velocity));
                const double with_master = section * conduit.outward.dot(U), most = mouth_bound * section * at_conduit[r].fastest;
                q = with_master + std::clamp(flux - with_master, -most, most);
            }
            const MouthLaw mouth = law(film.pair.master, film.pair.other);
            const bool sharp = conduit.kind != ConduitKind::smooth && conduit.kind != ConduitKind::inflow;
            if (sharp && u < 0) { // entrance, semi-implicit
                const double k = 1 + mouth.entrance_loss;
                scale = 1 / (1 + dt * k * -u / (2 * conduit.resistance * conduit.h));
                q = scale * q + (1 - scale) * section * conduit.outward.dot(U);
            } else if (sharp && !mouth.jet) {
                const double thickness = conduit.h / mean_thickness[conduit.film];
                const double open = std::min(1.0, thickness / blocked_mouth);
                head[r] = open * open * conduit.length * dt * 0.5 * u * u / conduit.resistance;
                if (thickness < thin_mouth)
                    head[r] = std::min(head[r], section * u);
            }
        } else {
            q = section * conduit.outward.dot(*next++);
        }
        flow.conduit.push_back(q);
        flow.conduit_scale.push_back(scale);
    }
    add_heads(network, solids, memory, given_away, head, flow.conduit);
    return flow;
}

template <int D>
FilmMemories<D> remember_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const std::vector<Twist<D>>& twists,
                               const std::vector<Vec<D>>& u, const std::vector<double>& conduit, double dx,
                               const std::vector<char>& idle)
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
    std::vector<std::shared_ptr<FilmMemory<D>>> memories(list.size());
    for_each_job(static_cast<int>(list.size()), [&](int k) {
        const int master = list[k].first->master;
        memories[k] = std::make_shared<FilmMemory<D>>(solids[master], twists[master], *list[k].second, w, idle, dx);
    });
    for (std::size_t r = 0; r < conduit.size(); ++r) {
        const Conduit<D>& c = network.mouths.conduits[r];
        const FilmPair<D>& pair = network.films[c.film].pair;
        const Solid<D>& master = solids[pair.master];
        memories[number[c.film]]->mouths.push_back({master.shape.to_body(c.x), c.outward, c.h, conduit[r] / c.length,
                                          velocity_at<D>(twists[pair.master], c.x - master.centre), c.kind});
    }
    FilmMemories<D> by_pair;
    for (std::size_t k = 0; k < list.size(); ++k)
        by_pair.emplace_hint(by_pair.end(), *list[k].first, std::move(memories[k]));
    return by_pair;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template class FilmMemory<D>;                                                                                              \
    template FilmFlow<D> advect_films<D>(const FilmNetwork<D>&, std::span<const Solid<D>>, const FilmMemories<D>&,             \
                                         const std::vector<Twist<D>>&, const VelocitySampler<D>&,                              \
                                         const std::function<MouthLaw(int, int)>&, double);                                    \
    template FilmMemories<D> remember_films<D>(const FilmNetwork<D>&, std::span<const Solid<D>>, const std::vector<Twist<D>>&, \
                                               const std::vector<Vec<D>>&, const std::vector<double>&, double, const std::vector<char>&); \
    template std::vector<double> wall_normal_speed<D>(const FilmNetwork<D>&, std::span<const Solid<D>>,                        \
                                                      const std::vector<Twist<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
