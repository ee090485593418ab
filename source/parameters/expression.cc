#include <deltaform/parameters/ceilings.h>
#include <deltaform/parameters/expression.h>
#include <deltaform/parameters/text.h>

#include <muParser.h>

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
  } // namespace

  Expression::Expression(const std::string &text, const Constants &constants)
    : parser_(std::make_shared<Parser>())
  {
    if (text.size() > ceilings::expression_bytes)
      throw std::invalid_argument("a formula has at most " + std::to_string(ceilings::expression_bytes) +
                                  " characters; this one has " + std::to_string(text.size()));
    auto &parser = parser_->parser;
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
      parser.Eval(); // muParser reads the text only now, and complains only now
    }
    catch (const mu::Parser::exception_type &error)
    {
      throw std::invalid_argument("cannot evaluate '" + text + "': " + text::trim(error.GetMsg()));
    }
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
