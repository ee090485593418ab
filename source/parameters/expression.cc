#include <deltaform/parameters/ceilings.h>
#include <deltaform/parameters/expression.h>
#include <deltaform/parameters/text.h>

#include <muParser.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace deltaform
{
  struct Expression::Parser
  {
    mu::Parser parser;
    double time = 0.;
  };

  namespace
  {
    // muParser leaves these out, or has had several meanings of them.
    double natural_logarithm(const double x)
    {
      return std::log(x);
    }
    double power(const double x, const double y)
    {
      return std::pow(x, y);
    }
    double choose(const double condition, const double yes, const double no)
    {
      return condition != 0. ? yes : no;
    }
    double round_up(const double x)
    {
      return std::ceil(x);
    }
    double round_down(const double x)
    {
      return std::floor(x);
    }

    /// Names that may stand in a formula, for one that does not.
    std::string known_names(const Constants &constants)
    {
      std::string result = "t";
      for (const auto &constant : constants)
        result += ", " + constant.first;
      return result + ", pi and functions such as sin, exp, sqrt, min, max, if";
    }

    /// "12 kN", "1mm": a number and a word behind it.
    bool has_unit(const std::string &text)
    {
      char *end = nullptr;
      std::strtod(text.c_str(), &end);
      const std::string rest = text::trim(end);
      return end != text.c_str() && !rest.empty() && std::isalpha(static_cast<unsigned char>(rest.front()));
    }

    /// What may be meant by a text that muParser does not understand.
    std::string hint(const std::string &text, const mu::Parser::exception_type &error, const Constants &constants)
    {
      if (has_unit(text))
        return "; numbers stand without a unit, in those of the entry Units";
      if (text.find("**") != std::string::npos)
        return "; a power is written t^2";
      if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN && !error.GetToken().empty() &&
          std::isalpha(static_cast<unsigned char>(error.GetToken().front())))
        return "; known here: " + known_names(constants);
      return "";
    }
  } // namespace

  Expression::Expression(const std::string &text, const Constants &constants)
    : parser_(std::make_shared<Parser>())
  {
    if (text.size() > ceilings::expression_bytes)
      throw std::invalid_argument("a formula has at most " + std::to_string(ceilings::expression_bytes) +
                                  " characters; this one has " + std::to_string(text.size()));
    auto &parser = parser_->parser;
    int n_values = 1;
    try
    {
      parser.DefineFun("log", natural_logarithm);
      parser.DefineFun("pow", power);
      parser.DefineFun("if", choose);
      parser.DefineFun("ceil", round_up);
      parser.DefineFun("floor", round_down);
      parser.DefineConst("pi", 3.14159265358979323846);
      for (const auto &[name, value] : constants)
        parser.DefineConst(name, value);
      parser.DefineVar("t", &parser_->time);
      parser.SetExpr(text);
      parser.Eval(n_values); // muParser reads the text only now, and complains only now
    }
    catch (const mu::Parser::exception_type &error)
    {
      std::string why = text::trim(error.GetMsg());
      if (!why.empty() && why.back() == '.')
        why.pop_back();
      throw std::invalid_argument("cannot evaluate '" + text + "': " + why + hint(text, error, constants));
    }
    // Of several values muParser would take the last one.
    if (n_values != 1)
      throw std::invalid_argument("'" + text + "' is " + std::to_string(n_values) +
                                  " numbers; decimals are written with a point: 0.8, not 0,8");
  }

  double Expression::operator()(const double time) const
  {
    parser_->time = time;
    return parser_->parser.Eval();
  }

  bool Expression::depends_on_time() const
  {
    return parser_->parser.GetUsedVar().count("t") > 0;
  }

  double evaluate_number(const std::string &text, const Constants &constants)
  {
    const std::string number = text::trim(text);
    if (number.empty())
      throw std::invalid_argument("a number is missing");
    char *end = nullptr;
    double value = std::strtod(number.c_str(), &end);
    if (*end != '\0')
    {
      const Expression expression(number, constants);
      if (expression.depends_on_time())
        throw std::invalid_argument("'" + number + "' depends on t, but must be a constant");
      value = expression(0.);
    }
    if (!std::isfinite(value))
      throw std::invalid_argument("must be a finite number");
    return value;
  }
} // namespace deltaform
