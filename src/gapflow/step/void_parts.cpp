#include "gapflow/step/void_parts.hpp"

#include "gapflow/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace gapflow {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double touching = 1e-6; // in dx: at the start a gap within this of the held distance is closed
constexpr double whole = 1e-12;   // by which a share may differ from one

/// What is known of a part from its faces.
struct Faces {
    bool gap = true;                ///< all of them
    double area = 0, thickness = 0; ///< the sum over arms, and weighted by their areas
    double mouth = 0;               ///< thickness at one
    std::map<std::pair<int, int>, double> pairs;
};

template <int D>
std::vector<Faces> faces_of_parts(const Grid<D>& grid, const Complex<D>& complex, const std::vector<GapArm<D>>& arms,
                                  const std::vector<MouthArm<D>>& mouths)
{
    std::vector<Faces> faces(complex.parts());
    std::vector<const GapArm<D>*> arm(complex.pieces.size(), nullptr);
    std::vector<const MouthArm<D>*> at_piece(complex.pieces.size(), nullptr), at_link(complex.links.size(), nullptr);
    for (const GapArm<D>& a : arms)
        arm[a.piece] = &a;
    for (const MouthArm<D>& m : mouths)
        (m.piece >= 0 ? at_piece[m.piece] : at_link[m.link]) = &m;
    const auto add_mouth = [&](std::int32_t part, const MouthArm<D>& m, double thickness) {
        faces[part].mouth = thickness;
        faces[part].pairs.try_emplace(std::minmax(m.solid[0], m.solid[1]), 0.0);
    };
    std::vector<std::size_t> plain; // pieces
    for (std::size_t k = 0; k < complex.pieces.size(); ++k) {
        const FacePiece<D>& piece = complex.pieces[k];
        if (!is_way_out(grid, piece))
            continue;
        if (!at_piece[k] && !(arm[k] && arm[k]->share > 1 - whole))
            plain.push_back(k);
        for (const PartOrCell& side : {piece.low, piece.high}) {
            if (!side.is_part())
                continue;
            Faces& of = faces[side.number()];
            if (at_piece[k])
                add_mouth(side.number(), *at_piece[k], arm[k] ? arm[k]->thickness : piece.area);
            else if (plain.empty() || plain.back() != k) {
                of.area += piece.area;
                of.thickness += piece.area * arm[k]->thickness;
                of.pairs[std::minmax(arm[k]->solid[0], arm[k]->solid[1])] += piece.area;
            }
        }
    }
    for (std::size_t k = 0; k < complex.links.size(); ++k)
        for (const std::int32_t part : {complex.links[k].a, complex.links[k].b})
            if (at_link[k])
                add_mouth(part, *at_link[k], complex.mouths[complex.links[k].mouth].length);
            else if (complex.links[k].conductance > 0)
                faces[part].gap = false;
    for (Faces& of : faces)
        of.gap = of.gap && !of.pairs.empty();
    // A plane of the grid may divide a gap along it: plain faces between two parts of it. Those that lead elsewhere are its ends.
    const auto in_gap = [&](const PartOrCell& side) { return side.is_part() && faces[side.number()].gap; };
    for (bool again = true; again;) {
        again = false;
        for (const std::size_t k : plain)
            for (const auto& [side, other] : {std::pair(complex.pieces[k].low, complex.pieces[k].high),
                                              std::pair(complex.pieces[k].high, complex.pieces[k].low)})
                if (in_gap(side) && !in_gap(other)) {
                    faces[side.number()].gap = false;
                    again = true;
                }
    }
    return faces;
}

/// Half of the walls of both solids; a side of the domain has none.
template <int D>
double wall_area(const Grid<D>& grid, const std::vector<Solid<D>>& solids, const Complex<D>& complex, const VoidPart<D>& of)
{
    double sum = 0;
    for (const WallPatch<D>& patch : complex.patches_of(of.part))
        if (patch.solid == of.a || patch.solid == of.b)
            sum += patch.area.norm();
    return (solids[of.a].wall || solids[of.b].wall ? 1.0 : 0.5) * sum * grid.face_area();
}

} // namespace

bool voids_are_possible(const Scene& scene)
{
    const auto dry = [](const GapScene& gap) { return gap.contact == GapScene::Contact::dry; };
    return scene.vapour_pressure.has_value() || dry(scene.gap) ||
           std::any_of(scene.pairs.begin(), scene.pairs.end(), [&](const PairScene& pair) { return dry(pair.gap); });
}

template <int D>
void require_for_voids(const Model<D>& model, bool circulation)
{
    const std::string& file = model.scene.file;
    if (model.grid.comm().size() > 1)
        throw InputError(file +
                         ": gap.model: this version runs \"parts\" with dry contact or cavitation on one rank; run it without "
                         "mpirun (threads work), or write gap.model = \"film\"");
    if (!model.viscous() && (circulation || model.driven()))
        throw InputError(
            file + ": gap.model: this version runs \"parts\" with dry contact or cavitation in fluid without a velocity of "
                   "its own; leave out gap.contact and fluid.vapour_pressure");
}

