// A TOML document as a plain tree. Only document.cpp uses the TOML library.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gapflow {

/// A value of a scene file with the place it comes from.
struct Node {
    enum class Kind { text, integer, number, flag, date, array, table };

    Kind kind = Kind::table;
    std::string key;       ///< in its table; empty in arrays
    std::string where;     ///< "scene.toml:12:5" (file, line, column) or "--set domain.cells"
    std::string key_where; ///< the same of its key
    std::string text;      ///< text and dates
    double number = 0;     ///< integers and numbers
    bool flag = false;
    std::vector<Node> items; ///< of an array; of a table, in the file's order

    bool numeric() const { return kind == Kind::integer || kind == Kind::number; }
    /// An entry of a table, or null.
    Node* find(std::string_view name);
    const Node* find(std::string_view name) const;
};

/// Throws InputError if the file cannot be read or is not TOML.
Node read_document(const std::string& file);

/// The same of a text; `file` names it in messages.
Node parse_document(std::string_view content, const std::string& file);

/// One TOML value; a text that is not valid TOML is taken literally, unless it starts like a list, a table or a quoted text
/// (then InputError). `where` goes into the node and into messages.
Node parse_value(const std::string& text, const std::string& where);

/// The value as TOML on one line, shortened for messages.
std::string value_text(const Node& node);

/// "scene.toml:12:5: domain.cells" or "--set domain.cells".
std::string place_of(const Node& node, const std::string& key);

/// Throws InputError "where: key = value: problem; remedy".
[[noreturn]] void refuse(const Node& node, const std::string& key, const std::string& problem, const std::string& remedy);

} // namespace gapflow
