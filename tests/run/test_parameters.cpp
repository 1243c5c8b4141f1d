// Parameters: what is read, what is refused, and what the refusal says.
#include "run/parameters.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace isoscope;

namespace {

Result<Tolerance> read_tolerance(const char* text) {
  return read_field<Tolerance>(field_of(&RunParameters::tolerance), "--tolerance", text);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("Tolerances are percentages or lengths") {
  const auto percent = read_tolerance("0.6%");
  REQUIRE(percent.ok());
  CHECK(percent->percent);
  CHECK(percent->value == 0.6);
  CHECK(percent->absolute(50) == doctest::Approx(0.3));
  CHECK(percent->text() == "0.6%");
  const auto length = read_tolerance("0.012");
  REQUIRE(length.ok());
  CHECK(!length->percent);
  CHECK(length->absolute(50) == 0.012);
  CHECK(length->text() == "0.012");
  CHECK(read_tolerance("1e-3").ok());
}

TEST_CASE("What is no positive finite number is refused as a tolerance, by name") {
  for (const char* text :
       {"", "%", "0", "0%", "-1", "-0.5%", "nan", "inf", "1 %", "1.2.3", "0.6 percent", "1e999"}) {
    const auto tolerance = read_tolerance(text);
    CAPTURE(text);
    REQUIRE(!tolerance.ok());
    CHECK(tolerance.error().code == ErrorCode::usage);
    CHECK(contains(tolerance.error().line(), "--tolerance"));
    CHECK(contains(tolerance.error().line(), "'" + std::string(text) + "'"));
  }
}

TEST_CASE("γ of the ball test is a number from 1.2 to 8, auto or off") {
  const auto read = [](const char* text) {
    return read_field<BallTestFactor>(field_of(&RunParameters::gamma), "--gamma", text);
  };
  for (const char* text : {"auto", "off", "2", "1.2", "8"}) {
    CAPTURE(text);
    const auto gamma = read(text);
    REQUIRE(gamma.ok());
    CHECK(gamma->text() == text);
  }
  CHECK(RunParameters().gamma.gamma == BallTestFactor::automatic);
  for (const char* text : {"", "0", "-1", "nan", "2x"}) {
    CAPTURE(text);
    CHECK_FALSE(read(text).ok());
  }
  for (const double gamma : {1.1, 9.0}) {
    RunParameters parameters;
    parameters.gamma.gamma = gamma;
    CHECK_FALSE(check(parameters).ok());
  }
}

TEST_CASE("Levels are two numbers, the smaller first, or none") {
  const auto read = [](const char* text) {
    return read_field<Levels>(field_of(&RunParameters::levels), "--levels", text);
  };
  const auto levels = read("-0.5 1e3");
  REQUIRE(levels.ok());
  CHECK(*levels == Levels{-0.5, 1000});
  CHECK(levels->text() == "-0.5 1000");
  REQUIRE(read("none").ok());
  CHECK_FALSE(read("none")->given());
  for (const char* text : {"", "1", "1 1", "2 1", "1 2 3", "a b", "nan 1", "0 inf", "1,2"}) {
    CAPTURE(text);
    REQUIRE_FALSE(read(text).ok());
    CHECK(contains(read(text).error().line(), "--levels"));
  }
}

TEST_CASE("Each number outside its range is refused with option, value and range") {
  RunParameters good;
  good.input = "gallery:sphere";
  CHECK(check(good).ok());
  const auto refused = [&](auto&& edit, const char* option) {
    RunParameters p = good;
    edit(p);
    const Status status = check(p);
    CAPTURE(option);
    REQUIRE(!status.ok());
    CHECK(status.error().code == ErrorCode::usage);
    CHECK(contains(status.error().line(), option));
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {-0.1, 1.1, nan}) refused([&](RunParameters& p) { p.sigma = bad; }, "--sigma");
  for (const double bad : {0.0, 1.0, -1.0, nan}) refused([&](RunParameters& p) { p.alpha = bad; }, "--alpha");
  for (const double bad : {0.0, 1.5, nan}) refused([&](RunParameters& p) { p.shrink = bad; }, "--shrink");
  for (const double bad : {-1.0, nan}) refused([&](RunParameters& p) { p.time_limit = bad; }, "--time-limit");
  for (const double bad : {-1.0, nan})
    refused([&](RunParameters& p) { p.memory_limit = bad; }, "--memory-limit");
  for (const double bad : {0.0, -1.0, 101.0, nan}) {
    refused([&](RunParameters& p) { p.tolerance = {bad, true}; }, "--tolerance");
  }
  good.sigma = good.shrink = 1;
  CHECK(check(good).ok());
}

TEST_CASE("Criteria follow from the parameters") {
  RunParameters p;
  CHECK(p.criteria(2.0).sigma == 1.0);
  CHECK(p.criteria(2.0).certified);
  p.containment = Containment::sampled;
  CHECK(p.criteria(2.0).sigma == 0.25);
  CHECK(!p.criteria(2.0).certified);
  p.sigma = 0.1;
  p.conditions[2] = false;
  p.alpha = 0.5;
  const CriteriaParameters c = p.criteria(2.0);
  CHECK(c.sigma == doctest::Approx(0.2));
  CHECK(c.error_limit() == 0.5);
  CHECK(c.height_limit() == doctest::Approx(0.8));
  CHECK(!c.condition_3);
  CHECK(c.condition_1);
}
