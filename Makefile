# SPDX-License-Identifier: BSD-3-Clause
# Front door to set-up, build, demo and tests. Work that is done is not done again.
# Variables: BUILD (folder), BUILD_TYPE, JOBS, CMAKE_FLAGS, CI=true (warnings are errors), AGAINST
# (another build of the program for bench), BENCH_FLAGS (of tests/performance/bench.py).
BUILD ?= build
BUILD_TYPE ?= Release
JOBS ?= $(shell nproc)
CI ?= false
CMAKE_FLAGS ?=
AGAINST ?=
BENCH_FLAGS ?=
# The interpreter that the distribution's Python packages belong to.
PYTHON := /usr/bin/python3

warnings_as_errors := $(if $(filter true,$(CI)),ON,OFF)
configure := cmake -S . -B $(BUILD) -G Ninja -DCMAKE_BUILD_TYPE=$(BUILD_TYPE) -DABUT_ENABLE_TESTS=ON \
	-DABUT_WARNINGS_AS_ERRORS=$(warnings_as_errors) $(CMAKE_FLAGS)

.PHONY: help demo test verify bench audit-threads setup build format
.DELETE_ON_ERROR:
.NOTPARALLEL:

help:
	@echo 'make demo    set up, build the program, press a sphere on a plane and compare with Hertz'
	@echo 'make test    set up, build everything, run the tests'
	@echo 'make verify  set up, build everything, run the long verification studies'
	@echo 'make bench   set up, build and run the benchmarks; AGAINST=PROGRAM: in turn with another build'
	@echo 'make audit-threads  set up, try the kernels on 4 threads (fetches the source of Trilinos)'
	@echo 'make setup   install the Debian packages that are missing'
	@echo 'make build   set up, build everything'
	@echo 'make format  lay out the C++ sources'
	@echo 'Variables: BUILD=$(BUILD) BUILD_TYPE=$(BUILD_TYPE) JOBS=$(JOBS) CI=$(CI) CMAKE_FLAGS=$(CMAKE_FLAGS)'

demo: $(BUILD)/build.ninja
	ninja -C $(BUILD) -j $(JOBS) abut
	$(PYTHON) input/hertz_sphere/demo.py --abut $(BUILD)/bin/abut --ranks 2

test: build
	.ci/ctest $(BUILD) $(JOBS) --label-exclude '^verify$$'

verify: build
	.ci/ctest $(BUILD) $(JOBS) --label-regex '^verify$$'

# The option stays in the cache, and its target is none of those that `build` makes.
bench: $(BUILD)/.setup-bench $(BUILD)/build.ninja
	grep -qx 'ABUT_ENABLE_BENCHMARKS:BOOL=ON' $(BUILD)/CMakeCache.txt || \
	  cmake -S . -B $(BUILD) -DABUT_ENABLE_BENCHMARKS=ON
	ninja -C $(BUILD) -j $(JOBS) abut abut_benchmark
	@mkdir -p $(BUILD)/bench
	OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 $(BUILD)/tests/performance/abut_benchmark \
	  --benchmark_out=$(BUILD)/bench/kernels.json --benchmark_out_format=json
	PYTHONPATH=tests/support $(PYTHON) -B tests/performance/bench.py --abut $(BUILD)/bin/abut \
	  $(if $(AGAINST),--against $(AGAINST)) --output $(BUILD)/bench $(BENCH_FLAGS)

audit-threads: setup
	tests/threads/audit.sh $(BUILD) $(JOBS)

setup: $(BUILD)/.setup

build: $(BUILD)/build.ninja
	ninja -C $(BUILD) -j $(JOBS)

format:
	.ci/setup format
	git ls-files -z --cached --others --exclude-standard '*.hpp' '*.cpp' | xargs -0 clang-format -i

$(BUILD)/.setup: .ci/setup
	.ci/setup
	@mkdir -p $(@D)
	@touch $@

$(BUILD)/.setup-bench: .ci/setup
	.ci/setup bench
	@mkdir -p $(@D)
	@touch $@

# Changes only when the configuration asked for does, so that it is repeated then and only then;
# an edited CMakeLists.txt is ninja's own affair.
$(BUILD)/.configure: FORCE
	@mkdir -p $(@D)
	@echo '$(configure)' | cmp -s - $@ || echo '$(configure)' >$@

$(BUILD)/build.ninja: $(BUILD)/.configure | $(BUILD)/.setup
	$(configure)
	@touch $@

FORCE:
