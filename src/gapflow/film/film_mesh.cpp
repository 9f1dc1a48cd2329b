// From the cut surface to films: connected pieces, thickness, mid-gap elements, rims (method, "Mesh").
//
// On a mid-gap simplex with vertices X_k, area A and unit normal n (vertices anticlockwise about n) the linear shape
// functions have the gradients n x (X_{k+2} - X_{k+1}) / 2A; on a segment +- tangent / length.
#include "gapflow/film/film_mesh.hpp"

#include "gapflow/film/film_quadrature.hpp"
#include "gapflow/film/ring_cut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace gapflow {
namespace {

constexpr double least_element = 1e-14; ///< measure, in dx^(D-1)
constexpr double least_film = 1e-6;     ///< measure, in dx^(D-1)

template <int D>
using Simplex = std::array<Vec<D>, D>;

template <int D>
Vec<D> mean(const Simplex<D>& corners)
{
    Vec<D> m = Vec<D>::Zero();
    for (const Vec<D>& c : corners)
        m += c / D;
    return m;
}

/// Normal, gradients, measure and centroid of a mid-gap element.
template <int D>
void set_geometry(const Simplex<D>& mid, FilmElement<D>& element)
{
    const Vec<D> area = area_vector<D>(mid);
    element.measure = area.norm();
    element.normal = area / element.measure;
    element.centroid = mean<D>(mid);
    if constexpr (D == 2) {
        element.gradient[1] = (mid[1] - mid[0]) / (element.measure * element.measure);
        element.gradient[0] = -element.gradient[1];
    } else {
        for (int k = 0; k < 3; ++k)
            element.gradient[k] = element.normal.cross(mid[(k + 2) % 3] - mid[(k + 1) % 3]) / (2 * element.measure);
    }
}

/// Builds the films of one label of the other.
template <int D>
class Assembler {
public:
    Assembler(const GapTest<D>& test, const GapCut<D>& cut) : test_(test), cut_(cut)
    {
        dx_measure_ = std::pow(test.options.dx, D - 1);
        place_nodes();
        for (const auto& e : cut.elements)
            if (const double m = area_vector<D>(corners(mid_, e.nodes)).norm(); m > least_element * dx_measure_)
                elements_.push_back(e);
    }

    std::vector<FilmMesh<D>> films(bool capped)
    {
        std::vector<FilmMesh<D>> all;
        for (const std::vector<int>& piece : pieces()) {
            double measure = 0;
            for (int e : piece)
                measure += area_vector<D>(corners(mid_, elements_[e].nodes)).norm();
            if (measure < least_film * dx_measure_)
                continue;
            all.push_back(film(piece));
            all.back().capped = capped;
        }
        return all;
    }

private:
    static Simplex<D> corners(const std::vector<Vec<D>>& x, const std::array<int, D>& nodes)
    {
        Simplex<D> c;
        for (int k = 0; k < D; ++k)
            c[k] = x[nodes[k]];
        return c;
    }

    /// y, h and mid-gap of the cut's nodes. At a switch between patches of the other, the value inside the label.
    void place_nodes()
    {
        for (const auto& node : cut_.nodes) {
            SurfacePoint<D> p = test_.other.closest(node.x);
            if (p.patch != node.p.patch) {
                p.patch = node.p.patch;
                p.x = node.p.x;
                p.distance = node.p.distance;
            }
            y_.push_back(p.x);
            h_.push_back(test_.thickness(p));
            mid_.push_back(node.x + 0.5 * (p.x - node.x));
        }
    }

    /// Facets of an element: 2D its nodes, 3D its edges.
    std::array<int, 2> facet(int e, int k) const
    {
        const auto& n = elements_[e].nodes;
        return {n[k], D == 2 ? n[k] : n[(k + 1) % D]};
    }

