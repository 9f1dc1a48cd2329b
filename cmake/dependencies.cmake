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
find_package(PNG REQUIRED) # with zlib: pictures and pages of gapflow report
if(GAPFLOW_OPENMP)
  find_package(OpenMP COMPONENTS CXX)
endif()
if(GAPFLOW_TESTS)
  find_package(GTest REQUIRED)
endif()
