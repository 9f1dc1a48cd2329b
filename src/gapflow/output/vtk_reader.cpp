// The files' layout is that of vtk.cpp: one piece; arrays as base64 in their elements or as raw bytes behind the XML, with a 64-bit length before
// the values, little endian.
#include "gapflow/output/vtk_reader.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"
#include "gapflow/output/xml.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <iterator>

namespace gapflow {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why)
{
    throw InputError(path.string() + ": " + why + "; is it a file of a Gapflow run, and complete?");
}

std::array<std::int8_t, 256> base64_digits()
{
    std::array<std::int8_t, 256> digits;
    digits.fill(-1);
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < alphabet.size(); ++i)
        digits[static_cast<unsigned char>(alphabet[i])] = static_cast<std::int8_t>(i);
    return digits;
}

// Everything before the padding; other characters are skipped.
std::vector<unsigned char> decode_base64(std::string_view text)
{
    static const std::array<std::int8_t, 256> digits = base64_digits();
    std::vector<unsigned char> bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t pending = 0;
    int bits = 0;
    for (const char c : text) {
        const int digit = digits[static_cast<unsigned char>(c)];
        if (digit < 0)
            continue;
        pending = pending << 6 | static_cast<std::uint32_t>(digit);
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes.push_back(static_cast<unsigned char>(pending >> bits & 255));
        }
    }
    return bytes;
}

// An element of the XML text: <name attributes>content.
struct Element {
    std::string_view head, content;

    std::string attribute(const std::string& name) const { return gapflow::attribute(head, name); }
};

// The first element of a name at or after `from`, which moves behind it; empty head: none.
Element next_element(std::string_view text, const std::string& name, std::size_t& from)
{
    for (auto at = text.find("<" + name, from); at != std::string_view::npos; at = text.find("<" + name, at + 1)) {
        const auto after = at + 1 + name.size();
        const auto end = text.find('>', at);
        if (end == std::string_view::npos)
            break;
        if (text[after] != ' ' && text[after] != '>')
            continue;
        const auto close = text.find("</" + name + ">", end);
        if (close == std::string_view::npos)
            break;
        from = close;
        return {text.substr(at, end - at), text.substr(end + 1, close - end - 1)};
    }
    from = text.size();
    return {};
}

Element find_element(std::string_view text, const std::string& name)
{
    std::size_t from = 0;
    return next_element(text, name, from);
}

template <class T>
void append_as_double(const std::vector<unsigned char>& bytes, std::vector<double>& values)
{
    for (std::size_t at = sizeof(std::uint64_t); at + sizeof(T) <= bytes.size(); at += sizeof(T)) {
        T value;
        std::memcpy(&value, bytes.data() + at, sizeof(T));
        values.push_back(static_cast<double>(value));
    }
}

// A file's text: the XML, and the bytes behind it.
struct Parts {
    const std::filesystem::path& path;
    std::string_view xml, appended;
};

Parts parts_of(const std::string& text, const std::filesystem::path& path)
{
    Parts parts{path, text, {}};
    if (const auto at = text.find("<AppendedData"); at != std::string::npos) {
        parts.xml = parts.xml.substr(0, at);
        const auto start = text.find('_', at);
        if (start != std::string::npos)
            parts.appended = std::string_view(text).substr(start + 1);
    }
    return parts;
}

// An array's bytes with their length before them.
std::vector<unsigned char> bytes_of(const Element& element, const Parts& file)
{
    if (element.attribute("format") != "appended")
        return decode_base64(element.content);
    const auto offset = static_cast<std::size_t>(parse_number(element.attribute("offset")).value_or(0));
    std::uint64_t length = 0;
    if (file.appended.size() < sizeof length || offset > file.appended.size() - sizeof length)
        return {};
    std::memcpy(&length, file.appended.data() + offset, sizeof length);
    const std::string_view bytes = file.appended.substr(offset, sizeof length + length);
    return {bytes.begin(), bytes.end()};
}

