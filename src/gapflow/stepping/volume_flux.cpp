#include "gapflow/stepping/volume_flux.hpp"

#include "gapflow/film/film_motion.hpp"
#include "gapflow/stepping/flooding.hpp"
#include "gapflow/stepping/gap_flux.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace gapflow {

namespace {

/// Sums of one flux. What films carry is the same on every rank, the grid's share is each rank's own.
struct Sums {
    double in = 0, out = 0, film = 0, bodies = 0;

    void add_fluid(double flux)
    {
        in += std::max(-flux, 0.0);
        out += std::max(flux, 0.0);
    }
    void add_film(double flux)
    {
        add_fluid(flux);
        film += flux;
    }
};

VolumeFlux values_of(const Sums& grid, const Sums& films, const Communicator& comm)
{
    std::vector<double> sums{grid.in, grid.out, grid.film, grid.bodies};
    comm.sum(sums);
    VolumeFlux result;
    result.inflow = sums[0] + films.in;
    result.outflow = sums[1] + films.out;
    result.flux = result.outflow - result.inflow;
    result.film = sums[2] + films.film;
    result.bodies = sums[3];
    return result;
}

/// What passes single faces, and the film's flows.
template <int D>
class Flows {
public:
    Flows(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V,
          const FaceFluxes<D>* fluxes = nullptr)
        : grid_(model.grid), here_(here), state_(state), V_(V), fluxes_(fluxes),
          faces_(grid_, *here.clipper, here.solids, *here.fractions)
    {
    }

    // Volume of solids that passes a face of this rank along its axis. Wholly solid faces away from surfaces have no parts stored.
    double of_bodies(int axis, const Index<D>& f)
    {
        if (fluxes_ && grid_.in_domain(grid_.wrapped(f)) && grid_.in_domain(grid_.wrapped(Index<D>(f - step<D>(axis)))))
            return fluxes_->bodies(axis, f) * grid_.face_area();
        const FaceFractions<D>& fractions = *here_.fractions;
        double sum = 0;
        const auto add = [&](int solid, double area, const Vec<D>& arm) {
            if (!here_.solids[solid].wall)
                sum += area * velocity_at<D>(V_[solid], arm)[axis];
        };
        if (const int cut = fractions.cut(axis, f); cut >= 0) {
            for (const SolidPart<D>& part : fractions.faces[cut].solid)
                add(part.solid, part.fraction * grid_.face_area(), part.arm);
        } else if (fractions.open(axis, f) <= 0) {
            const Vec<D> x = grid_.face_centre(axis, f);
            here_.clipper->near(x, grid_.dx(), near_);
            const Image<D>* deepest = nullptr;
            double least = 0;
            for (const int image : near_) {
                const Image<D>& candidate = here_.clipper->images()[image];
                if (const double distance = candidate.shape.distance(x); distance < least) {
                    least = distance;
                    deepest = &candidate;
                }
            }
            if (deepest)
                add(deepest->solid, grid_.relative_area(axis, f) * grid_.face_area(),
                    x - here_.solids[deepest->solid].centre - deepest->shift);
        }
        return sum;
    }

    // Of the grid's own fluid through a face. On a side of the domain a film's fluid passes through mouths.
    double of_grid(int axis, const Index<D>& f) const
    {
        if (fluxes_)
            return fluxes_->fluid(axis, f) * grid_.face_area();
        const int last = grid_.cells()[axis];
        const bool on_side = !grid_.periodic(axis) && (f[axis] == 0 || f[axis] == last);
        if (on_side && static_cast<CellKind>(here_.kind(f[axis] == last ? Index<D>(f - step<D>(axis)) : f)) == CellKind::film)
            return 0;
        return here_.open(axis, f) * state_.velocity.grid(axis, f) * grid_.face_area();
    }

    // Part of it in gaps, where they are parts of the grid's fluid.
    double of_gaps(int axis, const Index<D>& f) const { return fluxes_ ? fluxes_->gaps(axis, f) * grid_.face_area() : 0.0; }

