#include "gapflow/viscosity/viscous_system.hpp"

#include "gapflow/grid/far_field.hpp"
#include "gapflow/viscosity/following_faces.hpp"
#include "gapflow/viscosity/lattice_metric.hpp"
#include "gapflow/viscosity/narrow_gaps.hpp"
#include "gapflow/viscosity/viscous_faces.hpp"
#include "gapflow/viscosity/viscous_terms.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

// The system without its terms.
template <int D>
ViscousSystem<D> empty_system(const Coupling<D>& coupling, double viscosity, double dt)
{
    const Grid<D>& grid = *coupling.grid;
    ViscousSystem<D> system;
    system.grid = &grid;
    system.edge = viscosity * dt * std::pow(grid.dx(), D - 2);
    system.cell_mass = coupling.density * std::pow(grid.dx(), D);
    system.active = FaceField<D, std::int8_t>(grid);
    system.diagonal = FaceField<D>(grid);
    system.rhs = FaceField<D>(grid);
    system.turning.assign(coupling.solids.size(), Eigen::Matrix<double, spin_size<D>, spin_size<D>>::Zero());
    system.free_body = coupling.free_body;
    return system;
}

// The lattice's points and edges.
template <int D>
class ViscousLattice {
public:
    ViscousLattice(const Coupling<D>& coupling, const FaceField<D>& u_star, ViscousFaces<D>& faces, NarrowGaps<D>& gaps,
                   ViscousTerms<D>& terms, const Vec<D>& outside, ViscousSystem<D>& system)
        : grid_(*coupling.grid), far_(far_field(*coupling.grid)), outside_(outside), fractions_(*coupling.fractions),
          u_star_(u_star), faces_(faces), rays_(faces.rays()), gaps_(gaps), terms_(terms), system_(system)
    {
    }

    void add(int axis)
    {
        const Block<D>& block = system_.active[axis].block();
        const std::int8_t* active = system_.active[axis].data();
        const double full = system_.cell_mass + 2 * D * system_.edge;
        std::vector<Index<D>> special;
        for_each_row<D>(grid_.low(), owned_faces_end(grid_, axis), [&](const Index<D>& first) {
            const long begin = block.offset(first);
            const int count = owned_faces_end(grid_, axis)[0] - first[0];
            if (grid_.graded())
                return add_graded_row(axis, first, count, special);
            const double* u = &u_star_(axis, first);
            const int* cut = &fractions_.cut(axis, first);
            double *diagonal = &system_.diagonal(axis, first), *rhs = &system_.rhs(axis, first);
            double constant = 0;
            int plain = 0;
#pragma omp simd reduction(+ : plain, constant)
            for (int i = 0; i < count; ++i) {
                int around = active[begin + i];
                for (int k = 0; k < D; ++k)
                    around += active[begin + i - block.stride[k]] + active[begin + i + block.stride[k]];
                const bool is_plain = around == 2 * D + 1 && cut[i] < 0;
                diagonal[i] = is_plain ? full : 0.0;
                rhs[i] = is_plain ? system_.cell_mass * u[i] : 0.0;
                constant += rhs[i] * u[i];
                plain += is_plain;
            }
            system_.constant += constant;
            if (plain == count)
                return;
            Index<D> f = first;
            for (int i = 0; i < count; ++i, ++f[0])
                if (active[begin + i] && diagonal[i] == 0)
                    special.push_back(f);
        });
        for (const Index<D>& f : special)
            add_special_face(axis, f);
    }

private:
    // The same where cells differ in width.
    void add_graded_row(int axis, const Index<D>& first, int count, std::vector<Index<D>>& special)
    {
        const Block<D>& block = system_.active[axis].block();
        const std::int8_t* active = &system_.active(axis, first);
        const EdgeRow<D> edges(grid_, axis, first);
        Index<D> f = first;
        for (int i = 0; i < count; ++i, ++f[0]) {
            int around = active[i];
            double weights = 0;
            for (int k = 0; k < D; ++k) {
                around += active[i - block.stride[k]] + active[i + block.stride[k]];
                weights += edges.before(k, i) + edges.after(k, i);
            }
            if (around < 2 * D + 1 || fractions_.cut(axis, f) >= 0) {
                if (active[i])
                    special.push_back(f);
                continue;
            }
            const double mass = faces_.mass(axis, f), u = u_star_(axis, f);
            system_.diagonal(axis, f) = mass + weights * system_.edge;
            system_.rhs(axis, f) = mass * u;
            system_.constant += mass * u * u;
        }
    }

    // A lattice point next to a surface, a side, or what films have closed.
    void add_special_face(int axis, const Index<D>& f)
    {
        const long at = system_.active[axis].block().offset(f);
        const LatticeFace<D> face = faces_.examine(axis, f);
        const bool has_gap = gaps_.find(axis, f, at, face.share);
        const double whole_mass = faces_.mass(axis, f), counts = has_gap ? 1.0 : faces_.share_beside_walls(axis, f);
        if (counts < 1)
            system_.beside_walls.push_back({axis, at, (1 - counts) * whole_mass});
        ViscousTerm<D> inertia{axis, at, counts * whole_mass, face.share, u_star_(axis, f), {-1, -1}, {}};
        if (face.share != 1) {
            inertia.solid[0] = rays_.image(face.image).solid;
            inertia.row[0] = (1 - face.share) * faces_.row(face.image, axis, face.foot);
            system_.cut.push_back({axis, at, face.share, inertia.solid[0], inertia.row[0]});
        }
        terms_.add(inertia);
        rays_ready_ = false;
        for (int k = 0; k < D; ++k)
            for (int end = 0; end < 2; ++end)
                add_edge(axis, f, at, k, end);
    }

