// A disc in a polygon against quadrature, over polygons that share a square, and in the places where cases meet.
#include "gapflow/grid/clip_disc.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace gapflow::testing {
namespace {

using Point = Eigen::Vector2d;
using Polygon = std::vector<Point>;

const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// The same in the unit square by Gauss' rule, v = v_c + r sin t, between all places where a bound of u or v changes.
PartSum<3> by_quadrature(const Disc& disc)
{
    using Real = long double;
    static constexpr std::array<Real, 5> nodes{0.1488743389816312108848260L, 0.4333953941292471907992659L,
                                               0.6794095682990244062343274L, 0.8650633666889845107320967L,
                                               0.9739065285171717200779640L},
        weights{0.2955242247147528701738930L, 0.2692667193099963550912269L, 0.2190863625159820439955349L,
                0.1494513491505805931457763L, 0.0666713443086881375935688L};
    const Real u = disc.centre.x(), v = disc.centre.y(), r = disc.radius, right_angle = std::acos(Real(0));
    std::vector<Real> breaks{-right_angle, right_angle};
    const auto add_break = [&](Real at) {
        if (std::abs((at - v) / r) < 1)
            breaks.push_back(std::asin((at - v) / r));
    };
    for (const Real side : {Real(0), Real(1)}) {
        add_break(side);
        if (const Real h2 = r * r - (side - u) * (side - u); h2 > 0) {
            add_break(v + std::sqrt(h2));
            add_break(v - std::sqrt(h2));
        }
    }
    std::sort(breaks.begin(), breaks.end());
    Real area = 0, first_u = 0, first_v = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        for (int piece = 0; piece < 8; ++piece) {
            const Real step = (breaks[i + 1] - breaks[i]) / 8, middle = breaks[i] + (piece + 0.5L) * step;
            for (int k = 0; k < 10; ++k) {
                const Real t = middle + (k % 2 ? -0.5L : 0.5L) * step * nodes[k / 2], at = v + r * std::sin(t),
                           half = r * std::cos(t), low = std::max(Real(0), u - half), high = std::min(Real(1), u + half);
                if (at < 0 || at > 1 || high <= low)
                    continue;
                const Real weight = weights[k / 2] * 0.5L * step * half;
                area += weight * (high - low);
                first_u += weight * (high * high - low * low) / 2;
                first_v += weight * at * (high - low);
            }
        }
    return {double(area), {double(first_u), double(first_v)}};
}

TEST(ClipDisc, IsTheIntegral)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(0, 1);
    for (int k = 0; k < 2000; ++k) {
        const double radius = std::pow(10.0, k % 5 - 1) * (0.3 + number(random)), angle = 2 * M_PI * number(random);
        const Point on_circle(1.4 * number(random) - 0.2, 1.4 * number(random) - 0.2);
        const Disc disc{on_circle - radius * Point(std::cos(angle), std::sin(angle)), radius};
        const PartSum<3> part = area_inside(disc, square), exact = by_quadrature(disc);
        const double round_off = 4e-16 * std::max(1.0, radius);
        ASSERT_NEAR(part.measure, exact.measure, round_off) << "radius " << radius << " at " << disc.centre.transpose();
        ASSERT_LE((part.moment - exact.moment).norm(), 8 * round_off)
            << "radius " << radius << " at " << disc.centre.transpose();
    }
}

TEST(ClipDisc, PartsOfPolygonsAddUp)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> number(0, 1);
    for (int k = 0; k < 5000; ++k) {
        const Disc disc{{2 * number(random) - 0.5, 2 * number(random) - 0.5}, 0.02 + 3 * number(random) * number(random)};
        const double angle = 2 * M_PI * number(random), offset = number(random) - 0.5;
        const Point normal(std::cos(angle), std::sin(angle)), middle(0.5, 0.5);
        Polygon low, high;
        for (int i = 0; i < 4; ++i) {
            const Point &p = square[i], &q = square[(i + 1) % 4];
            const double f = normal.dot(p - middle) - offset, g = normal.dot(q - middle) - offset;
            (f <= 0 ? low : high).push_back(p);
            if ((f <= 0) != (g <= 0))
                for (Polygon* part : {&low, &high})
                    part->push_back(p + f / (f - g) * (q - p));
        }
        const PartSum<3> all = area_inside(disc, square), a = area_inside(disc, low), b = area_inside(disc, high);
        ASSERT_NEAR(all.measure, a.measure + b.measure, 2e-15);
        ASSERT_LE((all.moment - a.moment - b.moment).norm(), 2e-15);
    }
}

// Circles through corners, that touch sides, with centres on sides and corners: as with the disc moved by 1e-9.
TEST(ClipDisc, IsContinuousWhereCasesMeet)
{
    for (const double radius : {0.5, 1.0, std::sqrt(2.0), std::sqrt(0.5)})
        for (const Point& centre : {Point(0, 0), Point(0.5, 0.5), Point(1, 0), Point(0.5, 0), Point(-0.5, 0.5), Point(1.5, 0.5),
                                    Point(0, 1 + radius), Point(-radius, 0.3), Point(radius, 0.5)}) {
            const PartSum<3> part = area_inside({centre, radius}, square);
            for (const Point& by : {Point(1e-9, -1e-9), Point(-1e-9, 1e-9), Point(0, 1e-9)}) {
                const PartSum<3> moved = area_inside({centre + by, radius}, square);
                EXPECT_NEAR(part.measure, moved.measure, 1e-8) << "radius " << radius << " at " << centre.transpose();
                EXPECT_LE((part.moment - moved.moment).norm(), 1e-8) << "radius " << radius << " at " << centre.transpose();
            }
        }
    EXPECT_NEAR(area_inside({{0.5, 0.5}, 0.5}, square).measure, M_PI / 4, 1e-15);
    EXPECT_NEAR(area_inside({{0, 0}, 1}, square).measure, M_PI / 4, 1e-15);
    EXPECT_EQ(area_inside({{2, 2}, 0.75}, square).measure, 0);
    EXPECT_EQ(area_inside({{0.4, 0.5}, 3}, square).measure, 1);
}

} // namespace
} // namespace gapflow::testing
