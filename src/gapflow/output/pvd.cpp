#include "gapflow/output/pvd.hpp"

#include "gapflow/output/file.hpp"
#include "gapflow/output/xml.hpp"

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <map>

namespace gapflow {

PvdCollection::PvdCollection(std::filesystem::path path) : path_(std::move(path)) {}

std::optional<int> frame_number(const std::filesystem::path& file)
{
    const std::string name = file.stem().string();
    const auto underscore = name.rfind('_');
    if (underscore == std::string::npos)
        return {};
    int number = 0;
    const char *first = name.data() + underscore + 1, *last = name.data() + name.size();
    const auto [end, error] = std::from_chars(first, last, number);
    return error == std::errc() && end == last ? std::optional(number) : std::nullopt;
}

PvdCollection PvdCollection::resume(const std::filesystem::path& path, int frames)
{
    PvdCollection collection(path);
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
        const std::string when = attribute(line, "timestep"), file = attribute(line, "file");
        if (!when.empty() && !file.empty() && frame_number(file).value_or(0) < frames)
            collection.add(std::strtod(when.c_str(), nullptr), attribute(line, "name"), file);
    }
    return collection;
}

void PvdCollection::add(double time, const std::string& part, const std::filesystem::path& file)
{
    entries_.push_back({time, part, file.generic_string()});
}

void PvdCollection::write() const
{
    std::map<std::string, std::size_t> numbers;
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
                       "<Collection>\n";
    for (const auto& entry : entries_) {
        const auto number = numbers.try_emplace(entry.part, numbers.size()).first->second;
        text += "<DataSet timestep=\"" + shortest(entry.time) + "\" group=\"\" part=\"" + std::to_string(number) +
                "\" name=\"" + escaped(entry.part) + "\" file=\"" + escaped(entry.file) + "\"/>\n";
    }
    text += "</Collection>\n</VTKFile>\n";
    write_atomically(path_, text);
}

} // namespace gapflow
