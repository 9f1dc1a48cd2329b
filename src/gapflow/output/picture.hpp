// A small raster picture with smooth edges, written as PNG.
#pragma once

#include "gapflow/output/colour_map.hpp"

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

namespace gapflow {

/// A point of a picture: pixels right of and below the top left corner.
using PixelPoint = std::array<double, 2>;

/// Pixels left <= x < right, top <= y < bottom.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;
    int width() const { return right - left; }
    int height() const { return bottom - top; }
};

class Picture {
public:
    Picture(int width, int height, Colour background);

    int width() const { return width_; }
    int height() const { return height_; }
    PixelBox box() const { return {0, 0, width_, height_}; }
    Colour at(int x, int y) const { return pixels_[static_cast<std::size_t>(y) * width_ + x]; }

    /// Mixes a colour in, by a share of 0 ... 1. Outside the picture: nothing.
    void blend(int x, int y, Colour colour, double share = 1);
    void fill(const PixelBox& box, Colour colour);
    /// The inside (even-odd) of closed outlines, given as segments in any order; clipped to a box.
    void fill_inside(const std::vector<std::array<PixelPoint, 2>>& segments, Colour colour, const PixelBox& clip);
    void line(const PixelPoint& from, const PixelPoint& to, double thickness, Colour colour, const PixelBox& clip);
    /// Text with its top left corner at (x, y); characters other than printable ASCII become '?'.
    void text(int x, int y, std::string_view text, Colour colour);

    /// Throws ComputationError.
    void write_png(const std::filesystem::path& path) const;

private:
    int width_, height_;
    std::vector<Colour> pixels_;
};

/// Pixels that Picture::text takes; a line is text_height high.
int text_width(std::string_view text);
inline constexpr int text_height = 20;

} // namespace gapflow
