// Clips single faces: which solids reach a face, its parts, and their centroids. The cutting is in clip_segment.cpp (2D) and
// clip_square.cpp (3D). A signed distance is 1-Lipschitz, so with r the half diagonal of the face and phi at its centre a
// solid with phi > r misses it, and one with phi > phi_min + 2 r is nowhere the deepest. Method, "Face fractions".
#include "gapflow/grid/face_clipper_data.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace gapflow {

namespace {

constexpr double negligible = 1e-12; // open fractions below this are 0
// Surfaces within this of a grid plane (in dx) count as on it, and openings below it beside a single solid are closed: otherwise
// the round-off of the position of a body aligned with the grid would open and close whole faces.
constexpr double alignment = 1e-6;
constexpr double well_conditioned = 1e-3; // open fractions above this get their centroid from the balance of moments

template <int D>
std::array<int, D - 1> tangents_of(int axis)
{
    if constexpr (D == 2)
        return {1 - axis};
    else
        return {(axis + 1) % 3, (axis + 2) % 3};
}

template <int D>
std::vector<Plane<D>> world_planes(const PlacedShape<D>& shape)
{
    std::vector<Plane<D>> planes = shape.shape().planes();
    for (Plane<D>& plane : planes) {
        const Vec<D> on_plane = shape.to_world(plane.offset * plane.normal);
        plane.normal = shape.rotation() * plane.normal;
        plane.offset = plane.normal.dot(on_plane);
    }
    return planes;
}

// Side of the domain that a wall closes, by its position and normal; -1: none.
template <int D>
int side_of_wall(const Grid<D>& grid, const Plane<D>& plane)
{
    const Vec<D> far_corner = grid.origin() + grid.size();
    for (int side = 0; side < 2 * D; ++side) {
        const int axis = side / 2, end = side % 2;
        if (std::abs(plane.normal[axis] - (end ? -1 : 1)) < 1e-9 &&
            std::abs(plane.offset - plane.normal.dot(end ? far_corner : grid.origin())) < 1e-6 * grid.dx())
            return side;
    }
    return -1;
}

} // namespace

template <int D>
FaceClipper<D>::Data::Data(const Grid<D>& grid_, std::span<const Solid<D>> solids, FractionMode mode_)
    : grid(grid_), mode(mode_)
{
    const Vec<D> low = grid.origin(), high = grid.origin() + grid.size();
    tolerance = alignment * grid.dx() +
                16 * std::numeric_limits<double>::epsilon() * low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff();

    Vec<D> period = Vec<D>::Zero();
    for (int axis = 0; axis < D; ++axis)
        if (grid.periodic(axis))
            period[axis] = grid.size()[axis];
    // Bins reach 15 cells past the domain at most.
    images = gapflow::images<D>(solids, low, high, period, 16 * grid.dx());
    std::erase_if(images, [](const Image<D>& image) { return image.shape.shape().inside_out() && !image.shift.isZero(0); });

    std::vector<int> order(solids.size()), rank_of_solid(solids.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return solids[a].name < solids[b].name; });
    for (std::size_t k = 0; k < order.size(); ++k)
        rank_of_solid[order[k]] = static_cast<int>(k);

    wall_of_side.fill(-1);
    for (int i = 0; i < static_cast<int>(images.size()); ++i) {
        const Solid<D>& solid = solids[images[i].solid];
        centres.push_back(solid.centre + images[i].shift);
        planes.push_back(world_planes(images[i].shape));
        rank.push_back(rank_of_solid[images[i].solid]);
        wall.push_back(solid.wall);
        if (!solid.wall)
            continue;
        const int side = planes[i].size() == 1 ? side_of_wall(grid, planes[i][0]) : -1;
        if (side < 0)
            throw std::logic_error("wall '" + solid.name + "' is not a half-space on a side of the domain");
        wall_of_side[side] = i;
    }
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end) {
            int& image = wall_of_side[2 * axis + end];
            if (grid.side(axis, end) != SideKind::wall)
                image = -1;
            else if (image < 0)
                throw std::logic_error("a closed side of the domain has no wall among the solids");
        }
    bins = ImageBins<D>(grid, images);
}

template <int D>
bool FaceClipper<D>::Data::nearer(double phi_a, int a, double phi_b, int b) const
{
    return std::abs(phi_a - phi_b) <= tolerance ? rank[a] < rank[b] : phi_a < phi_b;
}

