#include "present/gl/shader_program.h"

#include <cstdlib>
#include <string>

#include "tests/present/gl_test.h"

namespace offing::present {
namespace {

using ShaderProgramTest = test::GlTest;

std::string fault_of(const ShaderStages& stages) {
  try {
    const ShaderProgram program(stages);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::build_failed);
    return error.what();
  }
  return {};
}

// Fails if an embedded shader is lost, or a good program is refused.
TEST_F(ShaderProgramTest, CompilesAnEmbeddedFile) {
  EXPECT_EQ(fault_of({.vertex = {shader_file("screen.vert")},
                      .fragment = {{"shared", "const vec3 red = vec3(1.0, 0.0, 0.0);"},
                                   {"main", "out vec4 light; void main() { light = vec4(red, 1.0); }"}}}),
            "");
}

// Fails if the compiler's message does not lead to the file and line of the fault.
TEST_F(ShaderProgramTest, NamesFileAndLineOfAFault) {
  const std::string fault = fault_of({.vertex = {shader_file("screen.vert")},
                                      .fragment = {{"shared", "const float one = 1.0;\n"},
                                                   {"broken.frag",
                                                    "out vec4 light;\n\nvoid main() {\n  "
                                                    "light = vec4(missing);\n}\n"}}});
  EXPECT_NE(fault.find("broken.frag:4"), std::string::npos) << fault;
}

// Fails if a name without a file is taken for an empty shader.
TEST(ShaderFileTest, RefusesAnUnknownName) {
  EXPECT_THROW(shader_file("no_such_file.frag"), Error);
}

}  // namespace
}  // namespace offing::present
