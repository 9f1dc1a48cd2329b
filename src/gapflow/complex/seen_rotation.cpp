#include "gapflow/complex/seen_rotation.hpp"

#include "gapflow/complex/dual.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <vector>

namespace gapflow {
namespace {

template <int D, class S>
using PlaceOf = Eigen::Matrix<S, D, 1>;

/// The last plane not above x, or where `below` the last one below it.
double plane_under(double x, bool below)
{
    return below ? std::ceil(x) - 1 : std::floor(x);
}

double cosine_of(double x)
{
    return std::cos(x);
}
double sine_of(double x)
{
    return std::sin(x);
}
double angle_of(double cosine)
{
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}
template <int N>
Dual<N> cosine_of(const Dual<N>& x)
{
    return x.scaled(std::cos(x.value), -std::sin(x.value));
}
template <int N>
Dual<N> sine_of(const Dual<N>& x)
{
    return x.scaled(std::sin(x.value), std::cos(x.value));
}
template <int N>
Dual<N> angle_of(const Dual<N>& cosine)
{
    const double sine = std::sqrt(std::max(1 - cosine.value * cosine.value, 0.0));
    return cosine.scaled(angle_of(cosine.value), sine > 0 ? -1 / sine : 0.0);
}

/// The sum of a surface's pieces. Numbers S: with or without their derivatives by the solid's twist.
template <int D, class S>
class TurningSurface {
public:
    using Place = PlaceOf<D, S>;
    using Square = Eigen::Matrix<S, spin_size<D>, spin_size<D>>;

    TurningSurface(const PlacedSolid<D>& solid, const Vec<D>& c, const Window<D>* window,
                   const Eigen::Matrix<double, D, twist_size<D>>& by_twist)
        : reference_(solid.reference), window_(window && !window->holds(solid) ? window : nullptr), c_(moving(c))
    {
        if constexpr (!std::is_same_v<S, double>)
            for (int axis = 0; axis < D; ++axis)
                for (int k = 0; k < twist_size<D>; ++k)
                    c_[axis].rate[k] += by_twist(axis, k);
        sum_.setConstant(S(0.0));
        std::visit([&](const auto& kind) { add(kind); }, solid.kind);
    }
    const Square& sum() const { return sum_; }

private:
    /// A point that moves with the solid.
    Place moving(const Vec<D>& x) const
    {
        Place place = turning(x - reference_);
        for (int axis = 0; axis < D; ++axis) {
            S shift(reference_[axis]);
            if constexpr (!std::is_same_v<S, double>)
                shift.rate[axis] = 1;
            place[axis] += shift;
        }
        return place;
    }
    /// A way that turns with the solid.
    static Place turning(const Vec<D>& way)
    {
        Place place;
        for (int axis = 0; axis < D; ++axis)
            place[axis] = S(way[axis]);
        if constexpr (!std::is_same_v<S, double>)
            for (int k = 0; k < spin_size<D>; ++k) {
                Spin<D> turn = Spin<D>::Zero();
                turn[k] = 1;
                const Vec<D> speed = spin_velocity<D>(turn, way);
                for (int axis = 0; axis < D; ++axis)
                    place[axis].rate[D + k] = speed[axis];
            }
        return place;
    }

    void add(const BallKind<D>&) {} // it moves nothing

    void add(const PlanesKind<D>& kind)
    {
        if (!(kind.reach > 0))
            return;
        const auto corner = [&](std::array<int, D> end) {
            Vec<D> x = kind.centre;
            for (int k = 0; k < D; ++k)
                x += kind.offset[2 * k + end[k]] * kind.normal[2 * k + end[k]];
            return moving(x);
        };
        for (int k = 0; k < D; ++k)
            for (int end = 0; end < 2; ++end) {
                const Vec<D>& normal = kind.normal[2 * k + end];
                std::array<int, D> at;
                at[k] = end;
                if constexpr (D == 2) {
                    at[1 - k] = 0;
                    const Place a = corner(at);
                    at[1 - k] = 1;
                    add_segment(a, corner(at), normal, true);
                } else {
                    std::vector<Place> facet;
                    for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                        at[(k + 1) % 3] = u;
                        at[(k + 2) % 3] = v;
                        facet.push_back(corner(at));
                    }
                    add_facet(facet, normal, true);
                }
            }
    }

