// State of a simulation as named arrays: an object lists its members once, in list_state(archive, ...),
// and the list serves to store and to restore them.
//
//     void list_state(StateArchive& archive) { archive("time", time_); archive("pull", pull_); }
//
// Names are paths. Arrays are streams: every call under the same name appends to it or takes the next values of it.
#pragma once

#include "gapflow/core/error.hpp"

#include <Eigen/Core>

#include <concepts>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace gapflow {

/// A state that does not fit the objects to be restored from it: of another scene or version.
class StateError : public InputError {
public:
    using InputError::InputError;
};

struct StoredState {
    std::map<std::string, std::vector<double>> numbers;        ///< the same on every rank
    std::map<std::string, std::vector<std::int64_t>> integers; ///< the same on every rank
    std::map<std::string, std::vector<double>> fields;         ///< of the whole grid; on the root only
};

class StateArchive {
public:
    /// Stores into `state`.
    explicit StateArchive(StoredState& state) : into_(&state) {}
    /// Restores from `state`. The calls throw StateError, the same on every rank, where a requested array is missing or too short.
    explicit StateArchive(const StoredState& state) : from_(&state) {}

    bool restoring() const { return from_ != nullptr; }

    void operator()(const std::string& name, double& value) { numbers(name, std::span(&value, 1)); }
    void operator()(const std::string& name, std::integral auto& value)
    {
        std::int64_t number = static_cast<std::int64_t>(value);
        integer(name, number);
        value = static_cast<std::remove_reference_t<decltype(value)>>(number);
    }
    /// Fixed size, or a vector of any.
    template <int Rows, int Columns>
    void operator()(const std::string& name, Eigen::Matrix<double, Rows, Columns>& value)
    {
        if constexpr (Rows == Eigen::Dynamic)
            value.resize(size(name, value.size()));
        numbers(name, std::span(value.data(), static_cast<std::size_t>(value.size())));
    }
    void operator()(const std::string& name, std::vector<double>& values)
    {
        values.resize(size(name, static_cast<long>(values.size())));
        numbers(name, values);
    }
    template <std::integral T>
    void operator()(const std::string& name, std::vector<T>& values)
    {
        values.resize(size(name, static_cast<long>(values.size())));
        for (T& value : values)
            (*this)(name, value);
    }
    template <int Rows>
    void operator()(const std::string& name, std::vector<Eigen::Matrix<double, Rows, 1>>& values)
    {
        static_assert(Rows > 0 && sizeof(values[0]) == Rows * sizeof(double));
        values.resize(size(name, static_cast<long>(values.size())));
        if (!values.empty())
            numbers(name, std::span(values.front().data(), Rows * values.size()));
    }
    /// Any number of objects: list(archive, object) lists one, under names that begin with `name`/.
    template <class T, class List>
    void each(const std::string& name, std::vector<T>& objects, List&& list)
    {
        objects.resize(size(name, static_cast<long>(objects.size())));
        group(name, [&] {
            for (T& object : objects)
                list(*this, object);
        });
    }
    /// Calls list(); names in it begin with `name`/.
    template <class List>
    void group(const std::string& name, List&& list)
    {
        const std::string outer = prefix_;
        prefix_ += name + "/";
        list();
        prefix_ = outer;
    }
    /// The same, of a part that the state need not have: it is stored if `present`, and restored if it was stored.
    template <class List>
    void optional(const std::string& name, bool present, List&& list)
    {
        if (from_ ? holds(prefix_ + name + "/") : present)
            group(name, list);
    }
    /// A property that is not state but must have the value that it had when the state was stored, to round-off.
    void expect(const std::string& name, double value);

    /// Storing: the array to fill, on the root. See list_field() in grid/.
    std::vector<double>& field(const std::string& name) { return into_->fields[prefix_ + name]; }
    /// Restoring: the array; empty if there is none (and always but on the root).
    const std::vector<double>& stored_field(const std::string& name);

    /// Restoring: throws StateError if the state contains values that were not requested.
    void finish() const;

private:
    void numbers(const std::string& name, std::span<double> values);
    void integer(const std::string& name, std::int64_t& value);
    long size(const std::string& name, long size);
    bool holds(const std::string& prefix) const;

    StoredState* into_ = nullptr;
    const StoredState* from_ = nullptr;
    std::string prefix_;
    std::map<std::string, std::size_t> taken_; ///< values that were taken of every array
};

} // namespace gapflow
