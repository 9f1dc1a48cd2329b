#include "gapflow/film/film_transport.hpp"

#include "gapflow/film/edge_table.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

// Largest part of an element's volume that enters in a sub-step. Elements so small that they would ask for more than `most_sub_steps` follow
// the flow with a delay.
constexpr double courant = 0.5;
constexpr int most_sub_steps = 16;
// Part of the last step's acceleration that fluid which crosses three elements or more in a step goes without, from two on. The acceleration includes what
// answered the last step's transport, and grows 1.26 times a step where fluid crosses 0.64 of a wave in it, without this part (validation, gate on its
// seats).
constexpr double damping = 0.25;
// Of the implicit step's solution, in the film's largest speed; sweeps for it.
constexpr double accuracy = 1e-9;
constexpr int most_sweeps = 100;

// The mean thickness of an element over that at a facet: what a mesh resolves (FilmMeshOptions::ratio). Beyond, at a point of contact, h u is not
// linear in the element.
constexpr double steepest = 1.5;

struct InOrderOfFilms {
    bool operator()(const auto& mouth, int film) const { return mouth.film < film; }
    bool operator()(int film, const auto& mouth) const { return film < mouth.film; }
};

} // namespace

template <int D>
FilmTransport<D>::FilmTransport(const FilmNetwork<D>& network, int number, const PlacedShape<D>& master,
                                std::span<const FluidInPlace<D>> start, std::span<const Vec<D>> flow,
                                std::span<const MouthFlow<D>> mouth_flow, double dt)
    : mesh_(network.films[number].mesh), first_node_(network.films[number].first_node), start_(start), dt_(dt)
{
    const Mat<D> to_master = master.rotation().transpose();
    for (const Vec<D>& x : mesh_.x)
        x_.push_back(master.to_body(x));
    std::vector<std::array<int, D>> nodes;
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i) {
        const FilmElement<D>& e = mesh_.elements[i];
        nodes.push_back(e.nodes);
        centroid_.push_back(master.to_body(e.centroid_master));
        normal_.push_back(to_master * e.normal);
        gradient_.emplace_back();
        for (int k = 0; k < D; ++k)
            gradient_.back()[k] = to_master * e.gradient[k];
        end_volume_.push_back(e.volume);
        start_volume_.push_back(start[i].volume + start[i].covered);
        mean_h_.push_back(e.volume / e.measure);
    }
    fit_ = vertex_fit<D>(x_, nodes, centroid_, normal_, end_volume_);
    find_facets(network.rim, number, mouth_flow);
    for (Facet& facet : facets_) {
        for (int node : facet.nodes)
            facet.h += mesh_.h[node] / (D - 1);
        facet.h *= facet.b < 0 ? mesh_.elements[facet.a].cosine()
                               : 0.5 * (mesh_.elements[facet.a].cosine() + mesh_.elements[facet.b].cosine());
        facet.h = std::max(facet.h, mean_h_[facet.a] / steepest);
        if (facet.b >= 0)
            facet.h = std::max(facet.h, mean_h_[facet.b] / steepest);
    }
    balance_corners(flow);
    choose_sub_steps();
}

template <int D>
void FilmTransport<D>::find_facets(const RimLinks<D>& rim, int number, std::span<const MouthFlow<D>> mouth_flow)
{
    const int count = static_cast<int>(mesh_.elements.size());
    facet_of_.assign(count, {});
    EdgeTable table; // nodes of a facet (2D: its node twice) -> D * element + opposite node, then -2 - facet
    table.reset(2 * mesh_.elements.size());
    for (int e = 0; e < count; ++e)
        for (int i = 0; i < D; ++i) {
            facet_of_[e][i] = -1;
            const auto& nodes = mesh_.elements[e].nodes;
            int& known = table.insert(nodes[(i + 1) % D], nodes[(i + D - 1) % D]);
            if (known < 0) {
                known = D * e + i;
                continue;
            }
            Facet facet{known / D, e};
            for (int k = 1; k < D; ++k)
                facet.nodes[k - 1] = nodes[(i + k) % D];
            facet_of_[known / D][known % D] = facet_of_[e][i] = static_cast<int>(facets_.size());
            facets_.push_back(facet);
        }
    inner_facets_ = facets_.size();
    mouth_at_corner_.assign(D * count, 0.0);
    const auto own = std::equal_range(rim.mouths.begin(), rim.mouths.end(), number, InOrderOfFilms());
    for (auto it = own.first; it != own.second; ++it) {
        const Mouth<D>& mouth = *it;
        const std::size_t r = it - rim.mouths.begin();
        Facet facet{-1, -1, mouth_flow[r].flux, 0, mouth_flow[r]};
        for (int k = 0; k < D - 1; ++k)
            facet.nodes[k] = mouth.nodes[k] - first_node_;
        const int known = table.find(facet.nodes[0], facet.nodes[D - 2]);
        if (known < 0 || facet_of_[known / D][known % D] >= 0)
            continue;
        facet.a = known / D;
        for (int k = 0; k < D - 1; ++k)
            for (int i = 0; i < D; ++i)
                if (mesh_.elements[facet.a].nodes[i] == facet.nodes[k])
                    mouth_at_corner_[D * facet.a + i] += facet.flux * mouth.shape[k];
        facets_.push_back(facet);
    }
}

