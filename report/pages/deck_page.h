// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "audit/counting/tally.h"
#include "report/uses.h"

namespace touchstone::report {

/// Pages of the deck that belong together, from report/pages/deck.json, in the deck's order.
struct DeckSection {
  std::string pages, title, idea;
  std::vector<std::string> operations;  ///< the operations with the formulas of these pages; the main one first
  std::string drag;                     ///< the figure of drag_figures.js; empty: none
  std::string scene;                    ///< of simulate/scenes; empty: none
};
const std::vector<DeckSection>& deck_sections();

/// A scene that the page plays.
struct PlayedScene {
  std::string title, about;
  Json data;  ///< player_data of its recording
};

/// The deck as one self-contained page: for each section the idea, the formulas, a figure that the reader drags or
/// rotates, the most frequent failure in the tally, and the scene, if `scenes` has it by name. Operations that no page
/// of the deck asks come last.
std::string deck_page(const Tally& tally, const std::map<std::string, PlayedScene>& scenes);

}  // namespace touchstone::report
