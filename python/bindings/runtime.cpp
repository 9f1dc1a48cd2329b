#include "runtime.hpp"

#include "session.hpp"

namespace gapflow {

void Runtime::start()
{
    if (ended_)
        throw std::runtime_error("gapflow has been shut down, as Python is ending; nothing can be computed any more");
    if (!environment_)
        environment_ = std::make_unique<Environment>();
}

void Runtime::shutdown()
{
    ended_ = true;
    for (Session* session : std::vector<Session*>(sessions_))
        session->end_or_print();
    environment_.reset();
}

Runtime& runtime()
{
    static auto* const the = new Runtime; // sessions may be destroyed after static objects
    return *the;
}

} // namespace gapflow
