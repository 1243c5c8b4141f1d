// The larger one is the outer one; what is wrong with the pair the run says.
#include "steering/wall_order.h"

#include "input/input_mesh.h"

namespace isoscope {
namespace {

using Answer = Result<WallOrder::Walls>;

Result<double> size_of(const std::string& file, const RunControl& control) {
  const auto mesh = read_input_mesh(file, control);
  if (!mesh) return mesh.error();
  return length(mesh->soup.bounds().extent());
}

} // namespace

WallOrder::WallOrder(std::function<void()> notify)
    : worker_(
          [](const Question& q, RunControl& control) {
            const auto one = size_of(q.one, control), other = size_of(q.other, control);
            if (!one) return std::make_shared<const Answer>(one.error());
            if (!other) return std::make_shared<const Answer>(other.error());
            return std::make_shared<const Answer>(*one < *other ? Walls{q.other, q.one}
                                                                : Walls{q.one, q.other});
          },
          std::move(notify)) {}

void WallOrder::ask(std::string one, std::string other) {
  worker_.ask({std::move(one), std::move(other)});
}

std::optional<Result<WallOrder::Walls>> WallOrder::take() {
  const auto answered = worker_.answered();
  if (!answered || answered == taken_) return std::nullopt;
  taken_ = answered;
  return *answered->answer;
}

} // namespace isoscope