VtkArray array_of(const Element& element, const Parts& file)
{
    const std::filesystem::path& path = file.path;
    VtkArray array{element.attribute("Name"), 1, {}};
    if (const auto components = parse_number(element.attribute("NumberOfComponents")))
        array.components = static_cast<int>(*components);
    const std::vector<unsigned char> bytes = bytes_of(element, file);
    std::uint64_t length = 0;
    if (bytes.size() >= sizeof length)
        std::memcpy(&length, bytes.data(), sizeof length);
    if (bytes.size() < sizeof length || bytes.size() - sizeof length != length)
        refuse(path, "array '" + array.name + "' is damaged");
    const std::string type = element.attribute("type");
    if (type == "Float64")
        append_as_double<double>(bytes, array.values);
    else if (type == "Float32")
        append_as_double<float>(bytes, array.values);
    else if (type == "Int64")
        append_as_double<std::int64_t>(bytes, array.values);
    else
        refuse(path, "array '" + array.name + "' has the unknown type '" + type + "'");
    return array;
}

std::vector<VtkArray> arrays_in(std::string_view text, const std::string& section, std::size_t tuples, const Parts& file)
{
    const std::string_view content = find_element(text, section).content;
    std::vector<VtkArray> arrays;
    for (std::size_t from = 0; from < content.size();) {
        const Element element = next_element(content, "DataArray", from);
        if (element.head.empty())
            break;
        arrays.push_back(array_of(element, file));
        if (arrays.back().values.size() != tuples * static_cast<std::size_t>(arrays.back().components))
            refuse(file.path, "array '" + arrays.back().name + "' has a wrong length");
    }
    return arrays;
}

Eigen::VectorXd numbers_of(const std::string& text, Eigen::Index count, const std::filesystem::path& path)
{
    Eigen::VectorXd numbers(count);
    Eigen::Index found = 0;
    for (const std::string_view part : split(text, ' '))
        if (const auto number = parse_number(part); number && found < count)
            numbers[found++] = *number;
    if (found != count)
        refuse(path, "'" + text + "' are not " + std::to_string(count) + " numbers");
    return numbers;
}

void read_image(const Element& image, VtkContent& content, const Parts& file)
{
    const std::filesystem::path& path = file.path;
    const Eigen::VectorXd extent = numbers_of(image.attribute("WholeExtent"), 6, path);
    for (int axis = 0; axis < 3; ++axis)
        content.cells[axis] = static_cast<int>(extent[2 * axis + 1] - extent[2 * axis]);
    content.origin = numbers_of(image.attribute("Origin"), 3, path);
    content.spacing = numbers_of(image.attribute("Spacing"), 3, path);
    const auto cells = static_cast<std::size_t>(content.cells.cwiseMax(1).cast<long>().prod());
    content.cell_data = arrays_in(image.content, "CellData", cells, file);
}

void read_rectilinear(const Element& grid, VtkContent& content, const Parts& file)
{
    const Eigen::VectorXd extent = numbers_of(grid.attribute("WholeExtent"), 6, file.path);
    for (int axis = 0; axis < 3; ++axis)
        content.cells[axis] = static_cast<int>(extent[2 * axis + 1] - extent[2 * axis]);
    const auto cells = static_cast<std::size_t>(content.cells.cwiseMax(1).cast<long>().prod());
    content.cell_data = arrays_in(grid.content, "CellData", cells, file);
    const std::string_view coordinates = find_element(grid.content, "Coordinates").content;
    std::size_t from = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Element element = next_element(coordinates, "DataArray", from);
        if (element.head.empty())
            refuse(file.path, "has no coordinates");
        content.coordinates[axis] = array_of(element, file).values;
        if (static_cast<int>(content.coordinates[axis].size()) != content.cells[axis] + 1)
            refuse(file.path, "has coordinates of a wrong number");
    }
}

