#include "gapflow/coupling/film_rows.hpp"

#include "gapflow/core/threads.hpp"
#include "gapflow/coupling/film_drag.hpp"
#include "gapflow/film/cell_states.hpp"
#include "gapflow/film/film_motion.hpp"
#include "gapflow/film/mouth_cells.hpp"
#include "gapflow/grid/inline_vector.hpp"

#include <algorithm>
#include <limits>

namespace gapflow {

namespace {

constexpr int cells_around_points =
    5; // in which a film's share of rows may lie, beside its mouths' cells: those of faces behind its mouths, four cells away
constexpr double equally_near = 1e-9; // squares of distances that differ by this part are the same

template <int D>
class FilmAssembler {
public:
    FilmAssembler(Coupling<D>& coupling, FluxRows<D>& rows)
        : coupling_(coupling), rows_(rows), grid_(*coupling.grid), network_(coupling.network), faces_(*network_.faces)
    {
    }

    void assemble()
    {
        if (D == 2 && !coupling_.mouth_drag.empty())
            closed_areas_ = closed_areas(grid_, network_);

        find_mouths();
        choose_films();
        assemble_elements();
        assemble_closed_faces();
        assemble_other_walls();
        assemble_third_bodies();
        assemble_mouths();
    }

private:
    /// A box of cells; they may lie beyond a periodic domain.
    struct CellBox {
        Index<D> low = Index<D>::Constant(std::numeric_limits<int>::max()),
                 high = Index<D>::Constant(std::numeric_limits<int>::min());

        void add(const Index<D>& cell)
        {
            low = low.cwiseMin(cell);
            high = high.cwiseMax(cell);
        }
        void widen(int cells)
        {
            low.array() -= cells;
            high.array() += cells;
        }
        /// Whether an image of the box has cells in common with the other.
        bool meets(const CellBox& other, const Grid<D>& grid) const
        {
            if ((other.low.array() > other.high.array()).any())
                return false;
            for (int axis = 0; axis < D; ++axis) {
                const int period = grid.periodic(axis) ? grid.cells()[axis] : 0;
                bool any = false;
                for (int image = -1; image <= 1; ++image)
                    any = any ||
                          (low[axis] + image * period <= other.high[axis] && high[axis] + image * period >= other.low[axis]);
                if (!any)
                    return false;
            }
            return true;
        }
    };

    using Nearest = InlineVector<int, 2>; // those that are equally near share what goes to the nearest

    struct Third {
        long key;
        int solid;
        Twist<D> flux;
        Vec<D> centre;
    };

    const Film<D>& film(int k) const { return network_.films[k]; }
    const Vec<D>& centre(int solid) const { return coupling_.solids[solid].centre; }
    Vec<D> other_centre(const FilmMesh<D>& mesh) const { return centre(mesh.other) + mesh.shift; }
    Twist<D> other_flux(const FilmMesh<D>& mesh, const FilmPoint<D>& point) const
    {
        const auto [area, centroid] = wall_share(mesh, point);
        return wrench<D>(area, centroid - other_centre(mesh));
    }

    // Flux w of the other wall (or a third body's) relative to the master: + for the body, - for the master.
    // Wrenches are about the body's centre (in the film's frame: `centre`); the master's about its own.
    template <class Add>
    void add_relative(Add&& add, const FilmMesh<D>& mesh, int solid, const Vec<D>& solid_centre, const Twist<D>& flux,
                      double share)
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

    // Each film's mouths that end in cells.
    void find_mouths()
    {
        mouths_.assign(network_.films.size(), {});
        mouth_places_ = mouth_places(network_);
        for (const Mouth<D>& mouth : network_.rim.mouths)
            if (!mouth.cells.empty())
                mouths_[mouth.film].push_back(&mouth);
    }

