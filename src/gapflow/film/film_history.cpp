#include "gapflow/film/film_history.hpp"

#include "gapflow/film/edge_table.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gapflow {

namespace {

constexpr int longest_walk = 100; // elements: a longer walk may be a cycle
// Interpolated velocities relative to the master exceed those of the surrounding elements by this factor at most.
constexpr double surplus_bound = 1.5;
// Speeds are means over the elements around a vertex, and over at least the gap's own thickness, or this in dx: on smaller lengths the film
// model has no meaning. (A film's end cuts elements of a hundredth of a cell, which have a negligible flux at any speed.)
constexpr double smallest_patch = 0.25;
// A mouth takes over the flux of an old one within this many cells.
constexpr double mouth_reach = 2.0;
// In dx: a point of the master that lies further beyond a film's end than this, or than the film is thick there, does not belong to it. Where surfaces
// touch, points over an element are still found at it, within round-off.
constexpr double beyond_end = 0.05;
constexpr double round_off = 1e-9;
// The master's surface rises over an element's plane by less than this share of the element's size; what is further off is another surface.
constexpr double rise = 0.25;
// Shape functions less than this are round-off.
constexpr double at_vertex = 1e-6;
// Films of up to this many elements are searched without bins.
constexpr int few_elements = 256;

// Barycentric coordinates of x in the plane of a simplex, and the distance from x to the (closed) simplex.
template <int D>
double to_simplex(const std::array<Vec<D>, D>& v, const Vec<D>& x, std::array<double, D>& shape)
{
    if constexpr (D == 2) {
        const Vec<2> t = v[1] - v[0];
        const double s = (x - v[0]).dot(t) / t.squaredNorm();
        shape = {1 - s, s};
        return (x - v[0] - std::clamp(s, 0.0, 1.0) * t).norm();
    } else {
        const Vec<3> a = v[1] - v[0], b = v[2] - v[0], r = x - v[0];
        const double aa = a.dot(a), ab = a.dot(b), bb = b.dot(b), ra = r.dot(a), rb = r.dot(b);
        const double det = aa * bb - ab * ab;
        const double s = (bb * ra - ab * rb) / det, t = (aa * rb - ab * ra) / det;
        shape = {1 - s - t, s, t};
        if (s >= 0 && t >= 0 && s + t <= 1)
            return (r - s * a - t * b).norm();
        double best = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; ++i) {
            const Vec<3>& p = v[i];
            const Vec<3> e = v[(i + 1) % 3] - p;
            best = std::min(best, (x - p - std::clamp((x - p).dot(e) / e.squaredNorm(), 0.0, 1.0) * e).norm());
        }
        return best;
    }
}

} // namespace

template <int D>
FilmHistory<D>::FilmHistory(const Solid<D>& master, const Twist<D>& master_twist, const std::vector<const Film<D>*>& films,
                            const std::vector<Vec<D>>& w, const std::vector<Vec<D>>& acceleration,
                            const std::vector<Vec<D>>& increment, const std::vector<char>& idle, double dx)
    : dx_(dx), rotation_(master.shape.rotation()), centre_body_(master.shape.to_body(master.centre)), twist_(master_twist)
{
    std::vector<double> weight;
    for (const Film<D>* film : films) {
        const int first = static_cast<int>(x_.size());
        for (const Vec<D>& x : film->mesh.x)
            x_.push_back(master.shape.to_body(x));
        h_.insert(h_.end(), film->mesh.h.begin(), film->mesh.h.end());
        for (std::size_t e = 0; e < film->mesh.elements.size(); ++e) {
            const FilmElement<D>& element = film->mesh.elements[e];
            std::array<int, D> nodes = element.nodes;
            Vec<D> centroid = Vec<D>::Zero();
            for (int& node : nodes) {
                node += first;
                centroid += x_[node] / D;
            }
            elements_.push_back(nodes);
            centroid_.push_back(centroid);
            normal_.push_back(element.normal);
            if (!acceleration.empty())
                acceleration_.push_back(acceleration[film->first_element + e]);
            if (!increment.empty())
                increment_.push_back(increment[film->first_element + e]);
            idle_.push_back(!idle.empty() && idle[film->first_element + e]);
            weight.push_back(idle_.back() ? 0.0 : element.volume);
            h_mean_.push_back(element.volume / element.measure);
            cosine_.push_back(element.cosine());
            // Where the master's velocity is added again: on its surface, not on the element's plane.
            const Vec<D> relative = w[film->first_element + e] - master_velocity(master.shape.to_body(element.centroid_master));
            flux_.push_back(h_mean_.back() * relative);
            volumes_.push_back(element.volume);
        }
    }
    radius_.assign(elements_.size(), 0.0);
    for (std::size_t e = 0; e < elements_.size(); ++e)
        for (int node : elements_[e])
            radius_[e] = std::max(radius_[e], (x_[node] - centroid_[e]).norm());
    if (elements() > few_elements)
        for (int e = 0; e < elements(); ++e)
            bins_[bin_key(bin(centroid_[e]))].push_back(e);
    join_elements();
    fit_vertices(weight);
    limit_slopes();
}

