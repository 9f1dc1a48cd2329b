// Shared by all sessions of a Python process: MPI and PETSc, started once, and a lock, because neither allows two threads at once.
#pragma once

#include "gapflow/core/communicator.hpp"

#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <vector>

namespace gapflow {

class Session;

class Runtime {
public:
    /// MPI and PETSc, started by the first call. Throws std::runtime_error after shutdown(). Needs the GIL.
    void start();
    /// Ends all sessions, then PETSc, and MPI if start() started it. Errors are printed. Needs the GIL.
    void shutdown();

    void enter(Session* session) { sessions_.push_back(session); }
    void leave(Session* session) { std::erase(sessions_, session); }
    std::mutex& lock() { return lock_; }

private:
    std::unique_ptr<Environment> environment_;
    bool ended_ = false;
    std::vector<Session*> sessions_; ///< in the order of their creation, the same on all ranks
    std::mutex lock_;
};

/// The only one of the process: MPI can be started once only. Never destroyed.
Runtime& runtime();

/// A long call: other Python threads run, other computations wait. The lock is never held while waiting for the GIL.
class Computing {
public:
    Computing() : lock_(runtime().lock()) {}

private:
    pybind11::gil_scoped_release others_run_;
    std::lock_guard<std::mutex> lock_;
};

} // namespace gapflow
