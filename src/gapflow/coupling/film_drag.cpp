#include "gapflow/coupling/film_drag.hpp"

#include "gapflow/core/decompositions.hpp"
#include "gapflow/coupling/film_way.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gapflow {

namespace {

// Of the cosine of the film's slant in its resistance.
constexpr double slant_power = 5.8;

// An orthonormal basis of the element's tangent plane.
template <int D>
std::array<Vec<D>, D - 1> tangents(const Vec<D>& normal)
{
    if constexpr (D == 2) {
        return {Vec<2>(-normal[1], normal[0])};
    } else {
        const Vec<3> t = normal.unitOrthogonal();
        return {t, normal.cross(t)};
    }
}

// int 1/h^3 of every element: exact for h linear between its nodes (a triangle: A / (h0 h1 h2), a segment: l (h0 + h1) / (2 h0^2
// h1^2)), times a factor for the true thickness at its points. A single point, in the middle of a parabola, has (D + 1) / D times
// the parabola's mean.
template <int D>
std::vector<double> cubic_integrals(const FilmMesh<D>& mesh)
{
    std::vector<double> weight(mesh.elements.size(), 0.0), ratio(mesh.elements.size(), 0.0);
    std::vector<int> points(mesh.elements.size(), 0);
    for (const FilmPoint<D>& point : mesh.points) {
        double linear = 0;
        for (int i = 0; i < D; ++i)
            linear += point.shape[i] * mesh.h[mesh.elements[point.element].nodes[i]];
        weight[point.element] += point.weight;
        ratio[point.element] += point.weight * std::pow(linear / point.h, 3);
        ++points[point.element];
    }
    std::vector<double> integrals;
    for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
        const FilmElement<D>& e = mesh.elements[k];
        std::array<double, D> h;
        for (int i = 0; i < D; ++i)
            h[i] = mesh.h[e.nodes[i]];
        double linear;
        if constexpr (D == 2)
            linear = e.measure * (h[0] + h[1]) / (2 * h[0] * h[0] * h[1] * h[1]);
        else
            linear = e.measure / (h[0] * h[1] * h[2]);
        double bulge = weight[k] > 0 ? ratio[k] / weight[k] - 1 : 0.0;
        if (points[k] == 1)
            bulge *= static_cast<double>(D) / (D + 1);
        integrals.push_back((1 + bulge) * linear);
    }
    return integrals;
}

// Cosine of the angle between the film and the line along which its thickness is measured, from the master to the other: the gap across the
// film is h cos.
template <int D>
double slant(const FilmElement<D>& e)
{
    const Vec<D> across = e.centroid_other - e.centroid_master;
    const double h = e.volume / e.measure, length = across.norm();
    return length > 1e-3 * h ? std::clamp(across.dot(e.normal) / length, 0.5, 1.0) : 1.0;
}

// Tangential part of the same distance over its normal part: the tangent of the angle between the walls and the film.
template <int D>
Vec<D> tilt(const FilmElement<D>& e)
{
    const Vec<D> across = e.centroid_other - e.centroid_master;
    const double h = e.volume / e.measure, normal = across.dot(e.normal);
    if (normal <= 1e-3 * h)
        return Vec<D>::Zero();
    const Vec<D> g = (across - normal * e.normal) / normal;
    return g / std::max(1.0, g.norm());
}

// Derivative along t of the distance's part along the film: the other wall's length over the master's minus 1, times t.
template <int D>
Vec<D> widening(const FilmMesh<D>& mesh, const FilmElement<D>& e, const Vec<D>& t)
{
    constexpr double largest = 0.3; // where closest points accumulate at an edge
    Vec<D> change = Vec<D>::Zero();
    for (int i = 0; i < D; ++i)
        change += e.gradient[i].dot(t) * (mesh.y[e.nodes[i]] - mesh.x[e.nodes[i]]);
    change -= change.dot(e.normal) * e.normal;
    const double length = change.norm(), most = largest * t.norm();
    return length > most ? Vec<D>(most / length * change) : change;
}

double mouth_beta(MouthKind kind, double viscosity_dt, double density, double h, double resistance)
{
    const double scale = viscosity_dt / (density * h * h);
    return kind == MouthKind::edge_edge || kind == MouthKind::edge_face ? 16 * scale / (std::numbers::pi * resistance)
                                                                        : 12 * scale;
}

