// Along the component: the projection of du_d/dx_d on linear functions of a cell. With q = 1, x - c, Gauss's theorem and div u = 0 give its moments exactly,
//
//     int_P q d_d u_d = int_border q u_d n_d - (d_d q) int_P u_d,      int_P u_d = int_border x_d u.n,
//
// from the mean velocities of the faces, their first moments and the walls' motion.
#include "gapflow/viscous/form_builder.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace gapflow {
namespace {

/// A point of a wall with its share of the outward area.
template <int D>
struct WallSample {
    Vec<D> at, area;
};

/// Exact for quadratic functions.
template <int D>
std::array<WallSample<D>, 3> samples_of(const std::array<Vec<D>, D>& p)
{
    if constexpr (D == 2) {
        const Vec<2> way = p[1] - p[0], area(way[1], -way[0]);
        return {{{p[0], area / 6}, {0.5 * (p[0] + p[1]), 4 * area / 6}, {p[1], area / 6}}};
    } else {
        const Vec<3> area = (p[1] - p[0]).cross(p[2] - p[0]) / 6;
        return {{{0.5 * (p[0] + p[1]), area}, {0.5 * (p[1] + p[2]), area}, {0.5 * (p[2] + p[0]), area}}};
    }
}

} // namespace

template <int D>
Vec<D> FormBuilder<D>::centroid_in(const CellFace& of, std::int32_t cell) const
{
    const FormFace<D>& face = form_.faces[of.face];
    Vec<D> x = face.polygon_centroid;
    const Index<D> c = index_.index(form_.cells.grid_cell[cell]);
    x[face.axis] = planes_.place[face.axis][c[face.axis] + (of.sign > 0)];
    return x;
}

/// V (mean of d_d u_d)^2, of cells beside the compact lattice.
template <int D>
void FormBuilder<D>::add_plain_along(std::int32_t cell)
{
    if (const std::span<const CellFace> faces = faces_of(cell); faces.size() == 2 * D && form_.cells.whole[cell]) {
        std::array<std::array<const CellFace*, 2>, D> at{};
        for (const CellFace& of : faces)
            at[form_.faces[of.face].axis][of.sign > 0] = &of;
        for (int d = 0; d < D; ++d)
            if (at[d][0] && at[d][1] && !regular_[at[d][0]->face] && !regular_[at[d][1]->face])
                form_.squares.add(1 / shapes_[cell].volume, {{at[d][0]->face, -form_.faces[at[d][0]->face].area},
                                                             {at[d][1]->face, form_.faces[at[d][1]->face].area}});
        return;
    }
    std::array<Row, D> rows;
    for (const CellFace& of : faces_of(cell))
        rows[form_.faces[of.face].axis].add(of.face, of.sign * form_.faces[of.face].area);
    for (int d = 0; d < D; ++d)
        form_.squares.add(1 / shapes_[cell].volume, rows[d]);
}

/// In space planes from edges that meet at a corner of a solid inside a cell need not share their borders: without closed borders even uniform motion would seem to
/// have a divergence.
template <int D>
bool FormBuilder<D>::is_closed_border(std::int32_t cell) const
{
    Vec<D> sum = Vec<D>::Zero();
    for (const CellFace& of : faces_of(cell))
        sum[form_.faces[of.face].axis] += of.sign * form_.faces[of.face].polygon_area;
    for (const WallPiece<D>& wall : walls_of(cell))
        for (const WallSample<D>& sample : samples_of<D>(wall.points))
            sum += sample.area;
    return D == 2 || form_.cells.whole[cell] || !(sum.norm() > viscous_parameters.open_border);
}

