#include "gapflow/step/viscous_traces.hpp"

#include "gapflow/core/sort_unique.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace gapflow {
namespace {

constexpr double least = 0.02; // more resistance of a face's traces, over their diagonal: slivers have modes without any

}

template <int D>
ViscousTraces<D>::ViscousTraces(const ViscousColumns<D>& columns, const Rows& form_of, const Vector& resistance)
    : columns_(columns), first_(columns.trace(0)), scale_(resistance.size()), alone_(Vector::Zero(resistance.size()))
{
    const RowList& beside = columns.of_form().beside;
    for (Eigen::Index k = 0; k < scale_.size(); ++k) {
        const double faces = static_cast<double>(beside.end[k + 1] - beside.end[k]);
        alone_[k] = faces > 0 ? 0 : 1;
        scale_[k] = resistance[k] > 0 ? 1 / std::sqrt(resistance[k] * std::max(1.0, faces)) : 0.0;
    }
    find_means(form_of);
    find_elements();
}

template <int D>
void ViscousTraces<D>::find_means(const Rows& form_of)
{
    const RowList& beside = columns_.of_form().beside;
    std::vector<std::int32_t> number(form_of.cols(), 0); // first how often, then where
    for (int trace = 0; trace < beside.rows(); ++trace) {
        for (std::int64_t t = beside.end[trace]; t < beside.end[trace + 1]; ++t)
            for (typename Rows::InnerIterator entry(form_of, beside.column[t]); entry; ++entry) {
                means_.column.push_back(static_cast<std::int32_t>(entry.col()));
                means_.factor.push_back(beside.factor[t] * entry.value());
                ++number[entry.col()];
            }
        means_.end.push_back(static_cast<std::int64_t>(means_.column.size()));
    }
    std::vector<std::int64_t> next;
    for (std::size_t k = 0; k < number.size(); ++k)
        if (number[k] > 0) {
            next.push_back(pull_.end.back());
            pull_.end.push_back(pull_.end.back() + number[k]);
            number[k] = static_cast<std::int32_t>(pulled_.size());
            pulled_.push_back(static_cast<int>(k));
        }
    pull_.column.resize(pull_.end.back());
    pull_.factor.resize(pull_.end.back());
    for (int trace = 0; trace < means_.rows(); ++trace)
        for (std::int64_t t = means_.end[trace]; t < means_.end[trace + 1]; ++t) {
            const std::int64_t at = next[number[means_.column[t]]]++;
            pull_.column[at] = trace;
            pull_.factor[at] = means_.factor[t];
        }
}

template <int D>
Eigen::VectorXd ViscousTraces<D>::pull(Vector& residual) const
{
    const std::span<const double> of_traces(residual.data() + first_, static_cast<std::size_t>(scale_.size()));
    Vector pulled(pulled_.size());
    for (int k = 0; k < pull_.rows(); ++k)
        pulled[k] = pull_.value(k, of_traces);
    for (std::size_t k = 0; k < pulled_.size(); ++k)
        residual[pulled_[k]] += pulled[static_cast<Eigen::Index>(k)];
    return pulled;
}

template <int D>
void ViscousTraces<D>::release(const Vector& pulled, Vector& residual) const
{
    for (std::size_t k = 0; k < pulled_.size(); ++k)
        residual[pulled_[k]] -= pulled[static_cast<Eigen::Index>(k)];
}

template <int D>
void ViscousTraces<D>::find_elements()
{
    const ViscousForm<D>& form = columns_.of_form();
    const std::vector<double> diagonal = form.diagonal();
    const auto number = [&](std::int32_t column) {
        return column >= form.velocities() && column < form.unknowns() ? column - form.velocities() : -1;
    };
    std::vector<std::int32_t> traces;
    for (const FormElement& of : form.elements) {
        traces.clear();
        for (std::int64_t t = form.squares.end[of.first]; t < form.squares.end[of.last]; ++t)
            if (const int trace = number(form.squares.column[t]); trace >= 0)
                traces.push_back(trace);
        sort_unique(traces);
        const auto n = static_cast<Eigen::Index>(traces.size());
        Eigen::MatrixXd block = Eigen::MatrixXd::Zero(n, n);
        for (std::int64_t k = of.first; k < of.last; ++k) {
            Vector row = Vector::Zero(n);
            for (std::int64_t t = form.squares.end[k]; t < form.squares.end[k + 1]; ++t)
                if (const int trace = number(form.squares.column[t]); trace >= 0) {
                    const auto at = std::lower_bound(traces.begin(), traces.end(), trace);
                    row[at - traces.begin()] += form.squares.factor[t] / std::sqrt(diagonal[form.velocities() + trace]);
                }
            block += form.squares.weight[k] * row * row.transpose();
        }
        block.diagonal().setConstant(1 + least);
        trace_.insert(trace_.end(), traces.begin(), traces.end());
        end_.push_back(static_cast<std::int64_t>(trace_.size()));
        const std::size_t begin = inverse_.size();
        inverse_.resize(begin + n * n);
        if (n > 0)
            Eigen::Map<Eigen::MatrixXd>(inverse_.data() + begin, n, n) = block.llt().solve(Eigen::MatrixXd::Identity(n, n));
        entry_.push_back(static_cast<std::int64_t>(inverse_.size()));
    }
}

template <int D>
void ViscousTraces<D>::follow(const Vector& residual, Vector& z) const
{
    constexpr int traces = UnitFace::traces;
    const ViscousForm<D>& form = columns_.of_form();
    const Eigen::Matrix<double, traces, traces> inverse = unit_face().inverse;
    const Vector r = residual.segment(first_, scale_.size()).cwiseProduct(scale_);
    Vector change = r.cwiseProduct(alone_);
    const std::int32_t first = form.velocities(), last = form.unknowns();
    for (const auto& face : form.whole.columns) {
        Eigen::Matrix<double, traces, 1> own;
        for (int k = 0; k < traces; ++k)
            own[k] = face[k] < last ? r[face[k] - first] : 0.0;
        const Eigen::Matrix<double, traces, 1> by = inverse * own;
        for (int k = 0; k < traces; ++k)
            if (face[k] < last)
                change[face[k] - first] += by[k];
    }
    for (std::size_t e = 0; e + 1 < end_.size(); ++e) {
        const double* entry = inverse_.data() + entry_[e];
        for (std::int64_t i = end_[e]; i < end_[e + 1]; ++i) {
            double sum = 0;
            for (std::int64_t j = end_[e]; j < end_[e + 1]; ++j)
                sum += *entry++ * r[trace_[j]];
            change[trace_[i]] += sum;
        }
    }
    change.array() *= scale_.array();
    const std::span<const double> others(z.data(), static_cast<std::size_t>(z.size()));
    for (int trace = 0; trace < means_.rows(); ++trace)
        change[trace] += means_.value(trace, others);
    z.segment(first_, scale_.size()) = change;
}

template class ViscousTraces<2>;
template class ViscousTraces<3>;

} // namespace gapflow