// A film is impermeable where its effective mass under viscosity exceeds this multiple of that of the lighter free body beside it: under
// any force that body moves by less than 1e-10 of its motion alone. Beyond this ratio the sum of the film's pressure force and the body's inertia
// is lost in round-off (a box on a floor; method, "Films of viscous fluid").
constexpr double heaviest_film = 1e10;

Drag drag_of(double beta, double most)
{
    beta = std::min(beta, most);
    Drag drag;
    drag.kappa = 1 / (1 + beta);
    drag.theta = beta * drag.kappa;
    return drag;
}

// The largest beta of a film's elements and mouths, where it becomes impermeable. A wall that closes with unit speed drives at most the flux s
// through a place at the distance s from the film's thinnest point; its effective mass is (inertance) s^2 / kappa.
template <int D>
struct Shut {
    double mass = std::numeric_limits<double>::infinity(); ///< of the lighter body that moves freely
    double section = 0;                                    ///< of that body at most
    Vec<D> thinnest;
    double dx;

    Shut(const Coupling<D>& coupling, const FilmMesh<D>& mesh, const std::vector<TwistMatrix<D>>& masses)
        : dx(coupling.grid->dx())
    {
        for (int solid : {mesh.master, mesh.other})
            if (coupling.solids[solid].motion == Motion::free) {
                mass = std::min(mass, masses[solid](0, 0));
                section =
                    std::max(section, std::pow(2 * bounding_radius<D>(world_bounds(coupling.solids[solid].shape)), D - 1));
            }
        const auto thickness = [](const FilmElement<D>& e) { return e.volume / e.measure; };
        const auto least = std::min_element(mesh.elements.begin(), mesh.elements.end(),
                                            [&](const auto& a, const auto& b) { return thickness(a) < thickness(b); });
        thinnest = least == mesh.elements.end() ? Vec<D>(Vec<D>::Zero()) : least->centroid;
    }

    /// A mouth may be the only outlet of a pocket, into which a body drives the flux that its own section sweeps.
    double mouth_beta(double inertance) const
    {
        return section > 0 ? std::max(heaviest_film * mass / (inertance * section * section), 1.0) : mass;
    }
    /// `inertance`: of the place, without viscosity, mass over squared flux.
    double beta(double inertance, const Vec<D>& x) const
    {
        const double reach = std::max((x - thinnest).squaredNorm(), 1e-6 * dx * dx);
        return std::max(heaviest_film * mass / (inertance * reach), 1.0);
    }
};

// Shear between a film's walls, sum of m (w . (V_master - V_other))^2 / 2 over wrenches w about one point, in its principal ones: no more than a twist has components.
template <int D>
class WallShear {
public:
    WallShear(const Coupling<D>& coupling, const FilmMesh<D>& mesh)
        : centre_(coupling.solids[mesh.master].centre), other_(coupling.solids[mesh.other].centre + mesh.shift),
          place_(mesh.mid.empty() ? centre_ : mesh.mid.front())
    {
    }
    void add(double mass, const Vec<D>& t, const Vec<D>& x)
    {
        const Twist<D> w = wrench<D>(t, x - place_);
        sum_ += mass * w * w.transpose();
        length_ = std::max(length_, (x - place_).norm());
    }
    template <class F>
    void for_each_inertia(F&& f) const // f(row of the master, row of the other, mass)
    {
        Twist<D> scale = Twist<D>::Ones(); // forces and torques alike
        scale.template tail<spin_size<D>>().setConstant(length_ > 0 ? 1 / length_ : 1.0);
        const auto [masses, wrenches] = symmetric_eigen<twist_size<D>>(scale.asDiagonal() * sum_ * scale.asDiagonal());
        for (int k = 0; k < twist_size<D>; ++k) {
            if (!(masses[k] > 0))
                continue;
            const Twist<D> w = wrenches.col(k).cwiseQuotient(scale);
            f(about(w, centre_), Twist<D>(-about(w, other_)), masses[k]);
        }
    }

private:
    Twist<D> about(Twist<D> w, const Vec<D>& centre) const
    {
        w.template tail<spin_size<D>>() += moment<D>(Vec<D>(place_ - centre), Vec<D>(w.template head<D>()));
        return w;
    }

    Vec<D> centre_, other_, place_;
    double length_ = 0;
    TwistMatrix<D> sum_ = TwistMatrix<D>::Zero();
};

} // namespace

