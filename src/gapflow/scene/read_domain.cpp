#include "gapflow/scene/graded_widths.hpp"
#include "gapflow/scene/read_parts.hpp"
#include "gapflow/scene/time_table.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/core/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace gapflow {

namespace {

constexpr double most_cells = 2147483648.0; // 2^31

/// Cells for a domain with the given number along x; empty if no whole numbers give the same spacing on all axes.
std::vector<long> fitting_cells(const Scene& scene, long along_x)
{
    std::vector<long> cells;
    for (int axis = 0; axis < scene.dimension; ++axis) {
        const double exact = along_x * (scene.size[axis] / scene.size[0]);
        cells.push_back(std::lround(exact));
        if (cells.back() < 1 || std::abs(exact - cells.back()) > 1e-6 * exact)
            return {};
    }
    return cells;
}

std::string list_text(const auto& numbers, int count)
{
    std::vector<std::string> parts;
    for (int i = 0; i < count; ++i)
        parts.push_back(number_text(static_cast<double>(numbers[i])));
    std::string text = "[";
    text += joined(parts);
    return text += ']';
}

/// Names the cells nearest to those given that fit the size, or the size that fits the cells.
std::string spacing_remedy(const Scene& scene)
{
    const long wanted = scene.cells[0];
    for (long off = 0; off <= wanted + 1000; ++off)
        for (const long along_x : {wanted - off, wanted + off})
            if (const auto cells = along_x < 1 ? std::vector<long>{} : fitting_cells(scene, along_x); !cells.empty())
                return "cells = " + list_text(cells, scene.dimension) + " fit this size";
    Triple size{};
    for (int axis = 0; axis < scene.dimension; ++axis)
        size[axis] = scene.cells[axis] * (scene.size[0] / scene.cells[0]);
    return "no numbers of cells near these fit this size; size = " + list_text(size, scene.dimension) + " fits these cells";
}

/// Sizes that agree with the same spacing on all axes within the seven digits of a CAD program's numbers are made to agree.
void fit_size(const Values& v, Scene& scene)
{
    const double dx = scene.size[0] / scene.cells[0];
    for (int axis = 1; axis < scene.dimension; ++axis) {
        const double other = scene.size[axis] / scene.cells[axis];
        if (std::abs(other - dx) > 1e-6 * dx)
            v.refuse("domain.cells",
                     std::string("the spacing size/cells must be the same on all axes, but is ") + number_text(dx) +
                         " along x and " + number_text(other) + " along " + "xyz"[axis] +
                         " for domain.size = " + list_text(scene.size, scene.dimension),
                     spacing_remedy(scene));
        if (std::abs(other - dx) > 1e-9 * dx)
            scene.size[axis] = scene.cells[axis] * dx;
    }
}

void check_memory(const Values& v, const Scene& scene)
{
    double count = 1;
    for (int axis = 0; axis < scene.dimension; ++axis)
        count *= scene.cells[axis];
    if (count <= most_cells)
        return;
    char text[96];
    std::snprintf(text, sizeof text, "%.3g cells would need about %.3g GiB of memory", count,
                  expected_memory(scene.dimension, count) / 1073741824.0);
    v.refuse(scene.core || v.given("domain.spacing") ? "domain.spacing" : "domain.cells", text,
             "allowed: up to 2^31 cells in all; use fewer cells");
}

/// The table of an inflow or pressure side; `what`: "an inflow", for a message.
TimeTable side_table(const Values& v, const std::string& name, const Node& file, const std::vector<std::string>& columns,
                     const std::string& what, const Scene& scene)
{
    try {
        return read_time_table(resolved_path(scene, file.text), columns);
    } catch (const InputError& e) {
        v.refuse(name, e.what(), what + " file has rows of " + joined(columns, ","));
    }
}

void read_inflow(const Values& v, const std::string& name, const Node& inflow, const Scene& scene, SideScene& side)
{
    side.kind = SideScene::Kind::inflow;
    if (inflow.kind != Node::Kind::text) {
        side.velocity = to_triple(inflow);
        return;
    }
    std::vector<std::string> columns{"time", "u", "v"};
    if (scene.dimension == 3)
        columns.push_back("w");
    side.table = side_table(v, name, inflow, columns, "an inflow", scene);
}

void read_pressure(const Values& v, const std::string& name, const Node& pressure, const Scene& scene, SideScene& side)
{
    side.kind = SideScene::Kind::pressure;
    if (pressure.kind == Node::Kind::text)
        side.table = side_table(v, name, pressure, {"time", "pressure"}, "a pressure", scene);
    else
        side.table = {"", {0}, {{pressure.number}}};
}

void read_side(const Values& v, int number, Scene& scene)
{
    const std::string name = "domain.sides." + side_names[number];
    const int axis = number / 2;
    SideScene& side = scene.sides[number];
    const Node* given = v.given(name);
    if (!given || given->kind == Node::Kind::text) {
        using Kind = SideScene::Kind;
        side.kind =
            std::array{Kind::wall, Kind::open, Kind::periodic, Kind::far, Kind::surface}.at(v.choice<std::size_t>(name));
    } else if (const Node* inflow = given->find("inflow")) {
        read_inflow(v, name, *inflow, scene, side);
    } else if (const Node* pressure = given->find("pressure")) {
        read_pressure(v, name, *pressure, scene, side);
    } else {
        side.velocity = to_triple(*given->find("wall"));
        if (side.velocity[axis] != 0) {
            Triple in_plane = side.velocity;
            in_plane[axis] = 0;
            v.refuse(name, std::string("a wall slides in its own plane, but this velocity has a part along ") + "xyz"[axis],
                     "write { wall = " + list_text(in_plane, scene.dimension) + " }, or { inflow = ... } to let fluid through");
        }
    }
}

void check_periodic(const Values& v, const Scene& scene)
{
    const int least = 3 + static_cast<int>(std::ceil(scene.cfl)); // the halo of a grid must not overlap itself
    for (int axis = 0; axis < scene.dimension; ++axis) {
        const bool low = scene.sides[2 * axis].kind == SideScene::Kind::periodic;
        const bool high = scene.sides[2 * axis + 1].kind == SideScene::Kind::periodic;
        if (low != high)
            v.refuse("domain.sides." + side_names[2 * axis + (low ? 0 : 1)], "an axis is periodic on both sides or on none",
                     "write " + side_names[2 * axis + (low ? 1 : 0)] + " = \"periodic\" too");
        if (low && scene.cells[axis] < least)
            v.refuse(v.given("domain.spacing") ? "domain.spacing" : "domain.cells",
                     std::string("too few cells along the periodic axis ") + "xyz"[axis],
                     "allowed: at least " + std::to_string(least) + " (3 + time.cfl, rounded up) there");
    }
}

/// Beyond a far side a disturbance fades because fluid is around it: it needs room along two axes at least.
void check_far(const Values& v, const Scene& scene)
{
    for (int number = 0; number < 2 * scene.dimension; ++number)
        if (scene.sides[number].kind == SideScene::Kind::far && scene.endless_axes().size() < 2)
            v.refuse("domain.sides." + side_names[number],
                     "the fluid is a channel: walls or periodic sides bound it along all other axes, and in a channel without "
                     "end nothing fades",
                     "write \"open\" for the channel's end, or \"far\" for sides along another axis too");
}

std::string axis_text(int axis)
{
    return std::string(1, "xyz"[axis]);
}

/// Gravity holds a water level at right angles to itself, below air.
void check_surface(const Values& v, const Scene& scene)
{
    for (int number = 0; number < 2 * scene.dimension; ++number) {
        if (scene.sides[number].kind != SideScene::Kind::surface)
            continue;
        const std::string name = "domain.sides." + side_names[number];
        const int axis = number / 2, outwards = number % 2 ? 1 : -1;
        int along = -1; // the axis that gravity is along
        for (int k = 0; k < scene.dimension; ++k)
            if (scene.gravity[k] != 0)
                along = along < 0 ? k : scene.dimension;
        if (along < 0)
            v.refuse(name, "a surface is a water level with air above, and there is no gravity that holds it level",
                     "give gravity, or write \"open\" where fluid is free to pass");
        if (along == scene.dimension)
            v.refuse(name,
                     "a water level is at right angles to gravity, and gravity = " + list_text(scene.gravity, scene.dimension) +
                         " is along no axis",
                     "let gravity be along " + axis_text(axis) + " alone, or write \"open\"");
        if (along != axis || scene.gravity[axis] * outwards > 0)
            v.refuse(name,
                     "a water level has its air on the side that gravity = " + list_text(scene.gravity, scene.dimension) +
                         " points away from",
                     "write " + side_names[2 * along + (scene.gravity[along] < 0 ? 1 : 0)] + " = \"surface\"");
    }
}

/// Number of spacings nearest to a length, at least one. Whether the length is that many, within round-off.
struct CellCount {
    int number = 1;
    bool exact = false;
};
CellCount cell_count(const Values& v, double length, double spacing)
{
    const double cells = length / spacing, number = std::max(1.0, std::round(cells));
    if (number > 1e6)
        v.refuse("domain.spacing", number_text(cells) + " cells along an axis are too many", "allowed: up to 1000000");
    return {static_cast<int>(number), std::abs(cells - number) <= 1e-9 * number};
}

std::string cells_text(double cells)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.7g cells", cells);
    return text;
}

