// Numbers that carry their derivatives by N variables (forward differentiation).
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>

namespace gapflow {

template <int N>
struct Dual {
    static constexpr int variables = N;

    double value = 0;
    std::array<double, N> rate{};

    Dual() = default;
    Dual(double v) : value(v) {} // NOLINT: a constant
    static Dual variable(double v, int k)
    {
        Dual x(v);
        x.rate[k] = 1;
        return x;
    }

    /// The last variable: along a line on which a root of a function of all variables is looked for.
    static Dual along(double s) { return variable(s, N - 1); }
    /// Place of the root of a function on such a line, known as s for the others' values.
    static Dual root(double s, const Dual& function)
    {
        const double slope = function.rate[N - 1];
        Dual result = slope != 0 ? function.scaled(s, -1 / slope) : Dual(s);
        result.rate[N - 1] = 0;
        return result;
    }

    Dual operator-() const { return scaled(-value, -1); }
    Dual& operator+=(const Dual& b)
    {
        value += b.value;
        return add_rates(1, b, 1);
    }
    Dual& operator-=(const Dual& b)
    {
        value -= b.value;
        return add_rates(1, b, -1);
    }
    Dual& operator*=(const Dual& b)
    {
        add_rates(b.value, b, value);
        value *= b.value;
        return *this;
    }
    Dual& operator/=(const Dual& b)
    {
        value /= b.value;
        return add_rates(1 / b.value, b, -value / b.value);
    }
    friend Dual operator+(Dual a, const Dual& b) { return a += b; }
    friend Dual operator-(Dual a, const Dual& b) { return a -= b; }
    friend Dual operator*(Dual a, const Dual& b) { return a *= b; }
    friend Dual operator/(Dual a, const Dual& b) { return a /= b; }
    friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
    friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
    friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
    friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
    friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
    friend bool operator!=(const Dual& a, const Dual& b) { return a.value != b.value; }

    friend Dual abs(const Dual& a) { return a.value < 0 ? -a : a; }
    friend Dual sqrt(const Dual& a) // at 0 without a derivative
    {
        const double root = std::sqrt(a.value);
        return a.scaled(root, root > 0 ? 0.5 / root : 0.0);
    }
    friend Dual hypot(const Dual& a, const Dual& b)
    {
        const double root = std::hypot(a.value, b.value);
        Dual result = a.scaled(root, root > 0 ? a.value / root : 0.0);
        return result.add_rates(1, b, root > 0 ? b.value / root : 0.0);
    }

    /// A function of it with this value and slope.
    Dual scaled(double v, double slope) const
    {
        Dual result(v);
        return result.add_rates(0, *this, slope);
    }

    /// Its value as it is, with the rates of b times `factor`.
    Dual& add_rates_of(const Dual& b, double factor) { return add_rates(1, b, factor); }

private:
    /// Its own rates times `own`, and those of b.
    Dual& add_rates(double own, const Dual& b, double factor)
    {
        for (int k = 0; k < N; ++k)
            rate[k] = own * rate[k] + factor * b.rate[k];
        return *this;
    }
};

inline double value_of(double x)
{
    return x;
}
template <int N>
double value_of(const Dual<N>& x)
{
    return x.value;
}
/// Of a vector of D numbers.
template <int D, class S>
Eigen::Matrix<double, D, 1> values_of(const Eigen::Matrix<S, D, 1>& x)
{
    Eigen::Matrix<double, D, 1> values;
    for (int k = 0; k < D; ++k)
        values[k] = value_of(x[k]);
    return values;
}

} // namespace gapflow

namespace Eigen {

template <int N>
struct NumTraits<gapflow::Dual<N>> : GenericNumTraits<double> {
    using Real = gapflow::Dual<N>;
    using NonInteger = gapflow::Dual<N>;
    using Nested = gapflow::Dual<N>;
    using Literal = gapflow::Dual<N>;
    enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = N, AddCost = N, MulCost = 3 * N };
};
template <int N, class Operation>
struct ScalarBinaryOpTraits<gapflow::Dual<N>, double, Operation> {
    using ReturnType = gapflow::Dual<N>;
};
template <int N, class Operation>
struct ScalarBinaryOpTraits<double, gapflow::Dual<N>, Operation> {
    using ReturnType = gapflow::Dual<N>;
};

} // namespace Eigen