// With g the tilt of d, which leads from wall to wall, and D t the change along t of d's part along the film,
//
//     r_B = 1/2 (t - 7/6 g (g.t) + 1/6 D t) - 2/5 (g.t) n,     r_A = t - r_B,     U_w.t = r_A.U_A + r_B.U_B
//
// (method, "Films of viscous fluid"; D t in 2D only). The difference that a common rotation makes to t.U at mid-gap is subtracted, half from each.
template <int D>
WallRows<D> wall_rows(const Coupling<D>& coupling, const FilmMesh<D>& mesh, const FilmElement<D>& e, const Vec<D>& t,
                      double wet)
{
    const Vec<D> g = tilt(e);
    const Vec<D> bent = D == 2 ? widening(mesh, e, t) : Vec<D>(Vec<D>::Zero());
    const Vec<D> of_other = 0.5 * (t - 7.0 / 6 * g.dot(t) * g + bent / 6) - 0.4 * g.dot(t) * e.normal, of_master = t - of_other;
    Twist<D> turned = Twist<D>::Zero();
    turned.template tail<spin_size<D>>() = -0.5 * (moment<D>(Vec<D>(e.centroid_master - e.centroid), of_master) +
                                                   moment<D>(Vec<D>(e.centroid_other - e.centroid), of_other));
    const Vec<D>&centre = coupling.solids[mesh.master].centre, other_centre = coupling.solids[mesh.other].centre + mesh.shift;
    WallRows<D> rows{wrench<D>(of_master, e.centroid_master - centre) + turned,
                     wrench<D>(of_other, e.centroid_other - other_centre) + turned};
    Twist<D> about_master = rows.other;
    about_master.template tail<spin_size<D>>() += moment<D>(Vec<D>(other_centre - centre), of_other);
    rows.master += (1 - wet) * about_master;
    rows.other *= wet;
    return rows;
}

template <int D>
std::vector<double> element_betas(const FilmMesh<D>& mesh, double viscosity_dt, double density)
{
    const std::vector<double> cubic = D == 3 ? cubic_integrals(mesh) : std::vector<double>();
    std::vector<double> betas;
    betas.reserve(mesh.elements.size());
    for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
        const FilmElement<D>& e = mesh.elements[k];
        const double resistance = D == 3 ? cubic[k] * e.conductance() / (e.measure * e.measure) : e.inverse / e.volume;
        betas.push_back(12 * viscosity_dt / density * resistance / std::pow(slant(e), slant_power));
    }
    return betas;
}