    // The films that this rank assembles: its own, and those whose mouths or closest points lie in its cells or among its own films' cells.
    void choose_films()
    {
        assembled_.assign(network_.films.size(), 1);
        if (grid_.comm().size() == 1)
            return;
        CellBox own_cells;
        for (const auto& [key, cell] : network_.cells.cells)
            if (cell.kind == CellKind::film && film(cell.owner).here)
                own_cells.add(grid_.cell_of_key(key));
        CellBox block;
        block.add(grid_.low());
        block.add(grid_.high() - Index<D>::Ones());
        for_each_job(static_cast<int>(network_.films.size()), [&](int k) {
            CellBox points;
            for (const Vec<D>& y : film(k).mesh.y)
                points.add(grid_.cell_of(y));
            points.widen(cells_around_points);
            assembled_[k] = film(k).here || points.meets(block, grid_) || points.meets(own_cells, grid_);
            for (const Mouth<D>* mouth : mouths_[k])
                for (const auto& entry : mouth->cells)
                    assembled_[k] = assembled_[k] || grid_.owns(grid_.cell_of_key(entry.first));
        });
    }

    // Stiffness S / rho grad N_i . grad N_j (harmonic on coarse elements), the flux that moves with the master, and
    // inertia across the gap.
    void assemble_elements()
    {
        std::vector<std::size_t> first(network_.films.size()); // of a film's elements among this rank's
        std::size_t elements = 0;
        for (std::size_t k = 0; k < first.size(); ++k) {
            first[k] = elements;
            elements += network_.films[k].here ? network_.films[k].mesh.elements.size() : 0;
        }
        coupling_.normal_inertia.resize(elements);
        std::vector<std::vector<Column>> columns(network_.films.size());
        for_each_job(static_cast<int>(network_.films.size()), [&](int k) {
            const Film<D>& f = film(k);
            const FilmMesh<D>& mesh = f.mesh;
            if (!f.here)
                return;
            for (std::size_t number = 0; number < mesh.elements.size(); ++number) {
                const FilmElement<D>& e = mesh.elements[number];
                const NormalRows<D> normal = normal_rows<D>(mesh, e, coupling_.solids);
                const Twist<D> across = wrench<D>(e.normal, e.centroid - centre(mesh.master));
                for (int i = 0; i < D; ++i) {
                    const double lean = e.gradient[i].dot(e.lean);
                    rows_.add_node(f.first_node + e.nodes[i], mesh.master,
                                   e.volume * wrench<D>(e.gradient[i], e.centroid - centre(mesh.master)) +
                                       lean * (normal.master - across));
                    rows_.add_node(f.first_node + e.nodes[i], mesh.other, lean * normal.other);
                }
                coupling_.normal_inertia[first[k] + number] = {mesh.master, mesh.other, normal.master, normal.other,
                                                               coupling_.density * e.volume};
                if (!coupling_.element_drag.empty())
                    add_entrainment(f, e);
            }
            columns[k] = stiffness(f);
        });
        Eigen::SparseMatrix<double>& matrix = coupling_.system.film;
        long nodes = 0;
        for (const std::vector<Column>& of_film : columns)
            nodes += static_cast<long>(of_film.size());
        matrix.resize(network_.nodes, network_.nodes);
        matrix.reserve((D == 2 ? 3 : 8) * nodes);
        for (std::size_t k = 0; k < columns.size(); ++k)
            for (std::size_t j = 0; j < network_.films[k].mesh.h.size(); ++j) {
                const int film_begin = network_.films[k].first_node, column = film_begin + static_cast<int>(j);
                matrix.startVec(column);
                if (!columns[k].empty())
                    for (const auto& [i, value] : columns[k][j])
                        matrix.insertBack(film_begin + i, column) = value;
            }
        matrix.finalize();
    }

    // Method, "Films of viscous fluid": the flux that both walls drag along, - theta int h U_w . grad N_i.
    void add_entrainment(const Film<D>& f, const FilmElement<D>& e)
    {
        const FilmMesh<D>& mesh = f.mesh;
        const Drag& drag = coupling_.element_drag[f.first_element + (&e - mesh.elements.data())];
        for (int i = 0; i < D; ++i) {
            const WallRows<D> rows = wall_rows<D>(coupling_, mesh, e, -drag.theta * e.volume * e.gradient[i], drag.wet);
            rows_.add_node(f.first_node + e.nodes[i], mesh.master, rows.master);
            rows_.add_node(f.first_node + e.nodes[i], mesh.other, rows.other);
        }
    }

