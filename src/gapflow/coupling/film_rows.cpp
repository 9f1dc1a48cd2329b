#include "gapflow/coupling/film_rows.hpp"

#include "gapflow/film/film_cells.hpp"

#include <algorithm>

namespace gapflow {

namespace {

template <int D>
class FilmAssembler {
public:
    FilmAssembler(Coupling<D>& coupling, FluxRows<D>& rows)
        : coupling_(coupling), rows_(rows), grid_(*coupling.grid), network_(coupling.network), faces_(*network_.faces)
    {
    }

    void assemble()
    {
        rows_.nodes.assign(network_.nodes, {});
        find_mouth_cells();
        assemble_elements();
        assemble_closed_faces();
        assemble_other_walls();
        assemble_third_bodies();
        assemble_mouths();
    }

private:
    const Film<D>& film(int k) const { return network_.films[k]; }
    const Vec<D>& centre(int solid) const { return coupling_.solids[solid].centre; }
    Vec<D> other_centre(const FilmMesh<D>& mesh) const { return centre(mesh.other) + mesh.shift; }

    // Flux w of the other wall (or a third body's) relative to the master: + for the body, - for the master.
    // Wrenches are about the body's centre (in the film's frame: `centre`); the master's about its own.
    template <class Add>
    void add_relative(Add&& add, const FilmMesh<D>& mesh, int solid, const Vec<D>& solid_centre, const Twist<D>& flux, double share)
    {
        add(solid, share * flux);
        Twist<D> about_master = flux;
        about_master.template tail<spin_size<D>>() +=
            moment<D>(solid_centre - centre(mesh.master), Vec<D>(flux.template head<D>()));
        add(mesh.master, -share * about_master);
    }

    auto to_node(int node)
    {
        return [this, node](int solid, const Twist<D>& flux) { rows_.add_node(node, solid, flux); };
    }
    auto to_cell(long key)
    {
        return [this, key](int solid, const Twist<D>& flux) { rows_.add_cell(key, solid, flux); };
    }

    // Each film's conduits' cells with their share of the rim.
    void find_mouth_cells()
    {
        mouth_.assign(network_.films.size(), {});
        std::vector<double> total(network_.films.size(), 0);
        conduits_.assign(network_.films.size(), {});
        for (const Conduit<D>& conduit : network_.mouths.conduits) {
            if (!conduit.cells.empty())
                conduits_[conduit.film].push_back(&conduit);
            for (const auto& [key, weight] : conduit.cells) {
                mouth_[conduit.film][key] += conduit.length * weight;
                total[conduit.film] += conduit.length * weight;
            }
        }
        for (std::size_t k = 0; k < mouth_.size(); ++k)
            for (auto& [key, weight] : mouth_[k])
                weight /= total[k];
    }

    // Item 8: stiffness S / rho grad N_i . grad N_j (harmonic on coarse elements), and the flux that the master carries
    // along; item 9: inertia across the gap.
    void assemble_elements()
    {
        std::vector<Eigen::Triplet<double>> entries;
        coupling_.normal_inertia.clear();
        for (const Film<D>& f : network_.films) {
            const FilmMesh<D>& mesh = f.mesh;
            for (const FilmElement<D>& e : mesh.elements) {
                const double conductance = e.conductance() / coupling_.density;
                for (int i = 0; i < D; ++i) {
                    const int node = f.first_node + e.nodes[i];
                    for (int j = 0; j < D; ++j)
                        entries.emplace_back(node, f.first_node + e.nodes[j], conductance * e.gradient[i].dot(e.gradient[j]));
                    rows_.add_node(node, mesh.master, e.volume * wrench<D>(e.gradient[i], e.centroid - centre(mesh.master)));
                }
                coupling_.normal_inertia.push_back({mesh.master, mesh.other,
                                                    0.5 * wrench<D>(e.normal, e.centroid - centre(mesh.master)),
                                                    0.5 * wrench<D>(e.normal, e.centroid - other_centre(mesh)),
                                                    coupling_.density * e.volume});
            }
        }
        coupling_.system.film.resize(network_.nodes, network_.nodes);
        coupling_.system.film.setFromTriplets(entries.begin(), entries.end());
    }

