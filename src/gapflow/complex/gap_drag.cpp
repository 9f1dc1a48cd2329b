#include "gapflow/complex/gap_drag.hpp"

#include "gapflow/complex/drag_line.hpp"

#include <cmath>
#include <map>

namespace gapflow {
namespace {

template <int D>
GapDrag<D> drag_at(const GapSite<D>& site, const FacePiece<D>& piece, const Vec<D>& low, const Vec<D>& high, const Peak* peak)
{
    constexpr int T = twist_size<D>;
    const double t0 = site.here.thickness, A = piece.area;
    GapDrag<D> drag{site.piece, site.solid, 0, 0, PairTwist<D>::Zero(), {}, PairMass<D>::Zero(), t0, {}};
    for (int side = 0; side < 2; ++side)
        drag.motion.template segment<T>(side * T) =
            0.5 * speed_along<D>(unit<D>(piece.axis), piece.centroid, site.walls.reference[side]);
    drag.share = share_up_to(t0, parameters.gap_start, parameters.gap_end);
    if (site.along_face())
        for (DragForm<D>& half : drag.half)
            half.resistance = 6 * site.delta * site.walls.between_shapes(t0) / (A * t0 * t0 * t0);
    else {
        GapShape<D> closing = shape_of_gap<D, StillWalls<D>>(site.walls, piece.centroid, site.n, site.here, site.e, site.way);
        if constexpr (D == 3)
            if (peak && !(closing.curvature > 0)) // beside the end of a wall
                closing.share = site.e.dot(peak->hessian * site.way) / peak->hessian.trace();
        DragFace<D> face(site, piece, low, high, peak);
        const auto lines = face.lines(closing.share);
        double conductance = 0;
        PairTwist<D> mean = PairTwist<D>::Zero();
        for (const auto& line : lines) {
            const double b = line.width * A / face.area();
            if (!(line.way.drop() > 0))
                continue;
            conductance += b / line.way.drop();
            mean += b * line.way.mean();
        }
        if (!(conductance > 0)) {
            drag.share = 0;
            return drag;
        }
        const PairMass<D> relative = relative_twists(site.walls);
        for (const auto& line : lines) {
            const DragLine<D>& way = line.way;
            if (!(way.drop() > 0))
                continue;
            const double b = site.delta * line.width * A / face.area(), of_flux = 1 / (conductance * way.drop());
            for (int side = 0; side < 2; ++side) { // of the line's flux w = of_flux (q + mean) - its mean
                const auto& of = way.half[side];
                const PairTwist<D> rest = of_flux * mean - way.mean() + of.mean;
                drag.half[side].resistance += b * of.drop * of_flux * of_flux;
                drag.half[side].flux += b * of.drop * of_flux * rest;
                drag.half[side].mass += b * (of.drop * rest * rest.transpose() + of.square + of.friction);
            }
        }
        for (DragForm<D>& half : drag.half) {
            half.flux = PairTwist<D>(relative.transpose().lazyProduct(half.flux));
            half.mass = in_relative<D>(relative, half.mass);
        }
    }
    for (DragForm<D>& half : drag.half) {
        drag.resistance += drag.share * half.resistance;
        drag.flux += drag.share * half.flux;
        drag.mass += drag.share * half.mass;
    }
    return drag;
}

/// Names the walls in an order that does not depend on the place.
template <int D>
void order_walls(GapSite<D>& site)
{
    const std::array<Vec<D>, 2>& x = site.walls.reference;
    if (site.solid[0] < site.solid[1] ||
        (site.solid[0] == site.solid[1] && std::lexicographical_compare(x[0].begin(), x[0].end(), x[1].begin(), x[1].end())))
        return;
    std::swap(site.solid[0], site.solid[1]);
    std::swap(site.still[0], site.still[1]);
    site.walls.swap();
    site.n = -site.n;
    std::swap(site.round[0], site.round[1]);
    std::swap(site.here.normal[0], site.here.normal[1]);
}

/// In 2D the fluid in a gap is one chain: of faces that follow each other across it the straighter ones count. Parts that others join
/// have the node of the largest.
class Chain {
public:
    Chain(const Grid<2>& grid, const Complex<2>& complex) : grid_(grid), complex_(complex) {}