template <int D>
void FaceClipper<D>::Data::add_part(int image, double fraction, const Vec<D>& centroid, ClippedFace<D>& result) const
{
    result.solid.push_back({images[image].solid, fraction, centroid, centroid - centres[image]});
}

template <int D>
int FaceClipper<D>::Data::clip(int axis, const Index<D>& face, ClippedFace<D>& result) const
{
    const Index<D> wrapped = grid.wrapped(face);
    result.open = 1;
    result.open_centroid = grid.face_centre(axis, wrapped);
    result.solid.clear();
    int whole = wall_at(axis, wrapped);
    if (whole >= 0) {
        result.open = 0;
        add_part(whole, 1, result.open_centroid, result);
    } else {
        whole = mode == FractionMode::cut_cell ? clip_cut_cell(axis, wrapped, result) : clip_voxel(axis, wrapped, result);
    }
    if (face != wrapped) {
        const Vec<D> shift = grid.dx() * (face - wrapped).template cast<double>();
        result.open_centroid += shift;
        for (SolidPart<D>& part : result.solid)
            part.centroid += shift;
    }
    if (const double area = grid.relative_area(axis, wrapped); area != 1) {
        result.open *= area;
        for (SolidPart<D>& part : result.solid)
            part.fraction *= area;
    }
#ifndef NDEBUG
    double sum = result.open;
    for (const SolidPart<D>& part : result.solid)
        sum += part.fraction;
    assert(std::abs(sum / grid.relative_area(axis, wrapped) - 1) < 1e-12);
#endif
    return whole;
}

template <int D>
int FaceClipper<D>::Data::clip_cut_cell(int axis, const Index<D>& face, ClippedFace<D>& result) const
{
    struct Candidate {
        int image;
        double phi;
    };
    static thread_local std::vector<Candidate> near;
    static thread_local std::vector<Cutter<D>> cutters;
    static thread_local FaceSums<D> sums;

    const Vec<D> centre = result.open_centroid;
    const std::array<int, D - 1> tangents = tangents_of<D>(axis);
    std::array<double, D - 1> edges;
    for (int i = 0; i < D - 1; ++i)
        edges[i] = grid.dx() * grid.width(tangents[i], face[tangents[i]]);
    const double diagonal =
        grid.graded() ? Eigen::Map<const Eigen::Matrix<double, D - 1, 1>>(edges.data()).norm() : grid.dx() * std::sqrt(D - 1.0);
    const double r = 0.5 * diagonal + 2 * tolerance;
    near.clear();
    double smallest = r;
    for (int image : images_at(face))
        if (!wall[image])
            if (const double phi = images[image].shape.distance(centre); phi <= r) {
                near.push_back({image, phi});
                smallest = std::min(smallest, phi);
            }
    std::erase_if(near, [&](const Candidate& c) { return c.phi > smallest + 2 * r; });
    if (near.empty())
        return -1;
    if (near.size() == 1 && near[0].phi < -r) {
        result.open = 0;
        add_part(near[0].image, 1, centre, result);
        return near[0].image;
    }
    // By name, then by place: the result does not depend on the order of the scene.
    std::sort(near.begin(), near.end(), [&](const Candidate& a, const Candidate& b) {
        return std::pair(rank[a.image], a.image) < std::pair(rank[b.image], b.image);
    });
    cutters.clear();
    for (const Candidate& c : near)
        cutters.push_back({&images[c.image].shape, planes[c.image], images[c.image].shape.shape().complement()});
    Vec<D> corner = centre;
    for (int i = 0; i < D - 1; ++i)
        corner[tangents[i]] -= 0.5 * edges[i];
    clip_face(corner, edges, tangents, std::span<const Cutter<D>>(cutters), tolerance, sums);

    auto place = [&](const typename PartSum<D>::Local& local) {
        Vec<D> x = corner;
        for (int i = 0; i < D - 1; ++i)
            x[tangents[i]] += edges[i] * local[i];
        return x;
    };
    double total = 0;
    typename PartSum<D>::Local moment = PartSum<D>::Local::Zero();
    int last = -1, largest = -1;
    for (std::size_t i = 0; i < near.size(); ++i) {
        const PartSum<D>& part = sums.solid[i];
        if (part.measure < 0.1 * negligible)
            continue;
        add_part(near[i].image, part.measure, place(part.moment / part.measure), result);
        total += part.measure;
        moment += part.moment;
        last = near[i].image;
        if (largest < 0 || part.measure > result.solid[largest].fraction)
            largest = static_cast<int>(result.solid.size()) - 1;
    }
    if (total == 0)
        return -1;
    result.open = 1 - total;
    if (result.open < (result.solid.size() == 1 ? alignment : negligible) || !(sums.open.measure > 0)) {
        result.solid[largest].fraction += result.open;
        result.open = 0;
        if (result.solid.size() == 1) {
            result.solid.clear();
            add_part(last, 1, centre, result);
            return last;
        }
    } else {
        result.open_centroid = place(result.open > well_conditioned
                                         ? typename PartSum<D>::Local((PartSum<D>::Local::Constant(0.5) - moment) / result.open)
                                         : typename PartSum<D>::Local(sums.open.moment / sums.open.measure));
    }
    return -1;
}

