// Rays from points of the fluid to the next solid, against a search over all solids.
#include "gapflow/viscosity/wall_rays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace gapflow {
namespace {

constexpr double dx = 1.0 / 40;

// Balls of five cells at random in a box of 40 cells, three quarters of its height; or meshes of them.
class BallsInABox {
public:
    explicit BallsInABox(bool meshes = false)
        : grid_(Vec<3>::Zero(), dx, Index<3>::Constant(40), open_sides(), 4, Communicator()), ball_(make_ball<3>(2.5 * dx))
    {
        if (meshes)
            ball_ = make_mesh<3>(ball_->display_mesh(0.2 * dx), "ball");
        for (int i = 0; i < 60; ++i) {
            Pose<3> pose;
            pose.position = point();
            pose.position[2] *= 0.75;
            solids_.push_back({"ball" + std::to_string(i), PlacedShape<3>(*ball_, pose), pose.position});
        }
        clipper_ = std::make_unique<FaceClipper<3>>(grid_, solids_, FractionMode::cut_cell);
    }

    Vec<3> point() { return {number_(random_), number_(random_), number_(random_)}; }
    const FaceClipper<3>& clipper() const { return *clipper_; }
    /// The least over all solids.
    double distance(const Vec<3>& x, int* image = nullptr) const
    {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < clipper_->images().size(); ++i)
            if (const double phi = clipper_->images()[i].shape.distance(x); phi < least) {
                least = phi;
                if (image)
                    *image = static_cast<int>(i);
            }
        return least;
    }

private:
    static std::array<SideKind, 6> open_sides()
    {
        std::array<SideKind, 6> sides;
        sides.fill(SideKind::open);
        return sides;
    }

    std::mt19937 random_{5};
    std::uniform_real_distribution<double> number_{0.0, 1.0};
    Grid<3> grid_;
    std::unique_ptr<Shape<3>> ball_;
    std::vector<Solid<3>> solids_;
    std::unique_ptr<FaceClipper<3>> clipper_;
};

// To the last bit, near and far from where the rays were set up, in any order.
void check_distances(bool meshes)
{
    BallsInABox balls(meshes);
    WallRays<3> rays(balls.clipper(), dx);
    int far = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec<3> centre = balls.point();
        rays.around(centre, 8 * dx);
        for (int k = 0; k < 5; ++k) {
            const Vec<3> x = k == 0 ? centre : Vec<3>(centre + 4 * dx * (2 * balls.point() - Vec<3>::Ones()));
            int image = -1, expected = -1;
            const double phi = balls.distance(x, &expected);
            if (phi > 8 * dx)
                continue;
            far += phi > 4 * dx;
            EXPECT_EQ(rays.distance(x, &image), phi);
            EXPECT_EQ(image, expected);
        }
    }
    EXPECT_GT(far, 20);
}

TEST(WallRays, DistanceIsTheLeastOverAllSolids)
{
    check_distances(false);
    check_distances(true);
}

void check_ends(bool meshes, int tries)
{
    BallsInABox balls(meshes);
    WallRays<3> rays(balls.clipper(), dx);
    int hits = 0, misses = 0;
    for (int i = 0; i < tries; ++i) {
        const Vec<3> x = balls.point(), direction = (2 * balls.point() - Vec<3>::Ones()).normalized();
        if (balls.distance(x) <= 0)
            continue;
        rays.around(x, 8 * dx);
        const WallHit<3> hit = rays.cast(x, direction, 8 * dx);
        const double end = hit.image >= 0 ? hit.distance : 8 * dx;
        double least = std::numeric_limits<double>::infinity();
        for (double t = 0; t < end - 0.1 * dx; t += 0.1 * dx)
            least = std::min(least, balls.distance(x + t * direction));
        EXPECT_GT(least, -1e-9 * dx);
        if (hit.image >= 0) {
            EXPECT_NEAR(balls.distance(x + end * direction), 0, 1e-8 * dx);
        }
        ++(hit.image >= 0 ? hits : misses);
    }
    EXPECT_GT(hits, tries / 30);
    EXPECT_GT(misses, tries / 30);
}

TEST(WallRays, EndAtTheFirstSolid)
{
    check_ends(false, 600);
    check_ends(true, 100);
}

} // namespace
} // namespace gapflow
