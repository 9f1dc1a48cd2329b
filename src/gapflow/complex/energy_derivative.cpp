#include "gapflow/complex/energy_derivative.hpp"

#include "gapflow/complex/corner_faces.hpp"
#include "gapflow/complex/lending.hpp"
#include "gapflow/complex/lever.hpp"
#include "gapflow/complex/seen_volume.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/grid/field.hpp"
#include "gapflow/grid/side_distance.hpp"

#include <cmath>

namespace gapflow {
namespace {

/// n x o of a moment n and an area o along an axis, and its transpose: the moment's factors in (n x o) . s.
template <int D>
Vec<D> turned(const Spin<D>& s, int axis)
{
    if constexpr (D == 2)
        return axis == 0 ? Vec<2>(0, -s[0]) : Vec<2>(s[0], 0);
    else
        return unit<3>(axis).cross(s);
}

template <int D>
class EnergyDerivative {
public:
    using Area = typename OpenAreas<D>::Area;

    /// Of q . K V - 1/2 p . L p - next . diag(L) p with q = p + next.
    EnergyDerivative(const Grid<D>& grid, const Complex<D>& complex, const FaceDerivatives<D>& derivatives,
                     const Potentials<D>& p, const Potentials<D>& next, std::span<const Twist<D>> twists,
                     const DerivedGaps<D>& gaps, const Circulation<D>* circulation)
        : grid_(grid), complex_(complex), derivatives_(derivatives), p_(p), next_(next), twists_(twists), gaps_(gaps),
          circulation_(circulation), areas_(complex), by_area_(complex.pieces.size(), 0),
          by_moment_(complex.pieces.size(), Vec<D>::Zero()), by_patch_(complex.patches.size(), Twist<D>::Zero()),
          by_link_(complex.links.size(), 0), result_(twists.size(), Twist<D>::Zero())
    {
        if (!gaps.arms().empty()) {
            plain_.assign(complex.pieces.size(), 1.0);
            by_plain_.assign(complex.pieces.size(), 0.0);
            is_gap_.assign(complex.pieces.size(), 0);
        }
        for (const GapArm<D>& arm : gaps.arms()) {
            plain_[arm.piece] = 1 - arm.share;
            is_gap_[arm.piece] = 1;
        }
    }

    std::vector<Twist<D>> find(std::span<const std::vector<WeightedTwist<D>>> seen)
    {
        add_flow();
        add_walls();
        add_seen_volume(seen);
        add_loans();
        add_corners(seen);
        add_gaps();
        return by_motion();
    }

    /// Of a layer's inertia; its gaps' share in `loads`.
    std::vector<Twist<D>> of_layer(double weight, std::vector<LayerLoad<D>>& loads)
    {
        add_flow();
        add_walls();
        add_loans();
        add_corners({});
        add_loads(weight, loads);
        std::vector<Twist<D>> rate = by_motion();
        for (Twist<D>& of : rate)
            of *= weight;
        return rate;
    }

private:
    std::vector<Twist<D>> by_motion()
    {
        by_motion_of_pieces();
        by_motion_of_walls();
        by_motion_of_links();
        return std::move(result_);
    }

    bool owns(int part) const { return grid_.owns(complex_.cell_of_part(part)); }
    double q_of(const PartOrCell& side) const { return p_.of(side) + next_.of(side); }
    /// What of the momentum from the low side of a piece to its high one, a length apart, is no difference of potentials.
    double rest_of(std::size_t piece, double length) const { return circulation_ ? length * circulation_->piece[piece] : 0.0; }
    /// What a conductance of one between two sides takes from E. `rest`: of the momentum.
    double loss(const PartOrCell& low, const PartOrCell& high, double rest) const
    {
        const double difference = p_.of(high) - p_.of(low) + rest;
        return 0.5 * difference * difference + next_.of(low) * p_.of(low) + next_.of(high) * p_.of(high);
    }

