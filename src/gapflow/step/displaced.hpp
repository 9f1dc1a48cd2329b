// dT/dx of solids whose gaps end at sharp edges, by differences of the energy at fixed potentials. The closed form (complex/energy_derivative) does not know
// the lines and planes that divide the fluid at such mouths.
#pragma once

#include "gapflow/core/sparse_cholesky.hpp"
#include "gapflow/step/potential_flow.hpp"

#include <array>
#include <utility>
#include <vector>

namespace gapflow {

/// The terms of -1/2 p . L p - p . K V + 1/2 V . B V of a complex near another one, by the latter's potentials. Conductances of the grid's faces are
/// changes against the other one.
template <int D>
class EnergyTerms {
public:
    /// `of`: of the displaced solids; `near`: the other one. All ranks have the terms of all. Collective.
    EnergyTerms(const Coupling<D>& of, const Complex<D>& complex, const std::vector<int>& node, const Placed<D>& near);

    /// Of potentials and twists at the other place. Collective.
    double energy(const PotentialFlow<D>& flow) const;

private:
    // Values: the other place's cells by their keys, its nodes, and local ones: of this place's nodes and of the cells whose rows differ. These are those that
    // make the energy stationary here: two parts between which a sliver becomes a passage are not what they were.
    struct Pair {
        long a, b; ///< values; b -1: a side of the domain
        double conductance;
    };
    struct Sum {
        double conductance;
        std::vector<std::pair<long, double>> values;
    };
    struct Flux {
        long value;
        int solid;
        Twist<D> flux;
    };
    struct Local {
        long start = -1; ///< value at the other place
        double diagonal = 0;
        double to_side = 0;                          ///< of it, to a side of the domain
        std::vector<std::pair<long, double>> others; ///< minus the entries of L; some twice
    };
    /// Local values that are joined with each other, but not with others: a constant may be added to them.
    struct Sealed {
        std::vector<int> values;
        double diagonal; ///< sum
    };
    using Differing = std::vector<long>; ///< cells by their keys, in their order
    /// Values at the other place.
    struct Known {
        const PotentialFlow<D>& flow;
        std::vector<double> cells; ///< on several ranks: of shared_cells_
    };

    Differing differing_cells(const Coupling<D>& of, const Coupling<D>& other) const;
    long value_of_cell(const Index<D>& c) const;
    void add_faces(const CoupledSystem<D>& system, const CoupledSystem<D>& other);
    void add_film(const CoupledSystem<D>& system);
    void add_links(const CoupledSystem<D>& system);
    void add_rows();
    void factorise();
    void find_known_cells();
    Known known_values(const PotentialFlow<D>& flow) const;
    std::vector<double> local_values(const Known& known) const;
    double value(long number, const Known& known, const std::vector<double>& local) const;

    const Grid<D>* grid_;
    long cells_, known_;
    std::vector<std::pair<long, long>> local_value_; ///< of cells that have one, by keys
    std::vector<long> value_of_node_;
    std::vector<Pair> pairs_;
    std::vector<Sum> sums_;
    std::vector<Flux> fluxes_;
    std::vector<Local> local_;
    std::vector<Sealed> sealed_;
    SparseCholesky factor_; ///< of L of the local values
    std::vector<long>
        shared_cells_; ///< on several ranks: keys of the other place's cells that have values here, in their order
    std::vector<TwistMatrix<D>> seen_; ///< of each solid
    std::vector<NormalInertia<D>> gaps_;
};

/// A solid a little to both sides of its place.
template <int D>
struct Displaced {
    int solid, component;
    double way; ///< from one side to the other; a length or an angle
    EnergyTerms<D> low, high;
};

/// All components in which the bodies move that have mouths at their gaps. `at`: of the bodies where they are. Collective.
template <int D>
std::vector<Displaced<D>> displaced(const Model<D>& model, const std::vector<RigidBody<D>>& bodies, const Placed<D>& at);

/// Of each solid, whether a component of its force is left by replace_forces().
template <int D>
std::vector<char> not_replaced(const std::vector<Displaced<D>>& displaced, std::size_t solids);
/// Replaces the forces of these solids. Collective.
template <int D>
void replace_forces(const std::vector<Displaced<D>>& displaced, const PotentialFlow<D>& flow, std::vector<Twist<D>>& force);

} // namespace gapflow
