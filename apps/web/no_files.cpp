// A page has no file system: pictures come as bytes.
#include "zonal/io/byte_reader.h"

namespace zonal {

ByteReader::ByteReader(const std::filesystem::path& path) : name_(path.string()) { fail("a page opens no paths"); }

}  // namespace zonal
