#include "gapflow/output/frame_pictures.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/output/file.hpp"
#include "gapflow/output/picture.hpp"
#include "gapflow/output/run_view.hpp"
#include "gapflow/output/surface_raster.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <set>

namespace gapflow {

namespace {

constexpr Colour paper{255, 255, 255}, ink{27, 35, 48}, soft{91, 102, 117}, solid{119, 128, 141}, edge{44, 51, 61},
    empty{238, 242, 247};
constexpr int margin = 20, space = 24;

using Segments = std::vector<std::array<PixelPoint, 2>>;

std::string short_number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

/// Where a part of the plane lies in a picture.
struct Frame2D {
    PixelBox box;
    std::array<double, 2> low; ///< of the domain, along the plane's axes
    double scale;              ///< pixels a length

    PixelPoint pixel(double a, double b) const { return {box.left + (a - low[0]) * scale, box.bottom - (b - low[1]) * scale}; }
};

// Bilinear between cell centres; NaN next to cells without a value, and beyond the plane.
float interpolated(const FieldPlane& plane, const std::vector<float>& values, double a, double b)
{
    const double x = (a - plane.low[0]) / plane.spacing - 0.5, y = (b - plane.low[1]) / plane.spacing - 0.5;
    if (x < -1 || y < -1 || x > plane.cells[0] || y > plane.cells[1]) // a grid that follows a body shows less than its way
        return std::numeric_limits<float>::quiet_NaN();
    const int i = std::clamp(static_cast<int>(std::floor(x)), 0, std::max(plane.cells[0] - 2, 0));
    const int j = std::clamp(static_cast<int>(std::floor(y)), 0, std::max(plane.cells[1] - 2, 0));
    const int right = std::min(i + 1, plane.cells[0] - 1), above = std::min(j + 1, plane.cells[1] - 1);
    const auto s = static_cast<float>(std::clamp(x - i, 0.0, 1.0)), t = static_cast<float>(std::clamp(y - j, 0.0, 1.0));
    const auto at = [&](int k, int l) { return values[static_cast<std::size_t>(l) * plane.cells[0] + k]; };
    return (1 - t) * ((1 - s) * at(i, j) + s * at(right, j)) + t * ((1 - s) * at(i, above) + s * at(right, above));
}

// In 40 bands of equal colour: they read like contours, and the file stays small.
Colour banded(ColourMap map, const ColourRange& range, double value)
{
    constexpr int bands = 40;
    const double share = std::clamp(range.share(value), 0.0, 1.0);
    return colour_at(map, std::min(std::floor(share * bands), bands - 1.0) / (bands - 1));
}

void draw_field(Picture& picture, const Frame2D& frame, const FieldPlane& plane, const std::vector<float>& values,
                ColourMap map, const ColourRange& range)
{
    for (int y = frame.box.top; y < frame.box.bottom; ++y)
        for (int x = frame.box.left; x < frame.box.right; ++x) {
            const float value = interpolated(plane, values, frame.low[0] + (x + 0.5 - frame.box.left) / frame.scale,
                                             frame.low[1] + (frame.box.bottom - y - 0.5) / frame.scale);
            picture.blend(x, y, std::isnan(value) ? solid : banded(map, range, value));
        }
}

// A body in 2D: its outline; in 3D: its cut with the plane.
Segments outline(const RunView& view, const BodyView& body, const Placement& placement, const Frame2D& frame, int axis,
                 const std::array<int, 2>& in_plane, double position)
{
    Segments segments;
    const auto place = [&](int point) -> Eigen::Vector3d { return placement.rotation * body.points[point] + placement.shift; };
    const auto pixel = [&](const Eigen::Vector3d& x) { return frame.pixel(x[in_plane[0]], x[in_plane[1]]); };
    if (view.dimension == 2) {
        for (std::size_t e = 0; e + 1 < body.elements.size(); e += 2)
            segments.push_back({pixel(place(body.elements[e])), pixel(place(body.elements[e + 1]))});
        return segments;
    }
    for (std::size_t e = 0; e + 2 < body.elements.size(); e += 3) {
        const std::array<Eigen::Vector3d, 3> x = {place(body.elements[e]), place(body.elements[e + 1]),
                                                  place(body.elements[e + 2])};
        std::vector<PixelPoint> ends;
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector3d &a = x[i], &b = x[(i + 1) % 3];
            if ((a[axis] <= position) != (b[axis] <= position))
                ends.push_back(pixel(a + (position - a[axis]) / (b[axis] - a[axis]) * (b - a)));
        }
        if (ends.size() == 2)
            segments.push_back({ends[0], ends[1]});
    }
    if (body.inside_out) { // a rim around the picture: what lies outside the shape is solid
        const double l = frame.box.left - 9, t = frame.box.top - 9, r = frame.box.right + 9, b = frame.box.bottom + 9;
        segments.insert(segments.end(), {{{{l, t}, {r, t}}}, {{{r, t}, {r, b}}}, {{{r, b}, {l, b}}}, {{{l, b}, {l, t}}}});
    }
    return segments;
}

void draw_bodies(Picture& picture, const RunView& view, const FrameView& state, const Frame2D& frame, int axis,
                 const std::array<int, 2>& in_plane, double position)
{
    for (std::size_t b = 0; b < view.bodies.size(); ++b) {
        const Segments segments = outline(view, view.bodies[b], state.placements[b], frame, axis, in_plane, position);
        picture.fill_inside(segments, solid, frame.box);
        for (const auto& [from, to] : segments)
            picture.line(from, to, 1.2, edge, frame.box);
    }
}

// A line with square ends, `more` longer at both.
void draw_band(Picture& picture, const PixelPoint& from, const PixelPoint& to, double width, double more, Colour colour,
               const PixelBox& clip)
{
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    if (!(length > 0))
        return;
    const double ex = (to[0] - from[0]) / length, ey = (to[1] - from[1]) / length, half = 0.5 * width;
    const std::array<PixelPoint, 4> corners = {{{from[0] - more * ex - half * ey, from[1] - more * ey + half * ex},
                                                {from[0] - more * ex + half * ey, from[1] - more * ey - half * ex},
                                                {to[0] + more * ex + half * ey, to[1] + more * ey - half * ex},
                                                {to[0] + more * ex - half * ey, to[1] + more * ey + half * ex}}};
    Segments segments;
    PixelBox box = clip;
    double low[2] = {corners[0][0], corners[0][1]}, high[2] = {corners[0][0], corners[0][1]};
    for (int i = 0; i < 4; ++i) {
        segments.push_back({corners[i], corners[(i + 1) % 4]});
        for (int axis = 0; axis < 2; ++axis) {
            low[axis] = std::min(low[axis], corners[i][axis]);
            high[axis] = std::max(high[axis], corners[i][axis]);
        }
    }
    const auto within = [](double value, int least, int most) {
        return static_cast<int>(std::clamp<double>(value, least, most));
    };
    box.left = within(low[0], clip.left, clip.right);
    box.right = within(high[0] + 1, clip.left, clip.right);
    box.top = within(low[1], clip.top, clip.bottom);
    box.bottom = within(high[1] + 1, clip.top, clip.bottom);
    picture.fill_inside(segments, colour, box);
}

// A film as a band, wide enough to be seen however thin it is.
void draw_films(Picture& picture, const FilmView& film, const Frame2D& frame, const ColourRange& range)
{
    constexpr double least = 4;
    for (const bool casing : {true, false})
        for (const std::vector<int>& chain : film.chains)
            for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
                const int a = chain[i], b = chain[i + 1];
                const double width = std::max(least, 0.5 * (film.thickness[a] + film.thickness[b]) * frame.scale);
                draw_band(picture, frame.pixel(film.points[a][0], film.points[a][1]),
                          frame.pixel(film.points[b][0], film.points[b][1]), casing ? width + 2 : width, casing ? 1 : 0.5,
                          casing ? edge : colour_at(ColourMap::film, range.share(0.5 * (film.pressure[a] + film.pressure[b]))),
                          frame.box);
            }
}

