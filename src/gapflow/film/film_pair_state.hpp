// Entries of a pair with films in a stored state.
#pragma once

#include "gapflow/core/state_archive.hpp"
#include "gapflow/film/film_set.hpp"

namespace gapflow {

template <int D>
void list_state(StateArchive& archive, FilmPair<D>& pair)
{
    archive("master", pair.master);
    archive("other", pair.other);
    for (int& periods : pair.shift)
        archive("shift", periods);
}

} // namespace gapflow
