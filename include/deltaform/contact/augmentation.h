#pragma once

#include <deltaform/contact/contact_interface.h>

#include <deque>
#include <vector>

namespace deltaform
{
  /**
   * The outer loop of the augmented forms: s := lambda (Uzawa) on all interfaces together. That is a fixed-point
   * iteration whose rate is K_c/(K_c + eps), K_c = (C^T K^-1 C)^-1: slow where eps is soft. Anderson acceleration
   * (Walker, Ni, SIAM J. Numer. Anal. 49 (2011) 1715), which for a fixed set and a linear blank is GMRES, makes the
   * number of rounds nearly independent of eps; the fixed point, gap = 0, stays the same.
   */
  class Augmentation
  {
  public:
    /**
     * @param depth    number of earlier rounds that the acceleration looks back to; 0: plain Uzawa
     * @param patience after every so many rounds ten times the gap is accepted, up to delta, which is allowed: a
     * node at the edge of the contact zone may come and go with the shifts for ever
     */
    explicit Augmentation(unsigned int depth, unsigned int patience = 12);

    /// An increment begins: discard the earlier rounds.
    void restart();

    /// New shifts for all points. @return how many points had to change; 0: all gaps are small enough
    unsigned int update(const std::vector<ContactInterface *> &interfaces);

  private:
    using Values = std::vector<double>;

    /// Append the shifts of the points of an interface, and the forces that Uzawa's iteration makes of them. @return
    /// whether all gaps are small enough, with the law's tolerance times @p relaxation (at most delta)
    static bool collect(const ContactInterface &interface, double relaxation, Values &shifts, Values &forces);

    /// The earlier rounds belong to another problem.
    void discard();

    /// Remember what has changed since the last round.
    void look_back(const Values &shift, const Values &change);

    /// What the acceleration subtracts from the next shifts, after look_back().
    Values correction(const Values &change) const;

    unsigned int depth_, patience_, rounds_ = 0;
    Values last_shift_, last_change_;
    std::vector<bool> loaded_;
    std::deque<Values> shift_differences_, change_differences_;
  };
} // namespace deltaform
