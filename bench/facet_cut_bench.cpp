// Times of FacetCut: balls of 1000 to 1 000 000 facets, radius 40 cells, in 128^3 cells. Best of several, one thread.
#include "gapflow/complex/facet_cut.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>

namespace gapflow {
namespace {

struct Surface {
    std::vector<Vec<3>> vertices;
    std::vector<std::array<int, 3>> elements;
};

/// Octahedron with `parts` parts an edge, on the unit sphere.
Surface ball(int parts)
{
    Surface s;
    std::map<std::array<int, 3>, int> known;
    for (int octant = 0; octant < 8; ++octant) {
        const int x = octant & 1 ? -1 : 1, y = octant & 2 ? -1 : 1, z = octant & 4 ? -1 : 1;
        const auto vertex = [&](int i, int j) {
            const std::array<int, 3> at{x * i, y * j, z * (parts - i - j)};
            const auto [entry, added] = known.try_emplace(at, int(s.vertices.size()));
            if (added)
                s.vertices.push_back(Vec<3>(at[0], at[1], at[2]).normalized());
            return entry->second;
        };
        const auto add = [&](int a, int b, int c) {
            s.elements.push_back(x * y * z > 0 ? std::array{a, b, c} : std::array{a, c, b});
        };
        for (int i = 0; i < parts; ++i)
            for (int j = 0; i + j < parts; ++j) {
                add(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
                if (i + j + 1 < parts)
                    add(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
            }
    }
    return s;
}

template <class F>
double seconds(F&& f)
{
    const auto begin = std::chrono::steady_clock::now();
    f();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void measure(int parts)
{
    Surface s = ball(parts);
    const Eigen::AngleAxisd turn(0.3, Vec<3>(1, 2, 3).normalized());
    for (Vec<3>& x : s.vertices)
        x = 40 * (turn * x) + Vec<3>(64.3, 64.1, 64);
    std::array<std::vector<double>, 3> places;
    for (auto& p : places)
        for (int i = 0; i <= 128; ++i)
            p.push_back(i);
    const std::span<const std::array<int, 3>> elements(s.elements);
    double links_time = 1e9, cut_time = 1e9;
    std::size_t faces = 0;
    for (int i = 0; i < 9; ++i) {
        std::vector<std::array<int, 3>> links;
        links_time = std::min(links_time, seconds([&] { links = facet_links<3>(int(s.vertices.size()), elements); }));
        cut_time = std::min(cut_time, seconds([&] {
                                faces =
                                    FacetCut<3>(s.vertices, elements, links, places, Index<3>(0, 0, 0)).chained_faces().size();
                            }));
    }
    std::printf("%7zu facets: links %6.1f ms, cut %6.1f ms, %zu faces\n", s.elements.size(), 1e3 * links_time, 1e3 * cut_time,
                faces);
}

} // namespace
} // namespace gapflow

int main()
{
    for (const int parts : {11, 35, 112, 354})
        gapflow::measure(parts);
}
