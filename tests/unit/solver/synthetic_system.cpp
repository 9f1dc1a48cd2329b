#include "unit/solver/synthetic_system.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gapflow::test {

template <int D>
BodyShape<D> ball(const Vec<D>& centre, double radius, double density)
{
    const double volume = D == 2 ? M_PI * radius * radius : 4.0 / 3.0 * M_PI * std::pow(radius, 3);
    return {[=](const Vec<D>& x) { return (x - centre).norm() - radius; }, centre, density * volume, 0.6 * radius};
}

template <int D>
BodyShape<D> box(const Vec<D>& centre, const Vec<D>& half, double density)
{
    return {[=](const Vec<D>& x) { return ((x - centre).cwiseAbs() - half).maxCoeff(); }, centre,
            density * std::pow(2.0, D) * half.prod(), half.norm() / std::sqrt(3.0)};
}

template <int D>
std::unique_ptr<TestSystem<D>> build(const TestScene<D>& scene, const Communicator& comm)
{
    auto test = std::make_unique<TestSystem<D>>();
    test->grid = std::make_unique<Grid<D>>(Vec<D>::Zero(), scene.dx, scene.cells, scene.sides, 2, comm);
    const Grid<D>& grid = *test->grid;
    CoupledSystem<D>& system = test->system;
    system.grid = &grid;
    system.conductance = FaceField<D>(grid);
    system.component = CellField<D, int>(grid, -1);
    const Index<D> cells = scene.cells;
    const long count = cells.template cast<long>().prod();
    const double unit_conductance = D == 2 ? 1.0 : scene.dx;

    // Open fraction of every face and the body that closes the rest (-1: wall), for the whole grid.
    auto nearest = [&](const Vec<D>& x) {
        std::pair<double, int> best(1e30, -1);
        for (std::size_t b = 0; b < scene.bodies.size(); ++b)
            best = std::min(best, {scene.bodies[b].distance(x), static_cast<int>(b)});
        return best;
    };
    auto face = [&](int axis, const Index<D>& f) -> std::pair<double, int> {
        if (!grid.periodic(axis) && (f[axis] == 0 || f[axis] == cells[axis]))
            return {grid.side(axis, f[axis] > 0) == SideKind::open ? 1.0 : 0.0, -1};
        const auto [phi, b] = nearest(grid.face_centre(axis, f));
        const double low = nearest(grid.cell_centre(f - step<D>(axis))).first, high = nearest(grid.cell_centre(f)).first;
        if (scene.voxels)
            return {low > 0 && high > 0 ? 1.0 : 0.0, b};
        double a = std::clamp(0.5 + phi / scene.dx, 0.0, 1.0);
        if (a < 1)
            a *= 1 - 0.3 * std::abs(noise(grid.key(grid.wrapped(f)), axis));
        return {std::min(low, high) < -0.4 * scene.dx || a < 1e-7 ? 0.0 : a, b};
    };
    std::vector<int> number(scene.bodies.size(), -1);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        if (!scene.bodies[b].fixed)
            number[b] = system.bodies++;
    const int dofs = twist_size<D> * system.bodies;
    system.mass.resize(dofs, dofs);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        for (int d = 0; number[b] >= 0 && d < twist_size<D>; ++d)
            system.mass.insert(twist_size<D> * number[b] + d, twist_size<D> * number[b] + d) =
                scene.bodies[b].mass * (d < D ? 1.0 : std::pow(scene.bodies[b].radius, 2));

    std::array<std::vector<double>, D> open;
    std::vector<char> unknown(count, 0), grounded_cell(count, 0);
    auto face_key = [&](const Index<D>& f) { // faces beyond the last cell share nothing: only open sides matter there
        return grid.key(grid.wrapped(f));
    };
    for (int axis = 0; axis < D; ++axis)
        open[axis].assign(count, 0.0);
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(Index<D>::Zero(), cells, [&](const Index<D>& c) {
            const double a = face(axis, c).first;
            open[axis][grid.key(c)] = a;
            if (a > 0) {
                unknown[grid.key(c)] = 1;
                const Index<D> low = grid.wrapped(c - step<D>(axis));
                if (grid.in_domain(low))
                    unknown[grid.key(low)] = 1;
                else
                    grounded_cell[grid.key(c)] = 1;
            }
            if (!grid.periodic(axis) && c[axis] == cells[axis] - 1 && nearest(grid.cell_centre(c)).first > 0 &&
                face(axis, c + step<D>(axis)).first > 0)
                unknown[grid.key(c)] = grounded_cell[grid.key(c)] = 1;
        });

    // Films: a lattice of nodes on the plane.
    std::vector<Eigen::Triplet<double>> film;
    for (const TestFilm<D>& f : scene.films) {
        const int first = system.nodes, m = f.elements + 1;
        const int nodes = D == 2 ? m : m * m;
        system.nodes += nodes;
        double area = 1;
        for (int axis = 0; axis + 1 < D; ++axis)
            area *= (f.high[axis] - f.low[axis]) / f.elements;
        for (int k = 0; k < nodes; ++k) {
            std::array<int, 2> place{k % m, k / m};
            Vec<D> x = f.low;
            double share = area;
            for (int axis = 0; axis + 1 < D; ++axis) {
                x[axis] += (f.high[axis] - f.low[axis]) * place[axis] / f.elements;
                const bool end = place[axis] == 0 || place[axis] == f.elements;
                share *= end ? 0.5 : 1.0;
                if (place[axis] < f.elements) {
                    const int other = k + (axis == 0 ? 1 : m);
                    film.emplace_back(first + k, first + k, f.conductance);
                    film.emplace_back(first + other, first + other, f.conductance);
                    film.emplace_back(first + k, first + other, -f.conductance);
                    film.emplace_back(first + other, first + k, -f.conductance);
                }
                if (end && f.mouth > 0) { // half a cell beyond the end, both sides of the plane
                    Vec<D> y = x;
                    y[axis] += (place[axis] == 0 ? -0.5 : 0.5) * scene.dx;
                    Link link{f.mouth, {{first + k, 1.0}}, {}};
                    for (double side : {-0.5, 0.5}) {
                        y[D - 1] = f.plane + side * scene.dx;
                        const Index<D> c = grid.cell_of(y);
                        if (grid.in_domain(c) && unknown[grid.key(c)])
                            link.cells.emplace_back(grid.key(c), -0.5);
                    }
                    if (link.cells.size() == 1)
                        link.cells.front().second = -1;
                    if (!link.cells.empty())
                        system.links.push_back(link);
                }
            }
            x[D - 1] = f.plane;
            for (const auto& [body, sign] : {std::pair(f.below, -1.0), std::pair(f.above, 1.0)})
                if (number[body] >= 0)
                    system.node_flux.push_back(
                        {first + k, number[body], wrench<D>(sign * share * unit<D>(D - 1), x - scene.bodies[body].centre)});
        }
    }
    system.film.resize(system.nodes, system.nodes);
    system.film.setFromTriplets(film.begin(), film.end());

    // Components of cells and nodes.
    std::vector<long> parent(count + system.nodes);
    std::iota(parent.begin(), parent.end(), 0);
    auto root = [&](long i) {
        while (parent[i] != i)
            i = parent[i] = parent[parent[i]];
        return i;
    };
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(Index<D>::Zero(), cells, [&](const Index<D>& c) {
            const Index<D> low = grid.wrapped(c - step<D>(axis));
            if (open[axis][grid.key(c)] > 0 && grid.in_domain(low))
                parent[root(grid.key(c))] = root(grid.key(low));
        });
    for (const auto& entry : film)
        parent[root(count + entry.row())] = root(count + entry.col());
    for (const Link& link : system.links)
        for (const auto& entry : link.cells)
            parent[root(entry.first)] = root(count + link.nodes.front().first);
    std::vector<int> label(parent.size(), -1);
    auto component_of = [&](long i) {
        int& k = label[root(i)];
        if (k < 0) {
            k = static_cast<int>(system.components.size());
            system.components.emplace_back();
        }
        ++system.components[k].unknowns;
        return k;
    };
    std::vector<int> component(count, -1);
    for (long i = 0; i < count; ++i)
        if (unknown[i]) {
            component[i] = component_of(i);
            if (grounded_cell[i])
                system.components[component[i]].grounded = true;
        }
    for (int i = 0; i < system.nodes; ++i)
        system.node_component.push_back(component_of(count + i));

    // Body fluxes of the whole grid for the null space; those of this rank for the system.
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(system.components.size(), dofs);
    for_each_index<D>(Index<D>::Zero(), cells, [&](const Index<D>& c) {
        const long key = grid.key(c);
        if (!unknown[key])
            return;
        std::vector<Twist<D>> flux(system.bodies, Twist<D>::Zero());
        std::vector<char> touched(system.bodies, 0);
        for (int side = 0; side < 2 * D; ++side) {
            const int axis = side / 2;
            const Index<D> f = side % 2 ? Index<D>(c + step<D>(axis)) : c;
            const auto [a, b] = face(axis, f);
            if (b < 0 || number[b] < 0 || a == 1)
                continue;
            const double area = (1 - a) * grid.face_area() * (side % 2 ? 1 : -1);
            flux[number[b]] += wrench<D>(area * unit<D>(axis), grid.face_centre(axis, f) - scene.bodies[b].centre);
            touched[number[b]] = 1;
        }
        for (int b = 0; b < system.bodies; ++b)
            if (touched[b]) {
                sums.row(component[key]).segment(twist_size<D> * b, twist_size<D>) += flux[b].transpose();
                if (grid.owns(c))
                    system.cell_flux.push_back({c, b, flux[b]});
            }
    });
    for (const auto& entry : system.node_flux)
        sums.row(system.node_component[entry.row]).segment(twist_size<D> * entry.body, twist_size<D>) += entry.flux.transpose();
    std::vector<int> floating;
    for (std::size_t k = 0; k < system.components.size(); ++k)
        if (!system.components[k].grounded)
            floating.push_back(static_cast<int>(k));
    Eigen::MatrixXd of_floating(floating.size(), dofs);
    for (std::size_t k = 0; k < floating.size(); ++k)
        of_floating.row(k) = sums.row(floating[k]);
    system.null_space = Eigen::MatrixXd::Zero(system.components.size(), 0);
    if (!floating.empty()) {
        Eigen::MatrixXd basis = Eigen::MatrixXd::Identity(floating.size(), floating.size());
        if (dofs > 0) {
            const Eigen::MatrixXd gram = of_floating * of_floating.transpose();
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
            const double threshold = 1e-16 * std::pow(grid.face_area() * 10, 2);
            const long zero = (eigen.eigenvalues().array() < threshold).count();
            basis = eigen.eigenvectors().leftCols(zero);
        }
        system.null_space = Eigen::MatrixXd::Zero(system.components.size(), basis.cols());
        for (std::size_t k = 0; k < floating.size(); ++k)
            system.null_space.row(floating[k]) = basis.row(k);
    }

    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), grid.high() + step<D>(axis), [&](const Index<D>& f) {
            const Index<D> inner = grid.wrapped(f), low = grid.wrapped(f - step<D>(axis));
            if (grid.in_domain(inner) && grid.in_domain(low))
                system.conductance(axis, f) = unit_conductance * open[axis][face_key(f)];
            else if (const Index<D>& c = grid.in_domain(inner) ? inner : low; grounded_cell[grid.key(c)])
                system.conductance(axis, f) = 2 * unit_conductance * face(axis, f).first;
        });
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) { system.component(c) = component[grid.key(c)]; });
    return test;
}

