#include "gapflow/output/vtk_reader.hpp"

#include "temporary.hpp"

#include "gapflow/core/error.hpp"

#include <gmock/gmock.h>

#include <cmath>

using namespace gapflow;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

template <int D>
Grid<D> make_grid(const Communicator& comm)
{
    Index<D> cells;
    gapflow::Vec<D> origin;
    for (int axis = 0; axis < D; ++axis) {
        cells[axis] = 3 + axis;
        origin[axis] = -0.5 + axis;
    }
    std::array<SideKind, 2 * D> sides;
    sides.fill(SideKind::wall);
    return Grid<D>(origin, 0.1, cells, sides, 2, comm);
}

template <int D>
void check_image(VtkPrecision precision, bool appended)
{
    const test::TemporaryFolder folder;
    const Communicator comm;
    const Grid<D> grid = make_grid<D>(comm);
    const std::vector<VtkArray> arrays = {
        cell_array(grid, "pressure", 1, [&](const Index<D>& c, int) { return 1.0 / 3 + grid.key(c); }),
        cell_array(grid, "velocity", D, [&](const Index<D>& c, int axis) { return axis - 0.25 * grid.key(c); })};
    write_cells<D>(folder / "image.vti", grid, arrays, {precision, 0.375, appended});
    const VtkContent content = read_vtk(folder / "image.vti");
    EXPECT_EQ(content.time, 0.375);
    EXPECT_EQ(content.cells, (D == 2 ? Eigen::Vector3i(3, 4, 0) : Eigen::Vector3i(3, 4, 5)));
    EXPECT_EQ(content.origin, (D == 2 ? Eigen::Vector3d(-0.5, 0.5, 0) : Eigen::Vector3d(-0.5, 0.5, 1.5)));
    EXPECT_EQ(content.spacing, Eigen::Vector3d::Constant(0.1));
    ASSERT_NE(content.cell_array("pressure"), nullptr);
    const std::vector<double>& pressure = content.cell_array("pressure")->values;
    ASSERT_EQ(pressure.size(), static_cast<std::size_t>(grid.cells().prod()));
    for (std::size_t key = 0; key < pressure.size(); ++key)
        EXPECT_EQ(pressure[key], precision == VtkPrecision::float32 ? static_cast<float>(1.0 / 3 + key) : 1.0 / 3 + key);
    const VtkArray* velocity = content.cell_array("velocity");
    ASSERT_NE(velocity, nullptr);
    EXPECT_EQ(velocity->components, 3);
    EXPECT_EQ(velocity->values[3 * 2 + 1], 1 - 0.5);
    EXPECT_EQ(velocity->values[3 * 2 + 2], D == 2 ? 0 : 2 - 0.5);
    EXPECT_EQ(content.cell_array("nothing"), nullptr);
}

std::string message_of(const std::filesystem::path& path)
{
    try {
        read_vtk(path);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

} // namespace

TEST(VtkReader, ImagesComeBackAsWritten)
{
    for (const VtkPrecision precision : {VtkPrecision::float64, VtkPrecision::float32})
        for (const bool appended : {false, true}) {
            check_image<2>(precision, appended);
            check_image<3>(precision, appended);
        }
}

void check_surfaces(bool appended)
{
    const test::TemporaryFolder folder;
    write_vtp<2>(folder / "film.vtp",
                 {{{0.1, 0.0}, {1.0, 0.2}, {0.5, 1.0 / 3}}, {{0, 1}, {1, 2}}, {{"thickness", 1, {1e-7, 0.25, -3}}}, {}},
                 {{}, {}, appended});
    const VtkContent film = read_vtk(folder / "film.vtp");
    EXPECT_EQ(film.corners, 2);
    EXPECT_THAT(film.elements, ElementsAre(0, 1, 1, 2));
    EXPECT_EQ(film.points.at(2), Eigen::Vector3d(0.5, 1.0 / 3, 0));
    EXPECT_THAT(film.point_array("thickness")->values, ElementsAre(1e-7, 0.25, -3));
    EXPECT_FALSE(film.time);

    write_vtp<3>(folder / "body.vtp", {{{0, 0, 0}, {1, 0, 0.1}, {0, 1, 0}}, {{0, 2, 1}}, {}, {{"a <name>", 1, {7}}}},
                 {{}, 2.0, appended});
    const VtkContent body = read_vtk(folder / "body.vtp");
    EXPECT_EQ(body.corners, 3);
    EXPECT_THAT(body.elements, ElementsAre(0, 2, 1));
    EXPECT_THAT(body.cell_array("a <name>")->values, ElementsAre(7));
    EXPECT_EQ(body.time, 2.0);
}

TEST(VtkReader, SurfacesComeBackAsWritten)
{
    check_surfaces(false);
    check_surfaces(true);
}

TEST(VtkReader, SurfacesWithoutElements)
{
    const test::TemporaryFolder folder;
    write_vtp<2>(folder / "2.vtp", {});
    write_vtp<3>(folder / "3.vtp", {});
    EXPECT_EQ(read_vtk(folder / "2.vtp").corners, 2);
    EXPECT_EQ(read_vtk(folder / "3.vtp").corners, 3);
    EXPECT_TRUE(read_vtk(folder / "3.vtp").elements.empty());
}

TEST(VtkReader, RefusesWhatIsNotOurs)
{
    const test::TemporaryFolder folder;
    EXPECT_THAT(message_of(folder / "nowhere.vti"), HasSubstr("nowhere.vti: cannot be read"));
    const test::TemporaryFile text("text.vti", "hello"),
        cut("cut.vtp", "<PolyData><Piece NumberOfPoints=\"1\"></Piece></PolyData>");
    EXPECT_THAT(message_of(text.path()), HasSubstr("no VTK image, rectilinear grid or surface"));
    EXPECT_THAT(message_of(cut.path()), HasSubstr("has no points"));
    write_vtp<2>(folder / "film.vtp", {{{0, 0}, {1, 0}}, {{0, 1}}, {{"thickness", 1, {1, 2}}}, {}});
    std::string content = test::content_of(folder / "film.vtp");
    const auto values = content.find("Name=\"thickness\"");
    content.erase(content.find('\n', values) + 5, 8);
    const test::TemporaryFile damaged("damaged.vtp", content);
    EXPECT_THAT(message_of(damaged.path()), HasSubstr("damaged.vtp: array 'thickness' is damaged"));
    write_vtp<2>(folder / "raw.vtp", {{{0, 0}, {1, 0}}, {{0, 1}}, {{"thickness", 1, {1, 2}}}, {}}, {{}, {}, true});
    content = test::content_of(folder / "raw.vtp");
    const test::TemporaryFile ends_early("early.vtp", content.substr(0, content.find('_', content.find("<AppendedData")) + 12));
    EXPECT_THAT(message_of(ends_early.path()), HasSubstr("early.vtp: array 'thickness' is damaged"));
}