    using Column = InlineVector<std::pair<int, double>, D == 2 ? 3 : 8>; // entries by the film's nodes, in their order

    // The columns of a film's nodes, which are connected to each other only.
    std::vector<Column> stiffness(const Film<D>& f) const
    {
        const FilmMesh<D>& mesh = f.mesh;
        const int n = static_cast<int>(mesh.h.size());
        std::vector<int> first(n + 1, 0); // elements around each node
        for (const FilmElement<D>& e : mesh.elements)
            for (int node : e.nodes)
                ++first[node + 1];
        for (int i = 0; i < n; ++i)
            first[i + 1] += first[i];
        std::vector<int> around(first[n]), next(first.begin(), first.end() - 1);
        for (int k = 0; k < static_cast<int>(mesh.elements.size()); ++k)
            for (int node : mesh.elements[k].nodes)
                around[next[node]++] = k;
        std::vector<Column> columns(n);
        for (int j = 0; j < n; ++j) {
            Column& column = columns[j];
            for (int at = first[j]; at < first[j + 1]; ++at) {
                const FilmElement<D>& e = mesh.elements[around[at]];
                const int mine = static_cast<int>(std::find(e.nodes.begin(), e.nodes.end(), j) - e.nodes.begin());
                for (int i = 0; i < D; ++i) {
                    const double value =
                        film_conductance(coupling_, f, around[at]) / coupling_.density * e.gradient[i].dot(e.gradient[mine]);
                    const auto known =
                        std::find_if(column.begin(), column.end(), [&](const auto& c) { return c.first == e.nodes[i]; });
                    if (known == column.end())
                        column.push_back({e.nodes[i], value});
                    else
                        known->second += value;
                }
            }
            std::sort(column.begin(), column.end());
        }
        return columns;
    }

    // From outside film k a closed face is part of the film's master.
    void assemble_closed_faces()
    {
        const auto is_needed = [&](long key) {
            const FilmCell<D>* cell = network_.cells.cells.find(key);
            return cell && cell->kind == CellKind::film ? assembled_[cell->owner] != 0 : grid_.owns(grid_.cell_of_key(key));
        };
        const std::vector<ClosedFace<D>> faces = closed_faces(grid_, network_, is_needed);
        closed_flux_.reserve(faces.size());
        closed_of_.reserve(faces.size());
        for (const auto& [k, face, offset] : faces) {
            const int master = film(k).mesh.master, number = static_cast<int>(closed_flux_.size());
            closed_flux_.push_back({{master, wrench<D>(face.area, face.x - centre(master)),
                                     centre(master) - grid_.dx() * offset.template cast<double>()},
                                    -1});
            const auto [list, is_new] = closed_of_.insert(face.key, {number, number});
            if (!is_new)
                list.last = closed_flux_[list.last].next = number;
        }
    }

    struct CellFlux {
        int solid;
        Twist<D> flux; ///< wrench about the solid's centre
        Vec<D> centre; ///< of the solid's image at this place
    };

    // A cell's closed faces: places in `closed_flux_`, each with the next.
    struct ClosedList {
        int first = -1, last = -1;
    };
    struct ListedFlux {
        CellFlux flux;
        int next;
    };
    template <class F>
    void for_each_closed_flux(const ClosedList& list, F&& f) const
    {
        for (int i = list.first; i >= 0; i = closed_flux_[i].next)
            f(closed_flux_[i].flux);
    }

