#include "akb/import_common.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numeric>

#include "akb/fit.h"
#include "akb/row_reader.h"
#include "core/files.h"
#include "core/text.h"

namespace unietp {
namespace {

constexpr double kSizeFactor = 1.4, kMassFactor = 3;
constexpr double kThinnestModel_m = 0.001, kLongestModel_m = 20;  // of a model's box: a sheet of paper is flat upstream

/// To millimeters, so that files stay short.
Vec3 millimeters(const Vec3& v) {
  return {std::round(v.x() * 1000) / 1000, std::round(v.y() * 1000) / 1000, std::round(v.z() * 1000) / 1000};
}

bool has_joint(Archetype archetype) {
  return archetype == Archetype::Cabinet || archetype == Archetype::Drawers || archetype == Archetype::Lidded ||
         archetype == Archetype::Folding;
}

std::array<int, 3> order_of(const Vec3& v) {
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return v[a] < v[b]; });
  return order;
}

/// The extents laid along the axes so that the longest lies where the model's longest does.
Vec3 laid_like(const Vec3& extents, const Vec3& model) {
  const auto from = order_of(extents), to = order_of(model);
  Vec3 laid = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i) laid[to[i]] = extents[from[i]];
  return laid;
}

/// True when each extent is at least `low` and at most `high` times the model's.
bool within(const Vec3& extents, const Vec3& model, double low, double high) {
  const Vec3 ratio = extents.cwiseQuotient(model);
  return ratio.minCoeff() >= low && ratio.maxCoeff() <= high;
}

}  // namespace

std::string words_of(std::string_view name) {
  std::string words;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool upper = std::isupper(static_cast<unsigned char>(name[i])) != 0;
    if (upper && i != 0) words += ' ';
    words += name[i] == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  return words;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[(values.size() - 1) / 2];
}

Vec3 median(const std::vector<Vec3>& values) {
  Vec3 result = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> along;
    for (const auto& value : values) along.push_back(value[axis]);
    result[axis] = median(along);
  }
  return result;
}

Vec3 middle_box(const std::vector<Vec3>& boxes) {
  const Vec3 center = median(boxes);
  const auto distance = [&](const Vec3& box) {
    const Vec3 ratio = box.cwiseQuotient(center);
    return std::max(ratio.maxCoeff(), 1 / ratio.minCoeff());
  };
  return *std::min_element(boxes.begin(), boxes.end(),
                           [&](const Vec3& a, const Vec3& b) { return distance(a) < distance(b); });
}

TableBuilder::TableBuilder(Simulator simulator, std::filesystem::path curated)
    : simulator_(simulator),
      curated_(std::move(curated)),
      lexicon_(read_lexicon(curated_, errors_)),
      groups_(read_kind_groups(curated_ / "kind_groups.csv", errors_)) {
  const auto path = folder() / "category.csv";
  const auto text = read_file(path);
  if (!text) {
    errors_.push_back(text.error());
    return;
  }
  const auto file = read_csv(path.string(), *text);
  errors_.insert(errors_.end(), file.errors.begin(), file.errors.end());
  for (const auto& row : file.rows) {
    const auto& name = row.front().text;
    curated_names_.push_back(name);
    for (std::size_t i = 0; i < row.size(); ++i) cells_[name][file.header[i].text] = row[i].text;
  }
}

std::filesystem::path TableBuilder::folder() const { return curated_ / std::string(name_of(simulator_)); }

std::vector<std::string> TableBuilder::curated_names() const { return curated_names_; }

std::string TableBuilder::curated(const std::string& name, const std::string& column) const {
  const auto row = cells_.find(name);
  if (row == cells_.end()) return {};
  const auto cell = row->second.find(column);
  return cell == row->second.end() ? std::string() : cell->second;
}

