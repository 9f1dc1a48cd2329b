#include "gapflow/complex/inertia.hpp"

#include "gapflow/complex/corner_faces.hpp"
#include "gapflow/complex/lending.hpp"
#include "gapflow/complex/parameters.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/grid/field.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace gapflow {
namespace {

/// Flux of a solid's twist that lending adds to a row: the largest part of a cell, or another part of it.
template <int D>
struct LentRow {
    std::int32_t part; ///< -1: the largest, or the whole cell
    std::int32_t solid, cell;
    std::int32_t next; ///< of the same cell; -1: none
    Twist<D> flux;
};

/// Lends from the faces of some planes. Reaches two planes further on either side.
template <int D>
class Lending {
public:
    using Area = typename OpenAreas<D>::Area;

    /// `first_row`: workspace, of each cell; so far -1. `plain`: of each piece the share of its energy that is not a gap's; empty: all of it.
    Lending(const Grid<D>& grid, const Complex<D>& complex, const OpenAreas<D>& areas, std::vector<std::int32_t>& first_row,
            const std::vector<double>& plain, Inertia<D>& inertia, std::vector<FaceFlux<D>>* face_flux)
        : lenders_(lenders(grid, complex.index)), complex_(complex), areas_(areas), first_row_(first_row), plain_(plain),
          inertia_(inertia), face_flux_(face_flux), loans_(grid, complex, areas)
    {
    }

    /// Faces that lend to faces beside a rank's own cells.
    static Block<D> lenders(const Grid<D>& grid, const DenseIndex<D>& index)
    {
        const Index<D> reach = Index<D>::Constant(2);
        return {(grid.low() - reach).cwiseMax(index.low), (grid.high() + reach).cwiseMin(index.high())};
    }

    /// To the weights and to the fluxes of Complex::patches; returns the rows beside these.
    std::vector<LentRow<D>> lend(int begin, int end)
    {
        const DenseIndex<D>& index = complex_.index;
        Index<D> low = lenders_.low, high = lenders_.high;
        low[D - 1] = begin;
        high[D - 1] = end;
        for_each_row<D>(low, high, [&](const Index<D>& row) {
            for (axis_ = 0; axis_ < D; ++axis_) {
                const int i = row[axis_];
                below_ = (index.wraps[axis_] && i == index.low[axis_] ? index.size[axis_] - 2 : -1) * index.stride[axis_];
                Index<D> f = row;
                for (int face = index(row); f[0] < high[0]; ++f[0], ++face) {
                    for (std::int32_t k = areas_.first(axis_, face); k >= 0; k = areas_.next(k))
                        lend_from(k, f);
                    if (axis_ == 0)
                        below_ = -1;
                }
            }
        });
        move_to_patches();
        return std::move(rows_);
    }

private:
    /// The integral over the levels up to which corners' links join areas.
    void lend_from(std::int32_t k, const Index<D>& f)
    {
        areas_.find_levels(k, levels_);
        JoinLevel level;
        for (std::size_t i = 0; i <= levels_.size(); ++i) {
            const double share = (i < levels_.size() ? levels_[i].share : 1.0) - std::max(0.0, level.share);
            if (share > 0)
                lend_from(k, f, level, share);
            if (i < levels_.size())
                level = levels_[i];
        }
    }

    void lend_from(std::int32_t k, const Index<D>& f, const JoinLevel& level, double share)
    {
        double given = 0;
        Area own;
        loans_.from(k, f, level, [&](Loan<D> loan) {
            loan.size *= share * plain(loan.own) * plain(loan.next);
            loan.more *= share * plain(loan.own) * plain(loan.next) * plain(loan.after);
            own = loan.own;
            given += loan.given();
            add(loan.next, loan.of_next());
            if (loan.more > 0)
                add(loan.after, loan.of_after());
        });
        if (given > 0)
            add(own, -given);
    }

    double plain(const Area& area) const
    {
        if (plain_.empty() || area.face < 0)
            return 1;
        const std::int32_t k = area.piece >= 0 ? area.piece : areas_.first(axis_, area.face);
        return k >= 0 ? plain_[k] : 1.0;
    }

