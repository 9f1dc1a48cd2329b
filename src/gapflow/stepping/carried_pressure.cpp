#include "gapflow/stepping/carried_pressure.hpp"

#include "gapflow/core/threads.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr int layers = 32;          // of cells around bodies to which their velocity extends
constexpr double longest_way = 1.5; // in cells: fields have ghosts two cells deep
constexpr double known_share = 0.3; // of the weights of known cells around a place, for a value there

// Extension of the bodies' velocities from the cells that their surfaces cut, layer by layer, each the mean of the neighbours in those before it.
template <int D>
class Extension {
public:
    Extension(const Grid<D>& grid, CarryingVelocity<D>& W) : grid_(grid), W_(W), layer_(grid), owned_(grid)
    {
        for_each_row<D>(grid.low(), grid.high(), [&](const Index<D>& row) {
            std::fill_n(&owned_(row), grid.high()[0] - grid.low()[0], std::int8_t{1});
        });
        for (int axis = 0; axis < D; ++axis)
            stride_[axis] = layer_.block().stride[axis];
    }

    // Every face that a moving body cuts counts in the cells on both sides, by its part in the body.
    void start(const FaceFractions<D>& fractions, const std::vector<Twist<D>>& motion, std::size_t bodies,
               const Vec<D>& grid_velocity)
    {
        CellField<D> weight(grid_);
        const Block<D>& block = weight.block();
        for (int axis = 0; axis < D; ++axis) {
            Index<D> past = grid_.high(); // the first faces of the next rank bound this one's cells too
            ++past[axis];
            for_each_row<D>(grid_.low(), past, [&](const Index<D>& row) {
                const int* cut = &fractions.cut(axis, row);
                const long first = block.offset(row);
                for (int i = 0; i < past[0] - grid_.low()[0]; ++i) {
                    if (cut[i] < 0)
                        continue;
                    for (const SolidPart<D>& part : fractions.faces[cut[i]].solid)
                        if (part.solid < static_cast<int>(bodies))
                            for (const long at : {first + i, first + i - stride_[axis]}) {
                                weight.data()[at] += part.fraction;
                                for (int k = 0; k < D; ++k)
                                    W_[k].data()[at] += part.fraction * (motion[part.solid][k] - grid_velocity[k]);
                            }
                }
            });
        }
        for (long at = 0; at < weight.size(); ++at) {
            if (owned_.data()[at] && weight.data()[at] > 0) {
                layer_.data()[at] = 1;
                front_.push_back(at);
            }
            for (int k = 0; k < D; ++k)
                W_[k].data()[at] = layer_.data()[at] ? W_[k].data()[at] / weight.data()[at] : 0.0;
        }
        exchange_layer();
    }

    void extend()
    {
        for (std::int8_t layer = 1; layer <= layers; ++layer) {
            find_next(layer);
            if (!grid_.comm().any(!next_.empty()))
                return;
            for_each_part(static_cast<long>(next_.size()), [&](long begin, long end) {
                for (long i = begin; i < end; ++i)
                    fill(next_[i], layer);
            });
            front_.swap(next_);
            exchange_layer();
        }
    }

    // Beyond the domain's sides: as in the cells beside them.
    void fill_outside()
    {
        for (int axis = 0; axis < D; ++axis)
            for (int end = 0; end < 2 && !grid_.periodic(axis); ++end) {
                Index<D> low = grid_.low(), high = grid_.high();
                if (end ? high[axis] != grid_.cells()[axis] : low[axis] != 0)
                    continue;
                low[axis] = end ? high[axis] - 1 : low[axis];
                high[axis] = low[axis] + 1;
                for_each_index<D>(low, high, [&](const Index<D>& c) {
                    for (CellField<D>& component : W_.components)
                        component(c + (end ? 1 : -1) * step<D>(axis)) = component(c);
                });
            }
    }

private:
    // Marks them as of that layer.
    void find_next(std::int8_t layer)
    {
        const std::int8_t after = static_cast<std::int8_t>(layer + 1);
        next_.clear();
        auto queue_around = [&](long at) {
            for (int axis = 0; axis < D; ++axis)
                for (const long other : {at - stride_[axis], at + stride_[axis]})
                    if (owned_.data()[other] && layer_.data()[other] == 0) {
                        layer_.data()[other] = after;
                        next_.push_back(other);
                    }
        };
        for (const long at : front_)
            queue_around(at);
        for (int axis = 0; axis < D; ++axis) // beside ghosts that other ranks have filled
            for (int end = 0; end < 2; ++end) {
                Index<D> low = grid_.low(), high = grid_.high();
                low[axis] = end ? high[axis] : low[axis] - 1;
                high[axis] = low[axis] + 1;
                for_each_index<D>(low, high, [&](const Index<D>& ghost) {
                    const long inner = layer_.block().offset(ghost) + (end ? -1 : 1) * stride_[axis];
                    if (layer_(ghost) == layer && layer_.data()[inner] == 0) {
                        layer_.data()[inner] = after;
                        next_.push_back(inner);
                    }
                });
            }
    }

    void fill(long at, std::int8_t layer)
    {
        std::array<double, D> sum{};
        int count = 0;
        for (int axis = 0; axis < D; ++axis)
            for (const long other : {at - stride_[axis], at + stride_[axis]})
                if (layer_.data()[other] > 0 && layer_.data()[other] <= layer) {
                    ++count;
                    for (int k = 0; k < D; ++k)
                        sum[k] += W_[k].data()[other];
                }
        for (int k = 0; k < D; ++k)
            W_[k].data()[at] = sum[k] / count;
    }

    void exchange_layer()
    {
        exchange(grid_, layer_, 1);
        for (CellField<D>& component : W_.components)
            exchange(grid_, component, 1);
    }

