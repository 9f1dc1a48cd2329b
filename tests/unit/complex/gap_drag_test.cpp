// Drag of gaps alone, the rest of the fluid without resistance: against Reynolds' equation, and of a bearing against Wannier's exact flow.
#include "gapflow/complex/gap_drag.hpp"
#include "gapflow/complex/parameters.hpp"

#include <gtest/gtest.h>

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>

namespace gapflow {
namespace {

/// Parts of the fluid that faces without drag join.
template <int D>
class Pools {
public:
    Pools(const Complex<D>& complex, const GapDrags<D>& drags) : complex_(complex), root_(complex.parts() + complex.index.count)
    {
        std::iota(root_.begin(), root_.end(), 0);
        std::vector<bool> dragged(complex.pieces.size());
        for (const GapDrag<D>& drag : drags.faces)
            dragged[drag.piece] = true;
        std::array<std::vector<bool>, D> cut;
        cut.fill(std::vector<bool>(complex.index.count));
        for (std::size_t k = 0; k < complex.pieces.size(); ++k) {
            const FacePiece<D>& piece = complex.pieces[k];
            cut[piece.axis][piece.face] = true;
            if (!dragged[k] && piece.area > 0)
                join(piece.low, piece.high);
        }
        for (int c = 0; c < complex.index.count; ++c)
            for (int axis = 0; axis < D; ++axis) {
                const Index<D> cell = complex.index.index(c), below = cell - step<D>(axis);
                if (!cut[axis][c] && complex.main_area[axis][c] > 0 && complex.index.holds(cell) && complex.index.holds(below))
                    join(complex.main_of(complex.index(below)), complex.main_of(c));
            }
        for (const CornerLink<D>& link : complex.links)
            join(PartOrCell::part(link.a), PartOrCell::part(link.b));
    }
    int of(const PartOrCell& side)
    {
        int at = side.is_part() ? side.number() : complex_.parts() + side.number();
        while (root_[at] != at)
            at = root_[at] = root_[root_[at]];
        return at;
    }

private:
    void join(const PartOrCell& a, const PartOrCell& b)
    {
        if (a.exists() && b.exists())
            root_[of(a)] = of(b);
    }

