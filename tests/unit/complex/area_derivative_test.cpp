// Derivatives of open areas and first moments against central differences and identities.
#include "../grid/scenes.hpp"
#include "mean_rates.hpp"

#include "gapflow/complex/area_derivative.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <map>
#include <numbers>

namespace gapflow::testing {
namespace {

template <int D>
struct WithDerivatives {
    FaceDerivatives<D> derivatives;
    Complex<D> complex;

    WithDerivatives(const Grid<D>& grid, const std::vector<Solid<D>>& solids)
        : complex(build_complex<D>(grid, solids, &derivatives, nullptr, false))
    {
    }
};

template <int D>
Vec<D> centre_in_cells(const Grid<D>& grid, const Complex<D>& complex, const FacePiece<D>& piece)
{
    return (grid.face_centre(piece.axis, complex.index.index(piece.face)) - grid.anchor()) / grid.dx();
}

/// Largest errors of all pieces' derivatives, over the largest derivative by the same component.
struct Errors {
    double area = 0, moment = 0;
    bool jump = false; ///< pieces come or go between the two poses
};

template <int D>
Errors compare(const Grid<D>& grid, const std::vector<Solid<D>>& solids, int moving, int component, double step)
{
    const WithDerivatives<D> here(grid, solids);
    std::array<std::vector<Solid<D>>, 2> sides{solids, solids};
    std::array<std::multimap<std::pair<int, int>, FacePiece<D>>, 2> pieces;
    for (int s = 0; s < 2; ++s) {
        sides[s][moving] = moved(solids[moving], component, s ? step : -step, grid.dx());
        const Complex<D> complex = build_complex<D>(grid, sides[s], nullptr, nullptr, false);
        for (const FacePiece<D>& piece : complex.pieces)
            pieces[s].insert({{piece.axis, piece.face}, piece});
    }
    Errors errors;
    double largest_area = 1e-3, largest_moment = 1e-3;
    errors.jump = pieces[0].size() != pieces[1].size() || pieces[0].size() != here.complex.pieces.size();
    for (std::size_t k = 0; k < here.complex.pieces.size() && !errors.jump; ++k) {
        const FacePiece<D>& piece = here.complex.pieces[k];
        std::array<const FacePiece<D>*, 2> other{};
        for (int s = 0; s < 2; ++s) {
            const auto [first, last] = pieces[s].equal_range({piece.axis, piece.face});
            for (auto it = first; it != last; ++it)
                if (!other[s] || (it->second.centroid - piece.centroid).norm() + std::abs(it->second.area - piece.area) <
                                     (other[s]->centroid - piece.centroid).norm() + std::abs(other[s]->area - piece.area))
                    other[s] = &it->second;
            errors.jump = errors.jump || !other[s];
        }
        if (errors.jump)
            break;
        double area = 0;
        Vec<D> moment = Vec<D>::Zero();
        for (const PieceRate<D>& rate : here.derivatives.of(k))
            if (rate.solid == moving) {
                area += rate.area[component];
                moment += rate.moment.col(component);
            }
        const Vec<D> centre = centre_in_cells(grid, here.complex, piece);
        const double area_by_step = (other[1]->area - other[0]->area) / (2 * step);
        const Vec<D> moment_by_step =
            (other[1]->area * (other[1]->centroid - centre) - other[0]->area * (other[0]->centroid - centre)) / (2 * step);
        errors.area = std::max(errors.area, std::abs(area - area_by_step));
        errors.moment = std::max(errors.moment, (moment - moment_by_step).template lpNorm<Eigen::Infinity>());
        largest_area = std::max(largest_area, std::abs(area));
        largest_moment = std::max(largest_moment, moment.template lpNorm<Eigen::Infinity>());
    }
    errors.area /= largest_area;
    errors.moment /= largest_moment;
    return errors;
}

template <int D>
using Make = std::function<void(Scene<D>&, std::mt19937&)>;

template <int D>
Pose<D> random_pose(std::mt19937& random, bool aligned = false)
{
    std::uniform_real_distribution<double> number(0, 1);
    Pose<D> at;
    for (int axis = 0; axis < D; ++axis)
        at.position[axis] = 0.4 + 0.2 * number(random);
    if constexpr (D == 2)
        at.rotation =
            Rotation<2>(aligned ? std::numbers::pi / 2 * static_cast<int>(4 * number(random)) : 6.28 * number(random));
    else if (aligned)
        at.rotation = Rotation<3>(Eigen::AngleAxisd(std::numbers::pi / 2 * static_cast<int>(4 * number(random)),
                                                    unit<3>(static_cast<int>(3 * number(random)))));
    else
        at.rotation =
            Rotation<3>(Eigen::Vector4d(number(random) - 0.5, number(random) - 0.5, number(random) - 0.5, number(random) - 0.5)
                            .normalized());
    return at;
}

struct Count {
    int good = 0, all = 0;
    std::string rest; ///< the others: jumps, and where a grazing edge or a tip makes the difference itself inexact

