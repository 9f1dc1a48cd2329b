// Covers and chains fit each other on all edges, faces and cells, for surfaces in general and in special places.
#include "gapflow/complex/facet_cut.hpp"

#include "gapflow/geometry/shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <tuple>

namespace gapflow::testing {
namespace {

constexpr double pi = std::numbers::pi;

template <int D>
struct Planes {
    std::array<std::vector<double>, D> places;
    Index<D> low = Index<D>::Zero();

    Index<D> high() const
    {
        Index<D> h = low;
        for (int axis = 0; axis < D; ++axis)
            h[axis] += int(places[axis].size()) - 1;
        return h;
    }
};

/// Unit cells from 0 to `count`.
template <int D>
Planes<D> unit_planes(int count)
{
    Planes<D> planes;
    for (auto& places : planes.places)
        for (int i = 0; i <= count; ++i)
            places.push_back(i);
    return planes;
}

template <int D>
FacetCut<D> cut_of(const SurfaceMesh<D>& mesh, const Planes<D>& planes)
{
    const std::span<const std::array<int, D>> elements(mesh.elements);
    const auto links = facet_links<D>(int(mesh.vertices.size()), elements);
    return FacetCut<D>(mesh.vertices, elements, links, planes.places, planes.low);
}

template <int D>
void turn_over(SurfaceMesh<D>& mesh)
{
    for (auto& e : mesh.elements)
        std::swap(e[0], e[1]);
}

template <int D>
void append(SurfaceMesh<D>& mesh, const SurfaceMesh<D>& other)
{
    const int first = int(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (auto e : other.elements) {
        for (int& vertex : e)
            vertex += first;
        mesh.elements.push_back(e);
    }
}

template <int D>
SurfaceMesh<D> placed(SurfaceMesh<D> mesh, const Mat<D>& turn, const Vec<D>& shift)
{
    for (Vec<D>& x : mesh.vertices)
        x = turn * x + shift;
    return mesh;
}

SurfaceMesh<3> box_mesh(const Vec<3>& size)
{
    SurfaceMesh<3> mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(size.cwiseProduct(Vec<3>((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2 & 1) - 0.5)));
    for (int axis = 0; axis < 3; ++axis) {
        const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, top = 1 << axis;
        mesh.elements.insert(mesh.elements.end(), {{top, top + u, top + u + v}, {top, top + u + v, top + v}});
        mesh.elements.insert(mesh.elements.end(), {{0, u + v, u}, {0, v, u + v}});
    }
    return mesh;
}

/// Octahedron with each facet in four, `level` times, on the unit sphere.
SurfaceMesh<3> ball_mesh(int level)
{
    SurfaceMesh<3> mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1., -1.})
            mesh.vertices.push_back(side * unit<3>(axis));
    for (int i = 0; i < 8; ++i) {
        const int x = i & 1, y = 2 + (i >> 1 & 1), z = 4 + (i >> 2 & 1);
        mesh.elements.push_back((x + y + z) % 2 ? std::array{x, z, y} : std::array{x, y, z});
    }
    for (int n = 0; n < level; ++n) {
        std::map<std::pair<int, int>, int> known;
        const auto middle = [&](int a, int b) {
            const auto [entry, added] = known.try_emplace(std::minmax(a, b), int(mesh.vertices.size()));
            if (added)
                mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
            return entry->second;
        };
        std::vector<std::array<int, 3>> fine;
        for (const auto& e : mesh.elements) {
            const int a = middle(e[1], e[2]), b = middle(e[2], e[0]), c = middle(e[0], e[1]);
            fine.insert(fine.end(), {{e[0], c, b}, {c, e[1], a}, {b, a, e[2]}, {a, b, c}});
        }
        mesh.elements = fine;
    }
    return mesh;
}

SurfaceMesh<3> torus_mesh(double radius, double tube, int around, int across)
{
    SurfaceMesh<3> mesh;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double s = 2 * pi * i / around, t = 2 * pi * j / across, r = radius + tube * std::cos(t);
            mesh.vertices.push_back({r * std::cos(s), r * std::sin(s), tube * std::sin(t)});
            const int next_i = (i + 1) % around, next_j = (j + 1) % across;
            const int a = i * across + j, b = next_i * across + j, c = next_i * across + next_j, d = i * across + next_j;
            mesh.elements.insert(mesh.elements.end(), {{a, b, c}, {a, c, d}});
        }
    return mesh;
}

/// Corners counterclockwise.
SurfaceMesh<2> polygon_mesh(const std::vector<Vec<2>>& corners)
{
    SurfaceMesh<2> mesh;
    mesh.vertices = corners;
    const int n = int(corners.size());
    for (int i = 0; i < n; ++i)
        mesh.elements.push_back({i, (i + 1) % n});
    return mesh;
}

