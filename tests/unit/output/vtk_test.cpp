// The writers' text is checked here only where it is short; tests/cli/read_vtk.py reads the samples with VTK itself.
#include "gapflow/output/vtk.hpp"

#include "temporary.hpp"

#include "gapflow/output/file.hpp"
#include "gapflow/output/pvd.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include <unistd.h>

using namespace gapflow;
using testing::HasSubstr;

namespace {

template <int D>
Grid<D> make_grid(const Communicator& comm)
{
    Index<D> cells;
    gapflow::Vec<D> origin; // PETSc has a Vec too
    for (int axis = 0; axis < D; ++axis) {
        cells[axis] = 9 + axis;
        origin[axis] = -0.5 + axis;
    }
    std::array<SideKind, 2 * D> sides;
    sides.fill(SideKind::wall);
    return Grid<D>(origin, 0.25, cells, sides, 2, comm);
}

// What read_vtk.py expects: pressure = sin(key), velocity = (1, 2, 3)/3 + key; key: the cell's number, first axis fastest.
template <int D>
std::vector<VtkArray> sample_fields(const Grid<D>& grid)
{
    return {cell_array(grid, "pressure", 1, [&](const Index<D>& c, int) { return std::sin(grid.key(c)); }),
            cell_array(grid, "velocity", D, [&](const Index<D>& c, int axis) { return (axis + 1) / 3.0 + grid.key(c); })};
}

template <int D>
VtkSurface<D> sample_surface();

template <>
VtkSurface<2> sample_surface<2>()
{
    return {{{0.1, 0.0}, {1.0, 0.2}, {0.5, 1.0 / 3.0}},
            {{0, 1}, {1, 2}, {2, 0}},
            {{"thickness", 1, {1e-7, 0.25, -3.0}}},
            {{"velocity", 2, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}}}};
}

template <>
VtkSurface<3> sample_surface<3>()
{
    return {{{0, 0, 0}, {1, 0, 0.1}, {0, 1, 0}, {0, 0, 1.0 / 3.0}},
            {{0, 2, 1}, {0, 1, 3}},
            {{"thickness", 1, {1e-7, 0.25, -3.0, 1e30}}, {"normal", 3, {0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, -1}}},
            {{"pressure <full>", 1, {-1.5, 1.0 / 3.0}}}};
}

template <int D>
void write_samples(const std::filesystem::path& folder, PvdCollection& collection)
{
    const Communicator comm;
    const Grid<D> grid = make_grid<D>(comm);
    const std::string name = std::to_string(D) + "d";
    write_cells<D>(folder / ("fields_" + name + ".vti"), grid, sample_fields(grid), {VtkPrecision::float64, 0.125});
    write_cells<D>(folder / ("fields_float_" + name + ".vti"), grid, sample_fields(grid), {VtkPrecision::float32, {}});
    for (const VtkPrecision precision : {VtkPrecision::float64, VtkPrecision::float32})
        write_cells<D>(folder / ("appended_" + std::string(precision == VtkPrecision::float32 ? "float_" : "") + name + ".vti"),
                       grid, sample_fields(grid), {precision, 0.125, true});
    on_root(comm, [&] { write_vtp<D>(folder / ("appended_film_" + name + ".vtp"), sample_surface<D>(), {{}, 0.125, true}); });
    on_root(comm, [&] { write_vtp<D>(folder / ("film_" + name + ".vtp"), sample_surface<D>(), {{}, 0.125}); });
    on_root(comm, [&] { write_vtp<D>(folder / ("empty_" + name + ".vtp"), VtkSurface<D>{}); });
    collection.add(0.125, "fields " + name, "fields_" + name + ".vti");
    collection.add(0.125, "film " + name, "film_" + name + ".vtp");
}

} // namespace

// Into the folder that the environment names (the fixture of read_vtk.py), else one of this user.
TEST(VtkSamples, Write)
{
    const Communicator comm;
    const char* wanted = std::getenv("GAPFLOW_SAMPLE_FOLDER");
    const std::filesystem::path folder =
        wanted ? std::filesystem::path(wanted)
               : std::filesystem::temp_directory_path() / ("gapflow-vtk-samples-" + std::to_string(getuid()));
    on_root(comm, [&] { prepare_folder(folder); });
    PvdCollection collection(folder / "gapflow.pvd");
    write_samples<2>(folder, collection);
    write_samples<3>(folder, collection);
    on_root(comm, [&] { collection.write(); });
}

template <int D>
void expect_all_gathered()
{
    const Communicator comm;
    const Grid<D> grid = make_grid<D>(comm);
    const auto local = cell_array(grid, "key", 2, [&](const Index<D>& c, int k) { return 10.0 * grid.key(c) + k; });
    const auto all = gather_cells<D>(grid, local.values, 2);
    if (!comm.root()) {
        EXPECT_TRUE(all.empty());
        return;
    }
    ASSERT_EQ(all.size(), 2u * grid.cells().prod());
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_EQ(all[i], 10.0 * static_cast<double>(i / 2) + static_cast<double>(i % 2));
}

TEST(VtkParallel, GathersCellsInOrder)
{
    expect_all_gathered<2>();
    expect_all_gathered<3>();
}

TEST(Vtk, ArrayIsLengthAndValuesInOneBase64Text)
{
    const test::TemporaryFolder folder;
    // 8 as 64 bits, then 1.0 = 0x3ff0000000000000, little endian.
    write_vtp<2>(folder / "a.vtp", {{{0, 0}}, {}, {{"one", 1, {1.0}}}, {}});
    EXPECT_THAT(test::content_of(folder / "a.vtp"),
                HasSubstr("<DataArray type=\"Float64\" Name=\"one\" NumberOfComponents=\"1\" format=\"binary\">\n"
                          "CAAAAAAAAAAAAAAAAADwPw==\n</DataArray>\n"));
}

TEST(Vtk, UnwritablePathIsAnError)
{
    const test::TemporaryFolder folder;
    EXPECT_THROW(write_vtp<2>(folder / "gone/a.vtp", {}), std::runtime_error);
}