void draw_rim(Picture& picture, const PixelBox& box)
{
    const double l = box.left, t = box.top, r = box.right, b = box.bottom;
    for (const auto& [from, to] :
         {std::array<PixelPoint, 2>{{{l, t}, {r, t}}}, {{{r, t}, {r, b}}}, {{{r, b}, {l, b}}}, {{{l, b}, {l, t}}}})
        picture.line(from, to, 1, edge, picture.box());
}

constexpr int scale_height = 52;

// Title, colours, values at the ends and in the middle.
void draw_scale(Picture& picture, int left, int top, int width, const std::string& title, ColourMap map,
                const ColourRange& range)
{
    picture.text(left, top, title, ink);
    for (int x = 0; x < width; ++x)
        for (int y = 0; y < 10; ++y)
            picture.blend(left + x, top + text_height + 1 + y, colour_at(map, (x + 0.5) / width));
    for (int tick = 0; tick <= 2; ++tick) {
        const std::string label = short_number(range.low + 0.5 * tick * (range.high - range.low));
        picture.text(left + (width - text_width(label)) * tick / 2, top + text_height + 12, label, soft);
    }
}

std::string fitting(std::string text, int width)
{
    if (text_width(text) <= width)
        return text;
    while (!text.empty() && text_width(text + "...") > width)
        text.pop_back();
    return text + "...";
}