    const Complex<D>& complex_;
    std::vector<int> root_;
};

/// The least dissipation under continuity of every part, by the twists of two solids.
template <int D>
PairMass<D> drag_of_gaps(const Complex<D>& complex, const GapDrags<D>& drags)
{
    constexpr int T = twist_size<D>;
    Pools<D> pools(complex, drags);
    std::map<int, int> number;
    const auto node = [&](const PartOrCell& side) {
        return number.emplace(pools.of(side), static_cast<int>(number.size())).first->second;
    };
    PairMass<D> result = PairMass<D>::Zero();
    std::vector<std::array<int, 2>> ends;
    for (const GapDrag<D>& drag : drags.faces)
        ends.push_back({node(complex.pieces[drag.piece].low), node(complex.pieces[drag.piece].high)});
    const int n = static_cast<int>(number.size());
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, 2 * T);
    std::vector<int> parts(n);
    for (int p = 0; p < complex.parts(); ++p)
        if (const auto at = number.find(pools.of(PartOrCell::part(p))); at != number.end()) {
            ++parts[at->second];
            for (const WallPatch<D>& patch : complex.patches_of(p)) {
                K.block(at->second, T * patch.solid, 1, D) += patch.area.transpose();
                K.block(at->second, T * patch.solid + D, 1, T - D) += patch.moment.transpose();
            }
        }
    const auto by_solid = [&](const std::array<std::int32_t, 2>& solid, PairTwist<D> row) {
        if (solid[0] == 1)
            row << row.template tail<T>().eval(), row.template head<T>().eval();
        return row;
    };
    const auto add = [&](const std::array<std::int32_t, 2>& solid, const PairMass<D>& mass) {
        PairMass<D> half, whole;
        for (int k = 0; k < 2 * T; ++k)
            half.col(k) = by_solid(solid, mass.col(k));
        for (int k = 0; k < 2 * T; ++k)
            whole.row(k) = by_solid(solid, half.row(k).transpose()).transpose();
        result += whole;
    };
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<int> group(n); // nodes that the gap joins
    std::iota(group.begin(), group.end(), 0);
    const auto group_of = [&](int k) {
        while (group[k] != k)
            k = group[k];
        return k;
    };
    for (std::size_t k = 0; k < ends.size(); ++k) {
        const GapDrag<D>& drag = drags.faces[k];
        const auto [low, high] = ends[k];
        add(drag.solid, drag.mass - drag.flux * drag.flux.transpose() / drag.resistance);
        const PairTwist<D> row =
            by_solid(drag.solid, complex.pieces[drag.piece].area * drag.motion - drag.flux / drag.resistance);
        K.row(low) += row.transpose();
        K.row(high) -= row.transpose();
        group[group_of(low)] = group_of(high);
        for (const auto& [i, j] : {std::pair(low, high), std::pair(high, low)}) {
            entries.emplace_back(i, i, 1 / drag.resistance);
            entries.emplace_back(i, j, -1 / drag.resistance);
        }
    }
    for (const PeakDrag<D>& peak : drags.peaks)
        add(peak.solid, peak.mass);
    std::map<int, int> widest; // of each group: its pressure is 0
    for (int k = 0; k < n; ++k) {
        const auto [at, found] = widest.emplace(group_of(k), k);
        if (!found && parts[k] > parts[at->second])
            at->second = k;
    }
    for (const auto& [g, k] : widest) {
        std::erase_if(entries, [k = k](const auto& e) { return e.row() == k || e.col() == k; });
        entries.emplace_back(k, k, 1.0);
        K.row(k).setZero();
    }
    Eigen::SparseMatrix<double> L(n, n);
    L.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(L);
    return result + K.transpose() * factor.solve(K);
}

/// Rigid motion of both solids dissipates nothing, and what a face dissipates is a sum of squares.
template <int D>
void check_form(const GapDrags<D>& drags, const std::vector<Solid<D>>& solids)
{
    constexpr int T = twist_size<D>;
    const auto is_square = [](PairMass<D> rest, double scale) { // by elimination, the largest pivots first
        for (int k = 0; k < 2 * T; ++k) {
            int most = 0;
            for (int i = 0; i < 2 * T; ++i) {
                if (rest(i, i) < -1e-12 * scale)
                    return false;
                most = rest(i, i) > rest(most, most) ? i : most;
            }
            if (rest(most, most) < 1e-12 * scale)
                return true;
            const PairTwist<D> row = rest.col(most) / std::sqrt(rest(most, most));
            rest -= row * row.transpose();
        }
        return true;
    };
    for (const GapDrag<D>& drag : drags.faces) {
        Eigen::Matrix<double, 2 * T, T> rigid = Eigen::Matrix<double, 2 * T, T>::Zero();
        for (int side = 0; side < 2; ++side) {
            const Vec<D> x = solids[drag.solid[side]].centre;
            rigid.template block<T, T>(side * T, 0).setIdentity();
            if constexpr (D == 2)
                rigid.template block<2, 1>(side * T, 2) << -x[1], x[0];
            else
                for (int k = 0; k < 3; ++k)
                    rigid.template block<3, 1>(side * T, 3 + k) = unit<3>(k).cross(x);
        }
        EXPECT_LE((drag.flux.transpose() * rigid).norm(), 1e-11 * drag.flux.norm());
        EXPECT_LE((drag.mass * rigid).norm(), 1e-11 * drag.mass.norm());
        EXPECT_GT(drag.resistance, 0);
        EXPECT_TRUE(is_square(drag.mass - drag.flux * drag.flux.transpose() / drag.resistance, drag.mass.norm()));
    }
    for (const PeakDrag<D>& peak : drags.peaks)
        EXPECT_TRUE(is_square(peak.mass, peak.mass.norm()));
}

/// The middle between a wall (a plane, or round with a radius) and a round body above it, from the least gap outwards.
struct MiddlePoint {
    double s, t, share;
    Eigen::Vector2d x, n, wall; ///< middle, normal towards the body, and the body's wall
};
std::vector<MiddlePoint> middle_line(double wall_radius, double radius, double gap) // negative: a container
{
    const Eigen::Vector2d body(0, gap + radius), round(0, -wall_radius);
    Eigen::Vector2d x(0, 0.5 * gap);
    std::vector<MiddlePoint> line;
    for (double s = 0;;) {
        MiddlePoint at;
        for (int k = 0; k < 20; ++k) {
            const Eigen::Vector2d r = x - round, up = (x - body).normalized(),
                                  down = wall_radius == 0 ? Eigen::Vector2d(0, 1)
                                                          : Eigen::Vector2d(r.normalized() * std::copysign(1, wall_radius));
            const double low = wall_radius == 0 ? x[1] : std::copysign(1, wall_radius) * r.norm() - wall_radius,
                         high = (x - body).norm() - radius;
            at.n = (down - up).normalized();
            at.t = (low + high) / at.n.dot(down);
            x += 0.5 * (high - low) / at.n.dot(down) * at.n;
        }
        at.s = s;
        at.x = x;
        at.wall = x + 0.5 * at.t * at.n;
        const double f = std::clamp((parameters.gap_end - at.t) / (parameters.gap_end - parameters.gap_start), 0.0, 1.0);
        at.share = f * f * (3 - 2 * f);
        line.push_back(at);
        if (at.share == 0 || x[0] > 0.95 * radius)
            return line;
        const double step = 2e-3 * std::max(std::sqrt(gap * radius), 0.3 * s);
        x += step * Eigen::Vector2d(at.n[1], -at.n[0]);
        s += step;
    }
}

using FluxAndTwist = Eigen::Vector4d;

/// 2 int (d_s u)^2 over the thickness of u = 6 W/t (1/4 - z^2) + z v, z = -1/2 .. 1/2, by Gauss's rule.
Eigen::Matrix4d change_along(const FluxAndTwist& W, const FluxAndTwist& W_rate, const FluxAndTwist& v, double t, double t_rate)
{
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    for (const auto& [z, weight] : {std::pair(0.0, 4.0 / 9), {-std::sqrt(0.15), 5.0 / 18}, {std::sqrt(0.15), 5.0 / 18}}) {
        const FluxAndTwist rate =
            6 * (0.25 - z * z) * (W_rate / t - t_rate / (t * t) * W) + 12 * z * z * t_rate / (t * t) * W - z * t_rate / t * v;
        sum += 2 * weight * t * rate * rate.transpose();
    }
    return sum;
}

/// Of the body along the wall, normal to it and turning, the wall at rest.
Eigen::Matrix3d cylinder_drag(double wall_radius, double radius, double gap)
{
    const std::vector<MiddlePoint> line = middle_line(wall_radius, radius, gap);
    Eigen::Matrix4d form = Eigen::Matrix4d::Zero(); // of a flux that all sections have and of the twist
    for (const int side : {-1, 1}) {
        const auto from_centre = [&](const MiddlePoint& at) {
            return Eigen::Vector2d(side * at.wall[0], at.wall[1] - gap - radius);
        };
        const auto stream = [&](const MiddlePoint& at) {
            const Eigen::Vector2d r = from_centre(at);
            return FluxAndTwist(1, r[1], -r[0], -0.5 * r.squaredNorm());
        };
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            const double step = line[k + 1].s - line[k].s, t_rate = side * (line[k + 1].t - line[k].t) / step;
            const FluxAndTwist W_rate = side / step * (stream(line[k + 1]) - stream(line[k]));
            for (const MiddlePoint& at : {line[k], line[k + 1]}) {
                const Eigen::Vector2d r = from_centre(at), along(at.n[1], -side * at.n[0]);
                const FluxAndTwist speed(0, along[0], along[1], r[0] * along[1] - r[1] * along[0]),
                    W = stream(at) - 0.5 * at.t * speed;
                form += 0.5 * step * at.share *
                        (12 / std::pow(at.t, 3) * W * W.transpose() + speed * speed.transpose() / at.t +
                         change_along(W, W_rate, speed, at.t, t_rate));
            }
        }
    }
    return form.bottomRightCorner<3, 3>() - form.bottomLeftCorner<3, 1>() * form.topRightCorner<1, 3>() / form(0, 0);
}