template <int D>
UnknownVector<D> sample(const TestSystem<D>& test, double rough, std::uint64_t seed)
{
    UnknownVector<D> v = zeros(test);
    const Grid<D>& grid = *test.grid;
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& c) {
        if (test.system.component(c) < 0)
            return;
        const Vec<D> x = grid.cell_centre(c).cwiseQuotient(grid.size());
        double wave = 1;
        for (int axis = 0; axis < D; ++axis)
            wave *= std::cos((2 + axis + static_cast<double>(seed)) * x[axis] + axis);
        v.cells(c) = wave + rough * noise(grid.key(c), seed);
    });
    for (int i = 0; i < test.system.nodes; ++i)
        v.nodes[i] = 0.3 + rough * noise(i, seed + 100);
    return v;
}

template <int D>
UnknownVector<D> motion_outflow(const TestSystem<D>& test, std::uint64_t seed)
{
    UnknownVector<D> v = zeros(test);
    auto outflow = [&](int body, const Twist<D>& flux) {
        double sum = 0;
        for (int d = 0; d < twist_size<D>; ++d)
            sum += flux[d] * noise(twist_size<D> * body + d, seed);
        return sum;
    };
    for (const auto& entry : test.system.cell_flux)
        v.cells(entry.row) += outflow(entry.body, entry.flux);
    for (const auto& entry : test.system.node_flux)
        v.nodes[entry.row] += outflow(entry.body, entry.flux);
    return v;
}

