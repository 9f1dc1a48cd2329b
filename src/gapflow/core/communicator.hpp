// The ranks of a run. Every reduction goes through here; results are bitwise the same on all ranks.
#pragma once

#include <mpi.h>

#include <span>

namespace gapflow {

/// Value-type handle of an MPI communicator (not owning).
class Communicator {
public:
    explicit Communicator(MPI_Comm comm = MPI_COMM_WORLD);

    MPI_Comm mpi() const { return comm_; }
    int rank() const { return rank_; }
    int size() const { return size_; }
    bool root() const { return rank_ == 0; }

    double sum(double value) const;
    double max(double value) const;
    double min(double value) const;
    long sum(long value) const;
    long max(long value) const;
    bool any(bool value) const;
    /// In place, element by element.
    void sum(std::span<double> values) const;
    void max(std::span<double> values) const;
    void broadcast(std::span<double> values, int root = 0) const;

private:
    MPI_Comm comm_;
    int rank_ = 0;
    int size_ = 1;
};

/// Starts MPI and PETSc for the lifetime of the object (PETSc does not get the command line), and chooses the number of threads
/// unless OMP_NUM_THREADS is set; create one in main().
class Environment {
public:
    Environment();
    ~Environment();
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;
};

} // namespace gapflow
