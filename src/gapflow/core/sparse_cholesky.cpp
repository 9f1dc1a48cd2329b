#include "gapflow/core/sparse_cholesky.hpp"

#include "gapflow/core/threads.hpp"

#include <numeric>

namespace gapflow {

namespace {

// Smaller matrices stay as they are, in one piece: their vectors lie in a core's cache, and threads start for longer than they work.
constexpr long large = 20000; // rows
// Work of a subtree over that of the whole tree: less leaves more to the top, more leaves threads waiting for the last subtree.
constexpr double subtree_share = 1.0 / 64;

// Parent of every column in the elimination tree, of a matrix with both triangles whose columns are eliminated in `order` (Liu 1986).
std::vector<int> elimination_tree(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXi& order)
{
    const int n = static_cast<int>(a.cols());
    std::vector<int> place(n), parent(n, -1), ancestor(n, -1);
    for (int k = 0; k < n; ++k)
        place[order[k]] = k;
    for (int k = 0; k < n; ++k)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(a, order[k]); entry; ++entry)
            for (int i = place[entry.row()]; i < k;) {
                const int next = ancestor[i];
                ancestor[i] = k; // paths are compressed
                if (next == k)
                    break;
                if (next < 0) {
                    parent[i] = k;
                    break;
                }
                i = next;
            }
    return parent;
}

// Children before parents, and every subtree in one run.
std::vector<int> postorder(const std::vector<int>& parent)
{
    const int n = static_cast<int>(parent.size());
    std::vector<int> child(n, -1), sibling(n, -1), path, order;
    for (int k = n - 1; k >= 0; --k)
        if (parent[k] >= 0) {
            sibling[k] = child[parent[k]];
            child[parent[k]] = k;
        }
    order.reserve(n);
    for (int root = 0; root < n; ++root) {
        if (parent[root] >= 0)
            continue;
        path.push_back(root);
        while (!path.empty()) {
            const int k = path.back();
            if (child[k] >= 0) {
                path.push_back(child[k]);
                child[k] = sibling[child[k]];
            } else {
                order.push_back(k);
                path.pop_back();
            }
        }
    }
    return order;
}

} // namespace

void EliminationOrder::operator()(const Eigen::SparseMatrix<double>& a, Permutation& order) const
{
    Eigen::AMDOrdering<int>()(a, order);
    if (a.cols() < large)
        return;
    const Eigen::VectorXi minimum_degree = order.indices();
    const std::vector<int> post = postorder(elimination_tree(a, minimum_degree));
    for (std::size_t k = 0; k < post.size(); ++k)
        order.indices()[static_cast<long>(k)] = minimum_degree[post[k]];
}

void SparseCholesky::analyse(const Matrix& a)
{
    factor_.analyzePattern(a);
    subtrees_.clear();
}

bool SparseCholesky::factorise(const Matrix& a)
{
    factor_.factorize(a);
    if (factor_.info() != Eigen::Success || !(factor_.vectorD().array() > 0).all())
        return false;
    if (subtrees_.empty() && a.cols() > 0)
        cut_tree();
    return true;
}

bool SparseCholesky::compute(const Matrix& a)
{
    analyse(a);
    return factorise(a);
}

