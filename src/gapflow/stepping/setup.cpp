#include "gapflow/stepping/setup.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/stepping/memory_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <tuple>

namespace gapflow {

namespace {

// h_floor in cells: touching or overlapping surfaces keep a finite system.
constexpr double floor_in_cells = 1e-9;
// Solids at rest count as touching, and as one solid, where they are no further apart than this, in cells, or the roughness.
constexpr double touching_in_cells = 1e-6;
// Automatic h_c in cells: between flat surfaces, and at most where a surface is curved.
constexpr double flat_threshold = 2.25;
constexpr double curved_threshold = 1.5;
// A film ends where curved surfaces, in touch, would have turned from each other by this angle, without and with viscosity.
constexpr double ideal_opening = std::numbers::pi / 6;
constexpr double viscous_opening = std::numbers::pi / 4;

template <int D>
Index<D> to_index(const std::array<int, 3>& cells)
{
    return Eigen::Map<const Index<D>>(cells.data());
}

// Whether the solid is a wall of the domain that slides.
bool slides(const Scene& scene, const std::string& name)
{
    for (int side = 0; side < 2 * scene.dimension; ++side)
        if (name == "wall:" + side_names[side])
            return scene.sides[side].velocity != Triple{};
    return false;
}

bool has_pair(const Scene& scene, const std::string& a, const std::string& b)
{
    const std::array<std::string, 2> names{a, b};
    return std::any_of(scene.pairs.begin(), scene.pairs.end(), [&](const PairScene& pair) {
        return std::is_permutation(names.begin(), names.end(), pair.bodies.begin());
    });
}

// Curvature of a solid as a whole, negative for a container; 0 if all of it is flat. Its radius is half of its second smallest extent: that
// of balls, round bars and disks, while a plate with rounded edges counts as wide as it is.
template <int D>
double overall_curvature(const Shape<D>& shape)
{
    const auto mesh = shape.surface_mesh();
    if (std::all_of(mesh.patch.begin(), mesh.patch.end(), [&](int patch) { return shape.curvature(patch) == 0; }))
        return 0;
    const Bounds<D> bounds = shape.bounds();
    Vec<D> extent = bounds.high - bounds.low;
    std::sort(extent.begin(), extent.end());
    return (shape.inside_out() ? -2 : 2) / extent[1];
}

// Where the surface of a ball of radius R that touches a plane has turned from it by an angle a, the two are R (1 - cos a) apart.
double automatic_threshold(double curvature_a, double curvature_b, bool viscous, double dx)
{
    if (curvature_a == 0 && curvature_b == 0)
        return flat_threshold * dx;
    const double curvature = std::max(0.0, curvature_a + curvature_b); // of the ball over a plane that has the same gap
    const double parted = 1 - std::cos(viscous ? viscous_opening : ideal_opening);
    return parted < curved_threshold * dx * curvature ? parted / curvature : curved_threshold * dx;
}

} // namespace

FractionMode fraction_mode(const Scene& scene)
{
    return scene.fractions == Scene::Fractions::voxel ? FractionMode::voxel : FractionMode::cut_cell;
}

void require_memory(const Scene& scene, const Communicator& comm, double available)
{
    double cells = 1;
    for (int axis = 0; axis < scene.dimension; ++axis)
        cells *= scene.cells[axis];
    const double needed = forecast_memory(scene, 0, 0);
    const double here = needed * ranks_on_this_machine(comm) / comm.size();
    if (!comm.any(here > available))
        return;
    constexpr double gib = 1073741824.0;
    char text[256];
    std::snprintf(
        text, sizeof text,
        ": domain.cells: %.3g cells need about %.3g GiB of memory, %.3g GiB of it on a machine that has %.3g GiB; use "
        "fewer cells, or ranks on more machines",
        cells, needed / gib, comm.max(here > available ? here : 0.0) / gib, comm.min(available) / gib);
    throw InputError(scene.file + text);
}

namespace {

SideKind side_kind(const SideScene& side)
{
    if (side.kind == SideScene::Kind::far)
        return SideKind::far;
    if (side.is_open())
        return SideKind::open;
    if (side.kind == SideScene::Kind::periodic)
        return SideKind::periodic;
    return side.kind == SideScene::Kind::inflow ? SideKind::inflow : SideKind::wall;
}

} // namespace

template <int D>
Grid<D> make_grid(const Scene& scene, const Communicator& comm)
{
    require_memory(scene, comm);
    std::array<SideKind, 2 * D> sides;
    for (int s = 0; s < 2 * D; ++s)
        sides[s] = side_kind(scene.sides[s]);
    const int ghost = 3 + static_cast<int>(std::ceil(scene.cfl));
    Grading<D> grading;
    for (int axis = 0; axis < D && scene.core; ++axis) {
        grading.below[axis] = scene.core->below[axis];
        grading.above[axis] = scene.core->above[axis];
    }
    return Grid<D>(to_vec<D>(scene.origin), scene.spacing(), to_index<D>(scene.cells), sides, ghost, comm, grading);
}

namespace {

template <int D>
std::optional<WaterLevel<D>> water_level(const Scene& scene)
{
    for (int side = 0; side < 2 * D; ++side) {
        if (scene.sides[side].kind != SideScene::Kind::surface)
            continue;
        const int axis = side / 2, upwards = side % 2 ? 1 : -1;
        const double place = scene.origin[axis] + (side % 2) * scene.size[axis];
        return WaterLevel<D>{{upwards * unit<D>(axis), upwards * place}, scene.density * std::abs(scene.gravity[axis])};
    }
    return {};
}

template <int D>
SpinMatrix<D> inertia_of(const BodyScene& body)
{
    SpinMatrix<D> inertia = SpinMatrix<D>::Identity();
    if constexpr (D == 2) {
        inertia(0, 0) = body.inertia.at(0);
    } else if (body.inertia.size() == 3) {
        inertia.diagonal() = Eigen::Map<const Vec<3>>(body.inertia.data());
    } else {
        inertia = Eigen::Map<const Mat<3>>(body.inertia.data());
    }
    return inertia;
}

/// Shapes of bodies. Bodies of one mesh share its shape: a crowd reads its file once.
template <int D>
class MeshShapes {
public:
    std::shared_ptr<const Shape<D>> of(const BodyScene& body)
    {
        if (body.shape != BodyScene::ShapeKind::mesh && (body.shape != BodyScene::ShapeKind::sheet || !body.points.empty()))
            return make_shape<D>(body);
        std::shared_ptr<const Shape<D>>& shape = made_[{body.mesh_file, body.mesh_scale, body.thickness, body.inside_out}];
        if (!shape)
            shape = make_shape<D>(body);
        return shape;
    }

private:
    std::map<std::tuple<std::string, double, double, bool>, std::shared_ptr<const Shape<D>>> made_;
};

/// A body has an image for every period that it spans: of one as wide as ten they would be hundreds, each in the other.
template <int D>
void require_few_images(const Scene& scene, const BodyScene& from, const RigidBody<D>& body)
{
    const Bounds<D> bounds = world_bounds(PlacedShape<D>(*body.shape, body.pose));
    for (int axis = 0; axis < D; ++axis) {
        const double periods = (bounds.high[axis] - bounds.low[axis]) / scene.size[axis];
        if (scene.sides[2 * axis].kind != SideScene::Kind::periodic || !(periods > 10) || !std::isfinite(periods))
            continue;
        char text[96];
        std::snprintf(text, sizeof text, "' is %.3g times as wide as the domain along %c, which is periodic: ", periods,
                      "xyz"[axis]);
        throw InputError(scene.file + ": body '" + from.name + text + "it would lie in its own images; make it smaller" +
                         (from.shape == BodyScene::ShapeKind::mesh
                              ? ", with scale = " + number_text(1e-3 * from.mesh_scale) + " if its file is in millimetres"
                              : ""));
    }
}

} // namespace

template <int D>
std::vector<RigidBody<D>> make_bodies(const Scene& scene)
{
    std::vector<RigidBody<D>> bodies;
    MeshShapes<D> shapes;
    const std::optional<WaterLevel<D>> water = water_level<D>(scene);
    for (const BodyScene& from : scene.bodies) {
        RigidBody<D> body;
        body.name = from.name;
        body.shape = shapes.of(from);
        body.motion = from.motion == BodyScene::Motion::free         ? Motion::free
                      : from.motion == BodyScene::Motion::prescribed ? Motion::prescribed
                                                                     : Motion::fixed;
        body.pose = scene_pose<D>(from);
        body.water = water;
        require_few_images(scene, from, body);
        if (from.mass)
            set_mass<D>(body, *from.mass, inertia_of<D>(from));
        else if (from.shape != BodyScene::ShapeKind::half_space)
            set_density<D>(body, from.density.value_or(scene.density));
        Twist<D> twist;
        twist << to_vec<D>(from.velocity), Eigen::Map<const Spin<D>>(from.angular_velocity.data());
        if (from.motion == BodyScene::Motion::prescribed) {
            PrescribedMotion<D> motion = from.motion_table.time.empty()
                                             ? constant_motion<D>(body.pose, body.centre_of_mass, to_vec<D>(from.velocity),
                                                                  Eigen::Map<const Spin<D>>(from.angular_velocity.data()))
                                             : table_motion<D>(from.motion_table);
            body.pose = motion(0);
            const double instant = scene.max_step > 0 ? 1e-3 * scene.max_step : 1e-6;
            if (!from.motion_table.time.empty())
                twist = prescribed_twist<D>(motion, body.centre_of_mass, 0, instant);
            body.prescribed = std::make_shared<PrescribedMotion<D>>(std::move(motion));
        }
        for (int k = 0; k < twist_size<D>; ++k)
            body.can_move[k] = from.free[k < D ? k : k - D + (D == 2 ? 5 : 3)];
        if (from.hinge) {
            attach_hinge<D>(body, to_vec<D>(from.hinge->point), Eigen::Map<const Spin<D>>(from.hinge->axis.data()));
            twist = hinged_twist<D>(body, body.hinge->axis.dot(twist.template tail<spin_size<D>>()));
        }
        if (from.spring)
            body.spring = Spring<D>{to_vec<D>(from.spring->anchor), from.spring->stiffness, from.spring->damping};
        set_initial_twist(body, twist);
        body.force = to_vec<D>(from.force);
        body.torque = Eigen::Map<const Spin<D>>(from.torque.data());
        bodies.push_back(std::move(body));
    }
    return bodies;
}

template <int D>
DomainWalls<D> make_walls(const Scene& scene)
{
    DomainWalls<D> walls;
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end) {
            const SideScene& side = scene.sides[2 * axis + end];
            if (side.kind != SideScene::Kind::wall)
                continue;
            walls.shapes.push_back(make_half_space<D>((end == 0 ? 1.0 : -1.0) * unit<D>(axis)));
            Pose<D> pose;
            pose.position = to_vec<D>(scene.origin) + end * scene.size[axis] * unit<D>(axis);
            Solid<D> solid{"wall:" + side_names[2 * axis + end], PlacedShape<D>(*walls.shapes.back(), pose), pose.position,
                           Motion::fixed, true};
            walls.solids.push_back(solid);
            Twist<D> twist = Twist<D>::Zero();
            twist.template head<D>() = to_vec<D>(side.velocity);
            walls.twists.push_back(twist);
        }
    return walls;
}

