#include "gapflow/stepping/sampling.hpp"

#include "gapflow/film/film_motion.hpp"
#include "gapflow/grid/interpolation.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace gapflow {

namespace {

constexpr double on_surface = 1e-6; // in dx: a point this deep in a solid still lies on its surface

/// The cells around one, 3^D of them, the middle one in the middle.
template <int D>
constexpr int around = D == 2 ? 9 : 27;

template <int D>
Index<D> way_to(int number)
{
    Index<D> way;
    for (int axis = 0; axis < D; ++axis, number /= 3)
        way[axis] = number % 3 - 1;
    return way;
}

template <int D>
int number_of(const Index<D>& way)
{
    int number = 0;
    for (int axis = D - 1; axis >= 0; --axis)
        number = 3 * number + way[axis] + 1;
    return number;
}

template <int D>
class Sampler {
public:
    Sampler(const Model<D>& model, const Coupling<D>& here, const State<D>& state, const std::vector<Twist<D>>& V)
        : grid_(model.grid), model_(model), here_(here), state_(state), gaps_(grid_, here.solids, here.network.films),
          pressure_(grid_), known_(grid_), film_normal_(wall_normal_speed<D>(here.network, here.solids, V)),
          per_impulse_(state.dt > 0 ? 1 / state.dt : 0.0)
    {
        for (long i = 0; i < pressure_.size(); ++i)
            pressure_.data()[i] = state.pressure.impulse.cells.data()[i];
        for_each_index<D>(grid_.low(), grid_.high(),
                          [&](const Index<D>& c) { known_(c) = here.system.component(c) >= 0 ? 1 : 0; });
        exchange(grid_, pressure_, 1);
        exchange(grid_, known_, 1);
    }

    /// The cell of this rank that a point lies in; points on the domain's high sides belong to the last cell.
    std::optional<Index<D>> cell_of(const Vec<D>& x) const
    {
        for (int axis = 0; axis < D; ++axis) { // beyond the sides of a grid that moves
            const double from = x[axis] - grid_.origin()[axis], round_off = 1e-6 * grid_.dx();
            if (!grid_.periodic(axis) && (from < -round_off || from > grid_.size()[axis] + round_off))
                return std::nullopt;
        }
        const Index<D> c = grid_.cell_of(x).cwiseMax(0).cwiseMin(grid_.cells() - Index<D>::Ones());
        return grid_.owns(c) ? std::optional(c) : std::nullopt;
    }

    PointValues<D> at(const Vec<D>& x, const Index<D>& c)
    {
        PointValues<D> values;
        if (in_solid(x))
            return values;
        if (const FilmCell<D>* cell = here_.network.cells.cells.find(grid_.key(c))) {
            const auto at_film = [&](int film) { return Vec<D>(x + grid_.dx() * cell->offset(film).template cast<double>()); };
            for (const Touch<D>& touch : cell->touches)
                if (gaps_.holds(touch.film, at_film(touch.film)))
                    return in_film(x, at_film(touch.film), touch.film);
            if (cell->kind == CellKind::film) // all of its fluid is the film's
                return in_film(x, at_film(cell->owner), cell->owner);
        }
        const std::optional<double> impulse = bulk_impulse(x, c);
        if (!impulse)
            return values;
        values.kind = PointKind::bulk;
        values.pressure = per_impulse_ * *impulse + model_.hydrostatic(x);
        for (int axis = 0; axis < D; ++axis)
            values.velocity[axis] = interpolate_face(grid_, state_.velocity.grid[axis], axis, x);
        values.vorticity = vorticity_at(grid_, state_.velocity.grid, x);
        return values;
    }

private:
    bool in_solid(const Vec<D>& x)
    {
        here_.clipper->near(x, grid_.dx(), near_);
        return std::any_of(near_.begin(), near_.end(), [&](int image) {
            const Image<D>& solid = here_.clipper->images()[image];
            return !here_.solids[solid.solid].wall && solid.shape.distance(x) < -on_surface * grid_.dx();
        });
    }

