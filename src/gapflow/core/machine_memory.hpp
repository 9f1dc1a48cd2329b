// How much memory there is, and giving it back.
#pragma once

#include "gapflow/core/communicator.hpp"

namespace gapflow {

/// Bytes that this machine, or the control group that the process is in, lets all its processes use; infinity if unknown.
double machine_memory();

/// Ranks of the communicator on this rank's machine. Collective.
int ranks_on_this_machine(const Communicator& comm);

/// Hands the pages of freed small blocks, which the allocator keeps between blocks in use, back to the system (glibc; else nothing).
void return_freed_memory();

} // namespace gapflow
