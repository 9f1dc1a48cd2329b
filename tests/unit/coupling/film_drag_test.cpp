// Shear that viscous films carry between their walls (coupling/film_drag.hpp).
#include "gapflow/coupling/film_drag.hpp"
#include "world.hpp"

#include <gtest/gtest.h>

namespace gapflow {
namespace {

// Two bodies of different size that nearly touch, off the grid's axes; of the domain's walls none is near.
template <int D>
Scene two_bodies()
{
    Scene scene;
    scene.dimension = D;
    scene.size = {2, 2, D == 3 ? 2.0 : 0.0};
    scene.cells = {32, 32, D == 3 ? 32 : 1};
    BodyScene ball;
    ball.name = "ball";
    ball.shape = BodyScene::ShapeKind::ball;
    ball.radius = 0.3;
    ball.position = {0.8, 0.7, D == 3 ? 0.9 : 0.0};
    ball.density = 2;
    BodyScene other = ball;
    other.name = "other";
    other.radius = 0.4;
    const double apart = 0.701 / std::sqrt(D == 3 ? 3.0 : 2.0);
    for (int axis = 0; axis < D; ++axis)
        other.position[axis] += apart;
    scene.bodies = {ball, other};
    return scene;
}

// Of a relative velocity v of the walls, mu dt int v_t^2 / h over the film: whatever the bodies' twists.
template <int D>
void expect_shear()
{
    const World<D> world(two_bodies<D>(), true);
    Coupling<D> coupling = world.coupling;
    ASSERT_EQ(coupling.network.films.size(), 1u);
    const FilmMesh<D>& mesh = coupling.network.films[0].mesh;
    const std::vector<TwistMatrix<D>> mass(coupling.solids.size(), TwistMatrix<D>::Identity());
    const double viscosity_dt = 1e-4;
    find_drag<D>(coupling, viscosity_dt, mass, {});
    std::vector<Twist<D>> twists(coupling.solids.size(), Twist<D>::Zero());
    for (int trial = 0; trial < 4; ++trial) {
        for (int k = 0; k < twist_size<D>; ++k) {
            twists[mesh.master][k] = std::sin(1 + 3 * trial + k);
            twists[mesh.other][k] = std::cos(2 + 5 * trial - k * k);
        }
        double expected = 0, found = 0;
        for (const FilmElement<D>& e : mesh.elements) {
            Vec<D> v = velocity_at<D>(twists[mesh.master], e.centroid - coupling.solids[mesh.master].centre) -
                       velocity_at<D>(twists[mesh.other], e.centroid - coupling.solids[mesh.other].centre);
            v -= v.dot(e.normal) * e.normal;
            expected += viscosity_dt * e.inverse * v.squaredNorm();
        }
        int entries = 0;
        for (const DragInertia<D>& drag : coupling.drag_inertia) {
            if (drag.element >= 0 || drag.mouth >= 0)
                continue;
            ++entries;
            const double speed = drag.inertia.row_master.dot(twists[drag.inertia.master]) +
                                 drag.inertia.row_other.dot(twists[drag.inertia.other]);
            found += drag.inertia.mass * speed * speed;
        }
        EXPECT_NEAR(found, expected, 1e-12 * expected);
        EXPECT_LE(entries, twist_size<D>); // not two an element
    }
}

TEST(FilmDrag, ShearBetweenTheWalls)
{
    expect_shear<2>();
    expect_shear<3>();
}

} // namespace
} // namespace gapflow
