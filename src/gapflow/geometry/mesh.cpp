// Shape of a closed triangle mesh (2D: polygon): closest point by a tree, side by the angle-weighted pseudonormal of the
// facet, edge or vertex it lies on (Baerentzen & Aanaes 2005; exact for closed surfaces that do not cut themselves), by the
// winding number at vertices where parts touch.
#include "gapflow/geometry/facet_tree.hpp"
#include "gapflow/geometry/mesh_check.hpp"
#include "gapflow/geometry/mesh_features.hpp"
#include "gapflow/geometry/mesh_file.hpp"
#include "gapflow/geometry/mesh_mass.hpp"
#include "gapflow/geometry/requirement.hpp"

#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace gapflow {
namespace {

template <int D>
class Mesh final : public Shape<D> {
public:
    explicit Mesh(ClosedSurface<D> surface)
        : surface_(std::move(surface)), features_(find_features(surface_)), facets_(facets_of()),
          tree_(facets_, features_.patch), mass_(mass_properties_of(mesh()))
    {
        surface_.mesh.patch = features_.patch;
        bounds_.low = bounds_.high = mesh().vertices.front();
        for (const Vec<D>& x : mesh().vertices) {
            bounds_.low = bounds_.low.cwiseMin(x);
            bounds_.high = bounds_.high.cwiseMax(x);
        }
        tolerance_ = 1e-12 * (bounds_.high - bounds_.low).maxCoeff();
    }

    SurfacePoint<D> closest(const Vec<D>& x) const override
    {
        Answer& answer = answer_for(x);
        if (answer.mesh != number_ || answer.x != x)
            answer = {number_, x, find_closest(x)};
        return answer.point;
    }

    std::optional<double> entry(const Vec<D>& x, const Vec<D>& u) const override { return tree_.entry(x, u, tolerance_); }

    /// The closest point of the patch's facets.
    Vec<D> onto(const Vec<D>& x, int patch) const override { return tree_.closest(x, patch).point.x; }

    /// Of the patch's facets alone, also on its sharp borders.
    Vec<D> patch_normal(const Vec<D>& x, int patch) const override
    {
        const Hit hit = tree_.closest(x, patch);
        if (hit.point.vertex >= 0) {
            const int vertex = mesh().elements[hit.facet][hit.point.vertex];
            Vec<D> sum = Vec<D>::Zero();
            for (int f : features_.facets_at(vertex))
                if (features_.patch[f] == patch)
                    sum += facet_angle(mesh(), f, local_index(f, vertex)) * normal(f);
            return sum.normalized();
        }
        if (hit.point.ridge >= 0 && features_.smooth[hit.facet][hit.point.ridge])
            return (normal(hit.facet) + normal(across(hit))).normalized();
        return normal(hit.facet);
    }

    bool convex() const override { return false; }
    double curvature(int patch) const override { return features_.patch_curvature[patch]; }
    SurfaceMesh<D> surface_mesh() const override { return mesh(); }
    SurfaceMesh<D> display_mesh(double) const override { return mesh(); }
    MassProperties<D> mass_properties() const override { return mass_; }
    Bounds<D> bounds() const override { return bounds_; }

private:
    using Hit = typename FacetTree<D>::Hit;

    struct Answer {
        std::uint64_t mesh = 0; ///< number of the mesh that was asked
        Vec<D> x;
        SurfacePoint<D> point;
    };

    /// Where the answer for x is kept. A place is mostly asked for several times in a row: for its distance and its normal, by the rays that
    /// start there, by its neighbours.
    static Answer& answer_for(const Vec<D>& x)
    {
        static thread_local std::array<Answer, 256> answers;
        std::uint64_t hash = 0;
        for (int k = 0; k < D; ++k)
            hash = (hash ^ std::bit_cast<std::uint64_t>(x[k])) * 0x9e3779b97f4a7c15u;
        return answers[hash >> 56];
    }

    static std::uint64_t next_number()
    {
        static std::atomic<std::uint64_t> last = 0;
        return ++last;
    }

    SurfacePoint<D> find_closest(const Vec<D>& x) const
    {
        const Hit hit = settled(x, tree_.closest(x));
        if (hit.point.interior())
            return over_facet(x, hit.facet, hit.point.x);
        if (hit.point.vertex >= 0)
            return over_vertex(x, hit);
        return over_edge(x, hit);
    }

    const SurfaceMesh<D>& mesh() const { return surface_.mesh; }
    const Vec<D>& normal(int facet) const { return features_.facet_normal[facet]; }
    int across(const Hit& hit) const { return surface_.neighbours[hit.facet][hit.point.ridge]; }

    int local_index(int facet, int vertex) const
    {
        int i = 0;
        while (mesh().elements[facet][i] != vertex)
            ++i;
        return i;
    }

    std::vector<Facet<D>> facets_of() const
    {
        std::vector<Facet<D>> facets;
        for (std::size_t f = 0; f < mesh().elements.size(); ++f) {
            Facet<D> facet{{}, features_.facet_normal[f]};
            for (int i = 0; i < D; ++i)
                facet.corner[i] = mesh().vertices[mesh().elements[f][i]];
            facets.push_back(facet);
        }
        return facets;
    }

