#include "gapflow/stepping/standoff.hpp"

#include "gapflow/body/contact_points.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/complex/plane_poses.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace gapflow {
namespace {

// Of the roughness: the complex has no fluid between solids that touch, and where a body is displaced to find the force on it, it must not meet the next one.
constexpr double least_distance = 0.2;
constexpr int most_sweeps = 100;

double roughness_of(const Scene& scene, const std::string& a, const std::string& b)
{
    const GapScene& gap = scene.gap_of(a, b);
    return gap.contact == GapScene::Contact::dry ? scene.held_distance(a, b) : gap.roughness;
}

bool names_pair(const Scene& scene, const std::string& a, const std::string& b)
{
    const std::array<std::string, 2> names{a, b};
    return std::any_of(scene.pairs.begin(), scene.pairs.end(), [&](const PairScene& pair) {
        return std::is_permutation(names.begin(), names.end(), pair.bodies.begin());
    });
}

template <int D>
bool still(const Solid<D>& solid)
{
    return solid.wall || solid.motion == Motion::fixed;
}

/// Two solids that come too near.
template <int D>
struct ClosePair {
    int a, b;
    Vec<D> normal;  ///< towards a
    double missing; ///< of their least distance
};

/// Moves the solids that may move until all are apart.
template <int D>
void set_apart(const std::vector<ClosePair<D>>& touches, double enough, std::vector<Solid<D>>& solids)
{
    std::vector<Vec<D>> way(solids.size(), Vec<D>::Zero());
    double worst = touches.empty() ? 0.0 : enough + 1;
    for (int sweep = 0; sweep < most_sweeps && worst > enough; ++sweep) {
        worst = 0;
        for (const ClosePair<D>& touch : touches) {
            const double missing = touch.missing - touch.normal.dot(way[touch.a] - way[touch.b]);
            if (!(missing > 0))
                continue;
            worst = std::max(worst, missing);
            const bool a = !still(solids[touch.a]), b = !still(solids[touch.b]);
            if (a)
                way[touch.a] += (b ? 0.5 : 1.0) * missing * touch.normal;
            if (b)
                way[touch.b] -= (a ? 0.5 : 1.0) * missing * touch.normal;
        }
    }
    for (std::size_t s = 0; s < solids.size(); ++s)
        if (!way[s].isZero(0)) {
            solids[s].shape = solids[s].shape.shifted(way[s]);
            solids[s].centre += way[s];
        }
}

} // namespace

template <int D>
RoughSolids<D> rough_solids(const Scene& scene, const Grid<D>& grid, std::vector<Solid<D>> solids)
{
    RoughSolids<D> rough{std::move(solids), {}};
    const std::vector<Solid<D>> all = rough.solids;
    double roughest = std::max(scene.gap.roughness, scene.contact.thickness);
    for (const PairScene& pair : scene.pairs)
        roughest = std::max({roughest, pair.gap.roughness, pair.contact.thickness});
    if (!(roughest > 0)) {
        put_into_planes(grid, rough.solids);
        return rough;
    }
    const double dx = grid.dx();
    Vec<D> period = Vec<D>::Zero();
    for (int axis = 0; axis < D; ++axis)
        if (grid.periodic(axis))
            period[axis] = grid.size()[axis];
    std::vector<std::optional<ContactFeatures<D>>> features(all.size());
    const auto features_of = [&](int s) -> const ContactFeatures<D>& {
        if (!features[s])
            features[s] = contact_features(all[s].shape.shape());
        return *features[s];
    };
    std::vector<ClosePair<D>> touches;
    for (const NearPair<D>& near : near_pairs<D>(all, grid.origin(), grid.origin() + grid.size(), period, roughest)) {
        const Solid<D>&a = all[near.a], &b = all[near.b];
        if (still(a) && still(b) && !names_pair(scene, a.name, b.name))
            continue;
        const double roughness = roughness_of(scene, a.name, b.name);
        if (!(roughness > 0))
            continue;
        const std::optional<Separation<D>> found =
            separation<D>(a.shape, features_of(near.a), b.shape.shifted(near.shift), features_of(near.b), roughness);
        if (!found || !(found->distance < roughness))
            continue;
        const Vec<D>& n = found->normal;
        const double distance = found->distance, least = least_distance * roughness;
        const bool overlap = distance < -roughness, touch = !overlap && distance < least;
        Standoff<D> standoff{(roughness - (touch ? least : std::max(distance, 0.0))) / dx, PairTwist<D>::Zero()};
        if (!overlap)
            standoff.rate << -wrench<D>(n, (found->place - a.centre) / dx),
                wrench<D>(n, (found->place - b.centre - near.shift) / dx);
        rough.standoffs.add(near.a, near.b, standoff);
        if (touch)
            touches.push_back({near.a, near.b, n, least - distance});
    }
    set_apart<D>(touches, 1e-3 * least_distance * roughest, rough.solids);
    put_into_planes(grid, rough.solids);
    return rough;
}

template RoughSolids<2> rough_solids<2>(const Scene&, const Grid<2>&, std::vector<Solid<2>>);
template RoughSolids<3> rough_solids<3>(const Scene&, const Grid<3>&, std::vector<Solid<3>>);

} // namespace gapflow
