#include "gapflow/film/film_account.hpp"

#include <cmath>

namespace gapflow {

namespace {

// Of a pair's energy: a larger gain than planned in a step is not left to the next one (random scene 59). Much less, and the
// heads of a flow that is driven faster and faster are undone (docs/how-to/valve.md).
constexpr double surprise = 0.02;

// Energy over the density that the films of each pair gained by transport and heads.
template <int D>
FilmDebts<D> gains(const FilmNetwork<D>& network, const FilmAccount<D>& account, const std::vector<Vec<D>>& velocity,
                   const std::vector<double>& mouth)
{
    FilmDebts<D> result;
    for (const Film<D>& film : network.films)
        for (std::size_t k = 0; k < film.mesh.elements.size(); ++k) {
            const std::size_t i = film.first_element + k;
            result[film.pair] += film.mesh.elements[k].volume *
                                 (velocity[i] - account.master[i]).dot(account.transported[i] - account.reference[i]);
        }
    for (std::size_t r = 0; r < mouth.size(); ++r) {
        const Mouth<D>& m = network.rim.mouths[r];
        const double q = mouth[r] - account.carried[r], a = account.gain[r];
        result[network.films[m.film].pair] +=
            m.resistance / m.length * q * (a > 0 ? a * (2 * account.predicted[r] - q) : a * q);
    }
    return result;
}

} // namespace

template <int D>
FilmDebts<D> film_energy(const FilmNetwork<D>& network, const FilmAccount<D>& account, const std::vector<Vec<D>>& velocity,
                         const std::vector<double>& mouth)
{
    FilmDebts<D> energy;
    for (const Film<D>& film : network.films)
        for (std::size_t k = 0; k < film.mesh.elements.size(); ++k) {
            const std::size_t i = film.first_element + k;
            energy[film.pair] += 0.5 * film.mesh.elements[k].volume * (velocity[i] - account.master[i]).squaredNorm();
        }
    for (std::size_t r = 0; r < mouth.size(); ++r) {
        const Mouth<D>& m = network.rim.mouths[r];
        energy[network.films[m.film].pair] += 0.5 * m.resistance / m.length * std::pow(mouth[r] - account.carried[r], 2);
    }
    return energy;
}

template <int D>
FilmDebts<D> energy_in_place(const FilmNetwork<D>& network, const FilmAccount<D>& account)
{
    std::vector<double> mouth = account.carried;
    for (std::size_t r = 0; r < mouth.size(); ++r)
        mouth[r] += account.kept[r];
    return film_energy(network, account, account.reference, mouth);
}

template <int D>
std::set<FilmPair<D>> mispredicted_films(const FilmNetwork<D>& network, const FilmAccount<D>& account,
                                         const std::vector<Vec<D>>& velocity, const std::vector<double>& mouth)
{
    FilmDebts<D> energy = energy_in_place(network, account);
    std::set<FilmPair<D>> result;
    for (const auto& [pair, gain] : gains(network, account, velocity, mouth)) {
        const auto planned = account.planned.find(pair);
        if (planned != account.planned.end() && !account.rebounding.contains(pair) && gain > 0 &&
            gain - planned->second > surprise * energy[pair])
            result.insert(pair);
    }
    return result;
}

template <int D>
void take_back_transport(const FilmNetwork<D>& network, const std::set<FilmPair<D>>& pairs, FilmAccount<D>& account,
                         std::vector<Vec<D>>& velocity, std::vector<double>& mouth, std::vector<double>& factor)
{
    for (const Film<D>& film : network.films)
        for (std::size_t k = 0; k < film.mesh.elements.size() && pairs.contains(film.pair); ++k) {
            const std::size_t i = film.first_element + k;
            velocity[i] = account.transported[i] = account.reference[i];
        }
    factor.assign(mouth.size(), 1.0);
    for (std::size_t r = 0; r < mouth.size(); ++r)
        if (pairs.contains(network.films[network.rim.mouths[r].film].pair)) {
            mouth[r] = account.carried[r] + account.kept[r];
            factor[r] = 1 + std::abs(account.gain[r]);
            account.gain[r] = 0;
        }
    for (const FilmPair<D>& pair : pairs)
        account.before[pair] = account.owed[pair];
}

template <int D>
FilmDebts<D> settle_films(const FilmNetwork<D>& network, const FilmAccount<D>& account, const std::vector<Vec<D>>& velocity,
                          const std::vector<double>& mouth, double dt, std::vector<Vec<D>>& increment)
{
    FilmDebts<D> debts = account.before;
    increment.assign(velocity.size(), Vec<D>::Zero());
    if (account.reference.size() != velocity.size())
        return debts;
    for (std::size_t i = 0; i < velocity.size(); ++i)
        increment[i] = (velocity[i] - account.reference[i]) / dt;
    for (const auto& [pair, gain] : gains(network, account, velocity, mouth))
        debts[pair] += gain;
    for (const FilmPair<D>& pair : account.rebounding)
        if (const auto owed = account.owed.find(pair); owed != account.owed.end())
            debts[pair] = owed->second;
        else
            debts.erase(pair);
    // What transport lost is not given back: contacts take from it, and heads that give it back drive jets (method, "Film transport", debt).
    std::erase_if(debts, [](const auto& debt) { return debt.second <= 0; });
    return debts;
}

#define GAPFLOW_INSTANTIATE(D)                                                                                                 \
    template FilmDebts<D> film_energy<D>(const FilmNetwork<D>&, const FilmAccount<D>&, const std::vector<Vec<D>>&,             \
                                         const std::vector<double>&);                                                          \
    template FilmDebts<D> energy_in_place<D>(const FilmNetwork<D>&, const FilmAccount<D>&);                                    \
    template std::set<FilmPair<D>> mispredicted_films<D>(const FilmNetwork<D>&, const FilmAccount<D>&,                         \
                                                         const std::vector<Vec<D>>&, const std::vector<double>&);              \
    template void take_back_transport<D>(const FilmNetwork<D>&, const std::set<FilmPair<D>>&, FilmAccount<D>&,                 \
                                         std::vector<Vec<D>>&, std::vector<double>&, std::vector<double>&);                    \
    template FilmDebts<D> settle_films<D>(const FilmNetwork<D>&, const FilmAccount<D>&, const std::vector<Vec<D>>&,            \
                                          const std::vector<double>&, double, std::vector<Vec<D>>&);
GAPFLOW_INSTANTIATE(2)
GAPFLOW_INSTANTIATE(3)
#undef GAPFLOW_INSTANTIATE

} // namespace gapflow
