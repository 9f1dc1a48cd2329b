#include "gapflow/coupling/close_bodies.hpp"

#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/core/sparse_cholesky.hpp"
#include "gapflow/coupling/displaced_mass.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace gapflow {

template <int D>
BodyLayers<D>::BodyLayers(const Coupling<D>& coupling) : L_(coupling), K_(L_, coupling.cell_flux, coupling.node_flux)
{
    for (const Solid<D>& solid : coupling.solids)
        moves_.push_back(solid.motion != Motion::fixed && !solid.wall);
    moving_.assign(L_.locals(), 0);
    for (long local = 0; local < L_.locals(); ++local) { // those that move first, in their order
        const std::span<Entry> entries = K_.of(local);
        if (entries.size() > 1)
            std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
                return std::pair(!moves_[a.body], a.body) < std::pair(!moves_[b.body], b.body);
            });
        while (static_cast<std::size_t>(moving_[local]) < entries.size() && moves_[entries[moving_[local]].body])
            ++moving_[local];
    }
    const Communicator& comm = L_.grid().comm();
    if (comm.size() == 1)
        return;
    std::vector<RowEntry<D>> seen;
    for_each_row([&](long row) {
        if (at_side(row))
            for (const Entry& entry : of(row))
                seen.push_back({row, entry.body, entry.flux});
    });
    for (const RowEntry<D>& entry : all_values(comm, seen))
        if (!L_.owns(entry.row))
            beside_[entry.row].push_back({entry.body, entry.flux});
}

template <int D>
bool BodyLayers<D>::at_side(long row) const
{
    bool seen = L_.linked(row);
    for (int axis = 0; axis < D && !seen && L_.is_cell(row); ++axis)
        for (const int end : {0, 1})
            seen = seen || (L_.grid().neighbour(axis, end) >= 0 &&
                            L_.cell(row)[axis] == (end ? L_.grid().high()[axis] - 1 : L_.grid().low()[axis]));
    return seen;
}

template <int D>
std::span<const typename BodyLayers<D>::Entry> BodyLayers<D>::of(long row) const
{
    if (!L_.owns(row)) {
        const auto at = beside_.find(row);
        return at == beside_.end() ? std::span<const Entry>{} : std::span<const Entry>(at->second);
    }
    const long local = L_.local(row);
    return K_.of(local).first(moving_[local]);
}

template <int D>
bool BodyLayers<D>::differ(long a, long b) const
{
    const auto x = of(a), y = of(b);
    return !x.empty() && !y.empty() &&
           !std::equal(x.begin(), x.end(), y.begin(), y.end(), [](const Entry& p, const Entry& q) { return p.body == q.body; });
}

namespace {

/// What the rows of a link add to Lambda.
double share_of_link(const Link& link, double own, double weights)
{
    return 0.5 * link.conductance * std::abs(own) * weights;
}

template <class Rows>
std::pair<double, double> weights_in(const Rows& all, long row)
{
    double own = 0, sum = 0;
    for (const auto& [other, weight] : all) {
        own += other == row ? weight : 0.0;
        sum += std::abs(weight);
    }
    return {own, sum};
}

} // namespace

template <int D>
double BodyLayers<D>::bound(long row) const
{
    double sum = L_.bound(row);
    L_.for_each_edge(row, [&](long other, double g) {
        if (differ(row, other))
            sum += g;
    });
    L_.for_each_link(row, [&](const Link& link, const auto& all) {
        if (!differ(all))
            return;
        const auto [own, weights] = weights_in(all, row);
        sum += share_of_link(link, own, weights);
    });
    return sum;
}

namespace {

/// Bodies and the inertia of what they share, block by block.
template <int D>
using InertiaBlocks = std::map<std::pair<int, int>, TwistMatrix<D>>;

template <int D>
struct SharedInertia {
    int a, b;
    TwistMatrix<D> mass;
};

template <int D>
class CloseBodies {
public:
    explicit CloseBodies(Coupling<D>& coupling) : coupling_(coupling), layers_(coupling), comm_(coupling.grid->comm())
    {
        gaps_ = comm_.size() == 1 ? coupling.normal_inertia : all_values(comm_, coupling.normal_inertia);
    }

