// Velocities beyond the fluid: continued into solids and films, and where surfaces uncover faces (method, "The time step", stage 7).
#include "gapflow/stepping/simulation.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/grid/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gapflow {

namespace {

// Layers of faces that velocities are continued into solids and films.
constexpr int continued_layers = 4;

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

} // namespace

// Stage 7: velocities continued into solids and films for the next traces; films remembered; faces that leave a film.
template <int D>
void Simulation<D>::continue_velocities()
{
    const auto timer = stages_.measure("continuation");
    const Coupling<D>& c = *coupling_;
    FaceField<D, std::int8_t> valid(grid_);
    const double widest = sliver();
    slivers_.clear();
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> low = grid_.low(), end = owned_faces_end(grid_, axis);
        const int n = end[0] - low[0];
        // What walls and inflow give counts everywhere on their sides. A face of an open side that a body covers has no velocity of its own:
        // nothing would bound what advection makes of it from step to step.
        auto given = [&](int end) { return !grid_.periodic(axis) && grid_.side(axis, end) != SideKind::open; };
        auto at_side = [&](int place) { return (place == 0 && given(0)) || (place == grid_.cells()[axis] && given(1)); };
        auto of_plane = [&](int plane) {
            std::vector<Sliver> slivers;
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
                        slivers.push_back({axis, f, open[i], velocity_.grid(axis, f), 0, 0});
                if (axis == 0) {
                    to[0] |= at_side(row[0]);
                    to[n - 1] |= at_side(row[0] + n - 1);
                } else if (at_side(row[axis])) {
                    std::fill_n(to, n, std::int8_t{1});
                }
            });
            return slivers;
        };
        for (std::vector<Sliver>& slivers : each_plane(low[D - 1], end[D - 1], of_plane))
            slivers_.insert(slivers_.end(), slivers.begin(), slivers.end());
    }

    memories_ = remember_films<D>(c.network, c.solids, twists(), velocity_.film, velocity_.conduit, grid_.dx(),
                                  voids_.empty_elements(c.network), film_push_);
    film_faces_ = FaceField<D, std::int8_t>(grid_);
    any_film_faces_ = !c.network.films.empty();
    if (any_film_faces_) {
        painted_ = velocity_.grid;
        FaceField<D, std::int8_t> painted_valid = valid;
        paint_films(painted_valid);
        extrapolate(grid_, painted_, painted_valid, continued_layers);
        fill_velocity_ghosts(grid_, painted_, side_velocities(time_));
        follow_solids(painted_, painted_valid);
    }
    extrapolate(grid_, velocity_.grid, valid, continued_layers);
    fill_velocity_ghosts(grid_, velocity_.grid, side_velocities(time_));
    follow_solids(velocity_.grid, valid);
    for (Sliver& face : slivers_) {
        face.continued = velocity_.grid(face.axis, face.at);
        face.around = velocity_at_face(velocity_.grid, face.axis, face.at).norm();
    }
    for (const Sliver& face : slivers_)
        velocity_.grid(face.axis, face.at) = face.own;
    std::erase_if(slivers_, [](const Sliver& face) { return std::abs(face.own - face.continued) <= face.around; });
    fill_velocity_ghosts(grid_, velocity_.grid, side_velocities(time_));
}

// Where a solid has uncovered more of a face, the fresh part starts with the solid's normal velocity:
//     a_new u* = a_old u_advected + (a_new - a_old) (u_advected + n n . (U_b - u)).
// Else a surface that leaves a grid plane by round-off gives the whole face the speed of a jet that filled a sliver of it.
template <int D>
void Simulation<D>::share_uncovered_faces(FaceField<D>& u_star) const
{
    const Coupling<D>& c = *coupling_;
    const std::vector<Twist<D>> V = twists();
    std::vector<int> near;
    for (int axis = 0; axis < D; ++axis)
        for_each_marked<D>(film_faces_[axis], grid_.low(), owned_faces_end(grid_, axis), 1, [&](const Index<D>& f) {
            const double a_old = old_fractions_->open(axis, f), a_new = c.fractions->open(axis, f);
            if (a_new > a_old + 1e-12)
                u_star(axis, f) += (a_new - a_old) / a_new * normal_surplus(velocity_.grid, axis, f, V, near);
        });
}

