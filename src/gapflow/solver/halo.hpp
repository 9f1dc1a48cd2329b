// Exchange of one layer of ghosts across the faces of a rank's block (no edges and corners: 5- and 7-point stencils).
#pragma once

#include "gapflow/grid/field.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace gapflow {

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
    /// Whether only the sides normal to the last axis have neighbours.
    bool only_last_axis() const
    {
        return std::all_of(neighbours_.begin(), neighbours_.end() - 2, [](int neighbour) { return neighbour < 0; });
    }
    /// Whether the low (end = 0) or high side of an axis has a neighbour.
    bool active(int axis, int end) const { return neighbours_[2 * axis + end] >= 0; }

private:
    struct Plane {
        Index<D> low, high;
    };
    void pack(const Plane& plane, const T* data, std::vector<T>& buffer) const;
    void unpack(const Plane& plane, const std::vector<T>& buffer, T* data) const;

    static std::array<int, 2 * D> none()
    {
        std::array<int, 2 * D> all;
        all.fill(-1);
        return all;
    }

    Block<D> storage_;
    std::array<int, 2 * D> neighbours_ = none();
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
