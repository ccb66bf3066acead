#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""check_sources.py accepts a good tree and finds each kind of fault in a bad one."""
import pathlib
import tempfile
import unittest

import check_sources

LICENSE = "// SPDX-License-Identifier: BSD-3-Clause\n"
HEADER = LICENSE + "#pragma once\n"


class CheckSources(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "packages/core").mkdir(parents=True)
        (self.root / "apps").mkdir()

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def source(self, package, body):
        self.write(f"packages/{package}/src/a.cpp", LICENSE + body)

    def errors(self):
        return list(check_sources.errors(self.root))

    def assert_one(self, words):
        found = self.errors()
        self.assertEqual(len(found), 1, found)
        self.assertIn(words, found[0])

    def test_every_allowed_edge_passes(self):
        for package, allowed in check_sources.ALLOWED.items():
            lines = "".join(f'#include "abut/{target}/x.hpp"\n' for target in allowed | {package})
            self.source(package, lines)
        self.assertEqual(self.errors(), [])

    def test_every_other_edge_fails(self):
        for package, allowed in check_sources.ALLOWED.items():
            for target in set(check_sources.ALLOWED) - allowed - {package}:
                with self.subTest(package=package, target=target):
                    self.source(package, f'\n  # include <abut/{target}/x.hpp>\n')
                    self.assert_one(f"packages/{package}/src/a.cpp:3: {package} includes")
            self.source(package, "")

    def test_edges_point_down(self):
        """No cycle: a package knows only packages of rows above its own."""
        above = set()
        for package, allowed in check_sources.ALLOWED.items():
            self.assertLessEqual(allowed, above, package)
            above.add(package)

    def a_class(self, data, functions):
        members = "".join(f"  std::function<void(int, int)> a{i}{{}};\n" for i in range(data))
        members += "".join(f"  template <class T> int f{i}(T x, int y = 0) const {{ int z{{1}}; return y + z; }}\n"
                           for i in range(functions))
        nested = "  struct Other { int a, b, c; void f(); };\n  enum class E { x, y };\n  using T = int;\n"
        return f"class Large final : public Base {{\npublic:\n{nested}{members}\nprivate:\n}};\n"

    def test_classes_have_a_size(self):
        self.source("core", self.a_class(25, 40))
        self.assertEqual(self.errors(), [])
        self.source("core", self.a_class(26, 0))
        self.assert_one("Large has 26 data members")
        self.source("core", self.a_class(0, 41))
        self.assert_one("Large has 41 member functions")
        self.source("core", "struct Plain {\n  int a, b" + "".join(f", c{i} = 0" for i in range(24)) + ";\n};\n")
        self.assert_one("Plain has 26 data members")

    def test_kernels_are_device_code(self):
        kernel = "packages/core/src/kernels/a.cpp"
        self.write(kernel, LICENSE + "double x = 0.0; // std::vector\n")
        self.assertEqual(self.errors(), [])
        self.write(kernel, LICENSE + "std::vector<int> x;\n")
        self.assert_one("kernels are device code")
        self.write(kernel, LICENSE + "bool dual_law;\n")
        self.assert_one("kernels know sites")

    def test_kernels_have_labels_of_ours(self):
        self.source("core", 'void f() { parallel_for("abut::x", 1, 2); }\n')
        self.assertEqual(self.errors(), [])
        self.source("core", 'void f() { parallel_for("x", 1, 2); }\n')
        self.assert_one("begin with abut::")

    def test_deck_knows_options_only(self):
        self.source("deck", '#include "abut/contact/options.hpp"\n')
        self.assertEqual(self.errors(), [])
        self.source("deck", '#include "abut/contact/more/options.hpp"\n')
        self.assert_one("deck includes abut/contact/more/options.hpp")

    def test_options_know_options_only(self):
        self.write("packages/contact/include/abut/contact/options.hpp",
                   HEADER + '#include "abut/mesh/mesh.hpp"\n')
        self.assert_one("options know core and other options only")

    def test_header_of_no_package(self):
        self.source("core", '#include "abut/nowhere/x.hpp"\n')
        self.assert_one("is no header of a package")
        self.source("core", "")
        self.write("apps/abut/main.cpp", LICENSE + '#include "abut/nowhere/x.hpp"\n')
        self.assertEqual(self.errors(), [])  # the compiler's own affair outside packages

    def test_package_without_row(self):
        self.write("packages/heat/src/a.cpp", LICENSE)
        self.assert_one("packages/heat: give it a row")

    def test_private_header_stays_in_its_folder(self):
        self.source("core", '#include "../../mesh/src/secret.hpp"\n')
        self.assert_one("neither abut/... nor beside this file")
        self.source("core", '#include "secret.hpp"\n')
        self.write("packages/core/src/secret.hpp", HEADER)
        self.assertEqual(self.errors(), [])
        self.source("core", '#include "room/secret.hpp"\n')
        self.assert_one("nor below src/")
        self.write("packages/core/src/room/secret.hpp", HEADER)
        self.assertEqual(self.errors(), [])

    def test_linked_edge(self):
        self.write("packages/contact/CMakeLists.txt",
                   "# SPDX-License-Identifier: BSD-3-Clause\n# not abut::io\n"
                   "abut_package(contact PUBLIC abut::search PRIVATE abut::solid)\n")
        self.assert_one("contact links solid")

    def test_exodus_in_io_only(self):
        self.source("io", "#include <exodusII.h>\n")
        self.assertEqual(self.errors(), [])
        self.write("apps/abut/main.cpp", LICENSE + "#include <exodusII.h>\n")
        self.assert_one("only io includes exodusII.h")

    def test_forbidden_calls(self):
        for line in ("MPI_Comm_rank(MPI_COMM_WORLD, &r);", "std::cout << 1;", "std :: cerr << 1;",
                     'printf("x");', 'std::fprintf(stderr, "x");', "puts(s);", "exit(1);",
                     "std::exit(1);", "_exit(1);", "std::abort();", "MPI_Abort(c, 1);",
                     'fmt::print("x");'):
            with self.subTest(line=line):
                self.source("core", line)
                self.assert_one("packages/core/src/a.cpp:2: ")

    def test_words_in_comments_and_literals_are_no_calls(self):
        self.source("core", "// no std::cout\n/* printf(\n exit( */\n"
                            'const char* a = "exit(1) \\" exit(2)";\n'
                            'auto b = R"(exit(3) " exit(4))";\n'
                            "snprintf(c, 1'000, \"%d\", '\"'); co_exit(); auto d = '\\'';\n")
        self.assertEqual(self.errors(), [])

    def test_call_after_literals_is_found(self):
        self.source("core", "char a = '\"'; long b = 1'000'000; exit(1); char c = '\"';\n")
        self.assert_one("packages/core/src/a.cpp:2: exit(")

    def test_license_line(self):
        self.write("packages/core/src/a.cpp", "\n\n" + LICENSE)
        self.assert_one("packages/core/src/a.cpp:1: no line")
        self.write("packages/core/src/a.cpp", LICENSE)
        self.write("input/hertz/demo.py", "#!/usr/bin/python3\n# SPDX-License-Identifier: MIT\n")
        self.assert_one("input/hertz/demo.py:1: no line")

    def test_pragma_once(self):
        self.write("packages/core/include/abut/core/a.hpp", LICENSE)
        self.assert_one("no #pragma once")

    def test_words(self):
        for word in ("Ma" "ster", "sla" "ve_faces"):
            with self.subTest(word=word):
                self.source("core", f"int {word};\n")
                self.assert_one("packages/core/src/a.cpp:2: ")

    def test_long_functions_are_measured(self):
        text = ("class A {\n public:\n  int f(int a,\n        int b) {\n    return a;\n  }\n"
                "  int g() const;\n};\nint h() {\n  if (x()) {\n  }\n  return 1;\n}\nint i() { y(); }\n")
        self.assertEqual(list(check_sources.function_lengths(text)), [(3, 4), (9, 5)])


if __name__ == "__main__":
    unittest.main()
