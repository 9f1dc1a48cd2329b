#include "gapflow/output/progress.hpp"

#include <cmath>
#include <string>

#include <unistd.h>

namespace gapflow {

namespace {

// h:mm:ss; more than a thousand hours or no estimate yet: dashes.
std::string duration_text(double seconds)
{
    if (!(seconds >= 0.0 && seconds < 3.6e6))
        return "-:--:--";
    const long s = std::lround(seconds);
    char text[32];
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", s / 3600, s / 60 % 60, s % 60);
    return text;
}

std::string line_of(const ProgressState& state, double end_time, double remaining)
{
    char text[160];
    std::snprintf(text, sizeof text, "t = %.4g of %.4g  dt = %.2e  step %ld  %d iterations  ETA ", state.time, end_time,
                  state.dt, state.step, state.iterations);
    std::string line = text + duration_text(remaining);
    if (state.unsteadiness) {
        std::snprintf(text, sizeof text, "  unsteadiness %.1e", *state.unsteadiness);
        line += text;
    }
    return line;
}

} // namespace

ProgressStyle choose_progress_style(const Communicator& comm, bool quiet)
{
    if (quiet || !comm.root())
        return ProgressStyle::silent;
    return ::isatty(STDERR_FILENO) ? ProgressStyle::terminal : ProgressStyle::log;
}

Progress::Progress(ProgressStyle style, double start_time, double end_time, std::FILE* out)
    : style_(style), start_time_(start_time), end_time_(end_time), out_(out), started_(Clock::now())
{
}

Progress::~Progress()
{
    if (on_screen_)
        std::fputc('\n', out_);
    std::fflush(out_);
}

void Progress::step(const ProgressState& state)
{
    if (style_ == ProgressStyle::terminal && (!on_screen_ || Clock::now() - painted_ > std::chrono::milliseconds(100)))
        paint(state);
}

void Progress::output(const ProgressState& state)
{
    if (style_ != ProgressStyle::silent)
        paint(state);
}

void Progress::clear()
{
    if (!on_screen_)
        return;
    std::fputs("\r\033[K", out_);
    std::fflush(out_);
    on_screen_ = false;
}

void Progress::paint(const ProgressState& state)
{
    painted_ = Clock::now();
    const double elapsed = std::chrono::duration<double>(painted_ - started_).count();
    const double remaining = elapsed * (end_time_ - state.time) / (state.time - start_time_);
    const std::string line = line_of(state, end_time_, remaining);
    if (style_ == ProgressStyle::terminal) {
        std::fprintf(out_, "\r%s\033[K", line.c_str());
        on_screen_ = true;
    } else {
        std::fprintf(out_, "%s\n", line.c_str());
    }
    std::fflush(out_);
}

CountProgress::CountProgress(ProgressStyle style, std::string what, std::FILE* out)
    : style_(style), what_(std::move(what)), out_(out)
{
}

CountProgress::~CountProgress()
{
    if (on_screen_)
        std::fputs("\r\033[K", out_);
    std::fflush(out_);
}

void CountProgress::operator()(std::size_t done, std::size_t of)
{
    const auto wait = style_ == ProgressStyle::terminal ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10'000);
    if (style_ == ProgressStyle::silent || Clock::now() - painted_ < wait)
        return;
    painted_ = Clock::now();
    on_screen_ = style_ == ProgressStyle::terminal;
    std::fprintf(out_, on_screen_ ? "\r%s: %zu of %zu\033[K" : "%s: %zu of %zu\n", what_.c_str(), done, of);
    std::fflush(out_);
}

} // namespace gapflow
