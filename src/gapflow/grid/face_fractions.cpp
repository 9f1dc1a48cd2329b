// Fractions of all faces of a block of cells. Only faces within reach of a surface are clipped: a block of cells with half
// diagonal R is wholly open if phi > R at its centre for every solid, wholly inside a solid if phi < -R for one and the others
// are nowhere deeper (phi is 1-Lipschitz); else it is halved, down to single cells. Method, "Face fractions".
//
// What a bin of cells gets depends on the solids near it alone: where none of them has moved it is copied from the fractions before.
#include "gapflow/core/threads.hpp"
#include "gapflow/grid/face_clipper_data.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace gapflow {

namespace {

// `cut` of a face wholly inside image i is -2 - i.
int inside(int image)
{
    return -2 - image;
}

} // namespace

/// What fractions depend on, and what they do not tell of how they were found.
template <int D>
struct FractionsTrace {
    Vec<D> origin;
    Index<D> low, high;
    FractionMode mode;
    std::vector<Image<D>> images;
    std::vector<Vec<D>> centres;
    std::vector<int> rank;
    struct Bin {
        std::vector<int> images; ///< near it
        long first = 0, count = 0;
    };
    std::vector<Bin> bins;
    std::vector<Index<D>> cells; ///< whose low faces were clipped, in this order: of each bin `count` from `first` on
    int clipped = 0;             ///< number of entries of clipped faces; those after them are wholly solid
};

namespace {

template <int D>
bool same_pose(const PlacedShape<D>& a, const PlacedShape<D>& b)
{
    const Vec<D> origin = Vec<D>::Zero();
    return &a.shape() == &b.shape() && a.to_world(origin) == b.to_world(origin) && a.rotation() == b.rotation();
}

template <int D, class Data>
class Flood {
public:
    Flood(const Grid<D>& grid, const Data& data, const FaceFractions<D>* before) : grid_(grid), data_(data), before_(before)
    {
        trace_->origin = grid.origin();
        trace_->low = grid.low();
        trace_->high = grid.high();
        trace_->mode = data.mode;
        trace_->images = data.images;
        trace_->centres = data.centres;
        trace_->rank = data.rank;
        trace_->bins.resize(data.bins.bins().size);
        as_before_.assign(data.bins.bins().size, 0);
        find_unmoved();
        result_.open = FaceField<D>(grid, 0.0);
        result_.cut = FaceField<D, int>(grid, -1);
        for (int axis = 0; axis < D; ++axis) {
            low_[axis] = grid.low()[axis] - 1;
            high_[axis] = grid.high()[axis] + 1;
            if (!grid.periodic(axis)) {
                low_[axis] = std::max(low_[axis], 0);
                high_[axis] = std::min(high_[axis], grid.cells()[axis]);
            }
        }
        for (int axis = 0; axis < D; ++axis) {
            faces_end_[axis] = high_;
            faces_end_[axis][axis] = std::min(high_[axis] + 1, result_.open[axis].block().high[axis]);
        }
        // A voxel face depends on the centres of both its cells.
        padding_ = (data.mode == FractionMode::voxel ? grid.largest_width() : 0.0) * grid.dx() + 1e-6 * grid.dx();
    }

