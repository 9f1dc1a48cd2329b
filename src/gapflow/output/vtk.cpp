// File format: "VTK XML formats", https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
#include "gapflow/output/vtk.hpp"

#include "gapflow/grid/whole_field.hpp"
#include "gapflow/output/file.hpp"
#include "gapflow/output/xml.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <functional>

namespace gapflow {

namespace {

static_assert(std::endian::native == std::endian::little);

// Base64 of a stream of bytes, in pieces.
class Base64 {
public:
    explicit Base64(AtomicFile& file) : file_(file) { text_.reserve(chunk + 4); }

    template <class T>
    void put(T value)
    {
        unsigned char bytes[sizeof(T)];
        std::memcpy(bytes, &value, sizeof(T));
        for (const unsigned char byte : bytes) {
            pending_ = pending_ << 8 | byte;
            if (++count_ == 3)
                encode(4);
        }
        if (text_.size() >= chunk)
            flush();
    }
    void finish()
    {
        if (count_ > 0) {
            const int digits = count_ + 1;
            pending_ <<= 8 * (3 - count_);
            encode(digits);
            text_.append(static_cast<std::size_t>(4 - digits), '=');
        }
        flush();
    }

private:
    static constexpr std::size_t chunk = 1 << 16;

    void encode(int digits)
    {
        static constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        for (int digit = 0; digit < digits; ++digit)
            text_ += alphabet[pending_ >> (18 - 6 * digit) & 63];
        pending_ = 0;
        count_ = 0;
    }
    void flush()
    {
        file_.write(text_);
        text_.clear();
    }

    AtomicFile& file_;
    std::string text_;
    std::uint32_t pending_ = 0;
    int count_ = 0;
};

template <class T>
constexpr const char* type_name = std::is_same_v<T, double>  ? "Float64"
                                  : std::is_same_v<T, float> ? "Float32"
                                                             : "Int64";

// Bytes of a stream, in pieces.
class Bytes {
public:
    explicit Bytes(AtomicFile& file) : file_(file) { bytes_.reserve(chunk + 8); }

    template <class T>
    void put(T value)
    {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
        if (bytes_.size() >= chunk)
            finish();
    }
    void finish()
    {
        file_.write(bytes_);
        bytes_.clear();
    }

private:
    static constexpr std::size_t chunk = 1 << 16;

    AtomicFile& file_;
    std::string bytes_;
};

// A VTK file under way, and the arrays that follow its XML.
class VtkFile {
public:
    VtkFile(const std::filesystem::path& path, bool appended) : file_(path), appended_(appended) {}

