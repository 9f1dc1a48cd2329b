// Readers of OBJ, STL and 2D polygon files.
#include "gapflow/geometry/mesh_file.hpp"

#include "gapflow/core/error.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

namespace gapflow {
namespace {

/// Throws "file:line: parts"; line 0: none.
template <class... Parts>
[[noreturn]] void fail(const std::string& file, int line, const Parts&... parts)
{
    std::ostringstream text;
    text << file;
    if (line > 0)
        text << ':' << line;
    text << ": ";
    (text << ... << parts);
    throw InputError(text.str());
}

std::string whole_file(const std::string& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in)
        fail(file, 0, "cannot be opened; check the path (relative paths start at the scene file)");
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string_view> words_of(std::string_view line)
{
    std::vector<std::string_view> words;
    std::size_t i = 0;
    const auto space = [&](std::size_t k) { return std::isspace(static_cast<unsigned char>(line[k])) != 0; };
    while (i < line.size()) {
        while (i < line.size() && space(i))
            ++i;
        const std::size_t start = i;
        while (i < line.size() && !space(i))
            ++i;
        if (i > start)
            words.push_back(line.substr(start, i - start));
    }
    return words;
}

/// Calls use(words, number, comment) for every line: its words before any '#', and whether it has a '#'.
template <class Use>
void for_each_line(const std::string& text, Use use)
{
    int number = 0;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        std::string_view line(text.data() + start, end - start);
        const std::size_t hash = line.find('#');
        use(words_of(line.substr(0, hash)), ++number, hash != line.npos);
        start = end + 1;
    }
}

/// The point, unless squares and volumes of such coordinates could overflow.
template <int D>
Vec<D> checked(const Vec<D>& x, const std::string& file, int line)
{
    constexpr double largest = 1e30;
    if (!(x.cwiseAbs().maxCoeff() <= largest))
        fail(file, line, "a coordinate beyond ", largest, "; choose another scale");
    return x;
}

template <int D>
Vec<D> point_of(const std::vector<std::string_view>& words, std::size_t first, double scale, const std::string& file, int line)
{
    if (words.size() < first + D)
        fail(file, line, "expected ", D, " coordinates; write them with blanks in between");
    Vec<D> x;
    for (int i = 0; i < D; ++i) {
        std::string_view word = words[first + i];
        if (word.starts_with('+'))
            word.remove_prefix(1);
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), x[i]);
        if (error == std::errc::result_out_of_range)
            x[i] = std::strtod(std::string(word).c_str(), nullptr); // 0 or infinity
        if (error == std::errc::invalid_argument || end != word.data() + word.size() || !std::isfinite(x[i]))
            fail(file, line, '"', words[first + i], "\" is not a finite number; write coordinates as 1.5");
    }
    return checked<D>(scale * x, file, line);
}

/// Vertex of an OBJ corner "v", "v/t", "v//n" or "v/t/n"; counts from 1, or from the last one back if negative.
int obj_index(std::string_view word, int vertices, const std::string& file, int line)
{
    int index = 0;
    const std::string_view number = word.substr(0, word.find('/'));
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), index);
    const int from_zero = index > 0 ? index - 1 : vertices + index;
    if (error != std::errc() || end != number.data() + number.size() || index == 0 || from_zero < 0 || from_zero >= vertices)
        fail(file, line, "face corner \"", word, "\" names no vertex read so far (there are ", vertices,
             "); vertices count from 1, and stand before the faces that name them");
    return from_zero;
}

SurfaceMesh<3> read_obj(const std::string& text, const std::string& file, double scale, std::vector<int>& lines)
{
    SurfaceMesh<3> mesh;
    for_each_line(text, [&](const auto& words, int line, bool) {
        if (words.empty())
            return;
        if (words[0] == "v")
            mesh.vertices.push_back(point_of<3>(words, 1, scale, file, line));
        if (words[0] != "f")
            return;
        if (words.size() < 4)
            fail(file, line, "a face needs at least 3 corners; write f 1 2 3");
        const auto corner = [&](std::size_t k) { return obj_index(words[k], int(mesh.vertices.size()), file, line); };
        for (std::size_t k = 3; k < words.size(); ++k) {
            mesh.elements.push_back({corner(1), corner(k - 1), corner(k)});
            lines.push_back(line);
        }
    });
    return mesh;
}

SurfaceMesh<3> read_ascii_stl(const std::string& text, const std::string& file, double scale, std::vector<int>& lines)
{
    SurfaceMesh<3> mesh;
    int in_facet = 0, last_line = 0, first_line = 0;
    for_each_line(text, [&](const auto& words, int line, bool) {
        last_line = line;
        if (words.empty())
            return;
        if (words[0] == "facet")
            first_line = line;
        else if (words[0] == "vertex") {
            mesh.vertices.push_back(point_of<3>(words, 1, scale, file, line));
            ++in_facet;
        } else if (words[0] == "endfacet") {
            if (in_facet != 3)
                fail(file, line, "a facet has ", in_facet, " vertices; STL facets are triangles: export again");
            const int n = int(mesh.vertices.size());
            mesh.elements.push_back({n - 3, n - 2, n - 1});
            lines.push_back(first_line > 0 ? first_line : line);
            in_facet = first_line = 0;
        }
    });
    if (in_facet != 0)
        fail(file, last_line, "the file ends inside a facet; it was cut off: export again");
    return mesh;
}