    // A face that a film closes: its fluid moves with the film's master there, and relative to it through the film's elements.
    double with_master(int axis, const Index<D>& f) const
    {
        const FilmNetwork<D>& network = here_.network;
        const double open = here_.fractions->open(axis, f);
        if (network.cells.closed.empty() || open <= 0 || here_.open(axis, f) > 0)
            return 0;
        const int* film = network.cells.closed.find(faces_.key(axis, f));
        if (!film)
            return 0;
        const int master = network.films[*film].mesh.master;
        const Vec<D> arm = grid_.nearest_image(faces_.open_centroid(axis, f) - here_.solids[master].centre);
        return open * grid_.face_area() * velocity_at<D>(V_[master], arm)[axis];
    }

    // Half of the widths of a face along all axes; that along its own does not count.
    Vec<D> half_widths(const Index<D>& f) const
    {
        Vec<D> half;
        for (int k = 0; k < D; ++k)
            half[k] = 0.5 * grid_.dx() * grid_.width(k, f[k]);
        return half;
    }
    // Middle of the open part of a face, and half of the widths that this part has along the face's own axes.
    std::pair<Vec<D>, Vec<D>> open_part(int axis, const Index<D>& f) const
    {
        const FaceFractions<D>& fractions = *here_.fractions;
        const int cut = fractions.cut(axis, f);
        if (cut < 0)
            return {grid_.face_centre(axis, f), half_widths(f)};
        const double part = std::pow(fractions.open(axis, f) / grid_.relative_area(axis, f), 1.0 / (D - 1));
        return {fractions.faces[cut].open_centroid, half_widths(f) * part};
    }

    // Whether a solid beside a film does.
    bool films_move() const
    {
        const std::vector<Film<D>>& films = here_.network.films;
        return std::any_of(films.begin(), films.end(), [&](const Film<D>& film) {
            return !V_[film.mesh.master].isZero(0) || !V_[film.mesh.other].isZero(0);
        });
    }

    const Grid<D>& grid() const { return grid_; }
    const Coupling<D>& here() const { return here_; }
    const State<D>& state() const { return state_; }
    const std::vector<Twist<D>>& twists() const { return V_; }

private:
    const Grid<D>& grid_;
    const Coupling<D>& here_;
    const State<D>& state_;
    const std::vector<Twist<D>>& V_;
    const FaceFluxes<D>* fluxes_;
    FaceCache<D> faces_;
    std::vector<int> near_;
};

// Faces of the side, and the films that end on it.
template <int D>
VolumeFlux through_side(Flows<D>& flows, int side)
{
    const Grid<D>& grid = flows.grid();
    const int axis = side / 2, end = side % 2, sign = 2 * end - 1;
    Index<D> low = grid.low(), high = grid.high();
    Sums own, films;
    if (end ? high[axis] == grid.cells()[axis] : low[axis] == 0) {
        low[axis] = end * grid.cells()[axis];
        high[axis] = low[axis] + 1;
        for_each_index<D>(low, high, [&](const Index<D>& f) {
            own.add_fluid(sign * flows.of_grid(axis, f));
            own.film += sign * flows.of_gaps(axis, f);
            own.bodies += sign * flows.of_bodies(axis, f);
        });
    }
    const std::vector<Mouth<D>>& mouths = flows.here().network.rim.mouths;
    for (std::size_t r = 0; r < mouths.size(); ++r)
        if (mouths[r].side == side)
            films.add_film(flows.state().velocity.mouth[r]);
    return values_of(own, films, grid.comm());
}

/// A plane, or the part of it in a box.
template <int D>
class PlanePart {
public:
    PlanePart(const Grid<D>& grid, const FluxScene& scene)
        : grid_(grid), point_(scene.point.data()), normal_(scene.normal.data()),
          width_(grid.dx() * normal_.template lpNorm<1>()), part_(scene.low && scene.high)
    {
        low_.setConstant(-std::numeric_limits<double>::infinity());
        high_ = -low_;
        for (int axis = 0; axis < D; ++axis) {
            if (std::abs(normal_[axis]) > 1 - 1e-12)
                axis_ = axis;
            else if (scene.low && scene.high) {
                low_[axis] = (*scene.low)[axis];
                high_[axis] = (*scene.high)[axis];
            }
        }
    }

