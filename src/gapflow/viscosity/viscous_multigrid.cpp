#include "gapflow/viscosity/viscous_multigrid.hpp"

#include "gapflow/core/threads.hpp"

#include <algorithm>

namespace gapflow {

namespace {

constexpr float overcorrection = 0.5F;
// No coarser level where links are less than this part of the masses.
constexpr double mass_dominates = 0.1;
constexpr int sweeps = 2;
constexpr int coarsest_sweeps = 8;

template <int D>
Index<D> halves(const Index<D>& count)
{
    return (count + Index<D>::Ones()) / 2;
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
    double link = system.edge, mass = system.cell_mass;
    while (levels_.back().count.maxCoeff() > 2 && link > mass_dominates * mass) {
        Masses coarse;
        levels_.push_back(coarsened(levels_.back(), masses, coarse));
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
    const auto edge = static_cast<float>(system.edge);
    for_each_row<D>(Index<D>::Zero(), level.count, [&](const Index<D>& row) {
        const long at = level.block.offset(row), source = from.offset(low_ + row);
        for (int i = 0; i < level.count[0]; ++i) {
            if (!active[source + i])
                continue;
            int links = 0;
            for (int k = 0; k < D; ++k) {
                const int place = row[k] + (k == 0 ? i : 0);
                const bool next = wraps_[k] || place + 1 < level.count[k], previous = wraps_[k] || place > 0;
                if (next && active[source + i + from.stride[k]]) {
                    level.link[k][at + i] = edge;
                    ++links;
                }
                links += previous && active[source + i - from.stride[k]];
            }
            const double excess = system.diagonal[axis].data()[source + i] - links * system.edge;
            masses.mass[at + i] = static_cast<float>(std::min(excess, system.cell_mass));
            masses.wall[at + i] = static_cast<float>(std::max(excess - system.cell_mass, 0.0));
        }
    });
    set_diagonal(level, masses);
    return level;
}

template <int D>
typename ViscousMultigrid<D>::Level ViscousMultigrid<D>::coarsened(const Level& fine, const Masses& fine_masses,
                                                                   Masses& masses) const
{
    Level level;
    level.count = halves<D>(fine.count);
    level.block = Block<D>(-Index<D>::Ones(), level.count + Index<D>::Ones());
    for (auto& link : level.link)
        link.assign(level.block.size, 0.0F);
    masses.mass.assign(level.block.size, 0.0F);
    masses.wall.assign(level.block.size, 0.0F);
    for_each_index<D>(Index<D>::Zero(), fine.count, [&](const Index<D>& i) {
        const Index<D> parent = i / 2;
        const long at = fine.block.offset(i), to = level.block.offset(parent);
        masses.mass[to] += fine_masses.mass[at];
        masses.wall[to] += overcorrection * fine_masses.wall[at];
        for (int k = 0; k < D; ++k)
            if (i[k] % 2 == 1 || i[k] + 1 == fine.count[k])
                level.link[k][to] += overcorrection * fine.link[k][at];
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
        from[D - 1] = 2 * plane;
        to = fine.count;
        to[D - 1] = std::min(2 * plane + 2, fine.count[D - 1]);
        for_each_row<D>(from, to, [&](const Index<D>& row) {
            const long at = fine.block.offset(row);
            float* sum = coarse.b.data() + coarse.block.offset(row / 2);
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
                sum[i / 2] += r;
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
            const float* correction = coarse.x.data() + coarse.block.offset(row / 2);
            const long at = fine.block.offset(row);
            for (int i = 0; i < fine.count[0]; ++i)
                if (fine.inverse_diagonal[at + i] > 0)
                    fine.x[at + i] += correction[i / 2];
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
