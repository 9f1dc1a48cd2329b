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

/// Not of cells with faces of the compact lattice.
template <int D>
void FormBuilder<D>::add_along(std::int32_t cell)
{
    if (!is_closed_border(cell))
        return;
    const CellShape<D> shape = shape_of(cell);
    const double share = 1 - gap_of_cell_[cell];
    if (!(shape.volume > viscous_parameters.least_volume) || !(share > 1e-12))
        return;
    const Eigen::SelfAdjointEigenSolver<Mat<D>> axes(shape.second);
    find_along(cell, shape);
    const std::size_t n = columns_.size();
    std::vector<double> row(n);
    std::vector<char> has(n);
    const auto put = [&](double weight) {
        terms_.clear();
        for (std::size_t c = 0; c < n; ++c)
            if (has[c])
                terms_.push_back({columns_[c], row[c]});
        add_terms(weight, terms_);
    };
    for (int d = 0; d < D; ++d) {
        const std::size_t first = d * (D + 1) * n; // int of d_d u_d, and of (x_i - c_i) d_d u_d
        std::copy_n(dense_.begin() + first, n, row.begin());
        std::copy_n(has_.begin() + first, n, has.begin());
        put(share / shape.volume);
        for (int k = 0; k < D; ++k) {
            const double extent = axes.eigenvalues()[k];
            if (!(extent > viscous_parameters.least_extent * shape.volume))
                continue;
            std::fill(row.begin(), row.end(), 0.0);
            std::fill(has.begin(), has.end(), false);
            for (int i = 0; i < D; ++i)
                if (const double factor = axes.eigenvectors()(i, k); factor != 0)
                    for (std::size_t c = 0; c < n; ++c) {
                        row[c] += factor * dense_[first + (i + 1) * n + c];
                        has[c] |= has_[first + (i + 1) * n + c];
                    }
            put(share / extent);
        }
    }
}

/// Integrals over a cell: for each component d of d_d u_d, and of (x_i - c_i) d_d u_d, by the columns that are gathered.
template <int D>
void FormBuilder<D>::find_along(std::int32_t cell, const CellShape<D>& shape)
{
    const CellFaces faces = faces_of(cell);
    find_wall_moments(cell, wall_moments_);
    columns_.clear();
    sparse_.clear();
    sparse_end_.assign(1, 0);
    for (const CellFace& of : faces) { // its velocity, and its moments along each axis
        const int axis = form_.faces[of.face].axis;
        sparse_.emplace_back(slot_of(of.face), of.sign);
        for (int i = 0; i < D; ++i) {
            terms_.clear();
            if (i != axis)
                add_moment(of.face, i, of.sign, terms_);
            for (const Term& term : terms_)
                sparse_.emplace_back(slot_of(term.column), term.factor);
            sparse_end_.push_back(static_cast<std::int32_t>(sparse_.size()));
        }
    }
    InlineVector<int, 12> twists;
    for (const WallMoments<D>& wall : wall_moments_)
        for (int k = 0; k < twist_size<D>; ++k)
            twists.push_back(slot_of(-1 - twist_size<D> * wall.solid - k));
    const std::size_t n = columns_.size();
    dense_.assign(D * (D + 1) * n, 0.0);
    has_.assign(D * (D + 1) * n, false);
    const auto add = [&](int d, int row, std::int32_t slot, double factor) {
        dense_[(d * (D + 1) + row) * n + slot] += factor;
        has_[(d * (D + 1) + row) * n + slot] = true;
    };
    const auto add_wall = [&](int d, int row, std::int32_t slot, double factor) {
        if (factor != 0)
            add(d, row, slot, factor);
    };
    std::size_t next = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const FormFace<D>& face = form_.faces[faces[f].face];
        const Vec<D> r = centroid_in(faces[f], cell) - shape.centroid;
        const int slot = sparse_[next].first;
        const double flux = faces[f].sign * face.polygon_area;
        add(face.axis, 0, slot, flux);
        for (int i = 0; i < D; ++i) {
            add(face.axis, i + 1, slot, flux * r[i]);
            add(i, i + 1, slot, -flux * r[i]); // int u_i
        }
        ++next;
        for (int i = 0; i < D; ++i)
            for (; next < static_cast<std::size_t>(sparse_end_[D * f + i + 1]); ++next) {
                add(face.axis, i + 1, sparse_[next].first, sparse_[next].second);
                add(i, i + 1, sparse_[next].first, -sparse_[next].second);
            }
    }
    for (std::size_t w = 0; w < wall_moments_.size(); ++w)
        for (int k = 0; k < twist_size<D>; ++k) {
            const WallMoments<D>& wall = wall_moments_[w];
            const int slot = twists[twist_size<D> * w + k];
            for (int d = 0; d < D; ++d) {
                add_wall(d, 0, slot, wall.flux[d][k]);
                for (int i = 0; i < D; ++i) {
                    add_wall(d, i + 1, slot, wall.moment[d][i][k]);
                    add_wall(d, d + 1, slot, -wall.moment[i][d][k]);
                }
            }
        }
}