    FaceFractions<D> run()
    {
        const ImageBins<D>& bins = data_.bins;
        const Index<D> end = high_ + Index<D>::Ones(); // each cell fills the faces on its low sides
        const Index<D> first_bin = bins.bin_of(low_), end_bin = bins.bin_of(high_) + Index<D>::Ones();
        std::vector<Work> works(end_bin[D - 1] - first_bin[D - 1]); // one for each plane of bins, joined in their order
        for_each_plane(0, static_cast<int>(works.size()), [&](int plane) {
            Index<D> from = first_bin, to = end_bin;
            from[D - 1] += plane;
            to[D - 1] = from[D - 1] + 1;
            Work& work = works[plane];
            for_each_index<D>(from, to, [&](const Index<D>& bin) {
                const Index<D> first = bins.first_cell(bin);
                const Index<D> low = first.cwiseMax(low_), high = (first + Index<D>::Constant(bins.width())).cwiseMin(end);
                const long number = bins.bins().offset(bin);
                auto& trace = trace_->bins[number];
                trace.first = static_cast<long>(work.surface_cells.size());
                work.candidates.clear();
                if (padding_ > grid_.dx())
                    add_candidates_around(bin, work.candidates);
                else
                    for (int image : bins.images_in(bin))
                        if (!data_.wall[image])
                            work.candidates.push_back(image);
                trace.images = work.candidates;
                as_before_[number] = is_as_before(low, high, number);
                if (as_before_[number])
                    copy(low, high, before_->trace->bins[number], work);
                else
                    visit(low, high, 0, work);
                trace.count = static_cast<long>(work.surface_cells.size()) - trace.first;
            });
        });
        for (std::size_t plane = 0; plane < works.size(); ++plane) {
            Index<D> from = first_bin, to = end_bin;
            from[D - 1] += static_cast<int>(plane);
            to[D - 1] = from[D - 1] + 1;
            for_each_index<D>(from, to, [&](const Index<D>& bin) {
                trace_->bins[bins.bins().offset(bin)].first += static_cast<long>(surface_cells_.size());
            });
            number(works[plane]);
        }
        works.push_back(beyond_periodic_sides());
        number(works.back());
        list_surface_cells();
        trace_->clipped = count_;
        close_sides();
        complete_hulls();
        gather(works);
        trace_->cells = std::move(surface_cells_);
        result_.trace = std::move(trace_);
        return std::move(result_);
    }

private:
    /// Result of a part of the flood; `cut` of its faces counts from its own first one.
    struct Work {
        std::vector<int> candidates; ///< a stack: each level of the recursion adds its own
        std::vector<double> phi;
        std::vector<Index<D>> surface_cells;
        std::vector<ClippedFace<D>> faces;
        ClippedFace<D> parts;
    };

    // The images that are where they were; none if the grid or the list of images is another.
    void find_unmoved()
    {
        unmoved_.assign(data_.images.size(), 0);
        const FractionsTrace<D>* old = before_ ? before_->trace.get() : nullptr;
        if (!old || old->origin != grid_.origin() || old->low != grid_.low() || old->high != grid_.high() ||
            old->mode != data_.mode || old->rank != data_.rank || old->bins.size() != trace_->bins.size())
            return;
        for (std::size_t i = 0; i < data_.images.size(); ++i)
            if (data_.images[i].solid != old->images[i].solid || data_.images[i].shift != old->images[i].shift)
                return;
        for (std::size_t i = 0; i < data_.images.size(); ++i)
            unmoved_[i] = same_pose(data_.images[i].shape, old->images[i].shape) && data_.centres[i] == old->centres[i];
        image_of_.assign(1 + (data_.images.empty() ? 0 : data_.images.back().solid), 0);
        for (std::size_t i = 0; i < data_.images.size(); ++i)
            image_of_[data_.images[i].solid] = static_cast<int>(i);
    }

    // Beyond a periodic side faces are clipped where they wrap to, which is in another bin.
    bool is_as_before(const Index<D>& low, const Index<D>& high, long bin) const
    {
        const std::vector<int>& images = trace_->bins[bin].images;
        if (images.empty() || !(low.array() < high.array()).all() ||
            !std::all_of(images.begin(), images.end(), [&](int i) { return unmoved_[i]; }) ||
            images != before_->trace->bins[bin].images)
            return false;
        for (int axis = 0; axis < D; ++axis)
            if (grid_.periodic(axis) && (low[axis] < 0 || high[axis] > grid_.cells()[axis]))
                return false;
        return true;
    }

