// Transport of momentum along a film by finite volumes (method, "Film transport"). Fluxes between the corners of elements meet the
// nodes' volume balances.
#pragma once

#include "gapflow/film/fluid_in_place.hpp"
#include "gapflow/film/vertex_fit.hpp"

#include <span>
#include <vector>

namespace gapflow {

/// Flow through a film's mouth in a step, relative to the master.
template <int D>
struct MouthFlow {
    double flux = 0;                  ///< out of the film
    Vec<D> entering = Vec<D>::Zero(); ///< velocity of fluid that enters, relative to the master, its axes
    Vec<D> world = Vec<D>::Zero();    ///< the same, absolute, world axes
};

/// What the elements have after transport. Energies over the density, relative to the master.
template <int D>
struct Carried {
    std::vector<Vec<D>> velocity; ///< relative to the master, its axes
    std::vector<Vec<D>> world;    ///< w, world axes; of first order only
    double out = 0, in = 0;       ///< energy that leaves and enters through the mouths

    /// Calls f with all of its fields.
    template <class F>
    void each_field(F&& f)
    {
        f(velocity, world, out, in);
    }
};

/// Transport in one film over dt.
template <int D>
class FilmTransport {
public:
    /// `number`: of the film in the network. `start`: of the film's elements; must outlive the object. `flow`: volume times velocity relative to the master, mean over
    /// the step, its axes, one for each element. `mouth_flow`: of all mouths of the network.
    FilmTransport(const FilmNetwork<D>& network, int number, const PlacedShape<D>& master,
                  std::span<const FluidInPlace<D>> start, std::span<const Vec<D>> flow,
                  std::span<const MouthFlow<D>> mouth_flow, double dt);
    /// First order: positive averages, which add no energy.
    Carried<D> low() const;
    /// Second order in space, limited, and in time: with the acceleration of the last step during the sub-steps. May add energy where the fluxes
    /// do not meet the nodes' balances.
    Carried<D> high() const;

private:
    struct Facet {
        int a, b;                ///< elements; b < 0: through a mouth
        double flux = 0;         ///< from a to b, volume per time
        double h = 0;            ///< thickness there
        MouthFlow<D> mouth = {}; ///< if it is one
        std::array<int, D - 1> nodes = {};
    };
    void find_facets(const RimLinks<D>& rim, int number, std::span<const MouthFlow<D>> mouth_flow);
    void balance_corners(std::span<const Vec<D>> flow);
    std::vector<int> chain(int node, const VertexRings& rings, std::vector<char>& visited, bool& closed) const;
    void choose_sub_steps();
    double volume(int e, double share) const { return start_volume_[e] + share * (end_volume_[e] - start_volume_[e]); }
    std::vector<Vec<D>> reconstructed(const std::vector<Vec<D>>& velocity) const;
    std::vector<Vec<D>> rates(const std::vector<Vec<D>>& velocity, const std::vector<Vec<D>>& values, double share) const;
    void count_energy(const std::vector<Vec<D>>& values, double dt, Carried<D>& result) const;
    Vec<D> into(int e, const Facet& facet, const Vec<D>& value) const;

    const FilmMesh<D>& mesh_;
    int first_node_;
    std::span<const FluidInPlace<D>> start_;
    double dt_;
    int sub_steps_ = 1;
    std::vector<double> start_volume_, end_volume_, mean_h_;
    std::vector<Vec<D>> acceleration_;          ///< used during the sub-steps
    std::vector<Vec<D>> x_, centroid_, normal_; ///< nodes on the master, elements; master's axes
    std::vector<std::array<Vec<D>, D>> gradient_;
    std::vector<std::array<int, D>> facet_of_; ///< facet opposite each node of an element, -1: the film's end
    std::vector<Facet> facets_;                ///< between elements first, then mouths
    std::size_t inner_facets_ = 0;
    std::vector<double> mouth_at_corner_; ///< D an element: flux out through mouths
    VertexFit fit_;
};

} // namespace gapflow