    /// Whether a piece ends in the gap at a vertex of the grid where the gap is straighter across the other axis. Joins its parts.
    bool joins(const GapSite<2>& site)
    {
        const FacePiece<2>& piece = complex_.pieces[site.piece];
        bool found = false;
        for (const double side : {-0.5, 0.5}) {
            const Vec<2> end = piece.centroid + side * piece.area * unit<2>(1 - piece.axis);
            double least = 1;
            for (const int wall : {0, 1})
                least = std::min(least, std::abs(site.walls.nearest(wall, end).distance));
            if (least < parameters.joint_distance)
                continue;
            const auto middle = foot<2>(site.walls, end, site.n);
            const auto at = middle ? own_section<2>(site.walls, *middle, site.n) : std::nullopt;
            found = found || (at && at->section.thickness < parameters.gap_end &&
                              (std::abs(at->n[0]) > std::abs(at->n[1]) + parameters.parallel ? 1 : 0) != piece.axis);
        }
        if (found && piece.low.is_part() && piece.high.is_part()) {
            const int a = root(piece.low.number()), b = root(piece.high.number());
            const auto larger = [&](int x, int y) {
                return complex_.part_area[x] != complex_.part_area[y] ? complex_.part_area[x] > complex_.part_area[y] : x < y;
            };
            if (a != b)
                (larger(a, b) ? parent_[b] : parent_[a]) = larger(a, b) ? a : b;
        }
        return found;
    }
    /// From the centre of a part's cell to its node.
    Vec<2> way_to_node(const PartOrCell& at)
    {
        if (!at.is_part())
            return Vec<2>::Zero();
        const Index<2> from = complex_.cell_of_part(at.number()), to = complex_.cell_of_part(root(at.number()));
        Vec<2> way;
        for (int axis = 0; axis < 2; ++axis) {
            way[axis] = (grid_.centre_place(axis, to[axis]) - grid_.centre_place(axis, from[axis])) / grid_.dx();
            if (grid_.periodic(axis))
                way[axis] -= std::round(way[axis] / grid_.size()[axis] * grid_.dx()) * grid_.size()[axis] / grid_.dx();
        }
        return way;
    }

private:
    int root(int part)
    {
        auto at = parent_.find(part);
        while (at != parent_.end()) {
            part = at->second;
            at = parent_.find(part);
        }
        return part;
    }

    const Grid<2>& grid_;
    const Complex<2>& complex_;
    std::map<int, int> parent_;
};

template <int D>
bool same_walls(const GapSite<D>& a, const GapSite<D>& b)
{
    return a.solid == b.solid && a.walls.reference == b.walls.reference;
}

} // namespace

template <int D>
GapDrags<D> find_gap_drag(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                          const Standoffs<D>& standoffs)
{
    std::vector<GapSite<D>> sites;
    for_each_gap<D>(grid, solids, complex, standoffs, [&](const GapSite<D>& site) {
        sites.push_back(site);
        order_walls(sites.back());
    });
    std::vector<std::optional<Peak>> peaks;
    std::vector<int> peak_of(sites.size(), -1);
    GapDrags<D> drags;
    if constexpr (D == 3) {
        std::vector<std::vector<std::size_t>> pairs; // sites of each two images, the thinnest first
        for (std::size_t k = 0; k < sites.size(); ++k) {
            std::size_t p = 0;
            while (p < pairs.size() && !same_walls(sites[pairs[p][0]], sites[k]))
                ++p;
            if (p == pairs.size())
                pairs.emplace_back();
            pairs[p].push_back(k);
            peak_of[k] = static_cast<int>(p);
        }
        for (std::vector<std::size_t>& pair : pairs) {
            std::stable_sort(pair.begin(), pair.end(),
                             [&](std::size_t a, std::size_t b) { return sites[a].here.thickness < sites[b].here.thickness; });
            peaks.emplace_back();
            for (const std::size_t k : pair) {
                const std::optional<FoundPeak> found = find_peak(sites[k]);
                if (!found)
                    continue;
                peaks.back() = found->peak;
                const PairMass<D> relative = relative_twists(sites[k].walls);
                drags.peaks.push_back({sites[k].solid, found->peak.at, in_relative<D>(relative, found->mass)});
                break;
            }
        }
    }
    std::vector<char> joined(sites.size(), false);
    std::vector<std::array<Vec<D>, 2>> shift(sites.size(), {Vec<D>::Zero(), Vec<D>::Zero()});
    if constexpr (D == 2) {
        Chain chain(grid, complex);
        for (std::size_t k = 0; k < sites.size(); ++k)
            joined[k] = chain.joins(sites[k]);
        for (std::size_t k = 0; k < sites.size(); ++k) {
            const FacePiece<D>& piece = complex.pieces[sites[k].piece];
            shift[k] = {chain.way_to_node(piece.low), chain.way_to_node(piece.high)};
        }
    }
    for (std::size_t k = 0; k < sites.size(); ++k) {
        if (joined[k]) {
            const double share = share_up_to(sites[k].here.thickness, parameters.gap_start, parameters.gap_end);
            if (share > 0)
                drags.joined.push_back({sites[k].piece, share, sites[k].here.thickness});
            continue;
        }
        const FacePiece<D>& piece = complex.pieces[sites[k].piece];
        const Vec<D> half = 0.5 * sites[k].delta * unit<D>(piece.axis);
        const Peak* peak = peak_of[k] >= 0 && peaks[peak_of[k]] ? &*peaks[peak_of[k]] : nullptr;
        const GapDrag<D> drag =
            drag_at<D>(sites[k], piece, sites[k].nodes - half + shift[k][0], sites[k].nodes + half + shift[k][1], peak);
        if (drag.share > 0)
            drags.faces.push_back(drag);
    }
    return drags;
}

template GapDrags<2> find_gap_drag(const Grid<2>&, std::span<const Solid<2>>, const Complex<2>&, const Standoffs<2>&);
template GapDrags<3> find_gap_drag(const Grid<3>&, std::span<const Solid<3>>, const Complex<3>&, const Standoffs<3>&);

} // namespace gapflow