    // Item 5: whoever looks at a closed face from outside film k sees a solid of its master there.
    void assemble_closed_faces()
    {
        const auto& cells = network_.cells.cells;
        for (const auto& [key, cell] : cells) {
            const Index<D> c = grid_.cell_of_key(key);
            for (const CellSide<D>& side : sides_of(grid_, c)) {
                if (!side.inside)
                    continue;
                auto closed = network_.cells.closed.find(faces_.key(side.axis, side.face));
                if (closed == network_.cells.closed.end())
                    continue;
                const int k = closed->second;
                const long beyond_key = grid_.key(grid_.wrapped(side.cell));
                auto beyond = cells.find(beyond_key);
                const Index<D> offset = cell.offset(k);
                if (!(cell.kind == CellKind::film && cell.owner == k))
                    add_closed(key, k, side, offset, 2 * side.end - 1);
                if (beyond == cells.end())
                    add_closed(beyond_key, k, side, offset, 1 - 2 * side.end);
            }
        }
    }

    void add_closed(long key, int k, const CellSide<D>& side, const Index<D>& offset, int sign)
    {
        const ClippedFace<D>& face = faces_.face(side.axis, side.face);
        const Vec<D> x = face.open_centroid + faces_.displacement(side.face) + grid_.dx() * offset.template cast<double>();
        const int master = film(k).mesh.master;
        const Vec<D> area = sign * face.open * grid_.face_area() * unit<D>(side.axis);
        closed_flux_[key].push_back({master, wrench<D>(area, x - centre(master)),
                                     centre(master) - grid_.dx() * offset.template cast<double>()});
    }

    struct CellFlux {
        int solid;
        Twist<D> flux; ///< wrench about the solid's centre
        Vec<D> centre; ///< of the solid's image that lies here
    };

    // Flux of each solid out of a film cell through its own clipped faces.
    std::vector<CellFlux> own_flux(const Index<D>& c) const
    {
        std::vector<CellFlux> fluxes;
        for (const CellSide<D>& side : sides_of(grid_, c))
            for (const SolidPart<D>& part : faces_.face(side.axis, side.face).solid) {
                const Twist<D> flux = wrench<D>((2 * side.end - 1) * part.fraction * grid_.face_area() * unit<D>(side.axis), part.arm);
                const Vec<D> x = part.centroid + faces_.displacement(side.face);
                // Parts of one solid may belong to different images: keep them apart by the place of their centre.
                auto same = std::find_if(fluxes.begin(), fluxes.end(), [&](const CellFlux& other) {
                    return other.solid == part.solid && (x - part.arm - other.centre).norm() < grid_.dx();
                });
                if (same == fluxes.end())
                    fluxes.push_back({part.solid, flux, x - part.arm});
                else
                    same->flux += flux;
            }
        return fluxes;
    }

