#include "gapflow/core/communicator.hpp"

#include <gtest/gtest.h>

int main(int argc, char** argv)
{
    testing::InitGoogleTest(&argc, argv);
    gapflow::Environment environment;
    return RUN_ALL_TESTS();
}
