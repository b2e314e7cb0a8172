#include "zonal/io/output_folder.h"

#include <system_error>
#include <utility>

#include "zonal/base/error.h"

namespace zonal {
namespace fs = std::filesystem;

OutputFolder::OutputFolder(fs::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  fs::path missing = folder_.has_filename() ? folder_ : folder_.parent_path();
  while (!missing.empty() && !fs::exists(missing, error) && !error) {
    made_.push_back(missing);
    missing = missing.parent_path();
  }
  fs::create_directories(folder_, error);
  if (error || !fs::is_directory(folder_, error)) {
    const std::string why = error ? error.message() : "it is not a folder";
    throw Error(ErrorKind::kOutput, "cannot make the folder " + folder_.string() + ": " + why, "name another folder");
  }
}

OutputFolder::~OutputFolder() {
  files_.clear();
  std::error_code ignored;
  for (const fs::path& folder : made_) fs::remove(folder, ignored);  // only while empty
}

OutputFile& OutputFolder::add(std::string_view name) {
  files_.push_back(std::make_unique<OutputFile>(folder_ / name));
  return *files_.back();
}

void OutputFolder::commit() {
  for (const auto& file : files_) file->flush();  // whatever can fail fails before the first name appears
  for (const auto& file : files_) file->commit();
  made_.clear();
}

}  // namespace zonal
