#include "gapflow/scene/check_keys.hpp"
#include "gapflow/scene/parse_scene.hpp"
#include "gapflow/scene/read_parts.hpp"

#include "gapflow/core/error.hpp"

#include <algorithm>
#include <filesystem>

namespace gapflow {

std::string resolved_path(const Scene& scene, const std::string& path)
{
    return (std::filesystem::path(scene.file).parent_path() / path).lexically_normal().string();
}

namespace {

void read_fluid(const Values& v, Scene& scene)
{
    scene.density = v.number("fluid.density");
    scene.viscosity = v.number("fluid.viscosity");
    scene.reference_pressure = v.number("fluid.reference_pressure");
    if (const Node* vapour = v.given("fluid.vapour_pressure"); vapour && vapour->numeric())
        scene.vapour_pressure = vapour->number;
    scene.fluid_velocity = v.triple("fluid.velocity");
    scene.initial = v.choice<Scene::Initial>("fluid.initial");
    scene.fractions = v.choice<Scene::Fractions>("grid.fractions");
    scene.advection = v.choice<Scene::Advection>("grid.advection");
}

void read_time(const Values& v, Purpose purpose, Scene& scene)
{
    for (const char* name : {"time.end", "time.max_step"})
        if (purpose == Purpose::run && !v.given(name))
            v.refuse_missing(name, "a run needs it");
    if (v.given("time.end"))
        scene.end = v.number("time.end");
    if (v.given("time.max_step"))
        scene.max_step = v.number("time.max_step");
    scene.cfl = v.number("time.cfl");
    scene.gap_cfl = v.number("time.gap_cfl");
}

void read_output(const Values& v, Scene& scene)
{
    scene.output_directory = v.text("output.directory");
    scene.output_every = v.number("output.every");
    scene.fields = v.texts("output.fields");
    scene.checkpoint_every = v.number("output.checkpoint_every");
}

Scene scene_of(Node document, const std::string& file, const Overrides& overrides, Purpose purpose)
{
    const std::vector<KeyInfo> keys = scene_keys();
    check_names(document, keys);
    apply_overrides(document, overrides, keys);
    Scene scene;
    scene.file = file;
    scene.dimension = dimension_of(document, keys);
    check_values(document, keys, scene.dimension);

    const Values values(document, "", "", keys, scene.dimension);
    scene.title = values.text("title");
    scene.gravity = values.triple("gravity");
    read_time(values, purpose, scene);
    read_domain(values, scene);
    read_fluid(values, scene);
    const bool moves = purpose == Purpose::run || (purpose == Purpose::check && scene.end > 0);
    read_bodies(document, keys, moves, scene);
    read_gaps(values, keys, scene);
    scene.tolerance = values.number("solver.tolerance");
    scene.backend = values.choice<Scene::Backend>("solver.backend");
    read_output(values, scene);
    const auto fixed = [](const BodyScene& body) { return body.motion == BodyScene::Motion::fixed; };
    if (purpose == Purpose::added_mass && std::all_of(scene.bodies.begin(), scene.bodies.end(), fixed))
        throw InputError(file + ": no body moves, so there is no added mass; add a [[body]] whose motion is not \"fixed\"");
    return scene;
}

} // namespace

Scene read_scene(const std::string& file, const Overrides& overrides, Purpose purpose)
{
    return scene_of(read_document(file), file, overrides, purpose);
}

Scene parse_scene(std::string_view text, const std::string& file, const Overrides& overrides, Purpose purpose)
{
    return scene_of(parse_document(text, file), file, overrides, purpose);
}

} // namespace gapflow
