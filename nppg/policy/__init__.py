"""The policy: a Gibbs distribution over a sum of trees, why it chooses as it does, and its file."""
