// Letters between ranks over MPI, without ever waiting for the other side. Use it from one thread.
#pragma once

#include <mpi.h>

#include <list>
#include <optional>
#include <string>
#include <vector>

#include "app/mpi/letter.h"

namespace pupflow::mpi {

class Post {
 public:
  Post();
  Post(const Post&) = delete;
  Post& operator=(const Post&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }

  /// Hands a letter to MPI, which keeps trying. What cannot be sent is dropped: the silence that
  /// follows tells either side that the other is lost.
  void send(int to, Subject subject, std::string bytes = {});

  /// Whether all letters to `to` are on their way.
  bool sent(int to);

  /// The next letter that has come, if any.
  std::optional<Letter> receive();

 private:
  struct Outgoing {
    std::string bytes;  // must stay where it is until the request is done
    MPI_Request request;
  };
  int rank_ = 0, size_ = 1;
  std::vector<std::list<Outgoing>> outgoing_;  // by receiver
};

}  // namespace pupflow::mpi
