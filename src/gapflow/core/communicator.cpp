#include "gapflow/core/communicator.hpp"

#include <petscsys.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef _OPENMP
#include <omp.h>
#endif

namespace gapflow {

namespace {

// A reduction to the root and a broadcast: MPI_Allreduce need not give the same bits on every rank.
template <class T>
void reduce(const Communicator& comm, T* values, int n, MPI_Datatype type, MPI_Op op)
{
    if (comm.size() == 1 || n == 0)
        return;
    MPI_Reduce(comm.root() ? MPI_IN_PLACE : values, values, n, type, op, 0, comm.mpi());
    MPI_Bcast(values, n, type, 0, comm.mpi());
}

} // namespace

Communicator::Communicator(MPI_Comm comm) : comm_(comm)
{
    MPI_Comm_rank(comm_, &rank_);
    MPI_Comm_size(comm_, &size_);
}

double Communicator::sum(double value) const
{
    reduce(*this, &value, 1, MPI_DOUBLE, MPI_SUM);
    return value;
}

double Communicator::max(double value) const
{
    reduce(*this, &value, 1, MPI_DOUBLE, MPI_MAX);
    return value;
}

double Communicator::min(double value) const
{
    reduce(*this, &value, 1, MPI_DOUBLE, MPI_MIN);
    return value;
}

long Communicator::sum(long value) const
{
    reduce(*this, &value, 1, MPI_LONG, MPI_SUM);
    return value;
}

long Communicator::max(long value) const
{
    reduce(*this, &value, 1, MPI_LONG, MPI_MAX);
    return value;
}

bool Communicator::any(bool value) const
{
    return max(static_cast<long>(value)) > 0;
}

void Communicator::sum(std::span<double> values) const
{
    reduce(*this, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_SUM);
}

void Communicator::max(std::span<double> values) const
{
    reduce(*this, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX);
}

void Communicator::broadcast(std::span<double> values, int root) const
{
    if (size_ > 1)
        MPI_Bcast(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, root, comm_);
}

namespace {

/// Threads of this rank where the user gives no number: the cores that the process was bound to, or else an equal share of
/// the machine's.
int default_threads(int cores)
{
    if (cores < static_cast<int>(std::thread::hardware_concurrency()))
        return cores;
    MPI_Comm machine;
    int ranks = 1;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    MPI_Comm_size(machine, &ranks);
    MPI_Comm_free(&machine);
    return std::max(1, cores / ranks);
}

/// Memory of grid-sized arrays that a time step frees stays with the process for the next step: returning pages to the system and
/// requesting them again costs as much as computing on them.
void keep_freed_memory()
{
#ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
#endif
}

} // namespace

Environment::Environment()
{
    keep_freed_memory();
    int argc = 1;
    char name[] = "gapflow";
    char skip_rc[] = "-skip_petscrc";
    char* words[] = {name, skip_rc, nullptr};
    char** argv = words;
    argc = 2;
    PetscInitialize(&argc, &argv, nullptr, nullptr);
    PetscPopSignalHandler();
    PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
#ifdef _OPENMP
    const int threads = default_threads(omp_get_num_procs()); // collective
    if (!std::getenv("OMP_NUM_THREADS"))
        omp_set_num_threads(threads);
#endif
}

Environment::~Environment()
{
    PetscFinalize();
}

} // namespace gapflow
