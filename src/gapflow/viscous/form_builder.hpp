// What builds the viscous form, for its files alone.
#pragma once

#include "gapflow/complex/placed.hpp"
#include "gapflow/grid/inline_vector.hpp"
#include "gapflow/viscous/curve_points.hpp"
#include "gapflow/viscous/form.hpp"
#include "gapflow/viscous/merge_terms.hpp"
#include "gapflow/viscous/parameters.hpp"
#include "gapflow/viscous/plane_element.hpp"

#include <algorithm>
#include <array>
#include <functional>
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

/// Integrals over a cell's walls of a solid of its velocity, by its twist.
template <int D>
struct WallMoments {
    std::int32_t solid;
    std::array<Twist<D>, D> flux;                  ///< of u_e n_e, by e
    std::array<std::array<Twist<D>, D>, D> moment; ///< of (x_i - c_i) u_e n_e, by e and i
};

/// An open stretch of an edge of the grid, 3D.
struct EdgeStretch {
    std::int8_t axis;
    std::int32_t edge; ///< number of its low vertex
    double from, to;
    std::int32_t next;                                ///< another one of the edge; -1: none
    std::array<std::int32_t, 3> trace = {-1, -1, -1}; ///< by component
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
void find_simplices(const std::vector<Vec<D>>& points, std::vector<std::array<Vec<D>, D>>& result)
{
    result.clear();
    if constexpr (D == 2)
        result.push_back({points[0], points[1]});
    else if (points.size() == 3)
        result.push_back({points[0], points[1], points[2]});
    else {
        Vec<3> middle = Vec<3>::Zero();
        for (const Vec<3>& x : points)
            middle += x / static_cast<double>(points.size());
        for (std::size_t k = 0; k < points.size(); ++k)
            result.push_back({points[k], points[k + 1 < points.size() ? k + 1 : 0], middle});
    }
}

/// A row of columns that differ.
void add(std::span<const Term> terms, RowList& to);

/// Rows of two terms, put behind those of a form block by block.
class FlatRows {
public:
    FlatRows(SquareSum& squares, std::vector<std::int32_t>& row_face) : squares_(squares), row_face_(row_face) {}
    ~FlatRows() { put(); }
    FlatRows(const FlatRows&) = delete;
    FlatRows& operator=(const FlatRows&) = delete;
    void add(std::int32_t face, double weight, const Term& a, const Term& b)
    {
        if (n_ == size)
            put();
        face_[n_] = face;
        weight_[n_] = weight;
        column_[2 * n_] = a.column;
        column_[2 * n_ + 1] = b.column;
        factor_[2 * n_] = a.factor;
        factor_[2 * n_ + 1] = b.factor;
        ++n_;
    }

private:
    static constexpr int size = 512;
    void put();

    SquareSum& squares_;
    std::vector<std::int32_t>& row_face_;
    int n_ = 0;
    std::array<std::int32_t, size> face_;
    std::array<double, size> weight_;
    std::array<std::int32_t, 2 * size> column_;
    std::array<double, 2 * size> factor_;
};

/// Numbers of derived columns and of moments until all columns are known.
inline constexpr std::int32_t first_derived = 1 << 29, first_moment = 1 << 30;

template <int D>
class FormBuilder {
public:
    FormBuilder(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex, const PartBorders<D>& borders,
                const GapDrags<D>& gaps);
    ViscousForm<D> build();

private:
    /// A face of a cell: its number, and 1 on the cell's high side, -1 on its low side.
    struct CellFace {
        std::int32_t face;
        int sign;
    };
    using CellFaces = InlineVector<CellFace, 12>;
    using Terms = std::vector<Term>;
    /// A whole cell without faces of the compact lattice; its faces by axis and side, -1: not whole, or none.
    struct UnevenCell {
        std::int32_t cell;
        std::array<std::array<std::int32_t, 2>, D> face;
    };

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
    Vec<D> on_curve(const Vec<D>& from, const Vec<D>& to, std::int32_t solid, int axis);
    void find_curved(const PartFace<D>& face, std::vector<Vec<D>>& points);
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
    void add_side(int axis, int plane, int component, double factor, Terms& to) const;
    void add_sides(const Index<D>& vertex, int component, double factor, Terms& to) const;
    int number(const Index<D>& c) const { return index_(index_.wrapped(c)); }
    Vec<D> vertex_place(const Index<D>& v) const;

