#include "gapflow/stepping/gap_notes.hpp"

#include "gapflow/core/text.hpp"

#include <cstdio>

namespace gapflow
{

std::string place_text(const std::vector<double>& x)
{
    std::string text;
    for (const double coordinate : x) {
        char number[32];
        std::snprintf(number, sizeof number, "%.4g", coordinate + 0.0); // no -0
        text += (text.empty() ? "(" : ", ") + std::string(number);
    }
    return text + ")";
}

std::string sealed_text(const SealedPocket& pocket)
{
    const std::string what = pocket.cells > 0 ? std::to_string(pocket.cells) + (pocket.cells == 1 ? " cell" : " cells") + " of fluid"
                                              : std::string("a film");
    return what + " at " + place_text(pocket.at) + (pocket.bodies.empty() ? "" : " between " + joined(pocket.bodies, ", ")) +
           ": nothing lets this fluid out, so its volume holds what bounds it; if that is not meant, leave a gap or an open side";
}

template <int D>
std::vector<std::string> blind_end_notes(const Coupling<D>& coupling, std::set<FilmPair<D>>& told)
{
    std::vector<std::string> notes;
    for (const BlindEnd<D>& end : coupling.network.mouths.blind) {
        const Film<D>& film = coupling.network.films[end.film];
        if (!told.insert(film.pair).second)
            continue;
        notes.push_back("the film between '" + coupling.solids[film.mesh.master].name + "' and '" + coupling.solids[film.mesh.other].name +
                        "' ends at " + place_text<D>(end.x) +
                        " where nothing continues it (no cell with fluid, no other film, no side): the flow there may be too stiff; "
                        "use a finer grid (domain.cells), or another gap.threshold for this pair");
    }
    return notes;
}

template std::vector<std::string> blind_end_notes<2>(const Coupling<2>&, std::set<FilmPair<2>>&);
template std::vector<std::string> blind_end_notes<3>(const Coupling<3>&, std::set<FilmPair<3>>&);

} // namespace gapflow
