#include "gapflow/viscous/plane_element.hpp"

#include "gapflow/viscous/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

double cross(const Vec<2>& a, const Vec<2>& b)
{
    return a[0] * b[1] - a[1] * b[0];
}

/// Modes of [a b; b d]: (c, -s) and (s, c).
struct TwoModes {
    double c = 1, s = 0;
    std::array<double, 2> value;

    TwoModes(double a, double b, double d) : value{a, d}
    {
        if (b == 0)
            return;
        const double half = (d - a) / (2 * b), t = (half < 0 ? -1 : 1) / (std::abs(half) + std::sqrt(half * half + 1));
        c = 1 / std::sqrt(t * t + 1);
        s = t * c;
        value = {a - t * b, d + t * b};
    }
};

/// Principal axes of a polygon, scaled so that the mean of a^2 and of b^2 is 1: the gradients of a, b, a^2, ab, b^2 are orthogonal.
struct Axes {
    Mat<2> axes;  ///< columns
    Vec<2> scale; ///< a = scale_0 axes_0 . x

    Axes(const std::vector<ElementSide>& sides, double area)
    {
        Mat<2> second = Mat<2>::Zero();
        for (const ElementSide& side : sides) {
            const Vec<2>&a = side.from, &b = side.to, s = a + b;
            second += cross(a, b) / 24 * (a * a.transpose() + b * b.transpose() + s * s.transpose());
        }
        second /= area;
        const TwoModes modes(second(0, 0), second(0, 1), second(1, 1));
        axes << modes.c, modes.s, -modes.s, modes.c;
        for (int k = 0; k < 2; ++k)
            scale[k] = 1 / std::sqrt(std::max(modes.value[k], 1e-20));
    }
    Vec<2> scaled(const Vec<2>& x) const { return scale.cwiseProduct(axes.transpose() * x); }
};

/// int x m over the polygon, of each monomial: its second and third moments.
Eigen::Matrix<double, 2, 6> first_moments(const std::vector<ElementSide>& sides, const Axes& axes)
{
    std::array<double, 3> second{};
    std::array<double, 4> third{};
    for (const ElementSide& side : sides) {
        const Vec<2> p = axes.scaled(side.from), q = axes.scaled(side.to), s = p + q;
        const double twice = cross(side.from, side.to);
        for (int k = 0; k < 3; ++k) {
            const int i = k / 2, j = (k + 1) / 2;
            second[k] += twice / 24 * (p[i] * p[j] + q[i] * q[j] + s[i] * s[j]);
        }
        for (int k = 0; k < 4; ++k) {
            const int i = k / 3, j = k / 2, l = (k + 2) / 3; // 0 0 0, 0 0 1, 0 1 1, 1 1 1
            third[k] += twice / 60 *
                        (3 * p[i] * p[j] * p[l] + p[i] * p[j] * q[l] + p[i] * q[j] * p[l] + q[i] * p[j] * p[l] +
                         p[i] * q[j] * q[l] + q[i] * p[j] * q[l] + q[i] * q[j] * p[l] + 3 * q[i] * q[j] * q[l]);
        }
    }
    Eigen::Matrix<double, 2, 6> scaled;
    scaled << 0, second[0], second[1], third[0], third[1], third[2], //
        0, second[1], second[2], third[1], third[2], third[3];
    return axes.axes * axes.scale.cwiseInverse().asDiagonal() * scaled;
}

/// The modes of its cost are even and odd functions along the side.
PlaneProjection::SideModes modes_of(double length, double delta)
{
    constexpr double root = std::numbers::sqrt2;
    PlaneProjection::SideModes modes{};
    if (!(length > 1e-12))
        return modes;
    // Of [4 2 -1; 2 16 2; -1 2 4] and [7 -8 1; -8 16 -8; 1 -8 7].
    const double mass = length / delta / 30,
                 stiffness = viscous_parameters.side_stiffness * std::min(delta, length) / length / 3;
    const TwoModes even(3 * mass + 8 * stiffness, root * (2 * mass - 8 * stiffness), 16 * mass + 16 * stiffness);
    modes.row = {{{1 / root, 0, -1 / root}, {even.c / root, -even.s, even.c / root}, {even.s / root, even.c, even.s / root}}};
    modes.weight = {5 * mass + 6 * stiffness, std::max(even.value[0], 0.0), std::max(even.value[1], 0.0)};
    return modes;
}

} // namespace

