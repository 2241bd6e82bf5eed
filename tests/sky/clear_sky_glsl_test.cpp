// The radiance function as GLSL text. tests/sky/clear_sky_gl_test.cpp compiles and runs it.
#include <regex>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/sky/clear_sky.h"
#include "tests/ocl/test_kernels.h"

namespace offing::sky {
namespace {

using testing::HasSubstr;

// Without comments, and without what the preprocessor drops where the language is GLSL.
std::string code_of(const std::string& text) {
  std::string code = std::regex_replace(text, std::regex("//[^\n]*"), "");
  const auto erase = [&code](const char* opening, const char* closing) {
    const std::size_t begin = code.find(opening);
    ASSERT_NE(begin, std::string::npos) << opening;
    code.erase(begin, code.find(closing, begin) - begin);
  };
  erase("#ifdef __OPENCL_VERSION__", "#else");
  erase("#if !defined(__OPENCL_VERSION__) && defined(__cplusplus)", "#endif");
  return code;
}

// Fails if the shared source takes a word of OpenCL C, or of C++, that GLSL 3.30 does not have.
TEST(ClearSkyGlslTest, HasNoWordOfOpenClAlone) {
  const std::string code = code_of(clear_sky_glsl());
  for (const char* word :
       {"__global",    "__local", "__kernel",      "kernel", "restrict", "inline", "static",      "typedef",
        "convert_int", "fmin",    "fmax",          "fabs",   "rsqrt",    "mad",    "native_sqrt", "half",
        "uchar",       "size_t",  "get_global_id", "double", "include",  "sizeof", "\""}) {
    EXPECT_FALSE(std::regex_search(code, std::regex("(^|\\W)" + std::string(word) + "(\\W|$)"))) << word;
  }
  EXPECT_FALSE(std::regex_search(code, std::regex("\\(float[34]?\\)"))) << "a cast or literal of OpenCL C";
  EXPECT_FALSE(std::regex_search(code, std::regex("->"))) << "a pointer";
}

// Fails if what the presenter calls is missing or changes its form unnoticed.
TEST(ClearSkyGlslTest, DeclaresWhatItPromises) {
  const std::string text = clear_sky_glsl();
  EXPECT_THAT(text, HasSubstr("struct SkyParams {"));
  EXPECT_THAT(text, HasSubstr("\n};"));
  EXPECT_THAT(text,
              HasSubstr("float3 sky_radiance(const SkyParams sky, SKY_TABLE view_table, float3 direction)"));
  EXPECT_THAT(text,
              HasSubstr("float3 sky_sun_disc(const SkyParams sky, SKY_TABLE depth_table, float3 direction)"));
  EXPECT_THAT(text, HasSubstr("#define SKY_VIEW_COLUMNS "));
  EXPECT_THAT(text, HasSubstr("// file 1: kernels/sky/clear_sky.clh\n"));
  EXPECT_THAT(text, HasSubstr("#line 1 1\n"));
}

// Fails if the presenter's reload would not see an edited file.
TEST(ClearSkyGlslTest, ReadsTheFolderOfKernels) {
  const test::TestKernels kernels;
  kernels.write("sky/clear_sky.clh", "#include \"shared/sky_params.h\"\nfloat edited;\n");
  EXPECT_THAT(clear_sky_glsl(), HasSubstr("float edited;"));
}

}  // namespace
}  // namespace offing::sky