void read_surface(const Element& surface, VtkContent& content, const Parts& file)
{
    const std::filesystem::path& path = file.path;
    const Element piece = find_element(surface.content, "Piece");
    const auto count = [&](const char* what) {
        return static_cast<std::size_t>(parse_number(piece.attribute(what)).value_or(0));
    };
    const std::size_t points = count("NumberOfPoints"), lines = count("NumberOfLines"), triangles = count("NumberOfPolys");
    const Element polygons = find_element(piece.content, "Polys");
    content.corners = polygons.head.empty() ? 2 : 3;
    content.point_data = arrays_in(piece.content, "PointData", points, file);
    content.cell_data = arrays_in(piece.content, "CellData", lines + triangles, file);
    const std::vector<VtkArray> places = arrays_in(piece.content, "Points", points, file);
    if (places.size() != 1 || places[0].components != 3)
        refuse(path, "has no points");
    for (std::size_t i = 0; i < points; ++i)
        content.points.emplace_back(places[0].values.data() + 3 * i);
    const Element list = polygons.head.empty() ? find_element(piece.content, "Lines") : polygons;
    const VtkArray connectivity = array_of(find_element(list.content, "DataArray"), file);
    for (const double point : connectivity.values) {
        if (!(point >= 0 && point < static_cast<double>(points)))
            refuse(path, "an element names a point that is not there");
        content.elements.push_back(static_cast<int>(point));
    }
}

const VtkArray* named(const std::vector<VtkArray>& arrays, const std::string& name)
{
    const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const VtkArray& array) { return array.name == name; });
    return found == arrays.end() ? nullptr : &*found;
}

} // namespace

const VtkArray* VtkContent::cell_array(const std::string& name) const
{
    return named(cell_data, name);
}

const VtkArray* VtkContent::point_array(const std::string& name) const
{
    return named(point_data, name);
}

VtkContent read_vtk(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!in && text.empty())
        refuse(path, "cannot be read");
    VtkContent content;
    const Parts file = parts_of(text, path);
    const Element image = find_element(file.xml, "ImageData"), surface = find_element(file.xml, "PolyData"),
                  grid = find_element(file.xml, "RectilinearGrid");
    const Element& whole = !image.head.empty() ? image : !grid.head.empty() ? grid : surface;
    if (whole.head.empty())
        refuse(path, "is no VTK image, rectilinear grid or surface");
    if (const Element field = find_element(whole.content, "FieldData"); !field.head.empty()) {
        const VtkArray time = array_of(find_element(field.content, "DataArray"), file);
        if (time.values.size() == 1)
            content.time = time.values[0];
    }
    if (!image.head.empty())
        read_image(image, content, file);
    else if (!grid.head.empty())
        read_rectilinear(grid, content, file);
    else
        read_surface(surface, content, file);
    return content;
}

VtkContent as_image(const VtkContent& grid, const Eigen::Vector3d& low, double spacing, const Eigen::Vector3i& cells)
{
    VtkContent image;
    image.cells = cells;
    image.origin = low;
    image.spacing.setConstant(spacing);
    image.time = grid.time;
    std::array<std::vector<std::size_t>, 3> source; // of the image's cells along each axis
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < std::max(cells[axis], 1); ++i) {
            const std::vector<double>& x = grid.coordinates[axis];
            const auto above = std::upper_bound(x.begin(), x.end(), low[axis] + (i + 0.5) * spacing);
            const long cell = std::clamp<long>(above - x.begin() - 1, 0, std::max(grid.cells[axis] - 1, 0));
            source[axis].push_back(static_cast<std::size_t>(cell));
        }
    const auto nx = static_cast<std::size_t>(std::max(grid.cells[0], 1)),
               ny = static_cast<std::size_t>(std::max(grid.cells[1], 1));
    for (const VtkArray& array : grid.cell_data) {
        VtkArray values{array.name, array.components, {}};
        const auto components = static_cast<std::size_t>(array.components);
        for (const std::size_t k : source[2])
            for (const std::size_t j : source[1])
                for (const std::size_t i : source[0]) {
                    const double* from = array.values.data() + components * (i + nx * (j + ny * k));
                    values.values.insert(values.values.end(), from, from + components);
                }
        image.cell_data.push_back(std::move(values));
    }
    return image;
}

} // namespace gapflow
