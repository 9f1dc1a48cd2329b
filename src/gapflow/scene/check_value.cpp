#include "gapflow/scene/check_value.hpp"

#include "gapflow/core/text.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

using T = KeyType;

constexpr double largest = 1e30; ///< of any number: products of a few of them stay finite

/// Checks one value and composes the message about it.
struct Check {
    const Node& value; ///< of the whole key, shown in messages
    const KeyInfo& key;
    const std::string& shown;
    int dimension;

    [[noreturn]] void fail(const std::string& problem) const
    {
        refuse(value, shown, problem, "allowed: " + allowed_values(key, dimension));
    }

    void number(const Node& node) const
    {
        if (!node.numeric())
            fail(node.kind == Node::Kind::text && parse_number(node.text) ? "text where a number is meant (remove the quotes)"
                                                                          : value_text(node) + " is not a number");
        if (!std::isfinite(node.number))
            fail("not a finite number");
        if (std::abs(node.number) > largest || (node.number != 0 && std::abs(node.number) < 1 / largest))
            refuse(value, shown,
                   (&node == &value ? "" : number_text(node.number) + " is ") + std::string("too ") +
                       (std::abs(node.number) > 1 ? "large" : "small") + " to compute with",
                   "allowed: 0, or between 1e-30 and 1e30 in size; choose other units");
        if (!key.range.contains(node.number))
            fail((&node == &value ? "" : number_text(node.number) + " is ") + std::string("out of range"));
    }

    void numbers(const Node& node, int count) const
    {
        if (node.kind != Node::Kind::array)
            fail("not a list of numbers");
        if (static_cast<int>(node.items.size()) != count)
            fail("has " + std::to_string(node.items.size()) + " numbers, not " + std::to_string(count) +
                 (key.type == T::two_counts ? "" : dimension_note()));
        for (const Node& item : node.items)
            number(item);
    }

    std::string dimension_note() const { return " (domain.size makes this a " + std::to_string(dimension) + "D scene)"; }

    void word(const Node& node) const
    {
        if (node.kind != Node::Kind::text)
            fail(value_text(node) + " is not text");
        if (std::find(key.choices.begin(), key.choices.end(), node.text) != key.choices.end())
            return;
        const std::string near = nearest_name(node.text, key.choices);
        fail("unknown value \"" + node.text + "\"" + (near.empty() ? "" : ", did you mean \"" + near + "\"?"));
    }

    void text(const Node& node) const
    {
        if (node.kind != Node::Kind::text)
            fail(value_text(node) + " is not text");
        if (node.text.empty() && key.name != "title")
            fail("empty");
    }

    void count() const
    {
        number(value);
        if (value.kind != Node::Kind::integer)
            fail(number_text(value.number) + " is not a whole number");
    }

    void counts(int count) const
    {
        numbers(value, count);
        for (const Node& item : value.items)
            if (item.kind != Node::Kind::integer)
                fail(number_text(item.number) + " is not a whole number");
    }

    void vectors() const
    {
        if (value.kind != Node::Kind::array || value.items.empty())
            fail("not a list of points");
        for (const Node& item : value.items)
            numbers(item, dimension);
    }

    static double length(const Node& list)
    {
        double sum = 0;
        for (const Node& item : list.items)
            sum += item.number * item.number;
        return std::sqrt(sum);
    }

    void direction() const
    {
        if (dimension == 2)
            fail("an axis in a 2D scene");
        numbers(value, 3);
        if (length(value) == 0)
            fail("a direction of length 0");
    }

    void normal() const
    {
        if (value.kind == Node::Kind::text) {
            word(value);
            if (dimension == 2 && value.text == "z")
                fail("a 2D scene has no z axis");
            return;
        }
        numbers(value, dimension);
        if (length(value) == 0)
            fail("a direction of length 0");
    }

    void rotation() const
    {
        if (dimension == 2)
            return number(value);
        if (value.kind == Node::Kind::array) {
            numbers(value, 4);
            if (length(value) == 0)
                fail("a quaternion of length 0");
            return;
        }
        const Node* axis = value.find("axis");
        const Node* degrees = value.find("degrees");
        if (!axis || !degrees || value.items.size() != 2)
            fail("not a rotation in 3D");
        numbers(*axis, 3);
        number(*degrees);
        if (length(*axis) == 0)
            fail("an axis of length 0");
    }

