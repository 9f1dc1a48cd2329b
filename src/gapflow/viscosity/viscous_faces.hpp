// Role of the grid's faces in the lattice of the viscous step: a point of it, following a neighbour, or neither (method, "Viscosity").
#pragma once

#include "gapflow/viscosity/viscous_system.hpp"
#include "gapflow/viscosity/wall_rays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace gapflow {

// ViscousFaces::reach in cells.
constexpr double ray_length = 1.7;
// No surface counts as nearer to a lattice point than this, in dx.
constexpr double least_distance = 1e-3;
// Faces that a thread looks at in a row.
constexpr long faces_a_chunk = 256;

enum class FaceRole { none, active, following };

/// Role of a face in the lattice.
template <int D>
struct LatticeFace {
    FaceRole role = FaceRole::none;
    double share = 1; ///< s
    int image = -1;
    Vec<D> foot;  ///< x*
    Vec<D> shift; ///< centroid less centre
    Vec<D> centroid;
};

template <int D>
class ViscousFaces {
public:
    explicit ViscousFaces(const Coupling<D>& coupling)
        : coupling_(coupling), grid_(*coupling.grid), fractions_(*coupling.fractions),
          cell_mass_(coupling.density * std::pow(grid_.dx(), D))
    {
        find_walls();
        mark_surfaces();
    }

    /// Whole faces by rows; those that surfaces cut, and those on sides of the domain, one by one. Collective.
    void classify(FaceField<D, std::int8_t>& active);
    /// Role of a cut face in the lattice. Any face of this rank or of the ghost layer: the same on all ranks. Moves the rays.
    LatticeFace<D> examine(WallRays<D>& rays, int axis, const Index<D>& f) const;

    bool on_side(int axis, const Index<D>& f) const
    {
        return !grid_.periodic(axis) && (f[axis] == 0 || f[axis] == grid_.cells()[axis]);
    }
    double mass(int axis, const Index<D>& f) const
    {
        return cell_mass_ * coupling_.open(axis, f) * (on_side(axis, f) ? 0.5 : 1.0) * grid_.spread(axis, f[axis]);
    }
    /// Share of a face's inertia that counts next to walls of the domain, half a cell from it: of its part at either wall, the third of a
    /// cell that adheres to the wall moves with the wall, and the wall bears the pressure's force on it. Plane Poiseuille flow is then exact.
    double share_beside_walls(int axis, const Index<D>& f) const;
    /// Rays from a face are this long: past a neighbour in the solid, or next to one, up to its surface.
    double reach(const Index<D>& f) const
    {
        double widest = 1;
        for (int k = 0; k < D && grid_.graded(); ++k)
            widest = std::max({widest, grid_.width(k, f[k] - 1), grid_.width(k, f[k]), grid_.width(k, f[k] + 1)});
        return ray_length * widest * grid_.dx();
    }
    bool near_surface(int axis, const Index<D>& f) const { return surface_(f) || surface_(Index<D>(f - step<D>(axis))); }
    /// Does a surface cut any of the `count` faces of a row?
    bool any_cut(int axis, const Index<D>& row, int count) const
    {
        const int* cut = &fractions_.cut(axis, row);
        int largest = -1;
        for (int i = 0; i < count; ++i)
            largest = std::max(largest, cut[i]);
        return largest >= 0;
    }
    /// Row of the velocity component along `axis` of a solid's image at x.
    Twist<D> row(int image, int axis, const Vec<D>& x) const
    {
        const Image<D>& at = this->image(image);
        return wrench<D>(unit<D>(axis), x - coupling_.solids[at.solid].centre - at.shift);
    }
    Twist<D> wall_row(int solid, int axis, const Vec<D>& x) const
    {
        return wrench<D>(unit<D>(axis), x - coupling_.solids[solid].centre);
    }
    /// Solid of a wall of the domain.
    int wall(int axis, int end) const { return wall_[2 * axis + end]; }
    const Image<D>& image(int i) const { return coupling_.clipper->images()[i]; }
    /// A thread has its own.
    WallRays<D> rays() const { return WallRays<D>(*coupling_.clipper, grid_.dx()); }

private:
    void find_walls();
    void mark_surfaces();
    bool is_open(int axis, const Index<D>& f) const;
    template <class F>
    void for_owned_rows(int axis, F&& f) const;

    const Coupling<D>& coupling_;
    const Grid<D>& grid_;
    const FaceFractions<D>& fractions_;
    double cell_mass_; ///< rho dx^D
    std::array<int, 2 * D> wall_;
    CellField<D, std::int8_t> surface_;
};

} // namespace gapflow