struct BallDrag {
    double normal, along, turning;
};
BallDrag ball_drag(double wall_radius, double radius, double gap)
{
    const std::vector<MiddlePoint> line = middle_line(wall_radius, radius, gap);
    const int n = static_cast<int>(line.size());
    BallDrag drag{0, 0, 0};
    for (int i = 0; i + 1 < n; ++i)
        for (const MiddlePoint& at : {line[i], line[i + 1]}) {
            const double ds = 0.5 * (line[i + 1].s - line[i].s) * at.share, r = at.x[0], v = -at.n[0];
            if (r > 0) {
                const double W = -at.wall[0] * at.wall[0] / (2 * r) - 0.5 * at.t * v;
                drag.normal += 2 * M_PI * r * ds * (12 * W * W / std::pow(at.t, 3) + v * v / at.t);
            }
        }
    // Along and turning: the cosine and sine of the azimuth. Flux of the wall, and speeds along the line and around it.
    Eigen::MatrixXd along(n, 2), around(n, 2), b = Eigen::MatrixXd::Zero(n - 1, 2);
    for (int i = 0; i < n; ++i) {
        const Eigen::Vector2d y = line[i].wall - Eigen::Vector2d(0, gap + radius), tangent(line[i].n[1], -line[i].n[0]);
        along.row(i) << tangent[0], y[1] * tangent[0] - y[0] * tangent[1];
        around.row(i) << -1, -y[1];
    }
    Eigen::VectorXd below = Eigen::VectorXd::Zero(n - 1), middle = below, above = below;
    const auto conductance = [&](int i) { return std::pow(line[i].t, 3) / 12 / std::max(line[i].share, 1e-9); };
    for (int i = 0; i + 1 < n; ++i) {
        const MiddlePoint &p = line[i], &q = line[i + 1];
        const double ds = q.s - p.s;
        middle[i] += 0.5 * (conductance(i) + conductance(i + 1)) / (0.5 * (p.x[0] + q.x[0])) * ds;
        if (i > 0) {
            below[i] = -conductance(i) * p.x[0] / (0.5 * (q.s - line[i - 1].s));
            middle[i] -= below[i];
        }
        const double to_next = i + 2 < n ? 0.5 * (line[i + 2].s - p.s) : 0.5 * ds, g = conductance(i + 1) * q.x[0] / to_next;
        middle[i] += g;
        above[i] = i + 2 < n ? -g : 0;
        for (int k = 0; k < 2; ++k) { // a ball that turns has no flux
            const Eigen::Vector2d y = 0.5 * (p.wall + q.wall) - Eigen::Vector2d(0, gap + radius);
            const double flux = k == 0 ? (q.wall - p.wall).norm() * 0.5 * (p.wall[0] + q.wall[0]) * y[0] / y.norm() : 0;
            b(i, k) = flux - 0.5 * (q.t * q.x[0] * along(i + 1, k) - p.t * p.x[0] * along(i, k)) -
                      0.25 * (p.t * around(i, k) + q.t * around(i + 1, k)) * ds;
        }
    }
    Eigen::MatrixXd x = b;
    for (int i = 1; i + 1 < n; ++i) {
        const double f = below[i] / middle[i - 1];
        middle[i] -= f * above[i - 1];
        x.row(i) -= f * x.row(i - 1);
    }
    for (int i = n - 2; i >= 0; --i) {
        if (i + 2 < n)
            x.row(i) -= above[i] * x.row(i + 1);
        x.row(i) /= middle[i];
    }
    Eigen::Vector2d sum = M_PI * (b.cwiseProduct(x)).colwise().sum().transpose();
    for (int i = 0; i + 1 < n; ++i)
        for (int end = i; end < i + 2; ++end)
            for (int k = 0; k < 2; ++k)
                sum[k] += M_PI * 0.5 * (line[i + 1].s - line[i].s) * line[end].x[0] * line[end].share / line[end].t *
                          (along(end, k) * along(end, k) + around(end, k) * around(end, k));
    drag.along = sum[0];
    drag.turning = sum[1];
    return drag;
}