/// Lets the domain end a whole number of cells from its low corner, and says so.
void fit_domain(const Values& v, int axis, double spacing, int cells, Scene& scene)
{
    const double size = cells * spacing;
    scene.warnings.push_back(place_of(*v.given("domain.spacing"), "domain.spacing") + ": the domain is " +
                             cells_text(scene.size[axis] / spacing) + " long along " + axis_text(axis) + "; it is taken as " +
                             cells_text(cells) + ", a domain.size of " + number_text(size) + " there");
    scene.size[axis] = size;
}

/// A uniform grid given by its spacing.
void read_uniform_spacing(const Values& v, double spacing, Scene& scene)
{
    for (int axis = 0; axis < scene.dimension; ++axis) {
        const CellCount count = cell_count(v, scene.size[axis], spacing);
        scene.cells[axis] = count.number;
        if (!count.exact)
            fit_domain(v, axis, spacing, count.number, scene);
    }
}

/// Whether the core's end is at the domain's side, within half a cell: that much is left neither between the two nor beyond the side.
bool ends_at_side(const Values& v, int axis, int end, const CoreScene& core, const Scene& scene)
{
    const double side = scene.origin[axis] + (end ? scene.size[axis] : 0.0);
    const double beyond = end ? side - core.high[axis] : core.low[axis] - side;
    const std::string name = end ? "domain.core.high" : "domain.core.low";
    if (beyond <= -0.5 * core.spacing)
        v.refuse(name, "along " + axis_text(axis) + " the core ends outside the domain, whose side is at " + number_text(side),
                 "put the core inside the domain");
    if (beyond >= 0.5 * core.spacing && scene.sides[2 * axis].kind == SideScene::Kind::periodic)
        v.refuse(name, "the axis " + axis_text(axis) + " is periodic: there cells cannot differ in width",
                 "let the core reach from side to side along it");
    return beyond < 0.5 * core.spacing;
}

