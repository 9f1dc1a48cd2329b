// A face in 3D is a square (u, v) in [0, 1]^2. It is split into convex fragments by affine functions
//
//     f(u, v) = f_0 + f_u u + f_v v,
//
// exactly by the planes of flat-faced solids, and by phi of other shapes interpolated on 2 x 2 x 2 triangles whose diagonals
// meet in the middle of the face (the pattern has the square's own symmetries), those near a surface cut in four once more
// (error of the volume of a ball of radius 4 dx that is cut so: -0.13 % instead of -0.52 %). Each fragment stores the solids in which it lies: none:
// open; one: that solid's; several: split once more where their distances, linear on the triangles about its middle, are equal. All
// splits divide the whole fragment, so the parts sum to the square. Exact for flat faces that do not overlap, else second
// order (after Ng, Min & Gibou 2009).
//
// Where the curved solids on a face are all spheres and overlap by no more than the tolerance, their parts of the fragments that flat
// solids leave open are closed forms (sphere_sections): exact. Method, "Face fractions".
#include "gapflow/grid/clip_kernels.hpp"
#include "gapflow/grid/sphere_sections.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace gapflow {

namespace {

constexpr int m = 2;              // pieces along an edge of the face; even, for the symmetry of the diagonals
constexpr int nodes = 2 * m;      // of the triangles cut in four: (nodes + 1)^2
constexpr double far = 0.1;       // triangles with |phi| > far (in dx) at their corners are not cut in four
constexpr int most_vertices = 24; // of a fragment: 3 or 4, one more a split

struct Affine {
    double f0, fu, fv;
    double operator()(double u, double v) const { return f0 + fu * u + fv * v; }
};

template <int Capacity>
struct Vertices {
    int n = 0;
    std::array<double, Capacity> u, v;
    void add(double u_, double v_)
    {
        u[n] = u_;
        v[n++] = v_;
    }
};

using Polygon = Vertices<most_vertices>;
using SmallPolygon = Vertices<5>; // a triangle, split once

struct Fragment {
    Polygon polygon;
    std::uint64_t inside; ///< bit i: in cutter i
};

// An affine function through three values.
Affine through(const double (&u)[3], const double (&v)[3], const double (&f)[3])
{
    const double u1 = u[1] - u[0], u2 = u[2] - u[0], v1 = v[1] - v[0], v2 = v[2] - v[0];
    const double f1 = f[1] - f[0], f2 = f[2] - f[0], det = u1 * v2 - u2 * v1;
    const double fu = (f1 * v2 - f2 * v1) / det, fv = (u1 * f2 - u2 * f1) / det;
    return {f[0] - fu * u[0] - fv * v[0], fu, fv};
}

// Splits `p` into f <= 0 (low) and f >= 0 (high); either may come back empty (n = 0). If f = 0 everywhere, all is low, or
// high if `zero_is_high`.
template <int Capacity, class F>
void split(const Vertices<Capacity>& p, F&& f, double tolerance, bool zero_is_high, Vertices<Capacity>& low,
           Vertices<Capacity>& high)
{
    std::array<double, Capacity> value;
    bool negative = false, positive = false;
    for (int i = 0; i < p.n; ++i) {
        value[i] = f(i);
        if (std::abs(value[i]) <= tolerance)
            value[i] = 0;
        negative |= value[i] < 0;
        positive |= value[i] > 0;
    }
    low.n = high.n = 0;
    if (negative && positive && p.n + 1 < Capacity) {
        for (int i = 0; i < p.n; ++i) {
            const int j = i + 1 < p.n ? i + 1 : 0;
            if (value[i] <= 0)
                low.add(p.u[i], p.v[i]);
            if (value[i] >= 0)
                high.add(p.u[i], p.v[i]);
            if ((value[i] < 0 && value[j] > 0) || (value[i] > 0 && value[j] < 0)) {
                const double t = value[i] / (value[i] - value[j]);
                const double u = p.u[i] + t * (p.u[j] - p.u[i]), v = p.v[i] + t * (p.v[j] - p.v[i]);
                low.add(u, v);
                high.add(u, v);
            }
        }
    } else if (positive || (zero_is_high && !negative)) {
        high = p;
    } else {
        low = p;
    }
}

template <int Capacity>
void add_area(const Vertices<Capacity>& p, PartSum<3>& sum)
{
    for (int i = 1; i + 1 < p.n; ++i) {
        const double area = 0.5 * ((p.u[i] - p.u[0]) * (p.v[i + 1] - p.v[0]) - (p.u[i + 1] - p.u[0]) * (p.v[i] - p.v[0]));
        sum.add(area, {(p.u[0] + p.u[i] + p.u[i + 1]) / 3, (p.v[0] + p.v[i] + p.v[i + 1]) / 3});
    }
}

class SquareClipper {
public:
    void clip(const Vec<3>& corner, const std::array<double, 2>& edges, const std::array<int, 2>& tangents,
              std::span<const Cutter<3>> cutters, double tolerance, FaceSums<3>& sums)
    {
        corner_ = corner;
        edges_ = edges;
        unit_ = std::max(edges[0], edges[1]);
        tangents_ = tangents;
        cutters_ = cutters.first(std::min<std::size_t>(cutters.size(), 64));
        tolerance_ = tolerance / unit_;
        sums_ = &sums;
        planes_.resize(std::max(planes_.size(), cutters_.size()));
        values_.resize(std::max(values_.size(), cutters_.size()));
        spheres_.clear();
        bool curved = false, flat = false;
        for (std::size_t i = 0; i < cutters_.size(); ++i)
            if (cutters_[i].planes.empty()) {
                curved = true;
            } else {
                flat = true;
                take_planes(static_cast<int>(i));
            }
        if (!curved || spheres_.take(corner, tangents, cutters_, tolerance))
            clip_square();
        else
            clip_triangles(flat);
    }

private:
    double phi(int cutter, double u, double v) const
    {
        Vec<3> x = corner_;
        x[tangents_[0]] += u * edges_[0];
        x[tangents_[1]] += v * edges_[1];
        return cutters_[cutter].shape->distance(x) / unit_;
    }