    void write(std::string_view text) { file_.write(text); }
    /// One <DataArray>: its length in bytes, then the values value(tuple, component); in one base64 text, or later. What `value` refers to must
    /// last until commit().
    template <class T, class F>
    void write_array(const std::string& name, std::size_t tuples, int components, F value, const std::string& attributes = {})
    {
        const std::uint64_t bytes = tuples * static_cast<std::size_t>(components) * sizeof(T);
        file_.write("<DataArray type=\"" + std::string(type_name<T>) + "\" Name=\"" + escaped(name) +
                    "\" NumberOfComponents=\"" + std::to_string(components) + "\"" + attributes);
        const auto write_values = [bytes, tuples, components, value](auto out) {
            out.put(bytes);
            for (std::size_t tuple = 0; tuple < tuples; ++tuple)
                for (int component = 0; component < components; ++component)
                    out.put(static_cast<T>(value(tuple, component)));
            out.finish();
        };
        if (appended_) {
            file_.write(" format=\"appended\" offset=\"" + std::to_string(offset_) + "\">");
            offset_ += sizeof bytes + bytes;
            later_.push_back([this, write_values] { write_values(Bytes(file_)); });
        } else {
            file_.write(" format=\"binary\">\n");
            write_values(Base64(file_));
            file_.write("\n");
        }
        file_.write("</DataArray>\n");
    }
    /// Writes the arrays that follow and the end. The last call.
    void commit()
    {
        if (appended_) {
            file_.write("<AppendedData encoding=\"raw\">\n_");
            for (const auto& write : later_)
                write();
            file_.write("\n</AppendedData>\n");
        }
        file_.write("</VTKFile>\n");
        file_.commit();
    }

private:
    AtomicFile file_;
    bool appended_;
    std::uint64_t offset_ = 0;
    std::vector<std::function<void()>> later_;
};

template <class T>
void write_data_array(VtkFile& file, const VtkArray& array, std::size_t tuples)
{
    assert(array.values.size() == tuples * static_cast<std::size_t>(array.components));
    const int stored = array.components;
    const int components = stored == 2 ? 3 : stored;
    file.write_array<T>(array.name, tuples, components, [&array, stored](std::size_t tuple, int component) {
        return component < stored ? array.values[tuple * static_cast<std::size_t>(stored) + component] : 0.0;
    });
}

// <PointData> or <CellData>; viewers show its first scalar and first vector.
void write_data(VtkFile& file, const std::string& element, const std::vector<VtkArray>& arrays, std::size_t tuples,
                VtkPrecision precision)
{
    std::string scalars, vectors;
    for (const auto& array : arrays) {
        if (array.components == 1 && scalars.empty())
            scalars = " Scalars=\"" + escaped(array.name) + "\"";
        if ((array.components == 2 || array.components == 3) && vectors.empty())
            vectors = " Vectors=\"" + escaped(array.name) + "\"";
    }
    file.write("<" + element + scalars + vectors + ">\n");
    for (const auto& array : arrays) {
        if (precision == VtkPrecision::float32)
            write_data_array<float>(file, array, tuples);
        else
            write_data_array<double>(file, array, tuples);
    }
    file.write("</" + element + ">\n");
}

void write_head(VtkFile& file, const std::string& type)
{
    file.write("<?xml version=\"1.0\"?>\n<VTKFile type=\"" + type +
               "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n");
}

void write_time(VtkFile& file, const std::optional<double>& time)
{
    if (!time)
        return;
    file.write("<FieldData>\n");
    file.write_array<double>(
        "TimeValue", 1, 1, [value = *time](std::size_t, int) { return value; }, " NumberOfTuples=\"1\"");
    file.write("</FieldData>\n");
}

template <int D>
void write_image(const std::filesystem::path& path, const Grid<D>& grid, const std::vector<VtkArray>& cell_data,
                 const VtkOptions& options)
{
    std::string extent, origin, spacing;
    for (int axis = 0; axis < 3; ++axis) {
        const std::string space = axis > 0 ? " " : "";
        extent += space + "0 " + std::to_string(axis < D ? grid.cells()[axis] : 0);
        origin += space + shortest(axis < D ? grid.origin()[axis] : 0.0);
        spacing += space + shortest(grid.dx());
    }
    VtkFile file(path, options.appended);
    write_head(file, "ImageData");
    file.write("<ImageData WholeExtent=\"" + extent + "\" Origin=\"" + origin + "\" Spacing=\"" + spacing + "\">\n");
    write_time(file, options.time);
    file.write("<Piece Extent=\"" + extent + "\">\n<PointData>\n</PointData>\n");
    const auto cells = static_cast<std::size_t>(grid.cells().template cast<long>().prod());
    write_data(file, "CellData", cell_data, cells, options.precision);
    file.write("</Piece>\n</ImageData>\n");
    file.commit();
}

template <int D>
void write_rectilinear(const std::filesystem::path& path, const Grid<D>& grid, const std::vector<VtkArray>& cell_data,
                       const VtkOptions& options)
{
    std::string extent;
    for (int axis = 0; axis < 3; ++axis)
        extent += (axis > 0 ? " 0 " : "0 ") + std::to_string(axis < D ? grid.cells()[axis] : 0);
    VtkFile file(path, options.appended);
    write_head(file, "RectilinearGrid");
    file.write("<RectilinearGrid WholeExtent=\"" + extent + "\">\n");
    write_time(file, options.time);
    file.write("<Piece Extent=\"" + extent + "\">\n<PointData>\n</PointData>\n");
    const auto cells = static_cast<std::size_t>(grid.cells().template cast<long>().prod());
    write_data(file, "CellData", cell_data, cells, options.precision);
    file.write("<Coordinates>\n");
    for (int axis = 0; axis < 3; ++axis)
        file.write_array<double>(
            std::string(1, "xyz"[axis]), axis < D ? static_cast<std::size_t>(grid.cells()[axis]) + 1 : 1, 1,
            [&grid, axis](std::size_t i, int) { return axis < D ? grid.face_place(axis, static_cast<int>(i)) : 0.0; });
    file.write("</Coordinates>\n</Piece>\n</RectilinearGrid>\n");
    file.commit();
}

// <Lines> (2D) or <Polys> (3D).
template <int D>
void write_elements(VtkFile& file, const std::string& name, const std::vector<std::array<int, D>>& elements)
{
    file.write("<" + name + ">\n");
    file.write_array<std::int64_t>("connectivity", elements.size() * D, 1,
                                   [&elements](std::size_t i, int) { return elements[i / D][i % D]; });
    file.write_array<std::int64_t>("offsets", elements.size(), 1, [](std::size_t i, int) { return (i + 1) * D; });
    file.write("</" + name + ">\n");
}

} // namespace

template <int D>
std::vector<double> gather_cells(const Grid<D>& grid, std::span<const double> owned, int components)
{
    return gather<D>(grid, Block<D>(Index<D>::Zero(), grid.cells()), grid.low(), grid.high(), owned, components);
}

template <int D>
void write_cells(const std::filesystem::path& path, const Grid<D>& grid, std::span<const VtkArray> cell_data,
                 const VtkOptions& options)
{
    std::vector<VtkArray> gathered;
    for (const auto& array : cell_data)
        gathered.push_back({array.name, array.components, gather_cells(grid, array.values, array.components)});
    on_root(grid.comm(), [&] {
        if (grid.graded())
            write_rectilinear(path, grid, gathered, options);
        else
            write_image(path, grid, gathered, options);
    });
}

template <int D>
void write_vtp(const std::filesystem::path& path, const VtkSurface<D>& surface, const VtkOptions& options)
{
    const std::size_t points = surface.points.size(), elements = surface.elements.size();
    const std::string lines = std::to_string(D == 2 ? elements : 0), polygons = std::to_string(D == 3 ? elements : 0);
    VtkFile file(path, options.appended);
    write_head(file, "PolyData");
    file.write("<PolyData>\n");
    write_time(file, options.time);
    file.write("<Piece NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" + lines +
               "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + polygons + "\">\n");
    write_data(file, "PointData", surface.point_data, points, options.precision);
    write_data(file, "CellData", surface.cell_data, elements, options.precision);
    file.write("<Points>\n");
    file.write_array<double>("Points", points, 3,
                             [&](std::size_t point, int axis) { return axis < D ? surface.points[point][axis] : 0.0; });
    file.write("</Points>\n");
    write_elements<D>(file, D == 2 ? "Lines" : "Polys", surface.elements);
    file.write("</Piece>\n</PolyData>\n");
    file.commit();
}

template <int D>
void write_vtu(const std::filesystem::path& path, const VtkCells<D>& cells, const VtkOptions& options)
{
    const std::size_t points = cells.points.size(), count = cells.cells.size();
    std::vector<std::int64_t> connectivity, offsets, faces, face_offsets;
    for (const auto& cell : cells.cells) {
        const auto begin = static_cast<std::ptrdiff_t>(connectivity.size());
        faces.push_back(static_cast<std::int64_t>(cell.size()));
        for (const auto& face : cell) {
            connectivity.insert(connectivity.end(), face.begin(), face.end());
            faces.push_back(static_cast<std::int64_t>(face.size()));
            faces.insert(faces.end(), face.begin(), face.end());
        }
        if (D == 3) { // each point once
            std::sort(connectivity.begin() + begin, connectivity.end());
            connectivity.erase(std::unique(connectivity.begin() + begin, connectivity.end()), connectivity.end());
        }
        offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
        face_offsets.push_back(static_cast<std::int64_t>(faces.size()));
    }
    VtkFile file(path, options.appended);
    write_head(file, "UnstructuredGrid");
    file.write("<UnstructuredGrid>\n");
    write_time(file, options.time);
    file.write("<Piece NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfCells=\"" + std::to_string(count) + "\">\n");
    write_data(file, "PointData", {}, points, options.precision);
    write_data(file, "CellData", cells.cell_data, count, options.precision);
    file.write("<Points>\n");
    file.write_array<double>("Points", points, 3,
                             [&](std::size_t point, int axis) { return axis < D ? cells.points[point][axis] : 0.0; });
    file.write("</Points>\n<Cells>\n");
    const auto write_list = [&](const std::string& name, const std::vector<std::int64_t>& list) {
        file.write_array<std::int64_t>(name, list.size(), 1, [&list](std::size_t k, int) { return list[k]; });
    };
    constexpr std::int64_t polygon = 7, polyhedron = 42; // VTK's numbers
    write_list("connectivity", connectivity);
    write_list("offsets", offsets);
    file.write_array<std::int64_t>("types", count, 1, [](std::size_t, int) { return D == 2 ? polygon : polyhedron; });
    if (D == 3) {
        write_list("faces", faces);
        write_list("faceoffsets", face_offsets);
    }
    file.write("</Cells>\n</Piece>\n</UnstructuredGrid>\n");
    file.commit();
}

template std::vector<double> gather_cells(const Grid<2>&, std::span<const double>, int);
template std::vector<double> gather_cells(const Grid<3>&, std::span<const double>, int);
template void write_cells(const std::filesystem::path&, const Grid<2>&, std::span<const VtkArray>, const VtkOptions&);
template void write_cells(const std::filesystem::path&, const Grid<3>&, std::span<const VtkArray>, const VtkOptions&);
template void write_vtp(const std::filesystem::path&, const VtkSurface<2>&, const VtkOptions&);
template void write_vtp(const std::filesystem::path&, const VtkSurface<3>&, const VtkOptions&);
template void write_vtu(const std::filesystem::path&, const VtkCells<2>&, const VtkOptions&);
template void write_vtu(const std::filesystem::path&, const VtkCells<3>&, const VtkOptions&);

} // namespace gapflow
