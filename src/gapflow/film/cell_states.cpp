#include "gapflow/film/cell_states.hpp"

namespace gapflow {

namespace {

// A known state in 16 bits: open faces in the lowest 2 D, then whether it leads out, the kind, and that it is known.
constexpr unsigned open_bits = 0x3f, leads_out_bit = 0x40, kind_shift = 7, known_bit = 0x8000;

} // namespace

template <int D>
CellKind kind_of(const FaceCache<D>& faces, const FilmCells<D>& cells, const Index<D>& cell)
{
    const Index<D> w = faces.grid().wrapped(cell);
    if (const FilmCell<D>* known = cells.cells.find(faces.grid().key(w)))
        return known->kind;
    for (int axis = 0; axis < D; ++axis)
        for (int end = 0; end < 2; ++end)
            if (faces.open(axis, w + end * step<D>(axis)) > negligible_opening)
                return CellKind::bulk;
    return CellKind::solid;
}

template <int D>
double open_after_closing(const FaceCache<D>& faces, const FilmCells<D>& cells, int axis, const Index<D>& face)
{
    const double open = faces.open(axis, face);
    return open > 0 && cells.closed.contains(faces.key(axis, face)) ? 0.0 : open;
}

template <int D>
CellStates<D>::CellStates(const FaceCache<D>& faces, const FilmCells<D>& cells) : faces_(faces), cells_(cells)
{
    const Grid<D>& grid = faces.grid();
    const Index<D> around = Index<D>::Constant(2);
    block_ = Block<D>((grid.low() - around).cwiseMax(0), (grid.high() + around).cwiseMin(grid.cells()));
    known_ = std::vector<std::atomic<std::uint16_t>>(block_.size);
    apertures_ = std::vector<std::atomic<double>>(block_.size);
}

template <int D>
CellState<D> CellStates<D>::find(const Index<D>& cell) const
{
    CellState<D> state{kind_of(faces_, cells_, cell), 0, false, 0};
    for (const CellSide<D>& side : sides_of(grid(), cell)) {
        const double open = open_after_closing(faces_, cells_, side.axis, side.face);
        state.aperture += open;
        if (open > negligible_opening && side.inside)
            state.open |= 1u << (2 * side.axis + side.end);
        state.leads_out |= open > negligible_opening && !side.inside;
    }
    return state;
}

template <int D>
CellState<D> CellStates<D>::operator()(const Index<D>& cell) const
{
    const Index<D> w = grid().wrapped(cell);
    if (!block_.contains(w))
        return find(w);
    const long i = block_.offset(w);
    if (const unsigned known = known_[i].load(std::memory_order_acquire); known & known_bit)
        return {static_cast<CellKind>(known >> kind_shift & 3), known & open_bits, (known & leads_out_bit) != 0,
                apertures_[i].load(std::memory_order_relaxed)};
    const CellState<D> state = find(w);
    apertures_[i].store(state.aperture, std::memory_order_relaxed);
    known_[i].store(static_cast<std::uint16_t>(known_bit | static_cast<unsigned>(state.kind) << kind_shift |
                                               (state.leads_out ? leads_out_bit : 0) | state.open),
                    std::memory_order_release);
    return state;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template class CellStates<D>;                                                                                              \
    template CellKind kind_of<D>(const FaceCache<D>&, const FilmCells<D>&, const Index<D>&);                                   \
    template double open_after_closing<D>(const FaceCache<D>&, const FilmCells<D>&, int, const Index<D>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
