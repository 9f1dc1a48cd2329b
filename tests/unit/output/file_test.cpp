#include "gapflow/output/file.hpp"

#include "temporary.hpp"

#include "gapflow/core/error.hpp"

#include <gmock/gmock.h>

#include <csignal>

#include <sys/resource.h>

using namespace gapflow;
using testing::HasSubstr;

namespace {

// While it lives, files may not grow beyond some bytes: what a full disk does to a writer.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes)
    {
        getrlimit(RLIMIT_FSIZE, &before_);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit()
    {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int);
};

} // namespace

TEST(File, ReplacesAtomicallyAndLeavesNoTemporary)
{
    const test::TemporaryFolder folder;
    write_atomically(folder / "a.txt", "first");
    write_atomically(folder / "a.txt", "second");
    EXPECT_EQ(test::content_of(folder / "a.txt"), "second");
    const std::filesystem::directory_iterator files(folder.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

TEST(File, KeepsTheOldFileWhenTheNewOneIsNotFinished)
{
    const test::TemporaryFolder folder;
    write_atomically(folder / "a.txt", "first");
    {
        AtomicFile file(folder / "a.txt");
        file.write("half of the sec");
    }
    EXPECT_EQ(test::content_of(folder / "a.txt"), "first");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt.partial"));
}

TEST(File, FullDiskIsAComputationErrorAndKeepsTheOldFile)
{
    const test::TemporaryFolder folder;
    write_atomically(folder / "a.txt", "first");
    try {
        const FileSizeLimit limit(1000);
        write_atomically(folder / "a.txt", std::string(5000, 'x'));
        FAIL() << "no error";
    } catch (const ComputationError& error) {
        EXPECT_THAT(error.what(), HasSubstr("a.txt: cannot write the file: File too large"));
        EXPECT_THAT(error.what(), HasSubstr("-o DIR"));
    }
    EXPECT_EQ(test::content_of(folder / "a.txt"), "first");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt.partial"));
}

TEST(File, FolderThatCannotBeCreatedIsAnInputError)
{
    const test::TemporaryFolder folder;
    write_atomically(folder / "file", "x");
    try {
        prepare_folder(folder / "file/out");
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("file/out: cannot create the output folder: Not a directory"));
        EXPECT_THAT(error.what(), HasSubstr("choose another folder"));
    }
}

TEST(File, PreparesNestedFoldersTwice)
{
    const test::TemporaryFolder folder;
    prepare_folder(folder / "a/b/c");
    prepare_folder(folder / "a/b/c");
    EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b/c"));
    EXPECT_TRUE(std::filesystem::is_empty(folder / "a/b/c"));
}

TEST(File, MissingFolderIsAComputationError)
{
    const test::TemporaryFolder folder;
    EXPECT_THROW(write_atomically(folder / "gone/a.txt", "x"), ComputationError);
}

TEST(FileParallel, ErrorOfTheRootReachesEveryRank)
{
    const Communicator comm;
    int calls = 0;
    on_root(comm, [&] { ++calls; });
    EXPECT_EQ(calls, comm.root() ? 1 : 0);
    try {
        on_root(comm, [] { throw ComputationError("disk full"); });
        FAIL() << "no error";
    } catch (const ComputationError& error) {
        EXPECT_STREQ(error.what(), "disk full");
    }
    EXPECT_THROW(on_root(comm, [] { throw InputError("no such folder"); }), InputError);
}

TEST(File, ShortestNumbersReadBackTheSame)
{
    EXPECT_EQ(shortest(0.1), "0.1");
    EXPECT_EQ(shortest(-3.0), "-3");
    for (const double value : {1.0 / 3.0, 1e-300, 6.02214076e23, 0.1 + 0.2})
        EXPECT_EQ(std::stod(shortest(value)), value);
}
