// Reading values, and judging what is expected of them.
#include "command/named_values.h"

#include <array>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace isoscope {
namespace {

bool compare(double a, const std::string& op, double b) {
  if (op == "==") return a == b;
  if (op == "!=") return a != b;
  if (op == "<") return a < b;
  if (op == "<=") return a <= b;
  if (op == ">") return a > b;
  return a >= b;
}

} // namespace

Error wrong_value(const std::string& text, const std::string& wanted) {
  return {ErrorCode::usage, "\"" + text + "\" is not " + wanted + ".", ""};
}

std::string text_of(double value) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10 - 2);
  out << value;
  return out.str();
}

void NamedValues::add(std::string name, std::string help, std::function<std::string()> get,
                      std::function<Status(const std::string&)> set) {
  values_.push_back({std::move(name), std::move(help), std::move(get), std::move(set)});
}

void NamedValues::add_switch(std::string name, std::string help, bool& place) {
  add(
      std::move(name), std::move(help), [&place] { return on_off(place); },
      [&place](const std::string& text) -> Status {
        const auto on = parse_switch(text);
        if (!on) return on.error();
        place = *on;
        return {};
      });
}

Status NamedValues::judge(const std::string& name, const std::string& op, const std::string& word) const {
  static constexpr std::array<std::string_view, 6> operators{"==", "!=", "<", "<=", ">", ">="};
  const NamedValue* value = find(name);
  if (value == nullptr) return wrong_value(name, "a value that has a name (F1 lists them)");
  if (std::find(operators.begin(), operators.end(), op) == operators.end())
    return wrong_value(op, "== != < <= > or >=");
  const std::string found = value->get();
  const NamedValue* other = find(word);
  const std::string wanted = other != nullptr ? other->get() : word;
  const auto a = parse_number(found), b = parse_number(wanted);
  const bool numbers = a.ok() && b.ok();
  if (!numbers && op != "==" && op != "!=")
    return wrong_value(wanted, "a number (" + name + " is " + found + ")");
  const bool holds = numbers ? compare(*a, op, *b) : (found == wanted) == (op == "==");
  if (holds) return {};
  return Error{ErrorCode::internal, name + " is " + found + ", expected " + op + " " + wanted + ".", ""};
}

const NamedValue* NamedValues::find(std::string_view name) const {
  for (const NamedValue& value : values_)
    if (value.name == name) return &value;
  return nullptr;
}

Result<double> parse_number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || at != end || !std::isfinite(value)) return wrong_value(text, "a finite number");
  return value;
}

Result<bool> parse_switch(const std::string& text) {
  if (text == "on" || text == "true" || text == "1") return true;
  if (text == "off" || text == "false" || text == "0") return false;
  return wrong_value(text, "on or off");
}

Status NamedValues::expect(const std::string& expression) const {
  std::istringstream words(expression);
  std::string name, op, wanted, joint;
  while (true) {
    if (!(words >> name >> op >> std::quoted(wanted)))
      return Error{ErrorCode::usage, "Expected NAME OP VALUE in \"" + expression + "\".",
                   "For example: bad_samples == 0"};
    if (Status s = judge(name, op, wanted); !s) return s;
    if (!(words >> joint)) return {};
    if (joint != "and") return wrong_value(joint, "\"and\"");
  }
}

} // namespace isoscope
