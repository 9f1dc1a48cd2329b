#include "gapflow/stepping/placement.hpp"

#include "gapflow/body/forces.hpp"
#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/stepping/contact_set.hpp"

#include <algorithm>
#include <cstdio>

namespace gapflow {

namespace {

template <int D>
bool bounded(const RigidBody<D>& body)
{
    const Bounds<D> bounds = body.shape->bounds();
    return bounds.low.allFinite() && bounds.high.allFinite() && !(bounds.low.array() > bounds.high.array()).any();
}

constexpr int most_passes = 200;    // that take overlaps out
constexpr double seen = 1e-6;       // in cells: overlaps that are round-off
constexpr double left_alone = 1e-2; // in cells: overlap of wedged bodies that is not reported
constexpr std::size_t most_named = 6;

/// Vertices of a body's surface and its centre in the world, and the box that holds them.
template <int D>
struct Surface {
    std::vector<Vec<D>> points; ///< none of a shape without bounds
    Vec<D> low, high;
    bool solid_inside = true;
};

template <int D>
Surface<D> surface_of(const RigidBody<D>& body, double tolerance)
{
    Surface<D> surface;
    surface.solid_inside = !body.shape->complement();
    if (!bounded(body))
        return surface;
    const Mat<D> rotation = body.pose.matrix();
    for (const Vec<D>& x : body.shape->display_mesh(tolerance).vertices)
        surface.points.push_back(body.pose.position + rotation * x);
    if (body.shape->distance(body.centre_of_mass) < 0) // finds bodies of one shape at one place
        surface.points.push_back(body.centre());
    surface.low = surface.high = surface.points.front();
    for (const Vec<D>& x : surface.points) {
        surface.low = surface.low.cwiseMin(x);
        surface.high = surface.high.cwiseMax(x);
    }
    return surface;
}

/// Of solids with bounds: whether their boxes have nothing in common.
template <int D>
bool apart(const Surface<D>& a, const Surface<D>& b)
{
    if (a.points.empty() || b.points.empty() || !a.solid_inside || !b.solid_inside)
        return false;
    return (a.low.array() > b.high.array()).any() || (b.low.array() > a.high.array()).any();
}

/// Sides of the domain that a surface is wholly beyond, 2 * axis + end; what is beyond a periodic one comes in on the other, and what is above a water
/// level may fall in.
template <int D>
std::vector<int> sides_before(const Surface<D>& surface, const Scene& scene)
{
    std::vector<int> sides;
    for (int axis = 0; axis < D && !surface.points.empty() && surface.solid_inside; ++axis) {
        const double low = scene.origin[axis], high = low + scene.size[axis];
        const auto ends = [&](int end) {
            const SideScene::Kind kind = scene.sides[2 * axis + end].kind;
            return kind != SideScene::Kind::periodic && kind != SideScene::Kind::surface;
        };
        if (ends(0) && surface.high[axis] < low)
            sides.push_back(2 * axis);
        if (ends(1) && surface.low[axis] > high)
            sides.push_back(2 * axis + 1);
    }
    return sides;
}

/// Whether a free body beyond these sides can come in: fluid passes there, and it moves or is pulled that way.
template <int D>
bool comes_in(const RigidBody<D>& body, const std::vector<int>& sides, const Scene& scene)
{
    const Twist<D> force = explicit_wrench<D>(body, to_vec<D>(scene.gravity), scene.density) + spring_wrench(body);
    return std::all_of(sides.begin(), sides.end(), [&](int side) {
        const double inward = side % 2 == 0 ? 1 : -1;
        return scene.sides[side].kind != SideScene::Kind::wall &&
               (inward * body.twist[side / 2] > 0 || inward * force[side / 2] > 0);
    });
}

/// Depth in a solid of the deepest point of a surface; 0 if no point lies in it.
template <int D>
double depth_in(const Solid<D>& solid, const Surface<D>& surface)
{
    double deepest = 0;
    for (const Vec<D>& x : surface.points)
        deepest = std::max(deepest, -solid.shape.closest(x).distance);
    return deepest;
}

/// Whether no part of a surface is seen outside a solid; not of a container's, whose solid is around it.
template <int D>
bool lies_in(const Solid<D>& solid, const Surface<D>& surface, double dx)
{
    return !surface.points.empty() && surface.solid_inside &&
           std::all_of(surface.points.begin(), surface.points.end(),
                       [&](const Vec<D>& x) { return solid.shape.closest(x).distance <= seen * dx; });
}

/// A free body beyond the sides that stays there moves in nothing, and of two solids in one place, one of them free, neither way out is meant.
template <int D>
void refuse_places(const Scene& scene, const std::vector<RigidBody<D>>& bodies, const std::vector<Solid<D>>& solids,
                   const std::vector<Surface<D>>& surfaces)
{
    for (std::size_t a = 0; a < bodies.size(); ++a) {
        const std::vector<int> beyond = sides_before(surfaces[a], scene);
        if (bodies[a].motion == Motion::free && !beyond.empty() && !comes_in(bodies[a], beyond, scene))
            throw InputError(scene.file + ": body '" + bodies[a].name +
                             "' lies outside the domain, where there is no fluid; put it inside, or remove it");
        for (std::size_t b = a + 1; b < bodies.size(); ++b) {
            if ((bodies[a].motion != Motion::free && bodies[b].motion != Motion::free) || apart(surfaces[a], surfaces[b]))
                continue;
            const bool in = lies_in(solids[b], surfaces[a], scene.spacing()),
                       around = lies_in(solids[a], surfaces[b], scene.spacing());
            const std::string first = "'" + bodies[a].name + "'", second = "'" + bodies[b].name + "'";
            if (in || around)
                throw InputError(scene.file + ": " +
                                 (in && around ? first + " and " + second + " are in one place"
                                               : (in ? first : second) + " lies wholly inside " + (in ? second : first)) +
                                 "; move one of them, or remove it");
        }
    }
}

/// Asks for the unit of a mesh that is more than ten times as wide as the domain (in millimetres it is some 1000 times as wide as it should
/// be); empty: it is not.
template <int D>
std::string unit_question(const Scene& scene, const std::vector<RigidBody<D>>& bodies, std::size_t body)
{
    if (body >= bodies.size() || scene.bodies[body].shape != BodyScene::ShapeKind::mesh)
        return {};
    const Bounds<D> bounds = bodies[body].shape->bounds();
    const double wider = (bounds.high - bounds.low).maxCoeff() / to_vec<D>(scene.size).maxCoeff();
    if (!(wider > 10))
        return {};
    char times[32];
    std::snprintf(times, sizeof times, "%.3g", wider);
    return "body '" + bodies[body].name + "' is " + times +
           " times as wide as the domain: is its file in millimetres? then scale = " +
           number_text(1e-3 * scene.bodies[body].mesh_scale);
}

} // namespace

template <int D>
std::vector<std::string> placement_warnings(const Scene& scene, const std::vector<RigidBody<D>>& bodies,
                                            const DomainWalls<D>& walls)
{
    const double dx = scene.spacing();
    const std::vector<Solid<D>> solids = make_solids<D>(bodies, walls);
    std::vector<Surface<D>> surfaces;
    for (const RigidBody<D>& body : bodies)
        surfaces.push_back(surface_of(body, 0.1 * dx));
    refuse_places(scene, bodies, solids, surfaces);

    std::vector<std::string> warnings;
    for (std::size_t a = 0; a < bodies.size(); ++a) {
        if (std::string question = unit_question(scene, bodies, a); !question.empty())
            warnings.push_back(std::move(question));
        if (!sides_before(surfaces[a], scene).empty())
            warnings.push_back(
                "body '" + bodies[a].name + "' lies outside the domain, where there is no fluid; " +
                (bodies[a].motion == Motion::fixed ? "put it inside, or remove it" : "its motion should bring it in"));
        for (std::size_t b = a + 1; b < solids.size(); ++b) {
            const bool is_body = b < bodies.size();
            const bool free = bodies[a].motion == Motion::free || (is_body && bodies[b].motion == Motion::free);
            if ((!is_body && !free) || (is_body && apart(surfaces[a], surfaces[b])))
                continue;
            double depth = depth_in(solids[b], surfaces[a]);
            if (is_body)
                depth = std::max(depth, depth_in(solids[a], surfaces[b]));
            if (!(depth > dx))
                continue;
            char text[64];
            std::snprintf(text, sizeof text, "overlap by %.3g (%.3g cells) at the start; ", depth, depth / dx);
            warnings.push_back("'" + bodies[a].name + "' and '" + solids[b].name + "' " + text +
                               (free ? "contact will push them apart: better move them" : "they count as one solid there"));
        }
    }
    return warnings;
}

template <int D>
std::vector<std::string> take_out_overlaps(const Scene& scene, const Grid<D>& grid, std::vector<RigidBody<D>>& bodies,
                                           const DomainWalls<D>& walls)
{
    const double dx = grid.dx();
    std::vector<Solid<D>> solids = make_solids<D>(bodies, walls);
    ContactSet<D> contacts(scene, grid, solids);
    const std::vector<Twist<D>> rest(solids.size(), Twist<D>::Zero());
    const Contact<D>* deepest = nullptr; // a pointer into the contacts as they are
    auto find = [&] {
        contacts.find(solids, rest, 0);
        deepest = nullptr;
        for (const Contact<D>& c : contacts.contacts())
            if (!deepest || c.point.distance < deepest->point.distance)
                deepest = &c;
        return deepest ? -deepest->point.distance : 0.0;
    };
    double overlap = find();
    if (!(overlap > seen * dx))
        return {};
    char text[64];
    auto cells = [&](double length) {
        std::snprintf(text, sizeof text, "%.3g cells", length / dx);
        return std::string(text);
    };
    auto pair = [&] { return "'" + solids[deepest->point.a].name + "' and '" + solids[deepest->point.b].name + "'"; };
    const std::string start = pair() + " by " + cells(overlap);
    const std::vector<RigidBody<D>> before = bodies;
    for (int pass = 0; pass < most_passes && contacts.separate(bodies, true); ++pass) {
        solids = make_solids<D>(bodies, walls);
        overlap = find();
    }
    if (overlap > dx) {
        std::string text = scene.file + ": " + pair() + " overlap by " + cells(overlap) +
                           " at the start, and cannot be pushed apart; move them";
        for (const int solid : {deepest->point.a, deepest->point.b})
            if (const std::string question = unit_question(scene, bodies, static_cast<std::size_t>(solid)); !question.empty())
                text += "; " + question;
        throw InputError(text);
    }
    std::vector<std::pair<double, std::string>> moves; // longest first
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (const double way = (bodies[b].centre() - before[b].centre()).norm(); way > seen * dx)
            moves.emplace_back(-way, bodies[b].name);
    std::stable_sort(moves.begin(), moves.end(), [](const auto& p, const auto& q) { return p.first < q.first; });
    std::vector<std::string> named;
    for (std::size_t i = 0; i < std::min(moves.size(), most_named); ++i)
        named.push_back("'" + moves[i].second + "' " + cells(-moves[i].first));
    if (moves.size() > most_named)
        named.push_back(std::to_string(moves.size() - most_named) + " more");
    std::vector<std::string> notes;
    notes.push_back("bodies overlap at the start (most " + start + ") and were pushed apart before it: moved by " +
                    joined(named, ", ") + "; better place them so that they do not overlap");
    if (overlap > left_alone * dx)
        notes.push_back(pair() + " still overlap by " + cells(overlap) + ": nothing there can give way; move them");
    return notes;
}

template std::vector<std::string> placement_warnings<2>(const Scene&, const std::vector<RigidBody<2>>&, const DomainWalls<2>&);
template std::vector<std::string> placement_warnings<3>(const Scene&, const std::vector<RigidBody<3>>&, const DomainWalls<3>&);

template std::vector<std::string> take_out_overlaps<2>(const Scene&, const Grid<2>&, std::vector<RigidBody<2>>&,
                                                       const DomainWalls<2>&);
template std::vector<std::string> take_out_overlaps<3>(const Scene&, const Grid<3>&, std::vector<RigidBody<3>>&,
                                                       const DomainWalls<3>&);

} // namespace gapflow
