// The way from a run's files to page and pictures: stored_run, run_view, colour_map, report_page, frame_pictures.
#include "gapflow/output/run_view.hpp"

#include "temporary.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/output/base64.hpp"
#include "gapflow/output/colour_map.hpp"
#include "gapflow/output/frame_pictures.hpp"
#include "gapflow/output/pvd.hpp"
#include "gapflow/output/report_page.hpp"
#include "gapflow/output/vtk.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

using namespace gapflow;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

// A run of a square that moves right by 0.1 a frame and turns by 90 degrees in all, with fields pressure = x and a film along y
// = 0.5.
class SmallRun {
public:
    explicit SmallRun(int frames, int cells = 8)
    {
        const Communicator comm;
        std::array<SideKind, 4> sides;
        sides.fill(SideKind::wall);
        const Grid<2> grid(gapflow::Vec<2>::Zero(), 2.0 / cells, Index<2>::Constant(cells), sides, 2, comm);
        const nlohmann::json scene = {
            {"title", "small"},
            {"domain", {{"origin", {0, 0}}, {"size", {2, 2}}, {"cells", {cells, cells}}, {"sides", nlohmann::json::object()}}},
            {"fluid", {{"reference_pressure", 0}}},
            {"body", {{{"name", "a, \"b\""}, {"shape", "box"}, {"motion", "free"}, {"inside_out", false}}}}};
        write("run.json", nlohmann::json({{"status", "done"}, {"scene", scene.dump()}}).dump());
        std::string steps = "step,time,dt\n", bodies = "step,time,body,x,y,angle\n",
                    gaps = "step,time,body_a,body_b,thickness\n";
        PvdCollection collection(folder_ / "gapflow.pvd");
        for (const char* part : {"fields", "bodies", "films"})
            std::filesystem::create_directories(folder_ / part);
        for (int k = 0; k < frames; ++k) {
            const double time = 0.5 * k, angle = k * std::acos(0.0) / std::max(frames - 1, 1);
            const std::string number = std::to_string(k), name = "_0000" + number;
            steps += number + "," + std::to_string(time) + ",0.5\n";
            bodies += number + "," + std::to_string(time) + ",\"a, \"\"b\"\"\"," + std::to_string(0.5 + 0.1 * k) + ",1," +
                      std::to_string(angle) + "\n";
            gaps += number + "," + std::to_string(time) + ",\"a, \"\"b\"\"\",wall:x_low," +
                    std::to_string(std::abs(k - 2) + 0.5) + "\n";
            write_cells<2>(folder_ / ("fields/fields" + name + ".vti"), grid,
                           std::vector<VtkArray>{
                               cell_array(grid, "pressure", 1, [&](const Index<2>& c, int) { return grid.cell_centre(c)[0]; }),
                               cell_array(grid, "kind", 1, [&](const Index<2>& c, int) { return c[0] == 0 ? 0.0 : 1.0; })});
            write_vtp<2>(folder_ / ("bodies/a" + name + ".vtp"), square({0.5 + 0.1 * k, 1}));
            write_vtp<2>(folder_ / ("films/films" + name + ".vtp"),
                         {{{0, 0.5}, {1, 0.5}}, {{0, 1}}, {{"thickness", 1, {0.1, 0.2}}, {"pressure", 1, {-1, 3}}}, {}});
            collection.add(time, "fields", "fields/fields" + name + ".vti");
            collection.add(time, "a, \"b\"", "bodies/a" + name + ".vtp");
            collection.add(time, "films", "films/films" + name + ".vtp");
        }
        collection.write();
        write("steps.csv", steps);
        write("bodies.csv", bodies + "9,1"); // being written
        write("gaps.csv", gaps);
    }
    std::filesystem::path path() const { return folder_.path(); }

private:
    static VtkSurface<2> square(const gapflow::Vec<2>& centre)
    {
        VtkSurface<2> surface;
        for (const auto& [x, y] : {std::pair{-0.2, -0.1}, std::pair{0.2, -0.1}, std::pair{0.2, 0.1}, std::pair{-0.2, 0.1}})
            surface.points.push_back(centre + gapflow::Vec<2>(x, y));
        surface.elements = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
        return surface;
    }
    void write(const std::string& name, const std::string& content) { std::ofstream(folder_ / name) << content; }

    test::TemporaryFolder folder_;
};

} // namespace

