// Threads inside a rank (OpenMP, optional). Loops are cut into parts that depend on the number of threads only where every
// value is computed by itself; sums go over parts of fixed size, in the same order for any number of threads.
#pragma once

#ifdef _OPENMP
#include <omp.h>
#endif

#include <algorithm>
#include <exception>
#include <vector>

namespace gapflow {

/// Threads that a loop runs on: OMP_NUM_THREADS, else all cores that the process was given; 1 without OpenMP.
inline int thread_count()
{
#ifdef _OPENMP
    return omp_get_max_threads();
#else
    return 1;
#endif
}

/// Calls f(begin, end) for parts that make up 0 <= i < n, one for each thread, on at most `threads`.
template <class F>
void for_each_part_of(int threads, long n, F&& f)
{
    threads = static_cast<int>(std::min<long>(threads, n));
    if (threads <= 1) {
        if (n > 0)
            f(0L, n);
        return;
    }
#ifdef _OPENMP
#pragma omp parallel num_threads(threads)
    {
        const long count = omp_get_num_threads(), mine = omp_get_thread_num();
        f(n * mine / count, n * (mine + 1) / count);
    }
#endif
}

/// The same on all threads.
template <class F>
void for_each_part(long n, F&& f)
{
    for_each_part_of(thread_count(), n, f);
}

/// Calls f(0) .. f(n - 1), in any order, on all threads: pieces of work of different size.
template <class F>
void for_each_job(int n, F&& f)
{
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic) if (n > 1)
#endif
    for (int i = 0; i < n; ++i)
        f(i);
}

/// The results of f(begin, end) for chunks of this size that make up 0 <= i < n, in their order: the same for any number of threads.
template <class F>
auto each_chunk(long n, long size, F&& f)
{
    std::vector<decltype(f(0L, 0L))> results((n + size - 1) / size);
    for_each_job(static_cast<int>(results.size()), [&](int k) { results[k] = f(k * size, std::min(n, (k + 1) * size)); });
    return results;
}

/// What f(i, items) adds to `items` for all 0 <= i < n, in the order of i.
template <class T, class F>
std::vector<T> items_of(long n, F&& f)
{
    constexpr long size = 256; // of a thread's piece of work
    std::vector<T> all;
    for (const std::vector<T>&items : each_chunk(n, size, [&](long begin, long end) {
             std::vector<T> items;
             for (long i = begin; i < end; ++i)
                 f(i, items);
             return items;
         }))
        all.insert(all.end(), items.begin(), items.end());
    return all;
}

/// Calls f(k) for low <= k < high.
template <class F>
void for_each_plane(int low, int high, F&& f)
{
    for_each_part(high - low, [&](long begin, long end) {
        for (long k = begin; k < end; ++k)
            f(low + static_cast<int>(k));
    });
}

/// Calls f, on this thread, and g, beside it where there is more than one.
template <class F, class G>
void call_both(F&& f, G&& g)
{
    if (thread_count() <= 1) {
        f();
        g();
        return;
    }
#ifdef _OPENMP
    std::exception_ptr failures[2];
    auto keep = [](auto& call, std::exception_ptr& failure) {
        try {
            call();
        } catch (...) {
            failure = std::current_exception();
        }
    };
#pragma omp parallel num_threads(2)
    {
        if (omp_get_thread_num() == 0)
            keep(f, failures[0]);
        if (omp_get_thread_num() == omp_get_num_threads() - 1)
            keep(g, failures[1]);
    }
    for (const std::exception_ptr& failure : failures)
        if (failure)
            std::rethrow_exception(failure);
#endif
}

/// f(k) for low <= k < high, one after the other.
template <class F>
auto each_plane(int low, int high, F&& f)
{
    std::vector<decltype(f(low))> results(std::max(high - low, 0));
    for_each_plane(low, high, [&](int k) { results[k - low] = f(k); });
    return results;
}

/// Sum of f(k) over low <= k < high, added in the order of k.
template <class F>
double sum_over_planes(int low, int high, F&& f)
{
    double sum = 0;
    for (double part : each_plane(low, high, f))
        sum += part;
    return sum;
}

/// Largest f(k) >= 0 over low <= k < high.
template <class F>
double max_over_planes(int low, int high, F&& f)
{
    double largest = 0;
    for (double part : each_plane(low, high, f))
        largest = std::max(largest, part);
    return largest;
}

} // namespace gapflow