    /// -A/spread (1/2 (p_high - p_low)^2 + ..) of every piece.
    void add_flow()
    {
        for (std::size_t k = 0; k < complex_.pieces.size(); ++k) {
            if (!is_gap_.empty() && is_gap_[k])
                continue;
            const FacePiece<D>& piece = complex_.pieces[k];
            const Index<D> f = complex_.index.index(piece.face);
            if (!owns_face(grid_, piece.axis, f))
                continue;
            double over = grid_.spread(piece.axis, f[piece.axis]);
            if (!piece.low.exists() || !piece.high.exists()) { // a side of the domain
                const int end = piece.low.exists();
                if (!is_open(grid_.side(piece.axis, end)))
                    continue;
                over *= side_distance(grid_, piece.axis, end, f);
            }
            by_area_[k] -= loss(piece.low, piece.high, rest_of(k, over)) / over;
        }
    }

    /// q . K V of the walls themselves.
    void add_walls()
    {
        for (int part = 0; part < complex_.parts(); ++part)
            for (int k = complex_.first_patch[part]; k < complex_.first_patch[part + 1] && owns(part); ++k)
                by_patch_[k] += q_of(PartOrCell::part(part)) * twists_[complex_.patches[k].solid];
    }

    /// Of a lent area of one on a piece or an open face: flux between its two sides relative to a wall with the speed U.
    struct Side {
        double difference, loss;
        double energy(double U) const { return difference * U - loss; }
    };
    Side side_of(double length, double rest, const PartOrCell& low, const PartOrCell& high) const
    {
        return {q_of(high) - q_of(low) + rest, loss(low, high, rest) / length};
    }
    Side side_of(std::int32_t piece) const
    {
        const FacePiece<D>& p = complex_.pieces[piece];
        const double length = grid_.spread(p.axis, complex_.index.index(p.face)[p.axis]);
        return side_of(length, rest_of(piece, length), p.low, p.high);
    }
    Side side_of(int axis, std::int32_t face) const
    {
        const Index<D> f = complex_.index.index(face);
        const auto at = [&](const Index<D>& c) { return complex_.main_of(complex_.index(complex_.index.wrapped(c))); };
        const double length = grid_.spread(axis, f[axis]);
        return side_of(length, circulation_ ? length * circulation_->face[axis][face] : 0.0, at(f - step<D>(axis)), at(f));
    }

    /// What E gains by a lent area on another one, per unit of it, and by the speed U. The rest of `weight` E depends on how it is shared among the pieces.
    double add_lent(const Area& to, double weight, double U, double& by_speed)
    {
        if (to.piece < 0) {
            const Side side = side_of(axis_, to.face);
            by_speed += weight * side.difference;
            return side.energy(U);
        }
        double sum = 0;
        areas_.for_each(to, [&](std::int32_t k) { sum += complex_.pieces[k].area / to.area * side_of(k).energy(U); });
        areas_.for_each(to, [&](std::int32_t k) {
            const Side side = side_of(k);
            by_speed += weight * complex_.pieces[k].area / to.area * side.difference;
            by_area_[k] += weight / to.area * (side.energy(U) - sum);
        });
        return sum;
    }

    /// Calls f(piece) for the pieces of an area; a face that nothing cuts has none.
    template <class F>
    void for_each_piece(const Area& area, F&& f) const
    {
        if (area.piece >= 0)
            areas_.for_each(area, f);
        else if (const std::int32_t k = areas_.first(axis_, area.face); k >= 0)
            f(k);
    }
    /// Calls f(patch, part) for the walls beside an area; those that lie beside several of its pieces as often.
    template <class F>
    void for_each_wall_beside(const Area& area, F&& f) const
    {
        for_each_piece(area, [&](std::int32_t piece) {
            for (const PartOrCell& side : {complex_.pieces[piece].low, complex_.pieces[piece].high})
                if (side.is_part())
                    for (int k = complex_.first_patch[side.number()]; k < complex_.first_patch[side.number() + 1]; ++k)
                        f(k, side.number());
        });
    }