/// As FacetCut rounds.
double rounded(double x)
{
    return std::ldexp(std::nearbyint(std::ldexp(x, 36)), -36);
}

template <int D>
void for_box(const Index<D>& low, const Index<D>& high, auto&& visit)
{
    Index<D> i = low;
    for (int axis = 0; axis < D;) {
        visit(i);
        for (axis = 0; axis < D && ++i[axis] > high[axis]; ++axis)
            i[axis] = low[axis];
    }
}

double cross(const Vec<2>& a, const Vec<2>& b)
{
    return a[0] * b[1] - a[1] * b[0];
}

/// A face: its axes, lengths and edges.
template <int D>
struct Face {
    int axis, u, v;
    Index<D> index;
    double width, height;

    Face(const FacetCut<D>& cut, int d, const Index<D>& f)
        : axis(d), u((d + 1) % 3), v((d + 2) % 3), index(f), width(cut.length(u, f[u])), height(cut.length(v, f[v]))
    {
    }
    int edge_axis(int number) const { return number % 2 ? v : u; }
    Index<D> edge(int number) const
    {
        Index<D> e = index;
        e[number % 2 ? u : v] += number == 1 || number == 2;
        return e;
    }
    Vec<2> point(int number, double place) const
    {
        const double off = number == 1 ? width : number == 2 ? height : 0;
        return number % 2 ? Vec<2>(off, place) : Vec<2>(place, off);
    }
};

/// Open stretches of an edge.
template <int D>
std::vector<EdgeCover> open_stretches(const FacetCut<D>& cut, int axis, const Index<D>& e)
{
    std::vector<EdgeCover> open;
    double from = 0;
    for (const EdgeCover& c : cut.edge(axis, e)) {
        open.push_back({from, c.from});
        from = c.to;
    }
    open.push_back({from, cut.length(axis, e[axis])});
    return open;
}

/// Of its open stretches and chains.
template <int D>
double open_area(const FacetCut<D>& cut, const Face<D>& face)
{
    double area = 0;
    for (int number = 0; number < 4; ++number)
        for (const EdgeCover& s : open_stretches(cut, face.edge_axis(number), face.edge(number)))
            area += (number < 2 ? 0.5 : -0.5) * cross(face.point(number, s.from), face.point(number, s.to));
    const FaceChains chains = cut.face(face.axis, face.index);
    for (int i = 0; i < chains.size(); ++i)
        for (std::size_t k = 0; k + 1 < chains[i].points.size(); ++k)
            area += 0.5 * cross(chains[i].points[k], chains[i].points[k + 1]);
    return area;
}

template <int D>
void check_edge(const FacetCut<D>& cut, int axis, const Index<D>& e)
{
    const auto covers = cut.edge(axis, e);
    const double length = cut.length(axis, e[axis]);
    double last = 0;
    for (const EdgeCover& c : covers) {
        ASSERT_LE(last, c.from);
        ASSERT_LE(c.from, c.to);
        last = c.to;
    }
    ASSERT_LE(last, length);
    if (cut.covered(e)) {
        ASSERT_FALSE(covers.empty());
        ASSERT_EQ(covers.front().from, 0);
    }
    if (cut.covered(e + step<D>(axis))) {
        ASSERT_FALSE(covers.empty());
        ASSERT_EQ(covers.back().to, length);
    }
}