    // The lattice edge from f along k.
    void add_edge(int axis, const Index<D>& f, long at, int k, int end)
    {
        const int sign = 2 * end - 1;
        const Index<D> g = f + sign * step<D>(k);
        if (system_.active(axis, g)) {
            const double length = edge_length<D>(grid_, axis, end ? f : g, k);
            system_.diagonal[axis].data()[at] += system_.edge * (edge_section<D>(grid_, axis, f, k) / length);
            return;
        }
        const Vec<D> x = grid_.face_centre(axis, f), direction = sign * unit<D>(k);
        const bool leads_out = !grid_.periodic(k) && (g[k] < 0 || g[k] >= grid_.cells()[k] || (k == axis && g[k] == 0));
        const double edge = system_.edge * edge_section<D>(grid_, axis, f, k);
        // Distance to the side of the domain, over dx.
        const double to_side = k == axis ? edge_length<D>(grid_, axis, end ? f : g, k) : 0.5 * grid_.width(k, f[k]);
        const bool surface = faces_.near_surface(axis, f);
        WallHit<D> hit;
        if (surface || !leads_out) {
            if (!rays_ready_)
                rays_.around(x, faces_.reach(f));
            rays_ready_ = true;
            hit = rays_.cast(x, direction, faces_.reach(f));
        }
        ViscousTerm<D> term{axis, at, 0, 1, 0, {-1, -1}, {}};
        if (leads_out && (hit.image < 0 || hit.distance > to_side * grid_.dx())) {
            if (grid_.side(k, end) == SideKind::far)
                return add_far_edge(axis, f, k, end, term);
            if (k == axis && faces_.on_side(axis, f))
                return;
            term.stiffness = edge / to_side;
            switch (grid_.side(k, end)) {
            case SideKind::wall:
                term.solid[0] = faces_.wall(k, end);
                term.row[0] = -faces_.wall_row(term.solid[0], axis, x + to_side * grid_.dx() * direction);
                break;
            case SideKind::inflow:
                term.target = u_star_(axis, g);
                break;
            default:
                return;
            }
        } else {
            if (hit.image < 0)
                return; // belongs to a film
            term.stiffness = edge / std::max(hit.distance / grid_.dx(), least_distance);
            term.solid[0] = rays_.image(hit.image).solid;
            term.row[0] = -faces_.row(hit.image, axis, x + hit.distance * direction);
            const Twist<D> rise = faces_.row(hit.image, axis, x) + term.row[0]; // of the solid's own motion over the edge
            system_.turning[term.solid[0]] -=
                term.stiffness * term.row[0].template tail<spin_size<D>>() * rise.template tail<spin_size<D>>().transpose();
        }
        terms_.add(term);
    }

    // The lattice edge that leaves the domain through a far side. Slow flow around a body fades like r^-(d - 2) (a point force's), d the
    // number of endless axes.
    void add_far_edge(int axis, const Index<D>& f, int k, int end, ViscousTerm<D>& term)
    {
        const int degree = far_.dimensions() - 2;
        if (degree <= 0)
            return;
        Vec<D> x = grid_.face_centre(axis, f);
        x[k] = grid_.origin()[k] + end * grid_.size()[k];
        const double to_side = k == axis ? 0.0 : 0.5 * grid_.width(k, f[k]);
        term.stiffness =
            system_.edge * edge_section<D>(grid_, axis, f, k) / (to_side + 1 / (degree * far_.fading(k, x) * grid_.dx()));
        term.target = outside_[axis];
        terms_.add(term);
    }

    const Grid<D>& grid_;
    const FarField<D> far_;
    const Vec<D> outside_; ///< velocity of the fluid far away
    const FaceFractions<D>& fractions_;
    const FaceField<D>& u_star_;
    ViscousFaces<D>& faces_;
    WallRays<D>& rays_;
    bool rays_ready_ = false; ///< they lie around the point at hand
    NarrowGaps<D>& gaps_;
    ViscousTerms<D>& terms_;
    ViscousSystem<D>& system_;
};

} // namespace

template <int D>
ViscousSystem<D> viscous_system(const Coupling<D>& coupling, double viscosity, double dt, const FaceField<D>& u_star,
                                const ViscousBodies<D>& bodies, const Vec<D>& outside)
{
    ViscousSystem<D> system = empty_system(coupling, viscosity, dt);
    ViscousFaces<D> faces(coupling);
    faces.classify(system.active);
    ViscousTerms<D> terms(coupling, bodies, system);
    NarrowGaps<D> gaps(coupling, faces, system);
    ViscousLattice<D> lattice(coupling, u_star, faces, gaps, terms, outside, system);
    for (int axis = 0; axis < D; ++axis)
        lattice.add(axis);
    FollowingFaces<D> following(coupling, u_star, faces, gaps, terms, system);
    for (int axis = 0; axis < D; ++axis)
        following.add(axis);
    gaps.add_drag(terms);
    terms.finish();
    return system;
}

template ViscousSystem<2> viscous_system<2>(const Coupling<2>&, double, double, const FaceField<2>&, const ViscousBodies<2>&,
                                            const Vec<2>&);
template ViscousSystem<3> viscous_system<3>(const Coupling<3>&, double, double, const FaceField<3>&, const ViscousBodies<3>&,
                                            const Vec<3>&);

} // namespace gapflow
