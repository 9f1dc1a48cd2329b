// The one table of scene keys: validation, suggestions for misspelt keys, defaults and the reference page come from it.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace gapflow {

enum class KeyType {
    number,
    number_or_word,   ///< a number in the range or one of the choices
    vector,           ///< a number for each axis
    vectors,          ///< a list of such
    count,            ///< a whole number
    counts,           ///< a whole number for each axis
    two_counts,       ///< two whole numbers
    spin,             ///< 2D: a number, 3D: three numbers
    direction,        ///< 3D: three numbers, not all 0; not in 2D
    normal,           ///< a number for each axis, not all 0, or the letter of an axis
    rotation,         ///< 2D: degrees, 3D: { axis, degrees } or a quaternion [w, x, y, z]
    rotation_or_word, ///< the same, or one of the choices
    inertia,          ///< 2D: a number, 3D: three principal moments or a matrix of three rows
    text,
    choice,
    choices, ///< a list of some of the choices
    names,   ///< two names of bodies or walls
    flag,
    follow, ///< name of a body, or { body, axes }
    side ///< "wall", "open", "periodic", "far", "surface", { inflow = velocity or file }, { pressure = number or file }, { wall = velocity }
};

struct KeyRange {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool open_low = false, open_high = false; ///< the end itself is not allowed

    bool contains(double value) const;
};

struct KeyInfo {
    std::string
        name; ///< dotted; keys of [[body]] start with "body.", those of [[crowd]], [[pair]], [[probe]] and [[flux]] likewise
    KeyType type = KeyType::number;
    std::string unit;          ///< in SI (any consistent units do); in 2D masses and forces are per unit depth
    std::string default_value; ///< as TOML; one number for a vector stands for every axis; empty: none
    KeyRange range{};          ///< of every number in it
    std::vector<std::string> choices{};
    std::string meaning;  ///< one line
    std::string needed{}; ///< when it must be given: "always" or a condition in words; empty: never
};

/// All keys, in the order of the reference page.
std::vector<KeyInfo> scene_keys();

/// Description of the values allowed, in a scene of the given dimension (0: not yet known).
std::string allowed_values(const KeyInfo& key, int dimension);

/// Names of the keys and tables that a misspelt dotted name may have meant, nearest only; empty if nothing is near.
std::string nearest_key(const std::string& name, const std::vector<KeyInfo>& keys);

/// Whether a table stands in double brackets, as often as needed.
bool is_list_table(const std::string& table);

/// The last key of a dotted name.
std::string last_part(const std::string& dotted);

} // namespace gapflow
