# SPDX-License-Identifier: BSD-3-Clause
"""Entry of `abut report RESULTS [--output FILE] [--summary FILE]`; exit status as the program's."""
import argparse
import sys

INPUT, MACHINE = 2, 5  # exit statuses, docs/user/first-run.md
PACKAGES = {"numpy": "python3-numpy", "matplotlib": "python3-matplotlib", "netCDF4": "python3-netcdf4"}


def missing_packages():
    """{module: Debian package} of what this interpreter lacks."""
    missing = {}
    for module, package in PACKAGES.items():
        try:
            __import__(module)
        except ImportError:
            missing[module] = package
    return missing


def say(message):
    print(f"abut: {message}", file=sys.stderr)


def main():
    parser = argparse.ArgumentParser(prog="abut report")
    parser.add_argument("results")
    parser.add_argument("--output")
    parser.add_argument("--summary")
    arguments = parser.parse_args()
    missing = missing_packages()
    if missing:
        say(f"abut report needs the Python modules {', '.join(missing)}, which {sys.executable} does not have; on Debian: "
            f"apt-get install {' '.join(missing.values())}; another interpreter: ABUT_PYTHON=PATH")
        return MACHINE
    from ..errors import InputError
    from .write import write_report
    try:
        print(f"report: {write_report(arguments.results, arguments.output, arguments.summary)}")
    except InputError as error:
        say(error)
        return INPUT
    except (OSError, MemoryError) as error:
        say(f"the report cannot be written: {error}")
        return MACHINE
    return 0


if __name__ == "__main__":
    sys.exit(main())