// The elements around a node that share facets there, in order, from an unvisited one. `closed`: the last one joins the first.
template <int D>
std::vector<int> FilmTransport<D>::chain(int node, const VertexRings& rings, std::vector<char>& visited, bool& closed) const
{
    auto facets_at = [&](int e) { // facets of an element that contain the node
        std::array<int, 2> at{-1, -1};
        int n = 0;
        for (int i = 0; i < D; ++i)
            if (mesh_.elements[e].nodes[i] != node)
                at[n++] = facet_of_[e][i];
        return at;
    };
    auto other = [&](int facet, int e) { return facets_[facet].a == e ? facets_[facet].b : facets_[facet].a; };
    const int begin = rings.first[node], end = rings.first[node + 1];
    auto place = [&](int e) {
        return std::find(rings.element.begin() + begin, rings.element.begin() + end, e) - rings.element.begin();
    };
    int first = -1;
    for (int k = begin; k < end; ++k)
        if (!visited[k]) {
            const auto at = facets_at(rings.element[k]);
            if (first < 0 || at[0] < 0 || (D == 3 && at[1] < 0))
                first = rings.element[k];
            if (at[0] < 0 || (D == 3 && at[1] < 0))
                break;
        }
    std::vector<int> list;
    closed = false;
    int from = -1;
    for (int e = first; e >= 0;) {
        visited[place(e)] = 1;
        list.push_back(e);
        int next = -1, through = -1;
        for (int facet : facets_at(e))
            if (facet >= 0 && facet != from && next < 0) {
                next = other(facet, e);
                through = facet;
            }
        if (next >= 0 && visited[place(next)]) {
            closed = next == first && list.size() > 2;
            break;
        }
        from = through;
        e = next;
    }
    return list;
}

// Fluxes between the corners around each node. A corner's volume, int h N_i, changes by what flows along its own element, through
// mouths and to the corners beside it. What the node's balance lacks is shared by its corners' volumes.
template <int D>
void FilmTransport<D>::balance_corners(std::span<const Vec<D>> flow)
{
    const int count = static_cast<int>(mesh_.elements.size());
    std::vector<double> corner(D * count, 0.0), needs(D * count, 0.0);
    for (int e = 0; e < count; ++e) {
        double sum = 0;
        for (int node : mesh_.elements[e].nodes)
            sum += mesh_.h[node];
        for (int i = 0; i < D; ++i) {
            double& volume = corner[D * e + i];
            // int h N_i of an h that is linear: (sum + h_i) over (D + 1) sums
            volume = end_volume_[e] * (sum + mesh_.h[mesh_.elements[e].nodes[i]]) / ((D + 1) * sum);
            // The old volume has the new one's distribution in the element.
            const double change = (end_volume_[e] - start_volume_[e]) / end_volume_[e] * volume / dt_;
            const double along = flow[e].dot(gradient_[e][i]);
            needs[D * e + i] = change - along + mouth_at_corner_[D * e + i];
        }
    }
    std::vector<std::array<int, D>> nodes;
    for (const FilmElement<D>& e : mesh_.elements)
        nodes.push_back(e.nodes);
    const VertexRings rings = vertex_rings<D>(mesh_.x.size(), nodes);
    std::vector<char> visited(rings.element.size(), 0);
    for (std::size_t node = 0; node < mesh_.x.size(); ++node)
        for (int k = rings.first[node]; k < rings.first[node + 1]; ++k) {
            if (visited[k])
                continue;
            bool closed = false;
            const std::vector<int> list = chain(static_cast<int>(node), rings, visited, closed);
            auto local = [&](int e) {
                const auto& at = mesh_.elements[e].nodes;
                return D * e + static_cast<int>(std::find(at.begin(), at.end(), static_cast<int>(node)) - at.begin());
            };
            double lack = 0, volume = 0;
            for (int e : list) {
                lack += needs[local(e)];
                volume += corner[local(e)];
            }
            std::vector<double> onwards; // flux from each element to the next
            double flux = 0, mean = 0;
            for (int e : list) {
                flux -= needs[local(e)] - lack * corner[local(e)] / volume;
                onwards.push_back(flux);
                mean += flux / static_cast<double>(list.size());
            }
            const std::size_t joined = closed ? list.size() : list.size() - 1;
            for (std::size_t j = 0; j < joined; ++j) {
                const int a = list[j], b = list[(j + 1) % list.size()];
                for (int i = 0; i < D; ++i) {
                    const int f = facet_of_[a][i];
                    if (f >= 0 && (facets_[f].a == b || facets_[f].b == b))
                        facets_[f].flux += (facets_[f].a == a ? 1 : -1) * (onwards[j] - (closed ? mean : 0.0));
                }
            }
        }
}