void TableBuilder::add(const RawCategory& raw) {
  auto display = curated(raw.name, "display");
  if (display.empty()) display = raw.display.empty() ? words_of(raw.name) : raw.display;
  const auto known = lexicon_.find(display);
  const Word* word = raw.word ? &*raw.word : known != lexicon_.end() ? &known->second : nullptr;
  if (word == nullptr) {
    errors_.push_back({Error::Kind::Schema,
                       (curated_ / "lexicon*.csv").string(),
                       {},
                       "no word '" + display + "' for category '" + raw.name + "'; expected a row for it"});
    return;
  }
  Category c = word->category;
  c.name = raw.name;
  c.movable = raw.movable;
  c.source = raw.source;
  if (raw.extents) {
    const bool as_it_is = within(*raw.extents, c.size, 1 / kSizeFactor, kSizeFactor);
    const Vec3 laid = as_it_is ? *raw.extents : laid_like(*raw.extents, c.size);
    if (within(laid, c.size, 1 / kSizeFactor, kSizeFactor)) {
      c.size = millimeters(laid);
      c.size_source = {raw.extents_source, 0.9};
    }
  }
  if (raw.mass && *raw.mass <= c.mass * kMassFactor && *raw.mass * kMassFactor >= c.mass) {
    c.mass = std::round(*raw.mass * 1000) / 1000;
    c.mass_source = {raw.mass_source, 0.9};
  }
  if (!raw.materials.empty()) c.materials = raw.materials;
  const auto cell = [&](const std::string& column) { return curated(raw.name, column); };
  if (!cell("movable").empty()) c.movable = cell("movable") == "true";
  if (!cell("archetype").empty()) c.archetype = archetype_named(cell("archetype")).value_or(c.archetype);
  if (!cell("width").empty()) {
    c.size = {std::stod(cell("width")), std::stod(cell("depth")), std::stod(cell("height"))};
    c.size_source = {"curated", 0.9};
  }
  if (!cell("mass").empty()) {
    c.mass = std::stod(cell("mass"));
    c.mass_source = {"curated", 0.9};
  }
  if (!cell("rooms").empty()) c.rooms = cell("rooms") == "-" ? std::vector<std::string>{} : split(cell("rooms"), '|');
  if (!cell("materials").empty()) c.materials = split(cell("materials"), '|');
  kinds_[raw.name] = cell("kind").empty() ? word->kind : cell("kind");
  categories_[raw.name] = std::move(c);
}

void TableBuilder::afford(const std::string& category, std::string_view affordance, const std::string& source,
                          double confidence) {
  const auto found = categories_.find(category);
  if (found == categories_.end()) return;
  // What has no door, drawer, lid or hinge in our bodies cannot be opened: blinds, curtains, a toilet's seat.
  if (affordance == "openable" && !has_joint(found->second.archetype)) return;
  affordances_.try_emplace({category, std::string(affordance)},
                           AffordanceFact{category, std::string(affordance), {source, confidence}});
}

bool TableBuilder::has(const std::string& category, std::string_view affordance) const {
  return affordances_.contains({category, std::string(affordance)});
}

void TableBuilder::afford_by_archetype() {
  if (!errors_.empty()) return;  // a group may be missing
  overlay_affordances();
  for (const auto& [name, c] : categories_) {
    if (is_kind(name, KindGroup::HoldsNothing)) continue;
    if (room_of(c, Predicate::Inside) && c.archetype != Archetype::Drawers) {
      afford(name, "container", "derived:archetype", 0.9);
    }
    const bool flat_food = c.archetype == Archetype::Plate && is_kind(name, KindGroup::FlatFood);
    const bool furniture = !c.movable || c.archetype == Archetype::Plate;
    if (furniture && !flat_food && room_of(c, Predicate::On)) afford(name, "receptacle", "derived:archetype", 0.9);
  }
}

void TableBuilder::model(Asset asset) {
  const bool box = asset.size.minCoeff() >= 0 && asset.size.maxCoeff() > 0 && asset.size.maxCoeff() <= kLongestModel_m;
  if (!box || !categories_.contains(asset.category)) return;
  asset.size = millimeters(asset.size).cwiseMax(kThinnestModel_m);
  assets_.try_emplace(asset.name, std::move(asset));
}

void TableBuilder::effect(Effect effect) {
  if (!categories_.contains(effect.tool) || !categories_.contains(effect.target)) return;
  if (effect.treatment == Treatment::Slices && !categories_.contains(effect.gives)) return;
  effects_.try_emplace({effect.tool, name_of(effect.treatment), effect.target, effect.gives}, effect);
}

void TableBuilder::alias(Alias alias) {
  if (!categories_.contains(alias.category)) return;
  aliases_.try_emplace({alias.category, name_of(alias.kind), alias.text}, alias);
}

const Category* TableBuilder::find(const std::string& name) const {
  const auto at = categories_.find(name);
  return at == categories_.end() ? nullptr : &at->second;
}

std::string TableBuilder::kind(const std::string& name) const {
  const auto at = kinds_.find(name);
  return at == kinds_.end() ? std::string() : at->second;
}

std::vector<std::string> TableBuilder::names() const {
  std::vector<std::string> names;
  for (const auto& [name, c] : categories_) names.push_back(name);
  return names;
}

}  // namespace unietp
