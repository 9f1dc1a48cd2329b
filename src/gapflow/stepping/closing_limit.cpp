#include "gapflow/stepping/closing_limit.hpp"

#include "gapflow/stepping/contact_rows.hpp"
#include "gapflow/stepping/film_reversal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

template <int D>
double limit_of_closing(const Model<D>& model, const State<D>& state, const std::vector<Solid<D>>& solids,
                        const std::vector<Twist<D>>& V, const std::vector<Twist<D>>& A, std::span<const GapArm<D>> arms,
                        double dt)
{
    const double dx = model.grid.dx(), part = model.scene.gap_cfl;
    Vec<D> period = Vec<D>::Zero();
    for (int axis = 0; axis < D; ++axis)
        period[axis] = model.grid.periodic(axis) ? model.grid.size()[axis] : 0.0;
    std::vector<double> way; // that a solid's surface goes at most
    for (std::size_t s = 0; s < solids.size(); ++s) {
        const double radius = bounding_radius<D>(world_bounds(solids[s].shape));
        const Twist<D> expected = dt * V[s].cwiseAbs() + 0.5 * dt * dt * A[s].cwiseAbs();
        const double turn = expected.template tail<spin_size<D>>().norm();
        way.push_back(expected.template head<D>().norm() +
                      (turn > 0 ? turn * std::min(radius, model.grid.size().norm()) : 0.0));
    }
    const auto reach = [&](int a, int b) { return (way[a] + way[b]) / part; };
    const double largest = way.empty() ? 0.0 : 2 * *std::max_element(way.begin(), way.end()) / part;
    const auto limit_to = [&](double thickness, int a, int b, const auto& rate) {
        const double hold = model.scene.held_distance(solids[a].name, solids[b].name),
                     h = std::max({thickness, hold, smallest_limiting_gap * dx}), tiny = std::numeric_limits<double>::min();
        dt = std::min({dt, part * h / std::max(rate(V), tiny), std::sqrt(2 * part * h / std::max(rate(A), tiny))});
    };
    const std::vector<ContactFeatures<D>>& features = state.contacts.features();
    for (const ContactPoint<D>& point :
         find_contacts<D>(solids, features, model.grid.origin(), model.grid.origin() + model.grid.size(), period, reach,
                          largest, 0.5 * dx)) {
        const RelativeRow<D> row = relative_row<D>(point, solids, point.normal);
        limit_to(point.distance, point.a, point.b, [&](const std::vector<Twist<D>>& twist) {
            return std::abs(row.a.dot(twist[point.a]) + row.b.dot(twist[point.b]));
        });
    }
    // Walls that turn about a contact close where their distance has no minimum.
    for (const GapArm<D>& arm : arms) {
        limit_to(arm.thickness * dx, arm.solid[0], arm.solid[1], [&](const std::vector<Twist<D>>& twist) {
            double sum = 0;
            for (int side = 0; side < 2; ++side) {
                const Twist<D> row = arm.opening.template segment<twist_size<D>>(side * twist_size<D>),
                               &own = twist[arm.solid[side]];
                sum += row.template head<D>().dot(own.template head<D>()) +
                       dx * row.template tail<spin_size<D>>().dot(own.template tail<spin_size<D>>());
            }
            return std::abs(sum);
        });
    }
    return model.grid.comm().min(dt);
}

template double limit_of_closing<2>(const Model<2>&, const State<2>&, const std::vector<Solid<2>>&,
                                    const std::vector<Twist<2>>&, const std::vector<Twist<2>>&, std::span<const GapArm<2>>,
                                    double);
template double limit_of_closing<3>(const Model<3>&, const State<3>&, const std::vector<Solid<3>>&,
                                    const std::vector<Twist<3>>&, const std::vector<Twist<3>>&, std::span<const GapArm<3>>,
                                    double);

} // namespace gapflow