/// Chains begin and end at the ends of covers; elsewhere the face is of one kind.
template <int D>
void check_face(const FacetCut<D>& cut, const Face<D>& face, const SurfaceMesh<D>& mesh, bool folded)
{
    using End = std::tuple<int, double, bool>; // edge, place, a chain begins
    std::vector<End> expected, found;
    for (int number = 0; number < 4; ++number) {
        const int axis = face.edge_axis(number);
        const Index<D> e = face.edge(number);
        const auto covers = cut.edge(axis, e);
        for (std::size_t i = 0; i < covers.size(); ++i) {
            if (i > 0 || !cut.covered(e))
                expected.emplace_back(number, covers[i].from, number < 2);
            if (i + 1 < covers.size() || !cut.covered(e + step<D>(axis)))
                expected.emplace_back(number, covers[i].to, number >= 2);
        }
    }
    const FaceChains chains = cut.face(face.axis, face.index);
    for (int i = 0; i < chains.size(); ++i) {
        const FacetChain chain = chains[i];
        ASSERT_GE(chain.points.size(), 2u);
        ASSERT_EQ(chain.points.size(), chain.facets.size() + 1);
        ASSERT_TRUE(i == 0 || chains[i - 1].facets.front() < chain.facets.front());
        for (const Vec<2>& x : chain.points) {
            ASSERT_TRUE(x[0] >= 0 && x[0] <= face.width && x[1] >= 0 && x[1] <= face.height) << x.transpose();
        }
        if (chain.closed()) {
            ASSERT_EQ(chain.points.front(), chain.points.back());
        } else {
            const Vec<2>&a = chain.points.front(), &b = chain.points.back();
            found.emplace_back(chain.first_edge, a[chain.first_edge % 2], true);
            found.emplace_back(chain.last_edge, b[chain.last_edge % 2], false);
            ASSERT_EQ(a, face.point(chain.first_edge, a[chain.first_edge % 2]));
            ASSERT_EQ(b, face.point(chain.last_edge, b[chain.last_edge % 2]));
        }
        for (std::size_t k = 0; k + 1 < chain.points.size(); ++k) { // the middle of each segment lies in its facet's bounds
            const auto& element = mesh.elements[chain.facets[k]];
            Vec<D> x, low = mesh.vertices[element[0]], high = low;
            for (int j = 1; j < D; ++j) {
                low = low.cwiseMin(mesh.vertices[element[j]]);
                high = high.cwiseMax(mesh.vertices[element[j]]);
            }
            if constexpr (D == 3)
                x[face.axis] = cut.place(face.axis, face.index[face.axis]);
            const Vec<2> middle = (chain.points[k] + chain.points[k + 1]) / 2;
            x[face.u] = cut.place(face.u, face.index[face.u]) + middle[0];
            x[face.v] = cut.place(face.v, face.index[face.v]) + middle[1];
            ASSERT_LT((low - x).maxCoeff(), 1e-9);
            ASSERT_LT((x - high).maxCoeff(), 1e-9);
        }
    }
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    ASSERT_EQ(expected, found);
    const double area = open_area(cut, face), whole = face.width * face.height;
    ASSERT_TRUE(folded || (area > -1e-9 && area < whole + 1e-9)) << area;
    if (chains.size() == 0) {
        ASSERT_NEAR(area, cut.covered(face.index) ? 0 : whole, 1e-15 * whole);
    }
}

/// Open areas and the wall's area, of its border by Stokes' theorem, close each cell.
void check_cell(const FacetCut<3>& cut, const Index<3>& cell)
{
    Vec<3> sum = Vec<3>::Zero();
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1}) {
            const Face<3> face(cut, axis, cell + side * step<3>(axis));
            const double sign = side ? 1 : -1;
            sum += sign * open_area(cut, face) * unit<3>(axis);
            const FaceChains chains = cut.face(axis, face.index);
            for (int i = 0; i < chains.size(); ++i)
                for (std::size_t k = 0; k + 1 < chains[i].points.size(); ++k) {
                    Vec<3> a, b;
                    a[axis] = b[axis] = side * cut.length(axis, cell[axis]);
                    a[face.u] = chains[i].points[k][0];
                    a[face.v] = chains[i].points[k][1];
                    b[face.u] = chains[i].points[k + 1][0];
                    b[face.v] = chains[i].points[k + 1][1];
                    sum -= sign * 0.5 * a.cross(b);
                }
        }
    ASSERT_LT(sum.norm(), 1e-12) << cell.transpose();
}

/// Area of the section just above a plane, of the facets' segments.
double section_area(const SurfaceMesh<3>& mesh, int axis, double place)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    double area = 0;
    for (const auto& e : mesh.elements) {
        Vec<2> end[2];
        int count = 0;
        for (int k = 0; k < 3; ++k) {
            const Vec<3>&a = mesh.vertices[e[k]], &b = mesh.vertices[e[(k + 1) % 3]];
            const bool a_above = rounded(a[axis]) > place, b_above = rounded(b[axis]) > place;
            if (a_above != b_above) {
                const double t = std::clamp((place - a[axis]) / (b[axis] - a[axis]), 0., 1.);
                end[b_above] = {a[u] + t * (b[u] - a[u]), a[v] + t * (b[v] - a[v])};
                ++count;
            }
        }
        if (count == 2)
            area += 0.5 * cross(end[0], end[1]); // from where it goes down: counterclockwise round the solid
    }
    return area;
}

/// Whether x may lie on a facet.
template <int D>
bool on_surface(const SurfaceMesh<D>& mesh, const Vec<D>& x)
{
    for (const auto& e : mesh.elements) {
        Vec<D> low = mesh.vertices[e[0]], high = low, normal;
        for (int k = 1; k < D; ++k) {
            low = low.cwiseMin(mesh.vertices[e[k]]);
            high = high.cwiseMax(mesh.vertices[e[k]]);
        }
        const Vec<D> edge = mesh.vertices[e[1]] - mesh.vertices[e[0]];
        if constexpr (D == 2)
            normal = {edge[1], -edge[0]};
        else
            normal = edge.cross(mesh.vertices[e[2]] - mesh.vertices[e[0]]);
        constexpr double near = 1e-7;
        if ((x - low).minCoeff() > -near && (high - x).minCoeff() > -near &&
            std::abs(normal.dot(x - mesh.vertices[e[0]])) <= near * normal.norm())
            return true;
    }
    return false;
}

