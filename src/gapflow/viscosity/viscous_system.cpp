#include "gapflow/viscosity/viscous_system.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/viscosity/wall_rays.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace gapflow {

namespace {

// Rays are this long, in dx: past a neighbour in the solid, or next to one, up to its surface.
constexpr double ray_length = 1.7;
// No surface counts as nearer to a lattice point than this, in dx.
constexpr double least_distance = 1e-3;
// A cut face whose mean velocity (relative to the solid) is this many times that at its centre follows a neighbour instead.
constexpr double largest_share = 2.0;
// Gaps of up to this many cells get the drag that the lattice lacks.
constexpr double thin_gap = 8;
// Surfaces of a gap face each other: cosine of their normals at most.
constexpr double opposed = -0.5;
// Open fraction from which a face counts as whole.
constexpr double whole = 1 - 1e-9;

template <int D>
class ViscousBuilder {
public:
    ViscousBuilder(const Coupling<D>& coupling, double viscosity, double dt, const FaceField<D>& u_star,
                   const ViscousBodies<D>& bodies)
        : coupling_(coupling), grid_(*coupling.grid), fractions_(*coupling.fractions), u_star_(u_star), bodies_(bodies),
          rays_(*coupling.clipper, grid_.dx())
    {
        system_.grid = &grid_;
        system_.edge = viscosity * dt * std::pow(grid_.dx(), D - 2);
        system_.cell_mass = coupling.density * std::pow(grid_.dx(), D);
        system_.active = FaceField<D, std::int8_t>(grid_);
        system_.diagonal = FaceField<D>(grid_);
        system_.rhs = FaceField<D>(grid_);
        system_.turning.assign(coupling.solids.size(), Spins::Zero());
        system_.free_body = coupling.free_body;
    }

    ViscousSystem<D> build()
    {
        find_walls();
        mark_surfaces();
        classify();
        body_rhs_ = Eigen::VectorXd::Zero(n * coupling_.system.bodies);
        for (int axis = 0; axis < D; ++axis)
            add_lattice(axis);
        for (int axis = 0; axis < D; ++axis)
            add_following_faces(axis);
        for (const auto& [place, gap] : gaps_)
            add_gap_drag(place.first, place.second, gap);
        finish_bodies();
        return std::move(system_);
    }

private:
    static constexpr int n = twist_size<D>;
    using Spins = Eigen::Matrix<double, spin_size<D>, spin_size<D>>;

    enum class Role { none, active, following };
    struct Face {
        Role role = Role::none;
        double share = 1;  ///< s
        int image = -1;
        Vec<D> foot;       ///< x*
        Vec<D> shift;      ///< centroid less centre
        Vec<D> centroid;
    };

    long offset(int axis, const Index<D>& f) const { return system_.active[axis].block().offset(f); }

    // The walls' solids by side.
    void find_walls()
    {
        wall_.fill(-1);
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end) {
                if (grid_.side(axis, end) != SideKind::wall)
                    continue;
                Vec<D> x = grid_.origin() + 0.5 * grid_.size();
                x[axis] = grid_.origin()[axis] + end * grid_.size()[axis];
                for (std::size_t s = 0; s < coupling_.solids.size(); ++s) {
                    if (!coupling_.solids[s].wall)
                        continue;
                    const SurfacePoint<D> p = coupling_.solids[s].shape.closest(x);
                    if (std::abs(p.distance) < 1e-6 * grid_.dx() && p.normal[axis] * (end ? -1 : 1) > 0.5)
                        wall_[2 * axis + end] = static_cast<int>(s);
                }
            }
    }

    void mark_surfaces()
    {
        surface_ = CellField<D, std::int8_t>(grid_);
        for (const Index<D>& c : fractions_.surface_cells)
            surface_(c) = 1;
        exchange(grid_, surface_, 1);
    }

    // Is the face one of the grid's, and does the pressure drive it?
    bool is_open(int axis, const Index<D>& f) const
    {
        for (int k = 0; k < D; ++k)
            if (!grid_.periodic(k) && (f[k] < 0 || f[k] >= grid_.cells()[k] + (k == axis)))
                return false;
        if (!(coupling_.open(axis, f) > 1e-12))
            return false;
        if (grid_.periodic(axis) || (f[axis] > 0 && f[axis] < grid_.cells()[axis]))
            return true;
        const Index<D> inner = f[axis] > 0 ? Index<D>(f - step<D>(axis)) : f;
        return grid_.side(axis, f[axis] > 0) == SideKind::open &&
               static_cast<CellKind>(coupling_.kind(inner)) != CellKind::film;
    }
    bool on_side(int axis, const Index<D>& f) const
    {
        return !grid_.periodic(axis) && (f[axis] == 0 || f[axis] == grid_.cells()[axis]);
    }
    double mass(int axis, const Index<D>& f) const
    {
        return system_.cell_mass * coupling_.open(axis, f) * (on_side(axis, f) ? 0.5 : 1.0);
    }

