// Damping of vorticity about a point of contact: it takes energy, touches no balance, and leaves ideal flow as it is.
#include "film_mesh_checks.hpp"

#include "gapflow/film/film_vorticity.hpp"

#include <random>

namespace gapflow::test {
namespace {

constexpr double dx = 1;

FilmNetwork<3> ball_on_wall()
{
    const auto ball = make_ball<3>(5), wall = make_half_space<3>(unit<3>(2));
    FilmNetwork<3> network;
    for (const FilmMesh<3>& mesh :
         films_of<3>(place<3>(ball, Vec<3>(0.1, 0.2, 5)), place<3>(wall, Vec<3>::Zero()), options_with(0.5)))
        network.films.push_back({{}, mesh, 0.5});
    number_films(network.films);
    network.elements = static_cast<int>(network.films[0].mesh.elements.size());
    return network;
}

double energy(const FilmMesh<3>& mesh, const std::vector<Vec<3>>& u)
{
    double sum = 0;
    for (std::size_t e = 0; e < u.size(); ++e)
        sum += 0.5 * mesh.elements[e].conductance() * u[e].squaredNorm();
    return sum;
}

std::vector<double> outflow(const FilmMesh<3>& mesh, const std::vector<Vec<3>>& u)
{
    std::vector<double> out(mesh.x.size(), 0.0);
    for (std::size_t e = 0; e < u.size(); ++e)
        for (int k = 0; k < 3; ++k)
            out[mesh.elements[e].nodes[k]] -= mesh.elements[e].conductance() * u[e].dot(mesh.elements[e].gradient[k]);
    return out;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

TEST(FilmVorticity, IdealFlowStaysAsItIs)
{
    const FilmNetwork<3> network = ball_on_wall();
    ASSERT_EQ(network.films.size(), 1u);
    const FilmMesh<3>& mesh = network.films[0].mesh;
    std::vector<Vec<3>> u(mesh.elements.size(), Vec<3>::Zero());
    for (std::size_t e = 0; e < u.size(); ++e)
        for (int k = 0; k < 3; ++k) {
            const Vec<3>& x = mesh.x[mesh.elements[e].nodes[k]];
            u[e] += (x[0] + 0.3 * x[0] * x[1]) * mesh.elements[e].gradient[k];
        }
    const std::vector<Vec<3>> before = u;
    damp_vorticity(network, dx, u);
    double change = 0;
    for (std::size_t e = 0; e < u.size(); ++e)
        change = std::max(change, (u[e] - before[e]).norm());
    EXPECT_LT(change, 1e-9);
}

TEST(FilmVorticity, NoiseLosesEnergyAndNoVolume)
{
    const FilmNetwork<3> network = ball_on_wall();
    const FilmMesh<3>& mesh = network.films[0].mesh;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<Vec<3>> u(mesh.elements.size());
    for (std::size_t e = 0; e < u.size(); ++e) {
        const Vec<3> v(number(random), number(random), number(random));
        u[e] = v - v.dot(mesh.elements[e].normal) * mesh.elements[e].normal;
    }
    const std::vector<Vec<3>> before = u;
    damp_vorticity(network, dx, u);
    EXPECT_LT(energy(mesh, u), energy(mesh, before));
    EXPECT_LT(largest_difference(outflow(mesh, u), outflow(mesh, before)), 1e-12);
    for (std::size_t e = 0; e < u.size(); ++e) {
        EXPECT_LT(std::abs(u[e].dot(mesh.elements[e].normal)), 1e-9 * (1 + u[e].norm()));
        if (mesh.elements[e].lateral > dx) { // wide there: nothing is noise
            EXPECT_EQ(u[e], before[e]);
        }
    }
}

} // namespace
} // namespace gapflow::test
