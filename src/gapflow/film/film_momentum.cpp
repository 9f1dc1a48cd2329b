#include "gapflow/film/film_momentum.hpp"

#include "gapflow/core/sharing.hpp"
#include "gapflow/core/threads.hpp"
#include "gapflow/film/film_transport.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace gapflow {

namespace {

template <int D>
double debt_of(const FilmDebts<D>& debts, const FilmPair<D>& pair)
{
    const auto it = debts.find(pair);
    return it == debts.end() ? 0.0 : it->second;
}

double square(double x)
{
    return x * x;
}

// The films' transport in a step, part by part.
template <int D>
class FilmMomentum {
public:
    FilmMomentum(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const FilmHistories<D>& histories,
                 const std::function<MouthLaw(int, int)>& law, double dt, double share)
        : network_(network), solids_(solids), mouths_(network.rim.mouths), law_(law), dt_(dt),
          history_(network.films.size(), nullptr)
    {
        for (std::size_t k = 0; k < network.films.size(); ++k)
            if (auto it = histories.find(network.films[k].pair); it != histories.end())
                history_[k] = it->second.get();
        place_ = put_in_place<D>(network, solids, history_);
        for (FluidInPlace<D>& place : place_) {
            place.acceleration *= share;
            place.increment *= share;
        }
        predicted_flux_.resize(mouths_.size());
    }

    // Places at which the bulk's velocity counts: elements that cover new volume, then all mouths.
    std::vector<Vec<D>> bulk_places() const
    {
        std::vector<Vec<D>> places;
        for_each_element([&](std::size_t k, std::size_t i, const FilmElement<D>& e) {
            if (!history_[k] || place_[i].covered > 0)
                places.push_back(e.centroid);
        });
        for (const Mouth<D>& mouth : mouths_) // at smooth ends beyond the film's own cells
            places.push_back(history_[mouth.film] && mouth.kind == MouthKind::smooth
                                 ? Vec<D>(mouth.x + 0.5 * mouth.h * mouth.outward)
                                 : mouth.x);
        return places;
    }

    // The bulk's fluid in volume that films cover; reference velocities in world axes.
    void cover(const std::vector<Vec<D>>& bulk, FilmFlow<D>& flow)
    {
        auto next = bulk.begin();
        flow.velocity.resize(network_.elements);
        flow.normal.resize(network_.elements);
        FilmAccount<D>& account = flow.account;
        account.reference.resize(network_.elements);
        account.master.assign(network_.elements, Vec<D>::Zero());
        reference_.assign(network_.elements, Vec<D>::Zero());
        across_.assign(network_.elements, 0.0);
        for_each_element([&](std::size_t k, std::size_t i, const FilmElement<D>& e) {
            FluidInPlace<D>& place = place_[i];
            if (!history_[k]) {
                account.reference[i] = flow.velocity[i] = tangential<D>(*next, e.normal);
                flow.normal[i] = next->dot(e.normal);
                ++next;
                return;
            }
            const PlacedShape<D>& master = solids_[network_.films[k].pair.master].shape;
            const Vec<D> x = master.to_body(e.centroid_master);
            const Mat<D> R = master.rotation();
            const Vec<D> U = moving_with(*history_[k], x, R);
            if (place.covered > 0) {
                const Vec<D>& u = *next++;
                const Vec<D> along = R.transpose() * tangential<D>(u - U, e.normal);
                const double whole = place.volume + place.covered;
                place.world = (place.volume * place.world + place.covered * u) / whole;
                place.velocity = (place.volume * place.velocity + place.covered * along) / whole;
                place.reference += place.covered / e.volume * along;
            }
            reference_[i] = R * place.reference;
            across_[i] = e.normal.dot(place.world - U);
            account.master[i] = tangential<D>(U, e.normal);
            account.reference[i] = account.master[i] + reference_[i];
        });
        for (std::size_t r = 0; r < mouths_.size(); ++r)
            bulk_at_mouth_.push_back(*next++);
    }

