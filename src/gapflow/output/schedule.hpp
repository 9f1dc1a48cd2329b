// When a run writes what: fields at output times, checkpoints now and then.
#pragma once

#include "gapflow/scene/scene.hpp"

namespace gapflow {

/// Number k >= 1 of the first multiple of `every` after `time`; times of multiples are k * every to the bit.
long next_multiple(double time, double every);

/// Output times are the multiples of output.every and time.end; steps land on them. A checkpoint is due after the first step that
/// reaches a multiple of output.checkpoint_every, and at time.end.
class Schedule {
public:
    /// From a time on: that of the start, or of the checkpoint that a run goes on from.
    Schedule(const Scene& scene, double time);

    /// The first output time after the last one passed; infinity after time.end.
    double next_output() const { return next_output_; }
    /// Whether a step has reached next_output(); if so, that is passed.
    bool output_due(double time);
    /// Whether a checkpoint is due; if so, it is passed.
    bool checkpoint_due(double time);

private:
    void find_next_output(double time);

    double end_, every_, checkpoint_every_;
    long output_ = 0; ///< number of the next multiple
    double next_output_ = 0, next_checkpoint_ = 0;
};

} // namespace gapflow
