// Derivatives of the energies of gaps' arms (complex, "Derivatives").
#include "gapflow/complex/gap_finder.hpp"
#include "gapflow/complex/gap_moving_way.hpp"
#include "gapflow/complex/gap_round_rates.hpp"

namespace gapflow {
namespace {

/// Of arms whose walls are not round.
template <int D>
class ArmRates {
public:
    explicit ArmRates(const GapFinder<D>& finder) : finder_(finder) {}

    GapRates<D> rates_at(const GapSite<D>& site, const PairTwist<D>& twist, const GapLoads& by) const
    {
        const FacePiece<D>& piece = finder_.complex().pieces[site.piece];
        const MovingPlace at = moving(site, piece, twist);
        Number sum = 0; // its rates alone
        double by_area = 0;
        add_integrals(at, piece, by, sum, by_area);
        GapRates<D> rates;
        rates.pose = Eigen::Map<const PairTwist<D>>(sum.rate.data());
        rates.area = by_area;
        rates.centroid = Eigen::Map<const Vec<D>>(&sum.rate[first_centroid]);
        return rates;
    }

private:
    using Number = MovingNumber<D>;
    static constexpr int first_centroid = 2 * twist_size<D>;
    struct MovingPlace {
        PlaceOf<D, Number> centroid;
        GapPlace<D, MovingWalls<D>> place;
    };
    /// Refers to `site`.
    MovingPlace moving(const GapSite<D>& site, const FacePiece<D>& piece, PairTwist<D> twist) const
    {
        for (int side = 0; side < 2; ++side)
            if (site.still[side])
                twist.template segment<twist_size<D>>(side * twist_size<D>).setZero();
            else if (site.round[side])
                twist.template segment<spin_size<D>>(side * twist_size<D> + D).setZero();
        PlaceOf<D, Number> centroid;
        for (int axis = 0; axis < D; ++axis)
            centroid[axis] = Number::variable(piece.centroid[axis], first_centroid + axis);
        const FacingWalls<D, MovingWalls<D>> walls(MovingWalls<D>(site.walls, twist, site.standoff));
        return {centroid, *finder_.place_at(piece, walls, centroid)};
    }
    /// The derivatives of what has those `by` by the terms of integrate().
    void add_integrals(const MovingPlace& at, const FacePiece<D>& piece, const GapLoads& by, Number& rates,
                       double& by_area) const
    {
        using Way = MovingWay<D>;
        const GapPlace<D, MovingWalls<D>>& place = at.place;
        const auto& walls = place.walls;
        const double A = piece.area, delta = place.delta;
        const PlaceOf<D, Number> frame = mean_motion(walls, place.here.normal, place.here.middle);
        rates.add_rates_of(frame[piece.axis], by.motion);
        if (place.along_face()) {
            by_area -= by.resistance * delta / (A * A);
            return;
        }
        const GapShape<D, Number> shape =
            shape_of_gap<D, MovingWalls<D>>(walls, at.centroid, place.n, place.here, place.e, place.way);
        const Number &sigma = shape.share, &bend = shape.bend;
        const std::vector<GapLine<D, Number>> lines = finder_.lines_of(at.centroid, place);
        Number sum = 0, open = 0;
        for (const auto& line : lines) {
            sum += line.width * line.thickness;
            open += line.width * walls.between_shapes(line.thickness);
        }
        const Number wider = A / open, thinner = open / (A * sum); // of widths, and one over the gap's area
        std::vector<Way> ways;
        ways.reserve(lines.size());
        std::vector<Number> width, scale;
        double through = 0;
        for (const auto& line : lines) {
            Way& way = ways.emplace_back(walls, line.place, place.way, place.n, line.thickness, frame);
            way.find_points(place.end[0], place.end[1], sigma, bend);
            width.push_back(line.width * wider);
            scale.push_back(line.thickness * thinner);
            through += width.back().value * way.at_face();
        }
        const Number share = finder_.share_of(place);
        double resistance = 0, flux = 0, mass = 0, by_through = 0;
        std::vector<double> by_width(lines.size(), 0.0);
        for (std::size_t l = 0; l < lines.size(); ++l) {
            const double own = scale[l].value;
            double by_scale = 0;
            for (typename Way::Point& point : ways[l].points()) {
                const double per_weight = delta * width[l].value / point.thickness, w = per_weight * point.weight,
                             Q = point.flux - own * through;
                resistance += own * own * w;
                flux += own * w * Q;
                mass += w * Q * Q;
                const double by_w = share.value * (by.resistance * own * own + by.flux * own * Q + by.mass * Q * Q);
                point.by_weight = by_w * per_weight;
                point.by_thickness = -by_w * w / point.thickness;
                point.by_flux = share.value * w * (by.flux * own + 2 * by.mass * Q);
                by_width[l] += by_w * w / width[l].value;
                by_scale += share.value * w * (2 * by.resistance * own + by.flux * Q) - point.by_flux * through;
                by_through -= own * point.by_flux;
            }
            rates.add_rates_of(scale[l], by_scale);
        }
        typename Way::Rates shared;
        for (std::size_t l = 0; l < lines.size(); ++l) {
            rates.add_rates_of(width[l], by_width[l] + by_through * ways[l].at_face());
            ways[l].add_rates(by_through * width[l].value, shared, rates);
        }
        add_rates_along<D>(shared.way, place.way, rates);
        add_rates_along<D>(shared.walls.n, place.n, rates);
        add_rates_along<D>(shared.walls.frame, frame, rates);
        rates.add_rates_of(sigma, shared.sigma);
        for (int k = 0; k < 2 * twist_size<D>; ++k)
            rates.rate[k] += shared.walls.pose[k];
        const Number length = delta * (1.0 + place.moved[1] - place.moved[0]);
        const double plain = length.value / A;
        rates.add_rates_of(length, by.resistance * (1 - share.value) / A);
        rates.add_rates_of(share, by.share + by.resistance * (resistance - plain) + by.flux * flux + by.mass * mass);
        by_area +=
            share.value * by.mass * mass / A - by.resistance * (share.value * resistance + (1 - share.value) * plain) / A;
    }

    const GapFinder<D>& finder_;
};

} // namespace

template <int D>
GapDerivatives<D>::GapDerivatives(const Grid<D>& grid, std::span<const Solid<D>> solids, const Complex<D>& complex,
                                  std::span<const GapArm<D>> arms)
    : finder_(std::make_unique<GapFinder<D>>(grid, solids, complex, Standoffs<D>{}, true)), // the arms have theirs
      arms_(arms), round_(arms.size())
{
}
template <int D>
GapDerivatives<D>::~GapDerivatives() = default;

template <int D>
GapRates<D> GapDerivatives<D>::of(int number, const PairTwist<D>& twist, const GapLoads& by) const
{
    if (by.share == 0 && by.resistance == 0 && twist.isZero(0))
        return {};
    const GapArm<D>& arm = arms_[number];
    std::unique_ptr<const RoundArmRates<D>>& round = round_[number];
    if (!round) {
        const GapSite<D> site = *finder_->site_at(arm.piece, &arm);
        if (!site.walls.round())
            return ArmRates<D>(*finder_).rates_at(site, twist, by);
        round = std::make_unique<const RoundArmRates<D>>(round_arm_rates(*finder_, site));
    }
    return round->of(arm, finder_->complex().pieces[arm.piece], twist, by);
}

template class GapDerivatives<2>;
template class GapDerivatives<3>;

} // namespace gapflow
