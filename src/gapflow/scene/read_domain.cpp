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
#include <optional>

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
        if (cells.back() < 1 || std::abs(exact - cells.back()) > 1e-9 * exact)
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

void check_spacing(const Values& v, const Scene& scene)
{
    const double dx = scene.size[0] / scene.cells[0];
    for (int axis = 1; axis < scene.dimension; ++axis) {
        const double other = scene.size[axis] / scene.cells[axis];
        if (std::abs(other - dx) > 1e-9 * dx)
            v.refuse("domain.cells",
                     std::string("the spacing size/cells must be the same on all axes, but is ") + number_text(dx) +
                         " along x and " + number_text(other) + " along " + "xyz"[axis] +
                         " for domain.size = " + list_text(scene.size, scene.dimension),
                     spacing_remedy(scene));
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
        side.kind = std::array{Kind::wall, Kind::open, Kind::periodic, Kind::far}.at(v.choice<std::size_t>(name));
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

/// Whole number of spacings in a length; empty if there is none.
std::optional<int> whole_cells(double length, double spacing)
{
    const double exact = length / spacing, count = std::round(exact);
    if (count < 1 || count > 1e6 || std::abs(exact - count) > 1e-9 * count)
        return {};
    return static_cast<int>(count);
}

/// A uniform grid given by its spacing.
void read_uniform_spacing(const Values& v, double spacing, Scene& scene)
{
    for (int axis = 0; axis < scene.dimension; ++axis) {
        const std::optional<int> count = whole_cells(scene.size[axis], spacing);
        if (!count)
            v.refuse("domain.spacing",
                     "the domain is " + number_text(scene.size[axis] / spacing) + " cells long along " + axis_text(axis),
                     "without a domain.core, domain.size must be a multiple of the spacing along every axis");
        scene.cells[axis] = *count;
    }
}

/// The core along one axis and the cells outside it.
void read_core_axis(const Values& v, int axis, double largest, CoreScene& core, Scene& scene)
{
    const double spacing = core.spacing, side_low = scene.origin[axis], side_high = side_low + scene.size[axis];
    const double round_off = 1e-9 * scene.size[axis];
    double &low = core.low[axis], &high = core.high[axis];
    if (!(low < high))
        v.refuse("domain.core.high", "along " + axis_text(axis) + " the core's high end is not above its low end",
                 "give domain.core.low < domain.core.high");
    const bool periodic = scene.sides[2 * axis].kind == SideScene::Kind::periodic;
    for (int end = 0; end < 2; ++end) {
        double& place = end ? high : low;
        const double side = end ? side_high : side_low, beyond = end ? side - place : place - side;
        const std::string name = end ? "domain.core.high" : "domain.core.low";
        if (beyond < -round_off)
            v.refuse(name,
                     "along " + axis_text(axis) + " the core ends outside the domain, whose side is at " + number_text(side),
                     "put the core inside the domain");
        if (beyond > round_off && periodic)
            v.refuse(name, "the axis " + axis_text(axis) + " is periodic: there cells cannot differ in width",
                     "let the core reach from side to side along it");
        if (beyond > round_off && beyond < 0.5 * spacing)
            v.refuse(name,
                     "along " + axis_text(axis) + " less than half a cell is left between the core and the side at " +
                         number_text(side),
                     "let the core end at the side, or further from it");
        if (beyond <= round_off)
            place = side;
        std::vector<double>& widths = (end ? core.above : core.below)[axis];
        widths = graded_widths(beyond > round_off ? beyond / spacing : 0.0, core.growth, largest / spacing);
    }
    const std::optional<int> count = whole_cells(high - low, spacing);
    if (!count) {
        const double fitting = std::max(1.0, std::round((high - low) / spacing));
        v.refuse("domain.core.high",
                 "along " + axis_text(axis) + " the core is " + number_text((high - low) / spacing) + " cells long",
                 "a core is a whole number of cells long, as with its end at " + number_text(low + fitting * spacing));
    }
    scene.cells[axis] = *count + static_cast<int>(core.below[axis].size() + core.above[axis].size());
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
    check_spacing(v, scene);
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
    read_follow(v, scene);
    scene.leaving = v.choice<Scene::Leaving>("domain.leaving");
}

} // namespace gapflow