    // Flux of each solid out of a film cell through its own clipped faces; none where all of them lie in one solid.
    InlineVector<CellFlux, 4> own_flux(const Index<D>& c) const
    {
        InlineVector<CellFlux, 4> fluxes;
        bool closed = true;
        for (int side = 0; side < 2 * D; ++side) {
            const Index<D> face = c + (side % 2) * step<D>(side / 2);
            closed = closed && faces_.open(side / 2, face) <= 0;
            const Vec<D> displacement = faces_.displacement(face);
            for (const SolidPart<D>& part : faces_.parts(side / 2, face)) {
                const Twist<D> flux =
                    wrench<D>((2 * (side % 2) - 1) * part.fraction * grid_.face_area() * unit<D>(side / 2), part.arm);
                const Vec<D> x = part.centroid + displacement;
                // Parts of one solid may belong to different images: keep them apart by the place of their centre.
                auto same = std::find_if(fluxes.begin(), fluxes.end(), [&](const CellFlux& other) {
                    return other.solid == part.solid && (x - part.arm - other.centre).norm() < grid_.dx();
                });
                if (same == fluxes.end())
                    fluxes.push_back({part.solid, flux, x - part.arm});
                else
                    same->flux += flux;
            }
        }
        if (closed && fluxes.size() == 1)
            fluxes.clear();
        return fluxes;
    }

    // The other wall's flux, shared over each point's nodes and subtracted from the container of the cell that contains
    // the closest point. The difference between a film cell's own J and its points' fluxes goes to the mouths.
    void assemble_other_walls()
    {
        const KeyMap<FilmCell<D>>& cells = network_.cells.cells;
        const std::vector<Nearest> nearest = nearest_mouths();
        std::vector<Twist<D>> remainder(cells.size(),
                                        Twist<D>::Zero()); // of film cells: own J of the other wall less what its points took
        third_ = items_of<Third>(static_cast<long>(cells.size()), [&](long i, std::vector<Third>& thirds) {
            if (const auto& item = cells.item(static_cast<int>(i)); counts(item.second, nearest[i]))
                add_own_flux(item, remainder[i], thirds);
        });
        std::vector<Twist<D>> lost(network_.films.size(), Twist<D>::Zero());
        assemble_points(remainder, lost);
        add_to_mouths(nearest, remainder, lost);
        for (int k = 0; k < static_cast<int>(network_.films.size()); ++k)
            if (!lost[k].isZero(0))
                spread(k, lost[k]);
    }

    // Whether what a film cell has left over is in a row of this rank: of its films, or of its cells through the nearest mouths.
    bool counts(const FilmCell<D>& cell, const Nearest& nearest) const
    {
        if (cell.kind != CellKind::film || !assembled_[cell.owner])
            return false;
        const auto leads_here = [&](int mouth) {
            const auto& cells = mouths_[cell.owner][mouth]->cells;
            return std::any_of(cells.begin(), cells.end(),
                               [&](const auto& entry) { return grid_.owns(grid_.cell_of_key(entry.first)); });
        };
        return film(cell.owner).here || std::any_of(nearest.begin(), nearest.end(), leads_here);
    }

    // What solids' own surfaces give a film cell: the other wall's flux to `remainder`, third bodies' to `thirds`.
    void add_own_flux(const typename KeyMap<FilmCell<D>>::Item& item, Twist<D>& remainder, std::vector<Third>& thirds) const
    {
        const auto& [key, cell] = item;
        const FilmMesh<D>& mesh = film(cell.owner).mesh;
        const Vec<D> here = grid_.dx() * cell.offset(cell.owner).template cast<double>();
        for (const CellFlux& flux : own_flux(grid_.cell_of_key(key)))
            add_in_film_cell_of(key, mesh, flux, here, remainder, thirds);
        if (const ClosedList* closed = closed_of_.find(key))
            for_each_closed_flux(*closed,
                                 [&](const CellFlux& flux) { add_in_film_cell_of(key, mesh, flux, here, remainder, thirds); });
    }

    // Flux of a film's point that leaves for a cell of the grid or for another film.
    struct Leaving {
        int film;
        long key;  // of the cell
        int owner; // film of that cell, -1: of the grid
        Twist<D> flux;
    };

