#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "apps/zonal/choices.h"
#include "apps/zonal/filtered_map.h"
#include "apps/zonal/input_options.h"
#include "apps/zonal/layouts.h"
#include "apps/zonal/output_options.h"
#include "apps/zonal/run_options.h"
#include "apps/zonal/verbs.h"
#include "zonal/base/error.h"

namespace zonal {
namespace {

struct PrefilterOptions {
  InputOptions input;
  OutputOptions output;
  LobeKind lobe = LobeKind::kGgx;
  std::optional<double> roughness, alpha, exponent, angle_deg;
};

constexpr int kPanoramaHeight = 256, kFaceEdge = 128;

[[noreturn]] void wrong_parameter(LobeKind kind, const char* wanted) {
  throw Error(ErrorKind::kUsage, fmt::format("the lobe {} takes {}", name_of(kind), wanted),
              "zonal prefilter --help shows examples");
}

Lobe lobe_of(const PrefilterOptions& o) {
  const int given = o.roughness.has_value() + o.alpha.has_value() + o.exponent.has_value() + o.angle_deg.has_value();
  switch (o.lobe) {
    case LobeKind::kCosine:
      if (given != 0) wrong_parameter(o.lobe, "no parameter");
      return Lobe::cosine();
    case LobeKind::kGgx:
    case LobeKind::kCharlie:
      if (given == 1 && o.roughness) return lobe_for_roughness(o.lobe, *o.roughness);
      if (given == 1 && o.alpha) return o.lobe == LobeKind::kGgx ? Lobe::ggx(*o.alpha) : Lobe::charlie(*o.alpha);
      wrong_parameter(o.lobe, "either --roughness or --alpha");
    case LobeKind::kPhong:
    case LobeKind::kBlinnPhong:
      if (given == 1 && o.roughness) return lobe_for_roughness(o.lobe, *o.roughness);
      if (given == 1 && o.exponent)
        return o.lobe == LobeKind::kPhong ? Lobe::phong(*o.exponent) : Lobe::blinn_phong(*o.exponent);
      wrong_parameter(o.lobe, "either --roughness or --exponent");
    case LobeKind::kCone:
    case LobeKind::kGaussian:
      if (given != 1 || !o.angle_deg) wrong_parameter(o.lobe, "--angle");
      return o.lobe == LobeKind::kCone ? Lobe::cone(radians(*o.angle_deg)) : Lobe::gaussian(radians(*o.angle_deg));
  }
  wrong_parameter(o.lobe, "another parameter");
}

void run_prefilter(const PrefilterOptions& options, Call& call) {
  const Lobe lobe = lobe_of(options);
  const Projection to = target_of(options.output, Layout::kEquirect);
  check_output(options.output, to.layout);
  const ImageSize size = target_size(options.output, to, is_cube(to.layout) ? kFaceEdge : kPanoramaHeight);
  const Convolved result = filtered_map(options.input, lobe, to, size, call);
  call.console.field("lobe", name_of(lobe.kind()));
  call.console.field("parameter", lobe.parameter());
  write_map(result.map, options.output, "radiance",
            fmt::format("{} map, error bound {:.2g} of the mean", name_of(lobe.kind()), result.report.bound_to_mean),
            call);
}

}  // namespace

void add_prefilter(CLI::App& app, Call& call) {
  auto options = std::make_shared<PrefilterOptions>();
  CLI::App& verb = *app.add_subcommand("prefilter", "The environment seen through one lobe, in any projection.");
  add_input_options(verb, options->input);
  constexpr const char* kGroup = "Lobe";
  add_choice(verb, "--lobe", options->lobe, lobe_kind_named,
             names_of(all_lobe_kinds(), [](LobeKind k) { return std::string(name_of(k)); }),
             "the shape, ggx if not said")
      ->group(kGroup);
  verb.add_option("--roughness", options->roughness, "perceptual roughness, 0.01 to 1")->group(kGroup);
  verb.add_option("--alpha", options->alpha, "GGX, Charlie: roughness squared")->group(kGroup);
  verb.add_option("--exponent", options->exponent, "Phong, Blinn-Phong: the exponent")->group(kGroup);
  verb.add_option("--angle", options->angle_deg, "cone: half its angle; gaussian: its standard deviation; in degrees")
      ->group(kGroup);
  add_output_options(verb, options->output, "256 for panoramas, 128 for cube faces if not said");
  add_run_options(verb, call);
  verb.footer(
      "Examples:\n"
      "  zonal prefilter sunset.hdr --roughness 0.4 -o gloss.exr\n"
      "  zonal prefilter sunset.hdr --lobe phong --exponent 50 --to cube -o gloss.ktx2\n"
      "  zonal prefilter sunset.hdr --lobe gaussian --angle 3 --size 1024 -o blurred.hdr");
  verb.callback([options, &call] { run_prefilter(*options, call); });
}

}  // namespace zonal
