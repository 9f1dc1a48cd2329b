// Distances of convex bodies by Gilbert's algorithm (SIAM J. Control 4, 1966): the point of a convex set that is nearest to the
// origin, by steps to the set's outermost points; each step gives a plane between origin and set, or none.
#include "gapflow/scene/crowd_room.hpp"

#include "gapflow/scene/body_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gapflow {

namespace {

constexpr int most_turns = 200;         // of Gilbert's algorithm
constexpr int most_bins = 64;           // along an axis, of the list of bodies
constexpr int rim_points = 64;          // of a cylinder's end
constexpr std::size_t few_points = 400; // of a mesh's hull

template <int D>
const Vec<D>& outermost(const Hull<D>& hull, const Vec<D>& direction)
{
    const Vec<D>* best = &hull.points.front();
    double most = best->dot(direction);
    for (const Vec<D>& x : hull.points)
        if (const double here = x.dot(direction); here > most) {
            most = here;
            best = &x;
        }
    return *best;
}

// The way from a point to the nearest point of a hull without its radius.
template <int D>
Vec<D> nearest_way(const Hull<D>& hull, const Vec<D>& x)
{
    Vec<D> v = hull.points.front() - x;
    for (int step = 0; step < most_turns; ++step) {
        const Vec<D> e = outermost<D>(hull, -v) - x - v;
        if (!(e.squaredNorm() > 0) || v.dot(e) > -1e-12 * v.squaredNorm())
            break;
        v += std::min(1.0, -v.dot(e) / e.squaredNorm()) * e;
    }
    return v;
}

// Of many points those that are outermost in some directions; the radius covers what the others stick out.
template <int D>
void thin_out(Hull<D>& hull)
{
    if (hull.points.size() <= few_points)
        return;
    Hull<D> few;
    constexpr int directions = 300;
    for (int k = 0; k < directions; ++k) {
        Vec<D> direction;
        if constexpr (D == 2) {
            const double angle = 2 * std::numbers::pi * k / directions;
            direction = {std::cos(angle), std::sin(angle)};
        } else { // on a spiral from pole to pole, evenly
            const double z = 1 - (2 * k + 1.0) / directions, angle = 2.399963229728653 * k, r = std::sqrt(1 - z * z);
            direction = {r * std::cos(angle), r * std::sin(angle), z};
        }
        const Vec<D>& x = outermost<D>(hull, direction);
        if (std::find(few.points.begin(), few.points.end(), x) == few.points.end())
            few.points.push_back(x);
    }
    for (const Vec<D>& x : hull.points)
        few.radius = std::max(few.radius, nearest_way<D>(few, x).norm());
    hull.points = std::move(few.points);
    hull.radius = few.radius;
}

template <int D>
void find_reach(Hull<D>& hull)
{
    hull.reach = 0;
    for (const Vec<D>& x : hull.points)
        hull.reach = std::max(hull.reach, x.norm() + hull.radius);
}

} // namespace

template <int D>
Hull<D> Hull<D>::turned(const Mat<D>& rotation, double factor) const
{
    Hull<D> result{{}, factor * radius, factor * reach};
    for (const Vec<D>& x : points)
        result.points.push_back(factor * (rotation * x));
    return result;
}

