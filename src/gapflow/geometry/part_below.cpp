// With m the plane's normal and h = m . x - offset, negative below it, the divergence theorem turns integrals over the part V below into such over
// the solid's own surface below the plane, because these fields are 0 on the plane:
//
//     |V| = int h m.dA,      int_V x dV = int (h x - h^2/2 m) m.dA.
//
// With p = x - h m, the point of the plane above x, and fields that are constant along m, the section S with the plane is
//
//     int_S (1, p, p p^T) dA = -int (1, p, p p^T) m.dA.
//
// Facets are clipped; a quadratic is integrated exactly. Round pieces are cut in circles, and what of a circle is below is an arc. The variable across
// the circles is an angle in which arcs begin and end smoothly, so that Gauss's rule converges to round-off.
#include "gapflow/geometry/part_below.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace gapflow {
namespace {

using std::numbers::pi;

/// Gauss's rule with N points on -1 ... 1.
template <int N>
struct Gauss {
    std::array<double, N> x, weight;

    Gauss()
    {
        for (int i = 0; i < N; ++i) {
            double z = std::cos(pi * (i + 0.75) / (N + 0.5)), slope = 1;
            for (int pass = 0; pass < 8; ++pass) { // Newton's method from Tricomi's estimate: doubles the digits in each
                double last = 0, value = 1;
                for (int k = 1; k <= N; ++k) {
                    const double next = ((2 * k - 1) * z * value - (k - 1) * last) / k;
                    last = value;
                    value = next;
                }
                slope = N * (z * value - last) / (z * z - 1);
                z -= value / slope;
            }
            x[i] = z;
            weight[i] = 2 / ((1 - z * z) * slope * slope);
        }
    }
};

/// Calls f(x, weight) at the points of a rule on a ... b.
template <class F>
void each_point(double a, double b, F&& f)
{
    static const Gauss<24> rule;
    const double half = 0.5 * (b - a);
    for (std::size_t i = 0; i < rule.x.size() && half > 0; ++i)
        f(a + half * (1 + rule.x[i]), half * rule.weight[i]);
}

double arc_cosine(double c)
{
    return std::acos(std::clamp(c, -1.0, 1.0));
}

template <int D>
class SurfaceBelow {
public:
    explicit SurfaceBelow(const Plane<D>& plane) : plane_(plane) {}

    const PartBelow<D>& part() const { return part_; }
    const Vec<D>& up() const { return plane_.normal; }
    double height(const Vec<D>& x) const { return up().dot(x) - plane_.offset; }

