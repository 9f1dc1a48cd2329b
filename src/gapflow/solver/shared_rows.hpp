// Rows of coefficients in chunks that are stored once where they are equal to a neighbour's: away from bodies and walls all
// coefficients of a uniform grid are the same, and kernels then read them from the first cache instead of from memory.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

namespace gapflow {

template <class T>
class SharedRows {
public:
    static constexpr int chunk = 64; ///< values

    SharedRows() = default;
    /// Rows of zeros, `width` values each.
    SharedRows(long rows, int width) : width_(width), chunks_((width + chunk - 1) / chunk), slot_(rows * chunks_, 0)
    {
        values_.assign(stride, T{});
    }

    int width() const { return width_; }
    int chunks() const { return chunks_; }
    long rows() const { return chunks_ > 0 ? static_cast<long>(slot_.size()) / chunks_ : 0; }

    /// A chunk's values, and the one after them (0 beyond the row).
    const T* operator()(long row, int c) const { return &values_[stride * slot(row, c)]; }
    T value(long row, int i) const { return (*this)(row, i / chunk)[i % chunk]; }
    /// Equal numbers: equal values.
    long slot(long row, int c) const { return slot_[row * chunks_ + c]; }

    /// Stores a row; chunks that equal those of the rows `like` (-1: none), or the one before in the row, share theirs.
    void set(long row, const T* values, long like_a, long like_b)
    {
        T next[chunk + 1];
        for (int c = 0; c < chunks_; ++c) {
            const int count = std::min(chunk + 1, width_ - c * chunk);
            const T* from = values + c * chunk;
            if (count <= chunk) {
                std::fill(std::copy_n(from, count, next), next + chunk + 1, T{});
                from = next;
            }
            auto equal = [&](long s) { return std::memcmp(&values_[stride * s], from, sizeof next) == 0; };
            int& to = slot_[row * chunks_ + c];
            if (like_a >= 0 && equal(slot(like_a, c)))
                to = static_cast<int>(slot(like_a, c));
            else if (c > 0 && equal(slot(row, c - 1)))
                to = static_cast<int>(slot(row, c - 1));
            else if (like_b >= 0 && equal(slot(like_b, c)))
                to = static_cast<int>(slot(like_b, c));
            else {
                to = static_cast<int>(values_.size() / stride);
                values_.insert(values_.end(), from, from + chunk + 1);
                values_.resize(static_cast<std::size_t>(to + 1) * stride);
            }
        }
    }
    void share(long row, long with) { std::copy_n(&slot_[with * chunks_], chunks_, &slot_[row * chunks_]); }
    /// Whether two rows share all their values.
    bool equal(long row, long other) const
    {
        return std::equal(&slot_[row * chunks_], &slot_[row * chunks_] + chunks_, &slot_[other * chunks_]);
    }

    /// The same sharing with other values. f(0) must be 0.
    template <class U, class F>
    SharedRows<U> mapped(F&& f) const
    {
        SharedRows<U> result;
        result.width_ = width_;
        result.chunks_ = chunks_;
        result.slot_ = slot_;
        result.values_.resize(values_.size());
        std::transform(values_.begin(), values_.end(), result.values_.begin(), f);
        return result;
    }

    T largest() const { return values_.empty() ? T{} : *std::max_element(values_.begin(), values_.end()); }

    long bytes() const { return static_cast<long>(values_.capacity() * sizeof(T) + slot_.capacity() * sizeof(int)); }

private:
    template <class U>
    friend class SharedRows;
    static constexpr long stride = chunk + 16; ///< keeps the alignment of the first

    int width_ = 0, chunks_ = 0;
    std::vector<int> slot_;
    std::vector<T> values_;
};

} // namespace gapflow
