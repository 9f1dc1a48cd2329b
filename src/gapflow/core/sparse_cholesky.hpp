// Cholesky factorisation L D L^T of a sparse symmetric matrix with an order of elimination that keeps it sparse.
#pragma once

#include <Eigen/SparseCholesky>

#include <vector>

namespace gapflow {

/// Approximate minimum degree (Amestoy, Davis & Duff 1996), or nested dissection where that makes many entries. Of a large matrix the elimination tree is then numbered in postorder, which changes no entry's place in
/// the factor: what is eliminated in turn is close in memory, and every subtree is a run of columns.
struct EliminationOrder {
    using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;
    /// Of a symmetric matrix with both triangles. `order` maps places in the order to rows.
    void operator()(const Eigen::SparseMatrix<double>& a, Permutation& order) const;
};

class SparseCholesky {
public:
    using Matrix = Eigen::SparseMatrix<double>;

    /// Chooses the order of elimination for matrices of this pattern; the lower triangle is read.
    void analyse(const Matrix& a);
    /// Factorises a matrix of the analysed pattern. False if it is not positive definite.
    [[nodiscard]] bool factorise(const Matrix& a);
    /// Both, for a pattern that is used once.
    [[nodiscard]] bool compute(const Matrix& a);
    /// The solution of the matrix factorised last. On all threads, with the same bits for any number.
    /// Columns in turn that have the same rows below them, as the unknowns have that a dense block ties, are one block of arithmetic.
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
    /// The same of every column, on this thread alone.
    Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& b) const;
    /// Entries of the factor below its diagonal.
    long entries() const;

private:
    /// Disjoint subtrees of the elimination tree, whose columns touch each other's unknowns through the top alone: the columns that are in none.
    struct Subtree {
        int begin, end; ///< columns
    };
    struct Crossing { ///< an entry of L in a row of the top and a column of a subtree
        int column;
        int entry;
    };
    /// Columns begin .. end - 1, each with all rows below it in the panel and then `rows`, the same for all.
    struct Panel {
        int begin, end;
        int rows, inside; ///< rows below the panel; those of them in its subtree
    };
    void cut_tree();
    /// Panels that lie in one subtree each, or in the top.
    void find_panels();
    void forward(const Panel& panel, int rows, double* y) const;
    void backward(const Panel& panel, double* y) const;

    Eigen::SimplicialLDLT<Matrix, Eigen::Lower, EliminationOrder> factor_;
    Eigen::VectorXd inverse_diagonal_;
    std::vector<Subtree> subtrees_;
    std::vector<int> inside_end_;     ///< of a subtree's column: where its entries end that lie in the subtree
    std::vector<Panel> panels_;       ///< of the subtrees, then of the top
    std::vector<int> first_panel_;    ///< of every subtree, and of the top
    std::vector<int> top_;            ///< columns, ascending
    std::vector<int> crossing_begin_; ///< of every column in `top_`
    std::vector<Crossing> crossing_;  ///< ascending columns in each row
};

} // namespace gapflow
