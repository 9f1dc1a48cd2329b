// The collection file that joins a run's fields, bodies and films to one time series for ParaView.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace gapflow {

/// Number of an output time in the name of one of its files (fields_00012.vti: 12).
std::optional<int> frame_number(const std::filesystem::path& file);

/// A .pvd file. It is rewritten as a whole, under a temporary name first, so that what is on the disk is always valid.
class PvdCollection {
public:
    struct Entry {
        double time;
        std::string part, file;
    };

    /// Starts an empty collection; nothing is written yet.
    explicit PvdCollection(std::filesystem::path path);
    /// Goes on with the file that an earlier run of this program left, with its first `frames` output times only (by the
    /// numbers in the files' names); no file: empty.
    static PvdCollection resume(const std::filesystem::path& path, int frames = std::numeric_limits<int>::max());

    /// Adds a file of a time step under the name of its part ("fields", a body's or a film's name). `file`: relative to the
    /// collection's folder. Parts are numbered in the order in which they first appear.
    void add(double time, const std::string& part, const std::filesystem::path& file);
    /// Throws ComputationError. Not collective: call it on the root.
    void write() const;
    const std::vector<Entry>& entries() const { return entries_; }

private:
    std::filesystem::path path_;
    std::vector<Entry> entries_;
};

} // namespace gapflow
