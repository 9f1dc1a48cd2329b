#include "gapflow/output/picture.hpp"
#include "gapflow/output/surface_raster.hpp"

#include "temporary.hpp"

#include "gapflow/core/error.hpp"

#include <gmock/gmock.h>
#include <png.h>

#include <cmath>

using namespace gapflow;

namespace {

constexpr Colour white{255, 255, 255}, black{0, 0, 0}, red{255, 0, 0}, green{0, 255, 0};

std::vector<std::array<PixelPoint, 2>> outline(const std::vector<PixelPoint>& corners)
{
    std::vector<std::array<PixelPoint, 2>> segments;
    for (std::size_t i = 0; i < corners.size(); ++i)
        segments.push_back({corners[i], corners[(i + 1) % corners.size()]});
    return segments;
}

// Blackness of all pixels together.
double inked(const Picture& picture)
{
    double sum = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            sum += (255 - picture.at(x, y).green) / 255.0;
    return sum;
}

} // namespace

TEST(Picture, InsideHasTheRightAreaAlsoAtEdges)
{
    Picture box(20, 20, white);
    box.fill_inside(outline({{2.5, 3}, {10.25, 3}, {10.25, 8.5}, {2.5, 8.5}}), black, box.box());
    EXPECT_NEAR(inked(box), 7.75 * 5.5, 0.1);
    EXPECT_EQ(box.at(5, 5).red, 0);
    EXPECT_EQ(box.at(11, 5).red, 255);
    EXPECT_NEAR(box.at(2, 5).red, 128, 1);

    // A ring: the hole, an outline inside the other, stays as it was.
    Picture ring(20, 20, white);
    auto segments = outline({{1, 1}, {19, 1}, {19, 19}, {1, 19}});
    const auto hole = outline({{5, 5}, {15, 5}, {15, 15}, {5, 15}});
    segments.insert(segments.end(), hole.begin(), hole.end());
    ring.fill_inside(segments, black, ring.box());
    EXPECT_NEAR(inked(ring), 18 * 18 - 10 * 10, 0.1);
    EXPECT_EQ(ring.at(10, 10).red, 255);
}

TEST(Picture, ClipsAndTakesFarAwayCorners)
{
    Picture picture(20, 20, white);
    picture.fill_inside(outline({{-1e4, -1e4}, {1e4, -1e4}, {1e4, 1e4}, {-1e4, 1e4}}), black, {5, 5, 10, 12});
    EXPECT_NEAR(inked(picture), 5 * 7, 1e-9);
    picture.line({-1e8, 2}, {1e8, 2}, 1, black, picture.box());
    EXPECT_EQ(picture.at(19, 2).red < 255, true);
    picture.blend(-1, 3, black);
    picture.blend(3, 20, black);
}

TEST(Picture, LinesAreAsThickAsAsked)
{
    Picture picture(60, 40, white);
    picture.line({10, 20.5}, {50, 20.5}, 4, black, picture.box());
    EXPECT_NEAR(inked(picture), 4 * 40 + std::acos(-1.0) * 4, 4); // with round ends
    EXPECT_EQ(picture.at(30, 20).red, 0);
    EXPECT_EQ(picture.at(30, 24).red, 255);
}

TEST(Picture, TextHasWidthAndInk)
{
    EXPECT_EQ(text_width(""), 0);
    EXPECT_GT(text_width("mm"), text_width("ii"));
    EXPECT_EQ(text_width("\xc3"), text_width("?"));
    Picture picture(200, 30, white);
    picture.text(2, 2, "t = 0.125", black);
    EXPECT_GT(inked(picture), 50);
    for (int y = 0; y < 30; ++y)
        for (int x = 2 + text_width("t = 0.125"); x < 200; ++x)
            ASSERT_EQ(picture.at(x, y).red, 255);
}

TEST(Picture, PngReadsBackWithLibpng)
{
    const test::TemporaryFolder folder;
    Picture picture(3, 2, white);
    picture.blend(1, 0, red);
    picture.blend(2, 1, Colour{1, 2, 3});
    picture.write_png(folder / "p.png");
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_TRUE(png_image_begin_read_from_file(&image, (folder / "p.png").c_str()));
    EXPECT_EQ(image.width, 3U);
    EXPECT_EQ(image.height, 2U);
    image.format = PNG_FORMAT_RGB;
    std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image));
    ASSERT_TRUE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr));
    EXPECT_THAT(pixels, testing::ElementsAre(255, 255, 255, 255, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 255, 1, 2, 3));
    EXPECT_THROW(picture.write_png(folder / "nowhere" / "p.png"), ComputationError);
}

