#include "gapflow/step/covered.hpp"

#include "gapflow/step/inner_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gapflow {
namespace {

template <int D>
bool is_ball(const Solid<D>& solid)
{
    const std::vector<Core<D>> cores = solid.shape.shape().cores();
    return cores.size() == 1 && cores[0].from == cores[0].to &&
           (solid.shape.to_world(cores[0].from) - solid.centre).norm() <= 1e-12 * cores[0].radius;
}

/// Pieces of the complex by their faces.
template <int D>
class PiecesOfFaces {
public:
    explicit PiecesOfFaces(const Complex<D>& complex) : complex_(complex), next_(complex.pieces.size(), -1)
    {
        for (auto& of : first_)
            of.assign(complex.index.count, -1);
        for (std::size_t k = 0; k < complex.pieces.size(); ++k) {
            std::int32_t& first = first_[complex.pieces[k].axis][complex.pieces[k].face];
            next_[k] = std::exchange(first, static_cast<std::int32_t>(k));
        }
    }
    bool any(int axis, int face) const { return first_[axis][face] >= 0; }
    template <class F>
    void for_each(int axis, int face, const F& f) const
    {
        for (std::int32_t k = first_[axis][face]; k >= 0; k = next_[k])
            f(complex_.pieces[k]);
    }

private:
    const Complex<D>& complex_;
    std::array<std::vector<std::int32_t>, D> first_;
    std::vector<std::int32_t> next_;
};

/// What one solid covers of a face, and its first moment about the face's centre; lengths in cells.
template <int D>
struct Covered {
    const SolidPart<D>* by;
    double area;
    Vec<D> moment;
};

/// Finds what solids cover of faces: what the pieces of the complex leave of them, which the clipper shares out.
template <int D>
class CoveredParts {
public:
    explicit CoveredParts(const Placed<D>& at) : at_(at), grid_(*at.coupling.grid), pieces_(at.complex) {}

    const std::vector<Covered<D>>& of(int axis, const Index<D>& f)
    {
        parts_.clear();
        const int number = at_.complex.index(at_.complex.index.wrapped(f));
        if (!pieces_.any(axis, number) && at_.complex.main_area[axis][number] > 0)
            return parts_; // wholly open
        centre_ = in_cells(grid_.face_centre(axis, f));
        double area = grid_.relative_area(axis, f);
        Vec<D> moment = Vec<D>::Zero();
        pieces_.for_each(axis, number, [&](const FacePiece<D>& piece) {
            area -= piece.area;
            moment -= piece.area * (piece.centroid - centre_);
        });
        if (!(area > 0))
            return parts_;
        at_.coupling.clipper->clip(axis, f, clipped_);
        if (clipped_.solid.size() == 1)
            parts_.push_back({&*clipped_.solid.begin(), area, moment});
        else if constexpr (D == 2)
            add_stretches(axis, number, grid_.relative_area(axis, f));
        else
            share_out(area, [](const SolidPart<D>&) { return true; });
        return parts_;
    }

private:
    Vec<D> in_cells(const Vec<D>& x) const { return (x - grid_.anchor()) / grid_.dx(); }

    /// An area among the solids that `counts`, as the clipper has theirs.
    template <class Counts>
    void share_out(double area, const Counts& counts)
    {
        double all = 0;
        for (const SolidPart<D>& part : clipped_.solid)
            all += counts(part) ? part.fraction : 0.0;
        for (const SolidPart<D>& part : clipped_.solid)
            if (counts(part) && part.fraction > 0) {
                const double own = area * part.fraction / all;
                parts_.push_back({&part, own, own * (in_cells(part.centroid) - centre_)});
            }
    }

    /// The stretches between the pieces, most of them of one solid.
    void add_stretches(int axis, int number, double length)
    {
        const int along = 1 - axis;
        std::vector<std::array<double, 2>> open;
        pieces_.for_each(axis, number, [&](const FacePiece<D>& piece) {
            open.push_back({piece.centroid[along] - 0.5 * piece.area, piece.centroid[along] + 0.5 * piece.area});
        });
        const double end = centre_[along] + 0.5 * length;
        open.push_back({end, end});
        std::sort(open.begin(), open.end());
        double from = centre_[along] - 0.5 * length;
        for (const auto& [low, high] : open) {
            const double to = low, middle = 0.5 * (from + to);
            const auto within = [&](const SolidPart<D>& part) {
                return std::abs(in_cells(part.centroid)[along] - middle) <= 0.5 * (to - from);
            };
            const std::size_t before = parts_.size();
            if (to > from)
                share_out(to - from, within);
            if (parts_.size() == before + 1) {
                parts_.back().moment.setZero();
                parts_.back().moment[along] = (to - from) * (middle - centre_[along]);
            }
            from = std::max(from, high);
        }
    }

    const Placed<D>& at_;
    const Grid<D>& grid_;
    PiecesOfFaces<D> pieces_;
    ClippedFace<D> clipped_;
    Vec<D> centre_ = Vec<D>::Zero();
    std::vector<Covered<D>> parts_;
};

} // namespace

template <int D>
Twist<D> moving_walls(const Solid<D>& solid, Twist<D> twist)
{
    if (is_ball(solid))
        twist.template tail<spin_size<D>>().setZero();
    return twist;
}

template <int D>
std::vector<CarriedFlux<D>> covered_fluxes(const Placed<D>& at)
{
    const Grid<D>& grid = *at.coupling.grid;
    std::vector<char> ball;
    for (const Solid<D>& solid : at.coupling.solids)
        ball.push_back(is_ball(solid));
    CoveredParts<D> parts(at);
    std::vector<CarriedFlux<D>> result;
    for (int axis = 0; axis < D; ++axis)
        for_each_index<D>(grid.low(), owned_faces_end(grid, axis), [&](const Index<D>& f) {
            if (!is_inner(grid, axis, f))
                return;
            for (const Covered<D>& of : parts.of(axis, f)) {
                Twist<D> flux = Twist<D>::Zero();
                flux[axis] = of.area;
                if (!ball[of.by->solid]) {
                    const Vec<D> centre_from_solid = of.by->arm - of.by->centroid + grid.face_centre(axis, f);
                    flux.template tail<spin_size<D>>() =
                        moment<D>(Vec<D>(grid.dx() * of.moment + of.area * centre_from_solid), unit<D>(axis));
                }
                result.push_back({axis, f, -1, of.by->solid, grid.face_area() * flux});
            }
        });
    return result;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template Twist<D> moving_walls<D>(const Solid<D>&, Twist<D>);                                                              \
    template std::vector<CarriedFlux<D>> covered_fluxes<D>(const Placed<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
