// The dissipation of the plane: exact channels, what holds for every form, and Stokes flow against exact solutions.
#include "../grid/scenes.hpp"
#include "stokes.hpp"

#include "gapflow/complex/gap_drag.hpp"

#include <numbers>

namespace gapflow::testing {
namespace {

std::span<const double> all_of(const Eigen::VectorXd& x)
{
    return {x.data(), static_cast<std::size_t>(x.size())};
}

Grid<2> plane_grid(const Index<2>& cells, const std::array<SideKind, 4>& sides)
{
    return Grid<2>(Vec<2>::Zero(), 1.0, cells, sides, 2, Communicator(MPI_COMM_SELF));
}

ViscousForm<2> form_of(const Grid<2>& grid, const Scene<2>& scene, bool gaps = true)
{
    PartBorders<2> borders;
    const Complex<2> complex = build_complex<2>(grid, scene.solids, nullptr, &borders);
    return build_viscous_form<2>(grid, scene.solids, complex, borders,
                                 gaps ? find_gap_drag<2>(grid, scene.solids, complex) : GapDrags<2>{});
}

/// Channels of a width in a periodic domain, `slabs` of them side by side, along the direction (n_y, -n_x).
struct Channels {
    double period, length; ///< across, between images of one wall; along, of one channel
    Vec<2> along;
    Grid<2> grid;
    Scene<2> scene;

