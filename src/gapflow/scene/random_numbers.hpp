// Random numbers that are the same on every machine: the standard fixes the engine but not its distributions, and logarithm and
// exponential differ between libraries in the last place.
#pragma once

#include <array>
#include <cstdint>
#include <random>

namespace gapflow {

class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

    /// In [0, 1), a multiple of 2^-53.
    double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// Mean 0, standard deviation 1: the polar method (Marsaglia and Bray, SIAM Review 6, 1964).
    double normal();
    /// Uniform over all rotations in 3D, w x y z (Marsaglia, Ann. Math. Statist. 43, 1972).
    std::array<double, 4> quaternion();

private:
    std::mt19937_64 engine_;
};

/// Natural logarithm of a positive number and exponential, to 1e-15, by additions, multiplications and divisions alone.
double portable_log(double x);
double portable_exp(double x);

} // namespace gapflow