/// Moves the ends of a core along an axis to the sides that they are at, and an end inside the domain so that the core is a whole number of cells
/// long; where it reaches from side to side the domain's high side. Says so. The number.
int fit_core(const Values& v, int axis, CoreScene& core, Scene& scene)
{
    const double spacing = core.spacing, side_low = scene.origin[axis], round_off = 1e-9 * scene.size[axis];
    const double side_high = side_low + scene.size[axis];
    double &low = core.low[axis], &high = core.high[axis];
    const double given_low = low;
    double given_high = high;
    const bool at_low = ends_at_side(v, axis, 0, core, scene), at_high = ends_at_side(v, axis, 1, core, scene);
    if (at_low)
        low = side_low;
    if (at_high)
        high = side_high;
    CellCount count = cell_count(v, high - low, spacing);
    if (!count.exact && at_low && at_high) {
        fit_domain(v, axis, spacing, count.number, scene);
        if (std::abs(given_high - side_high) <= round_off) // said so
            given_high = side_low + scene.size[axis];
        high = side_low + scene.size[axis];
    } else if (!count.exact) {
        double& place = at_high ? low : high;
        const auto move = [&] { place = at_high ? high - count.number * spacing : low + count.number * spacing; };
        move();
        if (const double left = at_high ? low - side_low : side_high - high; left < 0.5 * spacing && count.number > 1) {
            --count.number; // cells outside the core are no narrower than half of one
            move();
        }
    }
    for (const bool end : {false, true})
        if (const double given = end ? given_high : given_low, taken = end ? high : low; std::abs(given - taken) > round_off) {
            const std::string name = end ? "domain.core.high" : "domain.core.low";
            scene.warnings.push_back(place_of(*v.given(name), name) + ": along " + axis_text(axis) + " the core is " +
                                     cells_text((given_high - given_low) / spacing) + " long; it is taken as " +
                                     cells_text(count.number) + ", with this end at " + number_text(taken));
        }
    return count.number;
}

