// Tables as CSV: a header line, then complete lines only, one step at a time.
#pragma once

#include <Eigen/Core>

#include <concepts>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gapflow {

/// A column of a table whose rows are objects: its name and the member that it contains.
template <class Row>
struct Column {
    const char* name;
    std::variant<double Row::*, int Row::*, long Row::*, std::string Row::*> member;
};

/// Names of columns, behind some others.
template <class Row>
std::vector<std::string> names_of(std::span<const Column<Row>> columns, std::vector<std::string> names = {})
{
    for (const Column<Row>& column : columns)
        names.emplace_back(column.name);
    return names;
}

/// An object as a row's values.
template <class Row>
struct Cells {
    std::span<const Column<Row>> columns;
    const Row& row;
};

/// Text as a cell of a CSV file: in quotes where it holds commas, quotes or line ends.
std::string csv_cell(std::string_view text);

/// A CSV file that grows by whole steps. Numbers are the shortest text that reads back the same; names with commas, quotes
/// or line ends are quoted. Errors throw ComputationError; the file then ends after the last complete step. Used on the root.
class Table {
public:
    /// Replaces the file and writes the header.
    Table(const std::filesystem::path& path, std::vector<std::string> columns);
    /// Goes on with an earlier run's file, without its rows after `last_step` (first column) and without an incomplete last
    /// line; no file: like the constructor. Throws InputError if the file has other columns.
    static Table resume(const std::filesystem::path& path, std::vector<std::string> columns, long last_step);
    ~Table();
    Table(Table&& other) noexcept;
    Table& operator=(Table&&) = delete;

    /// Adds a row; vectors fill one column per component. The values must fill the columns exactly. In memory until flush().
    template <class... T>
    void row(const T&... values)
    {
        begin_row();
        (put(values), ...);
        end_row();
    }
    /// Appends the rows since the last call to the file in one write.
    void flush();

private:
    struct Open {}; ///< tag: appends to a file that is there
    Table(Open, const std::filesystem::path& path, std::size_t columns);

    void begin_row() { filled_ = 0; }
    void end_row();
    void put(std::string_view text);
    void put(double value);
    void put(std::integral auto value) { put_raw(std::to_string(value)); }
    template <class Derived>
    void put(const Eigen::MatrixBase<Derived>& vector)
    {
        for (Eigen::Index i = 0; i < vector.size(); ++i)
            put(static_cast<double>(vector(i)));
    }
    template <class Row>
    void put(const Cells<Row>& cells)
    {
        for (const Column<Row>& column : cells.columns)
            std::visit([&](auto member) { put(cells.row.*member); }, column.member);
    }
    void put_raw(std::string_view text);

    std::filesystem::path path_;
    std::size_t columns_, filled_ = 0;
    std::string pending_;
    int descriptor_ = -1;
};

} // namespace gapflow