    double reach() const { return width_ * grid_.largest_width(); }
    const Vec<D>& normal() const { return normal_; }
    /// Whether it divides the domain in two.
    bool divides() const { return !part_ && !(axis_ >= 0 && grid_.periodic(axis_)); }
    /// From the plane's point to x; of a plane normal to a periodic axis to the nearest image of x.
    Vec<D> way(const Vec<D>& x) const
    {
        Vec<D> way = x - point_;
        if (axis_ >= 0 && grid_.periodic(axis_))
            way[axis_] = grid_.nearest_image(way)[axis_];
        return way;
    }
    double height(const Vec<D>& way) const { return normal_.dot(way); }
    /// 1 in cells beyond the plane, along its normal, 0 in the others: of the cell that holds a place.
    double side(const Vec<D>& way) const { return side_of(height(grid_.cell_centre(grid_.cell_of(point_ + way)) - point_)); }
    /// Its change from one side of a face at a place to the other.
    double across(int axis, const Index<D>& f, const Vec<D>& way) const
    {
        const double middle = height(way), half = 0.5 * grid_.dx() * normal_[axis];
        return side_of(middle + half * grid_.width(axis, f[axis])) - side_of(middle - half * grid_.width(axis, f[axis] - 1));
    }
    /// The share in the box of a part of a face, so wide around its middle.
    double share(int face_axis, const Vec<D>& way, const Vec<D>& half) const
    {
        const Vec<D> x = point_ + way;
        double share = 1;
        for (int axis = 0; axis < D; ++axis)
            if (axis == face_axis || half[axis] <= 0)
                share *= x[axis] >= low_[axis] && x[axis] <= high_[axis] ? 1.0 : 0.0;
            else
                share *=
                    std::max(std::min(x[axis] + half[axis], high_[axis]) - std::max(x[axis] - half[axis], low_[axis]), 0.0) /
                    (2 * half[axis]);
        return share;
    }
    bool holds(const Vec<D>& way) const
    {
        const Vec<D> x = point_ + way;
        return (x.array() >= low_.array()).all() && (x.array() <= high_.array()).all();
    }

private:
    // Of the centre of a cell; one on the plane, to round-off, lies beyond it.
    double side_of(double height) const { return height > -1e-9 * width_ ? 1.0 : 0.0; }

    const Grid<D>& grid_;
    Vec<D> point_, normal_, low_, high_;
    double width_;
    bool part_;     ///< in a box
    int axis_ = -1; ///< that it is normal to
};

/// All planes normal to an axis at once: the place along it stands for the side.
template <int D>
struct AllPlanes {
    int axis;

