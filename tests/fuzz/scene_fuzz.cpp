// The scene reader: any text is a scene or refused with InputError, whose message is one line that names the file. An accepted
// scene holds finite numbers only and can be written as JSON.
#include "target.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/scene/parse_scene.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

void demand(bool good, const char* what, const std::string& detail)
{
    if (good)
        return;
    std::fprintf(stderr, "%s: %s\n", what, detail.c_str());
    std::abort();
}

void check(const gapflow::Scene& scene)
{
    double sum = scene.density + scene.viscosity + scene.end + scene.max_step + scene.output_every + scene.cfl;
    for (const gapflow::BodyScene& body : scene.bodies) {
        for (int i = 0; i < 3; ++i)
            sum += body.position[i] + body.size[i] + body.velocity[i] + body.angular_velocity[i] + body.force[i];
        for (const double part : body.quaternion)
            sum += part;
        sum += body.radius + body.length + body.angle + body.density.value_or(0) + body.mass.value_or(0);
    }
    const std::string json = gapflow::scene_as_json(scene);
    demand(!std::isnan(sum), "not a number in an accepted scene", json);
    for (int axis = 0; axis < scene.dimension; ++axis)
        demand(scene.cells[axis] >= 1 && scene.size[axis] > 0, "an accepted scene without cells", json);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(reinterpret_cast<const char*>(data), size);
    for (const gapflow::Purpose purpose : {gapflow::Purpose::run, gapflow::Purpose::added_mass}) {
        try {
            check(gapflow::parse_scene(text, "fuzz.toml", {}, purpose));
        } catch (const gapflow::InputError& error) {
            const std::string message = error.what();
            demand(message.starts_with("fuzz.toml"), "a message that does not name the file", message);
            demand(message.find('\n') == message.npos, "a message of more than one line", message);
        }
    }
    return 0;
}