    // Velocities of elements; of each pair the work that transport gives to the mouths.
    void carry(const FilmDebts<D>& debts, FilmFlow<D>& flow)
    {
        FilmAccount<D>& account = flow.account;
        std::vector<Vec<D>> expected(network_.elements),
            carrying(
                network_
                    .elements); // relative: velocity at the end of the step; volume times velocity, mean of the step, master's axes
        for_each_element([&](std::size_t k, std::size_t i, const FilmElement<D>& e) {
            if (!history_[k])
                return;
            const Mat<D> R = solids_[network_.films[k].pair.master].shape.rotation();
            expected[i] = reference_[i] + dt_ * (R * place_[i].increment);
            const FluidInPlace<D>& place = place_[i];
            carrying[i] =
                0.5 * ((place.volume + place.covered) * place.velocity + e.volume * (place.reference + dt_ * place.increment));
            carrying[i] -= across_[i] * (R.transpose() * e.lean);
        });
        mouth_fluxes(expected);
        std::vector<Carried<D>> low(history_.size()), high(history_.size());
        for_each_job(static_cast<int>(history_.size()), [&](int k) {
            const Film<D>& film = network_.films[k];
            if (!history_[k] || !film.here)
                return;
            const std::size_t n = film.mesh.elements.size();
            const FilmTransport<D> transport(
                network_, k, solids_[film.pair.master].shape, std::span(place_).subspan(film.first_element, n),
                std::span<const Vec<D>>(carrying).subspan(film.first_element, n), mouth_flow_, dt_);
            low[k] = transport.low();
            high[k] = transport.high();
        });
        exchange_items(
            network_.ranks, low.size(), [&](std::size_t k) { return history_[k] && network_.films[k].here; },
            [&](ByteWriter& out, std::size_t k) {
                low[k].each_field(out);
                high[k].each_field(out);
            },
            [&](ByteReader& in, std::size_t k) {
                low[k].each_field(in);
                high[k].each_field(in);
            });
        struct Sum {
            double low = 0, high = 0;         // work of transport against the expected velocities, what leaves less what enters
            double in = 0, out = 0, debt = 0; // what enters and leaves at first order
            double kept = 1;                  // the share of transport with which the films gain no more than what stays
        };
        std::map<const FilmHistory<D>*, Sum> sums;
        std::vector<Vec<D>> of_low(network_.elements), of_high(network_.elements);
        for_each_element([&](std::size_t k, std::size_t i, const FilmElement<D>& e) {
            if (!history_[k])
                return;
            const std::size_t own = i - network_.films[k].first_element;
            const Mat<D> R = solids_[network_.films[k].pair.master].shape.rotation();
            of_low[i] = account.master[i] + R * low[k].velocity[own];
            of_high[i] = account.master[i] + R * high[k].velocity[own];
            sums[history_[k]].low += e.volume * expected[i].dot(of_low[i] - account.reference[i]);
            sums[history_[k]].high += e.volume * expected[i].dot(of_high[i] - account.reference[i]);
        });
        for (std::size_t k = 0; k < history_.size(); ++k)
            if (history_[k]) {
                Sum& sum = sums[history_[k]];
                sum.low -= low[k].in;
                sum.high -= high[k].in;
                sum.in += low[k].in;
                sum.out += low[k].out;
                sum.debt = debt_of(debts, network_.films[k].pair);
            }
        for (auto& [old, sum] : sums) { // what leaves may be kept to pay a debt
            sum.low += sum.debt;
            if (sum.low > 0 && sum.high + sum.debt > 0)
                sum.kept = std::clamp((sum.in - sum.out - sum.debt) / (sum.low + sum.in - sum.debt), 0.0, 1.0);
            sum.high += sum.debt;
        }
        for_each_element([&](std::size_t k, std::size_t i, const FilmElement<D>& e) {
            if (!history_[k])
                return;
            const Sum& sum = sums[history_[k]];
            // The largest share of the second-order velocities with which the films gain nothing and pay their debt; if not even those of first
            // order do, what was put in place.
            const double share = sum.high <= 0        ? 1.0
                                 : sum.high > sum.low ? std::max(-sum.low, 0.0) / (sum.high - sum.low)
                                                      : 0.0;
            const std::size_t own = i - network_.films[k].first_element;
            flow.velocity[i] =
                account.reference[i] + sum.kept * ((1 - share) * of_low[i] + share * of_high[i] - account.reference[i]);
            flow.normal[i] = low[k].world[own].dot(e.normal);
            gives_[history_[k]] -= e.volume * expected[i].dot(flow.velocity[i] - account.reference[i]);
        });
    }

