#include "gapflow/core/byte_archive.hpp"

#include <gtest/gtest.h>

namespace gapflow {
namespace {

TEST(ByteArchive, ReadsWhatWasWritten)
{
    const std::vector<int> numbers{3, 1, 4}, none;
    ByteWriter writer;
    writer(2.5, numbers, none, true);
    EXPECT_EQ(writer.size(), sizeof(double) + 2 * sizeof(std::size_t) + 3 * sizeof(int) + sizeof(bool));
    const Bytes bytes = writer.take();

    double value;
    std::vector<int> read, empty{1};
    bool flag;
    ByteReader reader(bytes);
    EXPECT_FALSE(reader.at_end());
    reader(value);
    reader(read, empty, flag);
    EXPECT_TRUE(reader.at_end());
    EXPECT_EQ(value, 2.5);
    EXPECT_EQ(read, numbers);
    EXPECT_TRUE(empty.empty());
    EXPECT_TRUE(flag);
}

} // namespace
} // namespace gapflow