    /// Elements joined by facets.
    std::vector<std::vector<int>> pieces()
    {
        const int n = int(elements_.size());
        std::vector<int> root(n), number(n, -1);
        std::iota(root.begin(), root.end(), 0);
        const auto find = [&](int i) {
            while (root[i] != i)
                i = root[i] = root[root[i]];
            return i;
        };
        facets_.reset(2 * n);
        for (int e = 0; e < n; ++e)
            for (int k = 0; k < D; ++k) {
                int& id = facets_.insert(facet(e, k)[0], facet(e, k)[1]);
                if (id < 0) {
                    id = int(uses_.size());
                    uses_.push_back({1, e});
                } else {
                    ++uses_[id].count;
                    const int a = find(e), b = find(uses_[id].first);
                    root[std::max(a, b)] = std::min(a, b);
                }
            }
        std::vector<std::vector<int>> pieces;
        for (int e = 0; e < n; ++e) {
            int& id = number[find(e)];
            if (id < 0) {
                id = int(pieces.size());
                pieces.emplace_back();
            }
            pieces[id].push_back(e);
        }
        return pieces;
    }

    FilmMesh<D> film(const std::vector<int>& piece)
    {
        FilmMesh<D> film;
        film.other_patch = test_.label.empty() ? 0 : test_.label.front();
        film.flat = true;
        film.viscous = test_.options.viscous;
        film.elements.reserve(piece.size());
        film.points.reserve((D == 2 ? 4 : 2) * piece.size());
        number_.resize(cut_.nodes.size(), -1);
        const int first_patch = elements_[piece.front()].patch;
        const int first_other = cut_.nodes[elements_[piece.front()].nodes[0]].p.patch;
        for (int e : piece) {
            const auto& [nodes, patch] = elements_[e];
            FilmElement<D>& element = film.elements.emplace_back();
            bool one_patch = true;
            for (int k = 0; k < D; ++k) {
                const int i = nodes[k];
                if (number_[i] < 0) {
                    number_[i] = int(film.x.size());
                    film.x.push_back(cut_.nodes[i].x);
                    film.y.push_back(y_[i]);
                    film.h.push_back(h_[i]);
                    film.mid.push_back(mid_[i]);
                }
                element.nodes[k] = number_[i];
                one_patch &= cut_.nodes[i].p.patch == cut_.nodes[nodes[0]].p.patch;
            }
            const int other_patch = cut_.nodes[nodes[0]].p.patch;
            const bool flat =
                one_patch && test_.master.shape().curvature(patch) == 0 && test_.other.shape().curvature(other_patch) == 0;
            film.flat &= flat && patch == first_patch && other_patch == first_other;
            set_geometry<D>(corners(mid_, nodes), element);
            set_lateral(patch, other_patch, film, element);
            add_points(test_, patch, other_patch, flat, int(film.elements.size()) - 1, film);
            set_walls(patch, flat, corners(film.x, element.nodes), corners(film.y, element.nodes), element);
            add_rim(e, film);
        }
        film.points.shrink_to_fit(); // most of a film's memory
        for (int e : piece)          // ready for the next piece (pieces may touch in a node)
            for (int i : elements_[e].nodes)
                number_[i] = -1;
        return film;
    }

    void set_walls(int patch, bool flat, const Simplex<D>& x, const Simplex<D>& y, FilmElement<D>& element) const
    {
        element.centroid_master = test_.onto(mean<D>(x), patch);
        element.centroid_other = mean<D>(y);
        if (flat)
            return;
        const SurfacePoint<D> p = test_.other.closest(element.centroid_master);
        if (test_.in_label(p.patch))
            element.centroid_other = p.x;
    }

    void set_lateral(int patch, int other_patch, const FilmMesh<D>& film, FilmElement<D>& element) const
    {
        const double curvature = test_.curvature(patch, other_patch);
        double bent = 0, h = film.h[element.nodes[0]]; // most of length^2 times the curvature along it
        for (int k = 0; k < D; ++k) {
            const int a = element.nodes[k], b = element.nodes[(k + 1) % D];
            bent =
                std::max(bent, (film.x[a] - film.x[b]).squaredNorm() *
                                   test_.curvature_along(patch, other_patch, {film.x[a], film.x[b]}, {film.y[a], film.y[b]}));
            h = std::min(h, film.h[a]);
        }
        element.lateral = curvature > 0 ? std::sqrt(2 * h / curvature) : std::numeric_limits<double>::infinity();
        const double coarsest = 1.2 * test_.options.curved;
        element.coarse = bent > 2 * h * coarsest * coarsest;
    }

