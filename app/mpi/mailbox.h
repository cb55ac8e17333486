// Sends and receives messages over MPI and never blocks. For use from one thread.
#pragma once

#include <mpi.h>

#include <chrono>
#include <list>
#include <optional>
#include <string>
#include <vector>

#include "app/mpi/message.h"

namespace pupflow::mpi {

/// The time between two calls of Mailbox::receive() while there is nothing to receive.
constexpr std::chrono::milliseconds kPollInterval{2};

class Mailbox {
 public:
  Mailbox();
  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

  /// The number of ranks.
  int size() const { return static_cast<int>(outgoing_.size()); }

  /// Starts sending a message to rank `destination`. A message that MPI refuses is dropped: missing
  /// heartbeats show each side that the other is lost.
  void send(int destination, Tag tag, std::string bytes = {});

  /// Whether MPI has sent all messages to `destination`.
  bool all_sent(int destination);

  /// The next message that has arrived; empty if there is none.
  std::optional<Message> receive();

 private:
  struct Outgoing {
    std::string bytes;  // must not move until the request is complete
    MPI_Request request;
  };
  std::vector<std::list<Outgoing>> outgoing_;  // by destination
};

}  // namespace pupflow::mpi
