"""How good a policy is: on sampled starts, exactly over all of them, and beside the optimum."""
