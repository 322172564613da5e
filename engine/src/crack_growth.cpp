#include "crack_growth.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <tuple>

#include "neighbours.hpp"

namespace rgimp {

namespace {

/// How a particle hangs together with a flaw.
struct Connection {
  std::int64_t step = 0;  ///< from when on
  double way = 0.0;       ///< m, through the crack to the flaw's layer; shorter ones go first
  std::size_t particle = 0;
  std::size_t source = 0;
  std::size_t flaw = 0;              ///< of the source
  std::optional<std::size_t> crack;  ///< none in a flaw's layer and at the first step out of it

  bool operator>(const Connection& other) const {
    return std::tie(step, way, particle, source, crack) >
           std::tie(other.step, other.way, other.particle, other.source, other.crack);
  }
};

/// Grows all cracks at once, in the order of connection: Dijkstra's shortest paths where a path is
/// as long as the latest failure on it.
class Growth {
 public:
  Growth(const std::vector<FailedParticle>& failed, const CrackScale& scale)
      : failed_(failed),
        two_cells_(2.0 * scale.cell_size),
        neighbours_(failed, scale.pitch),
        connections_(failed.size()) {}

  void grow() {
    for (std::size_t p = 0; p < failed_.size(); ++p) {
      if (failed_[p].source) {
        queue_.push({failed_[p].step, 0.0, p, *failed_[p].source, *failed_[p].flaw, std::nullopt});
      }
    }
    while (!queue_.empty()) {
      Connection next = queue_.top();
      queue_.pop();
      if (!connections_[next.particle]) {
        if (!next.crack && !failed_[next.particle].flaw) {
          next.crack = crack_through(next);
        }
        connections_[next.particle] = next;
        spread(next);
      }
    }
    find_outlines();
  }

  CrackGrowth result() const {
    CrackGrowth growth;
    for (const Mouth& mouth : mouths_) {
      growth.cracks.push_back({mouth.source, {}});
    }
    for (std::size_t p = 0; p < failed_.size(); ++p) {
      const auto crack = crack_of(p);
      if (crack) {
        growth.cracks[*crack].particles.push_back({connections_[p]->step, failed_[p].position});
      } else {
        ++(connections_[p] ? growth.outline : growth.elsewhere);
      }
    }
    for (Crack& crack : growth.cracks) {
      std::stable_sort(
          crack.particles.begin(), crack.particles.end(),
          [](const CrackParticle& a, const CrackParticle& b) { return a.step < b.step; });
    }
    growth.meetings = find_meetings();
    return growth;
  }

 private:
  /// Where a crack leaves its flaw's layer.
  struct Mouth {
    std::size_t source;
    std::size_t particle;  // the first one out
    bool is_outline = false;
  };

  /// Of those that leave the layer at a source, the first whose mouth a particle lies in: within
  /// two cells, one for the layer and one for a crack that crosses it obliquely.
  std::optional<std::size_t> find_crack(std::size_t source, std::size_t particle) const {
    const auto found = std::find_if(mouths_.begin(), mouths_.end(), [&](const Mouth& mouth) {
      const Vector apart = failed_[mouth.particle].position - failed_[particle].position;
      return !mouth.is_outline && mouth.source == source && apart.norm() <= two_cells_;
    });
    return found == mouths_.end() ? std::nullopt
                                  : std::optional<std::size_t>(found - mouths_.begin());
  }

  std::size_t crack_through(const Connection& exit) {
    const auto crack = find_crack(exit.source, exit.particle);
    if (!crack) {
      mouths_.push_back({exit.source, exit.particle});
    }
    return crack.value_or(mouths_.size() - 1);
  }

  /// The steps of an oblique face on the grid may stick out of the layer; what never gets two cells
  /// from its flaw, nor to a crack of another, is no crack yet.
  void find_outlines() {
    std::vector<char> is_crack(mouths_.size(), 0);
    for (std::size_t p = 0; p < failed_.size(); ++p) {
      if (!connections_[p] || !connections_[p]->crack) {
        continue;
      }
      bool counts = failed_[p].distance > two_cells_;
      neighbours_.for_each(p, [&](std::size_t other) {
        counts =
            counts || (connections_[other] && connections_[other]->flaw != connections_[p]->flaw);
      });
      if (counts) {
        is_crack[*connections_[p]->crack] = 1;
      }
    }
    for (std::size_t crack = 0; crack < mouths_.size(); ++crack) {
      mouths_[crack].is_outline = is_crack[crack] == 0;
    }
  }

  /// Cracks leave a flaw's layer but do not run along in it.
  void spread(const Connection& from) {
    neighbours_.for_each(from.particle, [&](std::size_t other) {
      if (!connections_[other] && !failed_[other].flaw) {
        const double way = (failed_[other].position - failed_[from.particle].position).norm();
        queue_.push({std::max(from.step, failed_[other].step), from.way + way, other, from.source,
                     from.flaw, from.crack});
      }
    });
  }

  /// None: an outline of a flaw, or connected to none.
  std::optional<std::size_t> crack_of(std::size_t particle) const {
    const auto& connection = connections_[particle];
    if (!connection) {
      return std::nullopt;
    }
    if (!connection->crack) {
      return find_crack(connection->source, particle);
    }
    return mouths_[*connection->crack].is_outline ? std::nullopt : connection->crack;
  }

  /// Cracks meet out of the layers, or where one comes to the layer of another flaw.
  bool can_meet(std::size_t a, std::size_t b) const {
    const auto& one = connections_[a];
    const auto& other = connections_[b];
    if (!one || !other || one->source == other->source) {
      return false;
    }
    const bool out = crack_of(a) && one->crack;
    const bool other_out = crack_of(b) && other->crack;
    return (out && other_out) || ((out || other_out) && one->flaw != other->flaw);
  }

  CrackPlace place_of(std::size_t particle) const {
    return {connections_[particle]->source, crack_of(particle)};
  }

  std::vector<Meeting> find_meetings() const {
    std::map<std::pair<CrackPlace, CrackPlace>, Meeting> first;
    for (std::size_t a = 0; a < failed_.size(); ++a) {
      neighbours_.for_each(a, [&](std::size_t b) {
        if (b < a || !can_meet(a, b)) {
          return;
        }
        const auto [one, other] = std::minmax({place_of(a), place_of(b)});
        const Meeting meeting{std::max(connections_[a]->step, connections_[b]->step), one, other,
                              0.5 * (failed_[a].position + failed_[b].position)};
        const auto [found, is_new] = first.try_emplace({one, other}, meeting);
        if (!is_new && meeting.step < found->second.step) {
          found->second = meeting;
        }
      });
    }
    std::vector<Meeting> meetings;
    meetings.reserve(first.size());
    for (const auto& [places, meeting] : first) {
      meetings.push_back(meeting);
    }
    return meetings;
  }

  const std::vector<FailedParticle>& failed_;
  double two_cells_;  // m
  Neighbours neighbours_;
  std::priority_queue<Connection, std::vector<Connection>, std::greater<>> queue_;
  std::vector<std::optional<Connection>> connections_;
  std::vector<Mouth> mouths_;  // of each crack
};

}  // namespace

CrackGrowth grow_cracks(const std::vector<FailedParticle>& failed, const CrackScale& scale) {
  Growth growth(failed, scale);
  growth.grow();
  return growth.result();
}

}  // namespace rgimp
