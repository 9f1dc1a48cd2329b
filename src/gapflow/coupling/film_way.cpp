#include "gapflow/coupling/film_way.hpp"

#include "gapflow/core/sparse_cholesky.hpp"
#include "gapflow/coupling/film_drag.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

double mean_of_cube(double h, double before)
{
    return h * (before + h) / (2 * before * before);
}

double mean_of_inverse(double h, double before)
{
    const double ratio = before / h - 1;
    return std::abs(ratio) < 1e-6 ? 1 - 0.5 * ratio : std::log1p(ratio) / ratio;
}

// Geometric mean over the element's nodes of f(h, h - opened).
template <int D, class F>
double over_nodes(const FilmMesh<D>& mesh, const FilmElement<D>& e, double opened, F&& f)
{
    double product = 1;
    for (const int node : e.nodes)
        product *= f(mesh.h[node], mesh.h[node] - opened);
    return std::pow(product, 1.0 / D);
}

// L of one film's nodes and its links, factorised for conductances (at density 1) of its elements: the same entries each time.
template <int D>
class FilmAlone {
public:
    FilmAlone(const Coupling<D>& coupling, const Film<D>& film, const std::vector<int>& links)
    {
        const long count = static_cast<long>(film.mesh.h.size());
        std::vector<Eigen::Triplet<double>> entries;
        for (const FilmElement<D>& e : film.mesh.elements)
            for (int i = 0; i < D; ++i)
                for (int j = 0; j < D; ++j)
                    entries.emplace_back(e.nodes[i], e.nodes[j], 0.0);
        const auto own = [&](int node) { return node >= film.first_node && node < film.first_node + count; };
        for (const int number : links) {
            const Link& link = coupling.system.links[number];
            for (const auto& [i, wi] : link.nodes)
                for (const auto& [j, wj] : link.nodes)
                    if (own(i) && own(j))
                        entries.emplace_back(i - film.first_node, j - film.first_node, link.conductance * wi * wj);
        }
        links_.resize(count, count);
        links_.setFromTriplets(entries.begin(), entries.end());
        for (const FilmElement<D>& e : film.mesh.elements)
            for (int i = 0; i < D; ++i)
                for (int j = 0; j < D; ++j) {
                    const int* rows = links_.innerIndexPtr();
                    const int *begin = rows + links_.outerIndexPtr()[e.nodes[j]],
                              *end = rows + links_.outerIndexPtr()[e.nodes[j] + 1];
                    places_.push_back(static_cast<int>(std::lower_bound(begin, end, e.nodes[i]) - rows));
                    shares_.push_back(e.gradient[i].dot(e.gradient[j]) / coupling.density);
                }
        factor_.analyse(links_);
    }
    /// L^-1 b; empty where L is singular.
    std::optional<Eigen::VectorXd> solve(const std::vector<double>& conductance, const Eigen::VectorXd& b)
    {
        Eigen::SparseMatrix<double> L = links_;
        for (std::size_t k = 0; k < places_.size(); ++k)
            L.valuePtr()[places_[k]] += conductance[k / (D * D)] * shares_[k];
        if (!factor_.factorise(L))
            return {};
        return factor_.solve(b);
    }

private:
    Eigen::SparseMatrix<double> links_; ///< their part of L, with places for the elements'
    std::vector<int> places_;           ///< of the D x D entries of each element
    std::vector<double> shares_;        ///< of its conductance, in each of them
    SparseCholesky factor_;
};

} // namespace

template <int D>
double cubic_mean(const FilmMesh<D>& mesh, const FilmElement<D>& e, double opened)
{
    return over_nodes<D>(mesh, e, opened, mean_of_cube);
}

template <int D>
double linear_mean(const FilmMesh<D>& mesh, const FilmElement<D>& e, double opened)
{
    return over_nodes<D>(mesh, e, opened, mean_of_inverse);
}

template <int D>
std::vector<std::vector<int>> links_of_films(const Coupling<D>& coupling)
{
    std::vector<int> film_of(coupling.network.nodes);
    for (std::size_t f = 0; f < coupling.network.films.size(); ++f) {
        const Film<D>& film = coupling.network.films[f];
        std::fill_n(film_of.begin() + film.first_node, film.mesh.h.size(), static_cast<int>(f));
    }
    std::vector<std::vector<int>> links(coupling.network.films.size());
    for (std::size_t k = 0; k < coupling.system.links.size(); ++k)
        for (const auto& [node, weight] : coupling.system.links[k].nodes) {
            std::vector<int>& of_film = links[film_of[node]];
            if (of_film.empty() || of_film.back() != static_cast<int>(k))
                of_film.push_back(static_cast<int>(k));
        }
    return links;
}

double square_mean(double h, double opened)
{
    return h / (h - opened);
}

