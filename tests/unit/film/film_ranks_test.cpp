// Films whose making ranks share: every rank gets what a single one makes. Run on several ranks (ctest -L mpi).
#include "film_scene.hpp"

#include "gapflow/core/sharing.hpp"

#include <random>

namespace gapflow::test {
namespace {

/// Balls and boxes close to each other everywhere, across the domain's sides too.
template <int D>
void fill(FilmScene<D>& scene)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> jitter(-0.2, 0.2);
    int number = 0;
    for_each_index<D>(Index<D>::Zero(), Index<D>::Constant(4), [&](const Index<D>& i) {
        Vec<D> x = 5.0 * i.template cast<double>() + Vec<D>::Constant(2.3);
        for (int axis = 0; axis < D; ++axis)
            x[axis] += jitter(random);
        const std::string name = "body" + std::to_string(100 + number++);
        if (number % 4 == 0)
            scene.add_ball(name, 2.3, x);
        else
            scene.add_box(name, x - Vec<D>::Constant(2.25), x + Vec<D>::Constant(2.25));
    });
    scene.clip();
}

Bytes bytes_of(const auto& value)
{
    ByteWriter writer;
    writer(value);
    return writer.take();
}

template <int D>
void expect_same(FilmNetwork<D> a, FilmNetwork<D> b)
{
    ASSERT_EQ(a.films.size(), b.films.size());
    for (std::size_t k = 0; k < a.films.size(); ++k) {
        const FilmMesh<D>&m = a.films[k].mesh, &n = b.films[k].mesh;
        EXPECT_EQ(a.films[k].pair, b.films[k].pair);
        EXPECT_EQ(a.films[k].threshold, b.films[k].threshold);
        EXPECT_EQ(a.films[k].first_node, b.films[k].first_node);
        EXPECT_EQ(bytes_of(m.x), bytes_of(n.x));
        EXPECT_EQ(bytes_of(m.h), bytes_of(n.h));
        EXPECT_EQ(m.elements.size(), n.elements.size());
        EXPECT_EQ(m.rim.size(), n.rim.size());
        EXPECT_EQ(m.points.size(), n.points.size());
    }
    ASSERT_EQ(a.cells.cells.size(), b.cells.cells.size());
    for (int i = 0; i < static_cast<int>(a.cells.cells.size()); ++i) {
        const auto& [key, cell] = a.cells.cells.item(i);
        const auto& [other_key, other] = b.cells.cells.item(i);
        ASSERT_EQ(key, other_key);
        EXPECT_EQ(cell.kind, other.kind);
        EXPECT_EQ(cell.owner, other.owner);
        ASSERT_EQ(cell.touches.size(), other.touches.size());
        for (std::size_t t = 0; t < cell.touches.size(); ++t) {
            EXPECT_EQ(cell.touches[t].film, other.touches[t].film);
            EXPECT_EQ(cell.touches[t].measure, other.touches[t].measure);
            EXPECT_EQ(cell.touches[t].offset, other.touches[t].offset);
        }
    }
    ASSERT_EQ(a.cells.closed.size(), b.cells.closed.size());
    for (const auto& [face, film] : a.cells.closed) {
        ASSERT_TRUE(b.cells.closed.contains(face));
        EXPECT_EQ(*b.cells.closed.find(face), film);
    }
    ASSERT_EQ(a.rim.mouths.size(), b.rim.mouths.size());
    for (std::size_t k = 0; k < a.rim.mouths.size(); ++k) {
        EXPECT_EQ(a.rim.mouths[k].nodes, b.rim.mouths[k].nodes);
        EXPECT_EQ(a.rim.mouths[k].resistance, b.rim.mouths[k].resistance);
        EXPECT_EQ(a.rim.mouths[k].cells, b.rim.mouths[k].cells);
    }
    ASSERT_EQ(a.rim.joints.size(), b.rim.joints.size());
    for (std::size_t k = 0; k < a.rim.joints.size(); ++k) {
        EXPECT_EQ(a.rim.joints[k].nodes_a, b.rim.joints[k].nodes_a);
        EXPECT_EQ(a.rim.joints[k].nodes_b, b.rim.joints[k].nodes_b);
    }
    EXPECT_EQ(a.rim.blind_length, b.rim.blind_length);
    EXPECT_EQ(a.rim.closed_length, b.rim.closed_length);
}

/// Cells that no film touches and that became film: neighbours, closed cells, pockets.
template <int D>
int given_cells(const FilmNetwork<D>& network)
{
    int count = 0;
    for (const auto& [key, cell] : network.cells.cells)
        count += cell.kind == CellKind::film && cell.touches[0].measure == 0;
    return count;
}

template <int D>
void check(SideKind sides)
{
    FilmScene<D> alone(20, sides), shared(20, sides, MPI_COMM_WORLD);
    fill(alone);
    fill(shared);
    const FilmNetwork<D> network = alone.network();
    EXPECT_TRUE(D == 2 || given_cells(network) > 0);
    EXPECT_GT(network.rim.mouths.size(), 0u);
    EXPECT_GT(network.rim.joints.size(), 0u);
    expect_same<D>(network, shared.network());
}

TEST(FilmRanks, MakeWhatOneRankMakes2D)
{
    check<2>(SideKind::open);
}

TEST(FilmRanks, MakeWhatOneRankMakesInAPeriodicBox2D)
{
    check<2>(SideKind::periodic);
}

TEST(FilmRanks, MakeWhatOneRankMakes3D)
{
    check<3>(SideKind::open);
}

TEST(FilmRanks, MakeWhatOneRankMakesInAPeriodicBox3D)
{
    check<3>(SideKind::periodic);
}

} // namespace
} // namespace gapflow::test