template <int D>
ShapeHull<D> hull_of(const BodyScene& body, const Shape<D>& shape)
{
    using Kind = BodyScene::ShapeKind;
    ShapeHull<D> result{{}, Vec<D>::Zero()};
    Hull<D>& hull = result.hull;
    const auto corners = [&](const Vec<D>& low, const Vec<D>& high) {
        for (int k = 0; k < 1 << D; ++k) {
            Vec<D> x;
            for (int axis = 0; axis < D; ++axis)
                x[axis] = (k >> axis) & 1 ? high[axis] : low[axis];
            hull.points.push_back(x);
        }
    };
    switch (body.shape) {
    case Kind::ball:
        hull.points = {Vec<D>::Zero()};
        hull.radius = body.radius;
        break;
    case Kind::capsule:
        hull.points = {-0.5 * body.length * unit<D>(0), 0.5 * body.length * unit<D>(0)};
        hull.radius = body.radius;
        break;
    case Kind::cylinder: // prism around it
        for (int k = 0; k < rim_points; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.5) / rim_points;
            const double outside = body.radius / std::cos(std::numbers::pi / rim_points);
            for (const double end : {-0.5, 0.5}) {
                Vec<D> x = end * body.length * unit<D>(0);
                x[1] = outside * std::cos(angle);
                x[D - 1] = outside * std::sin(angle);
                hull.points.push_back(x);
            }
        }
        break;
    case Kind::box:
    case Kind::half_space:
        corners(shape.bounds().low, shape.bounds().high);
        break;
    case Kind::mesh:
    case Kind::sheet: {
        const Bounds<D> bounds = shape.bounds();
        result.centre = 0.5 * (bounds.low + bounds.high);
        for (const Vec<D>& x : shape.display_mesh((bounds.high - bounds.low).norm()).vertices)
            hull.points.push_back(x - result.centre);
        thin_out<D>(hull);
        break;
    }
    }
    find_reach<D>(hull);
    return result;
}

template <int D>
bool apart(const Hull<D>& a, const Hull<D>& b, const Vec<D>& way, double distance)
{
    const double centres = way.norm();
    if (centres >= a.reach + b.reach + distance)
        return true;
    if (a.ball() && b.ball())
        return false;
    const double least = a.radius + b.radius + distance;
    Vec<D> v = way + b.points.front() - a.points.front();
    for (int step = 0; step < most_turns; ++step) {
        const double length = v.norm();
        if (length < least || !(length > 0))
            return false;
        const Vec<D> outer = way + outermost<D>(b, -v) - outermost<D>(a, v), e = outer - v;
        if (v.dot(outer) >= least * length)
            return true;
        if (!(e.squaredNorm() > 0))
            return false;
        v += std::clamp(-v.dot(e) / e.squaredNorm(), 0.0, 1.0) * e;
    }
    return false;
}

template <int D>
double Region<D>::volume() const
{
    if (kind == Kind::box)
        return (high - low).prod();
    if (kind == Kind::cylinder)
        return std::numbers::pi * radius * radius * length;
    return D == 2 ? std::numbers::pi * radius * radius : 4.0 / 3 * std::numbers::pi * radius * radius * radius;
}

template <int D>
bool Region<D>::holds(const Hull<D>& hull, const Vec<D>& at) const
{
    const double round_off = 1e-12 * (low.cwiseAbs() + high.cwiseAbs()).sum(); // inside() puts balls on the region's surface
    return std::all_of(hull.points.begin(), hull.points.end(), [&](const Vec<D>& from_centre) {
        const Vec<D> x = at + from_centre;
        const double size = hull.radius - round_off;
        if (kind == Kind::box) {
            for (int i = 0; i < D; ++i)
                if (!endless[i] && (x[i] - size < low[i] || x[i] + size > high[i]))
                    return false;
            return true;
        }
        if (kind == Kind::ball)
            return (x - centre).norm() + size <= radius;
        const double along = (x - centre).dot(axis);
        return std::abs(along) + size <= 0.5 * length && (x - centre - along * axis).norm() + size <= radius;
    });
}

template <int D>
Vec<D> Region<D>::inside(double margin, Vec<D> at) const
{
    if (kind == Kind::box) {
        for (int i = 0; i < D; ++i)
            if (!endless[i])
                at[i] = std::max(low[i] + margin, std::min(high[i] - margin, at[i]));
        return at;
    }
    Vec<D> across = at - centre, along = Vec<D>::Zero();
    if (kind == Kind::cylinder) {
        const double s = across.dot(axis), most = 0.5 * length - margin;
        across -= s * axis;
        along = std::max(-most, std::min(most, s)) * axis;
    }
    if (const double far = across.norm(); far > radius - margin)
        across *= std::max(radius - margin, 0.0) / far;
    return centre + along + across;
}

