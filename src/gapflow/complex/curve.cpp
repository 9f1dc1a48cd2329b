#include "gapflow/complex/curve.hpp"

#include <cmath>
#include <numbers>

namespace gapflow {

double ellipse_angle(const Curve& curve, const Vec<2>& A, const Vec<2>& B)
{
    const Vec<2> a = curve.scaled(A), b = curve.scaled(B), chord = curve.axes(Vec<2>(B - A));
    const double cross = a[0] * chord[1] - a[1] * chord[0], quarter = 0.25 * chord.squaredNorm();
    if (quarter < 0.02 && cross <= 0)
        return 2 * std::asin(std::sqrt(quarter));
    const double angle = -std::atan2(cross, a.dot(b));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

Bulge ellipse_bulge(const Curve& curve, const Vec<2>& A, const Vec<2>& B)
{
    const Vec<2> a = curve.scaled(A), b = curve.scaled(B), chord = curve.axes(Vec<2>(B - A));
    const double length2 = chord.squaredNorm(), quarter = 0.25 * length2; // sin^2 of half the angle
    if (length2 == 0)
        return {};
    const double cross = a[0] * chord[1] - a[1] * chord[0], dot = a.dot(b); // a x b
    double segment;                                                         // area over semi1 semi2, (angle - sin(angle)) / 2
    if (quarter < 0.02 && cross <= 0) // by series: for small angles the difference loses its digits
        segment =
            quarter * std::sqrt(quarter) *
            (2. / 3 +
             quarter *
                 (1. / 5 +
                  quarter * (3. / 28 +
                             quarter * (5. / 72 +
                                        quarter * (35. / 704 + quarter * (63. / 1664 +
                                                                          quarter * (77. / 2560 + quarter * 429. / 17408)))))));
    else {
        double angle = -std::atan2(cross, dot); // clockwise
        if (angle < 0)
            angle += 2 * std::numbers::pi;
        segment = 0.5 * (angle - std::sin(angle));
    }
    // Moment about the centre: 2/3 sin^3 of half the angle, along the chord's normal to the left.
    const double third = length2 / 12;
    const Vec<2> towards(-chord[1] * third, chord[0] * third), e2(-curve.e1[1], curve.e1[0]);
    const double scale = curve.semi1 * curve.semi2;
    const Vec<2> moment =
        scale * (segment * curve.centre + towards[0] * curve.semi1 * curve.e1 + towards[1] * curve.semi2 * e2);
    return {-scale * segment, -moment};
}

Bulge whole_ellipse(const Curve& curve)
{
    const double area = std::numbers::pi * curve.semi1 * curve.semi2;
    return {-area, -area * curve.centre};
}

ArcIntegrals arc_integrals(const Vec<2>& A, const Vec<2>& B, const Bulge& bulge, const Vec<2>& reference, double h)
{
    const Vec<2> a = A - reference, b = B - reference, d = B - A, moment = bulge.moment - bulge.area * reference;
    const double square = (a.squaredNorm() + a.dot(b) + b.squaredNorm()) / 3 + h * h;
    return {{-0.5 * h * d[1], 0.5 * h * d[0], 0.5 * (a[0] * b[1] - a[1] * b[0]) + bulge.area},
            {-0.5 * square * d[0] + moment[1], -0.5 * square * d[1] - moment[0], 0}};
}

} // namespace gapflow
