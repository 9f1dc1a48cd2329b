// Added mass of a configuration (method, "The coupled system"): 2 T = V^T M_a V,
//
//     L p = -K e_k,   M_a = -K^T p + sum rho S N^T N   with the fluid's u* = 0: one solve a column.
//
// It depends on shapes and positions only: constraints and springs of the bodies do not change it.
#pragma once

#include "gapflow/core/communicator.hpp"
#include "gapflow/coupling/coupling.hpp"
#include "gapflow/scene/scene.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace gapflow {

struct AddedMass {
    std::vector<std::string> bodies; ///< not fixed, in the scene's order
    std::vector<std::string> labels; ///< "name.vx" ... of rows and columns; twists about the centre of mass, world axes
    Eigen::MatrixXd matrix;          ///< in the scene's fluid density
    long cells = 0;                  ///< of the grid
    int film_nodes = 0;
    std::vector<int> iterations; ///< one a column
    std::vector<SealedPocket> sealed;
    double blind_length = 0;           ///< of film rim with blind ends
    double closure = 0;                ///< largest |sum K| over bodies wholly inside, over dx^(D-1)
    std::vector<std::string> warnings; ///< for the user: bodies too thin for the grid, blind film ends
    double seconds = 0;
};

/// Collective. Throws InputError if a body is too thin (thickness_check), ComputationError if a solve does not converge.
AddedMass added_mass(const Scene& scene, const Communicator& comm);

} // namespace gapflow