    void add(const Area& to, double area)
    {
        if (to.piece < 0) {
            inertia_.main_weight[axis_][to.face] += area;
            record(to.face, -1, area);
            add_to_row(-1, to.face, area);
            add_to_row(-1, to.face + below_, -area);
            return;
        }
        const auto other_part = [&](const PartOrCell& side) { return complex_.is_main(side) ? -1 : side.number(); };
        areas_.for_each(to, [&](std::int32_t k) {
            const FacePiece<D>& piece = complex_.pieces[k];
            const double share = area * (piece.area / to.area);
            inertia_.piece_weight[k] += share;
            if (complex_.joins_main(piece))
                inertia_.main_weight[axis_][to.face] += share;
            record(to.face, complex_.joins_main(piece) ? -1 : k, share);
            add_to_row(other_part(piece.high), to.face, share);
            add_to_row(other_part(piece.low), to.face + below_, -share);
        });
    }

    void record(std::int32_t face, std::int32_t piece, double area)
    {
        if (!face_flux_)
            return;
        for (const MovingShare<D>& share : loans_.shares()) {
            FaceFlux<D> of{static_cast<std::int8_t>(axis_), face, piece, -1, share.solid, Twist<D>::Zero()};
            of.flux[axis_] = -area * share.size;
            of.flux.template tail<spin_size<D>>() = -area * share.spin;
            face_flux_->push_back(of);
        }
    }

    void add_to_row(std::int32_t part, int cell, double area)
    {
        for (const MovingShare<D>& share : loans_.shares()) {
            std::int32_t* at = &first_row_[cell];
            while (*at >= 0 && (rows_[*at].solid != share.solid || rows_[*at].part != part))
                at = &rows_[*at].next;
            if (*at < 0) {
                *at = static_cast<std::int32_t>(rows_.size());
                rows_.push_back({part, share.solid, cell, -1, Twist<D>::Zero()});
                at = &first_row_[cell];
                while (rows_[*at].solid != share.solid || rows_[*at].part != part)
                    at = &rows_[*at].next;
            }
            Twist<D>& flux = rows_[*at].flux;
            flux[axis_] += area * share.size;
            flux.template tail<spin_size<D>>() += area * share.spin;
        }
    }

    void move_to_patches()
    {
        std::size_t left = 0;
        for (LentRow<D>& row : rows_) {
            const PartOrCell at = row.part >= 0 ? PartOrCell::part(row.part) : complex_.main_of(row.cell);
            int k = at.is_part() ? complex_.first_patch[at.number()] : 0;
            const int end = at.is_part() ? complex_.first_patch[at.number() + 1] : 0;
            while (k < end && complex_.patches[k].solid != row.solid)
                ++k;
            if (k < end)
                inertia_.patch_flux[k] += row.flux;
            else
                rows_[left++] = row;
        }
        rows_.resize(left);
    }

