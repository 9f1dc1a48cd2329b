#include "gapflow/stepping/gap_meshes.hpp"

#include "gapflow/stepping/observation.hpp"

namespace gapflow {

template <int D>
GapMeshes<D> film_meshes(const Model<D>& model, const Coupling<D>& here, const State<D>& state)
{
    const UnknownVector<D> p = reduced_pressure(state);
    GapMeshes<D> meshes;
    for (const Film<D>& film : here.network.films) {
        const FilmMesh<D>& mesh = film.mesh;
        const int number = static_cast<int>(meshes.solids.size()), first = static_cast<int>(meshes.nodes.size());
        meshes.solids.emplace_back(mesh.master, mesh.other);
        for (std::size_t i = 0; i < mesh.mid.size(); ++i) {
            const int node = film.first_node + static_cast<int>(i);
            meshes.nodes.push_back(mesh.mid[i]);
            meshes.thickness.push_back(mesh.h[i] + mesh.skin);
            meshes.pressure.push_back(p.nodes[node] + model.hydrostatic(mesh.mid[i]));
            meshes.void_depth.push_back(state.voids.depth(node));
            meshes.node_gap.push_back(number);
        }
        for (const FilmElement<D>& element : mesh.elements) {
            std::array<int, D> corners = element.nodes;
            for (int& node : corners)
                node += first;
            meshes.elements.push_back(corners);
            meshes.normal.push_back(element.normal);
            meshes.area.push_back(element.measure);
            meshes.element_gap.push_back(number);
        }
    }
    meshes.velocity = state.velocity.film;
    return meshes;
}

template GapMeshes<2> film_meshes<2>(const Model<2>&, const Coupling<2>&, const State<2>&);
template GapMeshes<3> film_meshes<3>(const Model<3>&, const Coupling<3>&, const State<3>&);

} // namespace gapflow
