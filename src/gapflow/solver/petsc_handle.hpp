// Owning, move-only handles of PETSc objects.
#pragma once

#include "gapflow/core/error.hpp"

#include <petscksp.h>

#include <string>
#include <utility>

namespace gapflow {

/// Throws ComputationError if a PETSc call failed.
inline void check_petsc(PetscErrorCode code, const char* what)
{
    if (code != 0)
        throw ComputationError(std::string("PETSc: ") + what + " failed with error " + std::to_string(code));
}

/// Owns one PETSc object; `destroy` is its XxxDestroy function.
template <class T, PetscErrorCode (*destroy)(T*)>
class PetscHandle {
public:
    PetscHandle() = default;
    explicit PetscHandle(T object) : object_(object) {}
    PetscHandle(const PetscHandle&) = delete;
    PetscHandle& operator=(const PetscHandle&) = delete;
    PetscHandle(PetscHandle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
    PetscHandle& operator=(PetscHandle&& other) noexcept
    {
        std::swap(object_, other.object_);
        return *this;
    }
    ~PetscHandle()
    {
        if (object_)
            destroy(&object_);
    }
    /// The raw object; still owned.
    T get() const { return object_; }
    /// Where a XxxCreate function puts a new object; only while empty.
    T* out() { return &object_; }

private:
    T object_ = nullptr;
};

using PetscVector = PetscHandle<::Vec, VecDestroy>;
using PetscMatrix = PetscHandle<::Mat, MatDestroy>;
using PetscSolver = PetscHandle<KSP, KSPDestroy>;
using PetscPreconditioner = PetscHandle<PC, PCDestroy>;

} // namespace gapflow
