// The columns of the viscous solve on parts: momenta of the complex's edges, traces of the viscous form, twists of all solids; with the operators
// that the coupled system and the form have in them.
#pragma once

#include "gapflow/step/potential_flow.hpp"
#include "gapflow/viscous/form.hpp"

#include <Eigen/Sparse>

#include <array>
#include <span>
#include <vector>

namespace gapflow {

/// Edges: the faces of the grid that this rank owns, then Placed::edges. With the conductance g an edge has the flux g m + k V and the energy 1/2 g m^2. Its column is
/// n = sqrt(g) m, whose energy is 1/2 n^2.
template <int D>
class ViscousColumns {
public:
    using Vector = Eigen::VectorXd;
    using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

    ViscousColumns(const Placed<D>& at, const ViscousForm<D>& form);

    int edges() const { return static_cast<int>(conductance_.size()); }
    int trace(int number) const { return edges() + number; }
    int twist(int solid, int component = 0) const
    {
        return edges() + static_cast<int>(form_.traces.size()) + twist_size<D> * solid + component;
    }
    int columns() const { return twist(static_cast<int>(at_.coupling.solids.size())); }
    int unknowns() const { return static_cast<int>(cells_) + at_.coupling.system.nodes; }

    /// -1: not an edge.
    int edge_of_face(int axis, const Index<D>& f) const { return face_[axis][number(f)]; }
    int edge_of(std::size_t sparse_edge) const { return first_sparse_ + static_cast<int>(sparse_edge); }
    double conductance(int edge) const { return conductance_[edge]; }
    /// Share of each face of the form that is filled with fluid, less than one beside voids.
    const std::vector<double>& filled() const { return filled_; }

    /// D q + K V of all rows of the coupled system.
    const Rows& outflow() const { return outflow_; }
    /// Roots of the weights times the rows of the form's squares.
    Rows squares() const;
    /// The form's part that is not a sum of squares.
    Rows rotation() const;
    /// The form's columns of these, without what is given.
    const Rows& form() const { return to_form_; }
    Vector to_form(const Vector& x) const { return to_form_ * x; }
    /// Of the derivatives by the form's columns: those by these.
    Vector from_form(const Vector& by_form) const { return to_form_.transpose() * by_form; }
    /// The form's columns that are given: velocities of inflow.
    Vector given(const GivenSides<D>& sides) const;
    /// Derivatives of the form.
    Vector friction(const Vector& x) const;
    /// Its diagonal, nearly. Of edges whose faces have traces beside them, with the traces at the means of the faces beside them.
    Vector diagonal() const;
    const ViscousForm<D>& of_form() const { return form_; }

    /// Momenta of a flow, its twists.
    Vector of_flow(const PotentialFlow<D>& flow) const;
    UnknownVector<D> to_unknowns(const Vector& rows) const;
    Vector of_unknowns(const UnknownVector<D>& p) const;
    /// What the potentials have along each edge.
    Vector drops(const Vector& rows) const { return incidence_.transpose() * rows; }

private:
    /// The share of an edge's flux that passes a face of the form, over the face's area.
    struct Through {
        int edge;
        double factor;
    };

    std::span<const Through> through(int face) const
    {
        return {through_.data() + first_through_[face],
                static_cast<std::size_t>(first_through_[face + 1] - first_through_[face])};
    }
    long number(const Index<D>& f) const
    {
        long n = 0;
        for (int axis = D - 1; axis >= 0; --axis)
            n = n * (at_.coupling.grid->cells()[axis] + 1) + f[axis];
        return n;
    }
    template <class F>
    void for_each_line(const F& f) const;
    void find_edges();
    void find_faces();
    void fill_outflow();
    void fill_form();
    Rows in_columns(const SquareSum& sum, bool roots) const;
    /// Terms of the form's column in these columns.
    template <class F>
    void for_each_term(int form_column, const F& f) const;

    const Placed<D>& at_;
    const ViscousForm<D>& form_;
    long cells_;
    int first_sparse_ = 0;
    std::array<std::vector<int>, D> face_;
    std::vector<double> conductance_;
    std::vector<std::vector<std::pair<int, Twist<D>>>> carried_; ///< of each edge: solid and k
    std::vector<int> first_through_;
    std::vector<Through> through_;          ///< of each face of the form, from first_through_ of it on
    std::vector<double> filled_;            ///< the same
    Eigen::SparseMatrix<double> incidence_; ///< unknowns x edges
    Rows outflow_, to_form_;
};

} // namespace gapflow
