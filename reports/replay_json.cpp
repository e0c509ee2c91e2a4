// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/replay_json.h"

#include <nlohmann/json.hpp>

#include "reports/environment.h"

namespace gnomon::reports {

std::string replay_json(const fuzz::ReplayResult& result) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["schema"] = 1;
  json["kind"] = "replay";
  json["tool"] = version();
  json["cases"] = result.cases;
  json["stated"] = result.stated;
  json["lines"] = Json::array();
  for (const fuzz::ReplayLine& line : result.lines) {
    json["lines"].push_back({{"where", line.where},
                             {"question", line.question},
                             {"method", line.method},
                             {"answer", line.answer},
                             {"reference", line.reference},
                             {"verdict", line.verdict},
                             {"promise_broken", line.promise_broken}});
  }
  json["wrong_answers"] = Json::array();
  for (const fuzz::WrongAnswer& wrong : result.wrong_answers) {
    json["wrong_answers"].push_back(
        {{"where", wrong.where}, {"stated", wrong.stated}, {"reference", wrong.reference}});
  }
  return json.dump(1) + "\n";
}

}  // namespace gnomon::reports