    double reach() const { return std::numeric_limits<double>::infinity(); }
    Vec<D> way(const Vec<D>&) const { return Vec<D>::Zero(); } // flows count by the difference of their ends' places alone
    double height(const Vec<D>& way) const { return way[axis]; }
    double side(const Vec<D>& way) const { return way[axis]; }
    bool holds(const Vec<D>&) const { return true; }
};

// Flows of films through a plane; the same on every rank.
template <int D, class Plane>
Sums films_through(const Flows<D>& flows, const Plane& plane)
{
    const Coupling<D>& here = flows.here();
    const FilmNetwork<D>& network = here.network;
    const std::vector<Twist<D>>& V = flows.twists();
    Sums sums;
    for (const Film<D>& film : network.films) {
        const FilmMesh<D>& mesh = film.mesh;
        for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
            const FilmElement<D>& element = mesh.elements[e];
            const Vec<D> middle = plane.way(element.centroid);
            if (std::abs(plane.height(middle)) > plane.reach() + 2 * flows.grid().dx() || !plane.holds(middle))
                continue;
            const Vec<D> U = velocity_at<D>(V[mesh.master], element.centroid - here.solids[mesh.master].centre);
            const Vec<D> u = flows.state().velocity.film[film.first_element + e] - U;
            const NormalRows<D> rows = normal_rows<D>(mesh, element, here.solids);
            const double across = rows.master.dot(V[mesh.master]) + rows.other.dot(V[mesh.other]) - element.normal.dot(U);
            double flux = 0;
            for (int i = 0; i < D; ++i)
                flux += (element.volume * u - across * element.lean).dot(element.gradient[i]) *
                        plane.side(middle + mesh.mid[element.nodes[i]] - element.centroid);
            sums.add_film(flux);
        }
    }
    const std::vector<Mouth<D>>& mouths = network.rim.mouths;
    const auto place_of = [&](int node) { // among all film nodes
        const auto film = std::upper_bound(network.films.begin(), network.films.end(), node,
                                           [](int n, const Film<D>& f) { return n < f.first_node; }) -
                          1;
        return film->mesh.mid[node - film->first_node];
    };
    for (std::size_t r = 0; r < mouths.size(); ++r) {
        const Mouth<D>& mouth = mouths[r];
        const Vec<D> middle = plane.way(mouth.x);
        if (std::abs(plane.height(middle)) > plane.reach() + 4 * flows.grid().dx() || !plane.holds(middle))
            continue;
        double beyond = mouth.cells.empty() ? plane.side(middle + 0.5 * flows.grid().dx() * mouth.outward) : 0.0, within = 0;
        for (const auto& [key, weight] : mouth.cells)
            beyond += weight * plane.side(middle + flows.grid().nearest_image(
                                                       flows.grid().cell_centre(flows.grid().cell_of_key(key)) - mouth.x));
        for (int i = 0; i < D - 1; ++i)
            within += mouth.shape[i] * plane.side(middle + place_of(mouth.nodes[i]) - mouth.x);
        sums.add_film((flows.state().velocity.mouth[r] - carried_flux<D>(here, mouth, V)) * (beyond - within));
    }
    for (std::size_t r = mouths.size(); r < here.system.links.size() && here.network.nodes > 0; ++r) {
        const Link& link = here.system.links[r];
        const Vec<D> first = place_of(link.nodes.front().first), middle = plane.way(first);
        if (std::abs(plane.height(middle)) > plane.reach() + 4 * flows.grid().dx() || !plane.holds(middle))
            continue;
        double change = 0;
        for (const auto& [node, weight] : link.nodes)
            change -= weight * plane.side(middle + flows.grid().nearest_image(place_of(node) - first));
        sums.add_film(flux_of_joint(flows.state(), link) * change);
    }
    return sums;
}

// The cells, by key, between which and films' nodes the flux of films' walls moves.
template <int D>
std::set<long> cells_of_films(const Coupling<D>& here)
{
    const Grid<D>& grid = *here.grid;
    const FilmCells<D>& cells = here.network.cells;
    std::set<long> keys;
    for (int i = 0; i < static_cast<int>(cells.cells.size()); ++i) {
        const auto& [key, cell] = cells.cells.item(i);
        keys.insert(key);
        for (const CellSide<D>& side : sides_of(grid, grid.cell_of_key(key)))
            if (side.inside && cell.kind == CellKind::film)
                keys.insert(grid.key(grid.wrapped(side.cell)));
    }
    for (const Mouth<D>& mouth : here.network.rim.mouths)
        for (const auto& [key, weight] : mouth.cells)
            keys.insert(key);
    for (const std::vector<CarriedCell>& behind : here.cells_behind)
        for (const CarriedCell& cell : behind)
            keys.insert(cell.key);
    return keys;
}

// What films' walls sweep enters nodes on one side of a plane and leaves cells on the other. With all cells of films taken to its lower side,
// the section has faces of the grid alone: what passes these less what was counted in films. For a plane that divides the domain.
template <int D>
double moved_by_films(Flows<D>& flows, const PlanePart<D>& plane, double in_films)
{
    const Grid<D>& grid = flows.grid();
    double sum = 0;
    for (const long key : cells_of_films(flows.here())) {
        const Index<D> c = grid.cell_of_key(key);
        if (!grid.owns(c) || plane.side(plane.way(grid.cell_centre(c))) == 0)
            continue;
        for (int side = 0; side < 2 * D; ++side) {
            const Index<D> f = c + (side % 2) * step<D>(side / 2);
            sum += (2 * (side % 2) - 1) *
                   (flows.of_grid(side / 2, f) + flows.with_master(side / 2, f) + flows.of_bodies(side / 2, f));
        }
    }
    sum = grid.comm().sum(sum);
    const std::vector<Mouth<D>>& mouths = flows.here().network.rim.mouths;
    for (std::size_t r = 0; r < mouths.size(); ++r)
        if (mouths[r].cells.empty())
            sum += (flows.state().velocity.mouth[r] - carried_flux<D>(flows.here(), mouths[r], flows.twists())) *
                   plane.side(plane.way(mouths[r].x + 0.5 * grid.dx() * mouths[r].outward));
    return sum - in_films;
}

