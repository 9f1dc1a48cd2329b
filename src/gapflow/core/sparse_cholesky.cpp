#include "gapflow/core/sparse_cholesky.hpp"

#include "gapflow/core/nested_dissection.hpp"
#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <numeric>

namespace gapflow {

namespace {

// Smaller matrices stay as they are, in one piece: their vectors lie in a core's cache, and threads start for longer than they work.
constexpr long large = 20000; // rows
// Work of a subtree over that of the whole tree: less leaves more to the top, more leaves threads waiting for the last subtree.
constexpr double subtree_share = 1.0 / 64;
constexpr int wide = 4; // columns from which a panel's arithmetic is a block's
// Products a row that minimum degree may take before nested dissection is tried. To find its order takes as long as some 10 000 products a row.
constexpr double many_products = 20000;

// Parents of the columns in the elimination tree (Liu 1986), and the products that the factorisation takes.
struct Elimination {
    std::vector<int> parent; // -1: a root
    double products = 0;
};

// Of a matrix with both triangles whose columns are eliminated in `order`.
Elimination elimination_of(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXi& order)
{
    const int n = static_cast<int>(a.cols());
    std::vector<int> place(n), parent(n, -1), row_seen(n, -1);
    std::vector<double> below(n, 0); // entries of the factor's column
    for (int k = 0; k < n; ++k)
        place[order[k]] = k;
    for (int k = 0; k < n; ++k) {
        row_seen[k] = k;
        for (Eigen::SparseMatrix<double>::InnerIterator entry(a, order[k]); entry; ++entry)
            for (int i = place[entry.row()]; i < k && row_seen[i] != k; i = parent[i]) { // the factor's entries of row k
                if (parent[i] < 0)
                    parent[i] = k;
                row_seen[i] = k;
                ++below[i];
            }
    }
    const double products = std::accumulate(below.begin(), below.end(), 0.0, [](double sum, double b) { return sum + b * b; });
    return {std::move(parent), products};
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
    Elimination elimination = elimination_of(a, order.indices());
    const bool dense = elimination.products > many_products * static_cast<double>(a.cols());
    if (dense) {
        const Eigen::VectorXi dissected = nested_dissection(a);
        Elimination other = elimination_of(a, dissected);
        if (other.products < elimination.products) {
            order.indices() = dissected;
            elimination = std::move(other);
        }
    }
    if (a.cols() < large)
        return;
    const Eigen::VectorXi before = order.indices();
    const std::vector<int> post = postorder(elimination.parent);
    for (std::size_t k = 0; k < post.size(); ++k)
        order.indices()[static_cast<long>(k)] = before[post[k]];
}

void SparseCholesky::analyse(const Matrix& a)
{
    factor_.analyzePattern(a);
    subtrees_.clear();
}

bool SparseCholesky::factorise(const Matrix& a)
{
    factor_.factorize(a);
    if (factor_.info() != Eigen::Success)
        return false;
    inverse_diagonal_ = factor_.vectorD();
    if (!(inverse_diagonal_.array() > 0).all())
        return false;
    inverse_diagonal_ = inverse_diagonal_.cwiseInverse();
    if (subtrees_.empty() && a.cols() > 0) {
        cut_tree();
        find_panels();
    }
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

void SparseCholesky::find_panels()
{
    const Matrix& L = factor_.matrixL().nestedExpression();
    const int *begin = L.outerIndexPtr(), *row = L.innerIndexPtr();
    panels_.clear();
    first_panel_.clear();
    const auto add_run = [&](int low, int high) {
        for (int j = low, end; j < high; j = end) {
            end = j + 1;
            while (end < high && begin[end - 1] < begin[end] && row[begin[end - 1]] == end &&
                   begin[end] - begin[end - 1] == begin[end + 1] - begin[end] + 1)
                ++end;
            panels_.push_back({j, end, begin[end] - begin[end - 1], inside_end_[end - 1] - begin[end - 1]});
        }
    };
    for (const auto& [low, high] : subtrees_) {
        first_panel_.push_back(static_cast<int>(panels_.size()));
        add_run(low, high);
    }
    first_panel_.push_back(static_cast<int>(panels_.size()));
    for (std::size_t t = 0, end; t < top_.size(); t = end) {
        for (end = t + 1; end < top_.size() && top_[end] == top_[end - 1] + 1;)
            ++end;
        add_run(top_[t], top_[end - 1] + 1);
    }
}

void SparseCholesky::forward(const Panel& panel, int rows, double* y) const
{
    const Matrix& L = factor_.matrixL().nestedExpression();
    const int* begin = L.outerIndexPtr();
    const double* value = L.valuePtr();
    if (panel.end - panel.begin < wide) {
        const int outside = panel.rows - rows;
        for (int j = panel.begin; j < panel.end; ++j) {
            const double mine = y[j];
            for (int q = begin[j]; q < begin[j + 1] - outside; ++q)
                y[L.innerIndexPtr()[q]] -= value[q] * mine;
        }
        return;
    }
    const int* row = L.innerIndexPtr() + begin[panel.end - 1];
    static thread_local std::vector<double> sums;
    sums.resize(rows);
    double* const sum = sums.data();
    for (int j = panel.begin; j < panel.end; ++j) {
        const double mine = y[j];
        const double* const v = value + begin[j];
        const int within = panel.end - 1 - j;
        double* const next = y + j + 1;
        for (int k = 0; k < within; ++k)
            next[k] -= v[k] * mine;
    }
    int j = panel.begin;
    const auto below = [&](int column) { return value + begin[column] + (panel.end - 1 - column); };
    std::fill_n(sum, rows, 0.0);
    for (; j + 4 <= panel.end; j += 4) {
        const double *v0 = below(j), *v1 = below(j + 1), *v2 = below(j + 2), *v3 = below(j + 3);
        const double y0 = y[j], y1 = y[j + 1], y2 = y[j + 2], y3 = y[j + 3];
        for (int i = 0; i < rows; ++i)
            sum[i] += (v0[i] * y0 + v1[i] * y1) + (v2[i] * y2 + v3[i] * y3);
    }
    for (; j < panel.end; ++j) {
        const double *v = below(j), mine = y[j];
        for (int i = 0; i < rows; ++i)
            sum[i] += v[i] * mine;
    }
    for (int i = 0; i < rows; ++i)
        y[row[i]] -= sum[i];
}

void SparseCholesky::backward(const Panel& panel, double* y) const
{
    const Matrix& L = factor_.matrixL().nestedExpression();
    const int* begin = L.outerIndexPtr();
    const double* value = L.valuePtr();
    if (panel.end - panel.begin < wide) {
        for (int j = panel.end - 1; j >= panel.begin; --j) {
            double sum = inverse_diagonal_[j] * y[j];
            for (int q = begin[j]; q < begin[j + 1]; ++q)
                sum -= value[q] * y[L.innerIndexPtr()[q]];
            y[j] = sum;
        }
        return;
    }
    const int* row = L.innerIndexPtr() + begin[panel.end - 1];
    const int rows = panel.rows;
    static thread_local std::vector<double> gathered;
    gathered.resize(rows);
    double* const from = gathered.data();
    for (int i = 0; i < rows; ++i)
        from[i] = y[row[i]];
    for (int j = panel.end - 1; j >= panel.begin; --j) {
        const double* const v = value + begin[j];
        const int within = panel.end - 1 - j;
        const double *const next = y + j + 1, *const below = v + within;
        double sum = 0;
#pragma omp simd reduction(+ : sum)
        for (int k = 0; k < within; ++k)
            sum += v[k] * next[k];
#pragma omp simd reduction(+ : sum)
        for (int i = 0; i < rows; ++i)
            sum += below[i] * from[i];
        y[j] = inverse_diagonal_[j] * y[j] - sum;
    }
}

Eigen::VectorXd SparseCholesky::solve(const Eigen::VectorXd& b) const
{
    const double* value = factor_.matrixL().nestedExpression().valuePtr();
    const auto& row_of = factor_.permutationPinv().indices(); // of a column in elimination order
    const int subtrees = static_cast<int>(subtrees_.size());
    Eigen::VectorXd x(b.size()), y(b.size());

    for_each_job(subtrees, [&](int s) {
        for (int j = subtrees_[s].begin; j < subtrees_[s].end; ++j)
            y[j] = b[row_of[j]];
        for (int k = first_panel_[s]; k < first_panel_[s + 1]; ++k)
            forward(panels_[k], panels_[k].inside, y.data());
    });
    for_each_part(static_cast<long>(top_.size()), [&](long low, long high) {
        for (long t = low; t < high; ++t) {
            double sum = b[row_of[top_[t]]];
            for (int k = crossing_begin_[t]; k < crossing_begin_[t + 1]; ++k)
                sum -= value[crossing_[k].entry] * y[crossing_[k].column];
            y[top_[t]] = sum;
        }
    });
    const int first_of_top = subtrees > 0 ? first_panel_.back() : 0, panels = static_cast<int>(panels_.size());
    for (int k = first_of_top; k < panels; ++k)
        forward(panels_[k], panels_[k].rows, y.data());
    for (int k = panels; k-- > first_of_top;)
        backward(panels_[k], y.data());
    for (int j : top_)
        x[row_of[j]] = y[j];
    for_each_job(subtrees, [&](int s) {
        for (int k = first_panel_[s + 1]; k-- > first_panel_[s];)
            backward(panels_[k], y.data());
        for (int j = subtrees_[s].begin; j < subtrees_[s].end; ++j)
            x[row_of[j]] = y[j];
    });
    return x;
}

Eigen::MatrixXd SparseCholesky::solve_columns(const Eigen::MatrixXd& b) const
{
    constexpr int width = 8; // columns that an entry of the factor is read for at once
    using Row = Eigen::Matrix<double, 1, width>;
    const Matrix& L = factor_.matrixL().nestedExpression();
    const int *begin = L.outerIndexPtr(), *row = L.innerIndexPtr(), n = static_cast<int>(b.rows());
    const double* value = L.valuePtr();
    const auto& row_of = factor_.permutationPinv().indices(); // of a column in elimination order
    Eigen::MatrixXd x(b.rows(), b.cols());
    Eigen::Matrix<double, Eigen::Dynamic, width, Eigen::RowMajor> y(b.rows(), width);
    for (long first = 0; first < b.cols(); first += width) {
        const long count = std::min<long>(width, b.cols() - first);
        y.setZero();
        for (int j = 0; j < n; ++j)
            y.row(j).head(count) = b.row(row_of[j]).segment(first, count);
        for (int j = 0; j < n; ++j)
            if (const Row mine = y.row(j); !mine.isZero(0))
                for (int q = begin[j]; q < begin[j + 1]; ++q)
                    y.row(row[q]) -= value[q] * mine;
        for (int j = n - 1; j >= 0; --j) {
            Row sum = inverse_diagonal_[j] * y.row(j);
            for (int q = begin[j]; q < begin[j + 1]; ++q)
                sum -= value[q] * y.row(row[q]);
            y.row(j) = sum;
            x.row(row_of[j]).segment(first, count) = sum.head(count);
        }
    }
    return x;
}

long SparseCholesky::entries() const
{
    return static_cast<long>(factor_.matrixL().nestedExpression().nonZeros());
}

} // namespace gapflow
