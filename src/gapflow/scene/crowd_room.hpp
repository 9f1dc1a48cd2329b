// What is free for a crowd's bodies: the domain between its walls, without the bodies that are there.
#pragma once

#include "gapflow/geometry/pose.hpp"
#include "gapflow/scene/scene.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace gapflow {

/// A body as the convex hull of some points, about its centre, widened by a radius: exact for balls, boxes and capsules, cylinders
/// within 0.2 % of their radius outside; of a mesh its convex hull.
template <int D>
struct Hull {
    std::vector<Vec<D>> points; ///< from the centre
    double radius = 0;
    double reach = 0; ///< of the ball about the centre that holds it

    bool ball() const { return points.size() == 1; }
    /// Turned by a rotation matrix, all lengths times a factor.
    Hull turned(const Mat<D>& rotation, double factor) const;
};

/// A hull in the frame of the shape whose hull it is.
template <int D>
struct ShapeHull {
    Hull<D> hull;
    Vec<D> centre; ///< of the hull, from the shape's origin
};

/// Of a bounded shape that is not inside out; `shape` is that of `body`.
template <int D>
ShapeHull<D> hull_of(const BodyScene& body, const Shape<D>& shape);

/// Whether two hulls are certainly at least `distance` apart, the second one's centre `way` from the first one's. Undecided pairs, within
/// about a hundredth of their size of the distance and no balls, count as closer.
template <int D>
bool apart(const Hull<D>& a, const Hull<D>& b, const Vec<D>& way, double distance);

/// Part of the domain for the bodies of a crowd, which lie wholly in it.
template <int D>
struct Region {
    enum class Kind { box, ball, cylinder };
    Kind kind = Kind::box;
    Vec<D> low, high;              ///< of a box; of the others' bounds
    std::array<bool, D> endless{}; ///< of a box: a whole period of the domain along the axis, without ends
    Vec<D> centre = Vec<D>::Zero(), axis = Vec<D>::Zero(); ///< of ball and cylinder; unit vector
    double radius = 0, length = 0;                         ///< of ball and cylinder

    double volume() const; ///< 2D: area
    bool holds(const Hull<D>& hull, const Vec<D>& at) const;
    /// A ball's centre, put where the region holds the ball, if it is large enough.
    Vec<D> inside(double radius, Vec<D> at) const;
};

/// Bodies of a domain by cells, for what is near a place. All distances are to the nearest images in a periodic domain.
template <int D>
class CrowdRoom {
public:
    /// With all bodies of the scene at their places at the start. Throws InputError for meshes that cannot be read.
    explicit CrowdRoom(const Scene& scene);

    const Vec<D>& low() const { return low_; }
    const Vec<D>& size() const { return size_; }
    /// Period along an axis; 0: none.
    const Vec<D>& period() const { return period_; }

    /// Prepares for bodies of at most this reach, `spacing` apart from all others and from walls.
    void expect(double reach, double spacing);
    double spacing() const { return spacing_; }

    /// Whether a body may be there. `except`: one of the crowds' bodies that does not count, -1: none.
    bool free(const Hull<D>& hull, const Vec<D>& at, int except = -1) const;
    /// Puts a crowd's body in; returns its number.
    int add(Hull<D> hull, const Vec<D>& at);
    void move(int body, const Vec<D>& at);
    /// Takes all bodies out again that were added since `count` were there.
    void cut_back(int count);
    int count() const { return static_cast<int>(bodies_.size()); }
    const Vec<D>& place(int body) const { return bodies_[static_cast<std::size_t>(body)].at; }
    const Hull<D>& hull(int body) const { return bodies_[static_cast<std::size_t>(body)].hull; }

    /// Moves a ball out of walls and of bodies that are none of a crowd, so that it is `spacing` from them where it can; returns
    /// how much too near it was.
    double push_out(double radius, double spacing, Vec<D>& at) const;
    /// The shift that puts a ball `spacing` from a crowd's body; 0 where it is.
    Vec<D> shift_from(int body, double radius, double spacing, const Vec<D>& at) const;
    /// The way from one place to another, to the nearest image.
    Vec<D> way(const Vec<D>& from, const Vec<D>& to) const;
    /// A place put back into the domain along periodic axes.
    Vec<D> wrapped(Vec<D> at) const;
    /// Numbers of the crowds' bodies whose centres may be within the range that expect() prepared for.
    template <class Visit>
    void near(const Vec<D>& at, Visit visit) const;

private:
    struct Body {
        Hull<D> hull;
        Vec<D> at;
        int cell = 0;
    };
    /// A body of the scene that is none of a crowd.
    struct Solid {
        std::unique_ptr<Shape<D>> shape;
        PlacedShape<D> placed;
        Hull<D> hull; ///< without points: none, the shape is not convex, unbounded or inside out
        Vec<D> at;    ///< centre of hull or bounds
    };
    struct Wall {
        int axis;
        double sign, offset; ///< the solid is where sign * x[axis] < offset
        bool closed;         ///< a wall, which bodies keep their spacing to; else an opening
    };

    bool free_of_walls(const Hull<D>& hull, const Vec<D>& at) const;
    bool free_of_solid(const Solid& solid, const Hull<D>& hull, const Vec<D>& at) const;
    bool free_of_hull(const Hull<D>& other, const Vec<D>& place, const Hull<D>& hull, const Vec<D>& at) const;
    int cell_of(const Vec<D>& at) const;
    void sort_in(int body);
    void take_out(int body);

    Vec<D> low_, size_, period_;
    std::vector<Wall> walls_;
    std::vector<Solid> solids_;
    std::vector<Body> bodies_;
    double spacing_ = 0, reach_ = 0;
    Index<D> cells_ = Index<D>::Ones();
    std::vector<std::vector<int>> in_cell_;
};

template <int D>
template <class Visit>
void CrowdRoom<D>::near(const Vec<D>& at, Visit visit) const
{
    const Vec<D> place = wrapped(at);
    Index<D> home, first, last;
    for (int axis = 0; axis < D; ++axis) {
        home[axis] = std::clamp(static_cast<int>((place[axis] - low_[axis]) / size_[axis] * cells_[axis]), 0, cells_[axis] - 1);
        const bool round = period_[axis] > 0;
        first[axis] = round ? (cells_[axis] < 3 ? 0 : home[axis] - 1) : std::max(home[axis] - 1, 0);
        last[axis] =
            round ? (cells_[axis] < 3 ? cells_[axis] - 1 : home[axis] + 1) : std::min(home[axis] + 1, cells_[axis] - 1);
    }
    Index<D> c = first;
    for (;;) {
        int number = 0;
        for (int axis = D - 1; axis >= 0; --axis)
            number = number * cells_[axis] + (c[axis] + cells_[axis]) % cells_[axis];
        for (const int body : in_cell_[static_cast<std::size_t>(number)])
            visit(body);
        int axis = 0;
        while (axis < D && ++c[axis] > last[axis]) {
            c[axis] = first[axis];
            ++axis;
        }
        if (axis == D)
            return;
    }
}

} // namespace gapflow