    /// Squared distances to facets that meet agree to round-off over a strip along their border as wide as 1e-8 of the
    /// distance, so the tree's choice between an edge, its ends and the facets beside it is not sharp. From a foot y on an
    /// edge or vertex, the foot p on a facet that holds y is nearer, squared, by at least |p - y|^2 (convexity): that is sharp.
    Hit settled(const Vec<D>& x, Hit hit) const
    {
        for (int tries = 0; tries < 8 && !hit.point.interior(); ++tries) {
            Hit best = hit;
            double gain = 1e-6 * tolerance_ * tolerance_;
            const auto consider = [&](int f) {
                const FacetPoint<D> p = closest_on(facets_[f], x);
                if (const double g = (p.x - hit.point.x).squaredNorm(); g > gain) {
                    gain = g;
                    best = {f, p};
                }
            };
            if (hit.point.ridge >= 0)
                consider(across(hit));
            else
                for (int f : features_.facets_at(mesh().elements[hit.facet][hit.point.vertex]))
                    consider(f);
            if (gain <= 1e-6 * tolerance_ * tolerance_)
                break;
            hit = best;
        }
        return hit;
    }

    SurfacePoint<D> over_facet(const Vec<D>& x, int f, const Vec<D>& foot) const
    {
        return {foot, normal(f), normal(f).dot(x - facets_[f].corner[0]), Feature::face, features_.patch[f]};
    }

    /// Whether x is over the facet's border within the tolerance: over the face then, not over a sharp edge.
    bool on_border_of(int f, const Vec<D>& arm) const { return (arm - normal(f).dot(arm) * normal(f)).norm() <= tolerance_; }

    SurfacePoint<D> at(const Vec<D>& x, const Vec<D>& foot, const Vec<D>& pseudonormal, bool inside, Feature feature,
                       int patch) const
    {
        const Vec<D> arm = x - foot;
        const double distance = inside ? -arm.norm() : arm.norm();
        const bool sharp = feature != Feature::face && distance != 0;
        return {foot, sharp ? Vec<D>(arm / distance) : pseudonormal, distance, feature, patch};
    }

    SurfacePoint<D> over_edge(const Vec<D>& x, const Hit& hit) const
    {
        const int f = hit.facet, g = across(hit);
        const Vec<D> arm = x - hit.point.x, pseudonormal = (normal(f) + normal(g)).normalized();
        const bool inside = pseudonormal.dot(arm) < 0;
        if (features_.smooth[f][hit.point.ridge])
            return at(x, hit.point.x, pseudonormal, inside, Feature::face, features_.patch[f]);
        for (int border : {f, g})
            if (on_border_of(border, arm))
                return over_facet(x, border, hit.point.x);
        return at(x, hit.point.x, pseudonormal, inside, Feature::edge, features_.patch[f]);
    }

    SurfacePoint<D> over_vertex(const Vec<D>& x, const Hit& hit) const
    {
        const int vertex = mesh().elements[hit.facet][hit.point.vertex];
        const Vec<D>& foot = mesh().vertices[vertex];
        const Vec<D> arm = x - foot, &pseudonormal = features_.vertex_normal[vertex];
        const bool inside = features_.vertex_one_fan[vertex] ? pseudonormal.dot(arm) < 0 : winding_number(mesh(), x) > 0.5;
        Feature feature = features_.vertex_feature[vertex];
        if (feature == Feature::face)
            return at(x, foot, pseudonormal, inside, feature, features_.patch[hit.facet]);
        for (int f : features_.facets_at(vertex))
            if (on_border_of(f, arm))
                return over_facet(x, f, foot);
        if constexpr (D == 3)
            for (int f : features_.facets_at(vertex)) { // over the end of an edge: still over the edge
                const int i = local_index(f, vertex);
                const Vec<3> edge = mesh().vertices[mesh().elements[f][(i + 1) % 3]] - foot;
                if (!features_.smooth[f][(i + 2) % 3] && std::abs(edge.normalized().dot(arm)) <= tolerance_)
                    feature = Feature::edge;
            }
        return at(x, foot, pseudonormal, inside, feature, features_.patch[hit.facet]);
    }

    ClosedSurface<D> surface_;
    MeshFeatures<D> features_;
    std::vector<Facet<D>> facets_;
    FacetTree<D> tree_;
    MassProperties<D> mass_;
    Bounds<D> bounds_;
    std::uint64_t number_ = next_number();
    double tolerance_; ///< a point beyond a sharp edge by less counts as over the face
};

} // namespace

template <int D>
std::unique_ptr<Shape<D>> make_mesh(const std::string& file, double scale)
{
    require_positive("mesh " + file, "scale", scale);
    std::vector<int> lines;
    SurfaceMesh<D> surface = read_surface_file<D>(file, scale, &lines);
    return std::make_unique<Mesh<D>>(closed_surface(std::move(surface), file, lines));
}

template <int D>
std::unique_ptr<Shape<D>> make_mesh(SurfaceMesh<D> surface, const std::string& name)
{
    return std::make_unique<Mesh<D>>(closed_surface(std::move(surface), name));
}

template std::unique_ptr<Shape<2>> make_mesh<2>(const std::string&, double);
template std::unique_ptr<Shape<3>> make_mesh<3>(const std::string&, double);
template std::unique_ptr<Shape<2>> make_mesh<2>(SurfaceMesh<2>, const std::string&);
template std::unique_ptr<Shape<3>> make_mesh<3>(SurfaceMesh<3>, const std::string&);

} // namespace gapflow
