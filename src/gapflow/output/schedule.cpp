#include "gapflow/output/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

} // namespace

long next_multiple(double time, double every)
{
    long k = std::max(1L, std::lround(time / every) - 1);
    while (static_cast<double>(k) * every <= time)
        ++k;
    return k;
}

Schedule::Schedule(const Scene& scene, double time)
    : end_(scene.end), every_(scene.output_every), checkpoint_every_(scene.checkpoint_every)
{
    if (every_ > 0)
        output_ = next_multiple(time, every_);
    find_next_output(time);
    next_checkpoint_ = checkpoint_every_ > 0 ? checkpoint_every_ * next_multiple(time, checkpoint_every_) : never;
}

void Schedule::find_next_output(double time)
{
    if (time >= end_) {
        next_output_ = never;
        return;
    }
    next_output_ = every_ > 0 ? std::min(end_, output_ * every_) : end_;
    if (end_ - next_output_ < 1e-9 * end_) // no sliver of a step before the end
        next_output_ = end_;
}

bool Schedule::output_due(double time)
{
    if (!(time >= next_output_))
        return false;
    ++output_;
    find_next_output(time);
    return true;
}

bool Schedule::checkpoint_due(double time)
{
    if (time >= next_checkpoint_) {
        next_checkpoint_ = checkpoint_every_ * next_multiple(time, checkpoint_every_);
        return true;
    }
    return time >= end_;
}

} // namespace gapflow