    // Share of a face's inertia that counts next to walls of the domain, half a cell from it: of its part at either wall, the third of a
    // cell that the wall holds moves with the wall, and the wall bears what the pressure does to it. Plane Poiseuille flow is then exact.
    double share_beside_walls(int axis, const Index<D>& f) const
    {
        double share = 1;
        for (int k = 0; k < D; ++k) {
            if (k == axis || grid_.periodic(k))
                continue;
            int walls = 0;
            for (int end = 0; end < 2; ++end)
                walls += f[k] == end * (grid_.cells()[k] - 1) && grid_.side(k, end) == SideKind::wall;
            share *= 1 - walls / 3.0;
        }
        return share;
    }

    // What a cut face is to the lattice. Any face of this rank or of the ghost layer: the same on all ranks.
    Face examine(int axis, const Index<D>& f)
    {
        Face face;
        if (!is_open(axis, f))
            return face;
        face.role = Role::active;
        const int cut = fractions_.cut(axis, f);
        if (cut < 0 || fractions_.faces[cut].open >= whole)
            return face;
        const Vec<D> x = grid_.face_centre(axis, f);
        face.centroid = fractions_.faces[cut].open_centroid;
        face.shift = face.centroid - x;
        rays_.around(x, ray_length * grid_.dx());
        if (rays_.distance(x) <= least_distance * grid_.dx()) {
            face.role = Role::following;
            return face;
        }
        const double length = face.shift.norm();
        if (length < 1e-6 * grid_.dx())
            return face;
        const WallHit<D> hit = rays_.cast(x, -face.shift / length, ray_length * grid_.dx());
        if (hit.image < 0)
            return face;
        face.share = 1 + length / std::max(hit.distance, least_distance * grid_.dx());
        face.image = hit.image;
        face.foot = x - hit.distance / length * face.shift;
        if (face.share > largest_share)
            face.role = Role::following;
        return face;
    }

    /// Calls f(first face of a row, number of faces) for this rank's rows of faces, planes shared out over threads.
    template <class F>
    void for_owned_rows(int axis, F&& f) const
    {
        const Index<D> low = grid_.low(), end = owned_faces_end(grid_, axis);
        for_each_plane(low[D - 1], end[D - 1], [&](int plane) {
            Index<D> from = low, to = end;
            from[D - 1] = plane;
            to[D - 1] = plane + 1;
            for_each_row<D>(from, to, [&](const Index<D>& row) { f(row, end[0] - low[0]); });
        });
    }
    bool any_cut(int axis, const Index<D>& row, int count) const
    {
        const int* cut = &fractions_.cut(axis, row);
        int largest = -1;
        for (int i = 0; i < count; ++i)
            largest = std::max(largest, cut[i]);
        return largest >= 0;
    }

    // Whole faces by rows; those that surfaces cut, and those on sides of the domain, one by one.
    void classify()
    {
        std::vector<std::pair<int, Index<D>>> others;
        std::mutex mutex;
        for (int axis = 0; axis < D; ++axis)
            for_owned_rows(axis, [&](const Index<D>& row, int count) {
                const double* open = &coupling_.open(axis, row);
                std::int8_t* to = &system_.active(axis, row);
                for (int i = 0; i < count; ++i)
                    to[i] = open[i] > 1e-12;
                Index<D> last = row;
                last[0] += count - 1;
                const bool cut = any_cut(axis, row, count), side = on_side(axis, row), last_on_side = on_side(axis, last);
                if (!cut && !side && !last_on_side)
                    return;
                const std::lock_guard lock(mutex);
                for (Index<D> f = row; f[0] <= last[0]; ++f[0])
                    if (to[f[0] - row[0]] && (fractions_.cut(axis, f) >= 0 || on_side(axis, f)))
                        others.emplace_back(axis, f);
            });
        for (const auto& [axis, f] : others)
            system_.active(axis, f) = examine(axis, f).role == Role::active;
        exchange(grid_, system_.active, 1);
    }