    /// An element of the surface at x, a point below: `along` is m . dA.
    void add(const Vec<D>& x, double along)
    {
        const double h = height(x);
        const Vec<D> above = x - h * up();
        part_.volume += along * h;
        part_.moment += along * h * (x - 0.5 * h * up());
        part_.section -= along;
        part_.section_moment -= along * above;
        part_.section_square -= along * above * above.transpose();
    }

private:
    Plane<D> plane_;
    PartBelow<D> part_;
};

void add_facet(SurfaceBelow<2>& sum, std::array<Vec<2>, 2> ends)
{
    const std::array<double, 2> h{sum.height(ends[0]), sum.height(ends[1])};
    if (h[0] > 0 && h[1] > 0)
        return;
    for (int k = 0; k < 2; ++k)
        if (h[k] > 0)
            ends[k] += h[k] / (h[k] - h[1 - k]) * (ends[1 - k] - ends[k]);
    const Vec<2> way = ends[1] - ends[0];
    const double along = sum.up().dot(Vec<2>(way[1], -way[0]));
    sum.add(ends[0], along / 6);
    sum.add(0.5 * (ends[0] + ends[1]), along * 4 / 6);
    sum.add(ends[1], along / 6);
}

void add_facet(SurfaceBelow<3>& sum, const std::array<Vec<3>, 3>& corners)
{
    std::array<Vec<3>, 4> kept;
    int n = 0;
    for (int k = 0; k < 3; ++k) {
        const Vec<3>&a = corners[k], &b = corners[(k + 1) % 3];
        const double above_a = sum.height(a), above_b = sum.height(b);
        if (above_a <= 0)
            kept[n++] = a;
        if ((above_a <= 0) != (above_b <= 0))
            kept[n++] = a + above_a / (above_a - above_b) * (b - a);
    }
    for (int k = 1; k + 1 < n; ++k) {
        const Vec<3>&a = kept[0], &b = kept[k], &c = kept[k + 1];
        const double along = sum.up().dot((b - a).cross(c - a)) / 6;
        sum.add(0.5 * (a + b), along);
        sum.add(0.5 * (b + c), along);
        sum.add(0.5 * (c + a), along);
    }
}

template <int D>
void add_facets(SurfaceBelow<D>& sum, const SurfaceMesh<D>& mesh)
{
    for (const std::array<int, D>& element : mesh.elements) {
        std::array<Vec<D>, D> corners;
        for (int k = 0; k < D; ++k)
            corners[k] = mesh.vertices[element[k]];
        add_facet(sum, corners);
    }
}

/// The arc from the angle `from` to `to`, less than a turn away, of a circle.
void add_arc(SurfaceBelow<2>& sum, const Vec<2>& centre, double radius, double from, double to)
{
    const double up = std::atan2(sum.up()[1], sum.up()[0]), out = arc_cosine(-sum.height(centre) / radius);
    for (int turn = -2; turn <= 2; ++turn) {
        const double first = up + out + 2 * pi * turn, last = up - out + 2 * pi * (turn + 1);
        each_point(std::max(from, first), std::min(to, last), [&](double angle, double weight) {
            const Vec<2> n(std::cos(angle), std::sin(angle));
            sum.add(centre + radius * n, weight * radius * sum.up().dot(n));
        });
    }
}

Vec<3> across(const Vec<3>& v)
{
    return v.unitOrthogonal();
}

/// A sphere, or its half on the side of `axis`, in level circles at t above the centre.
void add_sphere(SurfaceBelow<3>& sum, const Vec<3>& centre, double radius, const Vec<3>* axis)
{
    const Vec<3>& m = sum.up();
    const double top = std::min(radius, -sum.height(centre)); // below the plane
    const double rising = axis ? axis->dot(m) : 1.0;
    const Vec<3> level = axis ? Vec<3>(*axis - rising * m) : Vec<3>(Vec<3>::Zero());
    const double sideways = level.norm();
    const Vec<3> e1 = sideways > 0 ? Vec<3>(level / sideways) : across(m), e2 = m.cross(e1);
    const auto add_circle = [&](double t, double weight, double half_arc) {
        const double around = std::sqrt(std::max(0.0, (radius - t) * (radius + t)));
        each_point(-half_arc, half_arc, [&](double angle, double share) {
            sum.add(centre + t * m + around * (std::cos(angle) * e1 + std::sin(angle) * e2), weight * share * t);
        });
    };
    const double border = radius * sideways; // between whole circles and those that the half-space cuts
    const double from = rising > 0 ? (axis ? border : -radius) : -radius, to = rising > 0 ? radius : -border;
    each_point(from, std::min(to, top), [&](double t, double weight) { add_circle(t, weight, pi); });
    if (border == 0)
        return;
    // Of an axis that is nearly level the arcs change from nothing to half a circle within an angle of `rising`, at circles of that size.
    std::vector<double> ends{0, pi};
    for (double near = std::max(std::abs(rising), 1e-4); near < 1; near *= 6) {
        ends.push_back(near);
        ends.push_back(pi - near);
    }
    std::sort(ends.begin(), ends.end());
    const double last = arc_cosine(-top / border);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
        each_point(ends[k], std::min(ends[k + 1], last), [&](double angle, double weight) {
            add_circle(-border * std::cos(angle), weight * border * std::sin(angle),
                       std::atan2(std::sin(angle), rising * std::cos(angle)));
        });
}

/// Circles about the x axis. Below the plane is what lies at angles from arc_cosine(share(s)) on, both ways from the direction up.
struct AlongAxis {
    AlongAxis(const SurfaceBelow<3>& sum, double r) : radius(r), rising(sum.up()[0]), level(sum.height(Vec<3>::Zero()))
    {
        const Vec<3> upwards = sum.up() - rising * a;
        sideways = upwards.norm();
        u = sideways > 0 ? Vec<3>(upwards / sideways) : across(a);
        v = a.cross(u);
    }
    double share(double s) const
    {
        const double below = -(level + s * rising);
        return sideways > 0 ? below / (radius * sideways) : std::copysign(std::numeric_limits<double>::infinity(), below);
    }
    Vec<3> point(double s, double y, double w) const { return s * a + y * u + w * v; }