    void take_planes(int cutter)
    {
        planes_[cutter].clear();
        for (const Plane<3>& plane : cutters_[cutter].planes)
            planes_[cutter].push_back({(plane.normal.dot(corner_) - plane.offset) / unit_,
                                       plane.normal[tangents_[0]] * (edges_[0] / unit_),
                                       plane.normal[tangents_[1]] * (edges_[1] / unit_)});
    }

    void clip_square()
    {
        Polygon square;
        square.add(0, 0);
        square.add(1, 0);
        square.add(1, 1);
        square.add(0, 1);
        fragments_.assign(1, {square, 0});
        cut_all({});
    }

    struct Node {
        int a, b; ///< on the (nodes + 1)^2 lattice
    };

    // phi of a curved cutter at a node, kept for the other triangles there.
    double value(std::size_t cutter, Node node)
    {
        double& v = values_[cutter][node.b * (nodes + 1) + node.a];
        if (std::isnan(v))
            v = phi(static_cast<int>(cutter), node.a / double(nodes), node.b / double(nodes));
        return v;
    }

    void clip_triangles(bool flat)
    {
        for (std::size_t i = 0; i < cutters_.size(); ++i)
            if (cutters_[i].planes.empty())
                values_[i].fill(std::numeric_limits<double>::quiet_NaN());
        for (int q = 0; q < m; ++q)
            for (int p = 0; p < m; ++p)
                for (int half = 0; half < 2; ++half) {
                    // Corners of the piece counterclockwise, from one end of its diagonal.
                    static constexpr int ring[4][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
                    const int start = (p + q) % 2, corners[3] = {start, (start + 1 + half) % 4, (start + 2 + half) % 4};
                    std::array<Node, 3> c, mid;
                    for (int k = 0; k < 3; ++k)
                        c[k] = {2 * p + ring[corners[k]][0], 2 * q + ring[corners[k]][1]};
                    if (!near_surface(c)) {
                        clip_triangle(c, flat);
                        continue;
                    }
                    for (int k = 0; k < 3; ++k)
                        mid[k] = {(c[k].a + c[(k + 1) % 3].a) / 2, (c[k].b + c[(k + 1) % 3].b) / 2};
                    for (int k = 0; k < 3; ++k)
                        clip_triangle({c[k], mid[k], mid[(k + 2) % 3]}, flat);
                    clip_triangle(mid, flat);
                }
    }

    bool near_surface(const std::array<Node, 3>& c)
    {
        for (std::size_t i = 0; i < cutters_.size(); ++i)
            if (cutters_[i].planes.empty()) {
                const double f[3] = {value(i, c[0]), value(i, c[1]), value(i, c[2])};
                if (std::min({f[0], f[1], f[2]}) <= far && std::max({f[0], f[1], f[2]}) >= -far)
                    return true;
            }
        return false;
    }

    void clip_triangle(const std::array<Node, 3>& c, bool flat)
    {
        double u[3], v[3];
        for (int k = 0; k < 3; ++k) {
            u[k] = c[k].a / double(nodes);
            v[k] = c[k].b / double(nodes);
        }
        int owner = -1, near = 0;
        bool whole = true; // outside all, or inside one
        for (std::size_t i = 0; i < cutters_.size() && !flat && near < 2; ++i) {
            const double f[3] = {value(i, c[0]), value(i, c[1]), value(i, c[2])};
            if (std::min({f[0], f[1], f[2]}) > tolerance_)
                continue;
            ++near;
            whole = std::max({f[0], f[1], f[2]}) < -tolerance_;
            owner = static_cast<int>(i);
        }
        SmallPolygon triangle;
        for (int k = 0; k < 3; ++k)
            triangle.add(u[k], v[k]);
        if (!flat && whole && near < 2)
            return add_area(triangle, owner < 0 ? sums_->open : sums_->solid[owner]);
        if (near == 1) { // most triangles
            const Affine f = through(u, v, {value(owner, c[0]), value(owner, c[1]), value(owner, c[2])});
            SmallPolygon low, high;
            split(
                triangle, [&](int i) { return f(triangle.u[i], triangle.v[i]); }, tolerance_, false, low, high);
            add_area(low, sums_->solid[owner]);
            return add_area(high, sums_->open);
        }
        linear_.resize(cutters_.size());
        for (std::size_t i = 0; i < cutters_.size(); ++i)
            if (cutters_[i].planes.empty())
                linear_[i] = through(u, v, {value(i, c[0]), value(i, c[1]), value(i, c[2])});
        Polygon fragment;
        for (int k = 0; k < 3; ++k)
            fragment.add(u[k], v[k]);
        fragments_.assign(1, {fragment, 0});
        cut_all(linear_);
    }

    // Cuts the fragments by every solid in turn and adds them to the parts.
    void cut_all(std::span<const Affine> linear)
    {
        for (int i = 0; i < static_cast<int>(cutters_.size()); ++i) {
            if (cutters_[i].planes.empty() && linear.empty())
                continue; // spheres: from what is open in the end
            next_.clear();
            for (const Fragment& fragment : fragments_)
                if (cutters_[i].planes.empty())
                    cut_by({&linear[i], 1}, i, false, fragment);
                else
                    cut_by(planes_[i], i, cutters_[i].complement, fragment);
            fragments_.swap(next_);
        }
        for (const Fragment& fragment : fragments_)
            give(fragment);
    }

    // The solid is where all functions are <= 0, or (complement) where any is >= 0.
    void cut_by(std::span<const Affine> functions, int cutter, bool complement, const Fragment& fragment)
    {
        const std::uint64_t in = fragment.inside | std::uint64_t(1) << cutter, out = fragment.inside;
        Polygon rest = fragment.polygon, low, high;
        for (const Affine& f : functions) {
            split(
                rest, [&](int i) { return f(rest.u[i], rest.v[i]); }, tolerance_, complement, low, high);
            if (high.n > 0)
                next_.push_back({high, complement ? in : out});
            if (low.n == 0)
                return;
            if (high.n > 0)
                rest = low;
        }
        next_.push_back({rest, complement ? out : in});
    }

    void give(const Fragment& fragment)
    {
        if (fragment.inside == 0 && !spheres_.empty())
            share_with_spheres(fragment.polygon);
        else if (fragment.inside == 0)
            add_area(fragment.polygon, sums_->open);
        else if (std::has_single_bit(fragment.inside))
            add_area(fragment.polygon, sums_->solid[std::countr_zero(fragment.inside)]);
        else
            share(fragment);
    }

    // A fragment that lies in no flat solid: the spheres' parts of it, and the rest. Parts below the tolerance are none, as a ball that touches
    // a grid plane has none.
    void share_with_spheres(const Polygon& fragment)
    {
        std::array<Eigen::Vector2d, most_vertices> places;
        for (int i = 0; i < fragment.n; ++i)
            places[i] = {fragment.u[i] * edges_[0], fragment.v[i] * edges_[1]};
        const std::span<const Eigen::Vector2d> polygon = std::span(places).first(fragment.n);
        const Eigen::Vector2d scale(edges_[0], edges_[1]);
        PartSum<3> rest = area_of(polygon);
        const auto in_units_of_face = [&](const PartSum<3>& part) {
            return PartSum<3>{part.measure / scale.prod(), part.moment.cwiseQuotient(scale) / scale.prod()};
        };
        for (const SphereSections::Section& section : spheres_.sections()) {
            const PartSum<3> part = spheres_.part(section, polygon);
            if (part.measure <= tolerance_ * scale.prod())
                continue;
            rest -= part;
            sums_->solid[section.cutter] += in_units_of_face(part);
        }
        sums_->open += in_units_of_face(rest);
    }

    // A fragment in several solids.
    void share(const Fragment& fragment)
    {
        const Polygon& p = fragment.polygon;
        owners_.clear();
        for (std::uint64_t left = fragment.inside; left != 0; left &= left - 1)
            owners_.push_back(std::countr_zero(left));
        double mid_u = 0, mid_v = 0;
        for (int k = 0; k < p.n; ++k) {
            mid_u += p.u[k] / p.n;
            mid_v += p.v[k] / p.n;
        }
        phi_.resize(owners_.size() * (p.n + 1));
        auto phi_at = [&](std::size_t owner, int k) -> double& { return phi_[owner * (p.n + 1) + k]; };
        for (std::size_t o = 0; o < owners_.size(); ++o) {
            for (int k = 0; k < p.n; ++k)
                phi_at(o, k) = phi(owners_[o], p.u[k], p.v[k]);
            phi_at(o, p.n) = phi(owners_[o], mid_u, mid_v);
        }
        for (int k = 0; k < p.n; ++k) {
            const int next = k + 1 < p.n ? k + 1 : 0;
            const double u[3] = {mid_u, p.u[k], p.u[next]}, v[3] = {mid_v, p.v[k], p.v[next]};
            if (!((u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]) > 1e-15))
                continue;
            // Each solid takes the part nearer to it than to any other; at equal distances the first.
            for (std::size_t o = 0; o < owners_.size(); ++o) {
                Polygon mine, low, high;
                for (int c = 0; c < 3; ++c)
                    mine.add(u[c], v[c]);
                for (std::size_t e = 0; e < owners_.size() && mine.n > 0; ++e) {
                    if (e == o)
                        continue;
                    const Affine f = through(
                        u, v,
                        {phi_at(o, p.n) - phi_at(e, p.n), phi_at(o, k) - phi_at(e, k), phi_at(o, next) - phi_at(e, next)});
                    split(
                        mine, [&](int i) { return f(mine.u[i], mine.v[i]); }, tolerance_, e < o, low, high);
                    mine = low;
                }
                add_area(mine, sums_->solid[owners_[o]]);
            }
        }
    }

    Vec<3> corner_;
    std::array<double, 2> edges_;
    double unit_, tolerance_; ///< length in which distances are measured; tolerance in it
    std::array<int, 2> tangents_;
    std::span<const Cutter<3>> cutters_;
    FaceSums<3>* sums_;
    std::vector<std::vector<Affine>> planes_;
    std::vector<std::array<double, (nodes + 1) * (nodes + 1)>> values_;
    std::vector<Affine> linear_;
    SphereSections spheres_; ///< if the curved solids here are spheres and overlap none; else none
    std::vector<Fragment> fragments_, next_;
    std::vector<int> owners_;
    std::vector<double> phi_;
};

} // namespace

void clip_face(const Vec<3>& corner, const std::array<double, 2>& edges, const std::array<int, 2>& tangents,
               std::span<const Cutter<3>> cutters, double tolerance, FaceSums<3>& sums)
{
    static thread_local SquareClipper clipper;
    sums.reset(cutters.size());
    clipper.clip(corner, edges, tangents, cutters, tolerance, sums);
}

} // namespace gapflow
