// Shared by the tests of film meshes: placing shapes, sums over a film, checks that every film must pass.
#pragma once

#include "gapflow/film/film_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <numbers>

namespace gapflow::test {

template <int D>
PlacedShape<D> place(const std::unique_ptr<Shape<D>>& shape, const Vec<D>& position,
                     const Rotation<D>& rotation = Rotation<D>::Identity())
{
    Pose<D> pose;
    pose.position = position;
    pose.rotation = rotation;
    return {*shape, pose};
}

template <int D>
double nothing_else(const Vec<D>&, const Vec<D>&)
{
    return std::numeric_limits<double>::infinity();
}

inline FilmMeshOptions options_with(double threshold)
{
    FilmMeshOptions options;
    options.threshold = threshold;
    return options;
}

template <int D>
std::vector<FilmMesh<D>> films_of(const PlacedShape<D>& master, const PlacedShape<D>& other, const FilmMeshOptions& options,
                                  const std::function<double(const Vec<D>&, const Vec<D>&)>& third = nothing_else<D>)
{
    return film_meshes<D>(master, other, third, options);
}

template <int D>
double area(const FilmMesh<D>& film)
{
    double sum = 0;
    for (const auto& e : film.elements)
        sum += e.measure;
    return sum;
}

template <int D>
double volume(const FilmMesh<D>& film)
{
    double sum = 0;
    for (const auto& e : film.elements)
        sum += e.volume;
    return sum;
}

template <int D>
Vec<D> other_area(const FilmMesh<D>& film)
{
    Vec<D> sum = Vec<D>::Zero();
    for (const auto& p : film.points)
        sum += wall_share(film, p).area;
    return sum;
}

/// Length of rim by reason.
template <int D>
std::map<RimEnd, double> rim_lengths(const FilmMesh<D>& film)
{
    std::map<RimEnd, double> length;
    for (const auto& r : film.rim)
        length[r.end] += r.length;
    return length;
}

template <int D>
Vec<D> simplex_area(const std::array<Vec<D>, D>& c)
{
    if constexpr (D == 2)
        return {c[1][1] - c[0][1], c[0][0] - c[1][0]};
    else
        return 0.5 * (c[1] - c[0]).cross(c[2] - c[0]);
}

/// What holds for every film: finite numbers, sums over points exact, gradients of linear functions, conforming with a
/// closed rim whose conormals point out of the film.
template <int D>
void check_film(const FilmMesh<D>& film, const FilmMeshOptions& options)
{
    ASSERT_FALSE(film.elements.empty());
    for (std::size_t i = 0; i < film.x.size(); ++i) {
        ASSERT_TRUE(film.x[i].allFinite() && film.y[i].allFinite() && film.mid[i].allFinite());
        ASSERT_TRUE(film.h[i] >= options.floor && film.h[i] <= options.threshold * (1 + 1e-7)) << film.h[i];
        ASSERT_LT((film.mid[i] - 0.5 * (film.x[i] + film.y[i])).norm(), 1e-12 * (1 + film.x[i].norm()));
    }
    std::vector<double> fraction(film.elements.size(), 0), volume(fraction), across(fraction);
    std::vector<Vec<D>> lean(film.elements.size(), Vec<D>::Zero());
    std::vector<int> pieces(film.elements.size(), 0);
    std::vector<Vec<D>> share(film.elements.size(), Vec<D>::Zero());
    std::vector<Spin<D>> turn(film.elements.size(), Spin<D>::Zero()); // about the mean of the closest points
    for (const auto& p : film.points) {
        ASSERT_TRUE(p.x.allFinite() && p.y.allFinite() && p.other_normal.allFinite());
        ASSERT_TRUE(p.weight > 0 && p.h >= options.floor);
        ASSERT_NEAR(p.other_normal.norm(), 1, 1e-12);
        const auto& e = film.elements[p.element];
        fraction[p.element] += p.weight / e.measure;
        const Vec<D>& normal = film.elements[p.element].normal;
        across[p.element] = options.viscous ? 1.0 : std::max(-p.other_normal.dot(normal), 0.5);
        volume[p.element] += p.weight * p.h * across[p.element];
        if (!options.viscous)
            lean[p.element] -= p.weight * p.h * (p.other_normal - p.other_normal.dot(normal) * normal);
        ++pieces[p.element];
        const auto [area, centroid] = wall_share(film, p);
        ASSERT_TRUE(area.allFinite() && centroid.allFinite());
        share[p.element] += area;
        Vec<D> mean = Vec<D>::Zero();
        for (int i : e.nodes)
            mean += film.y[i] / D;
        turn[p.element] += moment<D>(Vec<D>(centroid - mean), area);
    }
    std::map<std::array<int, 2>, int> uses;
    for (std::size_t i = 0; i < film.elements.size(); ++i) {
        const auto& e = film.elements[i];
        std::array<Vec<D>, D> y, mid;
        Vec<D> sum = Vec<D>::Zero();
        double size = 0;
        for (int k = 0; k < D; ++k) {
            y[k] = film.y[e.nodes[k]];
            mid[k] = film.mid[e.nodes[k]];
            sum += e.gradient[k];
            size = std::max(size, (film.x[e.nodes[k]] - film.x[e.nodes[(k + 1) % D]]).norm());
            const int a = e.nodes[k], b = D == 2 ? a : e.nodes[(k + 1) % D];
            ++uses[{std::min(a, b), std::max(a, b)}];
        }
        ASSERT_LT(size, (options.largest + 0.3 * options.straddle) * options.dx);
        ASSERT_NEAR(fraction[i], 1, 1e-13);
        if (D == 3 && pieces[i] == 1) // a triangle's corners count by a twelfth each
            volume[i] = 0.75 * volume[i] +
                        0.25 * e.measure * across[i] * (film.h[e.nodes[0]] + film.h[e.nodes[1]] + film.h[e.nodes[D - 1]]) / 3;
        else
            ASSERT_LT((lean[i] - e.lean).norm(), 1e-13 * e.volume);
        ASSERT_NEAR(volume[i], e.volume, 1e-13 * e.volume);
        ASSERT_LT((share[i] - simplex_area<D>(y)).norm(), 1e-14 * options.dx);
        ASSERT_LT(turn[i].norm(), 1e-12 * options.dx * options.dx);
        ASSERT_TRUE(e.inverse >= e.measure * e.measure / e.volume * (1 - 1e-12) && std::isfinite(e.inverse));
        ASSERT_NEAR(e.normal.norm(), 1, 1e-12);
        ASSERT_GT(e.normal.dot(simplex_area<D>(mid)), 0);
        ASSERT_TRUE(e.centroid_master.allFinite() && e.centroid_other.allFinite());
        const double largest_gradient = std::max(e.gradient[0].norm(), e.gradient[1].norm());
        ASSERT_LT(sum.norm(), 1e-9 * largest_gradient);
        for (int k = 0; k < D; ++k)
            ASSERT_NEAR(e.gradient[k].dot(mid[k] - mid[(k + 1) % D]), 1, 1e-4);
    }
    std::map<int, int> degree;
    std::size_t ends = 0;
    for (const auto& [facet, count] : uses) {
        ASSERT_LE(count, 2);
        ends += count == 1;
    }
    ASSERT_EQ(ends, film.rim.size());
    for (const auto& r : film.rim) {
        ASSERT_NEAR(r.outward.norm(), 1, 1e-12);
        ASSERT_NEAR(r.outward.dot(film.elements[r.element].normal), 0, 1e-6);
        for (int n : r.nodes) {
            ++degree[n];
            if (r.length > 1e-6 * options.dx) {
                ASSERT_GT(r.outward.dot(film.mid[n] - film.elements[r.element].centroid), 0);
            }
        }
    }
    for (const auto& [node, count] : degree)
        ASSERT_EQ(count % 2, D == 2 ? 1 : 0) << "the rim is open";
}

} // namespace gapflow::test
