#include "gapflow/scene/body_shape.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/geometry/mesh_file.hpp"
#include "gapflow/geometry/sheet.hpp"

namespace gapflow {

namespace {

template <int D>
SurfaceMesh<D> surface_of_sheet(const BodyScene& body)
{
    if constexpr (D == 2)
        if (!body.points.empty()) {
            std::vector<Vec<2>> points;
            for (const Triple& x : body.points)
                points.push_back(body.mesh_scale * to_vec<2>(x));
            return sheet_surface(polyline(points), body.thickness);
        }
    std::vector<int> lines;
    SurfaceMesh<D> middle = read_surface_file<D>(body.mesh_file, body.mesh_scale, &lines, true);
    return sheet_surface(std::move(middle), body.thickness, lines);
}

template <int D>
std::unique_ptr<Shape<D>> make_outside_in(const BodyScene& body)
{
    using Kind = BodyScene::ShapeKind;
    switch (body.shape) {
    case Kind::box:
        return make_box<D>(to_vec<D>(body.size));
    case Kind::ball:
        return make_ball<D>(body.radius);
    case Kind::capsule:
        return make_capsule<D>(body.radius, body.length);
    case Kind::cylinder:
        if constexpr (D == 3)
            return make_cylinder(body.radius, body.length);
        break;
    case Kind::half_space:
        return make_half_space<D>(to_vec<D>(body.normal));
    case Kind::mesh:
        return make_mesh<D>(body.mesh_file, body.mesh_scale);
    case Kind::sheet:
        return make_mesh<D>(surface_of_sheet<D>(body), "body '" + body.name + "'");
    }
    throw InputError("body '" + body.name + "': a cylinder needs three dimensions; use a ball (a disk) or a capsule");
}

} // namespace

template <int D>
std::unique_ptr<Shape<D>> make_shape(const BodyScene& body)
{
    std::unique_ptr<Shape<D>> shape = make_outside_in<D>(body);
    return body.inside_out ? make_inside_out<D>(std::move(shape)) : std::move(shape);
}

template <int D>
Pose<D> scene_pose(const BodyScene& body)
{
    const auto& q = body.quaternion;
    if constexpr (D == 2)
        return {to_vec<2>(body.position), Rotation<2>(body.angle)};
    else
        return {to_vec<3>(body.position), Rotation<3>(q[0], q[1], q[2], q[3])};
}

template <int D>
Pose<D> start_pose(const BodyScene& body)
{
    if (body.motion_table.time.empty())
        return scene_pose<D>(body);
    const std::vector<double> row = value_at(body.motion_table, 0);
    Pose<D> pose;
    pose.position = Eigen::Map<const Vec<D>>(row.data());
    if constexpr (D == 2)
        pose.rotation = Rotation<2>(row[2]);
    else
        pose.rotation = Rotation<3>(row[3], row[4], row[5], row[6]).normalized();
    return pose;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::unique_ptr<Shape<D>> make_shape<D>(const BodyScene&);                                                        \
    template Pose<D> scene_pose<D>(const BodyScene&);                                                                          \
    template Pose<D> start_pose<D>(const BodyScene&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
