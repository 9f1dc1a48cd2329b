// Coupled systems made by hand: balls and boxes with rough cut fractions in a box, a film on the plane where two boxes touch.
#pragma once

#include "gapflow/solver/solver.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace gapflow::test {

template <int D>
struct BodyShape {
    std::function<double(const Vec<D>&)> distance; ///< negative inside
    Vec<D> centre;
    double mass;
    double radius; ///< of gyration
    bool fixed = false;
};

template <int D>
BodyShape<D> ball(const Vec<D>& centre, double radius, double density);
template <int D>
BodyShape<D> box(const Vec<D>& centre, const Vec<D>& half, double density);

/// Film on the plane x_{D-1} = `plane` between body `below` and body `above`, low <= x <= high along the other axes.
template <int D>
struct TestFilm {
    int below, above;
    double plane;
    Vec<D> low, high;
    int elements;       ///< along each axis
    double conductance; ///< of an element's edge
    double mouth;       ///< of a mouth
};

template <int D>
struct TestScene {
    Index<D> cells;
    double dx = 1.0;
    std::array<SideKind, 2 * D> sides;
    std::vector<BodyShape<D>> bodies;
    std::vector<TestFilm<D>> films;
    bool voxels = false; ///< faces are open or closed

    TestScene(const Index<D>& cells_, double dx_, SideKind all = SideKind::wall) : cells(cells_), dx(dx_) { sides.fill(all); }
};

/// The system, its grid kept with it.
template <int D>
struct TestSystem {
    std::unique_ptr<Grid<D>> grid;
    CoupledSystem<D> system;
};

/// Every rank works out the whole scene: for small grids.
template <int D>
std::unique_ptr<TestSystem<D>> build(const TestScene<D>& scene, const Communicator& comm = Communicator());

/// In [-1, 1), the same for the same key everywhere.
inline double noise(std::uint64_t key, std::uint64_t seed = 0)
{
    std::uint64_t z = key * 0x9E3779B97F4A7C15ull + seed * 0xD1B54A32D192ED03ull + 0x632BE59BD9B4E019ull;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return static_cast<double>((z ^ (z >> 31)) >> 11) / 4503599627370496.0 - 1.0;
}

/// Smooth waves plus `rough` times noise, 0 in cells without unknown.
template <int D>
UnknownVector<D> sample(const TestSystem<D>& test, double rough, std::uint64_t seed = 0);

template <int D>
UnknownVector<D> zeros(const TestSystem<D>& test)
{
    return {CellField<D>(*test.grid), Eigen::VectorXd::Zero(test.system.nodes)};
}

/// K V of twists V by noise: the outflow that moving bodies cause.
template <int D>
UnknownVector<D> motion_outflow(const TestSystem<D>& test, std::uint64_t seed = 0);

/// Sum of a b over all unknowns.
template <int D>
double inner(const TestSystem<D>& test, const UnknownVector<D>& a, const UnknownVector<D>& b);

/// v without its part along the null vectors.
template <int D>
void remove_null(const TestSystem<D>& test, UnknownVector<D>& v);

/// |a - b| / |b|.
template <int D>
double distance(const TestSystem<D>& test, const UnknownVector<D>& a, const UnknownVector<D>& b);

/// Two boxes in a closed or open box, one upon the other with a film between, and a ball.
template <int D>
TestScene<D> film_scene(int n, double film, double mouth, double density, SideKind sides = SideKind::wall);

/// A wall of two boxes across a closed box, joined by a film between them: two chambers that only the film connects.
template <int D>
TestScene<D> chamber_scene(int n, double film, double mouth, double density);

/// Two bodies away from each other in a closed box.
template <int D>
TestScene<D> two_bodies(int n, double density, SideKind sides = SideKind::wall);

} // namespace gapflow::test