    // Does what visit() did when the fractions before were made.
    void copy(const Index<D>& low, const Index<D>& high, const typename FractionsTrace<D>::Bin& bin, Work& work)
    {
        const FractionsTrace<D>& old = *before_->trace;
        for (int axis = 0; axis < D; ++axis)
            for_each_index<D>(low, high.cwiseMin(faces_end_[axis]), [&](const Index<D>& face) {
                const int cut = before_->cut(axis, face);
                result_.open(axis, face) = before_->open(axis, face);
                result_.cut(axis, face) = cut >= old.clipped ? inside(image_of_[before_->faces[cut].solid[0].solid]) : cut;
            });
        for (long i = bin.first; i < bin.first + bin.count; ++i) {
            const Index<D>& cell = old.cells[i];
            work.surface_cells.push_back(cell);
            for (int axis = 0; axis < D; ++axis) {
                if (!(cell.array() < faces_end_[axis].array()).all())
                    continue;
                int& cut = result_.cut(axis, cell);
                if (cut < 0)
                    continue;
                work.faces.push_back(before_->faces[cut]);
                cut = static_cast<int>(work.faces.size()) - 1;
            }
        }
    }

    // Entry that a face wholly in a solid had and still has; -1: none.
    int old_entry(int axis, const Index<D>& face) const
    {
        return as_before_[data_.bins.bins().offset(data_.bins.bin_of(face))] ? before_->cut(axis, face) : -1;
    }

    // Numbers its faces after all before.
    void number(const Work& work)
    {
        for (const Index<D>& cell : work.surface_cells)
            for (int axis = 0; axis < D; ++axis)
                if ((cell.array() < faces_end_[axis].array()).all() && result_.cut(axis, cell) >= 0)
                    result_.cut(axis, cell) += count_;
        surface_cells_.insert(surface_cells_.end(), work.surface_cells.begin(), work.surface_cells.end());
        count_ += static_cast<int>(work.faces.size());
    }

    // The faces in the order of their numbers; their memory, the most there is in crowds, is asked for once.
    void gather(std::vector<Work>& works)
    {
        result_.faces.resize(count_);
        std::vector<std::size_t> first{0}; // of every work
        for (const Work& work : works)
            first.push_back(first.back() + work.faces.size());
        for_each_job(static_cast<int>(works.size()), [&](int k) {
            std::move(works[k].faces.begin(), works[k].faces.end(), result_.faces.begin() + static_cast<long>(first[k]));
            works[k] = {};
        });
        const std::size_t before = first.back();
        for_each_part(static_cast<long>(whole_.size()), [&](long begin, long end) {
            for (long i = begin; i < end; ++i) {
                const auto& [axis, face] = whole_[i];
                if (const int old = old_entry(axis, face); old >= 0)
                    result_.faces[before + i] = before_->faces[old];
                else
                    data_.clip(axis, face, result_.faces[before + i]);
            }
        });
    }

    void add_candidates_around(const Index<D>& bin, std::vector<int>& candidates)
    {
        const Block<D>& all = data_.bins.bins();
        const Index<D> one = Index<D>::Ones();
        for_each_index<D>((bin - one).cwiseMax(all.low), (bin + 2 * one).cwiseMin(all.high), [&](const Index<D>& other) {
            for (int image : data_.bins.images_in(other))
                if (!data_.wall[image])
                    candidates.push_back(image);
        });
        std::sort(candidates.begin(), candidates.end());
        candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    }

    // Fills the low faces of the cells low..high; the candidates from `begin` on are all that reach them.
    void visit(const Index<D>& low, const Index<D>& high, std::size_t begin, Work& work)
    {
        if (!(low.array() < high.array()).all())
            return;
        if (work.candidates.size() == begin)
            return fill(low, high, 1, -1);
        const auto [centre, half_diagonal] = middle_of(low, high);
        const double radius = half_diagonal + padding_;
        const std::size_t end = work.candidates.size();
        double smallest = radius;
        work.phi.resize(end);
        for (std::size_t k = begin; k < end; ++k) {
            const double phi = data_.images[work.candidates[k]].shape.distance(centre);
            work.phi.push_back(phi);
            work.candidates.push_back(work.candidates[k]);
            smallest = std::min(smallest, phi);
        }
        std::size_t kept = end;
        for (std::size_t k = end; k < work.candidates.size(); ++k)
            if (work.phi[k] <= radius && work.phi[k] <= smallest + 2 * radius)
                work.candidates[kept++] = work.candidates[k];
        work.candidates.resize(kept);
        if (kept == end)
            fill(low, high, 1, -1);
        else if (kept == end + 1 && smallest < -radius)
            fill(low, high, 0, inside(work.candidates[end]));
        else if ((high - low).maxCoeff() == 1)
            clip_cell(low, work);
        else
            halve(low, high, end, work);
        work.candidates.resize(end);
    }

