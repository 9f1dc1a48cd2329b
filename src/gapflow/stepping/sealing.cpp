#include "gapflow/stepping/sealing.hpp"

#include "gapflow/core/decompositions.hpp"
#include "gapflow/core/disjoint_sets.hpp"
#include "gapflow/core/sharing.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/coupling/fluid_parts.hpp"
#include "gapflow/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

namespace gapflow {

namespace {

constexpr double rough = 0.01;           // in cells: a floor of a film that counts as a way out
constexpr double flush_within = 1.05;    // of the floor, or of the distance at which a contact holds
constexpr double thickness_error = 1e-7; // in cells, of thicknesses
constexpr double no_flux = 1e-2;         // of the fluxes around it: changes of a pocket's volume that are errors of its surface
constexpr double parting = 1e-4;   // of the largest speed: a ball held in its seat spins at the level of the solver's tolerance
constexpr double immovable = 5e-3; // of a pocket's surface: parts of a moving body below this count as immovable
constexpr std::size_t most_bodies = 150; // connected around a pocket; with more the check is omitted

// Calls f(side, cell, face) for this rank's faces of inflow sides; side = 2 * axis + end.
template <int D, class F>
void for_each_inflow_face(const Grid<D>& grid, F&& f)
{
    for (int side = 0; side < 2 * D; ++side) {
        const int axis = side / 2, end = side % 2, last = end * (grid.cells()[axis] - 1);
        if (grid.side(axis, end) != SideKind::inflow || last < grid.low()[axis] || last >= grid.high()[axis])
            continue;
        Index<D> low = grid.low(), high = grid.high();
        low[axis] = last;
        high[axis] = last + 1;
        for_each_index<D>(low, high, [&](const Index<D>& c) { f(side, c, Index<D>(c + end * step<D>(axis))); });
    }
}

// The largest normal speed at inflow sides.
template <int D>
double speed_of_inflows(const Grid<D>& grid, const FluidVelocity<D>& u)
{
    double fastest = 0;
    for_each_inflow_face(grid, [&](int side, const Index<D>&, const Index<D>& f) {
        fastest = std::max(fastest, std::abs(u.grid(side / 2, f)));
    });
    return grid.comm().max(fastest);
}

// Film nodes where the surfaces touch and do not part, and the pairs that do.
template <int D>
std::vector<char> shut_nodes(const Coupling<D>& coupling, const TouchingGaps<D>& touching, const std::vector<Twist<D>>& V,
                             std::set<std::pair<int, int>>& pairs)
{
    std::vector<char> shut(coupling.system.nodes, 0);
    for (const Film<D>& film : coupling.network.films) {
        const FilmMesh<D>& mesh = film.mesh;
        const double most = touching.thickest(mesh.master, mesh.other);
        if (most < 0)
            continue;
        std::vector<char> parts(mesh.h.size(), 0);
        std::vector<double> slope(mesh.h.size(),
                                  1.0); // at an edge h is along the normal of the face beside it: the surfaces are nearer
        for (const FilmElement<D>& e : mesh.elements) {
            const Vec<D> of_master = velocity_at<D>(V[mesh.master], e.centroid - coupling.solids[mesh.master].centre);
            const Vec<D> of_other = velocity_at<D>(V[mesh.other], e.centroid - coupling.solids[mesh.other].centre - mesh.shift);
            const double half = std::clamp(e.normal.dot(e.into_other), 0.0, 1.0);
            for (int node : e.nodes) {
                parts[node] = parts[node] || touching.part(e.normal.dot(of_other - of_master));
                slope[node] = std::min(slope[node], std::max(2 * half * half - 1, -facing_cosine));
            }
        }
        for (std::size_t i = 0; i < mesh.h.size(); ++i)
            if (!parts[i] && slope[i] * (mesh.h[i] + mesh.skin) <= most) {
                shut[film.first_node + static_cast<int>(i)] = 1;
                pairs.insert({mesh.master, mesh.other});
            }
    }
    return shut;
}

// Fluxes into the pockets: of every part, from every solid and side, and the sums of magnitudes.
template <int D>
class Balance {
public:
    Balance(const Coupling<D>& coupling, const FluidParts<D>& parts, const std::vector<Twist<D>>& twists,
            const FluidVelocity<D>& u)
        : coupling_(coupling), causes_(static_cast<int>(coupling.solids.size()) + 2 * D),
          count_(static_cast<int>(parts.components.size()))
    {
        const Grid<D>& grid = *coupling.grid;
        driven = magnitude = Eigen::MatrixXd::Zero(causes_, count_);
        auto add = [&](int cause, int part, double flux) {
            if (part < 0)
                return;
            driven(cause, part) += flux;
            magnitude(cause, part) += std::abs(flux);
        };
        for (const auto& entry : coupling.cell_flux)
            add(entry.body, parts.component(entry.row), entry.flux.dot(twists[entry.body]));
        for_each_inflow_face(grid, [&](int of, const Index<D>& c, const Index<D>& f) {
            const int axis = of / 2, end = of % 2;
            add(side(of), parts.component(c), (2 * end - 1) * coupling.open(axis, f) * grid.face_area() * u.grid(axis, f));
        });
        for (const auto& entry : coupling.node_flux)
            add(entry.body, parts.node_component[entry.row], entry.flux.dot(twists[entry.body]));
        grid.comm().sum(std::span<double>(driven.data(), static_cast<std::size_t>(driven.size())));
        grid.comm().sum(std::span<double>(magnitude.data(), static_cast<std::size_t>(magnitude.size())));
    }