    double radius, rising, level;
    double sideways = 0;
    Vec<3> a = unit<3>(0), u, v;
};

/// The side from s = -half to half. Where circles are cut, the variable is the angle at which they are: it is linear in s in the limit of a level axis.
void add_side(SurfaceBelow<3>& sum, const AlongAxis& axis, double half)
{
    if (axis.sideways == 0)
        return;
    const auto add_circle = [&](double s, double weight) {
        const double first = arc_cosine(axis.share(s));
        each_point(first, 2 * pi - first, [&](double angle, double share) {
            sum.add(axis.point(s, axis.radius * std::cos(angle), axis.radius * std::sin(angle)),
                    weight * share * axis.radius * axis.sideways * std::cos(angle));
        });
    };
    std::array<double, 4> ends{-half, half, -half, -half};
    for (int k = 0; k < 2 && axis.rising != 0; ++k) // where the plane touches the cylinder
        ends[2 + k] = std::clamp(-(axis.level + (k ? -1 : 1) * axis.radius * axis.sideways) / axis.rising, -half, half);
    std::sort(ends.begin(), ends.end());
    for (int k = 0; k < 3; ++k) {
        const double from = ends[k], way = ends[k + 1] - from, middle = axis.share(from + 0.5 * way);
        if (!(way > 0) || middle <= -1)
            continue;
        if (middle >= 1) {
            each_point(from, from + way, add_circle);
            continue;
        }
        const double first = arc_cosine(axis.share(from)), turn = arc_cosine(axis.share(from + way)) - first;
        const auto part_of_way = [&](double t) { return std::sin(first + 0.5 * turn * t) * std::sin(0.5 * turn * t); };
        const double whole = part_of_way(1);
        const auto speed = [&](double t) { return whole != 0 ? 0.5 * turn * std::sin(first + turn * t) / whole : 1.0; };
        each_point(0, 1, [&](double t, double weight) {
            add_circle(from + way * (whole != 0 ? part_of_way(t) / whole : t), weight * way * speed(t));
        });
    }
}

/// The flat end at s = end * half.
void add_end(SurfaceBelow<3>& sum, const AlongAxis& axis, double half, int end)
{
    const double s = end * half, r = axis.radius;
    each_point(arc_cosine(axis.share(s)), pi, [&](double angle, double weight) {
        const double width = r * std::sin(angle);
        each_point(-1, 1, [&](double place, double share) {
            sum.add(axis.point(s, r * std::cos(angle), width * place), weight * share * width * width * end * axis.rising);
        });
    });
}

PartBelow<2> of_round(const Core<2>& core, bool flat_ends, SurfaceBelow<2> sum)
{
    (void)flat_ends;
    const double r = core.radius, half = core.to[0];
    if (half == 0) {
        add_arc(sum, core.to, r, 0, 2 * pi);
        return sum.part();
    }
    add_arc(sum, core.to, r, -0.5 * pi, 0.5 * pi);
    add_arc(sum, core.from, r, 0.5 * pi, 1.5 * pi);
    add_facet(sum, {Vec<2>(half, r), Vec<2>(-half, r)});
    add_facet(sum, {Vec<2>(-half, -r), Vec<2>(half, -r)});
    return sum.part();
}

PartBelow<3> of_round(const Core<3>& core, bool flat_ends, SurfaceBelow<3> sum)
{
    const double half = core.to[0];
    if (half == 0) {
        add_sphere(sum, core.to, core.radius, nullptr);
        return sum.part();
    }
    const AlongAxis axis(sum, core.radius);
    add_side(sum, axis, half);
    for (int end = -1; end <= 1; end += 2)
        if (flat_ends) {
            add_end(sum, axis, half, end);
        } else {
            const Vec<3> outward = end * axis.a;
            add_sphere(sum, half * outward, core.radius, &outward);
        }
    return sum.part();
}

template <int D>
PartBelow<D> scaled(PartBelow<D> part, double factor)
{
    part.volume *= factor;
    part.moment *= factor;
    part.section *= factor;
    part.section_moment *= factor;
    part.section_square *= factor;
    return part;
}

} // namespace

template <int D>
PartBelow<D> part_below(const Shape<D>& shape, const Plane<D>& plane)
{
    const SurfaceBelow<D> none(plane);
    const Bounds<D> bounds = shape.bounds();
    if (const std::optional<double> radius = shape.sphere_radius())
        return scaled(of_round(Core<D>{Vec<D>::Zero(), Vec<D>::Zero(), *radius}, false, none), shape.inside_out() ? -1.0 : 1.0);
    if (const std::vector<Core<D>> cores = shape.cores(); cores.size() == 1)
        return of_round(cores[0], bounds.high[0] < cores[0].to[0] + 0.5 * cores[0].radius, none);
    SurfaceBelow<D> sum(plane);
    const double size = (bounds.high - bounds.low).norm();
    add_facets(sum, shape.display_mesh(1e-4 * size));
    if (!shape.inside_out())
        return sum.part();
    // A round cavity's facets enclose a little less than it.
    SurfaceBelow<D> whole(Plane<D>{unit<D>(0), bounds.high[0] + size});
    add_facets(whole, shape.display_mesh(1e-4 * size));
    return scaled(sum.part(), -shape.mass_properties().volume / whole.part().volume);
}

template PartBelow<2> part_below<2>(const Shape<2>&, const Plane<2>&);
template PartBelow<3> part_below<3>(const Shape<3>&, const Plane<3>&);

} // namespace gapflow
