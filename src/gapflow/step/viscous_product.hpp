// The form of the viscous solve in its unknowns, made for many products: runs of the lattice, a matrix for each element, rows, and what is a function of the unknowns.
#pragma once

#include "gapflow/step/viscous_columns.hpp"

namespace gapflow {

template <int D>
class ViscousProduct {
public:
    using Vector = Eigen::VectorXd;
    using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

    /// `form_of`: the form's columns of the unknowns: edges, traces, the motion of free bodies. `factor`: of the form. `bodies`: mass of that motion.
    ViscousProduct(const ViscousForm<D>& form, const Rows& form_of, double factor, int edges,
                   const Eigen::SparseMatrix<double>& bodies);

    /// Of vectors for products: after the unknowns they have room for functions of these.
    Eigen::Index size() const { return first_moment_ + 2 * static_cast<Eigen::Index>(whole_.size()); }
    Eigen::Index unknowns() const { return unknowns_; }
    /// What the form times the factor has between the motion of free bodies, but for what derived columns have.
    std::vector<Eigen::Triplet<double>> friction_of_bodies() const;
    /// y = (T + factor A) x, T the kinetic energy's: edges have 1/2 n^2. Fills the room of both.
    void apply(Vector& x, Vector& y) const;

private:
    /// A column of the form: of these vectors, times a factor. -1: one at rest.
    struct Place {
        std::int32_t at = -1;
        double factor = 0;
    };
    struct Run {
        std::int32_t first, length;
        std::array<std::int32_t, 2 * D> beside;
        double square; ///< of the factor of all
    };
    /// y_at += factor (factor x_at - other_factor x_other)
    struct Link {
        Place at, other;
    };
    struct Whole {
        std::array<std::int32_t, UnitFace::size> at;
        double factor; ///< of its velocity
    };
    /// The matrices of elements, one after the other, by columns.
    struct Elements {
        std::vector<std::int64_t> end{0}, entry{0};
        std::vector<std::int32_t> at;
        std::vector<double> matrix;
    };

    void find_places(const ViscousForm<D>& form, const Rows& form_of);
    void take_lattice(const Lattice<D>& lattice);
    void take_whole(const WholeFaces& whole);
    void take_squares(const ViscousForm<D>& form);
    void add_element(const SquareSum& squares, std::int64_t first, std::int64_t last);
    void find_functions(Vector& x) const;
    void give_functions(Vector& y) const;
    void add_whole(const Vector& x, Vector& y) const;
    void add_elements(const Vector& x, Vector& y) const;

    Eigen::Index edges_, unknowns_, first_moment_ = 0;
    std::int32_t first_of_twists_ = 0, last_of_twists_ = 0; ///< functions that are columns of twists
    double factor_;
    std::vector<Place> place_; ///< of each column of the form
    RowList functions_;        ///< of what is before them
    std::vector<Run> runs_;
    std::vector<Link> links_;
    std::vector<Whole> whole_;
    Elements elements_;
    SquareSum squares_, rotation_;
    Eigen::SparseMatrix<double> bodies_;
};

} // namespace gapflow