    // Mouths' fluxes, the factors of their conductances, and the heads: at entrances fluid pays its kinetic head; at exits it
    // regains what it brings, in all no more than transport and entrances gave.
    void drive_mouths(const FilmDebts<D>& debts, FilmFlow<D>& flow) const
    {
        struct Sum {
            double in = 0, out = 0, bulk = 0; // heads' work, and energy that the bulk brings in
            double paid = 0;                  // at entrances, losses included
            bool leaves = false;              // fluid by any mouth
            const FilmPair<D>* pair = nullptr;
        };
        std::map<const FilmHistory<D>*, Sum> sums; // also of films without mouths, between other films
        for (std::size_t k = 0; k < history_.size(); ++k)
            if (history_[k])
                sums[history_[k]].pair = &network_.films[k].pair;
        double largest = 0; // flux
        for (std::size_t r = 0; r < mouths_.size(); ++r)
            largest =
                std::max(largest, std::abs(mean_flux_[r]) + std::abs(mouths_[r].length * mouths_[r].section.dot(carried_[r])));
        std::vector<double> work(mouths_.size(), 0.0); // R a q_p^2 of the whole head: in < 0, out > 0
        for (std::size_t r = 0; r < mouths_.size(); ++r) {
            const Mouth<D>& mouth = mouths_[r];
            if (!history_[mouth.film] || mouth.kind == MouthKind::inflow ||
                std::abs(mean_flux_[r]) <= negligible_flux * largest)
                continue;
            const FilmPair<D>& pair = network_.films[mouth.film].pair;
            const MouthLaw law = law_(pair.master, pair.other);
            const bool smooth = mouth.kind == MouthKind::smooth;
            const double u = speed_[r];
            const double beyond =
                mouth.kind == MouthKind::open_side ? 0.0 : square(mouth.outward.dot(bulk_at_mouth_[r] - carried_[r]));
            Sum& sum = sums[history_[mouth.film]];
            // R a q_p^2 with a = dt u^2 / (2 R |q_p|), u of the step's mean
            const double head = 0.5 * dt_ * std::abs(predicted_flux_[r]);
            if (u < 0) {
                const double brought = smooth ? std::min(square(u), beyond) : 0.0;
                sum.bulk += head * brought;
                if (!smooth || !law.jet) {
                    work[r] = -head * (smooth ? square(u) - brought : (1 + law.entrance_loss) * square(u));
                    sum.in += head * (square(u) - brought);
                    sum.paid -= work[r];
                }
            }
            sum.leaves = sum.leaves || u > 0;
            if (u >= 0 && !smooth && !law.jet) {
                work[r] = head * std::max(square(u) - beyond, 0.0);
                sum.out += work[r];
            }
        }
        std::map<const FilmHistory<D>*, std::pair<double, double>> factor; // on the heads at entrances and exits
        for (auto& [old, sum] : sums) {
            const double debt = debt_of(debts, *sum.pair);
            const double gives = gives_.at(old) + sum.bulk - debt, left = sum.in + gives;
            double in = 1, out = sum.out > 0 ? std::clamp(left / sum.out, 0.0, 1.0) : 0.0;
            if (sum.in > 0 && (left < 0 || !sum.leaves))
                in = std::max(-gives, 0.0) / sum.in;
            factor[old] = {in, out};
            const double loss = in * sum.paid + gives_.at(old) + sum.bulk - out * sum.out - debt; // as expected
            flow.account.before[*sum.pair] = debt + std::max(loss, 0.0) - sum.bulk;
            flow.account.owed[*sum.pair] = debt;
            flow.account.planned[*sum.pair] = out * sum.out - in * sum.paid - gives_.at(old);
        }
        for (std::size_t r = 0; r < mouths_.size(); ++r) {
            const Mouth<D>& mouth = mouths_[r];
            double q = start_flux_[r], scale = 1, gain = 0;
            if (history_[mouth.film] && work[r] != 0 && predicted_flux_[r] != 0) {
                const auto [in, out] = factor.at(history_[mouth.film]);
                const double R = mouth.resistance / mouth.length;
                const double whole = std::abs(work[r]) / (R * square(predicted_flux_[r]));
                // What the whole head does not pay may take half of a mouth's flux; the rest remains a debt.
                const double a = work[r] > 0 ? out * whole : std::min(in * whole, std::max(whole, 1.0));
                gain = work[r] > 0 ? a : -a;
                if (work[r] > 0)
                    q += 2 * a * predicted_flux_[r];
                scale = 1 / (1 + a);
                q *= scale;
            }
            flow.mouth.push_back(q + (history_[mouth.film] ? mouth.length * mouth.section.dot(carried_[r]) : 0.0));
            flow.mouth_scale.push_back(scale);
            flow.account.gain.push_back(gain);
            flow.account.predicted.push_back(predicted_flux_[r]);
            flow.account.kept.push_back(start_flux_[r]);
            flow.account.carried.push_back(history_[mouth.film] ? mouth.length * mouth.section.dot(carried_[r]) : 0.0);
        }
    }

private:
    template <class F>
    void for_each_element(F&& f) const
    {
        for (std::size_t k = 0; k < network_.films.size(); ++k)
            for (std::size_t i = 0; i < network_.films[k].mesh.elements.size(); ++i)
                f(k, network_.films[k].first_element + i, network_.films[k].mesh.elements[i]);
    }