template <int D>
CrowdRoom<D>::CrowdRoom(const Scene& scene)
    : low_(to_vec<D>(scene.origin)), size_(to_vec<D>(scene.size)), period_(Vec<D>::Zero()), in_cell_(1)
{
    for (int side = 0; side < 2 * D; ++side) {
        const int axis = side / 2;
        if (scene.sides[side].kind == SideScene::Kind::periodic) {
            period_[axis] = size_[axis];
            continue;
        }
        const double sign = side % 2 == 0 ? 1 : -1;
        walls_.push_back(
            {axis, sign, sign * (low_[axis] + (side % 2) * size_[axis]), scene.sides[side].kind == SideScene::Kind::wall});
    }
    for (const BodyScene& body : scene.bodies) {
        std::unique_ptr<Shape<D>> shape = make_shape<D>(body);
        const Pose<D> pose = start_pose<D>(body);
        const PlacedShape<D> placed(*shape, pose);
        const Bounds<D> bounds = shape->bounds();
        const bool bounded = bounds.low.allFinite() && bounds.high.allFinite();
        Vec<D> at = bounded ? placed.to_world(0.5 * (bounds.low + bounds.high)) : pose.position;
        Hull<D> hull;
        if (bounded && !body.inside_out && shape->convex() && body.shape != BodyScene::ShapeKind::half_space &&
            body.shape != BodyScene::ShapeKind::mesh && body.shape != BodyScene::ShapeKind::sheet) {
            const ShapeHull<D> own = hull_of<D>(body, *shape);
            at = placed.to_world(own.centre);
            hull = own.hull.turned(placed.rotation(), 1);
        }
        solids_.push_back({std::move(shape), placed, std::move(hull), at});
    }
}

template <int D>
void CrowdRoom<D>::expect(double reach, double spacing)
{
    spacing_ = spacing;
    reach_ = std::max(reach_, reach);
    for (int axis = 0; axis < D; ++axis)
        cells_[axis] =
            std::clamp(static_cast<int>(std::min(size_[axis] / (2 * reach_ + spacing), 1.0 * most_bins)), 1, most_bins);
    in_cell_.assign(static_cast<std::size_t>(cells_.prod()), {});
    for (int body = 0; body < count(); ++body)
        sort_in(body);
}

template <int D>
Vec<D> CrowdRoom<D>::wrapped(Vec<D> at) const
{
    for (int axis = 0; axis < D; ++axis)
        if (period_[axis] > 0) {
            at[axis] -= period_[axis] * std::floor((at[axis] - low_[axis]) / period_[axis]);
            if (at[axis] >= low_[axis] + period_[axis]) // rounded up
                at[axis] = low_[axis];
        }
    return at;
}

template <int D>
Vec<D> CrowdRoom<D>::way(const Vec<D>& from, const Vec<D>& to) const
{
    Vec<D> d = to - from;
    for (int axis = 0; axis < D; ++axis)
        if (period_[axis] > 0)
            d[axis] -= period_[axis] * std::floor(d[axis] / period_[axis] + 0.5);
    return d;
}

template <int D>
int CrowdRoom<D>::cell_of(const Vec<D>& at) const
{
    const Vec<D> place = wrapped(at);
    int number = 0;
    for (int axis = D - 1; axis >= 0; --axis)
        number = number * cells_[axis] +
                 std::clamp(static_cast<int>((place[axis] - low_[axis]) / size_[axis] * cells_[axis]), 0, cells_[axis] - 1);
    return number;
}

template <int D>
void CrowdRoom<D>::sort_in(int body)
{
    Body& b = bodies_[static_cast<std::size_t>(body)];
    b.cell = cell_of(b.at);
    in_cell_[static_cast<std::size_t>(b.cell)].push_back(body);
}

