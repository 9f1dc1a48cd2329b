// Union-find on each rank's cells; then every local part takes the lowest label among its neighbours on other ranks until
// nothing changes.

#include "gapflow/solver/grid_parts.hpp"

#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/core/sharing.hpp"
#include "gapflow/core/sort_unique.hpp"

#include <algorithm>
#include <numeric>

namespace gapflow {

namespace {

/// The parts of this rank's own cells, then of all ranks'.
template <int D>
class PartFinder {
public:
    explicit PartFinder(const CoupledSystem<D>& system)
        : system_(system), grid_(*system.grid), block_(grid_.low(), grid_.high()), sets_(static_cast<int>(block_.size)),
          label_(block_.size, -1)
    {
        for_each_index<D>(grid_.low(), grid_.high(), [&](const Index<D>& c) {
            const int i = static_cast<int>(block_.offset(c));
            for (int axis = 0; axis < D; ++axis)
                if (c[axis] > grid_.low()[axis] && system_.conductance(axis, c) > 0)
                    sets_.join(i, i - static_cast<int>(block_.stride[axis]));
        });
        for_each_index<D>(grid_.low(), grid_.high(), [&](const Index<D>& c) {
            if (system_.component(c) < 0)
                return;
            long& l = label(c);
            const long key = grid_.key(c);
            l = l < 0 ? key : std::min(l, key);
        });
    }

    /// Labels of parts that touch across ranks become the same.
    void join_ranks()
    {
        CellField<D, double> seen(grid_, -1.0); // a double holds every key
        for (bool changed = true; changed;) {
            for_each_index<D>(grid_.low(), grid_.high(), [&](const Index<D>& c) { seen(c) = static_cast<double>(label(c)); });
            exchange(grid_, seen, 1);
            changed = false;
            for (int side = 0; side < 2 * D; ++side)
                changed |= take_lower_labels(side / 2, side % 2, seen);
            changed = grid_.comm().any(changed);
        }
    }

    /// Parts numbered by size, the largest first.
    GridParts<D> number()
    {
        std::vector<long> labels;
        for_each_index<D>(grid_.low(), grid_.high(), [&](const Index<D>& c) {
            const int i = static_cast<int>(block_.offset(c));
            if (sets_.find(i) == i && system_.component(c) >= 0)
                labels.push_back(label_[i]);
        });
        sort_unique(labels);
        labels = all_values(grid_.comm(), labels);
        sort_unique(labels);
        GridParts<D> parts{CellField<D, int>(grid_, -1), {}, {}};
        std::vector<double> told(2 * labels.size(), 0.0); // size, ground
        std::vector<int> number_of_root(block_.size, -1);
        for_each_index<D>(grid_.low(), grid_.high(), [&](const Index<D>& c) {
            if (system_.component(c) < 0)
                return;
            int& number = number_of_root[root(c)];
            if (number < 0)
                number = static_cast<int>(std::lower_bound(labels.begin(), labels.end(), label(c)) - labels.begin());
            parts.part(c) = number;
            told[2 * number] += 1;
            if (on_open_side(c))
                told[2 * number + 1] = 1;
        });
        grid_.comm().sum(told);

        std::vector<int> order(labels.size()), place(labels.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return told[2 * i] > told[2 * j]; });
        for (std::size_t i = 0; i < order.size(); ++i) {
            place[order[i]] = static_cast<int>(i);
            parts.size.push_back(static_cast<long>(told[2 * order[i]]));
            parts.grounded.push_back(told[2 * order[i] + 1] > 0);
        }
        for_each_index<D>(grid_.low(), grid_.high(), [&](const Index<D>& c) {
            if (int& k = parts.part(c); k >= 0)
                k = place[k];
        });
        return parts;
    }

private:
    int root(const Index<D>& c) { return sets_.find(static_cast<int>(block_.offset(c))); }
    /// Of a part: the lowest key of its cells; -1 in cells without unknown.
    long& label(const Index<D>& c) { return label_[root(c)]; }

    /// Across one side of this rank's block, from what the neighbour has `seen`. True if a label changed.
    bool take_lower_labels(int axis, int end, const CellField<D, double>& seen)
    {
        if (grid_.neighbour(axis, end) < 0)
            return false;
        bool changed = false;
        Index<D> low = grid_.low(), high = grid_.high();
        (end ? low : high)[axis] = end ? high[axis] - 1 : low[axis] + 1;
        for_each_index<D>(low, high, [&](const Index<D>& c) {
            const Index<D> face = end ? Index<D>(c + step<D>(axis)) : c;
            const Index<D> other = end ? face : Index<D>(c - step<D>(axis));
            long& mine = label(c);
            const long theirs = static_cast<long>(seen(other));
            if (system_.conductance(axis, face) > 0 && theirs >= 0 && theirs < mine) {
                mine = theirs;
                changed = true;
            }
        });
        return changed;
    }

    bool on_open_side(const Index<D>& c) const
    {
        for (int axis = 0; axis < D; ++axis) {
            if (grid_.periodic(axis))
                continue;
            if ((c[axis] == 0 && system_.conductance(axis, c) > 0) ||
                (c[axis] == grid_.cells()[axis] - 1 && system_.conductance(axis, c + step<D>(axis)) > 0))
                return true;
        }
        return false;
    }

    const CoupledSystem<D>& system_;
    const Grid<D>& grid_;
    Block<D> block_;
    DisjointSets sets_;
    std::vector<long> label_; ///< of each root
};

} // namespace

template <int D>
GridParts<D> find_grid_parts(const CoupledSystem<D>& system)
{
    PartFinder<D> finder(system);
    finder.join_ranks();
    return finder.number();
}

template GridParts<2> find_grid_parts<2>(const CoupledSystem<2>&);
template GridParts<3> find_grid_parts<3>(const CoupledSystem<3>&);

} // namespace gapflow
