#include "gapflow/step/viscous_product.hpp"

#include "gapflow/core/sort_unique.hpp"
#include "gapflow/viscous/lattice_run.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace gapflow {

template <int D>
ViscousProduct<D>::ViscousProduct(const ViscousForm<D>& form, const Rows& form_of, double factor, int edges,
                                  const Eigen::SparseMatrix<double>& bodies)
    : edges_(edges), unknowns_(form_of.cols()), factor_(factor), bodies_(bodies)
{
    find_places(form, form_of);
    take_lattice(form.lattice);
    take_whole(form.whole);
    take_squares(form);
}

/// A column that is one unknown is that; others are functions, of which the form's derived ones are functions again.
template <int D>
void ViscousProduct<D>::find_places(const ViscousForm<D>& form, const Rows& form_of)
{
    place_.resize(form.all_columns());
    functions_.end.push_back(0); // 0, of columns at rest
    const auto next = [&] { return static_cast<std::int32_t>(unknowns_) + functions_.rows(); };
    for (int column = 0; column < form.columns(); ++column) {
        if (column == form.unknowns())
            first_of_twists_ = next();
        const int begin = form_of.outerIndexPtr()[column], count = form_of.outerIndexPtr()[column + 1] - begin;
        if (count == 0)
            continue;
        if (count == 1) {
            place_[column] = {form_of.innerIndexPtr()[begin], form_of.valuePtr()[begin]};
            continue;
        }
        place_[column] = {next(), 1};
        for (int k = begin; k < begin + count; ++k) {
            functions_.column.push_back(form_of.innerIndexPtr()[k]);
            functions_.factor.push_back(form_of.valuePtr()[k]);
        }
        functions_.end.push_back(static_cast<std::int64_t>(functions_.column.size()));
    }
    last_of_twists_ = next();
    for (int row = 0; row < form.derived.rows(); ++row) {
        place_[form.columns() + row] = {next(), 1};
        for (std::int64_t t = form.derived.end[row]; t < form.derived.end[row + 1]; ++t)
            if (const Place& place = place_[form.derived.column[t]]; place.at >= 0) {
                functions_.column.push_back(place.at);
                functions_.factor.push_back(form.derived.factor[t] * place.factor);
            }
        functions_.end.push_back(static_cast<std::int64_t>(functions_.column.size()));
    }
    first_moment_ = next();
    for (int k = form.columns() + form.derived.rows(); k < form.all_columns(); ++k)
        place_[k] = {static_cast<std::int32_t>(first_moment_) + k - form.columns() - form.derived.rows(), 1};
}

/// Runs go on where the unknowns do.
template <int D>
void ViscousProduct<D>::take_lattice(const Lattice<D>& lattice)
{
    for (const LatticeRun<D>& of : lattice.runs)
        for (std::int32_t i = 0; i < of.length; ++i) {
            const Place here = place_[of.first + i];
            std::array<Place, 2 * D> beside;
            bool equal = here.at >= 0;
            for (int k = 0; k < 2 * D; ++k) {
                beside[k] = place_[of.beside[k] + i];
                equal = equal && beside[k].at >= 0 && beside[k].factor == here.factor;
            }
            if (!equal) {
                for (const Place& other : beside)
                    if (here.at >= 0)
                        links_.push_back({here, other});
                continue;
            }
            bool goes_on = i > 0 && !runs_.empty() && here.at == runs_.back().first + runs_.back().length &&
                           factor_ * here.factor * here.factor == runs_.back().square;
            for (int k = 0; k < 2 * D && goes_on; ++k)
                goes_on = beside[k].at == runs_.back().beside[k] + runs_.back().length;
            if (goes_on) {
                ++runs_.back().length;
                continue;
            }
            runs_.push_back({here.at, 1, {}, factor_ * here.factor * here.factor});
            for (int k = 0; k < 2 * D; ++k)
                runs_.back().beside[k] = beside[k].at;
        }
    for (const auto& [face, other] : lattice.links)
        if (place_[face].at >= 0)
            links_.push_back({place_[face], place_[other]});
}