template <int D>
void FilmHistory<D>::join_elements()
{
    EdgeTable first; // facets (2D: nodes) -> D * element + node opposite
    first.reset(2 * elements_.size());
    beyond_.assign(elements_.size(), {});
    for (int e = 0; e < elements(); ++e)
        for (int i = 0; i < D; ++i) {
            beyond_[e][i] = -1;
            int& facet = first.insert(elements_[e][(i + 1) % D], elements_[e][(i + D - 1) % D]);
            if (facet < 0) {
                facet = D * e + i;
            } else {
                beyond_[e][i] = facet / D;
                beyond_[facet / D][facet % D] = e;
            }
        }
}

template <int D>
void FilmHistory<D>::fit_vertices(const std::vector<double>& weight)
{
    std::vector<Vec<D>> normal_body(elements_.size());
    for (std::size_t e = 0; e < elements_.size(); ++e)
        normal_body[e] = rotation_.transpose() * normal_[e];
    const VertexFit fit = vertex_fit<D>(x_, elements_, centroid_, normal_body, weight);
    rings_ = vertex_rings<D>(x_.size(), elements_);
    flux_vertex_.assign(x_.size(), Vec<D>::Zero());
    speed_.assign(x_.size(), 0.0);
    for (int i = 0; i < static_cast<int>(x_.size()); ++i) {
        if (rings_.first[i] == rings_.first[i + 1])
            continue;
        const int any = rings_.element[rings_.first[i]];
        if (fit.first[i] == fit.first[i + 1]) { // idle all around
            flux_vertex_[i] = flux_[any];
            speed_[i] = flux_[any].norm() / h_mean_[any];
            continue;
        }
        double total = 0;
        for (int k = fit.first[i]; k < fit.first[i + 1]; ++k)
            total += weight[fit.element[k]];
        const double least = h_[i] * std::pow(std::min(h_[i], smallest_patch * dx_), D - 1);
        for (int k = fit.first[i]; k < fit.first[i + 1]; ++k) {
            const int e = fit.element[k];
            speed_[i] += weight[e] / std::max(total, least) * flux_[e].squaredNorm() / (h_mean_[e] * h_mean_[e]);
        }
        speed_[i] = std::sqrt(speed_[i]);
        flux_vertex_[i] = fit.at(i, flux_, flux_vertex_[i]);
        if (!flux_vertex_[i].allFinite())
            flux_vertex_[i] = flux_[any];
    }
}

template <int D>
std::vector<int> FilmHistory<D>::around(int element) const
{
    std::vector<int> list;
    for (int node : elements_[element])
        list.insert(list.end(), rings_.element.begin() + rings_.first[node], rings_.element.begin() + rings_.first[node + 1]);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    list.erase(std::find(list.begin(), list.end(), element));
    return list;
}

// At a facet's middle the flux goes no further than the mean of an element beside this one: a linear field keeps its slope, because the middle
// lies between the elements' centroids.
template <int D>
void FilmHistory<D>::limit_slopes()
{
    slope_.assign(elements_.size(), 1.0);
    for (int e = 0; e < elements(); ++e) {
        Vec<D> mean = Vec<D>::Zero();
        for (int node : elements_[e])
            mean += flux_vertex_[node] / D;
        for (int i = 0; i < D; ++i) {
            if (beyond_[e][i] < 0)
                continue;
            Vec<D> change = -mean;
            for (int k = 1; k < D; ++k)
                change += flux_vertex_[elements_[e][(i + k) % D]] / (D - 1);
            double along = 0; // the furthest that a neighbour goes the same way
            for (int beside : beyond_[e])
                if (beside >= 0)
                    along = std::max(along, change.dot(flux_[beside] - flux_[e]));
            const double square = change.squaredNorm();
            slope_[e] = std::min(slope_[e], along < square ? along / square : 1.0);
        }
    }
}