    int side(int s) const { return static_cast<int>(coupling_.solids.size()) + s; }

    Eigen::MatrixXd driven, magnitude; ///< causes (solids, then sides) x parts

private:
    const Coupling<D>& coupling_;
    int causes_, count_;
};

// The parts' constants as forces on the free bodies, K^T 1_k, torques over the body's size; and the area of each part on them.
template <int D>
Eigen::MatrixXd forces_of(const Coupling<D>& coupling, const FluidParts<D>& parts, Eigen::VectorXd& area)
{
    constexpr int n = twist_size<D>;
    const int count = static_cast<int>(parts.components.size()), dofs = n * coupling.system.bodies;
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(dofs + 1, count);
    auto add = [&](int part, int solid, const Twist<D>& flux) {
        const int b = coupling.free_body[solid];
        if (part < 0 || b < 0)
            return;
        sums.col(part).template segment<n>(n * b) += coupling.solids[solid].admissible * flux;
        sums(dofs, part) += flux.template head<D>().norm();
    };
    for (const auto& entry : coupling.cell_flux)
        add(parts.component(entry.row), entry.body, entry.flux);
    for (const auto& entry : coupling.node_flux)
        add(parts.node_component[entry.row], entry.body, entry.flux);
    coupling.grid->comm().sum(std::span<double>(sums.data(), static_cast<std::size_t>(sums.size())));
    area = sums.row(dofs);
    return sums.topRows(dofs);
}

template <int D>
std::string names(const Coupling<D>& coupling, const std::set<std::pair<int, int>>& pairs)
{
    std::vector<std::string> list;
    for (const auto& [a, b] : pairs)
        if (list.size() < 4)
            list.push_back("'" + coupling.solids[a].name + "' and '" + coupling.solids[b].name + "'");
    if (pairs.size() > list.size())
        list.push_back(std::to_string(pairs.size() - list.size()) + " more pairs");
    return joined(list, ", ");
}

// Connected shut nodes: what their surfaces squeeze out as they close goes to the parts beside them.
struct ShutFilm {
    double flux = 0; ///< as in Balance::driven, of all solids
    std::set<int> beside;
};

template <int D>
std::vector<ShutFilm> shut_films(const Coupling<D>& coupling, const std::vector<char>& shut, const FluidParts<D>& parts,
                                 const Balance<D>& balance)
{
    const Grid<D>& grid = *coupling.grid;
    DisjointSets sets(coupling.system.nodes);
    std::vector<std::pair<int, int>> borders; // shut node, part
    const auto join = [&](const auto& nodes, const auto& number) {
        int first = -1;
        for (const auto& node : nodes)
            if (const int i = number(node); shut[i] && first < 0)
                first = i;
            else if (shut[i])
                sets.join(first, i);
        for (const auto& node : nodes)
            if (const int i = number(node); !shut[i] && first >= 0)
                borders.emplace_back(first, parts.node_component[i]);
        return first;
    };
    for (const Film<D>& film : coupling.network.films)
        for (const FilmElement<D>& e : film.mesh.elements)
            join(e.nodes, [&](int node) { return film.first_node + node; });
    for (const Link& link : coupling.system.links)
        if (const int first = join(link.nodes, [](const auto& node) { return node.first; }); first >= 0)
            for (const auto& [key, weight] : link.cells)
                if (const Index<D> c = grid.cell_of_key(key); grid.owns(c) && parts.component(c) >= 0)
                    borders.emplace_back(first, parts.component(c));
    std::map<int, ShutFilm> films;
    const auto film_of = [&](int node) -> ShutFilm& { return films[sets.find(node)]; };
    for (int node = 0; node < coupling.system.nodes; ++node)
        if (shut[node])
            film_of(node).flux += balance.driven.col(parts.node_component[node]).sum();
    for (const auto& [node, part] : all_values(grid.comm(), borders))
        film_of(node).beside.insert(part);
    std::vector<ShutFilm> list;
    for (auto& [node, film] : films)
        list.push_back(std::move(film));
    return list;
}

// Parts of the fluid with the shut nodes closed: the fluxes into them, and the bodies on which their pressure acts.
template <int D>
struct Pockets {
    /// `within`: parts in shut gaps, whose volume is the contact's condition.
    Pockets(const Coupling<D>& of, FluidParts<D> of_fluid, const std::vector<char>& within, const std::vector<Twist<D>>& twists,
            const FluidVelocity<D>& u, GivesWay who)
        : coupling(of), gives_way(who), parts(std::move(of_fluid)), balance(of, parts, twists, u),
          forces(forces_of(of, parts, area)), largest(balance.magnitude.size() > 0 ? balance.magnitude.maxCoeff() : 0.0),
          is_pocket(parts.components.size())
    {
        for (int k = 0; k < count(); ++k)
            is_pocket[k] = !parts.components[k].grounded && !within[k];
    }

