// Errors that reach the user. Programmer's errors are asserts.
#pragma once

#include <stdexcept>
#include <string>

namespace gapflow {

/// Bad usage or bad scene: found before any computation. Exit status 2.
/// The message names file, line, key, value, allowed range and the remedy.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The computation failed (no convergence, sealed fluid squeezed by a prescribed body, disk full). Exit status 1.
class ComputationError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace gapflow
