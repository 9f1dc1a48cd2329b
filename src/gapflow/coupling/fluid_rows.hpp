// Rows of L and K of a coupled system, also across ranks.
#pragma once

#include "gapflow/core/sharing.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/coupling/coupling.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace gapflow {

/// Of K, or of what has a row for each of its rows. Rows: cells by their keys, nodes after them.
template <int D>
struct RowEntry {
    long row;
    int body;
    Twist<D> flux;
};

template <int D>
bool comes_before(const RowEntry<D>& a, const RowEntry<D>& b)
{
    return std::tie(a.row, a.body) < std::tie(b.row, b.body);
}

/// One entry a row and body, in their order.
template <int D>
void merge_entries(std::vector<RowEntry<D>>& entries)
{
    std::sort(entries.begin(), entries.end(), comes_before<D>);
    std::size_t count = 0;
    for (const RowEntry<D>& entry : entries)
        if (count > 0 && entries[count - 1].row == entry.row && entries[count - 1].body == entry.body)
            entries[count - 1].flux += entry.flux;
        else
            entries[count++] = entry;
    entries.resize(count);
}

/// Values of nodes as the ranks have them that own these. Collective.
template <int D>
void take_from_owners(const CoupledSystem<D>& system, Eigen::VectorXd& nodes)
{
    if (system.own_node.empty())
        return;
    for (int node = 0; node < system.nodes; ++node)
        if (!system.owns(node))
            nodes[node] = 0;
    system.grid->comm().sum(std::span<double>(nodes.data(), nodes.size()));
}

/// L, row by row.
template <int D>
class FluidRows {
public:
    explicit FluidRows(const Coupling<D>& coupling)
        : grid_(*coupling.grid), system_(coupling.system), cells_(grid_.cells().template cast<long>().prod()),
          own_(grid_.low(), grid_.high()), whole_(own_.size == cells_ && grid_.comm().size() == 1),
          linked_(own_.size + system_.nodes, 0)
    {
        for (std::size_t k = 0; k < system_.links.size(); ++k) {
            members_.push_back(members(system_.links[k]));
            for (const auto& [row, weight] : members_[k])
                if (owns(row)) {
                    links_.emplace_back(row, k);
                    linked_[local(row)] = 1;
                }
        }
        std::sort(links_.begin(), links_.end());
        links_.erase(std::unique(links_.begin(), links_.end()), links_.end());
    }

    const Grid<D>& grid() const { return grid_; }
    const CoupledSystem<D>& system() const { return system_; }
    long row(const Index<D>& c) const { return grid_.key(c); }
    long row(int node) const { return cells_ + node; }
    bool is_cell(long row) const { return row < cells_; }
    Index<D> cell(long row) const { return grid_.cell_of_key(row); }
    int node(long row) const { return static_cast<int>(row - cells_); }
    bool owns(long row) const { return whole_ || (is_cell(row) ? grid_.owns(cell(row)) : system_.owns(node(row))); }
    /// Numbers of own rows, cells before nodes. Their number.
    long local(const Index<D>& c) const { return own_.offset(c); }
    long local(int node) const { return own_.size + node; }
    long local(long row) const { return whole_ ? row : is_cell(row) ? local(cell(row)) : local(node(row)); }
    long stride(int axis) const { return own_.stride[axis]; }
    long locals() const { return own_.size + system_.nodes; }

    /// Calls f(other, coefficient) for the entries of an own row, several for one other row perhaps.
    template <class F>
    void for_each(long row, F&& f) const
    {
        if (is_cell(row))
            for_each_face(row, f);
        else
            for (Eigen::SparseMatrix<double>::InnerIterator entry(system_.film, node(row)); entry; ++entry)
                f(this->row(static_cast<int>(entry.row())), entry.value());
        for_each_link(row, [&](const Link& link, const auto& all) {
            double own = 0;
            for (const auto& [other, weight] : all)
                own += other == row ? weight : 0.0;
            for (const auto& [other, weight] : all)
                f(other, link.conductance * own * weight);
        });
    }

    /// Calls f(other, conductance) for the faces and the edges of the film from an own row to others.
    template <class F>
    void for_each_edge(long row, F&& f) const
    {
        const auto between = [&](long other, double value) {
            if (other != row && value < 0)
                f(other, -value);
        };
        if (is_cell(row))
            for_each_face(row, between);
        else
            for (Eigen::SparseMatrix<double>::InnerIterator entry(system_.film, node(row)); entry; ++entry)
                between(this->row(static_cast<int>(entry.row())), entry.value());
    }

