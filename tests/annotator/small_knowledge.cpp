#include "small_knowledge.h"

namespace unietp::testing_support {

Knowledge small_knowledge() {
  const auto category = [](const char* name, const char* display, const char* plural, bool countable = true) {
    Category c;
    c.name = name;
    c.display = display;
    c.plural = plural;
    c.countable = countable;
    c.movable = c.name != "CoffeeTable" && c.name != "Fridge" && c.name != "Table";
    c.rooms = {"kitchen", "living_room"};
    c.colors = {"red"};
    c.materials = {"wood"};
    return c;
  };
  std::vector<Category> categories{
      category("Apple", "apple", "apples"),       category("Bowl", "bowl", "bowls"),
      category("Bread", "bread", "bread", false), category("CoffeeTable", "coffee table", "coffee tables"),
      category("Fridge", "fridge", "fridges"),    category("Knife", "knife", "knives"),
      category("Lamp", "lamp", "lamps"),          category("Mug", "mug", "mugs"),
      category("Table", "table", "tables"),       category("Utensil", "utensil", "utensils")};
  const Source source{"curated", 1};
  std::vector<Alias> aliases{{"Bowl", "something to drink from", AliasKind::Function, source},
                             {"Mug", "I'm thirsty.", AliasKind::Occasion, source},
                             {"Bowl", "a piece of tableware", AliasKind::Hypernym, source},
                             {"Mug", "a piece of tableware", AliasKind::Hypernym, source},
                             {"Fridge", "the place where we keep the milk cold", AliasKind::Description, source},
                             {"Lamp", "power_on It's too dark to read.", AliasKind::Request, source},
                             {"Mug", "something to drink from", AliasKind::Function, source},
                             {"Mug", "beaker", AliasKind::Synonym, source}};
  return Knowledge(Simulator::Ai2thor, categories, {}, {}, {}, aliases);
}

Specification asking(const std::string& goal, const std::string& style) {
  Specification specification;
  auto formula = parse_formula("test", goal, FormulaUse::Goal);
  if (formula) specification.goal = *formula;
  specification.style = style_named(style).value();
  return specification;
}

}  // namespace unietp::testing_support
