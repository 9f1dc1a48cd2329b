#include "gapflow/core/sparse_cholesky.hpp"

#include "gapflow/core/nested_dissection.hpp"
#include "gapflow/core/threads.hpp"

#include <Eigen/Dense>
#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace gapflow {

namespace {

// Smaller matrices stay as they are, in one piece: their vectors lie in a core's cache, and threads start for longer than they work.
constexpr long large = 20000; // rows
// Work of a subtree over that of the whole tree: less leaves more to the top, more leaves threads waiting for the last subtree.
constexpr double subtree_share = 1.0 / 64;
constexpr int wide = 4; // columns from which a panel's arithmetic is a block's
// Products a row that minimum degree may take before nested dissection is tried, whose order takes as long to find as some 100 000 products a row and saves up
// to three quarters of them, and half of the entries in each solve.
constexpr double many_products = 50000;

// Parents of the columns in the elimination tree (Liu 1986), entries below their diagonals, and the products that the factorisation takes.
struct Elimination {
    std::vector<int> parent; // -1: a root
    std::vector<int> below;
    double products = 0;
};

// Of a matrix with both triangles whose columns are eliminated in `order`.
Elimination elimination_of(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXi& order)
{
    const int n = static_cast<int>(a.cols());
    std::vector<int> place(n), parent(n, -1), row_seen(n, -1), below(n, 0);
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
    double products = 0;
    for (const int entries : below)
        products += static_cast<double>(entries) * entries;
    return {std::move(parent), std::move(below), products};
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

// Columns of an update that are one piece of work on all threads.
constexpr long tile = 96;

// The lower triangle of `update` -= below below^T.
template <class Below>
void subtract_square(const Below& below, Eigen::MatrixXd& update)
{
    const long rows = update.rows();
    if (below.cols() < wide) {
        for (int j = 0; j < below.cols(); ++j)
            for (long k = 0; k < rows; ++k)
                update.col(k).tail(rows - k) -= below(k, j) * below.col(j).tail(rows - k);
        return;
    }
    for_each_job(static_cast<int>((rows + tile - 1) / tile), [&](int k) {
        const long first = k * tile, columns = std::min(tile, rows - first), rest = rows - first - columns;
        const auto beside = below.middleRows(first, columns);
        update.block(first, first, columns, columns).template selfadjointView<Eigen::Lower>().rankUpdate(beside, -1.0);
        update.block(first + columns, first, rest, columns).noalias() -= below.bottomRows(rest) * beside.transpose();
    });
}

// Calls each(k, sum over the terms j of value(k, j) row(j)) for all k below `count`, four at a time: a row is read once for them.
template <class Value, class Row, class Each>
void for_sums(int count, int terms, Value&& value, Row&& row, Each&& each)
{
    using Sum = Eigen::Matrix<double, 1, std::remove_cvref_t<decltype(row(0))>::ColsAtCompileTime>;
    int k = 0;
    for (; k + 4 <= count; k += 4) {
        Sum s0 = Sum::Zero(), s1 = s0, s2 = s0, s3 = s0;
        for (int j = 0; j < terms; ++j) {
            const Sum from = row(j);
            s0 += value(k, j) * from;
            s1 += value(k + 1, j) * from;
            s2 += value(k + 2, j) * from;
            s3 += value(k + 3, j) * from;
        }
        each(k, s0);
        each(k + 1, s1);
        each(k + 2, s2);
        each(k + 3, s3);
    }
    for (; k < count; ++k) {
        Sum sum = Sum::Zero();
        for (int j = 0; j < terms; ++j)
            sum += value(k, j) * row(j);
        each(k, sum);
    }
}

} // namespace

// Minimum degree (Amestoy, Davis & Duff 1996), or nested dissection where that takes fewer products; then a postorder of the elimination tree, which changes no
// entry's place in the factor: what is eliminated in turn is close in memory, and every subtree is a run of columns.
struct SparseCholesky::Order {
    explicit Order(const Matrix& both_triangles);
    Eigen::VectorXi row_of, place_of; // of a place in the order, and back
    std::vector<int> parent;          // of every column in the elimination tree, -1: a root
    std::vector<int> below;           // entries of the factor's column below the diagonal
};

SparseCholesky::Order::Order(const Matrix& a) : place_of(a.cols())
{
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> minimum_degree;
    Eigen::AMDOrdering<int>()(a, minimum_degree);
    Eigen::VectorXi order = minimum_degree.indices();
    Elimination elimination = elimination_of(a, order);
    if (elimination.products > many_products * static_cast<double>(a.cols())) {
        const Eigen::VectorXi dissected = nested_dissection(a);
        Elimination other = elimination_of(a, dissected);
        if (other.products < elimination.products) {
            order = dissected;
            elimination = std::move(other);
        }
    }
    const std::vector<int> post = postorder(elimination.parent);
    const int n = static_cast<int>(post.size());
    std::vector<int> place_in_post(n);
    for (int k = 0; k < n; ++k)
        place_in_post[post[k]] = k;
    row_of.resize(n);
    for (int k = 0; k < n; ++k) {
        row_of[k] = order[post[k]];
        place_of[row_of[k]] = k;
        const int up = elimination.parent[post[k]];
        parent.push_back(up < 0 ? -1 : place_in_post[up]);
        below.push_back(elimination.below[post[k]]);
    }
}

void SparseCholesky::analyse(const Matrix& a)
{
    const Matrix both = a.selfadjointView<Eigen::Lower>();
    const Order order(both);
    row_of_ = order.row_of;
    place_of_ = order.place_of;
    cut_tree(order);
    find_panels(order, both);
    find_crossings();
}

bool SparseCholesky::factorise(const Matrix& a)
{
    Matrix lower(a.rows(), a.cols());
    lower.selfadjointView<Eigen::Lower>() =
        a.selfadjointView<Eigen::Lower>().twistedBy(Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>(place_of_));
    std::vector<Update> updates(panels_.size());
    const int subtrees = static_cast<int>(subtrees_.size());
    std::vector<char> failed(subtrees, 0);
    for_each_job(subtrees, [&](int s) {
        for (int k = first_panel_[s]; k < first_panel_[s + 1] && !failed[s]; ++k)
            failed[s] = !eliminate(k, lower, updates);
    });
    if (std::find(failed.begin(), failed.end(), 1) != failed.end())
        return false;
    const int panels = static_cast<int>(panels_.size());
    for (int k = subtrees > 0 ? first_panel_.back() : 0; k < panels; ++k)
        if (!eliminate(k, lower, updates))
            return false;
    return true;
}

bool SparseCholesky::compute(const Matrix& a)
{
    analyse(a);
    return factorise(a);
}

void SparseCholesky::cut_tree(const Order& order)
{
    const int n = static_cast<int>(order.parent.size());
    top_.clear();
    subtrees_.clear();
    if (n < large) {
        if (n > 0)
            subtrees_ = {{0, n}};
        return;
    }
    std::vector<long> work(n); // of the subtree below a column
    std::vector<int> first(n); // its first column
    std::iota(first.begin(), first.end(), 0);
    long whole = 0;
    for (int j = 0; j < n; ++j) {
        work[j] += order.below[j] + 1;
        whole += order.below[j] + 1;
        if (const int parent = order.parent[j]; parent >= 0) {
            work[parent] += work[j];
            first[parent] = std::min(first[parent], first[j]);
        }
    }
    const auto in_top = [&](int j) { return static_cast<double>(work[j]) > subtree_share * static_cast<double>(whole); };
    for (int j = 0; j < n; ++j)
        if (in_top(j))
            top_.push_back(j);
        else if (order.parent[j] < 0 || in_top(order.parent[j]))
            subtrees_.push_back({first[j], j + 1});
}

void SparseCholesky::find_panels(const Order& order, const Matrix& both_triangles)
{
    panels_.clear();
    first_panel_.clear();
    rows_.clear();
    child_.clear();
    child_begin_ = {0};
    const int n = static_cast<int>(order.parent.size());
    std::vector<int> child_of(n, -1), next; // panels by the column that is their parent
    std::vector<int> seen(n, -1);
    long values = 0;
    // Columns low .. high - 1, in the subtree that ends at `last`.
    const auto add_run = [&](int low, int high, int last) {
        for (int j = low, end; j < high; j = end) {
            end = j + 1;
            while (end < high && order.parent[end - 1] == end && order.below[end - 1] == order.below[end] + 1)
                ++end;
            const int number = static_cast<int>(panels_.size()), first = static_cast<int>(rows_.size());
            const auto add = [&](int row) {
                if (row >= end && seen[row] != number) {
                    seen[row] = number;
                    rows_.push_back(row);
                }
            };
            for (int column = j; column < end; ++column) {
                for (Matrix::InnerIterator entry(both_triangles, row_of_[column]); entry; ++entry)
                    add(place_of_[entry.row()]);
                for (int child = child_of[column]; child >= 0; child = next[child]) {
                    child_.push_back(child);
                    for (int k = 0; k < panels_[child].rows; ++k)
                        add(rows_[panels_[child].first_row + k]);
                }
            }
            child_begin_.push_back(static_cast<int>(child_.size()));
            std::sort(rows_.begin() + first, rows_.end());
            const int inside =
                static_cast<int>(std::upper_bound(rows_.begin() + first, rows_.end(), last) - rows_.begin()) - first;
            panels_.push_back({j, end, static_cast<int>(rows_.size()) - first, inside, first, values});
            values += static_cast<long>(panels_.back().height()) * panels_.back().columns();
            next.push_back(-1);
            if (const int parent = order.parent[end - 1]; parent >= 0)
                next.back() = std::exchange(child_of[parent], number);
        }
    };
    for (const auto& [low, high] : subtrees_) {
        first_panel_.push_back(static_cast<int>(panels_.size()));
        add_run(low, high, high - 1);
    }
    first_panel_.push_back(static_cast<int>(panels_.size()));
    for (std::size_t t = 0, end; t < top_.size(); t = end) {
        for (end = t + 1; end < top_.size() && top_[end] == top_[end - 1] + 1;)
            ++end;
        add_run(top_[t], top_[end - 1] + 1, n - 1);
    }
    values_.assign(values, 0.0);
    inverse_diagonal_.assign(n, 0.0);
}

void SparseCholesky::find_crossings()
{
    crossing_.clear();
    crossing_begin_.assign(top_.size() + 1, 0);
    std::vector<int> place_in_top(row_of_.size(), -1);
    for (std::size_t t = 0; t < top_.size(); ++t)
        place_in_top[top_[t]] = static_cast<int>(t);
    const int below_top = first_panel_.back();
    const auto for_each_crossing = [&](auto&& f) {
        for (int p = 0; p < below_top; ++p)
            for (int k = panels_[p].inside; k < panels_[p].rows; ++k)
                f(place_in_top[rows_[panels_[p].first_row + k]], Crossing{p, k});
    };
    for_each_crossing([&](int t, const Crossing&) { ++crossing_begin_[t + 1]; });
    std::partial_sum(crossing_begin_.begin(), crossing_begin_.end(), crossing_begin_.begin());
    crossing_.resize(crossing_begin_.back());
    std::vector<int> next(crossing_begin_.begin(), crossing_begin_.end() - 1);
    for_each_crossing([&](int t, const Crossing& crossing) { crossing_[next[t]++] = crossing; });
}

bool SparseCholesky::eliminate(int number, const Matrix& lower, std::vector<Update>& updates)
{
    const Panel& panel = panels_[number];
    const int columns = panel.columns(), rows = panel.rows;
    const int* const row = rows_.data() + panel.first_row;
    static thread_local std::vector<int> place; // of a row in the panel's matrix
    place.resize(std::max<std::size_t>(place.size(), row_of_.size()));
    for (int j = 0; j < columns; ++j)
        place[panel.begin + j] = j;
    for (int k = 0; k < rows; ++k)
        place[row[k]] = columns + k;

    Eigen::Map<Eigen::MatrixXd> own(values_.data() + panel.first_value, panel.height(), columns);
    Update& update = updates[number];
    own.setZero();
    update.setZero(rows, rows);
    for (int j = 0; j < columns; ++j)
        for (Matrix::InnerIterator entry(lower, panel.begin + j); entry; ++entry)
            own(place[entry.row()], j) = entry.value();
    static thread_local std::vector<int> to; // of a child's rows
    for (int c = child_begin_[number]; c < child_begin_[number + 1]; ++c) {
        const Panel& child = panels_[child_[c]];
        Update& from = updates[child_[c]];
        to.clear();
        for (int k = 0; k < child.rows; ++k)
            to.push_back(place[rows_[child.first_row + k]]);
        for (int j = 0; j < child.rows; ++j) {
            double* const column = to[j] < columns ? own.col(to[j]).data() : update.col(to[j] - columns).data() - columns;
            for (int k = j; k < child.rows; ++k)
                column[to[k]] += from(k, j);
        }
        from.resize(0, 0);
    }

    if (columns < wide) {
        for (int j = 0; j < columns; ++j) {
            if (!(own(j, j) > 0)) // nor a number
                return false;
            auto column = own.col(j).tail(panel.height() - j);
            column *= 1 / std::sqrt(own(j, j));
            for (int k = j + 1; k < columns; ++k)
                own.col(k).tail(panel.height() - k) -= own(k, j) * own.col(j).tail(panel.height() - k);
        }
    } else {
        auto diagonal = own.topRows(columns);
        const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(diagonal);
        if (factor.info() != Eigen::Success || !(diagonal.diagonal().array() > 0).all())
            return false;
        auto below = own.bottomRows(rows);
        diagonal.transpose().triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(below);
    }
    for (int j = 0; j < columns; ++j)
        inverse_diagonal_[panel.begin + j] = 1 / own(j, j);
    subtract_square(own.bottomRows(rows), update);
    return true;
}

void SparseCholesky::forward(const Panel& panel, int rows, double* y) const
{
    const int columns = panel.columns(), height = panel.height();
    const double* const value = values_.data() + panel.first_value;
    const int* const row = rows_.data() + panel.first_row;
    double* const own = y + panel.begin;
    const auto below = [&](int j) { return value + static_cast<long>(j) * height + columns; };
    for (int j = 0; j < columns; ++j) {
        const double mine = own[j] *= inverse_diagonal_[panel.begin + j];
        const double* const v = value + static_cast<long>(j) * height;
        for (int k = j + 1; k < columns; ++k)
            own[k] -= v[k] * mine;
    }
    if (columns < wide) {
        for (int j = 0; j < columns; ++j)
            for (int k = 0; k < rows; ++k)
                y[row[k]] -= below(j)[k] * own[j];
        return;
    }
    static thread_local std::vector<double> sums;
    sums.assign(rows, 0.0);
    double* const sum = sums.data();
    int j = 0;
    for (; j + 4 <= columns; j += 4) {
        const double *v0 = below(j), *v1 = below(j + 1), *v2 = below(j + 2), *v3 = below(j + 3);
        const double y0 = own[j], y1 = own[j + 1], y2 = own[j + 2], y3 = own[j + 3];
        for (int k = 0; k < rows; ++k)
            sum[k] += (v0[k] * y0 + v1[k] * y1) + (v2[k] * y2 + v3[k] * y3);
    }
    for (; j < columns; ++j) {
        const double *v = below(j), mine = own[j];
        for (int k = 0; k < rows; ++k)
            sum[k] += v[k] * mine;
    }
    for (int k = 0; k < rows; ++k)
        y[row[k]] -= sum[k];
}

void SparseCholesky::backward(const Panel& panel, double* y) const
{
    const int columns = panel.columns(), rows = panel.rows, height = panel.height();
    const double* const value = values_.data() + panel.first_value;
    const int* const row = rows_.data() + panel.first_row;
    double* const own = y + panel.begin;
    static thread_local std::vector<double> gathered;
    gathered.resize(rows);
    double* const from = gathered.data();
    for (int k = 0; k < rows; ++k)
        from[k] = y[row[k]];
    for (int j = columns - 1; j >= 0; --j) {
        const double* const v = value + static_cast<long>(j) * height;
        const double* const below = v + columns;
        double sum = 0;
#pragma omp simd reduction(+ : sum)
        for (int k = j + 1; k < columns; ++k)
            sum += v[k] * own[k];
#pragma omp simd reduction(+ : sum)
        for (int k = 0; k < rows; ++k)
            sum += below[k] * from[k];
        own[j] = (own[j] - sum) * inverse_diagonal_[panel.begin + j];
    }
}

Eigen::VectorXd SparseCholesky::solve(const Eigen::VectorXd& b) const
{
    const int subtrees = static_cast<int>(subtrees_.size());
    Eigen::VectorXd x(b.size()), y(b.size());

    for_each_job(subtrees, [&](int s) {
        for (int j = subtrees_[s].begin; j < subtrees_[s].end; ++j)
            y[j] = b[row_of_[j]];
        for (int k = first_panel_[s]; k < first_panel_[s + 1]; ++k)
            forward(panels_[k], panels_[k].inside, y.data());
    });
    for_each_part(static_cast<long>(top_.size()), [&](long low, long high) {
        for (long t = low; t < high; ++t) {
            double sum = b[row_of_[top_[t]]];
            for (int k = crossing_begin_[t]; k < crossing_begin_[t + 1]; ++k) {
                const Panel& panel = panels_[crossing_[k].panel];
                const double* const value = values_.data() + panel.first_value + panel.columns() + crossing_[k].row;
                for (int j = 0; j < panel.columns(); ++j)
                    sum -= value[static_cast<long>(j) * panel.height()] * y[panel.begin + j];
            }
            y[top_[t]] = sum;
        }
    });
    const int first_of_top = subtrees > 0 ? first_panel_.back() : 0, panels = static_cast<int>(panels_.size());
    for (int k = first_of_top; k < panels; ++k)
        forward(panels_[k], panels_[k].rows, y.data());
    for (int k = panels; k-- > first_of_top;)
        backward(panels_[k], y.data());
    for (int j : top_)
        x[row_of_[j]] = y[j];
    for_each_job(subtrees, [&](int s) {
        for (int k = first_panel_[s + 1]; k-- > first_panel_[s];)
            backward(panels_[k], y.data());
        for (int j = subtrees_[s].begin; j < subtrees_[s].end; ++j)
            x[row_of_[j]] = y[j];
    });
    return x;
}

void SparseCholesky::forward(const Panel& panel, RightSides& y) const
{
    const int columns = panel.columns(), height = panel.height();
    if (y.middleRows(panel.begin, columns).isZero(0))
        return;
    const double* const value = values_.data() + panel.first_value;
    for (int j = 0; j < columns; ++j) {
        const RightSide mine = y.row(panel.begin + j) *= inverse_diagonal_[panel.begin + j];
        for (int k = j + 1; k < columns; ++k)
            y.row(panel.begin + k) -= value[static_cast<long>(j) * height + k] * mine;
    }
    const int* const row = rows_.data() + panel.first_row;
    for_sums(
        panel.rows, columns, [&](int k, int j) { return value[static_cast<long>(j) * height + columns + k]; },
        [&](int j) { return y.row(panel.begin + j); }, [&](int k, const RightSide& sum) { y.row(row[k]) -= sum; });
}

void SparseCholesky::backward(const Panel& panel, RightSides& y) const
{
    const int columns = panel.columns(), height = panel.height();
    const double* const value = values_.data() + panel.first_value;
    const int* const row = rows_.data() + panel.first_row;
    for_sums(
        columns, panel.rows, [&](int j, int k) { return value[static_cast<long>(j) * height + columns + k]; },
        [&](int k) { return y.row(row[k]); }, [&](int j, const RightSide& sum) { y.row(panel.begin + j) -= sum; });
    for (int j = columns - 1; j >= 0; --j) {
        RightSide sum = y.row(panel.begin + j);
        for (int k = j + 1; k < columns; ++k)
            sum -= value[static_cast<long>(j) * height + k] * y.row(panel.begin + k);
        y.row(panel.begin + j) = sum * inverse_diagonal_[panel.begin + j];
    }
}

Eigen::MatrixXd SparseCholesky::solve_columns(const Eigen::MatrixXd& b) const
{
    Eigen::MatrixXd x(b.rows(), b.cols());
    RightSides y(b.rows(), together);
    for (long first = 0; first < b.cols(); first += together) {
        const long count = std::min<long>(together, b.cols() - first);
        y.setZero();
        for (long j = 0; j < b.rows(); ++j)
            y.row(j).head(count) = b.row(row_of_[j]).segment(first, count);
        for (const Panel& panel : panels_)
            forward(panel, y);
        for (std::size_t p = panels_.size(); p-- > 0;)
            backward(panels_[p], y);
        for (long j = 0; j < b.rows(); ++j)
            x.row(row_of_[j]).segment(first, count) = y.row(j).head(count);
    }
    return x;
}

long SparseCholesky::entries() const
{
    long sum = 0;
    for (const Panel& panel : panels_)
        sum += static_cast<long>(panel.columns()) * panel.rows + static_cast<long>(panel.columns()) * (panel.columns() - 1) / 2;
    return sum;
}

long SparseCholesky::bytes() const
{
    return static_cast<long>(8 * (values_.size() + inverse_diagonal_.size() + crossing_.size()) +
                             4 * (rows_.size() + row_of_.size() + place_of_.size()) + sizeof(Panel) * panels_.size());
}

} // namespace gapflow
