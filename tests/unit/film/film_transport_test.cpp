// Transport along flat films: exact where nothing changes along the film, of second order where it does, and never more energy.
#include "gap_of_plates.hpp"

namespace gapflow::test {
namespace {

/// Fluxes of a uniform velocity (master's axes) through all mouths.
template <int D>
std::vector<MouthFlow<D>> through_ends(const GapOfPlates<D>& gap, const Vec<D>& u)
{
    std::vector<MouthFlow<D>> flow;
    for (const Mouth<D>& mouth : gap.network.rim.mouths)
        flow.push_back(
            {mouth.length * mouth.h * mouth.outward.dot(gap.master().rotation() * u), u, gap.master().rotation() * u});
    return flow;
}

template <int D>
struct Steps {
    Carried<D> low, high;
};

template <int D>
Steps<D> transport(const GapOfPlates<D>& gap, const std::vector<FluidInPlace<D>>& start, const std::vector<Vec<D>>& flow,
                   const std::vector<MouthFlow<D>>& mouths, double dt)
{
    const FilmTransport<D> film(gap.network, 0, gap.master(), start, flow, mouths, dt);
    return {film.low(), film.high()};
}

/// Volume times velocity.
template <int D>
std::vector<Vec<D>> flow_of(const GapOfPlates<D>& gap, const std::vector<Vec<D>>& velocity)
{
    std::vector<Vec<D>> flow;
    for (std::size_t i = 0; i < velocity.size(); ++i)
        flow.push_back(gap.elements()[i].volume * velocity[i]);
    return flow;
}

/// Random velocities in a film, in the master's axes, whose fluxes meet all nodes' balances with no flux through the ends.
std::vector<Vec<3>> circulating(const GapOfPlates<3>& gap, std::mt19937& random)
{
    std::normal_distribution<double> normal;
    std::vector<double> stream;
    for (std::size_t i = 0; i < gap.film().mesh.x.size(); ++i)
        stream.push_back(normal(random));
    for (const RimEdge<3>& rim : gap.film().mesh.rim)
        for (int node : rim.nodes)
            stream[node] = 0;
    return gap.at_elements([&](const FilmElement<3>& e) {
        Vec<3> slope = Vec<3>::Zero();
        for (int k = 0; k < 3; ++k)
            slope += stream[e.nodes[k]] * e.gradient[k];
        return Vec<3>(gap.master().rotation().transpose() * e.normal.cross(slope));
    });
}

template <int D>
void uniform_stays()
{
    PlateSetup<D> setup;
    setup.pose.rotation = tilted<D>(0.6);
    GapOfPlates<D> gap(setup);
    gap.open_ends();
    Vec<D> u = 0.7 * unit<D>(0);
    if (D == 3)
        u[1] = 0.4;
    const std::vector<Vec<D>> uniform(gap.elements().size(), u);
    const std::vector<FluidInPlace<D>> start = gap.filled(uniform);
    for (double dt : {0.1, 1.0, 5.0}) {
        const auto [low, high] = transport(gap, start, flow_of(gap, uniform), through_ends(gap, u), dt);
        for (std::size_t i = 0; i < uniform.size(); ++i) {
            EXPECT_LT((low.velocity[i] - u).norm(), 1e-7) << i;
            EXPECT_LT((high.velocity[i] - u).norm(), 1e-7) << i;
        }
        // What leaves and enters: half the flux times the speed squared.
        double through = 0;
        for (const Mouth<D>& mouth : gap.network.rim.mouths)
            through += 0.25 * mouth.length * 0.2 * std::abs(mouth.outward.dot(gap.master().rotation() * u)) * u.squaredNorm();
        EXPECT_NEAR(low.out, dt * through, 1e-6 * dt);
        EXPECT_NEAR(low.in, dt * through, 1e-6 * dt);
        EXPECT_NEAR(high.out, dt * through, 1e-6 * dt);
        EXPECT_NEAR(high.in, dt * through, 1e-6 * dt);
    }
}

TEST(FilmTransport, UniformFlowStaysAsItIs2D)
{
    uniform_stays<2>();
}

TEST(FilmTransport, UniformFlowStaysAsItIs3D)
{
    uniform_stays<3>();
}

// Fluxes between elements, seen by what a pulse in one of them brings to those beside it in a short step: those of a uniform flow.
TEST(FilmTransport, UniformFlowCrossesEachFacetWithItsFlux3D)
{
    PlateSetup<3> setup;
    setup.largest = 1;
    GapOfPlates<3> gap(setup);
    gap.open_ends();
    const Vec<3> u(1, 0.4, 0);
    const std::vector<Vec<3>> uniform(gap.elements().size(), u);
    const double dt = 1e-6;
    const FilmMesh<3>& mesh = gap.film().mesh;
    int facets = 0;
    for (std::size_t a = 0; a < uniform.size(); ++a) {
        std::vector<Vec<3>> pulse(uniform.size(), Vec<3>::Zero());
        pulse[a] = unit<3>(0);
        std::vector<MouthFlow<3>> mouths = through_ends(gap, u);
        for (MouthFlow<3>& mouth : mouths)
            mouth.entering.setZero();
        const std::vector<Vec<3>> v = transport(gap, gap.filled(pulse), flow_of(gap, uniform), mouths, dt).low.velocity;
        for (std::size_t b = 0; b < uniform.size(); ++b) {
            std::vector<int> common;
            for (int node : mesh.elements[b].nodes)
                if (std::ranges::find(mesh.elements[a].nodes, node) != mesh.elements[a].nodes.end())
                    common.push_back(node);
            if (a == b || common.size() != 2)
                continue;
            const Vec<3> edge = mesh.x[common[1]] - mesh.x[common[0]];
            Vec<3> across = edge.cross(unit<3>(2));
            if (across.dot(mesh.elements[b].centroid - mesh.elements[a].centroid) < 0)
                across = -across;
            EXPECT_NEAR(v[b][0] * mesh.elements[b].volume / dt, setup.thickness * std::max(across.dot(u), 0.0), 1e-5)
                << a << ", " << b;
            ++facets;
        }
    }
    EXPECT_GT(facets, 50);
}

// A pulse in the middle of a uniform flow: none of its momentum is lost before it gets to the end.
TEST(FilmTransport, PulseKeepsItsMomentum2D)
{
    PlateSetup<2> setup;
    setup.largest = 0.1;
    GapOfPlates<2> gap(setup);
    gap.open_ends();
    const Vec<2> u(1, 0);
    const std::vector<Vec<2>> uniform(gap.elements().size(), u), pulse = gap.at_elements([](const FilmElement<2>&e) {
        const double x = e.centroid_master[0];
        return Vec<2>(std::abs(x) < 0.3 ? 3.0 : 1.0, 0);
    });
    const auto flow = transport(gap, gap.filled(pulse), flow_of(gap, uniform), through_ends<2>(gap, u), 0.2);
    const Vec<2> before = gap.over_volume(pulse, Vec<2>(0, 0));
    EXPECT_LT((gap.over_volume(flow.high.velocity, Vec<2>(0, 0)) - before).norm(), 1e-9);
    EXPECT_LT((gap.over_volume(flow.low.velocity, Vec<2>(0, 0)) - before).norm(), 1e-3); // implicit: some is at the end
    // And it has moved on by 0.2.
    double moment = 0, mass = 0, moment_before = 0;
    const std::vector<Vec<2>> after = flow.high.velocity;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const FilmElement<2>& e = gap.elements()[i];
        mass += e.volume * (pulse[i][0] - 1);
        moment_before += e.volume * e.centroid_master[0] * (pulse[i][0] - 1);
        moment += e.volume * e.centroid_master[0] * (after[i][0] - 1);
    }
    EXPECT_NEAR((moment - moment_before) / mass, 0.2, 0.01);
}

// Random velocities carried around by random fluxes that do not leave the film.
TEST(FilmTransport, ClosedFilmKeepsItsMomentum3D)
{
    std::mt19937 random(4);
    PlateSetup<3> setup;
    setup.pose.rotation = tilted<3>(0.6);
    const GapOfPlates<3> gap(setup);
    const Mat<3> to_master = gap.master().rotation().transpose();
    for (int trial = 0; trial < 5; ++trial) {
        std::vector<Vec<3>> u = gap.random_velocities(random);
        for (Vec<3>& v : u)
            v = to_master * v;
        std::vector<FluidInPlace<3>> start = gap.filled(u);
        for (FluidInPlace<3>& place : start)
            place.acceleration = {0.3, 2, 0}; // is taken out again
        const auto flow = transport<3>(gap, start, flow_of(gap, circulating(gap, random)), {}, 0.1);
        const Vec<3> before = gap.over_volume(u, Vec<3>(0, 0, 0));
        const double size = std::sqrt(2 * gap.energy(u) * volume(gap.film().mesh));
        EXPECT_LT((gap.over_volume(flow.high.velocity, Vec<3>(0, 0, 0)) - before).norm(), 1e-12 * size);
        EXPECT_LT((gap.over_volume(flow.low.velocity, Vec<3>(0, 0, 0)) - before).norm(), 1e-7 * size);
    }
}

// Centrifugal and Coriolis accelerations change velocities by dt times themselves; the pressure's is taken out again.
TEST(FilmTransport, AccelerationsOfFluidThatIsNotCarried)
{
    const GapOfPlates<2> gap({});
    const std::vector<Vec<2>> rest(gap.elements().size(), Vec<2>(0, 0));
    std::vector<FluidInPlace<2>> start = gap.filled(rest);
    for (FluidInPlace<2>& place : start) {
        place.acceleration = {3, 0};
        place.inertial = {0.5, 0};
    }
    const auto still = transport<2>(gap, start, rest, {}, 0.1);
    for (const Carried<2>& result : {still.low, still.high})
        for (const Vec<2>& v : result.velocity)
            EXPECT_LT((v - Vec<2>(0.05, 0)).norm(), 1e-12);
}

double order(double coarse, double fine)
{
    return std::log2(coarse / fine);
}

// Between ends without changes the velocity rises smoothly over a length of 2; a uniform flow carries it 0.8 on, half an element a step.
TEST(FilmTransport, SmoothProfileIsSecondOrder)
{
    const auto profile = [](double x) {
        const double s = std::clamp(0.5 * (x + 1.4), 0.0, 1.0);
        return 1 + s * s * s * (10 - 15 * s + 6 * s * s);
    };
    std::vector<double> low, high;
    for (double size : {0.125, 0.0625}) {
        PlateSetup<2> setup;
        setup.largest = size;
        GapOfPlates<2> gap(setup);
        gap.open_ends();
        const Vec<2> u(1, 0);
        const std::vector<Vec<2>> uniform(gap.elements().size(), u);
        std::vector<MouthFlow<2>> mouths = through_ends<2>(gap, u);
        std::vector<Vec<2>> of_low = gap.at_elements(
                                [&](const FilmElement<2>&e) { return Vec<2>(profile(e.centroid_master[0]), 0); }),
                            of_high = of_low;
        const int steps = static_cast<int>(std::lround(1.6 / size));
        for (int step = 0; step < steps; ++step) {
            of_low = transport(gap, gap.filled(of_low), flow_of(gap, uniform), mouths, 0.8 / steps).low.velocity;
            of_high = transport(gap, gap.filled(of_high), flow_of(gap, uniform), mouths, 0.8 / steps).high.velocity;
        }
        low.push_back(0);
        high.push_back(0);
        for (std::size_t i = 0; i < of_high.size(); ++i) {
            const FilmElement<2>& e = gap.elements()[i];
            const Vec<2> exact(profile(e.centroid_master[0] - 0.8), 0);
            low.back() += e.measure * (of_low[i] - exact).norm();
            high.back() += e.measure * (of_high[i] - exact).norm();
        }
    }
    RecordProperty("high", std::to_string(high[0]) + ", " + std::to_string(high[1]));
    EXPECT_GE(order(high[0], high[1]), 1.7) << high[0] << ", " << high[1];
    EXPECT_GE(order(low[0], low[1]), 0.7) << low[0] << ", " << low[1];
    EXPECT_LT(5 * high[1], low[1]);
}

// The same in 3D, along the mesh's lines and across them.
TEST(FilmTransport, SmoothProfileIsNearlySecondOrder3D)
{
    for (const auto& [u, least] :
         {std::pair{Vec<3>(1, 0, 0), 1.8}, std::pair{Vec<3>(0, 1, 0), 1.8}, std::pair{Vec<3>(1, 0.5, 0), 1.2}}) {
        const Vec<3> along = u.normalized();
        const auto profile = [&](const Vec<3>& x) {
            const double s = std::clamp(0.5 * (x.dot(along) + 1.4), 0.0, 1.0);
            return 1 + s * s * s * (10 - 15 * s + 6 * s * s);
        };
        std::vector<double> errors;
        for (double size : {0.25, 0.125}) {
            PlateSetup<3> setup;
            setup.largest = size;
            GapOfPlates<3> gap(setup);
            gap.open_ends();
            const std::vector<Vec<3>> uniform(gap.elements().size(), u);
            std::vector<MouthFlow<3>> mouths = through_ends<3>(gap, u);
            for (std::size_t r = 0; r < mouths.size(); ++r)
                mouths[r].entering = profile(gap.network.rim.mouths[r].x) * u;
            std::vector<Vec<3>> v =
                gap.at_elements([&](const FilmElement<3>& e) { return Vec<3>(profile(e.centroid_master) * u); });
            const int steps = static_cast<int>(std::lround(1.6 / size));
            for (int step = 0; step < steps; ++step)
                v = transport(gap, gap.filled(v), flow_of(gap, uniform), mouths, 0.8 / u.norm() / steps).high.velocity;
            errors.push_back(0);
            for (std::size_t i = 0; i < v.size(); ++i) {
                const FilmElement<3>& e = gap.elements()[i];
                if (e.centroid_master.head<2>().cwiseAbs().maxCoeff() < 1.2)
                    errors.back() += e.measure * (v[i] - profile(e.centroid_master - 0.8 * along) * u).norm();
            }
        }
        EXPECT_GE(order(errors[0], errors[1]), least) << u.transpose() << ": " << errors[0] << ", " << errors[1];
    }
}

// Steady flow through a wedge, u = q / h: with the pressure's acceleration u u_s its velocities stay, to second order in
// steps in which fluid crosses less than an element.
TEST(FilmTransport, SteadyFlowInAWedgeIsSecondOrder)
{
    std::vector<double> errors;
    for (double size : {0.1, 0.05}) {
        PlateSetup<2> setup;
        setup.largest = size;
        setup.tilt = 0.04;
        GapOfPlates<2> gap(setup);
        gap.open_ends();
        const double q = 0.2, dt = 0.25 * size;
        const Vec<2> along = tangential<2>(unit<2>(0), gap.elements()[0].normal).normalized();
        const auto speed = [&](const FilmElement<2>& e) { return q * e.measure / e.volume; };
        const std::vector<Vec<2>> u = gap.at_elements([&](const FilmElement<2>& e) { return Vec<2>(speed(e) * along); });
        std::vector<FluidInPlace<2>> start = gap.filled(u);
        for (std::size_t i = 0; i < start.size(); ++i) {
            const FilmElement<2>& e = gap.elements()[i];
            const std::vector<double>& h = gap.film().mesh.h;
            double slope = 0;
            for (int k = 0; k < 2; ++k)
                slope += e.cosine() * h[e.nodes[k]] * e.gradient[k].dot(along);
            start[i].acceleration = -speed(e) * speed(e) * e.measure / e.volume * slope * along; // u u_s
        }
        std::vector<MouthFlow<2>> mouths;
        for (const Mouth<2>& mouth : gap.network.rim.mouths) {
            const Vec<2> through = q / (mouth.h * gap.elements()[mouth.element].cosine()) * along;
            mouths.push_back({std::copysign(q, mouth.outward[0]), through, through});
        }
        const std::vector<Vec<2>> carried = transport(gap, start, flow_of(gap, u), mouths, dt).high.velocity;
        double error = 0, length = 0, largest = 0;
        for (std::size_t i = 0; i < u.size(); ++i) {
            const FilmElement<2>& e = gap.elements()[i];
            if (std::abs(e.centroid_master[0]) > 1.5)
                continue;
            error += e.measure * ((carried[i] - u[i]) / dt + start[i].acceleration).norm();
            largest = std::max(largest, start[i].acceleration.norm());
            length += e.measure;
        }
        errors.push_back(error / length / largest);
    }
    RecordProperty("errors", std::to_string(errors[0]) + ", " + std::to_string(errors[1]));
    EXPECT_GE(order(errors[0], errors[1]), 1.7) << errors[0] << ", " << errors[1];
    EXPECT_LT(errors[1], 0.02);
}

// No new extremum: between the smallest and the largest velocity that is there or enters.
TEST(FilmTransport, StepStaysBetweenItsEnds)
{
    PlateSetup<2> setup;
    setup.largest = 0.1;
    GapOfPlates<2> gap(setup);
    gap.open_ends();
    const Vec<2> u(1, 0);
    const std::vector<Vec<2>> uniform(gap.elements().size(), u);
    std::vector<Vec<2>> v =
        gap.at_elements([](const FilmElement<2>& e) { return Vec<2>(e.centroid_master[0] < 0 ? 2 : 1, 0); });
    std::vector<MouthFlow<2>> mouths = through_ends<2>(gap, u);
    for (MouthFlow<2>& mouth : mouths)
        mouth.entering = {2, 0};
    for (int step = 0; step < 10; ++step) {
        v = transport(gap, gap.filled(v), flow_of(gap, uniform), mouths, 0.13).high.velocity;
        for (const Vec<2>& w : v)
            EXPECT_TRUE(w[0] > 1 - 1e-6 && w[0] < 2 + 1e-6) << w[0];
    }
}

// Random velocities, random fluxes that meet the nodes' balances.
TEST(FilmTransport, BalancedFluxesAddNoEnergy3D)
{
    std::mt19937 random(6);
    const GapOfPlates<3> gap({});
    for (double dt : {0.001, 0.05, 0.3, 3.0})
        for (int trial = 0; trial < 5; ++trial) {
            const std::vector<Vec<3>> u = gap.random_velocities(random);
            const auto flow = transport<3>(gap, gap.filled(u), flow_of(gap, circulating(gap, random)), {}, dt);
            EXPECT_LE(gap.energy(flow.high.velocity), (1 + 1e-9) * gap.energy(u)) << dt;
            EXPECT_LE(gap.energy(flow.low.velocity), (1 + 1e-9) * gap.energy(u)) << dt;
            EXPECT_GT(gap.energy(flow.low.velocity), 0) << dt;
        }
}

// The same where a uniform flow takes them to the ends, and others enter: what the film has and what left is no more than it had and
// what entered.
template <int D>
void no_energy_by_uniform_flow()
{
    std::mt19937 random(9);
    std::normal_distribution<double> normal;
    GapOfPlates<D> gap({});
    gap.open_ends();
    Vec<D> u = unit<D>(0);
    if (D == 3)
        u[1] = 0.5;
    const std::vector<Vec<D>> uniform(gap.elements().size(), u);
    for (double dt : {0.001, 0.05, 0.3, 3.0})
        for (int trial = 0; trial < 5; ++trial) {
            const std::vector<Vec<D>> v = gap.random_velocities(random);
            std::vector<MouthFlow<D>> mouths = through_ends(gap, u);
            for (MouthFlow<D>& mouth : mouths)
                mouth.entering *= 3 * normal(random);
            const auto [low, high] = transport(gap, gap.filled(v), flow_of(gap, uniform), mouths, dt);
            EXPECT_LE(gap.energy(high.velocity) + high.out, (1 + 1e-9) * (gap.energy(v) + high.in)) << dt;
            EXPECT_LE(gap.energy(low.velocity) + low.out, (1 + 1e-9) * (gap.energy(v) + low.in)) << dt;
        }
}

TEST(FilmTransport, UniformFlowAddsNoEnergy2D)
{
    no_energy_by_uniform_flow<2>();
}

TEST(FilmTransport, UniformFlowAddsNoEnergy3D)
{
    no_energy_by_uniform_flow<3>();
}

// Whatever the fluxes along the film and through its ends, and however little volume some elements have or had: what the film has and
// what left is no more than it had and what entered.
template <int D>
void no_energy_by_any_fluxes()
{
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    PlateSetup<D> setup;
    setup.tilt = 0.0999;
    setup.upper = 5;
    GapOfPlates<D> gap(setup); // the plates all but touch at one side
    gap.open_ends();
    double least = 1, most = 0;
    for (const FilmElement<D>& e : gap.elements()) {
        least = std::min(least, e.volume);
        most = std::max(most, e.volume);
    }
    ASSERT_LT(least, 1e-4 * most);
    double entered = 0;
    for (double dt : {1e-3, 0.1, 10.0})
        for (int trial = 0; trial < 3; ++trial) {
            std::vector<FluidInPlace<D>> start = gap.filled(gap.random_velocities(random));
            double before = 0;
            std::vector<Vec<D>> flow = gap.random_velocities(random);
            for (std::size_t i = 0; i < start.size(); ++i) {
                flow[i] *= gap.elements()[i].volume;
                start[i].volume *= std::pow(10, normal(random)) * (i % 7 ? 1 : 1e-8);
                before += 0.5 * start[i].volume * start[i].velocity.squaredNorm();
            }
            std::vector<MouthFlow<D>> mouths;
            for (const Mouth<D>& mouth : gap.network.rim.mouths)
                mouths.push_back(
                    {mouth.length * mouth.h * normal(random), Vec<D>(normal(random) * unit<D>(0)), Vec<D>::Zero()});
            const Carried<D> low = transport(gap, start, flow, mouths, dt).low;
            entered += low.in;
            EXPECT_LE(gap.energy(low.velocity) + low.out, (1 + 1e-6) * (before + low.in)) << dt;
        }
    EXPECT_GT(entered, 0);
}

TEST(FilmTransport, AnyFluxesAddNoEnergyAtFirstOrder2D)
{
    no_energy_by_any_fluxes<2>();
}

TEST(FilmTransport, AnyFluxesAddNoEnergyAtFirstOrder3D)
{
    no_energy_by_any_fluxes<3>();
}

// Elements of a millionth of the volume that their fluxes ask for: the momentum that the step takes across the film is the fluid's that was there, and not
// that of as much fluid as there should be.
template <int D>
void volume_without_momentum()
{
    const GapOfPlates<D> gap({});
    std::mt19937 random(4);
    const std::vector<Vec<D>> fast = gap.random_velocities(random), none(fast.size(), Vec<D>::Zero());
    std::vector<FluidInPlace<D>> start = gap.filled(none);
    double before = 0;
    const Vec<D> master = Vec<D>::Constant(0.3);
    for (std::size_t i = 0; i < start.size(); ++i) {
        start[i].volume *= 1e-6;
        start[i].master = master;
        start[i].world = master + 1e4 * fast[i];
        before += start[i].volume * (start[i].world - master).norm();
    }
    const auto [low, high] = transport<D>(gap, start, none, {}, 0.1);
    Vec<D> after = Vec<D>::Zero();
    for (std::size_t i = 0; i < start.size(); ++i)
        after += gap.elements()[i].volume * (low.world[i] - master);
    EXPECT_GT(before, 0);
    EXPECT_LE(after.norm(), (1 + 1e-9) * before);
}

TEST(FilmTransport, VolumeThatIsNotThereHasNoMomentum2D)
{
    volume_without_momentum<2>();
}

TEST(FilmTransport, VolumeThatIsNotThereHasNoMomentum3D)
{
    volume_without_momentum<3>();
}

} // namespace
} // namespace gapflow::test
