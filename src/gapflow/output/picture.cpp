#include "gapflow/output/picture.hpp"

#include "gapflow/output/assets.hpp"
#include "gapflow/output/file.hpp"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace gapflow {

namespace {

// ---- font.pgm: 95 glyphs of 16 x 20 pixels, a byte each, below each other
constexpr int glyph_width = 16, glyphs = 95;

struct Glyph {
    const unsigned char* ink; ///< rows of glyph_width
    int advance;
};

const std::array<Glyph, glyphs>& font()
{
    static const std::array<Glyph, glyphs> all = [] {
        const std::string_view file = assets::font_pgm();
        const auto* ink =
            reinterpret_cast<const unsigned char*>(file.data()) + file.size() - glyphs * glyph_width * text_height;
        std::array<Glyph, glyphs> result{};
        for (Glyph& glyph : result) {
            glyph = {ink, 4}; // of a blank, less the space behind
            for (int i = 0; i < glyph_width * text_height; ++i)
                if (ink[i] > 0)
                    glyph.advance = std::max(glyph.advance, i % glyph_width + 1);
            glyph.advance += 1;
            ink += glyph_width * text_height;
        }
        return result;
    }();
    return all;
}

const Glyph& glyph_of(char c)
{
    return font()[c >= 32 && c < 127 ? c - 32 : '?' - 32];
}

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, double share)
{
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
}

void append_bytes(png_structp png, png_bytep bytes, png_size_t count)
{
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

} // namespace

Picture::Picture(int width, int height, Colour background)
    : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * height, background)
{
}

void Picture::blend(int x, int y, Colour colour, double share)
{
    if (x < 0 || y < 0 || x >= width_ || y >= height_)
        return;
    Colour& pixel = pixels_[static_cast<std::size_t>(y) * width_ + x];
    const double s = std::clamp(share, 0.0, 1.0);
    pixel = {mixed(pixel.red, colour.red, s), mixed(pixel.green, colour.green, s), mixed(pixel.blue, colour.blue, s)};
}

void Picture::fill(const PixelBox& box, Colour colour)
{
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x)
            blend(x, y, colour);
}

// Coverage of a pixel: mean over four lines through it, each exact along the line.
void Picture::fill_inside(const std::vector<std::array<PixelPoint, 2>>& segments, Colour colour, const PixelBox& clip)
{
    constexpr int lines = 4;
    std::vector<double> crossings;
    std::vector<double> coverage(static_cast<std::size_t>(std::max(clip.width(), 0)));
    for (int y = clip.top; y < clip.bottom; ++y) {
        std::fill(coverage.begin(), coverage.end(), 0.0);
        for (int line = 0; line < lines; ++line) {
            const double at = y + (line + 0.5) / lines;
            crossings.clear();
            for (const auto& [a, b] : segments)
                if ((a[1] <= at) != (b[1] <= at))
                    crossings.push_back(a[0] + (at - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
            std::sort(crossings.begin(), crossings.end());
            for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
                const double from = std::max(crossings[i], static_cast<double>(clip.left));
                const double to = std::min(crossings[i + 1], static_cast<double>(clip.right));
                for (int x = static_cast<int>(std::floor(from)); x < to; ++x)
                    coverage[x - clip.left] +=
                        std::max(0.0, std::min(to, x + 1.0) - std::max(from, static_cast<double>(x))) / lines;
            }
        }
        for (int x = clip.left; x < clip.right; ++x)
            if (coverage[x - clip.left] > 0)
                blend(x, y, colour, coverage[x - clip.left]);
    }
}

void Picture::line(const PixelPoint& from, const PixelPoint& to, double thickness, Colour colour, const PixelBox& clip)
{
    const double dx = to[0] - from[0], dy = to[1] - from[1], length2 = dx * dx + dy * dy, reach = 0.5 * thickness + 1;
    const int left = std::max<int>(clip.left, static_cast<int>(std::max(-1e6, std::min(from[0], to[0]) - reach)));
    const int right = std::min<int>(clip.right, static_cast<int>(std::min(1e6, std::max(from[0], to[0]) + reach)) + 1);
    const int top = std::max<int>(clip.top, static_cast<int>(std::max(-1e6, std::min(from[1], to[1]) - reach)));
    const int bottom = std::min<int>(clip.bottom, static_cast<int>(std::min(1e6, std::max(from[1], to[1]) + reach)) + 1);
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const double px = x + 0.5 - from[0], py = y + 0.5 - from[1];
            const double along = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0;
            const double distance = std::hypot(px - along * dx, py - along * dy);
            if (distance < 0.5 * thickness + 0.5)
                blend(x, y, colour, std::min(1.0, 0.5 * thickness + 0.5 - distance));
        }
}

void Picture::text(int x, int y, std::string_view text, Colour colour)
{
    for (const char c : text) {
        const Glyph& glyph = glyph_of(c);
        for (int i = 0; i < glyph_width * text_height; ++i)
            if (glyph.ink[i] > 0)
                blend(x + i % glyph_width, y + i / glyph_width, colour, glyph.ink[i] / 255.0);
        x += glyph.advance;
    }
}

int text_width(std::string_view text)
{
    int width = 0;
    for (const char c : text)
        width += glyph_of(c).advance;
    return width;
}

void Picture::write_png(const std::filesystem::path& path) const
{
    std::string content;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (!info || setjmp(png_jmpbuf(png))) {
        png_destroy_write_struct(&png, &info);
        throw_file_error(path, "cannot make the picture", ENOMEM);
    }
    png_set_write_fn(png, &content, append_bytes, nullptr);
    png_set_compression_level(png, 9);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width_), static_cast<png_uint_32>(height_), 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    static_assert(sizeof(Colour) == 3);
    for (int y = 0; y < height_; ++y)
        png_write_row(png, reinterpret_cast<png_const_bytep>(pixels_.data() + static_cast<std::size_t>(y) * width_));
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    write_atomically(path, content);
}

} // namespace gapflow
