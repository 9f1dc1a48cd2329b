// Primal-dual active set: a node below its least pressure becomes a void, a void that overfills becomes wet; all at once in the
// first rounds, then one at a time (the last in order: Murty's rule).
#include "gapflow/stepping/void_set.hpp"

#include "gapflow/film/film_pair_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace gapflow {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// At the start a gap within this of the held distance is in contact, in dx.
constexpr double touching = 1e-6;
// A void shallower than this, in dx, is round-off.
constexpr double shallowest = 1e-14;
// A void that takes this part of its gap has no fluid left that could flow out.
constexpr double drained = 0.5;
// A mouth may shut and reopen once in a step: its flux when open depends on the flux before, so its state and the nodes' could
// alternate without end.
constexpr int most_flips = 2;

} // namespace

VoidLaw void_law(const Scene& scene, const std::string& a, const std::string& b)
{
    const bool dry = scene.gap_of(a, b).contact == GapScene::Contact::dry;
    if (!dry && !scene.vapour_pressure)
        return {-infinity, 0};
    return {scene.vapour_pressure.value_or(0.0), dry ? scene.held_distance(a, b) : 0.0};
}

template <int D>
VoidSet<D>::VoidSet(const Scene& scene, const Grid<D>& grid, const std::vector<Solid<D>>& solids,
                    std::function<double(const Vec<D>&)> hydrostatic)
    : scene_(&scene), dx_(grid.dx()), hydrostatic_(std::move(hydrostatic))
{
    for (const Solid<D>& solid : solids)
        names_.push_back(solid.name);
    possible_ = scene.vapour_pressure.has_value() || scene.gap.contact == GapScene::Contact::dry;
    for (const PairScene& pair : scene.pairs)
        possible_ = possible_ || pair.gap.contact == GapScene::Contact::dry;
}

template <int D>
VoidLaw VoidSet<D>::law(int a, int b) const
{
    return void_law(*scene_, names_[a], names_[b]);
}

template <int D>
void VoidSet<D>::find(const Coupling<D>& coupling, const FilmHistories<D>* histories)
{
    const int nodes = coupling.network.nodes;
    volume_.assign(nodes, 0.0);
    growth_.assign(nodes, 0.0);
    area_.assign(nodes, 0.0);
    least_.assign(nodes, -infinity);
    last_pressure_.assign(nodes, 0.0);
    is_void_.assign(nodes, 0);
    drained_.assign(nodes, 0);
    shut_.assign(coupling.network.rim.mouths.size(), 0);
    flips_.assign(shut_.size(), 0);
    any_ = false;
    if (!possible_)
        return;
    for (const Film<D>& film : coupling.network.films) {
        for (const FilmElement<D>& e : film.mesh.elements)
            for (int node : e.nodes)
                area_[film.first_node + node] += e.measure / D;
        const double least = law(film.pair.master, film.pair.other).least_pressure;
        if (least == -infinity)
            continue;
        any_ = true;
        for (std::size_t i = 0; i < film.mesh.mid.size(); ++i)
            least_[film.first_node + i] = least - hydrostatic_(film.mesh.mid[i]);
    }
    if (histories)
        carry(coupling, *histories);
    else
        start(coupling);
    for (int i = 0; i < nodes; ++i) {
        is_void_[i] = volume_[i] > shallowest * dx_ * area_[i];
        if (!is_void_[i])
            volume_[i] = 0;
        else
            last_pressure_[i] = least_[i];
    }
    for (const Film<D>& film : coupling.network.films)
        for (std::size_t i = 0; i < film.mesh.h.size(); ++i) {
            const std::size_t node = film.first_node + i;
            drained_[node] = is_void_[node] && volume_[node] >= drained * (film.mesh.h[i] + film.mesh.skin) * area_[node];
        }
}

