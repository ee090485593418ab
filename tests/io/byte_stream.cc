// Bytes collected through a stream.
#include <deltaform/io/byte_stream.h>

#include <boost/test/unit_test.hpp>

using namespace deltaform;

BOOST_AUTO_TEST_SUITE(byte_stream)

BOOST_AUTO_TEST_CASE(bytes_come_out_as_they_went_in)
{
  // Nothing, less than a buffer, blocks longer than one, and more than there is room for at first.
  for (const std::size_t length : {std::size_t(0), std::size_t(7), std::size_t(100000), std::size_t(20) << 20})
  {
    std::string written(length, '\0');
    for (std::size_t i = 0; i < length; ++i)
      written[i] = static_cast<char>(i * 37 % 251);
    ByteStream bytes;
    bytes.stream().write(written.data(), static_cast<std::streamsize>(length / 2));
    bytes.stream() << 'x';
    bytes.stream().write(written.data() + length / 2, static_cast<std::streamsize>(length - length / 2));
    BOOST_TEST((bytes.take() == written.substr(0, length / 2) + 'x' + written.substr(length / 2)));
    bytes.stream().flush(); // as the end of an archive does
  }
}

BOOST_AUTO_TEST_SUITE_END()
