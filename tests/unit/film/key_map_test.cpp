// The hash map behaves as an ordered map does, whatever the keys, and keeps the order of insertion until it is sorted.
#include "gapflow/film/key_map.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <string>

namespace gapflow {
namespace {

// Keys far apart, next to each other, negative, and with equal low bits.
std::vector<long> many_keys()
{
    std::vector<long> keys{0, -1, std::numeric_limits<long>::min(), std::numeric_limits<long>::max()};
    std::mt19937_64 random(5);
    for (long i = 1; i <= 1000; ++i) {
        keys.push_back(i);
        keys.push_back(i << 33);
        keys.push_back(static_cast<long>(random()));
    }
    std::shuffle(keys.begin(), keys.end(), random);
    return keys;
}

TEST(KeyMap, HoldsWhatWasInsertedAndNothingElse)
{
    KeyMap<int> map;
    EXPECT_TRUE(map.empty());
    EXPECT_EQ(map.index(0), -1); // the key of empty slots
    EXPECT_EQ(map.find(0), nullptr);
    std::map<long, int> expected;
    const std::vector<long> keys = many_keys();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const auto [value, is_new] = map.insert(keys[i], static_cast<int>(i));
        EXPECT_EQ(is_new, expected.emplace(keys[i], static_cast<int>(i)).second);
        EXPECT_EQ(value, expected.at(keys[i]));
    }
    ASSERT_EQ(map.size(), expected.size());
    for (const auto& [key, value] : expected) {
        ASSERT_TRUE(map.contains(key));
        EXPECT_EQ(*map.find(key), value);
        EXPECT_EQ(map.item(map.index(key)).first, key);
    }
    for (const long key : keys)
        if (const long absent = key ^ (1L << 62); !expected.count(absent)) {
            EXPECT_FALSE(map.contains(absent));
            EXPECT_EQ(std::as_const(map).find(absent), nullptr);
        }
}

TEST(KeyMap, KeepsTheOrderOfInsertionAndSortsByKey)
{
    KeyMap<std::string> map;
    for (long key : {7L, -3L, 100000000000L, 0L})
        map.insert(key, std::to_string(key));
    std::vector<long> order;
    for (const auto& [key, value] : map)
        order.push_back(key);
    EXPECT_EQ(order, (std::vector<long>{7, -3, 100000000000, 0}));
    map.sort();
    order.clear();
    for (const auto& [key, value] : map) {
        EXPECT_EQ(value, std::to_string(key));
        EXPECT_EQ(map.find(key), &value);
        order.push_back(key);
    }
    EXPECT_EQ(order, (std::vector<long>{-3, 0, 7, 100000000000}));
    map.insert(5, "5"); // goes on after its sort
    EXPECT_EQ(map.index(5), 4);
    EXPECT_EQ(map.index(7), 2);
}

TEST(KeyMap, InsertsOnceAndByDefault)
{
    KeyMap<int> map;
    EXPECT_EQ(map[4], 0);
    map[4] += 3;
    EXPECT_FALSE(map.insert(4, 9).second);
    EXPECT_EQ(map[4], 3);
    map.insert(4, 9).first = 5;
    EXPECT_EQ(*map.find(4), 5);
    EXPECT_EQ(map.size(), 1u);
}

TEST(KeyMap, IsEmptyAfterItWasCleared)
{
    KeyMap<int> map;
    for (long key = 0; key < 100; ++key)
        map.insert(key, 1);
    const KeyMap<int> copy = map;
    map.clear();
    EXPECT_TRUE(map.empty() && map.begin() == map.end());
    for (long key = 0; key < 100; ++key) {
        EXPECT_FALSE(map.contains(key));
        EXPECT_TRUE(copy.contains(key));
    }
    EXPECT_TRUE(map.insert(3, 2).second);
    EXPECT_EQ(*map.find(3), 2);
}

} // namespace
} // namespace gapflow
