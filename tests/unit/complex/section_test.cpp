// Sections of convex solids with grid planes: their curves lie on the surface, lines and points agree with them.
#include "gapflow/complex/convex.hpp"
#include "gapflow/complex/square.hpp"

#include <gtest/gtest.h>

#include <random>

namespace gapflow::testing {
namespace {

double distance(const RoundKind<3>& kind, const Vec<3>& x)
{
    const Vec<3> r = x - kind.centre;
    const double s = r.dot(kind.axis);
    if (!kind.flat)
        return (r - std::clamp(s, -kind.half, kind.half) * kind.axis).norm() - kind.radius;
    const double rho = (r - s * kind.axis).norm() - kind.radius, end = std::abs(s) - kind.half;
    return std::max(rho, end);
}

TEST(Section, RoundBarsLieOnTheirSurface)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(0, 1);
    int sections = 0;
    for (int k = 0; k < 4000; ++k) {
        RoundKind<3> kind;
        for (int i = 0; i < 3; ++i) {
            kind.centre[i] = number(random);
            kind.axis[i] = number(random) - 0.5;
        }
        if (k % 5 == 0)
            kind.axis[k % 3] *= 1e-7;
        if (k % 7 == 0)
            kind.axis = Vec<3>::Unit(k % 3) + 1e-9 * kind.axis;
        kind.axis.normalize();
        kind.radius = 0.2 + number(random);
        kind.half = 2 * number(random) * number(random);
        kind.flat = k % 2;
        const int d = k % 3;
        const double at = kind.centre[d] + 2 * (number(random) - 0.5) * (kind.radius + kind.half);
        const Section section = kind.section(d, at);
        const auto in_space = [&](const Vec<2>& x) {
            Vec<3> y;
            y[d] = at;
            y[(d + 1) % 3] = x[0];
            y[(d + 2) % 3] = x[1];
            return y;
        };
        if (section.empty()) { // no point of the plane lies inside
            for (int i = 0; i < 50; ++i) {
                Vec<3> x = in_space({kind.centre[(d + 1) % 3] + 4 * (number(random) - 0.5),
                                     kind.centre[(d + 2) % 3] + 4 * (number(random) - 0.5)});
                EXPECT_GT(distance(kind, x), -1e-6) << k;
            }
            continue;
        }
        ++sections;
        EXPECT_LT(distance(kind, in_space(section.inside)), 1e-9) << k;
        for (int c = 0; c < section.count; ++c) {
            const Curve& curve = section.curve[c];
            if (section.single())
                continue;
            const ArcSegment segment{section.corner[c],
                                     section.corner[(c + 1) % section.count],
                                     curve.kind == Curve::Kind::ellipse ? &curve : nullptr,
                                     0,
                                     false,
                                     false};
            for (const double t : {0.0, 0.3, 0.7, 1.0})
                EXPECT_NEAR(distance(kind, in_space(segment.at(t))), 0, 1e-6)
                    << k << " curve " << c << " of " << section.count << " flat " << kind.flat << " t " << t << " q "
                    << kind.axis[d] << " h " << at - kind.centre[d] << " r " << kind.radius << " half " << kind.half;
        }
    }
    EXPECT_GT(sections, 2000);
}

} // namespace
} // namespace gapflow::testing
