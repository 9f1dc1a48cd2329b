// First accelerations of the free bodies when everything starts from rest (method, "The coupled system"):
//
//     L q + K a = 0,    M a - K^T q = F,
//
// F: gravity with buoyancy, given forces and torques, springs. Ideal fluid; prescribed and fixed bodies are held, contacts do not act.
#pragma once

#include "gapflow/core/communicator.hpp"
#include "gapflow/scene/scene.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace gapflow {

struct FirstAccelerations {
    std::vector<std::string> bodies;           ///< free ones, in the scene's order
    std::vector<Eigen::VectorXd> acceleration; ///< of each: of the centre of mass and angular, world axes
    int iterations = 0;
};

/// With the gap model of the scene, "parts" too. Collective. Throws as added_mass().
FirstAccelerations first_accelerations(const Scene& scene, const Communicator& comm);

} // namespace gapflow
