// How much memory the machine has, and how many ranks share it.
#include "gapflow/core/machine_memory.hpp"

#include <gtest/gtest.h>

namespace gapflow {
namespace {

TEST(MachineMemory, IsSharedByRanksOnIt)
{
    const double mebibyte = 1048576;
    EXPECT_GT(machine_memory(), 100 * mebibyte);
    EXPECT_EQ(ranks_on_this_machine(Communicator(MPI_COMM_SELF)), 1);
}

} // namespace
} // namespace gapflow
