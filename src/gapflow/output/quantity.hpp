// Quantities of a run by the names that users give them, and what they are over time: last, mean, smallest, largest.
#pragma once

#include "gapflow/output/convergence.hpp"
#include "gapflow/output/stored_run.hpp"
#include "gapflow/scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gapflow {

/// "body.column" of bodies.csv, "a-b.column" of gaps.csv or "name.column" of fluxes.csv.
struct Quantity {
    std::string name, column;
    std::string body, other; ///< other: of a gap, else empty
    bool flux = false;       ///< body is the name of a flux
};

/// The quantity of a name. Throws InputError that lists the available ones.
Quantity quantity_of(const std::string& name, const Scene& scene);

/// What a reader of a run looks at first: position, velocity and force of bodies that move, force on fixed ones; thickness, film force and
/// contact force of gaps at bodies that move; fluxes. Bodies of crowds and gaps between them are left out, and gaps beyond `most_gaps`.
std::vector<Quantity> key_quantities(const StoredRun& run, std::size_t most_gaps = 20);

/// The window of --window FROM,TO, for runs that end at `end`. Throws InputError.
TimeWindow window_of(const std::string& text, double end);

/// Of a quantity in a window of time.
struct Statistics {
    double last = 0; ///< latest one
    double mean = 0; ///< every row weighs as long as its step; the start weighs nothing
    double low = 0, high = 0;
};

/// Over the rows that the run has of it in the window: none without any.
std::optional<Statistics> statistics_of(const StoredRun& run, const Quantity& quantity, const TimeWindow& window);

} // namespace gapflow
