#include "gapflow/output/run.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/output/checkpoint.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace gapflow {

namespace {

template <int D>
std::unique_ptr<Simulation<D>> restored(const Scene& scene, const Communicator& comm, const Checkpoint& from,
                                        const std::string& file)
{
    try {
        return std::make_unique<Simulation<D>>(scene, comm, from.state);
    } catch (const StateError& error) {
        throw_checkpoint_error(file, error.what());
    }
}

} // namespace

template <int D>
Run<D>::Run(const Scene& scene, const Communicator& comm, const RunPlace& place, const FaceField<D>* velocity)
    : version_(place.version), end_(scene.end), resumed_(!place.resume.empty())
{
    std::optional<Checkpoint> from;
    if (resumed_ && velocity)
        throw InputError(place.resume + ": a checkpoint has the fluid's velocity; give either the one or the other");
    if (resumed_) {
        from = read_checkpoint(place.resume, comm);
        require_same_scene(place.resume, *from, scene);
        simulation_ = restored<D>(scene, comm, *from, place.resume);
        smallest_gap_ = from->position.smallest_gap;
    } else {
        simulation_ =
            velocity ? std::make_unique<Simulation<D>>(scene, comm, *velocity) : std::make_unique<Simulation<D>>(scene, comm);
    }
    report_ = simulation_->initial_report();
    for (const RigidBody<D>& body : simulation_->bodies())
        if (body.motion != Motion::fixed)
            moving_.insert(body.name);
    if (place.folder.empty())
        return;
    files_.emplace(place.folder, *simulation_, place.version, from ? &from->position : nullptr);
    schedule_.emplace(scene, simulation_->time());
}

template <int D>
void Run<D>::write_start()
{
    if (!files_ || resumed_)
        return;
    try {
        files_->write_step(*simulation_, report_);
        files_->write_fields(*simulation_);
        shown_ = true;
    } catch (const std::exception& error) {
        record_failure(error.what());
        throw;
    }
}

template <int D>
const StepReport& Run<D>::step(double until)
{
    Simulation<D>& s = *simulation_;
    if (s.time() < end_)
        until = std::min(until, end_);
    if (schedule_)
        until = std::min(until, schedule_->next_output());
    shown_ = stored_ = false;
    try {
        report_ = s.step(until);
        note_smallest_gap();
        if (!files_) {
            end_if_asked();
            demand_core();
            return report_;
        }
        files_->write_step(s, report_);
        shown_ = schedule_->output_due(s.time());
        if (shown_)
            files_->write_fields(s);
        stored_ = schedule_->checkpoint_due(s.time());
        if (stored_)
            files_->write_checkpoint(s, smallest_gap_);
        end_if_asked();
        demand_core();
    } catch (const std::exception& error) {
        record_failure(error.what());
        throw;
    }
    return report_;
}

// Ends a run in which something has left the core of a graded grid, with a checkpoint and the fields of this moment.
template <int D>
void Run<D>::demand_core()
{
    const auto outside = simulation_->outside_core();
    if (!outside)
        return;
    if (files_)
        write_last();
    throw ComputationError(fmt::format("at time {:.6g} {}; choose a larger domain.core", simulation_->time(), *outside));
}

// Before time.end.
template <int D>
void Run<D>::end_if_asked()
{
    const Simulation<D>& s = *simulation_;
    if (s.time() >= end_ || !ended_by_.empty()) // whoever steps on has been told
        return;
    if (s.settled())
        ended_by_ = "time.until_steady";
    else if (report_.leaving && s.scene().leaving == Scene::Leaving::stop)
        ended_by_ = "domain.leaving";
    if (files_ && !ended_by_.empty())
        write_last();
}

// A checkpoint and the fields of this moment, where they are not there yet: a run that continues from it replaces the fields.
template <int D>
void Run<D>::write_last()
{
    if (!stored_)
        files_->write_checkpoint(*simulation_, smallest_gap_);
    if (!shown_)
        files_->write_fields(*simulation_);
    stored_ = shown_ = true;
}

// Gaps between two solids that stand still are as the scene has them.
template <int D>
void Run<D>::note_smallest_gap()
{
    for (const GapState& gap : simulation_->gaps())
        if (gap.thickness < smallest_gap_ && (moving_.contains(gap.body_a) || moving_.contains(gap.body_b))) {
            smallest_gap_ = gap.thickness;
            smallest_gap_place_ =
                fmt::format("between '{}' and '{}' at time {:.4g}", gap.body_a, gap.body_b, simulation_->time());
        }
}

template <int D>
void Run<D>::write_checkpoint(const std::filesystem::path& path) const
{
    const RunPosition position{simulation_->steps(), files_ ? files_->frames() : 0, smallest_gap_};
    gapflow::write_checkpoint(path, {version_, scene_as_json(simulation_->scene()), position, simulation_->state()},
                              simulation_->grid().comm());
}

template <int D>
Run<D>::Run(Copy, const Run& from)
    : simulation_(std::make_unique<Simulation<D>>(from.simulation().scene(), from.simulation().grid().comm(),
                                                  from.simulation().state())),
      report_(from.report_), version_(from.version_), smallest_gap_place_(from.smallest_gap_place_), moving_(from.moving_),
      end_(from.end_), smallest_gap_(from.smallest_gap_), resumed_(from.resumed_)
{
}

template <int D>
std::unique_ptr<Run<D>> Run<D>::copy() const
{
    return std::unique_ptr<Run<D>>(new Run(Copy{}, *this));
}

template <int D>
void Run<D>::change(const Scene& scene)
{
    simulation_ = std::make_unique<Simulation<D>>(scene, simulation_->grid().comm(), simulation_->state());
    ended_by_.clear(); // what has settled may flow again
}

template <int D>
void Run<D>::interrupt()
{
    if (!files_)
        return;
    write_last();
    files_->finish(*simulation_, "interrupted");
}

template <int D>
void Run<D>::finish()
{
    if (files_)
        files_->finish(*simulation_, "done", "", ended_by());
}

template <int D>
void Run<D>::record_failure(const char* message)
{
    if (!files_)
        return;
    try {
        files_->finish(*simulation_, "failed", message);
    } catch (const ComputationError&) { // a full disk may refuse the record too; the first error counts
    }
}

template class Run<2>;
template class Run<3>;

} // namespace gapflow
