#include "gapflow/film/rim_joints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gapflow {

namespace {

template <int D>
constexpr double joint_length = D == 2 ? 0.01 : 0.05; // film length whose resistance a joint has, in dx

} // namespace

template <int D>
RimJoints<D>::RimJoints(const Grid<D>& grid, std::span<const Film<D>> films, const std::vector<RimPoint<D>>& points)
    : grid_(grid), films_(films), points_(points)
{
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
        const RimPoint<D>& point = points_[i];
        Bin& bin = bins_[cell_number<D>(grid_.wrapped(grid_.cell_of(point.x)))];
        bin.points.push_back(i);
        bin.h = std::max(bin.h, point.h);
        largest_h_ = std::max(largest_h_, point.h);
        if (D == 3) {
            bin.edge = std::max(bin.edge, point.edge->length);
            longest_edge_ = std::max(longest_edge_, point.edge->length);
        }
    }
}

template <int D>
bool RimJoints<D>::add(const RimPoint<D>& point, double factor, double reach, std::vector<Joint<D>>& joints) const
{
    const RimPoint<D>* nearest = nullptr;
    double best = std::numeric_limits<double>::infinity();
    std::array<double, D - 1> best_shape{};
    std::vector<std::pair<double, const RimPoint<D>*>> ends; // 2D: the nearest of every film
    const Index<D> centre = grid_.cell_of(point.x);
    const double slack = 1e-9 * grid_.dx();
    const double furthest = factor * (point.h + largest_h_) + reach + slack + 0.5 * longest_edge_;
    const int cells = std::min(2, static_cast<int>(furthest / grid_.dx()) + 1);
    // In 3D the nearest alone is sought: `enough` is no less than its distance.
    double enough = std::numeric_limits<double>::infinity();
    const auto search = [&](const Index<D>& d, auto&& take) {
        const Bin* bin = bins_.find(cell_number<D>(grid_.wrapped(centre + d)));
        if (!bin || distance_to_cell(point.x, centre + d) >
                        std::min(factor * (point.h + bin->h) + reach + slack, enough + slack) + bin->edge)
            return;
        for (int i : bin->points) {
            const RimPoint<D>& other = points_[i];
            const double limit = factor * (point.h + other.h) + reach + slack;
            if (other.film == point.film || !near(point.x, other, std::min(limit, enough + slack)))
                continue;
            std::array<double, D - 1> shape = other.shape;
            if (const double distance = distance_to_rim(point.x, other, shape); distance <= limit)
                take(other, distance, shape);
        }
    };
    const auto shrink = [&](const RimPoint<D>&, double distance, const auto&) { enough = std::min(enough, distance); };
    if (D == 3)
        search(Index<D>::Zero(), shrink);
    for_each_index<D>(Index<D>::Constant(-cells), Index<D>::Constant(cells + 1), [&](const Index<D>& d) {
        search(d, [&](const RimPoint<D>& other, double distance, const std::array<double, D - 1>& shape) {
            if constexpr (D == 2) {
                const auto known =
                    std::find_if(ends.begin(), ends.end(), [&](const auto& e) { return e.second->film == other.film; });
                if (known == ends.end())
                    ends.emplace_back(distance, &other);
                else if (distance < known->first)
                    *known = {distance, &other};
            } else if (distance < best) {
                best = enough = distance;
                nearest = &other;
                best_shape = shape;
            }
        });
    });
    for (const auto& [distance, other] : ends)
        joints.push_back(tie(point, *other, other->shape));
    if (nearest)
        joints.push_back(tie(point, *nearest, best_shape));
    return !joints.empty();
}

template <int D>
double RimJoints<D>::distance_to_cell(const Vec<D>& x, const Index<D>& cell) const
{
    const Vec<D> low = grid_.corner(cell), high = grid_.corner(cell + Index<D>::Ones());
    return (low - x).cwiseMax(x - high).cwiseMax(0.0).norm();
}

// From the other point to x, or to its nearest image.
template <int D>
Vec<D> RimJoints<D>::towards(const Vec<D>& x, const RimPoint<D>& other) const
{
    return grid_.nearest_image(x - other.x);
}

// Can the other point's rim edge come within `reach` of x?
template <int D>
bool RimJoints<D>::near(const Vec<D>& x, const RimPoint<D>& other, double reach) const
{
    const double all = reach + (D == 3 ? other.edge->length : 0.0);
    return towards(x, other).squaredNorm() <= all * all;
}

// Distance from x to the other point's rim edge; `shape` becomes the edge's shape functions at the closest point.
template <int D>
double RimJoints<D>::distance_to_rim(const Vec<D>& x, const RimPoint<D>& other, std::array<double, D - 1>& shape) const
{
    Vec<D> to = towards(x, other);
    if constexpr (D == 3) {
        const FilmMesh<D>& mesh = films_[other.film].mesh;
        const Vec<D> along = mesh.mid[other.edge->nodes[1]] - mesh.mid[other.edge->nodes[0]];
        const double s = std::clamp(other.shape[1] + to.dot(along) / along.squaredNorm(), 0.0, 1.0);
        to -= (s - other.shape[1]) * along;
        shape = {1 - s, s};
    }
    return to.norm();
}

template <int D>
Joint<D> RimJoints<D>::tie(const RimPoint<D>& a, const RimPoint<D>& b, const std::array<double, D - 1>& shape_b) const
{
    const double conductance = a.length * std::min(a.h, b.h) / (joint_length<D> * grid_.dx());
    return {global_nodes(films_[a.film], a.edge->nodes), global_nodes(films_[b.film], b.edge->nodes), a.shape, shape_b,
            conductance};
}

template class RimJoints<2>;
template class RimJoints<3>;

} // namespace gapflow
