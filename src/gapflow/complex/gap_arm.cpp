#include "gapflow/complex/gap_finder.hpp"
#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <utility>

namespace gapflow {
namespace {

/// Of the same two solids in the other order.
template <int D>
Standoff<D> swapped(const Standoff<D>& standoff)
{
    Standoff<D> other{standoff.distance, {}};
    other.rate << standoff.rate.template tail<twist_size<D>>(), standoff.rate.template head<twist_size<D>>();
    return other;
}

} // namespace

template <int D>
void Standoffs<D>::add(int a, int b, const Standoff<D>& standoff)
{
    Standoff<D>& known = of_[std::minmax(a, b)];
    if (standoff.distance > known.distance)
        known = a < b ? standoff : swapped(standoff);
}

template <int D>
Standoff<D> Standoffs<D>::of(int a, int b) const
{
    const auto found = of_.find(std::minmax(a, b));
    if (found == of_.end())
        return {};
    return a < b ? found->second : swapped(found->second);
}

namespace {

template <int D>
class ArmIntegrals {
public:
    explicit ArmIntegrals(const GapFinder<D>& finder) : finder_(finder) {}

    std::optional<GapArm<D>> arm_at(std::size_t number) const
    {
        const std::optional<GapSite<D>> site = finder_.site_at(number);
        if (!site)
            return {};
        const FacePiece<D>& piece = finder_.complex().pieces[number];
        const auto terms = integrate(*site, piece);
        if (!terms)
            return {};
        GapArm<D> arm{static_cast<std::int32_t>(number),
                      site->solid,
                      terms->share,
                      terms->resistance,
                      terms->flux,
                      terms->motion,
                      terms->mass,
                      site->standoff,
                      site->here.thickness,
                      PairTwist<D>::Zero()};
        for (int side = 0; side < 2; ++side)
            arm.opening.template segment<twist_size<D>>(side * twist_size<D>) =
                -speed_along<D>(site->here.normal[side], site->here.middle, site->walls.reference[side]);
        for (int side = 0; side < 2; ++side) // round-off of what moves no wall
            if (site->still[side])
                still(arm, side * twist_size<D>, twist_size<D>);
            else if (site->round[side])
                still(arm, side * twist_size<D> + D, spin_size<D>);
        return arm;
    }

private:
    struct Terms {
        double share, resistance;
        PairTwist<D> flux, motion;
        PairMass<D> mass;
    };
    /// Nothing where the walls meet on the way.
    std::optional<Terms> integrate(const GapPlace<D, StillWalls<D>>& place, const FacePiece<D>& piece) const
    {
        constexpr int T = twist_size<D>;
        const auto& walls = place.walls;
        const double A = piece.area, delta = place.delta;

        const auto frame = mean_motion(walls, place.here.normal, place.here.middle);
        Terms arm{0, 0, PairTwist<D>::Zero(), StillWalls<D>::along(frame, unit<D>(piece.axis)), PairMass<D>::Zero()};
        if (place.along_face()) {
            arm.resistance = delta / A;
            return arm;
        }
        if (walls.round()) { // the first wall's velocity less the second one's
            Vec<D> flux = Vec<D>::Zero();
            Mat<D> mass = Mat<D>::Zero();
            if (!add_lines(place, piece, frame, arm.resistance, flux, mass))
                return {};
            arm.flux.template head<D>() = flux;
            arm.flux.template segment<D>(T) = -flux;
            for (const int a : {0, T})
                for (const int b : {0, T})
                    arm.mass.template block<D, D>(a, b) = a == b ? mass : Mat<D>(-mass);
        } else if (!add_lines(place, piece, frame, arm.resistance, arm.flux, arm.mass))
            return {};
        arm.share = finder_.share_of(place);
        const double plain = delta * (1.0 + place.moved[1] - place.moved[0]) / A;
        arm.resistance = arm.share * arm.resistance + (1.0 - arm.share) * plain;
        arm.flux *= arm.share;
        arm.mass *= arm.share;
        return arm;
    }
    /// Adds the lines' integrals; false where the walls meet on the way.
    template <class Row, class Square>
    bool add_lines(const GapPlace<D, StillWalls<D>>& place, const FacePiece<D>& piece,
                   const typename StillWalls<D>::Frame& frame, double& resistance, Row& flux_of, Square& mass) const
    {
        const auto& walls = place.walls;
        const double A = piece.area, delta = place.delta;
        const GapShape<D> shape =
            shape_of_gap<D, StillWalls<D>>(walls, piece.centroid, place.n, place.here, place.e, place.way);
        std::vector<GapLine<D, double>> lines = finder_.lines_of(piece.centroid, place);
        double sum = 0, open = 0; // of the lines' areas, and what of them is in the face
        for (const auto& line : lines) {
            sum += line.width * line.thickness;
            open += line.width * walls.between_shapes(line.thickness);
        }
        const double area = A * (sum / open); // of the gap
        using Way = GapWay<D, Row>;
        std::vector<std::vector<typename Way::Point>> points;
        Row through = Row::Zero(); // the closing's flux at the face
        for (auto& line : lines) {
            line.width *= A / open;
            Way along(walls, line.place, place.way, place.n, line.thickness, frame);
            points.push_back(along.points(place.end[0], place.end[1], shape.share, shape.bend));
            if (along.meets())
                return false;
            through += line.width * along.at_face();
        }
        for (std::size_t l = 0; l < lines.size(); ++l) {
            const double scale = lines[l].thickness / area;
            for (const auto& point : points[l]) {
                const double w = delta * point.weight * lines[l].width / point.thickness;
                const Row flux = point.flux - scale * through;
                resistance += scale * scale * w;
                flux_of += scale * w * flux;
                mass += w * (flux * flux.transpose());
            }
        }
        return true;
    }
    /// No energy of some components of the twists.
    static void still(GapArm<D>& arm, int first, int count)
    {
        for (int k = first; k < first + count; ++k) {
            for (PairTwist<D>* row : {&arm.flux, &arm.motion, &arm.opening})
                (*row)[k] = 0;
            arm.mass.row(k).setZero();
            arm.mass.col(k).setZero();
        }
    }

