"""The compliant job behind one door: task, controller, world, pictures; the chapter-6 experiments beside them."""