double steepened(double share)
{
    return share == 0 ? 1.0 : std::expm1(share) / share;
}

// X0 is X with the thickness at the start; drag at the end is 1 here. X is negative where a body's other films speed it up more. The two drags are
// joined by their inverses, as they limit the speed: that of bodies left alone grows beyond all bounds where a film closes and X is large.
DragParts drag_parts(double share, double change, double h, double opened)
{
    const double before = h - opened, mean = mean_of_cube(h, before);
    const double at_start = std::max(share, 0.0) * std::pow(h / before, 3) / mean;
    const double alone = std::exp(-2 * at_start), not_alone = -std::expm1(-2 * at_start), balanced = 1 / (1 + at_start);
    const double steep = 1 + std::min(change, 1.0) * (steepened(share) - 1);
    const double of_balance = balanced * mean + 1 - balanced;
    const double drag = 1 / (alone / (steep * mean) + not_alone / of_balance);
    const double factor = drag / (alone * mean + not_alone * of_balance);
    return {factor * (alone + not_alone * balanced), factor * not_alone * (1 - balanced)};
}

// The film's pressure impulse p solves L p = F V with F the rows of K, and acts with -F^T p. L with the resistances of the way, less L with
// those of the inertia that the film has at its start.
template <int D>
std::optional<WayImpulses<D>> impulses_on_way(const Coupling<D>& coupling, std::span<const int> films,
                                              std::span<const std::vector<int>> links, const WayAhead<D>& way,
                                              const std::array<Twist<D>, 2>& V)
{
    WayImpulses<D> impulses;
    for (std::size_t f = 0; f < films.size(); ++f) {
        const Film<D>& film = coupling.network.films[films[f]];
        const FilmMesh<D>& mesh = film.mesh;
        const std::vector<int>& outlets = links[films[f]];
        if (std::none_of(outlets.begin(), outlets.end(), [&](int link) { return coupling.system.links[link].conductance > 0; }))
            return {};
        const std::vector<double> beta =
            way.viscosity_dt > 0 ? element_betas(mesh, way.viscosity_dt, coupling.density) : std::vector<double>();
        std::vector<double> at_start, changed, dragged; // conductances
        for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
            const FilmElement<D>& e = mesh.elements[k];
            double thinned = 1, cube = 1;
            for (const int node : e.nodes) {
                const double end = std::max(mesh.h[node] + way.opened[f][k], way.floor);
                thinned *= mesh.h[node] / end;
                cube *= mean_of_cube(mesh.h[node], end);
            }
            const double more = std::abs(std::pow(thinned, 1.0 / D) - 1);
            at_start.push_back(e.conductance());
            changed.push_back(e.conductance() / (1 + more));
            if (!beta.empty())
                dragged.push_back(e.conductance() / (1 + more + beta[k] * std::pow(cube, 1.0 / D)));
        }
        const auto first = std::lower_bound(coupling.node_flux.begin(), coupling.node_flux.end(), film.first_node,
                                            [](const BodyFlux<D, int>& entry, int node) { return entry.row < node; });
        const int end = film.first_node + static_cast<int>(mesh.h.size());
        Eigen::VectorXd driven = Eigen::VectorXd::Zero(static_cast<long>(mesh.h.size()));
        const auto each = [&](auto&& take) {
            for (auto entry = first; entry != coupling.node_flux.end() && entry->row < end; ++entry)
                if (entry->body == mesh.master || entry->body == mesh.other)
                    take(*entry, entry->body == mesh.master ? 0 : 1);
        };
        each([&](const BodyFlux<D, int>& entry, int side) { driven[entry.row - film.first_node] += entry.flux.dot(V[side]); });
        FilmAlone<D> alone(coupling, film, outlets);
        const auto before = alone.solve(at_start, driven), after = alone.solve(changed, driven);
        const auto with_drag = beta.empty() ? after : alone.solve(dragged, driven);
        if (!before || !after || !with_drag)
            return {};
        each([&](const BodyFlux<D, int>& entry, int side) {
            const int node = entry.row - film.first_node;
            impulses.inertia[side] += ((*after)[node] - (*before)[node]) * entry.flux;
            impulses.all[side] += ((*with_drag)[node] - (*before)[node]) * entry.flux;
        });
    }
    return impulses;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template double cubic_mean<D>(const FilmMesh<D>&, const FilmElement<D>&, double);                                          \
    template double linear_mean<D>(const FilmMesh<D>&, const FilmElement<D>&, double);                                         \
    template std::vector<std::vector<int>> links_of_films<D>(const Coupling<D>&);                                              \
    template std::optional<WayImpulses<D>> impulses_on_way<D>(const Coupling<D>&, std::span<const int>,                        \
                                                              std::span<const std::vector<int>>, const WayAhead<D>&,           \
                                                              const std::array<Twist<D>, 2>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