TEST(Camera, SeesTheWholeBoxUpright)
{
    const Eigen::Vector3d low(1, -2, 0.5), size(2, 1, 3);
    const Camera camera(low, size, 300, 200);
    double top = 1e9, bottom = -1e9;
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d p =
            camera.project(low + size.cwiseProduct(Eigen::Vector3d(corner & 1, corner >> 1 & 1, corner >> 2)));
        EXPECT_GE(p[0], 0);
        EXPECT_LE(p[0], 300);
        EXPECT_GE(p[1], 0);
        EXPECT_LE(p[1], 200);
        top = std::min(top, p[1]);
        bottom = std::max(bottom, p[1]);
    }
    EXPECT_GT(bottom - top, 150); // and uses the room
    EXPECT_LT(camera.project(low + size)[1], camera.project(low + size - Eigen::Vector3d(0, 0, size[2]))[1]); // z is up
    EXPECT_LT(camera.project(low)[0], camera.project(low + Eigen::Vector3d(size[0], 0, 0))[0]);               // x to the right
}

TEST(SurfaceRaster, WhatIsNearerHides)
{
    const Camera camera({-1, -1, -1}, {2, 2, 2}, 64, 64);
    const auto wall = [](double y) {
        return std::array<Eigen::Vector3d, 3>{Eigen::Vector3d(-3, y, -3), Eigen::Vector3d(5, y, -3), Eigen::Vector3d(-3, y, 5)};
    };
    const auto paint = [](Colour colour) { return [colour](const Eigen::Vector3d&) { return std::pair(colour, true); }; };
    for (const bool near_first : {true, false}) {
        SurfaceRaster raster(camera, 64, 64);
        raster.clear(white);
        raster.triangle(wall(near_first ? -0.5 : 0.5), paint(near_first ? red : green));
        raster.triangle(wall(near_first ? 0.5 : -0.5), paint(near_first ? green : red));
        Picture picture(32, 32, black);
        raster.draw(picture, 0, 0, 2);
        EXPECT_EQ(picture.at(16, 16).red, 255);
        EXPECT_EQ(picture.at(16, 16).green, 0);
        // Behind, but seen through by half.
        raster.triangle_through(wall(0), paint(green), 0.5);
        raster.draw(picture, 0, 0, 2);
        EXPECT_NEAR(picture.at(16, 16).red, 128, 1);
        EXPECT_NEAR(picture.at(16, 16).green, 128, 1);
    }
}

TEST(SurfaceRaster, WeightsAreThoseInSpace)
{
    const Camera camera({-1, -1, -1}, {2, 2, 2}, 400, 400);
    const std::array<Eigen::Vector3d, 3> corners = {Eigen::Vector3d(-1, -1, 0), Eigen::Vector3d(1, -1, 0),
                                                    Eigen::Vector3d(0, 1, 0)};
    SurfaceRaster raster(camera, 400, 400);
    int pixels = 0;
    double largest = 0;
    raster.triangle(corners, [&](const Eigen::Vector3d& w) {
        const Eigen::Vector3d x = w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2];
        const Eigen::Vector3d p = camera.project(x);
        // x lies behind the centre of some pixel: its place on the picture is a whole number and a half.
        largest = std::max({largest, std::abs(p[0] - std::floor(p[0]) - 0.5), std::abs(p[1] - std::floor(p[1]) - 0.5)});
        ++pixels;
        return std::pair(red, true);
    });
    EXPECT_GT(pixels, 1000);
    EXPECT_LT(largest, 1e-6);
}

TEST(SurfaceRaster, NormalsAreSmoothAcrossFlatAnglesOnly)
{
    // Two triangles that share an edge: at 10 degrees they share normals there, at 90 degrees not.
    for (const double degrees : {10.0, 90.0}) {
        const double angle = degrees * std::acos(-1.0) / 180;
        const std::vector<Eigen::Vector3d> points = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {std::cos(angle), 0, -std::sin(angle)}};
        const auto normals = corner_normals(points, {0, 1, 2, 0, 3, 1});
        EXPECT_NEAR(normals[2].z(), 1, 1e-12);
        EXPECT_NEAR(normals[0].dot(normals[3]), degrees < 35 ? 1 : 0, 1e-12);
    }
}
