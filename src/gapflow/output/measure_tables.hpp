// Tables of what a scene asks to be measured: probes.csv, fluxes.csv, forces.csv.
#pragma once

#include "gapflow/output/checkpoint.hpp"
#include "gapflow/output/table.hpp"
#include "gapflow/step/simulation.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace gapflow {

/// The names of the tables; a run removes those of an earlier run that it does not write.
inline constexpr const char* measure_tables[] = {"probes.csv", "fluxes.csv", "forces.csv"};

template <int D>
class MeasureTables {
public:
    /// Of a simulation at its start; with `from` the tables of the run that wrote that checkpoint are continued.
    explicit MeasureTables(const Simulation<D>& simulation);
    /// Opens the tables. Throws InputError, ComputationError. Not collective: call it on the root.
    void open(const std::filesystem::path& folder, const Scene& scene, const RunPosition* from);

    /// The rows of probes and fluxes that are due, and those of the forces. Collective.
    void write_step(const Simulation<D>& simulation, const StepReport& report);

private:
    /// When rows of a probe or flux are due: at the start and at the first step that reaches a multiple of its interval.
    struct Due {
        double every, next;

        Due(double interval, double time);
        bool operator()(double time);
    };
    void write_probes(const Simulation<D>& simulation, const StepReport& report);
    void write_fluxes(const Simulation<D>& simulation, const StepReport& report);
    void write_forces(const Simulation<D>& simulation, const StepReport& report);

    std::optional<Table> probes_, fluxes_, forces_; ///< on the root
    std::vector<Due> probes_due_, fluxes_due_;
    std::vector<std::vector<Vec<D>>> places_;                      ///< of each probe
    bool pressure_ = false, velocity_ = false, vorticity_ = false; ///< whether any probe measures it
};

} // namespace gapflow
