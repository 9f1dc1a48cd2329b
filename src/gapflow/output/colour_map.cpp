#include "gapflow/output/colour_map.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

using Anchors = std::array<std::uint32_t, 17>;
constexpr Anchors brewer_rd_bu = {0x053061, 0x175290, 0x2a71b2, 0x3f8ec0, 0x6bacd1, 0x9bc9e0, 0xc2ddec, 0xe0ecf3, 0xf7f6f6,
                                  0xfbe5d8, 0xfbccb4, 0xf5aa89, 0xe48066, 0xd05548, 0xba2832, 0x930e26, 0x67001f};
constexpr Anchors viridis = {0x440154, 0x48186a, 0x472d7b, 0x424086, 0x3b528b, 0x33638d, 0x2c728e, 0x26828e, 0x21918c,
                             0x1fa088, 0x28ae80, 0x3fbc73, 0x5ec962, 0x84d44b, 0xaddc30, 0xd8e219, 0xfde725};
constexpr Anchors plasma = {0x0d0887, 0x310597, 0x4c02a1, 0x6600a7, 0x7e03a8, 0x9511a1, 0xaa2395, 0xbc3587, 0xcc4778,
                            0xda5a6a, 0xe66c5c, 0xf0804e, 0xf89540, 0xfdac33, 0xfdc527, 0xf8df25, 0xf0f921};

// Never empty: values that are all the same lie in the middle.
ColourRange widened(double low, double high)
{
    if (high - low > 1e-12 * std::max(std::abs(low), std::abs(high)) && high > low)
        return {low, high};
    const double half = low == 0 ? 1 : 0.5 * std::abs(low);
    return {low - half, low + half};
}

void sample(const std::vector<float>& from, const std::vector<float>* fluid, std::vector<float>& to)
{
    constexpr std::size_t most = 20'000; // of a plane: a sufficient sample
    const std::size_t stride = from.size() / most + 1;
    for (std::size_t i = 0; i < from.size(); i += stride)
        if (std::isfinite(from[i]) && (!fluid || (*fluid)[i] > 0))
            to.push_back(from[i]);
}

} // namespace

Colour colour_at(ColourMap map, double t)
{
    const Anchors& anchors = map == ColourMap::pressure ? brewer_rd_bu : map == ColourMap::speed ? viridis : plasma;
    const double place = std::clamp(t, 0.0, 1.0) * (anchors.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), anchors.size() - 2);
    const double s = place - static_cast<double>(below);
    const auto channel = [&](int shift) {
        const double a = anchors[below] >> shift & 255, b = anchors[below + 1] >> shift & 255;
        return static_cast<std::uint8_t>(std::lround(a + s * (b - a)));
    };
    return {channel(16), channel(8), channel(0)};
}

void RangeSampler::Ends::add(const std::vector<float>& values)
{
    if (values.empty())
        return;
    const auto [from, to] = range_between(values, 0.01, 0.99);
    low.push_back(from);
    high.push_back(to);
}

std::array<double, 2> RangeSampler::Ends::range() const
{
    return {range_between(low, 0.03, 1)[0], range_between(high, 0, 0.97)[1]};
}

void RangeSampler::add(const FrameView& frame)
{
    std::vector<float> pressure, speed, film;
    for (const FieldPlane& plane : frame.planes) {
        sample(plane.pressure, &plane.fluid, pressure);
        sample(plane.speed, &plane.fluid, speed);
    }
    sample(frame.film.pressure, nullptr, film);
    pressure_.add(pressure);
    speed_.add(speed);
    film_.add(film);
}

ColourRanges RangeSampler::ranges(double reference_pressure) const
{
    auto [low, high] = pressure_.range();
    if (low <= reference_pressure && reference_pressure <= high) {
        const double half = std::max(reference_pressure - low, high - reference_pressure);
        low = reference_pressure - half;
        high = reference_pressure + half;
    }
    const double fastest = speed_.range()[1];
    const auto film = film_.range();
    return {widened(low, high), {0, fastest > 0 ? fastest : 1}, widened(film[0], film[1])};
}

} // namespace gapflow
