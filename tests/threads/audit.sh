#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Shows that the kernels give the right answer on several threads. Debian's Kokkos has one, so the
# source of its Trilinos is fetched, and Kokkos and Sacado are built from it with OpenMP and, for
# ThreadSanitizer, with C++ threads (libgomp's own synchronisation is unknown to it). The packages that
# need no more are built against each. Then: unit tests on 4 threads with both, and kernel_results with
# both against a build on Debian's own Kokkos, to 1e-13 of the largest value of each array.
# Usage: tests/threads/audit.sh BUILD JOBS. Exit status 77 where the source cannot be had.
set -euo pipefail

repository=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$1/threads"
work=$(cd "$1/threads" && pwd)
jobs=$2
source=$work/source
export OMPI_MCA_ess_singleton_isolated=1 OMP_PROC_BIND=false OMP_WAIT_POLICY=passive
# Kokkos does not join its threads.
export TSAN_OPTIONS="suppressions=$repository/tests/threads/tsan.supp ignore_noninstrumented_modules=1
  report_thread_leaks=0"

skip() {
  echo "audit-threads: skipped: $1" >&2
  exit 77
}

# Downloads with apt's lists, state and cache in folders of their own: no root, nothing left behind.
fetch_source() (
  local version
  [ ! -e "$source/.complete" ] || return 0
  version=$(dpkg-query -W -f '${source:Version}' libtrilinos-kokkos-dev 2>/dev/null) ||
    skip "Trilinos is no Debian package here"
  rm -rf "$source" && mkdir -p "$source" "$work/apt/lists/partial" "$work/apt/cache/archives/partial"
  # shellcheck disable=SC2016  # these belong to apt-get
  apt-get indextargets --format 'deb-src $(REPO_URI) $(RELEASE) main' \
    'Created-By: Packages' 'Origin: Debian' | sort -u >"$work/apt/sources.list"
  local apt=(apt-get -qq -o Dir::Etc::SourceList="$work/apt/sources.list" -o Dir::Etc::SourceParts=-
    -o Dir::State="$work/apt" -o Dir::State::status=/var/lib/dpkg/status -o Dir::Cache="$work/apt/cache"
    -o APT::Sandbox::User=)
  if ! { "${apt[@]}" update && cd "$work/apt" &&
    "${apt[@]}" source --download-only "trilinos=$version"; }; then
    skip "apt-get cannot fetch the source of trilinos $version"
  fi
  tar -xf "$work/apt"/trilinos_*.orig.tar.* -C "$source" --strip-components=1 \
    --wildcards --no-wildcards-match-slash \
    '*/[A-Z]*' '*/cmake' '*/commonTools' '*/packages/kokkos' '*/packages/sacado'
  show_hand_over
  touch "$source/.complete"
)

# Kokkos's threads hand work over by a volatile int and fences, which the sanitizer cannot follow: every
# loop would race with what comes before and after. The same int as an atomic says what is meant. So does
# an atomic load where atomic_fetch_add first reads what it then compares and swaps.
show_hand_over() {
  local threads=$source/packages/kokkos/core/src/Threads
  local wait='template <class T>\nvoid spinwait_while_equal(std::atomic<T> \&flag, T value) {'
  wait+='\n  while (flag == value)\n    std::this_thread::yield();\n}\n\n'
  sed -i -e 's/int volatile m_pool_state;/std::atomic<int> m_pool_state;/' \
    -e 's/int volatile &state()/std::atomic<int> \&state()/' \
    -e 's/wait_yield(volatile int &, const int);/wait_yield(std::atomic<int> \&, const int);/' \
    -e "s/^class ThreadsExec {/$wait&/" \
    -e '0,/#include <cstdio>/s//#include <atomic>\n#include <cstdio>\n#include <thread>/' \
    "$threads/Kokkos_ThreadsExec.hpp"
  sed -i 's/wait_yield(volatile int& flag/wait_yield(std::atomic<int>\& flag/' \
    "$threads/Kokkos_ThreadsExec_base.cpp"
  sed -i 's/oldval.t = \*dest;/__atomic_load(const_cast<T*>(dest), \&oldval.t, __ATOMIC_RELAXED);/' \
    "$threads/../impl/Kokkos_Atomic_Fetch_Add.hpp"
}

# build_trilinos NAME OPTION...: Kokkos and Sacado in a folder of their own.
build_trilinos() {
  local build=$work/$1/trilinos
  cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    -DCMAKE_INSTALL_PREFIX="$work/$1/installed" -DTrilinos_ASSERT_MISSING_PACKAGES=OFF \
    -DTrilinos_ENABLE_ALL_OPTIONAL_PACKAGES=OFF -DTrilinos_ENABLE_TESTS=OFF \
    -DTrilinos_ENABLE_Fortran=OFF -DTrilinos_ENABLE_Kokkos=ON -DTrilinos_ENABLE_Sacado=ON \
    "${@:2}" >"$build.log" 2>&1 || { tail -n 40 "$build.log" >&2; return 1; }
  cmake --build "$build" --target install -j "$jobs" >"$build.log" 2>&1 ||
    { tail -n 40 "$build.log" >&2; return 1; }
}

# build_kernels NAME TARGET OPTION...: abut's packages for kernels, and what they give.
build_kernels() {
  cmake -S "$repository" -B "$work/$1/abut" -G Ninja -DABUT_KERNELS_ONLY=ON -DABUT_ENABLE_TESTS=ON \
    -DCMAKE_BUILD_TYPE=RelWithDebInfo -DABUT_WARNINGS_AS_ERRORS=ON -DABUT_TEST_THREADS=4 \
    "${@:3}" >/dev/null
  cmake --build "$work/$1/abut" --target "$2" kernel_results -j "$jobs"
  OMP_NUM_THREADS=4 KOKKOS_NUM_THREADS=4 \
    "$work/$1/abut/tests/threads/kernel_results" "$work/$1/results"
}

# threaded NAME: its unit tests and its results against those of Serial.
threaded() {
  "$repository/.ci/ctest" "$work/$1/abut" 1
  /usr/bin/python3 "$repository/tests/threads/compare.py" "$work/serial/results" "$work/$1/results" 1e-13
}

fetch_source
mkdir -p "$work"/{openmp,tsan}
build_kernels serial kernel_results

build_trilinos openmp -DTrilinos_ENABLE_OpenMP=ON -DKokkos_ENABLE_OPENMP=ON
build_kernels openmp all -DTrilinos_DIR="$work/openmp/installed/lib/cmake/Trilinos"
threaded openmp

build_trilinos tsan -DTPL_ENABLE_Pthread=ON -DKokkos_ENABLE_PTHREAD=ON -DCMAKE_CXX_FLAGS=-fsanitize=thread
build_kernels tsan all -DABUT_SANITIZE=thread -DABUT_TEST_SECONDS=3600 \
  -DTrilinos_DIR="$work/tsan/installed/lib/cmake/Trilinos"
threaded tsan
echo "audit-threads: all right"