void draw_header(Picture& picture, const StoredRun& run, const FrameView& state)
{
    const std::string time = "t = " + short_number(state.time);
    const int right = picture.width() - margin - text_width(time);
    picture.text(margin, 12, fitting(run.scene->value("title", ""), right - margin - space), ink);
    picture.text(right, 12, time, ink);
}

constexpr int header = 42;

// What a panel shows; values empty: bodies only.
struct Panel {
    std::string title;
    ColourMap map;
    const std::vector<float>* values;
    ColourRange range;
};

std::vector<Panel> panels_of(const FrameView& state, std::size_t plane, const ColourRanges& ranges)
{
    std::vector<Panel> panels;
    if (plane < state.planes.size() && !state.planes[plane].pressure.empty())
        panels.push_back({"pressure", ColourMap::pressure, &state.planes[plane].pressure, ranges.pressure});
    if (plane < state.planes.size() && !state.planes[plane].speed.empty())
        panels.push_back({"speed", ColourMap::speed, &state.planes[plane].speed, ranges.speed});
    if (panels.empty())
        panels.push_back({"", ColourMap::speed, nullptr, {}});
    return panels;
}

Picture picture_2d(const StoredRun& run, const RunView& view, const FrameView& state, const ColourRanges& ranges, bool films)
{
    const std::vector<Panel> panels = panels_of(state, 0, ranges);
    const double ratio = view.size[1] / view.size[0];
    const Eigen::Vector3d low = view.origin + state.shift;
    const bool stacked = ratio < 0.5;
    const int width = stacked ? 840 : std::min(400, static_cast<int>(560 / ratio)),
              height = std::max(1, static_cast<int>(width * ratio));
    const int count = static_cast<int>(panels.size()), bars = scale_height * (films ? 2 : 1) + 10;
    Picture picture(
        2 * margin + (stacked ? width : count * width + (count - 1) * space),
        header + (stacked ? count * (height + scale_height + 20) + (films ? scale_height : 0) : height + 10 + bars) + 6, paper);
    draw_header(picture, run, state);
    int left = margin, top = header;
    for (const Panel& panel : panels) {
        const Frame2D frame{{left, top, left + width, top + height}, {low[0], low[1]}, width / view.size[0]};
        if (panel.values)
            draw_field(picture, frame, state.planes[0], *panel.values, panel.map, panel.range);
        else
            picture.fill(frame.box, empty);
        draw_bodies(picture, view, state, frame, 2, {0, 1}, 0);
        draw_films(picture, state.film, frame, ranges.film);
        draw_rim(picture, frame.box);
        if (panel.values)
            draw_scale(picture, left, top + height + 8, width, panel.title, panel.map, panel.range);
        if (stacked)
            top += height + scale_height + 20;
        else
            left += width + space;
    }
    if (films)
        draw_scale(picture, margin, stacked ? top : top + height + 10 + scale_height, width, "film pressure", ColourMap::film,
                   ranges.film);
    return picture;
}

