#include "gapflow/film/film_vorticity.hpp"

namespace gapflow {

namespace {

constexpr double narrow = 1; // in dx: lateral scale of the gap below which vorticity is noise
constexpr double relaxation = 0.5;
constexpr int sweeps = 2;

void damp(const FilmMesh<3>& mesh, double dx, Vec<3>* u)
{
    const std::size_t nodes = mesh.x.size(), elements = mesh.elements.size();
    std::vector<char> inner(nodes, 1); // not on the rim, and the gap narrow all around
    bool any = false;
    for (const FilmElement<3>& e : mesh.elements) {
        any = any || e.lateral < narrow * dx;
        if (!(e.lateral < narrow * dx))
            for (int node : e.nodes)
                inner[node] = 0;
    }
    if (!any)
        return;
    for (const RimEdge<3>& rim : mesh.rim)
        for (int node : rim.nodes)
            inner[node] = 0;
    std::vector<double> diagonal(nodes, 0.0), psi(nodes);
    for (const FilmElement<3>& e : mesh.elements)
        for (int k = 0; k < 3; ++k)
            diagonal[e.nodes[k]] += e.measure * e.measure * e.gradient[k].squaredNorm() / e.conductance();
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        psi.assign(nodes, 0.0);
        for (std::size_t i = 0; i < elements; ++i) {
            const FilmElement<3>& e = mesh.elements[i];
            for (int k = 0; k < 3; ++k)
                if (inner[e.nodes[k]])
                    psi[e.nodes[k]] -= relaxation / diagonal[e.nodes[k]] * e.measure * u[i].dot(e.normal.cross(e.gradient[k]));
        }
        for (std::size_t i = 0; i < elements; ++i) {
            const FilmElement<3>& e = mesh.elements[i];
            for (int k = 0; k < 3; ++k)
                if (inner[e.nodes[k]])
                    u[i] += psi[e.nodes[k]] * e.measure / e.conductance() * e.normal.cross(e.gradient[k]);
        }
    }
}

} // namespace

template <>
void damp_vorticity<2>(const FilmNetwork<2>&, double, std::vector<Vec<2>>&)
{
}

template <>
void damp_vorticity<3>(const FilmNetwork<3>& network, double dx, std::vector<Vec<3>>& velocity)
{
    for (const Film<3>& film : network.films)
        damp(film.mesh, dx, velocity.data() + film.first_element);
}

} // namespace gapflow
