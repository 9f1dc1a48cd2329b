#include "gapflow/stepping/start_flow.hpp"

#include <algorithm>
#include <limits>

namespace gapflow {

namespace {

// A place where two solids lie on each other: opening rate row_a . V_a + row_b . V_b.
template <int D>
struct Meeting {
    int a, b;
    Twist<D> row_a, row_b;
};

// Elements of films whose surfaces are no further apart than the floor; of round bodies that rebound where they are as near as anywhere about. Such bodies are
// nearer than the floor in a strip, but what flows there has a finite speed and energy, which the rebound returns.
template <int D>
std::vector<Meeting<D>> flat_touches(const Coupling<D>& coupling, const std::function<GapSettings(int, int)>& gaps,
                                     const std::function<bool(int, int)>& rebound)
{
    const double dx = coupling.grid->dx(), least = D == 2 ? flat::patch * dx : flat::patch * flat::patch * dx * dx;
    std::vector<Meeting<D>> touches;
    for (const Film<D>& film : coupling.network.films) {
        const FilmMesh<D>& mesh = film.mesh;
        const double floor = gaps(mesh.master, mesh.other).floor, slack = std::max(1e-3 * floor, flat::flush * dx),
                     most = floor + slack;
        const auto apart = [&](int node) { return (mesh.y[node] - mesh.x[node]).norm(); };
        const bool round = !mesh.flat && rebound && rebound(mesh.master, mesh.other);
        double nearest = std::numeric_limits<double>::infinity();
        for (int node = 0; round && node < static_cast<int>(mesh.x.size()); ++node)
            nearest = std::min(nearest, apart(node));
        std::vector<Meeting<D>> of_film;
        double area = 0;
        for (const FilmElement<D>& e : mesh.elements) {
            if (std::any_of(e.nodes.begin(), e.nodes.end(),
                            [&](int node) { return mesh.h[node] + mesh.skin > most || apart(node) > nearest + slack; }))
                continue;
            const Solid<D>&a = coupling.solids[mesh.master], &b = coupling.solids[mesh.other];
            of_film.push_back({mesh.master, mesh.other, Twist<D>(-wrench<D>(e.normal, e.centroid - a.centre)),
                               wrench<D>(e.normal, e.centroid - b.centre - mesh.shift)});
            area += e.measure;
        }
        if (area > least)
            touches.insert(touches.end(), of_film.begin(), of_film.end());
    }
    return touches;
}

template <int D>
double opening_rate(const Meeting<D>& touch, const std::vector<Twist<D>>& V)
{
    return touch.row_a.dot(V[touch.a]) + touch.row_b.dot(V[touch.b]);
}

// Largest opening or closing rate.
template <int D>
double largest_rate(const std::vector<Meeting<D>>& touches, const std::vector<Twist<D>>& V)
{
    double largest = 0;
    for (const Meeting<D>& t : touches)
        largest = std::max(largest, std::abs(opening_rate(t, V)));
    return largest;
}

template <int D>
double fastest_of(const std::vector<Twist<D>>& twists)
{
    double fastest = 0;
    for (const Twist<D>& V : twists)
        fastest = std::max(fastest, V.norm());
    return fastest;
}

// The twists nearest to the given ones, in the metric of mass, with negligible rates.
template <int D>
std::vector<Twist<D>> without_rates(const std::vector<Meeting<D>>& touches, const std::vector<RigidBody<D>>& bodies,
                                    const std::vector<Solid<D>>& solids, bool prescribed_too, std::vector<Twist<D>> V)
{
    constexpr int n = twist_size<D>;
    std::vector<int> place(solids.size(), -1);
    int count = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (bodies[b].motion == Motion::free || (prescribed_too && bodies[b].motion == Motion::prescribed))
            place[b] = count++;
    if (count == 0)
        return V;
    std::vector<Eigen::Triplet<double>> inertia, rows;
    Eigen::VectorXd momentum = Eigen::VectorXd::Zero(n * count);
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (const int i = place[b]; i >= 0) {
            const TwistMatrix<D>& P = solids[b].admissible;
            const TwistMatrix<D> M = mass_matrix(bodies[b]), admitted = admissible_mass<D>(P, M, bodies[b].mass);
            for (int k = 0; k < n; ++k)
                for (int l = 0; l < n; ++l)
                    inertia.emplace_back(n * i + k, n * i + l, admitted(k, l));
            momentum.segment<n>(n * i) = P * (M * V[b]);
        }
    const auto meetings = static_cast<int>(touches.size());
    Eigen::VectorXd speed = Eigen::VectorXd::Zero(meetings);
    for (int r = 0; r < meetings; ++r) {
        const Meeting<D>& t = touches[r];
        for (const auto& [solid, row] : {std::pair(t.a, t.row_a), std::pair(t.b, t.row_b)})
            if (const int i = place[solid]; i < 0)
                speed[r] -= row.dot(V[solid]);
            else
                for (int k = 0; k < n; ++k)
                    rows.emplace_back(r, n * i + k, (solids[solid].admissible * row)[k]);
    }
    Eigen::SparseMatrix<double> mass(n * count, n * count), contact(meetings, n * count);
    mass.setFromTriplets(inertia.begin(), inertia.end());
    contact.setFromTriplets(rows.begin(), rows.end());
    const BodyResponse response(mass, contact, Eigen::VectorXd::Constant(meetings, std::numeric_limits<double>::infinity()));
    const Eigen::VectorXd all = response(momentum, speed, nullptr);
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (place[b] >= 0)
            V[b] = solids[b].admissible * all.segment<n>(n * place[b]);
    return V;
}

} // namespace

template <int D>
std::vector<Twist<D>> start_twists(const Coupling<D>& coupling, const std::vector<RigidBody<D>>& bodies,
                                   const std::function<GapSettings(int, int)>& gaps, const std::vector<Twist<D>>& twists,
                                   const std::function<bool(int, int)>& rebound)
{
    const double fastest = fastest_of<D>(twists);
    if (fastest == 0)
        return twists;
    const auto touches = flat_touches<D>(coupling, gaps, rebound);
    if (!(largest_rate(touches, twists) > flat::same * fastest))
        return twists;
    std::vector<Twist<D>> V = without_rates(touches, bodies, coupling.solids, false, twists);
    if (largest_rate(touches, V) > flat::same * fastest)
        V = without_rates(touches, bodies, coupling.solids, true, twists);
    for (Twist<D>& twist : V)
        if (twist.norm() < flat::same * fastest)
            twist.setZero();
    return V;
}

template <int D>
std::optional<std::array<int, 2>> falls_flat(const Coupling<D>& coupling, const std::function<GapSettings(int, int)>& gaps,
                                             const std::vector<Twist<D>>& twists, const std::function<bool(int, int)>& rebound)
{
    const double least = flat::same * fastest_of<D>(twists);
    std::optional<std::array<int, 2>> pair;
    for (const Meeting<D>& touch : flat_touches<D>(coupling, gaps, rebound)) {
        const double rate = opening_rate(touch, twists);
        if (rate > least)
            return {};
        if (rate < -least && rebound(touch.a, touch.b) && !pair)
            pair = {touch.a, touch.b};
    }
    return pair;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<Twist<D>> start_twists<D>(const Coupling<D>&, const std::vector<RigidBody<D>>&,                       \
                                                   const std::function<GapSettings(int, int)>&, const std::vector<Twist<D>>&,  \
                                                   const std::function<bool(int, int)>&);                                      \
    template std::optional<std::array<int, 2>> falls_flat<D>(const Coupling<D>&, const std::function<GapSettings(int, int)>&,  \
                                                             const std::vector<Twist<D>>&,                                     \
                                                             const std::function<bool(int, int)>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