    // Items 6 and 7: the other wall's flux, shared over each point's nodes and taken out of the container of the cell where
    // the closest point lies; what a film cell's own J and its points disagree on goes to the mouths.
    void assemble_other_walls()
    {
        std::map<long, Twist<D>> remainder; // of film cells: own J of the other wall less what its points took
        for (const auto& [key, cell] : network_.cells.cells) {
            if (cell.kind != CellKind::film)
                continue;
            Twist<D>& rest = remainder.emplace(key, Twist<D>::Zero()).first->second;
            const FilmMesh<D>& mesh = film(cell.owner).mesh;
            const Vec<D> here = grid_.dx() * cell.offset(cell.owner).template cast<double>();
            for (const CellFlux& flux : own_flux(grid_.cell_of_key(key)))
                add_in_film_cell_of(key, mesh, flux, here, rest);
            if (auto closed = closed_flux_.find(key); closed != closed_flux_.end())
                for (const CellFlux& flux : closed->second)
                    add_in_film_cell_of(key, mesh, flux, here, rest);
        }
        std::vector<Twist<D>> lost(network_.films.size(), Twist<D>::Zero());
        for (int k = 0; k < static_cast<int>(network_.films.size()); ++k) {
            const FilmMesh<D>& mesh = film(k).mesh;
            for (const FilmPoint<D>& point : mesh.points) {
                const Twist<D> flux = wrench<D>(point.area, point.area_centroid - other_centre(mesh));
                add_at_point(k, point, mesh.other, other_centre(mesh), flux, 1.0);
                const Index<D> c = grid_.wrapped(grid_.cell_of(point.y + 1e-9 * grid_.dx() * point.other_normal));
                const long key = grid_.in_domain(c) ? grid_.key(c) : -1;
                auto it = network_.cells.cells.find(key);
                const CellKind kind = key < 0 ? CellKind::solid
                                      : it != network_.cells.cells.end() ? it->second.kind
                                                                         : kind_of(faces_, network_.cells, c);
                if (kind == CellKind::bulk || kind == CellKind::mixed)
                    add_relative(to_cell(key), mesh, mesh.other, other_centre(mesh), flux, -1.0);
                else if (kind == CellKind::film && it->second.owner == k)
                    remainder[key] -= flux;
                else if (kind == CellKind::film)
                    add_in_film_cell(it->second, k, c, flux, -1.0);
                else
                    lost[k] -= flux;
            }
        }
        for (const auto& [key, rest] : remainder)
            add_to_nearest_mouth(key, rest, lost);
        for (int k = 0; k < static_cast<int>(network_.films.size()); ++k) {
            const FilmMesh<D>& mesh = film(k).mesh;
            for (const auto& [key, weight] : mouth_[k])
                add_relative(to_cell(key), mesh, mesh.other, other_centre(mesh), lost[k], weight);
            if (mouth_[k].empty())
                for (const FilmPoint<D>& point : mesh.points)
                    add_at_point(k, point, mesh.other, other_centre(mesh), lost[k], 1.0 / static_cast<double>(mesh.points.size()));
        }
    }

    // A film cell's remainder leaves through the nearest mouth of its film (spread over all mouths it would short-circuit
    // pockets that several films enclose); without mouths it is left to the film as a whole.
    void add_to_nearest_mouth(long key, const Twist<D>& rest, std::vector<Twist<D>>& lost)
    {
        const FilmCell<D>& cell = network_.cells.cells.at(key);
        const Vec<D> x = grid_.cell_centre(grid_.cell_of_key(key) + cell.offset(cell.owner));
        const std::vector<const Conduit<D>*>& mouths = conduits_[cell.owner];
        const auto nearest = std::min_element(mouths.begin(), mouths.end(), [&](const Conduit<D>* a, const Conduit<D>* b) {
            return (a->x - x).squaredNorm() < (b->x - x).squaredNorm();
        });
        if (nearest == mouths.end()) {
            lost[cell.owner] += rest;
            return;
        }
        const FilmMesh<D>& mesh = film(cell.owner).mesh;
        for (const auto& [to, weight] : (*nearest)->cells)
            add_relative(to_cell(to), mesh, mesh.other, other_centre(mesh), rest, weight);
    }

    // Flux of a solid out of a film cell: the other wall's into `rest`, the master's vanishes, third bodies' for later.
    void add_in_film_cell_of(long key, const FilmMesh<D>& mesh, const CellFlux& flux, const Vec<D>& here, Twist<D>& rest)
    {
        const double half = 0.5 * grid_.size().minCoeff();
        if (flux.solid == mesh.other && (coupling_.solids[flux.solid].wall || (flux.centre + here - other_centre(mesh)).norm() < half))
            rest += flux.flux;
        else if (flux.solid != mesh.master)
            third_.push_back({key, flux.solid, flux.flux, flux.centre + here});
    }

    void add_at_point(int k, const FilmPoint<D>& point, int solid, const Vec<D>& solid_centre, const Twist<D>& flux, double share)
    {
        const Film<D>& f = film(k);
        const FilmElement<D>& e = f.mesh.elements[point.element];
        for (int i = 0; i < D; ++i)
            add_relative(to_node(f.first_node + e.nodes[i]), f.mesh, solid, solid_centre, flux, share * point.shape[i]);
    }

    // A point of film k whose closest point lies in a cell of another film: that film's container, relative to k's master.
    void add_in_film_cell(const FilmCell<D>& cell, int k, const Index<D>& c, const Twist<D>& flux, double share)
    {
        const FilmMesh<D>& mesh = film(k).mesh;
        const Film<D>& owner = film(cell.owner);
        const FilmPoint<D>& point = nearest_point(cell, c);
        const FilmElement<D>& e = owner.mesh.elements[point.element];
        for (int i = 0; i < D; ++i)
            add_relative(to_node(owner.first_node + e.nodes[i]), mesh, mesh.other, other_centre(mesh), flux,
                         share * point.shape[i]);
    }

