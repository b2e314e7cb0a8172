#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace zonal {

/// Where an item of the panels is, in the window's units, the origin at the top left.
struct WidgetPlace {
  struct Box {
    double left = 0, top = 0, right = 0, bottom = 0;
    double x() const { return 0.5 * (left + right); }
    double y() const { return 0.5 * (top + bottom); }
    bool operator==(const Box&) const = default;
  };
  Box item;
  Box around;  ///< what of the panel or list that holds it is to be seen
  bool visible =
      false;  ///< its middle is, so that a pointer can reach it; else the wheel over `around` brings it there
  bool operator==(const WidgetPlace&) const = default;
};

/// The items of the panels by name, as they were drawn last, for whoever finds them without looking: tests, and
/// programs that press buttons for a person. A control has its own name, an entry of a list "list/entry".
class WidgetPlaces {
 public:
  /// Another frame begins: what is not drawn in it has no place.
  void begin_frame() { places_.clear(); }
  /// The item that was drawn last. Between ImGui's Begin() and End(). `width`: of the part that takes the pointer,
  /// where a label stands beside it; 0: all of it does.
  void note(std::string name, float width = 0);
  std::optional<WidgetPlace> find(std::string_view name) const;

 private:
  std::map<std::string, WidgetPlace, std::less<>> places_;
};

}  // namespace zonal
