#include "gapflow/step/displaced.hpp"

#include "gapflow/complex/facet_cut.hpp"
#include "gapflow/stepping/following.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace gapflow {
namespace {

// To each side, over the width of a gap or a cell: of a gap's energy, which goes as its inverse, the difference misses the square of this. Less far, a wall
// that is nearly parallel to a plane of the grid and passes it is a spike.
constexpr double small_way = 0.05;

/// Ways of the solids to each side in cells.
struct Ways {
    double length;
    double radius; ///< by which an angle has the same way
    double of(int component, int dimension) const { return component < dimension ? length : length / radius; }
};

/// Of each solid and component: whether a face of the grid opens or closes on the way from one side to the other, by the derivative of its open area, faster than by a
/// ball of its radius. So it is where the round side of a cylinder or capsule has just passed a plane that it is parallel to: there the derivative is that of a root.
/// Collective.
template <int D>
std::vector<double> steep_components(const Placed<D>& at, const std::vector<Ways>& ways)
{
    constexpr int T = twist_size<D>;
    std::vector<double> steep(ways.size() * T, 0.0), radius; // negative: not round, or a ball
    for (std::size_t s = 0; s < ways.size(); ++s) {
        const auto bar = at.coupling.solids[s].shape.shape().round_bar();
        radius.push_back(bar ? bar->radius / at.coupling.grid->dx() : -1);
    }
    for (std::size_t k = 0; k < at.complex.pieces.size(); ++k) {
        const FacePiece<D>& piece = at.complex.pieces[k];
        if (!owns_face(*at.coupling.grid, piece.axis, at.complex.index.index(piece.face)))
            continue;
        for (const PieceRate<D>& rate : at.derivatives.of(k)) {
            if (rate.solid >= static_cast<int>(ways.size()) || radius[rate.solid] < 0)
                continue;
            const Ways& to = ways[rate.solid];
            const double most = 1 + (D == 3 ? 2 * std::numbers::pi * radius[rate.solid] * 2 * to.length : 0);
            for (int c = 0; c < T; ++c)
                if (!(std::abs(rate.area[c]) * 2 * to.of(c, D) < most))
                    steep[rate.solid * T + c] = 1;
        }
    }
    at.coupling.grid->comm().max(steep);
    return steep;
}

} // namespace

template <int D>
std::vector<Displaced<D>> displaced(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const Placed<D>& at)
{
    const bool circulation = at.rotational;
    const double dx = model.grid.dx();
    std::vector<double> has_mouth(bodies.size(), 0.0), less_width(bodies.size(), -1.0); // minus that of the gaps, or of a cell
    for (const auto& mouth : at.complex.mouths)
        if (model.grid.owns(model.grid.nearest_cell(model.grid.anchor() + dx * mouth.at)))
            for (const int solid : mouth.solid)
                if (solid >= 0 && solid < static_cast<int>(bodies.size()) && bodies[solid].motion == Motion::free)
                    has_mouth[solid] = 1;
    for (const GapArm<D>& arm : own_arms(at))
        for (const int solid : arm.solid)
            if (solid < static_cast<int>(bodies.size()))
                less_width[solid] = std::max(less_width[solid], -arm.thickness);
    model.grid.comm().max(has_mouth);
    model.grid.comm().max(less_width);
    const FollowedBody<D> followed = followed_body(model);
    const auto is_free = [&](int solid) {
        return solid < static_cast<int>(bodies.size()) && bodies[solid].motion == Motion::free;
    };
    const bool given_mouth =
        model.grid.comm().any(std::any_of(at.complex.mouths.begin(), at.complex.mouths.end(), [&](const auto& mouth) {
            return std::any_of(mouth.solid.begin(), mouth.solid.end(),
                               [&](int solid) { return solid >= 0 && !is_free(solid); });
        }));
    // A body with which the grid goes along the axis, displaced with it: all others are the other way. Where their forces are known, it has the reactions.
    const auto with_grid = [&](int solid, int component) {
        return solid == followed.body && component < D && followed.axes[component];
    };
    const auto terms = [&](int solid, int component, double way) {
        std::vector<RigidBody<D>> there = bodies;
        RigidBody<D>& body = there[solid];
        const Vec<D> centre = body.centre();
        if (with_grid(solid, component)) {
            for (int b = 0; b < static_cast<int>(there.size()); ++b)
                there[b].pose.position[component] -= b == solid ? 0.0 : way;
        } else if (component < D)
            body.pose.position[component] += way;
        else {
            Spin<D> angle = Spin<D>::Zero();
            angle[component - D] = way;
            place<D>(body, centre, rotation_of<D>(angle) * body.pose.rotation);
        }
        return EnergyTerms<D>(placed_for_energy(model, there, circulation), at);
    };
    // In places of the complex: else their rounding would be a part of the difference.
    const auto way_in_cells = [](double width) {
        return std::max(1.0, std::round(small_way * width / place_unit)) * place_unit;
    };
    std::vector<Ways> ways;
    for (std::size_t b = 0; b < bodies.size(); ++b)
        ways.push_back(
            {way_in_cells(-less_width[b]), std::max(bounding_radius(world_bounds(at.coupling.solids[b].shape)), dx) / dx});
    const std::vector<double> steep = steep_components(at, ways);
    std::vector<Displaced<D>> result;
    for (int solid = 0; solid < static_cast<int>(bodies.size()); ++solid)
        for (int component = 0; component < twist_size<D>; ++component) {
            const bool leads = with_grid(solid, component),
                       mouth = leads ? given_mouth && is_free(solid) : has_mouth[solid] > 0;
            if (!mouth && (leads || !(steep[solid * twist_size<D> + component] > 0)))
                continue;
            if (is_free(solid) && !(at.coupling.solids[solid].admissible.col(component).norm() > 0))
                continue;
            Ways to = ways[solid];
            if (leads)
                to.length = way_in_cells(-*std::max_element(less_width.begin(), less_width.end()));
            const double way = to.of(component, D) * (component < D ? dx : 1);
            result.push_back({solid, component, mouth, 2 * way, terms(solid, component, -way), terms(solid, component, way)});
        }
    return result;
}

template <int D>
std::vector<char> not_replaced(const std::vector<Displaced<D>>& displaced, std::size_t solids)
{
    std::vector<int> left(solids, twist_size<D>);
    for (const Displaced<D>& one : displaced)
        --left[one.solid];
    std::vector<char> any(solids);
    for (std::size_t s = 0; s < solids; ++s)
        any[s] = left[s] > 0;
    return any;
}

template <int D>
void replace_forces(const std::vector<Displaced<D>>& displaced, const PotentialFlow<D>& flow, std::vector<Twist<D>>& force)
{
    for (const Displaced<D>& one : displaced)
        force[one.solid][one.component] = (one.high.energy(flow) - one.low.energy(flow)) / one.way;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<Displaced<D>> displaced<D>(const Model<D>&, const std::vector<RigidBody<D>>&, const Placed<D>&);      \
    template std::vector<char> not_replaced<D>(const std::vector<Displaced<D>>&, std::size_t);                                 \
    template void replace_forces<D>(const std::vector<Displaced<D>>&, const PotentialFlow<D>&, std::vector<Twist<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