    // Centre of a block of cells, and the distance from it to a corner.
    std::pair<Vec<D>, double> middle_of(const Index<D>& low, const Index<D>& high) const
    {
        if (grid_.graded()) {
            const Vec<D> from = grid_.corner(low), to = grid_.corner(high);
            return {0.5 * (from + to), 0.5 * (to - from).norm()};
        }
        const Vec<D> extent = (high - low).template cast<double>();
        return {grid_.origin() + grid_.dx() * (low.template cast<double>() + 0.5 * extent), 0.5 * grid_.dx() * extent.norm()};
    }

    void halve(const Index<D>& low, const Index<D>& high, std::size_t begin, Work& work)
    {
        const Index<D> middle = (low + high + Index<D>::Ones()).unaryExpr([](int i) { return i >> 1; });
        for (int part = 0; part < 1 << D; ++part) {
            Index<D> from, to;
            for (int axis = 0; axis < D; ++axis) {
                const bool upper = part >> axis & 1;
                from[axis] = upper ? middle[axis] : low[axis];
                to[axis] = upper ? high[axis] : middle[axis];
            }
            visit(from, to, begin, work);
        }
    }

    // open: 1 or 0.
    void fill(const Index<D>& low, const Index<D>& high, double open, int cut)
    {
        for (int axis = 0; axis < D; ++axis)
            for_each_row<D>(low, high.cwiseMin(faces_end_[axis]), [&](const Index<D>& row) {
                const int n = std::min(high[0], faces_end_[axis][0]) - low[0];
                if (n <= 0)
                    return;
                double* to = &result_.open(axis, row);
                if (grid_.graded() && open > 0)
                    for (int i = 0; i < n; ++i)
                        to[i] = grid_.relative_area(axis, row + i * step<D>(0));
                else
                    std::fill_n(to, n, open);
                std::fill_n(&result_.cut(axis, row), n, cut);
            });
    }

    void clip_cell(const Index<D>& cell, Work& work)
    {
        work.surface_cells.push_back(cell);
        for (int axis = 0; axis < D; ++axis) {
            if (!(cell.array() < faces_end_[axis].array()).all())
                continue;
            const int whole = data_.clip(axis, cell, work.parts);
            result_.open(axis, cell) = work.parts.open;
            result_.cut(axis, cell) = whole >= 0                 ? inside(whole)
                                      : work.parts.solid.empty() ? -1
                                                                 : static_cast<int>(work.faces.size());
            if (result_.cut(axis, cell) >= 0)
                work.faces.push_back(work.parts);
        }
    }

    // An entry for a face that lies wholly in a solid.
    void add_entry(int axis, const Index<D>& face)
    {
        result_.cut(axis, face) = count_++;
        whole_.emplace_back(axis, face);
    }

    // A container has no images: beyond a periodic side its faces are those that they wrap to, not what lies there.
    Work beyond_periodic_sides()
    {
        Work work;
        const bool containers = std::any_of(data_.images.begin(), data_.images.end(),
                                            [](const Image<D>& image) { return image.shape.shape().inside_out(); });
        if (!containers)
            return work;
        for_each_index<D>(low_, high_ + Index<D>::Ones(), [&](const Index<D>& cell) {
            for (int axis = 0; axis < D; ++axis)
                if (grid_.periodic(axis) && (cell[axis] < 0 || cell[axis] >= grid_.cells()[axis]))
                    return clip_cell(cell, work);
        });
        return work;
    }