template <int D>
void FormBuilder<D>::add_along(std::int32_t cell)
{
    for (const CellFace& of : faces_of(cell))
        if (form_.faces[of.face].compact)
            return add_plain_along(cell);
    if constexpr (D == 3)
        if (add_whole_along(cell))
            return;
    if (!is_closed_border(cell))
        return;
    const CellShape<D>& shape = shapes_[cell];
    const double share = 1 - gap_of_cell_[cell];
    if (!(shape.volume > viscous_parameters.least_volume) || !(share > 1e-12))
        return;
    const Eigen::SelfAdjointEigenSolver<Mat<D>> axes(shape.second);
    const WallMoments<D> walls = wall_moments(cell);
    for (int d = 0; d < D; ++d) {
        Row one, volume;           // int of d_d u_d, and of u_d
        std::array<Row, D> linear; // int of (x_i - c_i) d_d u_d
        for (const CellFace& of : faces_of(cell)) {
            const FormFace<D>& face = form_.faces[of.face];
            const Vec<D> r = centroid_in(of, cell) - shape.centroid;
            const double flux = of.sign * face.polygon_area;
            if (face.axis == d) {
                one.add(of.face, flux);
                for (int i = 0; i < D; ++i) {
                    linear[i].add(of.face, flux * r[i]);
                    if (i != d)
                        linear[i].add(moment_of(of.face, i), of.sign);
                }
            } else
                volume.add(moment_of(of.face, d), of.sign);
            volume.add(of.face, flux * r[d]);
        }
        for (std::size_t k = 0; k < walls.solid.size(); ++k) {
            add_twist(one, walls.solid[k], walls.flux[k][d]);
            for (int i = 0; i < D; ++i) {
                add_twist(linear[i], walls.solid[k], walls.moment[k][d][i]);
                add_twist(volume, walls.solid[k], walls.moment[k][i][d]);
            }
        }
        linear[d].add(volume, -1);
        form_.squares.add(share / shape.volume, one);
        for (int k = 0; k < D; ++k) {
            const double extent = axes.eigenvalues()[k];
            if (!(extent > viscous_parameters.least_extent * shape.volume))
                continue;
            Row row;
            for (int i = 0; i < D; ++i)
                if (axes.eigenvectors()(i, k) != 0)
                    row.add(linear[i], axes.eigenvectors()(i, k));
            form_.squares.add(share / extent, row);
        }
    }
}

/// Of all walls of a cell.
template <int D>
WallMoments<D> FormBuilder<D>::wall_moments(std::int32_t cell) const
{
    WallMoments<D> walls;
    for (const WallPiece<D>& wall : walls_of(cell)) {
        const auto found = std::find(walls.solid.begin(), walls.solid.end(), wall.solid);
        const auto k = static_cast<std::size_t>(found - walls.solid.begin());
        if (found == walls.solid.end()) {
            walls.solid.push_back(wall.solid);
            walls.flux.emplace_back().fill(Twist<D>::Zero());
            walls.moment.emplace_back();
            for (auto& of_component : walls.moment.back())
                of_component.fill(Twist<D>::Zero());
        }
        for (const WallSample<D>& sample : samples_of<D>(wall.points)) {
            const Vec<D> r = sample.at - shapes_[cell].centroid, lever = arm(wall.solid, sample.at);
            for (int e = 0; e < D; ++e) {
                const Twist<D> out = sample.area[e] * wrench<D>(unit<D>(e), lever);
                walls.flux[k][e] += out;
                for (int i = 0; i < D; ++i)
                    walls.moment[k][e][i] += r[i] * out;
            }
        }
    }
    return walls;
}

template WallMoments<2> FormBuilder<2>::wall_moments(std::int32_t) const;
template WallMoments<3> FormBuilder<3>::wall_moments(std::int32_t) const;
template void FormBuilder<2>::add_along(std::int32_t);
template bool FormBuilder<2>::is_closed_border(std::int32_t) const;
template bool FormBuilder<3>::is_closed_border(std::int32_t) const;
template void FormBuilder<2>::add_plain_along(std::int32_t);
template Vec<2> FormBuilder<2>::centroid_in(const CellFace&, std::int32_t) const;
template void FormBuilder<3>::add_along(std::int32_t);
template void FormBuilder<3>::add_plain_along(std::int32_t);
template Vec<3> FormBuilder<3>::centroid_in(const CellFace&, std::int32_t) const;

} // namespace gapflow