void SparseCholesky::cut_tree()
{
    const Matrix& L = factor_.matrixL().nestedExpression();
    const int n = static_cast<int>(L.cols());
    top_.clear();
    crossing_.clear();
    const int *begin = L.outerIndexPtr(), *row = L.innerIndexPtr();
    inside_end_.assign(begin + 1, begin + n + 1);
    if (n < large) {
        subtrees_ = {{0, n}};
        crossing_begin_ = {0};
        return;
    }
    std::vector<long> work(n);        // of the subtree below a column
    std::vector<int> first(n, n);     // its first column
    std::vector<int> place_in_top(n); // -1: in a subtree
    long whole = 0;
    for (int j = 0; j < n; ++j) {
        work[j] += begin[j + 1] - begin[j] + 1;
        whole += begin[j + 1] - begin[j] + 1;
        first[j] = std::min(first[j], j);
        if (begin[j] < begin[j + 1]) {
            const int parent = row[begin[j]];
            work[parent] += work[j];
            first[parent] = std::min(first[parent], first[j]);
        }
    }
    const auto in_top = [&](int j) { return static_cast<double>(work[j]) > subtree_share * static_cast<double>(whole); };
    for (int j = 0; j < n; ++j) {
        place_in_top[j] = in_top(j) ? static_cast<int>(top_.size()) : -1;
        if (in_top(j))
            top_.push_back(j);
        else if (begin[j] == begin[j + 1] || in_top(row[begin[j]]))
            subtrees_.push_back({first[j], j + 1});
    }
    crossing_begin_.assign(top_.size() + 1, 0);
    for (const auto& [low, high] : subtrees_)
        for (int j = low; j < high; ++j) {
            while (inside_end_[j] > begin[j] && row[inside_end_[j] - 1] >= high)
                --inside_end_[j];
            for (int q = inside_end_[j]; q < begin[j + 1]; ++q)
                ++crossing_begin_[place_in_top[row[q]] + 1];
        }
    std::partial_sum(crossing_begin_.begin(), crossing_begin_.end(), crossing_begin_.begin());
    crossing_.resize(crossing_begin_.back());
    std::vector<int> next(crossing_begin_.begin(), crossing_begin_.end() - 1);
    for (const auto& [low, high] : subtrees_)
        for (int j = low; j < high; ++j)
            for (int q = inside_end_[j]; q < begin[j + 1]; ++q)
                crossing_[next[place_in_top[row[q]]]++] = {j, q};
}

Eigen::VectorXd SparseCholesky::solve(const Eigen::VectorXd& b) const
{
    const Matrix& L = factor_.matrixL().nestedExpression();
    const int *begin = L.outerIndexPtr(), *row = L.innerIndexPtr();
    const double* value = L.valuePtr();
    const auto& row_of = factor_.permutationPinv().indices(); // of a column in elimination order
    const auto& diagonal = factor_.vectorD();
    const int subtrees = static_cast<int>(subtrees_.size());
    Eigen::VectorXd x(b.size()), y(b.size());

    const auto forward = [&](int j, int end) {
        const double mine = y[j];
        for (int q = begin[j]; q < end; ++q)
            y[row[q]] -= value[q] * mine;
    };
    const auto backward = [&](int j) {
        double sum = (1 / diagonal[j]) * y[j];
        for (int q = begin[j]; q < begin[j + 1]; ++q)
            sum -= value[q] * y[row[q]];
        y[j] = sum;
        x[row_of[j]] = sum;
    };
    for_each_job(subtrees, [&](int s) {
        const auto [low, high] = subtrees_[s];
        for (int j = low; j < high; ++j)
            y[j] = b[row_of[j]];
        for (int j = low; j < high; ++j)
            forward(j, inside_end_[j]);
    });
    for_each_part(static_cast<long>(top_.size()), [&](long low, long high) {
        for (long t = low; t < high; ++t) {
            double sum = b[row_of[top_[t]]];
            for (int k = crossing_begin_[t]; k < crossing_begin_[t + 1]; ++k)
                sum -= value[crossing_[k].entry] * y[crossing_[k].column];
            y[top_[t]] = sum;
        }
    });
    for (int j : top_)
        forward(j, begin[j + 1]);
    for (std::size_t t = top_.size(); t-- > 0;)
        backward(top_[t]);
    for_each_job(subtrees, [&](int s) {
        const auto [low, high] = subtrees_[s];
        for (int j = high - 1; j >= low; --j)
            backward(j);
    });
    return x;
}

Eigen::MatrixXd SparseCholesky::solve_columns(const Eigen::MatrixXd& b) const
{
    return factor_.solve(b);
}

long SparseCholesky::entries() const
{
    return static_cast<long>(factor_.matrixL().nestedExpression().nonZeros());
}

} // namespace gapflow
