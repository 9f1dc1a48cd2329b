// Values as bytes, to be sent to other ranks of the same program.
#pragma once

#include "gapflow/core/large_memory.hpp"

#include <cstddef>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace gapflow {

using Bytes = LargeVector<std::byte>;

/// Appends values: vectors with their length, everything else as it lies in memory (it must not own any).
class ByteWriter {
public:
    template <class... T>
    void operator()(const T&... values)
    {
        (write(values), ...);
    }
    std::size_t size() const { return bytes_.size(); }
    Bytes take() { return std::move(bytes_); }

private:
    template <class T>
    void write(const T& value)
    {
        append(&value, sizeof(T));
    }
    template <class T>
    void write(const std::vector<T>& values)
    {
        write(values.size());
        append(values.data(), values.size() * sizeof(T));
    }
    void append(const void* from, std::size_t size)
    {
        const auto* bytes = static_cast<const std::byte*>(from);
        bytes_.insert(bytes_.end(), bytes, bytes + size);
    }

    Bytes bytes_;
};

/// Reads the same values in the same order. The bytes must last.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

    template <class... T>
    void operator()(T&... values)
    {
        (read(values), ...);
    }
    bool at_end() const { return rest_.empty(); }

private:
    template <class T>
    void read(T& value)
    {
        take(&value, sizeof(T));
    }
    template <class T>
    void read(std::vector<T>& values)
    {
        std::size_t size;
        read(size);
        values.resize(size);
        take(values.data(), size * sizeof(T));
    }
    void take(void* to, std::size_t size)
    {
        if (size > 0)
            std::memcpy(to, rest_.data(), size);
        rest_ = rest_.subspan(size);
    }

    std::span<const std::byte> rest_;
};

} // namespace gapflow
