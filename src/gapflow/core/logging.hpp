// Messages to the user on stderr.
#pragma once

#include "gapflow/core/communicator.hpp"

#include <iosfwd>
#include <memory>
#include <set>
#include <string>
#include <string_view>

namespace spdlog {
class logger;
}

namespace gapflow {

/// Writes "level: message" lines, without time, from rank 0 only; with `quiet` no information, only warnings and errors.
/// Copies share their sink.
class Logger {
public:
    Logger(const Communicator& comm, bool quiet);
    /// Into a stream that outlives the logger, instead of stderr.
    Logger(const Communicator& comm, bool quiet, std::ostream& out);

    void info(std::string_view message) const;
    void warning(std::string_view message) const;
    void error(std::string_view message) const;
    /// Warns of each text the first time only: notes that a run would repeat at every step.
    void warn_once(const std::string& message);

private:
    std::shared_ptr<spdlog::logger> logger_;
    std::set<std::string> told_;
};

} // namespace gapflow
