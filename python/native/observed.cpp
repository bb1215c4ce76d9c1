#include "python/native/observed.h"

#include <nlohmann/json.hpp>

#include "scene/scene_json.h"

namespace nb = nanobind;

namespace unietp::python {
namespace {

/// The vector as an array of numpy that keeps it alive.
template <class Number>
nb::object owned_array(std::vector<Number> numbers, std::vector<std::size_t> shape) {
  auto* kept = new std::vector<Number>(std::move(numbers));  // the capsule deletes it with the array
  const nb::capsule owner(kept, [](void* memory) noexcept { delete static_cast<std::vector<Number>*>(memory); });
  return nb::cast(nb::ndarray<nb::numpy, Number>(kept->data(), shape.size(), shape.data(), owner));
}

template <class Number>
std::span<Number> part_of(std::vector<Number>& all, std::size_t index, std::size_t size) {
  return std::span(all).subspan(index * size, size);
}

}  // namespace

ArrayBlock::ArrayBlock(std::size_t count, std::size_t rows, std::size_t text_bytes)
    : count_(count),
      rows_(rows),
      text_bytes_(text_bytes),
      things_(count * rows * kThingColumns),
      held_(count * kHeldRows * kHeldColumns),
      last_(count * kLastNumbers),
      counts_(count * kCountNumbers),
      instruction_(count * text_bytes) {}

ObservationArrays ArrayBlock::part(std::size_t environment) {
  return {part_of(things_, environment, rows_ * kThingColumns), part_of(held_, environment, kHeldRows * kHeldColumns),
          part_of(last_, environment, kLastNumbers), part_of(counts_, environment, kCountNumbers),
          part_of(instruction_, environment, text_bytes_)};
}

nb::dict ArrayBlock::to_python(bool batched) && {
  const auto shape = [&](std::vector<std::size_t> own) {
    if (batched) own.insert(own.begin(), count_);
    return own;
  };
  nb::dict arrays;
  arrays["things"] = owned_array(std::move(things_), shape({rows_, kThingColumns}));
  arrays["held"] = owned_array(std::move(held_), shape({kHeldRows, kHeldColumns}));
  arrays["last"] = owned_array(std::move(last_), shape({kLastNumbers}));
  arrays["counts"] = owned_array(std::move(counts_), shape({kCountNumbers}));
  arrays["instruction"] = owned_array(std::move(instruction_), shape({text_bytes_}));
  return arrays;
}

nb::object array_of(std::vector<double> numbers) {
  const auto size = numbers.size();
  return owned_array(std::move(numbers), {size});
}
nb::object array_of(std::vector<std::uint8_t> numbers) {
  const auto size = numbers.size();
  return owned_array(std::move(numbers), {size});
}

nb::object to_python(Picture picture) {
  const auto height = static_cast<std::size_t>(picture.height), width = static_cast<std::size_t>(picture.width);
  return owned_array(std::move(picture.rgb), {height, width, 3});
}

nb::dict to_python(Channels channels, const std::vector<std::string>& ids) {
  const auto height = static_cast<std::size_t>(channels.height), width = static_cast<std::size_t>(channels.width);
  for (std::int32_t& node : channels.node) ++node;
  nb::list names;
  names.append("");
  for (const std::string& id : ids) names.append(id);
  nb::dict arrays;
  arrays["depth"] = owned_array(std::move(channels.depth), {height, width});
  arrays["normals"] = owned_array(std::move(channels.normal), {height, width, 3});
  arrays["instances"] = owned_array(std::move(channels.node), {height, width});
  arrays["ids"] = std::move(names);
  return arrays;
}

nlohmann::ordered_json executed_to_json(const std::vector<ExecutedAction>& executed) {
  auto list = nlohmann::ordered_json::array();
  for (const auto& one : executed) {
    auto row = command_to_json(one.command);
    row["success"] = one.outcome.success;
    row["failure"] = name_of(one.outcome.failure);
    row["feedback"] = one.outcome.feedback;
    row["counted"] = one.counted;
    row["changes"] = nlohmann::ordered_json::parse(delta_to_json(one.changes));
    for (const Delta& moment : one.moments)
      row["moments"].push_back(nlohmann::ordered_json::parse(delta_to_json(moment)));
    list.push_back(std::move(row));
  }
  return list;
}

}  // namespace unietp::python