    // Rows: terms that are added to others.
    Row of_solid(std::int32_t solid, const Vec<D>& x, int component) const;
    void add_solid(std::int32_t solid, const Vec<D>& x, int component, double factor, Terms& to) const;
    static void add_twist(std::int32_t solid, const Twist<D>& twist, double factor, Terms& to);
    void add_point(const BorderPoint<D>& point, int component, double factor, Terms& to);
    void add_vertex(std::int32_t vertex, int component, double factor, Terms& to);
    void add_stretch(std::int32_t stretch, int component, double factor, Terms& to);
    /// Between two faces normal to `component` that share an edge, along `across`, one of them of the compact lattice. high: the face above.
    void add_between(int component, int across, const Index<D>& high, double factor, Terms& to) const;
    std::int32_t new_trace(int component, const Vec<D>& at, int axis = 0, double length = 0)
    {
        form_.traces.push_back({static_cast<std::int8_t>(component), static_cast<std::int8_t>(axis), at, length});
        return form_.unknowns() - 1;
    }
    Vec<D> arm(std::int32_t solid, const Vec<D>& x) const;
    /// Columns of a vertex and of a whole edge, derived where they are no traces, 3D.
    std::int32_t vertex_column(std::int32_t vertex, int component);
    std::int32_t edge_column(int axis, std::int32_t edge, int component);
    std::int32_t new_vertex_column(std::int32_t vertex, int component);
    std::int32_t new_edge_column(int axis, std::int32_t edge, int component);
    std::int32_t derive(Terms& row);
    bool is_compact_edge(const Index<D>& edge, int component, int across) const;
    /// First moment of a face's velocity about its centroid.
    void add_moment(std::int32_t face, int axis, double factor, Terms& to) const;

    // Squares.
    void add_face(std::int32_t face);
    void add_element(std::int32_t face);
    /// Of a column among those that are gathered.
    int slot_of(std::int32_t column)
    {
        const auto slot = std::ranges::find(columns_, column) - columns_.begin();
        if (slot == std::ssize(columns_))
            columns_.push_back(column);
        return static_cast<int>(slot);
    }
    void find_widths();
    template <class F>
    void for_each_whole_cell(const Index<D>& row, const F& f) const;
    void find_uneven_cells();
    void add_flat_rows();
    void add_compact(int axis, const Index<D>& row, FlatRows& rows) const;
    void add_plain(const Index<D>& row, FlatRows& rows) const;
    bool add_whole_face(std::int32_t face);
    bool add_whole_along(const UnevenCell& cell);
    void find_lattice();
    std::array<std::int32_t, 2 * D> beside(std::int32_t face) const;
    void add_at_sides(std::int32_t face);
    void add_at_side(std::int32_t face, int axis, int end, int layer);
    void add_along(std::int32_t cell);
    void find_along(std::int32_t cell, const CellShape<D>& shape);
    void find_wall_moments(std::int32_t cell, std::vector<WallMoments<D>>& walls) const;
    /// As SquareSum::add.
    void add_row(double weight, std::span<const std::int32_t> columns, std::span<const double> factors);
    void add_row(double weight, Terms& row);
    /// Of columns that differ.
    void add_terms(double weight, std::span<const Term> terms);
    void add_plain_along(std::int32_t cell, const CellFaces& faces);
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
    void add_flat_outflow(const std::function<void(std::int32_t)>& add);
    void add_rotation();
    template <class F>
    void for_each_open_column(const F& f);
    void close_columns();
    void drop_unused_traces();
    void find_beside();

