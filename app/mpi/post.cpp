#include "app/mpi/post.h"

namespace pupflow::mpi {

Post::Post() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  outgoing_.resize(static_cast<std::size_t>(size_));
  // The default ends this rank too when a letter to a lost one fails.
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
}

void Post::send(int to, Subject subject, std::string bytes) {
  std::list<Outgoing>& letters = outgoing_[static_cast<std::size_t>(to)];
  Outgoing& letter = letters.emplace_back(Outgoing{std::move(bytes), MPI_REQUEST_NULL});
  const int status = MPI_Isend(letter.bytes.data(), static_cast<int>(letter.bytes.size()), MPI_BYTE,
                               to, static_cast<int>(subject), MPI_COMM_WORLD, &letter.request);
  if (status != MPI_SUCCESS) letters.pop_back();
}

bool Post::sent(int to) {
  std::list<Outgoing>& letters = outgoing_[static_cast<std::size_t>(to)];
  letters.remove_if([](Outgoing& letter) {
    int done = 0;
    return MPI_Test(&letter.request, &done, MPI_STATUS_IGNORE) != MPI_SUCCESS || done != 0;
  });
  return letters.empty();
}

std::optional<Letter> Post::receive() {
  int waiting = 0;
  MPI_Status status;
  if (MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &waiting, &status) != MPI_SUCCESS ||
      waiting == 0) {
    return std::nullopt;
  }
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  Letter letter{status.MPI_SOURCE, static_cast<Subject>(status.MPI_TAG),
                std::string(static_cast<std::size_t>(size), '\0')};
  if (MPI_Recv(letter.bytes.data(), size, MPI_BYTE, letter.from, status.MPI_TAG, MPI_COMM_WORLD,
               MPI_STATUS_IGNORE) != MPI_SUCCESS) {
    return std::nullopt;
  }
  return letter;
}

}  // namespace pupflow::mpi
