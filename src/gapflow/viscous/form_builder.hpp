// What builds the viscous form, for its files alone.
#pragma once

#include "gapflow/complex/placed.hpp"
#include "gapflow/viscous/form.hpp"
#include "gapflow/viscous/parameters.hpp"

#include <array>
#include <map>
#include <tuple>
#include <vector>

namespace gapflow {

/// A point of a face's border: a vertex of the grid in the fluid, a point of a wall, or where neither is known a trace of its own.
template <int D>
struct BorderPoint {
    Vec<D> at = Vec<D>::Zero();
    std::int32_t vertex = -1; ///< number in Complex::index
    std::int32_t solid = -1;
};

/// A straight piece of the border of a face, the face at its left seen from its high side (3D).
template <int D>
struct BorderSegment {
    BorderPoint<D> from, to;
    std::int32_t stretch = -1; ///< number of an open stretch of an edge of the grid; -1: a wall
};

/// A wall of a cell: a straight line with the fluid at its left (2D), or a triangle, counterclockwise from outside (3D).
template <int D>
struct WallPiece {
    std::array<Vec<D>, D> points;
    std::int32_t solid;
};

/// Integrals over a cell's walls of their velocity: of each solid there, by its twist.
template <int D>
struct WallMoments {
    std::vector<std::int32_t> solid;
    std::vector<std::array<Twist<D>, D>> flux;                  ///< of u_e n_e, by e
    std::vector<std::array<std::array<Twist<D>, D>, D>> moment; ///< of (x_i - c_i) u_e n_e, by e and i
};

/// An open stretch of an edge of the grid, 3D.
struct EdgeStretch {
    std::int8_t axis;
    std::int32_t edge; ///< number of its low vertex
    double from, to;
};

/// Volume, centroid and second moments about it, from the simplices of a closed border.
template <int D>
struct CellShape {
    double volume = 0;
    Vec<D> centroid = Vec<D>::Zero();
    Mat<D> second = Mat<D>::Zero();

    /// Of a border's simplex, the volume between it and a point.
    void add(const std::array<Vec<D>, D>& simplex, const Vec<D>& about)
    {
        Mat<D> edges;
        for (int k = 0; k < D; ++k)
            edges.col(k) = simplex[k] - about;
        const double part = edges.determinant() / (D == 2 ? 2 : 6);
        const Vec<D> sum = edges.rowwise().sum();
        volume += part;
        centroid += part / (D + 1) * sum;
        second += part / ((D + 1) * (D + 2)) * (edges * edges.transpose() + sum * sum.transpose());
    }
    /// After all of them.
    void close(const Vec<D>& about)
    {
        if (volume > 0) {
            centroid /= volume;
            second -= volume * centroid * centroid.transpose();
        }
        centroid += about;
    }
};

/// A polygon as lines (2D: the line itself) or triangles around the mean of its points.
template <int D>
std::vector<std::array<Vec<D>, D>> simplices(const std::vector<Vec<D>>& points)
{
    if constexpr (D == 2)
        return {{points[0], points[1]}};
    else {
        std::vector<std::array<Vec<3>, 3>> result;
        if (points.size() == 3)
            return {{points[0], points[1], points[2]}};
        Vec<3> middle = Vec<3>::Zero();
        for (const Vec<3>& x : points)
            middle += x / static_cast<double>(points.size());
        for (std::size_t k = 0; k < points.size(); ++k)
            result.push_back({points[k], points[(k + 1) % points.size()], middle});
        return result;
    }
}

/// Numbers of derived columns and of moments until all columns are known.
inline constexpr std::int32_t first_derived = 1 << 29, first_moment = 1 << 30;

template <int D>
class FormBuilder {
public:
    FormBuilder(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex, const PartBorders<D>& borders,
                const GapDrags<D>& gaps);
    ViscousForm<D> build();

private:
    // Faces and their borders.
    void find_faces();
    void add_pieces();
    void add_whole_faces();
    void merge_pieces();
    void find_borders();
    const PartFace<D>* polygon_of(const FacePiece<D>& piece) const;
    std::int32_t stretch_of(int axis, const Index<D>& edge, double from, double to);
    BorderSegment<D> open_segment(const FormFace<D>& face, const Vec<D>& from, const Vec<D>& to);
    std::vector<BorderSegment<D>> square_of(const FormFace<D>& face);
    void join_stretches(std::size_t begin, const FormFace<D>& face);
    void find_walls();
    void find_sides();
    Vec<D> on_curve(const Vec<D>& from, const Vec<D>& to, std::int32_t solid, int axis) const;
    std::vector<Vec<D>> curved(const PartFace<D>& face) const;
    double length_of(int axis, const Index<D>& f) const;
    bool is_closed_side(int axis, int plane) const;
    bool on_closed_side(const Index<D>& vertex) const;
    /// How many cells of the compact lattice are between a face of it and a closed side with rows of its own, along an axis, and whether that is the high one; at most 2.
    std::pair<int, int> cells_to_side(const FormFace<D>& face, int axis) const;
    /// Whole faces by their place; -1: none.
    std::int32_t whole_face_at(int component, const Index<D>& f) const
    {
        const Index<D> at = index_.wrapped(f);
        return index_.holds(at - std::max(0, at[component] - index_.high()[component] + 1) * step<D>(component))
                   ? whole_face_[component][index_(at)]
                   : -1;
    }
    /// The velocity of closed sides: at a plane of one, at a vertex (the mean of those that meet there); 0 of sides that are not among the solids.
    Row of_side(int axis, int plane, int component) const;
    Row of_sides(const Index<D>& vertex, int component) const;
    int number(const Index<D>& c) const { return index_(index_.wrapped(c)); }
    Vec<D> vertex_place(const Index<D>& v) const;

