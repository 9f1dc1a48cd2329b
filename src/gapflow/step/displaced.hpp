// dT/dx of solids whose gaps end at sharp edges, by differences of the energy at fixed potentials. The closed form (complex/energy_derivative) does not know
// the lines and planes that divide the fluid at such mouths.
#pragma once

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
    /// `of`: of the displaced solids; `near`: the other one, whose nodes are `numbers`.
    EnergyTerms(const Coupling<D>& of, const Complex<D>& complex, const std::vector<int>& node, const Placed<D>& near);

    /// Of potentials and twists at the other place.
    double energy(const PotentialFlow<D>& flow) const;

private:
    struct Pair {
        long a, b; ///< rows; b -1: a side of the domain
        double conductance;
    };
    struct Sum {
        double conductance;
        std::vector<std::pair<long, double>> rows;
    };
    struct Flux {
        long row;
        int solid;
        Twist<D> flux;
    };
    /// A row that the other place lacks. Its potential is what its neighbours' and its walls' flux make it.
    struct Fresh {
        long row;
        double diagonal = 0;
        std::vector<std::pair<long, double>> others; ///< conductances
    };

    long row_of_node(int node) const { return cells_ + node; }
    Fresh* fresh(long row);
    double value(long row, const PotentialFlow<D>& flow, const std::vector<double>& fresh_value) const;
    void add_pair(long a, long b, double conductance);

    const Grid<D>* grid_;
    long cells_;
    std::vector<Pair> pairs_;
    std::vector<Sum> sums_;
    std::vector<Flux> fluxes_;
    std::vector<Fresh> fresh_;            ///< sorted
    std::vector<int> node_there_;         ///< of each node: that of the other place, or -1
    std::vector<TwistMatrix<D>> seen_;    ///< of each solid
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

/// Replaces the forces of these solids.
template <int D>
void replace_forces(const std::vector<Displaced<D>>& displaced, const PotentialFlow<D>& flow, std::vector<Twist<D>>& force);

} // namespace gapflow