template <int D>
void VoidSet<D>::start(const Coupling<D>& coupling)
{
    for (const Film<D>& film : coupling.network.films) {
        const VoidLaw pair = law(film.pair.master, film.pair.other);
        for (std::size_t i = 0; i < film.mesh.h.size(); ++i)
            if (film.mesh.h[i] + film.mesh.skin < pair.start + touching * dx_)
                volume_[film.first_node + i] = pair.start * area_[film.first_node + i];
    }
}

// The depth of the voids is linear over the old film; the total of a pair is conserved, except for the part that its master has
// carried beyond the film's end: the bulk has no voids.
template <int D>
void VoidSet<D>::carry(const Coupling<D>& coupling, const FilmHistories<D>& histories)
{
    struct Sum {
        double volume = 0, distance = infinity;
        int nearest = -1; ///< node nearest to the old film's deepest void: it takes all if no node lies in one
    };
    std::map<FilmPair<D>, Sum> sums;
    std::set<FilmPair<D>> seen;
    for (const Film<D>& film : coupling.network.films) {
        const auto old = memory_.find(film.pair);
        if (old == memory_.end() || !seen.insert(film.pair).second)
            continue;
        const PlacedShape<D>&master = coupling.solids[film.pair.master].shape,
              other = coupling.solids[film.pair.other].shape.shifted(film.mesh.shift);
        for (std::size_t i = 0; i < old->second.places.size(); ++i)
            if (old->second.volumes[i] > 0 && other.closest(master.to_world(old->second.places[i])).distance > film.threshold)
                old->second.volume -= old->second.volumes[i];
        old->second.volume = std::max(0.0, old->second.volume);
    }
    for (const Film<D>& film : coupling.network.films) {
        const auto old = memory_.find(film.pair);
        const auto place = histories.find(film.pair);
        if (old == memory_.end() || place == histories.end())
            continue;
        Sum& sum = sums[film.pair];
        const PlacedShape<D>& master = coupling.solids[film.pair.master].shape;
        int hint = -1;
        for (std::size_t i = 0; i < film.mesh.x.size(); ++i) {
            const std::size_t node = film.first_node + i;
            const Vec<D> x = master.to_body(film.mesh.x[i]);
            volume_[node] = place->second->at_vertices(old->second.depth, x, hint) * area_[node];
            last_pressure_[node] = place->second->at_vertices(old->second.pressure, x, hint);
            sum.volume += volume_[node];
            if (const double d = (x - old->second.deepest).norm(); d < sum.distance) {
                sum.distance = d;
                sum.nearest = static_cast<int>(node);
            }
        }
    }
    for (const auto& [pair, old] : memory_) {
        auto now = sums.find(pair);
        if (now == sums.end())
            lost_ += old.volume;
        else if (old.volume > 0 && now->second.volume <= 0)
            volume_[now->second.nearest] = now->second.volume = old.volume;
    }
    for (const Film<D>& film : coupling.network.films) {
        const auto now = sums.find(film.pair);
        if (now == sums.end() || now->second.volume <= 0)
            continue;
        const double share = memory_.at(film.pair).volume / now->second.volume;
        for (std::size_t i = 0; i < film.mesh.x.size(); ++i)
            volume_[film.first_node + i] *= share;
    }
    std::erase_if(memory_, [&](const auto& entry) { return !sums.contains(entry.first); });
}

template <int D>
Eigen::VectorXd VoidSet<D>::impulses(double dt) const
{
    Eigen::VectorXd b = Eigen::VectorXd::Zero(static_cast<long>(is_void_.size()));
    for (std::size_t i = 0; i < is_void_.size(); ++i)
        if (is_void_[i])
            b[static_cast<long>(i)] = dt * least_[i];
    return b;
}

template <int D>
Eigen::VectorXd VoidSet<D>::filling(double dt) const
{
    return Eigen::Map<const Eigen::VectorXd>(volume_.data(), static_cast<long>(volume_.size())) / dt;
}