// The elements that have a place on one of their facets or nodes; none: it lies inside of its own.
template <int D>
std::vector<int> FilmHistory<D>::sharing(const Place& place) const
{
    std::array<int, D> at{}; // nodes of that facet
    int count = 0;
    for (int i = 0; i < D; ++i)
        if (place.shape[i] > at_vertex)
            at[count++] = elements_[place.element][i];
    std::vector<int> shared;
    for (int k = rings_.first[at[0]]; k < rings_.first[at[0] + 1] && count < D; ++k) {
        const std::array<int, D>& nodes = elements_[rings_.element[k]];
        if (std::all_of(at.begin(), at.begin() + count,
                        [&](int i) { return std::find(nodes.begin(), nodes.end(), i) != nodes.end(); }))
            shared.push_back(rings_.element[k]);
    }
    return shared;
}

template <int D>
typename FilmHistory<D>::Sample FilmHistory<D>::sample(const Place& place, const Vec<D>& x_body, double share) const
{
    Vec<D> flux = flux_[place.element];
    for (int i = 0; i < D; ++i)
        flux += slope_[place.element] * (std::clamp(place.shape[i], 0.0, 1.0) - 1.0 / D) *
                flux_vertex_[elements_[place.element][i]];
    return {place.element, share, belongs(place, x_body), thickness(place), flux};
}

template <int D>
Index<D> FilmHistory<D>::bin(const Vec<D>& x_body) const
{
    return (x_body / dx_).array().floor().template cast<int>();
}

template <int D>
long FilmHistory<D>::bin_key(const Index<D>& bin) const
{
    long key = 0;
    for (int axis = 0; axis < D; ++axis)
        key = key * 2000003L + bin[axis] + 1000001L;
    return key;
}

template <int D>
typename FilmHistory<D>::Place FilmHistory<D>::place_in(int element, const Vec<D>& x_body) const
{
    Place place{element, {}, 0};
    std::array<Vec<D>, D> v;
    for (int i = 0; i < D; ++i)
        v[i] = x_[elements_[element][i]];
    place.distance = to_simplex<D>(v, x_body, place.shape);
    return place;
}

// On the master's surface over the element, or next to it. (The surface of a ball of four cells is 0.05 cells from an element of one cell.)
template <int D>
bool FilmHistory<D>::belongs(const Place& place, const Vec<D>& x_body) const
{
    Vec<D> in_plane = Vec<D>::Zero();
    for (int i = 0; i < D; ++i)
        in_plane += place.shape[i] * x_[elements_[place.element][i]];
    const double off = (x_body - in_plane).norm();
    const double end = std::max(std::min(beyond_end * dx_, thickness(place)), round_off * dx_);
    return off < rise * radius_[place.element] + end && place.distance * place.distance - off * off < end * end;
}

// From element to element towards x, across the facet that x lies furthest beyond. Element -1: x lies beyond the film's end.
template <int D>
typename FilmHistory<D>::Place FilmHistory<D>::walk(const Vec<D>& x_body, int start) const
{
    Place place = place_in(start, x_body);
    for (int step = 0; step < longest_walk; ++step) {
        const int i = static_cast<int>(std::min_element(place.shape.begin(), place.shape.end()) - place.shape.begin());
        if (place.shape[i] >= 0)
            return place;
        const int next = beyond_[place.element][i];
        if (next < 0)
            break;
        place = place_in(next, x_body);
    }
    place.element = -1;
    return place;
}