// ---- voxel mode

// Image that holds the cell's centre, or -1.
template <int D>
int FaceClipper<D>::Data::owner_of_cell(const Index<D>& cell) const
{
    const Vec<D> x = grid.cell_centre(cell);
    int owner = -1;
    double smallest = 0;
    for (int image : images_at(cell))
        if (!wall[image])
            if (const double phi = images[image].shape.distance(x); phi <= tolerance)
                if (owner < 0 || nearer(phi, image, smallest, owner)) {
                    owner = image;
                    smallest = phi;
                }
    return owner;
}

// Image that the segment between the centres of the two cells of a face crosses, neither centre being inside: by sphere
// tracing, the deepest of the points tried.
template <int D>
int FaceClipper<D>::Data::crossed_between(int axis, const Index<D>& face) const
{
    static thread_local std::vector<int> near;
    const Vec<D> begin = grid.cell_centre(face - step<D>(axis));
    const double distance = grid.dx() * grid.spread(axis, face[axis]);
    near.clear();
    for (const Index<D>& cell : {face, Index<D>(face - step<D>(axis))})
        for (int image : images_at(cell))
            near.push_back(image);
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    int crossed = -1;
    double smallest = 0;
    for (int image : near) {
        if (wall[image])
            continue;
        double lowest = std::numeric_limits<double>::infinity();
        for (double t = 0; t < distance;) {
            const double phi = images[image].shape.distance(begin + t * unit<D>(axis));
            lowest = std::min(lowest, phi);
            t += std::max(std::abs(phi), grid.dx() / 64);
        }
        if (lowest <= tolerance && (crossed < 0 || nearer(lowest, image, smallest, crossed))) {
            crossed = image;
            smallest = lowest;
        }
    }
    return crossed;
}

template <int D>
int FaceClipper<D>::Data::clip_voxel(int axis, const Index<D>& face, ClippedFace<D>& result) const
{
    const Vec<D> centre = result.open_centroid;
    int low = owner_of_cell(face - step<D>(axis)), high = owner_of_cell(face);
    if (low < 0 && high < 0)
        low = high = crossed_between(axis, face);
    if (low < 0 && high < 0)
        return -1;
    result.open = 0;
    if (low >= 0 && high >= 0 && low != high) {
        if (rank[high] < rank[low])
            std::swap(low, high);
        add_part(low, 0.5, centre, result);
        add_part(high, 0.5, centre, result);
        return -1;
    }
    const int owner = std::max(low, high);
    add_part(owner, 1, centre, result);
    return owner;
}

// ---- interface

template <int D>
FaceClipper<D>::FaceClipper(const Grid<D>& grid, std::span<const Solid<D>> solids, FractionMode mode)
    : data_(std::make_unique<Data>(grid, solids, mode))
{
}

template <int D>
FaceClipper<D>::~FaceClipper() = default;

template <int D>
const std::vector<Image<D>>& FaceClipper<D>::images() const
{
    return data_->images;
}

template <int D>
double FaceClipper<D>::tolerance() const
{
    return data_->tolerance;
}

template <int D>
void FaceClipper<D>::clip(int axis, const Index<D>& face, ClippedFace<D>& result) const
{
    data_->clip(axis, face, result);
}

