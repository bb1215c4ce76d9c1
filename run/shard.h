#pragma once

namespace unietp {

/// Part `number` of `of` of a run: the blocks whose place leaves number - 1 when divided by `of`. 1 of 1 is all of it.
struct Shard {
  int number = 1, of = 1;
  bool is_whole() const { return of == 1; }  // the run is not divided
};

}  // namespace unietp
