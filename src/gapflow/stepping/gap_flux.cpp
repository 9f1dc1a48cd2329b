// A pair may have several films. What one of them passes on to another, through a joint or through cells that mouths of both lead to (at an edge
// around which the gap goes on), stays in the gap. So mouths of different films with a cell in common are one end of the gap, with the sum of
// their fluxes q. With the direction t, x the middle of an end, and m the middle of the films that pass fluid on to each other, by their extent
// along t,
//
//     Q = 1/2 sum q sgn((x - m) . t)
//
// is what flows through the gap along t, exactly where no volume changes, and 0 where films are squeezed alike to both sides.
#include "gapflow/stepping/gap_flux.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <vector>

namespace gapflow {

namespace {

/// Numbers that are joined to groups.
class Groups {
public:
    explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
    int of(int i) const
    {
        while (parent_[i] != i)
            i = parent_[i];
        return i;
    }
    /// The group keeps the lower number.
    void join(int i, int j)
    {
        const auto [low, high] = std::minmax({of(i), of(j)});
        parent_[high] = low;
    }

private:
    std::vector<int> parent_;
};

/// Where fluid leaves the gap.
template <int D>
struct End {
    int film;
    double flux; ///< out of the gap
    Vec<D> x;
};

template <int D>
class GapWithEnds {
public:
    GapWithEnds(const Coupling<D>& here, const State<D>& state, const std::array<std::string, 2>& bodies)
        : network_(here.network), groups_(network_.films.size())
    {
        for (std::size_t k = 0; k < network_.films.size(); ++k) {
            const FilmMesh<D>& mesh = network_.films[k].mesh;
            const std::string &a = here.solids[mesh.master].name, &b = here.solids[mesh.other].name;
            of_pair_.push_back((a == bodies[0] && b == bodies[1]) || (a == bodies[1] && b == bodies[0]));
        }
        find_mouths(state);
        for (std::size_t r = network_.rim.mouths.size(); r < here.system.links.size() && network_.nodes > 0; ++r)
            add_joint(state, here.system.links[r]);
    }

    bool any() const { return std::find(of_pair_.begin(), of_pair_.end(), true) != of_pair_.end(); }
    const std::vector<End<D>>& ends() const { return ends_; }

    /// What flows along a direction.
    double along(const Vec<D>& direction) const
    {
        std::map<int, std::pair<double, double>> extent; // of each group of films
        for (std::size_t k = 0; k < network_.films.size(); ++k)
            for (const Vec<D>& x : network_.films[k].mesh.mid) {
                const double height = x.dot(direction);
                auto& [low, high] = extent.try_emplace(groups_.of(static_cast<int>(k)), height, height).first->second;
                low = std::min(low, height);
                high = std::max(high, height);
            }
        double sum = 0;
        for (const End<D>& end : ends_) {
            const auto [low, high] = extent.at(groups_.of(end.film));
            const double height = end.x.dot(direction) - 0.5 * (low + high);
            if (std::abs(height) > 1e-9 * (high - low)) // one in the middle, to round-off, counts to neither side
                sum += height > 0 ? end.flux : -end.flux;
        }
        return 0.5 * sum;
    }

private:
    void find_mouths(const State<D>& state)
    {
        const std::vector<Mouth<D>>& mouths = network_.rim.mouths;
        Groups ends(mouths.size());
        std::map<long, std::vector<int>> leading_to; // cells
        for (int r = 0; r < static_cast<int>(mouths.size()); ++r)
            for (const auto& [key, weight] : mouths[r].cells)
                if (of_pair_[mouths[r].film])
                    leading_to[key].push_back(r);
        for (const auto& [key, list] : leading_to)
            for (const int r : list)
                for (const int s : list)
                    if (mouths[r].film != mouths[s].film) {
                        ends.join(r, s);
                        groups_.join(mouths[r].film, mouths[s].film);
                    }
        std::map<int, std::pair<End<D>, int>> sums; // in the order of their first mouths; how many
        for (int r = 0; r < static_cast<int>(mouths.size()); ++r) {
            if (!of_pair_[mouths[r].film])
                continue;
            auto& [end, count] = sums.try_emplace(ends.of(r), End<D>{mouths[r].film, 0.0, Vec<D>::Zero()}, 0).first->second;
            end.flux += state.velocity.mouth[r];
            end.x += mouths[r].x;
            ++count;
        }
        for (auto& [first, sum] : sums) {
            sum.first.x /= sum.second;
            ends_.push_back(sum.first);
        }
    }

    // Its flow leaves the nodes of positive weight.
    void add_joint(const State<D>& state, const Link& link)
    {
        std::optional<int> own;
        bool leaves = false;
        double sign = 0;
        Vec<D> x;
        for (const auto& [node, weight] : link.nodes) {
            const int k = film_of(node);
            if (!of_pair_[k]) {
                leaves = true;
                continue;
            }
            if (own)
                groups_.join(*own, k);
            own = k;
            x = network_.films[k].mesh.mid[node - network_.films[k].first_node];
            sign += weight;
        }
        if (own && leaves)
            ends_.push_back({*own, (sign > 0 ? 1 : -1) * flux_of_joint(state, link), x});
    }

    int film_of(int node) const
    {
        const auto next = std::upper_bound(network_.films.begin(), network_.films.end(), node,
                                           [](int n, const Film<D>& f) { return n < f.first_node; });
        return static_cast<int>(next - network_.films.begin()) - 1;
    }

    const FilmNetwork<D>& network_;
    Groups groups_; ///< films that pass fluid on to each other
    std::vector<bool> of_pair_;
    std::vector<End<D>> ends_;
};

} // namespace

template <int D>
double flux_of_joint(const State<D>& state, const Link& link)
{
    double drop = 0;
    for (const auto& [node, weight] : link.nodes)
        drop += weight * state.pressure.impulse.nodes[node];
    return link.conductance * drop;
}

template <int D>
VolumeFlux flux_through_gap(const Coupling<D>& here, const State<D>& state, const FluxScene& through)
{
    const GapWithEnds<D> gap(here, state, through.bodies);
    if (!gap.any()) {
        const double none = std::numeric_limits<double>::quiet_NaN();
        return {none, none, none, none, none};
    }
    VolumeFlux result;
    for (const End<D>& end : gap.ends()) {
        result.inflow += std::max(-end.flux, 0.0);
        result.outflow += std::max(end.flux, 0.0);
    }
    result.flux = through.along ? gap.along(Vec<D>(through.along->data())) : 0.5 * (result.inflow + result.outflow);
    result.film = result.flux;
    return result;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template double flux_of_joint<D>(const State<D>&, const Link&);                                                            \
    template VolumeFlux flux_through_gap<D>(const Coupling<D>&, const State<D>&, const FluxScene&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
