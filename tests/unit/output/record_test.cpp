#include "gapflow/output/progress.hpp"
#include "gapflow/output/pvd.hpp"
#include "gapflow/output/run_record.hpp"

#include "temporary.hpp"

#include "gapflow/core/logging.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <sstream>

using namespace gapflow;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

namespace {

// What a Progress writes while `use` drives it.
template <class F>
std::string progress_text(ProgressStyle style, F&& use)
{
    std::FILE* out = std::tmpfile();
    {
        Progress progress(style, 0.0, 1.0, out);
        use(progress);
    }
    std::rewind(out);
    std::string text;
    for (int c; (c = std::fgetc(out)) != EOF;)
        text += static_cast<char>(c);
    std::fclose(out);
    return text;
}

} // namespace

TEST(Pvd, ListsPartsOfATimeStep)
{
    const test::TemporaryFolder folder;
    PvdCollection collection(folder / "gapflow.pvd");
    collection.add(0.0, "fields", "fields/0.vti");
    collection.add(0.0, "a<\"b\"", "bodies/a_0.vtp");
    collection.add(0.1, "fields", "fields/1.vti");
    collection.write();
    const std::string text = test::content_of(folder / "gapflow.pvd");
    EXPECT_THAT(text, HasSubstr(R"(timestep="0" group="" part="1" name="a&lt;&quot;b&quot;" file="bodies/a_0.vtp")"));
    EXPECT_THAT(text, HasSubstr(R"(timestep="0.1" group="" part="0" name="fields" file="fields/1.vti")"));
}

TEST(Pvd, ResumeCutsBackToItsFirstFramesAndWritesTheSameAgain)
{
    const test::TemporaryFolder folder;
    const auto path = folder / "gapflow.pvd";
    PvdCollection collection(path);
    collection.add(0.1, "fields & more", "fields/fields_00000.vti");
    collection.write();
    const std::string first = test::content_of(path);
    collection.add(0.2, "fields & more", "fields/fields_00001.vti");
    collection.write();
    PvdCollection::resume(path, 1).write();
    EXPECT_EQ(test::content_of(path), first);
}

TEST(RunRecord, HoldsWhatWasGiven)
{
    const test::TemporaryFolder folder;
    const Communicator comm;
    StageTimers timers;
    timers.add("solve", 1.5);
    timers.add("solve", 0.25);
    RunRecord record;
    record.version = "0.1.0";
    record.scene = "title = \"two plates\"\n";
    record.status = "done";
    record.warnings = {"one", "two"};
    record.machine = describe_machine(comm);
    record.stages = timers.stages();
    record.memory = peak_memory(comm);
    write_run_record(folder / "run.json", record);
    const auto json = nlohmann::json::parse(test::content_of(folder / "run.json"));
    EXPECT_EQ(json["version"], "0.1.0");
    EXPECT_EQ(json["scene"], record.scene);
    EXPECT_EQ(json["timings"]["stages"]["solve"]["seconds"], 1.75);
    EXPECT_EQ(json["timings"]["stages"]["solve"]["count"], 2);
    EXPECT_EQ(json["machine"]["ranks"], comm.size());
    EXPECT_GT(json["machine"]["cores"], 0);
    EXPECT_FALSE(json["machine"]["cpu"].get<std::string>().empty());
    EXPECT_GT(json["peak_memory_bytes"]["sum"], 1e6);
    EXPECT_EQ(warnings_of_record(folder / "run.json"), record.warnings);
    EXPECT_TRUE(warnings_of_record(folder / "none.json").empty());
}

TEST(StageTimers, MeasuresAScope)
{
    StageTimers timers;
    {
        const auto timer = timers.measure("rebuild");
    }
    EXPECT_EQ(timers.stages().at("rebuild").count, 1);
    EXPECT_GE(timers.seconds("rebuild"), 0.0);
    EXPECT_EQ(timers.seconds("never"), 0.0);
}

TEST(Progress, LogHasALineAnOutputTime)
{
    const std::string text = progress_text(ProgressStyle::log, [](Progress& progress) {
        progress.step({0.25, 0.01, 25, 7});
        progress.output({0.5, 0.01, 50, 8});
    });
    EXPECT_THAT(text, StartsWith("t = 0.5 of 1  dt = 1.00e-02  step 50  8 iterations  ETA 0:00:0"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
}

TEST(Progress, TerminalRepaintsOneLine)
{
    const std::string text = progress_text(ProgressStyle::terminal, [](Progress& progress) {
        progress.step({0.25, 0.01, 25, 7});
        progress.step({0.26, 0.01, 26, 7}); // too soon to repaint
        progress.output({0.5, 0.01, 50, 8});
    });
    EXPECT_THAT(text, StartsWith("\rt = 0.25 of 1"));
    EXPECT_THAT(text, Not(HasSubstr("step 26")));
    EXPECT_THAT(text, HasSubstr("\rt = 0.5 of 1"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
    EXPECT_EQ(text.back(), '\n');
}

TEST(Progress, QuietWritesNothing)
{
    const Communicator comm;
    EXPECT_EQ(choose_progress_style(comm, true), ProgressStyle::silent);
    EXPECT_EQ(progress_text(ProgressStyle::silent, [](Progress& progress) { progress.output({0.5, 0.01, 50, 8}); }), "");
}

TEST(Logger, LevelsQuietAndOnce)
{
    const Communicator comm;
    std::ostringstream loud, quiet;
    Logger(comm, false, loud).info("100% {}");
    EXPECT_EQ(loud.str(), comm.root() ? "info: 100% {}\n" : "");
    Logger logger(comm, true, quiet);
    logger.info("nothing");
    logger.warn_once("a gap is held");
    logger.warn_once("a gap is held");
    logger.error("failed");
    EXPECT_EQ(quiet.str(), comm.root() ? "warning: a gap is held\nerror: failed\n" : "");
}