template <int D>
bool VoidSet<D>::update(const Eigen::VectorXd& p, const Eigen::VectorXd& outflow, double dt, double accuracy, bool at_once)
{
    const int nodes = static_cast<int>(is_void_.size());
    auto room = [&](int i) { return volume_[i] / dt + outflow[i]; };
    double largest_excess = 0, largest_room = 0;
    for (int i = 0; i < nodes; ++i)
        if (least_[i] > -infinity) {
            largest_excess = std::max(largest_excess, std::abs(p[i] - dt * least_[i]));
            if (is_void_[i])
                largest_room = std::max({largest_room, volume_[i] / dt, std::abs(outflow[i])});
        }
    int last = -1;
    for (int i = 0; i < nodes; ++i) {
        if (least_[i] == -infinity)
            continue;
        const bool wrong =
            is_void_[i] ? room(i) < -accuracy * largest_room : p[i] - dt * least_[i] < -accuracy * largest_excess;
        if (!wrong)
            continue;
        last = i;
        if (at_once)
            is_void_[i] = !is_void_[i];
    }
    if (last >= 0 && !at_once)
        is_void_[last] = !is_void_[last];
    return last >= 0;
}

template <int D>
bool VoidSet<D>::update_mouths(const std::vector<Mouth<D>>& mouths, const std::vector<double>& flux,
                               const std::vector<double>& drop, double accuracy, bool at_once)
{
    auto at_void = [&](const Mouth<D>& mouth) {
        return std::all_of(mouth.nodes.begin(), mouth.nodes.end(), [&](int node) { return is_void_[node] && drained_[node]; });
    };
    double largest_flux = 0, largest_drop = 0;
    for (std::size_t r = 0; r < mouths.size(); ++r) {
        largest_flux = std::max(largest_flux, std::abs(flux[r]));
        largest_drop = std::max(largest_drop, std::abs(drop[r]));
    }
    bool changed = false;
    for (std::size_t r = mouths.size(); r-- > 0;) {
        const bool wrong = shut_[r] ? !at_void(mouths[r]) || drop[r] < -accuracy * largest_drop
                                    : at_void(mouths[r]) && flux[r] > accuracy * largest_flux;
        if (!wrong || flips_[r] == most_flips)
            continue;
        ++flips_[r];
        shut_[r] = !shut_[r];
        changed = true;
        if (!at_once)
            break;
    }
    return changed;
}

template <int D>
void VoidSet<D>::finish(const Coupling<D>& coupling, const Eigen::VectorXd& p, const Eigen::VectorXd& outflow, double dt)
{
    for (std::size_t i = 0; i < is_void_.size(); ++i) {
        const double before = volume_[i];
        volume_[i] = is_void_[i] ? std::max(0.0, before + dt * outflow[static_cast<long>(i)]) : 0.0;
        if (volume_[i] <= shallowest * dx_ * area_[i])
            volume_[i] = 0;
        growth_[i] = dt > 0 ? (volume_[i] - before) / dt : 0.0;
        is_void_[i] = volume_[i] > 0;
    }
    memory_.clear();
    for (const Film<D>& film : coupling.network.films) {
        if (law(film.pair.master, film.pair.other).least_pressure == -infinity)
            continue;
        Memory& history = memory_[film.pair];
        double deepest = history.depth.empty() ? -1 : *std::max_element(history.depth.begin(), history.depth.end());
        for (std::size_t i = 0; i < film.mesh.h.size(); ++i) {
            const std::size_t node = film.first_node + i;
            history.depth.push_back(depth(static_cast<int>(node)));
            history.pressure.push_back(dt > 0 ? p[static_cast<long>(node)] / dt : last_pressure_[node]);
            history.places.push_back(coupling.solids[film.pair.master].shape.to_body(film.mesh.x[i]));
            history.volumes.push_back(volume_[node]);
            history.volume += volume_[node];
            if (history.depth.back() > deepest) {
                deepest = history.depth.back();
                history.deepest = coupling.solids[film.pair.master].shape.to_body(film.mesh.x[i]);
            }
        }
    }
}

