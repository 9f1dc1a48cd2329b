// Work shared out among the ranks, where each makes a part of what all of them need.
#pragma once

#include "gapflow/core/byte_archive.hpp"
#include "gapflow/core/communicator.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace gapflow {

/// What each rank gives, by rank. Collective.
std::vector<Bytes> gather(const Communicator& comm, Bytes mine);

/// Of items 0 <= i < n those that is_mine(i) go from this rank to all others: write(archive, i) here, read(archive, i) there. Each is one rank's.
/// They go in pieces, which stay in the cache and need little memory. Collective.
template <class IsMine, class Write, class Read>
void exchange_items(const Communicator& comm, std::size_t n, IsMine&& is_mine, Write&& write, Read&& read)
{
    constexpr std::size_t full = std::size_t{1} << 21; // bytes of a message
    if (comm.size() == 1)
        return;
    std::size_t next = 0;
    for (bool more = true; more;) {
        ByteWriter writer;
        for (; next < n && writer.size() < full; ++next)
            if (is_mine(next)) {
                writer(next);
                write(writer, next);
            }
        more = false;
        const std::vector<Bytes> all = gather(comm, writer.take());
        for (int rank = 0; rank < comm.size(); ++rank) {
            more = more || all[rank].size() >= full;
            if (rank == comm.rank())
                continue;
            for (ByteReader reader(all[rank]); !reader.at_end();) {
                std::size_t i;
                reader(i);
                read(reader, i);
            }
        }
    }
}

/// The values of each rank, none of which owns memory. Collective.
template <class T>
std::vector<std::vector<T>> values_by_rank(const Communicator& comm, const std::vector<T>& mine)
{
    ByteWriter writer;
    writer(mine);
    std::vector<std::vector<T>> all;
    for (const Bytes& bytes : gather(comm, writer.take())) {
        ByteReader reader(bytes);
        reader(all.emplace_back());
    }
    return all;
}

/// The values of all ranks, in the order of the ranks. Collective.
template <class T>
std::vector<T> all_values(const Communicator& comm, const std::vector<T>& mine)
{
    std::vector<T> all;
    for (const std::vector<T>& part : values_by_rank(comm, mine))
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

template <class T>
using NumberedItems = std::vector<std::pair<long, T>>;

/// Items of all ranks, none of which owns memory, in the order of their numbers; of equal numbers in the order of ranks. `parts`: this rank's, in
/// this order. Collective.
template <class T>
NumberedItems<T> all_items(const Communicator& comm, const std::vector<NumberedItems<T>>& parts)
{
    NumberedItems<T> mine;
    for (const NumberedItems<T>& part : parts)
        mine.insert(mine.end(), part.begin(), part.end());
    if (comm.size() == 1)
        return mine;
    NumberedItems<T> all = all_values(comm, mine);
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return all;
}

} // namespace gapflow
