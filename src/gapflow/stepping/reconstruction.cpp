#include "gapflow/stepping/reconstruction.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/grid/extrapolation.hpp"
#include "gapflow/stepping/flooding.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

namespace gapflow {

namespace {

// Layers of faces that velocities are extrapolated into solids and films.
constexpr int extrapolated_layers = 4;

// u at a face centre, ghosts filled.
template <int D>
Vec<D> velocity_at_face(const FaceField<D>& u, int axis, const Index<D>& f)
{
    Vec<D> value;
    for (int k = 0; k < D; ++k) {
        const Index<D> below = f - step<D>(axis), up = step<D>(k);
        value[k] = k == axis ? u(k, f) : 0.25 * (u(k, f) + u(k, f + up) + u(k, below) + u(k, below + up));
    }
    return value;
}

// Solids near a face, kept from face to face: the next one mostly has the same.
template <int D>
struct Near {
    typename FaceClipper<D>::Nearby solids;
    std::vector<double> distances;
};

// Component along `axis` of n n . (U_b - u) at a face: the difference of u from the nearest solid's normal velocity.
template <int D>
double normal_surplus(const Coupling<D>& c, const FaceField<D>& u, int axis, const Index<D>& f, const std::vector<Twist<D>>& V,
                      Near<D>& near)
{
    const Grid<D>& grid = *c.grid;
    const Vec<D> x = grid.face_centre(axis, f);
    c.clipper->near(x, grid.dx(), near.solids);
    const std::vector<int>& nearby = near.solids.images;
    // Halfway between two solids each counts by half, so that the order in the scene has no influence.
    const auto& images = c.clipper->images();
    double distance = grid.dx();
    near.distances.clear();
    for (int i : nearby) {
        const double least = distance_to_bounds(images[i], x);
        near.distances.push_back(least > 2 * grid.dx() ? least : images[i].shape.distance(x));
        distance = std::min(distance, near.distances.back());
    }
    if (distance >= grid.dx())
        return 0;
    const Vec<D> fluid = velocity_at_face(u, axis, f);
    double surplus = 0;
    int count = 0;
    for (std::size_t k = 0; k < nearby.size(); ++k)
        if (nearby.size() == 1 || near.distances[k] <= distance + 1e-9 * grid.dx()) {
            const int i = nearby[k];
            const Vec<D> n = images[i].shape.closest(x).normal;
            const Vec<D> relative =
                velocity_at<D>(V[images[i].solid], x - c.solids[images[i].solid].centre - images[i].shift) - fluid;
            surplus += n[axis] * n.dot(relative);
            ++count;
        }
    return surplus / count;
}

// Extrapolated velocities keep the solids' normal velocity: u += n n . (U_b - u) with the nearest solid's n. Without it a face
// that a moving surface uncovers transports momentum through that surface, an impulse on the body that does not shrink with dt.
template <int D>
void follow_solids(const Coupling<D>& c, const FaceField<D, std::int8_t>& valid, const std::vector<Twist<D>>& V,
                   const BoundaryVelocity<D>& sides, FaceField<D>& u)
{
    const Grid<D>& grid = *c.grid;
    std::vector<std::pair<int, Index<D>>> faces;
    for (int axis = 0; axis < D; ++axis)
        for_each_marked<D>(valid[axis], grid.low(), owned_faces_end(grid, axis), 2,
                           [&](const Index<D>& f) { faces.emplace_back(axis, f); });
    std::vector<double> surplus(faces.size());
    for_each_part(static_cast<long>(faces.size()), [&](long begin, long end) {
        Near<D> near;
        for (long k = begin; k < end; ++k)
            surplus[k] = normal_surplus(c, u, faces[k].first, faces[k].second, V, near);
    });
    for (std::size_t k = 0; k < faces.size(); ++k)
        u(faces[k].first, faces[k].second) += surplus[k];
    fill_velocity_ghosts(grid, u, sides);
}

// Faces of film cells get the film's velocity: its tangential component the film's own, its normal component the one given by
// the walls.
template <int D>
void paint_films(const Coupling<D>& c, Reconstruction<D>& into, FaceField<D, std::int8_t>& valid)
{
    const Grid<D>& grid = *c.grid;
    const FilmNetwork<D>& network = c.network;
    struct Face {
        int axis;
        Index<D> f;
        Vec<D> x; ///< its centre, seen from the film
    };
    std::vector<std::vector<Face>> faces(network.films.size());
    for (const auto& [key, cell] : network.cells.cells) {
        if (cell.kind != CellKind::film)
            continue;
        for (const CellSide<D>& side : sides_of(grid, grid.cell_of_key(key))) {
            const Index<D> f = grid.wrapped(side.face);
            if (!owns_face(grid, side.axis, f) || valid(side.axis, f))
                continue;
            valid(side.axis, f) = 1;
            into.film_faces(side.axis, f) = 1;
            faces[cell.owner].push_back(
                {side.axis, f, grid.face_centre(side.axis, Index<D>(side.face + cell.offset(cell.owner)))});
        }
    }
    for_each_job(static_cast<int>(network.films.size()), [&](int k) {
        const Film<D>& film = network.films[k];
        const PlacedShape<D>& master = c.solids[film.pair.master].shape;
        const FilmHistory<D>& memory = *into.histories.at(film.pair);
        int near = -1; // element of the film's memory close to the last face
        for (const auto& [axis, f, x] : faces[k]) {
            // From the master's surface, on which the memory lies: next to it there is no need to search.
            const Vec<D> on_master = master.to_body(master.closest(x).x);
            const typename FilmHistory<D>::Flow flow = memory.at(on_master, near);
            // The film may be only a part of what is open there: the face carries the film's flux.
            const double across = std::sqrt(std::max(0.0, 1 - flow.normal[axis] * flow.normal[axis])),
                         width = across * c.fractions->open(axis, f) * grid.dx();
            into.painted(axis, f) = flow.of_master[axis] + flow.flux[axis] / std::max(width, flow.h);
        }
    });
}

// Faces whose velocity is the fluid's own or given; those that are open but no wider than `widest` are added to `slivers` with
// their velocities.
template <int D>
FaceField<D, std::int8_t> known_faces(const Coupling<D>& c, double widest, const FaceField<D>& u,
                                      std::vector<Sliver<D>>& slivers)
{
    const Grid<D>& grid = *c.grid;
    FaceField<D, std::int8_t> valid(grid);
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> low = grid.low(), end = owned_faces_end(grid, axis);
        const int n = end[0] - low[0];
        // The velocities of walls and inflow hold everywhere on their sides. A face of an open side that a body covers has no
        // velocity of its own: its advected value would be unbounded from step to step.
        auto given = [&](int end) { return !grid.periodic(axis) && !is_open(grid.side(axis, end)); };
        auto at_side = [&](int place) { return (place == 0 && given(0)) || (place == grid.cells()[axis] && given(1)); };
        auto of_plane = [&](int plane) {
            std::vector<Sliver<D>> found;
            for_each_row_of_plane<D>(low, end, plane, [&](const Index<D>& row) {
                const double *conductance = &c.system.conductance(axis, row), *open = &c.open(axis, row);
                std::int8_t* to = &valid(axis, row);
                for (int i = 0; i < n; ++i)
                    to[i] = conductance[i] > 0 && open[i] > widest;
                int narrow = 0;
                for (int i = 0; i < n; ++i)
                    narrow += conductance[i] > 0 && open[i] <= widest;
                Index<D> f = row;
                for (int i = 0; i < n && narrow > 0; ++i, ++f[0])
                    if (conductance[i] > 0 && !to[i])
                        found.push_back({axis, f, open[i], u(axis, f), 0, 0});
                if (axis == 0) {
                    to[0] |= at_side(row[0]);
                    to[n - 1] |= at_side(row[0] + n - 1);
                } else if (at_side(row[axis])) {
                    std::fill_n(to, n, std::int8_t{1});
                }
            });
            return found;
        };
        for (const std::vector<Sliver<D>>& of_this : each_plane(low[D - 1], end[D - 1], of_plane))
            slivers.insert(slivers.end(), of_this.begin(), of_this.end());
    }
    return valid;
}

// Velocities across the closed faces of cells that mouths flow into, of the first extrapolated layer: linear extrapolation takes what mouths bring into the cell for a
// gradient. Fluid that comes out of a film is no faster than it is there: beyond the velocity at the cell's opposite face, extrapolated ones go no further
// than that of a mouth's fluid (method, "The time step", stage 7). Ghosts of u are not kept up to date.
template <int D>
void bound_by_mouths(const Coupling<D>& c, const FaceField<D, std::int8_t>& valid, const std::vector<Twist<D>>& V,
                     const std::vector<double>& flux, FaceField<D>& u)
{
    constexpr std::int8_t known = 1, first_layer = 2;
    const Grid<D>& grid = *c.grid;
    struct Bounded {
        int axis;
        Index<D> face;
        double u;
    };
    const std::vector<Mouth<D>>& mouths = c.network.rim.mouths;
    std::vector<double> out;               // of the film, relative to its walls
    std::unordered_map<long, double> into; // the cells
    for (std::size_t r = 0; r < mouths.size(); ++r) {
        out.push_back(flux[r] - carried_flux(c, mouths[r], V));
        for (const auto& [key, weight] : mouths[r].cells)
            into[key] += weight * out[r];
    }
    std::vector<Bounded> bounded;
    for (std::size_t r = 0; r < mouths.size(); ++r) {
        const Mouth<D>& mouth = mouths[r];
        const int master = c.network.films[mouth.film].mesh.master;
        const Vec<D> wall = velocity_at<D>(V[master], mouth.x - c.solids[master].centre);
        const double speed = std::abs(out[r]) / (mouth.length * mouth.h);
        for (const auto& [key, weight] : mouth.cells) {
            if (into.at(key) <= 0)
                continue;
            for (const CellSide<D>& side : sides_of(grid, grid.cell_of_key(key))) {
                const int axis = side.axis;
                const Index<D> f = grid.wrapped(side.face);
                if (!owns_face(grid, axis, f) || valid(axis, f) != first_layer)
                    continue;
                const Index<D> opposite = f + (side.end == 0 ? 1 : -1) * step<D>(axis);
                if (valid(axis, opposite) != known)
                    continue;
                const double across = u(axis, opposite);
                bounded.push_back(
                    {axis, f,
                     std::clamp(u(axis, f), std::min(across, wall[axis] - speed), std::max(across, wall[axis] + speed))});
            }
        }
    }
    // Of a face's bounds the widest.
    std::sort(bounded.begin(), bounded.end(), [&](const Bounded& a, const Bounded& b) {
        if (a.axis != b.axis)
            return a.axis < b.axis;
        if (a.face != b.face)
            return std::lexicographical_compare(a.face.begin(), a.face.end(), b.face.begin(), b.face.end());
        const double now = u(a.axis, a.face);
        return std::abs(a.u - now) < std::abs(b.u - now);
    });
    for (std::size_t k = 0; k < bounded.size(); ++k)
        if (k == 0 || bounded[k].axis != bounded[k - 1].axis || bounded[k].face != bounded[k - 1].face)
            u(bounded[k].axis, bounded[k].face) = bounded[k].u;
}

} // namespace

