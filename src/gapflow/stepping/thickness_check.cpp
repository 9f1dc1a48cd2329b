#include "gapflow/stepping/thickness_check.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/geometry/thickness.hpp"
#include "gapflow/stepping/gap_notes.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace gapflow {

namespace {

constexpr double least_cells = 1, enough_cells = 2;
constexpr double beside = 1e-3; // in cells: closer surfaces are flush
constexpr std::size_t most_told = 3;
constexpr double long_enough = 8; // cells along a thin body's surface
constexpr double end_error =
    0.34; // of a thin plate's added mass, times its length in cells: rows "Parts: thin plates" of the validation

template <int D>
bool near(const Bounds<D>& a, const Bounds<D>& b, double margin)
{
    if (!b.low.allFinite() || !b.high.allFinite())
        return true;
    return ((a.low.array() <= b.high.array() + margin) && (b.low.array() <= a.high.array() + margin)).all();
}

/// Distance to which solids extend beyond the surface point x along the unit vector n.
template <int D>
double goes_on(const std::vector<const Solid<D>*>& solids, const Vec<D>& x, const Vec<D>& n, double cell, double most)
{
    double way = 0;
    while (way < most) {
        double depth = -1;
        for (const Solid<D>* solid : solids)
            depth = std::max(depth, -solid->shape.distance(x + (way + beside * cell) * n));
        if (depth < 0)
            break;
        way += std::max(depth, 0.05 * cell);
    }
    return way;
}

/// Where a body's thickness matters: in the domain, for a body that moves also as far as the domain is wide from it, and everywhere along
/// an axis along which the grid moves. What is beyond a periodic side comes in on the other.
template <int D>
Bounds<D> seen(const Scene& scene, const Solid<D>& solid)
{
    const Vec<D> size = to_vec<D>(scene.size), origin = to_vec<D>(scene.origin);
    const Bounds<D> body = world_bounds(solid.shape);
    const double around = solid.motion == Motion::fixed ? 0.0 : size.maxCoeff();
    Bounds<D> seen{origin.array() - around, (origin + size).array() + around};
    for (int axis = 0; axis < D; ++axis)
        if (scene.follow && scene.follow->axes[axis]) {
            seen.low[axis] = Bounds<D>().low[axis];
            seen.high[axis] = Bounds<D>().high[axis];
        } else if (scene.sides[2 * axis].kind == SideScene::Kind::periodic) {
            const double middle = 0.5 * (body.low[axis] + body.high[axis]);
            seen.low[axis] = middle - 1.5 * size[axis];
            seen.high[axis] = middle + 1.5 * size[axis];
        }
    return seen;
}

template <int D>
std::string text_of(const ThinBody<D>& body)
{
    char number[32];
    std::snprintf(number, sizeof number, "%.3g", body.cells);
    return "body '" + body.name + "' is " + number + " cells thin at " + place_text<D>(body.at);
}

/// The grid on which the body is two cells thick.
std::string finer_grid(const Scene& scene, double cells)
{
    const double factor = std::ceil(enough_cells / cells);
    if (scene.core)
        return "domain.spacing = " + number_text(scene.spacing() / factor) + " or less";
    std::vector<std::string> counts;
    for (int axis = 0; axis < scene.dimension; ++axis)
        counts.push_back(number_text(factor * scene.cells[axis]));
    return "domain.cells = [" + joined(counts) + "] or more";
}

} // namespace

template <int D>
std::vector<ThinBody<D>> thin_bodies(const Scene& scene, const std::vector<RigidBody<D>>& bodies, const DomainWalls<D>& walls)
{
    const double cell = scene.spacing(), most = enough_cells * cell;
    const std::vector<Solid<D>> solids = make_solids<D>(bodies, walls);
    std::vector<ThinBody<D>> thin;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        std::vector<const Solid<D>*> beside; // one body with it
        const auto beyond = [&](const Vec<D>& x, const Vec<D>& n) { return goes_on(beside, x, n, cell, most); };
        const PlacedShape<D>& shape = solids[b].shape;
        const Bounds<D> within = seen<D>(scene, solids[b]);
        Thickness<D> found = sheet_thickness<D>(shape, cell, most, {}, within);
        if (found.value < (1 - 1e-6) * most && bodies[b].motion == Motion::fixed) {
            for (std::size_t s = 0; s < solids.size(); ++s)
                if (s != b && solids[s].motion == Motion::fixed &&
                    (solids[s].shape.shape().inside_out() || near(world_bounds(shape), world_bounds(solids[s].shape), most)))
                    beside.push_back(&solids[s]);
            if (!beside.empty())
                found = sheet_thickness<D>(shape, cell, most, beyond, within);
        }
        if (found.value < (1 - 1e-6) * most)
            thin.push_back({bodies[b].name, found.value / cell, found.at});
    }
    std::stable_sort(thin.begin(), thin.end(), [](const ThinBody<D>& a, const ThinBody<D>& b) { return a.cells < b.cells; });
    return thin;
}