template <int D>
Grid<D> box_of(int n, const Communicator& comm)
{
    std::array<SideKind, 2 * D> sides;
    sides.fill(SideKind::wall);
    return Grid<D>(Vec<D>::Zero(), 1.0, Index<D>::Constant(n), sides, 2, comm);
}

struct Worst {
    double normal = 0, along = 0, turning = 0;
    /// In percent, for the page of the validation.
    void record(double R, double gap) const
    {
        std::array<char, 80> name, text;
        std::snprintf(name.data(), name.size(), "%g cells, %g", R, gap);
        std::snprintf(text.data(), text.size(), "%.2f %.2f %.2f", 100 * normal, 100 * along, 100 * turning);
        ::testing::Test::RecordProperty(name.data(), text.data());
    }
    void add(double n, double a, double t)
    {
        normal = std::max(normal, std::abs(n - 1));
        along = std::max(along, std::abs(a - 1));
        turning = std::max(turning, std::abs(t - 1));
    }
};

Worst cylinder(bool container, double R, double gap)
{
    const Communicator comm;
    const double h = gap * R;
    const Eigen::Matrix3d exact = cylinder_drag(container ? -2 * R : 0, R, h);
    Worst worst;
    for (const double degrees : {0.0, 17.0, 45.0, 62.0})
        for (const Vec<2>& shift : {Vec<2>(0, 0), Vec<2>(0.3, 0.4), Vec<2>(0.71, 0.13)}) {
            const Grid<2> grid = box_of<2>(static_cast<int>(std::ceil(5.4 * R)), comm);
            const double a = degrees * M_PI / 180;
            const Vec<2> t(std::cos(a), std::sin(a)), n(-t[1], t[0]);
            Pose<2> body, outer;
            body.position = outer.position = Vec<2>::Constant(std::floor(2.7 * R)) + shift;
            std::unique_ptr<Shape<2>> ball = make_ball<2>(R), wall;
            if (container) {
                wall = make_inside_out(make_ball<2>(2 * R));
                body.position -= (R - h) * n;
            } else {
                wall = make_box<2>(Vec<2>(3 * R, 0.8 * R));
                body.position += 0.3 * R * n;
                outer.position = body.position - (1.4 * R + h) * n;
                outer.rotation = Rotation<2>(a);
            }
            std::vector<Solid<2>> solids;
            solids.push_back({"wall", PlacedShape<2>(*wall, outer), outer.position});
            solids.push_back({"body", PlacedShape<2>(*ball, body), body.position});
            const Complex<2> complex = build_complex<2>(grid, solids);
            const GapDrags<2> drags = find_gap_drag<2>(grid, solids, complex);
            check_form<2>(drags, solids);
            const Eigen::Matrix3d drag = drag_of_gaps<2>(complex, drags).bottomRightCorner<3, 3>();
            worst.add(n.dot(drag.topLeftCorner<2, 2>() * n) / exact(1, 1), t.dot(drag.topLeftCorner<2, 2>() * t) / exact(0, 0),
                      drag(2, 2) / exact(2, 2));
        }
    return worst;
}

