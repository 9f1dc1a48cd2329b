// Points of an element: it is divided evenly until pieces are no larger than the spacing and h changes by less than 1.3 over
// each, and cut where the closest point y (linear over the flat simplex y_0..y_{D-1}) crosses a plane of the grid, so that
// each piece has its y in one cell.
//
// Midpoint rule on each piece, second order, except: int h over a triangle of one piece, its corners counted by a twelfth each
// (exact for quadratic h); 2D, int 1/h = L ln(h_1/h_0) / (h_1 - h_0) on each half, exact for linear h; the area vectors and moments
// of the simplex, exact in sum (between flat surfaces their fractions are those of the piece in barycentric coordinates).
#include "gapflow/film/film_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace gapflow {
namespace {

constexpr double thickness_ratio = 1.3; ///< largest change of h over a piece ...
template <int D>
constexpr int most_for_ratio = D == 2 ? 8 : 1; ///< ... as long as an element needs no more divisions along an edge
constexpr int most_for_inverse = 6;            ///< the same for the integral of 1/h alone (3D)
constexpr int most_divisions = 64;
// A corner of an element within this of a plane of the grid, in dx, counts as on it, as it does for fractions: a film that ends there would
// touch the cells beyond or not by the round-off of its bodies' positions.
constexpr double on_plane = 1e-6;

template <int D>
using Barycentric = std::array<double, D>;

/// A piece of an element.
template <int D>
struct Piece {
    Barycentric<D> centre;
    double fraction;
    std::array<Barycentric<D>, 2> ends; ///< 2D
};

template <int D>
Vec<D> at(const std::array<Vec<D>, D>& corners, const Barycentric<D>& shape)
{
    Vec<D> x = Vec<D>::Zero();
    for (int k = 0; k < D; ++k)
        x += shape[k] * corners[k];
    return x;
}

/// int_0^1 dt / (h_0 + t (h_1 - h_0)).
double mean_inverse(double h0, double h1)
{
    const double r = (h1 - h0) / h0;
    return std::abs(r) < 1e-5 ? 2 / (h0 + h1) : std::log1p(r) / (h1 - h0);
}

void divide(const std::array<Vec<2>, 2>& y, int divisions, const FilmMeshOptions& o, std::vector<Piece<2>>& pieces)
{
    std::vector<double> cuts;
    for (int i = 0; i <= divisions; ++i)
        cuts.push_back(double(i) / divisions);
    for (int axis = 0; axis < 2; ++axis) {
        const double a = (y[0][axis] - o.origin[axis]) / o.dx, b = (y[1][axis] - o.origin[axis]) / o.dx;
        for (double k = std::floor(std::min(a, b) + on_plane) + 1; k < std::max(a, b) - on_plane; ++k)
            cuts.push_back((k - a) / (b - a));
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double s = cuts[i], t = cuts[i + 1], m = 0.5 * (s + t);
        if (t - s > 1e-12)
            pieces.push_back({{1 - m, m}, t - s, {{{1 - s, s}, {1 - t, t}}}});
    }
}

/// Convex polygon in barycentric coordinates; a triangle cut by two parallel planes an axis has at most nine corners.
struct Polygon {
    std::array<Vec<3>, 12> corners;
    int n = 0;
    void add(const Vec<3>& b)
    {
        if (n < int(corners.size()))
            corners[n++] = b;
    }
};

/// Appends the slices of a polygon between the planes where `height` . b is an integer.
void slice(const Polygon& whole, const Vec<3>& height, std::vector<Polygon>& slices)
{
    double low = 1e300, high = -1e300;
    for (int i = 0; i < whole.n; ++i) {
        low = std::min(low, height.dot(whole.corners[i]));
        high = std::max(high, height.dot(whole.corners[i]));
    }
    Polygon rest = whole;
    for (double k = std::floor(low + on_plane) + 1; k < high - on_plane && rest.n > 2; ++k) {
        Polygon below, above;
        for (int i = 0; i < rest.n; ++i) {
            const Vec<3>&a = rest.corners[i], &b = rest.corners[(i + 1) % rest.n];
            const double fa = height.dot(a) - k, fb = height.dot(b) - k;
            if (fa <= 0)
                below.add(a);
            if (fa >= 0)
                above.add(a);
            if (fa * fb < 0) {
                const Vec<3> cut = a + (b - a) * (fa / (fa - fb));
                below.add(cut);
                above.add(cut);
            }
        }
        if (below.n > 2)
            slices.push_back(below);
        rest = above;
    }
    if (rest.n > 2)
        slices.push_back(rest);
}

void divide(const std::array<Vec<3>, 3>& y, int q, const FilmMeshOptions& o, std::vector<Piece<3>>& pieces)
{
    static thread_local std::vector<Polygon> polygons, slices;
    polygons.clear();
    const auto corner = [q](int i, int j) { return Vec<3>(double(q - i - j) / q, double(i) / q, double(j) / q); };
    for (int i = 0; i < q; ++i)
        for (int j = 0; j < q - i; ++j) {
            Polygon& p = polygons.emplace_back();
            p.add(corner(i, j)), p.add(corner(i + 1, j)), p.add(corner(i, j + 1));
            if (j < q - i - 1) {
                Polygon& r = polygons.emplace_back();
                r.add(corner(i + 1, j)), r.add(corner(i + 1, j + 1)), r.add(corner(i, j + 1));
            }
        }
    for (int axis = 0; axis < 3; ++axis) {
        const Vec<3> height = (Vec<3>(y[0][axis], y[1][axis], y[2][axis]).array() - o.origin[axis]) / o.dx;
        if (std::floor(height.minCoeff() + on_plane) + 1 >= height.maxCoeff() - on_plane)
            continue;
        slices.clear();
        for (const Polygon& p : polygons)
            slice(p, height, slices);
        polygons.swap(slices);
    }
    double total = 0;
    const std::size_t first = pieces.size();
    for (const Polygon& p : polygons) {
        double area = 0;
        Vec<3> centre = Vec<3>::Zero();
        for (int k = 1; k + 1 < p.n; ++k) {
            const Vec<3> a = p.corners[k] - p.corners[0], b = p.corners[k + 1] - p.corners[0];
            const double w = std::abs(a[1] * b[2] - a[2] * b[1]);
            area += w;
            centre += w / 3 * (p.corners[0] + p.corners[k] + p.corners[k + 1]);
        }
        if (area < 1e-14)
            continue;
        centre /= area;
        total += area;
        pieces.push_back({{centre[0], centre[1], centre[2]}, area, {}});
    }
    for (std::size_t i = first; i < pieces.size(); ++i)
        pieces[i].fraction /= total;
}

/// Shares the flux of a curved other wall over an element's points as the wall itself has it, not its chord (2D): a wall that slides along
/// itself sweeps no volume anywhere. The chord of a wall of radius R sweeps U (L/2 - s) / R at s, an error that matters most between conforming
/// surfaces. The small difference of both over the whole element is shared evenly, so the sum stays the chord's.
void bend_areas(const Vec<2>& area, const std::array<Vec<2>, 2>& y, std::span<FilmPoint<2>> points)
{
    constexpr double straight = 1e-12;
    const double size = area.norm();
    const Vec<2> normal = points.front().other_normal;
    const bool curved = std::any_of(points.begin(), points.end(),
                                    [&](const FilmPoint<2>& p) { return (p.other_normal - normal).norm() > straight; });
    if (!curved || !(size > 0))
        return;
    const Vec<2> centre = 0.5 * (y[0] + y[1]);
    // Wrenches about the chord's centre; the chord's own is (area, 0).
    double weight = 0;
    Twist<2> sum = Twist<2>::Zero();
    const auto own = [&](const FilmPoint<2>& p) {
        const double cosine = std::max(-p.other_normal.dot(area) / size, least_cosine);
        return wrench<2>(Vec<2>(-p.weight * size / cosine * p.other_normal), p.y - centre);
    };
    for (const FilmPoint<2>& p : points) {
        weight += p.weight;
        sum += own(p);
    }
    sum.head<2>() -= weight * area;
    for (FilmPoint<2>& p : points) {
        const Twist<2> flux = (own(p) - p.weight / weight * sum) / weight;
        const Vec<2> share = flux.head<2>();
        // where an area has that moment
        p.share = {share, centre + flux[2] / share.squaredNorm() * Vec<2>(share[1], -share[0])};
    }
}

} // namespace

