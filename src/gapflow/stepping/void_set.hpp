// Voids in films (method, "Voids: dry contact and cavitation"): film nodes at their least pressure. Per film node, with void
// volume v and outflow row_i = (L p + K V + D u*)_i,
//
//     0 <= p_i - b_i  |  v_i / dt + row_i >= 0,      v_i^{n+1} = max(0, v_i + dt row_i),      b_i = dt (least pressure there).
//
// Dry contact starts with voids as thick as the distance at which the surfaces are held; cavitation starts without. The void
// volume moves with the film's master from step to step.
#pragma once

#include "gapflow/core/state_archive.hpp"
#include "gapflow/coupling/coupling.hpp"
#include "gapflow/film/film_motion.hpp"
#include "gapflow/scene/scene.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gapflow {

/// The least full pressure in the film of a pair, -infinity: none; and the thickness of the voids that it starts with.
struct VoidLaw {
    double least_pressure;
    double start;
};

template <int D>
class VoidSet {
public:
    VoidSet() = default;
    /// `hydrostatic`: full minus reduced pressure at a point.
    VoidSet(const Scene& scene, const Grid<D>& grid, const std::vector<Solid<D>>& solids,
            std::function<double(const Vec<D>&)> hydrostatic);

    /// Whether some pair of the scene can have voids at all.
    bool possible() const { return possible_; }
    /// Voids of a new configuration: taken over from the last one, or those that the scene starts with (`histories` null).
    void find(const Coupling<D>& coupling, const FilmHistories<D>* histories);
    /// Whether some film node can be a void: without, nothing below need be called.
    bool any() const { return any_; }
    /// Void nodes of the current active set.
    const std::vector<char>& is_void() const { return is_void_; }
    /// b of the void nodes, 0 elsewhere.
    Eigen::VectorXd impulses(double dt) const;
    /// v / dt of every node: the inflow where it becomes wet.
    Eigen::VectorXd filling(double dt) const;
    /// Least reduced pressure of a node; -infinity: no void can be there.
    double least_pressure(int node) const { return least_[node]; }
    /// Reduced pressure that a node's film had at the end of the last step (in voids: their own).
    const std::vector<double>& last_pressure() const { return last_pressure_; }

    /// Mouths out of voids that take half their gap or more: there is no fluid to flow out, so where the bulk's pressure is
    /// lower they are shut.
    const std::vector<char>& shut() const { return shut_; }

    /// Updates the active set with the pressure impulses and outflows of a solve. True if nodes change and the solve must be
    /// repeated; if
    /// `at_once` is false, one node has changed at most (Murty's rule).
    bool update(const Eigen::VectorXd& p, const Eigen::VectorXd& outflow, double dt, double accuracy, bool at_once);
    /// The same for mouths, with their fluxes out of the film relative to its master and their drops of pressure impulse.
    bool update_mouths(const std::vector<Mouth<D>>& mouths, const std::vector<double>& flux, const std::vector<double>& drop,
                       double accuracy, bool at_once);
    /// Void volumes of the end of the step, and the data that find() needs.
    void finish(const Coupling<D>& coupling, const Eigen::VectorXd& p, const Eigen::VectorXd& outflow, double dt);

    /// Void volume of every film node, and its rate of change in the step (0 where voids are impossible).
    const std::vector<double>& volume() const { return volume_; }
    const std::vector<double>& growth() const { return growth_; }
    /// Void volume over area.
    double depth(int node) const { return area_[node] > 0 ? volume_[node] / area_[node] : 0.0; }
    /// Elements without any node that is wet.
    std::vector<char> empty_elements(const FilmNetwork<D>& network) const;
    /// Share of their gaps filled with fluid, upstream of every element and mouth with respect to both walls' motion; computed
    /// by find(), valid until its next call. `twists`: of all solids.
    void find_wet_shares(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists);
    const WetShares& wet_shares() const { return wet_; }
    /// Void volume that find() had to drop because its film is gone, summed over the run.
    double lost() const { return lost_; }
    /// The voids at the end of the last step.
    void list_state(StateArchive& archive);

private:
    /// A pair's film at the end of a step, at the vertices of its FilmHistory.
    struct Memory {
        std::vector<double> depth, pressure; ///< void volume over area; reduced pressure
        std::vector<Vec<D>> places;          ///< of the vertices, in the master's frame
        std::vector<double> volumes;
        double volume = 0;               ///< their sum
        Vec<D> deepest = Vec<D>::Zero(); ///< place of the deepest void in the master's frame
    };
    VoidLaw law(int a, int b) const;
    void start(const Coupling<D>& coupling);
    void carry(const Coupling<D>& coupling, const FilmHistories<D>& histories);

    const Scene* scene_ = nullptr;
    double dx_ = 0;
    std::vector<std::string> names_;
    std::function<double(const Vec<D>&)> hydrostatic_;
    bool possible_ = false, any_ = false;
    std::vector<double> volume_, area_, growth_;
    std::vector<double> least_; ///< reduced pressure, -infinity: no void here
    std::vector<double> last_pressure_;
    std::vector<char> is_void_, drained_, shut_;
    std::vector<int> flips_; ///< of the mouths, in this step
    std::map<FilmPair<D>, Memory> memory_;
    double lost_ = 0;
    WetShares wet_;
};

/// The pairs' laws, from the scene.
VoidLaw void_law(const Scene& scene, const std::string& a, const std::string& b);

} // namespace gapflow