/// Winding number of the surface about x, off it.
double winding_number(const SurfaceMesh<3>& mesh, const Vec<3>& x)
{
    double angle = 0;
    for (const auto& e : mesh.elements) {
        const Vec<3> a = mesh.vertices[e[0]] - x, b = mesh.vertices[e[1]] - x, c = mesh.vertices[e[2]] - x;
        const double l = a.norm(), m = b.norm(), n = c.norm();
        angle += 2 * std::atan2(a.dot(b.cross(c)), l * m * n + a.dot(b) * n + b.dot(c) * l + c.dot(a) * m);
    }
    return angle / (4 * pi);
}
double winding_number(const SurfaceMesh<2>& mesh, const Vec<2>& x)
{
    double angle = 0;
    for (const auto& e : mesh.elements) {
        const Vec<2> a = mesh.vertices[e[0]] - x, b = mesh.vertices[e[1]] - x;
        angle += std::atan2(cross(a, b), a.dot(b));
    }
    return angle / (2 * pi);
}

template <int D>
void check_vertices(const FacetCut<D>& cut, const SurfaceMesh<D>& mesh, const Planes<D>& planes)
{
    for_box<D>(planes.low, planes.high(), [&](const Index<D>& i) {
        Vec<D> x;
        for (int axis = 0; axis < D; ++axis)
            x[axis] = cut.place(axis, i[axis]);
        if (!on_surface(mesh, x)) {
            ASSERT_NEAR(cut.covered(i), winding_number(mesh, x), 0.1) << i.transpose();
        }
    });
}

struct What {
    bool sections = true; ///< the box has the whole surface
    bool vertices = true; ///< against winding numbers
    bool folded = false;  ///< the surface may be turned over where no grid line meets it
};

/// All that has to hold of a surface that does not cut itself.
template <int D>
void check(const SurfaceMesh<D>& mesh, const Planes<D>& planes, const What& what = {})
{
    const FacetCut<D> cut = cut_of(mesh, planes);
    ASSERT_EQ(cut.overlaps(), 0);
    const Index<D> low = planes.low, high = planes.high();
    for (int axis = 0; axis < D; ++axis)
        for_box<D>(low, high - step<D>(axis), [&](const Index<D>& e) { check_edge(cut, axis, e); });
    std::size_t cut_count = 0;
    for (int axis = D == 2 ? 2 : 0; axis < 3; ++axis) {
        std::map<int, double> covered; // of each plane
        const Index<D> last = high - step<D>((axis + 1) % 3) - step<D>((axis + 2) % 3);
        for_box<D>(low, last, [&](const Index<D>& f) {
            const Face<D> face(cut, axis, f);
            check_face(cut, face, mesh, what.folded);
            ASSERT_FALSE(::testing::Test::HasFatalFailure()) << "face " << axis << " " << f.transpose();
            covered[D == 3 ? f[axis % D] : 0] += face.width * face.height - open_area(cut, face);
            cut_count += cut.face(axis, f).size() > 0;
        });
        if (::testing::Test::HasFatalFailure())
            return;
        if (!what.sections)
            continue;
        if constexpr (D == 3) {
            for (const auto& [plane, area] : covered)
                ASSERT_NEAR(area, section_area(mesh, axis, cut.place(axis, plane)), 1e-8) << axis << " " << plane;
        } else {
            double area = 0;
            for (const auto& e : mesh.elements)
                area += 0.5 * cross(mesh.vertices[e[0]], mesh.vertices[e[1]]);
            ASSERT_NEAR(covered[0], area, 1e-9);
        }
    }
    ASSERT_EQ(cut_count, cut.chained_faces().size());
    if constexpr (D == 3)
        for_box<3>(low, high - Index<3>::Ones(), [&](const Index<3>& cell) { check_cell(cut, cell); });
    if (what.vertices)
        check_vertices(cut, mesh, planes);
}

#define CHECK_CUT(...)                                                                                                         \
    do {                                                                                                                       \
        ASSERT_NO_FATAL_FAILURE(check(__VA_ARGS__));                                                                           \
    } while (false)