    static double bearing(const Area& own, const Area& other) { return std::min(1.0, other.area / own.area); }
    /// min(1, other/own), by both areas.
    void add_bearing(const Area& own, const Area& other, double factor)
    {
        if (other.area >= own.area)
            return;
        for_each_piece(other, [&](std::int32_t k) { by_area_[k] += factor / own.area; });
        for_each_piece(own, [&](std::int32_t k) { by_area_[k] -= factor * other.area / (own.area * own.area); });
    }

    void add_loans()
    {
        Loans<D> loans(grid_, complex_, areas_);
        for (std::size_t k = 0; k < complex_.pieces.size(); ++k) {
            axis_ = complex_.pieces[k].axis;
            const Index<D> f = complex_.index.index(complex_.pieces[k].face);
            if (owns_face(grid_, axis_, f))
                add_loans_of(static_cast<std::int32_t>(k), f, loans);
        }
    }

    /// The integral over the levels of links: a link's level parts what lends below it from what lends above it.
    void add_loans_of(std::int32_t k, const Index<D>& f, Loans<D>& loans)
    {
        JoinLevels levels;
        areas_.find_levels(k, levels);
        JoinLevel level;
        for (std::size_t i = 0; i <= levels.size(); ++i) {
            const double share = (i < levels.size() ? levels[i].share : 1.0) - std::max(0.0, level.share);
            double energy = 0;
            loans.from(k, f, level, [&](const Loan<D>& loan) { energy += add_loan(loan, share, loans.shares()); });
            if (i > 0)
                by_link_[level.link] -= energy * slope(level);
            if (i < levels.size()) {
                by_link_[levels[i].link] += energy * slope(levels[i]);
                level = levels[i];
            }
        }
    }
    /// Of a level by its link's conductance.
    static double slope(const JoinLevel& level) { return (1 - level.share) * (1 - level.share); }

    /// What of an area's energy is not a gap's; its number among the pieces, -1: all is plain.
    std::int32_t gap_of(const Area& area) const
    {
        if (plain_.empty() || area.face < 0)
            return -1;
        return area.piece >= 0 ? area.piece : areas_.first(axis_, area.face);
    }
    double plain(std::int32_t piece) const { return piece >= 0 ? plain_[piece] : 1.0; }

    /// A share of a loan. Returns what E has of the whole loan.
    double add_loan(const Loan<D>& whole, double share_of_levels, const std::vector<MovingShare<D>>& shares)
    {
        const std::int32_t own_gap = gap_of(whole.own), next_gap = gap_of(whole.next),
                           after_gap = whole.more > 0 ? gap_of(whole.after) : -1;
        const double lends = plain(own_gap), bears = plain(next_gap), bears_after = plain(after_gap),
                     part = share_of_levels * lends * bears, part_after = part * bears_after;
        Loan<D> loan = whole;
        loan.size *= part;
        loan.more *= part_after;
        double U = 0;
        for (const MovingShare<D>& share : shares)
            U += share.speed(axis_, twists_[share.solid]);
        double by_speed = 0;
        const double own = add_lent(loan.own, -loan.given(), U, by_speed),
                     next = add_lent(loan.next, loan.of_next(), U, by_speed),
                     after = loan.more > 0 ? add_lent(loan.after, loan.of_after(), U, by_speed) : 0.0;
        const double further = whole.more > 0 ? -own + 2 * next - after : 0.0, by_more = part_after * further,
                     by_size = part * (next - own) + (whole.more > 0 ? 0.5 * bearing(loan.own, loan.after) * by_more : 0.0);
        const auto add_plain = [&](std::int32_t piece, double by) {
            if (piece >= 0)
                by_plain_[piece] += by;
        };
        const double simple = whole.size * (next - own), beyond = whole.more * further;
        add_plain(own_gap, share_of_levels * bears * (simple + bears_after * beyond));
        add_plain(next_gap, share_of_levels * lends * (simple + bears_after * beyond));
        add_plain(after_gap, part * beyond);
        add_bearing(loan.own, loan.next, 0.5 * loan.own.area * std::abs(loan.offset) * by_size);
        if (whole.more > 0)
            add_bearing(loan.own, loan.after, 0.5 * whole.size * by_more);
        for_each_piece(loan.own, [&](std::int32_t k) {
            by_moment_[k][loan.along] += 0.5 * bearing(loan.own, loan.next) * (loan.offset > 0 ? 1 : -1) * by_size;
        });
        add_shares(loan.own, shares, U, by_speed);
        return lends * bears * (simple + bears_after * beyond);
    }