    const Block<D> lenders_;
    const Complex<D>& complex_;
    const OpenAreas<D>& areas_;
    std::vector<std::int32_t>& first_row_;
    const std::vector<double>& plain_;
    Inertia<D>& inertia_;
    std::vector<FaceFlux<D>>* face_flux_;
    Loans<D> loans_;
    int axis_ = 0;  ///< of the face that lends
    int below_ = 0; ///< number of the cell below it less that of the one above it
    JoinLevels levels_;
    std::vector<LentRow<D>> rows_;
};

/// Planes in slabs, first all even ones, then all odd ones: those of one time reach no common cell, and sums are the same for any number of threads.
template <int D>
void lend(const Grid<D>& grid, const Complex<D>& complex, const OpenAreas<D>& areas, const std::vector<double>& plain,
          bool face_flux, Inertia<D>& inertia)
{
    const Block<D> lenders = Lending<D>::lenders(grid, complex.index);
    const int first = lenders.low[D - 1], n = lenders.high[D - 1] - first, slabs = std::max(1, n / (2 * parameters.slab) * 2);
    std::vector<std::vector<LentRow<D>>> rows(slabs);
    std::vector<std::vector<FaceFlux<D>>> through(slabs);
    for (int odd = 0; odd < 2; ++odd) {
        std::vector<std::int32_t> first_row(complex.index.count, -1);
        for_each_job((slabs + 1 - odd) / 2, [&](int k) {
            const int s = 2 * k + odd;
            rows[s] = Lending<D>(grid, complex, areas, first_row, plain, inertia, face_flux ? &through[s] : nullptr)
                          .lend(first + n * s / slabs, first + n * (s + 1) / slabs);
        });
    }
    for_each_part(static_cast<long>(complex.pieces.size()), [&](long begin, long end) {
        for (long k = begin; k < end; ++k)
            if (const FacePiece<D>& piece = complex.pieces[k]; areas.plain(piece.axis, piece.face))
                inertia.piece_weight[k] = inertia.main_weight[piece.axis][piece.face];
            else
                inertia.piece_weight[k] += piece.area;
    });
    for (const auto& list : through)
        inertia.face_flux.insert(inertia.face_flux.end(), list.begin(), list.end());
    std::vector<std::size_t> offset{0};
    for (const auto& list : rows)
        offset.push_back(offset.back() + list.size());
    inertia.flux.resize(offset.back());
    for_each_job(slabs, [&](int s) {
        std::size_t k = offset[s];
        for (const LentRow<D>& row : rows[s])
            inertia.flux[k++] = {row.part >= 0 ? PartOrCell::part(row.part) : complex.main_of(row.cell), row.solid, row.flux};
    });
}

/// To the flux of a solid's twist out of a part or cell.
template <int D>
void add_flux(const Complex<D>& complex, const PartOrCell& row, std::int32_t solid, const Twist<D>& flux, Inertia<D>& inertia)
{
    if (flux.isZero(0))
        return;
    if (row.is_part())
        for (int k = complex.first_patch[row.number()]; k < complex.first_patch[row.number() + 1]; ++k)
            if (complex.patches[k].solid == solid) {
                inertia.patch_flux[k] += flux;
                return;
            }
    inertia.flux.push_back({row, solid, flux});
}

/// The singular flow around corners, relative to their solids.
template <int D>
void add_corners(const Grid<D>& grid, const Complex<D>& complex, const OpenAreas<D>& areas, bool face_flux, Inertia<D>& inertia)
{
    const CornerFaces<D> faces(grid, complex, areas);
    for (const auto& corner : complex.corners)
        faces.for_each(corner, [&](const CornerFace<D>& face) {
            for (const CornerPiece<D>& of : face.pieces) {
                const double added = face.added * of.open / face.all_open;
                const bool main = of.piece < 0 || complex.joins_main(complex.pieces[of.piece]);
                if (of.piece >= 0)
                    inertia.piece_weight[of.piece] += added;
                if (main)
                    inertia.main_weight[face.axis][face.face] += added;
                const Twist<D> flux = added * face.motion;
                add_flux<D>(complex, of.high, corner.solid, flux, inertia);
                add_flux<D>(complex, of.low, corner.solid, -flux, inertia);
                if (face_flux)
                    inertia.face_flux.push_back({face.axis, face.face, main ? -1 : of.piece, -1, corner.solid, -flux});
            }
        });
}

/// Another arm takes its place.
template <int D>
void remove_piece(const Complex<D>& complex, std::int32_t number, Inertia<D>& inertia)
{
    const FacePiece<D>& piece = complex.pieces[number];
    if (complex.joins_main(piece))
        inertia.main_weight[piece.axis][piece.face] -= inertia.piece_weight[number];
    inertia.piece_weight[number] = 0;
}

/// Replaces the energies of faces in gaps and of links in their mouths.
template <int D>
void add_gaps(const Grid<D>& grid, const Complex<D>& complex, std::span<const GapArm<D>> gaps,
              std::span<const MouthArm<D>> mouths, bool face_flux, Inertia<D>& inertia)
{
    constexpr int T = twist_size<D>;
    const auto add_row = [&](const PartOrCell& row, std::int32_t solid, const Twist<D>& flux) {
        add_flux<D>(complex, row, solid, flux, inertia);
    };
    const auto record = [&](const FacePiece<D>* piece, std::int32_t number, std::int32_t mouth, std::int32_t solid,
                            const Twist<D>& flux) {
        if (!face_flux || flux.isZero(0))
            return;
        if (piece)
            inertia.face_flux.push_back({piece->axis, piece->face, complex.joins_main(*piece) ? -1 : number, -1, solid, flux});
        else
            inertia.face_flux.push_back({0, -1, -1, mouth, solid, flux});
    };
    std::vector<std::int32_t> in_mouths;
    for (const MouthArm<D>& mouth : mouths)
        if (mouth.piece >= 0)
            in_mouths.push_back(mouth.piece);
    std::sort(in_mouths.begin(), in_mouths.end());
    inertia.pairs.reserve(gaps.size() + mouths.size());
    for (const GapArm<D>& gap : gaps) {
        if (std::binary_search(in_mouths.begin(), in_mouths.end(), gap.piece))
            continue;
        const FacePiece<D>& piece = complex.pieces[gap.piece];
        const Index<D> f = complex.index.index(piece.face);
        // Of what others take from its area it gives all but a twentieth of what it is: the weight stays positive. The derivative does not know that.
        const double delta = grid.spread(piece.axis, f[piece.axis]), a = delta / gap.resistance,
                     lent = inertia.piece_weight[gap.piece] - piece.area,
                     change = a - piece.area + std::max(0.0, -0.95 * a - lent);
        inertia.piece_weight[gap.piece] += change;
        if (complex.joins_main(piece))
            inertia.main_weight[piece.axis][piece.face] += change;
        const PairTwist<D> flux = -gap.flux / gap.resistance - change * gap.motion, cross = -a * gap.flux;
        for (int side = 0; side < 2; ++side) {
            record(&piece, gap.piece, -1, gap.solid[side], flux.template segment<T>(side * T));
            add_row(piece.low, gap.solid[side], flux.template segment<T>(side * T));
            add_row(piece.high, gap.solid[side], -flux.template segment<T>(side * T));
        }
        if (!owns_face(grid, piece.axis, f)) // its mass is another rank's
            continue;
        const PairMass<D> motion = cross * gap.motion.transpose() + gap.motion * cross.transpose() -
                                   change * delta * gap.motion * gap.motion.transpose();
        inertia.pairs.push_back(
            {gap.solid[0], gap.solid[1], gap.mass - gap.flux * gap.flux.transpose() / gap.resistance + motion, motion});
    }
    for (const MouthArm<D>& mouth : mouths) {
        if (mouth.link >= 0)
            inertia.link_conductance[mouth.link] = 0;
        else
            remove_piece(complex, mouth.piece, inertia);
        if (!(mouth.resistance > 0))
            continue;
        const PartOrCell& first =
            mouth.link >= 0 ? PartOrCell::part(complex.links[mouth.link].a) : complex.pieces[mouth.piece].high;
        inertia.mouths.push_back({first, 1 / mouth.resistance, mouth.rows});
        for (int side = 0; side < 2; ++side) {
            record(nullptr, -1, static_cast<std::int32_t>(inertia.mouths.size()) - 1, mouth.solid[side],
                   Twist<D>(-1 / mouth.resistance * mouth.flux.template segment<T>(side * T)));
            for (const auto& [row, weight] : mouth.rows)
                add_row(row, mouth.solid[side],
                        Twist<D>(-weight / mouth.resistance * mouth.flux.template segment<T>(side * T)));
            const Twist<D> carried = mouth.carried.template segment<T>(side * T);
            if (mouth.piece >= 0)
                record(&complex.pieces[mouth.piece], mouth.piece, -1, mouth.solid[side], carried);
            const auto [from, to] =
                mouth.piece >= 0
                    ? std::pair(complex.pieces[mouth.piece].low, complex.pieces[mouth.piece].high)
                    : std::pair(PartOrCell::part(complex.links[mouth.link].a), PartOrCell::part(complex.links[mouth.link].b));
            add_row(from, mouth.solid[side], carried);
            add_row(to, mouth.solid[side], -carried);
        }
        if (grid.owns(complex.index.index(complex.cell_of(first))))
            inertia.pairs.push_back({mouth.solid[0], mouth.solid[1], mouth.mass, mouth.motion});
    }
    for (PairInertia<D>& pair : inertia.pairs)
        if (pair.a > pair.b) {
            std::swap(pair.a, pair.b);
            for (PairMass<D>* mass : {&pair.mass, &pair.motion}) {
                PairMass<D> turned;
                turned << mass->template bottomRightCorner<T, T>(), mass->template bottomLeftCorner<T, T>(),
                    mass->template topRightCorner<T, T>(), mass->template topLeftCorner<T, T>();
                *mass = turned;
            }
        }
    merge_pairs(inertia.pairs);
}

} // namespace

