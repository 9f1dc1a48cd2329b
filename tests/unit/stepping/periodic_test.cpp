// A periodic side is no place: what happens at it happens elsewhere in the same way.
#include "gapflow/step/simulation.hpp"

#include <gtest/gtest.h>

namespace gapflow {
namespace {

constexpr int cells = 24;
constexpr double dx = 1.0 / cells;

Scene periodic_scene()
{
    Scene scene;
    scene.size = {1, 1, 0};
    scene.cells = {cells, cells, 1};
    for (SideScene& side : scene.sides)
        side.kind = SideScene::Kind::periodic;
    scene.tolerance = 1e-13;
    scene.end = 1;
    scene.max_step = 0.25 * dx;
    return scene;
}

BodyScene body(const std::string& name, BodyScene::ShapeKind shape, double radius, const Triple& position,
               const Triple& velocity, double density)
{
    BodyScene body;
    body.name = name;
    body.shape = shape;
    body.radius = radius;
    body.position = position;
    body.velocity = velocity;
    body.density = density;
    return body;
}

/// Twists of all bodies after a number of steps of the scene moved by so much along the first two axes.
template <int D>
std::vector<Twist<D>> moved_by(Scene scene, double along_x, double along_y, int steps)
{
    for (BodyScene& b : scene.bodies) {
        b.position[0] += along_x;
        b.position[1] += along_y;
    }
    Simulation<D> simulation(scene, Communicator());
    for (int k = 0; k < steps; ++k)
        simulation.step(scene.end);
    std::vector<Twist<D>> twists;
    for (const auto& b : simulation.bodies())
        twists.push_back(b.twist);
    return twists;
}

void expect_the_same_everywhere(const Scene& scene, int steps)
{
    const std::vector<Twist<2>> here = moved_by<2>(scene, 0, 0, steps);
    for (int k = 1; k < cells; ++k) {
        const std::vector<Twist<2>> there = moved_by<2>(scene, k * dx, (5 * k) % cells * dx, steps);
        for (std::size_t b = 0; b < here.size(); ++b)
            EXPECT_LT((there[b] - here[b]).norm(), 1e-9) << scene.bodies[b].name << " moved by " << k;
    }
}

// A capsule of four cells, whose tips a single closed face separates from the fluid behind, and a ball that drives it.
TEST(Periodic, ThinBodiesCrossTheSeam)
{
    Scene scene = periodic_scene();
    BodyScene capsule = body("capsule", BodyScene::ShapeKind::capsule, 1.1 * dx, {0.51, 0.53, 0}, {-0.2, 0.19, 0}, 0.07);
    capsule.length = 3.3 * dx;
    capsule.angle = 0.7;
    scene.bodies = {capsule, body("ball", BodyScene::ShapeKind::ball, 4.2 * dx, {0.83, 0.61, 0}, {-0.3, 0, 0}, 2)};
    expect_the_same_everywhere(scene, 8);
}

// Two balls, one above the other, that meet: fluid leaves their film to both sides.
TEST(Periodic, FilmsCrossTheSeam)
{
    Scene scene = periodic_scene();
    scene.bodies = {body("low", BodyScene::ShapeKind::ball, 4.2 * dx, {0.5, 0.25, 0}, {0, 0.5, 0}, 1.5),
                    body("high", BodyScene::ShapeKind::ball, 4.2 * dx, {0.5, 0.25 + 9.5 * dx, 0}, {0, -0.5, 0}, 1.5)};
    expect_the_same_everywhere(scene, 8);
}

/// Bodies in a box with no sides, at lengths of a quarter of a millimetre a cell: moved by whole cells, their places get another round-off.
Scene small_scene(const std::array<int, 3>& count, double density, double max_step)
{
    Scene scene = periodic_scene();
    scene.cells = count;
    for (int axis = 0; axis < 3; ++axis)
        scene.size[axis] = 0.25e-3 * count[axis];
    scene.density = density;
    scene.max_step = max_step;
    scene.end = 10 * max_step;
    return scene;
}

/// `within`: of the fastest body's speed.
void expect_the_same_after_a_step(const Scene& scene, double within = 1e-8)
{
    const std::vector<Twist<3>> here = moved_by<3>(scene, 0, 0, 1);
    double fastest = 0;
    for (const Twist<3>& twist : here)
        fastest = std::max(fastest, twist.head<3>().norm());
    for (int k = 1; k < 12; ++k) {
        const std::vector<Twist<3>> there = moved_by<3>(scene, 0.25e-3 * k, 0, 1);
        for (std::size_t b = 0; b < here.size(); ++b)
            EXPECT_LT((there[b] - here[b]).head<3>().norm(), within * fastest) << scene.bodies[b].name << " moved by " << k;
    }
}

// A cylinder whose flat end lies on a plane of the grid: whether the open part of a face there lies in it must not be a matter of round-off
// (random scene 405).
TEST(MovedByWholeCells, FlatEndOnAPlaneOfTheGrid)
{
    Scene scene = small_scene({19, 19, 24}, 1, 0.00040732389948217447);
    BodyScene tilted = body("tilted", BodyScene::ShapeKind::cylinder, 0.0007054707444705202,
                            {0.0007775452584250706, 0.0007809030665740049, 0.003972137273121137},
                            {-0.04525843662001447, 0.041457374672211625, 0}, 189.2228817950867);
    tilted.length = 0.00075;
    tilted.quaternion = {-1.0005083124630991, 1.4066000784165307, 0.2504961102946128, -2.223410675200334};
    const double size = Eigen::Map<const Eigen::Vector4d>(tilted.quaternion.data()).norm();
    for (double& q : tilted.quaternion)
        q /= size;
    BodyScene aligned = body("aligned", BodyScene::ShapeKind::cylinder, 0.0008076067756810038,
                             {0.0008008230855997462, 0.003942393224318996, 0.0035930904258534365},
                             {0.037338302227394725, 0.048712330951985156, 0}, 0.03610243339299679);
    aligned.length = 0.0016016461711994925;
    scene.bodies = {tilted, aligned};
    expect_the_same_after_a_step(scene);
}

BodyScene capsule_along_x()
{
    BodyScene capsule = body("capsule", BodyScene::ShapeKind::capsule, 0.0005722476617909106,
                             {0.0022271022992803135, 0.002136015111283931, 0.0028850833793778786},
                             {0.005257283783225807, -0.05985349586467469, 0}, 10.074160657682782);
    capsule.length = 0.0018356512902927293;
    return capsule;
}

// A heavy ball that touches a light capsule: the film's mesh, and the motion that both start with, without a rate where they touch (random scene 441).
TEST(MovedByWholeCells, LightBodyTouchesAHeavyOne)
{
    Scene scene = small_scene({20, 19, 23}, 1000, 0.00041608455548198533);
    scene.bodies = {body("ball", BodyScene::ShapeKind::ball, 0.0009399465198439544,
                         {0.004060053480156045, 0.0032792071883440787, 0.0025077395417797493},
                         {-0.04430552070642595, 0.04058449007850735, 0}, 165610.8121158099),
                    capsule_along_x()};
    expect_the_same_after_a_step(scene);
}

// Edges along which the gap of two capsules is as curved as it is at most (random scene 441).
TEST(MovedByWholeCells, EdgesOfTheLargestCurvature)
{
    Scene scene = small_scene({20, 19, 23}, 1000, 0.00041608455548198533);
    BodyScene other = body("other", BodyScene::ShapeKind::capsule, 0.0005164758981047981,
                           {0.0009300519782808937, 0.002704896859488887, 0.003921662281016899},
                           {0.03655214466129074, 0.047686693329062724, 0}, 1167.142983948221);
    other.length = 0.0005607631446464873;
    other.quaternion = {0.8232271716669439, 0.0693115185738495, -0.15317845143843736, -0.5422446857620211};
    scene.bodies = {capsule_along_x(), other};
    expect_the_same_after_a_step(scene);
}

// A box whose film ends half a cell, the distance at which its mouths read the grid's pressure, before a third box. (Moved by five, nine and ten cells
// the step differs by 2e-6 to 2e-4 for another reason; with mouths that differ by 3e-2.)
TEST(MovedByWholeCells, MouthsBeforeASurface)
{
    constexpr double h = 0.25e-3, v = 30 * h;
    Scene scene = small_scene({16, 16, 16}, 1000, 0.00041608455548198533);
    const auto box = [&](const std::string& name, const Triple& size, const Triple& position, const Triple& velocity) {
        BodyScene box = body(name, BodyScene::ShapeKind::box, 0, {}, velocity, 1000);
        for (int axis = 0; axis < 3; ++axis) {
            box.size[axis] = h * size[axis];
            box.position[axis] = h * position[axis];
        }
        return box;
    };
    scene.bodies = {box("upper", {3.3, 4.7, 4.1}, {5.17, 6.3, 8.4}, {v, 0, -v}),
                    box("lower", {9.3, 6.7, 2.1}, {6.2, 6.2, 8.4 - 2.05 - 0.2 - 1.05}, {0, 0, v}),
                    box("beside", {2.2, 4.9, 4.7}, {5.17 + 1.65 + 0.5 + 1.1, 6.4, 9.1}, {0, v, 0})};
    expect_the_same_after_a_step(scene, 1e-3);
}

} // namespace
} // namespace gapflow
