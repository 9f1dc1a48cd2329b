// Voids taken along from one place of the bodies to the next one. A void stays in its cell until it is filled, also where its gap has become too thick to be
// one; what the walls uncover between voids is void as they are.
#include "gapflow/complex/open_areas.hpp"
#include "gapflow/step/matching.hpp"
#include "gapflow/step/void_parts.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace gapflow {
namespace {

constexpr double level_accuracy = 1e-3; // share of a site's room
constexpr int most_sweeps = 8;          // a site each, over which what a void has too much goes
constexpr double mostly = 0.5;          // of the open faces of what is between voids

/// Open faces between sites.
template <int D>
class SiteFaces {
public:
    SiteFaces(const Grid<D>& grid, const Complex<D>& complex, const OpenAreas<D>& areas)
        : grid_(grid), complex_(complex), areas_(areas)
    {
        for (const FacePiece<D>& piece : complex.pieces)
            if (piece.area > 0 && piece.low.exists() && piece.high.exists())
                add(site_of(complex, piece.low), site_of(complex, piece.high), piece.area);
        for (const CornerLink<D>& link : complex.links)
            if (link.conductance > 0)
                add(link.a, link.b, link.open);
    }

    /// Calls f(other site, area in cells).
    template <class F>
    void for_each(std::int32_t site, F&& f) const
    {
        if (const auto found = beside_.find(site); found != beside_.end())
            for (const auto& [other, area] : found->second)
                f(other, area);
        const PartOrCell side = side_of(complex_, site);
        if (!complex_.is_main(side))
            return;
        const DenseIndex<D>& index = complex_.index;
        const Index<D> c = index.index(complex_.cell_of(side));
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end) {
                const Index<D> next = index.wrapped(c + (2 * end - 1) * step<D>(axis));
                const int face = index(index.wrapped(c + end * step<D>(axis)));
                if (grid_.in_domain(next) && index.holds(next) && areas_.first(axis, face) < 0 &&
                    complex_.main_area[axis][face] > 0)
                    f(site_of(complex_, complex_.main_of(index(next))), complex_.main_area[axis][face]);
            }
    }

private:
    void add(std::int32_t a, std::int32_t b, double area)
    {
        beside_[a].emplace_back(b, area);
        beside_[b].emplace_back(a, area);
    }

    const Grid<D>& grid_;
    const Complex<D>& complex_;
    const OpenAreas<D>& areas_;
    std::map<std::int32_t, std::vector<std::pair<std::int32_t, double>>> beside_;
};

/// Volume of a site, in cells. In space the middle one of three: those of ducts with the mean of its faces along an axis.
template <int D>
double volume_of(const Complex<D>& complex, [[maybe_unused]] const OpenAreas<D>& areas, std::int32_t site)
{
    if (site >= complex.parts())
        return 1;
    if constexpr (D == 2)
        return complex.part_area[site];
    else {
        std::array<double, 3> volume{};
        const Index<3> cell = complex.cell_of_part(site);
        for (int axis = 0; axis < 3; ++axis)
            for (int end = 0; end < 2; ++end) {
                const int face = complex.index(complex.index.wrapped(cell + end * step<3>(axis)));
                const std::int32_t first = areas.first(axis, face);
                if (first < 0 && complex.is_main(site))
                    volume[axis] += 0.5 * complex.main_area[axis][face];
                for (std::int32_t k = first; k >= 0; k = areas.next(k))
                    if (const PartOrCell side = end ? complex.pieces[k].low : complex.pieces[k].high;
                        side.is_part() && side.number() == site)
                        volume[axis] += 0.5 * complex.pieces[k].area;
            }
        std::sort(volume.begin(), volume.end());
        return volume[1];
    }
}

template <int D>
class TakenAlong {
public:
    TakenAlong(const Model<D>& model, const std::vector<Solid<D>>& solids, const Complex<D>& complex, Voids<D>& voids)
        : model_(model), solids_(solids), complex_(complex), voids_(voids), areas_(complex),
          faces_(model.grid, complex, areas_), place_(places_of_parts(model.grid, complex))
    {
        std::vector<char> is_mouth(complex.links.size(), 0);
        for (const MouthArm<D>& mouth : voids.mouths)
            if (mouth.link >= 0)
                is_mouth[mouth.link] = 1;
        for (std::size_t k = 0; k < complex.links.size(); ++k)
            if (const CornerLink<D>& link = complex.links[k]; link.conductance > 0 && !is_mouth[k])
                beside_corner_.insert({link.a, link.b});
    }