    const GapFinder<D>& finder_;
};

} // namespace

template <int D>
std::vector<GapArm<D>> find_gap_arms(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                                     const Standoffs<D>& standoffs)
{
    const GapFinder<D> finder(grid, solids, complex, standoffs);
    const ArmIntegrals<D> integrals(finder);
    return items_of<GapArm<D>>(static_cast<long>(complex.pieces.size()), [&](long k, std::vector<GapArm<D>>& arms) {
        if (auto arm = integrals.arm_at(static_cast<std::size_t>(k)))
            arms.push_back(*arm);
    });
}

template <int D>
void for_each_gap(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                  const Standoffs<D>& standoffs, const std::function<void(const GapSite<D>&)>& visit)
{
    const GapFinder<D> finder(grid, solids, complex, standoffs);
    for (std::size_t k = 0; k < complex.pieces.size(); ++k)
        if (const auto site = finder.site_at(k))
            visit(*site);
}

template class Standoffs<2>;
template class Standoffs<3>;
template std::vector<GapArm<2>> find_gap_arms(const Grid<2>&, std::span<const Solid<2>>, const Complex<2>&,
                                              const Standoffs<2>&);
template std::vector<GapArm<3>> find_gap_arms(const Grid<3>&, std::span<const Solid<3>>, const Complex<3>&,
                                              const Standoffs<3>&);
template void for_each_gap(const Grid<2>&, std::span<const Solid<2>>, const Complex<2>&, const Standoffs<2>&,
                           const std::function<void(const GapSite<2>&)>&);
template void for_each_gap(const Grid<3>&, std::span<const Solid<3>>, const Complex<3>&, const Standoffs<3>&,
                           const std::function<void(const GapSite<3>&)>&);

} // namespace gapflow