template <int D>
bool same(const FacetCut<D>& a, const FacetCut<D>& b, const Planes<D>& box, const Index<D>& shift)
{
    bool equal = true;
    const Index<D> low = box.low, high = box.high();
    for_box<D>(low, high, [&](const Index<D>& i) { equal = equal && a.covered(i) == b.covered(i + shift); });
    for (int axis = 0; axis < D; ++axis)
        for_box<D>(low, high - step<D>(axis), [&](const Index<D>& e) {
            const auto p = a.edge(axis, e), q = b.edge(axis, e + shift);
            equal = equal && std::equal(p.begin(), p.end(), q.begin(), q.end(), [](const EdgeCover& c, const EdgeCover& d) {
                        return c.from == d.from && c.to == d.to;
                    });
        });
    for (int axis = D == 2 ? 2 : 0; axis < 3; ++axis)
        for_box<D>(low, high - step<D>((axis + 1) % 3) - step<D>((axis + 2) % 3), [&](const Index<D>& f) {
            const FaceChains p = a.face(axis, f), q = b.face(axis, f + shift);
            equal = equal && p.size() == q.size();
            for (int i = 0; equal && i < p.size(); ++i)
                equal = p[i].first_edge == q[i].first_edge && p[i].last_edge == q[i].last_edge &&
                        std::equal(p[i].points.begin(), p[i].points.end(), q[i].points.begin(), q[i].points.end()) &&
                        std::equal(p[i].facets.begin(), p[i].facets.end(), q[i].facets.begin(), q[i].facets.end());
        });
    return equal;
}

class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double operator()(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
    int below(int n) { return std::uniform_int_distribution(0, n - 1)(engine_); }
    template <int D>
    Vec<D> point(double low, double high)
    {
        Vec<D> x;
        for (int axis = 0; axis < D; ++axis)
            x[axis] = (*this)(low, high);
        return x;
    }
    template <int D>
    Mat<D> turn()
    {
        if constexpr (D == 2)
            return Eigen::Rotation2Dd((*this)(0, 2 * pi)).toRotationMatrix();
        else
            return Eigen::Quaterniond(Eigen::Vector4d((*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)))
                .normalized()
                .toRotationMatrix();
    }
    /// Cells of equal or of unequal lengths.
    template <int D>
    Planes<D> planes(int count)
    {
        Planes<D> planes = unit_planes<D>(count);
        if (below(2))
            for (auto& places : planes.places)
                for (int i = 1; i < count; ++i)
                    places[i] += (*this)(-0.4, 0.4);
        for (int axis = 0; axis < D; ++axis)
            planes.low[axis] = below(9) - 4;
        return planes;
    }

private:
    std::mt19937 engine_;
};

/// One star-shaped surface, of radius within 1.
template <int D>
SurfaceMesh<D> star(Random& random, int level, double depth)
{
    SurfaceMesh<D> mesh;
    if constexpr (D == 3) {
        mesh = ball_mesh(level);
    } else {
        std::vector<Vec<2>> corners;
        const int n = 3 << (level + 1);
        for (int i = 0; i < n; ++i)
            corners.push_back({std::cos(2 * pi * i / n), std::sin(2 * pi * i / n)});
        mesh = polygon_mesh(corners);
    }
    for (Vec<D>& x : mesh.vertices)
        x *= random(1 - depth, 1);
    return mesh;
}

TEST(FacetCut, HandValuesOfATriangle)
{
    const SurfaceMesh<2> mesh = polygon_mesh({{0.25, 0.5}, {1.75, 0.5}, {0.25, 2}}); // its long side is x + y = 2.25
    const FacetCut<2> cut = cut_of(mesh, unit_planes<2>(2));
    EXPECT_FALSE(cut.covered({0, 0}));
    EXPECT_TRUE(cut.covered({1, 1}));
    const auto low = cut.edge(1, {1, 0}), high = cut.edge(1, {1, 1});
    ASSERT_EQ(low.size(), 1u);
    EXPECT_EQ(low[0].from, 0.5);
    EXPECT_EQ(low[0].to, 1);
    ASSERT_EQ(high.size(), 1u);
    EXPECT_EQ(high[0].from, 0);
    EXPECT_EQ(high[0].to, 0.25);
    FaceChains chains = cut.face(2, {0, 0});
    ASSERT_EQ(chains.size(), 1);
    EXPECT_EQ(chains[0].first_edge, 1);
    EXPECT_EQ(chains[0].last_edge, 2);
    ASSERT_EQ(chains[0].points.size(), 3u);
    EXPECT_EQ(chains[0].points[0], Vec<2>(1, 0.5));
    EXPECT_EQ(chains[0].points[1], Vec<2>(0.25, 0.5));
    EXPECT_EQ(chains[0].points[2], Vec<2>(0.25, 1));
    EXPECT_EQ(chains[0].facets[0], 0);
    EXPECT_EQ(chains[0].facets[1], 2);
    chains = cut.face(2, {1, 1});
    ASSERT_EQ(chains.size(), 1);
    EXPECT_EQ(chains[0].points.front(), Vec<2>(0, 0.25));
    EXPECT_EQ(chains[0].points.back(), Vec<2>(0.25, 0));
    EXPECT_EQ(chains[0].facets[0], 1);
}

