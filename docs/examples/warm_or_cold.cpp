// The mean huddling of twelve pups in the cold and in the warm.
#include <iostream>

#include "pupflow/observer.h"
#include "pupflow/simulation.h"

int main() {
  for (const double ta : {0.2, 0.8}) {
    pupflow::Params params;
    params.ambient_temperature = ta;
    pupflow::Simulation simulation(params);
    pupflow::Observer observer(simulation);
    pupflow::RunMeans means(params.discard);
    while (simulation.steps_done() < params.steps && simulation.step().ok())
      means.add(simulation, observer.observe(simulation));
    if (!simulation.status().ok()) std::cerr << simulation.status().message() << "\n";
    std::cout << "T_a = " << ta << ": huddling " << means.means().huddling << "\n";
  }
}
