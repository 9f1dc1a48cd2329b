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
ViscousTraces<D>::ViscousTraces(const ViscousColumns<D>& columns, const Eigen::SparseMatrix<double>& free,
                                const Vector& resistance)
    : columns_(columns), first_(columns.trace(0)), means_(columns.means() * Rows(free)), scale_(resistance.size()), alone_(Vector::Zero(resistance.size()))
{
    const RowList& beside = columns.of_form().beside;
    for (Eigen::Index k = 0; k < scale_.size(); ++k) {
        const double faces = static_cast<double>(beside.end[k + 1] - beside.end[k]);
        alone_[k] = faces > 0 ? 0 : 1;
        scale_[k] = resistance[k] > 0 ? 1 / std::sqrt(resistance[k] * std::max(1.0, faces)) : 0.0;
    }
    for (Eigen::Index k = 0; k < means_.nonZeros(); ++k)
        pulled_.push_back(means_.innerIndexPtr()[k]);
    sort_unique(pulled_);
    std::vector<Eigen::Triplet<double>> entries;
    for (int trace = 0; trace < means_.rows(); ++trace)
        for (typename Rows::InnerIterator entry(means_, trace); entry; ++entry)
            entries.emplace_back(
                static_cast<int>(std::lower_bound(pulled_.begin(), pulled_.end(), entry.col()) - pulled_.begin()), trace,
                entry.value());
    pull_.resize(static_cast<int>(pulled_.size()), means_.rows());
    pull_.setFromTriplets(entries.begin(), entries.end());
    find_elements();
}

template <int D>
Eigen::VectorXd ViscousTraces<D>::pull(Vector& residual) const
{
    const Vector pulled = pull_ * residual.segment(first_, scale_.size());
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
    change.noalias() += means_ * z;
    z.segment(first_, scale_.size()) = change;
}

template class ViscousTraces<2>;
template class ViscousTraces<3>;

} // namespace gapflow
