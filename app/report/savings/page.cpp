// The table and the notes of the time that a plan saves.
#include <cstdio>

#include "app/io/provenance.h"
#include "app/io/text.h"
#include "app/report/savings/savings.h"

namespace pupflow::report {
namespace {

std::string figure(double microseconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%9.2f", microseconds);
  return text;
}

std::string zero() {
  return std::string(8, ' ') + "0";
}

std::string dash() {
  return std::string(8, ' ') + "-";
}

}  // namespace

std::string threads_words(int threads) {
  return threads == 1 ? "one thread" : std::to_string(threads) + " threads";
}

const char* agreement_words(Agreement agreement) {
  switch (agreement) {
    case Agreement::needed:
      return "-";
    case Agreement::whole_state:
      return "whole state";
    case Agreement::all_but_headings:
      return "all but headings";
    case Agreement::none:
      break;
  }
  return "NO";
}

std::vector<io::Row> savings_rows(const Savings& savings) {
  std::vector<io::Row> rows{
      {"stage", "needed", "µs a step", "of the step", "forced in", "saved", "the same bits"}};
  double stages = 0;
  for (const PartCost& part : savings.parts) stages += part.of_stage ? 0 : part.planned;
  for (const PartCost& part : savings.parts) {
    const bool never_ran = !part.needed && part.planned == 0;
    rows.push_back({(part.of_stage ? "- " : "") + part.name, part.needed ? "yes" : "no",
                    never_ran ? zero() : figure(part.planned), io::bar(part.planned, stages),
                    part.needed ? dash() : figure(part.forced),
                    part.needed ? dash() : figure(part.forced - part.planned),
                    agreement_words(part.agreement)});
  }
  rows.push_back({"whole step", "", figure(savings.planned_step), "", figure(savings.full_step),
                  figure(savings.saved), agreement_words(savings.agreement)});
  return rows;
}

std::vector<std::string> savings_notes(const Savings& savings) {
  std::vector<std::string> notes;
  char text[800];
  std::snprintf(
      text, sizeof text,
      "Medians over steps %lld to %lld, %s, of runs that are stepped in turn; reading the clock "
      "adds %.2f µs to each. Every second step is timed as a whole, which can take less time than "
      "the sum of its stages. Its forced time is with all parts forced in, and the saved time is "
      "the median difference, with a noise of 1 to 2 %% of the step. The saved time of a part of a "
      "stage is the median difference of the stage, with a noise of a few per cent of the stage.",
      static_cast<long long>(savings.first), static_cast<long long>(savings.last),
      threads_words(savings.threads).c_str(), savings.clock);
  notes.emplace_back(text);
  bool headings = false;
  std::string left_out;
  for (const PartCost& part : savings.parts) {
    headings = headings || part.agreement == Agreement::all_but_headings;
    if (part.needed) continue;
    left_out += (left_out.empty() ? "" : "; ") + part.name + " (" + part.reason + ")";
  }
  notes.push_back("Left out: " + left_out + ".");
  notes.push_back("After step " + std::to_string(savings.last) +
                  " the hash of the whole state is " + io::hash_text(savings.hash) +
                  ", with and without each part whose last column says so.");
  if (headings) {
    notes.push_back(
        "Steering turns the headings of pups that have no drive, and nothing reads those: without "
        "headings the hash is " +
        io::hash_text(savings.rest_hash) + " in both cases.");
  }
  return notes;
}

}  // namespace pupflow::report