    // Of the film's element over which the point lies, or that is nearest to it.
    PointValues<D> in_film(const Vec<D>& x, const Vec<D>& there, int number) const
    {
        const Film<D>& film = here_.network.films[number];
        double least = std::numeric_limits<double>::infinity();
        std::array<double, D> shape{};
        std::size_t nearest = 0;
        for (std::size_t e = 0; e < film.mesh.elements.size(); ++e) {
            const FilmElement<D>& element = film.mesh.elements[e];
            std::array<double, D> own;
            double sum = 0;
            for (int i = 0; i < D; ++i)
                sum += own[i] = std::max(1.0 / D + element.gradient[i].dot(there - element.centroid), 0.0);
            Vec<D> foot = Vec<D>::Zero();
            for (int i = 0; i < D; ++i)
                foot += (own[i] /= sum) * film.mesh.mid[element.nodes[i]];
            if (const double distance = (foot - there).squaredNorm(); distance < least) {
                least = distance;
                shape = own;
                nearest = e;
            }
        }
        const FilmElement<D>& element = film.mesh.elements[nearest];
        const std::size_t e = film.first_element + nearest;
        PointValues<D> values;
        values.kind = PointKind::film;
        double impulse = 0;
        for (int i = 0; i < D; ++i)
            impulse += shape[i] * state_.pressure.impulse.nodes[film.first_node + element.nodes[i]];
        values.pressure = per_impulse_ * impulse + model_.hydrostatic(x);
        values.velocity = state_.velocity.film[e] + film_normal_[e] * element.normal;
        return values;
    }

    // The cells around c, itself too, that hold a pressure and that open faces connect with each other and with c; where c holds none
    // (its fluid is a sliver), with the one of them nearest to x.
    std::array<char, around<D>> connected(const Vec<D>& x, const Index<D>& c) const
    {
        std::array<char, around<D>> known{}, reached{};
        int start = -1;
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < around<D>; ++i) {
            const Index<D> cell = c + way_to<D>(i);
            known[i] = grid_.in_domain(grid_.wrapped(cell)) && known_(cell);
            const double distance = i == around<D> / 2 ? -1 : (grid_.cell_centre(cell) - x).squaredNorm();
            if (known[i] && distance < least) {
                least = distance;
                start = i;
            }
        }
        if (start < 0)
            return reached;
        std::array<int, around<D>> list;
        int count = 0;
        reached[list[count++] = start] = 1;
        for (int k = 0; k < count; ++k)
            for (int side = 0; side < 2 * D; ++side) {
                const int axis = side / 2, end = side % 2;
                const Index<D> way = way_to<D>(list[k]), next = way + (2 * end - 1) * step<D>(axis);
                if (std::abs(next[axis]) > 1)
                    continue;
                const int i = number_of<D>(next);
                if (known[i] && !reached[i] && here_.fractions->open(axis, Index<D>(c + way + end * step<D>(axis))) > 0)
                    reached[list[count++] = i] = 1;
            }
        return reached;
    }

    std::optional<double> bulk_impulse(const Vec<D>& x, const Index<D>& c) const
    {
        const std::array<char, around<D>> cells = connected(x, c);
        if (std::none_of(cells.begin(), cells.end(), [](char in) { return in != 0; }))
            return {};
        const Vec<D> place = grid_.graded() ? Vec<D>(grid_.lattice_place(0, x) - c.template cast<double>())
                                            : Vec<D>((x - grid_.cell_centre(c)) / grid_.dx());
        double value = 0;
        bool whole = true;
        for (int corner = 0; corner < (1 << D); ++corner) {
            Index<D> way;
            double weight = 1;
            for (int axis = 0; axis < D; ++axis) {
                const bool far = corner >> axis & 1;
                way[axis] = far ? (place[axis] < 0 ? -1 : 1) : 0;
                weight *= far ? std::abs(place[axis]) : 1 - std::abs(place[axis]);
            }
            if (weight == 0)
                continue;
            whole = whole && cells[number_of<D>(way)];
            if (whole)
                value += weight * pressure_(Index<D>(c + way));
        }
        return whole ? value : fitted(place, c, cells);
    }

    // The linear function of least squares, nearer cells counting more; along directions that the cells do not span it is constant.
    double fitted(const Vec<D>& place, const Index<D>& c, const std::array<char, around<D>>& cells) const
    {
        using Row = Eigen::Matrix<double, D + 1, 1>;
        constexpr double stiff = 1e-8;
        Eigen::Matrix<double, D + 1, D + 1> normal = Eigen::Matrix<double, D + 1, D + 1>::Zero();
        Row right = Row::Zero();
        for (int axis = 0; axis < D; ++axis)
            normal(axis + 1, axis + 1) = stiff;
        for (int i = 0; i < around<D>; ++i) {
            if (!cells[i])
                continue;
            Row row;
            row << 1.0, way_to<D>(i).template cast<double>() - place;
            const double weight = 1 / (0.1 + row.template tail<D>().squaredNorm());
            normal += weight * row * row.transpose();
            right += weight * pressure_(Index<D>(c + way_to<D>(i))) * row;
        }
        return Row(normal.ldlt().solve(right))[0];
    }

