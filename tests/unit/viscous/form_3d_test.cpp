// The dissipation in space: channels at any angle, what holds for every form, and arrays of spheres.
#include "../grid/scenes.hpp"
#include "stokes.hpp"

#include <limits>
#include <numbers>

namespace gapflow::testing {
namespace {

std::span<const double> all_of(const Eigen::VectorXd& x)
{
    return {x.data(), static_cast<std::size_t>(x.size())};
}

Grid<3> space_grid(const Index<3>& cells, const std::array<SideKind, 6>& sides)
{
    return Grid<3>(Vec<3>::Zero(), 1.0, cells, sides, 2, Communicator(MPI_COMM_SELF));
}

struct Built {
    PartBorders<3> borders;
    Complex<3> complex;
    ViscousForm<3> form;

    Built(const Grid<3>& grid, const Scene<3>& scene)
        : complex(build_complex<3>(grid, scene.solids, nullptr, &borders)),
          form(build_viscous_form<3>(grid, scene.solids, complex, borders))
    {
    }
    /// Of a quadratic function over a face.
    template <class Field>
    double mean(const FormFace<3>& face, Field&& u) const
    {
        std::vector<Vec<3>> points;
        const int v = (face.axis + 1) % 3, w = (face.axis + 2) % 3;
        double least = std::numeric_limits<double>::infinity();
        for (const PartFace<3>& polygon : borders) {
            if (face.whole || polygon.sides.empty() ||
                std::ranges::any_of(polygon.points, [&](const Vec<3>& x) { return x[face.axis] != face.centroid[face.axis]; }))
                continue;
            const double far = (polygon_centroid(polygon.points) - face.centroid).norm();
            if (far < least) {
                least = far;
                points = polygon.points;
            }
        }
        if (face.whole)
            for (const auto& [a, b] : {std::pair(-0.5, -0.5), {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
                points.push_back(face.centroid + a * unit<3>(v) + b * unit<3>(w));
        double sum = 0, area = 0;
        for (std::size_t k = 1; k + 1 < points.size(); ++k) {
            const Vec<3>&p = points[0], &q = points[k], &r = points[k + 1];
            const double part = 0.5 * (q - p).cross(r - p)[face.axis];
            sum += part / 3 * (u(0.5 * (p + q)) + u(0.5 * (q + r)) + u(0.5 * (r + p)));
            area += part;
        }
        return sum / area;
    }
    static Vec<3> polygon_centroid(const std::vector<Vec<3>>& points)
    {
        Vec<3> sum = Vec<3>::Zero();
        double all = 0;
        for (std::size_t k = 1; k + 1 < points.size(); ++k) {
            const Vec<3> n = (points[k] - points[0]).cross(points[k + 1] - points[0]);
            const double part = n.sum();
            sum += part / 3 * (points[0] + points[k] + points[k + 1]);
            all += part;
        }
        return sum / all;
    }
    /// All columns but the twists in a quadratic field.
    template <class Field>
    Eigen::VectorXd sampled(Field&& u) const
    {
        Eigen::VectorXd x = Eigen::VectorXd::Zero(form.columns());
        for (int k = 0; k < form.velocities(); ++k)
            x[k] = mean(form.faces[k], [&](const Vec<3>& at) { return u(at)[form.faces[k].axis]; });
        for (std::size_t k = 0; k < form.traces.size(); ++k) {
            const FormTrace<3>& trace = form.traces[k];
            for (int i = 0; i < 3; ++i)
                x[form.velocities() + static_cast<int>(k)] +=
                    (i == 1 ? 4.0 : 1.0) / 6 *
                    u(trace.at + 0.5 * (i - 1) * trace.length * unit<3>(trace.axis))[trace.component];
        }
        return x;
    }
};

TEST(ViscousForm3D, IsExactBetweenClosedSides)
{
    // All faces of a channel of four cells have elements.
    const Grid<3> grid = space_grid(Index<3>(4, 5, 4), {SideKind::periodic, SideKind::periodic, SideKind::periodic,
                                                        SideKind::periodic, SideKind::wall, SideKind::wall});
    const Scene<3> scene(grid);
    const Built built(grid, scene);
    Stokes<3> stokes(built.form);
    for (const Vec<3>& along : {Vec<3>(1, 0, 0), Vec<3>(0, 1, 0)}) {
        const Eigen::VectorXd load = uniform_load<3>(built.form, along),
                              x = stokes.solve(Eigen::VectorXd::Zero(built.form.columns()), load);
        EXPECT_NEAR(load.dot(x) / (20.0 * 64 / 12), 1, 1e-10);
        EXPECT_NEAR(2 * built.form.energy(all_of(x)) / load.dot(x), 1, 1e-9);
    }
}

// Runs of the lattice, shared elements and rows are one matrix.
TEST(ViscousForm3D, ProductsAreThoseOfTheSquares)
{
    const Grid<3> grid = space_grid(Index<3>(17, 18, 16), {SideKind::periodic, SideKind::periodic, SideKind::wall,
                                                           SideKind::wall, SideKind::open, SideKind::wall});
    Scene<3> scene(grid);
    scene.add("ball", make_ball<3>(1.7), pose<3>(Vec<3>(8.1, 9.2, 7.4)));
    const Built built(grid, scene);
    const ViscousForm<3>& form = built.form;
    EXPECT_GT(form.lattice.runs.size(), 0);
    EXPECT_GT(form.lattice.links.size(), 0);
    const Eigen::SparseMatrix<double> matrix = form.plain_squares().assembled(form.columns());
    std::srand(3);
    Eigen::VectorXd x = Eigen::VectorXd::Random(form.columns()), y(form.columns());
    x.tail(form.columns() - form.unknowns()).setZero(); // the rotation is in none
    form.product(all_of(x), {y.data(), static_cast<std::size_t>(y.size())});
    EXPECT_LT((y - matrix * x).cwiseAbs().maxCoeff(), 1e-11 * y.cwiseAbs().maxCoeff());
    const std::vector<double> diagonal = form.diagonal();
    for (int k = 0; k < form.velocities(); ++k)
        if (form.faces[k].compact) {
            EXPECT_NEAR(diagonal[k] / matrix.coeff(k, k), 1, 1e-12) << k;
        }
}

TEST(ViscousForm3D, IsExactInChannelsAtAnyAngle)
{
    // Velocities on the domain's sides are data; those inside are the exact ones.
    constexpr int n = 6;
    for (const Vec<3>& normal : {Vec<3>(0, 0, 1), Vec<3>(1, 0, 1), Vec<3>(1, 0, 2), Vec<3>(1, 1, 1), Vec<3>(1, 2, 3)})
        for (const double width : {0.3, 1.0, 2.3}) {
            const Grid<3> grid = space_grid(Index<3>::Constant(n), all_sides<3>(SideKind::open));
            Scene<3> scene(grid);
            const Vec<3> up = normal.normalized(), centre(3.13, 2.91, 3.27), along = up.unitOrthogonal();
            for (const int side : {-1, 1}) {
                Pose<3> at;
                at.position = centre + side * (0.5 * width + 15) * up;
                at.rotation = Rotation<3>(Eigen::Quaterniond::FromTwoVectors(Vec<3>(0, 0, 1), up));
                scene.add(numbered("wall", side + 1), make_box<3>(Vec<3>(60, 60, 30)), at);
            }
            const Built built(grid, scene);
            const Eigen::VectorXd exact = built.sampled([&](const Vec<3>& x) {
                const double z = up.dot(x - centre) / width + 0.5;
                return Vec<3>((z + 6 * z * (1 - z)) * along); // shear of the upper wall's motion, and a pressure gradient
            });
            std::vector<char> known(built.form.unknowns());
            const auto on_side = [&](const Vec<3>& x) { return (x.array() < 1e-9).any() || (x.array() > n - 1e-9).any(); };
            for (int k = 0; k < built.form.unknowns(); ++k)
                known[k] = on_side(k < built.form.velocities() ? built.form.faces[k].centroid
                                                               : built.form.traces[k - built.form.velocities()].at);
            Stokes<3> stokes(built.form, known);
            ASSERT_TRUE(stokes.ok);
            Eigen::VectorXd x = exact;
            for (int k = 0; k < 3; ++k)
                x[built.form.twist_column(1, k)] = along[k];
            x = stokes.solve(x, Eigen::VectorXd::Zero(built.form.columns()));
            EXPECT_LT((x - exact).head(built.form.velocities()).cwiseAbs().maxCoeff(), 1e-8)
                << normal.transpose() << ", " << width;
        }
}

TEST(ViscousForm3D, WallsPowerIsTwiceTheDissipation)
{
    const Grid<3> grid = space_grid(Index<3>::Constant(8), all_sides<3>(SideKind::open));
    Scene<3> scene(grid);
    scene.add("container", make_inside_out<3>(make_ball<3>(3.7)), pose<3>(Vec<3>(4.03, 3.94, 4.06)));
    scene.add("ball", make_ball<3>(1.3), pose<3>(Vec<3>(3.21, 3.47, 4.3)));
    const Built built(grid, scene);
    const ViscousForm<3>& form = built.form;
    Stokes<3> stokes(form);
    ASSERT_TRUE(stokes.ok);
    Eigen::MatrixXd resistance(12, 12);
    for (int k = 0; k < 12; ++k) {
        Eigen::VectorXd x = Eigen::VectorXd::Zero(form.columns());
        x[form.unknowns() + k] = 1;
        x = stokes.solve(x, Eigen::VectorXd::Zero(form.columns()));
        const Eigen::VectorXd wrench = stokes.with_rotation(x);
        resistance.col(k) = wrench.tail<12>();
        EXPECT_NEAR(wrench[form.unknowns() + k] / (2 * form.energy(all_of(x))), 1, 1e-9) << k;
    }
    const double scale = resistance.cwiseAbs().maxCoeff();
    EXPECT_LT((resistance - resistance.transpose()).cwiseAbs().maxCoeff(), 1e-8 * scale);
    for (int k = 0; k < 3; ++k) { // in a translation of all
        const Eigen::VectorXd all = Eigen::VectorXd::Unit(12, k) + Eigen::VectorXd::Unit(12, 6 + k);
        EXPECT_LT((resistance * all).cwiseAbs().maxCoeff(), 1e-8 * scale) << k;
    }
}

TEST(ViscousForm3D, CubicArraysOfSpheres)
{
    // A. A. Zick and G. M. Homsy, J. Fluid Mech. 115 (1982) 13-26.
    struct Case {
        int cells;
        double fraction, drag, tolerance;
    };
    for (const Case& c :
         {Case{8, 0.125, 4.292, 0.01}, {8, 0.343, 15.4, 0.01}, {8, 0.45, 28.1, 0.01}, {12, 0.45, 28.1, 0.005}}) {
        const Grid<3> grid = space_grid(Index<3>::Constant(c.cells), all_sides<3>(SideKind::periodic));
        const double radius = c.cells * std::cbrt(0.75 * c.fraction / std::numbers::pi);
        Scene<3> scene(grid);
        scene.add("ball", make_ball<3>(radius), pose<3>(Vec<3>(c.cells * Vec<3>(0.513, 0.507, 0.503))));
        const Built built(grid, scene);
        Stokes<3> stokes(built.form);
        ASSERT_TRUE(stokes.ok);
        const Eigen::VectorXd load = uniform_load<3>(built.form, Vec<3>(1, 0, 0)),
                              x = stokes.solve(Eigen::VectorXd::Zero(built.form.columns()), load);
        const double drag = std::pow(c.cells, 6) / load.dot(x) / (6 * std::numbers::pi * radius);
        EXPECT_NEAR(drag / c.drag, 1, c.tolerance) << c.cells << ' ' << c.fraction;
    }
}

TEST(ViscousForm3D, BallNextToAWall)
{
    // A ball of 2 cells a radius, 0.02 cells from a closed side, towards it: H. Brenner, Chem. Eng. Sci. 16 (1961) 242-251, 101.896 Stokes drags.
    const Grid<3> grid = space_grid(
        Index<3>(10, 10, 8), {SideKind::open, SideKind::open, SideKind::open, SideKind::open, SideKind::wall, SideKind::open});
    Scene<3> scene(grid);
    const int ball = scene.add("ball", make_ball<3>(2), pose<3>(Vec<3>(5.3, 5.1, 2.02)));
    const Built built(grid, scene);
    const GapDrags<3> gaps = find_gap_drag<3>(grid, scene.solids, built.complex);
    const ViscousForm<3> with_gaps = build_viscous_form<3>(grid, scene.solids, built.complex, built.borders, gaps);
    // Friction in gaps is told by these rows alone, so they have no derived columns.
    const SquareSum& squares = with_gaps.squares;
    EXPECT_LT(with_gaps.gap_rows[0], with_gaps.gap_rows[1]);
    for (std::int64_t t = squares.end[with_gaps.gap_rows[0]]; t < squares.end[with_gaps.gap_rows[1]]; ++t)
        EXPECT_LT(squares.column[t], with_gaps.columns());
    for (const ViscousForm<3>* form : {&with_gaps, &built.form}) {
        Stokes<3> stokes(*form);
        ASSERT_TRUE(stokes.ok);
        Eigen::VectorXd x = Eigen::VectorXd::Zero(form->columns());
        x[form->twist_column(ball, 2)] = 1;
        x = stokes.solve(x, Eigen::VectorXd::Zero(form->columns()));
        const double wrench = stokes.with_rotation(x)[form->twist_column(ball, 2)],
                     drag = wrench / (6 * std::numbers::pi * 2 * 101.896);
        if (form == &with_gaps)
            EXPECT_NEAR(drag, 1, 0.06);
        else // elements alone do not resolve it
            EXPECT_LT(drag, 0.85);
        EXPECT_NEAR(wrench / (2 * form->energy(all_of(x))), 1, 1e-9);
    }
}

} // namespace
} // namespace gapflow::testing
