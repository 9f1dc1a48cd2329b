// Bodies that the grid is too coarse for: who is told of, who is refused.
#include "gapflow/core/error.hpp"
#include "gapflow/step/simulation.hpp"
#include "gapflow/stepping/added_mass.hpp"
#include "gapflow/stepping/thickness_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gapflow {
namespace {

using Motion = BodyScene::Motion;

BodyScene plate(const std::string& name, double y, double thickness, Motion motion)
{
    BodyScene body;
    body.name = name;
    body.shape = BodyScene::ShapeKind::box;
    body.size = {0.5, thickness, 0};
    body.position = {0.5, y, 0};
    body.density = 2;
    body.motion = motion;
    return body;
}

/// 20 x 20 cells of 0.05.
Scene scene_of(std::vector<BodyScene> bodies)
{
    Scene scene;
    scene.file = "scene.toml";
    scene.size = {1, 1, 0};
    scene.cells = {20, 20, 1};
    scene.max_step = 0.01;
    scene.end = 1;
    scene.bodies = std::move(bodies);
    return scene;
}

std::vector<std::string> warnings_of(const Scene& scene)
{
    return thickness_warnings<2>(scene, make_bodies<2>(scene), make_walls<2>(scene), scene.thin);
}

TEST(ThinBodies, AreRefusedBelowACellAndToldOfBelowTwo)
{
    const Communicator comm;
    EXPECT_THAT(warnings_of(scene_of({plate("a", 0.5, 0.1, Motion::free)})), testing::IsEmpty());
    EXPECT_THAT(warnings_of(scene_of({plate("a", 0.5, 0.06, Motion::free)})),
                testing::ElementsAre(testing::AllOf(testing::StartsWith("body 'a' is 1.2 cells thin at (0."),
                                                    testing::HasSubstr("domain.cells = [40, 40]"))));
    Scene thin = scene_of({plate("a", 0.5, 0.025, Motion::free)});
    for (const auto& attempt :
         std::vector<std::function<void()>>{[&] { warnings_of(thin); }, [&] { Simulation<2>(thin, comm); },
                                            [&] { added_mass(thin, comm); }, [&] { require_thickness(thin); }})
        try {
            attempt();
            FAIL();
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), testing::StartsWith("scene.toml: body 'a' is 0.5 cells thin at (0."));
            EXPECT_THAT(error.what(), testing::HasSubstr("domain.cells = [80, 80]"));
            EXPECT_THAT(error.what(), testing::HasSubstr("thin = \"allow\" in [grid]"));
        }
    thin.thin = Scene::Thin::allow;
    const auto told = testing::ElementsAre(testing::StartsWith("body 'a' is 0.5 cells thin at "));
    EXPECT_THAT(warnings_of(thin), told);
    EXPECT_THAT(Simulation<2>(thin, comm).initial_report().notes, told);
    EXPECT_THAT(added_mass(thin, comm).warnings, told);
    EXPECT_NO_THROW(require_thickness(thin));
}

TEST(ThinBodies, AreAsThickAsWhatTheyAreFixedTo)
{
    const auto cells_of = [](const Scene& scene) {
        std::vector<double> cells;
        for (const ThinBody<2>& body : thin_bodies<2>(scene, make_bodies<2>(scene), make_walls<2>(scene)))
            cells.push_back(body.cells);
        return cells;
    };
    EXPECT_THAT(cells_of(scene_of({plate("lining", 0.0125, 0.025, Motion::fixed)})), testing::IsEmpty()); // on the floor
    EXPECT_THAT(cells_of(scene_of({plate("lining", 0.005, 0.025, Motion::fixed)})), testing::IsEmpty());  // in it
    EXPECT_THAT(cells_of(scene_of({plate("lying", 0.0125, 0.025, Motion::free)})),
                testing::ElementsAre(testing::DoubleNear(0.5, 1e-6)));
    EXPECT_THAT(cells_of(scene_of({plate("above", 0.0225, 0.025, Motion::fixed)})),
                testing::ElementsAre(testing::DoubleNear(0.5, 1e-6)));
    const BodyScene lower = plate("lower", 0.5, 0.03, Motion::fixed), upper = plate("upper", 0.53, 0.03, Motion::fixed);
    EXPECT_THAT(cells_of(scene_of({lower, upper})),
                testing::ElementsAre(testing::DoubleNear(1.2, 2e-3), testing::DoubleNear(1.2, 2e-3))); // both together
    EXPECT_THAT(cells_of(scene_of({lower, plate("block", 0.665, 0.3, Motion::fixed)})), testing::IsEmpty());
    std::vector<BodyScene> many;
    for (int i = 0; i < 6; ++i)
        many.push_back(plate("p" + std::to_string(i), 0.1 + 0.15 * i, 0.07, Motion::fixed));
    EXPECT_THAT(warnings_of(scene_of(many)), testing::SizeIs(3)); // and that there are others
    EXPECT_THAT(warnings_of(scene_of(many)).back(), testing::EndsWith("so are other bodies"));
}

} // namespace
} // namespace gapflow
