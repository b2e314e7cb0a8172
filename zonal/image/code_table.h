#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "zonal/image/response.h"

namespace zonal {

/// Whether a code can be trusted; if not, why.
enum class CodeState : std::uint8_t { kTrusted, kBlack, kSaturated, kMissing };

/// What a code says about the light.
struct CodeValue {
  float exposure = 0;      ///< radiance times seconds
  float log_exposure = 0;  ///< its natural logarithm; meaningless unless trusted
  float slope = 0;         ///< by how much that moves when the code does by 1/255; over 0 in a known exposure
  float weight = 0;        ///< over 0 where trusted, 0 elsewhere
  CodeState state = CodeState::kMissing;
};

/// A response and a weighting, tabulated for the codes of a picture: each of its `levels` exactly, and floats (levels
/// 0) computed one by one.
class CodeTable {
 public:
  CodeTable(const Response&, CodeWeight, const TrustedRanges&, int levels);

  CodeValue operator()(int channel, float encoded) const {
    if (table_[0].empty() || !(encoded >= 0 && encoded <= 1)) return compute(channel, encoded);
    return table_[channel][static_cast<std::size_t>(encoded * largest_ + 0.5f)];
  }

 private:
  CodeValue compute(int channel, float encoded) const;
  float slope_at(int channel, float encoded) const;

  Response response_;
  CodeWeight kind_;
  TrustedRanges trusted_;
  float largest_ = 0;
  std::array<std::vector<CodeValue>, 3> table_;
};

/// One table for each exposure of a bracket, pictures of one depth sharing theirs.
class CodeTables {
 public:
  CodeTables(const Exposures&, const Response&, CodeWeight, const TrustedRanges&);
  const CodeTable& operator[](std::size_t exposure) const { return tables_[of_[exposure]]; }

 private:
  std::vector<CodeTable> tables_;
  std::vector<std::size_t> of_;
};

}  // namespace zonal