template <int D>
double inner(const TestSystem<D>& test, const UnknownVector<D>& a, const UnknownVector<D>& b)
{
    double sum = 0;
    for_each_index<D>(test.grid->low(), test.grid->high(), [&](const Index<D>& c) { sum += a.cells(c) * b.cells(c); });
    return test.grid->comm().sum(sum) + a.nodes.dot(b.nodes);
}

template <int D>
void remove_null(const TestSystem<D>& test, UnknownVector<D>& v)
{
    const CoupledSystem<D>& system = test.system;
    if (system.null_space.cols() == 0)
        return;
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(system.components.size()), sizes = sums;
    for_each_index<D>(test.grid->low(), test.grid->high(), [&](const Index<D>& c) {
        if (const int k = system.component(c); k >= 0)
            sums[k] += v.cells(c);
    });
    test.grid->comm().sum(std::span<double>(sums.data(), sums.size()));
    for (int i = 0; i < system.nodes; ++i)
        sums[system.node_component[i]] += v.nodes[i];
    for (std::size_t k = 0; k < system.components.size(); ++k)
        sizes[k] = static_cast<double>(system.components[k].unknowns);
    const Eigen::MatrixXd gram = system.null_space.transpose() * sizes.asDiagonal() * system.null_space;
    const Eigen::VectorXd shift = system.null_space * gram.ldlt().solve(system.null_space.transpose() * sums);
    for_each_index<D>(test.grid->low(), test.grid->high(), [&](const Index<D>& c) {
        if (const int k = system.component(c); k >= 0)
            v.cells(c) -= shift[k];
    });
    for (int i = 0; i < system.nodes; ++i)
        v.nodes[i] -= shift[system.node_component[i]];
}

