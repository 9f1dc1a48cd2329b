// Errors of runs on several grids and their observed orders.
//
// On a run's own times t_i within the window that run and reference share, e_i = q(t_i) - q_ref(t_i), q_ref linear between its
// times. With the reference's range there, R = max q_ref - min q_ref,
//
//     max error = max |e_i| / R,       L2 error = sqrt( integral e^2 dt / integral dt ) / R   (trapezoidal rule).
//
// The observed order p is that of an error C (h^p - h_ref^p): h_ref = 0 for a reference from elsewhere, the finest spacing
// where the finest run is the reference, whose own error would otherwise make the order appear higher (P. J. Roache, Verification and
// Validation in Computational Science and Engineering, 1998, chapter 5).
//
// The limit of a single number f(h) = L + C h^p follows from the three finest grids (Richardson's extrapolation, same chapter):
//
//     (f1 - f2) / (f2 - f3) = (h1^p - h2^p) / (h2^p - h3^p),      L = f3 - (f2 - f3) h3^p / (h2^p - h3^p),      h1 > h2 > h3,
//
// which has a solution p > 0 only where f goes one way and its changes fall faster than those of log h.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace gapflow {

/// A table of text with named columns.
struct CsvTable {
    std::string file;
    std::vector<std::string> names;
    std::vector<std::vector<std::string>> rows;
    std::vector<long> lines; ///< number of each row's line in the file

    /// Number of a column. Throws InputError that lists the columns.
    std::size_t column(const std::string& name) const;
};

/// Reads a CSV file whose first line (after empty ones and those that start with #) names its columns.
/// Throws InputError: file, line, remedy.
CsvTable read_csv(const std::string& file);

/// One quantity in time; times increase.
struct Series {
    std::vector<double> time, value;
};

/// A numeric column over the time column; `where`, if given: only rows with these texts in these columns.
/// Throws InputError for text that is no number and times that do not increase.
Series read_series(const CsvTable& table, const std::string& time, const std::string& value,
                   const std::vector<std::pair<std::string, std::string>>& where = {});

struct TimeWindow {
    double from, to;
};

/// Largest less smallest value in a window, its ends included.
double range_of(const Series& series, const TimeWindow& window);

struct SeriesError {
    double max = 0, l2 = 0; ///< not divided by the range
};

/// Error of a run against a reference. The window is inside both. At least two of the run's times lie in it.
SeriesError error_of(const Series& run, const Series& reference, const TimeWindow& window);

/// Observed order of errors at several spacings h, C (h^p - reference_h^p): exact for two, else fitted so that the logarithms
/// have no remaining least-squares slope (reference_h = 0: it is that slope). Empty with fewer than two errors > 0, or if no p in -5 ... 20 fits.
std::optional<double> observed_order(const std::vector<double>& h, const std::vector<double>& error, double reference_h);

/// Value that a number approaches as the grid gets finer, or why there is none.
struct Limit {
    std::string of;             ///< "end", "mean", "smallest", "largest" of a quantity in the window
    std::vector<double> values; ///< of every grid, the coarsest first
    std::optional<double> order, value;
    std::string reason; ///< without a limit: not monotone, changes that do not fall, fewer than three grids
};

/// Richardson's estimate from the values at the three smallest of the spacings, which fall. Differences below `least` are none.
Limit limit_of(const std::vector<double>& spacings, const std::vector<double>& values, double least);

/// Value at the window's end, mean (trapezoidal rule), smallest and largest value in the window. It is inside the series.
std::vector<std::pair<std::string, double>> numbers_of(const Series& series, const TimeWindow& window);

struct ConvergenceRow {
    int cells = 0; ///< along the first axis
    double spacing = 0;
    long steps = 0;
    SeriesError error;                         ///< divided by the range
    std::optional<double> order_max, order_l2; ///< from the row before to this one
};

struct ConvergenceOf {
    std::string quantity, reference; ///< "upper.y"; a file and its column, or the finest run
    TimeWindow window{};
    double range = 0;
    std::vector<ConvergenceRow> rows;
    std::optional<double> slope_max, slope_l2; ///< of all rows
    std::vector<int> grids;                    ///< cells of all runs, that of the reference too
    std::vector<Limit> limits;
};

/// Fills the orders of the rows and the slopes. `reference_spacing`: 0 for a reference from elsewhere.
void find_orders(ConvergenceOf& convergence, double reference_spacing);

/// The table that a user reads.
std::string convergence_text(const std::vector<ConvergenceOf>& all);
/// quantity,cells,spacing,steps,error_max,order_max,error_l2,order_l2; orders are empty where there are none.
std::string convergence_csv(const std::vector<ConvergenceOf>& all);
/// quantity,of,cells...,order,limit,reason: a row a limit.
std::string limits_csv(const std::vector<ConvergenceOf>& all);
std::string convergence_json(const std::vector<ConvergenceOf>& all);

} // namespace gapflow
