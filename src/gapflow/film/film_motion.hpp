// What films carry from step to step, and its advection on the moving surface mesh (method, section 5).
//
// An element's velocity is w = u + V_n n in world axes (u tangential, V_n the normal speed of the mid-gap surface).
// Semi-Lagrangian on the master: trace back by dt (u - P U_m) along the old mesh in the master's frame, transport w as a world
// vector, and turn its surplus into the new tangent plane:
//     w* = w^(x*) + theta (w_e - w^(x_e)),    w^ = U_m + (h (w - U_m))^ / h^, theta = 1 where the
//                                             new element is the old element e, 0 where the mesh has changed,
// (.)^: from vertex values (local least squares in the tangent plane, weighted by S). The flux h (w - U_m) varies slowly where the
// gap does not: interpolating w itself, which goes like 1/h, overestimates it on both sides of a throat and pumps the fluid through.
//     w_new = w* + lambda n_bar,      n_bar parallel to n_old + n_new,   lambda such that w_new . n_new is the new normal speed.
// A trace that leaves the old film uses w^ extrapolated linearly beyond its end, never the grid's velocity.
#pragma once

#include "gapflow/film/conduits.hpp"

#include <functional>
#include <map>
#include <memory>
#include <vector>

namespace gapflow {

/// The films of one pair of solids after a step.
template <int D>
class FilmMemory {
public:
    struct Mouth {
        Vec<D> place;            ///< in the master's frame
        Vec<D> outward;          ///< world axes, at the time
        double h, flux;          ///< thickness and absolute flux out of the film, per length of rim
        Vec<D> master_velocity;  ///< world, of the master there
        ConduitKind kind;
    };

    /// `films`: the pieces of this pair; `w`: one world vector an element of all films of the network. Where `idle` (one an
    /// element of the network, or none) an element says nothing of the velocity around it.
    FilmMemory(const Solid<D>& master, const Twist<D>& master_twist, const std::vector<const Film<D>*>& films,
               const std::vector<Vec<D>>& w, const std::vector<char>& idle, double dx);

    /// Velocity (world axes) transported to a point of the master's frame over dt, with the old normal at its foot.
    struct Transported {
        Vec<D> velocity, normal;
        bool near; ///< an old film lies within two cells of the arrival point
        bool beyond; ///< but not there
        double fastest; ///< speed about the arrival point, as speed_about(); infinite where the old film was idle
    };
    /// `hint`: an element near it, or -1; on return the one it arrived in.
    Transported transport(const Vec<D>& x_body, double dt, int& hint) const;
    /// Old velocity at a point of the master's frame, extrapolated linearly beyond the film, and the film's normal there.
    Transported at(const Vec<D>& x_body, int& hint) const { return transport(x_body, 0.0, hint); }
    /// A field given at the vertices, linear over the elements, at a point of the master's frame; 0 where no film was. `hint` as
    /// above.
    double at_vertices(std::span<const double> field, const Vec<D>& x_body, int& hint) const;
    int elements() const { return static_cast<int>(elements_.size()); }
    /// Sums over the elements: volume S, and S |u - P U_m|^2, twice the energy of the motion along the master at density 1.
    double volume() const { return volume_; }
    double motion() const { return motion_; }
    /// Speed relative to the master about an element: the largest about its vertices, each the root of the mean square over the volume
    /// around. (Single elements tell little: those that the film's end cuts small may carry ten times the speed of the flow.)
    double speed_about(int element) const;
    /// Velocity of the master's old rigid motion at a point of its frame (world axes).
    Vec<D> master_velocity(const Vec<D>& x_body) const;
    /// The old mouth that a new one at this place continues; null: none near.
    const Mouth* mouth(const Vec<D>& x_body, const Vec<D>& outward) const;

    std::vector<Mouth> mouths;

private:
    struct Place {
        int element;
        std::array<double, D> shape; ///< barycentric, may lie outside 0..1
        double distance;
    };
    Place place_in(int element, const Vec<D>& x_body) const;
    Place locate(const Vec<D>& x_body, int hint) const;
    Place walk(const Vec<D>& x_body, int start) const;
    void join_elements();
    Vec<D> vertex_velocity(const Vec<D>& x_body, const Place& place) const;
    void fit_vertices(const std::vector<double>& weight);
    Index<D> bin(const Vec<D>& x_body) const;
    long bin_key(const Index<D>& bin) const;

    double dx_, volume_ = 0, motion_ = 0;
    Mat<D> rotation_;       ///< of the master, at the time
    Vec<D> centre_body_;    ///< the master's reference point in its frame
    Twist<D> twist_;
    std::vector<Vec<D>> x_; ///< vertices on the master, its frame
    std::vector<std::array<int, D>> elements_;
    std::vector<std::array<int, D>> beyond_; ///< element across the facet opposite each node, -1: none
    std::vector<Vec<D>> centroid_; ///< master's frame
    std::vector<double> radius_;   ///< of elements about their centroids
    std::vector<double> speed_;    ///< |w - U_m| about a vertex: root of the mean square over the volume of the elements around
    std::vector<double> h_, h_mean_; ///< thickness at the vertices, mean over the elements
    std::vector<char> coarse_, idle_; ///< elements too large for their gap; those that say nothing of the flow
    std::vector<Vec<D>> w_, normal_; ///< of elements, world axes
    std::vector<Vec<D>> flux_, flux_vertex_; ///< h (w - U_m), of elements and vertices
    KeyMap<std::vector<int>> bins_;
};

/// All that films remember, by pair.
template <int D>
using FilmMemories = std::map<FilmPair<D>, std::shared_ptr<const FilmMemory<D>>>;

/// Velocities with which films enter the next projection.
template <int D>
struct FilmFlow {
    std::vector<Vec<D>> velocity;        ///< u*, tangential, one an element
    std::vector<double> normal;          ///< w_n*, one an element
    std::vector<double> conduit;         ///< q*, absolute, one a conduit
    std::vector<double> conduit_scale;   ///< factor on the conduit's 1/R (semi-implicit inflow)
};

/// Velocities at a list of points.
template <int D>
using VelocitySampler = std::function<std::vector<Vec<D>>(const std::vector<Vec<D>>&)>;

struct MouthLaw {
    double entrance_loss = 0; ///< zeta
    bool jet = false;         ///< outflow leaves as a jet: its kinetic head is lost
};

/// Advects what the old films carried onto the new ones. `predicted`: V^n + dt A; `grid_velocity` samples the bulk's continued
/// velocity at a list of points (elements and conduits that no old film is near), once.
template <int D>
FilmFlow<D> advect_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const FilmMemories<D>& memories,
                         const std::vector<Twist<D>>& predicted, const VelocitySampler<D>& grid_velocity,
                         const std::function<MouthLaw(int, int)>& law, double dt);

/// Remembers the films after a step. `u`: tangential velocities of elements; `conduit`: fluxes; `twists`: V^{n+1}; `idle`: as in
/// FilmMemory.
template <int D>
FilmMemories<D> remember_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const std::vector<Twist<D>>& twists,
                               const std::vector<Vec<D>>& u, const std::vector<double>& conduit, double dx,
                               const std::vector<char>& idle = {});

/// Mean of the two walls' velocities at mid-gap, normal part: n . 1/2 (U_A + U_B), one an element.
template <int D>
std::vector<double> wall_normal_speed(const FilmNetwork<D>& network, std::span<const Solid<D>> solids,
                                      const std::vector<Twist<D>>& twists);

} // namespace gapflow
