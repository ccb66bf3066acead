// SPDX-License-Identifier: BSD-3-Clause
#include "report_command.hpp"

#include "python_tool.hpp"

#include "abut/core/comm.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace abut::app {

namespace {

struct Arguments {
  std::string results, output, summary;
};

int report(const Arguments& a) {
  std::vector<std::string> words = {a.results};
  if (!a.output.empty())
    words.insert(words.end(), {"--output", a.output});
  if (!a.summary.empty())
    words.insert(words.end(), {"--summary", a.summary});
  const Comm comm(MPI_COMM_WORLD);
  Global status = 0;
  comm.on_root([&] { status = run_python_tool("abut.report", words); });
  return static_cast<int>(comm.max(status));
}

} // namespace

void add_report_command(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("report", "Write one HTML page of pictures and figures of a run");
  command->add_option("RESULTS", arguments->results, "Exodus file of a run, NAME.exo")->required();
  command->add_option("-o,--output", arguments->output,
                      "Page to write; NAME.html beside the results if not given");
  command->add_option("--summary", arguments->summary,
                      "Summary of the run; looked for beside the results if not given");
  command->footer("Needs Python with numpy, matplotlib and netCDF4 (Debian: python3-matplotlib "
                  "python3-netcdf4).\nABUT_PYTHON names another interpreter than "
                  "/usr/bin/python3.");
  command->callback([arguments, &status] { status = report(*arguments); });
}

} // namespace abut::app
