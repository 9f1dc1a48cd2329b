// Cholesky factorisation L L^T of a sparse symmetric matrix with an order of elimination that keeps it sparse.
#pragma once

#include <Eigen/Sparse>

#include <vector>

namespace gapflow {

/// Columns in turn that have the same rows below them, as those have that a dense block ties, are a panel, one block of arithmetic. A panel and the rows below it are
/// one dense matrix, the sum of their part of A and of what the panels that are eliminated before leave there (multifrontal method; Duff & Reid 1983).
class SparseCholesky {
public:
    using Matrix = Eigen::SparseMatrix<double>;

    /// Chooses the order of elimination for matrices of this pattern; the lower triangle is read.
    void analyse(const Matrix& a);
    /// Factorises a matrix of the analysed pattern. False if it is not positive definite. On all threads, with the same bits for any number.
    [[nodiscard]] bool factorise(const Matrix& a);
    /// Both, for a pattern that is used once.
    [[nodiscard]] bool compute(const Matrix& a);
    /// The solution of the matrix factorised last. On all threads, with the same bits for any number.
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    /// The same of every column, on this thread alone.
    Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& b) const;
    /// Entries of the factor below its diagonal.
    long entries() const;
    /// Memory of the factor.
    long bytes() const;

private:
    /// Disjoint subtrees of the elimination tree, whose columns touch each other's unknowns through the top alone: the columns that are in none.
    struct Subtree {
        int begin, end; ///< columns
    };
    /// Columns begin .. end - 1, each with all rows below it in the panel and then `rows`, the same for all.
    struct Panel {
        int begin, end;
        int rows, inside; ///< rows below the panel; those of them in its subtree
        int first_row;    ///< in rows_
        long first_value; ///< in values_: (columns + rows) x columns, whose upper triangle is not used
        int columns() const { return end - begin; }
        int height() const { return columns() + rows; }
    };
    struct Crossing { ///< a row of a subtree's panel that is in the top
        int panel;
        int row; ///< of the panel's
    };
    /// What a panel takes off the matrix of its rows; both triangles stored, the lower one used.
    using Update = Eigen::MatrixXd;
    struct Order;
    void cut_tree(const Order& order);
    /// Panels that lie in one subtree each, or in the top, and their rows.
    void find_panels(const Order& order, const Matrix& both_triangles);
    void find_crossings();
    /// The panel's part of L and its update, from the lower triangle of A in the order of elimination. False if it is not positive definite.
    bool eliminate(int panel, const Matrix& lower, std::vector<Update>& updates);
    void forward(const Panel& panel, int rows, double* y) const;
    void backward(const Panel& panel, double* y) const;
    /// Right sides that an entry of the factor is read for at once.
    static constexpr int together = 8;
    using RightSides = Eigen::Matrix<double, Eigen::Dynamic, together, Eigen::RowMajor>;
    using RightSide = Eigen::Matrix<double, 1, together>;
    void forward(const Panel& panel, RightSides& y) const;
    void backward(const Panel& panel, RightSides& y) const;

    Eigen::VectorXi row_of_, place_of_; ///< of a place in the order, and back
    std::vector<Subtree> subtrees_;
    std::vector<int> top_;                 ///< columns, ascending
    std::vector<Panel> panels_;            ///< of the subtrees, then of the top
    std::vector<int> first_panel_;         ///< of every subtree, and of the top
    std::vector<int> child_begin_, child_; ///< of every panel, those whose first row below them is one of its columns
    std::vector<int> rows_;                ///< of all panels, each one's ascending
    std::vector<int> crossing_begin_;      ///< of every column in `top_`
    std::vector<Crossing> crossing_;       ///< ascending panels in each row
    std::vector<double> values_, inverse_diagonal_;
};

} // namespace gapflow