/// Area, centroid; sides about the centroid on return.
double PlaneProjection::centre(Vec<2>& middle)
{
    const Vec<2> about = lines_[0].from;
    double sum = 0;
    Vec<2> first = Vec<2>::Zero();
    for (const ElementSide& side : lines_) {
        const Vec<2> a = side.from - about, b = side.to - about;
        sum += 0.5 * cross(a, b);
        first += cross(a, b) / 6 * (a + b);
    }
    middle = sum > 0 ? Vec<2>(about + first / sum) : about;
    for (ElementSide& side : lines_) {
        side.from -= middle;
        side.to -= middle;
    }
    return sum;
}

void PlaneProjection::find(const std::vector<ElementSide>& all)
{
    lines_ = all;
    area = centre(centroid);
    project.clear();
    if (!(area > viscous_parameters.least_volume))
        return;
    const Axes axes(lines_, area);
    const double a = axes.scale[0] * axes.scale[0] * area, b = axes.scale[1] * axes.scale[1] * area;
    energy = {0, a, b, 4 * a, a + b, 4 * b};
    const std::size_t m = lines_.size();
    project.resize(3 * m + 1);
    at.resize(3 * m);
    double perimeter = 0;
    for (std::size_t k = 0; k < m; ++k) {
        const Vec<2> way = lines_[k].to - lines_[k].from, n = axes.scaled({way[1], -way[0]});
        perimeter += way.norm();
        for (int p = 0; p < 3; ++p) {
            const Vec<2> z = axes.scaled(lines_[k].from + 0.5 * p * way);
            const double share = (p == 1 ? 4.0 : 1.0) / 6;
            Monomials& of = project[3 * k + p];
            of = {0, n[0], n[1], 2 * z[0] * n[0], z[1] * n[0] + z[0] * n[1], 2 * z[1] * n[1]};
            for (int r = 1; r < 6; ++r)
                of[r] *= share / energy[r];
            of[0] = -(of[3] + of[5]); // the mean of a^2 and of b^2 is 1
            at[3 * k + p] = {1, z[0], z[1], z[0] * z[0], z[0] * z[1], z[1] * z[1]};
        }
    }
    project.back() = {2, 0, 0, -0.5, 0, -0.5}; // of the mean: - 2 scale^2 area over the energy
    moment = first_moments(lines_, axes);
    sides.clear();
    for (const ElementSide& side : lines_)
        sides.push_back(modes_of((side.to - side.from).norm(), 2 * area / perimeter));
}

PlaneElement plane_element(const std::vector<ElementSide>& sides)
{
    const PlaneProjection of(sides);
    PlaneElement element;
    element.area = of.area;
    element.centroid = of.centroid;
    const auto m = static_cast<Eigen::Index>(sides.size()), values = 3 * m + 1;
    element.rows = Eigen::MatrixXd::Zero(of.empty() ? 0 : 5 + 3 * m, values);
    element.moment = Eigen::MatrixXd::Zero(2, values);
    if (of.empty())
        return element;
    element.weight.resize(5 + 3 * m);
    Eigen::MatrixXd project(6, values);
    for (Eigen::Index v = 0; v < values; ++v)
        project.col(v) = Eigen::Map<const Eigen::Matrix<double, 6, 1>>(of.project[v].data());
    element.moment = of.moment * project;
    for (int r = 1; r < 6; ++r) {
        element.rows.row(r - 1) = project.row(r);
        element.weight[r - 1] = of.energy[r];
    }
    for (Eigen::Index k = 0; k < m; ++k)
        for (int mode = 0; mode < 3; ++mode) {
            for (int p = 0; p < 3; ++p) {
                const double share = of.sides[k].row[mode][p];
                const Eigen::Map<const Eigen::Matrix<double, 6, 1>> at(of.at[3 * k + p].data());
                element.rows.row(5 + 3 * k + mode) -= share * at.transpose() * project;
                element.rows(5 + 3 * k + mode, 3 * k + p) += share;
            }
            element.weight[5 + 3 * k + mode] = of.sides[k].weight[mode];
        }
    return element;
}

} // namespace gapflow