template <int D>
void find_drag(Coupling<D>& coupling, double viscosity_dt, const std::vector<TwistMatrix<D>>& mass, const DragTerms& terms)
{
    const double rho = coupling.density;
    const WetShares& wet = terms.wet;
    const GapChanges& changes = terms.changes;
    const auto parts_of = [&](std::size_t film) { return changes.drag.empty() ? DragParts() : changes.drag[film]; };
    std::vector<Shut<D>> shuts;
    const std::size_t tangential = static_cast<std::size_t>(coupling.network.elements) * (D - 1);
    coupling.element_drag.reserve(coupling.network.elements);
    coupling.drag_inertia.reserve(tangential + coupling.network.films.size() * twist_size<D> +
                                  coupling.network.rim.mouths.size());
    for (const Film<D>& film : coupling.network.films) {
        const FilmMesh<D>& mesh = film.mesh;
        WallShear<D> shear(coupling, mesh);
        const Shut<D>& shut = shuts.emplace_back(coupling, mesh, mass);
        const DragParts parts = parts_of(shuts.size() - 1);
        const std::vector<double> betas = element_betas(mesh, viscosity_dt, rho);
        for (std::size_t k = 0; k < mesh.elements.size(); ++k) {
            const FilmElement<D>& e = mesh.elements[k];
            const int number = static_cast<int>(coupling.element_drag.size());
            const double opened = changes.elements.empty() ? 0.0 : changes.elements[number];
            Drag drag = drag_of(opened != 0 ? betas[k] * (parts.mean * cubic_mean(mesh, e, opened) + parts.end) : betas[k],
                                shut.beta(rho * e.measure * e.measure / e.conductance(), e.centroid));
            const double inverse =
                opened != 0 ? e.inverse * ((1 - parts.end) * linear_mean(mesh, e, opened) + parts.end) : e.inverse;
            drag.wet = wet.elements.empty() ? 1.0 : wet.elements[number];
            coupling.element_drag.push_back(drag);
            if (!film.here)
                continue;
            for (const Vec<D>& t : tangents<D>(e.normal)) {
                const WallRows<D> rows = wall_rows(coupling, mesh, e, t, drag.wet);
                coupling.drag_inertia.push_back(
                    {{mesh.master, mesh.other, rows.master, rows.other, drag.wet * rho * e.volume * drag.theta},
                     number,
                     -1,
                     t});
                shear.add(drag.wet * viscosity_dt * inverse, t, e.centroid);
            }
        }
        shear.for_each_inertia([&](const Twist<D>& row_master, const Twist<D>& row_other, double inertia) {
            coupling.drag_inertia.push_back({{mesh.master, mesh.other, row_master, row_other, inertia}});
        });
    }
    const std::vector<Mouth<D>>& mouths = coupling.network.rim.mouths;
    for (std::size_t r = 0; r < mouths.size(); ++r) {
        const Mouth<D>& c = mouths[r];
        const FilmMesh<D>& mesh = coupling.network.films[c.film].mesh;
        const double opened = changes.mouths.empty() ? 0.0 : changes.mouths[r];
        const double beta = mouth_beta(c.kind, viscosity_dt, rho, c.h, c.resistance);
        const DragParts parts = parts_of(static_cast<std::size_t>(c.film));
        Drag drag = drag_of(opened != 0 ? beta * (parts.mean * square_mean(c.h, opened) + parts.end) : beta,
                            shuts[c.film].mouth_beta(rho * c.resistance / c.length));
        drag.wet = wet.mouths.empty() ? 1.0 : wet.mouths[r];
        coupling.mouth_drag.push_back(drag);
        if (!coupling.network.films[c.film].here)
            continue;
        coupling.drag_inertia.push_back(
            {{mesh.master, mesh.other, (1 - 0.5 * drag.wet) * wrench<D>(c.outward, c.x - coupling.solids[mesh.master].centre),
              0.5 * drag.wet * wrench<D>(c.outward, c.x - coupling.solids[mesh.other].centre - mesh.shift),
              drag.wet * rho * c.resistance * c.h * c.h * c.length * drag.theta},
             -1,
             static_cast<int>(r)});
    }
}

template <int D>
double film_conductance(const Coupling<D>& coupling, const Film<D>& film, std::size_t e)
{
    const double conductance = film.mesh.elements[e].conductance();
    return coupling.element_drag.empty() ? conductance : coupling.element_drag[film.first_element + e].kappa * conductance;
}

template <int D>
void start_drag(Coupling<D>& coupling, FluidVelocity<D>& u_star)
{
    const std::vector<Mouth<D>>& mouths = coupling.network.rim.mouths;
    for (DragInertia<D>& drag : coupling.drag_inertia) {
        if (drag.element >= 0)
            drag.speed = drag.direction.dot(u_star.film[drag.element]);
        if (drag.mouth >= 0)
            drag.speed = u_star.mouth[drag.mouth] / (mouths[drag.mouth].length * mouths[drag.mouth].h);
    }
    for (std::size_t e = 0; e < coupling.element_drag.size(); ++e)
        u_star.film[e] *= coupling.element_drag[e].kappa;
    for (std::size_t r = 0; r < coupling.mouth_drag.size(); ++r)
        u_star.mouth[r] *= coupling.mouth_drag[r].kappa;
}

namespace {

// Mean of the velocities of a film's two walls at mid-gap; for the share 1 - `wet` of the gap, a void, the master's.
template <int D>
Vec<D> mean_velocity(const Coupling<D>& coupling, const FilmMesh<D>& mesh, const std::vector<Twist<D>>& twists, const Vec<D>& x,
                     double wet)
{
    return (1 - 0.5 * wet) * velocity_at<D>(twists[mesh.master], x - coupling.solids[mesh.master].centre) +
           0.5 * wet * velocity_at<D>(twists[mesh.other], x - coupling.solids[mesh.other].centre - mesh.shift);
}

} // namespace

