// Reading values, and judging what is expected of them.
#include "command/named_values.h"

#include <algorithm>
#include <array>
#include <iomanip>
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

Status NamedValues::judge(const std::string& name, const std::string& op, const std::string& word) const {
  static constexpr std::array<std::string_view, 6> operators{"==", "!=", "<", "<=", ">", ">="};
  const NamedValue* value = find(name);
  if (value == nullptr) return wrong_value(name, "a value that has a name (F1 lists them)");
  if (std::find(operators.begin(), operators.end(), op) == operators.end())
    return wrong_value(op, "== != < <= > or >=");
  const std::string found = value->get();
  // What a value is called may also be what another one is.
  const NamedValue* other = found == word ? nullptr : find(word);
  const std::string wanted = other != nullptr ? other->get() : word;
  const auto a = read_number(found), b = read_number(wanted);
  const bool numbers = a && b;
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
