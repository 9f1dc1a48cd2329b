#include "gapflow/step/viscous_traces.hpp"

#include "gapflow/core/sort_unique.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace gapflow {
namespace {

constexpr double least = 0.02; // of a mode of a face's traces, over its diagonal: slivers have some without resistance

}

template <int D>
ViscousTraces<D>::ViscousTraces(const ViscousColumns<D>& columns, const Eigen::SparseMatrix<double>& free,
                                const Vector& resistance)
    : columns_(columns), first_(columns.trace(0)), means_(columns.means() * Rows(free)), pulled_(means_.transpose()),
      scale_(resistance.size()), alone_(Vector::Zero(resistance.size()))
{
    const RowList& beside = columns.of_form().beside;
    for (Eigen::Index k = 0; k < scale_.size(); ++k) {
        const double faces = static_cast<double>(beside.end[k + 1] - beside.end[k]);
        alone_[k] = faces > 0 ? 0 : 1;
        scale_[k] = resistance[k] > 0 ? 1 / std::sqrt(resistance[k] * std::max(1.0, faces)) : 0.0;
    }
    find_elements();
}

template <int D>
void ViscousTraces<D>::find_elements()
{
    const ViscousForm<D>& form = columns_.of_form();
    const std::vector<double> diagonal = form.diagonal();
    const auto number = [&](std::int32_t column) {
        return column >= form.velocities() && column < form.unknowns() ? column - form.velocities() : -1;
    };
    for (const FormElement& of : form.elements) {
        Element element;
        for (std::int64_t t = form.squares.end[of.first]; t < form.squares.end[of.last]; ++t)
            if (const int trace = number(form.squares.column[t]); trace >= 0)
                element.traces.push_back(trace);
        sort_unique(element.traces);
        const auto n = static_cast<Eigen::Index>(element.traces.size());
        Eigen::MatrixXd block = Eigen::MatrixXd::Zero(n, n);
        for (std::int64_t k = of.first; k < of.last; ++k) {
            Vector row = Vector::Zero(n);
            for (std::int64_t t = form.squares.end[k]; t < form.squares.end[k + 1]; ++t)
                if (const int trace = number(form.squares.column[t]); trace >= 0) {
                    const auto at = std::lower_bound(element.traces.begin(), element.traces.end(), trace);
                    row[at - element.traces.begin()] += form.squares.factor[t] / std::sqrt(diagonal[form.velocities() + trace]);
                }
            block += form.squares.weight[k] * row * row.transpose();
        }
        block.diagonal().setOnes();
        if (n > 0) {
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(block);
            element.inverse = modes.eigenvectors() * modes.eigenvalues().cwiseMax(least).cwiseInverse().asDiagonal() *
                              modes.eigenvectors().transpose();
        }
        elements_.push_back(std::move(element));
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
    for (const Element& element : elements_)
        for (std::size_t i = 0; i < element.traces.size(); ++i) {
            double sum = 0;
            for (std::size_t j = 0; j < element.traces.size(); ++j)
                sum += element.inverse(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) * r[element.traces[j]];
            change[element.traces[i]] += sum;
        }
    z.segment(first_, scale_.size()).setZero();
    change.array() *= scale_.array();
    change.noalias() += means_ * z;
    z.segment(first_, scale_.size()) = change;
}

template class ViscousTraces<2>;
template class ViscousTraces<3>;

} // namespace gapflow