    void limit()
    {
        find_neighbours();
        if (neighbours_.empty())
            return;
        find_bounds();
        // Each body alone, with what is its own.
        std::vector<int> group(coupling_.solids.size(), -1);
        for (const auto& [a, b] : neighbours_)
            group[a] = a, group[b] = b;
        const InertiaBlocks<D> own = inertia(group);
        for (const auto& [pair, mass] : own) {
            const int b = pair.first;
            const ScaledModes<D> modes(mass, displaced_mass(coupling_.solids[b], coupling_.density));
            if (modes.modes.eigenvalues()[0] < 0)
                lack_.emplace(b, modes.positive_part(mass) - mass);
        }
        if (lack_.empty())
            return;
        // Together with those beside them.
        DisjointSets sets(static_cast<int>(coupling_.solids.size()));
        std::vector<char> member(coupling_.solids.size(), 0);
        for (const auto& [a, b] : neighbours_)
            if (lack_.contains(a) || lack_.contains(b)) {
                sets.join(a, b);
                member[a] = member[b] = 1;
            }
        int groups = 0;
        const std::vector<int> number = sets.numbers(groups);
        for (std::size_t s = 0; s < group.size(); ++s)
            group[s] = member[s] ? number[s] : -1;
        const InertiaBlocks<D> joint = inertia(group);
        std::set<int> numbers;
        for (const auto& [b, lack] : lack_)
            numbers.insert(group[b]);
        for (const int g : numbers)
            raise(g, group, joint);
    }

private:
    void add_neighbours(int a, int b)
    {
        if (const std::pair<int, int> pair = std::minmax(a, b); a != b && (neighbours_.empty() || neighbours_.back() != pair))
            neighbours_.push_back(pair);
    }
    void sort_neighbours()
    {
        std::sort(neighbours_.begin(), neighbours_.end());
        neighbours_.erase(std::unique(neighbours_.begin(), neighbours_.end()), neighbours_.end());
    }
    /// Bodies with a row in common, or rows beside each other.
    void find_neighbours()
    {
        const FluidRows<D>& L = layers_.rows();
        const auto add_rows = [&](long p, long q) {
            for (const auto& a : layers_.of(p))
                for (const auto& b : layers_.of(q))
                    add_neighbours(a.body, b.body);
        };
        layers_.for_each_row([&](long row) {
            add_rows(row, row);
            L.for_each_edge(row, [&](long other, double) { add_rows(row, other); });
            L.for_each_link(row, [&](const Link&, const auto& all) {
                for (const auto& [other, weight] : all)
                    add_rows(row, other);
            });
        });
        if (comm_.size() > 1) {
            sort_neighbours();
            neighbours_ = all_values(comm_, neighbours_);
        }
        for (const NormalInertia<D>& gap : gaps_)
            if (layers_.moves(gap.master) && layers_.moves(gap.other))
                add_neighbours(gap.master, gap.other);
        sort_neighbours();
    }
    /// Lambda of own rows, and of those beside them.
    void find_bounds()
    {
        own_bound_.assign(layers_.rows().locals(), 0.0);
        std::vector<std::pair<long, double>> seen;
        layers_.for_each_row([&](long row) {
            const double bound = own_bound_[layers_.rows().local(row)] = layers_.bound(row);
            if (comm_.size() > 1 && layers_.at_side(row))
                seen.emplace_back(row, bound);
        });
        if (comm_.size() > 1)
            for (const auto& [row, bound] : all_values(comm_, seen))
                bound_beside_[row] = bound;
    }
    double bound(long row) const
    {
        return layers_.rows().owns(row) ? own_bound_[layers_.rows().local(row)] : bound_beside_.at(row);
    }

