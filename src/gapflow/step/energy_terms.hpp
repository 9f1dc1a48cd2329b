// The energy of a complex near another one, by the other one's potentials: as a sum over what differs (theory of the step, "A step").
#pragma once

#include "gapflow/core/sparse_cholesky.hpp"
#include "gapflow/step/potential_flow.hpp"

#include <utility>
#include <vector>

namespace gapflow {

/// The terms of the Routhian R = -1/2 m . g m - p . K V - w . (k + W) V + 1/2 V . B V and what is given at the sides, m = w - grad p (without circulation T = R) of a
/// complex near another one, by the latter's potentials and remainder. Conductances of the grid's faces are changes against the other one.
template <int D>
class EnergyTerms {
public:
    /// `of`: of the displaced solids; of both its place needs complex, coupling, nodes and, with circulation, edges alone. `near`: the other one. All ranks
    /// have the terms of all. Collective.
    EnergyTerms(const Placed<D>& of, const Placed<D>& near);

    /// Of potentials, twists, remainder and sides at the other place. Collective.
    double energy(const PotentialFlow<D>& flow) const;

private:
    // Values: the other place's cells by their keys, its nodes, and local ones: of this place's nodes and of the cells whose rows differ. These are those that
    // make the energy stationary here: two parts between which a sliver becomes a passage are not what they were.
    /// A share of the remainder's velocity on a face in the momentum along an edge.
    struct Along {
        long face;     ///< number_of_face(); -1: none
        double length; ///< times density
    };
    struct Pair {
        long a, b; ///< values; b -1: a side of the domain
        double conductance;
        Along along; ///< from a to b
    };
    struct Sum {
        double conductance;
        std::vector<std::pair<long, double>> values;
        std::vector<Along> along;
    };
    struct Flux {
        long value;
        int solid;
        Twist<D> flux;
    };
    /// What the remainder on a face carries with a solid's twist.
    struct Carried {
        Along along;
        int solid;
        Twist<D> flux;
    };
    /// Of a row beside a side of the domain.
    struct SideTerm {
        long value;
        int side;
        double area, conductance, half; ///< half: density times half a cell
        Along along;                    ///< from the row to the side
    };
    struct Local {
        long start = -1; ///< value at the other place
        double diagonal = 0;
        double to_side = 0;                          ///< of it, to a side of the domain
        std::vector<std::pair<long, double>> others; ///< minus the entries of L; some twice
        std::vector<Along> along;                    ///< times conductances: what leaves with the remainder
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
        std::vector<double> cells, faces; ///< on several ranks: of shared_cells_, shared_faces_
    };

    Differing differing_cells(const Placed<D>& at, const Coupling<D>& other) const;
    void add_values(const Placed<D>& of, const Placed<D>& near);
    long value_of_cell(const Index<D>& c) const;
    long number_of_face(int axis, const Index<D>& f) const;
    Along along_face(int axis, const Index<D>& f, double sign) const;
    void add_faces(const CoupledSystem<D>& system, const CoupledSystem<D>& other);
    void add_film(const CoupledSystem<D>& system);
    void add_links(const CoupledSystem<D>& system);
    void add_edges(const Placed<D>& of);
    void add_sides(const Placed<D>& of, const Placed<D>& near);
    void add_rows();
    void factorise();
    void find_known();
    Known known_values(const PotentialFlow<D>& flow) const;
    std::vector<double> local_values(const Known& known) const;
    double value(long number, const Known& known, const std::vector<double>& local) const;
    double on_face(long number, const PotentialFlow<D>& flow) const;
    double momentum(const Along& along, const Known& known) const;

    const Grid<D>* grid_;
    double density_;
    bool rotational_;
    long cells_, known_;
    std::vector<std::pair<long, long>> local_value_; ///< of cells that have one, by keys
    std::vector<long> value_of_node_;
    std::vector<Pair> pairs_;
    std::vector<Sum> sums_;
    std::vector<Flux> fluxes_;
    std::vector<Carried> carried_;
    std::vector<SideTerm> sides_;
    std::vector<Local> local_;
    std::vector<Sealed> sealed_;
    SparseCholesky factor_; ///< of L of the local values
    /// On several ranks: keys of the other place's cells that have values here, and faces, in their order.
    std::vector<long> shared_cells_, shared_faces_;
    std::vector<TwistMatrix<D>> seen_; ///< of each solid
    std::vector<NormalInertia<D>> gaps_;
};

} // namespace gapflow