    // Rows.
    Row velocity(std::int32_t face) const;
    Row of_solid(std::int32_t solid, const Vec<D>& x, int component) const;
    static void add_twist(Row& row, std::int32_t solid, const Twist<D>& factor);
    Row of_point(const BorderPoint<D>& point, int component);
    Row of_vertex(std::int32_t vertex, int component);
    Row of_stretch(std::int32_t stretch, int component);
    /// Between two faces normal to `component` that share an edge, along `across`, one of them of the compact lattice. high: the face above.
    Row between(int component, int across, const Index<D>& high) const;
    std::int32_t new_trace(int component, const Vec<D>& at, int axis = 0, double length = 0)
    {
        form_.traces.push_back({static_cast<std::int8_t>(component), static_cast<std::int8_t>(axis), at, length});
        return form_.unknowns() - 1;
    }
    Vec<D> arm(std::int32_t solid, const Vec<D>& x) const;
    /// Columns of a vertex and of a whole edge, derived where they are no traces, 3D.
    std::int32_t vertex_column(std::int32_t vertex, int component);
    std::int32_t edge_column(int axis, std::int32_t edge, int component);
    std::int32_t derive(Row row);
    bool is_compact_edge(const Index<D>& edge, int component, int across) const;
    /// First moment of a face's velocity about its centroid.
    Row moment_of(std::int32_t face, int axis) const;

    // Squares.
    void add_face(std::int32_t face);
    bool add_whole_face(std::int32_t face);
    bool add_whole_along(std::int32_t cell);
    void find_lattice();
    std::array<std::int32_t, 2 * D> beside(std::int32_t face) const;
    void add_compact(std::int32_t face);
    void add_at_side(std::int32_t face, int axis, int end, int layer);
    void add_along(std::int32_t cell);
    WallMoments<D> wall_moments(std::int32_t cell) const;
    void add_plain_along(std::int32_t cell);
    bool is_closed_border(std::int32_t cell) const;
    void find_gaps();
    void find_cell_shares();
    double pair_share(const std::array<std::int32_t, 2>& solids) const;
    void add_gaps();
    std::vector<std::size_t> side_by_side();
    void add_turning();
    std::int32_t face_at(const PeakDrag<D>& peak) const;
    void add_pair(const std::array<std::int32_t, 2>& solids, const PairMass<D>& mass);
    void add_outflow();
    void add_rotation();
    void close_columns();
    void drop_unused_traces();
    void find_beside();

    /// A face of a cell: its number, and 1 on the cell's high side, -1 on its low side.
    struct CellFace {
        std::int32_t face;
        int sign;
    };
    std::span<const CellFace> faces_of(std::int32_t cell) const
    {
        return {cell_faces_.data() + first_face_[cell], static_cast<std::size_t>(first_face_[cell + 1] - first_face_[cell])};
    }
    std::span<const WallPiece<D>> walls_of(std::int32_t cell) const
    {
        return {walls_.data() + first_wall_[cell], static_cast<std::size_t>(first_wall_[cell + 1] - first_wall_[cell])};
    }
    Vec<D> centre_of(std::int32_t cell) const; ///< of the grid's cell
    /// The face's centroid as the cell on that side has it, in a periodic domain.
    Vec<D> centroid_in(const CellFace& of, std::int32_t cell) const;