template <int D>
void CrowdRoom<D>::take_out(int body)
{
    std::erase(in_cell_[static_cast<std::size_t>(bodies_[static_cast<std::size_t>(body)].cell)], body);
}

template <int D>
int CrowdRoom<D>::add(Hull<D> hull, const Vec<D>& at)
{
    bodies_.push_back({std::move(hull), at, 0});
    sort_in(count() - 1);
    return count() - 1;
}

template <int D>
void CrowdRoom<D>::move(int body, const Vec<D>& at)
{
    take_out(body);
    bodies_[static_cast<std::size_t>(body)].at = at;
    sort_in(body);
}

template <int D>
void CrowdRoom<D>::cut_back(int count)
{
    for (int body = count; body < this->count(); ++body)
        take_out(body);
    bodies_.resize(static_cast<std::size_t>(count));
}

namespace {

// Calls visit(d) for a way and its images one period to either side; false as soon as one call is.
template <int D, class Visit>
bool for_images(const Vec<D>& way, const Vec<D>& period, double range, Visit visit)
{
    Index<D> first, last, k;
    for (int axis = 0; axis < D; ++axis) {
        const bool far = period[axis] > 0 && std::abs(way[axis]) + range >= period[axis];
        first[axis] = far ? -1 : 0;
        last[axis] = far ? 1 : 0;
    }
    for (k = first;;) {
        if (!visit(Vec<D>(way + k.template cast<double>().cwiseProduct(period))))
            return false;
        int axis = 0;
        while (axis < D && ++k[axis] > last[axis]) {
            k[axis] = first[axis];
            ++axis;
        }
        if (axis == D)
            return true;
    }
}

// Whether the hull at `at` is certainly `distance` from a solid: boxes around the hull are halved until the solid's distance from
// their centres tells, or they are a fiftieth of the hull; the latter count as too near.
template <int D>
bool clear_of(const PlacedShape<D>& solid, const Hull<D>& hull, const Vec<D>& at, double distance)
{
    if (const double d = solid.distance(at); hull.ball() || d >= hull.reach + distance || d < distance)
        return d >= hull.reach + distance;
    const double least = 0.02 * hull.reach;
    struct Box {
        Vec<D> centre; ///< from the hull's
        double half;
    };
    std::vector<Box> open{{Vec<D>::Zero(), hull.reach}};
    while (!open.empty()) {
        const Box box = open.back();
        open.pop_back();
        const double corner = box.half * std::sqrt(1.0 * D);
        if (solid.distance(at + box.centre) - corner >= hull.radius + distance)
            continue;
        const Hull<D> ball{{Vec<D>::Zero()}, corner, corner};
        const Hull<D> core{hull.points, 0, hull.reach};
        if (apart<D>(core, ball, box.centre, 0))
            continue;
        if (box.half < least)
            return false;
        for (int k = 0; k < 1 << D; ++k) {
            Vec<D> centre = box.centre;
            for (int axis = 0; axis < D; ++axis)
                centre[axis] += ((k >> axis) & 1 ? 0.5 : -0.5) * box.half;
            open.push_back({centre, 0.5 * box.half});
        }
    }
    return true;
}

} // namespace

template <int D>
bool CrowdRoom<D>::free_of_walls(const Hull<D>& hull, const Vec<D>& at) const
{
    return std::all_of(walls_.begin(), walls_.end(), [&](const Wall& wall) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec<D>& x : hull.points)
            nearest = std::min(nearest, wall.sign * (at[wall.axis] + x[wall.axis]));
        return nearest - hull.radius >= wall.offset + (wall.closed ? spacing_ : 0);
    });
}

template <int D>
bool CrowdRoom<D>::free_of_hull(const Hull<D>& other, const Vec<D>& place, const Hull<D>& hull, const Vec<D>& at) const
{
    return for_images<D>(way(at, place), period_, hull.reach + other.reach + spacing_,
                         [&](const Vec<D>& d) { return apart<D>(hull, other, d, spacing_); });
}

