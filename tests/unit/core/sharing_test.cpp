// What ranks exchange. Run on several ranks (ctest -L mpi).
#include "gapflow/core/sharing.hpp"

#include <gtest/gtest.h>

namespace gapflow {
namespace {

// More than a message holds, and not alike on all ranks.
TEST(Sharing, EveryItemReachesAllRanks)
{
    const Communicator comm(MPI_COMM_WORLD);
    constexpr std::size_t n = 4000;
    std::vector<std::vector<int>> items(n);
    const auto is_mine = [&](std::size_t i) { return static_cast<int>(i * i % 7) % comm.size() == comm.rank(); };
    for (std::size_t i = 0; i < n; ++i)
        if (is_mine(i))
            items[i].assign(1000 + i % 50, static_cast<int>(i));
    exchange_items(
        comm, n, is_mine, [&](ByteWriter& out, std::size_t i) { out(items[i]); },
        [&](ByteReader& in, std::size_t i) { in(items[i]); });
    for (std::size_t i = 0; i < n; ++i)
        ASSERT_EQ(items[i], std::vector<int>(1000 + i % 50, static_cast<int>(i)));
}

TEST(Sharing, ValuesComeInTheOrderOfRanks)
{
    const Communicator comm(MPI_COMM_WORLD);
    const std::vector<int> all = all_values(comm, std::vector<int>(comm.rank(), comm.rank())); // none of rank 0
    std::vector<int> expected;
    for (int rank = 0; rank < comm.size(); ++rank)
        expected.insert(expected.end(), rank, rank);
    EXPECT_EQ(all, expected);
}

TEST(Sharing, ItemsComeInTheOrderOfTheirNumbers)
{
    const Communicator comm(MPI_COMM_WORLD);
    std::vector<NumberedItems<int>> parts(2);
    for (int i = comm.rank(); i < 100; i += comm.size())
        parts[i >= 50].emplace_back(i, i * i);
    const NumberedItems<int> all = all_items(comm, parts);
    ASSERT_EQ(all.size(), 100u);
    for (int i = 0; i < 100; ++i)
        EXPECT_EQ(all[i], std::pair(static_cast<long>(i), i * i));
}

} // namespace
} // namespace gapflow
