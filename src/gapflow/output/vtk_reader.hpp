// Reads back the .vti, .vtr and .vtp files that vtk.hpp writes (not VTK files in general).
#pragma once

#include "gapflow/output/vtk.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace gapflow {

/// What a file holds; vectors have three components, in 2D the third is 0.
struct VtkContent {
    Eigen::Vector3i cells = Eigen::Vector3i::Zero(); ///< image and rectilinear grid only; 2D: z is 0
    Eigen::Vector3d origin = Eigen::Vector3d::Zero(), spacing = Eigen::Vector3d::Zero();
    std::array<std::vector<double>, 3> coordinates; ///< rectilinear grid only: of the points along each axis
    std::vector<Eigen::Vector3d> points;            ///< surface only
    int corners = 0;                                ///< of an element: 2 lines, 3 triangles
    std::vector<int> elements;                      ///< `corners` points each
    std::vector<VtkArray> point_data, cell_data;
    std::optional<double> time;

    /// nullptr if there is none of that name.
    const VtkArray* cell_array(const std::string& name) const;
    const VtkArray* point_array(const std::string& name) const;
};

/// Cell data of a rectilinear grid on an image of equal cells with the low corner `low`: the value of the cell that each one's centre lies
/// in; centres beyond the grid take that of the nearest cell.
VtkContent as_image(const VtkContent& grid, const Eigen::Vector3d& low, double spacing, const Eigen::Vector3i& cells);

/// Throws InputError with the path if the file is missing or was not written by vtk.hpp.
VtkContent read_vtk(const std::filesystem::path& path);

} // namespace gapflow
