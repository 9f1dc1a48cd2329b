#include "gapflow/core/sharing.hpp"

#include <limits>

namespace gapflow {

std::vector<Bytes> gather(const Communicator& comm, Bytes mine)
{
    std::vector<long> sizes(comm.size(), static_cast<long>(mine.size()));
    std::vector<Bytes> all(comm.size());
    all[comm.rank()] = std::move(mine);
    MPI_Allgather(MPI_IN_PLACE, 1, MPI_LONG, sizes.data(), 1, MPI_LONG, comm.mpi());
    for (int rank = 0; rank < comm.size(); ++rank) {
        all[rank].resize(sizes[rank]);
        constexpr long most = std::numeric_limits<int>::max(); // of one message
        for (long start = 0; start < sizes[rank]; start += most)
            MPI_Bcast(all[rank].data() + start, static_cast<int>(std::min(most, sizes[rank] - start)), MPI_BYTE, rank,
                      comm.mpi());
    }
    return all;
}

} // namespace gapflow