/// Of all walls of a cell.
template <int D>
void FormBuilder<D>::find_wall_moments(std::int32_t cell, std::vector<WallMoments<D>>& walls) const
{
    walls.clear();
    if (cell >= cut_cells())
        return;
    // By solid, of the outward area: itself, with (x - c)_i, with the arm, and with both.
    struct Sums {
        std::int32_t solid = -1;
        Vec<D> area = Vec<D>::Zero();
        Mat<D> by_place = Mat<D>::Zero(), by_arm = Mat<D>::Zero();
        std::array<Mat<D>, D> by_both{};
    };
    InlineVector<Sums, 2> sums;
    const Vec<D> centroid = shapes_[cell].centroid;
    for (const WallPiece<D>& wall : walls_of(cell)) {
        Sums* of = std::find_if(sums.begin(), sums.end(), [&](const Sums& s) { return s.solid == wall.solid; });
        if (of == sums.end()) {
            sums.push_back({});
            of = sums.end() - 1;
            of->solid = wall.solid;
            of->by_both.fill(Mat<D>::Zero());
        }
        const auto add = [&](const Vec<D>& area, double share, const Vec<D>& r, const Vec<D>& lever, const Mat<D>& both) {
            of->area += share * area;
            of->by_place += area * r.transpose();
            of->by_arm += area * lever.transpose();
            for (int i = 0; i < D; ++i)
                of->by_both[i] += area * both.row(i);
        };
        Vec<D> sum_r = Vec<D>::Zero(), sum_lever = Vec<D>::Zero();
        Mat<D> sum_both = Mat<D>::Zero();
        const std::array<WallSample<D>, 3> samples = samples_of<D>(wall.points);
        for (const WallSample<D>& sample : samples) {
            const Vec<D> r = sample.at - centroid, lever = arm(wall.solid, sample.at);
            if constexpr (D == 2)
                add(sample.area, 1, r, lever, r * lever.transpose());
            else { // whose samples have one area
                sum_r += r;
                sum_lever += lever;
                sum_both += r * lever.transpose();
            }
        }
        if constexpr (D == 3)
            add(samples[0].area, 3, sum_r, sum_lever, sum_both);
    }
    for (const Sums& of : sums) {
        WallMoments<D>& wall = walls.emplace_back();
        wall.solid = of.solid;
        const auto twist = [](int e, double area, const Vec<D>& by_arm) { // of u_e
            Twist<D> result;
            result << area * unit<D>(e), moment<D>(by_arm, unit<D>(e));
            return result;
        };
        for (int e = 0; e < D; ++e) {
            wall.flux[e] = twist(e, of.area[e], of.by_arm.row(e));
            for (int i = 0; i < D; ++i)
                wall.moment[e][i] = twist(e, of.by_place(e, i), of.by_both[i].row(e));
        }
    }
}

template void FormBuilder<2>::add_along(std::int32_t);
template void FormBuilder<3>::add_along(std::int32_t);
template bool FormBuilder<2>::is_closed_border(std::int32_t) const;
template bool FormBuilder<3>::is_closed_border(std::int32_t) const;
template Vec<2> FormBuilder<2>::centroid_in(const CellFace&, std::int32_t) const;
template Vec<3> FormBuilder<3>::centroid_in(const CellFace&, std::int32_t) const;

} // namespace gapflow