    // The points of each film on its own nodes and cells, films on threads. What leaves for nodes of other films comes in the films' order too.
    void assemble_points(std::vector<Twist<D>>& remainder, std::vector<Twist<D>>& lost)
    {
        const int films = static_cast<int>(network_.films.size());
        std::vector<std::vector<Leaving>> leaving(films);
        for_each_job(films, [&](int k) {
            if (assembled_[k])
                leaving[k] = leaving_points(k, remainder, lost[k]);
        });
        for (const std::vector<Leaving>& of_film : leaving)
            for (const Leaving& point : of_film)
                if (point.owner > point.film)
                    add_leaving(point);
        for_each_job(films, [&](int k) {
            const FilmMesh<D>& mesh = film(k).mesh;
            if (!film(k).here)
                return;
            for (const FilmPoint<D>& point : mesh.points)
                add_at_point(k, point, mesh.other, other_centre(mesh), other_flux(mesh, point), 1.0);
        });
        for (const std::vector<Leaving>& of_film : leaving)
            for (const Leaving& point : of_film)
                if (point.owner < point.film)
                    add_leaving(point);
    }

    // Takes the fluxes of a film's points off its own cells; returns those of points whose closest one lies elsewhere.
    std::vector<Leaving> leaving_points(int k, std::vector<Twist<D>>& remainder, Twist<D>& lost) const
    {
        const KeyMap<FilmCell<D>>& cells = network_.cells.cells;
        const FilmMesh<D>& mesh = film(k).mesh;
        std::vector<Leaving> leaving;
        for (const FilmPoint<D>& point : mesh.points) {
            const Twist<D> flux = other_flux(mesh, point);
            const Index<D> c = grid_.wrapped(grid_.cell_of(point.y + 1e-9 * grid_.dx() * point.other_normal));
            const long key = grid_.in_domain(c) ? grid_.key(c) : -1;
            const int i = cells.index(key);
            const CellKind kind = key < 0  ? CellKind::solid
                                  : i >= 0 ? cells.item(i).second.kind
                                           : kind_of(faces_, network_.cells, c);
            if (kind == CellKind::bulk || kind == CellKind::mixed)
                leaving.push_back({k, key, -1, flux});
            else if (kind == CellKind::film && cells.item(i).second.owner == k)
                remainder[i] -= flux;
            else if (kind == CellKind::film)
                leaving.push_back({k, key, cells.item(i).second.owner, flux});
            else
                lost -= flux;
        }
        return leaving;
    }

    void add_leaving(const Leaving& point)
    {
        const FilmMesh<D>& mesh = film(point.film).mesh;
        if (point.owner < 0)
            add_relative(to_cell(point.key), mesh, mesh.other, other_centre(mesh), point.flux, -1.0);
        else if (film(point.owner).here)
            add_in_film_cell(*network_.cells.cells.find(point.key), point.film, grid_.cell_of_key(point.key), point.flux, -1.0);
    }

    // Over all mouths of a film; without any over its points.
    void spread(int k, const Twist<D>& flux)
    {
        const FilmMesh<D>& mesh = film(k).mesh;
        double total = 0;
        for (const Mouth<D>* mouth : mouths_[k])
            total += mouth->length;
        for (const Mouth<D>* mouth : mouths_[k])
            for (const auto& [key, weight] : mouth->cells)
                add_relative(to_cell(key), mesh, mesh.other, other_centre(mesh), flux, mouth->length / total * weight);
        if (mouths_[k].empty())
            for (const FilmPoint<D>& point : mesh.points)
                add_at_point(k, point, mesh.other, other_centre(mesh), flux, 1.0 / static_cast<double>(mesh.points.size()));
    }

    /// Those of n items whose distance is the least, but for round-off.
    template <class Distance>
    static Nearest nearest_of(std::size_t n, Distance&& distance)
    {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < n; ++i)
            least = std::min(least, distance(i));
        Nearest nearest;
        for (std::size_t i = 0; i < n; ++i)
            if (distance(i) <= (1 + equally_near) * least)
                nearest.push_back(static_cast<int>(i));
        return nearest;
    }

