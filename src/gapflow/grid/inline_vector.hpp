// A vector that keeps its first few elements in itself: no heap for the usual one or two.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace gapflow {

/// Grows like std::vector; elements are default-constructible and cheap to copy.
template <class T, std::size_t N>
class InlineVector {
public:
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T* begin() { return size_ <= N ? inside_.data() : outside_.data(); }
    T* end() { return begin() + size_; }
    const T* begin() const { return size_ <= N ? inside_.data() : outside_.data(); }
    const T* end() const { return begin() + size_; }
    T& operator[](std::size_t i) { return begin()[i]; }
    const T& operator[](std::size_t i) const { return begin()[i]; }
    void clear()
    {
        size_ = 0;
        outside_.clear();
    }
    void push_back(const T& value)
    {
        if (size_ < N) {
            inside_[size_++] = value;
            return;
        }
        const T copy = value;
        if (size_ == N)
            outside_.assign(inside_.begin(), inside_.end());
        outside_.push_back(copy);
        ++size_;
    }

private:
    std::array<T, N> inside_;
    std::vector<T> outside_; ///< all elements once there are more than N
    std::size_t size_ = 0;
};

} // namespace gapflow
