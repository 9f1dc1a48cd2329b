// Which folders a run may write into, and what is removed from one before it does.
#include "gapflow/output/run_folder.hpp"

#include "temporary.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/output/pvd.hpp"
#include "gapflow/output/run_record.hpp"
#include "gapflow/scene/parse_scene.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

using namespace gapflow;
using testing::HasSubstr;

namespace {

Scene scene_of(const std::string& file, const std::string& more = "")
{
    return parse_scene("[domain]\nsize = [1, 1]\ncells = [8, 8]\n[time]\nend = 1\nmax_step = 0.1\n" + more, file, {},
                       Purpose::run);
}

RunRecord record_of(const Scene& scene, const std::string& status)
{
    RunRecord record;
    record.version = "0.1.0";
    record.scene_file = path_of_scene(scene);
    record.scene = scene_as_json(scene);
    record.status = status;
    record.time = 0.25;
    return record;
}

std::string refusal(const std::filesystem::path& folder, const Scene& scene, const FolderClaim& claim = {})
{
    try {
        claim_folder(folder, scene, claim, Communicator());
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

// The record as if another process had written it.
void set_process(const std::filesystem::path& path, const nlohmann::json& process)
{
    nlohmann::json record = nlohmann::json::parse(test::content_of(path));
    record["process"].update(process);
    std::ofstream(path) << record;
}

void touch(const std::filesystem::path& path)
{
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << "x";
}

} // namespace

TEST(RunFolder, AnotherScenesRunIsRefusedWithoutForce)
{
    const test::TemporaryFolder folder;
    const test::TemporaryFile one("one.toml", "x"), two("two.toml", "y");
    const Scene first = scene_of(one.path()), other = scene_of(two.path(), "[fluid]\ndensity = 3\n");
    EXPECT_EQ(refusal(folder / "nothing", other), "");
    EXPECT_EQ(refusal(folder.path(), other), "");
    write_run_record(folder / "run.json", record_of(first, "done"));
    EXPECT_THAT(refusal(folder.path(), other),
                HasSubstr("holds another run, of " + path_of_scene(first) + ", done at time 0.25"));
    EXPECT_THAT(refusal(folder.path(), other), HasSubstr("(-o DIR)"));
    EXPECT_THAT(refusal(folder.path(), other), HasSubstr("--force"));
    EXPECT_EQ(refusal(folder.path(), other, {true, false}), "");
    EXPECT_EQ(refusal(folder.path(), other, {false, true}), "");
    EXPECT_EQ(refusal(folder.path(), scene_of(one.path(), "[fluid]\ndensity = 3\n")), "");       // the same file, edited
    EXPECT_EQ(refusal(folder.path(), scene_of(two.path(), "[solver]\ntolerance = 1e-6\n")), ""); // the same scene, copied
}

TEST(RunFolder, ARunThatIsUnderWayIsNotDisturbed)
{
    const test::TemporaryFolder folder;
    const test::TemporaryFile one("one.toml", "x");
    const Scene scene = scene_of(one.path());
    write_run_record(folder / "run.json", record_of(scene, "running"));
    EXPECT_EQ(read_recorded_run(folder / "run.json")->state, RunState::running); // by this process
    for (const FolderClaim& claim : {FolderClaim{false, false}, FolderClaim{true, false}, FolderClaim{false, true}})
        EXPECT_THAT(refusal(folder.path(), scene, claim),
                    HasSubstr("process " + std::to_string(getpid()) + " writes a run there"));
    set_process(folder / "run.json", {{"started", 1}}); // another process has taken its number since
    EXPECT_EQ(read_recorded_run(folder / "run.json")->state, RunState::killed);
    EXPECT_EQ(refusal(folder.path(), scene), "");
}

TEST(RunFolder, AKilledRunIsToldFromOneThatRuns)
{
    const test::TemporaryFolder folder;
    const test::TemporaryFile one("one.toml", "x");
    const Scene scene = scene_of(one.path());
    const pid_t child = fork();
    if (child == 0) {
        write_run_record(folder / "run.json", record_of(scene, "running"));
        pause();
        _exit(0);
    }
    while (!std::filesystem::exists(folder / "run.json"))
        usleep(1000);
    const auto state = [&] { return read_recorded_run(folder / "run.json")->state; };
    EXPECT_EQ(state(), RunState::running);
    kill(child, SIGKILL);
    while (state() == RunState::running) // until the kernel has ended it; it waits for its parent as a zombie then
        usleep(1000);
    EXPECT_EQ(state(), RunState::killed);
    waitpid(child, nullptr, 0);
    EXPECT_EQ(state(), RunState::killed);
    EXPECT_EQ(read_recorded_run(folder / "run.json")->process.id, child);
}

TEST(RunFolder, OnAnotherHostTheHeartbeatDecides)
{
    const test::TemporaryFolder folder;
    const test::TemporaryFile one("one.toml", "x");
    const Scene scene = scene_of(one.path());
    write_run_record(folder / "run.json", record_of(scene, "running"));
    set_process(folder / "run.json", {{"host", "elsewhere"}});
    EXPECT_THAT(refusal(folder.path(), scene), HasSubstr("on elsewhere"));
    EXPECT_EQ(refusal(folder.path(), scene, {true, false}), "");
    set_process(folder / "run.json", {{"heartbeat", 1000}});
    EXPECT_EQ(read_recorded_run(folder / "run.json")->state, RunState::killed);
    EXPECT_EQ(refusal(folder.path(), scene), "");
}

TEST(RunFolder, ClearingLeavesWhatIsNotTheRuns)
{
    const test::TemporaryFolder parent;
    const std::filesystem::path folder = parent / "run";
    const test::TemporaryFile one("one.toml", "x");
    for (const char* name : {"notes.txt", "report.html", "fields/mine.vti", "bodies/other_00000.vtp", "fields/fields_00001.vti",
                             "fields/fields_00002.vti.partial", "bodies/ball_00000.vtp", "films/films_00000.vtp", "steps.csv",
                             "probes.csv", "checkpoint.h5"})
        touch(folder / name);
    PvdCollection collection(folder / "gapflow.pvd");
    collection.add(0, "ball", "bodies/ball_00000.vtp");
    collection.add(0, "away", "../elsewhere.vtp");
    collection.write();
    touch(parent / "elsewhere.vtp");
    clear_run(folder); // no record: not a run's folder
    EXPECT_TRUE(std::filesystem::exists(folder / "steps.csv"));
    write_run_record(folder / "run.json", record_of(scene_of(one.path()), "done"));
    clear_run(folder);
    for (const char* name : {"notes.txt", "report.html", "fields/mine.vti", "bodies/other_00000.vtp", "../elsewhere.vtp"})
        EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    for (const char* name : {"fields/fields_00001.vti", "fields/fields_00002.vti.partial", "bodies/ball_00000.vtp",
                             "films/films_00000.vtp", "steps.csv", "probes.csv", "checkpoint.h5", "gapflow.pvd", "run.json"})
        EXPECT_FALSE(std::filesystem::exists(folder / name)) << name;
}