template <int D>
void ViscousProduct<D>::take_whole(const WholeFaces& whole)
{
    const auto zero = static_cast<std::int32_t>(unknowns_);
    for (const auto& columns : whole.columns) {
        Whole face;
        for (int k = 0; k < UnitFace::size; ++k)
            face.at[k] = place_[columns[k]].at >= 0 ? place_[columns[k]].at : zero;
        face.factor = place_[columns[UnitFace::traces]].factor;
        whole_.push_back(face);
    }
}

/// Rows of elements become matrices.
template <int D>
void ViscousProduct<D>::take_squares(const ViscousForm<D>& form)
{
    const auto add_rows = [&](const SquareSum& from, std::int64_t first, std::int64_t last, SquareSum& to) {
        for (std::int64_t k = first; k < last; ++k) {
            const std::size_t before = to.column.size();
            for (std::int64_t t = from.end[k]; t < from.end[k + 1]; ++t)
                if (const Place& place = place_[from.column[t]]; place.at >= 0) {
                    to.column.push_back(place.at);
                    to.factor.push_back(from.factor[t] * place.factor);
                }
            if (to.column.size() == before)
                continue;
            to.weight.push_back(factor_ * from.weight[k]);
            to.end.push_back(static_cast<std::int64_t>(to.column.size()));
        }
    };
    std::int64_t done = 0;
    for (const FormElement& element : form.elements) {
        add_rows(form.squares, done, element.first, squares_);
        add_element(form.squares, element.first, element.last);
        done = element.last;
    }
    add_rows(form.squares, done, form.squares.rows(), squares_);
    add_rows(form.rotation, 0, form.rotation.rows(), rotation_);
}

template <int D>
void ViscousProduct<D>::add_element(const SquareSum& squares, std::int64_t first, std::int64_t last)
{
    std::vector<std::int32_t> at;
    for (std::int64_t t = squares.end[first]; t < squares.end[last]; ++t)
        if (const std::int32_t place = place_[squares.column[t]].at; place >= 0)
            at.push_back(place);
    sort_unique(at);
    const auto n = static_cast<Eigen::Index>(at.size());
    if (n == 0)
        return;
    const std::size_t begin = elements_.matrix.size();
    elements_.matrix.resize(begin + n * n, 0.0);
    Eigen::Map<Eigen::MatrixXd> matrix(elements_.matrix.data() + begin, n, n);
    Vector row(n);
    for (std::int64_t k = first; k < last; ++k) {
        row.setZero();
        for (std::int64_t t = squares.end[k]; t < squares.end[k + 1]; ++t)
            if (const Place& place = place_[squares.column[t]]; place.at >= 0)
                row[std::lower_bound(at.begin(), at.end(), place.at) - at.begin()] += squares.factor[t] * place.factor;
        for (Eigen::Index j = 0; j < n; ++j)
            if (const double by = factor_ * squares.weight[k] * row[j]; by != 0)
                matrix.col(j) += by * row;
    }
    elements_.at.insert(elements_.at.end(), at.begin(), at.end());
    elements_.end.push_back(static_cast<std::int64_t>(elements_.at.size()));
    elements_.entry.push_back(static_cast<std::int64_t>(elements_.matrix.size()));
}

