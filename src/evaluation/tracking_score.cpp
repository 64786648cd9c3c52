// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <slamicp/evaluation/tracking_score.hpp>

namespace slamicp {
namespace {

/// A truth and a guess that may be of it.
struct TrackedPair {
  bool is_old;  // they were a pair before
  double distance;
  std::size_t truth;
  std::size_t guess;

  bool operator<(const TrackedPair& other) const noexcept {
    if (is_old != other.is_old) return is_old;
    if (distance != other.distance) return distance < other.distance;
    return truth != other.truth ? truth < other.truth : guess < other.guess;
  }
};

}  // namespace

void TrackingScore::add(std::span<const TrackedTruth> truths, std::span<const TrackedGuess> guesses) {
  std::vector<TrackedPair> pairs;
  for (std::size_t t = 0; t < truths.size(); ++t) {
    const auto before = guess_of_.find(truths[t].id);
    for (std::size_t g = 0; g < guesses.size(); ++g) {
      const double distance = (truths[t].position - guesses[g].position).norm();
      if (distance < reach_)
        pairs.push_back({before != guess_of_.end() && before->second == guesses[g].id, distance, t, g});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<char> truth_taken(truths.size(), 0), guess_taken(guesses.size(), 0);
  for (const TrackedPair& pair : pairs) {
    if (truth_taken[pair.truth] != 0 || guess_taken[pair.guess] != 0) continue;
    truth_taken[pair.truth] = guess_taken[pair.guess] = 1;
    const TrackedTruth& truth = truths[pair.truth];
    const TrackedGuess& guess = guesses[pair.guess];
    const auto [before, is_first] = guess_of_.try_emplace(truth.id, guess.id);
    const bool switched = !is_first && before->second != guess.id;
    before->second = guess.id;
    if (!truth.counts) continue;
    ++found_;
    switches_ += switched ? 1 : 0;
    distance_ += pair.distance;
    velocity2_ += (truth.velocity - guess.velocity).squaredNorm();
  }
  ++frames_;
  truths_ += static_cast<std::size_t>(
      std::count_if(truths.begin(), truths.end(), [](const TrackedTruth& truth) { return truth.counts; }));
  false_ += static_cast<std::size_t>(std::count(guess_taken.begin(), guess_taken.end(), 0));
}

void TrackingScore::next_run() { guess_of_.clear(); }

double TrackingScore::mota() const noexcept {
  const auto wrong = static_cast<double>(missed() + false_ + switches_);
  if (truths_ == 0) return wrong > 0.0 ? -wrong : 1.0;
  return 1.0 - wrong / static_cast<double>(truths_);
}

double TrackingScore::velocity_rmse() const noexcept {
  return found_ > 0 ? std::sqrt(velocity2_ / static_cast<double>(found_)) : 0.0;
}

std::string TrackingScore::brief() const {
  char text[200];
  std::snprintf(text, sizeof text,
                "MOTA %.3f, MOTP %.3f m, velocity %.2f m/s RMS, %zu of %zu found, %zu false, %zu switches", mota(),
                motp(), velocity_rmse(), found_, truths_, false_, switches_);
  return text;
}

}  // namespace slamicp