    /// U depends on the walls beside the lending area.
    void add_shares(const Area& own, const std::vector<MovingShare<D>>& shares, double U, double by_speed)
    {
        double all = 0;
        for_each_wall_beside(own, [&](int k, int) { all += complex_.patches[k].area.norm(); });
        if (!(all > 0))
            return;
        for_each_wall_beside(own, [&](int k, int part) {
            const WallPatch<D>& patch = complex_.patches[k];
            const MovingShare<D>& share =
                *std::find_if(shares.begin(), shares.end(), [&](const auto& s) { return s.solid == patch.solid; });
            const Twist<D>& V = twists_[patch.solid];
            const Spin<D> spin = V.template tail<spin_size<D>>();
            const double square = share.area.squaredNorm(), turn = share.moment.dot(spin);
            auto by_area = by_patch_[k].template head<D>();
            if (const double size = patch.area.norm(); size > 0) {
                const double speed = V[axis_] + (share.faces() ? share.area[axis_] / square * turn : 0.0);
                by_area += by_speed * (speed - U) / (all * size) * patch.area;
            }
            if (share.faces() && !areas_.divided(part, own.level)) { // n_d/|S| Theta . omega
                const double factor = by_speed * share.size / square;
                by_area += factor * turn * (unit<D>(axis_) - 2 * share.area[axis_] / square * share.area);
                by_patch_[k].template tail<spin_size<D>>() += factor * share.area[axis_] * spin;
            }
        });
    }

    /// h (difference U - loss), and of D -1/2 h Delta U^2.
    void add_corners(std::span<const std::vector<WeightedTwist<D>>> seen)
    {
        const CornerFaces<D> faces(grid_, complex_, areas_);
        const std::span<const WeightedTwist<D>> none;
        for (const auto& corner : complex_.corners)
            faces.for_each(corner, [&](const CornerFace<D>& face) {
                if (owns_face(grid_, face.axis, complex_.index.index(face.face)))
                    add_corner_face(corner, face, seen.empty() ? none : std::span(seen[corner.solid]));
            });
    }
    void add_corner_face(const typename Complex<D>::Corner& corner, const CornerFace<D>& face,
                         std::span<const WeightedTwist<D>> seen)
    {
        const Twist<D>& V = twists_[corner.solid];
        const double U = face.motion.dot(V);
        InlineVector<double, 4> energy; // by h of each piece
        double by_added = 0, difference = 0;
        for (const CornerPiece<D>& of : face.pieces) {
            const Side side = of.piece >= 0 ? side_of(of.piece) : side_of(face.axis, face.face);
            energy.push_back(side.energy(U));
            by_added += of.open / face.all_open * side.energy(U);
            difference += of.open / face.all_open * side.difference;
        }
        Twist<D>& result = result_[corner.solid];
        for (std::size_t k = 0; k < face.pieces.size(); ++k)
            if (const CornerPiece<D>& of = face.pieces[k]; of.piece >= 0) {
                const double by_open = face.added / face.all_open * (energy[k] - by_added);
                add_by_extent(of.piece, face.across, by_open * of.by_area, by_open * of.by_centroid,
                              complex_.pieces[of.piece].area, complex_.pieces[of.piece].centroid[face.across]);
                result += by_open * of.by_pose;
            }
        Vec<D> by_arm = difference * turned<D>(V.template tail<spin_size<D>>(), face.axis);
        for (const WeightedTwist<D>& of : seen) {
            const double speed = face.motion.dot(of.z), factor = of.weight * face.distance * speed;
            by_added -= 0.5 * factor * speed;
            by_arm -= factor * turned<D>(of.z.template tail<spin_size<D>>(), face.axis);
        }
        for (const CornerPiece<D>& of : face.pieces)
            if (of.piece >= 0)
                add_by_extent(of.piece, face.across, by_added * face.by_area, by_added * face.by_centroid, face.area,
                              face.centroid);
        result += by_added * face.by_pose;
        // The arm goes with the corner from the reference point, and across the face twice as far.
        Vec<D> twice = Vec<D>::Zero();
        twice[face.across] = by_arm[face.across];
        result.template head<D>() += face.added * twice;
        result.template tail<spin_size<D>>() += face.added * moment<D>(corner.at - corner.reference, by_arm + twice);
    }