template <int D>
std::vector<char> VoidSet<D>::empty_elements(const FilmNetwork<D>& network) const
{
    std::vector<char> empty(network.elements, 0);
    for (const Film<D>& film : network.films)
        for (std::size_t e = 0; e < film.mesh.elements.size(); ++e) {
            const auto& nodes = film.mesh.elements[e].nodes;
            empty[film.first_element + e] =
                std::all_of(nodes.begin(), nodes.end(), [&](int node) { return is_void_[film.first_node + node]; });
        }
    return empty;
}

template <int D>
void VoidSet<D>::find_wet_shares(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists)
{
    wet_ = {};
    if (!any_)
        return;
    const FilmNetwork<D>& network = coupling.network;
    std::vector<double> share(network.nodes, 1.0);
    for (const Film<D>& film : network.films)
        for (std::size_t i = 0; i < film.mesh.h.size(); ++i)
            if (const std::size_t node = film.first_node + i; volume_[node] > 0)
                share[node] = std::max(0.0, 1 - depth(static_cast<int>(node)) / (film.mesh.h[i] + film.mesh.skin));
    // Velocity of the film's fluid relative to the master.
    auto passes = [&](const FilmMesh<D>& mesh, const Vec<D>& x) {
        return Vec<D>(0.5 * (velocity_at<D>(twists[mesh.other], x - coupling.solids[mesh.other].centre - mesh.shift) -
                             velocity_at<D>(twists[mesh.master], x - coupling.solids[mesh.master].centre)));
    };
    for (const Film<D>& film : network.films)
        for (const FilmElement<D>& e : film.mesh.elements) {
            const Vec<D> u = passes(film.mesh, e.centroid);
            double sum = 0, weights = 0, mean = 0;
            for (int i = 0; i < D; ++i) {
                const double of_node = share[film.first_node + e.nodes[i]], upstream = std::max(0.0, -e.gradient[i].dot(u));
                sum += upstream * of_node;
                weights += upstream;
                mean += of_node / D;
            }
            wet_.elements.push_back(weights > 0 ? sum / weights : mean);
        }
    for (const Mouth<D>& mouth : network.rim.mouths) {
        double of_nodes = 0;
        for (int i = 0; i < D - 1; ++i)
            of_nodes += mouth.shape[i] * share[mouth.nodes[i]];
        const bool out = mouth.outward.dot(passes(network.films[mouth.film].mesh, mouth.x)) >= 0;
        wet_.mouths.push_back(out ? of_nodes : 1.0);
    }
}

template <int D>
void VoidSet<D>::list_state(StateArchive& archive)
{
    archive.group("voids", [&] {
        archive("any", any_);
        archive("volume", volume_);
        archive("area", area_);
        archive("growth", growth_);
        archive("least_pressure", least_);
        archive("last_pressure", last_pressure_);
        archive("is_void", is_void_);
        archive("drained", drained_);
        archive("shut", shut_);
        archive("lost", lost_);
        archive("wet_elements", wet_.elements);
        archive("wet_conduits", wet_.mouths);
        std::vector<std::pair<FilmPair<D>, Memory>> pairs(memory_.begin(), memory_.end());
        archive.each("pairs", pairs, [](StateArchive& list, auto& entry) {
            gapflow::list_state(list, entry.first);
            list("depth", entry.second.depth);
            list("pressure", entry.second.pressure);
            list("places", entry.second.places);
            list("volumes", entry.second.volumes);
            list("volume", entry.second.volume);
            list("deepest", entry.second.deepest);
        });
        memory_ = {pairs.begin(), pairs.end()};
    });
}

template class VoidSet<2>;
template class VoidSet<3>;

} // namespace gapflow
