// The last step's fluid at the places of the new films' elements: on the same part of the master (method, "Film transport").
#pragma once

#include "gapflow/film/film_history.hpp"

#include <span>
#include <vector>

namespace gapflow {

/// v, tangential at the unit normal `from`, in the tangent plane of `to`: the least rotation from one normal to the other.
template <int D>
Vec<D> turned(const Vec<D>& v, const Vec<D>& from, const Vec<D>& to)
{
    return v - v.dot(to) / (1 + from.dot(to)) * (from + to);
}

/// The last step's fluid at the place of a new element. Vectors in the master's axes and along the element, but for the world's.
template <int D>
struct FluidInPlace {
    Vec<D> velocity = Vec<D>::Zero(); ///< relative to the master, mean over the volume
    /// The same on the new volume: sum of sqrt(old volume * new volume) times the velocity over the new volume. Has no more energy than the
    /// old fluid.
    Vec<D> reference = Vec<D>::Zero();
    Vec<D> acceleration = Vec<D>::Zero(); ///< by the pressure
    Vec<D> increment = Vec<D>::Zero();    ///< acceleration in the last step over what was put in place
    Vec<D> inertial = Vec<D>::Zero();     ///< acceleration relative to a master that turns: centrifugal and Coriolis
    Vec<D> world = Vec<D>::Zero();        ///< w, mean over the volume; world axes
    Vec<D> master = Vec<D>::Zero();       ///< of the old master there; world axes
    double volume = 0;                    ///< old volume there
    double covered = 0;                   ///< new volume where there was no film
};

/// One value for each element of the network; all 0 where a film's pair has no history. Collective.
template <int D>
std::vector<FluidInPlace<D>> put_in_place(const FilmNetwork<D>& network, std::span<const Solid<D>> solids,
                                          const std::vector<const FilmHistory<D>*>& history);

} // namespace gapflow
