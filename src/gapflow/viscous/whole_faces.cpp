#include "gapflow/viscous/whole_faces.hpp"

#include "gapflow/viscous/plane_element.hpp"

namespace gapflow {
namespace {

using Slots = Eigen::Matrix<double, UnitFace::size, 1>;
using FaceMatrix = Eigen::Matrix<double, UnitFace::size, UnitFace::size>;

/// Of squares of a first moment in a cell, 1 over its mean square extent; it comes twice in each of the two cells.
constexpr double moments_of_cells = 12 * 2 * 2;

UnitFace find_unit_face()
{
    const std::array<Vec<2>, 4> corner{Vec<2>(0, 0), Vec<2>(1, 0), Vec<2>(1, 1), Vec<2>(0, 1)};
    std::vector<ElementSide> sides;
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(13, UnitFace::size); // of the sides' ends and middles
    for (int k = 0; k < 4; ++k) {
        const int next = (k + 1) % 4;
        sides.push_back({corner[k], corner[next]});
        values(3 * k, k) = values(3 * k + 2, next) = 1;
        values(3 * k + 1, 4 + k) = 1.5;
        values(3 * k + 1, k) = values(3 * k + 1, next) = -0.25;
    }
    values(12, 8) = 1;
    const PlaneElement element = plane_element(sides);
    UnitFace face;
    const Eigen::MatrixXd rows = element.rows * values;
    face.stiffness = rows.transpose() * element.weight.asDiagonal() * rows;
    face.moment = element.moment * values;
    // Beside a face are one over each side, with two vertices of it, and one over each vertex.
    const FaceMatrix all = face.stiffness + moments_of_cells * face.moment.transpose() * face.moment;
    const auto part = [&](std::array<int, 3> slots) {
        FaceMatrix result = FaceMatrix::Zero();
        for (const int i : slots)
            for (const int j : slots)
                result(i, j) = all(i, j);
        return result;
    };
    FaceMatrix sum = all;
    Slots own, beside = Slots::Zero(), over = Slots::Zero(); // with traces at means
    own << 0.25, 0.25, 0.25, 0.25, 0.5, 0.5, 0.5, 0.5, 1;
    beside[0] = beside[1] = over[0] = 0.25;
    beside[4] = 0.5;
    for (int k = 0; k < 4; ++k)
        sum += part({k, (k + 1) % 4, 4 + k}) + part({k, k, k});
    const Eigen::Matrix<double, 8, 8> block = sum.topLeftCorner<8, 8>();
    const Eigen::Matrix<double, 8, 1> root = block.diagonal().cwiseSqrt();
    face.inverse = root.asDiagonal() * block.inverse() * root.asDiagonal();
    face.alone = face.stiffness(8, 8) + 2;
    face.followed = own.dot(all * own) + 4 * (beside.dot(all * beside) + over.dot(all * over)) + 2;
    return face;
}

} // namespace

const UnitFace& unit_face()
{
    static const UnitFace face = find_unit_face();
    return face;
}

void WholeFaces::find_moments(std::span<const double> x, std::span<double> moments) const
{
    const Eigen::Matrix<double, 2, UnitFace::size> moment = unit_face().moment;
    for (std::size_t f = 0; f < columns.size(); ++f) {
        Slots slots;
        for (int k = 0; k < UnitFace::size; ++k)
            slots[k] = x[columns[f][k]];
        const Eigen::Vector2d both = moment * slots;
        moments[2 * f] = both[0];
        moments[2 * f + 1] = both[1];
    }
}

void WholeFaces::add_product(std::span<const double> x, std::span<const double> by_moments, std::span<double> y) const
{
    const FaceMatrix stiffness = unit_face().stiffness;
    const Eigen::Matrix<double, UnitFace::size, 2> moment = unit_face().moment.transpose();
    for (std::size_t f = 0; f < columns.size(); ++f) {
        Slots slots;
        for (int k = 0; k < UnitFace::size; ++k)
            slots[k] = x[columns[f][k]];
        const Slots by = stiffness * slots + moment * Eigen::Vector2d(by_moments[2 * f], by_moments[2 * f + 1]);
        for (int k = 0; k < UnitFace::size; ++k)
            y[columns[f][k]] += by[k];
    }
}

} // namespace gapflow
