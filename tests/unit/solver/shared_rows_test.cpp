#include "gapflow/solver/shared_rows.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace gapflow {
namespace {

TEST(SharedRows, HoldsWhatItIsGiven)
{
    for (int width : {1, 63, 64, 65, 128, 200}) {
        SharedRows<float> rows(3, width);
        std::vector<float> values(width);
        std::iota(values.begin(), values.end(), 1.0f);
        rows.set(1, values.data(), 0, -1);
        values.back() = 0.5f;
        rows.set(2, values.data(), 1, 0);
        for (int i = 0; i < width; ++i) {
            EXPECT_EQ(rows.value(0, i), 0);
            EXPECT_EQ(rows.value(1, i), i + 1);
            EXPECT_EQ(rows.value(2, i), i + 1 < width ? i + 1 : 0.5f);
        }
        EXPECT_FALSE(rows.equal(1, 2));
        for (int c = 0; c + 1 < rows.chunks(); ++c) // the value after a chunk
            EXPECT_EQ(rows(1, c)[SharedRows<float>::chunk], rows.value(1, (c + 1) * SharedRows<float>::chunk));
        EXPECT_EQ(rows.largest(), width);
        const SharedRows<float> doubled = rows.mapped<float>([](float v) { return 2 * v; });
        EXPECT_EQ(doubled.value(2, width - 1), 1.0f);
    }
}

TEST(SharedRows, StoresEqualChunksOnce)
{
    const int width = 256, count = 1000;
    SharedRows<float> rows(count, width);
    const std::vector<float> values(width, 0.25f);
    for (int row = 1; row < count; ++row)
        rows.set(row, values.data(), row - 1, -1);
    EXPECT_TRUE(rows.equal(1, count - 1));
    EXPECT_LT(rows.bytes(), 5 * static_cast<long>(sizeof(int)) * count);
}

} // namespace
} // namespace gapflow