/// The core along one axis and the cells outside it.
void read_core_axis(const Values& v, int axis, double largest, CoreScene& core, Scene& scene)
{
    if (!(core.low[axis] < core.high[axis]))
        v.refuse("domain.core.high", "along " + axis_text(axis) + " the core's high end is not above its low end",
                 "give domain.core.low < domain.core.high");
    const int count = fit_core(v, axis, core, scene);
    const double spacing = core.spacing, side_low = scene.origin[axis], side_high = side_low + scene.size[axis];
    const double round_off = 1e-9 * scene.size[axis];
    for (const bool end : {false, true}) {
        const double beyond = end ? side_high - core.high[axis] : core.low[axis] - side_low;
        std::vector<double>& widths = (end ? core.above : core.below)[axis];
        widths = graded_widths(beyond > round_off ? beyond / spacing : 0.0, core.growth, largest / spacing);
    }
    scene.cells[axis] = count + static_cast<int>(core.below[axis].size() + core.above[axis].size());
}

void read_spacing(const Values& v, Scene& scene)
{
    const double spacing = v.number("domain.spacing");
    if (v.given("domain.cells"))
        v.refuse("domain.cells", "domain.spacing is given too", "give one of the two");
    const bool low = v.given("domain.core.low") != nullptr, high = v.given("domain.core.high") != nullptr;
    if (!low && !high)
        return read_uniform_spacing(v, spacing, scene);
    if (!low || !high)
        v.refuse(low ? "domain.core.low" : "domain.core.high", "a core has two corners",
                 std::string("give domain.core.") + (low ? "high" : "low") + " too");
    CoreScene core;
    core.spacing = spacing;
    core.low = v.triple("domain.core.low");
    core.high = v.triple("domain.core.high");
    core.growth = v.number("domain.growth");
    double largest = std::numeric_limits<double>::infinity();
    if (v.given("domain.largest")) {
        core.largest = largest = v.number("domain.largest");
        if (largest < spacing)
            v.refuse("domain.largest", "the largest width is below domain.spacing, " + number_text(spacing),
                     "allowed: at least domain.spacing");
    }
    bool any = false;
    for (int axis = 0; axis < scene.dimension; ++axis) {
        read_core_axis(v, axis, largest, core, scene);
        any = any || !core.below[axis].empty() || !core.above[axis].empty();
    }
    if (any) // otherwise the grid is uniform
        scene.core = core;
}

void read_follow(const Values& v, Scene& scene)
{
    const Node* given = v.given("domain.follow");
    if (!given)
        return;
    FollowScene follow;
    const Node* axes = given->kind == Node::Kind::text ? nullptr : given->find("axes");
    follow.body = given->kind == Node::Kind::text ? given->text : given->find("body")->text;
    for (int axis = 0; axis < scene.dimension; ++axis) {
        follow.axes[axis] = !axes || std::any_of(axes->items.begin(), axes->items.end(),
                                                 [&](const Node& item) { return item.text == axis_text(axis); });
        for (int end = 0; end < 2 && follow.axes[axis]; ++end) {
            const SideScene::Kind kind = scene.sides[2 * axis + end].kind;
            if (kind != SideScene::Kind::open && kind != SideScene::Kind::far && kind != SideScene::Kind::inflow)
                v.refuse("domain.follow",
                         "the side " + side_names[2 * axis + end] + " would move through the fluid along " + axis_text(axis),
                         "follow the body along other axes, as in { body = \"" + follow.body +
                             "\", axes = [...] }, or make the sides there far, open or inflow");
        }
    }
    scene.follow = follow;
}

void read_cells(const Values& v, Scene& scene)
{
    for (const char* name : {"domain.core.low", "domain.core.high", "domain.growth", "domain.largest"})
        if (v.given(name))
            v.refuse(name, "cells outside a core grow from domain.spacing, which is not given",
                     "give domain.spacing instead of domain.cells");
    if (!v.given("domain.cells"))
        v.refuse_missing("domain.cells", "give it, or domain.spacing");
    const Triple cells = v.triple("domain.cells");
    for (int axis = 0; axis < scene.dimension; ++axis)
        scene.cells[axis] = static_cast<int>(cells[axis]);
    check_memory(v, scene);
    fit_size(v, scene);
}

} // namespace

void read_domain(const Values& v, Scene& scene)
{
    scene.size = v.triple("domain.size");
    scene.origin = v.triple("domain.origin");
    for (int number = 0; number < 2 * scene.dimension; ++number)
        read_side(v, number, scene);
    if (v.given("domain.spacing")) {
        read_spacing(v, scene);
        check_memory(v, scene);
    } else {
        read_cells(v, scene);
    }
    check_periodic(v, scene);
    check_far(v, scene);
    check_surface(v, scene);
    read_follow(v, scene);
    scene.leaving = v.choice<Scene::Leaving>("domain.leaving");
}

} // namespace gapflow
