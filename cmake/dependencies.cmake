# Debian 12: see tools/install-dependencies for the packages.
find_package(PkgConfig REQUIRED)
find_package(MPI REQUIRED COMPONENTS C CXX)
pkg_check_modules(PETSC REQUIRED IMPORTED_TARGET PETSc)
pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5-openmpi) # checkpoints; the build that PETSc links
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(tomlplusplus 3.3 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Threads REQUIRED)
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED) # for METIS' order of elimination
find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
find_package(PNG REQUIRED) # with zlib: pictures and pages of gapflow report
if(GAPFLOW_OPENMP)
  find_package(OpenMP COMPONENTS CXX)
endif()
if(GAPFLOW_TESTS)
  find_package(GTest REQUIRED)
endif()

# The Python package is for the system's own python unless -DPython_EXECUTABLE names another: Debian's pybind11 and NumPy belong to it.
if(NOT Python_EXECUTABLE)
  find_program(Python_EXECUTABLE NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH DOC "python of the package gapflow")
endif()
find_package(Python COMPONENTS Interpreter Development.Module)
if(Python_Development.Module_FOUND)
  find_package(pybind11 2.10 QUIET)
endif()
