// Wall-clock time by stage.
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace gapflow {

/// Seconds since its construction.
class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

/// Seconds and number of calls of every named stage of a run. Passed to the functions that measure; not shared between threads.
class StageTimers {
public:
    struct Stage {
        double seconds = 0;
        long count = 0;
    };

    /// Adds the time until its end of life to a stage. May not outlive the registry.
    class Scope {
    public:
        explicit Scope(Stage& stage) : stage_(stage), start_(Clock::now()) {}
        ~Scope()
        {
            stage_.seconds += std::chrono::duration<double>(Clock::now() - start_).count();
            ++stage_.count;
        }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

    private:
        using Clock = std::chrono::steady_clock;
        Stage& stage_;
        Clock::time_point start_;
    };

    /// auto timer = timers.measure("projection");
    [[nodiscard]] Scope measure(const std::string& name) { return Scope(stages_[name]); }

    /// For scopes that are opened later.
    Stage& stage(const std::string& name) { return stages_[name]; }

    void add(const std::string& name, double seconds)
    {
        Stage& stage = stages_[name];
        stage.seconds += seconds;
        ++stage.count;
    }

    const std::map<std::string, Stage>& stages() const { return stages_; }
    /// 0 if the stage never ran.
    double seconds(const std::string& name) const
    {
        const auto stage = stages_.find(name);
        return stage == stages_.end() ? 0.0 : stage->second.seconds;
    }

private:
    std::map<std::string, Stage> stages_;
};

} // namespace gapflow
