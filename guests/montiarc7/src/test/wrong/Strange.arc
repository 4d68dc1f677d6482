component Strange extends Needy(1, b = 2, d = 3) { }
