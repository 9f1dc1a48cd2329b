#include "gapflow/coupling/displaced_mass.hpp"

#include "gapflow/geometry/shape.hpp"

#include <algorithm>

namespace gapflow {

template <int D>
TwistMatrix<D> displaced_mass(const Solid<D>& solid, double density)
{
    const MassProperties<D> own = solid.shape.shape().mass_properties();
    const Vec<D> arm = solid.shape.to_world(own.centre) - solid.centre;
    TwistMatrix<D> mass = TwistMatrix<D>::Zero();
    auto spins = mass.template bottomRightCorner<spin_size<D>, spin_size<D>>();
    if constexpr (D == 2)
        spins = density * own.inertia;
    else
        spins = density * solid.shape.rotation() * own.inertia * solid.shape.rotation().transpose();
    for (int d = 0; d < D; ++d) {
        const Twist<D> row = wrench<D>(unit<D>(d), arm);
        mass += density * own.volume * row * row.transpose();
    }
    return mass;
}

template <int D>
ScaledModes<D>::ScaledModes(const TwistMatrix<D>& A, const TwistMatrix<D>& G) : root(G)
{
    const TwistMatrix<D> scaled = root.matrixL().solve(root.matrixL().solve(A).transpose());
    modes.compute(0.5 * (scaled + scaled.transpose()));
}

template <int D>
TwistMatrix<D> ScaledModes<D>::positive_part(const TwistMatrix<D>& A) const
{
    TwistMatrix<D> positive = A;
    for (int k = 0; k < twist_size<D>; ++k)
        if (const double value = modes.eigenvalues()[k]; value < 0) {
            const Twist<D> mode = root.matrixL() * modes.eigenvectors().col(k);
            positive -= value * mode * mode.transpose();
        }
    return positive;
}

template <int D>
double ScaledModes<D>::slope(int i, int j) const
{
    const double a = modes.eigenvalues()[std::max(i, j)], b = modes.eigenvalues()[std::min(i, j)]; // a >= b
    return b >= 0 ? 1.0 : a <= 0 ? 0.0 : a / (a - b);
}

template TwistMatrix<2> displaced_mass(const Solid<2>&, double);
template TwistMatrix<3> displaced_mass(const Solid<3>&, double);
template struct ScaledModes<2>;
template struct ScaledModes<3>;

} // namespace gapflow
