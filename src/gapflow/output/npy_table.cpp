#include "gapflow/output/npy_table.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/output/file.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gapflow {

namespace {

constexpr std::string_view magic{"\x93NUMPY\x01\x00", 8};
constexpr std::size_t count_width = 20; // characters of the header for the number of rows
constexpr char order = std::endian::native == std::endian::little ? '<' : '>';

std::size_t bytes_of(const NpyColumn& column)
{
    return column.type == NpyColumn::Type::text ? 4 * column.width : 8;
}

long row_bytes(const std::vector<NpyColumn>& columns)
{
    std::size_t sum = 0;
    for (const NpyColumn& column : columns)
        sum += bytes_of(column);
    return static_cast<long>(sum);
}

// A Python literal, as long whatever the number of rows is.
std::string header_of(const std::vector<NpyColumn>& columns, long rows)
{
    std::string text = "{'descr': [";
    for (const NpyColumn& column : columns) {
        text += "('" + column.name + "', '" + order;
        text += column.type == NpyColumn::Type::integer ? "i8" : column.type == NpyColumn::Type::real ? "f8" : "U";
        text += (column.type == NpyColumn::Type::text ? std::to_string(column.width) : "") + "'), ";
    }
    text += "], 'fortran_order': False, 'shape': (";
    std::string count = std::to_string(rows);
    text += count + ",), }" + std::string(count_width - count.size(), ' ');
    const std::size_t whole = (magic.size() + 2 + text.size() + 1 + 63) / 64 * 64;
    text.append(whole - magic.size() - 2 - text.size() - 1, ' ');
    text += '\n';
    const auto length = static_cast<unsigned>(text.size());
    return std::string(magic) + static_cast<char>(length & 255) + static_cast<char>(length >> 8) + text;
}

// One character of a UTF-8 text, which becomes what follows; U+FFFD for bytes that are none.
char32_t next_character(std::string_view& text)
{
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t more = first < 0x80 ? 0 : first >= 0xf0 && first < 0xf8 ? 3 : first >= 0xe0 ? 2 : 1;
    char32_t character = more == 0 ? first : first & (0x3fU >> more);
    text.remove_prefix(1);
    if (more > 0 && (first < 0xc0 || first >= 0xf8 || text.size() < more))
        return 0xfffd;
    for (std::size_t i = 0; i < more; ++i)
        character = (character << 6) | (static_cast<unsigned char>(text[i]) & 0x3f);
    text.remove_prefix(more);
    return character;
}

void append_utf8(char32_t c, std::string& text)
{
    if (c < 0x80) {
        text += static_cast<char>(c);
        return;
    }
    const int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
    constexpr unsigned lead[] = {0, 0xc0, 0xe0, 0xf0};
    text += static_cast<char>(lead[more] | (c >> (6 * more)));
    for (int i = more - 1; i >= 0; --i)
        text += static_cast<char>(0x80 | ((c >> (6 * i)) & 0x3f));
}

[[noreturn]] void refuse_file(const std::filesystem::path& path)
{
    throw InputError(path.string() + ": not a table that a run wrote; remove it, or take the folder of a run");
}

struct Header {
    std::vector<NpyColumn> columns;
    long rows = 0, bytes = 0;
};

// Reads what header_of() writes.
Header read_header(const std::filesystem::path& path, std::istream& in)
{
    std::string start(magic.size() + 2, '\0');
    in.read(start.data(), static_cast<long>(start.size()));
    if (!in || !start.starts_with(magic))
        refuse_file(path);
    const auto length = static_cast<unsigned char>(start[8]) + 256L * static_cast<unsigned char>(start[9]);
    std::string text(static_cast<std::size_t>(length), '\0');
    in.read(text.data(), length);
    const auto shape = text.find("'shape': (");
    if (!in || shape == text.npos)
        refuse_file(path);
    Header header;
    header.bytes = static_cast<long>(start.size()) + length;
    const char* digits = text.data() + shape + 10;
    if (std::from_chars(digits, text.data() + text.size(), header.rows).ec != std::errc() || header.rows < 0)
        refuse_file(path);
    std::string_view list = std::string_view(text).substr(0, shape);
    for (auto at = list.find("('"); at != list.npos; at = list.find("('")) {
        list.remove_prefix(at + 2);
        const auto quote = list.find('\'');
        const auto type = list.find(order, quote);
        if (quote == list.npos || type == list.npos || type + 2 >= list.size())
            refuse_file(path);
        NpyColumn column{std::string(list.substr(0, quote)), NpyColumn::Type::real, 0};
        const std::string_view code = list.substr(type + 1);
        if (code.starts_with("i8")) {
            column.type = NpyColumn::Type::integer;
        } else if (code.starts_with("U")) {
            column.type = NpyColumn::Type::text;
            std::from_chars(code.data() + 1, code.data() + code.size(), column.width);
        } else if (!code.starts_with("f8")) {
            refuse_file(path);
        }
        header.columns.push_back(std::move(column));
    }
    if (header.columns.empty() || header_of(header.columns, header.rows) != start + text)
        refuse_file(path);
    return header;
}

} // namespace