    // Of each film cell the nearest of its film's mouths.
    std::vector<Nearest> nearest_mouths() const
    {
        const KeyMap<FilmCell<D>>& cells = network_.cells.cells;
        std::vector<Nearest> nearest(cells.size());
        for_each_part(static_cast<long>(cells.size()), [&](long begin, long end) {
            for (long k = begin; k < end; ++k) {
                const auto& [key, cell] = cells.item(static_cast<int>(k));
                if (cell.kind != CellKind::film || !assembled_[cell.owner])
                    continue;
                const Vec<D> x = grid_.cell_centre(grid_.cell_of_key(key) + cell.offset(cell.owner));
                const std::vector<Vec<D>>& places = mouth_places_[cell.owner];
                nearest[k] = nearest_of(places.size(), [&](std::size_t i) { return (places[i] - x).squaredNorm(); });
            }
        });
        return nearest;
    }

    // A film cell's remainder leaves through the nearest mouths of its film (spread over all mouths it would short-circuit
    // pockets that several films enclose); without mouths it is spread over the film.
    void add_to_mouths(const std::vector<Nearest>& nearest, const std::vector<Twist<D>>& remainder, std::vector<Twist<D>>& lost)
    {
        const KeyMap<FilmCell<D>>& cells = network_.cells.cells;
        std::vector<std::vector<Twist<D>>> through(mouths_.size()); // of each film, its mouths
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const FilmCell<D>& cell = cells.item(static_cast<int>(i)).second;
            if (!counts(cell, nearest[i]))
                continue;
            if (nearest[i].empty())
                lost[cell.owner] += remainder[i];
            through[cell.owner].resize(mouths_[cell.owner].size(), Twist<D>::Zero());
            for (int mouth : nearest[i])
                through[cell.owner][mouth] += remainder[i] / static_cast<double>(nearest[i].size());
        }
        for (std::size_t k = 0; k < through.size(); ++k) {
            const FilmMesh<D>& mesh = film(static_cast<int>(k)).mesh;
            for (std::size_t mouth = 0; mouth < through[k].size(); ++mouth)
                if (!through[k][mouth].isZero(0))
                    for (const auto& [to, weight] : mouths_[k][mouth]->cells)
                        add_relative(to_cell(to), mesh, mesh.other, other_centre(mesh), through[k][mouth], weight);
        }
    }

    // Flux of a solid out of a film cell: the other wall's into `rest`, the master's vanishes, third bodies' for later.
    void add_in_film_cell_of(long key, const FilmMesh<D>& mesh, const CellFlux& flux, const Vec<D>& here, Twist<D>& rest,
                             std::vector<Third>& thirds) const
    {
        const double half = 0.5 * grid_.size().minCoeff();
        if (flux.solid == mesh.other &&
            (coupling_.solids[flux.solid].wall || (flux.centre + here - other_centre(mesh)).norm() < half))
            rest += flux.flux;
        else if (flux.solid != mesh.master)
            thirds.push_back({key, flux.solid, flux.flux, flux.centre + here});
    }

