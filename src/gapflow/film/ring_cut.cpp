// A ray leaves the pole, the point of the ball nearest to the other, along a great circle; azimuths are counted from an axis of the ball, so that
// the mesh turns with it and is symmetric where the pair is. Each ring has the same share of all rays' lengths.
#include "gapflow/film/ring_cut.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gapflow {
namespace {

using std::numbers::pi;

constexpr int quarter = 4;           // a number of rays that is a multiple of this keeps the mesh as symmetric as the pair
constexpr int fewest = 12;           // rays: with 8 the added mass of two balls that approach is 0.7 % low
constexpr int fewest_to_halve = 24;  // rays of which every other one may end before the rim
constexpr double least_share = 0.25; // of more rays: the rim must be longer than this before it takes them
constexpr double precision = 1e-12;  // of a ray's end, in dx
constexpr int most_rings = 1000;
// In dx: balls that overlap no further touch. Those that touch overlap by their places' round-off or not (random scene 441).
constexpr double overlap = 1e-6;

class BallRays {
public:
    /// A point of the ball and what it has opposite.
    struct Sample {
        Vec<3> x;
        SurfacePoint<3> p;
        std::optional<RimEnd> fails;
    };
    /// Where the gap ends along a ray.
    struct End {
        double angle; ///< from the pole
        Sample inside;
        RimEnd end;
    };

    explicit BallRays(const GapTest<3>& test) : test_(test)
    {
        centre_ = test.master.to_world(Vec<3>::Zero());
        radius_ = *test.master.shape().sphere_radius();
        pole_ = (test.other.closest(centre_).x - centre_).normalized();
        const Vec<3> n = test.master.rotation().transpose() * pole_;
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (std::abs(n[k]) < std::abs(n[axis]) - 1e-6) // the first of equals, whatever the rounding
                axis = k;
        const Vec<3> along = test.master.rotation() * unit<3>(axis);
        first_ = (along - along.dot(pole_) * pole_).normalized();
        second_ = pole_.cross(first_);
    }

    double radius() const { return radius_; }

    Sample at(double angle, double azimuth) const
    {
        const Vec<3> n = std::cos(angle) * pole_ + std::sin(angle) * (std::cos(azimuth) * first_ + std::sin(azimuth) * second_);
        const Vec<3> x = centre_ + radius_ * n;
        const SurfacePoint<3> p = test_.other.closest(x);
        return {x, p, test_.fails(x, n, p)};
    }

    /// The first end along an azimuth; nothing if there is none on the pole's half of the ball. `guess`: an angle near it.
    std::optional<End> end(double azimuth, const Sample& pole, double guess) const
    {
        double in = 0, out = guess;
        Sample inside = pole, outside = at(out, azimuth);
        while (!outside.fails) {
            in = out;
            inside = outside;
            out *= 1.3;
            if (out > 0.5 * pi)
                return {};
            outside = at(out, azimuth);
        }
        // Where the thickness ends it, regula falsi (Illinois) with bisections between; else bisections.
        const double close = precision * test_.options.dx;
        const auto excess = [&](const Sample& s) { return s.p.distance - test_.options.threshold + 0.5 * close; };
        double below = excess(inside), above = excess(outside);
        int last = 0;
        for (int i = 0; i < 60 && (out - in) * radius_ > close; ++i) {
            const bool secant = *outside.fails == RimEnd::thickness && i % 3 != 2 && below < 0 && above > 0;
            const double angle = secant ? in + (out - in) * below / (below - above) : 0.5 * (in + out);
            const Sample s = at(angle, azimuth);
            if (s.fails) {
                out = angle;
                outside = s;
                above = excess(s);
                below *= last > 0 ? 0.5 : 1.0;
                last = 1;
                continue;
            }
            in = angle;
            inside = s;
            below = excess(s);
            above *= last < 0 ? 0.5 : 1.0;
            last = -1;
            if (*outside.fails == RimEnd::thickness && below > -0.5 * close)
                break;
        }
        return End{in, inside, *outside.fails};
    }