TEST(GapDrag, CylinderOverAWall)
{
    for (const double R : {4.0, 8.0})
        for (const double gap : {0.03, 1e-2, 1e-3, 1e-4}) {
            const Worst worst = cylinder(false, R, gap);
            worst.record(R, gap);
            if (gap > 1e-3)
                continue; // oblique gaps have open faces that are no arms
            EXPECT_LT(worst.normal, 0.01) << R << ' ' << gap;
            EXPECT_LT(worst.along, 0.03) << R << ' ' << gap;
            EXPECT_LT(worst.turning, 0.02) << R << ' ' << gap;
        }
}

TEST(GapDrag, ARollingWheelThatIsNearerThanItsRoughness)
{
    // As far apart as the roughness: by Reynolds' equation it has the pressures of one that slides.
    const Communicator comm;
    const double R = 9.6, roughness = 2.4e-3;
    const Eigen::Matrix3d exact = cylinder_drag(0, R, roughness);
    const Grid<2> grid = box_of<2>(52, comm);
    for (const double gap : {1e-5, 1e-2, 0.3}) {
        const double h = gap * roughness;
        Pose<2> body, outer;
        body.position = Vec<2>(26.3, 28.4);
        outer.position = body.position - Vec<2>(0, 1.4 * R + h);
        const auto wheel = make_ball<2>(R), wall = make_box<2>(Vec<2>(3 * R, 0.8 * R));
        std::vector<Solid<2>> solids;
        solids.push_back({"wall", PlacedShape<2>(*wall, outer), outer.position});
        solids.push_back({"wheel", PlacedShape<2>(*wheel, body), body.position});
        const Complex<2> complex = build_complex<2>(grid, solids);
        Standoffs<2> standoffs;
        standoffs.add(0, 1, {roughness - h});
        const Eigen::Matrix3d drag =
            drag_of_gaps<2>(complex, find_gap_drag<2>(grid, solids, complex, standoffs)).bottomRightCorner<3, 3>();
        EXPECT_NEAR(drag(0, 0) / exact(0, 0), 1, 0.02) << gap;
        EXPECT_NEAR(drag(1, 1) / exact(1, 1), 1, 0.02) << gap;
        EXPECT_NEAR(drag(2, 2) / exact(2, 2), 1, 0.02) << gap;
    }
}