// ---- 3D

Colour lit(Colour colour, const Eigen::Vector3d& normal, const Eigen::Vector3d& to_eye)
{
    const Eigen::Vector3d lamp = (to_eye + Eigen::Vector3d(-0.3, 0, 0.7)).normalized();
    const double share = 0.5 + 0.5 * std::max(0.0, (normal.dot(to_eye) < 0 ? -normal : normal).dot(lamp));
    const auto shade = [&](std::uint8_t c) { return static_cast<std::uint8_t>(std::min(255.0, share * c)); };
    return {shade(colour.red), shade(colour.green), shade(colour.blue)};
}

void draw_surfaces(SurfaceRaster& raster, const Camera& camera, const RunView& view, const FrameView& state)
{
    constexpr Colour body_colour{196, 204, 214};
    for (std::size_t b = 0; b < view.bodies.size(); ++b) {
        const BodyView& body = view.bodies[b];
        if (body.inside_out) // would hide everything
            continue;
        std::vector<Eigen::Vector3d> points;
        for (const Eigen::Vector3d& x : body.points)
            points.push_back(state.placements[b].rotation * x + state.placements[b].shift);
        const std::vector<Eigen::Vector3d> normals = corner_normals(points, body.elements);
        for (std::size_t e = 0; e + 2 < body.elements.size(); e += 3) {
            const std::array<Eigen::Vector3d, 3> x = {points[body.elements[e]], points[body.elements[e + 1]],
                                                      points[body.elements[e + 2]]};
            raster.triangle(x, [&](const Eigen::Vector3d& w) {
                const Eigen::Vector3d normal = w[0] * normals[e] + w[1] * normals[e + 1] + w[2] * normals[e + 2];
                const Eigen::Vector3d at = w[0] * x[0] + w[1] * x[1] + w[2] * x[2];
                return std::pair(lit(body_colour, normal.normalized(), (camera.eye() - at).normalized()), true);
            });
        }
    }
}

void draw_slice(SurfaceRaster& raster, const FieldPlane& plane, const Panel& panel)
{
    const auto corner = [&](double a, double b) {
        Eigen::Vector3d x;
        x[plane.axis] = plane.position;
        x[plane.in_plane[0]] = plane.low[0] + a * plane.spacing * plane.cells[0];
        x[plane.in_plane[1]] = plane.low[1] + b * plane.spacing * plane.cells[1];
        return x;
    };
    for (const bool upper : {false, true}) {
        const std::array<std::array<double, 2>, 3> at = upper ? std::array<std::array<double, 2>, 3>{{{1, 1}, {0, 1}, {1, 0}}}
                                                              : std::array<std::array<double, 2>, 3>{{{0, 0}, {1, 0}, {0, 1}}};
        raster.triangle(
            {corner(at[0][0], at[0][1]), corner(at[1][0], at[1][1]), corner(at[2][0], at[2][1])},
            [&](const Eigen::Vector3d& w) {
                const double a = w[0] * at[0][0] + w[1] * at[1][0] + w[2] * at[2][0];
                const double b = w[0] * at[0][1] + w[1] * at[1][1] + w[2] * at[2][1];
                const float value = interpolated(plane, *panel.values, plane.low[0] + a * plane.spacing * plane.cells[0],
                                                 plane.low[1] + b * plane.spacing * plane.cells[1]);
                return std::pair(std::isnan(value) ? Colour{} : banded(panel.map, panel.range, value), !std::isnan(value));
            });
    }
}

