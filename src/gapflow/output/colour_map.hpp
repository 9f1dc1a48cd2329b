// Colours for values, distinguishable with any colour vision.
//
// pressure: diverging, C. Brewer's RdBu (colorbrewer2.org), blue low, red high; speed: viridis, film pressure: plasma (S. van
// der Walt, N. Smith: perceptually uniform, rising in lightness). Each is a table of 17 colours, linear in between.
#pragma once

#include "gapflow/output/run_view.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace gapflow {

struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0;
};

enum class ColourMap { pressure, speed, film };

/// Colour at t in 0 ... 1; outside: that of the end.
Colour colour_at(ColourMap map, double t);

/// Values at the ends of a colour map.
struct ColourRange {
    double low = 0, high = 1;
    /// Where a value lies, 0 ... 1 inside.
    double share(double value) const { return (value - low) / (high - low); }
};

struct ColourRanges {
    ColourRange pressure, speed, film;
};

/// Collects values of frames for ranges that all frames share. Of every frame the 1 % and the 99 % value, of these over all
/// frames the 3 % and the 97 % one: neither single cells nor an impact in a single one of many frames determine them. Pressure:
/// symmetric about the reference pressure where that lies inside; speed: from 0.
class RangeSampler {
public:
    void add(const FrameView& frame);
    ColourRanges ranges(double reference_pressure) const;

private:
    struct Ends {
        std::vector<float> low, high; ///< of every frame

        void add(const std::vector<float>& values);
        std::array<double, 2> range() const;
    };

    Ends pressure_, speed_, film_;
};

} // namespace gapflow
