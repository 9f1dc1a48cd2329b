#include "gapflow/viscous/plane_element.hpp"

#include "gapflow/viscous/parameters.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace gapflow {
namespace {

/// 1, a, b, a^2, ab, b^2 in the polygon's principal axes, in which the mean of a^2 and of b^2 is 1: their gradients are orthogonal.
struct Monomials {
    Mat<2> axes;  ///< columns
    Vec<2> scale; ///< a = scale_0 axes_0 . x

    Vec<2> scaled(const Vec<2>& x) const { return scale.cwiseProduct(axes.transpose() * x); }
    Eigen::Matrix<double, 6, 1> at(const Vec<2>& x) const
    {
        const Vec<2> z = scaled(x);
        Eigen::Matrix<double, 6, 1> f;
        f << 1, z[0], z[1], z[0] * z[0], z[0] * z[1], z[1] * z[1];
        return f;
    }
    /// Of 1 .. 5 in its rows 1 .. 5.
    Eigen::Matrix<double, 6, 2> gradients(const Vec<2>& x) const
    {
        const Vec<2> z = scaled(x), e = scale[0] * axes.col(0), f = scale[1] * axes.col(1);
        Eigen::Matrix<double, 6, 2> g;
        g.row(0).setZero();
        g.row(1) = e;
        g.row(2) = f;
        g.row(3) = 2 * z[0] * e;
        g.row(4) = z[1] * e + z[0] * f;
        g.row(5) = 2 * z[1] * f;
        return g;
    }
    Eigen::Matrix<double, 6, 1> energies(double area) const
    {
        const double a = scale[0] * scale[0] * area, b = scale[1] * scale[1] * area;
        Eigen::Matrix<double, 6, 1> result;
        result << 0, a, b, 4 * a, a + b, 4 * b;
        return result;
    }
};

double cross(const Vec<2>& a, const Vec<2>& b)
{
    return a[0] * b[1] - a[1] * b[0];
}

/// Area, centroid; sides about the centroid on return.
double centre(std::vector<ElementSide>& sides, Vec<2>& centroid)
{
    const Vec<2> about = sides[0].from;
    double area = 0;
    Vec<2> first = Vec<2>::Zero();
    for (const ElementSide& side : sides) {
        const Vec<2> a = side.from - about, b = side.to - about;
        area += 0.5 * cross(a, b);
        first += cross(a, b) / 6 * (a + b);
    }
    centroid = area > 0 ? Vec<2>(about + first / area) : about;
    for (ElementSide& side : sides) {
        side.from -= centroid;
        side.to -= centroid;
    }
    return area;
}

Monomials monomials_of(const std::vector<ElementSide>& sides, double area)
{
    Mat<2> second = Mat<2>::Zero();
    for (const ElementSide& side : sides) {
        const Vec<2>&a = side.from, &b = side.to, s = a + b;
        second += cross(a, b) / 24 * (a * a.transpose() + b * b.transpose() + s * s.transpose());
    }
    const Eigen::SelfAdjointEigenSolver<Mat<2>> axes(second / area);
    Monomials m;
    m.axes = axes.eigenvectors();
    for (int k = 0; k < 2; ++k)
        m.scale[k] = 1 / std::sqrt(std::max(axes.eigenvalues()[k], 1e-20));
    return m;
}

/// int x m_r over the polygon: exact for polynomials of degree 4 on triangles (D. A. Dunavant, 1985).
Eigen::Matrix<double, 2, 6> first_moments(const std::vector<ElementSide>& sides, const Monomials& m)
{
    constexpr double a = 0.816847572980459, b = 0.091576213509771, c = 0.109951743655322, d = 0.108103018168070,
                     e = 0.445948490915965, f = 0.223381589678011;
    constexpr double rule[6][3] = {{a, b, c}, {b, a, c}, {b, b, c}, {d, e, f}, {e, d, f}, {e, e, f}};
    Eigen::Matrix<double, 2, 6> sum = Eigen::Matrix<double, 2, 6>::Zero();
    for (const ElementSide& side : sides)
        for (const auto& point : rule) {
            const Vec<2> x = point[0] * side.from + point[1] * side.to;
            sum += 0.5 * cross(side.from, side.to) * point[2] * x * m.at(x).transpose();
        }
    return sum;
}

} // namespace

PlaneElement plane_element(const std::vector<ElementSide>& all)
{
    std::vector<ElementSide> sides = all;
    PlaneElement element;
    element.area = centre(sides, element.centroid);
    const int m = static_cast<int>(sides.size()), values = 3 * m + 1, mean = 3 * m;
    element.rows = Eigen::MatrixXd::Zero(0, values);
    element.moment = Eigen::MatrixXd::Zero(2, values);
    if (!(element.area > viscous_parameters.least_volume))
        return element;
    const Monomials monomials = monomials_of(sides, element.area);
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(6, values), at_points(3 * m, 6);
    double perimeter = 0;
    for (int k = 0; k < m; ++k) {
        const Vec<2> way = sides[k].to - sides[k].from, normal(way[1], -way[0]);
        perimeter += way.norm();
        for (int p = 0; p < 3; ++p) {
            const Vec<2> x = sides[k].from + 0.5 * p * way;
            B.col(3 * k + p) += (p == 1 ? 4.0 : 1.0) / 6 * (monomials.gradients(x) * normal);
            at_points.row(3 * k + p) = monomials.at(x);
        }
    }
    for (const int k : {0, 1})
        B(3 + 2 * k, mean) -= 2 * monomials.scale[k] * monomials.scale[k] * element.area;
    const Eigen::Matrix<double, 6, 1> energy = monomials.energies(element.area);
    Eigen::MatrixXd project = Eigen::MatrixXd::Zero(6, values);
    for (int r = 1; r < 6; ++r)
        project.row(r) = B.row(r) / energy[r];
    project(0, mean) = 1; // the mean of a^2 and of b^2 is 1
    project.row(0) -= project.row(3) + project.row(5);
    element.moment = first_moments(sides, monomials) * project;
    Eigen::MatrixXd rest = -at_points * project;
    for (int k = 0; k < 3 * m; ++k)
        rest(k, k) += 1;
    element.rows.resize(5 + 3 * m, values);
    element.weight.resize(5 + 3 * m);
    for (int r = 1; r < 6; ++r) {
        element.rows.row(r - 1) = project.row(r);
        element.weight[r - 1] = energy[r];
    }
    Eigen::Matrix3d mass, stiffness;
    mass << 4, 2, -1, 2, 16, 2, -1, 2, 4;
    stiffness << 7, -8, 1, -8, 16, -8, 1, -8, 7;
    const double delta = 2 * element.area / perimeter;
    for (int k = 0; k < m; ++k) {
        const double length = (sides[k].to - sides[k].from).norm();
        const Eigen::Matrix3d cost =
            length > 1e-12 ? Eigen::Matrix3d(length / delta / 30 * mass + viscous_parameters.side_stiffness *
                                                                              std::min(delta, length) / length / 3 * stiffness)
                           : Eigen::Matrix3d::Zero();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(cost);
        element.rows.middleRows(5 + 3 * k, 3) = modes.eigenvectors().transpose() * rest.middleRows(3 * k, 3);
        element.weight.segment(5 + 3 * k, 3) = modes.eigenvalues().cwiseMax(0);
    }
    return element;
}

} // namespace gapflow
