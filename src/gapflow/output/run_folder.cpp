#include "gapflow/output/run_folder.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/output/checkpoint.hpp"
#include "gapflow/output/file.hpp"
#include "gapflow/output/pvd.hpp"
#include "gapflow/output/run_record.hpp"

#include <regex>
#include <system_error>

namespace gapflow {

namespace {

constexpr const char* tables[] = {"bodies.csv",         "bodies.npy", "gaps.csv",   "steps.csv", "crowds.csv",
                                  "crowd_profiles.csv", "probes.csv", "fluxes.csv", "forces.csv"};

std::string name_of(const RecordedRun& run)
{
    std::string name = run.scene_file.empty() ? "a scene" : run.scene_file;
    if (!run.title.empty())
        name += " (\"" + run.title + "\")";
    return name;
}

std::string word_of(RunState state)
{
    switch (state) {
    case RunState::running:
        return "running";
    case RunState::killed:
        return "killed";
    case RunState::done:
        return "done";
    case RunState::failed:
        return "failed";
    case RunState::interrupted:
        return "interrupted";
    case RunState::unknown:
        break;
    }
    return "in an unknown state";
}

bool is_same_scene(const RecordedRun& run, const Scene& scene)
{
    if (!run.scene_file.empty() && run.scene_file == path_of_scene(scene))
        return true;
    try {
        return same_scene(run.scene, scene_as_json(scene));
    } catch (const std::exception&) { // of another version, or damaged
        return false;
    }
}

void check(const std::filesystem::path& folder, const Scene& scene, const FolderClaim& claim)
{
    const std::optional<RecordedRun> run = read_recorded_run(folder / "run.json");
    if (!run)
        return;
    const std::string place = folder.string() + ": ", elsewhere = "choose another folder (-o DIR)";
    if (run->state == RunState::running && run->here)
        throw InputError(place + "process " + std::to_string(run->process.id) + " writes a run there, of " + name_of(*run) +
                         "; wait for its end, stop it (kill " + std::to_string(run->process.id) + "), or " + elsewhere);
    if (run->state == RunState::running && !claim.force)
        throw InputError(place + "process " + std::to_string(run->process.id) + " on " + run->process.host +
                         " has written a run there in the last ten minutes, of " + name_of(*run) +
                         "; wait for its end, add --force if it is gone, or " + elsewhere);
    if (claim.force || claim.resumes || is_same_scene(*run, scene))
        return;
    throw InputError(place + "holds another run, of " + name_of(*run) + ", " + word_of(run->state) + " at time " +
                     number_text(run->time) + "; " + elsewhere + ", or replace that run's files (--force)");
}

// Files of a folder whose names are as a run numbers its frames, the incomplete ones of a killed run too.
void remove_frames(const std::filesystem::path& folder, const std::string& name, const std::string& type)
{
    const std::regex numbered(name + "_[0-9]{5,}\\." + type + "(\\" + partial_extension + ")?");
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (std::regex_match(entry->path().filename().string(), numbered))
            std::filesystem::remove(entry->path());
}

} // namespace

std::string path_of_scene(const Scene& scene)
{
    std::error_code error;
    if (scene.file.empty() || !std::filesystem::is_regular_file(scene.file, error))
        return {};
    const std::filesystem::path path = std::filesystem::canonical(scene.file, error);
    return error ? std::string() : path.string();
}

void claim_folder(const std::filesystem::path& folder, const Scene& scene, const FolderClaim& claim, const Communicator& comm)
{
    on_root(comm, [&] { check(folder, scene, claim); });
}

void clear_run(const std::filesystem::path& folder)
{
    std::error_code error;
    if (!std::filesystem::exists(folder / "run.json", error))
        return;
    const auto collection = PvdCollection::resume(folder / "gapflow.pvd");
    for (const PvdCollection::Entry& entry : collection.entries()) {
        const std::filesystem::path file = std::filesystem::path(entry.file).lexically_normal();
        if (file.is_relative() && *file.begin() != "..")
            std::filesystem::remove(folder / file, error);
    }
    for (const char* type : {"vti", "vtr"})
        remove_frames(folder / "fields", "fields", type);
    remove_frames(folder / "films", "films", "vtp");
    for (const char* name : tables)
        std::filesystem::remove(folder / name, error);
    for (const char* name :
         {"gapflow.pvd", "checkpoint.h5", "run.json"}) { // the record last: until then the folder holds a run
        std::filesystem::remove(folder / (std::string(name) + partial_extension), error);
        std::filesystem::remove(folder / name, error);
    }
}

} // namespace gapflow