template <int D>
Vec<D> area_vector(const std::array<Vec<D>, D>& c)
{
    if constexpr (D == 2)
        return {c[1][1] - c[0][1], c[0][0] - c[1][0]};
    else
        return 0.5 * (c[1] - c[0]).cross(c[2] - c[0]);
}

namespace {

struct Divisions {
    int edge, for_inverse; // of an element's edge; the same for the mean of 1/h
};

// So fine that pieces are as small as the grid requires, and their thicknesses similar.
template <int D>
Divisions divisions_of(const std::array<Vec<D>, D>& x, const std::array<Vec<D>, D>& y, const Barycentric<D>& h,
                       const FilmMeshOptions& o, bool flat)
{
    double size = 0;
    for (int k = 0; k < D; ++k)
        size = std::max({size, (x[k] - x[(k + 1) % D]).norm(), (y[k] - y[(k + 1) % D]).norm()});
    const double spacing = o.dx * (o.spacing > 0 ? o.spacing : D == 2 ? 0.125 : flat ? 0.5 : 0.25);
    const auto [lowest, highest] = std::minmax_element(h.begin(), h.end());
    const int divisions = std::max(1, int(std::ceil(std::min(size / spacing, double(most_divisions)) - 1e-6)));
    const double for_ratio = std::ceil(std::log(*highest / *lowest) / std::log(thickness_ratio) - 1e-6);
    return {std::max(divisions, int(std::min(for_ratio, double(most_for_ratio<D>)))),
            std::max(divisions, int(std::min(for_ratio, double(most_for_inverse))))};
}

} // namespace

