#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace zonal {

/// The instruction sets our kernels are compiled for, weakest first.
enum class Isa { kBaseline, kAvx2, kAvx512 };

/// The strongest instruction set this machine and this build have. Asked once.
Isa best_isa();

/// Every instruction set that can run here, weakest first; tests run each kernel on each.
std::vector<Isa> available_isas();

std::string_view name_of(Isa);
std::optional<Isa> isa_named(std::string_view name);

}  // namespace zonal