    /// By the area and the centroid, along an axis, of some area that the piece is part of.
    void add_by_extent(std::int32_t piece, int axis, double by_area, double by_centroid, double area, double centroid)
    {
        if (by_area == 0 && by_centroid == 0)
            return;
        const double by_moment = by_centroid / area; // about the face's centre
        by_area_[piece] += by_area - by_moment * (centroid - face_centre(complex_.pieces[piece])[axis]);
        by_moment_[piece][axis] += by_moment;
    }

    PairTwist<D> pair_twist(const GapArm<D>& arm) const
    {
        PairTwist<D> twist;
        twist << twists_[arm.solid[0]], twists_[arm.solid[1]];
        return twist;
    }
    double spread(const FacePiece<D>& piece) const
    {
        return grid_.spread(piece.axis, complex_.index.index(piece.face)[piece.axis]);
    }
    bool owns(const GapArm<D>& arm) const
    {
        const FacePiece<D>& piece = complex_.pieces[arm.piece];
        return owns_face(grid_, piece.axis, complex_.index.index(piece.face));
    }
    bool wanted(const GapArm<D>& arm) const
    {
        return gaps_.wanted.empty() || gaps_.wanted[arm.solid[0]] || gaps_.wanted[arm.solid[1]];
    }

    /// Energies of faces in gaps.
    void add_gaps()
    {
        std::vector<GapRates<D>> energy(gaps_.arms().size());
        const auto counts = [&](std::size_t k) {
            const GapArm<D>& arm = gaps_.arms()[k];
            return wanted(arm) && std::isfinite(arm.resistance) && // a void has no energy
                   (owns(arm) || by_plain_[arm.piece] != 0 || (!gaps_.loads.empty() && gaps_.loads[k].plain != 0));
        };
        for_each_job(static_cast<int>(energy.size()), [&](int k) {
            if (counts(k))
                energy[k] = gap_energy(k);
        });
        for (std::size_t k = 0; k < energy.size(); ++k) {
            const GapArm<D>& arm = gaps_.arms()[k];
            if (!counts(k))
                continue;
            const FacePiece<D>& piece = complex_.pieces[arm.piece];
            for (int side = 0; side < 2; ++side)
                result_[arm.solid[side]] += energy[k].pose.template segment<twist_size<D>>(side * twist_size<D>);
            Vec<D> by_centroid = energy[k].centroid / piece.area;
            by_centroid[piece.axis] = 0;
            by_area_[arm.piece] += energy[k].area - by_centroid.dot(piece.centroid - face_centre(piece));
            by_moment_[arm.piece] += by_centroid;
        }
    }
    /// Derivatives of E_f.
    GapRates<D> gap_energy(int number) const
    {
        const GapArm<D>& arm = gaps_.arms()[number];
        const FacePiece<D>& piece = complex_.pieces[arm.piece];
        const PairTwist<D> V = pair_twist(arm);
        GapLoads by;
        by.share = -(by_plain_[arm.piece] + (gaps_.loads.empty() ? 0.0 : gaps_.loads[number].plain));
        if (!owns(arm)) // what this rank's faces lend to it
            return gaps_.derivatives->of(number, V, by);
        const double delta = spread(piece), rest = rest_of(arm.piece, delta), d = q_of(piece.low) - q_of(piece.high) - rest,
                     A = piece.area, R = arm.resistance, U = arm.motion.dot(V), flow = arm.flux.dot(V) + delta * U;
        by.resistance = (d * flow + loss(piece.low, piece.high, rest) + 0.5 * flow * flow) / (R * R);
        by.flux = -(d + flow) / R;
        by.motion = A * d + delta * A * U + delta * by.flux;
        by.mass = 0.5;
        GapRates<D> rates = limits_of_motion(number, by);
        rates += gaps_.derivatives->of(number, V, by);
        rates.area += U * d + 0.5 * delta * U * U;
        return rates;
    }