constexpr std::size_t stl_header = 84, stl_facet = 50;

/// Number of triangles of a binary STL, or -1 where the length of the file does not fit the count in its header.
std::int64_t binary_stl_count(const std::string& text)
{
    if (text.size() < stl_header)
        return -1;
    std::uint32_t count;
    std::memcpy(&count, text.data() + 80, sizeof count);
    return text.size() == stl_header + stl_facet * std::size_t(count) ? std::int64_t(count) : -1;
}

SurfaceMesh<3> read_binary_stl(const std::string& text, std::int64_t count, const std::string& file, double scale)
{
    static_assert(std::endian::native == std::endian::little, "STL files are little-endian");
    SurfaceMesh<3> mesh;
    for (std::int64_t f = 0; f < count; ++f) {
        float numbers[12]; // normal, then three vertices
        std::memcpy(numbers, text.data() + stl_header + stl_facet * std::size_t(f), sizeof numbers);
        const int n = int(mesh.vertices.size());
        for (int k = 1; k < 4; ++k) {
            const Vec<3> x(numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]);
            if (!x.allFinite())
                fail(file, 0, "triangle ", f, " has a coordinate that is not finite");
            mesh.vertices.push_back(checked<3>(scale * x, file, 0));
        }
        mesh.elements.push_back({n, n + 1, n + 2});
    }
    return mesh;
}

SurfaceMesh<2> read_polygon(const std::string& text, const std::string& file, double scale, bool open, std::vector<int>& lines)
{
    SurfaceMesh<2> mesh;
    std::vector<int> line_of; // of each vertex
    std::size_t first = 0;    // vertex of the loop or polyline being read
    int last_line = 0;
    const auto close = [&](int line) {
        const bool repeats = mesh.vertices.size() - first > 1 && mesh.vertices.back() == mesh.vertices[first];
        if (repeats) { // the first vertex
            mesh.vertices.pop_back();
            line_of.pop_back();
        }
        const std::size_t n = mesh.vertices.size() - first;
        if (n == 0)
            return;
        if (open && n < 2)
            fail(file, line, "a polyline has one point; it needs at least 2");
        if (!open && n < 3)
            fail(file, line, "a loop has ", n, " vertices; it needs at least 3");
        for (std::size_t i = 0; i < (open && !repeats ? n - 1 : n); ++i) {
            mesh.elements.push_back({int(first + i), int(first + (i + 1) % n)});
            lines.push_back(line_of[first + i]); // where the segment starts
        }
        first = mesh.vertices.size();
    };
    for_each_line(text, [&](const auto& words, int line, bool comment) {
        last_line = line;
        if (words.size() == 2) {
            const Vec<2> x = point_of<2>(words, 0, scale, file, line);
            if (mesh.vertices.size() == first || mesh.vertices.back() != x) {
                mesh.vertices.push_back(x);
                line_of.push_back(line);
            }
        } else if (!words.empty())
            fail(file, line, "expected \"x y\", found ", words.size(), " words; write two numbers a line");
        else if (!comment)
            close(line);
    });
    close(last_line);
    return mesh;
}

} // namespace

template <int D>
SurfaceMesh<D> read_surface_file(const std::string& file, double scale, std::vector<int>* lines, bool open)
{
    return parse_surface<D>(whole_file(file), file, scale, lines, open);
}

template <int D>
SurfaceMesh<D> parse_surface(const std::string& text, const std::string& file, double scale, std::vector<int>* lines, bool open)
{
    std::vector<int> line_of_facet;
    std::string extension = file.substr(std::min(file.rfind('.'), file.size()));
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    SurfaceMesh<D> mesh;
    if constexpr (D == 2)
        mesh = read_polygon(text, file, scale, open, line_of_facet);
    else if (extension == ".obj")
        mesh = read_obj(text, file, scale, line_of_facet);
    else if (extension == ".stl") {
        const std::int64_t count = binary_stl_count(text);
        if (count < 0 && !std::string_view(text).starts_with("solid"))
            fail(file, 0,
                 "neither ASCII STL (starts with \"solid\") nor binary STL of the length its header tells; it was cut off: "
                 "export again");
        mesh = count >= 0 ? read_binary_stl(text, count, file, scale) : read_ascii_stl(text, file, scale, line_of_facet);
    } else
        fail(file, 0, "unknown kind of mesh file \"", extension, "\"; use .obj or .stl");
    if (mesh.elements.empty())
        fail(file, 0, "holds no facets; export the surface as triangles");
    if (lines)
        *lines = std::move(line_of_facet);
    return mesh;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template SurfaceMesh<D> read_surface_file<D>(const std::string&, double, std::vector<int>*, bool);                         \
    template SurfaceMesh<D> parse_surface<D>(const std::string&, const std::string&, double, std::vector<int>*, bool);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
