#include "gapflow/stepping/start_flow.hpp"
#include "gapflow/core/sparse_cholesky.hpp"

#include <algorithm>

namespace gapflow {

namespace {

constexpr double flush = 1e-8;     // in cells, and of the floor 1e-3: surfaces that touch
constexpr double patch = 0.1;      // in cells: the size of a part of a film that lies flat
constexpr double stiffness = 1e10; // relative to the masses: its inverse is the remaining part of a speed
constexpr double same = 1e-6;      // of the largest speed

// A place where two solids lie on each other: opening rate row_a . V_a + row_b . V_b.
template <int D>
struct Meeting {
    int a, b;
    Twist<D> row_a, row_b;
    double area;
};

template <int D>
std::vector<Meeting<D>> flat_touches(const Coupling<D>& coupling, const std::function<GapSettings(int, int)>& gaps)
{
    const double dx = coupling.grid->dx(), least = D == 2 ? patch * dx : patch * patch * dx * dx;
    std::vector<Meeting<D>> touches;
    for (const Film<D>& film : coupling.network.films) {
        const FilmMesh<D>& mesh = film.mesh;
        const double floor = gaps(mesh.master, mesh.other).floor, most = floor + std::max(1e-3 * floor, flush * dx);
        std::vector<Meeting<D>> of_film;
        double area = 0;
        for (const FilmElement<D>& e : mesh.elements) {
            if (std::any_of(e.nodes.begin(), e.nodes.end(), [&](int node) { return mesh.h[node] + mesh.skin > most; }))
                continue;
            const Solid<D>&a = coupling.solids[mesh.master], &b = coupling.solids[mesh.other];
            of_film.push_back({mesh.master, mesh.other, Twist<D>(-wrench<D>(e.normal, e.centroid - a.centre)),
                               wrench<D>(e.normal, e.centroid - b.centre - mesh.shift), e.measure});
            area += e.measure;
        }
        if (area > least)
            touches.insert(touches.end(), of_film.begin(), of_film.end());
    }
    return touches;
}

// Largest opening or closing rate.
template <int D>
double largest_rate(const std::vector<Meeting<D>>& touches, const std::vector<Twist<D>>& V)
{
    double largest = 0;
    for (const Meeting<D>& t : touches)
        largest = std::max(largest, std::abs(t.row_a.dot(V[t.a]) + t.row_b.dot(V[t.b])));
    return largest;
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
    double area = 0;
    for (const Meeting<D>& t : touches)
        area += t.area;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd momentum = Eigen::VectorXd::Zero(n * count);
    auto add_block = [&](int i, int j, const TwistMatrix<D>& block) {
        for (int k = 0; k < n; ++k)
            for (int l = 0; l < n; ++l)
                entries.emplace_back(n * i + k, n * j + l, block(k, l));
    };
    double heaviest = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (place[b] >= 0) {
            const TwistMatrix<D>& P = solids[b].admissible;
            const TwistMatrix<D> M = mass_matrix(bodies[b]);
            add_block(place[b], place[b], admissible_mass<D>(P, M, bodies[b].mass));
            momentum.segment<n>(n * place[b]) = P * (M * V[b]);
            heaviest = std::max(heaviest, bodies[b].mass);
        }
    for (const Meeting<D>& t : touches) {
        const int a = place[t.a], b = place[t.b];
        const double k = stiffness * heaviest * t.area / area;
        const double given = (a < 0 ? t.row_a.dot(V[t.a]) : 0.0) + (b < 0 ? t.row_b.dot(V[t.b]) : 0.0);
        const Twist<D> row_a = solids[t.a].admissible * t.row_a, row_b = solids[t.b].admissible * t.row_b;
        auto add = [&](int i, const Twist<D>& row_i, int j, const Twist<D>& row_j) {
            if (i >= 0 && j >= 0)
                add_block(i, j, k * row_i * row_j.transpose());
        };
        add(a, row_a, a, row_a);
        add(a, row_a, b, row_b);
        add(b, row_b, a, row_a);
        add(b, row_b, b, row_b);
        if (a >= 0)
            momentum.segment<n>(n * a) -= k * given * row_a;
        if (b >= 0)
            momentum.segment<n>(n * b) -= k * given * row_b;
    }
    Eigen::SparseMatrix<double> matrix(n * count, n * count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    SparseCholesky factor;
    if (!factor.compute(matrix))
        return V;
    const Eigen::VectorXd all = factor.solve(momentum);
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (place[b] >= 0)
            V[b] = solids[b].admissible * all.segment<n>(n * place[b]);
    return V;
}

} // namespace

template <int D>
std::vector<Twist<D>> start_twists(const Coupling<D>& coupling, const std::vector<RigidBody<D>>& bodies,
                                   const std::function<GapSettings(int, int)>& gaps, const std::vector<Twist<D>>& twists)
{
    double fastest = 0;
    for (const Twist<D>& V : twists)
        fastest = std::max(fastest, V.norm());
    if (fastest == 0)
        return twists;
    const auto touches = flat_touches<D>(coupling, gaps);
    if (!(largest_rate(touches, twists) > same * fastest))
        return twists;
    std::vector<Twist<D>> V = without_rates(touches, bodies, coupling.solids, false, twists);
    if (largest_rate(touches, V) > same * fastest)
        V = without_rates(touches, bodies, coupling.solids, true, twists);
    for (Twist<D>& twist : V)
        if (twist.norm() < same * fastest)
            twist.setZero();
    return V;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<Twist<D>> start_twists<D>(const Coupling<D>&, const std::vector<RigidBody<D>>&,                       \
                                                   const std::function<GapSettings(int, int)>&, const std::vector<Twist<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