    void list_surface_cells()
    {
        std::vector<Index<D>>& cells = result_.surface_cells;
        std::copy_if(surface_cells_.begin(), surface_cells_.end(), std::back_inserter(cells),
                     [&](const Index<D>& cell) { return grid_.owns(cell); });
        std::sort(cells.begin(), cells.end(), [](const Index<D>& a, const Index<D>& b) {
            for (int axis = D - 1; axis > 0; --axis)
                if (a[axis] != b[axis])
                    return a[axis] < b[axis];
            return a[0] < b[0];
        });
        cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    }

    // Faces on the domain's closed sides belong to their walls.
    void close_sides()
    {
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end) {
                const int place = end * grid_.cells()[axis];
                if (grid_.side(axis, end) != SideKind::wall || place < low_[axis] || place >= faces_end_[axis][axis])
                    continue;
                Index<D> from = low_, to = faces_end_[axis];
                from[axis] = place;
                to[axis] = place + 1;
                for_each_index<D>(from, to, [&](const Index<D>& f) {
                    result_.open(axis, f) = 0;
                    add_entry(axis, f);
                    surface_cells_.push_back(end ? Index<D>(f - step<D>(axis)) : f);
                });
            }
    }

    template <class F>
    void for_each_face(const Index<D>& cell, F&& f) const
    {
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2; ++end)
                if (const Index<D> face = cell + end * step<D>(axis); (face.array() < faces_end_[axis].array()).all())
                    f(axis, face);
    }

    // A cell all of whose faces lie wholly inside one solid has no body flux; the faces of all others have entries. (Beyond a periodic side they may lie in
    // different images of it: those that are clipped are clipped where they wrap to.)
    void complete_hulls()
    {
        const auto solid_around = [&](int axis, const Index<D>& face) {
            const int cut = result_.cut(axis, face);
            return cut < -1 ? data_.images[inside(cut)].solid : -1;
        };
        const auto lacks_entries = [&](const Index<D>& cell) {
            if (!(cell.array() < high_.array()).all())
                return false;
            const int first = solid_around(0, cell);
            bool same = first >= 0, any = false;
            for_each_face(cell, [&](int axis, const Index<D>& face) {
                const int solid = solid_around(axis, face);
                same &= solid == first;
                any |= solid >= 0;
            });
            return any && !same;
        };
        std::vector<char> lacks(surface_cells_.size());
        for_each_part(static_cast<long>(lacks.size()), [&](long begin, long end) {
            for (long i = begin; i < end; ++i)
                lacks[i] = lacks_entries(surface_cells_[i]);
        });
        for (std::size_t i = 0; i < lacks.size(); ++i)
            if (lacks[i])
                for_each_face(surface_cells_[i], [&](int axis, const Index<D>& face) {
                    if (result_.cut(axis, face) < -1)
                        add_entry(axis, face);
                });
    }

    const Grid<D>& grid_;
    const Data& data_;
    const FaceFractions<D>* before_;
    std::vector<char> unmoved_;   ///< of the images
    std::vector<char> as_before_; ///< of the bins
    std::vector<int> image_of_;   ///< one of each solid's
    std::shared_ptr<FractionsTrace<D>> trace_ = std::make_shared<FractionsTrace<D>>();
    FaceFractions<D> result_;
    Index<D> low_, high_;               ///< cells all of whose faces are filled
    std::array<Index<D>, D> faces_end_; ///< faces normal to an axis: low_ <= f < faces_end_
    double padding_;
    std::vector<Index<D>> surface_cells_;
    int count_ = 0;                               ///< of entries so far
    std::vector<std::pair<int, Index<D>>> whole_; ///< faces that lie wholly in a solid: the last entries
};

} // namespace

template <int D>
FaceFractions<D> face_fractions(const Grid<D>& grid, const FaceClipper<D>& clipper, const FaceFractions<D>* before)
{
    return Flood<D, typename FaceClipper<D>::Data>(grid, *clipper.data_, before).run();
}

template FaceFractions<2> face_fractions<2>(const Grid<2>&, const FaceClipper<2>&, const FaceFractions<2>*);
template FaceFractions<3> face_fractions<3>(const Grid<3>&, const FaceClipper<3>&, const FaceFractions<3>*);

} // namespace gapflow