    /// Pieces, then whole faces.
    CellFaces faces_of(std::int32_t cell) const;
    bool is_whole(std::int32_t face) const { return face >= pieces_; }
    /// Cells that solids cut are numbered before the others.
    std::int32_t cut_cells() const { return static_cast<std::int32_t>(shapes_.size()); }
    CellShape<D> shape_of(std::int32_t cell) const;
    std::span<const WallPiece<D>> walls_of(std::int32_t cell) const
    {
        if (cell >= cut_cells())
            return {};
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
    std::array<std::vector<double>, D> width_, centre_;   ///< of the grid's cells, from DenseIndex::low on
    std::array<std::vector<double>, D> spread_, between_; ///< of its planes: length_of(), 1 over the sum of the widths beside
    ViscousForm<D> form_;
    std::int32_t pieces_ = 0;                                       ///< faces that are not whole, before the others
    std::vector<char> compact_;                                     ///< FormFace::compact
    std::vector<char> regular_;                                     ///< of each face: in a run of the lattice
    std::array<std::vector<std::int32_t>, D> whole_face_;           ///< by number in Complex::index; -1: none
    std::vector<double> gap_of_cell_;                               ///< share of its dissipation that is that of gaps
    std::map<std::array<std::int32_t, 2>, double> least_thickness_; ///< of the gaps of two solids, 3D
    std::vector<std::int32_t> face_of_piece_;                       ///< -1: none of its own
    std::vector<std::int32_t> first_face_;                          ///< of each cell
    std::vector<CellFace> cell_faces_;                              ///< that are not whole
    std::vector<std::int32_t> first_wall_;                          ///< of each cell that is cut
    std::vector<WallPiece<D>> walls_;
    std::vector<CellShape<D>> shapes_; ///< of each cell that is cut
    std::vector<UnevenCell> uneven_cells_;
    std::int64_t first_flat_ = 0;             ///< term: from there on all columns are velocities
    std::vector<std::int32_t> first_segment_; ///< of each face that is not whole
    std::vector<BorderSegment<D>> segments_;
    std::vector<EdgeStretch> stretches_;
    std::array<std::vector<std::int32_t>, D> first_stretch_; ///< by axis and low vertex of the edge; -1: none
    std::vector<int> first_border_;                          ///< of each part, 3D
    std::vector<std::vector<const PartFace<D>*>> polygons_;  ///< of each face that is not whole, 3D
    std::array<std::vector<std::int32_t>, D> vertex_trace_;  ///< by component and vertex
    std::array<std::array<std::vector<std::int32_t>, D>, D>
        edge_column_; ///< by component, the edge's axis and its low vertex, 3D
    std::vector<std::int32_t>
        element_;    ///< of each face: its number in ViscousForm::whole; -1: none; from -2 down: that in moment_
    RowList moment_; ///< D rows of each such face, by axis
    std::vector<std::pair<std::int32_t, std::int32_t>> trace_face_; ///< traces of faces that are not whole, face by face
    CurvePoints curve_points_;
    // Room for what is found again and again.
    Terms terms_;
    std::vector<std::int32_t> columns_;
    std::vector<double> dense_;
    std::vector<char> has_;
    std::vector<std::pair<std::int32_t, double>> sparse_; ///< numbers in columns_, with factors
    std::vector<std::int32_t> sparse_end_;
    std::vector<ElementSide> sides_;
    PlaneProjection projection_;
    std::vector<WallMoments<D>> wall_moments_;
};

template <>
void FormBuilder<2>::merge_pieces();
template <>
void FormBuilder<2>::find_borders();
template <>
void FormBuilder<2>::add_vertex(std::int32_t vertex, int component, double factor, Terms& to);
template <>
void FormBuilder<2>::add_face(std::int32_t face);
template <>
void FormBuilder<2>::add_turning();
template <>
std::vector<std::size_t> FormBuilder<2>::side_by_side();
template <>
const PartFace<3>* FormBuilder<3>::polygon_of(const FacePiece<3>& piece) const;
template <>
Vec<3> FormBuilder<3>::on_curve(const Vec<3>& from, const Vec<3>& to, std::int32_t solid, int axis);
template <>
void FormBuilder<3>::find_curved(const PartFace<3>& face, std::vector<Vec<3>>& points);
template <>
void FormBuilder<2>::find_curved(const PartFace<2>& face, std::vector<Vec<2>>& points);
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
void FormBuilder<3>::add_vertex(std::int32_t vertex, int component, double factor, Terms& to);
template <>
void FormBuilder<3>::add_stretch(std::int32_t stretch, int component, double factor, Terms& to);
template <>
void FormBuilder<3>::add_face(std::int32_t face);
template <>
void FormBuilder<3>::add_element(std::int32_t face);
template <>
std::int32_t FormBuilder<3>::new_vertex_column(std::int32_t vertex, int component);
template <>
std::int32_t FormBuilder<3>::new_edge_column(int axis, std::int32_t edge, int component);
template <>
inline std::int32_t FormBuilder<3>::vertex_column(std::int32_t vertex, int component)
{
    std::int32_t& column = vertex_trace_[component][vertex];
    return column < 0 ? column = new_vertex_column(vertex, component) : column;
}
template <>
inline std::int32_t FormBuilder<3>::edge_column(int axis, std::int32_t edge, int component)
{
    std::vector<std::int32_t>& columns = edge_column_[component][axis];
    if (columns.empty())
        columns.assign(index_.count, -1);
    return columns[edge] < 0 ? columns[edge] = new_edge_column(axis, edge, component) : columns[edge];
}
template <>
bool FormBuilder<3>::add_whole_face(std::int32_t face);
template <>
bool FormBuilder<3>::add_whole_along(const UnevenCell& cell);
template <>
void FormBuilder<3>::add_turning();
template <>
std::vector<std::size_t> FormBuilder<3>::side_by_side();

} // namespace gapflow
