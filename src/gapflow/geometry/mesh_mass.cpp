// Mass properties of a polyhedron (polygon): sum over the simplices that a point spans with each facet. With the vertices
// v_0 .. v_{D-1} of a facet as seen from that point, s = sum of v_i, the simplex has
//   volume V = det(v) / D!,   first moment V s / (D + 1),   second moment V (s s^T + sum v_i v_i^T) / ((D + 1) (D + 2)),
// exact (Tonon 2004). The point is the mean of the vertices, which keeps round-off small far from the origin.
#include "gapflow/geometry/mesh_mass.hpp"

namespace gapflow {

template <int D>
MassProperties<D> mass_properties_of(const SurfaceMesh<D>& mesh)
{
    Vec<D> origin = Vec<D>::Zero();
    for (const auto& facet : mesh.elements)
        for (int v : facet)
            origin += mesh.vertices[v] / double(D * mesh.elements.size());
    double volume = 0;
    Vec<D> first = Vec<D>::Zero();
    Mat<D> second = Mat<D>::Zero();
    for (const auto& facet : mesh.elements) {
        Mat<D> v; // one vertex per column
        for (int i = 0; i < D; ++i)
            v.col(i) = mesh.vertices[facet[i]] - origin;
        const double part = v.determinant() / (D == 2 ? 2 : 6);
        const Vec<D> s = v.rowwise().sum();
        volume += part;
        first += part / (D + 1) * s;
        second += part / ((D + 1) * (D + 2)) * (s * s.transpose() + v * v.transpose());
    }
    const Vec<D> centre = first / volume;
    second -= volume * centre * centre.transpose();
    MassProperties<D> mass{volume, origin + centre, {}};
    if constexpr (D == 2)
        mass.inertia(0, 0) = second.trace();
    else
        mass.inertia = second.trace() * Mat<3>::Identity() - second;
    return mass;
}

template MassProperties<2> mass_properties_of<2>(const SurfaceMesh<2>&);
template MassProperties<3> mass_properties_of<3>(const SurfaceMesh<3>&);

} // namespace gapflow