template <int D>
std::vector<Eigen::Triplet<double>> ViscousProduct<D>::friction_of_bodies() const
{
    constexpr int T = twist_size<D>;
    const Eigen::Index n = bodies_.cols(), first = unknowns_ - n;
    std::vector<TwistMatrix<D>> own(n / T, TwistMatrix<D>::Zero());
    std::map<std::pair<int, int>, TwistMatrix<D>> others;
    std::vector<std::pair<int, Twist<D>>> motions; // of bodies, what a row has of each
    const auto add_term = [&](Eigen::Index at, double factor) {
        const int body = static_cast<int>((at - first) / T);
        if (motions.empty() || motions.back().first != body) {
            const auto found =
                std::find_if(motions.begin(), motions.end(), [&](const auto& motion) { return motion.first == body; });
            if (found != motions.end())
                std::swap(*found, motions.back());
            else
                motions.emplace_back(body, Twist<D>::Zero());
        }
        motions.back().second[(at - first) % T] += factor;
    };
    const auto find_terms = [&](std::int32_t at, double factor) {
        if (at >= first && at < unknowns_)
            add_term(at, factor);
        else if (at >= first_of_twists_ && at < last_of_twists_)
            for (std::int64_t t = functions_.end[at - unknowns_]; t < functions_.end[at - unknowns_ + 1]; ++t)
                add_term(functions_.column[t], factor * functions_.factor[t]);
    };
    const auto add = [&](const std::pair<int, Twist<D>>& a, const std::pair<int, Twist<D>>& b, double weight) {
        TwistMatrix<D>& block =
            a.first == b.first ? own[a.first] : others.try_emplace({a.first, b.first}, TwistMatrix<D>::Zero()).first->second;
        block += weight * a.second * b.second.transpose();
    };
    for (const SquareSum* sum : {&squares_, &rotation_})
        for (std::int64_t k = 0; k < sum->rows(); ++k) {
            motions.clear();
            for (std::int64_t t = sum->end[k]; t < sum->end[k + 1]; ++t)
                find_terms(sum->column[t], sum->factor[t]);
            for (const auto& a : motions)
                for (const auto& b : motions)
                    add(a, b, sum->weight[k]);
        }
    for (std::size_t e = 0; e + 1 < elements_.end.size(); ++e) {
        const Eigen::Index size = elements_.end[e + 1] - elements_.end[e];
        const double* matrix = elements_.matrix.data() + elements_.entry[e];
        const std::int32_t* at = elements_.at.data() + elements_.end[e];
        for (Eigen::Index a = 0; a < size; ++a) {
            motions.clear();
            find_terms(at[a], 1);
            const auto columns = motions;
            motions.clear();
            for (Eigen::Index b = 0; b < size && !columns.empty(); ++b)
                find_terms(at[b], matrix[a * size + b]);
            for (const auto& column : columns)
                for (const auto& row : motions)
                    add(row, column, 1);
        }
    }
    std::vector<Eigen::Triplet<double>> entries;
    const auto put = [&](int a, int b, const TwistMatrix<D>& block) {
        for (int k = 0; k < T * T; ++k)
            entries.emplace_back(T * a + k / T, T * b + k % T, block(k / T, k % T));
    };
    for (std::size_t b = 0; b < own.size(); ++b)
        put(static_cast<int>(b), static_cast<int>(b), own[b]);
    for (const auto& [pair, block] : others)
        put(pair.first, pair.second, block);
    return entries;
}

template <int D>
void ViscousProduct<D>::find_functions(Vector& x) const
{
    const std::span<const double> all(x.data(), static_cast<std::size_t>(x.size()));
    for (int row = 0; row < functions_.rows(); ++row)
        x[unknowns_ + row] = functions_.value(row, all);
    const Eigen::Matrix<double, 2, UnitFace::size> moment = unit_face().moment;
    for (std::size_t f = 0; f < whole_.size(); ++f) {
        Eigen::Matrix<double, UnitFace::size, 1> slots;
        for (int k = 0; k < UnitFace::traces; ++k)
            slots[k] = x[whole_[f].at[k]];
        slots[UnitFace::traces] = whole_[f].factor * x[whole_[f].at[UnitFace::traces]];
        x.segment<2>(first_moment_ + 2 * static_cast<Eigen::Index>(f)) = moment.lazyProduct(slots);
    }
}

