"""The judge of the compliant job: sequences of poses and an arm's joints against the task that ordered them."""
