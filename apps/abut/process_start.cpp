// SPDX-License-Identifier: BSD-3-Clause
#include "process_start.hpp"

#include <cstdlib>
#include <dlfcn.h>
#include <initializer_list>
#include <limits>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace abut::app {

namespace {

/// Arrays of the size of the matrix come and go with every linear system. Given back each time,
/// their pages would be mapped and cleared anew: a twentieth of a run.
void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

void start_mpi_lightly() {
  // Started alone, Open MPI would fork a daemon that nothing here needs and that may fail to start.
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  // It measures the processor's clock for a tenth of a second for each kind of fast network that it
  // knows; ranks of one machine, and one rank by itself, use none.
  const auto count = [](const char* variable) {
    const char* value = std::getenv(variable);
    return value ? std::atoi(value) : 1;
  };
  if (count("OMPI_COMM_WORLD_SIZE") == count("OMPI_COMM_WORLD_LOCAL_SIZE"))
    setenv("OMPI_MCA_pml", "ob1", 0);
}

/// Ranks would fight for the cores with each other's threads. Libraries read the variables as they
/// are loaded, and so before main: which of them are there is asked of the loader.
void take_one_thread() {
  for (const char* variable : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"})
    if (std::getenv(variable))
      return;
  for (const char* name : {"openblas_set_num_threads", "omp_set_num_threads"})
    if (void* setter = dlsym(RTLD_DEFAULT, name))
      reinterpret_cast<void (*)(int)>(setter)(1);
}

} // namespace

void prepare_process() {
  keep_freed_memory();
  start_mpi_lightly();
  take_one_thread();
}

} // namespace abut::app