TEST(GapDrag, CylinderInAContainer)
{
    for (const double R : {4.0, 8.0})
        for (const double gap : {1e-2, 1e-3, 1e-4}) {
            const Worst worst = cylinder(true, R, gap);
            worst.record(R, gap);
            EXPECT_LT(worst.normal, 0.02) << R << ' ' << gap;
            EXPECT_LT(worst.along, gap > 1e-3 ? 0.05 : 0.02) << R << ' ' << gap;
            EXPECT_LT(worst.turning, gap > 1e-3 ? 0.04 : 0.02) << R << ' ' << gap;
        }
}

TEST(GapDrag, Bearing)
{
    const Communicator comm;
    std::ifstream file(GAPFLOW_TEST_DATA "/reference/V4_wannier_summary.csv");
    std::string line;
    std::getline(file, line);
    std::vector<std::array<double, 3>> cases{{0, -4 * M_PI * 0.99 / (1 - 0.99 * 0.99), 0}}; // eccentricity, torque, load
    while (std::getline(file, line)) {
        std::istringstream words(line);
        std::vector<double> value;
        for (std::string word; std::getline(words, word, ',');)
            value.push_back(std::stod(word));
        if (value[0] == 0.99)
            cases.push_back({value[1], value[3], value[5]});
    }
    ASSERT_EQ(cases.size(), 5u);
    const int n = 64;
    const double size = n / 2.2; // cells a unit
    double torques = 0, loads = 0;
    for (const auto& [eccentricity, torque, load] : cases)
        for (const double degrees : {0.0, 17.0, 45.0})
            for (const Vec<2>& shift : {Vec<2>(0, 0), Vec<2>(0.3, 0.4)}) {
                const Grid<2> grid = box_of<2>(n, comm);
                const double a = degrees * M_PI / 180;
                const Vec<2> towards(std::cos(a), std::sin(a)), across(-towards[1], towards[0]);
                const auto inner = make_ball<2>(0.99 * size), outer = make_inside_out(make_ball<2>(size));
                Pose<2> in, out;
                out.position = Vec<2>::Constant(n / 2) + shift;
                in.position = out.position + eccentricity * 0.01 * size * towards;
                std::vector<Solid<2>> solids;
                solids.push_back({"outer", PlacedShape<2>(*outer, out), out.position});
                solids.push_back({"inner", PlacedShape<2>(*inner, in), in.position});
                const Complex<2> complex = build_complex<2>(grid, solids);
                const Eigen::Matrix3d drag =
                    drag_of_gaps<2>(complex, find_gap_drag<2>(grid, solids, complex)).bottomRightCorner<3, 3>() / 0.99;
                EXPECT_NEAR(drag(2, 2) / (size * size), -torque, 0.005 * std::abs(torque)) << eccentricity;
                const double force = std::abs(drag.block<2, 1>(0, 2).dot(across)) / size;
                EXPECT_NEAR(force, std::abs(load), 0.005 * std::abs(load) + 1e-6 * std::abs(torque)) << eccentricity;
                torques = std::max(torques, std::abs(-drag(2, 2) / (size * size * torque) - 1));
                if (load != 0)
                    loads = std::max(loads, std::abs(force / std::abs(load) - 1));
            }
    RecordProperty("torque", std::to_string(100 * torques));
    RecordProperty("load", std::to_string(100 * loads));
}