TEST(FacetCut, HandValuesOfABoxInOneCell)
{
    const SurfaceMesh<3> mesh = placed<3>(box_mesh({0.5, 0.5, 2}), Mat<3>::Identity(), {1.5, 1.5, 1.5});
    const FacetCut<3> cut = cut_of(mesh, unit_planes<3>(3));
    const FaceChains chains = cut.face(2, {1, 1, 1});
    ASSERT_EQ(chains.size(), 1);
    EXPECT_TRUE(chains[0].closed());
    double area = 0;
    for (std::size_t k = 0; k + 1 < chains[0].points.size(); ++k)
        area += 0.5 * cross(chains[0].points[k], chains[0].points[k + 1]);
    EXPECT_EQ(area, -0.25); // clockwise round the solid
    EXPECT_EQ(cut.chained_faces().size(), 2u);
    EXPECT_EQ(cut.face(0, {1, 1, 1}).size(), 0);
    EXPECT_TRUE(cut.edge(2, {1, 1, 1}).empty());
}

// A side in a grid plane covers it if the solid lies above: each plane and vertex is covered by one of two boxes that touch.
TEST(FacetCut, AlignedBoxesHaveTheirVolume)
{
    const Planes<3> planes = unit_planes<3>(7);
    for (const Vec<3>& size : {Vec<3>(2, 3, 4), Vec<3>(1, 1, 1), Vec<3>(5, 1, 2)}) {
        const SurfaceMesh<3> mesh = placed<3>(box_mesh(size), Mat<3>::Identity(), size / 2 + Vec<3>::Ones());
        CHECK_CUT(mesh, planes);
        const FacetCut<3> cut = cut_of(mesh, planes);
        int vertices = 0;
        for_box<3>(planes.low, planes.high(), [&](const Index<3>& i) {
            const bool inside = (i.array() >= 1).all() && (i.cast<double>().array() < 1 + size.array()).all();
            ASSERT_EQ(cut.covered(i), inside);
            vertices += inside;
        });
        EXPECT_EQ(vertices, size.prod());
        for (int axis = 0; axis < 3; ++axis) {
            double volume = 0;
            for_box<3>(planes.low, planes.high() - Index<3>::Ones(),
                       [&](const Index<3>& f) { volume += 1 - open_area(cut, Face<3>(cut, axis, f)); });
            EXPECT_EQ(volume, size.prod());
        }
    }
}

TEST(FacetCut, BoxesInAllSymmetricPoses)
{
    const Planes<3> planes = unit_planes<3>(8);
    std::vector<Mat<3>> turns{Mat<3>::Identity()};
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t count = turns.size();
        for (int i = 1; i < 8; ++i)
            for (std::size_t k = 0; k < count; ++k)
                turns.push_back(Eigen::AngleAxisd(i * pi / 4, unit<3>(axis)) * turns[k]);
    }
    int i = 0;
    for (const Mat<3>& turn : turns) // of each, one of the boxes and places
        for (const Vec<3>& size : {Vec<3>(2, 2, 2), Vec<3>(3, 2, 1), Vec<3>(4, 1, 0.001)})
            for (const Vec<3>& at : {Vec<3>(4, 4, 4), Vec<3>(4.5, 4, 3.5), Vec<3>(4.5, 4.5, 4.5)})
                if (++i % 23 == 0)
                    CHECK_CUT(placed<3>(box_mesh(size), turn, at), planes, {.vertices = i % 5 == 0});
}

TEST(FacetCut, BallsWithVerticesOnPlanesAndLines)
{
    for (const int level : {0, 1, 2, 3})
        for (const double radius : {0.4, 1., 2., 3.})
            for (const Vec<3>& at : {Vec<3>(4, 4, 4), Vec<3>(4.5, 4, 4), Vec<3>(4.5, 4.5, 4.5)}) {
                SurfaceMesh<3> mesh = ball_mesh(level);
                CHECK_CUT(placed<3>(mesh, radius * Mat<3>::Identity(), at), unit_planes<3>(8), {.vertices = level < 3});
                for (Vec<3>& x : mesh.vertices) // the octahedron's facets in parts: vertices and edges on lines and on vertices
                    x *= radius / x.lpNorm<1>();
                CHECK_CUT(placed<3>(mesh, Mat<3>::Identity(), at), unit_planes<3>(8), {.vertices = level < 3});
            }
}

TEST(FacetCut, FacetsMuchSmallerThanCells)
{
    CHECK_CUT(placed<3>(ball_mesh(5), 2.1 * Mat<3>::Identity(), {3.1, 2.9, 3}), unit_planes<3>(6), {.vertices = false});
}

