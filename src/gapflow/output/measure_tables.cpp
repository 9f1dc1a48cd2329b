#include "gapflow/output/measure_tables.hpp"

#include "gapflow/output/columns.hpp"
#include "gapflow/output/schedule.hpp"

#include <algorithm>

namespace gapflow {

namespace {

std::vector<std::string> vorticity_names(int dimension)
{
    return dimension == 2 ? std::vector<std::string>{"vorticity"}
                          : std::vector<std::string>{"vorticity_x", "vorticity_y", "vorticity_z"};
}

void append(std::vector<std::string>& names, const std::vector<std::string>& more)
{
    names.insert(names.end(), more.begin(), more.end());
}

// The parts in the order of their columns.
template <int D>
std::vector<std::pair<std::string, Twist<D> ForceParts<D>::*>> parts()
{
    return {{"pressure", &ForceParts<D>::pressure},
            {"shear", &ForceParts<D>::shear},
            {"film", &ForceParts<D>::film},
            {"contact", &ForceParts<D>::contact},
            {"buoyancy", &ForceParts<D>::buoyancy}};
}

} // namespace

template <int D>
MeasureTables<D>::Due::Due(double interval, double time) : every(interval)
{
    next = every > 0 && time > 0 ? every * static_cast<double>(next_multiple(time, every)) : 0.0;
}

template <int D>
bool MeasureTables<D>::Due::operator()(double time)
{
    if (time < next)
        return false;
    if (every > 0)
        next = every * static_cast<double>(next_multiple(time, every));
    return true;
}

template <int D>
MeasureTables<D>::MeasureTables(const Simulation<D>& simulation)
{
    const Scene& scene = simulation.scene();
    for (const ProbeScene& probe : scene.probes) {
        probes_due_.emplace_back(probe.every, simulation.time());
        places_.emplace_back();
        for (const Triple& place : probe.places())
            places_.back().emplace_back(place.data());
        pressure_ = pressure_ || probe.pressure;
        velocity_ = velocity_ || probe.velocity;
        vorticity_ = vorticity_ || probe.vorticity;
    }
    for (const FluxScene& flux : scene.fluxes)
        fluxes_due_.emplace_back(flux.every, simulation.time());
}

template <int D>
void MeasureTables<D>::open(const std::filesystem::path& folder, const Scene& scene, const RunPosition* from)
{
    const auto open = [&](std::optional<Table>& table, const char* name, bool wanted, const std::vector<std::string>& columns) {
        if (!wanted) {
            if (!from)
                std::filesystem::remove(folder / name);
        } else if (from) {
            table.emplace(Table::resume(folder / name, columns, from->step));
        } else {
            table.emplace(folder / name, columns);
        }
    };
    std::vector<std::string> probe{"step", "time", "name", "point"};
    append(probe, body_columns(D).position);
    probe.emplace_back("kind");
    if (pressure_)
        probe.emplace_back("pressure");
    if (velocity_)
        append(probe, D == 2 ? std::vector<std::string>{"u", "v"} : std::vector<std::string>{"u", "v", "w"});
    if (vorticity_)
        append(probe, vorticity_names(D));
    open(probes_, "probes.csv", !scene.probes.empty(), probe);
    open(fluxes_, "fluxes.csv", !scene.fluxes.empty(), {"step", "time", "name", "flux", "inflow", "outflow", "film", "bodies"});
    std::vector<std::string> force{"step", "time", "body"};
    for (const auto& [name, part] : parts<D>())
        for (const std::string& component : body_columns(D).force)
            force.push_back(name + "_" + component);
    open(forces_, "forces.csv", scene.forces, force);
}

template <int D>
void MeasureTables<D>::write_step(const Simulation<D>& simulation, const StepReport& report)
{
    if (!places_.empty())
        write_probes(simulation, report);
    if (!fluxes_due_.empty())
        write_fluxes(simulation, report);
    if (forces_)
        write_forces(simulation, report);
}

template <int D>
void MeasureTables<D>::write_probes(const Simulation<D>& simulation, const StepReport& report)
{
    const std::vector<ProbeScene>& probes = simulation.scene().probes;
    std::vector<char> due;
    std::vector<Vec<D>> places;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        due.push_back(probes_due_[i](report.time));
        if (due[i])
            places.insert(places.end(), places_[i].begin(), places_[i].end());
    }
    if (places.empty())
        return;
    const std::vector<PointValues<D>> values = simulation.sample(places);
    if (!probes_)
        return;
    const PointValues<D> none;
    std::size_t at = 0;
    for (std::size_t i = 0; i < probes.size(); ++i)
        for (std::size_t point = 0; due[i] && point < places_[i].size(); ++point, ++at) {
            const PointValues<D>& v = values[at];
            const double pressure = probes[i].pressure ? v.pressure : none.pressure;
            const Vec<D> velocity = probes[i].velocity ? v.velocity : none.velocity;
            const Spin<D> vorticity = probes[i].vorticity ? v.vorticity : none.vorticity;
            probes_->row(report.step, report.time, probes[i].name, point + 1, places[at], static_cast<int>(v.kind),
                         Eigen::Map<const Eigen::VectorXd>(&pressure, pressure_ ? 1 : 0),
                         Eigen::Map<const Eigen::VectorXd>(velocity.data(), velocity_ ? D : 0),
                         Eigen::Map<const Eigen::VectorXd>(vorticity.data(), vorticity_ ? spin_size<D> : 0));
        }
    probes_->flush();
}

template <int D>
void MeasureTables<D>::write_fluxes(const Simulation<D>& simulation, const StepReport& report)
{
    const std::vector<FluxScene>& fluxes = simulation.scene().fluxes;
    for (std::size_t i = 0; i < fluxes.size(); ++i) {
        if (!fluxes_due_[i](report.time))
            continue;
        const VolumeFlux v = simulation.volume_flux(fluxes[i]);
        if (fluxes_)
            fluxes_->row(report.step, report.time, fluxes[i].name, v.flux, v.inflow, v.outflow, v.film, v.bodies);
    }
    if (fluxes_)
        fluxes_->flush();
}

template <int D>
void MeasureTables<D>::write_forces(const Simulation<D>& simulation, const StepReport& report)
{
    const std::vector<ForceParts<D>>& forces = simulation.force_parts();
    for (std::size_t b = 0; b < forces.size(); ++b) {
        if (simulation.removed(static_cast<int>(b)))
            continue;
        Eigen::Matrix<double, 5 * twist_size<D>, 1> all;
        int at = 0;
        for (const auto& [name, part] : parts<D>())
            all.template segment<twist_size<D>>(twist_size<D> * at++) = forces[b].*part;
        all.array() += 0.0; // no -0
        forces_->row(report.step, report.time, simulation.bodies()[b].name, all);
    }
    forces_->flush();
}

template class MeasureTables<2>;
template class MeasureTables<3>;

} // namespace gapflow
