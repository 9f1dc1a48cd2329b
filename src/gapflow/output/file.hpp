// Files that are complete at any moment: the files of an interrupted run are valid.
#pragma once

#include "gapflow/core/communicator.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace gapflow {

/// Creates a folder and its parents and tries to write into it. Throws InputError with path, reason and remedy.
void prepare_folder(const std::filesystem::path& folder);

/// Throws ComputationError: path, the operation that failed, the reason of errno value `error`, and the remedy.
[[noreturn]] void throw_file_error(const std::filesystem::path& path, const std::string& action, int error);

/// Ending of a file's name until it is complete.
inline constexpr const char* partial_extension = ".partial";

/// A file written under a temporary name in its folder, which takes its own name only once it is complete and on the disk;
/// until then an older file of that name stays. Errors throw ComputationError.
class AtomicFile {
public:
    explicit AtomicFile(const std::filesystem::path& path);
    /// Removes the temporary file unless committed.
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view bytes);
    /// Flushes to the disk and renames. The last call.
    void commit();

private:
    std::filesystem::path path_, temporary_;
    int descriptor_ = -1;
};

void write_atomically(const std::filesystem::path& path, std::string_view content);

/// Runs `action` on the root; where it throws, every rank throws the same error. Collective.
void on_root(const Communicator& comm, const std::function<void()>& action);

/// Shortest decimal text that reads back as the same number ("nan", "inf" where it is none).
std::string shortest(double value);

} // namespace gapflow
