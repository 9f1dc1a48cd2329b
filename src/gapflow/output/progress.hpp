// Progress of a run: a line that repaints itself on a terminal, a line per output time into a pipe.
#pragma once

#include "gapflow/core/communicator.hpp"

#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>

namespace gapflow {

enum class ProgressStyle { terminal, log, silent };

/// Silent with `quiet` and on ranks other than 0; else by what stderr is.
ProgressStyle choose_progress_style(const Communicator& comm, bool quiet);

struct ProgressState {
    double time = 0, dt = 0; ///< reached; of the last step
    long step = 0;
    int iterations = 0;                      ///< of the last solve
    std::optional<double> unsteadiness = {}; ///< where the run ends once it is small
};

class Progress {
public:
    /// `out` outlives the object.
    Progress(ProgressStyle style, double start_time, double end_time, std::FILE* out = stderr);
    /// Ends the terminal's line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// After every step: repaints the terminal's line, at most ten times a second.
    void step(const ProgressState& state);
    /// After every output time: a line into the log; the terminal's line at once.
    void output(const ProgressState& state);
    /// Erases the terminal's line before other text goes there.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    void paint(const ProgressState& state);

    ProgressStyle style_;
    double start_time_, end_time_;
    std::FILE* out_;
    Clock::time_point started_, painted_;
    bool on_screen_ = false;
};

/// Called after each part of a long work: parts done, parts in all.
using CountWatcher = std::function<void(std::size_t done, std::size_t of)>;

/// Progress of work with many parts, as "frames: 3 of 20": on a terminal a line that repaints itself, in a log a line every ten
/// seconds, so that short work adds none.
class CountProgress {
public:
    /// `out` outlives the object.
    CountProgress(ProgressStyle style, std::string what, std::FILE* out = stderr);
    /// Erases the terminal's line.
    ~CountProgress();
    CountProgress(const CountProgress&) = delete;
    CountProgress& operator=(const CountProgress&) = delete;

    void operator()(std::size_t done, std::size_t of);

private:
    using Clock = std::chrono::steady_clock;

    ProgressStyle style_;
    std::string what_;
    std::FILE* out_;
    Clock::time_point painted_ = Clock::now();
    bool on_screen_ = false;
};

} // namespace gapflow
