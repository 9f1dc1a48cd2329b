// The readers of surfaces: any bytes are a closed surface or refused with InputError. The first byte chooses the format. An
// accepted surface has a volume and finite distances.
#include "target.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/geometry/mesh_file.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace gapflow {
namespace {

void demand(bool good, const char* what)
{
    if (good)
        return;
    std::fprintf(stderr, "%s\n", what);
    std::abort();
}

template <int D>
void check(const std::string& text, const std::string& name)
{
    std::unique_ptr<Shape<D>> shape;
    try {
        shape = make_mesh<D>(parse_surface<D>(text, name, 1.0), name);
    } catch (const InputError& error) {
        const std::string message = error.what();
        demand(message.starts_with(name), "a message that does not name the file");
        demand(message.find('\n') == message.npos, "a message of more than one line");
        return;
    }
    demand(std::isfinite(shape->mass_properties().volume) && shape->mass_properties().volume > 0, "a surface without volume");
    const Bounds<D> bounds = shape->bounds();
    for (const Vec<D>& x : {Vec<D>(0.5 * (bounds.low + bounds.high)), bounds.low, Vec<D>(2 * bounds.high - bounds.low)}) {
        const SurfacePoint<D> point = shape->closest(x);
        demand(std::isfinite(point.distance) && point.x.allFinite() && point.normal.allFinite(),
               "a distance that is not finite");
    }
}

} // namespace
} // namespace gapflow

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    switch (data[0] % 3) {
    case 0:
        gapflow::check<3>(text, "fuzz.obj");
        break;
    case 1:
        gapflow::check<3>(text, "fuzz.stl");
        break;
    default:
        gapflow::check<2>(text, "fuzz.txt");
    }
    return 0;
}
