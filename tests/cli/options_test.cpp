#include <nlohmann/json.hpp>

#include "tests/cli/command.h"

namespace zonal {
namespace {

using CliOptions = Cli;

const std::vector<std::string> kVerbs = {"bake",   "info",  "convert", "irradiance", "prefilter",
                                         "sh",     "light", "lights",  "multiply",   "ambient-cube",
                                         "shader", "dfg",   "sky",     "testcard",   "compare",
                                         "split",  "merge", "gallery",    "fisheye", "view"};

TEST_F(CliOptions, HelpNamesEveryVerbAndEveryVerbHasExamples) {
  const std::string all = good({"--help"}).out;
  int helped = 0;
  for (const std::string& verb : kVerbs) {
    EXPECT_NE(all.find("\n  " + verb + " "), std::string::npos) << verb;
    const std::string help = good({verb, "--help"}).out;
    std::size_t examples = 0;
    for (std::size_t at = help.find("\n  zonal " + verb); at != std::string::npos;
         at = help.find("\n  zonal " + verb, at + 1))
      ++examples;
    EXPECT_GE(examples, 2u) << verb;
    EXPECT_NE(help.find("--json"), std::string::npos) << verb;
    ++helped;
  }
  EXPECT_EQ(helped, 20);
}

TEST_F(CliOptions, Version) { EXPECT_EQ(good({"--version"}).out.substr(0, 6), "zonal "); }

TEST_F(CliOptions, UsageErrors) {
  bad(2, {"bkae"}, "did you mean 'bake'");
  bad(2, {"irradince", "x"}, "did you mean 'irradiance'");
  bad(2, {}, "subcommand");
  bad(2, {"bake"}, "IN is required");
  bad(2, {"sky", "furnace", "-o", "x.exr", "--siez", "3"}, "--siez");
  bad(2, {"sky", "furnace", "-o", "x.exr", "--size", "many"}, "--size");
  bad(2, {"sky", "furnace", "-o", "x.exr", "--size", "0"}, "--size");
  bad(2, {"sky", "furnace", "-o", "x.exr", "--to", "cubus"}, "'cubus' is not one of");
  bad(2, {"sky", "furnace", "-o", "x.gif"}, "names no format");
  bad(2, {"sky", "nonsense", "-o", "x.exr"}, "no sky 'nonsense'");
  bad(2, {"sky", "furnace", "-o", "x.exr", "--turbidity", "3"}, "has no --turbidity");
  bad(2, {"sky", "daylight", "-o", "x.exr", "--elevation", "-3"}, "horizon");
  bad(2, {"sky", "furnace", "-o", ".", "--to", "equirect"}, "six faces");
  bad(2, {"sky", "furnace", "-o", "x.exr", "--radiance", "1,2"}, "one number or three");
  bad(2, {"sky", "furnace", "-o", "x.exr", "--radiance", "1,two,3"}, "list of numbers");
}

TEST_F(CliOptions, ParametersThatDoNotFitEachOther) {
  good({"sky", "furnace", "-o", "x.exr", "--size", "8"});
  bad(2, {"convert", "x.exr", "-o", "y.exr", "--rotate", "1,2,3,4"}, "--rotate");
  bad(2, {"convert", "x.exr", "-o", "y.exr", "--fov", "120"}, "describe a fisheye");
  bad(2, {"prefilter", "x.exr", "-o", "y.exr"}, "takes either --roughness or --alpha");
  bad(2, {"prefilter", "x.exr", "-o", "y.exr", "--roughness", "0.5", "--alpha", "0.2"}, "takes either");
  bad(2, {"prefilter", "x.exr", "-o", "y.exr", "--lobe", "phong", "--alpha", "0.2"}, "--exponent");
  bad(2, {"prefilter", "x.exr", "-o", "y.exr", "--roughness", "7"}, "roughness");
  bad(2, {"irradiance", "x.exr", "-o", "y.exr", "--shininess", "3", "--quantity", "irradiance"}, "no meaning");
  bad(2, {"sh", "x.exr", "--bands", "7", "--glsl"}, "bands");
  bad(2, {"bake", "x.exr", "-o", "out", "--size", "64", "--levels", "9"}, "do not fit");
  bad(2, {"bake", "x.exr", "x.exr", "x.exr", "-o", "out"}, "make no environment");
}

TEST_F(CliOptions, JsonIsOneObjectAndNothingElse) {
  good({"sky", "furnace", "-o", "x.exr", "--size", "16"});
  const std::vector<std::vector<std::string>> calls = {
      {"info", "x.exr"},
      {"convert", "x.exr", "-o", "y.exr"},
      {"irradiance", "x.exr", "-o", "i.exr", "--size", "8"},
      {"prefilter", "x.exr", "-o", "p.exr", "--size", "8", "--roughness", "0.5"},
      {"sh", "x.exr"},
      {"sh", "x.exr", "--glsl", "-o", "sh.glsl"},
      {"sh", "x.exr", "--to", "filament"},
      {"sh", "x.exr", "-o", "x.json", "--window", "hann"},
      {"light", "ambient", "-o", "l.json"},
      {"lights", "x.json"},
      {"multiply", "x.json", "l.json"},
      {"ambient-cube", "x.json"},
      {"shader", "x.json"},
      {"shader", "x.json", "--program"},
      {"dfg", "-o", "d.exr", "--size", "4"},
      {"sky", "-o", "s.exr", "--size", "8"},
      {"testcard", "-o", "t.png", "--size", "8"},
      {"compare", "x.exr", "y.exr"},
      {"bake", "x.exr", "-o", "out", "--size", "16", "--dfg-size", "4", "--verify"},
  };
  int parsed = 0;
  for (std::vector<std::string> call : calls) {
    call.push_back("--json");
    const Result result = good(call);
    const auto json = nlohmann::json::parse(result.out, nullptr, false);
    ASSERT_TRUE(json.is_object()) << call[0] << result.out;
    EXPECT_TRUE(json.at("warnings").is_array()) << call[0];
    EXPECT_GE(json.size(), 3u) << call[0];
    ++parsed;
  }
  EXPECT_EQ(parsed, 19);
  const Result failed = run({"info", "missing.exr", "--json"});
  EXPECT_EQ(failed.code, 3);
  EXPECT_EQ(nlohmann::json::parse(failed.out).at("error").at("exit_code"), 3);
}

TEST_F(CliOptions, QuietKeepsAnswersAndWarnings) {
  write_pfm("dark.pfm", 4, 2, std::vector<float>(24, 0));
  const Result result = good({"convert", "dark.pfm", "-o", "y.exr", "--quiet"});
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.substr(0, 9), "warning: ");
  EXPECT_EQ(result.err.find("note:"), std::string::npos);
  EXPECT_NE(good({"info", "dark.pfm", "--quiet"}).out.find("4x2"), std::string::npos);
}

TEST_F(CliOptions, NoProgressWhereNobodyLooks) {
  const Result result = good({"sky", "daylight", "-o", "x.exr", "--size", "256"});
  EXPECT_EQ(result.err.find('\r'), std::string::npos);
  EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
  EXPECT_EQ(result.out.find('\r'), std::string::npos);
}

}  // namespace
}  // namespace zonal
