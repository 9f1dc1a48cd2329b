// Two plates with the film between them, turned and tilted at will: the mesh covers the lower one, or what the upper one leaves of it.
#pragma once

#include "film_mesh_checks.hpp"

#include "gapflow/film/film_transport.hpp"

#include <memory>
#include <random>

namespace gapflow::test {

/// About the last axis but one of the plane that stands upright along the first axis; 0: none.
template <int D>
Rotation<D> tilted(double angle)
{
    if constexpr (D == 2)
        return Rotation<2>(angle);
    else
        return Rotation<3>(Eigen::AngleAxisd(-angle, unit<3>(1)));
}

template <int D>
struct PlateSetup {
    double thickness = 0.2; ///< below the middle of the upper plate
    double upper = 6;       ///< its length; that of the lower plate: 4
    double aside = 0;       ///< of its middle, along the first axis
    double tilt = 0;        ///< of the upper plate
    double largest = 0.5;   ///< element size
    Pose<D> pose = {};      ///< of everything
};

/// The lower plate, solid 0, is the master; its upper face has the height 0 in its frame.
template <int D>
class GapOfPlates {
public:
    explicit GapOfPlates(const PlateSetup<D>& setup)
    {
        constexpr double thick = 1;
        Vec<D> low = Vec<D>::Constant(4), high = Vec<D>::Constant(setup.upper);
        low[D - 1] = high[D - 1] = thick;
        shapes_[0] = make_box<D>(low);
        shapes_[1] = make_box<D>(high);
        const Rotation<D> tilt = tilted<D>(setup.tilt);
        const Vec<D> up = thick / 2 * unit<D>(D - 1);
        const Vec<D> above = setup.aside * unit<D>(0) + setup.thickness * unit<D>(D - 1) + tilt * up;
        Pose<D> lower = setup.pose, upper = setup.pose;
        lower.position = setup.pose.position - setup.pose.rotation * up;
        upper.position = setup.pose.position + setup.pose.rotation * above;
        upper.rotation = setup.pose.rotation * tilt;
        solids.push_back({"lower", {*shapes_[0], lower}, setup.pose.position});
        solids.push_back({"upper", {*shapes_[1], upper}, upper.position});
        FilmMeshOptions options = options_with(0.9);
        options.largest = setup.largest;
        for (const FilmMesh<D>& mesh : films_of(solids[0].shape, solids[1].shape, options))
            network.films.push_back({{0, 1, {}}, mesh, options.threshold});
        number_films(network.films);
        network.elements = static_cast<int>(film().mesh.elements.size());
        network.nodes = static_cast<int>(film().mesh.x.size());
    }
    const Film<D>& film() const { return network.films.at(0); }
    const std::vector<FilmElement<D>>& elements() const { return film().mesh.elements; }
    const PlacedShape<D>& master() const { return solids[0].shape; }
    /// A mouth at each edge of the rim (2D: each end).
    void open_ends()
    {
        for (const RimEdge<D>& rim : film().mesh.rim) {
            Mouth<D> mouth{};
            mouth.nodes = rim.nodes;
            mouth.element = rim.element;
            mouth.shape.fill(1.0 / (D - 1));
            mouth.x = Vec<D>::Zero();
            for (int node : rim.nodes) {
                mouth.x += film().mesh.mid[node] / (D - 1);
                mouth.h += film().mesh.h[node] / (D - 1);
            }
            mouth.outward = rim.outward;
            mouth.section = mouth.h * rim.outward;
            mouth.length = rim.length;
            network.rim.mouths.push_back(mouth);
        }
    }
    /// Of velocities (world axes) that the elements have.
    FilmHistory<D> history(const std::vector<Vec<D>>& w, const Twist<D>& twist = Twist<D>::Zero()) const
    {
        return {solids[0], twist, {&film()}, w, {}, {}, {}, 1.0};
    }
    std::vector<FluidInPlace<D>> put_in_place(const FilmHistory<D>& old) const
    {
        return gapflow::put_in_place<D>(network, solids, {&old});
    }
    /// Fluid that fills the film, of velocities in the master's axes.
    std::vector<FluidInPlace<D>> filled(const std::vector<Vec<D>>& velocity) const
    {
        std::vector<FluidInPlace<D>> fluid(velocity.size());
        for (std::size_t i = 0; i < velocity.size(); ++i) {
            fluid[i].velocity = fluid[i].reference = velocity[i];
            fluid[i].volume = elements()[i].volume;
        }
        return fluid;
    }
    template <class F>
    std::vector<Vec<D>> at_elements(F&& f) const
    {
        std::vector<Vec<D>> values;
        for (const FilmElement<D>& e : elements())
            values.push_back(f(e));
        return values;
    }
    /// Sum of volume times value.
    template <class Value>
    Value over_volume(const std::vector<Value>& values, Value sum) const
    {
        for (std::size_t i = 0; i < values.size(); ++i)
            sum += elements()[i].volume * values[i];
        return sum;
    }
    double energy(const std::vector<Vec<D>>& velocity) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < velocity.size(); ++i)
            sum += 0.5 * elements()[i].volume * velocity[i].squaredNorm();
        return sum;
    }
    /// Random, along the film, of very different size; world axes.
    std::vector<Vec<D>> random_velocities(std::mt19937& random) const
    {
        std::normal_distribution<double> normal;
        return at_elements([&](const FilmElement<D>& e) {
            Vec<D> u;
            for (int axis = 0; axis < D; ++axis)
                u[axis] = normal(random);
            return Vec<D>(std::pow(10, normal(random)) * tangential<D>(u, e.normal));
        });
    }

    std::vector<Solid<D>> solids;
    FilmNetwork<D> network;

private:
    std::unique_ptr<Shape<D>> shapes_[2];
};

} // namespace gapflow::test