    /// Does the gap begin again beyond this end, within the angle?
    bool goes_on_beyond(const End& end, double azimuth, double within) const
    {
        for (double share : {0.25, 0.5, 0.75, 1.0})
            if (!at(end.angle + share * within, azimuth).fails)
                return true;
        return false;
    }

private:
    const GapTest<3>& test_;
    Vec<3> centre_, pole_, first_, second_;
    double radius_;
};

class RingMesh {
public:
    explicit RingMesh(const GapTest<3>& test)
        : test_(test), o_(test.options), rays_(test), pole_(rays_.at(0, 0)), curvature_(test.curvature(0, pole_.p.patch))
    {
    }

    std::optional<GapCut<3>> cut()
    {
        if (pole_.fails == RimEnd::thickness)
            return GapCut<3>{};
        if (pole_.fails || pole_.p.distance < -overlap * o_.dx || !(curvature_ > 0) || !find_rim())
            return {};
        keep_area();
        if (!choose_rings() || !add_nodes())
            return {};
        if (!is_one_surface())
            return {};
        add_elements();
        return std::move(cut_);
    }

private:
    double azimuth(double ray) const { return 2 * pi * ray / double(rim_.size()); }

    /// As many rays as the rim has edges of their size.
    bool find_rim()
    {
        const double guess =
            std::min(1.0, 1.05 * std::sqrt(2 * (o_.threshold - pole_.p.distance) / curvature_) / rays_.radius());
        const double edges = 2 * pi * rays_.radius() * std::sin(guess) / (o_.straddle_smooth * o_.dx);
        const int many = edges > fewest_to_halve - quarter ? 2 * quarter : quarter; // half of them is as symmetric
        const int count = std::max(fewest, many * int(std::ceil(edges / many - least_share)));
        for (int j = 0; j < count; ++j) {
            const double at = 2 * pi * j / count;
            const auto end = rays_.end(at, pole_, guess);
            if (!end || end->angle <= 0)
                return false;
            if (end->end == RimEnd::third_body) {
                if (rays_.goes_on_beyond(*end, at, std::max(guess - end->angle, 0.1 * guess)))
                    return false;
            } else if (!is_smooth(end->end)) {
                return false;
            }
            rim_.push_back(*end);
        }
        return true;
    }
    static bool is_smooth(RimEnd end) { return end == RimEnd::thickness || end == RimEnd::normals; }

    /// Moves the rim out where it is smooth: the polygon then has the gap's area.
    void keep_area()
    {
        const double beyond = std::sqrt(azimuth(1) / std::sin(azimuth(1)));
        for (std::size_t j = 0; j < rim_.size(); ++j) {
            if (!is_smooth(rim_[j].end))
                continue;
            const BallRays::Sample s = rays_.at(beyond * rim_[j].angle, azimuth(double(j)));
            if (s.p.feature == Feature::face && s.fails != RimEnd::third_body)
                rim_[j] = {beyond * rim_[j].angle, s, rim_[j].end};
        }
    }

    /// The rings' shares of the longest ray, on which the thickness is taken as h0 + (h1 - h0) share^2.
    bool choose_rings()
    {
        double reach = 0, h1 = 0;
        for (const BallRays::End& end : rim_) {
            reach = std::max(reach, end.angle * rays_.radius());
            h1 = std::max(h1, end.inside.p.distance);
        }
        const double h0 = std::max(pole_.p.distance, o_.floor);
        shares_ = {0};
        while (shares_.back() < 1) {
            const double h = h0 + (h1 - h0) * shares_.back() * shares_.back();
            const double size =
                std::clamp(o_.rings * std::sqrt(2 * h / curvature_), o_.smallest * o_.dx, o_.largest_curved * o_.dx);
            shares_.push_back(shares_.back() + size / reach);
            if (int(shares_.size()) > most_rings)
                return false;
        }
        if (shares_.size() > 2 && shares_.back() - 1 > 1 - shares_[shares_.size() - 2]) // the ring before is nearer to the rim
            shares_.pop_back();
        const double last = shares_.back();
        for (double& share : shares_)
            share /= last;
        return true;
    }

