// The columns of a run's tables: the one list that the files, `converge` and the Python package use.
#pragma once

#include "gapflow/output/table.hpp"
#include "gapflow/step/simulation.hpp"

#include <span>
#include <string>
#include <vector>

namespace gapflow {

/// The last column of steps.csv in runs with time.until_steady.
inline constexpr const char* unsteadiness_column = "unsteadiness";

/// Of steps.csv. `driven`: those of a periodic box that a pressure gradient drives, too; `steady`: the unsteadiness; `parts`: the energy of the correction of forces.
std::vector<Column<StepReport>> step_columns(int dimension, bool driven, bool steady = false, bool parts = false);
/// Of gaps.csv, after step and time.
std::span<const Column<GapState>> gap_columns();

/// Of bodies.csv, after step, time and body.
struct BodyColumns {
    std::vector<std::string> position; ///< of the centre of mass
    std::vector<std::string> rotation; ///< 2D: an angle; 3D: a quaternion
    std::vector<std::string> velocity; ///< of the centre of mass, then angular
    std::vector<std::string> force;    ///< of the fluid, then its torque

    std::vector<std::string> all() const;
};
BodyColumns body_columns(int dimension);

} // namespace gapflow
