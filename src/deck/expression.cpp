#include "perinox/deck/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "perinox/deck/scalar.hpp"

namespace perinox::deck {

struct Expression::Compiled {
  double x = 0, y = 0, z = 0, t = 0;
  mu::Parser parser;
  bool uses_time = false, uses_position = false;

  Compiled() {
    parser.ClearConst();
    parser.DefineVar("x", &x);
    parser.DefineVar("y", &y);
    parser.DefineVar("z", &z);
    parser.DefineVar("t", &t);
    parser.DefineConst("pi", 3.14159265358979323846);
  }
};

namespace {

constexpr std::size_t longest_formula = 10000;
constexpr std::size_t deepest_formula = 100;

/// Refuses a formula at a place within it. Characters count from 1.
[[noreturn]] void refuse_formula(const Location& where, const std::string& formula, std::size_t position,
                                 const std::string& sentence) {
  refuse(where, fmt::format("the formula '{}' cannot be read at character {}: {}", formula, position + 1, sentence));
}

std::vector<std::string> known_names(const mu::Parser& parser) {
  std::vector<std::string> names{"x", "y", "z", "t", "pi"};
  for (const auto& function : parser.GetFunDef()) names.push_back(function.first);
  return names;
}

bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool continues_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Checks that every name in the formula is known. `1e3` is a number, not a name.
void check_names(const std::string& formula, const mu::Parser& parser, const Location& where) {
  const std::vector<std::string> names = known_names(parser);
  for (std::size_t i = 0; i < formula.size();) {
    const auto character = static_cast<unsigned char>(formula[i]);
    if (std::isdigit(character) || formula[i] == '.') {
      while (i < formula.size() && (std::isdigit(static_cast<unsigned char>(formula[i])) || formula[i] == '.')) ++i;
      if (i < formula.size() && (formula[i] == 'e' || formula[i] == 'E')) {
        std::size_t power = i + 1;
        if (power < formula.size() && (formula[power] == '+' || formula[power] == '-')) ++power;
        if (power < formula.size() && std::isdigit(static_cast<unsigned char>(formula[power]))) i = power;
      }
      continue;
    }
    if (!starts_name(formula[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < formula.size() && continues_name(formula[end])) ++end;
    const std::string name = formula.substr(i, end - i);
    if (name == "and") refuse_formula(where, formula, i, "'and' is not an operator; write &&");
    if (name == "or") refuse_formula(where, formula, i, "'or' is not an operator; write ||");
    if (name == "not") refuse_formula(where, formula, i, "'not' is not an operator; write (...) == 0");
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      const std::string hint = did_you_mean(name, names);
      refuse_formula(
          where, formula, i,
          fmt::format("{} is not known{}", name,
                      hint.empty() ? "; a formula may use x, y, z, t, pi and functions such as sin, exp, sqrt" : hint));
    }
    i = end;
  }
}

/// Refuses characters of other languages, before what stands behind them is found odd.
void check_characters(const std::string& formula, const Location& where) {
  for (std::size_t i = 0; i < formula.size(); ++i) {
    const std::string two = formula.substr(i, 2);
    const bool compared = i > 0 && std::string("=<>!").find(formula[i - 1]) != std::string::npos;
    if (formula[i] == ';') refuse_formula(where, formula, i, "a formula has no ;: join conditions with && or ||");
    if (formula[i] == '#') refuse_formula(where, formula, i, "a formula has no comment: close its quotes before the #");
    if (formula[i] == '%') refuse_formula(where, formula, i, "% has no meaning in a formula; write a plain number");
    if (!compared && two == "=>") refuse_formula(where, formula, i, "write >= for 'at least'");
    if (!compared && two == "=<") refuse_formula(where, formula, i, "write <= for 'at most'");
  }
}

/// Refuses operators that muParser would read otherwise than the user meant: `x = 1` assigns, `0 < z < 1` compares a
/// truth value, `&` and `|` are half an operator, and a comma outside a function drops everything before it.
void check_operators(const std::string& formula, const Location& where) {
  struct Level {
    bool compared = false, function = false;
  };
  std::vector<Level> levels(1);
  const auto is = [&](std::size_t i, const char* two) { return formula.compare(i, 2, two) == 0; };
  for (std::size_t i = 0; i < formula.size(); ++i) {
    const char c = formula[i];
    if (c == '(') {
      levels.push_back({false, i > 0 && continues_name(formula[i - 1])});
      if (levels.size() > deepest_formula) refuse_formula(where, formula, i, "too many parentheses inside each other");
    } else if (c == ')') {
      if (levels.size() == 1) refuse_formula(where, formula, i, "this parenthesis was never opened");
      levels.pop_back();
    } else if (c == ',') {
      if (!levels.back().function)
        refuse_formula(where, formula, i, "a comma may only separate a function's arguments; decimals have a point");
      levels.back().compared = false;
    } else if (is(i, "&&") || is(i, "||")) {
      levels.back().compared = false;
      ++i;
    } else if (c == '&' || c == '|') {
      refuse_formula(where, formula, i, fmt::format("write {0}{0} instead of {0}", c));
    } else if (c == '?' || c == ':') {
      levels.back().compared = false;
    } else if (c == '"' || c == '\'') {
      refuse_formula(where, formula, i, "a formula has no quoted text");
    } else if (is(i, "**")) {
      refuse_formula(where, formula, i, "write ^ for a power");
    } else if (is(i, "==") || is(i, "<=") || is(i, ">=") || is(i, "!=") || c == '<' || c == '>') {
      if (levels.back().compared) {
        refuse_formula(where, formula, i, "comparisons cannot be chained; write a < x && x < b");
      }
      levels.back().compared = true;
      if (i + 1 < formula.size() && formula[i + 1] == '=') ++i;
    } else if (c == '=') {
      refuse_formula(where, formula, i, "write == to compare");
    } else if (c == '!') {
      refuse_formula(where, formula, i, "write (...) == 0 for 'not'");
    }
  }
  if (levels.size() > 1) refuse_formula(where, formula, formula.size(), "a parenthesis is not closed");
}

std::string reason(const mu::ParserError& error) {
  switch (error.GetCode()) {
    case mu::ecUNEXPECTED_EOF:
      return "it ends too early";
    case mu::ecUNEXPECTED_OPERATOR:
      return fmt::format("the operator {} does not belong here", error.GetToken());
    case mu::ecUNEXPECTED_VAL:
      return fmt::format("an operator is missing before {}", error.GetToken());
    case mu::ecUNEXPECTED_VAR:
      return fmt::format("an operator is missing before {}", error.GetToken());
    case mu::ecUNEXPECTED_FUN:
      return fmt::format("an operator is missing before {}", error.GetToken());
    case mu::ecUNEXPECTED_PARENS:
      return fmt::format("the parenthesis {} does not belong here", error.GetToken());
    case mu::ecTOO_MANY_PARAMS:
      return fmt::format("{} has too many arguments", error.GetToken());
    case mu::ecTOO_FEW_PARAMS:
      return fmt::format("{} has too few arguments", error.GetToken());
    default:
      break;
  }
  std::string text = error.GetMsg();
  while (!text.empty() && (text.back() == '.' || text.back() == '\n')) text.pop_back();
  return text;
}

}  // namespace

Expression::Expression() : Expression(0.0) {}

Expression::Expression(double value) : text_(format_number(value)), constant_(value) {}

Expression::Expression(std::string formula, const Location& where) : text_(std::move(formula)) {
  if (const auto number = parse_number(text_)) {
    constant_ = *number;
    return;
  }
  if (std::all_of(text_.begin(), text_.end(), [](char c) { return std::isspace(static_cast<unsigned char>(c)); })) {
    refuse(where, "the formula is empty; write a number or a formula of x, y, z and t");
  }
  if (text_.size() > longest_formula) {
    refuse(where, fmt::format("the formula has {} characters; at most {} are read", text_.size(), longest_formula));
  }
  auto compiled = std::make_shared<Compiled>();
  check_characters(text_, where);
  check_names(text_, compiled->parser, where);
  check_operators(text_, where);
  try {
    compiled->parser.SetExpr(text_);
    compiled->parser.Eval();
    const auto& used = compiled->parser.GetUsedVar();
    compiled->uses_time = used.count("t") > 0;
    compiled->uses_position = used.count("x") + used.count("y") + used.count("z") > 0;
  } catch (const mu::ParserError& error) {
    const auto position = error.GetPos() < 0 ? text_.size() : static_cast<std::size_t>(error.GetPos());
    refuse_formula(where, text_, std::min(position, text_.size()), reason(error));
  }
  compiled_ = std::move(compiled);
}

double Expression::operator()(double x, double y, double z, double t) const {
  if (!compiled_) return constant_;
  compiled_->x = x;
  compiled_->y = y;
  compiled_->z = z;
  compiled_->t = t;
  return compiled_->parser.Eval();
}

bool Expression::uses_time() const { return compiled_ && compiled_->uses_time; }
bool Expression::uses_position() const { return compiled_ && compiled_->uses_position; }

}  // namespace perinox::deck