    /// What limits of D have in an arm: the layers' loads, and of the terms that make uniform motion exact with the weights M
    ///
    ///     -(Delta/R c M U + 1/2 Delta (Delta/R - A) U M U),
    ///
    /// whose derivative takes c and U along two twists only: c M U = c(M U_0) + U(M c_0) - c_0 M U_0. That by the resistance is added to `by`.
    GapRates<D> limits_of_motion(int number, GapLoads& by) const
    {
        const GapArm<D>& arm = gaps_.arms()[number];
        const FacePiece<D>& piece = complex_.pieces[arm.piece];
        const double delta = spread(piece), A = piece.area, R = arm.resistance;
        const PairTwist<D> none = PairTwist<D>::Zero();
        PairTwist<D> y = none; // of the loads
        GapRates<D> rates;
        if (!gaps_.loads.empty()) {
            y = gaps_.loads[number].twist;
            by.resistance += gaps_.loads[number].loss / (R * R);
        }
        if (const PairMass<D> M = weight_of(arm); !M.isZero(0)) {
            const PairTwist<D> by_motion = M * arm.motion;
            const double square = by_motion.dot(arm.motion);
            GapLoads of_flux;
            of_flux.motion = -delta / R;
            rates += gaps_.derivatives->of(number, M * arm.flux, of_flux);
            rates.area -= 0.5 * delta * square;
            by.resistance -= 0.5 * delta * delta / (R * R) * square;
            y += delta * by_motion;
        }
        if (!y.isZero(0)) {
            const double U = arm.motion.dot(y);
            GapLoads of_load;
            of_load.flux = -1 / R;
            of_load.motion = A - delta / R;
            rates += gaps_.derivatives->of(number, y, of_load);
            rates.area += U;
            by.resistance += (arm.flux.dot(y) + delta * U) / (R * R);
        }
        return rates;
    }
    /// M of the pair of an arm.
    PairMass<D> weight_of(const GapArm<D>& arm) const
    {
        constexpr int T = twist_size<D>;
        const std::pair<std::int32_t, std::int32_t> pair = std::minmax(arm.solid[0], arm.solid[1]);
        const auto found = std::lower_bound(gaps_.motion.begin(), gaps_.motion.end(), pair,
                                            [](const auto& of, const auto& p) { return std::pair(of.a, of.b) < p; });
        if (found == gaps_.motion.end() || std::pair(found->a, found->b) != pair)
            return PairMass<D>::Zero();
        const PairMass<D>& weight = found->weight;
        if (arm.solid[0] == pair.first)
            return weight;
        PairMass<D> swapped;
        swapped << weight.template bottomRightCorner<T, T>(), weight.template bottomLeftCorner<T, T>(),
            weight.template topRightCorner<T, T>(), weight.template topLeftCorner<T, T>();
        return swapped;
    }

    /// What a layer's inertia has in the arms.
    void add_loads(double weight, std::vector<LayerLoad<D>>& loads) const
    {
        loads.resize(gaps_.arms().size());
        for (std::size_t k = 0; k < loads.size(); ++k) {
            const GapArm<D>& arm = gaps_.arms()[k];
            const FacePiece<D>& piece = complex_.pieces[arm.piece];
            if (owns(arm)) {
                loads[k].twist += weight * (q_of(piece.low) - q_of(piece.high)) * pair_twist(arm);
                loads[k].loss += weight * loss(piece.low, piece.high, 0);
            }
            loads[k].plain += weight * by_plain_[arm.piece];
        }
    }