Worst ball(bool two, double R, double gap)
{
    const Communicator comm;
    const double h = gap * R;
    const BallDrag exact = ball_drag(two ? R : 0, R, h);
    Worst worst;
    for (const Vec<3>& towards : {Vec<3>(0, 0, 1), Vec<3>(0.3, 0, 1), Vec<3>(1, 0, 1), Vec<3>(1, 1, 1)}) {
        const Vec<3> n = towards.normalized();
        const Grid<3> grid = box_of<3>(static_cast<int>(std::ceil(4.6 * R)), comm);
        const Vec<3> middle = Vec<3>::Constant(std::floor(2.3 * R)) + Vec<3>(0.31, 0.17, 0.23) - (two ? 0.0 : 0.6 * R) * n;
        Pose<3> body, other;
        body.position = middle + (R + 0.5 * h) * n;
        std::unique_ptr<Shape<3>> shape = make_ball<3>(R), wall;
        if (two) {
            wall = make_ball<3>(R);
            other.position = middle - (R + 0.5 * h) * n;
        } else {
            wall = make_box<3>(Vec<3>(2.6 * R, 2.6 * R, 0.6 * R));
            other.position = middle - (0.3 * R + 0.5 * h) * n;
            other.rotation = Eigen::Quaterniond::FromTwoVectors(Vec<3>(0, 0, 1), n);
        }
        std::vector<Solid<3>> solids;
        solids.push_back({"wall", PlacedShape<3>(*wall, other), other.position});
        solids.push_back({"body", PlacedShape<3>(*shape, body), body.position});
        const Complex<3> complex = build_complex<3>(grid, solids);
        const GapDrags<3> drags = find_gap_drag<3>(grid, solids, complex);
        EXPECT_EQ(drags.peaks.size(), 1u);
        check_form<3>(drags, solids);
        const auto drag = drag_of_gaps<3>(complex, drags).template bottomRightCorner<6, 6>().eval();
        const auto mean_along = [&](int k) {
            const auto block = drag.block<3, 3>(k, k);
            return 0.5 * (block.trace() - n.dot(block * n));
        };
        worst.add(n.dot(drag.topLeftCorner<3, 3>() * n) / exact.normal, mean_along(0) / exact.along,
                  mean_along(3) / exact.turning);
    }
    return worst;
}

