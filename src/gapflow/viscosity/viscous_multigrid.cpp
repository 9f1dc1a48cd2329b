#include "gapflow/viscosity/viscous_multigrid.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/solver/merging.hpp"
#include "gapflow/viscosity/lattice_metric.hpp"

#include <algorithm>

namespace gapflow {

namespace {

constexpr float overcorrection = 0.5F;
// No coarser level where links are less than this part of the masses.
constexpr double mass_dominates = 0.1;
constexpr int sweeps = 2;
constexpr int coarsest_sweeps = 8;

template <int D, class Level>
Index<D> parent_of(const Level& level, const Index<D>& i)
{
    Index<D> parent;
    for (int k = 0; k < D; ++k)
        parent[k] = level.parent[k][i[k]];
    return parent;
}

// Part of a link after point i along axis k that its coarse one keeps: the ratio of their lengths, half where both ends are pairs.
template <class Level>
float overcorrected(const Level& fine, const Level& coarse, int k, int i)
{
    const int last = static_cast<int>(fine.width[k].size()) - 1, last_coarse = static_cast<int>(coarse.width[k].size()) - 1;
    const int c = fine.parent[k][i];
    if (i == last || c == last_coarse)
        return overcorrection;
    return static_cast<float>((fine.width[k][i] + fine.width[k][i + 1]) / (coarse.width[k][c] + coarse.width[k][c + 1]));
}

} // namespace

template <int D>
ViscousMultigrid<D>::ViscousMultigrid(const ViscousSystem<D>& system, int axis)
    : grid_(*system.grid), low_(system.grid->low()), system_(system), axis_(axis)
{
    for (int k = 0; k < D; ++k)
        wraps_[k] = grid_.periodic(k) && grid_.neighbour(k, 1) == grid_.comm().rank();
    Masses masses;
    levels_.push_back(finest(system, axis, masses));
    double link = system.edge, mass = system.cell_mass, target = 1;
    while (levels_.back().count.maxCoeff() > 2 && link > mass_dominates * mass) {
        Masses coarse;
        target *= 2;
        levels_.push_back(coarsened(levels_.back(), target, masses, coarse));
        masses = std::move(coarse);
        link *= 1 << (D - 2);
        mass *= 1 << D;
    }
}

template <int D>
typename ViscousMultigrid<D>::Level ViscousMultigrid<D>::finest(const ViscousSystem<D>& system, int axis, Masses& masses) const
{
    Level level;
    level.count = owned_faces_end(grid_, axis) - low_;
    level.block = Block<D>(-Index<D>::Ones(), level.count + Index<D>::Ones());
    for (auto& link : level.link)
        link.assign(level.block.size, 0.0F);
    masses.mass.assign(level.block.size, 0.0F);
    masses.wall.assign(level.block.size, 0.0F);
    const Block<D>& from = system.active[axis].block();
    const std::int8_t* active = system.active[axis].data();
    for (int k = 0; k < D; ++k)
        for (int i = 0; i < level.count[k]; ++i)
            level.width[k].push_back(k == axis ? grid_.spread(k, low_[k] + i) : grid_.width(k, low_[k] + i));
    for_each_row<D>(Index<D>::Zero(), level.count, [&](const Index<D>& row) {
        const long at = level.block.offset(row), source = from.offset(low_ + row);
        const EdgeRow<D> edges(grid_, axis, low_ + row);
        for (int i = 0; i < level.count[0]; ++i) {
            if (!active[source + i])
                continue;
            double links = 0;
            for (int k = 0; k < D; ++k) {
                const int place = row[k] + (k == 0 ? i : 0);
                const bool next = wraps_[k] || place + 1 < level.count[k], previous = wraps_[k] || place > 0;
                if (next && active[source + i + from.stride[k]]) {
                    level.link[k][at + i] = static_cast<float>(system.edge * edges.after(k, i));
                    links += edges.after(k, i);
                }
                if (previous && active[source + i - from.stride[k]])
                    links += edges.before(k, i);
            }
            double mass = system.cell_mass;
            for (int k = 0; k < D; ++k)
                mass *= level.width[k][row[k] + (k == 0 ? i : 0)];
            const double excess = system.diagonal[axis].data()[source + i] - links * system.edge;
            masses.mass[at + i] = static_cast<float>(std::min(excess, mass));
            masses.wall[at + i] = static_cast<float>(std::max(excess - mass, 0.0));
        }
    });
    set_diagonal(level, masses);
    return level;
}

template <int D>
typename ViscousMultigrid<D>::Level ViscousMultigrid<D>::coarsened(Level& fine, double target, const Masses& fine_masses,
                                                                   Masses& masses) const
{
    Level level;
    for (int k = 0; k < D; ++k) {
        std::vector<int>& parent = fine.parent[k];
        parent.resize(fine.count[k]);
        if (grid_.graded()) {
            const std::vector<int> starts = merged(fine.width[k], 0, fine.count[k], widest_merged * target);
            for (int i = 0, c = 0; i < fine.count[k]; ++i) {
                c += c + 1 < static_cast<int>(starts.size()) && starts[c + 1] == i;
                parent[i] = c;
            }
        } else {
            for (int i = 0; i < fine.count[k]; ++i)
                parent[i] = i / 2;
        }
        level.count[k] = parent.back() + 1;
        level.width[k].assign(level.count[k], 0.0);
        for (int i = 0; i < fine.count[k]; ++i)
            level.width[k][parent[i]] += fine.width[k][i];
    }
    level.block = Block<D>(-Index<D>::Ones(), level.count + Index<D>::Ones());
    for (auto& link : level.link)
        link.assign(level.block.size, 0.0F);
    masses.mass.assign(level.block.size, 0.0F);
    masses.wall.assign(level.block.size, 0.0F);
    for_each_index<D>(Index<D>::Zero(), fine.count, [&](const Index<D>& i) {
        const Index<D> parent = parent_of(fine, i);
        const long at = fine.block.offset(i), to = level.block.offset(parent);
        masses.mass[to] += fine_masses.mass[at];
        masses.wall[to] += overcorrection * fine_masses.wall[at];
        for (int k = 0; k < D; ++k)
            if (i[k] + 1 == fine.count[k] || fine.parent[k][i[k] + 1] != parent[k])
                level.link[k][to] += (grid_.graded() ? overcorrected(fine, level, k, i[k]) : overcorrection) * fine.link[k][at];
    });
    for (int k = 0; k < D; ++k) // one point left along a periodic axis: linked to itself
        if (level.count[k] == 1)
            std::fill(level.link[k].begin(), level.link[k].end(), 0.0F);
    set_diagonal(level, masses);
    return level;
}

template <int D>
void ViscousMultigrid<D>::set_diagonal(Level& level, const Masses& masses) const
{
    level.inverse_diagonal.assign(level.block.size, 0.0F);
    level.x.assign(level.block.size, 0.0F);
    level.b.assign(level.block.size, 0.0F);
    for (auto& link : level.link)
        copy_around(level, link);
    for_each_index<D>(Index<D>::Zero(), level.count, [&](const Index<D>& i) {
        const long at = level.block.offset(i);
        float sum = masses.mass[at] + masses.wall[at];
        for (int k = 0; k < D; ++k)
            sum += level.link[k][at] + level.link[k][at - level.block.stride[k]];
        level.inverse_diagonal[at] = sum > 0 ? 1 / sum : 0.0F;
    });
}

// Copies across periodic sides; elsewhere the layer around the points stays zero.
template <int D>
void ViscousMultigrid<D>::copy_around(const Level& level, LargeVector<float>& field) const
{
    for (int k = 0; k < D; ++k) {
        if (!wraps_[k])
            continue;
        const long stride = level.block.stride[k], period = stride * level.count[k];
        Index<D> first = Index<D>::Zero(), last = level.count;
        last[k] = 1;
        for_each_index<D>(first, last, [&](const Index<D>& i) {
            const long at = level.block.offset(i);
            field[at + period] = field[at];
            field[at - stride] = field[at + period - stride];
        });
    }
}

template <int D>
void ViscousMultigrid<D>::smooth(Level& level, int colour) const
{
    if (std::any_of(wraps_.begin(), wraps_.end(), [](bool wraps) { return wraps; }))
        copy_around(level, level.x);
    for_each_plane(0, level.count[D - 1], [&](int plane) {
        Index<D> from = Index<D>::Zero(), to = level.count;
        from[D - 1] = plane;
        to[D - 1] = plane + 1;
        for_each_row<D>(from, to, [&](const Index<D>& row) {
            const long at = level.block.offset(row);
            float* x = level.x.data() + at;
            const float *b = level.b.data() + at, *inverse = level.inverse_diagonal.data() + at;
            std::array<const float*, D> link;
            std::array<long, D> stride;
            for (int k = 0; k < D; ++k) {
                link[k] = level.link[k].data() + at;
                stride[k] = level.block.stride[k];
            }
            for (int i = (row.sum() + colour) & 1; i < level.count[0]; i += 2) {
                float sum = b[i];
                for (int k = 0; k < D; ++k)
                    sum += link[k][i] * x[i + stride[k]] + link[k][i - stride[k]] * x[i - stride[k]];
                x[i] = sum * inverse[i];
            }
        });
    });
}

template <int D>
void ViscousMultigrid<D>::restrict_residual(Level& fine, Level& coarse) const
{
    copy_around(fine, fine.x);
    for_each_plane(0, coarse.count[D - 1], [&](int plane) {
        Index<D> from = Index<D>::Zero(), to = coarse.count;
        from[D - 1] = plane;
        to[D - 1] = plane + 1;
        for_each_row<D>(from, to, [&](const Index<D>& row) {
            std::fill_n(coarse.b.data() + coarse.block.offset(row), coarse.count[0], 0.0F);
            std::fill_n(coarse.x.data() + coarse.block.offset(row), coarse.count[0], 0.0F);
        });
        const std::vector<int>& parents = fine.parent[D - 1];
        const auto own = std::equal_range(parents.begin(), parents.end(), plane);
        from[D - 1] = static_cast<int>(own.first - parents.begin());
        to = fine.count;
        to[D - 1] = static_cast<int>(own.second - parents.begin());
        for_each_row<D>(from, to, [&](const Index<D>& row) {
            const long at = fine.block.offset(row);
            float* sum = coarse.b.data() + coarse.block.offset(parent_of(fine, row));
            for (int i = 0; i < fine.count[0]; ++i) {
                const float inverse = fine.inverse_diagonal[at + i];
                if (inverse == 0)
                    continue;
                float r = fine.b[at + i] - fine.x[at + i] / inverse;
                for (int k = 0; k < D; ++k) {
                    const long stride = fine.block.stride[k];
                    r += fine.link[k][at + i] * fine.x[at + i + stride] +
                         fine.link[k][at + i - stride] * fine.x[at + i - stride];
                }
                sum[fine.parent[0][i]] += r;
            }
        });
    });
}

template <int D>
void ViscousMultigrid<D>::prolong(const Level& coarse, Level& fine) const
{
    for_each_plane(0, fine.count[D - 1], [&](int plane) {
        Index<D> from = Index<D>::Zero(), to = fine.count;
        from[D - 1] = plane;
        to[D - 1] = plane + 1;
        for_each_row<D>(from, to, [&](const Index<D>& row) {
            const float* correction = coarse.x.data() + coarse.block.offset(parent_of(fine, row));
            const long at = fine.block.offset(row);
            for (int i = 0; i < fine.count[0]; ++i)
                if (fine.inverse_diagonal[at + i] > 0)
                    fine.x[at + i] += correction[fine.parent[0][i]];
        });
    });
}

template <int D>
void ViscousMultigrid<D>::descend(std::size_t l)
{
    Level& level = levels_[l];
    const bool coarsest = l + 1 == levels_.size();
    const int count = coarsest && levels_.size() > 1 ? coarsest_sweeps : sweeps;
    for (int sweep = 0; sweep < count; ++sweep) {
        smooth(level, 0);
        smooth(level, 1);
    }
    if (!coarsest) {
        restrict_residual(level, levels_[l + 1]);
        descend(l + 1);
        prolong(levels_[l + 1], level);
    }
    for (int sweep = 0; sweep < count; ++sweep) {
        smooth(level, 1);
        smooth(level, 0);
    }
}

template <int D>
void ViscousMultigrid<D>::cycle(const CellField<D>& r, CellField<D>& z)
{
    Level& level = levels_.front();
    // In units in which residuals are of order one: single precision has its range.
    double largest = 0;
    for_each_row<D>(Index<D>::Zero(), level.count, [&](const Index<D>& row) {
        const double* from = &r(Index<D>(low_ + row));
        for (int i = 0; i < level.count[0]; ++i)
            largest = std::max(largest, std::abs(from[i]));
    });
    const double scale = largest > 0 ? largest : 1.0;
    for_each_row<D>(Index<D>::Zero(), level.count, [&](const Index<D>& row) {
        const double* from = &r(Index<D>(low_ + row));
        const long at = level.block.offset(row);
        for (int i = 0; i < level.count[0]; ++i) {
            level.b[at + i] = static_cast<float>(from[i] / scale);
            level.x[at + i] = 0;
        }
    });
    descend(0);
    for_each_row<D>(Index<D>::Zero(), level.count, [&](const Index<D>& row) {
        double* to = &z(Index<D>(low_ + row));
        const long at = level.block.offset(row);
        for (int i = 0; i < level.count[0]; ++i)
            to[i] = scale * level.x[at + i];
    });
}

template class ViscousMultigrid<2>;
template class ViscousMultigrid<3>;

} // namespace gapflow