    void add(const FacetKind<D>& kind)
    {
        const bool out = enclosed(kind) >= 0;
        for (const auto& element : kind.surface->elements) {
            std::vector<Place> facet;
            for (const int i : element)
                facet.push_back(moving(kind.vertices[i]));
            Vec<D> normal;
            if constexpr (D == 2) { // solid at the left
                const Vec<2> way = kind.vertices[element[1]] - kind.vertices[element[0]];
                normal << way[1], -way[0];
            } else
                normal = (kind.vertices[element[1]] - kind.vertices[element[0]])
                             .cross(kind.vertices[element[2]] - kind.vertices[element[0]]);
            if (!out)
                normal = -normal;
            if constexpr (D == 2)
                add_segment(facet[0], facet[1], normal, false);
            else
                add_facet(facet, normal, false);
        }
    }

    /// Area or volume of what the facets enclose, but for a factor.
    static double enclosed(const FacetKind<D>& kind)
    {
        double sum = 0;
        const Vec<D>& origin = kind.vertices.front();
        for (const auto& element : kind.surface->elements) {
            Eigen::Matrix<double, D, D> ways;
            for (int k = 0; k < D; ++k)
                ways.col(k) = kind.vertices[element[k]] - origin;
            sum += ways.determinant();
        }
        return sum;
    }

    void add(const RoundKind<D>& kind)
    {
        if constexpr (D == 2) {
            const Vec<2> across(-kind.axis[1], kind.axis[0]), along = kind.half * kind.axis, away = kind.radius * across;
            for (const double side : {-1.0, 1.0})
                add_segment(moving(kind.centre - along + side * away), moving(kind.centre + along + side * away), side * across,
                            true);
            for (const double end : {-1.0, 1.0})
                if (kind.flat)
                    add_segment(moving(kind.centre + end * along - away), moving(kind.centre + end * along + away),
                                end * kind.axis, true);
                else
                    add_half_circle(moving(kind.centre + end * along), end * kind.axis, kind.radius);
        }
    }

    /// `normal`: out of the solid, of any length. `closed`: a plane in which the segment lies counts as within the solid.
    void add_segment(const Place& from, const Place& to, const Vec<D>& normal, bool closed)
    {
        using std::sqrt;
        Place a = from, b = to;
        if (!cut(a, b))
            return;
        const Place way = b - a;
        const S square = way.squaredNorm();
        if (!(value_of(square) > 0))
            return;
        const S length = sqrt(square);
        const double side = normal[0] * value_of(way[1]) - normal[1] * value_of(way[0]) >= 0 ? 1 : -1;
        for (int d = 0; d < 2; ++d) {
            const S n = (d == 0 ? way[1] : -way[0]) * side; // times the length
            const S slope = way[1 - d] / length;            // of the velocity along the plane
            const bool below = !(closed && value_of(n) > 0);
            for_each_slab(value_of(a[d]), value_of(b[d]), below, [&](double plane, bool from_a, bool to_b) {
                // Between the planes, along the way from a.
                const auto at = [&](double p) { return (p - a[d]) / way[d]; };
                const bool up = value_of(way[d]) > 0;
                const S from = from_a ? S(0.0) : at(up ? plane : plane + 1), to = to_b ? S(1.0) : at(up ? plane + 1 : plane);
                for (int g = 0; g < 3; ++g) {
                    const S t = from + gauss_node[g] * (to - from);
                    const Place x = a + t * way;
                    const S lever = (x - c_).dot(way) / length;
                    sum_(0, 0) -=
                        gauss_weight[g] * (to - from) * n * (x[d] - (plane + 0.5)) * (lever * lever - slope * slope / 12);
                }
            });
        }
    }

    /// To what lies in the window; false: nothing.
    bool cut(Place& a, Place& b) const
    {
        for (int d = 0; d < D && window_; ++d)
            for (int end = 0; end < 2 && window_->bounded(d); ++end) {
                const double side = window_->side(d, end), sign = end ? -1 : 1;
                const S over_a = sign * (a[d] - side), over_b = sign * (b[d] - side);
                if (value_of(over_a) <= 0 && value_of(over_b) <= 0)
                    return false;
                if (value_of(over_a) >= 0 && value_of(over_b) >= 0)
                    continue;
                const S share = over_a / (over_a - over_b);
                const Place at = a + share * (b - a);
                (value_of(over_a) < 0 ? a : b) = at;
                (value_of(over_a) < 0 ? a : b)[d] = S(side);
            }
        return true;
    }