template <int D>
std::vector<Solid<D>> make_solids(const std::vector<RigidBody<D>>& bodies, const DomainWalls<D>& walls)
{
    std::vector<Solid<D>> solids;
    for (const RigidBody<D>& body : bodies)
        solids.push_back(solid_of(body));
    solids.insert(solids.end(), walls.solids.begin(), walls.solids.end());
    return solids;
}

template <int D>
std::function<GapSettings(int, int)> gap_settings(const Scene& scene, const std::vector<Solid<D>>& solids, bool moving)
{
    std::vector<double> curvature;
    std::vector<bool> still; // and never moves
    std::vector<std::string> names;
    for (const Solid<D>& solid : solids) {
        curvature.push_back(overall_curvature(solid.shape.shape()));
        still.push_back(solid.motion == Motion::fixed && !slides(scene, solid.name));
        names.push_back(solid.name);
    }
    const double dx = scene.spacing();
    return [&scene, curvature, still, names, dx, moving](int a, int b) {
        const GapScene& gap = scene.gap_of(names[a], names[b]);
        GapSettings settings;
        settings.film = gap.film;
        settings.lasting = moving;
        settings.viscous = scene.viscosity > 0;
        // Added mass does not depend on viscosity.
        settings.threshold = gap.threshold ? *gap.threshold * dx
                                           : automatic_threshold(curvature[a], curvature[b], moving && settings.viscous, dx);
        const double least = floor_in_cells * dx;
        settings.floor = std::max(gap.roughness, least);
        if (still[a] && still[b] && !has_pair(scene, names[a], names[b]))
            settings.touching = std::max(settings.floor, touching_in_cells * dx);
        if (gap.contact == GapScene::Contact::dry) {
            settings.floor = std::max(scene.held_distance(names[a], names[b]), least);
            settings.skin = moving ? settings.floor - least : 0.0;
        }
        return settings;
    };
}

template <int D>
std::function<MouthLaw(int, int)> mouth_laws(const Scene& scene, const std::vector<Solid<D>>& solids)
{
    std::vector<std::string> names;
    for (const Solid<D>& solid : solids)
        names.push_back(solid.name);
    return [&scene, names](int a, int b) {
        const GapScene& gap = scene.gap_of(names[a], names[b]);
        const bool jet = gap.exit == GapScene::Exit::jet || (gap.exit == GapScene::Exit::automatic && scene.viscosity > 0);
        return MouthLaw{gap.entrance_loss, jet};
    };
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Grid<D> make_grid<D>(const Scene&, const Communicator&);                                                          \
    template std::vector<RigidBody<D>> make_bodies<D>(const Scene&);                                                           \
    template DomainWalls<D> make_walls<D>(const Scene&);                                                                       \
    template std::vector<Solid<D>> make_solids<D>(const std::vector<RigidBody<D>>&, const DomainWalls<D>&);                    \
    template std::function<GapSettings(int, int)> gap_settings<D>(const Scene&, const std::vector<Solid<D>>&, bool);           \
    template std::function<MouthLaw(int, int)> mouth_laws<D>(const Scene&, const std::vector<Solid<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