    void add_at_point(int k, const FilmPoint<D>& point, int solid, const Vec<D>& solid_centre, const Twist<D>& flux,
                      double share)
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
        const Nearest nearest = nearest_points(cell, c);
        for (int at : nearest) {
            const FilmPoint<D>& point = owner.mesh.points[at];
            const FilmElement<D>& e = owner.mesh.elements[point.element];
            for (int i = 0; i < D; ++i)
                add_relative(to_node(owner.first_node + e.nodes[i]), mesh, mesh.other, other_centre(mesh), flux,
                             share / static_cast<double>(nearest.size()) * point.shape[i]);
        }
    }

    Nearest nearest_points(const FilmCell<D>& cell, const Index<D>& c) const
    {
        const Vec<D> x = grid_.cell_centre(c + cell.offset(cell.owner));
        const std::vector<FilmPoint<D>>& points = film(cell.owner).mesh.points;
        return nearest_of(points.size(), [&](std::size_t i) { return (0.5 * (points[i].x + points[i].y) - x).squaredNorm(); });
    }

    // A third body's flux in a film cell goes to the nearest point's nodes, relative to the master.
    void assemble_third_bodies()
    {
        std::erase_if(third_, [&](const Third& third) {
            return !film(network_.cells.cells.find(third.key)->owner).here ||
                   third.flux.template head<D>().norm() <= 1e-14 * grid_.face_area();
        });
        std::vector<Nearest> nearest(third_.size());
        for_each_part(static_cast<long>(third_.size()), [&](long begin, long end) {
            for (long i = begin; i < end; ++i)
                nearest[i] = nearest_points(*network_.cells.cells.find(third_[i].key), grid_.cell_of_key(third_[i].key));
        });
        for (std::size_t i = 0; i < third_.size(); ++i) {
            const int owner = network_.cells.cells.find(third_[i].key)->owner;
            for (int point : nearest[i])
                add_at_point(owner, film(owner).mesh.points[point], third_[i].solid, third_[i].centre, third_[i].flux,
                             1.0 / static_cast<double>(nearest[i].size()));
        }
        for (const auto& entry : closed_of_) // bulk and mixed cells beside closed faces
            if (const long key = entry.first; network_.cells.kind(key, CellKind::bulk) != CellKind::film)
                for_each_closed_flux(entry.second, [&](const CellFlux& flux) { rows_.add_cell(key, flux.solid, flux.flux); });
    }

    // Method, "Mouths and joints": q = (p_film - p_bulk) length / (rho R) + q*; length h nu . U_m moves with the master.
    void assemble_mouths()
    {
        std::vector<Link>& links = coupling_.system.links;
        links.clear();
        coupling_.cells_behind.assign(network_.rim.mouths.size(), {});
        for (const Mouth<D>& mouth : network_.rim.mouths) {
            // For the grid the faces that a film closes move with its master. The flux that both walls drag along in viscous fluid replaces
            // the master's face by face: distributed by the pressure's stencil, from cell to cell in a gap of a cell, it would drag the walls.
            if (D == 2 && mouth.kind == MouthKind::smooth && !coupling_.mouth_drag.empty())
                coupling_.cells_behind[links.size()] =
                    cells_behind<D>(mouth, film(mouth.film), closed_areas_[mouth.film], mouth_places_[mouth.film], grid_.dx());
            Link link{mouth.length / (coupling_.density * mouth.resistance), {}, {}};
            if (mouth.kind == MouthKind::inflow)
                link.conductance = 0;
            if (!coupling_.mouth_drag.empty())
                link.conductance *= coupling_.mouth_drag[links.size()].kappa;
            for (int i = 0; i < D - 1; ++i)
                link.nodes.emplace_back(mouth.nodes[i], mouth.shape[i]);
            for (const auto& [key, weight] : mouth.cells)
                link.cells.emplace_back(key, -weight);
            if (assembled_[mouth.film])
                add_mouth(coupling_, links.size(), 1.0, rows_);
            links.push_back(std::move(link));
        }
        for (const Joint<D>& joint : network_.rim.joints) {
            Link link{joint.conductance / coupling_.density, {}, {}};
            for (int i = 0; i < D - 1; ++i) {
                link.nodes.emplace_back(joint.nodes_a[i], joint.shape_a[i]);
                link.nodes.emplace_back(joint.nodes_b[i], -joint.shape_b[i]);
            }
            links.push_back(std::move(link));
        }
    }

    Coupling<D>& coupling_;
    FluxRows<D>& rows_;
    const Grid<D>& grid_;
    const FilmNetwork<D>& network_;
    const FaceCache<D>& faces_;
    std::vector<char> assembled_;                      ///< whether this rank assembles each film
    std::vector<std::vector<const Mouth<D>*>> mouths_; ///< of each film, those that end in cells
    std::vector<std::vector<Vec<D>>> mouth_places_;    ///< where they are
    std::vector<ListedFlux> closed_flux_;              ///< of masters, out of cells beside closed faces
    KeyMap<ClosedList> closed_of_;
    std::vector<std::vector<ClosedArea<D>>> closed_areas_; ///< of each film
    std::vector<Third> third_;
};

} // namespace

