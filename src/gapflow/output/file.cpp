#include "gapflow/output/file.hpp"

#include "gapflow/core/error.hpp"

#include <cerrno>
#include <charconv>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace gapflow {

namespace {

std::string describe(const std::filesystem::path& path, const std::string& action, int error)
{
    std::string remedy = "check the output folder or choose another one (-o DIR)";
    if (error == ENOSPC || error == EDQUOT || error == EFBIG)
        remedy = "free space on that disk (or raise its limits) or choose another folder (-o DIR)";
    else if (error == EACCES || error == EPERM || error == EROFS)
        remedy = "allow writing there or choose another folder (-o DIR)";
    else if (error == ENOTDIR || error == EEXIST)
        remedy = "a file stands where a folder is needed: move it away or choose another folder (-o DIR)";
    return path.string() + ": " + action + ": " + std::generic_category().message(error) + "; " + remedy;
}

} // namespace

void throw_file_error(const std::filesystem::path& path, const std::string& action, int error)
{
    throw ComputationError(describe(path, action, error));
}

void prepare_folder(const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw InputError(describe(folder, "cannot create the output folder", error.value()));
    const auto probe = folder / ".gapflow-write-test";
    const int descriptor = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0)
        throw InputError(describe(folder, "cannot write into the output folder", errno));
    ::close(descriptor);
    ::unlink(probe.c_str());
}

AtomicFile::AtomicFile(const std::filesystem::path& path) : path_(path), temporary_(path.string() + partial_extension)
{
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0)
        throw_file_error(path_, "cannot create the file", errno);
}

AtomicFile::~AtomicFile()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
    if (!temporary_.empty())
        ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view bytes)
{
    while (!bytes.empty()) {
        const auto written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written > 0)
            bytes.remove_prefix(static_cast<std::size_t>(written));
        else if (written == 0 || errno != EINTR)
            throw_file_error(path_, "cannot write the file", written == 0 ? ENOSPC : errno);
    }
}

void AtomicFile::commit()
{
    if (::fsync(descriptor_) != 0)
        throw_file_error(path_, "cannot write the file to the disk", errno);
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0)
        throw_file_error(path_, "cannot write the file to the disk", errno);
    if (::rename(temporary_.c_str(), path_.c_str()) != 0)
        throw_file_error(path_, "cannot give the file its name", errno);
    temporary_.clear();
}

void write_atomically(const std::filesystem::path& path, std::string_view content)
{
    AtomicFile file(path);
    file.write(content);
    file.commit();
}

void on_root(const Communicator& comm, const std::function<void()>& action)
{
    enum : int { fine, input, computation };
    int outcome = fine;
    std::string message;
    if (comm.root()) {
        try {
            action();
        } catch (const InputError& error) {
            outcome = input;
            message = error.what();
        } catch (const std::exception& error) {
            outcome = computation;
            message = error.what();
        }
    }
    if (comm.size() > 1) {
        int header[2] = {outcome, static_cast<int>(message.size())};
        MPI_Bcast(header, 2, MPI_INT, 0, comm.mpi());
        outcome = header[0];
        if (outcome != fine) {
            message.resize(static_cast<std::size_t>(header[1]));
            MPI_Bcast(message.data(), header[1], MPI_CHAR, 0, comm.mpi());
        }
    }
    if (outcome == input)
        throw InputError(message);
    if (outcome == computation)
        throw ComputationError(message);
}

std::string shortest(double value)
{
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

} // namespace gapflow
