// Pressure sides (method, "Sides of the domain"): the reduced pressure beyond them acts on the fluid in the side, on films that end there
// and on bodies that stick out. The coupled system has the pressure 0 beyond all open sides; what is beyond pressure sides changes u*.
#pragma once

#include "gapflow/stepping/model.hpp"
#include "gapflow/stepping/transport.hpp"

#include <array>
#include <vector>

namespace gapflow {

/// Reduced pressure beyond every mouth: of mouths on pressure sides that of the side, else 0.
template <int D>
std::vector<double> pressure_beyond_mouths(const Model<D>& model, const std::vector<Mouth<D>>& mouths, double time);

/// The force and torque on every body of the pressure beyond pressure sides, on the part that sticks out. Collective.
template <int D>
std::vector<Twist<D>> wrenches_from_beyond(const Model<D>& model, const Coupling<D>& there, double time);

/// Adds a step's impulse of the pressures beyond to u* of the bulk and V* of free bodies; to the fluxes of mouths project() adds it, after
/// their drag. Collective.
template <int D>
void push_from_beyond(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const Coupling<D>& there,
                      const Step& step, Intermediate<D>& star);

} // namespace gapflow
