#include "authoring/template_in_words.h"

#include <algorithm>
#include <cctype>

#include "akb/table_words.h"
#include "annotator/instruction.h"
#include "core/text.h"
#include "templates/init_shape.h"
#include "templates/word_meanings.h"

namespace unietp {
namespace {

/// A noun for a placeholder that is part of no other word.
std::string stand_in(std::size_t index) {
  std::string letters;
  for (++index; index > 0; index /= 26) letters += static_cast<char>('a' + index % 26);
  return "placeholder" + letters + "q";
}

bool stands_for(const Parameter& parameter, const char* what) {
  return parameter.affordances == std::vector<std::string>{what};
}

/// A knowledge base whose categories are the placeholders.
Knowledge of_placeholders(const Template& source) {
  Category spare;  // its rooms, colors and materials
  spare.name = spare.display = "spare";
  spare.plural = "spares";
  spare.source = {"curated", 1};
  std::vector<Category> categories;
  for (std::size_t i = 0; i < source.parameters.size(); ++i) {
    const auto name = stand_in(i);
    if (stands_for(source.parameters[i], "room")) {
      spare.rooms.push_back(name);
    } else if (stands_for(source.parameters[i], "colour")) {
      spare.colors.push_back(name);
    } else if (stands_for(source.parameters[i], "material")) {
      spare.materials.push_back(name);
    } else {
      auto category = spare;
      category.name = category.display = name;
      category.plural = name + "s";
      category.rooms = category.colors = category.materials = {};
      category.movable = true;
      categories.push_back(std::move(category));
    }
  }
  categories.push_back(std::move(spare));
  std::sort(categories.begin(), categories.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return Knowledge(Simulator::Ai2thor, std::move(categories), {}, {}, {}, {});
}

std::string with_placeholders(std::string text, const Template& source) {
  for (std::size_t i = 0; i < source.parameters.size(); ++i) {
    const auto written = "<" + source.parameters[i].name + ">";
    auto name = stand_in(i);
    for (const bool first : {false, true}) {
      if (first) name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
      text = replace_all(text, name + "s", written);
      text = replace_all(text, name, written);
    }
  }
  return text;
}

std::string domain_in_words(const Domain& domain) {
  if (domain.kind == Domain::Kind::Object) return "object";
  if (domain.kind == Domain::Kind::Room) return "room";
  if (domain.kind == Domain::Kind::Agent) return "agent";
  std::vector<std::string> names;
  for (const auto& member : domain.members)
    names.push_back((member.slice ? "slice of <" : "<") + member.category + ">");
  return join(names, " or ");
}

std::string literal_in_words(const StartLiteral& literal) {
  auto word = replace_all(std::string(info(literal.predicate).name), "_", " ");
  if (literal.predicate == Predicate::InRoom) word = literal.relation ? "in" : "where the agent is";
  if (literal.predicate == Predicate::Nearest) word = "nearest to";
  if (literal.relation) return word + (literal.positive ? " a " : " no ") + domain_in_words(literal.other);
  if (!literal.symbol.empty()) word += " " + literal.symbol;
  return (literal.positive ? "" : "not ") + word;
}

}  // namespace

std::optional<std::string> goal_in_words(const Template& source) {
  std::vector<NameBinding> bindings;
  for (std::size_t i = 0; i < source.parameters.size(); ++i) {
    bindings.push_back({source.parameters[i].name, {stand_in(i)}});
  }
  Specification specification;
  specification.template_name = source.name;
  specification.split = source.split;
  specification.goal = substitute_names(source.goal, bindings);
  const Knowledge knowledge = of_placeholders(source);
  const auto written = write_instruction(specification, knowledge, NounTable(knowledge, {}), {}, Rng(0));
  if (!written) return std::nullopt;
  return with_placeholders(written->text, source);
}

std::string start_in_words(const Formula& start) {
  const auto noun = domain_in_words(start.domain);
  std::vector<std::string> literals;
  for (const auto& literal : start_literals(start)) literals.push_back(literal_in_words(literal));
  const auto body = join(literals, " and ");
  if (start.op == Formula::Op::Forall) return "every " + noun + " is " + body;
  const std::string exactly = start.comparison == Comparison::Equal ? "exactly " : "at least ";
  const auto how_many = start.op == Formula::Op::Count ? exactly + std::to_string(start.number) : "at least 1";
  return how_many + " " + noun +
         (body.empty() ? "" : " that " + std::string(demanded_count(start) == 1 ? "is " : "are ") + body);
}

std::string parameter_in_words(const Parameter& parameter) {
  std::vector<std::string> says;
  for (const auto& word : parameter.affordances) {
    for (const auto& known : all_affordances()) {
      if (known.name == word) says.emplace_back(known.meaning);
    }
    for (const auto& known : pseudo_affordance_meanings()) {
      if (known.word == word) says.emplace_back(known.says);
    }
  }
  return join(says, "; ");
}

}  // namespace unietp