template <int D>
void merge_pairs(std::vector<PairInertia<D>>& pairs)
{
    std::vector<std::size_t> order(pairs.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
        const PairInertia<D>&p = pairs[x], &q = pairs[y];
        return std::tie(p.a, p.b, x) < std::tie(q.a, q.b, y);
    });
    std::vector<PairInertia<D>> sums;
    for (const std::size_t k : order) {
        const PairInertia<D>& pair = pairs[k];
        if (sums.empty() || sums.back().a != pair.a || sums.back().b != pair.b)
            sums.push_back(pair);
        else {
            sums.back().mass += pair.mass;
            sums.back().motion += pair.motion;
        }
    }
    pairs = std::move(sums);
}

template <int D>
Inertia<D> find_inertia(const Grid<D>& grid, const Complex<D>& complex, std::span<const GapArm<D>> gaps,
                        std::span<const MouthArm<D>> mouths, bool face_flux)
{
    Inertia<D> inertia;
    inertia.main_weight = complex.main_area;
    inertia.piece_weight.resize(complex.pieces.size());
    inertia.patch_flux.resize(complex.patches.size());
    for_each_part(static_cast<long>(complex.patches.size()), [&](long begin, long end) {
        for (long k = begin; k < end; ++k)
            inertia.patch_flux[k] << complex.patches[k].area, complex.patches[k].moment;
    });
    for (const CornerLink<D>& link : complex.links)
        inertia.link_conductance.push_back(link.conductance);
    std::vector<double> plain(gaps.empty() && mouths.empty() ? 0 : complex.pieces.size(), 1.0);
    for (const GapArm<D>& gap : gaps)
        plain[gap.piece] = 1 - gap.share;
    for (const MouthArm<D>& mouth : mouths)
        if (mouth.piece >= 0)
            plain[mouth.piece] = 0;
    const OpenAreas<D> areas(complex);
    lend(grid, complex, areas, plain, face_flux, inertia);
    add_gaps(grid, complex, gaps, mouths, face_flux, inertia);
    add_corners(grid, complex, areas, face_flux, inertia);
    return inertia;
}

template <int D>
long Inertia<D>::bytes() const
{
    const auto of = [](const auto& v) { return static_cast<long>(v.capacity() * sizeof(v[0])); };
    long sum = of(piece_weight) + of(link_conductance) + of(patch_flux) + of(flux) + of(pairs) + of(face_flux);
    for (const std::vector<double>& weight : main_weight)
        sum += of(weight);
    return sum;
}

template void merge_pairs(std::vector<PairInertia<2>>&);
template void merge_pairs(std::vector<PairInertia<3>>&);
template struct Inertia<2>;
template struct Inertia<3>;
template Inertia<2> find_inertia(const Grid<2>&, const Complex<2>&, std::span<const GapArm<2>>, std::span<const MouthArm<2>>,
                                 bool);
template Inertia<3> find_inertia(const Grid<3>&, const Complex<3>&, std::span<const GapArm<3>>, std::span<const MouthArm<3>>,
                                 bool);

} // namespace gapflow