template <int D>
VolumeFlux through_plane(Flows<D>& flows, const PlanePart<D>& plane)
{
    const Grid<D>& grid = flows.grid();
    Sums own;
    for (int axis = 0; axis < D; ++axis) {
        if (plane.normal()[axis] == 0)
            continue;
        const Index<D> low = grid.low(), end = owned_faces_end(grid, axis);
        for_each_row<D>(low, end, [&](const Index<D>& row) {
            // Heights are linear along a row, but for a jump to the next image.
            const double slope = grid.dx() * grid.largest_width() * std::abs(plane.normal()[0]);
            Index<D> f = row;
            while (f[0] < end[0]) {
                const Vec<D> way = plane.way(grid.face_centre(axis, f));
                const double beyond = std::abs(plane.height(way)) - plane.reach();
                if (beyond > 0) {
                    f[0] = slope > 0 ? f[0] + std::max(1, static_cast<int>(std::min(beyond / slope, 1e9))) : end[0];
                    continue;
                }
                if (const double change = plane.across(axis, f, way); change != 0) {
                    const auto [middle, half] = flows.open_part(axis, f);
                    const double open_share = change * plane.share(axis, plane.way(middle), half);
                    own.add_fluid(open_share * flows.of_grid(axis, f));
                    own.film += open_share * flows.of_gaps(axis, f);
                    own.add_film(open_share * flows.with_master(axis, f));
                    own.bodies += change * plane.share(axis, way, flows.half_widths(f)) * flows.of_bodies(axis, f);
                }
                ++f[0];
            }
        });
    }
    const Sums films = films_through(flows, plane);
    VolumeFlux result = values_of(own, films, grid.comm());
    if (plane.divides() && flows.films_move())
        result.bodies += moved_by_films(flows, plane, films.film);
    return result;
}

} // namespace

template <int D>
VolumeFlux volume_flux(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V,
                       const FluxScene& through, const FaceFluxes<D>* fluxes)
{
    Flows<D> flows(model, here, state, V, fluxes);
    switch (through.kind) {
    case FluxScene::Kind::side:
        return through_side(flows, through.side);
    case FluxScene::Kind::plane:
        return through_plane(flows, PlanePart<D>(model.grid, through));
    case FluxScene::Kind::gap:
        break;
    }
    return flux_through_gap(here, state, through);
}

template <int D>
Vec<D> flow_of_films(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V)
{
    const Grid<D>& grid = model.grid;
    const Flows<D> flows(model, here, state, V);
    std::vector<double> sums(D, 0.0);
    for (int axis = 0; axis < D; ++axis)
        for_each_row<D>(grid.low(), grid.high(), [&](const Index<D>& row) {
            Index<D> f = row;
            for (; f[0] < grid.high()[0]; ++f[0])
                sums[axis] += grid.dx() * flows.with_master(axis, f);
        });
    grid.comm().sum(sums);
    Vec<D> flow;
    for (int axis = 0; axis < D; ++axis)
        flow[axis] = sums[axis] + films_through(flows, AllPlanes<D>{axis}).film;
    return flow;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Vec<D> flow_of_films<D>(const Model<D>&, const Coupling<D>&, const State<D>&, const std::vector<Twist<D>>&);      \
    template VolumeFlux volume_flux<D>(const Model<D>&, const Coupling<D>&, const State<D>&, const std::vector<Twist<D>>&,     \
                                       const FluxScene&, const FaceFluxes<D>*);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