    // Row of the velocity component along `axis` of a solid's image at x.
    Twist<D> row(int image, int axis, const Vec<D>& x) const
    {
        const Image<D>& at = rays_.image(image);
        return wrench<D>(unit<D>(axis), x - coupling_.solids[at.solid].centre - at.shift);
    }
    Twist<D> wall_row(int solid, int axis, const Vec<D>& x) const
    {
        return wrench<D>(unit<D>(axis), x - coupling_.solids[solid].centre);
    }

    void add(const ViscousTerm<D>& term)
    {
        double target = term.target;
        bool any = false;
        for (int k = 0; k < 2; ++k) {
            const int s = term.solid[k];
            if (s < 0)
                continue;
            if (coupling_.free_body[s] < 0)
                target -= term.row[k].dot(bodies_.twists[s]);
            any = any || !coupling_.solids[s].wall;
        }
        system_.constant += term.stiffness * target * target;
        if (term.at >= 0) {
            system_.diagonal[term.axis].data()[term.at] += term.stiffness * term.weight * term.weight;
            system_.rhs[term.axis].data()[term.at] += term.stiffness * term.weight * target;
        }
        if (any)
            system_.terms.push_back(term);
        for (int i = 0; i < 2; ++i) {
            const int a = term.solid[i] < 0 ? -1 : coupling_.free_body[term.solid[i]];
            if (a < 0)
                continue;
            const Twist<D> row_a = coupling_.solids[term.solid[i]].admissible * term.row[i];
            body_rhs_.segment<n>(n * a) += term.stiffness * target * row_a;
            for (int j = 0; j < 2; ++j) {
                const int b = term.solid[j] < 0 ? -1 : coupling_.free_body[term.solid[j]];
                if (b >= 0)
                    add_block(a, b, term.stiffness * row_a * (coupling_.solids[term.solid[j]].admissible * term.row[j]).transpose());
            }
        }
    }

    void add_block(int a, int b, const TwistMatrix<D>& block)
    {
        auto [at, is_new] = blocks_.try_emplace({a, b}, block);
        if (!is_new)
            at->second += block;
    }

