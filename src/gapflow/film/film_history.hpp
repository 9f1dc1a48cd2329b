// Velocities of a pair's films after the last step, as a field on the master's surface in which traces can be followed back.
#pragma once

#include "gapflow/film/mouths.hpp"
#include "gapflow/film/vertex_fit.hpp"

#include <span>
#include <vector>

namespace gapflow {

/// The part of v normal to the unit vector n.
template <int D>
Vec<D> tangential(const Vec<D>& v, const Vec<D>& n)
{
    return v - v.dot(n) * n;
}

/// The films of one pair of solids after a step.
template <int D>
class FilmHistory {
public:
    struct OldMouth {
        Vec<D> place;            ///< in the master's frame
        Vec<D> outward, section; ///< world axes, at the time (Mouth)
        double resistance;       ///< R
        double flux;             ///< absolute, out of the film, per length of rim
        Vec<D> master_velocity;  ///< world, of the master there
        MouthKind kind;
    };

    /// `films`: the pieces of this pair; `w`: one world vector for each element of all films of the network. Elements marked in `idle` (one
    /// value for each element of the network, or none) are excluded from the reconstruction. `acceleration`: acceleration by the pressure, one for
    /// each element of the network, or none; `increment`: change of its velocity in the last step over what was put in place, or none.
    FilmHistory(const Solid<D>& master, const Twist<D>& master_twist, const std::vector<const Film<D>*>& films,
                const std::vector<Vec<D>>& w, const std::vector<Vec<D>>& acceleration, const std::vector<Vec<D>>& increment,
                const std::vector<char>& idle, double dx);

    /// What lies at a point of the master's frame. `flux`: h (w - U_m), linear in the element with a limited slope, world axes.
    struct Sample {
        int element;
        double
            share; ///< of the point: new meshes have many points on facets and nodes of old ones, which lie in all elements there
        bool belongs; ///< x to the film: it lies at the element, not beyond the film's end
        double h;
        Vec<D> flux;
    };
    /// Calls f(sample) for each element in which the point lies; `hint` as in `at`.
    template <class F>
    void for_each_sample(const Vec<D>& x_body, int& hint, F&& f) const
    {
        const Place place = locate(x_body, hint);
        hint = place.element;
        const std::vector<int> shared = sharing(place);
        if (shared.empty())
            f(sample(place, x_body, 1));
        for (int element : shared)
            f(sample(place_in(element, x_body), x_body, 1.0 / static_cast<double>(shared.size())));
    }
    /// Of an element: velocity along the film relative to the master, unit normal (world axes), volume.
    Vec<D> along(int element) const { return tangential<D>(flux_[element] / h_mean_[element], normal_[element]); }
    const Vec<D>& normal(int element) const { return normal_[element]; }
    double volume(int element) const { return volumes_[element]; }
    Vec<D> acceleration(int element) const
    {
        return acceleration_.empty() || idle_[element] ? Vec<D>(Vec<D>::Zero()) : acceleration_[element];
    }
    Vec<D> increment(int element) const { return increment_.empty() ? Vec<D>(Vec<D>::Zero()) : increment_[element]; }
    /// Of an element on the master.
    double measure_on_master(int element) const
    {
        const std::array<int, D>& n = elements_[element];
        if constexpr (D == 2)
            return (x_[n[1]] - x_[n[0]]).norm();
        else
            return 0.5 * (x_[n[1]] - x_[n[0]]).cross(x_[n[2]] - x_[n[0]]).norm();
    }
    /// Elements that share a vertex with an element, each once, without the element itself.
    std::vector<int> around(int element) const;
    /// Of the master, at the time.
    const Mat<D>& rotation() const { return rotation_; }
    /// Of the master, at the time.
    Spin<D> spin() const { return twist_.template tail<spin_size<D>>(); }
    /// The master's reference point in its frame.
    const Vec<D>& centre() const { return centre_body_; }
    /// What flows at a point of the master's frame, extrapolated linearly beyond the film; world axes.
    struct Flow {
        Vec<D> of_master; ///< velocity of the master
        Vec<D> flux;      ///< h (w - U_m)
        Vec<D> normal;    ///< of the nearest element
        double h;
        Vec<D> velocity() const { return of_master + flux / h; }
    };
    /// `hint`: an element near the point, or -1; on return the one nearest to it.
    Flow at(const Vec<D>& x_body, int& hint) const;
    /// A field given at the vertices, linear over the elements, at a point of the master's frame; 0 where there was no film. `hint` as
    /// above.
    double at_vertices(std::span<const double> field, const Vec<D>& x_body, int& hint) const;
    int elements() const { return static_cast<int>(elements_.size()); }
    /// Speed relative to the master around an element: the largest of its vertices' values, each the root of the mean square over the volume
    /// around the vertex. (Single elements are unreliable: small ones cut by the film's end may have ten times the speed of the flow.)
    double speed_about(int element) const;
    /// Velocity of the master's old rigid motion at a point of its frame (world axes).
    Vec<D> master_velocity(const Vec<D>& x_body) const;
    /// The old mouth whose flux a new one at this place takes over; null: none near.
    const OldMouth* nearest_mouth(const Vec<D>& x_body, const Vec<D>& outward) const;

    std::vector<OldMouth> mouths;

private:
    struct Place {
        int element;
        std::array<double, D> shape; ///< barycentric, may lie outside 0..1
        double distance;
    };
    Place place_in(int element, const Vec<D>& x_body) const;
    Sample sample(const Place& place, const Vec<D>& x_body, double share) const;
    std::vector<int> sharing(const Place& place) const;
    bool belongs(const Place& place, const Vec<D>& x_body) const;
    Place locate(const Vec<D>& x_body, int hint) const;
    Place walk(const Vec<D>& x_body, int start) const;
    void join_elements();
    double thickness(const Place& place) const;
    void limit_slopes();
    void fit_vertices(const std::vector<double>& weight);
    Index<D> bin(const Vec<D>& x_body) const;
    long bin_key(const Index<D>& bin) const;

    double dx_;
    Mat<D> rotation_;    ///< of the master, at the time
    Vec<D> centre_body_; ///< the master's reference point in its frame
    Twist<D> twist_;
    std::vector<Vec<D>> x_; ///< vertices on the master, its frame
    std::vector<std::array<int, D>> elements_;
    VertexRings rings_;
    std::vector<std::array<int, D>> beyond_; ///< element across the facet opposite each node, -1: none
    std::vector<Vec<D>> centroid_;           ///< master's frame
    std::vector<double> radius_;             ///< of elements about their centroids
    std::vector<double> speed_; ///< |w - U_m| around a vertex: root of the mean square over the volume of the elements around
    std::vector<double> h_, h_mean_, cosine_; ///< h at the vertices; of the elements: mean thickness, FilmElement::cosine()
    std::vector<double> volumes_, slope_;     ///< of elements; share of the fitted slope of the flux that makes no new extremum
    std::vector<Vec<D>> increment_;           ///< of elements, world axes; or none
    std::vector<char> idle_;                  ///< elements excluded from the reconstruction
    std::vector<Vec<D>> normal_;              ///< of elements, world axes
    std::vector<Vec<D>> flux_, flux_vertex_;  ///< h (w - U_m), of elements and vertices
    std::vector<Vec<D>> acceleration_;        ///< by the pressure, of elements, world axes; or none
    KeyMap<std::vector<int>> bins_;
};

} // namespace gapflow
