// Wavefront over planes k normal to the last axis: a stage that reads the planes beside its own runs one plane behind the
// stage before it, so that at front t
//
//     relax red (t), black (t - 1), red (t - 2), black (t - 3), restrict (t - 4)
//
// and a handful of planes stays in the cache while all sweeps pass over it: the same values as sweep by sweep, at a fifth of
// the memory traffic. Levels with ghosts to exchange (several ranks, periodic sides) go sweep by sweep.

#include "gapflow/solver/wavefront.hpp"

#include "gapflow/solver/smoother.hpp"
#include "gapflow/solver/transfer.hpp"

#include <algorithm>

namespace gapflow {

namespace {

constexpr int sweeps = 2;
constexpr int stages = 2 * sweeps; // relaxations of one colour

template <int D>
void relax_all(Level<D>& level, int colour)
{
    for (int k = level.low[D - 1]; k < level.high[D - 1]; ++k)
        relax_plane(level, colour, k);
    level.halo.exchange(level.x.data());
}

} // namespace

template <int D>
void descend(Level<D>& fine, Level<D>& coarse)
{
    const int low = fine.low[D - 1], high = fine.high[D - 1];
    if (fine.halo.active()) {
        for (int k = low; k < high; ++k)
            relax_plane_from_zero(fine, 0, k);
        fine.halo.exchange(fine.x.data());
        for (int stage = 1; stage < stages; ++stage)
            relax_all(fine, stage % 2);
        for (int k = low; k < high; ++k)
            restrict_plane(fine, coarse, k);
        return;
    }
    for (int front = low; front < high + stages; ++front) {
        if (front < high)
            relax_plane_from_zero(fine, 0, front);
        for (int stage = 1; stage < stages; ++stage)
            if (const int k = front - stage; k >= low && k < high)
                relax_plane(fine, stage % 2, k);
        if (const int k = front - stages; k >= low)
            restrict_plane(fine, coarse, k);
    }
}

template <int D>
void ascend(const Level<D>& coarse, Level<D>& fine)
{
    const int low = fine.low[D - 1], high = fine.high[D - 1];
    if (fine.halo.active()) {
        for (int k = low; k < high; ++k)
            prolong_plane(coarse, fine, k);
        fine.halo.exchange(fine.x.data());
        for (int stage = 0; stage < stages; ++stage)
            relax_all(fine, (stage + 1) % 2);
        return;
    }
    for (int front = low; front < high + stages; ++front) {
        if (front < high)
            prolong_plane(coarse, fine, front);
        for (int stage = 0; stage < stages; ++stage)
            if (const int k = front - stage - 1; k >= low && k < high)
                relax_plane(fine, (stage + 1) % 2, k);
    }
}

template void descend<2>(Level<2>&, Level<2>&);
template void descend<3>(Level<3>&, Level<3>&);
template void ascend<2>(const Level<2>&, Level<2>&);
template void ascend<3>(const Level<3>&, Level<3>&);

} // namespace gapflow
