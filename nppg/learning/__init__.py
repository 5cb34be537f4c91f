"""Non-parametric policy gradients, Algorithm 1 of Kersting and Driessens (2008), with its options."""