    void take(const VoidsBefore<D>& before)
    {
        voids_.volume.assign(count_sites(complex_), 0.0);
        if (before.voids.volume.empty())
            return;
        const std::vector<std::int32_t> was = sites_before(model_.grid, complex_, before.complex);
        std::vector<std::int32_t> next(count_sites(before.complex), -1);
        for (int part = 0; part < complex_.parts(); ++part)
            if (was[part] >= 0)
                next[was[part]] = part;
        std::vector<const VoidPart<D>*> homeless;
        for (const VoidPart<D>& old : before.at.parts) {
            if (!before.voids.is_void(old.part))
                continue;
            const PartOrCell side = side_of(before.complex, old.part);
            if (const int cell = before.complex.cell_of(side);
                complex_.cell[cell] == Complex<D>::open && before.complex.is_main(side))
                next[old.part] = site_of(complex_, PartOrCell::cell(cell));
            if (const std::int32_t site = next[old.part]; site >= 0 && offer(site, old.a, old.b))
                voids_.volume[site] += before.voids.volume[old.part];
            else
                homeless.push_back(&old);
        }
        for (const VoidPart<D>* old : homeless)
            if (const std::int32_t site = nearest(*old); site >= 0)
                voids_.volume[site] += before.voids.volume[old->part];
            else
                voids_.lost.push_back(old->part);
        const auto is_fresh = [&](std::int32_t site) {
            return site < complex_.parts() ? was[site] < 0 : before.complex.cell[site - complex_.parts()] == Complex<D>::solid;
        };
        while (fill_between(is_fresh))
            ;
        for (int sweep = 0; sweep < most_sweeps && level(); ++sweep)
            ;
    }

    /// A site that voids may be in from now on. Whether it is.
    bool offer(std::int32_t site, int a, int b)
    {
        if (voids_.find(site))
            return true;
        if (beside_corner_.contains(site))
            return false;
        const bool is_part = site < complex_.parts();
        const Vec<D> place = is_part ? place_[site] : model_.grid.cell_centre(complex_.index.index(site - complex_.parts()));
        const double dx = model_.grid.dx(), room = std::pow(dx, D) * volume_of(complex_, areas_, site);
        const VoidLaw law = void_law(model_.scene, solids_[a].name, solids_[b].name);
        const VoidPart<D> part{site,  a, b, dx, 0, room / dx, room, false, law.least_pressure - model_.hydrostatic(place),
                               place, -1};
        voids_.parts.insert(std::upper_bound(voids_.parts.begin(), voids_.parts.end(), part,
                                             [](const auto& x, const auto& y) { return x.part < y.part; }),
                            part);
        return true;
    }

private:
    /// Where the void of a part that is gone goes: beside it.
    std::int32_t nearest(const VoidPart<D>& old) const
    {
        std::int32_t site = -1;
        double distance = 2 * model_.grid.dx();
        for (const VoidPart<D>& part : voids_.parts)
            if (const double d = model_.grid.nearest_image(part.place - old.place).norm();
                part.a == old.a && part.b == old.b && d < distance) {
                distance = d;
                site = part.part;
            }
        return site;
    }

    /// What most of the open faces join with voids may become one; what was not there before is one as they are. Whether there was such.
    template <class Fresh>
    bool fill_between(const Fresh& is_fresh)
    {
        std::map<std::int32_t, const VoidPart<D>*> beside;
        const std::vector<VoidPart<D>> parts = voids_.parts;
        for (const VoidPart<D>& part : parts)
            if (voids_.is_void(part.part))
                faces_.for_each(part.part, [&](std::int32_t other, double) {
                    if (!voids_.is_void(other))
                        beside.emplace(other, &part);
                });
        bool changed = false;
        for (const auto& [site, of] : beside) {
            double area = 0, of_voids = 0, volume = 0, room = 0;
            std::set<std::int32_t> others;
            faces_.for_each(site, [&](std::int32_t other, double face) {
                area += face;
                if (voids_.is_void(other)) {
                    of_voids += face;
                    if (others.insert(other).second) {
                        volume += voids_.volume[other];
                        room += voids_.find(other)->room;
                    }
                }
            });
            if (!(of_voids > mostly * area) || !offer(site, of->a, of->b) || !is_fresh(site))
                continue;
            const double own = voids_.find(site)->room, share = own / (own + room);
            if (!(share * volume > 0))
                continue;
            for (const std::int32_t other : others)
                voids_.volume[other] *= 1 - share;
            voids_.volume[site] = share * volume;
            changed = true;
        }
        return changed;
    }