    int count() const { return static_cast<int>(parts.components.size()); }
    bool moves(int k) const
    {
        return std::abs(balance.driven.col(k).sum()) > no_flux * std::max(balance.magnitude.col(k).maxCoeff(), 1e-6 * largest);
    }
    /// Whether a solid or side moves independently of the pressure.
    bool prescribed(int cause) const
    {
        return cause >= static_cast<int>(coupling.solids.size()) || coupling.free_body[cause] < 0 ||
               gives_way == GivesWay::nothing;
    }
    bool acts_on(int k, int b) const { return forces.col(k).template segment<twist_size<D>>(twist_size<D> * b).norm() > 0; }

    const Coupling<D>& coupling;
    GivesWay gives_way;
    FluidParts<D> parts;
    Balance<D> balance;
    Eigen::VectorXd area;   ///< of each part on free bodies
    Eigen::MatrixXd forces; ///< of each part on free bodies
    double largest;
    std::vector<char> is_pocket;
    std::vector<ShutFilm> films;
};

// Connected pockets and free bodies.
struct Chain {
    std::set<int> pockets, bodies;
};

// Pockets connected by bodies that can give way, starting from those on which prescribed motion or inflow acts. None if too
// many bodies are connected.
template <int D>
Chain driven_chain(const Pockets<D>& all, const std::vector<Contact<D>>& contacts)
{
    const Coupling<D>& coupling = all.coupling;
    Chain chain;
    auto& [pockets, bodies] = chain;
    for (int k = 0; k < all.count(); ++k)
        for (int cause = 0; cause < all.balance.driven.rows() && all.is_pocket[k]; ++cause)
            if (all.prescribed(cause) && std::abs(all.balance.driven(cause, k)) >
                                             no_flux * std::max(all.balance.magnitude(cause, k), 1e-6 * all.largest))
                pockets.insert(k);
    for (bool grows = !pockets.empty() && all.gives_way != GivesWay::nothing; grows;) {
        const std::size_t before = pockets.size() + bodies.size();
        for (int b = 0; b < coupling.system.bodies; ++b)
            if (std::any_of(pockets.begin(), pockets.end(), [&](int k) { return all.acts_on(k, b); }))
                bodies.insert(b);
        for (const Contact<D>& c : contacts) {
            const int a = coupling.free_body[c.point.a], b = coupling.free_body[c.point.b];
            if (c.closed && all.gives_way == GivesWay::unblocked && a >= 0 && b >= 0 &&
                (bodies.contains(a) || bodies.contains(b))) {
                bodies.insert(a);
                bodies.insert(b);
            }
        }
        for (int k = 0; k < all.count(); ++k)
            if (all.is_pocket[k] && std::any_of(bodies.begin(), bodies.end(), [&](int b) { return all.acts_on(k, b); }))
                pockets.insert(k);
        if (bodies.size() > most_bodies)
            return {};
        grows = pockets.size() + bodies.size() > before;
    }
    return chain;
}

// The bodies of a chain, torques over their sizes.
template <int D>
struct ChainBodies {
    ChainBodies(const Coupling<D>& of, const std::set<int>& bodies) : coupling(of)
    {
        for (int b : bodies) {
            place[b] = static_cast<int>(place.size());
            const auto solid = std::find(coupling.free_body.begin(), coupling.free_body.end(), b) - coupling.free_body.begin();
            const double radius = bounding_radius<D>(world_bounds(coupling.solids[solid].shape));
            size.push_back(std::isfinite(radius) ? radius : coupling.grid->size().maxCoeff());
        }
    }

