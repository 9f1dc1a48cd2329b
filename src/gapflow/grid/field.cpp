#include "gapflow/grid/field.hpp"

#include <cstdint>

namespace gapflow {

namespace {

template <class T>
MPI_Datatype mpi_type();
template <>
MPI_Datatype mpi_type<double>()
{
    return MPI_DOUBLE;
}
template <>
MPI_Datatype mpi_type<float>()
{
    return MPI_FLOAT;
}
template <>
MPI_Datatype mpi_type<int>()
{
    return MPI_INT;
}
template <>
MPI_Datatype mpi_type<std::int8_t>()
{
    return MPI_INT8_T;
}

} // namespace

// Axis by axis, each over the whole width of the block along the other axes, so that corners arrive too.
template <int D, class T>
void exchange(const Grid<D>& grid, CellField<D, T>& field, int layers)
{
    if (layers < 0)
        layers = grid.ghost();
    const Block<D>& block = field.block();
    std::vector<T> out, in;
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end) { // end 1: send my last cells up, receive my low ghosts from below
            const int to = grid.neighbour(axis, end), from = grid.neighbour(axis, 1 - end);
            Index<D> send_low = block.low, send_high = block.high, take_low = block.low, take_high = block.high;
            if (end == 1) {
                send_low[axis] = grid.high()[axis] - layers;
                send_high[axis] = grid.high()[axis];
                take_low[axis] = grid.low()[axis] - layers;
                take_high[axis] = grid.low()[axis];
            } else {
                send_low[axis] = grid.low()[axis];
                send_high[axis] = grid.low()[axis] + layers;
                take_low[axis] = grid.high()[axis];
                take_high[axis] = grid.high()[axis] + layers;
            }
            out.clear();
            if (to >= 0)
                for_each_index<D>(send_low, send_high, [&](const Index<D>& c) { out.push_back(field(c)); });
            if (from < 0 && to < 0)
                continue;
            if (to == grid.comm().rank() && from == to) {
                in.swap(out);
            } else {
                in.resize((take_high - take_low).template cast<long>().prod());
                MPI_Sendrecv(out.data(), static_cast<int>(out.size()), mpi_type<T>(), to >= 0 ? to : MPI_PROC_NULL,
                             2 * axis + end, in.data(), static_cast<int>(in.size()), mpi_type<T>(),
                             from >= 0 ? from : MPI_PROC_NULL, 2 * axis + end, grid.comm().mpi(), MPI_STATUS_IGNORE);
            }
            if (from >= 0) {
                const T* value = in.data();
                for_each_index<D>(take_low, take_high, [&](const Index<D>& c) { field(c) = *value++; });
            }
        }
}

template <int D, class T>
void exchange(const Grid<D>& grid, FaceField<D, T>& field, int layers)
{
    for (int axis = 0; axis < D; ++axis)
        exchange(grid, field[axis], layers);
}

#define GAPFLOW_INSTANTIATE(D, T)                                                                                              \
    template void exchange<D, T>(const Grid<D>&, CellField<D, T>&, int);                                                       \
    template void exchange<D, T>(const Grid<D>&, FaceField<D, T>&, int);
GAPFLOW_INSTANTIATE(2, double)
GAPFLOW_INSTANTIATE(3, double)
GAPFLOW_INSTANTIATE(2, float)
GAPFLOW_INSTANTIATE(3, float)
GAPFLOW_INSTANTIATE(2, int)
GAPFLOW_INSTANTIATE(3, int)
GAPFLOW_INSTANTIATE(2, std::int8_t)
GAPFLOW_INSTANTIATE(3, std::int8_t)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