template <int D>
double widest_sliver(const Model<D>& model, double dt)
{
    constexpr double share = 0.25, least = 0.02,
                     rate = 8; // of a face's surplus, in nu dt / dx^2: four neighbours, two walls close by
    const Scene& scene = model.scene;
    return std::max(least, share / (1 + rate * scene.viscosity * dt / (scene.density * model.grid.dx() * model.grid.dx())));
}

template <int D>
Reconstruction<D> reconstruct(const Model<D>& model, const Coupling<D>& here, State<D>& state, const std::vector<Twist<D>>& V)
{
    const Grid<D>& grid = model.grid;
    const BoundaryVelocity<D> sides = model.sides(state.time);
    FaceField<D>& u = state.velocity.grid;
    Reconstruction<D> result;
    FaceField<D, std::int8_t> valid = known_faces(here, widest_sliver(model, state.dt), u, result.slivers);

    result.histories = remember_films<D>(here.network, here.solids, V, state.velocity.film, state.velocity.mouth, grid.dx(),
                                         state.voids.empty_elements(here.network), state.pressure.film, state.film_increment);
    result.film_faces = FaceField<D, std::int8_t>(grid);
    result.any_film_faces = !here.network.films.empty();
    if (result.any_film_faces) {
        result.painted = u;
        FaceField<D, std::int8_t> painted_valid = valid;
        paint_films(here, result, painted_valid);
        extrapolate(grid, result.painted, painted_valid, extrapolated_layers);
        fill_velocity_ghosts(grid, result.painted, sides);
        follow_solids(here, painted_valid, V, sides, result.painted);
    }
    extrapolate(grid, u, valid, extrapolated_layers);
    bound_by_mouths(here, valid, V, state.velocity.mouth, u);
    fill_velocity_ghosts(grid, u, sides);
    follow_solids(here, valid, V, sides, u);
    for (Sliver<D>& face : result.slivers) {
        face.extrapolated = u(face.axis, face.at);
        face.around = velocity_at_face(u, face.axis, face.at).norm();
    }
    for (const Sliver<D>& face : result.slivers)
        u(face.axis, face.at) = face.own;
    std::erase_if(result.slivers, [](const Sliver<D>& face) { return std::abs(face.own - face.extrapolated) <= face.around; });
    fill_velocity_ghosts(grid, u, sides);
    return result;
}

template <int D>
void share_uncovered_faces(const Coupling<D>& there, const FaceFractions<D>& old, const FaceField<D, std::int8_t>& film_faces,
                           const FaceField<D>& u, const std::vector<Twist<D>>& V, FaceField<D>& u_star)
{
    const Grid<D>& grid = *there.grid;
    Near<D> near;
    for (int axis = 0; axis < D; ++axis)
        for_each_marked<D>(film_faces[axis], grid.low(), owned_faces_end(grid, axis), 1, [&](const Index<D>& f) {
            const double a_old = old.open(axis, f), a_new = there.fractions->open(axis, f);
            if (a_new > a_old + 1e-12)
                u_star(axis, f) += (a_new - a_old) / a_new * normal_surplus(there, u, axis, f, V, near);
        });
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template double widest_sliver<D>(const Model<D>&, double);                                                                 \
    template Reconstruction<D> reconstruct<D>(const Model<D>&, const Coupling<D>&, State<D>&, const std::vector<Twist<D>>&);   \
    template void share_uncovered_faces<D>(const Coupling<D>&, const FaceFractions<D>&, const FaceField<D, std::int8_t>&,      \
                                           const FaceField<D>&, const std::vector<Twist<D>>&, FaceField<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
