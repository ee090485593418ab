#include <deltaform/analysis/observer_list.h>
#include <deltaform/io/byte_stream.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <sstream>

namespace deltaform
{
  void ObserverList::announce(const Model &model, Workspace &workspace, const unsigned int number) const
  {
    std::vector<Observer *> wanting;
    for (const auto &observer : all_)
    {
      observer->before(model, number);
      if (observer->wants_tangent())
        wanting.push_back(observer.get());
    }
    if (!wanting.empty())
      workspace.before_contact([wanting](const System &system) {
        for (auto *const observer : wanting)
          observer->tangent_without_contact(system);
      });
  }


  std::string ObserverList::save() const
  {
    ByteStream bytes;
    {
      boost::archive::binary_oarchive archive(bytes.stream());
      for (const auto &observer : all_)
        observer->save(archive);
    }
    return bytes.take();
  }


  void ObserverList::load(const std::string &bytes) const
  {
    std::istringstream stream(bytes);
    boost::archive::binary_iarchive archive(stream);
    for (const auto &observer : all_)
      observer->load(archive);
  }
} // namespace deltaform