    const FilmPoint<D>& nearest_point(const FilmCell<D>& cell, const Index<D>& c) const
    {
        const Vec<D> x = grid_.cell_centre(c + cell.offset(cell.owner));
        const std::vector<FilmPoint<D>>& points = film(cell.owner).mesh.points;
        return *std::min_element(points.begin(), points.end(), [&](const FilmPoint<D>& a, const FilmPoint<D>& b) {
            return (0.5 * (a.x + a.y) - x).squaredNorm() < (0.5 * (b.x + b.y) - x).squaredNorm();
        });
    }

    // A third body's flux in a film cell goes to the nearest point's nodes, relative to the master.
    void assemble_third_bodies()
    {
        for (const Third& third : third_) {
            if (third.flux.template head<D>().norm() <= 1e-14 * grid_.face_area())
                continue;
            const FilmCell<D>& cell = network_.cells.cells.at(third.key);
            add_at_point(cell.owner, nearest_point(cell, grid_.cell_of_key(third.key)), third.solid, third.centre, third.flux, 1.0);
        }
        for (const auto& [key, fluxes] : closed_flux_) { // bulk and mixed cells beside closed faces
            auto it = network_.cells.cells.find(key);
            if (it != network_.cells.cells.end() && it->second.kind == CellKind::film)
                continue;
            for (const CellFlux& flux : fluxes)
                rows_.add_cell(key, flux.solid, flux.flux);
        }
    }

    // Section 3.4: q = (p_film - p_bulk) length / (rho R) + q*; the master carries length h nu . U_m along.
    void assemble_mouths()
    {
        std::vector<Link>& links = coupling_.system.links;
        links.clear();
        for (const Conduit<D>& conduit : network_.mouths.conduits) {
            const FilmMesh<D>& mesh = film(conduit.film).mesh;
            const Twist<D> carried = conduit.length * conduit.h * wrench<D>(conduit.outward, conduit.x - centre(mesh.master));
            Link link{conduit.length / (coupling_.density * conduit.resistance), {}, {}};
            if (conduit.kind == ConduitKind::inflow)
                link.conductance = 0;
            for (int i = 0; i < D - 1; ++i) {
                link.nodes.emplace_back(conduit.nodes[i], conduit.shape[i]);
                rows_.add_node(conduit.nodes[i], mesh.master, -conduit.shape[i] * carried);
            }
            for (const auto& [key, weight] : conduit.cells) {
                link.cells.emplace_back(key, -weight);
                rows_.add_cell(key, mesh.master, weight * carried);
            }
            links.push_back(std::move(link));
        }
        for (const Joint<D>& joint : network_.mouths.joints) {
            Link link{joint.conductance / coupling_.density, {}, {}};
            for (int i = 0; i < D - 1; ++i) {
                link.nodes.emplace_back(joint.nodes_a[i], joint.shape_a[i]);
                link.nodes.emplace_back(joint.nodes_b[i], -joint.shape_b[i]);
            }
            links.push_back(std::move(link));
        }
    }

    struct Third {
        long key;
        int solid;
        Twist<D> flux;
        Vec<D> centre;
    };

    Coupling<D>& coupling_;
    FluxRows<D>& rows_;
    const Grid<D>& grid_;
    const FilmNetwork<D>& network_;
    const FaceCache<D>& faces_;
    std::vector<std::map<long, double>> mouth_;               ///< of each film: cells and their share of the rim
    std::vector<std::vector<const Conduit<D>*>> conduits_;    ///< of each film, those that end in cells
    std::map<long, std::vector<CellFlux>> closed_flux_;
    std::vector<Third> third_;
};

} // namespace

template <int D>
void assemble_films(Coupling<D>& coupling, FluxRows<D>& rows)
{
    FilmAssembler<D>(coupling, rows).assemble();
}

template void assemble_films<2>(Coupling<2>&, FluxRows<2>&);
template void assemble_films<3>(Coupling<3>&, FluxRows<3>&);

} // namespace gapflow
