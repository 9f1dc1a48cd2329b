#include "gapflow/step/viscous_columns.hpp"

#include "gapflow/step/inner_faces.hpp"
#include "gapflow/step/remainder.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace gapflow {
namespace {

constexpr double least_filled = 1e-9; // share of a way, as of a dry gap that is closed: a void's edge has a velocity

} // namespace

template <int D>
ViscousColumns<D>::ViscousColumns(const Placed<D>& at, const ViscousForm<D>& form)
    : at_(at), form_(form), cells_(at.coupling.grid->cells().template cast<long>().prod())
{
    find_edges();
    find_faces();
    fill_outflow();
    fill_form();
}

template <int D>
void ViscousColumns<D>::find_edges()
{
    const Grid<D>& grid = *at_.coupling.grid;
    const CoupledSystem<D>& system = at_.coupling.system;
    std::vector<int> row, end{0}; // of the incidence, by edges
    std::vector<double> weight;
    const auto close = [&] {
        const std::size_t begin = end.back();
        for (std::size_t k = begin + 1; k < row.size(); ++k) // few
            for (std::size_t m = k; m > begin && row[m] < row[m - 1]; --m) {
                std::swap(row[m], row[m - 1]);
                std::swap(weight[m], weight[m - 1]);
            }
        end.push_back(static_cast<int>(row.size()));
    };
    const auto add = [&](long at, double value) {
        for (std::size_t k = end.back(); k < row.size(); ++k)
            if (row[k] == at) {
                weight[k] += value;
                return;
            }
        row.push_back(static_cast<int>(at));
        weight.push_back(value);
    };
    for (int axis = 0; axis < D; ++axis) {
        face_[axis].assign(number(grid.cells()) + 1, -1);
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            const double g = system.conductance(axis, f);
            if (!(g > 0))
                return;
            face_[axis][number(f)] = edges();
            conductance_.push_back(g);
            if (const Index<D> low = grid.wrapped(Index<D>(f - step<D>(axis))); grid.in_domain(low))
                add(grid.key(low), 1);
            if (const Index<D> high = grid.wrapped(f); grid.in_domain(high))
                add(grid.key(high), -1);
            close();
        });
        if (grid.periodic(axis)) { // the last face is the first one
            Index<D> low = grid.low(), high = grid.high();
            low[axis] = high[axis];
            high[axis] = low[axis] + 1;
            for_each_index<D>(low, high,
                              [&](const Index<D>& f) { face_[axis][number(f)] = face_[axis][number(grid.wrapped(f))]; });
        }
    }
    first_sparse_ = edges();
    for (const SparseEdge<D>& edge : at_.edges.edges) {
        for (const auto& of : at_.edges.rows_of(edge))
            add(of.node >= 0 ? cells_ + of.node : grid.key(grid.wrapped(of.cell)), of.weight);
        close();
        conductance_.push_back(edge.conductance);
    }
    for (const VoidEdge<D>& edge : at_.voids.edges)
        conductance_[edge_of(edge.edge)] = edge.open();
    incidence_ = Eigen::Map<const Eigen::SparseMatrix<double>>(unknowns(), edges(), static_cast<Eigen::Index>(row.size()),
                                                               end.data(), row.data(), weight.data());
    carried_.resize(edges());
    for (const CarriedFlux<D>& of : at_.edges.carried)
        if (const int edge = of.axis >= 0 ? edge_of_face(of.axis, of.face) : edge_of(of.edge); edge >= 0)
            carried_[edge].emplace_back(of.solid, of.flux);
}