template <int D>
void FaceClipper<D>::near(const Vec<D>& x, double reach, std::vector<int>& result) const
{
    Nearby nearby;
    std::swap(nearby.images, result);
    near(x, reach, nearby);
    std::swap(nearby.images, result);
}

template <int D>
void FaceClipper<D>::near(const Vec<D>& x, double reach, Nearby& nearby) const
{
    const Grid<D>& grid = data_->grid;
    const ImageBins<D>& bins = data_->bins;
    std::vector<int>& result = nearby.images;
    const Vec<D> around = Vec<D>::Constant(reach + 1e-6 * grid.dx());
    const Index<D> low = grid.cell_of(x - around), high = grid.cell_of(x + around);
    const bool covered = (low.array() >= bins.first_cell(bins.bins().low).array()).all() &&
                         (high.array() < bins.first_cell(bins.bins().high).array()).all();
    if (!covered) {
        nearby.binned = false;
        result.clear();
        for (int i = 0; i < static_cast<int>(data_->images.size()); ++i)
            if (data_->images[i].shape.distance(x) <= reach)
                result.push_back(i);
        return;
    }
    const Index<D> first = bins.bin_of(low), last = bins.bin_of(high);
    if (nearby.binned && nearby.low == first && nearby.high == last)
        return;
    nearby.binned = true;
    nearby.low = first;
    nearby.high = last;
    result.clear();
    static thread_local std::vector<char> listed;
    listed.resize(std::max(listed.size(), data_->images.size()), 0);
    for_each_index<D>(first, last + Index<D>::Ones(), [&](const Index<D>& bin) {
        for (const int image : bins.images_in(bin))
            if (!listed[image]) {
                listed[image] = 1;
                result.push_back(image);
            }
    });
    std::sort(result.begin(), result.end());
    for (const int image : result)
        listed[image] = 0;
}

template <int D>
Vec<D> FaceClipper<D>::deepest_open_centroid(int axis, const Index<D>& face) const
{
    constexpr int n = D == 2 ? 32 : 12;
    constexpr int count = D == 2 ? n : n * n;
    static thread_local std::vector<int> images;
    const Grid<D>& grid = data_->grid;
    const Index<D> wrapped = grid.wrapped(face);
    const Vec<D> centre = grid.face_centre(axis, wrapped);
    const Vec<D> shift = grid.dx() * (face - wrapped).template cast<double>();
    if (data_->mode == FractionMode::voxel)
        return centre + shift;
    near(centre, 2 * grid.dx(), images);
    if (images.empty())
        return centre + shift;

    const std::array<int, D - 1> tangents = tangents_of<D>(axis);
    std::array<Vec<D>, count> x;
    std::array<double, count> phi;
    int deepest = 0;
    for (int k = 0; k < count; ++k) {
        const int place[2] = {k % n, k / n};
        x[k] = centre;
        for (int i = 0; i < D - 1; ++i)
            x[k][tangents[i]] += grid.dx() * grid.width(tangents[i], wrapped[tangents[i]]) * ((place[i] + 0.5) / n - 0.5);
        phi[k] = std::numeric_limits<double>::infinity();
        for (int image : images)
            phi[k] = std::min(phi[k], data_->images[image].shape.distance(x[k]));
        if (phi[k] > phi[deepest])
            deepest = k;
    }
    if (!(phi[deepest] > data_->tolerance)) { // openings that no sample meets
        ClippedFace<D> parts;
        clip(axis, face, parts);
        return parts.open_centroid;
    }
    // Flood from the deepest sample over open neighbours.
    std::array<bool, count> seen{};
    std::array<int, count> queue;
    int size = 1;
    queue[0] = deepest;
    seen[deepest] = true;
    Vec<D> sum = Vec<D>::Zero();
    for (int next = 0; next < size; ++next) {
        const int k = queue[next];
        sum += x[k];
        auto visit = [&](bool exists, int other) {
            if (exists && !seen[other] && phi[other] > data_->tolerance) {
                seen[other] = true;
                queue[size++] = other;
            }
        };
        visit(k % n > 0, k - 1);
        visit(k % n < n - 1, k + 1);
        visit(k >= n, k - n);
        visit(k + n < count, k + n);
    }
    return sum / size + shift;
}

template struct FaceClipper<2>::Data;
template struct FaceClipper<3>::Data;
template class FaceClipper<2>;
template class FaceClipper<3>;

} // namespace gapflow