    Vec<D> face_centre(const FacePiece<D>& piece) const
    {
        const Index<D> face = complex_.index.index(piece.face);
        Vec<D> centre;
        for (int axis = 0; axis < D; ++axis) {
            const double place = axis == piece.axis ? grid_.face_place(axis, face[axis]) : grid_.centre_place(axis, face[axis]);
            centre[axis] = (place - grid_.anchor()[axis]) / grid_.dx();
        }
        return centre;
    }

    /// All that depends on areas and first moments, and the walls' by closure.
    void by_motion_of_pieces()
    {
        for (std::size_t k = 0; k < complex_.pieces.size(); ++k) {
            const FacePiece<D>& piece = complex_.pieces[k];
            const Vec<D> centre = face_centre(piece);
            const bool turns = circulation_ && piece.low.exists() && piece.high.exists() &&
                               owns_face(grid_, piece.axis, complex_.index.index(piece.face));
            for (const PieceRate<D>& rate : derivatives_.of(k)) {
                double by_area = by_area_[k];
                Vec<D> by_moment = by_moment_[k];
                if (turns) { // what the solid covers more is open less
                    const Twist<D> of =
                        spread(piece) * circulation_->face[piece.axis][piece.face] * circulation_->covered[rate.solid];
                    const Vec<D> turn = turned<D>(of.template tail<spin_size<D>>(), piece.axis);
                    by_area += of[piece.axis] + turn.dot(centre - rate.reference);
                    by_moment += turn;
                }
                for (const auto& [side, out] : {std::pair{piece.low, 1.0}, {piece.high, -1.0}})
                    if (const int patch = patch_of(side, rate.solid); patch >= 0) {
                        const Vec<D> turn = out * turned<D>(by_patch_[patch].template tail<spin_size<D>>(), piece.axis);
                        by_area -= out * by_patch_[patch][piece.axis] + turn.dot(centre - rate.reference);
                        by_moment -= turn;
                    }
                result_[rate.solid] += by_area * rate.area + rate.moment.transpose() * by_moment;
            }
        }
    }

    int patch_of(const PartOrCell& side, int solid) const
    {
        if (side.is_part())
            for (int k = complex_.first_patch[side.number()]; k < complex_.first_patch[side.number() + 1]; ++k)
                if (complex_.patches[k].solid == solid)
                    return k;
        return -1;
    }

    /// Their reference points, and the curves in which they meet.
    void by_motion_of_walls()
    {
        for (std::size_t k = 0; k < complex_.patches.size(); ++k) {
            const WallPatch<D>& patch = complex_.patches[k];
            const Spin<D> by_turn = by_patch_[k].template tail<spin_size<D>>();
            for (int axis = 0; axis < D; ++axis)
                result_[patch.solid][axis] -= moment<D>(unit<D>(axis), patch.area).dot(by_turn);
        }
        for (const PatchRate<D>& rate : derivatives_.patches)
            result_[rate.solid] += rate.flux.transpose() * by_patch_[rate.patch];
    }

    void by_motion_of_links()
    {
        for (const LinkRate<D>& rate : derivatives_.links) {
            const CornerLink<D>& link = complex_.links[rate.link];
            if (owns(link.a))
                result_[rate.solid] -= loss(PartOrCell::part(link.a), PartOrCell::part(link.b),
                                            circulation_ ? circulation_->link[rate.link] : 0.0) *
                                       rate.conductance;
            result_[rate.solid] += by_link_[rate.link] * rate.conductance; // what areas of this rank's faces it joins
        }
    }