/// Which edges pass each face of the form.
template <int D>
void ViscousColumns<D>::find_faces()
{
    const Complex<D>& complex = at_.complex;
    const Grid<D>& grid = *at_.coupling.grid;
    const double face_area = grid.face_area();
    // Faces of the form on a face of the grid: the first one, and after each the next one.
    std::array<std::vector<std::int32_t>, D> first;
    std::vector<std::int32_t> next(form_.velocities(), -1);
    for (auto& of : first)
        of.assign(complex.index.count, -1);
    for (int k = form_.velocities() - 1; k >= 0; --k) {
        std::int32_t& at = first[form_.faces[k].axis][form_.faces[k].face];
        next[k] = at;
        at = k;
    }
    std::vector<std::pair<int, Through>> passing; // by faces
    passing.reserve(form_.velocities() + form_.velocities() / 8);
    filled_.assign(form_.velocities(), 1.0);
    std::vector<double> filled(edges(), 1.0);            // of the way along each edge
    std::map<std::pair<int, std::int32_t>, int> to_void; // edges of faces of the grid
    std::map<std::int32_t, int> piece_to_void;
    for (const VoidEdge<D>& edge : at_.voids.edges) {
        filled[edge_of(edge.edge)] = std::max(least_filled, edge.fluid * edge.permeable);
        if (edge.face >= 0)
            to_void[{static_cast<int>(edge.face % D), complex.index(grid.cell_of_key(edge.face / D))}] = edge_of(edge.edge);
        else if (edge.mouth < 0)
            piece_to_void[edge.piece] = edge_of(edge.edge);
    }
    const auto add = [&](int face, int edge, double share) {
        passing.push_back({face, {edge, share / (filled[edge] * form_.faces[face].area * face_area)}});
        filled_[face] = std::min(filled_[face], filled[edge]);
    };
    // The face of the form that a piece is, or a part of.
    const auto face_of = [&](const FacePiece<D>& piece) {
        int best = -1;
        double least = 0;
        for (std::int32_t k = first[piece.axis][piece.face]; k >= 0; k = next[k]) {
            const FormFace<D>& face = form_.faces[k];
            if (face.low != form_.cells.of(piece.low) || face.high != form_.cells.of(piece.high))
                continue;
            const double far = (face.centroid - piece.centroid).norm();
            if (best < 0 || far < least) {
                best = k;
                least = far;
            }
        }
        return best;
    };
    std::map<std::pair<int, std::int32_t>, double> main_area;
    for (const FacePiece<D>& piece : complex.pieces)
        if (complex.joins_main(piece))
            main_area[{piece.axis, piece.face}] += piece.area;
    for (std::size_t k = 0; k < complex.pieces.size(); ++k) {
        const FacePiece<D>& piece = complex.pieces[k];
        const int face = face_of(piece);
        if (face < 0 || !(piece.area > 0))
            continue;
        if (complex.joins_main(piece)) {
            if (const int edge = edge_of_face(piece.axis, complex.index.index(piece.face)); edge >= 0)
                add(face, edge, piece.area / main_area[{piece.axis, piece.face}]);
            else if (const auto found = piece_to_void.find(static_cast<std::int32_t>(k)); found != piece_to_void.end())
                add(face, found->second, 1);
        } else if (const std::int32_t edge = at_.edges.edge_of_piece[k]; edge >= 0)
            add(face, edge_of(edge), 1);
    }
    for (int k = 0; k < form_.velocities(); ++k)
        if (const FormFace<D>& face = form_.faces[k]; face.whole) {
            if (const int edge = edge_of_face(face.axis, complex.index.index(face.face)); edge >= 0)
                add(k, edge, 1);
            else if (const auto found = to_void.find({face.axis, face.face}); found != to_void.end())
                add(k, found->second, 1);
        }
    for (std::size_t e = 0; e < at_.edges.edges.size(); ++e)
        if (at_.edges.edges[e].mouth >= 0)
            for (const FaceAlong<D>& along : faces_along(at_, at_.edges.edges[e])) {
                const std::int32_t begin = first[along.axis][complex.index(complex.index.wrapped(along.face))];
                double all = 0;
                for (std::int32_t k = begin; k >= 0; k = next[k])
                    all += form_.faces[k].area;
                for (std::int32_t k = begin; k >= 0; k = next[k])
                    add(k, edge_of(e), along.length / face_length(grid, along.axis, along.face) * form_.faces[k].area / all);
            }
    first_through_.assign(form_.velocities() + 1, 0);
    for (const auto& [face, of] : passing)
        ++first_through_[face + 1];
    for (int k = 0; k < form_.velocities(); ++k)
        first_through_[k + 1] += first_through_[k];
    through_.resize(passing.size());
    std::vector<int> at(first_through_.begin(), first_through_.end() - 1);
    for (const auto& [face, of] : passing)
        through_[at[face]++] = of;
}