// The flux that both walls drag along, theta length h nu . U_w, leaves the film, with their velocities at mid-gap; the master's own flux does not.
// With cells behind the mouth all of length h nu . U_w goes there, and the share 1 - theta of it in the mouth's flux is not distributed by the stencil.
template <int D>
void append_rows(Coupling<D>& coupling, const FluxRows<D>& rows, std::vector<BodyFlux<D, int>>& free_nodes)
{
    const Grid<D>& grid = *coupling.grid;
    append_entries<D, Index<D>>(
        static_cast<long>(rows.cells.size()),
        [&](long i, FluxEntries<D, Index<D>>& entries) {
            const auto& [key, fluxes] = rows.cells.item(static_cast<int>(i));
            for (const auto& [solid, flux] : fluxes)
                entries.add(coupling, grid.cell_of_key(key), solid, flux);
        },
        coupling.cell_flux, coupling.system.cell_flux);
    append_entries<D, int>(
        static_cast<long>(rows.nodes.size()),
        [&](long node, FluxEntries<D, int>& entries) {
            for (const auto& [solid, flux] : rows.nodes[node])
                entries.add(coupling, static_cast<int>(node), solid, flux);
        },
        coupling.node_flux, free_nodes);
}

template <int D>
void add_mouth(const Coupling<D>& coupling, std::size_t r, double share, FluxRows<D>& rows)
{
    const Mouth<D>& mouth = coupling.network.rim.mouths[r];
    const Film<D>& film = coupling.network.films[mouth.film];
    const FilmMesh<D>& mesh = film.mesh;
    const std::vector<CarriedCell>& behind = coupling.cells_behind[r];
    const Vec<D> flux = share * mouth.length * mouth.section;
    const Vec<D> other_centre = coupling.solids[mesh.other].centre + mesh.shift;
    const Vec<D> at_master = mouth.x - coupling.solids[mesh.master].centre, at_other = mouth.x - other_centre;
    if (!coupling.mouth_drag.empty()) {
        const Drag& drag = coupling.mouth_drag[r];
        const Twist<D> of_master = (1 - 0.5 * drag.wet) * wrench<D>(flux, at_master);
        const Twist<D> of_other = 0.5 * drag.wet * wrench<D>(flux, at_other);
        for (int i = 0; i < D - 1; ++i) {
            rows.add_node(mouth.nodes[i], mesh.master, drag.theta * mouth.shape[i] * of_master);
            rows.add_node(mouth.nodes[i], mesh.other, drag.theta * mouth.shape[i] * of_other);
        }
        const auto add = [&](const CarriedCell& cell, double part) {
            rows.add_cell(cell.key, mesh.master, part * (cell.weight + cell.lean) * of_master);
            rows.add_cell(cell.key, mesh.other, part * (cell.weight - cell.lean) * of_other);
        };
        if (behind.empty())
            for (const CarriedCell& cell : cells_around(*coupling.grid, mouth, film))
                add(cell, -drag.theta);
        for (const CarriedCell& cell : behind)
            add(cell, -1);
        if (!behind.empty())
            for (const auto& [key, weight] : mouth.cells)
                add({key, weight, 0.0}, 1 - drag.theta);
    }
    const Twist<D> carried = share * mouth.length * wrench<D>(mouth.section, at_master);
    for (int i = 0; i < D - 1; ++i)
        rows.add_node(mouth.nodes[i], mesh.master, -mouth.shape[i] * carried);
    if (behind.empty())
        for (const auto& [key, weight] : mouth.cells)
            rows.add_cell(key, mesh.master, weight * carried);
    for (const CarriedCell& cell : behind)
        rows.add_cell(cell.key, mesh.master, cell.weight * carried);
}

template <int D>
void assemble_films(Coupling<D>& coupling, FluxRows<D>& rows)
{
    FilmAssembler<D>(coupling, rows).assemble();
}

template void add_mouth<2>(const Coupling<2>&, std::size_t, double, FluxRows<2>&);
template void add_mouth<3>(const Coupling<3>&, std::size_t, double, FluxRows<3>&);
template void assemble_films<2>(Coupling<2>&, FluxRows<2>&);
template void assemble_films<3>(Coupling<3>&, FluxRows<3>&);

template void append_rows<2>(Coupling<2>&, const FluxRows<2>&, std::vector<BodyFlux<2, int>>&);
template void append_rows<3>(Coupling<3>&, const FluxRows<3>&, std::vector<BodyFlux<3, int>>&);

} // namespace gapflow