template <int D>
void add_points(const GapTest<D>& test, int master_patch, int other_patch, bool flat, int e, FilmMesh<D>& film)
{
    const FilmMeshOptions& o = test.options;
    FilmElement<D>& element = film.elements[e];
    std::array<Vec<D>, D> x, y;
    Barycentric<D> h;
    for (int k = 0; k < D; ++k) {
        x[k] = film.x[element.nodes[k]];
        y[k] = film.y[element.nodes[k]];
        h[k] = film.h[element.nodes[k]];
    }
    auto [divisions, for_inverse] = divisions_of<D>(x, y, h, o, flat);
    if (D == 3 && !o.inverse && !element.coarse)
        for_inverse = divisions;

    static thread_local std::vector<Piece<D>> pieces;
    pieces.clear();
    divide(y, divisions, o, pieces);

    // The gap at a place of the element: interpolated, or that of the exact surfaces.
    const Vec<D> normal = test.other.patch_normal(at<D>(y, pieces.front().centre), other_patch);
    const auto gap = [&](const Barycentric<D>& shape, FilmPoint<D>& p) {
        p.x = at<D>(x, shape);
        if (!flat) {
            p.x = test.onto(p.x, master_patch);
            const SurfacePoint<D> s = test.other.closest(p.x);
            if (s.feature == Feature::face && test.in_label(s.patch)) {
                p.y = s.x;
                p.other_normal = s.normal;
                p.h = test.thickness(s);
                return;
            }
        }
        p.y = at<D>(y, shape);
        p.other_normal = normal;
        p.h = 0;
        for (int k = 0; k < D; ++k)
            p.h += shape[k] * h[k];
        p.h = std::max(p.h, o.floor);
    };
    const Vec<D> area = area_vector<D>(y);
    [[maybe_unused]] const std::size_t first_point = film.points.size();
    element.volume = element.inverse = 0;
    element.lean = Vec<D>::Zero();
    element.into_other = element.place_on_other = Vec<D>::Zero();
    // What is across the gap of a distance along the other's normal, and what is along the film.
    const auto across = [&](const FilmPoint<D>& p) {
        return o.viscous ? 1.0 : std::max(-p.other_normal.dot(element.normal), least_cosine);
    };
    const auto along = [&](const FilmPoint<D>& p) {
        return o.viscous ? Vec<D>(Vec<D>::Zero())
                         : Vec<D>(p.other_normal.dot(element.normal) * element.normal - p.other_normal);
    };
    for (const Piece<D>& piece : pieces) {
        FilmPoint<D>& p = film.points.emplace_back();
        p.element = e;
        p.shape = piece.centre;
        p.weight = piece.fraction * element.measure;
        if constexpr (D == 2)
            p.share = {piece.fraction * area, at<D>(y, piece.centre)};
        else
            p.fraction = piece.fraction;
        gap(piece.centre, p);
        if constexpr (D == 2)
            for (const auto& end_shape : piece.ends) {
                FilmPoint<2> end;
                gap(end_shape, end);
                element.inverse += 0.5 * p.weight * mean_inverse(p.h, end.h) / across(p);
            }
        element.volume += p.weight * p.h * across(p);
        element.lean += p.weight * p.h * along(p);
        element.into_other -= piece.fraction * p.other_normal;
        element.place_on_other += piece.fraction * p.y;
        if (D == 3 && for_inverse == divisions)
            element.inverse += p.weight / (p.h * across(p));
    }
    element.into_other.normalize();
    if constexpr (D == 2)
        if (!flat && pieces.size() > 1)
            bend_areas(area, y, std::span(film.points).subspan(first_point));
    if (D == 3 && pieces.size() == 1) {
        const double mean = 0.75 * film.points.back().h + 0.25 * (h[0] + h[1] + h[D - 1]) / 3;
        element.volume = element.measure * mean * across(film.points.back());
        element.lean = element.measure * mean * along(film.points.back());
    }
    if constexpr (D == 3)
        if (for_inverse > divisions) {
            pieces.clear();
            divide(y, for_inverse, o, pieces);
            for (const Piece<3>& piece : pieces) {
                FilmPoint<3> p;
                gap(piece.centre, p);
                element.inverse += piece.fraction * element.measure / (p.h * across(p));
            }
        }
    // int h int 1/h >= measure^2, also where the midpoint rule for h misses its kink at the floor
    element.inverse = std::max(element.inverse, element.measure * element.measure / element.volume);
}

template <int D>
WallShare<D> wall_share(const FilmMesh<D>& mesh, const FilmPoint<D>& point)
{
    if constexpr (D == 2) {
        return point.share;
    } else {
        std::array<Vec<D>, D> y;
        for (int k = 0; k < D; ++k)
            y[k] = mesh.y[mesh.elements[point.element].nodes[k]];
        return {point.fraction * area_vector<D>(y), at<D>(y, point.shape)};
    }
}

template WallShare<2> wall_share(const FilmMesh<2>&, const FilmPoint<2>&);
template WallShare<3> wall_share(const FilmMesh<3>&, const FilmPoint<3>&);
template Vec<2> area_vector<2>(const std::array<Vec<2>, 2>&);
template Vec<3> area_vector<3>(const std::array<Vec<3>, 3>&);
template void add_points(const GapTest<2>&, int, int, bool, int, FilmMesh<2>&);
template void add_points(const GapTest<3>&, int, int, bool, int, FilmMesh<3>&);

} // namespace gapflow