template <int D>
void ViscousColumns<D>::fill_outflow()
{
    const Grid<D>& grid = *at_.coupling.grid;
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](long row, int solid, const Twist<D>& flux) {
        for (int k = 0; k < twist_size<D>; ++k)
            entries.emplace_back(static_cast<int>(row), twist(solid, k), flux[k]);
    };
    for (const auto& entry : at_.coupling.cell_flux)
        add(grid.key(entry.row), entry.body, entry.flux);
    for (const auto& entry : at_.coupling.node_flux)
        add(cells_ + entry.row, entry.body, entry.flux);
    const Eigen::SparseMatrix<double> of_edges =
        incidence_ * Vector::Map(conductance_.data(), edges()).cwiseSqrt().asDiagonal();
    outflow_ = of_edges;
    outflow_.conservativeResize(unknowns(), columns());
    Rows of_solids(unknowns(), columns());
    of_solids.setFromTriplets(entries.begin(), entries.end());
    outflow_ += of_solids;
}

template <int D>
template <class F>
void ViscousColumns<D>::for_each_term(int form_column, const F& f) const
{
    if (form_column < form_.velocities()) {
        for (const Through& of : through(form_column)) {
            f(of.edge, of.factor * std::sqrt(conductance_[of.edge]));
            for (const auto& [solid, flux] : carried_[of.edge])
                for (int k = 0; k < twist_size<D>; ++k)
                    f(twist(solid, k), of.factor * flux[k]);
        }
    } else if (form_column < form_.unknowns())
        f(trace(form_column - form_.velocities()), 1.0);
    else {
        const int k = (form_column - form_.unknowns()) % twist_size<D>;
        f(twist((form_column - form_.unknowns()) / twist_size<D>, k), k < D ? 1.0 : at_.coupling.grid->dx());
    }
}

template <int D>
void ViscousColumns<D>::fill_form()
{
    std::vector<int> end{0}, column;
    std::vector<double> factor;
    Row row;
    for (int k = 0; k < form_.columns(); ++k) {
        if (k < form_.velocities() && through(k).size() == 1 && carried_[through(k)[0].edge].empty()) {
            const Through& of = through(k)[0];
            column.push_back(of.edge);
            factor.push_back(of.factor * std::sqrt(conductance_[of.edge]));
        } else {
            row = {};
            for_each_term(k, [&](int at, double value) { row.add(at, value); });
            row.merge();
            for (const Term& term : row.terms()) {
                column.push_back(term.column);
                factor.push_back(term.factor);
            }
        }
        end.push_back(static_cast<int>(column.size()));
    }
    to_form_ = Eigen::Map<const Rows>(form_.columns(), columns(), static_cast<Eigen::Index>(column.size()), end.data(),
                                      column.data(), factor.data());
}

template <int D>
auto ViscousColumns<D>::in_columns(const SquareSum& sum, bool roots) const -> Rows
{
    std::vector<Eigen::Triplet<double>> entries;
    for (std::int64_t row = 0; row < sum.rows(); ++row)
        for (std::int64_t t = sum.end[row]; t < sum.end[row + 1]; ++t)
            for_each_term(sum.column[t], [&](int column, double factor) {
                entries.emplace_back(static_cast<int>(row), column,
                                     (roots ? std::sqrt(sum.weight[row]) : 1.0) * factor * sum.factor[t]);
            });
    Rows rows(static_cast<int>(sum.rows()), columns());
    rows.setFromTriplets(entries.begin(), entries.end());
    return rows;
}

template <int D>
auto ViscousColumns<D>::squares() const -> Rows
{
    return in_columns(form_.plain_squares(), true);
}