    Count& operator+=(const Count& other)
    {
        good += other.good;
        all += other.all;
        rest += other.rest;
        return *this;
    }
};

/// All solids, all components, `poses` random poses; good: within 1e-5 of the largest.
template <int D>
Count check(const std::string& name, int poses, const Make<D>& make, SideKind sides = SideKind::wall, double shift = 0)
{
    const Grid<D> grid = unit_grid<D>(D == 3 ? 8 : 16, all_sides<D>(sides));
    int good = 0, jumps = 0, all = 0;
    double worst_area = 0, worst_moment = 0;
    std::string rest;
    for (int seed = 0; seed < poses; ++seed) {
        std::mt19937 random(1000 + seed);
        std::uniform_real_distribution<double> number(-1, 1);
        Scene<D> scene(grid);
        const std::size_t walls = scene.solids.size();
        make(scene, random);
        for (std::size_t k = walls; k < scene.solids.size(); ++k) {
            scene.solids[k].shape = scene.solids[k].shape.shifted(Vec<D>::Constant(shift));
            scene.solids[k].centre += Vec<D>::Constant(shift);
            if (seed % 2) // reference points beside the centres
                for (int axis = 0; axis < D; ++axis)
                    scene.solids[k].centre[axis] += 0.2 * number(random);
            if (has_mean_rates(grid, scene.solids[k]))
                continue;
            for (int c = 0; c < twist_size<D>; ++c) {
                // Places are rounded to 2^-36 of a cell: a translation's step is a multiple of it, a rotation's is larger.
                const double step = c < D ? 0x1p-20 : 0x1p-16;
                const Errors errors = compare<D>(grid, scene.solids, static_cast<int>(k), c, step);
                ++all;
                if (!errors.jump && errors.area < 1e-5 && errors.moment < 1e-5) {
                    ++good;
                    worst_area = std::max(worst_area, errors.area);
                    worst_moment = std::max(worst_moment, errors.moment);
                } else {
                    jumps += errors.jump;
                    rest += " " + std::to_string(seed) + ":" + std::to_string(k - walls) + "/" + std::to_string(c) +
                            (errors.jump ? " jump" : " " + std::to_string(errors.area) + " " + std::to_string(errors.moment));
                }
            }
        }
    }
    std::printf("%-28s %4d of %4d, %d jumps; worst of the others %.1e %.1e\n", name.c_str(), good, all, jumps, worst_area,
                worst_moment);
    return {good, all, rest.empty() ? "" : "\n" + name + ":" + rest};
}

void expect_almost_all(const Count& count)
{
    if (!count.rest.empty())
        std::printf("all others:%s\n", count.rest.c_str());
    EXPECT_GE(count.good, 0.96 * count.all)
        << count.rest; // the rest: where a line from a sharp corner begins or ends to divide a face
}

template <int D>
Vec<D> box_size(std::mt19937& random)
{
    std::uniform_real_distribution<double> number(0.1, 0.6);
    Vec<D> size;
    for (int axis = 0; axis < D; ++axis)
        size[axis] = number(random);
    return size;
}

template <int D>
std::unique_ptr<Shape<D>> faceted(const Shape<D>& shape, double tolerance)
{
    return make_mesh<D>(shape.display_mesh(tolerance), "facets");
}

template <int D>
std::vector<std::pair<std::string, Make<D>>> kinds()
{
    using R = std::mt19937;
    const auto one = [](auto shape, bool aligned = false) -> Make<D> {
        return [=](Scene<D>& scene, R& random) {
            auto made = shape(random);
            scene.add("solid", std::move(made), random_pose<D>(random, aligned));
        };
    };
    const auto number = [](R& random, double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto ball = [=](R& random) { return make_ball<D>(number(random, 0.05, 0.35)); };
    const auto box = [](R& random) { return make_box<D>(box_size<D>(random)); };
    const auto plate = [](R& random) {
        Vec<D> size = box_size<D>(random);
        size[0] *= 0.02;
        return make_box<D>(size);
    };
    const auto half_space = [](R&) { return make_half_space<D>(unit<D>(0)); };
    const auto capsule = [=](R& random) { return make_capsule<D>(number(random, 0.03, 0.2), number(random, 0.05, 0.5)); };
    std::vector<std::pair<std::string, Make<D>>> list{
        {"ball", one(ball)},
        {"box", one(box)},
        {"plate", one(plate)},
        {"half-space", one(half_space)},
        {"capsule", one(capsule)},
        {"box aligned", one(box, true)},
        {"capsule aligned", one(capsule, true)},
        {"outside of a ball", one([=](R& random) { return make_inside_out<D>(make_ball<D>(number(random, 0.2, 0.35))); })},
        {"outside of a box", one([](R& random) { return make_inside_out<D>(make_box<D>(box_size<D>(random))); })},
        {"outside of a capsule", one([=](R& random) {
             return make_inside_out<D>(make_capsule<D>(number(random, 0.05, 0.2), number(random, 0.1, 0.3)));
         })},
        {"two balls, overlapping",
         [=](Scene<D>& scene, R& random) {
             Pose<D> at = random_pose<D>(random);
             scene.add("a", make_ball<D>(0.2), at);
             at.position += 0.3 * (at.rotation * unit<D>(0));
             scene.add("b", make_ball<D>(0.15), at);
         }},
        {"two balls, gap of 0.01 cells",
         [=](Scene<D>& scene, R& random) {
             Pose<D> at = random_pose<D>(random);
             scene.add("a", make_ball<D>(0.2), at);
             at.position += 0.351 * (at.rotation * unit<D>(0));
             scene.add("b", make_ball<D>(0.15), at);
         }},
        {"box and capsule",
         [=](Scene<D>& scene, R& random) {
             scene.add("a", make_box<D>(box_size<D>(random)), random_pose<D>(random));
             scene.add("b", capsule(random), random_pose<D>(random));
         }},
        {"faceted ball", one([=](R& random) { return faceted<D>(*make_ball<D>(number(random, 0.1, 0.35)), 0.01); })},
        {"faceted box", one([](R& random) { return faceted<D>(*make_box<D>(box_size<D>(random)), 0.1); })},
        {"outside of a faceted ball",
         one([=](R& random) { return make_inside_out<D>(faceted<D>(*make_ball<D>(number(random, 0.1, 0.35)), 0.01)); })},
        {"faceted ball and box",
         [=](Scene<D>& scene, R& random) {
             scene.add("a", faceted<D>(*make_ball<D>(number(random, 0.1, 0.25)), 0.01), random_pose<D>(random));
             scene.add("b", make_box<D>(box_size<D>(random)), random_pose<D>(random));
         }},
        {"two boxes",
         [=](Scene<D>& scene, R& random) {
             scene.add("a", make_box<D>(box_size<D>(random)), random_pose<D>(random));
             scene.add("b", make_box<D>(box_size<D>(random)), random_pose<D>(random));
         }},
    };
    if constexpr (D == 3) {
        const auto cylinder = [=](R& random) { return make_cylinder(number(random, 0.03, 0.3), number(random, 0.03, 0.6)); };
        list.push_back({"cylinder", one(cylinder)});
        list.push_back({"cylinder aligned", one(cylinder, true)});
        list.push_back({"outside of a cylinder", one([=](R& random) { return make_inside_out<3>(cylinder(random)); })});
        list.push_back({"cylinder and half-space", [=](Scene<D>& scene, R& random) {
                            scene.add("a", cylinder(random), random_pose<D>(random));
                            scene.add("b", make_half_space<D>(unit<D>(2)), random_pose<D>(random));
                        }});
    }
    return list;
}

TEST(AreaDerivative, IsThatOfDifferences2D)
{
    Count count;
    for (const auto& [name, make] : kinds<2>())
        count += check<2>(name, 40, make);
    expect_almost_all(count);
}

TEST(AreaDerivative, IsThatOfDifferences3D)
{
    Count count;
    for (const auto& [name, make] : kinds<3>())
        count += check<3>(name, 8, make);
    expect_almost_all(count);
}

TEST(AreaDerivative, ImagesOfASolidCountAsOne)
{
    expect_almost_all(check<2>("periodic", 50, kinds<2>()[0].second, SideKind::periodic, 0.4));
    expect_almost_all(check<3>("periodic", 20, kinds<3>()[0].second, SideKind::periodic, 0.4));
}

/// The motion (spatial, about a fixed point) that is left of going i, j, and back.
template <int D>
Twist<D> bracket(int i, int j)
{
    Twist<D> result = Twist<D>::Zero();
    const auto spin = [](int k) { return Spin<D>(Spin<D>::Unit(k - D)); };
    if (i >= D && j < D)
        result.template head<D>() = spin_velocity<D>(spin(i), unit<D>(j));
    else if (i < D && j >= D)
        result.template head<D>() = -spin_velocity<D>(spin(j), unit<D>(i));
    else if (i >= D && j >= D)
        if constexpr (D == 3)
            result.template tail<3>() = spin(i).cross(spin(j));
    return result;
}

/// A part's wall flux K by the twist of a solid (that meets no other one there) is the derivative of the part's volume, so X_i K_j - X_j K_i = K [j, i] for the motions X.
/// By closure K = - sum over the part's faces of (o A e_d, int (x - reference) x o e_d): what is differentiated here is all by A and m.
/// Returns the worst error over the largest derivative.
template <int D>
double asymmetry(const Grid<D>& grid, const std::vector<Solid<D>>& solids, int solid, bool apart)
{
    const WithDerivatives<D> here(grid, solids);
    const Complex<D>& complex = here.complex;
    constexpr int n = twist_size<D>;
    using Matrix = Eigen::Matrix<double, n, n>;
    std::vector<Matrix> change(complex.parts(), Matrix::Zero()); // [motion][component of K]
    const Vec<D> reference = (solids[solid].centre - grid.anchor()) / grid.dx();
    for (std::size_t k = 0; k < complex.pieces.size(); ++k) {
        const FacePiece<D>& piece = complex.pieces[k];
        const Vec<D> arm = centre_in_cells(grid, complex, piece) - reference, e = unit<D>(piece.axis);
        for (const PieceRate<D>& rate : here.derivatives.of(k))
            for (int i = 0; i < n && rate.solid == solid; ++i) {
                Twist<D> flux;
                flux << rate.area[i] * e, moment<D>(Vec<D>(rate.moment.col(i) + rate.area[i] * arm), e);
                if (piece.low.is_part())
                    change[piece.low.number()].row(i) -= flux.transpose();
                if (piece.high.is_part())
                    change[piece.high.number()].row(i) += flux.transpose();
            }
    }
    std::vector<char> divided(complex.index.count, 0); // by a line from a sharp corner, or beside such a cell
    for (const CornerLink<D>& link : complex.links) {
        const Index<D> c = complex.cell_of_part(link.a);
        for_each_index<D>(c - Index<D>::Ones(), c + Index<D>::Constant(2), [&](const Index<D>& near) {
            if (grid.in_domain(near))
                divided[complex.index(near)] = 1;
        });
    }
    const auto has_rims = [](const Solid<D>& s) { // the chords of a rim's cone do not move as the solid does
        const auto bar = s.shape.shape().round_bar();
        return bar && bar->flat;
    };
    const bool pair = std::count_if(solids.begin(), solids.end(), [](const Solid<D>& s) { return !s.wall; }) > 1 ||
                      std::any_of(solids.begin(), solids.end(), has_rims);
    double worst = 0;
    for (int p = 0; p < complex.parts(); ++p) {
        if (pair && divided[complex.cut_cell[complex.part_cell[p]]]) // the line may end on the other solid, and slide along it
            continue;
        Twist<D> flux = Twist<D>::Zero();
        int others = 0;
        for (const WallPatch<D>& patch : complex.patches_of(p))
            if (patch.solid == solid)
                flux << patch.area, patch.moment;
        const int cell = complex.part_cell[p]; // a line from a sharp corner to another solid slides along that one
        for (int q = complex.first_part[cell]; q < complex.first_part[cell + 1]; ++q)
            for (const WallPatch<D>& patch : complex.patches_of(q))
                others += patch.solid != solid;
        if (flux.isZero(0) || (others > 0 && !apart))
            continue;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double error = std::abs(change[p](i, j) - change[p](j, i) - flux.dot(bracket<D>(j, i)));
                EXPECT_TRUE(std::isfinite(error));
                worst = std::max(worst, error / std::max(1.0, change[p].cwiseAbs().maxCoeff()));
            }
    }
    return worst;
}

template <int D>
void check_symmetry(int poses)
{
    const Grid<D> grid = unit_grid<D>(D == 3 ? 8 : 16);
    for (const auto& [name, make] : kinds<D>()) {
        double worst = 0;
        for (int seed = 0; seed < poses; ++seed) {
            std::mt19937 random(seed);
            Scene<D> scene(grid);
            const std::size_t first = scene.solids.size();
            make(scene, random);
            for (std::size_t k = first; k < scene.solids.size(); ++k) {
                scene.solids[k].centre = Vec<D>::Constant(0.375); // places are rounded: this one is not
                if (!has_mean_rates(grid, scene.solids[k]))
                    worst =
                        std::max(worst, asymmetry<D>(grid, scene.solids, static_cast<int>(k), name.find("gap") != name.npos));
            }
        }
        std::printf("%-28s %.1e\n", name.c_str(), worst);
        EXPECT_LE(worst, 1e-11) << name;
    }
}

TEST(AreaDerivative, FluxesAreDerivativesOfOneVolume2D)
{
    check_symmetry<2>(100);
}

TEST(AreaDerivative, FluxesAreDerivativesOfOneVolume3D)
{
    check_symmetry<3>(20);
}

TEST(AreaDerivative, PartsGrowAsTheirWallsMove2D)
{
    const Grid<2> grid = unit_grid<2>(16);
    double worst = 0;
    int compared = 0;
    for (int seed = 0; seed < 30; ++seed)
        for (const auto& [name, make] : kinds<2>()) {
            std::mt19937 random(seed);
            Scene<2> scene(grid);
            const std::size_t walls = scene.solids.size();
            make(scene, random);
            const Complex<2> here = build_complex<2>(grid, scene.solids, nullptr, nullptr, false);
            for (int c = 0; c < 3; ++c) {
                const double step = c < 2 ? 0x1p-20 : 0x1p-18;
                const auto at = [&](double s) {
                    std::vector<Solid<2>> solids = scene.solids;
                    solids[walls] = moved(solids[walls], c, s, grid.dx());
                    return build_complex<2>(grid, solids, nullptr, nullptr, false);
                };
                const Complex<2> low = at(-step), high = at(step);
                if (low.cut_cell != here.cut_cell || high.cut_cell != here.cut_cell || low.first_part != here.first_part ||
                    high.first_part != here.first_part)
                    continue;
                for (int p = 0; p < here.parts(); ++p) {
                    Twist<2> flux = Twist<2>::Zero();
                    for (const WallPatch<2>& patch : here.patches_of(p))
                        if (patch.solid == static_cast<int>(walls)) {
                            flux.head<2>() += patch.area;
                            flux[2] += patch.moment[0];
                        }
                    const double error = std::abs((high.part_area[p] - low.part_area[p]) / (2 * step) - flux[c]);
                    worst = std::max(worst, error);
                    ++compared;
                }
            }
        }
    std::printf("%d parts, worst %.1e\n", compared, worst);
    EXPECT_GT(compared, 30000);
    EXPECT_LE(worst, 1e-4);
}

TEST(AreaDerivative, OfABall)
{
    const Grid<3> grid = unit_grid<3>(8);
    Scene<3> scene(grid);
    const double radius = 2.6;
    const int ball = scene.add("ball", make_ball<3>(radius / 8), pose<3>(Vec<3>(525, 499, 545) / 1024));
    const WithDerivatives<3> here(grid, scene.solids);
    const Vec<3> centre = 8 * scene.solids[ball].centre;
    struct Sum {
        Twist<3> area = Twist<3>::Zero();
        Eigen::Matrix<double, 3, 6> moment = Eigen::Matrix<double, 3, 6>::Zero();
    };
    std::map<std::pair<int, int>, Sum> planes;
    for (std::size_t k = 0; k < here.complex.pieces.size(); ++k) {
        const FacePiece<3>& piece = here.complex.pieces[k];
        const Vec<3> face_centre = centre_in_cells(grid, here.complex, piece);
        for (const PieceRate<3>& rate : here.derivatives.of(k)) {
            EXPECT_EQ(rate.solid, ball);
            EXPECT_LE((rate.area.tail<3>().lpNorm<Eigen::Infinity>()), 1e-13); // its spin moves nothing
            EXPECT_LE((rate.moment.rightCols<3>().lpNorm<Eigen::Infinity>()), 1e-13);
            Sum& sum = planes[{piece.axis, here.complex.index.index(piece.face)[piece.axis]}];
            sum.area += rate.area;
            sum.moment += rate.moment + face_centre * rate.area.transpose();
        }
    }
    EXPECT_EQ(planes.size(), 15U);
    for (const auto& [plane, sum] : planes) { // pi (R^2 - H^2) is covered, its moment moves with it
        const auto [d, at] = plane;
        const double h = at - centre[d], section = std::numbers::pi * (radius * radius - h * h);
        Twist<3> area = Twist<3>::Zero();
        area[d] = -2 * std::numbers::pi * h;
        EXPECT_LE((sum.area - area).norm(), 1e-11);
        Mat<3> moment = -section * Mat<3>::Identity();
        moment.row(d).setZero();
        moment.col(d) = area[d] * centre;
        EXPECT_LE((sum.moment.leftCols<3>() - moment).topRows(3).row((d + 1) % 3).norm(), 1e-10);
        EXPECT_LE((sum.moment.leftCols<3>() - moment).row((d + 2) % 3).norm(), 1e-10);
    }
}

/// Almost along the grid the sides of cylinders are ellipses of any length, along it they are straight.
TEST(AreaDerivative, OfCylindersAlmostAlongTheGrid)
{
    const Grid<3> grid = unit_grid<3>(8);
    for (const bool flat : {false, true}) {
        const auto at = [&](double angle) {
            Scene<3> scene(grid);
            Pose<3> pose;
            pose.position = Vec<3>(0.5123, 0.4871, 0.5312);
            pose.rotation = Rotation<3>(Eigen::AngleAxisd(angle, Vec<3>(0, 0.6, 0.8)));
            scene.add("bar", flat ? make_cylinder(0.23, 0.55) : make_capsule<3>(0.23, 0.3), pose);
            return WithDerivatives<3>(grid, scene.solids);
        };
        // Of whole faces: the line of a rim divides some of them at an angle only, and some that nothing else cuts.
        const auto of_faces = [](const WithDerivatives<3>& made) {
            std::map<std::pair<int, int>, PieceRate<3>> sums;
            for (std::size_t p = 0; p < made.complex.pieces.size(); ++p)
                for (const PieceRate<3>& rate : made.derivatives.of(p)) {
                    PieceRate<3>& sum = sums[{made.complex.pieces[p].axis, made.complex.pieces[p].face}];
                    sum.area += rate.area;
                    sum.moment += rate.moment;
                }
            return sums;
        };
        const auto straight = of_faces(at(0));
        for (int k = 2; k <= 12; ++k) {
            const double angle = std::pow(10, -k);
            const auto turned = of_faces(at(angle));
            ASSERT_GE(turned.size(), straight.size());
            double worst = 0;
            for (const auto& [face, a] : turned) {
                const auto found = straight.find(face);
                const PieceRate<3> b = found == straight.end() ? PieceRate<3>{} : found->second; // a line's two sides
                worst = std::max({worst, (a.area - b.area).norm(), (a.moment - b.moment).norm()});
            }
            EXPECT_LE(worst, 100 * angle + 1e-7);
        }
    }
}

/// Facets in planes of the grid, corners on vertices, solids that overlap: nothing special comes out.
TEST(AreaDerivative, IsFiniteEverywhere)
{
    const Grid<3> grid = unit_grid<3>(8);
    for (int seed = 0; seed < 300; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> number(0, 1);
        Scene<3> scene(grid);
        const int count = 1 + static_cast<int>(3 * number(random));
        for (int k = 0; k < count; ++k) {
            Pose<3> at = random_pose<3>(random, true);
            at.position = (at.position * 16).array().round() / 16;
            std::unique_ptr<Shape<3>> shape;
            const double size = 0.0625 * (1 + static_cast<int>(4 * number(random)));
            switch (static_cast<int>(5 * number(random))) {
            case 0:
                shape = make_ball<3>(size);
                break;
            case 1:
                shape = make_box<3>(Vec<3>(size, 2 * size, 0.125));
                break;
            case 2:
                shape = make_capsule<3>(0.5 * size, 0.25);
                break;
            case 3:
                shape = faceted<3>(*make_box<3>(Vec<3>(2 * size, 0.125, size)), 0.1);
                break;
            default:
                shape = make_cylinder(0.5 * size, 0.25);
            }
            scene.add("s", std::move(shape), at);
        }
        const WithDerivatives<3> here(grid, scene.solids);
        for (const PieceRate<3>& rate : here.derivatives.rates) {
            ASSERT_TRUE(rate.area.allFinite() && rate.moment.allFinite()) << seed;
        }
    }
}

} // namespace
} // namespace gapflow::testing
