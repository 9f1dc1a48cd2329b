#include "gapflow/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gapflow {

const std::array<std::string, 6> side_names{"x_low", "x_high", "y_low", "y_high", "z_low", "z_high"};

namespace {

const PairScene* find_pair(const Scene& scene, const std::string& a, const std::string& b)
{
    for (const PairScene& pair : scene.pairs)
        if ((pair.bodies[0] == a && pair.bodies[1] == b) || (pair.bodies[0] == b && pair.bodies[1] == a))
            return &pair;
    return nullptr;
}

} // namespace

const GapScene& Scene::gap_of(const std::string& a, const std::string& b) const
{
    const PairScene* pair = find_pair(*this, a, b);
    return pair ? pair->gap : gap;
}

const ContactScene& Scene::contact_of(const std::string& a, const std::string& b) const
{
    const PairScene* pair = find_pair(*this, a, b);
    return pair ? pair->contact : contact;
}

double Scene::held_distance(const std::string& a, const std::string& b) const
{
    return std::max(contact_of(a, b).thickness, gap_of(a, b).roughness);
}

double Scene::least_distance(const std::string& a, const std::string& b) const
{
    const GapScene& gap = gap_of(a, b);
    return std::max(contact_of(a, b).thickness, gap.automatic_roughness ? 0.0 : gap.roughness);
}

std::vector<int> Scene::endless_axes() const
{
    std::vector<int> axes;
    for (int axis = 0; axis < dimension; ++axis) {
        const SideScene::Kind low = sides[2 * axis].kind, high = sides[2 * axis + 1].kind;
        const bool between_walls = low == SideScene::Kind::wall && high == SideScene::Kind::wall;
        if (!between_walls && low != SideScene::Kind::periodic)
            axes.push_back(axis);
    }
    return axes;
}

const CrowdScene* Scene::crowd_of(int body) const
{
    const auto crowd = std::find_if(crowds.begin(), crowds.end(),
                                    [&](const CrowdScene& c) { return body >= c.first && body < c.first + c.number; });
    return crowd == crowds.end() ? nullptr : &*crowd;
}

bool Scene::writes_csv() const
{
    return bodies_table == BodiesTable::csv || bodies_table == BodiesTable::both ||
           (bodies_table == BodiesTable::automatic && (crowds.empty() || bodies.size() <= most_bodies_of_csv));
}

bool Scene::writes_binary() const
{
    return bodies_table == BodiesTable::both || !writes_csv();
}

std::vector<Triple> ProbeScene::places() const
{
    if (kind == Kind::points)
        return points;
    std::vector<Triple> places;
    const Triple& from = points[0];
    const auto at = [](int i, int count) { return static_cast<double>(i) / (count - 1); };
    for (int j = 0; j < std::max(counts[1], 1); ++j)
        for (int i = 0; i < counts[0]; ++i) {
            Triple place = from;
            for (int axis = 0; axis < 3; ++axis)
                place[axis] += kind == Kind::line ? at(i, counts[0]) * (points[1][axis] - from[axis])
                                                  : at(i, counts[0]) * points[1][axis] + at(j, counts[1]) * points[2][axis];
            places.push_back(place);
        }
    return places;
}

std::string names_text(const Scene& scene, const CrowdScene& crowd)
{
    const auto name = [&](int body) { return scene.bodies[static_cast<std::size_t>(body)].name; };
    return name(crowd.first) + (crowd.number > 1 ? " ... " + name(crowd.first + crowd.number - 1) : "");
}

std::string roughness_text(const Scene& scene)
{
    char text[100];
    std::snprintf(text, sizeof text, "%.4g (%.3g cells%s)", scene.gap.roughness, scene.gap.roughness / scene.spacing(),
                  scene.gap.automatic_roughness ? ", auto" : "");
    return text;
}

double expected_memory(int dimension, double cells)
{
    constexpr double process = 45e6;
    return dimension == 2 ? process + 325 * cells : process + 376 * cells + 14.1e3 * std::cbrt(cells * cells);
}

} // namespace gapflow