template <int D>
auto ViscousColumns<D>::rotation() const -> Rows
{
    const Rows rows = in_columns(form_.rotation, false);
    const Eigen::VectorXd weight = Eigen::VectorXd::Map(form_.rotation.weight.data(), form_.rotation.rows());
    return Rows(rows.transpose()) * Rows(weight.asDiagonal() * rows);
}

template <int D>
Eigen::VectorXd ViscousColumns<D>::friction(const Vector& x) const
{
    const Vector u = to_form_ * x;
    Vector by(u.size());
    form_.product({u.data(), static_cast<std::size_t>(u.size())}, {by.data(), static_cast<std::size_t>(by.size())});
    return to_form_.transpose() * by;
}

template <int D>
Eigen::VectorXd ViscousColumns<D>::diagonal() const
{
    std::vector<double> of_form = form_.diagonal();
    const std::vector<double> followed = form_.followed_diagonal(of_form);
    std::copy(followed.begin(), followed.end(), of_form.begin());
    Vector diagonal = Vector::Zero(columns());
    for (int row = 0; row < form_.columns(); ++row)
        for (typename Rows::InnerIterator entry(to_form_, row); entry; ++entry)
            diagonal[entry.col()] += of_form[row] * entry.value() * entry.value();
    return diagonal;
}

template <int D>
Eigen::VectorXd ViscousColumns<D>::given(const GivenSides<D>& sides) const
{
    Vector y = Vector::Zero(form_.columns());
    for (int k = 0; k < form_.velocities(); ++k)
        if (const FormFace<D>& face = form_.faces[k]; face.low < 0 || face.high < 0)
            y[k] = sides.speed[2 * face.axis + (face.high < 0)]; // 0 but at inflow, where no edge is
    return y;
}

template <int D>
Eigen::VectorXd ViscousColumns<D>::of_flow(const PotentialFlow<D>& flow) const
{
    const Grid<D>& grid = *at_.coupling.grid;
    const double density = at_.coupling.density;
    const Vector drop = drops(of_unknowns(flow.p));
    Vector x = Vector::Zero(columns());
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            if (const int edge = edge_of_face(axis, f); edge >= 0)
                x[edge] = std::sqrt(conductance_[edge]) *
                          (drop[edge] + density * face_length(grid, axis, f) * flow.remainder.faces(axis, f));
        });
    for (std::size_t e = 0; e < flow.remainder.edges.size(); ++e)
        x[edge_of(e)] = std::sqrt(conductance_[edge_of(e)]) * (drop[edge_of(e)] + density * flow.remainder.edges[e]);
    for (std::size_t s = 0; s < flow.twists.size(); ++s)
        x.segment<twist_size<D>>(twist(static_cast<int>(s))) = flow.twists[s];
    return x;
}

/// f(cell, row) of the first cell of each line along the first axis.
template <int D>
template <class F>
void ViscousColumns<D>::for_each_line(const F& f) const
{
    const Grid<D>& grid = *at_.coupling.grid;
    Index<D> end = grid.high();
    end[0] = grid.low()[0] + 1;
    for_each_index<D>(grid.low(), end, [&](const Index<D>& c) { f(c, grid.key(c)); });
}

template <int D>
UnknownVector<D> ViscousColumns<D>::to_unknowns(const Vector& rows) const
{
    const Grid<D>& grid = *at_.coupling.grid;
    UnknownVector<D> p{CellField<D>(grid), rows.tail(at_.coupling.system.nodes)};
    for_each_line([&](const Index<D>& c, long row) { std::copy_n(rows.data() + row, grid.cells()[0], &p.cells(c)); });
    return p;
}

template <int D>
Eigen::VectorXd ViscousColumns<D>::of_unknowns(const UnknownVector<D>& p) const
{
    const Grid<D>& grid = *at_.coupling.grid;
    Vector rows(unknowns());
    for_each_line([&](const Index<D>& c, long row) { std::copy_n(&p.cells(c), grid.cells()[0], rows.data() + row); });
    rows.tail(at_.coupling.system.nodes) = p.nodes;
    return rows;
}

template class ViscousColumns<2>;
template class ViscousColumns<3>;

} // namespace gapflow