    /// What a void has beyond its room goes on into those beside it that have room left. Whether there was such.
    bool level()
    {
        bool changed = false;
        for (const VoidPart<D>& part : voids_.parts) {
            double& own = voids_.volume[part.part];
            const double surplus = own - part.room;
            if (!voids_.is_void(part.part) || !(surplus > level_accuracy * part.room))
                continue;
            std::map<std::int32_t, double> left;
            double sum = 0;
            faces_.for_each(part.part, [&](std::int32_t other, double) {
                if (voids_.is_void(other))
                    if (const double room = voids_.find(other)->room - voids_.volume[other];
                        room > 0 && left.emplace(other, room).second)
                        sum += room;
            });
            const double given = std::min(surplus, sum);
            if (!(given > level_accuracy * part.room))
                continue;
            for (const auto& [other, room] : left)
                voids_.volume[other] += given * room / sum;
            own -= given;
            changed = true;
        }
        return changed;
    }

    const Model<D>& model_;
    const std::vector<Solid<D>>& solids_;
    const Complex<D>& complex_;
    Voids<D>& voids_;
    OpenAreas<D> areas_;
    SiteFaces<D> faces_;
    std::vector<Vec<D>> place_;
    std::set<std::int32_t> beside_corner_; ///< parts with links that are no mouth's
};

} // namespace

template <int D>
std::vector<std::int32_t> sites_before(const Grid<D>& grid, const Complex<D>& complex, const Complex<D>& before)
{
    std::vector<std::int32_t> sites;
    const std::vector<MatchedPart> was = matched_parts(grid, complex, before);
    for (int part = 0; part < complex.parts(); ++part)
        sites.push_back(was[part].kind == MatchedPart::Kind::none ? -1
                        : was[part].part >= 0                     ? was[part].part
                                              : site_of(before, PartOrCell::cell(complex.cut_cell[complex.part_cell[part]])));
    return sites;
}

template <int D>
void take_along(const Model<D>& model, const std::vector<Solid<D>>& solids, const Complex<D>& complex,
                const VoidsBefore<D>& before, Voids<D>& voids)
{
    TakenAlong<D>(model, solids, complex, voids).take(before);
}

template <int D>
void add_beyond(const Model<D>& model, const std::vector<Solid<D>>& solids, const Complex<D>& complex,
                const std::vector<double>& beyond, Voids<D>& voids)
{
    TakenAlong<D> sites(model, solids, complex, voids);
    for (std::size_t k = 0; k + 2 < beyond.size(); k += 3)
        sites.offer(static_cast<std::int32_t>(beyond[k]), static_cast<int>(beyond[k + 1]), static_cast<int>(beyond[k + 2]));
}

template <int D>
std::vector<double> beyond_gaps(const Voids<D>& voids)
{
    std::vector<double> beyond;
    for (const VoidPart<D>& part : voids.parts)
        if (!part.in_gap && voids.is_void(part.part))
            for (const double value : {1.0 * part.part, 1.0 * part.a, 1.0 * part.b})
                beyond.push_back(value);
    return beyond;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::vector<std::int32_t> sites_before<D>(const Grid<D>&, const Complex<D>&, const Complex<D>&);                  \
    template void take_along<D>(const Model<D>&, const std::vector<Solid<D>>&, const Complex<D>&, const VoidsBefore<D>&,       \
                                Voids<D>&);                                                                                    \
    template void add_beyond<D>(const Model<D>&, const std::vector<Solid<D>>&, const Complex<D>&, const std::vector<double>&,  \
                                Voids<D>&);                                                                                    \
    template std::vector<double> beyond_gaps<D>(const Voids<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
