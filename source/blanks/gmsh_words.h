#pragma once

#include <string>

namespace deltaform
{
  /// The words of a file of Gmsh, one after the other, with the line for messages.
  class GmshWords
  {
  public:
    using Number = long long;

    explicit GmshWords(const std::string &content);

    /// Is there nothing left?
    bool at_end();

    /// The next word. @throws std::invalid_argument at the end of the file
    std::string word();

    /// The rest of this line.
    std::string rest_of_line();

    /// An integer in [@p least, @p most]. @throws std::invalid_argument
    Number integer(const std::string &what, Number least, Number most);

    /// How many things follow that take @p bytes each at least: not more than the rest of the file can hold.
    Number count(const std::string &what, std::size_t bytes);

    /// A finite number of reasonable size. @throws std::invalid_argument
    double coordinate();

    /// Step over @p n words.
    void skip(Number n);

    /// The next word is this one. @throws std::invalid_argument
    void expect(const std::string &expected);

    /// Go after the word @p end. @throws std::invalid_argument if it does not come
    void skip_to(const std::string &end);

    [[noreturn]] void fail(const std::string &message) const;

  private:
    void skip_white();

    const std::string &content_;
    std::size_t place_ = 0;
    unsigned int line_ = 1;
  };
} // namespace deltaform