void draw_film_surface(SurfaceRaster& raster, const FilmView& film, const ColourRange& range)
{
    for (std::size_t e = 0; e + 2 < film.elements.size(); e += 3) {
        const int* node = film.elements.data() + e;
        raster.triangle_through(
            {film.points[node[0]], film.points[node[1]], film.points[node[2]]},
            [&](const Eigen::Vector3d& w) {
                const double p = w[0] * film.pressure[node[0]] + w[1] * film.pressure[node[1]] + w[2] * film.pressure[node[2]];
                return std::pair(colour_at(ColourMap::film, range.share(p)), true);
            },
            0.5);
    }
}

void draw_domain(SurfaceRaster& raster, const Eigen::Vector3d& low, const Eigen::Vector3d& size)
{
    for (int corner = 0; corner < 8; ++corner)
        for (int axis = 0; axis < 3; ++axis) {
            if (corner >> axis & 1)
                continue;
            Eigen::Vector3d from = low + size.cwiseProduct(Eigen::Vector3d(corner & 1, corner >> 1 & 1, corner >> 2));
            raster.line(from, from + size[axis] * Eigen::Vector3d::Unit(axis), 2, soft);
        }
}

Picture picture_3d(const StoredRun& run, const RunView& view, const FrameView& state, const ColourRanges& ranges, bool films)
{
    constexpr int axis = 1, factor = 2, width = 440, height = 440;
    const std::vector<Panel> panels = panels_of(state, axis, ranges);
    const double ratio = view.size[2] / view.size[0];
    const int slice_width = ratio > 1 ? static_cast<int>(height / ratio) : height,
              slice_height = static_cast<int>(slice_width * ratio);
    const bool sliced = panels.back().values != nullptr;
    Picture picture(2 * margin + width + (sliced ? space + slice_width : 0), header + height + 10 + 2 * scale_height + 12,
                    paper);
    draw_header(picture, run, state);

    const Eigen::Vector3d low = view.origin + state.shift;
    const Camera camera(low, view.size, factor * width, factor * height);
    SurfaceRaster raster(camera, factor * width, factor * height);
    raster.clear(paper);
    if (panels.front().values)
        draw_slice(raster, state.planes[axis], panels.front());
    draw_surfaces(raster, camera, view, state);
    draw_domain(raster, low, view.size);
    draw_film_surface(raster, state.film, ranges.film);
    raster.draw(picture, margin, header, factor);
    int top = header + height + 8;
    if (panels.front().values)
        draw_scale(picture, margin, top, width, panels.front().title + " at y = " + short_number(state.planes[axis].position),
                   panels.front().map, panels.front().range);
    if (films)
        draw_scale(picture, margin, top + scale_height + 2, width, "film pressure (seen through bodies)", ColourMap::film,
                   ranges.film);
    if (!sliced)
        return picture;
    const int left = margin + width + space, slice_top = header + (height - slice_height) / 2;
    const Frame2D frame{
        {left, slice_top, left + slice_width, slice_top + slice_height}, {low[0], low[2]}, slice_width / view.size[0]};
    const FieldPlane& plane = state.planes[axis];
    draw_field(picture, frame, plane, *panels.back().values, panels.back().map, panels.back().range);
    draw_bodies(picture, view, state, frame, axis, plane.in_plane, plane.position);
    draw_rim(picture, frame.box);
    draw_scale(picture, left, top, slice_width, panels.back().title + " at y = " + short_number(plane.position),
               panels.back().map, panels.back().range);
    return picture;
}

