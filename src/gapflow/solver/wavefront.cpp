// A leg of a cycle is a list of stages s = 0 .. 4 on planes k normal to the last axis; stage s on plane k needs stage s - 1 on
// planes k - 1, k, k + 1. Run as a wavefront,
//
//     relax red (t), black (t - 1), red (t - 2), black (t - 3), restrict (t - 4)      at front t,
//
// a few planes stay in the cache while all sweeps pass over them: the same values as sweep by sweep, at a fifth of the
// memory traffic. Threads take slabs of planes: first every stage as far as it is independent of other slabs (a trapezoid),
// then, after one barrier, the rest around the slabs' common planes. The ends next to other ranks come last,
// stage by stage with an exchange of ghosts before each. All values are those of whole sweeps, on any number of threads and
// ranks. Blocks with neighbours along other axes, or of few planes, are computed sweep by sweep.

#include "gapflow/solver/wavefront.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/solver/smoother.hpp"
#include "gapflow/solver/transfer.hpp"

#include <algorithm>
#include <functional>

namespace gapflow {

namespace {

constexpr int last_stage = 4;                    // two sweeps of two colours, and the transfer
constexpr int least_planes = 2 * last_stage + 2; // of a slab
constexpr long threaded_cells = 30000;           // of a level: below, threads cost more than they save

/// Calls stage(s, k) for s = 0 .. last_stage and all planes; `exchange` fills the ghosts of x.
template <int D, class Stage>
void run_stages(const Level<D>& level, Stage&& stage, const std::function<void()>& exchange)
{
    const int low = level.low[D - 1], high = level.high[D - 1], n = high - low;
    const bool below = level.halo.active(D - 1, 0), above = level.halo.active(D - 1, 1);
    const bool alone = !level.halo.active();
    const int slabs = std::max(1, level.block.size < threaded_cells ? 1 : std::min(thread_count(), n / least_planes));
    auto slab_begin = [&](int t) { // a coarse plane in one slab
        int k = t == slabs ? high : low + n * t / slabs;
        while (k > low && k < high && level.parent[D - 1][k] == level.parent[D - 1][k - 1])
            --k;
        return k;
    };
    if (!alone && (!level.halo.only_last_axis() || n < least_planes)) {
        for (int s = 0; s <= last_stage; ++s) {
            if (s > 0)
                exchange();
            for_each_part_of(slabs, slabs, [&](long begin, long end) {
                for (int k = slab_begin(static_cast<int>(begin)); k < slab_begin(static_cast<int>(end)); ++k)
                    stage(s, k);
            });
        }
        return;
    }
    for_each_part_of(slabs, slabs, [&](long begin, long end) {
        for (int t = static_cast<int>(begin); t < end; ++t) {
            const int from = slab_begin(t), to = slab_begin(t + 1);
            const int shrink_low = t > 0 || below ? 1 : 0, shrink_high = t + 1 < slabs || above ? 1 : 0;
            for (int front = from; front < to + last_stage; ++front)
                for (int s = 0; s <= last_stage; ++s)
                    if (const int k = front - s; k >= from + shrink_low * s && k < to - shrink_high * s)
                        stage(s, k);
        }
    });
    for_each_part_of(slabs, slabs - 1, [&](long begin, long end) {
        for (int t = static_cast<int>(begin); t < end; ++t)
            for (int s = 1; s <= last_stage; ++s)
                for (int k = slab_begin(t + 1) - s; k < slab_begin(t + 1) + s; ++k)
                    stage(s, k);
    });
    for (int s = 1; s <= last_stage && !alone; ++s) {
        exchange();
        for (int k = low; k < low + s && below; ++k)
            stage(s, k);
        for (int k = high - s; k < high && above; ++k)
            stage(s, k);
    }
}

} // namespace

template <int D>
void descend(Level<D>& fine, Level<D>& coarse)
{
    run_stages(
        fine,
        [&](int s, int k) {
            if (s == 0)
                relax_plane_from_zero(fine, 0, k);
            else if (s < last_stage)
                relax_plane(fine, s % 2, k);
            else
                restrict_plane(fine, coarse, k);
        },
        [&] { fine.halo.exchange(fine.x.data()); });
}

template <int D>
void ascend(const Level<D>& coarse, Level<D>& fine)
{
    run_stages(
        fine,
        [&](int s, int k) {
            if (s == 0)
                prolong_plane(coarse, fine, k);
            else
                relax_plane(fine, s % 2, k);
        },
        [&] { fine.halo.exchange(fine.x.data()); });
    fine.halo.exchange(fine.x.data());
}

template void descend<2>(Level<2>&, Level<2>&);
template void descend<3>(Level<3>&, Level<3>&);
template void ascend<2>(const Level<2>&, Level<2>&);
template void ascend<3>(const Level<3>&, Level<3>&);

} // namespace gapflow
