// Typed access to the values of one table that check_values() has passed.
#pragma once

#include "gapflow/scene/document.hpp"
#include "gapflow/scene/keys.hpp"
#include "gapflow/scene/scene.hpp"

#include <string>
#include <vector>

namespace gapflow {

class Values {
public:
    /// Keys are named relative to `prefix` of the key table ("" for the document, "body." for a body); `shown` precedes
    /// them in messages.
    Values(const Node& table, std::string prefix, std::string shown, const std::vector<KeyInfo>& keys, int dimension);

    int dimension() const { return dimension_; }
    const Node& table() const { return table_; }
    std::string shown(const std::string& name) const { return shown_ + name; }
    /// Whether the table may have a key of this name.
    bool known(const std::string& name) const;
    /// The value in the file, or null.
    const Node* given(const std::string& name) const;
    /// Given, or with a default.
    bool has(const std::string& name) const;

    // The given value or the default; one of them must be there.
    double number(const std::string& name) const;
    bool flag(const std::string& name) const;
    std::string text(const std::string& name) const;
    std::vector<std::string> texts(const std::string& name) const;
    Triple triple(const std::string& name) const; ///< a number fills the first place of a 2D spin
    /// Place of the word among the key's choices, as an enumeration with the same order.
    template <class Enum>
    Enum choice(const std::string& name) const
    {
        return static_cast<Enum>(choice_number(name));
    }

    /// Throws InputError about the value of a key that is given.
    [[noreturn]] void refuse(const std::string& name, const std::string& problem, const std::string& remedy) const;
    /// Throws InputError about a key that is not given.
    [[noreturn]] void refuse_missing(const std::string& name, const std::string& why) const;

private:
    const KeyInfo& info(const std::string& name) const;
    Node value(const std::string& name) const;
    int choice_number(const std::string& name) const;

    const Node& table_;
    std::string prefix_, shown_;
    const std::vector<KeyInfo>& keys_;
    int dimension_;
};

/// The numbers of a list in a Triple, or one number in its first place.
Triple to_triple(const Node& node);

} // namespace gapflow