template <int D>
double entrained_flux(const Coupling<D>& coupling, std::size_t mouth, const std::vector<Twist<D>>& twists)
{
    if (coupling.mouth_drag.empty())
        return 0;
    const Mouth<D>& c = coupling.network.rim.mouths[mouth];
    const Drag& drag = coupling.mouth_drag[mouth];
    return drag.theta * c.length * c.h *
           c.outward.dot(mean_velocity(coupling, coupling.network.films[c.film].mesh, twists, c.x, drag.wet));
}

template <int D>
void add_entrainment(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, double share, FluidVelocity<D>& u)
{
    if (coupling.element_drag.empty() && coupling.mouth_drag.empty())
        return;
    for (const Film<D>& film : coupling.network.films)
        for (std::size_t e = 0; e < film.mesh.elements.size(); ++e) {
            const FilmElement<D>& element = film.mesh.elements[e];
            const Drag& drag = coupling.element_drag[film.first_element + e];
            for (const Vec<D>& t : tangents<D>(element.normal)) {
                const WallRows<D> rows = wall_rows(coupling, film.mesh, element, t, drag.wet);
                const double U = rows.master.dot(twists[film.mesh.master]) + rows.other.dot(twists[film.mesh.other]);
                u.film[film.first_element + e] += share * drag.theta * U * t;
            }
        }
    for (std::size_t r = 0; r < u.mouth.size(); ++r)
        u.mouth[r] += share * entrained_flux(coupling, r, twists);
}

// The inertia of drag is theta times a film's mass, and beta = theta / kappa.
template <int D>
double film_loss(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists, const FluidVelocity<D>& u)
{
    const std::vector<Mouth<D>>& mouths = coupling.network.rim.mouths;
    double loss = 0;
    for (const DragInertia<D>& drag : coupling.drag_inertia) {
        const NormalInertia<D>& inertia = drag.inertia;
        double speed = 0, kappa = 1;
        if (drag.element >= 0) {
            speed = drag.direction.dot(u.film[drag.element]);
            kappa = coupling.element_drag[drag.element].kappa;
        } else if (drag.mouth >= 0) {
            speed = u.mouth[drag.mouth] / (mouths[drag.mouth].length * mouths[drag.mouth].h);
            kappa = coupling.mouth_drag[drag.mouth].kappa;
        }
        const double lag =
            speed - inertia.row_master.dot(twists[inertia.master]) - inertia.row_other.dot(twists[inertia.other]);
        loss += inertia.mass / kappa * lag * lag;
    }
    return coupling.grid->comm().sum(loss);
}

template <int D>
std::vector<Twist<D>> drag_impulses(const Coupling<D>& coupling, const std::vector<Twist<D>>& twists)
{
    std::vector<Twist<D>> impulse(coupling.solids.size(), Twist<D>::Zero());
    for (const DragInertia<D>& drag : coupling.drag_inertia) {
        const NormalInertia<D>& inertia = drag.inertia;
        const double lag =
            drag.speed - inertia.row_master.dot(twists[inertia.master]) - inertia.row_other.dot(twists[inertia.other]);
        impulse[inertia.master] += inertia.mass * lag * inertia.row_master;
        impulse[inertia.other] += inertia.mass * lag * inertia.row_other;
    }
    coupling.grid->comm().sum(std::span<double>(impulse.data()->data(), impulse.size() * twist_size<D>));
    return impulse;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<double> element_betas<D>(const FilmMesh<D>&, double, double);                                         \
    template void find_drag<D>(Coupling<D>&, double, const std::vector<TwistMatrix<D>>&, const DragTerms&);                    \
    template WallRows<D> wall_rows<D>(const Coupling<D>&, const FilmMesh<D>&, const FilmElement<D>&, const Vec<D>&, double);   \
    template double film_conductance<D>(const Coupling<D>&, const Film<D>&, std::size_t);                                      \
    template double entrained_flux<D>(const Coupling<D>&, std::size_t, const std::vector<Twist<D>>&);                          \
    template void start_drag<D>(Coupling<D>&, FluidVelocity<D>&);                                                              \
    template void add_entrainment<D>(const Coupling<D>&, const std::vector<Twist<D>>&, double, FluidVelocity<D>&);             \
    template double film_loss<D>(const Coupling<D>&, const std::vector<Twist<D>>&, const FluidVelocity<D>&);                   \
    template std::vector<Twist<D>> drag_impulses<D>(const Coupling<D>&, const std::vector<Twist<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