    void add_lattice(int axis)
    {
        const Block<D>& block = system_.active[axis].block();
        const std::int8_t* active = system_.active[axis].data();
        const double full = system_.cell_mass + 2 * D * system_.edge;
        std::vector<Index<D>> special;
        for_each_row<D>(grid_.low(), owned_faces_end(grid_, axis), [&](const Index<D>& first) {
            const long begin = block.offset(first);
            const int count = owned_faces_end(grid_, axis)[0] - first[0];
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

    // A lattice point next to a surface, a side, or what films have closed.
    void add_special_face(int axis, const Index<D>& f)
    {
        const long at = offset(axis, f);
        const Face face = examine(axis, f);
        const bool has_gap = find_gap_drag(axis, f, at, face.share);
        const double whole_mass = mass(axis, f), counts = has_gap ? 1.0 : share_beside_walls(axis, f);
        if (counts < 1)
            system_.beside_walls.push_back({axis, at, (1 - counts) * whole_mass});
        ViscousTerm<D> inertia{axis, at, counts * whole_mass, face.share, u_star_(axis, f), {-1, -1}, {}};
        if (face.share != 1) {
            inertia.solid[0] = rays_.image(face.image).solid;
            inertia.row[0] = (1 - face.share) * row(face.image, axis, face.foot);
            system_.cut.push_back({axis, at, face.share, inertia.solid[0], inertia.row[0]});
        }
        add(inertia);
        rays_ready_ = false;
        for (int k = 0; k < D; ++k)
            for (int end = 0; end < 2; ++end)
                add_edge(axis, f, at, k, end);
    }

    // The narrow gap around a lattice point. Lengths in dx.
    struct Gap {
        std::array<int, 2> image;  ///< near and far
        std::array<Vec<D>, 2> foot;
        Vec<D> x, normal;          ///< of the point; unit, from the near surface to the far one
        double near, width;        ///< distance to the near surface; of the gap
        double value;              ///< what the point has in plane Poiseuille flow y (h - y) / 2
        double lacking;            ///< force that the lattice lacks there, of the unit pressure gradient's
    };

    std::optional<Gap> narrow_gap(const Vec<D>& x)
    {
        rays_.around(x, thin_gap * grid_.dx());
        if (const int lone = rays_.lone_image(); lone >= 0 && coupling_.solids[rays_.image(lone).solid].wall)
            return {}; // a side of the domain, and nothing that faces it
        Gap gap;
        int image = -1;
        const double phi = rays_.distance(x, &image);
        if (image < 0 || phi <= least_distance * grid_.dx() || phi > ray_length * grid_.dx())
            return {};
        const SurfacePoint<D> wall = rays_.image(image).shape.closest(x);
        const WallHit<D> far = rays_.cast(x, wall.normal, thin_gap * grid_.dx() - phi);
        if (far.image < 0)
            return {};
        const Vec<D> beyond = x + far.distance * wall.normal;
        if (wall.normal.dot(rays_.image(far.image).shape.closest(beyond).normal) > opposed)
            return {};
        gap.image = {image, far.image};
        gap.foot = {wall.x, beyond};
        gap.x = x;
        gap.normal = wall.normal;
        gap.near = phi / grid_.dx();
        gap.width = gap.near + far.distance / grid_.dx();
        gap.value = gap.lacking = 0;
        return gap;
    }

    // Mean of y (h - y) / 2 over the part `open` of a face around its centroid: that there, and what the profile's curvature takes.
    double face_mean(const Gap& gap, int axis, const Vec<D>& centroid, double open) const
    {
        const double y = gap.near + gap.normal.dot(centroid - gap.x) / grid_.dx();
        const double spread = (1 - gap.normal[axis] * gap.normal[axis]) * (D == 2 ? open * open : open) / 12;
        return 0.5 * y * (gap.width - y) - 0.5 * spread;
    }

    // The lattice's value in the same flow at a face of the gap.
    double lattice_value(const Gap& gap, int axis, const Index<D>& f)
    {
        const int cut = fractions_.cut(axis, f);
        if (cut < 0)
            return face_mean(gap, axis, grid_.face_centre(axis, f), 1.0);
        const Face face = examine(axis, f);
        const ClippedFace<D>& part = fractions_.faces[cut];
        return face_mean(gap, axis, part.open_centroid, part.open) / face.share;
    }

    // Gaps of a few cells: a point next to a surface, whose second difference is too weak there. Returns whether there is one.
    bool find_gap_drag(int axis, const Index<D>& f, long at, double share)
    {
        std::optional<Gap> gap = narrow_gap(grid_.face_centre(axis, f));
        if (!gap)
            return false;
        gap->value = lattice_value(*gap, axis, f);
        if (!(gap->value > 0))
            return false;
        gap->lacking = share * coupling_.open(axis, f);
        for (int k = 0; k < D; ++k)
            for (int end = 0; end < 2; ++end) {
                const int sign = 2 * end - 1;
                const Index<D> g = f + sign * step<D>(k);
                if (system_.active(axis, g)) {
                    gap->lacking -= gap->value - lattice_value(*gap, axis, g);
                    continue;
                }
                rays_.around(gap->x, ray_length * grid_.dx());
                const WallHit<D> hit = rays_.cast(gap->x, sign * unit<D>(k), ray_length * grid_.dx());
                if (hit.image >= 0)
                    gap->lacking -= gap->value / std::max(hit.distance / grid_.dx(), least_distance);
            }
        gaps_.try_emplace({axis, at}, *gap);
        return true;
    }

    void add_gap_drag(int axis, long at, const Gap& gap)
    {
        if (gap.lacking <= 0)
            return;
        ViscousTerm<D> term{axis, at, system_.edge * gap.lacking / gap.value, 1, 0, {-1, -1}, {}};
        const double part = gap.near / gap.width;
        for (int k = 0; k < 2; ++k) {
            term.solid[k] = rays_.image(gap.image[k]).solid;
            term.row[k] = -(k == 0 ? 1 - part : part) * row(gap.image[k], axis, gap.foot[k]);
        }
        add(term);
    }

    // A face that follows a point of a narrow gap: as stiff as its own share of that flow asks for. Returns what it passes on of the
    // pressure's force to its leader.
    double stiffen(int axis, const Index<D>& f, const Face& face, const Index<D>& leader, FollowingFace<D>& following)
    {
        const std::optional<Gap> gap = narrow_gap(grid_.face_centre(axis, leader));
        const double open = coupling_.open(axis, f);
        if (!gap)
            return 0;
        const double led = following.share * lattice_value(*gap, axis, leader), own = face_mean(*gap, axis, face.centroid, open);
        if (own > led * (1 + 1e-6))
            following.stiffness = std::max(following.stiffness, system_.edge * open / (own - led));
        return following.share * open;
    }

    // The lattice edge from f along k.
    void add_edge(int axis, const Index<D>& f, long at, int k, int end)
    {
        const int sign = 2 * end - 1;
        const Index<D> g = f + sign * step<D>(k);
        if (system_.active(axis, g)) {
            system_.diagonal[axis].data()[at] += system_.edge;
            return;
        }
        const Vec<D> x = grid_.face_centre(axis, f), direction = sign * unit<D>(k);
        const bool leads_out = !grid_.periodic(k) && (g[k] < 0 || g[k] >= grid_.cells()[k] || (k == axis && g[k] == 0));
        // Distance to the side of the domain, in cells.
        const double to_side = k == axis ? 1.0 : 0.5;
        const bool surface = near_surface(axis, f);
        WallHit<D> hit;
        if (surface || !leads_out) {
            if (!rays_ready_)
                rays_.around(x, ray_length * grid_.dx());
            rays_ready_ = true;
            hit = rays_.cast(x, direction, ray_length * grid_.dx());
        }
        ViscousTerm<D> term{axis, at, 0, 1, 0, {-1, -1}, {}};
        if (leads_out && (hit.image < 0 || hit.distance > to_side * grid_.dx())) {
            if (k == axis && on_side(axis, f))
                return;
            term.stiffness = system_.edge / to_side;
            switch (grid_.side(k, end)) {
            case SideKind::wall:
                term.solid[0] = wall_[2 * k + end];
                term.row[0] = -wall_row(term.solid[0], axis, x + to_side * grid_.dx() * direction);
                break;
            case SideKind::inflow:
                term.target = u_star_(axis, g);
                break;
            default:
                return;
            }
        } else {
            if (hit.image < 0)
                return; // what films carry
            term.stiffness = system_.edge / std::max(hit.distance / grid_.dx(), least_distance);
            term.solid[0] = rays_.image(hit.image).solid;
            term.row[0] = -row(hit.image, axis, x + hit.distance * direction);
            const Twist<D> rise = row(hit.image, axis, x) + term.row[0]; // of the solid's own motion over the edge
            system_.turning[term.solid[0]] -= term.stiffness * term.row[0].template tail<spin_size<D>>() *
                                              rise.template tail<spin_size<D>>().transpose();
        }
        add(term);
    }

    bool near_surface(int axis, const Index<D>& f) const
    {
        return surface_(f) || surface_(Index<D>(f - step<D>(axis)));
    }

    // Cut faces whose centres lie in solids or next to them. This rank adds those whose leader it owns.
    void add_following_faces(int axis)
    {
        const Index<D> ones = Index<D>::Ones();
        const Index<D> owned = owned_faces_end(grid_, axis);
        auto is_mine = [&](const Index<D>& f) { return (f.array() >= grid_.low().array()).all() && (f.array() < owned.array()).all(); };
        auto add_face = [&](const Index<D>& f) {
            if (fractions_.cut(axis, f) < 0)
                return;
            const Face face = examine(axis, f);
            if (face.role != Role::following)
                return;
            FollowingFace<D> following{axis, offset(axis, f), -1, mass(axis, f), 0, 0, {-1, -1}, {}};
            const Index<D> leader = leader_of(axis, f, face, following);
            const bool mine = is_mine(f), leads = following.leader >= 0 ? is_mine(leader) : mine;
            const double passed_on = following.leader >= 0 ? stiffen(axis, f, face, leader, following) : 0.0;
            if (leads) {
                if (const auto gap = gaps_.find({axis, following.leader}); gap != gaps_.end())
                    gap->second.lacking += passed_on;
                ViscousTerm<D> term{axis, following.leader, 0, following.share, u_star_(axis, f), following.solid, following.row};
                term.stiffness = following.mass * following.stiffness / (following.mass + following.stiffness);
                add(term);
            }
            if (mine)
                system_.following.push_back(following);
        };
        const int count = owned[0] - grid_.low()[0] + 2;
        for_each_row<D>(grid_.low() - ones, owned + ones, [&](const Index<D>& row) {
            if (!any_cut(axis, row, count))
                return;
            for (Index<D> f = row; f[0] < row[0] + count; ++f[0])
                add_face(f);
        });
    }

    // The neighbour that lies best in the direction of the open part; fills in how the face follows it.
    Index<D> leader_of(int axis, const Index<D>& f, const Face& face, FollowingFace<D>& following)
    {
        const Vec<D> x = face.centroid;
        const double area = coupling_.open(axis, f);
        std::array<std::pair<double, int>, 2 * D> choices;
        for (int side = 0; side < 2 * D; ++side)
            choices[side] = {(side % 2 ? -1.0 : 1.0) * face.shift[side / 2], side};
        std::sort(choices.begin(), choices.end());
        for (const auto& [along, side] : choices) {
            const Index<D> g = f + (side % 2 ? 1 : -1) * step<D>(side / 2);
            if (along >= -1e-6 * grid_.dx() || !system_.active[axis].block().contains(g) || !system_.active(axis, g))
                continue;
            const Vec<D> from = grid_.face_centre(axis, g), direction = (x - from).normalized();
            const double length = (x - from).norm();
            rays_.around(from, 3 * grid_.dx());
            const WallHit<D> hit = rays_.cast(from, direction, 3 * grid_.dx());
            if (hit.image < 0 || hit.distance < length)
                continue;
            const double rest = std::max(hit.distance - length, least_distance * grid_.dx());
            following.leader = offset(axis, g);
            following.stiffness = system_.edge * area * grid_.dx() * (1 / rest + 1 / length);
            following.share = rest / (rest + length);
            following.solid[0] = rays_.image(hit.image).solid;
            following.row[0] = (1 - following.share) * row(hit.image, axis, from + (rest + length) * direction);
            return g;
        }
        follow_solids(axis, f, x, area, following);
        return f;
    }

    // No neighbour: a gap narrower than the grid. Drag towards the velocity of a linear profile between its walls, as much as keeps the face's
    // share of Poiseuille flow.
    void follow_solids(int axis, const Index<D>&, const Vec<D>& x, double area, FollowingFace<D>& following)
    {
        rays_.around(x, ray_length * grid_.dx());
        int nearest = -1;
        const double phi = std::max(rays_.distance(x, &nearest), least_distance * grid_.dx());
        if (nearest < 0) {
            following.stiffness = 0;
            return;
        }
        const SurfacePoint<D> wall = rays_.image(nearest).shape.closest(x);
        const WallHit<D> other = rays_.cast(x, wall.normal, ray_length * grid_.dx());
        following.solid[0] = rays_.image(nearest).solid;
        following.row[0] = row(nearest, axis, wall.x);
        double mean = phi * phi / 3; // of y (h - y) / 2 over the face, h = 2 phi
        if (other.image >= 0) {
            const double h = phi + other.distance;
            const double spread = (1 - wall.normal[axis] * wall.normal[axis]) * (D == 2 ? area * area : area) / 12 * grid_.dx() * grid_.dx();
            mean = std::max(0.5 * phi * other.distance - 0.5 * spread, h * h / 24);
            const double near_share = other.distance / h;
            following.row[0] *= near_share;
            following.solid[1] = rays_.image(other.image).solid;
            following.row[1] = (1 - near_share) * row(other.image, axis, x + other.distance * wall.normal);
        }
        following.stiffness = system_.edge * area * grid_.dx() * grid_.dx() / mean;
    }

    void share_turning()
    {
        constexpr int size = spin_size<D> * spin_size<D>;
        std::vector<double> sums;
        for (const Spins& matrix : system_.turning)
            sums.insert(sums.end(), matrix.data(), matrix.data() + size);
        grid_.comm().sum(sums);
        for (std::size_t s = 0; s < system_.turning.size(); ++s) {
            const Spins sum = Eigen::Map<const Spins>(&sums[size * s]);
            system_.turning[s] = 0.5 * (sum + sum.transpose());
        }
    }

    void finish_bodies()
    {
        share_turning();
        const int dofs = n * coupling_.system.bodies;
        if (dofs == 0)
            return;
        // Every rank adds up the same blocks in the same order.
        std::vector<double> sums(static_cast<std::size_t>(dofs) * n + dofs, 0.0);
        std::vector<Eigen::Triplet<double>> entries;
        auto append = [&](int a, int b, const TwistMatrix<D>& block) {
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j)
                    if (block(i, j) != 0)
                        entries.emplace_back(n * a + i, n * b + j, block(i, j));
        };
        for (int b = 0; b < coupling_.system.bodies; ++b) {
            if (const auto known = blocks_.find({b, b}); known != blocks_.end())
                std::copy_n(known->second.data(), n * n, sums.data() + static_cast<std::size_t>(b) * n * n);
        }
        Eigen::Map<Eigen::VectorXd>(&sums[static_cast<std::size_t>(dofs) * n], dofs) = body_rhs_;
        grid_.comm().sum(sums);
        body_rhs_ = Eigen::Map<Eigen::VectorXd>(&sums[static_cast<std::size_t>(dofs) * n], dofs);
        system_.admissible.resize(coupling_.system.bodies);
        for (std::size_t s = 0; s < coupling_.solids.size(); ++s) {
            const int b = coupling_.free_body[s];
            if (b < 0)
                continue;
            const TwistMatrix<D>& P = coupling_.solids[s].admissible;
            const TwistMatrix<D>& M = bodies_.mass[s];
            TwistMatrix<D> turning = TwistMatrix<D>::Zero();
            turning.template bottomRightCorner<spin_size<D>, spin_size<D>>() = system_.turning[s];
            TwistMatrix<D> block = Eigen::Map<TwistMatrix<D>>(&sums[static_cast<std::size_t>(b) * n * n]);
            block += P * (M + turning) * P + M(0, 0) * (TwistMatrix<D>::Identity() - P);
            append(b, b, block);
            body_rhs_.segment<n>(n * b) += P * (M * bodies_.twists[s]);
            system_.admissible[b] = P;
        }
        add_blocks_between_bodies(append);
        system_.body_matrix.resize(dofs, dofs);
        system_.body_matrix.setFromTriplets(entries.begin(), entries.end());
        system_.body_rhs = body_rhs_;
    }

    // Blocks of two different bodies (gaps that neither grid nor film resolves): few, gathered from all ranks.
    template <class Append>
    void add_blocks_between_bodies(Append&& append)
    {
        const int bodies = coupling_.system.bodies;
        std::vector<double> mine;
        for (const auto& [place, block] : blocks_)
            if (place.first != place.second) {
                mine.push_back(place.first);
                mine.push_back(place.second);
                mine.insert(mine.end(), block.data(), block.data() + n * n);
            }
        std::vector<double> counts(grid_.comm().size(), 0.0);
        counts[grid_.comm().rank()] = static_cast<double>(mine.size());
        grid_.comm().sum(counts);
        long total = 0, before = 0;
        for (int r = 0; r < grid_.comm().size(); ++r) {
            before += r < grid_.comm().rank() ? static_cast<long>(counts[r]) : 0;
            total += static_cast<long>(counts[r]);
        }
        if (total == 0 || bodies < 2)
            return;
        std::vector<double> all(total, 0.0);
        std::copy(mine.begin(), mine.end(), all.begin() + before);
        grid_.comm().sum(all);
        for (long at = 0; at < total; at += 2 + n * n)
            append(static_cast<int>(all[at]), static_cast<int>(all[at + 1]), Eigen::Map<TwistMatrix<D>>(&all[at + 2]));
    }

    const Coupling<D>& coupling_;
    const Grid<D>& grid_;
    const FaceFractions<D>& fractions_;
    const FaceField<D>& u_star_;
    const ViscousBodies<D>& bodies_;
    WallRays<D> rays_;
    bool rays_ready_ = false;
    std::array<int, 2 * D> wall_;
    CellField<D, std::int8_t> surface_;
    std::map<std::pair<int, long>, Gap> gaps_; // of lattice points, by axis and offset
    std::map<std::pair<int, int>, TwistMatrix<D>> blocks_;
    Eigen::VectorXd body_rhs_;
    ViscousSystem<D> system_;
};

} // namespace

template <int D>
ViscousSystem<D> viscous_system(const Coupling<D>& coupling, double viscosity, double dt, const FaceField<D>& u_star,
                                const ViscousBodies<D>& bodies)
{
    return ViscousBuilder<D>(coupling, viscosity, dt, u_star, bodies).build();
}

template ViscousSystem<2> viscous_system<2>(const Coupling<2>&, double, double, const FaceField<2>&, const ViscousBodies<2>&);
template ViscousSystem<3> viscous_system<3>(const Coupling<3>&, double, double, const FaceField<3>&, const ViscousBodies<3>&);

} // namespace gapflow