    int rings() const { return int(shares_.size()) - 1; }
    /// Rings within the rim have every other ray only.
    bool halved() const { return int(rim_.size()) >= fewest_to_halve && rings() > 1; }
    /// Nodes of ring k lie between the rays: rings take turns.
    bool between(int k) const { return k < rings() && (rings() - k - (halved() ? 1 : 0)) % 2 == 1; }

    bool add_nodes()
    {
        cut_.nodes.push_back({pole_.x, pole_.p, {}});
        nodes_.resize(shares_.size());
        const int every = halved() ? 2 : 1, inner = int(rim_.size()) / every;
        for (int k = 1; k < rings(); ++k)
            for (int j = 0; j < inner; ++j) {
                const double a = rim_[every * j].angle, b = rim_[every * ((j + 1) % inner)].angle;
                const double half = 0.5 * every;
                const double chord = 2 * a * b * std::cos(azimuth(half)) / (a + b); // of the polygon through the rays' ends
                const BallRays::Sample s = between(k) ? rays_.at(shares_[k] * chord, azimuth(every * j + half))
                                                      : rays_.at(shares_[k] * a, azimuth(every * j));
                if (s.fails)
                    return false;
                nodes_[k].push_back(int(cut_.nodes.size()));
                cut_.nodes.push_back({s.x, s.p, {}});
            }
        for (const BallRays::End& end : rim_) {
            nodes_[rings()].push_back(int(cut_.nodes.size()));
            cut_.nodes.push_back({end.inside.x, end.inside.p, end.end});
        }
        return true;
    }

    /// Patches of the other that are opposite join smoothly.
    bool is_one_surface() const
    {
        std::vector<int> patches;
        for (const GapCut<3>::Node& node : cut_.nodes)
            if (std::find(patches.begin(), patches.end(), node.p.patch) == patches.end())
                patches.push_back(node.p.patch);
        return patches.size() == 1 || smooth_groups<3>(test_.other.shape(), patches).size() == 1;
    }

    void add_elements()
    {
        const auto add = [&](int a, int b, int c) { cut_.elements.push_back({{a, b, c}, 0}); };
        for (std::size_t j = 0; j < nodes_[1].size(); ++j)
            add(0, nodes_[1][j], nodes_[1][(j + 1) % nodes_[1].size()]);
        for (int k = 1; k < rings(); ++k) {
            const std::vector<int>&in = nodes_[k], &out = nodes_[k + 1];
            for (std::size_t j = 0; j < in.size(); ++j) {
                const std::size_t n = (j + 1) % in.size();
                if (out.size() > in.size()) { // the rim: two edges for one
                    add(in[j], out[2 * j], out[2 * j + 1]);
                    add(in[j], out[2 * j + 1], in[n]);
                    add(in[n], out[2 * j + 1], out[2 * n]);
                } else if (between(k)) { // in[j] lies between out[j] and out[n]
                    add(in[j], out[j], out[n]);
                    add(in[j], out[n], in[n]);
                } else { // out[j] lies between in[j] and in[n]
                    add(in[j], out[j], in[n]);
                    add(in[n], out[j], out[n]);
                }
            }
        }
    }

    const GapTest<3>& test_;
    const FilmMeshOptions& o_;
    BallRays rays_;
    BallRays::Sample pole_;
    double curvature_;
    std::vector<BallRays::End> rim_; // one for each ray
    std::vector<double> shares_;
    std::vector<std::vector<int>> nodes_; // of each ring
    GapCut<3> cut_;
};

} // namespace

std::optional<GapCut<3>> ring_cut(const GapTest<3>& test)
{
    const Shape<3>& master = test.master.shape();
    if (test.options.rings <= 0 || !master.sphere_radius() || master.inside_out() || !test.other.shape().convex() ||
        test.other.shape().inside_out())
        return {};
    return RingMesh(test).cut();
}

} // namespace gapflow
