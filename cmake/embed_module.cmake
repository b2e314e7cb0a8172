# Writes OUTPUT, a C++ source that holds FILE, the WebAssembly module, as web_module() of apps/web/module.h.
file(READ ${FILE} bytes HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
file(WRITE ${OUTPUT} "#include \"apps/web/module.h\"

namespace zonal {
namespace {

constexpr unsigned char kModule[] = {${bytes}};

}  // namespace

std::span<const std::byte> web_module() { return std::as_bytes(std::span(kModule)); }

}  // namespace zonal
")