    // Velocity of the master's old motion at a point of its frame, in its new place.
    static Vec<D> moving_with(const FilmHistory<D>& history, const Vec<D>& x_body, const Mat<D>& rotation)
    {
        const Vec<D> at_old = history.master_velocity(x_body);
        const Vec<D> turn = rotation * history.rotation().transpose() * (at_old - history.master_velocity(history.centre()));
        return history.master_velocity(history.centre()) + turn;
    }

    // Fluxes relative to the master: kept from the old mouths, expected at the end of the step, mean.
    void mouth_fluxes(const std::vector<Vec<D>>& expected)
    {
        for (std::size_t r = 0; r < mouths_.size(); ++r) {
            const Mouth<D>& mouth = mouths_[r];
            const Film<D>& film = network_.films[mouth.film];
            const FilmHistory<D>* history = history_[mouth.film];
            if (!history) {
                carried_.push_back(Vec<D>::Zero());
                start_flux_.push_back(mouth.length * mouth.section.dot(bulk_at_mouth_[r]));
                mean_flux_.push_back(start_flux_.back());
                speed_.push_back(0);
                mouth_flow_.push_back({});
                continue;
            }
            const PlacedShape<D>& master = solids_[film.pair.master].shape;
            const Vec<D> x = master.to_body(mouth.x);
            const Vec<D> U = moving_with(*history, x, master.rotation());
            const int at = film.first_element + mouth.element;
            // The film's speed at its end, relative to the master: what was put in place, and expected.
            const double before = mouth.outward.dot(reference_[at]), after = mouth.outward.dot(expected[at]);
            const FilmElement<D>& end = film.mesh.elements[mouth.element];
            const FluidInPlace<D>& place = place_[at];
            const Vec<D> across = end.normal.dot(place.world - U) * end.normal; // what the walls carry it with
            const auto* old = history->nearest_mouth(x, mouth.outward);
            // The mouth's flux at the start, and with the energy that it had; volume times speed of the film's end at the start and expected.
            const double swept = mouth.length * mouth.section.dot(across); // part of the flux
            double flux = mouth.length * mouth.section.dot(reference_[at]) + swept, q = flux,
                   h = mouth.section.dot(mouth.outward), start = before, expects = after;
            if (old) {
                flux = mouth.length * (old->flux - old->section.dot(old->master_velocity));
                q = D == 2 && mouth.kind == MouthKind::smooth && !film.mesh.viscous
                        ? flux
                        : std::sqrt(old->resistance / mouth.resistance) * flux;
                h = 0.5 * (h + old->section.dot(old->outward));
                start = (place.volume + place.covered) * mouth.outward.dot(master.rotation() * place.velocity);
                expects = end.volume * after;
            }
            const double predicted = start != 0 && expects * start > 0 ? swept + (flux - swept) * expects / start : flux;
            carried_.push_back(U);
            start_flux_.push_back(q);
            predicted_flux_[r] = predicted;
            mean_flux_.push_back(0.5 * (flux + predicted));
            // Through mouths much thinner than their film the speed q/h has no meaning: no more than the film's own at its end.
            const double along = mean_flux_.back() - swept; // with the film's own speed
            const double through = std::abs(along) / (mouth.length * h), in_film = 2 * 0.5 * std::abs(before + after);
            double speed = std::min(through, in_film);
            // What enters by a smooth end without a head comes as the bulk brings it.
            if (mouth.kind == MouthKind::smooth && law_(film.pair.master, film.pair.other).jet && mean_flux_.back() < 0)
                speed = std::clamp(mouth.outward.dot(U - bulk_at_mouth_[r]), 0.0, speed);
            speed_.push_back(std::copysign(speed, mean_flux_.back()));
            Vec<D> entering = speed_.back() * mouth.outward;
            if (D == 3) // along the rim with the bulk's velocity
                entering += tangential<D>(bulk_at_mouth_[r] - U, mouth.outward);
            mouth_flow_.push_back({mean_flux_.back(), master.rotation().transpose() * entering, Vec<D>(U + across + entering)});
        }
    }

