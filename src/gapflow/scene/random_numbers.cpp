// Compiled without contraction of products and sums, whose rounding would depend on the processor.
#include "gapflow/scene/random_numbers.hpp"

#include <cmath>
#include <numbers>

namespace gapflow {

double RandomNumbers::normal()
{
    for (;;) {
        const double x = 2 * uniform() - 1, y = 2 * uniform() - 1, s = x * x + y * y;
        if (s > 0 && s < 1)
            return x * std::sqrt(-2 * portable_log(s) / s);
    }
}

std::array<double, 4> RandomNumbers::quaternion()
{
    const auto in_disk = [&] {
        for (;;) {
            const double x = 2 * uniform() - 1, y = 2 * uniform() - 1, s = x * x + y * y;
            if (s > 0 && s < 1)
                return std::array{x, y, s};
        }
    };
    const auto [x, y, s] = in_disk();
    const auto [z, w, t] = in_disk();
    const double root = std::sqrt((1 - s) / t);
    return {x, y, z * root, w * root};
}

// ln x = e ln 2 + 2 artanh((m - 1) / (m + 1)), x = m 2^e with m from sqrt(1/2) to sqrt(2): the series' terms fall by 0.03.
double portable_log(double x)
{
    int exponent = 0;
    double m = std::frexp(x, &exponent);
    if (m < 0.5 * std::numbers::sqrt2) {
        m *= 2;
        --exponent;
    }
    const double t = (m - 1) / (m + 1), square = t * t;
    double sum = 0;
    for (int k = 25; k > 0; k -= 2)
        sum = sum * square + 1.0 / k;
    return exponent * std::numbers::ln2 + 2 * t * sum;
}

// exp x = 2^k exp r, |r| <= ln 2 / 2, by Taylor's series.
double portable_exp(double x)
{
    const double k = std::floor(x / std::numbers::ln2 + 0.5), r = x - k * std::numbers::ln2;
    double sum = 1;
    for (int n = 16; n > 0; --n)
        sum = 1 + sum * r / n;
    return std::ldexp(sum, static_cast<int>(k));
}

} // namespace gapflow