    long dofs() const { return twist_size<D> * static_cast<long>(place.size()); }
    Twist<D> scaled(int b, const Twist<D>& force) const
    {
        Twist<D> result = force;
        result.template tail<spin_size<D>>() /= size[place.at(b)];
        return result;
    }

    const Coupling<D>& coupling;
    std::map<int, int> place;
    std::vector<double> size;
};

// Removes from the columns of X the part that held contacts support.
template <int D>
void take_out_contacts(const ChainBodies<D>& bodies, const std::vector<Contact<D>>& contacts, Eigen::MatrixXd& X)
{
    constexpr int n = twist_size<D>;
    const Coupling<D>& coupling = bodies.coupling;
    std::vector<Eigen::VectorXd> rows;
    for (const Contact<D>& c : contacts) {
        if (!c.closed)
            continue;
        Eigen::VectorXd row = Eigen::VectorXd::Zero(bodies.dofs());
        auto add = [&](int solid, const Twist<D>& part) {
            if (const int b = coupling.free_body[solid]; b >= 0 && bodies.place.contains(b))
                row.segment<n>(n * bodies.place.at(b)) += bodies.scaled(b, coupling.solids[solid].admissible * part);
        };
        add(c.point.a, c.normal.a);
        add(c.point.b, c.normal.b);
        if (row.norm() > 0)
            rows.push_back(row.normalized());
    }
    Eigen::MatrixXd C(bodies.dofs(), static_cast<long>(rows.size()));
    for (std::size_t r = 0; r < rows.size(); ++r)
        C.col(static_cast<long>(r)) = rows[r];
    if (C.cols() == 0)
        return;
    const SingularVectors held = left_singular_vectors(C);
    for (long j = 0; j < held.values.size(); ++j)
        if (held.values[j] > 1e-6 * held.values[0])
            X -= held.vectors.col(j) * (held.vectors.col(j).transpose() * X).eval();
}

// Combinations of the pressures of the pockets in `list` that move no body: one column each.
template <int D>
Eigen::MatrixXd idle_pressures(const Pockets<D>& all, const Chain& chain, const std::vector<int>& list,
                               const std::vector<Contact<D>>& contacts)
{
    constexpr int n = twist_size<D>;
    const ChainBodies<D> bodies(all.coupling, chain.bodies);
    const long dofs = bodies.dofs(), wide = static_cast<long>(list.size());
    Eigen::MatrixXd null = Eigen::MatrixXd::Identity(wide, wide);
    if (dofs == 0)
        return null;
    Eigen::MatrixXd X = Eigen::MatrixXd::Zero(dofs, wide);
    for (long k = 0; k < wide; ++k)
        for (int b : chain.bodies)
            if (all.area[list[k]] > 0)
                X.col(k).segment<n>(n * bodies.place.at(b)) =
                    bodies.scaled(b, all.forces.col(list[k]).template segment<n>(n * b)) / all.area[list[k]];
    if (all.gives_way == GivesWay::unblocked)
        take_out_contacts(bodies, contacts, X);
    const SingularVectors right = right_singular_vectors(X);
    long rank = 0;
    while (rank < right.values.size() && right.values[rank] > immovable)
        ++rank;
    null = right.vectors.rightCols(wide - rank);
    for (long j = 0; j < null.cols(); ++j)
        for (long k = 0; k < wide; ++k)
            null(k, j) /= all.area[list[k]] > 0 ? all.area[list[k]] : 1.0;
    return null;
}

// Where a part of the fluid lies.
template <int D>
std::string where_is(const Grid<D>& grid, const FluidParts<D>& parts, int part)
{
    long cells = 0;
    Vec<D> middle = Vec<D>::Zero();
    for_each_index<D>(grid.low(), grid.high(), [&](const Index<D>& at) {
        if (parts.component(at) == part) {
            ++cells;
            middle += grid.cell_centre(at);
        }
    });
    cells = grid.comm().sum(cells);
    grid.comm().sum(std::span<double>(middle.data(), D));
    char where[96];
    if (cells > 0 && D == 2)
        std::snprintf(where, sizeof where, "%ld cells about (%.3g, %.3g)", cells, middle[0] / cells, middle[1] / cells);
    else if (cells > 0)
        std::snprintf(where, sizeof where, "%ld cells about (%.3g, %.3g, %.3g)", cells, middle[0] / cells, middle[1] / cells,
                      middle[D - 1] / cells);
    else
        std::snprintf(where, sizeof where, "a gap");
    return where;
}

// The solids and sides that change the volume of the pockets in `list` under pressures c, and the pocket that changes most;
// empty: none.
template <int D>
std::string squeeze_by(const Pockets<D>& all, const std::vector<int>& list, const Eigen::VectorXd& c)
{
    const Balance<D>& balance = all.balance;
    const long wide = static_cast<long>(list.size());
    Eigen::VectorXd of_cause = Eigen::VectorXd::Zero(balance.driven.rows());
    double most = 0;
    for (long k = 0; k < wide; ++k) {
        of_cause += c[k] * balance.driven.col(list[k]);
        most = std::max(most, std::abs(c[k]) * balance.magnitude.col(list[k]).maxCoeff());
    }
    // Of what a film that closes squeezes out any share may go to each part beside it.
    double low = of_cause.sum(), high = low;
    for (const ShutFilm& film : all.films) {
        std::vector<double> pressures;
        for (const int part : film.beside) {
            const auto at = std::find(list.begin(), list.end(), part);
            pressures.push_back(at == list.end() ? 0.0 : c[at - list.begin()] * film.flux);
        }
        if (pressures.empty())
            continue;
        const auto [least, largest] = std::minmax_element(pressures.begin(), pressures.end());
        low += *least;
        high += *largest;
    }
    if (!(low > no_flux * most || high < -no_flux * most) || !(most > 0))
        return {};
    long k = 0; // the pocket with the largest change
    for (long i = 0; i < wide; ++i)
        if (std::abs(c[i] * balance.driven.col(list[i]).sum()) > std::abs(c[k] * balance.driven.col(list[k]).sum()))
            k = i;
    if (!all.moves(list[k]))
        return {};
    const std::vector<Solid<D>>& solids = all.coupling.solids;
    const int count = static_cast<int>(solids.size());
    std::vector<std::string> causes;
    for (int cause = 0; cause < of_cause.size(); ++cause)
        if (all.prescribed(cause) && std::abs(of_cause[cause]) > no_flux * of_cause.cwiseAbs().maxCoeff())
            causes.push_back(cause < count ? "the motion of '" + solids[cause].name + "'"
                                           : "the inflow at " + side_names[cause - count]);
    return joined(causes, " and ") + " changes the volume of fluid sealed in (" +
           where_is(*all.coupling.grid, all.parts, list[k]) + ")";
}

template <int D>
std::string squeezed_among(const Pockets<D>& all, const std::vector<Contact<D>>& contacts,
                           const std::set<std::pair<int, int>>& pairs)
{
    const Chain chain = driven_chain(all, contacts);
    if (chain.pockets.empty())
        return {};
    const std::vector<int> list(chain.pockets.begin(), chain.pockets.end());
    const Eigen::MatrixXd idle = idle_pressures(all, chain, list, contacts);
    for (long j = 0; j < idle.cols(); ++j)
        if (const std::string squeeze = squeeze_by<D>(all, list, idle.col(j)); !squeeze.empty())
            return squeeze + ", which has no way out where " + names(all.coupling, pairs) +
                   " touch; open a side, correct the motion or the inflow, or leave a gap";
    return {};
}

} // namespace

template <int D>
TouchingGaps<D>::TouchingGaps(const Coupling<D>& coupling, std::function<GapSettings(int, int)> gaps,
                              const std::vector<Contact<D>>& contacts, const std::vector<Twist<D>>& twists,
                              const FluidVelocity<D>& u)
    : gaps_(std::move(gaps)), fastest_(speed_of_inflows(*coupling.grid, u)), dx_(coupling.grid->dx())
{
    for (const Twist<D>& twist : twists)
        fastest_ = std::max(fastest_, twist.template head<D>().norm());
    for (const Contact<D>& c : contacts)
        if (c.closed && c.point.distance <= std::max(c.hold, rough * dx_)) // others are still about to close
            held_[std::minmax(c.point.a, c.point.b)] = std::max(held_[std::minmax(c.point.a, c.point.b)], c.point.distance);
}

template <int D>
double TouchingGaps<D>::thickest(int a, int b) const
{
    const double floor = gaps_(a, b).floor;
    if (floor >= rough * dx_)
        return -1;
    const auto contact = held_.find(std::minmax(a, b));
    return flush_within * (contact == held_.end() ? floor : std::max(floor, contact->second)) + thickness_error * dx_;
}

template <int D>
bool TouchingGaps<D>::part(double speed) const
{
    return speed > parting * fastest_;
}

template <int D>
std::string squeezed_pocket(const Coupling<D>& coupling, const std::function<GapSettings(int, int)>& gaps,
                            const std::vector<Contact<D>>& contacts, const std::vector<Twist<D>>& twists,
                            const FluidVelocity<D>& u, GivesWay gives_way)
{
    if (!anything_prescribed(coupling, twists, gives_way))
        return {};
    std::set<std::pair<int, int>> pairs;
    const std::vector<char> shut = shut_nodes(coupling, TouchingGaps<D>(coupling, gaps, contacts, twists, u), twists, pairs);
    if (pairs.empty())
        return {};
    FluidParts<D> parts = find_parts(coupling, shut);
    std::vector<char> within(parts.components.size(), 0);
    for (int node = 0; node < coupling.system.nodes; ++node)
        if (shut[node])
            within[parts.node_component[node]] = 1;
    Pockets<D> all(coupling, std::move(parts), within, twists, u, gives_way);
    all.films = shut_films(coupling, shut, all.parts, all.balance);
    return squeezed_among(all, contacts, pairs);
}

template <int D>
std::string squeezed_pocket(const Coupling<D>& coupling, const std::vector<char>& within,
                            const std::set<std::pair<int, int>>& pairs, const std::vector<Contact<D>>& contacts,
                            const std::vector<Twist<D>>& twists, const FluidVelocity<D>& u, GivesWay gives_way)
{
    return squeezed_among(Pockets<D>(coupling, find_parts(coupling, {}), within, twists, u, gives_way), contacts, pairs);
}

template <int D>
bool anything_prescribed(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, GivesWay gives_way)
{
    bool any = false;
    for (std::size_t s = 0; s < coupling.solids.size(); ++s)
        any = any || (coupling.solids[s].motion == Motion::prescribed && !twists[s].isZero(0)) ||
              (gives_way == GivesWay::nothing && !coupling.solids[s].wall && !twists[s].isZero(0));
    for (int s = 0; s < 2 * D; ++s)
        any = any || coupling.grid->side(s / 2, s % 2) == SideKind::inflow;
    return any;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::string squeezed_pocket<D>(const Coupling<D>&, const std::function<GapSettings(int, int)>&,                   \
                                            const std::vector<Contact<D>>&, const std::vector<Twist<D>>&,                      \
                                            const FluidVelocity<D>&, GivesWay);                                                \
    template std::string squeezed_pocket<D>(const Coupling<D>&, const std::vector<char>&,                                      \
                                            const std::set<std::pair<int, int>>&, const std::vector<Contact<D>>&,              \
                                            const std::vector<Twist<D>>&, const FluidVelocity<D>&, GivesWay);                  \
    template bool anything_prescribed<D>(const Coupling<D>&, const std::vector<Twist<D>>&, GivesWay);                          \
    template class TouchingGaps<D>;
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
