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

/// Two solids that are near each other, or come near as others are moved.
template <int D>
struct ClosePair {
    int a, b;
    Separation<D> nearest;
    Vec<D> shift; ///< of b
    double roughness;

    double least() const { return least_distance * roughness; }
    bool overlap() const { return nearest.distance < -roughness; }
};

/// Ways of the solids that may move until all pairs have their least distance.
template <int D>
std::vector<Vec<D>> set_apart(const std::vector<ClosePair<D>>& pairs, double enough, const std::vector<Solid<D>>& solids)
{
    std::vector<Vec<D>> way(solids.size(), Vec<D>::Zero());
    double worst = enough + 1;
    for (int sweep = 0; sweep < most_sweeps && worst > enough; ++sweep) {
        worst = 0;
        for (const ClosePair<D>& pair : pairs) {
            const Vec<D>& n = pair.nearest.normal;
            const double missing = pair.least() - pair.nearest.distance - n.dot(way[pair.a] - way[pair.b]);
            if (!(missing > 0) || pair.overlap())
                continue;
            worst = std::max(worst, missing);
            const bool a = !still(solids[pair.a]), b = !still(solids[pair.b]);
            if (a)
                way[pair.a] += (b ? 0.5 : 1.0) * missing * n;
            if (b)
                way[pair.b] -= (a ? 0.5 : 1.0) * missing * n;
        }
    }
    return way;
}

/// What the surfaces lack of their roughness, or of their distance if that is more, once the solids have gone their ways.
template <int D>
Standoff<D> standoff_of(const ClosePair<D>& pair, const std::vector<Solid<D>>& solids, const std::vector<Vec<D>>& way,
                        double dx)
{
    const auto& [place, n, distance] = pair.nearest;
    const double apart = pair.overlap() ? 0.0 : distance + n.dot(way[pair.a] - way[pair.b]);
    Standoff<D> standoff{std::max(0.0, std::max(pair.roughness, distance) - std::max(0.0, apart)) / dx, PairTwist<D>::Zero()};
    if (!pair.overlap() && distance < pair.roughness)
        standoff.rate << -wrench<D>(n, (place - solids[pair.a].centre) / dx),
            wrench<D>(n, (place - solids[pair.b].centre - pair.shift) / dx);
    return standoff;
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
    const auto pairs_within = [&](double reach) {
        std::vector<ClosePair<D>> pairs;
        for (const NearPair<D>& near : near_pairs<D>(all, grid.origin(), grid.origin() + grid.size(), period, reach)) {
            const Solid<D>&a = all[near.a], &b = all[near.b];
            if (still(a) && still(b) && !names_pair(scene, a.name, b.name))
                continue;
            const double roughness = roughness_of(scene, a.name, b.name);
            if (!(roughness > 0))
                continue;
            const std::optional<Separation<D>> found =
                separation<D>(a.shape, features_of(near.a), b.shape.shifted(near.shift), features_of(near.b), reach);
            if (found && found->distance < reach)
                pairs.push_back({near.a, near.b, *found, near.shift, roughness});
        }
        return pairs;
    };
    std::vector<ClosePair<D>> pairs;
    std::vector<Vec<D>> way;
    double reach = 0; // a stack's upper bodies go farther, and may meet others
    for (double needed = roughest; reach < needed;) {
        reach = needed;
        pairs = pairs_within(reach);
        way = set_apart<D>(pairs, 1e-3 * least_distance * roughest, all);
        for (const Vec<D>& one : way)
            needed = std::max(needed, least_distance * roughest + 2 * one.norm());
    }
    for (const ClosePair<D>& pair : pairs)
        if (const Standoff<D> standoff = standoff_of<D>(pair, all, way, dx); standoff.distance > 0)
            rough.standoffs.add(pair.a, pair.b, standoff);
    for (std::size_t s = 0; s < all.size(); ++s)
        if (!way[s].isZero(0)) {
            rough.solids[s].shape = rough.solids[s].shape.shifted(way[s]);
            rough.solids[s].centre += way[s];
        }
    put_into_planes(grid, rough.solids);
    return rough;
}

template RoughSolids<2> rough_solids<2>(const Scene&, const Grid<2>&, std::vector<Solid<2>>);
template RoughSolids<3> rough_solids<3>(const Scene&, const Grid<3>&, std::vector<Solid<3>>);

} // namespace gapflow
