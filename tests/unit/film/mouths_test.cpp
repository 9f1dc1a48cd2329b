// Where films exchange fluid: a mouth's resistance, and what the ends of films with known geometry join.
#include "film_scene.hpp"

#include "gapflow/film/cell_states.hpp"
#include "gapflow/film/mouths.hpp"

#include <cmath>
#include <map>
#include <numbers>

namespace gapflow::test {
namespace {

using std::numbers::e;
using std::numbers::pi;

// The logarithms of the method's table, where they are whole numbers.
TEST(MouthResistance, HandValues)
{
    const double dx = 0.3, r = 0.8 * dx;
    EXPECT_NEAR(mouth_resistance(MouthKind::edge_edge, pi * r / 2, dx), 1 / pi, 1e-14);
    EXPECT_NEAR(mouth_resistance(MouthKind::edge_edge, pi * r / (2 * e), dx), 2 / pi, 1e-14);
    const double thin = pi * r / (4 * std::exp(8.0)); // its mirror image is next to nothing
    EXPECT_NEAR(mouth_resistance(MouthKind::edge_face, thin, dx), 18 / pi, 1e-12);
    EXPECT_NEAR(mouth_resistance(MouthKind::edge_face, dx, dx), 2 / pi * (std::log(pi * std::pow(0.4096 + 0.14, 0.25) / 4) + 1),
                1e-14);
    EXPECT_NEAR(mouth_resistance(MouthKind::smooth, 0.1 * dx, dx), 20.0 / 3, 1e-13); // 1/2 and 1/6 of a cell
    for (const double h : {0.01, 1.0}) {
        EXPECT_EQ(mouth_resistance(MouthKind::open_side, h, dx), 0.2);
        EXPECT_EQ(mouth_resistance(MouthKind::inflow, h, dx), 0.2);
    }
}

TEST(MouthResistance, FallsWithThicknessToItsFloorAndKnowsNoScale)
{
    for (const MouthKind kind : {MouthKind::edge_edge, MouthKind::edge_face, MouthKind::smooth}) {
        double last = mouth_resistance(kind, 1e-9, 1);
        for (double h = 2e-9; h < 100; h *= 2) {
            const double R = mouth_resistance(kind, h, 1);
            EXPECT_LE(R, last);
            EXPECT_GE(R, 0.02);
            EXPECT_NEAR(mouth_resistance(kind, 7 * h, 7), R, 1e-12 * R);
            last = R;
        }
        EXPECT_EQ(mouth_resistance(MouthKind::edge_edge, 1e3, 1), 0.02);
    }
}

/// What holds for every network: shares of nodes and cells sum to 1, and no mouth draws on a cell of film or solid.
template <int D>
void check_network(const FilmScene<D>& scene, const FilmNetwork<D>& network)
{
    for (const Mouth<D>& c : network.rim.mouths) {
        const Film<D>& film = network.films[c.film];
        double nodes = 0, cells = 0;
        Vec<D> x = Vec<D>::Zero();
        for (int i = 0; i < D - 1; ++i) {
            nodes += c.shape[i];
            x += c.shape[i] * film.mesh.mid[c.nodes[i] - film.first_node];
        }
        EXPECT_NEAR(nodes, 1, 1e-12);
        EXPECT_LT((x - c.x).norm(), 1e-9);
        EXPECT_NEAR(c.outward.norm(), 1, 1e-12);
        for (const auto& [key, weight] : c.cells) {
            cells += weight;
            EXPECT_GT(weight, 0);
            const CellKind kind = kind_of<D>(scene.faces(), network.cells, scene.grid().cell_of_key(key));
            EXPECT_TRUE(kind == CellKind::bulk || kind == CellKind::mixed);
        }
        EXPECT_NEAR(cells, 1, 1e-12);
    }
}

// Two plates: the whole rim is mouth, between sharp edges.
template <int D>
void mouths_of_plates()
{
    const auto scene = plates<D>(3, 7);
    const FilmNetwork<D> network = scene->network();
    ASSERT_EQ(network.films.size(), 1u);
    EXPECT_EQ(network.nodes, static_cast<int>(network.films[0].mesh.h.size()));
    EXPECT_EQ(network.elements, static_cast<int>(network.films[0].mesh.elements.size()));
    check_network(*scene, network);
    std::map<int, double> length; // by the way out
    for (const Mouth<D>& c : network.rim.mouths) {
        EXPECT_EQ(c.kind, MouthKind::edge_edge);
        EXPECT_NEAR(c.h, 0.2, 1e-12);
        EXPECT_NEAR(c.resistance, (std::log(pi * 0.8 / 0.4) + 1) / pi, 1e-10);
        int axis = 0;
        c.outward.cwiseAbs().maxCoeff(&axis);
        const bool high = c.outward[axis] > 0;
        EXPECT_NEAR(std::abs(c.outward[axis]), 1, 1e-12);
        EXPECT_NEAR(c.x[axis], high ? 7 : 3, 1e-9);
        EXPECT_NEAR(c.x[D - 1], 4.4, 1e-9);
        length[2 * axis + high] += c.length;
        Vec<D> mean = Vec<D>::Zero(); // of the cells: half a cell out
        for (const auto& [key, weight] : c.cells)
            mean += weight * scene->grid().cell_centre(scene->grid().cell_of_key(key));
        EXPECT_NEAR(mean[axis], high ? 7.5 : 2.5, 1e-9);
    }
    ASSERT_EQ(length.size(), static_cast<std::size_t>(2 * (D - 1)));
    for (const auto& [side, sum] : length)
        EXPECT_NEAR(sum, D == 2 ? 1 : 4, 1e-9);
    EXPECT_TRUE(network.rim.joints.empty() && network.rim.blind.empty());
    EXPECT_EQ(network.rim.closed_length, 0);
    EXPECT_EQ(network.rim.blind_length, 0);
}

TEST(Mouths, OfTwoPlates2D)
{
    mouths_of_plates<2>();
}

TEST(Mouths, OfTwoPlates3D)
{
    mouths_of_plates<3>();
}

// A box above a wide one: one edge at each mouth. Beside it stands a third one that it touches: no mouth there.
TEST(Mouths, BesideAFaceThatGoesOnAndClosedByAThirdBody)
{
    for (const bool closed : {false, true}) {
        FilmScene<2> scene(12);
        scene.add_box("floor", {1, 2}, {11, 4.3});
        scene.add_box("box", {4, 4.5}, {8, 7});
        if (closed)
            scene.add_box("post", {2.5, 4.3}, {4, 7});
        scene.clip();
        const FilmNetwork<2> network = scene.network([](int a, int b) { return a < 2 && b < 2; });
        check_network(scene, network);
        ASSERT_EQ(network.rim.mouths.size(), closed ? 1u : 2u);
        EXPECT_EQ(network.rim.closed_length, closed ? 1 : 0);
        EXPECT_EQ(network.rim.blind_length, 0);
        for (const Mouth<2>& c : network.rim.mouths) {
            EXPECT_EQ(c.kind, MouthKind::edge_face);
            EXPECT_EQ(c.length, 1);
            EXPECT_EQ(c.resistance, mouth_resistance(MouthKind::edge_face, c.h, 1));
        }
        EXPECT_NEAR(network.rim.mouths.back().outward[0] + network.rim.mouths.front().outward[0], closed ? 2 : 0, 1e-12);
    }
}

// Plates that reach through an open side: the film goes out there, and draws on no cell.
TEST(Mouths, AtAnOpenSideAndAnInflow)
{
    for (const SideKind side : {SideKind::open, SideKind::inflow}) {
        FilmScene<2> scene(10, side);
        scene.add_box("lower", {-2, 2}, {7, 4.3});
        scene.add_box("upper", {-2, 4.5}, {7, 7});
        scene.clip();
        const FilmNetwork<2> network = scene.network();
        int at_side = 0;
        for (const Mouth<2>& c : network.rim.mouths) {
            EXPECT_EQ(c.cells.empty(), c.outward[0] < 0);
            if (c.outward[0] > 0)
                continue;
            ++at_side;
            EXPECT_EQ(c.kind, side == SideKind::open ? MouthKind::open_side : MouthKind::inflow);
            EXPECT_NEAR(c.x[0], 0, 1e-3);
            EXPECT_EQ(c.resistance, 0.2);
        }
        EXPECT_EQ(at_side, 1);
        EXPECT_EQ(network.rim.mouths.size(), 2u);
    }
}

// The last part of a film between disks that reach through an open side ends a little below it: its mouth lies beyond.
TEST(Mouths, JustInsideAnOpenSide)
{
    for (const double height : {9.3, 9.6, 9.9}) {
        FilmScene<2> scene(10, SideKind::open);
        scene.add_ball("left", 1.9, {3, height});
        scene.add_ball("right", 1.9, {7, height});
        scene.clip();
        const FilmNetwork<2> network = scene.network();
        EXPECT_TRUE(network.rim.blind.empty());
        int at_side = 0;
        for (const Mouth<2>& mouth : network.rim.mouths)
            if (mouth.kind == MouthKind::open_side) {
                ++at_side;
                EXPECT_EQ(mouth.side, 3);
                EXPECT_TRUE(mouth.cells.empty());
                EXPECT_LT(mouth.x[1], 10);
                EXPECT_NEAR(mouth.resistance, std::max(0.2, (10 - mouth.x[1]) / mouth.h), 1e-12);
            }
        EXPECT_EQ(at_side, 1);
    }
}

// Two boxes side by side under a lid: their films go on into each other, over a hundredth of a cell of film.
TEST(Mouths, FilmsThatMeetAreJoined)
{
    FilmScene<2> scene(14);
    scene.add_box("left", {3, 4}, {7, 6.3});
    scene.add_box("right", {7, 4}, {11, 6.3});
    scene.add_box("lid", {3, 6.5}, {11, 9});
    scene.clip();
    const FilmNetwork<2> network = scene.network([](int a, int b) { return a == 2 || b == 2; });
    ASSERT_EQ(network.films.size(), 2u);
    check_network(scene, network);
    EXPECT_EQ(network.rim.mouths.size(), 2u);
    EXPECT_EQ(network.rim.blind_length, 0);
    ASSERT_EQ(network.rim.joints.size(), 2u); // one from each side
    for (const Joint<2>& joint : network.rim.joints) {
        EXPECT_NEAR(joint.conductance, 0.2 / 0.01, 1e-8);
        EXPECT_EQ(joint.shape_a[0], 1);
        EXPECT_EQ(joint.shape_b[0], 1);
        EXPECT_NE(joint.nodes_a[0] < network.films[1].first_node, joint.nodes_b[0] < network.films[1].first_node);
        for (const int node : {joint.nodes_a[0], joint.nodes_b[0]}) {
            const Film<2>& film = network.films[node < network.films[1].first_node ? 0 : 1];
            EXPECT_NEAR(film.mesh.mid[node - film.first_node][0], 7, 1e-9);
        }
    }
}

// Films of a lid over two boxes with bulk between them: two mouths each, numbers in one row.
// A ball beyond a box's corner, close to it: the wedge between it and a face of the box is narrower than the cells that it leads through, and takes none
// of them whole at one in seven places on the grid. (At four of the 64 a single cell holds both sides of the throat, with no face to close.)
TEST(FilmNetwork, KeepsTheFilmOfACornerAcrossTheGrid)
{
    int kept = 0;
    for (double x = 0; x < 1; x += 0.125)
        for (double y = 0; y < 1; y += 0.125) {
            FilmScene<2> scene(20);
            scene.gap.threshold = 1.2;
            const Vec<2> corner(9 + x, 8 + y);
            scene.add_box("box", corner - Vec<2>(5, 4), corner);
            scene.add_ball("ball", 3.2, corner + 3.245 * Vec<2>(std::cos(0.49), std::sin(0.49)));
            scene.clip();
            kept += !scene.network().films.empty();
        }
    EXPECT_GE(kept, 60);
}

TEST(FilmNetwork, CountsItsNodesAndNumbersItsFilms)
{
    FilmScene<2> scene(14);
    scene.add_box("left", {3, 4}, {6, 6.3});
    scene.add_box("right", {8, 4}, {11, 6.3});
    scene.add_box("lid", {3, 6.5}, {11, 9});
    scene.clip();
    const FilmNetwork<2> network = scene.network();
    ASSERT_EQ(network.films.size(), 2u);
    EXPECT_EQ(network.rim.mouths.size(), 4u); // the bulk lies below the hollow between the boxes
    check_network(scene, network);
    EXPECT_EQ(network.films[0].first_node, 0);
    EXPECT_EQ(network.films[1].first_node, static_cast<int>(network.films[0].mesh.h.size()));
    EXPECT_EQ(network.films[1].first_element, static_cast<int>(network.films[0].mesh.elements.size()));
    EXPECT_EQ(network.nodes, network.films[1].first_node + static_cast<int>(network.films[1].mesh.h.size()));
    EXPECT_EQ(network.elements, network.films[1].first_element + static_cast<int>(network.films[1].mesh.elements.size()));
    std::set<int> owners;
    for (const auto& [key, cell] : network.cells.cells)
        if (cell.kind == CellKind::film)
            owners.insert(cell.owner);
    EXPECT_EQ(owners.size(), 2u);
}

} // namespace
} // namespace gapflow::test