    const FilmNetwork<D>& network_;
    std::span<const Solid<D>> solids_;
    const std::vector<Mouth<D>>& mouths_;
    const std::function<MouthLaw(int, int)>& law_;
    double dt_;
    std::vector<const FilmHistory<D>*> history_; // of each film's pair; null: none
    std::vector<FluidInPlace<D>> place_;
    std::vector<Vec<D>> reference_;               // of elements, relative to the master, world axes
    std::vector<double> across_;                  // of elements, their speed across the film relative to the master
    std::vector<Vec<D>> bulk_at_mouth_, carried_; // at mouths: the bulk's velocity, the master's
    std::vector<double> start_flux_, predicted_flux_, mean_flux_, speed_;
    std::vector<MouthFlow<D>> mouth_flow_;
    std::map<const FilmHistory<D>*, double> gives_; // work of transport against the pressure, of each pair
};

} // namespace

template <int D>
FilmFlow<D> advect_films(const FilmNetwork<D>& network, std::span<const Solid<D>> solids, const FilmHistories<D>& histories,
                         const VelocitySampler<D>& grid_velocity, const std::function<MouthLaw(int, int)>& law,
                         const FilmDebts<D>& debts, double dt, double share)
{
    FilmMomentum<D> momentum(network, solids, histories, law, dt, share);
    FilmFlow<D> flow;
    momentum.cover(grid_velocity(momentum.bulk_places()), flow);
    momentum.carry(debts, flow);
    momentum.drive_mouths(debts, flow);
    flow.account.transported = flow.velocity;
    return flow;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template FilmFlow<D> advect_films<D>(const FilmNetwork<D>&, std::span<const Solid<D>>, const FilmHistories<D>&,            \
                                         const VelocitySampler<D>&, const std::function<MouthLaw(int, int)>&,                  \
                                         const FilmDebts<D>&, double, double);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
