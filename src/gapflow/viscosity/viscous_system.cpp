#include "gapflow/viscosity/viscous_system.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/grid/far_field.hpp"
#include "gapflow/viscosity/following_faces.hpp"
#include "gapflow/viscosity/lattice_metric.hpp"
#include "gapflow/viscosity/narrow_gaps.hpp"
#include "gapflow/viscosity/viscous_faces.hpp"
#include "gapflow/viscosity/viscous_terms.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

constexpr long chunks_at_once = 64; // what they give is kept until all are there

// The lattice's points and edges.
template <int D>
class ViscousLattice {
public:
    ViscousLattice(const Coupling<D>& coupling, const FaceField<D>& u_star, const ViscousFaces<D>& faces, NarrowGaps<D>& gaps,
                   ViscousTerms<D>& terms, const Vec<D>& outside, ViscousSystem<D>& system)
        : grid_(*coupling.grid), far_(far_field(*coupling.grid)), outside_(outside), fractions_(*coupling.fractions),
          u_star_(u_star), faces_(faces), gaps_(gaps), terms_(terms), system_(system)
    {
    }

    void add(int axis)
    {
        const Index<D> low = grid_.low(), end = owned_faces_end(grid_, axis);
        const std::vector<Rows> planes = each_plane(low[D - 1], end[D - 1], [&](int plane) {
            Rows rows;
            for_each_row_of_plane<D>(low, end, plane, [&](const Index<D>& first) {
                const int count = end[0] - first[0];
                rows.constants.push_back(grid_.graded() ? add_graded_row(axis, first, count, rows.special)
                                                        : add_row(axis, first, count, rows.special));
            });
            return rows;
        });
        std::vector<Index<D>> special;
        for (const Rows& rows : planes) {
            for (double constant : rows.constants)
                system_.constant += constant;
            special.insert(special.end(), rows.special.begin(), rows.special.end());
        }
        const long count = static_cast<long>(special.size());
        for (long first = 0; first < count; first += chunks_at_once * faces_a_chunk)
            for (const SpecialFaces& part :
                 each_chunk(std::min(chunks_at_once * faces_a_chunk, count - first), faces_a_chunk, [&](long begin, long end) {
                     WallRays<D> rays = faces_.rays();
                     SpecialFaces part;
                     for (long i = begin; i < end; ++i)
                         add_special_face(rays, axis, special[first + i], part);
                     return part;
                 }))
                take(axis, part);
    }

private:
    // Of a plane: sums over plain faces, one a row, and the faces that are not.
    struct Rows {
        std::vector<double> constants;
        std::vector<Index<D>> special;
    };

    // What a chunk of special faces gives beyond the values of the lattice at these faces, in their order.
    struct SpecialFaces {
        std::vector<double> constants;
        std::vector<ViscousTerm<D>> terms;
        std::vector<ViscousCutFace<D>> cut;
        std::vector<HeldMass> beside_walls;
        std::vector<std::pair<long, NarrowGap<D>>> gaps;
        std::vector<std::pair<int, Eigen::Matrix<double, spin_size<D>, spin_size<D>>>> turning;
    };

    void take(int axis, const SpecialFaces& part)
    {
        for (double constant : part.constants)
            system_.constant += constant;
        for (const ViscousTerm<D>& term : part.terms)
            terms_.add_to_bodies(term);
        system_.cut.insert(system_.cut.end(), part.cut.begin(), part.cut.end());
        system_.beside_walls.insert(system_.beside_walls.end(), part.beside_walls.begin(), part.beside_walls.end());
        for (const auto& [at, gap] : part.gaps)
            gaps_.keep(axis, at, gap);
        for (const auto& [solid, turning] : part.turning)
            system_.turning[solid] -= turning;
    }

    void add_term(const ViscousTerm<D>& term, SpecialFaces& part) const
    {
        part.constants.push_back(terms_.add_to_lattice(term));
        if (term.solid[0] >= 0 || term.solid[1] >= 0)
            part.terms.push_back(term);
    }

