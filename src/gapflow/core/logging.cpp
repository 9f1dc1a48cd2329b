#include "gapflow/core/logging.hpp"

#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace gapflow {

namespace {

// Not registered with spdlog: its registry is global.
std::shared_ptr<spdlog::logger> make_logger(const Communicator& comm, bool quiet, spdlog::sink_ptr sink)
{
    auto logger = std::make_shared<spdlog::logger>("gapflow", std::move(sink));
    logger->set_pattern("%^%l%$: %v");
    logger->set_level(!comm.root() ? spdlog::level::off : quiet ? spdlog::level::warn : spdlog::level::info);
    logger->flush_on(spdlog::level::info);
    return logger;
}

} // namespace

Logger::Logger(const Communicator& comm, bool quiet)
    : logger_(make_logger(comm, quiet, std::make_shared<spdlog::sinks::stderr_color_sink_mt>()))
{
}

Logger::Logger(const Communicator& comm, bool quiet, std::ostream& out)
    : logger_(make_logger(comm, quiet, std::make_shared<spdlog::sinks::ostream_sink_mt>(out)))
{
}

// The message is an argument, not a format: it may hold braces.
void Logger::info(std::string_view message) const
{
    logger_->info("{}", message);
}
void Logger::warning(std::string_view message) const
{
    logger_->warn("{}", message);
}
void Logger::error(std::string_view message) const
{
    logger_->error("{}", message);
}

void Logger::warn_once(const std::string& message)
{
    if (told_.insert(message).second)
        warning(message);
}

} // namespace gapflow
