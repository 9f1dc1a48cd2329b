#include "gapflow/output/table.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/output/file.hpp"

#include <cassert>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace gapflow {

namespace {

std::string header_of(const std::vector<std::string>& columns)
{
    std::string header;
    for (const auto& column : columns)
        header += (header.empty() ? "" : ",") + column;
    return header + "\n";
}

// The step in a row's first column; a row without one is never kept.
long step_of(std::string_view row)
{
    long step = std::numeric_limits<long>::max();
    std::from_chars(row.data(), row.data() + row.size(), step);
    return step;
}

} // namespace

std::string csv_cell(std::string_view text)
{
    if (text.find_first_of(",\"\n\r") == std::string_view::npos)
        return std::string(text);
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

Table::Table(Open, const std::filesystem::path& path, std::size_t columns) : path_(path), columns_(columns)
{
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor_ < 0)
        throw_file_error(path, "cannot create the table", errno);
}

Table::Table(const std::filesystem::path& path, std::vector<std::string> columns) : Table(Open{}, path, columns.size())
{
    // Fails where the file cannot be cut (a device); the write then reports it.
    [[maybe_unused]] const int cut = ::ftruncate(descriptor_, 0);
    pending_ = header_of(columns);
    flush();
}

Table Table::resume(const std::filesystem::path& path, std::vector<std::string> columns, long last_step)
{
    std::ifstream in(path, std::ios::binary);
    if (!in)
        return Table(path, std::move(columns));
    const std::string content{std::istreambuf_iterator<char>(in), {}};
    const std::string header = header_of(columns);
    if (!content.starts_with(header))
        throw InputError(path.string() + ": has other columns than this run writes (" + header.substr(0, header.size() - 1) +
                         "); resume with the scene and version that wrote it, or into another folder (-o DIR)");
    std::string kept = header;
    for (std::size_t start = header.size(), end; (end = content.find('\n', start)) != std::string::npos; start = end + 1) {
        const std::string_view row = std::string_view(content).substr(start, end + 1 - start);
        if (step_of(row) <= last_step)
            kept += row;
    }
    write_atomically(path, kept);
    return Table(Open{}, path, columns.size());
}

Table::Table(Table&& other) noexcept
    : path_(std::move(other.path_)), columns_(other.columns_), filled_(other.filled_), pending_(std::move(other.pending_)),
      descriptor_(std::exchange(other.descriptor_, -1))
{
}

Table::~Table()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

void Table::flush()
{
    if (pending_.empty())
        return;
    const off_t complete = ::lseek(descriptor_, 0, SEEK_END);
    std::string_view left = pending_;
    while (!left.empty()) {
        const auto written = ::write(descriptor_, left.data(), left.size());
        if (written > 0) {
            left.remove_prefix(static_cast<std::size_t>(written));
        } else if (written == 0 || errno != EINTR) {
            const int error = written == 0 ? ENOSPC : errno;
            // Complete lines only: an incomplete step is removed.
            [[maybe_unused]] const int cut = ::ftruncate(descriptor_, complete);
            pending_.clear();
            throw_file_error(path_, "cannot write the table", error);
        }
    }
    pending_.clear();
}

void Table::end_row()
{
    assert(filled_ == columns_ && "a row has as many values as the table has columns");
    pending_ += '\n';
}

void Table::put(double value)
{
    put_raw(shortest(value));
}

void Table::put(std::string_view text)
{
    put_raw(csv_cell(text));
}

void Table::put_raw(std::string_view text)
{
    if (filled_++ > 0)
        pending_ += ',';
    pending_ += text;
}

} // namespace gapflow