    /// Adds the facets of element e (the film's last) that no other element shares.
    void add_rim(int e, FilmMesh<D>& film)
    {
        const FilmElement<D>& element = film.elements.back();
        for (int k = 0; k < D; ++k) {
            const auto [a, b] = facet(e, k);
            if (uses_[facets_.find(a, b)].count > 1)
                continue;
            RimEdge<D> rim;
            rim.element = int(film.elements.size()) - 1;
            rim.nodes[0] = element.nodes[k];
            if constexpr (D == 2) {
                rim.length = 1;
                rim.outward = element.gradient[k].normalized();
            } else {
                rim.nodes[1] = element.nodes[(k + 1) % 3];
                const Vec<3> along = mid_[b] - mid_[a];
                rim.length = along.norm();
                // for rims far shorter than the element the direction comes from its gradients
                rim.outward = along.cross(element.normal);
                rim.outward =
                    rim.length > 0 ? Vec<3>(rim.outward / rim.length) : Vec<3>(-element.gradient[(k + 2) % 3].normalized());
            }
            rim.end = why(e, k, rim.outward);
            film.rim.push_back(rim);
        }
    }

    /// Why the film ends at facet k of element e.
    RimEnd why(int e, int k, const Vec<D>& outward) const
    {
        const auto [a, b] = facet(e, k);
        const auto &end_a = cut_.nodes[a].end, &end_b = cut_.nodes[b].end;
        if constexpr (D == 2) {
            return end_a.value_or(RimEnd::master_edge);
        } else {
            if (cut_.creases.find(a, b) >= 0)
                return RimEnd::master_edge;
            if (end_a && end_a == end_b)
                return *end_a;
            // Two ends meet, or the part beyond was dropped: test there, slightly further out if the rim is curved.
            const int patch = elements_[e].patch;
            for (double step : {1e-6, 1e-3, 1e-2}) {
                const Vec<D> beyond = 0.5 * (cut_.nodes[a].x + cut_.nodes[b].x) + step * test_.options.dx * outward;
                const Vec<D> x = test_.onto(beyond, patch);
                if (const auto f = test_.fails(x, test_.master.patch_normal(x, patch), test_.other.closest(x)))
                    return *f;
            }
            return end_a ? *end_a : end_b ? *end_b : RimEnd::thickness;
        }
    }

    struct Use {
        int count, first;
    };
    const GapTest<D>& test_;
    const GapCut<D>& cut_;
    double dx_measure_;
    std::vector<Vec<D>> y_, mid_;
    std::vector<double> h_;
    std::vector<typename FilmSurface<D>::Element> elements_;
    EdgeTable facets_;
    std::vector<Use> uses_;
    std::vector<int> number_;
};

/// The films with all sizes times `scale`; nothing if they have more nodes than allowed.
template <int D>
std::optional<std::vector<FilmMesh<D>>> films_at_scale(const FilmSurface<D>& base, double scale)
{
    std::vector<FilmMesh<D>> films;
    FilmSurface<D> coarse = base;
    if (!coarse.refine_coarsely(scale))
        return {};
    for (const std::vector<int>& label : smooth_groups<D>(base.test().other.shape(), coarse.other_patches())) {
        FilmSurface<D> surface = coarse;
        surface.restrict_to(label);
        if (!surface.refine(scale))
            return {};
        const GapCut<D> cut = cut_at_end(surface);
        for (FilmMesh<D>& film : Assembler<D>(surface.test(), cut).films(scale > 1))
            films.push_back(std::move(film));
    }
    return films;
}

/// The film of a gap in rings, or none.
std::vector<FilmMesh<3>> ring_films(GapTest<3> test, const GapCut<3>& cut)
{
    if (cut.nodes.empty())
        return {};
    std::set<int> patches;
    for (const GapCut<3>::Node& node : cut.nodes)
        patches.insert(node.p.patch);
    test.label.assign(patches.begin(), patches.end());
    test.options.curved = 1.7 * test.options.rings; // diagonals of elements between rings that no limit keeps apart
    return Assembler<3>(test, cut).films(false);
}

} // namespace