// Component along `axis` of n n . (U_b - u) at a face: what u lacks of the nearest solid's normal velocity.
template <int D>
double Simulation<D>::normal_surplus(const FaceField<D>& u, int axis, const Index<D>& f, const std::vector<Twist<D>>& V,
                                     std::vector<int>& near) const
{
    const Coupling<D>& c = *coupling_;
    const Vec<D> x = grid_.face_centre(axis, f);
    c.clipper->near(x, grid_.dx(), near);
    // Halfway between two solids either counts by half: which comes first in the scene must not matter.
    const auto& images = c.clipper->images();
    double distance = grid_.dx();
    for (int i : near)
        distance = std::min(distance, images[i].shape.distance(x));
    if (distance >= grid_.dx())
        return 0;
    const Vec<D> fluid = velocity_at_face(u, axis, f);
    double surplus = 0;
    int count = 0;
    for (int i : near)
        if (near.size() == 1 || images[i].shape.distance(x) <= distance + 1e-9 * grid_.dx()) {
            const Vec<D> n = images[i].shape.closest(x).normal;
            const Vec<D> relative =
                velocity_at<D>(V[images[i].solid], x - c.solids[images[i].solid].centre - images[i].shift) - fluid;
            surplus += n[axis] * n.dot(relative);
            ++count;
        }
    return surplus / count;
}

// Continued velocities keep the solids' normal velocity: u += n n . (U_b - u) with the nearest solid's n. Without it a face
// that a moving surface uncovers brings momentum through that surface, a kick on the body that does not shrink with dt.
template <int D>
void Simulation<D>::follow_solids(FaceField<D>& u, const FaceField<D, std::int8_t>& valid) const
{
    const std::vector<Twist<D>> V = twists();
    std::vector<std::pair<int, Index<D>>> faces;
    for (int axis = 0; axis < D; ++axis)
        for_each_marked<D>(valid[axis], grid_.low(), owned_faces_end(grid_, axis), 2,
                           [&](const Index<D>& f) { faces.emplace_back(axis, f); });
    std::vector<double> surplus(faces.size());
    for_each_part(static_cast<long>(faces.size()), [&](long begin, long end) {
        std::vector<int> near;
        for (long k = begin; k < end; ++k)
            surplus[k] = normal_surplus(u, faces[k].first, faces[k].second, V, near);
    });
    for (std::size_t k = 0; k < faces.size(); ++k)
        u(faces[k].first, faces[k].second) += surplus[k];
    fill_velocity_ghosts(grid_, u, side_velocities(time_));
}

// Faces of film cells get the film's velocity: along it the film's own, across it what the walls give it.
template <int D>
void Simulation<D>::paint_films(FaceField<D, std::int8_t>& valid)
{
    const FilmNetwork<D>& network = coupling_->network;
    std::vector<int> near(network.films.size(), -1); // element of each film's memory close to the last face
    for (const auto& [key, cell] : network.cells.cells) {
        if (cell.kind != CellKind::film)
            continue;
        const Film<D>& film = network.films[cell.owner];
        const PlacedShape<D>& master = coupling_->solids[film.pair.master].shape;
        const FilmMemory<D>& memory = *memories_.at(film.pair);
        for (const CellSide<D>& side : sides_of(grid_, grid_.cell_of_key(key))) {
            const Index<D> f = grid_.wrapped(side.face);
            const Index<D> end = owned_faces_end(grid_, side.axis);
            if ((f.array() < grid_.low().array()).any() || (f.array() >= end.array()).any() || valid(side.axis, f))
                continue;
            const Vec<D> x = grid_.face_centre(side.axis, Index<D>(side.face + cell.offset(cell.owner)));
            // From the master's surface, on which the memory lies: next to it there is no need to search.
            const Vec<D> on_master = master.to_body(master.closest(x).x);
            painted_(side.axis, f) = memory.at(on_master, near[cell.owner]).velocity[side.axis];
            valid(side.axis, f) = 1;
            film_faces_(side.axis, f) = 1;
        }
    }
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template void Simulation<D>::continue_velocities();                                                                        \
    template void Simulation<D>::share_uncovered_faces(FaceField<D>&) const;
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