    /// Calls f(plane below, whether the slab begins at a, whether it ends at b) for the slabs between planes through which one goes from a to b.
    template <class F>
    static void for_each_slab(double a, double b, bool below, F&& f)
    {
        if (a == b) {
            f(plane_under(a, below), true, true);
            return;
        }
        const bool up = b > a;
        const double low = std::min(a, b), high = std::max(a, b), first = std::floor(low), last = std::ceil(high) - 1;
        for (double plane = first; plane <= last; ++plane) {
            const bool starts = plane == first, ends = plane == last;
            f(plane, up ? starts : ends, up ? ends : starts);
        }
    }

    /// Where `out` points from the centre.
    void add_half_circle(const Place& centre, const Vec<2>& out, double radius)
    {
        const Place lever = centre - c_, axis = turning(out);
        Place across;
        across << -axis[1], axis[0];
        const auto turned_from = [&](int d) {
            const S angle = angle_of(axis[d]);
            return value_of(across[d]) < 0 ? -angle : angle;
        };
        for (int d = 0; d < 2; ++d) {
            // x_d = centre_d + radius cos(phi - turned), phi from the axis: monotonous between ends and the extremes.
            const S turned = turned_from(d);
            std::vector<S> stops{S(-0.5 * std::numbers::pi), S(0.5 * std::numbers::pi)};
            const auto offer = [&](const S& phi) {
                for (const double round : {-2 * std::numbers::pi, 0.0, 2 * std::numbers::pi})
                    if (std::abs(value_of(phi) + round) < 0.5 * std::numbers::pi)
                        stops.push_back(phi + round);
            };
            offer(turned);
            offer(turned + std::numbers::pi);
            const auto offer_line = [&](int e, double place) {
                const S cosine = (place - centre[e]) / radius;
                if (std::abs(value_of(cosine)) < 1)
                    for (const double sign : {-1.0, 1.0})
                        offer(turned_from(e) + sign * angle_of(cosine));
            };
            for (double plane = std::ceil(value_of(centre[d]) - radius); plane <= value_of(centre[d]) + radius; ++plane)
                offer_line(d, plane);
            for (int e = 0; e < 2 && window_; ++e)
                for (int end = 0; end < 2 && window_->bounded(e); ++end)
                    offer_line(e, window_->side(e, end));
            std::sort(stops.begin(), stops.end(), [](const S& x, const S& y) { return value_of(x) < value_of(y); });
            for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
                const S &from = stops[k], length = stops[k + 1] - from;
                const double middle = value_of(from) + 0.5 * value_of(length),
                             plane = std::floor(value_of(centre[d]) + radius * std::cos(middle - value_of(turned)));
                if (window_ &&
                    !window_->holds(Vec<2>(values_of<2>(centre) + radius * (std::cos(middle) * values_of<2>(axis) +
                                                                            std::sin(middle) * values_of<2>(across)))))
                    continue;
                const int pieces = 1 + static_cast<int>(value_of(length) / 0.4);
                for (int piece = 0; piece < pieces; ++piece)
                    for (int g = 0; g < 3; ++g) {
                        const S phi = from + (piece + gauss_node[g]) / pieces * length;
                        const Place n = cosine_of(phi) * axis + sine_of(phi) * across;
                        const S speed = n[1] * lever[0] - n[0] * lever[1], x = centre[d] + radius * n[d];
                        sum_(0, 0) -= gauss_weight[g] / pieces * radius * length * n[d] * (x - (plane + 0.5)) * speed * speed;
                    }
            }
        }
    }

    void add_facet(std::vector<Place> facet, const Vec<D>& normal, bool closed)
    {
        using std::sqrt;
        Place area = (facet[1] - facet[0]).cross(facet[2] - facet[0]);
        const S square = area.squaredNorm();
        if (!(value_of(square) > 0))
            return;
        const S length = sqrt(square);
        Place n = area / length;
        if (values_of<D>(n).dot(normal) < 0)
            n = -n;
        for (int d = 0; d < 3 && window_; ++d)
            for (int end = 0; end < 2 && window_->bounded(d); ++end)
                facet = half_of(facet, d, window_->side(d, end), end ? -1 : 1);
        if (facet.size() < 3)
            return;
        for (int d = 0; d < 3; ++d) {
            if (value_of(n[d]) == 0)
                continue;
            double low = value_of(facet[0][d]), high = low;
            for (const Place& x : facet) {
                low = std::min(low, value_of(x[d]));
                high = std::max(high, value_of(x[d]));
            }
            const double first = low == high ? plane_under(low, !(closed && value_of(n[d]) > 0)) : std::floor(low),
                         last = low == high ? first : std::ceil(high) - 1;
            for (double plane = first; plane <= last; ++plane)
                if (first == last)
                    add_polygon(facet, n, d, plane);
                else
                    add_polygon(half_of(half_of(facet, d, plane, 1), d, plane + 1, -1), n, d, plane);
        }
    }

