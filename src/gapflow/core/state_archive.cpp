#include "gapflow/core/state_archive.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr double round_off = 1e-10;

// The next `count` values of an array that a state must hold.
template <class T>
const T* next(const std::map<std::string, std::vector<T>>& arrays, const std::string& name, std::size_t count,
              std::map<std::string, std::size_t>& taken)
{
    const auto array = arrays.find(name);
    if (array == arrays.end())
        throw StateError("it holds no '" + name + "'");
    std::size_t& position = taken[name];
    if (array->second.size() - position < count)
        throw StateError("it holds too few values of '" + name + "'");
    position += count;
    return array->second.data() + position - count;
}

} // namespace

void StateArchive::numbers(const std::string& name, std::span<double> values)
{
    const std::string path = prefix_ + name;
    if (from_) {
        std::copy_n(next(from_->numbers, path, values.size(), taken_), values.size(), values.begin());
    } else {
        std::vector<double>& array = into_->numbers[path];
        array.insert(array.end(), values.begin(), values.end());
    }
}

void StateArchive::integer(const std::string& name, std::int64_t& value)
{
    if (from_)
        value = *next(from_->integers, prefix_ + name, 1, taken_);
    else
        into_->integers[prefix_ + name].push_back(value);
}

long StateArchive::size(const std::string& name, long size)
{
    std::int64_t number = size;
    integer(name + ".size", number);
    constexpr std::int64_t largest = std::int64_t{1} << 40;
    if (number < 0 || number > largest)
        throw StateError("'" + name + "' has an impossible size");
    return static_cast<long>(number);
}

bool StateArchive::holds(const std::string& prefix) const
{
    const auto any = [&](const auto& arrays) {
        const auto first = arrays.lower_bound(prefix);
        return first != arrays.end() && first->first.starts_with(prefix);
    };
    return any(from_->numbers) || any(from_->integers);
}

void StateArchive::expect(const std::string& name, double value)
{
    double stored = value;
    numbers(name, std::span(&stored, 1));
    if (!(std::abs(stored - value) <= round_off * std::max(std::abs(stored), std::abs(value))))
        throw StateError("'" + prefix_ + name + "' was " + std::to_string(stored) + " and is now " + std::to_string(value));
}

const std::vector<double>& StateArchive::stored_field(const std::string& name)
{
    static const std::vector<double> none;
    const auto array = from_->fields.find(prefix_ + name);
    if (array == from_->fields.end())
        return none;
    taken_[prefix_ + name] = array->second.size();
    return array->second;
}

void StateArchive::finish() const
{
    if (!from_)
        return;
    const auto check = [&](const auto& arrays) {
        for (const auto& [name, array] : arrays) {
            const auto taken = taken_.find(name);
            if ((taken == taken_.end() ? 0 : taken->second) != array.size())
                throw StateError("it holds values of '" + name + "' that nothing asks for");
        }
    };
    check(from_->numbers);
    check(from_->integers);
}

} // namespace gapflow
