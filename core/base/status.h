// Errors as values: what was wrong, where, and what to do about it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace isoscope {

/// What kind of failure; the batch program's exit status follows from it (2 usage, 3 bad input,
/// 4 stopped).
enum class ErrorCode {
  usage,         ///< an option or a command is wrong
  bad_input,     ///< a file cannot be read or does not describe a surface we can work on
  unsupported,   ///< understood, but not served by this version
  open_surface,  ///< the input has a border that Ω does not close, which this version does not serve
  joined_sheets, ///< sheets of the input meet, cross or lie too near where Ω does not take that in
  io,            ///< a file cannot be written, a disk is full
  cancelled,     ///< stopped by the user or by a limit
  device,        ///< display, OpenGL or font trouble
  internal       ///< an invariant of ours does not hold
};

/// Whether what was given cannot be worked on: not how, but what was asked for.
constexpr bool refuses_input(ErrorCode code) {
  return code == ErrorCode::bad_input || code == ErrorCode::unsupported || code == ErrorCode::open_surface ||
         code == ErrorCode::joined_sheets;
}

/// One failure. `message` is a full sentence that names the place; `remedy` says what to do and may be empty.
struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;
  std::string remedy;

  /// Message and remedy on one line.
  std::string line() const { return remedy.empty() ? message : message + " " + remedy; }
};

/// A value or the Error that prevented it.
template <class T> class [[nodiscard]] Result {
 public:
  Result(T value) : data_(std::move(value)) {}
  Result(Error error) : data_(std::move(error)) {}
  bool ok() const { return data_.index() == 0; }
  explicit operator bool() const { return ok(); }
  T& value() & { return std::get<0>(data_); }
  const T& value() const& { return std::get<0>(data_); }
  T&& value() && { return std::get<0>(std::move(data_)); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  const Error& error() const { return std::get<1>(data_); }

 private:
  std::variant<T, Error> data_;
};

/// Success, or the Error that prevented it.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(Error error) : error_(std::move(error)) {}
  bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }
  const Error& error() const { return *error_; }

 private:
  std::optional<Error> error_;
};

} // namespace isoscope
