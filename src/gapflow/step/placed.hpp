// What follows from the places of the bodies: the complex of fluid parts, its derivatives, and the coupled system. Const once
// built, but for the contacts that hold the bodies in a step.
#pragma once

#include "gapflow/coupling/parts.hpp"
#include "gapflow/step/void_parts.hpp"
#include "gapflow/stepping/model.hpp"

#include <memory>
#include <vector>

namespace gapflow {

template <int D>
struct ViscousForm;

/// An edge of the complex that is not a face of the grid between the largest parts of two cells: its flux is the conductance times the sum of w p and of the
/// density times what circulation has along it, of which w leaves each row.
template <int D>
struct SparseEdge {
    struct Row {
        int node;      ///< -1: a cell's
        Index<D> cell; ///< in this rank's numbers, for nodes too: another rank's lies in the layers around its own
        double weight;
    };
    double conductance;                   ///< 0 where another edge stands for it
    std::int32_t piece, link, mouth;      ///< of the complex and its inertia, one of them not -1
    std::int32_t first_row = 0, rows = 0; ///< in EdgesOfParts::rows
};

/// An edge in a mouth.
template <int D>
struct MouthEdge {
    std::int32_t edge;
    std::array<std::int32_t, 2> solid; ///< the corner's and the one across
    Vec<D> at;                         ///< the corner, or the middle of a face
};

/// Flux of a solid's twist along a face of the grid or an edge, which K has.
template <int D>
struct CarriedFlux {
    int axis; ///< of the face; -1: an edge
    Index<D> face;
    std::int32_t edge;
    int solid;
    Twist<D> flux;
};

/// For flow with circulation.
template <int D>
struct EdgesOfParts {
    std::vector<SparseEdge<D>> edges;
    std::vector<typename SparseEdge<D>::Row> rows;
    std::vector<std::int32_t> edge_of_piece; ///< -1: none
    std::vector<std::int32_t> edge_of_link;
    std::vector<MouthEdge<D>> in_mouths;
    std::vector<CarriedFlux<D>> carried; ///< of this rank's faces
    std::vector<CarriedFlux<D>> covered; ///< the same of what solids cover of them, which is not the fluid's

    std::span<const typename SparseEdge<D>::Row> rows_of(const SparseEdge<D>& edge) const
    {
        return {rows.data() + edge.first_row, static_cast<std::size_t>(edge.rows)};
    }
};

template <int D>
struct Placed {
    Complex<D> complex;
    FaceDerivatives<D> derivatives;
    std::vector<GapArm<D>> arms;
    std::vector<PairInertia<D>> pairs;             ///< what gaps add to the masses of two solids
    std::vector<int> node;                         ///< of each part, -1: none
    bool rotational = false;                       ///< whether the flow has circulation
    EdgesOfParts<D> edges;                         ///< where it has, or where fluxes are measured
    Voids<D> voids;                                ///< in gaps
    std::shared_ptr<const ViscousForm<D>> viscous; ///< dissipation per unit of viscosity; null: ideal fluid
    Coupling<D> coupling;                          ///< with the masses of the bodies at these places
    std::unique_ptr<const GapDerivatives<D>> gaps; ///< of the arms; null: none
};

/// `mass`: of all solids. `circulation`: whether the flow has some, which needs `edges`. `voids`: taken along from another place; null: none. Collective.
template <int D>
std::unique_ptr<Placed<D>> placed(const Model<D>& model, const std::vector<RigidBody<D>>& bodies,
                                  const std::vector<TwistMatrix<D>>& mass, bool circulation = false,
                                  const VoidsBefore<D>* voids = nullptr);

/// The same with what the energy of a flow there asks for alone: complex, coupling, nodes and, with circulation, edges. Collective.
template <int D>
Placed<D> placed_for_energy(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, bool circulation);

/// Other volumes of voids in the same complex. Collective.
template <int D>
void put_voids(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const std::vector<TwistMatrix<D>>& mass,
               std::vector<double> volume, Placed<D>& at);

/// Arms of this rank's faces.
template <int D>
std::vector<GapArm<D>> own_arms(const Placed<D>& at);

/// The same system where the twists of all solids are given: it has no bodies.
template <int D>
Coupling<D> with_given_twists(Coupling<D> coupling);

} // namespace gapflow
