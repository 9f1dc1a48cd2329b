#include "gapflow/output/columns.hpp"

namespace gapflow {

std::vector<Column<StepReport>> step_columns(int dimension, bool driven, bool steady, bool parts)
{
    using R = StepReport;
    std::vector<Column<R>> columns{
        {"step", &R::step},
        {"time", &R::time},
        {"dt", &R::dt},
        {"cells", &R::cells},
        {"film_nodes", &R::film_nodes},
        {"iterations", &R::iterations},
        {"residual", &R::residual},
        {"divergence_max", &R::divergence_max},
        {"energy_fluid", &R::energy_fluid},
        {"energy_bodies", &R::energy_bodies},
        {"viscous_iterations", &R::viscous_iterations},
        {"dissipation_grid", &R::dissipation_grid},
        {"dissipation_film", &R::dissipation_film},
        {"solves", &R::solves},
        {"seconds", &R::seconds},
    };
    const Column<R> gradient[] = {{"pressure_gradient_x", &R::pressure_gradient_x},
                                  {"pressure_gradient_y", &R::pressure_gradient_y},
                                  {"pressure_gradient_z", &R::pressure_gradient_z}};
    const Column<R> velocity[] = {{"mean_velocity_x", &R::mean_velocity_x},
                                  {"mean_velocity_y", &R::mean_velocity_y},
                                  {"mean_velocity_z", &R::mean_velocity_z}};
    if (driven) {
        columns.insert(columns.end(), gradient, gradient + dimension);
        columns.insert(columns.end(), velocity, velocity + dimension);
    }
    if (parts)
        columns.push_back({"corrected_energy", &R::corrected_energy});
    if (steady)
        columns.push_back({unsteadiness_column, &R::unsteadiness});
    return columns;
}

std::span<const Column<GapState>> gap_columns()
{
    using G = GapState;
    static const Column<G> columns[] = {
        {"body_a", &G::body_a},
        {"body_b", &G::body_b},
        {"thickness", &G::thickness},
        {"opening_rate", &G::opening_rate},
        {"film_nodes", &G::film_nodes},
        {"film_area", &G::film_area},
        {"pressure_min", &G::pressure_min},
        {"pressure_max", &G::pressure_max},
        {"force", &G::force},
        {"contact_force", &G::contact_force},
        {"contact_impulse", &G::contact_impulse},
        {"void_volume", &G::void_volume},
    };
    return columns;
}

std::vector<std::string> BodyColumns::all() const
{
    std::vector<std::string> names;
    for (const auto& part : {position, rotation, velocity, force})
        names.insert(names.end(), part.begin(), part.end());
    return names;
}

BodyColumns body_columns(int dimension)
{
    if (dimension == 2)
        return {{"x", "y"}, {"angle"}, {"vx", "vy", "omega"}, {"fx", "fy", "torque"}};
    return {
        {"x", "y", "z"}, {"qw", "qx", "qy", "qz"}, {"vx", "vy", "vz", "wx", "wy", "wz"}, {"fx", "fy", "fz", "tx", "ty", "tz"}};
}

} // namespace gapflow
