#include "gapflow/stepping/core_check.hpp"

#include "gapflow/stepping/leaving.hpp"
#include "gapflow/stepping/short_text.hpp"

#include <cmath>

namespace gapflow {

namespace {

// Along which axis, and how far, a box reaches out of the core; empty: nowhere.
template <int D>
std::optional<std::string> reach_out(const Model<D>& model, const Vec<D>& low, const Vec<D>& high)
{
    const Scene& scene = model.scene;
    const Grid<D>& grid = model.grid;
    const double round_off = 1e-6 * scene.core->spacing;
    for (int axis = 0; axis < D; ++axis) {
        if (scene.sides[2 * axis].kind == SideScene::Kind::periodic)
            continue;
        const double core_low = grid.face_place(axis, grid.core_low()[axis]),
                     core_high = grid.face_place(axis, grid.core_high()[axis]);
        const bool at_low_side = scene.core->below[axis].empty(), at_high_side = scene.core->above[axis].empty();
        if ((at_low_side || low[axis] >= core_low - round_off) && (at_high_side || high[axis] <= core_high + round_off))
            continue;
        return std::string("from ") + short_text(low[axis]) + " to " + short_text(high[axis]) + " along " + "xyz"[axis] +
               ", the core from " + short_text(core_low) + " to " + short_text(core_high);
    }
    return {};
}

} // namespace

template <int D>
std::optional<std::string> outside_core(const Model<D>& model, const Coupling<D>& here, const std::vector<RigidBody<D>>& bodies)
{
    const Scene& scene = model.scene;
    if (!scene.core)
        return {};
    for (const RigidBody<D>& body : bodies) {
        if (body.motion == Motion::fixed)
            continue;
        const Bounds<D> own = body.shape->bounds();
        if (!own.low.allFinite() || !own.high.allFinite() || body.shape->inside_out())
            return "body '" + body.name + "' moves and has no bounds: it reaches out of the core";
        Bounds<D> extent = extent_of(body, 0);
        if (reach_out<D>(model, extent.low, extent.high))
            extent = extent_of(body, 0.1 * scene.core->spacing);
        if (const auto where = reach_out<D>(model, extent.low, extent.high))
            return "body '" + body.name + "' reaches out of the core: it lies " + *where;
    }
    for (const Film<D>& film : here.network.films)
        for (const Vec<D>& x : film.mesh.mid)
            if (const auto where = reach_out<D>(model, x, x))
                return "the gap between '" + here.solids[film.mesh.master].name + "' and '" +
                       here.solids[film.mesh.other].name + "' is a film outside the core: it lies " + *where;
    return {};
}

template std::optional<std::string> outside_core<2>(const Model<2>&, const Coupling<2>&, const std::vector<RigidBody<2>>&);
template std::optional<std::string> outside_core<3>(const Model<3>&, const Coupling<3>&, const std::vector<RigidBody<3>>&);

} // namespace gapflow