std::size_t count_characters(std::string_view text)
{
    std::size_t count = 0;
    for (; !text.empty(); ++count)
        next_character(text);
    return count;
}

NpyTable::NpyTable(Open, const std::filesystem::path& path, std::vector<NpyColumn> columns)
    : path_(path), columns_(std::move(columns)), header_(header_of(columns_, 0))
{
    descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0)
        throw_file_error(path, "cannot create the table", errno);
}

NpyTable::NpyTable(const std::filesystem::path& path, std::vector<NpyColumn> columns)
    : NpyTable(Open{}, path, std::move(columns))
{
    // Fails where the file cannot be cut (a device); the write then reports it.
    [[maybe_unused]] const int cut = ::ftruncate(descriptor_, 0);
    write_at(0, header_);
}

NpyTable NpyTable::resume(const std::filesystem::path& path, std::vector<NpyColumn> columns, long last_step)
{
    std::ifstream in(path, std::ios::binary);
    if (!in)
        return NpyTable(path, std::move(columns));
    const Header header = read_header(path, in);
    const auto same = [](const NpyColumn& a, const NpyColumn& b) {
        return a.name == b.name && a.type == b.type && a.width == b.width;
    };
    if (!std::equal(columns.begin(), columns.end(), header.columns.begin(), header.columns.end(), same))
        throw InputError(path.string() +
                         ": has other columns than this run writes; resume with the scene and version that wrote it, or "
                         "into another folder (-o DIR)");
    const long width = row_bytes(columns);
    in.seekg(0, std::ios::end);
    const long whole = std::min(header.rows, (static_cast<long>(in.tellg()) - header.bytes) / width);
    const auto step_of = [&](long row) {
        std::int64_t step = 0;
        in.seekg(header.bytes + row * width);
        in.read(reinterpret_cast<char*>(&step), sizeof step);
        return step;
    };
    long kept = 0, end = whole; // steps increase from row to row
    while (kept < end) {
        const long middle = kept + (end - kept) / 2;
        if (step_of(middle) <= last_step)
            kept = middle + 1;
        else
            end = middle;
    }
    in.close();
    NpyTable table(Open{}, path, std::move(columns));
    table.rows_ = kept;
    table.write_at(0, header_of(table.columns_, kept));
    if (::ftruncate(table.descriptor_, header.bytes + kept * width) != 0)
        throw_file_error(path, "cannot cut the table", errno);
    return table;
}

NpyTable::NpyTable(NpyTable&& other) noexcept
    : path_(std::move(other.path_)), columns_(std::move(other.columns_)), header_(std::move(other.header_)),
      filled_(other.filled_), rows_(other.rows_), pending_rows_(other.pending_rows_), pending_(std::move(other.pending_)),
      descriptor_(std::exchange(other.descriptor_, -1))
{
}