    /// What of a polygon lies above a plane; side -1: below it.
    static std::vector<Place> half_of(const std::vector<Place>& polygon, int d, double plane, int side)
    {
        std::vector<Place> half;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Place &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
            const S over_a = side * (a[d] - plane), over_b = side * (b[d] - plane);
            if (value_of(over_a) >= 0)
                half.push_back(a);
            if ((value_of(over_a) >= 0) != (value_of(over_b) >= 0)) {
                const S share = over_a / (over_a - over_b);
                half.push_back(a + share * (b - a));
            }
        }
        return half;
    }

    /// By a rule of degree three for triangles.
    void add_polygon(const std::vector<Place>& polygon, const Place& n, int d, double plane)
    {
        Square variance; // of the velocity within a face of the plane
        variance.setConstant(S(0.0));
        for (const int t : {(d + 1) % 3, (d + 2) % 3}) {
            Place slope = Place::Constant(S(0.0));
            slope[(t + 1) % 3] = -n[(t + 2) % 3];
            slope[(t + 2) % 3] = n[(t + 1) % 3];
            variance += slope * slope.transpose() / S(12.0);
        }
        for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
            const Place &a = polygon[0], &b = polygon[k], &c = polygon[k + 1];
            const S area = 0.5 * (b - a).cross(c - a).dot(n);
            const S size = value_of(area) < 0 ? -area : area;
            const auto offer = [&](const Place& x, double weight) {
                const Place lever = (x - c_).cross(n);
                sum_ -= (weight * size * n[d] * (x[d] - (plane + 0.5))) * (lever * lever.transpose() - variance);
            };
            for (const Place& x : {a, b, c})
                offer(x, 1.0 / 20);
            for (const Place& x : {Place(0.5 * (a + b)), Place(0.5 * (b + c)), Place(0.5 * (c + a))})
                offer(x, 2.0 / 15);
            offer((a + b + c) / S(3.0), 9.0 / 20);
        }
    }

    static constexpr std::array<double, 3> gauss_node{0.11270166537925831, 0.5, 0.88729833462074169},
        gauss_weight{5.0 / 18, 8.0 / 18, 5.0 / 18};

    const Vec<D> reference_;
    const Window<D>* const window_; ///< null: it holds the solid
    Place c_;
    Square sum_;
};

} // namespace

template <int D>
SpinMatrix<D> seen_rotation(const PlacedSolid<D>& solid, const Vec<D>& c, const Window<D>* window)
{
    return TurningSurface<D, double>(solid, c, window, Eigen::Matrix<double, D, twist_size<D>>::Zero()).sum();
}

template <int D>
std::array<SpinMatrix<D>, twist_size<D>> seen_rotation_rate(const PlacedSolid<D>& solid, const Vec<D>& c,
                                                            const Window<D>* window,
                                                            const Eigen::Matrix<double, D, twist_size<D>>& by_twist)
{
    const auto sum = TurningSurface<D, Dual<twist_size<D>>>(solid, c, window, by_twist).sum();
    std::array<SpinMatrix<D>, twist_size<D>> rates;
    for (int k = 0; k < twist_size<D>; ++k)
        for (int i = 0; i < spin_size<D>; ++i)
            for (int j = 0; j < spin_size<D>; ++j)
                rates[k](i, j) = sum(i, j).rate[k];
    return rates;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template SpinMatrix<D> seen_rotation(const PlacedSolid<D>&, const Vec<D>&, const Window<D>*);                              \
    template std::array<SpinMatrix<D>, twist_size<D>> seen_rotation_rate(                                                      \
        const PlacedSolid<D>&, const Vec<D>&, const Window<D>*, const Eigen::Matrix<double, D, twist_size<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
