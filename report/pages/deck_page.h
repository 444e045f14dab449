// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// Pages of the deck that belong together, as report/pages/deck.json has them, in the deck's order.
struct DeckSection {
  std::string pages, title, idea;
  std::vector<std::string> operations;  ///< whose formulas these pages have; the first comes first
  std::string drag;                     ///< the figure of drag_figures.js; empty: none
  std::string scene;                    ///< of simulate/scenes; empty: none
};
const std::vector<DeckSection>& deck_sections();

/// A scene that the page plays.
struct PlayedScene {
  std::string title, about;
  Json data;  ///< player_data of its recording
};

/// The deck as one page that stands alone: of each section the idea, the formulas, a figure that the reader drags or
/// turns, the most frequent failure that the tally has, and the scene, where `scenes` has it by name. Operations that
/// no page of the deck asks stand at the end.
std::string deck_page(const Tally& tally, const std::map<std::string, PlayedScene>& scenes);

}  // namespace touchstone::report