    /// D, the gaps and the layers of the bodies of each group: of fluid that bodies of no other group use.
    InertiaBlocks<D> inertia(const std::vector<int>& group) const
    {
        const FluidRows<D>& L = layers_.rows();
        InertiaBlocks<D> sum;
        // The group of all bodies of a row, -1: none.
        const auto find_group = [&](long row) {
            int found = -1;
            for (const auto& entry : layers_.of(row)) {
                if (group[entry.body] < 0 || (found >= 0 && found != group[entry.body]))
                    return -1;
                found = group[entry.body];
            }
            return found;
        };
        std::vector<int> groups(L.locals(), -1); // of own rows
        layers_.for_each_row([&](long row) { groups[L.local(row)] = find_group(row); });
        const auto group_of = [&](long row) { return L.owns(row) ? groups[L.local(row)] : find_group(row); };
        std::vector<std::vector<std::pair<int, TwistMatrix<D>*>>> known(group.size()); // the blocks of each body
        const auto block_of = [&](int a, int b) -> TwistMatrix<D>& {
            for (const auto& [other, block] : known[a])
                if (other == b)
                    return *block;
            return *known[a].emplace_back(b, &sum.try_emplace({a, b}, TwistMatrix<D>::Zero()).first->second).second;
        };
        const auto add = [&](long p, long q, double factor) {
            for (const auto& a : layers_.of(p))
                for (const auto& b : layers_.of(q))
                    block_of(a.body, b.body).noalias() += Twist<D>(factor * a.flux) * b.flux.transpose();
        };
        layers_.for_each_row([&](long row) {
            const int here = group_of(row);
            const double own_bound = here >= 0 ? bound(row) : 0.0;
            if (!(own_bound > 0))
                return;
            const double y = 1 / own_bound;
            double diagonal = 2 * own_bound - L.diagonal(row);
            L.for_each_edge(row, [&](long other, double g) {
                if (layers_.of(other).empty())
                    return;
                if (group_of(other) != here)
                    diagonal -= g;
                else if (const double beside = bound(other); beside > 0)
                    add(row, other, g * y / beside);
            });
            L.for_each_link(row, [&](const Link& link, const auto& all) {
                const auto [own, weights] = weights_in(all, row);
                const bool ours = std::all_of(all.begin(), all.end(), [&](const auto& member) {
                    return layers_.of(member.first).empty() || group_of(member.first) == here;
                });
                if (!ours) {
                    diagonal -= 2 * share_of_link(link, own, weights) - link.conductance * own * own;
                    return;
                }
                for (const auto& [other, weight] : all)
                    if (other != row && !layers_.of(other).empty())
                        if (const double beside = bound(other); beside > 0)
                            add(row, other, -link.conductance * own * weight * y / beside);
            });
            add(row, row, diagonal * y * y);
        });
        if (comm_.size() > 1) {
            std::vector<SharedInertia<D>> own;
            for (const auto& [pair, mass] : sum)
                own.push_back({pair.first, pair.second, mass});
            sum.clear();
            for (const SharedInertia<D>& block : all_values(comm_, own))
                sum.try_emplace({block.a, block.b}, TwistMatrix<D>::Zero()).first->second += block.mass;
        }
        for (std::size_t s = 0; s < group.size(); ++s)
            if (group[s] >= 0) {
                const int b = static_cast<int>(s);
                sum.try_emplace({b, b}, TwistMatrix<D>::Zero()).first->second +=
                    coupling_.seen_mass[s] - coupling_.gap_deficit[s];
            }
        for (const GapDeficit<D>& gap : coupling_.gap_deficits)
            if (joined(group, gap.a, gap.b))
                for (const auto& [solid, mass] : {std::pair(gap.a, &gap.of_a), std::pair(gap.b, &gap.of_b)})
                    if (group[solid] >= 0)
                        sum.at({solid, solid}) += *mass;
        for (const NormalInertia<D>& gap : gaps_)
            if (joined(group, gap.master, gap.other))
                for (const auto& [i, row_i] : {std::pair(gap.master, &gap.row_master), std::pair(gap.other, &gap.row_other)})
                    for (const auto& [j, row_j] :
                         {std::pair(gap.master, &gap.row_master), std::pair(gap.other, &gap.row_other)})
                        if (group[i] >= 0 && group[j] >= 0)
                            sum.try_emplace({i, j}, TwistMatrix<D>::Zero()).first->second +=
                                Twist<D>(gap.mass * *row_i) * row_j->transpose();
        return sum;
    }
    /// Whether a gap's inertia is that of one group: its walls belong to it, or stand still.
    bool joined(const std::vector<int>& group, int a, int b) const
    {
        if (!layers_.moves(a) || !layers_.moves(b))
            return group[a] >= 0 || group[b] >= 0;
        return group[a] >= 0 && group[a] == group[b];
    }

