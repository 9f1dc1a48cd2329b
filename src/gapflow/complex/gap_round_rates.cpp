#include "gapflow/complex/gap_round_rates.hpp"

namespace gapflow {
namespace {

/// With their rates: the sums that make up R, c and B on the lines of a piece.
template <int D>
struct RoundIntegrals {
    double resistance = 0;
    Vec<D> flux = Vec<D>::Zero();
    Mat<D> mass = Mat<D>::Zero();
    RoundArmRates<D> rates;

    /// Of a line of this width with the thickness at the face over the gap's area, `scale`; `through` is the closing's flux through the face.
    void add(const typename RoundWay<D>::Point& point, double delta, const RoundNumber<D>& width, const RoundNumber<D>& scale,
             const RoundRow<D>& through)
    {
        const double w = delta * point.weight * width.value / point.thickness, own = scale.value;
        const RoundRates<D> by_scale = rates_of<D>(scale),
                            by_w = delta / point.thickness *
                                   (width.value * point.weight_rate + point.weight * rates_of<D>(width) -
                                    point.weight * width.value / point.thickness * point.thickness_rate);
        RoundRow<D> Q = point.flux;
        Q.add(-own, -by_scale, through);
        resistance += own * own * w;
        flux += own * w * Q.value;
        mass += w * Q.value * Q.value.transpose();
        rates.resistance += own * own * by_w + 2 * own * w * by_scale;
        const RoundRates<D> by_flux = own * by_w + w * by_scale;
        for (int k = 0, kl = 0; k < D; ++k) {
            rates.flux.col(k) += Q.value[k] * by_flux + own * w * Q.rate.col(k);
            for (int l = k; l < D; ++l, ++kl)
                rates.mass.col(kl) +=
                    Q.value[k] * Q.value[l] * by_w + w * Q.value[l] * Q.rate.col(k) + w * Q.value[k] * Q.rate.col(l);
        }
    }
};

} // namespace

template <int D>
GapRates<D> RoundArmRates<D>::of(const GapArm<D>& arm, const FacePiece<D>& piece, const PairTwist<D>& twist,
                                 const GapLoads& by) const
{
    constexpr int T = twist_size<D>;
    Vec<D> speed = Vec<D>::Zero(); // the first wall's less the second one's
    for (int side = 0; side < 2; ++side)
        if (!still[side])
            speed += (side == 0 ? 1 : -1) * twist.template segment<D>(side * T);
    RoundRates<D> sum = by.share * share + by.resistance * resistance;
    for (int k = 0, kl = 0; k < D; ++k) {
        sum += by.flux * speed[k] * flux.col(k);
        for (int l = k; l < D; ++l, ++kl)
            sum += by.mass * (k == l ? 1 : 2) * speed[k] * speed[l] * mass.col(kl);
    }
    GapRates<D> rates;
    rates.pose.template segment<D>(0) = sum.template segment<D>(0);
    rates.pose.template segment<D>(T) = sum.template segment<D>(D);
    for (int axis = 0, variable = 2 * D; axis < D; ++axis)
        if (axis != piece.axis)
            rates.centroid[axis] = sum[variable++];
    rates.area = (by.mass * twist.dot(arm.mass * twist) - by.resistance * arm.resistance) / piece.area;
    return rates;
}

template <int D>
RoundArmRates<D> round_arm_rates(const GapFinder<D>& finder, const GapSite<D>& site)
{
    using S = RoundNumber<D>;
    using Walls = MovingRoundWalls<D>;
    RoundArmRates<D> rates;
    rates.still = site.still;
    if (site.along_face())
        return rates;
    const FacePiece<D>& piece = finder.complex().pieces[site.piece];
    const auto centroid = Walls::centroid(piece.centroid, piece.axis);
    const GapPlace<D, Walls> place = *finder.place_at(piece, FacingWalls<D, Walls>(Walls(site.walls, site.standoff)), centroid);
    const GapShape<D, S> shape = shape_of_gap<D, Walls>(place.walls, centroid, place.n, place.here, place.e, place.way);
    const std::vector<GapLine<D, S>> lines = finder.lines_of(centroid, place);
    S sum = 0, open = 0; // of the lines' areas, and what of them is in the face
    for (const auto& line : lines) {
        sum += line.width * line.thickness;
        open += line.width * place.walls.between_shapes(line.thickness);
    }
    const double A = piece.area, delta = place.delta;
    const S wider = A / open, thinner = open / (A * sum); // of widths, and one over the gap's area
    std::vector<RoundWay<D>> ways;
    ways.reserve(lines.size());
    RoundRow<D> through = RoundRow<D>::zero(); // the closing's flux at the face
    for (const auto& line : lines) {
        RoundWay<D>& way = ways.emplace_back(place.walls, line.place, place.way, place.n, line.thickness);
        way.find_points(place.end[0], place.end[1], shape.share, shape.bend);
        const S width = line.width * wider;
        through.add(width.value, rates_of<D>(width), way.at_face());
    }
    RoundIntegrals<D> of;
    for (std::size_t l = 0; l < lines.size(); ++l) {
        const S width = lines[l].width * wider, scale = lines[l].thickness * thinner;
        for (const auto& point : ways[l].points())
            of.add(point, delta, width, scale, through);
    }
    const S share = finder.share_of(place);
    const S plain = delta / A * (1.0 + place.moved[1] - place.moved[0]);
    const RoundRates<D> by_share = rates_of<D>(share);
    rates.share = by_share;
    rates.resistance =
        share.value * of.rates.resistance + (1 - share.value) * rates_of<D>(plain) + (of.resistance - plain.value) * by_share;
    for (int k = 0, kl = 0; k < D; ++k) {
        rates.flux.col(k) = share.value * of.rates.flux.col(k) + of.flux[k] * by_share;
        for (int l = k; l < D; ++l, ++kl)
            rates.mass.col(kl) = share.value * of.rates.mass.col(kl) + of.mass(k, l) * by_share;
    }
    return rates;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template struct RoundArmRates<D>;                                                                                          \
    template RoundArmRates<D> round_arm_rates(const GapFinder<D>&, const GapSite<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