    const Grid<D>& grid_;
    const Model<D>& model_;
    const Coupling<D>& here_;
    const State<D>& state_;
    FilmGaps<D> gaps_;
    CellField<D> pressure_; ///< impulse, with ghosts
    CellField<D, std::int8_t> known_;
    std::vector<double> film_normal_;
    double per_impulse_;
    std::vector<int> near_;
};

// du_b/dx_a - du_a/dx_b at x, linear between the places that are midway between faces of both axes.
template <int D>
double curl(const Grid<D>& grid, const FaceField<D>& u, int a, int b, const Vec<D>& x)
{
    const Vec<D> place =
        grid.graded() ? grid.lattice_place(1u << a | 1u << b, x)
                      : Vec<D>((x - grid.origin()) / grid.dx() - Vec<D>::Constant(0.5) + 0.5 * (unit<D>(a) + unit<D>(b)));
    const Index<D> low = place.array().floor().template cast<int>();
    double value = 0;
    for (int corner = 0; corner < (1 << D); ++corner) {
        Index<D> n = low;
        double weight = 1;
        for (int axis = 0; axis < D; ++axis) {
            const double f = place[axis] - low[axis];
            n[axis] += corner >> axis & 1;
            weight *= corner >> axis & 1 ? f : 1 - f;
        }
        if (weight > 0 && grid.graded())
            value += weight * ((u(b, n) - u(b, Index<D>(n - step<D>(a)))) / grid.spread(a, n[a]) -
                               (u(a, n) - u(a, Index<D>(n - step<D>(b)))) / grid.spread(b, n[b]));
        else if (weight > 0)
            value += weight * (u(b, n) - u(b, Index<D>(n - step<D>(a))) - u(a, n) + u(a, Index<D>(n - step<D>(b))));
    }
    return value / grid.dx();
}

} // namespace

template <int D>
Spin<D> vorticity_at(const Grid<D>& grid, const FaceField<D>& velocity, const Vec<D>& x)
{
    if constexpr (D == 2)
        return Spin<2>(curl<2>(grid, velocity, 0, 1, x));
    else
        return Spin<3>(curl<3>(grid, velocity, 1, 2, x), curl<3>(grid, velocity, 2, 0, x), curl<3>(grid, velocity, 0, 1, x));
}

template <int D>
std::vector<PointValues<D>> sample_points(const Model<D>& model, const Coupling<D>& here, const State<D>& state,
                                          const std::vector<Twist<D>>& V, std::span<const Vec<D>> points)
{
    constexpr int count = 2 + D + spin_size<D>; // kind, pressure, velocity, vorticity
    Sampler<D> sampler(model, here, state, V);
    std::vector<double> numbers(count * points.size(), 0.0);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const std::optional<Index<D>> c = sampler.cell_of(points[i])) {
            const PointValues<D> values = sampler.at(points[i], *c);
            Eigen::Map<Eigen::Matrix<double, count, 1>>(&numbers[count * i]) << static_cast<double>(values.kind),
                values.pressure, values.velocity, values.vorticity;
        }
    model.grid.comm().sum(numbers); // one rank has each point
    std::vector<PointValues<D>> result(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double* number = &numbers[count * i];
        result[i].kind = static_cast<PointKind>(static_cast<int>(number[0]));
        result[i].pressure = number[1];
        result[i].velocity = Eigen::Map<const Vec<D>>(number + 2);
        result[i].vorticity = Eigen::Map<const Spin<D>>(number + 2 + D);
    }
    return result;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Spin<D> vorticity_at<D>(const Grid<D>&, const FaceField<D>&, const Vec<D>&);                                      \
    template std::vector<PointValues<D>> sample_points<D>(const Model<D>&, const Coupling<D>&, const State<D>&,                \
                                                          const std::vector<Twist<D>>&, std::span<const Vec<D>>);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