template <int D>
FilmMeshOptions coupling_sizes(bool viscous)
{
    FilmMeshOptions options;
    options.viscous = viscous;
    if (D == 3) {
        options.largest_curved = 1;
        options.curved = 0.4;
        options.smallest = viscous ? 1e-4 : 1. / 16;
        options.straddle_open = 0.5;
        options.straddle_smooth = 1;
        options.rings = viscous ? 0.4 : 0.6;
        options.inverse = viscous;
        options.kink = 0.06;
        options.spacing = 1;
        options.ratio = 3;
    }
    return options;
}

template <int D>
std::vector<FilmMesh<D>> film_meshes(const PlacedShape<D>& master, const PlacedShape<D>& other,
                                     const std::function<double(const Vec<D>&, const Vec<D>&)>& third,
                                     const FilmMeshOptions& options, const SurfaceMesh<D>* base)
{
    GapTest<D> test{master, other, third, options, {}};
    if (test.options.smallest <= 0)
        test.options.smallest = D == 2 ? 1e-4 : 1. / 32;

    if constexpr (D == 3)
        if (const auto cut = ring_cut(test))
            return ring_films(test, *cut);
    const FilmSurface<D> surface(test, base ? *base : master.shape().surface_mesh());
    if (surface.elements().empty())
        return {};
    double scale = 1;
    auto films = films_at_scale(surface, scale);
    while (!films && scale < 1e6) {
        scale *= D == 2 ? 2 : std::sqrt(2.0);
        films = films_at_scale(surface, scale);
    }
    return films ? std::move(*films) : std::vector<FilmMesh<D>>{};
}

template <int D>
void take_skin_off(FilmMesh<D>& mesh, double skin)
{
    mesh.skin = skin;
    if (skin == 0)
        return;
    for (double& h : mesh.h)
        h -= skin;
    std::vector<double> across; // of each element: n.d, and the tangent of that angle
    std::vector<Vec<D>> lean;
    for (FilmElement<D>& e : mesh.elements) {
        lean.push_back(e.lean / e.volume);
        across.push_back(e.cosine());
        e.volume = e.inverse = 0;
    }
    for (FilmPoint<D>& point : mesh.points) {
        point.h -= skin;
        mesh.elements[point.element].volume += point.weight * point.h * across[point.element];
        mesh.elements[point.element].inverse += point.weight / (point.h * across[point.element]);
    }
    for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
        FilmElement<D>& e = mesh.elements[k];
        e.lean = e.volume * lean[k];
        e.inverse = std::max(e.inverse, e.measure * e.measure / e.volume);
    }
}

template void take_skin_off<2>(FilmMesh<2>&, double);
template void take_skin_off<3>(FilmMesh<3>&, double);
template FilmMeshOptions coupling_sizes<2>(bool);
template FilmMeshOptions coupling_sizes<3>(bool);
template std::vector<FilmMesh<2>> film_meshes(const PlacedShape<2>&, const PlacedShape<2>&,
                                              const std::function<double(const Vec<2>&, const Vec<2>&)>&,
                                              const FilmMeshOptions&, const SurfaceMesh<2>*);
template std::vector<FilmMesh<3>> film_meshes(const PlacedShape<3>&, const PlacedShape<3>&,
                                              const std::function<double(const Vec<3>&, const Vec<3>&)>&,
                                              const FilmMeshOptions&, const SurfaceMesh<3>*);

} // namespace gapflow