// The element nearest to x; where a walk from the hint ends inside one close to x, that.
template <int D>
typename FilmHistory<D>::Place FilmHistory<D>::locate(const Vec<D>& x_body, int hint) const
{
    Place best{-1, {}, std::numeric_limits<double>::infinity()};
    if (hint >= 0) {
        const Place place = walk(x_body, hint);
        if (place.element >= 0 && place.distance < 0.5 * radius_[place.element])
            return place;
        best = place_in(hint, x_body);
    }
    auto consider = [&](int e) {
        const double least = best.distance + radius_[e];
        if ((x_body - centroid_[e]).squaredNorm() >= least * least)
            return;
        if (const Place place = place_in(e, x_body); place.distance < best.distance)
            best = place;
    };
    if (bins_.empty()) {
        for (int e = 0; e < elements(); ++e)
            consider(e);
        return best;
    }
    for (int reach = 1; reach <= 3; ++reach) {
        for_each_index<D>(Index<D>::Constant(-reach), Index<D>::Constant(reach + 1), [&](const Index<D>& d) {
            if (const std::vector<int>* in_bin = bins_.find(bin_key(Index<D>(bin(x_body) + d))))
                for (int e : *in_bin)
                    consider(e);
        });
        if (best.distance < (reach - 0.5) * dx_)
            return best;
    }
    if (best.element < 0)
        for (int e = 0; e < elements(); ++e)
            consider(e);
    return best;
}

// Quadratic: from the vertices and the element's mean (a bubble c sum lambda_i lambda_j of mean 1). Beyond the film extrapolated linearly over one
// element's length, within a factor of two.
template <int D>
double FilmHistory<D>::thickness(const Place& place) const
{
    double h = 0, mean = 0, bubble = 0, least = std::numeric_limits<double>::infinity(), most = 0;
    for (int i = 0; i < D; ++i) {
        const double at_node = cosine_[place.element] * h_[elements_[place.element][i]];
        h += std::clamp(place.shape[i], -1.0, 2.0) * at_node;
        mean += at_node / D;
        for (int j = 0; j < i; ++j)
            bubble += (D == 2 ? 6 : 4) * std::clamp(place.shape[i], 0.0, 1.0) * std::clamp(place.shape[j], 0.0, 1.0);
        least = std::min(least, at_node);
        most = std::max(most, at_node);
    }
    return std::clamp(h + bubble * (h_mean_[place.element] - mean), 0.5 * least, 2 * most);
}

template <int D>
double FilmHistory<D>::at_vertices(std::span<const double> field, const Vec<D>& x_body, int& hint) const
{
    const Place place = locate(x_body, hint);
    hint = place.element;
    if (place.element < 0 || !belongs(place, x_body))
        return 0;
    double value = 0, sum = 0;
    for (int i = 0; i < D; ++i)
        if (place.shape[i] > at_vertex) {
            value += place.shape[i] * field[elements_[place.element][i]];
            sum += place.shape[i];
        }
    return value / sum;
}

template <int D>
double FilmHistory<D>::speed_about(int element) const
{
    double speed = 0;
    for (int node : elements_[element])
        speed = std::max(speed, speed_[node]);
    return speed;
}

template <int D>
Vec<D> FilmHistory<D>::master_velocity(const Vec<D>& x_body) const
{
    return velocity_at<D>(twist_, rotation_ * (x_body - centre_body_));
}

template <int D>
typename FilmHistory<D>::Flow FilmHistory<D>::at(const Vec<D>& x_body, int& hint) const
{
    const Place place = locate(x_body, hint);
    hint = place.element;
    // Beyond the film the flux is extrapolated linearly over one element's length.
    Vec<D> flux = Vec<D>::Zero();
    for (int i = 0; i < D; ++i)
        flux += std::clamp(place.shape[i], -1.0, 2.0) * flux_vertex_[elements_[place.element][i]];
    // Where the gap closes to a tip the division amplifies errors: limits the speed to about that of the surrounding elements.
    const double h = thickness(place), bound = surplus_bound * h * speed_about(place.element);
    if (flux.norm() > bound)
        flux *= bound / flux.norm();
    return {master_velocity(x_body), flux, normal_[place.element], h};
}

template <int D>
const typename FilmHistory<D>::OldMouth* FilmHistory<D>::nearest_mouth(const Vec<D>& x_body, const Vec<D>& outward) const
{
    const OldMouth* best = nullptr;
    double nearest = mouth_reach * dx_;
    for (const OldMouth& m : mouths)
        if (m.outward.dot(outward) > 0.5 && (m.place - x_body).norm() < nearest) {
            nearest = (m.place - x_body).norm();
            best = &m;
        }
    return best;
}

template class FilmHistory<2>;
template class FilmHistory<3>;

} // namespace gapflow