TEST(GapDrag, BallOverAWall)
{
    for (const double gap : {0.03, 1e-2, 1e-3, 1e-4}) {
        const Worst worst = ball(false, 4, gap);
        worst.record(4, gap);
        if (gap > 1e-2)
            continue; // as above
        EXPECT_LT(worst.normal, 0.02) << gap;
        EXPECT_LT(worst.along, 0.04) << gap;
        EXPECT_LT(worst.turning, 0.03) << gap;
    }
}

TEST(GapDrag, TwoBalls)
{
    for (const double gap : {0.03, 1e-2, 1e-3, 1e-4}) {
        const Worst worst = ball(true, 4, gap);
        worst.record(4, gap);
        if (gap > 1e-3)
            continue; // as above
        EXPECT_LT(worst.normal, 0.01) << gap;
        EXPECT_LT(worst.along, gap > 5e-4 ? 0.07 : 0.05) << gap;
        EXPECT_LT(worst.turning, 0.04) << gap;
    }
}

/// A line of contact, between the ends of a cylinder.
TEST(GapDrag, SideOfACylinder)
{
    const Communicator comm;
    const double R = 4, length = 8, h = 1e-4 * R;
    const Eigen::Matrix3d exact = length * cylinder_drag(0, R, h);
    for (const auto& [up, along] :
         {std::pair(Vec<3>(0, 0, 1), Vec<3>(1, 0.6, 0)), std::pair(Vec<3>(0.3, 0, 1), Vec<3>(0, 1, 0)),
          std::pair(Vec<3>(0.8, 0.3, 1), Vec<3>(0.3, 1, 0.2))}) {
        const Vec<3> n = up.normalized(), axis = (along - n.dot(along) * n).normalized(), across = axis.cross(n);
        const Grid<3> grid = box_of<3>(24, comm);
        const Vec<3> middle = Vec<3>::Constant(12) + Vec<3>(0.31, 0.17, 0.23) - 0.6 * R * n;
        const auto shape = make_cylinder(R, length);
        const auto wall = make_box<3>(Vec<3>(2.6 * R, 2.6 * R, 0.6 * R));
        Pose<3> body, floor;
        body.position = middle + (R + 0.5 * h) * n;
        body.rotation = Eigen::Quaterniond::FromTwoVectors(Vec<3>(1, 0, 0), axis);
        floor.position = middle - (0.3 * R + 0.5 * h) * n;
        Mat<3> turned;
        turned << across, n.cross(across), n;
        floor.rotation = Eigen::Quaterniond(turned);
        std::vector<Solid<3>> solids;
        solids.push_back({"wall", PlacedShape<3>(*wall, floor), floor.position});
        solids.push_back({"body", PlacedShape<3>(*shape, body), body.position});
        const Complex<3> complex = build_complex<3>(grid, solids);
        const GapDrags<3> drags = find_gap_drag<3>(grid, solids, complex);
        ASSERT_EQ(drags.peaks.size(), 1u);
        check_form<3>({drags.faces, {}, {}}, solids);
        const Eigen::Matrix3d drag = drag_of_gaps<3>(complex, drags).block<3, 3>(6, 6);
        EXPECT_NEAR(n.dot(drag * n) / exact(1, 1), 1, 0.02);
        EXPECT_NEAR(across.dot(drag * across) / exact(0, 0), 1, 0.03);
    }
}

} // namespace
} // namespace gapflow
