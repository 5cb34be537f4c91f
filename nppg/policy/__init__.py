"""The policy: a Gibbs distribution over a sum of trees, and its file."""
