// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"

#include <vector>

namespace abut::audit {

/// Sends questions to ranks, (ranks) lists, and brings home what `answer(question, answers)` adds
/// there, in the order of the ranks. Answers say themselves to which question they belong.
/// Collective.
template <class Answer, class Question, class Work>
std::vector<Answer> ask(const Comm& comm, const std::vector<std::vector<Question>>& questions,
                        const Work& answer) {
  std::vector<Answer> home;
  if (comm.size() == 1) {
    for (const Question& q : questions[0])
      answer(q, home);
    return home;
  }
  const auto asked = comm.exchange(questions);
  std::vector<std::vector<Answer>> answers(asked.size());
  for (std::size_t r = 0; r < asked.size(); ++r)
    for (const Question& q : asked[r])
      answer(q, answers[r]);
  for (const auto& part : comm.exchange(answers))
    home.insert(home.end(), part.begin(), part.end());
  return home;
}

/// What all ranks have, in their order, on each of them. Collective.
template <class T> std::vector<T> share(const Comm& comm, const std::vector<T>& mine) {
  if (comm.size() == 1)
    return mine;
  const std::vector<std::vector<T>> to_all(static_cast<std::size_t>(comm.size()), mine);
  std::vector<T> all;
  for (const auto& part : comm.exchange(to_all))
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

} // namespace abut::audit