    /// Raises D of the bodies of a group that lack something by one share of it: the least with which the sum of all is positive.
    void raise(int number, const std::vector<int>& group, const InertiaBlocks<D>& joint)
    {
        constexpr int n = twist_size<D>;
        std::vector<int> bodies, place(group.size(), -1);
        for (std::size_t s = 0; s < group.size(); ++s)
            if (group[s] == number) {
                place[s] = static_cast<int>(bodies.size());
                bodies.push_back(static_cast<int>(s));
            }
        std::vector<Eigen::Triplet<double>> of_sum, of_lack;
        const auto add = [&](int a, int b, const TwistMatrix<D>& mass, std::vector<Eigen::Triplet<double>>& to) {
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j)
                    to.emplace_back(n * place[a] + i, n * place[b] + j, mass(i, j));
        };
        for (const auto& [pair, mass] : joint)
            if (place[pair.first] >= 0 && place[pair.second] >= 0) {
                add(pair.first, pair.second, 0.5 * mass, of_sum);
                add(pair.second, pair.first, 0.5 * mass.transpose(), of_sum);
            }
        for (const int s : bodies) {
            const auto at = lack_.find(s);
            add(s, s, at != lack_.end() ? at->second : TwistMatrix<D>(TwistMatrix<D>::Zero()), of_lack);
        }
        const long size = n * static_cast<long>(bodies.size());
        Eigen::SparseMatrix<double> sum(size, size), lack(size, size);
        sum.setFromTriplets(of_sum.begin(), of_sum.end());
        lack.setFromTriplets(of_lack.begin(), of_lack.end());
        // In the axes in which the diagonal with all that is lacking is one; where the fluid feels next to nothing of a motion it is less.
        Eigen::VectorXd scale = (sum.diagonal() + lack.diagonal()).cwiseMax(0.0);
        for (const int s : bodies)
            scale.segment<n>(n * place[s]) += round_off * displaced_mass(coupling_.solids[s], coupling_.density).diagonal();
        scale = scale.cwiseSqrt().cwiseInverse();
        sum = Eigen::SparseMatrix<double>(scale.asDiagonal() * sum * scale.asDiagonal());
        lack = Eigen::SparseMatrix<double>(scale.asDiagonal() * lack * scale.asDiagonal());
        for (long i = 0; i < size; ++i)
            sum.coeffRef(i, i) += round_off;
        SparseCholesky factor;
        factor.analyse(sum);
        const auto positive = [&](double share) { return factor.factorise(Eigen::SparseMatrix<double>(sum + share * lack)); };
        if (positive(0))
            return;
        double low = 0, high = 1;
        for (int k = 0; k < halvings; ++k)
            (positive(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
        for (const int s : bodies)
            if (const auto at = lack_.find(s); at != lack_.end())
                coupling_.seen_mass[s] += high * at->second;
    }

    static constexpr double round_off = 1e-14; // of a matrix with a diagonal of one
    static constexpr int halvings = 20;        // of a share

    Coupling<D>& coupling_;
    const BodyLayers<D> layers_;
    const Communicator& comm_;
    std::vector<NormalInertia<D>> gaps_;
    std::vector<std::pair<int, int>> neighbours_; ///< bodies beside each other, a < b
    std::vector<double> own_bound_;
    std::map<long, double> bound_beside_; ///< of other ranks' rows
    std::map<int, TwistMatrix<D>> lack_;
};

} // namespace

template <int D>
void limit_close_deficits(Coupling<D>& coupling)
{
    const auto moving = std::count_if(coupling.solids.begin(), coupling.solids.end(),
                                      [](const Solid<D>& solid) { return solid.motion != Motion::fixed && !solid.wall; });
    if (moving > 1)
        CloseBodies<D>(coupling).limit();
}

template class BodyLayers<2>;
template class BodyLayers<3>;
template void limit_close_deficits<2>(Coupling<2>&);
template void limit_close_deficits<3>(Coupling<3>&);

} // namespace gapflow
