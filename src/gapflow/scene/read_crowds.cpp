#include "gapflow/scene/body_shape.hpp"
#include "gapflow/scene/check_keys.hpp"
#include "gapflow/scene/crowd_placing.hpp"
#include "gapflow/scene/read_parts.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace gapflow {

namespace {

constexpr double most_bodies = 100'000;    // of a crowd
constexpr double automatic_spacing = 0.02; // over the radius of the ball that holds a body
constexpr double least_normal = 0.1;       // of the mean: smaller factors of a normal distribution are drawn again
constexpr int most_draws = 100'000;        // of one factor

std::string short_text(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

void read_crowd_name(const Values& v, const Scene& scene, CrowdScene& crowd)
{
    crowd.name = v.text("name");
    check_body_name(v, crowd.name);
    for (const CrowdScene& other : scene.crowds)
        if (other.name == crowd.name)
            v.refuse("name", "an earlier [[crowd]] has this name", "give every crowd a name of its own");
    const auto of_crowd = [&](const std::string& name) {
        const std::string start = crowd.name + "_";
        return name.starts_with(start) && name.find_first_not_of("0123456789", start.size()) == name.npos;
    };
    for (const BodyScene& body : scene.bodies)
        if (body.name == crowd.name || of_crowd(body.name))
            v.refuse("name", "the body '" + body.name + "' has this name or one of the crowd's bodies'",
                     "choose another name: those of the bodies are " + crowd.name + "_0001, " + crowd.name + "_0002 ...");
}

// ---- sizes

struct Sizes {
    enum class Kind { fixed, uniform, normal, log_normal };
    Kind kind = Kind::fixed;
    double mean = 1, deviation = 0, low = 0, high = std::numeric_limits<double>::infinity();
};

Sizes read_sizes(const Values& v)
{
    Sizes sizes;
    sizes.kind = v.choice<Sizes::Kind>("sizes.distribution");
    const std::string word = v.text("sizes.distribution");
    const auto needs = [&](const char* name) {
        if (!v.given(name))
            v.refuse_missing(name, "a " + word + " distribution needs it");
    };
    const auto has_none = [&](const char* name) {
        if (v.given(name))
            v.refuse(name, "a " + word + " distribution has none",
                     v.given("sizes.distribution") ? "remove it, or choose another sizes.distribution"
                                                   : "add sizes.distribution = \"uniform\", \"normal\" or \"log-normal\"");
    };
    const bool fixed = sizes.kind == Sizes::Kind::fixed, uniform = sizes.kind == Sizes::Kind::uniform;
    if (fixed || uniform)
        has_none("sizes.deviation");
    else
        needs("sizes.deviation");
    for (const char* end : {"sizes.low", "sizes.high"})
        if (fixed)
            has_none(end);
        else if (uniform)
            needs(end);
    if (uniform)
        has_none("sizes.mean");
    sizes.mean = v.number("sizes.mean");
    if (v.given("sizes.deviation"))
        sizes.deviation = v.number("sizes.deviation");
    if (sizes.kind == Sizes::Kind::normal)
        sizes.low = least_normal * sizes.mean;
    if (v.given("sizes.low"))
        sizes.low = v.number("sizes.low");
    if (v.given("sizes.high"))
        sizes.high = v.number("sizes.high");
    if (!(sizes.low < sizes.high))
        v.refuse(v.given("sizes.high") ? "sizes.high" : "sizes.low", "the smallest factor is not below the largest",
                 "give sizes.low < sizes.high");
    return sizes;
}

double draw_factor(const Values& v, const Sizes& sizes, RandomNumbers& random)
{
    if (sizes.kind == Sizes::Kind::fixed)
        return sizes.mean;
    if (sizes.kind == Sizes::Kind::uniform)
        return random.uniform(sizes.low, sizes.high);
    // Of a log-normal variable with this mean and deviation, the logarithm has the variance ln(1 + (deviation / mean)^2).
    const double ratio = sizes.deviation / sizes.mean, variance = portable_log(1 + ratio * ratio);
    for (int draw = 0; draw < most_draws; ++draw) {
        const double x = random.normal();
        const double factor = sizes.kind == Sizes::Kind::normal
                                  ? sizes.mean + sizes.deviation * x
                                  : sizes.mean * portable_exp(std::sqrt(variance) * x - 0.5 * variance);
        if (factor >= sizes.low && factor <= sizes.high)
            return factor;
    }
    v.refuse(v.given("sizes.low") ? "sizes.low" : "sizes.high",
             "next to no factor of this distribution is between sizes.low and sizes.high",
             "let the ends include the mean, or use a uniform distribution");
}

// The factors of all bodies; `volume`: of a body of factor 1, `room`: of the region.
std::vector<double> draw_factors(const Values& v, const Sizes& sizes, double volume, double room, int dimension,
                                 RandomNumbers& random)
{
    std::vector<double> factors;
    if (v.given("number")) {
        for (double n = v.number("number"); n > 0; --n)
            factors.push_back(draw_factor(v, sizes, random));
        return factors;
    }
    const double wanted = v.number("volume_fraction") * room;
    double sum = 0;
    for (;;) { // until one more body takes the sum further away
        const double factor = draw_factor(v, sizes, random);
        const double next = volume * (dimension == 2 ? factor * factor : factor * factor * factor);
        if (sum + 0.5 * next > wanted)
            break;
        sum += next;
        factors.push_back(factor);
        if (static_cast<double>(factors.size()) > most_bodies)
            v.refuse("volume_fraction", "gives about " + short_text(wanted / sum * most_bodies) + " bodies",
                     "allowed: up to " + number_text(most_bodies) + "; use larger bodies or a smaller region");
    }
    if (factors.empty())
        v.refuse("volume_fraction",
                 "is less than half a body in the region (a body: " + short_text(volume) + ", the region: " + short_text(room) +
                     ")",
                 "use smaller bodies, a larger region or a larger fraction");
    return factors;
}

// ---- region

/// The keys of [crowd.region] that are given must be all of one of these.
const std::vector<std::vector<std::string>> region_keys{{"low", "high"}, {"centre", "radius"}, {"from", "to", "radius"}};
constexpr const char* region_remedy =
    "a region has low and high (a box), centre and radius (a ball), or from, to and radius (a cylinder, 3D)";

int region_kind(const Values& v)
{
    const Node* region = v.given("region");
    if (!region)
        return 0;
    for (const char* first : {"centre", "from", "to"}) // what tells the shape
        for (int kind = 1; kind < 3; ++kind)
            if (const auto& keys = region_keys[static_cast<std::size_t>(kind)];
                v.given(std::string("region.") + first) && std::find(keys.begin(), keys.end(), first) != keys.end()) {
                for (const Node& item : region->items)
                    if (std::find(keys.begin(), keys.end(), item.key) == keys.end())
                        v.refuse("region." + item.key, std::string("given together with region.") + first, region_remedy);
                for (const std::string& key : keys)
                    if (!v.given("region." + key))
                        v.refuse_missing("region." + key, kind == 1 ? "a ball needs it" : "a cylinder needs it");
                return kind;
            }
    if (v.given("region.radius"))
        v.refuse("region.radius", "given without region.centre, or region.from and region.to", region_remedy);
    return 0;
}

template <int D>
Region<D> read_region(const Values& v, const CrowdRoom<D>& room)
{
    Region<D> region;
    const int kind = region_kind(v);
    const Vec<D> low = room.low(), high = room.low() + room.size();
    const auto round_off = [&](int axis) { return 1e-9 * room.size()[axis]; };
    if (kind == 0) {
        region.low = v.given("region.low") ? to_vec<D>(v.triple("region.low")) : low;
        region.high = v.given("region.high") ? to_vec<D>(v.triple("region.high")) : high;
        for (int axis = 0; axis < D; ++axis)
            if (!(region.low[axis] < region.high[axis]))
                v.refuse(v.given("region.high") ? "region.high" : "region.low",
                         std::string("the region has no extent along ") + "xyz"[axis], "give region.low < region.high");
    } else if (kind == 1) {
        region.kind = Region<D>::Kind::ball;
        region.centre = to_vec<D>(v.triple("region.centre"));
        region.radius = v.number("region.radius");
        region.low = region.centre - Vec<D>::Constant(region.radius);
        region.high = region.centre + Vec<D>::Constant(region.radius);
    } else {
        if (D == 2)
            v.refuse("region.from", "a cylinder needs three dimensions", "use a ball (a disk) or a box in a 2D scene");
        region.kind = Region<D>::Kind::cylinder;
        const Vec<D> from = to_vec<D>(v.triple("region.from")), to = to_vec<D>(v.triple("region.to"));
        region.length = (to - from).norm();
        if (!(region.length > 0))
            v.refuse("region.to", "the same point as region.from", "give the ends of the cylinder's axis");
        region.radius = v.number("region.radius");
        region.centre = 0.5 * (from + to);
        region.axis = (to - from) / region.length;
        for (int axis = 0; axis < D; ++axis) {
            const double a = region.axis[axis];
            const double half = 0.5 * region.length * std::abs(a) + region.radius * std::sqrt(std::max(0.0, 1 - a * a));
            region.low[axis] = region.centre[axis] - half;
            region.high[axis] = region.centre[axis] + half;
        }
    }
    for (int axis = 0; axis < D; ++axis) {
        const bool below =
            region.low[axis]<low[axis] - round_off(axis), above = region.high[axis]> high[axis] + round_off(axis);
        if (below || above)
            v.refuse(kind == 0 && v.given(below ? "region.low" : "region.high") ? (below ? "region.low" : "region.high")
                                                                                : "region",
                     std::string("the region reaches out of the domain along ") + "xyz"[axis],
                     std::string("allowed along ") + "xyz"[axis] + ": from " + number_text(low[axis]) + " to " +
                         number_text(high[axis]));
        if (kind == 0) {
            region.low[axis] = std::max(region.low[axis], low[axis]);
            region.high[axis] = std::min(region.high[axis], high[axis]);
            region.endless[axis] =
                room.period()[axis] > 0 && region.high[axis] - region.low[axis] > room.size()[axis] - round_off(axis);
        }
    }
    return region;
}

// ---- bodies

/// A body of the crowd: the crowd's own with all lengths times a factor.
BodyScene scaled(BodyScene body, double factor, int dimension)
{
    for (double& length : body.size)
        length *= factor;
    body.radius *= factor;
    body.length *= factor;
    body.mesh_scale *= factor;
    body.thickness *= factor;
    const double volume = dimension == 2 ? factor * factor : factor * factor * factor;
    if (body.mass)
        body.mass = *body.mass * volume;
    for (double& moment : body.inertia)
        moment *= volume * factor * factor;
    return body;
}

template <int D>
void set_pose(BodyScene& body, const Vec<D>& position, const Rotation<D>& rotation)
{
    for (int axis = 0; axis < D; ++axis)
        body.position[axis] = position[axis];
    if constexpr (D == 2)
        body.angle = rotation.angle();
    else
        body.quaternion = {rotation.w(), rotation.x(), rotation.y(), rotation.z()};
}

/// The key that says how many bodies there are.
const char* amount_key(const Values& v)
{
    return v.given("number") ? "number" : "volume_fraction";
}

template <int D>
double volume_of(const CrowdPlan<D>& plan, double volume)
{
    double sum = 0;
    for (const double factor : plan.factors)
        sum += volume * std::pow(factor, D);
    return sum;
}

template <int D>
[[noreturn]] void refuse_crowded(const Values& v, const CrowdPlan<D>& plan, const CrowdScene& crowd, int found)
{
    const bool lattice = crowd.arrangement == CrowdScene::Arrangement::lattice;
    const std::string spacing = "spacing (" + short_text(crowd.spacing) + (v.given("spacing") ? ")" : ", auto)");
    if (found == 0 && !lattice)
        v.refuse(amount_key(v), "no body finds room in the region",
                 "use smaller bodies, a larger region or a smaller " + spacing);
    const std::string count = std::to_string(found) + " of " + std::to_string(plan.factors.size()) + " bodies";
    char fraction[64];
    std::snprintf(fraction, sizeof fraction, ", a volume fraction of %.3g", crowd.volume_fraction);
    const std::string fewer = "use fewer bodies, a larger region or a smaller " + spacing;
    if (lattice)
        v.refuse(amount_key(v), "only " + count + fraction + " together, have room at their sites of the lattice",
                 fewer + ", or arrangement = \"random\"");
    v.refuse(amount_key(v), "only " + count + fraction + " together, find room at random",
             fewer + (plan.hull.ball() ? "; balls go up to a fraction of about 0.55 (disks: 0.75), less next to walls"
                                       : ", or arrangement = \"lattice\""));
}

template <int D>
void add_crowd(const Values& v, bool moves, CrowdRoom<D>& room, Scene& scene)
{
    CrowdScene crowd;
    read_crowd_name(v, scene, crowd);
    if (v.given("number") && v.given("volume_fraction"))
        v.refuse("volume_fraction", "given together with number", "keep one of them");
    if (!v.given("number") && !v.given("volume_fraction"))
        v.refuse_missing("number", "a crowd needs number or volume_fraction");
    if (v.given("file") && v.text("shape") != "mesh" && v.text("shape") != "sheet")
        v.refuse("file", "a " + v.text("shape") + " has no file",
                 "remove it; a crowd moves with constant velocities, not as in a file");
    const BodyScene body = read_crowd_body(v, moves, scene);
    std::unique_ptr<Shape<D>> shape;
    try {
        shape = make_shape<D>(body);
    } catch (const InputError& error) {
        v.refuse(body.shape == BodyScene::ShapeKind::mesh ? "file" : "shape", error.what(), "give another one");
    }
    const double volume = shape->mass_properties().volume;
    const ShapeHull<D> own = hull_of<D>(body, *shape);

    CrowdPlan<D> plan;
    plan.region = read_region<D>(v, room);
    crowd.seed = static_cast<std::uint64_t>(v.number("seed"));
    RandomNumbers random(crowd.seed);
    plan.factors = draw_factors(v, read_sizes(v), volume, plan.region.volume(), D, random);
    plan.hull = own.hull;
    crowd.arrangement = v.choice<CrowdScene::Arrangement>("arrangement");
    const bool lattice = crowd.arrangement == CrowdScene::Arrangement::lattice;
    const Node* spacing = v.given("spacing");
    const double held = std::max(scene.contact.thickness, scene.gap.automatic_roughness ? 0.0 : scene.gap.roughness);
    crowd.spacing = spacing && spacing->numeric() ? spacing->number : std::max(automatic_spacing * own.hull.reach, held);
    plan.spacing = crowd.spacing;
    const Node* rotation = v.given("rotation");
    if (rotation ? rotation->kind != Node::Kind::text : lattice)
        plan.rotation = scene_pose<D>(body).rotation;
    if (!lattice && v.given("jitter"))
        v.refuse("jitter", "only a lattice has jitter", "remove it, or add arrangement = \"lattice\"");
    plan.jitter = v.number("jitter");
    if (lattice && plan.region.kind != Region<D>::Kind::box)
        v.refuse("arrangement", "a lattice fills a box", "give region.low and region.high, or arrangement = \"random\"");

    crowd.region_volume = plan.region.volume();
    crowd.volume_fraction = volume_of(plan, volume) / crowd.region_volume;
    if (crowd.volume_fraction >= 1)
        v.refuse(amount_key(v),
                 std::to_string(plan.factors.size()) + " bodies have " + short_text(crowd.volume_fraction) +
                     " times the region's volume",
                 "use fewer or smaller bodies, or a larger region");
    const auto [least, most] = std::minmax_element(plan.factors.begin(), plan.factors.end());
    crowd.smallest = *least;
    crowd.largest = *most;
    room.expect(*most * own.hull.reach, plan.spacing);
    const CrowdPlaces<D> found = lattice ? place_on_lattice(plan, room, random) : place_at_random(plan, room, random);
    crowd.number = static_cast<int>(plan.factors.size());
    if (found.found < crowd.number)
        refuse_crowded(v, plan, crowd, found.found);

    crowd.first = static_cast<int>(scene.bodies.size());
    const std::size_t digits = std::max<std::size_t>(4, std::to_string(crowd.number).size());
    for (int i = 0; i < crowd.number; ++i) {
        const double factor = plan.factors[static_cast<std::size_t>(i)];
        const CrowdPlace<D>& place = found.places[static_cast<std::size_t>(i)];
        BodyScene one = scaled(body, factor, D);
        std::string number = std::to_string(i + 1);
        number.insert(0, digits - number.size(), '0');
        one.name = crowd.name + "_" + number;
        set_pose<D>(one, place.centre - factor * (place.rotation * own.centre), place.rotation);
        scene.bodies.push_back(std::move(one));
    }
    scene.crowds.push_back(crowd);
}

template <int D>
void add_crowds(const Node& crowds, const std::vector<KeyInfo>& keys, bool moves, Scene& scene)
{
    std::optional<CrowdRoom<D>> room;
    try {
        room.emplace(scene);
    } catch (const InputError& error) { // a mesh of another body
        throw InputError(scene.file + ": " + error.what());
    }
    for (std::size_t i = 0; i < crowds.items.size(); ++i) {
        const Node& table = crowds.items[i];
        add_crowd<D>(Values(table, "crowd.", shown_prefix(table, "crowd", static_cast<int>(i) + 1), keys, D), moves, *room,
                     scene);
    }
}

} // namespace

void read_crowds(const Node& document, const std::vector<KeyInfo>& keys, bool moves, Scene& scene)
{
    const Node* crowds = document.find("crowd");
    if (!crowds || crowds->items.empty())
        return;
    if (scene.dimension == 2)
        add_crowds<2>(*crowds, keys, moves, scene);
    else
        add_crowds<3>(*crowds, keys, moves, scene);
}

} // namespace gapflow
