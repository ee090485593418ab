// The folder of results is touched when it is known that the run begins, or goes on.
#include <deltaform/reports/accepted_increment.h>
#include <deltaform/results/observers.h>

#include <utility>

namespace deltaform
{
  namespace
  {
    class FolderObserver : public Observer
    {
    public:
      FolderObserver(ResultsFolder &folder, std::function<void(std::ostream &)> print_scene)
        : folder_(folder), print_scene_(std::move(print_scene))
      {
      }

      void begin(const Model & /*model*/, const Stage & /*stage*/) override
      {
        folder_.begin(print_scene_, false);
      }

      void resumed(const AcceptedIncrement & /*increment*/) override
      {
        folder_.begin(print_scene_, true);
      }

    private:
      ResultsFolder &folder_;
      std::function<void(std::ostream &)> print_scene_;
    };
  } // namespace


  std::unique_ptr<Observer> make_folder_observer(ResultsFolder &folder,
                                                 std::function<void(std::ostream &)> print_scene)
  {
    return std::make_unique<FolderObserver>(folder, std::move(print_scene));
  }
} // namespace deltaform