    Channels(int n, int nx, int ny, double width, int slabs, const Vec<2>& shift)
        : period(n / std::hypot(nx, ny)), length(n * std::hypot(nx, ny)), along(Vec<2>(ny, -nx).normalized()),
          grid(plane_grid(Index<2>::Constant(n), all_sides<2>(SideKind::periodic))), scene(grid)
    {
        const Vec<2> normal = Vec<2>(nx, ny).normalized();
        for (int k = 0; k < slabs; ++k)
            scene.add(numbered("slab", k), make_box<2>(Vec<2>(3.3 * length, period / slabs - width)),
                      pose<2>(Vec<2>(0.5 * n, 0.5 * n) + shift + k * period / slabs * normal, std::atan2(along[1], along[0])));
    }
};

TEST(ViscousForm2D, IsExactInFlatChannels)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(0, 1);
    for (const auto& [nx, ny] : {std::pair(0, 1), {1, 1}, {1, 2}, {2, 1}, {1, 3}})
        for (const double width : {0.05, 0.3, 0.7, 1.0, 1.7, 3.3, 5.0}) {
            const int n = nx == 0 ? 14 : 18;
            const Channels channels(n, nx, ny, width, 1, Vec<2>(number(random), number(random)));
            for (const bool gaps : {false, true}) {
                const ViscousForm<2> form = form_of(channels.grid, channels.scene, gaps);
                Stokes<2> stokes(form);
                const Eigen::VectorXd load = uniform_load<2>(form, channels.along),
                                      x = stokes.solve(Eigen::VectorXd::Zero(form.columns()), load);
                const double exact = channels.length * std::pow(width, 3) / 12;
                EXPECT_NEAR(load.dot(x) / exact, 1, gaps ? 1e-8 : 1e-10) << nx << ' ' << ny << ' ' << width << ' ' << gaps;
                EXPECT_NEAR(2 * form.energy(all_of(x)) / exact, 1, gaps ? 1e-8 : 1e-10);
            }
        }
}

TEST(ViscousForm2D, IsExactForShear)
{
    for (const auto& [nx, ny] : {std::pair(0, 1), {1, 1}, {1, 2}})
        for (const double width : {0.05, 0.4, 1.3, 3.1}) {
            const Channels channels(24, nx, ny, width, 2, Vec<2>(0.31, 0.77));
            for (const bool gaps : {false, true}) {
                const ViscousForm<2> form = form_of(channels.grid, channels.scene, gaps);
                Stokes<2> stokes(form);
                Eigen::VectorXd x = Eigen::VectorXd::Zero(form.columns());
                for (int k = 0; k < 2; ++k)
                    x[form.twist_column(0, k)] = channels.along[k];
                x = stokes.solve(x, Eigen::VectorXd::Zero(form.columns()));
                EXPECT_NEAR(form.energy(all_of(x)) / (channels.length / width), 1, gaps ? 1e-2 : 1e-10)
                    << nx << ' ' << ny << ' ' << width << ' ' << gaps;
            }
        }
}

TEST(ViscousForm2D, WideChannelsWithACompactMiddle)
{
    for (const double width : {8.3, 12.2, 16.7})
        for (const double at : {0.1, 0.37, 0.8}) {
            const Grid<2> grid = plane_grid(Index<2>(5, 20), all_sides<2>(SideKind::periodic));
            Scene<2> scene(grid);
            scene.add("slab", make_box<2>(Vec<2>(17, 20 - width)), pose<2>(Vec<2>(2.5, at)));
            const ViscousForm<2> form = form_of(grid, scene);
            Stokes<2> stokes(form);
            const Eigen::VectorXd load = uniform_load<2>(form, Vec<2>(1, 0)),
                                  x = stokes.solve(Eigen::VectorXd::Zero(form.columns()), load);
            EXPECT_NEAR(load.dot(x) / (5 * std::pow(width, 3) / 12), 1, 6e-4) << width << ' ' << at;
        }
}

// Beside closed sides the lattice has rows of its own.
TEST(ViscousForm2D, WideChannelsBetweenClosedSides)
{
    for (const int width : {16, 23, 40}) {
        const Grid<2> grid =
            plane_grid(Index<2>(5, width), {SideKind::periodic, SideKind::periodic, SideKind::wall, SideKind::wall});
        const ViscousForm<2> form = form_of(grid, Scene<2>(grid));
        EXPECT_TRUE(form.traces.empty()) << width;
        Stokes<2> stokes(form);
        const Eigen::VectorXd load = uniform_load<2>(form, Vec<2>(1, 0)),
                              x = stokes.solve(Eigen::VectorXd::Zero(form.columns()), load);
        EXPECT_NEAR(load.dot(x) / (5 * std::pow(width, 3) / 12), 1, 6e-4) << width;
        EXPECT_NEAR(2 * form.energy(all_of(x)) / load.dot(x), 1, 1e-9) << width;
    }
}

/// A cylinder and a box, askew, in a container that turns with them.
struct Crowd {
    Grid<2> grid = plane_grid(Index<2>::Constant(17), all_sides<2>(SideKind::open));
    Scene<2> scene{grid};
    Crowd()
    {
        scene.add("container", make_inside_out<2>(make_ball<2>(7.5)), pose<2>(Vec<2>(8.13, 8.24)));
        scene.add("cylinder", make_ball<2>(2.3), pose<2>(Vec<2>(6.2, 8.9)));
        scene.add("box", make_box<2>(Vec<2>(3.2, 2.1)), pose<2>(Vec<2>(10.5, 8.6), 0.4));
    }
};

/// All columns in one rigid motion.
Eigen::VectorXd rigid(const Scene<2>& scene, const ViscousForm<2>& form, const Twist<2>& common)
{
    Eigen::VectorXd x(form.columns());
    for (int k = 0; k < form.velocities(); ++k)
        x[k] = velocity_at<2>(common, form.faces[k].centroid)[form.faces[k].axis];
    for (std::size_t k = 0; k < form.traces.size(); ++k)
        x[form.velocities() + static_cast<int>(k)] = velocity_at<2>(common, form.traces[k].at)[form.traces[k].component];
    for (int solid = 0; solid < form.solids; ++solid) {
        x.segment<2>(form.twist_column(solid, 0)) = velocity_at<2>(common, scene.solids[solid].centre);
        x[form.twist_column(solid, 2)] = common[2];
    }
    return x;
}

TEST(ViscousForm2D, RigidMotionOfAllDissipatesNothing)
{
    const Crowd crowd;
    const ViscousForm<2> form = form_of(crowd.grid, crowd.scene, false);
    for (int k = 0; k < 3; ++k) {
        const Eigen::VectorXd x = rigid(crowd.scene, form, Twist<2>(Twist<2>::Unit(k)));
        Eigen::VectorXd y(form.columns());
        form.product(all_of(x), {y.data(), static_cast<std::size_t>(y.size())});
        // No force anywhere; none of these faces is of the compact lattice. Forces on slivers are as large as their areas are small.
        for (int face = 0; face < form.velocities(); ++face)
            y[face] *= form.faces[face].area;
        EXPECT_LT(y.cwiseAbs().maxCoeff(), 1e-8) << k;
        EXPECT_NEAR(form.energy(all_of(x)), 0, 1e-9 * 24 * 24) << k;
        for (int cell = 0; cell < form.cells.count(); ++cell)
            EXPECT_NEAR(form.outflow.value(cell, all_of(x)), 0, 1e-11 * 24) << k;
    }
}

TEST(ViscousForm2D, IsSymmetricAndPositive)
{
    const Crowd crowd;
    const ViscousForm<2> form = form_of(crowd.grid, crowd.scene);
    const int n = form.columns();
    std::srand(3);
    for (int k = 0; k < 5; ++k) {
        const Eigen::VectorXd a = Eigen::VectorXd::Random(n), b = Eigen::VectorXd::Random(n);
        Eigen::VectorXd Aa(n), Ab(n);
        form.product(all_of(a), {Aa.data(), static_cast<std::size_t>(n)});
        form.product(all_of(b), {Ab.data(), static_cast<std::size_t>(n)});
        EXPECT_NEAR(a.dot(Ab) / b.dot(Aa), 1, 1e-9);
        EXPECT_GT(form.squares.twice(all_of(a)), 0);
    }
}

TEST(ViscousForm2D, WallsPowerIsTwiceTheDissipation)
{
    const Crowd crowd;
    for (const bool gaps : {false, true}) {
        const ViscousForm<2> form = form_of(crowd.grid, crowd.scene, gaps);
        Stokes<2> stokes(form);
        Eigen::MatrixXd resistance(9, 9);
        for (int k = 0; k < 9; ++k) {
            Eigen::VectorXd x = Eigen::VectorXd::Zero(form.columns());
            x[form.unknowns() + k] = 1;
            x = stokes.solve(x, Eigen::VectorXd::Zero(form.columns()));
            const Eigen::VectorXd wrench = stokes.with_rotation(x);
            resistance.col(k) = wrench.tail<9>();
            EXPECT_NEAR(wrench[form.unknowns() + k] / (2 * form.energy(all_of(x))), 1, 1e-10) << k;
            EXPECT_LT(wrench.head(form.unknowns()).cwiseAbs().maxCoeff(), 1e-8 * wrench.tail<9>().cwiseAbs().maxCoeff());
        }
        // Reciprocity, and no wrench on solids in a common motion.
        const double scale = resistance.cwiseAbs().maxCoeff();
        EXPECT_LT((resistance - resistance.transpose()).cwiseAbs().maxCoeff(), 1e-9 * scale);
        for (int k = 0; k < 3; ++k) {
            const Eigen::VectorXd all = rigid(crowd.scene, form, Twist<2>(Twist<2>::Unit(k))).tail<9>();
            // In gaps of changing thickness the rotation of all is not exact.
            EXPECT_LT((resistance * all).cwiseAbs().maxCoeff(), (gaps && k == 2 ? 1e-3 : 1e-9) * scale * all.norm()) << k;
        }
    }
}

TEST(ViscousForm2D, SquareArraysOfCylinders)
{
    // A. S. Sangani and A. Acrivos, Int. J. Multiphase Flow 8 (1982) 193-206.
    struct Case {
        double fraction, drag, tolerance;
    };
    for (const int n : {12, 24})
        for (const Case& c : {Case{0.05, 15.56, 0.010}, {0.2, 51.53, 0.006}, {0.4, 217.89, 0.004}, {0.6, 1763, 0.005}})
            for (int place = 0; place < 3; ++place) {
                const Grid<2> grid = plane_grid(Index<2>::Constant(n), all_sides<2>(SideKind::periodic));
                Scene<2> scene(grid);
                scene.add("cylinder", make_ball<2>(n * std::sqrt(c.fraction / std::numbers::pi)),
                          pose<2>(Vec<2>(n / 2 + 0.3 * place + 0.013, n / 2 + 0.41 * place + 0.007)));
                const ViscousForm<2> form = form_of(grid, scene);
                Stokes<2> stokes(form);
                const Eigen::VectorXd load = uniform_load<2>(form, Vec<2>(1, 0)),
                                      x = stokes.solve(Eigen::VectorXd::Zero(form.columns()), load);
                EXPECT_NEAR(std::pow(n, 4) / load.dot(x) / c.drag, 1, c.tolerance * (n == 12 ? 1 : 0.5))
                    << n << ' ' << c.fraction;
            }
}

TEST(ViscousForm2D, CylinderOverAWall)
{
    // 4 cells a radius, towards a wall at any angle and turning: D. J. Jeffrey and Y. Onishi, Quart. J. Mech. Appl. Math. 34 (1981) 129-137.
    struct Case {
        double gap, normal, turning;
    };
    const double R = 4;
    for (const Case& c :
         {Case{0.4, 0.01, 0.02}, {0.1, 0.035, 0.02}, {0.05, 0.025, 0.025}, {0.01, 0.012, 0.025}, {1e-3, 0.002, 0.015}})
        for (const double angle : {0.0, 0.2, 0.4636, 0.6, std::numbers::pi / 4})
            for (int place = 0; place < 2; ++place) {
                const Grid<2> grid = plane_grid(Index<2>::Constant(72), all_sides<2>(SideKind::open));
                const Vec<2> n(-std::sin(angle), std::cos(angle)), foot(36.013 + 0.27 * place, 36.117 + 0.37 * place);
                Scene<2> scene(grid);
                const int cylinder = scene.add("cylinder", make_ball<2>(R), pose<2>(Vec<2>(foot + R * (1 + c.gap) * n)));
                scene.add("wall", make_half_space<2>(n), pose<2>(foot));
                const ViscousForm<2> form = form_of(grid, scene);
                Stokes<2> stokes(form);
                const double a = std::acosh(1 + c.gap);
                const auto resistance = [&](const Twist<2>& twist) {
                    Eigen::VectorXd x = Eigen::VectorXd::Zero(form.columns());
                    x.segment<3>(form.twist_column(cylinder, 0)) = twist;
                    x = stokes.solve(x, Eigen::VectorXd::Zero(form.columns()));
                    return twist.dot(stokes.with_rotation(x).segment<3>(form.twist_column(cylinder, 0)));
                };
                EXPECT_NEAR(resistance({n[0], n[1], 0}) * (a - std::tanh(a)) / (4 * std::numbers::pi), 1, c.normal)
                    << c.gap << ' ' << angle;
                EXPECT_NEAR(resistance({0, 0, 1}) * std::tanh(a) / (4 * std::numbers::pi * R * R), 1, c.turning)
                    << c.gap << ' ' << angle;
            }
}

TEST(ViscousForm2D, Bearings)
{
    // Torque and load on the inner cylinder at the speed 1 of its surface: G. H. Wannier, Quart. Appl. Math. 8 (1950) 1-32. Radius, eccentricity ratio.
    struct Case {
        double radius, eccentricity, torque, load, torque_tolerance, load_tolerance;
    };
    for (const Case& c : {Case{0.5, 0.5, 10.0119599, 13.8336642, 1e-3, 2e-3},
                          {0.5, 0.9, 20.4224383, 39.3203946, 4e-3, 6e-3},
                          {0.5, 0.99, 63.0142271, 125.603824, 1e-2, 1e-2},
                          {0.5, 0.999, 198.749690, 397.366737, 5e-3, 5e-3},
                          {0.9, 0.5, 87.1481120, 826.156356, 4e-3, 1e-2},
                          {0.9, 0.9, 231.367482, 2365.32270, 5e-3, 5e-3},
                          {0.9, 0.99, 756.076000, 7580.13048, 4e-3, 4e-3},
                          {0.99, 0.5, 957.694904, 95288.7808, 4e-3, 5e-3}}) {
        const double outer = 32 / 2.2, angle = 0.44;
        const Vec<2> way(std::cos(angle), std::sin(angle)), across(-way[1], way[0]);
        for (const Vec<2>& shift : {Vec<2>(0.3, 0.4), Vec<2>(0.71, 0.13)}) {
            const Grid<2> grid = plane_grid(Index<2>::Constant(34), all_sides<2>(SideKind::wall));
            Scene<2> scene(grid);
            const Vec<2> centre = Vec<2>::Constant(16) + shift;
            const int inner = scene.add("inner", make_ball<2>(c.radius * outer),
                                        pose<2>(Vec<2>(centre + c.eccentricity * (1 - c.radius) * outer * way)));
            scene.add("outer", make_inside_out<2>(make_ball<2>(outer)), pose<2>(centre));
            const ViscousForm<2> form = form_of(grid, scene);
            Stokes<2> stokes(form);
            Eigen::VectorXd x = Eigen::VectorXd::Zero(form.columns());
            x[form.twist_column(inner, 2)] = 1 / (c.radius * outer);
            const Eigen::VectorXd wrench = stokes.with_rotation(stokes.solve(x, Eigen::VectorXd::Zero(form.columns())));
            EXPECT_NEAR(wrench[form.twist_column(inner, 2)] / (c.torque * outer), 1, c.torque_tolerance)
                << c.radius << ' ' << c.eccentricity;
            EXPECT_NEAR(std::abs(wrench.segment<2>(form.twist_column(inner, 0)).dot(across)) / c.load, 1, c.load_tolerance)
                << c.radius << ' ' << c.eccentricity;
        }
    }
}

} // namespace
} // namespace gapflow::testing
