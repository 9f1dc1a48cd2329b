// Film meshes of triangle meshes (2D: polygons) against those of the exact shapes they copy.
#include "film_mesh_checks.hpp"
#include "temporary.hpp"

#include <sstream>

namespace gapflow::test {
namespace {

/// The shape's own display mesh, read back as a mesh shape.
std::unique_ptr<Shape<3>> as_mesh(const Shape<3>& shape, double tolerance)
{
    std::ostringstream file;
    file.precision(17);
    const SurfaceMesh<3> mesh = shape.display_mesh(tolerance);
    for (const auto& x : mesh.vertices)
        file << "v " << x[0] << ' ' << x[1] << ' ' << x[2] << '\n';
    for (const auto& e : mesh.elements)
        file << "f " << e[0] + 1 << ' ' << e[1] + 1 << ' ' << e[2] + 1 << '\n';
    return make_mesh<3>(TemporaryFile("shape.obj", file.str()).path(), 1);
}

TEST(FacetFilm, BoxAsMeshEqualsBox)
{
    const FilmMeshOptions options = options_with(1);
    const auto box = make_box<3>({6, 5, 4});
    const auto mesh = as_mesh(*box, 0.1);
    const Vec<3> above(1.1, 0.7, 4.01);
    const auto exact = films_of<3>(place<3>(box, Vec<3>::Zero()), place<3>(box, above), options);
    ASSERT_EQ(exact.size(), 1u);
    for (int k = 0; k < 3; ++k) {
        const auto films =
            films_of<3>(place<3>(k != 1 ? mesh : box, Vec<3>::Zero()), place<3>(k != 0 ? mesh : box, above), options);
        ASSERT_EQ(films.size(), 1u);
        check_film(films[0], options);
        EXPECT_NEAR(area(films[0]), area(exact[0]), 1e-6 * area(exact[0]));
        EXPECT_NEAR(volume(films[0]), 0.01 * area(films[0]), 1e-9);
        EXPECT_TRUE(films[0].flat);
    }
}

TEST(FacetFilm, BallAsMeshOverWall)
{
    const FilmMeshOptions options = options_with(0.5);
    const auto ball = make_ball<3>(3), wall = make_half_space<3>(unit<3>(2));
    const auto mesh = as_mesh(*ball, 0.003);
    const auto exact = films_of<3>(place<3>(ball, Vec<3>(0, 0, 3.01)), place<3>(wall, Vec<3>::Zero()), options);
    const auto films = films_of<3>(place<3>(mesh, Vec<3>(0, 0, 3.01)), place<3>(wall, Vec<3>::Zero()), options);
    ASSERT_EQ(films.size(), 1u);
    check_film(films[0], options);
    EXPECT_NEAR(area(films[0]), area(exact[0]), 0.02 * area(exact[0]));
    EXPECT_NEAR(volume(films[0]), volume(exact[0]), 0.03 * volume(exact[0]));

    const auto plate = make_box<3>({8, 8, 2});
    const auto over = films_of<3>(place<3>(plate, Vec<3>(0, 0, 4.01)), place<3>(mesh, Vec<3>::Zero()), options);
    ASSERT_EQ(over.size(), 1u);
    check_film(over[0], options);
    // the mesh's surface as seen from the plate: the same cap of the ball
    EXPECT_NEAR(volume(over[0]), volume(exact[0]), 0.1 * volume(exact[0]));
}

} // namespace
} // namespace gapflow::test
