#pragma once

#include <cstddef>
#include <string_view>

// What the module asks of the page that runs it (module "page").

namespace zonal {

/// Texts and bytes are places in the module's memory; the page copies them before it returns.
extern "C" {
/// Ends the run: the page throws away the whole instance. `hint` may be empty.
[[noreturn]] __attribute__((import_module("page"), import_name("fail"))) void page_fail(const char* message,
                                                                                        std::size_t message_length,
                                                                                        const char* hint,
                                                                                        std::size_t hint_length);
__attribute__((import_module("page"), import_name("progress"))) void page_progress(const char* stage,
                                                                                   std::size_t stage_length,
                                                                                   double fraction);
__attribute__((import_module("page"), import_name("give"))) void page_give(const char* json, std::size_t json_length,
                                                                           const char* bytes, std::size_t byte_count);
}

[[noreturn]] inline void fail(std::string_view message, std::string_view hint) {
  page_fail(message.data(), message.size(), hint.data(), hint.size());
}

}  // namespace zonal
