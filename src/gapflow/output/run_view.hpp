// A run prepared for display, in the report's page and in pictures: bodies as outlines or surfaces that move rigidly,
// fields on planes without holes next to bodies, films as chains or surfaces.
#pragma once

#include "gapflow/output/stored_run.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace gapflow {

/// Values on a plane across `axis` at `position` (2D: the whole field, axis 2). Cell (i, j) is values[i + cells[0] j], along
/// the plane's axes in_plane[0], in_plane[1]. NaN: no fluid anywhere near. Arrays that the run did not write are empty.
struct FieldPlane {
    int axis = 2;
    double position = 0;
    std::array<int, 2> in_plane{0, 1}, cells{0, 0};
    std::array<double, 2> low{0, 0};
    double spacing = 0;
    std::vector<float> pressure, speed, u, v; ///< u, v: velocity along in_plane
    std::vector<float> fluid;                 ///< 1 where there is fluid (bulk, film or mixed cells), 0 in solids
};

/// 3D: values of the whole domain, coarsened, for slices anywhere. Cell (i, j, k) is values[i + cells[0] (j + cells[1] k)]. NaN: no fluid.
struct FieldVolume {
    std::array<int, 3> cells{0, 0, 0};
    std::array<double, 3> low{0, 0, 0};
    double spacing = 0;
    std::vector<float> pressure, speed; ///< empty where the run did not write them
};

/// A body's surface as it lies in the first frame that has it. 2D: closed outlines, a container's with a rim around the domain.
struct BodyView {
    std::string name, motion, shape;
    bool inside_out = false;
    std::vector<Eigen::Vector3d> points;
    std::vector<int> elements;              ///< pairs of points (2D), triples (3D)
    std::vector<std::vector<int>> outlines; ///< 2D
    std::vector<std::size_t> rows;          ///< in bodies.csv, in the order of time
};

/// x -> rotation x + shift: from where a body's view lies to where it is.
struct Placement {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
};

struct FilmView {
    std::vector<Eigen::Vector3d> points;
    std::vector<float> thickness, pressure;
    std::vector<int> elements;            ///< pairs of points (2D), triples (3D)
    std::vector<std::vector<int>> chains; ///< 2D: nodes in a row
};

struct FrameView {
    int number = 0;
    double time = 0;
    Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< of a grid that follows a body since the start: the view goes with it
    std::vector<FieldPlane> planes;                  ///< 2D: one; 3D: across x, y, z; none without field files
    FieldVolume volume;                              ///< 3D, with field files
    FilmView film;
    std::vector<Placement> placements; ///< a body each
};

struct RunView {
    int dimension = 2;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero(),
                    size = Eigen::Vector3d::Zero(); ///< at the start; of a graded grid: a window around its core
    double spacing = 0;
    Eigen::Vector3d slices = Eigen::Vector3d::Zero(); ///< 3D: where the planes across x, y, z lie at the start
    std::vector<BodyView> bodies;
};

/// What all frames share. 3D: the planes go through the films of the first frame that has any, else through a free body, else
/// through the middle.
RunView view_run(const StoredRun& run);

/// One frame. Planes of more than `most_cells` cells, and volumes of more than `most_volume_cells`, are coarsened by a whole factor (means of
/// blocks). 0 volume cells: no volume.
FrameView view_frame(const StoredRun& run, const RunView& view, const RunFrame& frame,
                     long most_cells = std::numeric_limits<long>::max(), long most_volume_cells = 0);

/// Points of elements (pairs) in a row, closed ones with the first point again at the end.
std::vector<std::vector<int>> chains_of(const std::vector<int>& pairs);

/// Smallest and largest of some values between the given shares of them (0, 1: of all); NaN are left out. Empty: (0, 0).
std::array<float, 2> range_between(std::vector<float> values, double low_share, double high_share);

} // namespace gapflow