    // Sylvester: all leading minors > 0.
    void positive_definite() const
    {
        const auto m = [&](int i, int j) { return value.items[i].items[j].number; };
        double largest = 0;
        for (int i = 0; i < 3; ++i)
            largest = std::max(largest, std::abs(m(i, i)));
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < i; ++j)
                if (std::abs(m(i, j) - m(j, i)) > 1e-12 * largest)
                    fail("not symmetric");
        const double two = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
        const double three = m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) -
                             m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
                             m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
        if (m(0, 0) <= 0 || two <= 0 || three <= 0)
            fail("not positive definite");
    }

    void inertia() const
    {
        const auto positive = [&](const Node& node) {
            number(node);
            if (node.number <= 0)
                fail(number_text(node.number) + " is out of range");
        };
        if (dimension == 2)
            return positive(value);
        if (value.kind == Node::Kind::array && value.items.size() == 3 && value.items[0].kind == Node::Kind::array) {
            for (const Node& row : value.items)
                numbers(row, 3);
            return positive_definite();
        }
        numbers(value, 3);
        for (const Node& item : value.items)
            positive(item);
    }

    void side() const
    {
        if (value.kind == Node::Kind::text)
            return word(value);
        if (value.kind != Node::Kind::table || value.items.size() != 1)
            fail("not a side");
        const Node& entry = value.items[0];
        if ((entry.key == "inflow" || entry.key == "pressure") && entry.kind == Node::Kind::text) {
            if (entry.text.empty())
                fail("empty file name");
        } else if (entry.key == "pressure") {
            number(entry);
        } else if (entry.key == "inflow" || entry.key == "wall") {
            numbers(entry, dimension);
        } else {
            const std::string near = nearest_name(entry.key, {"inflow", "pressure", "wall"});
            fail("unknown key '" + entry.key + "'" + (near.empty() ? "" : ", did you mean '" + near + "'?"));
        }
    }

    void follow() const
    {
        if (value.kind == Node::Kind::text)
            return text(value);
        if (value.kind != Node::Kind::table)
            fail("neither a name nor a table");
        for (const Node& entry : value.items) {
            if (entry.key == "body") {
                text(entry);
            } else if (entry.key == "axes") {
                const auto is_axis = [&](const Node& axis) {
                    return axis.kind == Node::Kind::text && axis.text.size() == 1 &&
                           std::string("xyz").substr(0, static_cast<std::size_t>(dimension)).find(axis.text) !=
                               std::string::npos;
                };
                if (entry.kind != Node::Kind::array || entry.items.empty() ||
                    !std::all_of(entry.items.begin(), entry.items.end(), is_axis))
                    fail("axes are no list of axes");
            } else {
                fail("unknown key '" + entry.key + "'");
            }
        }
        if (!value.find("body"))
            fail("no body");
    }

    void names() const
    {
        if (value.kind != Node::Kind::array || value.items.size() != 2)
            fail("not two names");
        for (const Node& item : value.items)
            text(item);
        if (value.items[0].text == value.items[1].text)
            fail("the same name twice");
    }

    void all() const
    {
        switch (key.type) {
        case T::number:
            return number(value);
        case T::number_or_word:
            return value.numeric() ? number(value) : word(value);
        case T::vector:
            return numbers(value, dimension);
        case T::count:
            return count();
        case T::vectors:
            return vectors();
        case T::counts:
            return counts(dimension);
        case T::two_counts:
            return counts(2);
        case T::spin:
            return dimension == 2 ? number(value) : numbers(value, 3);
        case T::direction:
            return direction();
        case T::normal:
            return normal();
        case T::rotation:
            return rotation();
        case T::rotation_or_word:
            return value.kind == Node::Kind::text ? word(value) : rotation();
        case T::inertia:
            return inertia();
        case T::text:
            return text(value);
        case T::choice:
            return word(value);
        case T::choices:
            if (value.kind != Node::Kind::array)
                fail("not a list");
            for (const Node& item : value.items)
                word(item);
            return;
        case T::names:
            return names();
        case T::flag:
            if (value.kind != Node::Kind::flag)
                fail("neither true nor false");
            return;
        case T::follow:
            return follow();
        case T::side:
            return side();
        }
    }
};

} // namespace

void check_value(const Node& value, const KeyInfo& key, const std::string& shown, int dimension)
{
    Check{value, key, shown, dimension}.all();
}

} // namespace gapflow