    void add_seen_volume(std::span<const std::vector<WeightedTwist<D>>> seen)
    {
        const GridPlanes<D> planes(grid_);
        struct Walls {
            Vec<D> by, reference;
        };
        std::vector<Walls> walls(result_.size(), {Vec<D>::Zero(), Vec<D>::Zero()}); // one rank sees a solid
        for (std::size_t s = 0; s < result_.size(); ++s) {
            for (const WeightedTwist<D>& of : seen[s]) {
                const SeenEnergyRate<D> rate = half_square_rate<D>(derivatives_.seen[s], of.z);
                result_[s] += of.weight * rate.by_place;
                walls[s].by += of.weight * rate.by_walls;
            }
            walls[s].reference = derivatives_.seen[s].reference;
        }
        if (!walls.empty())
            grid_.comm().sum(std::span<double>(walls.data()->by.data(), 2 * D * walls.size()));
        for (int part = 0; part < complex_.parts(); ++part)
            for (int k = complex_.first_patch[part]; k < complex_.first_patch[part + 1] && owns(part); ++k) {
                const Walls& of = walls[complex_.patches[k].solid];
                by_patch_[k].template head<D>() +=
                    of.by.cwiseProduct(way_from<D>(grid_, planes, of.reference, complex_.cell_of_part(part)));
            }
    }

    const Grid<D>& grid_;
    const Complex<D>& complex_;
    const FaceDerivatives<D>& derivatives_;
    const Potentials<D>&p_, &next_;
    std::span<const Twist<D>> twists_;
    const DerivedGaps<D>& gaps_;
    const Circulation<D>* circulation_;
    OpenAreas<D> areas_;
    // Of each piece, where there are gaps: what of its energy is not a gap's, dE by it, and whether there is one.
    std::vector<double> plain_, by_plain_;
    std::vector<char> is_gap_;
    int axis_ = 0; ///< of the face that lends
    // dE by areas, first moments and walls.
    std::vector<double> by_area_;
    std::vector<Vec<D>> by_moment_;
    std::vector<Twist<D>> by_patch_;
    std::vector<double> by_link_; ///< by the conductance, of what it joins
    std::vector<Twist<D>> result_;
};

} // namespace

template <int D>
std::vector<Twist<D>> energy_derivative(const Grid<D>& grid, const Complex<D>& complex, const FaceDerivatives<D>& derivatives,
                                        const Potentials<D>& potentials, std::span<const Twist<D>> twists,
                                        std::span<const std::vector<WeightedTwist<D>>> seen, const DerivedGaps<D>& gaps,
                                        const Circulation<D>* circulation)
{
    const Potentials<D> none{std::vector<double>(complex.parts(), 0), std::vector<double>(complex.index.count, 0)};
    return EnergyDerivative<D>(grid, complex, derivatives, potentials, none, twists, gaps, circulation).find(seen);
}

template <int D>
std::vector<Twist<D>> layer_derivative(const Grid<D>& grid, const Complex<D>& complex, const FaceDerivatives<D>& derivatives,
                                       const Potentials<D>& step, const Potentials<D>& next, int solid,
                                       const WeightedTwist<D>& of, DerivedGaps<D>& gaps)
{
    std::vector<Twist<D>> twists(complex.seen_mass.size(), Twist<D>::Zero());
    twists[solid] = of.z;
    return EnergyDerivative<D>(grid, complex, derivatives, step, next, twists, gaps, nullptr).of_layer(of.weight, gaps.loads);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<Twist<D>> energy_derivative(                                                                          \
        const Grid<D>&, const Complex<D>&, const FaceDerivatives<D>&, const Potentials<D>&, std::span<const Twist<D>>,         \
        std::span<const std::vector<WeightedTwist<D>>>, const DerivedGaps<D>&, const Circulation<D>*);                         \
    template std::vector<Twist<D>> layer_derivative(const Grid<D>&, const Complex<D>&, const FaceDerivatives<D>&,              \
                                                    const Potentials<D>&, const Potentials<D>&, int, const WeightedTwist<D>&,  \
                                                    DerivedGaps<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
