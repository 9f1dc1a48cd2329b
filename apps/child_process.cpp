#include "child_process.hpp"

#include "gapflow/core/error.hpp"
#include "gapflow/output/file.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/prctl.h>
#include <unistd.h>

extern char** environ;

namespace gapflow {

namespace {

std::vector<char*> pointers(const std::vector<std::string>& words)
{
    std::vector<char*> list;
    for (const std::string& word : words)
        list.push_back(const_cast<char*>(word.c_str())); // execve changes nothing
    list.push_back(nullptr);
    return list;
}

} // namespace

std::vector<std::string> environment_variables()
{
    std::vector<std::string> variables;
    for (char** variable = environ; *variable; ++variable)
        variables.emplace_back(*variable);
    return variables;
}

void let_threads_sleep([[maybe_unused]] char** argv)
{
#ifdef _OPENMP
    const char* threads = std::getenv("OMP_NUM_THREADS");
    if (std::getenv("OMP_WAIT_POLICY") || std::getenv("GOMP_SPINCOUNT") || (threads && std::string_view(threads) == "1"))
        return;
    std::error_code failure;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failure);
    if (failure)
        return;
    ::setenv("GOMP_SPINCOUNT", "1000", 1);
    ::execv(program.c_str(), argv); // returns where it fails: then this process goes on
#endif
}

int start_program(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                  const std::filesystem::path& log)
{
    std::vector<std::string> words{"gapflow"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const std::vector<char*> argv = pointers(words), envp = pointers(environment);
    const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (out < 0)
        throw_file_error(log, "cannot open", errno);
    const pid_t parent = ::getpid(), child = ::fork();
    if (child == 0) { // only what is allowed between fork and exec
        ::setpgid(0, 0);
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);
        if (::getppid() != parent)
            ::_exit(1);
        ::dup2(out, STDOUT_FILENO);
        ::dup2(out, STDERR_FILENO);
        ::execve("/proc/self/exe", argv.data(), envp.data());
        ::_exit(127);
    }
    ::close(out);
    if (child < 0)
        throw ComputationError(std::string("cannot start a process: ") + std::strerror(errno) + "; use fewer --jobs");
    return child;
}

} // namespace gapflow