TEST(FacetCut, SliversNeedlesAndPlates)
{
    Random random(3);
    for (int i = 0; i < 60; ++i) {
        const Planes<3> planes = random.planes<3>(7);
        const Vec<3> at = i % 2 ? Vec<3>(random.point<3>(3, 4)) : Vec<3>(3, 4, 3);
        const Mat<3> turn = i % 4 < 2 ? Mat<3>(Mat<3>::Identity()) : random.turn<3>();
        const double thin = std::pow(10, -random(1, 10));
        CHECK_CUT(placed<3>(box_mesh({5, thin, thin}), turn, at), planes);
        CHECK_CUT(placed<3>(box_mesh({4, 4, thin}), turn, at), planes);
        // A ball with vertices close to each other: its facets are slivers.
        SurfaceMesh<3> ball = ball_mesh(2);
        for (Vec<3>& x : ball.vertices)
            x[2] = x[2] > 0.1 ? 1 + thin * x[2] : thin * x[2];
        CHECK_CUT(placed<3>(ball, 2 * turn, at), planes);
    }
}

TEST(FacetCut, CavitiesPartsAndContainers)
{
    Random random(4);
    for (int i = 0; i < 20; ++i) {
        const Planes<3> planes = random.planes<3>(8);
        const Vec<3> at = i % 2 ? Vec<3>(random.point<3>(3.5, 4.5)) : Vec<3>(4, 4, 4);
        SurfaceMesh<3> mesh = placed<3>(ball_mesh(2), 3.3 * random.turn<3>(), at), hole = ball_mesh(1);
        turn_over(hole);
        append(mesh, placed<3>(hole, 2.4 * random.turn<3>(), at));
        append(mesh, placed<3>(box_mesh({1, 1, 1}), i % 4 < 2 ? Mat<3>(Mat<3>::Identity()) : random.turn<3>(), at));
        CHECK_CUT(mesh, planes);
        turn_over(mesh);
        const FacetCut<3> cut = cut_of(mesh, planes);
        EXPECT_TRUE(cut.covered(planes.low));
        EXPECT_EQ(cut.overlaps(), 0);
    }
    // Two boxes that touch: along a side, an edge and a corner.
    for (const Vec<3>& shift : {Vec<3>(2, 0, 0), Vec<3>(2, 1, 0), Vec<3>(2, 2, 0), Vec<3>(2, -2, 2)}) {
        SurfaceMesh<3> mesh = placed<3>(box_mesh({2, 2, 2}), Mat<3>::Identity(), {3, 3, 3});
        append(mesh, placed<3>(box_mesh({2, 2, 2}), Mat<3>::Identity(), Vec<3>(3, 3, 3) + shift));
        CHECK_CUT(mesh, unit_planes<3>(8), {.vertices = false});
        for (Vec<3>& x : mesh.vertices)
            x = Eigen::AngleAxisd(pi / 6, Vec<3>(1, 1, 1).normalized()) * (x - Vec<3>(4, 4, 4)) + Vec<3>(4, 4, 4);
        CHECK_CUT(mesh, unit_planes<3>(8), {.vertices = false});
    }
}

TEST(FacetCut, RandomSurfacesInRandomPoses)
{
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        SCOPED_TRACE(i);
        const int kind = i % 5;
        SurfaceMesh<3> mesh = kind == 0   ? ball_mesh(random.below(3))
                              : kind == 1 ? star<3>(random, 1 + random.below(2), 0.8)
                              : kind == 2 ? torus_mesh(0.7, random(0.05, 0.3), 3 + random.below(9), 3 + random.below(6))
                              : kind == 3 ? box_mesh(random.point<3>(0.1, 1.2))
                                          : star<3>(random, 0, 0.99);
        Mat<3> turn = random.turn<3>();
        if (kind == 0) // ellipsoids
            turn = turn * Vec<3>(random.point<3>(0.05, 1)).asDiagonal();
        const double size = random(0.1, 2);
        CHECK_CUT(placed<3>(mesh, size * turn, random.point<3>(2, 3)), random.planes<3>(5), {.vertices = i % 50 < 5});
    }
}

// Vertices on half-integer places: on planes, lines and vertices of the grid, and on each other.
TEST(FacetCut, RandomSurfacesWithVerticesOnGridPlanes)
{
    Random random(6);
    int checked = 0;
    for (int i = 0; i < 400; ++i) {
        SCOPED_TRACE(i);
        SurfaceMesh<3> mesh = i % 2 ? star<3>(random, random.below(3), random(0, 0.5))
                                    : torus_mesh(0.7, 0.3, 4 + random.below(9), 4 + random.below(6));
        mesh = placed<3>(mesh, random(1, 2.6) * random.turn<3>(), random.point<3>(2.5, 3.5));
        const double spacing = i % 3 ? 1 : 2;
        for (Vec<3>& x : mesh.vertices)
            x = (spacing * x).array().round() / spacing;
        const Planes<3> planes = unit_planes<3>(6);
        if (cut_of(mesh, planes).overlaps() > 0) // rounding folded it
            continue;
        CHECK_CUT(mesh, planes, {.vertices = false, .folded = true});
        ++checked;
    }
    EXPECT_GT(checked, 150);
}

