// The C++ library of WebAssembly comes without exceptions. The compiler still turns `throw` into calls of the two
// functions below, and they hand the message to the page, which ends the run: nothing is caught inside the module, and
// a run that failed leaves nothing behind but its instance.
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string>
#include <typeinfo>

#include "apps/web/host.h"
#include "zonal/base/error.h"

namespace {

constexpr const char* kOwnFault = "the library broke a promise of its own: ";

}  // namespace

extern "C" void* __cxa_allocate_exception(std::size_t size) noexcept { return std::malloc(size); }

extern "C" void __cxa_free_exception(void* exception) noexcept { std::free(exception); }

extern "C" void __cxa_throw(void* exception, std::type_info* type, void (*)(void*)) {
  if (*type == typeid(zonal::Error)) {
    const auto& error = *static_cast<const zonal::Error*>(exception);
    zonal::fail(error.what(), error.hint());
  }
  if (*type == typeid(std::logic_error)) {
    zonal::fail(std::string(kOwnFault) + static_cast<const std::logic_error*>(exception)->what(), "please report it");
  }
  if (*type == typeid(std::bad_alloc)) {
    zonal::fail("there is not enough memory in a page for this picture", "make it smaller, or use the command");
  }
  zonal::fail(std::string(kOwnFault) + type->name(), "please report it");
}

void* operator new(std::size_t size) {
  void* memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
