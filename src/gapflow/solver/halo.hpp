// Exchange of one layer of ghosts across the faces of a rank's block (no edges and corners: 5- and 7-point stencils).
#pragma once

#include "gapflow/grid/field.hpp"

#include <array>
#include <cstring>
#include <vector>

namespace gapflow {

/// Calls f(index of the row's first cell) for every row along the first axis of the box low <= i < high.
template <int D, class F>
void for_each_row(const Index<D>& low, const Index<D>& high, F&& f)
{
    Index<D> end = high;
    end[0] = low[0] + 1;
    for_each_index<D>(low, end, f);
}

/// Plan and buffers of the exchange. Ghosts beyond walls, open and inflow sides are left as they are.
template <int D, class T>
class Halo {
public:
    Halo() = default;
    /// `storage`: the box that is stored; low, high: the cells of this rank; neighbours: as Grid::neighbour.
    Halo(const Block<D>& storage, const Index<D>& low, const Index<D>& high, const std::array<int, 2 * D>& neighbours,
         const Communicator& comm);

    void exchange(T* data);
    /// Whether there is anything to exchange.
    bool active() const { return active_; }

private:
    struct Plane {
        Index<D> low, high;
    };
    void pack(const Plane& plane, const T* data, std::vector<T>& buffer) const;
    void unpack(const Plane& plane, const std::vector<T>& buffer, T* data) const;

    Block<D> storage_;
    std::array<int, 2 * D> neighbours_{};
    std::array<Plane, 2 * D> inner_, ghost_;
    std::array<std::vector<T>, 2 * D> send_, take_;
    MPI_Comm comm_ = MPI_COMM_NULL;
    int rank_ = 0;
    bool active_ = false;
};

/// The halo of a field on the grid.
template <int D, class T>
Halo<D, T> halo_of(const Grid<D>& grid, const Block<D>& storage)
{
    std::array<int, 2 * D> neighbours;
    for (int side = 0; side < 2 * D; ++side)
        neighbours[side] = grid.neighbour(side / 2, side % 2);
    return Halo<D, T>(storage, grid.low(), grid.high(), neighbours, grid.comm());
}

} // namespace gapflow
