#include "gapflow/core/machine_memory.hpp"

#include <algorithm>
#include <fstream>
#include <limits>

#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gapflow {

double machine_memory()
{
    const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGE_SIZE);
    double bytes = pages > 0 && page > 0 ? static_cast<double>(pages) * static_cast<double>(page)
                                         : std::numeric_limits<double>::infinity();
    for (const char* file : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        double limit;
        if (std::ifstream(file) >> limit) // "max" is no number: no limit
            bytes = std::min(bytes, limit);
    }
    return bytes;
}

int ranks_on_this_machine(const Communicator& comm)
{
    MPI_Comm machine;
    MPI_Comm_split_type(comm.mpi(), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    int ranks = 1;
    MPI_Comm_size(machine, &ranks);
    MPI_Comm_free(&machine);
    return ranks;
}

void return_freed_memory()
{
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

} // namespace gapflow