    /// Calls f(link, its rows and weights) for the links of an own row.
    template <class F>
    void for_each_link(long row, F&& f) const
    {
        if (!linked_[local(row)])
            return;
        for (auto k = std::lower_bound(links_.begin(), links_.end(), std::pair(row, std::size_t{0}));
             k != links_.end() && k->first == row; ++k)
            f(system_.links[k->second], members_[k->second]);
    }
    bool linked(long row) const { return linked_[local(row)]; }
    /// Whether a row of another rank may look at this own one, over a face on its low side or a link.
    bool seen_from_below(long row) const
    {
        bool seen = linked(row);
        for (int axis = 0; axis < D && !seen && is_cell(row); ++axis)
            seen = grid_.neighbour(axis, 0) >= 0 && cell(row)[axis] == grid_.low()[axis];
        return seen;
    }

    /// No less than the row's entries of the links, whatever the signs: 2 diag(bound) - L is positive.
    double bound(long row) const
    {
        double sum = diagonal(row);
        if (linked(row))
            for_each_link(row, [&](const Link& link, const auto& all) {
                double own = 0, weights = 0;
                for (const auto& [other, weight] : all) {
                    own += other == row ? weight : 0.0;
                    weights += std::abs(weight);
                }
                if (all.size() > 2)
                    sum += link.conductance * std::abs(own) * (0.5 * weights - std::abs(own));
            });
        return sum;
    }
    double diagonal(long row) const
    {
        double sum = 0;
        if (is_cell(row) && !linked(row)) {
            const Index<D> c = cell(row);
            for (int axis = 0; axis < D; ++axis)
                sum += system_.conductance(axis, c) + system_.conductance(axis, Index<D>(c + step<D>(axis)));
            return sum;
        }
        for_each(row, [&](long other, double value) { sum += other == row ? value : 0.0; });
        return sum;
    }

private:
    template <class F>
    void for_each_face(long row, F&& f) const
    {
        const Index<D> c = cell(row);
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end) {
                const double g = system_.conductance(axis, end ? Index<D>(c + step<D>(axis)) : c);
                if (!(g > 0))
                    continue;
                f(row, g);
                const Index<D> beside = grid_.wrapped(end ? Index<D>(c + step<D>(axis)) : Index<D>(c - step<D>(axis)));
                if (grid_.in_domain(beside))
                    f(this->row(beside), -g);
            }
    }

    std::vector<std::pair<long, double>> members(const Link& link) const
    {
        std::vector<std::pair<long, double>> rows;
        for (const auto& [node, weight] : link.nodes)
            rows.emplace_back(row(node), weight);
        for (const auto& [key, weight] : link.cells)
            rows.emplace_back(row(grid_.cell_of_key(key)), weight);
        return rows;
    }

    const Grid<D>& grid_;
    const CoupledSystem<D>& system_;
    long cells_;
    Block<D> own_;
    bool whole_; ///< all rows are this rank's: their local numbers are theirs
    std::vector<char> linked_;
    std::vector<std::vector<std::pair<long, double>>> members_; ///< rows of each link
    std::vector<std::pair<long, std::size_t>> links_;           ///< own row, number of a link in it; by rows
};

/// Entries of own rows, found by them.
template <int D>
class BodyRows {
public:
    struct Entry {
        int body;
        Twist<D> flux;
    };

    BodyRows(const FluidRows<D>& rows, const std::vector<BodyFlux<D, Index<D>>>& cells,
             const std::vector<BodyFlux<D, int>>& nodes)
        : first_(rows.locals() + 1, 0)
    {
        const auto for_all = [&](auto&& f) {
            for (const auto& entry : cells)
                f(rows.local(entry.row), entry.body, entry.flux);
            for (const auto& entry : nodes)
                f(rows.local(entry.row), entry.body, entry.flux);
        };
        for_all([&](long row, int, const Twist<D>&) { ++first_[row + 1]; });
        for (std::size_t r = 1; r < first_.size(); ++r)
            first_[r] += first_[r - 1];
        entries_.resize(cells.size() + nodes.size());
        std::vector<std::int32_t> end(first_.begin(), first_.end() - 1);
        for_all([&](long row, int body, const Twist<D>& flux) {
            for (std::int32_t k = first_[row]; k < end[row]; ++k)
                if (entries_[k].body == body) {
                    entries_[k].flux += flux;
                    return;
                }
            entries_[end[row]++] = {body, flux};
        });
        end_ = std::move(end);
    }

    std::span<const Entry> of(long local) const
    {
        return {entries_.data() + first_[local], static_cast<std::size_t>(end_[local] - first_[local])};
    }
    std::span<Entry> of(long local)
    {
        return {entries_.data() + first_[local], static_cast<std::size_t>(end_[local] - first_[local])};
    }

private:
    std::vector<std::int32_t> first_, end_; ///< of each row
    std::vector<Entry> entries_;
};

} // namespace gapflow
