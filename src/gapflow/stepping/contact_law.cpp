// Projected Gauss-Seidel over the contacts, to and fro, a contact's normal before its tangents (J. J. Moreau, M. Jean, "Numerical
// treatment of contact and friction: the contact dynamics method", 1996). Bodies' twists are kept, so a sweep costs the number of
// contacts.
#include "gapflow/stepping/contact_law.hpp"

#include <algorithm>
#include <cmath>

namespace gapflow {

namespace {

constexpr int most_sweeps = 2000;
constexpr double round_off = 1e-14; // of the largest change of a speed

// One row of C with what an impulse along it does to its two bodies.
template <int D>
struct Row {
    const RelativeRow<D>* row;
    Twist<D> response_a, response_b;
    double mobility;
};

template <int D>
class Sweeps {
public:
    Sweeps(const std::vector<Contact<D>>& contacts, const std::vector<TwistMatrix<D>>& mobility, ContactForecast<D>& result)
        : contacts_(contacts), mobility_(mobility), result_(result)
    {
        for (const Contact<D>& c : contacts) {
            normal_.push_back(make_row(c, c.normal));
            if (c.friction > 0)
                for (const RelativeRow<D>& t : c.tangents)
                    tangent_.push_back(make_row(c, t));
            else
                tangent_.resize(tangent_.size() + D - 1);
            rebounds_.push_back(c.closed && c.target > c.least);
        }
    }

    /// Brings one contact to its law, the others as they are. Largest change of a speed.
    double settle(int i)
    {
        const Contact<D>& c = contacts_[i];
        ContactImpulse<D>& impulse = result_.impulses[i];
        const Row<D>& n = normal_[i];
        if (n.mobility <= 0)
            return 0;
        const double bound = rebounds_[i] ? c.target : c.least;
        const double normal = std::max(0.0, impulse.normal + (bound - speed(c, n)) / n.mobility);
        double largest = push(c, n, normal - impulse.normal);
        impulse.normal = normal;
        if (normal == 0)
            rebounds_[i] = false;
        else if (c.target > c.least && !rebounds_[i])
            rebounds_[i] = true; // what closes in an impact leaves with its rebound
        if (c.friction <= 0)
            return largest;
        const Row<D>* t = &tangent_[(D - 1) * i];
        double mobility = 0; // no less than the tangents' together
        for (int k = 0; k < D - 1; ++k)
            mobility += t[k].mobility;
        if (mobility <= 0)
            return largest;
        Vec<D - 1> pull = impulse.tangential;
        for (int k = 0; k < D - 1; ++k)
            pull[k] -= speed(c, t[k]) / mobility;
        const double most = c.friction * normal;
        if (pull.norm() > most)
            pull *= most / pull.norm();
        for (int k = 0; k < D - 1; ++k)
            largest = std::max(largest, push(c, t[k], pull[k] - impulse.tangential[k]));
        impulse.tangential = pull;
        return largest;
    }

private:
    Row<D> make_row(const Contact<D>& c, const RelativeRow<D>& row) const
    {
        Row<D> made{&row, mobility_[c.point.a] * row.a, mobility_[c.point.b] * row.b, 0};
        made.mobility = row.a.dot(made.response_a) + row.b.dot(made.response_b);
        return made;
    }

    double speed(const Contact<D>& c, const Row<D>& r) const
    {
        return r.row->a.dot(result_.twists[c.point.a]) + r.row->b.dot(result_.twists[c.point.b]);
    }

    double push(const Contact<D>& c, const Row<D>& r, double impulse)
    {
        if (impulse == 0)
            return 0;
        result_.twists[c.point.a] += impulse * r.response_a;
        result_.twists[c.point.b] += impulse * r.response_b;
        return std::abs(impulse) * r.mobility;
    }

    const std::vector<Contact<D>>& contacts_;
    const std::vector<TwistMatrix<D>>& mobility_;
    ContactForecast<D>& result_;
    std::vector<Row<D>> normal_, tangent_;
    std::vector<char> rebounds_;
};

} // namespace

template <int D>
ContactForecast<D> forecast_contacts(const std::vector<Contact<D>>& contacts, const std::vector<ContactImpulse<D>>& given,
                                     const std::vector<Twist<D>>& twists, const std::vector<TwistMatrix<D>>& mobility,
                                     double accuracy)
{
    ContactForecast<D> result{given, twists};
    Sweeps<D> sweeps(contacts, mobility, result);
    const int n = static_cast<int>(contacts.size());
    double fastest = 0;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        double largest = 0;
        for (int i = 0; i < n; ++i)
            largest = std::max(largest, sweeps.settle(sweep % 2 == 0 ? i : n - 1 - i));
        if (largest < std::max(accuracy, round_off * fastest))
            break;
        fastest = std::max(fastest, largest);
    }
    return result;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                              \
    template ContactForecast<D> forecast_contacts<D>(const std::vector<Contact<D>>&, const std::vector<ContactImpulse<D>>&, \
                                                     const std::vector<Twist<D>>&, const std::vector<TwistMatrix<D>>&, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
