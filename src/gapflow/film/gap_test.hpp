// Which points of the master's surface lie in the gap of the other (method, "Mesh"). Private to film/.
#pragma once

#include "gapflow/film/film_mesh.hpp"

#include <optional>
#include <vector>

namespace gapflow {

template <int D>
struct GapTest {
    const PlacedShape<D>& master;
    const PlacedShape<D>& other;
    const std::function<double(const Vec<D>&, const Vec<D>&)>& third;
    FilmMeshOptions options; ///< defaults filled in
    std::vector<int> label;  ///< patches of the other that count as one (they join smoothly); empty: all

    bool in_label(int patch) const;
    /// Why the point x of the master's surface with normal n and closest point p is not in the gap; nothing if it is.
    std::optional<RimEnd> fails(const Vec<D>& x, const Vec<D>& n, const SurfacePoint<D>& p) const;
    double thickness(const SurfacePoint<D>& p) const { return std::max(p.distance, options.floor); }
    /// 1/R_A + 1/R_B where positive, else 0: the gap's lateral scale is sqrt(2 R h).
    double curvature(int master_patch, int other_patch) const;
    /// The same of the curvatures in the direction from x[0] to x[1], points of the master with the closest points y.
    double curvature_along(int master_patch, int other_patch, const std::array<Vec<D>, 2>& x,
                           const std::array<Vec<D>, 2>& y) const;
    /// x moved onto the surface of the master where two of its patches meet (second -1: onto the first alone).
    Vec<D> onto(const Vec<D>& x, int patch, int second = -1) const;
};

/// The given patches of a shape in groups that join smoothly (normals within 30 degrees), each sorted, by lowest patch.
template <int D>
std::vector<std::vector<int>> smooth_groups(const Shape<D>& shape, const std::vector<int>& patches);

/// Smallest cosine between normals of surfaces that join smoothly: 30 degrees.
inline constexpr double smooth_cosine = 0.8660254037844386;

} // namespace gapflow