template <int D>
bool CrowdRoom<D>::free_of_solid(const Solid& solid, const Hull<D>& hull, const Vec<D>& at) const
{
    if (!solid.hull.points.empty())
        return free_of_hull(solid.hull, solid.at, hull, at);
    const Bounds<D> bounds = solid.shape->bounds();
    if (!bounds.low.allFinite() || !bounds.high.allFinite())
        return clear_of<D>(solid.placed, hull, at, spacing_);
    const double range = hull.reach + 0.5 * (bounds.high - bounds.low).norm() + spacing_;
    return for_images<D>(way(solid.at, at), period_, range,
                         [&](const Vec<D>& d) { return clear_of<D>(solid.placed, hull, solid.at + d, spacing_); });
}

template <int D>
bool CrowdRoom<D>::free(const Hull<D>& hull, const Vec<D>& at, int except) const
{
    if (!free_of_walls(hull, at))
        return false;
    for (int axis = 0; axis < D; ++axis) // its own images
        if (period_[axis] > 0 && 2 * hull.reach + spacing_ > period_[axis] &&
            !apart<D>(hull, hull, Vec<D>(period_[axis] * unit<D>(axis)), spacing_))
            return false;
    bool result = true;
    near(at, [&](int body) {
        const Body& other = bodies_[static_cast<std::size_t>(body)];
        if (result && body != except)
            result = free_of_hull(other.hull, other.at, hull, at);
    });
    return result &&
           std::all_of(solids_.begin(), solids_.end(), [&](const Solid& solid) { return free_of_solid(solid, hull, at); });
}

template <int D>
double CrowdRoom<D>::push_out(double radius, double spacing, Vec<D>& at) const
{
    double deepest = 0;
    for (const Solid& solid : solids_) {
        // The images of a large body may reach further: what is left of them, free() finds.
        const Bounds<D> bounds = solid.shape->bounds();
        const bool bounded = bounds.low.allFinite() && bounds.high.allFinite();
        const Vec<D> image = bounded ? Vec<D>(solid.at + way(solid.at, at)) : at;
        const SurfacePoint<D> nearest = solid.placed.closest(image);
        const double depth = radius + spacing - nearest.distance;
        if (depth > 0) {
            at += depth * nearest.normal;
            deepest = std::max(deepest, depth);
        }
    }
    for (const Wall& wall : walls_) {
        const double depth = radius + (wall.closed ? spacing : 0) + wall.offset - wall.sign * at[wall.axis];
        if (depth > 0) {
            at[wall.axis] += wall.sign * depth;
            deepest = std::max(deepest, depth);
        }
    }
    return deepest;
}

template <int D>
Vec<D> CrowdRoom<D>::shift_from(int body, double radius, double spacing, const Vec<D>& at) const
{
    const Body& other = bodies_[static_cast<std::size_t>(body)];
    const Vec<D> from = way(other.at, at); // the ball, seen from the body
    Vec<D> out = from;
    if (!other.hull.ball()) {
        out = -nearest_way<D>(other.hull, from);
        if (out.norm() < 1e-3 * other.hull.reach) // in it
            out = from;
    }
    const double length = out.norm(), depth = radius + other.hull.radius + spacing - length;
    if (depth <= 0)
        return Vec<D>::Zero();
    return length > 0 ? Vec<D>(depth / length * out) : Vec<D>(depth * unit<D>(body % D));
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template struct Hull<D>;                                                                                                   \
    template struct Region<D>;                                                                                                 \
    template class CrowdRoom<D>;                                                                                               \
    template ShapeHull<D> hull_of<D>(const BodyScene&, const Shape<D>&);                                                       \
    template bool apart<D>(const Hull<D>&, const Hull<D>&, const Vec<D>&, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