TEST(FacetCut, PartsOfTheBoxAndShiftsGiveTheSame)
{
    Random random(7);
    for (int i = 0; i < 60; ++i) {
        SurfaceMesh<3> mesh = placed<3>(star<3>(random, 1 + random.below(3), 0.6), random(1, 4) * random.turn<3>(), {4, 4, 4});
        append(mesh, placed<3>(box_mesh({5, 0.3, 0.2}), Mat<3>::Identity(), {4, 9, 4}));
        for (Vec<3>& x : mesh.vertices)
            x = x.unaryExpr([](double y) { return rounded(y); });
        const Planes<3> planes = unit_planes<3>(10);
        const FacetCut<3> cut = cut_of(mesh, planes);
        Planes<3> part = planes;
        for (int axis = 0; axis < 3; ++axis) {
            const int from = random.below(8), to = from + 1 + random.below(9 - from);
            part.low[axis] = from;
            part.places[axis] = {planes.places[axis].begin() + from, planes.places[axis].begin() + to + 1};
        }
        ASSERT_TRUE(same(cut_of(mesh, part), cut, part, Index<3>(0, 0, 0)));
        CHECK_CUT(mesh, part, {.sections = false});
        SurfaceMesh<3> shifted = mesh;
        Planes<3> far = planes;
        const Index<3> shift(96, -32000, 65000);
        for (Vec<3>& x : shifted.vertices)
            x += shift.cast<double>();
        for (int axis = 0; axis < 3; ++axis) {
            far.low[axis] += shift[axis];
            for (double& place : far.places[axis])
                place += shift[axis];
        }
        ASSERT_TRUE(same(cut, cut_of(shifted, far), planes, shift));
    }
}

// No chain or cover is lost, and it is told.
TEST(FacetCut, PartsThatOverlapAreCounted)
{
    SurfaceMesh<3> mesh = placed<3>(box_mesh({2, 2, 2}), Mat<3>::Identity(), {3.3, 3.3, 3.3});
    append(mesh, placed<3>(box_mesh({2, 2, 2}), Mat<3>::Identity(), {4.1, 4.2, 4.4}));
    const FacetCut<3> cut = cut_of(mesh, unit_planes<3>(8));
    EXPECT_GT(cut.overlaps(), 0);
    int vertices = 0;
    for_box<3>({0, 0, 0}, {8, 8, 8}, [&](const Index<3>& i) { vertices += cut.covered(i); });
    EXPECT_EQ(vertices, 8 + 8 - 1);
}

TEST(FacetCut, PolygonsWithHoles)
{
    Random random(8);
    for (int i = 0; i < 1000; ++i) {
        SCOPED_TRACE(i);
        const bool on_planes = i % 4 == 0;
        const double size = random(0.6, 2.4);
        const Vec<2> at = random.point<2>(2.5, 3.5);
        SurfaceMesh<2> mesh = placed<2>(star<2>(random, random.below(4), 0.5), size * random.turn<2>(), at);
        if (i % 3 == 0) {
            SurfaceMesh<2> hole = star<2>(random, 1, 0.5);
            turn_over(hole);
            append(mesh, placed<2>(hole, 0.2 * size * random.turn<2>(), at));
        }
        if (on_planes)
            for (Vec<2>& x : mesh.vertices)
                x = (2 * x).array().round() / 2;
        const Planes<2> planes = on_planes ? unit_planes<2>(6) : random.planes<2>(6);
        if (on_planes && cut_of(mesh, planes).overlaps() > 0)
            continue;
        CHECK_CUT(mesh, planes, {.vertices = !on_planes, .folded = on_planes});
        Planes<2> part = planes;
        for (int axis = 0; axis < 2; ++axis) {
            part.low[axis] += 2;
            part.places[axis] = {planes.places[axis].begin() + 2, planes.places[axis].begin() + 5};
        }
        ASSERT_TRUE(same(cut_of(mesh, part), cut_of(mesh, planes), part, Index<2>(0, 0)));
    }
    for (int i = 0; i < 8; ++i)
        for (const Vec<2>& at : {Vec<2>(3, 3), Vec<2>(3.5, 3), Vec<2>(3.5, 3.5)})
            CHECK_CUT(placed<2>(polygon_mesh({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}),
                                Eigen::Rotation2Dd(i * pi / 4).toRotationMatrix(), at),
                      unit_planes<2>(6));
}

} // namespace
} // namespace gapflow::testing
