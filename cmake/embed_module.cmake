# Writes OUTPUT, a C++ source that holds FILE, the WebAssembly module, and the text NOTICES, for apps/web/module.h.
file(READ ${FILE} bytes HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
file(READ ${NOTICES} notices)
file(WRITE ${OUTPUT} "#include \"apps/web/module.h\"

namespace zonal {
namespace {

constexpr unsigned char kModule[] = {${bytes}};

}  // namespace

std::span<const std::byte> web_module() { return std::as_bytes(std::span(kModule)); }

std::string_view web_notices() {
  return R\"~(${notices})~\";
}

}  // namespace zonal
")
