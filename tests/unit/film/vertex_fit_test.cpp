// Vertex values from means over elements: exact for linear fields on flat meshes, whatever the elements and their weights.
#include "gapflow/film/vertex_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gapflow::test {
namespace {

/// A flat mesh in a tilted plane, of irregular elements and weights: 2D a row of 9, 3D a square of 6 by 6 by 2 triangles.
template <int D>
struct FlatMesh {
    FlatMesh()
    {
        constexpr int cells = D == 2 ? 9 : 6;
        std::mt19937 random(5);
        std::uniform_real_distribution<double> number(-0.3, 0.3), any(0.1, 3);
        const auto node = [&](int i, int j) { return i + (cells + 1) * j; };
        for (int j = 0; j <= (D == 2 ? 0 : cells); ++j)
            for (int i = 0; i <= cells; ++i)
                x.push_back(origin + (i + number(random)) * along() + (j + number(random)) * aside());
        for (int i = 0; i < cells; ++i)
            if constexpr (D == 2)
                elements.push_back({i, i + 1});
            else
                for (int j = 0; j < cells; ++j) {
                    elements.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1)});
                    elements.push_back({node(i, j), node(i + 1, j + 1), node(i, j + 1)});
                }
        for (const auto& nodes : elements) {
            centroid.push_back(Vec<D>::Zero());
            for (int i : nodes)
                centroid.back() += x[i] / D;
            normal.push_back(across());
            weight.push_back(any(random));
        }
    }
    static Vec<D> along()
    {
        if constexpr (D == 2)
            return {0.6, 0.8};
        else
            return {0.6, 0, 0.8};
    }
    static Vec<D> aside()
    {
        if constexpr (D == 2)
            return {0, 0};
        else
            return {0, 1, 0};
    }
    static Vec<D> across()
    {
        if constexpr (D == 2)
            return {-0.8, 0.6};
        else
            return {-0.8, 0, 0.6};
    }
    VertexFit fit() const { return vertex_fit<D>(x, elements, centroid, normal, weight); }

    Vec<D> origin = Vec<D>::Constant(2);
    std::vector<Vec<D>> x, centroid, normal;
    std::vector<std::array<int, D>> elements;
    std::vector<double> weight;
};

template <int D>
double linear(const Vec<D>& x)
{
    Vec<D> slope = Vec<D>::Constant(-0.7);
    slope[0] = 1.3;
    return 2 + slope.dot(x);
}

template <int D>
void exact_for_linear_fields()
{
    const FlatMesh<D> mesh;
    const VertexFit fit = mesh.fit();
    std::vector<double> means, ones(mesh.elements.size(), 1.0);
    for (const Vec<D>& x : mesh.centroid)
        means.push_back(linear<D>(x));
    ASSERT_EQ(fit.first.size(), mesh.x.size() + 1);
    for (int i = 0; i < static_cast<int>(mesh.x.size()); ++i) {
        EXPECT_NEAR(fit.at(i, means, 0.0), linear<D>(mesh.x[i]), 1e-5) << i;
        EXPECT_NEAR(fit.at(i, ones, 0.0), 1, 1e-12) << i;
    }
}

TEST(VertexFit, ExactForLinearFieldsToTheEnds2D)
{
    exact_for_linear_fields<2>();
}

TEST(VertexFit, ExactForLinearFieldsToTheEnds3D)
{
    exact_for_linear_fields<3>();
}

// Values of elements without weight do not count, and a vertex with none but those has none.
template <int D>
void without_weight()
{
    FlatMesh<D> mesh;
    std::vector<double> means;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const bool counts = (mesh.centroid[e] - mesh.origin).dot(mesh.along()) < 5;
        means.push_back(counts ? linear<D>(mesh.centroid[e]) : 1e6);
        if (!counts)
            mesh.weight[e] = 0;
    }
    const VertexFit fit = mesh.fit();
    int some = 0, none = 0;
    for (int i = 0; i < static_cast<int>(mesh.x.size()); ++i) {
        const double along = (mesh.x[i] - mesh.origin).dot(mesh.along());
        if (along < 3.5) {
            EXPECT_NEAR(fit.at(i, means, 0.0), linear<D>(mesh.x[i]), 1e-5) << i;
            ++some;
        }
        if (D == 2 && along > 7.5) {
            EXPECT_EQ(fit.first[i], fit.first[i + 1]) << i;
            ++none;
        }
    }
    EXPECT_GT(some, 3);
    EXPECT_TRUE(D == 3 || none > 0);
}

TEST(VertexFit, ElementsWithoutWeightDoNotCount2D)
{
    without_weight<2>();
}

TEST(VertexFit, ElementsWithoutWeightDoNotCount3D)
{
    without_weight<3>();
}

// On a bent surface the slope is taken in the mean tangent plane: a constant vector stays one, and a lone element gives its own value.
TEST(VertexFit, LoneElementGivesItsOwnValue)
{
    const std::vector<Vec<2>> x{{0, 0}, {1, 0}}, centroid{{0.5, 0}}, normal{{0, 1}};
    const std::vector<std::array<int, 2>> elements{{0, 1}};
    const std::vector<double> weight{0.3}, value{7};
    const VertexFit fit = vertex_fit<2>(x, elements, centroid, normal, weight);
    for (int i : {0, 1})
        EXPECT_NEAR(fit.at(i, value, 0.0), 7, 1e-9);
}

TEST(VertexFit, RingsHoldEachElementOnceAtEachOfItsVertices)
{
    const FlatMesh<3> mesh;
    const VertexRings rings = vertex_rings<3>(mesh.x.size(), mesh.elements);
    EXPECT_EQ(rings.element.size(), 3 * mesh.elements.size());
    std::vector<int> found(mesh.elements.size(), 0);
    for (int i = 0; i < static_cast<int>(mesh.x.size()); ++i)
        for (int k = rings.first[i]; k < rings.first[i + 1]; ++k) {
            const auto& nodes = mesh.elements[rings.element[k]];
            EXPECT_EQ(std::count(nodes.begin(), nodes.end(), i), 1);
            ++found[rings.element[k]];
        }
    for (int count : found)
        EXPECT_EQ(count, 3);
}

} // namespace
} // namespace gapflow::test