template <int D>
double distance(const TestSystem<D>& test, const UnknownVector<D>& a, const UnknownVector<D>& b)
{
    UnknownVector<D> difference = a;
    for_each_index<D>(test.grid->low(), test.grid->high(), [&](const Index<D>& c) { difference.cells(c) -= b.cells(c); });
    difference.nodes -= b.nodes;
    return std::sqrt(inner(test, difference, difference) / inner(test, b, b));
}

template <int D>
TestScene<D> film_scene(int n, double film, double mouth, double density, SideKind sides)
{
    TestScene<D> scene(Index<D>::Constant(n), 1.0 / n, sides);
    Vec<D> half = Vec<D>::Constant(0.15625);
    half[D - 1] = 0.125;
    Vec<D> lower = Vec<D>::Constant(0.46875), upper = lower;
    lower[D - 1] = 0.375;
    upper[D - 1] = 0.625;
    scene.bodies = {box<D>(lower, half, density), box<D>(upper, half, density), ball<D>(Vec<D>::Constant(0.83), 0.1, density)};
    scene.films = {{0, 1, 0.5, lower - half, lower + half, n / 2, film, mouth}};
    return scene;
}

template <int D>
TestScene<D> chamber_scene(int n, double film, double mouth, double density)
{
    TestScene<D> scene(Index<D>::Constant(n), 1.0 / n);
    Vec<D> half = Vec<D>::Constant(1), lower = Vec<D>::Constant(0.5), upper = lower;
    half[0] = 0.125;
    half[D - 1] = 0.5;
    lower[D - 1] = 0;
    upper[D - 1] = 1;
    scene.bodies = {box<D>(lower, half, density), box<D>(upper, half, density)};
    Vec<D> low = Vec<D>::Constant(0.1), high = Vec<D>::Constant(0.9);
    low[0] = 0.375;
    high[0] = 0.625;
    scene.films = {{0, 1, 0.5, low, high, n / 4, film, mouth}};
    return scene;
}

template <int D>
TestScene<D> two_bodies(int n, double density, SideKind sides)
{
    TestScene<D> scene(Index<D>::Constant(n), 1.0 / n, sides);
    Vec<D> far = Vec<D>::Constant(0.66);
    far[0] = 0.6;
    scene.bodies = {ball<D>(Vec<D>::Constant(0.31), 0.17, density), box<D>(far, Vec<D>::Constant(0.13), density)};
    return scene;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template BodyShape<D> ball<D>(const Vec<D>&, double, double);                                                              \
    template BodyShape<D> box<D>(const Vec<D>&, const Vec<D>&, double);                                                        \
    template std::unique_ptr<TestSystem<D>> build<D>(const TestScene<D>&, const Communicator&);                                \
    template UnknownVector<D> sample<D>(const TestSystem<D>&, double, std::uint64_t);                                          \
    template UnknownVector<D> motion_outflow<D>(const TestSystem<D>&, std::uint64_t);                                          \
    template TestScene<D> chamber_scene<D>(int, double, double, double);                                                       \
    template double inner<D>(const TestSystem<D>&, const UnknownVector<D>&, const UnknownVector<D>&);                          \
    template void remove_null<D>(const TestSystem<D>&, UnknownVector<D>&);                                                     \
    template double distance<D>(const TestSystem<D>&, const UnknownVector<D>&, const UnknownVector<D>&);                       \
    template TestScene<D> film_scene<D>(int, double, double, double, SideKind);                                                \
    template TestScene<D> two_bodies<D>(int, double, SideKind);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow::test