template <int D>
void FilmTransport<D>::choose_sub_steps()
{
    std::vector<double> enters(mesh_.elements.size(), 0.0);
    for (const Facet& facet : facets_) {
        if (facet.b >= 0)
            enters[facet.b] += std::max(facet.flux, 0.0);
        enters[facet.a] += std::max(-facet.flux, 0.0);
    }
    double largest = 0;
    for (std::size_t e = 0; e < enters.size(); ++e) {
        const double number = enters[e] * dt_ / std::max(std::min(start_volume_[e], end_volume_[e]), 1e-300);
        largest = std::max(largest, number);
        acceleration_.push_back(std::clamp(1 + damping * (2 - number), 1 - damping, 1.0) * start_[e].acceleration);
    }
    sub_steps_ = static_cast<int>(std::clamp(std::ceil(largest / courant), 1.0, static_cast<double>(most_sub_steps)));
}

// A facet's value, in the tangent plane of the element that it comes from, in that of the element e.
template <int D>
Vec<D> FilmTransport<D>::into(int e, const Facet& facet, const Vec<D>& value) const
{
    const int from = facet.flux >= 0 ? facet.a : facet.b;
    return from < 0 ? tangential<D>(value, normal_[e]) : from == e ? value : turned<D>(value, normal_[from], normal_[e]);
}

