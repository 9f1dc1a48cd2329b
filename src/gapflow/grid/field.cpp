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
    std::array<LargeVector<T>, 2> out, in;
    for (int axis = 0; axis < D; ++axis) {
        // The layers of an end: this rank's last cells there, and the ghosts beyond.
        struct Layers {
            Index<D> low, high;
        };
        const auto layers_from = [&](int first) {
            Layers result{block.low, block.high};
            result.low[axis] = first;
            result.high[axis] = first + layers;
            return result;
        };
        const int low = grid.low()[axis], high = grid.high()[axis];
        const std::array<Layers, 2> inner = {layers_from(low), layers_from(high - layers)},
                                    ghosts = {layers_from(low - layers), layers_from(high)};
        const int width = block.high[0] - block.low[0], row = axis == 0 ? layers : width;
        const long size = (inner[0].high - inner[0].low).template cast<long>().prod();
        MPI_Request requests[4];
        int pending = 0;
        const auto neighbour = [&](int end) { return grid.neighbour(axis, end); };
        const auto is_other = [&](int end) { return neighbour(end) >= 0 && neighbour(end) != grid.comm().rank(); };
        // What leaves through the high end arrives through the low end of the neighbour: the tag is the end it left through.
        for (int end = 0; end < 2; ++end)
            if (is_other(end)) {
                in[end].resize(size);
                MPI_Irecv(in[end].data(), static_cast<int>(size), mpi_type<T>(), neighbour(end), 2 * axis + 1 - end,
                          grid.comm().mpi(), &requests[pending++]);
            }
        for (int end = 0; end < 2; ++end) {
            if (neighbour(end) < 0)
                continue;
            out[end].resize(size);
            T* to = out[end].data();
            for_each_row<D>(inner[end].low, inner[end].high,
                            [&](const Index<D>& first) { to = std::copy_n(&field(first), row, to); });
            if (is_other(end))
                MPI_Isend(out[end].data(), static_cast<int>(size), mpi_type<T>(), neighbour(end), 2 * axis + end,
                          grid.comm().mpi(), &requests[pending++]);
        }
        MPI_Waitall(pending, requests, MPI_STATUSES_IGNORE);
        for (int end = 0; end < 2; ++end) {
            if (neighbour(end) < 0)
                continue;
            const T* from = (is_other(end) ? in[end] : out[1 - end]).data();
            for_each_row<D>(ghosts[end].low, ghosts[end].high, [&](const Index<D>& first) {
                std::copy_n(from, row, &field(first));
                from += row;
            });
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