template <int D>
std::vector<Vec<D>> places_of_parts(const Grid<D>& grid, const Complex<D>& complex)
{
    std::vector<Vec<D>> place(complex.parts(), Vec<D>::Zero());
    std::vector<double> area(complex.parts(), 0.0);
    for (const FacePiece<D>& piece : complex.pieces)
        for (const PartOrCell& side : {piece.low, piece.high})
            if (side.is_part() && is_way_out(grid, piece)) {
                const Vec<D> middle = grid.cell_centre(complex.cell_of_part(side.number()));
                place[side.number()] +=
                    piece.area * (middle + grid.nearest_image(Vec<D>(grid.anchor() + grid.dx() * piece.centroid - middle)));
                area[side.number()] += piece.area;
            }
    for (int part = 0; part < complex.parts(); ++part)
        if (area[part] > 0)
            place[part] /= area[part];
        else
            place[part] = grid.cell_centre(complex.cell_of_part(part));
    return place;
}

template <int D>
const VoidPart<D>* Voids<D>::find(std::int32_t site) const
{
    const auto found =
        std::lower_bound(parts.begin(), parts.end(), site, [](const VoidPart<D>& p, std::int32_t n) { return p.part < n; });
    return found != parts.end() && found->part == site ? &*found : nullptr;
}

template <int D>
bool Voids<D>::any() const
{
    return std::any_of(volume.begin(), volume.end(), [](double v) { return v > 0; });
}

template <int D>
Voids<D> find_voids(const Model<D>& model, const std::vector<Solid<D>>& solids, const Complex<D>& complex,
                    std::vector<GapArm<D>> arms, std::vector<MouthArm<D>> mouths, const VoidsBefore<D>* before)
{
    const Grid<D>& grid = model.grid;
    const std::vector<Faces> faces = faces_of_parts(grid, complex, arms, mouths);
    const std::vector<Vec<D>> place = places_of_parts(grid, complex);
    Voids<D> voids;
    for (int part = 0; part < complex.parts(); ++part) {
        const Faces& of = faces[part];
        if (!of.gap)
            continue;
        const auto& [a, b] = std::max_element(of.pairs.begin(), of.pairs.end(), [](const auto& x, const auto& y) {
                                 return x.second < y.second;
                             })->first;
        const VoidLaw law = void_law(model.scene, solids[a].name, solids[b].name);
        if (law.least_pressure == -infinity)
            continue;
        const double thickness = grid.dx() * (of.area > 0 ? of.thickness / of.area : of.mouth);
        voids.parts.push_back(
            {part, a, b, thickness, law.start, 0, 0, true, law.least_pressure - model.hydrostatic(place[part]), place[part]});
        voids.parts.back().area = wall_area(grid, solids, complex, voids.parts.back());
        voids.parts.back().room = thickness * voids.parts.back().area;
    }
    voids.arms = std::move(arms);
    voids.mouths = std::move(mouths);
    if (before)
        take_along(model, solids, complex, *before, voids);
    return voids;
}

template <int D>
PartVoids starting_voids(const Grid<D>& grid, const Complex<D>& complex, const Voids<D>& voids)
{
    PartVoids start{std::vector<double>(count_sites(complex), 0.0), {}, {}, 0};
    for (const VoidPart<D>& part : voids.parts)
        if (part.held > 0 && part.thickness < part.held + touching * grid.dx())
            start.volume[part.part] = part.held * part.area;
    return start;
}

template <int D>
void leave_empty(const Complex<D>& complex, const Voids<D>& voids, std::vector<GapArm<D>>& arms,
                 std::vector<MouthArm<D>>& mouths)
{
    const auto is_void = [&](const PartOrCell& side) { return side.exists() && voids.is_void(site_of(complex, side)); };
    for (GapArm<D>& arm : arms)
        if (const FacePiece<D>& piece = complex.pieces[arm.piece]; is_void(piece.low) || is_void(piece.high)) {
            arm.flux.setZero();
            arm.motion.setZero();
            arm.mass.setZero();
        }
    for (MouthArm<D>& mouth : mouths)
        if (std::any_of(mouth.rows.begin(), mouth.rows.end(), [&](const auto& row) { return is_void(row.first); })) {
            mouth.flux.setZero();
            mouth.mass.setZero();
            mouth.motion.setZero();
        }
}

template <int D>
void shut_empty(const Complex<D>& complex, const Voids<D>& voids, std::vector<GapArm<D>>& arms)
{
    for (GapArm<D>& arm : arms)
        for (const PartOrCell& side : {complex.pieces[arm.piece].low, complex.pieces[arm.piece].high})
            if (side.exists() && voids.is_void(site_of(complex, side))) {
                arm.resistance = infinity;
                arm.share = 1;
            }
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template struct Voids<D>;                                                                                                  \
    template void require_for_voids<D>(const Model<D>&, bool);                                                                 \
    template Voids<D> find_voids<D>(const Model<D>&, const std::vector<Solid<D>>&, const Complex<D>&, std::vector<GapArm<D>>,  \
                                    std::vector<MouthArm<D>>, const VoidsBefore<D>*);                                          \
    template std::vector<Vec<D>> places_of_parts<D>(const Grid<D>&, const Complex<D>&);                                        \
    template PartVoids starting_voids<D>(const Grid<D>&, const Complex<D>&, const Voids<D>&);                                  \
    template void leave_empty<D>(const Complex<D>&, const Voids<D>&, std::vector<GapArm<D>>&, std::vector<MouthArm<D>>&);      \
    template void shut_empty<D>(const Complex<D>&, const Voids<D>&, std::vector<GapArm<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
