// Tables as NumPy's .npy files (format 1.0): one structured array, readable by numpy.load.
#pragma once

#include "gapflow/output/stored_run.hpp"

#include <Eigen/Core>

#include <concepts>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gapflow {

/// A column of a binary table.
struct NpyColumn {
    enum class Type { integer, real, text }; ///< 8 bytes, 8 bytes, `width` characters of 4 bytes (UTF-32)
    std::string name;
    Type type = Type::real;
    std::size_t width = 0;
};

/// A .npy file that grows by whole steps. Its header, of fixed length, holds the number of rows and is written after them: a file of a run
/// that was killed has all complete steps and nothing else that counts. Errors throw ComputationError; the file then ends after the last
/// complete step. Used on the root.
class NpyTable {
public:
    /// Replaces the file by one without rows.
    NpyTable(const std::filesystem::path& path, std::vector<NpyColumn> columns);
    /// Goes on with an earlier run's file, without its rows after `last_step` (first column); no file: like the constructor. Throws
    /// InputError if the file is none of these or has other columns.
    static NpyTable resume(const std::filesystem::path& path, std::vector<NpyColumn> columns, long last_step);
    ~NpyTable();
    NpyTable(NpyTable&& other) noexcept;
    NpyTable& operator=(NpyTable&&) = delete;

    /// Adds a row; vectors fill one column per component. The values must fill the columns exactly, each with its type; text is UTF-8 and
    /// fills its width at most. In memory until flush().
    template <class... T>
    void row(const T&... values)
    {
        begin_row();
        (put(values), ...);
        end_row();
    }
    /// Appends the rows since the last call to the file.
    void flush();

private:
    struct Open {}; ///< tag: a file that is there
    NpyTable(Open, const std::filesystem::path& path, std::vector<NpyColumn> columns);

    void begin_row() { filled_ = 0; }
    void end_row();
    void put(std::string_view text);
    void put(double value) { put_bytes(NpyColumn::Type::real, &value); }
    void put(std::integral auto value)
    {
        const auto number = static_cast<std::int64_t>(value);
        put_bytes(NpyColumn::Type::integer, &number);
    }
    template <class Derived>
    void put(const Eigen::MatrixBase<Derived>& vector)
    {
        for (Eigen::Index i = 0; i < vector.size(); ++i)
            put(static_cast<double>(vector(i)));
    }
    void put_bytes(NpyColumn::Type type, const void* value);
    void write_at(long place, std::string_view bytes);

    std::filesystem::path path_;
    std::vector<NpyColumn> columns_;
    std::string header_; ///< of a table without rows
    std::size_t filled_ = 0;
    long rows_ = 0, pending_rows_ = 0;
    std::string pending_;
    int descriptor_ = -1;
};

/// Characters of a UTF-8 text.
std::size_t count_characters(std::string_view text);

/// A file that NpyTable wrote; without rows if there is none. Throws InputError for other files.
RunTable read_npy(const std::filesystem::path& path);

} // namespace gapflow
