#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/zonal/call.h"
#include "apps/zonal/merge_input.h"
#include "apps/zonal/merge_view.h"
#include "zonal/image/align_exposures.h"
#include "zonal/image/deghost.h"
#include "zonal/image/merge_exposures.h"

namespace zonal {

struct MergeOutputs {
  MergeView view;
  std::filesystem::path map, curve, response;  ///< all may be empty
};

/// What is told about a merge beside its picture.
struct MergeFacts {
  std::string response;  ///< as the user named it
  TrustedRanges trusted;
  std::optional<ResponseFit> fit;
  std::vector<Alignment> alignments;
  std::optional<Deghosting> deghosting;
  bool absolute = false;
};

/// Throws Error{kUsage} for names that cannot be written, before any work is done.
void check_merge_outputs(const MergeOutputs&);

/// Writes the files and says what was found.
void write_merge(Merge, const Response&, const Bracket&, const MergeFacts&, const MergeOutputs&, Call&);

}  // namespace zonal
