#include "host/ocl/program.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/ocl/buffer.h"
#include "host/ocl/device_state.h"
#include "host/ocl/program_source.h"
#include "tests/ocl/expect_error.h"
#include "tests/ocl/scoped_environment.h"
#include "tests/ocl/test_kernels.h"

namespace offing::ocl {
namespace {

using ::testing::HasSubstr;

class ProgramTest : public ::testing::Test {
 protected:
  // The first number that `kernel` of `source` writes.
  int result(const char* source, const Defines& defines = {}) const {
    const Buffer<int> values(device_, 1, "values");
    Program::build(device_, source, defines).kernel("answer").launch({{1}}, values);
    return values.read()[0];
  }

  test::TestKernels kernels_;
  Device device_ = Device::open();
};

TEST_F(ProgramTest, PassesDefines) {
  kernels_.write("answer.cl", "kernel void answer(global int* v) { v[0] = VALUE; }");
  EXPECT_EQ(result("answer.cl", Defines().set("VALUE", 42)), 42);
  EXPECT_EQ(result("answer.cl", Defines().set("VALUE", -7)), -7);  // fails if the cache ignores the values
  EXPECT_EQ(result("answer.cl", Defines().set("VALUE", "(3+4)")), 7);
}

TEST_F(ProgramTest, RejectsDefinesThatACommandLineWouldSplit) {
  test::expect_error(ErrorKind::bad_usage, "expected a name and a value without blanks",
                     [] { Defines().set("VALUE", "1 -cl-fast-relaxed-math"); });
  test::expect_error(ErrorKind::bad_usage, "expected a name", [] { Defines().set("", 1); });
}

// Fails if an edited source is answered from the cache.
TEST_F(ProgramTest, RebuildsWhenAnIncludedFileChanges) {
  kernels_.write("part/number.clh", "#define NUMBER 1\n");
  kernels_.write("answer.cl",
                 "#include \"part/number.clh\"\nkernel void answer(global int* v) { v[0] = NUMBER; }");
  EXPECT_EQ(result("answer.cl"), 1);
  kernels_.write("part/number.clh", "#define NUMBER 2\n");
  EXPECT_EQ(result("answer.cl"), 2);
}

// Fails if a device keeps what sources were before they were edited: a window that compiles them again and
// again would fill its memory.
TEST_F(ProgramTest, KeepsOneProgramOfEachSource) {
  for (int value = 0; value < 5; ++value) {
    kernels_.write("answer.cl",
                   fmt::format("kernel void answer(global int* v) {{ v[0] = {} + OFFSET; }}", value));
    for (const int offset : {0, 100}) {
      EXPECT_EQ(result("answer.cl", Defines().set("OFFSET", offset)), value + offset);
    }
  }
  EXPECT_EQ(device_.state()->programs.size(), 2u) << "one for each set of options";
}

// A file that two others include, in a ring even, is there once: fails by a redefinition or by recursion.
TEST_F(ProgramTest, IncludesEachFileOnce) {
  kernels_.write("two.clh", "#include \"ring.clh\"\nint two() { return 2; }\n");
  kernels_.write("ring.clh", "  #  include \"two.clh\"\nint ring() { return 40; }\n");
  kernels_.write("answer.cl",
                 "#include \"two.clh\"\n#include \"kernels/ring.clh\"\n"
                 "kernel void answer(global int* v) { v[0] = two() + ring(); }");
  EXPECT_EQ(result("answer.cl"), 42);
}

// Fails if a message counts lines of the assembled text instead of the file's.
TEST_F(ProgramTest, NamesTheTrueFileAndLine) {
  kernels_.write("long.clh", "// 1\n// 2\n// 3\n");
  kernels_.write("deep.clh",
                 "// 1\n#include \"long.clh\"\nint broken(int x) { return undeclared_in_deep; }\n");
  kernels_.write("broken.cl",
                 "#include \"deep.clh\"\n#include \"long.clh\"\n\nkernel void f() { broken(1); }\n");
  test::expect_error(ErrorKind::build_failed,
                     kernels_.path_of("deep.clh") + ":3:", [&] { Program::build(device_, "broken.cl"); });
  kernels_.write("deep.clh", "// 1\n#include \"long.clh\"\nint broken(int x) { return x; }\n");
  kernels_.write("broken.cl",
                 "#include \"deep.clh\"\n#include \"long.clh\"\n\nkernel void f() { int x = undeclared; }\n");
  const std::string hint = test::expect_error(ErrorKind::build_failed, kernels_.path_of("broken.cl") + ":4:",
                                              [&] { Program::build(device_, "broken.cl"); });
  EXPECT_THAT(hint, HasSubstr("--verbose"));
}

// Fails if messages of drivers that ignore `#line` name no file.
TEST(AtTrueLine, FindsFileAndLineOfALineOfTheWhole) {
  const std::string source = "#line 1 \"a.cl\"\n#line 1 \"b.clh\"\n// b1\n// b2\n#line 2 \"a.cl\"\nbroken\n";
  EXPECT_EQ(at_true_line(source, "<kernel>:6:2: error: x"), "a.cl:2:2: error: x");
  EXPECT_EQ(at_true_line(source, "<kernel>:4: error"), "b.clh:2: error");
  EXPECT_EQ(at_true_line(source, "b.clh:4: error"), "b.clh:4: error");
  EXPECT_EQ(at_true_line(source, "<kernel>:9: error"), "<kernel>:9: error");
  EXPECT_EQ(at_true_line(source, "ptxas fatal: no"), "ptxas fatal: no");
}

// The name in messages about embedded files is the path from the repository root.
TEST_F(ProgramTest, NamesEmbeddedFilesFromTheRoot) {
  EXPECT_THAT(assemble_source("shared/random.h"), HasSubstr("#line 1 \"kernels/shared/random.h\"\n"));
}

TEST_F(ProgramTest, NamesTheLineThatIncludesAMissingFile) {
  kernels_.write("lost.cl", "\n#include \"no/such.clh\"\n");
  test::expect_error(ErrorKind::build_failed,
                     kernels_.path_of("lost.cl") + ":2: no kernel source \"no/such.clh\"",
                     [&] { Program::build(device_, "lost.cl"); });
  test::expect_error(ErrorKind::build_failed, "no kernel source \"none.cl\"",
                     [&] { Program::build(device_, "none.cl"); });
}

// Fails if a mistyped folder is answered with the embedded kernels, while its owner edits others.
TEST_F(ProgramTest, NamesAKernelPathThatIsNoFolder) {
  const test::ScopedEnvironment path("OFFING_KERNEL_PATH", kernels_.path_of("nowhere"));
  test::expect_error(ErrorKind::bad_usage,
                     "OFFING_KERNEL_PATH: expected a folder, got " + kernels_.path_of("nowhere"),
                     [] { assemble_source("shared/random.h"); });
}

TEST_F(ProgramTest, NamesAMissingKernel) {
  kernels_.write("answer.cl", "kernel void answer(global int* v) { v[0] = 1; }");
  test::expect_error(ErrorKind::build_failed, "kernels/answer.cl has no kernel \"question\"",
                     [&] { Program::build(device_, "answer.cl").kernel("question"); });
}

// Denormal numbers slow spectra down by half; fails if the option that flushes them gets lost. A device may
// ignore the option, so the gate is the option's presence where PoCL obeys it.
TEST_F(ProgramTest, FlushesDenormalsOnPocl) {
  if (device_.info().platform != "Portable Computing Language")
    GTEST_SKIP() << "other drivers may keep denormals";
  kernels_.write("denormal.cl", "kernel void scale(global float* v) { v[0] *= 0.5f; }");
  const Buffer<float> value(device_, std::vector<float>{1.5e-38f}, "value");  // the least normal is 1.18e-38
  Program::build(device_, "denormal.cl").kernel("scale").launch({{1}}, value);
  EXPECT_EQ(value.read()[0], 0.0f);
}

}  // namespace
}  // namespace offing::ocl