TEST(StoredRun, TablesFramesAndNames)
{
    const SmallRun small(3);
    const StoredRun run = read_run(small.path());
    EXPECT_EQ(run.dimension, 2);
    EXPECT_EQ(run.bodies.rows, 3U);
    EXPECT_THAT(run.bodies.text("body"), ElementsAre("a, \"b\"", "a, \"b\"", "a, \"b\""));
    EXPECT_THAT(run.bodies.number("x"), ElementsAre(0.5, 0.6, 0.7));
    EXPECT_THAT(run.bodies.number("nothing"), IsEmpty());
    ASSERT_EQ(run.frames.size(), 3U);
    EXPECT_EQ(run.frames[2].number, 2);
    EXPECT_EQ(run.frames[2].time, 1.0);
    EXPECT_EQ(run.frames[2].fields, "fields/fields_00002.vti");
    EXPECT_EQ(run.frames[2].bodies.at("a, \"b\""), "bodies/a_00002.vtp");
}

TEST(StoredRun, FilesThatAreGoneAreNoFrames)
{
    const SmallRun small(3);
    for (const char* part : {"fields", "films", "bodies"})
        std::filesystem::remove_all(small.path() / part);
    EXPECT_THAT(read_run(small.path()).frames, IsEmpty());
    EXPECT_THROW(write_frame_pictures(read_run(small.path()), small.path() / "frames"), InputError);
}

TEST(RunView, BodiesMoveAsTheTableSays)
{
    const SmallRun small(3);
    const StoredRun run = read_run(small.path());
    const RunView view = view_run(run);
    ASSERT_EQ(view.bodies.size(), 1U);
    EXPECT_THAT(view.bodies[0].outlines, ElementsAre(ElementsAre(0, 1, 2, 3, 0)));
    const Placement placement = view_frame(run, view, run.frames[2]).placements.at(0);
    // The corner (0.3, 0.9), 0.2 left of and 0.1 below the centre, a quarter turn on: 0.1 right of and 0.2 below the new
    // centre.
    EXPECT_LT((placement.rotation * view.bodies[0].points[0] + placement.shift - Eigen::Vector3d(0.8, 0.8, 0)).norm(), 1e-5);
}

TEST(RunView, FieldsReachIntoSolidsNextToFluid)
{
    const SmallRun small(1);
    const StoredRun run = read_run(small.path());
    const FrameView frame = view_frame(run, view_run(run), run.frames[0]);
    ASSERT_EQ(frame.planes.size(), 1U);
    const FieldPlane& plane = frame.planes[0];
    EXPECT_THAT(plane.cells, ElementsAre(8, 8));
    EXPECT_FLOAT_EQ(plane.pressure[8 * 3 + 5], 5.5 * 0.25);
    EXPECT_FLOAT_EQ(plane.pressure[8 * 3], 1.5 * 0.25); // the first column is solid: it has its neighbours' value
    EXPECT_EQ(plane.fluid[8 * 3], 0);
    EXPECT_EQ(plane.fluid[8 * 3 + 1], 1);
    EXPECT_THAT(plane.speed, IsEmpty()); // the run wrote no velocity
    EXPECT_THAT(frame.film.chains, ElementsAre(ElementsAre(0, 1)));
    EXPECT_THAT(frame.film.pressure, ElementsAre(-1, 3));
}

TEST(RunView, CoarserPlanesAreMeansOfBlocks)
{
    const SmallRun small(1);
    const StoredRun run = read_run(small.path());
    const FieldPlane plane = view_frame(run, view_run(run), run.frames[0], 16).planes.at(0);
    EXPECT_THAT(plane.cells, ElementsAre(4, 4));
    EXPECT_EQ(plane.spacing, 0.5);
    EXPECT_FLOAT_EQ(plane.pressure[4 + 2], 0.5 * (4.5 + 5.5) * 0.25);
}

TEST(RunView, ChainsFollowElementsInAnyOrder)
{
    EXPECT_THAT(chains_of({}), IsEmpty());
    EXPECT_THAT(chains_of({1, 2, 0, 1, 3, 2}), UnorderedElementsAre(ElementsAre(0, 1, 2, 3)));
    EXPECT_THAT(chains_of({0, 1, 2, 0, 1, 2}), ElementsAre(ElementsAre(0, 1, 2, 0)));
    // Three branches that meet in node 1.
    const auto branches = chains_of({0, 1, 1, 2, 3, 1});
    EXPECT_EQ(branches.size(), 3U);
    for (const auto& chain : branches)
        EXPECT_EQ(chain.size(), 2U);
}

TEST(RunView, RangesLeaveOutWhatIsNoNumber)
{
    const auto nan = static_cast<float>(nan_value);
    EXPECT_THAT(range_between({nan, 3, 1, 2, nan}, 0, 1), ElementsAre(1, 3));
    EXPECT_THAT(range_between({5, 1, 2, 3, 4}, 0.25, 0.75), ElementsAre(2, 4));
    EXPECT_THAT(range_between({nan}, 0, 1), ElementsAre(0, 0));
}