namespace {

/// How far a thin body reaches along its surface, whichever way it lies in its own frame: its extent along the longest principal axis, in 3D along the
/// second longest.
template <int D>
double extent_along(const Shape<D>& shape, double cell)
{
    Mat<D> axes = Mat<D>::Identity();
    const std::vector<Vec<D>> points = shape.display_mesh(0.1 * cell).vertices;
    if constexpr (D == 3)
        axes = Eigen::SelfAdjointEigenSolver<Mat<3>>(shape.mass_properties().inertia).eigenvectors();
    else { // of the surface's points: a twist has one moment of inertia
        Vec<2> middle = Vec<2>::Zero();
        for (const Vec<2>& x : points)
            middle += x / static_cast<double>(points.size());
        Mat<2> square = Mat<2>::Zero();
        for (const Vec<2>& x : points)
            square += (x - middle) * (x - middle).transpose();
        axes = Eigen::SelfAdjointEigenSolver<Mat<2>>(square).eigenvectors();
    }
    std::array<double, D> extent;
    for (int k = 0; k < D; ++k) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Vec<D>& x : points) {
            low = std::min(low, axes.col(k).dot(x));
            high = std::max(high, axes.col(k).dot(x));
        }
        extent[k] = high - low;
    }
    std::sort(extent.begin(), extent.end());
    return extent[1];
}

template <int D>
std::vector<std::string> short_body_warnings(const Scene& scene, const std::vector<RigidBody<D>>& bodies,
                                             const DomainWalls<D>& walls)
{
    std::vector<std::string> warnings;
    for (const ThinBody<D>& thin : thin_bodies<D>(scene, bodies, walls)) {
        const auto body =
            std::find_if(bodies.begin(), bodies.end(), [&](const RigidBody<D>& b) { return b.name == thin.name; });
        const double cells = extent_along<D>(*body->shape, scene.spacing()) / scene.spacing();
        if (!(cells < long_enough))
            continue;
        char text[160];
        std::snprintf(
            text, sizeof text,
            "' is thin and %.3g cells long: its added mass errs by some %.2g %%; the error falls as the number of cells", cells,
            100 * end_error / cells);
        warnings.push_back("body '" + thin.name + text);
    }
    return warnings;
}

} // namespace

template <int D>
std::vector<std::string> thickness_warnings(const Scene& scene, const std::vector<RigidBody<D>>& bodies,
                                            const DomainWalls<D>& walls, Scene::Thin thin)
{
    if (scene.parts)
        return short_body_warnings<D>(scene, bodies, walls);
    std::vector<std::string> warnings;
    for (const ThinBody<D>& body : thin_bodies<D>(scene, bodies, walls)) {
        const std::string remedy = "use " + finer_grid(scene, body.cells) + ", or a thicker body";
        const bool unseen = body.cells < least_cells - 1e-6;
        if (unseen && thin == Scene::Thin::refuse)
            throw InputError(scene.file + ": " + text_of(body) +
                             ", and the fluid does not see what is thinner than a cell: forces would be wrong; " + remedy +
                             "; or write thin = \"allow\" in [grid] to compute it all the same");
        if (warnings.size() == most_told) {
            warnings.back() += "; so are other bodies";
            break;
        }
        warnings.push_back(text_of(body) +
                           (unseen ? ": the fluid does not see what is thinner than a cell; "
                                   : ": pressure leaks through what is thinner than two cells; ") +
                           remedy);
    }
    return warnings;
}

void require_thickness(const Scene& scene)
{
    if (scene.dimension == 2)
        thickness_warnings<2>(scene, make_bodies<2>(scene), make_walls<2>(scene), scene.thin);
    else
        thickness_warnings<3>(scene, make_bodies<3>(scene), make_walls<3>(scene), scene.thin);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<ThinBody<D>> thin_bodies<D>(const Scene&, const std::vector<RigidBody<D>>&, const DomainWalls<D>&);   \
    template std::vector<std::string> thickness_warnings<D>(const Scene&, const std::vector<RigidBody<D>>&,                    \
                                                            const DomainWalls<D>&, Scene::Thin);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