// Velocities at the facets, from the side that the flow comes from. The flux h u is linear in an element.
template <int D>
std::vector<Vec<D>> FilmTransport<D>::reconstructed(const std::vector<Vec<D>>& velocity) const
{
    std::vector<Vec<D>> flux, vertex, values(facets_.size());
    for (std::size_t e = 0; e < velocity.size(); ++e)
        flux.push_back(mean_h_[e] * velocity[e]);
    for (std::size_t i = 0; i < x_.size(); ++i)
        vertex.push_back(fit_.at(static_cast<int>(i), flux, Vec<D>(Vec<D>::Zero())));
    auto increment = [&](int e, const Facet& facet) { // from the element's mean to the facet
        Vec<D> change = Vec<D>::Zero();
        for (int node : facet.nodes)
            change += vertex[node] / (D - 1);
        for (int node : mesh_.elements[e].nodes)
            change -= vertex[node] / D;
        return tangential<D>(change, normal_[e]);
    };
    std::vector<std::array<Vec<D>, D>> beside(velocity.size()); // differences to the means of the elements beside each
    for (std::size_t e = 0; e < velocity.size(); ++e)
        for (int i = 0; i < D; ++i) {
            const int f = facet_of_[e][i];
            const int n = f < 0 ? -1 : facets_[f].a == static_cast<int>(e) ? facets_[f].b : facets_[f].a;
            beside[e][i] = n < 0 ? Vec<D>(Vec<D>::Zero()) : Vec<D>(turned<D>(flux[n], normal_[n], normal_[e]) - flux[e]);
        }
    // At no facet does the flux go further than the mean of an element beside this one: linear fields keep their slope on any mesh.
    std::vector<double> slope(velocity.size(), 1.0);
    std::vector<std::array<Vec<D>, 2>> change_of(inner_facets_); // of a facet's two elements
    for (std::size_t f = 0; f < inner_facets_; ++f)
        for (int side = 0; side < 2; ++side) {
            const int e = side == 0 ? facets_[f].a : facets_[f].b;
            const Vec<D> change = change_of[f][side] = increment(e, facets_[f]);
            double along = 0;
            for (const Vec<D>& d : beside[e])
                along = std::max(along, change.dot(d));
            const double square = change.squaredNorm();
            slope[e] = std::min(slope[e], along < square ? along / square : 1.0);
        }
    // Between the velocities of the two elements: the gap's thickness makes no new extremum either. And what an element loses by its own
    // changes goes no further than what flows into it brings.
    std::vector<Vec<D>> enters(velocity.size(), Vec<D>::Zero()), leaves = enters;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
        const Facet& facet = facets_[f];
        const int from = facet.flux >= 0 ? facet.a : facet.b, to = facet.flux >= 0 ? facet.b : facet.a;
        if (from < 0) {
            values[f] = facet.mouth.entering;
        } else {
            Vec<D>& change = values[f];
            const Vec<D> in_flux = f < inner_facets_ ? change_of[f][from == facet.a ? 0 : 1] : increment(from, facet);
            change = (flux[from] + slope[from] * in_flux) / facet.h - velocity[from];
            if (to >= 0) {
                const Vec<D> d = turned<D>(velocity[to], normal_[to], normal_[from]) - velocity[from];
                const double square = change.squaredNorm(),
                             along = change.dot(d); // in the ball between both: continuous in its direction
                change *= along <= 0 ? 0.0 : along < square ? along / square : 1.0;
            }
            leaves[from] += std::abs(facet.flux) * change;
        }
        if (to >= 0)
            enters[to] +=
                std::abs(facet.flux) * (velocity[to] - into(to, facet, from < 0 ? facet.mouth.entering : velocity[from]));
    }
    // Of its changes those are reduced that exceed what the others balance: where fluid leaves to both sides of an element the sum is a small difference.
    std::vector<double> exceeds(velocity.size(), 0.0);
    for (std::size_t f = 0; f < facets_.size(); ++f)
        if (const int from = facets_[f].flux >= 0 ? facets_[f].a : facets_[f].b; from >= 0)
            exceeds[from] += std::max(std::abs(facets_[f].flux) * values[f].dot(leaves[from]), 0.0);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
        const int from = facets_[f].flux >= 0 ? facets_[f].a : facets_[f].b;
        if (from < 0)
            continue;
        Vec<D>& change = values[f];
        const double square = leaves[from].squaredNorm(), allowed = std::clamp(leaves[from].dot(enters[from]), 0.0, square);
        if (allowed < square && change.dot(leaves[from]) > 0)
            change *= std::max(1 - (square - allowed) / exceeds[from], 0.0);
        change += velocity[from];
    }
    return values;
}

template <int D>
std::vector<Vec<D>> FilmTransport<D>::rates(const std::vector<Vec<D>>& velocity, const std::vector<Vec<D>>& values,
                                            double share) const
{
    std::vector<Vec<D>> rate(velocity.size(), Vec<D>::Zero());
    std::vector<double> enters(velocity.size(), 0.0);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
        const Facet& facet = facets_[f];
        rate[facet.a] -= facet.flux * (into(facet.a, facet, values[f]) - velocity[facet.a]);
        enters[facet.a] += std::max(-facet.flux, 0.0);
        if (facet.b >= 0) {
            rate[facet.b] += facet.flux * (into(facet.b, facet, values[f]) - velocity[facet.b]);
            enters[facet.b] += std::max(facet.flux, 0.0);
        }
    }
    const double dt = dt_ / sub_steps_;
    for (std::size_t e = 0; e < velocity.size(); ++e)
        rate[e] /= std::max(volume(static_cast<int>(e), share), enters[e] * dt / courant);
    return rate;
}

template <int D>
void FilmTransport<D>::count_energy(const std::vector<Vec<D>>& values, double dt, Carried<D>& result) const
{
    for (std::size_t f = inner_facets_; f < facets_.size(); ++f)
        (facets_[f].flux >= 0 ? result.out : result.in) += 0.5 * dt * std::abs(facets_[f].flux) * values[f].squaredNorm();
}

