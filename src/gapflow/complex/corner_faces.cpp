#include "gapflow/complex/corner_faces.hpp"

#include "gapflow/complex/lever.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/grid/field.hpp"

#include <cmath>
#include <numbers>

namespace gapflow {

double corner_gain(double angle)
{
    const double nu = std::numbers::pi / (2 * std::numbers::pi - angle);
    return std::pow(2, 0.5 * nu - 1) / std::sin(0.25 * std::numbers::pi * nu) - 1;
}

namespace {

/// Places half a cell apart at most, which go with the solid.
int places_along(double length)
{
    return std::max(1, static_cast<int>(std::ceil(2 * length)));
}

void add_edges(const PlacedSolid<3>& image, int number, const EdgeMouths* mouths, std::vector<Complex<3>::Corner>& corners)
{
    for (int e = 0; e < static_cast<int>(image.sharp.edges.size()); ++e) {
        const SharpEdge& edge = image.sharp.edges[e];
        const Vec<3> way = edge.to - edge.from;
        const double length = way.norm();
        const Vec<3> outward = (image.sharp.facets[edge.a].normal + image.sharp.facets[edge.b].normal).normalized();
        const int n = places_along(length);
        for (int k = 0; k < n; ++k) {
            const double s = (k + 0.5) / n * length;
            const double own = mouths ? mouths->own(number, e, s) : 1.0;
            const double strength = corner_gain(edge.angle) * own * length / n;
            if (strength > 0)
                corners.push_back({image.solid, edge.from + s / length * way, image.reference, strength, outward,
                                   std::numbers::pi - 0.5 * edge.angle, way / length});
        }
    }
    for (const SharpRim& rim : image.sharp.rims) {
        const double length = 2 * std::numbers::pi * rim.radius;
        const int n = 4 * places_along(length / 4);
        // Two directions normal to the axis that turn with the solid.
        const Mat<3>& turn = image.shape.rotation();
        int least = 0;
        (turn.transpose() * rim.normal).cwiseAbs().minCoeff(&least);
        const Vec<3> u = rim.normal.cross(Vec<3>(turn.col(least))).normalized(), v = rim.normal.cross(u);
        for (int k = 0; k < n; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.5) / n;
            const Vec<3> out = std::cos(angle) * u + std::sin(angle) * v;
            corners.push_back({image.solid, rim.centre + rim.radius * out, image.reference,
                               corner_gain(0.5 * std::numbers::pi) * length / n, (rim.normal + out).normalized(),
                               0.75 * std::numbers::pi, rim.normal.cross(out)});
        }
    }
}

} // namespace

template <int D>
std::vector<typename Complex<D>::Corner> corners_near(const GridPlanes<D>& planes, const std::vector<PlacedSolid<D>>& placed,
                                                      [[maybe_unused]] const EdgeMouths* mouths)
{
    std::vector<typename Complex<D>::Corner> corners;
    for (int number = 0; number < static_cast<int>(placed.size()); ++number) {
        const PlacedSolid<D>& image = placed[number];
        if constexpr (D == 2) {
            for (const SharpCorner& corner : image.corners)
                if (corner.own > 0)
                    corners.push_back({image.solid, corner.at, image.reference, corner.own * corner_gain(corner.angle),
                                       corner.bisector.isZero(0) ? corner.outward : corner.bisector,
                                       std::numbers::pi - 0.5 * corner.angle, Vec<2>::Zero()});
        } else
            add_edges(image, number, mouths, corners);
    }
    std::erase_if(corners, [&](const typename Complex<D>::Corner& corner) {
        for (const PlacedSolid<D>& other : placed) // which covers it, as images of a solid longer than the period do
            if (!(other.solid == corner.solid && other.reference == corner.reference) &&
                (corner.at.array() >= other.low.array()).all() && (corner.at.array() <= other.high.array()).all() &&
                other.shape.distance(planes.in_world(corner.at)) < parameters.joint_distance * planes.dx)
                return true;
        for (int axis = 0; axis < D; ++axis) // farther than two cells from the block
            if (const PlanePlaces& place = planes.place[axis];
                corner.at[axis] < place[place.first()] - 2 || corner.at[axis] > place[place.last()] + 2)
                return true;
        return false;
    });
    return corners;
}

template <int D>
std::vector<TwistMatrix<D>> corner_masses(const Grid<D>& grid, const Complex<D>& complex)
{
    std::vector<TwistMatrix<D>> masses(complex.seen_mass.size(), TwistMatrix<D>::Zero());
    if (!complex.corners.empty()) {
        const OpenAreas<D> areas(complex);
        const CornerFaces<D> faces(grid, complex, areas);
        for (const auto& corner : complex.corners)
            faces.for_each(corner, [&](const CornerFace<D>& face) {
                if (owns_face(grid, face.axis, complex.index.index(face.face)))
                    masses[corner.solid] -= face.added * face.distance * face.motion * face.motion.transpose();
            });
    }
    for (TwistMatrix<D>& mass : masses)
        mass = (0.5 * (mass + mass.transpose())).eval();
    if (!masses.empty())
        grid.comm().sum(std::span<double>(masses.data()->data(), masses.size() * masses.data()->size()));
    return masses;
}

template std::vector<Complex<2>::Corner> corners_near(const GridPlanes<2>&, const std::vector<PlacedSolid<2>>&,
                                                      const EdgeMouths*);
template std::vector<Complex<3>::Corner> corners_near(const GridPlanes<3>&, const std::vector<PlacedSolid<3>>&,
                                                      const EdgeMouths*);
template std::vector<TwistMatrix<2>> corner_masses(const Grid<2>&, const Complex<2>&);
template std::vector<TwistMatrix<3>> corner_masses(const Grid<3>&, const Complex<3>&);

} // namespace gapflow