template <int D>
void ViscousProduct<D>::add_whole(const Vector& x, Vector& y) const
{
    const Eigen::Matrix<double, UnitFace::size, UnitFace::size> stiffness = factor_ * unit_face().stiffness;
    const Eigen::Matrix<double, UnitFace::size, 2> moment = unit_face().moment.transpose();
    for (std::size_t f = 0; f < whole_.size(); ++f) {
        const Whole& face = whole_[f];
        Eigen::Matrix<double, UnitFace::size, 1> slots;
        for (int k = 0; k < UnitFace::traces; ++k)
            slots[k] = x[face.at[k]];
        slots[UnitFace::traces] = face.factor * x[face.at[UnitFace::traces]];
        const Eigen::Vector2d both = y.segment<2>(first_moment_ + 2 * static_cast<Eigen::Index>(f));
        Eigen::Matrix<double, UnitFace::size, 1> by = stiffness.lazyProduct(slots);
        by.noalias() += moment.lazyProduct(both);
        for (int k = 0; k < UnitFace::traces; ++k)
            y[face.at[k]] += by[k];
        y[face.at[UnitFace::traces]] += face.factor * by[UnitFace::traces];
    }
}

template <int D>
void ViscousProduct<D>::add_elements(const Vector& x, Vector& y) const
{
    constexpr Eigen::Index most = 64;
    std::array<double, most> few_by, few_of;
    std::vector<double> many(2 * most);
    for (std::size_t e = 0; e + 1 < elements_.end.size(); ++e) {
        const std::int32_t* at = elements_.at.data() + elements_.end[e];
        const Eigen::Index n = elements_.end[e + 1] - elements_.end[e];
        if (n > most)
            many.resize(std::max<std::size_t>(many.size(), 2 * n));
        double* by = n > most ? many.data() : few_by.data();
        double* of = n > most ? many.data() + n : few_of.data();
        for (Eigen::Index k = 0; k < n; ++k) {
            of[k] = x[at[k]];
            by[k] = 0;
        }
        const double* column = elements_.matrix.data() + elements_.entry[e];
        for (Eigen::Index j = 0; j < n; ++j, column += n)
            for (Eigen::Index k = 0; k < n; ++k)
                by[k] += column[k] * of[j];
        for (Eigen::Index k = 0; k < n; ++k)
            y[at[k]] += by[k];
    }
}

/// Backwards: what depends on others first.
template <int D>
void ViscousProduct<D>::give_functions(Vector& y) const
{
    for (int row = functions_.rows() - 1; row >= 0; --row) {
        const double by = y[unknowns_ + row];
        for (std::int64_t t = functions_.end[row]; t < functions_.end[row + 1]; ++t)
            y[functions_.column[t]] += functions_.factor[t] * by;
    }
}

template <int D>
void ViscousProduct<D>::apply(Vector& x, Vector& y) const
{
    find_functions(x);
    y.resize(size());
    y.head(edges_) = x.head(edges_);
    y.tail(size() - edges_).setZero();
    const Eigen::Index n = bodies_.cols();
    if (n > 0)
        y.segment(unknowns_ - n, n).noalias() += bodies_ * x.segment(unknowns_ - n, n);
    for (const Run& run : runs_)
        add_run<D>(run, run.square, x.data(), y.data());
    for (const auto& [at, other] : links_)
        y[at.at] += factor_ * at.factor * (at.factor * x[at.at] - (other.at >= 0 ? other.factor * x[other.at] : 0.0));
    const std::span<const double> from(x.data(), static_cast<std::size_t>(x.size()));
    const std::span<double> to(y.data(), static_cast<std::size_t>(y.size()));
    add_elements(x, y);
    squares_.add_product(from, to);
    rotation_.add_product(from, to);
    add_whole(x, y);
    give_functions(y);
}

template class ViscousProduct<2>;
template class ViscousProduct<3>;

} // namespace gapflow