// Of every frame, the smallest thickness of the gaps that open or close, at its step; infinity without one.
std::vector<double> thickness_of_frames(const StoredRun& run)
{
    const std::vector<double>&times = run.gaps.number("time"), &thickness = run.gaps.number("thickness");
    const std::vector<std::string>&a = run.gaps.text("body_a"), &b = run.gaps.text("body_b");
    std::map<std::pair<std::string, std::string>, std::array<double, 2>> ranges;
    for (std::size_t row = 0; row < run.gaps.rows; ++row) {
        auto& [low, high] = ranges.try_emplace({a[row], b[row]}, std::array{thickness[row], thickness[row]}).first->second;
        low = std::min(low, thickness[row]);
        high = std::max(high, thickness[row]);
    }
    std::vector<double> result;
    std::size_t row = 0;
    for (const RunFrame& frame : run.frames) {
        double thinnest = std::numeric_limits<double>::infinity();
        while (row < run.gaps.rows && times[row] < frame.time)
            ++row;
        for (std::size_t at = row; at < run.gaps.rows && times[at] == frame.time; ++at)
            if (const auto& [low, high] = ranges.at({a[at], b[at]}); high > low)
                thinnest = std::min(thinnest, thickness[at]);
        result.push_back(thinnest);
    }
    return result;
}

} // namespace

std::vector<std::size_t> key_frames(const StoredRun& run, std::size_t most)
{
    const std::size_t count = run.frames.size();
    if (count == 0)
        return {};
    std::set<std::size_t> chosen{0, count - 1};
    const std::vector<double> thickness = thickness_of_frames(run);
    std::size_t thinnest = 0, widest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (thickness[i] < thickness[thinnest])
            thinnest = i;
        if (std::isfinite(thickness[i]) && (thickness[i] > thickness[widest] || !std::isfinite(thickness[widest])))
            widest = i;
    }
    for (const std::size_t frame : {thinnest, widest})
        if (chosen.size() < most)
            chosen.insert(frame);
    for (std::size_t k = 1; k + 1 < most && chosen.size() < most; ++k)
        chosen.insert(k * (count - 1) / (most - 1));
    return {chosen.begin(), chosen.end()};
}

std::vector<std::filesystem::path> write_frame_pictures(const StoredRun& run, const std::filesystem::path& folder,
                                                        const CountWatcher& watch)
{
    if (run.frames.empty())
        throw InputError(run.folder.string() + ": there is no output time to draw; the run has not reached one, or its files "
                                               "fields/ and bodies/ are gone");
    const RunView view = view_run(run);
    // Colour ranges come from the whole run, from up to 40 of its frames: an impact in one frame must not determine them.
    const std::size_t stride = (run.frames.size() + 39) / 40;
    RangeSampler sampler;
    bool films = false;
    const std::vector<std::size_t> chosen = key_frames(run);
    std::size_t done = 0;
    const auto told = [&] {
        if (watch)
            watch(++done, (run.frames.size() + stride - 1) / stride + chosen.size());
    };
    for (std::size_t index = 0; index < run.frames.size(); index += stride) {
        const FrameView frame = view_frame(run, view, run.frames[index]);
        sampler.add(frame);
        films = films || !frame.film.points.empty();
        told();
    }
    const ColourRanges ranges = sampler.ranges(run.scene->at("fluid").value("reference_pressure", 0.0));
    prepare_folder(folder);
    std::vector<std::filesystem::path> written;
    for (const std::size_t index : chosen) {
        const FrameView frame = view_frame(run, view, run.frames[index]);
        char name[32];
        std::snprintf(name, sizeof name, "frame_%05d.png", frame.number);
        written.push_back(folder / name);
        const auto draw = view.dimension == 2 ? picture_2d : picture_3d;
        draw(run, view, frame, ranges, films).write_png(written.back());
        told();
    }
    return written;
}

} // namespace gapflow