    const Grid<D>& grid_;
    std::span<const Solid<D>> solids_;
    const Complex<D>& complex_;
    const DenseIndex<D>& index_;
    const PartBorders<D>& borders_;
    const GapDrags<D>& gaps_;
    GridPlanes<D> planes_;
    std::vector<Vec<D>> reference_;              ///< of each solid, in cells
    std::array<std::int32_t, 2 * D> side_solid_; ///< of each closed side; -1: none
    bool periodic_ = false;
    ViscousForm<D> form_;
    std::vector<char> regular_;                                     ///< of each face: in a run of the lattice
    std::array<std::vector<std::int32_t>, D> whole_face_;           ///< by number in Complex::index; -1: none
    std::vector<double> gap_of_cell_;                               ///< share of its dissipation that is that of gaps
    std::map<std::array<std::int32_t, 2>, double> least_thickness_; ///< of the gaps of two solids, 3D
    std::vector<std::int32_t> face_of_piece_;                       ///< -1: none of its own
    std::vector<std::int32_t> first_face_, first_wall_;
    std::vector<CellFace> cell_faces_;
    std::vector<WallPiece<D>> walls_;
    std::vector<CellShape<D>> shapes_;
    std::vector<std::int32_t> first_segment_; ///< of each face that is not whole
    std::vector<BorderSegment<D>> segments_;
    std::vector<EdgeStretch> stretches_;
    std::map<std::pair<int, std::int32_t>, std::vector<std::int32_t>> stretches_at_; ///< by axis and low vertex of the edge
    std::vector<int> first_border_;                                                  ///< of each part, 3D
    std::vector<std::vector<const PartFace<D>*>> polygons_;                          ///< of each face that is not whole, 3D
    std::array<std::vector<std::int32_t>, D> vertex_trace_;                          ///< by component and vertex
    std::map<std::pair<std::int32_t, int>, std::int32_t> stretch_trace_;
    std::array<std::array<std::vector<std::int32_t>, D>, D>
        edge_column_; ///< by component, the edge's axis and its low vertex, 3D
    std::vector<Row> derived_;
    std::vector<std::int32_t> whole_element_; ///< of each face: its number in ViscousForm::whole; -1: none
    std::vector<std::array<Row, D>> moment_;  ///< of each face without
    std::vector<std::pair<std::int32_t, std::int32_t>> trace_face_; ///< traces of faces that are not whole
};

template <>
void FormBuilder<2>::merge_pieces();
template <>
void FormBuilder<2>::find_borders();
template <>
Row FormBuilder<2>::of_vertex(std::int32_t vertex, int component);
template <>
void FormBuilder<2>::add_face(std::int32_t face);
template <>
void FormBuilder<2>::add_turning();
template <>
std::vector<std::size_t> FormBuilder<2>::side_by_side();
template <>
const PartFace<3>* FormBuilder<3>::polygon_of(const FacePiece<3>& piece) const;
template <>
Vec<3> FormBuilder<3>::on_curve(const Vec<3>& from, const Vec<3>& to, std::int32_t solid, int axis) const;
template <>
std::vector<Vec<3>> FormBuilder<3>::curved(const PartFace<3>& face) const;
template <>
std::vector<Vec<2>> FormBuilder<2>::curved(const PartFace<2>& face) const;
template <>
void FormBuilder<3>::merge_pieces();
template <>
std::int32_t FormBuilder<3>::stretch_of(int axis, const Index<3>& edge, double from, double to);
template <>
BorderSegment<3> FormBuilder<3>::open_segment(const FormFace<3>& face, const Vec<3>& from, const Vec<3>& to);
template <>
std::vector<BorderSegment<3>> FormBuilder<3>::square_of(const FormFace<3>& face);
template <>
void FormBuilder<3>::join_stretches(std::size_t begin, const FormFace<3>& face);
template <>
void FormBuilder<3>::find_borders();
template <>
Row FormBuilder<3>::of_vertex(std::int32_t vertex, int component);
template <>
Row FormBuilder<3>::of_stretch(std::int32_t stretch, int component);
template <>
void FormBuilder<3>::add_face(std::int32_t face);
template <>
std::int32_t FormBuilder<3>::vertex_column(std::int32_t vertex, int component);
template <>
std::int32_t FormBuilder<3>::edge_column(int axis, std::int32_t edge, int component);
template <>
bool FormBuilder<3>::add_whole_face(std::int32_t face);
template <>
bool FormBuilder<3>::add_whole_along(std::int32_t cell);
template <>
void FormBuilder<3>::add_turning();
template <>
std::vector<std::size_t> FormBuilder<3>::side_by_side();

} // namespace gapflow
