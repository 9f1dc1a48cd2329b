#include "gapflow/solver/halo.hpp"

#include <algorithm>

namespace gapflow {

template <int D, class T>
Halo<D, T>::Halo(const Block<D>& storage, const Index<D>& low, const Index<D>& high, const std::array<int, 2 * D>& neighbours,
                 const Communicator& comm)
    : storage_(storage), neighbours_(neighbours), comm_(comm.mpi()), rank_(comm.rank())
{
    for (int side = 0; side < 2 * D; ++side) {
        const int axis = side / 2;
        inner_[side] = ghost_[side] = {low, high};
        if (side % 2) {
            inner_[side].low[axis] = high[axis] - 1;
            ghost_[side].low[axis] = high[axis];
            ghost_[side].high[axis] = high[axis] + 1;
        } else {
            inner_[side].high[axis] = low[axis] + 1;
            ghost_[side].low[axis] = low[axis] - 1;
            ghost_[side].high[axis] = low[axis];
        }
        if (neighbours[side] < 0)
            continue;
        active_ = true;
        send_[side].resize((inner_[side].high - inner_[side].low).template cast<long>().prod());
        take_[side].resize(send_[side].size());
    }
}

template <int D, class T>
void Halo<D, T>::pack(const Plane& plane, const T* data, std::vector<T>& buffer) const
{
    T* to = buffer.data();
    const int width = plane.high[0] - plane.low[0];
    for_each_row<D>(plane.low, plane.high, [&](const Index<D>& row) {
        std::copy_n(data + storage_.offset(row), width, to);
        to += width;
    });
}

template <int D, class T>
void Halo<D, T>::unpack(const Plane& plane, const std::vector<T>& buffer, T* data) const
{
    const T* from = buffer.data();
    const int width = plane.high[0] - plane.low[0];
    for_each_row<D>(plane.low, plane.high, [&](const Index<D>& row) {
        std::copy_n(from, width, data + storage_.offset(row));
        from += width;
    });
}

template <int D, class T>
void Halo<D, T>::exchange(T* data)
{
    if (!active_)
        return;
    MPI_Request requests[4 * D];
    int pending = 0;
    // What leaves through side 1 arrives through side 0 of the neighbour: the tag is the side it left through.
    for (int side = 0; side < 2 * D; ++side)
        if (neighbours_[side] >= 0 && neighbours_[side] != rank_)
            MPI_Irecv(take_[side].data(), static_cast<int>(take_[side].size() * sizeof(T)), MPI_BYTE, neighbours_[side],
                      side ^ 1, comm_, &requests[pending++]);
    for (int side = 0; side < 2 * D; ++side) {
        if (neighbours_[side] < 0)
            continue;
        pack(inner_[side], data, send_[side]);
        if (neighbours_[side] != rank_)
            MPI_Isend(send_[side].data(), static_cast<int>(send_[side].size() * sizeof(T)), MPI_BYTE, neighbours_[side], side,
                      comm_, &requests[pending++]);
    }
    MPI_Waitall(pending, requests, MPI_STATUSES_IGNORE);
    for (int side = 0; side < 2 * D; ++side)
        if (neighbours_[side] >= 0)
            unpack(ghost_[side], neighbours_[side] == rank_ ? send_[side ^ 1] : take_[side], data);
}

template class Halo<2, float>;
template class Halo<3, float>;
template class Halo<2, double>;
template class Halo<3, double>;

} // namespace gapflow
