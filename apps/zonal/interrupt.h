#pragma once

#include <stop_token>

namespace zonal {

/// Turns an interrupt (Ctrl-C) or a request to terminate into a request to stop, which long verbs notice and clean up
/// after. To be called once, before any thread is started.
std::stop_token stop_on_interrupt();

}  // namespace zonal
