#include "gapflow/grid/whole_field.hpp"

#include <cassert>

namespace gapflow {

namespace {

template <int D>
using Box = std::array<int, 2 * D>;

template <int D>
Box<D> box_of(const Index<D>& low, const Index<D>& high)
{
    Box<D> box;
    Eigen::Map<Index<D>>(box.data()) = low;
    Eigen::Map<Index<D>>(box.data() + D) = high;
    return box;
}

template <int D>
long count(const Index<D>& low, const Index<D>& high)
{
    return (high - low).template cast<long>().prod();
}

// Rank by rank on the root: f(rank, low, high).
template <int D, class F>
void for_each_part(const Communicator& comm, const Index<D>& low, const Index<D>& high, F&& f)
{
    f(0, low, high);
    for (int rank = 1; rank < comm.size(); ++rank) {
        Box<D> box;
        MPI_Recv(box.data(), 2 * D, MPI_INT, rank, 0, comm.mpi(), MPI_STATUS_IGNORE);
        f(rank, Index<D>(Eigen::Map<Index<D>>(box.data())), Index<D>(Eigen::Map<Index<D>>(box.data() + D)));
    }
}

} // namespace

template <int D>
std::vector<double> gather(const Grid<D>& grid, const Block<D>& all, const Index<D>& low, const Index<D>& high,
                           std::span<const double> own, int components)
{
    const Communicator& comm = grid.comm();
    assert(static_cast<long>(own.size()) == count<D>(low, high) * components);
    if (!comm.root()) {
        const Box<D> box = box_of<D>(low, high);
        MPI_Send(box.data(), 2 * D, MPI_INT, 0, 0, comm.mpi());
        MPI_Send(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, 0, 1, comm.mpi());
        return {};
    }
    std::vector<double> values(static_cast<std::size_t>(all.size * components)), received;
    for_each_part<D>(comm, low, high, [&](int rank, const Index<D>& first, const Index<D>& end) {
        const double* from = own.data();
        if (rank > 0) {
            received.resize(static_cast<std::size_t>(count<D>(first, end) * components));
            MPI_Recv(received.data(), static_cast<int>(received.size()), MPI_DOUBLE, rank, 1, comm.mpi(), MPI_STATUS_IGNORE);
            from = received.data();
        }
        for_each_index<D>(first, end, [&](const Index<D>& i) {
            std::copy_n(from, components, values.data() + all.offset(i) * components);
            from += components;
        });
    });
    return values;
}

template <int D>
std::vector<double> scatter(const Grid<D>& grid, const Block<D>& all, const Index<D>& low, const Index<D>& high,
                            std::span<const double> values)
{
    const Communicator& comm = grid.comm();
    std::vector<double> own(static_cast<std::size_t>(count<D>(low, high)));
    if (!comm.root()) {
        const Box<D> box = box_of<D>(low, high);
        MPI_Send(box.data(), 2 * D, MPI_INT, 0, 0, comm.mpi());
        MPI_Recv(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, 0, 1, comm.mpi(), MPI_STATUS_IGNORE);
        return own;
    }
    assert(static_cast<long>(values.size()) == all.size);
    std::vector<double> part;
    for_each_part<D>(comm, low, high, [&](int rank, const Index<D>& first, const Index<D>& end) {
        std::vector<double>& to = rank > 0 ? part : own;
        to.clear();
        for_each_index<D>(first, end, [&](const Index<D>& i) { to.push_back(values[all.offset(i)]); });
        if (rank > 0)
            MPI_Send(to.data(), static_cast<int>(to.size()), MPI_DOUBLE, rank, 1, comm.mpi());
    });
    return own;
}

namespace {

template <int D>
void list_values(StateArchive& archive, const std::string& name, const Grid<D>& grid, const Index<D>& whole,
                 const Index<D>& end, CellField<D>& field)
{
    const Block<D> all(Index<D>::Zero(), whole);
    if (archive.restoring()) {
        const std::vector<double>& stored = archive.stored_field(name);
        if (grid.comm().any(grid.comm().root() && static_cast<long>(stored.size()) != all.size))
            throw StateError("its field '" + name + "' is not of this scene's grid");
        const std::vector<double> own = scatter<D>(grid, all, grid.low(), end, stored);
        const double* from = own.data();
        for_each_index<D>(grid.low(), end, [&](const Index<D>& i) { field(i) = *from++; });
    } else {
        std::vector<double> own;
        for_each_index<D>(grid.low(), end, [&](const Index<D>& i) { own.push_back(field(i)); });
        std::vector<double> values = gather<D>(grid, all, grid.low(), end, own);
        if (grid.comm().root())
            archive.field(name) = std::move(values);
    }
}

} // namespace

template <int D>
void list_field(StateArchive& archive, const std::string& name, const Grid<D>& grid, CellField<D>& field)
{
    list_values<D>(archive, name, grid, grid.cells(), grid.high(), field);
}

template <int D>
void list_field(StateArchive& archive, const std::string& name, const Grid<D>& grid, FaceField<D>& field)
{
    for (int axis = 0; axis < D; ++axis) {
        Index<D> faces = grid.cells();
        faces[axis] += grid.periodic(axis) ? 0 : 1;
        list_values<D>(archive, name + "_" + "xyz"[axis], grid, faces, owned_faces_end(grid, axis), field[axis]);
    }
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<double> gather<D>(const Grid<D>&, const Block<D>&, const Index<D>&, const Index<D>&,                  \
                                           std::span<const double>, int);                                                      \
    template std::vector<double> scatter<D>(const Grid<D>&, const Block<D>&, const Index<D>&, const Index<D>&,                 \
                                            std::span<const double>);                                                          \
    template void list_field<D>(StateArchive&, const std::string&, const Grid<D>&, CellField<D>&);                             \
    template void list_field<D>(StateArchive&, const std::string&, const Grid<D>&, FaceField<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