    const Grid<D>& grid_;
    CarryingVelocity<D>& W_;
    CellField<D, std::int8_t> layer_; ///< 1: cut by a body; 0: not reached
    CellField<D, std::int8_t> owned_;
    std::array<long, D> stride_;
    std::vector<long> front_, next_; ///< cells of the last layer and of the one after it
};

// Multilinear weights of the values around the end of a way that starts at a value. Neighbours mostly have the same way: found once.
template <int D>
class WayEnd {
public:
    explicit WayEnd(const Index<D>& stride) : stride_(stride) { set({}); }

    // `cells`: the way, along each axis; none longer than `longest_way` counts.
    void go(const std::array<double, D>& cells)
    {
        if (cells != way_)
            set(cells);
    }
    bool moves() const { return moves_; }
    double value(const double* at) const
    {
        double sum = 0;
        for (int k = 0; k < (1 << D); ++k)
            sum += weight[k] * at[offset[k]];
        return sum;
    }

    std::array<double, 1 << D> weight;
    std::array<long, 1 << D> offset;

private:
    void set(const std::array<double, D>& cells)
    {
        way_ = cells;
        moves_ = std::any_of(cells.begin(), cells.end(), [](double way) { return way != 0; });
        weight.fill(1);
        offset.fill(0);
        for (int axis = 0; axis < D; ++axis) {
            const double way = std::clamp(cells[axis], -longest_way, longest_way), below = std::floor(way), part = way - below;
            for (int k = 0; k < (1 << D); ++k) {
                const int up = k >> axis & 1;
                weight[k] *= up ? part : 1 - part;
                offset[k] += (static_cast<long>(below) + up) * stride_[axis];
            }
        }
    }

    Index<D> stride_; ///< of the field
    std::array<double, D> way_;
    bool moves_;
};

} // namespace

template <int D>
std::optional<CarryingVelocity<D>> carrying_velocity(const Coupling<D>& there, const std::vector<Twist<D>>& motion,
                                                     std::size_t bodies, const Vec<D>& grid_velocity)
{
    if (std::none_of(motion.begin(), motion.begin() + static_cast<long>(bodies),
                     [&](const Twist<D>& V) { return V.template head<D>() != grid_velocity; }))
        return {};
    CarryingVelocity<D> W;
    for (CellField<D>& component : W.components)
        component = CellField<D>(*there.grid);
    Extension<D> extension(*there.grid, W);
    extension.start(*there.fractions, motion, bodies, grid_velocity);
    extension.extend();
    extension.fill_outside();
    return W;
}

template <int D>
FaceField<D> change_along(const Grid<D>& grid, const CarryingVelocity<D>& W, double dt, const FaceField<D>& f)
{
    FaceField<D> change(grid);
    for (int axis = 0; axis < D; ++axis) {
        const Index<D> end = owned_faces_end(grid, axis);
        const Index<D> stride = f[axis].block().stride;
        const double* const value = f[axis].data();
        for_each_row_on_threads<D>(grid.low(), end, [&](const Index<D>& row) {
            const long first = f[axis].block().offset(row);
            WayEnd<D> end_of_way(stride);
            Index<D> face = row;
            for (int i = 0; i < end[0] - row[0]; ++i, ++face[0]) {
                const long at = first + i;
                std::array<double, D> way;
                for (int k = 0; k < D; ++k) {
                    const double speed = 0.5 * (W[k].data()[at] + W[k].data()[at - stride[axis]]);
                    way[k] = dt * speed / (grid.dx() * (k == axis ? grid.spread(k, face[k]) : grid.width(k, face[k])));
                }
                end_of_way.go(way);
                if (end_of_way.moves())
                    change[axis].data()[at] = end_of_way.value(value + at) - value[at];
            }
        });
    }
    exchange(grid, change);
    return change;
}

template <int D>
void carry(const Grid<D>& grid, const CarryingVelocity<D>& W, double dt, PastPressure<D>& past)
{
    exchange(grid, past.pressure);
    exchange(grid, past.known);
    CellField<D> moved = past.pressure;
    const Index<D> stride = moved.block().stride;
    const double *pressure = past.pressure.data(), *known = past.known.data();
    for_each_row_on_threads<D>(grid.low(), grid.high(), [&](const Index<D>& row) {
        const long first = moved.block().offset(row);
        WayEnd<D> start(stride);
        Index<D> c = row;
        for (int i = 0; i < grid.high()[0] - row[0]; ++i, ++c[0]) {
            const long at = first + i;
            if (known[at] <= 0)
                continue;
            std::array<double, D> way;
            for (int k = 0; k < D; ++k)
                way[k] = -dt * W[k].data()[at] / (grid.dx() * grid.width(k, c[k]));
            start.go(way);
            if (!start.moves())
                continue;
            double sum = 0, weights = 0;
            for (int k = 0; k < (1 << D); ++k)
                if (const long g = at + start.offset[k]; start.weight[k] > 0 && known[g] > 0) {
                    sum += start.weight[k] * pressure[g];
                    weights += start.weight[k];
                }
            if (weights > known_share)
                moved.data()[at] = sum / weights;
        }
    });
    past.pressure = std::move(moved);
    exchange(grid, past.pressure);
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template std::optional<CarryingVelocity<D>> carrying_velocity<D>(const Coupling<D>&, const std::vector<Twist<D>>&,         \
                                                                     std::size_t, const Vec<D>&);                              \
    template FaceField<D> change_along<D>(const Grid<D>&, const CarryingVelocity<D>&, double, const FaceField<D>&);            \
    template void carry<D>(const Grid<D>&, const CarryingVelocity<D>&, double, PastPressure<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