// One implicit step: (S + dt sum F_in) u' = S u + dt sum F_in u'_in, by Gauss and Seidel's method there and back along the film. As conservative as the
// fluxes, and stable however little volume an element has.
template <int D>
Carried<D> FilmTransport<D>::low() const
{
    Carried<D> result;
    std::vector<double> enters(start_.size(), 0.0);
    std::vector<std::vector<int>> from(start_.size()); // facets through which each element is entered
    std::vector<double> stays = end_volume_;           // what the fluxes leave of the start's volume, and what has left
    for (std::size_t f = 0; f < facets_.size(); ++f) {
        const Facet& facet = facets_[f];
        const int source = facet.flux >= 0 ? facet.a : facet.b, to = facet.flux >= 0 ? facet.b : facet.a;
        const double volume = dt_ * std::abs(facet.flux);
        if (source >= 0)
            stays[source] += volume;
        if (to >= 0) {
            stays[to] -= volume;
            enters[to] += volume;
            from[to].push_back(static_cast<int>(f));
        }
    }
    // Where they need more volume than there is, it shares the start's energy; and the start's momentum relative to the master, of which the step takes
    // what is across the film.
    for (std::size_t e = 0; e < start_.size(); ++e) {
        stays[e] = std::max(stays[e], 0.0);
        const double known = stays[e] > start_volume_[e] ? start_volume_[e] / stays[e] : 1.0;
        result.velocity.push_back(std::sqrt(known) * start_[e].velocity + dt_ * start_[e].inertial);
        result.world.push_back(known * start_[e].world + (1 - known) * start_[e].master);
    }
    std::vector<Vec<D>>&u = result.velocity, &w = result.world;
    const std::vector<Vec<D>> first = u, first_world = w;
    auto update = [&](int e) {
        if (enters[e] <= 0)
            return 0.0;
        Vec<D> momentum = stays[e] * first[e], world = stays[e] * first_world[e];
        for (int f : from[e]) {
            const Facet& facet = facets_[f];
            const int source = facet.flux >= 0 ? facet.a : facet.b;
            const double volume = dt_ * std::abs(facet.flux);
            momentum += volume * into(e, facet, source < 0 ? facet.mouth.entering : u[source]);
            world += volume * (source < 0 ? facet.mouth.world : w[source]);
        }
        const Vec<D> next = momentum / (stays[e] + enters[e]);
        const double change = (next - u[e]).norm();
        u[e] = next;
        w[e] = world / (stays[e] + enters[e]);
        return change;
    };
    double fastest = 0;
    for (const Vec<D>& v : u)
        fastest = std::max(fastest, v.norm());
    const int count = static_cast<int>(u.size());
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        double change = 0;
        for (int e = 0; e < count; ++e)
            change = std::max(change, update(e));
        for (int e = count; e-- > 0;)
            change = std::max(change, update(e));
        if (change <= accuracy * fastest)
            break;
    }
    std::vector<Vec<D>> values(facets_.size());
    for (std::size_t f = inner_facets_; f < facets_.size(); ++f)
        values[f] = facets_[f].flux >= 0 ? u[facets_[f].a] : facets_[f].mouth.entering;
    count_energy(values, dt_, result);
    return result;
}

template <int D>
Carried<D> FilmTransport<D>::high() const
{
    Carried<D> result;
    for (const FluidInPlace<D>& place : start_)
        result.velocity.push_back(place.velocity);
    std::vector<Vec<D>>& u = result.velocity;
    const double dt = dt_ / sub_steps_;
    for (int k = 0; k < sub_steps_; ++k) {
        const std::vector<Vec<D>> first_values = reconstructed(u);
        const std::vector<Vec<D>> first = rates(u, first_values, static_cast<double>(k) / sub_steps_);
        std::vector<Vec<D>> next = u;
        for (std::size_t e = 0; e < u.size(); ++e)
            next[e] += dt * (first[e] + acceleration_[e] + start_[e].inertial);
        const std::vector<Vec<D>> second_values = reconstructed(next);
        const std::vector<Vec<D>> second = rates(next, second_values, (k + 1.0) / sub_steps_);
        for (std::size_t e = 0; e < u.size(); ++e)
            u[e] += dt * (0.5 * (first[e] + second[e]) + acceleration_[e] + start_[e].inertial);
        count_energy(first_values, 0.5 * dt, result);
        count_energy(second_values, 0.5 * dt, result);
    }
    for (std::size_t e = 0; e < u.size(); ++e)
        u[e] -= dt_ * acceleration_[e];
    return result;
}

template class FilmTransport<2>;
template class FilmTransport<3>;

} // namespace gapflow