TEST(ColourMap, EndsAndMiddle)
{
    const auto numbers = [](const Colour& c) { return std::array<int, 3>{c.red, c.green, c.blue}; };
    EXPECT_THAT(numbers(colour_at(ColourMap::speed, -1)), ElementsAre(0x44, 0x01, 0x54));
    EXPECT_THAT(numbers(colour_at(ColourMap::speed, 2)), ElementsAre(0xfd, 0xe7, 0x25));
    EXPECT_THAT(numbers(colour_at(ColourMap::pressure, 0.5)), ElementsAre(0xf7, 0xf6, 0xf6));
    // Half way between two colours of the table.
    EXPECT_THAT(numbers(colour_at(ColourMap::film, 0.5 / 16)),
                ElementsAre((0x0d + 0x31 + 1) / 2, (0x08 + 0x05 + 1) / 2, (0x87 + 0x97) / 2));
}

TEST(ColourMap, PressureIsSymmetricAboutTheReferenceInside)
{
    FrameView frame;
    frame.planes.resize(1);
    for (int i = 0; i < 1001; ++i) {
        frame.planes[0].pressure.push_back(static_cast<float>(-1 + 0.004 * i)); // -1 ... 3
        frame.planes[0].fluid.push_back(1);
    }
    frame.film.pressure = {2, 2};
    RangeSampler sampler;
    sampler.add(frame);
    const ColourRanges inside = sampler.ranges(0), outside = sampler.ranges(10);
    EXPECT_NEAR(inside.pressure.high, 2.96, 1e-6);
    EXPECT_NEAR(inside.pressure.low, -2.96, 1e-6);
    EXPECT_NEAR(outside.pressure.low, -0.96, 1e-6);
    EXPECT_EQ(inside.speed.low, 0);
    EXPECT_EQ(inside.speed.high, 1); // no speed at all: any range
    EXPECT_LT(inside.film.low, 2);
    EXPECT_GT(inside.film.high, 2);
    EXPECT_DOUBLE_EQ(inside.film.share(2), 0.5);
}

TEST(ColourMap, ASlamInOneOfManyFramesDoesNotSetTheRange)
{
    RangeSampler sampler;
    for (int k = 0; k < 40; ++k) {
        FrameView frame;
        frame.planes.resize(1);
        frame.planes[0].pressure.assign(100, k == 17 ? 1000.0F : static_cast<float>(k));
        frame.planes[0].fluid.assign(100, 1);
        sampler.add(frame);
    }
    const double high = sampler.ranges(0).pressure.high;
    EXPECT_GE(high, 37);
    EXPECT_LE(high, 39);
}

TEST(ReportPage, LongRunsAreThinnedAndSaySo)
{
    const SmallRun small(8);
    const StoredRun run = read_run(small.path());
    const auto page = small.path() / "page.html";
    const PageSummary whole = write_report_page(run, page);
    EXPECT_EQ(whole.frames, 8U);
    EXPECT_EQ(whole.steps, 8U);
    EXPECT_EQ(whole.bytes, std::filesystem::file_size(page));
    PageLimits limits;
    limits.frame_bytes = 900; // about four frames of 16 cells
    limits.steps = 3;
    limits.plane_cells = 16;
    const PageSummary thin = write_report_page(run, page, limits);
    EXPECT_EQ(thin.frames_of_run, 8U);
    EXPECT_EQ(thin.steps, 4U); // 0, 3, 6 and the last
    EXPECT_LT(thin.frames, 8U);
    const std::string text = test::content_of(page);
    const auto from = text.find("id=\"gapflow-data\">") + 18;
    const auto json = nlohmann::json::parse(text.substr(from, text.find("</script>", from) - from));
    EXPECT_EQ(json["frames_of_run"], 8);
    EXPECT_EQ(json["frames"].size(), thin.frames);
    EXPECT_EQ(json["frames"].front()["number"], 0);
    EXPECT_EQ(json["frames"].back()["number"], 7); // the end stays
    EXPECT_EQ(json["frames"][0]["planes"][0]["cells"], nlohmann::json({4, 4}));
    EXPECT_EQ(json["tables"]["of"], 8);
    EXPECT_EQ(json["tables"]["time"][2], 4);
}

TEST(FramePictures, KeyFramesAreEndsThinnestAndWidest)
{
    const SmallRun small(8);
    const StoredRun run = read_run(small.path());
    EXPECT_THAT(key_frames(run, 3), ElementsAre(0, 2, 7)); // the gap is thinnest at frame 2, widest at 7
    EXPECT_THAT(key_frames(run, 20), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
    EXPECT_THAT(key_frames(run, 1), ElementsAre(0, 7));
}

TEST(Base64, AgainstTheStandardsExamples)
{
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}
