# SPDX-License-Identifier: BSD-3-Clause
# Front door to set-up, build, demo and tests. Work that is done is not done again.
# Variables: BUILD (folder), BUILD_TYPE, JOBS, CMAKE_FLAGS, CI=true (warnings are errors).
BUILD ?= build
BUILD_TYPE ?= Release
JOBS ?= $(shell nproc)
CI ?= false
CMAKE_FLAGS ?=
# The interpreter that the distribution's Python packages belong to.
PYTHON := /usr/bin/python3

warnings_as_errors := $(if $(filter true,$(CI)),ON,OFF)
configure := cmake -S . -B $(BUILD) -G Ninja -DCMAKE_BUILD_TYPE=$(BUILD_TYPE) -DABUT_ENABLE_TESTS=ON \
	-DABUT_WARNINGS_AS_ERRORS=$(warnings_as_errors) $(CMAKE_FLAGS)

.PHONY: help demo test verify setup build format
.DELETE_ON_ERROR:
.NOTPARALLEL:

help:
	@echo 'make demo    set up, build the program, press a sphere on a plane and compare with Hertz'
	@echo 'make test    set up, build everything, run the tests'
	@echo 'make verify  set up, build everything, run the long verification studies'
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

# Changes only when the configuration asked for does, so that it is repeated then and only then;
# an edited CMakeLists.txt is ninja's own affair.
$(BUILD)/.configure: FORCE
	@mkdir -p $(@D)
	@echo '$(configure)' | cmp -s - $@ || echo '$(configure)' >$@

$(BUILD)/build.ninja: $(BUILD)/.configure | $(BUILD)/.setup
	$(configure)
	@touch $@

FORCE:
