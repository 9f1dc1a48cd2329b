#include "gapflow/output/convergence.hpp"
#include "temporary.hpp"

#include "gapflow/core/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace gapflow {
namespace {

Series sampled(int steps, double end, double (*f)(double))
{
    Series series;
    for (int i = 0; i <= steps; ++i) {
        series.time.push_back(i * end / steps);
        series.value.push_back(f(series.time.back()));
    }
    return series;
}

TEST(Convergence, ErrorsOfAHandMadeSeries)
{
    const Series reference = sampled(1, 2, [](double t) { return 3 * t; });
    const Series run = sampled(4, 2, [](double t) { return 3 * t + t * t; }); // e = t^2 at 0, 0.5, 1, 1.5, 2
    const SeriesError all = error_of(run, reference, {0, 2});
    EXPECT_NEAR(all.max, 4, 1e-14);
    EXPECT_NEAR(all.l2, std::sqrt(0.5 * (0.5 * 16 + 0.0625 + 1 + 5.0625) / 2), 1e-14);
    const SeriesError part = error_of(run, reference, {0.4, 1.1});
    EXPECT_NEAR(part.max, 1, 1e-14);
    EXPECT_NEAR(range_of(reference, {0.5, 1.5}), 3, 1e-14);
    EXPECT_NEAR(range_of(sampled(2, 2, [](double t) { return (t - 1) * (t - 1); }), {0, 2}), 1, 1e-14);
}

TEST(Convergence, OrdersAreThoseOfTheErrorsLaw)
{
    const std::vector<double> h{0.4, 0.2, 0.15, 0.05};
    for (double p : {0.5, 1.0, 2.0, 3.3}) {
        std::vector<double> exact, finest;
        for (double spacing : h) {
            exact.push_back(7 * std::pow(spacing, p));
            finest.push_back(7 * (std::pow(spacing, p) - std::pow(0.05, p)));
        }
        EXPECT_NEAR(*observed_order(h, exact, 0), p, 1e-12);
        EXPECT_NEAR(*observed_order({h[0], h[2]}, {exact[0], exact[2]}, 0), p, 1e-12);
        EXPECT_NEAR(*observed_order({h[0], h[1]}, {finest[0], finest[1]}, 0.05), p, 1e-10);
        EXPECT_NEAR(*observed_order(h, finest, 0.05), p, 1e-10); // its own row has error 0
    }
    EXPECT_NEAR(*observed_order({0.2, 0.1}, {std::log(0.2 / 0.05), std::log(0.1 / 0.05)}, 0.05), 0, 1e-6);
    EXPECT_FALSE(observed_order({0.2, 0.1}, {0.1, 0.0}, 0));
    EXPECT_FALSE(observed_order({0.2}, {0.1}, 0));
    EXPECT_LT(*observed_order({0.2, 0.1}, {0.1, 0.2}, 0), 0); // errors that grow
}

TEST(Convergence, TableCsvAndJson)
{
    ConvergenceOf c{"ball.y", "a file", {0, 2}, 0.5, {}, {}, {}, {8, 16, 32}, {}};
    c.limits = {limit_of({0.4, 0.2, 0.1}, {1, 1.5, 1.75}, 1e-9), limit_of({0.4, 0.2, 0.1}, {1, 2, 1}, 1e-9)};
    c.limits[0].of = "end";
    c.limits[1].of = "mean";
    for (int n : {8, 16, 32})
        c.rows.push_back({n, 1.0 / n, 10 * n, {1.0 / n / n, 0.5 / n}, {}, {}});
    find_orders(c, 0);
    EXPECT_FALSE(c.rows[0].order_max);
    EXPECT_NEAR(*c.rows[2].order_max, 2, 1e-12);
    EXPECT_NEAR(*c.slope_l2, 1, 1e-12);
    const std::string text = convergence_text({c});
    EXPECT_THAT(text, testing::HasSubstr("ball.y against a file, times 0 to 2, errors over its range 0.5"));
    EXPECT_THAT(text, testing::HasSubstr("slope"));
    EXPECT_THAT(convergence_csv({c}), testing::StartsWith("quantity,cells,spacing,steps,error_max,order_max,error_l2,order_l2\n"
                                                          "ball.y,8,0.125,80,0.015625,,0.0625,\n"));
    const auto json = nlohmann::json::parse(convergence_json({c}))["convergence"][0];
    EXPECT_EQ(json["rows"][1]["cells"], 16);
    EXPECT_TRUE(json["rows"][0]["order_max"].is_null());
    EXPECT_NEAR(json["limits"][0]["limit"].get<double>(), 2, 1e-9);
    EXPECT_EQ(json["limits"][1]["reason"], "not monotone");
    EXPECT_THAT(limits_csv({c}),
                testing::StartsWith("quantity,of,cells_8,cells_16,cells_32,order,limit,reason\nball.y,end,1,1.5,1.75,"));
    EXPECT_THAT(limits_csv({c}), testing::EndsWith("ball.y,mean,1,2,1,,,not monotone\n"));
    EXPECT_THAT(text, testing::HasSubstr("mean            1            2            1    not monotone\n"));
    EXPECT_NEAR(json["slope_max"].get<double>(), 2, 1e-12);
}

TEST(Convergence, LimitOfAMonotoneSequenceIsExact)
{
    for (const double p : {0.5, 1.0, 2.0, 3.3})
        for (const std::vector<double>& h : {std::vector<double>{0.4, 0.2, 0.1}, {1.0, 0.3, 0.15, 0.06}}) {
            std::vector<double> values;
            for (const double spacing : h)
                values.push_back(5 - 7 * std::pow(spacing, p));
            const Limit limit = limit_of(h, values, 1e-12);
            ASSERT_TRUE(limit.value);
            EXPECT_NEAR(*limit.order, p, 1e-9);
            EXPECT_NEAR(*limit.value, 5, 1e-9);
        }
}

TEST(Convergence, WithoutALimitItSaysWhy)
{
    const std::vector<double> h{0.4, 0.2, 0.1};
    const auto reason = [&](const std::vector<double>& values) {
        const Limit limit = limit_of(std::vector<double>(h.end() - static_cast<long>(values.size()), h.end()), values, 1e-9);
        EXPECT_FALSE(limit.value || limit.order);
        return limit.reason;
    };
    EXPECT_EQ(reason({1, 2}), "takes three grids");
    EXPECT_EQ(reason({1, 2, 1.5}), "not monotone");
    EXPECT_EQ(reason({1, 2, 3}), "its changes do not fall"); // those of log h
    EXPECT_EQ(reason({1, 2, 4}), "its changes do not fall");
    EXPECT_EQ(reason({1, 2, 2 + 1e-10}), "changes no more than by round-off");
}

TEST(Convergence, NumbersOfASeriesInAWindow)
{
    const Series series = sampled(4, 2, [](double t) { return t * t; }); // linear between 0, 0.25, 1, 2.25, 4
    const auto numbers = numbers_of(series, {0.25, 1.5});
    ASSERT_EQ(numbers.size(), 4u);
    EXPECT_EQ(numbers[0], (std::pair<std::string, double>("end", 2.25)));
    EXPECT_EQ(numbers[1].first, "mean");
    EXPECT_NEAR(numbers[1].second, (0.25 * 0.5 * (0.125 + 0.25) + 0.5 * 0.5 * (0.25 + 1) + 0.5 * 0.5 * (1 + 2.25)) / 1.25,
                1e-14);
    EXPECT_EQ(numbers[2], (std::pair<std::string, double>("smallest", 0.125)));
    EXPECT_EQ(numbers[3], (std::pair<std::string, double>("largest", 2.25)));
}

TEST(Convergence, ReadsNamedColumns)
{
    const test::TemporaryFile file("a.csv", "# made by hand\ntime, body ,x\n0,a,1\n0,b,7\n0.5,a,2\n0.5,b,8\n");
    const CsvTable table = read_csv(file.path());
    EXPECT_EQ(table.names, (std::vector<std::string>{"time", "body", "x"}));
    EXPECT_EQ(read_series(table, "time", "x", {{"body", "b"}}).value, (std::vector<double>{7, 8}));
    EXPECT_TRUE(read_series(table, "time", "x", {{"body", "c"}}).time.empty());
}

void expect_refusal(const std::string& content, const std::string& expected)
{
    const test::TemporaryFile file("bad.csv", content);
    try {
        read_series(read_csv(file.path()), "time", "x");
        FAIL() << content;
    } catch (const InputError& e) {
        EXPECT_THAT(std::string(e.what()), testing::HasSubstr("bad.csv" + expected));
    }
}

TEST(Convergence, HalfARowOfAKilledRunIsLeftOut)
{
    const test::TemporaryFile run("bodies.csv", "step,time,x\n0,0,1\n1,0.5,2\n2,0.75,1");
    EXPECT_EQ(read_series(read_csv(run.path()), "time", "x").time, (std::vector<double>{0, 0.5}));
    const test::TemporaryFile shorter("bodies.csv", "step,time,x\n0,0,1\n1,0.5,2\n2,0.");
    EXPECT_EQ(read_series(read_csv(shorter.path()), "time", "x").time, (std::vector<double>{0, 0.5}));
    const test::TemporaryFile other("motion.csv", "time,x\n0,1\n0.5,2"); // by hand: its last line counts
    EXPECT_EQ(read_series(read_csv(other.path()), "time", "x").time, (std::vector<double>{0, 0.5}));
}

TEST(Convergence, BadReferencesAreRefusedWithPlaceAndRemedy)
{
    expect_refusal("", ": has no rows; write");
    expect_refusal("0,1\n", ":1: the first line must name the columns");
    expect_refusal("time,y\n0,1\n", ": has no column 'x'; its columns are: time, y");
    expect_refusal("time,xx\n0,1\n", ": has no column 'x', did you mean 'xx'?");
    expect_refusal("time,x\n0\n", ":2: has 1 columns, the first line names 2");
    expect_refusal("time,x\n0,1\n1,one\n", ":3: x = 'one' is not a finite number");
    expect_refusal("time,x\n1,1\n1,2\n", ":3: time = 1 does not come after 1");
    EXPECT_THROW(read_csv("/nowhere/a.csv"), InputError);
}

} // namespace
} // namespace gapflow