NpyTable::~NpyTable()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

void NpyTable::write_at(long place, std::string_view bytes)
{
    while (!bytes.empty()) {
        const auto written = ::pwrite(descriptor_, bytes.data(), bytes.size(), place);
        if (written > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
            place += written;
        } else if (written == 0 || errno != EINTR) {
            const int error = written == 0 ? ENOSPC : errno;
            pending_.clear();
            pending_rows_ = 0;
            // Behind the rows that the header counts nothing stays.
            [[maybe_unused]] const int cut =
                ::ftruncate(descriptor_, static_cast<long>(header_.size()) + rows_ * row_bytes(columns_));
            throw_file_error(path_, "cannot write the table", error);
        }
    }
}

void NpyTable::flush()
{
    if (pending_rows_ == 0)
        return;
    write_at(static_cast<long>(header_.size()) + rows_ * row_bytes(columns_), pending_);
    write_at(0, header_of(columns_, rows_ + pending_rows_));
    rows_ += pending_rows_;
    pending_rows_ = 0;
    pending_.clear();
}

void NpyTable::end_row()
{
    assert(filled_ == columns_.size() && "a row has as many values as the table has columns");
    ++pending_rows_;
}

void NpyTable::put_bytes([[maybe_unused]] NpyColumn::Type type, const void* value)
{
    assert(columns_[filled_].type == type);
    ++filled_;
    pending_.append(static_cast<const char*>(value), 8);
}

void NpyTable::put(std::string_view text)
{
    assert(columns_[filled_].type == NpyColumn::Type::text);
    const std::size_t width = columns_[filled_++].width;
    for (std::size_t i = 0; i < width; ++i) {
        const char32_t character = text.empty() ? 0 : next_character(text);
        pending_.append(reinterpret_cast<const char*>(&character), 4);
    }
    assert(text.empty() && "a text fits its column");
}

RunTable read_npy(const std::filesystem::path& path)
{
    RunTable table;
    std::ifstream in(path, std::ios::binary);
    if (!in)
        return table;
    const Header header = read_header(path, in);
    std::vector<std::vector<double>*> numbers;
    std::vector<std::vector<std::string>*> texts;
    for (const NpyColumn& column : header.columns) {
        const bool text = column.type == NpyColumn::Type::text;
        numbers.push_back(text ? nullptr : &table.numbers[column.name]);
        texts.push_back(text ? &table.texts[column.name] : nullptr);
    }
    std::string row(static_cast<std::size_t>(row_bytes(header.columns)), '\0');
    for (long number = 0; number < header.rows; ++number) {
        in.read(row.data(), static_cast<long>(row.size()));
        if (!in)
            throw InputError(path.string() + ": ends after " + std::to_string(number) + " of " + std::to_string(header.rows) +
                             " rows; it was cut off: copy it again");
        const char* at = row.data();
        for (std::size_t c = 0; c < header.columns.size(); ++c) {
            const NpyColumn& column = header.columns[c];
            if (column.type == NpyColumn::Type::text) {
                std::string text;
                for (std::size_t i = 0; i < column.width; ++i) {
                    char32_t character = 0;
                    std::memcpy(&character, at + 4 * i, 4);
                    if (character != 0)
                        append_utf8(character, text);
                }
                texts[c]->push_back(std::move(text));
            } else if (column.type == NpyColumn::Type::real) {
                double value = 0;
                std::memcpy(&value, at, 8);
                numbers[c]->push_back(value);
            } else {
                std::int64_t value = 0;
                std::memcpy(&value, at, 8);
                numbers[c]->push_back(static_cast<double>(value));
            }
            at += bytes_of(column);
        }
        ++table.rows;
    }
    return table;
}

} // namespace gapflow