    // The plain faces of a row. Returns what they add to the system's constant.
    double add_row(int axis, const Index<D>& first, int count, std::vector<Index<D>>& special)
    {
        const Block<D>& block = system_.active[axis].block();
        const std::int8_t* active = &system_.active(axis, first);
        const double full = system_.cell_mass + 2 * D * system_.edge;
        const double* u = &u_star_(axis, first);
        const int* cut = &fractions_.cut(axis, first);
        double *diagonal = &system_.diagonal(axis, first), *rhs = &system_.rhs(axis, first);
        double constant = 0;
        int plain = 0;
#pragma omp simd reduction(+ : plain, constant)
        for (int i = 0; i < count; ++i) {
            int around = active[i];
            for (int k = 0; k < D; ++k)
                around += active[i - block.stride[k]] + active[i + block.stride[k]];
            const bool is_plain = around == 2 * D + 1 && cut[i] < 0;
            diagonal[i] = is_plain ? full : 0.0;
            rhs[i] = is_plain ? system_.cell_mass * u[i] : 0.0;
            constant += rhs[i] * u[i];
            plain += is_plain;
        }
        Index<D> f = first;
        for (int i = 0; i < count && plain < count; ++i, ++f[0])
            if (active[i] && diagonal[i] == 0)
                special.push_back(f);
        return constant;
    }

    // The same where cells differ in width.
    double add_graded_row(int axis, const Index<D>& first, int count, std::vector<Index<D>>& special)
    {
        double constant = 0;
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
            constant += mass * u * u;
        }
        return constant;
    }

    // A lattice point next to a surface, a side, or what films have closed.
    void add_special_face(WallRays<D>& rays, int axis, const Index<D>& f, SpecialFaces& part) const
    {
        const long at = system_.active[axis].block().offset(f);
        const LatticeFace<D> face = faces_.examine(rays, axis, f);
        const std::optional<NarrowGap<D>> gap = gaps_.find(rays, axis, f, face.share);
        if (gap)
            part.gaps.emplace_back(at, *gap);
        const double whole_mass = faces_.mass(axis, f), counts = gap ? 1.0 : faces_.share_beside_walls(axis, f);
        if (counts < 1)
            part.beside_walls.push_back({axis, at, (1 - counts) * whole_mass});
        ViscousTerm<D> inertia{axis, at, counts * whole_mass, face.share, u_star_(axis, f), {-1, -1}, {}};
        if (face.share != 1) {
            inertia.solid[0] = faces_.image(face.image).solid;
            inertia.row[0] = (1 - face.share) * faces_.row(face.image, axis, face.foot);
            part.cut.push_back({axis, at, face.share, inertia.solid[0], inertia.row[0]});
        }
        add_term(inertia, part);
        for (int k = 0; k < D; ++k)
            for (int end = 0; end < 2; ++end)
                add_edge(rays, axis, f, at, k, end, part);
    }

    // The lattice edge from f along k.
    void add_edge(WallRays<D>& rays, int axis, const Index<D>& f, long at, int k, int end, SpecialFaces& part) const
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
            rays.around(x, faces_.reach(f));
            hit = rays.cast(x, direction, faces_.reach(f));
        }
        ViscousTerm<D> term{axis, at, 0, 1, 0, {-1, -1}, {}};
        if (leads_out && (hit.image < 0 || hit.distance > to_side * grid_.dx())) {
            if (grid_.side(k, end) == SideKind::far)
                return add_far_edge(axis, f, k, end, term, part);
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
            term.solid[0] = faces_.image(hit.image).solid;
            term.row[0] = -faces_.row(hit.image, axis, x + hit.distance * direction);
            const Twist<D> rise = faces_.row(hit.image, axis, x) + term.row[0]; // of the solid's own motion over the edge
            part.turning.emplace_back(term.solid[0], term.stiffness * term.row[0].template tail<spin_size<D>>() *
                                                         rise.template tail<spin_size<D>>().transpose());
        }
        add_term(term, part);
    }

    // The lattice edge that leaves the domain through a far side. Slow flow around a body fades like r^-(d - 2) (a point force's), d the
    // number of endless axes.
    void add_far_edge(int axis, const Index<D>& f, int k, int end, ViscousTerm<D>& term, SpecialFaces& part) const
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
        add_term(term, part);
    }

    const Grid<D>& grid_;
    const FarField<D> far_;
    const Vec<D> outside_; ///< velocity of the fluid far away
    const FaceFractions<D>& fractions_;
    const FaceField<D>& u_star_;
    const ViscousFaces<D>& faces_;
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
